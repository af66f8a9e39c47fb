#include "bits.h"

uint64_t qtri_quotient_digits(uint64_t *rest, uint64_t divisor, int32_t count)
{
    uint64_t left = *rest;
    uint64_t quotient = 0;
    for (; count > 0; count--) { /* left < 2 divisor at the head of every step */
        quotient <<= 1;
        if (left >= divisor) {
            left -= divisor;
            quotient |= 1;
        }
        left <<= 1;
    }
    *rest = left;
    return quotient;
}

uint64_t qtri_divide64(uint64_t n, uint64_t divisor, int32_t more, bool *half)
{
    int32_t up = qtri_clz64(divisor) - qtri_clz64(n); /* as many digits: then n < 2 divisor 2^up */
    up = up > 0 ? up : 0;
    divisor <<= up;
    uint64_t quotient = qtri_quotient_digits(&n, divisor, up + 1 + more);
    *half = n >= divisor;
    return quotient;
}
