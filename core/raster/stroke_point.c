/* SPDX-License-Identifier: MIT */
/*
 * Points: discs and squares of up to 32 pixels, without a union of parts.
 *
 * With the origin in a point's centre, let A(x, y) be the area of the point between both axes and
 * the corner (x, y), with the sign of x y. Between columns x0, x1 and rows y0, y1 the point covers
 *
 *     A(x1, y1) - A(x0, y1) - A(x1, y0) + A(x0, y0).
 *
 * A corner inside has |A| = |x y|. One that is outside of the disc, within its square, cuts off two
 * areas that do not overlap, that right of it and that above: |A| = S(x) + S(y) - S(r), where S(t)
 * is the area of the quarter disc from its axis to t. With x and y held to +-r this serves for all
 * corners, and each pixel costs one of them.
 *
 * S, of a table, is off by 2 10^-5 r^2 at most, and a pixel at an axis has that twice: 1/100 of a
 * pixel for the largest disc.
 */
#include "stroke.h"

#include "../bits/bits.h"

enum {
    COLUMNS = 33, /* of the widest point */
    WEIGHTS = 200 /* of a block: all of a point of 13 pixels */
};

/* A line between columns, from the centre, and the corner where it crosses a row's. */
typedef struct corner {
    int32_t x;      /* held to the radius */
    int32_t square; /* of x */
    int32_t area;   /* S(|x|), 2^-16 */
    int32_t above;  /* A at the line above, less A there of the column before */
} corner;

/* S of the unit disc, 2^-16: in 128ths, and from 7/8 on in 512ths. */
enum { FINE = 112 };
/* clang-format off */
static const uint16_t sector[FINE + 65] = {
    0, 512, 1024, 1536, 2048, 2559, 3071, 3582, 4093, 4604, 5115, 5625,
    6135, 6645, 7154, 7662, 8171, 8678, 9186, 9692, 10198, 10704, 11208, 11712,
    12216, 12718, 13220, 13721, 14221, 14720, 15218, 15715, 16212, 16707, 17201, 17694,
    18186, 18677, 19166, 19655, 20142, 20627, 21112, 21595, 22076, 22556, 23035, 23512,
    23987, 24461, 24933, 25404, 25872, 26339, 26804, 27268, 27729, 28189, 28646, 29101,
    29555, 30006, 30455, 30902, 31346, 31788, 32228, 32666, 33101, 33533, 33963, 34391,
    34815, 35237, 35656, 36073, 36486, 36897, 37304, 37709, 38110, 38508, 38903, 39294,
    39682, 40067, 40448, 40825, 41199, 41569, 41935, 42297, 42655, 43009, 43359, 43704,
    44045, 44381, 44713, 45040, 45362, 45679, 45991, 46298, 46599, 46895, 47184, 47468,
    47746, 48018, 48283, 48542, 48793, 48855, 48916, 48977, 49037, 49097, 49156, 49215,
    49274, 49332, 49389, 49446, 49503, 49559, 49614, 49669, 49723, 49777, 49831, 49883,
    49935, 49987, 50038, 50089, 50139, 50188, 50237, 50285, 50332, 50379, 50425, 50471,
    50516, 50560, 50603, 50646, 50688, 50730, 50770, 50810, 50849, 50888, 50925, 50962,
    50998, 51033, 51067, 51100, 51132, 51163, 51194, 51223, 51251, 51278, 51304, 51328,
    51351, 51373, 51394, 51412, 51429, 51444, 51457, 51467, 51472,
};
/* clang-format on */

/* S(x), 0 <= x <= radius. */
static inline int32_t area_to(const qtri_stroke_disc *disc, int32_t x)
{
    const uint32_t fine_q30 = (uint32_t)FINE << 23;
    uint32_t at = (uint32_t)x * disc->inverse_q30; /* < 2^30 */
    at = at < fine_q30 ? at : 4 * at - 3 * fine_q30;
    const uint16_t *s = &sector[at >> 23];
    const uint32_t unit_q16 = s[0] + (((uint32_t)(s[1] - s[0]) * (at >> 7 & 0xFFFFu)) >> 16);
    // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): down is 7..31
    return (int32_t)((unit_q16 * disc->square) >> disc->down);
}

static void disc_init(qtri_stroke_disc *disc, int32_t radius)
{
    const uint32_t square = (uint32_t)(radius * radius); /* <= 2^24 */
    const int32_t zeros = qtri_clz32((uint32_t)radius);  /* 19..31 */
    const int32_t up = qtri_clz32(square) - 16;          /* to 16 bits: -9..15 */
    disc->radius = (uint16_t)radius;                     /* <= QTRI_STROKE_POINT_RADIUS */
    /* NOLINTBEGIN(clang-analyzer-core.UndefinedBinaryOperatorResult): a radius is not 0 */
    /* Less than 2^30 / radius: 4 units are what the reciprocal may be off by. */
    disc->inverse_q30 = (qtri_reciprocal_near((uint32_t)radius << zeros) - 5) >> (32 - zeros);
    disc->square = up < 0 ? square >> -up : square << up;
    disc->down = (uint16_t)(16 + up);
    disc->area = area_to(disc, radius);
    /* NOLINTEND(clang-analyzer-core.UndefinedBinaryOperatorResult) */
}

