/* SPDX-License-Identifier: MIT */
/* Attributes of a large triangle: their values at the vertices, and their planes. */
#include "large_setup.h"

/* Weights ----------------------------------------------------------------------------------------
 *
 * An attribute is f0 + (f1 - f0) b1 + (f2 - f0) b2, with the weights b1 and b2 of vertices 1 and 2.
 * These are linear on the screen, and found once a triangle; a plane is three sums of two products.
 *
 * Pixels are covered by triangles whose vertices are snapped to 1/256 pixel, but an attribute
 * belongs to a vertex's true position, up to half a step away: on a floor that runs to the horizon
 * that is many texels. So weights are those of the true positions, where these are known.
 */

/*
 * 2^126 / x within 2^-58 of itself, for x in [2^63, 2^64): at most 2^63. With r = 2^62 / (x 2^-32)
 * rounded down, 2^94 - r x is between -2^63 and 2^64; a Newton step adds its 2^-94 part.
 */
static uint64_t reciprocal64(uint64_t x)
{
    const uint32_t high = (uint32_t)(x >> 32);
    const uint32_t r = (uint32_t)qtri_reciprocal_below(high);
    const int64_t rest =
        qtri_wrap64(((uint64_t)1 << 62) - qtri_mul_u32(high, r) - qtri_mul_high32((uint32_t)x, r));
    return ((uint64_t)r << 32) + (uint64_t)(qtri_mul_s32((int32_t)(rest >> 1), (int32_t)r) >> 29);
}

/* b times a distance of less than 130 2^-8, 2^-24 pixel. */
QTRI_NOINLINE static int64_t along(int64_t b, int32_t distance)
{
    return (b >> 8) * (distance >> 16) + (b >> 24) * (distance & 0xFFFF);
}

QTRI_NOINLINE static int64_t cross(const int32_t a[2], const int32_t b[2])
{
    return qtri_mul_s32(a[0], b[1]) - qtri_mul_s32(a[1], b[0]);
}

/* d 2^up r 2^-64, |d| 2^up < 2^62. */
QTRI_NOINLINE static int64_t scaled(int64_t d, int32_t up, uint64_t r, bool is_negative)
{
    const int64_t size = (int64_t)qtri_mul_high64(qtri_magnitude64(d) << up, r);
    return (d < 0) != is_negative ? -size : size;
}

/*
 * A step of a weight is a difference D, 2^-24 pixel, by the area: D 2^6 / A, with A 2^14 times the
 * area. With r = 2^126 / (A 2^zeros) and D 2^up below 2^62 that is
 *
 *     D r 2^(zeros - 120) = (D 2^up r 2^-64) 2^-(56 + up - zeros)
 *
 * and what is in parentheses is below 2^61. False, with true positions: they are so close to a
 * line, 1/8 of a pixel, that corrections would be more than 2^-5 of what attributes vary by.
 */
