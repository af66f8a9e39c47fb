/* SPDX-License-Identifier: MIT */
/*
 * Outlines: what is no outline, and says so; memory of any size; surfaces and bands that lists were
 * not made for. The picture of edges is always that of the whole frame without lists.
 */
#include "support/core.h"
#include "support/layouts.h"

#include "tools/mesh_faces.h"
#include "tools/mesh_neighbours.h"

#include <qtri/antialias.h>
#include <qtri/frame.h>
#include <qtri/prepared.h>
#include <qtri/shapes.h>

enum { WIDTH = 50, HEIGHT = 44, SIDE = 5, VERTICES = 6 * SIDE * SIDE, CELLS = SIDE - 1 };
enum { TRIANGLES = 12 * CELLS * CELLS, WORDS = 9000 };

static const qtri_rgb sky = {10, 20, 60};
static const qtri_light sun = {
    .towards = {Q16(.3), Q16(.5), Q16(.8)}, .ambient = Q16(.1), .diffuse = Q16(.9)};

static qtri_vec3 positions[VERTICES];
static uint16_t triangles[TRIANGLES][3], neighbours[TRIANGLES][3];
static qtri_vertex vertices[VERTICES];
static uint32_t outline_memory[WORDS], edge_memory[WORDS];
static uint16_t lists[4000];

/* A cube of six grids: edges within it are creases or none. */
static int make_cube(void **state)
{
    (void)state;
    for (int face = 0; face < 6; face++) {
        for (int i = 0; i < SIDE * SIDE; i++) {
            const int axis = face / 2, sign = face & 1 ? 1 : -1;
            q16 p[3];
            p[axis] = sign * 65536;
            p[(axis + 1) % 3] = sign * (i % SIDE * 2 - CELLS) * 65536 / CELLS;
            p[(axis + 2) % 3] = (i / SIDE * 2 - CELLS) * 65536 / CELLS;
            positions[face * SIDE * SIDE + i] = (qtri_vec3){p[0], p[1], p[2]};
        }
        for (int cell = 0; cell < CELLS * CELLS; cell++) {
            const int at = face * SIDE * SIDE + cell / CELLS * SIDE + cell % CELLS;
            const uint16_t corner[4] = {(uint16_t)at, (uint16_t)(at + 1), (uint16_t)(at + SIDE + 1),
                                        (uint16_t)(at + SIDE)};
            uint16_t(*t)[3] = &triangles[2 * (face * CELLS * CELLS + cell)];
            for (int k = 0; k < 3; k++) {
                t[0][k] = corner[k];
                t[1][k] = corner[k == 0 ? 0 : k + 1];
            }
        }
    }
    qtri_mesh mesh = {.positions = positions,
                      .triangles = (const uint16_t(*)[3])triangles,
                      .vertex_count = VERTICES,
                      .triangle_count = TRIANGLES};
    return mesh_neighbours_make(&mesh, neighbours) ? 0 : 1;
}

static qtri_mesh cube(bool has_neighbours)
{
    const qtri_mesh mesh = {.positions = positions,
                            .triangles = (const uint16_t(*)[3])triangles,
                            .vertex_count = VERTICES,
                            .triangle_count = TRIANGLES,
                            .neighbours = has_neighbours ? (const uint16_t(*)[3])neighbours : NULL};
    return mesh;
}

static qtri_view view_of(double x, double distance, qtri_transform *pose)
{
    qtri_view view;
    qtri_view_init(&view, WIDTH, HEIGHT);
    qtri_transform_perspective(&view.projection, Q16(50), Q16(1.2), Q16(.5), Q16(40));
    view.light = &sun;
    give_vertices(&view, vertices, VERTICES);
    qtri_transform_identity(pose);
    qtri_transform_translate(pose, vec3_of(x, .1, -distance));
    qtri_transform_rotate_y(pose, Q16(33));
    qtri_transform_rotate_x(pose, Q16(21));
    return view;
}

static canvas new_canvas(const qtri_compare compare)
{
    canvas c = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    const bool is_far = compare == QTRI_GREATER || compare == QTRI_GREATER_EQUAL;
    clear_to(&c.surface, sky, is_far ? 0 : 65535);
    return c;
}

