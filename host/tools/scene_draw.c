/* SPDX-License-Identifier: MIT */
#include "scene_draw.h"

#include <stdlib.h>

/* The two matrix stacks while a scene is replayed. */
struct stacks {
    qtri_transform matrix[2][SCENE_STACK_DEPTH + 1];
    int top[2];
    int current; /* 0 projection, 1 modelview */
};

static void load(qtri_transform *out, const int32_t number[16])
{
    qtri_mat4 m;
    for (int column = 0; column < 4; column++) {
        for (int row = 0; row < 4; row++) {
            m.m[row][column] = number[4 * column + row];
        }
    }
    qtri_transform_from_mat4(out, &m);
}

static qtri_vec3 vec3_at(const int32_t *n)
{
    qtri_vec3 v = {n[0], n[1], n[2]};
    return v;
}

static void apply(qtri_transform *current, const struct scene_op *op)
{
    const int32_t *n = op->u.number;
    qtri_transform given;
    switch (op->kind) {
    case SCENE_IDENTITY:
        qtri_transform_identity(current);
        break;
    case SCENE_LOAD:
        load(current, n);
        break;
    case SCENE_MULT:
        load(&given, n);
        qtri_transform_mul(current, current, &given);
        break;
    case SCENE_LOOKAT:
        qtri_transform_look_at(current, vec3_at(n), vec3_at(n + 3), vec3_at(n + 6));
        break;
    case SCENE_PERSPECTIVE:
        qtri_transform_perspective(current, n[0], n[1], n[2], n[3]);
        break;
    case SCENE_FRUSTUM:
        qtri_transform_frustum(current, n[0], n[1], n[2], n[3], n[4], n[5]);
        break;
    case SCENE_ORTHO:
        qtri_transform_ortho(current, n[0], n[1], n[2], n[3], n[4], n[5]);
        break;
    case SCENE_TRANSLATE:
        qtri_transform_translate(current, vec3_at(n));
        break;
    case SCENE_ROTATE:
        qtri_transform_rotate(current, n[0], vec3_at(n + 1));
        break;
    case SCENE_SCALE:
        qtri_transform_scale(current, vec3_at(n));
        break;
    default:
        break;
    }
}

static void apply_to_stacks(struct stacks *stacks, const struct scene_op *op)
{
    int *top = &stacks->top[stacks->current];
    qtri_transform *matrices = stacks->matrix[stacks->current];
    switch (op->kind) {
    case SCENE_MODE_PROJECTION:
        stacks->current = 0;
        break;
    case SCENE_MODE_MODELVIEW:
        stacks->current = 1;
        break;
    case SCENE_PUSH:
        matrices[*top + 1] = matrices[*top];
        (*top)++;
        break;
    case SCENE_POP:
        (*top)--;
        break;
    default:
        apply(&matrices[*top], op);
        break;
    }
}

static uint8_t color_8(int32_t c)
{
    return (uint8_t)((c * 255 + 32768) >> 16); /* 0 <= c <= 1 */
}

static qtri_rgb rgb_8(const int32_t color[3])
{
    qtri_rgb rgb = {color_8(color[0]), color_8(color[1]), color_8(color[2])};
    return rgb;
}

static qtri_rgb rgb_of_id(uint32_t id)
{
    qtri_rgb rgb = {(uint8_t)(id >> 16), (uint8_t)(id >> 8), (uint8_t)id};
    return rgb;
}

static qtri_compare compare_of(const struct scene *scene)
{
    static const qtri_compare compare[] = {
        [SCENE_LESS] = QTRI_LESS,          [SCENE_LEQUAL] = QTRI_LESS_EQUAL,
        [SCENE_GREATER] = QTRI_GREATER,    [SCENE_GEQUAL] = QTRI_GREATER_EQUAL,
        [SCENE_ALWAYS] = QTRI_ALWAYS,      [SCENE_EQUAL] = QTRI_EQUAL,
        [SCENE_NOTEQUAL] = QTRI_NOT_EQUAL, [SCENE_NEVER] = QTRI_NEVER,
    };
    return scene->depth_test ? compare[scene->depth_compare] : QTRI_DEPTH_OFF;
}

static qtri_material material_of(const struct scene_resources *resources, enum scene_pass pass)
{
    static const qtri_cull cull[] = {
        [SCENE_CULL_NONE] = QTRI_CULL_NONE,
        [SCENE_CULL_BACK] = QTRI_CULL_BACK,
        [SCENE_CULL_FRONT] = QTRI_CULL_FRONT,
    };
    const struct scene *scene = resources->scene;
    qtri_material material = qtri_material_default();
    material.interpolation = scene->screen_linear ? QTRI_SCREEN_LINEAR : QTRI_PERSPECTIVE;
    material.cull = cull[scene->cull];
    material.fill = scene->wireframe ? &qtri_wireframe : NULL;
    material.depth_compare = compare_of(scene);
    material.depth_read_only = !scene->depth_write;
    if (pass == SCENE_IDS) {
        material.shading = QTRI_FLAT_LAST;
        material.texture = resources->mask_texels != NULL ? &resources->mask : NULL;
        return material; /* modulated: white leaves an id as it is */
    }
    if (scene->flat) {
        material.shading = scene->provoking == 0 ? QTRI_FLAT_FIRST : QTRI_FLAT_LAST;
    }
    material.texture = resources->texels != NULL ? &resources->texture : NULL;
    material.texture_mode = scene->texture_mode == SCENE_REPLACE ? QTRI_REPLACE : QTRI_MODULATE;
    return material;
}

