/* SPDX-License-Identifier: MIT */
#include "place.h"

#include "sampling.h"

bool qtri_inv_w_more(int32_t *more, const qtri_vertex *a, const qtri_vertex *b)
{
    const uint32_t up = (b->depth_16p8 & 0xFF) - (a->depth_16p8 & 0xFF) + 1;
    const uint32_t limit = (a->inv_w >> 4) + (a->inv_w >> 6);
    if (up > 2) {
        return false;
    }
    const uint32_t inv_w = up == 0 ? b->inv_w >> 1 : b->inv_w << (up - 1);
    const uint32_t difference = inv_w - a->inv_w;
    *more = (int32_t)difference;
    return difference + limit <= 2 * limit;
}

QTRI_NOINLINE bool qtri_place_uneven(qtri_place *p, const qtri_vertex *a, const qtri_vertex *b,
                                     const qtri_vertex *c)
{
    const int32_t z0 = (int32_t)(a->depth_16p8 >> 8);
    const int32_t z1 = (int32_t)(b->depth_16p8 >> 8) - z0;
    const int32_t z2 = (int32_t)(c->depth_16p8 >> 8) - z0;
    int32_t more[2];
    if (qtri_place_is_steep(p, z1, z2) || !qtri_inv_w_more(&more[0], a, b) ||
        !qtri_inv_w_more(&more[1], a, c)) {
        return false;
    }
    p->more1 = more[p->back ? 1 : 0];
    p->more2 = more[p->back ? 0 : 1];
    return true;
}

bool qtri_place_cut(uint8_t *span, int32_t column, const qtri_rect *bounds)
{
    const int32_t least = qtri_hold32(bounds->x0 - column, 0, QTRI_PLACE_STOP - 1);
    const int32_t greatest = qtri_hold32(bounds->x1 - column, 0, QTRI_PLACE_STOP - 1);
    bool any = false;
    for (; span[0] != QTRI_PLACE_STOP; span += 2) {
        span[0] = (uint8_t)qtri_hold32(span[0], least, greatest);
        span[1] = (uint8_t)qtri_hold32(span[1], least, greatest);
        any |= span[0] < span[1];
    }
    return any;
}

qtri_placed qtri_place_triangle(qtri_place *p, uint8_t spans[QTRI_PLACE_SPANS],
                                const qtri_raster *raster, const qtri_vertex *a,
                                const qtri_vertex *b, const qtri_vertex *c)
{
    return raster->samples != NULL ? raster->samples->place(p, spans, raster, a, b, c)
                                   : qtri_place_near(p, spans, raster, a, b, c);
}
