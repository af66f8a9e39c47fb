/*
 * Vectors of 2, 3 and 4 Q16.16 components.
 *
 * Sums of products accumulate in 64 bits or more and round once, to nearest; results saturate.
 */
#ifndef QTRI_VEC_H
#define QTRI_VEC_H

#include "q16.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct qtri_vec2 {
    q16 x, y;
} qtri_vec2;

typedef struct qtri_vec3 {
    q16 x, y, z;
} qtri_vec3;

typedef struct qtri_vec4 {
    q16 x, y, z, w;
} qtri_vec4;

qtri_vec3 qtri_vec3_add(qtri_vec3 a, qtri_vec3 b);
qtri_vec3 qtri_vec3_sub(qtri_vec3 a, qtri_vec3 b);
qtri_vec3 qtri_vec3_scale(qtri_vec3 a, q16 s);
qtri_vec3 qtri_vec3_lerp(qtri_vec3 a, qtri_vec3 b, q16 t); /* as q16_lerp */

q16 qtri_vec2_dot(qtri_vec2 a, qtri_vec2 b);
q16 qtri_vec3_dot(qtri_vec3 a, qtri_vec3 b);
q16 qtri_vec4_dot(qtri_vec4 a, qtri_vec4 b);

/* a x b, right-handed. */
qtri_vec3 qtri_vec3_cross(qtri_vec3 a, qtri_vec3 b);

/* Euclidean length, correctly rounded. */
q16 qtri_vec2_length(qtri_vec2 a);
q16 qtri_vec3_length(qtri_vec3 a);

/* a / |a|, each component within 1 ULP for every a. The zero vector gives the zero vector. */
qtri_vec3 qtri_vec3_normalize(qtri_vec3 a);

#ifdef __cplusplus
}
#endif

#endif