static bool find_weights(qtri_large *t, bool true_positions)
{
    qtri_large_weights *w = &t->weights;
    const qtri_large_vertex *v = t->in->v;
    const int32_t rest_mask = true_positions ? -1 : 0;
    const int32_t rest_x = v[0].rest[0] & rest_mask, rest_y = v[0].rest[1] & rest_mask;
    /* 1/256 pixel, and what is true of positions besides, 2^-24 */
    int32_t snapped[2][2], rest[2][2];
    uint64_t all = 0;
    for (int i = 0; i < 2; i++) {
        snapped[i][0] = t->corner_x[i + 1] - t->corner_x[0];
        snapped[i][1] = t->corner_y[i + 1] - t->corner_y[0];
        rest[i][0] = (v[i + 1].rest[0] & rest_mask) - rest_x;
        rest[i][1] = (v[i + 1].rest[1] & rest_mask) - rest_y;
        for (int k = 0; k < 2; k++) {
            const int64_t d = (int64_t)snapped[i][k] * 65536 + rest[i][k];
            w->b[1 - i][1 - k] = d;
            all |= qtri_magnitude64(d);
        }
    }
    /* 2^14 times the area; that of snapped vertices is exact. */
    const int64_t once = cross(snapped[0], rest[1]) + cross(rest[0], snapped[1]);
    const int64_t area = t->area * 16384 + (once >> 2) + (cross(rest[0], rest[1]) >> 18);
    const uint64_t size = qtri_magnitude64(area);
    if (true_positions && ((area ^ t->area) < 0 || size < all << 3)) {
        return false;
    }
    const int32_t zeros = qtri_clz64(size), up = qtri_clz64(all) - 2; /* neither is 0 */
    const uint64_t r = reciprocal64(size << zeros);
    const int32_t x = (128 - (t->corner_x[0] & 255)) * 65536 - rest_x;
    const int32_t y = (128 - (t->corner_y[0] & 255)) * 65536 - rest_y;
    for (int i = 0; i < 2; i++) {
        int64_t *b = w->b[1 - i];
        b[0] = scaled(b[0], up, r, (area < 0) != (i == 0));
        b[1] = scaled(b[1], up, r, (area < 0) == (i == 0));
        b[2] = along(b[0], x) + along(b[1], y);
    }
    w->fraction = 56 + up - zeros;
    w->of_true_positions = true_positions;
    return true;
}

void qtri_large_use_weights(qtri_large *t, bool true_positions)
{
    if (t->weights.of_true_positions != true_positions) {
        (void)find_weights(t, true_positions); /* true ones were found before */
    }
}

void qtri_large_set_weights(qtri_large *t)
{
    int32_t any = 0;
    for (int i = 0; i < 3; i++) {
        any |= t->in->v[i].rest[0] | t->in->v[i].rest[1];
    }
    t->has_true_positions = any != 0 && find_weights(t, true);
    if (!t->has_true_positions) {
        (void)find_weights(t, false);
    }
}

/* Planes --------------------------------------------------------------------------------------- */

/* A difference of an attribute, 2^-8, times a weight, 2^-32. */
static int64_t product(int64_t f_q8, int64_t b)
{
    const int32_t whole = (int32_t)(f_q8 >> 8), high = (int32_t)(b >> 32);
    return qtri_mul_s32(whole, high) + qtri_mul_high_s31(whole, (uint32_t)b >> 1) * (int64_t)2 +
           (high >> 8) * (int32_t)(f_q8 & 255);
}

/*
 * Products are below 2^60. A step is off by 2^-32 of a unit, or, of triangles that are thinner than
 * a pixel by 2^n, by 2^(n - 32): all sums wrap, and at the pixels that the triangle covers they
 * lie between the vertices' values.
 */
static void find_steps(uint64_t value[3], const qtri_large *t, const int64_t f_q8[3], int32_t up)
{
    const qtri_large_weights *w = &t->weights;
    const int32_t down = w->fraction - 64 - up;
    for (int k = 0; k < 3; k++) {
        const int64_t sum =
            product(f_q8[1] - f_q8[0], w->b[0][k]) + product(f_q8[2] - f_q8[0], w->b[1][k]);
        value[k] = down >= 0 ? (uint64_t)(sum >> down) : (uint64_t)sum << -down;
    }
    value[2] += (uint64_t)f_q8[0] << (24 + up);
}

/* From the pixel of vertex 0, which value[2] is at, to a column and a row. */
static uint64_t value_at(const uint64_t value[3], const qtri_large *t, int32_t x, int32_t y)
{
    return value[2] + value[0] * (uint64_t)(int64_t)(x - (t->corner_x[0] >> 8)) +
           value[1] * (uint64_t)(int64_t)(y - (t->corner_y[0] >> 8));
}

/* The plane of 0 <= f < 2^39, in 2^-8; times 2^up. */
static void plane_init(qtri_large_plane *p, const qtri_large *t, const int64_t f_q8[3], int32_t up)
{
    uint64_t value[3];
    find_steps(value, t, f_q8, up);
    p->dx = value[0];
    p->dy = value[1];
    p->row = value_at(value, t, 0, t->plane_y);
}

