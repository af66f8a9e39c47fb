/* SPDX-License-Identifier: MIT */
/* Images under an affine transform: rotated, scaled and sheared. */
#include "picture.h"

#include "qtri/error.h"
#include "qtri/q16.h"

#include "../frame/pixel.h"

#ifdef QTRI_CHECKED
/* Whether one is too far from 0 for an integer in place of a Q16.16, or both are 0. */
static bool is_scale(q16 x, q16 y)
{
    return (x == 0 && y == 0) || x > 15 || x < -15 || y > 15 || y < -15;
}
#endif

void qtri_affine_place(qtri_affine *affine, q16 pivot_x, q16 pivot_y, q16 place_x, q16 place_y,
                       q16 scale_x, q16 scale_y, q16 degrees)
{
    QTRI_ASSERT(affine != NULL);
    QTRI_ASSERT(is_scale(scale_x, scale_y));
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

/* A column of a row, and a coordinate there. */
typedef struct bound {
    int64_t at; /* |.| < 2^47 */
    int32_t column;
} bound;

/*
 * A texture coordinate along a row of the surface, and the columns at which it enters and leaves
 * the image. It is linear: all rows together move either column by no more than a row's width.
 */
typedef struct axis {
    bound low, high; /* of high, the coordinate less the image's size */
    int32_t step;    /* a column, >= 0: a negative one is mirrored */
    int32_t row;     /* a row */
} axis;

/* Begins before the first row. */
static void axis_init(axis *x, int64_t start, int32_t step, int32_t row, int32_t size)
{
    const bool is_mirrored = step < 0;
    x->step = is_mirrored ? -step : step;
    x->row = is_mirrored ? -row : row;
    x->low.column = 0;
    x->high.column = 0;
    x->low.at = (is_mirrored ? size - 1 - start : start) - x->row;
    x->high.at = x->low.at - size;
}

/* Goes on to the next row, and the first of columns 0..count whose coordinate is 0 or more. */
static inline void bound_next(bound *b, const axis *x, int32_t count)
{
    int64_t at = b->at + x->row;
    int32_t column = b->column;
    for (; at < 0 && column < count; column++) {
        at += x->step;
    }
    for (; at >= x->step && column > 0; column--) {
        at -= x->step;
    }
    b->at = at;
    b->column = column;
}

static void axis_next(axis *x, int32_t count)
{
    bound_next(&x->low, x, count);
    bound_next(&x->high, x, count);
}

typedef struct run {
    const qtri_surface *surface;
    const qtri_image *image;
    inverse inverse;
    int32_t u, v;        /* of the first pixel, in the picture */
    uint32_t a;          /* of 256 */
    bool is_alike;       /* pixels mean the same on both sides, */
    bool is_swapped;     /*   or have their bytes in the other order */
    int32_t kept_v;      /* where it does not turn: the row of the picture that was last, */
    const uint8_t *kept; /*   and its first pixel on the surface; NULL: none */
} run;

/* Loads stored pixels along u and v, which stay within the image; a step past the end may wrap. */
static void load_pixels(const run *r, uint32_t u, uint32_t v, uint32_t *stored, int32_t count)
{
    const qtri_image *image = r->image;
    const uint8_t *pixels = (const uint8_t *)image->pixels;
    const int32_t bytes = image->format->pixels->bytes;
    const ptrdiff_t pitch = image->pitch;
    const uint32_t du = (uint32_t)r->inverse.ux;
    const uint32_t dv = (uint32_t)r->inverse.vx;
    if (bytes == 2) {
        for (; count > 0; count--, u += du, v += dv) {
            const uint8_t *row = pixels + (ptrdiff_t)(v >> 16) * pitch;
            *stored++ = ((const uint16_t *)(const void *)row)[u >> 16];
        }
        return;
    }
    for (; count > 0; count--, u += du, v += dv) {
        const uint8_t *row = pixels + (ptrdiff_t)(v >> 16) * pitch;
        *stored++ = image->format->pixels->load(row + (ptrdiff_t)(u >> 16) * bytes);
    }
}

/* Constants of a loop: bytes a pixel, whether there is a key, whether v changes along a row, and
   whether bytes swap. */
typedef struct kind {
    uint32_t bytes;
    bool is_keyed, is_turned, swaps;
} kind;

QTRI_INLINE void walk_row(kind is, const run *r, uint8_t *to, int32_t count)
{
    const qtri_image *image = r->image;
    const ptrdiff_t pitch = image->pitch;
    const uint8_t *pixels = (const uint8_t *)image->pixels;
    const uint32_t mask = is.is_keyed && is.bytes == 4 ? qtri_picture_key_mask(image) : UINT32_MAX;
    const uint32_t key = image->has_key ? image->key & mask : UINT32_MAX; /* none of 16 bits */
    const uint32_t du = (uint32_t)r->inverse.ux;
    const uint32_t dv = (uint32_t)r->inverse.vx;
    uint32_t u = (uint32_t)r->u;
    uint32_t v = (uint32_t)r->v;
    if (!is.is_turned) {
        pixels += (ptrdiff_t)(v >> 16) * pitch;
    }
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint8_t *row = is.is_turned ? pixels + (ptrdiff_t)(v >> 16) * pitch : pixels;        \
        const uint32_t stored =                                                                    \
            qtri_load(is.bytes, row + (ptrdiff_t)(u >> 16) * (ptrdiff_t)is.bytes);                 \
        u += du;                                                                                   \
        QTRI_BODY_BARRIER(u);                                                                      \
        if (is.is_turned) {                                                                        \
            v += dv;                                                                               \
            QTRI_BODY_BARRIER(v);                                                                  \
        }                                                                                          \
        if (!is.is_keyed) {                                                                        \
            qtri_save(is.bytes, to + (i)*is.bytes, stored);                                        \
        } else if ((stored & mask) != key) {                                                       \
            QTRI_BODY_BRANCH();                                                                    \
            qtri_save(is.bytes, to + (i)*is.bytes, is.swaps ? qtri_swap_16(stored) : stored);      \
        }                                                                                          \
    }
    for (; count >= 4; count -= 4) {
        ONE(0)
        ONE(1)
        ONE(2)
        ONE(3)
        to += 4 * is.bytes;
    }
    for (; count > 0; count--) {
        ONE(0)
        to += is.bytes;
    }
#undef ONE
}

