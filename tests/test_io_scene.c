/* SPDX-License-Identifier: MIT */
/*
 * Scene files: every statement's effect and every error, with its line.
 */
#define _POSIX_C_SOURCE 200809L
#include "support/io.h"

#include "io/picture.h"
#include "io/palette.h"
#include "io/scene.h"

#define LITERAL(text) text, sizeof(text) - 1

#define TRI  "tri 0 0 0 1 1 0 0  1 0 0 1 0 1 0  0 1 0 1 0 0 1\n"
#define TRIT "trit 0 0 0 1 1 0 0 0 0  1 0 0 1 0 1 0 1 0  0 1 0 1 0 0 1 0 1\n"

#define ONE_FACE  "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
#define TWO_FACES "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"

static const char *scene_name = "x.scene"; /* what the parser is told */

static struct scene parse_bytes(const char *text, size_t length)
{
    struct scene scene;
    struct text_error error;
    char *copy = exact_copy(text, length);
    bool ok = scene_parse(scene_name, copy, length, &scene, &error);
    free(copy);
    if (!ok) {
        fail_msg("%s", error.message);
    }
    return scene;
}

static struct scene parse(const char *text)
{
    return parse_bytes(text, strlen(text));
}

static void assert_error_bytes(const char *text, size_t length, const char *expected)
{
    struct scene scene;
    struct text_error error;
    char *copy = exact_copy(text, length);
    bool ok = scene_parse(scene_name, copy, length, &scene, &error);
    free(copy);
    if (ok) {
        fail_msg("accepted: %.80s", text);
    }
    assert_string_equal(error.message, expected);
    assert_null(scene.ops);
    assert_null(scene.meshes);
    assert_null(scene.texture.rgb);
}

static void assert_error(const char *text, const char *expected)
{
    assert_error_bytes(text, strlen(text), expected);
}

/* Scenes lie in the test's folder from here on. */
static int in_folder(void **state)
{
    (void)state;
    static char name[PATH_SIZE];
    (void)snprintf(name, sizeof name, "%s", io_path("x.scene"));
    scene_name = name;
    return 0;
}

static int out_of_folder(void **state)
{
    scene_name = "x.scene";
    return io_remove_files(state);
}

/* `expected` follows "FOLDER/x.scene:"; each @ in it is the folder. */
static void assert_error_in_folder(const char *text, const char *expected)
{
    char message[2 * PATH_SIZE];
    size_t used = (size_t)snprintf(message, sizeof message, "%s:", scene_name);
    for (; *expected != '\0'; expected++) {
        if (*expected == '@') {
            used += (size_t)snprintf(message + used, sizeof message - used, "%s", io_folder);
        } else {
            message[used++] = *expected;
        }
    }
    message[used] = '\0';
    assert_error(text, message);
}

/* ---- State ---- */

static void assert_defaults(const struct scene *scene)
{
    assert_int_equal(scene->width, 256);
    assert_int_equal(scene->height, 256);
    for (int i = 0; i < 3; i++) {
        assert_int_equal(scene->clear[i], 0);
        assert_int_equal(scene->light.towards[i], 0);
    }
    assert_int_equal(scene->clear_depth, ONE);
    assert_false(scene->depth_test);
    assert_true(scene->depth_write);
    assert_int_equal(scene->cull, SCENE_CULL_NONE);
    assert_false(scene->flat);
    assert_int_equal(scene->provoking, 2);
    assert_false(scene->screen_linear);
    assert_false(scene->wireframe);
    assert_int_equal(scene->antialias, SCENE_ANTIALIAS_OFF);
    assert_int_equal(scene->texture_mode, SCENE_MODULATE);
    assert_int_equal(scene->texture.width, 0);
    assert_null(scene->texture.rgb);
    assert_false(scene->texture_clamp[0] || scene->texture_clamp[1]);
    assert_false(scene->texture_bilinear);
    assert_false(scene->texture_keyed);
    assert_int_equal(scene->texel_format, SCENE_TEXEL_XRGB8888);
    assert_int_equal(scene->depth_near, 0);
    assert_int_equal(scene->depth_far, ONE);
    assert_int_equal(scene->op_count, 0);
    assert_int_equal(scene->mesh_count, 0);
    assert_int_equal(scene->triangle_count, 0);
}

TEST(empty_scenes_have_defaults)
{
    const char *const texts[] = {"", "\n\n", "# viewport 1 1", "  \t\r\n#\r\n", "\xEF\xBB\xBF"};
    for (size_t i = 0; i < ARRAY_LENGTH(texts); i++) {
        struct scene scene = parse(texts[i]);
        assert_defaults(&scene);
        scene_free(&scene);
    }
}

TEST(state_statements)
{
    struct scene scene =
        parse("# first\n\nviewport 320 240\nclear .25 0.5 1 # sky\ncleardepth 0\n"
              "depth gequal\ndepthformat float16\ndepthmask off\ncull front\nshade flat first\n"
              "texmode replace\ninterpolate linear\npolygon line\n"
              "depthrange 1 .25\nlight .4 .6 -.7 .2 .8\n");
    assert_int_equal(scene.width, 320);
    assert_int_equal(scene.height, 240);
    assert_int_equal(scene.clear[0], ONE / 4);
    assert_int_equal(scene.clear[1], ONE / 2);
    assert_int_equal(scene.clear[2], ONE);
    assert_int_equal(scene.clear_depth, 0);
    assert_int_equal(scene.depth_format, SCENE_FLOAT16);
    assert_true(scene.depth_test);
    assert_false(scene.depth_write);
    assert_int_equal(scene.depth_compare, SCENE_GEQUAL);
    assert_int_equal(scene.cull, SCENE_CULL_FRONT);
    assert_true(scene.flat);
    assert_int_equal(scene.provoking, 0);
    assert_int_equal(scene.texture_mode, SCENE_REPLACE);
    assert_true(scene.screen_linear);
    assert_true(scene.wireframe);
    assert_int_equal(scene.depth_near, ONE);
    assert_int_equal(scene.depth_far, ONE / 4);
    assert_int_equal(scene.light.towards[0], 26214); /* .4 = 26214.4 */
    assert_int_equal(scene.light.towards[2], -45875);
    assert_int_equal(scene.light.ambient, 13107);
    assert_int_equal(scene.light.diffuse, 52429);
    assert_int_equal(scene.op_count, 0);
    scene_free(&scene);
}

