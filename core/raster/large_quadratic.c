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
 * Weights are linear on the screen, so F is of second order in pixels too, and the sum of its
 * products is right modulo 2^32. Pieces are chords of it; mostly one serves the row. Without it a
 * lit torus of 96 triangles (S12) takes 17 to 24 % more, textured (S13a) 7 to 9 %.
 */
#include "large_setup.h"

enum { PIXELS_MAX = 1024 /* of a side: weights are off by 2^-20 */ };

/* a b / 2^30, to nearest, |a| <= 2^31, |b| <= 2^30. */
QTRI_NOINLINE static int32_t mul_q30(int32_t a, int32_t b)
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

/* How large r^2 range may be for attribute i: F is off by less than 3/2 of the bound of colours
   (.09 to .38 of a step), 3/4 of packed ones, whose steps are rounded; by 2^-5 texel else. */
static uint64_t limit_of(const qtri_large_job *job, int i)
{
    return i < job->first_color ? (uint64_t)1 << job->axis[i].shift >> 3
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

/* Weights in Q30, at vertex 0's pixel the last; false: they step by more than 1/2 a pixel. */
static bool set_weights(int32_t weight_q30[2][3], const qtri_large_weights *w)
{
    const int32_t down = w->fraction - 30; /* 4..45 of sides of PIXELS_MAX at most */
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 3; k++) {
            const int64_t b = w->b[i][k] >> down;
            if (qtri_magnitude64(b) > (uint64_t)1 << 29) {
                return false;
            }
            weight_q30[i][k] = (int32_t)b;
        }
    }
    return true;
}

static uint32_t shifted(const qtri_large_attribute *a, int32_t x)
{
    return (uint32_t)((int32_t)((uint32_t)x << a->at_left) >> a->at_right);
}

/* a x + b y of Q30 with `more` bits, and whether 31 bits hold it. */
QTRI_NOINLINE static bool set_bend(int32_t *out, int32_t a, int32_t x, int32_t b, int32_t y,
                                   int32_t more)
{
    const int64_t bend = (qtri_mul_s32(a, x) + qtri_mul_s32(b, y)) >> (30 - more);
    *out = (int32_t)bend;
    return qtri_magnitude64(bend) < (uint64_t)1 << 30;
}

/*
 * In pixels from vertex 0's, with b1 = c1 + x1 X + y1 Y and b2 = c2 + x2 X + y2 Y. |f| < 2^29, |e|
 * <= |d| < 2^29: |a| < 2^30 and |b| < 2^29 for r <= 1/3. Steps are below 2^30: a weight's share of
 * F changes by the range of f times 1 + 4 r at most, by half of which a pixel steps, and is_near()
 * leaves r <= .16 where that range is 2^29. False: products of second order leave 32 bits.
 */
static bool set_polynomial(qtri_large_attribute *a, const qtri_large_job *job,
                           int32_t weight_q30[2][3], const int32_t middle[3])
{
    const int32_t more = job->quadratic_more;
    qtri_large_quadratic *f = &a->along.quadratic;
    const int32_t x1 = weight_q30[0][0], y1 = weight_q30[0][1], c1 = weight_q30[0][2];
    const int32_t x2 = weight_q30[1][0], y2 = weight_q30[1][1], c2 = weight_q30[1][2];
    const int32_t d1 = (int32_t)(a->f[1] - a->f[0]), d2 = (int32_t)(a->f[2] - a->f[0]);
    const int32_t e1 = mul_q30(d1, middle[0]), e2 = mul_q30(d2, middle[1]);
    const int32_t a1 = 4 * e1 - d1, a2 = 4 * e2 - d2;
    const int32_t b11 = 2 * (d1 - 2 * e1), b22 = 2 * (d2 - 2 * e2);
    const int32_t b12 = 4 * (d1 - e1 - e2 + mul_q30(d2 - d1, middle[2]));
    const int32_t g1 = a1 + 2 * mul_q30(b11, c1) + mul_q30(b12, c2);
    const int32_t g2 = a2 + 2 * mul_q30(b22, c2) + mul_q30(b12, c1);
    int32_t right1, right2, down1, down2; /* what dF/db1 and dF/db2 change by a pixel */
    f->at = a->f[0] + (uint32_t)(mul_q30(a1 / 2 + g1 / 2, c1) + mul_q30(a2 / 2 + g2 / 2, c2));
    f->right = mul_q30(g1, x1) + mul_q30(g2, x2);
    f->down = mul_q30(g1, y1) + mul_q30(g2, y2);
    if (!set_bend(&right1, 2 * b11, x1, b12, x2, more) ||
        !set_bend(&right2, 2 * b22, x2, b12, x1, more) ||
        !set_bend(&down1, 2 * b11, y1, b12, y2, more) ||
        !set_bend(&down2, 2 * b22, y2, b12, y1, more)) {
        return false;
    }
    f->right_right = (mul_q30(right1, x1) + mul_q30(right2, x2)) / 2;
    f->right_down = mul_q30(right1, y1) + mul_q30(right2, y2);
    f->down_down = (mul_q30(down1, y1) + mul_q30(down2, y2)) / 2;
    a->at_left = (uint8_t)qtri_greatest32(a->up, 0);
    a->at_right = (uint8_t)qtri_greatest32(-a->up, 0);
    f->bend = shifted(a, 2 * f->right_right >> more);
    const uint32_t most = qtri_magnitude32(f->right_right) | qtri_magnitude32(f->right_down) |
                          qtri_magnitude32(f->down_down);
    return more == 0 || qtri_mul_u32(most, (uint32_t)job->t.pixels) < (uint64_t)1 << 29;
}

