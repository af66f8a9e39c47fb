/* SPDX-License-Identifier: MIT */
/*
 * What makes meshes and textures for a microcontroller of models and pictures: nothing is lost but
 * what rounding takes, and that is as small as reported.
 */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/test.h"
#include "assets/asset.h"
#include "assets/model.h"
#include "assets/texture.h"
#include "io/number.h"
#include "tools/mesh_faces.h"

static struct model parse(const char *text)
{
    struct model model;
    struct text_error error;
    if (!model_parse_obj("x.obj", text, strlen(text), true, &model, &error)) {
        fail_msg("%s", error.message);
    }
    assert_true(model_check("x.obj", &model, &error));
    model_weld(&model);
    return model;
}

/* A cube of side 2 whose faces share nothing but places. */
static const char cube[] = "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\nf -4 -3 -2 -1\n"
                           "v 1 -1 -1\nv -1 -1 -1\nv -1 1 -1\nv 1 1 -1\nf -4 -3 -2 -1\n"
                           "v 1 -1 1\nv 1 -1 -1\nv 1 1 -1\nv 1 1 1\nf -4 -3 -2 -1\n"
                           "v -1 -1 -1\nv -1 -1 1\nv -1 1 1\nv -1 1 -1\nf -4 -3 -2 -1\n"
                           "v -1 1 1\nv 1 1 1\nv 1 1 -1\nv -1 1 -1\nf -4 -3 -2 -1\n"
                           "v -1 -1 -1\nv 1 -1 -1\nv 1 -1 1\nv -1 -1 1\nf -4 -3 -2 -1\n";

TEST(equal_vertices_are_merged)
{
    char text[1024];
    snprintf(text, sizeof text, "%s%s", cube, "f 1 1 2\nf 1 2 2\nv 0 -1 1\nf 1 25 2\nv 9 9 9\n");
    struct model model = parse(text);
    assert_int_equal(model.vertex_count, 8);
    assert_int_equal(model.triangle_count, 12); /* none without an area */
    model_free(&model);
}

/* A cube's faces meet at 90 degrees. */
TEST(normals_are_smooth_below_the_angle)
{
    static const struct {
        enum model_normals normals;
        double degrees;
        size_t vertices;
    } cases[] = {{MODEL_NORMALS_SMOOTH, 89.0, 24}, {MODEL_NORMALS_SMOOTH, 91.0, 8},
                 {MODEL_NORMALS_SMOOTH, 0.0, 24},  {MODEL_NORMALS_FLAT, 0.0, 24},
                 {MODEL_NORMALS_NONE, 0.0, 8},     {MODEL_NORMALS_KEEP, 0.0, 24}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct model model = parse(cube);
        model_make_normals(&model, cases[i].normals, cases[i].degrees);
        model_weld(&model);
        assert_int_equal(model.vertex_count, cases[i].vertices);
        for (size_t j = 0; j < model.vertex_count; j++) {
            const struct model_vertex *v = &model.vertices[j];
            double outwards = 0.0;
            for (int axis = 0; axis < 3; axis++) {
                outwards += v->normal[axis] * v->position[axis];
            }
            double expected = cases[i].normals == MODEL_NORMALS_NONE ? 0.0 : 1.0;
            assert_true(outwards >= expected && outwards <= 1.7321 * expected + 1e-9);
        }
        model_free(&model);
    }
}

TEST(models_are_turned_and_fitted)
{
    struct model model = parse("v 1 2 3\nv 5 2 3\nv 1 4 3\nv 1 2 11\nf 1 2 3\nf 1 3 4\n");
    model_turn_up(&model, 'z');
    struct model_box box = model_bounds(&model);
    assert_true(box.high[1] == 11.0 && box.low[1] == 3.0 && box.low[2] == -4.0);
    model_center(&model);
    model_fit(&model, 2.0);
    box = model_bounds(&model);
    assert_true(fabs(box.low[1] + 1.0) < 1e-12 && fabs(box.high[1] - 1.0) < 1e-12);
    assert_true(fabs(box.low[0] + 0.5) < 1e-12 && fabs(box.high[0] - 0.5) < 1e-12);
    model_free(&model);
}

/* ---- Assets ---- */

