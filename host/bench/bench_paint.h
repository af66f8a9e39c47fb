/* SPDX-License-Identifier: MIT */
/*
 * Benchmark scenes of flat shapes, pictures and text, on the frame of bench_scenes.h:
 *
 *   P1   a filled rectangle of 300 x 200 pixels at an odd column
 *   P2   800 rectangles of 11 x 7, from all columns
 *   P3   that of P1, mixed with what is there
 *   P4   a picture of 128 x 128, copied four times, columns even and odd
 *   P5   the same with a key that every eighth pixel has
 *   P6   one turned by 30 degrees and 1.5 times as large
 *   P7   a circle of radius 100
 *   P8   the same with smooth edges
 *   P9   a polygon of 12 corners, smooth
 *   P10  text of characters of 8 x 16 pixels
 */
#ifndef BENCH_PAINT_H
#define BENCH_PAINT_H

#include "bench_scenes.h"

enum { BENCH_PAINT_CHARACTERS = 320 };

typedef void bench_paint(bench_frame *frame);

bench_paint bench_paint_rect, bench_paint_rects, bench_paint_alpha, bench_paint_copy,
    bench_paint_keyed, bench_paint_turned, bench_paint_circle, bench_paint_smooth,
    bench_paint_polygon, bench_paint_text;

#endif
