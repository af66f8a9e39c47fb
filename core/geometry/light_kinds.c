/* SPDX-License-Identifier: MIT */
/*
 * Kinds of light: directional, point and spot. A program links those that its sources name.
 */
#include "../bits/bits.h"
#include "../math/q16_trig.h"
#include "illumination.h"

/* ---- What kinds of light share ---- */

/* From this 1 - cosine on a highlight is 0; 0 without a table. */
static inline uint32_t highlight_end_q29(const qtri_shininess *table)
{
    return table == NULL ? 0 : (uint32_t)table->count << table->shift;
}

/* 1 - a . b of two unit vectors: |a - b|^2 / 2. |a| + |b| < 4 in Q14. */
static inline uint32_t distance_q29(const int32_t a[3], const int32_t b[3])
{
    const uint32_t x = (uint32_t)(a[0] - b[0]); /* squares fit 32 bits, unsigned */
    const uint32_t y = (uint32_t)(a[1] - b[1]);
    const uint32_t z = (uint32_t)(a[2] - b[2]);
    return x * x + y * y + z * z;
}

static inline int32_t dot_q28(const int32_t a_q14[3], const int32_t b_q14[3])
{
    return a_q14[0] * b_q14[0] + a_q14[1] * b_q14[1] + a_q14[2] * b_q14[2];
}

/* sum += color share, each product 2^28 at most. */
static inline void add_light(uint32_t sum_q24[3], const uint32_t color_q12[3], uint32_t share_q12)
{
    sum_q24[0] += color_q12[0] * share_q12;
    sum_q24[1] += color_q12[1] * share_q12;
    sum_q24[2] += color_q12[2] * share_q12;
}

/* ---- Directional lights ---- */

/*
 * A half of 0, where light comes from behind what is looked at, is far from all unit vectors: its
 * distance is more than 1.8, which is beyond the table, and its square below 2^32.
 */
static bool prepare_directional(qtri_source *out, const qtri_light_source *source,
                                const qtri_light_space *space)
{
    qtri_light_color_q12(out->color_q12, &source->color);
    if (!qtri_light_direction(out->at, space, &source->position)) {
        return false;
    }
    int64_t half[3];
    for (int i = 0; i < 3; i++) {
        half[i] = out->at[i] + space->view_q14[i];
    }
    if (!qtri_direction_q14(out->of.half_q14, half)) {
        out->of.half_q14[0] = 46340;
    }
    return true;
}

/* Adds a highlight at 1 - n . h. Out of line: most vertices are outside of most highlights. */
QTRI_NOINLINE static void add_highlight(const qtri_source *at, qtri_lit_point *point,
                                        uint32_t apart_q29)
{
    const uint32_t power_q15 = qtri_shininess_at(point->by->shininess, apart_q29);
    add_light(point->specular_q24, at->color_q12, power_q15 >> 3);
}

static void add_directional(const qtri_source *first, const qtri_source *end, qtri_lit_point *point)
{
    const int32_t n[3] = {point->normal_q14[0], point->normal_q14[1], point->normal_q14[2]};
    uint32_t sum_q24[3] = {point->diffuse_q24[0], point->diffuse_q24[1], point->diffuse_q24[2]};
    const uint32_t end_q29 = highlight_end_q29(point->by->shininess);
    for (const qtri_source *at = first; at != end; at++) {
        const int32_t cosine_q28 = dot_q28(n, at->at);
        if (cosine_q28 <= 0) {
            continue;
        }
        add_light(sum_q24, at->color_q12, (uint32_t)cosine_q28 >> 16);
        const uint32_t apart_q29 = distance_q29(n, at->of.half_q14);
        if (apart_q29 < end_q29) {
            add_highlight(at, point, apart_q29);
        }
    }
    point->diffuse_q24[0] = sum_q24[0];
    point->diffuse_q24[1] = sum_q24[1];
    point->diffuse_q24[2] = sum_q24[2];
}

const qtri_light_kind qtri_directional_light = {.prepare = prepare_directional,
                                                .add = add_directional};

/* ---- What point and spot lights share ---- */

/* The way from a vertex to a source. */
typedef struct light_way {
    int32_t direction_q14[3];
    int32_t cosine_q28;  /* between the normal and the direction, > 0 */
    uint32_t distance16; /* below 2^16; times 2^exponent, in local units */
    int32_t exponent;
} light_way;

