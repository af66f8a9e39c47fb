/* SPDX-License-Identifier: MIT */
/* Filters of textures, with pipelines for RGB565 with those that are used most. */
#include "qtri/pipeline_make.h"

#include "descriptions.h"

#define FILTERED                                                                                   \
    .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS, .read_only = QTRI_ANY,    \
    .texel = QTRI_TEXEL_RGB565, .bilinear = 1

QTRI_PIPELINE(qtri_pipeline_bilinear, FILTERED)
QTRI_PIPELINE(qtri_pipeline_bilinear_lit, FILTERED, .shade = QTRI_LIGHT)
QTRI_PIPELINE(qtri_pipeline_bilinear_white, FILTERED, .shade = QTRI_WHITE_LIGHT)

static const qtri_pipeline *const between[] = {&qtri_pipeline_bilinear, &qtri_pipeline_bilinear_lit,
                                               &qtri_pipeline_bilinear_white, NULL};

#define MIPMAPPED                                                                                  \
    .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS,                           \
    .texel = QTRI_TEXEL_RGB565, .mipmapped = 1

QTRI_PIPELINE(qtri_pipeline_mipmapped, MIPMAPPED)
QTRI_PIPELINE(qtri_pipeline_mipmapped_lit, MIPMAPPED, .shade = QTRI_LIGHT)
QTRI_PIPELINE(qtri_pipeline_mipmapped_white, MIPMAPPED, .shade = QTRI_WHITE_LIGHT)

static const qtri_pipeline *const by_level[] = {
    &qtri_pipeline_mipmapped, &qtri_pipeline_mipmapped_lit, &qtri_pipeline_mipmapped_white, NULL};

/* Levels that can be used besides the first: their widths are 2 texels or more. */
static uint8_t last_level(const qtri_texture *texture)
{
    const int32_t width_log2 = qtri_side_log2(texture->width_log2);
    uint8_t last = 0;
    if (texture->levels != NULL) {
        while (last + 1 < width_log2 && last < texture->level_count &&
               texture->levels[last] != NULL) {
            last++;
        }
    }
    return last;
}

static void begin_levels(qtri_draw_state *state)
{
    state->level_texture = *state->texture;
    state->last_level = last_level(state->texture);
    state->texture = &state->level_texture;
    qtri_draw_state_set_level(state, 0);
}

const qtri_filter qtri_bilinear = {true, false, QTRI_BROUGHT_LIST(between), NULL};
const qtri_filter qtri_mipmapped = {false, true, QTRI_BROUGHT_LIST(by_level), begin_levels};
const qtri_filter qtri_mipmapped_bilinear = {true, true, NULL, begin_levels};