/* A bumpy sheet of n x n fields with uvs and colours, off the origin. */
static struct model bumpy(int n, double size)
{
    struct model model;
    size_t side = (size_t)n + 1;
    assert_true(model_create(&model, side * side, (size_t)(2 * n * n), 2));
    for (size_t i = 0; i < side * side; i++) {
        struct model_vertex *v = &model.vertices[i];
        size_t row = i / side;
        double x = (double)(i % side) / n, y = (double)row / n;
        v->position[0] = size * (x + 3.0);
        v->position[1] = size * (y - 5.0);
        v->position[2] = size * .2 * sin(9.0 * x) * cos(7.0 * y);
        v->uv[0] = x;
        v->uv[1] = y;
        v->color[0] = (uint8_t)(255.0 * x);
        v->color[1] = (uint8_t)(255.0 * y);
    }
    for (uint32_t i = 0; i < (uint32_t)(n * n); i++) {
        uint32_t a = i / (uint32_t)n * (uint32_t)side + i % (uint32_t)n;
        const uint32_t t[2][3] = {{a, a + 1, a + (uint32_t)side},
                                  {a + 1, a + (uint32_t)side + 1, a + (uint32_t)side}};
        memcpy(model.triangles[2 * i], t, sizeof t);
    }
    model.has_uvs = true;
    model.has_colors = true;
    model_make_normals(&model, MODEL_NORMALS_SMOOTH, 180.0);
    model_weld(&model);
    return model;
}

static void stored_position(const qtri_mesh *mesh, uint32_t i, double out[3])
{
    if (mesh->positions != NULL) {
        const qtri_vec3 p = mesh->positions[i];
        out[0] = p.x / 65536.0;
        out[1] = p.y / 65536.0;
        out[2] = p.z / 65536.0;
        return;
    }
    const qtri_position16 p = mesh->positions16[i];
    double unit = (double)mesh->extent / 32768.0;
    out[0] = (mesh->origin.x + unit * p.x) / 65536.0;
    out[1] = (mesh->origin.y + unit * p.y) / 65536.0;
    out[2] = (mesh->origin.z + unit * p.z) / 65536.0;
}

static double distance(const double a[3], const double b[3])
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

static uint32_t corner_of(const qtri_mesh *mesh, uint32_t triangle, int corner)
{
    return mesh->triangles8 != NULL ? mesh->triangles8[triangle][corner]
                                    : mesh->triangles[triangle][corner];
}

/* Whether the mesh's triangle is the model's, turned in any way, within `most`. */
static bool same_triangle(const qtri_mesh *mesh, uint32_t triangle, const struct model *model,
                          size_t other, double most)
{
    for (int turn = 0; turn < 3; turn++) {
        bool same = true;
        for (int i = 0; i < 3 && same; i++) {
            double at[3];
            stored_position(mesh, corner_of(mesh, triangle, i), at);
            const uint32_t corner = model->triangles[other][(i + turn) % 3];
            same = distance(at, model->vertices[corner].position) <= most;
        }
        if (same) {
            return true;
        }
    }
    return false;
}

TEST(triangles_are_the_models_and_errors_as_reported)
{
    for (int n = 0; n < 8; n++) {
        struct asset asset;
        struct text_error error;
        const struct asset_options options = {n % 2 == 1,      n / 2 % 2 == 1, n / 4 == 0,
                                              mesh_faces_make, false,          n % 3 == 2};
        const double size = n < 4 ? 1.0 : 40.0;
        struct model model = bumpy(n < 6 ? 14 : 20, size);
        assert_true(asset_make("x", &model, &options, &asset, &error));
        assert_int_equal(asset.count, 1);
        const qtri_mesh *mesh = &asset.parts[0].mesh;
        assert_int_equal(mesh->triangle_count, model.triangle_count);
        assert_int_equal(mesh->vertex_count, model.vertex_count);
        assert_true((mesh->triangles8 != NULL) == (options.compact && mesh->vertex_count <= 256));
        /* Half a unit each way, in three directions. */
        double unit = options.compact ? (double)mesh->extent / 32768.0 / 65536.0 : 1.0 / 65536.0;
        assert_true(asset.error.position > 0.0 && asset.error.position <= .8661 * unit);
        assert_true(asset.error.uv <= .5001 / (options.compact ? 16384.0 : 65536.0));
        assert_true(asset.error.normal_degrees < (options.compact ? .5 : .01));
        bool *found = calloc(model.triangle_count, sizeof *found);
        assert_non_null(found);
        for (uint32_t i = 0; i < mesh->triangle_count; i++) {
            size_t j = 0;
            while (j < model.triangle_count &&
                   (found[j] || !same_triangle(mesh, i, &model, j, asset.error.position + 1e-12))) {
                j++;
            }
            assert_true(j < model.triangle_count);
            assert_true(!options.keep_order || j == i);
            found[j] = true;
        }
        free(found);
        asset_free(&asset);
        model_free(&model);
    }
}

