/* SPDX-License-Identifier: MIT */
#include "qtri/mat.h"
#include "qtri/error.h"

#include "dot.h"

qtri_mat4 qtri_mat4_translate(qtri_vec3 offset)
{
    qtri_mat4 m = qtri_mat4_identity();
    m.m[0][3] = offset.x;
    m.m[1][3] = offset.y;
    m.m[2][3] = offset.z;
    return m;
}

qtri_mat4 qtri_mat4_scale(qtri_vec3 factor)
{
    qtri_mat4 m = qtri_mat4_identity();
    m.m[0][0] = factor.x;
    m.m[1][1] = factor.y;
    m.m[2][2] = factor.z;
    return m;
}

qtri_mat4 qtri_mat4_shear(q16 x_by_y, q16 x_by_z, q16 y_by_x, q16 y_by_z, q16 z_by_x, q16 z_by_y)
{
    qtri_mat4 m = {{{Q16_ONE, x_by_y, x_by_z, 0},
                    {y_by_x, Q16_ONE, y_by_z, 0},
                    {z_by_x, z_by_y, Q16_ONE, 0},
                    {0, 0, 0, Q16_ONE}}};
    return m;
}

qtri_mat3 qtri_mat4_linear(const qtri_mat4 *m)
{
    QTRI_ASSERT(m != NULL);
    qtri_mat3 linear;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            linear.m[i][j] = m->m[i][j];
        }
    }
    return linear;
}

qtri_mat4 qtri_mat4_from_linear(const qtri_mat3 *linear)
{
    QTRI_ASSERT(linear != NULL);
    qtri_mat4 m = qtri_mat4_identity();
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            m.m[i][j] = linear->m[i][j];
        }
    }
    return m;
}

static inline q16 row_product(const q16 row[4], const qtri_right v[4], uint32_t *flags)
{
    qtri_sum sum = qtri_sum_start();
    qtri_sum_product(&sum, row[0], v[0], flags);
    qtri_sum_product(&sum, row[1], v[1], flags);
    qtri_sum_product(&sum, row[2], v[2], flags);
    qtri_sum_product(&sum, row[3], v[3], flags);
    return qtri_sum_q16(&sum, flags);
}

#if QTRI_LONG_MULTIPLY
/* v is `column`. One row's sum that does not fit is no concern of the others. */
static inline q16 row_or_dot(const q16 row[4], const qtri_right v[4], const q16 column[4])
{
    uint32_t flags = 0;
    q16 result = row_product(row, v, &flags);
    return qtri_sum_good(flags) ? result : qtri_dot(row, column, 4);
}
#endif

void qtri_mat4_times(q16 out[4], const qtri_mat4 *m, const q16 v[4])
{
    QTRI_ASSERT(out != NULL && m != NULL && v != NULL);
    QTRI_ASSERT(out != v);
    uint32_t flags = 0;
    const qtri_right right[4] = {qtri_right_of(v[0], &flags), qtri_right_beside(v[1], &flags),
                                 qtri_right_beside(v[2], &flags), qtri_right_beside(v[3], &flags)};
#if QTRI_LONG_MULTIPLY
    if (qtri_sum_good(flags)) {
        out[0] = row_or_dot(m->m[0], right, v);
        out[1] = row_or_dot(m->m[1], right, v);
        out[2] = row_or_dot(m->m[2], right, v);
        out[3] = row_or_dot(m->m[3], right, v);
        return;
    }
#else
    for (int i = 0; i < 4; i++) {
        out[i] = row_product(m->m[i], right, &flags);
    }
    if (qtri_sum_good(flags)) {
        return;
    }
#endif
    qtri_dot_rows(out, m->m[0], v, 4);
}

static qtri_vec3 transform(const qtri_mat4 *m, qtri_vec3 v, q16 w)
{
    qtri_vec4 homogeneous = {v.x, v.y, v.z, w};
    homogeneous = qtri_mat4_vec4(m, homogeneous);
    qtri_vec3 image = {homogeneous.x, homogeneous.y, homogeneous.z};
    return image;
}

qtri_vec3 qtri_mat4_point(const qtri_mat4 *m, qtri_vec3 p)
{
    QTRI_ASSERT(m != NULL);
    return transform(m, p, Q16_ONE);
}

qtri_vec3 qtri_mat4_vector(const qtri_mat4 *m, qtri_vec3 v)
{
    QTRI_ASSERT(m != NULL);
    return transform(m, v, 0);
}

qtri_mat4 qtri_mat4_mul(const qtri_mat4 *a, const qtri_mat4 *b)
{
    QTRI_ASSERT(a != NULL && b != NULL);
    qtri_mat4 product;
    for (int j = 0; j < 4; j++) {
        qtri_vec4 column = {b->m[0][j], b->m[1][j], b->m[2][j], b->m[3][j]};
        column = qtri_mat4_vec4(a, column);
        product.m[0][j] = column.x;
        product.m[1][j] = column.y;
        product.m[2][j] = column.z;
        product.m[3][j] = column.w;
    }
    return product;
}

qtri_mat4 qtri_mat4_transpose(const qtri_mat4 *a)
{
    QTRI_ASSERT(a != NULL);
    qtri_mat4 result;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            result.m[i][j] = a->m[j][i];
        }
    }
    return result;
}
