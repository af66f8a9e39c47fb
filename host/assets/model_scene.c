/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700
#include "model_scene.h"

#ifdef QTRI_HAVE_ASSIMP

#include <assimp/cimport.h>
#include <assimp/material.h>
#include <assimp/scene.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "model_motion.h"

bool model_request_fail(const struct model_request *request, const char *problem, const char *what)
{
    text_error_set(request->error, request->path, 0, "%s%s", problem, what);
    return false;
}

/* ---- Materials ---- */

static uint8_t byte_of(double value)
{
    return (uint8_t)lround(255.0 * fmin(fmax(value, 0.0), 1.0)); /* NaN: 0 */
}

/* glTF's colours are linear light. */
static double encode(const struct model_request *request, double value)
{
    bool is_linear = request->format[0] == 'g';
    if (!is_linear) {
        return value;
    }
    return value <= 0.0031308 ? 12.92 * value : 1.055 * pow(value, 1.0 / 2.4) - 0.055;
}

static void copy_color(const struct model_request *request, const struct aiColor4D *from,
                       uint8_t to[3])
{
    to[0] = byte_of(encode(request, (double)from->r));
    to[1] = byte_of(encode(request, (double)from->g));
    to[2] = byte_of(encode(request, (double)from->b));
}

/* The name of a material's picture, which of the vertices' texture coordinates are its, and how it
   goes on beyond its edges. False: it has none. */
static bool find_texture(const struct aiMaterial *material, struct aiString *name,
                         unsigned *channel, enum aiTextureMapMode mode[2])
{
    *channel = 0;
    mode[0] = aiTextureMapMode_Wrap;
    mode[1] = aiTextureMapMode_Wrap;
    return aiGetMaterialTexture(material, aiTextureType_BASE_COLOR, 0, name, NULL, channel, NULL,
                                NULL, mode, NULL) == aiReturn_SUCCESS ||
           aiGetMaterialTexture(material, aiTextureType_DIFFUSE, 0, name, NULL, channel, NULL, NULL,
                                mode, NULL) == aiReturn_SUCCESS;
}

static bool copy_texture(const struct model_request *request, const struct aiMaterial *from,
                         struct model_material *to)
{
    struct aiString name;
    unsigned channel;
    enum aiTextureMapMode mode[2];
    if (!find_texture(from, &name, &channel, mode)) {
        return true;
    }
    to->clamp_u = mode[0] == aiTextureMapMode_Clamp;
    to->clamp_v = mode[1] == aiTextureMapMode_Clamp;
    if (name.data[0] == '*') { /* inside the file */
        (void)snprintf(to->texture, sizeof to->texture, "%.15s", name.data);
        return true;
    }
    if (!model_path_beside(to->texture, sizeof to->texture, request->path, name.data)) {
        return model_request_fail(request, "the name of a picture is too long", "");
    }
    if (access(to->texture, F_OK) != 0) {
        return model_request_fail(request, "there is no picture ", to->texture);
    }
    return true;
}

/* glTF says how its alpha is meant; other formats have an opacity. */
static void copy_opacity(const struct aiMaterial *from, double alpha, struct model_material *to)
{
    struct aiString mode;
    ai_real opacity = 1.0f;
    if (aiGetMaterialString(from, "$mat.gltf.alphaMode", 0, 0, &mode) == aiReturn_SUCCESS) {
        to->has_holes = strcmp(mode.data, "OPAQUE") != 0;
        to->opacity = strcmp(mode.data, "BLEND") == 0 ? byte_of(alpha) : 255;
    } else if (aiGetMaterialFloatArray(from, AI_MATKEY_OPACITY, &opacity, NULL) ==
               aiReturn_SUCCESS) {
        to->opacity = byte_of((double)opacity);
    }
}

