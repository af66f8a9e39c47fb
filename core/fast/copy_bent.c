/* SPDX-License-Identifier: MIT */
#include "../frame/curves.h"
#include "../raster/loop.h"
#include "../raster/texel_copy.h"
#include "fused.h"

/*
 * A pixel: a depth, two coordinates and their two steps advance, of which GCC 12 keeps half in
 * memory on Armv6-M: a third of the time. There pixels are assembler, in the low registers but r7
 * and in four high ones, so that those which a compiler may be told to keep stay out of it.
 * `offset` is where a pixel is, in bytes.
 */
/* clang-format off */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__) &&                           \
    !defined(__OPTIMIZE_SIZE__) && defined(__thumb__) && !defined(__thumb2__)
#define PIXEL(offset, fails)                                                                              \
    "lsrs %[top], %[z], #16\n\t"                                                                   \
    "ldrh %[other], [%[depth], #" offset "]\n\t"                                                   \
    "cmp %[top], %[other]\n\t"                                                                     \
    fails " 1f\n\t"                                                                                   \
    "strh %[top], [%[depth], #" offset "]\n\t"                                                     \
    "movs %[top], %[u]\n\t"                                                                        \
    "lsrs %[top], %[cut]\n\t"                                                                      \
    "movs %[other], %[v]\n\t"                                                                      \
    "ands %[other], %[cut]\n\t"                                                                    \
    "lsrs %[other], %[other], #16\n\t"                                                             \
    "adds %[top], %[top], %[other]\n\t"                                                            \
    "lsls %[top], %[top], #1\n\t"                                                                  \
    "ldr %[other], %[texels]\n\t"                                                                  \
    "ldrh %[top], [%[other], %[top]]\n\t"                                                          \
    "ldr %[other], %[to_pixel]\n\t"                                                                \
    "add %[other], %[depth]\n\t"                                                                   \
    "strh %[top], [%[other], #" offset "]\n"                                                       \
    "1:\tldr %[other], %[z_step]\n\t"                                                              \
    "adds %[z], %[z], %[other]\n\t"                                                               \
    "add %[u], %[u_step]\n\t"                                                                      \
    "add %[v], %[v_step]\n\t"                                                                      \
    "add %[u_step], %[u_bend]\n\t"                                                                 \
    "add %[v_step], %[v_bend]\n\t"
#define DRAW(pixels)                                                                               \
    {                                                                                              \
        uint32_t top, other;                                                                       \
        __asm__ volatile(".syntax unified\n\t" pixels                                              \
                         : [z] "+l"(z), [u] "+l"(u), [v] "+l"(v), [u_step] "+h"(u_step),           \
                           [v_step] "+h"(v_step), [top] "=&l"(top), [other] "=&l"(other)           \
                         : [depth] "l"(depth), [cut] "l"(cut), [to_pixel] "m"(to_pixel),           \
                           [texels] "m"(texels), [z_step] "m"(z_step),                             \
                           [u_bend] "h"(u_bend), [v_bend] "h"(v_bend)                              \
                         : "cc", "memory");                                                        \
    }
#define ONE_PIXEL(fails) PIXEL("0", fails)
#define EIGHT_PIXELS(fails)                                                                        \
    PIXEL("0", fails) PIXEL("2", fails) PIXEL("4", fails) PIXEL("6", fails)                        \
    PIXEL("8", fails) PIXEL("10", fails) PIXEL("12", fails) PIXEL("14", fails)
#define DRAW_PIXELS(PIXELS)                                                                        \
    if (equal) {                                                                                   \
        DRAW(PIXELS("bhi"))                                                                        \
    } else {                                                                                       \
        DRAW(PIXELS("bcs"))                                                                        \
    }
#define DRAW_ONE   DRAW_PIXELS(ONE_PIXEL)
#define DRAW_EIGHT DRAW_PIXELS(EIGHT_PIXELS)
#define MOVE(n) depth += (n);
#define ASSEMBLER 1
#else
#define ASSEMBLER 0
#define MOVE(n) QTRI_MOVE(n)
#define ONE(i)                                                                                     \
    uint32_t top_##i = z >> 16;                                                                    \
    QTRI_OPAQUE(top_##i)                                                                           \
    if (qtri_passes(top_##i, depth[i], equal)) {                                                   \
        QTRI_BRANCH                                                                                \
        depth[i] = (uint16_t)top_##i;                                                              \
        pixel[i] = texels[qtri_texel_index(u, v, cut)];                                            \
    }                                                                                              \
    z += z_step;                                                                                   \
    u += u_step;                                                                                   \
    v += v_step;                                                                                   \
    u_step += u_bend;                                                                              \
    v_step += v_bend;
#define DRAW_ONE   ONE(0)
#define DRAW_EIGHT ONE(0) ONE(1) ONE(2) ONE(3) ONE(4) ONE(5) ONE(6) ONE(7)
#endif
/* clang-format on */

#define TURN                                                                                       \
    QTRI_TURN(u_step, u_bend, uv[0].twist)                                                         \
    QTRI_TURN(v_step, v_bend, uv[1].twist)

QTRI_IN_PLACE void copy(const qtri_job *job, const qtri_run *run, const qtri_curve uv[2],
                        int32_t skip, bool equal)
{
    const uint16_t *texels = job->raster->texture->texels;
    const uint32_t cut = job->raster->texel_cut;
    uint16_t *pixel = (uint16_t *)(void *)run->pixels + run->x;
    uint16_t *depth = run->depths + run->x;
#if ASSEMBLER
    const uintptr_t to_pixel = (uintptr_t)pixel - (uintptr_t)depth;
#endif
    uint32_t z = run->z;
    uint32_t u = uv[0].at;
    uint32_t v = uv[1].at;
    uint32_t u_step = uv[0].step;
    uint32_t v_step = uv[1].step;
    uint32_t u_bend = uv[0].bend;
    uint32_t v_bend = uv[1].bend;
    const uint32_t z_step = job->depth.dx;
    int32_t count = run->count;
    int32_t left_of_eight = 8;
    for (; skip > 0; skip--) { /* rare: what a scissor cuts off */
        u += u_step;
        v += v_step;
        u_step += u_bend;
        v_step += v_bend;
        if (--left_of_eight == 0) {
            left_of_eight = 8;
            TURN
        }
    }
    for (;;) {
#ifndef __OPTIMIZE_SIZE__
        if (count >= 8 && left_of_eight == 8) {
            DRAW_EIGHT
            MOVE(8)
            count -= 8;
        } else
#endif
        {
            for (; count > 0 && left_of_eight > 0; count--, left_of_eight--) {
                DRAW_ONE
                MOVE(1)
            }
            left_of_eight = 8;
        }
        if (count <= 0) {
            return;
        }
        TURN
    }
}

void qtri_copy_bent_less(const qtri_job *job, const qtri_run *run, const qtri_curve uv[2],
                         int32_t skip)
{
    copy(job, run, uv, skip, false);
}

#ifndef __OPTIMIZE_SIZE__
void qtri_copy_bent_lequal(const qtri_job *job, const qtri_run *run, const qtri_curve uv[2],
                           int32_t skip)
{
    copy(job, run, uv, skip, true);
}
#endif
