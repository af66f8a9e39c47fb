/* SPDX-License-Identifier: MIT */
/* The generic pipelines of strokes' spans and of lines: options are read for every pixel. */
#define QTRI_PIPELINE_IS_ANY
#define QTRI_PIPELINE_IS_ANY_BY_KIND
#define QTRI_PIXEL_IS_ALONE
#include "line_path.h"

static qtri_options options_of(const qtri_draw_state *state, bool is_lit)
{
    qtri_options o = state->options;
    o.texel = QTRI_NO_TEXEL; /* constants: the compiler removes what these options need */
    o.shade = is_lit ? QTRI_LIGHT : QTRI_FLAT;
    o.fragment = NULL;
    o.vertex_alpha = o.bilinear = o.key = o.alpha_test = o.large_texture = 0;
    o.asks = (uint16_t)qtri_find_kind(&o);
    return o;
}

static void any_span(const qtri_stroke_span *span)
{
    const qtri_options o = options_of(span->state, false);
    qtri_stroke_span_draw(&o, span);
}

static void any_run(const qtri_line_run *run)
{
    const qtri_options o = options_of(run->state, run->is_lit);
    qtri_line_run_draw(&o, run);
}

static void any_line(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                     const qtri_line_color *color)
{
    qtri_line_draw(job, a, b, color, any_run);
}

const qtri_pipeline qtri_stroke_any = {.options = {.format = QTRI_ANY}, .span = any_span};
const qtri_pipeline qtri_line_any = {.options = {.format = QTRI_ANY}, .line = any_line};
