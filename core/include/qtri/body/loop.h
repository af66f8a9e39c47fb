/* SPDX-License-Identifier: MIT */
/*
 * Loops over the pixels of a row. Internal, part of the pipelines' body (pipeline_make.h).
 */
#ifndef QTRI_BODY_LOOP_H
#define QTRI_BODY_LOOP_H

#include "quads.h"

/*
 * qtri_pixel_at with a pipeline's options, which QTRI_PIPELINE makes once: the compiler inlines
 * calls and looks at them before it leaves out what options do not ask for, and a pixel of all
 * options in each of the loops below was six sevenths of its time.
 */
typedef void qtri_pixel_body(qtri_pixel_walk *w, bool bent, uint8_t *pixel, uint8_t *depth);

/* Draws pixel i after the one that the walk points to, and steps its values, not its pointers. */
QTRI_BODY void qtri_pixel(const qtri_options *o, qtri_pixel_body *pixel, qtri_pixel_walk *w,
                          bool bent, int32_t i)
{
    uint8_t *depth = w->depth;
    if (qtri_tests_depth(o)) { /* or there may be none */
        depth += (uint32_t)i * qtri_depth_size(o, w->state->surface);
    }
    pixel(w, bent, w->pixel + (uint32_t)i * qtri_pixel_step(o), depth);
}

/* Moves the pointers of the walk. */
QTRI_BODY void qtri_walk_move(const qtri_options *o, qtri_pixel_walk *w, uint32_t pixels)
{
    w->pixel += pixels * qtri_pixel_step(o);
    QTRI_BODY_BARRIER(w->pixel);
    if (qtri_tests_depth(o)) {
        w->depth += pixels * qtri_depth_size(o, w->state->surface);
        QTRI_BODY_BARRIER(w->depth);
    }
}

/* Packed colours of 565 have two steps along long rows, for even and odd pixels: both rounded to
   short fractions, their sum only once. */
QTRI_BODY void qtri_walk_swap_steps(const qtri_options *o, qtri_pixel_walk *w)
{
    if (qtri_is_packed_565(o)) {
        const uint32_t step = w->c_step;
        w->c_step = w->c_other;
        w->c_other = step;
    }
}

/* As qtri_pixel(), in a long row. */
QTRI_BODY void qtri_pixel_next(const qtri_options *o, qtri_pixel_body *pixel, qtri_pixel_walk *w,
                               bool bent, int32_t i)
{
    qtri_pixel(o, pixel, w, bent, i);
    qtri_walk_swap_steps(o, w);
}

/* Draws the walk's pixel, with the samples that the row covers, and moves to the next. */
QTRI_BODY void qtri_pixel_and_move(const qtri_options *o, qtri_pixel_body *pixel,
                                   qtri_pixel_walk *w, bool bent)
{
    if (qtri_has_samples(o)) {
        w->samples = qtri_samples_of(w->sample_row, w->x);
    }
    qtri_pixel_next(o, pixel, w, bent, 0);
    qtri_walk_move(o, w, 1);
}

/* Draws pixels of a row, by qtri_quads_draw() where pixels and depths are equally aligned. */
QTRI_BODY void qtri_pixels_by_fours(const qtri_options *o, qtri_pixel_body *pixel,
                                    qtri_pixel_walk *w, int32_t count)
{
    const int32_t together = QTRI_BODY_UNROLLS > 2 ? 8 : 2; /* even: words stay where they begin */
    if (count > 0 && ((uintptr_t)w->pixel & 2) != 0) {
        qtri_pixel_and_move(o, pixel, w, false);
        count--;
    }
    const bool aligned = !qtri_tests_depth(o) || ((uintptr_t)w->depth & 2) == 0;
    for (;;) {
        if (aligned) {
            count = qtri_quads_draw(o, w, count);
        }
        if (count < together) {
            break;
        }
        QTRI_BODY_UNROLL
        for (int32_t i = 0; i < together; i++) {
            qtri_pixel_next(o, pixel, w, false, i);
        }
        qtri_walk_move(o, w, (uint32_t)together);
        count -= together;
    }
    for (; count > 0; count--) {
        qtri_pixel_and_move(o, pixel, w, false);
    }
}

/* Whether long rows step one pointer for both pixel and depth: a lit and textured face of 140
   pixels takes 6 % less, one of colours in fog 5. On Armv7-M untextured blends have registers for
   two and a count. */
