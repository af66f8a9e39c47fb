/* SPDX-License-Identifier: MIT */
#include "bits.h"

uint64_t qtri_divide64(uint64_t n, uint64_t divisor, int32_t more, bool *half)
{
    int32_t up = qtri_clz64(divisor) - qtri_clz64(n); /* as many digits: then n < 2 divisor 2^up */
    up = up > 0 ? up : 0;
    divisor <<= up;
    uint64_t quotient = 0;
    for (int32_t digits = up + 1 + more; digits > 0; digits--) {
        quotient <<= 1;
        if (n >= divisor) {
            n -= divisor;
            quotient |= 1;
        }
        n <<= 1; /* < 2 divisor again */
    }
    *half = n >= divisor;
    return quotient;
}
