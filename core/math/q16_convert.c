/*
 * Q16.16 from and to integers and other fixed-point formats.
 */
#include "qtri/q16.h"

#include "bits.h"

/* value 2^shift, correctly rounded, halves up, saturated. */
static int32_t scaled(int32_t value, int shift)
{
    if (shift < 0) {
        if (shift <= -32) {
            return 0; /* at least -1/2, less than 1/2 */
        }
        int32_t twice = value >> (-shift - 1);
        return (twice >> 1) + (twice & 1);
    }
    int32_t limit = shift < 32 ? (int32_t)((uint32_t)INT32_MAX >> shift) : 0;
    bool fits = value <= limit && value >= (shift < 32 ? -limit - 1 : 0);
    QTRI_MATH_CHECK(fits);
    return fits ? (int32_t)((uint32_t)value << (shift & 31)) : qtri_extreme32(value);
}

q16 q16_from_fixed(int32_t value, int fraction_bits)
{
    return scaled(value, fraction_bits < -64 ? 80 : 16 - (fraction_bits > 64 ? 64 : fraction_bits));
}

int32_t q16_to_fixed(q16 x, int fraction_bits)
{
    return scaled(x, fraction_bits > 64 ? 48 : (fraction_bits < -64 ? -80 : fraction_bits - 16));
}

q16 q16_from_int(int32_t x)
{
    return scaled(x, 16);
}
