/* SPDX-License-Identifier: MIT */
/*
 * What was found by attack: arguments at their extremes, objects whose initialisation failed, and
 * limits that no picture of the other tests depends on. Most of them fail by a sanitizer's word.
 */
#include "support/core.h"
#include "support/layouts.h"

enum { SIDE = 32 };

static const qtri_rgb red = {255, 0, 0};

static const qtri_vec3 corner_positions[3] = {
    {Q16(-1), Q16(-1), 0}, {Q16(1), Q16(-1), 0}, {Q16(0), Q16(1), 0}};
static const uint16_t one_triangle[1][3] = {{0, 1, 2}};

static const qtri_mesh one = {.positions = corner_positions,
                              .triangles = one_triangle,
                              .vertex_count = 3,
                              .triangle_count = 1,
                              .bounds = {{0, 0, 0}, {Q16(1), Q16(1), Q16(1)}}};

/* first_row + rows, and a frame's and a scissor's end plus one, beyond 32 bits. */
TEST(surfaces_without_end)
{
    static const int32_t extremes[] = {INT32_MIN, -1, 0, 1, SIDE, INT32_MAX - 1, INT32_MAX};
    canvas wanted = canvas_new(&qtri_rgb565, SIDE, SIDE);
    qtri_view view;
    qtri_transform pose;
    const qtri_material material = plain_material();
    start_view(&view, &pose, SIDE, SIDE);
    qtri_draw_mesh(&wanted.surface, &view, &pose, &one, &material);
    assert_true(count_painted(&wanted.surface) > SIDE * SIDE / 4);
    for (size_t i = 0; i < LENGTH_OF(extremes) * LENGTH_OF(extremes); i++) {
        const int32_t end = extremes[i % LENGTH_OF(extremes)];
        canvas c = canvas_new(&qtri_rgb565, SIDE, SIDE);
        qtri_surface s = c.surface;
        s.rows = extremes[i / LENGTH_OF(extremes)];
        s.scissor.x1 = end;
        s.scissor.y1 = end;
        qtri_draw_mesh(&s, &view, &pose, &one, &material);
        if (s.rows >= SIDE && end >= SIDE) {
            assert_same_picture(&wanted.surface, &c.surface);
        }
        if (s.rows <= 0 || end <= 0) {
            assert_int_equal(count_painted(&c.surface), 0);
        }
        s = c.surface; /* rows that end beyond 32 bits, not one of them in memory */
        s.first_row = SIDE;
        s.rows = INT32_MAX;
        qtri_draw_mesh(&s, &view, &pose, &one, &material);
        canvas_free(&c);
    }
    /* A frame has no such sides: they count as the largest, so that this scissor is outside. */
    qtri_surface s = wanted.surface;
    s.width = s.height = s.rows = INT32_MAX;
    s.scissor.x0 = s.scissor.y0 = INT32_MAX - 1;
    s.scissor.x1 = s.scissor.y1 = INT32_MAX;
    qtri_draw_mesh(&s, &view, &pose, &one, &material);
    canvas_free(&wanted);
}

/* Rows of zeros may have any exponent: they are zeros, and say nothing of the other rows. */
TEST(rows_of_zeros)
{
    static const int32_t exponents[] = {INT32_MIN, INT32_MIN + 1, -4097,    -16, -1, 0,
                                        16,        4097,          INT32_MAX};
    canvas wanted = canvas_new(&qtri_rgb565, SIDE, SIDE);
    qtri_view view;
    qtri_transform pose;
    const qtri_material material = plain_material();
    start_view(&view, &pose, SIDE, SIDE);
    qtri_draw_mesh(&wanted.surface, &view, &pose, &one, &material);
    for (size_t i = 0; i < LENGTH_OF(exponents); i++) {
        for (unsigned rows = 1; rows < 16; rows++) {
            for (int which = 0; which < 3; which++) {
                canvas c = canvas_new(&qtri_rgb565, SIDE, SIDE);
                qtri_view zeroed = view;
                qtri_transform posed = pose;
                qtri_transform *const changed[3] = {&posed, &zeroed.camera, &zeroed.projection};
                for (int row = 0; row < 4; row++) {
                    const qtri_row zero = {.exponent = exponents[i]};
                    if ((rows >> row & 1) != 0) {
                        changed[which]->row[row] = zero;
                    }
                }
                qtri_draw_mesh(&c.surface, &zeroed, &posed, &one, &material);
                if (rows == 4) { /* z alone: flat, in the middle of the depths */
                    assert_same_picture(&wanted.surface, &c.surface);
                } else if ((rows & 8) != 0) {
                    assert_int_equal(count_painted(&c.surface), 0); /* w = 0 */
                }
                canvas_free(&c);
            }
        }
    }
    canvas_free(&wanted);
}

