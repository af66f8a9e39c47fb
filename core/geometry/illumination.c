#include "illumination.h"

#include "../bits/seed.h"

/*
 * v / |v| for |v| < 2^15.5, not 0. q = v . v becomes v' = q 4^up / 2^32 in [1/4, 1), and y is
 * v'^-1/2 in Q15 within 2^-13: v / |v| = v y 2^up / 2^31.
 */
static void normalize_q14(int32_t out[3], const int32_t v[3], uint32_t square)
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
        scaled[i] = (int32_t)(down >= 0 ? v[i] >> down : v[i] * ((int64_t)1 << -down));
    }
    const uint32_t square = square_of(scaled);
    if (square == 0) {
        out[0] = 0;
        out[1] = 0;
        out[2] = 0;
        return false;
    }
    normalize_q14(out, scaled, square);
    return true;
}

QTRI_NOINLINE static void set_uneven(qtri_lit_point *point, const qtri_illumination *by,
                                     const int32_t v[3])
{
    int64_t turned[3]; /* < 3 2^15 2^29 */
    for (int row = 0; row < 3; row++) {
        const int32_t *m = by->normal_q28[row];
        turned[row] =
            qtri_mul_s32(m[0], v[0]) + qtri_mul_s32(m[1], v[1]) + qtri_mul_s32(m[2], v[2]);
    }
    (void)qtri_direction_q14(point->normal_q14, turned);
}

/*
 * Stored unit normals are within 2^-6 of length 1: there one step of Newton from 1 is enough. For
 * s = n . n = 1 + e, n (3 - s) / 2 is off by 3/8 e^2 < 2^-11.5.
 */
void qtri_illuminated_normal(qtri_lit_point *point, const qtri_illumination *by, int32_t x,
                             int32_t y, int32_t z)
{
    const uint32_t one_q28 = (uint32_t)1 << 28;
    int32_t *n = point->normal_q14;
    n[0] = x;
    n[1] = y;
    n[2] = z;
    if (!by->even) {
        const int32_t v[3] = {x, y, z};
        set_uneven(point, by, v);
        return;
    }
    const uint32_t square = square_of(n); /* <= 3 2^30 */
    if (square - (one_q28 - one_q28 / 32) < one_q28 / 16) {
        const int32_t factor_q15 = (int32_t)((3 * one_q28 - square) >> 14);
        n[0] = (x * factor_q15 + 0x4000) >> 15;
        n[1] = (y * factor_q15 + 0x4000) >> 15;
        n[2] = (z * factor_q15 + 0x4000) >> 15;
    } else if (square != 0) {
        const int32_t v[3] = {x, y, z};
        normalize_q14(n, v, square);
    }
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

void qtri_illuminated_place16(qtri_lit_point *point, const qtri_illumination *by,
                              const qtri_position16 *position)
{
    point->exponent = 0;
    if (by->even) {
        point->place[0] = position->x * 256;
        point->place[1] = position->y * 256;
        point->place[2] = position->z * 256;
        return;
    }
    for (int i = 0; i < 3; i++) {
        point->place[i] =
            qtri_row16_sum(&by->row.compact[i], position->x, position->y, position->z);
    }
}

/* Rows times a position, which fits 64 bits, in local units of 2^-24; the largest below 2^29. */
QTRI_NOINLINE static void place_uneven(qtri_lit_point *point, const qtri_row row[3],
                                       const qtri_vec3 *p)
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
                                              : sum[i] * ((int64_t)1 << -down));
    }
    point->exponent = exponent;
}

void qtri_illuminated_place(qtri_lit_point *point, const qtri_illumination *by,
                            const qtri_vec3 *position)
{
    if (!by->even) {
        place_uneven(point, by->row.wide, position);
        return;
    }
    const qtri_vec3 *p = position;
    const uint32_t all = qtri_magnitude32(p->x) | qtri_magnitude32(p->y) | qtri_magnitude32(p->z);
    const int32_t exponent = all >> 29 != 0 ? 2 : 0;
    point->exponent = exponent;
    point->place[0] = p->x >> exponent;
    point->place[1] = p->y >> exponent;
    point->place[2] = p->z >> exponent;
}

/*
 * Of sums below 2^32 there remain 23 bits, times 255 less than 2^31; base is below 2^27. Only the
 * eight sources together, each far too bright, come near that.
 */
static inline uint8_t reflect(uint32_t base_q15, uint32_t diffuse_q24, uint32_t specular_q24,
                              uint32_t color, uint32_t highlight)
{
    const uint32_t sum_q15 =
        base_q15 + (diffuse_q24 >> 9) * color + (specular_q24 >> 9) * highlight;
    const uint32_t value = (sum_q15 + 0x4000u) >> 15;
    return (uint8_t)(value > 255 ? 255 : value);
}

qtri_rgb qtri_illuminate(const qtri_illumination *by, qtri_lit_point *point, const qtri_rgb *color)
{
    point->view_q14 = by->view_q14;
    point->shininess = by->shininess;
    point->diffuse_q24[0] = by->ambient_q24[0];
    point->diffuse_q24[1] = by->ambient_q24[1];
    point->diffuse_q24[2] = by->ambient_q24[2];
    point->specular_q24[0] = 0;
    point->specular_q24[1] = 0;
    point->specular_q24[2] = 0;
    const qtri_shine *first = by->shine;
    for (int32_t i = 0; i < by->count; i++) {
        by->run[i].kind->add(first, by->run[i].end, point);
        first = by->run[i].end;
    }
    const qtri_rgb lit = {
        reflect(by->base_q15[0], point->diffuse_q24[0], point->specular_q24[0], color->r,
                by->specular.r),
        reflect(by->base_q15[1], point->diffuse_q24[1], point->specular_q24[1], color->g,
                by->specular.g),
        reflect(by->base_q15[2], point->diffuse_q24[2], point->specular_q24[2], color->b,
                by->specular.b),
    };
    return lit;
}
