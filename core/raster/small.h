/*
 * Flat triangles of a mesh of one colour in RGB565 with depth "less" and written, of which
 * qtri_triangle_begin found all spans: set up for the loop that fills them without what they do not
 * need, with the general path's pixels to the bit. Internal.
 */
#ifndef QTRI_RASTER_SMALL_H
#define QTRI_RASTER_SMALL_H

#include "../geometry/projector.h"
#include "triangle.h"

/* Where code is to be small they are drawn as any are. */
#ifdef __OPTIMIZE_SIZE__
#define QTRI_SMALL 0
#else
#define QTRI_SMALL QTRI_WITH_FAST_PATHS
#endif

/*
 * The triangle is one that qtri_triangle_begin accepted, with the places of a, b, c. False when it
 * is not that simple: then nothing was drawn.
 */
bool qtri_small_draw(const qtri_raster *raster, const qtri_triangle *triangle, const qtri_vertex *a,
                     const qtri_vertex *b, const qtri_vertex *c, uint32_t intensity_q15);

/* Whether depths differ by so little that qtri_ramp_from_steps takes them. */
static inline bool qtri_depths_are_close(const qtri_vertex *a, const qtri_vertex *b,
                                         const qtri_vertex *c)
{
    const uint32_t reach = (uint32_t)1 << 15;
    const uint32_t z0 = a->depth_16p8 >> 8;
    return (((b->depth_16p8 >> 8) - z0 + reach) | ((c->depth_16p8 >> 8) - z0 + reach)) < 2 * reach;
}

/* The difference from a to b, as it takes it. */
static inline int32_t qtri_depth_step(const qtri_vertex *a, const qtri_vertex *b)
{
    const int32_t difference = (int32_t)((b->depth_16p8 >> 8) - (a->depth_16p8 >> 8));
    return (difference + 1) >> (QTRI_RAMP_DOWN - 8);
}

/* The tint at an intensity, as a pixel. */
static inline uint32_t qtri_raster_shade_565(const qtri_raster *raster, uint32_t intensity_q15)
{
    qtri_channels color;
    for (int i = 0; i < 3; i++) {
        color.c[i] = qtri_raster_shade(raster, (int32_t)(intensity_q15 << 7), i);
    }
    return qtri_pixel_pack(QTRI_KIND_RGB565, &color);
}

#endif
