/* SPDX-License-Identifier: MIT */
/*
 * Pixels of four samples. Internal, part of the pipelines' body (pipeline_make.h).
 *
 * A pixel is a record: four stored colours, then the depths of samples 1 to 3, of 16 bits; that of
 * sample 0 is the surface's. Samples lie at (-32, -96), (96, -32), (-96, 32) and (32, 96) from the
 * pixel's centre, 1/256 pixel, so what is linear on the screen has p more at sample 3, -p at 0, q
 * at 1 and -q at 2. A set of samples is a word: bit 7 + 8 k is sample k.
 *
 * A pixel takes its colour at its centre, or, where the triangle does not cover that, at the first
 * sample that it covers; a depth of the walk is the centre's.
 */
#ifndef QTRI_BODY_SAMPLES_H
#define QTRI_BODY_SAMPLES_H

#include "stored.h"

#define QTRI_SAMPLE_0    0x80u
#define QTRI_SAMPLE_1    0x8000u
#define QTRI_SAMPLE_2    0x800000u
#define QTRI_SAMPLE_3    0x80000000u
#define QTRI_SAMPLES_ALL 0x80808080u

enum { QTRI_CENTER = 4, QTRI_PLACES }; /* samples, and the centre */

/* A linear value at a place, sample 0..3 or QTRI_CENTER, less that at the centre. */
QTRI_BODY uint32_t qtri_samples_more(int32_t place, uint32_t p, uint32_t q)
{
    return place == QTRI_CENTER ? 0
           : place == 0         ? 0u - p
           : place == 1         ? q
           : place == 2         ? 0u - q
                                : p;
}

/* A row of a large triangle. Sample k, or the centre, is covered from left[k] to before right[k];
   `count` pixels from x0 on are so wholly. */
typedef struct qtri_samples_row {
    int32_t x0;
    uint32_t count;
    int32_t left[QTRI_PLACES], right[QTRI_PLACES];
} qtri_samples_row;

/* The samples in column x that are covered. */
QTRI_BODY uint32_t qtri_samples_of(const qtri_samples_row *row, int32_t x)
{
    uint32_t samples = 0;
    if ((uint32_t)x - (uint32_t)row->x0 < row->count) {
        return QTRI_SAMPLES_ALL;
    }
    for (int k = QTRI_CENTER - 1; k >= 0; k--) {
        samples = samples << 8 | (x >= row->left[k] && x < row->right[k] ? QTRI_SAMPLE_0 : 0);
    }
    return samples;
}

/* Tests one sample at a depth of 16.16; returns the samples without it if it fails. */
QTRI_BODY uint32_t qtri_sample_test(const qtri_options *o, const qtri_pixel_walk *w,
                                    uint32_t samples, uint32_t sample, uint8_t *depth,
                                    uint32_t z_16p16)
{
    if ((samples & sample) == 0) {
        return samples;
    }
    const uint32_t z = z_16p16 >> 16;
    if (!qtri_depth_passes(o, w, z, qtri_load(2, depth))) {
        return samples & ~sample;
    }
    QTRI_BODY_BRANCH();
    if (qtri_pixel_writes(o, w) && !qtri_discards(o)) {
        qtri_save(2, depth, z);
    }
    return samples;
}

/* Those of w->samples that pass the depth test; depths are written if no option discards pixels. */
QTRI_BODY uint32_t qtri_samples_test(const qtri_options *o, const qtri_pixel_walk *w,
                                     uint8_t *pixel, uint8_t *depth)
{
    uint32_t samples = w->samples;
    if (qtri_tests_depth(o) && samples != 0) {
        uint8_t *more = pixel + 4 * qtri_pixel_bytes(o);
        samples = qtri_sample_test(o, w, samples, QTRI_SAMPLE_0, depth, w->z - w->z_p);
        samples = qtri_sample_test(o, w, samples, QTRI_SAMPLE_1, more, w->z + w->z_q);
        samples = qtri_sample_test(o, w, samples, QTRI_SAMPLE_2, more + 2, w->z - w->z_q);
        samples = qtri_sample_test(o, w, samples, QTRI_SAMPLE_3, more + 4, w->z + w->z_p);
    }
    return samples;
}

/* Writes depths after all tests, where options may discard pixels. */
QTRI_BODY void qtri_samples_write_late(const qtri_options *o, const qtri_pixel_walk *w,
                                       uint32_t samples, uint8_t *pixel, uint8_t *depth)
{
    if (!qtri_pixel_writes(o, w) || !qtri_discards(o)) {
        return;
    }
    uint8_t *more = pixel + 4 * qtri_pixel_bytes(o);
    if ((samples & QTRI_SAMPLE_0) != 0) {
        qtri_save(2, depth, (w->z - w->z_p) >> 16);
    }
    if ((samples & QTRI_SAMPLE_1) != 0) {
        qtri_save(2, more, (w->z + w->z_q) >> 16);
    }
    if ((samples & QTRI_SAMPLE_2) != 0) {
        qtri_save(2, more + 2, (w->z - w->z_q) >> 16);
    }
    if ((samples & QTRI_SAMPLE_3) != 0) {
        qtri_save(2, more + 4, (w->z + w->z_p) >> 16);
    }
}

/* Stores an encoded colour in these samples. */
QTRI_BODY void qtri_pixel_store_samples(uint32_t bytes, uint8_t *pixel, uint32_t samples,
                                        uint32_t stored)
{
    if ((samples & QTRI_SAMPLE_0) != 0) {
        qtri_save(bytes, pixel, stored);
    }
    if ((samples & QTRI_SAMPLE_1) != 0) {
        qtri_save(bytes, pixel + bytes, stored);
    }
    if ((samples & QTRI_SAMPLE_2) != 0) {
        qtri_save(bytes, pixel + 2 * bytes, stored);
    }
    if ((samples & QTRI_SAMPLE_3) != 0) {
        qtri_save(bytes, pixel + 3 * bytes, stored);
    }
}

#endif
