/* SPDX-License-Identifier: MIT */
#include "scene_draw.h"

#include <math.h>
#include <stdlib.h>

#include "../assets/mesh_arrays.h"
#include "../io/xalloc.h"
#include "mesh_neighbours.h"
#include "scene_color.h"
#include "scene_transform.h"

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
    material.alpha = scene_byte(scene->alpha);
    material.least_alpha = (uint8_t)scene->least_alpha;
    if (pass == SCENE_IDS) {
        material.shading = QTRI_FLAT_LAST;
        material.blend = scene->blend == SCENE_BLEND_SCREENDOOR ? &qtri_blend_screen_door : NULL;
        material.texture = resources->mask_texels != NULL ? &resources->mask : NULL;
        return material; /* modulated: white leaves an id as it is */
    }
    if (scene->by_pixel) {
        material.shading = QTRI_PER_PIXEL;
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
    material.fragment = resources->pipelines != NULL ? resources->pipelines->fragment : NULL;
    return material;
}

/* One scene being drawn into one surface. */
struct drawing {
    const struct scene_resources *resources;
    const qtri_surface *surface; /* `whole`, or a window of it */
    const qtri_surface *whole;
    qtri_surface window;
    enum scene_pass pass;
    qtri_edges *edges; /* to note outlines on, for SCENE_EDGES */
    qtri_view view;
    const qtri_light *white_light; /* where coloured ones are not meant; NULL: none */
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

/* Whether alpha of an operation's vertices counts: then the blend that takes it. */
static const qtri_blend *vertex_blend_of(const struct drawing *d, const struct scene_op *op)
{
    if (!op->by_vertex || d->pass == SCENE_IDS) {
        return NULL;
    }
    if (d->material.blend == &qtri_blend_alpha) {
        return &qtri_blend_vertex_alpha;
    }
    return d->material.blend == &qtri_blend_add ? &qtri_blend_vertex_add : NULL;
}

static qtri_corner corner_of(const struct drawing *d, const struct scene_vertex *v, uint32_t id)
{
    const qtri_corner corner = {{v->position[0], v->position[1], v->position[2], v->position[3]},
                                d->pass == SCENE_IDS ? rgb_of_id(id) : scene_rgb(v->color),
                                {v->uv[0], v->uv[1]}};
    return corner;
}

static void draw_triangle(struct drawing *d, const struct scene_op *op)
{
    qtri_corner corner[3];
    qtri_normal normal[3];
    uint8_t alpha[3];
    for (int i = 0; i < 3; i++) {
        const struct scene_vertex *v = &op->u.triangle.vertex[i];
        corner[i] = corner_of(d, v, op->id);
        normal[i] = normal_of(v->normal);
        alpha[i] = scene_byte(op->vertex_alpha[i]);
    }
    qtri_material material = d->material;
    if (!op->u.triangle.textured) {
        material.texture = NULL;
    }
    if (vertex_blend_of(d, op) != NULL) {
        material.blend = vertex_blend_of(d, op);
        material.alphas = alpha;
    }
    const bool is_lit = d->pass == SCENE_COLORS && d->resources->lights.model != NULL;
    d->view.light = is_lit ? &d->resources->lights : d->white_light;
    qtri_draw_lit_triangles(d->surface, &d->view, &d->modelview, corner, normal, 3, &material);
}

/* Whether edges of meshes are exact shapes, not lines of pixels. */
static bool has_strokes(const struct drawing *d)
{
    return d->resources->scene->wide_lines || d->resources->scene->smooth_lines;
}

/* How lines of the scene are drawn; for ids hard and opaque. */
static qtri_stroke stroke_of(const struct drawing *d, const struct scene_stroke *from)
{
    static const qtri_cap caps[] = {[SCENE_CAP_ROUND] = QTRI_CAP_ROUND,
                                    [SCENE_CAP_BUTT] = QTRI_CAP_BUTT,
                                    [SCENE_CAP_SQUARE] = QTRI_CAP_SQUARE};
    qtri_stroke stroke = qtri_stroke_default();
    const bool for_ids = d->pass == SCENE_IDS;
    const int32_t samples = d->surface->width / d->resources->scene->width; /* 2: 2x2 samples */
    const int64_t width = (int64_t)from->width * (from->in_space ? 1 : samples);
    stroke.width = (q16)(width > INT32_MAX ? INT32_MAX : width < INT32_MIN ? INT32_MIN : width);
    stroke.cap = caps[from->cap];
    stroke.edges = from->smooth && !for_ids ? &qtri_stroke_smooth : NULL;
    stroke.alpha = for_ids ? 255 : scene_byte(from->alpha);
    stroke.closed = from->closed;
    stroke.in_space = from->in_space;
    return stroke;
}

static void draw_stroke(struct drawing *d, const struct scene_op *op)
{
    const struct scene_stroke *from = &op->u.stroke;
    const qtri_stroke stroke = stroke_of(d, from);
    const uint32_t count = (uint32_t)from->count;
    qtri_corner *corners = xcalloc(from->count, sizeof *corners);
    for (uint32_t i = 0; i < count; i++) {
        const struct scene_vertex *v = &d->resources->scene->stroke_vertices[from->first + i];
        corners[i] = corner_of(d, v, op->id);
    }
    (from->is_point ? qtri_draw_points : qtri_draw_polyline)(d->surface, &d->view, &d->modelview,
                                                             corners, count, &stroke, &d->material);
    free(corners);
}

static void draw_wide(struct drawing *d, const qtri_view *view, const qtri_mesh *mesh,
                      const qtri_material *material)
{
    const qtri_stroke stroke = stroke_of(d, &d->resources->scene->wide);
    qtri_draw_wide_wireframe(d->surface, view, &d->modelview, mesh, &stroke, material);
}

/* Triangle by triangle, each a mesh of its own in the colour of its id. */
static void draw_mesh_ids(struct drawing *d, const qtri_mesh *mesh, uint32_t id)
{
    static const uint16_t corners[1][3] = {{0, 1, 2}};
    qtri_position16 positions16[3];
    qtri_vec3 positions[3];
    qtri_vec2 uvs[3];
    qtri_material material = d->material;
    const qtri_mesh one = {.positions16 = mesh->positions == NULL ? positions16 : NULL,
                           .positions = mesh->positions != NULL ? positions : NULL,
                           .origin = mesh->origin,
                           .extent = mesh->extent,
                           .uvs = mesh->uvs != NULL ? uvs : NULL,
                           .triangles = corners,
                           .vertex_count = 3,
                           .triangle_count = 1};
    if (mesh->uvs == NULL) {
        material.texture = NULL;
    }
    qtri_view view = d->view;
    view.light = NULL;
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        for (int j = 0; j < 3; j++) {
            const uint32_t vertex = mesh->triangles[i][j];
            if (mesh->positions == NULL) {
                positions16[j] = mesh->positions16[vertex];
            } else {
                positions[j] = mesh->positions[vertex];
            }
            if (mesh->uvs != NULL) {
                uvs[j] = mesh->uvs[vertex];
            }
        }
        material.color = rgb_of_id(id + i);
        if (has_strokes(d)) {
            draw_wide(d, &view, &one, &material);
        } else {
            qtri_draw_mesh(d->surface, &view, &d->modelview, &one, &material);
        }
    }
}

