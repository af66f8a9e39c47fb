/* SPDX-License-Identifier: MIT */
/*
 * Draw calls where they draw nothing, where a mesh says wrong things of itself, and in parts that
 * no picture needs: against the same picture made another way.
 */
#include "support/cube.h"
#include "support/layouts.h"

#include "geometry/projector.h"

#include <qtri/material.h>
#include <qtri/antialias.h>
#include <qtri/frame.h>
#include <qtri/light.h>
#include <qtri/prepared.h>
#include <qtri/stroke.h>

enum { WIDTH = 48, HEIGHT = 40, TRIANGLES = CUBE_TRIANGLES + 1, VERTICES = CUBE_VERTICES };

static const qtri_rgb sky = {10, 20, 60};
static const qtri_rgb colors[VERTICES] = {{255, 0, 0},   {0, 255, 0},    {0, 0, 255},
                                          {255, 255, 0}, {255, 0, 255},  {0, 255, 255},
                                          {90, 90, 90},  {255, 255, 255}};
static qtri_vertex vertices[QTRI_LIT_VERTICES(VERTICES)];
static uint16_t lists[400];
static uint32_t outline_memory[9000];

/* With the triangle without an area, and without texture. */
static qtri_mesh cube(void)
{
    qtri_mesh mesh = cube_mesh();
    mesh.uvs = NULL;
    mesh.triangle_count = TRIANGLES;
    return mesh;
}

static qtri_view view_of(double distance, qtri_transform *pose)
{
    return cube_view(WIDTH, HEIGHT, distance, vertices, LENGTH_OF(vertices), pose);
}

static canvas new_canvas(void)
{
    canvas c = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    qtri_surface_clear(&c.surface, sky);
    return c;
}

static int count_drawn(const canvas *c)
{
    canvas empty = new_canvas();
    int count = 0;
    count += count_different(&c->surface, &empty.surface);
    canvas_free(&empty);
    return count;
}

/* ---- Meshes whose planes and bounds are wrong ---- */

/* In bands of seven rows, with what is listed and outlined. */
static void draw_bands(canvas *c, const qtri_mesh *mesh, const qtri_view *view,
                       const qtri_transform *pose, const qtri_material *material)
{
    qtri_prepared prepared;
    qtri_frame frame;
    prepared_init_with(&prepared, vertices, VERTICES, lists, LENGTH_OF(lists));
    assert_ok(qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, 7, c->memory, c->bytes));
    qtri_frame_begin(&frame);
    qtri_prepare_mesh(&prepared, &frame, view, pose, mesh, material);
    for (int32_t row = 0; row < HEIGHT; row += 7) {
        qtri_surface band = c->surface;
        band.scissor.y0 = row;
        band.scissor.y1 = row + 7;
        qtri_draw_prepared(&band, &prepared);
    }
    qtri_prepared_mark(&prepared, &frame);
}

/* Planes that turn no face away, of a mesh that is larger than it says: as without them. */
TEST(planes_of_a_smaller_mesh)
{
    static const qtri_face8 none[TRIANGLES];
    int met = 0;
    for (int n = 0; n < 120; n++) {
        qtri_transform pose;
        const qtri_view view = view_of(1.2 + n % 40 * .06, &pose);
        qtri_mesh plain = cube();
        plain.colors = n % 3 == 1 ? colors : NULL;
        qtri_mesh wrong = plain;
        wrong.faces = (qtri_faces){&qtri_cull_by_planes, none, 1, 0, 1 << 14};
        wrong.extent = Q16(.01);
        qtri_material material = qtri_material_default();
        material.cull = n % 4 == 3 ? QTRI_CULL_FRONT : QTRI_CULL_BACK;
        material.fill = n % 2 == 0 ? NULL : &qtri_wireframe;
        canvas c[4] = {new_canvas(), new_canvas(), new_canvas(), new_canvas()};
        qtri_draw_mesh(&c[0].surface, &view, &pose, &plain, &material);
        qtri_draw_mesh(&c[1].surface, &view, &pose, &wrong, &material);
        assert_same_picture(&c[0].surface, &c[1].surface);
        draw_bands(&c[2], &wrong, &view, &pose, &material);
        assert_same_picture(&c[0].surface, &c[2].surface);
        qtri_outline outline;
        assert_ok(qtri_outline_init(&outline, &wrong, outline_memory, LENGTH_OF(outline_memory)));
        assert_ok(qtri_draw_mesh_outlined(&c[3].surface, &view, &pose, &material, &outline));
        assert_same_picture(&c[0].surface, &c[3].surface);
        met += count_drawn(&c[0]);
        for (int i = 0; i < 4; i++) {
            canvas_free(&c[i]);
        }
    }
    assert_true(met > 20000);
}

