/*
 * Functions that fill rows. Internal.
 *
 * Each loop beside the generic one, qtri_run_generic, is there for rows of the benchmark:
 *
 *     fill.inc        one colour, any format, with and without depth           S1
 *     fill_packed.c   linear colours in RGB565; the same for tiny triangles    S2; S4 S4k
 *     fill_texture.c  copied texels in RGB565                                  S3 S3a
 *     fill_pairs.c    these three two pixels at a time, on Thumb-2             S1 S2 S3 S3a
 *     tiny.h          tiny triangles of a mesh, set up and filled in one go    S4 S5
 *
 * All of them test depth with "less" and write it, or, in fill.inc, know none.
 */
#ifndef QTRI_RASTER_FILL_H
#define QTRI_RASTER_FILL_H

#include "job.h"

/*
 * GCC 12 computes several pixels' values ahead and mixes their work, and then runs out of
 * registers. An empty statement that may change a value, for all the compiler knows, keeps each
 * pixel's work together, and a branch a branch: a third of the loop on a Cortex-M3.
 */
#if defined(__GNUC__) && defined(__thumb__) && !defined(__thumb2__)
#define QTRI_OPAQUE(x) __asm__ volatile("" : "+l"(x));
#define QTRI_ASIDE(x)  __asm__ volatile("" : "+h"(x));
#define QTRI_BRANCH    __asm__ volatile("");
#elif defined(__GNUC__)
#define QTRI_OPAQUE(x) __asm__ volatile("" : "+r"(x));
#define QTRI_ASIDE(x)
#define QTRI_BRANCH __asm__ volatile("");
#else
#define QTRI_OPAQUE(x)
#define QTRI_ASIDE(x)
#define QTRI_BRANCH
#endif

/*
 * Repeats ONE(i), which draws pixel[i] and steps, for `count` pixels; `pixel` and `depth` move on.
 * Groups of sixteen and of four have constant offsets.
 */
/* clang-format off */
#ifdef __OPTIMIZE_SIZE__
#define QTRI_PIXELS(count)                                                                         \
    do {                                                                                           \
        ONE(0)                                                                                     \
        QTRI_MOVE(1)                                                                               \
    } while (--(count) > 0);
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

/* RGB565, linear colours, depth "less" with write. */
void qtri_fill_packed_less(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count);

/* The same for tiny triangles. */
void qtri_fill_tiny_less(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count);

/* The same for jobs that copy texels. */
void qtri_run_copy_less(const qtri_job *job, const qtri_run *run);

#endif
