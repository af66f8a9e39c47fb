/* SPDX-License-Identifier: MIT */
/*
 * Draw calls of loose triangles, lit and unlit, each drawn as a mesh of one triangle; of lines; and
 * of a triangle in screen coordinates.
 */
#include <string.h>

#include "checked.h"
#include "lights.h"
#include "qtri/draw.h"

#include "../bits/bits.h"

static void set_vertex_attributes(qtri_screen_vertex *out, const qtri_corner *corner)
{
    qtri_line_color_set(out->color_8p16, &corner->color, QTRI_INTENSITY_ONE);
    out->u_q32 = (int64_t)corner->uv.x * 65536;
    out->v_q32 = (int64_t)corner->uv.y * 65536;
}

/* A qtri_attribute_source, from three corners. */
static void set_attributes(const void *from, qtri_screen_vertex attributes[3])
{
    const qtri_corner *corners = from;
    for (int i = 0; i < 3; i++) {
        set_vertex_attributes(&attributes[i], &corners[i]);
    }
}

/* Transforms `count` corners of one primitive, which then share one scale. */
static void transform(const qtri_primitive *primitive, const qtri_corner *corners, int count,
                      qtri_clip_vertex v[3])
{
    const qtri_vec4 *position[3];
    for (int i = 0; i < count; i++) {
        position[i] = &corners[i].position;
    }
    qtri_projector_points(&primitive->projector, position, count, v);
}

/* The triangles of a draw call, one after the other. */
typedef struct triangle_call {
    qtri_mesh_job job;
    const qtri_vertex *before; /* vertices of the triangle before, or NULL */
} triangle_call;

/* What becomes of a triangle. */
typedef enum fate {
    UNDECIDED, /* a vertex is outside or not at w = 1, or the material has a fill */
    CULLED,
    VISIBLE /* and inside all planes */
} fate;

/* `shade`: see qtri_draw_state_init(). */
static void begin(triangle_call *call, const qtri_surface *surface, const qtri_view *view,
                  const qtri_transform *pose, const qtri_material *material, int shade)
{
    qtri_mesh_job *job = &call->job;
    qtri_loose_triangle *triangle = &job->of.triangle;
    qtri_mesh *mesh = &job->primitive.to.solid.mesh;
    memset(call, 0, sizeof *call);
    mesh->positions = triangle->inside.positions;
    mesh->uvs = triangle->inside.uvs;
    mesh->colors = triangle->inside.colors;
    job->mesh = mesh;
    job->positions = &qtri_positions_wide;
    job->slot_count = 3;
    qtri_primitive_set_target(&job->primitive, surface, view, material, material->texture, shade);
    qtri_projector_init_view(&job->primitive.projector, view, pose, material->depth_bias, NULL);
    if (material->fill == NULL) {
        qtri_mesh_solid_init(job, NULL);
        for (uint32_t i = 0; i < 3; i++) { /* for alphas of a clipped triangle */
            job->primitive.to.solid.state.alpha_index[i] = i;
        }
    }
}

/* The vertex of three corners that is at this position; NULL: none. */
static inline const qtri_vertex *find_vertex(const qtri_vertex v[3], const qtri_corner *corners,
                                             const qtri_vec4 *position)
{
    for (int i = 3; i-- > 0;) { /* fans and strips mostly share the last */
        const qtri_vec4 *own = &corners[i].position;
        if (own->x == position->x && own->y == position->y && own->z == position->z) {
            return &v[i];
        }
    }
    return NULL;
}

/* Projects and culls three corners, of which `first` is the index in the call; job.vertices are
   theirs then. */
