/*
 * Q16.16 matrices, m[row][column], acting on column vectors: M v; (A B) v = A (B v).
 *
 * They are for application code and for matrices that come from elsewhere. What reaches the screen
 * goes through qtri_transform (transform.h), which keeps the bits that a Q16.16 product loses.
 */
#ifndef QTRI_MAT_H
#define QTRI_MAT_H

#include "vec.h"

#ifdef __cplusplus
extern "C" {
#endif

/* 2D homogeneous transforms, or linear maps of space. */
typedef struct qtri_mat3 {
    q16 m[3][3];
} qtri_mat3;

typedef struct qtri_mat4 {
    q16 m[4][4];
} qtri_mat4;

qtri_mat3 qtri_mat3_identity(void);
qtri_mat3 qtri_mat3_translate(qtri_vec2 offset);
qtri_mat3 qtri_mat3_scale(qtri_vec2 factor); /* negative factors reflect */
qtri_mat3 qtri_mat3_shear(q16 x_by_y, q16 y_by_x);
qtri_mat3 qtri_mat3_rotate_deg(q16 degrees); /* about the origin, counter-clockwise */
qtri_mat3 qtri_mat3_mul(const qtri_mat3 *a, const qtri_mat3 *b);

/* M (p, 1), for a transform whose last row is 0 0 1. */
qtri_vec2 qtri_mat3_point(const qtri_mat3 *m, qtri_vec2 p);

qtri_mat4 qtri_mat4_identity(void);
qtri_mat4 qtri_mat4_mul(const qtri_mat4 *a, const qtri_mat4 *b);
qtri_mat4 qtri_mat4_transpose(const qtri_mat4 *a);
qtri_vec4 qtri_mat4_vec4(const qtri_mat4 *m, qtri_vec4 v);

#ifdef __cplusplus
}
#endif

#endif
