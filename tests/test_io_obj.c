/* SPDX-License-Identifier: MIT */
/*
 * Wavefront OBJ files.
 */
#define _POSIX_C_SOURCE 200809L
#include "support/io.h"

#include <math.h>

#include "io/obj.h"

#define LITERAL(text) text, sizeof(text) - 1

/* A unit square in the plane z = 0, as four corners. */
#define SQUARE "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"

static struct obj_mesh parse_bytes(const char *text, size_t length)
{
    struct obj_mesh mesh;
    struct text_error error;
    char *copy = exact_copy(text, length);
    bool ok = obj_parse("x.obj", copy, length, &mesh, &error);
    free(copy);
    if (!ok) {
        fail_msg("%s", error.message);
    }
    return mesh;
}

static struct obj_mesh parse(const char *text)
{
    return parse_bytes(text, strlen(text));
}

static void assert_error_bytes(const char *text, size_t length, const char *expected)
{
    struct obj_mesh mesh;
    struct text_error error;
    char *copy = exact_copy(text, length);
    bool ok = obj_parse("x.obj", copy, length, &mesh, &error);
    free(copy);
    assert_false(ok);
    assert_string_equal(error.message, expected);
    assert_null(mesh.positions);
    assert_null(mesh.path);
}

static void assert_error(const char *text, const char *expected)
{
    assert_error_bytes(text, strlen(text), expected);
}

static void assert_vec3(const int32_t v[3], int32_t x, int32_t y, int32_t z)
{
    assert_int_equal(v[0], x);
    assert_int_equal(v[1], y);
    assert_int_equal(v[2], z);
}

static void assert_triangle(const struct obj_mesh *mesh, size_t i, uint32_t a, uint32_t b,
                            uint32_t c)
{
    assert_true(i < mesh->triangle_count);
    assert_int_equal(mesh->triangles[i][0], a);
    assert_int_equal(mesh->triangles[i][1], b);
    assert_int_equal(mesh->triangles[i][2], c);
}

/* ---- Faces ---- */

TEST(one_triangle)
{
    struct obj_mesh mesh = parse("v -1.5 0 0.25\nv 1 0 0\nv 0 1e0 0\nf 1 2 3");
    assert_string_equal(mesh.path, "x.obj");
    assert_int_equal(mesh.vertex_count, 3);
    assert_int_equal(mesh.triangle_count, 1);
    assert_vec3(mesh.positions[0], -ONE * 3 / 2, 0, ONE / 4);
    assert_vec3(mesh.positions[2], 0, ONE, 0);
    assert_triangle(&mesh, 0, 0, 1, 2);
    assert_null(mesh.uvs);
    obj_free(&mesh);
    assert_null(mesh.positions);
}

TEST(convex_polygons_are_fans)
{
    struct obj_mesh mesh = parse(SQUARE "v 0.5 2 0\nf 1 2 3 5 4\nf 5 4 3\n");
    assert_int_equal(mesh.vertex_count, 5);
    assert_int_equal(mesh.triangle_count, 4);
    assert_triangle(&mesh, 0, 0, 1, 2);
    assert_triangle(&mesh, 1, 0, 2, 3);
    assert_triangle(&mesh, 2, 0, 3, 4);
    assert_triangle(&mesh, 3, 3, 4, 2);
    obj_free(&mesh);
}

/* An arrow head, whose fan about its first corner would leave it; its corners follow. */
TEST(concave_polygons_stay_inside)
{
    struct obj_mesh mesh = parse("f 1 2 3 4\nv 1 3 0\nv 0 0 0\nv -1 3 0\nv 0 2 0\n");
    assert_int_equal(mesh.triangle_count, 2);
    assert_triangle(&mesh, 0, 3, 0, 1);
    assert_triangle(&mesh, 1, 1, 2, 3);
    obj_free(&mesh);
}

TEST(negative_indices_count_back)
{
    struct obj_mesh mesh =
        parse("v 9 9 9\nv 1 0 0\nv 2 0 0\nv 3 1 0\nf -3 -2 -1\nv 4 0 0\nf -1 2 3");
    assert_int_equal(mesh.vertex_count, 4);
    assert_vec3(mesh.positions[0], ONE, 0, 0);
    assert_vec3(mesh.positions[2], 3 * ONE, ONE, 0);
    assert_vec3(mesh.positions[3], 4 * ONE, 0, 0);
    assert_triangle(&mesh, 1, 3, 0, 1);
    obj_free(&mesh);
}

