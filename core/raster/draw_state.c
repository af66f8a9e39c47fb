/* SPDX-License-Identifier: MIT */
#include "draw_state.h"

#include <string.h>

#include "bilinear.h"
#include "effect.h"
#include "qtri/body/pixel.h"
#include "sampling.h"
#include "shading.h"
#include "texel_format.h"

enum {
    SMALL_REACH = 61 * 256 /* of a small triangle from its first vertex, 24.8, and a pixel */
};

/* What the library computes in 2^16 texels at most fits one mask. */
static bool is_large_texture(const qtri_texture *texture)
{
    return qtri_side_log2(texture->width_log2) + qtri_side_log2(texture->height_log2) > 16;
}

/* A side of one texel has nothing to repeat, and coordinates that fill 32 bits no room for it. */
static uint8_t wrap_of(qtri_wrap wrap, uint8_t side_log2)
{
    return wrap == QTRI_CLAMP || side_log2 == 0 ? QTRI_CLAMP : QTRI_REPEAT;
}

static bool is_usable(const qtri_texture *texture)
{
    return texture != NULL && texture->format != NULL && texture->format->usable(texture);
}

static void want_texture(qtri_options *o, const qtri_material *material)
{
    const qtri_texture *texture = material->texture;
    o->texel = texture->format->kind != QTRI_NO_TEXEL ? texture->format->kind : QTRI_OTHER_TEXEL;
    if (texture->filter != NULL) {
        o->bilinear = texture->filter->is_bilinear;
        o->mipmapped = texture->filter->is_mipmapped;
    }
    o->wrap_u = wrap_of(texture->wrap_u, texture->width_log2);
    o->wrap_v = wrap_of(texture->wrap_v, texture->height_log2);
    o->key = texture->has_key;
    o->large_texture = is_large_texture(texture);
    o->alpha_test = material->least_alpha != 0 && qtri_has_alpha(o);
}

static bool is_white(qtri_rgb color)
{
    return (color.r & color.g & color.b) == 255;
}

static uint8_t shade_of(const qtri_options *o, const qtri_material *material, int shade)
{
    if (o->texel == QTRI_NO_TEXEL) {
        return (uint8_t)(shade == QTRI_TINT ? QTRI_FLAT : shade);
    }
    if (material->texture_mode == QTRI_REPLACE ||
        (shade == QTRI_FLAT && is_white(material->color))) {
        return QTRI_FLAT;
    }
    if (shade == QTRI_LIGHT && is_white(material->color)) {
        return QTRI_WHITE_LIGHT;
    }
    return (uint8_t)(shade == QTRI_FLAT ? QTRI_TINT : shade);
}

static void want_blend(qtri_options *o, const qtri_material *material)
{
    const qtri_blend *blend = material->blend;
    if (blend == NULL) {
        return;
    }
    const uint8_t keep = material->keep & 7;
    o->blend = blend->kind;
    o->vertex_alpha = blend->by_vertex != NULL && material->alphas != NULL;
    if (blend->kind != QTRI_SCREEN_DOOR && blend->kind != QTRI_KEEP_PIXEL) {
        if (keep == 7) {
            o->blend = QTRI_KEEP_PIXEL;
        } else {
            o->keep = keep != 0 && o->format != QTRI_GRAY8;
        }
    }
    if (o->blend == QTRI_KEEP_PIXEL || o->blend == QTRI_STORE) {
        o->vertex_alpha = 0;
    }
}

static void want(qtri_options *o, const qtri_surface *surface, const qtri_material *material,
                 int shade)
{
    const qtri_depth_format *depth = surface->depth_format;
    memset(o, 0, sizeof *o);
    o->format = surface->format->kind;
    o->pixel_bytes = o->format == QTRI_OTHER_FORMAT ? surface->format->pixels->bytes : 0;
    if (surface->depth != NULL && material->depth_compare != QTRI_DEPTH_OFF) {
        o->depth = depth == NULL || depth->testing == NULL ? QTRI_LINEAR16
                   : depth->kind != QTRI_NO_DEPTH          ? depth->kind
                                                           : QTRI_OTHER_DEPTH;
        o->compare =
            (uint8_t)((unsigned)material->depth_compare < QTRI_ALWAYS ? material->depth_compare
                                                                      : QTRI_ALWAYS);
        o->read_only = material->depth_read_only;
    }
    if (is_usable(material->texture)) {
        want_texture(o, material);
    }
    o->covered = (shade & QTRI_COVERED) != 0;
    o->shade = shade_of(o, material, shade & ~QTRI_COVERED);
    want_blend(o, material);
    o->fog = material->fog != NULL && material->fog->stages != NULL;
    o->fragment = material->fragment;
    o->linear = material->interpolation != QTRI_PERSPECTIVE &&
                (o->texel != QTRI_NO_TEXEL || o->shade >= QTRI_LIGHT || o->vertex_alpha);
    o->samples = qtri_sampling_of(surface->format) != NULL ? 4 : 0;
}

