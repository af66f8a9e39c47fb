/* SPDX-License-Identifier: MIT */
/*
 * Scene files: poses, joints, windows, computed and mixed meshes, alpha of textures; what they
 * leave in the scene, and every error with its line.
 */
#define _POSIX_C_SOURCE 200809L
#include "support/io.h"

#include "io/scene.h"

#define KEY(time)  "key " #time " 1 2 3 90 0 0 1 1 1 1\n"
#define ONE_FACE   "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
#define OTHER_FACE "v 0 0 1\nv 2 0 0\nv 0 1 0\nf 1 2 3\n"
#define TWO_FACES  "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"

static char name[PATH_SIZE]; /* what the parser is told */

static bool read_scene(const char *text, struct scene *scene, struct text_error *error)
{
    (void)snprintf(name, sizeof name, "%s", io_path("x.scene"));
    char *copy = exact_copy(text, strlen(text));
    const bool ok = scene_parse(name, copy, strlen(text), scene, error);
    free(copy);
    return ok;
}

static struct scene parse(const char *text)
{
    struct scene scene;
    struct text_error error;
    if (!read_scene(text, &scene, &error)) {
        fail_msg("%s", error.message);
    }
    return scene;
}

/* `expected` follows the file's name and a colon. */
static void assert_error(const char *text, const char *expected)
{
    struct scene scene;
    struct text_error error;
    if (read_scene(text, &scene, &error)) {
        fail_msg("accepted: %.80s", text);
    }
    assert_memory_equal(error.message, name, strlen(name));
    assert_string_equal(error.message + strlen(name) + 1, expected);
    assert_null(scene.ops);
    assert_null(scene.keys);
    assert_null(scene.models);
    assert_null(scene.texture.alpha);
}

TEST(keys)
{
    struct scene scene = parse(KEY(0) KEY(1) "keys .5\nkeys 7\n" KEY(0) "keys 0\n");
    assert_int_equal(scene.key_count, 3);
    assert_int_equal(scene.op_count, 3);
    static const struct {
        size_t first, count;
        int32_t time;
    } expected[] = {{0, 2, ONE / 2}, {0, 2, 7 * ONE}, {2, 1, 0}};
    for (size_t i = 0; i < 3; i++) {
        assert_int_equal(scene.ops[i].kind, SCENE_KEYS);
        assert_int_equal(scene.ops[i].u.track.first, expected[i].first);
        assert_int_equal(scene.ops[i].u.track.count, expected[i].count);
        assert_int_equal(scene.ops[i].u.track.time, expected[i].time);
    }
    assert_int_equal(scene.keys[1].time, ONE);
    assert_int_equal(scene.keys[1].position[2], 3 * ONE);
    assert_int_equal(scene.keys[1].degrees, 90 * ONE);
    assert_int_equal(scene.keys[1].axis[2], ONE);
    assert_int_equal(scene.keys[1].scale[0], ONE);
    scene_free(&scene);
    assert_error("keys 1\n", "1: keys: without a key before it");
    assert_error(KEY(1) KEY(1), "2: key: the time must grow from key to key");
    assert_error(KEY(1) "keys 1\n" KEY(1) KEY(.5), "4: key: the time must grow from key to key");
    assert_error("key 0 1 2 3 90 0 0 0 1 1 1\n", "1: key: the axis must not be zero");
    assert_error("key 0 1 2\n", "1: wrong number of values (3) for key time x y z degrees ax ay az "
                                "sx sy sz");
}

