#include "lights.h"

#include "../geometry/lit_point.h"

#define LIT 0x1000000u /* a colour in memory, 8 bits a channel, is one; 0: not lit yet */

/* The sign of the homogeneous determinant; y points down. */
static bool is_back_clipped(const qtri_clip_vertex v[3])
{
    qtri_wide p[3][3];
    qtri_wide cross[3];
    for (int i = 0; i < 3; i++) {
        qtri_wide_set(&p[i][0], v[i].x, 0);
        qtri_wide_set(&p[i][1], v[i].y, 0);
        qtri_wide_set(&p[i][2], v[i].w, 0);
    }
    qtri_wide_cross(cross, p[0], p[1]);
    qtri_wide sum = qtri_wide_mul(cross[0], p[2][0]);
    qtri_wide_add_product(&sum, &cross[1], &p[2][1]);
    qtri_wide_add_product(&sum, &cross[2], &p[2][2]);
    return sum.m > 0;
}

static void illuminate_mesh(qtri_mesh_job *draw, const qtri_view *view, const qtri_transform *pose,
                            void (*body)(qtri_mesh_job *draw, void *with), void *with)
{
    qtri_illumination illumination;
    qtri_illumination_init(&illumination, view->lights, &view->camera, pose,
                           draw->material.reflection,
                           qtri_mesh_has_compact(draw->mesh->positions16) ? draw->mesh : NULL);
    draw->illumination = &illumination;
    body(draw, with);
    draw->illumination = NULL;
}

QTRI_IN_PLACE void set_place(qtri_lit_point *point, const qtri_mesh_job *draw, uint32_t index)
{
    const qtri_mesh *mesh = draw->mesh;
    if (qtri_mesh_has_compact(mesh->positions16)) {
        qtri_illuminated_place16(point, draw->illumination, &mesh->positions16[index]);
    } else {
        qtri_illuminated_place(point, draw->illumination, &mesh->positions[index]);
    }
}

