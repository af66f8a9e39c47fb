/* SPDX-License-Identifier: MIT */
/*
 * The pipelines of lines and of spans of strokes: on RGB565, in either byte order, and GRAY8, with
 * linear16 depth or without; their lists, and what chooses from that of lines.
 */
#include "checked_material.h"
#include "large_setup.h"
#include "line_path.h"

/* Fast case, inlined for `o`: a short line, lit by the table, as most of a wireframe. `draw` draws
   others. */
QTRI_BODY void draw_lit(const qtri_options *o, const qtri_line_job *job, const qtri_vertex *a,
                        const qtri_vertex *b, const qtri_line_color *color, qtri_line_runs draw)
{
    qtri_line_path l;
    qtri_line_path_init(&l, a, b);
    if (color != NULL || (uint32_t)(l.count - 1) >= QTRI_LINE_CHUNK) {
        qtri_line_draw(job, a, b, color, draw);
        return;
    }
    if (!job->to->state.has_table) {
        (void)qtri_line_has_table(job); /* which makes it */
    }
    qtri_line_run run;
    qtri_divider by;
    qtri_line_walk_short(&run.walk, &l);
    run.count = l.count;
    if (!qtri_line_is_inside(job, &l)) {
        const qtri_line_path path = l; /* copies: these need not be in memory */
        qtri_line_walk first = run.walk;
        run.count = qtri_line_clip_short(&first, job, &path);
        run.walk = first;
        if (run.count <= 0) {
            return;
        }
    }
    qtri_line_run_depth(&run, &by, job, &l, qtri_needs_depth(o));
    qtri_line_run_light(&run, &l, &by);
    qtri_line_run_place(&run, job, &l, 0);
    qtri_line_run_draw(o, &run);
}

/* A pipeline of lines by draw_lit(). */
#define LIT_LINE(name, ...)                                                                        \
    static void name##_run(const qtri_line_run *run)                                               \
    {                                                                                              \
        static const qtri_options options = {__VA_ARGS__};                                         \
        qtri_line_run_draw(&options, run);                                                         \
    }                                                                                              \
    static void name##_line(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,  \
                            const qtri_line_color *color)                                          \
    {                                                                                              \
        static const qtri_options lit = {__VA_ARGS__, .shade = QTRI_LIGHT};                        \
        draw_lit(&lit, job, a, b, color, name##_run);                                              \
    }                                                                                              \
    static const qtri_pipeline name = {.options = {__VA_ARGS__}, .line = name##_line};

LIT_LINE(line_less, .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS)
LIT_LINE(line_over, .format = QTRI_RGB565)

/* With depth: any comparison, written or read only. */
#define DEPTH .depth = QTRI_LINEAR16, .compare = QTRI_ANY, .read_only = QTRI_ANY

/* A pipeline of which only the loop over pixels is its own: 140 to 520 bytes each at -Os. */
#define LINE(name, ...)                                                                            \
    static void name##_run(const qtri_line_run *run)                                               \
    {                                                                                              \
        static const qtri_options options = {__VA_ARGS__};                                         \
        static const qtri_options lit = {__VA_ARGS__, .shade = QTRI_LIGHT};                        \
        if (qtri_uses_table(&lit) && run->is_lit) {                                                \
            qtri_line_run_draw(&lit, run);                                                         \
        } else {                                                                                   \
            qtri_line_run_draw(&options, run);                                                     \
        }                                                                                          \
    }                                                                                              \
    static void name##_line(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,  \
                            const qtri_line_color *color)                                          \
    {                                                                                              \
        qtri_line_draw(job, a, b, color, name##_run);                                              \
    }                                                                                              \
    static const qtri_pipeline name = {.options = {__VA_ARGS__}, .line = name##_line};

LINE(line_depth, .format = QTRI_RGB565, DEPTH)
LINE(line_swapped, .format = QTRI_RGB565_SWAPPED, DEPTH)
LINE(line_swapped_over, .format = QTRI_RGB565_SWAPPED)
LINE(line_gray, .format = QTRI_GRAY8, DEPTH)
LINE(line_gray_over, .format = QTRI_GRAY8)

const qtri_pipeline *const qtri_line_pipelines[] = {
    &line_less, &line_over,      &line_depth,    &line_swapped, &line_swapped_over,
    &line_gray, &line_gray_over, &qtri_line_any, NULL};

/* A pipeline of spans: 500 to 800 bytes each at -Os, for a third of the generic one's time. */
#define SPAN(name, ...)                                                                            \
    static void name##_draw(const qtri_stroke_span *span)                                          \
    {                                                                                              \
        static const qtri_options options = {__VA_ARGS__};                                         \
        qtri_stroke_span_draw(&options, span);                                                     \
    }                                                                                              \
    static const qtri_pipeline name = {.options = {__VA_ARGS__}, .span = name##_draw};

SPAN(span_depth, .format = QTRI_RGB565, DEPTH, .covered = 1)
SPAN(span_hard, .format = QTRI_RGB565, DEPTH)
SPAN(span_over, .format = QTRI_RGB565, .covered = 1)
SPAN(span_swapped, .format = QTRI_RGB565_SWAPPED, DEPTH, .covered = 1)
SPAN(span_gray, .format = QTRI_GRAY8, DEPTH, .covered = 1)

const qtri_pipeline *const qtri_stroke_pipelines[] = {
    &span_depth, &span_hard, &span_over, &span_swapped, &span_gray, &qtri_stroke_any, NULL};

/* The choice of a line's pipeline: calls lead from here to line.c and never back. */

void qtri_line_job_init(qtri_line_job *job, const qtri_surface *surface,
                        const qtri_material *material, qtri_stroke_target *to)
{
    (void)qtri_stroke_target_init(to, surface, material, qtri_line_pipelines, 255, false);
    const qtri_rect *bounds = &to->state.bounds;
    job->to = to;
    job->draw = to->state.pipeline->line;
    if (job->draw == NULL ||
        (qtri_is_paired(&to->state.options) && to->state.surface->pitch != to->state.depth_pitch)) {
        job->draw = qtri_line_any.line; /* nothing is drawn, or pixels and depths are not paired */
    }
    job->left_24p8 = bounds->x0 * 256;
    job->top_24p8 = bounds->y0 * 256;
    job->width_24p8 = (uint32_t)(bounds->x1 - bounds->x0) * 256;
    job->height_24p8 = (uint32_t)(bounds->y1 - bounds->y0) * 256;
    job->depth_mask = ~0xFFu;
    const qtri_color_kind kind = qtri_kind_of(&to->state.options);
    job->packing = kind == QTRI_IN_565    ? &qtri_packing_565
                   : kind == QTRI_IN_GRAY ? &qtri_packing_gray
                   : kind == QTRI_IN_888  ? &qtri_packing_888
                                          : &qtri_packing_fine;
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
