/* SPDX-License-Identifier: MIT */
/*
 * Large triangles on surfaces with four samples a pixel: passes, and their rows. Depths of samples
 * are the centre's and what a ramp has more there.
 */
#include "large_setup.h"
#include "triangle.h"

static const int8_t offset[QTRI_PLACES][2] = {{-32, -96}, {96, -32}, {-96, 32}, {32, 96}, {0, 0}};

/* By less than a pixel: coordinates stay where all that follows has room. */
static int32_t moved_by(int32_t at_24p8, int32_t by)
{
    return qtri_hold32(at_24p8 - by, -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
}

/* The triangle so that a place lies where centres do; returns its area, which may be 0. */
static int64_t move(const qtri_point *p[3], const qtri_large *t, int32_t place)
{
    qtri_point *moved = t->samples->moved;
    for (int i = 0; i < 3; i++) {
        moved[i].x_24p8 = moved_by(t->in->p[i]->x_24p8, offset[place][0]);
        moved[i].y_24p8 = moved_by(t->in->p[i]->y_24p8, offset[place][1]);
        p[i] = &moved[i];
    }
    return qtri_triangle_area(p[0], p[1], p[2]);
}

/* Edges at all places; false: there is nothing to draw. */
static bool set_edges(qtri_large *t)
{
    qtri_large_samples *s = t->samples;
    const qtri_rect *bounds = &t->state->bounds;
    const qtri_point *p[3];
    s->first_row = bounds->y1;
    s->end = bounds->y0;
    for (int32_t k = 0; k < QTRI_PLACES; k++) {
        qtri_large_edges *e = &s->first[k];
        const int64_t area = move(p, t, k);
        if (area == 0 || !qtri_large_edges_init(e, bounds, p, area > 0)) {
            e->row = 0;
            e->end = 0;
        } else if (k != QTRI_CENTER) {
            s->first_row = qtri_least32(s->first_row, e->row);
            s->end = qtri_greatest32(s->end, e->end);
        }
    }
    return s->first_row < s->end;
}

/* The triangle at a place; false: it has no area there. */
static bool set_up(qtri_large *t, int32_t place)
{
    const qtri_point *p[3];
    const int64_t area = move(p, t, place);
    if (area == 0) {
        return false;
    }
    qtri_large_set_box(t, p, area);
    t->y = t->samples->first_row - 1;
    qtri_large_set_up(t);
    return true;
}

/*
 * Whether a step of depth is below 2^29, so that its ramp did not wrap: with differences of
 * coordinates of at most an extent it is at most 2 range extent 2^8 / area.
 */
static bool is_gentle(const qtri_large *t)
{
    uint32_t least, most;
    const uint64_t extent = (uint64_t)((int64_t)t->width + t->height);
    qtri_find_range(&least, &most, t->in->depth_16p16);
    return (((most - least) >> 12) + 1) * extent <= qtri_magnitude64(t->area) << 8;
}

/* Depth at a place where its step may have wrapped: it is set up there. */
static uint32_t depth_at(qtri_large *t, int32_t place, int32_t x, int32_t y)
{
    return set_up(t, place) ? (uint32_t)(t->ramp_z.at + t->ramp_z.dx * x + t->ramp_z.dy * y) : 0;
}

static void set_depths(qtri_large *t)
{
    qtri_large_samples *s = t->samples;
    s->z_p = 0;
    s->z_q = 0;
    if (!qtri_needs_depth(t->options)) {
        return;
    }
    if (is_gentle(t)) {
        const int32_t dx = (int32_t)t->ramp_z.dx >> 1;
        const int32_t dy = (int32_t)t->ramp_z.dy >> 1;
        s->z_p = (uint32_t)((dx + 3 * dy) >> 2);
        s->z_q = (uint32_t)((3 * dx - dy) >> 2);
        return;
    }
    const int32_t x = t->corner_x[0] >> 8, y = t->corner_y[0] >> 8;
    const uint32_t p = depth_at(t, 3, x, y), q = depth_at(t, 1, x, y);
    const uint32_t center = depth_at(t, QTRI_CENTER, x, y);
    s->z_p = p - center;
    s->z_q = q - center;
}

bool qtri_large_begin_samples(qtri_large *t, int32_t place)
{
    qtri_large_samples *s = t->samples;
    if (place == QTRI_CENTER) {
        if (!set_edges(t)) { /* nor in the passes that follow */
            s->first_row = 0;
            s->end = 0;
            return false;
        }
        (void)set_up(t, place);
        set_depths(t);
    } else if (s->end <= s->first_row || !set_up(t, place)) {
        return false;
    }
    for (int32_t k = 0; k < QTRI_PLACES; k++) {
        s->edges[k] = s->first[k];
    }
    s->place = place;
    t->next_left = 0;
    t->row_right = 0;
    return true;
}

/* The columns of all places in the row. */
static void set_columns(qtri_large *t)
{
    qtri_large_samples *s = t->samples;
    qtri_samples_row *row = &s->row;
    for (int32_t k = 0; k < QTRI_PLACES; k++) {
        qtri_large_edges *e = &s->edges[k];
        row->left[k] = 0;
        row->right[k] = 0;
        if (t->y >= e->row && t->y < e->end) {
            qtri_large_edges_next(e, t->y, &row->left[k], &row->right[k]);
        }
    }
    row->x0 = qtri_greatest32(qtri_greatest32(row->left[0], row->left[1]),
                              qtri_greatest32(row->left[2], row->left[3]));
    const int32_t end = qtri_least32(qtri_least32(row->right[0], row->right[1]),
                                     qtri_least32(row->right[2], row->right[3]));
    row->count = end > row->x0 ? (uint32_t)(end - row->x0) : 0;
    t->row_left = qtri_greatest32(row->left[s->place], 0);
    t->row_right = qtri_least32(row->right[s->place], t->frame_width);
    t->next_left = t->row_left;
}

static bool is_in(const qtri_samples_row *row, int32_t k, int32_t x)
{
    return x >= row->left[k] && x < row->right[k];
}

/* Which comes before sample k in what a pixel takes its colour from: the centre, then samples. */
static int32_t place_before(int32_t k)
{
    return k == 0 ? QTRI_CENTER : k - 1;
}

/* The next columns of the row of pixels that take their colours at the pass's place; false: there
   are none. Those of places that come before are intervals, too. */
static bool next_run(qtri_large *t, int32_t *first, int32_t *end)
{
    const qtri_large_samples *s = t->samples;
    const qtri_samples_row *row = &s->row;
    int32_t x = t->next_left, stop = t->row_right;
    for (int32_t k = s->place; k != QTRI_CENTER;) {
        k = place_before(k);
        if (is_in(row, k, x)) {
            x = row->right[k];
            k = s->place; /* from the start: it may be in another */
        }
    }
    if (x >= t->row_right) {
        return false;
    }
    for (int32_t k = s->place; k != QTRI_CENTER;) {
        k = place_before(k);
        if (row->left[k] > x && row->left[k] < row->right[k]) {
            stop = qtri_least32(stop, row->left[k]);
        }
    }
    *first = x;
    *end = stop;
    t->next_left = stop;
    return true;
}

bool qtri_large_next_samples(qtri_large *t)
{
    qtri_large_samples *s = t->samples;
    for (;;) {
        int32_t first, end;
        if (t->next_left < t->row_right && next_run(t, &first, &end)) {
            qtri_large_set_row(t, first, end);
            return true;
        }
        qtri_large_step_row(t);
        if (t->y >= s->end) {
            return false;
        }
        set_columns(t);
    }
}
