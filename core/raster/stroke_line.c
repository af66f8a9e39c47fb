/* SPDX-License-Identifier: MIT */
/* Smooth lines of up to two pixels: exact coverage, column by column. */
#include "line.h"

#include "../bits/bits.h"
#include "line_path.h"
#include "stroke_shape.h"

enum { MIN_COVER = QTRI_COVERAGE_FULL / 64 }; /* less would not change RGB565 */

enum { CELLS = 8 }; /* of a column, with what follows the last */

/* Where a column's cells are, what covers the pixel before the first, and the share there in Q24.
 */
typedef struct cells {
    const int32_t *cell, *end;
    int32_t sum, share, along, across;
} cells;

/*
 * A line by its longer axis, "along", and the other, "across". Its rectangle's corners lie at an
 * end less the offset, on the near side, and at the end plus the offset, on the far one:
 * (offset_x, -offset_y) from it. 24.8 where nothing else is said.
 */
typedef struct thin_line {
    const qtri_line_job *job;
    void (*draw)(const struct thin_line *w, const cells *c); /* the pixels of a column */
    int32_t x[2], y[2];         /* of the ends, along and across; x[0] < x[1] */
    int32_t origin_x, origin_y; /* of the first end, without a cap */
    int32_t slope_q16;          /* across for along: -1..1 */
    uint32_t slope_q30;         /* its magnitude */
    int32_t inverse_q8;         /* along for across, its magnitude, at most 2^22 */
    int32_t offset_x, offset_y; /* |offset_x| <= offset_y <= radius */
    int32_t half_q16;           /* of its extent across, in a column: <= sqrt(2) pixels */
    int32_t first, end;         /* columns */
    int32_t inner, inner_end;   /* columns that touch no end */
    int32_t bounds[4];          /* pixels inside: along from, to; across from, to */
    bool inside;                /* all of it lies in them */
    int32_t share_step;         /* Q24 of its length a column; at most 2^28 */
    int32_t share_across;       /* of its length a pixel across */
    qtri_stroke_look look;
    bool steep; /* along is y */
} thin_line;

/*
 * Adds the area on the far side of a side that goes from `ya` to `yb`, 1/256 pixel behind the
 * column's first cell, while `dx` (signed) goes by along. Once all sides are there, the sum of all
 * cells up to one is what its pixel has, of QTRI_COVERAGE_FULL. ratio_q8: |dx| for |yb - ya|.
 */
QTRI_INLINE void add_side(int32_t *cell, int32_t dx, int32_t ya, int32_t yb, int32_t ratio_q8)
{
    int32_t k = ya >> 8;
    const int32_t last = yb >> 8;
    if (k == last) {
        qtri_coverage_add_piece(&cell[k], dx, (ya & 255) + (yb & 255));
        return;
    }
    const int32_t size = dx < 0 ? -dx : dx;
    const int32_t step = yb > ya ? 1 : -1;
    int32_t y = ya - k * 256;
    int32_t gone = 0; /* across */
    int32_t done = 0; /* along */
    do {
        const int32_t to = step > 0 ? 256 : 0;
        gone += (to - y) * step;
        const int32_t upto = qtri_least32((gone * ratio_q8) >> 8, size); /* 2^10 2^21 */
        qtri_coverage_add_piece(&cell[k], dx < 0 ? done - upto : upto - done, y + to);
        k += step;
        y = 256 - to;
        done = upto;
    } while (k != last);
    qtri_coverage_add_piece(&cell[k], dx < 0 ? done - size : size - done, y + yb - k * 256);
}

/* An end of the rectangle, near to far corner, in the column at x, whose cell 0 is at `first`. */
QTRI_INLINE void add_end(int32_t *cell, const thin_line *w, int end, int32_t x, int32_t first)
{
    const int32_t near_x = w->x[end] + w->offset_x, far_x = w->x[end] - w->offset_x;
    const bool forwards = far_x > near_x;
    const int32_t left = qtri_greatest32(forwards ? near_x : far_x, x);
    const int32_t right = qtri_least32(forwards ? far_x : near_x, x + 256);
    if (left >= right) {
        return;
    }
    const int32_t near_y = w->y[end] - w->offset_y - first, far_y = w->y[end] + w->offset_y - first;
    const int32_t from = forwards ? left - near_x : near_x - right; /* < 2^9 */
    const int32_t to = forwards ? right - near_x : near_x - left;
    const int32_t ya = qtri_least32(near_y + ((from * w->inverse_q8) >> 8), far_y);
    const int32_t yb = qtri_least32(near_y + ((to * w->inverse_q8) >> 8), far_y);
    const int32_t dx = (forwards == (end == 1)) ? right - left : left - right;
    add_side(cell, dx, ya, yb, (int32_t)(w->slope_q30 >> 22));
}