void qtri_large_plane_of(qtri_large_plane *p, const qtri_large *t, const uint32_t f[3])
{
    const int64_t f_q8[3] = {(int64_t)f[0] * 256, (int64_t)f[1] * 256, (int64_t)f[2] * 256};
    plane_init(p, t, f_q8, 0);
}

/* Planes have 48 bits of whole values here, so that those of 32 bits may be out of range. */
void qtri_large_ramp_init(qtri_large_ramp *ramp, const qtri_large *t, const int64_t f_q8[3],
                          int32_t down)
{
    const int64_t half = (int64_t)1 << (down + 15);
    const int32_t x = qtri_hold32(t->corner_x[0] >> 8, 0, t->frame_width - 1);
    const int32_t y = qtri_hold32(t->corner_y[0] >> 8, 0, t->state->surface->height - 1);
    uint64_t value[3];
    find_steps(value, t, f_q8, -16);
    ramp->dx = (qtri_wrap64(value[0]) + half) >> (down + 16);
    ramp->dy = (qtri_wrap64(value[1]) + half) >> (down + 16);
    ramp->at = ((qtri_wrap64(value_at(value, t, x, y)) + half) >> (down + 16)) - ramp->dx * x -
               ramp->dy * y;
}

/* Texture coordinates -------------------------------------------------------------------------- */

enum {
    AFFINE_TEXEL_LOG2 = -8, /* linear coordinates may stray by 2^this of a texel */
    AFFINE_COLOR_LOG2 = 13  /* and colours, 8.16, by 2^this */
};

static int64_t clamp_q32(int64_t coordinate)
{
    const int64_t limit = (int64_t)1 << 48;
    return coordinate < -limit ? -limit : (coordinate > limit ? limit : coordinate);
}

qtri_large_zone qtri_large_zone_of(const qtri_large_job *job, int i, uint32_t level)
{
    const qtri_draw_state *state = job->t.state;
    const qtri_options *o = job->t.options;
    const qtri_large_axis *axis = &job->axis[i];
    const uint32_t side_log2 = i == 0 ? state->width_log2 : state->height_log2;
    const uint32_t down = qtri_large_level_down(job, i, level);
    const uint32_t texel = (uint32_t)1 << (axis->texel_shift + down);
    const uint32_t texels = (uint32_t)1 << (axis->texel_shift + side_log2);
    qtri_large_zone z;
    if (o->bilinear) { /* which count from centres before there are levels */
        z.least = axis->texel_zero + (qtri_large_has_levels(job) ? texel >> 1 : 0);
        z.size = texels - texel;
        z.start = 0;
    } else {
        z.start = (texel >> 4) + 1;
        z.least = axis->texel_zero + z.start;
        z.size = texels - 2 * z.start;
    }
    qtri_set_shifts(&z.shift_left, &z.shift_right,
                    axis->walk_shift - (i == 0 || o->large_texture ? 0 : (int32_t)(level + down)));
    return z;
}

/* Whether a clamped coordinate stays in its zone, that of the last level. */
static bool is_inside(const qtri_large_job *job, int i)
{
    const uint32_t *f = job->a[i].f;
    const qtri_large_zone z =
        qtri_large_zone_of(job, i, qtri_large_has_levels(job) ? job->t.state->last_level : 0);
    return f[0] - z.least <= z.size && f[1] - z.least <= z.size && f[2] - z.least <= z.size;
}

/* One coordinate: whole repeats below the least are dropped, the rest is brought to 29 bits; of
   what is clamped, with the place of the first texel. */
