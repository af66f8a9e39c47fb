#include "qtri/jitter.h"

/* n + 1 with its digits in base 2 behind the point, for n < 32: Q16. */
static int32_t halton2(uint32_t n)
{
    int32_t sum = 0;
    n++;
    for (int32_t share = 1 << 15; n != 0; share >>= 1, n >>= 1) {
        sum += (n & 1) != 0 ? share : 0;
    }
    return sum;
}

/* The same in base 3. */
static int32_t halton3(uint32_t n)
{
    static const int32_t shares[4] = {21845, 7282, 2427, 809}; /* 2^16 / 3, / 9 ..., rounded */
    int32_t sum = 0;
    n++;
    for (int i = 0; i < 4; i++, n /= 3) {
        sum += (int32_t)(n % 3) * shares[i];
    }
    return sum;
}

/* Clip coordinates of a part of a pixel, in the middle of -1/2 .. 1/2. */
static q16 clip_of(int32_t share, int32_t pixels)
{
    const int32_t half = 1 << 15;
    return pixels > 0 ? 2 * (share - half) / pixels : 0;
}

void qtri_view_jitter(qtri_view *out, const qtri_view *view, uint32_t n)
{
    qtri_transform moved;
    const qtri_vec3 by = {clip_of(halton2(n % QTRI_JITTER_COUNT), view->viewport.width),
                          clip_of(halton3(n % QTRI_JITTER_COUNT), view->viewport.height), 0};
    qtri_transform_identity(&moved);
    qtri_transform_translate(&moved, by);
    *out = *view;
    qtri_transform_mul(&out->projection, &moved, &view->projection);
}
