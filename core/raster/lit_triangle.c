/* SPDX-License-Identifier: MIT */
#include "lit_triangle.h"

#include "../bits/multiply.h"
#include "../geometry/lit_point.h"

#define ONE_Q30 QTRI_LIT_ONE_Q30

void qtri_lit_set_corner(qtri_lit_triangle *p, int i, const qtri_lit_point *point,
                         const qtri_rgb *color)
{
    qtri_lit_corner *corner = &p->corner[i];
    corner->color = *color;
    corner->exponent = point->exponent;
    for (int k = 0; k < 3; k++) {
        corner->place[k] = point->place[k];
        corner->normal_q14[k] = point->normal_q14[k];
    }
}

void qtri_lit_set_corners(qtri_lit_triangle *p)
{
    qtri_lit_corner *c = p->corner;
    const int32_t exponent =
        qtri_greatest32(c[0].exponent, qtri_greatest32(c[1].exponent, c[2].exponent));
    uint32_t all = 1;
    uint32_t turns = 0;
    for (int i = 0; i < 3; i++) {
        const int32_t down = qtri_least32(exponent - c[i].exponent, 31);
        c[i].exponent = exponent;
        for (int k = 0; k < 3; k++) {
            c[i].place[k] >>= down;
        }
    }
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 2; i++) { /* places are within 2^29 of 0, directions within 2^14.1 */
            p->across[i][k] = c[i + 1].place[k] - c[0].place[k];
            p->turn_q14[i][k] = c[i + 1].normal_q14[k] - c[0].normal_q14[k];
            all |= qtri_magnitude32(p->across[i][k]);
            turns |= (uint32_t)p->turn_q14[i][k];
        }
    }
    p->up = qtri_greatest32(qtri_clz32(all) - 2, 0);
    for (int k = 0; k < 3; k++) { /* 2^30 itself, at up = 0, is one less */
        p->across[0][k] = qtri_hold32(p->across[0][k], -ONE_Q30, ONE_Q30 - 1) * (1 << p->up);
        p->across[1][k] = qtri_hold32(p->across[1][k], -ONE_Q30, ONE_Q30 - 1) * (1 << p->up);
    }
    p->one_normal = turns == 0;
    p->one_color = c[0].color.r == c[1].color.r && c[0].color.g == c[1].color.g &&
                   c[0].color.b == c[1].color.b && c[0].color.r == c[2].color.r &&
                   c[0].color.g == c[2].color.g && c[0].color.b == c[2].color.b;
}

/* Products are of an element within 2^30 and shares whose sum is less than 1. */
static void set_place(qtri_lit_point *point, const qtri_lit_triangle *p, const int32_t b_q30[2])
{
    point->exponent = p->corner[0].exponent;
    for (int k = 0; k < 3; k++) {
        const int32_t way = qtri_mul_high_s30(p->across[0][k], b_q30[0]) +
                            qtri_mul_high_s30(p->across[1][k], b_q30[1]); /* <= 2^28 */
        point->place[k] =
            p->corner[0].place[k] + (p->up >= 2 ? way >> (p->up - 2) : way * (4 >> p->up));
    }
}

/*
 * The normals' mean is shorter than they are. Near 1 a step of Newton is enough, as in lit_point.h.
 */
static void set_normal(qtri_lit_point *point, const qtri_lit_triangle *p, const int32_t b_q30[2])
{
    const uint32_t one_q28 = (uint32_t)1 << 28;
    const int32_t b1 = b_q30[0] >> 15;
    const int32_t b2 = b_q30[1] >> 15;
    int32_t *n = point->normal_q14;
    for (int k = 0; k < 3; k++) {
        n[k] = p->corner[0].normal_q14[k];
        if (!p->one_normal) { /* two unit vectors differ by 2^15.01, so that sums fit */
            n[k] += (p->turn_q14[0][k] * b1 + p->turn_q14[1][k] * b2) >> 15;
        }
    }
    if (p->one_normal) {
        return;
    }
    const uint32_t square =
        (uint32_t)(n[0] * n[0]) + (uint32_t)(n[1] * n[1]) + (uint32_t)(n[2] * n[2]);
    if (square - (one_q28 - one_q28 / 32) < one_q28 / 16) {
        const int32_t factor_q15 = (int32_t)((3 * one_q28 - square) >> 14);
        for (int k = 0; k < 3; k++) {
            n[k] = (n[k] * factor_q15 + 0x4000) >> 15;
        }
    } else if (square != 0) {
        const int32_t v[3] = {n[0], n[1], n[2]};
        qtri_normalize_q14(n, v, square);
    }
}

/* A channel of a colour, 8.8, in the light, n.16: sums are as in qtri_reflect(). */
static uint32_t reflected_8p16(uint32_t base_q15, uint32_t diffuse_q24, uint32_t specular_q24,
                               uint32_t color_8p8, uint32_t highlight)
{
    const uint32_t diffuse_q15 = diffuse_q24 >> 9;
    const uint32_t sum_q15 = base_q15 - 0x4000 + diffuse_q15 * (color_8p8 >> 8) +
                             (diffuse_q15 * (color_8p8 & 255) >> 8) +
                             (specular_q24 >> 9) * highlight;
    const uint32_t most_q15 = (uint32_t)255 << 15;
    return (sum_q15 < most_q15 ? sum_q15 : most_q15) << 1;
}

/* A channel of the corners' colours, 8.8. */
static uint32_t color_8p8(const qtri_lit_triangle *p, uint8_t c0, uint8_t c1, uint8_t c2,
                          const int32_t b_q30[2])
{
    if (p->one_color) {
        return (uint32_t)c0 << 8;
    }
    const int32_t more = (c1 - c0) * (b_q30[0] >> 14) + (c2 - c0) * (b_q30[1] >> 14);
    return (uint32_t)((c0 << 8) + (more >> 8));
}

void qtri_lit_color(uint32_t color_8p16[3], const qtri_lit_triangle *p, const int32_t b_q30[2])
{
    const qtri_illumination *by = p->by;
    const qtri_lit_corner *c = p->corner;
    qtri_lit_point point;
    set_place(&point, p, b_q30);
    set_normal(&point, p, b_q30);
    qtri_gather_light(by, &point);
    color_8p16[0] = reflected_8p16(by->base_q15[0], point.diffuse_q24[0], point.specular_q24[0],
                                   color_8p8(p, c[0].color.r, c[1].color.r, c[2].color.r, b_q30),
                                   by->specular.r);
    color_8p16[1] = reflected_8p16(by->base_q15[1], point.diffuse_q24[1], point.specular_q24[1],
                                   color_8p8(p, c[0].color.g, c[1].color.g, c[2].color.g, b_q30),
                                   by->specular.g);
    color_8p16[2] = reflected_8p16(by->base_q15[2], point.diffuse_q24[2], point.specular_q24[2],
                                   color_8p8(p, c[0].color.b, c[1].color.b, c[2].color.b, b_q30),
                                   by->specular.b);
}
