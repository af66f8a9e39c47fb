/*
 * Unit quaternions for orientations: w + xi + yj + zk, Hamilton's product, Q16.16 components.
 */
#ifndef QTRI_QUAT_H
#define QTRI_QUAT_H

#include "mat.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct qtri_quat {
    q16 w, x, y, z;
} qtri_quat;

qtri_quat qtri_quat_identity(void);

/* A turn about an axis of any length, counter-clockwise seen against it. Axis 0: identity. */
qtri_quat qtri_quat_from_axis_deg(qtri_vec3 axis, q16 degrees);

/* First b, then a: rotate(mul(a, b), v) = rotate(a, rotate(b, v)). */
qtri_quat qtri_quat_mul(qtri_quat a, qtri_quat b);

qtri_quat qtri_quat_conjugate(qtri_quat a);

/* a / |a|; zero gives the identity. */
qtri_quat qtri_quat_normalize(qtri_quat a);

/* v turned by a; a need not have unit length exactly. */
qtri_vec3 qtri_quat_rotate(qtri_quat a, qtri_vec3 v);

#ifdef __cplusplus
}
#endif

#endif
