/* SPDX-License-Identifier: MIT */
#include "large.h"

#include "descriptions.h"
#include "large_setup.h"

/* First row whose centre is at or below y, or column whose centre is at or right of x. */
static int32_t first_center(int32_t at_24p8)
{
    return (at_24p8 + 127) >> 8;
}

static void edge_init(qtri_dda *dda, const qtri_screen_point *a, const qtri_screen_point *b,
                      int32_t row)
{
    const int32_t length = b->y_24p8 - a->y_24p8;
    qtri_dda_init(dda, a->x_24p8, b->x_24p8 - a->x_24p8, length, row * 256 + 128 - a->y_24p8,
                  128 * length - 1);
}

bool qtri_large_edges_init(qtri_large_edges *e, const qtri_rect *bounds,
                           const qtri_screen_point *const vertex[3], bool clockwise)
{
    const qtri_screen_point *p[3] = {vertex[0], vertex[1], vertex[2]};
    for (int i = 0; i < 3; i++) { /* 0 1, 1 2, 0 1 */
        const int k = i & 1;
        if (p[k + 1]->y_24p8 < p[k]->y_24p8) {
            const qtri_screen_point *other = p[k];
            p[k] = p[k + 1];
            p[k + 1] = other;
            clockwise = !clockwise;
        }
    }
    const int32_t row = qtri_greatest32(first_center(p[0]->y_24p8), bounds->y0);
    e->row = row;
    e->end = qtri_least32(first_center(p[2]->y_24p8), bounds->y1);
    e->turn = qtri_least32(first_center(p[1]->y_24p8), e->end);
    if (row >= e->end) {
        return false;
    }
    e->lower_is_left = !clockwise;
    qtri_dda *const across = clockwise ? &e->right : &e->left;
    edge_init(clockwise ? &e->left : &e->right, p[0], p[2], row);
    if (row < e->turn) {
        edge_init(across, p[0], p[1], row);
        if (e->turn < e->end) {
            edge_init(&e->lower, p[1], p[2], e->turn);
        }
    } else {
        edge_init(across, p[1], p[2], row);
        e->turn = e->end;
    }
    return true;
}

void qtri_large_set_box(qtri_large_job *job, const qtri_screen_point *const p[3])
{
    int32_t x[2] = {p[0]->x_24p8, p[0]->x_24p8};
    int32_t y[2] = {p[0]->y_24p8, p[0]->y_24p8};
    for (int i = 1; i < 3; i++) {
        x[0] = qtri_least32(x[0], p[i]->x_24p8);
        x[1] = qtri_greatest32(x[1], p[i]->x_24p8);
        y[0] = qtri_least32(y[0], p[i]->y_24p8);
        y[1] = qtri_greatest32(y[1], p[i]->y_24p8);
    }
    job->x_least = x[0];
    job->y_least = y[0];
    job->width = x[1] - x[0];
    job->height = y[1] - y[0];
    job->pixels = (qtri_greatest32(job->width, job->height) >> 8) + 1;
}

static int32_t limit(int32_t at_24p8, int32_t pixels)
{
    return qtri_hold32(at_24p8, 0, pixels * 256 - 1) >> 8;
}

/* The anchor of ramps is vertex 0, or as near to it as the frame has a pixel. */
static void set_gradient(qtri_large_job *job, const qtri_screen_point *const p[3], int64_t area)
{
    qtri_gradient *g = &job->gradient;
    const qtri_surface *surface = job->t.state->surface;
    g->x_24p8 = p[0]->x_24p8;
    g->y_24p8 = p[0]->y_24p8;
    g->dx1 = p[1]->x_24p8 - g->x_24p8;
    g->dy1 = p[1]->y_24p8 - g->y_24p8;
    g->dx2 = p[2]->x_24p8 - g->x_24p8;
    g->dy2 = p[2]->y_24p8 - g->y_24p8;
    g->area = area;
    qtri_gradient_init(g, job->width + job->height);
    g->anchor_x = limit(g->x_24p8, qtri_least32(surface->width, QTRI_SURFACE_MAX));
    g->anchor_y = limit(g->y_24p8, qtri_least32(surface->height, QTRI_SURFACE_MAX));
    g->anchor_dx = g->anchor_x * 256 + 128 - g->x_24p8;
    g->anchor_dy = g->anchor_y * 256 + 128 - g->y_24p8;
}

/* A plane of halves, 2^-16 of them: whole units of depth. */
static int64_t whole_depth(uint64_t value)
{
    return (qtri_wrap64(value) + ((int64_t)1 << 14)) >> 15;
}

/*
 * A triangle that the near plane has clipped has two vertices at depth 0, and its true plane is a
 * little below 0 where they are snapped to. To clamp the three depths would bend the plane, so the
 * ramp is that of the true plane, and pixels whose depth leaves the range are drawn apart, see
 * qtri_large_next_row(). Depths are halved, since with what is outside of the range they take 33
 * bits: a correction is at most 2^-5 of the range, so with 2^30 they are positive and below 2^32.
 *
 * Where a step fits, a half has 2^46 of the plane's units, and from vertex 0 to the anchor it is
 * less than 2^15 pixels in x and in y: 2^62. False: 32 bits do not hold a step.
 */
