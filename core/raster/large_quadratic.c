/* SPDX-License-Identifier: MIT */
/*
 * Colours in perspective without a reciprocal for each row: a polynomial of second order in the
 * weights b1 and b2 of vertices 1 and 2,
 *
 *     F = f0 + a1 b1 + a2 b2 + b11 b1^2 + b12 b1 b2 + b22 b2^2,
 *
 * that is exact at the vertices and in the middles of the edges. Between vertices i and j the
 * middle is f_i + (f_j - f_i) s with s = q_j / (q_i + q_j). With r = (q_max - q_min) / (q_max +
 * q_min) and the range of f, F is off by less than range r^2 / 4 where r <= 1/3: largest on an
 * edge, .20 range r^2 for small r, .239 range r^2 at r = 1/3.
 *
 * Along a row F(x + m) = F(x) + m slope(x) + m^2 curve, so a chord over m pixels steps by slope + m
 * curve; mostly one serves the row.
 */
#include "large_setup.h"

enum { PIXELS_MAX = 1024 /* of a side: weights are off by 2^-20 */ };

/* a b / 2^30, to nearest, |a| <= 2^31, |b| <= 2^30. */
static inline int32_t mul_q30(int32_t a, int32_t b)
{
    return (int32_t)((qtri_mul_s32(a, b) + ((int64_t)1 << 29)) >> 30);
}

/* q1 / (q0 + q1), Q30. */
static int32_t middle_of(uint32_t q0, uint32_t q1)
{
    const uint32_t sum = (q0 >> 1) + (q1 >> 1);
    const int32_t zeros = qtri_clz32(sum | 1); /* 2^29 or more, as is_near() asks */
    const uint32_t r = (uint32_t)qtri_reciprocal_below(sum << zeros);
    return (int32_t)(qtri_mul_u32(q1 >> 1, r) >> (32 - zeros));
}

/* The largest bound, in units of f, that colours may stray by. */
static uint32_t bound_of(const qtri_large_job *job)
{
    return (uint32_t)1 << (qtri_large_chord_bound_log2(job) + QTRI_LARGE_COLOR_UP);
}

/* Whether F is off by less than 3/2 of the bound, .09 to .38 of a step; of packed colours, whose
   steps are rounded, by 3/4. */
static bool is_near(const qtri_large_job *job)
{
    const uint32_t limit = bound_of(job) * (job->packing == QTRI_PACK_565 ? 3 : 6);
    uint32_t q_min, q_max;
    qtri_find_range(&q_min, &q_max, job->q_at);
    const uint32_t sum = (q_min >> 17) + (q_max >> 17); /* < 2^15; q_max is 2^30 or more */
    const uint32_t difference = ((q_max - q_min) >> 17) + 1;
    if (q_max >> 1 > q_min) {
        return false;
    }
    for (int i = 0; i < job->count; i++) {
        const qtri_large_attribute *a = &job->t.a[i];
        const uint32_t range = (a->most - a->least) << QTRI_LARGE_COLOR_UP;
        if (qtri_mul_u32(difference * difference, range) > qtri_mul_u32(sum * sum, limit)) {
            return false;
        }
    }
    return true;
}

/* Weights in Q30; false: of a triangle so thin that they step by more than 1/2 a pixel. */
static bool set_weights(qtri_large_job *job)
{
    const qtri_large_weights *w = &job->weights;
    const int32_t down = w->fraction - 30;
    if (down < 0 || down > 62) {
        return false;
    }
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 3; k++) {
            const int64_t b = w->b[i][k] >> down;
            if (k < 2 && qtri_magnitude64(b) > (uint64_t)1 << 29) {
                return false;
            }
            job->weight_q30[i][k] = (uint32_t)b;
        }
    }
    return true;
}

/* |f| < 2^29, |e| <= |d| < 2^29: |a| < 2^30 and |b| < 2^29 for r <= 1/3. */
static void set_polynomial(qtri_large_attribute *a, const int32_t middle[3])
{
    qtri_large_quadratic *f = &a->along.quadratic;
    const uint32_t *at = a->f;
    const int32_t d1 = (int32_t)(at[1] - at[0]), d2 = (int32_t)(at[2] - at[0]);
    const int32_t e1 = mul_q30(d1, middle[0]), e2 = mul_q30(d2, middle[1]);
    f->a1 = 4 * e1 - d1;
    f->a2 = 4 * e2 - d2;
    f->b11 = 2 * (d1 - 2 * e1);
    f->b22 = 2 * (d2 - 2 * e2);
    f->b12 = 4 * (d1 - e1 - e2 + mul_q30(d2 - d1, middle[2]));
}

/*
 * Slopes are below 2^31: a weight's share of F changes by the range of f times 1 + 4 r at most, and
 * is_near() leaves r <= .16 where that range is 2^29.
 */