static void blend_edges(const qtri_surface *s, const qtri_outline *outline)
{
    qtri_edges edges;
    assert_ok(qtri_edges_begin(&edges, s, edge_memory, WORDS));
    qtri_edges_note(&edges, outline);
    qtri_edges_blend(&edges);
}

/* ---- Arguments ---- */

TEST(outlines_that_cannot_be)
{
    static uint16_t wrong[TRIANGLES][3];
    qtri_outline outline;
    qtri_mesh mesh = cube(true);
    for (int corner = 0; corner < 3; corner++) {
        memcpy(wrong, neighbours, sizeof wrong);
        wrong[9][corner] = TRIANGLES + 1;
        mesh.neighbours = (const uint16_t(*)[3])wrong;
        assert_int_equal(qtri_outline_init(&outline, &mesh, outline_memory, WORDS),
                         QTRI_ERROR_SIZE);
    }
    mesh.triangle_count = 65536;
    assert_int_equal(qtri_outline_init(&outline, &mesh, outline_memory, WORDS), QTRI_ERROR_SIZE);
    mesh = cube(false);
    const uint32_t front = QTRI_OUTLINE_WORDS(TRIANGLES), sums = QTRI_OUTLINE_SUMS(VERTICES);
    assert_int_equal(qtri_outline_init(&outline, &mesh, outline_memory, front - 1),
                     QTRI_ERROR_MEMORY);
    assert_int_equal(qtri_outline_init(&outline, &mesh, outline_memory, front + sums - 1),
                     QTRI_ERROR_MEMORY);
    assert_ok(qtri_outline_init(&outline, &mesh, outline_memory, front + sums));
}

/* Whatever goes wrong, edges change nothing. */
TEST(prepared_outlines_that_cannot_be)
{
    static uint32_t more_memory[WORDS];
    static qtri_vertex few[VERTICES];
    qtri_transform pose;
    qtri_mesh mesh = cube(true);
    const qtri_mesh other = cube(true);
    mesh.bounds.half = vec3_of(1, 1, 1);
    for (int n = 0; n < 7; n++) {
        const qtri_view view = view_of(0, n == 4 ? -6 : 5, &pose);
        qtri_material material = qtri_material_default();
        qtri_prepared prepared;
        qtri_outline outline, second;
        qtri_frame frame;
        canvas c[2] = {new_canvas(QTRI_LESS), new_canvas(QTRI_LESS)};
        assert_int_equal(qtri_outline_init(&outline, n == 1 ? &other : &mesh, outline_memory,
                                           n == 0 ? 1 : WORDS),
                         n == 0 ? QTRI_ERROR_MEMORY : QTRI_OK);
        assert_ok(qtri_outline_init(&second, &mesh, more_memory, WORDS));
        assert_ok(
            qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, 11, c[0].memory, c[0].bytes));
        prepared_init_with(&prepared, few, n == 3 ? VERTICES - 1 : VERTICES, lists,
                           LENGTH_OF(lists));
        qtri_prepared_set_outline(&prepared, n == 2 ? &second : &outline);
        material.fill = n == 5 ? &qtri_wireframe : NULL;
        material.depth_compare = n == 6 ? QTRI_NEVER : QTRI_LESS;
        qtri_prepare_mesh(&prepared, &frame, &view, &pose, &mesh, &material);
        assert_int_equal(qtri_prepared_find_edges(&prepared, &outline),
                         n < 4 ? QTRI_ERROR_MEMORY : QTRI_OK);
        qtri_draw_prepared(&c[0].surface, &prepared);
        qtri_draw_prepared(&c[1].surface, &prepared);
        blend_edges(&c[1].surface, &outline);
        assert_int_equal(count_different(&c[0].surface, &c[1].surface), 0);
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
}

