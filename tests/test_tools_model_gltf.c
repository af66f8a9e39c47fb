/* SPDX-License-Identifier: MIT */
/*
 * `qtri model`: what files hold besides triangles is kept, or named in one line.
 */
#define _POSIX_C_SOURCE 200809L

#include "support/command.h"

#include <math.h>

#include "assets/asset_model.h"

/* ---- A small glTF ---- */

/* Accessors of the file's data: of a triangle, of two keys, of one joint, of one target. */
enum { POSITION, UV, TIMES, WEIGHTS, INVERSE_BIND, JOINTS, JOINT_WEIGHTS, TARGET };

static const float numbers[] = {
    0, 0, 0, 1, 0, 0, 0, 1, 0,                             /* positions */
    0, 0, 1, 0, 0, 1,                                      /* texture coordinates */
    0, 1,                                                  /* times */
    0, 1,                                                  /* weights of the target */
    1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -2, 0, 0, 1,       /* the joint was at x = 2 */
    0, 0, 0,                                               /* joints: 4 bytes each */
    1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0,                    /* and how much */
    0, 0, 0, 0, 0, 0, 0, 0, 4,                             /* what the target moves */
    0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1,  1, 0, 0, 0, 0, /* a curve of translations */
};

static const char accessors[] =
    "\"buffers\":[{\"uri\":\"t.bin\",\"byteLength\":308}],"
    "\"bufferViews\":[{\"buffer\":0,\"byteLength\":308}],\"accessors\":["
    "{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,0],"
    "\"max\":[1,1,0]},"
    "{\"bufferView\":0,\"byteOffset\":36,\"componentType\":5126,\"count\":3,\"type\":\"VEC2\"},"
    "{\"bufferView\":0,\"byteOffset\":60,\"componentType\":5126,\"count\":2,\"type\":\"SCALAR\","
    "\"min\":[0],\"max\":[1]},"
    "{\"bufferView\":0,\"byteOffset\":68,\"componentType\":5126,\"count\":2,\"type\":\"SCALAR\"},"
    "{\"bufferView\":0,\"byteOffset\":76,\"componentType\":5126,\"count\":1,\"type\":\"MAT4\"},"
    "{\"bufferView\":0,\"byteOffset\":140,\"componentType\":5121,\"count\":3,\"type\":\"VEC4\"},"
    "{\"bufferView\":0,\"byteOffset\":152,\"componentType\":5126,\"count\":3,\"type\":\"VEC4\"},"
    "{\"bufferView\":0,\"byteOffset\":200,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\","
    "\"min\":[0,0,0],\"max\":[0,0,4]},"
    "{\"bufferView\":0,\"byteOffset\":236,\"componentType\":5126,\"count\":6,\"type\":\"VEC3\"}]";

/* A mesh of one triangle, with what is given of attributes, and what is given besides. */
static void write_model(const char *name, const char *attributes, const char *more)
{
    char text[6000];
    write_bytes("t.bin", numbers, sizeof numbers);
    write_text("t.ppm", "P6 2 1 255\nabcdef");
    const int length = snprintf(text, sizeof text,
                                "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,%s,\"meshes\":[{"
                                "\"primitives\":[{\"attributes\":{\"POSITION\":0%s}]}],%s}",
                                accessors, attributes, more);
    assert_true(length > 0 && (size_t)length < sizeof text);
    write_text(name, text);
}

#define NODE "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}]"

/* Skips the test where the command was built without libassimp. */
static void need_library(void)
{
    write_model("t.gltf", "}", NODE);
    if (run("model t.gltf -o t.h") != 0) {
        assert_true(contains("messages", "was built without lib"));
        skip();
    }
}

static void assert_left_out(const char *name, const char *list)
{
    char command[256], line[512], text[4096];
    snprintf(command, sizeof command, "model %s -o l.h", name);
    snprintf(line, sizeof line, "%s: left out: %s\n", name, list);
    assert_int_equal(run(command), 0);
    read_text("messages", text, sizeof text);
    assert_string_equal(text, list[0] != '\0' ? line : "");
    assert_compiles("l.h", "l[0]");
}

static void read_model(const char *name, struct model *model)
{
    struct text_error error;
    char path[1024];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    assert_true(model_read(path, MODEL_ALL, model, &error));
}

/* ---- What is named ---- */

