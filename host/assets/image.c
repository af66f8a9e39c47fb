/* SPDX-License-Identifier: MIT */
#include "image.h"

#include <stdlib.h>
#include <string.h>

#include "../io/file.h"
#include "../io/lines.h"
#include "png_write.h"

static const char png_magic[8] = {'\x89', 'P', 'N', 'G', '\r', '\n', '\x1A', '\n'};

void image_free(struct image *image)
{
    free(image->rgba);
    memset(image, 0, sizeof *image);
}

/* ---- PPM and PGM ---- */

static bool parse_pnm(const char *path, const char *bytes, size_t length, struct image *image,
                      struct text_error *error)
{
    struct pnm pnm = {0};
    const char *problem = pnm_header(bytes, length, &pnm);
    if (pnm.width > 0 && pnm.height > 0 && image_size_problem(pnm.width, pnm.height) != NULL) {
        problem = image_size_problem(pnm.width, pnm.height); /* rather than that it ends */
    }
    if (problem != NULL) {
        return text_error_set(error, path, 0, "%s", problem);
    }
    const size_t count = (size_t)pnm.width * (size_t)pnm.height;
    image->width = pnm.width;
    image->height = pnm.height;
    image->rgba = malloc(4 * count);
    for (size_t i = 0; image->rgba != NULL && i < 4 * count; i++) {
        image->rgba[i] = i % 4 == 3 ? 255 : pnm_sample(&pnm, bytes, i / 4, (int)(i % 4));
    }
    return image->rgba != NULL || text_error_set(error, path, 0, "out of memory");
}

bool image_parse(const char *path, const char *bytes, size_t length, struct image *image,
                 struct text_error *error)
{
    bool ok;
    memset(image, 0, sizeof *image);
    if (length >= sizeof png_magic && memcmp(bytes, png_magic, sizeof png_magic) == 0) {
        ok = image_parse_stb(path, "PNG", bytes, length, image, error);
    } else if (length > 2 && memcmp(bytes, "\xFF\xD8\xFF", 3) == 0) {
        ok = image_parse_stb(path, "JPEG", bytes, length, image, error);
    } else if (length > 2 && bytes[0] == 'P' && (bytes[1] == '5' || bytes[1] == '6') &&
               (text_is_space(bytes[2]) || bytes[2] == '#')) {
        ok = parse_pnm(path, bytes, length, image, error);
    } else {
        ok = text_error_set(error, path, 0, "is neither PNG nor JPEG nor binary PPM or PGM");
    }
    if (!ok) {
        image_free(image);
    }
    return ok;
}

bool image_read(const char *path, struct image *image, struct text_error *error)
{
    struct file_content file;
    memset(image, 0, sizeof *image);
    if (!file_read(path, &file, error)) {
        return false;
    }
    bool ok = image_parse(path, file.bytes, file.length, image, error);
    free(file.bytes);
    return ok;
}

static bool write_png(const char *path, const struct picture *picture, struct text_error *error)
{
    struct file_output output;
    struct byte_list png = {.bytes = NULL};
    png_append(&png, picture);
    bool ok = file_output_open(&output, path, error);
    if (ok) {
        file_output_write(&output, png.bytes, png.count);
        ok = file_output_commit(&output, error);
    }
    free(png.bytes);
    return ok;
}

bool image_write_picture(const char *path, const struct picture *picture, struct text_error *error)
{
    return file_name_ends_in(path, ".png") ? write_png(path, picture, error)
                                           : picture_write_ppm(path, picture, error);
}
