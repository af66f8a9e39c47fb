/* SPDX-License-Identifier: MIT */
/*
 * Frames in bands and prepared meshes: the pixels of the whole frame, whatever the height of the
 * bands, their order and the memory there is; and what a frame says has changed.
 */
#include "support/core.h"
#include "support/layouts.h"

enum { WIDTH = 56, HEIGHT = 44, RINGS = 12, SIDES = 9, VERTICES = RINGS * SIDES };
enum { TRIANGLES = 2 * VERTICES, EXTRA = 3, LISTS = 4000 };

static const qtri_format *const formats[3] = {&qtri_rgb565, &qtri_xrgb8888, &qtri_gray8};
static const qtri_rgb sky = {10, 20, 30};

/* ---- A torus with everything a mesh can bring, and some triangles that are none ---- */

static qtri_vec3 positions[VERTICES];
static qtri_normal normals[VERTICES];
static qtri_vec2 uvs[VERTICES];
static qtri_rgb colors[VERTICES];
static qtri_position16 positions16[VERTICES];
static qtri_normal8 normals8[VERTICES];
static uint16_t triangles[TRIANGLES + EXTRA][3];
static uint8_t triangles8[TRIANGLES + EXTRA][3];

static const qtri_texture checker = {.format = &qtri_texel_checker,
                                     .width_log2 = 5,
                                     .height_log2 = 5,
                                     .fields = 6,
                                     .color = {{255, 200, 40}, {20, 60, 200}}};
static const qtri_light sun = {
    .towards = {Q16(.4), Q16(.6), Q16(.7)}, .ambient = Q16(.2), .diffuse = Q16(.8)};

static int make_torus(void **state)
{
    (void)state;
    const double turn = 2 * 3.14159265358979;
    for (int i = 0; i < VERTICES; i++) {
        double a = turn * (i / SIDES) / RINGS;
        double b = turn * (i % SIDES) / SIDES;
        double n[3] = {cos(b) * cos(a), cos(b) * sin(a), sin(b)};
        double p[3] = {(1 + .45 * cos(b)) * cos(a), (1 + .45 * cos(b)) * sin(a), .45 * sin(b)};
        positions[i] = vec3_of(p[0], p[1], p[2]);
        normals[i].x = (int16_t)lround(16384 * n[0]);
        normals[i].y = (int16_t)lround(16384 * n[1]);
        normals[i].z = (int16_t)lround(16384 * n[2]);
        normals8[i].x = (int8_t)lround(127 * n[0]);
        normals8[i].y = (int8_t)lround(127 * n[1]);
        normals8[i].z = (int8_t)lround(127 * n[2]);
        positions16[i].x = (int16_t)lround(p[0] * 16384);
        positions16[i].y = (int16_t)lround(p[1] * 16384);
        positions16[i].z = (int16_t)lround(p[2] * 16384);
        uvs[i].x = fixed(4.0 * (i / SIDES) / RINGS);
        uvs[i].y = fixed(2.0 * (i % SIDES) / SIDES);
        colors[i].r = (uint8_t)(37 * i);
        colors[i].g = (uint8_t)(91 * i);
        colors[i].b = (uint8_t)(153 * i);
    }
    for (int i = 0; i < VERTICES; i++) {
        int right = (i + SIDES) % VERTICES;
        int up = i / SIDES * SIDES + (i + 1) % SIDES;
        int both = right / SIDES * SIDES + up % SIDES;
        const int corner[6] = {i, right, both, i, both, up};
        for (int k = 0; k < 6; k++) {
            triangles[2 * i + k / 3][k % 3] = (uint16_t)corner[k];
        }
    }
    const uint16_t extra[EXTRA][3] = {{3, VERTICES, 4}, {5, 5, 6}, {0, 40, 80}};
    memcpy(triangles[TRIANGLES], extra, sizeof extra);
    for (int i = 0; i < TRIANGLES + EXTRA; i++) {
        for (int k = 0; k < 3; k++) {
            triangles8[i][k] = (uint8_t)triangles[i][k];
        }
    }
    return 0;
}

typedef struct scene {
    qtri_mesh mesh;
    qtri_view view;
    qtri_transform pose;
    qtri_material material;
} scene;

