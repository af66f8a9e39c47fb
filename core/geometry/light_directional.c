/* SPDX-License-Identifier: MIT */
#include "illumination.h"

/*
 * A half of 0, where light comes from behind what is looked at, is far from all unit vectors: its
 * distance is more than 1.8, which is beyond the table, and its square below 2^32.
 */
static bool prepare(qtri_shine *out, const qtri_light_source *source, const qtri_light_space *space)
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

/* Most vertices are outside of most highlights: what is needed for one is not kept at hand. */
QTRI_NOINLINE static void add_highlight(const qtri_shine *at, qtri_lit_point *point,
                                        uint32_t apart_q29)
{
    const qtri_shininess *table = point->by->shininess;
    const uint16_t *value = &table->value_q15[apart_q29 >> table->shift];
    const uint32_t rest_q15 = (apart_q29 << (32 - table->shift)) >> 17;
    const uint32_t first_q15 = value[0];
    const uint32_t power_q15 = first_q15 - (((first_q15 - value[1]) * rest_q15) >> 15);
    const uint32_t share_q12 = power_q15 >> 3;
    const uint32_t red = point->specular_q24[0] + at->color_q12[0] * share_q12;
    const uint32_t green = point->specular_q24[1] + at->color_q12[1] * share_q12;
    const uint32_t blue = point->specular_q24[2] + at->color_q12[2] * share_q12;
    point->specular_q24[0] = red;
    point->specular_q24[1] = green;
    point->specular_q24[2] = blue;
}

static void add(const qtri_shine *first, const qtri_shine *end, qtri_lit_point *point)
{
    const int32_t n[3] = {point->normal_q14[0], point->normal_q14[1], point->normal_q14[2]};
    uint32_t sum_q24[3] = {point->diffuse_q24[0], point->diffuse_q24[1], point->diffuse_q24[2]};
    const uint32_t end_q29 = qtri_shininess_end_q29(point->by->shininess);
    for (const qtri_shine *at = first; at != end; at++) {
        const int32_t cosine_q28 = qtri_dot_q28(n, at->at);
        if (cosine_q28 <= 0) {
            continue;
        }
        qtri_light_add(sum_q24, at->color_q12, (uint32_t)cosine_q28 >> 16);
        const uint32_t apart_q29 = qtri_apart_q29(n, at->of.half_q14);
        if (apart_q29 < end_q29) {
            add_highlight(at, point, apart_q29);
        }
    }
    point->diffuse_q24[0] = sum_q24[0];
    point->diffuse_q24[1] = sum_q24[1];
    point->diffuse_q24[2] = sum_q24[2];
}

const qtri_light_kind qtri_directional_light = {.prepare = prepare, .add = add};
