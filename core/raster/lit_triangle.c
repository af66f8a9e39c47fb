/* SPDX-License-Identifier: MIT */
#include "lit_triangle.h"

#include "../bits/bits.h"
#include "../geometry/illumination.h"

#define ONE_Q30 QTRI_LIT_ONE_Q30

/* What a line may be off by beyond the tolerance where a polynomial replaces it, 2^-7 of a step of
   255: a kink near a corner leaves three halves of the line's error. */
enum { QUADRATIC_MORE = 4 << 7 };

void qtri_lit_set_corner(qtri_lit_triangle *p, int i, const qtri_lit_point *point,
                         const qtri_rgb *color)
{
    qtri_lit_corner *corner = &p->corner[i];
    corner->color = *color;
    p->is_quadratic = false;
    corner->exponent = point->exponent;
    for (int k = 0; k < 3; k++) {
        corner->place[k] = point->place[k];
        corner->normal_q14[k] = point->normal_q14[k];
    }
}

/* Places in one scale, that of the farthest. */
static void align_corners(qtri_lit_triangle *p)
{
    qtri_lit_corner *c = p->corner;
    const int32_t exponent =
        qtri_greatest32(c[0].exponent, qtri_greatest32(c[1].exponent, c[2].exponent));
    for (int i = 0; i < 3; i++) {
        const int32_t down = qtri_least32(exponent - c[i].exponent, 31);
        c[i].exponent = exponent;
        for (int k = 0; k < 3; k++) {
            c[i].place[k] >>= down;
        }
    }
    p->one_color = c[0].color.r == c[1].color.r && c[0].color.g == c[1].color.g &&
                   c[0].color.b == c[1].color.b && c[0].color.r == c[2].color.r &&
                   c[0].color.g == c[2].color.g && c[0].color.b == c[2].color.b;
}