/* All but formats of the application's own. */
static bool are_equal(const qtri_options *a, const qtri_options *b)
{
    const uint8_t *x = (const uint8_t *)a;
    const uint8_t *y = (const uint8_t *)b;
    size_t i = 0;
    while (i < offsetof(qtri_options, pixel_bytes) && x[i] == y[i]) {
        i++;
    }
    return i == offsetof(qtri_options, pixel_bytes);
}

/* Formats of the application's own are known by their addresses, where a pipeline names them. */
static bool fits(const qtri_pipeline *pipeline, const qtri_options *wanted,
                 const qtri_surface *surface, const qtri_texture *texture)
{
    const qtri_options *o = &pipeline->options;
    if (o->format == QTRI_ANY) {
        return true;
    }
    return are_equal(o, wanted) && o->fragment == wanted->fragment &&
           (o->format != QTRI_OTHER_FORMAT ||
            (o->own_format == surface->format && o->pixel_bytes == wanted->pixel_bytes)) &&
           (o->texel != QTRI_OTHER_TEXEL || (texture != NULL && o->own_texel == texture->format));
}

static const qtri_pipeline *find(const qtri_pipeline *const *list, const qtri_options *wanted,
                                 const qtri_surface *surface, const qtri_texture *texture)
{
    for (; list != NULL && *list != NULL; list++) {
        if (fits(*list, wanted, surface, texture)) {
            return *list;
        }
    }
    return NULL;
}

static void set_bounds(qtri_draw_state *state, const qtri_surface *surface)
{
    state->bounds = qtri_surface_bounds(surface);
    const qtri_rect *b = &state->bounds;
    const int32_t width = (b->x1 - b->x0) * 256 - 2 * SMALL_REACH;
    const int32_t height = (b->y1 - b->y0) * 256 - 2 * SMALL_REACH;
    state->inner.x = (uint32_t)(b->x0 * 256 + SMALL_REACH);
    state->inner.y = (uint32_t)(b->y0 * 256 + SMALL_REACH);
    state->inner.width = width < 0 ? 0 : (uint32_t)width;
    state->inner.height = height < 0 ? 0 : (uint32_t)height;
}

/* Bits of colours that stay: see QTRI_KEEP_RED. */
static uint32_t kept_bits(qtri_color_kind kind, uint32_t keep)
{
    const bool is_565 = kind == QTRI_IN_565;
    return ((keep & QTRI_KEEP_RED) != 0 ? (is_565 ? 0xF800u : 0xFF0000u) : 0) |
           ((keep & QTRI_KEEP_GREEN) != 0 ? (is_565 ? 0x07E0u : 0xFF00u) : 0) |
           ((keep & QTRI_KEEP_BLUE) != 0 ? (is_565 ? 0x1Fu : 0xFFu) : 0);
}

static uint32_t word_of(qtri_rgb color)
{
    return (uint32_t)color.r << 16 | (uint32_t)color.g << 8 | color.b;
}

static void set_colors(qtri_draw_state *state, const qtri_material *material)
{
    const qtri_options *o = &state->options;
    const qtri_color_kind kind = qtri_kind_of(o);
    state->color = word_of(material->color);
    state->weight[0] = material->color.r + (material->color.r >> 7);
    state->weight[1] = material->color.g + (material->color.g >> 7);
    state->weight[2] = material->color.b + (material->color.b >> 7);
    state->alpha = material->alpha + (material->alpha >> 7);
    state->keep = kept_bits(kind, material->keep);
    state->fog = o->fog ? material->fog : NULL;
    state->fog_color = !o->fog                ? 0
                       : kind == QTRI_IN_GRAY ? material->fog->word[2]
                                              : material->fog->word[1];
}