/* Of two triangles that nobody may see the planes say so, and what they span is not marked. */
TEST(vertices_that_were_never_met)
{
    static const qtri_face8 away[TRIANGLES] = {
        {0, 0, -120, 120}, {0, 0, -120, 120}, {0, 0, 120, 120}, {0, 0, 120, 120},
        {-120, 0, 0, 120}, {-120, 0, 0, 120}, {120, 0, 0, 120}, {120, 0, 0, 120},
        {0, -120, 0, 120}, {0, -120, 0, 120}, {0, 120, 0, 120}, {0, 120, 0, 120}};
    qtri_transform pose;
    const qtri_view view = view_of(6, &pose);
    qtri_mesh mesh = cube();
    mesh.triangle_count = 12;
    mesh.extent = Q16(1);
    mesh.faces = (qtri_faces){&qtri_cull_by_planes, away, 500, 2000, 29000};
    const qtri_material material = qtri_material_default();
    qtri_prepared prepared;
    qtri_frame frame;
    canvas c = new_canvas();
    prepared_init_with(&prepared, vertices, VERTICES, lists, LENGTH_OF(lists));
    assert_ok(qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, 7, c.memory, c.bytes));
    qtri_frame_begin(&frame);
    qtri_surface band;
    while (qtri_frame_next_band(&frame, &band)) {
    }
    qtri_frame_begin(&frame);
    qtri_prepare_mesh(&prepared, &frame, &view, &pose, &mesh, &material);
    qtri_prepared_mark(&prepared, &frame);
    const qtri_rect marked = qtri_frame_changes(&frame);
    int never = 0;
    for (int i = 0; i < VERTICES; i++) {
        never += vertices[i].depth_16p8 == QTRI_VERTEX_EMPTY;
    }
    assert_int_equal(never, 1); /* the corner behind: three faces are seen */
    canvas whole = new_canvas();
    qtri_draw_mesh(&whole.surface, &view, &pose, &mesh, &material);
    canvas empty = new_canvas();
    for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const int32_t x = i % WIDTH, y = i / WIDTH;
        if (stored_pixel(&whole.surface, x, y) != stored_pixel(&empty.surface, x, y)) {
            assert_true(x >= marked.x0 && x < marked.x1 && y >= marked.y0 && y < marked.y1);
        }
    }
    canvas_free(&c);
    canvas_free(&whole);
    canvas_free(&empty);
}

/* ---- Hidden lines ---- */

/* Depth is compared as the material says, and the lines' bias is towards the eye. */
TEST(hidden_lines_of_all_comparisons)
{
    static const qtri_compare near_ones[2] = {QTRI_LESS, QTRI_LESS_EQUAL};
    static const qtri_compare far_ones[2] = {QTRI_GREATER, QTRI_GREATER_EQUAL};
    qtri_transform pose;
    qtri_view view = view_of(6, &pose);
    const qtri_mesh mesh = cube();
    for (int n = 0; n < 2; n++) {
        qtri_material material = qtri_material_default();
        canvas c[2] = {new_canvas(), new_canvas()};
        material.cull = QTRI_CULL_NONE;
        material.depth_compare = near_ones[n];
        qtri_draw_hidden_lines(&c[0].surface, &view, &pose, &mesh, NULL, &material, Q16(.004));
        /* Depth the other way round, and its comparison: the same lines. */
        qtri_view inverted = view;
        inverted.viewport.depth_near = Q16(1);
        inverted.viewport.depth_far = 0;
        material.depth_compare = far_ones[n];
        clear_to(&c[1].surface, sky, 0);
        qtri_draw_hidden_lines(&c[1].surface, &inverted, &pose, &mesh, NULL, &material, Q16(.004));
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            assert_int_equal(stored_pixel(&c[0].surface, i % WIDTH, i / WIDTH),
                             stored_pixel(&c[1].surface, i % WIDTH, i / WIDTH));
        }
        assert_true(count_drawn(&c[0]) > 100);
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
}

