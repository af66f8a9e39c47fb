#include "fill_pairs.h"

#define LOOP(name) rgb565_##name
#define PIXEL      uint16_t
#include "fill.inc"

#define LOOP(name) xrgb8888_##name
#define PIXEL      uint32_t
#include "fill.inc"

#define LOOP(name) gray8_##name
#define PIXEL      uint8_t
#include "fill.inc"

static qtri_fill_rows flat_for(qtri_kind kind, bool less)
{
    switch (kind) {
    case QTRI_KIND_RGB565:
        if (less) {
            return QTRI_PAIRS ? qtri_fill_flat_pairs : rgb565_flat_less;
        }
        return rgb565_flat;
    case QTRI_KIND_XRGB8888:
        return less ? xrgb8888_flat_less : xrgb8888_flat;
    default:
        return less ? gray8_flat_less : gray8_flat;
    }
}

void qtri_fill_choose(qtri_raster *raster)
{
    bool less = raster->compare == QTRI_LESS && raster->depth_write;
    const qtri_kind kind = qtri_kind_of(raster->surface);
    raster->fill_flat = qtri_fill_spans;
    raster->fill_linear = qtri_fill_spans;
    raster->fill_tiny = qtri_fill_spans;
    raster->copy_run = qtri_run_generic;
    raster->small =
        QTRI_WITH_FAST_PATHS && less && kind == QTRI_KIND_RGB565 && raster->texture == NULL;
    if (!QTRI_WITH_FAST_PATHS) {
        return;
    }
    if (less || raster->compare == QTRI_DEPTH_OFF) {
        raster->fill_flat = flat_for(kind, less);
    }
    if (less && kind == QTRI_KIND_RGB565) {
        if (QTRI_WITH_SMOOTH) {
            raster->fill_tiny = qtri_fill_tiny_less;
            raster->fill_linear = QTRI_PAIRS ? qtri_fill_packed_pairs : qtri_fill_packed_less;
        }
        if (QTRI_WITH_TEXTURES) {
            raster->copy_run = QTRI_PAIRS ? qtri_run_copy_pairs : qtri_run_copy_less;
        }
    }
}