/* A long side, near (sign 1) or far (-1), in a column where the line ends; y: at x, in cell 0. */
QTRI_INLINE void add_long_side(int32_t *cell, const thin_line *w, int32_t sign, int32_t x,
                               int32_t y)
{
    const int32_t offset = sign * w->offset_x;
    const int32_t left = qtri_greatest32(w->x[0] + offset, x);
    const int32_t right = qtri_least32(w->x[1] + offset, x + 256);
    if (left < right) {
        add_side(cell, sign * (right - left), y + ((w->slope_q16 * (left - x)) >> 16),
                 y + ((w->slope_q16 * (right - x)) >> 16), w->inverse_q8);
    }
}

/* All sides in a column where the line ends; y: the near side at its start, in cell 0. */
QTRI_NOINLINE static void add_end_column(int32_t *cell, const thin_line *w, int32_t column,
                                         int32_t first, int32_t y, int32_t wide)
{
    const int32_t x = column * 256;
    add_long_side(cell, w, 1, x, y);
    add_long_side(cell, w, -1, x, y + wide);
    if (column < w->inner) {
        add_end(cell, w, 0, x, first);
    }
    if (column >= w->inner_end) {
        add_end(cell, w, 1, x, first);
    }
}

static void clip_cells(const thin_line *w, cells *c)
{
    for (; c->across < w->bounds[2] && c->cell != c->end; c->across++) {
        c->sum += *c->cell++;
        c->share += w->share_across;
    }
    const int32_t rest = w->bounds[3] - c->across;
    if (rest < (int32_t)(c->end - c->cell)) {
        c->end = rest > 0 ? c->cell + rest : c->cell;
    }
}

static void draw_any(const thin_line *w, const cells *c)
{
    qtri_stroke_target *to = w->job->to;
    uint16_t weight[CELLS], share_q16[CELLS];
    int32_t share_q24 = c->share, sum = c->sum;
    int32_t count = 0;
    for (const int32_t *cell = c->cell; cell != c->end; cell++, share_q24 += w->share_across) {
        sum += *cell;
        const uint32_t cover = (uint32_t)qtri_hold32(sum, 0, QTRI_COVERAGE_FULL);
        weight[count] = (uint16_t)(sum < MIN_COVER ? 0 : qtri_stroke_weight(cover, to->alpha_q16));
        share_q16[count] = qtri_stroke_clamped_share(share_q24);
        count++;
    }
    const qtri_stroke_span span = {&to->state,
                                   &w->look,
                                   w->steep ? c->across : c->along,
                                   w->steep ? c->along : c->across,
                                   w->steep ? count : 1,
                                   w->steep ? 1 : count,
                                   weight,
                                   share_q16};
    qtri_stroke_target_draw(to, &span);
}

/* Draws a column in RGB565, opaque, its colours from the table of light. */
QTRI_INLINE void draw_pixels(const thin_line *w, const cells *c, bool has_depth)
{
    const int32_t *cell = c->cell;
    const int32_t *const end = c->end;
    const qtri_surface *surface = w->job->to->state.surface;
    const ptrdiff_t x = w->steep ? c->across : c->along;
    const ptrdiff_t row = (w->steep ? c->along : c->across) - surface->first_row;
    const ptrdiff_t pixel_step = w->steep ? 2 : surface->pitch;
    const ptrdiff_t depth_step = w->steep ? 1 : surface->depth_pitch;
    uint8_t *pixel = surface->pixels + row * surface->pitch + 2 * x;
    uint16_t *depth = has_depth ? surface->depth + row * surface->depth_pitch + x : NULL;
    int32_t share_q24 = c->share, sum = c->sum;
    do {
        sum += *cell++;
        if (sum >= MIN_COVER) {
            const uint32_t share = qtri_stroke_share(qtri_stroke_clamped_share(share_q24));
            const uint32_t z = (qtri_stroke_depth_at(&w->look, share) + 0x8000u) >> 16;
            if (!has_depth || z < *depth) {
                uint16_t *to = (uint16_t *)(void *)pixel;
                const uint32_t cover = (uint32_t)qtri_least32(sum, QTRI_COVERAGE_FULL);
                const uint32_t weight = qtri_stroke_weight(cover, 65536) & 0x1FFu;
                const uint32_t word = qtri_stroke_lit_color_at(&w->look, share);
                if (has_depth && sum >= QTRI_COVERAGE_FULL / 2) {
                    *depth = (uint16_t)z;
                }
                *to = (uint16_t)qtri_color_fade(QTRI_IN_565, word, weight, *to);
            }
        }
        share_q24 += w->share_across;
        pixel += pixel_step;
        if (has_depth) {
            depth += depth_step;
        }
    } while (cell != end);
}