TEST(what_gltf_has_besides_is_named)
{
    need_library();
    assert_left_out("t.gltf", "");
    write_model("u.gltf", ",\"TEXCOORD_0\":1,\"TEXCOORD_1\":1},\"material\":0",
                "\"materials\":[{\"emissiveFactor\":[0,1,0],\"extensions\":{"
                "\"KHR_materials_sheen\":{}}}],\"cameras\":[{\"type\":\"perspective\","
                "\"perspective\":{\"yfov\":1,\"znear\":1}}],\"extensionsUsed\":["
                "\"KHR_materials_sheen\",\"KHR_texture_transform\", \"OF\\\"]\",\"OF_last\"],"
                "\"scenes\":[{\"name\":\"}]\",\"nodes\":[0,1]},{\"nodes\":[0]},{\"extras\":{}}],"
                "\"nodes\":[{\"mesh\":0},{\"camera\":0}]");
    assert_left_out("u.gltf", "1 further set of texture coordinates, 1 emissive colour, 1 camera, "
                              "KHR_materials_sheen, OF\"], OF_last, 2 further scenes");
    write_model("m.gltf", ",\"TEXCOORD_0\":1},\"material\":0",
                "\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}},"
                "\"normalTexture\":{\"index\":0}}],\"textures\":[{\"source\":0,\"sampler\":0}],"
                "\"images\":[{\"uri\":\"t.ppm\"}],\"samplers\":[{\"wrapS\":33648}]," NODE);
    assert_left_out("m.gltf", "1 picture of other things than colour, 1 picture's mirrored repeat");
}

