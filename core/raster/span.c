/* SPDX-License-Identifier: MIT */
/*
 * Rows of large triangles by stages: chunks of up to 32 pixels, counted from the span's left end,
 * whatever of them a scissor or a band leaves. So pixels do not depend on either.
 */
#include "span.h"

#include "effect.h"
#include "linear.h"
#include "loop.h"
#include "packed.h"
#include "perspective_block.h"
#include "pixel_light.h"

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
    do {
        int32_t some = count;
        if (qtri_job_is_bent(job)) {
            some = qtri_interpolate_perspective(row, x, count, job->first, QTRI_U);
        }
        raster->units->smooth(color, &row->curve[job->first], some);
        color += some;
        x += some;
        count -= some;
    } while (count > 0);
}

/* Of a job that has one colour, or that is lit by pixel. */
static void make_plain(qtri_scanline *row, int32_t x, int32_t count)
{
    const qtri_raster *raster = row->job->raster;
    if (raster->by_pixel) {
        raster->lit->shade(row, x, count);
        return;
    }
    for (int32_t i = 0; i < count; i++) {
        raster->batch->color[i] = row->job->pixel;
    }
}

/* Stored pixels into the batch for a chunk of `count` pixels at x; the mask of those drawn. */
static uint32_t make_pixels(qtri_scanline *row, int32_t x, int32_t count, uint32_t mask)
{
    const qtri_raster *raster = row->job->raster;
    if (raster->texture != NULL) {
        mask = raster->texturing->color_chunk(row, x, count, mask);
    } else if (row->job->first == row->job->end) {
        make_plain(row, x, count);
    } else {
        interpolate_colors(row, x, count);
    }
    if (raster->format->encode != NULL && raster->effects == NULL && mask != 0) {
        raster->format->encode(raster->batch->color, count);
    }
    return mask;
}

/*
 * Fog and blend for colours of `count` pixels from x on, of depths z on, which are then stored; the
 * mask of them.
 */
QTRI_NOINLINE static uint32_t store_affected(const qtri_scanline *row, uint8_t *pixels,
                                             uint32_t *color, int32_t x, uint32_t z, uint32_t mask,
                                             int32_t count)
{
    const qtri_job *job = row->job;
    const qtri_raster *raster = job->raster;
    const int32_t first_row = raster->surface->first_row;
    qtri_ramp depth;
    qtri_fragments at;
    if (mask == 0) {
        return 0;
    }
    if (raster->effect_row != NULL && mask == qtri_mask_of(count)) {
        raster->effect_row(pixels, color, count, raster, z, job->depth.dx);
        return mask;
    }
    at.place = NULL;
    at.first = ((uint32_t)(row->y - first_row) << 16) + (uint32_t)x;
    at.depth = &depth;
    at.depths = NULL;
    if (raster->with_depth) {
        depth.origin = qtri_ramp_at(&job->depth, -job->anchor_x, first_row - job->anchor_y);
        depth.dx = job->depth.dx;
        depth.dy = job->depth.dy;
    }
    mask = raster->effects->fragments(raster, color, &at, mask, count);
    if (raster->format->encode != NULL) {
        raster->format->encode(color, count);
    }
    raster->format->pixels->store(pixels, color, mask, count);
    return mask;
}

/* Pixels of a row in one colour. */
static void fill_row(const qtri_scanline *row)
{
    const qtri_job *job = row->job;
    const qtri_raster *raster = job->raster;
    const qtri_pixels *memory = raster->format->pixels;
    const uint32_t inverted = raster->depth.inverted ? UINT32_MAX : 0;
    const uint32_t z_step = job->depth.dx;
    uint8_t *pixels = row->pixels + (ptrdiff_t)row->x0 * memory->bytes;
    uint16_t *depths = row->depths;
    uint32_t z = 0;
    int32_t rest = row->x1 - row->x0;
    if (depths != NULL) {
        depths += row->x0;
        z = qtri_ramp_at(&job->depth, row->x0 - job->anchor_x, row->y - job->anchor_y);
    }
    for (;;) {
        const int32_t count = qtri_least32(rest, QTRI_BATCH);
        uint32_t mask = qtri_mask_of(count);
        if (raster->depth.test != NULL) {
            mask &= raster->depth.test(depths, z, z_step, count) ^ inverted;
        }
        if (mask != 0) {
            memory->fill(pixels, job->pixel, mask, count);
            if (raster->depth.write) {
                qtri_depth_write(depths, z, z_step, mask, count);
            }
        }
        rest -= count;
        if (rest <= 0) {
            return;
        }
        pixels += QTRI_BATCH * memory->bytes;
        if (depths != NULL) {
            depths += QTRI_BATCH;
            z += QTRI_BATCH * z_step;
        }
    }
}

/*
 * The same of colours that vary: `from` is the first pixel of a chunk that is drawn, of those that
 * are computed x.
 */
