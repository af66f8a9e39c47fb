/* SPDX-License-Identifier: MIT */
/*
 * Light by pixel: of triangles whose material names &qtri_per_pixel. Internal.
 *
 * A raster that draws such triangles has `lit`, which knows what light reaches the surface of the
 * triangle that is drawn, and a route. Jobs have one colour then, and where they would take it they
 * ask `lit` for colours. Nothing but the description names its functions.
 */
#ifndef QTRI_RASTER_PIXEL_LIGHT_H
#define QTRI_RASTER_PIXEL_LIGHT_H

#include "job.h"
#include "lit_triangle.h"
#include "sampling.h"
#include "triangle.h"

/* What a pixel shows: channels in the raster's units. */
typedef struct qtri_lit_sample {
    int32_t x, y;
    int32_t c[3];
} qtri_lit_sample;

struct qtri_pixel_light {
    /* Colours of a chunk of a row into the batch, or its texels times them. */
    void (*shade)(qtri_scanline *row, int32_t x, int32_t count);
    qtri_route next;    /* what the raster had; NULL: none */
    int32_t block_log2; /* of pixels from sample to sample */
    qtri_lit_triangle lit;
    /* Shares of corners 1 and 2, 2^30 is 1; divided: times q = 1/w, 2^31 at most, and q. */
    bool divided;
    qtri_plane share[2];
    qtri_plane q;
    uint32_t least, greatest;  /* of the vertices' q */
    qtri_lit_sample sample[3]; /* the first two: where the last chunk ended, and the next one */
    bool bends;                /* between them and the one before */
    int32_t left, right;       /* the span that they are of: four samples have several in a row */
};

/*
 * Calls `body` while the raster, which has a batch and its stages, draws triangles by pixel. Before
 * each its corners are set.
 */
typedef void (*qtri_lit_body)(void *with);
void qtri_pixel_light_run(qtri_raster *raster, const qtri_illumination *by, qtri_lit_body body,
                          void *with);

/* Corner i, as the point and colour are that light falls on. */
void qtri_pixel_light_set(const qtri_raster *raster, int i, const qtri_lit_point *point,
                          const qtri_rgb *color);

/*
 * Vertices of what is left of a triangle bring their shares of its corners 1 and 2 in place of
 * colours.
 */
static inline void qtri_pixel_light_share(qtri_attributes *v, int32_t b1_q30, int32_t b2_q30)
{
    v->color[0] = b1_q30;
    v->color[1] = b2_q30;
    v->color[2] = 0;
}

/* Vertices 1 and 2 within this of vertex 0, 1/256 pixel: light by vertex is as good. */
#define QTRI_LIT_BY_VERTEX (6 * 256)

/*
 * Whether such a triangle may be drawn as a small one: it is, and the route that the raster had,
 * none or that of samples, lets it.
 */
static inline bool qtri_is_lit_by_vertex(const qtri_raster *raster, const qtri_screen_point *a,
                                         const qtri_screen_point *b, const qtri_screen_point *c)
{
    const uint32_t half = QTRI_LIT_BY_VERTEX;
    const qtri_route next = raster->lit->next;
    return (next == NULL || (raster->samples != NULL && next == raster->samples->draw)) &&
           (((uint32_t)(b->x_24p8 - a->x_24p8) + half) |
            ((uint32_t)(b->y_24p8 - a->y_24p8) + half) |
            ((uint32_t)(c->x_24p8 - a->x_24p8) + half) |
            ((uint32_t)(c->y_24p8 - a->y_24p8) + half)) < 2 * half;
}

#endif
