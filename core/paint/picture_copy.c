/* SPDX-License-Identifier: MIT */
#include "picture.h"

#include "../frame/barrier.h"

#ifdef __GNUC__
typedef uint32_t __attribute__((__may_alias__)) word;
#else
typedef uint32_t word;
#endif

/* Blocks of words. */
static size_t copy_words(uint8_t *to, const uint8_t *from, size_t bytes)
{
    word *out = (word *)(void *)to;
    const word *in = (const word *)(const void *)from;
    size_t left = bytes;
    for (; left >= 16; left -= 16) {
        const uint32_t a = in[0];
        const uint32_t b = in[1];
        const uint32_t c = in[2];
        const uint32_t d = in[3];
        out[0] = a;
        out[1] = b;
        out[2] = c;
        out[3] = d;
        out += 4;
        in += 4;
    }
    for (; left >= 4; left -= 4) {
        *out++ = *in++;
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
        QTRI_OPAQUE(out) /* or two would become a word that is not aligned */
        out[1] = in[1];
        QTRI_OPAQUE(out)
        out[2] = in[2];
        QTRI_OPAQUE(out)
        out[3] = in[3];
        out += 4;
        in += 4;
        QTRI_OPAQUE(out)
        QTRI_OPAQUE(in)
    }
    return bytes - left;
}

static size_t copy_bytes(uint8_t *to, const uint8_t *from, size_t bytes)
{
    size_t left = bytes;
    for (; left >= 4; left -= 4) {
        to[0] = from[0];
        to[1] = from[1];
        to[2] = from[2];
        to[3] = from[3];
        to += 4;
        from += 4;
    }
    return bytes - left;
}

/* As wide as both sides can be aligned at once. */
static void copy_row(uint8_t *to, const uint8_t *from, size_t bytes)
{
    const uintptr_t apart = (uintptr_t)to ^ (uintptr_t)from;
    const uintptr_t unit = (apart & 3) == 0 ? 4 : ((apart & 1) == 0 ? 2 : 1);
    for (; bytes > 0 && ((uintptr_t)to & (unit - 1)) != 0; bytes--) {
        *to++ = *from++;
    }
    const size_t done = unit == 4   ? copy_words(to, from, bytes)
                        : unit == 2 ? copy_halves(to, from, bytes)
                                    : copy_bytes(to, from, bytes);
    to += done;
    from += done;
    for (bytes -= done; bytes > 0; bytes--) {
        *to++ = *from++;
    }
}

void qtri_picture_copy(uint8_t *to, ptrdiff_t to_pitch, const uint8_t *from, ptrdiff_t from_pitch,
                       size_t bytes, int32_t rows)
{
    for (; rows > 0; rows--) {
        copy_row(to, from, bytes);
        to += to_pitch;
        from += from_pitch;
    }
}