TEST(masks_and_biases)
{
    struct scene scene = parse("colormask on off on\nblend replace\npoint 0 0 0 1 1 1 1\n"
                               "depthbias -.25\npoint 0 0 0 1 1 1 1\ndepthbias 0\n"
                               "point 0 0 0 1 1 1 1\n");
    assert_false(scene.keep[0] || scene.keep[2]);
    assert_true(scene.keep[1]);
    assert_int_equal(scene.blend, SCENE_BLEND_REPLACE);
    assert_int_equal(scene.op_count, 3);
    assert_int_equal(scene.ops[0].depth_bias, 0);
    assert_int_equal(scene.ops[1].depth_bias, -ONE / 4);
    assert_int_equal(scene.ops[2].depth_bias, 0);
    scene_free(&scene);
}

TEST(vertex_statements)
{
    struct scene scene = parse("vertexalpha 1 .5 0\ndepthslope -1.5\npoint 0 0 0 1 1 1 1\n"
                               "vertexalpha off\ndepthslope 0\npoint 0 0 0 1 1 1 1\n");
    assert_int_equal(scene.op_count, 2);
    assert_true(scene.ops[0].by_vertex);
    assert_int_equal(scene.ops[0].vertex_alpha[1], ONE / 2);
    assert_int_equal(scene.ops[0].vertex_alpha[2], 0);
    assert_int_equal(scene.ops[0].depth_slope, -ONE * 3 / 2);
    assert_false(scene.ops[1].by_vertex);
    assert_int_equal(scene.ops[1].depth_slope, 0);
    scene_free(&scene);
}

TEST(light_statements)
{
    struct scene scene = parse("ambient .25 .5 2\nlight directional 0 0 2 1 .5 0\n"
                               "light point 1 2 3 1 1 16\nlight point 1 2 3 1 1 1 .5 .25 2\n"
                               "light spot 1 2 3 0 -1 0 10 20 1 1 1\n"
                               "light spot 1 2 3 0 -1 0 10 20 1 1 1 0 0 1 4\n"
                               "material specular 1 .5 0 30\nmaterial emission .25 0 0\n"
                               "twosided on\ntexgen sphere\n"
                               "trin 0 0 0 1 1 0 0 0 0 1  1 0 0 1 0 1 0 0 1 0  "
                               "0 1 0 1 0 0 1 1 0 0\n");
    assert_true(scene.lamps_on);
    assert_int_equal(scene.ambient[2], 2 * ONE);
    assert_int_equal(scene.lamp_count, 5);
    assert_int_equal(scene.lamps[0].kind, SCENE_DIRECTIONAL);
    assert_int_equal(scene.lamps[0].position[2], 2 * ONE);
    assert_int_equal(scene.lamps[1].kind, SCENE_POINT);
    assert_int_equal(scene.lamps[1].color[2], 16 * ONE);
    assert_int_equal(scene.lamps[1].fade[0], ONE);
    assert_int_equal(scene.lamps[1].fade[2], 0);
    assert_int_equal(scene.lamps[2].fade[1], ONE / 4);
    assert_int_equal(scene.lamps[3].kind, SCENE_SPOT);
    assert_int_equal(scene.lamps[3].direction[1], -ONE);
    assert_int_equal(scene.lamps[3].outer, 20 * ONE);
    assert_int_equal(scene.lamps[3].exponent, 0);
    assert_int_equal(scene.lamps[4].exponent, 4 * ONE);
    assert_int_equal(scene.reflection.specular[1], ONE / 2);
    assert_int_equal(scene.reflection.shininess, 30 * ONE);
    assert_int_equal(scene.reflection.emission[0], ONE / 4);
    assert_false(scene.reflection.own_ambient);
    assert_true(scene.reflection.two_sided);
    assert_true(scene.texture_sphere);
    assert_int_equal(scene.ops[0].u.triangle.vertex[1].normal[1], ONE);
    assert_false(scene.ops[0].u.triangle.textured);
    scene_free(&scene);
    scene = parse("light 0 0 1 .2 .8\n");
    assert_false(scene.lamps_on);
    scene_free(&scene);
    char many[400] = "";
    for (int i = 0; i <= SCENE_MAX_LAMPS; i++) {
        strcat(many, "light point 0 0 0 1 1 1\n");
    }
    assert_error(many, "x.scene:8: light: more lights than can be drawn with");
}

TEST(the_last_statement_wins)
{
    struct scene scene =
        parse("viewport 1 4096\nclear 1 1 1\ncleardepth 0\ndepth never\n"
              "depthmask off\ncull back\nshade flat first\ntexture 2 2 1 1 2 3 4 5 6\n"
              "texmode replace\ninterpolate linear\npolygon line\ndepthrange 1 0\n"
              "clear 0 0 0\ncleardepth 1\ndepth off\ndepthmask on\ncull none\n"
              "shade smooth\ntexture off\ntexmode modulate\n"
              "texwrap clamp\ntexfilter bilinear\ntexformat gray8\ntexkey 1 2 3\n"
              "texwrap repeat\ntexfilter nearest\ntexformat xrgb8888\ntexkey off\n"
              "interpolate perspective\npolygon fill\ndepthrange 0 1\n");
    assert_int_equal(scene.width, 1);
    assert_int_equal(scene.height, 4096);
    scene.width = 256;
    scene.height = 256;
    assert_defaults(&scene);
    scene_free(&scene);
}