static void random_scene(scene *s, uint64_t *seed)
{
    const qtri_mesh wide = {.positions = positions,
                            .triangles = (const uint16_t(*)[3])triangles,
                            .vertex_count = VERTICES,
                            .triangle_count = TRIANGLES + EXTRA};
    s->mesh = wide;
    s->mesh.normals = random_flag(seed) ? normals : NULL;
    s->mesh.uvs = random_flag(seed) ? uvs : NULL;
    s->mesh.colors = random_flag(seed) ? colors : NULL;
    s->mesh.triangles8 = random_flag(seed) ? (const uint8_t(*)[3])triangles8 : NULL;
    if (random_flag(seed)) {
        s->mesh.positions16 = positions16;
        s->mesh.extent = Q16(2);
        s->mesh.normals8 = s->mesh.normals != NULL ? normals8 : NULL;
    }
    s->material = qtri_material_default();
    s->material.color.g = (uint8_t)random64(seed);
    s->material.shading = shading_of((int)(random_in(seed, 0, 5) / 2));
    s->material.interpolation = (qtri_interpolation)random_in(seed, 0, 1);
    s->material.texture = random_flag(seed) ? &checker : NULL;
    s->material.cull = (qtri_cull)(random_in(seed, 1, 7) % 3);
    s->material.fill = random_in(seed, 0, 3) == 0 ? &qtri_wireframe : NULL;
    s->material.depth_compare = (qtri_compare)(random_flag(seed) ? 2 : random_in(seed, 0, 8));

    qtri_view_init(&s->view, WIDTH, HEIGHT);
    qtri_transform_perspective(&s->view.projection, Q16(60), Q16(1.3), Q16(.5), Q16(30));
    s->view.light = random_flag(seed) ? &sun : NULL;
    /* From inside, cut by the near plane, to far away; partly outside of the picture. */
    int32_t away = random_in(seed, 0, 3) == 0 ? Q16(1) : Q16(6);
    qtri_vec3 at = {random_in(seed, Q16(-1.5), Q16(1.5)), random_in(seed, Q16(-1.5), Q16(1.5)),
                    -random_in(seed, 0, away)};
    qtri_transform_identity(&s->pose);
    qtri_transform_translate(&s->pose, at);
    qtri_transform_rotate_x(&s->pose, random_in(seed, 0, Q16(360)));
    qtri_transform_rotate_y(&s->pose, random_in(seed, 0, Q16(360)));
}

static void draw_whole(const qtri_surface *surface, scene *s)
{
    static qtri_vertex vertices[VERTICES];
    give_vertices(&s->view, vertices, VERTICES);
    qtri_surface_clear(surface, sky);
    qtri_draw_mesh(surface, &s->view, &s->pose, &s->mesh, &s->material);
}

/* ---- The same pixels ---- */

static uint8_t band_memory[QTRI_FRAME_BYTES_DOUBLE(WIDTH, HEIGHT, QTRI_XRGB8888_BYTES)];
static qtri_vertex vertex_memory[VERTICES];
static uint16_t list_memory[LISTS];

TEST(heights)
{
    uint64_t seed = 71;
    for (int n = 0; n < 60; n++) {
        static scene s;
        random_scene(&s, &seed);
        const qtri_format *format = formats[n % 3];
        canvas whole = canvas_new(format, WIDTH, HEIGHT);
        draw_whole(&whole.surface, &s);
        for (int32_t rows = 1; rows <= HEIGHT; rows++) {
            qtri_frame frame;
            qtri_prepared prepared;
            const bool two = random_flag(&seed);
            const size_t bytes = two ? QTRI_FRAME_BYTES_DOUBLE(WIDTH, rows, format->pixels->bytes)
                                     : QTRI_FRAME_BYTES(WIDTH, rows, format->pixels->bytes);
            assert_ok(qtri_frame_init(&frame, format, WIDTH, HEIGHT, rows, band_memory, bytes));
            const uint32_t few[4] = {VERTICES, VERTICES, 20, 0};
            const uint32_t short_lists[6] = {
                QTRI_PREPARED_LISTS(TRIANGLES, HEIGHT, HEIGHT), LISTS, LISTS, 100, 20, 0};
            prepared_init_with(&prepared, vertex_memory, few[random_in(&seed, 0, 3)], list_memory,
                               short_lists[random_in(&seed, 0, 5)]);
            qtri_frame_begin(&frame);
            qtri_prepare_mesh(&prepared, &frame, &s.view, &s.pose, &s.mesh, &s.material);
            assert_same_bands(&whole.surface, &frame, &prepared, sky);
        }
        canvas_free(&whole);
    }
}

/* A sphere as high as the frame, in bands down to one row: each triangle that is seen has its own
   entries, in the memory that the macro says. */