QTRI_NOINLINE static fate project(triangle_call *call, const qtri_corner *corners, uint32_t first)
{
    qtri_mesh_job *job = &call->job;
    qtri_loose_triangle *triangle = &job->of.triangle;
    const qtri_vertex *before = call->before;
    qtri_vertex *v = triangle->inside.vertex[before == triangle->inside.vertex[0]];
    uint32_t count = 0;
    call->before = NULL;
    job->vertices = v;
    if (job->primitive.material->fill != NULL) {
        return UNDECIDED;
    }
    if (job->primitive.material->alphas != NULL) {
        job->primitive.to.solid.state.alphas = &job->primitive.material->alphas[first];
    }
    for (uint32_t i = 0; i < 3; i++) {
        const qtri_vec4 *position = &corners[i].position;
        if (position->w != Q16_ONE) {
            return UNDECIDED;
        }
        triangle->inside.positions[i].x = position->x;
        triangle->inside.positions[i].y = position->y;
        triangle->inside.positions[i].z = position->z;
        const qtri_vertex *same =
            before != NULL ? find_vertex(before, corners - 3, position) : NULL;
        if (same != NULL) {
            v[i] = *same;
        } else {
            v[count++].index = (uint16_t)i;
        }
    }
    if (count != 0 && !qtri_projector_vertices(&job->primitive.projector,
                                               triangle->inside.positions, count, v, true)) {
        return UNDECIDED;
    }
    call->before = v;
    const int64_t area = qtri_triangle_area(&v[0].at, &v[1].at, &v[2].at);
    return area == 0 || qtri_is_culled(job->primitive.material->cull, area) ? CULLED : VISIBLE;
}

/* Draws a visible triangle with the colours and coordinates of `attributes`. */
static void draw_visible(triangle_call *call, const qtri_corner *attributes)
{
    static const uint16_t indices[3] = {0, 1, 2};
    static const uint32_t index[3] = {0, 1, 2};
    qtri_loose_triangle *triangle = &call->job.of.triangle;
    qtri_small *small = &call->job.primitive.to.solid.small;
    qtri_vertex *const v = call->job.vertices;
    qtri_vertex *const vertex[3] = {&v[0], &v[1], &v[2]};
    for (int i = 0; i < 3; i++) {
        triangle->inside.colors[i] = attributes[i].color;
        triangle->inside.uvs[i] = attributes[i].uv;
        v[i].intensity_q15 = QTRI_INTENSITY_ONE;
    }
    if (!qtri_mesh_draw_small(small, indices, index, vertex)) {
        qtri_mesh_draw_large(&call->job, indices, vertex[0], vertex[1], vertex[2]);
    }
}

/* Draws any triangle: in homogeneous coordinates, which may be clipped. */
static void draw_general(triangle_call *call, const qtri_corner *corners)
{
    qtri_shape *shape = &call->job.of.triangle.shape;
    transform(&call->job.primitive, corners, 3, shape->clip);
    qtri_primitive_triangle(&call->job.primitive, shape, set_attributes, corners);
}

void qtri_draw_triangles(const qtri_surface *surface, const qtri_view *view,
                         const qtri_transform *pose, const qtri_corner *corners,
                         uint32_t corner_count, const qtri_material *material)
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_CHECK(qtri_check_view(view, pose));
    QTRI_CHECK(qtri_check_corners(corners, corner_count, 3));
    triangle_call call;
    begin(&call, surface, view, pose, material, qtri_is_smooth(material) ? QTRI_COLORS : QTRI_TINT);
    for (uint32_t i = 0; corner_count - i >= 3; i += 3) {
        const fate found = project(&call, &corners[i], i);
        if (found == VISIBLE) {
            draw_visible(&call, &corners[i]);
        } else if (found == UNDECIDED) {
            draw_general(&call, &corners[i]);
        }
    }
}

/* ---- In a view's lights ---- */

/* A draw call in a view's lights. */
typedef struct lit_call {
    triangle_call call;
    const qtri_illumination *by;
    const qtri_corner *corners;
    const qtri_normal *normals;
    uint32_t corner_count;
} lit_call;

static qtri_vec3 divide_by_w(const qtri_vec4 *position)
{
    qtri_vec3 place = {position->x, position->y, position->z};
    if (position->w != Q16_ONE) {
        place.x = q16_div(place.x, position->w);
        place.y = q16_div(place.y, position->w);
        place.z = q16_div(place.z, position->w);
    }
    return place;
}

