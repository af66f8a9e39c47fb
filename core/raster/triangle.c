/* SPDX-License-Identifier: MIT */
#include "triangle.h"

#include "../geometry/projector.h"
#include "effect.h"
#include "checked_material.h"
#include "depth_clamp.h"
#include "small.h"
#include "rows.h"
#include "sampling.h"
#include "setup.h"

QTRI_IN_PLACE void fill_rows(qtri_job *job, const qtri_span *spans, int32_t row, int32_t count,
                             qtri_fill_rows fill)
{
    if (!job->clamps_depth || qtri_depth_clamp_is_inside(job, spans, row, count)) {
        fill(job, spans, row, count);
        return;
    }
    qtri_span part = {0, 0};
    int32_t i = -1;
    while (qtri_depth_clamp_next(job, &part, &i, spans, row, count)) {
        fill(job, &part, row + i, 1);
    }
}

/* Apart, as its edges take stack that most triangles do without. */
QTRI_NOINLINE static void fill_tall(qtri_job *job, qtri_triangle *triangle, qtri_fill_rows fill)
{
    qtri_rows rows;
    qtri_rows_init(&rows, triangle);
    for (;;) {
        int32_t row = rows.row;
        int32_t count = qtri_rows_next(&rows, triangle->spans);
        if (count == 0) {
            break;
        }
        fill_rows(job, triangle->spans, row, count, fill);
    }
}

/* Apart from that, too: what it keeps is not beneath fill_tall. */
QTRI_NOINLINE static void fill_short(qtri_job *job, const qtri_triangle *triangle,
                                     qtri_fill_rows fill)
{
    fill_rows(job, triangle->spans, triangle->row, triangle->end - triangle->row, fill);
}

void qtri_triangle_fill(qtri_job *job, qtri_triangle *triangle, qtri_fill_rows fill)
{
    qtri_list_flush(job->raster);
    if (QTRI_WITH_FAST_PATHS && triangle->is_short) {
        fill_short(job, triangle, fill);
    } else {
        fill_tall(job, triangle, fill);
    }
}

void qtri_triangle_draw(const qtri_raster *raster, qtri_triangle *triangle,
                        const qtri_attributes v[3])
{
    if (raster->route != NULL) {
        raster->route(raster, triangle, v);
    } else {
        qtri_triangle_draw_plain(raster, triangle, v);
    }
}

void qtri_triangle_draw_plain(const qtri_raster *raster, qtri_triangle *triangle,
                              const qtri_attributes v[3])
{
    qtri_job job;
    if (raster->samples != NULL) {
        raster->samples->draw(raster, triangle, v);
        return;
    }
    qtri_triangle_fill(&job, triangle, qtri_job_init(&job, raster, triangle, v));
}

static void attributes_from_screen(qtri_attributes *out, const qtri_screen_vertex *v,
                                   const qtri_raster *raster)
{
    const uint32_t farthest = (uint32_t)65535 << 16;
    out->depth_16p16 = v->depth_16p16 < farthest ? v->depth_16p16 : farthest;
    uint32_t mantissa = v->inv_w_q31 | (v->inv_w_q31 == 0);
    int32_t zeros = qtri_clz32(mantissa);
    out->inv_w_q31 = mantissa << zeros >> 1;
    out->inv_w_exponent = qtri_saturate32((int64_t)v->inv_w_exponent - zeros);
    qtri_channels color = qtri_raster_channels(raster, v->color_8p16);
    for (int i = 0; i < 3; i++) {
        out->color[i] = color.c[i];
    }
    out->u_q32 = v->u_q32;
    out->v_q32 = v->v_q32;
    out->rest[0] = 0;
    out->rest[1] = 0;
}

/* The same as vertices of a mesh are kept: of exponents only what is near the first counts. */
static void vertex_from_attributes(qtri_vertex *out, const qtri_screen_point *at,
                                   const qtri_attributes *v, int32_t first_exponent)
{
    const int64_t more = (int64_t)v->inv_w_exponent - first_exponent;
    out->at = *at;
    out->depth_16p8 =
        (v->depth_16p16 & ~0xFFu) | (more < -2 || more > 2 ? 0u : (uint32_t)(more + 8));
    out->inv_w = v->inv_w_q31;
}

QTRI_NOINLINE static void draw_large(const qtri_raster *raster, const qtri_screen_point p[3],
                                     const qtri_attributes attributes[3], int64_t area)
{
    qtri_triangle triangle;
    triangle.p[0] = &p[0];
    triangle.p[1] = &p[1];
    triangle.p[2] = &p[2];
    triangle.tinted = false;
    triangle.area = area;
    if (qtri_triangle_begin(raster, &triangle)) {
        qtri_triangle_draw(raster, &triangle, attributes);
    }
}

static void draw_small(const qtri_raster *raster, qtri_place *place,
                       const qtri_vertex *const vertex[3], const qtri_attributes attributes[3])
{
    qtri_small_values values;
    qtri_small_set_values(&values, raster, attributes);
    qtri_small_draw_values(raster, place, vertex, &values);
}

void qtri_raster_draw(const qtri_raster *raster, const qtri_screen_vertex v[3])
{
    qtri_screen_point p[3];
    qtri_attributes attributes[3];
    qtri_vertex vertex[3];
    qtri_place place;
    uint8_t spans[QTRI_PLACE_SPANS];
    for (int i = 0; i < 3; i++) {
        p[i].x_24p8 = qtri_hold32(v[i].x_24p8, -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
        p[i].y_24p8 = qtri_hold32(v[i].y_24p8, -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
    }
    const int64_t area = qtri_triangle_area(&p[0], &p[1], &p[2]);
    if (area == 0 || qtri_is_culled(raster->cull, area)) {
        return;
    }
    for (int i = 0; i < 3; i++) {
        attributes_from_screen(&attributes[i], &v[i], raster);
        vertex_from_attributes(&vertex[i], &p[i], &attributes[i], attributes[0].inv_w_exponent);
    }
    const qtri_vertex *const corner[3] = {&vertex[0], &vertex[1], &vertex[2]};
    if (!qtri_takes_small(raster)) {
        if (qtri_by_vertex(raster) != NULL) {
            const uint32_t index[3] = {0, 1, 2};
            qtri_by_vertex(raster)->set(attributes, raster, index);
        }
        draw_large(raster, p, attributes, area);
        return;
    }
    switch (qtri_place_triangle(&place, spans, raster, corner[0], corner[1], corner[2])) {
    case QTRI_PLACED_SMALL:
        draw_small(raster, &place, corner, attributes);
        qtri_list_flush(raster);
        break;
    case QTRI_PLACED_LARGE:
        draw_large(raster, p, attributes, area);
        break;
    default:
        break;
    }
}

void qtri_raster_triangle(const qtri_surface *surface, const qtri_material *material,
                          const qtri_screen_vertex v[3])
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_ASSERT(v != NULL);
    qtri_raster raster;
    qtri_batch batch;
    qtri_raster_init(&raster, surface, material, &batch);
    qtri_raster_draw(&raster, v);
}