/* One scene being drawn into one surface. */
struct drawing {
    const struct scene_resources *resources;
    const qtri_surface *surface;
    enum scene_pass pass;
    qtri_view view;
    qtri_transform modelview;
    qtri_material material;
};

static void draw_triangle(struct drawing *d, const struct scene_op *op)
{
    qtri_corner corner[3];
    for (int i = 0; i < 3; i++) {
        const struct scene_vertex *v = &op->u.triangle.vertex[i];
        qtri_vec4 position = {v->position[0], v->position[1], v->position[2], v->position[3]};
        qtri_vec2 uv = {v->uv[0], v->uv[1]};
        corner[i].position = position;
        corner[i].color = d->pass == SCENE_IDS ? rgb_of_id(op->id) : rgb_8(v->color);
        corner[i].uv = uv;
    }
    qtri_material material = d->material;
    if (!op->u.triangle.textured) {
        material.texture = NULL;
    }
    qtri_draw_triangles(d->surface, &d->view, &d->modelview, corner, 3, &material);
}

/* Triangle by triangle, each in the colour of its id. */
static void draw_part_ids(struct drawing *d, const qtri_mesh *mesh, uint32_t id)
{
    enum { BATCH = 256 };
    qtri_corner corners[3 * BATCH];
    uint32_t count = 0;
    qtri_material material = d->material;
    if (mesh->uvs == NULL) {
        material.texture = NULL;
    }
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        for (int j = 0; j < 3; j++) {
            uint32_t vertex = mesh->triangles[i][j];
            const qtri_vec3 *p = &mesh->positions[vertex];
            qtri_corner corner = {{p->x, p->y, p->z, Q16_ONE}, rgb_of_id(id + i), {0, 0}};
            if (mesh->uvs != NULL) {
                corner.uv = mesh->uvs[vertex];
            }
            corners[count++] = corner;
        }
        if (count == 3 * BATCH || i + 1 == mesh->triangle_count) {
            qtri_draw_triangles(d->surface, &d->view, &d->modelview, corners, count, &material);
            count = 0;
        }
    }
}

static void draw_mesh(struct drawing *d, const struct scene_op *op)
{
    const struct scene_parts *parts = &d->resources->meshes[op->u.mesh.mesh];
    uint32_t id = op->id;
    d->material.color = rgb_8(op->u.mesh.color);
    for (size_t i = 0; i < parts->count; i++) {
        const qtri_mesh *mesh = &parts->part[i].mesh;
        if (d->pass == SCENE_IDS) {
            draw_part_ids(d, mesh, id);
        } else {
            qtri_draw_mesh(d->surface, &d->view, &d->modelview, mesh, &d->material);
        }
        id += mesh->triangle_count;
    }
}

void scene_draw(const struct scene_resources *resources, const qtri_surface *surface,
                enum scene_pass pass)
{
    const struct scene *scene = resources->scene;
    const qtri_rgb black = {0, 0, 0};
    qtri_surface_clear(surface, pass == SCENE_IDS ? black : rgb_8(scene->clear),
                       (uint16_t)(((int64_t)scene->clear_depth * 65535 + 32768) >> 16));

    struct drawing d = {.resources = resources, .surface = surface, .pass = pass};
    qtri_view_init(&d.view, scene->width, scene->height);
    d.view.viewport.depth_near = scene->depth_near;
    d.view.viewport.depth_far = scene->depth_far;
    d.view.vertices = resources->vertices;
    d.view.vertex_count = resources->vertex_count;
    const qtri_vec3 *towards = &resources->light.towards;
    d.view.light = (towards->x | towards->y | towards->z) != 0 ? &resources->light : NULL;
    d.material = material_of(resources, pass);

    struct stacks *stacks = calloc(1, sizeof *stacks);
    if (stacks == NULL) {
        abort(); /* a few kilobytes: nothing sensible is left to do */
    }
    stacks->current = 1;
    qtri_transform_identity(&stacks->matrix[0][0]);
    qtri_transform_identity(&stacks->matrix[1][0]);
    for (size_t i = 0; i < scene->op_count; i++) {
        const struct scene_op *op = &scene->ops[i];
        if (op->kind != SCENE_TRIANGLE && op->kind != SCENE_MESH) {
            apply_to_stacks(stacks, op);
            continue;
        }
        d.view.projection = stacks->matrix[0][stacks->top[0]];
        d.modelview = stacks->matrix[1][stacks->top[1]];
        if (op->kind == SCENE_TRIANGLE) {
            draw_triangle(&d, op);
        } else {
            draw_mesh(&d, op);
        }
    }
    free(stacks);
}
