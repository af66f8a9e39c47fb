/* SPDX-License-Identifier: MIT */
#include "qtri/quat.h"

#include "dot.h"

/*
 * What qtri_quat_mul does when 64 bits or 32 are not enough; high and low as in qtri_dot. Term k of
 * component i is a[k] b[i ^ k], negative where bit k of digit i of the mask is set.
 */
static qtri_quat exact_product(qtri_quat a, qtri_quat b)
{
    const q16 u[4] = {a.w, a.x, a.y, a.z};
    const q16 v[4] = {b.w, b.x, b.y, b.z};
    q16 product[4];
    uint32_t negative = 0x428E;
    for (int i = 0; i < 4; i++) {
        int64_t high = 0;
        uint32_t low = 0x8000u;
        for (int k = 0; k < 4; k++) {
            int64_t term = qtri_mul_s32(u[k], v[i ^ k]);
            term = (negative & 1u) != 0 ? -term : term;
            high += term >> 16;
            low += (uint32_t)term & 0xFFFFu;
            negative >>= 1;
        }
        product[i] = qtri_saturate32_checked(high + (int64_t)(low >> 16));
    }
    qtri_quat result = {product[0], product[1], product[2], product[3]};
    return result;
}

/* A macro, because GCC for small cores would call a function and copy what it takes. */
#define COMPONENT(b0, b1, b2, b3)                                                                  \
    do {                                                                                           \
        qtri_sum sum = qtri_sum_start();                                                           \
        qtri_sum_product(&sum, a.w, b0, &flags);                                                   \
        qtri_sum_product(&sum, a.x, b1, &flags);                                                   \
        qtri_sum_product(&sum, a.y, b2, &flags);                                                   \
        qtri_sum_product(&sum, a.z, b3, &flags);                                                   \
        result = qtri_sum_q16(&sum, &flags);                                                       \
    } while (0)

qtri_quat qtri_quat_mul(qtri_quat a, qtri_quat b)
{
    uint32_t flags = 0;
    q16 result;
    qtri_quat product;
    const qtri_right w = qtri_right_of(b.w, &flags);
    const qtri_right x = qtri_right_of(b.x, &flags);
    const qtri_right y = qtri_right_of(b.y, &flags);
    const qtri_right z = qtri_right_of(b.z, &flags);
    const qtri_right minus_x = qtri_right_opposite(b.x);
    const qtri_right minus_y = qtri_right_opposite(b.y);
    const qtri_right minus_z = qtri_right_opposite(b.z);
    COMPONENT(w, minus_x, minus_y, minus_z);
    product.w = result;
    COMPONENT(x, w, z, minus_y);
    product.x = result;
    COMPONENT(y, minus_z, w, x);
    product.y = result;
    COMPONENT(z, y, minus_x, w);
    product.z = result;
    return qtri_sum_good(flags) ? product : exact_product(a, b);
}
