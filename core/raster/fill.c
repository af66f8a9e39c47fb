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

void qtri_fill_choose(qtri_raster *raster)
{
    static const qtri_fill_rows flat[3][2] = {{rgb565_flat, rgb565_flat_less},
                                              {xrgb8888_flat, xrgb8888_flat_less},
                                              {gray8_flat, gray8_flat_less}};
    bool less = raster->compare == QTRI_LESS && raster->depth_write;
    qtri_format format = raster->surface->format;
    raster->fill_flat = qtri_fill_spans;
    raster->fill_linear = qtri_fill_spans;
    raster->fill_tiny = qtri_fill_spans;
    raster->copy_run = qtri_run_generic;
    raster->tiny = less && format == QTRI_RGB565 && raster->texture == NULL;
    if (less || raster->compare == QTRI_DEPTH_OFF) {
        raster->fill_flat = flat[format <= QTRI_GRAY8 ? format : QTRI_GRAY8][less];
    }
    if (less && format == QTRI_RGB565) {
        raster->fill_tiny = qtri_fill_tiny_less;
#if QTRI_PAIRS
        raster->fill_flat = qtri_fill_flat_pairs;
        raster->fill_linear = qtri_fill_packed_pairs;
        raster->copy_run = qtri_run_copy_pairs;
#else
        raster->fill_linear = qtri_fill_packed_less;
        raster->copy_run = qtri_run_copy_less;
#endif
    }
}
