/* SPDX-License-Identifier: MIT */
/*
 * Assembly loops for Armv7-M that draw four pixels at once, colours and depths of 16 bits being
 * two words each. Internal, part of the pipelines' body (pipeline_make.h).
 *
 * They serve where words begin at the same columns of pixels and depths; elsewhere, and with other
 * options, pixels are drawn one by one, to the same bits. By fours a pixel takes 5.75 instructions
 * on a Cortex-M3 (4.75 where four fail) and 4.5 on a Cortex-M4, alone 7.6 (5.6); of packed colours
 * 9 on a Cortex-M4, alone 10.6. Words are aligned: memory of devices, as external RAM may be, knows
 * no others.
 */
#ifndef QTRI_BODY_QUADS_H
#define QTRI_BODY_QUADS_H

#include "pixel.h"

#if !defined(QTRI_PIPELINE_IS_ANY) && defined(__GNUC__) && defined(__thumb2__) &&                  \
    __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
#define QTRI_BODY_QUADS true
#else
#define QTRI_BODY_QUADS false
#endif

/* Instructions for two half-words at once; without them loops are for QTRI_LESS and one colour. */
#ifdef __ARM_FEATURE_SIMD32
#define QTRI_BODY_HALVES true
#else
#define QTRI_BODY_HALVES false
#endif

/* Whether loops have the comparison. */
QTRI_BODY bool qtri_quads_compare(const qtri_options *o)
{
    return o->compare == QTRI_LESS ||
           (QTRI_BODY_HALVES && (o->compare == QTRI_LESS_EQUAL || o->compare == QTRI_GREATER ||
                                 o->compare == QTRI_GREATER_EQUAL));
}

/* Whether a loop steps packed vertex colours, which replace the pixel. */
QTRI_BODY bool qtri_quads_vary(const qtri_options *o)
{
    return QTRI_BODY_HALVES && qtri_is_packed_565(o) && qtri_tests_depth(o) && !o->fog &&
           !qtri_reads_pixel(o) && o->fragment == NULL;
}

/* Whether pixels are drawn by fours: stored as they are, depths tested and written, or neither. */
QTRI_BODY bool qtri_draws_quads(const qtri_options *o)
{
    return QTRI_BODY_QUADS && (qtri_has_constant_color(o) || qtri_quads_vary(o)) &&
           o->blend == QTRI_STORE &&
           qtri_pixel_bytes(o) == 2 && /* of one sample: loops of short pixels ask */
           (!qtri_tests_depth(o) ||
            (qtri_quads_compare(o) && o->depth == QTRI_LINEAR16 && o->read_only == 0));
}

#if QTRI_BODY_QUADS
/* Each draws pixels of the walk by fours until `more`, how many there are more than four, is below
   0, and returns that. */
#if QTRI_BODY_HALVES
/* Compares half-words of d, stored depths, with those of z by a flag each; d becomes what stays. */
#define QTRI_QUADS_LESS(d, z, t)       "usub16 " t ", " z ", " d "\n\tsel " d ", " d ", " z "\n\t"
#define QTRI_QUADS_GREATER(d, z, t)    "usub16 " t ", " d ", " z "\n\tsel " d ", " d ", " z "\n\t"
#define QTRI_QUADS_LESS_EQUAL(d, z, t) "usub16 " t ", " d ", " z "\n\tsel " d ", " z ", " d "\n\t"
#define QTRI_QUADS_GREATER_EQUAL(d, z, t)                                                          \
    "usub16 " t ", " z ", " d "\n\tsel " d ", " z ", " d "\n\t"

/* By these flags, the colour that stays. */
#define QTRI_QUADS_UNDER(p, c) "sel " p ", " p ", " c "\n\t"
#define QTRI_QUADS_OVER(p, c)  "sel " p ", " c ", " p "\n\t"

/* Runs the loop for a comparison. */
#define QTRI_QUADS_BY_COMPARE(o, loop)                                                             \
    do {                                                                                           \
        if ((o)->compare == QTRI_LESS) {                                                           \
            loop(QTRI_QUADS_LESS, QTRI_QUADS_UNDER);                                               \
        } else if ((o)->compare == QTRI_GREATER) {                                                 \
            loop(QTRI_QUADS_GREATER, QTRI_QUADS_UNDER);                                            \
        } else if ((o)->compare == QTRI_LESS_EQUAL) {                                              \
            loop(QTRI_QUADS_LESS_EQUAL, QTRI_QUADS_OVER);                                          \
        } else {                                                                                   \
            loop(QTRI_QUADS_GREATER_EQUAL, QTRI_QUADS_OVER);                                       \
        }                                                                                          \
    } while (0)

