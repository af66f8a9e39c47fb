/* SPDX-License-Identifier: MIT */
/*
 * What ../assets asks of the library assimp, of a GLB file: files.js has laid out its content as
 * 32-bit words in a file named like it, with `.words` behind. A text is its length in bytes, its
 * bytes, and zeros up to the next word.
 */
#include <assimp/cimport.h>
#include <assimp/material.h>
#include <assimp/scene.h>
#include <assimp/texture.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "web_files.h"

/* ---- Memory, until the next import ---- */

static struct chunk {
    struct chunk *next;
} * chunks;

static void *take(size_t count, size_t size)
{
    struct chunk *chunk = calloc(1, 16 + count * size);
    if (chunk == NULL) {
        abort();
    }
    chunk->next = chunks;
    chunks = chunk;
    return (char *)chunk + 16;
}

static void release(void)
{
    while (chunks != NULL) {
        struct chunk *next = chunks->next;
        free(chunks);
        chunks = next;
    }
}

/* ---- Words ---- */

static uint32_t *at; /* the next one */

static uint32_t number(void)
{
    return *at++;
}

/* So many words, where they are. */
static void *words(size_t count)
{
    void *first = at;
    at += count;
    return first;
}

static float real(void)
{
    return *(float *)words(1);
}

static struct aiString text(void)
{
    struct aiString string = {.length = 0};
    const uint32_t length = number();
    string.length = length < sizeof string.data ? length : (uint32_t)sizeof string.data - 1;
    memcpy(string.data, words((length + 3) / 4), string.length);
    return string;
}

/* Column by column. */
static struct aiMatrix4x4 matrix(void)
{
    struct aiMatrix4x4 m = {.a1 = 0};
    for (int i = 0; i < 16; i++) {
        (&m.a1)[i % 4 * 4 + i / 4] = real();
    }
    return m;
}

/* The count and the elements of what follows. */
static void *list(unsigned *count, void *element(void))
{
    *count = number();
    void **elements = take(*count, sizeof *elements);
    for (unsigned i = 0; i < *count; i++) {
        elements[i] = element();
    }
    return elements;
}

/* ---- Materials ---- */

struct material { /* what an aiMaterial points at here */
    struct aiMaterial base;
    struct aiString name, alpha_mode, picture;
    struct aiColor4D color, emissive;
    int two_sided;
    uint32_t other_pictures, has_picture, channel, wrap[2];
    struct aiUVTransform transform;
};

/* glTF turns a picture about its corner, the library about its middle. */
static struct aiUVTransform transform(void)
{
    struct aiUVTransform t = {.mRotation = 0};
    const float *offset = words(2), angle = real(), c = cosf(angle), s = sinf(angle);
    t.mRotation = angle;
    t.mScaling = *(struct aiVector2D *)words(2);
    t.mTranslation.x = 0.5f * t.mScaling.x * (-c + s + 1) + offset[0];
    t.mTranslation.y = -(0.5f * t.mScaling.y * (s + c - 1) + 1 - t.mScaling.y - offset[1]);
    return t;
}

static void *material(void)
{
    struct material *m = take(1, sizeof *m);
    m->name = text();
    m->alpha_mode = text();
    m->color = *(struct aiColor4D *)words(4);
    m->emissive = *(struct aiColor4D *)words(4);
    m->two_sided = (int)number();
    m->other_pictures = number();
    m->has_picture = number();
    m->picture = text();
    m->channel = number();
    m->wrap[0] = number();
    m->wrap[1] = number();
    m->transform = transform();
    return m;
}

static const struct material *from(const struct aiMaterial *base)
{
    return (const struct material *)base;
}

/* NOLINTBEGIN(readability-non-const-parameter): the library's */

aiReturn aiGetMaterialString(const struct aiMaterial *mat, const char *key, unsigned type,
                             unsigned index, struct aiString *out)
{
    (void)type;
    (void)index;
    *out = strcmp(key, "?mat.name") == 0 ? from(mat)->name : from(mat)->alpha_mode;
    return out->length > 0 ? aiReturn_SUCCESS : aiReturn_FAILURE;
}