static void set_axis(qtri_large_job *job, int i, const int64_t coordinate[3])
{
    const qtri_draw_state *state = job->t.state;
    const qtri_options *o = job->t.options;
    qtri_large_attribute *a = &job->a[i];
    qtri_large_axis *axis = &job->axis[i];
    const int32_t side_log2 = i == 0 ? state->width_log2 : state->height_log2;
    const bool is_clamped = (state->traits >> i & 1) != 0;
    const bool is_one_wide = i == 0 && (state->traits & QTRI_ONE_WIDE) != 0;
    int64_t at[3];
    uint64_t all;
    int32_t base = INT32_MAX; /* |base| <= 2^16 */
    for (int k = 0; k < 3; k++) {
        at[k] = clamp_q32(coordinate[k]) - (o->bilinear && !qtri_large_has_levels(job)
                                                ? (int64_t)1 << (31 - side_log2)
                                                : 0); /* from texels' centres */
        base = qtri_least32(base, (int32_t)(at[k] >> 32));
    }
    all = is_clamped ? (uint64_t)qtri_magnitude32(base) << 32 : 0;
    for (int k = 0; k < 3; k++) {
        at[k] -= base * ((int64_t)1 << 32);
        all |= (uint64_t)at[k];
    }
    const int32_t up = i == 0 || o->large_texture ? 0 : state->width_log2 + state->height_log2 - 16;
    const int32_t least = is_clamped ? qtri_greatest32(3, -up) : 3;
    const int32_t down = qtri_greatest32(35 - qtri_clz64(all), least); /* <= 21 */
    /* What lies on a texel's edge, give or take an error, goes up: 2^-16 of a texel. */
    const int32_t more = qtri_greatest32(65536 >> side_log2, 4 << down);
    for (int k = 0; k < 3; k++) {
        a->f[k] = is_one_wide ? 0 : (uint32_t)((at[k] + more) >> down);
    }
    a->start = 0;
    axis->texel_shift = (uint8_t)(32 - down - side_log2);
    axis->texel_zero = 0u - ((uint32_t)base << (32 - down));
    axis->walk_shift = (int8_t)(up + down);
    axis->needs_clamp = is_clamped && !is_inside(job, i);
    a->piece_shift = axis->needs_clamp ? (int8_t)0 : axis->walk_shift;
    if (axis->needs_clamp) {
        axis->zone = qtri_large_zone_of(job, i, 0);
        job->needs_clamp = true;
    }
}

void qtri_large_reset_attributes(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    job->count = 0;
    job->run_log2 = 14;
    job->packing = NULL;
    job->rounds = false;
    job->needs_clamp = false;
    job->second_waits = false;
    job->piece[2].count = 0;
    job->first_color = 0;
    job->alpha = QTRI_LARGE_ATTRIBUTES;
}

void qtri_large_set_texture(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    const qtri_large_vertex *v = job->t.in->v;
    const int64_t u[3] = {v[0].u_q32, v[1].u_q32, v[2].u_q32};
    const int64_t w[3] = {v[0].v_q32, v[1].v_q32, v[2].v_q32};
    set_axis(job, 0, u);
    set_axis(job, 1, w);
    job->count = 2;
    job->first_color = 2;
}

/* Colours ----------------------------------------------------------------------------------------
 */

/* An attribute from what it is at the vertices, 8.16. */
static void add_attribute(qtri_large_job *job, const uint32_t value[3], uint32_t half)
{
    qtri_large_attribute *a = &job->a[job->count++];
    uint32_t least, most;
    qtri_find_range(&least, &most, value);
    for (int k = 0; k < 3; k++) {
        a->f[k] = (value[k] - least) << QTRI_LARGE_COLOR_UP;
    }
    a->range = most - least;
    a->start = least + half;
    a->piece_shift = -QTRI_LARGE_COLOR_UP;
}