/* clang-format off */
/* Depths of the next two pixels. */
#define QTRI_QUADS_NEXT                                                                            \
    "add %[both], %[z], %[step]\n\t"                                                               \
    "pkhtb %[both], %[both], %[z], asr #16\n\t"                                                    \
    "add %[z], %[z], %[step], lsl #1\n\t"

#define QTRI_QUADS_FLAT(test, select)                                                              \
    __asm__ volatile(                                                                              \
        "1: ldrd %[d0], %[d1], [%[depth]]\n\t"                                                     \
        "ldrd %[p0], %[p1], [%[pixel]]\n\t"                                                        \
        QTRI_QUADS_NEXT test("%[d0]", "%[both]", "%[t]") select("%[p0]", "%[colors]")              \
        QTRI_QUADS_NEXT test("%[d1]", "%[both]", "%[t]") select("%[p1]", "%[colors]")              \
        "strd %[d0], %[d1], [%[depth]], #8\n\t"                                                    \
        "strd %[p0], %[p1], [%[pixel]], #8\n\t"                                                    \
        "subs %[more], #4\n\t"                                                                     \
        "bge 1b"                                                                                   \
        : [d0] "=&r"(d0), [d1] "=&r"(d1), [p0] "=&r"(p0), [p1] "=&r"(p1), [both] "=&r"(both),      \
          [t] "=&r"(t), [z] "+&r"(w->z), [pixel] "+&r"(w->pixel), [depth] "+&r"(w->depth),         \
          [more] "+&r"(more)                                                                       \
        : [step] "r"(w->z_step), [colors] "r"(colors)                                              \
        : "cc", "memory")
/* clang-format on */

QTRI_BODY int32_t qtri_quads_flat(const qtri_options *o, qtri_pixel_walk *w, uint32_t colors,
                                  int32_t more)
{
    uint32_t d0, d1, p0, p1, both, t;
    QTRI_QUADS_BY_COMPARE(o, QTRI_QUADS_FLAT);
    return more;
}

/* clang-format off */
/* Two pixels; once the depth is stored its registers serve colours. */
#define QTRI_QUADS_COLOR_PAIR(test, select)                                                        \
    "ldr %[d], [%[depth]]\n\t"                                                                     \
    QTRI_QUADS_NEXT test("%[d]", "%[both]", "%[x]")                                                \
    "str %[d], [%[depth]], #4\n\t"                                                                 \
    "and %[d], %[c], %[mask]\n\t"                                                                  \
    "add %[c], %[c], %[even]\n\t"                                                                  \
    "and %[both], %[c], %[mask]\n\t"                                                               \
    "add %[c], %[c], %[odd]\n\t"                                                                   \
    "pkhbt %[x], %[d], %[both], lsl #16\n\t"                                                       \
    "pkhtb %[both], %[both], %[d], asr #16\n\t"                                                    \
    "orr %[x], %[x], %[both]\n\t"                                                                  \
    "ldr %[d], [%[pixel]]\n\t"                                                                     \
    select("%[d]", "%[x]")                                                                         \
    "str %[d], [%[pixel]], #4\n\t"

#define QTRI_QUADS_COLORS(test, select)                                                            \
    __asm__ volatile(                                                                              \
        "1: " QTRI_QUADS_COLOR_PAIR(test, select) QTRI_QUADS_COLOR_PAIR(test, select)              \
        "subs %[more], #4\n\t"                                                                     \
        "bge 1b"                                                                                   \
        : [d] "=&r"(d), [x] "=&r"(x), [both] "=&r"(both), [z] "+&r"(w->z), [c] "+&r"(w->c),        \
          [pixel] "+&r"(w->pixel), [depth] "+&r"(w->depth), [more] "+&r"(more)                     \
        : [step] "r"(w->z_step), [even] "r"(w->c_step), [odd] "r"(w->c_other),                     \
          [mask] "r"(0xF81F07E0u)                                                                  \
        : "cc", "memory")
/* clang-format on */