TEST(faces_may_come_first)
{
    struct obj_mesh mesh = parse("f 3 2 1\n" SQUARE);
    assert_int_equal(mesh.vertex_count, 3);
    assert_vec3(mesh.positions[0], ONE, ONE, 0);
    obj_free(&mesh);
}

/* Distinct (v, vt, vn) triples, in the order they appear; every form in one face. */
TEST(triples_become_vertices)
{
    struct obj_mesh mesh = parse(SQUARE "vt 0 0\nvt 1 .25\nvn 0 0 2\nvn 0 3 4\n"
                                        "f 1/1/1 2/2/1 3//1 4\n"
                                        "f 1/1/1 2/2/2 3/2\n"
                                        "f 1/1/1 2/2/1 4\n");
    assert_int_equal(mesh.vertex_count, 6);
    assert_int_equal(mesh.triangle_count, 4);
    assert_triangle(&mesh, 0, 0, 1, 2);
    assert_triangle(&mesh, 1, 0, 2, 3);
    assert_triangle(&mesh, 2, 0, 4, 5);
    assert_triangle(&mesh, 3, 0, 1, 3);
    assert_vec3(mesh.normals[0], 0, 0, ONE);
    assert_vec3(mesh.normals[4], 0, 39322, 52429); /* (0, .6, .8) */
    assert_non_null(mesh.uvs);
    assert_int_equal(mesh.uvs[0][0], 0);
    assert_int_equal(mesh.uvs[0][1], ONE); /* 1 - v */
    assert_int_equal(mesh.uvs[1][0], ONE);
    assert_int_equal(mesh.uvs[1][1], ONE * 3 / 4);
    assert_int_equal(mesh.uvs[2][0], 0); /* a corner without */
    assert_int_equal(mesh.uvs[2][1], 0);
    obj_free(&mesh);
}

/* More corners than the table's first sizes: every triple found again, none mixed up. */
TEST(many_triples)
{
    enum { SIDE = 40, LINE = 64 };
    char *text = malloc(SIDE * SIDE * 3 * LINE);
    size_t used = 0;
    assert_non_null(text);
    for (int i = 0; i < SIDE; i++) {
        used += (size_t)sprintf(text + used, "v %d 1 0\nvt %d 1\n", i, i);
    }
    for (int round = 0; round < 2; round++) {
        for (int v = 1; v <= SIDE; v++) {
            for (int vt = 1; vt <= SIDE; vt++) {
                used += (size_t)sprintf(text + used, "f %d/%d %d/%d 1\n", v, vt, vt, v);
            }
        }
    }
    struct obj_mesh mesh = parse_bytes(text, used);
    assert_int_equal(mesh.vertex_count, SIDE * SIDE + 1);
    assert_int_equal(mesh.triangle_count, 2 * SIDE * SIDE);
    for (int i = 0; i < 2 * SIDE * SIDE; i++) {
        uint32_t a = mesh.triangles[i][0], b = mesh.triangles[i][1];
        assert_int_equal(mesh.positions[a][0], i / SIDE % SIDE * ONE);
        assert_int_equal(mesh.uvs[a][0], i % SIDE * ONE);
        assert_int_equal(mesh.positions[b][0], i % SIDE * ONE);
        assert_int_equal(mesh.uvs[b][0], i / SIDE % SIDE * ONE);
    }
    obj_free(&mesh);
    free(text);
}

/* ---- Normals ---- */

/* Faces of area 1/2 (towards +z) and 1 (towards +x) share an edge; the uv seam between them does
   not split the normal: (1, 0, .5) / |.| at both. */
TEST(normals_are_weighted_by_area_per_position)
{
    struct obj_mesh mesh = parse("v 0 0 0\nv 0 1 0\nv -1 0 0\nv 0 0 -2\nvt 0 0\nvt 1 1\n"
                                 "f 1/1 2/1 3/1\nf 1/2 4/2 2/2\n");
    assert_int_equal(mesh.vertex_count, 6);
    const int32_t x = 58617, z = 29309; /* 2/sqrt(5), 1/sqrt(5) */
    assert_vec3(mesh.normals[0], x, 0, z);
    assert_vec3(mesh.normals[1], x, 0, z);
    assert_vec3(mesh.normals[2], 0, 0, ONE);
    assert_vec3(mesh.normals[3], x, 0, z);
    assert_vec3(mesh.normals[4], ONE, 0, 0);
    assert_vec3(mesh.normals[5], x, 0, z);
    obj_free(&mesh);
}