static void note_edges(struct drawing *d, const qtri_mesh *mesh)
{
    qtri_outline outline;
    const uint32_t words =
        QTRI_OUTLINE_WORDS(mesh->triangle_count) + QTRI_OUTLINE_SUMS(mesh->vertex_count);
    uint32_t *memory = xcalloc(words, sizeof *memory);
    if (qtri_outline_init(&outline, mesh, memory, words) == QTRI_OK) {
        outline.creases =
            d->material.shading != QTRI_SMOOTH && d->material.shading != QTRI_PER_PIXEL;
        (void)qtri_find_outline(d->surface, &d->view, &d->modelview, &d->material, &outline);
        qtri_edges_note(d->edges, &outline);
    }
    free(memory);
}

/* Whether the view could see any of it, where the scene asks. */
static bool may_be_seen(const struct drawing *d, const qtri_mesh *mesh)
{
    const enum scene_frustum_cull cull = d->resources->scene->frustum_cull;
    if (cull == SCENE_FRUSTUM_BOX) {
        const qtri_box box = qtri_mesh_box(mesh);
        return qtri_view_sees_box(&d->view, &d->modelview, &box);
    }
    if (cull == SCENE_FRUSTUM_BALL) {
        const qtri_ball ball = qtri_mesh_ball(mesh);
        return qtri_view_sees_ball(&d->view, &d->modelview, &ball);
    }
    return true;
}

