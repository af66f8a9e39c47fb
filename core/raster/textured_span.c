/* SPDX-License-Identifier: MIT */
/*
 * What textures add to rows of large triangles.
 */
#include "texel_copy.h"
#include "texel_number.h"
#include "textured.h"

/* The axes and the vertices' coordinates on them. */
void qtri_textured_axes(qtri_job *job, uint32_t value[2][3], const qtri_attributes v[3])
{
    const qtri_raster *raster = job->raster;
    const qtri_texture *texture = raster->texture;
    for (int i = 0; i < 2; i++) {
        int64_t f_q32[3];
        for (int k = 0; k < 3; k++) {
            f_q32[k] = i == 0 ? v[k].u_q32 : v[k].v_q32;
        }
        qtri_texel_axis_init(&job->axis[i], value[i], f_q32,
                             i == 0 ? texture->width_log2 : texture->height_log2,
                             (i == 0 ? texture->wrap_u : texture->wrap_v) == QTRI_CLAMP,
                             raster->repeated ? qtri_texel_copy_shift(texture, i) : 0);
    }
}

/* Light or colours for texels, into shades. */
static void interpolate_shades(qtri_scanline *row, int32_t x, int32_t count)
{
    const qtri_job *job = row->job;
    const qtri_raster *raster = job->raster;
    uint32_t *shade = raster->batch->by.shade;
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
        const int32_t some =
            job->interpolate(row, x + done, count - done, QTRI_U, QTRI_ATTRIBUTES, uv);
        if (raster->texture->filter != NULL) {
            qtri_texel_coordinates(batch->color + done, batch->by.shade + done, uv, some);
#ifndef __OPTIMIZE_SIZE__
        } else if (raster->fetched) {
            qtri_texels_repeated_16(batch->color + done, uv, raster->texel_cut,
                                    raster->texture->texels, some);
#endif
        } else if (raster->repeated) {
            qtri_texel_numbers_repeated(batch->color + done, uv, raster->texel_cut, some);
        } else {
            qtri_texel_numbers(batch->color + done, uv, job->axis, some);
        }
        done += some;
    }
}

/* Colours of the format's kind for `count` pixels of the chunk at x. Gives those that are drawn. */
uint32_t qtri_textured_chunk(qtri_scanline *row, int32_t x, int32_t count, uint32_t mask)
{
    const qtri_job *job = row->job;
    const qtri_raster *raster = job->raster;
    qtri_batch *batch = raster->batch;
    interpolate_texels(row, x, count);
    mask &=
        qtri_texels_color(raster, job->axis, batch->color, batch->by.shade, count, raster->fetched);
    if (mask != 0 && job->shaded) {
        if (job->first == QTRI_U) {
            qtri_shade_constant(batch->by.shade, job->pixel, count);
        } else {
            interpolate_shades(row, x, count);
        }
        if (job->first == QTRI_U - 1 && !raster->white) {
            raster->tinted(batch->color, batch->by.shade, raster->tint_q10, count);
        } else {
            (job->first == QTRI_U - 1 ? raster->light : raster->times)(batch->color,
                                                                       batch->by.shade, count);
        }
    }
    if (mask != 0 && raster->narrow != NULL) {
        raster->narrow(batch->color, count);
    }
    return mask;
}