aiReturn aiGetMaterialColor(const struct aiMaterial *mat, const char *key, unsigned type,
                            unsigned index, struct aiColor4D *out)
{
    (void)type;
    (void)index;
    *out = strcmp(key, "$clr.emissive") == 0 ? from(mat)->emissive : from(mat)->color;
    return aiReturn_SUCCESS;
}

/* Of an opacity: glTF has the mode of its alpha. */
aiReturn aiGetMaterialFloatArray(const struct aiMaterial *mat, const char *key, unsigned type,
                                 unsigned index, ai_real *out, unsigned *count)
{
    (void)mat, (void)key, (void)type, (void)index, (void)out, (void)count;
    return aiReturn_FAILURE;
}

aiReturn aiGetMaterialIntegerArray(const struct aiMaterial *mat, const char *key, unsigned type,
                                   unsigned index, int *out, unsigned *count)
{
    (void)key, (void)type, (void)index, (void)count;
    *out = from(mat)->two_sided;
    return aiReturn_SUCCESS;
}

unsigned aiGetMaterialTextureCount(const struct aiMaterial *mat, enum aiTextureType type)
{
    return type == aiTextureType_NORMALS ? from(mat)->other_pictures : 0;
}

aiReturn aiGetMaterialTexture(const struct aiMaterial *mat, enum aiTextureType type, unsigned index,
                              struct aiString *path, enum aiTextureMapping *mapping,
                              unsigned *channel, ai_real *blend, enum aiTextureOp *op,
                              enum aiTextureMapMode *mode, unsigned *flags)
{
    (void)type, (void)index, (void)mapping, (void)blend, (void)op, (void)flags;
    *path = from(mat)->picture;
    *channel = from(mat)->channel;
    mode[0] = (enum aiTextureMapMode)from(mat)->wrap[0];
    mode[1] = (enum aiTextureMapMode)from(mat)->wrap[1];
    return from(mat)->has_picture ? aiReturn_SUCCESS : aiReturn_FAILURE;
}

aiReturn aiGetMaterialUVTransform(const struct aiMaterial *mat, const char *key, unsigned type,
                                  unsigned index, struct aiUVTransform *out)
{
    (void)key, (void)type, (void)index;
    *out = from(mat)->transform;
    return aiReturn_SUCCESS;
}

/* NOLINTEND(readability-non-const-parameter) */

/* ---- Meshes ---- */

/* From the top, as glTF has it: the library flips it as it reads, and once more when asked to. */
static struct aiVector3D *uvs(unsigned count)
{
    struct aiVector3D *vectors = take(count, sizeof *vectors);
    for (unsigned i = 0; i < count; i++) {
        vectors[i].x = real();
        vectors[i].y = 1 - (1 - real());
    }
    return vectors;
}

static const struct aiMesh *shaped; /* the mesh whose targets are read */

static void *target(void)
{
    const struct aiMesh *mesh = shaped;
    struct aiAnimMesh *target = take(1, sizeof *target);
    target->mNumVertices = mesh->mNumVertices;
    target->mWeight = real();
    target->mNormals = number() ? mesh->mNormals : NULL; /* whether it has any is asked */
    if (number()) {
        const float *shifts = words(3 * (size_t)mesh->mNumVertices);
        target->mVertices = take(mesh->mNumVertices, sizeof *target->mVertices);
        for (unsigned i = 0; i < 3 * mesh->mNumVertices; i++) {
            (&target->mVertices->x)[i] = (&mesh->mVertices->x)[i] + shifts[i];
        }
    }
    return target;
}

static void *bone(void)
{
    struct aiBone *bone = take(1, sizeof *bone);
    bone->mName = text();
    bone->mOffsetMatrix = matrix();
    bone->mNumWeights = number();
    bone->mWeights = words(2 * (size_t)bone->mNumWeights); /* a vertex and a float each */
    return bone;
}

