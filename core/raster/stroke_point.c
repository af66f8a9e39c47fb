/* SPDX-License-Identifier: MIT */
/*
 * Small round points with smooth edges: most of a cloud of points. A disc is a polygon whose
 * vertices follow from its radius alone, and are kept from point to point.
 *
 * Vertices around its top lie (k / 4)^2 pixels below it, as the levels of arcs (stroke_shape.h),
 * and at its centre; half of each chord is 1/128 pixel longer.
 */
#include "stroke.h"

/* Radii, 24.8: up to these the polygon is regular, of 8 and of 12 vertices; and the most. */
enum { SMALL = 160, MEDIUM = 400, MOST = 1024, COLUMNS = 2 * (MOST >> 8) + 2 };

/*
 * A regular polygon of the disc's area: 8 or 12 vertices, of which there are three or four from its
 * top to its side. In 2^-14 of the radius.
 */
static int32_t set_regular(qtri_stroke_ring *ring)
{
    static const uint16_t side[2][4] = {{0, 12210, 17267}, {0, 8383, 14520, 16766}};
    const uint16_t *of = side[ring->radius > SMALL];
    const int32_t last = ring->radius > SMALL ? 3 : 2;
    for (int32_t i = 0; i <= last; i++) {
        ring->at[i].y = -(((int32_t)of[last - i] * ring->radius + 8192) >> 14);
        ring->at[i].half = ((int32_t)of[i] * ring->radius + 8192) >> 14;
    }
    return last;
}

/* By levels: the number of the one at the centre. */
static int32_t set_levels(qtri_stroke_ring *ring)
{
    static const int16_t down[8] = {16, 64, 144, 256, 400, 576, 784, 1024};
    const int32_t radius = ring->radius;
    int32_t count = 1;
    ring->at[0].y = -radius;
    ring->at[0].half = 0;
    for (int i = 0; i < 8 && down[i] < radius; i++, count++) {
        ring->at[count].y = down[i] - radius;
        ring->at[count].half =
            qtri_stroke_half_chord(radius, down[i] - radius) + QTRI_STROKE_CHORDS;
    }
    ring->at[count].y = 0;
    ring->at[count].half = radius + QTRI_STROKE_CHORDS;
    return count;
}

static void set_ring(qtri_stroke_ring *ring, int32_t radius)
{
    ring->radius = radius;
    const int32_t last = radius > MEDIUM ? set_levels(ring) : set_regular(ring);
    ring->count = 2 * last + 1; /* <= 17 */
    for (int32_t i = 0; i < last; i++) {
        const int32_t height = qtri_greatest32(ring->at[i + 1].y - ring->at[i].y, 1);
        const int32_t wide = ring->at[i + 1].half - ring->at[i].half;
        const int32_t mirrored = 2 * last - i;
        ring->at[i].slope_q16 = wide * 65536 / height; /* 0 <= wide < 2^11 */
        ring->at[i].inverse_q16 = wide == 0 ? 0 : height * 65536 / wide;
        ring->at[mirrored].y = -ring->at[i].y;
        ring->at[mirrored].half = ring->at[i].half;
        ring->at[mirrored - 1].slope_q16 = -ring->at[i].slope_q16;
        ring->at[mirrored - 1].inverse_q16 = ring->at[i].inverse_q16;
    }
}

/*
 * Adds the area to the right of a side between x0 and x1, x0 <= x1, behind the first column, while
 * `height` (signed) goes by.
 */
static inline void add_side(int32_t *cover, int32_t x0, int32_t x1, int32_t height,
                            int32_t inverse_q16)
{
    int32_t column = x0 >> 8;
    if (x1 <= (column + 1) * 256) {
        const int32_t behind = height * (x0 + x1 - 512 * column);
        cover[column] += height * 512 - behind;
        cover[column + 1] += behind;
        return;
    }
    const int32_t size = height < 0 ? -height : height;
    int32_t done = 0;
    for (int32_t x = x0; x < x1; column++) {
        const int32_t to = qtri_least32((column + 1) * 256, x1);
        const int32_t upto =
            to == x1 ? size : qtri_least32(((to - x0) * inverse_q16) >> 16, size); /* < 2^31 */
        const int32_t part = height < 0 ? done - upto : upto - done;
        const int32_t behind = part * (x + to - 512 * column);
        cover[column] += part * 512 - behind;
        cover[column + 1] += behind;
        x = to;
        done = upto;
    }
}

