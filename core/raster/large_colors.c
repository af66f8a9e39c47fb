/* SPDX-License-Identifier: MIT */
/* Colours, light and alpha of large triangles, which pieces have packed: see qtri_pixel_walk. */
#include "large_setup.h"

/* 31 / 255 and 63 / 255. */
#define TO_31 522133279u
#define TO_63 1061109568u

/* 256.0 is 1. */
static inline uint32_t weight(uint32_t c)
{
    return c + (c >> 8) + (c >> 16);
}

/* A vertex's channel as it is stepped, n.16. */
static uint32_t channel(const qtri_options *o, const qtri_large_vertex *v, int i)
{
    const uint32_t c = (uint32_t)qtri_hold32(v->color_8p16[i], 0, 255 * 65536);
    if (qtri_is_textured(o)) {
        return weight(c);
    }
    return qtri_kind_of(o) == QTRI_IN_565 ? qtri_mul_high32(c, i == 1 ? TO_63 : TO_31) : c;
}

static uint32_t luma_of(uint32_t r, uint32_t g, uint32_t b)
{
    return (uint32_t)((qtri_mul_u32(r, 19595) + qtri_mul_u32(g, 38470) + qtri_mul_u32(b, 7471) +
                       32768u) >>
                      16);
}

static uint32_t luma(const qtri_large_vertex *v)
{
    return luma_of((uint32_t)qtri_hold32(v->color_8p16[0], 0, 255 * 65536),
                   (uint32_t)qtri_hold32(v->color_8p16[1], 0, 255 * 65536),
                   (uint32_t)qtri_hold32(v->color_8p16[2], 0, 255 * 65536));
}

void qtri_large_channels(int packing, uint32_t out[3], const uint32_t color_8p16[3])
{
    const uint32_t *c = color_8p16;
    if (packing == QTRI_PACK_565) {
        out[0] = qtri_mul_high32(c[0], TO_31);
        out[1] = qtri_mul_high32(c[1], TO_63);
        out[2] = qtri_mul_high32(c[2], TO_31);
    } else if (packing == QTRI_PACK_ONE) {
        out[0] = luma_of(c[0], c[1], c[2]);
        out[1] = 0;
        out[2] = 0;
    } else {
        for (int i = 0; i < 3; i++) {
            out[i] = packing == QTRI_PACK_WEIGHTS ? weight(c[i]) : c[i];
        }
    }
}

/* An attribute from what it is at the vertices, 8.16. */
static void add_attribute(qtri_large_job *job, const uint32_t value[3], uint32_t half)
{
    qtri_large_attribute *a = &job->t.a[job->count++];
    qtri_find_range(&a->least, &a->most, value);
    for (int k = 0; k < 3; k++) {
        a->f[k] = (value[k] - a->least) << QTRI_LARGE_COLOR_UP;
    }
    a->start = a->least + half;
    a->up = -QTRI_LARGE_COLOR_UP;
}

uint32_t qtri_large_half_of(const qtri_options *o)
{
    if (qtri_is_textured(o)) { /* weights of 6 or 8 bits */
        return qtri_kind_of(o) == QTRI_IN_565 ? (uint32_t)1 << 17 : (uint32_t)1 << 15;
    }
    return qtri_uses_table(o) ? (uint32_t)1 << (23 - QTRI_TABLE_LOG2) : (uint32_t)1 << 15;
}

uint8_t qtri_large_packing_of(const qtri_options *o)
{
    if (qtri_is_lit(o) || (!qtri_is_textured(o) && qtri_kind_of(o) == QTRI_IN_GRAY)) {
        return QTRI_PACK_ONE;
    }
    return !qtri_has_two_words(o) ? QTRI_PACK_565
           : qtri_is_textured(o)  ? QTRI_PACK_WEIGHTS
                                  : QTRI_PACK_888;
}

void qtri_large_set_colors(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    const qtri_options *o = job->options;
    const qtri_large_vertex *v = job->v;
    const uint32_t half = qtri_large_half_of(o);
    uint32_t value[3];
    job->packing = qtri_large_packing_of(o);
    if (job->packing == QTRI_PACK_ONE) {
        for (int k = 0; k < 3; k++) {
            value[k] = qtri_is_lit(o) ? v[k].light_q15 << 9 : luma(&v[k]);
        }
        add_attribute(job, value, half);
        return;
    }
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            value[k] = channel(o, &v[k], i);
        }
        add_attribute(job, value, half);
    }
    job->run_log2 = QTRI_LARGE_RUN_LOG2;
}

void qtri_large_set_alpha(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    const qtri_large_vertex *v = job->v;
    const uint32_t value[3] = {v[0].alpha_q16 << 8, v[1].alpha_q16 << 8, v[2].alpha_q16 << 8};
    job->alpha = job->count;
    add_attribute(job, value, (uint32_t)1 << 15);
}

static uint32_t signed_shift(uint32_t x, int32_t by)
{
    return (uint32_t)((int32_t)x >> by);
}

