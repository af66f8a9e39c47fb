/* SPDX-License-Identifier: MIT */
#include "lit_triangle.h"

#include "../bits/reciprocal.h"
#include "../frame/pixel.h"
#include "../geometry/lit_point.h"
#include "setup.h"

#define ONE_Q30 QTRI_LIT_ONE_Q30

void qtri_lit_set_corners(qtri_pixel_light *p)
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

void qtri_lit_set_planes(qtri_pixel_light *p, const qtri_raster *raster,
                         const qtri_triangle *triangle, const qtri_attributes v[3])
{
    qtri_gradient gradient;
    uint32_t q[3];
    uint32_t f[3];
    qtri_gradient_place(&gradient, triangle);
    qtri_gradient_init(&gradient, triangle->extent);
    p->divided = QTRI_WITH_PERSPECTIVE && raster->perspective && qtri_align_inv_w(q, v);
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < 3; i++) {
            const uint32_t share_q30 = (uint32_t)v[i].color[k];
            f[i] = p->divided ? (uint32_t)(qtri_mul_u32(q[i], share_q30) >> 30) : share_q30;
        }
        qtri_plane_init(&p->share[k], &gradient, f);
    }
    if (p->divided) {
        qtri_plane_init(&p->q, &gradient, q);
        qtri_find_range(&p->least, &p->greatest, q);
    }
    p->sample[0].x = INT32_MIN;
}

/* ---- A pixel ---- */

static uint64_t plane_at(const qtri_plane *plane, int32_t x, int32_t y)
{
    return qtri_plane_column(qtri_plane_row(plane, y), plane->dx, x);
}

/* A plane's value, held to 0..most, in 2^-16 of the unit. */
static uint64_t held(uint64_t value, uint32_t least, uint32_t most)
{
    const int64_t whole = qtri_plane_floor(value);
    return whole < (int64_t)least   ? (uint64_t)least << 16
           : whole >= (int64_t)most ? (uint64_t)most << 16
                                    : value;
}

/* Shares of corners 1 and 2: below 2^30, as is their sum. */
static void find_shares(int32_t b_q30[2], const qtri_pixel_light *p, int32_t x, int32_t y)
{
    const uint64_t one = plane_at(&p->share[0], x, y);
    const uint64_t two = plane_at(&p->share[1], x, y);
    uint32_t b[2];
    if (p->divided) {
        const uint64_t q = held(plane_at(&p->q, x, y), p->least, p->greatest); /* >= 2^16 */
        const int32_t zeros = qtri_clz64(q | 1);
        const uint32_t most = (uint32_t)(q >> 16);
        const uint32_t reciprocal = qtri_reciprocal_near((uint32_t)((q << zeros) >> 32));
        /* s 2^32 / q with s <= q: (s 2^zeros) (2^62 / (q 2^zeros)) / 2^32 is below 2^30 + 2^4. */
        // NOLINTNEXTLINE(clang-analyzer-core.*): q | 1 is not 0, so zeros are at most 63
        b[0] = qtri_mul_high32((uint32_t)((held(one, 0, most) << zeros) >> 32), reciprocal);
        b[1] = qtri_mul_high32((uint32_t)((held(two, 0, most) << zeros) >> 32), reciprocal);
    } else {
        b[0] = (uint32_t)(held(one, 0, ONE_Q30 - 1) >> 16);
        b[1] = (uint32_t)(held(two, 0, ONE_Q30 - 1) >> 16);
    }
    b_q30[0] = qtri_least32((int32_t)b[0], ONE_Q30 - 1);
    b_q30[1] = qtri_least32((int32_t)b[1], ONE_Q30 - 1 - b_q30[0]);
}

/* Products are of an element within 2^30 and shares whose sum is less than 1. */
static void set_place(qtri_lit_point *point, const qtri_pixel_light *p, const int32_t b_q30[2])
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
static void set_normal(qtri_lit_point *point, const qtri_pixel_light *p, const int32_t b_q30[2])
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
static uint32_t color_8p8(const qtri_pixel_light *p, uint8_t c0, uint8_t c1, uint8_t c2,
                          const int32_t b_q30[2])
{
    if (p->one_color) {
        return (uint32_t)c0 << 8;
    }
    const int32_t more = (c1 - c0) * (b_q30[0] >> 14) + (c2 - c0) * (b_q30[1] >> 14);
    return (uint32_t)((c0 << 8) + (more >> 8));
}

void qtri_lit_channels(int32_t channel[3], const qtri_pixel_light *p, const qtri_raster *raster,
                       const int32_t b_q30[2])
{
    const qtri_illumination *by = p->by;
    const qtri_colors *units = raster->units;
    const qtri_lit_corner *c = p->corner;
    qtri_lit_point point;
    set_place(&point, p, b_q30);
    set_normal(&point, p, b_q30);
    qtri_gather_light(by, &point);
    const uint32_t red = reflected_8p16(
        by->base_q15[0], point.diffuse_q24[0], point.specular_q24[0],
        color_8p8(p, c[0].color.r, c[1].color.r, c[2].color.r, b_q30), by->specular.r);
    const uint32_t green = reflected_8p16(
        by->base_q15[1], point.diffuse_q24[1], point.specular_q24[1],
        color_8p8(p, c[0].color.g, c[1].color.g, c[2].color.g, b_q30), by->specular.g);
    const uint32_t blue = reflected_8p16(
        by->base_q15[2], point.diffuse_q24[2], point.specular_q24[2],
        color_8p8(p, c[0].color.b, c[1].color.b, c[2].color.b, b_q30), by->specular.b);
    channel[0] = (int32_t)qtri_channel_scaled(red, units->ratio_q30[0]);
    channel[1] = (int32_t)qtri_channel_scaled(green, units->ratio_q30[1]);
    channel[2] = (int32_t)qtri_channel_scaled(blue, units->ratio_q30[2]);
    if (units->single) {
        channel[2] += channel[0] + channel[1];
        channel[0] = 0;
        channel[1] = 0;
    }
}

void qtri_lit_sample_at(qtri_lit_sample *out, const qtri_pixel_light *p, const qtri_raster *raster,
                        int32_t x, int32_t y)
{
    int32_t b_q30[2];
    find_shares(b_q30, p, x, y);
    qtri_lit_channels(out->c, p, raster, b_q30);
    out->x = x;
    out->y = y;
}
