/* SPDX-License-Identifier: MIT */
#include "image.h"

#include <stdlib.h>
#include <string.h>

#include "../io/file.h"
#include "../io/lines.h"
#include "png_write.h"

static const char png_magic[8] = {'\x89', 'P', 'N', 'G', '\r', '\n', '\x1A', '\n'};

static bool create(const char *path, struct image *image, uint32_t width, uint32_t height,
                   struct text_error *error)
{
    const char *problem = image_size_problem((long)width, (long)height);
    if (problem != NULL) {
        return text_error_set(error, path, 0, "%s", problem);
    }
    // NOLINTNEXTLINE(clang-analyzer-optin.portability.UnixAPI): a side of 0 is a problem
    image->rgba = calloc((size_t)width * height, 4);
    image->width = (int)width;
    image->height = (int)height;
    return image->rgba != NULL || text_error_set(error, path, 0, "out of memory");
}

void image_free(struct image *image)
{
    free(image->rgba);
    memset(image, 0, sizeof *image);
}

/* ---- PPM and PGM ---- */

/* The next number of a header, after white space and comments; 0 when there is none to 16384. */
static uint32_t header_number(const char *bytes, size_t length, size_t *at)
{
    uint32_t number = 0;
    while (*at < length && (text_is_space(bytes[*at]) || bytes[*at] == '#')) {
        bool comment = bytes[*at] == '#';
        while (comment && *at < length && bytes[*at] != '\n') {
            (*at)++;
        }
        *at += *at < length ? 1 : 0;
    }
    for (; *at < length && bytes[*at] >= '0' && bytes[*at] <= '9'; (*at)++) {
        number = number * 10 + (uint32_t)(bytes[*at] - '0');
        if (number > IMAGE_MAX_SIDE) {
            return 0;
        }
    }
    return number;
}

static uint8_t scale_sample(char sample, uint32_t most)
{
    uint32_t value = (uint8_t)sample;
    value = value > most ? most : value;
    return (uint8_t)((value * 255 + most / 2) / most);
}

static bool parse_pnm(const char *path, const char *bytes, size_t length, struct image *image,
                      struct text_error *error)
{
    size_t at = 2;
    size_t channels = bytes[1] == '5' ? 1 : 3;
    uint32_t width = header_number(bytes, length, &at);
    uint32_t height = header_number(bytes, length, &at);
    uint32_t most = header_number(bytes, length, &at);
    const char *problem = image_size_problem((long)width, (long)height);
    if (problem != NULL) {
        return text_error_set(error, path, 0, "%s", problem);
    }
    if (most < 1 || most > 255) {
        return text_error_set(error, path, 0, "has a largest value that is not in 1..255");
    }
    if (at >= length || !text_is_space(bytes[at])) {
        return text_error_set(error, path, 0, "ends in its header");
    }
    at++;
    if ((length - at) / channels < (uint64_t)width * height) {
        return text_error_set(error, path, 0, "ends before its last pixel");
    }
    if (!create(path, image, width, height, error)) {
        return false;
    }
    size_t count = (size_t)width * height;
    for (size_t i = 0; i < count; i++) {
        for (size_t channel = 0; channel < 3; channel++) {
            size_t sample = channels * i + (channels == 1 ? 0 : channel);
            image->rgba[4 * i + channel] = scale_sample(bytes[at + sample], most);
        }
        image->rgba[4 * i + 3] = 255;
    }
    return true;
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
    bool ok = png_append(&png, picture) || text_error_set(error, path, 0, "out of memory");
    ok = ok && file_output_open(&output, path, error);
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
