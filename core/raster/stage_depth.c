/* SPDX-License-Identifier: MIT */
#include "stage_depth.h"

#include "loop.h"
#include "words.h"

/* Repeats ONE(i) for `count` pixels, which move on. */
#ifdef __OPTIMIZE_SIZE__
#define DEPTHS(count)                                                                              \
    do {                                                                                           \
        ONE(0)                                                                                     \
        depth++;                                                                                   \
        QTRI_OPAQUE(depth)                                                                         \
    } while (--(count) > 0);
#else
#define DEPTHS(count)                                                                              \
    for (; (count) >= 4; (count) -= 4) {                                                           \
        ONE(0)                                                                                     \
        ONE(1)                                                                                     \
        ONE(2)                                                                                     \
        ONE(3)                                                                                     \
        depth += 4;                                                                                \
        QTRI_OPAQUE(depth)                                                                         \
    }                                                                                              \
    for (; (count) > 0; (count)--) {                                                               \
        ONE(0)                                                                                     \
        depth++;                                                                                   \
        QTRI_OPAQUE(depth)                                                                         \
    }
#endif

/* Fragments that are not below what is stored: LESS inverted, GREATER_EQUAL. */
static uint32_t not_less(uint16_t *depth, uint32_t z, uint32_t step, int32_t count)
{
    uint32_t mask = 0;
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t top = z >> 16;                                                              \
        const uint32_t stored = depth[i];                                                          \
        QTRI_PUSH_GREATER_EQUAL(mask, top, stored)                                                 \
        z += step;                                                                                 \
        QTRI_OPAQUE(z)                                                                             \
    }
    DEPTHS(count)
#undef ONE
    return mask;
}

/* Those that are not above it: LESS_EQUAL, GREATER inverted. */
static uint32_t not_greater(uint16_t *depth, uint32_t z, uint32_t step, int32_t count)
{
    uint32_t mask = 0;
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t top = z >> 16;                                                              \
        const uint32_t stored = depth[i];                                                          \
        QTRI_PUSH_GREATER_EQUAL(mask, stored, top)                                                 \
        z += step;                                                                                 \
        QTRI_OPAQUE(z)                                                                             \
    }
    DEPTHS(count)
#undef ONE
    return mask;
}

static uint32_t equal(uint16_t *depth, uint32_t z, uint32_t step, int32_t count)
{
    uint32_t mask = 0;
    uint32_t zero = 0;
    QTRI_OPAQUE(zero)
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t differ = (z >> 16) ^ depth[i];                                              \
        QTRI_PUSH_GREATER_EQUAL(mask, zero, differ)                                                \
        z += step;                                                                                 \
        QTRI_OPAQUE(z)                                                                             \
    }
    DEPTHS(count)
#undef ONE
    return mask;
}

/* The two that most draw calls use also write, in the branch that they take anyway. */
static uint32_t less_write(uint16_t *depth, uint32_t z, uint32_t step, int32_t count)
{
    const uint32_t all = UINT32_MAX >> (32 - count);
    uint32_t mask = 0;
#if defined(__GNUC__) && defined(__thumb__) && !defined(__thumb2__)
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t top = z >> 16;                                                              \
        const uint32_t stored = depth[i];                                                          \
        __asm__ volatile(".syntax unified\n\tcmp %1, %2\n\tbcs 1f\n\tstrh %1, [%3, %4]\n"          \
                         "1:\tadcs %0, %0"                                                         \
                         : "+l"(mask)                                                              \
                         : "l"(top), "l"(stored), "l"(depth), "i"(2 * (i))                         \
                         : "cc", "memory");                                                        \
        z += step;                                                                                 \
        QTRI_OPAQUE(z)                                                                             \
    }
#elif defined(__GNUC__) && defined(__thumb2__)
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t top = z >> 16;                                                              \
        const uint32_t stored = depth[i];                                                          \
        __asm__ volatile("cmp %1, %2\n\tit lo\n\tstrhlo %1, [%3, %4]\n\tadcs %0, %0, %0"           \
                         : "+r"(mask)                                                              \
                         : "r"(top), "r"(stored), "r"(depth), "i"(2 * (i))                         \
                         : "cc", "memory");                                                        \
        z += step;                                                                                 \
        QTRI_OPAQUE(z)                                                                             \
    }