/* The box holds all positions, and vertices come in the order of their use. */
TEST(boxes_hold_and_vertices_follow)
{
    for (int n = 0; n < 2; n++) {
        struct asset asset;
        struct text_error error;
        const struct asset_options options = {n == 1, false, true, NULL, false, false};
        struct model model = bumpy(30, 100.0);
        assert_true(asset_make("x", &model, &options, &asset, &error));
        const qtri_mesh *mesh = &asset.parts[0].mesh;
        const double center[3] = {mesh->bounds.center.x, mesh->bounds.center.y,
                                  mesh->bounds.center.z};
        const double half[3] = {mesh->bounds.half.x, mesh->bounds.half.y, mesh->bounds.half.z};
        for (uint32_t i = 0; i < mesh->vertex_count; i++) {
            double at[3];
            stored_position(mesh, i, at);
            for (int axis = 0; axis < 3; axis++) {
                assert_true(fabs(at[axis] * 65536.0 - center[axis]) <= half[axis]);
            }
        }
        uint32_t next = 0;
        for (uint32_t i = 0; i < 3 * mesh->triangle_count; i++) {
            uint32_t corner = corner_of(mesh, i / 3, (int)(i % 3));
            assert_true(corner <= next);
            next += corner == next ? 1 : 0;
        }
        assert_int_equal(next, mesh->vertex_count);
        asset_free(&asset);
        model_free(&model);
    }
}