/* The corners `first` .. first + 2 with their colours lit. */
static void light(qtri_corner lit[3], const lit_call *call, uint32_t first, bool is_back)
{
    const qtri_corner *corners = &call->corners[first];
    const qtri_normal *normals = call->normals != NULL ? &call->normals[first] : NULL;
    const qtri_primitive *primitive = &call->call.job.primitive;
    const bool smooth = qtri_is_smooth(primitive->material);
    const qtri_by_pixel *by_pixel = qtri_by_pixel_of(primitive->material);
    const int32_t turn = is_back ? -1 : 1;
    const qtri_vec3 p[3] = {divide_by_w(&corners[0].position), divide_by_w(&corners[1].position),
                            divide_by_w(&corners[2].position)};
    const qtri_vec3 mean = qtri_mean(p);
    int32_t face[3];
    qtri_face_normal(face, &p[0], &p[1], &p[2]);
    for (int i = 0; i < 3; i++) {
        int32_t n[3] = {face[0], face[1], face[2]};
        qtri_lit_point point;
        if (smooth && normals != NULL && (normals[i].x | normals[i].y | normals[i].z) != 0) {
            n[0] = normals[i].x;
            n[1] = normals[i].y;
            n[2] = normals[i].z;
        }
        lit[i] = corners[i];
        qtri_illuminated_normal(&point, call->by, turn * n[0], turn * n[1], turn * n[2]);
        qtri_illuminated_place(&point, call->by, smooth ? &p[i] : &mean);
        if (by_pixel != NULL) {
            by_pixel->set_corner(primitive, i, &point, &corners[i].color);
        }
        lit[i].color = qtri_lit_rgb(qtri_illuminate(call->by, &point, &corners[i].color));
    }
}

static void draw_lit(lit_call *call, uint32_t first)
{
    const bool two_sided = call->by->two_sided;
    const qtri_corner *corners = &call->corners[first];
    const fate found = project(&call->call, corners, first);
    qtri_corner lit[3];
    if (found == VISIBLE) {
        const qtri_vertex *v = call->call.job.vertices;
        light(lit, call, first, two_sided && qtri_triangle_area(&v[0].at, &v[1].at, &v[2].at) > 0);
        draw_visible(&call->call, lit);
    } else if (found == UNDECIDED) {
        qtri_shape *shape = &call->call.job.of.triangle.shape;
        transform(&call->call.job.primitive, corners, 3, shape->clip);
        light(lit, call, first, two_sided && qtri_clipped_is_back(shape->clip));
        qtri_primitive_triangle(&call->call.job.primitive, shape, set_attributes, lit);
    }
}

static void draw_all_lit(void *with)
{
    lit_call *call = with;
    for (uint32_t i = 0; call->corner_count - i >= 3; i += 3) {
        draw_lit(call, i);
    }
}

/* Separate, or its stack would be beneath that of qtri_draw_triangles(). */
QTRI_NOINLINE static void draw_lit_call(const qtri_surface *surface, const qtri_view *view,
                                        const qtri_transform *pose, const qtri_corner *corners,
                                        const qtri_normal *normals, uint32_t corner_count,
                                        const qtri_material *material)
{
    lit_call call;
    qtri_illumination illumination;
    const qtri_by_pixel *by_pixel = qtri_by_pixel_of(material);
    begin(&call.call, surface, view, pose, material,
          by_pixel != NULL           ? QTRI_BY_PIXEL
          : qtri_is_smooth(material) ? QTRI_COLORS
                                     : QTRI_TINT);
    qtri_illumination_init(&illumination, view, pose, material->reflection, NULL);
    call.by = &illumination;
    call.corners = corners;
    call.normals = normals;
    call.corner_count = corner_count;
    if (by_pixel != NULL) {
        by_pixel->run(&call.call.job.primitive, &illumination, draw_all_lit, &call);
    } else {
        draw_all_lit(&call);
    }
}

