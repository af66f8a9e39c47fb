/* SPDX-License-Identifier: MIT */
#include "setup.h"

#include "depth_clamp.h"
#include "packed.h"
#include "perspective.h"
#include "shading.h"
#include "span.h"
#include "texel_copy.h"
#include "textured.h"
#include "tint.h"
#include "unsnapped.h"

/*
 * Colours may stray by 1/4 of a step for being linear on the screen: with the rounding to a pixel
 * and the short fractions of packed.h less than one step in all. Where texels are multiplied they
 * are in steps of 8 bits, and 1/8 of a step of what is drawn is left to them.
 */
static int linear_log2(const qtri_raster *raster)
{
    if (raster->texture == NULL) {
        return 14 + raster->units->finer;
    }
    return raster->working == &qtri_colors_565 ? 15 : 13;
}

/* Greatest less least. */
static uint32_t range_of(const uint32_t f[3], uint32_t *least)
{
    uint32_t greatest = f[0] > f[1] ? f[0] : f[1];
    *least = f[0] < f[1] ? f[0] : f[1];
    *least = *least < f[2] ? *least : f[2];
    return (greatest > f[2] ? greatest : f[2]) - *least;
}

/*
 * Whether linear interpolation of an attribute that spans `range` strays by less than
 * 2^tolerance_log2 anywhere in the triangle, q being 1/w at the vertices. With weights b_i, sum 1,
 * and Q = sum b_i q_i the true value has weights b_i q_i / Q: off by at most
 * (range / 2) sum b_i |q_i - Q| / Q, and a mean distance from the mean is at most half the range:
 * range (q_greatest - q_least) / (4 q_least).
 */
static bool nearly_linear(uint32_t range, const uint32_t q[3], int tolerance_log2)
{
    uint32_t q_least; /* <= 2^31 */
    uint32_t q_range = range_of(q, &q_least);
    return qtri_mul_u32(range, q_range) >> (tolerance_log2 + 2) < q_least;
}

static void ramp_init(qtri_ramp *ramp, const qtri_gradient *g, const uint32_t f[3])
{
    if (g->inverse != 0 && qtri_ramp_fits(f[0], f[1]) && qtri_ramp_fits(f[0], f[2])) {
        qtri_ramp_multiply(ramp, g, f);
    } else {
        qtri_ramp_divide(ramp, g, f);
    }
}

/*
 * That of shares of a tint, Q22, of which colours vary by as much as its widest channel does. Not 0
 * where they vary: 2^16 255 2^8 < 2^32, and a tint's channel is cut off by 2^-8 of a step.
 */
static uint32_t tint_range(const qtri_raster *raster, uint32_t share)
{
    return ((share + 63) >> 6) * qtri_raster_widest_tint(raster) >> 8;
}

/*
 * The widest of the colours, so that 2^16 is a step of what is drawn or less. Where texels are
 * multiplied, shares of a tint are taken as those of white: 63 steps of RGB565 or 255.
 */
static uint32_t color_range(const qtri_job *job, const qtri_attributes v[3])
{
    const qtri_raster *raster = job->raster;
    uint32_t range = 0;
    for (int i = job->tinted ? QTRI_U - 1 : 0; i < QTRI_U; i++) {
        const uint32_t f[3] = {(uint32_t)v[0].color[job->tinted ? 0 : i],
                               (uint32_t)v[1].color[job->tinted ? 0 : i],
                               (uint32_t)v[2].color[job->tinted ? 0 : i]};
        uint32_t least;
        const uint32_t other = range_of(f, &least);
        range = other > range ? other : range;
    }
    if (job->tinted && raster->texture == NULL) {
        return tint_range(raster, range);
    }
    return job->tinted ? range << 2 : range;
}

/* Ramps of a tint's channels from that of light, Q22 of it, where it is not so steep that it wraps.
 */
