/* SPDX-License-Identifier: MIT */
/*
 * The matrices of the library assimp's C interface, whose order of float operations they keep:
 * vertices get the bits that they get in the command.
 */
#include <assimp/cimport.h>
#include <math.h>
#include <string.h>

static const struct aiMatrix4x4 identity = {.a1 = 1, .b2 = 1, .c3 = 1, .d4 = 1};

void aiIdentityMatrix4(struct aiMatrix4x4 *mat)
{
    *mat = identity;
}

int aiMatrix4IsIdentity(const struct aiMatrix4x4 *mat)
{
    const float *one = &identity.a1, *m = &mat->a1;
    int is_identity = 1;
    for (int i = 0; i < 16; i++) {
        is_identity = is_identity && m[i] <= one[i] + 10e-3f && m[i] >= one[i] - 10e-3f;
    }
    return is_identity;
}

void aiMultiplyMatrix4(struct aiMatrix4x4 *dst, const struct aiMatrix4x4 *src)
{
    struct aiMatrix4x4 product = {.a1 = 0};
    const float *a = &dst->a1, *b = &src->a1;
    float *to = &product.a1;
    for (int i = 0; i < 16; i++) {
        const float *row = a + i / 4 * 4, *column = b + i % 4;
        to[i] = column[0] * row[0] + column[4] * row[1] + column[8] * row[2] + column[12] * row[3];
    }
    *dst = product;
}

void aiMatrix3FromMatrix4(struct aiMatrix3x3 *dst, const struct aiMatrix4x4 *mat)
{
    for (int i = 0; i < 3; i++) {
        memcpy(&dst->a1 + 3 * i, &mat->a1 + 4 * i, 3 * sizeof(float));
    }
}

float aiMatrix3Determinant(const struct aiMatrix3x3 *m)
{
    return m->a1 * m->b2 * m->c3 - m->a1 * m->b3 * m->c2 + m->a2 * m->b3 * m->c1 -
           m->a2 * m->b1 * m->c3 + m->a3 * m->b1 * m->c2 - m->a3 * m->b2 * m->c1;
}

/* By the cofactors. */
void aiMatrix3Inverse(struct aiMatrix3x3 *mat)
{
    const float determinant = aiMatrix3Determinant(mat);
    const float inverse = determinant != 0 ? 1 / determinant : NAN;
    const struct aiMatrix3x3 from = *mat;
    const float *m = &from.a1;
    float *to = &mat->a1;
    for (int i = 0; i < 9; i++) { /* what crosses this element's row and column is left out */
        const int row = i % 3, column = i / 3;
        const int up = row == 0 ? 3 : 0, down = row == 2 ? 3 : 6;
        const int left = column == 0 ? 1 : 0, right = column == 2 ? 1 : 2;
        to[i] = (i % 2 == 0 ? inverse : -inverse) *
                (m[up + left] * m[down + right] - m[up + right] * m[down + left]);
    }
}

void aiTransposeMatrix3(struct aiMatrix3x3 *mat)
{
    const struct aiMatrix3x3 from = *mat;
    for (int i = 0; i < 9; i++) {
        (&mat->a1)[i] = (&from.a1)[i % 3 * 3 + i / 3];
    }
}

void aiTransformVecByMatrix3(struct aiVector3D *vec, const struct aiMatrix3x3 *m)
{
    const struct aiVector3D v = *vec;
    vec->x = m->a1 * v.x + m->a2 * v.y + m->a3 * v.z;
    vec->y = m->b1 * v.x + m->b2 * v.y + m->b3 * v.z;
    vec->z = m->c1 * v.x + m->c2 * v.y + m->c3 * v.z;
}

void aiTransformVecByMatrix4(struct aiVector3D *vec, const struct aiMatrix4x4 *m)
{
    const struct aiVector3D v = *vec;
    vec->x = m->a1 * v.x + m->a2 * v.y + m->a3 * v.z + m->a4;
    vec->y = m->b1 * v.x + m->b2 * v.y + m->b3 * v.z + m->b4;
    vec->z = m->c1 * v.x + m->c2 * v.y + m->c3 * v.z + m->c4;
}

/* The quaternion x y z w of a rotation, by its largest component. */
static void quaternion_of(const float m[3][3], float q[4])
{
    const float trace = m[0][0] + m[1][1] + m[2][2];
    if (trace > 0) {
        const float s = sqrtf(1 + trace) * 2;
        q[0] = (m[2][1] - m[1][2]) / s;
        q[1] = (m[0][2] - m[2][0]) / s;
        q[2] = (m[1][0] - m[0][1]) / s;
        q[3] = 0.25f * s;
        return;
    }
    const int i = m[0][0] > m[1][1] && m[0][0] > m[2][2] ? 0 : m[1][1] > m[2][2] ? 1 : 2;
    const int j = (i + 1) % 3, k = (i + 2) % 3, low = j < k ? j : k, high = j < k ? k : j;
    const float s = sqrtf(1 + m[i][i] - m[low][low] - m[high][high]) * 2;
    q[i] = 0.25f * s;
    q[j] = (m[j][i] + m[i][j]) / s;
    q[k] = (m[k][i] + m[i][k]) / s;
    q[3] = (m[k][j] - m[j][k]) / s;
}

void aiDecomposeMatrix(const struct aiMatrix4x4 *mat, struct aiVector3D *scaling,
                       struct aiQuaternion *rotation, struct aiVector3D *position)
{
    struct aiMatrix3x3 inner;
    float m[3][3], q[4], *scale = &scaling->x;
    aiMatrix3FromMatrix4(&inner, mat);
    memcpy(m, &inner, sizeof m);
    for (int i = 0; i < 3; i++) {
        scale[i] = sqrtf(m[0][i] * m[0][i] + m[1][i] * m[1][i] + m[2][i] * m[2][i]);
        scale[i] = aiMatrix3Determinant(&inner) < 0 ? -scale[i] : scale[i];
        const float inverse = scale[i] != 0 ? 1 / scale[i] : 1;
        for (int j = 0; j < 3; j++) {
            m[j][i] *= inverse;
        }
    }
    quaternion_of((const float(*)[3])m, q);
    *rotation = (struct aiQuaternion){.x = q[0], .y = q[1], .z = q[2], .w = q[3]};
    *position = (struct aiVector3D){mat->a4, mat->b4, mat->c4};
}
