/* SPDX-License-Identifier: MIT */
#include "stroke_line.h"

#include "../bits/multiply.h"
#include "../bits/reciprocal.h"
#include "../filter/mix.h"
#include "../frame/mix.h"
#include "../frame/pixel.h"
#include "line_path.h"

/* What covers a whole pixel: 256 of a width by 512 halves of 1/256 of a height. */
#define FULL  ((int32_t)256 * 512)
#define LEAST (FULL / 256) /* less is nothing */

enum {
    CELLS = 8,   /* of a column, with what follows the last */
    CHUNK = 128, /* columns after which a line starts anew: see line_path.h */
    SHARE_BITS = 14
};

/*
 * A line by its longer axis, "along", and the other, "across". Its rectangle's corners lie at an
 * end less the offset, on the near side, and at the end plus the offset, on the far one:
 * (offset_x, -offset_y) from it. 24.8 where nothing else is said.
 */
typedef struct wire {
    const qtri_line_job *job;
    int32_t x[2], y[2];         /* of the ends, along and across; x[0] < x[1] */
    int32_t origin_x, origin_y; /* of the first end, without a cap */
    int32_t slope_q16;          /* across for along: -1..1 */
    uint32_t slope_q30;         /* its magnitude */
    int32_t inverse_q8;         /* along for across, its magnitude, at most 2^22 */
    int32_t offset_x, offset_y; /* |offset_x| <= offset_y <= radius */
    int32_t half_q16;           /* of its extent across, in a column: <= sqrt(2) pixels */
    int32_t first, end;         /* columns */
    int32_t bounds[4];          /* pixels inside: along from, to; across from, to */
    bool inside;                /* all of it lies in them */
    int32_t share_step;         /* Q24 of its length a column; at most 2^28 */
    int32_t share_across;       /* the same for a pixel across */
    int32_t z_16p14, z_step;    /* at the first end; from end to end */
    int32_t light_q29, light_step;
    const qtri_line_color *from, *to; /* NULL: shares of the tint */
    uint32_t alpha_q8;                /* 256: opaque */
    uint32_t place_along, place_across;
} wire;

/*
 * Adds the area on the far side of a side that goes from `ya` to `yb`, 1/256 pixel behind the
 * column's first cell, while `dx` (signed) goes by along. Once all sides are there, the sum of all
 * cells up to one is what its pixel has, of FULL. ratio_q8: |dx| for |yb - ya|.
 */
QTRI_INLINE void add_side(int32_t *cell, int32_t dx, int32_t ya, int32_t yb, int32_t ratio_q8)
{
    int32_t k = ya >> 8;
    const int32_t last = yb >> 8;
    if (k == last) {
        const int32_t behind = dx * ((ya & 255) + (yb & 255));
        cell[k] += dx * 512 - behind;
        cell[k + 1] += behind;
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
        const int32_t part = dx < 0 ? done - upto : upto - done;
        const int32_t behind = part * (y + to);
        cell[k] += part * 512 - behind;
        cell[k + 1] += behind;
        k += step;
        y = 256 - to;
        done = upto;
    } while (k != last);
    const int32_t part = dx < 0 ? done - size : size - done;
    const int32_t behind = part * (y + yb - k * 256);
    cell[k] += part * 512 - behind;
    cell[k + 1] += behind;
}

/* An end of the rectangle, from its near corner to the far one, as far as it lies in the column. */
static void add_end(int32_t *cell, const wire *w, int end, int32_t column, int32_t base)
{
    const int32_t near_x = w->x[end] + w->offset_x;
    const int32_t near_y = w->y[end] - w->offset_y;
    const int32_t far_x = w->x[end] - w->offset_x;
    const int32_t far_y = w->y[end] + w->offset_y;
    const int32_t left = qtri_greatest32(qtri_least32(near_x, far_x), column * 256);
    const int32_t right = qtri_least32(qtri_greatest32(near_x, far_x), column * 256 + 256);
    if (left >= right) {
        return;
    }
    const bool forwards = far_x > near_x;
    const int32_t from = forwards ? left - near_x : near_x - right;
    const int32_t to = forwards ? right - near_x : near_x - left;
    const int32_t first = base * 256;
    const int32_t ya =
        qtri_least32(near_y + (int32_t)(((uint32_t)from * (uint32_t)w->inverse_q8) >> 8), far_y);
    const int32_t yb =
        qtri_least32(near_y + (int32_t)(((uint32_t)to * (uint32_t)w->inverse_q8) >> 8), far_y);
    const int32_t dx = (forwards == (end == 1)) ? right - left : left - right;
    add_side(cell, dx, ya - first, yb - first, (int32_t)(w->slope_q30 >> 22));
}

