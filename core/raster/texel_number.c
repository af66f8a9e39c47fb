/* SPDX-License-Identifier: MIT */
#include "texel_number.h"

#include "../bits/bits.h"
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

/* The last of a curve's pixels: 8 of them are 8 steps and 0 + 1 + ... + 7 of what those grow by. */
static uint32_t last_of(const qtri_curve *curve, int32_t count)
{
    uint32_t at = curve->at;
    uint32_t step = curve->step;
    uint32_t bend = curve->bend;
    uint32_t steps = (uint32_t)count - 1;
    for (; steps >= 8; steps -= 8) {
        at += 8 * step + 28 * bend;
        step += 8 * bend;
        QTRI_TURN(step, bend, curve->twist)
    }
    return at + steps * step + (steps * (steps - 1) >> 1) * bend;
}

/*
 * Whether steps keep their sign, so that values lie between the first and the last: up to 2^l
 * pixels, 8 and more, change them by 2^l bends, and by 100, 17 or 0 twists.
 */
static bool is_steady(const qtri_curve *curve, int32_t count)
{
    const uint32_t step = qtri_magnitude32((int32_t)curve->step);
    const uint32_t half = step >> (count > 16 ? 6 : (count > 8 ? 5 : 4));
    return half >= qtri_magnitude32((int32_t)curve->bend) &&
           half >> 2 >= qtri_magnitude32((int32_t)curve->twist);
}

static inline uint32_t scaled(uint32_t step, int32_t up)
{
    return up >= 0 ? step << up : (uint32_t)((int32_t)(step + ((uint32_t)1 << (-up - 1))) >> -up);
}

bool qtri_texel_curve_held(qtri_curve *curve, const qtri_texel_axis *axis, int32_t to,
                           int32_t count)
{
    const int32_t shift = axis->texel_shift;
    const int32_t up = to - shift;
    const int32_t most = axis->mask;
    const int32_t first = (int32_t)(curve->at >> shift) - axis->first;
    int32_t last;
    if ((curve->bend | curve->twist) == 0) {
        last = (int32_t)((curve->at + (uint32_t)(count - 1) * curve->step) >> shift) - axis->first;
    } else if (is_steady(curve, count)) {
        last = (int32_t)(last_of(curve, count) >> shift) - axis->first;
    } else {
        return false;
    }
    if ((first < 0 && last < 0) || (first >= most && last >= most)) {
        const qtri_curve edge = {first < 0 ? 0 : (uint32_t)most << to, 0, 0, 0};
        *curve = edge;
        return true;
    }
    if (first < 0 || last < 0 || first >= most || last >= most) {
        return false;
    }
    const uint32_t inside = curve->at - ((uint32_t)axis->first << shift);
    curve->at = up >= 0 ? inside << up : inside >> -up;
    curve->step = scaled(curve->step, up);
    curve->bend = scaled(curve->bend, up);
    curve->twist = scaled(curve->twist, up);
    return true;
}

#undef MOVE
#define MOVE(n) at += (n);

void qtri_texel_coordinates_held(uint32_t *at, const qtri_texel_axis *axis, int32_t to,
                                 int32_t count)
{
    const uint32_t shift = axis->texel_shift;
    const uint32_t up = to > axis->texel_shift ? (uint32_t)(to - axis->texel_shift) : 0;
    const uint32_t down = to > axis->texel_shift ? 0 : (uint32_t)(axis->texel_shift - to);
    const uint32_t origin = (uint32_t)axis->first << shift;
    const uint32_t top = (uint32_t)axis->mask << to;
    const int32_t first = axis->first;
    const int32_t most = axis->mask;
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t value = at[i];                                                              \
        const int32_t index = (int32_t)(value >> shift) - first;                                   \
        uint32_t held = (value - origin) << up >> down;                                            \
        held = index < 0 ? 0 : held;                                                               \
        at[i] = index >= most ? top : held;                                                        \
    }
    QTRI_WORDS(count)
#undef ONE
}
