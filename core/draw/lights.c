/* SPDX-License-Identifier: MIT */
#include "lights.h"

#include "checked.h"

#define LIT 0x1000000u /* added to every stored 0x00RRGGBB: a word of 0 is not lit yet */

static bool is_two_sided(const qtri_mesh_job *draw)
{
    return draw->primitive.material->reflection != NULL &&
           draw->primitive.material->reflection->two_sided;
}

/* Whether a triangle shows its back, and its material is lit there by a turned normal. */
static bool is_back_seen(const qtri_mesh_job *draw, const qtri_vertex *a, const qtri_vertex *b,
                         const qtri_vertex *c)
{
    return is_two_sided(draw) && qtri_triangle_area(&a->at, &b->at, &c->at) > 0;
}

/* lit_colors lie behind the vertices, where memory has room for all of both. */
static void begin_job(qtri_mesh_job *draw)
{
    const qtri_mesh *mesh = draw->mesh;
    const uint32_t all = mesh->vertex_count;
    draw->shaded_per_vertex = qtri_is_smooth(draw->primitive.material) &&
                              (mesh->normals != NULL || mesh->normals8 != NULL);
    if (draw->slot_count >= all && draw->slot_count - all >= (all + 4) / 5) {
        draw->lit_colors = (uint32_t *)(void *)(draw->vertices + all);
        draw->slot_count = all;
    }
}

static bool keeps_colors(const qtri_mesh_job *draw, bool both_sides)
{
    return draw->lit_colors != NULL && draw->shaded_per_vertex &&
           (!both_sides ||
            (!is_two_sided(draw) && qtri_by_pixel_of(draw->primitive.material) == NULL));
}

static void illuminate_mesh(qtri_mesh_job *draw, const qtri_view *view, const qtri_transform *pose,
                            bool fresh, qtri_lit_body body, void *with)
{
    qtri_illumination illumination;
    qtri_illumination_init(&illumination, view, pose, draw->primitive.material->reflection,
                           draw->mesh->positions16 != NULL ? draw->mesh : NULL);
    for (uint32_t i = 0; fresh && draw->lit_colors != NULL && i < draw->mesh->vertex_count; i++) {
        draw->lit_colors[i] = 0;
    }
    draw->illumination = &illumination;
    const qtri_by_pixel *by_pixel = qtri_by_pixel_of(draw->primitive.material);
    if (by_pixel != NULL) {
        by_pixel->run(&draw->primitive, &illumination, body, with);
    } else {
        body(with);
    }
    draw->illumination = NULL;
}

/* A vertex's colour in the light of its own normal, plus LIT. */
QTRI_NOINLINE static uint32_t light_vertex(const qtri_mesh_job *draw, uint32_t index, bool is_back)
{
    int32_t n[3];
    qtri_lit_point point;
    qtri_lit_vertex_normal(n, draw->mesh, index);
    if (is_back) {
        n[0] = -n[0];
        n[1] = -n[1];
        n[2] = -n[2];
    }
    qtri_illuminated_normal(&point, draw->illumination, n[0], n[1], n[2]);
    qtri_lit_vertex_place(&point, draw, index);
    return LIT | qtri_illuminate(draw->illumination, &point, qtri_mesh_color(draw, index));
}

static void light_list(const qtri_mesh_job *draw, uint32_t count)
{
    if (!draw->shaded_per_vertex || draw->lit_colors == NULL) {
        return;
    }
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t index = draw->vertices[i].index;
        draw->lit_colors[index] = light_vertex(draw, index, false);
    }
}

/* A vertex's colour, plus LIT. That of its front side is computed once, where there is room. */
static inline uint32_t vertex_word(const qtri_mesh_job *draw, uint32_t index, bool is_back)
{
    if (is_back || draw->lit_colors == NULL) {
        return light_vertex(draw, index, is_back);
    }
    uint32_t word = draw->lit_colors[index];
    if (word == 0 && draw->illumination != NULL) {
        word = light_vertex(draw, index, false);
        draw->lit_colors[index] = word;
    }
    return word;
}

static void light_triangle(const qtri_mesh_job *draw, const uint32_t index[3])
{
    const bool has_words = draw->lit_colors != NULL && draw->illumination != NULL;
    for (int i = 0; i < 3 && has_words; i++) { /* by vertex: keeps_colors() has said so */
        (void)vertex_word(draw, index[i], false);
    }
}

/* qtri_illuminate() out of line, for faces: they are fewer than vertices. */
QTRI_NOINLINE static uint32_t illuminate(const qtri_illumination *by, qtri_lit_point *point,
                                         const qtri_rgb *color)
{
    return qtri_illuminate(by, point, color);
}

static void set_mean(qtri_lit_point *point, const qtri_mesh_job *draw, const qtri_vec3 p[3])
{
    if (draw->mesh->positions16 != NULL) {
        /* Within a step: 10923 / 2^15 is 1/3 and 2^-16.6, and sums are below 2^16.6. */
        const qtri_position16 mean = {(int16_t)(((p[0].x + p[1].x + p[2].x) * 10923) >> 15),
                                      (int16_t)(((p[0].y + p[1].y + p[2].y) * 10923) >> 15),
                                      (int16_t)(((p[0].z + p[1].z + p[2].z) * 10923) >> 15)};
        qtri_illuminated_place16(point, draw->illumination, &mean);
    } else {
        const qtri_vec3 mean = qtri_mean(p);
        qtri_illuminated_place(point, draw->illumination, &mean);
    }
}

