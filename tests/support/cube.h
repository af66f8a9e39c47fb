/* SPDX-License-Identifier: MIT */
/*
 * A cube from -1 to 1 with normals and texture coordinates, and a view of it from aside and above.
 */
#ifndef QTRI_TESTS_SUPPORT_CUBE_H
#define QTRI_TESTS_SUPPORT_CUBE_H

#include "core.h"

enum { CUBE_VERTICES = 8, CUBE_TRIANGLES = 12 };

static const qtri_light cube_light = {
    .towards = {Q16(.3), Q16(.5), Q16(.8)}, .ambient = Q16(.2), .diffuse = Q16(.8)};
static const qtri_vec3 cube_positions[CUBE_VERTICES] = {
    {Q16(-1), Q16(-1), Q16(-1)}, {Q16(1), Q16(-1), Q16(-1)}, {Q16(-1), Q16(1), Q16(-1)},
    {Q16(1), Q16(1), Q16(-1)},   {Q16(-1), Q16(-1), Q16(1)}, {Q16(1), Q16(-1), Q16(1)},
    {Q16(-1), Q16(1), Q16(1)},   {Q16(1), Q16(1), Q16(1)}};
static const qtri_normal cube_normals[CUBE_VERTICES] = {
    {-9459, -9459, -9459}, {9459, -9459, -9459}, {-9459, 9459, -9459}, {9459, 9459, -9459},
    {-9459, -9459, 9459},  {9459, -9459, 9459},  {-9459, 9459, 9459},  {9459, 9459, 9459}};
static const qtri_vec2 cube_uvs[CUBE_VERTICES] = {{0, 0},           {Q16(1), 0}, {0, Q16(1)},
                                                  {Q16(1), Q16(1)}, {Q16(1), 0}, {0, 0},
                                                  {Q16(1), Q16(1)}, {0, Q16(1)}};
/* And one without an area, for those who want no multiple of four. */
static const uint16_t cube_triangles[CUBE_TRIANGLES + 1][3] = {
    {0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5},
    {3, 7, 5}, {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7}, {7, 7, 7}};

static inline qtri_mesh cube_mesh(void)
{
    const qtri_mesh mesh = {.positions = cube_positions,
                            .normals = cube_normals,
                            .uvs = cube_uvs,
                            .triangles = cube_triangles,
                            .vertex_count = CUBE_VERTICES,
                            .triangle_count = CUBE_TRIANGLES};
    return mesh;
}

static inline qtri_view cube_view(int32_t width, int32_t height, double distance,
                                  qtri_vertex *vertices, uint32_t count, qtri_transform *pose)
{
    qtri_view view;
    qtri_view_init(&view, width, height);
    qtri_transform_perspective(&view.projection, Q16(50), Q16(1.2), Q16(.5), Q16(40));
    view.light = &cube_light;
    view.vertices = vertices;
    view.vertex_count = count;
    qtri_transform_identity(pose);
    qtri_transform_translate(pose, vec3_of(.2, .1, -distance));
    qtri_transform_rotate_y(pose, Q16(33));
    qtri_transform_rotate_x(pose, Q16(21));
    return view;
}

#endif
