/* SPDX-License-Identifier: MIT */
#include "scene_draw.h"

#include <stdlib.h>

/* Draws the rows of one band and copies them to the picture. */
static void render_band(const struct scene_resources *resources, const qtri_surface *surface,
                        enum scene_pass pass, struct picture *picture)
{
    scene_draw(resources, surface, pass);
    for (int32_t y = surface->first_row; y < surface->first_row + surface->rows; y++) {
        for (int32_t x = 0; x < picture->width; x++) {
            size_t at = (size_t)y * (size_t)picture->width + (size_t)x;
            qtri_rgb rgb = qtri_surface_pixel(surface, x, y);
            if (pass == SCENE_IDS) {
                ptrdiff_t row = y - surface->first_row;
                picture->id[at] = (uint32_t)rgb.r << 16 | (uint32_t)rgb.g << 8 | rgb.b;
                picture->depth[at] = surface->depth[row * surface->depth_pitch + x] / 65535.0;
            } else {
                picture->rgb[3 * at] = rgb.r;
                picture->rgb[3 * at + 1] = rgb.g;
                picture->rgb[3 * at + 2] = rgb.b;
            }
        }
    }
}

static bool render_pass(const struct scene_resources *resources, const qtri_format *format,
                        int32_t rows, enum scene_pass pass, struct picture *picture)
{
    size_t bytes = QTRI_BAND_BYTES(picture->width, rows, format->pixels->bytes);
    void *memory = malloc(bytes);
    if (memory == NULL) {
        return false;
    }
    for (int32_t first = 0; first < picture->height; first += rows) {
        qtri_surface surface;
        if (qtri_surface_init(&surface, format, picture->width, picture->height, first, rows,
                              memory, bytes) != QTRI_OK) {
            abort(); /* the scene reader keeps sizes within the core's range */
        }
        render_band(resources, &surface, pass, picture);
    }
    free(memory);
    return true;
}

bool scene_render(const struct scene *scene, const qtri_format *format, int32_t rows,
                  bool with_dump, struct picture *picture)
{
    struct scene_resources resources;
    if (!scene_resources_create(&resources, scene)) {
        return false;
    }
    if (!picture_create(picture, scene->width, scene->height, with_dump)) {
        scene_resources_free(&resources);
        return false;
    }
    rows = rows < 1 || rows > scene->height ? scene->height : rows;
    bool ok = render_pass(&resources, format, rows, SCENE_COLORS, picture) &&
              (!with_dump || render_pass(&resources, &qtri_xrgb8888, rows, SCENE_IDS, picture));
    scene_resources_free(&resources);
    if (!ok) {
        picture_free(picture);
    }
    return ok;
}
