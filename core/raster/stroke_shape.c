/* SPDX-License-Identifier: MIT */
#include "stroke_shape.h"

#include "../bits/reciprocal.h"
#include "../bits/seed.h"

/* dx / dy in Q32, |dx| < 2^25, 0 < dy < 2^25: off by 2^-30 of itself. */
static int64_t slope_of(int32_t dx, int32_t dy)
{
    const int32_t zeros = qtri_clz32((uint32_t)dy); /* 7..31 */
    // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): dy > 0
    const int64_t product = qtri_mul_s32(dx, qtri_reciprocal_below((uint32_t)dy << zeros));
    return zeros > 30 ? product * 2 : product >> (30 - zeros);
}

/* x y / 2^30, to nearest; |y| <= 2^30. */
static int32_t times_q30(int32_t x, int32_t y_q30)
{
    return (int32_t)((qtri_mul_s32(x, y_q30) + ((int64_t)1 << 29)) >> 30);
}

/*
 * Direction and length: the difference is shifted up so far that the square of its length has 61
 * or 62 bits, which leaves the direction 30 bits of a part of any length.
 */
static void set_direction(qtri_stroke_shape *shape, int32_t dx, int32_t dy)
{
    const uint64_t square = (uint64_t)qtri_mul_s32(dx, dx) + (uint64_t)qtri_mul_s32(dy, dy);
    shape->along_x_q30 = (int32_t)1 << 30;
    shape->along_y_q30 = 0;
    shape->length = 0;
    shape->up = 0;
    shape->inverse = 0;
    shape->inverse_shift = 0;
    if (square == 0) {
        return;
    }
    const int32_t up = (qtri_clz64(square) - 2) >> 1; /* square < 2^49: 6..30 */
    const uint32_t length = (uint32_t)qtri_sqrt64_round(square << (2 * up)); /* 2^30..2^31 */
    const int32_t zeros = qtri_clz32(length | 1);                            /* 0 or 1 */
    const int32_t reciprocal = qtri_reciprocal_below(length << zeros);
    const int32_t most = (int32_t)1 << 30;
    const int64_t x = qtri_mul_s32(dx * ((int32_t)1 << up), reciprocal) >> (32 - zeros);
    const int64_t y = qtri_mul_s32(dy * ((int32_t)1 << up), reciprocal) >> (32 - zeros);
    shape->along_x_q30 = qtri_hold32((int32_t)x, -most, most);
    shape->along_y_q30 = qtri_hold32((int32_t)y, -most, most);
    shape->inverse = (uint32_t)reciprocal;
    shape->inverse_shift = (uint8_t)(46 - zeros); /* 45 or 46 */
    shape->length = length;
    shape->up = (uint8_t)up;
}

void qtri_stroke_shape_init(qtri_stroke_shape *shape, const qtri_stroke_place *place)
{
    qtri_screen_point end[2] = {place->end[0], place->end[1]};
    const int32_t radius = place->radius_24p8;
    set_direction(shape, end[1].x_24p8 - end[0].x_24p8, end[1].y_24p8 - end[0].y_24p8);
    shape->origin = end[0];
    shape->radius = radius;
    const int32_t out_x = times_q30(radius, shape->along_x_q30);
    const int32_t out_y = times_q30(radius, shape->along_y_q30);
    if (place->caps[0] == QTRI_CAP_SQUARE) {
        end[0].x_24p8 -= out_x;
        end[0].y_24p8 -= out_y;
    }
    if (place->caps[1] == QTRI_CAP_SQUARE) {
        end[1].x_24p8 += out_x;
        end[1].y_24p8 += out_y;
    }
    const bool has_disc[2] = {place->caps[0] == QTRI_CAP_ROUND, place->caps[1] == QTRI_CAP_ROUND};
    const int upper = end[1].y_24p8 < end[0].y_24p8;
    shape->a = end[upper];
    shape->b = end[1 - upper];
    shape->discs = (uint8_t)((has_disc[upper] ? 1 : 0) | (has_disc[1 - upper] ? 2 : 0));
    shape->is_disc = shape->discs == 3 && shape->length == 0;
    if (shape->is_disc) {
        shape->discs = 1; /* the same one; the rectangle has no width there */
    }
    const bool is_short = (uint64_t)radius << shape->up > shape->length && shape->length != 0;
    shape->disc_apart = 0;
    if (is_short && (shape->discs == 1 || shape->discs == 2)) {
        shape->disc_apart = shape->discs;
        shape->discs = 0;
    }
    shape->disc_level[0] = shape->disc_level[1] = INT32_MAX;
    shape->side_level[0] = shape->side_level[1] = INT32_MAX;
    /* To the left of the direction, or where that is down, so that its y is not negative. */
    shape->offset_x = out_x < 0 ? out_y : -out_y;
    shape->offset_y = out_x < 0 ? -out_x : out_x;
    const int32_t dy = shape->b.y_24p8 - shape->a.y_24p8;
    shape->slope_q32 = dy == 0 ? 0 : slope_of(shape->b.x_24p8 - shape->a.x_24p8, dy);
    shape->end_slope_q32 = shape->offset_y == 0 ? 0 : slope_of(shape->offset_x, shape->offset_y);
}

