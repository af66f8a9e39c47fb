/* SPDX-License-Identifier: MIT */
/*
 * Two pixels at once: of one colour, of 16 bits as their depths are, in words. Internal, part of
 * the pipelines' body (pipeline_make.h).
 *
 * Where a core loads words from any address, the low half-word first. Elsewhere, and where options
 * ask for more, pixels are drawn one by one, to the same bits: large flat triangles (S1) then take
 * 8.5 instructions a pixel, with pairs 7.3 on a Cortex-M3, 6.3 on a Cortex-M4.
 */
#ifndef QTRI_BODY_PAIR_H
#define QTRI_BODY_PAIR_H

#include "stored.h"

#if !defined(QTRI_PIPELINE_IS_ANY) && defined(__GNUC__) && defined(__BYTE_ORDER__) &&              \
    __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ &&                                                   \
    (defined(__ARM_FEATURE_UNALIGNED) || defined(__x86_64__))

typedef struct qtri_pair_word {
    uint32_t word;
} __attribute__((packed, may_alias)) qtri_pair_word;

/* Both have the triangle's colour, and all that is done with their depths is the test. */
QTRI_BODY bool qtri_draws_pairs(const qtri_options *o)
{
    const bool orders = o->compare == QTRI_LESS || o->compare == QTRI_LESS_EQUAL ||
                        o->compare == QTRI_GREATER || o->compare == QTRI_GREATER_EQUAL;
    return qtri_is_plain(o) && o->blend == QTRI_STORE && qtri_pixel_bytes(o) == 2 &&
           !qtri_has_samples(o) &&
           (!qtri_tests_depth(o) || (orders && o->depth == QTRI_LINEAR16 && o->read_only == 0));
}

QTRI_BODY uint32_t qtri_pair_load(const uint8_t *at)
{
    return ((const qtri_pair_word *)(const void *)at)->word;
}

QTRI_BODY void qtri_pair_save(uint8_t *at, uint32_t word)
{
    ((qtri_pair_word *)(void *)at)->word = word;
}

/* Two depths of 16.16 as they are stored. */
QTRI_BODY uint32_t qtri_pair_depths(const uint32_t z_16p16[2])
{
#ifdef __ARM_FEATURE_SIMD32
    uint32_t both;
    __asm__("pkhtb %0, %1, %2, asr #16" : "=r"(both) : "r"(z_16p16[1]), "r"(z_16p16[0]));
    return both;
#else
    return (z_16p16[1] & 0xFFFF0000u) | z_16p16[0] >> 16;
#endif
}

#ifdef __ARM_FEATURE_SIMD32
/* Compares both at once, and stores what is there again where the test fails. */
QTRI_BODY void qtri_pair_draw(const qtri_options *o, const qtri_pixel_walk *w, uint8_t *pixel,
                              uint8_t *depth, const uint32_t z_16p16[2])
{
    const uint32_t stored = qtri_pair_load(depth), z = qtri_pair_depths(z_16p16);
    const uint32_t color = (w->color & 0xFFFFu) * 0x10001u;
    const bool less = o->compare == QTRI_LESS || o->compare == QTRI_GREATER_EQUAL;
    const uint32_t a = less ? z : stored, b = less ? stored : z;
    uint32_t under = qtri_pair_load(pixel), out;
    if (o->compare == QTRI_LESS || o->compare == QTRI_GREATER) { /* a >= b: it fails */
        __asm__("usub16 %0, %2, %3\n\tsel %0, %4, %5\n\tsel %1, %1, %6"
                : "=&r"(out), "+&r"(under)
                : "r"(a), "r"(b), "r"(stored), "r"(z), "r"(color));
    } else {
        __asm__("usub16 %0, %2, %3\n\tsel %0, %5, %4\n\tsel %1, %6, %1"
                : "=&r"(out), "+&r"(under)
                : "r"(a), "r"(b), "r"(stored), "r"(z), "r"(color));
    }
    qtri_pair_save(depth, out);
    qtri_pair_save(pixel, under);
}
#else
QTRI_BODY void qtri_pair_draw(const qtri_options *o, const qtri_pixel_walk *w, uint8_t *pixel,
                              uint8_t *depth, const uint32_t z_16p16[2])
{
    const uint32_t stored = qtri_pair_load(depth);
    const uint32_t color = w->color & 0xFFFFu;
    /* A shift to the left, in place of the low half-word, saves an instruction. */
    const bool first = o->compare == QTRI_LESS
                           ? z_16p16[0] < stored << 16
                           : qtri_depth_passes(o, w, z_16p16[0] >> 16, stored & 0xFFFFu);
    uint32_t alone;
    if (__builtin_expect(first, 1)) {
        if (__builtin_expect(qtri_depth_passes(o, w, z_16p16[1] >> 16, stored >> 16), 1)) {
            QTRI_BODY_BRANCH();
            qtri_pair_save(depth, qtri_pair_depths(z_16p16));
            qtri_pair_save(pixel, color * 0x10001u);
            return;
        }
        alone = z_16p16[0];
        QTRI_BODY_BARRIER(alone); /* or GCC 12 shifts it for all of these branches */
        qtri_save(2, depth, alone >> 16);
        qtri_save(2, pixel, color);
        return;
    }
    alone = z_16p16[1];
    QTRI_BODY_BARRIER(alone);
    if (qtri_depth_passes(o, w, alone >> 16, stored >> 16)) {
        qtri_save(2, depth + 2, alone >> 16);
        qtri_save(2, pixel + 2, color);
    }
}
#endif

/* Draws pixels i and i + 1 of the walk, and steps. */
QTRI_BODY void qtri_pixel_pair(const qtri_options *o, qtri_pixel_walk *w, int32_t i)
{
    if (!qtri_tests_depth(o)) {
        qtri_pair_save(w->pixel + 2 * i, (w->color & 0xFFFFu) * 0x10001u);
        return;
    }
    const uint32_t z[2] = {w->z, w->z + w->z_step};
    w->z += 2 * w->z_step;
    qtri_pair_draw(o, w, w->pixel + 2 * i, w->depth + 2 * i, z);
    QTRI_BODY_BARRIER(w->z);
}

#else

QTRI_BODY bool qtri_draws_pairs(const qtri_options *o)
{
    (void)o;
    return false;
}

QTRI_BODY void qtri_pixel_pair(const qtri_options *o, qtri_pixel_walk *w, int32_t i)
{
    (void)o;
    (void)w;
    (void)i;
}

#endif

#endif
