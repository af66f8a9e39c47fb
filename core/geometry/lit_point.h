/* SPDX-License-Identifier: MIT */
/*
 * A vertex, or another point of a surface, in the light of a draw call: normal, place, then colour.
 * In place, since vertices are many. Internal.
 */
#ifndef QTRI_GEOMETRY_LIT_POINT_H
#define QTRI_GEOMETRY_LIT_POINT_H

#include "illumination.h"

/* v / |v| for |v| < 2^15.5, not 0, of this square. */
void qtri_normalize_q14(int32_t out[3], const int32_t v[3], uint32_t square);

/* The normal v, |.| <= 2^15, and a place, where by->even is not set; the largest below 2^29. */
void qtri_illuminated_uneven(qtri_lit_point *point, const qtri_illumination *by,
                             const int32_t v[3]);
void qtri_illuminated_place_uneven(qtri_lit_point *point, const qtri_row row[3],
                                   const qtri_vec3 *p);

/* The normal of the triangle a b c, as three such numbers; 0 0 0 where it has no area. */
void qtri_face_normal(int32_t normal[3], const qtri_vec3 *a, const qtri_vec3 *b,
                      const qtri_vec3 *c);

/*
 * Sets a point's normal, from object space: any length, |.| <= 2^15.
 *
 * Stored unit normals are within 2^-6 of length 1: there one step of Newton from 1 is enough. For
 * s = n . n = 1 + e, n (3 - s) / 2 is off by 3/8 e^2 < 2^-11.5.
 */
QTRI_IN_PLACE void qtri_illuminated_normal(qtri_lit_point *point, const qtri_illumination *by,
                                           int32_t x, int32_t y, int32_t z)
{
    const uint32_t one_q28 = (uint32_t)1 << 28;
    if (!by->even) {
        const int32_t v[3] = {x, y, z};
        qtri_illuminated_uneven(point, by, v);
        return;
    }
    const uint32_t square = (uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z); /* 3 2^30 */
    if (square - (one_q28 - one_q28 / 32) < one_q28 / 16) {
        const int32_t factor_q15 = (int32_t)((3 * one_q28 - square) >> 14);
        point->normal_q14[0] = (x * factor_q15 + 0x4000) >> 15;
        point->normal_q14[1] = (y * factor_q15 + 0x4000) >> 15;
        point->normal_q14[2] = (z * factor_q15 + 0x4000) >> 15;
        return;
    }
    point->normal_q14[0] = 0;
    point->normal_q14[1] = 0;
    point->normal_q14[2] = 0;
    if (square != 0) {
        const int32_t v[3] = {x, y, z};
        qtri_normalize_q14(point->normal_q14, v, square);
    }
}

/* Sets a point's place. */
QTRI_IN_PLACE void qtri_illuminated_place16(qtri_lit_point *point, const qtri_illumination *by,
                                            const qtri_position16 *position)
{
    point->exponent = 0;
    if (by->even) {
        point->place[0] = position->x * 256;
        point->place[1] = position->y * 256;
        point->place[2] = position->z * 256;
        return;
    }
    for (int i = 0; i < 3; i++) {
        point->place[i] =
            qtri_row16_sum(&by->row.compact[i], position->x, position->y, position->z);
    }
}

QTRI_IN_PLACE void qtri_illuminated_place(qtri_lit_point *point, const qtri_illumination *by,
                                          const qtri_vec3 *position)
{
    if (!by->even) {
        qtri_illuminated_place_uneven(point, by->row.wide, position);
        return;
    }
    const qtri_vec3 *p = position;
    const uint32_t all = qtri_magnitude32(p->x) | qtri_magnitude32(p->y) | qtri_magnitude32(p->z);
    const int32_t exponent = all >> 29 != 0 ? 2 : 0;
    point->exponent = exponent;
    point->place[0] = p->x >> exponent;
    point->place[1] = p->y >> exponent;
    point->place[2] = p->z >> exponent;
}

/*
 * A channel of a colour: base has half of a step in it.
 *
 * Of sums below 2^32 there remain 23 bits, times 255 less than 2^31; base is below 2^27. Only the
 * eight sources together, each far too bright, come near that.
 */
static inline uint32_t qtri_reflect(uint32_t base_q15, uint32_t diffuse_q24, uint32_t specular_q24,
                                    uint32_t color, uint32_t highlight)
{
    const uint32_t sum_q15 =
        base_q15 + (diffuse_q24 >> 9) * color + (specular_q24 >> 9) * highlight;
    const uint32_t value = sum_q15 >> 15;
    return value > 255 ? 255 : value;
}

/* The light that reaches a point. */
QTRI_IN_PLACE void qtri_gather_light(const qtri_illumination *by, qtri_lit_point *point)
{
    point->by = by;
    point->diffuse_q24[0] = by->ambient_q24[0];
    point->diffuse_q24[1] = by->ambient_q24[1];
    point->diffuse_q24[2] = by->ambient_q24[2];
    point->specular_q24[0] = 0;
    point->specular_q24[1] = 0;
    point->specular_q24[2] = 0;
    const qtri_shine *first = by->shine;
    const qtri_light_run *end = by->run + by->count;
    for (const qtri_light_run *run = by->run; run != end; run++) {
        run->kind->add(first, run->end, point);
        first = run->end;
    }
}

/* What a point of this colour shows: red, green and blue from bit 16, 8 and 0 on. */
QTRI_IN_PLACE uint32_t qtri_illuminate(const qtri_illumination *by, qtri_lit_point *point,
                                       const qtri_rgb *color)
{
    qtri_gather_light(by, point);
    const uint32_t red = qtri_reflect(by->base_q15[0], point->diffuse_q24[0],
                                      point->specular_q24[0], color->r, by->specular.r);
    const uint32_t green = qtri_reflect(by->base_q15[1], point->diffuse_q24[1],
                                        point->specular_q24[1], color->g, by->specular.g);
    const uint32_t blue = qtri_reflect(by->base_q15[2], point->diffuse_q24[2],
                                       point->specular_q24[2], color->b, by->specular.b);
    return red << 16 | green << 8 | blue;
}

static inline qtri_rgb qtri_lit_rgb(uint32_t word)
{
    const qtri_rgb rgb = {(uint8_t)(word >> 16), (uint8_t)(word >> 8), (uint8_t)word};
    return rgb;
}

#endif