TEST(what_does_not_fit_is_refused)
{
    static const struct {
        const char *text, *message;
    } cases[] = {
        {"v 0 0 0\nv 40000 0 0\nv 0 1 0\nf 1 2 3\n", "x: reaches beyond 32767"},
        {"v 0 0 0\nv 1e-6 0 0\nv 0 1e-6 0\nf 1 2 3\n", "x: is so small"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const struct asset_options options = {false, false, false, mesh_faces_make, false, false};
        struct asset asset;
        struct text_error error;
        struct model model = parse(cases[i].text);
        assert_false(asset_make("x", &model, &options, &asset, &error));
        assert_memory_equal(error.message, cases[i].message, strlen(cases[i].message));
        model_free(&model);
    }
    struct model model = bumpy(260, 1.0); /* 261^2 vertices */
    const struct asset_options options = {false, false, false, NULL, false, false};
    struct asset asset;
    struct text_error error;
    assert_false(asset_make("x", &model, &options, &asset, &error));
    assert_non_null(strstr(error.message, "68121 vertices"));
    model_free(&model);
}

TEST(materials_become_meshes_or_colors)
{
    static const char text[] = "v 0 0 0 1 1 1\nv 1 0 0 .5 .5 .5\nv 0 1 0\nv 0 0 1\n"
                               "usemtl a\nf 1 2 3\nusemtl unused\nusemtl b\nf 1 3 4\nf 1 4 2\n";
    static const char mtl[] = "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 .5 1\nmap_Ka x.png\n";
    struct model model = parse(text);
    struct text_error error;
    struct asset asset;
    assert_true(model_parse_mtl("x.mtl", mtl, sizeof mtl - 1, &model, &error));
    struct asset_options options = {false, false, false, NULL, false, false};
    assert_true(asset_make("x", &model, &options, &asset, &error));
    assert_int_equal(asset.count, 2);
    assert_string_equal(asset.parts[0].material.name, "a");
    assert_int_equal(asset.parts[1].mesh.triangle_count, 2);
    assert_int_equal(asset.parts[1].material.color[1], 128);
    asset_free(&asset);
    options.colors = true;
    assert_true(asset_make("x", &model, &options, &asset, &error));
    assert_int_equal(asset.count, 1);
    assert_int_equal(asset.parts[0].mesh.triangle_count, 3);
    bool half_red = false;
    for (uint32_t i = 0; i < asset.parts[0].mesh.vertex_count; i++) {
        const qtri_rgb c = asset.parts[0].mesh.colors[i];
        half_red = half_red || (c.r == 128 && c.g == 0 && c.b == 0);
    }
    assert_true(half_red);
    asset_free(&asset);
    model_free(&model);
}

TEST(mtl_errors_have_a_line)
{
    static const struct {
        const char *text, *message;
    } cases[] = {
        {"newmtl a\nKd 1 0\n", "f/x.mtl:2: Kd needs one or three numbers"},
        {"newmtl a\nKd 1 zero 1\n", "f/x.mtl:2: Kd needs numbers"},
        {"newmtl a\nmap_Kd -s 1\n", "f/x.mtl:2: map_Kd needs the name of a picture"},
        {"\x01\x02\n", "f/x.mtl:1: is not text: is this an MTL file?"},
    };
    struct model model = parse("v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct text_error error;
        assert_false(
            model_parse_mtl("f/x.mtl", cases[i].text, strlen(cases[i].text), &model, &error));
        assert_string_equal(error.message, cases[i].message);
    }
    static const char without[] = "newmtl a\nmap_Kd -s 1 1 1 -clamp on no such.png\n";
    struct text_error error;
    assert_true(model_parse_mtl("f/x.mtl", without, strlen(without), &model, &error));
    assert_string_equal(model.left_out, "the picture no such.png, which is not there");
    model_free(&model);
}

TEST(ply_files_are_complete)
{
    static const char head[] = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                               "element face 1\nproperty list uchar short v\nend_header\n";
    char text[512];
    struct model model = {0};
    struct text_error error;
    int length = snprintf(text, sizeof text, "%s", head);
    assert_false(model_check_ply("x", text, (size_t)length, &model, &error));
    snprintf(text + length, sizeof text - (size_t)length, "1\n\n2\n3 0 1 0");
    assert_true(model_check_ply("x", text, strlen(text), &model, &error));
    static const struct {
        const char *data, *message; /* NULL: complete */
    } lines[] = {{"1\n2\n3 0 1 0\n", NULL},
                 {"1 9\n2\n3 0 1 0 9\n", NULL}, /* more than is asked for */
                 {"1\n2\n0\n", NULL},
                 {"1\n2\n\n3 0 1\n", "x:11: a list is longer than its line"},
                 {"1\n2\n3 0 1\n0\n", "x:10: a list is longer than its line"},
                 {"1\n2\n1000000000000 0\n", "x:10: a list needs a count"},
                 {"1\n2\n-1 0\n", "x:10: a list needs a count"},
                 {"1\n2\nx\n", "x:10: a list needs a count"},
                 {"1\n2\n", "x:9: ends before the last of its elements"}};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        snprintf(text + length, sizeof text - (size_t)length, "%s", lines[i].data);
        const bool ok = model_check_ply("x", text, strlen(text), &model, &error);
        assert_true(ok == (lines[i].message == NULL));
        if (!ok) {
            assert_string_equal(error.message, lines[i].message);
        }
    }
    static const char two[] = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                              "property float y\nelement face 1\nend_header\n1\n2\n";
    assert_false(model_check_ply("x", two, sizeof two - 1, &model, &error));
    assert_string_equal(error.message, "x:8: fewer values than its element has");
    static const char many[] = "ply\nelement face 10000000\nend_header\n";
    assert_false(model_check_ply("x", many, sizeof many - 1, &model, &error));
    assert_memory_equal(error.message, "x:2: more than", 14);
    static const char none[] = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                               "end_header\n1\n";
    assert_false(model_check_ply("x", none, sizeof none - 1, &model, &error));
    assert_string_equal(error.message, "x: has no faces: is it a cloud of points?");
    static const char returns[] = "ply\rformat ascii 1.0\relement vertex 1\rend_header\r";
    assert_false(model_check_ply("x", returns, sizeof returns - 1, &model, &error));
    assert_non_null(strstr(error.message, "its lines end with carriage returns alone"));
    assert_string_equal(model.left_out, "");
    static const char painted[] = "ply\nformat ascii 1.0\nelement face 1\n"
                                  "property list uchar int v\nproperty uchar red\nend_header\n"
                                  "3 0 1 2 9\n";
    assert_true(model_check_ply("x", painted, sizeof painted - 1, &model, &error));
    assert_string_equal(model.left_out, "colours of faces");
}

