/* SPDX-License-Identifier: MIT */
#include "model_make.h"

#include <stdio.h>
#include <string.h>

#include "../assets/asset_model.h"
#include "mesh_faces.h"
#include "mesh_make.h"

/* Materials that name no picture have the one of --texture. */
static bool set_skin(const struct mesh_options *options, struct model *model,
                     struct text_error *error)
{
    if (options->skin == NULL) {
        return true;
    }
    if (strlen(options->skin) >= sizeof model->materials[0].texture) {
        return text_error_set(error, options->skin, 0, "the name of the picture is too long");
    }
    if (!model->has_uvs) {
        return text_error_set(error, options->input, 0,
                              "has no texture coordinates, without which --texture cannot be seen");
    }
    for (size_t i = 0; i < model->material_count; i++) {
        struct model_material *material = &model->materials[i];
        if (material->texture[0] == '\0') {
            (void)snprintf(material->texture, sizeof material->texture, "%s", options->skin);
        }
    }
    return true;
}

static bool make(const struct mesh_options *options, struct model *model, struct asset *asset,
                 struct text_error *error)
{
    const struct asset_options wanted = {
        .compact = options->compact,
        .merged = true,
        .normals = options->normals != MODEL_NORMALS_NONE,
        .make_faces = options->no_faces ? NULL : mesh_faces_make,
        .keep_order = options->keep_order,
    };
    const char *path = options->input;
    if (!options->compact && model->morph_count > 0) {
        fprintf(stderr, "%s: left out: morph targets, which --wide meshes cannot have\n", path);
        model_drop_morphs(model);
    }
    if (!set_skin(options, model, error)) {
        return false;
    }
    if (!model_merge_materials(model)) {
        return text_error_set(error, path, 0, "too many materials and moving parts");
    }
    if (!asset_make(path, model, &wanted, asset, error)) {
        return false;
    }
    if (!asset_add_textures(asset, path, model, &options->most, error) ||
        !asset_add_motion(asset, path, model, error)) {
        asset_free(asset);
        return false;
    }
    return true;
}

bool model_make(struct mesh_options *options, struct asset *asset, struct text_error *error)
{
    struct model model;
    if (!mesh_read(options, options->plain ? MODEL_SHAPE : MODEL_ALL, &model, error)) {
        return false;
    }
    const bool ok = make(options, &model, asset, error);
    model_free(&model);
    return ok;
}
