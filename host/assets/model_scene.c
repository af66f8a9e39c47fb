/* SPDX-License-Identifier: MIT */
#include "model_scene.h"

#ifdef QTRI_HAVE_ASSIMP

#include <assimp/cimport.h>
#include <assimp/material.h>
#include <assimp/scene.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../io/mipmap.h"
#include "model_morph.h"
#include "model_motion.h"

bool model_request_fail(const struct model_request *request, const char *problem, const char *what)
{
    return text_error_set(request->error, request->path, 0, "%s%s", problem, what);
}

/* ---- Materials ---- */

static uint8_t byte_of(double value)
{
    return (uint8_t)lround(255.0 * fmin(fmax(value, 0.0), 1.0)); /* NaN: 0 */
}

/* glTF's colours are linear light. */
static double encode(const struct model_request *request, double value)
{
    const bool is_linear = request->format[0] == 'g';
    return is_linear ? mipmap_from_linear(value) : value;
}

static void copy_color(const struct model_request *request, const struct aiColor4D *from,
                       uint8_t to[3])
{
    to[0] = byte_of(encode(request, (double)from->r));
    to[1] = byte_of(encode(request, (double)from->g));
    to[2] = byte_of(encode(request, (double)from->b));
}

bool model_find_picture(const struct aiMaterial *material, struct model_picture_use *use)
{
    static const enum aiTextureType types[] = {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE};
    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++) {
        memset(use, 0, sizeof *use); /* the picture repeats */
        use->type = types[i];
        if (aiGetMaterialTexture(material, types[i], 0, &use->name, NULL, &use->channel, NULL, NULL,
                                 use->mode, NULL) == aiReturn_SUCCESS) {
            return true;
        }
    }
    use->channel = 0;
    return false;
}

static void copy_texture(const struct model_request *request, const struct aiMaterial *from,
                         struct model *model, struct model_material *to)
{
    struct model_picture_use use;
    if (!model_find_picture(from, &use)) {
        return;
    }
    to->clamp_u = use.mode[0] == aiTextureMapMode_Clamp;
    to->clamp_v = use.mode[1] == aiTextureMapMode_Clamp;
    if (use.name.data[0] == '*') { /* inside the file */
        (void)snprintf(to->texture, sizeof to->texture, "%.15s", use.name.data);
    } else {
        model_picture_beside(model, to, request->path, use.name.data);
    }
}

/* glTF says how its alpha is meant; other formats have an opacity. */
static void copy_opacity(const struct aiMaterial *from, double alpha, struct model_material *to)
{
    struct aiString mode;
    ai_real opacity = 1.0f;
    if (aiGetMaterialString(from, "$mat.gltf.alphaMode", 0, 0, &mode) == aiReturn_SUCCESS) {
        to->has_holes = strcmp(mode.data, "OPAQUE") != 0;
        to->is_blended = strcmp(mode.data, "BLEND") == 0;
        to->opacity = to->is_blended ? byte_of(alpha) : 255;
    } else if (aiGetMaterialFloatArray(from, AI_MATKEY_OPACITY, &opacity, NULL) ==
               aiReturn_SUCCESS) {
        to->opacity = byte_of((double)opacity);
    }
}

static void copy_material(const struct model_request *request, const struct aiMaterial *from,
                          struct model *model, struct model_material *to)
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
    copy_texture(request, from, model, to);
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
    struct motion_curves curves;         /* of the animation */
    struct json nodes;                   /* of glTF 1, by the names that the library has */
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

/* Which texture coordinates a mesh has of its picture, and what becomes of them. */
struct uvs {
    const struct aiVector3D *from; /* NULL: none */
    double matrix[2][3];
};

/*
 * The library turns a picture about its middle and counts from its last row; with aiProcess_FlipUVs
 * its angle is that of glTF's KHR_texture_transform. Of that this is the matrix: scale, rotation,
 * offset, in this order.
 */
static void set_matrix(const struct aiUVTransform *use, double matrix[2][3])
{
    const double angle = (double)use->mRotation, c = cos(angle), s = sin(angle);
    const double x = (double)use->mScaling.x, y = (double)use->mScaling.y;
    matrix[0][0] = c * x;
    matrix[0][1] = s * y;
    matrix[0][2] = (double)use->mTranslation.x - 0.5 * x * (1.0 + s - c);
    matrix[1][0] = -s * x;
    matrix[1][1] = c * y;
    matrix[1][2] = (double)use->mTranslation.y + 0.5 * y * (s + c - 1.0) + 1.0 - y;
}

