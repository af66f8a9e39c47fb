/* SPDX-License-Identifier: MIT */
/*
 * Draw calls of strokes: polylines, wide lines, points and splats, wide wireframes, hidden lines.
 */
#include "qtri/pipeline_make.h"
#include "qtri/stroke.h"

#include "../geometry/projector.h"
#include "../raster/stroke.h"
#include "checked.h"
#include "mesh_job.h"

enum { VERTICES = 4 }; /* transformed at a time */

/* The corners of one draw call, and their transform. */
typedef struct stroke_job {
    qtri_projector projector;
    const qtri_corner *corners;
    uint32_t count;
    const qtri_vertex *vertices; /* of the first `kept` corners, on the screen */
    uint32_t kept;
} stroke_job;

/* Sets projection camera pose, and the material's depth bias; no vertices are kept. */
static void job_init(stroke_job *job, const qtri_view *view, const qtri_transform *pose,
                     const qtri_corner *corners, uint32_t count, const qtri_material *material)
{
    qtri_projector_init_view(&job->projector, view, pose, material->depth_bias, NULL);
    job->corners = corners;
    job->count = count;
    job->vertices = NULL;
    job->kept = 0;
}

static bool is_inside(const qtri_vertex *v)
{
    return (v->depth_16p8 & QTRI_VERTEX_OUTSIDE) == 0;
}

/* Position and depth of *out; the rest is left alone. */
static void project(const stroke_job *job, const qtri_clip_vertex *clip, qtri_vertex *out)
{
    qtri_screen_vertex screen;
    qtri_project(&job->projector, clip, &screen);
    out->at.x_24p8 = screen.x_24p8;
    out->at.y_24p8 = screen.y_24p8;
    out->depth_16p8 = screen.depth_16p16 & ~0xFFu;
}

/* Corner `corner` on the screen, of any w; marked as vertices of meshes are where it is outside. */
static void any_vertex(const stroke_job *job, uint32_t corner, qtri_vertex *out)
{
    const qtri_vec4 *const position[1] = {&job->corners[corner].position};
    qtri_clip_vertex clip;
    qtri_projector_points(&job->projector, position, 1, &clip);
    const unsigned outcode = qtri_clip_outcode(&clip);
    out->at.x_24p8 = 0;
    out->at.y_24p8 = 0;
    out->depth_16p8 = QTRI_VERTEX_OUTSIDE | outcode;
    if (outcode == 0) {
        project(job, &clip, out);
    }
}

/*
 * Corners `first` .. first + count - 1, at most VERTICES, as any_vertex(). Where w is 1 they are
 * transformed as vertices of meshes are, to the same bits.
 */
static void job_vertices(const stroke_job *job, uint32_t first, uint32_t count, qtri_vertex *out)
{
    qtri_vec3 p[VERTICES];
    bool have_no_w = true;
    for (uint32_t i = 0; i < count; i++) {
        const qtri_vec4 *position = &job->corners[first + i].position;
        p[i].x = position->x;
        p[i].y = position->y;
        p[i].z = position->z;
        have_no_w = have_no_w && position->w == Q16_ONE;
    }
    if (have_no_w) {
        (void)qtri_projector_vertices(&job->projector, p, count, out, false);
    }
    for (uint32_t i = 0; i < count; i++) {
        if (!have_no_w) {
            any_vertex(job, first + i, &out[i]);
        } else if (is_inside(&out[i])) {
            out[i].depth_16p8 &= ~0xFFu;
        }
    }
}

/* Part i goes from corner i to corner i + 1; behind the last corner comes the first. */
static inline uint32_t corner_at(const stroke_job *job, uint32_t i)
{
    return i < job->count ? i : 0;
}

static void find_vertex(const stroke_job *job, uint32_t corner, qtri_vertex *out)
{
    corner = corner_at(job, corner);
    if (corner < job->kept) {
        *out = job->vertices[corner];
    } else {
        any_vertex(job, corner, out);
    }
}

/* Clips a part: its new ends, and t of each along the part. False: nothing is left. A function of
   its own: few parts need its stack. */
QTRI_NOINLINE static bool clip_part(const stroke_job *job, uint32_t part, qtri_vertex end[2],
                                    int32_t t_q30[2])
{
    const qtri_vec4 *const position[2] = {&job->corners[part].position,
                                          &job->corners[corner_at(job, part + 1)].position};
    qtri_clip_vertex v[2];
    qtri_projector_points(&job->projector, position, 2, v);
    v[0].b1_q30 = 0;
    v[1].b1_q30 = (int32_t)1 << 30;
    const unsigned first = qtri_clip_outcode(&v[0]);
    const unsigned second = qtri_clip_outcode(&v[1]);
    if ((first & second) != 0 || !qtri_clip_line(v, first | second)) {
        return false;
    }
    for (int i = 0; i < 2; i++) {
        project(job, &v[i], &end[i]);
        t_q30[i] = v[i].b1_q30;
    }
    return true;
}

