/* SPDX-License-Identifier: MIT */
#include "draw_bytes.h"

#include "core.h"
#include "fuzz_input.h"
#include "recorded.h"

enum { SIDE = 40, CORNERS = 9, CACHE = 16 };

static void draw_corners(struct reader *r, const qtri_surface *surface, const qtri_view *view,
                         const qtri_transform *pose, const qtri_material *material)
{
    qtri_corner corners[CORNERS];
    for (int i = 0; i < CORNERS; i++) {
        const qtri_vec3 p = take_vec3(r);
        const qtri_vec4 position = {p.x, p.y, p.z, take_byte(r) % 4 ? Q16_ONE : take_number(r)};
        corners[i].position = position;
        take(r, &corners[i].color, sizeof corners[i].color);
        corners[i].uv.x = take_int(r);
        corners[i].uv.y = take_int(r);
    }
    qtri_draw_triangles(surface, view, pose, corners, CORNERS, material);
    qtri_draw_lit_triangles(surface, view, pose, corners, NULL, CORNERS, material);
    qtri_draw_lines(surface, view, pose, corners, CORNERS, material);
}

static void draw_screen(struct reader *r, const qtri_surface *surface,
                        const qtri_pipeline *const *pipelines, const qtri_material *material)
{
    qtri_screen_vertex screen[3];
    for (int i = 0; i < 3; i++) {
        screen[i].x_24p8 = take_int(r);
        screen[i].y_24p8 = take_int(r);
        screen[i].depth_16p16 = take_bits(r);
        screen[i].inv_w_q31 = take_bits(r);
        screen[i].inv_w_exponent = take_int(r);
        take_ints(r, screen[i].color_8p16, 3);
        screen[i].u_q32 = take_long(r);
        screen[i].v_q32 = take_long(r);
    }
    for (int i = 0; i < 3 && take_byte(r) % 2; i++) {
        screen[i].x_24p8 >>= 16;
        screen[i].y_24p8 >>= 16;
    }
    qtri_raster_triangle(surface, pipelines, material, screen);
    qtri_raster_line(surface, material, screen);
}

/* Draws on a surface, with what the rest of the bytes say. */
static void draw_on(struct reader *r, const qtri_surface *surface,
                    const qtri_pipeline *const *pipelines)
{
    static const uint32_t texels[64] = {0xFF00FFu, 0x123456u, 0xFFFFFFu};
    qtri_view view;
    qtri_vertex cache[CACHE];
    qtri_light light = {.ambient = 0};
    lamps lit;
    qtri_transform pose;
    qtri_texture texture = {0};
    const void *levels[4];
    soup arrays;
    qtri_view_init(&view, SIDE, SIDE);
    view.pipelines = pipelines;
    build_transform(r, &view.projection);
    build_transform(r, &view.camera);
    build_transform(r, &pose);
    if (take_byte(r) % 4 == 0) {
        view.viewport.x = take_int(r);
        view.viewport.y = take_int(r);
        view.viewport.width = take_int(r);
        view.viewport.height = take_int(r);
        view.viewport.depth_near = take_int(r);
        view.viewport.depth_far = take_int(r);
    }
    light.towards = take_any_vec3(r);
    light.ambient = take_int(r);
    light.diffuse = take_int(r);
    view.light = take_byte(r) % 2 ? &light : NULL;
    if (take_byte(r) % 2) {
        view.light = build_lamps(r, &lit);
    }
    view.vertices = cache;
    view.vertex_count = take_byte(r) % (CACHE + 1);
    qtri_material material = build_material(r, &texture, levels, texels);
    material.reflection = view.light != NULL && view.light->model != NULL ? &lit.reflection : NULL;

    switch (take_byte(r) % 4) {
    case 0:
        qtri_draw_mesh(surface, &view, &pose, build_mesh(r, &arrays), &material);
        break;
    case 1:
        draw_corners(r, surface, &view, &pose, &material);
        break;
    default:
        draw_screen(r, surface, pipelines, &material);
        break;
    }
}

static uint32_t checksum(const qtri_surface *s)
{
    const int bytes = s->format->pixels->bytes;
    uint32_t hash = RECORDED_BEGIN;
    for (int32_t y = 0; y < s->rows; y++) {
        for (int32_t x = 0; x < s->width; x++) {
            hash = recorded_add(hash, stored_pixel(s, x, y + s->first_row), bytes);
            hash = recorded_add(hash, stored_depth(s, x, y + s->first_row), 2);
        }
    }
    return hash;
}

uint32_t draw_bytes(const uint8_t *data, size_t size, const qtri_pipeline *const *pipelines)
{
    const qtri_rgb sky = {1, 2, 3};
    struct reader reader = {data, size};
    struct reader *r = &reader;
    const qtri_format *format = surface_formats[take_byte(r) % 6];
    const int32_t first = take_byte(r) % SIDE;
    const int32_t rows = 1 + take_byte(r) % SIDE;
    const size_t bytes = QTRI_BAND_BYTES(SIDE, rows, format->pixels->bytes);
    uint8_t *memory = calloc(1, bytes); /* exactly as large: AddressSanitizer watches its ends */
    qtri_surface surface;
    if (memory == NULL ||
        qtri_surface_init(&surface, format, SIDE, SIDE, first, rows, memory, bytes) != QTRI_OK) {
        abort();
    }
    if (take_byte(r) % 4 == 0) {
        surface.scissor.x0 = take_int(r);
        surface.scissor.y0 = take_int(r);
        surface.scissor.x1 = take_int(r);
        surface.scissor.y1 = take_int(r);
    }
    qtri_surface_clear(&surface, sky);
    draw_on(r, &surface, pipelines);
    const uint32_t hash = checksum(&surface);
    free(memory);
    return hash;
}