/*
 * x of a side that passes through `from`, at a level y below it, to nearest. |x| < 2^24 along the
 * side, so that the product with the slope's whole part, which may be less by 1, is below 2^25.
 */
static int32_t side_x(int32_t from_x, int32_t from_y, int64_t slope_q32, int32_t y)
{
    const int32_t down = y - from_y;
    const int32_t whole = (int32_t)(slope_q32 >> 32) * down;
    const uint64_t rest = qtri_mul_u32((uint32_t)slope_q32, (uint32_t)down);
    return from_x + whole + (int32_t)((rest + ((uint32_t)1 << 31)) >> 32);
}

int32_t qtri_stroke_line_y(const qtri_stroke_place *place, int32_t x_24p8)
{
    const int left = place->end[1].x_24p8 < place->end[0].x_24p8;
    const qtri_screen_point *a = &place->end[left];
    const qtri_screen_point *b = &place->end[1 - left];
    const int64_t slope_q32 = slope_of(b->y_24p8 - a->y_24p8, b->x_24p8 - a->x_24p8);
    return side_x(a->y_24p8, a->x_24p8, slope_q32, x_24p8); /* x and y have changed places */
}

bool qtri_stroke_shape_columns(const qtri_stroke_shape *shape, int32_t row, int32_t *first,
                               int32_t *end)
{
    const int32_t radius = shape->radius;
    const int32_t a_y = shape->a.y_24p8;
    const int32_t b_y = shape->b.y_24p8;
    const int32_t top = row * 256 - radius;
    const int32_t bottom = row * 256 + 256 + radius;
    if (b_y < top || a_y > bottom) {
        return false;
    }
    int32_t x0 = shape->a.x_24p8;
    int32_t x1 = shape->b.x_24p8;
    if (a_y < top) {
        x0 = side_x(shape->a.x_24p8, a_y, shape->slope_q32, top);
    }
    if (b_y > bottom) {
        x1 = side_x(shape->a.x_24p8, a_y, shape->slope_q32, bottom);
    }
    *first = (qtri_least32(x0, x1) - radius - 1) >> 8;
    *end = ((qtri_greatest32(x0, x1) + radius + 1) >> 8) + 1;
    return true;
}

static void widen(qtri_stroke_slice *slice, int i, int32_t left, int32_t right)
{
    slice->left[i] = qtri_least32(slice->left[i], left);
    slice->right[i] = qtri_greatest32(slice->right[i], right);
}

/* Widens the slice by an end from `y0` down to `y1`, if that is there at both levels. */
static bool add_end(qtri_stroke_slice *slice, const int32_t level[2], int32_t x, int32_t y0,
                    int32_t y1, int64_t slope_q32)
{
    if (y0 == y1 || y0 > level[0] || y1 < level[1]) {
        return false;
    }
    for (int i = 0; i < 2; i++) {
        const int32_t at = side_x(x, y0, slope_q32, level[i]);
        widen(slice, i, at, at);
    }
    return true;
}

/* The same with one of the long sides, whose last level may be known. */
static bool add_side(qtri_stroke_slice *slice, const int32_t level[2], qtri_stroke_shape *s, int k)
{
    const int32_t x = k == 0 ? s->a.x_24p8 - s->offset_x : s->a.x_24p8 + s->offset_x;
    const int32_t across = k == 0 ? -s->offset_y : s->offset_y;
    const int32_t y0 = s->a.y_24p8 + across;
    const int32_t y1 = s->b.y_24p8 + across;
    if (y0 == y1 || y0 > level[0] || y1 < level[1]) {
        return false;
    }
    for (int i = 0; i < 2; i++) {
        if (s->side_level[k] != level[i]) {
            s->side_level[k] = level[i];
            s->side_x[k] = side_x(x, y0, s->slope_q32, level[i]);
        }
        widen(slice, i, s->side_x[k], s->side_x[k]);
    }
    return true;
}

