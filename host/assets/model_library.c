/* SPDX-License-Identifier: MIT */
/*
 * glTF, GLB, STL and PLY by the library assimp, in a process of its own.
 */
#include "model.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef QTRI_HAVE_ASSIMP

bool model_read_library(const char *path, const char *text, size_t length, const char *format,
                        enum model_content content, struct model *model, struct text_error *error)
{
    (void)text;
    (void)length;
    (void)content;
    (void)model;
    return text_error_set(error, path, 0,
                          "this qtri was built without libassimp and cannot read %s", format);
}

bool model_library_picture(const char *path, const char *text, size_t length, const char *format,
                           unsigned number, char **bytes, size_t *bytes_length,
                           struct text_error *error)
{
    (void)text;
    (void)length;
    (void)number;
    *bytes = NULL;
    *bytes_length = 0;
    return text_error_set(error, path, 0,
                          "this qtri was built without libassimp and cannot read %s", format);
}

#else

#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/texture.h>

#include "apart.h"
#include "model_scene.h"

/* Texture coordinates from the top, as glTF has them; and triangles. */
static const struct aiScene *import(const struct model_request *request)
{
    const unsigned steps = aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_FlipUVs |
                           aiProcess_ValidateDataStructure;
    struct aiPropertyStore *properties = aiCreatePropertyStore();
    const struct aiScene *scene =
        strcmp(request->path, "-") == 0
            ? aiImportFileFromMemoryWithProperties(request->text, (unsigned)request->length, steps,
                                                   request->format, properties)
            : aiImportFileExWithProperties(request->path, steps, NULL, properties);
    aiReleasePropertyStore(properties);
    return scene;
}

/* The library passes over triangles whose indices are out of range. */
static void leave_out_triangles(const struct model_request *request, const struct aiScene *scene,
                                struct model *model)
{
    size_t read = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; i++) {
        read += scene->mMeshes[i]->mNumFaces;
    }
    const size_t said = request->format[0] == 'g' && request->content == MODEL_ALL
                            ? model_gltf_triangles(request->text, request->length)
                            : 0;
    model_leave_out(model, said > read ? said - read : 0, "triangle with an index out of range",
                    "triangles with an index out of range");
}

static bool read_scene(const struct model_request *request, struct model *model)
{
    const struct aiScene *scene = import(request);
    if (scene == NULL) {
        const char *reason = aiGetErrorString();
        return model_request_fail(request, "cannot be read: ",
                                  reason[0] != '\0' ? reason : "the file is incomplete or wrong");
    }
    if (!model_copy_scene(request, scene, model)) {
        return false;
    }
    model_list_left_out(scene, request->content == MODEL_ALL, model);
    leave_out_triangles(request, scene, model);
    return true;
}

/* ---- Between the two processes ---- */

static bool write_all(FILE *file, const void *elements, size_t size, size_t count)
{
    return fwrite(elements, size, count, file) == count;
}

static bool read_all(FILE *file, void *elements, size_t size, size_t count)
{
    return fread(elements, size, count, file) == count;
}

/* Memory for what is read, which is not there at all for nothing; false when it runs out. */
static bool read_new(FILE *file, void **elements, size_t size, size_t count)
{
    *elements = calloc(count + 1, size);
    return *elements != NULL && read_all(file, *elements, size, count);
}

/* The arrays of a model but for its pictures: where pointer and count are, and an element's bytes.
 */
#define ARRAY(member, count)                                                                       \
    {                                                                                              \
        offsetof(struct model, member), offsetof(struct model, count),                             \
            sizeof *((struct model *)0)->member                                                    \
    }
static const struct {
    size_t at, count_at, bytes;
} arrays[] = {
    ARRAY(vertices, vertex_count),    ARRAY(triangles, triangle_count),
    ARRAY(materials, material_count), ARRAY(nodes, node_count),
    ARRAY(keys, key_count),           ARRAY(morphs, morph_count),
    ARRAY(tracks, track_count),       ARRAY(shifts, shift_count),
};

enum { ARRAYS = sizeof arrays / sizeof arrays[0] };

static size_t count_of(const struct model *model, int array)
{
    return *(const size_t *)(const void *)((const char *)model + arrays[array].count_at);
}

/* The model's struct, whose pointers mean nothing in the other process, then what they point to. */
static bool write_model(FILE *file, const struct model *model)
{
    bool ok = write_all(file, model, sizeof *model, 1);
    for (int i = 0; ok && i < ARRAYS; i++) {
        const void *elements;
        memcpy(&elements, (const char *)model + arrays[i].at, sizeof elements);
        ok = elements == NULL || write_all(file, elements, arrays[i].bytes, count_of(model, i));
    }
    for (size_t i = 0; ok && i < model->picture_count; i++) {
        const struct model_picture *picture = &model->pictures[i];
        ok = write_all(file, &picture->length, sizeof picture->length, 1) &&
             write_all(file, picture->bytes, 1, picture->length);
    }
    return ok;
}

