/* SPDX-License-Identifier: MIT */
/*
 * Words of pixels from curves along a row: what sources of colour are made of. Internal.
 */
#ifndef QTRI_FRAME_CURVES_H
#define QTRI_FRAME_CURVES_H

#include "barrier.h"
#include "colors.h"

/* Repeats ONE(i) and goes on by four, or one by one where code is to be small. */
#ifdef __OPTIMIZE_SIZE__
#define QTRI_CURVE_WORDS(out, count, ONE)                                                          \
    do {                                                                                           \
        ONE(0)                                                                                     \
        (out)++;                                                                                   \
    } while (--(count) > 0);
#else
#define QTRI_CURVE_WORDS(out, count, ONE)                                                          \
    do {                                                                                           \
        ONE(0)                                                                                     \
        ONE(1)                                                                                     \
        ONE(2)                                                                                     \
        ONE(3)                                                                                     \
        (out) += 4;                                                                                \
        QTRI_OPAQUE(out)                                                                           \
    } while (((count) -= 4) > 0);
#endif

/*
 * out[i] = PACK(r, g, b) of three curves, `less` taken from each; count >= 1, rounded up to a
 * multiple of four. Straight ones, as most are, have a loop without what bends them.
 */
#define QTRI_THREE_CURVES(out, curve, less, count, PACK)                                           \
    {                                                                                              \
        QTRI_THREE_BEGIN(curve, less)                                                              \
        if (!QTRI_SMALL_CODE && (r_bend | g_bend | b_bend) == 0) {                                 \
            QTRI_CURVE_WORDS(out, count, QTRI_STRAIGHT_##PACK)                                     \
        } else {                                                                                   \
            QTRI_CURVE_WORDS(out, count, QTRI_CURVED_##PACK)                                       \
        }                                                                                          \
    }

/* The same of those that are bent. */
#define QTRI_CURVED_CURVES(out, curve, less, count, PACK)                                          \
    {                                                                                              \
        QTRI_THREE_BEGIN(curve, less)                                                              \
        QTRI_CURVE_WORDS(out, count, QTRI_CURVED_##PACK)                                           \
    }

#define QTRI_THREE_BEGIN(curve, less)                                                              \
    uint32_t r = (curve)[0].at - (less);                                                           \
    uint32_t g = (curve)[1].at - (less);                                                           \
    uint32_t b = (curve)[2].at - (less);                                                           \
    uint32_t r_step = (curve)[0].step;                                                             \
    uint32_t g_step = (curve)[1].step;                                                             \
    uint32_t b_step = (curve)[2].step;                                                             \
    uint32_t r_bend = (curve)[0].bend;                                                             \
    uint32_t g_bend = (curve)[1].bend;                                                             \
    uint32_t b_bend = (curve)[2].bend;

#ifdef __OPTIMIZE_SIZE__
#define QTRI_SMALL_CODE 1
#else
#define QTRI_SMALL_CODE 0
#endif

#define QTRI_STEP_THREE                                                                            \
    r += r_step;                                                                                   \
    g += g_step;                                                                                   \
    b += b_step;                                                                                   \
    QTRI_OPAQUE(r)                                                                                 \
    QTRI_OPAQUE(g)                                                                                 \
    QTRI_OPAQUE(b)                                                                                 \
    QTRI_ASIDE(r_step)                                                                             \
    QTRI_ASIDE(g_step)                                                                             \
    QTRI_ASIDE(b_step)

#define QTRI_BEND_THREE                                                                            \
    r_step += r_bend;                                                                              \
    g_step += g_bend;                                                                              \
    b_step += b_bend;                                                                              \
    QTRI_ASIDE(r_bend)                                                                             \
    QTRI_ASIDE(g_bend)                                                                             \
    QTRI_ASIDE(b_bend)

/* A twisted curve goes on, after every eighth pixel. */
#define QTRI_TURN(step, bend, twist)                                                               \
    (step) += (twist);                                                                             \
    (bend) += 2 * (twist);

#endif