/* A fill has no outline, and neither has what cannot be seen; the mesh is drawn as without. */
TEST(drawn_outlines_that_cannot_be)
{
    for (int n = 0; n < 8; n++) {
        qtri_transform pose;
        qtri_view view = view_of(0, n / 2 == 1 ? -6 : 5, &pose);
        qtri_mesh mesh = cube(true);
        qtri_material material = qtri_material_default();
        qtri_outline outline;
        canvas c[2] = {new_canvas(QTRI_LESS), new_canvas(QTRI_LESS)};
        mesh.bounds.half = vec3_of(1, 1, 1);
        material.fill = n < 2 ? &qtri_wireframe : NULL;
        view.vertex_count = n / 2 == 2 ? VERTICES - 1 : VERTICES;
        assert_ok(qtri_outline_init(&outline, &mesh, outline_memory, WORDS));
        qtri_draw_mesh(&c[0].surface, &view, &pose, &mesh, &material);
        const enum qtri_error error = n / 2 == 2 ? QTRI_ERROR_MEMORY : QTRI_OK;
        if (n & 1) { /* without drawing */
            qtri_draw_mesh(&c[1].surface, &view, &pose, &mesh, &material);
            assert_int_equal(qtri_find_outline(&c[1].surface, &view, &pose, &material, &outline),
                             error);
        } else {
            assert_int_equal(
                qtri_draw_mesh_outlined(&c[1].surface, &view, &pose, &material, &outline), error);
        }
        assert_same_picture(&c[0].surface, &c[1].surface);
        blend_edges(&c[1].surface, &outline);
        assert_int_equal(count_different(&c[0].surface, &c[1].surface) > 20, n >= 6);
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
}

/* Triangles with indices past the end are skipped, whatever their neighbours and sums. */
TEST(wrong_indices_have_no_edges)
{
    enum { WRONG = 48, MORE = TRIANGLES + WRONG };
    static uint16_t all[MORE][3], around[MORE][3];
    static qtri_face8 planes[MORE];
    qtri_mesh with_planes = cube(false);
    with_planes.extent = Q16(1);
    assert_true(mesh_faces_fill(&with_planes, planes) > 0);
    with_planes.faces.culling = &qtri_cull_by_planes;
    memcpy(all, triangles, sizeof triangles);
    memcpy(around, neighbours, sizeof neighbours);
    for (int i = 0; i < TRIANGLES; i++) {
        for (int k = 0; k < 3; k++) {
            around[i][k] = neighbours[i][k] == TRIANGLES ? MORE : neighbours[i][k];
        }
    }
    for (int i = 0; i < WRONG; i++) { /* one index each; none has a neighbour */
        for (int k = 0; k < 3; k++) {
            all[TRIANGLES + i][k] = (uint16_t)(i % 3 == k ? VERTICES : (3 * i + k) % VERTICES);
            around[TRIANGLES + i][k] = MORE;
        }
        planes[TRIANGLES + i] = planes[i * (TRIANGLES / WRONG)]; /* some face the eye */
    }
    for (int n = 0; n < 8; n++) {
        qtri_transform pose;
        const qtri_view view = view_of(0, 5, &pose);
        qtri_mesh mesh[2] = {cube(n & 1), cube(n & 1)};
        qtri_material material = qtri_material_default();
        canvas c[2];
        if (n & 4) {
            mesh[1].faces = with_planes.faces;
            mesh[1].extent = with_planes.extent;
        }
        material.cull = n & 2 ? QTRI_CULL_NONE : QTRI_CULL_BACK;
        mesh[1].triangles = (const uint16_t(*)[3])all;
        mesh[1].triangle_count = MORE;
        mesh[1].neighbours = n & 1 ? (const uint16_t(*)[3])around : NULL;
        for (int i = 0; i < 2; i++) {
            qtri_outline outline;
            c[i] = new_canvas(QTRI_LESS);
            assert_ok(qtri_outline_init(&outline, &mesh[i], outline_memory, WORDS));
            assert_ok(qtri_draw_mesh_outlined(&c[i].surface, &view, &pose, &material, &outline));
            blend_edges(&c[i].surface, &outline);
        }
        assert_int_equal(count_different(&c[0].surface, &c[1].surface), 0);
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
}

/* Front faces of a mesh of many words of bits are those that are found without planes. */
TEST(planes_of_a_large_mesh_leave_its_outline)
{
    enum { SLICES = 32, RINGS = 24, FACES = QTRI_TORUS_TRIANGLES(SLICES, RINGS) };
    enum { POINTS = QTRI_TORUS_VERTICES(SLICES, RINGS), MEMORY = 8 * FACES };
    static qtri_vec3 points[POINTS];
    static uint16_t faces[FACES][3];
    static qtri_face8 planes[FACES];
    static qtri_vertex slots[POINTS];
    static uint32_t memory[MEMORY];
    const qtri_shape_memory shape = {
        .positions = points, .triangles = faces, .vertices = POINTS, .triangle_count = FACES};
    qtri_mesh mesh;
    qtri_material material = qtri_material_default();
    material.cull = QTRI_CULL_BACK;
    assert_ok(qtri_shape_torus(&mesh, &shape, Q16(1), Q16(.4), SLICES, RINGS));
    mesh.extent = Q16(2);
    assert_true(mesh_faces_fill(&mesh, planes) > 0);
    for (int n = 0; n < 4; n++) {
        qtri_transform pose;
        qtri_view view = view_of(n * .1, 4, &pose);
        canvas c[2];
        give_vertices(&view, slots, POINTS);
        for (int i = 0; i < 2; i++) {
            qtri_outline outline;
            c[i] = new_canvas(QTRI_LESS);
            mesh.faces.culling = i == 0 ? NULL : &qtri_cull_by_planes;
            assert_ok(qtri_outline_init(&outline, &mesh, memory, MEMORY));
            assert_ok(qtri_draw_mesh_outlined(&c[i].surface, &view, &pose, &material, &outline));
            blend_edges(&c[i].surface, &outline);
        }
        assert_int_equal(count_different(&c[0].surface, &c[1].surface), 0);
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
}

/* ---- Surfaces ---- */

/* No edge is noted on a surface of another size, or where there is nothing to be changed. */
TEST(surfaces_of_other_sizes)
{
    qtri_transform pose;
    const qtri_view view = view_of(0, 5, &pose);
    const qtri_mesh mesh = cube(true);
    const qtri_material material = qtri_material_default();
    qtri_outline outline;
    canvas c[2] = {new_canvas(QTRI_LESS), new_canvas(QTRI_LESS)};
    assert_ok(qtri_outline_init(&outline, &mesh, outline_memory, WORDS));
    for (int i = 0; i < 2; i++) {
        assert_ok(qtri_draw_mesh_outlined(&c[i].surface, &view, &pose, &material, &outline));
    }
    for (int n = 0; n < 3; n++) {
        qtri_surface other = c[1].surface;
        uint16_t depths[WIDTH * HEIGHT];
        memcpy(depths, c[1].surface.depth, sizeof depths);
        other.width -= n == 0;
        other.height -= n == 1;
        other.depth_pitch -= n == 0; /* as it must be */
        other.scissor.x1 = n == 2 ? 0 : other.scissor.x1;
        blend_edges(&other, &outline);
        memcpy(c[1].surface.depth, depths, sizeof depths);
    }
    assert_int_equal(count_different(&c[0].surface, &c[1].surface), 0);
    canvas_free(&c[0]);
    canvas_free(&c[1]);
}

static const qtri_compare compares[7] = {QTRI_LESS,      QTRI_LESS_EQUAL,    QTRI_GREATER,
                                         QTRI_DEPTH_OFF, QTRI_GREATER_EQUAL, QTRI_ALWAYS,
                                         QTRI_EQUAL};

/*
 * Lists are for bands of so many rows and a halo: parts of a frame that are cut otherwise, the
 * whole frame among them, look at all triangles. Memory for more entries than there can be.
 */
TEST(parts_that_have_no_list)
{
    int changed = 0;
    for (int n = 0; n < 42; n++) {
        const qtri_compare compare = compares[n % 7];
        qtri_transform pose;
        const qtri_view view = view_of(n * .1, 4, &pose);
        const qtri_mesh mesh = cube(n & 1);
        qtri_material material = qtri_material_default();
        canvas whole = new_canvas(compare), parts = new_canvas(compare),
               plain = new_canvas(compare);
        qtri_outline outline;
        qtri_prepared prepared;
        qtri_frame frame;
        material.depth_compare = compare;
        material.shading = QTRI_FLAT_LAST;
        /* With room for the lists of silhouettes and for some creases, too. */
        const uint32_t least =
            QTRI_OUTLINE_WORDS(TRIANGLES) + (n & 1 ? 0 : QTRI_OUTLINE_SUMS(VERTICES));
        assert_ok(qtri_outline_init(&outline, &mesh, outline_memory,
                                    n < 28 ? WORDS : least + 10 + 4 * (uint32_t)(n - 28)));
        outline.creases = n >= 14;
        assert_ok(qtri_draw_mesh_outlined(&whole.surface, &view, &pose, &material, &outline));
        blend_edges(&whole.surface, &outline);
        assert_ok(
            qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, 9, plain.memory, plain.bytes));
        assert_ok(qtri_frame_set_overlap(&frame, n % 3, NULL, 0));
        prepared_init_with(&prepared, vertices, VERTICES, lists, LENGTH_OF(lists));
        qtri_prepared_set_outline(&prepared, &outline);
        qtri_prepare_mesh(&prepared, &frame, &view, &pose, &mesh, &material);
        assert_ok(qtri_prepared_find_edges(&prepared, &outline));
        qtri_draw_prepared(&plain.surface, &prepared);
        /* All at once, then in parts of five rows with a halo of two, that begin anywhere. */
        qtri_draw_prepared(&parts.surface, &prepared);
        blend_edges(&parts.surface, &outline);
        assert_int_equal(count_different(&whole.surface, &parts.surface), 0);
        changed += count_different(&whole.surface, &plain.surface);
        for (int32_t row = 0; row < HEIGHT; row += 5) {
            canvas c = new_canvas(compare);
            c.surface.scissor.y0 = row - 2;
            c.surface.scissor.y1 = row + 7;
            qtri_draw_prepared(&c.surface, &prepared);
            qtri_surface last = c.surface; /* the frame's last row alone has nothing beside it */
            last.scissor.y0 = row == 0 ? HEIGHT - 1 : HEIGHT;
            last.scissor.y1 = HEIGHT;
            blend_edges(&last, &outline);
            blend_edges(&c.surface, &outline);
            for (int32_t i = row * WIDTH; i < (row + 5) * WIDTH && i < WIDTH * HEIGHT; i++) {
                assert_int_equal(stored_pixel(&whole.surface, i % WIDTH, i / WIDTH),
                                 stored_pixel(&c.surface, i % WIDTH, i / WIDTH));
            }
            canvas_free(&c);
        }
        canvas_free(&whole);
        canvas_free(&parts);
        canvas_free(&plain);
    }
    assert_true(changed > 1000);
}

/* Any rows of a frame, taller than a band with its halo or in the last one's halo below the frame:
   the edges that lists have are those that are found without. */
TEST(any_rows_have_all_edges)
{
    int changed = 0;
    for (int n = 0; n < 10; n++) {
        qtri_transform pose;
        const qtri_view view = view_of(n * .1, 3, &pose);
        const qtri_mesh mesh = cube(n & 1);
        qtri_material material = qtri_material_default();
        canvas drawn = new_canvas(QTRI_LESS), c[2] = {new_canvas(QTRI_LESS), new_canvas(QTRI_LESS)};
        qtri_outline outline;
        qtri_prepared prepared;
        qtri_frame frame;
        material.shading = QTRI_FLAT_LAST;
        assert_ok(qtri_outline_init(&outline, &mesh, outline_memory, WORDS));
        outline.creases = true;
        assert_ok(
            qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, 9, drawn.memory, drawn.bytes));
        assert_ok(qtri_frame_set_overlap(&frame, n % 5, NULL, 0));
        prepared_init_with(&prepared, vertices, VERTICES, lists, LENGTH_OF(lists));
        qtri_prepared_set_outline(&prepared, &outline);
        qtri_prepare_mesh(&prepared, &frame, &view, &pose, &mesh, &material);
        assert_ok(qtri_prepared_find_edges(&prepared, &outline));
        assert_int_equal(outline.rows, 9);
        qtri_outline unlisted = outline;
        unlisted.rows = 0;
        qtri_draw_prepared(&drawn.surface, &prepared);
        for (int32_t i = 0; i < 18 * HEIGHT; i++) {
            const qtri_rect rows = {0, i % HEIGHT, WIDTH, i % HEIGHT + 2 + i / HEIGHT};
            for (int k = 0; k < 2; k++) {
                memcpy(c[k].memory, drawn.memory, drawn.bytes);
                c[k].surface.scissor = rows;
                blend_edges(&c[k].surface, k == 0 ? &outline : &unlisted);
            }
            assert_int_equal(count_different(&c[0].surface, &c[1].surface), 0);
            changed += count_different(&c[0].surface, &drawn.surface) > 0;
        }
        canvas_free(&drawn);
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
    assert_true(changed > 1000);
}

/* Edges above and below the frame are in no list, and others are in theirs. */
TEST(edges_beside_the_frame_are_not_listed)
{
    const qtri_material material = qtri_material_default();
    static uint32_t memory[QTRI_BAND_BYTES(WIDTH, HEIGHT, QTRI_RGB565_BYTES) / 4];
    for (int n = -12; n <= 12; n++) {
        qtri_transform pose, moved, above;
        const qtri_view view = view_of(0, 4, &pose);
        const qtri_mesh mesh = cube(n & 1);
        qtri_outline outline;
        qtri_prepared prepared;
        qtri_frame frame;
        qtri_transform_identity(&above);
        qtri_transform_translate(&above, vec3_of(0, n * .2, 0));
        qtri_transform_mul(&moved, &above, &pose);
        assert_ok(qtri_outline_init(&outline, &mesh, outline_memory, WORDS));
        assert_ok(qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, 9, memory, sizeof memory));
        prepared_init_with(&prepared, vertices, VERTICES, lists, LENGTH_OF(lists));
        qtri_prepared_set_outline(&prepared, &outline);
        qtri_prepare_mesh(&prepared, &frame, &view, &moved, &mesh, &material);
        assert_ok(qtri_prepared_find_edges(&prepared, &outline));
        assert_int_equal(outline.rows, 9);
    }
}

/* Lists of a mesh that has been prepared behind the eye since: none of their edges is noted. */
TEST(lists_of_an_earlier_pose_are_left)
{
    const qtri_material material = qtri_material_default();
    qtri_transform pose;
    const qtri_view view = view_of(0, 4, &pose);
    const qtri_mesh mesh = cube(true);
    canvas c = new_canvas(QTRI_LESS), plain = new_canvas(QTRI_LESS);
    qtri_outline outline;
    qtri_prepared prepared;
    qtri_frame frame;
    assert_ok(qtri_outline_init(&outline, &mesh, outline_memory, WORDS));
    assert_ok(qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, HEIGHT, c.memory, c.bytes));
    prepared_init_with(&prepared, vertices, VERTICES, lists, LENGTH_OF(lists));
    qtri_prepared_set_outline(&prepared, &outline);
    qtri_prepare_mesh(&prepared, &frame, &view, &pose, &mesh, &material);
    assert_ok(qtri_prepared_find_edges(&prepared, &outline));
    for (int is_behind = 0; is_behind < 2; is_behind++) {
        if (is_behind) {
            qtri_transform_identity(&pose);
            qtri_transform_translate(&pose, vec3_of(0, 0, 4));
            qtri_prepare_mesh(&prepared, &frame, &view, &pose, &mesh, &material);
        }
        clear_to(&c.surface, sky, 65535);
        clear_to(&plain.surface, sky, 65535);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i += 3) {
            memset(c.surface.pixels + 2 * (ptrdiff_t)i, 0xF0, 2);
            memset(plain.surface.pixels + 2 * (ptrdiff_t)i, 0xF0, 2);
        }
        blend_edges(&c.surface, &outline);
        assert_int_equal(count_different(&c.surface, &plain.surface) == 0, is_behind);
    }
    canvas_free(&c);
    canvas_free(&plain);
}