static void mix_colors(qtri_stroke_end end[2], const int32_t t_q30[2])
{
    for (int i = 0; i < 3; i++) {
        const int32_t from = end[0].color_8p16[i];
        const int32_t difference = end[1].color_8p16[i] - from;
        for (int k = 0; k < 2; k++) {
            end[k].color_8p16[i] = from + (int32_t)(qtri_mul_s32(difference, t_q30[k]) >> 30);
        }
    }
}

/* The finder of parts for qtri_stroker_draw(): the ends of a part; false: it is outside. */
static bool find_part(const void *from, uint32_t part, qtri_point at[2], qtri_stroke_end end[2])
{
    const stroke_job *job = from;
    qtri_vertex v[2];
    int32_t t_q30[2];
    find_vertex(job, part, &v[0]);
    find_vertex(job, part + 1, &v[1]);
    const bool is_cut = !is_inside(&v[0]) || !is_inside(&v[1]);
    if (is_cut && !clip_part(job, part, v, t_q30)) {
        return false;
    }
    at[0] = v[0].at;
    at[1] = v[1].at;
    if (end == NULL) {
        return true;
    }
    for (uint32_t i = 0; i < 2; i++) {
        end[i].depth_16p8 = v[i].depth_16p8;
        qtri_line_color_set(end[i].color_8p16, &job->corners[corner_at(job, part + i)].color,
                            QTRI_INTENSITY_ONE);
    }
    if (is_cut) {
        mix_colors(end, t_q30);
    }
    return true;
}

/* ---- Lines ---- */

static void check_draw(const qtri_surface *surface, const qtri_view *view,
                       const qtri_transform *pose, const qtri_stroke *stroke,
                       const qtri_material *material)
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_CHECK(qtri_check_view(view, pose));
    QTRI_CHECK(qtri_check_stroke(stroke));
    (void)surface, (void)material, (void)view, (void)pose, (void)stroke;
}

void qtri_draw_polyline(const qtri_surface *surface, const qtri_view *view,
                        const qtri_transform *pose, const qtri_corner *corners,
                        uint32_t corner_count, const qtri_stroke *stroke,
                        const qtri_material *material)
{
    check_draw(surface, view, pose, stroke, material);
    QTRI_CHECK(qtri_check_corners(corners, corner_count, 1));
    stroke_job job;
    qtri_stroker stroker;
    if (corner_count == 0 || !qtri_stroker_init(&stroker, surface, material, stroke, false)) {
        return;
    }
    job_init(&job, view, pose, corners, corner_count, material);
    const uint32_t kept = view->vertices == NULL              ? 0
                          : view->vertex_count < corner_count ? view->vertex_count
                                                              : corner_count;
    for (uint32_t i = 0; i < kept; i++) {
        any_vertex(&job, i, &view->vertices[i]);
    }
    job.vertices = view->vertices;
    job.kept = kept;
    qtri_stroker_draw(&stroker, find_part, &job, corner_count, stroke->closed);
}

void qtri_draw_wide_lines(const qtri_surface *surface, const qtri_view *view,
                          const qtri_transform *pose, const qtri_corner *corners,
                          uint32_t corner_count, const qtri_stroke *stroke,
                          const qtri_material *material)
{
    check_draw(surface, view, pose, stroke, material);
    QTRI_CHECK(qtri_check_corners(corners, corner_count, 2));
    stroke_job job;
    qtri_stroker stroker;
    if (!qtri_stroker_init(&stroker, surface, material, stroke, false)) {
        return;
    }
    job_init(&job, view, pose, corners, 2, material);
    for (uint32_t i = 0; corner_count - i >= 2; i += 2) {
        job.corners = &corners[i];
        qtri_stroker_draw(&stroker, find_part, &job, 2, false);
    }
}

/* ---- Points ---- */

/*
 * Points and splats: parts without a length.
 *
 * The size of a splat on the screen is half the distance of the points that lie a width apart
 * around it, along the picture's rows' normal in eye space: the same for any projection.
 */

/* Half a width along what is up in the picture, in object space. */
static qtri_vec3 half_width_up(const qtri_view *view, const qtri_transform *pose, q16 width)
{
    qtri_transform object_to_eye;
    qtri_mat4 m;
    qtri_transform_mul(&object_to_eye, &view->camera, pose);
    qtri_transform_to_mat4(&object_to_eye, &m);
    const qtri_vec3 row = {m.m[1][0], m.m[1][1], m.m[1][2]};
    return qtri_vec3_scale(qtri_vec3_normalize(row), width / 2);
}

