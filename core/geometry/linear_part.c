/* SPDX-License-Identifier: MIT */
#include "linear_part.h"

#include "../bits/bits.h"
#include "../bits/wide.h"
#include "row.h"

static qtri_wide dot(const qtri_wide a[3], const qtri_wide b[3])
{
    return qtri_wide_add(qtri_wide_add(qtri_wide_mul(a[0], b[0]), qtri_wide_mul(a[1], b[1])),
                         qtri_wide_mul(a[2], b[2]));
}

int32_t qtri_linear_align(int32_t out[3][4], const qtri_transform *t)
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
    return least == INT32_MAX ? 0 : least;
}

int64_t qtri_linear_dot(int32_t m[3][4], int i, int j)
{
    return qtri_mul_s32(m[0][i], m[0][j]) + qtri_mul_s32(m[1][i], m[1][j]) +
           qtri_mul_s32(m[2][i], m[2][j]);
}

bool qtri_linear_is_even(int32_t m[3][4])
{
    const int64_t square = qtri_linear_dot(m, 0, 0);
    const uint64_t noise = (uint64_t)square >> 20;
    return square != 0 && qtri_magnitude64(qtri_linear_dot(m, 1, 1) - square) <= noise &&
           qtri_magnitude64(qtri_linear_dot(m, 2, 2) - square) <= noise &&
           qtri_magnitude64(qtri_linear_dot(m, 0, 1)) <= noise &&
           qtri_magnitude64(qtri_linear_dot(m, 1, 2)) <= noise &&
           qtri_magnitude64(qtri_linear_dot(m, 2, 0)) <= noise;
}

/* Cofactors times the sign of the determinant: the inverse transpose without its division. */
void qtri_linear_normals(int32_t out_q28[3][3], const qtri_transform *object_to_eye)
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