/* An outline that has been drawn once more is that of the last drawing: not of lists made before,
   and of a fill none. */
static void assert_last_drawing_has_outline(bool has_neighbours)
{
    static uint32_t memory[QTRI_BAND_BYTES(WIDTH, HEIGHT, QTRI_RGB565_BYTES) / 4];
    qtri_transform first, second;
    const qtri_view view = view_of(0, 4, &first), other = view_of(.4, 3, &second);
    const qtri_mesh mesh = cube(has_neighbours);
    qtri_material material = qtri_material_default();
    canvas c[2] = {new_canvas(QTRI_LESS), new_canvas(QTRI_LESS)};
    qtri_outline outline;
    qtri_prepared prepared;
    qtri_frame frame;
    for (int i = 0; i < 2; i++) { /* the second time there are lists of another pose */
        assert_ok(qtri_outline_init(&outline, &mesh, outline_memory, WORDS));
        if (i == 1) {
            assert_ok(
                qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, 9, memory, sizeof memory));
            prepared_init_with(&prepared, vertices, VERTICES, lists, LENGTH_OF(lists));
            qtri_prepared_set_outline(&prepared, &outline);
            qtri_prepare_mesh(&prepared, &frame, &view, &first, &mesh, &material);
            assert_ok(qtri_prepared_find_edges(&prepared, &outline));
        }
        assert_ok(qtri_draw_mesh_outlined(&c[i].surface, &other, &second, &material, &outline));
        for (int32_t row = 0; row < HEIGHT; row += 9) {
            qtri_surface part = c[i].surface;
            part.scissor.y0 = row;
            part.scissor.y1 = row + 9 < HEIGHT ? row + 9 : HEIGHT;
            blend_edges(&part, &outline);
        }
    }
    assert_int_equal(count_different(&c[0].surface, &c[1].surface), 0);
    material.fill = &qtri_wireframe;
    for (int i = 0; i < 2; i++) {
        clear_to(&c[i].surface, sky, 65535);
        (void)qtri_draw_mesh_outlined(&c[i].surface, &other, &second, &material, &outline);
    }
    blend_edges(&c[0].surface, &outline);
    assert_int_equal(count_different(&c[0].surface, &c[1].surface), 0);
    canvas_free(&c[0]);
    canvas_free(&c[1]);
}