static void find_uvs(const struct walk *walk, const struct aiMesh *mesh, struct uvs *uvs)
{
    struct model_picture_use use;
    struct aiUVTransform transform = {.mScaling = {1, 1}};
    const struct aiMaterial *material = walk->scene->mMaterials[mesh->mMaterialIndex];
    if (model_find_picture(material, &use)) {
        (void)aiGetMaterialUVTransform(material, AI_MATKEY_UVTRANSFORM(use.type, 0), &transform);
    }
    if (use.channel >= AI_MAX_NUMBER_OF_TEXTURECOORDS ||
        mesh->mTextureCoords[use.channel] == NULL) {
        use.channel = 0;
    }
    uvs->from = mesh->mTextureCoords[use.channel];
    set_matrix(&transform, uvs->matrix);
}

static void copy_vertex(const struct walk *walk, const struct aiMesh *mesh, const struct turn *turn,
                        const struct uvs *uvs, unsigned at)
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
    for (int i = 0; uvs->from != NULL && i < 2; i++) {
        vertex->uv[i] = uvs->matrix[i][0] * (double)uvs->from[at].x +
                        uvs->matrix[i][1] * (double)uvs->from[at].y + uvs->matrix[i][2];
    }
    memset(vertex->color, 255, sizeof vertex->color);
    if (mesh->mColors[0] != NULL) {
        copy_color(walk->request, &mesh->mColors[0][at], vertex->color);
    }
    vertex->material = walk->request->content != MODEL_SHAPE ? (uint16_t)mesh->mMaterialIndex : 0;
    vertex->node = turn->node;
}

/* Appends a mesh at the model's counts, which allocation has made room for. has_targets: those of
   the model's last morph. */
