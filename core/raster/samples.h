/* SPDX-License-Identifier: MIT */
/*
 * Surfaces with four samples a pixel: see qtri/antialias.h. Internal.
 *
 * A pixel is a record: four stored colours, then the depths of samples 1 to 3; that of sample 0 is
 * the surface's.
 */
#ifndef QTRI_RASTER_SAMPLES_H
#define QTRI_RASTER_SAMPLES_H

#include <stddef.h>

#include "qtri/antialias.h"
#include "qtri/pipeline.h"

#include "../frame/pixel.h"

/* What a format of four samples a pixel points to. */
struct qtri_sampling {
    const qtri_format *format; /* of resolved pixels */
    /* For surfaces for which a view's list has only the generic pipeline; the last one fits any. */
    const qtri_pipeline *const *pipelines;
};

/* Draws whatever is asked for on surfaces with samples; and lists that formats name: of any format,
   and of RGB565. */
extern const qtri_pipeline qtri_pipeline_any_x4;
extern const qtri_pipeline *const qtri_pipelines_x4[], *const qtri_pipelines_rgb565_x4[];

/* NULL: one sample a pixel. */
static inline const qtri_sampling *qtri_sampling_of(const qtri_format *format)
{
    return format != NULL ? format->samples : NULL;
}

enum {
    QTRI_SAMPLES = 4,
    QTRI_SAMPLE_DEPTHS = 6 /* bytes of depths after the colours; padding may follow */
};

/* The mean of a record as a stored pixel. */
uint32_t qtri_samples_mean(const qtri_format *format, const uint8_t *record);

/* Bytes of a colour in records of `size` bytes: 10, 14, 18 and 24. */
static inline int32_t qtri_sample_bytes(int32_t size)
{
    return (size - QTRI_SAMPLE_DEPTHS) / QTRI_SAMPLES;
}

/* Colour `k` of a record. */
static inline uint32_t qtri_sample_color(const uint8_t *record, int32_t bytes, int32_t k)
{
    return qtri_load((uint32_t)bytes, record + (ptrdiff_t)k * bytes);
}

static inline void qtri_sample_set_color(uint8_t *record, int32_t bytes, int32_t k, uint32_t stored)
{
    qtri_save((uint32_t)bytes, record + (ptrdiff_t)k * bytes, stored);
}

/* Depth `k`, 1 to 3, of a record whose colours have so many bytes. */
static inline uint16_t *qtri_sample_depth(uint8_t *record, int32_t bytes, int32_t k)
{
    return (uint16_t *)(void *)(record + QTRI_SAMPLES * bytes) + (k - 1);
}

/* As in qtri_pixels, for records of `size` bytes: all samples of a pixel get one colour. */
void qtri_samples_fill(uint8_t *pixel, uint32_t stored, uint32_t mask, int32_t count, int32_t size);
void qtri_samples_store(uint8_t *pixel, const uint32_t *stored, uint32_t mask, int32_t count,
                        int32_t size);

#endif