/* Without a format there is nothing to draw on. */
TEST(hidden_lines_on_no_surface)
{
    qtri_transform pose;
    const qtri_view view = view_of(6, &pose);
    const qtri_mesh mesh = cube();
    const qtri_material material = qtri_material_default();
    canvas c = new_canvas();
    canvas empty = new_canvas();
    qtri_surface none = c.surface;
    none.format = NULL;
    qtri_draw_hidden_lines(&none, &view, &pose, &mesh, NULL, &material, Q16(.004));
    assert_same_picture(&empty.surface, &c.surface);
    canvas_free(&c);
    canvas_free(&empty);
}

/* What a texture leaves out hides nothing: by its key, or by its alpha. */
TEST(hidden_lines_through_holes)
{
    static const uint16_t holes[4] = {0, 0, 0, 0}, solid[4] = {0x8000, 0x8000, 0x8000, 0x8000};
    qtri_transform pose;
    const qtri_view view = view_of(6, &pose);
    qtri_mesh mesh = cube();
    mesh.uvs = cube_uvs;
    canvas c[5];
    for (int n = 0; n < 5; n++) {
        qtri_texture texture = {.format = &qtri_texel_argb1555,
                                .texels = n < 2 ? solid : holes,
                                .width_log2 = 1,
                                .height_log2 = 1,
                                .has_key = n == 2};
        qtri_material material = qtri_material_default();
        material.cull = QTRI_CULL_NONE;
        material.texture = n == 0 ? NULL : &texture;
        material.least_alpha = n == 1 || n == 3 ? 100 : 0;
        c[n] = new_canvas();
        qtri_draw_hidden_lines(&c[n].surface, &view, &pose, &mesh, NULL, &material, Q16(.004));
    }
    assert_same_picture(&c[0].surface, &c[1].surface); /* all of it hides */
    assert_same_picture(&c[2].surface, &c[3].surface); /* nothing does */
    assert_same_picture(&c[0].surface, &c[4].surface); /* alpha is not looked at */
    assert_true(count_drawn(&c[2]) > count_drawn(&c[0]) + 20);
    for (int n = 0; n < 5; n++) {
        canvas_free(&c[n]);
    }
}

/* ---- Strokes and points that are not there ---- */

static void draw_strokes(const qtri_surface *s, const qtri_stroke *stroke,
                         const qtri_material *material, uint32_t count)
{
    const qtri_corner corners[4] = {
        {.position = {Q16(-1), Q16(-1), Q16(-5), Q16(1)}, .color = {255, 0, 0}},
        {.position = {Q16(1), Q16(1), Q16(-5), Q16(1)}, .color = {0, 255, 0}},
        {.position = {Q16(1), Q16(-1), Q16(-5), Q16(1)}, .color = {0, 0, 255}},
        {.position = {Q16(-1), Q16(1), Q16(-5), Q16(1)}, .color = {255, 255, 0}}};
    qtri_transform pose;
    const qtri_view view = view_of(0, &pose);
    const qtri_mesh mesh = cube();
    qtri_transform_identity(&pose);
    qtri_draw_polyline(s, &view, &pose, corners, count, stroke, material);
    qtri_draw_wide_lines(s, &view, &pose, corners, count, stroke, material);
    qtri_draw_points(s, &view, &pose, corners, count, stroke, material);
    qtri_transform_translate(&pose, vec3_of(0, 0, -6));
    if (count > 0) {
        qtri_draw_wide_wireframe(s, &view, &pose, &mesh, stroke, material);
    }
}

