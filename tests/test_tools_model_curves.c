/* SPDX-License-Identifier: MIT */
/*
 * Animations of glTF that step or curve between keys, against glTF's formulas in double precision.
 */
#define _POSIX_C_SOURCE 200809L

#include "support/command.h"

#include <math.h>

#include "assets/asset_model.h"

enum { KEYS = 3, PARTS = 3 }; /* of a curve: in-tangent, value, out-tangent */

/* What the file's buffer holds, all of it float. */
static const struct {
    float positions[9], target[9], times[KEYS];
    float places[KEYS][PARTS][3], turns[KEYS][PARTS][4], scales[KEYS][PARTS][3];
    float weights[KEYS][PARTS][1];
    float stepped[KEYS][3], stepped_weights[KEYS];
} data = {
    {0, 0, 0, 1, 0, 0, 0, 1, 0},
    {0, 0, 0, 0, 0, 0, 0, 0, 4},
    {.25f, .75f, 2},
    {{{0, 0, 0}, {0, 0, 0}, {4, 0, -2}},
     {{1, 2, 3}, {2, 1, 0}, {-3, 5, 1}},
     {{0, -2, 1}, {2, 1, 0}, {0, 0, 0}}}, /* the last two values are one, the way between is not */
    {{{0, 0, 0, 0}, {0, 0, 0, 1}, {1, 0, 0, 0}},
     {{0, 1, 0, .5f}, {0, .6f, 0, .8f}, {.5f, 0, -1, 0}},
     {{0, 0, 2, 0}, {.6f, 0, .8f, 0}, {0, 0, 0, 0}}},
    {{{0, 0, 0}, {1, 2, 3}, {1, 0, -1}},
     {{0, 1, 0}, {2, 2, 1}, {0, 0, 0}},
     {{0, 0, 1}, {1, 1, 4}, {0, 0, 0}}},
    {{{0}, {0}, {2}}, {{0}, {1}, {0}}, {{-1}, {.5f}, {0}}},
    {{1, 2, 3}, {4, 5, 6}, {-1, 0, 1}},
    {1, .25f, .5f},
};

static size_t put_accessor(char *text, size_t size, const void *first, int count, const char *type)
{
    return (size_t)snprintf(text, size,
                            ",{\"bufferView\":0,\"byteOffset\":%d,\"componentType\":5126,"
                            "\"count\":%d,\"type\":\"%s\",\"min\":[0,0,0],\"max\":[9,9,9]}",
                            (int)((const char *)first - (const char *)&data), count, type);
}

static void put_base64(char *text)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const unsigned char *bytes = (const unsigned char *)&data;
    text += sprintf(text, "\"uri\":\"data:application/octet-stream;base64,");
    for (size_t i = 0; i < sizeof data; i += 3) {
        const uint32_t bits = (uint32_t)bytes[i] << 16 |
                              (i + 1 < sizeof data ? (uint32_t)bytes[i + 1] << 8 : 0) |
                              (i + 2 < sizeof data ? bytes[i + 2] : 0);
        for (int j = 0; j < 4; j++) {
            *text++ = digits[bits >> (18 - 6 * j) & 63];
        }
    }
    (void)sprintf(text, "\",");
}