static bool copy_material(const struct model_request *request, const struct aiMaterial *from,
                          struct model_material *to)
{
    struct aiString name;
    struct aiColor4D color = {1, 1, 1, 1};
    int two_sided = 0;
    if (aiGetMaterialString(from, AI_MATKEY_NAME, &name) == aiReturn_SUCCESS) {
        (void)snprintf(to->name, sizeof to->name, "%.63s", name.data);
    }
    if (aiGetMaterialColor(from, AI_MATKEY_BASE_COLOR, &color) == aiReturn_SUCCESS ||
        aiGetMaterialColor(from, AI_MATKEY_COLOR_DIFFUSE, &color) == aiReturn_SUCCESS) {
        copy_color(request, &color, to->color);
    }
    if (aiGetMaterialIntegerArray(from, AI_MATKEY_TWOSIDED, &two_sided, NULL) == aiReturn_SUCCESS) {
        to->two_sided = two_sided != 0;
    }
    copy_opacity(from, (double)color.a, to);
    return copy_texture(request, from, to);
}

/* ---- Meshes ---- */

/* Where nodes' meshes go: what moves them, where they stand in its space, and how much larger that
   space is than in the file. */
struct place {
    struct aiMatrix4x4 fixed;
    double factor;
    uint16_t node;
};

struct walk {
    const struct model_request *request;
    const struct aiScene *scene;
    const struct aiAnimation *animation; /* NULL: none, or it is not wanted */
    struct model *model;
};

static void copy_vector(const struct aiVector3D *from, double to[3])
{
    to[0] = (double)from->x;
    to[1] = (double)from->y;
    to[2] = (double)from->z;
}

/* Points as they are; normals by the inverse of the transpose. */
struct turn {
    struct aiMatrix4x4 points;
    struct aiMatrix3x3 normals;
    double factor;
    uint16_t node;
    bool mirrors;
};

static void make_turn(const struct place *place, struct turn *turn)
{
    turn->points = place->fixed;
    turn->factor = place->factor;
    turn->node = place->node;
    aiMatrix3FromMatrix4(&turn->normals, &place->fixed);
    turn->mirrors = aiMatrix3Determinant(&turn->normals) < 0;
    aiMatrix3Inverse(&turn->normals);
    aiTransposeMatrix3(&turn->normals);
}

/* Not longer than it can be; the library's word for a normal that it could not make is NaN. */
static void copy_normal(const struct aiVector3D *from, const struct turn *turn, double to[3])
{
    struct aiVector3D normal = *from;
    aiTransformVecByMatrix3(&normal, &turn->normals);
    copy_vector(&normal, to);
    const double length = sqrt(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]);
    for (int i = 0; i < 3; i++) {
        to[i] = length > 0.0 && length <= MODEL_MAX_VALUE ? to[i] / length : 0.0;
    }
}

static void copy_vertex(const struct walk *walk, const struct aiMesh *mesh, const struct turn *turn,
                        unsigned channel, unsigned at)
{
    struct model_vertex *vertex = &walk->model->vertices[walk->model->vertex_count++];
    struct aiVector3D position = mesh->mVertices[at];
    aiTransformVecByMatrix4(&position, &turn->points);
    copy_vector(&position, vertex->position);
    for (int i = 0; i < 3; i++) {
        vertex->position[i] *= turn->factor;
    }
    if (mesh->mNormals != NULL) {
        copy_normal(&mesh->mNormals[at], turn, vertex->normal);
    }
    if (mesh->mTextureCoords[channel] != NULL) {
        vertex->uv[0] = (double)mesh->mTextureCoords[channel][at].x;
        vertex->uv[1] = (double)mesh->mTextureCoords[channel][at].y;
    }
    memset(vertex->color, 255, sizeof vertex->color);
    if (mesh->mColors[0] != NULL) {
        copy_color(walk->request, &mesh->mColors[0][at], vertex->color);
    }
    vertex->material = walk->request->content != MODEL_SHAPE ? (uint16_t)mesh->mMaterialIndex : 0;
    vertex->node = turn->node;
}

