/*
 * Rows of large triangles by stages: chunks of up to 32 pixels, counted from the span's left end,
 * whatever of them a scissor or a band leaves. So pixels do not depend on either.
 */
#include "span.h"

#include "loop.h"
#include "packed.h"

/* Pixels of a row from x on. */
static inline uint8_t *pixels_at(const qtri_scanline *row, int32_t x)
{
    return row->pixels + (ptrdiff_t)x * row->job->raster->format->pixels->bytes;
}

enum { RUN = 512 }; /* pixels along which coordinates that fill 32 bits step from one start */

/*
 * Linear coordinates start anew from their planes: steps lose what a long run would show. Those that
 * fill 32 bits leave 2^-17 of a texel and less to the last bit, others start with every chunk.
 */
static void start_run(qtri_scanline *row, int32_t x)
{
    const qtri_job *job = row->job;
    row->run = x;
    for (int i = 0; i < 2; i++) {
        const uint64_t value =
            qtri_plane_column(row->by.plane[i], job->attribute[QTRI_U + i].plane.dx, x);
        row->uv[i].at = qtri_run_scaled((uint32_t)qtri_plane_floor(value), job->axis[i].up);
    }
}

/* The start of the run that x lies in. */
static inline int32_t run_of(const qtri_scanline *row, int32_t x)
{
    const int32_t length = row->job->raster->repeated ? RUN : QTRI_BATCH;
    return row->level ? row->left : x - ((x - row->left) & (length - 1));
}

int32_t qtri_interpolate_linear(qtri_scanline *row, int32_t x, int32_t count, int first, int end,
                                qtri_curve *out)
{
    const qtri_job *job = row->job;
    for (int i = first; i < end && i < QTRI_U; i++, out++) {
        const qtri_ramp *ramp = &job->attribute[i].ramp;
        out->at = qtri_ramp_at(ramp, x - job->anchor_x, row->y - job->anchor_y);
        out->step = ramp->dx;
        out->bend = 0;
    }
    if (end == QTRI_ATTRIBUTES) {
        const int32_t run = run_of(row, x);
        if (row->run != run) {
            start_run(row, run);
        }
        for (int i = 0; i < 2; i++, out++) {
            out->at = row->uv[i].at + (uint32_t)(x - run) * row->uv[i].step;
            out->step = row->uv[i].step;
            out->bend = 0;
        }
    }
    return count;
}

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

/* Light or colours for texels, into shades. */
static void interpolate_shades(qtri_scanline *row, int32_t x, int32_t count)
{
    const qtri_job *job = row->job;
    const qtri_raster *raster = job->raster;
    uint32_t *shade = raster->batch->shade;
    const int32_t whole = count;
    while (count > 0) {
        qtri_curve curve[3];
        const int32_t some = job->interpolate(row, x, count, job->first, QTRI_U, curve);
        if (job->first == 0) {
            qtri_shade_rgb(shade, curve, some);
        } else {
            qtri_shade_light(shade, curve, some);
        }
        shade += some;
        x += some;
        count -= some;
    }
    if (job->first == QTRI_U - 1 && raster->tint_shade != QTRI_SHADE_WHITE) {
        qtri_shade_tint(raster->batch->shade, raster->tint_shade, whole);
    }
}

/* Texture coordinates into the batch: as numbers of texels, or, filtered, as they are. */
static void interpolate_texels(qtri_scanline *row, int32_t x, int32_t count)
{
    const qtri_job *job = row->job;
    const qtri_raster *raster = job->raster;
    qtri_batch *batch = raster->batch;
    int32_t done = 0;
    while (done < count) {
        qtri_curve uv[2];
        const int32_t some = job->interpolate(row, x + done, count - done, QTRI_U, QTRI_ATTRIBUTES, uv);
        if (raster->texture->filter != NULL) {
            qtri_texel_coordinates(batch->color + done, batch->shade + done, uv, some);
        } else if (raster->repeated) {
            qtri_texel_numbers_repeated(batch->color + done, uv, raster->texel_cut, some);
        } else {
            qtri_texel_numbers(batch->color + done, uv, job->axis, some);
        }
        done += some;
    }
}

/* Colours of the format's kind for `count` pixels of the chunk at x. Gives those that are drawn. */
static uint32_t textured(qtri_scanline *row, int32_t x, int32_t count, uint32_t mask)
{
    const qtri_job *job = row->job;
    const qtri_raster *raster = job->raster;
    qtri_batch *batch = raster->batch;
    interpolate_texels(row, x, count);
    mask &= qtri_texels_color(raster, job->axis, batch->color, batch->shade, count);
    if (mask == 0) {
        return 0;
    }
    if (job->shaded) {
        if (job->first == QTRI_U) {
            qtri_shade_constant(batch->shade, job->pixel, count);
        } else {
            interpolate_shades(row, x, count);
        }
        qtri_texels_shade(raster, job->first == QTRI_U - 1 && raster->tint_shade == QTRI_SHADE_WHITE,
                          batch->color, batch->shade, count);
    }
    qtri_texels_narrow(raster, batch->color, count);
    return mask;
}

