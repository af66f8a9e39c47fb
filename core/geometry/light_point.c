/* SPDX-License-Identifier: MIT */
#include "light_point.h"

enum { NEVER = -4096 }; /* as `up` of a part that is 0 */

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

static qtri_wide fraction_of(q16 x)
{
    return qtri_wide_make(x < 0 ? 0 : x, 16);
}

/* Fades are divided by the largest channel, and the color, too, so that it is 1 at most. */
bool qtri_light_point_prepare(qtri_shine *out, const qtri_light_source *source,
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
    const qtri_wide constant = qtri_wide_div(fraction_of(source->constant), by);
    qtri_wide linear = qtri_wide_div(fraction_of(source->linear), by);
    qtri_wide quadratic = qtri_wide_div(fraction_of(source->quadratic), by);
    linear = qtri_wide_mul(linear, space->unit);
    quadratic = qtri_wide_mul(qtri_wide_mul(quadratic, space->unit), space->unit);
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

int32_t qtri_light_subtract_scaled(int32_t d[3], const qtri_shine *source,
                                   const qtri_lit_point *point)
{
    const int32_t exponent = qtri_greatest32(source->of.far.exponent, point->exponent);
    const int32_t source_shift = qtri_least32(exponent - source->of.far.exponent, 31);
    const int32_t point_shift = qtri_least32(exponent - point->exponent, 31);
    for (int i = 0; i < 3; i++) {
        d[i] = (source->at[i] >> source_shift) - (point->place[i] >> point_shift);
    }
    return exponent;
}

static void add(const qtri_shine *first, const qtri_shine *end, qtri_lit_point *point)
{
    for (const qtri_shine *at = first; at != end; at++) {
        qtri_light_way way;
        qtri_light_fade fade;
        if (qtri_light_way_find(&way, at, point) && qtri_light_fade_find(&fade, at, &way)) {
            qtri_light_fade_add(point, at, &way, &fade);
        }
    }
}

const qtri_light_kind qtri_point_light = {.prepare = qtri_light_point_prepare, .add = add};