static void set_slopes(const qtri_large_job *job, qtri_large_quadratic *f)
{
    const int32_t x1 = (int32_t)job->weight_q30[0][0], x2 = (int32_t)job->weight_q30[1][0];
    f->slope = mul_q30(f->a1, x1) + mul_q30(f->a2, x2);
    f->slope1 = 2 * mul_q30(f->b11, x1) + mul_q30(f->b12, x2);
    f->slope2 = 2 * mul_q30(f->b22, x2) + mul_q30(f->b12, x1);
    f->curve = (mul_q30(f->slope1, x1) + mul_q30(f->slope2, x2)) / 2;
}

/* The longest chords that are off by half of the bound, curve m^2 / 4; of packed colours by 1/4. */
static void set_length(qtri_large_job *job)
{
    const uint32_t limit = bound_of(job) * (job->packing == QTRI_PACK_565 ? 1 : 2);
    uint32_t curve = 0;
    for (int i = 0; i < job->count; i++) {
        curve |= qtri_magnitude32(job->t.a[i].along.quadratic.curve);
    }
    int32_t log2 = QTRI_LARGE_RUN_LOG2;
    while (log2 > 0 && qtri_mul_u32(curve, (uint32_t)1 << 2 * log2) > limit) {
        log2--;
    }
    job->quadratic_log2 = (uint8_t)log2;
}

/* False: they do not serve. */
static bool set_quadratics(qtri_large_job *job)
{
    const uint32_t *q = job->q_at;
    if (job->pixels > PIXELS_MAX || !is_near(job)) {
        return false;
    }
    qtri_large_use_weights(job, false); /* so that colours stay within those of the vertices */
    if (!set_weights(job)) {
        return false;
    }
    const int32_t middle[3] = {middle_of(q[0], q[1]), middle_of(q[0], q[2]), middle_of(q[1], q[2])};
    for (int i = 0; i < job->count; i++) {
        set_polynomial(&job->t.a[i], middle);
        set_slopes(job, &job->t.a[i].along.quadratic);
    }
    set_length(job);
    job->t.is_bent = false;
    job->is_quadratic = true;
    return true;
}

void qtri_large_set_color_planes(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    int64_t q_q8[3];
    if (!qtri_large_set_linear(job, q_q8) && !set_quadratics(job)) {
        qtri_large_set_curved(job, q_q8);
    }
}

/* A chord of n pixels from column x on, n.16. */
static inline void set_chord(const qtri_large_attribute *a, int32_t b1, int32_t b2, int32_t n,
                             uint32_t *at, uint32_t *step)
{
    const qtri_large_quadratic *f = &a->along.quadratic;
    const uint32_t p1 =
        (uint32_t)f->a1 + (uint32_t)mul_q30(f->b11, b1) + (uint32_t)mul_q30(f->b12, b2);
    const uint32_t p2 = (uint32_t)f->a2 + (uint32_t)mul_q30(f->b22, b2);
    const uint32_t value =
        a->f[0] + (uint32_t)mul_q30((int32_t)p1, b1) + (uint32_t)mul_q30((int32_t)p2, b2);
    const uint32_t slope = (uint32_t)f->slope + (uint32_t)mul_q30(f->slope1, b1) +
                           (uint32_t)mul_q30(f->slope2, b2) + (uint32_t)f->curve * (uint32_t)n;
    *at = (uint32_t)((int32_t)value >> QTRI_LARGE_COLOR_UP) + a->start;
    *step = (uint32_t)((int32_t)slope >> QTRI_LARGE_COLOR_UP);
    qtri_large_clamp_chord(a, at, step, n);
}

int32_t qtri_large_next_colors(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    if (!job->is_quadratic) {
        return qtri_large_next_any(t);
    }
    if (t->is_new) { /* pieces are counted from the row's left end, which no scissor moves */
        t->x = t->row_left + ((t->x0 - t->row_left) >> job->quadratic_log2 << job->quadratic_log2);
        t->is_new = false;
    }
    uint32_t at[QTRI_LARGE_ATTRIBUTES], step[QTRI_LARGE_ATTRIBUTES];
    const int32_t x = t->x;
    const int32_t n = qtri_least32((int32_t)1 << job->quadratic_log2, t->row_right - x);
    const uint32_t right = (uint32_t)(x - (job->x[0] >> 8));
    const uint32_t down = (uint32_t)(t->y - (job->y[0] >> 8));
    const uint32_t *w1 = job->weight_q30[0], *w2 = job->weight_q30[1];
    const int32_t b1 = (int32_t)(w1[0] * right + w1[1] * down + w1[2]);
    const int32_t b2 = (int32_t)(w2[0] * right + w2[1] * down + w2[2]);
    for (int i = 0; i < job->count; i++) {
        set_chord(&t->a[i], b1, b2, n, &at[i], &step[i]);
    }
    qtri_large_piece *piece = &t->piece[0];
    qtri_large_pack(job, piece, at, step, n);
    piece->count = n;
    if (x < t->x0 || x + n > t->x1) {
        qtri_large_cut(job, piece, x);
    }
    t->x = x + n;
    return 1;
}