TEST(lists_have_room_for_thin_bands)
{
    enum { SIDE = 240, SLICES = 56, SPHERE = QTRI_SPHERE_VERTICES(SLICES, SLICES) };
    static qtri_vec3 points[SPHERE];
    static uint16_t corners[QTRI_SPHERE_TRIANGLES(SLICES, SLICES)][3];
    static uint8_t memory[QTRI_PREPARED_BYTES(SPHERE, LENGTH_OF(corners), SIDE, 1)];
    static uint8_t frame_memory[QTRI_FRAME_BYTES(SIDE, SIDE, QTRI_GRAY8_BYTES)];
    const qtri_shape_memory room = {points, NULL, NULL, corners, SPHERE, LENGTH_OF(corners)};
    const qtri_vec3 eye = {Q16(3), Q16(6), Q16(7)};
    const qtri_vec3 up = {0, Q16(1), 0};
    const qtri_material material = qtri_material_default();
    for (int32_t slices = 4; slices <= SLICES; slices += 4) {
        for (int32_t rows = 1; rows <= SIDE; rows *= 2) {
            qtri_mesh mesh;
            qtri_frame frame;
            qtri_view view;
            qtri_transform pose;
            qtri_prepared prepared;
            assert_ok(qtri_shape_sphere(&mesh, &room, Q16(1), slices, slices));
            assert_ok(qtri_frame_init(&frame, &qtri_gray8, SIDE, SIDE, rows, frame_memory,
                                      sizeof frame_memory));
            qtri_view_init(&view, SIDE, SIDE);
            qtri_view_look_at(&view, eye, vec3_of(0, 0, 0), up);
            qtri_view_perspective(&view, Q16(11.9), Q16(1), Q16(20)); /* 2 asin(1 / sqrt(94)) */
            qtri_transform_identity(&pose);
            const size_t bytes =
                QTRI_PREPARED_BYTES(mesh.vertex_count, mesh.triangle_count, SIDE, rows);
            qtri_prepared_init(&prepared, memory, bytes);
            qtri_prepare_mesh(&prepared, &frame, &view, &pose, &mesh, &material);
            assert_true(qtri_prepared_fits(&prepared));
            qtri_prepared_init(&prepared, memory, bytes / 4);
            assert_false(qtri_prepared_fits(&prepared));
            qtri_prepare_mesh(&prepared, &frame, &view, &pose, &mesh, &material);
            assert_false(qtri_prepared_fits(&prepared));
        }
    }
}

/* A triangle over all bands needs two numbers a band, up to whole blocks of eight, and a block for
   each band's list: with one number less the lists do not fit. */
TEST(lists_take_no_more_than_they_need)
{
    static const qtri_vec3 corners[3] = {
        {-Q16(9), -Q16(9), 0}, {Q16(9), -Q16(9), 0}, {0, Q16(9), 0}};
    static const uint16_t triangle[1][3] = {{0, 1, 2}};
    const qtri_mesh mesh = {
        .positions = corners, .triangles = triangle, .vertex_count = 3, .triangle_count = 1};
    const qtri_material material = plain_material();
    for (int32_t rows = 1; rows <= HEIGHT; rows++) {
        qtri_frame frame;
        qtri_view view;
        qtri_transform pose;
        qtri_prepared prepared;
        qtri_view_init(&view, WIDTH, HEIGHT);
        qtri_view_perspective(&view, Q16(60), Q16(.5), Q16(30));
        qtri_transform_identity(&pose);
        qtri_transform_translate(&pose, vec3_of(0, 0, -4));
        assert_ok(qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, rows, band_memory,
                                  sizeof band_memory));
        const uint32_t bands = (uint32_t)((HEIGHT + rows - 1) / rows);
        const uint32_t least = (2 * bands + 7) / 8 * 8 + 8 * bands;
        prepared_init_with(&prepared, vertex_memory, VERTICES, list_memory, least);
        qtri_prepare_mesh(&prepared, &frame, &view, &pose, &mesh, &material);
        assert_true(qtri_prepared_fits(&prepared));
        prepared_init_with(&prepared, vertex_memory, VERTICES, list_memory, least - 1);
        qtri_prepare_mesh(&prepared, &frame, &view, &pose, &mesh, &material);
        assert_false(qtri_prepared_fits(&prepared));
    }
}

