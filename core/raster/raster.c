/* SPDX-License-Identifier: MIT */
#include "raster.h"

#include "../frame/depth_format.h"
#include "effect.h"
#include "loop.h"
#include "job.h"
#include "sampling.h"
#include "shading.h"
#include "depth_shift.h"
#include "span.h"

static bool has_texture(const qtri_material *material)
{
    const qtri_texture *texture = material->texture;
    return texture != NULL && texture->format != NULL && texture->format->usable(texture);
}

static void set_bounds(qtri_raster *raster, const qtri_rect *bounds)
{
    const int32_t reach = 37 * 256; /* QTRI_PLACE_PIXELS and one */
    const int32_t width = (bounds->x1 - bounds->x0) * 256 - 2 * reach;
    const int32_t height = (bounds->y1 - bounds->y0) * 256 - 2 * reach;
    raster->bounds = *bounds;
    raster->inner.x = (uint32_t)(bounds->x0 * 256 + reach);
    raster->inner.y = (uint32_t)(bounds->y0 * 256 + reach);
    raster->inner.width = width < 0 ? 0 : (uint32_t)width;
    raster->inner.height = height < 0 ? 0 : (uint32_t)height;
}

/* Fog and blend: see effect.h. */
static void set_effects(qtri_raster *raster, const qtri_material *material, bool textured)
{
    const qtri_fog *fog = material->fog;
    raster->blend = material->blend;
    raster->fog = fog != NULL && fog->stages != NULL ? fog : NULL;
    raster->alpha = material->alpha;
    raster->least_alpha = material->least_alpha;
    raster->keep = material->keep;
    raster->wide = false;
    raster->finer = false;
    raster->effects = qtri_effect_stages_of(material);
    raster->rejects = (textured && (material->texture->has_key || material->least_alpha != 0)) ||
                      (raster->blend != NULL && raster->blend->rejects);
    raster->late = raster->effects != NULL ? raster->effects->late : NULL;
    raster->apart = raster->rejects && raster->depth_write && raster->compare == QTRI_NOT_EQUAL;
    raster->keeps_depth = raster->fog != NULL || (raster->rejects && raster->depth_write);
    raster->reads = raster->blend != NULL;
    raster->with_depth = raster->compare != QTRI_DEPTH_OFF || raster->fog != NULL;
}

/* The format's fused loops for what becomes of depth; NULL: none. */
static const qtri_fused *fused_of(const qtri_raster *raster)
{
    const qtri_fused *fused = raster->format->fused;
    if (!QTRI_WITH_FAST_PATHS || fused == NULL || raster->effects != NULL ||
        raster->route != NULL || !raster->depth_write) {
        return NULL;
    }
    if (raster->compare == QTRI_LESS_EQUAL) {
        return fused->less_equal;
    }
    return raster->compare == QTRI_LESS ? fused : NULL;
}

/*
 * Who draws the triangles: four samples, alpha of the vertices before that, and before all of it
 * a shift of depths. A blend by vertex sets units and format for the stages that are chosen next.
 */
static void set_route(qtri_raster *raster, const qtri_material *material)
{
    raster->route = raster->samples != NULL ? raster->samples->draw : NULL;
    raster->of.material = material;
    if (raster->blend != NULL && raster->blend->by_vertex != NULL) {
        raster->blend->by_vertex->begin(raster);
    }
    if (material->depth_shift != NULL) {
        raster->route = material->depth_shift->draw;
    }
}

