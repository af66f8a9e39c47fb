/* SPDX-License-Identifier: MIT */
#include "scene_draw.h"

#include <math.h>
#include <stdlib.h>

#include "mesh_neighbours.h"
#include "scene_stroke.h"

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

qtri_rgb scene_rgb(const int32_t color[3])
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
    if (scene->smooth_lines && pass != SCENE_IDS) {
        material.fill = &qtri_smooth_wireframe;
    }
    material.depth_compare = compare_of(scene);
    material.depth_read_only = !scene->depth_write;
    material.alpha = color_8(scene->alpha);
    if (pass == SCENE_IDS) {
        material.shading = QTRI_FLAT_LAST;
        material.blend = scene->blend == SCENE_BLEND_SCREENDOOR ? &qtri_blend_screen_door : NULL;
        material.texture = resources->mask_texels != NULL ? &resources->mask : NULL;
        return material; /* modulated: white leaves an id as it is */
    }
    if (scene->flat) {
        material.shading = scene->provoking == 0 ? QTRI_FLAT_FIRST : QTRI_FLAT_LAST;
    }
    static const qtri_blend *const blends[] = {
        [SCENE_BLEND_OFF] = NULL,
        [SCENE_BLEND_ALPHA] = &qtri_blend_alpha,
        [SCENE_BLEND_ADD] = &qtri_blend_add,
        [SCENE_BLEND_MULTIPLY] = &qtri_blend_multiply,
        [SCENE_BLEND_NONE] = &qtri_blend_none,
        [SCENE_BLEND_REPLACE] = &qtri_blend_replace,
        [SCENE_BLEND_SCREENDOOR] = &qtri_blend_screen_door,
    };
    material.blend = blends[scene->blend];
    material.keep = (uint8_t)(scene->keep[0] * QTRI_KEEP_RED | scene->keep[1] * QTRI_KEEP_GREEN |
                              scene->keep[2] * QTRI_KEEP_BLUE);
    if (material.keep != 0 && material.blend == NULL) {
        material.blend = &qtri_blend_replace;
    }
    material.texture = resources->texels != NULL ? &resources->texture : NULL;
    material.texture_mode = scene->texture_mode == SCENE_REPLACE ? QTRI_REPLACE : QTRI_MODULATE;
    material.reflection = &resources->reflection;
    return material;
}

/* One scene being drawn into one surface. */
struct drawing {
    const struct scene_resources *resources;
    const qtri_surface *surface;
    enum scene_pass pass;
    qtri_edges *edges; /* to note outlines on, for SCENE_EDGES */
    qtri_view view;
    qtri_transform modelview;
    qtri_material material;
    qtri_fog fog; /* the material's */
};

static void set_fog(struct drawing *d)
{
    const struct scene_fog *fog = &d->resources->scene->fog;
    const qtri_fog_range range = {fog->range[0], fog->range[1], false};
    const qtri_rgb color = scene_rgb(fog->color);
    switch (fog->kind) {
    case SCENE_FOG_LINEAR:
        qtri_fog_linear(&d->fog, color, range, fog->number[0], fog->number[1]);
        break;
    case SCENE_FOG_EXP:
        qtri_fog_exp(&d->fog, color, range, fog->number[0]);
        break;
    case SCENE_FOG_EXP2:
        qtri_fog_exp2(&d->fog, color, range, fog->number[0]);
        break;
    default:
        return;
    }
    d->material.fog = &d->fog;
}

/* The nearest unit normal in Q2.14. */
static qtri_normal normal_of(const int32_t n[3])
{
    const double length = sqrt((double)n[0] * n[0] + (double)n[1] * n[1] + (double)n[2] * n[2]);
    qtri_normal normal = {0, 0, 0};
    if (length > 0.0) {
        normal.x = (int16_t)lround(n[0] * 16384.0 / length);
        normal.y = (int16_t)lround(n[1] * 16384.0 / length);
        normal.z = (int16_t)lround(n[2] * 16384.0 / length);
    }
    return normal;
}

