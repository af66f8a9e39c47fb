/* SPDX-License-Identifier: MIT */
#include "picture.h"

#include "qtri/q16_trig.h"

void qtri_affine_place(qtri_affine *affine, q16 pivot_x, q16 pivot_y, q16 place_x, q16 place_y,
                       q16 scale_x, q16 scale_y, q16 degrees)
{
    q16 sine;
    q16 cosine;
    q16_sincos_deg(degrees, &sine, &cosine);
    affine->xx = q16_mul(scale_x, cosine);
    affine->xy = q16_mul(scale_y, -sine);
    affine->yx = q16_mul(scale_x, sine);
    affine->yy = q16_mul(scale_y, cosine);
    affine->x0 =
        q16_sub(place_x, q16_add(q16_mul(affine->xx, pivot_x), q16_mul(affine->xy, pivot_y)));
    affine->y0 =
        q16_sub(place_y, q16_add(q16_mul(affine->yx, pivot_x), q16_mul(affine->yy, pivot_y)));
}

/* From the surface back to the picture: Q16.16, |.| < 2^30. */
typedef struct inverse {
    int32_t ux, uy, vx, vy;
} inverse;

#define LIMIT ((uint32_t)1 << 30)

/* Q16.16 c / determinant, rounded, below 2^30: c 2^32 / determinant is where 4 c < determinant. */
static bool divide(int32_t c, int64_t determinant_q32, int32_t *quotient)
{
    bool half;
    const uint32_t n = qtri_magnitude32(c);
    const uint64_t divisor = qtri_magnitude64(determinant_q32);
    if ((uint64_t)n << 2 >= divisor) {
        return false;
    }
    const uint64_t q = qtri_divide64(n, divisor, 32, &half);
    const int32_t rounded = (int32_t)(q + half);
    *quotient = (c < 0) != (determinant_q32 < 0) ? -rounded : rounded;
    return true;
}

/* With all numbers below 2^30 the determinant is below 2^61. */
static bool invert(const qtri_affine *m, inverse *to)
{
    const int32_t all[6] = {m->xx, m->xy, m->yx, m->yy, m->x0, m->y0};
    for (int i = 0; i < 6; i++) {
        if (qtri_magnitude32(all[i]) >= LIMIT) {
            return false;
        }
    }
    const int64_t determinant = qtri_mul_s32(m->xx, m->yy) - qtri_mul_s32(m->xy, m->yx);
    return determinant != 0 && divide(m->yy, determinant, &to->ux) &&
           divide(-m->xy, determinant, &to->uy) && divide(-m->yx, determinant, &to->vx) &&
           divide(m->xx, determinant, &to->vy);
}

/*
 * Steps 0 <= k < *end, from *first on, where 0 <= start + k step < limit, limit > 0. |start| <
 * 2^46, and it is linear: what is left is one run.
 */
static void clip_run(int64_t start, int32_t step, int32_t limit, int32_t *first, int32_t *end)
{
    bool half;
    if (step < 0) { /* from the other side: 0 <= limit - 1 - start + k |step| < limit */
        start = limit - 1 - start;
        step = -step;
    }
    if (step == 0) {
        *end = start < 0 || start >= limit ? 0 : *end;
        return;
    }
    if (start < 0) {
        const uint64_t k =
            qtri_divide64((uint64_t)(-start) + (uint32_t)step - 1, (uint32_t)step, 0, &half);
        *first = k < (uint32_t)*end ? qtri_greatest32(*first, (int32_t)k) : *end;
    }
    if (start >= limit) {
        *end = 0;
    } else if (start + (int64_t)step * *end > limit - 1) {
        const uint64_t k =
            qtri_divide64((uint64_t)(limit - 1 - start), (uint32_t)step, 0, &half) + 1;
        *end = k < (uint32_t)*end ? (int32_t)k : *end;
    }
}

typedef struct run {
    const qtri_surface *surface;
    const qtri_image *image;
    inverse inverse;
    uint32_t a; /* of 256 */
    bool is_alike;
} run;

/* u and v stay within the picture, below 2^29, all the way. */
static void fetch(const run *r, int32_t u, int32_t v, uint32_t *stored, int32_t count)
{
    const qtri_image *image = r->image;
    const uint8_t *pixels = (const uint8_t *)image->pixels;
    const int32_t bytes = image->format->pixels->bytes;
    const ptrdiff_t pitch = image->pitch;
    const int32_t du = r->inverse.ux;
    const int32_t dv = r->inverse.vx;
    if (bytes == 2) {
        for (; count > 0; count--) {
            const uint8_t *row = pixels + (v >> 16) * pitch;
            *stored++ = ((const uint16_t *)(const void *)row)[u >> 16];
            u = (int32_t)((uint32_t)u + (uint32_t)du);
            v = (int32_t)((uint32_t)v + (uint32_t)dv);
        }
        return;
    }
    for (; count > 0; count--) {
        *stored++ = image->format->pixels->load(pixels + (v >> 16) * pitch + (u >> 16) * bytes);
        u = (int32_t)((uint32_t)u + (uint32_t)du); /* one step past the end wraps, unused */
        v = (int32_t)((uint32_t)v + (uint32_t)dv);
    }
}

