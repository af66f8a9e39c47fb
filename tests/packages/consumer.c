/* SPDX-License-Identifier: MIT */
/* An application of a packaged library: draws a frame in bands and prints a checksum of it. */
#include <inttypes.h>
#include <qtri.h>
#ifndef QTRI_AMALGAMATION_H
#include <qtri_port/ili9341.h>
#endif
#include <stdio.h>

enum { WIDTH = 64, HEIGHT = 48, ROWS = 16 };

static uint8_t memory[QTRI_FRAME_BYTES(WIDTH, ROWS, QTRI_RGB565_BYTES)];

int main(void)
{
    static const qtri_corner corners[3] = {
        {{-Q16_ONE, -Q16_ONE, 0, Q16_ONE}, {255, 0, 0}, {0, 0}},
        {{Q16_ONE, -Q16_ONE, 0, Q16_ONE}, {0, 255, 0}, {0, 0}},
        {{0, Q16_ONE, 0, Q16_ONE}, {0, 0, 255}, {0, 0}},
    };
    const qtri_rgb sky = {10, 20, 30};
    qtri_frame frame;
    qtri_surface band;
    qtri_view view;
    qtri_transform pose;
    qtri_material material = qtri_material_default();
    uint32_t sum = 2166136261u;
    qtri_view_init(&view, WIDTH, HEIGHT);
    qtri_transform_identity(&pose);
    if (qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, ROWS, memory, sizeof memory) !=
            QTRI_OK ||
        qtri_ili9341.width != 240) {
        return 1;
    }
    while (qtri_frame_next_band(&frame, &band)) {
        qtri_surface_clear(&band, sky);
        qtri_draw_triangles(&band, &view, &pose, corners, 3, &material);
        for (int32_t y = band.first_row; y < band.first_row + band.rows; y++) {
            for (int32_t x = 0; x < WIDTH; x++) {
                qtri_rgb c = qtri_surface_pixel(&band, x, y);
                sum = (sum ^ ((uint32_t)c.r << 16 | (uint32_t)c.g << 8 | c.b)) * 16777619u;
            }
        }
    }
    printf("qtri %s %08" PRIX32 "\n", QTRI_VERSION_TEXT, sum);
    return 0;
}