QTRI_INLINE void walk_sized(uint32_t bytes, const run *r, uint8_t *to, int32_t count)
{
    const kind plain = {bytes, false, false, false};
    const kind turned = {bytes, false, true, false};
    const kind keyed = {bytes, true, false, false};
    const kind keyed_turned = {bytes, true, true, false};
    if (!r->image->has_key) {
        if (r->inverse.vx == 0) {
            walk_row(plain, r, to, count);
        } else {
            walk_row(turned, r, to, count);
        }
    } else if (r->inverse.vx == 0) {
        walk_row(keyed, r, to, count);
    } else {
        walk_row(keyed_turned, r, to, count);
    }
}

/*
 * Copies pixels to a surface of the image's format, or of it in the other order of bytes, except
 * those of the key. False: nothing is done, as batches take less code.
 */
QTRI_NOINLINE static bool walk_pixels(const run *r, uint8_t *to, int32_t count)
{
    const qtri_image *image = r->image;
    const int32_t bytes = image->format->pixels->bytes;
    if (QTRI_BODY_IS_SMALL) {
        return false;
    }
    if (r->is_swapped) {
        const kind swapped = {2, true, true, true};
        walk_row(swapped, r, to, count);
        return true;
    }
    if (r->inverse.vx == 0 && r->inverse.ux == 65536 && !image->has_key) {
        const uint8_t *row =
            (const uint8_t *)image->pixels + (ptrdiff_t)(r->v >> 16) * image->pitch;
        qtri_copy(to, row + (ptrdiff_t)(r->u >> 16) * bytes, (size_t)bytes * (size_t)count);
        return true;
    }
    if (bytes < 1 || bytes > 4) {
        return false;
    }
    switch (bytes) {
        QTRI_BYTES_CASES(walk_sized, r, to, count);
    }
    return true;
}

/* Paints pixels that are converted, or blended. */
static void paint_batches(const run *r, uint8_t *to, int32_t count)
{
    uint32_t u = (uint32_t)r->u;
    uint32_t v = (uint32_t)r->v;
    uint32_t stored[QTRI_PICTURE_BATCH];
    for (; count > 0; count -= QTRI_PICTURE_BATCH) {
        const int32_t n = qtri_least32(count, QTRI_PICTURE_BATCH);
        load_pixels(r, u, v, stored, n);
        qtri_picture_put(r->surface, r->image, to, stored, n, r->a);
        u += (uint32_t)r->inverse.ux * (uint32_t)n;
        v += (uint32_t)r->inverse.vx * (uint32_t)n;
        to += (ptrdiff_t)r->surface->format->pixels->bytes * n;
    }
}

/*
 * Paints a run of pixels. Where the image is upright and opaque, a row of it that is painted again
 * is copied from above: runs are then equal in all rows.
 */
