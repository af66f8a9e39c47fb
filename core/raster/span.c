/* SPDX-License-Identifier: MIT */
/*
 * Rows of large triangles by stages: chunks of up to 32 pixels, counted from the span's left end,
 * whatever of them a scissor or a band leaves. So pixels do not depend on either.
 */
#include "span.h"

#include "loop.h"
#include "packed.h"

/* Colours without texture into the batch: `count` from pixel x of the row on. */
static void interpolate_colors(qtri_scanline *row, int32_t x, int32_t count)
{
    const qtri_job *job = row->job;
    const qtri_raster *raster = job->raster;
    uint32_t *color = raster->batch->color;
    if (job->packed) {
        qtri_packed_colors(color, job, x, row->y, (x - row->left) & (QTRI_PACKED_RUN - 1), count);
        return;
    }
    while (count > 0) {
        qtri_curve curve[3];
        const int32_t some = job->interpolate(row, x, count, job->first, QTRI_U, curve);
        raster->format->colors->smooth(color, curve, some);
        color += some;
        x += some;
        count -= some;
    }
}

/* Stored pixels into the batch for a chunk of `count` pixels at x; the mask of those drawn. */
static uint32_t make_pixels(qtri_scanline *row, int32_t x, int32_t count, uint32_t mask)
{
    const qtri_raster *raster = row->job->raster;
    if (raster->texture != NULL) {
        mask = raster->texturing->color_chunk(row, x, count, mask);
    } else {
        interpolate_colors(row, x, count);
    }
    if (raster->format->encode != NULL && mask != 0) {
        raster->format->encode(raster->batch->color, count);
    }
    return mask;
}

/*
 * Chunk by chunk: `from` is the first pixel of one that is drawn, of those that are computed x.
 */
static void draw_row(qtri_scanline *row)
{
    const qtri_job *job = row->job;
    const qtri_raster *raster = job->raster;
    const qtri_pixels *memory = raster->format->pixels;
    const qtri_depth_test test = raster->depth.test;
    const uint32_t inverted = raster->depth.inverted ? UINT32_MAX : 0;
    int32_t from = row->x0;
    int32_t x = row->left + ((from - row->left) & -QTRI_BATCH);
    uint8_t *pixels = row->pixels + (ptrdiff_t)from * memory->bytes;
    uint16_t *depths = NULL;
    uint32_t z = 0;
    if (row->depths != NULL) {
        depths = row->depths + from;
        z = qtri_ramp_at(&job->depth, from - job->anchor_x, row->y - job->anchor_y);
    }
    for (;;) {
        const int32_t count = qtri_least32(x + QTRI_BATCH, row->x1) - from;
        uint32_t mask = qtri_mask_of(count);
        if (test != NULL) {
            mask &= test(depths, z, job->depth.dx, count) ^ inverted;
        }
        if (mask != 0 && job->first == job->end) {
            memory->fill(pixels, job->pixel, mask, count);
        } else if (mask != 0) {
            const int32_t whole = qtri_least32(QTRI_BATCH, row->right - x);
            const int32_t after = whole - (from - x) - count;
            mask = make_pixels(row, x, whole, mask << after) >> after;
            memory->store(pixels, raster->batch->color + (from - x), mask, count);
        }
        if (raster->depth.write && mask != 0) {
            qtri_depth_write(depths, z, job->depth.dx, mask, count);
        }
        x += QTRI_BATCH;
        if (x >= row->x1) {
            return;
        }
        from = x;
        pixels += (ptrdiff_t)count * memory->bytes;
        if (depths != NULL) {
            depths += count;
            z += (uint32_t)count * job->depth.dx;
        }
    }
}

/* The same for texels that become pixels as they are, where there is a loop for that. */
static void copy_row(qtri_scanline *row)
{
    const qtri_job *job = row->job;
    qtri_run run;
    run.pixels = row->pixels;
    run.depths = row->depths;
    for (int32_t x = row->x0; x < row->x1; x += run.count) {
        qtri_curve uv[2];
        const int32_t end = row->level ? row->x1 : qtri_least32(qtri_run_end(row, x), row->x1);
        (void)qtri_interpolate_linear(row, x, end - x, QTRI_U, QTRI_ATTRIBUTES, uv);
        run.x = x;
        run.count = end - x;
        run.z = qtri_ramp_at(&job->depth, x - job->anchor_x, row->y - job->anchor_y);
        for (int i = 0; i < 2; i++) {
            run.value[i] = uv[i].at;
            run.step[i] = uv[i].step;
        }
        job->raster->copy_run(job, &run);
    }
}

/* The same along curves: block by block, from the start of the chunk on that x0 lies in. */
static void copy_bent_row(qtri_scanline *row)
{
    const qtri_job *job = row->job;
    qtri_run run;
    run.pixels = row->pixels;
    run.depths = row->depths;
    for (int32_t x = row->left + ((row->x0 - row->left) & -QTRI_BATCH); x < row->x1;) {
        qtri_curve uv[2];
        const int32_t length = job->interpolate(row, x, QTRI_BATCH, QTRI_U, QTRI_ATTRIBUTES, uv);
        const int32_t skip = qtri_greatest32(row->x0 - x, 0);
        run.count = qtri_least32(length, row->x1 - x) - skip;
        if (run.count > 0) {
            run.x = x + skip;
            run.z = qtri_ramp_at(&job->depth, run.x - job->anchor_x, row->y - job->anchor_y);
            job->raster->copy_bent(job, &run, uv, skip);
        }
        x += length;
    }
}

/* Of texture coordinates that are linear on the screen. */
static bool has_planes(const qtri_job *job)
{
    return job->interpolate == qtri_interpolate_linear && job->end == QTRI_ATTRIBUTES;
}

static void begin(qtri_scanline *row, const qtri_job *job, int32_t y)
{
    const qtri_raster *raster = job->raster;
    row->job = job;
    row->y = y;
    row->pixels = qtri_pixels_at(raster->surface, y);
    row->depths = raster->compare != QTRI_DEPTH_OFF ? qtri_depths_at(raster->surface, y) : NULL;
    row->level = false;
    if (job->perspective) {
        qtri_perspective_begin(row);
        return;
    }
    if (has_planes(job)) {
        qtri_linear_begin(row);
    }
}

static void go_on(qtri_scanline *row)
{
    const qtri_job *job = row->job;
    const qtri_surface *surface = job->raster->surface;
    row->y++;
    row->pixels += surface->pitch;
    if (row->depths != NULL) {
        row->depths += surface->depth_pitch;
    }
    for (int i = 0; i < 2 && has_planes(job); i++) {
        // NOLINTNEXTLINE(clang-analyzer-core.uninitialized.Assign): as qtri_linear_begin set it
        row->by.plane[i] += job->attribute[QTRI_U + i].plane.dy;
    }
}

void qtri_span_fill(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count)
{
    const qtri_rect *bounds = &job->raster->bounds;
    const bool copies = job->copies && job->raster->copy_run != NULL;
    qtri_scanline r;
    for (begin(&r, job, row); count > 0; count--, spans++, go_on(&r)) {
        const int32_t pixels = qtri_span_clip(spans, bounds, &r.x0);
        if (pixels <= 0) {
            continue;
        }
        r.x1 = r.x0 + pixels;
        r.left = spans->left;
        r.right = spans->right;
        r.run = INT32_MIN;
        if (job->perspective) {
            qtri_perspective_row(&r);
        }
        if (copies && (has_planes(job) || r.level)) {
            copy_row(&r);
        } else if (copies) {
            copy_bent_row(&r);
        } else {
            draw_row(&r);
        }
    }
}
