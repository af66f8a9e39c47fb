/* SPDX-License-Identifier: MIT */
/*
 * What loops over pixels are made of. Internal.
 */
#ifndef QTRI_RASTER_LOOP_H
#define QTRI_RASTER_LOOP_H

#include "qtri/surface.h"

#include "../frame/barrier.h"

/*
 * Repeats ONE(i), which draws pixel[i] and steps, for `count` pixels; `pixel` and `depth` move on.
 * Groups of sixteen and of four have constant offsets.
 */
/* clang-format off */
#ifdef __OPTIMIZE_SIZE__
#define QTRI_PIXELS(count)                                                                         \
    for (const uint16_t *stop = depth + (count); depth != stop;) {                                 \
        ONE(0)                                                                                     \
        QTRI_MOVE(1)                                                                               \
    }
#else
#define QTRI_PIXELS(count)                                                                         \
    if ((count) >= 16) {                                                                           \
        const uint16_t *stop = depth + ((count) & ~15);                                            \
        do {                                                                                       \
            ONE(0) ONE(1) ONE(2) ONE(3) ONE(4) ONE(5) ONE(6) ONE(7)                                \
            ONE(8) ONE(9) ONE(10) ONE(11) ONE(12) ONE(13) ONE(14) ONE(15)                          \
            QTRI_MOVE(16)                                                                          \
        } while (depth != stop);                                                                   \
        (count) &= 15;                                                                             \
    }                                                                                              \
    for (; (count) >= 4; (count) -= 4) {                                                           \
        ONE(0) ONE(1) ONE(2) ONE(3)                                                                \
        QTRI_MOVE(4)                                                                               \
    }                                                                                              \
    for (; (count) > 0; (count)--) {                                                               \
        ONE(0)                                                                                     \
        QTRI_MOVE(1)                                                                               \
    }
#endif
/* clang-format on */
#define QTRI_MOVE(n)                                                                               \
    depth += (n);                                                                                  \
    pixel += (n);                                                                                  \
    QTRI_OPAQUE(depth)                                                                             \
    QTRI_OPAQUE(pixel)

/* Where the rows of a trapezoid are in memory, with depth. */
typedef struct qtri_lines {
    uint8_t *pixels;
    uint16_t *depths;
} qtri_lines;

static inline uint8_t *qtri_pixels_at(const qtri_surface *surface, int32_t row)
{
    return surface->pixels + (ptrdiff_t)(row - surface->first_row) * surface->pitch;
}

/* There is depth. */
static inline uint16_t *qtri_depths_at(const qtri_surface *surface, int32_t row)
{
    return surface->depth + (ptrdiff_t)(row - surface->first_row) * surface->depth_pitch;
}

static inline qtri_lines qtri_lines_at(const qtri_surface *surface, int32_t row)
{
    qtri_lines lines = {qtri_pixels_at(surface, row), qtri_depths_at(surface, row)};
    return lines;
}

/*
 * What was stored before is read again after. GCC 12 would gather what the job holds before the
 * first row, though most have few rows, or keep a second copy of it on the stack for want of
 * registers.
 */
#if defined(__GNUC__)
#define QTRI_READ_AGAIN __asm__ volatile("" ::: "memory");
#else
#define QTRI_READ_AGAIN
#endif

#endif
