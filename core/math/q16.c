#include "qtri/q16.h"

#include "bits.h"

q16 q16_from_int(int32_t x)
{
    return qtri_saturate32((int64_t)x * 65536);
}

q16 q16_from_ratio(int32_t numerator, int32_t denominator)
{
    return q16_div(numerator, denominator);
}

int32_t q16_to_int_floor(q16 x)
{
    return x >> 16;
}

int32_t q16_to_int_round(q16 x)
{
    return (x >> 16) + ((x >> 15) & 1);
}

q16 q16_add(q16 a, q16 b)
{
    return qtri_saturate32((int64_t)a + b);
}

q16 q16_sub(q16 a, q16 b)
{
    return qtri_saturate32((int64_t)a - b);
}

q16 q16_neg(q16 x)
{
    return q16_sub(0, x);
}

q16 q16_abs(q16 x)
{
    return x < 0 ? q16_neg(x) : x;
}

q16 q16_mul(q16 a, q16 b)
{
    return qtri_saturate32(((int64_t)a * b + 0x8000) >> 16);
}

q16 q16_mul_floor(q16 a, q16 b)
{
    return qtri_saturate32(((int64_t)a * b) >> 16);
}

q16 q16_div(q16 a, q16 b)
{
    if (b == 0) {
        return a == 0 ? 0 : (a > 0 ? Q16_MAX : Q16_MIN);
    }
    uint64_t divisor = qtri_magnitude64(b);
    uint64_t quotient = ((qtri_magnitude64(a) << 16) + divisor / 2) / divisor; /* < 2^47 + 1 */
    return qtri_saturate32((a < 0) == (b < 0) ? (int64_t)quotient : -(int64_t)quotient);
}

q16 q16_lerp(q16 a, q16 b, q16 t)
{
    int64_t difference = (int64_t)b - a; /* 33 bits: the product with t needs 64 at most */
    return qtri_saturate32(a + ((difference * t + 0x8000) >> 16));
}

q16 q16_sqrt(q16 x)
{
    return x <= 0 ? 0 : (q16)qtri_sqrt64_round((uint64_t)x << 16); /* < 2^23.5 */
}