/* Triangles of vertices that are not there are left out. */
static void faces(struct aiMesh *mesh, unsigned count)
{
    mesh->mFaces = take(count, sizeof *mesh->mFaces);
    for (unsigned i = 0; i < count; i++) {
        unsigned *corner = words(3);
        if (corner[0] < mesh->mNumVertices && corner[1] < mesh->mNumVertices &&
            corner[2] < mesh->mNumVertices) {
            mesh->mFaces[mesh->mNumFaces++] = (struct aiFace){3, corner};
        }
    }
}

static void *mesh(void)
{
    struct aiMesh *mesh = take(1, sizeof *mesh);
    mesh->mPrimitiveTypes = number() ? aiPrimitiveType_TRIANGLE : aiPrimitiveType_LINE;
    mesh->mMaterialIndex = number();
    mesh->mNumVertices = number();
    mesh->mVertices = words(3 * (size_t)mesh->mNumVertices);
    mesh->mNormals = number() ? words(3 * (size_t)mesh->mNumVertices) : NULL;
    for (unsigned i = 0, count = number(); i < count; i++) {
        mesh->mTextureCoords[i] = uvs(mesh->mNumVertices);
    }
    for (unsigned i = 0, count = number(); i < count; i++) {
        mesh->mColors[i] = words(4 * (size_t)mesh->mNumVertices);
    }
    faces(mesh, number());
    shaped = mesh;
    mesh->mAnimMeshes = list(&mesh->mNumAnimMeshes, target);
    mesh->mBones = list(&mesh->mNumBones, bone);
    return mesh;
}

/* ---- Nodes and what moves them ---- */

/* The product of translation, rotation and scale. */
static struct aiMatrix4x4 product(void)
{
    const float *t = words(3), *q = words(4), *s = words(3);
    const float x = q[0], y = q[1], z = q[2], w = q[3];
    struct aiMatrix4x4 m = {1, 0, 0, t[0], 0, 1, 0, t[1], 0, 0, 1, t[2], 0, 0, 0, 1};
    const struct aiMatrix4x4 rotation = {1 - 2 * (y * y + z * z),
                                         2 * (x * y - z * w),
                                         2 * (x * z + y * w),
                                         0,
                                         2 * (x * y + z * w),
                                         1 - 2 * (x * x + z * z),
                                         2 * (y * z - x * w),
                                         0,
                                         2 * (x * z - y * w),
                                         2 * (y * z + x * w),
                                         1 - 2 * (x * x + y * y),
                                         0,
                                         0,
                                         0,
                                         0,
                                         1};
    const struct aiMatrix4x4 scale = {.a1 = s[0], .b2 = s[1], .c3 = s[2], .d4 = 1};
    aiMultiplyMatrix4(&m, &rotation);
    aiMultiplyMatrix4(&m, &scale);
    return m;
}

static void *node(void)
{
    struct aiNode *own = take(1, sizeof *own);
    own->mName = text();
    own->mTransformation = number() ? matrix() : product();
    own->mNumMeshes = number();
    own->mMeshes = words(own->mNumMeshes);
    own->mChildren = list(&own->mNumChildren, node);
    for (unsigned i = 0; i < own->mNumChildren; i++) {
        own->mChildren[i]->mParent = own;
    }
    return own;
}

static double milliseconds(void)
{
    return (double)(real() * 1000.0f);
}

static struct aiVectorKey *vector_keys(unsigned count)
{
    struct aiVectorKey *keys = take(count, sizeof *keys);
    for (unsigned i = 0; i < count; i++) {
        keys[i].mTime = milliseconds();
        keys[i].mValue = *(struct aiVector3D *)words(3);
    }
    return keys;
}

