/* SPDX-License-Identifier: MIT */
/* Large triangles: edges, depth, and their rows. */
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

void qtri_large_set_box(qtri_large_job *job, const qtri_screen_point *const p[3], int64_t area)
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
        job->x[i] = p[i]->x_24p8;
        job->y[i] = p[i]->y_24p8;
    }
    job->area = area;
    job->x_least = x[0];
    job->y_least = y[0];
    job->width = x[1] - x[0];
    job->height = y[1] - y[0];
    job->pixels = (qtri_greatest32(job->width, job->height) >> 8) + 1;
}

/* Depth ---------------------------------------------------------------------------------------- */

/* Whether a ramp through the vertices' true positions is out of range where they are snapped to. No
   step is more than 8 times the range. */
static bool leaves_range(const qtri_large_job *job)
{
    for (int i = 0; i < 3; i++) {
        const qtri_large_vertex *v = &job->v[i];
        const int64_t more =
            (job->depth.dx * v->rest[0] + job->depth.dy * v->rest[1]) >> 24; /* 2^36 2^15 */
        if ((uint64_t)((int64_t)job->vertex_depth[i] - more) > (uint64_t)65535 << 16) {
            return true;
        }
    }
    return false;
}

/* Values have 2^39 at most: depth in quarters. */
static void set_depth_ramp(qtri_large_job *job, bool is_true)
{
    int64_t f_q8[3];
    for (int i = 0; i < 3; i++) {
        f_q8[i] = (int64_t)job->vertex_depth[i] << 6;
    }
    qtri_large_use_weights(job, is_true);
    qtri_large_ramp_init(&job->depth, job, f_q8, -2);
}

/*
 * A triangle that the near plane has clipped has two vertices at depth 0, and its true plane is a
 * little below 0 where they are snapped to. To clamp the three depths would bend the plane, so
 * pixels whose depth leaves the range are drawn by themselves, see qtri_large_next_row().
 */
static void set_depth(qtri_large_job *job)
{
    set_depth_ramp(job, job->is_true);
    if (job->is_true && leaves_range(job)) {
        if (job->options->samples) {
            set_depth_ramp(job, false);
        } else {
            job->clamps_depth = true;
        }
    }
    job->depth.at += QTRI_DEPTH_HALF;
    job->t.row_z = (uint32_t)(job->depth.at + job->depth.dy * job->t.y);
    job->t.row_z_step = (uint32_t)job->depth.dy;
    job->t.z_step = (uint32_t)job->depth.dx;
}

/* Where the row before the first begins. */
static void begin_rows(qtri_large_job *job)
{
    const qtri_draw_state *state = job->t.state;
    const qtri_surface *surface = state->surface;
    const ptrdiff_t row = job->t.y - surface->first_row;
    job->t.x_first = state->bounds.x0;
    job->t.x_end = state->bounds.x1;
    job->t.frame_width = qtri_least32(surface->width, QTRI_SURFACE_MAX);
    job->t.pitch = surface->pitch;
    job->t.depth_pitch = state->depth_pitch;
    job->t.row_z = 0;
    job->t.row_z_step = 0;
    job->t.row_pixel = (uintptr_t)surface->pixels + (uintptr_t)(row * surface->pitch);
    job->t.row_depth = (uintptr_t)surface->depth + (uintptr_t)(row * state->depth_pitch);
}

/* Apart: what is set up once takes no stack while rows are drawn. */
QTRI_NOINLINE void qtri_large_set_up(qtri_large_job *job)
{
    qtri_large_set_weights(job);
    job->plane_y = job->t.y + 1;
    job->t.z_step = 0;
    job->clamps_depth = false;
    job->t.pixel_bytes = qtri_pixel_step(job->options);
    job->t.depth_bytes =
        qtri_tests_depth(job->options) ? qtri_depth_size(job->options, job->t.state->surface) : 0;
    job->is_clamped = false;
    begin_rows(job);
    if (qtri_needs_depth(job->options)) {
        set_depth(job);
    }
    job->next_left = 0;
    job->next_right = 0;
    job->count = 0;
    job->run_log2 = 14;
    job->packing = QTRI_PACK_NONE;
    job->t.has_runs = false;
    job->first_color = 0;
    job->alpha = QTRI_LARGE_ATTRIBUTES;
}

/* Rows -----------------------------------------------------------------------------------------
 */

/* -1, 0, 1: depth at a column is below, inside and above its range. All bits of what the loop over
   pixels has modulo 2^32; a plane holds 50. */
QTRI_NOINLINE static int side_at(const qtri_large_job *job, int32_t x)
{
    const int64_t depth =
        qtri_wrap64((uint64_t)(job->depth.at + job->depth.dx * x + job->depth.dy * job->t.y)
                    << 14) >>
        14;
    return depth < 0 ? -1 : depth >> 32 != 0;
}