TEST(joints_and_billboards)
{
    struct scene scene = parse("joint none\njoint 0\njoint 0\natjoint 2\ncamera\nbillboard\n"
                               "billboard upright\n");
    static const struct {
        enum scene_op_kind kind;
        int32_t number;
    } expected[] = {{SCENE_JOINT, -1},   {SCENE_JOINT, 0},  {SCENE_JOINT, 0},
                    {SCENE_AT_JOINT, 2}, {SCENE_CAMERA, 0}, {SCENE_BILLBOARD, 0},
                    {SCENE_BILLBOARD, 1}};
    assert_int_equal(scene.op_count, ARRAY_LENGTH(expected));
    for (size_t i = 0; i < ARRAY_LENGTH(expected); i++) {
        assert_int_equal(scene.ops[i].kind, expected[i].kind);
        assert_int_equal(scene.ops[i].u.number[0], expected[i].number);
    }
    scene_free(&scene);
    assert_error("joint 0\n", "1: joint: without a joint before it");
    assert_error("atjoint 0\n", "1: atjoint: without a joint before it");
    assert_error("joint none\njoint 1\n", "2: joint: '1' is not a whole number in 0..0");
    assert_error("joint none\njoint 0\natjoint 2\n",
                 "3: atjoint: '2' is not a whole number in 0..1");
    assert_error("billboard\n", "1: billboard: without a camera before it");
    assert_error("camera\nbillboard flat\n", "2: 'flat' is unknown here: billboard [upright]");
    char text[SCENE_MAX_JOINTS * 12 + 24] = "";
    for (int i = 0; i <= SCENE_MAX_JOINTS; i++) {
        strcat(text, "joint none\n");
    }
    assert_error(text, "65: joint: more joints than a scene can have");
}

TEST(windows)
{
    struct scene scene = parse("window -5 6 70 80\nwindow 1 2 3 4 bottom\n");
    static const int32_t expected[2][5] = {{-5, 6, 70, 80, 0}, {1, 2, 3, 4, 1}};
    for (size_t i = 0; i < 2; i++) {
        assert_int_equal(scene.ops[i].kind, SCENE_WINDOW);
        assert_memory_equal(scene.ops[i].u.number, expected[i], sizeof expected[i]);
    }
    scene_free(&scene);
    assert_error("window 0 0 0 4\n", "1: window: '0' is not a whole number in 1..4096");
    assert_error("window 0 4097 1 1\n", "1: window: '4097' is not a whole number in -4096..4096");
    assert_error("window 0 0 4 4 top\n", "1: 'top' is unknown here: window X Y W H [bottom]");
}

TEST(matrices)
{
    static const struct {
        const char *text;
        enum scene_op_kind kind;
    } allowed[] = {
        {"rotateabout 1 0 0 2 3 4 5\n", SCENE_ROTATE_ABOUT},
        {"rotatetriangle 1 0 0 0 0 0 0 0 0 0\n", SCENE_ROTATE_TRIANGLE},
        {"quaternion 0 0 0 -3\n", SCENE_QUATERNION},
        {"orbit 1 2 3 0 720 -90\n", SCENE_ORBIT},
        {"lookatd3d 1 2 3 1 2 4 0 1 0\n", SCENE_LOOKAT_D3D},
        {"perspectived3d 60 1 1 2\n", SCENE_PERSPECTIVE_D3D},
        {"frustumd3d -1 1 -1 1 1 2\n", SCENE_FRUSTUM_D3D},
        {"orthod3d -1 1 -1 1 -1 1\n", SCENE_ORTHO_D3D},
        {"orthonormalize\n", SCENE_ORTHONORMALIZE},
    };
    for (size_t i = 0; i < ARRAY_LENGTH(allowed); i++) {
        struct scene scene = parse(allowed[i].text);
        assert_int_equal(scene.op_count, 1);
        assert_int_equal(scene.ops[0].kind, allowed[i].kind);
        scene_free(&scene);
    }
    assert_error("rotateabout 1 0 0 0 3 4 5\n", "1: rotateabout: the axis must not be zero");
    assert_error("quaternion 0 0 0 .000001\n", "1: quaternion: the quaternion must not be zero");
    assert_error("lookatd3d 1 2 3 1 2 3 0 1 0\n",
                 "1: lookatd3d: the eye and the center must differ");
    assert_error("perspectived3d 60 1 0 2\n",
                 "1: perspectived3d: near and far must be greater than 0");
    assert_error("frustumd3d 1 1 -1 1 1 2\n", "1: frustumd3d: left and right must differ");
    assert_error("orthod3d -1 1 -1 1 2 2\n", "1: orthod3d: near and far must differ");
}

