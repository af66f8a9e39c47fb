/* SPDX-License-Identifier: MIT */
/*
 * What the library would not say about a glTF file, or not in words that help: that its end is
 * missing, or that it needs what nobody here reads.
 */
#include <stdio.h>
#include <string.h>

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

static bool fail(struct text_error *error, const char *path, const char *problem)
{
    text_error_set(error, path, 0, "%s", problem);
    return false;
}

static uint64_t read_32(const char *bytes)
{
    uint64_t value = 0;
    for (int i = 3; i >= 0; i--) {
        value = value << 8 | (unsigned char)bytes[i];
    }
    return value;
}

/* The first place of a word, or NULL: text need not end in 0. */
static const char *find(const char *text, size_t length, const char *word)
{
    const size_t size = strlen(word);
    for (size_t i = 0; size <= length && i <= length - size; i++) {
        if (memcmp(text + i, word, size) == 0) {
            return text + i;
        }
    }
    return NULL;
}

/* The end of what begins at `from` with a bracket or a brace, or `end`: texts may hold any. */
static const char *skip(const char *from, const char *end)
{
    int depth = 0;
    bool is_text = false;
    for (; from < end; from++) {
        if (is_text) {
            const bool is_escape = *from == '\\' && from + 1 < end;
            is_text = is_escape || *from != '"';
            from += is_escape ? 1 : 0;
        } else if (*from == '"') {
            is_text = true;
        } else if (*from == '[' || *from == '{') {
            depth++;
        } else if ((*from == ']' || *from == '}') && --depth == 0) {
            return from + 1;
        }
    }
    return end;
}

/* The list of a name: from its bracket to `*end`. NULL: there is none. */
static const char *find_list(const char *json, size_t length, const char *name, const char **end)
{
    const char *at = find(json, length, name);
    const char *list = at != NULL ? memchr(at, '[', (size_t)(json + length - at)) : NULL;
    *end = list != NULL ? skip(list, json + length) : NULL;
    return list;
}

static bool check_extensions(const char *path, const char *json, size_t length,
                             struct text_error *error)
{
    const char *end;
    const char *list = find_list(json, length, "\"extensionsRequired\"", &end);
    for (size_t i = 0; list != NULL && i < sizeof needed / sizeof needed[0]; i++) {
        if (find(list, (size_t)(end - list), needed[i].name) != NULL) {
            text_error_set(error, path, 0, "%s (%s), which cannot be read: export it without",
                           needed[i].problem, needed[i].name);
            return false;
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
static void leave_out_extensions(const char *json, size_t length, struct model *model)
{
    const char *end;
    const char *at = find_list(json, length, "\"extensionsUsed\"", &end);
    while (at != NULL && (at = memchr(at, '"', (size_t)(end - at))) != NULL) {
        char name[64];
        size_t used = 0;
        for (at++; at < end && *at != '"'; at++) {
            at += *at == '\\' && at + 1 < end ? 1 : 0;
            const bool is_plain = *at > ' ' && *at <= '~';
            if (used + 1 < sizeof name) {
                name[used++] = (char)(is_plain ? *at : '?');
            }
        }
        name[used] = '\0';
        if (!is_read(name)) {
            model_leave_out_words(model, name);
        }
        at += at < end ? 1 : 0;
    }
}

static size_t count_scenes(const char *json, size_t length)
{
    const char *end;
    const char *list = find_list(json, length, "\"scenes\"", &end);
    size_t count = 0;
    if (list != NULL) {
        const char *scene = list + 1;
        while (scene < end && (scene = memchr(scene, '{', (size_t)(end - scene))) != NULL) {
            scene = skip(scene, end);
            count++;
        }
    }
    return count;
}

static void leave_out(const char *json, size_t length, struct model *model)
{
    const size_t scenes = count_scenes(json, length);
    leave_out_extensions(json, length, model);
    model_leave_out(model, scenes > 1 ? scenes - 1 : 0, "further scene", "further scenes");
    if (find(json, length, "\"CUBICSPLINE\"") != NULL) {
        model_leave_out_words(model, "curves between keys (CUBICSPLINE)");
    }
    if (find(json, length, "\"STEP\"") != NULL) {
        model_leave_out_words(model, "steps between keys (STEP)");
    }
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
        return fail(error, path, "ends before its last brace: the file is incomplete");
    }
    leave_out(json, length, model);
    return check_extensions(path, json, length, error);
}

static bool check_glb(const char *path, const char *bytes, size_t length, struct model *model,
                      struct text_error *error)
{
    if (length < HEADER + CHUNK || read_32(bytes + 8) > length) {
        text_error_set(error, path, 0, "ends after %zu bytes of the %zu that it should have",
                       length, length < HEADER ? (size_t)HEADER : (size_t)read_32(bytes + 8));
        return false;
    }
    const uint64_t json = read_32(bytes + HEADER);
    if (json > length - HEADER - CHUNK) {
        return fail(error, path, "its first chunk is longer than the file");
    }
    leave_out(bytes + HEADER + CHUNK, (size_t)json, model);
    return check_extensions(path, bytes + HEADER + CHUNK, (size_t)json, error);
}

bool model_check_gltf(const char *path, const char *text, size_t length, struct model *model,
                      struct text_error *error)
{
    const bool is_binary = length >= 4 && memcmp(text, "glTF", 4) == 0;
    return is_binary ? check_glb(path, text, length, model, error)
                     : check_json(path, text, length, model, error);
}
