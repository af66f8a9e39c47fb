/* SPDX-License-Identifier: MIT */
/*
 * A gauge with a needle, on a colour display of up to 320x240 pixels, round ones too. After the
 * first frame only the rectangle is drawn and sent that the needle leaves and enters
 * (qtri/frame.h).
 */
#include <qtri.h>
#include <qtri/pipeline_make.h>

#include "qtri_port/screen.h"

#include "../example.h"

enum { WIDTH = 320, HEIGHT = 320, ROWS = 16, TICKS = 41, ARC = 40 };

const char example_name[] = "gauge";

static uint8_t band_memory[QTRI_FRAME_BYTES(WIDTH, ROWS, QTRI_RGB565_BYTES)];
static qtri_corner ticks[6 * TICKS];
static qtri_corner arc[6 * ARC];

static const qtri_rgb face = {18, 20, 26}, white = {235, 235, 235}, red = {225, 50, 40},
                      green = {60, 170, 90};

/* From 225 degrees, counted from the right, over the top to -45: 0..1 of the scale. */
static q16 angle_of(q16 part)
{
    return Q16(225) - q16_mul(Q16(270), part);
}

static qtri_corner corner(q16 radius, q16 degrees, qtri_rgb color)
{
    qtri_corner c = {
        {q16_mul(radius, q16_cos_deg(degrees)), q16_mul(radius, q16_sin_deg(degrees)), 0, Q16(1)},
        color,
        {0, 0}};
    return c;
}

/* A piece of a ring, two triangles. */
static void put_piece(qtri_corner out[6], q16 inner, q16 outer, q16 from, q16 to, qtri_rgb color)
{
    out[0] = out[3] = corner(inner, from, color);
    out[1] = corner(outer, from, color);
    out[2] = out[4] = corner(outer, to, color);
    out[5] = corner(inner, to, color);
}

static void make_dial(void)
{
    for (int32_t i = 0; i < ARC; i++) {
        qtri_rgb color = i >= ARC * 3 / 4 ? red : green;
        put_piece(&arc[6 * i], Q16(.84), Q16(.9), angle_of(q16_from_ratio(i, ARC)),
                  angle_of(q16_from_ratio(i + 1, ARC)), color);
    }
    for (int32_t i = 0; i < TICKS; i++) {
        bool is_long = i % 5 == 0;
        q16 at = angle_of(q16_from_ratio(i, TICKS - 1));
        q16 half = is_long ? Q16(.9) : Q16(.45);
        put_piece(&ticks[6 * i], is_long ? Q16(.68) : Q16(.75), Q16(.81), at + half, at - half,
                  white);
    }
}

/* A long triangle with a tail, and the hub's six. */
static void draw_needle(const qtri_surface *band, const qtri_view *view, q16 degrees,
                        const qtri_material *material)
{
    qtri_corner c[6 + 18];
    qtri_transform pose;
    qtri_transform_identity(&pose);
    c[0] = c[3] = corner(Q16(.78), degrees, red);
    c[1] = corner(Q16(.06), degrees + Q16(90), red);
    c[2] = c[4] = corner(Q16(.2), degrees + Q16(180), red);
    c[5] = corner(Q16(.06), degrees - Q16(90), red);
    for (int32_t i = 0; i < 6; i++) {
        qtri_corner middle = {{0, 0, 0, Q16(1)}, white, {0, 0}};
        c[6 + 3 * i] = middle;
        c[7 + 3 * i] = corner(Q16(.09), i * Q16(60), white);
        c[8 + 3 * i] = corner(Q16(.09), (i + 1) * Q16(60), white);
    }
    qtri_draw_triangles(band, view, &pose, c, 6 + 18, material);
}

/* The pixels that a needle may touch: a box about its tip and its tail, and one more all around. */
static qtri_rect needle_box(const qtri_frame *frame, q16 degrees)
{
    int32_t radius = (frame->width < frame->height ? frame->width : frame->height) / 2;
    int32_t x = frame->width / 2, y = frame->height / 2;
    int32_t tip_x = q16_to_int_round(q16_mul(q16_cos_deg(degrees), radius * Q16(.78)));
    int32_t tip_y = -q16_to_int_round(q16_mul(q16_sin_deg(degrees), radius * Q16(.78)));
    int32_t hub = radius / 4 + 2; /* the tail is at .2 */
    qtri_rect box = {x - hub, y - hub, x + hub, y + hub};
    box.x0 = tip_x - 2 < -hub ? x + tip_x - 2 : box.x0;
    box.x1 = tip_x + 2 > hub ? x + tip_x + 2 : box.x1;
    box.y0 = tip_y - 2 < -hub ? y + tip_y - 2 : box.y0;
    box.y1 = tip_y + 2 > hub ? y + tip_y + 2 : box.y1;
    return box;
}

/* What draws dial and needle: colours, without depth. */
QTRI_PIPELINE(dial_pipeline, .format = QTRI_RGB565, .shade = QTRI_COLORS)
static const qtri_pipeline *const pipelines[] = {&dial_pipeline, NULL};

enum qtri_error example_run(void)
{
    qtri_screen screen;
    qtri_view view;
    qtri_transform still;
    qtri_material plain = qtri_material_default();
    plain.depth_compare = QTRI_DEPTH_OFF;
    plain.cull = QTRI_CULL_NONE;
    make_dial();
    enum qtri_error error = example_display(&screen.panel);
    if (error == QTRI_OK) {
        error = qtri_screen_begin(&screen, &qtri_rgb565, ROWS, band_memory, sizeof band_memory);
    }
    if (error != QTRI_OK) {
        return error;
    }
    const int32_t width = screen.frame.width, height = screen.frame.height;
    screen.background = face;
    /* -1..1 is the shorter side. */
    q16 across = width > height ? q16_from_ratio(width, height) : Q16(1);
    q16 up = height > width ? q16_from_ratio(height, width) : Q16(1);
    qtri_view_init_pipelines(&view, width, height, pipelines);
    qtri_transform_ortho(&view.projection, -across, across, -up, up, Q16(-1), Q16(1));
    qtri_transform_identity(&still);

    q16 value = 0, wanted = Q16(.1), before = angle_of(0);
    do {
        q16 degrees = angle_of(value);
        qtri_rect left = needle_box(&screen.frame, before),
                  entered = needle_box(&screen.frame, degrees);
        qtri_surface band;
        qtri_frame_mark(&screen.frame, &left);
        qtri_frame_mark(&screen.frame, &entered);
        qtri_frame_only_changes(&screen.frame);
        while (qtri_screen_next(&screen, &band)) {
            qtri_draw_triangles(&band, &view, &still, arc, 6 * ARC, &plain);
            qtri_draw_triangles(&band, &view, &still, ticks, 6 * TICKS, &plain);
            draw_needle(&band, &view, degrees, &plain);
        }
        before = degrees;
        /* What a sensor would say: here a value that jumps, and a needle that follows. */
        value += q16_mul(wanted - value, Q16(.35));
        wanted = q16_mod(wanted + Q16(.13), Q16(1));
    } while (screen.error == QTRI_OK && example_next_frame(&screen.panel));
    return screen.error;
}