/* All zero: no arrays to count from. */
TEST(zero_meshes)
{
    static const qtri_mesh zero;
    static qtri_vertex vertices[4];
    canvas c = canvas_new(&qtri_rgb565, SIDE, SIDE);
    qtri_view view;
    qtri_transform pose;
    qtri_frame frame;
    qtri_prepared prepared;
    start_view(&view, &pose, SIDE, SIDE);
    assert_ok(qtri_frame_init(&frame, &qtri_rgb565, SIDE, SIDE, SIDE, c.memory, c.bytes));
    static const qtri_fill *const fills[] = {NULL, &qtri_wireframe};
    for (int n = 0; n < 24; n++) {
        qtri_mesh mesh = zero;
        mesh.triangles = n / 2 % 3 == 1 ? one_triangle : NULL; /* with indices, without vertices */
        mesh.triangle_count = n / 2 % 3 == 1;
        mesh.vertex_count = n / 2 % 3 == 2 ? 3 : 0; /* the other way round */
        mesh.positions = n / 2 % 3 == 2 ? corner_positions : NULL;
        mesh.faces.culling = n / 6 % 2 != 0 ? &qtri_cull_by_planes : NULL;
        qtri_material material = plain_material();
        material.fill = fills[n % 2];
        give_vertices(&view, n / 12 != 0 ? vertices : NULL, n / 12 != 0 ? 4 : 0);
        qtri_draw_mesh(&c.surface, &view, &pose, &mesh, &material);
        prepared_init_with(&prepared, view.vertices, view.vertex_count, NULL, 0);
        qtri_prepare_mesh(&prepared, &frame, &view, &pose, &mesh, &material);
        qtri_draw_prepared(&c.surface, &prepared);
        qtri_prepared_mark(&prepared, &frame);
    }
    qtri_material material = plain_material();
    qtri_draw_triangles(&c.surface, &view, &pose, NULL, 0, &material);
    qtri_draw_lines(&c.surface, &view, &pose, NULL, 0, &material);
    assert_int_equal(count_painted(&c.surface), 0);
    canvas_free(&c);
}

/* Fewer slots than vertices, in memory that nobody has written: MemorySanitizer's. */
TEST(slots_never_written)
{
    for (uint32_t slots = 1; slots <= 3; slots++) {
        canvas c = canvas_new(&qtri_rgb565, SIDE, SIDE);
        qtri_vertex *vertices = malloc(slots * sizeof *vertices);
        assert_non_null(vertices);
        qtri_view view;
        qtri_transform pose;
        const qtri_material material = plain_material();
        start_view(&view, &pose, SIDE, SIDE);
        give_vertices(&view, vertices, slots);
        qtri_draw_mesh(&c.surface, &view, &pose, &one, &material);
        assert_true(count_painted(&c.surface) > SIDE * SIDE / 4);
        free(vertices);
        canvas_free(&c);
    }
}

/* Draws, clears and reads what must be as if it were not there. */
static void assert_inert(const qtri_surface *s, const uint8_t *memory, size_t bytes)
{
    qtri_view view;
    qtri_transform pose;
    const qtri_material material = plain_material();
    const qtri_corner corners[3] = {{{Q16(-1), Q16(-1), 0, Q16_ONE}, {255, 255, 255}, {0, 0}},
                                    {{Q16(3), Q16(-1), 0, Q16_ONE}, {255, 255, 255}, {0, 0}},
                                    {{Q16(-1), Q16(3), 0, Q16_ONE}, {255, 255, 255}, {0, 0}}};
    const qtri_screen_vertex screen[3] = {screen_at(0, 0), screen_at(9999, 0), screen_at(0, 9999)};
    start_view(&view, &pose, SIDE, SIDE);
    clear_to(s, red, 0);
    qtri_draw_mesh(s, &view, &pose, &one, &material);
    qtri_draw_triangles(s, &view, &pose, corners, 3, &material);
    qtri_draw_lines(s, &view, &pose, corners, 2, &material);
    qtri_raster_triangle(s, qtri_pipelines_default, &material, screen);
    qtri_raster_line(s, &material, screen);
    const qtri_rgb pixel = qtri_surface_pixel(s, 0, 0);
    assert_int_equal(pixel.r | pixel.g | pixel.b, 0);
    const qtri_rect bounds = qtri_surface_bounds(s);
    assert_int_equal(bounds.x0 | bounds.y0 | bounds.x1 | bounds.y1, 0);
    for (size_t i = 0; i < bytes; i++) {
        assert_int_equal(memory[i], 0xA5);
    }
}

