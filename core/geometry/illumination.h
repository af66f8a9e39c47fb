/* SPDX-License-Identifier: MIT */
/*
 * The light sources of a view in one draw call: set up once, then summed up at each vertex or
 * pixel. Internal.
 *
 * Normals and positions are compared in local coordinates: the object's own where eye space is
 * object space rotated, reflected or scaled evenly, and otherwise those of eye space. Directions
 * have 14 fraction bits: light depends on the cosine of an angle, to which that is 2^-14, and
 * highlights are found from the distance between two directions, where it counts even less.
 */
#ifndef QTRI_GEOMETRY_ILLUMINATION_H
#define QTRI_GEOMETRY_ILLUMINATION_H

#include "qtri/light.h"

#include <stdbool.h>
#include <stddef.h>

#include "../bits/bits.h"
#include "../bits/wide.h"
#include "row.h"

/* A source set up for a draw call. |color| <= 2^16; of point and spot lights <= 2^12. */
typedef struct qtri_source {
    uint32_t color_q12[3];
    int32_t at[3]; /* the direction to it, Q14; or its place, |.| < 2^29, times 2^exponent */
    union {
        int32_t half_q14[3]; /* directional: h, halfway to the eye */
        struct {
            int32_t exponent; /* of `at` */
            /* Attenuation over the largest channel, Q19; factors of 16 bits, times 2^up: */
            uint32_t constant_q19;
            uint32_t linear, quadratic; /* 16 bits, or 0 */
            int32_t linear_up, quadratic_up;
        } far;
    } of;
    /* Spot: */
    int32_t axis_q14[3];       /* to where it shines */
    uint32_t outer_q29;        /* 1 - cos of the outer angle */
    uint32_t penumbra_inverse; /* 2^31 / (outer - inner, shifted right by penumbra_shift) */
    int32_t penumbra_shift;
    const qtri_shininess *falloff;
} qtri_source;

/* A vertex or pixel in local coordinates, and the light that it gets. */
typedef struct qtri_lit_point {
    int32_t normal_q14[3]; /* unit, or 0 */
    int32_t place[3];      /* |.| <= 2^29, times 2^exponent */
    int32_t exponent;
    const struct qtri_illumination *by;
    uint32_t diffuse_q24[3], specular_q24[3]; /* sums over sources */
} qtri_lit_point;

/* How sources are taken from the world to local coordinates. */
typedef struct qtri_light_space {
    const qtri_transform *camera;
    bool even;
    qtri_wide column[3][3]; /* even: of object_to_eye's linear part */
    qtri_wide offset[3];    /* even: its translation, negated */
    qtri_wide inverse;      /* even: 1 / (scale^2 unit) */
    qtri_wide origin[3];    /* even: of local coordinates, times -1 / unit */
    qtri_wide unit;         /* of local coordinates, in eye space */
    const int32_t *view_q14;
} qtri_light_space;

struct qtri_light_kind {
    /* Sets a source up; false: it gives no light. */
    bool (*prepare)(qtri_source *out, const qtri_light_source *source,
                    const qtri_light_space *space);
    /* Adds the light of sources first..end - 1. */
    void (*add)(const qtri_source *first, const qtri_source *end, qtri_lit_point *point);
    bool has_edges; /* what it lights ends where it is bright */
};

/* Sources of one kind, from where the run before ended. */
typedef struct qtri_light_run {
    const qtri_light_kind *kind;
    const qtri_source *end;
} qtri_light_run;

typedef struct qtri_illumination {
    bool even, two_sided; /* even: rotated and scaled uniformly, see above */
    int32_t count;        /* of runs */
    qtri_light_run run[QTRI_LIGHTS_MAX];
    int32_t view_q14[3];     /* towards the eye */
    uint32_t ambient_q24[3]; /* times the diffuse colour */
    /* Emission, and ambient light on an ambient colour of its own: 0..17 255, and 1/2 to round. */
    uint32_t base_q15[3];
    qtri_rgb specular;
    const qtri_shininess *shininess; /* NULL: no highlights */
    int32_t normal_q28[3][3];        /* not even: inverse transpose up to a positive factor */
    union {
        qtri_row16 compact[3]; /* not even: from a position to a place */
        qtri_row wide[3];
    } row;
    qtri_source source[QTRI_LIGHTS_MAX];
} qtri_illumination;

/* For view->light, which has sources. compact: NULL, or a mesh whose positions16 are lit. */
void qtri_illumination_init(qtri_illumination *by, const qtri_view *view,
                            const qtri_transform *pose, const qtri_reflection *reflection,
                            const qtri_mesh *compact);

/* ---- For kinds of light ---- */

/* v / |v| with 14 fraction bits, within 2^-12 of its length; false, and zeros, for v = 0. */
bool qtri_direction_q14(int32_t out[3], const int64_t v[3]);

