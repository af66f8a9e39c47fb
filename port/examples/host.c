/* SPDX-License-Identifier: MIT */
/*
 * The examples on this computer: on the displays of display.h. Frames become pictures; the
 * emulated boards' are compared.
 *
 *   example lcd|oled|paper FOLDER          writes FOLDER/0-NAME.ppm, 1-NAME.ppm, ...
 *   example lcd|oled|paper FOLDER DUMPS    and compares them with those of the same names in DUMPS
 *   example ... DUMPS FRAMES               so many frames in place of 8
 *
 * A line `frame <number> <name> <pixels> <mismatches> <not as the first pixel>` for each. Status 0
 * when all of them are equal. A dump may be enlarged, and has as many bits of a colour as the
 * display.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "display.h"
#include "example.h"

static struct {
    const char *folder, *dumps;
    int frame, frames;
    long mismatches;
} host;

static void fail(const char *path, const char *what)
{
    fprintf(stderr, "%s: %s\n", path, what);
    exit(2);
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
    if (display_complaint() != NULL) {
        fail(example_name, display_complaint());
    }
    long other = 0, wrong = 0;
    for (int i = 0; i < width * height; i++) {
        display_pixel(i % width, i / width, rgb + 3 * (size_t)i);
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
    return ++host.frame < host.frames;
}

int main(int argc, char **argv)
{
    if (argc < 3 || !display_choose(argv[1])) {
        fail(argv[0], "usage: lcd|oled|paper FOLDER [DUMPS [FRAMES]]");
    }
    host.folder = argv[2];
    host.dumps = argc > 3 ? argv[3] : NULL;
    host.frames = argc > 4 ? atoi(argv[4]) : 8;
    if (example_run() != QTRI_OK) {
        fail(example_name, "failed");
    }
    return host.mismatches != 0;
}
