/* SPDX-License-Identifier: MIT */
/*
 * Vectors of two, three and four numbers.
 */
#include "qtri/error.h"
#include "qtri/q16.h"
#include "qtri/vec.h"

#include <stddef.h>
#include "dot.h"
#include "unit.h"

q16 qtri_vec2_dot(qtri_vec2 a, qtri_vec2 b)
{
    const q16 u[2] = {a.x, a.y};
    const q16 v[2] = {b.x, b.y};
    return qtri_dot(u, v, 2);
}

q16 qtri_vec3_dot(qtri_vec3 a, qtri_vec3 b)
{
    uint32_t flags = 0;
    qtri_sum sum = qtri_sum_start();
    qtri_sum_product(&sum, a.x, qtri_right_of(b.x, &flags), &flags);
    qtri_sum_product(&sum, a.y, qtri_right_beside(b.y, &flags), &flags);
    qtri_sum_product(&sum, a.z, qtri_right_beside(b.z, &flags), &flags);
    q16 result = qtri_sum_q16(&sum, &flags);
    if (qtri_sum_good(flags)) {
        return result;
    }
    qtri_vec4 u = {a.x, a.y, a.z, 0};
    qtri_vec4 v = {b.x, b.y, b.z, 0};
    return qtri_vec4_dot(u, v);
}

q16 qtri_vec4_dot(qtri_vec4 a, qtri_vec4 b)
{
    const q16 u[4] = {a.x, a.y, a.z, a.w};
    const q16 v[4] = {b.x, b.y, b.z, b.w};
    return qtri_dot(u, v, 4);
}

q16 qtri_vec2_cross(qtri_vec2 a, qtri_vec2 b)
{
    return qtri_dot_cross(a.x, b.y, a.y, b.x);
}

qtri_vec3 qtri_vec3_cross(qtri_vec3 a, qtri_vec3 b)
{
    qtri_vec3 product = {qtri_dot_cross(a.y, b.z, a.z, b.y), qtri_dot_cross(a.z, b.x, a.x, b.z),
                         qtri_dot_cross(a.x, b.y, a.y, b.x)};
    return product;
}

/* The unit of a square root of squared ULPs is the ULP: no scaling is needed. */
q16 qtri_vec_distance(const q16 *a, const q16 *b, int32_t count)
{
    QTRI_ASSERT(a != NULL);
    uint64_t square = 0;
    for (int32_t i = 0; i < count && square >> 62 == 0; i++) { /* < 2^62 + 2^62 */
        uint64_t size = qtri_magnitude64((int64_t)a[i] - (b != NULL ? b[i] : 0));
        square =
            size > INT32_MAX ? UINT64_MAX : square + qtri_mul_u32((uint32_t)size, (uint32_t)size);
    }
    uint64_t length = qtri_sqrt64_round(square);
    return qtri_saturate32_checked((int64_t)length); /* <= 2^32 */
}

void qtri_vec_normalize(q16 *out, const q16 *a, int32_t count)
{
    QTRI_ASSERT(out != NULL && a != NULL);
    (void)qtri_unit(out, a, count, 16);
}

void qtri_vec_along(q16 *out, const q16 *a, const q16 *b, int32_t count, int32_t keep,
                    int32_t times)
{
    QTRI_ASSERT(out != NULL && a != NULL && b != NULL);
    qtri_wide ratio;
    qtri_wide square;
    qtri_wide_dot(&ratio, a, b, count);
    qtri_wide_dot(&square, b, b, count);
    if (square.m != 0) {
        qtri_wide_div_by(&ratio, &square);
        qtri_wide_set(&square, times, 0);
        qtri_wide_mul_by(&ratio, &square);
    }
    for (int32_t i = 0; i < count; i++) {
        qtri_wide component;
        qtri_wide_set(&component, b[i], 16);
        out[i] = qtri_wide_less((int64_t)keep * a[i], &ratio, &component);
    }
}

/*
 * For unit vectors u, v at the angle A: |u - v| / 2 = sin(A/2) and |u + v| / 2 = cos(A/2), good for
 * every angle and any number of components (Kahan 2006, "How futile are mindless assessments of
 * roundoff", section 12). Then sin A = 2 sin cos and cos A = cos^2 - sin^2 of A/2.
 */
q16 qtri_vec_angle_deg(const q16 *a, const q16 *b, int32_t count)
{
    QTRI_ASSERT(a != NULL && b != NULL);
    int32_t u_q30[4];
    int32_t v_q30[4];
    if (!qtri_unit(u_q30, a, count, 30) || !qtri_unit(v_q30, b, count, 30)) {
        return 0;
    }
    uint64_t apart_q60 = 0;
    uint64_t along_q60 = 0;
    for (int32_t i = 0; i < count; i++) {
        int32_t difference = (u_q30[i] >> 1) - (v_q30[i] >> 1); /* halves: |.| <= 2^30 */
        int32_t sum = (u_q30[i] >> 1) + (v_q30[i] >> 1);
        apart_q60 += (uint64_t)qtri_mul_s32(difference, difference);
        along_q60 += (uint64_t)qtri_mul_s32(sum, sum);
    }
    uint32_t sine_q30 = (uint32_t)qtri_sqrt64_round(apart_q60);
    uint32_t cosine_q30 = (uint32_t)qtri_sqrt64_round(along_q60);
    int32_t y_q30 = (int32_t)(qtri_mul_u32(sine_q30, cosine_q30) >> 29);
    int32_t x_q30 = (int32_t)((int64_t)(along_q60 - apart_q60) >> 30); /* may be negative */
    return q16_atan2_deg(y_q30, x_q30); /* the ratio counts, not the unit */
}