TEST(shapes)
{
    static const struct {
        const char *text;
        uint32_t vertices, triangles;
    } expected[] = {
        {"shape box 1 2 3\n", 24, 12},
        {"shape sphere 1 24 12 color .5 0 1\n", 25 * 13, 2 * 24 * 11},
        {"shape cylinder 1 2 8\n", 54, 32},
        {"shape cone -1 2 8\n", 36, 16},
        {"shape torus 1 .5 8 6\n", 63, 96},
        {"shape grid 1 1 1 1\n", 4, 2},
        {"shape sphere 1 255 255\n", 65536, 2 * 255 * 254},
    };
    for (size_t i = 0; i < ARRAY_LENGTH(expected); i++) {
        struct scene scene = parse(expected[i].text);
        assert_int_equal(scene.model_count, 1);
        assert_int_equal(scene.ops[0].kind, SCENE_MODEL);
        assert_int_equal(scene.ops[0].id, 1);
        assert_int_equal(scene.ops[0].u.mesh.color[0], i == 1 ? ONE / 2 : ONE);
        assert_int_equal(scene.models[0].vertices, expected[i].vertices);
        assert_int_equal(scene.models[0].triangles, expected[i].triangles);
        assert_int_equal(scene.triangle_count, expected[i].triangles);
        scene_free(&scene);
    }
    assert_error("shape sphere 1 2 2\n", "1: shape: '2' is not a whole number in 3..1024");
    assert_error("shape sphere 1 3 1\n", "1: shape: '1' is not a whole number in 2..1024");
    assert_error("shape torus 1 1 3 2\n", "1: shape: '2' is not a whole number in 3..1024");
    assert_error("shape grid 1 1 1025 1\n", "1: shape: '1025' is not a whole number in 1..1024");
    assert_error("shape sphere 1 256 256\n", "1: shape: more than 65536 vertices");
    assert_error("shape box 1 2 3 color 1 1 2\n", "1: shape: '2' does not lie in 0..1");
    assert_error("frustumcull cone\n", "1: 'cone' is unknown here: frustumcull off|box|ball");
    static const char usage[] =
        " box HX HY HZ [color r g b], shape sphere R SLICES ROWS [color r g b], shape cylinder R H "
        "SLICES [color r g b], shape cone R H SLICES [color r g b], shape torus R TUBE SLICES "
        "RINGS "
        "[color r g b] or shape grid HX HZ COLUMNS ROWS [color r g b]";
    char message[400];
    (void)snprintf(message, sizeof message, "1: wrong number of values (6) for shape%s", usage);
    assert_error("shape box 1 2 3 4 5\n", message);
    (void)snprintf(message, sizeof message, "1: 'knot' is unknown here: shape%s", usage);
    assert_error("shape knot 1 2 3\n", message);
}

TEST_WITH(mixed_meshes, NULL, io_remove_files)
{
    (void)io_write_text("a.obj", ONE_FACE);
    (void)io_write_text("b.obj", OTHER_FACE);
    (void)io_write_text("two.obj", TWO_FACES);
    struct scene scene = parse("morph .25 a.obj b.obj color 0 0 1\nframes -1.5 a.obj b.obj a.obj\n"
                               "targets a.obj .5 b.obj -2 a.obj\n");
    assert_int_equal(scene.mesh_count, 2);
    assert_int_equal(scene.model_count, 3);
    assert_int_equal(scene.triangle_count, 3);
    assert_int_equal(scene.models[0].kind, SCENE_MORPH);
    assert_int_equal(scene.models[0].at, ONE / 4);
    assert_int_equal(scene.ops[0].u.mesh.color[0], 0);
    assert_int_equal(scene.models[1].kind, SCENE_FRAMES);
    assert_int_equal(scene.models[1].mesh_count, 3);
    assert_int_equal(scene.models[1].at, -3 * ONE / 2);
    assert_int_equal(scene.models[2].kind, SCENE_TARGETS);
    assert_int_equal(scene.models[2].weight[1], ONE / 2);
    assert_int_equal(scene.models[2].weight[2], -2 * ONE);
    assert_int_equal(scene.ops[2].id, 3);
    scene_free(&scene);
    assert_error("morph .5 a.obj two.obj\n",
                 "1: morph: 'two.obj' has other triangles than the first mesh");
    assert_error("morph 1.5 a.obj b.obj\n", "1: morph: '1.5' does not lie in 0..1");
    assert_error("frames 1 a.obj\n",
                 "1: wrong number of values (2) for frames AT FILE.obj x2 to x16 [color r g b]");
    assert_error("targets a.obj 1 b.obj 2\n", "1: wrong number of values (4) for targets BASE.obj "
                                              "(WEIGHT FILE.obj) x1 to x15 [color r g b]");
    assert_error("targets a.obj b.obj 1\n", "1: targets: 'b.obj' is not a number");
}

