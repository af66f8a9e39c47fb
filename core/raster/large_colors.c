/* SPDX-License-Identifier: MIT */
/* Colours along rows of large triangles: how they are packed, and runs of packed ones. */
#include "large_setup.h"

/* 31 / 255 and 63 / 255. */
#define TO_31 522133279u
#define TO_63 1061109568u

/* 256.0 is 1. */
static inline uint32_t weight(uint32_t c)
{
    return c + (c >> 8) + (c >> 16);
}

void qtri_large_skip_colors(qtri_large_piece *piece, uint32_t n)
{
    const uint32_t even = piece->of.colors.c_step, odd = piece->of.colors.c_other;
    piece->of.colors.c += even * ((n + 1) >> 1) + odd * (n >> 1);
    piece->of.colors.g += piece->of.colors.g_step * n;
    if ((n & 1) != 0) {
        piece->of.colors.c_step = odd;
        piece->of.colors.c_other = even;
    }
}

/* One number: light, or luma -------------------------------------------------------------------
 */

static void pack_one(qtri_large_piece *piece, const uint32_t *c, const uint32_t *step, int32_t n)
{
    (void)n;
    piece->of.colors.c = c[0];
    piece->of.colors.c_step = step[0];
    piece->of.colors.c_other = step[0];
    piece->of.colors.g = 0;
    piece->of.colors.g_step = 0;
}

static void set_luma(uint32_t out[3], const uint32_t c[3])
{
    out[0] = (uint32_t)((qtri_mul_u32(c[0], 19595) + qtri_mul_u32(c[1], 38470) +
                         qtri_mul_u32(c[2], 7471) + 32768u) >>
                        16);
    out[1] = 0;
    out[2] = 0;
}

const qtri_large_packing qtri_packing_light = {NULL, pack_one, 1, 14, false};
const qtri_large_packing qtri_packing_gray = {set_luma, pack_one, 1, 14, false};

/* Lanes ---------------------------------------------------------------------------------------- */

static uint32_t signed_shift(uint32_t x, int32_t by)
{
    return (uint32_t)((int32_t)x >> by);
}

/* Red and blue lose `down` bits. */
static void pack_lanes(qtri_large_piece *piece, const uint32_t *c, const uint32_t *step,
                       int32_t down)
{
    const uint32_t round = (uint32_t)1 << (down - 1);
    piece->of.colors.c = (c[0] >> down << 16) + (c[2] >> down);
    piece->of.colors.c_step =
        (signed_shift(step[0] + round, down) << 16) + signed_shift(step[2] + round, down);
    piece->of.colors.c_other = piece->of.colors.c_step;
    piece->of.colors.g = c[1];
    piece->of.colors.g_step = step[1];
}

static void pack_888(qtri_large_piece *piece, const uint32_t *c, const uint32_t *step, int32_t n)
{
    (void)n;
    pack_lanes(piece, c, step, 8);
}

static void pack_weights(qtri_large_piece *piece, const uint32_t *c, const uint32_t *step,
                         int32_t n)
{
    (void)n;
    pack_lanes(piece, c, step, 9);
}

static void set_same(uint32_t out[3], const uint32_t c[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = c[i];
    }
}

static void set_weights(uint32_t out[3], const uint32_t c[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = weight(c[i]);
    }
}

const qtri_large_packing qtri_packing_888 = {set_same, pack_888, 3, QTRI_LARGE_RUN_LOG2, false};
const qtri_large_packing qtri_packing_weights = {set_weights, pack_weights, 3, QTRI_LARGE_RUN_LOG2,
                                                 false};

/* A word of 565 -------------------------------------------------------------------------------- */

/* A step to nearest 2^(bits - 16); to nearest zero of what is below 0, as all sums are unsigned. */
static uint32_t rounded(uint32_t step, uint32_t bits)
{
    return (step + ((uint32_t)1 << (bits - 1))) & ~(((uint32_t)1 << bits) - 1);
}

static uint32_t word_step(const uint32_t step[3])
{
    return (step[0] >> 10 << 21) + step[2] + signed_shift(step[1], 11);
}

