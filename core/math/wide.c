#include "wide.h"

#include "bits.h"

qtri_wide qtri_wide_make(int64_t m, int32_t e)
{
    qtri_wide result = {0, 0};
    if (m == 0 || e > ((int32_t)1 << 30) || e < -((int32_t)1 << 30)) {
        return result; /* no caller comes near these exponents */
    }
    uint64_t size = qtri_magnitude64(m);
    int32_t shift = qtri_clz64(size) - 2;
    size = shift >= 0 ? size << shift : size >> -shift;
    e += shift;
    if (e > QTRI_WIDE_EXPONENT_MAX) {
        return result;
    }
    if (e < -QTRI_WIDE_EXPONENT_MAX) {
        e = -QTRI_WIDE_EXPONENT_MAX;
        size = ((uint64_t)1 << 62) - 1;
    }
    result.m = m < 0 ? -(int64_t)size : (int64_t)size;
    result.e = e;
    return result;
}

qtri_wide qtri_wide_neg(qtri_wide a)
{
    a.m = -a.m;
    return a;
}

qtri_wide qtri_wide_add(qtri_wide a, qtri_wide b)
{
    if (a.m == 0) {
        return b;
    }
    if (b.m == 0) {
        return a;
    }
    if (a.e > b.e) {
        qtri_wide swap = a;
        a = b;
        b = swap;
    }
    int32_t shift = b.e - a.e;
    return qtri_wide_make(a.m + (shift > 62 ? 0 : b.m >> shift), a.e); /* |sum| < 2^63 */
}

qtri_wide qtri_wide_sub(qtri_wide a, qtri_wide b)
{
    return qtri_wide_add(a, qtri_wide_neg(b));
}

qtri_wide qtri_wide_mul(qtri_wide a, qtri_wide b)
{
    uint64_t size = qtri_mul_high64(qtri_magnitude64(a.m) << 1, qtri_magnitude64(b.m) << 1);
    return qtri_wide_make((a.m < 0) == (b.m < 0) ? (int64_t)size : -(int64_t)size, a.e + b.e - 62);
}

qtri_wide qtri_wide_div(qtri_wide a, qtri_wide b)
{
    if (b.m == 0) {
        return qtri_wide_make(a.m, -2 * QTRI_WIDE_EXPONENT_MAX);
    }
    uint64_t rest = qtri_magnitude64(a.m);
    uint64_t divisor = qtri_magnitude64(b.m);
    uint64_t quotient = 0;
    for (int bit = 0; bit < 62; bit++) { /* rest < 2 divisor at the head of every step */
        quotient <<= 1;
        if (rest >= divisor) {
            rest -= divisor;
            quotient |= 1;
        }
        rest <<= 1;
    }
    int64_t m = (a.m < 0) == (b.m < 0) ? (int64_t)quotient : -(int64_t)quotient;
    return qtri_wide_make(m, a.e - b.e + 61);
}

qtri_wide qtri_wide_sqrt(qtri_wide a)
{
    if (a.m <= 0) {
        return qtri_wide_make(0, 0);
    }
    int32_t odd = a.e & 1;
    uint64_t remainder = 0;
    uint32_t root = qtri_sqrt64_floor((uint64_t)a.m << odd, &remainder); /* 31 bits */
    qtri_wide estimate = qtri_wide_make(root, (a.e + odd) / 2);
    /* Heron's step doubles the good bits: (r + a / r) / 2. */
    qtri_wide result = qtri_wide_add(estimate, qtri_wide_div(a, estimate));
    return qtri_wide_make(result.m, result.e + 1);
}

int qtri_wide_normalize(qtri_wide v[3])
{
    qtri_wide square = {0, 0};
    int32_t least = QTRI_WIDE_EXPONENT_MAX + 1;
    for (int i = 0; i < 3; i++) {
        if (v[i].m != 0 && v[i].e < least) {
            least = v[i].e;
        }
    }
    if (least > QTRI_WIDE_EXPONENT_MAX) {
        return 0;
    }
    qtri_wide unit[3];
    for (int i = 0; i < 3; i++) { /* bring the largest near 1, so that squares stay in range */
        unit[i] = qtri_wide_make(v[i].m, v[i].e - least + 62);
        square = qtri_wide_add(square, qtri_wide_mul(unit[i], unit[i]));
    }
    qtri_wide length = qtri_wide_sqrt(square);
    for (int i = 0; i < 3; i++) {
        v[i] = qtri_wide_div(unit[i], length);
    }
    return 1;
}

void qtri_wide_cross(qtri_wide out[3], const qtri_wide a[3], const qtri_wide b[3])
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        int k = (i + 2) % 3;
        out[i] = qtri_wide_sub(qtri_wide_mul(a[j], b[k]), qtri_wide_mul(a[k], b[j]));
    }
}
