/* SPDX-License-Identifier: MIT */
/*
 * Fragments of small triangles into the samples that they cover, after fog and blend.
 *
 * Fog knows nothing of samples: it changes the colour of a fragment. A blend reads each sample
 * that is covered, and what it reads is mostly the same in all of a pixel: so it is made once for
 * each colour that is stored there. Those lie in a row of pixels of the format without samples,
 * which the blend takes for the surface, as it does for large triangles (samples.c).
 */
#include "samples.h"

#include <string.h>

#include "effect.h"

QTRI_INLINE void scatter_records(const qtri_raster *raster, int32_t count, int32_t bytes,
                                 int32_t size)
{
    const uint32_t *place = raster->batch->place;
    const uint32_t *color = raster->batch->color;
    const ptrdiff_t pitch = raster->surface->pitch;
    uint8_t *pixels = raster->surface->pixels;
    for (const uint32_t *end = place + count; place != end; place++, color++) {
        const uint32_t at = *place;
        const uint32_t stored = *color;
        uint8_t *record = pixels + (ptrdiff_t)(at >> 16 & QTRI_SAMPLE_PLACE_MAX) * pitch +
                          (int32_t)(at & QTRI_SAMPLE_PLACE_MAX) * size;
#define SAMPLE(k, bit)                                                                             \
    if ((at >> (bit)&1) != 0) {                                                                    \
        qtri_sample_set_color(record, bytes, k, stored);                                           \
    }
        SAMPLE(0, QTRI_SAMPLE_LOW)
        SAMPLE(1, QTRI_SAMPLE_LOW + 1)
        SAMPLE(2, QTRI_SAMPLE_LOW + 2)
        SAMPLE(3, QTRI_SAMPLE_LAST)
#undef SAMPLE
    }
}

static void put_all(const qtri_raster *raster, int32_t count)
{
    if (raster->format->encode != NULL) {
        raster->format->encode(raster->batch->color, count);
    }
    const int32_t size = raster->format->pixels->bytes;
    if (!QTRI_SHARE && size == QTRI_RGB565_X4_BYTES) {
        scatter_records(raster, count, QTRI_RGB565_BYTES, QTRI_RGB565_X4_BYTES);
    } else {
        scatter_records(raster, count, qtri_sample_bytes(size), size);
    }
}

/* Columns and rows that are told apart; those as far from each other are taken for the same. */
enum { COLUMNS = 32, ROWS = 16 };

/* Colours that are read, each of some samples of a pixel. */
typedef struct mixed {
    qtri_raster raster; /* into `row` */
    qtri_surface surface;
    int32_t count;
    uint8_t samples[QTRI_BATCH];
    uint8_t *record[QTRI_BATCH];
    uint32_t seen[ROWS]; /* pixels whose colours these are */
    uint32_t row[QTRI_BATCH];
    uint32_t color[QTRI_BATCH_ROOM];
    uint32_t depth[QTRI_BATCH];
} mixed;

static void begin(mixed *m, const qtri_raster *raster)
{
    m->surface = *raster->surface;
    m->surface.format = raster->samples->format;
    m->surface.pixels = (uint8_t *)m->row;
    m->raster = *raster;
    m->raster.surface = &m->surface;
    m->raster.format = m->surface.format;
    m->count = 0;
    memset(m->seen, 0, sizeof m->seen);
}

/* Blends those that wait, and stores them. */
QTRI_INLINE void end_of(mixed *m, int32_t bytes)
{
    const qtri_raster *raster = &m->raster;
    const qtri_fragments at = {NULL, 0, NULL, m->depth};
    const int32_t count = m->count;
    if (count == 0) {
        return;
    }
    (void)raster->effects->fragments(raster, m->color, &at, qtri_mask_of(count), count);
    if (raster->format->encode != NULL) {
        raster->format->encode(m->color, count);
    }
    for (int32_t i = 0; i < count; i++) {
        for (int k = 0; k < QTRI_SAMPLES; k++) {
            if ((m->samples[i] >> k & 1) != 0) {
                qtri_sample_set_color(m->record[i], bytes, k, m->color[i]);
            }
        }
    }
    m->count = 0;
    memset(m->seen, 0, sizeof m->seen);
}