TEST(strokes_of_nothing)
{
    for (int n = 0; n < 8; n++) {
        qtri_stroke stroke = qtri_stroke_default();
        qtri_material material = qtri_material_default();
        canvas c = new_canvas();
        canvas empty = new_canvas();
        stroke.width = Q16(3);
        qtri_surface s = c.surface;
        switch (n) {
        case 0:
            stroke.alpha = 0;
            break;
        case 1:
            material.depth_compare = QTRI_NEVER;
            break;
        case 2:
            s.scissor.x1 = s.scissor.x0;
            break;
        case 3:
            s.format = NULL;
            break;
        case 4:
            stroke.width = 0;
            break;
        case 5:
            stroke.width = Q16_MIN;
            break;
        default:
            break;
        }
        draw_strokes(&s, &stroke, &material, n == 6 ? 0 : 4);
        if (n < 7) {
            assert_same_picture(&empty.surface, &c.surface);
        } else {
            assert_true(count_drawn(&c) > 100);
        }
        canvas_free(&c);
        canvas_free(&empty);
    }
}

/* Wide wireframes: nothing of a mesh without triangles; those with wrong indices are skipped. */
TEST(wide_wireframes_of_wrong_meshes)
{
    static uint16_t wrong[TRIANGLES + 3][3];
    memcpy(wrong, cube_triangles, sizeof cube_triangles);
    wrong[TRIANGLES][0] = VERTICES;
    wrong[TRIANGLES + 1][1] = 65535;
    wrong[TRIANGLES + 2][2] = VERTICES;
    qtri_transform pose;
    qtri_stroke stroke = qtri_stroke_default();
    stroke.width = Q16(2.5);
    for (int n = 0; n < 8; n++) {
        qtri_view view = view_of(6, &pose);
        view.vertex_count = n & 1 ? 3 : view.vertex_count; /* by slots */
        qtri_mesh right = cube();
        right.colors = n & 2 ? colors : NULL;
        right.normals = n & 4 ? NULL : cube_normals;
        qtri_mesh more = right;
        more.triangles = (const uint16_t(*)[3])wrong;
        more.triangle_count = TRIANGLES + 3;
        qtri_mesh empty = right;
        empty.triangle_count = 0;
        const qtri_material material = qtri_material_default();
        canvas c[2] = {new_canvas(), new_canvas()};
        qtri_draw_wide_wireframe(&c[0].surface, &view, &pose, &right, &stroke, &material);
        qtri_draw_wide_wireframe(&c[1].surface, &view, &pose, &more, &stroke, &material);
        qtri_draw_wide_wireframe(&c[1].surface, &view, &pose, &empty, &stroke, &material);
        assert_same_picture(&c[0].surface, &c[1].surface);
        assert_true(count_drawn(&c[0]) > 100);
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
}

/* ---- Prepared meshes ---- */

/* Lights of colours, in bands with lists of few and of many triangles: those of the whole frame. */
/*
 * Edges of triangles beyond a band, in steps of 1/256 pixel to where their strokes do not reach it
 * any more: its rows are those of the whole frame.
 */
TEST(wide_edges_beside_a_band)
{
    static const uint16_t one[1][3] = {{0, 1, 2}};
    qtri_view view;
    qtri_transform identity;
    qtri_vertex slots[3];
    qtri_view_init(&view, 16, 64);
    give_vertices(&view, slots, 3);
    qtri_transform_identity(&identity);
    int reached = 0;
    for (int32_t n = 0; n < 2 * 700; n++) {
        const int32_t away = n / 2; /* 1/256 pixel from the band's rows 16..47 */
        const q16 edge = (q16)((n % 2 == 0 ? -16 * 256 - away : 16 * 256 + away) * 8);
        const q16 far = n % 2 == 0 ? -Q16(.95) : Q16(.95);
        const qtri_vec3 positions[3] = {{-Q16(.8), edge, 0}, {Q16(.8), edge, 0}, {0, far, 0}};
        const qtri_mesh mesh = {
            .positions = positions, .triangles = one, .vertex_count = 3, .triangle_count = 1};
        qtri_stroke stroke = qtri_stroke_default();
        qtri_material material = qtri_material_default();
        stroke.width = Q16(4);
        stroke.edges = n % 8 < 4 ? &qtri_stroke_smooth : NULL;
        stroke.cap = n % 16 < 8 ? QTRI_CAP_ROUND : QTRI_CAP_BUTT;
        material.cull = QTRI_CULL_NONE;
        canvas c[2] = {canvas_new(&qtri_xrgb8888, 16, 64),
                       canvas_band(&qtri_xrgb8888, 16, 64, 16, 32)};
        for (int i = 0; i < 2; i++) {
            qtri_draw_wide_wireframe(&c[i].surface, &view, &identity, &mesh, &stroke, &material);
        }
        assert_same_picture(&c[0].surface, &c[1].surface);
        const int32_t row = n % 2 == 0 ? 47 : 16;
        reached += stored_pixel(&c[1].surface, 8, row) != 0;
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
    assert_in_range(reached, 700, 1200); /* 512 of 700 on either side, less where centres count */
}

TEST(prepared_in_many_lights)
{
    static qtri_vec3 spread[3 * VERTICES];
    static qtri_normal up[3 * VERTICES];
    static uint16_t all[3 * TRIANGLES][3];
    static qtri_vertex room[QTRI_LIT_VERTICES(3 * VERTICES)];
    const qtri_light_source sources[2] = {{.kind = &qtri_directional_light,
                                           .position = vec3_of(1, 2, 2),
                                           .color = {Q16(.9), Q16(.4), 0}},
                                          {.kind = &qtri_point_light,
                                           .position = vec3_of(0, 1, -3),
                                           .color = {0, Q16(1), Q16(2)},
                                           .constant = Q16(1),
                                           .quadratic = Q16(.1)}};
    const qtri_light_color dark = {Q16(.1), Q16(.1), Q16(.1)};
    qtri_light lights;
    assert_ok(qtri_light_init(&lights, sources, 2, dark));
    for (int i = 0; i < 3 * VERTICES; i++) { /* one cube above, one in the frame, one below */
        spread[i] = cube_positions[i % VERTICES];
        spread[i].y += (i / VERTICES - 1) * Q16(5);
        up[i] = cube_normals[i % VERTICES];
    }
    for (int i = 0; i < 3 * TRIANGLES; i++) { /* in turn, so that groups have all three */
        for (int k = 0; k < 3; k++) {
            all[i][k] = (uint16_t)(cube_triangles[i / 3][k] + i % 3 * VERTICES);
        }
    }
    const uint32_t list_counts[4] = {0, 24, 40, 400};
    for (int n = 0; n < 32; n++) {
        qtri_transform pose;
        qtri_view view = view_of(n & 8 ? 3.5 : 7, &pose);
        view.light = &lights;
        give_vertices(&view, room, n & 16 ? 2 * VERTICES : LENGTH_OF(room));
        const qtri_mesh mesh = {.positions = spread,
                                .normals = up,
                                .triangles = (const uint16_t(*)[3])all,
                                .vertex_count = 3 * VERTICES,
                                .triangle_count = 3 * TRIANGLES};
        qtri_material material = qtri_material_default();
        material.shading = n & 4 ? QTRI_FLAT_FIRST : QTRI_SMOOTH;
        canvas c[2] = {new_canvas(), new_canvas()};
        qtri_draw_mesh(&c[0].surface, &view, &pose, &mesh, &material);
        qtri_prepared prepared;
        qtri_frame frame;
        prepared_init_with(&prepared, room, view.vertex_count, lists, list_counts[n & 3]);
        assert_ok(qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, 9, c[1].memory, c[1].bytes));
        qtri_frame_begin(&frame);
        qtri_prepare_mesh(&prepared, &frame, &view, &pose, &mesh, &material);
        for (int32_t row = 0; row < HEIGHT; row += 9) {
            qtri_surface band = c[1].surface;
            band.scissor.y0 = row;
            band.scissor.y1 = row + 9;
            qtri_draw_prepared(&band, &prepared);
        }
        assert_same_picture(&c[0].surface, &c[1].surface);
        assert_true(count_drawn(&c[0]) > 100);
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
}

/* Memory of light that something else has cleared since: what is drawn is black. */
TEST(prepared_light_that_was_lost)
{
    const qtri_light_source source = {
        .kind = &qtri_directional_light, .position = vec3_of(1, 2, 2), .color = {Q16(1), 0, 0}};
    const qtri_light_color dark = {0, 0, 0};
    qtri_light lights;
    qtri_transform pose;
    qtri_view view = view_of(5, &pose);
    const qtri_mesh mesh = cube();
    const qtri_material material = qtri_material_default();
    qtri_prepared prepared;
    qtri_frame frame;
    canvas c = new_canvas(), empty = new_canvas();
    assert_ok(qtri_light_init(&lights, &source, 1, dark));
    view.light = &lights;
    prepared_init_with(&prepared, vertices, LENGTH_OF(vertices), lists, LENGTH_OF(lists));
    assert_ok(qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, 40, c.memory, c.bytes));
    qtri_prepare_mesh(&prepared, &frame, &view, &pose, &mesh, &material);
    memset(&vertices[VERTICES], 0, sizeof vertices - VERTICES * sizeof vertices[0]);
    qtri_draw_prepared(&c.surface, &prepared);
    int black = 0;
    for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const uint32_t pixel = stored_pixel(&c.surface, i % WIDTH, i / WIDTH);
        assert_true(pixel == 0 || pixel == stored_pixel(&empty.surface, 0, 0));
        black += pixel == 0;
    }
    assert_true(black > 100);
    canvas_free(&c);
    canvas_free(&empty);
}