/* Ids over depths: what qtri_draw_hidden_lines does, triangle by triangle. */
static void draw_hidden_ids(struct drawing *d, const qtri_mesh *mesh, uint32_t id)
{
    const qtri_material before = d->material;
    const bool is_greater =
        before.depth_compare == QTRI_GREATER || before.depth_compare == QTRI_GREATER_EQUAL;
    const q16 bias = d->resources->scene->hidden_bias;
    qtri_surface depth = *d->surface;
    qtri_material solid = before;
    depth.format = &qtri_depth_only;
    solid.fill = NULL;
    solid.depth_read_only = false;
    qtri_draw_mesh(&depth, &d->view, &d->modelview, mesh, &solid);
    d->material.depth_bias += is_greater ? bias : -bias; /* both within -1..1 */
    draw_mesh_ids(d, mesh, id);
    d->material = before;
}

/* For as many vertices as a part has, if that is the whole mesh; NULL: 255 for all. */
static uint8_t *alphas_of(const qtri_mesh *mesh, const struct scene_op *op, bool is_whole)
{
    uint8_t *alphas = is_whole ? xcalloc(mesh->vertex_count, 1) : NULL;
    for (uint32_t i = 0; alphas != NULL && i < mesh->vertex_count; i++) {
        alphas[i] = scene_byte(op->vertex_alpha[i % 3]);
    }
    return alphas;
}

static void show_part(struct drawing *d, const struct scene_op *op, const qtri_mesh *mesh,
                      bool is_whole)
{
    const struct scene_resources *resources = d->resources;
    const qtri_blend *by_vertex = vertex_blend_of(d, op);
    uint8_t *alphas = by_vertex != NULL ? alphas_of(mesh, op, is_whole) : NULL;
    qtri_material material = d->material;
    qtri_mesh shown = *mesh;
    if (by_vertex != NULL) {
        material.blend = by_vertex;
        material.alphas = alphas;
    }
    if (resources->sphere_uvs != NULL) {
        qtri_sphere_map(resources->sphere_uvs, &d->view.camera, &d->modelview, mesh);
        shown.uvs16 = resources->sphere_uvs;
    }
    if (resources->scene->hidden_lines) {
        qtri_draw_hidden_lines(d->surface, &d->view, &d->modelview, &shown, NULL, &material,
                               resources->scene->hidden_bias);
    } else if (resources->scene->wide_lines) {
        draw_wide(d, &d->view, &shown, &material);
    } else {
        qtri_draw_mesh(d->surface, &d->view, &d->modelview, &shown, &material);
    }
    free(alphas);
}

static void draw_part(struct drawing *d, const struct scene_op *op, const qtri_mesh *mesh,
                      uint32_t id, bool is_whole)
{
    if (!may_be_seen(d, mesh)) {
        return;
    }
    if (d->pass == SCENE_IDS && d->resources->scene->hidden_lines) {
        draw_hidden_ids(d, mesh, id);
    } else if (d->pass == SCENE_IDS) {
        draw_mesh_ids(d, mesh, id);
    } else if (d->pass == SCENE_EDGES) {
        note_edges(d, mesh);
    } else {
        show_part(d, op, mesh, is_whole);
    }
}

