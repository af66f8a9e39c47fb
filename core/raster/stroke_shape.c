/* SPDX-License-Identifier: MIT */
#include "stroke_shape.h"

#include "../bits/bits.h"

/* Discs ---------------------------------------------------------------------------------------- */

/*
 * Half of the chord of a disc at a level so far from its centre, |down| < radius: a root, to
 * nearest; below 2^24 off by less than 3/4: the estimate is within 2^-13 of itself, so by half a
 * unit of a root of 12 bits.
 */
static int32_t half_chord(int32_t radius, int32_t down)
{
    const uint64_t x = qtri_mul_u32((uint32_t)(radius - down), (uint32_t)(radius + down));
    if (x >= (uint64_t)1 << 24) {
        return (int32_t)qtri_sqrt64_round(x);
    }
    const int32_t zeros = qtri_clz32((uint32_t)x) & ~1; /* 8..30 */
    // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): x is not 0
    const uint32_t t = ((uint32_t)x << zeros) >> 16;
    const uint32_t root = (t * qtri_rsqrt_seed(t)) >> 15;
    return (int32_t)((root + ((uint32_t)1 << (zeros >> 1) >> 1)) >> (zeros >> 1));
}

/* Regular polygons of 8, 12 and 16 vertices serve up to these radii, 24.8. */
enum { REGULAR = 3 };
static const int16_t regular_radius[REGULAR] = {160, 400, 800};

/* Sets half chords of the n-th, from the top to the side, from a table in 2^-14 of the radius. */
static int32_t set_regular(qtri_stroke_ring *ring, int32_t n)
{
    static const uint16_t side[REGULAR][5] = {
        {0, 12210, 17267}, {0, 8383, 14520, 16766}, {0, 6351, 11736, 15334, 16597}};
    const int32_t last = n + 2;
    for (int32_t i = 0; i <= last; i++) {
        ring->half[i] = (uint16_t)((side[n][i] * ring->radius + 8192) >> 14);
    }
    return last;
}

/*
 * Chords leave out what lies between them and the arc, which 2/256 of a pixel make up for in the
 * mean. The largest disc has 64 chords.
 */
static int32_t set_levels(qtri_stroke_ring *ring)
{
    const int32_t radius = ring->radius;
    int32_t last = 0;
    for (; 16 * last * last < radius; last++) {
        const int32_t half = last == 0 ? 0 : half_chord(radius, radius - 16 * last * last) + 2;
        ring->half[last] = (uint16_t)qtri_least32(half, UINT16_MAX);
    }
    ring->half[last] = (uint16_t)qtri_least32(radius + 2, UINT16_MAX);
    return last;
}

/* How far above the centre a vertex lies: a regular polygon has its mirror image in the diagonal.
 */
static inline int32_t ring_up(const qtri_stroke_ring *ring, int32_t k)
{
    return ring->is_regular ? ring->half[ring->last - k]
           : k < ring->last ? ring->radius - 16 * k * k
                            : 0;
}

void qtri_stroke_ring_init(qtri_stroke_ring *ring, int32_t radius)
{
    int32_t n = 0;
    while (n < REGULAR && radius > regular_radius[n]) {
        n++;
    }
    ring->radius = radius;
    ring->is_regular = n < REGULAR;
    ring->last = n < REGULAR ? set_regular(ring, n) : set_levels(ring);
    for (int32_t i = 0; i < ring->last; i++) {
        const int32_t height = qtri_greatest32(ring_up(ring, i) - ring_up(ring, i + 1), 1);
        const int32_t wide = ring->half[i + 1] - ring->half[i]; /* 0..2^11 */
        ring->slope_q16[i] = wide * 65536 / height;
    }
}

/* Shapes --------------------------------------------------------------------------------------- */

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
 *
 * A unit along is u / length of the part, u the direction: with 1 / length = reciprocal
 * 2^(up + zeros - 62), and the product of both numbers cut off by 2^31, it is
 * share 2^(up + zeros - 61).
 */
