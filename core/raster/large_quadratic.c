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

/* How large r^2 range may be for attribute i: F is off by less than 3/2 of the bound of colours,
   .09 to .38 of a step, of packed ones, whose steps are rounded, by 3/4; of coordinates by 2^-6 of
   a texel. */
static uint64_t limit_of(const qtri_large_job *job, int i)
{
    return i < job->first_color ? (uint64_t)5 << job->axis[i].shift >> 6
           : job->rounds        ? 3 * bound_of(job)
                                : 6 * bound_of(job);
}

static bool is_near(const qtri_large_job *job)
{
    uint32_t q_min, q_max;
    qtri_find_range(&q_min, &q_max, job->q_at);
    const uint32_t sum = (q_min >> 17) + (q_max >> 17); /* < 2^15; q_max is 2^30 or more */
    const uint32_t difference = ((q_max - q_min) >> 17) + 1;
    if (q_max >> 1 > q_min) {
        return false;
    }
    for (int i = 0; i < job->count; i++) {
        uint32_t min, max;
        qtri_find_range(&min, &max, job->a[i].f);
        if (qtri_mul_u32(difference * difference, max - min) > sum * sum * limit_of(job, i)) {
            return false;
        }
    }
    return true;
}

/* Weights in Q30; false: of a triangle so thin that they step by more than 1/2 a pixel. */
static bool set_weights(qtri_large_job *job)
{
    const qtri_large_weights *w = &job->t.weights;
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

static uint32_t shifted(const qtri_large_attribute *a, int32_t x)
{
    return (uint32_t)((int32_t)((uint32_t)x << a->at_left) >> a->at_right);
}

/*
 * |f| < 2^29, |e| <= |d| < 2^29: |a| < 2^30 and |b| < 2^29 for r <= 1/3. Slopes are below 2^30: a
 * weight's share of F changes by the range of f times 1 + 4 r at most, by half of which a pixel
 * steps, and is_near() leaves r <= .16 where that range is 2^29.
 */
static void set_polynomial(qtri_large_attribute *a, const qtri_large_job *job,
                           const int32_t middle[3])
{
    qtri_large_quadratic *f = &a->along.quadratic;
    const int32_t x1 = (int32_t)job->weight_q30[0][0], x2 = (int32_t)job->weight_q30[1][0];
    const int32_t d1 = (int32_t)(a->f[1] - a->f[0]), d2 = (int32_t)(a->f[2] - a->f[0]);
    const int32_t e1 = mul_q30(d1, middle[0]), e2 = mul_q30(d2, middle[1]);
    const int32_t a1 = 4 * e1 - d1, a2 = 4 * e2 - d2;
    const int32_t b11 = 2 * (d1 - 2 * e1), b22 = 2 * (d2 - 2 * e2);
    const int32_t b12 = 4 * (d1 - e1 - e2 + mul_q30(d2 - d1, middle[2]));
    const int32_t slope1 = 2 * mul_q30(b11, x1) + mul_q30(b12, x2);
    const int32_t slope2 = 2 * mul_q30(b22, x2) + mul_q30(b12, x1);
    f->a1 = a1;
    f->a2 = a2;
    f->b11 = 2 * b11;
    f->b12 = 2 * b12;
    f->b22 = 2 * b22;
    f->slope = mul_q30(a1, x1) + mul_q30(a2, x2);
    f->slope1 = 2 * slope1;
    f->slope2 = 2 * slope2;
    f->curve = (mul_q30(slope1, x1) + mul_q30(slope2, x2)) / 2;
    a->at_left = (uint8_t)qtri_greatest32(a->up, 0);
    a->at_right = (uint8_t)qtri_greatest32(-a->up, 0);
}

/* Pieces start at multiples of 2^this pixels of a row: chords that are off by half of the bound,
   curve m^2 / 4; of packed colours by 1/4. */
static void set_length(qtri_large_job *job)
{
    const uint32_t limit = bound_of(job) * (job->rounds ? 1 : 2);
    uint32_t curve = 0;
    for (int i = job->first_color; i < job->count; i++) {
        curve |= qtri_magnitude32(job->a[i].along.quadratic.curve);
    }
    int32_t log2 = QTRI_LARGE_RUN_LOG2;
    while (log2 > 0 && curve > limit >> 2 * log2) {
        log2--;
    }
    job->quadratic_log2 = (uint8_t)log2;
}

bool qtri_large_set_quadratics(qtri_large_job *job)
{
    const uint32_t *q = job->q_at;
    if (job->t.pixels > PIXELS_MAX || qtri_large_has_levels(job) || !is_near(job)) {
        return false;
    }
    /* Colours where vertices are snapped to, so that they stay within those of the vertices. */
    qtri_large_use_weights(&job->t, job->t.is_true && job->first_color != 0);
    if (!set_weights(job)) {
        return false;
    }
    const int32_t middle[3] = {middle_of(q[0], q[1]), middle_of(q[0], q[2]), middle_of(q[1], q[2])};
    for (int i = 0; i < job->count; i++) {
        set_polynomial(&job->a[i], job, middle);
    }
    for (int i = 0; i < job->first_color; i++) {
        qtri_large_quadratic *f = &job->a[i].along.quadratic;
        f->bend = shifted(&job->a[i], 2 * f->curve);
    }
    set_length(job);
    job->is_bent = job->first_color != 0;
    job->is_curved = true;
    job->may_be_level = false;
    job->is_level = false;
    job->is_quadratic = true;
    return true;
}

/* Weights of a pixel: Q30, Q15, and products of these, Q15. */
typedef struct at_pixel {
    int32_t b1, b2, s1, s2, s11, s12, s22;
} at_pixel;

/* True positions may leave a weight outside of 0 to 1 by what a pixel's 1/512 changes it. */
static inline void set_pixel(at_pixel *b, const qtri_large_job *job, int32_t x)
{
    const uint32_t right = (uint32_t)(x - (job->t.corner_x[0] >> 8));
    const uint32_t down = (uint32_t)(job->t.y - (job->t.corner_y[0] >> 8));
    const uint32_t *w1 = job->weight_q30[0], *w2 = job->weight_q30[1];
    const int32_t most = ((int32_t)1 << 30) - 1;
    b->b1 = qtri_hold32((int32_t)(w1[0] * right + w1[1] * down + w1[2]), 0, most);
    b->b2 = qtri_hold32((int32_t)(w2[0] * right + w2[1] * down + w2[2]), 0, most);
    b->s1 = b->b1 >> 15;
    b->s2 = b->b2 >> 15;
    b->s11 = (b->s1 * b->s1) >> 15;
    b->s12 = (b->s1 * b->s2) >> 15;
    b->s22 = (b->s2 * b->s2) >> 15;
}

/* Products of Q30 lose two bits. */
static inline int32_t value_at(const qtri_large_attribute *a, const at_pixel *b)
{
    const qtri_large_quadratic *f = &a->along.quadratic;
    const uint32_t linear =
        (uint32_t)qtri_mul_high_s30(f->a1, b->b1) + (uint32_t)qtri_mul_high_s30(f->a2, b->b2);
    const uint32_t bent = (uint32_t)qtri_mul_s16(f->b11, b->s11) +
                          (uint32_t)qtri_mul_s16(f->b12, b->s12) +
                          (uint32_t)qtri_mul_s16(f->b22, b->s22);
    return (int32_t)(a->f[0] + 4 * linear + bent);
}

/* The slope there, and n times half of what it grows by. */
static inline int32_t slope_at(const qtri_large_attribute *a, const at_pixel *b, int32_t n)
{
    const qtri_large_quadratic *f = &a->along.quadratic;
    return (int32_t)((uint32_t)f->slope + (uint32_t)qtri_mul_s16(f->slope1, b->s1) +
                     (uint32_t)qtri_mul_s16(f->slope2, b->s2) + (uint32_t)f->curve * (uint32_t)n);
}

/* Colours of a piece of n pixels, along chords. */
static inline void set_chords(qtri_large_job *job, const at_pixel *b, int32_t n)
{
    uint32_t at[QTRI_LARGE_ATTRIBUTES], step[QTRI_LARGE_ATTRIBUTES];
    for (int i = job->first_color; i < job->count; i++) {
        const qtri_large_attribute *a = &job->a[i];
        at[i] = (uint32_t)(value_at(a, b) >> QTRI_LARGE_COLOR_UP) + a->start;
        step[i] = (uint32_t)(slope_at(a, b, n) >> QTRI_LARGE_COLOR_UP);
        qtri_large_clamp_chord(a, &at[i], &step[i], n);
    }
    qtri_large_pack(job, &job->piece[0], at, step, n);
}

int32_t qtri_large_quadratic_piece(qtri_large_job *job)
{
    qtri_large *t = &job->t;
    qtri_large_piece *piece = &job->piece[0];
    at_pixel b;
    if (t->is_new) { /* pieces are counted from the row's left end, which no scissor moves */
        t->x = t->row_left + ((t->x0 - t->row_left) >> job->quadratic_log2 << job->quadratic_log2);
        t->is_new = false;
    }
    const int32_t x = t->x;
    const int32_t n = qtri_least32((int32_t)1 << job->quadratic_log2, t->row_right - x);
    set_pixel(&b, job, x);
    if (job->first_color != 0) {
        const qtri_large_attribute *u = &job->a[0], *v = &job->a[1];
        piece->u = shifted(u, value_at(u, &b));
        piece->u_step = shifted(u, slope_at(u, &b, 1));
        piece->u_bend = u->along.quadratic.bend;
        piece->v = shifted(v, value_at(v, &b));
        piece->v_step = shifted(v, slope_at(v, &b, 1));
        piece->v_bend = v->along.quadratic.bend;
    }
    if (job->first_color != job->count) {
        set_chords(job, &b, n);
    }
    piece->count = n;
    if (x < t->x0 || x + n > t->x1) {
        qtri_large_clip(job, piece, x);
    }
    t->x = x + n;
    return 1;
}
