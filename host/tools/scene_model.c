/* SPDX-License-Identifier: MIT */
/* Models of a scene: shapes of the core, and meshes that it mixes in 16 bits. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../assets/mesh_arrays.h"
#include "../io/xalloc.h"
#include "scene_draw.h"

/* ---- Shapes ---- */

static enum qtri_error make_shape(qtri_mesh *mesh, const qtri_shape_memory *memory,
                                  const struct scene_model *model)
{
    const int32_t *size = model->size;
    const int *count = model->count;
    const qtri_vec3 half = {size[0], size[1], size[2]};
    switch (model->shape) {
    case SCENE_BOX:
        return qtri_shape_box(mesh, memory, half);
    case SCENE_SPHERE:
        return qtri_shape_sphere(mesh, memory, size[0], count[0], count[1]);
    case SCENE_CYLINDER:
        return qtri_shape_cylinder(mesh, memory, size[0], size[1], count[0]);
    case SCENE_CONE:
        return qtri_shape_cone(mesh, memory, size[0], size[1], count[0]);
    case SCENE_TORUS:
        return qtri_shape_torus(mesh, memory, size[0], size[1], count[0], count[1]);
    case SCENE_GRID:
        break;
    }
    return qtri_shape_grid(mesh, memory, size[0], size[1], count[0], count[1]);
}

static void create_shape(qtri_mesh *mesh, const struct scene_model *model)
{
    mesh_array_create(mesh, MESH_POSITIONS);
    mesh_array_create(mesh, MESH_NORMALS);
    mesh_array_create(mesh, MESH_UVS);
    mesh_array_create(mesh, MESH_TRIANGLES);
    const qtri_shape_memory memory = {mesh_array(mesh, MESH_POSITIONS),
                                      mesh_array(mesh, MESH_NORMALS),
                                      mesh_array(mesh, MESH_UVS),
                                      mesh_array(mesh, MESH_TRIANGLES),
                                      model->vertices,
                                      model->triangles};
    if (make_shape(mesh, &memory, model) != QTRI_OK) {
        abort(); /* the scene reader has checked it */
    }
}

/* ---- Mixed ---- */

/* The box of all positions that are read or made: what 16 bits span. */
struct span {
    double least[3], greatest[3];
};

static void widen(struct span *span, int axis, double x)
{
    span->least[axis] = fmin(span->least[axis], x);
    span->greatest[axis] = fmax(span->greatest[axis], x);
}

static struct span span_of(const struct scene *scene, const struct scene_model *model)
{
    struct span span = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
    const struct obj_mesh *base = &scene->meshes[model->mesh[0]];
    for (size_t i = 0; i < base->vertex_count; i++) {
        for (int axis = 0; axis < 3; axis++) {
            double sum = base->positions[i][axis];
            for (int k = 0; k < model->mesh_count; k++) {
                const double x = scene->meshes[model->mesh[k]].positions[i][axis];
                sum += model->weight[k] / 65536.0 * (x - base->positions[i][axis]);
                widen(&span, axis, x);
            }
            widen(&span, axis, sum);
        }
    }
    return span;
}

static q16 saturated(double x)
{
    return (q16)fmax(INT32_MIN, fmin(INT32_MAX, x));
}

static int16_t position16(int32_t x, int32_t origin, int32_t extent)
{
    const double p = floor(((double)x - origin) * 32768.0 / extent + .5);
    return (int16_t)fmax(-32767, fmin(32767, p));
}

/* Sets `to[0..count-1]` to the positions and normals of a mesh as the compact mesh stores them. */
static void store(const qtri_mesh *out, const struct obj_mesh *mesh, qtri_position16 *to,
                  qtri_normal8 *normals)
{
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const int32_t *p = mesh->positions[i];
        const int32_t *n = mesh->normals[i];
        to[i].x = position16(p[0], out->origin.x, out->extent);
        to[i].y = position16(p[1], out->origin.y, out->extent);
        to[i].z = position16(p[2], out->origin.z, out->extent);
        normals[i].x = (int8_t)lround(127.0 * n[0] / 65536.0);
        normals[i].y = (int8_t)lround(127.0 * n[1] / 65536.0);
        normals[i].z = (int8_t)lround(127.0 * n[2] / 65536.0);
    }
}