/* Colours in the light of the face's normal: at its middle when flat, otherwise at each vertex. */
static void shade_face(const qtri_mesh_job *draw, const uint32_t index[3], bool is_back,
                       uint32_t lit[3])
{
    const int32_t turn = is_back ? -1 : 1;
    qtri_lit_point point;
    qtri_vec3 p[3];
    int32_t n[3];
    qtri_mesh_positions(p, draw->mesh, index);
    qtri_face_normal(n, &p[0], &p[1], &p[2]);
    qtri_illuminated_normal(&point, draw->illumination, turn * n[0], turn * n[1], turn * n[2]);
    if (!qtri_is_smooth(draw->primitive.material)) {
        const uint32_t provoking = index[qtri_provoking_of(draw->primitive.material)];
        set_mean(&point, draw, p);
        lit[0] = illuminate(draw->illumination, &point, qtri_mesh_color(draw, provoking));
        lit[1] = lit[2] = lit[0];
        return;
    }
    for (int i = 0; i < 3; i++) {
        qtri_lit_vertex_place(&point, draw, index[i]);
        lit[i] = illuminate(draw->illumination, &point, qtri_mesh_color(draw, index[i]));
    }
}

/* Sets the words 0x00RRGGBB of a triangle's vertices; higher bits are undefined. */
static void shade_side(const qtri_mesh_job *draw, const uint32_t index[3], bool is_back,
                       uint32_t lit[3])
{
    if (!draw->shaded_per_vertex) {
        shade_face(draw, index, is_back, lit);
        return;
    }
    lit[0] = vertex_word(draw, index[0], is_back);
    lit[1] = vertex_word(draw, index[1], is_back);
    lit[2] = vertex_word(draw, index[2], is_back);
}

static void shade(const qtri_mesh_job *draw, const uint32_t index[3], const qtri_vertex *a,
                  const qtri_vertex *b, const qtri_vertex *c, uint32_t lit[3])
{
    shade_side(draw, index, is_back_seen(draw, a, b, c), lit);
}

static uint32_t find(const void *from, const void *indices, qtri_vertex *a, qtri_vertex *b,
                     qtri_vertex *c)
{
    const qtri_mesh_job *draw = from;
    uint32_t index[3];
    qtri_mesh_indices(index, indices, qtri_mesh_has_bytes(draw->mesh));
    shade(draw, index, a, b, c, draw->primitive.to.solid.small.state->lit);
    return QTRI_INTENSITY_ONE;
}

static uint32_t find_large(const void *from, const void *indices, qtri_vertex *a, qtri_vertex *b,
                           qtri_vertex *c)
{
    const qtri_mesh_job *draw = from;
    const qtri_by_pixel *by_pixel = qtri_by_pixel_of(draw->primitive.material);
    if (by_pixel == NULL || !draw->primitive.to.solid.small.state->options.per_pixel) {
        return find(from, indices, a, b, c);
    }
    by_pixel->set_corners(draw, indices, is_back_seen(draw, a, b, c));
    return QTRI_INTENSITY_ONE;
}

/* The sign of the homogeneous determinant; y points down. */
bool qtri_clipped_is_back(const qtri_clip_vertex v[3])
{
    qtri_wide p[3][3];
    qtri_wide cross[3];
    for (int i = 0; i < 3; i++) {
        qtri_wide_set(&p[i][0], v[i].x, 0);
        qtri_wide_set(&p[i][1], v[i].y, 0);
        qtri_wide_set(&p[i][2], v[i].w, 0);
    }
    qtri_wide_cross(cross, p[0], p[1]);
    return qtri_wide_inner(cross, p[2]).m > 0;
}

static void shade_clipped(const qtri_mesh_job *draw, const void *indices,
                          const qtri_clip_vertex v[3], uint32_t lit[3])
{
    const bool turned = is_two_sided(draw) && qtri_clipped_is_back(v);
    const qtri_by_pixel *by_pixel = qtri_by_pixel_of(draw->primitive.material);
    uint32_t index[3];
    qtri_mesh_indices(index, indices, qtri_mesh_has_bytes(draw->mesh));
    if (by_pixel != NULL) {
        by_pixel->set_corners(draw, indices, turned);
    }
    shade_side(draw, index, turned, lit);
}

static const qtri_light_model model = {
    .begin = begin_job,
    .mesh = illuminate_mesh,
    .keeps_colors = keeps_colors,
    .list = light_list,
    .light_triangle = light_triangle,
    .find = find,
    .find_large = find_large,
    .shade = shade,
    .shade_clipped = shade_clipped,
};

enum qtri_error qtri_light_init(qtri_light *light, const qtri_light_source *sources, uint32_t count,
                                qtri_light_color ambient)
{
    static const qtri_light none = {.towards = {0, 0, 0}};
    QTRI_ASSERT(light != NULL);
    QTRI_CHECK(qtri_check_lights(sources, count, &ambient));
    *light = none;
    light->model = &model;
    light->sources = sources;
    light->count = count < QTRI_LIGHTS_MAX ? count : QTRI_LIGHTS_MAX;
    light->color = ambient;
    return count <= QTRI_LIGHTS_MAX ? QTRI_OK : QTRI_ERROR_SIZE;
}