/* A fragment, of which some samples are covered: one for each colour that these have. */
QTRI_INLINE void append_of(mixed *m, uint8_t *record, uint32_t samples, uint32_t color,
                           uint32_t depth, int32_t bytes)
{
    int32_t n = m->count;
    for (int k = 0; samples != 0; k++) {
        if ((samples >> k & 1) == 0) {
            continue;
        }
        const uint32_t under = qtri_sample_color(record, bytes, k);
        uint32_t same = 1u << k;
        for (int i = k + 1; i < QTRI_SAMPLES; i++) {
            if ((samples >> i & 1) != 0 && qtri_sample_color(record, bytes, i) == under) {
                same |= 1u << i;
            }
        }
        samples &= ~same;
        qtri_stored_put(bytes, (uint8_t *)m->row + (ptrdiff_t)n * bytes, under);
        m->record[n] = record;
        m->samples[n] = (uint8_t)same;
        m->color[n] = color;
        m->depth[n] = depth;
        n++;
    }
    m->count = n;
}

QTRI_INLINE void blend_of(const qtri_raster *raster, uint32_t mask, int32_t count, int32_t bytes,
                          int32_t size)
{
    mixed m;
    const qtri_batch *batch = raster->batch;
    begin(&m, raster);
    mask <<= 32 - count;
    for (int32_t i = 0; mask != 0; i++, mask <<= 1) {
        if ((int32_t)mask >= 0) {
            continue;
        }
        const uint32_t place = batch->place[i];
        const uint32_t column = place & QTRI_SAMPLE_PLACE_MAX;
        const uint32_t row = place >> 16 & QTRI_SAMPLE_PLACE_MAX;
        const uint32_t bit = (uint32_t)1 << (column & (COLUMNS - 1));
        if (m.count > QTRI_BATCH - QTRI_SAMPLES || (m.seen[row & (ROWS - 1)] & bit) != 0) {
            end_of(&m, bytes);
        }
        m.seen[row & (ROWS - 1)] |= bit;
        uint8_t *record = raster->surface->pixels + (ptrdiff_t)row * raster->surface->pitch +
                          (int32_t)column * size;
        append_of(&m, record, qtri_samples_in(place), batch->color[i], batch->depth[i], bytes);
    }
    end_of(&m, bytes);
}

QTRI_NOINLINE static void blend(const qtri_raster *raster, uint32_t mask, int32_t count)
{
    const int32_t size = raster->format->pixels->bytes;
    if (!QTRI_SHARE && size == QTRI_RGB565_X4_BYTES) {
        blend_of(raster, mask, count, QTRI_RGB565_BYTES, QTRI_RGB565_X4_BYTES);
    } else {
        blend_of(raster, mask, count, qtri_sample_bytes(size), size);
    }
}

/* Fragments that are turned away have no samples. */
static void drop(qtri_batch *batch, uint32_t mask, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        if ((mask >> (count - 1 - i) & 1) == 0) {
            batch->place[i] &= QTRI_SAMPLE_PLACE;
        }
    }
}

void qtri_samples_put(const qtri_raster *raster, uint32_t mask, int32_t count)
{
    qtri_batch *batch = raster->batch;
    if (raster->late != NULL) {
        if (raster->blend != NULL && !raster->blend->rejects) {
            blend(raster, mask, count);
            return;
        }
        if (raster->effects != NULL) { /* nothing is read: samples in places do not matter */
            const qtri_fragments at = {batch->place, *batch->place, NULL, batch->depth};
            mask = raster->effects->fragments(raster, batch->color, &at, mask, count);
        }
        drop(batch, mask, count);
    }
    put_all(raster, count);
}
