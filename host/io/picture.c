/* SPDX-License-Identifier: MIT */
#include "picture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "file.h"
#include "file_identity.h"
#include "lines.h"
#include "xalloc.h"

typedef char double_has_64_bits[sizeof(double) == 8 ? 1 : -1];

bool picture_create(struct picture *picture, int width, int height, bool with_dump)
{
    memset(picture, 0, sizeof *picture);
    if (width < 1 || height < 1 || (uint64_t)width * (uint64_t)height > SIZE_MAX / 8) {
        return false;
    }
    size_t pixels = (size_t)width * (size_t)height;
    picture->width = width;
    picture->height = height;
    picture->rgb = calloc(pixels, 3);
    if (with_dump) {
        picture->id = calloc(pixels, sizeof *picture->id);
        picture->depth = calloc(pixels, sizeof *picture->depth);
    }
    if (picture->rgb == NULL || (with_dump && (picture->id == NULL || picture->depth == NULL))) {
        picture_free(picture);
        return false;
    }
    return true;
}

void picture_free(struct picture *picture)
{
    free(picture->rgb);
    free(picture->id);
    free(picture->depth);
    memset(picture, 0, sizeof *picture);
}

static size_t pixel_count(const struct picture *picture)
{
    return (size_t)picture->width * (size_t)picture->height;
}

/* ---- PPM ---- */

/* The next header number, after white space and comments; -1 when there is none up to 10^6. */
static int header_number(const char *bytes, size_t length, size_t *at)
{
    bool is_comment = false;
    for (; *at < length && (is_comment || text_is_space(bytes[*at]) || bytes[*at] == '#');
         (*at)++) {
        is_comment = bytes[*at] != '\n' && (is_comment || bytes[*at] == '#');
    }
    int number = -1;
    for (; *at < length && bytes[*at] >= '0' && bytes[*at] <= '9'; (*at)++) {
        number = (number < 0 ? 0 : number * 10) + (bytes[*at] - '0');
        if (number > 1000000) {
            return -1;
        }
    }
    return number;
}

const char *pnm_header(const char *bytes, size_t length, struct pnm *pnm)
{
    size_t at = 2;
    if (length < 3 || bytes[0] != 'P' || (bytes[1] != '5' && bytes[1] != '6') ||
        (!text_is_space(bytes[2]) && bytes[2] != '#')) {
        return "not a binary PPM (P6)";
    }
    pnm->channels = bytes[1] == '5' ? 1 : 3;
    pnm->width = header_number(bytes, length, &at);
    pnm->height = header_number(bytes, length, &at);
    pnm->maximum = header_number(bytes, length, &at);
    if (pnm->width < 1 || pnm->height < 1) {
        return "bad size in the PPM header";
    }
    if (pnm->maximum < 1 || pnm->maximum > 255) {
        return "the PPM's largest value is not in 1..255";
    }
    if (at == length || !text_is_space(bytes[at])) {
        return "the PPM header does not end";
    }
    pnm->length = at + 1;
    const uint64_t pixels = (uint64_t)pnm->width * (uint64_t)pnm->height; /* < 2^42 */
    return length - pnm->length < pixels * (uint64_t)pnm->channels
               ? "the PPM ends before its last pixel"
               : NULL;
}

uint8_t pnm_sample(const struct pnm *pnm, const char *bytes, size_t pixel, int channel)
{
    const size_t at = (size_t)pnm->channels * pixel + (size_t)(pnm->channels == 1 ? 0 : channel);
    const int sample = (uint8_t)bytes[pnm->length + at];
    const int scaled = (sample * 255 + pnm->maximum / 2) / pnm->maximum;
    return (uint8_t)(scaled > 255 ? 255 : scaled);
}

bool picture_read_ppm(const char *path, struct picture *picture, struct text_error *error)
{
    struct file_content file;
    memset(picture, 0, sizeof *picture);
    if (!file_read(path, &file, error)) {
        return false;
    }
    struct pnm header;
    const char *problem = pnm_header(file.bytes, file.length, &header);
    problem = problem == NULL && header.channels == 1 ? "not a binary PPM (P6)" : problem;
    if (problem == NULL && !picture_create(picture, header.width, header.height, false)) {
        problem = "out of memory";
    }
    if (problem != NULL) {
        text_error_set(error, path, 0, "%s", problem);
        free(file.bytes);
        return false;
    }
    for (size_t i = 0; i < pixel_count(picture) * 3; i++) {
        picture->rgb[i] = pnm_sample(&header, file.bytes, i / 3, (int)(i % 3));
    }
    free(file.bytes);
    return true;
}