static void mix(const qtri_mesh *mesh, const struct scene_model *model,
                const qtri_position16 *positions, const qtri_normal8 *normals)
{
    qtri_position16 *mixed = mesh_array(mesh, MESH_POSITIONS16);
    qtri_normal8 *mixed_normals = mesh_array(mesh, MESH_NORMALS8);
    const uint32_t count = model->vertices;
    const int frames = model->mesh_count;
    if (model->kind == SCENE_TARGETS) {
        const qtri_position16 *targets[SCENE_MAX_MODEL_MESHES];
        for (int i = 1; i < frames; i++) {
            targets[i - 1] = positions + (size_t)i * count;
        }
        qtri_morph_targets(mixed, positions, targets, model->weight + 1, frames - 1, count);
        memcpy(mixed_normals, normals, count * sizeof *normals);
        return;
    }
    int32_t first = 0;
    q16 share = model->at;
    if (model->kind == SCENE_FRAMES) {
        const double turns = floor(model->at / 65536.0 / frames);
        const double at = model->at - turns * frames * 65536.0;
        first = (int32_t)(at / 65536.0);
        share = (q16)(at - first * 65536.0);
        qtri_frames_positions(mixed, positions, frames, count, model->at);
    } else {
        qtri_morph_positions(mixed, positions, positions + count, count, share);
    }
    const qtri_normal8 *to = normals + (size_t)((first + 1) % frames) * count;
    qtri_morph_normals(mixed_normals, normals + (size_t)first * count, to, count, share);
}

static void create_mixed(qtri_mesh *mesh, const struct scene *scene,
                         const struct scene_model *model)
{
    const struct obj_mesh *base = &scene->meshes[model->mesh[0]];
    const size_t all = (size_t)model->vertices * (size_t)model->mesh_count;
    const struct span span = span_of(scene, model);
    double center[3] = {0, 0, 0}, extent = 1;
    for (int axis = 0; axis < 3 && model->vertices > 0; axis++) {
        center[axis] = floor((span.least[axis] + span.greatest[axis]) / 2.0);
        extent = fmax(extent, span.greatest[axis] - center[axis]);
        extent = fmax(extent, center[axis] - span.least[axis]);
    }
    const qtri_vec3 origin = {saturated(center[0]), saturated(center[1]), saturated(center[2])};
    mesh->origin = origin;
    mesh->extent = saturated(ceil(extent));
    qtri_position16 *positions = xcalloc(all, sizeof *positions);
    qtri_normal8 *normals = xcalloc(all, sizeof *normals);
    mesh_array_create(mesh, MESH_POSITIONS16);
    mesh_array_create(mesh, MESH_NORMALS8);
    if (base->uvs != NULL) {
        mesh_array_fill(mesh, MESH_UVS, base->uvs[0]);
    }
    mesh_array_fill(mesh, MESH_TRIANGLES, (const int32_t *)base->triangles[0]);
    for (int i = 0; i < model->mesh_count; i++) {
        const size_t first = (size_t)i * model->vertices;
        store(mesh, &scene->meshes[model->mesh[i]], positions + first, normals + first);
    }
    mix(mesh, model, positions, normals);
    free(positions);
    free(normals);
}

void scene_model_create(qtri_mesh *mesh, const struct scene *scene, const struct scene_model *model)
{
    *mesh = (qtri_mesh){.vertex_count = model->vertices, .triangle_count = model->triangles};
    if (model->kind == SCENE_SHAPE) {
        create_shape(mesh, model);
    } else {
        create_mixed(mesh, scene, model);
    }
}
