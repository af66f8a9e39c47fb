/* SPDX-License-Identifier: MIT */
/*
 * glTF, GLB, STL and PLY by the library assimp, in a process of its own.
 */
#define _XOPEN_SOURCE 700
#include "model.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef QTRI_HAVE_ASSIMP

bool model_read_library(const char *path, const char *text, size_t length, const char *format,
                        bool with_materials, struct model *model, struct text_error *error)
{
    (void)text;
    (void)length;
    (void)with_materials;
    (void)model;
    text_error_set(error, path, 0, "this qtri was built without libassimp and cannot read %s",
                   format);
    return false;
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
    text_error_set(error, path, 0, "this qtri was built without libassimp and cannot read %s",
                   format);
    return false;
}

#else

#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/texture.h>
#include <unistd.h>

#include "apart.h"

struct request {
    const char *path, *text, *format;
    size_t length;
    bool with_materials;
    unsigned picture; /* the number that is wanted */
    struct text_error *error;
};

static bool fail(const struct request *request, const char *problem, const char *what)
{
    text_error_set(request->error, request->path, 0, "%s%s", problem, what);
    return false;
}

/* ---- Of a scene of the library ---- */

static uint8_t byte_of(double value)
{
    return (uint8_t)lround(255.0 * fmin(fmax(value, 0.0), 1.0)); /* NaN: 0 */
}

/* glTF's colours are linear light. */
static double encode(const struct request *request, double value)
{
    bool is_linear = request->format[0] == 'g';
    if (!is_linear) {
        return value;
    }
    return value <= 0.0031308 ? 12.92 * value : 1.055 * pow(value, 1.0 / 2.4) - 0.055;
}

static void copy_color(const struct request *request, const struct aiColor4D *from, uint8_t to[3])
{
    to[0] = byte_of(encode(request, (double)from->r));
    to[1] = byte_of(encode(request, (double)from->g));
    to[2] = byte_of(encode(request, (double)from->b));
}

static bool copy_texture(const struct request *request, const struct aiMaterial *from,
                         struct model_material *to)
{
    struct aiString name;
    if (aiGetMaterialTexture(from, aiTextureType_BASE_COLOR, 0, &name, NULL, NULL, NULL, NULL, NULL,
                             NULL) != aiReturn_SUCCESS &&
        aiGetMaterialTexture(from, aiTextureType_DIFFUSE, 0, &name, NULL, NULL, NULL, NULL, NULL,
                             NULL) != aiReturn_SUCCESS) {
        return true;
    }
    if (name.data[0] == '*') { /* inside the file */
        (void)snprintf(to->texture, sizeof to->texture, "%.15s", name.data);
        return true;
    }
    if (!model_path_beside(to->texture, sizeof to->texture, request->path, name.data)) {
        return fail(request, "the name of a picture is too long", "");
    }
    if (access(to->texture, F_OK) != 0) {
        return fail(request, "there is no picture ", to->texture);
    }
    return true;
}

static bool copy_material(const struct request *request, const struct aiMaterial *from,
                          struct model_material *to)
{
    struct aiString name;
    struct aiColor4D color;
    if (aiGetMaterialString(from, AI_MATKEY_NAME, &name) == aiReturn_SUCCESS) {
        (void)snprintf(to->name, sizeof to->name, "%.63s", name.data);
    }
    if (aiGetMaterialColor(from, AI_MATKEY_BASE_COLOR, &color) == aiReturn_SUCCESS ||
        aiGetMaterialColor(from, AI_MATKEY_COLOR_DIFFUSE, &color) == aiReturn_SUCCESS) {
        copy_color(request, &color, to->color);
    }
    return copy_texture(request, from, to);
}

static void copy_vector(const struct aiVector3D *from, double to[3])
{
    to[0] = (double)from->x;
    to[1] = (double)from->y;
    to[2] = (double)from->z;
}