TEST(the_last_drawing_has_the_outline)
{
    assert_last_drawing_has_outline(true);
    assert_last_drawing_has_outline(false);
}

/* The mesh with its outline in a whole frame, and in bands. */
static void draw_frame_and_bands(canvas *whole, canvas *banded, const qtri_mesh *mesh,
                                 const qtri_material *material, double distance)
{
    qtri_transform pose;
    const qtri_view view = view_of(.3, distance, &pose);
    qtri_outline outline;
    qtri_prepared prepared;
    qtri_frame frame;
    qtri_surface band, shown;
    static uint32_t memory[QTRI_FRAME_BYTES(WIDTH, 9 + 2 * 1, QTRI_RGB565_BYTES) / 4];
    *whole = new_canvas(QTRI_LESS);
    *banded = new_canvas(QTRI_LESS);
    assert_ok(qtri_outline_init(&outline, mesh, outline_memory, WORDS));
    assert_ok(qtri_draw_mesh_outlined(&whole->surface, &view, &pose, material, &outline));
    blend_edges(&whole->surface, &outline);
    assert_ok(frame_with_overlap(&frame, &qtri_rgb565, WIDTH, HEIGHT, 9, 1, memory, sizeof memory));
    prepared_init_with(&prepared, vertices, VERTICES, lists, LENGTH_OF(lists));
    qtri_prepared_set_outline(&prepared, &outline);
    qtri_prepare_mesh(&prepared, &frame, &view, &pose, mesh, material);
    assert_ok(qtri_prepared_find_edges(&prepared, &outline));
    while (next_shown(&frame, &band, &shown)) {
        clear_to(&band, sky, 65535);
        qtri_draw_prepared(&band, &prepared);
        blend_edges(&band, &outline);
        for (int32_t y = 0; y < shown.rows; y++) {
            memcpy(banded->surface.pixels + (shown.first_row + y) * banded->surface.pitch,
                   shown.pixels + y * shown.pitch, 2 * WIDTH);
        }
    }
}

