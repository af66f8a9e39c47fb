/* SPDX-License-Identifier: MIT */
#include "bench_scenes.h"

enum { LINE_POINTS = 64, POINTS = 256, CHART_POINTS = 160 };

/* Numbers that repeat on every machine: 0..65535. */
static int32_t next(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (int32_t)(*state >> 16);
}

/* A chart of 300 by some 200 pixels, in parts of 2 by up to 20 pixels: two waves, and noise. */
static uint32_t set_chart(qtri_corner *corners)
{
    uint32_t state = 1;
    for (int32_t i = 0; i < CHART_POINTS; i++) {
        const int32_t y = q16_sin(Q16(.21) * i) * 3 / 4 + q16_sin(Q16(.65) * i) / 4;
        const qtri_corner corner = {
            {i * 1545 - 122880, y + next(&state) / 4 - 8192, 0, Q16_ONE}, {255, 200, 60}, {0, 0}};
        corners[i] = corner;
    }
    return CHART_POINTS;
}

/* A zigzag across the screen, in 63 parts of 5 by up to 40 pixels; or points all over it. */
uint32_t bench_set_strokes(qtri_corner *corners, const bench_scene *scene)
{
    uint32_t state = 1;
    if (scene->chart) {
        return set_chart(corners);
    }
    const uint32_t count = scene->points ? POINTS : LINE_POINTS;
    for (uint32_t i = 0; i < count; i++) {
        const int32_t x = scene->points ? next(&state) * 4 : (int32_t)i * 4096;
        const int32_t y = scene->points ? next(&state) * 3 - 98304 : next(&state) / 2 - 16384;
        const qtri_corner corner = {
            {x - 131072, y, 0, Q16_ONE},
            {(uint8_t)(255 - (i * 4 & 127)), (uint8_t)(128 + (i & 127)), (uint8_t)(60 + (i & 63))},
            {0, 0}};
        corners[i] = corner;
    }
    return count;
}

void bench_draw_strokes(bench_frame *frame)
{
    const bench_scene *scene = frame->scene;
    qtri_stroke stroke = qtri_stroke_default();
    stroke.width = scene->width;
    if (scene->hidden) {
        qtri_draw_hidden_lines(&frame->surface, &frame->view, &frame->pose, &frame->mesh, NULL,
                               &frame->material, Q16(.002));
    } else if (scene->work == BENCH_MESH) {
        qtri_draw_wide_wireframe(&frame->surface, &frame->view, &frame->pose, &frame->mesh, &stroke,
                                 &frame->material);
    } else if (scene->points) {
        qtri_draw_points(&frame->surface, &frame->view, &frame->pose, frame->corners, POINTS,
                         &stroke, &frame->material);
    } else {
        qtri_draw_polyline(&frame->surface, &frame->view, &frame->pose, frame->corners,
                           scene->chart ? CHART_POINTS : LINE_POINTS, &stroke, &frame->material);
    }
}
