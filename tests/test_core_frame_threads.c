/* SPDX-License-Identifier: MIT */
/*
 * Two cores: threads that draw alternate bands of one frame from shared data, each into memory of
 * its own. `make test-threads` runs it under the thread sanitizer.
 */
#define _POSIX_C_SOURCE 200112L

#include "support/core.h"
#include "support/layouts.h"

#include <pthread.h>

enum { WIDTH = 96, HEIGHT = 72, ROWS = 8, SIDE = 24, VERTICES = SIDE * SIDE };
enum { TRIANGLES = 2 * (SIDE - 1) * (SIDE - 1), THREADS = 2, FRAMES = 12 };

static qtri_vec3 positions[VERTICES];
static qtri_normal normals[VERTICES];
static qtri_vec2 uvs[VERTICES];
static uint16_t triangles[TRIANGLES][3];

static const qtri_texture checker = {.format = &qtri_texel_checker,
                                     .width_log2 = 5,
                                     .height_log2 = 5,
                                     .fields = 8,
                                     .color = {{255, 200, 40}, {20, 60, 200}}};
static const qtri_light sun = {
    .towards = {Q16(.4), Q16(.6), Q16(.7)}, .ambient = Q16(.2), .diffuse = Q16(.8)};
static const qtri_mesh mesh = {.positions = positions,
                               .normals = normals,
                               .uvs = uvs,
                               .triangles = (const uint16_t (*)[3])triangles,
                               .vertex_count = VERTICES,
                               .triangle_count = TRIANGLES};

/* A field of waves. */
static int make_waves(void **state)
{
    (void)state;
    int count = 0;
    for (int i = 0; i < VERTICES; i++) {
        const double x = 2.0 * (i % SIDE) / (SIDE - 1) - 1;
        const double y = 2.0 * (i / SIDE) / (SIDE - 1) - 1;
        positions[i] = vec3_of(x, y, .2 * sin(5 * x) * cos(4 * y));
        normals[i].x = (int16_t)lround(-11585 * cos(5 * x));
        normals[i].z = (int16_t)lround(sqrt(16384.0 * 16384.0 - normals[i].x * normals[i].x));
        uvs[i].x = fixed(x);
        uvs[i].y = fixed(y);
    }
    for (int i = 0; i < VERTICES - SIDE; i++) {
        if (i % SIDE != SIDE - 1) {
            const int corner[6] = {i, i + 1, i + SIDE + 1, i, i + SIDE + 1, i + SIDE};
            for (int k = 0; k < 6; k++) {
                triangles[count + k / 3][k % 3] = (uint16_t)corner[k];
            }
            count += 2;
        }
    }
    assert_int_equal(count, TRIANGLES);
    return 0;
}

typedef struct core {
    const qtri_prepared *prepared; /* shared */
    qtri_frame frame;
    uint8_t memory[QTRI_FRAME_BYTES_DOUBLE(WIDTH, ROWS, QTRI_RGB565_BYTES)];
    uint8_t *picture; /* of the whole frame: what the display would get */
} core;

static void *draw_bands(void *argument)
{
    core *c = argument;
    const qtri_rgb sky = {10, 20, 30};
    qtri_surface band;
    while (qtri_frame_next_band(&c->frame, &band)) {
        qtri_surface_clear(&band, sky);
        qtri_draw_prepared(&band, c->prepared);
        memcpy(c->picture + band.first_row * band.pitch, band.pixels,
               (size_t)(band.rows * band.pitch));
    }
    return NULL;
}

TEST(alternate_bands)
{
    static qtri_vertex vertices[VERTICES];
    static uint16_t lists[QTRI_PREPARED_LISTS(TRIANGLES, HEIGHT, ROWS)];
    static core cores[THREADS];
    const qtri_rgb sky = {10, 20, 30};
    for (int n = 0; n < FRAMES; n++) {
        qtri_view view;
        qtri_transform pose;
        qtri_prepared prepared;
        qtri_material material = qtri_material_default();
        material.cull = QTRI_CULL_NONE;
        material.shading = n % 3 == 2 ? QTRI_FLAT_LAST : QTRI_SMOOTH;
        material.fill = n % 5 == 4 ? &qtri_wireframe : NULL;
        material.texture = n % 2 != 0 ? &checker : NULL;
        qtri_view_init(&view, WIDTH, HEIGHT);
        view.light = &sun;
        qtri_transform_perspective(&view.projection, Q16(60), Q16(4.0 / 3.0), Q16(.5), Q16(20));
        const qtri_vec3 at = {0, 0, Q16(-.6) - Q16(.2) * n}; /* at first through the near plane */
        qtri_transform_identity(&pose);
        qtri_transform_translate(&pose, at);
        qtri_transform_rotate_x(&pose, Q16(-50));
        qtri_transform_rotate_z(&pose, Q16(33) * n);

        canvas whole = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
        qtri_surface_clear(&whole.surface, sky);
        qtri_draw_mesh(&whole.surface, &view, &pose, &mesh, &material);

        canvas shown = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
        prepared_init_with(&prepared, vertices, VERTICES, lists, n == 7 ? 0 : LENGTH_OF(lists));
        pthread_t thread[THREADS];
        for (int i = 0; i < THREADS; i++) {
            assert_ok(qtri_frame_init(&cores[i].frame, &qtri_rgb565, WIDTH, HEIGHT, ROWS,
                                      cores[i].memory, sizeof cores[i].memory));
            qtri_frame_share(&cores[i].frame, i, THREADS);
            cores[i].prepared = &prepared;
            cores[i].picture = shown.surface.pixels;
        }
        qtri_prepare_mesh(&prepared, &cores[0].frame, &view, &pose, &mesh, &material);
        for (int i = 0; i < THREADS; i++) {
            assert_int_equal(pthread_create(&thread[i], NULL, draw_bands, &cores[i]), 0);
        }
        for (int i = 0; i < THREADS; i++) {
            assert_int_equal(pthread_join(thread[i], NULL), 0);
        }
        assert_memory_equal(whole.surface.pixels, shown.surface.pixels,
                            (size_t)(whole.surface.pitch * HEIGHT));
        canvas_free(&whole);
        canvas_free(&shown);
    }
}

int main(void)
{
    return run_all_tests(make_waves, NULL);
}