static bool set_clamped_depth(qtri_large_job *job, const uint32_t depth[3])
{
    const uint32_t above = (uint32_t)1 << 30;
    const qtri_gradient *g = &job->gradient;
    qtri_plane plane;
    uint32_t f[3];
    for (int i = 0; i < 3; i++) {
        f[i] = (depth[i] >> 1) + above;
    }
    (void)qtri_residual_apply(f, &job->residual, 0, UINT32_MAX);
    qtri_plane_init(&plane, g, f);
    const int64_t dx = whole_depth(plane.dx);
    const int64_t dy = whole_depth(plane.dy);
    if (dx != (int32_t)dx || dy != (int32_t)dy) {
        return false;
    }
    plane.origin -= (uint64_t)above << 16;
    plane.origin += plane.dx * (uint64_t)(int64_t)g->anchor_x;
    plane.origin += plane.dy * (uint64_t)(int64_t)g->anchor_y;
    const int64_t origin = whole_depth(plane.origin) + QTRI_DEPTH_HALF;
    job->depth.origin = (uint32_t)((uint64_t)origin & UINT32_MAX);
    job->depth.dx = (uint32_t)((uint64_t)dx & UINT32_MAX);
    job->depth.dy = (uint32_t)((uint64_t)dy & UINT32_MAX);
    job->depth_above = (int32_t)(origin >> 32); /* 2^62 2^-15 2^-32: it fits */
    return true;
}

static void set_depth(qtri_large_job *job)
{
    const qtri_large_vertex *v = job->v;
    const uint32_t at[3] = {v[0].depth_16p16, v[1].depth_16p16, v[2].depth_16p16};
    uint32_t depth[3] = {at[0], at[1], at[2]};
    /* Of samples clamped depths serve. */
    job->clamps_depth = qtri_residual_apply(depth, &job->residual, 0, (uint32_t)65535 << 16) &&
                        !job->options->samples && set_clamped_depth(job, at);
    if (job->clamps_depth) {
        return;
    }
    if (job->gradient.inverse != 0 && qtri_ramp_fits(depth[0], depth[1]) &&
        qtri_ramp_fits(depth[0], depth[2])) {
        qtri_ramp_multiply(&job->depth, &job->gradient, depth);
    } else {
        qtri_ramp_divide(&job->depth, &job->gradient, depth);
    }
}

/* Where the row before the first begins. */
static void set_row(qtri_large_job *job)
{
    const qtri_draw_state *state = job->t.state;
    const qtri_surface *surface = state->surface;
    const ptrdiff_t row = job->t.y - surface->first_row;
    job->x_first = state->bounds.x0;
    job->x_end = state->bounds.x1;
    job->frame_width = qtri_least32(surface->width, QTRI_SURFACE_MAX);
    job->pitch = surface->pitch;
    job->depth_pitch = state->depth_pitch;
    job->row_pixel = (uintptr_t)surface->pixels + (uintptr_t)(row * surface->pitch);
    job->row_depth = (uintptr_t)surface->depth + (uintptr_t)(row * state->depth_pitch);
    job->row_z =
        qtri_ramp_at(&job->depth, -job->gradient.anchor_x, job->t.y - job->gradient.anchor_y);
}

/* Apart: what is set up once takes no stack while rows are drawn. */
QTRI_NOINLINE void qtri_large_set_up(qtri_large_job *job, const qtri_screen_point *const p[3],
                                     int64_t area)
{
    set_gradient(job, p, area);
    qtri_residual_init(&job->residual, &job->gradient, job->v, qtri_is_textured(job->options),
                       job->width + job->height);
    job->t.z_step = 0;
    job->clamps_depth = false;
    job->pixel_bytes = (uint8_t)qtri_pixel_step(job->options);
    job->depth_bytes = (uint8_t)(qtri_tests_depth(job->options)
                                     ? qtri_depth_size(job->options, job->t.state->surface)
                                     : 0);
    job->is_clamped = false;
    job->depth.origin = 0;
    job->depth.dx = 0;
    job->depth.dy = 0;
    if (qtri_needs_depth(job->options)) {
        set_depth(job);
        job->t.z_step = job->depth.dx;
    }
    set_row(job);
    job->next_left = 0;
    job->next_right = 0;
    job->count = 0;
    job->run_log2 = 14;
    job->packing = QTRI_PACK_NONE;
    job->t.has_runs = false;
    job->first_color = 0;
    job->alpha = QTRI_LARGE_ATTRIBUTES;
    job->plane_y = job->t.y + 1;
}

/* False: there is nothing to draw. */
QTRI_NOINLINE static bool begin(qtri_large_job *job, const qtri_screen_point *const p[3],
                                int64_t area)
{
    const qtri_rect *bounds = &job->t.state->bounds;
    qtri_large_set_box(job, p);
    if (first_center(job->x_least) >= bounds->x1 ||
        first_center(job->x_least + job->width) <= bounds->x0 ||
        !qtri_large_edges_init(&job->edges, bounds, p, area > 0)) {
        return false;
    }
    job->t.y = job->edges.row - 1;
    qtri_large_set_up(job, p, area);
    return true;
}

/* Apart: others take no stack for it. */
QTRI_NOINLINE static void draw_shifted(qtri_large_job *job, const qtri_screen_point *const p[3],
                                       int64_t area)
{
    qtri_draw_state *state = job->t.state;
    qtri_large_vertex moved[3];
    state->material->depth_shift->move(moved, state, p, area, job->v);
    const qtri_large_vertex *v = job->v;
    job->v = moved;
    if (job->options->samples != 0 || begin(job, p, area)) {
        state->pipeline->large(&job->t);
    }
    job->v = v;
}

void qtri_large_triangle(qtri_draw_state *state, const qtri_screen_point *const p[3], int64_t area,
                         uint32_t color_rgb, const qtri_large_vertex v[3])
{
    qtri_large_job job;
    if (area == 0) {
        return;
    }
    job.t.state = state;
    job.t.color = color_rgb;
    job.options = &state->options;
    job.v = v;
    job.p = p;
    job.area = area;
    if (state->material->depth_shift != NULL) {
        draw_shifted(&job, p, area);
        return;
    }
    if (job.options->samples != 0 || begin(&job, p, area)) {
        state->pipeline->large(&job.t);
    }
}
