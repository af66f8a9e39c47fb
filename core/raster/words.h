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
