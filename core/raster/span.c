#include "span.h"

#include "fill.h"
#include "packed.h"

/* A plane's step in the attribute's unit times 2^up, rounded. */
static uint32_t plane_step(uint64_t dx, int32_t up)
{
    int32_t down = 16 - up; /* -4..46 */
    return (uint32_t)(down > 0 ? qtri_wrap64(dx + ((uint64_t)1 << (down - 1))) >> down
                               : qtri_wrap64(dx << -down));
}

static void linear_colors(const qtri_job *job, int32_t y, qtri_run *run)
{
    int32_t dx = run->x - job->anchor_x;
    int32_t dy = y - job->anchor_y;
    for (int i = 0; i < 3; i++) {
        run->color[i] = qtri_ramp_at(&job->color.ramp[i], dx, dy);
        run->color_step[i] = job->color.ramp[i].dx;
    }
}

/* Everything is linear: one run, of which the place is known, and uv. */
static inline void linear_run(const qtri_job *job, int32_t y, qtri_run *run)
{
    if (qtri_job_is_smooth(job)) {
        linear_colors(job, y, run);
    }
    run->z = qtri_ramp_at(&job->depth, run->x - job->anchor_x, y - job->anchor_y);
    job->draw_run(job, run);
}

/* Linear colours in RGB565: they start anew every QTRI_PACKED_RUN pixels, see packed.h. */
static void packed_span(const qtri_job *job, qtri_run *run, int32_t y, int32_t left, int32_t end)
{
    int32_t dy = y - job->anchor_y;
    run->is_packed = true;
    while (run->x < end) {
        int32_t dx = run->x - job->anchor_x;
        int32_t rest = end - run->x;
        int32_t phase = job->tiny ? 0 : (run->x - left) % QTRI_PACKED_RUN;
        run->count = job->tiny || rest < QTRI_PACKED_RUN - phase ? rest : QTRI_PACKED_RUN - phase;
        run->z = qtri_ramp_at(&job->depth, dx, dy);
        run->phase = phase;
        run->packed =
            job->tiny ? qtri_packed_tiny(job, dx, dy) : qtri_packed_start(job, dx - phase, dy);
        qtri_run_generic(job, run);
        run->x += run->count;
    }
}

/* The pixels x0..x1-1 of row y, inside the bounds. */
static void draw_span(const qtri_job *job, int32_t y, const qtri_span *span, int32_t x0, int32_t x1)
{
    const qtri_surface *surface = job->raster->surface;
    ptrdiff_t row = y - surface->first_row;
    qtri_run run;
    run.x = x0;
    run.is_packed = false;
    run.pixels = surface->pixels + row * surface->pitch;
    run.depths =
        job->raster->compare == QTRI_DEPTH_OFF ? NULL : surface->depth + row * surface->depth_pitch;
    if (qtri_job_is_perspective(job)) {
        qtri_span_perspective(job, &run, y, span, x0, x1);
    } else if (qtri_job_is_smooth(job) && qtri_format_of(surface) == QTRI_RGB565) {
        packed_span(job, &run, y, span->left, x1);
    } else {
        run.count = x1 - x0;
        linear_run(job, y, &run);
    }
}

void qtri_fill_spans(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count)
{
    for (; count > 0; count--, row++, spans++) {
        int32_t x;
        int32_t pixels = qtri_span_clip(spans, &job->raster->bounds, &x);
        if (pixels > 0) {
            draw_span(job, row, spans, x, x + pixels);
        }
    }
}

/* Axis i at column x of a row, `row` being its plane at column 0 with the bias. */
static inline uint32_t linear_coordinate(const qtri_job *job, int i, uint64_t row, int32_t x)
{
    uint32_t value = (uint32_t)qtri_plane_floor(qtri_plane_column(row, job->uv[i].dx, x));
    return qtri_run_scaled(value, job->uv_up[i]);
}

/*
 * Texture coordinates linear on the screen: they fill their 32 bits, so that steps lose what a long
 * run would show. They start anew from their planes: every 64 pixels, or, where copied texels leave
 * 2^-17 of a texel and less to the last bit, every 512.
 */
void qtri_fill_textured(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count)
{
    const qtri_raster *raster = job->raster;
    const qtri_surface *surface = raster->surface;
    const int32_t length = qtri_job_copies_texels(job) ? 512 : 64;
    const bool tested = raster->compare != QTRI_DEPTH_OFF;
    const qtri_lines lines = qtri_lines_at(surface, row);
    uint64_t uv[2];
    qtri_run run;
    run.pixels = lines.pixels;
    run.depths = tested ? lines.depths : NULL;
    run.is_packed = false;
    for (int i = 0; i < 2; i++) {
        uv[i] = qtri_plane_row(&job->uv[i], row) + ((uint64_t)job->axis[i].bias << 16);
        run.uv_step[i] = plane_step(job->uv[i].dx, job->uv_up[i]);
    }
    for (const qtri_span *end = spans + count; spans < end; spans++, row++) {
        int32_t x0;
        int32_t rest = qtri_span_clip(spans, &raster->bounds, &x0);
        int32_t skip = (x0 - spans->left) & (length - 1);
        for (run.x = x0; rest > 0; run.x += run.count) {
            int32_t x = run.x - skip;
            run.count = length - skip < rest ? length - skip : rest;
            run.uv[0] = linear_coordinate(job, 0, uv[0], x) + (uint32_t)skip * run.uv_step[0];
            run.uv[1] = linear_coordinate(job, 1, uv[1], x) + (uint32_t)skip * run.uv_step[1];
            linear_run(job, row, &run);
            rest -= run.count;
            skip = 0;
        }
        uv[0] += job->uv[0].dy;
        uv[1] += job->uv[1].dy;
        run.pixels += surface->pitch;
        if (tested) {
            run.depths += surface->depth_pitch;
        }
    }
}
