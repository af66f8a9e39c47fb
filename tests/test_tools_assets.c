/* SPDX-License-Identifier: MIT */
/*
 * `qtri mesh` and `qtri texture` as a user meets them: what they write compiles, bad input is one
 * line on standard error and leaves nothing behind.
 */
#define _POSIX_C_SOURCE 200809L

#include "support/command.h"

TEST(usage_errors)
{
    static const char *const wrong[] = {
        "mesh",
        "mesh cube",
        "mesh dodo -o x.h",
        "mesh cube -o x.txt",
        "mesh cube -o",
        "mesh cube -o x.h --fit 0",
        "mesh cube -o x.h --fit",
        "mesh cube -o x.h --scale 0",
        "mesh cube -o x.h --scale -1",
        "mesh cube -o x.h --scale 2 --fit 2",
        "mesh cube -o x.h --up x",
        "mesh cube -o x.h --normals",
        "mesh cube -o x.h --normals smooth",
        "mesh cube -o x.h --normals rough",
        "mesh cube -o x.h --normals smooth 181",
        "mesh cube -o x.h --simplify 0",
        "mesh cube -o x.h --name 1x",
        "mesh cube -o x.h --panel 3",
        "mesh cube -o x.h --panel 3x0",
        "mesh cube -o x.h --rows 0",
        "mesh cube torus -o x.h",
        "mesh cube -o - --split",
        "mesh cube -o x.h --frobnicate",
        "texture",
        "texture a.ppm",
        "texture a.ppm -o x.txt",
        "texture a.ppm -o x.h --format cmyk",
        "texture a.ppm -o x.h --size 3x4",
        "texture a.ppm -o x.h --size 2048x2",
        "texture a.ppm -o x.h --size 4",
        "texture a.ppm -o x.h --key 12345",
        "texture a.ppm -o x.h --key 12345g",
        "texture a.ppm -o x.h --name a-b",
        "texture a.ppm b.ppm -o x.h",
        "texture a.ppm -o x.h --frobnicate",
    };
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        if (run(wrong[i]) != 2) {
            fail_msg("%s: not a usage error", wrong[i]);
        }
        assert_false(exists("x.h"));
        assert_true(contains("messages", "--help`"));
    }
    assert_int_equal(run("mesh --help"), 0);
    assert_true(contains("output", "gear"));
    assert_int_equal(run("texture --help"), 0);
    assert_true(contains("output", "--dither"));
}

TEST(generated_meshes)
{
    static const char *const names[] = {"cube",  "sphere", "cylinder", "cone",
                                        "torus", "knot",   "grid",     "gear"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        char line[256], header[64];
        snprintf(line, sizeof line, "mesh %s -o %s.h%s", names[i], names[i],
                 i % 2 ? " --compact" : "");
        snprintf(header, sizeof header, "%s.h", names[i]);
        assert_int_equal(run(line), 0);
        assert_true(contains("output", "flash: "));
        assert_compiles(header, names[i]);
        snprintf(line, sizeof line, "mesh %s -o %s.obj", names[i], names[i]);
        assert_int_equal(run(line), 0);
        snprintf(line, sizeof line, "mesh %s.obj -o again.h --name again", names[i]);
        assert_int_equal(run(line), 0);
    }
    assert_int_equal(run("mesh gear -o gear.h"), 0);
    assert_true(contains("output", "gear: 500 vertices, 996 triangles\n"));
}