void qtri_draw_lit_triangles(const qtri_surface *surface, const qtri_view *view,
                             const qtri_transform *pose, const qtri_corner *corners,
                             const qtri_normal *normals, uint32_t corner_count,
                             const qtri_material *material)
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_CHECK(qtri_check_view(view, pose));
    QTRI_CHECK(qtri_check_corners(corners, corner_count, 3));
    if (qtri_colored_light(view) == NULL) {
        qtri_draw_triangles(surface, view, pose, corners, corner_count, material);
    } else {
        draw_lit_call(surface, view, pose, corners, normals, corner_count, material);
    }
}

/* ---- Lines ---- */

void qtri_draw_lines(const qtri_surface *surface, const qtri_view *view, const qtri_transform *pose,
                     const qtri_corner *corners, uint32_t corner_count,
                     const qtri_material *material)
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_CHECK(qtri_check_view(view, pose));
    QTRI_CHECK(qtri_check_corners(corners, corner_count, 2));
    qtri_primitive primitive;
    primitive.surface = surface;
    primitive.material = material;
    qtri_projector_init_view(&primitive.projector, view, pose, material->depth_bias, NULL);
    qtri_primitive_begin_lines(&primitive);
    for (uint32_t i = 0; corner_count - i >= 2; i += 2) {
        qtri_clip_vertex v[3];
        qtri_screen_vertex attributes[2];
        transform(&primitive, &corners[i], 2, v);
        set_vertex_attributes(&attributes[0], &corners[i]);
        set_vertex_attributes(&attributes[1], &corners[i + 1]);
        qtri_primitive_line(&primitive, &v[0], &v[1], &attributes[0], &attributes[1]);
    }
}

/* ---- The rasterizer alone ---- */

/* Depth, 1/w and colours are clamped to the ranges in large.h; coordinates are already. */
static void set_large_vertex(qtri_large_vertex *out, const qtri_screen_vertex *v, uint32_t alpha)
{
    const uint32_t farthest = (uint32_t)65535 << 16;
    const uint32_t mantissa = v->inv_w_q31 | (v->inv_w_q31 == 0);
    const int32_t zeros = qtri_clz32(mantissa);
    out->depth_16p16 = v->depth_16p16 < farthest ? v->depth_16p16 : farthest;
    out->inv_w_q31 = mantissa << zeros >> 1;
    out->inv_w_exponent = qtri_saturate32((int64_t)v->inv_w_exponent - zeros);
    out->light_q15 = 0;
    for (int i = 0; i < 3; i++) {
        out->color_8p16[i] = qtri_hold32(v->color_8p16[i], 0, 255 << 16);
    }
    out->u_q32 = v->u_q32;
    out->v_q32 = v->v_q32;
    out->rest[0] = 0;
    out->rest[1] = 0;
    out->alpha_q16 = (alpha << 16) / 255;
}

void qtri_raster_triangle(const qtri_surface *surface, const qtri_pipeline *const *pipelines,
                          const qtri_material *material, const qtri_screen_vertex v[3])
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_ASSERT(v != NULL);
    qtri_draw_state state;
    qtri_point at[3];
    qtri_large_vertex vertex[3];
    const qtri_point *const p[3] = {&at[0], &at[1], &at[2]};
    for (int i = 0; i < 3; i++) {
        at[i].x_24p8 = qtri_hold32(v[i].x_24p8, -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
        at[i].y_24p8 = qtri_hold32(v[i].y_24p8, -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
        set_large_vertex(&vertex[i], &v[i], material->alphas != NULL ? material->alphas[i] : 255);
    }
    const int64_t area = qtri_triangle_area(p[0], p[1], p[2]);
    if (area == 0 || qtri_is_culled(material->cull, area)) {
        return;
    }
    qtri_draw_state_init(&state, surface, pipelines, material, material->texture,
                         qtri_is_smooth(material) ? QTRI_COLORS : QTRI_TINT);
    qtri_large_triangle(&state, p, area,
                        qtri_color_word(vertex[qtri_provoking_of(material)].color_8p16), vertex);
}