/* The intensity of a source at a distance: 1 / attenuation, 2^-10..16. */
typedef struct light_fade {
    uint32_t mantissa;
    int32_t shift; /* intensity = mantissa 2^-(shift - 3); mantissa <= 2^16, shift 15..28 */
} light_fade;

/* point->place from source->at in one scale, where they have two: the finer one gives way. The
   exponent of the difference is returned. */
static int32_t subtract_scaled(int32_t d[3], const qtri_source *source, const qtri_lit_point *point)
{
    const int32_t exponent = qtri_greatest32(source->of.far.exponent, point->exponent);
    const int32_t source_shift = qtri_least32(exponent - source->of.far.exponent, 31);
    const int32_t point_shift = qtri_least32(exponent - point->exponent, 31);
    for (int i = 0; i < 3; i++) {
        d[i] = (source->at[i] >> source_shift) - (point->place[i] >> point_shift);
    }
    return exponent;
}

/*
 * False: the source is behind the surface or at the vertex itself.
 *
 * |d| <= 2^30; its largest part gets 15 bits, so q = d . d is in [2^28, 3 2^30]. With v = q 4^even
 * / 2^32 in [1/4, 1) and y = v^-1/2 in Q15, within 2^-13: |d| = 2^16 v y 2^-even / 2^15, and
 * d / |d| = d y 2^even / 2^31.
 */
QTRI_IN_PLACE bool find_way(light_way *way, const qtri_source *source, const qtri_lit_point *point)
{
    int32_t d[3];
    int32_t exponent = point->exponent;
    if (source->of.far.exponent == exponent) {
        d[0] = source->at[0] - point->place[0];
        d[1] = source->at[1] - point->place[1];
        d[2] = source->at[2] - point->place[2];
    } else {
        exponent = subtract_scaled(d, source, point);
    }
    const uint32_t all =
        (uint32_t)((d[0] ^ (d[0] >> 31)) | (d[1] ^ (d[1] >> 31)) | (d[2] ^ (d[2] >> 31)));
    const int32_t zeros = qtri_clz32(all | 1u); /* >= 1 */
    d[0] = (int32_t)((uint32_t)d[0] << (zeros - 1)) >> 16;
    d[1] = (int32_t)((uint32_t)d[1] << (zeros - 1)) >> 16;
    d[2] = (int32_t)((uint32_t)d[2] << (zeros - 1)) >> 16;
    uint32_t square = qtri_square_q28(d);
    if (square == 0) {
        return false;
    }
    int32_t even = 0;
    if (square >> 30 == 0) {
        square <<= 2;
        even = 1;
    }
    const uint32_t y_q15 = qtri_rsqrt_seed_in_place(square >> 16);
    const int32_t y_q14 = (int32_t)(y_q15 >> 1);
    const int32_t down = 16 - even;
    way->direction_q14[0] = (d[0] * y_q14) >> down;
    way->direction_q14[1] = (d[1] * y_q14) >> down;
    way->direction_q14[2] = (d[2] * y_q14) >> down;
    way->cosine_q28 = dot_q28(point->normal_q14, way->direction_q14);
    if (way->cosine_q28 <= 0) {
        return false;
    }
    way->distance16 = ((square >> 16) * y_q15) >> 15; /* <= 0xFFFD, of all v */
    way->exponent = exponent + 17 - zeros - even;
    return true;
}

/* x 2^shift, for shift < -1; 0 for x = 0, whose shift is NEVER. */
static inline uint32_t scaled(uint32_t x, int32_t shift)
{
    return shift <= -32 ? 0 : x >> -shift;
}

/*
 * Finds a source's intensity at this distance; false: it is less than 2^-10.
 *
 * The sum is the attenuation, Q19: 2^15, for 16, to 2^29, for 2^-10. Factors have 16 bits, so a
 * product that is not 0 is 2^30 at least: without two bits to be cut off it is 2^29 or more.
 */
QTRI_IN_PLACE bool find_fade(light_fade *fade, const qtri_source *source, const light_way *way)
{
    const uint32_t m = way->distance16;
    const int32_t linear_shift = source->of.far.linear_up + way->exponent;
    const int32_t quadratic_shift = source->of.far.quadratic_up + 2 * way->exponent;
    if (linear_shift >= -1 || quadratic_shift >= -1) {
        return false;
    }
    uint32_t sum_q19 = source->of.far.constant_q19;
    sum_q19 += scaled(source->of.far.linear * m, linear_shift);
    sum_q19 += scaled(source->of.far.quadratic * ((m * m) >> 16), quadratic_shift);
    if (sum_q19 >> 29 != 0) {
        return false;
    }
    sum_q19 = sum_q19 >> 15 == 0 ? (uint32_t)1 << 15 : sum_q19;
    const int32_t zeros = qtri_clz32(sum_q19); /* 3..16 */
    fade->mantissa = qtri_reciprocal_seed_newton((sum_q19 << zeros) >> 16);
    fade->shift = 31 - zeros;
    return true;
}

