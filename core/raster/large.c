/* SPDX-License-Identifier: MIT */
/* Large triangles: edges, depth, and their rows. */
#include "large.h"

#include "descriptions.h"
#include "large_setup.h"

static void edge_init(qtri_dda *dda, const qtri_point *a, const qtri_point *b, int32_t row)
{
    const int32_t length = b->y_24p8 - a->y_24p8;
    qtri_dda_init(dda, a->x_24p8, b->x_24p8 - a->x_24p8, length, row * 256 + 128 - a->y_24p8,
                  128 * length - 1);
}

bool qtri_large_edges_init(qtri_large_edges *e, const qtri_rect *bounds,
                           const qtri_point *const vertex[3], bool clockwise)
{
    const qtri_point *p[3] = {vertex[0], vertex[1], vertex[2]};
    for (int i = 0; i < 3; i++) { /* 0 1, 1 2, 0 1 */
        const int k = i & 1;
        if (p[k + 1]->y_24p8 < p[k]->y_24p8) {
            const qtri_point *other = p[k];
            p[k] = p[k + 1];
            p[k + 1] = other;
            clockwise = !clockwise;
        }
    }
    const int32_t row = qtri_greatest32(qtri_large_first_center(p[0]->y_24p8), bounds->y0);
    e->row = row;
    e->end = qtri_least32(qtri_large_first_center(p[2]->y_24p8), bounds->y1);
    e->turn = qtri_least32(qtri_large_first_center(p[1]->y_24p8), e->end);
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

void qtri_large_set_box(qtri_large *t, const qtri_point *const p[3], int64_t area)
{
    int32_t x[2] = {p[0]->x_24p8, p[0]->x_24p8};
    int32_t y[2] = {p[0]->y_24p8, p[0]->y_24p8};
    for (int i = 1; i < 3; i++) {
        x[0] = qtri_least32(x[0], p[i]->x_24p8);
        x[1] = qtri_greatest32(x[1], p[i]->x_24p8);
        y[0] = qtri_least32(y[0], p[i]->y_24p8);
        y[1] = qtri_greatest32(y[1], p[i]->y_24p8);
    }
    for (int i = 0; i < 3; i++) {
        t->corner_x[i] = p[i]->x_24p8;
        t->corner_y[i] = p[i]->y_24p8;
    }
    t->area = area;
    t->x_least = x[0];
    t->y_least = y[0];
    t->width = x[1] - x[0];
    t->height = y[1] - y[0];
}

/* Depth ---------------------------------------------------------------------------------------- */

/* Whether a ramp through the vertices' true positions is out of range where they are snapped to. No
   step is more than 8 times the range. */
static bool leaves_range(const qtri_large *t)
{
    for (int i = 0; i < 3; i++) {
        const qtri_large_vertex *v = &t->in->v[i];
        const int64_t more =
            (t->ramp_z.dx * v->rest[0] + t->ramp_z.dy * v->rest[1]) >> 24; /* 2^36 2^15 */
        if ((uint64_t)((int64_t)t->in->depth_16p16[i] - more) > (uint64_t)65535 << 16) {
            return true;
        }
    }
    return false;
}

/* By the weights in use. Values have 2^39 at most: depth in quarters. */
static void set_depth_ramp(qtri_large *t)
{
    int64_t f_q8[3];
    for (int i = 0; i < 3; i++) {
        f_q8[i] = (int64_t)t->in->depth_16p16[i] << 6;
    }
    qtri_large_ramp_init(&t->ramp_z, t, f_q8, -2);
}

/*
 * A triangle that the near plane has clipped has two vertices at depth 0, and its true plane is a
 * little below 0 where they are snapped to. To clamp the three depths would bend the plane, so
 * pixels whose depth leaves the range are drawn by themselves, see qtri_large_next_row().
 */
static void set_depth(qtri_large *t)
{
    set_depth_ramp(t);
    if (t->has_true_positions && leaves_range(t)) {
        if (t->options->samples) {
            qtri_large_use_weights(t, false);
            set_depth_ramp(t);
        } else {
            t->clamps_depth = true;
        }
    }
    t->ramp_z.at += QTRI_DEPTH_HALF;
    t->row_z = (uint32_t)(t->ramp_z.at + t->ramp_z.dy * t->y);
    t->row_z_step = (uint32_t)t->ramp_z.dy;
    t->z_step = (uint32_t)t->ramp_z.dx;
}

/* Where the row before the first begins. */
static void begin_rows(qtri_large *t)
{
    const qtri_draw_state *state = t->state;
    const qtri_surface *surface = state->surface;
    const ptrdiff_t row = t->y - surface->first_row;
    t->bounds_left = state->bounds.x0;
    t->bounds_right = state->bounds.x1;
    t->frame_width = qtri_least32(surface->width, QTRI_SURFACE_MAX);
    t->pitch = surface->pitch;
    t->depth_pitch = state->depth_pitch;
    t->row_z = 0;
    t->row_z_step = 0;
    t->row_pixel = (uintptr_t)surface->pixels + (uintptr_t)(row * surface->pitch);
    t->row_depth = (uintptr_t)state->depth + (uintptr_t)(row * state->depth_pitch);
}

/* Apart: what is set up once takes no stack while rows are drawn. */
QTRI_NOINLINE void qtri_large_set_up(qtri_large *t)
{
    qtri_large_set_weights(t);
    t->plane_y = t->y + 1;
    t->z_step = 0;
    t->clamps_depth = false;
    begin_rows(t);
    if (qtri_needs_depth(t->options)) {
        set_depth(t);
    }
    t->next_left = 0;
    t->next_right = 0;
}

/* Rows ----------------------------------------------------------------------------------------- */

/* -1, 0, 1: depth at a column is below, inside and above its range. All bits of what the loop over
   pixels has modulo 2^32; a plane holds 50. */
QTRI_NOINLINE static int side_at(const qtri_large *t, int32_t x)
{
    const int64_t depth =
        qtri_wrap64((uint64_t)(t->ramp_z.at + t->ramp_z.dx * x + t->ramp_z.dy * t->y) << 14) >> 14;
    return depth < 0 ? -1 : depth >> 32 != 0;
}

/*
 * The next part of a row, from next_left to next_right, whose depth is inside the range, or all
 * below or above it. Depth goes one way along a row, so each side has one run of pixels; few are
 * outside, and are counted. False: there is none.
 */
QTRI_NOINLINE static bool next_part(qtri_large *t)
{
    const int32_t left = t->next_left, end = t->next_right;
    if (left >= end) {
        return false;
    }
    const int side = side_at(t, left);
    int32_t right = left + 1;
    if (side == 0) {
        right = end;
        while (side_at(t, right - 1) != 0) {
            right--;
        }
        t->row_z = (uint32_t)(t->ramp_z.at + t->ramp_z.dy * t->y);
        t->z_step = (uint32_t)t->ramp_z.dx;
    } else {
        while (right < end && side_at(t, right) == side) {
            right++;
        }
        t->row_z = (side < 0 ? 0 : (uint32_t)65535 << 16) + QTRI_DEPTH_HALF;
        t->z_step = 0;
    }
    t->row_left = left;
    t->row_right = right;
    t->next_left = right;
    return true;
}

/* The next row's ends; false: there is none. */
static inline bool step_row(qtri_large *t)
{
    int32_t left, right;
    qtri_large_step_row(t);
    if (t->y >= t->edges.end) {
        return false;
    }
    qtri_large_edges_next(&t->edges, t->y, &left, &right);
    t->row_left = qtri_greatest32(left, 0);
    t->row_right = qtri_least32(right, t->frame_width);
    return true;
}

/* Rows whose depth may leave its range are drawn part by part. */
QTRI_NOINLINE static bool next_clamped(qtri_large *t)
{
    while (!next_part(t)) {
        if (!step_row(t)) {
            return false;
        }
        t->next_left = t->row_left;
        t->next_right = t->row_right;
    }
    qtri_large_set_row(t, t->row_left, t->row_right);
    return true;
}

bool qtri_large_next_row(qtri_large *t)
{
    if (t->clamps_depth) {
        return next_clamped(t);
    }
    if (!step_row(t)) {
        return false;
    }
    qtri_large_set_row(t, t->row_left, t->row_right);
    return true;
}

/* Triangles ------------------------------------------------------------------------------------ */

bool qtri_large_begin_rows(qtri_large *t)
{
    const qtri_large_input *in = t->in;
    const qtri_rect *bounds = &t->state->bounds;
    qtri_large_set_box(t, in->p, in->area);
    if (qtri_large_first_center(t->x_least) >= bounds->x1 ||
        qtri_large_first_center(t->x_least + t->width) <= bounds->x0 ||
        !qtri_large_edges_init(&t->edges, bounds, in->p, in->area > 0)) {
        return false;
    }
    t->y = t->edges.row - 1;
    qtri_large_set_up(t);
    return true;
}

void qtri_large_triangle(qtri_draw_state *state, const qtri_point *const p[3], int64_t area,
                         uint32_t color_rgb, const qtri_large_vertex v[3])
{
    const qtri_depth_shift *shift = state->material->depth_shift;
    qtri_large_input in = {state, p, area, color_rgb, v, {0, 0, 0}};
    for (int i = 0; i < 3; i++) {
        in.depth_16p16[i] = v[i].depth_16p16;
    }
    if (shift != NULL) {
        const uint32_t by = shift->find(state->material, p, area, in.depth_16p16);
        for (int i = 0; i < 3; i++) {
            in.depth_16p16[i] += by;
        }
    }
    state->pipeline->large(&in);
}
