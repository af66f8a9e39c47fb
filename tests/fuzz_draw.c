/* SPDX-License-Identifier: MIT */
/*
 * Fuzz target: arbitrary bytes as a drawing (support/draw_bytes.c). Nothing may trap, overflow or
 * write outside the surface; `make fuzz` runs it under AddressSanitizer and UBSan. It is drawn
 * again by a list of pipelines that the bytes choose: where that ends with the generic one, the
 * same.
 */
#include <qtri/pipeline_make.h>
#include <stdlib.h>

#include "support/draw_bytes.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { PIECES = 6 };

#define TEXTURED .texel = QTRI_TEXEL_RGB565

QTRI_PIPELINE(own_texture, .format = QTRI_RGB565, TEXTURED)
QTRI_PIPELINE(own_less_equal, .format = QTRI_RGB565, .depth = QTRI_LINEAR16,
              .compare = QTRI_LESS_EQUAL, .shade = QTRI_COLORS)
QTRI_PIPELINE(own_always, .format = QTRI_XRGB8888, .depth = QTRI_LINEAR16, .compare = QTRI_ALWAYS,
              TEXTURED, .wrap_u = QTRI_CLAMP, .shade = QTRI_COLORS)
QTRI_PIPELINE(own_plain, .format = QTRI_XRGB8888)
QTRI_PIPELINE(own_gray, .format = QTRI_GRAY8, .shade = QTRI_COLORS)
QTRI_PIPELINE(own_large, .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS,
              TEXTURED, .large_texture = 1)
QTRI_PIPELINE(own_blend, .format = QTRI_RGB888, TEXTURED, .blend = QTRI_ALPHA, .keep = 1)

static const qtri_pipeline *const known[] = {
    &own_texture,
    &own_less_equal,
    &own_always,
    &own_plain,
    &own_gray,
    &own_large,
    &own_blend,
    &qtri_pipeline_flat,
    &qtri_pipeline_lit,
    &qtri_pipeline_colors,
    &qtri_pipeline_texture,
    &qtri_pipeline_texture_tint,
    &qtri_pipeline_texture_lit,
    &qtri_pipeline_texture_white,
    &qtri_pipeline_mipmapped_lit,
    &qtri_pipeline_swapped_lit,
    &qtri_pipeline_swapped_colors,
    &qtri_pipeline_any,
};

/* Any of the known ones, in any order; the generic one stands last in half of the lists. */
static void choose(uint32_t seed, const qtri_pipeline *list[PIECES + 2])
{
    int count = 0;
    for (; count < PIECES && seed % 16 != 0; count++) {
        seed = seed * 1664525u + 1013904223u;
        list[count] = known[(seed >> 16) % (sizeof known / sizeof known[0])];
        seed ^= seed >> 15;
    }
    if (seed & 16) {
        list[count++] = &qtri_pipeline_any;
    }
    list[count] = NULL;
}

static bool draws_all(const qtri_pipeline *const *list)
{
    while (*list != NULL && *list != &qtri_pipeline_any) {
        list++;
    }
    return *list != NULL;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const qtri_pipeline *list[PIECES + 2];
    const uint32_t expected = draw_bytes(data, size, qtri_pipelines_default);
    uint32_t seed = 2166136261u;
    for (size_t i = 0; i < size; i++) {
        seed = (seed ^ data[i]) * 16777619u;
    }
    choose(seed, list);
    const uint32_t drawn = draw_bytes(data, size, seed % 64 == 0 ? NULL : list);
    if (seed % 64 != 0 && draws_all(list) && drawn != expected) {
        abort();
    }
    return 0;
}