static void *channel(void)
{
    struct aiNodeAnim *channel = take(1, sizeof *channel);
    channel->mNodeName = text();
    channel->mPositionKeys = vector_keys(channel->mNumPositionKeys = number());
    channel->mNumRotationKeys = number();
    channel->mRotationKeys = take(channel->mNumRotationKeys, sizeof *channel->mRotationKeys);
    for (unsigned i = 0; i < channel->mNumRotationKeys; i++) {
        struct aiQuatKey *key = &channel->mRotationKeys[i];
        key->mTime = milliseconds();
        const float *q = words(4);
        key->mValue = (struct aiQuaternion){.x = q[0], .y = q[1], .z = q[2], .w = q[3]};
    }
    channel->mScalingKeys = vector_keys(channel->mNumScalingKeys = number());
    return channel;
}

static void *morph_channel(void)
{
    struct aiMeshMorphAnim *channel = take(1, sizeof *channel);
    channel->mName = text();
    channel->mNumKeys = number();
    channel->mKeys = take(channel->mNumKeys, sizeof *channel->mKeys);
    const unsigned targets = number();
    for (unsigned i = 0; i < channel->mNumKeys; i++) {
        struct aiMeshMorphKey *key = &channel->mKeys[i];
        key->mTime = milliseconds();
        key->mNumValuesAndWeights = targets;
        key->mValues = take(targets, sizeof *key->mValues);
        key->mWeights = take(targets, sizeof *key->mWeights);
        for (unsigned j = 0; j < targets; j++) {
            const float weight = real();
            key->mValues[j] = j;
            key->mWeights[j] = (double)(0 > weight ? 0 : weight);
        }
    }
    return channel;
}

/* Of the first of `count`: nobody asks for the others. */
static struct aiAnimation **animations(unsigned count)
{
    struct aiAnimation **all = take(count, sizeof(void *)), *first = take(1, sizeof *first);
    if (count > 0) {
        all[0] = first;
        first->mTicksPerSecond = 1000;
        first->mChannels = list(&first->mNumChannels, channel);
        first->mMorphMeshChannels = list(&first->mNumMorphMeshChannels, morph_channel);
    }
    return all;
}

/* ---- The scene ---- */

static void *picture(void)
{
    struct aiTexture *picture = take(1, sizeof *picture);
    picture->mWidth = number(); /* bytes, where the height is 0 */
    picture->pcData = words(((size_t)picture->mWidth + 3) / 4);
    return picture;
}

const struct aiScene *aiImportFileExWithProperties(const char *path, unsigned steps,
                                                   struct aiFileIO *io,
                                                   const struct aiPropertyStore *properties)
{
    char name[1024];
    (void)steps, (void)io, (void)properties;
    (void)snprintf(name, sizeof name, "%s.words", path);
    char *first = web_file_content(name);
    if (first == NULL) {
        return NULL;
    }
    at = (uint32_t *)(void *)first;
    release();
    struct aiScene *scene = take(1, sizeof *scene);
    scene->mTextures = list(&scene->mNumTextures, picture);
    scene->mMaterials = list(&scene->mNumMaterials, material);
    scene->mMeshes = list(&scene->mNumMeshes, mesh);
    scene->mRootNode = node();
    scene->mAnimations = animations(scene->mNumAnimations = number());
    scene->mNumCameras = number();
    scene->mNumLights = number();
    return (const char *)at == first + web_file_length(name) ? scene : NULL;
}

const struct aiScene *aiImportFileFromMemoryWithProperties(const char *bytes, unsigned length,
                                                           unsigned steps, const char *format,
                                                           const struct aiPropertyStore *properties)
{
    (void)bytes, (void)length, (void)steps, (void)format, (void)properties;
    return NULL; /* a page has no standard input */
}

struct aiPropertyStore *aiCreatePropertyStore(void)
{
    return NULL;
}

void aiReleasePropertyStore(struct aiPropertyStore *properties)
{
    (void)properties;
}

const char *aiGetErrorString(void)
{
    return "only GLB can be read here";
}