/* Chords of n pixels whose middles are off by 7/16 of the bound, curve n^2 / 8; of packed colours
   by 1/4. */
static void set_length(qtri_large_job *job)
{
    const uint32_t limit = bound_of(job) * (job->rounds ? 4 : 7) / 2;
    uint32_t curve = 1;
    for (int i = job->first_color; i < job->count; i++) {
        const uint32_t own =
            qtri_magnitude32(job->a[i].along.quadratic.right_right) >> job->quadratic_more;
        curve = own > curve ? own : curve;
    }
    uint32_t n = QTRI_LARGE_RUN;
    while (n > 1 && n * n > limit / curve) {
        n--;
    }
    job->quadratic_length = (uint8_t)n;
}

bool qtri_large_is_quadratic(const qtri_large_job *job)
{
    return job->t.pixels <= PIXELS_MAX && !qtri_large_has_levels(job) && is_near(job);
}

bool qtri_large_set_quadratics(qtri_large_job *job)
{
    const uint32_t *q = job->q_at;
    /* Of sides below 2^n, 2 n - 14: F is off by less than 2^16 for what coefficients are. */
    const int32_t more = 50 - 2 * qtri_clz32((uint32_t)job->t.pixels);
    job->quadratic_more = (uint8_t)qtri_greatest32(more, 0);
    int32_t weight_q30[2][3];
    if (!set_weights(weight_q30, &job->t.weights)) {
        return false;
    }
    const int32_t middle[3] = {middle_of(q[0], q[1]), middle_of(q[0], q[2]), middle_of(q[1], q[2])};
    for (int i = 0; i < job->count; i++) {
        if (!set_polynomial(&job->a[i], job, weight_q30, middle)) {
            return false;
        }
    }
    set_length(job);
    job->is_bent = job->first_color != 0;
    job->is_curved = true;
    job->may_be_level = false;
    job->is_quadratic = true;
    return true;
}

static inline uint32_t times(int32_t a, int32_t n, int32_t more)
{
    return (uint32_t)((int32_t)((uint32_t)a * (uint32_t)n) >> more);
}

/* F at a pixel, and its slope along the n pixels from there. Products and sums wrap, F does not. */
static inline int32_t value_at(const qtri_large_job *job, const qtri_large_attribute *a,
                               int32_t right, int32_t down, int32_t n, uint32_t *slope)
{
    const qtri_large_quadratic *f = &a->along.quadratic;
    const int32_t more = job->quadratic_more;
    const uint32_t step = (uint32_t)f->right + times(f->right_down, down, more);
    const uint32_t row = (uint32_t)f->down + times(f->down_down, down, more);
    const uint32_t along = step + times(f->right_right, right, more);
    *slope = step + times(f->right_right, 2 * right + n, more);
    return (int32_t)(f->at + row * (uint32_t)down + along * (uint32_t)right);
}

/* Colours of a piece of n pixels, along chords. Pixel k of one through both ends is right_right
   k (n - k) too high: half of the most of that, at n / 2, is taken off. */
static inline void set_chords(qtri_large_job *job, int32_t right, int32_t down, int32_t n)
{
    uint32_t at[QTRI_LARGE_ATTRIBUTES], step[QTRI_LARGE_ATTRIBUTES];
    for (int i = job->first_color; i < job->count; i++) {
        const qtri_large_attribute *a = &job->a[i];
        uint32_t slope;
        const int32_t start = value_at(job, a, right, down, n, &slope);
        const int32_t value = start - (int32_t)times(a->along.quadratic.right_right, n * n >> 2,
                                                     job->quadratic_more + 1);
        at[i] = (uint32_t)(value >> QTRI_LARGE_COLOR_UP) + a->start;
        step[i] = (uint32_t)((int32_t)slope >> QTRI_LARGE_COLOR_UP);
        qtri_large_clamp_chord(a, &at[i], &step[i], n);
    }
    qtri_large_pack(job, &job->piece[0], at, step, n);
}

int32_t qtri_large_quadratic_piece(qtri_large_job *job)
{
    qtri_large *t = &job->t;
    qtri_large_piece *piece = &job->piece[0];
    if (t->is_new) { /* pieces are counted from the row's left end, which no scissor moves */
        t->x = t->x0 - (int32_t)((uint32_t)(t->x0 - t->row_left) % job->quadratic_length);
        t->is_new = false;
    }
    const int32_t x = t->x;
    const int32_t n = qtri_least32(job->quadratic_length, t->row_right - x);
    const int32_t right = x - (t->corner_x[0] >> 8), down = t->y - (t->corner_y[0] >> 8);
    if (job->first_color != 0) {
        const qtri_large_attribute *u = &job->a[0], *v = &job->a[1];
        uint32_t step;
        piece->u = shifted(u, value_at(job, u, right, down, 1, &step));
        piece->u_step = shifted(u, (int32_t)step);
        piece->u_bend = u->along.quadratic.bend;
        piece->v = shifted(v, value_at(job, v, right, down, 1, &step));
        piece->v_step = shifted(v, (int32_t)step);
        piece->v_bend = v->along.quadratic.bend;
    }
    if (job->first_color != job->count) {
        set_chords(job, right, down, n);
    }
    piece->count = n;
    piece->knot = n;
    if (x < t->x0 || x + n > t->x1) {
        qtri_large_clip(job, piece, x);
    }
    t->x = x + n;
    return 1;
}