QTRI_BODY bool qtri_pixels_are_paired(const qtri_options *o)
{
    return qtri_is_paired(o) && !qtri_has_samples(o) &&
           (qtri_is_textured(o) || o->fog || !QTRI_LONG_MULTIPLY);
}

/* Draws `count` pixels by the pointer to depth, which also tells the end. */
QTRI_BODY void qtri_pixels_paired(const qtri_options *o, qtri_pixel_body *pixel, qtri_pixel_walk *w,
                                  bool bent, int32_t count)
{
    const uint32_t bytes = qtri_pixel_bytes(o);
    const uintptr_t apart = (uintptr_t)w->pixel - (uintptr_t)w->depth;
    const uint8_t *const end = w->depth + (uint32_t)count * bytes;
    if (count <= 0) {
        return;
    }
    w->pixel += (uint32_t)count * bytes;
    do {
        // NOLINTNEXTLINE(performance-no-int-to-ptr)
        pixel(w, bent, (uint8_t *)((uintptr_t)w->depth + apart), w->depth);
        qtri_walk_swap_steps(o, w);
        w->depth += bytes;
        QTRI_BODY_BARRIER(w->depth);
    } while (w->depth != end);
}

/* Draws `count` pixels one after the other; 0 or less: none. */
#ifdef QTRI_PIPELINE_IS_ANY_LOOP
/* The generic pipeline has loops of its own. */
QTRI_BODY void qtri_pixels_singly(const qtri_options *o, qtri_pixel_body *pixel, qtri_pixel_walk *w,
                                  bool bent, int32_t count)
{
    (void)o;
    (void)pixel;
    if (count > 0) {
        w->state->loop(w, bent, count);
    }
}
#elif QTRI_BODY_UNROLLS <= 2
/* Where code is to be small: two pixels at a time, after one where the count is odd. */
QTRI_BODY void qtri_pixels_singly(const qtri_options *o, qtri_pixel_body *pixel, qtri_pixel_walk *w,
                                  bool bent, int32_t count)
{
    const bool in_pairs = qtri_unrolled(o, bent) == 2;
    if (count > 0 && (!in_pairs || (count & 1) != 0)) {
        do { /* GCC does not turn loops round by itself */
            qtri_pixel_and_move(o, pixel, w, bent);
        } while (!in_pairs && --count != 0);
    }
    if (in_pairs && count > 1) {
        count >>= 1;
        do {
            qtri_pixel_next(o, pixel, w, bent, 0);
            qtri_pixel_next(o, pixel, w, bent, 1);
            qtri_walk_move(o, w, 2);
            QTRI_BODY_BARRIER(count);
        } while (--count != 0);
    }
}
#else
QTRI_BODY void qtri_pixels_singly(const qtri_options *o, qtri_pixel_body *pixel, qtri_pixel_walk *w,
                                  bool bent, int32_t count)
{
    const int together = qtri_unrolled(o, bent);
    if (together > 1) {
        /* Where the sign tells the end, one instruction counts and compares; on Armv6-M GCC 12 then
           moves what copies of textures step from register to register. */
        const int32_t early = qtri_is_textured(o) && !QTRI_LONG_MULTIPLY ? 0 : together;
        count -= early;
        while (count >= together - early) {
            QTRI_BODY_UNROLL
            for (int32_t i = 0; i < together; i++) {
                qtri_pixel_next(o, pixel, w, bent, i);
            }
            qtri_walk_move(o, w, (uint32_t)together);
            if (qtri_varies(o)) {
                QTRI_BODY_BARRIER(count);
            }
            count -= together;
        }
        count += early;
    }
    if (together == 1 && qtri_pixels_are_paired(o)) {
        qtri_pixels_paired(o, pixel, w, bent, count);
        return;
    }
    for (; count > 0; count--) {
        qtri_pixel_and_move(o, pixel, w, bent);
    }
}
#endif

/* Draws `count` pixels of a long row, 0 or less: none. */
QTRI_BODY void qtri_pixels_draw(const qtri_options *o, qtri_pixel_body *pixel, qtri_pixel_walk *w,
                                bool bent, int32_t count)
{
    if (qtri_draws_quads(o)) {
        qtri_pixels_by_fours(o, pixel, w, count);
    } else {
        qtri_pixels_singly(o, pixel, w, bent, count);
    }
}

#endif
