/* SPDX-License-Identifier: MIT */
#include "mesh.h"
#include "../io/xalloc.h"
#include "blend.h"
#include "clip.h"
#include "light.h"
#include "model.h"
#include "raster.h"
#include "raster_stroke.h"

#include <math.h>
#include <stdlib.h>

void ref_draw_triangle(struct ref_target *target, const struct ref_triangle *triangle)
{
    for (int i = 0; i < 3; i++)
        if (!ref_vertex_is_finite(&triangle->vertex[i]))
            return;
    if (target->scene->wireframe && !target->depth_only)
        ref_raster_outline(target, triangle);
    else if (target->subpixel_bits == 0)
        ref_raster_homogeneous(target, triangle);
    else
        ref_raster_snapped(target, triangle);
}

static void set_color(struct ref_vertex *vertex, const double color[3], double factor)
{
    for (int c = 0; c < 3; c++)
        vertex->attribute[c] = 255.0 * color[c] * factor;
}

/* One mesh being drawn. */
struct drawing {
    const struct ref_model *mesh;
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

/* colored: the vertex whose colour it takes. */
static void light_vertex(const struct drawing *d, struct ref_vertex *vertex, size_t colored,
                         const double normal[3], const double position[3])
{
    double color[3];

    for (int c = 0; c < 3; c++)
        color[c] = d->mesh->colors ? d->mesh->colors[colored][c] / 255.0 : d->color[c];
    if (d->light->scene->lamps_on && d->light->scene->by_pixel)
        ref_light_by_pixel(d->light, normal, position, color, vertex->attribute);
    else if (d->light->scene->lamps_on)
        ref_illuminate(d->light, normal, position, color, vertex->attribute);
    else
        set_color(vertex, color, ref_intensity(d->light, normal));
}

static void transform_vertices(const struct drawing *d, const struct scene_op *op,
                               const struct ref_matrix *to_clip, struct ref_vertex *out)
{
    const struct ref_model *mesh = d->mesh;

    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const double *normal = mesh->normals[i];
        const double *at = mesh->positions[i];
        double position[4] = {at[0], at[1], at[2], 1};
        double clip[4];

        ref_matrix_transform(to_clip, position, clip);
        out[i] = (struct ref_vertex){clip[0], clip[1], clip[2], clip[3], {0}};
        light_vertex(d, &out[i], i, normal, position);
        out[i].attribute[REF_ALPHA] = ref_vertex_alpha(d->light->scene, op, i);
        if (d->light->scene->texture_sphere)
            set_sphere(&out[i], d->light, normal);
        else if (mesh->uvs) {
            out[i].attribute[REF_U] = mesh->uvs[i][0];
            out[i].attribute[REF_V] = mesh->uvs[i][1];
        }
    }
}

/* Two-sided, and showing its back: lit by the other side. Flat: lit as a whole. */
static void light_triangle(const struct drawing *d, struct ref_triangle *triangle,
                           const uint32_t index[3])
{
    const struct scene *scene = d->light->scene;
    bool turned = scene->reflection.two_sided && scene->lamps_on && ref_facing(triangle) < 0;
    const double *p[3];
    double normal[3], middle[3];

    for (int i = 0; i < 3; i++)
        p[i] = d->mesh->positions[index[i]];
    for (int k = 0; k < 3; k++)
        middle[k] = (p[0][k] + p[1][k] + p[2][k]) / 3.0;
    ref_face_normal(p[0], p[1], p[2], normal);
    for (int i = 0; i < 3 && (scene->flat || turned); i++) {
        const double *own = scene->flat ? normal : d->mesh->normals[index[i]];
        double n[3];

        for (int k = 0; k < 3; k++)
            n[k] = own[k] * (turned ? -1.0 : 1.0);
        light_vertex(d, &triangle->vertex[i], index[scene->flat ? scene->provoking : i], n,
                     scene->flat ? middle : p[i]);
    }
}

