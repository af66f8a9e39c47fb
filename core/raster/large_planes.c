/* SPDX-License-Identifier: MIT */
/* Planes of what varies in a large triangle. */
#include "large_setup.h"

enum {
    AFFINE_TEXEL_LOG2 = -8, /* linear coordinates may stray by 2^this of a texel */
    AFFINE_COLOR_LOG2 = 13  /* and colours, 8.16, by 2^this */
};

static int64_t clamp_q32(int64_t coordinate)
{
    const int64_t limit = (int64_t)1 << 48;
    return coordinate < -limit ? -limit : (coordinate > limit ? limit : coordinate);
}

/* One coordinate: whole repeats below the least are dropped, the rest is brought to 29 bits. */
static void set_axis(qtri_large_job *job, int i, const int64_t coordinate[3], bool is_clamped)
{
    const qtri_draw_state *state = job->t.state;
    const qtri_options *o = job->options;
    qtri_large_attribute *a = &job->t.a[i];
    qtri_clamp_axis *axis = &job->t.axis[i];
    const int32_t side_log2 = i == 0 ? state->width_log2 : state->height_log2;
    int64_t at[3];
    uint64_t all = 0;
    int32_t base = INT32_MAX; /* |base| <= 2^16 */
    for (int k = 0; k < 3; k++) {
        at[k] = clamp_q32(coordinate[k]) - (o->bilinear && !qtri_large_has_levels(job)
                                                ? (int64_t)1 << (31 - side_log2)
                                                : 0); /* from texels' centres */
        base = qtri_least32(base, (int32_t)(at[k] >> 32));
    }
    for (int k = 0; k < 3; k++) {
        all |= (uint64_t)(at[k] - (int64_t)base * ((int64_t)1 << 32));
    }
    const int32_t down = qtri_greatest32(35 - qtri_clz64(all), 3); /* <= 21 */
    /* What lies on a texel's edge, give or take an error, goes up: 2^-16 of a texel. */
    const uint64_t texel_part = (uint64_t)65536 >> side_log2, least = (uint64_t)4 << down;
    const uint64_t up = texel_part > least ? texel_part : least;
    for (int k = 0; k < 3; k++) {
        const uint64_t offset = (uint64_t)(at[k] - (int64_t)base * ((int64_t)1 << 32));
        a->f[k] = (uint32_t)((offset + up) >> down);
    }
    a->start = 0;
    axis->shift = (uint8_t)(32 - down - side_log2);
    axis->mask = (uint16_t)(((uint32_t)1 << side_log2) - 1);
    axis->first = -base * ((int32_t)1 << side_log2);
    a->up = 0;
    if (!is_clamped) {
        a->up = (int8_t)(i == 0 || o->large_texture
                             ? down
                             : state->width_log2 + state->height_log2 - 16 + down);
    }
}

void qtri_large_set_texture(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    const qtri_large_vertex *v = job->v;
    const int64_t u[3] = {v[0].u_q32, v[1].u_q32, v[2].u_q32};
    const int64_t w[3] = {v[0].v_q32, v[1].v_q32, v[2].v_q32};
    set_axis(job, 0, u, job->options->wrap_u == QTRI_CLAMP);
    set_axis(job, 1, w, job->options->wrap_v == QTRI_CLAMP);
    job->count = 2;
    job->first_color = 2;
}

/* Without perspective ------------------------------------------------------------------------- */

/* f + low 2^-8, at the snapped vertices, in 2^-8. */
static void correct(int64_t there_q8[3], const qtri_large_job *job, const uint32_t f[3],
                    const uint32_t low[3])
{
    for (int k = 0; k < 3; k++) {
        there_q8[k] = (int64_t)f[k] * 256 + low[k];
        if (job->residual.is_on) {
            there_q8[k] -= qtri_residual_correction(&job->residual, f, k, 8);
        }
    }
}

