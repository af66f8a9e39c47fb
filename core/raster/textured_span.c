/* SPDX-License-Identifier: MIT */
/*
 * What textures add to rows of large triangles.
 */
#include "textured_span.h"

/* The axes and the vertices' coordinates on them. */
void qtri_textured_axes(qtri_job *job, uint32_t value[2][3], const qtri_attributes v[3])
{
    const qtri_raster *raster = job->raster;
    const qtri_texture *texture = raster->texture;
    const bool clamped[2] = {texture->wrap_u == QTRI_CLAMP, texture->wrap_v == QTRI_CLAMP};
    for (int i = 0; i < 2; i++) {
        int64_t f_q32[3];
        for (int k = 0; k < 3; k++) {
            f_q32[k] = i == 0 ? v[k].u_q32 : v[k].v_q32;
        }
        qtri_texel_axis_init(
            &job->axis[i], value[i], f_q32, i == 0 ? texture->width_log2 : texture->height_log2,
            clamped[i], clamped[i] || raster->texel_cut == 0 ? 0 : raster->coordinate[i].shift);
        if (texture->filter != NULL) { /* from texels' centres */
            job->axis[i].bias -= (uint32_t)1 << (job->axis[i].shift - 1);
        }
    }
}

qtri_fill_rows qtri_textured_begin_large(qtri_job *job, const qtri_triangle *triangle,
                                         const uint32_t value[2][3], const uint32_t q[3])
{
    (void)job;
    (void)triangle;
    (void)value;
    (void)q;
    return qtri_span_fill;
}

/*
 * Where coordinates are brought to 32 bits one by one, as a chunk lies partly outside of the
 * texture.
 */
QTRI_NOINLINE static void hold_texels(const qtri_raster *raster, const qtri_texel_axis axis[2],
                                      uint32_t *color, uint32_t *across, const bool held[2],
                                      int32_t count)
{
    if (!held[0]) {
        qtri_texel_coordinates_held(color, &axis[0], raster->coordinate[0].shift, count);
    }
    if (!held[1]) {
        qtri_texel_coordinates_held(across, &axis[1], raster->coordinate[1].shift, count);
    }
    if (raster->texture->filter != NULL) {
        return;
    }
    const uint16_t *texels = raster->texture->texels;
    for (const uint32_t *end = color + ((count + 3) & ~3); color != end; color++) {
        const uint32_t number = qtri_texel_index(*color, *across++, raster->texel_cut);
        *color = raster->fetched ? texels[number] : number;
    }
}

QTRI_NOINLINE bool qtri_clamp_texels(const qtri_raster *raster, const qtri_texel_axis axis[2],
                                     int32_t done, qtri_curve uv[2], int32_t count)
{
    uint32_t *color = raster->batch->color + done;
    uint32_t *across = raster->batch->by.shade + done;
    bool held[2];
    for (int i = 0; i < 2; i++) {
        held[i] = !axis[i].clamped ||
                  qtri_texel_curve_held(&uv[i], &axis[i], raster->coordinate[i].shift, count);
    }
    if (held[0] && held[1]) {
        return false;
    }
    qtri_texel_coordinates(color, across, uv, count);
    hold_texels(raster, axis, color, across, held, count);
    return true;
}

/* Texture coordinates into the batch: as texels, their numbers or as they are. */
static void interpolate_texels(qtri_scanline *row, int32_t x, int32_t count)
{
    const qtri_job *job = row->job;
    const qtri_raster *raster = job->raster;
    qtri_curve *uv = &row->curve[QTRI_U];
    const bool clamped = !raster->repeated && raster->texel_cut != 0;
    int32_t done = 0;
    do {
        int32_t some = count;
        qtri_curve held[2];
        if (qtri_job_is_bent(job) && !row->level) {
            some =
                qtri_interpolate_perspective(row, x + done, count - done, QTRI_U, QTRI_ATTRIBUTES);
        } else if (clamped) { /* the next chunk goes on from what is kept */
            held[0] = uv[0];
            held[1] = uv[1];
            uv = held;
        }
        qtri_number_texels(raster, job->axis, done, uv, clamped, some);
        done += some;
    } while (done < count);
}

/* Pixels of the format's kind for `count` pixels of the chunk at x. Gives those that are drawn. */
uint32_t qtri_textured_chunk(qtri_scanline *row, int32_t x, int32_t count, uint32_t mask)
{
    const qtri_job *job = row->job;
    const qtri_raster *raster = job->raster;
    uint32_t *color = raster->batch->color;
    interpolate_texels(row, x, count);
    mask &= qtri_texels_color(raster, raster->texel_cut != 0 ? NULL : job->axis, color,
                              raster->batch->by.shade, count, raster->fetched, job->shaded);
    if (mask == 0 || !job->shaded) {
        return mask;
    }
    qtri_shade_texels(row, x, count);
    if (raster->narrow != NULL && !raster->gray) {
        raster->narrow(color, count);
    }
    return mask;
}