/* Appends a mesh at the model's counts, which allocation has made room for. */
static void copy_mesh(const struct walk *walk, const struct aiMesh *mesh, const struct turn *turn)
{
    struct model *model = walk->model;
    const uint32_t first = (uint32_t)model->vertex_count;
    struct aiString name;
    unsigned channel;
    enum aiTextureMapMode mode[2];
    if (!find_texture(walk->scene->mMaterials[mesh->mMaterialIndex], &name, &channel, mode) ||
        channel >= AI_MAX_NUMBER_OF_TEXTURECOORDS || mesh->mTextureCoords[channel] == NULL) {
        channel = 0;
    }
    for (unsigned i = 0; i < mesh->mNumVertices; i++) {
        copy_vertex(walk, mesh, turn, channel, i);
    }
    for (unsigned i = 0; i < mesh->mNumFaces; i++) {
        const struct aiFace *face = &mesh->mFaces[i];
        if (face->mNumIndices == 3) {
            uint32_t *corner = model->triangles[model->triangle_count++];
            for (int j = 0; j < 3; j++) {
                corner[j] = first + face->mIndices[turn->mirrors ? 2 - j : j];
            }
        }
    }
    model->has_uvs = model->has_uvs || mesh->mTextureCoords[channel] != NULL;
    model->has_colors = model->has_colors || mesh->mColors[0] != NULL;
}

/* ---- Nodes ---- */

static bool has_mesh(const struct aiNode *node)
{
    bool found = node->mNumMeshes > 0;
    for (unsigned i = 0; !found && i < node->mNumChildren; i++) {
        found = has_mesh(node->mChildren[i]);
    }
    return found;
}

static const struct aiNodeAnim *channel_of(const struct walk *walk, const struct aiNode *node)
{
    for (unsigned i = 0; walk->animation != NULL && i < walk->animation->mNumChannels; i++) {
        const struct aiNodeAnim *channel = walk->animation->mChannels[i];
        if (strcmp(channel->mNodeName.data, node->mName.data) == 0) {
            return channel;
        }
    }
    return NULL;
}

/* A node that moves has a space of its own; another stands in that of what moves it. */
static bool enter(const struct walk *walk, const struct aiNode *node, struct place *place)
{
    const struct aiNodeAnim *channel = channel_of(walk, node);
    if (channel == NULL || !has_mesh(node) || !motion_moves(channel)) {
        aiMultiplyMatrix4(&place->fixed, &node->mTransformation);
        return true;
    }
    if ((aiMatrix4IsIdentity(&place->fixed) ||
         motion_add_rest(walk->model, &place->fixed, &place->node, &place->factor)) &&
        motion_add_channel(walk->model, walk->animation, channel, &node->mTransformation,
                           &place->node, &place->factor)) {
        aiIdentityMatrix4(&place->fixed);
        return true;
    }
    return model_request_fail(walk->request, "more parts move than there is memory for", "");
}

static bool copy_node(const struct walk *walk, const struct aiNode *node, struct place place)
{
    struct turn turn;
    if (!enter(walk, node, &place)) {
        return false;
    }
    make_turn(&place, &turn);
    for (unsigned i = 0; i < node->mNumMeshes; i++) {
        copy_mesh(walk, walk->scene->mMeshes[node->mMeshes[i]], &turn);
    }
    bool ok = true;
    for (unsigned i = 0; ok && i < node->mNumChildren; i++) {
        ok = copy_node(walk, node->mChildren[i], place);
    }
    return ok;
}

/* A mesh counts as often as nodes show it. */
static void count_node(const struct aiScene *scene, const struct aiNode *node, size_t *vertices,
                       size_t *triangles)
{
    for (unsigned i = 0; i < node->mNumMeshes; i++) {
        *vertices += scene->mMeshes[node->mMeshes[i]]->mNumVertices;
        *triangles += scene->mMeshes[node->mMeshes[i]]->mNumFaces;
    }
    for (unsigned i = 0; i < node->mNumChildren; i++) {
        count_node(scene, node->mChildren[i], vertices, triangles);
    }
}

/* ---- What is left out ---- */

/* Appends ", 3 skins" to the list, or nothing where there are none. */
static void leave_out(struct model *model, size_t count, const char *one, const char *many)
{
    const size_t length = strlen(model->left_out);
    if (count > 0) {
        (void)snprintf(model->left_out + length, sizeof model->left_out - length, "%s%zu %s",
                       length > 0 ? ", " : "", count, count == 1 ? one : many);
    }
}

