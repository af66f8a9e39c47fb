/* SPDX-License-Identifier: MIT */
#include "texel_number.h"

#include "../frame/curves.h"
#include "loop.h"
#include "texel_copy.h"
#include "words.h"

#define MOVE(n)                                                                                    \
    number += (n);                                                                                 \
    QTRI_OPAQUE(number)

#define STEP                                                                                       \
    u += u_step;                                                                                   \
    v += v_step;                                                                                   \
    QTRI_OPAQUE(u)                                                                                 \
    QTRI_OPAQUE(v)                                                                                 \
    QTRI_ASIDE(u_step)                                                                             \
    QTRI_ASIDE(v_step)

#define BEND                                                                                       \
    u_step += u_bend;                                                                              \
    v_step += v_bend;                                                                              \
    QTRI_ASIDE(u_bend)                                                                             \
    QTRI_ASIDE(v_bend)

#define TURN                                                                                       \
    QTRI_TURN(u_step, u_bend, uv[0].twist)                                                         \
    QTRI_TURN(v_step, v_bend, uv[1].twist)

void qtri_texel_numbers_repeated(uint32_t *number, const qtri_curve uv[2], uint32_t cut,
                                 int32_t count)
{
#define READ(i) number[i] = qtri_texel_index(u, v, cut);
#include "texel_number.inc"
}

#ifndef __OPTIMIZE_SIZE__
void qtri_texels_repeated_16(uint32_t *number, const qtri_curve uv[2], uint32_t cut,
                             const void *texels, int32_t count)
{
    const uint8_t *bytes = texels;
#define READ(i)                                                                                    \
    {                                                                                              \
        const uint32_t at = qtri_texel_index(u, v, cut) * 2;                                       \
        number[i] = *(const uint16_t *)(const void *)(bytes + at);                                 \
        QTRI_ASIDE(bytes)                                                                          \
    }
#include "texel_number.inc"
}
#endif

#undef TURN
#define TURN QTRI_TURN(step, bend, curve->twist)

#define STEP_ONE                                                                                   \
    at += step;                                                                                    \
    step += bend;                                                                                  \
    QTRI_OPAQUE(at)                                                                                \
    QTRI_ASIDE(bend)

/* Adds the columns or rows, times 2^up, that a coordinate leads to. */
static void add_axis(uint32_t *number, const qtri_curve *curve, const qtri_texel_axis *axis,
                     uint32_t up, int32_t count)
{
    const uint32_t shift = axis->texel_shift;
    uint32_t at = curve->at;
    uint32_t step = curve->step;
    uint32_t bend = curve->bend;
    int32_t mask = axis->mask;
    if (!axis->clamped) {
#define ONE(i)                                                                                     \
    number[i] += (at >> shift & (uint32_t)mask) << up;                                             \
    STEP_ONE
        QTRI_WORDS_TURNED(count)
#undef ONE
        return;
    }
    int32_t first = axis->first;
#define ONE(i)                                                                                     \
    {                                                                                              \
        int32_t index = (int32_t)(at >> shift) - first;                                            \
        index = index < 0 ? 0 : index;                                                             \
        index = index > mask ? mask : index;                                                       \
        number[i] += (uint32_t)index << up;                                                        \
        STEP_ONE                                                                                   \
        QTRI_ASIDE(first)                                                                          \
    }
    // cppcheck-suppress shiftTooManyBitsSigned
    QTRI_WORDS_TURNED(count)
#undef ONE
}

/* What is written past `count` is a number of a texel too. */
void qtri_texel_numbers(uint32_t *number, const qtri_curve uv[2], const qtri_texel_axis axis[2],
                        int32_t count)
{
    for (int32_t i = 0; i < count + 3; i++) {
        number[i] = 0;
    }
    add_axis(number, &uv[0], &axis[0], 0, count);
    add_axis(number, &uv[1], &axis[1], axis[0].side_log2, count);
}

#undef TURN
#define TURN                                                                                       \
    QTRI_TURN(u_step, u_bend, uv[0].twist)                                                         \
    QTRI_TURN(v_step, v_bend, uv[1].twist)
#undef MOVE
#define MOVE(n)                                                                                    \
    u += (n);                                                                                      \
    v += (n);

void qtri_texel_coordinates(uint32_t *u, uint32_t *v, const qtri_curve uv[2], int32_t count)
{
    uint32_t u_at = uv[0].at;
    uint32_t v_at = uv[1].at;
    uint32_t u_step = uv[0].step;
    uint32_t v_step = uv[1].step;
    uint32_t u_bend = uv[0].bend;
    uint32_t v_bend = uv[1].bend;
#define ONE(i)                                                                                     \
    u[i] = u_at;                                                                                   \
    v[i] = v_at;                                                                                   \
    u_at += u_step;                                                                                \
    v_at += v_step;                                                                                \
    u_step += u_bend;                                                                              \
    v_step += v_bend;
    QTRI_WORDS_TURNED(count)
#undef ONE
}