TEST_WITH(alpha, NULL, io_remove_files)
{
#define CHECKER "texture 4 2 2 255 0 0 0 0 255\n"
    (void)io_write("t.ppm", "P6 2 1 255\nabcdef", 17);
    (void)io_write("a.ppm", "P6 2 1 255\n\xff\xff\xff\0\0\0", 17);
    (void)io_write("wide.ppm", "P6 3 1 255\nabcdefghi", 20);
    struct scene scene = parse(CHECKER "texformat argb4444\ntexalpha 7 200\nalphatest 8\n");
    static const uint8_t expected[8] = {7, 7, 200, 200, 200, 200, 7, 7};
    assert_memory_equal(scene.texture.alpha, expected, 8);
    assert_int_equal(scene.least_alpha, 8);
    scene_free(&scene);
    scene =
        parse("texture t.ppm\ntexformat argb8888\ntexalpha a.ppm\nalphatest 9\nalphatest off\n");
    assert_memory_equal(scene.texture.alpha, "\xff\0", 2);
    assert_int_equal(scene.least_alpha, 0);
    scene_free(&scene);
    scene = parse("texture t.ppm\ntexformat argb1555\n");
    assert_memory_equal(scene.texture.alpha, "\xff\xff", 2);
    scene_free(&scene);
    scene = parse(CHECKER);
    assert_null(scene.texture.alpha);
    scene_free(&scene);

    assert_error(CHECKER "texalpha 1 2\n",
                 "2: texalpha: needs a texture, and a texformat that has alpha");
    assert_error("texformat argb4444\ntexalpha 1 2\n",
                 "2: texalpha: needs a texture, and a texformat that has alpha");
    assert_error(CHECKER "alphatest 1\n",
                 "2: alphatest: needs a texture, and a texformat that has alpha");
    assert_error(CHECKER "texformat alpha8\ntexkey 1 2 3\n",
                 "3: texkey: the texformat has alpha: what is not drawn has an alpha of 0");
    assert_error("texture t.ppm\ntexformat alpha8\ntexalpha 1 2\n",
                 "3: texalpha: the texture is no checkerboard: give a file");
    assert_error(CHECKER "texformat alpha8\ntexalpha 1 256\n",
                 "3: texalpha: '256' is not a whole number in 0..255");
    assert_error("alphatest -1\n", "1: alphatest: '-1' is not a whole number in 0..255");
    char message[2 * PATH_SIZE];
    (void)snprintf(message, sizeof message, "1: texalpha: %s does not exist", io_path("no.ppm"));
    assert_error("texalpha no.ppm\n", message);
    (void)snprintf(message, sizeof message, "3: texalpha: %s is 3 x 1, the texture 2 x 1",
                   io_path("wide.ppm"));
    assert_error("texture t.ppm\ntexformat alpha8\ntexalpha wide.ppm\n", message);
}

TEST(hidden_lines)
{
    struct scene scene = parse("polygon hidden\n");
    assert_true(scene.wireframe && scene.hidden_lines);
    assert_int_equal(scene.hidden_bias, 131);
    scene_free(&scene);
    scene = parse("polygon hidden .5\n");
    assert_int_equal(scene.hidden_bias, ONE / 2);
    scene_free(&scene);
    scene = parse("polygon hidden\npolygon line\n");
    assert_true(scene.wireframe && !scene.hidden_lines);
    scene_free(&scene);
    assert_error("polygon hidden 2\n", "1: polygon: '2' does not lie in 0..1");
    assert_error("polygon fill 1\n",
                 "1: wrong number of values (2) for polygon fill|line|smooth|wide|hidden [BIAS]");
}

int main(void)
{
    return run_all_tests(io_setup, io_teardown);
}