/* The same two faces, in a file that repeats the positions of their edge, one of them as -0. */
TEST(normals_are_smooth_across_equal_positions)
{
    struct obj_mesh mesh = parse("v 0 0 0\nv 0 1 0\nv -1 0 0\nv 0 0 -2\nv -0 0 0\nv 0 1 0\n"
                                 "f 1 2 3\nf 5 4 6\n");
    assert_int_equal(mesh.vertex_count, 6);
    const int32_t x = 58617, z = 29309;
    const int32_t expected[6][3] = {{x, 0, z}, {x, 0, z},   {0, 0, ONE},
                                    {x, 0, z}, {ONE, 0, 0}, {x, 0, z}};
    for (int i = 0; i < 6; i++) {
        assert_vec3(mesh.normals[i], expected[i][0], expected[i][1], expected[i][2]);
    }
    obj_free(&mesh);
}

TEST(normals_without_a_direction)
{
    /* No area at all, and two faces that cancel: (0, 0, 1). */
    struct obj_mesh mesh = parse("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    assert_vec3(mesh.normals[0], 0, 0, ONE);
    obj_free(&mesh);
    mesh = parse("v 0 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 2\n");
    assert_vec3(mesh.normals[1], 0, 0, ONE);
    obj_free(&mesh);
    /* A zero vn counts as none. */
    mesh = parse("v 0 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 0\nf 1//1 2//1 3//1\n");
    assert_vec3(mesh.normals[0], ONE, 0, 0);
    obj_free(&mesh);
}

TEST(huge_coordinates)
{
    struct obj_mesh mesh =
        parse("v -32768 -32768 -32768\nv 32767.99998 -32768 0\nv 0 32767.99998 -32768\n"
              "vn 32767 32767 32767\nf 1 2 3\nf 1//1 2//1 3//1");
    assert_vec3(mesh.positions[1], INT32_MAX, INT32_MIN, 0);
    assert_vec3(mesh.normals[3], 37837, 37837, 37837);
    obj_free(&mesh);
}

/* ---- Text ---- */

TEST(other_statements_are_passed_over)
{
    struct obj_mesh mesh = parse("# comment\nmtllib a b.mtl\no \xC3\xA4\ng x y\ns off\nusemtl q\n"
                                 "vp 1 2\nl 1 2\np 1\ncstype bezier\ncurv 0 1 1 2\nend\n" SQUARE
                                 "f 1 2 3 # trailing\nlod 3\n");
    assert_int_equal(mesh.triangle_count, 1);
    obj_free(&mesh);
}

TEST(extra_components)
{
    struct obj_mesh mesh = parse("v 1 2 3 1.0\nv 1 2 4 .5 .5 .5\nv 2 2 5 1 .5 .5 99999\n"
                                 "vt .5\nvt .5 .25 .125\nf 1/1 2/2 3\n");
    assert_vec3(mesh.positions[2], 2 * ONE, 2 * ONE, 5 * ONE);
    assert_int_equal(mesh.uvs[0][0], ONE / 2);
    assert_int_equal(mesh.uvs[0][1], ONE);
    assert_int_equal(mesh.uvs[1][1], ONE * 3 / 4);
    obj_free(&mesh);
}

TEST(line_ends)
{
    struct obj_mesh mesh =
        parse("v 0 0 0\r\nv 1 0 \\\r\n0\r\nv 1 1 0\r\n\r\nf 1 \\\r\n2 \\\r\n3\r\n");
    assert_int_equal(mesh.triangle_count, 1);
    assert_vec3(mesh.positions[1], ONE, 0, 0);
    obj_free(&mesh);
    assert_error("v 0 0 \\\n 0\n# \\\nf 1 \\\n x 1\n",
                 "x.obj:4: 'x' is not a corner (v, v/vt, v//vn or v/vt/vn)");
}

TEST(very_long_lines)
{
    const size_t corners = 500000;
    char *text = malloc(sizeof SQUARE + 2 * corners + 1);
    assert_non_null(text);
    size_t used = (size_t)sprintf(text, SQUARE "f");
    for (size_t i = 0; i < corners; i++) {
        text[used++] = ' ';
        text[used++] = (char)('1' + i % 4);
    }
    struct obj_mesh mesh = parse_bytes(text, used);
    assert_int_equal(mesh.triangle_count, corners - 2);
    assert_int_equal(mesh.vertex_count, 4);
    obj_free(&mesh);
    memset(text, 'x', used);
    text[0] = '\n';
    assert_error_bytes(text, used,
                       "x.obj:2: 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...' "
                       "is not an OBJ statement");
    free(text);
}

/* ---- Errors ---- */

TEST(bad_indices)
{
    assert_error(SQUARE "f 1 2 0\n", "x.obj:5: '0' has the index 0; they count from 1");
    assert_error(SQUARE "f 1 2 -0\n", "x.obj:5: '-0' has the index 0; they count from 1");
    assert_error(SQUARE "f 1 2 -5\n", "x.obj:5: '-5' has an index out of range");
    assert_error(SQUARE "\nf 1 2 3\nf 1 2 5\nf 1 2 4\n",
                 "x.obj:7: index 5 is out of range: the file has 4 v statements");
    assert_error(SQUARE "vt 0 0\nf 1/1 2/2 3\n",
                 "x.obj:6: index 2 is out of range: the file has 1 vt statements");
    assert_error(SQUARE "f 1//1 2 3\n",
                 "x.obj:5: index 1 is out of range: the file has 0 vn statements");
    assert_error(SQUARE "f 1 2 99999999999999999999999\n",
                 "x.obj:5: '99999999999999999999999' has an index out of range");
    assert_error(SQUARE "f 1 2 4294967297\n", "x.obj:5: '4294967297' has an index out of range");
    assert_error(SQUARE "f 1/-1 2 3\n", "x.obj:5: '1/-1' has an index out of range");
}

/* Programs leave the slashes of what they leave out. */
TEST(corners_that_end_in_slashes)
{
    struct obj_mesh mesh = parse(SQUARE "vt 0 0\nf 1/ 2/ 3/\nf 1// 2// 3//\nf 1/1/ 2 3\n");
    assert_int_equal(mesh.vertex_count, 4);
    assert_triangle(&mesh, 0, 0, 1, 2);
    assert_triangle(&mesh, 1, 0, 1, 2);
    assert_triangle(&mesh, 2, 3, 1, 2);
    obj_free(&mesh);
}

TEST(edges_are_passed_over)
{
    struct obj_mesh mesh = parse(SQUARE "f 4 3\nf 1 2 3\nf 4\n");
    assert_int_equal(mesh.vertex_count, 3);
    assert_int_equal(mesh.triangle_count, 1);
    obj_free(&mesh);
    assert_error(SQUARE "f 1 2\n", "x.obj: has no faces");
}

TEST(bad_corners)
{
    const char *const corners[] = {"x", "/1", "1/1/1/1", "1.5", "1e0", "//", "/", "1///1", "1///"};
    for (size_t i = 0; i < ARRAY_LENGTH(corners); i++) {
        char text[200], expected[200];
        (void)snprintf(text, sizeof text, SQUARE "vt 0 0\nvn 0 0 1\nf 1 2 %s\n", corners[i]);
        (void)snprintf(expected, sizeof expected,
                       "x.obj:7: '%s' is not a corner (v, v/vt, v//vn or v/vt/vn)", corners[i]);
        assert_error(text, expected);
    }
    assert_error(SQUARE "f 1 2", "x.obj:5: a face needs 3 corners or more");
    assert_error(SQUARE "f\n", "x.obj:5: a face needs 3 corners or more");
}

TEST(bad_numbers)
{
    assert_error("\nv 0 0 x\n", "x.obj:2: 'x' is not a number");
    assert_error("v 0 0 40000\n", "x.obj:1: '40000' does not fit Q16.16");
    assert_error("v 0 0\n", "x.obj:1: too few numbers");
    assert_error("v 0 0 0 0 0 0 0 0\n", "x.obj:1: '0' is more than the statement takes");
    assert_error("v 0 0 0 nan\n", "x.obj:1: 'nan' is not a number");
    assert_error("vt\n", "x.obj:1: too few numbers");
    assert_error("vt 0 0 0 7\n", "x.obj:1: '7' is more than the statement takes");
    assert_error("vt 0 -32768\n", "x.obj:1: 1 - v does not fit Q16.16");
    assert_error("vn 0 1\n", "x.obj:1: too few numbers");
    assert_error("vn 0 1 0 0\n", "x.obj:1: '0' is more than the statement takes");
    struct obj_mesh mesh = parse(SQUARE "vt 0 -32766.99998474\nf 1/1 2/1 3/1");
    assert_int_equal(mesh.uvs[0][1], INT32_MAX);
    obj_free(&mesh);
}

TEST(files_that_are_no_meshes)
{
    assert_error("", "x.obj: has no faces");
    assert_error("# nothing\n" SQUARE, "x.obj: has no faces");
    assert_error(SQUARE "F 1 2 3\n", "x.obj:5: 'F' is not an OBJ statement");
    assert_error("hello\n", "x.obj:1: 'hello' is not an OBJ statement");
    assert_error_bytes(LITERAL("v 1 2 3\n\x7F"
                               "ELF\2\1\0"),
                       "x.obj:2: '?ELF?\?\?' is not text: is this an OBJ file?");
    assert_error_bytes(LITERAL("\0\0\0\0"), "x.obj:1: '?\?\?\?' is not text: is this an OBJ file?");
    assert_error_bytes(LITERAL("v 1 2 3\0\n"), "x.obj:1: '3?' is not a number");
}

TEST_WITH(reading_files, NULL, io_remove_files)
{
    struct obj_mesh mesh;
    struct text_error error;
    assert_false(obj_read(io_path("none.obj"), &mesh, &error));
    assert_non_null(strstr(error.message, "none.obj: cannot be opened: No such file"));
    assert_false(obj_read(io_folder, &mesh, &error));
    assert_non_null(strstr(error.message, "cannot be read: Is a directory"));
    assert_false(obj_read(io_write_text("empty.obj", ""), &mesh, &error));
    assert_non_null(strstr(error.message, "empty.obj: has no faces"));
    assert_true(obj_read(io_write_text("ok.obj", SQUARE "f 1 2 3 4"), &mesh, &error));
    assert_string_equal(mesh.path, io_path("ok.obj"));
    assert_int_equal(mesh.triangle_count, 2);
    obj_free(&mesh);
}

/* ---- Scales ---- */

enum { RINGS = 24, SECTORS = 48, SPHERE_TRIANGLES = 2 * RINGS * SECTORS - 2 * SECTORS };

/* A sphere about the origin, and a vertex far away that no face names. */
static char *sphere_text(double radius)
{
    enum { ROOM = 200000 };
    char *text = malloc(ROOM);
    size_t used = (size_t)snprintf(text, ROOM, "v %.17g 0 0\n", radius * 1e9);
    for (int ring = 0; ring <= RINGS; ring++) {
        for (int sector = 0; sector < SECTORS; sector++) {
            const double a = 3.14159265358979 * ring / RINGS;
            const double b = 2 * 3.14159265358979 * sector / SECTORS;
            used += (size_t)snprintf(text + used, ROOM - used, "v %.17g %.17g %.17g\n",
                                     radius * sin(a) * cos(b), radius * cos(a),
                                     radius * sin(a) * sin(b));
        }
    }
    for (int i = 0; i < RINGS * SECTORS; i++) {
        const int next = i % SECTORS == SECTORS - 1 ? i - SECTORS + 1 : i + 1;
        if (i >= SECTORS) {
            used += (size_t)snprintf(text + used, ROOM - used, "f %d %d %d\n", i + 2, next + 2,
                                     next + SECTORS + 2);
        }
        if (i < (RINGS - 1) * SECTORS) {
            used += (size_t)snprintf(text + used, ROOM - used, "f %d %d %d\n", i + 2,
                                     next + SECTORS + 2, i + SECTORS + 2);
        }
    }
    assert_true(used < ROOM);
    return text;
}

static struct obj_mesh sphere(double radius, double factor, double fit)
{
    const struct obj_scale scale = {factor, fit};
    struct obj_mesh mesh;
    struct text_error error;
    char *text = sphere_text(radius);
    if (!obj_parse_scaled("x.obj", text, strlen(text), factor == 0 && fit == 0 ? NULL : &scale,
                          &mesh, &error)) {
        fail_msg("%s", error.message);
    }
    free(text);
    assert_int_equal(mesh.triangle_count, SPHERE_TRIANGLES);
    return mesh;
}

/* Triangles of which two corners are at one place. */
static int lost(const struct obj_mesh *mesh)
{
    int count = 0;
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        bool is_lost = false;
        for (int k = 0; k < 3; k++) {
            const int32_t *a = mesh->positions[mesh->triangles[i][k]];
            const int32_t *b = mesh->positions[mesh->triangles[i][(k + 1) % 3]];
            is_lost = is_lost || (a[0] == b[0] && a[1] == b[1] && a[2] == b[2]);
        }
        count += is_lost;
    }
    return count;
}

