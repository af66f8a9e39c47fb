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

static char *dump_path(const char *prefix, const char *suffix, struct text_error *error)
{
    size_t size = strlen(prefix) + strlen(suffix) + 1;
    char *path = malloc(size);
    if (path == NULL) {
        text_error_set(error, prefix, 0, "out of memory");
        return NULL;
    }
    (void)snprintf(path, size, "%s%s", prefix, suffix);
    return path;
}

static void write_little_endian(struct file_output *output, uint64_t value, size_t size)
{
    uint8_t bytes[8];
    for (size_t i = 0; i < size; i++) {
        bytes[i] = (uint8_t)(value >> (8 * i));
    }
    file_output_write(output, bytes, size);
}

static uint64_t read_little_endian(const char *bytes, size_t size)
{
    uint64_t value = 0;
    for (size_t i = 0; i < size; i++) {
        value |= (uint64_t)(uint8_t)bytes[i] << (8 * i);
    }
    return value;
}

static bool write_ids(const char *path, const struct picture *picture, struct text_error *error)
{
    struct file_output output;
    if (!file_output_open(&output, path, error)) {
        return false;
    }
    for (size_t i = 0; i < pixel_count(picture); i++) {
        write_little_endian(&output, picture->id[i], 4);
    }
    return file_output_commit(&output, error);
}

static bool write_depths(const char *path, const struct picture *picture, struct text_error *error)
{
    struct file_output output;
    if (!file_output_open(&output, path, error)) {
        return false;
    }
    for (size_t i = 0; i < pixel_count(picture); i++) {
        uint64_t bits;
        memcpy(&bits, &picture->depth[i], sizeof bits);
        write_little_endian(&output, bits, 8);
    }
    return file_output_commit(&output, error);
}

bool picture_write_dump(const char *prefix, const struct picture *picture, struct text_error *error)
{
    char *id_path = dump_path(prefix, ".id", error);
    char *depth_path = dump_path(prefix, ".depth", error);
    bool ok = id_path != NULL && depth_path != NULL &&
              (picture->id == NULL || write_ids(id_path, picture, error)) &&
              (picture->depth == NULL || write_depths(depth_path, picture, error));
    free(id_path);
    free(depth_path);
    return ok;
}

/* Leaves file->bytes NULL where there is no such file. */
static bool read_items(const char *path, size_t item_size, const struct picture *picture,
                       struct file_content *file, struct text_error *error)
{
    file->bytes = NULL;
    if (file_inspect(path, NULL) == FILE_MISSING) {
        return true;
    }
    if (!file_read(path, file, error)) {
        return false;
    }
    if (file->length != pixel_count(picture) * item_size) {
        text_error_set(error, path, 0, "%zu bytes, but %d x %d pixels need %zu", file->length,
                       picture->width, picture->height, pixel_count(picture) * item_size);
        free(file->bytes);
        return false;
    }
    return true;
}

static bool read_ids(const char *path, struct picture *picture, struct text_error *error)
{
    struct file_content file;
    if (!read_items(path, 4, picture, &file, error)) {
        return false;
    }
    if (file.bytes == NULL) {
        return true;
    }
    picture->id = malloc(pixel_count(picture) * sizeof *picture->id);
    for (size_t i = 0; picture->id != NULL && i < pixel_count(picture); i++) {
        picture->id[i] = (uint32_t)read_little_endian(file.bytes + 4 * i, 4);
    }
    free(file.bytes);
    if (picture->id == NULL) {
        text_error_set(error, path, 0, "out of memory");
    }
    return picture->id != NULL;
}

static bool read_depths(const char *path, struct picture *picture, struct text_error *error)
{
    struct file_content file;
    if (!read_items(path, 8, picture, &file, error)) {
        return false;
    }
    if (file.bytes == NULL) {
        return true;
    }
    picture->depth = malloc(pixel_count(picture) * sizeof *picture->depth);
    for (size_t i = 0; picture->depth != NULL && i < pixel_count(picture); i++) {
        uint64_t bits = read_little_endian(file.bytes + 8 * i, 8);
        memcpy(&picture->depth[i], &bits, sizeof bits);
    }
    free(file.bytes);
    if (picture->depth == NULL) {
        text_error_set(error, path, 0, "out of memory");
    }
    return picture->depth != NULL;
}

bool picture_read_dump(const char *prefix, struct picture *picture, struct text_error *error)
{
    free(picture->id);
    free(picture->depth);
    picture->id = NULL;
    picture->depth = NULL;
    char *id_path = dump_path(prefix, ".id", error);
    char *depth_path = dump_path(prefix, ".depth", error);
    bool ok = id_path != NULL && depth_path != NULL && read_ids(id_path, picture, error) &&
              read_depths(depth_path, picture, error);
    free(id_path);
    free(depth_path);
    return ok;
}