void qtri_large_set_colors(qtri_large *t, const qtri_large_packing *packing, uint32_t half)
{
    qtri_large_job *job = qtri_large_job_of(t);
    uint32_t value[3][3];
    for (int k = 0; k < 3; k++) {
        const qtri_large_vertex *v = &t->in->v[k];
        uint32_t c[3] = {v->light_q15 << 9, 0, 0};
        if (packing->channels != NULL) {
            for (int i = 0; i < 3; i++) {
                c[i] = (uint32_t)qtri_hold32(v->color_8p16[i], 0, 255 * 65536);
            }
            packing->channels(c, c);
        }
        for (int i = 0; i < 3; i++) {
            value[i][k] = c[i];
        }
    }
    for (int i = 0; i < packing->count; i++) {
        add_attribute(job, value[i], half);
    }
    job->packing = packing;
    job->rounds = packing->rounds;
    job->run_log2 = packing->run_log2;
}

void qtri_large_set_alpha(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    const qtri_large_vertex *v = job->t.in->v;
    const uint32_t value[3] = {v[0].alpha_q16 << 8, v[1].alpha_q16 << 8, v[2].alpha_q16 << 8};
    job->alpha = job->count;
    add_attribute(job, value, (uint32_t)1 << 15);
}

/* Without perspective ------------------------------------------------------------------------- */

static void set_plane(qtri_large_job *job, int i, const uint32_t f[3])
{
    /* Colours are where vertices are snapped to, so that they stay within those of the vertices. */
    qtri_large_use_weights(&job->t, job->t.has_true_positions && i < job->first_color);
    qtri_large_plane_of(&job->a[i].plane, &job->t, f);
}

static void set_linear_planes(qtri_large_job *job)
{
    job->is_curved = false;
    job->q.row = 0;
    job->q.dy = 0;
    job->row_is_linear = true;
    if (job->rounds) {
        return; /* they are linear by runs */
    }
    for (int i = 0; i < job->count; i++) {
        qtri_large_attribute *a = &job->a[i];
        const int32_t down = 32 - a->piece_shift; /* 11..52 */
        set_plane(job, i, a->f);
        a->step =
            (uint32_t)((uint64_t)(qtri_wrap64(a->plane.dx + ((uint64_t)1 << (down - 1))) >> down));
    }
}

/* With perspective ----------------------------------------------------------------------------- */

void qtri_large_align_q(int64_t q_q8[3], const qtri_large_vertex v[3])
{
    const int32_t most = qtri_greatest32(v[0].inv_w_exponent,
                                         qtri_greatest32(v[1].inv_w_exponent, v[2].inv_w_exponent));
    for (int k = 0; k < 3; k++) {
        const uint32_t down = (uint32_t)most - (uint32_t)v[k].inv_w_exponent;
        q_q8[k] = down <= 29 ? (int64_t)v[k].inv_w_q31 << 8 >> down : 256;
    }
}

/* Of true positions less 1/32: pixels may be beyond these. */
static void set_q(qtri_large_job *job, int64_t q_q8[3])
{
    qtri_large_align_q(q_q8, job->t.in->v);
    for (int k = 0; k < 3; k++) {
        q_q8[k] -= job->t.has_true_positions ? q_q8[k] >> 5 : 0;
        job->vertex_q[k] = (uint32_t)(q_q8[k] >> 8);
    }
}

/*
 * Whether linear interpolation of an attribute strays by 2^tolerance or more. With weights b_i,
 * sum 1, and Q = sum b_i q_i the true value has weights b_i q_i / Q: off by at most
 * (range / 2) sum b_i |q_i - Q| / Q, and a mean distance from the mean is at most half the range:
 * range (q_max - q_min) / (4 q_min).
 */
static bool strays(const qtri_large_job *job, const qtri_large_attribute *a, int32_t tolerance_log2)
{
    uint32_t min, max, q_min, q_max;
    qtri_find_range(&min, &max, a->f);
    qtri_find_range(&q_min, &q_max, job->vertex_q);
    return max != min && (tolerance_log2 < 0 ||
                          qtri_mul_u32(max - min, q_max - q_min) >> (tolerance_log2 + 2) >= q_min);
}

