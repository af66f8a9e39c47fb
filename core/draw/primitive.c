/* SPDX-License-Identifier: MIT */
#include "fill.h"
#include "large_piece.h"
#include "per_pixel.h"

void qtri_primitive_set_target(qtri_primitive *primitive, const qtri_surface *surface,
                               const qtri_view *view, const qtri_material *material, int shade)
{
    primitive->surface = surface;
    primitive->material = material;
    if (material->fill != NULL) {
        material->fill->begin(primitive);
        return;
    }
    qtri_draw_state *state = &primitive->to.solid.state;
    primitive->to.solid.small.state = state;
    qtri_draw_state_init(state, surface, view->pipelines, material, shade);
    if (shade == QTRI_BY_PIXEL) {
        qtri_draw_state_prefer(state, qtri_by_pixel_of(material)->pipelines);
    }
}

void qtri_primitive_begin_lines(qtri_primitive *primitive)
{
    qtri_line_job_init(&primitive->to.lines.job, primitive->surface, primitive->material,
                       &primitive->to.lines.target);
}

void qtri_primitive_place_in_eye(qtri_primitive *primitive, const qtri_view *view,
                                 const qtri_transform *object_to_eye)
{
    qtri_transform object_to_clip;
    qtri_transform_mul(&object_to_clip, &view->projection, object_to_eye);
    qtri_projector_init(&primitive->projector, &object_to_clip, &view->viewport);
    if (primitive->material->depth_bias != 0) {
        qtri_projector_set_depth(&primitive->projector, &view->viewport,
                                 primitive->material->depth_bias);
    }
}

void qtri_primitive_place(qtri_primitive *primitive, const qtri_view *view,
                          const qtri_transform *pose)
{
    qtri_transform object_to_eye;
    qtri_transform_mul(&object_to_eye, &view->camera, pose);
    qtri_primitive_place_in_eye(primitive, view, &object_to_eye);
}

void qtri_primitive_init(qtri_primitive *primitive, const qtri_surface *surface,
                         const qtri_view *view, const qtri_transform *pose,
                         const qtri_material *material, int shade)
{
    qtri_primitive_set_target(primitive, surface, view, material, shade);
    qtri_primitive_place(primitive, view, pose);
}

/* What is left of the triangle after cuts by `planes`; *out may be where v is. */
QTRI_NOINLINE static int clip_to_screen(const qtri_projector *projector,
                                        const qtri_clip_vertex v[3], unsigned planes,
                                        qtri_fan_vertex out[QTRI_CLIP_MAX])
{
    qtri_clip_vertex polygon[QTRI_CLIP_MAX];
    int count = 3;
    for (int i = 0; i < 3; i++) {
        polygon[i] = v[i];
        polygon[i].b1_q30 = i == 1 ? (int32_t)1 << 30 : 0;
        polygon[i].b2_q30 = i == 2 ? (int32_t)1 << 30 : 0;
    }
    if (planes != 0) {
        count = qtri_clip_polygon(polygon, 3, planes);
    }
    for (int i = 0; i < count; i++, out++) {
        qtri_screen_vertex screen;
        qtri_project(projector, &polygon[i], &screen);
        out->at.x_24p8 = screen.x_24p8;
        out->at.y_24p8 = screen.y_24p8;
        out->depth_16p8 = screen.depth_16p16 | (uint32_t)screen.inv_w_exponent;
        out->inv_w_q31 = screen.inv_w_q31;
        out->b1_q30 = polygon[i].b1_q30;
        out->b2_q30 = polygon[i].b2_q30;
        qtri_project_rest(out->rest, &polygon[i], &out->at, out->inv_w_q31);
    }
    return count;
}

/* Twice the area of triangle i of a fan, i = 2 .. count-1. */
static int64_t piece_area(const qtri_fan_vertex fan[], int i)
{
    return qtri_triangle_area(&fan[0].at, &fan[i - 1].at, &fan[i].at);
}

static int64_t fan_area(const qtri_fan_vertex fan[], int count)
{
    int64_t sum = 0;
    for (int i = 2; i < count; i++) {
        sum += piece_area(fan, i);
    }
    return sum;
}

/*
 * Whether a line lies above or below the surface's rows, as most do of a band: two rows further
 * than its ends, since smooth lines reach a pixel and its corners beyond them.
 */
static bool is_beside(const qtri_line_job *job, int32_t y0_24p8, int32_t y1_24p8)
{
    const int32_t above = job->top_24p8 - 512;
    const int32_t below = job->top_24p8 + (int32_t)job->height_24p8 + 512;
    return (y0_24p8 < above && y1_24p8 < above) || (y0_24p8 >= below && y1_24p8 >= below);
}