/* A number that is no qtri_cull culls nothing, nor is it taken for what culls: borders too. */
TEST(numbers_that_are_no_cull)
{
    static uint16_t around[TRIANGLES][3];
    static const uint32_t numbers[4] = {3, 4, 255, 0x80000001u};
    qtri_mesh mesh = cube(true);
    mesh.triangle_count -= 3 * TRIANGLES / 6; /* open on three sides */
    assert_true(mesh_neighbours_make(&mesh, around));
    for (int n = 0; n < 3; n++) {
        qtri_material material = qtri_material_default();
        canvas none[2];
        mesh.neighbours = n == 1 ? NULL : (const uint16_t(*)[3])around;
        material.cull = QTRI_CULL_NONE;
        material.depth_compare = n == 2 ? (qtri_compare)77 : QTRI_LESS;
        draw_frame_and_bands(&none[0], &none[1], &mesh, &material, 4);
        assert_int_equal(count_different(&none[0].surface, &none[1].surface), 0);
        for (int i = 0; i < (int)LENGTH_OF(numbers); i++) {
            canvas c[2];
            material.cull = (qtri_cull)numbers[i];
            draw_frame_and_bands(&c[0], &c[1], &mesh, &material, 4);
            assert_int_equal(count_different(&none[0].surface, &c[0].surface), 0);
            assert_int_equal(count_different(&none[0].surface, &c[1].surface), 0);
            canvas_free(&c[0]);
            canvas_free(&c[1]);
        }
        canvas_free(&none[0]);
        canvas_free(&none[1]);
    }
}