TEST(depth_comparisons)
{
    static const struct {
        const char *word;
        enum scene_compare compare;
    } cases[] = {
        {"less", SCENE_LESS},         {"lequal", SCENE_LEQUAL}, {"greater", SCENE_GREATER},
        {"gequal", SCENE_GEQUAL},     {"always", SCENE_ALWAYS}, {"equal", SCENE_EQUAL},
        {"notequal", SCENE_NOTEQUAL}, {"never", SCENE_NEVER},
    };
    for (size_t i = 0; i < ARRAY_LENGTH(cases); i++) {
        char text[40];
        (void)snprintf(text, sizeof text, "depth %s", cases[i].word);
        struct scene scene = parse(text);
        assert_true(scene.depth_test);
        assert_true(scene.depth_write);
        assert_int_equal(scene.depth_compare, cases[i].compare);
        scene_free(&scene);
    }
}

TEST(provoking_vertex)
{
    static const struct {
        const char *text;
        bool flat;
        int provoking;
    } cases[] = {
        {"shade flat", true, 2},
        {"shade flat last", true, 2},
        {"shade flat first", true, 0},
        {"shade smooth first", false, 0},
        {"shade flat first\nshade flat", true, 2},
    };
    for (size_t i = 0; i < ARRAY_LENGTH(cases); i++) {
        struct scene scene = parse(cases[i].text);
        assert_int_equal(scene.flat, cases[i].flat);
        assert_int_equal(scene.provoking, cases[i].provoking);
        scene_free(&scene);
    }
}

/* ---- Operations ---- */

static void assert_op(const struct scene *scene, size_t i, enum scene_op_kind kind, int line)
{
    assert_true(i < scene->op_count);
    assert_int_equal(scene->ops[i].kind, kind);
    assert_int_equal(scene->ops[i].line, line);
}

static void assert_numbers(const struct scene_op *op, int count, int first)
{
    for (int i = 0; i < 16; i++) {
        assert_int_equal(op->u.number[i], i < count ? (first + i) * ONE : 0);
    }
    assert_int_equal(op->id, 0);
}

TEST(matrix_statements)
{
    static const struct {
        enum scene_op_kind kind;
        int count, first;
    } expected[] = {
        {SCENE_MODE_PROJECTION, 0, 0},
        {SCENE_IDENTITY, 0, 0},
        {SCENE_LOAD, 16, 1},
        {SCENE_MULT, 16, -3},
        {SCENE_LOOKAT, 9, 1},
        {SCENE_PERSPECTIVE, 4, 5},
        {SCENE_FRUSTUM, 6, 2},
        {SCENE_ORTHO, 6, -2},
        {SCENE_MODE_MODELVIEW, 0, 0},
        {SCENE_TRANSLATE, 3, -1},
        {SCENE_ROTATE, 4, 30},
        {SCENE_SCALE, 3, 0},
        {SCENE_PUSH, 0, 0},
        {SCENE_POP, 0, 0},
    };
    struct scene scene = parse("mode projection\nidentity\n"
                               "load 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16\n"
                               "mult -3 -2 -1 0 1 2 3 4 5 6 7 8 9 10 11 12\n"
                               "lookat 1 2 3 4 5 6 7 8 9\nperspective 5 6 7 8\n"
                               "frustum 2 3 4 5 6 7\northo -2 -1 0 1 2 3\nmode modelview\n"
                               "translate -1 0 1\nrotate 30 31 32 33\nscale 0 1 2\npush\npop\n");
    assert_int_equal(scene.op_count, ARRAY_LENGTH(expected));
    for (size_t i = 0; i < ARRAY_LENGTH(expected); i++) {
        assert_op(&scene, i, expected[i].kind, (int)i + 1);
        assert_numbers(&scene.ops[i], expected[i].count, expected[i].first);
    }
    scene_free(&scene);
}

TEST(numbers_are_rounded)
{
    struct scene scene = parse("translate 0.1 -0.00000762939453125 1e-9\n");
    assert_int_equal(scene.ops[0].u.number[0], 6554);
    assert_int_equal(scene.ops[0].u.number[1], -1);
    assert_int_equal(scene.ops[0].u.number[2], 0);
    scene_free(&scene);
}

TEST(triangles)
{
    struct scene scene =
        parse("tri 1 2 3 4 .5 0 1  5 6 7 8 0 1 0  9 10 11 12 0 0 1\nidentity\n"
              "trit 1 2 3 4 .5 0 1 -3 7  5 6 7 8 0 1 0 1 2  9 10 11 12 0 0 1 .5 .25\n");
    assert_int_equal(scene.op_count, 3);
    assert_int_equal(scene.triangle_count, 2);
    assert_op(&scene, 0, SCENE_TRIANGLE, 1);
    assert_op(&scene, 2, SCENE_TRIANGLE, 3);
    assert_int_equal(scene.ops[0].id, 1);
    assert_int_equal(scene.ops[2].id, 2);
    assert_false(scene.ops[0].u.triangle.textured);
    assert_true(scene.ops[2].u.triangle.textured);
    for (size_t op = 0; op < 3; op += 2) {
        const struct scene_vertex *vertex = scene.ops[op].u.triangle.vertex;
        for (int i = 0; i < 12; i++) {
            assert_int_equal(vertex[i / 4].position[i % 4], (i + 1) * ONE);
        }
        assert_int_equal(vertex[0].color[0], ONE / 2);
        assert_int_equal(vertex[0].color[2], ONE);
        assert_int_equal(vertex[1].color[1], ONE);
        assert_int_equal(vertex[2].color[2], ONE);
        assert_int_equal(vertex[0].uv[0], op == 0 ? 0 : -3 * ONE);
        assert_int_equal(vertex[0].uv[1], op == 0 ? 0 : 7 * ONE);
        assert_int_equal(vertex[2].uv[1], op == 0 ? 0 : ONE / 4);
    }
    scene_free(&scene);
}

