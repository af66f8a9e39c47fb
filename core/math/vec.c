/* SPDX-License-Identifier: MIT */
#include "qtri/vec.h"
#include "qtri/error.h"

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