static const char tetra[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

TEST(materials)
{
    char text[512];
    snprintf(text, sizeof text, "mtllib m x.mtl\n%susemtl a\nf 1 3 2\nf 1 2 4\nusemtl b\nf 1 4 3\n",
             tetra);
    write_text("m.obj", text);
    write_text("m x.mtl", "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 0 1\nmap_Kd m.obj\n");
    assert_int_equal(run("mesh m.obj -o two.h"), 0);
    assert_true(contains("output", "2 meshes"));
    assert_true(contains("output", "texture: m.obj"));
    assert_compiles("two.h", "two[TWO_MESHES - 1]");
    assert_compiles("two.h", "two_materials[1]");
    assert_int_equal(run("mesh m.obj -o one.h --colors"), 0);
    assert_compiles("one.h", "one");
    assert_true(contains("one.h", "one_colors, /* colors */"));
    assert_int_equal(run("mesh m.obj -o - --plain --name plain"), 0);
    assert_true(contains("output", "const qtri_mesh plain = {"));
    assert_true(contains("messages", "plain: "));
    write_text("m x.mtl", "newmtl a\nmap_Kd gone.png\n");
    assert_int_equal(run("mesh m.obj -o one.h"), 0);
    assert_true(
        contains("messages", "m.obj: left out: the picture gone.png, which is not there\n"));
    shell("rm 'm x.mtl'");
    assert_refused("mesh m.obj -o bad.h", "qtri mesh: m.obj:1: there is no file m x.mtl");
    assert_int_equal(run("mesh m.obj -o one.h --plain"), 0);
    assert_false(contains("output", "material"));
}

TEST(an_only_material_is_named)
{
    char text[512];
    snprintf(text, sizeof text, "mtllib x.mtl\n%susemtl a\nf 1 3 2\n", tetra);
    write_text("m.obj", text);
    write_text("x.mtl", "newmtl a\nKd 1 0 .2\n");
    assert_int_equal(run("mesh m.obj -o one.h"), 0);
    assert_true(contains("output", "material 0, a: 1 triangles, colour 255 0 51"));
}

/* Two strips by turns, as no vertex cache wants them. */
TEST(triangles_keep_their_order)
{
    write_text("two.obj",
               "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv -1 0 0\nv 4 0 0\n"
               "f 1 2 3\nf 4 5 6\nf 1 3 7\nf 4 6 8\n");
    assert_int_equal(run("mesh two.obj -o two.h --normals none --compact --keep-order"), 0);
    shell("tr -s ' \\n' ' ' <two.h >output");
    assert_true(contains("output", "{0, 1, 2}, {3, 4, 5}, {0, 2, 6}, {3, 5, 7}"));
}

TEST(split_files_link)
{
    char line[2048];
    assert_int_equal(run("mesh torus -o torus.h --split --compact"), 0);
    assert_true(exists("torus.c"));
    assert_compiles("torus.h", "torus");
    write_text("main.c", "#include \"torus.h\"\nint main(void)\n{\n"
                         "    return torus.triangle_count == 2304 ? 0 : 1;\n}\n");
    const char *const compilers[] = {"gcc -std=c99", "g++ -std=c++11 -x c++"};
    for (size_t i = 0; i < 2; i++) {
        snprintf(line, sizeof line,
                 "! command -v %.3s >/dev/null || { %s -Wall -Wextra -Werror "
                 "-I'%s/core/include' main.c torus.c -c && "
                 "%.3s main.o torus.o -o main -Wl,--unresolved-symbols=ignore-all && ./main; }",
                 compilers[i], compilers[i], root, compilers[i]);
        assert_int_equal(shell(line), 0);
    }
    assert_int_equal(shell("mkdir -p locked.c"), 0); /* NAME.c cannot be written: nor is NAME.h */
    assert_int_equal(run("mesh torus -o locked.h --split"), 1);
    assert_false(exists("locked.h"));
    assert_false(has_parts());
}

TEST(standard_input_and_output)
{
    char line[1024];
    const char *command = getenv("QTRI_COMMAND");
    assert_int_equal(run("mesh cube -o cube.obj"), 0);
    assert_int_equal(run("mesh cube.obj -o cube.h"), 0);
    snprintf(line, sizeof line, "'%s' mesh - -o - --name cube <cube.obj 2>/dev/null | cmp - cube.h",
             command);
    assert_int_equal(shell(line), 0);
    write_bytes("p.ppm", "P6 2 1 255\n\1\2\3\4\5\6", 17);
    assert_int_equal(run("texture p.ppm -o p.h"), 0);
    snprintf(line, sizeof line, "'%s' texture - -o - --name p <p.ppm 2>/dev/null | cmp - p.h",
             command);
    assert_int_equal(shell(line), 0);
}

TEST(bad_models)
{
    write_text("nan.obj", "v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n");
    assert_refused("mesh nan.obj -o bad.h", "qtri mesh: nan.obj:2: 'nan' is not a number");
    write_text("cut.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2");
    assert_refused("mesh cut.obj -o bad.h", "qtri mesh: cut.obj:4: a face needs 3 corners");
    write_text("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    assert_refused("mesh line.obj -o bad.h --split",
                   "qtri mesh: line.obj: has no triangle with an area");
    write_text("far.obj", "v 0 0 0\nv 1e6 0 0\nv 0 1e6 0\nf 1 2 3\n");
    assert_refused("mesh far.obj -o bad.h", "qtri mesh: far.obj: reaches beyond 32767");
    assert_int_equal(run("mesh far.obj -o far.h --fit 2"), 0);
    assert_int_equal(run("mesh far.obj -o scaled.h --scale 2e-6"), 0);
    assert_int_equal(shell("sed 's/scaled/far/g; s/SCALED/FAR/g' scaled.h | cmp - far.h"), 0);
    assert_refused("mesh none.obj -o bad.h", "qtri mesh: none.obj: cannot be opened");
    assert_refused("mesh none.stl -o bad.h", "qtri mesh: none.stl: cannot be opened");
    write_text("wrong.glb", "solid, but no GLB");
    assert_refused("mesh wrong.glb -o bad.h", "qtri mesh: wrong.glb: does not begin as");
    write_text("wrong.stl", "nothing of the kind");
    assert_refused("mesh wrong.stl -o bad.h", "qtri mesh: wrong.stl: is neither text");
    assert_refused("mesh cube -o no/such/folder/bad.h", "qtri mesh: no/such/folder/bad.h");
}

/* A face of ten million. */
TEST(far_too_many_faces)
{
    assert_int_equal(shell("{ printf 'v 0 0 0\\nv 1 0 0\\nv 0 1 0\\n'; "
                           "yes 'f 1 2 3' | head -n 10000000; } >many.obj"),
                     0);
    assert_refused("mesh many.obj -o bad.h", "qtri mesh: many.obj:2097156: more than 2097152");
    shell("rm many.obj");
    write_text("many.ply", "ply\nformat ascii 1.0\nelement face 10000000\nend_header\n");
    assert_refused("mesh many.ply -o bad.h", "qtri mesh: many.ply:3: more than 2097152");
}

/* ---- Formats of the library ---- */

static void put_32(char *at, uint32_t value)
{
    for (int i = 0; i < 4; i++) {
        at[i] = (char)(value >> (8 * i));
    }
}

/* A tetrahedron as GLB, its nodes, materials and picture as given. Returns the bytes. */
static size_t make_glb_of(char out[4096], const char *nodes, const char *material,
                          uint32_t first_bits, const char *picture)
{
    static const uint16_t corners[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    char json[2048], data[72] = {0};
    const uint32_t one = 0x3F800000u;
    put_32(data, first_bits);
    put_32(data + 12, one);
    put_32(data + 28, one);
    put_32(data + 44, one);
    for (int i = 0; i < 12; i++) {
        data[48 + 2 * i] = (char)corners[i];
    }
    int length = snprintf(
        json, sizeof json,
        "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
        "\"nodes\":[%s],\"materials\":[{\"name\":\"red\",\"pbrMetallicRoughness\":{%s}}],"
        "\"images\":[{\"uri\":\"%s\"}],\"textures\":[{\"source\":0}],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1,"
        "\"material\":0}]}],\"buffers\":[{\"byteLength\":72}],"
        "\"bufferViews\":[{\"buffer\":0,\"byteOffset\":0,\"byteLength\":48},"
        "{\"buffer\":0,\"byteOffset\":48,\"byteLength\":24}],"
        "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\","
        "\"min\":[0,0,0],\"max\":[1,1,1]},"
        "{\"bufferView\":1,\"componentType\":5123,\"count\":12,\"type\":\"SCALAR\"}]}",
        nodes, material, picture);
    while (length % 4 != 0) {
        json[length++] = ' ';
    }
    put_32(out, 0x46546C67u); /* glTF */
    put_32(out + 4, 2);
    put_32(out + 8, (uint32_t)length + 28 + 72);
    put_32(out + 12, (uint32_t)length);
    put_32(out + 16, 0x4E4F534Au); /* JSON */
    memcpy(out + 20, json, (size_t)length);
    put_32(out + 20 + length, 72);
    put_32(out + 24 + length, 0x004E4942u); /* BIN */
    memcpy(out + 28 + length, data, 72);
    return (size_t)length + 28 + 72;
}

static size_t make_glb(char out[4096], const char *nodes, const char *material, uint32_t first_bits)
{
    return make_glb_of(out, nodes, material, first_bits, "gone.png");
}

#define RED "\"baseColorFactor\":[1,0.25,0,1]"

/* Skips the test where the command was built without the library. */
static void need_library(void)
{
    char glb[4096];
    write_bytes("t.glb", glb, make_glb(glb, "{\"mesh\":0,\"scale\":[2,2,2]}", RED, 0));
    if (run("mesh t.glb -o t.h --colors") != 0) {
        assert_true(contains("messages", "was built without libassimp"));
        skip();
    }
}

TEST(other_formats)
{
    need_library();
    assert_true(contains("output", "t: 12 vertices, 4 triangles\n"));
    assert_true(contains("t.h", "{131072, 0, 0}")); /* the node's scale */
    assert_true(contains("t.h", "{255, 137, 0}"));  /* linear .25 is 137 in sRGB */
    assert_compiles("t.h", "t");
    static const char stl[] = " solid t\nfacet normal 9 9 9\nouter loop\nvertex 0 0 0\n"
                              "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid t\n";
    write_text("t.stl", stl);
    assert_int_equal(run("mesh t.stl -o t.h"), 0);
    assert_true(contains("t.h", "{0, 0, 16384}")); /* the face's normal, not the file's */
    static const char ply[] = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                              "property float y\nproperty float z\nproperty uchar red\n"
                              "property uchar green\nproperty uchar blue\nelement face 1\n"
                              "property list uchar int vertex_indices\nend_header\n"
                              "0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 7 8 9\n3 0 1 2\n";
    write_text("t.ply", ply);
    assert_int_equal(run("mesh t.ply -o t.h --colors"), 0);
    assert_true(contains("t.h", "{7, 8, 9}"));
    write_bytes("cut.stl", stl, sizeof stl - 12);
    assert_refused("mesh cut.stl -o bad.h", "qtri mesh: cut.stl:9: ends without `endsolid`");
    write_bytes("cut.ply", ply, sizeof ply - 10);
    assert_refused("mesh cut.ply -o bad.h", "qtri mesh: cut.ply:15: ends before the last");
    /* What is binary the library looks at itself: three vertices of zeros, and a face cut short. */
    char binary[256] = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
                       "property float y\nproperty float z\nelement face 1\n"
                       "property list uchar uchar vertex_indices\nend_header\n";
    const size_t header = strlen(binary);
    memcpy(binary + header + 36, "\3\0\1\2", 4);
    write_bytes("cut.ply", binary, header + 36 + 3);
    assert_refused("mesh cut.ply -o bad.h", "qtri mesh: cut.ply: ");
}

TEST(bad_gltf)
{
    need_library();
    char glb[4096];
    size_t length = make_glb(glb, "{\"mesh\":0}", RED, 0x7FC00000u);
    write_bytes("nan.glb", glb, length);
    assert_refused("mesh nan.glb -o bad.h", "qtri mesh: nan.glb: vertex 1 is not a number");
    length = make_glb(glb, "{\"mesh\":0,\"children\":[1]},{\"children\":[0]}", RED, 0);
    write_bytes("cyclic.glb", glb, length);
    assert_refused("mesh cyclic.glb -o bad.h", "qtri mesh: cyclic.glb: cannot be read: ");
    length = make_glb(glb, "{\"mesh\":0}", "\"baseColorTexture\":{\"index\":0}", 0);
    write_bytes("gone.glb", glb, length);
    assert_int_equal(run("mesh gone.glb -o plain.h"), 0);
    assert_true(contains("messages", "left out: the picture gone.png, which is not there\n"));
    assert_int_equal(run("mesh gone.glb -o plain.h --plain"), 0);
    length = make_glb(glb, "{\"mesh\":0}", RED, 0);
    for (size_t cut = 1; cut < length; cut += 97) {
        write_bytes("cut.glb", glb, length - cut);
        assert_refused("mesh cut.glb -o bad.h", "qtri mesh: cut.glb: ");
    }
}

/* A red pixel as PNG, and 8 x 8 brown ones as JPEG. */
static const char png_uri[] =
    "data:image/png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP4z8AAAAMBAQDJ/pLvAAAA"
    "AElFTkSuQmCC";
static const char jpeg_uri[] =
    "data:image/jpeg;base64,"
    "/9j/4AAQSkZJRgABAQAAAQABAAD/2wCEABALDA4MChAODQ4SERATGCgaGBYWGDEjJR0oOjM9PDkzODdA"
    "SFxOQERXRTc4UG1RV19iZ2hnPk1xeXBkeFxlZ2MBERISGBUYLxoaL2NCOEJjY2NjY2NjY2NjY2NjY2Nj"
    "Y2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY//AABEIAAgACAMBIgACEQEDEQH/xAGiAAAB"
    "BQEBAQEBAQAAAAAAAAAAAQIDBAUGBwgJCgsQAAIBAwMCBAMFBQQEAAABfQECAwAEEQUSITFBBhNRYQci"
    "cRQygZGhCCNCscEVUtHwJDNicoIJChYXGBkaJSYnKCkqNDU2Nzg5OkNERUZHSElKU1RVVldYWVpjZGVm"
    "Z2hpanN0dXZ3eHl6g4SFhoeIiYqSk5SVlpeYmZqio6Slpqeoqaqys7S1tre4ubrCw8TFxsfIycrS09TV"
    "1tfY2drh4uPk5ebn6Onq8fLz9PX29/j5+gEAAwEBAQEBAQEBAQAAAAAAAAECAwQFBgcICQoLEQACAQIE"
    "BAMEBwUEBAABAncAAQIDEQQFITEGEkFRB2FxEyIygQgUQpGhscEJIzNS8BVictEKFiQ04SXxFxgZGiYn"
    "KCkqNTY3ODk6Q0RFRkdISUpTVFVWV1hZWmNkZWZnaGlqc3R1dnd4eXqCg4SFhoeIiYqSk5SVlpeYmZqi"
    "o6Slpqeoqaqys7S1tre4ubrCw8TFxsfIycrS09TV1tfY2dri4+Tl5ufo6ery8/T19vf4+fr/2gAMAwEA"
    "AhEDEQA/AG0UUV5J7R//2Q==";

/* The picture that a model has inside becomes a texture; broken ones end in one line. */
TEST(pictures_inside)
{
    need_library();
    char glb[4096];
    const char *const textured = "\"baseColorTexture\":{\"index\":0}";
    size_t length = make_glb_of(glb, "{\"mesh\":0}", textured, 0, png_uri);
    write_bytes("in.glb", glb, length);
    assert_int_equal(run("mesh in.glb -o in.h"), 0);
    assert_true(contains("output", "`qtri texture in.glb --picture 0`"));
    assert_refused("texture in.glb --picture 1 -o bad.h",
                   "qtri texture: in.glb: there is no picture 1 inside, of 1 in all");
    assert_refused("texture t.glb -o bad.h", "qtri texture: t.glb: there is no picture 0 inside");
    if (run("texture in.glb -o skin.h") != 0) {
        assert_true(contains("messages", "was built without libstb"));
    } else {
        assert_compiles("skin.h", "skin");
        assert_true(contains("skin.h", "0xF800"));
        assert_int_equal(shell("\"$QTRI_COMMAND\" texture - -o - <in.glb >piped.h"), 0);
        assert_true(contains("piped.h", "qtri_texture texture = {"));
    }
    length = make_glb_of(glb, "{\"mesh\":0}", textured, 0, jpeg_uri);
    write_bytes("in.glb", glb, length);
    if (run("texture in.glb -o brown.h") != 0) {
        assert_true(contains("messages", "was built without libstb"));
    } else {
        assert_true(contains("brown.h", "0xC325"));
        write_bytes("cut.jpg", "\xFF\xD8\xFF\xE0 cut", 8);
        assert_refused("texture cut.jpg -o bad.h",
                       "qtri texture: cut.jpg: cannot be read as JPEG: ");
    }
}

/* Names that C and C++ have taken. */
TEST(names_in_c)
{
    assert_int_equal(run("mesh cube -o union.h"), 0);
    assert_true(contains("union.h", "const qtri_mesh union_ = {"));
    assert_true(contains("union.h", "#define UNION__VERTICES 24\n#define UNION__TRIANGLES 12\n"));
    assert_compiles("union.h", "union_");
    assert_int_equal(run("mesh cube -o x.h --name class"), 2);
}

/* Bytes changed at random: a mesh or one line, and nothing but these. */
TEST(damaged_files)
{
    need_library();
    uint64_t seed = 5;
    char glb[4096], text[4096];
    for (int i = 0; i < 60; i++) {
        size_t length = make_glb(glb, "{\"mesh\":0}", RED, 0);
        for (int j = 0; j < 1 + i % 4; j++) {
            seed = seed * UINT64_C(6364136223846793005) + 1442695040888963407u;
            glb[(seed >> 33) % length] = (char)(seed >> 24);
        }
        write_bytes("damaged.glb", glb, length);
        discard("bad.h");
        int status = run("mesh damaged.glb -o bad.h --plain");
        assert_true(status == 0 || status == 1);
        assert_true(exists("bad.h") == (status == 0));
        assert_false(has_parts());
        size_t said = read_text("messages", text, sizeof text);
        if (status == 1) {
            assert_true(said > 0 && strchr(text, '\n') == text + said - 1);
        }
    }
}

TEST(simplified)
{
    int status = run("mesh knot -o k.h --simplify 500 --normals smooth 180");
    if (status == 2) {
        assert_true(contains("messages", "without libmeshoptimizer"));
        skip();
    }
    assert_int_equal(status, 0);
    assert_true(contains("messages", "simplified from 5760 to "));
    assert_compiles("k.h", "k");
}

/* ---- Pictures ---- */

TEST(previews)
{
    char text[32];
    assert_int_equal(run("mesh gear -o gear.h --preview gear.ppm"), 0);
    read_text("gear.ppm", text, sizeof text);
    assert_memory_equal(text, "P6\n480 360\n255\n", 15);
    if (run("mesh gear -o gear.h --preview gear.png") != 0) {
        assert_true(contains("messages", "was built without libpng"));
        skip();
    }
    read_text("gear.png", text, sizeof text);
    assert_memory_equal(text, "\x89PNG", 4);
}

TEST(textures)
{
    static const char *const formats[] = {"rgb565", "palette", "gray8", "xrgb8888", "palette565"};
    assert_int_equal(run("mesh gear -o gear.h --preview gear.ppm"), 0);
    for (size_t i = 0; i < 5; i++) {
        char line[256];
        snprintf(line, sizeof line,
                 "texture gear.ppm -o wall.h --format %s --size 32x16 --dither%s", formats[i],
                 i % 2 ? " --key 182030" : "");
        assert_int_equal(run(line), 0);
        assert_true(contains("output", "colour error: at most "));
        assert_true(contains("output", "32 x 16"));
        assert_true(contains("output", ", resampled from "));
        assert_compiles("wall.h", "wall");
    }
    assert_int_equal(run("texture gear.ppm -o split.h --split"), 0);
    assert_true(exists("split.c") && contains("split.h", "extern const qtri_texture split;"));
    assert_int_equal(run("texture gear.ppm -o small.ppm --size 8x8"), 0);
    if (run("texture gear.ppm -o small.png --size 8x8") == 0) { /* what is written is read */
        assert_int_equal(run("texture small.png -o a.h --name x"), 0);
        assert_int_equal(run("texture small.ppm -o b.h --name x"), 0);
        assert_false(contains("output", "resampled"));
        assert_int_equal(shell("cmp a.h b.h"), 0);
    }
}

TEST(bad_pictures)
{
    write_text("cut.ppm", "P6 4 4 255\nabc");
    assert_refused("texture cut.ppm -o bad.h",
                   "qtri texture: cut.ppm: the PPM ends before its last pixel");
    write_text("wrong.png", "GIF89a");
    assert_refused("texture wrong.png -o bad.h", "qtri texture: wrong.png: is neither PNG nor");
    write_text("large.pgm", "P5 99999 99999 255\n");
    assert_refused("texture large.pgm -o bad.h", "qtri texture: large.pgm: has a side");
    write_text("much.pgm", "P5 16384 4097 255\n");
    assert_refused("texture much.pgm -o bad.h",
                   "qtri texture: much.pgm: has more than 8192 x 8192 pixels");
    assert_refused("texture none.png -o bad.h", "qtri texture: none.png: cannot be opened");
    write_bytes("cut.png", "\x89PNG\r\n\x1a\n\0\0\0\15IHDR\0\0\0\1", 20);
    assert_refused("texture cut.png -o bad.h", "qtri texture: cut.png: ");
    write_text("p.pgm", "P5 1 1 255\nx");
    assert_refused("texture p.pgm -o no/such/bad.h", "qtri texture: no/such/bad.h");
}

/* ---- Fonts ---- */

/* Any scalable font of this computer. */
TEST(scalable_fonts)
{
    write_text("no.ttf", "no font");
    assert_int_equal(run("font no.ttf -o bad.h"), 1);
    assert_true(contains("messages", "no.ttf: is not a font that FreeType knows") ||
                contains("messages", "built without libfreetype"));
    assert_false(exists("bad.h"));
    assert_int_equal(run("font f.bdf -o bad.h --size 12"), 2);
    assert_int_equal(run("font no.ttf -o bad.h --range 65"), 2);
    assert_int_equal(run("font no.ttf -o bad.h --range 90-65"), 2);
    assert_int_equal(run("font no.ttf -o bad.h --size 3"), 2);
    shell("find /usr/share/fonts -name '*Sans.ttf' 2>/dev/null | head -n 1 | "
          "while read -r f; do cp \"$f\" sans.ttf; done");
    if (!exists("sans.ttf") || contains("messages", "built without libfreetype")) {
        skip();
    }
    assert_int_equal(run("font sans.ttf -o sans.h --range 0x41-90"), 0);
    assert_true(contains("sans.h", "{0x0041, 26, 0},")); /* one range of 26 glyphs, from glyph 0 */
    assert_compiles("sans.h", "sans");
    assert_int_equal(run("font sans.ttf -o latin.h --size 32"), 0);
    assert_int_equal(shell("grep -q U+00E9 latin.h"), 0);
    assert_compiles("latin.h", "latin");
    assert_refused("font sans.ttf -o bad.h --size 127 --range 32-20000",
                   "qtri font: sans.ttf: its glyphs take more than 65535 bytes");
    assert_refused("font sans.ttf -o bad.h --range 0xE000-0xE001",
                   "qtri font: sans.ttf: has none of these characters");
}

int main(void)
{
    return command_is_known() ? run_all_tests(make_folder, NULL) : 1;
}
