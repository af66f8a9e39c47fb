/* SPDX-License-Identifier: MIT */
/*
 * Blends and fog, with pipelines for RGB565 with those that are used most: for
 * depths that are read only, as most that is seen through is drawn, and for others.
 */
#include "qtri/error.h"
#include "qtri/pipeline_make.h"
#include "qtri/q16.h"

#include "../bits/bits.h"
#include "descriptions.h"

#define LESS                                                                                       \
    .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS, .read_only = QTRI_ANY
#define TEXTURE .texel = QTRI_TEXEL_RGB565

/* Blends --------------------------------------------------------------------------------------- */

#define OVER(BLEND) LESS, .blend = (BLEND)
#define SPRITE      .texel = QTRI_TEXEL_ARGB4444

QTRI_PIPELINE(qtri_pipeline_alpha, OVER(QTRI_ALPHA))
QTRI_PIPELINE(qtri_pipeline_alpha_lit, OVER(QTRI_ALPHA), .shade = QTRI_LIGHT)
QTRI_PIPELINE(qtri_pipeline_alpha_colors, OVER(QTRI_ALPHA), .shade = QTRI_COLORS)
QTRI_PIPELINE(qtri_pipeline_alpha_vertex, OVER(QTRI_ALPHA), .shade = QTRI_COLORS, .vertex_alpha = 1)
QTRI_PIPELINE(qtri_pipeline_alpha_texture, OVER(QTRI_ALPHA), TEXTURE)
QTRI_PIPELINE(qtri_pipeline_alpha_texture_lit, OVER(QTRI_ALPHA), TEXTURE, .shade = QTRI_LIGHT)
QTRI_PIPELINE(qtri_pipeline_alpha_texture_white, OVER(QTRI_ALPHA), TEXTURE,
              .shade = QTRI_WHITE_LIGHT)
QTRI_PIPELINE(qtri_pipeline_alpha_sprite, OVER(QTRI_ALPHA), SPRITE)

static const qtri_pipeline *const by_alpha[] = {&qtri_pipeline_alpha,
                                                &qtri_pipeline_alpha_lit,
                                                &qtri_pipeline_alpha_colors,
                                                &qtri_pipeline_alpha_vertex,
                                                &qtri_pipeline_alpha_texture,
                                                &qtri_pipeline_alpha_texture_lit,
                                                &qtri_pipeline_alpha_texture_white,
                                                &qtri_pipeline_alpha_sprite,
                                                NULL};

QTRI_PIPELINE(qtri_pipeline_add, OVER(QTRI_ADD))
QTRI_PIPELINE(qtri_pipeline_add_colors, OVER(QTRI_ADD), .shade = QTRI_COLORS)
QTRI_PIPELINE(qtri_pipeline_add_texture, OVER(QTRI_ADD), TEXTURE)

static const qtri_pipeline *const adding[] = {&qtri_pipeline_add, &qtri_pipeline_add_colors,
                                              &qtri_pipeline_add_texture, NULL};

QTRI_PIPELINE(qtri_pipeline_multiply, OVER(QTRI_MULTIPLY))
QTRI_PIPELINE(qtri_pipeline_multiply_texture, OVER(QTRI_MULTIPLY), TEXTURE)

static const qtri_pipeline *const multiplying[] = {&qtri_pipeline_multiply,
                                                   &qtri_pipeline_multiply_texture, NULL};

static void begin(qtri_draw_state *state, const qtri_material *material)
{
    qtri_options *o = &state->options;
    const qtri_blend *blend = material->blend;
    const uint8_t keep = material->keep & 7;
    o->blend = blend->kind;
    o->vertex_alpha = blend->by_vertex && material->alphas != NULL;
    if (blend->kind != QTRI_SCREEN_DOOR && blend->kind != QTRI_KEEP_PIXEL) {
        if (keep == 7) {
            o->blend = QTRI_KEEP_PIXEL;
            o->vertex_alpha = 0;
        } else {
            o->keep = keep != 0 && o->format != QTRI_GRAY8;
        }
    }
    state->alpha = material->alpha + (material->alpha >> 7);
    state->keep = (keep & QTRI_KEEP_RED ? 0xFF0000u : 0) | (keep & QTRI_KEEP_GREEN ? 0xFF00u : 0) |
                  (keep & QTRI_KEEP_BLUE ? 0xFFu : 0);
    if (qtri_kind_of(o) == QTRI_IN_565) {
        state->keep = qtri_pixel_888_to_565(state->keep);
    }
}