static void copy_mesh(const struct walk *walk, const struct aiMesh *mesh, const struct turn *turn,
                      bool has_targets)
{
    struct model *model = walk->model;
    const uint32_t first = (uint32_t)model->vertex_count;
    struct uvs uvs;
    struct turn own = *turn;
    struct aiMatrix4x4 *skin = model_skin_at_rest(walk->scene, mesh);
    find_uvs(walk, mesh, &uvs);
    for (unsigned i = 0; i < mesh->mNumVertices; i++) {
        if (skin != NULL && skin[i].d4 > 0) {
            const struct place at_rest = {skin[i], 1.0, 0};
            make_turn(&at_rest, &own);
        }
        copy_vertex(walk, mesh, &own, &uvs, i);
        if (has_targets) {
            const struct aiMatrix4x4 *m = &own.points;
            const double f = own.factor;
            const double matrix[3][3] = {{f * (double)m->a1, f * (double)m->a2, f * (double)m->a3},
                                         {f * (double)m->b1, f * (double)m->b2, f * (double)m->b3},
                                         {f * (double)m->c1, f * (double)m->c2, f * (double)m->c3}};
            morph_copy(model, mesh, i, matrix, &model->vertices[first + i]);
        }
    }
    free(skin);
    for (unsigned i = 0; i < mesh->mNumFaces; i++) {
        const struct aiFace *face = &mesh->mFaces[i];
        if (face->mNumIndices == 3) {
            uint32_t *corner = model->triangles[model->triangle_count++];
            for (int j = 0; j < 3; j++) {
                corner[j] = first + face->mIndices[own.mirrors ? 2 - j : j];
            }
        }
    }
    model->has_uvs = model->has_uvs || uvs.from != NULL;
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

/* Curves may lead away from keys that are alike. */
static bool moves(const struct walk *walk, const struct aiNodeAnim *channel)
{
    bool found = motion_moves(channel);
    for (int i = 0; !found && i < MOTION_WEIGHTS; i++) {
        const struct motion_curve *curve =
            motion_curve_of(&walk->curves, channel->mNodeName.data, (enum motion_path)i);
        found = curve != NULL && curve->is_cubic;
    }
    return found;
}

/* The library turns and scales a translation of glTF 1 as well. */
static struct aiMatrix4x4 matrix_of(const struct walk *walk, const struct aiNode *node)
{
    struct aiMatrix4x4 matrix = node->mTransformation;
    const struct json as_written = json_member(walk->nodes, node->mName.data);
    const struct json translation = json_member(as_written, "translation");
    if (translation.at != NULL && json_member(as_written, "matrix").at == NULL) {
        matrix.a4 = (ai_real)json_number(json_element(translation, 0), 0.0);
        matrix.b4 = (ai_real)json_number(json_element(translation, 1), 0.0);
        matrix.c4 = (ai_real)json_number(json_element(translation, 2), 0.0);
    }
    return matrix;
}

/* A node that moves has a space of its own; another stands in that of what moves it. */
static bool enter(const struct walk *walk, const struct aiNode *node, struct place *place)
{
    const struct aiNodeAnim *channel = channel_of(walk, node);
    if (channel == NULL || !has_mesh(node) || !moves(walk, channel)) {
        const struct aiMatrix4x4 matrix = matrix_of(walk, node);
        aiMultiplyMatrix4(&place->fixed, &matrix);
        return true;
    }
    if ((aiMatrix4IsIdentity(&place->fixed) ||
         motion_add_rest(walk->model, &place->fixed, &place->node, &place->factor)) &&
        motion_add_channel(walk->model, walk->animation, channel, &walk->curves,
                           &node->mTransformation, &place->node, &place->factor)) {
        aiIdentityMatrix4(&place->fixed);
        return true;
    }
    return model_request_fail(walk->request, "more parts move than there is memory for", "");
}

static const struct aiMeshMorphAnim *morph_channel_of(const struct walk *walk,
                                                      const struct aiNode *node)
{
    for (unsigned i = 0; walk->animation != NULL && i < walk->animation->mNumMorphMeshChannels;
         i++) {
        const struct aiMeshMorphAnim *channel = walk->animation->mMorphMeshChannels[i];
        if (strcmp(channel->mName.data, node->mName.data) == 0) {
            return channel;
        }
    }
    return NULL;
}

static double ticks_per_second(const struct aiAnimation *animation)
{
    return animation != NULL && animation->mTicksPerSecond > 0.0 ? animation->mTicksPerSecond
                                                                 : 25.0;
}

/* The meshes of a node that have as many targets share their weights. */
static bool copy_meshes(const struct walk *walk, const struct aiNode *node, const struct turn *turn)
{
    const bool is_all = walk->request->content == MODEL_ALL;
    unsigned targets = 0; /* of the morph that was added last */
    for (unsigned i = 0; i < node->mNumMeshes; i++) {
        const struct aiMesh *mesh = walk->scene->mMeshes[node->mMeshes[i]];
        const unsigned own = is_all ? morph_targets(mesh) : 0;
        const bool has_targets = own > 0 && morph_reserve(walk->model, mesh);
        if (has_targets && own != targets) {
            const struct motion_curve *curve =
                motion_curve_of(&walk->curves, node->mName.data, MOTION_WEIGHTS);
            if (!morph_add(walk->model, mesh, morph_channel_of(walk, node),
                           curve != NULL && curve->width >= own ? curve : NULL,
                           ticks_per_second(walk->animation))) {
                return model_request_fail(walk->request, "out of memory", "");
            }
            targets = own;
        }
        model_leave_out(walk->model, is_all && !has_targets ? mesh->mNumAnimMeshes : 0,
                        "morph target", "morph targets");
        copy_mesh(walk, mesh, turn, has_targets);
    }
    return true;
}

static bool copy_node(const struct walk *walk, const struct aiNode *node, struct place place)
{
    struct turn turn;
    if (!enter(walk, node, &place)) {
        return false;
    }
    make_turn(&place, &turn);
    bool ok = copy_meshes(walk, node, &turn);
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

static void copy_materials(const struct walk *walk)
{
    for (size_t i = 0; i < walk->model->material_count; i++) {
        copy_material(walk->request, walk->scene->mMaterials[i], walk->model,
                      &walk->model->materials[i]);
    }
}

bool model_copy_scene(const struct model_request *request, const struct aiScene *scene,
                      struct model *model)
{
    struct walk walk = {.request = request, .scene = scene, .model = model};
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
    if (strcmp(request->format, "gltf") == 0) {
        walk.nodes = json_member(json_text(request->text, request->length), "nodes");
    }
    if (request->content == MODEL_ALL && scene->mNumAnimations > 0) {
        walk.animation = scene->mAnimations[0];
    }
    bool ok = walk.animation == NULL || request->format[0] != 'g' ||
              motion_curves_read(request->path, request->text, request->length,
                                 ticks_per_second(walk.animation), &walk.curves) ||
              model_request_fail(request, "out of memory", "");
    model_leave_out(model, walk.curves.lost, "curve or steps between keys",
                    "curves or steps between keys");
    if (materials > 0) {
        copy_materials(&walk);
    }
    ok = ok && copy_node(&walk, scene->mRootNode, place) &&
         (request->content != MODEL_ALL || copy_pictures(&walk));
    motion_curves_free(&walk.curves);
    return ok;
}

#endif
