/* SPDX-License-Identifier: MIT */
/*
 * What the double-precision reference does with a scene's state: depth comparison and writing,
 * culling, shading, textures, light; and its pictures in the formats of displays.
 */
#include "support/reference.h"

#include "reference/reference_picture.h"

/* ---- Depth ---- */

static uint32_t visible_after(const char *state_statements, double first_z, double second_z)
{
    char text[1024];

    snprintf(text, sizeof text,
             "viewport 4 4\n%s\n"
             "tri -1 -1 %.9f 1 1 0 0  3 -1 %.9f 1 1 0 0  -1 3 %.9f 1 1 0 0\n"
             "tri -1 -1 %.9f 1 0 1 0  3 -1 %.9f 1 0 1 0  -1 3 %.9f 1 0 1 0\n",
             state_statements, first_z, first_z, first_z, second_z, second_z, second_z);
    struct reference_image image = render(text, 0);
    uint32_t id = image.id[5];
    reference_free(&image);
    return id;
}

TEST(depth_comparisons)
{
    /* what is visible after drawing 2 in front of, exactly at, and behind 1 */
    static const struct {
        const char *statements;
        uint32_t nearer, same, farther;
    } rows[] = {
        {"depth off", 2, 2, 2},
        {"depth less", 2, 1, 1},
        {"depth lequal", 2, 2, 1},
        {"depth always", 2, 2, 2},
        {"depth notequal", 2, 1, 2},
        {"cleardepth 0\ndepth greater", 1, 1, 2},
        {"cleardepth 0\ndepth gequal", 1, 2, 2},
        {"depth equal", 0, 0, 0},
        {"cleardepth 0\ndepth less", 0, 0, 0},
    };

    for (size_t r = 0; r < ARRAY_LENGTH(rows); r++) {
        assert_int_equal(visible_after(rows[r].statements, .25, -.25), rows[r].nearer);
        assert_int_equal(visible_after(rows[r].statements, .25, .25), rows[r].same);
        assert_int_equal(visible_after(rows[r].statements, .25, .5), rows[r].farther);
    }
    /* 2^-16 of z is half a unit of the depth buffer: two such steps may, three must, differ */
    assert_int_equal(visible_after("depth equal\ncleardepth .5", 0, 1 / 65536.0), 2);
    assert_int_equal(visible_after("depth equal\ncleardepth .5", 0, 3 / 65536.0), 1);
}

TEST(depth_is_kept_where_it_is_not_written)
{
    static const char triangle[] = "tri -1 -1 .5 1 1 0 0  3 -1 .5 1 1 0 0  -1 3 .5 1 1 0 0\n";
    static const struct {
        const char *statements;
        double depth;
    } rows[] = {
        {"depth less\n", .75},
        {"depth off\n", 1},
        {"depth off\ncleardepth .5\n", .5},
        {"depth less\ndepthrange .25 .5\n", .4375},
        {"depth less\ndepthrange 1 0\n", .25},
    };

    for (size_t r = 0; r < ARRAY_LENGTH(rows); r++) {
        for (size_t b = 0; b < ARRAY_LENGTH(all_bits); b++) {
            char text[512];
            snprintf(text, sizeof text, "viewport 4 4\n%s%s", rows[r].statements, triangle);
            struct reference_image image = render(text, all_bits[b]);
            assert_int_equal(image.id[0], 1);
            assert_near(image.depth[0], rows[r].depth, 1e-15);
            reference_free(&image);
        }
    }
}

TEST(depth_mask)
{
    struct scene scene;
    struct reference_image image;

    parse("viewport 4 4\ndepth less\n"
          "tri -1 -1 .5 1 1 0 0  3 -1 .5 1 1 0 0  -1 3 .5 1 1 0 0\n",
          &scene);
    scene.depth_write = false;
    assert_true(reference_render(&scene, 0, &image));
    assert_int_equal(image.id[0], 1);
    assert_near(image.depth[0], 1, 0);
    reference_free(&image);
    scene_free(&scene);
}

/* ---- Culling, shading, texture ---- */