TEST(real_numbers_are_those_of_strtod)
{
    uint64_t seed = 1;
    for (int i = 0; i < 20000; i++) {
        char text[64];
        double value = 0.0;
        seed = seed * UINT64_C(6364136223846793005) + 1442695040888963407u;
        double mantissa = (double)(int64_t)seed / 9e18;
        snprintf(text, sizeof text, i % 2 ? "%.*f" : "%.*e", (int)(seed >> 20 & 15),
                 mantissa * pow(10.0, (double)((seed >> 30) % 12) - 4.0));
        double expected = strtod(text, NULL);
        assert_int_equal(number_parse_real(text, strlen(text), &value), NUMBER_OK);
        assert_true(fabs(value - expected) <= 4e-16 * fabs(expected));
    }
    double value;
    assert_int_equal(number_parse_real("1e31", 4, &value), NUMBER_OUT_OF_RANGE);
    assert_int_equal(number_parse_real("1e999999999999999999", 20, &value), NUMBER_OUT_OF_RANGE);
    assert_int_equal(number_parse_real("nan", 3, &value), NUMBER_MALFORMED);
    assert_int_equal(number_parse_real("1e-999999999", 12, &value), NUMBER_OK);
    assert_true(value == 0.0);
    assert_int_equal(number_parse_real("0e99", 4, &value), NUMBER_OK);
    assert_true(value == 0.0);
}

/* ---- Textures ---- */

static struct image picture_of(int width, int height, const uint8_t *rgba)
{
    struct image image = {width, height, malloc((size_t)width * (size_t)height * 4)};
    assert_non_null(image.rgba);
    memcpy(image.rgba, rgba, (size_t)width * (size_t)height * 4);
    return image;
}

/* Noise of all colours. */
static struct image noise(int width, int height)
{
    uint64_t seed = 7;
    struct image image = {width, height, malloc((size_t)width * (size_t)height * 4)};
    assert_non_null(image.rgba);
    for (size_t i = 0; i < (size_t)width * (size_t)height * 4; i++) {
        seed = seed * UINT64_C(6364136223846793005) + 1442695040888963407u;
        image.rgba[i] = i % 4 == 3 ? 255 : (uint8_t)(seed >> 56);
    }
    return image;
}

TEST(light_is_averaged_not_numbers)
{
    static const uint8_t board[] = {0,   0,   0,   255, 255, 255, 255, 255,
                                    255, 255, 255, 255, 0,   0,   0,   255};
    struct image image = picture_of(2, 2, board), out;
    assert_true(texture_resample(&image, 1, 1, &out));
    assert_int_equal(out.rgba[0], 188); /* half of the light */
    image_free(&out);
    assert_true(texture_resample(&image, 2, 2, &out));
    assert_memory_equal(out.rgba, board, sizeof board);
    image_free(&out);
    image_free(&image);
}

/* What is transparent has no part in the colour, whatever it is. */
TEST(transparent_pixels_do_not_bleed)
{
    static const uint8_t half[] = {255, 0, 0, 255, 0, 255, 0, 0, 255, 0, 0, 255, 0, 255, 0, 0};
    struct image image = picture_of(2, 2, half), out;
    assert_true(texture_resample(&image, 1, 1, &out));
    assert_int_equal(out.rgba[0], 255);
    assert_int_equal(out.rgba[1], 0);
    assert_int_equal(out.rgba[3], 128);
    image_free(&out);
    image_free(&image);
}

TEST(a_flat_picture_stays_flat)
{
    struct image image = noise(37, 23), out;
    for (size_t i = 0; i < 37 * 23; i++) {
        memcpy(&image.rgba[4 * i], "\x11\x80\xF0\xFF", 4);
    }
    assert_true(texture_resample(&image, 64, 8, &out));
    for (size_t i = 0; i < 64 * 8; i++) {
        assert_memory_equal(&out.rgba[4 * i], "\x11\x80\xF0\xFF", 4);
    }
    image_free(&out);
    image_free(&image);
}

