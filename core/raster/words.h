/*
 * Loops over words of a batch. Internal.
 *
 * QTRI_WORDS(count) repeats ONE(i), on word i from where pointers are, and MOVE(n), which moves
 * them on, for `count` >= 1 words: rounded up to a multiple of four, so that offsets are constant.
 */
#ifndef QTRI_RASTER_WORDS_H
#define QTRI_RASTER_WORDS_H

#ifdef __OPTIMIZE_SIZE__
#define QTRI_WORDS(count)                                                                          \
    do {                                                                                           \
        ONE(0)                                                                                     \
        MOVE(1)                                                                                    \
    } while (--(count) > 0);
#else
#define QTRI_WORDS(count)                                                                          \
    do {                                                                                           \
        ONE(0)                                                                                     \
        ONE(1)                                                                                     \
        ONE(2)                                                                                     \
        ONE(3)                                                                                     \
        MOVE(4)                                                                                    \
    } while (((count) -= 4) > 0);
#endif

#endif