/* The edge between two vertices, given twice: as coordinates, and as attributes. */
QTRI_NOINLINE static void draw_edge(const qtri_primitive *primitive, const qtri_clip_vertex *a,
                                    const qtri_clip_vertex *b,
                                    const qtri_screen_vertex *a_attributes,
                                    const qtri_screen_vertex *b_attributes)
{
    qtri_clip_vertex end[2] = {*a, *b};
    unsigned first = qtri_clip_outcode(a);
    unsigned second = qtri_clip_outcode(b);
    end[0].b1_q30 = 0;
    end[1].b1_q30 = (int32_t)1 << 30;
    if ((first & second) != 0 || !qtri_clip_line(end, first | second)) {
        return;
    }
    const qtri_line_job *job = &primitive->to.lines.job;
    qtri_screen_vertex screen[2];
    qtri_project(&primitive->projector, &end[0], &screen[0]);
    qtri_project(&primitive->projector, &end[1], &screen[1]);
    if (is_beside(job, screen[0].y_24p8, screen[1].y_24p8)) {
        return;
    }
    qtri_vertex line[2];
    qtri_line_color color[2];
    for (int i = 0; i < 2; i++) {
        qtri_blend_attributes(&screen[i], a_attributes, b_attributes, b_attributes, end[i].b1_q30,
                              0);
        qtri_line_end(&line[i], color[i], &screen[i]);
    }
    job->draw(job, &line[0], &line[1], (const qtri_line_color *)color);
}

QTRI_NOINLINE static void draw_whole_outline(const qtri_primitive *primitive,
                                             const qtri_fan_vertex corner[3],
                                             qtri_screen_vertex attributes[3])
{
    const qtri_line_job *job = &primitive->to.lines.job;
    qtri_vertex end[4];
    qtri_line_color color[4];
    for (int i = 0; i < 4; i++) { /* back to the first */
        int from = i < 3 ? i : 0;
        attributes[from].x_24p8 = corner[from].at.x_24p8;
        attributes[from].y_24p8 = corner[from].at.y_24p8;
        attributes[from].depth_16p16 = corner[from].depth_16p8 & ~0xFFu;
        qtri_line_end(&end[i], color[i], &attributes[from]);
    }
    for (int i = 0; i < 3; i++) {
        job->draw(job, &end[i], &end[i + 1], (const qtri_line_color *)&color[i]);
    }
}

/* The ends of an unclipped triangle serve two lines each; otherwise every edge is clipped anew. */
void qtri_primitive_outline(const qtri_primitive *primitive, const qtri_clip_vertex v[3],
                            unsigned planes, qtri_attribute_source source, const void *from)
{
    qtri_screen_vertex attributes[3];
    qtri_fan_vertex fan[QTRI_CLIP_MAX];
    int count = clip_to_screen(&primitive->projector, v, planes, fan);
    if (count == 0 || qtri_is_culled(primitive->material->cull, fan_area(fan, count))) {
        return;
    }
    source(from, attributes);
    qtri_spread_provoking(primitive->material, attributes);
    if (planes == 0) {
        draw_whole_outline(primitive, fan, attributes);
        return;
    }
    for (int i = 0; i < 3; i++) {
        int next = i < 2 ? i + 1 : 0;
        draw_edge(primitive, &v[i], &v[next], &attributes[i], &attributes[next]);
    }
}

/*
 * What clipping left is a fan around its first vertex. Of its triangles those are drawn whose area
 * has the sign of the sum: snapping may dent the polygon by a sliver that turns the other way. Its
 * pixels belong to the neighbour in the fan, too.
 */
void qtri_primitive_triangle(const qtri_primitive *primitive, qtri_shape *shape,
                             qtri_attribute_source source, const void *from)
{
    unsigned common = ~0u;
    unsigned planes = 0;
    for (int i = 0; i < 3; i++) {
        unsigned outcode = qtri_clip_outcode(&shape->clip[i]);
        common &= outcode;
        planes |= outcode;
    }
    if (common != 0) {
        return;
    }
    const qtri_fill *fill = primitive->material->fill;
    if (fill != NULL) {
        fill->clipped(primitive, shape->clip, planes, source, from);
        return;
    }
    int count = clip_to_screen(&primitive->projector, shape->clip, planes, shape->fan);
    int64_t sum = fan_area(shape->fan, count);
    if (sum == 0 ||
        qtri_is_culled(primitive->material->cull, sum)) { /* 0, too, when nothing is left */
        return;
    }
    const qtri_fan_vertex *piece[3] = {&shape->fan[0], NULL, NULL};
    for (int i = 2; i < count; i++) {
        int64_t area = count == 3 ? sum : piece_area(shape->fan, i);
        if (area != 0 && (area ^ sum) >= 0) {
            piece[1] = &shape->fan[i - 1];
            piece[2] = &shape->fan[i];
            qtri_draw_large_piece(primitive, piece, area, source, from);
        }
    }
}

void qtri_primitive_line(const qtri_primitive *primitive, const qtri_clip_vertex v[2],
                         const qtri_screen_vertex attributes[2])
{
    draw_edge(primitive, &v[0], &v[1], &attributes[0], &attributes[1]);
}