static void assert_same_positions(const struct obj_mesh *a, const struct obj_mesh *b)
{
    assert_int_equal(a->vertex_count, b->vertex_count);
    for (size_t i = 0; i < a->vertex_count; i++) {
        for (int axis = 0; axis < 3; axis++) {
            assert_true(labs((long)a->positions[i][axis] - b->positions[i][axis]) <= 1);
        }
    }
}

/* The same shape whatever the file's unit is, where Q16.16 alone would lose it. */
TEST(scales_keep_small_models)
{
    struct obj_mesh one = sphere(1.0, 1.0, 0.0);
    const double radius[] = {1e-12, 1e-4, .01, 7.0, 1e6};
    for (size_t i = 0; i < ARRAY_LENGTH(radius); i++) {
        struct obj_mesh fitted = sphere(radius[i], 0.0, 2.0);
        struct obj_mesh scaled = sphere(radius[i], 1.0 / radius[i], 0.0);
        assert_int_equal(lost(&fitted), 0);
        assert_same_positions(&fitted, &one);
        assert_same_positions(&scaled, &one);
        obj_free(&fitted);
        obj_free(&scaled);
    }
    obj_free(&one);
    char *text = sphere_text(1e-4);
    char *faces = strchr(text, '\n') + 1; /* without the vertex that is far away: indices shift */
    struct text_error error;
    struct obj_mesh small;
    memmove(text, "v 0 0 0\n", 8);
    memmove(text + 8, faces, strlen(faces) + 1);
    assert_true(obj_parse("x.obj", text, strlen(text), &small, &error));
    assert_true(lost(&small) > SPHERE_TRIANGLES / 10);
    obj_free(&small);
    free(text);
}

