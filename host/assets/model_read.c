/* SPDX-License-Identifier: MIT */
#include "model.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../io/file.h"

/* Formats by the end of a file's name. */
static const char *const endings[] = {"obj", "gltf", "glb", "stl", "ply"};

enum { ENDINGS = sizeof endings / sizeof endings[0] };

static char lower(char c)
{
    return (char)(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
}

/* The ending of a name, one of `endings`, or NULL. */
static const char *ending_of(const char *path)
{
    const char *dot = strrchr(path, '.');
    for (int i = 0; dot != NULL && i < ENDINGS; i++) {
        size_t at = 0;
        while (endings[i][at] != '\0' && lower(dot[1 + at]) == endings[i][at]) {
            at++;
        }
        if (endings[i][at] == '\0' && dot[1 + at] == '\0') {
            return endings[i];
        }
    }
    return NULL;
}

bool model_is_file_name(const char *path)
{
    return strcmp(path, "-") == 0 || ending_of(path) != NULL;
}

static bool begins(const char *text, size_t length, const char *magic)
{
    return length >= strlen(magic) && memcmp(text, magic, strlen(magic)) == 0;
}

/* A binary STL says in bytes 80..83 how many triangles of 50 bytes follow. */
static bool is_binary_stl(const char *text, size_t length)
{
    uint64_t count = 0;
    for (int i = 3; length >= 84 && i >= 0; i--) {
        count = count << 8 | (unsigned char)text[80 + i];
    }
    return length >= 84 && (uint64_t)length - 84 >= 50 * count && count > 0 &&
           (uint64_t)length - 84 < 50 * count + 50;
}

static size_t skip_space(const char *text, size_t length, size_t at)
{
    while (at < length &&
           (text[at] == ' ' || text[at] == '\n' || text[at] == '\r' || text[at] == '\t')) {
        at++;
    }
    return at;
}

static bool is_text_stl(const char *text, size_t length)
{
    const size_t at = skip_space(text, length, 0);
    return begins(text + at, length - at, "solid");
}

static bool is_json(const char *text, size_t length)
{
    const size_t at = skip_space(text, length, begins(text, length, "\xEF\xBB\xBF") ? 3 : 0);
    return at < length && text[at] == '{';
}

/* The format that the bytes look like; OBJ has nothing to know it by. */
static const char *sniff(const char *text, size_t length)
{
    if (begins(text, length, "glTF")) {
        return "glb";
    }
    if (begins(text, length, "ply\n") || begins(text, length, "ply\r")) {
        return "ply";
    }
    if (is_binary_stl(text, length) || is_text_stl(text, length)) {
        return "stl";
    }
    return is_json(text, length) ? "gltf" : "obj";
}

/* Text ends in `endsolid`; without it, its end is missing. */
static bool check_stl(const char *path, const char *text, size_t length, struct text_error *error)
{
    static const char word[] = "endsolid";
    int lines = 1;
    for (size_t i = 0; i < length; i++) {
        lines += text[i] == '\n' ? 1 : 0;
    }
    if (is_binary_stl(text, length)) {
        return true;
    }
    for (size_t at = length; at >= sizeof word - 1 && at + 1024 > length; at--) {
        if (memcmp(text + at - (sizeof word - 1), word, sizeof word - 1) == 0) {
            return true;
        }
    }
    return text_error_set(error, path, lines, "ends without `endsolid`");
}

/* What the library would not notice; what it passes over is left out of *model. */
static bool check_complete(const char *path, const char *text, size_t length, const char *format,
                           struct model *model, struct text_error *error)
{
    if (strcmp(format, "ply") == 0) {
        return model_check_ply(path, text, length, model, error);
    }
    if (format[0] == 'g') {
        return model_check_gltf(path, text, length, model, error);
    }
    return strcmp(format, "stl") != 0 || check_stl(path, text, length, error);
}

static bool read_as(const char *path, const char *text, size_t length, enum model_content content,
                    struct model *model, struct text_error *error)
{
    const char *seen = sniff(text, length);
    const char *format = strcmp(path, "-") == 0 ? seen : ending_of(path);
    if (format == NULL) {
        return text_error_set(error, path, 0, "is not named .obj, .gltf, .glb, .stl or .ply");
    }
    if (strcmp(format, "obj") == 0) {
        return model_parse_obj(path, text, length, content != MODEL_SHAPE, model, error);
    }
    if (strcmp(format, seen) != 0) {
        const char *problem = strcmp(format, "stl") == 0
                                  ? "is neither text that begins with `solid` nor as long as its "
                                    "count of triangles says"
                                  : "does not begin as such a file does";
        return text_error_set(error, path, 0, "%s (%s)", problem, format);
    }
    struct model passed_over = {0};
    if (!check_complete(path, text, length, format, &passed_over, error) ||
        !model_read_library(path, text, length, format, content, model, error)) {
        return false;
    }
    if (content == MODEL_ALL) {
        model_leave_out_words(model, passed_over.left_out);
    }
    if (strcmp(format, "stl") != 0) {
        return true;
    }
    /* Programs write anything for the normals of an STL file: they are made anew. */
    if (!model_check(path, model, error)) {
        model_free(model);
        return false;
    }
    model_make_normals(model, MODEL_NORMALS_FLAT, 0.0);
    return true;
}

/* Where next to nothing of a file becomes triangles, what it holds was not understood. */
static bool check_use(const char *path, const struct model *model, struct text_error *error)
{
    enum { MOST_LOSS = 100 };
    if (model->triangle_count == 0) {
        return text_error_set(error, path, 0, "has no triangle with an area%s%s",
                              model->left_out[0] != '\0' ? ", but: " : "", model->left_out);
    }
    if (model->file_triangles / MOST_LOSS > model->triangle_count) {
        return text_error_set(error, path, 0, "only %zu of its %zu triangles have an area",
                              model->triangle_count, model->file_triangles);
    }
    if (model->file_vertices / MOST_LOSS > 3 * model->triangle_count) {
        return text_error_set(
            error, path, 0,
            "has %zu vertices, and only %zu triangles: is it a cloud of points, or are "
            "its triangles stored in another way than as faces?",
            model->file_vertices, model->triangle_count);
    }
    return true;
}

bool model_read(const char *path, enum model_content content, struct model *model,
                struct text_error *error)
{
    struct file_content file;
    memset(model, 0, sizeof *model);
    if (!file_read(path, &file, error)) {
        return false;
    }
    bool ok = read_as(path, file.bytes, file.length, content, model, error);
    free(file.bytes);
    model->file_triangles = model->triangle_count;
    if (!ok || !model_check(path, model, error)) {
        model_free(model);
        return false;
    }
    model_weld(model);
    if (!check_use(path, model, error)) {
        model_free(model);
        return false;
    }
    model_leave_out(model, model->file_triangles - model->triangle_count, "triangle without area",
                    "triangles without area");
    return true;
}

bool model_can_hold_pictures(const char *text, size_t length)
{
    return sniff(text, length)[0] == 'g'; /* gltf, glb */
}

bool model_picture(const char *path, const char *text, size_t length, unsigned number, char **bytes,
                   size_t *bytes_length, struct text_error *error)
{
    return model_library_picture(path, text, length, sniff(text, length), number, bytes,
                                 bytes_length, error);
}
