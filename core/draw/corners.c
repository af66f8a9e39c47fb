/* SPDX-License-Identifier: MIT */
#include "checked.h"
#include "corners.h"

static void attributes_of(qtri_screen_vertex *out, const qtri_corner *corner)
{
    out->color_8p16[0] = (int32_t)corner->color.r << 16;
    out->color_8p16[1] = (int32_t)corner->color.g << 16;
    out->color_8p16[2] = (int32_t)corner->color.b << 16;
    out->u_q32 = (int64_t)corner->uv.x * 65536;
    out->v_q32 = (int64_t)corner->uv.y * 65536;
}

/* A qtri_attribute_source, from three corners. */
static void set_attributes(const void *from, qtri_screen_vertex attributes[3])
{
    const qtri_corner *corners = from;
    for (int i = 0; i < 3; i++) {
        attributes_of(&attributes[i], &corners[i]);
    }
}

void qtri_corners_fetch(const qtri_primitive *primitive, const qtri_corner *corners, int count,
                        qtri_clip_vertex v[3])
{
    const qtri_vec4 *position[3];
    for (int i = 0; i < count; i++) {
        position[i] = &corners[i].position;
    }
    qtri_projector_points(&primitive->projector, position, count, v);
}

static inline bool is_at(const qtri_vec4 *a, const qtri_vec4 *b)
{
    return a->x == b->x && a->y == b->y && a->z == b->z;
}

/* The vertex of three corners that is at this position; NULL: none. */
static inline const qtri_vertex *find_vertex(const qtri_vertex v[3], const qtri_corner *corners,
                                             const qtri_vec4 *position)
{
    if (is_at(&corners[2].position, position)) { /* fans and strips share these */
        return &v[2];
    }
    if (is_at(&corners[0].position, position)) {
        return &v[0];
    }
    return is_at(&corners[1].position, position) ? &v[1] : NULL;
}

void qtri_corners_init(qtri_corners *c, const qtri_surface *surface, const qtri_view *view,
                       const qtri_transform *pose, const qtri_material *material, int shade)
{
    static const qtri_mesh empty;
    qtri_mesh_job *job = &c->job;
    c->before = NULL;
    c->alphas = material->alphas;
    c->mesh = empty;
    c->mesh.positions = c->positions;
    c->mesh.uvs = c->uvs;
    c->mesh.colors = c->colors;
    job->material = *material;
    job->mesh = &c->mesh;
    job->vertices = c->vertex[0];
    job->slot_count = 3;
    job->lit_per_vertex = false;
    job->lit_per_face = false;
    job->noted = false;
    job->lit = true;
    job->shaded_per_vertex = false;
    job->lights = NULL;
    job->illumination = NULL;
    job->lit_colors = NULL;
    job->late = NULL;
    qtri_primitive_init(&job->primitive, surface, view, pose, &job->material, shade);
    if (material->fill == NULL) {
        qtri_mesh_solid_init(job);
        for (uint32_t i = 0; i < 3; i++) { /* whose alphas a clipped triangle's vertices have */
            job->primitive.to.solid.state.alpha_index[i] = i;
        }
    }
}

QTRI_NOINLINE qtri_corners_fate qtri_corners_place(qtri_corners *c, const qtri_corner *corners,
                                                   uint32_t first)
{
    const qtri_vertex *before = c->before;
    qtri_vertex *v = c->vertex[before == c->vertex[0]];
    uint32_t count = 0;
    c->before = NULL;
    c->job.vertices = v;
    c->job.material.alphas = c->alphas != NULL ? c->alphas + first : NULL;
    if (c->job.material.fill != NULL) {
        return QTRI_CORNERS_ELSEWHERE;
    }
    for (uint32_t i = 0; i < 3; i++) {
        const qtri_vec4 *position = &corners[i].position;
        if (position->w != Q16_ONE) {
            return QTRI_CORNERS_ELSEWHERE;
        }
        c->positions[i].x = position->x;
        c->positions[i].y = position->y;
        c->positions[i].z = position->z;
        const qtri_vertex *same =
            before != NULL ? find_vertex(before, corners - 3, position) : NULL;
        if (same != NULL) {
            v[i] = *same;
            continue;
        }
        v[count++].index = (uint16_t)i;
    }
    if (count != 0 && !qtri_projector_list(&c->job.primitive.projector, c->positions, count, v)) {
        return QTRI_CORNERS_ELSEWHERE;
    }
    c->before = v;
    const int64_t area = qtri_triangle_area(&v[0].at, &v[1].at, &v[2].at);
    return area == 0 || qtri_is_culled(c->job.material.cull, area) ? QTRI_CORNERS_CULLED
                                                                   : QTRI_CORNERS_SEEN;
}

void qtri_corners_draw(qtri_corners *c, const qtri_corner *attributes)
{
    static const uint16_t indices[3] = {0, 1, 2};
    qtri_vertex *v = c->job.vertices;
    for (int i = 0; i < 3; i++) {
        c->colors[i] = attributes[i].color;
        c->uvs[i] = attributes[i].uv;
        v[i].intensity_q15 = QTRI_INTENSITY_ONE;
    }
    qtri_mesh_draw_solid(&c->job, indices, &v[0], &v[1], &v[2]);
}

void qtri_corners_draw_clipped(const qtri_corners *c, qtri_shape *shape,
                               const qtri_corner *attributes)
{
    qtri_primitive_triangle(&c->job.primitive, shape, set_attributes, attributes);
}

void qtri_draw_triangles(const qtri_surface *surface, const qtri_view *view,
                         const qtri_transform *pose, const qtri_corner *corners,
                         uint32_t corner_count, const qtri_material *material)
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_CHECK(qtri_check_view(view, pose));
    QTRI_CHECK(qtri_check_corners(corners, corner_count, 3));
    qtri_corners c;
    qtri_corners_init(&c, surface, view, pose, material,
                      qtri_is_smooth(material) ? QTRI_COLORS : QTRI_TINT);
    for (uint32_t i = 0; corner_count - i >= 3; i += 3) {
        const qtri_corners_fate found = qtri_corners_place(&c, &corners[i], i);
        if (found == QTRI_CORNERS_SEEN) {
            qtri_corners_draw(&c, &corners[i]);
        } else if (found == QTRI_CORNERS_ELSEWHERE) {
            qtri_shape shape;
            qtri_corners_fetch(&c.job.primitive, &corners[i], 3, shape.clip);
            qtri_corners_draw_clipped(&c, &shape, &corners[i]);
        }
    }
}

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
    qtri_primitive_place(&primitive, view, pose);
    qtri_primitive_begin_lines(&primitive);
    for (uint32_t i = 0; corner_count - i >= 2; i += 2) {
        qtri_clip_vertex v[3];
        qtri_screen_vertex attributes[2];
        qtri_corners_fetch(&primitive, &corners[i], 2, v);
        attributes_of(&attributes[0], &corners[i]);
        attributes_of(&attributes[1], &corners[i + 1]);
        qtri_primitive_line(&primitive, v, attributes);
    }
}
