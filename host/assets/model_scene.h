/* SPDX-License-Identifier: MIT */
/*
 * A model of what the library assimp has read.
 */
#ifndef QTRI_HOST_ASSETS_MODEL_SCENE_H
#define QTRI_HOST_ASSETS_MODEL_SCENE_H

#include "model.h"

#ifdef QTRI_HAVE_ASSIMP

#include <assimp/scene.h>

struct model_request {
    const char *path, *text, *format; /* text: of "-" */
    size_t length;
    enum model_content content;
    unsigned picture; /* the number that is wanted, of model_library_picture */
    struct text_error *error;
};

/* Sets the request's error; false. */
bool model_request_fail(const struct model_request *request, const char *problem, const char *what);

/* A material's picture: its name, which of the vertices' texture coordinates are its, and how it
   goes on beyond its edges; the library's type of it. */
struct model_picture_use {
    struct aiString name;
    unsigned channel;
    enum aiTextureMapMode mode[2];
    enum aiTextureType type;
};

/* False: the material has none; then the channel is 0. */
bool model_find_picture(const struct aiMaterial *material, struct model_picture_use *use);

/* Matrices that put each of the mesh's vertices where its joints are when nothing moves; d4 is 0
   for vertices that no joint has. free() them. NULL: no skin, one of other nodes, or no memory. */
struct aiMatrix4x4 *model_skin_at_rest(const struct aiScene *scene, const struct aiMesh *mesh);

/* Lists what the scene has and the model, whose nodes are there, has not. is_all: materials and
   motion are wanted. */
void model_list_left_out(const struct aiScene *scene, bool is_all, struct model *model);

/* Copies meshes, materials, pictures and motion. False with an error, where *model may hold
   something to be freed. */
bool model_copy_scene(const struct model_request *request, const struct aiScene *scene,
                      struct model *model);

#endif
#endif