TEST(culling)
{
    static const char front[] = "tri -1 -1 0 1 1 0 0  3 -1 0 1 1 0 0  -1 3 0 1 1 0 0\n";
    static const char back[] = "tri -1 -1 0 1 1 0 0  -1 3 0 1 1 0 0  3 -1 0 1 1 0 0\n";
    static const struct {
        const char *statement;
        bool front, back;
    } rows[] = {{"cull none", true, true}, {"cull back", true, false}, {"cull front", false, true}};

    for (size_t r = 0; r < ARRAY_LENGTH(rows); r++) {
        for (int k = 0; k < 4; k++) { /* three ways to fill, and the outline */
            char text[512];
            for (int side = 0; side < 2; side++) {
                snprintf(text, sizeof text, "viewport 4 4\n%s\n%s%s", rows[r].statement,
                         k == 3 ? "polygon line\n" : "", side ? back : front);
                struct reference_image image = render(text, k == 3 ? 0 : all_bits[k]);
                bool drawn = side ? rows[r].back : rows[r].front;
                /* outline: only the left edge runs inside the picture */
                assert_int_equal(count_covered(&image), !drawn ? 0 : k == 3 ? 4 : 16);
                reference_free(&image);
            }
        }
    }
}

TEST(flat_shading_takes_the_provoking_vertex)
{
    static const char triangle[] = "tri -1 -1 0 1 1 0 0  3 -1 0 1 0 1 0  -1 3 0 1 0 0 1\n";
    static const char *const statement[] = {"shade flat first", "shade flat last", "shade flat"};
    static const double expected[3][3] = {{255, 0, 0}, {0, 0, 255}, {0, 0, 255}};

    for (size_t r = 0; r < 3; r++) {
        for (size_t b = 0; b < ARRAY_LENGTH(all_bits); b++) {
            char text[512];
            snprintf(text, sizeof text, "viewport 4 4\n%s\n%s", statement[r], triangle);
            struct reference_image image = render(text, all_bits[b]);
            for (size_t c = 0; c < 3; c++) {
                assert_near(image.color[3 * 6 + c], expected[r][c], 0);
                assert_near(image.color_min[3 * 6 + c], expected[r][c], 0);
                assert_near(image.color_max[3 * 6 + c], expected[r][c], 0);
            }
            reference_free(&image);
        }
    }
}

TEST(color_range_is_that_of_the_vertices)
{
    struct reference_image image =
        render("viewport 4 4\nclear .2 .4 .6\n"
               "tri -1 -1 0 1 1 .5 0  1 -1 0 1 .2 1 0  -1 1 0 1 0 .6 0\n",
               0);
    size_t inside = 3 * at(&image, 0, 2), outside = 3 * at(&image, 3, 0);
    const double least[3] = {0, .5, 0}, greatest[3] = {1, 1, 0}, clear[3] = {.2, .4, .6};

    for (size_t c = 0; c < 3; c++) {
        assert_near(image.color_min[inside + c], 255 * least[c], 0.01);
        assert_near(image.color_max[inside + c], 255 * greatest[c], 0.01);
        assert_near(image.color[outside + c], 255 * clear[c], 0.01);
        assert_near(image.color_min[outside + c], 255 * clear[c], 0.01);
        assert_near(image.color_max[outside + c], 255 * clear[c], 0.01);
    }
    assert_int_equal(image.hits[inside / 3], 1);
    assert_int_equal(image.hits[outside / 3], 0);
    reference_free(&image);
}

/* A 4x4 texture, 2x2 fields, on a quad of 8x8 pixels with u from -1 to 1: it repeats, starts again
   at 0 exactly, and v = 0 is the top row. */
TEST(textures_repeat)
{
    static const char quad[] =
        "trit -1 -1 0 1 1 1 .5 -1 1   1 -1 0 1 1 1 .5 1 1   1 1 0 1 1 1 .5 1 0\n"
        "trit -1 -1 0 1 1 1 .5 -1 1   1 1 0 1 1 1 .5 1 0  -1 1 0 1 1 1 .5 -1 0\n";

    for (int modulate = 0; modulate < 2; modulate++) {
        for (size_t b = 0; b < ARRAY_LENGTH(all_bits); b++) {
            char text[1024];
            snprintf(text, sizeof text,
                     "viewport 8 8\ntexture 4 4 2 200 100 50 0 0 255\ntexmode %s\n%s",
                     modulate ? "modulate" : "replace", quad);
            struct reference_image image = render(text, all_bits[b]);
            for (int y = 0; y < 8; y++) {
                for (int x = 0; x < 8; x++) {
                    bool second = (x / 2 + y / 4) % 2 != 0;
                    const double a[3] = {200, 100, 50}, z[3] = {0, 0, 255};
                    for (size_t c = 0; c < 3; c++) {
                        double expected = (second ? z : a)[c] * (modulate && c == 2 ? .5 : 1);
                        assert_near(image.color[3 * at(&image, x, y) + c], expected, 1e-9);
                    }
                }
            }
            reference_free(&image);
        }
    }
}

