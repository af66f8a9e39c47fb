#include "span.h"

/*
 * GCC 12 interleaves unrolled pixels and then runs out of registers; an empty statement that it may
 * not move things across keeps each pixel's work together. 15 to 20 % of the loop on a Cortex-M3.
 */
#if defined(__GNUC__)
#define QTRI_BARRIER __asm__ volatile("");
#else
#define QTRI_BARRIER
#endif

/* The three channels at the first pixel of a run, and their steps. */
static void channels_start(const qtri_run *run, uint32_t c[3], uint32_t step[3])
{
    for (int i = 0; i < 3; i++) {
        c[i] = run->color[i];
        step[i] = run->color_step[i];
    }
}

#define rgb565_colors   channels_start
#define xrgb8888_colors channels_start

/* Luma is the sum of its three shares, and so are its value and its step: one ramp. */
static void gray8_colors(const qtri_run *run, uint32_t c[1], uint32_t step[1])
{
    c[0] =
        run->color[0] + run->color[1] + run->color[2] - 0x10000u; /* of three halves, one rounds */
    step[0] = run->color_step[0] + run->color_step[1] + run->color_step[2];
}

#define LOOP(name) rgb565_##name
#define PIXEL      uint16_t
#define CHANNELS   3
#define PACK(c)    (((c)[0] >> 16 << 11) | ((c)[1] >> 16 << 5) | ((c)[2] >> 16))
#include "run_loops.inc"

#define LOOP(name) xrgb8888_##name
#define PIXEL      uint32_t
#define CHANNELS   3
#define PACK(c)    (((c)[0] >> 16 << 16) | ((c)[1] >> 16 << 8) | ((c)[2] >> 16))
#include "run_loops.inc"

#define LOOP(name) gray8_##name
#define PIXEL      uint8_t
#define CHANNELS   1
#define PACK(c)    ((c)[0] >> 16)
#include "run_loops.inc"

qtri_run_loop qtri_run_choose(const qtri_span_job *job)
{
    bool less = job->compare == QTRI_LESS && job->depth_write;
    if (job->texture != NULL || !(less || job->compare == QTRI_DEPTH_OFF)) {
        return qtri_run_generic;
    }
    int smooth = job->smooth;
    switch (job->surface->format) {
    case QTRI_RGB565:
        return rgb565_loops[smooth][less];
    case QTRI_XRGB8888:
        return xrgb8888_loops[smooth][less];
    default:
        return gray8_loops[smooth][less];
    }
}