TEST(scales_that_do_not_fit)
{
    static const char text[] = "v 0 0 0\nv 0 0 40000\nv 1 0 0\nf 1 2 3\n";
    static const char point[] = "v 3 3 3\nf 1 1 1\n";
    const struct obj_scale as_it_is = {1.0, 0.0};
    const struct obj_scale half = {.5, 0.0};
    const struct obj_scale fit = {0.0, 2.0};
    struct obj_mesh mesh;
    struct text_error error;
    assert_false(obj_parse_scaled("x.obj", LITERAL(text), &as_it_is, &mesh, &error));
    assert_string_equal(error.message, "x.obj: does not fit Q16.16 when it is scaled");
    assert_null(mesh.positions);
    assert_true(obj_parse_scaled("x.obj", LITERAL(text), &half, &mesh, &error));
    assert_int_equal(mesh.positions[1][2], 20000 * ONE);
    obj_free(&mesh);
    assert_true(obj_parse_scaled("x.obj", LITERAL(point), &fit, &mesh, &error)); /* no size */
    assert_vec3(mesh.positions[0], 3 * ONE, 3 * ONE, 3 * ONE);
    obj_free(&mesh);
}

/* ---- Models from elsewhere ---- */

static void assert_model(const char *name, size_t vertices, size_t triangles, bool uvs)
{
    struct obj_mesh mesh;
    struct text_error error;
    const char *path = model_path(name);
    if (path == NULL) {
        skip();
    }
    if (!obj_read(path, &mesh, &error)) {
        fail_msg("%s", error.message);
    }
    assert_int_equal(mesh.vertex_count, vertices);
    assert_int_equal(mesh.triangle_count, triangles);
    assert_int_equal(mesh.uvs != NULL, uvs);
    for (size_t i = 0; i < vertices; i++) {
        double sum = 0;
        for (int j = 0; j < 3; j++) {
            sum += (double)mesh.normals[i][j] * mesh.normals[i][j];
        }
        assert_true(fabs(sqrt(sum) - ONE) < 1.0);
    }
    for (size_t i = 0; i < triangles; i++) {
        for (int j = 0; j < 3; j++) {
            assert_true(mesh.triangles[i][j] < vertices);
        }
    }
    obj_free(&mesh);
}

TEST(model_spot)
{
    assert_model("spot.obj", 3225, 5856, true);
}

TEST(model_teapot)
{
    assert_model("teapot.obj", 3644, 6320, false);
}

TEST(model_suzanne)
{
    assert_model("suzanne.obj", 507, 968, false);
}

int main(void)
{
    return run_all_tests(io_setup, io_teardown);
}