/* The plane of what is so at the snapped vertices, times 2^up. */
static void set_plane(qtri_large_plane *p, const qtri_large_job *job, const qtri_divisor *divisor,
                      const int64_t there_q8[3], int32_t up)
{
    if (divisor != NULL) {
        qtri_fine_plane fine;
        qtri_fine_plane_init(&fine, &job->gradient, divisor, there_q8);
        p->dx = fine.dx << (2 + up);
        p->dy = fine.dy << (2 + up);
        p->row = (fine.origin + fine.dy * (uint64_t)(int64_t)job->plane_y) << (2 + up);
        return;
    }
    const uint32_t above = (uint32_t)1 << 30; /* corrected, f may be below 0 */
    const uint32_t there[3] = {(uint32_t)(there_q8[0] >> 8) + above,
                               (uint32_t)(there_q8[1] >> 8) + above,
                               (uint32_t)(there_q8[2] >> 8) + above};
    qtri_plane plane;
    qtri_plane_init(&plane, &job->gradient, there);
    plane.origin -= (uint64_t)above << 16;
    p->dx = plane.dx << 16;
    p->dy = plane.dy << 16;
    p->row = (plane.origin + plane.dy * (uint64_t)(int64_t)job->plane_y) << 16;
}

static void set_step(qtri_large_attribute *a)
{
    const int32_t down = 32 - a->up; /* 11..52 */
    a->step =
        (uint32_t)((uint64_t)(qtri_wrap64(a->plane.dx + ((uint64_t)1 << (down - 1))) >> down));
}

static void set_linear_planes(qtri_large_job *job, const qtri_divisor *divisor)
{
    static const uint32_t none[3] = {0, 0, 0};
    int64_t there[3];
    for (int i = 0; i < job->count; i++) {
        uint32_t *f = job->t.a[i].f;
        if (i < job->first_color) {
            correct(there, job, f, none);
        } else { /* the rest stays within the range of the vertices */
            (void)qtri_residual_apply(f, &job->residual, 0,
                                      (job->t.a[i].most - job->t.a[i].least)
                                          << QTRI_LARGE_COLOR_UP);
            for (int k = 0; k < 3; k++) {
                there[k] = (int64_t)f[k] * 256;
            }
        }
        if (job->packing != QTRI_PACK_565) { /* which has ramps */
            set_plane(&job->t.a[i].plane, job, divisor, there, 0);
            set_step(&job->t.a[i]);
        }
    }
    job->is_curved = false;
    job->q.row = 0;
    job->q.dy = 0;
    job->is_level = true;
    job->t.is_bent = false;
    qtri_large_set_run_steps(job);
}

/* With perspective ----------------------------------------------------------------------------- */

