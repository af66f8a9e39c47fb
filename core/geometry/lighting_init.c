/* SPDX-License-Identifier: MIT */
#include "lighting.h"

#include "../math/unit.h"
#include "../bits/wide.h"
#include "row.h"

static qtri_wide dot(const qtri_wide a[3], const qtri_wide b[3])
{
    return qtri_wide_add(qtri_wide_add(qtri_wide_mul(a[0], b[0]), qtri_wide_mul(a[1], b[1])),
                         qtri_wide_mul(a[2], b[2]));
}

/* The linear part with one exponent, that of its largest row; a fourth column is left alone. */
static void align(int32_t out[3][4], const qtri_transform *t)
{
    int32_t least = INT32_MAX;
    for (int row = 0; row < 3; row++) {
        const int32_t *m = t->row[row].m;
        if ((m[0] | m[1] | m[2]) != 0 && t->row[row].exponent < least) {
            least = t->row[row].exponent;
        }
    }
    for (int row = 0; row < 3; row++) {
        int32_t shift = least == INT32_MAX ? 0 : t->row[row].exponent - least;
        for (int i = 0; i < 3; i++) {
            out[row][i] = t->row[row].m[i] >> (shift < 0 || shift > 31 ? 31 : shift);
        }
    }
}

/* Of two columns; |m| <= 2^30, in one of them 2^31. */
static int64_t column_dot(int32_t m[3][4], int i, int j)
{
    return qtri_mul_s32(m[0][i], m[0][j]) + qtri_mul_s32(m[1][i], m[1][j]) +
           qtri_mul_s32(m[2][i], m[2][j]);
}

/*
 * Columns of equal length, at right angles, to 2^-20: far above the noise of a rotation in Q2.30,
 * far below 1/255.
 */
static bool is_even(int32_t m[3][4])
{
    int64_t square = column_dot(m, 0, 0);
    uint64_t noise = (uint64_t)square >> 20;
    for (int i = 0; i < 3; i++) {
        int next = i < 2 ? i + 1 : 0;
        if (qtri_magnitude64(column_dot(m, i, next)) > noise ||
            qtri_magnitude64(column_dot(m, next, next) - square) > noise) {
            return false;
        }
    }
    return square != 0;
}

/* Cofactors times the sign of the determinant: the inverse transpose without its division. */
QTRI_NOINLINE static void normal_matrix(int32_t out_q28[3][3], const qtri_transform *object_to_eye)
{
    qtri_wide column[3][3];
    for (int i = 0; i < 3; i++) {
        for (int row = 0; row < 3; row++) {
            column[i][row] = qtri_row_element(&object_to_eye->row[row], i);
        }
    }
    qtri_wide cofactor[3][3]; /* columns */
    int32_t least = INT32_MAX;
    for (int i = 0; i < 3; i++) {
        int next = i < 2 ? i + 1 : 0;
        qtri_wide_cross(cofactor[i], column[next], column[3 - i - next]);
        for (int row = 0; row < 3; row++) {
            if (cofactor[i][row].m != 0 && cofactor[i][row].e < least) {
                least = cofactor[i][row].e;
            }
        }
    }
    bool mirrored = dot(column[0], cofactor[0]).m < 0;
    for (int i = 0; i < 3; i++) {
        for (int row = 0; row < 3; row++) {
            qtri_wide c = cofactor[i][row];
            int32_t size = (int32_t)qtri_shift_round(c.m, c.m == 0 ? 0 : c.e - least + 34);
            out_q28[row][i] = mirrored ? -size : size;
        }
    }
}

/*
 * ambient + diffuse (n . towards) / unit as a row of intensities times 2^25, plus half of a step of
 * 2^-15. |m| <= 4 2^27, 2^29.8 for all three.
 */
static void set_plain_row(qtri_lighting *lighting, int32_t unit)
{
    int32_t m[3];
    for (int i = 0; i < 3; i++) {
        int64_t product_q46 = (int64_t)lighting->towards_q30[i] * lighting->diffuse; /* <= 2^48 */
        bool half;
        int32_t size =
            (int32_t)qtri_divide64(qtri_magnitude64(product_q46), (uint32_t)unit * 32, 0, &half);
        m[i] = (product_q46 < 0 ? -size : size) & ~(int32_t)3;
    }
    int64_t ambient_q16 = lighting->ambient > Q16_ONE ? Q16_ONE : lighting->ambient;
    int64_t t_q41 = (ambient_q16 << 25) + ((int64_t)1 << 25);
    qtri_row16_set(&lighting->by.row, m, t_q41);
    lighting->least_q15 = (uint32_t)(t_q41 >> 26);
}

void qtri_lighting_init(qtri_lighting *lighting, const qtri_light *light,
                        const qtri_transform *object_to_eye, int32_t unit)
{
    int32_t m[3][4];
    align(m, object_to_eye);
    lighting->ambient = light->ambient;
    lighting->diffuse = light->diffuse;
    lighting->even = is_even(m);
    lighting->plain = lighting->even && light->ambient >= 0 && light->diffuse >= 0 &&
                      light->diffuse <= 4 * Q16_ONE;
    const int32_t towards[3] = {light->towards.x, light->towards.y, light->towards.z};
    if (!QTRI_WITH_UNEVEN_LIGHT && !lighting->plain) {
        return;
    }
    if (!lighting->even) {
        (void)qtri_unit(lighting->towards_q30, towards, 3, 30);
        normal_matrix(lighting->by.normal_q28, object_to_eye);
        return;
    }
    int64_t object[3]; /* the transpose takes it there; < 3 2^61 */
    int32_t fitted[3];
    for (int i = 0; i < 3; i++) {
        m[i][3] = towards[i];
    }
    for (int i = 0; i < 3; i++) {
        object[i] = column_dot(m, i, 3);
    }
    (void)qtri_fit32(fitted, object, 3);
    (void)qtri_unit(lighting->towards_q30, fitted, 3, 30); /* stays zero for no direction */
    if (lighting->plain) {
        set_plain_row(lighting, unit);
    }
}
