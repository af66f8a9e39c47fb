/* SPDX-License-Identifier: MIT */
#include "line.h"

#include "../bits/bits.h"
#include "checked_material.h"
#include "large_setup.h"
#include "line_run.h"

void qtri_line_job_init(qtri_line_job *job, const qtri_surface *surface,
                        const qtri_material *material, qtri_stroke_target *to)
{
    (void)qtri_stroke_target_init(to, surface, material, qtri_line_pipelines, 255, false);
    const qtri_rect *bounds = &to->state.bounds;
    job->to = to;
    job->draw = to->state.pipeline->line;
    if (job->draw == NULL || (qtri_tests_depth(&to->state.options) &&
                              to->state.surface->pitch != to->state.depth_pitch)) {
        job->draw = qtri_line_any.line; /* nothing is drawn, or pixels and depths are not paired */
    }
    job->left_24p8 = bounds->x0 * 256;
    job->top_24p8 = bounds->y0 * 256;
    job->width_24p8 = (uint32_t)(bounds->x1 - bounds->x0) * 256;
    job->height_24p8 = (uint32_t)(bounds->y1 - bounds->y0) * 256;
    job->depth_mask = ~0xFFu;
    switch (qtri_kind_of(&to->state.options)) {
    case QTRI_IN_565:
        job->packing = QTRI_PACK_565;
        break;
    case QTRI_IN_GRAY:
        job->packing = QTRI_PACK_ONE;
        break;
    default:
        job->packing = QTRI_PACK_888;
        break;
    }
}

void qtri_line_end(qtri_vertex *end, qtri_line_color color, const qtri_screen_vertex *v)
{
    const uint32_t farthest = (uint32_t)65535 << 16;
    end->at.x_24p8 = qtri_hold32(v->x_24p8, -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
    end->at.y_24p8 = qtri_hold32(v->y_24p8, -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
    end->depth_16p8 = v->depth_16p16 < farthest ? v->depth_16p16 : farthest;
    for (int i = 0; i < 3; i++) {
        color[i] = qtri_hold32(v->color_8p16[i], 0, 255 << 16);
    }
}

void qtri_raster_line(const qtri_surface *surface, const qtri_material *material,
                      const qtri_screen_vertex v[2])
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_ASSERT(v != NULL);
    qtri_line_job job;
    qtri_stroke_target to;
    qtri_vertex end[2];
    qtri_line_color color[2];
    qtri_line_job_init(&job, surface, material, &to);
    job.depth_mask = UINT32_MAX;
    qtri_line_end(&end[0], color[0], &v[0]);
    qtri_line_end(&end[1], color[1], &v[1]);
    job.draw(&job, &end[0], &end[1], (const qtri_line_color *)color);
}