/* One of the long sides in a column where the line ends: `y` at the column's start. */
static void add_part(int32_t *cell, const wire *w, int32_t sign, int32_t column, int32_t y)
{
    const int32_t offset = sign * w->offset_x;
    const int32_t x = column * 256;
    const int32_t left = qtri_greatest32(w->x[0] + offset, x);
    const int32_t right = qtri_least32(w->x[1] + offset, x + 256);
    if (left < right) {
        const int32_t slope_q8 = w->slope_q16;
        add_side(cell, sign * (right - left), y + ((slope_q8 * (left - x)) >> 16),
                 y + ((slope_q8 * (right - x)) >> 16), w->inverse_q8);
    }
}

/* Pixels of a line on their way. */
typedef struct pixels {
    int32_t count;
    uint32_t place[QTRI_BATCH];
    uint32_t share[QTRI_BATCH]; /* of the line's length, 0..2^SHARE_BITS */
    uint32_t cover[QTRI_BATCH + 4];
} pixels;

/* Colour words of a line in colours of its own. */
static void color_words(uint32_t *word, const wire *w, const pixels *p)
{
    const qtri_colors *colors = w->job->surface->format->colors;
    const qtri_channels from = qtri_channels_from_color(colors, *w->from);
    const qtri_channels to = qtri_channels_from_color(colors, *w->to);
    for (int32_t i = 0; i < p->count; i++) {
        int32_t c[3];
        for (int k = 0; k < 3; k++) { /* 2^16 steps of 1/256 by 2^14 */
            c[k] = from.c[k] + (((to.c[k] - from.c[k]) >> 8) * (int32_t)p->share[i] >> 6);
        }
        word[i] = colors->pack(c);
    }
}

static inline uint32_t mix_channel(uint32_t over, uint32_t under, uint32_t k, uint32_t most)
{
    (void)most;
    return qtri_mix_over(over, under, k);
}

/* Stores pixels of one line, of any format. No pixel is there twice. */
QTRI_NOINLINE static void store(const wire *w, pixels *p)
{
    const qtri_surface *surface = w->job->surface;
    const qtri_format *format = surface->format;
    const qtri_pixels *memory = format->pixels;
    uint32_t word[QTRI_BATCH_ROOM] = {0};
    uint32_t under[QTRI_BATCH];
    const int32_t count = p->count;
    p->count = 0;
    if (count == 0) {
        return;
    }
    p->count = count;
    if (w->from != NULL) {
        color_words(word, w, p);
    } else {
        for (int32_t i = 0; i < count; i++) {
            word[i] = (uint32_t)(w->light_q29 + w->light_step * (int32_t)p->share[i]) >> 7;
        }
        qtri_line_tint(word, w->job, count);
    }
    for (int32_t i = 0; i < count; i++) {
        const uint32_t place = p->place[i];
        under[i] = qtri_color_of(format, memory->load(surface->pixels +
                                                      (ptrdiff_t)(place >> 16) * surface->pitch +
                                                      (ptrdiff_t)(place & 0xFFFF) * memory->bytes));
    }
    QTRI_MIX(word, under[i], count, format->colors, p->cover[i], mix_channel, qtri_mix_over_565)
    if (format->encode != NULL) {
        format->encode(word, count);
    }
    memory->scatter(surface->pixels, surface->pitch, p->place, word, count);
    p->count = 0;
}

/* What a column's pixels have in common, and where the first is. */
typedef struct column {
    uint32_t place;
    int32_t share, row; /* Q24; across */
} column;

