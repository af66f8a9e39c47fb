/* SPDX-License-Identifier: MIT */
#include "per_pixel.h"

#include "../geometry/lit_point.h"

static void set_place(qtri_lit_point *point, const qtri_mesh_job *draw, uint32_t index)
{
    const qtri_mesh *mesh = draw->mesh;
    if (qtri_mesh_has_compact(mesh->positions16)) {
        qtri_illuminated_place16(point, draw->illumination, &mesh->positions16[index]);
    } else {
        qtri_illuminated_place(point, draw->illumination, &mesh->positions[index]);
    }
}

/* The normal of a vertex of a mesh that has some. */
static void get_normal(int32_t n[3], const qtri_mesh *mesh, uint32_t index)
{
    if (qtri_mesh_has_compact(mesh->normals8)) {
        const qtri_normal8 *normal = &mesh->normals8[index];
        n[0] = normal->x * 128;
        n[1] = normal->y * 128;
        n[2] = normal->z * 128;
    } else {
        const qtri_normal *normal = &mesh->normals[index];
        n[0] = normal->x;
        n[1] = normal->y;
        n[2] = normal->z;
    }
}

/* That of the triangle. */
static void get_face_normal(int32_t n[3], const qtri_mesh *mesh, const uint32_t index[3])
{
    qtri_vec3 p[3];
    for (int i = 0; i < 3; i++) {
        if (qtri_mesh_has_compact(mesh->positions16)) {
            const qtri_position16 *from = &mesh->positions16[index[i]];
            p[i].x = from->x;
            p[i].y = from->y;
            p[i].z = from->z;
        } else {
            p[i] = mesh->positions[index[i]];
        }
    }
    qtri_face_normal(n, &p[0], &p[1], &p[2]);
}

static void note(const qtri_mesh_job *draw, const uint32_t index[3], bool is_back)
{
    const qtri_mesh *mesh = draw->mesh;
    const int32_t turn = is_back ? -1 : 1;
    int32_t n[3];
    if (!draw->shaded_per_vertex) {
        get_face_normal(n, mesh, index);
    }
    for (int i = 0; i < 3; i++) {
        qtri_lit_point point;
        if (draw->shaded_per_vertex) {
            get_normal(n, mesh, index[i]);
        }
        qtri_illuminated_normal(&point, draw->illumination, turn * n[0], turn * n[1], turn * n[2]);
        set_place(&point, draw, index[i]);
        qtri_pixel_light_set(&draw->primitive.to.solid.raster, i, &point,
                             mesh->colors != NULL ? &mesh->colors[index[i]]
                                                  : &draw->material.color);
    }
}

static const qtri_by_pixel by_pixel = {qtri_pixel_light_run, note, qtri_pixel_light_set};

const qtri_shading qtri_per_pixel = {2, &qtri_varying_stages, &by_pixel};