/* Pictures that say something else than a colour. */
static size_t count_other_pictures(const struct aiScene *scene)
{
    static const enum aiTextureType types[] = {aiTextureType_NORMALS,   aiTextureType_HEIGHT,
                                               aiTextureType_EMISSIVE,  aiTextureType_SPECULAR,
                                               aiTextureType_METALNESS, aiTextureType_LIGHTMAP};
    size_t count = 0;
    for (unsigned i = 0; i < scene->mNumMaterials; i++) {
        for (size_t j = 0; j < sizeof types / sizeof types[0]; j++) {
            count += aiGetMaterialTextureCount(scene->mMaterials[i], types[j]);
        }
    }
    return count;
}

static void list_left_out(const struct walk *walk)
{
    const struct aiScene *scene = walk->scene;
    const bool is_all = walk->request->content == MODEL_ALL;
    size_t skins = 0, morphs = 0, flat = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; i++) {
        const struct aiMesh *mesh = scene->mMeshes[i];
        skins += mesh->mNumBones > 0 ? 1 : 0;
        morphs += mesh->mNumAnimMeshes;
        flat += mesh->mPrimitiveTypes & (aiPrimitiveType_POINT | aiPrimitiveType_LINE) ? 1 : 0;
    }
    leave_out(walk->model, skins, "skin", "skins");
    leave_out(walk->model, morphs, "morph target", "morph targets");
    leave_out(walk->model, scene->mNumAnimations - (walk->animation != NULL ? 1U : 0U),
              is_all ? "further animation" : "animation",
              is_all ? "further animations" : "animations");
    leave_out(walk->model, flat, "mesh of points or lines", "meshes of points or lines");
    leave_out(walk->model, is_all ? count_other_pictures(scene) : 0,
              "picture of other things than colour", "pictures of other things than colour");
}

/* ---- The scene ---- */

static bool copy_pictures(const struct walk *walk)
{
    const struct aiScene *scene = walk->scene;
    struct model *model = walk->model;
    model->pictures = calloc(scene->mNumTextures + (size_t)1, sizeof *model->pictures);
    bool ok = model->pictures != NULL;
    for (unsigned i = 0; ok && i < scene->mNumTextures; i++) {
        const struct aiTexture *from = scene->mTextures[i];
        struct model_picture *to = &model->pictures[model->picture_count++];
        to->length = from->mHeight == 0 ? from->mWidth : 0; /* else texels, a format long gone */
        to->bytes = malloc(to->length + 1);
        ok = to->bytes != NULL;
        if (ok) {
            memcpy(to->bytes, from->pcData, to->length);
        }
    }
    return ok || model_request_fail(walk->request, "out of memory", "");
}

static bool copy_materials(const struct walk *walk)
{
    bool ok = true;
    for (size_t i = 0; ok && i < walk->model->material_count; i++) {
        ok = copy_material(walk->request, walk->scene->mMaterials[i], &walk->model->materials[i]);
    }
    return ok;
}

bool model_copy_scene(const struct model_request *request, const struct aiScene *scene,
                      struct model *model)
{
    struct walk walk = {request, scene, NULL, model};
    struct place place = {.factor = 1.0};
    size_t vertices = 0, triangles = 0;
    const size_t materials = request->content != MODEL_SHAPE ? scene->mNumMaterials : 0;
    count_node(scene, scene->mRootNode, &vertices, &triangles);
    if (triangles > MODEL_MAX_TRIANGLES || vertices > 3 * MODEL_MAX_TRIANGLES) {
        return model_request_fail(
            request, "more than 2097152 triangles; simplify the model elsewhere first", "");
    }
    if (materials > MODEL_MAX_MATERIALS) {
        return model_request_fail(request, "more than 4096 materials", "");
    }
    if (!model_create(model, vertices, triangles, materials == 0 ? 1 : materials)) {
        return model_request_fail(request, "out of memory", "");
    }
    model->file_vertices = vertices;
    model->vertex_count = 0;
    model->triangle_count = 0;
    aiIdentityMatrix4(&place.fixed);
    if (request->content == MODEL_ALL && scene->mNumAnimations > 0) {
        walk.animation = scene->mAnimations[0];
    }
    list_left_out(&walk);
    return copy_node(&walk, scene->mRootNode, place) && (materials == 0 || copy_materials(&walk)) &&
           (request->content != MODEL_ALL || copy_pictures(&walk));
}

#endif
