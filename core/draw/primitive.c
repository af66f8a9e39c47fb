/* SPDX-License-Identifier: MIT */
#include "mesh_job.h"

void qtri_primitive_set_target(qtri_primitive *primitive, const qtri_surface *surface,
                               const qtri_view *view, const qtri_material *material,
                               const qtri_texture *texture, int shade)
{
    primitive->surface = surface;
    primitive->material = material;
    if (material->fill != NULL) {
        material->fill->begin(primitive);
        return;
    }
    qtri_draw_state *state = &primitive->to.solid.state;
    primitive->to.solid.small.state = state;
    qtri_draw_state_init(state, surface, view->pipelines, material, texture, shade);
    if (shade == QTRI_BY_PIXEL) {
        qtri_draw_state_prefer(state, qtri_by_pixel_of(material)->pipelines);
    }
}

void qtri_primitive_begin_lines(qtri_primitive *primitive)
{
    qtri_line_job_init(&primitive->to.lines.job, primitive->surface, primitive->material,
                       &primitive->to.lines.target);
}

/* Clips a triangle by `planes` and projects it; returns its vertex count. *out may be *v. */
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

/* Twice the signed area of a fan; below 0: it is front. */
static int64_t fan_area(const qtri_fan_vertex fan[], int count)
{
    int64_t sum = 0;
    for (int i = 2; i < count; i++) {
        sum += piece_area(fan, i);
    }
    return sum;
}

/* ---- Attributes ---- */

/* a0 + (a1 - a0) b1 + (a2 - a0) b2, times 2^16: products of 33 and 31 bits. */
QTRI_NOINLINE static int64_t mix_q16(int32_t a0, int32_t a1, int32_t a2, const int32_t b_q30[2])
{
    int64_t one = (((int64_t)a1 - a0) * b_q30[0]) >> 14;
    int64_t two = (((int64_t)a2 - a0) * b_q30[1]) >> 14;
    return (int64_t)a0 * 65536 + one + two;
}

/* Attributes of a clipped vertex at barycentric coordinates b1 and b2 of the triangle. */
static void interpolate_attributes(qtri_screen_vertex *out, const qtri_screen_vertex *a0,
                                   const qtri_screen_vertex *a1, const qtri_screen_vertex *a2,
                                   int32_t b1_q30, int32_t b2_q30)
{
    const int32_t b_q30[2] = {b1_q30, b2_q30};
    for (int i = 0; i < 3; i++) {
        int64_t sum = mix_q16(a0->color_8p16[i], a1->color_8p16[i], a2->color_8p16[i], b_q30);
        out->color_8p16[i] = (int32_t)(sum >> 16); /* 0..255.0, as the three are */
    }
    out->u_q32 = mix_q16((int32_t)(a0->u_q32 >> 16), (int32_t)(a1->u_q32 >> 16),
                         (int32_t)(a2->u_q32 >> 16), b_q30);
    out->v_q32 = mix_q16((int32_t)(a0->v_q32 >> 16), (int32_t)(a1->v_q32 >> 16),
                         (int32_t)(a2->v_q32 >> 16), b_q30);
}

/* Flat shading: all three get the provoking vertex's colour. */
static void spread_provoking_color(const qtri_material *material, qtri_screen_vertex v[3])
{
    if (qtri_is_smooth(material)) {
        return;
    }
    const qtri_screen_vertex *from = &v[qtri_provoking_of(material)];
    for (int i = 0; i < 3; i++) {
        for (int channel = 0; channel < 3; channel++) {
            v[i].color_8p16[channel] = from->color_8p16[channel];
        }
    }
}

/* ---- Lines ---- */

