#include "dot.h"

/* high 2^16 + low in Q32: four products of 2^62 and more would not fit 64 bits. */
int32_t qtri_dot(const int32_t *a, const int32_t *b, int32_t count)
{
    int64_t high = 0;
    uint32_t low = 0x8000u; /* below 5 2^16 */
    for (int32_t i = 0; i < count; i++) {
        int64_t product = qtri_mul_s32(a[i], b[i]);
        high += product >> 16;
        low += (uint32_t)product & 0xFFFFu;
    }
    return qtri_saturate32_checked(high + (int64_t)(low >> 16));
}