/* Neighbours of any numbers, of triangles that are seen, cross a plane or lie beyond one. */
TEST(neighbours_that_are_none)
{
    static uint16_t any[TRIANGLES][3];
    uint64_t seed = 3;
    for (int n = 0; n < 60; n++) {
        qtri_mesh mesh = cube(true);
        qtri_material material = qtri_material_default();
        canvas c[2];
        for (int i = 0; i < TRIANGLES; i++) {
            for (int k = 0; k < 3; k++) {
                any[i][k] = (uint16_t)random_in(&seed, 0, TRIANGLES);
            }
        }
        mesh.neighbours = (const uint16_t(*)[3])any;
        material.cull = (qtri_cull)(n % 4);
        draw_frame_and_bands(&c[0], &c[1], &mesh, &material, 1.5 + n * .02);
        assert_int_equal(count_different(&c[0].surface, &c[1].surface), 0);
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
}

/* Creases take light: without one there is none, and what is drawn of samples beside a frame that
   the mesh does not reach has none either. */
TEST(creases_without_light)
{
    static uint32_t memory[QTRI_BAND_BYTES(WIDTH, HEIGHT, QTRI_RGB565_X4_BYTES) / 4];
    const qtri_material material = {.color = {255, 255, 255}};
    qtri_transform pose;
    canvas c[3];
    for (int n = 0; n < 3; n++) {
        qtri_view view = view_of(0, 5, &pose);
        const qtri_mesh mesh = cube(true);
        qtri_outline outline;
        view.light = n == 2 ? &sun : NULL;
        c[n] = new_canvas(QTRI_LESS);
        assert_ok(qtri_outline_init(&outline, &mesh, outline_memory, WORDS));
        outline.creases = n > 0;
        qtri_material flat = material;
        flat.depth_compare = QTRI_LESS;
        assert_ok(qtri_draw_mesh_outlined(&c[n].surface, &view, &pose, &flat, &outline));
        blend_edges(&c[n].surface, &outline);
    }
    assert_int_equal(count_different(&c[0].surface, &c[1].surface), 0);
    assert_true(count_different(&c[1].surface, &c[2].surface) > 100);
    for (int n = 0; n < 40; n++) {
        qtri_surface s;
        qtri_outline outline;
        qtri_mesh mesh = cube(true);
        mesh.bounds.half = vec3_of(1, 1, 1);
        const qtri_view view = view_of(-4.2 - n * .02, 5, &pose);
        assert_ok(qtri_surface_init(&s, &qtri_rgb565_x4, WIDTH, HEIGHT, 0, HEIGHT, memory,
                                    sizeof memory));
        qtri_samples_clear(&s, sky);
        assert_ok(qtri_outline_init(&outline, &mesh, outline_memory, WORDS));
        outline.creases = true;
        assert_ok(qtri_draw_mesh_outlined(&s, &view, &pose, &material, &outline));
        assert_ok(qtri_samples_resolve(&s, &s));
        blend_edges(&s, &outline);
    }
    for (int n = 0; n < 3; n++) {
        canvas_free(&c[n]);
    }
}

int main(void)
{
    return run_all_tests(make_cube, NULL);
}