TEST(passes_have_bounds)
{
    static const char large[] = "texture 1024 1024 4 1 1 1 2 2 2\npass\n", plain[] = "pass\n";
    char text[1024 * sizeof plain];
    size_t length = 0;
    for (int i = 0; i < 17; i++) {
        length += (size_t)snprintf(text + length, sizeof text - length, "%s", large);
    }
    assert_error(text,
                 "x.scene:33: texture: the textures of all passes have more than 16777216 texels");
    for (length = 0; length < 1024 * (sizeof plain - 1);) {
        length += (size_t)snprintf(text + length, sizeof text - length, "%s", plain);
    }
    assert_error(text, "x.scene:1024: pass: there are too many");
    assert_error("clear 0 0 0\npass\nviewport 9 9\n",
                 "x.scene:3: viewport: must be the first statement");
    assert_error("push\npass\npop\n", "x.scene:3: pop: without a push on the same stack");
}

TEST(stacks)
{
    char text[40 * 10] = "";
    for (int i = 0; i < SCENE_STACK_DEPTH; i++) {
        strcat(text, "push\n");
    }
    struct scene scene = parse(text); /* left open at the end */
    assert_int_equal(scene.op_count, SCENE_STACK_DEPTH);
    scene_free(&scene);

    strcat(text, "mode projection\npush\n");
    scene = parse(text); /* a stack of its own */
    scene_free(&scene);
    strcat(text, "mode modelview\npop\npush\npush\n");
    assert_error(text, "x.scene:38: push: nested too deep");
    assert_error("pop\n", "x.scene:1: pop: without a push on the same stack");
    assert_error("push\npop\npop\n", "x.scene:3: pop: without a push on the same stack");
    assert_error("mode projection\npush\npop\nmode modelview\npush\nmode projection\npop\n",
                 "x.scene:7: pop: without a push on the same stack");
    assert_error("push\nmode projection\npop\n",
                 "x.scene:3: pop: without a push on the same stack");
}

/* ---- Textures ---- */

TEST(checkerboard)
{
    /* 3 fields over 8 x 4 texels: columns begin at texels 0, 3, 6, rows at 0, 2, 3. */
    static const char *const expected[4] = {"00011100", "00011100", "11100011", "00011100"};
    struct scene scene = parse("texture 1 1 1 9 9 9 9 9 9\ntexture 8 4 3 1 2 3 255 0 254\n");
    assert_int_equal(scene.texture.width, 8);
    assert_int_equal(scene.texture.height, 4);
    for (int y = 0; y < 4; y++) {
        for (int x = 0; x < 8; x++) {
            const uint8_t *texel = &scene.texture.rgb[3 * (8 * y + x)];
            assert_memory_equal(texel, expected[y][x] == '0' ? "\1\2\3" : "\377\0\376", 3);
        }
    }
    scene_free(&scene);
}

TEST(checkerboard_sizes)
{
    struct scene scene = parse("texture 1024 1 1 1 2 3 4 5 6\n");
    assert_memory_equal(&scene.texture.rgb[3 * 1023], "\1\2\3", 3);
    scene_free(&scene);
    scene = parse("texture 1024 1024 1024 1 2 3 4 5 6\n");
    assert_memory_equal(&scene.texture.rgb[3 * 1024 * 1023], "\4\5\6\1\2\3", 6);
    scene_free(&scene);
    assert_error("texture 3 4 1 0 0 0 0 0 0\n", "x.scene:1: texture: '3' is not a power of two");
    assert_error("texture 4 0 1 0 0 0 0 0 0\n",
                 "x.scene:1: texture: '0' is not a whole number in 1..1024");
    assert_error("texture 2048 4 1 0 0 0 0 0 0\n",
                 "x.scene:1: texture: '2048' is not a whole number in 1..1024");
    assert_error("texture 8 4 5 0 0 0 0 0 0\n",
                 "x.scene:1: texture: '5' is not a whole number in 1..4");
    assert_error("texture 8 4 0 0 0 0 0 0 0\n",
                 "x.scene:1: texture: '0' is not a whole number in 1..4");
    assert_error("texture 8 4 1 0 0 0 0 0 256\n",
                 "x.scene:1: texture: '256' is not a whole number in 0..255");
    assert_error("texture 8 4 1 0 0 0 0 0 .5\n",
                 "x.scene:1: texture: '.5' is not a whole number in 0..255");
}

TEST_WITH(texture_from_a_file, in_folder, out_of_folder)
{
    (void)io_write("t.ppm", LITERAL("P6 2 1 255\nabcdef"));
    (void)io_write("odd.ppm", LITERAL("P6 1 3 255\nabcdefghi"));
    (void)io_write("cut.ppm", LITERAL("P6 2 1 255\nabcde"));
    struct scene scene = parse("texture t.ppm\n" TRIT);
    assert_int_equal(scene.texture.width, 2);
    assert_int_equal(scene.texture.height, 1);
    assert_memory_equal(scene.texture.rgb, "abcdef", 6);
    scene_free(&scene);

    char text[PATH_SIZE + 40];
    (void)snprintf(text, sizeof text, "texture %s\n", io_path("t.ppm"));
    scene = parse(text); /* an absolute path */
    assert_int_equal(scene.texture.width, 2);
    scene_free(&scene);

    assert_error_in_folder("\ntexture none.ppm\n", "2: texture: @/none.ppm does not exist");
    assert_error_in_folder("texture none.ppm\ntexture off\n",
                           "1: texture: @/none.ppm does not exist");
    assert_error_in_folder("texture .\n", "1: texture: @/. is not an ordinary file");
    assert_error_in_folder("texture /dev/zero\n", "1: texture: /dev/zero is not an ordinary file");
    assert_error_in_folder(
        "\n\ntexture odd.ppm\n" TRI,
        "3: texture: @/odd.ppm is 1 x 3; sides must be powers of two up to 1024");
    assert_error_in_folder("texture cut.ppm\n" TRI,
                           "1: texture: @/cut.ppm: the PPM ends before its last pixel");
    assert_error_in_folder("texture t\x01.ppm\n", "1: texture: 't?.ppm' is not a file name");
}