static bool read_pictures(FILE *file, struct model *model, size_t count)
{
    model->pictures = calloc(count + 1, sizeof *model->pictures);
    bool ok = model->pictures != NULL;
    for (size_t i = 0; ok && i < count; i++) {
        struct model_picture *picture = &model->pictures[model->picture_count++];
        void *bytes = NULL;
        ok = read_all(file, &picture->length, sizeof picture->length, 1) &&
             read_new(file, &bytes, 1, picture->length);
        picture->bytes = bytes;
    }
    return ok;
}

static bool read_model(FILE *file, struct model *model)
{
    memset(model, 0, sizeof *model);
    bool ok = read_all(file, model, sizeof *model, 1);
    const size_t pictures = model->picture_count;
    model->pictures = NULL;
    model->picture_count = 0;
    for (int i = 0; i < ARRAYS; i++) { /* all of them: what was sent is nothing to be freed */
        void *elements = NULL;
        ok = ok && read_new(file, &elements, arrays[i].bytes, count_of(model, i));
        memcpy((char *)model + arrays[i].at, &elements, sizeof elements);
    }
    return ok && read_pictures(file, model, pictures);
}

/* In the other process: what fails to be written is noticed there. */
static bool send_model(FILE *file, void *context, struct text_error *error)
{
    struct model_request *request = (struct model_request *)context;
    struct model model;
    memset(&model, 0, sizeof model);
    request->error = error;
    if (!read_scene(request, &model)) {
        return false;
    }
    (void)write_model(file, &model);
    return true;
}

static bool receive_model(FILE *file, const struct model_request *request, struct model *model)
{
    if (!read_model(file, model)) {
        model_free(model);
        return model_request_fail(request, "cannot be read: the reader's answer is incomplete", "");
    }
    return true;
}

bool model_read_library(const char *path, const char *text, size_t length, const char *format,
                        enum model_content content, struct model *model, struct text_error *error)
{
    struct model_request request = {path, text, format, length, content, 0, error};
    memset(model, 0, sizeof *model);
    FILE *file = apart_run(path, send_model, &request, error);
    bool ok = file != NULL && receive_model(file, &request, model);
    if (file != NULL) {
        (void)fclose(file);
    }
    return ok;
}

/* ---- Pictures inside of models ---- */

/* A picture that is stored as its file was; others, texel by texel, are of formats long gone. */
static bool send_picture(FILE *file, void *context, struct text_error *error)
{
    struct model_request *request = (struct model_request *)context;
    request->error = error;
    const struct aiScene *scene = import(request);
    if (scene == NULL) {
        return model_request_fail(request, "cannot be read: ", aiGetErrorString());
    }
    if (request->picture >= scene->mNumTextures) {
        return text_error_set(error, request->path, 0,
                              "there is no picture %u inside, of %u in all", request->picture,
                              scene->mNumTextures);
    }
    const struct aiTexture *picture = scene->mTextures[request->picture];
    if (picture->mHeight != 0) {
        return model_request_fail(request, "its picture is not stored as PNG or JPEG", "");
    }
    (void)write_all(file, picture->pcData, 1, picture->mWidth);
    return true;
}

static bool receive_picture(FILE *file, const struct model_request *request, char **bytes,
                            size_t *length)
{
    const long start = ftell(file);
    long end = start;
    if (start >= 0 && fseek(file, 0, SEEK_END) == 0) {
        end = ftell(file);
    }
    *length = end > start ? (size_t)(end - start) : 0;
    *bytes = malloc(*length + 1);
    if (*bytes == NULL) {
        return model_request_fail(request, "out of memory", "");
    }
    if (fseek(file, start, SEEK_SET) != 0 || !read_all(file, *bytes, 1, *length)) {
        free(*bytes);
        return model_request_fail(request, "cannot be read: the reader's answer is incomplete", "");
    }
    return true;
}

bool model_library_picture(const char *path, const char *text, size_t length, const char *format,
                           unsigned number, char **bytes, size_t *bytes_length,
                           struct text_error *error)
{
    struct model_request request = {path, text, format, length, MODEL_SHAPE, number, error};
    FILE *file = apart_run(path, send_picture, &request, error);
    bool ok = file != NULL && receive_picture(file, &request, bytes, bytes_length);
    if (file != NULL) {
        (void)fclose(file);
    }
    return ok;
}

#endif