static void copy_vertex(const struct request *request, const struct aiMesh *mesh, unsigned at,
                        struct model_vertex *vertex)
{
    copy_vector(&mesh->mVertices[at], vertex->position);
    if (mesh->mNormals != NULL) {
        copy_vector(&mesh->mNormals[at], vertex->normal);
    }
    for (int i = 0; i < 3; i++) { /* the library's word for a normal that it could not make */
        if (!(fabs(vertex->normal[i]) <= MODEL_MAX_VALUE)) {
            memset(vertex->normal, 0, sizeof vertex->normal);
        }
    }
    if (mesh->mTextureCoords[0] != NULL) {
        vertex->uv[0] = (double)mesh->mTextureCoords[0][at].x;
        vertex->uv[1] = (double)mesh->mTextureCoords[0][at].y;
    }
    memset(vertex->color, 255, sizeof vertex->color);
    if (mesh->mColors[0] != NULL) {
        copy_color(request, &mesh->mColors[0][at], vertex->color);
    }
    vertex->material = request->with_materials ? (uint16_t)mesh->mMaterialIndex : 0;
}

/* Appends a mesh at the model's counts, which allocation has made room for. */
static void copy_mesh(const struct request *request, const struct aiMesh *mesh, struct model *model)
{
    uint32_t first = (uint32_t)model->vertex_count;
    for (unsigned i = 0; i < mesh->mNumVertices; i++) {
        copy_vertex(request, mesh, i, &model->vertices[model->vertex_count++]);
    }
    for (unsigned i = 0; i < mesh->mNumFaces; i++) {
        const struct aiFace *face = &mesh->mFaces[i];
        if (face->mNumIndices == 3) {
            uint32_t *corner = model->triangles[model->triangle_count++];
            for (int j = 0; j < 3; j++) {
                corner[j] = first + face->mIndices[j];
            }
        }
    }
    model->has_uvs = model->has_uvs || mesh->mTextureCoords[0] != NULL;
    model->has_colors = model->has_colors || mesh->mColors[0] != NULL;
}

static bool copy_scene(const struct request *request, const struct aiScene *scene,
                       struct model *model)
{
    size_t vertices = 0, triangles = 0;
    size_t materials = request->with_materials ? scene->mNumMaterials : 0;
    for (unsigned i = 0; i < scene->mNumMeshes; i++) {
        vertices += scene->mMeshes[i]->mNumVertices;
        triangles += scene->mMeshes[i]->mNumFaces;
    }
    if (triangles > MODEL_MAX_TRIANGLES || vertices > 3 * MODEL_MAX_TRIANGLES) {
        return fail(request, "more than 2097152 triangles; simplify the model elsewhere first", "");
    }
    if (materials > MODEL_MAX_MATERIALS) {
        return fail(request, "more than 4096 materials", "");
    }
    if (!model_create(model, vertices, triangles, materials == 0 ? 1 : materials)) {
        return fail(request, "out of memory", "");
    }
    model->vertex_count = 0;
    model->triangle_count = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; i++) {
        copy_mesh(request, scene->mMeshes[i], model);
    }
    for (size_t i = 0; i < materials; i++) {
        if (!copy_material(request, scene->mMaterials[i], &model->materials[i])) {
            return false;
        }
    }
    return true;
}

