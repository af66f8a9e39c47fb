/* SPDX-License-Identifier: MIT */
/*
 * Arbitrary bytes as views, poses, materials, meshes and screen vertices: nothing may trap,
 * overflow or write outside the surface. `make fuzz` runs it under AddressSanitizer and UBSan.
 */
#include "support/fuzz_input.h"

enum { SIDE = 40, CORNERS = 9, CACHE = 16 };

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const uint32_t texels[64] = {0xFF00FFu, 0x123456u, 0xFFFFFFu};
    struct reader reader = {data, size};
    struct reader *r = &reader;
    const qtri_format *format = surface_formats[take_byte(r) % 6];
    int32_t first = take_byte(r) % SIDE;
    int32_t rows = 1 + take_byte(r) % SIDE;
    size_t bytes = QTRI_BAND_BYTES(SIDE, rows, format->pixels->bytes);
    uint8_t *memory = malloc(bytes); /* exactly as large: AddressSanitizer watches its ends */
    qtri_surface surface;
    if (memory == NULL ||
        qtri_surface_init(&surface, format, SIDE, SIDE, first, rows, memory, bytes) != QTRI_OK) {
        abort();
    }
    if (take_byte(r) % 4 == 0) {
        take(r, &surface.scissor, sizeof surface.scissor);
    }
    qtri_rgb sky = {1, 2, 3};
    qtri_surface_clear(&surface, sky);

    qtri_view view;
    qtri_vertex cache[CACHE];
    qtri_light light;
    lamps lamps;
    qtri_transform pose;
    qtri_texture texture;
    const void *levels[4];
    qtri_corner corners[CORNERS];
    qtri_screen_vertex screen[3];
    soup soup;
    qtri_view_init(&view, SIDE, SIDE);
    build_transform(r, &view.projection);
    build_transform(r, &view.camera);
    build_transform(r, &pose);
    if (take_byte(r) % 4 == 0) {
        take(r, &view.viewport, sizeof view.viewport);
    }
    take(r, &light, sizeof light);
    view.light = take_byte(r) % 2 ? &light : NULL;
    view.lights = take_byte(r) % 2 ? build_lamps(r, &lamps) : NULL;
    view.vertices = cache;
    view.vertex_count = take_byte(r) % (CACHE + 1);
    qtri_material material = build_material(r, &texture, levels, texels);
    material.reflection = view.lights != NULL ? &lamps.reflection : NULL;

    switch (take_byte(r) % 4) {
    case 0:
        qtri_draw_mesh(&surface, &view, &pose, build_mesh(r, &soup), &material);
        break;
    case 1:
        for (int i = 0; i < CORNERS; i++) {
            qtri_vec3 p = take_vec3(r);
            qtri_vec4 position = {p.x, p.y, p.z, take_byte(r) % 4 ? Q16_ONE : take_number(r)};
            corners[i].position = position;
            take(r, &corners[i].color, sizeof corners[i].color);
            take(r, &corners[i].uv, sizeof corners[i].uv);
        }
        qtri_draw_triangles(&surface, &view, &pose, corners, CORNERS, &material);
        qtri_draw_lit_triangles(&surface, &view, &pose, corners, NULL, CORNERS, &material);
        qtri_draw_lines(&surface, &view, &pose, corners, CORNERS, &material);
        break;
    default:
        take(r, screen, sizeof screen);
        for (int i = 0; i < 3 && take_byte(r) % 2; i++) {
            screen[i].x_24p8 >>= 16;
            screen[i].y_24p8 >>= 16;
        }
        qtri_raster_triangle(&surface, &material, screen);
        qtri_raster_line(&surface, &material, screen);
        break;
    }
    free(memory);
    return 0;
}
