/* SPDX-License-Identifier: MIT */
/*
 * The examples on this computer: on a display in memory (lcd, 320x240), or on a simulated
 * controller of host/panels: an OLED's, the SSD0323 (oled, 128x64), or e-paper's, the SSD1680
 * (paper, 250x122). Frames become pictures; the emulated boards' are compared.
 *
 *   example lcd|oled|paper FOLDER          writes FOLDER/0-NAME.ppm, 1-NAME.ppm, ...
 *   example lcd|oled|paper FOLDER DUMPS    and compares them with those of the same names in DUMPS
 *
 * A line `frame <number> <name> <pixels> <mismatches> <not as the first pixel>` for each. Status 0
 * when all of them are equal. A dump may be enlarged, and has as many bits of a colour as the
 * display.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "example.h"
#include "panels/controllers.h"
#include "qtri_port/framebuffer.h"
#include "qtri_port/ssd0323.h"
#include "qtri_port/ssd1680.h"

enum { FRAMES = 8, LCD_WIDTH = 320, LCD_HEIGHT = 240 };

static struct {
    enum { LCD, OLED, PAPER } display;
    const char *folder, *dumps;
    int frame;
    long mismatches;
    uint16_t framebuffer[LCD_WIDTH * LCD_HEIGHT];
    union {
        chip chip;
        ssd0323 oled;
        ssd1680 paper;
    } sim;
    uint8_t panel_memory[QTRI_SSD1680_BYTES]; /* the OLED needs a row of it */
} host;

static void fail(const char *path, const char *what)
{
    fprintf(stderr, "%s: %s\n", path, what);
    exit(2);
}

static bool send_command(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    chip_send(&host.sim.chip, false, bytes, count);
    return true;
}

static bool send_data(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    chip_send(&host.sim.chip, true, bytes, count);
    return true;
}

static void wait_ms(void *context, uint32_t ms)
{
    (void)context;
    chip_wait(&host.sim.chip, ms);
}

static void reset(void *context, bool active)
{
    (void)context;
    chip_reset_pin(&host.sim.chip, active);
}

static bool busy(void *context)
{
    (void)context;
    return chip_busy(&host.sim.chip);
}

enum qtri_error example_display(qtri_panel *panel)
{
    static const qtri_panel_description screen =
        QTRI_FRAMEBUFFER(LCD_WIDTH, LCD_HEIGHT, QTRI_PANEL_RGB565, QTRI_ORDER_NATIVE);
    static const qtri_bus bus = {NULL,    send_command, send_data, NULL, NULL,
                                 wait_ms, reset,        busy,      0};
    if (host.display == LCD) {
        return qtri_panel_init(panel, &screen, NULL, QTRI_ROTATE_0, host.framebuffer,
                               sizeof host.framebuffer);
    }
    if (host.display == PAPER) {
        ssd1680_init(&host.sim.paper);
        return qtri_panel_init(panel, &qtri_ssd1680_partial, &bus, QTRI_ROTATE_90,
                               host.panel_memory, sizeof host.panel_memory);
    }
    ssd0323_init(&host.sim.oled);
    return qtri_panel_init(panel, &qtri_ssd0323, &bus, QTRI_ROTATE_0, host.panel_memory,
                           QTRI_SSD0323_ROW_BYTES);
}

/* E-paper is turned clockwise: the frame's upper left corner is the glass's upper right one. */
static void seen(int x, int y, unsigned char rgb[3])
{
    uint32_t color = host.display == LCD ? qtri_decode_rgb565(host.framebuffer[y * LCD_WIDTH + x])
                     : host.display == OLED ? chip_pixel(&host.sim.chip, x, y)
                                            : chip_pixel(&host.sim.chip, 121 - y, x);
    rgb[0] = (unsigned char)(color >> 16);
    rgb[1] = (unsigned char)(color >> 8);
    rgb[2] = (unsigned char)color;
}

static void write_picture(const char *path, int width, int height, const unsigned char *rgb)
{
    FILE *file = fopen(path, "wb");
    if (file == NULL) {
        fail(path, "cannot be written");
    }
    size_t bytes = (size_t)width * (size_t)height * 3;
    fprintf(file, "P6\n%d %d\n255\n", width, height);
    bool ok = fwrite(rgb, 1, bytes, file) == bytes;
    if (fclose(file) != 0 || !ok) {
        fail(path, "cannot be written");
    }
}

/* Pixels that the dump shows otherwise: 5, 6 and 5 bits are what the display has. */
static long compare_picture(const char *path, int width, int height, const unsigned char *rgb)
{
    int dump_width = 0, dump_height = 0;
    FILE *file = fopen(path, "rb");
    if (file == NULL || fscanf(file, "P6 %d %d 255", &dump_width, &dump_height) != 2 ||
        fgetc(file) != '\n' || dump_width < width || dump_width > 8 * width ||
        dump_width % width != 0 || dump_height != dump_width / width * height) {
        fail(path, "is no picture of the display");
    }
    int scale = dump_width / width;
    long wrong = 0;
    for (int y = 0; y < dump_height; y++) {
        for (int x = 0; x < dump_width; x++) {
            const unsigned char *is =
                rgb + 3 * ((size_t)(y / scale) * (size_t)width + (size_t)(x / scale));
            unsigned char dumped[3];
            if (fread(dumped, 1, 3, file) != 3) {
                fail(path, "ends early");
            }
            wrong += is[0] >> 3 != dumped[0] >> 3 || is[1] >> 2 != dumped[1] >> 2 ||
                     is[2] >> 3 != dumped[2] >> 3;
        }
    }
    fclose(file);
    return wrong;
}

bool example_next_frame(qtri_panel *panel)
{
    int width = (int)qtri_panel_width(panel), height = (int)qtri_panel_height(panel);
    unsigned char *rgb = calloc((size_t)width * (size_t)height, 3);
    if (rgb == NULL || qtri_panel_finish(panel) != QTRI_OK) {
        fail(example_name, "no picture");
    }
    if (host.display != LCD && host.sim.chip.error[0] != '\0') {
        fail(example_name, host.sim.chip.error);
    }
    long other = 0, wrong = 0;
    for (int i = 0; i < width * height; i++) {
        seen(i % width, i / width, rgb + 3 * (size_t)i);
        other += memcmp(rgb, rgb + 3 * (size_t)i, 3) != 0;
    }
    char path[1024];
    snprintf(path, sizeof path, "%s/%d-%s.ppm", host.folder, host.frame, example_name);
    write_picture(path, width, height, rgb);
    if (host.dumps != NULL) {
        snprintf(path, sizeof path, "%s/%d-%s.ppm", host.dumps, host.frame, example_name);
        wrong = compare_picture(path, width, height, rgb);
    }
    free(rgb);
    printf("frame %d %s %d %ld %ld\n", host.frame, example_name, width * height, wrong, other);
    host.mismatches += wrong;
    return ++host.frame < FRAMES;
}

int main(int argc, char **argv)
{
    static const char *const displays[] = {"lcd", "oled", "paper"};
    int display = 0;
    while (argc > 2 && display < 3 && strcmp(argv[1], displays[display]) != 0) {
        display++;
    }
    if (argc < 3 || display == 3) {
        fail(argv[0], "usage: lcd|oled|paper FOLDER [DUMPS]");
    }
    host.display = display == 0 ? LCD : display == 1 ? OLED : PAPER;
    host.folder = argv[2];
    host.dumps = argc > 3 ? argv[3] : NULL;
    if (example_run() != QTRI_OK) {
        fail(example_name, "failed");
    }
    return host.mismatches != 0;
}
