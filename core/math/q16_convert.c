/* SPDX-License-Identifier: MIT */
/*
 * Q16.16 from and to integers and other fixed-point formats.
 */
#include "qtri/q16.h"

#include "scaled.h"

q16 q16_from_fixed(int32_t value, int fraction_bits)
{
    return qtri_scaled(value,
                       fraction_bits < -64 ? 80 : 16 - (fraction_bits > 64 ? 64 : fraction_bits));
}

int32_t q16_to_fixed(q16 x, int fraction_bits)
{
    return qtri_scaled(x,
                       fraction_bits > 64 ? 48 : (fraction_bits < -64 ? -80 : fraction_bits - 16));
}

q16 q16_from_int(int32_t x)
{
    return qtri_scaled(x, 16);
}