/*
 * The highlight at a point: its table at 1 - n . h, h the direction of l + v, |l + v| <= 2^15.
 * Where its square is below 2^16 the source is behind what is looked at, in line with the eye: no
 * direction is good enough, and there is no highlight. 4^up squares are in [2^28, 2^30].
 */
QTRI_IN_PLACE uint32_t highlight_q15(const qtri_lit_point *point, const int32_t direction_q14[3])
{
    int32_t h[3];
    h[0] = direction_q14[0] + point->by->view_q14[0];
    h[1] = direction_q14[1] + point->by->view_q14[1];
    h[2] = direction_q14[2] + point->by->view_q14[2];
    uint32_t square = qtri_square_q28(h);
    if (square >> 16 == 0) {
        return 0;
    }
    /* Most points are outside of a highlight: (n . h)^2 tells, while it is precise. */
    const int32_t along_q15 = dot_q28(point->normal_q14, h) >> 14; /* <= |l + v| */
    if (along_q15 <= 0 ||
        (square >> 28 != 0 &&
         (uint32_t)(along_q15 * along_q15) < (square >> 15) * point->by->shininess->least_q15)) {
        return 0;
    }
    int32_t down = 16;
    for (; square >> 28 == 0; square <<= 2) {
        down--;
    }
    const uint32_t v_q16 = square >> 14;
    const int32_t y_q15 = (int32_t)qtri_rsqrt_seed_in_place(v_q16 > 0xFFFFu ? 0xFFFFu : v_q16);
    h[0] = (h[0] * y_q15) >> down;
    h[1] = (h[1] * y_q15) >> down;
    h[2] = (h[2] * y_q15) >> down;
    return qtri_shininess_at(point->by->shininess, distance_q29(point->normal_q14, h));
}

/* Adds the diffuse and specular light of a source in this direction. */
QTRI_IN_PLACE void add_faded(qtri_lit_point *point, const qtri_source *source, const light_way *way,
                             const light_fade *fade)
{
    const uint32_t cosine_q15 = (uint32_t)way->cosine_q28 >> 13; /* <= 2^15 (1 + 2^-12) */
    add_light(point->diffuse_q24, source->color_q12, (fade->mantissa * cosine_q15) >> fade->shift);
    if (point->by->shininess != NULL) {
        const uint32_t power_q15 = highlight_q15(point, way->direction_q14);
        if (power_q15 != 0) {
            add_light(point->specular_q24, source->color_q12,
                      (fade->mantissa * power_q15) >> fade->shift);
        }
    }
}

/* ---- Point lights ---- */

enum { NEVER = -4096 }; /* `up` of a factor that is 0 */

/* x as 16 bits times 2^up; in Q19, times 2^more. */
static uint32_t set_part(const qtri_wide *x, int32_t more, int32_t *up)
{
    if (x->m <= 0) {
        *up = NEVER;
        return 0;
    }
    *up = 46 - x->e + 19 + more;
    return (uint32_t)(x->m >> 46);
}

/* x, at least 0, divided by `by`. */
static qtri_wide fraction_of(q16 x, const qtri_wide *by)
{
    qtri_wide fraction = qtri_wide_make(x < 0 ? 0 : x, 16);
    qtri_wide_div_by(&fraction, by);
    return fraction;
}