/* A splat's radius on the screen, 24.8: at least 1/256, at most QTRI_STROKE_WIDTH_MAX / 2. */
static int32_t radius_in_space(const stroke_job *job, const qtri_vec4 *center,
                               const qtri_vec3 *half, const qtri_point *at)
{
    const int32_t most = QTRI_STROKE_WIDTH_MAX * 128;
    qtri_vec4 rim = *center;
    qtri_clip_vertex clip;
    qtri_screen_vertex screen;
    rim.x = qtri_saturate32((int64_t)rim.x + qtri_mul_s32(half->x, rim.w) / 65536);
    rim.y = qtri_saturate32((int64_t)rim.y + qtri_mul_s32(half->y, rim.w) / 65536);
    rim.z = qtri_saturate32((int64_t)rim.z + qtri_mul_s32(half->z, rim.w) / 65536);
    const qtri_vec4 *const position[1] = {&rim};
    qtri_projector_points(&job->projector, position, 1, &clip);
    if ((qtri_clip_outcode(&clip) & ~(unsigned)QTRI_OUT_FAR) != 0) {
        return most;
    }
    qtri_project(&job->projector, &clip, &screen);
    /* Below 2^23 each. */
    const int64_t x = (int64_t)screen.x_24p8 - at->x_24p8;
    const int64_t y = (int64_t)screen.y_24p8 - at->y_24p8;
    const uint64_t radius = qtri_sqrt64_round((uint64_t)(x * x) + (uint64_t)(y * y));
    return radius > (uint64_t)most ? most : qtri_greatest32((int32_t)radius, 1);
}

void qtri_draw_points(const qtri_surface *surface, const qtri_view *view,
                      const qtri_transform *pose, const qtri_corner *corners, uint32_t corner_count,
                      const qtri_stroke *stroke, const qtri_material *material)
{
    check_draw(surface, view, pose, stroke, material);
    QTRI_CHECK(qtri_check_corners(corners, corner_count, 1));
    stroke_job job;
    qtri_stroker stroker;
    qtri_vec3 half = {0, 0, 0};
    qtri_stroke_place place;
    if (!qtri_stroker_init(&stroker, surface, material, stroke, stroke->in_space)) {
        return;
    }
    job_init(&job, view, pose, corners, corner_count, material);
    if (stroke->in_space) {
        half = half_width_up(view, pose, stroke->width);
    }
    place.radius_24p8 = stroker.radius;
    place.caps[0] = stroker.cap == QTRI_CAP_ROUND ? QTRI_CAP_ROUND : QTRI_CAP_SQUARE;
    place.caps[1] = place.caps[0];
    qtri_vertex vertices[VERTICES];
    for (uint32_t i = 0; i < corner_count; i++) {
        const qtri_vertex *v = &vertices[i % VERTICES];
        if (i % VERTICES == 0) {
            const uint32_t left = corner_count - i;
            job_vertices(&job, i, left < VERTICES ? left : VERTICES, vertices);
        }
        if (!is_inside(v)) {
            continue;
        }
        place.end[0] = v->at;
        place.end[1] = v->at;
        qtri_stroke_look_set_constant(&stroker.look, v->depth_16p8, &corners[i].color);
        if (stroke->in_space) {
            place.radius_24p8 = radius_in_space(&job, &corners[i].position, &half, &v->at);
        }
        qtri_stroker_draw_part(&stroker, &place);
    }
}

/* ---- Wireframes ---- */

/*
 * Edges are found, lit and owned as those of &qtri_wireframe are. Only the function that draws an
 * edge differs: for smooth lines one pixel wide, and for the wide ones of one call.
 */

static const qtri_stroke_line one_pixel = {128, false, 255};

static void begin_smooth(qtri_primitive *primitive)
{
    qtri_primitive_begin_lines(primitive);
    qtri_stroke_line_choose(&primitive->to.lines.job, primitive->surface, primitive->material,
                            &one_pixel, qtri_stroke_line_draw);
}

const qtri_fill qtri_smooth_wireframe = QTRI_WIREFRAME_FILL(begin_smooth);

/* What all edges of one call are drawn with. */
typedef struct wide_edges {
    qtri_stroker stroker;
    qtri_stroke_place place;
    qtri_stroke_line thin;
    qtri_line_draws draw_thin; /* NULL: edges are parts of strokes */
} wide_edges;

typedef struct wide_fill {
    qtri_fill fill; /* first: it is what a material names */
    wide_edges *edges;
} wide_fill;

/* See qtri_line_draws. */
static void draw_edge(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                      const qtri_line_color *color)
{
    wide_edges *wide = job->wide;
    wide->place.end[0] = a->at;
    wide->place.end[1] = b->at;
    qtri_line_look(&wide->stroker.look, job, a, b, color, false);
    qtri_stroker_draw_part(&wide->stroker, &wide->place);
}

