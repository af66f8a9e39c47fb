/* SPDX-License-Identifier: MIT */
/*
 * Wireframes of meshes: edges that triangles share are left out only where nobody sees it. The
 * picture is that of every triangle drawn alone, in turn, for every way to look and to draw.
 */
#include "support/core.h"
#include "support/layouts.h"

#include "draw/mesh_job.h"

enum { WIDTH = 60, HEIGHT = 44, SIDE = 8, VERTICES = SIDE * SIDE, TRIANGLES = 2 * VERTICES + 12 };

typedef struct scene {
    qtri_vec3 positions[VERTICES];
    qtri_normal normals[VERTICES];
    qtri_rgb colors[VERTICES];
    uint16_t triangles[TRIANGLES][3];
    uint8_t triangles8[TRIANGLES][3];
    qtri_mesh mesh;
    qtri_view view;
    qtri_light light;
    qtri_transform pose;
    qtri_material material;
    const qtri_format *format;
    qtri_rect scissor;
    bool has_depth;
} scene;

static qtri_vertex scratch[VERTICES];
static const qtri_rgb sky = {24, 32, 48};

/* A torus, a sheet, or a heap of points: many depths are equal when it is flat. */
static void place_vertices(scene *s, uint64_t *seed)
{
    const int kind = random_in(seed, 0, 2);
    const double depth = random_flag(seed) ? 1 : random_in(seed, 0, 2) * .0004;
    for (int i = 0; i < VERTICES; i++) {
        double u = i % SIDE * 6.2831853 / SIDE;
        double v = i / SIDE * 6.2831853 / SIDE; /* NOLINT(bugprone-integer-division): a row */
        double r = 1 + .5 * cos(v);
        double x = kind == 0 ? r * cos(u) : i % SIDE * .3 - 1;
        double y = kind == 0 ? r * sin(u) : v / 3 - 1;
        double z = kind == 0 ? .5 * sin(v) : random_in(seed, -500, 500) / 1000.;
        if (kind == 2) {
            x = random_in(seed, -1300, 1300) / 1000.;
            y = random_in(seed, -1300, 1300) / 1000.;
        }
        s->positions[i] = vec3_of(x, y, z * depth);
        qtri_normal n = {(int16_t)random_in(seed, -9400, 9400),
                         (int16_t)random_in(seed, -9400, 9400), (int16_t)random_in(seed, 0, 9400)};
        s->normals[i] = n;
        s->colors[i].r = (uint8_t)random64(seed);
        s->colors[i].g = (uint8_t)random64(seed);
        s->colors[i].b = (uint8_t)random64(seed);
    }
}

/* Its triangles in their order, none turned over. */
static void place_torus(scene *s)
{
    for (int i = 0; i < VERTICES; i++) {
        const double u = i % SIDE * 6.2831853 / SIDE;
        const double v = i / SIDE * 6.2831853 / SIDE; /* NOLINT(bugprone-integer-division): a row */
        const double r = 1 + .5 * cos(v);
        s->positions[i] = vec3_of(r * cos(u), r * sin(u), .5 * sin(v));
        const int right = i / SIDE * SIDE + (i + 1) % SIDE;
        const int up = (i + SIDE) % VERTICES;
        const int both = (right + SIDE) % VERTICES;
        const int corner[6] = {i, right, both, i, both, up};
        for (int k = 0; k < 6; k++) {
            s->triangles[2 * i + k / 3][k % 3] = (uint16_t)corner[k];
        }
    }
}

/* Squares of two triangles in any order, some turned over; twice, degenerate and past the end. */
static void place_triangles(scene *s, uint64_t *seed)
{
    const int disorder = random_in(seed, 0, 2);
    for (int i = 0; i < VERTICES; i++) {
        int right = i / SIDE * SIDE + (i + 1) % SIDE;
        int up = (i + SIDE) % VERTICES;
        int both = (right + SIDE) % VERTICES;
        const int corner[6] = {i, right, both, i, both, up};
        for (int k = 0; k < 6; k++) {
            s->triangles[2 * i + k / 3][(k + i) % 3] = (uint16_t)corner[k];
        }
    }
    for (int i = 2 * VERTICES; i < TRIANGLES; i++) {
        for (int k = 0; k < 3; k++) {
            s->triangles[i][k] = (uint16_t)random_in(seed, 0, i % 2 ? VERTICES : 3);
        }
    }
    for (int i = 0; disorder > 0 && i < TRIANGLES; i++) {
        uint16_t *a = s->triangles[i];
        uint16_t *b = s->triangles[random_in(seed, 0, TRIANGLES - 1)];
        for (int k = 0; k < 3; k++) {
            uint16_t one = a[k];
            a[k] = b[k];
            b[k] = one;
        }
        if (disorder == 2 && random_in(seed, 0, 4) == 0) {
            uint16_t one = a[0];
            a[0] = a[2];
            a[2] = one;
        }
    }
    for (int i = 0; i < TRIANGLES * 3; i++) {
        s->triangles8[i / 3][i % 3] = (uint8_t)s->triangles[i / 3][i % 3];
    }
}

