/* SPDX-License-Identifier: MIT */
/*
 * What rows of large triangles do with curves: of texture coordinates, and of what texels are
 * multiplied by. Inline, as each kind of rows has its own copy. Internal.
 */
#ifndef QTRI_RASTER_TEXTURED_SPAN_H
#define QTRI_RASTER_TEXTURED_SPAN_H

#include "linear.h"
#include "perspective_block.h"
#include "pixel_light.h"
#include "texel_copy.h"
#include "texel_number.h"
#include "textured.h"

/*
 * Of a clamped texture, along curves: brings them to 32 bits, or, where that is not so quickly
 * done, finds the texels.
 */
bool qtri_clamp_texels(const qtri_raster *raster, const qtri_texel_axis axis[2], int32_t done,
                       qtri_curve uv[2], int32_t count);

/*
 * Coordinates of `count` pixels from the batch's pixel `done` on: as texels, their numbers or as
 * they are. clamped: coordinates of textures that would fill 32 bits, which do not.
 */
static inline void qtri_number_texels(const qtri_raster *raster, const qtri_texel_axis axis[2],
                                      int32_t done, qtri_curve uv[2], bool clamped, int32_t count)
{
    uint32_t *color = raster->batch->color + done;
    if (clamped && qtri_clamp_texels(raster, axis, done, uv, count)) {
        ;
    } else if (raster->texture->filter != NULL) {
        qtri_texel_coordinates(color, raster->batch->by.shade + done, uv, count);
#ifndef __OPTIMIZE_SIZE__
    } else if (raster->fetched) {
        qtri_texels_repeated_16(color, uv, raster->texel_cut, raster->texture->texels, count);
#endif
    } else if (raster->texel_cut != 0) {
        qtri_texel_numbers_repeated(color, uv, raster->texel_cut, count);
    } else {
        qtri_texel_numbers(color, uv, axis, count);
    }
}

/* The shade of all of a triangle's texels as curves. */
static inline void qtri_constant_curves(qtri_curve curve[3], uint32_t shade)
{
    for (int i = 2; i >= 0; i--) {
        const qtri_curve one = {((shade & 1023) << 14) + QTRI_SHADE_LESS, 0, 0, 0};
        curve[i] = one;
        shade >>= QTRI_SHADE_GREEN;
    }
}

/* Some of the batch's texels: stages work on four at a time, but the others are not yet due. */
static inline void qtri_multiply_some(const qtri_raster *raster, uint32_t *color,
                                      const qtri_curve channel[3], int32_t count)
{
    uint32_t *after = color + count;
    const uint32_t kept[3] = {after[0], after[1], after[2]};
    raster->times_curves(color, channel, count);
    if ((count & 3) != 0) {
        after[0] = kept[0];
        after[1] = kept[1];
        after[2] = kept[2];
    }
}

/* Multiplies the batch's texels by light or colours: pixels of the format's kind. */
static inline void qtri_shade_texels(qtri_scanline *row, int32_t x, int32_t count)
{
    const qtri_job *job = row->job;
    const qtri_raster *raster = job->raster;
    uint32_t *color = raster->batch->color;
    uint32_t *shade = raster->batch->by.shade;
    if (job->first == QTRI_U) {
        if (raster->by_pixel) {
            raster->lit->shade(row, x, count);
            return;
        }
        qtri_constant_curves(row->curve, job->pixel);
        raster->times_curves(color, row->curve, count);
        return;
    }
    for (int32_t done = 0; done < count;) {
        int32_t some = count;
        if (qtri_job_is_bent(job)) {
            some = qtri_interpolate_perspective(row, x + done, count - done, job->first, QTRI_U);
        }
        if (job->first != 0) {
            qtri_shade_light(shade + done, &row->curve[QTRI_U - 1], some);
        } else if (some == count) {
            raster->times_curves(color, row->curve, count);
        } else {
            qtri_multiply_some(raster, color + done, row->curve, some);
        }
        done += some;
    }
    if (job->first == QTRI_U - 1 && raster->white) {
        raster->light(color, shade, count);
    } else if (job->first == QTRI_U - 1) {
        raster->tinted(color, shade, raster->tint_q10, count);
    }
}

#endif