bool picture_write_ppm(const char *path, const struct picture *picture, struct text_error *error)
{
    char header[48];
    struct file_output output;
    if (!file_output_open(&output, path, error)) {
        return false;
    }
    int length =
        snprintf(header, sizeof header, "P6\n%d %d\n255\n", picture->width, picture->height);
    file_output_write(&output, header, (size_t)length);
    file_output_write(&output, picture->rgb, pixel_count(picture) * 3);
    return file_output_commit(&output, error);
}

/* ---- Dumps ---- */

/* The members of a dump: their ending, and how many bytes a pixel has there. */
static const struct {
    const char *ending;
    size_t bytes;
} dumps[] = {{".id", sizeof(uint32_t)}, {".depth", sizeof(double)}};

enum { DUMPS = sizeof dumps / sizeof dumps[0] };

static char *dump_path(const char *prefix, int dump)
{
    size_t size = strlen(prefix) + strlen(dumps[dump].ending) + 1;
    char *path = xcalloc(size, 1);
    (void)snprintf(path, size, "%s%s", prefix, dumps[dump].ending);
    return path;
}

/* Turns `size` bytes between this machine's order and little-endian. */
static void turn_bytes(uint8_t *bytes, size_t size)
{
    const uint16_t one = 1;
    uint8_t first;
    memcpy(&first, &one, 1);
    for (size_t i = 0; first == 0 && i < size / 2; i++) {
        const uint8_t byte = bytes[i];
        bytes[i] = bytes[size - 1 - i];
        bytes[size - 1 - i] = byte;
    }
}

static bool write_items(const char *path, const struct picture *picture, const void *items,
                        size_t size, struct text_error *error)
{
    struct file_output output;
    if (!file_output_open(&output, path, error)) {
        return false;
    }
    for (size_t i = 0; i < pixel_count(picture); i++) {
        uint8_t bytes[8];
        memcpy(bytes, (const uint8_t *)items + i * size, size);
        turn_bytes(bytes, size);
        file_output_write(&output, bytes, size);
    }
    return file_output_commit(&output, error);
}

bool picture_write_dump(const char *prefix, const struct picture *picture, struct text_error *error)
{
    const void *const items[DUMPS] = {picture->id, picture->depth};
    bool ok = true;
    for (int i = 0; ok && i < DUMPS; i++) {
        char *path = dump_path(prefix, i);
        ok = items[i] == NULL || write_items(path, picture, items[i], dumps[i].bytes, error);
        free(path);
    }
    return ok;
}

/* Leaves *items NULL where there is no such file. */
static bool read_items(const char *path, const struct picture *picture, void **items, size_t size,
                       struct text_error *error)
{
    const size_t count = pixel_count(picture);
    struct file_content file;
    *items = NULL;
    if (file_inspect(path, NULL) == FILE_MISSING) {
        return true;
    }
    if (!file_read(path, &file, error)) {
        return false;
    }
    if (file.length != count * size) {
        free(file.bytes);
        return text_error_set(error, path, 0, "%zu bytes, but %d x %d pixels need %zu", file.length,
                              picture->width, picture->height, count * size);
    }
    for (size_t i = 0; i < count; i++) {
        turn_bytes((uint8_t *)file.bytes + i * size, size);
    }
    *items = file.bytes; /* as malloc() gave it: aligned for any type */
    return true;
}

bool picture_read_dump(const char *prefix, struct picture *picture, struct text_error *error)
{
    void *items[DUMPS] = {NULL};
    bool ok = true;
    for (int i = 0; ok && i < DUMPS; i++) {
        char *path = dump_path(prefix, i);
        ok = read_items(path, picture, &items[i], dumps[i].bytes, error);
        free(path);
    }
    free(picture->id);
    free(picture->depth);
    picture->id = items[0];
    picture->depth = items[1];
    return ok;
}
