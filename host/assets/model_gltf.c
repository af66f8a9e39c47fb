/* SPDX-License-Identifier: MIT */
/*
 * What the library would not say about a glTF file, or not in words that help: that its end is
 * missing, or that it needs what nobody here reads.
 */
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

static bool check_extensions(const char *path, const char *json, size_t length,
                             struct text_error *error)
{
    const char *list = find(json, length, "\"extensionsRequired\"");
    const char *end = list != NULL ? memchr(list, ']', (size_t)(json + length - list)) : NULL;
    for (size_t i = 0; end != NULL && i < sizeof needed / sizeof needed[0]; i++) {
        if (find(list, (size_t)(end - list), needed[i].name) != NULL) {
            text_error_set(error, path, 0, "%s (%s), which cannot be read: export it without",
                           needed[i].problem, needed[i].name);
            return false;
        }
    }
    return true;
}

static bool check_json(const char *path, const char *json, size_t length, struct text_error *error)
{
    size_t end = length;
    while (end > 0 && strchr(" \t\r\n", json[end - 1]) != NULL) { /* 0 as well */
        end--;
    }
    if (end == 0 || json[end - 1] != '}') {
        return fail(error, path, "ends before its last brace: the file is incomplete");
    }
    return check_extensions(path, json, length, error);
}

static bool check_glb(const char *path, const char *bytes, size_t length, struct text_error *error)
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
    return check_extensions(path, bytes + HEADER + CHUNK, (size_t)json, error);
}

bool model_check_gltf(const char *path, const char *text, size_t length, struct text_error *error)
{
    const bool is_binary = length >= 4 && memcmp(text, "glTF", 4) == 0;
    return is_binary ? check_glb(path, text, length, error) : check_json(path, text, length, error);
}