/* Surfaces of another width or height; rows behind the last band; memory for all that places can
   count. */
TEST(prepared_for_another_frame)
{
    static uint16_t many[70000];
    static const uint32_t counts[3] = {400, 69000, 70000};
    qtri_transform pose;
    const qtri_view view = view_of(5, &pose);
    const qtri_mesh mesh = cube();
    const qtri_material material = qtri_material_default();
    for (int n = 0; n < 3; n++) {
        qtri_prepared prepared;
        qtri_frame frame;
        canvas c[2] = {new_canvas(), new_canvas()};
        canvas empty = new_canvas();
        prepared_init_with(&prepared, vertices, VERTICES, many, counts[n]);
        qtri_prepared_set_outline(&prepared, NULL);
        assert_ok(qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, 7, c[0].memory, c[0].bytes));
        qtri_prepare_mesh(&prepared, &frame, &view, &pose, &mesh, &material);
        qtri_surface other = c[0].surface;
        other.width--;
        qtri_draw_prepared(&other, &prepared);
        other = c[0].surface;
        other.height--;
        qtri_draw_prepared(&other, &prepared);
        assert_same_picture(&empty.surface, &c[0].surface);
        for (int32_t row = 0; row < HEIGHT; row += 3) { /* of three rows, the last behind all */
            qtri_surface part = c[0].surface;
            part.scissor.y0 = row;
            part.scissor.y1 = row + 3;
            qtri_draw_prepared(&part, &prepared);
        }
        qtri_draw_mesh(&c[1].surface, &view, &pose, &mesh, &material);
        assert_same_picture(&c[1].surface, &c[0].surface);
        canvas_free(&c[0]);
        canvas_free(&c[1]);
        canvas_free(&empty);
    }
}