static void draw_mesh(struct drawing *d, const struct scene_op *op)
{
    const struct scene *scene = d->resources->scene;
    uint32_t id = op->id;
    const bool is_lit = d->pass == SCENE_COLORS && scene->lamps_on;
    d->view.light = is_lit ? &d->resources->lights : d->white_light;
    d->material.color = scene_rgb(op->u.mesh.color);
    if (op->kind == SCENE_MODEL) {
        qtri_mesh mesh;
        scene_model_create(&mesh, scene, &scene->models[op->u.mesh.mesh]);
        draw_part(d, op, &mesh, id, true);
        mesh_arrays_free(&mesh);
        return;
    }
    const struct scene_parts *parts = &d->resources->meshes[op->u.mesh.mesh];
    for (size_t i = 0; i < parts->count; i++) {
        draw_part(d, op, &parts->part[i], id, parts->count == 1);
        id += parts->part[i].triangle_count;
    }
}

/*
 * The outlines of `count` triangles that follow each other, as of one mesh. Homogeneous ones have
 * none: a mesh has no w.
 */
static void note_triangles(struct drawing *d, const struct scene_op *ops, size_t count)
{
    qtri_mesh mesh = {.vertex_count = 3 * (uint32_t)count, .triangle_count = (uint32_t)count};
    qtri_vertex *vertices = xcalloc(3 * count, sizeof *vertices);
    mesh_array_create(&mesh, MESH_POSITIONS);
    mesh_array_create(&mesh, MESH_TRIANGLES);
    mesh.vertex_count = mesh.triangle_count = 0;
    for (size_t i = 0; i < count; i++) {
        const struct scene_vertex *v = ops[i].u.triangle.vertex;
        const int32_t first = (int32_t)mesh.vertex_count;
        const int32_t corners[3] = {first, first + 1, first + 2};
        bool is_plain = true;
        for (uint32_t k = 0; k < 3; k++) {
            mesh_array_put(&mesh, MESH_POSITIONS, mesh.vertex_count + k, v[k].position);
            is_plain = is_plain && v[k].position[3] == Q16_ONE;
        }
        mesh_array_put(&mesh, MESH_TRIANGLES, mesh.triangle_count, corners);
        mesh.vertex_count += is_plain ? 3 : 0;
        mesh.triangle_count += is_plain ? 1 : 0;
    }
    d->view.vertices = vertices;
    d->view.vertex_count = mesh.vertex_count;
    if (mesh.triangle_count > 0 && mesh_neighbours_add(&mesh)) {
        note_edges(d, &mesh);
    }
    d->view.vertices = d->resources->vertices;
    d->view.vertex_count = d->resources->vertex_count;
    mesh_arrays_free(&mesh);
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

/* What follows is seen in a part of the frame. */
static void set_window(struct drawing *d, const int32_t n[5])
{
    const int32_t scale = d->whole->width / d->resources->scene->width; /* 2: 2x2 samples */
    const int32_t x = n[0] * scale, y = n[1] * scale, width = n[2] * scale, height = n[3] * scale;
    const qtri_viewport before = d->view.viewport;
    d->view.viewport = n[4] != 0 ? qtri_viewport_bottom(x, y, width, height, d->whole->height)
                                 : qtri_viewport_top(x, y, width, height);
    d->view.viewport.depth_near = before.depth_near;
    d->view.viewport.depth_far = before.depth_far;
    const qtri_viewport *now = &d->view.viewport;
    const qtri_rect inside = {now->x, now->y, now->x + width, now->y + height};
    qtri_rect scissor = d->whole->scissor;
    scissor.x0 = inside.x0 > scissor.x0 ? inside.x0 : scissor.x0;
    scissor.y0 = inside.y0 > scissor.y0 ? inside.y0 : scissor.y0;
    scissor.x1 = inside.x1 < scissor.x1 ? inside.x1 : scissor.x1;
    scissor.y1 = inside.y1 < scissor.y1 ? inside.y1 : scissor.y1;
    d->window = *d->whole;
    d->window.scissor = scissor;
    d->surface = &d->window;
}

static void replay(struct drawing *d, struct scene_stacks *stacks)
{
    const struct scene *scene = d->resources->scene;
    scene_stacks_begin(stacks);
    for (size_t i = 0; i < scene->op_count; i++) {
        const struct scene_op *op = &scene->ops[i];
        if (op->kind == SCENE_WINDOW) {
            set_window(d, op->u.number);
            continue;
        }
        if (op->kind < SCENE_TRIANGLE) {
            scene_stacks_apply(stacks, scene, op);
            continue;
        }
        if (op->kind == SCENE_PAINT) {
            if (d->pass == SCENE_COLORS) {
                scene_paint(d->resources, d->whole, &op->u.paint);
            }
            continue;
        }
        d->view.projection = stacks->matrix[0][stacks->top[0]];
        d->modelview = stacks->matrix[1][stacks->top[1]];
        d->material.depth_bias = op->depth_bias;
        d->material.depth_shift = op->depth_slope != 0 ? &qtri_slope_bias : NULL;
        d->material.depth_slope = op->depth_slope;
        if (d->resources->jitter_log2 > 0) {
            qtri_view_jitter(&d->view, &d->view, d->resources->jitter, d->resources->jitter_log2);
        }
        if (op->kind == SCENE_MESH || op->kind == SCENE_MODEL) {
            draw_mesh(d, op);
        } else if (op->kind == SCENE_STROKE) {
            if (d->pass != SCENE_EDGES) {
                draw_stroke(d, op);
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
    uint32_t *memory = xcalloc(words, sizeof *memory);
    if (qtri_edges_begin(edges, surface, memory, words) != QTRI_OK) {
        free(memory);
        memory = NULL;
    }
    return memory;
}

/* edges: to note outlines on, for SCENE_EDGES. */
static void draw_pass(const struct scene_resources *resources, const qtri_surface *surface,
                      enum scene_pass pass, qtri_edges *edges)
{
    const struct scene *scene = resources->scene;
    struct drawing d = {
        .resources = resources, .surface = surface, .whole = surface, .pass = pass, .edges = edges};
    qtri_view_init(&d.view, surface->width, surface->height);
    if (resources->pipelines != NULL) {
        d.view.pipelines = resources->pipelines->list;
    }
    d.view.viewport.depth_near = scene->depth_near;
    d.view.viewport.depth_far = scene->depth_far;
    d.view.vertices = resources->vertices;
    d.view.vertex_count = resources->vertex_count;
    const qtri_vec3 *towards = &resources->light.towards;
    d.white_light = (towards->x | towards->y | towards->z) != 0 ? &resources->light : NULL;
    d.view.light = d.white_light;
    d.material = material_of(resources, pass);
    if (pass != SCENE_IDS) {
        set_fog(&d);
    }

    struct scene_stacks *stacks = xcalloc(1, sizeof *stacks);
    replay(&d, stacks);
    free(stacks);
}

void scene_draw(const struct scene_resources *resources, const qtri_surface *surface,
                enum scene_pass pass)
{
    const qtri_rgb black = {0, 0, 0};
    const struct scene *scene = resources->scene;
    qtri_edges edges;
    uint32_t *memory = NULL;
    if (pass == SCENE_EDGES) {
        memory = begin_edges(&edges, surface);
        if (memory == NULL) {
            return;
        }
    } else {
        qtri_samples_clear(surface, pass == SCENE_IDS ? black : scene_rgb(scene->clear));
        qtri_samples_clear_depth(surface, scene->clear_depth);
    }
    for (; resources != NULL; resources = resources->next) {
        draw_pass(resources, surface, pass, &edges);
    }
    if (pass == SCENE_EDGES) {
        qtri_edges_blend(&edges);
    }
    free(memory);
}