/* Both sides of a ring's edge from level y0 to y1 below the centre; x: the centre's. */
static inline void add_edge(int32_t *cover, const qtri_stroke_ring *ring, int32_t i, int32_t x,
                            int32_t y0, int32_t y1)
{
    const int32_t slope = ring->at[i].slope_q16;
    const int32_t from = ring->at[i].half + ((slope * (y0 - ring->at[i].y) + 0x8000) >> 16);
    const int32_t to = ring->at[i].half + ((slope * (y1 - ring->at[i].y) + 0x8000) >> 16);
    const int32_t least = qtri_least32(from, to);
    const int32_t most = qtri_greatest32(from, to);
    add_side(cover, x - most, x - least, y1 - y0, ring->at[i].inverse_q16);
    add_side(cover, x + least, x + most, y0 - y1, ring->at[i].inverse_q16);
}

/* The row's pixels, whose upper side is `top` below the centre; *edge: the first that counts. */
static void cover_row(int32_t *cover, const qtri_stroke_ring *ring, int32_t *edge, int32_t x,
                      int32_t top)
{
    int32_t i = *edge;
    while (i + 1 < ring->count && ring->at[i + 1].y <= top) {
        i++;
    }
    *edge = i;
    for (; i + 1 < ring->count && ring->at[i].y < top + 256; i++) {
        add_edge(cover, ring, i, x, qtri_greatest32(ring->at[i].y, top),
                 qtri_least32(ring->at[i + 1].y, top + 256));
    }
}

/* Columns of a disc, and those of them inside the bounds. */
typedef struct columns {
    int32_t first, end;
    int32_t inside, inside_end;
} columns;

static void draw_row(qtri_stroker *stroker, const int32_t *cover, const columns *c, int32_t row)
{
    uint16_t weight[COLUMNS];
    int32_t sum = 0;
    for (int32_t x = c->first; x < c->inside_end; x++) {
        // NOLINTNEXTLINE(clang-analyzer-core.uninitialized.Assign): the caller cleared all columns
        sum += *cover++;
        if (x >= c->inside) {
            const uint32_t held = (uint32_t)qtri_hold32(sum, 0, QTRI_STROKE_FULL);
            weight[x - c->inside] = (uint16_t)qtri_stroke_weight(held, stroker->to.alpha_q16);
        }
    }
    const qtri_stroke_span span = {&stroker->to.state,        &stroker->look, c->inside, row,
                                   c->inside_end - c->inside, weight,         weight,    false};
    qtri_stroke_target_draw(&stroker->to, &span);
}

static void draw_rows(qtri_stroker *stroker, const qtri_screen_point *center)
{
    const qtri_rect *bounds = &stroker->to.state.bounds;
    const qtri_stroke_ring *ring = &stroker->ring;
    const int32_t reach = ring->at[ring->count >> 1].half;
    const int32_t top = ring->at[0].y;
    const int32_t last = qtri_least32((center->y_24p8 - top + 255) >> 8, bounds->y1);
    int32_t row = qtri_greatest32((center->y_24p8 + top) >> 8, bounds->y0);
    int32_t edge = 0;
    columns c;
    c.first = (center->x_24p8 - reach) >> 8;
    c.end = (center->x_24p8 + reach + 255) >> 8;
    c.inside = qtri_greatest32(c.first, bounds->x0);
    c.inside_end = qtri_least32(c.end, bounds->x1);
    if (c.inside >= c.inside_end) {
        return;
    }
    for (; row < last; row++) {
        int32_t cover[COLUMNS + 1];
        for (int32_t i = 0; i <= c.end - c.first; i++) {
            cover[i] = 0;
        }
        cover_row(cover, ring, &edge, center->x_24p8 - c.first * 256, row * 256 - center->y_24p8);
        draw_row(stroker, cover, &c, row);
    }
}

bool qtri_stroke_point_draw(qtri_stroker *stroker, const qtri_stroke_place *place)
{
    if (place->end[0].x_24p8 != place->end[1].x_24p8 ||
        place->end[0].y_24p8 != place->end[1].y_24p8 || place->caps[0] != QTRI_CAP_ROUND ||
        place->caps[1] != QTRI_CAP_ROUND || place->radius_24p8 > MOST) {
        return false;
    }
    if (stroker->ring.radius != place->radius_24p8) {
        set_ring(&stroker->ring, place->radius_24p8);
    }
    draw_rows(stroker, &place->end[0]);
    return true;
}