/* More triangles than the largest groups have room for: those that are in none are looked at. */
TEST(prepared_with_the_largest_groups)
{
    enum { MANY = 300000 };
    static uint16_t all[MANY][3]; /* nothing but the last ones has an area */
    memcpy(all[MANY - TRIANGLES], cube_triangles, sizeof cube_triangles);
    qtri_transform pose;
    const qtri_view view = view_of(5, &pose);
    qtri_mesh mesh = cube();
    const qtri_material material = qtri_material_default();
    canvas c[2] = {new_canvas(), new_canvas()};
    qtri_draw_mesh(&c[0].surface, &view, &pose, &mesh, &material);
    mesh.triangles = (const uint16_t(*)[3])all;
    mesh.triangle_count = MANY;
    qtri_prepared prepared;
    qtri_frame frame;
    assert_ok(qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, 40, c[1].memory, c[1].bytes));
    prepared_init_with(&prepared, vertices, VERTICES, lists, 16);
    qtri_prepare_mesh(&prepared, &frame, &view, &pose, &mesh, &material);
    qtri_draw_prepared(&c[1].surface, &prepared);
    assert_same_picture(&c[0].surface, &c[1].surface);
    canvas_free(&c[0]);
    canvas_free(&c[1]);
}

/* Bands of one row: more lists than there are blocks. And a frame that has lost its rows. */
TEST(prepared_in_rows)
{
    static const uint32_t counts[4] = {88, 150, 200, 400};
    qtri_transform pose;
    const qtri_view view = view_of(5, &pose);
    const qtri_mesh mesh = cube();
    const qtri_material material = qtri_material_default();
    for (int n = 0; n < 5; n++) {
        qtri_prepared prepared;
        qtri_frame frame;
        canvas c[2] = {new_canvas(), new_canvas()};
        canvas empty = new_canvas();
        prepared_init_with(&prepared, vertices, VERTICES, lists, counts[n & 3]);
        assert_ok(qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, 1, c[0].memory, c[0].bytes));
        frame.height = n < 4 ? HEIGHT : 0;
        qtri_prepare_mesh(&prepared, &frame, &view, &pose, &mesh, &material);
        for (int32_t row = 0; row < HEIGHT; row++) {
            qtri_surface band = c[0].surface;
            band.scissor.y0 = row;
            band.scissor.y1 = row + 1;
            band.height = n < 4 ? HEIGHT : 0;
            qtri_draw_prepared(&band, &prepared);
        }
        qtri_draw_mesh(&c[1].surface, &view, &pose, &mesh, &material);
        assert_same_picture(n < 4 ? &c[1].surface : &empty.surface, &c[0].surface);
        canvas_free(&c[0]);
        canvas_free(&c[1]);
        canvas_free(&empty);
    }
}