TEST(texture_state)
{
    static const char *const formats[] = {
        [SCENE_TEXEL_XRGB8888] = "xrgb8888",     [SCENE_TEXEL_RGB565] = "rgb565",
        [SCENE_TEXEL_PALETTE] = "palette",       [SCENE_TEXEL_GRAY8] = "gray8",
        [SCENE_TEXEL_PALETTE565] = "palette565", [SCENE_TEXEL_ARGB4444] = "argb4444",
        [SCENE_TEXEL_ARGB1555] = "argb1555",     [SCENE_TEXEL_ARGB8888] = "argb8888",
        [SCENE_TEXEL_ALPHA8] = "alpha8",
    };
    for (size_t i = 0; i < ARRAY_LENGTH(formats); i++) {
        char text[200];
        (void)snprintf(text, sizeof text, "texformat %s\ntexture 4 4 2 1 2 3 4 5 6\n", formats[i]);
        struct scene scene = parse(text);
        assert_int_equal(scene.texel_format, i);
        assert_memory_equal(scene.texture.rgb, "\1\2\3", 3); /* converted by those who draw */
        scene_free(&scene);
    }
    struct scene scene = parse("texwrap clamp\ntexfilter bilinear\ntexkey 0 128 255\n");
    assert_true(scene.texture_clamp[0] && scene.texture_clamp[1]);
    assert_true(scene.texture_bilinear && scene.texture_keyed && !scene.texture_mipmapped);
    assert_memory_equal(scene.texture_key, "\0\200\377", 3);
    scene_free(&scene);
    scene = parse("texwrap clamp repeat\n");
    assert_true(scene.texture_clamp[0] && !scene.texture_clamp[1]);
    scene_free(&scene);
    scene = parse("texwrap repeat clamp\n");
    assert_true(!scene.texture_clamp[0] && scene.texture_clamp[1]);
    scene_free(&scene);
}

/* 16 x 32 texels of `count` colours. */
static void write_colors(const char *name, int count)
{
    static const char header[] = "P6 16 32 255\n";
    uint8_t file[sizeof header - 1 + 3 * 512] = {0};
    memcpy(file, header, sizeof header - 1);
    for (int i = 0; i < 512; i++) {
        uint8_t *rgb = &file[sizeof header - 1 + 3 * (size_t)i];
        rgb[0] = (uint8_t)(i % count);
        rgb[1] = (uint8_t)(i % count / 256);
    }
    (void)io_write(name, file, sizeof file);
}

/* 256 colours fit a palette; the message for more names the statement that asked for one. */
TEST_WITH(palettes, in_folder, out_of_folder)
{
    write_colors("fits.ppm", 256);
    write_colors("more.ppm", 257);
    struct scene scene = parse("texformat palette\ntexture fits.ppm\n" TRIT);
    assert_int_equal(scene.texture.height, 32);
    struct palette palette;
    uint8_t numbers[512];
    assert_true(palette_make(&palette, scene.texture.rgb, 512, numbers));
    assert_int_equal(palette.count, 256);
    for (size_t i = 0; i < 512; i++) {
        assert_memory_equal(palette.color[numbers[i]], &scene.texture.rgb[3 * i], 3);
    }
    assert_int_equal(palette_find(&palette, (const uint8_t[3]){7, 0, 0}), 7);
    assert_int_equal(palette_find(&palette, (const uint8_t[3]){7, 1, 0}), -1);
    scene_free(&scene);
    assert_error_in_folder("texformat palette\n\ntexture more.ppm\n" TRIT,
                           "1: texformat: the texture of line 3 has more than 256 colours");
    scene = parse("texformat palette\ntexture more.ppm\ntexformat rgb565\n" TRIT);
    scene_free(&scene);
    scene = parse("texformat palette\n" TRIT);
    assert_null(scene.texture.rgb);
    scene_free(&scene);
}

/* ---- Meshes ---- */

TEST_WITH(meshes_are_read_once, in_folder, out_of_folder)
{
    (void)io_write_text("one.obj", ONE_FACE);
    (void)io_write_text("two.obj", TWO_FACES);
    struct scene scene = parse("mesh two.obj\n" TRI "mesh one.obj color .5 1 0\n"
                               "mesh ./two.obj color 0 0 0\nmesh two.obj\n" TRIT);
    assert_int_equal(scene.mesh_count, 2);
    assert_int_equal(scene.meshes[0].triangle_count, 2);
    assert_int_equal(scene.meshes[1].triangle_count, 1);
    static const struct {
        enum scene_op_kind kind;
        uint32_t id;
        size_t mesh;
    } expected[] = {
        {SCENE_MESH, 1, 0}, {SCENE_TRIANGLE, 3, 0}, {SCENE_MESH, 4, 1},
        {SCENE_MESH, 5, 0}, {SCENE_MESH, 7, 0},     {SCENE_TRIANGLE, 9, 0},
    };
    assert_int_equal(scene.op_count, ARRAY_LENGTH(expected));
    for (size_t i = 0; i < ARRAY_LENGTH(expected); i++) {
        assert_op(&scene, i, expected[i].kind, (int)i + 1);
        assert_int_equal(scene.ops[i].id, expected[i].id);
        if (expected[i].kind == SCENE_MESH) {
            assert_int_equal(scene.ops[i].u.mesh.mesh, expected[i].mesh);
        }
    }
    assert_int_equal(scene.triangle_count, 9);
    assert_int_equal(scene.ops[0].u.mesh.color[0], ONE);
    assert_int_equal(scene.ops[0].u.mesh.color[2], ONE);
    assert_int_equal(scene.ops[2].u.mesh.color[0], ONE / 2);
    assert_int_equal(scene.ops[2].u.mesh.color[2], 0);
    scene_free(&scene);
}