QTRI_BODY int32_t qtri_quads_colors(const qtri_options *o, qtri_pixel_walk *w, int32_t more)
{
    uint32_t d, x, both;
    QTRI_QUADS_BY_COMPARE(o, QTRI_QUADS_COLORS);
    return more;
}
#else
/* Ends before four pixels of which some pass and some fail, too. */
QTRI_BODY int32_t qtri_quads_flat(const qtri_options *o, qtri_pixel_walk *w, uint32_t colors,
                                  int32_t more)
{
    uint32_t d0, d1, z1, z2;
    (void)o;
    __asm__ volatile(
        "1: ldrd %[d0], %[d1], [%[depth]]\n\t"
        "add %[z1], %[z], %[step]\n\t"
        "add %[z2], %[z], %[step], lsl #1\n\t"
        "cmp %[z], %[d0], lsl #16\n\t"
        "bcs 2f\n\t"
        "lsrs %[d0], %[d0], #16\n\t"
        "cmp %[d0], %[z1], lsr #16\n\t"
        "bls 4f\n\t"
        "cmp %[z2], %[d1], lsl #16\n\t"
        "bcs 4f\n\t"
        "lsrs %[d1], %[d1], #16\n\t"
        "add %[d0], %[z2], %[step]\n\t" /* of the last pixel */
        "cmp %[d1], %[d0], lsr #16\n\t"
        "bls 4f\n\t"
        "lsrs %[z], %[z], #16\n\t"
        "bfi %[z1], %[z], #0, #16\n\t"
        "add %[z], %[z2], %[step], lsl #1\n\t"
        "lsrs %[z2], %[z2], #16\n\t"
        "bfi %[d0], %[z2], #0, #16\n\t"
        "strd %[z1], %[d0], [%[depth]], #8\n\t"
        "strd %[colors], %[colors], [%[pixel]], #8\n\t"
        "subs %[more], #4\n\t"
        "bge 1b\n\t"
        "b 4f\n"
        "2: lsrs %[d0], %[d0], #16\n\t" /* the first fails */
        "cmp %[d0], %[z1], lsr #16\n\t"
        "bhi 4f\n\t"
        "cmp %[z2], %[d1], lsl #16\n\t"
        "bcc 4f\n\t"
        "lsrs %[d1], %[d1], #16\n\t"
        "add %[d0], %[z2], %[step]\n\t"
        "cmp %[d1], %[d0], lsr #16\n\t"
        "bhi 4f\n\t"
        "add %[z], %[z2], %[step], lsl #1\n\t"
        "adds %[depth], #8\n\t"
        "adds %[pixel], #8\n\t"
        "subs %[more], #4\n\t"
        "bge 1b\n"
        "4:"
        : [d0] "=&r"(d0), [d1] "=&r"(d1), [z1] "=&r"(z1), [z2] "=&r"(z2), [z] "+&r"(w->z),
          [pixel] "+&r"(w->pixel), [depth] "+&r"(w->depth), [more] "+&r"(more)
        : [step] "r"(w->z_step), [colors] "r"(colors)
        : "cc", "memory");
    return more;
}

/* Draws none: see qtri_quads_vary(). */
QTRI_BODY int32_t qtri_quads_colors(const qtri_options *o, qtri_pixel_walk *w, int32_t more)
{
    (void)o;
    (void)w;
    return more;
}
#endif

QTRI_BODY int32_t qtri_quads_fill(qtri_pixel_walk *w, uint32_t colors, int32_t more)
{
    __asm__ volatile("1: strd %[colors], %[colors], [%[pixel]], #8\n\t"
                     "subs %[more], #4\n\t"
                     "bge 1b"
                     : [pixel] "+&r"(w->pixel), [more] "+&r"(more)
                     : [colors] "r"(colors)
                     : "cc", "memory");
    return more;
}

/* Draws pixels of the walk by fours, as long as all of four pass or fail; returns how many are left
   of `count`. */
QTRI_BODY int32_t qtri_quads_draw(const qtri_options *o, qtri_pixel_walk *w, int32_t count)
{
    const uint32_t colors = (w->color & 0xFFFFu) * 0x10001u;
    if (count < 4) {
        return count;
    }
    return 4 + (!qtri_tests_depth(o) ? qtri_quads_fill(w, colors, count - 4)
                : qtri_varies(o)     ? qtri_quads_colors(o, w, count - 4)
                                     : qtri_quads_flat(o, w, colors, count - 4));
}
#else
QTRI_BODY int32_t qtri_quads_draw(const qtri_options *o, qtri_pixel_walk *w, int32_t count)
{
    (void)o;
    (void)w;
    return count;
}
#endif

#endif
