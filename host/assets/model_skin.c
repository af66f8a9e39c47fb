/* SPDX-License-Identifier: MIT */
/*
 * Skins at rest: where the joints of a skin put the vertices of its mesh, whatever node shows it.
 */
#include "model_scene.h"

#ifdef QTRI_HAVE_ASSIMP

#include <assimp/cimport.h>
#include <stdlib.h>
#include <string.h>

static const struct aiNode *find_node(const struct aiNode *node, const char *name)
{
    const struct aiNode *found = strcmp(node->mName.data, name) == 0 ? node : NULL;
    for (unsigned i = 0; found == NULL && i < node->mNumChildren; i++) {
        found = find_node(node->mChildren[i], name);
    }
    return found;
}

static void add_weight(struct aiMatrix4x4 *sum, const struct aiMatrix4x4 *joint, ai_real weight)
{
    ai_real *to = &sum->a1;
    const ai_real *from = &joint->a1;
    for (int i = 0; i < 16; i++) {
        to[i] += weight * from[i];
    }
}

static bool add_joint(const struct aiScene *scene, const struct aiMesh *mesh,
                      const struct aiBone *bone, struct aiMatrix4x4 *matrices)
{
    const struct aiNode *node = find_node(scene->mRootNode, bone->mName.data);
    struct aiMatrix4x4 joint = bone->mOffsetMatrix;
    if (node == NULL) {
        return false;
    }
    for (; node != NULL; node = node->mParent) {
        struct aiMatrix4x4 product = node->mTransformation;
        aiMultiplyMatrix4(&product, &joint);
        joint = product;
    }
    for (unsigned i = 0; i < bone->mNumWeights; i++) {
        const struct aiVertexWeight *weight = &bone->mWeights[i];
        if (weight->mVertexId < mesh->mNumVertices) {
            add_weight(&matrices[weight->mVertexId], &joint, weight->mWeight);
        }
    }
    return true;
}

struct aiMatrix4x4 *model_skin_at_rest(const struct aiScene *scene, const struct aiMesh *mesh)
{
    struct aiMatrix4x4 *matrices =
        mesh->mNumBones > 0 ? calloc(mesh->mNumVertices + (size_t)1, sizeof *matrices) : NULL;
    bool ok = matrices != NULL;
    for (unsigned i = 0; ok && i < mesh->mNumBones; i++) {
        ok = add_joint(scene, mesh, mesh->mBones[i], matrices);
    }
    for (unsigned i = 0; ok && i < mesh->mNumVertices; i++) { /* weights whose sum is not 1 */
        const ai_real sum = matrices[i].d4;
        ai_real *numbers = &matrices[i].a1;
        for (int j = 0; sum > 0 && j < 16; j++) {
            numbers[j] /= sum;
        }
    }
    if (!ok) {
        free(matrices);
        return NULL;
    }
    return matrices;
}

#endif
