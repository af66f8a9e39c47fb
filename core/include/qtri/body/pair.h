/* SPDX-License-Identifier: MIT */
/*
 * Two pixels at once, of 16 bits as their depths are, in words. Internal, part of the pipelines'
 * body (pipeline_make.h).
 *
 * Where words begin at the same columns of pixels and of depths, the low half-word first.
 * Elsewhere, and where options ask for more, pixels are drawn one by one, to the same bits. By
 * pairs a pixel of a large flat triangle (S1) takes 7.4 instructions on a Cortex-M3 and 6.4
 * on a Cortex-M4 in place of 8.5. Words are aligned: memory of devices, as external RAM may be,
 * knows no others.
 */
#ifndef QTRI_BODY_PAIR_H
#define QTRI_BODY_PAIR_H

#include "pixel.h"

#if !defined(QTRI_PIPELINE_IS_ANY) && defined(__GNUC__) && defined(__BYTE_ORDER__) &&              \
    __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ && (defined(__thumb2__) || defined(__x86_64__))
#define QTRI_BODY_PAIRS true
typedef uint32_t __attribute__((may_alias)) qtri_pair_word;
#else
#define QTRI_BODY_PAIRS false
typedef uint32_t qtri_pair_word;
#endif

/* Comparisons that pairs gain by: of others a Cortex-M3 has the low half-word to cut out first. */
QTRI_BODY bool qtri_pairs_compare(const qtri_options *o)
{
#ifdef __ARM_FEATURE_SIMD32
    return o->compare == QTRI_LESS || o->compare == QTRI_LESS_EQUAL || o->compare == QTRI_GREATER ||
           o->compare == QTRI_GREATER_EQUAL;
#else
    return o->compare == QTRI_LESS;
#endif
}

/* Both have the triangle's colour, and all that is done with their depths is the test. */
QTRI_BODY bool qtri_draws_pairs(const qtri_options *o)
{
    return QTRI_BODY_PAIRS && qtri_is_plain(o) && o->blend == QTRI_STORE &&
           qtri_pixel_bytes(o) == 2 && /* of one sample: loops of short pixels ask */
           (!qtri_tests_depth(o) ||
            (qtri_pairs_compare(o) && o->depth == QTRI_LINEAR16 && o->read_only == 0));
}

QTRI_BODY uint32_t qtri_pair_load(const uint8_t *at)
{
    return *(const qtri_pair_word *)(const void *)at;
}

// NOLINTNEXTLINE(readability-non-const-parameter): it is written through
QTRI_BODY void qtri_pair_save(uint8_t *at, uint32_t word)
{
    *(qtri_pair_word *)(void *)at = word;
}

/* Whether words begin at the same columns of both. */
QTRI_BODY bool qtri_pairs_are_aligned(const uint8_t *pixel, const uint8_t *depth)
{
    return (((uintptr_t)pixel ^ (uintptr_t)depth) & 2) == 0;
}

QTRI_BODY bool qtri_pair_begins(const uint8_t *at)
{
    return ((uintptr_t)at & 2) == 0;
}

/* Two depths of 16.16 as they are stored. */
QTRI_BODY uint32_t qtri_pair_depths(uint32_t z_0, uint32_t z_1)
{
#ifdef __ARM_FEATURE_SIMD32
    uint32_t both;
    __asm__("pkhtb %0, %1, %2, asr #16" : "=r"(both) : "r"(z_1), "r"(z_0));
    return both;
#else
    return (z_1 & 0xFFFF0000u) | z_0 >> 16;
#endif
}

#ifdef __ARM_FEATURE_SIMD32
/* Compares both at once, and stores what is there again where the test fails. */
QTRI_BODY void qtri_pair_draw(const qtri_options *o, uint8_t *pixel, uint8_t *depth, uint32_t z_0,
                              uint32_t z_1, uint32_t colors)
{
    const uint32_t stored = qtri_pair_load(depth), z = qtri_pair_depths(z_0, z_1);
    const bool less = o->compare == QTRI_LESS || o->compare == QTRI_GREATER_EQUAL;
    const uint32_t a = less ? z : stored, b = less ? stored : z;
    uint32_t under = qtri_pair_load(pixel), out;
    if (o->compare == QTRI_LESS || o->compare == QTRI_GREATER) { /* a >= b: it fails */
        __asm__("usub16 %0, %2, %3\n\tsel %0, %4, %5\n\tsel %1, %1, %6"
                : "=&r"(out), "+&r"(under)
                : "r"(a), "r"(b), "r"(stored), "r"(z), "r"(colors));
    } else {
        __asm__("usub16 %0, %2, %3\n\tsel %0, %5, %4\n\tsel %1, %6, %1"
                : "=&r"(out), "+&r"(under)
                : "r"(a), "r"(b), "r"(stored), "r"(z), "r"(colors));
    }
    qtri_pair_save(depth, out);
    qtri_pair_save(pixel, under);
}
#else
QTRI_BODY void qtri_pair_draw(const qtri_options *o, uint8_t *pixel, uint8_t *depth, uint32_t z_0,
                              uint32_t z_1, uint32_t colors)
{
    const uint32_t stored = qtri_pair_load(depth);
    (void)o;
    if (QTRI_BODY_LIKELY(z_0 < stored << 16)) {
        if (QTRI_BODY_LIKELY(z_1 >> 16 < stored >> 16)) {
            QTRI_BODY_BRANCH();
            qtri_pair_save(depth, qtri_pair_depths(z_0, z_1));
            qtri_pair_save(pixel, colors);
            return;
        }
        QTRI_BODY_BARRIER(z_0); /* or GCC 12 shifts it for all of these branches */
        qtri_save(2, depth, z_0 >> 16);
        qtri_save(2, pixel, colors);
        return;
    }
    QTRI_BODY_BARRIER(z_1);
    if (z_1 >> 16 < stored >> 16) {
        qtri_save(2, depth + 2, z_1 >> 16);
        qtri_save(2, pixel + 2, colors >> 16);
    }
}
#endif

/* Draws two pixels of the walk, and steps. */
QTRI_BODY void qtri_pixel_pair(const qtri_options *o, qtri_pixel_walk *w, uint8_t *pixel,
                               uint8_t *depth)
{
    const uint32_t colors = (w->color & 0xFFFFu) * 0x10001u;
    if (!qtri_tests_depth(o)) {
        qtri_pair_save(pixel, colors);
        return;
    }
    const uint32_t z_0 = w->z, z_1 = z_0 + w->z_step;
    w->z += 2 * w->z_step;
    qtri_pair_draw(o, pixel, depth, z_0, z_1, colors);
    QTRI_BODY_BARRIER(w->z);
}

#endif
