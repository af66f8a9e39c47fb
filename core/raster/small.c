/* SPDX-License-Identifier: MIT */
#include "small.h"

#include "../geometry/projector.h"
#include "list_values.h"
#include "sampling.h"
#include "setup.h"
#include "textured.h"

/*
 * Whether rows have six pixels in the mean: then the longest has twice that, to what is cut off at
 * its ends.
 */
static bool rows_are_long(const qtri_place *p)
{
    const int32_t height = qtri_greatest_from_0(p->dy1, p->dy2) - qtri_least_from_0(p->dy1, p->dy2);
    return p->size >> 10 >= 3 * (uint32_t)height;
}

/* A function of its own, so that its stack is free again. */
QTRI_NOINLINE static void set_job(qtri_job *job, const qtri_raster *raster,
                                  const qtri_list_triangle *t)
{
    qtri_list_values v;
    qtri_list_begin(&v, raster, t);
    job->raster = raster;
    job->tinted = false;
    job->perspective = false;
    job->packed = false;
    job->copies = false;
    job->shaded = false;
    job->clamps_depth = false;
    job->cut = t->place->cut;
    job->first = QTRI_U;
    job->end = QTRI_U;
    job->anchor_x = t->place->column;
    job->anchor_y = t->place->row + raster->surface->first_row;
    qtri_list_set_depth(&job->depth, &v);
    job->pixel = qtri_raster_stored(raster, qtri_list_flat_color(raster, t));
}

QTRI_NOINLINE static void draw_rows(const qtri_raster *raster, const qtri_list_triangle *t)
{
    qtri_job job;
    set_job(&job, raster, t);
    qtri_list_flush(raster);
    int32_t row = job.anchor_y;
    const uint8_t *span = t->place->first;
    while (span[0] != QTRI_PLACE_STOP) {
        qtri_span spans[QTRI_ROWS_AHEAD];
        int32_t count = 0;
        do {
            spans[count].left = (int16_t)(span[0] + job.anchor_x);
            spans[count].right = (int16_t)(span[1] + job.anchor_x);
            span += 2;
            count++;
        } while (span[0] != QTRI_PLACE_STOP && count < QTRI_ROWS_AHEAD);
        raster->fill_flat(&job, spans, row, count);
        row += count;
    }
}

void qtri_small_draw(const qtri_raster *raster, const qtri_list_triangle *t)
{
    if (raster->samples != NULL) {
        raster->samples->draw_small(raster, t);
    } else if (raster->texture == NULL && rows_are_long(t->place) &&
               !(raster->smooth && qtri_list_varies(t))) {
        draw_rows(raster, t);
    } else {
        qtri_list_draw(raster, t);
    }
}

void qtri_small_set_values(qtri_small_values *values, const qtri_raster *raster,
                           const qtri_attributes attributes[3])
{
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            values->color[i][k] = attributes[i].color[k];
        }
    }
    if (raster->texture != NULL) {
        const int64_t u_q32[3] = {attributes[0].u_q32, attributes[1].u_q32, attributes[2].u_q32};
        const int64_t v_q32[3] = {attributes[0].v_q32, attributes[1].v_q32, attributes[2].v_q32};
        qtri_coordinates_set(&values->uv[0], u_q32);
        qtri_coordinates_set(&values->uv[1], v_q32);
    }
}

void qtri_small_draw_values(const qtri_raster *raster, qtri_place *place,
                            const qtri_vertex *const v[3], const qtri_small_values *values)
{
    const qtri_list_triangle t = {
        place, {v[0], v[1], v[2]}, values->color, QTRI_VERTEX_UNLIT, values->uv};
    qtri_small_draw(raster, &t);
}