static void draw_triangle(struct drawing *d, const struct scene_op *op)
{
    qtri_corner corner[3];
    qtri_normal normal[3];
    for (int i = 0; i < 3; i++) {
        const struct scene_vertex *v = &op->u.triangle.vertex[i];
        qtri_vec4 position = {v->position[0], v->position[1], v->position[2], v->position[3]};
        qtri_vec2 uv = {v->uv[0], v->uv[1]};
        corner[i].position = position;
        corner[i].color = d->pass == SCENE_IDS ? rgb_of_id(op->id) : scene_rgb(v->color);
        corner[i].uv = uv;
        normal[i] = normal_of(v->normal);
    }
    qtri_material material = d->material;
    if (!op->u.triangle.textured) {
        material.texture = NULL;
    }
    const bool is_lit = d->pass == SCENE_COLORS && d->resources->lights.model != NULL;
    d->view.lights = is_lit ? &d->resources->lights : NULL;
    qtri_draw_lit_triangles(d->surface, &d->view, &d->modelview, corner, normal, 3, &material);
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

static void note_edges(struct drawing *d, const qtri_mesh *mesh)
{
    qtri_outline outline;
    const uint32_t words =
        QTRI_OUTLINE_WORDS(mesh->triangle_count) + QTRI_OUTLINE_SUMS(mesh->vertex_count);
    uint32_t *memory = malloc(words * sizeof *memory);
    if (memory != NULL && qtri_outline_init(&outline, mesh, memory, words) == QTRI_OK) {
        outline.creases = d->material.shading != QTRI_SMOOTH;
        (void)qtri_find_outline(d->surface, &d->view, &d->modelview, &d->material, &outline);
        qtri_edges_note(d->edges, &outline);
    }
    free(memory);
}

static void draw_mesh(struct drawing *d, const struct scene_op *op)
{
    const struct scene_parts *parts = &d->resources->meshes[op->u.mesh.mesh];
    uint32_t id = op->id;
    const bool is_lit = d->pass == SCENE_COLORS && d->resources->scene->lamps_on;
    d->view.lights = is_lit ? &d->resources->lights : NULL;
    d->material.color = scene_rgb(op->u.mesh.color);
    for (size_t i = 0; i < parts->count; i++) {
        const qtri_mesh *mesh = &parts->part[i].mesh;
        if (d->pass == SCENE_IDS) {
            draw_part_ids(d, mesh, id);
        } else if (d->pass == SCENE_EDGES) {
            note_edges(d, mesh);
        } else {
            qtri_mesh shown = *mesh;
            if (d->resources->sphere_uvs != NULL) {
                qtri_sphere_map(d->resources->sphere_uvs, &d->view.camera, &d->modelview, mesh);
                shown.uvs16 = d->resources->sphere_uvs;
            }
            qtri_draw_mesh(d->surface, &d->view, &d->modelview, &shown, &d->material);
        }
        id += mesh->triangle_count;
    }
}

/*
 * The outlines of `count` triangles that follow each other, as of one mesh. Homogeneous ones have
 * none: a mesh has no w.
 */
static void note_triangles(struct drawing *d, const struct scene_op *ops, size_t count)
{
    count = count < 1 ? 1 : count; /* never 0 */
    qtri_vec3 *positions = malloc(3 * count * sizeof *positions);
    uint16_t(*triangles)[3] = malloc(count * sizeof *triangles);
    uint16_t(*neighbours)[3] = malloc(count * sizeof *neighbours);
    qtri_vertex *vertices = malloc(3 * count * sizeof *vertices);
    qtri_mesh mesh = {.positions = positions, .triangles = (const uint16_t(*)[3])triangles};
    if (positions != NULL && triangles != NULL && neighbours != NULL && vertices != NULL) {
        for (size_t i = 0; i < count; i++) {
            const struct scene_vertex *v = ops[i].u.triangle.vertex;
            bool is_plain = true;
            for (int k = 0; k < 3; k++) {
                const qtri_vec3 p = {v[k].position[0], v[k].position[1], v[k].position[2]};
                positions[mesh.vertex_count + (uint32_t)k] = p;
                triangles[mesh.triangle_count][k] = (uint16_t)(mesh.vertex_count + (uint32_t)k);
                is_plain = is_plain && v[k].position[3] == Q16_ONE;
            }
            mesh.vertex_count += is_plain ? 3 : 0;
            mesh.triangle_count += is_plain ? 1 : 0;
        }
        d->view.vertices = vertices;
        d->view.vertex_count = mesh.vertex_count;
        if (mesh.triangle_count > 0 && mesh_neighbours_make(&mesh, neighbours)) {
            note_edges(d, &mesh);
        }
        d->view.vertices = d->resources->vertices;
        d->view.vertex_count = d->resources->vertex_count;
    }
    free(positions);
    free(triangles);
    free(neighbours);
    free(vertices);
}

/* How many triangles follow each other from this operation on, at most what a mesh numbers. */
static size_t run_of(const struct scene *scene, size_t first)
{
    enum { RUN_MAX = 65536 / 3 };
    size_t count = 0;
    while (first + count < scene->op_count && count < RUN_MAX &&
           scene->ops[first + count].kind == SCENE_TRIANGLE) {
        count++;
    }
    return count;
}

static void replay(struct drawing *d, struct stacks *stacks)
{
    const struct scene *scene = d->resources->scene;
    stacks->current = 1;
    qtri_transform_identity(&stacks->matrix[0][0]);
    qtri_transform_identity(&stacks->matrix[1][0]);
    for (size_t i = 0; i < scene->op_count; i++) {
        const struct scene_op *op = &scene->ops[i];
        if (op->kind < SCENE_TRIANGLE) {
            apply_to_stacks(stacks, op);
            continue;
        }
        if (op->kind == SCENE_PAINT) {
            if (d->pass == SCENE_COLORS) {
                scene_paint(d->resources, d->surface, &op->u.paint);
            }
            continue;
        }
        d->view.projection = stacks->matrix[0][stacks->top[0]];
        d->modelview = stacks->matrix[1][stacks->top[1]];
        d->material.depth_bias = op->depth_bias;
        if (d->resources->jitter_log2 > 0) {
            qtri_view_jitter(&d->view, &d->view, d->resources->jitter, d->resources->jitter_log2);
        }
        if (op->kind == SCENE_MESH) {
            draw_mesh(d, op);
        } else if (op->kind == SCENE_STROKE) {
            const qtri_rgb id = rgb_of_id(op->id);
            if (d->pass != SCENE_EDGES) {
                scene_draw_stroke(scene, op, d->surface, &d->view, &d->modelview, &d->material,
                                  d->pass == SCENE_IDS ? &id : NULL);
            }
        } else if (d->pass == SCENE_EDGES) {
            const size_t count = run_of(scene, i);
            note_triangles(d, op, count);
            i += count - 1;
        } else {
            draw_triangle(d, op);
        }
    }
}

/* Memory for the pass over a surface with depth. */
static uint32_t *begin_edges(qtri_edges *edges, const qtri_surface *surface)
{
    const uint32_t words =
        QTRI_EDGES_WORDS(surface->width, surface->rows, surface->format->pixels->bytes);
    uint32_t *memory = malloc(words * sizeof *memory);
    if (memory != NULL && qtri_edges_begin(edges, surface, memory, words) != QTRI_OK) {
        free(memory);
        memory = NULL;
    }
    return memory;
}

void scene_draw(const struct scene_resources *resources, const qtri_surface *surface,
                enum scene_pass pass)
{
    const struct scene *scene = resources->scene;
    const qtri_rgb black = {0, 0, 0};
    qtri_edges edges;
    uint32_t *memory = NULL;
    struct drawing d = {.resources = resources, .surface = surface, .pass = pass, .edges = &edges};
    if (pass == SCENE_EDGES) {
        memory = begin_edges(&edges, surface);
        if (memory == NULL) {
            return;
        }
    } else {
        qtri_samples_clear(surface, pass == SCENE_IDS ? black : scene_rgb(scene->clear));
        qtri_samples_clear_depth(surface, scene->clear_depth);
    }
    qtri_view_init(&d.view, surface->width, surface->height);
    d.view.viewport.depth_near = scene->depth_near;
    d.view.viewport.depth_far = scene->depth_far;
    d.view.vertices = resources->vertices;
    d.view.vertex_count = resources->vertex_count;
    const qtri_vec3 *towards = &resources->light.towards;
    d.view.light = (towards->x | towards->y | towards->z) != 0 ? &resources->light : NULL;
    d.material = material_of(resources, pass);
    if (pass != SCENE_IDS) {
        set_fog(&d);
    }

    struct stacks *stacks = calloc(1, sizeof *stacks);
    if (stacks == NULL) {
        abort(); /* a few kilobytes: nothing sensible is left to do */
    }
    replay(&d, stacks);
    free(stacks);
    if (pass == SCENE_EDGES) {
        qtri_edges_blend(&edges);
    }
    free(memory);
}