/* ---- Memory that is laid out otherwise ---- */

/* Rows far apart, upside down, or not as far apart as those of depth; depth that is not written. */
TEST(surfaces_of_any_pitch)
{
    enum { FAR = 70000 };
    static uint16_t far[FAR / 2 * HEIGHT];
    qtri_transform pose;
    const qtri_view view = view_of(5, &pose);
    for (int n = 0; n < 12; n++) {
        canvas c = new_canvas();
        qtri_surface s = c.surface;
        const int32_t first = n % 4 == 1 ? HEIGHT - 1 : 0; /* bottom-up */
        const bool only_pixels = n >= 8;
        s.pitch = n % 4 == 3 ? 2 * (WIDTH + 1) : (n % 4 == 1 ? -FAR : FAR);
        s.pixels = (uint8_t *)far + first * (ptrdiff_t)FAR;
        if (n % 4 == 0 || n % 4 == 1) { /* as far apart as depths, which have their own place */
            s.depth = NULL;
        }
        qtri_material material = qtri_material_default();
        material.fill = n & 4 ? &qtri_wireframe : NULL;
        material.depth_read_only = only_pixels;
        material.depth_compare = s.depth == NULL ? QTRI_DEPTH_OFF : QTRI_LESS;
        const qtri_mesh mesh = cube();
        qtri_surface_clear(&s, sky);
        canvas want = new_canvas();
        want.surface.depth = s.depth == NULL ? NULL : want.surface.depth;
        qtri_draw_mesh(&s, &view, &pose, &mesh, &material);
        qtri_draw_mesh(&want.surface, &view, &pose, &mesh, &material);
        for (int32_t y = 0; y < HEIGHT; y++) {
            assert_memory_equal(s.pixels + y * s.pitch, want.surface.pixels + y * 2 * WIDTH,
                                2 * WIDTH);
            for (int32_t x = 0; x < WIDTH && only_pixels; x++) {
                assert_int_equal(c.surface.depth[y * WIDTH + x], 65535);
            }
        }
        canvas_free(&want);
        canvas_free(&c);
    }
}

