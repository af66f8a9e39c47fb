#include "qtri/vec.h"

#include "bits.h"
#include "products.h"

qtri_vec3 qtri_vec3_add(qtri_vec3 a, qtri_vec3 b)
{
    qtri_vec3 sum = {q16_add(a.x, b.x), q16_add(a.y, b.y), q16_add(a.z, b.z)};
    return sum;
}

qtri_vec3 qtri_vec3_sub(qtri_vec3 a, qtri_vec3 b)
{
    qtri_vec3 difference = {q16_sub(a.x, b.x), q16_sub(a.y, b.y), q16_sub(a.z, b.z)};
    return difference;
}

qtri_vec3 qtri_vec3_scale(qtri_vec3 a, q16 s)
{
    qtri_vec3 product = {q16_mul(a.x, s), q16_mul(a.y, s), q16_mul(a.z, s)};
    return product;
}

qtri_vec3 qtri_vec3_lerp(qtri_vec3 a, qtri_vec3 b, q16 t)
{
    qtri_vec3 result = {q16_lerp(a.x, b.x, t), q16_lerp(a.y, b.y, t), q16_lerp(a.z, b.z, t)};
    return result;
}

q16 qtri_vec2_dot(qtri_vec2 a, qtri_vec2 b)
{
    qtri_products sum = {0, 0};
    qtri_products_add(&sum, a.x, b.x);
    qtri_products_add(&sum, a.y, b.y);
    return qtri_products_q16(&sum);
}

q16 qtri_vec3_dot(qtri_vec3 a, qtri_vec3 b)
{
    qtri_products sum = {0, 0};
    qtri_products_add(&sum, a.x, b.x);
    qtri_products_add(&sum, a.y, b.y);
    qtri_products_add(&sum, a.z, b.z);
    return qtri_products_q16(&sum);
}

q16 qtri_vec4_dot(qtri_vec4 a, qtri_vec4 b)
{
    qtri_products sum = {0, 0};
    qtri_products_add(&sum, a.x, b.x);
    qtri_products_add(&sum, a.y, b.y);
    qtri_products_add(&sum, a.z, b.z);
    qtri_products_add(&sum, a.w, b.w);
    return qtri_products_q16(&sum);
}

/* a b - c d, in Q16.16. */
static q16 determinant(q16 a, q16 b, q16 c, q16 d)
{
    qtri_products sum = {0, 0};
    qtri_products_add(&sum, a, b);
    qtri_products_subtract(&sum, c, d);
    return qtri_products_q16(&sum);
}

qtri_vec3 qtri_vec3_cross(qtri_vec3 a, qtri_vec3 b)
{
    qtri_vec3 product = {determinant(a.y, b.z, a.z, b.y), determinant(a.z, b.x, a.x, b.z),
                         determinant(a.x, b.y, a.y, b.x)};
    return product;
}

static uint64_t square(q16 x)
{
    return (uint64_t)((int64_t)x * x); /* <= 2^62: three of them fit 64 bits unsigned */
}

/* The unit of a square root of squared ULPs is the ULP: no scaling is needed. */
static q16 length_of(uint64_t sum_of_squares)
{
    uint64_t length = qtri_sqrt64_round(sum_of_squares);
    return length > (uint64_t)Q16_MAX ? Q16_MAX : (q16)length;
}

q16 qtri_vec2_length(qtri_vec2 a)
{
    return length_of(square(a.x) + square(a.y));
}

q16 qtri_vec3_length(qtri_vec3 a)
{
    return length_of(square(a.x) + square(a.y) + square(a.z));
}

static q16 divide_component(int64_t x, uint64_t length)
{
    uint64_t quotient = ((qtri_magnitude64(x) << 16) + length / 2) / length; /* <= 2^16 */
    return x < 0 ? -(q16)quotient : (q16)quotient;
}

qtri_vec3 qtri_vec3_normalize(qtri_vec3 a)
{
    uint64_t all = qtri_magnitude64(a.x) | qtri_magnitude64(a.y) | qtri_magnitude64(a.z);
    if (all == 0) {
        return a;
    }
    /* Scale the largest component to 31 bits: a short vector must not lose its direction. */
    int64_t scale = (int64_t)1 << (qtri_clz64(all) > 33 ? qtri_clz64(all) - 33 : 0);
    int64_t x = a.x * scale;
    int64_t y = a.y * scale;
    int64_t z = a.z * scale; /* |x|, |y|, |z| <= 2^31 */
    uint64_t length = qtri_sqrt64_round((uint64_t)(x * x) + (uint64_t)(y * y) + (uint64_t)(z * z));
    qtri_vec3 unit = {divide_component(x, length), divide_component(y, length),
                      divide_component(z, length)};
    return unit;
}