TEST(errors_of_formats)
{
    static const int most[TEXTURE_FORMATS] = {4, 60, 255, 0, 64};
    struct image image = noise(64, 64);
    for (int i = 0; i < TEXTURE_FORMATS; i++) {
        struct texture_options options = {.format = (enum texture_format)i};
        struct texture texture;
        struct text_error error;
        assert_true(texture_make("x", &image, &options, &texture, &error));
        assert_int_equal(texture.width, 64);
        assert_true(texture.error.greatest <= most[i]);
        assert_true(texture.error.rms <= texture.error.greatest);
        texture_free(&texture);
    }
    image_free(&image);
}

TEST(few_colors_are_exact)
{
    struct image image = noise(16, 16);
    struct texture_options options = {.format = TEXTURE_PALETTE, .dither = true};
    struct texture texture;
    struct text_error error;
    assert_true(texture_make("x", &image, &options, &texture, &error));
    assert_int_equal(texture.error.greatest, 0);
    texture_free(&texture);
    image_free(&image);
}

/* Dithering keeps the mean: of a gray between two steps of 5 bits. */
TEST(dithering_keeps_the_mean)
{
    struct image image = noise(64, 64);
    for (size_t i = 0; i < 64 * 64; i++) {
        memcpy(&image.rgba[4 * i], "\x55\x55\x55\xFF", 4);
    }
    for (int dither = 0; dither < 2; dither++) {
        struct texture_options options = {.format = TEXTURE_RGB565, .dither = dither == 1};
        struct texture texture;
        struct picture picture;
        struct text_error error;
        double sum = 0.0;
        assert_true(texture_make("x", &image, &options, &texture, &error));
        assert_true(texture_picture(&texture, &picture));
        for (size_t i = 0; i < 64 * 64; i++) {
            sum += picture.rgb[3 * i];
        }
        double off = fabs(sum / 4096.0 - 0x55);
        assert_true(dither == 1 ? off < .2 : off > 1.0);
        picture_free(&picture);
        texture_free(&texture);
    }
    image_free(&image);
}

/* Whatever is opaque is drawn: its texel is not the key's. */
TEST(only_the_keys_texels_are_the_key)
{
    static const uint8_t near_key[] = {255, 0, 255, 255, 254, 1, 254, 255,
                                       9,   9, 9,   0,   255, 4, 250, 255};
    for (int i = 0; i < TEXTURE_FORMATS; i++) {
        struct image image = picture_of(2, 2, near_key);
        struct texture_options options = {
            .format = (enum texture_format)i, .has_key = true, .key = {255, 0, 255}};
        struct texture texture;
        struct text_error error;
        assert_true(texture_make("x", &image, &options, &texture, &error));
        assert_true(texture.has_key);
        assert_int_equal(texture.texels[0], texture.key);
        assert_int_equal(texture.texels[2], texture.key);
        assert_int_not_equal(texture.texels[1], texture.key);
        assert_int_not_equal(texture.texels[3], texture.key);
        texture_free(&texture);
        image_free(&image);
    }
}

TEST(pictures_that_end_too_soon)
{
    static const char good[] = "P5 # gray\n3 2\n15\n\0\1\2\3\4\17";
    struct image image;
    struct text_error error;
    assert_true(image_parse("x", good, sizeof good - 1, &image, &error));
    assert_int_equal(image.rgba[4 * 5], 255);
    assert_int_equal(image.rgba[4 * 1], 17);
    image_free(&image);
    for (size_t length = 0; length < sizeof good - 1; length++) {
        assert_false(image_parse("x", good, length, &image, &error));
        assert_memory_equal(error.message, "x: ", 3);
    }
}

TEST(sides_are_powers_of_two)
{
    static const int pairs[][2] = {{1, 1},   {2, 2},    {3, 4},       {5, 4},      {6, 8},
                                   {90, 64}, {91, 128}, {1025, 1024}, {9999, 1024}};
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        assert_int_equal(texture_nearest_side(pairs[i][0]), pairs[i][1]);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