static void random_scene(scene *s, uint64_t *seed)
{
    static const qtri_light sun = {
        .towards = {Q16(.4), Q16(.6), Q16(.7)}, .ambient = Q16(.1), .diffuse = Q16(.9)};
    const qtri_rect all = {0, 0, WIDTH, HEIGHT};
    const qtri_rect part = {random_in(seed, -4, 30), random_in(seed, -4, 30),
                            random_in(seed, 20, WIDTH + 4), random_in(seed, 20, HEIGHT + 4)};
    place_vertices(s, seed);
    place_triangles(s, seed);
    const qtri_mesh mesh = {
        .positions = s->positions,
        .normals = random_flag(seed) ? s->normals : NULL,
        .colors = random_in(seed, 0, 2) == 0 ? s->colors : NULL,
        .triangles = (const uint16_t(*)[3])s->triangles,
        .triangles8 = random_in(seed, 0, 2) == 0 ? (const uint8_t(*)[3])s->triangles8 : NULL,
        /* of few vertices: more triangles than there are notes for; others are past the end */
        .vertex_count = random_in(seed, 0, 3) == 0 ? (uint32_t)random_in(seed, 20, 40) : VERTICES,
        .triangle_count = TRIANGLES};
    s->mesh = mesh;
    s->material = qtri_material_default();
    s->material.color.g = (uint8_t)random64(seed);
    s->material.shading = shading_of((int)(random_in(seed, 0, 3) % 3));
    s->material.cull = (qtri_cull)(random_in(seed, 0, 3) % 3);
    s->material.fill = &qtri_wireframe;
    s->material.depth_compare =
        random_in(seed, 0, 3) == 0 ? QTRI_LESS : (qtri_compare)random_in(seed, 0, 9);
    s->material.depth_read_only = random_in(seed, 0, 3) == 0;
    s->format = random_flag(seed) ? &qtri_rgb565 : drawn_format(random_in(seed, 0, 2));
    s->scissor = random_in(seed, 0, 2) == 0 ? part : all;
    s->has_depth = random_in(seed, 0, 5) != 0;
    s->light = sun;
    qtri_view_init(&s->view, WIDTH, HEIGHT);
    qtri_transform_perspective(&s->view.projection, Q16(60), Q16(1.3), Q16(.5), Q16(30));
    s->view.light = random_flag(seed) ? &s->light : NULL;
    give_vertices(&s->view, scratch, VERTICES);
    const qtri_vec3 at = {random_in(seed, Q16(-.6), Q16(.6)), random_in(seed, Q16(-.6), Q16(.6)),
                          -random_in(seed, random_in(seed, 0, 4) == 0 ? 0 : Q16(2.5), Q16(7))};
    qtri_transform_identity(&s->pose);
    qtri_transform_translate(&s->pose, at);
    if (random_flag(seed)) {
        qtri_transform_rotate_x(&s->pose, random_in(seed, 0, Q16(360)));
        qtri_transform_rotate_y(&s->pose, random_in(seed, 0, Q16(360)));
    }
}

static canvas begin(const scene *s, int32_t first, int32_t rows)
{
    const bool farther = s->material.depth_compare >= QTRI_GREATER;
    canvas c = canvas_band(s->format, WIDTH, HEIGHT, first, rows);
    clear_to(&c.surface, sky, farther ? 0 : UINT16_MAX);
    c.surface.scissor = s->scissor;
    if (!s->has_depth) {
        c.surface.depth = NULL;
    }
    return c;
}

/* One triangle has three edges of its own. */
static canvas draw_one_by_one(const scene *s)
{
    canvas c = begin(s, 0, HEIGHT);
    for (uint32_t i = 0; i < TRIANGLES; i++) {
        qtri_mesh one = s->mesh;
        one.triangles = &s->mesh.triangles[i];
        one.triangles8 = s->mesh.triangles8 != NULL ? &s->mesh.triangles8[i] : NULL;
        one.triangle_count = 1;
        qtri_draw_mesh(&c.surface, &s->view, &s->pose, &one, &s->material);
    }
    return c;
}