/* A vertex in the light of its own normal. */
QTRI_NOINLINE static uint32_t light_vertex(const qtri_mesh_job *draw, uint32_t index, bool is_back)
{
    const qtri_mesh *mesh = draw->mesh;
    const qtri_rgb *color = mesh->colors != NULL ? &mesh->colors[index] : &draw->material.color;
    int32_t n[3];
    qtri_lit_point point;
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
    if (is_back) {
        n[0] = -n[0];
        n[1] = -n[1];
        n[2] = -n[2];
    }
    qtri_illuminated_normal(&point, draw->illumination, n[0], n[1], n[2]);
    set_place(&point, draw, index);
    return LIT | qtri_illuminate(draw->illumination, &point, color);
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

/* Front sides of vertices that have room are lit once. */
static qtri_rgb vertex_color(const qtri_mesh_job *draw, uint32_t index, bool is_back)
{
    if (is_back || draw->lit_colors == NULL) {
        return qtri_lit_rgb(light_vertex(draw, index, is_back));
    }
    uint32_t word = draw->lit_colors[index];
    if (word == 0 && draw->illumination != NULL) {
        word = light_vertex(draw, index, false);
        draw->lit_colors[index] = word;
    }
    return qtri_lit_rgb(word);
}

static void meet(const qtri_mesh_job *draw, const uint32_t index[3])
{
    for (int i = 0; i < 3 && draw->shaded_per_vertex; i++) {
        (void)vertex_color(draw, index[i], false);
    }
}

/* Where they are fewer: in one place. */
QTRI_NOINLINE static qtri_rgb illuminate(const qtri_illumination *by, qtri_lit_point *point,
                                         const qtri_rgb *color)
{
    return qtri_lit_rgb(qtri_illuminate(by, point, color));
}

/* A third, rounded down; three of them fit. */
static int32_t third(int32_t x)
{
    return (int32_t)(qtri_mul_s32(x, 0x55555554) >> 32);
}

/* The vertices' positions, in a scale that does not matter for their triangle's normal. */
static void get_positions(qtri_vec3 p[3], const qtri_mesh *mesh, const uint32_t index[3])
{
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
}

static void set_mean(qtri_lit_point *point, const qtri_mesh_job *draw, const qtri_vec3 p[3])
{
    if (qtri_mesh_has_compact(draw->mesh->positions16)) {
        /* Within a step: 10923 / 2^15 is 1/3 and 2^-16.6, and sums are below 2^16.6. */
        const qtri_position16 mean = {(int16_t)(((p[0].x + p[1].x + p[2].x) * 10923) >> 15),
                                      (int16_t)(((p[0].y + p[1].y + p[2].y) * 10923) >> 15),
                                      (int16_t)(((p[0].z + p[1].z + p[2].z) * 10923) >> 15)};
        qtri_illuminated_place16(point, draw->illumination, &mean);
    } else {
        const qtri_vec3 mean = {third(p[0].x) + third(p[1].x) + third(p[2].x),
                                third(p[0].y) + third(p[1].y) + third(p[2].y),
                                third(p[0].z) + third(p[1].z) + third(p[2].z)};
        qtri_illuminated_place(point, draw->illumination, &mean);
    }
}

/* In the light of the face's normal: at its middle when flat, otherwise at each corner. */
static void shade_face(const qtri_mesh_job *draw, const uint32_t index[3], bool is_back,
                       qtri_rgb color[3])
{
    const qtri_mesh *mesh = draw->mesh;
    const int32_t turn = is_back ? -1 : 1;
    const bool smooth = qtri_shading_of(&draw->material) == QTRI_SMOOTH;
    qtri_lit_point point;
    qtri_vec3 p[3];
    int32_t n[3];
    get_positions(p, mesh, index);
    qtri_face_normal(n, &p[0], &p[1], &p[2]);
    qtri_illuminated_normal(&point, draw->illumination, turn * n[0], turn * n[1], turn * n[2]);
    if (!smooth) {
        set_mean(&point, draw, p);
    }
    const int provoking = draw->material.shading == QTRI_FLAT_FIRST ? 0 : 2;
    for (int i = smooth ? 0 : provoking; i < 3; i++) {
        if (smooth) {
            set_place(&point, draw, index[i]);
        }
        color[i] =
            illuminate(draw->illumination, &point,
                       mesh->colors != NULL ? &mesh->colors[index[i]] : &draw->material.color);
        if (!smooth) { /* all three are the provoking one's */
            const qtri_rgb all = color[i];
            color[0] = all;
            color[1] = all;
            color[2] = all;
            break;
        }
    }
}

static bool is_two_sided(const qtri_mesh_job *draw)
{
    return draw->material.reflection != NULL && draw->material.reflection->two_sided;
}

static void shade_side(const qtri_mesh_job *draw, const uint32_t index[3], bool is_back,
                       qtri_rgb color[3])
{
    if (!draw->shaded_per_vertex) {
        shade_face(draw, index, is_back, color);
        return;
    }
    for (int i = 0; i < 3; i++) {
        color[i] = vertex_color(draw, index[i], is_back);
    }
}

static void shade(const qtri_mesh_job *draw, const uint32_t index[3], const qtri_vertex *a,
                  const qtri_vertex *b, const qtri_vertex *c, qtri_rgb color[3])
{
    const bool is_back = is_two_sided(draw) && qtri_triangle_area(&a->at, &b->at, &c->at) > 0;
    shade_side(draw, index, is_back, color);
}

static void shade_clipped(const qtri_mesh_job *draw, const uint32_t index[3],
                          const qtri_clip_vertex v[3], qtri_rgb color[3])
{
    shade_side(draw, index, is_two_sided(draw) && is_back_clipped(v), color);
}

static void illuminate_corners(const qtri_view *view, const qtri_transform *pose,
                               const qtri_material *material,
                               void (*body)(const qtri_illumination *by, void *with), void *with)
{
    qtri_illumination illumination;
    qtri_illumination_init(&illumination, view->lights, &view->camera, pose, material->reflection,
                           NULL);
    body(&illumination, with);
}

static qtri_vec3 place_of(const qtri_vec4 *position)
{
    qtri_vec3 place = {position->x, position->y, position->z};
    if (position->w != Q16_ONE) {
        place.x = q16_div(place.x, position->w);
        place.y = q16_div(place.y, position->w);
        place.z = q16_div(place.z, position->w);
    }
    return place;
}

static void shade_corners(const qtri_illumination *by, const qtri_material *material,
                          const qtri_clip_vertex *clip, int64_t area, qtri_corner corner[3])
{
    const bool is_back = by->two_sided && (clip != NULL ? is_back_clipped(clip) : area > 0);
    const int32_t turn = is_back ? -1 : 1;
    const bool smooth = qtri_shading_of(material) == QTRI_SMOOTH;
    const qtri_vec3 p[3] = {place_of(&corner[0].position), place_of(&corner[1].position),
                            place_of(&corner[2].position)};
    int32_t face[3];
    qtri_face_normal(face, &p[0], &p[1], &p[2]);
    for (int i = 0; i < 3; i++) {
        const qtri_normal *own = &corner[i].normal;
        const bool has_own = smooth && (own->x | own->y | own->z) != 0;
        const int32_t n[3] = {has_own ? own->x : face[0], has_own ? own->y : face[1],
                              has_own ? own->z : face[2]};
        const qtri_vec3 mean = {third(p[0].x) + third(p[1].x) + third(p[2].x),
                                third(p[0].y) + third(p[1].y) + third(p[2].y),
                                third(p[0].z) + third(p[1].z) + third(p[2].z)};
        qtri_lit_point point;
        qtri_illuminated_normal(&point, by, turn * n[0], turn * n[1], turn * n[2]);
        qtri_illuminated_place(&point, by, smooth ? &p[i] : &mean);
        corner[i].color = illuminate(by, &point, &corner[i].color);
    }
}

static const qtri_light_model model = {
    .mesh = illuminate_mesh,
    .list = light_list,
    .meet = meet,
    .shade = shade,
    .shade_clipped = shade_clipped,
    .corners = illuminate_corners,
    .shade_corners = shade_corners,
};

enum qtri_error qtri_lights_init(qtri_lights *lights, const qtri_light_source *sources,
                                 uint32_t count, qtri_light_color ambient)
{
    lights->model = &model;
    lights->sources = sources;
    lights->count = count < QTRI_LIGHTS_MAX ? count : QTRI_LIGHTS_MAX;
    lights->ambient = ambient;
    return count <= QTRI_LIGHTS_MAX ? QTRI_OK : QTRI_ERROR_SIZE;
}