static void paint_run(const run *r, uint8_t *to, int64_t u, int64_t v, int32_t count)
{
    const qtri_pixels *pixels = r->surface->format->pixels;
    uint32_t stored[QTRI_PICTURE_BATCH];
    for (; count > 0; count -= QTRI_PICTURE_BATCH) {
        const int32_t n = qtri_least32(count, QTRI_PICTURE_BATCH);
        fetch(r, (int32_t)u, (int32_t)v, stored, n);
        const uint32_t mask = qtri_picture_mask(r->image, stored, n);
        if (!r->is_alike) {
            qtri_picture_convert(r->image, r->surface, stored, n);
        }
        if (r->a == 256) {
            pixels->store(to, stored, mask, n);
        } else {
            qtri_picture_mix(r->surface, to, stored, mask, n, r->a);
        }
        u += (int64_t)r->inverse.ux * n;
        v += (int64_t)r->inverse.vx * n;
        to += (ptrdiff_t)pixels->bytes * n;
    }
}

/* x y + x' y' in Q16.16, rounded down. |x|, |x'| < 2^31, factors below 2^30: below 2^62. */
static int64_t coordinate(int32_t x, int32_t by, int32_t x2, int32_t by2)
{
    return (qtri_mul_s32(x, by) + qtri_mul_s32(x2, by2)) >> 16;
}

/*
 * The rows that the picture may reach, a few more where its corners lie. What it covers is decided
 * by the inverse, whose roundings move a row by 8192 / 131072 times the scale: 1/4 where that is 4.
 */
static void narrow_rows(const qtri_affine *m, const qtri_image *image, qtri_rect *bounds)
{
    const int32_t most = (int32_t)4 * 65536;
    if (qtri_magnitude32(m->yx) > (uint32_t)most || qtri_magnitude32(m->yy) > (uint32_t)most) {
        return;
    }
    const int64_t x = qtri_mul_s32(m->yx, image->width); /* |.| <= 2^18 2^13 */
    const int64_t y = qtri_mul_s32(m->yy, image->height);
    const int64_t least = (m->y0 + (x < 0 ? x : 0) + (y < 0 ? y : 0)) >> 16;
    const int64_t greatest = (m->y0 + (x > 0 ? x : 0) + (y > 0 ? y : 0)) >> 16;
    bounds->y0 = qtri_greatest32(bounds->y0, (int32_t)least - 1);
    bounds->y1 = qtri_least32(bounds->y1, (int32_t)greatest + 2);
}

void qtri_image_paint_affine(const qtri_surface *surface, const qtri_image *image,
                             const qtri_affine *affine, uint8_t alpha)
{
    run r = {surface, image, {0, 0, 0, 0}, qtri_mix_weight(255, alpha), false};
    qtri_rect bounds = qtri_surface_bounds(surface);
    if (alpha == 0 || bounds.x0 == bounds.x1 || !qtri_picture_is_usable(image) ||
        !invert(affine, &r.inverse)) {
        return;
    }
    r.is_alike = qtri_picture_is_alike(image, surface);
    narrow_rows(affine, image, &bounds);
    for (int32_t row = bounds.y0; row < bounds.y1; row++) {
        /* The centre of the row's first pixel, from where (0, 0) of the picture lies. */
        const int32_t x = bounds.x0 * 65536 + 32768 - affine->x0; /* |.| < 2^30 + 2^29 + 2^15 */
        const int32_t y = row * 65536 + 32768 - affine->y0;
        const int64_t u = coordinate(x, r.inverse.ux, y, r.inverse.uy);
        const int64_t v = coordinate(x, r.inverse.vx, y, r.inverse.vy);
        int32_t first = 0;
        int32_t end = bounds.x1 - bounds.x0;
        clip_run(u, r.inverse.ux, image->width * 65536, &first, &end);
        clip_run(v, r.inverse.vx, image->height * 65536, &first, &end);
        if (first < end) {
            paint_run(&r, qtri_surface_at(surface, bounds.x0 + first, row),
                      u + (int64_t)r.inverse.ux * first, v + (int64_t)r.inverse.vx * first,
                      end - first);
        }
    }
}
