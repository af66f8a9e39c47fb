/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "../assets/asset.h"
#include "../assets/asset_header.h"
#include "../io/file.h"
#include "mesh_faces.h"
#include "mesh_generate.h"
#include "mesh_make.h"
#include "mesh_options.h"

/* ---- Generated meshes ---- */

/* A mesh whose text is also the output, to the byte. */
static bool write_generated(const struct mesh_options *options, struct text_error *error)
{
    struct file_output output;
    if (!file_output_open(&output, options->output, error)) {
        return false;
    }
    (void)mesh_generate(options->input, output.stream);
    return file_output_commit(&output, error);
}

/* ---- The model ---- */

static bool make(struct mesh_options *options, struct asset *asset, struct text_error *error)
{
    struct model model;
    if (!mesh_read(options, options->plain ? MODEL_SHAPE : MODEL_MATERIALS, &model, error)) {
        return false;
    }
    const struct asset_options wanted = {
        .compact = options->compact,
        .colors = options->colors,
        .normals = options->normals != MODEL_NORMALS_NONE,
        .make_faces = options->no_faces ? NULL : mesh_faces_make,
        .keep_order = options->keep_order,
    };
    const bool ok = asset_make(options->input, &model, &wanted, asset, error);
    if (ok && model.has_colors && !options->colors) {
        fputs("the file's vertices have colours, which --colors would keep\n", stderr);
    }
    model_free(&model);
    return ok;
}

/* ---- Files ---- */

static bool write_obj(const struct mesh_options *options, const struct asset *asset,
                      struct text_error *error)
{
    struct file_output output;
    if (!file_output_open(&output, options->output, error)) {
        return false;
    }
    asset_write_obj(asset, false, output.stream);
    return file_output_commit(&output, error);
}

/* ---- What the user wants to know ---- */

static void report_materials(const char *input, const struct asset *asset, FILE *out)
{
    for (size_t i = 0; i < asset->count; i++) {
        const struct asset_part *part = &asset->parts[i];
        const uint8_t *c = part->material.color;
        if (asset->count > 1 || part->material.name[0] != '\0') {
            fprintf(out, "material %zu, %s: %" PRIu32 " triangles, colour %d %d %d\n", i,
                    part->material.name, part->mesh.triangle_count, c[0], c[1], c[2]);
        }
        if (part->material.texture[0] == '*') {
            fprintf(out, "texture: inside the file, for `qtri texture %s --picture %s`\n", input,
                    part->material.texture + 1);
        } else if (part->material.texture[0] != '\0') {
            fprintf(out, "texture: %s, for `qtri texture`\n", part->material.texture);
        }
    }
}

static bool write_output(const struct mesh_options *options, const struct asset *asset,
                         bool only_text, struct text_error *error)
{
    if (only_text) {
        return write_generated(options, error);
    }
    return options->is_obj ? write_obj(options, asset, error)
                           : asset_header_save(&asset_header_mesh, asset, options->name,
                                               options->output, options->split, error);
}

bool mesh_run(void *given, struct text_error *error)
{
    struct mesh_options *options = given;
    struct asset asset;
    const bool only_text = options->is_generated && options->is_obj && !options->is_changed;
    if (only_text && options->preview == NULL) {
        return write_generated(options, error);
    }
    if (!make(options, &asset, error)) {
        return false;
    }
    const bool ok = mesh_check_budget(options, &asset, error) &&
                    mesh_write_preview(options, &asset, error) &&
                    write_output(options, &asset, only_text, error);
    if (ok && !only_text) {
        FILE *out = mesh_is_piped(options) ? stderr : stdout;
        mesh_report(options, &asset, out);
        report_materials(options->input, &asset, out);
    }
    asset_free(&asset);
    return ok;
}