void qtri_lit_set_corners(qtri_lit_triangle *p)
{
    const qtri_lit_corner *c = p->corner;
    uint32_t all = 1;
    uint32_t turns = 0;
    align_corners(p);
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

/* A mean of normals is shorter than they are. Near 1 a step of Newton is enough, as in
   illumination.h. */
static void normalize(int32_t n[3])
{
    const uint32_t one_q28 = (uint32_t)1 << 28;
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

static void set_normal(qtri_lit_point *point, const qtri_lit_triangle *p, const int32_t b_q30[2])
{
    const int32_t b1 = b_q30[0] >> 15;
    const int32_t b2 = b_q30[1] >> 15;
    int32_t *n = point->normal_q14;
    for (int k = 0; k < 3; k++) {
        n[k] = p->corner[0].normal_q14[k];
        if (!p->one_normal) { /* two unit vectors differ by 2^15.01, so that sums fit */
            n[k] += (p->turn_q14[0][k] * b1 + p->turn_q14[1][k] * b2) >> 15;
        }
    }
    if (!p->one_normal) {
        normalize(n);
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

/* What a point shows, of the shares whose colour it has. */
static void light_point(uint32_t color_8p16[3], qtri_lit_point *point, const qtri_lit_triangle *p,
                        const int32_t b_q30[2])
{
    const qtri_illumination *by = p->by;
    const qtri_lit_corner *c = p->corner;
    qtri_gather_light(by, point);
    color_8p16[0] = reflected_8p16(by->base_q15[0], point->diffuse_q24[0], point->specular_q24[0],
                                   color_8p8(p, c[0].color.r, c[1].color.r, c[2].color.r, b_q30),
                                   by->specular.r);
    color_8p16[1] = reflected_8p16(by->base_q15[1], point->diffuse_q24[1], point->specular_q24[1],
                                   color_8p8(p, c[0].color.g, c[1].color.g, c[2].color.g, b_q30),
                                   by->specular.g);
    color_8p16[2] = reflected_8p16(by->base_q15[2], point->diffuse_q24[2], point->specular_q24[2],
                                   color_8p8(p, c[0].color.b, c[1].color.b, c[2].color.b, b_q30),
                                   by->specular.b);
}

/* Halfway between two corners, i below j. */
static void light_middle(uint32_t color_8p16[3], const qtri_lit_triangle *p, int i, int j)
{
    const int32_t half = QTRI_LIT_ONE_Q30 / 2;
    const qtri_lit_corner *a = &p->corner[i], *b = &p->corner[j];
    const int32_t b_q30[2] = {i == 1 || j == 1 ? half : 0, j == 2 ? half : 0};
    qtri_lit_point point;
    point.exponent = a->exponent;
    for (int k = 0; k < 3; k++) {
        point.place[k] = (a->place[k] + b->place[k]) >> 1;
        point.normal_q14[k] = (a->normal_q14[k] + b->normal_q14[k]) >> 1;
    }
    normalize(point.normal_q14);
    light_point(color_8p16, &point, p, b_q30);
}

/* |k| < 2^17, so that products fit. */
static uint32_t quadratic_8p16(const int32_t k[6], int32_t b1_q13, int32_t b2_q13,
                               const int32_t square_q13[3])
{
    const int32_t sum = ((k[1] * b1_q13) >> 13) + ((k[2] * b2_q13) >> 13) +
                        ((k[3] * square_q13[0]) >> 13) + ((k[4] * square_q13[1]) >> 13) +
                        ((k[5] * square_q13[2]) >> 13);
    return (uint32_t)qtri_hold32(k[0] + sum, 0, 255 << 7) << 9;
}

static void set_quadratic(uint32_t color_8p16[3], const qtri_lit_triangle *p,
                          const int32_t b_q30[2])
{
    const int32_t b1 = b_q30[0] >> 17, b2 = b_q30[1] >> 17;
    const int32_t square_q13[3] = {(b1 * b1) >> 13, (b2 * b2) >> 13, (b1 * b2) >> 13};
    for (int i = 0; i < 3; i++) {
        color_8p16[i] = quadratic_8p16(p->k[i], b1, b2, square_q13);
    }
}

/* Sets the channel's polynomial; returns its second differences along the edges, or-ed. */
static uint32_t set_channel(int32_t k[6], const int32_t c[3], int32_t m01, int32_t m02, int32_t m12)
{
    k[0] = c[0];
    k[1] = 4 * m01 - c[1] - 3 * c[0];
    k[2] = 4 * m02 - c[2] - 3 * c[0];
    k[3] = 2 * (c[0] + c[1] - 2 * m01);
    k[4] = 2 * (c[0] + c[2] - 2 * m02);
    k[5] = 4 * (c[0] + m12 - m01 - m02);
    return qtri_magnitude32(k[3]) / 2 | qtri_magnitude32(k[4]) / 2 |
           qtri_magnitude32(c[1] + c[2] - 2 * m12);
}

static bool is_quadratic_at_centroid(const qtri_lit_triangle *p, int32_t tolerance)
{
    const int32_t third[2] = {QTRI_LIT_ONE_Q30 / 3, QTRI_LIT_ONE_Q30 / 3};
    uint32_t exact[3], quadratic[3];
    qtri_lit_color(exact, p, third);
    set_quadratic(quadratic, p, third);
    for (int i = 0; i < 3; i++) {
        if (qtri_magnitude32((int32_t)(exact[i] - quadratic[i])) > (uint32_t)tolerance << 9) {
            return false;
        }
    }
    return true;
}

/*
 * A second difference D along an edge, ends and middle, is twice what the line is off in the
 * middle; inside the triangle that may be 4/3 of the most at an edge, and where light has a kink
 * near a corner twice of it.
 */
bool qtri_lit_is_linear(qtri_lit_triangle *p, const uint32_t corner[3], int32_t tolerance)
{
    uint32_t m[3][3];
    uint32_t second = 0;
    align_corners(p);
    light_middle(m[0], p, 0, 1);
    light_middle(m[1], p, 0, 2);
    light_middle(m[2], p, 1, 2);
    for (int i = 0; i < 3; i++) {
        int32_t c[3];
        for (int j = 0; j < 3; j++) {
            c[j] = (int32_t)(corner[j] >> (16 - 8 * i) & 255) << 7;
        }
        second |= set_channel(p->k[i], c, (int32_t)(m[0][i] >> 9), (int32_t)(m[1][i] >> 9),
                              (int32_t)(m[2][i] >> 9));
    }
    if (second < 2 * (uint32_t)tolerance) {
        return true;
    }
    qtri_lit_set_corners(p);
    p->is_quadratic = second < 2 * (uint32_t)(tolerance + QUADRATIC_MORE) &&
                      is_quadratic_at_centroid(p, tolerance);
    return false;
}

void qtri_lit_color(uint32_t color_8p16[3], const qtri_lit_triangle *p, const int32_t b_q30[2])
{
    if (p->is_quadratic) {
        set_quadratic(color_8p16, p, b_q30);
        return;
    }
    qtri_lit_point point;
    set_place(&point, p, b_q30);
    set_normal(&point, p, b_q30);
    light_point(color_8p16, &point, p, b_q30);
}