/* The picture of a quad of 8x8 pixels, u from u0 to u1 from the left, v alike from the top. */
static struct reference_image textured_quad(const char *state, double u0, double u1)
{
    char text[1024];
    snprintf(text, sizeof text,
             "viewport 8 8\ntexmode replace\ndepth less\n%s\n"
             "trit -1 -1 0 1 1 1 1 %f %f   1 -1 0 1 1 1 1 %f %f   1 1 0 1 1 1 1 %f %f\n"
             "trit -1 -1 0 1 1 1 1 %f %f   1 1 0 1 1 1 1 %f %f  -1 1 0 1 1 1 1 %f %f\n",
             state, u0, u1, u1, u1, u1, u0, u0, u1, u1, u0, u0, u0);
    return render(text, 8);
}

/* 2x2 texels over the middle 4x4 pixels: u and v from -1/2 to 3/2. */
TEST(textures_clamp)
{
    static const char *const wrap[] = {"clamp", "clamp repeat", "repeat clamp", "repeat"};
    for (size_t n = 0; n < 4; n++) {
        char text[200];
        snprintf(text, sizeof text, "texture 2 2 2 0 0 0 100 0 0\ntexwrap %s", wrap[n]);
        struct reference_image image = textured_quad(text, -.5, 1.5);
        for (int y = 0; y < 8; y++) {
            for (int x = 0; x < 8; x++) {
                int column = n < 2 ? x >= 4 : (x - 2 + 8) / 2 % 2;
                int row = n % 2 == 0 ? y >= 4 : (y - 2 + 8) / 2 % 2;
                assert_near(image.color[3 * at(&image, x, y)], (column + row) % 2 * 100, 1e-9);
            }
        }
        reference_free(&image);
    }
}

/* 2x2 texels over 8x8 pixels: weights are odd eighths, centres at pixels 2 and 6 of each row. */
TEST(textures_are_filtered)
{
    static const double clamped[8] = {0, 0, 12.5, 37.5, 62.5, 87.5, 100, 100};
    static const double repeated[8] = {37.5, 12.5, 12.5, 37.5, 62.5, 87.5, 87.5, 62.5};
    for (int clamp = 0; clamp < 2; clamp++) {
        char text[200];
        snprintf(text, sizeof text, "texture 2 2 2 0 0 0 100 0 0\ntexfilter bilinear\ntexwrap %s",
                 clamp ? "clamp" : "repeat");
        struct reference_image image = textured_quad(text, 0, 1);
        const double *share = clamp ? clamped : repeated; /* of the second column or row */
        for (int y = 0; y < 8; y++) {
            for (int x = 0; x < 8; x++) {
                double expected = share[x] + share[y] - share[x] * share[y] / 50;
                assert_near(image.color[3 * at(&image, x, y)], expected, 1e-9);
            }
        }
        reference_free(&image);
    }
}

TEST(texel_formats)
{
    static const struct {
        const char *name;
        double color[3];
    } formats[] = {{"xrgb8888", {200, 101, 50}},
                   {"palette", {200, 101, 50}},
                   {"palette565", {24 * 255 / 31., 25 * 255 / 63., 6 * 255 / 31.}},
                   {"rgb565", {24 * 255 / 31., 25 * 255 / 63., 6 * 255 / 31.}},
                   {"gray8", {125, 125, 125}}}; /* 124.787 */
    for (size_t n = 0; n < ARRAY_LENGTH(formats); n++) {
        char text[200];
        snprintf(text, sizeof text, "texture 1 1 1 200 101 50 0 0 0\ntexformat %s",
                 formats[n].name);
        struct reference_image image = textured_quad(text, 0, 1);
        for (size_t c = 0; c < 3; c++) {
            assert_near(image.color[c], formats[n].color[c], 1e-9);
        }
        reference_free(&image);
    }
}

/* Texels stored as the key is leave colour, depth and id alone; filtered, they lend no colour. */
TEST(keys_leave_holes)
{
    static const char *const filters[] = {"nearest", "bilinear"};
    static const char *const keys[] = {"xrgb8888\ntexkey 100 0 0", "palette\ntexkey 100 0 0",
                                       "palette565\ntexkey 100 0 0", "rgb565\ntexkey 97 1 3",
                                       "gray8\ntexkey 0 51 0"};
    for (int n = 0; n < 10; n++) {
        char text[200];
        snprintf(text, sizeof text,
                 "clear 0 0 1\ntexture 4 4 4 100 0 0 0 0 0\ntexfilter %s\ntexformat %s",
                 filters[n / 5], keys[n % 5]);
        struct reference_image image = textured_quad(text, 0, 1);
        for (int y = 0; y < 8; y++) {
            for (int x = 0; x < 8; x++) {
                size_t i = at(&image, x, y);
                bool hole = (x / 2 + y / 2) % 2 == 0;
                assert_int_equal(image.id[i] == 0, hole);
                assert_int_equal(image.hits[i], 1);
                assert_near(image.depth[i], hole ? 1 : .5, 1e-9);
                assert_near(image.color[3 * i], 0, 0);
                assert_near(image.color[3 * i + 2], hole ? 255 : 0, 1e-9);
            }
        }
        reference_free(&image);
    }
}