static void paint_run(run *r, uint8_t *to, int32_t count)
{
    const qtri_image *image = r->image;
    const int32_t bytes = r->surface->format->pixels->bytes;
    const bool is_upright = r->inverse.vx == 0 && r->inverse.uy == 0;
    if (is_upright && r->a == 256 && !image->has_key) {
        if (r->kept != NULL && r->kept_v == r->v >> 16) {
            qtri_copy(to, r->kept, (size_t)bytes * (size_t)count);
            return;
        }
        r->kept_v = r->v >> 16;
        r->kept = to;
    }
    if (r->a != 256 || !(r->is_alike || r->is_swapped) || !walk_pixels(r, to, count)) {
        paint_batches(r, to, count);
    }
}

/* x y + x' y' in Q16.16, rounded down. |x|, |x'| < 2^31, factors below 2^30: below 2^62. */
static int64_t coordinate(int32_t x, int32_t by, int32_t x2, int32_t by2)
{
    return (qtri_mul_s32(x, by) + qtri_mul_s32(x2, by2)) >> 16;
}

/*
 * Clips rows or columns to those that the image may reach, and `more` on both sides; `start`, by_x
 * and by_y: the affine's numbers for them. What the image covers is decided by the inverse, whose
 * roundings move a row by 8192 / 131072 times the scale: 1/4 where that is 4. Of a pixel in the
 * picture x and y lie within 2^16 and 2^15 of where the picture is, so that the inverse moves u and
 * v by .75, and that a column by less than 8.
 */
static void clip_range(int32_t start, q16 by_x, q16 by_y, const qtri_image *image, int32_t more,
                       int32_t *first, int32_t *end)
{
    const uint32_t most = (uint32_t)4 * 65536;
    if (qtri_magnitude32(by_x) > most || qtri_magnitude32(by_y) > most) {
        return;
    }
    const int64_t x = qtri_mul_s32(by_x, image->width); /* |.| <= 2^18 2^13 */
    const int64_t y = qtri_mul_s32(by_y, image->height);
    const int64_t least = (start + (x < 0 ? x : 0) + (y < 0 ? y : 0)) >> 16;
    const int64_t greatest = (start + (x > 0 ? x : 0) + (y > 0 ? y : 0)) >> 16;
    *first = qtri_greatest32(*first, (int32_t)least - more);
    *end = qtri_least32(*end, (int32_t)greatest + more + 1);
}

void qtri_image_paint_affine(const qtri_surface *surface, const qtri_image *image,
                             const qtri_affine *affine, uint8_t alpha)
{
    QTRI_ASSERT(affine != NULL);
    run r = {surface, image, {0, 0, 0, 0}, 0, 0, qtri_mix_weight(255, alpha), false,
             false,   0,     NULL};
    qtri_rect bounds = qtri_surface_bounds(surface);
    if (alpha == 0 || bounds.x0 == bounds.x1 || !qtri_picture_is_usable(image) ||
        !invert(affine, &r.inverse)) {
        return;
    }
    r.is_alike = qtri_picture_is_alike(image, surface);
    r.is_swapped = qtri_picture_is_swapped(image, surface);
    clip_range(affine->y0, affine->yx, affine->yy, image, 1, &bounds.y0, &bounds.y1);
    clip_range(affine->x0, affine->xx, affine->xy, image, 8, &bounds.x0, &bounds.x1);
    if (bounds.x0 >= bounds.x1 || bounds.y0 >= bounds.y1) {
        return;
    }
    /* The centre of the first row's first pixel, from where (0, 0) of the picture lies. */
    const int32_t x = bounds.x0 * 65536 + 32768 - affine->x0; /* |.| < 2^30 + 2^29 + 2^15 */
    const int32_t y = bounds.y0 * 65536 + 32768 - affine->y0;
    int64_t u = coordinate(x, r.inverse.ux, y, r.inverse.uy);
    int64_t v = coordinate(x, r.inverse.vx, y, r.inverse.vy);
    axis across;
    axis down;
    axis_init(&across, u, r.inverse.ux, r.inverse.uy, image->width * 65536);
    axis_init(&down, v, r.inverse.vx, r.inverse.vy, image->height * 65536);
    const int32_t count = bounds.x1 - bounds.x0;
    for (int32_t row = bounds.y0; row < bounds.y1; row++) {
        axis_next(&across, count);
        axis_next(&down, count);
        const int32_t first = qtri_greatest32(across.low.column, down.low.column);
        const int32_t end = qtri_least32(across.high.column, down.high.column);
        if (first < end) {
            r.u = (int32_t)(u + (int64_t)r.inverse.ux * first);
            r.v = (int32_t)(v + (int64_t)r.inverse.vx * first);
            paint_run(&r, qtri_surface_at(surface, bounds.x0 + first, row), end - first);
        }
        u += r.inverse.uy; /* exactly: a row is 65536 of y */
        v += r.inverse.vy;
    }
}
