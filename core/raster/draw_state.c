/* SPDX-License-Identifier: MIT */
#include "draw_state.h"

#include <string.h>

#include "checked_material.h"
#include "descriptions.h"
#include "qtri/body/pixel.h"
#include "samples.h"

enum {
    NEAR = 33 * 256 /* 24.8: reach of a small triangle that is not wide, and a pixel */
};

static bool is_usable(const qtri_texture *texture)
{
    return texture != NULL && texture->format != NULL && texture->format->usable(texture);
}

static void set_traits(qtri_draw_state *state, uint32_t texels_log2)
{
    const qtri_texture *texture = state->texture;
    const bool is_wide = state->width_log2 != 0, is_high = state->height_log2 != 0;
    state->traits =
        (uint8_t)((is_wide && texture->wrap_u == QTRI_CLAMP ? QTRI_CLAMPS_U : 0) |
                  (is_high && texture->wrap_v == QTRI_CLAMP ? QTRI_CLAMPS_V : 0) |
                  (is_wide ? 0 : QTRI_ONE_WIDE) | (texels_log2 < 8 ? QTRI_FEW_TEXELS : 0));
}

static void set_texture(qtri_draw_state *state, const qtri_texture *texture)
{
    qtri_options *o = &state->options;
    o->texel = texture->format->kind != QTRI_NO_TEXEL ? texture->format->kind : QTRI_OTHER_TEXEL;
    if (texture->filter != NULL) {
        state->between = texture->filter->between;
        o->bilinear = state->between != NULL;
        o->mipmapped = texture->filter->levels != NULL;
    }
    o->key = texture->has_key;
    o->alpha_test = state->material->least_alpha != 0 && qtri_has_alpha(o);
    state->texture = texture;
    state->width_log2 = qtri_side_log2(texture->width_log2);
    state->height_log2 = qtri_side_log2(texture->height_log2);
    set_traits(state, state->width_log2 + state->height_log2);
    /* What the library computes in 2^16 texels at most fits one mask. */
    o->large_texture = state->width_log2 + state->height_log2 > 16;
    state->key_mask = texture->format->key_mask;
    state->key = texture->key & state->key_mask;
    state->alpha_least = (uint32_t)state->material->least_alpha << 24;
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

/* A copy of a known format whose pixels have other bytes is user-defined. */
static void set_format(qtri_options *o, const qtri_format *format)
{
    const qtri_sampling *samples = format->samples;
    const uint8_t bytes = (samples != NULL ? samples->format : format)->pixels->bytes;
    o->format = format->kind;
    if (qtri_pixel_bytes(o) != bytes) {
        o->format = QTRI_OTHER_FORMAT;
        o->pixel_bytes = bytes;
    }
}

/* Sets options, all of which are 0 before, and the texture. */
static void set_options(qtri_draw_state *state, const qtri_texture *texture, int shade)
{
    qtri_options *o = &state->options;
    const qtri_surface *surface = state->surface;
    const qtri_material *material = state->material;
    const qtri_depth_format *depth = surface->depth_format;
    set_format(o, surface->format);
    if (surface->depth != NULL && material->depth_compare != QTRI_DEPTH_OFF) {
        o->depth = depth == NULL || depth->ops == NULL ? QTRI_LINEAR16
                   : depth->kind != QTRI_NO_DEPTH      ? depth->kind
                                                       : QTRI_OTHER_DEPTH;
        o->compare = (uint8_t)qtri_compare_of(material);
        o->read_only = material->depth_read_only;
    }
    if (is_usable(texture)) {
        set_texture(state, texture);
    }
    o->covered = (shade & QTRI_COVERED) != 0;
    shade &= ~QTRI_COVERED;
    o->shade = shade_of(o, material, shade == QTRI_BY_PIXEL ? QTRI_COLORS : shade);
    o->per_pixel = shade == QTRI_BY_PIXEL && o->shade == QTRI_COLORS;
    o->fog = material->fog != NULL && material->fog->is_set;
    o->fragment = material->fragment;
    if (qtri_sampling_of(surface->format) != NULL) {
        o->samples = 4;
        o->mipmapped = 0;
        o->depth = o->depth != QTRI_NO_DEPTH ? QTRI_LINEAR16 : QTRI_NO_DEPTH;
    }
    if (o->mipmapped) {
        texture->filter->levels->begin(state);
    }
}

/* Whether a pipeline's options are these, or any; formats of the application are not compared. */
static bool are_equal(const qtri_options *of_pipeline, const qtri_options *wanted)
{
    const uint8_t *x = (const uint8_t *)of_pipeline;
    const uint8_t *y = (const uint8_t *)wanted;
    size_t i = 0;
    while (i < offsetof(qtri_options, pixel_bytes) && (x[i] == y[i] || x[i] == QTRI_ANY)) {
        i++;
    }
    return i == offsetof(qtri_options, pixel_bytes);
}

/* User-defined formats are compared by their addresses, where a pipeline names them. */
static bool fits(const qtri_pipeline *pipeline, const qtri_draw_state *state)
{
    const qtri_options *o = &pipeline->options;
    const qtri_options *wanted = &state->options;
    if (o->format >= QTRI_BROUGHT) { /* without samples: see find_all() */
        return o->samples == 0 || wanted->samples != 0;
    }
    return are_equal(o, wanted) && o->fragment == wanted->fragment &&
           (o->format != QTRI_OTHER_FORMAT ||
            (o->own_format == state->surface->format && o->pixel_bytes == wanted->pixel_bytes)) &&
           (o->texel != QTRI_OTHER_TEXEL || o->own_texel == state->texture->format);
}

/* The first of a list that fits; NULL: none. */
static const qtri_pipeline *find(const qtri_pipeline *const *list, const qtri_draw_state *state)
{
    while (list != NULL && *list != NULL && !fits(*list, state)) {
        list++;
    }
    return list != NULL ? *list : NULL;
}

/* One of the lists of the surface's depth format and the material's blend, fog and filter. */
static const qtri_pipeline *find_brought(const qtri_pipeline *pipeline, qtri_draw_state *state)
{
    (void)pipeline;
    const qtri_depth_format *depth = state->surface->depth_format;
    const qtri_material *material = state->material;
    const qtri_filter *filter = state->texture != NULL ? state->texture->filter : NULL;
    const qtri_pipeline *const *const brought[] = {
        depth != NULL ? qtri_effect_pipelines(depth->effect) : NULL,
        material->blend != NULL ? qtri_effect_pipelines(material->blend->effect) : NULL,
        material->fog != NULL ? qtri_effect_pipelines(material->fog->effect) : NULL,
        filter != NULL ? qtri_effect_pipelines(filter->effect) : NULL};
    const qtri_pipeline *found = NULL;
    for (size_t i = 0; i < sizeof brought / sizeof *brought && found == NULL; i++) {
        found = find(brought[i], state);
    }
    return found;
}

const qtri_pipeline qtri_pipeline_brought = {.options = {.format = QTRI_BROUGHT},
                                             .choose = find_brought};

static const qtri_pipeline *chosen_by(const qtri_pipeline *pipeline, qtri_draw_state *state)
{
    return pipeline->choose != NULL ? pipeline->choose(pipeline, state) : pipeline;
}

/* The pipeline for a state, NULL if none fits. The generic one for samples is reached through the
   format, as views list the other. */
static const qtri_pipeline *find_all(const qtri_pipeline *const *list, qtri_draw_state *state)
{
    const qtri_pipeline *found = NULL;
    for (; list != NULL && *list != NULL && found == NULL; list++) {
        found = fits(*list, state) ? chosen_by(*list, state) : NULL;
    }
    if (found != NULL && found->options.format == QTRI_ANY &&
        found->options.samples != state->options.samples) {
        found = chosen_by(find(qtri_sampling_of(state->surface->format)->pipelines, state), state);
    }
    return found;
}

const qtri_pipeline *qtri_draw_state_ask(const qtri_pipeline *generic, qtri_draw_state *state)
{
    qtri_options *o = &state->options;
    const bool asks[] = {
        [QTRI_ASK_565] = qtri_stores_565(o),          [QTRI_ASK_ALPHA] = qtri_has_alpha(o),
        [QTRI_ASK_ALPHA_USED] = qtri_uses_alpha(o),   [QTRI_ASK_TWO_WORDS] = qtri_has_two_words(o),
        [QTRI_ASK_PACKED] = qtri_is_packed_565(o),    [QTRI_ASK_TABLE] = qtri_uses_table(o),
        [QTRI_ASK_TEST] = qtri_tests_depth(o),        [QTRI_ASK_WRITE] = qtri_writes_depth(o),
        [QTRI_ASK_DEPTH] = qtri_needs_depth(o),       [QTRI_ASK_PLACE] = qtri_needs_place(o),
        [QTRI_ASK_DISCARD] = qtri_discards(o),        [QTRI_ASK_READ] = qtri_reads_pixel(o),
        [QTRI_ASK_PLAIN] = qtri_has_constant_color(o)};
    o->pixel_bytes = (uint8_t)qtri_pixel_bytes(o);
    o->depth_bytes = (uint8_t)qtri_depth_size(o, state->surface);
    o->asks = (uint16_t)qtri_kind_of(o);
    for (uint32_t i = QTRI_ASK_565; i <= QTRI_ASK_PLAIN; i++) {
        o->asks |= (uint16_t)(asks[i] << i);
    }
    return generic;
}

static void set_bounds(qtri_draw_state *state, const qtri_surface *surface)
{
    state->bounds = qtri_surface_bounds(surface);
    const qtri_rect *b = &state->bounds;
    const int32_t width = (b->x1 - b->x0) * 256 - 2 * NEAR;
    const int32_t height = (b->y1 - b->y0) * 256 - 2 * NEAR;
    state->inner.x = (uint32_t)(b->x0 * 256 + NEAR);
    state->inner.y = (uint32_t)(b->y0 * 256 + NEAR);
    state->inner.width = width < 0 ? 0 : (uint32_t)width;
    state->inner.height = height < 0 ? 0 : (uint32_t)height;
}

static void set_colors(qtri_draw_state *state, const qtri_material *material)
{
    const qtri_options *o = &state->options;
    state->color = qtri_pixel_rgb_to_888(&material->color);
    state->weight[0] = material->color.r + (material->color.r >> 7);
    state->weight[1] = material->color.g + (material->color.g >> 7);
    state->weight[2] = material->color.b + (material->color.b >> 7);
    if (o->fog) {
        state->fog = material->fog;
        const qtri_color_kind kind = qtri_kind_of(o);
        const uint32_t color = material->fog->color;
        state->fog_color = kind == QTRI_IN_GRAY       ? qtri_pixel_888_to_luma(color)
                           : kind == QTRI_IN_FINE_565 ? qtri_pixel_888_to_fine(color)
                                                      : color;
    }
}

void qtri_draw_state_set_level(qtri_draw_state *state, uint32_t level)
{
    const qtri_texture *whole = state->material->texture;
    qtri_texture *texture = &state->level_texture;
    const uint32_t height_log2 = state->height_log2;
    state->level = (uint8_t)level;
    texture->texels = level == 0 ? whole->texels : whole->levels[level - 1];
    texture->width_log2 = (uint8_t)(state->width_log2 - level);
    texture->height_log2 = (uint8_t)(height_log2 - (level < height_log2 ? level : height_log2));
    set_traits(state, (uint32_t)texture->width_log2 + texture->height_log2);
}

/* Mipmapped: called through the filter, so that only programs that name one link it. */
bool qtri_small_set_level(const qtri_small_place *p, const qtri_small *t)
{
    return t->state->texture->filter->levels->set_small(p, t);
}

void qtri_large_set_levels(qtri_large *t)
{
    t->state->texture->filter->levels->set_large(t);
}

int32_t qtri_large_next_levels(qtri_large *t)
{
    return t->state->texture->filter->levels->next(t);
}

/* A pipeline that draws nothing. */
static void draw_nothing(const struct qtri_large_input *triangle)
{
    (void)triangle;
}

static bool draw_nothing_small(struct qtri_small *triangle)
{
    (void)triangle;
    return true;
}

static const qtri_pipeline nothing = {
    .large = draw_nothing, .small = draw_nothing_small, .span = NULL};

/* Records of samples have room for linear16 alone. */
static bool has_room(const qtri_surface *surface)
{
    return qtri_sampling_of(surface->format) == NULL || surface->depth == NULL ||
           surface->depth_format == NULL || surface->depth_format->ops == NULL;
}

static void set_pipeline(qtri_draw_state *state, const qtri_pipeline *pipeline)
{
    const qtri_depth_shift *shift = state->material->depth_shift;
    state->pipeline = pipeline;
    state->small = shift != NULL ? shift->small : pipeline->small;
}

void qtri_draw_state_init(qtri_draw_state *state, const qtri_surface *surface,
                          const qtri_pipeline *const *pipelines, const qtri_material *material,
                          const qtri_texture *texture, int shade)
{
    memset(state, 0, offsetof(qtri_draw_state, inner)); /* options, and bounds that hold nothing */
    state->texture = NULL;
    state->between = NULL;
    state->light_walk = NULL;
    state->has_linear_light = NULL;
    state->pipeline = &nothing;
    state->small = draw_nothing_small;
    state->surface = surface;
    state->material = material;
    state->alphas = material->alphas;
    if (surface->format == NULL || !has_room(surface) ||
        (surface->depth != NULL && material->depth_compare == QTRI_NEVER)) {
        return;
    }
    set_options(state, texture, shade);
    state->alpha = 256;
    state->keep = 0;
    if (material->blend != NULL) {
        material->blend->begin(state, material);
    }
    state->is_linear = material->interpolation != QTRI_PERSPECTIVE;
    set_bounds(state, surface);
    state->depth = surface->depth;
    state->depth_pitch =
        surface->depth_pitch * (ptrdiff_t)qtri_depth_size(&state->options, surface);
    set_colors(state, material);
    const qtri_pipeline *found = find_all(pipelines, state);
#ifdef QTRI_CHECKED
    qtri_check_pipeline(found, &state->options);
#endif
    if (found == NULL) {
        return;
    }
    set_pipeline(state, found);
    if (found->options.format != QTRI_ANY) {
        const uint8_t read_only = state->options.read_only, compare = state->options.compare;
        state->options = found->options;
        state->options.read_only = read_only;
        state->options.compare = compare;
    }
}

void qtri_draw_state_prefer(qtri_draw_state *state, const qtri_pipeline *const *pipelines)
{
    if (state->pipeline->options.format == QTRI_ANY) {
        const qtri_pipeline *found = find(pipelines, state);
        if (found != NULL) {
            set_pipeline(state, found);
        }
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
