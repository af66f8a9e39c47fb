/* SPDX-License-Identifier: MIT */
#include "mesh.h"
#include "blend.h"
#include "clip.h"
#include "light.h"
#include "raster.h"

#include <math.h>
#include <stdlib.h>

void ref_draw_triangle(struct ref_target *target, const struct ref_triangle *triangle)
{
    for (int i = 0; i < 3; i++)
        if (!ref_vertex_is_finite(&triangle->vertex[i]))
            return;
    if (target->scene->wireframe)
        ref_raster_outline(target, triangle);
    else if (target->subpixel_bits == 0)
        ref_raster_homogeneous(target, triangle);
    else
        ref_raster_snapped(target, triangle);
}

static void from_q16(const int32_t *in, int count, double *out)
{
    for (int i = 0; i < count; i++)
        out[i] = (double)in[i] / 65536.0;
}

static void set_color(struct ref_vertex *vertex, const double color[3], double factor)
{
    for (int c = 0; c < 3; c++)
        vertex->attribute[c] = 255.0 * color[c] * factor;
}

/* One mesh being drawn. */
struct drawing {
    const struct obj_mesh *mesh;
    const struct ref_lighting *light;
    double color[3];
};

/* Of a sphere's picture, by the normal in eye space. */
static void set_sphere(struct ref_vertex *vertex, const struct ref_lighting *light,
                       const double normal[3])
{
    double n[3];

    ref_light_normal(light, normal, n);
    vertex->attribute[REF_U] = (1.0 + n[0]) / 2.0;
    vertex->attribute[REF_V] = (1.0 - n[1]) / 2.0;
}

static void light_vertex(const struct drawing *d, struct ref_vertex *vertex, const double normal[3],
                         const double position[3])
{
    if (d->light->scene->lamps_on)
        ref_illuminate(d->light, normal, position, d->color, vertex->attribute);
    else
        set_color(vertex, d->color, ref_intensity(d->light, normal));
}

static void transform_vertices(const struct drawing *d, const struct scene_op *op,
                               const struct ref_matrix *to_clip, struct ref_vertex *out)
{
    const struct obj_mesh *mesh = d->mesh;

    for (size_t i = 0; i < mesh->vertex_count; i++) {
        double position[4] = {0, 0, 0, 1};
        double clip[4];
        double normal[3];

        from_q16(mesh->positions[i], 3, position);
        ref_matrix_transform(to_clip, position, clip);
        out[i] = (struct ref_vertex){clip[0], clip[1], clip[2], clip[3], {0}};
        from_q16(mesh->normals[i], 3, normal);
        light_vertex(d, &out[i], normal, position);
        out[i].attribute[REF_ALPHA] = ref_vertex_alpha(d->light->scene, op, i);
        if (d->light->scene->texture_sphere)
            set_sphere(&out[i], d->light, normal);
        else if (mesh->uvs)
            from_q16(mesh->uvs[i], 2, &out[i].attribute[REF_U]);
    }
}

/* Two-sided, and showing its back: lit by the other side. Flat: lit as a whole. */
static void light_triangle(const struct drawing *d, struct ref_triangle *triangle,
                           const uint32_t index[3])
{
    const struct scene *scene = d->light->scene;
    bool turned = scene->reflection.two_sided && scene->lamps_on && ref_facing(triangle) < 0;
    double p[3][3], normal[3], middle[3];

    for (int i = 0; i < 3; i++)
        from_q16(d->mesh->positions[index[i]], 3, p[i]);
    for (int k = 0; k < 3; k++)
        middle[k] = (p[0][k] + p[1][k] + p[2][k]) / 3.0;
    ref_face_normal(p[0], p[1], p[2], normal);
    for (int i = 0; i < 3 && (scene->flat || turned); i++) {
        double n[3];

        from_q16(d->mesh->normals[index[i]], 3, n);
        for (int k = 0; k < 3; k++)
            n[k] = (scene->flat ? normal[k] : n[k]) * (turned ? -1.0 : 1.0);
        light_vertex(d, &triangle->vertex[i], n, scene->flat ? middle : p[i]);
    }
}

bool ref_draw_mesh(struct ref_target *target, const struct scene_op *op,
                   const struct ref_matrix *projection, const struct ref_matrix *modelview)
{
    const struct scene *scene = target->scene;
    const struct obj_mesh *mesh = &scene->meshes[op->u.mesh.mesh];
    struct ref_matrix to_clip = ref_matrix_multiply(projection, modelview);
    struct ref_lighting light = ref_lighting_of(scene, projection, modelview);
    struct drawing d = {.mesh = mesh, .light = &light};
    struct ref_vertex *vertices;

    if (mesh->triangle_count == 0)
        return true;
    vertices = malloc(mesh->vertex_count * sizeof *vertices);
    if (!vertices)
        return false;
    for (int c = 0; c < 3; c++)
        d.color[c] = fmax(0.0, fmin(1.0, (double)op->u.mesh.color[c] / 65536.0));
    transform_vertices(&d, op, &to_clip, vertices);

    for (size_t t = 0; t < mesh->triangle_count; t++) {
        const uint32_t *index = mesh->triangles[t];
        struct ref_triangle triangle = {
            {vertices[index[0]], vertices[index[1]], vertices[index[2]]},
            op->id + (uint32_t)t,
            (mesh->uvs || scene->texture_sphere) && scene->texture.width != 0,
        };
        light_triangle(&d, &triangle, index);
        ref_draw_triangle(target, &triangle);
    }
    free(vertices);
    return true;
}
