/* SPDX-License-Identifier: MIT */
/*
 * Loops over words of a batch. Internal.
 *
 * QTRI_WORDS(count) repeats ONE(i), on word i from where pointers are, and MOVE(n), which moves
 * them on, for `count` >= 1 words: rounded up to a multiple of four, so that offsets are constant.
 * QTRI_WORDS_TURNED(count) has TURN between words eight apart.
 */
#ifndef QTRI_RASTER_WORDS_H
#define QTRI_RASTER_WORDS_H

/*
 * mask = 2 mask + (a >= b). A comparison leaves that in the carry, and adding with it is one
 * instruction.
 */
#if defined(__GNUC__) && defined(__thumb__) && !defined(__thumb2__)
#define QTRI_PUSH_GREATER_EQUAL(mask, a, b)                                                        \
    __asm__(".syntax unified\n\tcmp %1, %2\n\tadcs %0, %0" : "+l"(mask) : "l"(a), "l"(b) : "cc");
#elif defined(__GNUC__) && defined(__thumb2__)
#define QTRI_PUSH_GREATER_EQUAL(mask, a, b)                                                        \
    __asm__("cmp %1, %2\n\tadcs %0, %0, %0" : "+r"(mask) : "r"(a), "r"(b) : "cc");
#else
#define QTRI_PUSH_GREATER_EQUAL(mask, a, b) (mask) = 2 * (mask) + ((a) >= (b));
#endif

/* How many words past `count` are worked on. */
#ifdef __OPTIMIZE_SIZE__
#define QTRI_WORDS_PAST(count) 0
#else
#define QTRI_WORDS_PAST(count) (-(count)&3)
#endif

#ifdef __OPTIMIZE_SIZE__
#define QTRI_WORDS(count)                                                                          \
    do {                                                                                           \
        ONE(0)                                                                                     \
        MOVE(1)                                                                                    \
    } while (--(count) > 0);
#define QTRI_WORDS_TURNED(count)                                                                   \
    for (int32_t left_of_eight = 8;;) {                                                            \
        ONE(0)                                                                                     \
        MOVE(1)                                                                                    \
        if (--(count) <= 0) {                                                                      \
            break;                                                                                 \
        }                                                                                          \
        if (--left_of_eight == 0) {                                                                \
            left_of_eight = 8;                                                                     \
            TURN                                                                                   \
        }                                                                                          \
    }
#else
#define QTRI_WORDS(count)                                                                          \
    do {                                                                                           \
        ONE(0)                                                                                     \
        ONE(1)                                                                                     \
        ONE(2)                                                                                     \
        ONE(3)                                                                                     \
        MOVE(4)                                                                                    \
    } while (((count) -= 4) > 0);
#define QTRI_WORDS_TURNED(count)                                                                   \
    for (;;) {                                                                                     \
        ONE(0)                                                                                     \
        ONE(1)                                                                                     \
        ONE(2)                                                                                     \
        ONE(3)                                                                                     \
        MOVE(4)                                                                                    \
        if (((count) -= 4) <= 0) {                                                                 \
            break;                                                                                 \
        }                                                                                          \
        ONE(0)                                                                                     \
        ONE(1)                                                                                     \
        ONE(2)                                                                                     \
        ONE(3)                                                                                     \
        MOVE(4)                                                                                    \
        if (((count) -= 4) <= 0) {                                                                 \
            break;                                                                                 \
        }                                                                                          \
        TURN                                                                                       \
    }
#endif

#endif
