/* SPDX-License-Identifier: MIT */
/*
 * What a board's display must show, computed on the host, and the comparison:
 *
 *   show_BOARD FOLDER          writes the pictures there: 0-gouraud.ppm, ...
 *   show_BOARD FOLDER DUMPS    and compares them with the dumps in DUMPS, files of the same names
 *
 * A line `frame <number> <scene> <pixels> <mismatches> <drawn>` for each, drawn being the pixels
 * with a depth. Status 0 when all of them are equal.
 *
 * The host draws whole frames where the board draws bands, and takes levels of gray from the whole
 * frame by the rule of dither.h; what lies between a band and the glass (panel driver, bus, display
 * controller) is the board's alone. A dump may be enlarged: all pixels of a pixel must be equal.
 */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "display_show.h"
#include "qtri/dither.h"

static const display_show *const show = &display_show_here;

enum { WHITE_LEVEL = 15 }; /* of the gray display */

typedef struct picture {
    int width, height;
    unsigned char *rgb;
} picture;

/* The frame as QEMU shows it: 565 with zeros in the low bits, levels of gray as multiples of 17. */
static void take_picture(const qtri_surface *surface, picture *out)
{
    unsigned char *rgb = out->rgb;
    uint8_t level[QTRI_SURFACE_MAX];
    for (int32_t y = 0; y < surface->height; y++) {
        const void *row = surface->pixels + y * surface->pitch;
        if (surface->format == &qtri_gray8) {
            qtri_dither_row(QTRI_DITHER_BAYER8, WHITE_LEVEL, 0, y, row, surface->width, level);
        }
        for (int32_t x = 0; x < surface->width; x++, rgb += 3) {
            if (surface->format == &qtri_gray8) {
                memset(rgb, level[x] * 17, 3);
            } else {
                uint32_t pixel = ((const uint16_t *)row)[x];
                rgb[0] = (unsigned char)(pixel >> 11 << 3);
                rgb[1] = (unsigned char)((pixel >> 5 & 63) << 2);
                rgb[2] = (unsigned char)((pixel & 31) << 3);
            }
        }
    }
}

static void fail(const char *path, const char *what)
{
    fprintf(stderr, "%s: %s\n", path, what);
    exit(2);
}

static void write_ppm(const char *path, const picture *image)
{
    FILE *file = fopen(path, "wb");
    if (file == NULL) {
        fail(path, "cannot be written");
    }
    fprintf(file, "P6\n%d %d\n255\n", image->width, image->height);
    size_t bytes = (size_t)image->width * (size_t)image->height * 3;
    bool ok = fwrite(image->rgb, 1, bytes, file) == bytes;
    if (fclose(file) != 0 || !ok) {
        fail(path, "cannot be written");
    }
}

/* As QEMU writes it: P6, no comments. */
static picture read_ppm(const char *path)
{
    picture image = {0, 0, NULL};
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        fail(path, "is missing");
    }
    char header[3][32] = {"", "", ""};
    for (int i = 0; i < 3; i++) {
        if (fgets(header[i], sizeof header[i], file) == NULL) {
            fail(path, "is no PPM");
        }
    }
    char *rest = header[1];
    image.width = (int)strtol(rest, &rest, 10);
    image.height = (int)strtol(rest, &rest, 10);
    if (strcmp(header[0], "P6\n") != 0 || strcmp(header[2], "255\n") != 0 || image.width < 1 ||
        image.width > QTRI_SURFACE_MAX || image.height < 1 || image.height > QTRI_SURFACE_MAX) {
        fail(path, "is no PPM");
    }
    size_t bytes = (size_t)image.width * (size_t)image.height * 3;
    image.rgb = malloc(bytes);
    if (image.rgb == NULL || fread(image.rgb, 1, bytes, file) != bytes) {
        fail(path, "ends early");
    }
    fclose(file);
    return image;
}

static const unsigned char *pixel_at(const picture *image, int x, int y)
{
    return image->rgb + 3 * ((size_t)y * (size_t)image->width + (size_t)x);
}

/* Pixels of `expected` that the dump, a whole number of times as large, does not show. */
static long count_mismatches(const picture *expected, const picture *dump)
{
    int scale = dump->width / expected->width;
    if (scale < 1 || dump->width != scale * expected->width ||
        dump->height != scale * expected->height) {
        return (long)expected->width * expected->height;
    }
    long mismatches = 0;
    for (int y = 0; y < expected->height; y++) {
        for (int x = 0; x < expected->width; x++) {
            bool same = true;
            for (int i = 0; i < scale * scale; i++) {
                same = same &&
                       memcmp(pixel_at(expected, x, y),
                              pixel_at(dump, x * scale + i % scale, y * scale + i / scale), 3) == 0;
            }
            mismatches += !same;
        }
    }
    return mismatches;
}

static long count_drawn(const qtri_surface *surface)
{
    long drawn = 0;
    for (int32_t y = 0; y < surface->height; y++) {
        for (int32_t x = 0; x < surface->width; x++) {
            drawn += surface->depth[y * surface->depth_pitch + x] != UINT16_MAX;
        }
    }
    return drawn;
}

static void *allocate(size_t bytes)
{
    void *memory = malloc(bytes);
    if (memory == NULL) {
        fail("memory", "is too small");
    }
    return memory;
}

int main(int argc, char **argv)
{
    if (argc < 2) {
        fail(argv[0], "FOLDER [DUMPS]");
    }
    size_t bytes = QTRI_BAND_BYTES(show->width, show->height, show->format->pixels->bytes);
    void *memory = allocate(bytes);
    void *scratch = allocate(show->bytes);
    picture expected = {(int)show->width, (int)show->height,
                        allocate((size_t)show->width * (size_t)show->height * 3)};
    long all_mismatches = 0;
    show->prepare(scratch);
    for (uint32_t i = 0; i < show->frames; i++) {
        const char *scene = show->advance(scratch, i);
        qtri_surface frame;
        if (qtri_surface_init(&frame, show->format, show->width, show->height, 0, show->height,
                              memory, bytes) != QTRI_OK) {
            fail(scene, "no surface");
        }
        qtri_surface_clear(&frame, show->background);
        show->draw(scratch, &frame);
        take_picture(&frame, &expected);

        char path[1024];
        snprintf(path, sizeof path, "%s/%u-%s.ppm", argv[1], (unsigned)i, scene);
        write_ppm(path, &expected);
        long mismatches = 0;
        if (argc > 2) {
            snprintf(path, sizeof path, "%s/%u-%s.ppm", argv[2], (unsigned)i, scene);
            picture dump = read_ppm(path);
            mismatches = count_mismatches(&expected, &dump);
            free(dump.rgb);
        }
        all_mismatches += mismatches;
        printf("frame %u %s %ld %ld %ld\n", (unsigned)i, scene, (long)show->width * show->height,
               mismatches, count_drawn(&frame));
    }
    free(expected.rgb);
    free(scratch);
    free(memory);
    return all_mismatches != 0;
}
