/* SPDX-License-Identifier: MIT */
/*
 * `qtri model`: all of a model in one header, whose comment draws it.
 */
#define _POSIX_C_SOURCE 200809L

#include "support/command.h"

#include <math.h>

#include "assets/asset_model.h"
#include "io/picture.h"

/* ---- A small GLB ---- */

static void put_32(char *at, uint32_t value)
{
    for (int i = 0; i < 4; i++) {
        at[i] = (char)(value >> (8 * i));
    }
}

static void put_float(char *at, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    put_32(at, bits);
}

/* A red and a green pixel as PNG. */
static const char picture[] =
    "data:image/png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAIAAAB7QOjdAAAAD0lEQVR4nGP4z8DA8J8BAA"
    "f/Af8Bf4mnAAAAAElFTkSuQmCC";

enum { POSITIONS = 0, CORNERS = 48, UVS = 72, TIMES = 104, TURNS = 116, DATA = 164 };

/*
 * Four tetrahedra of the same data, materials 0..3 of those given, at x = 0, 3, 6 and 12; the
 * second mirrored, the third twice as large and turning by a quarter about z in a second, and back
 * again, the last below that.
 */
static void write_model(const char *name, const char *materials, const char *more)
{
    static const float positions[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    static const char corners[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    static const float uvs[8] = {.25f, .5f, .25f, .5f, .75f, .5f, .25f, .5f};
    const float half = (float)sqrt(.5);
    const float turns[12] = {0, 0, 0, 1, 0, 0, half, half, 0, 0, 0, 1};
    char data[DATA] = {0}, json[6000], glb[8000];
    for (int i = 0; i < 12; i++) {
        put_float(data + POSITIONS + 4 * i, positions[i]);
        data[CORNERS + 2 * i] = corners[i];
        put_float(data + TURNS + 4 * i, turns[i]);
    }
    for (int i = 0; i < 8; i++) {
        put_float(data + UVS + 4 * i, uvs[i]);
    }
    for (int i = 0; i < 3; i++) {
        put_float(data + TIMES + 4 * i, (float)i);
    }
    int length = snprintf(json, sizeof json,
                          "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
                          "\"scenes\":[{\"nodes\":[0,1,2]}],\"nodes\":[{\"mesh\":0},"
                          "{\"mesh\":1,\"translation\":[3,0,0],\"scale\":[-1,1,1]},"
                          "{\"name\":\"turns\",\"mesh\":2,\"translation\":[6,0,0],"
                          "\"scale\":[2,2,2],\"children\":[3]},"
                          "{\"mesh\":3,\"translation\":[3,0,0]}],"
                          "\"images\":[{\"uri\":\"%s\"}],\"textures\":[{\"source\":0}],"
                          "\"materials\":[%s],%s\"meshes\":[",
                          picture, materials, more);
    for (int i = 0; i < 4; i++) {
        length += snprintf(json + length, sizeof json - (size_t)length,
                           "%s{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":2},"
                           "\"indices\":1,\"material\":%d}]}",
                           i > 0 ? "," : "", i);
    }
    length += snprintf(json + length, sizeof json - (size_t)length,
                       "],\"buffers\":[{\"byteLength\":%d}],\"bufferViews\":["
                       "{\"buffer\":0,\"byteOffset\":0,\"byteLength\":48},"
                       "{\"buffer\":0,\"byteOffset\":48,\"byteLength\":24},"
                       "{\"buffer\":0,\"byteOffset\":72,\"byteLength\":32},"
                       "{\"buffer\":0,\"byteOffset\":104,\"byteLength\":12},"
                       "{\"buffer\":0,\"byteOffset\":116,\"byteLength\":48}],\"accessors\":["
                       "{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\","
                       "\"min\":[0,0,0],\"max\":[1,1,1]},"
                       "{\"bufferView\":1,\"componentType\":5123,\"count\":12,\"type\":\"SCALAR\"},"
                       "{\"bufferView\":2,\"componentType\":5126,\"count\":4,\"type\":\"VEC2\"},"
                       "{\"bufferView\":3,\"componentType\":5126,\"count\":3,\"type\":\"SCALAR\","
                       "\"min\":[0],\"max\":[2]},"
                       "{\"bufferView\":4,\"componentType\":5126,\"count\":3,\"type\":\"VEC4\"}]}",
                       DATA);
    while (length % 4 != 0) {
        json[length++] = ' ';
    }
    assert_true(length + 28 + DATA < (int)sizeof glb);
    put_32(glb, 0x46546C67u); /* glTF */
    put_32(glb + 4, 2);
    put_32(glb + 8, (uint32_t)length + 28 + DATA);
    put_32(glb + 12, (uint32_t)length);
    put_32(glb + 16, 0x4E4F534Au); /* JSON */
    memcpy(glb + 20, json, (size_t)length);
    put_32(glb + 20 + length, DATA);
    put_32(glb + 24 + length, 0x004E4942u); /* BIN */
    memcpy(glb + 28 + length, data, DATA);
    write_bytes(name, glb, (size_t)length + 28 + DATA);
}

#define COLOR(color) "{\"pbrMetallicRoughness\":{\"baseColorFactor\":[" color "]}}"
#define RED          COLOR("1,0,0,1")
#define BLUE         COLOR("0,0,1,1")
#define TEXTURED     "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}}"
#define GLASS                                                                                      \
    "{\"alphaMode\":\"BLEND\",\"doubleSided\":true,\"pbrMetallicRoughness\":{"                     \
    "\"baseColorFactor\":[0,1,0,0.5]}}"
#define TURN                                                                                       \
    "{\"samplers\":[{\"input\":3,\"output\":4}],\"channels\":[{\"sampler\":0,\"target\":{"         \
    "\"node\":2,\"path\":\"rotation\"}}]}"

/* Skips the test where the command was built without libassimp or libstb. */
static void need_libraries(void)
{
    write_model("t.glb", TEXTURED "," RED "," RED "," BLUE, "");
    if (run("model t.glb -o t.h") != 0) {
        assert_true(contains("messages", "was built without lib"));
        skip();
    }
}

/* ---- What becomes of materials ---- */

TEST(materials_of_equal_look_are_one_part)
{
    need_libraries();
    write_model("m.glb", TEXTURED "," RED "," RED "," RED, "");
    assert_int_equal(run("model m.glb -o m.h"), 0);
    assert_true(contains("m.h", "#define M_PARTS 2\n"));
    assert_true(contains("m.h", "{{255, 0, 0}, &qtri_smooth")); /* the material's colour */
    assert_false(contains("m.h", "qtri_rgb m_1_colors"));
    assert_true(contains("m.h", "QTRI_PERSPECTIVE, &m_texture_0, QTRI_MODULATE"));
    assert_true(contains("m.h", "0xF800, 0x07E0,")); /* the picture's pixels */
    assert_compiles("m.h", "m[M_PARTS - 1]");
    assert_program_compiles("m.h");
}

TEST(colours_without_pictures_are_the_vertices)
{
    need_libraries();
    write_model("c.glb", RED "," RED "," BLUE "," BLUE, "");
    assert_int_equal(run("model c.glb -o c.h"), 0);
    assert_true(contains("c.h", "#define C_PARTS 1\n"));
    assert_true(contains("c.h", "qtri_rgb c_colors[]"));
    assert_true(contains("c.h", "{255, 0, 0}, {255, 0, 0}"));
    assert_true(contains("c.h", "{0, 0, 255}, {0, 0, 255}"));
    assert_true(contains("c.h", "    NULL, /* uvs16 */")); /* nobody would read them */
    assert_compiles("c.h", "c[0]");
    assert_program_compiles("c.h");
    assert_int_equal(run("model c.glb -o s.h --split --name c"), 0);
    assert_compiles("s.h", "c[0]");
    assert_file_compiles("s.c", false);
}

TEST(what_is_seen_through_comes_last)
{
    need_libraries();
    write_model("g.glb", GLASS "," RED "," RED "," TEXTURED, "");
    assert_int_equal(run("model g.glb -o g.h"), 0);
    assert_true(contains("g.h", "#define G_PARTS 3\n"));
    assert_true(contains("g.h", " * g[2], unnamed: 4 triangles, colour 0 255 0, 50 % opaque\n"));
    assert_true(
        contains("g.h", "QTRI_CULL_NONE, NULL, QTRI_LESS, true, 0, &qtri_blend_alpha, 128"));
    assert_compiles("g.h", "g[G_PARTS - 1]");
}

TEST(opacity_of_mtl_is_kept)
{
    write_text("o.obj", "mtllib o.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                        "usemtl glass\nf 1 2 3\nusemtl solid\nf 1 3 4\n");
    write_text("o.mtl", "newmtl glass\nKd 0 0 1\nd 0.4\nnewmtl solid\nd 1\n");
    assert_int_equal(run("model o.obj -o o.h"), 0);
    assert_true(contains("o.h", " * o[1], glass: 1 triangles, colour 0 0 255, 40 % opaque\n"));
    write_text("o.mtl", "newmtl glass\nd much\n");
    assert_refused("model o.obj -o bad.h", "qtri model: o.mtl:2: d needs a number\n");
}

TEST(large_textures_are_scaled)
{
    assert_int_equal(shell("{ printf 'P6 600 300 255\\n'; head -c 540000 /dev/zero; } >big.ppm"),
                     0);
    write_text("q.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
    assert_int_equal(run("model q.obj -o q.h --texture big.ppm"), 0);
    assert_true(contains("output", "texture 0: 256 x 128, rgb565"));
    assert_int_equal(run("model q.obj -o q.h --texture big.ppm --texture-side 64 --format palette"),
                     0);
    assert_true(contains("output", "texture 0: 64 x 32, palette"));
    assert_compiles("q.h", "q[0]");
    write_text("n.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    assert_refused("model n.obj -o bad.h --texture big.ppm",
                   "qtri model: n.obj: has no texture coordinates");
    assert_refused("model q.obj -o bad.h --texture none.png", "qtri model: none.png: cannot be");
}

TEST(previews_show_textures_and_colours)
{
    need_libraries();
    write_model("p.glb", TEXTURED "," BLUE "," BLUE "," BLUE, "");
    assert_int_equal(run("model p.glb -o p.h --preview p.ppm"), 0);
    struct picture seen;
    struct text_error error;
    char path[1024];
    int blue = 0, red_green = 0;
    snprintf(path, sizeof path, "%s/p.ppm", folder);
    assert_true(picture_read_ppm(path, &seen, &error));
    for (size_t i = 0; i < (size_t)seen.width * (size_t)seen.height; i++) {
        const uint8_t *c = &seen.rgb[3 * i];
        blue += c[0] == 0 && c[1] == 0 && c[2] > 60 ? 1 : 0;
        red_green += (c[0] > 60 || c[1] > 60) && c[2] == 0 ? 1 : 0;
    }
    picture_free(&seen);
    assert_true(blue > 300 && red_green > 100);
}

/* ---- Motion ---- */

/* Where a vertex of the model is at a time, in the core's own poses. */
static qtri_vec3 core_place(const struct asset *asset, const struct asset_part *part, uint32_t i,
                            q16 time)
{
    qtri_transform identity, *poses = calloc(asset->node_count + 1, sizeof *poses);
    assert_non_null(poses);
    qtri_transform_identity(&identity);
    asset_pose(asset, &identity, time, poses);
    qtri_mat4 matrix;
    qtri_transform_to_mat4(&poses[part->material.node], &matrix);
    const qtri_vec3 place = qtri_mat4_point(&matrix, part->mesh.positions[i]);
    free(poses);
    return place;
}

/* Of closed surfaces whose faces look outwards. */
static double volume_of(const qtri_mesh *mesh)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        double p[3][3];
        for (int j = 0; j < 3; j++) {
            const qtri_vec3 *at = &mesh->positions[mesh->triangles[i][j]];
            p[j][0] = at->x / 65536.0;
            p[j][1] = at->y / 65536.0;
            p[j][2] = at->z / 65536.0;
        }
        for (int j = 0; j < 3; j++) {
            const int k = (j + 1) % 3, l = (j + 2) % 3;
            sum += p[0][j] * (p[1][k] * p[2][l] - p[1][l] * p[2][k]) / 6.0;
        }
    }
    return sum;
}

/* Corners of the tetrahedra at 6 and below it. */
TEST(moving_nodes_are_where_they_should_be)
{
    need_libraries();
    const struct asset_options wanted = {.merged = true};
    struct model model;
    struct asset asset;
    struct text_error error;
    char path[1024];
    write_model("a.glb", RED "," RED "," RED "," BLUE, "\"animations\":[" TURN "],");
    snprintf(path, sizeof path, "%s/a.glb", folder);
    assert_true(model_read(path, MODEL_ALL, &model, &error));
    assert_true(model_merge_materials(&model));
    assert_true(asset_make(path, &model, &wanted, &asset, &error));
    assert_true(asset_add_motion(&asset, path, &model, &error));
    assert_int_equal(asset.node_count, 2);
    assert_int_equal(asset.seconds, Q16(2));
    assert_int_equal(asset.count, 2); /* at rest, and moving: colours are the vertices' */
    const struct asset_part *part = &asset.parts[1];
    assert_int_equal(part->material.node, 1);
    assert_int_equal(part->mesh.vertex_count, 8);
    for (int step = 0; step <= 8; step++) {
        const double time = step / 4.0, angle = (time < 1 ? time : 2 - time) * 1.5707963267948966;
        for (uint32_t i = 0; i < 8; i++) {
            const qtri_vec3 at = core_place(&asset, part, i, Q16(0.25) * step);
            const double x = part->mesh.positions[i].x / 65536.0;
            const double y = part->mesh.positions[i].y / 65536.0;
            assert_true(fabs(at.x / 65536.0 - (6 + x * cos(angle) - y * sin(angle))) < 1e-3);
            assert_true(fabs(at.y / 65536.0 - (x * sin(angle) + y * cos(angle))) < 1e-3);
        }
    }
    /* From 0 to 14, whose middle is 7; turned, the last corner is not much farther. */
    assert_true(asset.center.x == Q16(7) && asset.radius > Q16(7) && asset.radius < Q16(11));
    assert_true(fabs(volume_of(&asset.parts[0].mesh) - 2.0 / 6.0) < 1e-3);
    assert_true(fabs(volume_of(&part->mesh) - 16.0 / 6.0) < 1e-3);
    asset_free(&asset);
    model_free(&model);
}

TEST(keys_are_written_with_the_program_that_moves)
{
    need_libraries();
    write_model("a.glb", RED "," RED "," RED "," BLUE, "\"animations\":[" TURN "," TURN "],");
    assert_int_equal(run("model a.glb -o a.h"), 0);
    assert_true(contains("messages", "a.glb: left out: 1 further animation\n"));
    assert_true(contains("a.h", "const qtri_key a_keys[3] = {"));
    assert_true(contains("a.h", "{65536, {32768, 0, 0}, ") ||
                contains("a.h", "{46341, 0, 0, 46341}"));
    assert_true(contains("a.h", "#define A_NODES 2\n#define A_SECONDS 131072\n"));
    assert_compiles("a.h", "a_keys[0]");
    assert_program_compiles("a.h");
    assert_int_equal(run("mesh a.glb -o b.h"), 0);
    assert_true(contains("messages", "a.glb: left out: 2 animations\n"));
    assert_int_equal(run("model a.glb -o s.h --split --name a"), 0);
    assert_compiles("s.h", "a_parents[0]");
    assert_file_compiles("s.c", false);
}

/* ---- Files that cannot be read as they are ---- */

TEST(incomplete_files_say_so)
{
    write_model("whole.glb", RED "," RED "," RED "," BLUE, "");
    assert_int_equal(shell("head -c 700 whole.glb >cut.glb"), 0);
    assert_refused("model cut.glb -o bad.h", "qtri model: cut.glb: ends after 700 bytes of the ");
    assert_int_equal(shell("head -c 9 whole.glb >cut.glb"), 0);
    assert_refused("model cut.glb -o bad.h", "qtri model: cut.glb: ends after 9 bytes of the 12");
    write_text("cut.gltf", "{\"asset\":{\"version\":\"2.0\"},\"meshes\":[");
    assert_refused("model cut.gltf -o bad.h",
                   "qtri model: cut.gltf: ends before its last brace: the file is incomplete\n");
}

TEST(compression_is_refused_by_name)
{
    write_model("z.glb", RED "," RED "," RED "," BLUE,
                "\"extensionsRequired\":[\"EXT_meshopt_compression\"],");
    assert_refused("model z.glb -o bad.h",
                   "qtri model: z.glb: its meshes are compressed with meshopt "
                   "(EXT_meshopt_compression), which cannot be read: export it without\n");
    write_model("z.glb", RED "," RED "," RED "," BLUE,
                "\"extensionsRequired\":[\"KHR_mesh_quantization\"],");
    assert_refused("model z.glb -o bad.h", "qtri model: z.glb: its vertices are quantized");
    write_text("strips.ply", "ply\nformat ascii 1.0\nelement tristrips 1\n");
    assert_refused("model strips.ply -o bad.h",
                   "qtri model: strips.ply:3: its triangles are strips (tristrips)");
}

TEST(next_to_nothing_is_an_error)
{
    assert_int_equal(shell("{ printf 'v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nf 1 2 3\\n'; "
                           "yes 'f 1 2 2' | head -n 200; } >thin.obj"),
                     0);
    assert_refused("model thin.obj -o bad.h",
                   "qtri model: thin.obj: only 1 of its 201 triangles have an area\n");
    need_libraries();
    assert_int_equal(
        shell("{ printf 'ply\\nformat ascii 1.0\\nelement vertex 1000\\nproperty float x\\n"
              "property float y\\nproperty float z\\nelement face 1\\n"
              "property list uchar int vertex_indices\\nend_header\\n0 0 0\\n1 0 0\\n'; "
              "yes '0 1 0' | head -n 998; echo 3 0 1 2; } >cloud.ply"),
        0);
    assert_refused("model cloud.ply -o bad.h",
                   "qtri model: cloud.ply: has 1000 vertices, and only 1 triangles");
}

/* ---- Sizes and usage ---- */

TEST(budgets_are_held)
{
    assert_int_equal(run("model knot -o k.h --flash 1M --ram 200K"), 0);
    assert_refused("model knot -o bad.h --flash 64K", "qtri model: knot: needs ");
    assert_true(contains("messages", " of flash, "));
    assert_refused("model knot -o bad.h --ram 65536 --split", "qtri model: knot: needs ");
    assert_true(contains("messages", " of RAM, "));
    assert_refused("mesh knot -o bad.h --flash 1K", "qtri mesh: knot: needs ");
    assert_program_compiles("k.h");
}

TEST(usage_errors)
{
    static const char *const wrong[] = {
        "model",
        "model cube",
        "model cube -o x.obj",
        "model cube -o x.h --flash 0",
        "model cube -o x.h --flash 12X",
        "model cube -o x.h --flash 12KB",
        "model cube -o x.h --ram K",
        "model cube -o x.h --texture-side 0",
        "model cube -o x.h --format cmyk",
        "model cube -o x.h --in-place --fit 2",
        "model cube -o x.h --colors",
        "mesh cube -o x.h --mipmaps",
    };
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        if (run(wrong[i]) != 2) {
            fail_msg("%s: not a usage error", wrong[i]);
        }
        assert_false(exists("x.h"));
    }
    assert_int_equal(run("model --help"), 0);
    assert_true(contains("output", "--texture-side"));
}

int main(void)
{
    return command_is_known() ? run_all_tests(make_folder, NULL) : 1;
}