static void draw_over(const thin_line *w, const cells *c)
{
    draw_pixels(w, c, false);
}

static void draw_nearer(const thin_line *w, const cells *c)
{
    draw_pixels(w, c, true);
}

/* Draws columns `column` to before `end` of one chunk; low_q16: the near side at the first. */
static void walk(const thin_line *w, int32_t column, int32_t end, int32_t low_q16, int32_t share)
{
    int32_t cell[CELLS];
    const int32_t slope = w->slope_q16;
    const int32_t wide = 2 * w->half_q16 >> 8;
    cells c;
    for (c.along = column; c.along < end; c.along++, low_q16 += slope, share += w->share_step) {
        cell[0] = cell[1] = cell[2] = cell[3] = 0;
        cell[4] = cell[5] = cell[6] = 0;
        /* 1/32 less, for corners that were rounded. */
        const int32_t base = ((slope < 0 ? low_q16 + slope : low_q16) - 0x800) >> 16;
        const int32_t first = base * 256;
        const int32_t near_a = (low_q16 >> 8) - first, near_b = ((low_q16 + slope) >> 8) - first;
        if (c.along >= w->inner && c.along < w->inner_end) {
            add_side(cell, 256, near_a, near_b, w->inverse_q8);
            add_side(cell, -256, near_a + wide, near_b + wide, w->inverse_q8);
        } else {
            add_end_column(cell, w, c.along, first, near_a, wide);
        }
        /* From the line at the column's middle to the first cell's: 1/256 pixel. */
        const int32_t middle = (low_q16 + (slope >> 1) + w->half_q16) >> 8;
        c.end = cell + ((qtri_greatest32(near_a, near_b) + wide + 8) >> 8) + 1;
        c.share = share + (w->share_across >> 8) * (first + 128 - middle);
        c.across = base;
        c.cell = cell;
        c.sum = 0;
        if (!w->inside) {
            clip_cells(w, &c);
            if (c.cell == c.end) {
                continue;
            }
        }
        w->draw(w, &c);
    }
}

/*
 * Direction and what follows from it, of a line that is `length` along and `delta` across. Its
 * cosine is 1 / sqrt(1 + slope^2), within 2^-12 of itself.
 */
static void set_direction(thin_line *w, int32_t length, int32_t delta, int32_t radius)
{
    const int32_t zeros = qtri_clz32((uint32_t)length); /* 8..31 */
    const uint32_t reciprocal = qtri_reciprocal_near((uint32_t)length << zeros);
    const uint32_t slope_q30 = qtri_mul_high32(qtri_magnitude32(delta) << zeros, reciprocal);
    w->slope_q30 = slope_q30 < (uint32_t)1 << 30 ? slope_q30 : (uint32_t)1 << 30;
    const int32_t magnitude_q16 = (int32_t)(w->slope_q30 >> 14);
    w->slope_q16 = delta < 0 ? -magnitude_q16 : magnitude_q16;
    w->inverse_q8 = (int32_t)1 << 22;
    if (w->slope_q30 >= (uint32_t)1 << 16) {
        const int32_t up = qtri_clz32(w->slope_q30); /* 1..15 */
        w->inverse_q8 = (int32_t)(qtri_reciprocal_near(w->slope_q30 << up) >> (24 - up));
    }
    const uint32_t s_q15 = w->slope_q30 >> 15;
    const uint32_t square_q15 = (s_q15 * s_q15) >> 15; /* <= 1 */
    const uint32_t t = 32768 + square_q15;
    const uint32_t cosine_q15 = (qtri_rsqrt_seed(t < 65535 ? t : 65535) * 46341u) >> 16;
    const int32_t sine_q15 = (int32_t)((cosine_q15 * s_q15 + 16384) >> 15);
    w->offset_y = (radius * (int32_t)cosine_q15 + 16384) >> 15;
    w->offset_x = (radius * sine_q15 + 16384) >> 15;
    w->offset_x = delta < 0 ? -w->offset_x : w->offset_x;
    w->half_q16 = (int32_t)(((uint32_t)radius * (((32768 + square_q15) * cosine_q15) >> 15)) >> 7);
    const uint32_t step = zeros < 28 ? reciprocal >> (30 - zeros) : (uint32_t)1 << 28;
    w->share_step = (int32_t)(step < (uint32_t)1 << 28 ? step : (uint32_t)1 << 28);
    const uint32_t square_cosine_q15 = (cosine_q15 * cosine_q15) >> 15;
    const int32_t across_q15 = (int32_t)((square_cosine_q15 * s_q15) >> 15);
    w->share_across = (int32_t)((uint32_t)(w->share_step >> 12) * (uint32_t)across_q15 >> 3);
    w->share_across = delta < 0 ? -w->share_across : w->share_across;
}