/* In coloured lights the memory that the macro says has vertices for the colours, and lists. */
TEST(colored_light_has_room_for_colors)
{
    static const qtri_light_source source = {.kind = &qtri_directional_light,
                                             .direction = {0, 0, -Q16(1)},
                                             .color = {Q16(1), Q16(.5), Q16(.2)}};
    static uint8_t memory[QTRI_PREPARED_BYTES(QTRI_LIT_VERTICES(VERTICES), TRIANGLES, HEIGHT, 1)];
    const qtri_light_color ambient = {Q16(.1), Q16(.2), Q16(.3)};
    qtri_light lights;
    uint64_t seed = 78;
    assert_ok(qtri_light_init(&lights, &source, 1, ambient));
    for (int32_t rows = 1; rows <= HEIGHT; rows++) {
        scene s;
        qtri_frame frame;
        qtri_prepared prepared;
        random_scene(&s, &seed);
        s.mesh.normals = normals;
        s.mesh.triangle_count = TRIANGLES;
        s.view.light = &lights;
        s.material = qtri_material_default();
        s.material.cull = QTRI_CULL_BACK;
        qtri_transform_identity(&s.pose);
        qtri_transform_translate(&s.pose, vec3_of(0, 0, -4));
        assert_ok(qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, rows, band_memory,
                                  sizeof band_memory));
        qtri_prepared_init(
            &prepared, memory,
            QTRI_PREPARED_BYTES(QTRI_LIT_VERTICES(VERTICES), TRIANGLES, HEIGHT, rows));
        qtri_prepare_mesh(&prepared, &frame, &s.view, &s.pose, &s.mesh, &s.material);
        assert_int_equal(prepared.vertex_count, QTRI_LIT_VERTICES(VERTICES));
        assert_true(qtri_prepared_fits(&prepared));
    }
}

/* Memory of any size is divided inside of it, and what is drawn does not depend on it. */
TEST(any_memory_draws_the_same)
{
    uint64_t seed = 77;
    enum { MOST = QTRI_PREPARED_BYTES(QTRI_LIT_VERTICES(VERTICES), TRIANGLES, HEIGHT, 1) };
    static uint8_t memory[MOST + 2 * 65536]; /* for more entries than lists can have */
    static const qtri_light_source source = {.kind = &qtri_directional_light,
                                             .direction = {0, 0, -Q16(1)},
                                             .color = {Q16(1), Q16(.5), Q16(.2)}};
    const qtri_light_color ambient = {Q16(.1), Q16(.2), Q16(.3)};
    qtri_light lights;
    int fitting = 0;
    assert_ok(qtri_light_init(&lights, &source, 1, ambient));
    for (int n = 0; n < 200; n++) {
        static scene s;
        random_scene(&s, &seed);
        s.view.light = n % 4 == 0 ? &lights : s.view.light;
        if (n % 50 == 3) { /* behind the eye, as its box says: nothing is to be listed */
            const qtri_box box = {{0, 0, 0}, {Q16(2), Q16(2), Q16(2)}};
            s.mesh.bounds = box;
            qtri_transform_identity(&s.pose);
            qtri_transform_translate(&s.pose, vec3_of(0, 0, 9));
        }
        canvas whole = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
        draw_whole(&whole.surface, &s);
        qtri_frame frame;
        qtri_prepared prepared;
        const int32_t first = random_in(&seed, 0, 3);
        const int32_t few = random_in(&seed, 0, MOST - first - 1);
        const int32_t bytes = n % 50 == 1   ? random_in(&seed, 0, 2) /* not even to align it */
                              : n % 50 == 2 ? (int32_t)sizeof memory - first - 1
                                            : few;
        memset(memory, 0x5A, sizeof memory);
        assert_ok(qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, random_in(&seed, 1, HEIGHT),
                                  band_memory, sizeof band_memory));
        qtri_prepared_init(&prepared, memory + first, (size_t)bytes);
        qtri_prepare_mesh(&prepared, &frame, &s.view, &s.pose, &s.mesh, &s.material);
        const bool fits = qtri_prepared_fits(&prepared);
        assert_true(!fits || !prepared.is_seen || bytes >= VERTICES * (int32_t)sizeof(qtri_vertex));
        assert_true(!fits || !prepared.is_seen || prepared.group_log2 == 0);
        assert_true(fits || bytes < MOST);
        assert_true(n % 50 != 3 || (!prepared.is_seen && fits));
        fitting += fits;
        assert_same_bands(&whole.surface, &frame, &prepared, sky);
        assert_true(first == 0 || memory[0] == 0x5A);
        assert_int_equal(memory[first + bytes], 0x5A);
        canvas_free(&whole);
    }
    assert_in_range(fitting, 10, 190);
}