/* A triangle that an animation moves; `uri` says where its buffer is. */
static size_t make_json(char text[16000], const char *uri, const char *name, const char *animation)
{
    size_t n = (size_t)snprintf(
        text, 16000,
        "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
        "\"nodes\":[{\"mesh\":0%s}],\"meshes\":[{\"primitives\":[{\"attributes\":{"
        "\"POSITION\":1},\"targets\":[{\"POSITION\":2}]}]}],"
        "\"animations\":[{%s}],\"buffers\":[{%s\"byteLength\":%zu}],"
        "\"bufferViews\":[{\"buffer\":0,\"byteLength\":%zu}],\"accessors\":[{"
        "\"componentType\":5126,\"count\":1,\"type\":\"SCALAR\"}",
        name, animation, uri, sizeof data, sizeof data);
    n += put_accessor(text + n, 16000 - n, data.positions, 3, "VEC3");
    n += put_accessor(text + n, 16000 - n, data.target, 3, "VEC3");
    n += put_accessor(text + n, 16000 - n, data.times, KEYS, "SCALAR");
    n += put_accessor(text + n, 16000 - n, data.places, KEYS * PARTS, "VEC3");
    n += put_accessor(text + n, 16000 - n, data.turns, KEYS * PARTS, "VEC4");
    n += put_accessor(text + n, 16000 - n, data.scales, KEYS * PARTS, "VEC3");
    n += put_accessor(text + n, 16000 - n, data.weights, KEYS * PARTS, "SCALAR");
    n += put_accessor(text + n, 16000 - n, data.stepped, KEYS, "VEC3");
    n += put_accessor(text + n, 16000 - n, data.stepped_weights, KEYS, "SCALAR");
    return n + (size_t)snprintf(text + n, 16000 - n, "]}");
}

#define SAMPLER(output, kind) "{\"input\":3,\"output\":" output ",\"interpolation\":\"" kind "\"}"
#define CHANNEL(sampler, path)                                                                     \
    "{\"sampler\":" sampler ",\"target\":{\"node\":0,\"path\":\"" path "\"}}"

static const char curves[] =
    "\"samplers\":[" SAMPLER("4", "CUBICSPLINE") "," SAMPLER("5", "CUBICSPLINE") "," SAMPLER("6", "CUBICSPLINE") "," SAMPLER(
        "7",
        "CUBICSPLINE") "],\"channels\":[" CHANNEL("0",
                                                  "translation") "," CHANNEL("1",
                                                                             "rotation") "," CHANNEL("2",
                                                                                                     "scale") "," CHANNEL("3",
                                                                                                                          "weights") "]";
static const char steps[] = "\"samplers\":[" SAMPLER("8", "STEP") "," SAMPLER("9", "STEP") "," SAMPLER(
    "5",
    "CUBICSPLINE") "],\"channels\":[" CHANNEL("0",
                                              "translation") "," CHANNEL("1",
                                                                         "weights") "," CHANNEL("2",
                                                                                                "ro"
                                                                                                "ta"
                                                                                                "ti"
                                                                                                "o"
                                                                                                "n") "]";

static void read_model(const char *name, struct model *model)
{
    struct text_error error;
    char path[1024], command[200];
    snprintf(command, sizeof command, "model %s -o c.h", name);
    if (run(command) != 0) {
        assert_true(contains("messages", "was built without lib"));
        skip();
    }
    assert_false(contains("messages", "left out"));
    assert_program_compiles("c.h");
    snprintf(path, sizeof path, "%s/%s", folder, name);
    if (!model_read(path, MODEL_ALL, model, &error)) {
        fail_msg("%s", error.message);
    }
}

/* glTF 2.0, appendix C.5, of component j of values of `width`. */
static double curve_at(const float *values, int width, int j, double time)
{
    const float *times = data.times;
    const int k = time < (double)times[1] ? 0 : 1;
    const double span = (double)times[k + 1] - (double)times[k];
    const double t = fmin(fmax((time - (double)times[k]) / span, 0.0), 1.0), t2 = t * t,
                 t3 = t2 * t;
    const float *from = values + 3 * width * k, *to = from + 3 * width;
    return (2 * t3 - 3 * t2 + 1) * (double)from[width + j] +
           span * (t3 - 2 * t2 + t) * (double)from[2 * width + j] +
           (-2 * t3 + 3 * t2) * (double)to[width + j] + span * (t3 - t2) * (double)to[j];
}

