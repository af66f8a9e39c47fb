/* SPDX-License-Identifier: MIT */
#include "mesh.h"
#include "clip.h"
#include "raster.h"

#include <math.h>
#include <stdlib.h>

struct lighting {
    bool on;
    double towards[3]; /* unit, eye space */
    double ambient, diffuse;
    double normal_matrix[3][3];
};

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

static struct lighting lighting_of(const struct scene_light *light,
                                   const struct ref_matrix *modelview)
{
    struct lighting r = {
        .ambient = (double)light->ambient / 65536.0,
        .diffuse = (double)light->diffuse / 65536.0,
    };

    from_q16(light->towards, 3, r.towards);
    r.on = ref_dot3(r.towards, r.towards) > 0.0;
    ref_normalise3(r.towards);
    ref_matrix_normal(modelview, r.normal_matrix);
    return r;
}

/* Lambert's law for a normal in object space, of any length. */
static double intensity(const struct lighting *light, const double normal[3])
{
    double n[3];

    if (!light->on)
        return 1.0;
    for (int i = 0; i < 3; i++)
        n[i] = ref_dot3(light->normal_matrix[i], normal);
    ref_normalise3(n);
    double reflected = fmax(0.0, ref_dot3(n, light->towards));
    return fmax(0.0, fmin(1.0, light->ambient + light->diffuse * reflected));
}

static void set_color(struct ref_vertex *vertex, const double color[3], double factor)
{
    for (int c = 0; c < 3; c++)
        vertex->attribute[c] = 255.0 * color[c] * factor;
}

static void transform_vertices(const struct obj_mesh *mesh, const struct ref_matrix *to_clip,
                               const struct lighting *light, const double color[3],
                               struct ref_vertex *out)
{
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        double position[4] = {0, 0, 0, 1};
        double normal[3];

        from_q16(mesh->positions[i], 3, position);
        ref_matrix_transform(to_clip, position, position);
        out[i] = (struct ref_vertex){position[0], position[1], position[2], position[3], {0}};
        from_q16(mesh->normals[i], 3, normal);
        set_color(&out[i], color, intensity(light, normal));
        if (mesh->uvs)
            from_q16(mesh->uvs[i], 2, &out[i].attribute[REF_U]);
    }
}

static double face_intensity(const struct obj_mesh *mesh, const uint32_t index[3],
                             const struct lighting *light)
{
    double p[3][3], along[3], across[3], normal[3];

    for (int i = 0; i < 3; i++)
        from_q16(mesh->positions[index[i]], 3, p[i]);
    for (int k = 0; k < 3; k++) {
        along[k] = p[1][k] - p[0][k];
        across[k] = p[2][k] - p[0][k];
    }
    ref_cross3(along, across, normal);
    return intensity(light, normal);
}

bool ref_draw_mesh(struct ref_target *target, const struct scene_op *op,
                   const struct ref_matrix *projection, const struct ref_matrix *modelview)
{
    const struct scene *scene = target->scene;
    const struct obj_mesh *mesh = &scene->meshes[op->u.mesh.mesh];
    struct ref_matrix to_clip = ref_matrix_multiply(projection, modelview);
    struct lighting light = lighting_of(&scene->light, modelview);
    struct ref_vertex *vertices;
    double color[3];

    if (mesh->triangle_count == 0)
        return true;
    vertices = malloc(mesh->vertex_count * sizeof *vertices);
    if (!vertices)
        return false;
    for (int c = 0; c < 3; c++)
        color[c] = fmax(0.0, fmin(1.0, (double)op->u.mesh.color[c] / 65536.0));
    transform_vertices(mesh, &to_clip, &light, color, vertices);

    for (size_t t = 0; t < mesh->triangle_count; t++) {
        const uint32_t *index = mesh->triangles[t];
        struct ref_triangle triangle = {
            {vertices[index[0]], vertices[index[1]], vertices[index[2]]},
            op->id + (uint32_t)t,
            mesh->uvs && scene->texture.width != 0,
        };
        double face = scene->flat ? face_intensity(mesh, index, &light) : 0.0;
        for (int i = 0; i < 3 && scene->flat; i++)
            set_color(&triangle.vertex[i], color, face);
        ref_draw_triangle(target, &triangle);
    }
    free(vertices);
    return true;
}
