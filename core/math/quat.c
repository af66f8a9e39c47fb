#include "qtri/quat.h"

#include "qtri/q16_trig.h"
#include "bits.h"
#include "products.h"
#include "sincos.h"

qtri_quat qtri_quat_identity(void)
{
    qtri_quat identity = {Q16_ONE, 0, 0, 0};
    return identity;
}

qtri_quat qtri_quat_from_axis_deg(qtri_vec3 axis, q16 degrees)
{
    qtri_vec3 unit = qtri_vec3_normalize(axis);
    if ((unit.x | unit.y | unit.z) == 0) {
        return qtri_quat_identity();
    }
    q16 sine;
    q16 cosine;
    q16_sincos_deg(degrees / 2, &sine, &cosine);
    qtri_quat result = {cosine, q16_mul(unit.x, sine), q16_mul(unit.y, sine),
                        q16_mul(unit.z, sine)};
    return result;
}

qtri_quat qtri_quat_mul(qtri_quat a, qtri_quat b)
{
    qtri_products w = {0, 0};
    qtri_products x = {0, 0};
    qtri_products y = {0, 0};
    qtri_products z = {0, 0};
    qtri_products_add(&w, a.w, b.w);
    qtri_products_subtract(&w, a.x, b.x);
    qtri_products_subtract(&w, a.y, b.y);
    qtri_products_subtract(&w, a.z, b.z);
    qtri_products_add(&x, a.w, b.x);
    qtri_products_add(&x, a.x, b.w);
    qtri_products_add(&x, a.y, b.z);
    qtri_products_subtract(&x, a.z, b.y);
    qtri_products_add(&y, a.w, b.y);
    qtri_products_subtract(&y, a.x, b.z);
    qtri_products_add(&y, a.y, b.w);
    qtri_products_add(&y, a.z, b.x);
    qtri_products_add(&z, a.w, b.z);
    qtri_products_add(&z, a.x, b.y);
    qtri_products_subtract(&z, a.y, b.x);
    qtri_products_add(&z, a.z, b.w);
    qtri_quat product = {qtri_products_q16(&w), qtri_products_q16(&x), qtri_products_q16(&y),
                         qtri_products_q16(&z)};
    return product;
}

qtri_quat qtri_quat_conjugate(qtri_quat a)
{
    qtri_quat result = {a.w, q16_neg(a.x), q16_neg(a.y), q16_neg(a.z)};
    return result;
}

static q16 divide_component(q16 x, uint64_t length)
{
    uint64_t quotient = ((qtri_magnitude64(x) << 31) + length / 2) / length; /* < 2^62, <= 2^31 */
    q16 size = (q16)((quotient + 0x4000) >> 15);
    return x < 0 ? -size : size;
}

qtri_quat qtri_quat_normalize(qtri_quat a)
{
    /* Quarter squares: four of up to 2^60 fit. Short quaternions are scaled up before. */
    uint64_t all = qtri_magnitude64(a.w) | qtri_magnitude64(a.x) | qtri_magnitude64(a.y) |
                   qtri_magnitude64(a.z);
    if (all == 0) {
        return qtri_quat_identity();
    }
    int32_t zeros = qtri_clz64(all);
    int64_t component[4] = {a.w, a.x, a.y, a.z};
    uint64_t sum = 0;
    for (int i = 0; i < 4; i++) {
        component[i] = zeros >= 34 ? component[i] * ((int64_t)1 << (zeros - 34))
                                   : component[i] / 2; /* below 2^30, or 2^30 for Q16_MIN */
        sum += (uint64_t)(component[i] * component[i]);
    }
    uint64_t length = qtri_sqrt64_round(sum);
    qtri_quat result = {
        divide_component((q16)component[0], length), divide_component((q16)component[1], length),
        divide_component((q16)component[2], length), divide_component((q16)component[3], length)};
    return result;
}

/* a b - c d for |a|, |c| <= 2^16 and |b|, |d| < 2^45. */
static int64_t determinant(q16 a, int64_t b, q16 c, int64_t d)
{
    return a * b - c * d;
}

/*
 * v + 2 w (u x v) + 2 u x (u x v), u the vector part, for the normalised quaternion. Parts of the
 * sum may exceed a q16 where the result does not: 64 bits throughout.
 */
qtri_vec3 qtri_quat_rotate(qtri_quat a, qtri_vec3 v)
{
    qtri_quat n = qtri_quat_normalize(a);
    const q16 u[3] = {n.x, n.y, n.z};
    const q16 p[3] = {v.x, v.y, v.z};
    int64_t once_q24[3];
    q16 result[3];
    for (int i = 0; i < 3; i++) { /* |u x v| < 2^48 in Q32, and < 2^41 in Q24 */
        int j = (i + 1) % 3;
        int k = (i + 2) % 3;
        once_q24[i] = qtri_shift_round(determinant(u[j], p[k], u[k], p[j]), 8);
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        int k = (i + 2) % 3;
        int64_t half_q40 =
            n.w * once_q24[i] + determinant(u[j], once_q24[k], u[k], once_q24[j]); /* < 2^59 */
        result[i] = qtri_saturate32(p[i] + qtri_shift_round(half_q40, 23));
    }
    qtri_vec3 turned = {result[0], result[1], result[2]};
    return turned;
}
