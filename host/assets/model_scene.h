/* SPDX-License-Identifier: MIT */
/*
 * A model of what the library assimp has read.
 */
#ifndef QTRI_HOST_ASSETS_MODEL_SCENE_H
#define QTRI_HOST_ASSETS_MODEL_SCENE_H

#include "model.h"

struct aiScene;

struct model_request {
    const char *path, *text, *format; /* text: of "-" */
    size_t length;
    enum model_content content;
    unsigned picture; /* the number that is wanted, of model_library_picture */
    struct text_error *error;
};

/* Sets the request's error; false. */
bool model_request_fail(const struct model_request *request, const char *problem, const char *what);

/* Copies meshes, materials, pictures and motion. False with an error, where *model may hold
   something to be freed. */
bool model_copy_scene(const struct model_request *request, const struct aiScene *scene,
                      struct model *model);

#endif