/* Attenuation and color are divided by the largest channel, so that color is 1 at most. */
static bool prepare_point(qtri_source *out, const qtri_light_source *source,
                          const qtri_light_space *space)
{
    qtri_light_color color = source->color;
    const q16 most =
        qtri_hold32(qtri_greatest32(color.r, qtri_greatest32(color.g, color.b)), 0, 16 * Q16_ONE);
    if (most == 0) {
        return false;
    }
    const q16 channel[3] = {color.r, color.g, color.b};
    for (int i = 0; i < 3; i++) {
        const uint32_t held = (uint32_t)qtri_hold32(channel[i], 0, most);
        bool half;
        const uint64_t share = qtri_divide64(held, (uint32_t)most, 12, &half);
        out->color_q12[i] = (uint32_t)share + (half ? 1u : 0u);
    }
    const qtri_wide by = qtri_wide_make(most, 16);
    const qtri_wide constant = fraction_of(source->constant, &by);
    qtri_wide linear = fraction_of(source->linear, &by);
    qtri_wide quadratic = fraction_of(source->quadratic, &by);
    qtri_wide_mul_by(&linear, &space->unit);
    qtri_wide_mul_by(&quadratic, &space->unit);
    qtri_wide_mul_by(&quadratic, &space->unit);
    qtri_light_place(out->at, &out->of.far.exponent, space, &source->position);
    out->of.far.linear = set_part(&linear, 0, &out->of.far.linear_up);
    out->of.far.quadratic = set_part(&quadratic, 16, &out->of.far.quadratic_up);
    int32_t up;
    const uint32_t mantissa = set_part(&constant, 0, &up);
    out->of.far.constant_q19 = up <= -16  ? 0
                               : up < 0   ? mantissa >> -up
                               : up <= 13 ? mantissa << up
                                          : (uint32_t)1 << 29;
    return true;
}

static void add_point(const qtri_source *first, const qtri_source *end, qtri_lit_point *point)
{
    for (const qtri_source *at = first; at != end; at++) {
        light_way way;
        light_fade fade;
        if (find_way(&way, at, point) && find_fade(&fade, at, &way)) {
            add_faded(point, at, &way, &fade);
        }
    }
}

const qtri_light_kind qtri_point_light = {.prepare = prepare_point, .add = add_point};

/* ---- Spot lights ---- */

/* 1 - cos(angle), for an angle held to 0..180 degrees. */
static uint32_t apart_q29(q16 degrees)
{
    int32_t sine_q30;
    int32_t cosine_q30;
    qtri_sincos_deg_q30(qtri_hold32(degrees, 0, 180 * Q16_ONE), &sine_q30, &cosine_q30);
    return ((uint32_t)((int32_t)1 << 30) - (uint32_t)cosine_q30 + 1u) >> 1; /* 0..2^30 */
}

static bool prepare_spot(qtri_source *out, const qtri_light_source *source,
                         const qtri_light_space *space)
{
    if (!qtri_light_direction(out->axis_q14, space, &source->direction) ||
        !prepare_point(out, source, space)) {
        return false;
    }
    const uint32_t inner = apart_q29(source->inner);
    out->outer_q29 = apart_q29(source->outer);
    const uint32_t least = (uint32_t)1 << 21; /* 1/256 */
    const uint32_t penumbra =
        out->outer_q29 >= inner + least ? out->outer_q29 - inner : least; /* <= 2^30 */
    out->penumbra_shift = qtri_greatest32(16 - qtri_clz32(penumbra), 0);  /* 6..15 */
    out->penumbra_inverse = qtri_reciprocal_seed_newton(penumbra >> out->penumbra_shift);
    out->falloff = source->falloff;
    return true;
}

/* The fraction, Q15, of a spot's light that goes in a direction: 1 inside, 0 outside its cone. */
static uint32_t cone_q15(const qtri_source *source, const light_way *way)
{
    const int32_t from[3] = {-way->direction_q14[0], -way->direction_q14[1],
                             -way->direction_q14[2]};
    const uint32_t apart = distance_q29(from, source->axis_q14);
    if (apart >= source->outer_q29) {
        return 0;
    }
    /* Within 2^31 / inverse of the penumbra's end it is this share of it. */
    const uint32_t inside = (source->outer_q29 - apart) >> source->penumbra_shift; /* <= 2^16 */
    uint32_t share_q15 = inside >> 16 != 0 ? 0x8000u : (inside * source->penumbra_inverse) >> 16;
    share_q15 = share_q15 > 0x8000u ? 0x8000u : share_q15;
    return source->falloff == NULL ? share_q15
                                   : (share_q15 * qtri_shininess_at(source->falloff, apart)) >> 15;
}

static void add_spot(const qtri_source *first, const qtri_source *end, qtri_lit_point *point)
{
    for (const qtri_source *at = first; at != end; at++) {
        light_way way;
        light_fade fade;
        if (!find_way(&way, at, point)) {
            continue;
        }
        const uint32_t share_q15 = cone_q15(at, &way);
        if (share_q15 != 0 && find_fade(&fade, at, &way)) {
            fade.mantissa = (fade.mantissa * share_q15) >> 15;
            add_faded(point, at, &way, &fade);
        }
    }
}

const qtri_light_kind qtri_spot_light = {
    .prepare = prepare_spot, .add = add_spot, .has_edges = true};