/* Rows that are not the frame's bands, in any order, inside any scissor. */
TEST(other_rows)
{
    uint64_t seed = 72;
    for (int n = 0; n < 400; n++) {
        static scene s;
        random_scene(&s, &seed);
        qtri_frame frame;
        qtri_prepared prepared;
        assert_ok(qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, random_in(&seed, 1, HEIGHT),
                                  band_memory, sizeof band_memory));
        prepared_init_with(&prepared, vertex_memory, VERTICES, list_memory, LISTS);
        qtri_prepare_mesh(&prepared, &frame, &s.view, &s.pose, &s.mesh, &s.material);
        for (int part = 0; part < 4; part++) {
            const int32_t first = random_in(&seed, 0, HEIGHT - 1);
            const int32_t rows = random_in(&seed, 1, HEIGHT);
            canvas one = canvas_band(&qtri_rgb565, WIDTH, HEIGHT, first, rows);
            canvas other = canvas_band(&qtri_rgb565, WIDTH, HEIGHT, first, rows);
            one.surface.scissor.y0 = random_in(&seed, -4, HEIGHT);
            one.surface.scissor.x1 = random_in(&seed, 0, WIDTH + 4);
            other.surface.scissor = one.surface.scissor;
            draw_whole(&one.surface, &s);
            qtri_surface_clear(&other.surface, sky);
            qtri_draw_prepared(&other.surface, &prepared);
            assert_same_picture(&one.surface, &other.surface);
            canvas_free(&one);
            canvas_free(&other);
        }
    }
}

/* What two cores share is not written to while they draw. */
TEST(only_reads)
{
    uint64_t seed = 73;
    static qtri_vertex vertices[VERTICES];
    static uint16_t lists[LISTS];
    for (int n = 0; n < 600; n++) {
        static scene s;
        random_scene(&s, &seed);
        qtri_frame frame;
        qtri_surface band;
        qtri_prepared prepared;
        assert_ok(qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, random_in(&seed, 1, HEIGHT),
                                  band_memory, sizeof band_memory));
        const uint32_t list_count = (uint32_t)random_in(&seed, 0, 2) * 150;
        prepared_init_with(&prepared, vertex_memory, VERTICES, list_memory, list_count);
        qtri_prepare_mesh(&prepared, &frame, &s.view, &s.pose, &s.mesh, &s.material);
        memcpy(vertices, vertex_memory, sizeof vertices);
        memcpy(lists, list_memory, sizeof lists);
        while (qtri_frame_next_band(&frame, &band)) {
            qtri_draw_prepared(&band, &prepared);
        }
        canvas odd = canvas_band(&qtri_rgb565, WIDTH, HEIGHT, 3, HEIGHT);
        qtri_draw_prepared(&odd.surface, &prepared);
        canvas_free(&odd);
        assert_memory_equal(vertices, vertex_memory, sizeof vertices);
        assert_memory_equal(lists, list_memory, sizeof lists);
    }
}

/* Nothing before it is prepared, of an empty mesh, and into frames of another size. */
TEST(nothing_drawn)
{
    uint64_t seed = 74;
    scene s;
    random_scene(&s, &seed);
    canvas c = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    canvas black = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    qtri_frame frame;
    qtri_prepared prepared;
    assert_ok(qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT - 1, 7, band_memory,
                              sizeof band_memory));
    prepared_init_with(&prepared, NULL, 0, NULL, 0);
    qtri_draw_prepared(&c.surface, &prepared);
    qtri_prepared_mark(&prepared, &frame);
    qtri_prepare_mesh(&prepared, &frame, &s.view, &s.pose, &s.mesh, &s.material);
    qtri_draw_prepared(&c.surface, &prepared);
    s.mesh.triangle_count = 0;
    assert_ok(
        qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, 7, band_memory, sizeof band_memory));
    qtri_prepare_mesh(&prepared, &frame, &s.view, &s.pose, &s.mesh, &s.material);
    qtri_draw_prepared(&c.surface, &prepared);
    assert_same_picture(&black.surface, &c.surface);
    /* A frame that could not be made. */
    assert_int_equal(
        qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, 0, band_memory, sizeof band_memory),
        QTRI_ERROR_SIZE);
    s.mesh.triangle_count = TRIANGLES;
    prepared_init_with(&prepared, vertex_memory, VERTICES, list_memory, LISTS);
    qtri_prepare_mesh(&prepared, &frame, &s.view, &s.pose, &s.mesh, &s.material);
    qtri_prepared_mark(&prepared, &frame);
    qtri_draw_prepared(&c.surface, &prepared);
    assert_same_picture(&black.surface, &c.surface);
    canvas_free(&c);
    canvas_free(&black);
}

/* ---- Frames ---- */