static void turn_at(double time, double m[3][3])
{
    double q[4], length = 0.0;
    for (int i = 0; i < 4; i++) {
        q[i] = curve_at(data.turns[0][0], 4, i, time);
        length += q[i] * q[i];
    }
    for (int i = 0; i < 4; i++) {
        q[i] /= sqrt(length);
    }
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    const double turn[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                               {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                               {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
    memcpy(m, turn, sizeof turn);
}

/* The greatest distance of a pose from the curves' is 3.3e-4, of a way of 2.5; of weights 1.2e-4.
 */
static void assert_curves(const char *name)
{
    struct model model;
    double worst = 0.0, worst_weight = 0.0;
    read_model(name, &model);
    assert_int_equal(model.node_count, 1);
    for (int i = 0; i <= 2300; i++) {
        const double time = i / 1000.0;
        double world[2][3][4], turn[3][3], weights[MODEL_TRACK_WEIGHTS];
        model_pose(&model, time, world);
        turn_at(time, turn);
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 3; column++) {
                const double scale = curve_at(data.scales[0][0], 3, column, time);
                worst = fmax(worst, fabs(world[1][row][column] - turn[row][column] * scale));
            }
            worst = fmax(worst, fabs(world[1][row][3] - curve_at(data.places[0][0], 3, row, time)));
        }
        model_weights(&model, time, weights);
        worst_weight =
            fmax(worst_weight, fabs(weights[0] - curve_at(data.weights[0][0], 1, 0, time)));
    }
    assert_true(worst <= 3.8e-4);
    assert_true(worst_weight <= 1.2e-4);
    model_free(&model);
}

TEST(cubic_curves_are_followed)
{
    static char text[16000], uri[4000], glb[20000];
    make_json(text, "\"uri\":\"c.bin\",", "", curves);
    write_bytes("c.bin", &data, sizeof data);
    write_text("c.gltf", text);
    assert_curves("c.gltf");
    put_base64(uri);
    make_json(text, uri, ",\"name\":\"a name\"", curves);
    write_text("d.gltf", text);
    assert_curves("d.gltf");
    size_t length = make_json(text, "", "", curves);
    for (; length % 4 != 0; length++) {
        text[length] = ' ';
    }
    const uint32_t head[] = {0x46546C67, 2, (uint32_t)(28 + length + sizeof data), (uint32_t)length,
                             0x4E4F534A};
    const uint32_t chunk[] = {sizeof data, 0x004E4942};
    memcpy(glb, head, 20);
    memcpy(glb + 20, text, length);
    memcpy(glb + 20 + length, chunk, 8);
    memcpy(glb + 28 + length, &data, sizeof data);
    write_bytes("e.glb", glb, 28 + length + sizeof data);
    assert_curves("e.glb");
}

/* Exactly, up to the key and from it on, beside what curves. */
TEST(steps_are_steps)
{
    static char text[16000];
    struct model model;
    write_bytes("s.bin", &data, sizeof data);
    make_json(text, "\"uri\":\"s.bin\",", "", steps);
    write_text("s.gltf", text);
    read_model("s.gltf", &model);
    for (int i = 0; i <= 2304; i++) {
        const double time = i / 1024.0;
        const int key = time >= 2 ? 2 : time >= .75 ? 1 : 0;
        double world[2][3][4], turn[3][3], weights[MODEL_TRACK_WEIGHTS];
        model_pose(&model, time, world);
        model_weights(&model, time, weights);
        turn_at(time, turn);
        for (int row = 0; row < 3; row++) {
            assert_true(world[1][row][3] == (double)data.stepped[key][row]);
            assert_true(fabs(world[1][row][0] - turn[row][0]) < 3e-4);
        }
        assert_true(weights[0] == (double)data.stepped_weights[key]);
    }
    model_free(&model);
}

/* As what belongs to a node whose name has escapes. */
TEST(curves_that_are_not_found_are_named)
{
    static char text[16000];
    write_bytes("b.bin", &data, sizeof data);
    make_json(text, "\"uri\":\"b.bin\",", ",\"name\":\"\\u0061\"", curves);
    write_text("b.gltf", text);
    if (run("model b.gltf -o b.h") != 0) {
        assert_true(contains("messages", "was built without lib"));
        skip();
    }
    assert_true(contains("messages", "left out: 4 curves or steps between keys\n"));
}

int main(void)
{
    return command_is_known() ? run_all_tests(make_folder, NULL) : 1;
}
