/* SPDX-License-Identifier: MIT */
/*
 * The smallest useful application: flat triangles with depth, here an octahedron.
 */
#include "app.h"

#define R                                                                                          \
    {                                                                                              \
        255, 64, 64                                                                                \
    }
#define G                                                                                          \
    {                                                                                              \
        64, 255, 64                                                                                \
    }
#define Y                                                                                          \
    {                                                                                              \
        255, 255, 64                                                                               \
    }
#define B                                                                                          \
    {                                                                                              \
        64, 64, 255                                                                                \
    }
#define ONE Q16_ONE
#define FACE(x, y, z, color)                                                                       \
    {{x, 0, 0, ONE}, color, {0, 0}}, {{0, y, 0, ONE}, color, {0, 0}},                              \
    {                                                                                              \
        {0, 0, z, ONE}, color,                                                                     \
        {                                                                                          \
            0, 0                                                                                   \
        }                                                                                          \
    }
static const qtri_corner corners[24] = {
    FACE(ONE, ONE, ONE, R),   FACE(-ONE, ONE, ONE, G),   FACE(ONE, -ONE, ONE, Y),
    FACE(ONE, ONE, -ONE, B),  FACE(-ONE, -ONE, ONE, B),  FACE(-ONE, ONE, -ONE, Y),
    FACE(ONE, -ONE, -ONE, G), FACE(-ONE, -ONE, -ONE, R),
};

static uint32_t band_memory[QTRI_BAND_BYTES(APP_WIDTH, APP_BAND_ROWS, QTRI_RGB565_BYTES) / 4];
static qtri_view view;
static qtri_transform pose;
static qtri_surface band;

static const qtri_material material = {.shading = QTRI_FLAT_LAST, .depth_compare = QTRI_LESS};

static const qtri_pipeline *const pipelines[] = {&qtri_pipeline_flat, NULL};

void app_setup(void)
{
    const qtri_vec3 back = {0, 0, Q16(-3)};
    qtri_view_init_pipelines(&view, APP_WIDTH, APP_HEIGHT, pipelines);
    qtri_transform_translate(&view.camera, back);
    qtri_transform_perspective(&view.projection, Q16(60), Q16(4.0 / 3.0), Q16(.5), Q16(20));
}

void app_frame(int32_t number)
{
    const qtri_rgb sky = {24, 32, 48};
    const qtri_vec3 nearer = {0, 0, Q16(.25) * number};
    qtri_transform_identity(&pose);
    qtri_transform_translate(&pose, nearer);
    qtri_transform_rotate_y(&pose, Q16(15) * number);
    for (int32_t row = 0; row < APP_HEIGHT; row += APP_BAND_ROWS) {
        qtri_surface_init(&band, &qtri_rgb565, APP_WIDTH, APP_HEIGHT, row, APP_BAND_ROWS,
                          band_memory, sizeof band_memory);
        qtri_surface_clear(&band, sky);
        qtri_draw_triangles(&band, &view, &pose, corners, 24, &material);
        display_write(&band);
    }
}
