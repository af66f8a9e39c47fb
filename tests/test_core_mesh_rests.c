/* SPDX-License-Identifier: MIT */
/*
 * Large triangles follow where their vertices truly are, which no vertex keeps: each way of a mesh
 * to the screen finds it again, from wide positions, from compact ones, and in the bands of a
 * prepared mesh. A mesh that is prepared has the same pixels; a compact one, whose transform is of
 * fewer bits, all but one of 100,000, and the same depths.
 */
#include "support/core.h"
#include "support/layouts.h"

enum { WIDTH = 200, HEIGHT = 150, VERTICES = 12, TRIANGLES = 8, STEP = 8, TRIALS = 60 };
enum { LISTS = QTRI_PREPARED_LISTS(TRIANGLES, HEIGHT, 1) };

/* Fields of a texel: what is off by one shows. */
static const qtri_texture checker = {.format = &qtri_texel_checker,
                                     .width_log2 = 8,
                                     .height_log2 = 8,
                                     .fields = 128,
                                     .color = {{255, 200, 40}, {20, 60, 200}}};

typedef struct sheet {
    qtri_vec3 position[VERTICES];
    qtri_position16 position16[VERTICES];
    qtri_vec2 uv[VERTICES];
    qtri_rgb color[VERTICES];
    uint16_t triangle[TRIANGLES][3];
    qtri_mesh wide, compact;
    qtri_view view;
    qtri_transform pose;
    qtri_material material;
} sheet;

/* Triangles as large as the picture; wide positions are those of the compact ones to the bit. */
static void make_mesh(sheet *s, uint64_t *seed)
{
    memset(s, 0, sizeof *s);
    const qtri_vec3 origin = {random_in(seed, -9999, 9999), random_in(seed, -9999, 9999), 0};
    for (int i = 0; i < VERTICES; i++) {
        qtri_position16 *p = &s->position16[i];
        p->x = (int16_t)random_in(seed, -32767, 32767);
        p->y = (int16_t)random_in(seed, -32767, 32767);
        p->z = (int16_t)random_in(seed, -32767, 32767);
        s->position[i].x = origin.x + STEP * p->x;
        s->position[i].y = origin.y + STEP * p->y;
        s->position[i].z = origin.z + STEP * p->z;
        s->uv[i].x = random_in(seed, Q16(-4), Q16(4));
        s->uv[i].y = random_in(seed, Q16(-4), Q16(4));
        s->color[i].r = (uint8_t)random64(seed);
        s->color[i].g = (uint8_t)random64(seed);
    }
    for (int i = 0; i < 3 * TRIANGLES; i++) {
        s->triangle[i / 3][i % 3] = (uint16_t)random_in(seed, 0, VERTICES - 1);
    }
    s->wide.positions = s->position;
    s->wide.uvs = s->uv;
    s->wide.colors = s->color;
    s->wide.triangles = (const uint16_t(*)[3])s->triangle;
    s->wide.vertex_count = VERTICES;
    s->wide.triangle_count = TRIANGLES;
    s->compact = s->wide;
    s->compact.positions = NULL;
    s->compact.positions16 = s->position16;
    s->compact.origin = origin;
    s->compact.extent = (q16)STEP * 32768;
}

static void make_sheet(sheet *s, uint64_t *seed)
{
    make_mesh(s, seed);
    s->material = qtri_material_default();
    s->material.texture = random_flag(seed) ? &checker : NULL;
    s->material.cull = QTRI_CULL_NONE;
    qtri_view_init(&s->view, WIDTH, HEIGHT);
    qtri_transform_perspective(&s->view.projection, Q16(70), Q16(1.3),
                               random_flag(seed) ? Q16(2) : Q16(.2), Q16(20));
    const qtri_vec3 at = {0, 0, -random_in(seed, Q16(1), Q16(9))};
    qtri_transform_identity(&s->pose);
    qtri_transform_translate(&s->pose, at);
    qtri_transform_rotate_x(&s->pose, random_in(seed, 0, Q16(360)));
    qtri_transform_rotate_y(&s->pose, random_in(seed, 0, Q16(360)));
}

static canvas draw_whole(sheet *s, const qtri_mesh *mesh)
{
    static qtri_vertex vertices[VERTICES];
    canvas c = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    give_vertices(&s->view, vertices, VERTICES);
    qtri_draw_mesh(&c.surface, &s->view, &s->pose, mesh, &s->material);
    return c;
}

/* In bands of `rows`, whose vertices are kept when there is memory for them. */
static void assert_prepared(const qtri_surface *whole, sheet *s, const qtri_mesh *mesh,
                            int32_t rows, uint32_t kept)
{
    static uint8_t memory[QTRI_FRAME_BYTES(WIDTH, HEIGHT, QTRI_RGB565_BYTES)];
    static qtri_vertex vertices[VERTICES];
    static uint16_t lists[LISTS];
    static const qtri_rgb black = {0, 0, 0};
    qtri_frame frame;
    qtri_prepared prepared;
    assert_ok(qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, rows, memory,
                              QTRI_FRAME_BYTES(WIDTH, rows, QTRI_RGB565_BYTES)));
    prepared_init_with(&prepared, vertices, kept, lists, LISTS);
    qtri_prepare_mesh(&prepared, &frame, &s->view, &s->pose, mesh, &s->material);
    assert_same_bands(whole, &frame, &prepared, black);
}

TEST(wide_compact_and_prepared_meshes_agree)
{
    uint64_t seed = 12;
    int counts[2] = {0, 0};
    long covered = 0;
    for (int n = 0; n < TRIALS; n++) {
        sheet s;
        make_sheet(&s, &seed);
        canvas wide = draw_whole(&s, &s.wide);
        canvas compact = draw_whole(&s, &s.compact);
        counts[0] += count_different(&wide.surface, &compact.surface);
        counts[1] += count_depths_apart(&wide.surface, &compact.surface, 1);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            covered += stored_depth(&wide.surface, i % WIDTH, i / WIDTH) != UINT16_MAX;
        }
        const int32_t rows = random_in(&seed, 1, 40);
        assert_prepared(&wide.surface, &s, &s.wide, rows, VERTICES);
        assert_prepared(&compact.surface, &s, &s.compact, rows, VERTICES);
        assert_prepared(&compact.surface, &s, &s.compact, rows, 0);
        canvas_free(&wide);
        canvas_free(&compact);
    }
    print_message("%d colours and %d depths of %ld pixels differ\n", counts[0], counts[1], covered);
    assert_true(covered > TRIALS * 5000L);
    assert_true(counts[0] <= covered / 50000);
    assert_int_equal(counts[1], 0);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
