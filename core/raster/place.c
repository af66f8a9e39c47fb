#include "place.h"

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
    return qtri_place_inline(p, spans, raster, a, b, c);
}

/* Whether numerators f d - f d' stay below 2^bits when they are shifted left. |f| <= 2^16. */
static bool fits(const qtri_place *p, const qtri_inverse *by, int32_t f1, int32_t f2,
                 int32_t bits)
{
    const uint32_t most =
        qtri_about(f2 * p->dy1 - f1 * p->dy2) | qtri_about(f1 * p->dx2 - f2 * p->dx1);
    return most >> (bits - by->left) == 0;
}

/* By planes of 64 bits, of values from the least of the three on. */
static void divide(qtri_ramp *ramp, const qtri_place *p, uint32_t f0, int32_t f1, int32_t f2)
{
    qtri_gradient g;
    const uint32_t one = (uint32_t)1 << QTRI_RAMP_DOWN;
    const int32_t least = qtri_least_from_0(f1, f2);
    const uint32_t f[3] = {(uint32_t)-least * one, (uint32_t)(f1 - least) * one,
                           (uint32_t)(f2 - least) * one};
    g.dx1 = p->dx1;
    g.dy1 = p->dy1;
    g.dx2 = p->dx2;
    g.dy2 = p->dy2;
    g.area = -(int64_t)p->size;
    const int32_t column = (128 - p->x) >> 8; /* the pixel at vertex 0: its steps are rounded */
    const int32_t row = (128 - p->y) >> 8;
    g.anchor_dx = column * 256 + p->x;
    g.anchor_dy = row * 256 + p->y;
    g.reciprocal = 0;
    qtri_ramp_divide(ramp, &g, f);
    ramp->origin += f0 - f[0] - 0x8000u;
    ramp->origin -= (uint32_t)column * ramp->dx + (uint32_t)row * ramp->dy;
}

/*
 * Slivers have numerators that do not fit, rarely. Steep attributes go in two parts of 2^9: the
 * higher one's steps, below 2^21, are off by half of that, and across 32 pixels by 2^13.
 */
QTRI_NOINLINE void qtri_place_ramp_any(qtri_ramp *ramp, const qtri_place *p,
                                       const qtri_inverse *by, uint32_t f0, int32_t f1,
                                       int32_t f2)
{
    const int32_t part = 512;
    const int32_t high1 = f1 >> 9;
    const int32_t high2 = f2 >> 9;
    const int32_t low1 = f1 & (part - 1);
    const int32_t low2 = f2 & (part - 1);
    const bool steep = (qtri_about(f1) | qtri_about(f2)) >> 16 != 0;
    if (!steep && fits(p, by, f1, f2, 30)) {
        qtri_place_ramp_plain(ramp, p, by, f0, f1, f2);
    } else if (steep && fits(p, by, high1, high2, 23) && fits(p, by, low1, low2, 30)) {
        const int32_t gx =
            qtri_place_dx(p, by, high1, high2) * part + qtri_place_dx(p, by, low1, low2) + part / 2;
        const int32_t gy =
            qtri_place_dy(p, by, high1, high2) * part + qtri_place_dy(p, by, low1, low2) + part / 2;
        ramp->origin = f0 + qtri_gradient_along(gx, p->x, gy, p->y);
        ramp->dx = (uint32_t)gx;
        ramp->dy = (uint32_t)gy;
    } else {
        divide(ramp, p, f0, f1, f2);
    }
}