/* Texture coordinates from the top, as glTF has them; triangles alone; all nodes in one space. */
static const struct aiScene *import(const struct request *request)
{
    const unsigned steps = aiProcess_Triangulate | aiProcess_PreTransformVertices |
                           aiProcess_SortByPType | aiProcess_FlipUVs |
                           aiProcess_ValidateDataStructure;
    struct aiPropertyStore *properties = aiCreatePropertyStore();
    aiSetImportPropertyInteger(properties, AI_CONFIG_PP_SBP_REMOVE,
                               aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const struct aiScene *scene =
        strcmp(request->path, "-") == 0
            ? aiImportFileFromMemoryWithProperties(request->text, (unsigned)request->length, steps,
                                                   request->format, properties)
            : aiImportFileExWithProperties(request->path, steps, NULL, properties);
    aiReleasePropertyStore(properties);
    return scene;
}

static bool read_scene(const struct request *request, struct model *model)
{
    const struct aiScene *scene = import(request);
    if (scene == NULL) {
        const char *reason = aiGetErrorString();
        return fail(request, "cannot be read: ",
                    reason[0] != '\0' ? reason : "the file is incomplete or wrong");
    }
    return copy_scene(request, scene, model);
}

/* ---- Between the two processes ---- */

struct reply {
    bool has_uvs, has_colors;
    size_t vertex_count, triangle_count, material_count;
};

static bool write_all(FILE *file, const void *elements, size_t size, size_t count)
{
    return fwrite(elements, size, count, file) == count;
}

/* In the other process: what fails to be written is noticed there. */
static bool send_model(FILE *file, void *context, struct text_error *error)
{
    struct request *request = (struct request *)context;
    struct model model;
    struct reply reply;
    memset(&model, 0, sizeof model);
    memset(&reply, 0, sizeof reply);
    request->error = error;
    if (!read_scene(request, &model)) {
        return false;
    }
    reply.has_uvs = model.has_uvs;
    reply.has_colors = model.has_colors;
    reply.vertex_count = model.vertex_count;
    reply.triangle_count = model.triangle_count;
    reply.material_count = model.material_count;
    (void)(write_all(file, &reply, sizeof reply, 1) &&
           write_all(file, model.vertices, sizeof *model.vertices, model.vertex_count) &&
           write_all(file, model.triangles, sizeof *model.triangles, model.triangle_count) &&
           write_all(file, model.materials, sizeof *model.materials, model.material_count));
    return true;
}

static bool read_all(FILE *file, void *elements, size_t size, size_t count)
{
    return fread(elements, size, count, file) == count;
}

static bool receive_model(FILE *file, const struct request *request, struct model *model)
{
    struct reply reply;
    if (!read_all(file, &reply, sizeof reply, 1)) {
        return fail(request, "cannot be read: the reader's answer is incomplete", "");
    }
    if (!model_create(model, reply.vertex_count, reply.triangle_count, reply.material_count)) {
        return fail(request, "out of memory", "");
    }
    model->has_uvs = reply.has_uvs;
    model->has_colors = reply.has_colors;
    if (!read_all(file, model->vertices, sizeof *model->vertices, model->vertex_count) ||
        !read_all(file, model->triangles, sizeof *model->triangles, model->triangle_count) ||
        !read_all(file, model->materials, sizeof *model->materials, model->material_count)) {
        model_free(model);
        return fail(request, "cannot be read: the reader's answer is incomplete", "");
    }
    return true;
}

bool model_read_library(const char *path, const char *text, size_t length, const char *format,
                        bool with_materials, struct model *model, struct text_error *error)
{
    struct request request = {path, text, format, length, with_materials, 0, error};
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
    struct request *request = (struct request *)context;
    request->error = error;
    const struct aiScene *scene = import(request);
    if (scene == NULL) {
        return fail(request, "cannot be read: ", aiGetErrorString());
    }
    if (request->picture >= scene->mNumTextures) {
        text_error_set(error, request->path, 0, "there is no picture %u inside, of %u in all",
                       request->picture, scene->mNumTextures);
        return false;
    }
    const struct aiTexture *picture = scene->mTextures[request->picture];
    if (picture->mHeight != 0) {
        return fail(request, "its picture is not stored as PNG or JPEG", "");
    }
    (void)write_all(file, picture->pcData, 1, picture->mWidth);
    return true;
}

static bool receive_picture(FILE *file, const struct request *request, char **bytes, size_t *length)
{
    const long start = ftell(file);
    long end = start;
    if (start >= 0 && fseek(file, 0, SEEK_END) == 0) {
        end = ftell(file);
    }
    *length = end > start ? (size_t)(end - start) : 0;
    *bytes = malloc(*length + 1);
    if (*bytes == NULL) {
        return fail(request, "out of memory", "");
    }
    if (fseek(file, start, SEEK_SET) != 0 || !read_all(file, *bytes, 1, *length)) {
        free(*bytes);
        return fail(request, "cannot be read: the reader's answer is incomplete", "");
    }
    return true;
}

bool model_library_picture(const char *path, const char *text, size_t length, const char *format,
                           unsigned number, char **bytes, size_t *bytes_length,
                           struct text_error *error)
{
    struct request request = {path, text, format, length, false, number, error};
    FILE *file = apart_run(path, send_picture, &request, error);
    bool ok = file != NULL && receive_picture(file, &request, bytes, bytes_length);
    if (file != NULL) {
        (void)fclose(file);
    }
    return ok;
}

#endif