TEST(animations_that_move_nothing_are_named)
{
    need_library();
    write_model("a.gltf", "}",
                "\"animations\":[{\"samplers\":[{\"input\":2,\"output\":0}],\"channels\":[{"
                "\"sampler\":0,\"target\":{\"node\":1,\"path\":\"translation\"}}]}],"
                "\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":[{\"mesh\":0},{\"name\":\"empty\"}]");
    assert_left_out("a.gltf", "1 animation");
}

/* The second triangle has a vertex that is not there. */
TEST(triangles_that_are_passed_over_are_named)
{
    need_library();
    write_text("i.gltf",
               "{\"asset\":{\"version\":\"2.0\"},\"scene\":0," NODE
               ",\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}]}],"
               "\"buffers\":[{\"uri\":\"i.bin\",\"byteLength\":42}],\"bufferViews\":[{"
               "\"buffer\":0,\"byteLength\":36},{\"buffer\":0,\"byteOffset\":36,"
               "\"byteLength\":6}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,"
               "\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,0],\"max\":[1,1,0]},{\"bufferView\":1,"
               "\"componentType\":5121,\"count\":6,\"type\":\"SCALAR\"}]}");
    char bytes[42];
    memcpy(bytes, numbers, 36);
    memcpy(bytes + 36, "\0\1\2\0\1\3", 6);
    write_bytes("i.bin", bytes, sizeof bytes);
    assert_left_out("i.gltf", "1 triangle with an index out of range");
}

TEST(what_obj_has_besides_is_named)
{
    write_text("l.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\nl 1 2\nl 2 3\np 1\n");
    assert_left_out("l.obj", "2 lines, 1 statement of points, 1 triangle without area");
    write_text("l.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv .3 .3 0\nv .3000001 .3 0\n"
                        "v .3 .3000001 0\nf 1 2 3\nf 4 5 6\n");
    assert_left_out("l.obj", "1 triangle too small to be stored");
    write_text("l.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n");
    assert_refused("model l.obj -o bad.h",
                   "qtri model: l.obj: has no faces, only lines, points or curves\n");
    write_text("k.obj", "mtllib one.mtl two.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n"
                        "usemtl a\nf 1/1 2/1 3/1\nusemtl b\nf 3/1 2/1 1/1\n");
    write_text("one.mtl", "newmtl a\nKe 0 0 0\nKd 1 0 0\nTr 0.6\nmap_bump n.png\n"
                          "newmtl other\nmap_Ks s.png\n");
    write_text("two.mtl", "newmtl b\nKe 0 1 0\nTr 1\n"
                          "map_Kd -colorspace sRGB -o 0.1 C:\\pictures\\t.ppm\n");
    write_text("t.ppm", "P6 2 1 255\nabcdef");
    assert_left_out("k.obj", "1 picture of other things than colour, 1 emissive colour");
    assert_true(contains("l.h", "a: 1 triangles, colour 255 0 0, 40 % opaque\n"));
    assert_true(contains("l.h", "b: 1 triangles, texture 0 of 2x1\n"));
    write_text("two.mtl", "newmtl b\nd 0.8\nTr 0.6\n");
    assert_left_out("k.obj", "1 picture of other things than colour");
    assert_true(contains("l.h", "b: 1 triangles, colour 255 255 255, 80 % opaque\n"));
    assert_int_equal(run("model k.obj -o l.h --preview k.ppm"), 0);
    assert_false(contains("messages", "nothing of the mesh is seen"));
    write_text("two.mtl", "newmtl b\nmap_Kd C:\\pictures\\other.ppm\n");
    assert_left_out("k.obj", "1 picture of other things than colour, "
                             "the picture C:/pictures/other.ppm, which is not there");
    write_text("l.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\nf 1 2 3\n");
    assert_left_out("l.obj", "1 face of less than 3 corners");
    write_text("l.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 3e9 0\nvt 1 1\nf 1/1 2/2 3/2\n");
    assert_left_out("l.obj", "1 vertex's texture coordinates beyond 32767");
}

TEST(a_cloud_of_points_is_called_so)
{
    need_library();
    write_model("p.gltf", "},\"mode\":0", NODE);
    assert_refused("model p.gltf -o bad.h", "qtri model: p.gltf: has no triangle with an area, "
                                            "but: 1 mesh of points or lines\n");
}

/* ---- What is kept ---- */

/* Offset (0.25, 0.5) after a quarter turn counter-clockwise of scale (2, 3). */
TEST(pictures_are_placed_as_the_file_says)
{
    static const double expected[3][2] = {{0.25, 0.5}, {0.25, -1.5}, {3.25, 0.5}};
    struct model model;
    need_library();
    write_model("x.gltf", ",\"TEXCOORD_0\":1},\"material\":0",
                "\"extensionsUsed\":[\"KHR_texture_transform\"],\"materials\":[{"
                "\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0,\"extensions\":{"
                "\"KHR_texture_transform\":{\"offset\":[0.25,0.5],\"rotation\":1.57079632679,"
                "\"scale\":[2,3]}}}}}],\"textures\":[{\"source\":0}],"
                "\"images\":[{\"uri\":\"t.ppm\"}]," NODE);
    assert_left_out("x.gltf", "");
    read_model("x.gltf", &model);
    assert_int_equal(model.vertex_count, 3);
    for (int i = 0; i < 3; i++) {
        assert_true(fabs(model.vertices[i].uv[0] - expected[i][0]) < 1e-5);
        assert_true(fabs(model.vertices[i].uv[1] - expected[i][1]) < 1e-5);
    }
    model_free(&model);
}

/* The joint was at x = 2 when it was bound, and rests at x = 2 + 3, turned about z by a half. */
TEST(skins_rest_where_their_joints_are)
{
    static const double expected[3][2] = {{7, 0}, {6, 0}, {7, -1}};
    struct model model;
    need_library();
    write_model("s.gltf", ",\"JOINTS_0\":5,\"WEIGHTS_0\":6},\"targets\":[{\"POSITION\":0}]",
                "\"skins\":[{\"joints\":[2],\"inverseBindMatrices\":4}],"
                "\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":[{\"mesh\":0,\"skin\":0,"
                "\"translation\":[0,9,0]},{\"name\":\"body\",\"translation\":[2,0,0],"
                "\"children\":[2]},{\"name\":\"joint\",\"translation\":[3,0,0],"
                "\"rotation\":[0,0,1,0]}]");
    assert_left_out("s.gltf", "1 skin");
    read_model("s.gltf", &model);
    for (int i = 0; i < 3; i++) {
        assert_true(fabs(model.vertices[i].position[0] - expected[i][0]) < 1e-5);
        assert_true(fabs(model.vertices[i].position[1] - expected[i][1]) < 1e-5);
        const double *shift = model.shifts[model.vertices[i].shift]; /* 0, x, y: turned as well */
        assert_true(fabs(shift[0] - (expected[i][0] - 7)) < 1e-5);
        assert_true(fabs(shift[1] - expected[i][1]) < 1e-5);
    }
    model_free(&model);
}

/* A quarter turn about z, then (5, 6, 7); the library turns the translation, too. */
TEST(nodes_of_gltf_1_stand_where_the_file_says)
{
    struct model model;
    need_library();
    write_text(
        "one.gltf",
        "{\"asset\":{\"version\":\"1.0\"},\"scene\":\"s\",\"scenes\":{\"s\":{\"nodes\":[\"n\"]}},"
        "\"nodes\":{\"n\":{\"meshes\":[\"m\"],\"translation\":[5,6,7],"
        "\"rotation\":[0,0,0.70710678,0.70710678]}},\"meshes\":{\"m\":{\"primitives\":[{"
        "\"attributes\":{\"POSITION\":\"p\"},\"mode\":4}]}},\"accessors\":{\"p\":{"
        "\"bufferView\":\"v\",\"byteOffset\":0,\"componentType\":5126,\"count\":3,"
        "\"type\":\"VEC3\"}},\"bufferViews\":{\"v\":{\"buffer\":\"b\",\"byteOffset\":0,"
        "\"byteLength\":36}},\"buffers\":{\"b\":{\"uri\":\"t.bin\",\"byteLength\":308,"
        "\"type\":\"arraybuffer\"}},\"animations\":{\"a\":{}}}");
    assert_left_out("one.gltf", "1 animation of glTF 1");
    read_model("one.gltf", &model);
    assert_int_equal(model.vertex_count, 3);
    for (size_t i = 0; i < 3; i++) {
        static const double expected[3][3] = {{5, 6, 7}, {5, 7, 7}, {4, 6, 7}};
        for (int axis = 0; axis < 3; axis++) {
            assert_true(fabs(model.vertices[i].position[axis] - expected[i][axis]) < 1e-5);
        }
    }
    model_free(&model);
}

/* ---- Morph targets ---- */

/* Where a vertex is, of a part that target and key frames shape. */
static void shaped(const struct asset *asset, q16 time, qtri_position16 *positions, double z[3])
{
    q16 weights[MODEL_TRACK_WEIGHTS];
    const struct asset_part *part = &asset->parts[0];
    asset_weights(asset, time, weights);
    asset_shape(part, weights, positions);
    for (uint32_t i = 0; i < part->mesh.vertex_count; i++) {
        z[i] = (part->mesh.origin.z + (double)part->mesh.extent * positions[i].z / 32768.0) / 65536;
    }
}

static bool planes_are_made;

static bool make_planes(qtri_mesh *mesh, qtri_face8 *planes)
{
    (void)mesh;
    (void)planes;
    planes_are_made = true;
    return false;
}

/* Vertex 2 goes 4 along z, times a weight from 0 to 1 in a second, of a node twice as large that
   goes along x. */
TEST(targets_are_mixed_by_their_weights)
{
    struct model model;
    struct asset asset;
    struct text_error error;
    const struct asset_options wanted = {
        .merged = true, .compact = true, .normals = true, .make_faces = make_planes};
    need_library();
    write_model("w.gltf", "},\"targets\":[{\"POSITION\":7}]",
                "\"animations\":[{\"samplers\":[{\"input\":2,\"output\":3},"
                "{\"input\":2,\"output\":0}],\"channels\":[{\"sampler\":0,\"target\":{\"node\":0,"
                "\"path\":\"weights\"}},{\"sampler\":1,\"target\":{\"node\":0,"
                "\"path\":\"translation\"}}]}],\"scenes\":[{\"nodes\":[0]}],\"nodes\":["
                "{\"mesh\":0,\"scale\":[2,2,2]}]");
    assert_left_out("w.gltf", "");
    assert_program_compiles("l.h");
    assert_true(contains("l.h", "const qtri_position16 l_target_0[]"));
    read_model("w.gltf", &model);
    assert_true(model_merge_materials(&model));
    assert_true(asset_make("w", &model, &wanted, &asset, &error));
    assert_true(asset_add_motion(&asset, "w", &model, &error));
    assert_int_equal(asset.seconds, Q16(1));
    assert_int_equal(asset.parts[0].mesh.vertex_count, 3);
    for (int step = 0; step <= 4; step++) {
        qtri_position16 positions[3];
        double z[3];
        shaped(&asset, Q16(0.25) * step, positions, z);
        double most = fmax(z[0], fmax(z[1], z[2]));
        assert_true(fabs(most - 2.0 * step) < 1e-3);
        assert_true(fabs(z[0] + z[1] + z[2] - most) < 1e-3);
    }
    /* A sphere about the middle of what is at rest, as far as the last key reaches. */
    assert_int_equal(asset.node_count, 2);
    assert_true(fabs(asset.radius / 65536.0 - sqrt(1 + 64)) < 1e-3);
    assert_false(planes_are_made);
    const qtri_box *box = &asset.parts[0].mesh.bounds;
    assert_true(box->center.z + box->half.z >= Q16(8) - 40);
    asset_free(&asset);
    model_free(&model);
}

TEST(targets_are_left_out_where_there_is_no_place)
{
    need_library();
    write_model("w.gltf", ",\"NORMAL\":7},\"targets\":[{\"POSITION\":7,\"NORMAL\":7}]", NODE);
    assert_left_out("w.gltf", "1 morph target's normals");
    assert_program_compiles("l.h");
    assert_int_equal(run("model w.gltf -o w.h --wide"), 0);
    assert_true(contains("messages", "left out: morph targets, which --wide meshes cannot have\n"));
    assert_false(contains("w.h", "target"));
    assert_program_compiles("w.h");
    assert_int_equal(run("mesh w.gltf -o w.h"), 0);
    assert_true(contains("messages", "w.gltf: left out: 1 morph target\n"));
    assert_int_equal(run("model w.gltf -o s.h --split --name w --up z --preview s.ppm"), 0);
    assert_compiles("s.h", "w_targets[0]");
    assert_file_compiles("s.c", false);
}

int main(void)
{
    return command_is_known() ? run_all_tests(make_folder, NULL) : 1;
}
