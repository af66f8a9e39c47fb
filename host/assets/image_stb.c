/* SPDX-License-Identifier: MIT */
/*
 * PNG and JPEG by the library stb, in a process of its own: the page of ../web has it, too, so that
 * texels are equal. As glTF wants it, a file's own word on its colour space is passed over.
 */
#include "image.h"

#ifndef QTRI_HAVE_STB

bool image_parse_stb(const char *path, const char *format, const char *bytes, size_t length,
                     struct image *image, struct text_error *error)
{
    (void)bytes;
    (void)length;
    (void)image;
    return text_error_set(error, path, 0, "this qtri was built without libstb and cannot read %s",
                          format);
}

#else

#include <limits.h>
#include <stb_image.h>
#include <stdio.h>
#include <stdlib.h>

#include "apart.h"

struct request {
    const char *path, *format, *bytes;
    size_t length;
};

/* Width and height, then the pixels. */
static bool send(FILE *answer, void *context, struct text_error *error)
{
    const struct request *request = (const struct request *)context;
    const unsigned char *bytes = (const unsigned char *)request->bytes;
    int size[2] = {0, 0}, channels = 0;
    int length = request->length <= INT_MAX ? (int)request->length : 0;
    if (stbi_info_from_memory(bytes, length, &size[0], &size[1], &channels) != 0) {
        const char *problem = image_size_problem(size[0], size[1]);
        if (problem != NULL) {
            return text_error_set(error, request->path, 0, "%s", problem);
        }
    }
    unsigned char *rgba = stbi_load_from_memory(bytes, length, &size[0], &size[1], &channels, 4);
    if (rgba == NULL) {
        return text_error_set(error, request->path, 0, "cannot be read as %s: %s", request->format,
                              stbi_failure_reason());
    }
    size_t count = 4 * (size_t)size[0] * (size_t)size[1];
    (void)(fwrite(size, sizeof size, 1, answer) == 1 &&
           fwrite(rgba, 1, count, answer) == count); /* who waits asks the stream */
    return true;
}

static bool receive(FILE *answer, struct image *image)
{
    int size[2];
    if (fread(size, sizeof size, 1, answer) != 1 || image_size_problem(size[0], size[1]) != NULL) {
        return false;
    }
    size_t count = (size_t)size[0] * (size_t)size[1];
    image->rgba = calloc(count, 4);
    image->width = size[0];
    image->height = size[1];
    return image->rgba != NULL && fread(image->rgba, 4, count, answer) == count;
}

bool image_parse_stb(const char *path, const char *format, const char *bytes, size_t length,
                     struct image *image, struct text_error *error)
{
    struct request request = {path, format, bytes, length};
    FILE *answer = apart_run(path, send, &request, error);
    if (answer == NULL) {
        return false;
    }
    bool ok = receive(answer, image);
    if (!ok) {
        text_error_set(error, path, 0, "out of memory");
    }
    (void)fclose(answer);
    return ok;
}

#endif