/* One that could be drawn on before its new initialisation failed. */
TEST(failed_surfaces)
{
    static uint8_t memory[QTRI_BAND_BYTES(SIDE, SIDE, QTRI_RGB565_BYTES)];
    const struct {
        const qtri_format *format;
        void *memory;
        size_t bytes;
        int32_t width, first_row, rows;
        enum qtri_error error;
    } cases[] = {
        {&qtri_rgb565, memory, sizeof memory, 0, 0, SIDE, QTRI_ERROR_SIZE},
        {&qtri_rgb565, memory, sizeof memory, SIDE, SIDE, SIDE, QTRI_ERROR_SIZE},
        {&qtri_rgb565, memory, sizeof memory, SIDE, 0, QTRI_SURFACE_MAX + 1, QTRI_ERROR_SIZE},
        {NULL, memory, sizeof memory, SIDE, 0, SIDE, QTRI_ERROR_FORMAT},
        {&qtri_rgb565, memory, sizeof memory - 1, SIDE, 0, SIDE, QTRI_ERROR_MEMORY},
        {&qtri_rgb565, memory, 0, SIDE, 0, SIDE, QTRI_ERROR_MEMORY},
        {&qtri_rgb565, NULL, sizeof memory, SIDE, 0, SIDE, QTRI_ERROR_MEMORY},
        {&qtri_rgb565, NULL, SIZE_MAX, SIDE, 0, SIDE, QTRI_ERROR_MEMORY},
    };
    memset(memory, 0xA5, sizeof memory);
    for (size_t i = 0; i < LENGTH_OF(cases); i++) {
        qtri_surface s;
        assert_ok(qtri_surface_init(&s, &qtri_rgb565, SIDE, SIDE, 0, SIDE, memory, sizeof memory));
        assert_int_equal(qtri_surface_init(&s, cases[i].format, cases[i].width, SIDE,
                                           cases[i].first_row, cases[i].rows, cases[i].memory,
                                           cases[i].bytes),
                         cases[i].error);
        assert_inert(&s, memory, sizeof memory);
    }
}

/* The same of frames: no band, no change, and nothing of what is prepared for them. */
TEST(failed_frames)
{
    static uint8_t memory[QTRI_FRAME_BYTES(SIDE, SIDE, QTRI_RGB565_BYTES)];
    const struct {
        const qtri_format *format;
        void *memory;
        size_t bytes;
        int32_t rows;
        enum qtri_error error;
    } cases[] = {
        {&qtri_rgb565, memory, sizeof memory, 0, QTRI_ERROR_SIZE},
        {NULL, memory, sizeof memory, SIDE, QTRI_ERROR_FORMAT},
        {&qtri_rgb565, memory, sizeof memory - 1, SIDE, QTRI_ERROR_MEMORY},
        {&qtri_rgb565, NULL, sizeof memory, SIDE, QTRI_ERROR_MEMORY},
        {&qtri_rgb565, NULL, SIZE_MAX, SIDE, QTRI_ERROR_MEMORY},
    };
    static qtri_vertex vertices[3];
    static uint16_t lists[64];
    qtri_view view;
    qtri_transform pose;
    const qtri_material material = plain_material();
    start_view(&view, &pose, SIDE, SIDE);
    memset(memory, 0xA5, sizeof memory);
    for (size_t i = 0; i < LENGTH_OF(cases); i++) {
        qtri_frame frame;
        qtri_surface band = {0};
        qtri_prepared prepared;
        const qtri_rect all = {0, 0, SIDE, SIDE};
        assert_ok(qtri_frame_init(&frame, &qtri_rgb565, SIDE, SIDE, SIDE, memory, sizeof memory));
        assert_int_equal(qtri_frame_init(&frame, cases[i].format, SIDE, SIDE, cases[i].rows,
                                         cases[i].memory, cases[i].bytes),
                         cases[i].error);
        qtri_frame_mark(&frame, &all);
        qtri_frame_mark_all(&frame);
        qtri_frame_share(&frame, 1, 2);
        prepared_init_with(&prepared, vertices, 3, lists, LENGTH_OF(lists));
        qtri_prepare_mesh(&prepared, &frame, &view, &pose, &one, &material);
        qtri_prepared_mark(&prepared, &frame);
        assert_int_equal(qtri_frame_changes(&frame).x1, 0);
        assert_false(qtri_frame_next_band(&frame, &band));
        assert_inert(&band, memory, sizeof memory);
    }
}

