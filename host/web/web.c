/* SPDX-License-Identifier: MIT */
/*
 * What page.js calls: commands of `qtri` on files in memory, and a scene, drawn by the core, in
 * double precision, and as their difference.
 */
#include "web.h"

#include <math.h>
#include <stdio.h>

#include "../reference/reference.h"
#include "../reference/reference_picture.h"
#include "../tools/commands.h"
#include "../tools/compare.h"
#include "../tools/scene_cost.h"
#include "../tools/scene_draw.h"
#include "web_files.h"

static const struct {
    const qtri_format *core;
    enum reference_format reference;
    enum scene_pixels pixels;
} formats[] = {
    {&qtri_rgb565, REFERENCE_RGB565, SCENE_RGB565},
    {&qtri_xrgb8888, REFERENCE_RGB888, SCENE_XRGB8888},
    {&qtri_gray8, REFERENCE_GRAY8, SCENE_GRAY8},
};

static struct scene scene;
static struct scene_resources resources; /* of the scene; all zero where there is none */
static struct picture pictures[3];       /* core, double precision, difference: of one frame */
static struct web_figures figures;

static int complain(const char *what)
{
    fprintf(stderr, "%s\n", what);
    return 1;
}

int web_model(int argc, char **argv)
{
    const int status = options_run(&model_command, argc, argv);
    (void)fflush(stdout);
    return status;
}

int web_scene(const char *path)
{
    struct text_error error;
    scene_resources_free(&resources);
    scene_free(&scene);
    if (!scene_read(path, &scene, &error)) {
        return complain(error.message);
    }
    scene_resources_create(&resources, &scene);
    return 0;
}

/* Cameras go around what they look at. */
static void turn(int degrees)
{
    for (struct scene *pass = &scene; pass != NULL; pass = pass->next) {
        for (size_t i = 0; i < pass->op_count; i++) {
            if (pass->ops[i].kind == SCENE_ORBIT) {
                pass->ops[i].u.number[4] = degrees * 65536;
            }
        }
    }
}

static bool draw_exact(int format, struct picture *picture)
{
    struct reference_image image = {0};
    const bool ok = reference_render(&scene, 0, &image) &&
                    reference_picture(&image, formats[format].reference, picture);
    reference_free(&image);
    return ok;
}

const uint8_t *web_draw(enum web_picture what, int format, int rows, int degrees)
{
    struct picture *picture = &pictures[what];
    struct comparison comparison;
    bool ok = false;
    picture_free(picture);
    turn(degrees);
    switch (what) {
    case WEB_CORE:
        ok = scene_render_resources(&resources, formats[format].core, rows, false, picture);
        break;
    case WEB_DOUBLE:
        ok = draw_exact(format, picture);
        break;
    case WEB_DIFFERENCE:
        ok = compare_difference(&pictures[WEB_CORE], &pictures[WEB_DOUBLE], picture);
        compare_pictures(&pictures[WEB_CORE], &pictures[WEB_DOUBLE], &comparison);
        figures.differing = (double)comparison.differing;
        figures.largest_error = comparison.max_color_error;
        break;
    }
    return ok ? picture->rgb : NULL;
}

/* Covered pixels of a pass: those whose triangle is its. */
static double pixels_of(const struct scene *pass, const struct picture *picture)
{
    const size_t all = (size_t)picture->width * (size_t)picture->height;
    const uint32_t end = pass->next != NULL ? pass->next->triangles_before : scene.triangle_count;
    double pixels = 0;
    for (size_t i = 0; i < all; i++) {
        pixels += picture->id[i] > pass->triangles_before && picture->id[i] <= end;
    }
    return pixels;
}

/* The passes' sum, unless one is of no kind that is known. */
static void add_costs(int format, int rows, const struct picture *picture)
{
    struct scene_load load = {.format = formats[format].pixels,
                              .rows = rows > 0 && rows < scene.height ? rows : 0,
                              .screen = (double)scene.width * scene.height};
    bool is_known = true;
    figures.pixels = figures.m0plus = figures.m3 = figures.cost_error = 0;
    for (const struct scene *pass = &scene; pass != NULL; pass = pass->next) {
        const uint32_t end =
            pass->next != NULL ? pass->next->triangles_before : scene.triangle_count;
        is_known = scene_load_pass(&load, pass) && is_known;
        load.triangles = end - pass->triangles_before;
        load.pixels = pixels_of(pass, picture);
        const struct scene_cost cost = scene_cost(&load);
        figures.pixels += load.pixels;
        figures.m0plus += cost.m0plus;
        figures.m3 += cost.m3;
        figures.cost_error = fmax(figures.cost_error, cost.error);
        load.screen = 0; /* is cleared once */
    }
    if (!is_known) {
        figures.m0plus = figures.m3 = 0;
    }
}

const struct web_figures *web_count(int format, int rows, int degrees)
{
    static const size_t depth_bytes[] = {
        [SCENE_LINEAR16] = 2, [SCENE_FLOAT16] = 2, [SCENE_LINEAR24] = 3, [SCENE_LINEAR32] = 4};
    const int held = rows < 1 || rows > scene.height ? scene.height : rows;
    struct picture picture = {0};
    turn(degrees);
    if (!scene_render_resources(&resources, formats[format].core, rows, true, &picture)) {
        return NULL;
    }
    figures.triangles = scene.triangle_count;
    add_costs(format, rows, &picture);
    picture_free(&picture);
    figures.band_bytes = (double)QTRI_BAND_BYTES_DEPTH(
        scene.width, held, formats[format].core->pixels->bytes, depth_bytes[scene.depth_format]);
    return &figures;
}