/* Pixels of a column, from its cells. */
QTRI_INLINE void take_pixels(const wire *w, pixels *p, const int32_t *cell, const int32_t *end,
                             const column *at, bool direct)
{
    const qtri_line_job *job = w->job;
    const qtri_surface *surface = job->surface;
    const uint16_t *table = qtri_batch_table(job->batch);
    uint32_t place = at->place;
    int32_t share_q24 = at->share;
    int32_t row = at->row;
    int32_t sum = 0;
    for (; cell != end; cell++, place += w->place_across, share_q24 += w->share_across, row++) {
        sum += *cell;
        if (sum < LEAST || (!w->inside && (row < w->bounds[2] || row >= w->bounds[3]))) {
            continue;
        }
        const int32_t share =
            qtri_hold32(share_q24 >> (24 - SHARE_BITS), 0, (int32_t)1 << SHARE_BITS);
        const ptrdiff_t y = (ptrdiff_t)(place >> 16);
        const ptrdiff_t x = (ptrdiff_t)(place & 0xFFFF);
        if (job->has_depth) {
            uint16_t *depth = surface->depth + y * surface->depth_pitch + x;
            const uint32_t z = (uint32_t)(w->z_16p14 + w->z_step * share) >> 14;
            if (z - *depth - job->less >= job->passing) {
                continue;
            }
            if (job->depth_write && sum >= FULL / 2) {
                *depth = (uint16_t)z;
            }
        }
        const uint32_t cover = (uint32_t)qtri_least32(sum, FULL) * w->alpha_q8 >> 15;
        if (direct) {
            uint16_t *pixel = (uint16_t *)(void *)(surface->pixels + y * surface->pitch) + x;
            const uint32_t word =
                table[((uint32_t)(w->light_q29 + w->light_step * share) + (1u << 21)) >> 22];
            *pixel = (uint16_t)qtri_mix_over_565(word, *pixel, cover);
        } else {
            const int32_t i = p->count++;
            p->place[i] = place;
            p->share[i] = (uint32_t)share;
            p->cover[i] = cover;
        }
    }
}

/* Columns from `column` to `end`, which are of one chunk; `low` is the near side at the first. */
QTRI_INLINE void walk(const wire *w, int32_t column, int32_t end, int32_t low_q16, int32_t share,
                      bool direct)
{
    pixels p;
    const int32_t slope = w->slope_q16;
    const int32_t wide = 2 * w->half_q16 >> 8;
    const int32_t reach = w->offset_x < 0 ? -w->offset_x : w->offset_x;
    const int32_t from = (w->x[0] + reach + 255) >> 8;
    const int32_t to = (w->x[1] - reach) >> 8;
    p.count = 0;
    for (; column < end; column++, low_q16 += slope, share += w->share_step) {
        int32_t cell[CELLS] = {0};
        /* 1/32 less, for corners that were rounded. */
        const int32_t base = ((slope < 0 ? low_q16 + slope : low_q16) - 0x800) >> 16;
        const int32_t near_a = (low_q16 >> 8) - base * 256;
        const int32_t near_b = ((low_q16 + slope) >> 8) - base * 256;
        if (column >= from && column < to) {
            add_side(cell, 256, near_a, near_b, w->inverse_q8);
            add_side(cell, -256, near_a + wide, near_b + wide, w->inverse_q8);
        } else {
            add_part(cell, w, 1, column, near_a);
            add_part(cell, w, -1, column, near_a + wide);
            add_end(cell, w, 0, column, base);
            add_end(cell, w, 1, column, base);
        }
        const int32_t last = (qtri_greatest32(near_a, near_b) + wide + 8) >> 8;
        /* From the line at the column's middle to the first cell's: 1/256 pixel. */
        const int32_t middle = (low_q16 + (slope >> 1) + w->half_q16) >> 8;
        const struct column at = {(uint32_t)column * w->place_along +
                                      (uint32_t)base * w->place_across - w->job->first_place,
                                  share + (w->share_across >> 8) * (base * 256 + 128 - middle),
                                  base};
        if (!direct && p.count > QTRI_BATCH - CELLS) {
            store(w, &p);
        }
        take_pixels(w, &p, cell, cell + last + 1, &at, direct);
    }
    if (!direct) {
        store(w, &p);
    }
}

QTRI_NOINLINE static void walk_any(const wire *w, int32_t column, int32_t end, int32_t low_q16,
                                   int32_t share)
{
    walk(w, column, end, low_q16, share, false);
}

QTRI_NOINLINE static void walk_565(const wire *w, int32_t column, int32_t end, int32_t low_q16,
                                   int32_t share)
{
    walk(w, column, end, low_q16, share, true);
}

/*
 * Direction and what follows from it, of a line that is `length` along and `delta` across. Its
 * cosine is 1 / sqrt(1 + slope^2), within 2^-12 of itself.
 */
static void set_direction(wire *w, int32_t length, int32_t delta, int32_t radius)
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

/* The near side at the start of a column that begins a chunk, and the share at its middle. */
static void begin_chunk(const wire *w, int32_t column, int32_t *low_q16, int32_t *share)
{
    const int32_t x = column * 256 - w->origin_x; /* |x| < 2^23 */
    int64_t rise = (int64_t)qtri_mul_u32(qtri_magnitude32(x), w->slope_q30);
    rise = (x < 0) == (w->slope_q16 < 0) ? rise : -rise;
    *low_q16 = w->origin_y * 256 + (int32_t)(rise >> 22) - w->half_q16;
    *share = (int32_t)(qtri_mul_s32(x + 128, w->share_step) >> 8);
}

