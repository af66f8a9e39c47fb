/* SPDX-License-Identifier: MIT */
#include "pixel.h"

/* Four bytes of pixels or depths, as an aligned word and as its bytes lie in memory. */
typedef union pattern {
    uint32_t word;
    uint8_t byte[4];
} pattern;

enum { BLOCK_BYTES = 64, MASK_PIXELS = 32 /* that a mask has bits for */ };

/* Stores x in all words; end - at is a multiple of BLOCK_BYTES and not 0. */
static void store_blocks(uint8_t *at, const uint8_t *end, uint32_t x)
{
#if defined(__GNUC__) && defined(__thumb__)
    /* GCC 12 stores several registers at once only what it has just loaded so. */
    register uint32_t a __asm__("r3") = x;
    register uint32_t b __asm__("r4") = x;
    register uint32_t c __asm__("r5") = x;
    register uint32_t d __asm__("r6") = x;
    __asm__ volatile("1: stmia %0!, {%1, %2, %3, %4}\n\t"
                     "stmia %0!, {%1, %2, %3, %4}\n\t"
                     "stmia %0!, {%1, %2, %3, %4}\n\t"
                     "stmia %0!, {%1, %2, %3, %4}\n\t"
                     "cmp %0, %5\n\t"
                     "bne 1b"
                     : "+l"(at)
                     : "l"(a), "l"(b), "l"(c), "l"(d), "l"(end)
                     : "cc", "memory");
#else
    for (qtri_word *to = (qtri_word *)(void *)at; to != (const qtri_word *)(const void *)end;
         to += 4) {
        to[0] = x;
        to[1] = x;
        to[2] = x;
        to[3] = x;
    }
#endif
}

static void fill(uint8_t *at, size_t bytes, const pattern *stored)
{
    uint8_t *end = at + bytes;
    while (at != end) {
        size_t left = (size_t)(end - at);
        if (((uintptr_t)at & 3) != 0 || left < 4) {
            *at = stored->byte[(uintptr_t)at & 3];
            at++;
        } else if (left < BLOCK_BYTES) {
            const uint8_t *stop = at + (left & ~(size_t)3);
            do {
                *(qtri_word *)(void *)at = stored->word;
                at += 4;
            } while (at != stop);
        } else {
            left &= ~(size_t)(BLOCK_BYTES - 1);
            store_blocks(at, at + left, stored->word);
            at += left;
        }
    }
}

void qtri_fill_words(uint8_t *first, ptrdiff_t pitch, size_t bytes, int32_t rows, uint32_t value)
{
    pattern stored = {value};
    if (pitch == (ptrdiff_t)bytes) {
        bytes *= (size_t)rows;
        rows = 1;
    }
    for (int32_t row = 0; row < rows; row++) {
        fill(first + row * pitch, bytes, &stored);
    }
}

/* ---- Copies ---- */

/* Copied at once, by instructions that load and store several registers. */
typedef struct block {
    uint32_t word[12];
}
#ifdef __GNUC__
__attribute__((__may_alias__))
#endif
block;

/* Copies whole words, both sides aligned; returns the number of bytes. */
static size_t copy_words(uint8_t *to, const uint8_t *from, size_t bytes)
{
    size_t left = bytes;
    for (; left >= sizeof(block); left -= sizeof(block)) {
        *(block *)(void *)to = *(const block *)(const void *)from;
        to += sizeof(block);
        from += sizeof(block);
    }
    for (; left >= 4; left -= 4) {
        *(qtri_word *)(void *)to = *(const qtri_word *)(const void *)from;
        to += 4;
        from += 4;
    }
    return bytes - left;
}

static size_t copy_halves(uint8_t *to, const uint8_t *from, size_t bytes)
{
    uint16_t *out = (uint16_t *)(void *)to;
    const uint16_t *in = (const uint16_t *)(const void *)from;
    size_t left = bytes;
    for (; left >= 8; left -= 8) {
        out[0] = in[0];
        QTRI_BODY_BARRIER(out); /* or two would become a word that is not aligned */
        out[1] = in[1];
        QTRI_BODY_BARRIER(out);
        out[2] = in[2];
        QTRI_BODY_BARRIER(out);
        out[3] = in[3];
        out += 4;
        in += 4;
        QTRI_BODY_BARRIER(out);
        QTRI_BODY_BARRIER(in);
    }
    return bytes - left;
}

void qtri_copy(uint8_t *to, const uint8_t *from, size_t bytes)
{
    const uintptr_t apart = (uintptr_t)to ^ (uintptr_t)from;
    const uintptr_t unit = (apart & 3) == 0 ? 4 : ((apart & 1) == 0 ? 2 : 1);
    for (; bytes > 0 && ((uintptr_t)to & (unit - 1)) != 0; bytes--) {
        *to++ = *from++;
    }
    const size_t done = unit == 4   ? copy_words(to, from, bytes)
                        : unit == 2 ? copy_halves(to, from, bytes)
                                    : 0;
    to += done;
    from += done;
    for (bytes -= done; bytes > 0; bytes--) {
        *to++ = *from++;
    }
}

/* ---- Rectangles ---- */

/* Fills pixels of three bytes: up to a word's begin, eight at a time as words, and the rest. */
static void fill_row_24(uint8_t *at, int32_t count, uint32_t stored)
{
    uint32_t four[3]; /* pixels */
    for (int i = 0; i < 12; i += 3) {
        qtri_save(3, (uint8_t *)four + i, stored);
    }
    const uint32_t a = four[0], b = four[1], c = four[2];
    for (; count > 0 && ((uintptr_t)at & 3) != 0; count--, at += 3) { /* three at most */
        qtri_save(3, at, stored);
    }
    for (; count >= 8; count -= 8, at += 24) {
        qtri_word *to = (qtri_word *)(void *)at;
        to[0] = a;
        to[1] = b;
        to[2] = c;
        to[3] = a;
        to[4] = b;
        to[5] = c;
    }
    for (; count > 0; count--, at += 3) {
        qtri_save(3, at, stored);
    }
}

void qtri_fill_rect(const qtri_surface *surface, const qtri_rect *rect, uint32_t stored)
{
    const qtri_pixels *pixels = surface->format->pixels;
    const size_t pixel_bytes = pixels->bytes;
    const int32_t columns = rect->x1 - rect->x0;
    const int32_t rows = rect->y1 - rect->y0;
    uint8_t *first = qtri_surface_at(surface, rect->x0, rect->y0);
    if (pixel_bytes == 1 || pixel_bytes == 2 || pixel_bytes == 4) {
        if (pixel_bytes == 1) {
            stored = (stored & 0xFF) * 0x101u;
        }
        if (pixel_bytes <= 2) {
            stored = (stored & 0xFFFF) * 0x10001u;
        }
        qtri_fill_words(first, surface->pitch, pixel_bytes * (size_t)columns, rows, stored);
        return;
    }
    for (int32_t row = 0; row < rows; row++, first += surface->pitch) {
        if (pixel_bytes == 3) {
            fill_row_24(first, columns, stored);
            continue;
        }
        uint8_t *at = first; /* pixels of another size */
        for (int32_t left = columns; left > 0; left -= MASK_PIXELS) {
            pixels->fill(at, stored, UINT32_MAX, qtri_least32(left, MASK_PIXELS));
            at += pixel_bytes * MASK_PIXELS;
        }
    }
}
