/* SPDX-License-Identifier: MIT */
#include "model.h"
#include "../io/xalloc.h"
#include "matrix.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void allocate(struct ref_model *model, size_t vertices, size_t triangles, bool textured)
{
    *model = (struct ref_model){
        .positions = xcalloc(vertices, sizeof *model->positions),
        .normals = xcalloc(vertices, sizeof *model->normals),
        .uvs = textured ? xcalloc(vertices, sizeof *model->uvs) : NULL,
        .triangles = xcalloc(triangles, sizeof *model->triangles),
        .vertex_count = vertices,
        .triangle_count = triangles,
    };
}

void ref_model_free(struct ref_model *model)
{
    free(model->positions);
    free(model->normals);
    free(model->uvs);
    free(model->triangles);
    *model = (struct ref_model){0};
}

/* ---- Meshes that are read ---- */

static void create_read(struct ref_model *model, const struct obj_mesh *mesh)
{
    allocate(model, mesh->vertex_count, mesh->triangle_count, mesh->uvs != NULL);
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        ref_from_q16(mesh->positions[i], 3, model->positions[i]);
        ref_from_q16(mesh->normals[i], 3, model->normals[i]);
        if (mesh->uvs)
            ref_from_q16(mesh->uvs[i], 2, model->uvs[i]);
    }
    model->colors = (const uint8_t(*)[3])mesh->colors;
    if (mesh->triangle_count > 0)
        memcpy(model->triangles, mesh->triangles, mesh->triangle_count * sizeof *mesh->triangles);
}

/* ---- Mixed ---- */

static void stored_normal(const struct obj_mesh *mesh, size_t i, double out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = round(127.0 * mesh->normals[i][k] / 65536.0);
}

/* (1 - t) a + t b of length 1; a where there is nothing left. */
static void mix_normals(const struct obj_mesh *a, const struct obj_mesh *b, double t, size_t i,
                        double out[3])
{
    double from[3], to[3];

    stored_normal(a, i, from);
    stored_normal(b, i, to);
    ref_normalise3(from);
    ref_normalise3(to);
    for (int k = 0; k < 3; k++)
        out[k] = from[k] + t * (to[k] - from[k]);
    if (ref_dot3(out, out) < 1e-12)
        memcpy(out, from, sizeof from);
}

static void mix_two(struct ref_model *model, const struct obj_mesh *a, const struct obj_mesh *b,
                    double t)
{
    for (size_t i = 0; i < model->vertex_count; i++) {
        for (int k = 0; k < 3; k++) {
            double from = a->positions[i][k] / 65536.0, to = b->positions[i][k] / 65536.0;
            model->positions[i][k] = from + t * (to - from);
        }
        mix_normals(a, b, t, i, model->normals[i]);
    }
}

static void mix_targets(struct ref_model *model, const struct scene *scene,
                        const struct scene_model *of)
{
    const struct obj_mesh *base = &scene->meshes[of->mesh[0]];

    for (size_t i = 0; i < model->vertex_count; i++) {
        for (int j = 1; j < of->mesh_count; j++) {
            const struct obj_mesh *target = &scene->meshes[of->mesh[j]];
            for (int k = 0; k < 3; k++)
                model->positions[i][k] +=
                    of->weight[j] / 65536.0 *
                    ((double)target->positions[i][k] - base->positions[i][k]) / 65536.0;
        }
        stored_normal(base, i, model->normals[i]);
    }
}

static void create_mixed(struct ref_model *model, const struct scene *scene,
                         const struct scene_model *of)
{
    double at = of->at / 65536.0;
    int first = 0;

    create_read(model, &scene->meshes[of->mesh[0]]);
    model->colors = NULL; /* what is mixed has the one of its statement */
    if (of->kind == SCENE_TARGETS) {
        mix_targets(model, scene, of);
        return;
    }
    if (of->kind == SCENE_FRAMES) {
        at -= of->mesh_count * floor(at / of->mesh_count);
        first = (int)at;
        at -= first;
    }
    mix_two(model, &scene->meshes[of->mesh[first]],
            &scene->meshes[of->mesh[(first + 1) % of->mesh_count]], at);
}

void ref_model_create(struct ref_model *model, const struct scene *scene, const struct scene_op *op)
{
    const struct scene_model *of = op->kind == SCENE_MESH ? NULL : &scene->models[op->u.mesh.mesh];

    if (of == NULL) {
        create_read(model, &scene->meshes[op->u.mesh.mesh]);
    } else if (of->kind != SCENE_SHAPE) {
        create_mixed(model, scene, of);
    } else {
        allocate(model, of->vertices, of->triangles, true);
        ref_shape(model, of);
    }
}
