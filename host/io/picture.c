/* SPDX-License-Identifier: MIT */
#include "picture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "file.h"
#include "file_identity.h"
#include "lines.h"

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

struct ppm_header {
    int width, height, maximum;
    size_t length; /* bytes before the samples */
};

/* The next header number, after white space and comments; -1 when there is none up to 10^6. */
static int header_number(const struct file_content *file, size_t *at)
{
    while (*at < file->length && (text_is_space(file->bytes[*at]) || file->bytes[*at] == '#')) {
        if (file->bytes[*at] == '#') {
            while (*at < file->length && file->bytes[*at] != '\n') {
                (*at)++;
            }
        } else {
            (*at)++;
        }
    }
    int number = -1;
    for (; *at < file->length && file->bytes[*at] >= '0' && file->bytes[*at] <= '9'; (*at)++) {
        number = (number < 0 ? 0 : number * 10) + (file->bytes[*at] - '0');
        if (number > 1000000) {
            return -1;
        }
    }
    return number;
}

/* Returns what is wrong, or NULL. */
static const char *parse_header(const struct file_content *file, struct ppm_header *header)
{
    size_t at = 2;
    if (file->length < 2 || memcmp(file->bytes, "P6", 2) != 0) {
        return "not a binary PPM (P6)";
    }
    if (file->length == 2 || (!text_is_space(file->bytes[2]) && file->bytes[2] != '#')) {
        return "not a binary PPM (P6)";
    }
    header->width = header_number(file, &at);
    header->height = header_number(file, &at);
    header->maximum = header_number(file, &at);
    if (header->width < 1 || header->height < 1) {
        return "bad size in the PPM header";
    }
    if (header->maximum < 1 || header->maximum > 255) {
        return "the PPM's largest value is not in 1..255";
    }
    if (at == file->length || !text_is_space(file->bytes[at])) {
        return "the PPM header does not end";
    }
    header->length = at + 1;
    uint64_t samples = (uint64_t)header->width * (uint64_t)header->height * 3; /* < 2^42 */
    if (file->length - header->length < samples) {
        return "the PPM ends before its last pixel";
    }
    return NULL;
}

static uint8_t scale_sample(uint8_t sample, int maximum)
{
    int scaled = (sample * 255 + maximum / 2) / maximum;
    return (uint8_t)(scaled > 255 ? 255 : scaled);
}

bool picture_read_ppm(const char *path, struct picture *picture, struct text_error *error)
{
    struct file_content file;
    memset(picture, 0, sizeof *picture);
    if (!file_read(path, &file, error)) {
        return false;
    }
    struct ppm_header header;
    const char *problem = parse_header(&file, &header);
    if (problem == NULL && !picture_create(picture, header.width, header.height, false)) {
        problem = "out of memory";
    }
    if (problem != NULL) {
        text_error_set(error, path, 0, "%s", problem);
        free(file.bytes);
        return false;
    }
    const char *samples = file.bytes + header.length;
    for (size_t i = 0; i < pixel_count(picture) * 3; i++) {
        picture->rgb[i] = scale_sample((uint8_t)samples[i], header.maximum);
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

static char *dump_path(const char *prefix, int dump, struct text_error *error)
{
    size_t size = strlen(prefix) + strlen(dumps[dump].ending) + 1;
    char *path = malloc(size);
    if (path == NULL) {
        text_error_set(error, prefix, 0, "out of memory");
        return NULL;
    }
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
        char *path = dump_path(prefix, i, error);
        ok = path != NULL &&
             (items[i] == NULL || write_items(path, picture, items[i], dumps[i].bytes, error));
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
        char *path = dump_path(prefix, i, error);
        ok = path != NULL && read_items(path, picture, &items[i], dumps[i].bytes, error);
        free(path);
    }
    free(picture->id);
    free(picture->depth);
    picture->id = items[0];
    picture->depth = items[1];
    return ok;
}
