/* SPDX-License-Identifier: MIT */
/*
 * An attitude indicator on a gray OLED of 128x64: horizon and pitch ladder turn behind the symbol
 * of the aircraft, as a gyroscope and an accelerometer say (imu.h).
 *
 * Their samples pass Mahony's filter (qtri/quat.h), which learns the offset of the gyroscope.
 */
#include <qtri.h>

#include "qtri_port/screen.h"

#include "../example.h"
#include "imu.h"

enum { WIDTH = 128, HEIGHT = 64, ROWS = 16, SAMPLES_A_FRAME = 8 };

const char example_name[] = "attitude";

static uint8_t band_memory[QTRI_FRAME_BYTES(WIDTH, ROWS, QTRI_GRAY8_BYTES)];

/* Multiples of 17 are levels of a display of 16 grays: areas of them are not dithered. */
static const qtri_rgb sky = {119, 119, 119}, ground = {34, 34, 34}, black = {0, 0, 0},
                      white = {255, 255, 255};

/* Pixels, on a display of 64 rows. */
#define ROWS_OF_LAYOUT  64
#define PIXELS_A_DEGREE Q16(1.2)
#define FAR_AWAY        Q16(400)

/* How the horizon lies on the screen. */
typedef struct horizon {
    q16 scale;        /* of the display's rows to those of the layout */
    q16 x, y;         /* the middle of the screen, pixels */
    q16 sine, cosine; /* of the bank, right wing down */
    q16 pitch;        /* degrees, nose up */
} horizon;

/* The world's up in axes of the body says bank and pitch. */
static horizon horizon_of(const qtri_frame *frame, qtri_quat body_to_world)
{
    const qtri_vec3 world_up = {0, Q16(1), 0};
    qtri_vec3 up = qtri_quat_rotate(qtri_quat_conjugate(body_to_world), world_up);
    horizon h;
    h.scale = q16_from_ratio(frame->height, ROWS_OF_LAYOUT);
    h.x = q16_from_ratio(frame->width, 2);
    h.y = q16_from_ratio(frame->height, 2);
    q16_sincos_deg(q16_atan2_deg(-up.x, up.y), &h.sine, &h.cosine);
    h.pitch = q16_atan2_deg(-up.z, q16_hypot(up.x, up.y));
    return h;
}

/* A point beside the ladder's middle, `right` along and `up` above the horizon, on the screen. */
static qtri_point screen_point(const horizon *h, q16 right, q16 up)
{
    right = q16_mul(right, h->scale);
    up = q16_mul(up - q16_mul(h->pitch, PIXELS_A_DEGREE), h->scale);
    q16 x = h->x + q16_mul(right, h->cosine) - q16_mul(up, h->sine);
    q16 y = h->y - q16_mul(right, h->sine) - q16_mul(up, h->cosine);
    qtri_point point = {q16_to_q8(x), q16_to_q8(y)};
    return point;
}

/* Upright, whatever the bank: the middle of the number is at the point. */
static void draw_number(const qtri_surface *band, qtri_point middle, const char *text)
{
    const qtri_brush brush = qtri_brush_of(white);
    int32_t width = qtri_text_width(&qtri_font_small, text);
    qtri_text_paint(band, &qtri_font_small, (middle.x_24p8 - QTRI_PX(width) / 2 + 128) >> 8,
                    (middle.y_24p8 + QTRI_PX(3.5) + 128) >> 8, text, &brush);
}

/* Rungs at 10, 20 and 30 degrees up and down; those below are shorter. */
static void draw_ladder(const qtri_surface *band, const horizon *h)
{
    static const char *const numbers[] = {"10", "20", "30"};
    const qtri_brush brush = {white, 255, &qtri_ink_smooth};
    for (int32_t i = 0; i < 6; i++) {
        q16 up = (i / 2 + 1) * (i % 2 == 0 ? 10 : -10) * PIXELS_A_DEGREE;
        q16 half = i % 2 == 0 ? Q16(11) : Q16(6);
        qtri_point left = screen_point(h, -half, up), right = screen_point(h, half, up);
        qtri_paint_stroke(band, &left, &right, QTRI_PX(1), &brush);
        draw_number(band, screen_point(h, half + Q16(9), up), numbers[i / 2]);
        draw_number(band, screen_point(h, -half - Q16(8), up), numbers[i / 2]);
    }
}

/* Wings whose roots bend down, and a dot where the nose points: white, in a black border. */
static void draw_aircraft(const qtri_surface *band, const horizon *h)
{
    static const int8_t parts[5][4] = {
        {-52, -1, -31, 2}, {31, -1, 52, 2}, {-34, -1, -31, 6}, {31, -1, 34, 6}, {-2, -2, 2, 2}};
    for (int32_t border = 1; border >= 0; border--) {
        const qtri_brush brush = qtri_brush_of(border != 0 ? black : white);
        for (int32_t i = 0; i < 5; i++) {
            const int8_t *p = parts[i];
            const qtri_area box = {q16_to_q8(h->x + (p[0] - border) * h->scale),
                                   q16_to_q8(h->y + (p[1] - border) * h->scale),
                                   q16_to_q8(h->x + (p[2] + border) * h->scale),
                                   q16_to_q8(h->y + (p[3] + border) * h->scale)};
            qtri_paint_rect(band, &box, &brush);
        }
    }
}

static void draw(const qtri_surface *band, const horizon *h)
{
    const qtri_brush earth = {ground, 255, &qtri_ink_smooth}, line = {white, 255, &qtri_ink_smooth};
    const qtri_point corner[4] = {screen_point(h, -FAR_AWAY, 0), screen_point(h, FAR_AWAY, 0),
                                  screen_point(h, FAR_AWAY, -FAR_AWAY),
                                  screen_point(h, -FAR_AWAY, -FAR_AWAY)};
    qtri_paint_polygon(band, corner, 4, &earth);
    qtri_paint_stroke(band, &corner[0], &corner[1], QTRI_PX(1.5), &line);
    draw_ladder(band, h);
    draw_aircraft(band, h);
}

enum qtri_error example_run(void)
{
    qtri_screen screen;
    qtri_attitude_filter filter;
    enum qtri_error error = example_display(&screen.panel);
    if (error == QTRI_OK) {
        error = qtri_screen_begin(&screen, &qtri_gray8, ROWS, band_memory, sizeof band_memory);
    }
    if (error != QTRI_OK) {
        return error;
    }
    screen.background = sky;
    qtri_attitude_filter_init(&filter, Q16(1), Q16(.25)); /* back in a second, without overshoot */

    do {
        qtri_surface band;
        for (int32_t i = 0; i < SAMPLES_A_FRAME; i++) {
            imu_sample sample = imu_read();
            qtri_attitude_filter_step(&filter, sample.rate, sample.force,
                                      ((int32_t)1 << 30) / IMU_RATE_HZ);
        }
        horizon h = horizon_of(&screen.frame, qtri_attitude_quat(&filter.attitude));
        while (qtri_screen_next(&screen, &band)) {
            draw(&band, &h);
        }
    } while (screen.error == QTRI_OK && example_next_frame(&screen.panel));
    return screen.error;
}