/* Blended edges are drawn by every triangle that has them, in bands as in the frame. */
TEST(blended_wireframes)
{
    static const qtri_compare compares[3] = {QTRI_LESS, QTRI_LESS_EQUAL, QTRI_DEPTH_OFF};
    qtri_transform pose;
    const qtri_view view = view_of(5, &pose);
    const qtri_mesh mesh = cube();
    for (int n = 0; n < 3; n++) {
        canvas c[2] = {new_canvas(), new_canvas()};
        qtri_material material = qtri_material_default();
        material.fill = &qtri_wireframe;
        material.blend = &qtri_blend_alpha;
        material.alpha = 100;
        material.depth_compare = compares[n];
        qtri_draw_mesh(&c[0].surface, &view, &pose, &mesh, &material);
        draw_bands(&c[1], &mesh, &view, &pose, &material);
        assert_same_picture(&c[0].surface, &c[1].surface);
        assert_true(count_drawn(&c[0]) > 50);
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
}

/* ---- Boxes ---- */

/* A mesh with bounds, moved out of the frame by parts of a pixel: as one without. */
TEST(samples_beside_the_frame)
{
    static uint32_t memory[2][QTRI_BAND_BYTES(WIDTH, HEIGHT, QTRI_RGB565_X4_BYTES) / 4];
    const qtri_material material = qtri_material_default();
    int seen = 0;
    for (int n = 0; n < 24; n++) {
        qtri_surface s[2];
        qtri_mesh mesh = cube();
        qtri_transform pose;
        qtri_view view = view_of(5, &pose);
        qtri_transform_identity(&pose);
        qtri_transform_translate(&pose, vec3_of(-3.15 - n * .008, 0, -5));
        for (int i = 0; i < 2; i++) {
            assert_ok(qtri_surface_init(&s[i], &qtri_rgb565_x4, WIDTH, HEIGHT, 0, HEIGHT, memory[i],
                                        sizeof memory[i]));
            qtri_samples_clear(&s[i], sky);
            mesh.bounds.half = i == 0 ? vec3_of(0, 0, 0) : vec3_of(1, 1, 1);
            qtri_draw_mesh(&s[i], &view, &pose, &mesh, &material);
            assert_ok(qtri_samples_resolve(&s[i], &s[i]));
        }
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const uint32_t pixel = stored_pixel(&s[0], i % WIDTH, i / WIDTH);
            assert_int_equal(pixel, stored_pixel(&s[1], i % WIDTH, i / WIDTH));
            seen += i % WIDTH == 0 && pixel != stored_pixel(&s[0], WIDTH - 1, 0);
        }
    }
    assert_in_range(seen, 10, 24 * HEIGHT - 10);
}

TEST(default_material)
{
    const qtri_material m = qtri_material_default();
    assert_int_equal(m.alpha, 255);
    assert_true(m.color.r == 255 && m.color.g == 255 && m.color.b == 255);
    assert_true(m.texture == NULL && m.fill == NULL && m.reflection == NULL);
    assert_int_equal(m.shading, QTRI_SMOOTH);
    assert_int_equal(m.cull, QTRI_CULL_BACK);
    assert_int_equal(m.depth_compare, QTRI_LESS);
    assert_false(m.depth_read_only);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
