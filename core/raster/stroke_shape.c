/* SPDX-License-Identifier: MIT */
#include "stroke_shape.h"

#include "../bits/multiply.h"
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

static void set_no_length(qtri_stroke_shape *s)
{
    s->along_x_q30 = (int32_t)1 << 30;
    s->along_y_q30 = 0;
    s->length_24p8 = 0;
    s->share_x = s->share_y = 0;
    s->share_shift = 31;
}

/*
 * Direction and length: the difference is shifted up so far that the square of its length has 61
 * or 62 bits, which leaves the direction 30 bits of a part of any length.
 *
 * A unit along is u / length of the part, u the direction: with 1 / length = reciprocal
 * 2^(up + zeros - 62), and the product of both numbers cut off by 2^31, it is
 * share 2^(up + zeros - 61).
 */
static void set_direction(qtri_stroke_shape *s, int32_t dx, int32_t dy)
{
    const uint64_t square = (uint64_t)qtri_mul_s32(dx, dx) + (uint64_t)qtri_mul_s32(dy, dy);
    if (square == 0) {
        set_no_length(s);
        return;
    }
    const int32_t up = (qtri_clz64(square) - 2) >> 1; /* square < 2^49: 6..30 */
    const uint32_t length = (uint32_t)qtri_sqrt64_round(square << (2 * up)); /* 2^30..2^31 */
    const int32_t zeros = qtri_clz32(length | 1);                            /* 0 or 1 */
    const int32_t reciprocal = qtri_reciprocal_below(length << zeros);
    const int32_t most = (int32_t)1 << 30;
    const int64_t x = qtri_mul_s32(dx * ((int32_t)1 << up), reciprocal) >> (32 - zeros);
    const int64_t y = qtri_mul_s32(dy * ((int32_t)1 << up), reciprocal) >> (32 - zeros);
    s->along_x_q30 = qtri_hold32((int32_t)x, -most, most);
    s->along_y_q30 = qtri_hold32((int32_t)y, -most, most);
    s->length_24p8 = (int32_t)((length + ((uint32_t)1 << (up - 1))) >> up);
    s->share_x = (int32_t)(qtri_mul_s32(s->along_x_q30, reciprocal) >> 31);
    s->share_y = (int32_t)(qtri_mul_s32(s->along_y_q30, reciprocal) >> 31);
    s->share_shift = (uint8_t)(37 - up - zeros); /* 6..31 */
}

enum { SHORT = 1 << 14 };

/* From ends, which of them are round, and `out`, radius times direction from a to b. */
static void set_outline(qtri_stroke_shape *s, int32_t out_x, int32_t out_y)
{
    /* To the left of the direction, or where that is down, so that its y is not negative. */
    s->offset_x = out_x < 0 ? out_y : -out_y;
    s->offset_y = out_x < 0 ? -out_x : out_x;
    const int32_t dx = s->b.x_24p8 - s->a.x_24p8;
    const int32_t dy = s->b.y_24p8 - s->a.y_24p8;
    s->slope_q32 = dy == 0 ? 0 : slope_of(dx, dy);
    s->end_slope_q32 =
        s->offset_y == 0 || (s->round_a && s->round_b) ? 0 : slope_of(s->offset_x, s->offset_y);
    s->is_short = dy < SHORT && dx < SHORT && dx > -SHORT;
    s->slope_q16 = s->is_short ? (int32_t)((s->slope_q32 + 0x8000) >> 16) : 0;
    s->top = s->a.y_24p8 - (s->round_a ? s->radius : s->offset_y);
    s->bottom = s->b.y_24p8 + (s->round_b ? s->radius : s->offset_y);
    s->level[0] = s->level[1] = s->row = INT32_MAX;
    /* To the right and down, the offset leads to the left bound; to the left, to the right one. */
    s->is_left = out_x >= 0;
}

void qtri_stroke_shape_init(qtri_stroke_shape *s, const qtri_stroke_place *place, int32_t more)
{
    qtri_screen_point end[2] = {place->end[0], place->end[1]};
    const int32_t radius = place->radius_24p8;
    set_direction(s, end[1].x_24p8 - end[0].x_24p8, end[1].y_24p8 - end[0].y_24p8);
    s->origin = end[0];
    s->radius = radius;
    s->more = (uint8_t)more;
    int32_t out_x = times_q30(radius, s->along_x_q30);
    int32_t out_y = times_q30(radius, s->along_y_q30);
    if (place->caps[0] == QTRI_CAP_SQUARE) {
        end[0].x_24p8 -= out_x;
        end[0].y_24p8 -= out_y;
    }
    if (place->caps[1] == QTRI_CAP_SQUARE) {
        end[1].x_24p8 += out_x;
        end[1].y_24p8 += out_y;
    }
    const bool is_round[2] = {place->caps[0] == QTRI_CAP_ROUND, place->caps[1] == QTRI_CAP_ROUND};
    const int upper = end[1].y_24p8 < end[0].y_24p8;
    s->a = end[upper];
    s->b = end[1 - upper];
    s->round_a = is_round[upper];
    s->round_b = is_round[1 - upper];
    s->apart = 0;
    if (s->round_a != s->round_b && s->length_24p8 != 0 && radius > s->length_24p8 - 1) {
        s->apart = s->round_a ? 1 : 2;
        s->round_a = s->round_b = false;
    }
    if (upper != 0) {
        out_x = -out_x;
        out_y = -out_y;
    }
    set_outline(s, out_x, out_y);
}

