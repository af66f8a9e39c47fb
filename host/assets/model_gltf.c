/* SPDX-License-Identifier: MIT */
/*
 * What the library would not say about a glTF file, or not in words that help: that its end is
 * missing, or that it needs what nobody here reads.
 */
#include <stdio.h>
#include <string.h>

#include "json.h"
#include "model.h"

enum { HEADER = 12, CHUNK = 8 };

/* Extensions without which a file cannot be read, where it says so. */
static const struct {
    const char *name, *problem;
} needed[] = {
    {"EXT_meshopt_compression", "its meshes are compressed with meshopt"},
    {"KHR_meshopt_compression", "its meshes are compressed with meshopt"},
    {"KHR_mesh_quantization", "its vertices are quantized"},
    {"KHR_texture_basisu", "its pictures are KTX2"},
    {"EXT_texture_webp", "its pictures are WebP"},
};

static uint64_t read_32(const char *bytes)
{
    uint64_t value = 0;
    for (int i = 3; i >= 0; i--) {
        value = value << 8 | (unsigned char)bytes[i];
    }
    return value;
}

static bool check_extensions(const char *path, struct json root, struct text_error *error)
{
    struct json name = json_first(json_member(root, "extensionsRequired"), NULL);
    for (; name.at != NULL; name = json_next(name, NULL)) {
        for (size_t i = 0; i < sizeof needed / sizeof needed[0]; i++) {
            if (json_is(name, needed[i].name)) {
                return text_error_set(error, path, 0,
                                      "%s (%s), which cannot be read: export it without",
                                      needed[i].problem, needed[i].name);
            }
        }
    }
    return true;
}

/* ---- What is left out ---- */

static bool is_read(const char *name)
{
    static const char *const names[] = {"KHR_draco_mesh_compression", "KHR_texture_transform",
                                        "KHR_lights_punctual"}; /* those are counted */
    size_t i = 0;
    while (i < sizeof names / sizeof names[0] && strcmp(names[i], name) != 0) {
        i++;
    }
    return i < sizeof names / sizeof names[0];
}

/* Extensions by their names, as far as those are plain. */
static void leave_out_extensions(struct json root, struct model *model)
{
    struct json used = json_first(json_member(root, "extensionsUsed"), NULL);
    for (; used.at != NULL; used = json_next(used, NULL)) {
        const char *end = json_skip(used.at, used.end);
        char name[64];
        size_t length = 0;
        for (const char *at = used.at + 1; at + 1 < end && length + 1 < sizeof name; at++) {
            at += *at == '\\' && at + 2 < end ? 1 : 0;
            name[length++] = *at > ' ' && *at <= '~' ? *at : '?';
        }
        name[length] = '\0';
        if (*used.at == '"' && !is_read(name)) {
            model_leave_out_words(model, name);
        }
    }
}

/* `name`: of an object, NULL: of an array. */
static size_t count_values(struct json whole, struct json *name)
{
    size_t count = 0;
    for (struct json at = json_first(whole, name); at.at != NULL; at = json_next(at, name)) {
        count++;
    }
    return count;
}

static bool check_root(const char *path, struct json root, struct model *model,
                       struct text_error *error)
{
    struct json name;
    const size_t scenes = count_values(json_member(root, "scenes"), NULL);
    leave_out_extensions(root, model);
    model_leave_out(model, scenes > 1 ? scenes - 1 : 0, "further scene", "further scenes");
    model_leave_out(model, count_values(json_member(root, "animations"), &name),
                    "animation of glTF 1", "animations of glTF 1");
    return check_extensions(path, root, error);
}

/* ---- Triangles ---- */

/* An element of a long array that is asked for in order, mostly. */
struct walk {
    struct json array, at;
    size_t index;
};

static struct json walk_to(struct walk *walk, size_t index)
{
    if (walk->at.at == NULL || index < walk->index) {
        walk->at = json_first(walk->array, NULL);
        walk->index = 0;
    }
    for (; walk->at.at != NULL && walk->index < index; walk->index++) {
        walk->at = json_next(walk->at, NULL);
    }
    return walk->at;
}

/* Of a primitive of separate triangles; others are not counted: SIZE_MAX. */
static size_t count_primitive(struct walk *accessors, struct json primitive)
{
    enum { TRIANGLES = 4 };
    const struct json indices = json_member(primitive, "indices");
    const struct json positions = json_member(json_member(primitive, "attributes"), "POSITION");
    const struct json accessor =
        walk_to(accessors, json_index(indices.at != NULL ? indices : positions, SIZE_MAX));
    return json_index(json_member(primitive, "mode"), TRIANGLES) == TRIANGLES && accessor.at != NULL
               ? json_index(json_member(accessor, "count"), 0) / 3
               : SIZE_MAX;
}

size_t model_gltf_triangles(const char *text, size_t length)
{
    const bool is_binary = length >= HEADER + CHUNK && memcmp(text, "glTF", 4) == 0;
    const size_t start = is_binary ? HEADER + CHUNK : 0;
    const struct json root = json_text(text + start, length - start);
    struct walk accessors = {.array = json_member(root, "accessors")};
    struct json mesh = json_first(json_member(root, "meshes"), NULL);
    size_t sum = 0;
    for (; mesh.at != NULL; mesh = json_next(mesh, NULL)) {
        struct json primitive = json_first(json_member(mesh, "primitives"), NULL);
        for (; primitive.at != NULL; primitive = json_next(primitive, NULL)) {
            const size_t count = count_primitive(&accessors, primitive);
            if (count == SIZE_MAX) {
                return 0;
            }
            sum += count;
        }
    }
    return sum;
}

/* ---- The file ---- */

static bool check_json(const char *path, const char *json, size_t length, struct model *model,
                       struct text_error *error)
{
    size_t end = length;
    while (end > 0 && strchr(" \t\r\n", json[end - 1]) != NULL) { /* 0 as well */
        end--;
    }
    if (end == 0 || json[end - 1] != '}') {
        return text_error_set(error, path, 0, "ends before its last brace: the file is incomplete");
    }
    return check_root(path, json_text(json, length), model, error);
}

static bool check_glb(const char *path, const char *bytes, size_t length, struct model *model,
                      struct text_error *error)
{
    if (length < HEADER + CHUNK || read_32(bytes + 8) > length) {
        return text_error_set(error, path, 0, "ends after %zu bytes of the %zu that it should have",
                              length,
                              length < HEADER ? (size_t)HEADER : (size_t)read_32(bytes + 8));
    }
    const uint64_t json = read_32(bytes + HEADER);
    if (json > length - HEADER - CHUNK) {
        return text_error_set(error, path, 0, "its first chunk is longer than the file");
    }
    return check_root(path, json_text(bytes + HEADER + CHUNK, (size_t)json), model, error);
}

bool model_check_gltf(const char *path, const char *text, size_t length, struct model *model,
                      struct text_error *error)
{
    const bool is_binary = length >= 4 && memcmp(text, "glTF", 4) == 0;
    return is_binary ? check_glb(path, text, length, model, error)
                     : check_json(path, text, length, model, error);
}
