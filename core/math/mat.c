#include "qtri/mat.h"

#include "qtri/q16_trig.h"
#include "products.h"

qtri_mat3 qtri_mat3_identity(void)
{
    qtri_mat3 m = {{{Q16_ONE, 0, 0}, {0, Q16_ONE, 0}, {0, 0, Q16_ONE}}};
    return m;
}

qtri_mat3 qtri_mat3_translate(qtri_vec2 offset)
{
    qtri_mat3 m = qtri_mat3_identity();
    m.m[0][2] = offset.x;
    m.m[1][2] = offset.y;
    return m;
}

qtri_mat3 qtri_mat3_scale(qtri_vec2 factor)
{
    qtri_mat3 m = qtri_mat3_identity();
    m.m[0][0] = factor.x;
    m.m[1][1] = factor.y;
    return m;
}

qtri_mat3 qtri_mat3_shear(q16 x_by_y, q16 y_by_x)
{
    qtri_mat3 m = qtri_mat3_identity();
    m.m[0][1] = x_by_y;
    m.m[1][0] = y_by_x;
    return m;
}

qtri_mat3 qtri_mat3_rotate_deg(q16 degrees)
{
    qtri_mat3 m = qtri_mat3_identity();
    q16 sine;
    q16 cosine;
    q16_sincos_deg(degrees, &sine, &cosine);
    m.m[0][0] = cosine;
    m.m[0][1] = -sine;
    m.m[1][0] = sine;
    m.m[1][1] = cosine;
    return m;
}

qtri_mat3 qtri_mat3_mul(const qtri_mat3 *a, const qtri_mat3 *b)
{
    qtri_mat3 product;
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++) {
            qtri_products sum = {0, 0};
            for (int k = 0; k < 3; k++) {
                qtri_products_add(&sum, a->m[row][k], b->m[k][column]);
            }
            product.m[row][column] = qtri_products_q16(&sum);
        }
    }
    return product;
}

qtri_vec2 qtri_mat3_point(const qtri_mat3 *m, qtri_vec2 p)
{
    q16 result[2];
    for (int row = 0; row < 2; row++) {
        qtri_products sum = {0, 0};
        qtri_products_add(&sum, m->m[row][0], p.x);
        qtri_products_add(&sum, m->m[row][1], p.y);
        qtri_products_add(&sum, m->m[row][2], Q16_ONE);
        result[row] = qtri_products_q16(&sum);
    }
    qtri_vec2 point = {result[0], result[1]};
    return point;
}

qtri_mat4 qtri_mat4_identity(void)
{
    qtri_mat4 m = {
        {{Q16_ONE, 0, 0, 0}, {0, Q16_ONE, 0, 0}, {0, 0, Q16_ONE, 0}, {0, 0, 0, Q16_ONE}}};
    return m;
}

qtri_mat4 qtri_mat4_mul(const qtri_mat4 *a, const qtri_mat4 *b)
{
    qtri_mat4 product;
    for (int row = 0; row < 4; row++) {
        for (int column = 0; column < 4; column++) {
            qtri_products sum = {0, 0};
            for (int k = 0; k < 4; k++) {
                qtri_products_add(&sum, a->m[row][k], b->m[k][column]);
            }
            product.m[row][column] = qtri_products_q16(&sum);
        }
    }
    return product;
}

qtri_mat4 qtri_mat4_transpose(const qtri_mat4 *a)
{
    qtri_mat4 result;
    for (int row = 0; row < 4; row++) {
        for (int column = 0; column < 4; column++) {
            result.m[row][column] = a->m[column][row];
        }
    }
    return result;
}

qtri_vec4 qtri_mat4_vec4(const qtri_mat4 *m, qtri_vec4 v)
{
    q16 result[4];
    for (int row = 0; row < 4; row++) {
        qtri_vec4 factors = {m->m[row][0], m->m[row][1], m->m[row][2], m->m[row][3]};
        result[row] = qtri_vec4_dot(factors, v);
    }
    qtri_vec4 product = {result[0], result[1], result[2], result[3]};
    return product;
}
