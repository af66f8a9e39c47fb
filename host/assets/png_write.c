/* SPDX-License-Identifier: MIT */
#include "png_write.h"

#include <stdlib.h>
#include <string.h>

#include "../io/xalloc.h"

static const uint8_t magic[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

enum { CHUNK_BYTES = 12, IHDR_BYTES = 13 }; /* of a chunk beside its data */

void byte_list_add(struct byte_list *list, const void *bytes, size_t count)
{
    if (list->capacity - list->count < count) {
        list->capacity = list->count + count + list->capacity / 2 + 64;
        list->bytes = xrealloc(list->bytes, list->capacity, 1);
    }
    if (count > 0) {
        memcpy(list->bytes + list->count, bytes, count);
    }
    list->count += count;
}

static void put32(uint8_t *to, uint32_t value)
{
    for (int i = 0; i < 4; i++) {
        to[i] = (uint8_t)(value >> (24 - 8 * i));
    }
}

static uint32_t get32(const uint8_t *from)
{
    return (uint32_t)from[0] << 24 | (uint32_t)from[1] << 16 | (uint32_t)from[2] << 8 | from[3];
}

/* CRC-32 of ISO 3309. */
static uint32_t crc(const uint8_t *bytes, size_t count)
{
    uint32_t sum = 0xFFFFFFFFu;
    for (size_t i = 0; i < count; i++) {
        sum ^= bytes[i];
        for (int bit = 0; bit < 8; bit++) {
            sum = sum >> 1 ^ (0xEDB88320u & (0 - (sum & 1)));
        }
    }
    return ~sum;
}

/* A chunk whose data is two pieces, the first of which may be empty. */
static void add_chunk(struct byte_list *out, const char type[4], const uint8_t *first,
                      size_t first_count, const uint8_t *data, size_t count)
{
    const size_t at = out->count + 4;
    uint8_t word[4];
    put32(word, (uint32_t)(first_count + count));
    byte_list_add(out, word, 4);
    byte_list_add(out, type, 4);
    byte_list_add(out, first, first_count);
    byte_list_add(out, data, count);
    put32(word, crc(out->bytes + at, 4 + first_count + count));
    byte_list_add(out, word, 4);
}

#ifdef QTRI_HAVE_LIBPNG

#include <png.h>

void png_append(struct byte_list *out, const struct picture *picture)
{
    png_image png;
    memset(&png, 0, sizeof png);
    png.version = PNG_IMAGE_VERSION;
    png.width = (png_uint_32)picture->width;
    png.height = (png_uint_32)picture->height;
    png.format = PNG_FORMAT_RGB;
    size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    void *bytes = xcalloc(size, 1);
    if (png_image_write_to_memory(&png, bytes, &size, 0, picture->rgb, 0, NULL) == 0) {
        xalloc_die();
    }
    byte_list_add(out, bytes, size);
    free(bytes);
}

#else

/* Rows without a filter, as a stream of zlib of stored blocks. */
static void add_stored(struct byte_list *out, const struct picture *picture)
{
    enum { BLOCK = 65535 };
    const size_t row = 3 * (size_t)picture->width + 1;
    const size_t total = row * (size_t)picture->height;
    uint32_t a = 1, b = 0; /* Adler-32 */
    static const uint8_t begin[2] = {0x78, 0x01};
    byte_list_add(out, begin, sizeof begin);
    for (size_t i = 0; i < total; i++) {
        if (i % BLOCK == 0) {
            const uint32_t length = (uint32_t)(total - i < BLOCK ? total - i : BLOCK);
            const uint8_t block[5] = {total - i <= BLOCK, (uint8_t)length, (uint8_t)(length >> 8),
                                      (uint8_t)~length, (uint8_t)(~length >> 8)};
            byte_list_add(out, block, sizeof block);
        }
        const uint8_t byte = i % row == 0 ? 0 : picture->rgb[i - i / row - 1];
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
        byte_list_add(out, &byte, 1);
    }
    uint8_t sum[4];
    put32(sum, b << 16 | a);
    byte_list_add(out, sum, sizeof sum);
}

void png_append(struct byte_list *out, const struct picture *picture)
{
    struct byte_list data = {.bytes = NULL};
    uint8_t header[IHDR_BYTES] = {[8] = 8, [9] = 2}; /* bits a channel; red green blue */
    put32(header, (uint32_t)picture->width);
    put32(header + 4, (uint32_t)picture->height);
    add_stored(&data, picture);
    byte_list_add(out, magic, sizeof magic);
    add_chunk(out, "IHDR", NULL, 0, header, sizeof header);
    add_chunk(out, "IDAT", NULL, 0, data.bytes, data.count);
    add_chunk(out, "IEND", NULL, 0, NULL, 0);
    free(data.bytes);
}

#endif

/* fcTL: the frame is all of the picture, is shown for a part of a second, and replaces what there
   was. */
static void add_control(struct apng *apng)
{
    uint8_t control[26] = {0};
    put32(control, apng->sequence++);
    memcpy(control + 4, apng->header + 8, 8); /* width and height */
    control[21] = 1;
    control[22] = (uint8_t)(apng->per_second >> 8);
    control[23] = (uint8_t)apng->per_second;
    add_chunk(&apng->frames, "fcTL", NULL, 0, control, sizeof control);
}

void apng_add(struct apng *apng, const struct picture *picture)
{
    struct byte_list png = {.bytes = NULL};
    png_append(&png, picture);
    memcpy(apng->header, png.bytes + sizeof magic, sizeof apng->header);
    add_control(apng);
    size_t at = sizeof magic;
    while (at + CHUNK_BYTES <= png.count) {
        const uint8_t *chunk = png.bytes + at;
        const size_t count = get32(chunk);
        if (memcmp(chunk + 4, "IDAT", 4) == 0) {
            uint8_t sequence[4];
            put32(sequence, apng->sequence);
            const bool is_first = apng->frame_count == 0; /* what others show of it, too */
            add_chunk(&apng->frames, is_first ? "IDAT" : "fdAT", sequence,
                      is_first ? 0 : sizeof sequence, chunk + 8, count);
            apng->sequence += !is_first;
        }
        at += CHUNK_BYTES + count;
    }
    apng->frame_count++;
    free(png.bytes);
}

void apng_finish(struct apng *apng, struct byte_list *out)
{
    uint8_t control[8] = {0}; /* acTL: frames; played for ever */
    put32(control, apng->frame_count);
    byte_list_add(out, magic, sizeof magic);
    byte_list_add(out, apng->header, sizeof apng->header);
    add_chunk(out, "acTL", NULL, 0, control, sizeof control);
    byte_list_add(out, apng->frames.bytes, apng->frames.count);
    add_chunk(out, "IEND", NULL, 0, NULL, 0);
    free(apng->frames.bytes);
    memset(apng, 0, sizeof *apng);
}