static void set_tint(qtri_job *job, const qtri_ramp *light)
{
    const qtri_raster *raster = job->raster;
    const int32_t origin = (int32_t)(light->origin - 0x8000u);
    for (int i = job->first; i < QTRI_U; i++) {
        qtri_ramp *c = &job->attribute[i].ramp;
        c->origin = (uint32_t)qtri_raster_shade(raster, origin, i) + 0x8000u;
        c->dx = (uint32_t)qtri_raster_shade(raster, (int32_t)light->dx, i);
        c->dy = (uint32_t)qtri_raster_shade(raster, (int32_t)light->dy, i);
    }
}

static uint32_t pack_step(const qtri_job *job, uint32_t times)
{
    const qtri_attribute *c = job->attribute;
    return qtri_pack_round(times * c[0].ramp.dx, times * c[1].ramp.dx, times * c[2].ramp.dx);
}

/* When ramps of colours are set: the steps of packed.h, where they serve. */
static void set_steps(qtri_job *job)
{
    job->packed = job->raster->units == &qtri_colors_565;
    if (job->packed) {
        qtri_packed_steps *step = &job->color.step;
        step->even = pack_step(job, 1);
        step->odd = pack_step(job, 2) - step->even;
        step->eight = pack_step(job, 8);
        step->last = step->eight - 4 * step->even - 3 * step->odd;
    }
}

static void linear_colors(qtri_job *job, const qtri_attributes v[3], const qtri_gradient *gradient,
                          const qtri_unsnapped *unsnapped)
{
    const bool textured = job->raster->texture != NULL;
    if (job->tinted && !textured && gradient->inverse != 0) {
        uint32_t share[3] = {(uint32_t)v[0].color[0], (uint32_t)v[1].color[0],
                             (uint32_t)v[2].color[0]};
        qtri_ramp light;
        qtri_unsnapped_move_inside(share, unsnapped);
        qtri_ramp_multiply(&light, gradient, share);
        set_tint(job, &light);
    } else {
        for (int i = job->first; i < QTRI_U; i++) {
            uint32_t f[3];
            qtri_job_color(f, job, v, i);
            qtri_unsnapped_move_inside(f, unsnapped);
            ramp_init(&job->attribute[i].ramp, gradient, f);
        }
    }
    if (!textured) {
        set_steps(job);
    }
}

/*
 * Whether attributes must be divided. q: 1/w with one exponent. Texture coordinates may stray by
 * 1/1024 of a texel for being linear. value: those of the vertices; range: of the colours.
 */
static bool needs_perspective(const qtri_job *job, const qtri_attributes v[3],
                              const uint32_t value[2][3], uint32_t range, uint32_t q[3])
{
    if (!(QTRI_WITH_PERSPECTIVE && job->raster->perspective) || !qtri_align_inv_w(q, v)) {
        return false;
    }
    if (!nearly_linear(range, q, linear_log2(job->raster))) {
        return true;
    }
    for (int i = QTRI_U; i < job->end; i++) {
        const int32_t tolerance = job->axis[i - QTRI_U].shift - 10;
        uint32_t least;
        if (tolerance < 0 || !nearly_linear(range_of(value[i - QTRI_U], &least), q, tolerance)) {
            return true;
        }
    }
    return false;
}

/*
 * The anchor of a small triangle is in its middle, that of others at vertex 0, or as near to it as
 * the frame has a pixel. Neither depends on bands or scissor.
 */
static void gradient_from(qtri_gradient *g, const qtri_triangle *t, const qtri_surface *surface)
{
    qtri_gradient_place(g, t);
    qtri_gradient_init(g, t->extent);
    if (g->inverse == 0) { /* <= 2^13 pixels */
        qtri_gradient_set_anchor(g, qtri_hold32(g->x_24p8, 0, surface->width * 256 - 1) >> 8,
                                 qtri_hold32(g->y_24p8, 0, surface->height * 256 - 1) >> 8);
    } else {
        qtri_gradient_set_middle(g, t);
    }
}