/* A line between rows, from the centre. */
typedef struct line {
    int32_t y;    /* held to the radius */
    int32_t rest; /* corners whose square is not greater are inside */
    int32_t area; /* S(|y|) - S(r) */
} line;

static inline line line_at(const qtri_stroke_disc *disc, int32_t y, bool is_round)
{
    const int32_t radius = disc->radius;
    const int32_t size = qtri_least32(y < 0 ? -y : y, radius);
    const int32_t square = radius * radius;
    const line at = {y < 0 ? -size : size, is_round ? square - size * size : square,
                     is_round && size < radius ? area_to(disc, size) - disc->area : 0};
    return at;
}

/* A(x, y) */
static inline int32_t area_at(const corner *c, const line *at)
{
    // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): all columns are set
    const int32_t sign = (c->x ^ at->y) >> 31;
    return c->square <= at->rest ? c->x * at->y : ((c->area + at->area) ^ sign) - sign;
}

/* See qtri_stroke_weight(): half of a pixel is QTRI_STROKE_WRITES already, and 65535 is all. */
static inline uint16_t weight_of(int32_t cover_q16, uint32_t alpha_q16)
{
    const uint32_t cover = (uint32_t)cover_q16;
    const uint32_t weight = ((cover >> 1) * alpha_q16 + ((uint32_t)1 << 22)) >> 23; /* < 2^32 */
    return (uint16_t)(weight | (cover & QTRI_STROKE_WRITES));
}

void qtri_stroke_point_cover(qtri_stroke_disc *disc, const qtri_stroke_block *b, uint32_t alpha_q16,
                             uint16_t *weight)
{
    corner column[COLUMNS + 1];
    const int32_t radius = b->radius;
    if (disc->radius != radius) {
        disc_init(disc, radius);
    }
    const bool is_round = b->is_round;
    const corner *const end = &column[b->count];
    const line top = line_at(disc, b->y, is_round);
    int32_t before = 0;
    int32_t x = b->x;
    for (corner *c = column; c <= end; c++, x += 256) {
        const int32_t size = qtri_least32(x < 0 ? -x : x, radius);
        c->x = x < 0 ? -size : size;
        c->square = size * size;
        c->area = size < radius && is_round ? area_to(disc, size) : disc->area;
        const int32_t area = area_at(c, &top);
        c->above = area - before;
        before = area;
    }
    int32_t y = b->y;
    for (int32_t row = b->rows; row > 0; row--) {
        y += 256;
        const line at = line_at(disc, y, is_round);
        before = area_at(column, &at);
        for (corner *c = &column[1]; c <= end; c++) {
            const int32_t area = area_at(c, &at);
            const int32_t grown = area - before;
            *weight++ = weight_of(qtri_hold32(grown - c->above, 0, 65535), alpha_q16);
            c->above = grown;
            before = area;
        }
    }
}

/* Hard edges: pixels whose centres lie inside. */
static void cover_centers(const qtri_stroke_block *b, uint16_t all, uint16_t *weight)
{
    const int32_t radius = b->radius;
    const int32_t square = radius * radius;
    for (int32_t row = 0; row < b->rows; row++) {
        const int32_t y = b->y + 256 * row + 128;
        for (int32_t column = 0; column < b->count; column++) {
            const int32_t x = b->x + 256 * column + 128;
            const bool is_inside =
                b->is_round ? x * x + y * y < square + (x < 0) /* on the rim: its left half */
                            : x >= -radius && x < radius && y >= -radius && y < radius;
            *weight++ = is_inside ? all : 0;
        }
    }
}

void qtri_stroker_draw_point(qtri_stroker *stroker, const qtri_point *center, int32_t radius,
                             bool is_round)
{
    const qtri_rect *bounds = &stroker->to.state.bounds;
    const int32_t x = center->x_24p8, y = center->y_24p8;
    const int32_t x0 = qtri_greatest32((x - radius) >> 8, bounds->x0);
    const int32_t y0 = qtri_greatest32((y - radius) >> 8, bounds->y0);
    const int32_t x1 = qtri_least32((x + radius + 255) >> 8, bounds->x1);
    const int32_t y1 = qtri_least32((y + radius + 255) >> 8, bounds->y1);
    if (x0 >= x1 || y0 >= y1) {
        return;
    }
    uint16_t weight[WEIGHTS];
    const uint32_t alpha_q16 = stroker->to.alpha_q16;
    qtri_stroke_block block = {x0 * 256 - x, y0 * 256 - y, x1 - x0, y1 - y0, radius, is_round};
    qtri_stroke_span span = {&stroker->to.state, &stroker->look, x0,     y0,
                             block.count,        block.rows,     weight, weight};
    while (span.rows * span.count > WEIGHTS) {
        span.rows = (span.rows + 1) >> 1;
    }
    while (span.y < y1) {
        block.rows = span.rows = qtri_least32(span.rows, y1 - span.y);
        if (stroker->edges != NULL) {
            stroker->edges->cover_point(&stroker->disc, &block, alpha_q16, weight);
        } else {
            cover_centers(&block, (uint16_t)qtri_stroke_weight(QTRI_COVERAGE_FULL, alpha_q16),
                          weight);
        }
        qtri_stroke_target_draw(&stroker->to, &span);
        span.y += span.rows;
        block.y += span.rows * 256;
    }
}
