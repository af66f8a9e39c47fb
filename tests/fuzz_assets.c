/* SPDX-License-Identifier: MIT */
/*
 * Fuzz target: models, materials and pictures of any content are read or refused with a message,
 * and what was read goes all the way to C. The first byte chooses what the rest is.
 */
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "assets/asset_header.h"
#include "assets/asset_model.h"
#include "assets/model.h"
#include "assets/texture.h"
#include "tools/mesh_faces.h"

/* Nothing is there, so that names in a model do not reach the machine's files. */
#define NAME "/nonexistent/fuzz"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(int condition)
{
    if (!condition) {
        abort();
    }
}

static void check_message(const struct text_error *error)
{
    require(memchr(error->message, '\0', sizeof error->message) != NULL);
    require(strncmp(error->message, "/nonexistent/", 13) == 0);
    require(strchr(error->message, '\n') == NULL);
}

static void check_asset(const struct asset *asset)
{
    for (size_t part = 0; part < asset->count; part++) {
        const qtri_mesh *mesh = &asset->parts[part].mesh;
        require(mesh->vertex_count > 0 && mesh->triangle_count > 0);
        for (uint32_t i = 0; i < 3 * mesh->triangle_count; i++) {
            uint32_t corner = mesh->triangles8 != NULL ? mesh->triangles8[i / 3][i % 3]
                                                       : mesh->triangles[i / 3][i % 3];
            require(corner < mesh->vertex_count);
        }
    }
}

static void write_nowhere(const struct asset *asset)
{
    static FILE *nowhere;
    if (nowhere == NULL) {
        nowhere = fopen("/dev/null", "w");
    }
    if (nowhere != NULL) {
        asset_header_write(&asset_header_mesh, asset, "x", "x.h", nowhere, NULL);
        asset_header_write(&asset_header_model, asset, "x", "x.h", nowhere, NULL);
        asset_write_obj(asset, false, nowhere);
    }
}

static void make_asset(struct model *model, uint8_t choice)
{
    struct asset asset;
    struct text_error error;
    const struct asset_options options = {choice % 2 == 1,       choice / 2 % 2 == 1,
                                          choice / 4 % 2 == 1,   mesh_faces_make,
                                          choice / 128 % 2 == 1, false};
    double distance;
    if (choice / 8 % 2 == 1) {
        model_center(model);
        model_fit(model, 2.0);
    }
    if (choice / 64 % 2 == 1) {
        model_simplify(model, model->triangle_count / 2, &distance);
    }
    model_make_normals(model, (enum model_normals)(choice / 16 % 4), 40.0);
    model_weld(model);
    require(!options.merged || model_merge_materials(model));
    if (asset_make(NAME, model, &options, &asset, &error)) {
        require(asset_add_motion(&asset, NAME, model, &error));
        check_asset(&asset);
        write_nowhere(&asset);
        asset_free(&asset);
    } else {
        check_message(&error);
    }
}

static void fuzz_obj(const char *text, size_t length, uint8_t choice)
{
    struct model model;
    struct text_error error;
    if (!model_parse_obj(NAME, text, length, true, &model, &error)) {
        check_message(&error);
        return;
    }
    if (!model_check(NAME, &model, &error)) {
        check_message(&error);
    } else {
        model_weld(&model);
        make_asset(&model, choice);
    }
    model_free(&model);
}

/* What is looked at before a library reads the file. */
static void fuzz_checks(const char *text, size_t length)
{
    struct model model = {0};
    struct text_error error;
    if (!model_check_ply(NAME, text, length, &model, &error)) {
        check_message(&error);
    }
    if (!model_check_gltf(NAME, text, length, &model, &error)) {
        check_message(&error);
    }
    require(strlen(model.left_out) < sizeof model.left_out);
}

static void fuzz_mtl(const char *text, size_t length)
{
    struct model model;
    struct text_error error;
    require(model_create(&model, 0, 0, 3));
    model.materials[1].name[0] = 'a';
    model.materials[2].name[0] = 'b';
    if (!model_parse_mtl(NAME, text, length, &model, &error)) {
        check_message(&error);
    }
    model_free(&model);
}

static void fuzz_picture(const char *bytes, size_t length, uint8_t choice)
{
    struct image image;
    struct texture texture;
    struct text_error error;
    struct texture_options options = {.format = (enum texture_format)(choice % 4),
                                      .dither = choice / 4 % 2 == 1,
                                      .has_key = choice / 8 % 2 == 1,
                                      .key = {255, 0, 255},
                                      .width = 16,
                                      .height = 8};
    if (!image_parse(NAME, bytes, length, &image, &error)) {
        check_message(&error);
        return;
    }
    if ((int64_t)image.width * image.height <= 65536) {
        require(texture_make(NAME, &image, &options, &texture, &error));
        texture_free(&texture);
    }
    image_free(&image);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size < 2) {
        return 0;
    }
    const char *text = (const char *)data + 2;
    switch (data[0] % 4) {
    case 0:
        fuzz_obj(text, size - 2, data[1]);
        break;
    case 1:
        fuzz_mtl(text, size - 2);
        break;
    case 2:
        fuzz_picture(text, size - 2, data[1]);
        break;
    default:
        fuzz_checks(text, size - 2);
        break;
    }
    return 0;
}
