#include "span.h"

#include "packed.h"

/* A plane's step in the attribute's unit times 2^up, rounded. */
static uint32_t plane_step(uint64_t dx, int32_t up)
{
    int32_t down = 16 - up; /* -4..28: what is shifted in does not get to the low 32 bits */
    return (uint32_t)(down > 0 ? ((dx >> (down - 1)) + 1) >> 1 : dx << -down);
}

/* Apart: what it needs in registers would be in the way of textures. */
QTRI_NOINLINE static void linear_colors(const qtri_job *job, qtri_run *run, int32_t y)
{
    const int32_t dx = run->x - job->anchor_x;
    const int32_t dy = y - job->anchor_y;
    if (qtri_job_is_packed(job)) {
        run->value[0] = job->tiny ? qtri_packed_tiny(job, dx - run->phase, dy)
                                  : qtri_packed_start(job, dx - run->phase, dy);
        return;
    }
    for (int i = qtri_job_first(job); i < QTRI_U; i++) {
        run->value[i] = qtri_ramp_at(&job->attribute[i].ramp, dx, dy);
        run->step[i] = job->attribute[i].ramp.dx;
    }
}

/* A run's texture coordinate i. row: its plane at column 0, with its bias. */
static inline void linear_coordinate(const qtri_job *job, qtri_run *run, int i, uint64_t row)
{
    const qtri_plane *plane = &job->attribute[QTRI_U + i].plane;
    uint64_t value = qtri_plane_column(row, plane->dx, run->x - run->phase);
    run->value[QTRI_U + i] = qtri_run_scaled((uint32_t)qtri_plane_floor(value), job->axis[i].up) +
                             (uint32_t)run->phase * run->step[QTRI_U + i];
}

/*
 * Texture coordinates linear on the screen fill their 32 bits, so that steps lose what a long run
 * would show. They start anew from their planes: every 64 pixels, as packed colours do, or, where
 * copied texels leave 2^-17 of a texel and less to the last bit, every 512.
 */
void qtri_fill_spans(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count)
{
    const qtri_raster *raster = job->raster;
    const int32_t length = qtri_job_copies_texels(job) ? 512 : QTRI_PACKED_RUN;
    const bool textured = qtri_raster_texture(raster) != NULL;
    uint64_t uv[2];
    qtri_run run;
    qtri_run_set_row(&run, raster, row);
    for (int i = 0; textured && i < 2; i++) {
        const qtri_texel_axis *axis = &job->axis[i];
        const qtri_plane *plane = &job->attribute[QTRI_U + i].plane;
        uv[i] = qtri_plane_row(plane, row) + ((uint64_t)axis->bias << 16);
        run.step[QTRI_U + i] = plane_step(plane->dx, axis->up);
    }
    for (; count > 0; count--, spans++, row++) {
        int32_t rest = qtri_span_clip(spans, &raster->bounds, &run.x);
        run.phase = (run.x - spans->left) & (length - 1);
        while (rest > 0) {
            run.count = qtri_least32(length - run.phase, rest);
            if (qtri_job_is_smooth(job)) {
                linear_colors(job, &run, row);
            }
            if (textured) {
                linear_coordinate(job, &run, 0, uv[0]);
                linear_coordinate(job, &run, 1, uv[1]);
            }
            qtri_run_draw(job, &run, row);
            rest -= run.count;
            run.x += run.count;
            run.phase = 0;
        }
        if (textured) {
            uv[0] += job->attribute[QTRI_U].plane.dy;
            uv[1] += job->attribute[QTRI_U + 1].plane.dy;
        }
        qtri_run_next_row(&run, raster->surface);
    }
}