/* Ends and what they bring, by the longer axis. False: nothing is covered. */
static bool set_ends(wire *w, const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                     const qtri_line_color *color)
{
    qtri_line_path l;
    qtri_line_path_init(&l, a, b, 1, 65536);
    if (l.length == 0) {
        return false;
    }
    const int32_t z[2] = {(int32_t)((l.first->depth_16p8 & job->depth_mask) >> 8),
                          (int32_t)((l.last->depth_16p8 & job->depth_mask) >> 8)};
    w->job = job;
    w->place_along = (uint32_t)l.step;
    w->place_across = (uint32_t)l.step_minor;
    w->x[0] = l.steep ? l.first->at.y_24p8 : l.first->at.x_24p8;
    w->x[1] = w->x[0] + l.length;
    w->y[0] = l.minor;
    w->y[1] = l.minor + l.delta;
    w->origin_x = w->x[0];
    w->origin_y = w->y[0];
    w->z_16p14 = (z[0] << 6) + (1 << 13);
    w->z_step = (z[1] - z[0] + 128) >> 8;
    w->from = NULL;
    w->to = NULL;
    w->light_q29 = 0;
    w->light_step = 0;
    if (color != NULL) {
        w->from = &color[l.first != a];
        w->to = &color[l.first == a];
    } else {
        w->light_q29 = (int32_t)((uint32_t)l.first->intensity_q15 << SHARE_BITS);
        w->light_step = (int32_t)l.last->intensity_q15 - (int32_t)l.first->intensity_q15;
    }
    set_direction(w, l.length, l.delta, job->smooth->radius_24p8);
    if (job->smooth->square) {
        w->x[0] -= w->offset_y; /* radius times cosine */
        w->x[1] += w->offset_y;
        w->y[0] -= w->offset_x;
        w->y[1] += w->offset_x;
    }
    const bool steep = l.steep;
    const int32_t left = job->left_24p8 >> 8;
    const int32_t more = QTRI_STROKE_LINE_REACH >> 8;
    const int32_t top = (job->top_24p8 >> 8) + more;
    const int32_t right = left + (int32_t)(job->width_24p8 >> 8);
    const int32_t bottom = top + (int32_t)(job->height_24p8 >> 8) - 2 * more;
    const int32_t reach = w->offset_x < 0 ? -w->offset_x : w->offset_x;
    w->bounds[0] = steep ? top : left;
    w->bounds[1] = steep ? bottom : right;
    w->bounds[2] = steep ? left : top;
    w->bounds[3] = steep ? right : bottom;
    w->first = (w->x[0] - reach) >> 8;
    w->end = (w->x[1] + reach + 255) >> 8;
    const int32_t low = (qtri_least32(w->y[0], w->y[1]) - w->offset_y) >> 8;
    const int32_t high = (qtri_greatest32(w->y[0], w->y[1]) + w->offset_y) >> 8;
    w->inside = w->first >= w->bounds[0] && w->end <= w->bounds[1] && low > w->bounds[2] &&
                high + 1 < w->bounds[3];
    return w->end > w->bounds[0] && w->first < w->bounds[1] && high + 1 >= w->bounds[2] &&
           low <= w->bounds[3];
}

void qtri_stroke_line_draw(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                           const qtri_line_color *color)
{
    wire w;
    if (job->width_24p8 == 0 || !set_ends(&w, job, a, b, color)) {
        return;
    }
    const uint32_t alpha = job->smooth->alpha;
    w.alpha_q8 = alpha + (alpha >> 7);
    const bool direct = color == NULL && job->batch->has_table && qtri_is_565(job->surface->format);
    for (int32_t start = w.first; start < w.end; start += CHUNK) {
        int32_t low_q16;
        int32_t share;
        const int32_t end = qtri_least32(qtri_least32(start + CHUNK, w.end), w.bounds[1]);
        const int32_t skip = qtri_greatest32(w.bounds[0] - start, 0);
        if (start + skip >= end) {
            continue;
        }
        begin_chunk(&w, start, &low_q16, &share);
        low_q16 += skip * w.slope_q16;
        share += skip * w.share_step;
        if (direct) {
            walk_565(&w, start + skip, end, low_q16, share);
        } else {
            walk_any(&w, start + skip, end, low_q16, share);
        }
    }
}
