#include "primitive.h"

void qtri_primitive_init(qtri_primitive *primitive, const qtri_surface *surface,
                         const qtri_view *view, const qtri_transform *pose,
                         const qtri_material *material)
{
    qtri_transform object_to_clip;
    qtri_transform_mul(&object_to_clip, &view->camera, pose);
    qtri_transform_mul(&object_to_clip, &view->projection, &object_to_clip);
    primitive->surface = surface;
    primitive->material = material;
    qtri_raster_init(&primitive->raster, surface, material);
    qtri_line_job_init(&primitive->line, surface, material);
    qtri_projector_init(&primitive->projector, &object_to_clip, &view->viewport);
}

bool qtri_primitive_culled(const qtri_material *material, int64_t area)
{
    return (material->cull == QTRI_CULL_BACK && area >= 0) ||
           (material->cull == QTRI_CULL_FRONT && area <= 0);
}

int64_t qtri_primitive_area(const qtri_screen_vertex *a, const qtri_screen_vertex *b,
                            const qtri_screen_vertex *c)
{
    return (int64_t)(b->x_24p8 - a->x_24p8) * (c->y_24p8 - a->y_24p8) -
           (int64_t)(c->x_24p8 - a->x_24p8) * (b->y_24p8 - a->y_24p8);
}

/* a0 + (a1 - a0) b1 + (a2 - a0) b2, all times 2^16, for a0..a2 of 32 bits: 33 bits times 31. */
static int64_t blend_q16(int64_t a0, int64_t a1, int64_t a2, const qtri_clip_vertex *v)
{
    int64_t one = ((a1 - a0) * v->b1_q30) >> 14;
    int64_t two = ((a2 - a0) * v->b2_q30) >> 14;
    return a0 * 65536 + one + two;
}

/* Attributes of a clipped vertex from those of the triangle's own three. */
static void blend_attributes(qtri_screen_vertex *out, const qtri_screen_vertex a[3],
                             const qtri_clip_vertex *v)
{
    for (int i = 0; i < 3; i++) {
        int64_t sum = blend_q16(a[0].color_8p16[i], a[1].color_8p16[i], a[2].color_8p16[i], v);
        out->color_8p16[i] = (int32_t)(sum >> 16); /* 0..255.0, as the three are */
    }
    out->u_q32 = blend_q16(a[0].u_q32 >> 16, a[1].u_q32 >> 16, a[2].u_q32 >> 16, v);
    out->v_q32 = blend_q16(a[0].v_q32 >> 16, a[1].v_q32 >> 16, a[2].v_q32 >> 16, v);
}

/* Flat: lines and the pieces of a clipped triangle have no provoking vertex of their own. */
static void spread_provoking(const qtri_material *material, qtri_screen_vertex v[3])
{
    if (material->shading == QTRI_SMOOTH) {
        return;
    }
    int from = material->shading == QTRI_FLAT_FIRST ? 0 : 2;
    for (int i = 0; i < 3; i++) {
        for (int channel = 0; channel < 3; channel++) {
            v[i].color_8p16[channel] = v[from].color_8p16[channel];
        }
    }
}

void qtri_primitive_screen_triangle(const qtri_primitive *primitive, qtri_screen_vertex v[3])
{
    if (primitive->material->fill == QTRI_SOLID) {
        qtri_raster_draw(&primitive->raster, v);
    } else if (!qtri_primitive_culled(primitive->material,
                                      qtri_primitive_area(&v[0], &v[1], &v[2]))) {
        spread_provoking(primitive->material, v);
        qtri_line_triangle(&primitive->line, v);
    }
}

/*
 * The polygon that clipping left, as a fan around its first vertex. Returns the sum of its areas;
 * draws the triangles whose area has the sign of `side`. Snapping may dent the polygon by a sliver
 * that turns the other way: its pixels belong to the neighbour in the fan, too.
 */
static int64_t draw_fan(const qtri_primitive *primitive, const qtri_clip_vertex polygon[],
                        int count, const qtri_screen_vertex attributes[3], int64_t side)
{
    int64_t sum = 0;
    qtri_screen_vertex fan[3];
    for (int i = 0; i < count; i++) {
        qtri_screen_vertex *out = &fan[i < 2 ? i : 2];
        qtri_project(&primitive->projector, &polygon[i], out);
        blend_attributes(out, attributes, &polygon[i]);
        if (i >= 2) {
            int64_t area = qtri_primitive_area(&fan[0], &fan[1], &fan[2]);
            sum += area;
            if ((side < 0 && area < 0) || (side > 0 && area > 0)) {
                qtri_raster_draw(&primitive->raster, fan);
            }
            fan[1] = fan[2];
        }
    }
    return sum;
}

void qtri_primitive_triangle(const qtri_primitive *primitive, const qtri_clip_vertex v[3],
                             const qtri_screen_vertex attributes[3])
{
    qtri_clip_vertex polygon[QTRI_CLIP_MAX] = {v[0], v[1], v[2]};
    unsigned outcode[3];
    for (int i = 0; i < 3; i++) {
        outcode[i] = qtri_clip_outcode(&v[i]);
        polygon[i].b1_q30 = i == 1 ? (int32_t)1 << 30 : 0;
        polygon[i].b2_q30 = i == 2 ? (int32_t)1 << 30 : 0;
    }
    if ((outcode[0] & outcode[1] & outcode[2]) != 0) {
        return;
    }
    qtri_screen_vertex corner[3] = {attributes[0], attributes[1], attributes[2]};
    unsigned planes = outcode[0] | outcode[1] | outcode[2];
    if (planes == 0) {
        for (int i = 0; i < 3; i++) {
            qtri_project(&primitive->projector, &v[i], &corner[i]);
        }
        qtri_primitive_screen_triangle(primitive, corner);
        return;
    }
    spread_provoking(primitive->material, corner);
    int count = qtri_clip_polygon(polygon, 3, planes);
    int64_t area = draw_fan(primitive, polygon, count, corner, 0);
    if (count == 0 || qtri_primitive_culled(primitive->material, area)) {
        return;
    }
    if (primitive->material->fill == QTRI_SOLID) {
        draw_fan(primitive, polygon, count, corner, area);
    } else {
        for (int i = 0; i < 3; i++) {
            int next = (i + 1) % 3;
            qtri_clip_vertex edge[2] = {v[i], v[next]};
            qtri_screen_vertex ends[2] = {corner[i], corner[next]};
            qtri_primitive_line(primitive, edge, ends);
        }
    }
}

void qtri_primitive_line(const qtri_primitive *primitive, const qtri_clip_vertex v[2],
                         const qtri_screen_vertex attributes[2])
{
    qtri_clip_vertex end[2] = {v[0], v[1]};
    unsigned outcode[2];
    for (int i = 0; i < 2; i++) {
        outcode[i] = qtri_clip_outcode(&v[i]);
        end[i].b1_q30 = i == 1 ? (int32_t)1 << 30 : 0;
        end[i].b2_q30 = 0;
    }
    if ((outcode[0] & outcode[1]) != 0 || !qtri_clip_line(end, outcode[0] | outcode[1])) {
        return;
    }
    qtri_screen_vertex corner[3] = {attributes[0], attributes[1], attributes[1]};
    qtri_line_end line[2];
    for (int i = 0; i < 2; i++) {
        qtri_screen_vertex screen;
        qtri_project(&primitive->projector, &end[i], &screen);
        blend_attributes(&screen, corner, &end[i]);
        qtri_line_end_init(&line[i], &primitive->line, &screen);
    }
    qtri_line_draw(&primitive->line, &line[0], &line[1]);
}
