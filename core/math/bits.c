#include "bits.h"

uint64_t qtri_mul_high64(uint64_t a, uint64_t b)
{
    uint64_t a_low = (uint32_t)a;
    uint64_t a_high = a >> 32;
    uint64_t b_low = (uint32_t)b;
    uint64_t b_high = b >> 32;
    uint64_t cross = a_high * b_low + ((a_low * b_low) >> 32); /* <= (2^32-1)^2 + 2^32-1 < 2^64 */
    uint64_t cross_low = a_low * b_high + (uint32_t)cross;     /* likewise */
    return a_high * b_high + (cross >> 32) + (cross_low >> 32);
}

/* One result bit a step, the schoolbook method in binary. */
uint32_t qtri_sqrt64_floor(uint64_t x, uint64_t *remainder)
{
    uint64_t root = 0;
    for (uint64_t bit = (uint64_t)1 << 62; bit != 0; bit >>= 2) {
        if (x >= root + bit) {
            x -= root + bit;
            root = (root >> 1) + bit;
        } else {
            root >>= 1;
        }
    }
    *remainder = x;
    return (uint32_t)root;
}

uint64_t qtri_sqrt64_round(uint64_t x)
{
    uint64_t remainder = 0;
    uint64_t root = qtri_sqrt64_floor(x, &remainder);
    return root + (remainder > root); /* x > (root + 1/2)^2 = root^2 + root + 1/4 */
}

/*
 * With d = x / 2^32 in [1/2, 1): Newton's r <- r (2 - d r) from the linear estimate
 * 48/17 - 32/17 d, off by at most 1/17. Three steps square that to 17^-8 < 2^-32; the truncations
 * in Q30 add a few units, which the remainder takes away again.
 */
uint32_t qtri_reciprocal_q62(uint32_t x)
{
    if (x <= 0x80000000u) {
        return 0x80000000u;
    }
    uint64_t r_q30 = 0xB4B4B4B4u - (uint32_t)(((uint64_t)x * 0x78787878u) >> 32);
    for (int step = 0; step < 3; step++) {
        uint64_t product_q30 = (x * r_q30) >> 32;            /* d r, close to 2^30 */
        r_q30 = (r_q30 * (0x80000000u - product_q30)) >> 30; /* both factors < 2^32 */
    }
    int64_t remainder = (int64_t)(((uint64_t)1 << 62) - x * r_q30);
    while (remainder < 0) {
        r_q30--;
        remainder += x;
    }
    while (remainder >= (int64_t)x) {
        r_q30++;
        remainder -= x;
    }
    return (uint32_t)r_q30;
}
