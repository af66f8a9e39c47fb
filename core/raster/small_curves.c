/* SPDX-License-Identifier: MIT */
#include "small_curves.h"

#include "../bits/bits.h"

void qtri_small_find_inv_w_deltas(int32_t e_q18[2], const qtri_small_place *p, const qtri_small *t)
{
    const int32_t y = (int32_t)qtri_small_reciprocal(t->v[0]->inv_w >> 15);
    e_q18[0] = ((p->q1 >> 15) * y + ((int32_t)1 << 12)) >> 13;
    e_q18[1] = ((p->q2 >> 15) * y + ((int32_t)1 << 12)) >> 13;
}

/* k = e / (1 + e/2) = 2 h (1 - h (1 - h + h^2)), h = e/2: off by 2 h^5, 2^-9, at most. */
static int32_t k_of(int32_t e_q18)
{
    const int32_t h = e_q18 >> 3; /* Q16, |h| <= 2^14 */
    const int32_t rest = 0x10000 - ((h * (0x10000 - h)) >> 16);
    return e_q18 - ((h * ((h * rest) >> 16)) >> 13);
}

bool qtri_small_set_curvature(qtri_curvature *c, const qtri_small_place *p, const qtri_small *t)
{
    int32_t *e = c->e_q18;
    const int wide = p->wide;
    qtri_small_ramp ramp;
    qtri_small_find_inv_w_deltas(e, p, t);
    c->k_q18[0] = k_of(e[0]);
    c->k_q18[1] = k_of(e[1]);
    QTRI_SMALL_SETUP(ramp_set_at)
    (&ramp, p, p->x, p->y - 256 * p->first, 0, c->k_q18[0] >> (1 + wide), c->k_q18[1] >> (1 + wide),
     -p->up);
    /* Steps of Q25, of wide ones Q24, 2^up less: to 13 bits of the greater one. */
    const uint32_t greater = qtri_small_abs((int32_t)ramp.dx) | qtri_small_abs((int32_t)ramp.dy);
    const int32_t down = qtri_greatest32(19 - qtri_clz32(greater), 1);
    const int32_t round = (int32_t)1 << (down - 1);
    c->bits = 25 - wide - p->up - down;
    c->e = ((int32_t)ramp.at + round) >> down;
    c->ex = ((int32_t)ramp.dx + round) >> down;
    c->ey = ((int32_t)ramp.dy + round) >> down;
    const uint32_t range = qtri_small_range(e[0], e[1]) >> 8; /* Q10, 3/4 at most */
    const uint32_t q_mid = 1024u + (uint32_t)(qtri_small_min0(e[0], e[1]) >> 8) + range / 2;
    c->ratio_q12 = (range * range >> 8) + 1;
    c->q_mid2_q10 = 35 * (q_mid * q_mid >> 10) >> 5;
    return c->bits >= 17;
}

bool qtri_small_is_near_curve(const qtri_curvature *c, uint32_t range, uint32_t by)
{
    return range <= (uint32_t)1 << 20 && range * c->ratio_q12 <= c->q_mid2_q10 << (by + 2);
}

/* F E / 2^14. */
static inline int32_t product(int32_t f, int32_t e)
{
    return qtri_small_product(f, e, 14);
}

/* x 2^up, rounded. */
static inline uint32_t to_units(int32_t x, int32_t up)
{
    return up >= 0 ? (uint32_t)x << up : (uint32_t)((x + ((int32_t)1 << (-up - 1))) >> -up);
}

void qtri_small_set_curve(qtri_small_curve *r, const qtri_small_place *p, const qtri_curvature *c,
                          const qtri_small_value *value)
{
    const int32_t x = p->x, y = p->y - 256 * p->first;
    const uint32_t rows = (uint32_t)p->first;
    const int32_t wide = p->wide;
    qtri_small_ramp f, g;
    const int32_t f1 = (value->f1 + wide) >> wide; /* scaled they have to be below 2^14.4 */
    const int32_t f2 = (value->f2 + wide) >> wide;
    int32_t up = value->up + wide;
    QTRI_SMALL_SETUP(ramp_set_at)(&f, p, x, y, 0, f1, f2, -p->up);
    QTRI_SMALL_SETUP(ramp_set_at)
    (&g, p, x, y, value->value, qtri_small_scaled(f1, c->k_q18[0]),
     qtri_small_scaled(f2, c->k_q18[1]), up);
    const int32_t at = (int32_t)f.at, fx = (int32_t)f.dx, fy = (int32_t)f.dy;
    up += p->up + 14 - c->bits; /* of the unit of product() */
    r->xx = 0u - to_units(product(fx, c->ex), up);
    r->xy = 0u - to_units(product(fx, c->ey) + product(fy, c->ex), up);
    const uint32_t yy = 0u - to_units(product(fy, c->ey), up);
    const uint32_t dy = g.dy - to_units(product(at, c->ey) + product(fy, c->e), up);
    const uint32_t dx = g.dx - to_units(product(at, c->ex) + product(fx, c->e), up);
    r->at = g.at - to_units(product(at, c->e), up) + rows * (dy + rows * yy);
    r->dx = dx + rows * r->xy;
    r->dy = dy + (2 * rows + 1) * yy;
    r->yy = 2 * yy;
}

int32_t qtri_small_chord_log2(const qtri_small_curve *c, int32_t most, uint32_t bend)
{
    const uint32_t by = qtri_small_abs((int32_t)c->xx);
    int32_t log2 = most;
    while (log2 > 0 && by > bend >> 2 * log2) {
        log2--;
    }
    return log2;
}
