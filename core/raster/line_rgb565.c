/* SPDX-License-Identifier: MIT */
/* Lines on RGB565, with linear16 depth and "less", or without depth; and the list of all lines. */
#include "line_path.h"

static const qtri_options less = {
    .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS};
static const qtri_options less_lit = {
    .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS, .shade = QTRI_LIGHT};
static const qtri_options over = {.format = QTRI_RGB565};
static const qtri_options over_lit = {.format = QTRI_RGB565, .shade = QTRI_LIGHT};

static void draw_less(const qtri_line_run *run)
{
    qtri_line_run_draw(&less, run);
}

static void draw_over(const qtri_line_run *run)
{
    qtri_line_run_draw(&over, run);
}

static void line_less(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                      const qtri_line_color *color)
{
    qtri_line_draw_lit(&less_lit, job, a, b, color, draw_less);
}

static void line_over(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                      const qtri_line_color *color)
{
    qtri_line_draw_lit(&over_lit, job, a, b, color, draw_over);
}

static const qtri_pipeline pipeline_less = {
    .options = {.format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS},
    .line = line_less};
static const qtri_pipeline pipeline_over = {.options = {.format = QTRI_RGB565}, .line = line_over};

const qtri_pipeline *const qtri_line_pipelines[] = {&pipeline_less, &pipeline_over, &qtri_line_any,
                                                    NULL};
