/* SPDX-License-Identifier: MIT */
/*
 * An attitude indicator on a gray OLED of 128x64: horizon and pitch ladder turn behind the symbol
 * of the aircraft, as a gyroscope and an accelerometer say (imu.h).
 *
 * Bank and pitch come from a complementary filter: the gyroscope's rates are summed up, and what
 * that drifts is drawn back, with a time constant of some 2 seconds, to where the accelerometer's
 * gravity is. Rates about the body's axes are taken for those of bank and pitch: right for small
 * pitch, which is what an indicator in a glider sees; tests/boards/attitude.c has a filter without
 * that limit.
 */
#include <qtri.h>
#include <qtri/pipeline_make.h>

#include "qtri_port/screen.h"

#include "../example.h"
#include "imu.h"

enum { WIDTH = 128, HEIGHT = 64, ROWS = 16, SAMPLES_A_FRAME = 8, RUNGS = 6 };

const char example_name[] = "attitude";

static uint8_t band_memory[QTRI_FRAME_BYTES(WIDTH, ROWS, QTRI_GRAY8_BYTES)];

/* In the plane of the display, whose height is -1..1. */
#define UNITS_A_DEGREE Q16(1.0 / 28)
#define AT(x, y, gray)                                                                             \
    {                                                                                              \
        {x, y, 0, Q16(1)}, {gray, gray, gray},                                                     \
        {                                                                                          \
            0, 0                                                                                   \
        }                                                                                          \
    }

static const qtri_corner ground[6] = {AT(Q16(-6), 0, 70),      AT(Q16(-6), Q16(-8), 20),
                                      AT(Q16(6), Q16(-8), 20), AT(Q16(-6), 0, 70),
                                      AT(Q16(6), Q16(-8), 20), AT(Q16(6), 0, 70)};
static const qtri_corner horizon[2] = {AT(Q16(-6), 0, 255), AT(Q16(6), 0, 255)};
static const qtri_corner symbol[8] = {AT(Q16(-.8), 0, 255),  AT(Q16(-.25), 0, 255),
                                      AT(Q16(-.25), 0, 255), AT(Q16(-.12), Q16(-.14), 255),
                                      AT(Q16(.8), 0, 255),   AT(Q16(.25), 0, 255),
                                      AT(Q16(.25), 0, 255),  AT(Q16(.12), Q16(-.14), 255)};

/* Rungs at 10, 20 and 30 degrees up and down; those below are shorter. */
static void make_ladder(qtri_corner ladder[2 * RUNGS])
{
    for (int32_t i = 0; i < RUNGS; i++) {
        int32_t degrees = (i / 2 + 1) * (i % 2 == 0 ? 10 : -10);
        q16 half = degrees > 0 ? Q16(.35) : Q16(.2);
        q16 y = degrees * UNITS_A_DEGREE;
        const qtri_corner from = AT(-half, y, 220), to = AT(half, y, 220);
        ladder[2 * i] = from;
        ladder[2 * i + 1] = to;
    }
}

/* Degrees. */
typedef struct attitude {
    q16 bank, pitch; /* right wing down, nose up */
} attitude;

static void step(attitude *a, const imu_sample *sample)
{
    q16 level = q16_sqrt(q16_mul(sample->force.x, sample->force.x) +
                         q16_mul(sample->force.y, sample->force.y));
    q16 bank = q16_atan2_deg(sample->force.x, sample->force.y);
    q16 pitch = q16_atan2_deg(-sample->force.z, level);
    a->bank += -sample->rate.z / IMU_RATE_HZ;
    a->pitch += sample->rate.x / IMU_RATE_HZ;
    a->bank += q16_mul(bank - a->bank, Q16(.008));
    a->pitch += q16_mul(pitch - a->pitch, Q16(.008));
}

static void draw(const qtri_surface *band, const qtri_view *view, const attitude *a)
{
    qtri_corner ladder[2 * RUNGS];
    qtri_material plain = qtri_material_default();
    plain.depth_compare = QTRI_DEPTH_OFF;
    plain.cull = QTRI_CULL_NONE;
    qtri_transform world, still;
    const qtri_vec3 down = {0, -q16_mul(a->pitch, UNITS_A_DEGREE), 0};
    qtri_transform_identity(&still);
    qtri_transform_identity(&world);
    qtri_transform_rotate_z(&world, a->bank);
    qtri_transform_translate(&world, down);
    make_ladder(ladder);
    qtri_draw_triangles(band, view, &world, ground, 6, &plain);
    qtri_draw_lines(band, view, &world, horizon, 2, &plain);
    qtri_draw_lines(band, view, &world, ladder, 2 * RUNGS, &plain);
    qtri_draw_lines(band, view, &still, symbol, 8, &plain);
}

/* What draws the ground. */
QTRI_PIPELINE(ground_pipeline, .format = QTRI_GRAY8, .shade = QTRI_COLORS)
static const qtri_pipeline *const pipelines[] = {&ground_pipeline, NULL};

enum qtri_error example_run(void)
{
    qtri_screen screen;
    qtri_view view;
    attitude now = {0, 0};
    enum qtri_error error = example_display(&screen.panel);
    if (error == QTRI_OK) {
        error = qtri_screen_begin(&screen, &qtri_gray8, ROWS, band_memory, sizeof band_memory);
    }
    if (error != QTRI_OK) {
        return error;
    }
    const int32_t width = screen.frame.width, height = screen.frame.height;
    const qtri_rgb sky = {150, 150, 150};
    screen.background = sky;
    q16 aspect = q16_from_ratio(width, height);
    qtri_view_init_pipelines(&view, width, height, pipelines);
    qtri_transform_ortho(&view.projection, -aspect, aspect, Q16(-1), Q16(1), Q16(-1), Q16(1));

    do {
        qtri_surface band;
        for (int32_t i = 0; i < SAMPLES_A_FRAME; i++) {
            imu_sample sample = imu_read();
            step(&now, &sample);
        }
        while (qtri_screen_next(&screen, &band)) {
            draw(&band, &view, &now);
        }
    } while (screen.error == QTRI_OK && example_next_frame(&screen.panel));
    return screen.error;
}