static bool needs_perspective(const qtri_large_job *job)
{
    for (int i = 0; i < job->count; i++) {
        const int32_t tolerance = i < job->first_color
                                      ? job->axis[i].texel_shift + AFFINE_TEXEL_LOG2
                                      : AFFINE_COLOR_LOG2 + QTRI_LARGE_COLOR_UP;
        if (strays(job, &job->a[i], tolerance)) {
            return true;
        }
    }
    return false;
}

/* The magnitude of 1/w, at most, in one corner of what is drawn; UINT64_MAX: unknown. */
static uint64_t q_bound(const qtri_large_job *job)
{
    const qtri_surface *surface = job->t.state->surface;
    const int64_t dx = qtri_wrap64(job->q.dx);
    const int64_t dy = qtri_wrap64(job->q.dy);
    const int32_t x_end = job->t.frame_width - 1 + QTRI_LARGE_CHUNK;
    const int32_t x = qtri_hold32((dx < 0 ? job->t.x_least : job->t.x_least + job->t.width) >> 8,
                                  -QTRI_LARGE_CHUNK, x_end);
    const int32_t y = qtri_hold32((dy < 0 ? job->t.y_least : job->t.y_least + job->t.height) >> 8,
                                  0, surface->height - 1);
    const uint64_t columns = (uint64_t)(uint32_t)(job->t.width >> 8) + 1;
    const uint64_t rows = (uint64_t)(uint32_t)(job->t.height >> 8) + 1;
    if ((qtri_magnitude64(dx) >> 32) * columns + (qtri_magnitude64(dy) >> 32) * rows >= (uint64_t)1
                                                                                            << 31) {
        return UINT64_MAX; /* of steep planes that corner may be out of reach */
    }
    const int64_t value = qtri_wrap64(job->q.row + job->q.dx * (uint64_t)(int64_t)x +
                                      job->q.dy * (uint64_t)(int64_t)(y - job->t.plane_y));
    return value <= 0 ? UINT64_MAX : (uint64_t)value | qtri_magnitude64(dx) | qtri_magnitude64(dy);
}

/*
 * By how many bits planes may be multiplied so that q is 2^31 or less wherever the triangle meets
 * the frame, and QTRI_LARGE_CHUNK pixels beyond at both sides; so must be its slopes. Neither
 * scissor nor band is asked.
 */
static int32_t spare_bits(const qtri_large_job *job)
{
    const uint64_t bound = q_bound(job);
    return bound == UINT64_MAX ? 0 : qtri_hold32(qtri_clz64(bound) - 1, 0, 14);
}

/* The plane of f q / 2^32. */
static void set_projected(qtri_large_job *job, qtri_large_attribute *a, const int64_t q_q8[3])
{
    int64_t product[3];
    for (int k = 0; k < 3; k++) {
        const uint64_t whole = qtri_mul_u32(a->f[k], job->vertex_q[k]);
        const uint64_t part = qtri_mul_u32(a->f[k], (uint32_t)q_q8[k] & 0xFF) >> 8;
        product[k] = (int64_t)((whole + part + 0x800000u) >> 24);
    }
    plane_init(&a->plane, &job->t, product, job->q_headroom);
}

bool qtri_large_set_linear(qtri_large_job *job, int64_t q_q8[3])
{
    set_q(job, q_q8);
    if (!job->t.state->is_linear && needs_perspective(job)) {
        return false;
    }
    set_linear_planes(job);
    return true;
}

void qtri_large_set_curved(qtri_large_job *job, const int64_t q_q8[3])
{
    plane_init(&job->q, &job->t, q_q8, 0);
    job->q_headroom = (uint8_t)spare_bits(job);
    plane_init(&job->q, &job->t, q_q8, job->q_headroom);
    for (int i = 0; i < job->count; i++) {
        set_projected(job, &job->a[i], q_q8);
    }
    job->is_curved = true;
    job->row_is_linear = false;
    job->q_zeros = 0;
}
