/* SPDX-License-Identifier: MIT */
/*
 * The lights of light.h in one draw call: what is the same for all its vertices, and one vertex in
 * their light. Internal.
 *
 * Normals and places are compared in local coordinates. Where eye space is object space rotated,
 * reflected or scaled evenly these are the object's own, and the sources are taken there once;
 * otherwise they are those of eye space, and every vertex is. Directions have 14 fraction bits:
 * light depends on the cosine of an angle, to which that is 2^-14, and highlights are found from
 * the distance between two directions, where it counts even less.
 */
#ifndef QTRI_GEOMETRY_ILLUMINATION_H
#define QTRI_GEOMETRY_ILLUMINATION_H

#include <stdbool.h>
#include <stddef.h>

#include "qtri/light.h"

#include "../bits/bits.h"
#include "../bits/wide.h"
#include "row16.h"

/* A source as a draw call sees it: of its kind. |color| <= 2^16; of point lights <= 2^12. */
typedef struct qtri_shine {
    uint32_t color_q12[3];
    int32_t at[3]; /* the direction to it, Q14; or its place, |.| < 2^29, times 2^exponent */
    union {
        int32_t half_q14[3]; /* directional: h */
        struct {
            int32_t exponent;
            /* color / fade in Q19, times a distance of 16 bits and a power of two: */
            uint32_t constant_q19;
            uint32_t linear, quadratic; /* 16 bits, or 0 */
            int32_t linear_up, quadratic_up;
        } far;
    } of;
    /* Spot: */
    int32_t axis_q14[3]; /* to where it shines */
    uint32_t outer_q29;  /* 1 - cos */
    uint32_t penumbra_inverse;
    int32_t penumbra_shift;
    const qtri_shininess *falloff;
} qtri_shine;

/* A vertex, and the light that reaches it. */
typedef struct qtri_lit_point {
    int32_t normal_q14[3]; /* unit, or 0 */
    int32_t place[3];      /* |.| <= 2^29, times 2^exponent */
    int32_t exponent;
    const struct qtri_illumination *by;
    uint32_t diffuse_q24[3], specular_q24[3];
} qtri_lit_point;

/* From the world to local coordinates. */
typedef struct qtri_light_space {
    const qtri_transform *camera;
    bool even;
    qtri_wide column[3][3]; /* even: of object_to_eye's linear part */
    qtri_wide offset[3];    /* even: its translation */
    qtri_wide inverse;      /* even: 1 / (scale^2 unit) */
    qtri_wide origin[3];    /* even: of local coordinates, times 1 / unit */
    qtri_wide unit;         /* of local coordinates, in eye space */
    int32_t view_q14[3];
} qtri_light_space;

struct qtri_light_kind {
    /* False: it is off. */
    bool (*prepare)(qtri_shine *out, const qtri_light_source *source,
                    const qtri_light_space *space);
    /* Adds the light of sources first..end - 1. */
    void (*add)(const qtri_shine *first, const qtri_shine *end, qtri_lit_point *point);
    bool has_edges; /* what it lights ends where it is bright */
};

/* Sources of one kind, from where the run before ended. */
typedef struct qtri_light_run {
    const qtri_light_kind *kind;
    const qtri_shine *end;
} qtri_light_run;

typedef struct qtri_illumination {
    bool even, compact, two_sided;
    int32_t count;
    qtri_light_run run[QTRI_LIGHTS_MAX];
    int32_t view_q14[3];     /* towards the eye */
    uint32_t ambient_q24[3]; /* times the diffuse colour */
    uint32_t
        base_q15[3]; /* emission, and ambient light on a colour of its own: 0..17 255, and half */
    qtri_rgb specular;
    const qtri_shininess *shininess; /* NULL: no highlights */
    int32_t normal_q28[3][3];        /* not even: inverse transpose up to a positive factor */
    union {
        qtri_row16 compact[3]; /* not even: from a position to a place */
        qtri_row wide[3];
    } row;
    qtri_shine shine[QTRI_LIGHTS_MAX];
} qtri_illumination;

/* For view->lights. compact: NULL, or a mesh whose positions16 are lit. */
void qtri_illumination_init(qtri_illumination *by, const qtri_view *view,
                            const qtri_transform *pose, const qtri_reflection *reflection,
                            const qtri_mesh *compact);

/* ---- For kinds of light ---- */

/* v / |v| with 14 fraction bits, within 2^-12 of its length; false, and zeros, for v = 0. */
bool qtri_direction_q14(int32_t out[3], const int64_t v[3]);

/* A direction of the world; false for one without length. */
bool qtri_light_direction(int32_t out_q14[3], const qtri_light_space *space, const qtri_vec3 *v);

/* A place in the world: below 2^29, times 2^exponent. */
void qtri_light_place(int32_t out[3], int32_t *exponent, const qtri_light_space *space,
                      const qtri_vec3 *position);

/* A source's color, held to 0..16. */
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

/* From here on the table is 0; 0 without one. */
static inline uint32_t qtri_shininess_end_q29(const qtri_shininess *table)
{
    return table == NULL ? 0 : (uint32_t)table->count << table->shift;
}

/* 1 - a . b of two unit vectors: |a - b|^2 / 2. |a| + |b| < 4 in Q14. */
static inline uint32_t qtri_apart_q29(const int32_t a[3], const int32_t b[3])
{
    const uint32_t x = (uint32_t)(a[0] - b[0]); /* squares fit 32 bits, unsigned */
    const uint32_t y = (uint32_t)(a[1] - b[1]);
    const uint32_t z = (uint32_t)(a[2] - b[2]);
    return x * x + y * y + z * z;
}

static inline int32_t qtri_dot_q28(const int32_t a_q14[3], const int32_t b_q14[3])
{
    return a_q14[0] * b_q14[0] + a_q14[1] * b_q14[1] + a_q14[2] * b_q14[2];
}

/* sum += color share: 2^28 at most. */
static inline void qtri_light_add(uint32_t sum_q24[3], const uint32_t color_q12[3],
                                  uint32_t share_q12)
{
    sum_q24[0] += color_q12[0] * share_q12;
    sum_q24[1] += color_q12[1] * share_q12;
    sum_q24[2] += color_q12[2] * share_q12;
}

#endif