TEST(sizes)
{
    struct {
        int32_t width, height, rows;
        enum qtri_error error;
    } cases[] = {{WIDTH, HEIGHT, 5, QTRI_OK},
                 {WIDTH, 1, HEIGHT, QTRI_OK},
                 {0, HEIGHT, 5, QTRI_ERROR_SIZE},
                 {WIDTH, 0, 5, QTRI_ERROR_SIZE},
                 {WIDTH, HEIGHT, 0, QTRI_ERROR_SIZE},
                 {WIDTH, HEIGHT, INT32_MIN, QTRI_ERROR_SIZE},
                 {QTRI_SURFACE_MAX + 1, HEIGHT, 5, QTRI_ERROR_SIZE},
                 {WIDTH, QTRI_SURFACE_MAX + 1, 5, QTRI_ERROR_SIZE},
                 {WIDTH, HEIGHT, INT32_MAX, QTRI_ERROR_SIZE},
                 {QTRI_SURFACE_MAX, QTRI_SURFACE_MAX, QTRI_SURFACE_MAX, QTRI_ERROR_MEMORY}};
    for (size_t i = 0; i < LENGTH_OF(cases); i++) {
        qtri_frame frame;
        qtri_surface band;
        assert_int_equal(qtri_frame_init(&frame, &qtri_xrgb8888, cases[i].width, cases[i].height,
                                         cases[i].rows, band_memory, sizeof band_memory),
                         cases[i].error);
        qtri_frame_begin(&frame);
        assert_true(qtri_frame_next_band(&frame, &band) == (cases[i].error == QTRI_OK));
        const qtri_rect r = qtri_frame_changes(&frame);
        assert_true((r.x1 > 0) == (cases[i].error == QTRI_OK));
    }
    qtri_frame none;
    qtri_surface no_band;
    assert_int_equal(qtri_frame_init(&none, NULL, 9, 9, 3, band_memory, sizeof band_memory),
                     QTRI_ERROR_FORMAT);
    assert_false(qtri_frame_next_band(&none, &no_band));
    static uint8_t exact[QTRI_FRAME_BYTES(9, 3, QTRI_GRAY8_BYTES)];
    qtri_frame frame;
    assert_ok(qtri_frame_init(&frame, &qtri_gray8, 9, 9, 3, exact, sizeof exact));
    assert_int_equal(qtri_frame_init(&frame, &qtri_gray8, 9, 9, 3, exact, sizeof exact - 1),
                     QTRI_ERROR_MEMORY);
}

/* Each row once, in order; buffers alternate, are aligned, apart and inside the memory. */
TEST(bands)
{
    static uint8_t memory[QTRI_FRAME_BYTES_DOUBLE(13, 9, QTRI_XRGB8888_BYTES) + 8];
    for (int n = 0; n < 9 * 3 * 2 * 4; n++) {
        const int32_t rows = n % 9 + 1;
        const qtri_format *format = formats[n / 9 % 3];
        const bool two = n / 27 % 2 != 0;
        uint8_t *start = memory + n / 54;
        const size_t bytes = two ? QTRI_FRAME_BYTES_DOUBLE(13, rows, format->pixels->bytes)
                                 : QTRI_FRAME_BYTES(13, rows, format->pixels->bytes);
        qtri_frame frame;
        qtri_surface band;
        assert_ok(qtri_frame_init(&frame, format, 13, 9, rows, start, bytes));
        const uint8_t *last = NULL;
        for (int turn = 0; turn < 3; turn++) {
            int32_t next = 0;
            while (qtri_frame_next_band(&frame, &band)) {
                const int32_t expected = rows < 9 - next ? rows : 9 - next;
                const ptrdiff_t size = rows * band.pitch;
                assert_int_equal(band.first_row, next);
                assert_int_equal(band.rows, expected);
                assert_int_equal((uintptr_t)band.pixels % 4, 0);
                assert_true(band.pixels >= start && band.pixels + size <= start + bytes);
                assert_true((uint8_t *)band.depth >= start);
                assert_true((uint8_t *)(band.depth + 13 * rows) <= start + bytes);
                assert_true((uint8_t *)band.depth >= band.pixels + size ||
                            (uint8_t *)(band.depth + 13 * rows) <= band.pixels);
                if (last != NULL && two) {
                    assert_true(band.pixels >= last + size || band.pixels + size <= last);
                } else if (last != NULL) {
                    assert_ptr_equal(band.pixels, last);
                }
                last = band.pixels;
                next += expected;
            }
            assert_int_equal(next, 9);
        }
    }
}