static void set_direction(qtri_stroke_shape *s, int32_t dx, int32_t dy)
{
    const uint64_t square = (uint64_t)qtri_mul_s32(dx, dx) + (uint64_t)qtri_mul_s32(dy, dy);
    if (square == 0) {
        s->along_x_q30 = (int32_t)1 << 30;
        s->along_y_q30 = 0;
        s->length_24p8 = 0;
        s->share_x = s->share_y = 0;
        s->share_shift = 31;
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

/* The height of pieces of a side, 2^cut: along one x changes by at most 2^14, or it is 1. */
static uint8_t cut_of(int64_t slope_q32)
{
    const uint32_t whole = qtri_magnitude32((int32_t)(slope_q32 >> 32)) + 1; /* < 2^26 */
    return (uint8_t)qtri_greatest32(qtri_clz32(whole) - 18, 0);
}

/* Sets offset, slope, top and bottom from the ends and `out`, radius times direction, a to b. */
static void set_outline(qtri_stroke_shape *s, int32_t out_x, int32_t out_y)
{
    const int32_t reach = s->ring != NULL ? ring_up(s->ring, 0) : s->radius;
    const int32_t dy = s->b.y_24p8 - s->a.y_24p8;
    /* To the left of the direction, or where that is down, so that its y is not negative. */
    s->offset_x = out_x < 0 ? out_y : -out_y;
    s->offset_y = out_x < 0 ? -out_x : out_x;
    /* To the right and down, the offset leads to the left bound; to the left, to the right one. */
    s->is_left = out_x >= 0;
    s->slope_q32 = dy == 0 ? 0 : slope_of(s->b.x_24p8 - s->a.x_24p8, dy);
    s->cut = cut_of(s->slope_q32);
    s->top = s->a.y_24p8 - (s->round_a ? reach : s->offset_y);
    s->bottom = s->b.y_24p8 + (s->round_b ? reach : s->offset_y);
    s->piece[0].top = s->piece[1].top = INT32_MIN; /* none are found */
    s->piece[0].bottom = s->piece[1].bottom = INT32_MIN;
    s->piece[0].vertex = s->piece[1].vertex = 0;
}

void qtri_stroke_shape_init(qtri_stroke_shape *s, const qtri_stroke_place *place,
                            const qtri_stroke_ring *ring)
{
    qtri_point end[2] = {place->end[0], place->end[1]};
    set_direction(s, end[1].x_24p8 - end[0].x_24p8, end[1].y_24p8 - end[0].y_24p8);
    s->origin = end[0];
    s->radius = place->radius_24p8;
    s->ring = ring;
    int32_t out_x = times_q30(s->radius, s->along_x_q30);
    int32_t out_y = times_q30(s->radius, s->along_y_q30);
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
    set_outline(s, upper != 0 ? -out_x : out_x, upper != 0 ? -out_y : out_y);
}

/* Pieces of bounds ----------------------------------------------------------------------------- */

/*
 * x of a side that passes through `from`, at a level so far below it, to nearest. |x| < 2^24 along
 * the side, so that the product with the slope's whole part, which may be less by 1, is below 2^25.
 */
static int32_t side_x(int32_t from_x, int32_t down, int64_t slope_q32)
{
    const int32_t whole = (int32_t)(slope_q32 >> 32) * down;
    const uint64_t rest = qtri_mul_u32((uint32_t)slope_q32, (uint32_t)down);
    return from_x + whole + (int32_t)((rest + ((uint32_t)1 << 31)) >> 32);
}

/* Sets the piece at y of a side from level `top` to `bottom`. */
static void set_side(qtri_stroke_piece *p, int32_t x, int32_t top, int32_t bottom,
                     int64_t slope_q32, int cut, int32_t y)
{
    p->top = top + ((y - top) >> cut) * ((int32_t)1 << cut);
    p->bottom = qtri_least32(p->top + ((int32_t)1 << cut), bottom);
    p->x0 = side_x(x, p->top - top, slope_q32);
    p->x1 = side_x(x, p->bottom - top, slope_q32);
    p->slope_q16 = cut == 0 ? 0 : (int32_t)((slope_q32 + 0x8000) >> 16); /* < 2^29 */
}

/* Sets the piece at y of a disc's bound; sign: -1 for the left one. */
static void set_arc(qtri_stroke_piece *p, const qtri_stroke_ring *ring, const qtri_point *center,
                    int32_t sign, int32_t y)
{
    const int32_t down = y - center->y_24p8;
    const int32_t level = down < 0 ? -down : down + 1;
    int32_t k = p->vertex; /* from this to the next: up_k >= level > up_(k+1) */
    while (k > 0 && ring_up(ring, k) < level) {
        k--;
    }
    while (k + 1 < ring->last && ring_up(ring, k + 1) >= level) {
        k++;
    }
    const int32_t up = down < 0 ? -1 : 1;
    const int32_t upper = down < 0 ? k : k + 1, lower = down < 0 ? k + 1 : k; /* vertices */
    p->vertex = k;
    p->top = center->y_24p8 + up * ring_up(ring, upper);
    p->bottom = center->y_24p8 + up * ring_up(ring, lower);
    p->x0 = center->x_24p8 + sign * ring->half[upper];
    p->x1 = center->x_24p8 + sign * ring->half[lower];
    p->slope_q16 = -up * sign * ring->slope_q16[k];
}

/* Clips a piece to levels `top` to `bottom`. */
static void cut_piece(qtri_stroke_piece *p, int32_t top, int32_t bottom)
{
    if (bottom < p->bottom) {
        p->x1 = qtri_stroke_piece_x(p, bottom);
        p->bottom = bottom;
    }
    if (top > p->top) {
        p->x0 = qtri_stroke_piece_x(p, top);
        p->top = top;
    }
}

/* Sets the piece at y of the bound around an end, from `top` to `bottom`. */
static void set_end(qtri_stroke_shape *s, int side, bool is_upper, int32_t top, int32_t bottom,
                    int32_t y)
{
    qtri_stroke_piece *p = &s->piece[side];
    const qtri_point *center = is_upper ? &s->a : &s->b;
    const int32_t sign = side == 0 ? -1 : 1;
    if (!(is_upper ? s->round_a : s->round_b)) {
        const int64_t slope_q32 = slope_of(s->offset_x, s->offset_y); /* below a corner: not 0 */
        set_side(p, center->x_24p8 - s->offset_x, center->y_24p8 - s->offset_y, bottom, slope_q32,
                 cut_of(slope_q32), y);
    } else if (s->ring != NULL) {
        set_arc(p, s->ring, center, sign, y);
        cut_piece(p, top, bottom);
    } else {
        const int32_t down = y - center->y_24p8;
        const bool is_inside = -down < s->radius; /* and down is less, above s->bottom */
        p->top = y;
        p->bottom = y + 1;
        p->x0 = center->x_24p8 + (is_inside ? sign * half_chord(s->radius, down) : 0);
        p->x1 = p->x0;
        p->slope_q16 = 0;
    }
}

void qtri_stroke_shape_find(qtri_stroke_shape *s, int side, int32_t y)
{
    const int32_t sign = (side == 0) == s->is_left ? 1 : -1; /* of the offset, on this bound */
    const int32_t y0 = s->a.y_24p8 + sign * s->offset_y;
    const int32_t y1 = s->b.y_24p8 + sign * s->offset_y;
    if (y < y0) {
        set_end(s, side, true, s->top, y0, y);
    } else if (y >= y1) {
        set_end(s, side, false, y1, s->bottom, y);
    } else {
        set_side(&s->piece[side], s->a.x_24p8 + sign * s->offset_x, y0, y1, s->slope_q32, s->cut,
                 y);
    }
}

/* Along a part --------------------------------------------------------------------------------- */

enum { NEAR = 1 << 14 };

/* From the part's first end to a pixel's centre; below 2^25. */
static void to_pixel(const qtri_stroke_shape *s, int32_t x, int32_t y, int32_t to[2])
{
    to[0] = x * 256 + 128 - s->origin.x_24p8;
    to[1] = y * 256 + 128 - s->origin.y_24p8;
}

/* share_x or share_y in Q38, of a part at least a pixel long: at most 2^30. */
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
    at += skip * step;
    for (int32_t i = 0; i < count; i++, at += step) {
        share_q16[i] = qtri_stroke_clamped_share((int32_t)(at < -most  ? -most
                                                           : at > most ? most
                                                                       : at));
    }
}

uint64_t qtri_stroke_shape_distance(const qtri_stroke_shape *s, int32_t x, int32_t y)
{
    const int32_t most = (int32_t)1 << 22;
    int32_t to[2];
    to_pixel(s, x, y, to);
    if (qtri_magnitude32(to[0]) < NEAR && qtri_magnitude32(to[1]) < NEAR) {
        const int32_t x_q15 = s->along_x_q30 >> 15, y_q15 = s->along_y_q30 >> 15;
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
    const int32_t dx = qtri_hold32(beyond, -most, most), dy = qtri_hold32(across, -most, most);
    return (uint64_t)qtri_mul_s32(dx, dx) + (uint64_t)qtri_mul_s32(dy, dy);
}
