/* SPDX-License-Identifier: MIT */
/*
 * Three kinds of failure, kept apart:
 *   - what the environment or the caller's memory makes impossible: a negative enum qtri_error;
 *   - degenerate geometry (zero area, w = 0, a zero axis): a documented, ordinary result;
 *   - a caller's bug (a null pointer where none is allowed): nothing is tested, unless QTRI_CHECKED
 *     is defined when core/ and the application are compiled.
 *
 * A build with -DQTRI_CHECKED, of core/ and of port/, stops at the call that is likely a mistake,
 * with file, line and the condition that does not hold:
 *   - null pointers, to every function that says nothing of NULL, and in what it is given: arrays
 *     with a count above 0, descriptions and buses without a function that they must have, a lack
 *     of one of data_start and data_finish, lights with sources that qtri_light_init did not set;
 *   - views without a pipeline that fits what is drawn;
 *   - indices past the end of a mesh, numbers that no enum of a material, a texture or a panel
 *     names, counts of corners that are no multiple of 3 (lines: of 2), polygons of more than 3
 *     corners to clip, keys whose times fall, more than 32767 frames, balls and boxes below 0;
 *   - transforms never initialised, surfaces, viewports and textures with sides out of range, 0
 *     too; a qtri_prepared whose fields have what none is given, as memory that was never
 *     initialised has: one of zeros is as one without memory;
 *   - a plain number where a Q16.16 belongs: a field of view of 60 in place of Q16(60), angles of
 *     spot lights, near and far, depths, sizes of shapes, distances of cameras, sides of a frustum,
 *     1 for a light; factors of a scale that are all within 15/65536 of 0, but not all 0, also of
 *     keys, though not of a pose between two keys; a stroke's width above 0 and below 1/128 pixel,
 *     in object space below 16/65536;
 *   - plain pixels where QTRI_PX belongs: what is painted is thinner than a pixel and lies in the
 *     first width/256 x height/256 pixels of the frame; widths above 0 and below 1/16 pixel. What
 *     is that small and meant has all its coordinates on whole or half pixels, reaches beyond the
 *     frame's upper or left side, or is of another place.
 * Where small numbers are ordinary, as angles of turns, offsets and times, or are held to a range,
 * as a shininess, it cannot tell; nor radii without QTRI_PX around a centre with it.
 * A number, or a pointer, that a function documents a result for is none. Contents of arrays are
 * not looked at, but for a mesh's indices, keys, targets and sources of light. The rest has a
 * documented result or faults elsewhere; the checked build is for finding it. q16.h has
 * QTRI_CHECK_MATH for the results of the mathematics.
 *
 * What stops is <assert.h>'s assert; without a C library (-ffreestanding), or with NDEBUG, a trap
 * with the three in reach of a debugger. -DQTRI_FAULT=name calls a function of the application in
 * place of either: void name(const char *condition, const char *file, int line). If that returns,
 * so does the check, and the call has its documented result.
 *
 * -DQTRI_MISSING=name: where a view's pipelines have none that fits, void name(const qtri_options
 * *wanted) of the application is called before, with what a QTRI_PIPELINE (pipeline.h) must name.
 */
#ifndef QTRI_ERROR_H
#define QTRI_ERROR_H

#include <stddef.h> /* NULL, for conditions */

/* What functions return that can fail: QTRI_OK or a negative number. */
enum qtri_error {
    QTRI_OK = 0,
    /* A width, height, row or count is outside its range; a number in text beyond Q16.16's. */
    QTRI_ERROR_SIZE = -1,
    /* The memory passed in is NULL or smaller than its size macro says; a buffer too small for a
       text. */
    QTRI_ERROR_MEMORY = -2,
    /* A display could not be reached: a bus function failed, or it stayed busy for too long. */
    QTRI_ERROR_BUS = -3,
    /* No format of pixels: NULL. */
    QTRI_ERROR_FORMAT = -4
};

/* May be defined from outside, as anything that takes a condition. */
#ifndef QTRI_ASSERT
#if !defined(QTRI_CHECKED)
#define QTRI_ASSERT(condition) ((void)0)
#elif defined(QTRI_FAULT)
#ifdef __cplusplus
extern "C"
#endif
    void
    QTRI_FAULT(const char *condition, const char *file, int line);
#define QTRI_ASSERT(condition) ((condition) ? (void)0 : QTRI_FAULT(#condition, __FILE__, __LINE__))
#elif __STDC_HOSTED__ && !defined(NDEBUG)
#include <assert.h>
#define QTRI_ASSERT(condition) assert(condition)
#else
static inline void qtri_fault(const char *condition, const char *file, int line)
{
    const char *volatile failed = condition;
    const char *volatile in_file = file;
    volatile int at_line = line;
    (void)failed;
    (void)in_file;
    (void)at_line;
#ifdef __GNUC__
    __builtin_trap();
#else
    for (;;) {
    }
#endif
}
#define QTRI_ASSERT(condition) ((condition) ? (void)0 : qtri_fault(#condition, __FILE__, __LINE__))
#endif
#endif

#endif