/*
 * Adds to the rows of the line job as many as an edge reaches beyond its vertices: a radius, and
 * the corner of a square end a radius times sqrt(2).
 */
static void begin_wide(qtri_primitive *primitive)
{
    const void *fill = primitive->material->fill;
    wide_edges *wide = ((const wide_fill *)fill)->edges;
    qtri_line_job *job = &primitive->to.lines.job;
    qtri_primitive_begin_lines(primitive);
    if (wide->draw_thin != NULL) {
        qtri_stroke_line_choose(job, primitive->surface, primitive->material, &wide->thin,
                                wide->draw_thin);
        return;
    }
    const int32_t radius = wide->place.radius_24p8;
    const int32_t reach = radius + radius / 2 + 1;
    job->draw = draw_edge;
    job->wide = wide;
    job->top_24p8 -= reach;
    job->height_24p8 += 2 * (uint32_t)reach;
}

void qtri_draw_wide_wireframe(const qtri_surface *surface, const qtri_view *view,
                              const qtri_transform *pose, const qtri_mesh *mesh,
                              const qtri_stroke *stroke, const qtri_material *material)
{
    check_draw(surface, view, pose, stroke, material);
    QTRI_CHECK(qtri_check_mesh(mesh));
    wide_edges wide;
    const wide_fill fill = {QTRI_WIREFRAME_FILL(begin_wide), &wide};
    if (!qtri_stroker_init(&wide.stroker, surface, material, stroke, false)) {
        return;
    }
    wide.place.radius_24p8 = wide.stroker.radius;
    wide.place.caps[0] = wide.place.caps[1] = wide.stroker.cap;
    const qtri_stroke_line thin = {wide.stroker.radius, wide.stroker.cap == QTRI_CAP_SQUARE,
                                   stroke->alpha};
    const bool is_thin = stroke->edges != NULL && wide.stroker.cap != QTRI_CAP_ROUND &&
                         wide.stroker.radius <= QTRI_STROKE_LINE_RADIUS;
    wide.thin = thin;
    wide.draw_thin = is_thin ? stroke->edges->line : NULL;
    qtri_material wired = *material;
    wired.fill = &fill.fill;
    /* Lines reach beyond their mesh: no box says that none can be seen. */
    const qtri_box everywhere = {{0, 0, 0}, {INT32_MAX, INT32_MAX, INT32_MAX}};
    qtri_mesh unbounded = *mesh;
    unbounded.bounds = everywhere;
    qtri_draw_mesh(surface, view, pose, &unbounded, &wired);
}

/* Hidden lines draw faces into depth alone, most often compared by less. */
QTRI_PIPELINE(qtri_pipeline_depth_less, .format = QTRI_DEPTH_ONLY, .depth = QTRI_LINEAR16,
              .compare = QTRI_LESS)
static const qtri_pipeline *const faces[] = {&qtri_pipeline_depth_less, &qtri_pipeline_any, NULL};

/* The material's depth bias plus `bias` towards the eye, on the side that passes the comparison. */
static q16 nearer_by(const qtri_material *material, q16 bias)
{
    const bool is_greater =
        material->depth_compare == QTRI_GREATER || material->depth_compare == QTRI_GREATER_EQUAL;
    const q16 held = qtri_hold32(bias, 0, Q16_ONE);
    const int64_t sum = (int64_t)material->depth_bias + (is_greater ? held : -held);
    return qtri_saturate32(sum);
}

void qtri_draw_hidden_lines(const qtri_surface *surface, const qtri_view *view,
                            const qtri_transform *pose, const qtri_mesh *mesh,
                            const qtri_stroke *stroke, const qtri_material *material, q16 bias)
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_CHECK(qtri_check_view(view, pose));
    QTRI_CHECK(qtri_check_mesh(mesh));
    qtri_surface depth = *surface;
    qtri_material solid = *material;
    qtri_material lines = *material;
    qtri_view unlit = *view;
    if (surface->format != NULL) {
        depth.format = &qtri_depth_only;
    }
    solid.fill = NULL;
    solid.depth_read_only = false;
    solid.shading = QTRI_FLAT_LAST; /* of colours that nobody sees */
    if (solid.texture != NULL && !solid.texture->has_key && solid.least_alpha == 0) {
        solid.texture = NULL;
    }
    lines.fill = &qtri_wireframe;
    lines.depth_bias = nearer_by(material, bias);
    unlit.light = NULL;
    unlit.pipelines = faces;
    solid.fog = NULL;
    qtri_draw_mesh(&depth, &unlit, pose, mesh, &solid);
    if (stroke != NULL) {
        qtri_draw_wide_wireframe(surface, view, pose, mesh, stroke, &lines);
    } else {
        qtri_draw_mesh(surface, view, pose, mesh, &lines);
    }
}
