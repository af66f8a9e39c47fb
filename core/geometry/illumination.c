/* SPDX-License-Identifier: MIT */
#include "lit_point.h"

#include "../bits/seed.h"

/*
 * q = v . v becomes v' = q 4^up / 2^32 in [1/4, 1), and y is
 * v'^-1/2 in Q15 within 2^-13: v / |v| = v y 2^up / 2^31.
 */
void qtri_normalize_q14(int32_t out[3], const int32_t v[3], uint32_t square)
{
    const int32_t zeros = qtri_clz32(square) & ~1;
    const int32_t y_q14 = (int32_t)(qtri_rsqrt_seed((square << zeros) >> 16) >> 1);
    int32_t down = 16 - (zeros >> 1); /* 1..16 */
    for (int i = 0; i < 3; i++) {     /* |v| y <= 2^(30 - zeros / 2) */
        out[i] = (v[i] * y_q14) >> down;
    }
}

static uint32_t square_of(const int32_t v[3])
{
    return (uint32_t)(v[0] * v[0]) + (uint32_t)(v[1] * v[1]) + (uint32_t)(v[2] * v[2]);
}

bool qtri_direction_q14(int32_t out[3], const int64_t v[3])
{
    const uint64_t all = qtri_magnitude64(v[0]) | qtri_magnitude64(v[1]) | qtri_magnitude64(v[2]);
    int32_t scaled[3];
    const int32_t down = 49 - qtri_clz64(all | 1u); /* leaves 15 bits */
    for (int i = 0; i < 3; i++) {
        scaled[i] = (int32_t)(down >= 0 ? v[i] >> down : qtri_shift_left64(v[i], -down));
    }
    const uint32_t square = square_of(scaled);
    if (square == 0) {
        out[0] = 0;
        out[1] = 0;
        out[2] = 0;
        return false;
    }
    qtri_normalize_q14(out, scaled, square);
    return true;
}

void qtri_illuminated_uneven(qtri_lit_point *point, const qtri_illumination *by, const int32_t v[3])
{
    int64_t turned[3]; /* < 3 2^15 2^29 */
    for (int row = 0; row < 3; row++) {
        const int32_t *m = by->normal_q28[row];
        turned[row] =
            qtri_mul_s32(m[0], v[0]) + qtri_mul_s32(m[1], v[1]) + qtri_mul_s32(m[2], v[2]);
    }
    (void)qtri_direction_q14(point->normal_q14, turned);
}

/* Edges are held to 30 bits, their product to 61. */
void qtri_face_normal(int32_t normal[3], const qtri_vec3 *a, const qtri_vec3 *b, const qtri_vec3 *c)
{
    const int64_t e[3] = {(int64_t)b->x - a->x, (int64_t)b->y - a->y, (int64_t)b->z - a->z};
    const int64_t f[3] = {(int64_t)c->x - a->x, (int64_t)c->y - a->y, (int64_t)c->z - a->z};
    const uint64_t e_all = qtri_magnitude64(e[0]) | qtri_magnitude64(e[1]) | qtri_magnitude64(e[2]);
    const uint64_t f_all = qtri_magnitude64(f[0]) | qtri_magnitude64(f[1]) | qtri_magnitude64(f[2]);
    const int32_t e_down = e_all >> 30 != 0 ? 3 : 0; /* below 2^33 */
    const int32_t f_down = f_all >> 30 != 0 ? 3 : 0;
    int64_t cross[3];
    for (int i = 0; i < 3; i++) {
        const int j = i < 2 ? i + 1 : 0;
        const int k = 3 - i - j;
        cross[i] = (e[j] >> e_down) * (f[k] >> f_down) - (e[k] >> e_down) * (f[j] >> f_down);
    }
    (void)qtri_direction_q14(normal, cross);
}

/* Rows times a position fit 64 bits; local units are 2^-24. */
void qtri_illuminated_place_uneven(qtri_lit_point *point, const qtri_row row[3], const qtri_vec3 *p)
{
    int64_t sum[3];
    int32_t exponent = 0;
    for (int i = 0; i < 3; i++) {
        const int32_t *m = row[i].m;
        sum[i] = qtri_mul_s32(m[0], p->x) + qtri_mul_s32(m[1], p->y) + qtri_mul_s32(m[2], p->z) +
                 row[i].t;
        const int32_t bits = 64 - qtri_clz64(qtri_magnitude64(sum[i]) | 1u);
        exponent = qtri_greatest32(exponent, bits - row[i].exponent + 8 - 29);
    }
    for (int i = 0; i < 3; i++) {
        const int32_t down = row[i].exponent - 8 + exponent;
        point->place[i] = (int32_t)(down >= 0 ? sum[i] >> (down > 63 ? 63 : down)
                                              : qtri_shift_left64(sum[i], -down));
    }
    point->exponent = exponent;
}