void qtri_stroke_shape_disc(qtri_stroke_shape *disc, const qtri_stroke_shape *shape)
{
    *disc = *shape;
    disc->a = shape->apart == 1 ? shape->a : shape->b;
    disc->b = disc->a;
    disc->round_a = disc->round_b = true;
    disc->apart = 0;
    set_outline(disc, shape->radius, 0);
}

/*
 * x of a side that passes through `from`, at a level y below it, to nearest. |x| < 2^24 along the
 * side, so that the product with the slope's whole part, which may be less by 1, is below 2^25.
 */
static int32_t side_x(int32_t from_x, int32_t down, int64_t slope_q32)
{
    const int32_t whole = (int32_t)(slope_q32 >> 32) * down;
    const uint64_t rest = qtri_mul_u32((uint32_t)slope_q32, (uint32_t)down);
    return from_x + whole + (int32_t)((rest + ((uint32_t)1 << 31)) >> 32);
}

/*
 * The root of x, to nearest; below 2^24 off by less than 3/4: the estimate is within 2^-13 of
 * itself, so by half a unit of a root of 12 bits.
 */
int32_t qtri_stroke_half_chord(int32_t radius, int32_t down)
{
    const uint64_t x = qtri_mul_u32((uint32_t)(radius - down), (uint32_t)(radius + down));
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

/* Half of the chord of a disc at a level, 0 outside of it. Levels follow each other. */
static int32_t half_chord(qtri_stroke_shape *s, int i, int32_t center_y, int32_t y)
{
    if (s->level[i] != y) {
        const int32_t down = y - center_y;
        s->level[i] = y;
        s->half[i] = down >= s->radius || -down >= s->radius
                         ? 0
                         : qtri_stroke_half_chord(s->radius, down) + s->more;
    }
    return s->half[i];
}

QTRI_NOINLINE static int32_t end_x(qtri_stroke_shape *s, int side, int32_t y, bool is_upper)
{
    const qtri_screen_point *center = is_upper ? &s->a : &s->b;
    if (is_upper ? s->round_a : s->round_b) {
        const int32_t half = half_chord(s, is_upper ? 0 : 1, center->y_24p8, y);
        return side == 0 ? center->x_24p8 - half : center->x_24p8 + half;
    }
    return side_x(center->x_24p8 - s->offset_x, y - (center->y_24p8 - s->offset_y),
                  s->end_slope_q32);
}

/* By how many offsets a long side is apart from the line between a and b. */
static inline int32_t side_sign(const qtri_stroke_shape *s, int side)
{
    return (side == 0) == s->is_left ? 1 : -1;
}

int32_t qtri_stroke_shape_x(qtri_stroke_shape *s, int side, int32_t y, bool below)
{
    const int32_t sign = side_sign(s, side);
    const int32_t across = sign * s->offset_y;
    const int32_t at = below ? y : y - 1; /* what is there from this level on to the next */
    if (at < s->a.y_24p8 + across) {
        return end_x(s, side, y, true);
    }
    if (at >= s->b.y_24p8 + across) {
        return end_x(s, side, y, false);
    }
    const int32_t x = s->a.x_24p8 + sign * s->offset_x;
    const int32_t down = y - (s->a.y_24p8 + across);
    /* |slope| down <= |dx| < 2^14 */
    return s->is_short ? x + ((s->slope_q16 * down + 0x8000) >> 16) : side_x(x, down, s->slope_q32);
}

/* Below y, an arc's next level around a disc, at most its bottom. */
static int32_t next_of_disc(int32_t center, int32_t radius, int32_t y)
{
    static const int16_t down[6] = {16, 64, 144, 256, 400, 576};
    const int32_t top = center - radius;
    const int32_t bottom = center + radius;
    const int32_t next = (y | 127) + 1; /* far from its top and its bottom: half a row */
    if (y < center) {
        int i = 0;
        while (i < 6 && top + down[i] <= y) {
            i++;
        }
        return qtri_least32(i < 6 ? top + down[i] : next, center);
    }
    int i = 5;
    if (bottom - down[5] > y) {
        return qtri_least32(bottom - down[5], next);
    }
    while (i >= 0 && bottom - down[i] <= y) {
        i--;
    }
    return i >= 0 ? bottom - down[i] : bottom;
}

int32_t qtri_stroke_shape_next(const qtri_stroke_shape *s, int side, int32_t y)
{
    const int32_t across = side_sign(s, side) * s->offset_y;
    const int32_t y0 = s->a.y_24p8 + across;
    const int32_t y1 = s->b.y_24p8 + across;
    if (y < y0) {
        return s->round_a ? qtri_least32(next_of_disc(s->a.y_24p8, s->radius, y), y0) : y0;
    }
    if (y < y1) {
        return y1;
    }
    return s->round_b ? next_of_disc(s->b.y_24p8, s->radius, y) : s->bottom;
}

enum { NEAR = 1 << 14 };

/* From the part's first end to a pixel's centre; below 2^25. */
static void to_pixel(const qtri_stroke_shape *s, int32_t x, int32_t y, int32_t to[2])
{
    to[0] = x * 256 + 128 - s->origin.x_24p8;
    to[1] = y * 256 + 128 - s->origin.y_24p8;
}

/* Of 24 bits, held to the part: 16 bits. */
static inline uint16_t held_share(int32_t share_q24)
{
    return (uint16_t)(share_q24 < 0 ? 0 : share_q24 >= 1 << 24 ? 65535 : share_q24 >> 8);
}

/* A share of the length a unit, of a part of a pixel or more: at most 2^30. */
static int32_t share_q38(int32_t share, int32_t shift)
{
    return shift >= 14 ? share >> (shift - 14) : share * ((int32_t)1 << (14 - shift));
}

/* Steps are counted from a multiple of 32 on, whatever a scissor leaves out. */
void qtri_stroke_shape_shares(const qtri_stroke_shape *s, int32_t x, int32_t y, int32_t count,
                              uint16_t *share_q16)
{
    const int64_t most = (int64_t)1 << 30;
    const int64_t step = (int64_t)s->share_x * 256 >> s->share_shift;
    const int32_t skip = x & 31;
    int32_t to[2];
    to_pixel(s, x - skip, y, to);
    if (s->length_24p8 >= 256 && qtri_magnitude32(to[0]) < NEAR && qtri_magnitude32(to[1]) < NEAR) {
        const int32_t x_q38 = share_q38(s->share_x, s->share_shift);
        const int32_t y_q38 = share_q38(s->share_y, s->share_shift);
        const int32_t step_q22 = x_q38 >> 8;
        int32_t share_q22 = qtri_mul_s16(x_q38, to[0]) + qtri_mul_s16(y_q38, to[1]);
        share_q22 += skip * step_q22; /* |.| < 2^30 */
        for (int32_t i = 0; i < count; i++, share_q22 += step_q22) {
            share_q16[i] = (uint16_t)(share_q22 < 0          ? 0
                                      : share_q22 >= 1 << 22 ? 65535
                                                             : share_q22 >> 6);
        }
        return;
    }
    int64_t at = (qtri_mul_s32(to[0], s->share_x) + qtri_mul_s32(to[1], s->share_y)) >>
                 s->share_shift; /* < 2^56 */
    if (s->length_24p8 >= 256) { /* no step is longer than the part: 32 of them do not lead from
                                    where it is held into it */
        int32_t share = (int32_t)(at < -most ? -most : at > most ? most : at);
        share += skip * (int32_t)step;
        for (int32_t i = 0; i < count; i++, share += (int32_t)step) {
            share_q16[i] = held_share(share);
        }
        return;
    }
    at += skip * step;
    for (int32_t i = 0; i < count; i++, at += step) {
        share_q16[i] = held_share((int32_t)(at < -most ? -most : at > most ? most : at));
    }
}

uint64_t qtri_stroke_shape_distance(const qtri_stroke_shape *s, int32_t x, int32_t y)
{
    const int32_t most = (int32_t)1 << 22;
    int32_t to[2];
    to_pixel(s, x, y, to);
    if (qtri_magnitude32(to[0]) < NEAR && qtri_magnitude32(to[1]) < NEAR) {
        const int32_t x_q15 = s->along_x_q30 >> 15;
        const int32_t y_q15 = s->along_y_q30 >> 15;
        const int32_t far = (to[0] * x_q15 + to[1] * y_q15) >> 15;
        const int32_t across = (to[1] * x_q15 - to[0] * y_q15) >> 15; /* < 2^14.5 */
        const int32_t beyond = far < 0 ? far : far > s->length_24p8 ? far - s->length_24p8 : 0;
        return (uint32_t)(beyond * beyond) + (uint32_t)(across * across); /* < 2^30 */
    }
    const int32_t along =
        (int32_t)((qtri_mul_s32(to[0], s->along_x_q30) + qtri_mul_s32(to[1], s->along_y_q30)) >>
                  30);
    const int32_t across =
        (int32_t)((qtri_mul_s32(to[1], s->along_x_q30) - qtri_mul_s32(to[0], s->along_y_q30)) >>
                  30);
    const int32_t beyond = along < 0 ? along : along > s->length_24p8 ? along - s->length_24p8 : 0;
    const int32_t dx = qtri_hold32(beyond, -most, most);
    const int32_t dy = qtri_hold32(across, -most, most);
    return (uint64_t)qtri_mul_s32(dx, dx) + (uint64_t)qtri_mul_s32(dy, dy);
}