/* 1/w of the vertices with one exponent, 8 bits of fraction; not 0. */
static void set_q(qtri_large_job *job, uint32_t low[3])
{
    const qtri_large_vertex *v = job->v;
    const int32_t most = qtri_greatest32(v[0].inv_w_exponent,
                                         qtri_greatest32(v[1].inv_w_exponent, v[2].inv_w_exponent));
    for (int k = 0; k < 3; k++) {
        const uint32_t down = (uint32_t)most - (uint32_t)v[k].inv_w_exponent;
        uint64_t q_q8 = down <= 29 ? (uint64_t)v[k].inv_w_q31 << 8 >> down : 256;
        q_q8 -= job->residual.is_on ? q_q8 >> 5 : 0; /* corrections are up to 2^-5 of it */
        job->q_at[k] = (uint32_t)(q_q8 >> 8);
        low[k] = (uint32_t)(q_q8 & 0xFFu);
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
    qtri_find_range(&q_min, &q_max, job->q_at);
    return max != min && (tolerance_log2 < 0 ||
                          qtri_mul_u32(max - min, q_max - q_min) >> (tolerance_log2 + 2) >= q_min);
}

static bool needs_perspective(const qtri_large_job *job)
{
    for (int i = 0; i < job->count; i++) {
        const int32_t tolerance = i < job->first_color ? job->t.axis[i].shift + AFFINE_TEXEL_LOG2
                                                       : AFFINE_COLOR_LOG2 + QTRI_LARGE_COLOR_UP;
        if (strays(job, &job->t.a[i], tolerance)) {
            return true;
        }
    }
    return false;
}

/* The magnitude of a plane's value, at most, in one corner of what is drawn; UINT64_MAX: unknown.
 */
static uint64_t value_bound(const qtri_fine_plane *q, const qtri_large_job *job)
{
    const qtri_surface *surface = job->t.state->surface;
    const int64_t dx = qtri_wrap64(q->dx);
    const int64_t dy = qtri_wrap64(q->dy);
    const int32_t x_end = surface->width - 1 + QTRI_LARGE_CHUNK;
    const int32_t x = qtri_hold32((dx < 0 ? job->x_least : job->x_least + job->width) >> 8,
                                  -QTRI_LARGE_CHUNK, x_end);
    const int32_t y = qtri_hold32((dy < 0 ? job->y_least : job->y_least + job->height) >> 8, 0,
                                  surface->height - 1);
    const uint64_t columns = (uint64_t)(uint32_t)(job->width >> 8) + 1;
    const uint64_t rows = (uint64_t)(uint32_t)(job->height >> 8) + 1;
    if ((qtri_magnitude64(dx) >> 30) * columns + (qtri_magnitude64(dy) >> 30) * rows >= (uint64_t)1
                                                                                            << 32) {
        return UINT64_MAX; /* of steep planes that corner may be out of reach */
    }
    const int64_t value = qtri_wrap64(qtri_fine_plane_at(q, x, y));
    return value <= 0 ? UINT64_MAX : (uint64_t)value | qtri_magnitude64(dx) | qtri_magnitude64(dy);
}

/*
 * By how many bits planes may be multiplied so that q is 2^31 or less wherever the triangle meets
 * the frame, and QTRI_LARGE_CHUNK pixels beyond at both sides; so must be its slopes. Neither
 * scissor nor band is asked.
 */
static int32_t room_above(const qtri_fine_plane *q, const qtri_large_job *job)
{
    const uint64_t bound = value_bound(q, job);
    return bound == UINT64_MAX ? 0 : qtri_hold32(qtri_clz64(bound) - 3, 0, 14);
}

static int32_t set_q_plane(qtri_large_job *job, const qtri_divisor *divisor, const uint32_t low[3])
{
    int64_t there[3];
    int32_t up = 0;
    correct(there, job, job->q_at, low);
    if (divisor != NULL) {
        qtri_fine_plane fine;
        qtri_fine_plane_init(&fine, &job->gradient, divisor, there);
        up = room_above(&fine, job);
    }
    set_plane(&job->q, job, divisor, there, up);
    return up;
}

/* The vertices' f q / 2^32. */
static void set_projected(qtri_large_job *job, qtri_large_attribute *a, const qtri_divisor *divisor,
                          const uint32_t q_low[3], int32_t up)
{
    uint32_t f[3], low[3];
    int64_t there[3];
    for (int k = 0; k < 3; k++) {
        uint64_t product =
            qtri_mul_u32(a->f[k], job->q_at[k]) + (qtri_mul_u32(a->f[k], q_low[k]) >> 8);
        product += divisor != NULL ? 0x800000u : 0x80000000u;
        f[k] = (uint32_t)(product >> 32);
        low[k] = divisor != NULL ? (uint32_t)product >> 24 : 0;
    }
    correct(there, job, f, low);
    set_plane(&a->plane, job, divisor, there, up);
}

void qtri_large_set_planes(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    qtri_divisor area;
    uint32_t q_low[3];
    const bool is_fine = qtri_divisor_init(&area, &job->gradient, job->width + job->height);
    const qtri_divisor *divisor = is_fine ? &area : NULL;
    if (t->state->is_linear) {
        set_linear_planes(job, divisor);
        return;
    }
    set_q(job, q_low);
    if (!needs_perspective(job)) {
        set_linear_planes(job, divisor);
        return;
    }
    const int32_t up = set_q_plane(job, divisor, q_low);
    for (int i = 0; i < job->count; i++) {
        set_projected(job, &job->t.a[i], divisor, q_low, up);
    }
    job->q_up = (uint8_t)up;
    job->is_curved = true;
    job->is_level = false;
    job->t.is_bent = true;
    job->zeros = 0;
    qtri_large_set_lengths(job);
}