/* Sets ends, direction and columns. False: the line misses the bounds. */
static bool set_ends(thin_line *w, const qtri_line_job *job, const qtri_line_path *l)
{
    w->job = job;
    w->x[0] = l->steep ? l->first->at.y_24p8 : l->first->at.x_24p8;
    w->x[1] = w->x[0] + l->length;
    w->y[0] = l->minor;
    w->y[1] = l->minor + l->delta;
    w->origin_x = w->x[0];
    w->origin_y = w->y[0];
    set_direction(w, l->length, l->delta, job->smooth->radius_24p8);
    if (job->smooth->square) {
        w->x[0] -= w->offset_y; /* radius times cosine */
        w->x[1] += w->offset_y;
        w->y[0] -= w->offset_x;
        w->y[1] += w->offset_x;
    }
    const qtri_rect *bounds = &job->to->state.bounds;
    const int32_t reach = w->offset_x < 0 ? -w->offset_x : w->offset_x;
    w->steep = l->steep;
    w->bounds[0] = l->steep ? bounds->y0 : bounds->x0;
    w->bounds[1] = l->steep ? bounds->y1 : bounds->x1;
    w->bounds[2] = l->steep ? bounds->x0 : bounds->y0;
    w->bounds[3] = l->steep ? bounds->x1 : bounds->y1;
    w->inner = (w->x[0] + reach + 255) >> 8;
    w->inner_end = (w->x[1] - reach) >> 8;
    w->first = (w->x[0] - reach) >> 8;
    w->end = (w->x[1] + reach + 255) >> 8;
    const int32_t low = (qtri_least32(w->y[0], w->y[1]) - w->offset_y) >> 8;
    const int32_t high = (qtri_greatest32(w->y[0], w->y[1]) + w->offset_y) >> 8;
    w->inside = w->first >= w->bounds[0] && w->end <= w->bounds[1] && low > w->bounds[2] &&
                high + 1 < w->bounds[3];
    return w->end > w->bounds[0] && w->first < w->bounds[1] && high + 1 >= w->bounds[2] &&
           low <= w->bounds[3];
}

static void set_draw(thin_line *w)
{
    const qtri_stroke_target *to = w->job->to;
    const qtri_options *o = &to->state.options;
    const bool nearer = o->depth == QTRI_LINEAR16 && o->compare == QTRI_LESS && !o->read_only;
    if (w->look.light_table == NULL || to->alpha_q16 != 65536 || to->samples != NULL ||
        o->format != QTRI_RGB565 || o->keep || (qtri_tests_depth(o) && !nearer)) {
        w->draw = draw_any;
    } else {
        w->draw = nearer ? draw_nearer : draw_over;
    }
}

void qtri_stroke_line_draw(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                           const qtri_line_color *color)
{
    thin_line w;
    qtri_line_path l;
    qtri_line_path_init(&l, a, b);
    if (job->width_24p8 == 0 || l.length == 0 || !set_ends(&w, job, &l)) {
        return;
    }
    qtri_line_look(&w.look, job, l.first, l.last, color, l.turned);
    set_draw(&w);
    for (int32_t start = w.first; start < w.end; start += QTRI_LINE_CHUNK) {
        const int32_t end = qtri_least32(qtri_least32(start + QTRI_LINE_CHUNK, w.end), w.bounds[1]);
        const int32_t skip = qtri_greatest32(w.bounds[0] - start, 0);
        if (start + skip < end) {
            /* The near side at the start of the chunk's column, and the share at its middle. */
            const int32_t x = start * 256 - w.origin_x; /* |x| < 2^23 */
            int64_t rise = (int64_t)qtri_mul_u32(qtri_magnitude32(x), w.slope_q30);
            rise = (x < 0) == (w.slope_q16 < 0) ? rise : -rise;
            const int32_t low_q16 = w.origin_y * 256 + (int32_t)(rise >> 22) - w.half_q16;
            const int32_t share = (int32_t)(qtri_mul_s32(x + 128, w.share_step) >> 8);
            walk(&w, start + skip, end, low_q16 + skip * w.slope_q16, share + skip * w.share_step);
        }
    }
}
