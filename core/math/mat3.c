/* SPDX-License-Identifier: MIT */
#include "qtri/mat.h"
#include "qtri/error.h"
#include "qtri/q16_trig.h"

#include "dot.h"

qtri_mat3 qtri_mat3_translate(qtri_vec2 offset)
{
    qtri_mat3 m = {{{Q16_ONE, 0, offset.x}, {0, Q16_ONE, offset.y}, {0, 0, Q16_ONE}}};
    return m;
}

qtri_mat3 qtri_mat3_scale(qtri_vec2 factor)
{
    qtri_mat3 m = {{{factor.x, 0, 0}, {0, factor.y, 0}, {0, 0, Q16_ONE}}};
    return m;
}

qtri_mat3 qtri_mat3_shear(q16 x_by_y, q16 y_by_x)
{
    qtri_mat3 m = {{{Q16_ONE, x_by_y, 0}, {y_by_x, Q16_ONE, 0}, {0, 0, Q16_ONE}}};
    return m;
}

/* p - R p with the rounded R: with the exact one, R p + offset would miss a far p. */
qtri_mat3 qtri_mat3_rotate_about_deg(q16 degrees, qtri_vec2 point)
{
    q16 s;
    q16 c;
    q16_sincos_deg(degrees, &s, &c);
    const q16 p[2] = {point.x, point.y};
    const q16 x[2] = {Q16_ONE - c, s};
    const q16 y[2] = {-s, Q16_ONE - c};
    qtri_mat3 m = {{{c, -s, qtri_dot(x, p, 2)}, {s, c, qtri_dot(y, p, 2)}, {0, 0, Q16_ONE}}};
    return m;
}

qtri_mat3 qtri_mat3_rotate_deg(q16 degrees)
{
    qtri_vec2 origin = {0, 0};
    return qtri_mat3_rotate_about_deg(degrees, origin);
}

qtri_mat3 qtri_mat3_reflect_deg(q16 degrees)
{
    q16 s;
    q16 c;
    q16_sincos_deg(degrees % Q16(180) * 2, &s, &c);
    qtri_mat3 m = {{{c, s, 0}, {s, -c, 0}, {0, 0, Q16_ONE}}};
    return m;
}

qtri_vec3 qtri_mat3_vec3(const qtri_mat3 *m, qtri_vec3 v)
{
    QTRI_ASSERT(m != NULL);
    const q16 column[3] = {v.x, v.y, v.z};
    q16 image[3];
    qtri_dot_rows(image, m->m[0], column, 3);
    qtri_vec3 product = {image[0], image[1], image[2]};
    return product;
}

static qtri_vec2 transform(const qtri_mat3 *m, qtri_vec2 v, q16 w)
{
    const q16 homogeneous[3] = {v.x, v.y, w};
    qtri_vec2 image = {qtri_dot(m->m[0], homogeneous, 3), qtri_dot(m->m[1], homogeneous, 3)};
    return image;
}

qtri_vec2 qtri_mat3_point(const qtri_mat3 *m, qtri_vec2 p)
{
    QTRI_ASSERT(m != NULL);
    return transform(m, p, Q16_ONE);
}

qtri_vec2 qtri_mat3_vector(const qtri_mat3 *m, qtri_vec2 v)
{
    QTRI_ASSERT(m != NULL);
    return transform(m, v, 0);
}

qtri_mat3 qtri_mat3_mul(const qtri_mat3 *a, const qtri_mat3 *b)
{
    QTRI_ASSERT(a != NULL && b != NULL);
    qtri_mat3 product;
    for (int j = 0; j < 3; j++) {
        const q16 column[3] = {b->m[0][j], b->m[1][j], b->m[2][j]};
        for (int i = 0; i < 3; i++) {
            product.m[i][j] = qtri_dot(a->m[i], column, 3);
        }
    }
    return product;
}

qtri_mat3 qtri_mat3_transpose(const qtri_mat3 *a)
{
    QTRI_ASSERT(a != NULL);
    qtri_mat3 result;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            result.m[i][j] = a->m[j][i];
        }
    }
    return result;
}