static void set_texture(qtri_draw_state *state, const qtri_material *material)
{
    const qtri_texture *texture = material->texture;
    state->texture = NULL;
    if (state->options.texel == QTRI_NO_TEXEL) {
        return;
    }
    state->texture = texture;
    state->width_log2 = qtri_side_log2(texture->width_log2);
    state->height_log2 = qtri_side_log2(texture->height_log2);
    state->key_mask = texture->format->key_mask;
    state->key = texture->key & state->key_mask;
    state->alpha_least = (uint32_t)material->least_alpha << 24;
}

/* What no pipeline draws. */
static void draw_nothing(struct qtri_large *triangle)
{
    (void)triangle;
}

static bool draw_nothing_small(struct qtri_small *triangle)
{
    (void)triangle;
    return true;
}

static const qtri_pipeline nothing = {
    .large = draw_nothing, .small = draw_nothing_small, .ops = NULL, .span = NULL};

void qtri_draw_state_init(qtri_draw_state *state, const qtri_surface *surface,
                          const qtri_pipeline *const *pipelines, const qtri_material *material,
                          int shade)
{
    const qtri_rect nowhere = {0, 0, 0, 0};
    memset(&state->options, 0, sizeof state->options);
    state->texture = NULL;
    state->has_table = false;
    state->pipeline = &nothing;
    state->surface = surface;
    state->material = material;
    state->bounds = nowhere;
    if (surface->format == NULL || material->depth_compare == QTRI_NEVER) {
        return;
    }
    want(&state->options, surface, material, shade);
    set_bounds(state, surface);
    state->depth_pitch =
        surface->depth_pitch * (ptrdiff_t)qtri_depth_size(&state->options, surface);
    set_colors(state, material);
    set_texture(state, material);
    const qtri_pipeline *found = find(pipelines, &state->options, surface, state->texture);
    QTRI_ASSERT(found != NULL);
    if (found == NULL) {
        return;
    }
    state->pipeline = found;
    if (found->options.format != QTRI_ANY) {
        state->options = found->options;
    }
}

/* A step of light of a channel of 255: most / (255 128) in 2^-24, off by 2^-9 in all at most. */
#define STEP(most) ((((uint32_t)(most) << 24) + 16320) / 32640)

void qtri_draw_state_set_table(qtri_draw_state *state)
{
    const uint32_t r_step = (state->color >> 16) * STEP(31);
    const uint32_t g_step = (state->color >> 8 & 255) * STEP(63);
    const uint32_t b_step = (state->color & 255) * STEP(31);
    uint32_t r = (uint32_t)1 << 23, g = r, b = r;
    uint16_t *const end = state->table + QTRI_TABLE;
    for (uint16_t *out = state->table; out != end; out++) {
        *out = (uint16_t)(r >> 24 << 11 | g >> 24 << 5 | b >> 24);
        r += r_step;
        g += g_step;
        b += b_step;
    }
    state->has_table = true;
}

bool qtri_pipelines_can_draw(const qtri_surface *surface, const qtri_material *material)
{
    const qtri_texture *texture = material->texture;
    return qtri_sampling_of(surface->format) == NULL && material->depth_shift == NULL &&
           material->fill == NULL &&
           (!is_usable(texture) || texture->filter == NULL || !texture->filter->is_mipmapped);
}

uint32_t qtri_encode_other(const qtri_format *format, uint32_t color_888)
{
    uint32_t words[4] = {color_888, 0, 0, 0}; /* formats may work on three more */
    if (format->colors == &qtri_colors_565) {
        words[0] = qtri_pixel_888_to_565(color_888);
    } else if (format->colors == &qtri_colors_gray) {
        words[0] = qtri_pixel_888_to_luma(color_888);
    }
    if (format->encode != NULL) {
        format->encode(words, 1);
    }
    return words[0];
}

uint32_t qtri_depth_encode_other(const qtri_depth_format *format, uint32_t z_16p16)
{
    uint32_t words[4] = {z_16p16, 0, 0, 0};
    format->encode(words, 1);
    return words[0];
}

uint32_t qtri_fetch_other(const qtri_texture *texture, uint32_t number)
{
    uint32_t words[4] = {number, number, number, number};
    texture->format->fetch(words, texture, 1);
    return words[0];
}

uint32_t qtri_texel_other(const qtri_texture *texture, uint32_t stored)
{
    const qtri_texel_format *format = texture->format;
    uint32_t words[4] = {stored, stored, stored, stored};
    if (format->decode != NULL) {
        format->decode(words, texture, 1);
    }
    return format->colors == &qtri_colors_565 ? qtri_pixel_565_to_888(words[0])
                                              : words[0] & 0xFFFFFFu;
}