static void assert_same(const scene *s, const canvas *whole, const canvas *part)
{
    const qtri_surface *b = &part->surface;
    for (int32_t y = b->first_row; y < b->first_row + b->rows; y++) {
        for (int32_t x = 0; x < WIDTH; x++) {
            if (stored_pixel(&whole->surface, x, y) != stored_pixel(b, x, y) ||
                (s->has_depth && stored_depth(&whole->surface, x, y) != stored_depth(b, x, y))) {
                fail_msg("pixel %d,%d: %x and %x", (int)x, (int)y,
                         (unsigned)stored_pixel(&whole->surface, x, y),
                         (unsigned)stored_pixel(b, x, y));
            }
        }
    }
}

TEST(whole_mesh)
{
    uint64_t seed = 91;
    for (int n = 0; n < random_cases(1500); n++) {
        static scene s;
        random_scene(&s, &seed);
        canvas expected = draw_one_by_one(&s);
        const uint32_t slots[3] = {VERTICES, (uint32_t)random_in(&seed, 1, VERTICES), 0};
        for (int i = 0; i < 3; i++) {
            canvas c = begin(&s, 0, HEIGHT);
            s.view.vertex_count = slots[i];
            qtri_draw_mesh(&c.surface, &s.view, &s.pose, &s.mesh, &s.material);
            assert_same(&s, &expected, &c);
            canvas_free(&c);
        }
        canvas_free(&expected);
    }
}

TEST(prepared_mesh)
{
    enum { LISTS = QTRI_PREPARED_LISTS(TRIANGLES, HEIGHT, 1) };
    static uint16_t lists[LISTS];
    static qtri_vertex vertices[VERTICES];
    static uint8_t memory[QTRI_FRAME_BYTES(WIDTH, HEIGHT, QTRI_XRGB8888_BYTES)];
    uint64_t seed = 92;
    for (int n = 0; n < random_cases(1500); n++) {
        static scene s;
        random_scene(&s, &seed);
        canvas expected = draw_one_by_one(&s);
        qtri_frame frame;
        qtri_prepared prepared;
        const int32_t rows = random_in(&seed, 1, HEIGHT);
        assert_ok(qtri_frame_init(&frame, s.format, WIDTH, HEIGHT, rows, memory, sizeof memory));
        prepared_init_with(&prepared, vertices, random_in(&seed, 0, 3) == 0 ? 20 : VERTICES, lists,
                           random_in(&seed, 0, 2) == 0 ? LISTS / 4 : LISTS);
        qtri_prepare_mesh(&prepared, &frame, &s.view, &s.pose, &s.mesh, &s.material);
        for (int32_t first = 0; first < HEIGHT; first += rows) {
            canvas band = begin(&s, first, first + rows > HEIGHT ? HEIGHT - first : rows);
            qtri_draw_prepared(&band.surface, &prepared);
            assert_same(&s, &expected, &band);
            canvas_free(&band);
        }
        canvas_free(&expected);
    }
}

/* A closed mesh has three edges for two triangles; what the notes forget is less than a fifth. */
TEST(edges_once)
{
    static qtri_vertex vertices[VERTICES];
    static uint8_t memory[QTRI_FRAME_BYTES(WIDTH, HEIGHT, QTRI_XRGB8888_BYTES)];
    uint64_t seed = 93;
    for (int n = 0; n < random_cases(400); n++) {
        static scene s;
        qtri_frame frame;
        qtri_prepared prepared;
        random_scene(&s, &seed);
        place_torus(&s);
        s.mesh.vertex_count = VERTICES;
        s.mesh.triangle_count = 2 * VERTICES;
        s.mesh.triangles8 = NULL;
        s.material.cull = QTRI_CULL_NONE;
        qtri_transform_identity(&s.pose);
        qtri_transform_translate(&s.pose, vec3_of(0, 0, -5));
        assert_ok(qtri_frame_init(&frame, s.format, WIDTH, HEIGHT, HEIGHT, memory, sizeof memory));
        prepared_init_with(&prepared, vertices, VERTICES, NULL, 0);
        qtri_prepare_mesh(&prepared, &frame, &s.view, &s.pose, &s.mesh, &s.material);
        int edges = 0;
        for (int bit = 0; bit < 16 * VERTICES; bit++) {
            edges += bit % 4 < 3 && (vertices[bit / 16].index >> bit % 16 & 1) != 0;
        }
        const bool every =
            s.material.depth_compare == QTRI_NOT_EQUAL && !s.material.depth_read_only;
        assert_true(every ? edges == 6 * VERTICES
                          : edges >= 3 * VERTICES && edges <= 36 * VERTICES / 10);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