void qtri_raster_init(qtri_raster *raster, const qtri_surface *surface,
                      const qtri_material *material, qtri_batch *batch)
{
    const qtri_rect nowhere = {0, 0, 0, 0};
    qtri_rect bounds = qtri_surface_bounds(surface);
    const qtri_format *format = surface->format;
    const bool textured = has_texture(material);
    raster->surface = surface;
    raster->format = format;
    raster->batch = batch;
    batch->count = 0;
    batch->kind = 0;
    batch->has_table = false;
    batch->mask = 0;
    raster->compare = surface->depth == NULL ? QTRI_DEPTH_OFF : qtri_compare_of(material);
    raster->depth_write = raster->compare != QTRI_DEPTH_OFF && !material->depth_read_only;
    raster->perspective = QTRI_WITH_PERSPECTIVE && material->interpolation == QTRI_PERSPECTIVE;
    raster->cull = material->cull;
    raster->provoking = qtri_shading_of(material)->provoking;
    raster->varying = qtri_shading_of(material)->varying;
    raster->smooth = raster->varying != NULL;
    raster->by_pixel = false;
    raster->lit = NULL;
    set_effects(raster, material, textured);
    const qtri_depth_testing *testing = qtri_depth_testing_of(surface);
    if (testing != NULL) {
        testing->begin(raster);
    }
    raster->depth = qtri_depth_stages(raster->compare, raster->depth_write, raster->rejects);
    raster->texture = NULL;
    raster->replace = false;
    raster->copied = false;
    raster->fetched = false;
    raster->repeated = false;
    raster->fill_flat = raster->effects != NULL ? raster->effects->fill : qtri_span_flat;
    raster->copy_run = NULL;
    raster->copy_bent = NULL;
    raster->lit_list = NULL;
    if (format == NULL || raster->compare == QTRI_NEVER) {
        bounds = nowhere;
        raster->format = &qtri_xrgb8888;
        format = raster->format;
    }
    set_bounds(raster, &bounds);
    raster->units = format->colors;
    raster->samples = format->fused != NULL ? format->fused->samples : NULL;
    set_route(raster, material);
    if (textured) {
        raster->texturing = material->texture->format->texturing;
        raster->texturing->init(raster, material);
    }
    raster->format = format;
    if (raster->fog != NULL) {
        raster->fog->stages->begin(raster); /* after the texture has its stages */
    }
    raster->fill_smooth = raster->varying != NULL ? raster->varying->fill : raster->fill_flat;
    raster->tint_small = NULL;
    raster->effect_row = NULL;
    raster->effect_list = NULL;
    if (QTRI_WITH_FAST_PATHS && raster->effects != NULL && raster->effects->choose != NULL) {
        raster->effects->choose(raster);
    }
    const qtri_fused *fused = fused_of(raster);
    if (fused != NULL) {
        raster->fill_flat = fused->flat;
        raster->fill_smooth = fused->smooth != NULL ? fused->smooth : raster->fill_smooth;
        raster->copy_run = raster->copied ? fused->copy : NULL;
        raster->copy_bent = raster->copied ? fused->copy_bent : NULL;
        if (raster->copied && raster->late == NULL &&
            raster->texturing == material->texture->format->texturing) { /* of one level */
            raster->lit_list = fused->lit;
        }
    }
}

qtri_channels qtri_raster_channels(const qtri_raster *raster, const int32_t color_8p16[3])
{
    qtri_channels channels = qtri_channels_from_color(raster->units, color_8p16);
    if (raster->units->single) {
        channels.c[2] += channels.c[0] + channels.c[1];
        channels.c[0] = 0;
        channels.c[1] = 0;
    }
    return channels;
}

void qtri_raster_lit_channels(int32_t channel[3], const qtri_raster *raster, const qtri_rgb *color,
                              uint32_t light_q15)
{
    const qtri_colors *units = raster->units;
    const uint32_t color_8p16[3] = {color->r * 2 * light_q15, color->g * 2 * light_q15,
                                    color->b * 2 * light_q15}; /* <= 255.0 */
    for (int i = 0; i < 3; i++) {
        channel[i] = (int32_t)qtri_channel_scaled(color_8p16[i], units->ratio_q30[i]);
    }
    if (units->single) {
        channel[2] += channel[0] + channel[1];
        channel[0] = 0;
        channel[1] = 0;
    }
}

void qtri_raster_set_tint(qtri_raster *raster, qtri_rgb color)
{
    const int32_t color_8p16[3] = {(int32_t)color.r << 16, (int32_t)color.g << 16,
                                   (int32_t)color.b << 16};
    raster->tint = qtri_raster_channels(raster, color_8p16);
    for (int i = 0; i < 3; i++) {
        raster->tint_n8[i] = (uint32_t)raster->tint.c[i] >> 8;
    }
    if (raster->texture != NULL) {
        const uint8_t channel[3] = {color.r, color.g, color.b};
        for (int i = 0; i < 3; i++) {
            raster->tint_q10[i] = (channel[i] * 1024u + 127) / 255;
        }
        raster->white = (color.r & color.g & color.b) == 255;
    }
}

uint32_t qtri_raster_stored(const qtri_raster *raster, uint32_t color)
{
    uint32_t words[4] = {color};
    if (raster->format->encode != NULL && raster->effects == NULL) {
        raster->format->encode(words, 1);
    }
    return words[0];
}