/*
 * The next part of a row, from next_left to next_right, whose depth is inside the range, or all
 * below or above it. Depth goes one way along a row, so each side has one run of pixels; few are
 * outside, and are counted. False: there is none.
 */
QTRI_NOINLINE static bool next_part(qtri_large_job *job)
{
    const int32_t left = job->next_left, end = job->next_right;
    if (left >= end) {
        return false;
    }
    const int side = side_at(job, left);
    int32_t right = left + 1;
    job->is_clamped = side != 0;
    if (side == 0) {
        right = end;
        while (side_at(job, right - 1) != 0) {
            right--;
        }
        job->t.z_step = (uint32_t)job->depth.dx;
    } else {
        while (right < end && side_at(job, right) == side) {
            right++;
        }
        job->t.z_step = 0;
        job->t.z = (side < 0 ? 0 : (uint32_t)65535 << 16) + QTRI_DEPTH_HALF;
    }
    job->t.row_left = left;
    job->t.row_right = right;
    job->next_left = right;
    return true;
}

/* What is drawn from `left` to `right`; false: nothing. */
static inline bool set_row(qtri_large_job *job, int32_t left, int32_t right)
{
    qtri_large *t = &job->t;
    const int32_t x0 = qtri_greatest32(left, job->t.x_first);
    const int32_t x1 = qtri_least32(right, job->t.x_end);
    if (x0 >= x1) {
        return false;
    }
    t->x0 = x0;
    t->x1 = x1;
    t->x = x0;
    t->fog_x = x0;
    job->t.is_new = true;
    /* NOLINTBEGIN(performance-no-int-to-ptr): column 0 may lie before the surface's first row */
    t->pixel = (uint8_t *)(job->t.row_pixel + (uint32_t)x0 * job->t.pixel_bytes);
    t->depth = (uint8_t *)(job->t.row_depth + (uint32_t)x0 * job->t.depth_bytes);
    /* NOLINTEND(performance-no-int-to-ptr) */
    if (!job->is_clamped) {
        t->z = t->row_z + (uint32_t)x0 * t->z_step;
    }
    return true;
}

bool qtri_large_set_row(qtri_large_job *job, int32_t left, int32_t right)
{
    return set_row(job, left, right);
}

/* The next row's ends; false: there is none. */
static inline bool step_row(qtri_large_job *job)
{
    int32_t left, right;
    qtri_large_step_row(job);
    if (job->t.y >= job->t.edges.end) {
        return false;
    }
    qtri_large_edges_next(&job->t.edges, job->t.y, &left, &right);
    job->t.row_left = qtri_greatest32(left, 0);
    job->t.row_right = qtri_least32(right, job->t.frame_width);
    return true;
}

/* Rows whose depth may leave its range are drawn part by part: of a new one there is none yet. */
bool qtri_large_next_row(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    do {
        if (!job->clamps_depth || !next_part(job)) {
            if (!step_row(job)) {
                return false;
            }
            if (job->clamps_depth) {
                job->next_left = t->row_left;
                job->next_right = t->row_right;
                t->row_right = t->row_left;
            }
        }
    } while (!set_row(job, t->row_left, t->row_right));
    return true;
}

/* Triangles ------------------------------------------------------------------------------------ */

/* False: there is nothing to draw. */
QTRI_NOINLINE static bool begin(qtri_large_job *job, const qtri_screen_point *const p[3],
                                int64_t area)
{
    const qtri_rect *bounds = &job->t.state->bounds;
    qtri_large_set_box(job, p, area);
    if (first_center(job->x_least) >= bounds->x1 ||
        first_center(job->x_least + job->width) <= bounds->x0 ||
        !qtri_large_edges_init(&job->t.edges, bounds, p, area > 0)) {
        return false;
    }
    job->t.y = job->t.edges.row - 1;
    qtri_large_set_up(job);
    return true;
}

void qtri_large_triangle(qtri_draw_state *state, const qtri_screen_point *const p[3], int64_t area,
                         uint32_t color_rgb, const qtri_large_vertex v[3])
{
    const qtri_depth_shift *shift = state->material->depth_shift;
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
    for (int i = 0; i < 3; i++) {
        job.vertex_depth[i] = v[i].depth_16p16;
    }
    if (shift != NULL) {
        const uint32_t by = shift->find(state->material, p, area, job.vertex_depth);
        for (int i = 0; i < 3; i++) {
            job.vertex_depth[i] += by;
        }
    }
    if (job.options->samples != 0 || begin(&job, p, area)) {
        state->pipeline->large(&job.t);
    }
}