/* Several frames share the bands: each one once. */
TEST(shares)
{
    for (int32_t parts = 1; parts <= 5; parts++) {
        int seen[HEIGHT] = {0};
        for (int32_t part = 0; part < parts; part++) {
            qtri_frame frame;
            qtri_surface band;
            assert_ok(qtri_frame_init(&frame, &qtri_gray8, 8, HEIGHT, 3, band_memory,
                                      sizeof band_memory));
            qtri_frame_share(&frame, part, parts);
            while (qtri_frame_next_band(&frame, &band)) {
                for (int32_t y = 0; y < band.rows; y++) {
                    seen[band.first_row + y]++;
                }
            }
        }
        for (int y = 0; y < HEIGHT; y++) {
            assert_int_equal(seen[y], 1);
        }
    }
    qtri_frame frame;
    qtri_surface band;
    assert_ok(qtri_frame_init(&frame, &qtri_gray8, 8, HEIGHT, 3, band_memory, sizeof band_memory));
    qtri_frame_share(&frame, INT32_MAX, INT32_MIN);
    assert_false(qtri_frame_next_band(&frame, &band));
    qtri_frame_share(&frame, INT32_MIN, INT32_MAX);
    assert_true(qtri_frame_next_band(&frame, &band));
    assert_false(qtri_frame_next_band(&frame, &band));
}

static void assert_rect(qtri_rect r, int32_t x0, int32_t y0, int32_t x1, int32_t y1)
{
    if (r.x0 != x0 || r.y0 != y0 || r.x1 != x1 || r.y1 != y1) {
        fail_msg("%d %d %d %d", (int)r.x0, (int)r.y0, (int)r.x1, (int)r.y1);
    }
}

TEST(marks)
{
    qtri_frame frame;
    qtri_surface band;
    assert_ok(
        qtri_frame_init(&frame, &qtri_gray8, WIDTH, HEIGHT, 8, band_memory, sizeof band_memory));
    qtri_frame_begin(&frame);
    assert_rect(qtri_frame_changes(&frame), 0, 0, WIDTH, HEIGHT); /* the first frame */
    assert_true(qtri_frame_next_band(&frame, &band));
    qtri_frame_begin(&frame);
    assert_rect(qtri_frame_changes(&frame), 0, 0, 0, 0);
    const qtri_rect none[3] = {
        {5, 5, 5, 9}, {WIDTH, 0, WIDTH + 9, HEIGHT}, {INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN}};
    for (int i = 0; i < 3; i++) {
        qtri_frame_mark(&frame, &none[i]);
        assert_rect(qtri_frame_changes(&frame), 0, 0, 0, 0);
    }
    qtri_frame_only_changes(&frame);
    assert_false(qtri_frame_next_band(&frame, &band));
    const qtri_rect one = {7, 17, 9, 19};
    const qtri_rect two = {8, 10, 30, 17};
    const qtri_rect all = {INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX};
    qtri_frame_begin(&frame);
    qtri_frame_mark(&frame, &one);
    assert_rect(qtri_frame_changes(&frame), 7, 17, 9, 19);
    qtri_frame_mark(&frame, &two);
    assert_rect(qtri_frame_changes(&frame), 7, 10, 30, 19);
    qtri_frame_only_changes(&frame);
    for (int32_t row = 8; row <= 16; row += 8) {
        assert_true(qtri_frame_next_band(&frame, &band));
        assert_int_equal(band.first_row, row);
        assert_rect(qtri_surface_bounds(&band), 7, row == 8 ? 10 : 16, 30, row == 8 ? 16 : 19);
    }
    assert_false(qtri_frame_next_band(&frame, &band));
    qtri_frame_begin(&frame);
    assert_true(qtri_frame_next_band(&frame, &band));
    assert_int_equal(band.first_row, 0);
    assert_rect(band.scissor, 0, 0, WIDTH, HEIGHT);
    qtri_frame_mark(&frame, &all);
    assert_rect(qtri_frame_changes(&frame), 0, 0, WIDTH, HEIGHT);
}