/* Steps of lanes lose `down` bits. */
static void lane_steps(uint32_t *c_step, uint32_t *g_step, const uint32_t *step, int32_t down)
{
    const uint32_t round = (uint32_t)1 << (down - 1);
    *c_step = (signed_shift(step[0] + round, down) << 16) + signed_shift(step[2] + round, down);
    *g_step = step[1];
}

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

void qtri_large_pack_colors(int packing, qtri_large_piece *piece, const uint32_t *c,
                            const uint32_t *step, int32_t n)
{
    if (packing == QTRI_PACK_ONE) {
        piece->c = c[0];
        piece->c_step = step[0];
    } else if (packing == QTRI_PACK_565) {
        uint32_t center[3];
        word_steps(&piece->c_step, &piece->c_other, center, step, n);
        piece->c = qtri_large_word(c[0] + center[0], c[1] + center[1], c[2] + center[2]);
    } else if (packing != QTRI_PACK_NONE) {
        const int32_t down = packing == QTRI_PACK_WEIGHTS ? 9 : 8;
        lane_steps(&piece->c_step, &piece->g_step, step, down);
        piece->c = (c[0] >> down << 16) + (c[2] >> down);
        piece->g = c[1];
    }
}

void qtri_large_pack(const qtri_large_job *job, qtri_large_piece *piece,
                     const uint32_t at[QTRI_LARGE_ATTRIBUTES],
                     const uint32_t step[QTRI_LARGE_ATTRIBUTES], int32_t n)
{
    qtri_large_pack_colors(job->packing, piece, &at[job->first_color], &step[job->first_color], n);
    if (job->alpha < job->count) {
        piece->alpha = at[job->alpha];
        piece->alpha_step = step[job->alpha];
    }
}

/* Linear in the whole triangle: ramps serve, whose origin has the half that rounds. */
static void set_runs(qtri_large_job *job)
{
    uint32_t step[3];
    for (int i = 0; i < 3; i++) {
        const qtri_large_attribute *a = &job->t.a[job->first_color + i];
        uint32_t f[3];
        for (int k = 0; k < 3; k++) {
            f[k] = a->least + (a->f[k] >> QTRI_LARGE_COLOR_UP);
        }
        if (job->gradient.inverse != 0) { /* |f| < 2^22 */
            qtri_ramp_multiply(&job->run_ramp[i], &job->gradient, f);
        } else {
            qtri_ramp_divide(&job->run_ramp[i], &job->gradient, f);
        }
        step[i] = job->run_ramp[i].dx;
        job->t.run_step[i] = step[i] << QTRI_LARGE_RUN_LOG2;
    }
    word_steps(&job->t.run_even, &job->t.run_odd, job->center, step, QTRI_LARGE_RUN);
    for (int i = 0; i < 3; i++) {
        job->run_ramp[i].origin += job->center[i];
    }
    job->t.has_runs = true;
}

uint32_t qtri_large_begin_runs(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    const int32_t skipped = t->x0 - job->row_left;
    const int32_t x = job->row_left + (skipped & -(int32_t)QTRI_LARGE_RUN) - job->gradient.anchor_x;
    const int32_t y = t->y - job->gradient.anchor_y;
    for (int i = 0; i < 3; i++) {
        t->run[i] = qtri_ramp_at(&job->run_ramp[i], x, y);
    }
    return (uint32_t)skipped & (QTRI_LARGE_RUN - 1);
}

void qtri_large_set_run_steps(qtri_large_job *job)
{
    const qtri_large_attribute *a = &job->t.a[job->first_color];
    if (job->packing == QTRI_PACK_565 && !job->is_curved) {
        set_runs(job);
    } else if (job->packing == QTRI_PACK_ONE) {
        job->t.piece[0].c_step = a->step;
    } else if (job->packing != QTRI_PACK_NONE) {
        const uint32_t step[3] = {a[0].step, a[1].step, a[2].step};
        if (job->packing == QTRI_PACK_565) {
            word_steps(&job->t.run_even, &job->t.run_odd, job->center, step, QTRI_LARGE_RUN);
        } else {
            lane_steps(&job->t.piece[0].c_step, &job->t.piece[0].g_step, step,
                       job->packing == QTRI_PACK_WEIGHTS ? 9 : 8);
        }
    }
    if (job->alpha < job->count) {
        job->t.piece[0].alpha_step = job->t.a[job->alpha].step;
    }
}

void qtri_large_pack_linear(qtri_large_job *job, qtri_large_piece *piece)
{
    const qtri_large_attribute *a = &job->t.a[job->first_color];
    if (job->packing == QTRI_PACK_ONE) {
        piece->c = a->at;
    } else if (job->packing == QTRI_PACK_565) {
        piece->c = qtri_large_word(a[0].at + job->center[0], a[1].at + job->center[1],
                                   a[2].at + job->center[2]);
        piece->c_step = job->t.run_even;
        piece->c_other = job->t.run_odd;
    } else if (job->packing != QTRI_PACK_NONE) {
        const int32_t down = job->packing == QTRI_PACK_WEIGHTS ? 9 : 8;
        piece->c = (a[0].at >> down << 16) + (a[2].at >> down);
        piece->g = a[1].at;
    }
    if (job->alpha < job->count) {
        piece->alpha = job->t.a[job->alpha].at;
    }
}
