/* SPDX-License-Identifier: MIT */
#include "light_point.h"

#include "../math/sincos.h"

/* 1 - cos(angle), for an angle held to 0..180 degrees. */
static uint32_t apart_q29(q16 degrees)
{
    int32_t sine_q30;
    int32_t cosine_q30;
    qtri_sincos_deg_q30(qtri_hold32(degrees, 0, 180 * Q16_ONE), &sine_q30, &cosine_q30);
    return ((uint32_t)((int32_t)1 << 30) - (uint32_t)cosine_q30 + 1u) >> 1; /* 0..2^30 */
}

static bool prepare(qtri_shine *out, const qtri_light_source *source, const qtri_light_space *space)
{
    if (!qtri_light_direction(out->axis_q14, space, &source->direction) ||
        !qtri_light_point_prepare(out, source, space)) {
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

/* The share in Q15 of a source's light that goes along a way. */
static uint32_t cone_q15(const qtri_shine *source, const qtri_light_way *way)
{
    const int32_t from[3] = {-way->direction_q14[0], -way->direction_q14[1],
                             -way->direction_q14[2]};
    const uint32_t apart = qtri_apart_q29(from, source->axis_q14);
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

static void add(const qtri_shine *first, const qtri_shine *end, qtri_lit_point *point)
{
    for (const qtri_shine *at = first; at != end; at++) {
        qtri_light_way way;
        qtri_light_fade fade;
        if (!qtri_light_way_find(&way, at, point)) {
            continue;
        }
        const uint32_t share_q15 = cone_q15(at, &way);
        if (share_q15 != 0 && qtri_light_fade_find(&fade, at, &way)) {
            fade.mantissa = (fade.mantissa * share_q15) >> 15;
            qtri_light_fade_add(point, at, &way, &fade);
        }
    }
}

const qtri_light_kind qtri_spot_light = {.prepare = prepare, .add = add, .has_edges = true};
