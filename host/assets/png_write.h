/* SPDX-License-Identifier: MIT */
/*
 * Pictures as PNG in memory: compressed where libpng is there, else in stored blocks. And animated
 * ones, APNG.
 */
#ifndef QTRI_HOST_ASSETS_PNG_WRITE_H
#define QTRI_HOST_ASSETS_PNG_WRITE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "../io/picture.h"

/* Bytes that grow at the end; bytes NULL where there are none. free() them. */
struct byte_list {
    uint8_t *bytes;
    size_t count, capacity;
};

void byte_list_add(struct byte_list *list, const void *bytes, size_t count);

/* Appends a whole PNG file. */
void png_append(struct byte_list *out, const struct picture *picture);

/* Frame after frame, each of one size; then the file. */
struct apng {
    struct byte_list frames; /* chunks */
    uint8_t header[25];      /* IHDR */
    uint32_t frame_count, sequence;
    uint16_t per_second;
};
void apng_add(struct apng *apng, const struct picture *picture);
void apng_finish(struct apng *apng, struct byte_list *out);

#endif