static const qtri_effect alpha = {by_alpha, qtri_blended_loop};
static const qtri_effect add = {adding, qtri_blended_loop};
static const qtri_effect multiply = {multiplying, qtri_blended_loop};
const qtri_blend qtri_blend_alpha = {QTRI_ALPHA, false, QTRI_EFFECT(alpha), begin};
const qtri_blend qtri_blend_vertex_alpha = {QTRI_ALPHA, true, QTRI_EFFECT(alpha), begin};
const qtri_blend qtri_blend_add = {QTRI_ADD, false, QTRI_EFFECT(add), begin};
const qtri_blend qtri_blend_vertex_add = {QTRI_ADD, true, NULL, begin};
const qtri_blend qtri_blend_multiply = {QTRI_MULTIPLY, false, QTRI_EFFECT(multiply), begin};
const qtri_blend qtri_blend_none = {QTRI_KEEP_PIXEL, false, NULL, begin};
const qtri_blend qtri_blend_replace = {QTRI_STORE, false, NULL, begin};
const qtri_blend qtri_blend_screen_door = {QTRI_SCREEN_DOOR, false, NULL, begin};

/* Fog ------------------------------------------------------------------------------------------ */

QTRI_BROUGHT_PIPELINES(qtri_pipelines_fog, LESS, .fog = 1)

static const qtri_effect fogged = {qtri_pipelines_fog, qtri_fogged_loop};

/* Describes all of a fog but its shares. */
static void begin_fog(qtri_fog *fog, qtri_rgb color)
{
    fog->color = qtri_pixel_rgb_to_888(&color);
    fog->effect = QTRI_EFFECT(fogged);
}

static int64_t linear(q16 z, q16 start, q16 end)
{
    if (end <= start) {
        return z <= start ? Q16_ONE : 0;
    }
    bool unused;
    const int64_t rest = (int64_t)end - z;
    const uint64_t share =
        qtri_divide64(qtri_magnitude64(rest), (uint64_t)((int64_t)end - start), 16, &unused);
    return rest < 0 ? -(int64_t)share : (int64_t)share;
}

static int64_t exponential(q16 z, q16 density, q16 unused)
{
    (void)unused;
    return q16_exp(-q16_mul(density, z));
}

static int64_t squared(q16 z, q16 density, q16 unused)
{
    const q16 x = q16_mul(density, z);
    (void)unused;
    return q16_exp(-q16_mul(x, x));
}

void qtri_fog_linear(qtri_fog *fog, qtri_rgb color, qtri_fog_range range, q16 start, q16 end)
{
    QTRI_ASSERT(fog != NULL);
    begin_fog(fog, color);
    qtri_fog_set(fog, range, start, end, linear, start, end);
}

/* e^-8 is less than half of 1/1024. */
void qtri_fog_exp(qtri_fog *fog, qtri_rgb color, qtri_fog_range range, q16 density)
{
    QTRI_ASSERT(fog != NULL);
    density = qtri_greatest32(density, 0);
    begin_fog(fog, color);
    qtri_fog_set(fog, range, 0, density == 0 ? INT32_MAX : q16_div((q16)8 * Q16_ONE, density),
                 exponential, density, 0);
}

void qtri_fog_exp2(qtri_fog *fog, qtri_rgb color, qtri_fog_range range, q16 density)
{
    QTRI_ASSERT(fog != NULL);
    density = qtri_greatest32(density, 0);
    begin_fog(fog, color);
    qtri_fog_set(fog, range, 0, density == 0 ? INT32_MAX : q16_div((q16)3 * Q16_ONE, density),
                 squared, density, 0);
}