/* A direction of the world, as a unit vector in local coordinates; false: it is 0. */
bool qtri_light_direction(int32_t out_q14[3], const qtri_light_space *space, const qtri_vec3 *v);

/* A position in the world, in local coordinates: out 2^*exponent, |out| <= 2^29. */
void qtri_light_place(int32_t out[3], int32_t *exponent, const qtri_light_space *space,
                      const qtri_vec3 *position);

/* A source's color, clamped to 0..16. */
void qtri_light_color_q12(uint32_t out[3], const qtri_light_color *color);

/* The power table at t = 1 - cosine, t <= 4. */
static inline uint32_t qtri_shininess_at(const qtri_shininess *table, uint32_t t_q29)
{
    const uint32_t i = t_q29 >> table->shift;
    if (i >= table->count) {
        return 0;
    }
    const uint16_t *value = &table->value_q15[i];
    const uint32_t rest_q15 = (t_q29 << (32 - table->shift)) >> 17;
    return value[0] - (((uint32_t)(value[0] - value[1]) * rest_q15) >> 15);
}

static inline uint32_t qtri_square_q28(const int32_t v_q14[3])
{
    return (uint32_t)(v_q14[0] * v_q14[0]) + (uint32_t)(v_q14[1] * v_q14[1]) +
           (uint32_t)(v_q14[2] * v_q14[2]);
}

/* ---- One point: in place, since vertices are many ---- */

/* v / |v| for |v| < 2^15.5, not 0, of this square. */
void qtri_normalize_q14(int32_t out[3], const int32_t v[3], uint32_t square);

/* Where by->even is not set: v, |.| <= 2^15, by normal_q28, and a place; the largest below 2^29. */
void qtri_uneven_normal_q14(int32_t out[3], const int32_t *m_q28, const int32_t v[3]);
void qtri_illuminated_place_uneven(qtri_lit_point *point, const qtri_row row[3],
                                   const qtri_vec3 *p);

/* The normal of the triangle a b c, unit, Q14; 0 0 0 where it has no area. */
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
        qtri_uneven_normal_q14(point->normal_q14, by->normal_q28[0], v);
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
    point->normal_q14[0] = point->normal_q14[1] = point->normal_q14[2] = 0;
    if (square != 0) {
        const int32_t v[3] = {x, y, z};
        qtri_normalize_q14(point->normal_q14, v, square);
    }
}

/* Sets a point's place from a position in object space. */
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
 * A channel of a lit colour, 0..255: base, which has the 1/2 that rounds, diffuse times color and
 * specular times highlight. With eight sources and ambient light of 16 at most, diffuse and base
 * add up to 145 times 255 and specular to 128 times 255: the sum is below 2^31.2.
 */
static inline uint32_t qtri_lit_channel(uint32_t base_q15, uint32_t diffuse_q24,
                                        uint32_t specular_q24, uint32_t color, uint32_t highlight)
{
    const uint32_t sum_q15 =
        base_q15 + (diffuse_q24 >> 9) * color + (specular_q24 >> 9) * highlight;
    const uint32_t value = sum_q15 >> 15;
    return value > 255 ? 255 : value;
}

/* Sums up the light of all sources at a point. */
QTRI_IN_PLACE void qtri_gather_light(const qtri_illumination *by, qtri_lit_point *point)
{
    point->by = by;
    point->diffuse_q24[0] = by->ambient_q24[0];
    point->diffuse_q24[1] = by->ambient_q24[1];
    point->diffuse_q24[2] = by->ambient_q24[2];
    point->specular_q24[0] = point->specular_q24[1] = point->specular_q24[2] = 0;
    const qtri_source *first = by->source;
    const qtri_light_run *end = by->run + by->count;
    for (const qtri_light_run *run = by->run; run != end; run++) {
        run->kind->add(first, run->end, point);
        first = run->end;
    }
}

/* The lit colour, 0x00RRGGBB, of a point of this colour. */
QTRI_IN_PLACE uint32_t qtri_illuminate(const qtri_illumination *by, qtri_lit_point *point,
                                       const qtri_rgb *color)
{
    qtri_gather_light(by, point);
    const uint32_t red = qtri_lit_channel(by->base_q15[0], point->diffuse_q24[0],
                                          point->specular_q24[0], color->r, by->specular.r);
    const uint32_t green = qtri_lit_channel(by->base_q15[1], point->diffuse_q24[1],
                                            point->specular_q24[1], color->g, by->specular.g);
    const uint32_t blue = qtri_lit_channel(by->base_q15[2], point->diffuse_q24[2],
                                           point->specular_q24[2], color->b, by->specular.b);
    return red << 16 | green << 8 | blue;
}

static inline qtri_rgb qtri_lit_rgb(uint32_t word)
{
    const qtri_rgb rgb = {(uint8_t)(word >> 16), (uint8_t)(word >> 8), (uint8_t)word};
    return rgb;
}

#endif