#else
#define ONE(i)                                                                                     \
    {                                                                                              \
        const bool fails = z >> 16 >= depth[i];                                                    \
        depth[i] = fails ? depth[i] : (uint16_t)(z >> 16);                                         \
        mask = 2 * mask + fails;                                                                   \
        z += step;                                                                                 \
    }
#endif
    DEPTHS(count)
#undef ONE
    return ~mask & all;
}

static uint32_t less_equal_write(uint16_t *depth, uint32_t z, uint32_t step, int32_t count)
{
    uint32_t mask = 0;
#if defined(__GNUC__) && defined(__thumb__) && !defined(__thumb2__)
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t top = z >> 16;                                                              \
        const uint32_t stored = depth[i];                                                          \
        __asm__ volatile(".syntax unified\n\tcmp %2, %1\n\tbcc 1f\n\tstrh %1, [%3, %4]\n"          \
                         "1:\tadcs %0, %0"                                                         \
                         : "+l"(mask)                                                              \
                         : "l"(top), "l"(stored), "l"(depth), "i"(2 * (i))                         \
                         : "cc", "memory");                                                        \
        z += step;                                                                                 \
        QTRI_OPAQUE(z)                                                                             \
    }
#elif defined(__GNUC__) && defined(__thumb2__)
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t top = z >> 16;                                                              \
        const uint32_t stored = depth[i];                                                          \
        __asm__ volatile("cmp %2, %1\n\tit hs\n\tstrhhs %1, [%3, %4]\n\tadcs %0, %0, %0"           \
                         : "+r"(mask)                                                              \
                         : "r"(top), "r"(stored), "r"(depth), "i"(2 * (i))                         \
                         : "cc", "memory");                                                        \
        z += step;                                                                                 \
        QTRI_OPAQUE(z)                                                                             \
    }
#else
#define ONE(i)                                                                                     \
    {                                                                                              \
        const bool passes = depth[i] >= z >> 16;                                                   \
        depth[i] = passes ? (uint16_t)(z >> 16) : depth[i];                                        \
        mask = 2 * mask + passes;                                                                  \
        z += step;                                                                                 \
    }
#endif
    DEPTHS(count)
#undef ONE
    return mask;
}

void qtri_depth_write(uint16_t *depth, uint32_t z, uint32_t step, uint32_t mask, int32_t count)
{
    if (mask == UINT32_MAX >> (32 - count)) {
#define ONE(i)                                                                                     \
    depth[i] = (uint16_t)(z >> 16);                                                                \
    z += step;                                                                                     \
    QTRI_OPAQUE(z)
        DEPTHS(count)
#undef ONE
        return;
    }
    for (mask <<= 32 - count; mask != 0; mask <<= 1) {
        if ((int32_t)mask < 0) {
            *depth = (uint16_t)(z >> 16);
        }
        depth++;
        z += step;
    }
}

qtri_depth qtri_depth_stages(qtri_compare compare, bool write, bool late)
{
    qtri_depth stages = {NULL, false, write};
    switch (compare) {
    case QTRI_LESS:
        stages.test = not_less;
        stages.inverted = true;
        break;
    case QTRI_GREATER_EQUAL:
        stages.test = not_less;
        break;
    case QTRI_LESS_EQUAL:
        stages.test = not_greater;
        break;
    case QTRI_GREATER:
        stages.test = not_greater;
        stages.inverted = true;
        break;
    case QTRI_EQUAL:
        stages.test = equal;
        break;
    case QTRI_NOT_EQUAL:
        stages.test = equal;
        stages.inverted = true;
        break;
    default:
        break;
    }
    if (write && !late && (compare == QTRI_LESS || compare == QTRI_LESS_EQUAL)) {
        stages.test = compare == QTRI_LESS ? less_write : less_equal_write;
        stages.inverted = false;
        stages.write = false;
    }
    return stages;
}