/*
 * Two steps in turn, whose sum is rounded; and what is added where n pixels start: half of what
 * that sums up to along them.
 */
static inline void channel_steps(uint32_t *one, uint32_t *two, uint32_t *center, uint32_t step,
                                 uint32_t bits, int32_t n)
{
    const uint32_t both = rounded(2 * step, bits);
    *one = rounded(step, bits);
    *two = both - *one;
    *center = (uint32_t)(((int32_t)(2 * step - both) * (n - 1)) >> 2);
}

static void word_steps(uint32_t *even, uint32_t *odd, uint32_t center[3], const uint32_t *step,
                       int32_t n)
{
    uint32_t one[3], two[3];
    channel_steps(&one[0], &two[0], &center[0], step[0], 10, n);
    channel_steps(&one[1], &two[1], &center[1], step[1], 11, n);
    channel_steps(&one[2], &two[2], &center[2], step[2], 11, n);
    *even = word_step(one);
    *odd = word_step(two);
}

static void pack_565(qtri_large_piece *piece, const uint32_t *c, const uint32_t *step, int32_t n)
{
    uint32_t center[3];
    word_steps(&piece->of.colors.c_step, &piece->of.colors.c_other, center, step, n);
    piece->of.colors.c = qtri_large_word(c[0] + center[0], c[1] + center[1], c[2] + center[2]);
    piece->of.colors.g = 0;
    piece->of.colors.g_step = 0;
}

static void set_565(uint32_t out[3], const uint32_t c[3])
{
    out[0] = qtri_mul_high32(c[0], TO_31);
    out[1] = qtri_mul_high32(c[1], TO_63);
    out[2] = qtri_mul_high32(c[2], TO_31);
}

static void set_fine(uint32_t out[3], const uint32_t c[3])
{
    set_565(out, c);
    out[0] <<= 3;
    out[1] <<= 2;
    out[2] <<= 3;
}

const qtri_large_packing qtri_packing_565 = {set_565, pack_565, 3, QTRI_LARGE_RUN_LOG2, true};
const qtri_large_packing qtri_packing_fine = {set_fine, pack_888, 3, QTRI_LARGE_RUN_LOG2, false};

/* Runs begin at any pixel of a row. */
void qtri_large_set_runs(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    uint32_t step[3], center[3];
    if (job->is_curved) {
        return;
    }
    qtri_large_use_weights(t, false);
    for (int i = 0; i < 3; i++) {
        const qtri_large_attribute *a = &job->a[i];
        const int64_t f_q8[3] = {(int64_t)a->f[0] * 256, (int64_t)a->f[1] * 256,
                                 (int64_t)a->f[2] * 256};
        qtri_large_ramp ramp;
        qtri_large_ramp_init(&ramp, t, f_q8, QTRI_LARGE_COLOR_UP);
        step[i] = (uint32_t)ramp.dx;
        job->a[i].step = step[i];
        job->run_down[i] = (uint32_t)ramp.dy;
        job->run_at[i] = (uint32_t)ramp.at + a->start;
        job->run_step[i] = step[i] << QTRI_LARGE_RUN_LOG2;
    }
    word_steps(&job->run_even, &job->run_odd, center, step, QTRI_LARGE_RUN);
    for (int i = 0; i < 3; i++) {
        job->run_at[i] += center[i];
    }
}

uint32_t qtri_large_begin_runs(const qtri_large *t, uint32_t start[3])
{
    const qtri_large_job *job = (const qtri_large_job *)(const void *)t;
    const uint32_t skipped = (uint32_t)(t->x0 - t->row_left);
    const uint32_t passed = skipped & ~(uint32_t)(QTRI_LARGE_RUN - 1);
    const uint32_t x = (uint32_t)t->row_left + passed, y = (uint32_t)t->y;
    for (int i = 0; i < 3; i++) {
        start[i] = job->run_at[i] + job->a[i].step * x + job->run_down[i] * y;
    }
    return skipped - passed;
}