QTRI_NOINLINE void qtri_primitive_line(const qtri_primitive *primitive, const qtri_clip_vertex *a,
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
    if (qtri_line_misses(job, screen[0].y_24p8, screen[1].y_24p8, screen[1].y_24p8)) {
        return;
    }
    qtri_vertex line[2];
    qtri_line_color color[2];
    for (int i = 0; i < 2; i++) {
        interpolate_attributes(&screen[i], a_attributes, b_attributes, b_attributes, end[i].b1_q30,
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
    spread_provoking_color(primitive->material, attributes);
    if (planes == 0) {
        draw_whole_outline(primitive, fan, attributes);
        return;
    }
    for (int i = 0; i < 3; i++) {
        int next = i < 2 ? i + 1 : 0;
        qtri_primitive_line(primitive, &v[i], &v[next], &attributes[i], &attributes[next]);
    }
}

/* ---- Large triangles ---- */

bool qtri_is_beside(const qtri_draw_state *state, const qtri_point *const p[3])
{
    const qtri_rect *b = &state->bounds;
    const int32_t x0 = b->x0 * 256, x1 = b->x1 * 256, y0 = b->y0 * 256, y1 = b->y1 * 256;
    return (p[0]->x_24p8 < x0 && p[1]->x_24p8 < x0 && p[2]->x_24p8 < x0) ||
           (p[0]->x_24p8 > x1 && p[1]->x_24p8 > x1 && p[2]->x_24p8 > x1) ||
           (p[0]->y_24p8 < y0 && p[1]->y_24p8 < y0 && p[2]->y_24p8 < y0) ||
           (p[0]->y_24p8 > y1 && p[1]->y_24p8 > y1 && p[2]->y_24p8 > y1);
}

uint32_t qtri_color_word(const int32_t color_8p16[3])
{
    uint32_t word = 0;
    for (int i = 0; i < 3; i++) {
        const int32_t c = qtri_hold32(color_8p16[i] + 0x8000, 0, 0xFFFFFF);
        word = word << 8 | (uint32_t)c >> 16;
    }
    return word;
}

/* ---- Pieces of a triangle ---- */

/* Which of the triangle's vertices this is, 0..2; -1: clipping made it. Not both weights can be 1:
   their sum is 1 at most. */
static int own_vertex(const qtri_fan_vertex *v)
{
    const int32_t one_q30 = (int32_t)1 << 30;
    if ((v->b1_q30 | v->b2_q30) == 0) {
        return 0;
    }
    if ((v->b1_q30 | v->b2_q30) != one_q30) {
        return -1;
    }
    return v->b1_q30 != 0 ? 1 : 2;
}

/* Alpha, Q16, interpolated at a vertex. Clipping leaves weights of 0 or more, whose sum is 1 at
   most: a mean of the three. */
static uint32_t alpha_at(const qtri_draw_state *state, const qtri_fan_vertex *v)
{
    const int32_t b_q30[2] = {v->b1_q30, v->b2_q30};
    int32_t a_q16[3];
    for (int i = 0; i < 3; i++) {
        a_q16[i] = (int32_t)(((uint32_t)state->alphas[state->alpha_index[i]] << 16) / 255);
    }
    return (uint32_t)(mix_q16(a_q16[0], a_q16[1], a_q16[2], b_q30) >> 16);
}

static void set_vertex(qtri_large_vertex *out, const qtri_draw_state *state,
                       const qtri_fan_vertex *v, const qtri_screen_vertex attributes[3])
{
    qtri_screen_vertex blend;
    const qtri_screen_vertex *from = &blend;
    const int own = own_vertex(v);
    if (own >= 0) {
        from = &attributes[own];
    } else {
        interpolate_attributes(&blend, &attributes[0], &attributes[1], &attributes[2], v->b1_q30,
                               v->b2_q30);
    }
    out->depth_16p16 = v->depth_16p8 & ~0xFFu;
    out->inv_w_q31 = v->inv_w_q31;
    out->inv_w_exponent = (int32_t)(v->depth_16p8 & 0xFFu);
    for (int i = 0; i < 3; i++) {
        out->color_8p16[i] = from->color_8p16[i];
    }
    /* 255.0 is 1: over 510, by 2^39 / 255, rounded up by less than 2^-32 of itself. */
    out->light_q15 = qtri_mul_high32((uint32_t)from->color_8p16[0] >> 1, 0x80808081u) >> 7;
    if (state->options.per_pixel) {
        out->color_8p16[0] = v->b1_q30;
        out->color_8p16[1] = v->b2_q30;
    }
    out->u_q32 = from->u_q32;
    out->v_q32 = from->v_q32;
    out->rest[0] = v->rest[0];
    out->rest[1] = v->rest[1];
    out->alpha_q16 = state->options.vertex_alpha ? alpha_at(state, v) : 65536;
}

QTRI_NOINLINE uint32_t qtri_primitive_set_piece(qtri_large_vertex v[3],
                                                const qtri_primitive *primitive,
                                                const qtri_fan_vertex *const vertex[3],
                                                qtri_attribute_source source, const void *from)
{
    const qtri_draw_state *state = primitive->to.solid.small.state;
    qtri_screen_vertex attributes[3];
    source(from, attributes);
    spread_provoking_color(primitive->material, attributes);
    for (int i = 0; i < 3; i++) {
        set_vertex(&v[i], state, vertex[i], attributes);
    }
    return qtri_color_word(attributes[0].color_8p16);
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
    qtri_draw_state *state = primitive->to.solid.small.state;
    const qtri_fan_vertex *piece[3] = {&shape->fan[0], NULL, NULL};
    for (int i = 2; i < count; i++) {
        const int64_t area = piece_area(shape->fan, i);
        if (area != 0 && (area ^ sum) >= 0) {
            piece[1] = &shape->fan[i - 1];
            piece[2] = &shape->fan[i];
            const qtri_point *const p[3] = {&piece[0]->at, &piece[1]->at, &piece[2]->at};
            if (!qtri_is_beside(state, p)) {
                qtri_large_vertex v[3];
                const uint32_t color = qtri_primitive_set_piece(v, primitive, piece, source, from);
                qtri_large_triangle(state, p, area, color, v);
            }
        }
    }
}