/* Texture coordinates are perspective-correct: a quad whose right side is twice as far has u = 1/3
   in its middle column. */
TEST(textures_follow_perspective)
{
    static const char quad[] = "trit -1 -1 0 1 1 1 1 0 1   2 -2 0 2 1 1 1 1 1   2 2 0 2 1 1 1 1 0\n"
                               "trit -1 -1 0 1 1 1 1 0 1   2 2 0 2 1 1 1 1 0  -1 1 0 1 1 1 1 0 0\n";
    struct scene scene;
    struct reference_image image;
    static uint8_t ramp[256 * 3];

    for (size_t i = 0; i < 256; i++)
        ramp[3 * i] = (uint8_t)i;
    parse("viewport 65 65\ntexmode replace\n", &scene);
    scene_free(&scene);
    for (size_t b = 0; b < ARRAY_LENGTH(all_bits); b++) {
        for (int linear = 0; linear < 2; linear++) {
            parse(quad, &scene);
            scene.width = scene.height = 65;
            scene.texture_mode = SCENE_REPLACE;
            scene.texture.width = 256;
            scene.texture.height = 1;
            scene.texture.rgb = ramp;
            scene.screen_linear = linear != 0;
            assert_true(reference_render(&scene, all_bits[b], &image));
            scene.texture.rgb = NULL;
            double u = linear ? .5 : 1 / 3.0;
            assert_near(image.color[3 * at(&image, 32, 40)], floor(256 * u), linear ? 1 : 0);
            reference_free(&image);
            scene_free(&scene);
        }
    }
}

/* ---- Meshes and light ---- */

/* One triangle with corners on the axes: its normal is (1,1,1). */
static int32_t corner_positions[3][3] = {{65536, 0, 0}, {0, 65536, 0}, {0, 0, 65536}};
static int32_t corner_normals[3][3] = {{37837, 37837, 37837}, {0, 0, 65536}, {0, 0, 0}};
static uint32_t corner_triangles[1][3] = {{0, 1, 2}};

/* A scene of that mesh under `number_of_ops` operations, of which the last draws it. */
static struct scene corner_scene(struct obj_mesh *mesh, struct scene_op *ops, size_t count)
{
    struct scene scene = {0};

    *mesh = (struct obj_mesh){
        .vertex_count = 3,
        .triangle_count = 1,
        .positions = corner_positions,
        .normals = corner_normals,
        .triangles = corner_triangles,
    };
    scene.width = scene.height = 64;
    scene.clear_depth = 65536;
    scene.depth_far = 65536;
    scene.light.towards[2] = 2 * 65536;
    scene.light.ambient = q16(.25);
    scene.light.diffuse = q16(.5);
    scene.ops = ops;
    scene.op_count = count;
    scene.meshes = mesh;
    scene.mesh_count = 1;
    scene.triangle_count = 1;
    ops[count - 1].kind = SCENE_MESH;
    ops[count - 1].id = 1;
    ops[count - 1].u.mesh.mesh = 0;
    for (int c = 0; c < 3; c++)
        ops[count - 1].u.mesh.color[c] = 65536;
    return scene;
}

static void light_range(const struct scene *scene, double *least, double *greatest)
{
    struct reference_image image;

    assert_true(reference_render(scene, 0, &image));
    *least = 1e9;
    *greatest = -1e9;
    for (int i = 0; i < image.width * image.height; i++) {
        if (image.id[i]) {
            *least = fmin(*least, image.color_min[3 * i]);
            *greatest = fmax(*greatest, image.color_max[3 * i]);
        }
    }
    reference_free(&image);
}

