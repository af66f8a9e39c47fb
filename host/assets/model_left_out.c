/* SPDX-License-Identifier: MIT */
/*
 * What a file has and the model has not, in words.
 */
#include "model_scene.h"

#ifdef QTRI_HAVE_ASSIMP

#include <assimp/material.h>
#include <string.h>

/* Counts of what no model has. */
struct left_out {
    size_t skins, targets, target_normals, flat, uvs, colors, opacities;
    size_t pictures, mirrored, emissive;
};

static bool is_opaque(const struct aiMaterial *material)
{
    struct aiString mode;
    return aiGetMaterialString(material, "$mat.gltf.alphaMode", 0, 0, &mode) == aiReturn_SUCCESS &&
           strcmp(mode.data, "OPAQUE") == 0;
}

static bool has_opacity(const struct aiMesh *mesh)
{
    bool found = false;
    for (unsigned i = 0; !found && mesh->mColors[0] != NULL && i < mesh->mNumVertices; i++) {
        found = mesh->mColors[0][i].a < 0.998f;
    }
    return found;
}

static void count_mesh(const struct aiScene *scene, const struct aiMesh *mesh,
                       struct left_out *count)
{
    count->skins += mesh->mNumBones > 0 ? 1 : 0;
    for (unsigned i = 0; i < mesh->mNumAnimMeshes; i++) {
        count->target_normals += mesh->mAnimMeshes[i]->mNormals != NULL ? 1 : 0;
    }
    count->targets += mesh->mNumAnimMeshes;
    count->flat += mesh->mPrimitiveTypes & (aiPrimitiveType_POINT | aiPrimitiveType_LINE) ? 1 : 0;
    for (unsigned i = 1; i < AI_MAX_NUMBER_OF_TEXTURECOORDS; i++) {
        count->uvs += mesh->mTextureCoords[i] != NULL ? 1 : 0;
        count->colors += mesh->mColors[i] != NULL ? 1 : 0;
    }
    count->opacities +=
        !is_opaque(scene->mMaterials[mesh->mMaterialIndex]) && has_opacity(mesh) ? 1 : 0;
}

static void count_material(const struct aiMaterial *material, struct left_out *count)
{
    static const enum aiTextureType types[] = {
        aiTextureType_NORMALS,      aiTextureType_HEIGHT,       aiTextureType_EMISSIVE,
        aiTextureType_SPECULAR,     aiTextureType_METALNESS,    aiTextureType_LIGHTMAP,
        aiTextureType_AMBIENT,      aiTextureType_OPACITY,      aiTextureType_SHININESS,
        aiTextureType_DISPLACEMENT, aiTextureType_REFLECTION,   aiTextureType_CLEARCOAT,
        aiTextureType_SHEEN,        aiTextureType_TRANSMISSION,
    };
    struct model_picture_use use;
    struct aiColor4D color = {0, 0, 0, 0};
    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++) {
        count->pictures += aiGetMaterialTextureCount(material, types[i]);
    }
    if (model_find_picture(material, &use)) {
        count->mirrored +=
            use.mode[0] == aiTextureMapMode_Mirror || use.mode[1] == aiTextureMapMode_Mirror;
    }
    if (aiGetMaterialColor(material, AI_MATKEY_COLOR_EMISSIVE, &color) == aiReturn_SUCCESS) {
        count->emissive += color.r > 0 || color.g > 0 || color.b > 0;
    }
}

/* Whether something of the model does as the animation says. */
static bool moves(const struct model *model)
{
    bool found = model->node_count > 0;
    for (size_t i = 0; !found && i < model->track_count; i++) {
        found = model->tracks[i].key_count > 1;
    }
    return found;
}

void model_list_left_out(const struct aiScene *scene, bool is_all, struct model *model)
{
    struct left_out count = {0};
    const unsigned moving = moves(model) ? 1 : 0;
    for (unsigned i = 0; i < scene->mNumMeshes; i++) {
        count_mesh(scene, scene->mMeshes[i], &count);
    }
    for (unsigned i = 0; i < scene->mNumMaterials; i++) {
        count_material(scene->mMaterials[i], &count);
    }
    model_leave_out(model, count.skins, "skin", "skins");
    model_leave_out(model, is_all ? 0 : count.targets, "morph target", "morph targets");
    model_leave_out(model, is_all ? count.target_normals : 0, "morph target's normals",
                    "morph targets' normals");
    model_leave_out(model, scene->mNumAnimations - moving,
                    moving > 0 ? "further animation" : "animation",
                    moving > 0 ? "further animations" : "animations");
    model_leave_out(model, count.flat, "mesh of points or lines", "meshes of points or lines");
    if (!is_all) {
        return;
    }
    model_leave_out(model, count.uvs, "further set of texture coordinates",
                    "further sets of texture coordinates");
    model_leave_out(model, count.colors, "further set of colours", "further sets of colours");
    model_leave_out(model, count.opacities, "mesh's opacity at vertices",
                    "meshes' opacity at vertices");
    model_leave_out(model, count.pictures, "picture of other things than colour",
                    "pictures of other things than colour");
    model_leave_out(model, count.mirrored, "picture's mirrored repeat",
                    "pictures' mirrored repeat");
    model_leave_out(model, count.emissive, "emissive colour", "emissive colours");
    model_leave_out(model, scene->mNumCameras, "camera", "cameras");
    model_leave_out(model, scene->mNumLights, "light", "lights");
}

#endif