/* Which of `count` pixels from x on pass the depth test. */
static inline uint32_t test_depth(const qtri_scanline *row, uint32_t z, int32_t x, int32_t count)
{
    const qtri_depth *depth = &row->job->raster->depth;
    uint32_t mask = qtri_mask_of(count);
    if (depth->test != NULL) {
        const uint32_t named = depth->test(row->depths + x, z, row->job->depth.dx, count);
        mask = depth->inverted ? mask ^ named : named;
    }
    return mask;
}

static void draw_row(qtri_scanline *row)
{
    const qtri_job *job = row->job;
    const qtri_raster *raster = job->raster;
    const qtri_format *format = raster->format;
    const bool flat = job->first == job->end;
    for (int32_t x = row->left + ((row->x0 - row->left) & -QTRI_BATCH); x < row->x1;
         x += QTRI_BATCH) {
        const int32_t whole = qtri_least32(QTRI_BATCH, row->right - x);
        const int32_t from = qtri_greatest32(x, row->x0);
        const int32_t count = qtri_least32(x + whole, row->x1) - from;
        uint32_t z = 0;
        if (row->depths != NULL) {
            z = qtri_ramp_at(&job->depth, from - job->anchor_x, row->y - job->anchor_y);
        }
        uint32_t mask = test_depth(row, z, from, count);
        if (mask == 0) {
            continue;
        }
        uint8_t *pixels = pixels_at(row, from);
        if (flat) {
            format->pixels->fill(pixels, job->pixel, mask, count);
        } else {
            uint32_t *color = raster->batch->color + (from - x);
            if (raster->texture != NULL) {
                const int32_t after = whole - (from - x) - count;
                mask = textured(row, x, whole, mask << after) >> after & qtri_mask_of(count);
                if (mask == 0) {
                    continue;
                }
            } else {
                interpolate_colors(row, x, whole);
            }
            if (format->encode != NULL) {
                format->encode(color, count);
            }
            format->pixels->store(pixels, color, mask, count);
        }
        if (raster->depth.write) {
            qtri_depth_write(row->depths + from, z, job->depth.dx, mask, count);
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
        const int32_t end = row->level ? row->x1 : qtri_least32(run_of(row, x) + RUN, row->x1);
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
        const int32_t length =
            job->interpolate(row, x, QTRI_BATCH, QTRI_U, QTRI_ATTRIBUTES, uv);
        const int32_t skipped = qtri_greatest32(row->x0 - x, 0);
        run.count = qtri_least32(length, row->x1 - x) - skipped;
        if (run.count > 0) {
            run.x = x + skipped;
            run.z = qtri_ramp_at(&job->depth, run.x - job->anchor_x, row->y - job->anchor_y);
            for (int i = 0; i < 2; i++) {
                const uint32_t skip = (uint32_t)skipped;
                run.value[i] =
                    uv[i].at + skip * uv[i].step + (skip * (skip - 1) >> 1) * uv[i].bend;
                run.step[i] = uv[i].step + skip * uv[i].bend;
                run.bend[i] = uv[i].bend;
            }
            job->raster->copy_bent(job, &run);
        }
        x += length;
    }
}

/* A plane's step in the attribute's unit times 2^up, rounded. */
static uint32_t plane_step(uint64_t dx, int32_t up)
{
    int32_t down = 16 - up; /* -4..28: what is shifted in does not get to the low 32 bits */
    return (uint32_t)(down > 0 ? ((dx >> (down - 1)) + 1) >> 1 : dx << -down);
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
        row->by.perspective.zeros = 0;
        return;
    }
    for (int i = 0; i < 2 && job->end == QTRI_ATTRIBUTES; i++) {
        const qtri_plane *plane = &job->attribute[QTRI_U + i].plane;
        row->by.plane[i] = qtri_plane_row(plane, y) + ((uint64_t)job->axis[i].bias << 16);
        row->uv[i].step = plane_step(plane->dx, job->axis[i].up);
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
    if (job->perspective) {
        return;
    }
    for (int i = 0; i < 2 && job->end == QTRI_ATTRIBUTES; i++) {
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
        if (copies && (!job->perspective || r.level)) {
            copy_row(&r);
        } else if (copies) {
            copy_bent_row(&r);
        } else {
            draw_row(&r);
        }
    }
}
