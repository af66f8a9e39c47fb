/* SPDX-License-Identifier: MIT */
#include "shapes.h"
#include "plain.h"

/* Two triangles of four corners: left above, left below, right below, right above. */
static void add_quad(qtri_builder *builder, uint32_t above_left, uint32_t below_left,
                     uint32_t below_right, uint32_t above_right)
{
    qtri_builder_triangle(builder, above_left, below_left, below_right);
    qtri_builder_triangle(builder, above_left, below_right, above_right);
}

static qtri_vec3 scaled(const qtri_vec3 *half, const int8_t sign[3])
{
    const qtri_vec3 v = {sign[0] < 0 ? q16_neg(half->x) : half->x,
                         sign[1] < 0 ? q16_neg(half->y) : half->y,
                         sign[2] < 0 ? q16_neg(half->z) : half->z};
    return v;
}

enum qtri_error qtri_shape_box(qtri_mesh *mesh, const qtri_shape_memory *memory, qtri_vec3 half)
{
    QTRI_ASSERT(qtri_is_length(half.x) && qtri_is_length(half.y) && qtri_is_length(half.z));
    /* Of each side: outwards, to the right and up in its picture. */
    static const int8_t sides[6][3][3] = {
        {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},   {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
        {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
        {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}},  {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};
    static const int8_t corner[4][2] = {{-1, 1}, {-1, -1}, {1, -1}, {1, 1}};
    qtri_builder builder;
    enum qtri_error error =
        qtri_builder_begin(&builder, mesh, memory, QTRI_BOX_VERTICES, QTRI_BOX_TRIANGLES);
    if (error != QTRI_OK) {
        return error;
    }
    for (int i = 0; i < 6; i++) {
        const int8_t(*side)[3] = sides[i];
        const qtri_vec3 normal = {side[0][0] * Q16_ONE, side[0][1] * Q16_ONE, side[0][2] * Q16_ONE};
        const uint32_t first = mesh->vertex_count;
        for (int k = 0; k < 4; k++) {
            int8_t sign[3];
            for (int axis = 0; axis < 3; axis++) {
                sign[axis] = (int8_t)(side[0][axis] + corner[k][0] * side[1][axis] +
                                      corner[k][1] * side[2][axis]);
            }
            qtri_builder_vertex(&builder, scaled(&half, sign), normal,
                                corner[k][0] > 0 ? Q16_ONE : 0, corner[k][1] > 0 ? 0 : Q16_ONE);
        }
        add_quad(&builder, first, first + 1, first + 2, first + 3);
    }
    return qtri_builder_end(&builder);
}

/* half (2 i / count - 1), rounded; |.| <= half. */
static q16 along(q16 half, int32_t i, int32_t count)
{
    return q16_muldiv(half, 2 * i - count, count);
}

enum qtri_error qtri_shape_grid(qtri_mesh *mesh, const qtri_shape_memory *memory, q16 half_x,
                                q16 half_z, int32_t columns, int32_t rows)
{
    QTRI_ASSERT(qtri_is_length(half_x) && qtri_is_length(half_z));
    static const qtri_vec3 up = {0, Q16_ONE, 0};
    qtri_builder builder;
    const bool is_valid = qtri_is_count(columns, 1) && qtri_is_count(rows, 1);
    enum qtri_error error = qtri_builder_begin(
        &builder, mesh, memory, is_valid ? QTRI_GRID_VERTICES(columns, rows) : INT32_MAX,
        is_valid ? QTRI_GRID_TRIANGLES(columns, rows) : 0);
    if (error != QTRI_OK) {
        return error;
    }
    for (int32_t z = 0; z <= rows; z++) {
        for (int32_t x = 0; x <= columns; x++) {
            const qtri_vec3 position = {along(half_x, x, columns), 0, along(half_z, z, rows)};
            const uint32_t i = qtri_builder_vertex(&builder, position, up, qtri_part_of(x, columns),
                                                   qtri_part_of(z, rows));
            if (z > 0 && x > 0) {
                const uint32_t above = i - (uint32_t)columns - 1;
                add_quad(&builder, above - 1, i - 1, i, above);
            }
        }
    }
    return qtri_builder_end(&builder);
}
