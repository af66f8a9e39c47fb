/* SPDX-License-Identifier: MIT */
/*
 * Three kinds of failure, kept apart:
 *   - what the environment or the caller's memory makes impossible: a negative enum qtri_error;
 *   - degenerate geometry (zero area, w = 0, a zero axis): a documented, ordinary result;
 *   - a caller's bug (a null pointer where none is allowed): QTRI_ASSERT, nothing unless defined.
 */
#ifndef QTRI_ERROR_H
#define QTRI_ERROR_H

enum qtri_error {
    QTRI_OK = 0,
    /* A width, height, row or count is outside its range; a number in text beyond Q16.16's. */
    QTRI_ERROR_SIZE = -1,
    /* The memory passed in is smaller than its size macro says; a buffer too small for a text. */
    QTRI_ERROR_MEMORY = -2,
    /* A display could not be reached: a bus function failed, or it stayed busy for too long. */
    QTRI_ERROR_BUS = -3,
    /* No format of pixels: NULL. */
    QTRI_ERROR_FORMAT = -4
};

#ifndef QTRI_ASSERT
#define QTRI_ASSERT(condition) ((void)0)
#endif

#endif