static void draw(struct ref_target *target, const struct scene_op *op, const struct drawing *d,
                 const struct ref_vertex *vertices)
{
    const struct ref_model *mesh = d->mesh;
    const struct scene *scene = target->scene;

    for (size_t t = 0; t < mesh->triangle_count; t++) {
        const uint32_t *index = mesh->triangles[t];
        struct ref_triangle triangle = {
            {vertices[index[0]], vertices[index[1]], vertices[index[2]]},
            op->id + (uint32_t)t,
            (mesh->uvs || scene->texture_sphere) && scene->texture.width != 0,
            scene->lamps_on && scene->by_pixel ? d->light : NULL,
        };
        light_triangle(d, &triangle, index);
        ref_draw_triangle(target, &triangle);
    }
}

/* The lines of a surface that hides what is behind it: depths first, then lines a little nearer. */
static void draw_hidden(struct ref_target *target, const struct scene_op *op,
                        const struct drawing *d, const struct ref_vertex *vertices)
{
    const struct scene *scene = target->scene;
    bool greater = scene->depth_compare == SCENE_GREATER || scene->depth_compare == SCENE_GEQUAL;

    target->depth_only = true;
    draw(target, op, d, vertices);
    target->depth_only = false;
    ref_target_bias(target, op->depth_bias + (greater ? scene->hidden_bias : -scene->hidden_bias));
    draw(target, op, d, vertices);
}

struct edge {
    uint32_t to;
    size_t next;
};

/* Edges that have been drawn, in lists by the lower of their vertices. */
struct edges {
    size_t count;
    size_t *first; /* of a vertex, from 1 on; 0: none. So are others */
    struct edge *edge;
};

static void edges_free(struct edges *all)
{
    free(all->first);
    free(all->edge);
}

/* Whether an edge is new, and then is no longer. */
static bool is_new(struct edges *all, uint32_t a, uint32_t b)
{
    uint32_t from = a < b ? a : b;
    uint32_t to = a < b ? b : a;

    for (size_t i = all->first[from]; i != 0; i = all->edge[i - 1].next)
        if (all->edge[i - 1].to == to)
            return false;
    all->edge[all->count] = (struct edge){to, all->first[from]};
    all->first[from] = ++all->count;
    return true;
}

/* Every edge of triangles that are seen, once, as a stroke by itself. */
static void draw_wide(struct ref_target *target, const struct scene_op *op, const struct drawing *d,
                      const struct ref_vertex *vertices)
{
    const struct ref_model *mesh = d->mesh;
    struct edges edges = {0, xcalloc(mesh->vertex_count, sizeof *edges.first),
                          xcalloc(3 * mesh->triangle_count, sizeof *edges.edge)};

    for (size_t t = 0; t < mesh->triangle_count; t++) {
        const uint32_t *index = mesh->triangles[t];
        struct ref_triangle triangle = {
            {vertices[index[0]], vertices[index[1]], vertices[index[2]]}, 0, false, NULL};
        if (!ref_facing_is_drawn(target, ref_facing(&triangle)))
            continue;
        light_triangle(d, &triangle, index);
        for (int i = 0; i < 3; i++)
            if (is_new(&edges, index[i], index[(i + 1) % 3]))
                ref_draw_edge(target, &triangle.vertex[i], &triangle.vertex[(i + 1) % 3],
                              &target->scene->wide, op->id + (uint32_t)t);
    }
    edges_free(&edges);
}

void ref_draw_mesh(struct ref_target *target, const struct scene_op *op,
                   const struct ref_matrix *projection, const struct ref_matrix *modelview)
{
    struct ref_matrix to_clip = ref_matrix_multiply(projection, modelview);
    struct ref_lighting light = ref_lighting_of(target->scene, projection, modelview);
    struct ref_model mesh;
    struct drawing d = {.mesh = &mesh, .light = &light};

    ref_model_create(&mesh, target->scene, op);
    struct ref_vertex *vertices = xcalloc(mesh.vertex_count, sizeof *vertices);
    for (int c = 0; c < 3; c++)
        d.color[c] = ref_unit_from_q16(op->u.mesh.color[c]);
    transform_vertices(&d, op, &to_clip, vertices);
    if (target->scene->wide_lines || target->scene->smooth_lines)
        draw_wide(target, op, &d, vertices);
    else
        (target->scene->hidden_lines ? draw_hidden : draw)(target, op, &d, vertices);
    ref_model_free(&mesh);
    free(vertices);
}
