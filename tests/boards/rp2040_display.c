/* SPDX-License-Identifier: MIT */
/*
 * The display on the RP2040: what rp2040.mjs prints comes in, the simulated ILI9341 gets it, and
 * the console's lines go out. For each `frame <number> <name> ...` what is seen is written to
 * FOLDER/<number>-<name>.ppm, upright:
 *
 *   node rp2040.mjs ... | rp2040_display FOLDER
 *
 * Status 1 when the controller complains.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "panels/controllers.h"

enum { WIDTH = 320, HEIGHT = 240, LINE = 8192 };

static void fail(const char *what)
{
    fprintf(stderr, "rp2040_display: %s\n", what);
    exit(1);
}

static int digit(char c)
{
    return c <= '9' ? c - '0' : c - 'a' + 10;
}

static void send(chip *display, bool is_data, const char *hex)
{
    uint8_t bytes[LINE / 2];
    size_t count = 0;
    for (; hex[0] > ' ' && hex[1] > ' '; hex += 2) {
        bytes[count++] = (uint8_t)(digit(hex[0]) << 4 | digit(hex[1]));
    }
    chip_send(display, is_data, bytes, count);
    if (display->error[0] != '\0') {
        fail(display->error);
    }
}

/* The frame is turned clockwise: its upper left corner is the glass's upper right one. */
static void write_picture(const chip *display, const char *folder, unsigned number,
                          const char *name)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/%u-%s.ppm", folder, number, name);
    FILE *file = fopen(path, "wb");
    if (file == NULL) {
        fail(path);
    }
    fprintf(file, "P6\n%d %d\n255\n", WIDTH, HEIGHT);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        uint32_t color = chip_pixel(display, HEIGHT - 1 - i / WIDTH, i % WIDTH);
        putc((int)(color >> 16), file);
        putc((int)(color >> 8 & 255), file);
        putc((int)(color & 255), file);
    }
    if (fclose(file) != 0) {
        fail(path);
    }
}

int main(int argc, char **argv)
{
    static lcd display;
    char line[LINE];
    if (argc != 2) {
        fprintf(stderr, "usage: rp2040_display FOLDER <OUTPUT_OF_RP2040_MJS\n");
        return 2;
    }
    ili9341_init(&display);
    while (fgets(line, sizeof line, stdin) != NULL) {
        unsigned value = 0;
        char name[64];
        if (sscanf(line, "at %u", &value) == 1) {
            chip_wait(&display.chip, value - (uint32_t)display.chip.now_ms);
        } else if (sscanf(line, "reset %u", &value) == 1) {
            chip_reset_pin(&display.chip, value == 0);
        } else if (strncmp(line, "command ", 8) == 0) {
            send(&display.chip, false, line + 8);
        } else if (strncmp(line, "data ", 5) == 0) {
            send(&display.chip, true, line + 5);
        } else {
            fputs(line, stdout);
            if (sscanf(line, "frame %u %63s", &value, name) == 2) {
                write_picture(&display.chip, argv[1], value, name);
            }
        }
    }
    return 0;
}