/* The one colour: as a stored pixel, or as the shade of all texels. */
static void constant_color(qtri_job *job, const qtri_attributes v[3])
{
    const qtri_raster *raster = job->raster;
    const qtri_attributes *from = &v[raster->provoking];
    int32_t channel[3];
    if (job->tinted && raster->texture == NULL) { /* as small triangles have it */
        job->pixel = qtri_raster_stored(
            raster, qtri_raster_tinted(raster, (uint32_t)from->color[0] >> 7, 15));
        return;
    }
    for (int i = 0; i < 3; i++) {
        channel[i] = job->tinted ? qtri_raster_shade(raster, from->color[0], i) : from->color[i];
    }
    if (raster->texture == NULL) {
        job->pixel = qtri_raster_stored(raster, raster->units->pack(channel));
        return;
    }
    job->pixel = qtri_shade_of(channel);
    job->shaded = !raster->replace && job->pixel != QTRI_SHADE_WHITE;
    job->copies = raster->copied && !job->shaded;
}

qtri_fill_rows qtri_job_set_varying(qtri_job *job, const qtri_triangle *triangle,
                                    const qtri_attributes v[3], const qtri_gradient *gradient,
                                    const qtri_unsnapped *unsnapped)
{
    const qtri_raster *raster = job->raster;
    const bool textured = raster->texture != NULL;
    uint32_t range = 0; /* of colours to interpolate */
    uint32_t q[3];
    uint32_t value[2][3];
    if (raster->smooth && !raster->replace) {
        range = color_range(job, v);
    }
    if (range == 0) {
        constant_color(job, v);
        if (!textured) {
            return raster->fill_flat;
        }
    } else {
        const bool one = raster->units->single || (textured && job->tinted);
        job->first = one ? QTRI_U - 1 : 0;
        job->shaded = textured;
    }
    if (textured) {
        raster->texturing->set_axes(job, value, v);
    }
    job->perspective = needs_perspective(job, v, (const uint32_t(*)[3])value, range, q);
    if (job->perspective) {
        qtri_perspective_init(job, triangle, v, (const uint32_t(*)[3])value, q, gradient,
                              unsnapped);
        return textured
                   ? raster->texturing->begin_large(job, triangle, (const uint32_t(*)[3])value, q)
                   : qtri_span_fill;
    }
    if (range != 0) {
        linear_colors(job, v, gradient, unsnapped);
    }
    if (!textured) {
        return raster->fill_smooth;
    }
    for (int i = QTRI_U; i < QTRI_ATTRIBUTES; i++) {
        qtri_unsnapped_plane(&job->attribute[i].plane, gradient, unsnapped, value[i - QTRI_U]);
    }
    return raster->texturing->begin_large(job, triangle, (const uint32_t(*)[3])value, q);
}

qtri_fill_rows qtri_job_init(qtri_job *job, const qtri_raster *raster,
                             const qtri_triangle *triangle, const qtri_attributes v[3])
{
    qtri_gradient gradient;
    qtri_unsnapped unsnapped;
    job->raster = raster;
    job->tinted = triangle->tinted;
    job->perspective = false;
    job->packed = false;
    job->copies = false;
    job->shaded = false;
    job->clamps_depth = false;
    job->cut = triangle->cut;
    job->first = QTRI_U;
    job->end = raster->texture != NULL ? QTRI_ATTRIBUTES : QTRI_U;
    gradient_from(&gradient, triangle, raster->surface);
    job->anchor_x = gradient.anchor_x;
    job->anchor_y = gradient.anchor_y;
    qtri_unsnapped_init(&unsnapped, raster, triangle, v);
    if (raster->with_depth) {
        uint32_t depth[3] = {v[0].depth_16p16, v[1].depth_16p16, v[2].depth_16p16};
        job->clamps_depth = qtri_unsnapped_move(depth, &unsnapped, 0, (uint32_t)65535 << 16) &&
                            qtri_depth_clamp_init(job, v, &gradient, &unsnapped);
        if (!job->clamps_depth) {
            ramp_init(&job->depth, &gradient, depth);
        }
    }
    if (raster->varying != NULL) {
        return raster->varying->set_job(job, triangle, v, &gradient, &unsnapped);
    }
    constant_color(job, v);
    return raster->fill_flat;
}
