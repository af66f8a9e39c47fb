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