static void draw_row(qtri_scanline *row)
{
    const qtri_job *job = row->job;
    const qtri_raster *raster = job->raster;
    const qtri_pixels *memory = raster->format->pixels;
    const uint32_t inverted = raster->depth.inverted ? UINT32_MAX : 0;
    const bool linear = !job->packed && (!qtri_job_is_bent(job) || row->level);
    int32_t from = row->x0;
    int32_t x = row->left + ((from - row->left) & -QTRI_BATCH);
    uint8_t *pixels = row->pixels + (ptrdiff_t)from * memory->bytes;
    uint16_t *depths = row->depths;
    uint32_t z = 0;
    if (raster->with_depth) {
        z = qtri_ramp_at(&job->depth, from - job->anchor_x, row->y - job->anchor_y);
    }
    if (depths != NULL) {
        depths += from;
    }
    if (linear) {
        qtri_linear_row(row, x);
    }
    for (;;) {
        const int32_t count = qtri_least32(x + QTRI_BATCH, row->x1) - from;
        uint32_t mask = qtri_mask_of(count);
        if (raster->depth.test != NULL) {
            mask &= raster->depth.test(depths, z, job->depth.dx, count) ^ inverted;
        }
        if (mask != 0) {
            uint32_t *color = raster->batch->color + (from - x);
            const int32_t whole = qtri_least32(QTRI_BATCH, row->right - x);
            const int32_t after = whole - (from - x) - count;
            mask = make_pixels(row, x, whole, mask << after) >> after;
            if (raster->effects != NULL) {
                mask = store_affected(row, pixels, color, from, z, mask, count);
            } else {
                memory->store(pixels, color, mask, count);
            }
            if (raster->depth.write && mask != 0) {
                qtri_depth_write(depths, z, job->depth.dx, mask, count);
            }
        }
        x += QTRI_BATCH;
        if (x >= row->x1) {
            return;
        }
        from = x;
        if (linear) {
            qtri_linear_next(row, x);
        }
        pixels += (ptrdiff_t)count * memory->bytes;
        z += (uint32_t)count * job->depth.dx;
        if (depths != NULL) {
            depths += count;
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
        const int32_t end = qtri_least32(qtri_linear_texels(row, x), row->x1);
        run.x = x;
        run.count = end - x;
        run.z = qtri_ramp_at(&job->depth, x - job->anchor_x, row->y - job->anchor_y);
        for (int i = 0; i < 2; i++) {
            run.value[i] = row->curve[QTRI_U + i].at;
            run.step[i] = row->curve[QTRI_U + i].step;
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
        const int32_t length =
            qtri_interpolate_perspective(row, x, QTRI_BATCH, QTRI_U, QTRI_ATTRIBUTES);
        const int32_t skip = qtri_greatest32(row->x0 - x, 0);
        run.count = qtri_least32(length, row->x1 - x) - skip;
        if (run.count > 0) {
            run.x = x + skip;
            run.z = qtri_ramp_at(&job->depth, run.x - job->anchor_x, row->y - job->anchor_y);
            job->raster->copy_bent(job, &run, &row->curve[QTRI_U], skip);
        }
        x += length;
    }
}

static void begin(qtri_scanline *row, const qtri_job *job, int32_t y)
{
    const qtri_raster *raster = job->raster;
    row->job = job;
    row->y = y;
    row->pixels = qtri_pixels_at(raster->surface, y);
    row->depths = raster->compare != QTRI_DEPTH_OFF ? qtri_depths_at(raster->surface, y) : NULL;
    row->level = false;
    if (qtri_job_is_bent(job)) {
        qtri_perspective_begin(row);
        return;
    }
    qtri_linear_begin(row);
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
    if (qtri_job_is_bent(job)) {
        return;
    }
    for (int i = 0; i < 2 && job->end == QTRI_ATTRIBUTES; i++) {
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
        if (qtri_job_is_bent(job)) {
            qtri_perspective_row(&r);
        }
        if (copies && (!qtri_job_is_bent(job) || r.level)) {
            copy_row(&r);
        } else if (copies) {
            copy_bent_row(&r);
        } else {
            draw_row(&r);
        }
    }
}

void qtri_span_flat(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count)
{
    const qtri_raster *raster = job->raster;
    qtri_scanline r;
    r.job = job;
    for (; count > 0; count--, spans++, row++) {
        const int32_t pixels = qtri_span_clip(spans, &raster->bounds, &r.x0);
        if (pixels > 0) {
            r.x1 = r.x0 + pixels;
            r.y = row;
            r.pixels = qtri_pixels_at(raster->surface, row);
            r.depths =
                raster->compare != QTRI_DEPTH_OFF ? qtri_depths_at(raster->surface, row) : NULL;
            fill_row(&r);
        }
    }
}