TEST(light_per_vertex_and_per_face)
{
    struct obj_mesh mesh;
    struct scene_op ops[1];
    struct scene scene = corner_scene(&mesh, ops, 1);
    double least, greatest;

    /* normals (1,1,1)/sqrt 3, (0,0,1), and none, which gets ambient light only */
    light_range(&scene, &least, &greatest);
    assert_near(greatest, 255 * .75, 1e-9);
    assert_near(least, 255 * .25, 1e-9);
    /* the face's own normal is (1,1,1) */
    scene.flat = true;
    light_range(&scene, &least, &greatest);
    assert_near(greatest, 255 * (.25 + .5 / sqrt(3)), 1e-9);
    assert_near(least, greatest, 0);
    /* saturation */
    scene.light.ambient = q16(.9);
    light_range(&scene, &least, &greatest);
    assert_near(greatest, 255, 0);
    /* light from behind */
    scene.light.ambient = q16(.25);
    scene.light.towards[2] = -65536;
    light_range(&scene, &least, &greatest);
    assert_near(greatest, 255 * .25, 1e-9);
    /* no light: the plain colour */
    scene.light.towards[2] = 0;
    light_range(&scene, &least, &greatest);
    assert_near(least, 255, 0);
}

/* Under scale (1,1,z) the plane x + y + z = 1 becomes x + y + z' / z = 1: normal (1, 1, 1/z). A
   negative z also turns the triangle over, but its normal still is the inverse transpose's. */
TEST(normals_follow_the_inverse_transpose)
{
    static const double factors[] = {4, .5, -.5};
    struct obj_mesh mesh;
    struct scene_op ops[2] = {{.kind = SCENE_SCALE}};

    for (size_t i = 0; i < ARRAY_LENGTH(factors); i++) {
        struct scene scene = corner_scene(&mesh, ops, 2);
        double z = factors[i], least, greatest;
        ops[0].u.number[0] = ops[0].u.number[1] = 65536 / 4;
        ops[0].u.number[2] = q16(z / 4);
        scene.flat = true;
        light_range(&scene, &least, &greatest);
        double cosine = (1 / z) / sqrt(2 + 1 / (z * z));
        assert_near(greatest, 255 * (.25 + .5 * fmax(0, cosine)), 1e-9);
    }
    struct scene scene = corner_scene(&mesh, ops, 2);
    double least, greatest;
    ops[0].u.number[2] = 0; /* singular: no normal */
    light_range(&scene, &least, &greatest);
    assert_near(greatest, 255 * .25, 1e-9);
}

TEST(meshes_without_uvs_are_not_textured)
{
    static uint8_t black[3];
    static int32_t uvs[3][2];
    struct obj_mesh mesh;
    struct scene_op ops[1];
    struct scene scene = corner_scene(&mesh, ops, 1);
    struct reference_image image;

    scene.light.towards[2] = 0;
    scene.texture = (struct scene_texture){.width = 1, .height = 1, .rgb = black};
    for (int with_uvs = 0; with_uvs < 2; with_uvs++) {
        mesh.uvs = with_uvs ? uvs : NULL;
        assert_true(reference_render(&scene, 0, &image));
        size_t i = at(&image, 40, 20);
        assert_int_equal(image.id[i], 1);
        assert_near(image.color[3 * i], with_uvs ? 0 : 255, 0);
        assert_near(image.color_min[3 * i], 255, 0);
        reference_free(&image);
    }
}

/* ---- Quantised pictures ---- */

TEST(pictures_are_quantised_to_nearest)
{
    struct reference_image image = render("viewport 2 1\ncleardepth .5\nclear .3 .5 .7\n", 0);
    struct picture picture;

    assert_true(reference_picture(&image, REFERENCE_RGB888, &picture));
    assert_int_equal(picture.rgb[0], 77); /* 76.5002: .3 is 19661/65536 */
    assert_int_equal(picture.rgb[1], 128);
    assert_int_equal(picture.rgb[2], 178); /* 178.4992 */
    assert_near(picture.depth[1], .5, 0);
    assert_int_equal(picture.id[1], 0);
    picture_free(&picture);
    assert_true(reference_picture(&image, REFERENCE_RGB565, &picture));
    assert_int_equal(picture.rgb[3], 74);  /* 9.3 of 31 is 9 */
    assert_int_equal(picture.rgb[4], 130); /* 31.5 of 63 is 32 */
    assert_int_equal(picture.rgb[5], 181); /* 21.7 of 31 is 22 */
    picture_free(&picture);
    assert_true(reference_picture(&image, REFERENCE_GRAY8, &picture));
    assert_int_equal(picture.rgb[0], 118); /* 22.87 + 74.84 + 20.35 = 118.07 */
    assert_int_equal(picture.rgb[2], 118);
    picture_free(&picture);
    reference_free(&image);
    image = render("viewport 1 1\nclear 1 0 0\n", 0);
    assert_true(reference_picture(&image, REFERENCE_GRAY8, &picture));
    assert_int_equal(picture.rgb[1], 76); /* 76.245 */
    picture_free(&picture);
    reference_free(&image);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