/* Memory that is not there, however large it is said to be: as too little of it. */
TEST(missing_memory)
{
    canvas c = canvas_new(&qtri_rgb565, SIDE, SIDE);
    qtri_outline outline;
    assert_int_equal(qtri_fxaa(&c.surface, NULL, UINT32_MAX), QTRI_ERROR_MEMORY);
    assert_int_equal(qtri_sum_add(NULL, UINT32_MAX, &c.surface), QTRI_ERROR_MEMORY);
    assert_int_equal(qtri_sum_store(&c.surface, NULL, UINT32_MAX, 1), QTRI_ERROR_MEMORY);
    assert_int_equal(qtri_outline_init(&outline, &one, NULL, UINT32_MAX), QTRI_ERROR_MEMORY);
    assert_null(outline.mesh);
    assert_int_equal(count_painted(&c.surface), 0);
    canvas_free(&c);
}

/* ---- Textures of any size ---- */

enum { TEXELS_MAX = 1024 * 1024 };

static uint16_t texel_at(int32_t column, int32_t row)
{
    return (uint16_t)(((uint32_t)column * 40503u + (uint32_t)row * 30011u) >> 3);
}

/*
 * A texel to a pixel, the nearest, repeated, as it is: of textures of up to 2^16 texels a mask cuts
 * the row out of 32 bits; it must leave larger ones alone (qtri_texel_row in body/texel.h).
 */
TEST(any_texture_as_it_is)
{
    static uint16_t texels[TEXELS_MAX];
    canvas c = canvas_new(&qtri_rgb565, SIDE, SIDE);
    for (int32_t n = 0; n < 11 * 11; n++) {
        const int32_t width_log2 = n % 11;
        const int32_t height_log2 = n / 11;
        const int32_t columns = (int32_t)1 << width_log2;
        const int32_t rows = (int32_t)1 << height_log2;
        for (int32_t i = 0; i < columns * rows; i++) {
            texels[i] = texel_at(i % columns, i / columns);
        }
        const qtri_texture texture = {.texels = texels,
                                      .format = &qtri_texel_rgb565,
                                      .width_log2 = (uint8_t)width_log2,
                                      .height_log2 = (uint8_t)height_log2};
        qtri_material material = plain_material();
        material.texture = &texture;
        material.texture_mode = QTRI_REPLACE;
        /* From near the texture's end on, so that it repeats, and from its middle on. */
        const int32_t first_column = n % 2 != 0 ? columns / 2 : columns - 5;
        const int32_t first_row = n % 3 != 0 ? rows / 2 : rows - 7;
        qtri_screen_vertex v[4];
        for (int i = 0; i < 4; i++) {
            const int32_t x = i % 2 * SIDE;
            const int32_t y = i / 2 * SIDE;
            v[i] = screen_at(x * 256, y * 256);
            v[i].u_q32 = (int64_t)(first_column + x) * ((int64_t)1 << (32 - width_log2));
            v[i].v_q32 = (int64_t)(first_row + y) * ((int64_t)1 << (32 - height_log2));
        }
        const qtri_screen_vertex first[3] = {v[0], v[1], v[2]};
        const qtri_screen_vertex second[3] = {v[2], v[1], v[3]};
        qtri_raster_triangle(&c.surface, qtri_pipelines_default, &material, first);
        qtri_raster_triangle(&c.surface, qtri_pipelines_default, &material, second);
        for (int32_t i = 0; i < SIDE * SIDE; i++) {
            const int32_t column = (first_column + i % SIDE) & (columns - 1);
            const int32_t row = (first_row + i / SIDE) & (rows - 1);
            if (stored_pixel(&c.surface, i % SIDE, i / SIDE) != texel_at(column, row)) {
                fail_msg("%dx%d: pixel %d,%d is not texel %d,%d", (int)columns, (int)rows,
                         (int)(i % SIDE), (int)(i / SIDE), (int)column, (int)row);
            }
        }
    }
    canvas_free(&c);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