/* A file in another scale is another mesh. */
TEST_WITH(meshes_are_scaled, in_folder, out_of_folder)
{
    (void)io_write_text("small.obj", "v 0 0 0\nv .00001 0 0\nv 0 .000005 0\nf 1 2 3\n");
    struct scene scene = parse("mesh small.obj\nmesh small.obj fit 2\n"
                               "mesh small.obj scale 1e5 color 0 1 0\n"
                               "mesh small.obj fit 2 color 0 .5 0\nmesh small.obj color 1 1 0\n");
    static const size_t mesh[] = {0, 1, 2, 1, 0};
    static const int32_t far_x[] = {1, 2 * ONE, ONE};
    static const int32_t far_y[] = {0, ONE, ONE / 2};
    assert_int_equal(scene.mesh_count, 3);
    assert_int_equal(scene.op_count, ARRAY_LENGTH(mesh));
    for (size_t i = 0; i < ARRAY_LENGTH(mesh); i++) {
        assert_int_equal(scene.ops[i].u.mesh.mesh, mesh[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        assert_int_equal(scene.meshes[i].positions[1][0], far_x[i]);
        assert_int_equal(scene.meshes[i].positions[2][1], far_y[i]);
    }
    assert_int_equal(scene.ops[2].u.mesh.color[0], 0);
    assert_int_equal(scene.ops[3].u.mesh.color[1], ONE / 2);
    scene_free(&scene);
}

TEST_WITH(mesh_errors, in_folder, out_of_folder)
{
    (void)io_write_text("bad.obj", ONE_FACE "f 1 2 9\n");
    (void)io_write_text("one.obj", ONE_FACE);
    assert_error_in_folder("mesh one.obj\nmesh bad.obj\n",
                           "2: mesh: @/bad.obj:5: index 9 is out of range: "
                           "the file has 3 v statements");
    assert_error_in_folder("mesh none.obj\n", "1: mesh: @/none.obj does not exist");
    assert_error_in_folder("mesh .\n", "1: mesh: @/. is not an ordinary file");
    assert_error_in_folder("mesh /dev/zero\n", "1: mesh: /dev/zero is not an ordinary file");
    assert_error_in_folder(
        "mesh one.obj colour 1 1 1\n",
        "1: 'colour' is unknown here: mesh FILE.obj [fit SIZE | scale FACTOR] [color r g b]");
    assert_error_in_folder("mesh one.obj fit 0\n", "1: mesh: '0' is not a size of .001 to 65534");
    assert_error_in_folder("mesh one.obj fit nan\n",
                           "1: mesh: 'nan' is not a size of .001 to 65534");
    assert_error_in_folder("mesh one.obj scale -1\n",
                           "1: mesh: '-1' is not a factor of 1e-9 to 1e9");
    assert_error_in_folder("mesh one.obj scale 1e9 color 1 1 1\n",
                           "1: mesh: @/one.obj: does not fit Q16.16 when it is scaled");
    assert_error_in_folder("mesh one.obj color 1 1 1.5\n", "1: mesh: '1.5' does not lie in 0..1");
    assert_error_in_folder(
        "mesh one.obj color 1 1\n",
        "1: wrong number of values (4) for mesh FILE.obj [fit SIZE | scale FACTOR] [color r g b]");
    assert_error_in_folder(
        "mesh\n",
        "1: wrong number of values (0) for mesh FILE.obj [fit SIZE | scale FACTOR] [color r g b]");
}

TEST_WITH(scene_files, NULL, io_remove_files)
{
    struct scene scene;
    struct text_error error;
    (void)io_write_text("two.obj", TWO_FACES);
    assert_true(scene_read(io_write_text("s", "viewport 8 8\nmesh two.obj"), &scene, &error));
    assert_int_equal(scene.triangle_count, 2);
    scene_free(&scene);
    assert_true(scene_read(io_write_text("empty", ""), &scene, &error));
    assert_defaults(&scene);
    scene_free(&scene);
    assert_false(scene_read(io_path("none"), &scene, &error));
    assert_non_null(strstr(error.message, "/none: cannot be opened: No such file"));
    assert_false(scene_read(io_folder, &scene, &error));
    assert_non_null(strstr(error.message, ": cannot be read: Is a directory"));
    assert_false(scene_read(io_write_text("s", "\nviewport 64"), &scene, &error));
    assert_non_null(strstr(error.message, "/s:2: wrong number of values (1) for viewport W H"));
}

TEST(model_in_a_scene)
{
    const char *path = model_path("spot.obj");
    if (path == NULL) {
        skip();
    }
    char text[PATH_SIZE + 200];
    (void)snprintf(text, sizeof text, TRI "mesh %s\n" TRI, path);
    struct scene scene = parse(text);
    assert_int_equal(scene.ops[1].id, 2);
    assert_int_equal(scene.ops[2].id, 2 + 5856);
    assert_int_equal(scene.triangle_count, 5858);
    scene_free(&scene);
}

/* ---- Errors ---- */

TEST(viewport_errors)
{
    assert_error("clear 0 0 0\nviewport 8 8\n", "x.scene:2: viewport: must be the first statement");
    assert_error("viewport 8 8\nviewport 8 8\n",
                 "x.scene:2: viewport: must be the first statement");
    assert_error("viewport 0 8\n", "x.scene:1: viewport: '0' is not a whole number in 1..4096");
    assert_error("viewport 8 4097\n",
                 "x.scene:1: viewport: '4097' is not a whole number in 1..4096");
    assert_error("viewport 8.0 8\n", "x.scene:1: viewport: '8.0' is not a whole number in 1..4096");
    assert_error("viewport -8 8\n", "x.scene:1: viewport: '-8' is not a whole number in 1..4096");
    assert_error("viewport 8\n", "x.scene:1: wrong number of values (1) for viewport W H");
    assert_error("viewport 8 8 8\n", "x.scene:1: wrong number of values (3) for viewport W H");
}

TEST(value_errors)
{
    static const char *const cases[][2] = {
        {"clear 0 0 1.1", "clear: '1.1' does not lie in 0..1"},
        {"clear -.1 0 1", "clear: '-.1' does not lie in 0..1"},
        {"clear 0 0 x", "clear: 'x' is not a number"},
        {"depthbias 1.5", "depthbias: the bias must lie between -1 and 1"},
        {"vertexalpha 1 1 2", "vertexalpha: '2' does not lie in 0..1"},
        {"vertexalpha 1", "'1' is unknown here: vertexalpha off or vertexalpha A0 A1 A2"},
        {"colormask on off red", "'red' is unknown here: colormask on|off on|off on|off"},
        {"cleardepth 2", "cleardepth: '2' does not lie in 0..1"},
        {"depthrange 0 1.5", "depthrange: '1.5' does not lie in 0..1"},
        {"depthrange -1 1", "depthrange: '-1' does not lie in 0..1"},
        {"light 0 0 0 .5 .5", "light: the direction must not be zero"},
        {"light 1e-9 0 0 .5 .5", "light: the direction must not be zero"},
        {"light 0 0 1 1.5 .5", "light: '1.5' does not lie in 0..1"},
        {"light 0 0 1 .5 -.5", "light: '-.5' does not lie in 0..1"},
        {"light directional 0 0 0 1 1 1", "light: the direction must not be zero"},
        {"light directional 0 0 1 1 17 1", "light: '17' does not lie in 0..16"},
        {"light point 0 0 1 1 1 1 1 -1 0", "light: '-1' must not be below 0"},
        {"light spot 0 0 1 0 0 0 10 20 1 1 1", "light: the direction must not be zero"},
        {"light spot 0 0 1 0 0 1 10 181 1 1 1", "light: '181' is not an angle of 0..180 degrees"},
        {"light spot 0 0 1 0 0 1 9 9 1 1 1 1 0 0 .5", "light: '.5' does not lie in 1..1024"},
        {"ambient 0 0 -1", "ambient: '-1' does not lie in 0..16"},
        {"material specular 1 1 1 0", "material: '0' does not lie in 1..1024"},
        {"material emission 1 1 2", "material: '2' does not lie in 0..1"},
        {"twosided yes", "'yes' is unknown here: twosided off|on"},
        {"texgen on", "'on' is unknown here: texgen off|sphere"},
        {"translate 40000 0 0", "translate: '40000' does not fit Q16.16"},
        {"translate 0 0 0x10", "translate: '0x10' is not a number"},
        {"scale nan 1 1", "scale: 'nan' is not a number"},
        {"tri 0 0 0 1 1 0 0 1 0 0 1 0 1 0 0 1 0 1 0 0 2", "tri: '2' does not lie in 0..1"},
        {"depth sideways", "'sideways' is unknown here: depth "
                           "off|less|lequal|greater|gequal|always|equal|notequal|never"},
        {"depth on", "'on' is unknown here: depth "
                     "off|less|lequal|greater|gequal|always|equal|notequal|never"},
        {"depthmask maybe", "'maybe' is unknown here: depthmask on|off"},
        {"cull both", "'both' is unknown here: cull none|back|front"},
        {"shade round", "'round' is unknown here: shade smooth|flat|pixel [first|last]"},
        {"shade flat middle", "'middle' is unknown here: shade smooth|flat|pixel [first|last]"},
        {"texmode add", "'add' is unknown here: texmode replace|modulate"},
        {"texwrap mirror", "'mirror' is unknown here: texwrap repeat|clamp [repeat|clamp]"},
        {"texwrap clamp off", "'off' is unknown here: texwrap repeat|clamp [repeat|clamp]"},
        {"texfilter linear", "'linear' is unknown here: texfilter nearest|bilinear [mipmaps]"},
        {"texfilter nearest mips", "'mips' is unknown here: texfilter nearest|bilinear [mipmaps]"},
        {"texformat cmyk", "'cmyk' is unknown here: texformat xrgb8888|rgb565|palette|gray8|"
                           "palette565|argb4444|argb1555|argb8888|alpha8"},
        {"texkey on", "'on' is unknown here: texkey off or texkey r g b"},
        {"texkey 1 2 256", "texkey: '256' is not a whole number in 0..255"},
        {"texkey 1 2", "wrong number of values (2) for texkey off or texkey r g b"},
        {"interpolate cubic", "'cubic' is unknown here: interpolate perspective|linear"},
        {"polygon point", "'point' is unknown here: polygon fill|line|smooth|wide|hidden [BIAS]"},
        {"mode texture", "'texture' is unknown here: mode projection|modelview"},
    };
    for (size_t i = 0; i < ARRAY_LENGTH(cases); i++) {
        char text[200], expected[300];
        (void)snprintf(text, sizeof text, "viewport 8 8\r\n# two\r\n%s\r\n", cases[i][0]);
        (void)snprintf(expected, sizeof expected, "x.scene:3: %s", cases[i][1]);
        assert_error(text, expected);
    }
}

TEST(camera_errors)
{
    static const char *const cases[][2] = {
        {"lookat 1 2 3 1 2 3 0 1 0", "lookat: the eye and the center must differ"},
        {"lookat 1 2 3 0 0 0 0 0 0", "lookat: the up vector must not be zero"},
        {"perspective 0 1 .1 10",
         "perspective: the field of view must lie between 0 and 180 degrees"},
        {"perspective 180 1 .1 10",
         "perspective: the field of view must lie between 0 and 180 degrees"},
        {"perspective 60 0 .1 10", "perspective: the aspect must be greater than 0"},
        {"perspective 60 -1 .1 10", "perspective: the aspect must be greater than 0"},
        {"perspective 60 1 0 10", "perspective: near and far must be greater than 0"},
        {"perspective 60 1 .1 -10", "perspective: near and far must be greater than 0"},
        {"perspective 60 1 1 1", "perspective: near and far must differ"},
        {"perspective 60 1 .000001 1", "perspective: near and far must be greater than 0"},
        {"frustum 1 1 -1 1 .1 10", "frustum: left and right must differ"},
        {"frustum -1 1 2 2 .1 10", "frustum: bottom and top must differ"},
        {"frustum -1 1 -1 1 0 10", "frustum: near and far must be greater than 0"},
        {"frustum -1 1 -1 1 10 10", "frustum: near and far must differ"},
        {"ortho 1 1 -1 1 -1 1", "ortho: left and right must differ"},
        {"ortho -1 1 0 0 -1 1", "ortho: bottom and top must differ"},
        {"ortho -1 1 -1 1 1 1", "ortho: near and far must differ"},
        {"rotate 45 0 0 0", "rotate: the axis must not be zero"},
    };
    for (size_t i = 0; i < ARRAY_LENGTH(cases); i++) {
        char text[200], expected[200];
        (void)snprintf(text, sizeof text, "identity\n%s\n", cases[i][0]);
        (void)snprintf(expected, sizeof expected, "x.scene:2: %s", cases[i][1]);
        assert_error(text, expected);
    }
    const char *const allowed[] = {"lookat 0 0 3 0 0 0 0 0 1",
                                   "perspective 179.99 .5 10 .1",
                                   "perspective .001 1 1 2",
                                   "frustum 1 -1 1 -1 10 .1",
                                   "ortho 1 -1 1 -1 -10 10",
                                   "scale 0 0 0",
                                   "load 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0"};
    for (size_t i = 0; i < ARRAY_LENGTH(allowed); i++) {
        struct scene scene = parse(allowed[i]);
        assert_int_equal(scene.op_count, 1);
        scene_free(&scene);
    }
}

/* One value too many and one too few, for every statement that has a fixed number. */
TEST(wrong_number_of_values)
{
    static const struct {
        const char *name;
        int count;
    } cases[] = {
        {"viewport", 2},    {"clear", 3},     {"cleardepth", 1},  {"depth", 1},
        {"depthmask", 1},   {"cull", 1},      {"texmode", 1},     {"depthrange", 2},
        {"interpolate", 1}, {"alphatest", 1}, {"ambient", 3},     {"mode", 1},
        {"identity", 0},    {"load", 16},     {"mult", 16},       {"lookat", 9},
        {"perspective", 4}, {"frustum", 6},   {"ortho", 6},       {"translate", 3},
        {"rotate", 4},      {"scale", 3},     {"push", 0},        {"pop", 0},
        {"tri", 21},        {"trit", 27},     {"trin", 30},       {"tritn", 36},
        {"twosided", 1},    {"texgen", 1},    {"depthformat", 1},
    };
    for (size_t i = 0; i < ARRAY_LENGTH(cases); i++) {
        for (int count = cases[i].count - 1; count <= cases[i].count + 1; count += 2) {
            char text[200], expected[100];
            struct scene scene;
            struct text_error error;
            size_t used = (size_t)snprintf(text, sizeof text, "\n%s", cases[i].name);
            for (int j = 0; j < count; j++) {
                used += (size_t)snprintf(text + used, sizeof text - used, " 1");
            }
            if (count >= 0) {
                (void)snprintf(expected, sizeof expected,
                               "x.scene:2: wrong number of values (%d) for %s", count,
                               cases[i].name);
                assert_false(scene_parse("x.scene", text, used, &scene, &error));
                assert_memory_equal(error.message, expected, strlen(expected));
            }
        }
    }
    assert_error("shade\n",
                 "x.scene:1: wrong number of values (0) for shade smooth|flat|pixel [first|last]");
    assert_error("texture 8 8\n", "x.scene:1: wrong number of values (2) for texture "
                                  "off, texture FILE.ppm or texture W H CELLS r g b r g b");
}

TEST(what_is_no_scene)
{
    assert_error(TRI "sphere 1\n", "x.scene:2: 'sphere' is not a statement");
    assert_error("Tri\n", "x.scene:1: 'Tri' is not a statement");
    assert_error("identity junk\n", "x.scene:1: wrong number of values (1) for identity");
    assert_error_bytes(LITERAL("identity\n\x89PNG\r\n\x1A\n"),
                       "x.scene:2: '?PNG' is not a statement");
    assert_error_bytes(LITERAL("\n\n\0\1\2"),
                       "x.scene:3: '?\?\?' is not text: is this a scene file?");
    assert_error_bytes(LITERAL("cleardepth 1\0\n"), "x.scene:1: cleardepth: '1?' is not a number");
    assert_error_bytes(LITERAL("push\\\npop"), "x.scene:1: 'push\\' is not a statement");
}

TEST(very_long_lines)
{
    const size_t length = 1000000;
    char *text = malloc(length);
    assert_non_null(text);
    memset(text, '1', length);
    memcpy(text, "\nidentity\n#", 11); /* a comment */
    struct scene scene = parse_bytes(text, length);
    assert_int_equal(scene.op_count, 1);
    scene_free(&scene);
    memcpy(text, "\npush\npush ", 11);
    for (size_t i = 11; i < length; i += 2) { /* half a million values */
        text[i] = ' ';
    }
    assert_error_bytes(text, length, "x.scene:3: wrong number of values (499994) for push");
    memset(text, 'z', length);
    assert_error_bytes(text, length,
                       "x.scene:1: 'zzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzz...' "
                       "is not a statement");
    memset(text, ' ', length);
    memcpy(text, "cleardepth", 10);
    text[length - 1] = '0';
    scene = parse_bytes(text, length);
    assert_int_equal(scene.clear_depth, 0);
    scene_free(&scene);
    free(text);
}

/* Costs its length only: a thousand large textures, of which one is made. */
TEST(many_statements)
{
    static const char line[] = "texture 1024 1024 8 255 255 255 0 0 0\n" TRI;
    const size_t length = sizeof line - 1, count = 5000;
    char *text = malloc(length * count);
    assert_non_null(text);
    for (size_t i = 0; i < count; i++) {
        memcpy(text + i * length, line, length);
    }
    struct scene scene = parse_bytes(text, length * count);
    assert_int_equal(scene.triangle_count, count);
    assert_int_equal(scene.ops[count - 1].id, count);
    assert_int_equal(scene.ops[count - 1].line, 2 * count);
    scene_free(&scene);
    free(text);
}

int main(void)
{
    return run_all_tests(io_setup, io_teardown);
}