/*
 * The root of x, to nearest; below 2^24 off by less than 3/4: the estimate is within 2^-13 of
 * itself, so by half a unit of a root of 12 bits.
 */
static int32_t root_of(uint32_t radius_less, uint32_t radius_more)
{
    const uint64_t x = qtri_mul_u32(radius_less, radius_more);
    if (x >= (uint64_t)1 << 24) {
        return (int32_t)qtri_sqrt64_round(x);
    }
    if (x == 0) {
        return 0;
    }
    const int32_t zeros = qtri_clz32((uint32_t)x) & ~1; /* 8..30 */
    const uint32_t t = ((uint32_t)x << zeros) >> 16;
    const uint32_t root = (t * qtri_rsqrt_seed(t)) >> 15;
    return (int32_t)((root + ((uint32_t)1 << (zeros >> 1) >> 1)) >> (zeros >> 1));
}

/* Half of the chord of disc i at a level within it; levels follow each other. */
static int32_t half_chord(qtri_stroke_shape *shape, int i, int32_t center_y, int32_t level)
{
    if (shape->disc_level[i] != level) {
        const int32_t down = level - center_y;
        shape->disc_level[i] = level;
        shape->disc_half[i] =
            root_of((uint32_t)(shape->radius - down), (uint32_t)(shape->radius + down));
    }
    return shape->disc_half[i];
}

static bool add_disc(qtri_stroke_slice *slice, const int32_t level[2], qtri_stroke_shape *shape,
                     int i)
{
    const qtri_screen_point *center = i == 0 ? &shape->a : &shape->b;
    if (level[0] < center->y_24p8 - shape->radius || level[1] > center->y_24p8 + shape->radius) {
        return false;
    }
    for (int k = 0; k < 2; k++) {
        const int32_t half = half_chord(shape, i, center->y_24p8, level[k]);
        widen(slice, k, center->x_24p8 - half, center->x_24p8 + half);
    }
    return true;
}

bool qtri_stroke_shape_slice(qtri_stroke_shape *s, int32_t y0, int32_t y1, qtri_stroke_slice *slice)
{
    const int32_t level[2] = {y0, y1};
    const int32_t a_y = s->a.y_24p8;
    const int32_t b_y = s->b.y_24p8;
    const int32_t x = s->offset_x;
    const int32_t y = s->offset_y;
    bool found = false;
    slice->left[0] = slice->left[1] = INT32_MAX;
    slice->right[0] = slice->right[1] = INT32_MIN;
    if (s->is_disc) {
        return add_disc(slice, level, s, 0);
    }
    found |= add_side(slice, level, s, 0);
    found |= add_side(slice, level, s, 1);
    if ((s->discs & 1) != 0) {
        found |= add_disc(slice, level, s, 0);
    } else {
        found |= add_end(slice, level, s->a.x_24p8 - x, a_y - y, a_y + y, s->end_slope_q32);
    }
    if ((s->discs & 2) != 0) {
        found |= add_disc(slice, level, s, 1);
    } else {
        found |= add_end(slice, level, s->b.x_24p8 - x, b_y - y, b_y + y, s->end_slope_q32);
    }
    return found;
}

bool qtri_stroke_shape_disc(qtri_stroke_shape *s, int32_t y0, int32_t y1, qtri_stroke_slice *slice)
{
    const int32_t level[2] = {y0, y1};
    slice->left[0] = slice->left[1] = INT32_MAX;
    slice->right[0] = slice->right[1] = INT32_MIN;
    return add_disc(slice, level, s, s->disc_apart - 1);
}

void qtri_stroke_shape_breaks(const qtri_stroke_shape *s, int32_t top, uint32_t levels[8])
{
    const qtri_screen_point *const center[2] = {&s->a, &s->b};
    for (int i = 0; i < 2; i++) {
        const int32_t y = center[i]->y_24p8 - top;
        if (y + s->radius <= 0 || y - s->radius >= 256) {
            continue; /* offset_y <= radius */
        }
        const int32_t level[4] = {y - s->offset_y, y + s->offset_y, y - s->radius, y + s->radius};
        for (int k = 0; k < 4; k++) {
            if ((uint32_t)level[k] < 256) {
                levels[level[k] >> 5] |= (uint32_t)1 << (level[k] & 31);
            }
        }
    }
}
