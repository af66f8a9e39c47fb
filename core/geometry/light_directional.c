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

static void add(const qtri_shine *first, const qtri_shine *end, qtri_lit_point *point)
{
    const qtri_shininess *shininess = point->shininess;
    for (const qtri_shine *at = first; at != end; at++) {
        const int32_t cosine_q28 = qtri_dot_q28(point->normal_q14, at->at);
        if (cosine_q28 <= 0) {
            continue;
        }
        qtri_light_add(point->diffuse_q24, at->color_q12, (uint32_t)cosine_q28 >> 16);
        if (shininess != NULL) {
            const uint32_t power_q15 =
                qtri_shininess_at(shininess, qtri_apart_q29(point->normal_q14, at->of.half_q14));
            if (power_q15 != 0) {
                qtri_light_add(point->specular_q24, at->color_q12, power_q15 >> 3);
            }
        }
    }
}

const qtri_light_kind qtri_directional_light = {.prepare = prepare, .add = add};