/* A display that only gets what has changed shows the same picture as one that gets all. */
TEST(display)
{
    uint64_t seed = 75;
    int small = 0;
    for (int n = 0; n < 40; n++) {
        const qtri_format *format = formats[n % 3];
        canvas shown = canvas_new(format, WIDTH, HEIGHT);
        qtri_frame frame;
        qtri_surface band;
        qtri_prepared prepared[2];
        scene s[2];
        static qtri_vertex vertices[2][VERTICES];
        static uint16_t lists[2][LISTS];
        assert_ok(qtri_frame_init(&frame, format, WIDTH, HEIGHT, random_in(&seed, 1, HEIGHT),
                                  band_memory, sizeof band_memory));
        for (int i = 0; i < 2; i++) {
            random_scene(&s[i], &seed);
            prepared_init_with(&prepared[i], vertices[i], random_flag(&seed) ? VERTICES : 30,
                               lists[i], LISTS);
        }
        for (int step = 0; step < 8; step++) {
            qtri_frame_begin(&frame);
            canvas whole = canvas_new(format, WIDTH, HEIGHT);
            qtri_surface_clear(&whole.surface, sky);
            for (int i = 0; i < 2; i++) {
                const bool moves = random_flag(&seed);
                if (moves) {
                    const qtri_vec3 by = {random_in(&seed, Q16(-.5), Q16(.5)), 0, Q16(-.25)};
                    qtri_transform_translate(&s[i].pose, by);
                    qtri_transform_rotate_y(&s[i].pose, Q16(25));
                }
                qtri_prepare_mesh(&prepared[i], &frame, &s[i].view, &s[i].pose, &s[i].mesh,
                                  &s[i].material);
                if (moves || step == 0) {
                    qtri_prepared_mark(&prepared[i], &frame);
                }
                s[i].view.vertices = NULL;
                s[i].view.vertex_count = 0;
                qtri_draw_mesh(&whole.surface, &s[i].view, &s[i].pose, &s[i].mesh, &s[i].material);
            }
            const qtri_rect changed = qtri_frame_changes(&frame);
            small += changed.x1 - changed.x0 < WIDTH;
            qtri_frame_only_changes(&frame);
            while (qtri_frame_next_band(&frame, &band)) {
                qtri_surface_clear(&band, sky);
                qtri_draw_prepared(&band, &prepared[0]);
                qtri_draw_prepared(&band, &prepared[1]);
                const qtri_rect sent = qtri_surface_bounds(&band);
                const size_t pixel = format->pixels->bytes;
                for (int32_t y = sent.y0; y < sent.y1; y++) {
                    memcpy(shown.surface.pixels + y * shown.surface.pitch + (size_t)sent.x0 * pixel,
                           band.pixels + (y - band.first_row) * band.pitch +
                               (size_t)sent.x0 * pixel,
                           (size_t)(sent.x1 - sent.x0) * pixel);
                }
            }
            assert_memory_equal(shown.surface.pixels, whole.surface.pixels,
                                (size_t)(whole.surface.pitch * HEIGHT));
            canvas_free(&whole);
        }
        canvas_free(&shown);
    }
    assert_true(small > 40); /* of 320 frames: it does say less than everything */
}

/* The rectangle of a mesh inside the picture, to the pixel. */
TEST(tight)
{
    qtri_frame frame;
    qtri_surface band;
    qtri_prepared prepared;
    uint64_t seed = 76;
    scene s;
    random_scene(&s, &seed);
    s.material = plain_material();
    s.mesh.triangles8 = NULL;
    qtri_transform_identity(&s.pose);
    const qtri_vec3 at = {0, 0, Q16(-5)};
    qtri_transform_translate(&s.pose, at);
    assert_ok(
        qtri_frame_init(&frame, &qtri_gray8, WIDTH, HEIGHT, 8, band_memory, sizeof band_memory));
    assert_true(qtri_frame_next_band(&frame, &band));
    qtri_frame_begin(&frame);
    prepared_init_with(&prepared, vertex_memory, VERTICES, list_memory, LISTS);
    qtri_prepare_mesh(&prepared, &frame, &s.view, &s.pose, &s.mesh, &s.material);
    qtri_prepared_mark(&prepared, &frame);
    canvas c = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    qtri_draw_prepared(&c.surface, &prepared);
    qtri_rect seen = {WIDTH, HEIGHT, 0, 0};
    for (int32_t y = 0; y < HEIGHT; y++) {
        for (int32_t x = 0; x < WIDTH; x++) {
            if (stored_pixel(&c.surface, x, y) != 0) {
                seen.x0 = x < seen.x0 ? x : seen.x0;
                seen.y0 = y < seen.y0 ? y : seen.y0;
                seen.x1 = x >= seen.x1 ? x + 1 : seen.x1;
                seen.y1 = y >= seen.y1 ? y + 1 : seen.y1;
            }
        }
    }
    assert_true(seen.x0 > 0 && seen.x1 < WIDTH);
    assert_rect(qtri_frame_changes(&frame), seen.x0, seen.y0, seen.x1, seen.y1);
    canvas_free(&c);
}

int main(void)
{
    return run_all_tests(make_torus, NULL);
}
