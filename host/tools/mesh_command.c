/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../assets/asset.h"
#include "../assets/image.h"
#include "../io/file.h"
#include "commands.h"
#include "mesh_faces.h"
#include "mesh_generate.h"
#include "mesh_options.h"

enum { PREVIEW_WIDTH = 480, PREVIEW_HEIGHT = 360 };

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

static bool read_generated(const char *name, struct model *model, struct text_error *error)
{
    char *text = NULL;
    size_t length = 0;
    FILE *stream = open_memstream(&text, &length);
    bool ok = stream != NULL;
    if (ok) {
        (void)mesh_generate(name, stream);
        ok = fclose(stream) == 0;
    }
    if (!ok) {
        text_error_set(error, name, 0, "out of memory");
    } else {
        ok = model_parse_obj(name, text, length, false, model, error) &&
             model_check(name, model, error) && model_weld(model);
    }
    free(text);
    return ok;
}

/* ---- The model ---- */

static bool has_normals(const struct model *model)
{
    for (size_t i = 0; i < model->vertex_count; i++) {
        const double *n = model->vertices[i].normal;
        if (n[0] != 0.0 || n[1] != 0.0 || n[2] != 0.0) {
            return true;
        }
    }
    return false;
}

static void drop_normals(struct model *model)
{
    for (size_t i = 0; i < model->vertex_count; i++) {
        memset(model->vertices[i].normal, 0, sizeof model->vertices[i].normal);
    }
}

/* Normals that are made anew must not keep vertices apart that are to be simplified together. */
static bool simplify(const struct mesh_options *options, struct model *model)
{
    double distance = 0.0;
    size_t before = model->triangle_count;
    if (options->simplify == 0 || (size_t)options->simplify >= before) {
        return true;
    }
    if (!model_simplify(model, (size_t)options->simplify, &distance)) {
        return false;
    }
    fprintf(stderr, "simplified from %zu to %zu triangles, within %.2g %% of the model's size\n",
            before, model->triangle_count, 100.0 * distance);
    if (model->triangle_count > (size_t)options->simplify) {
        fputs("its edges, seams and normals allow no fewer; --normals smooth 180 or --plain may\n",
              stderr);
    }
    return true;
}

static bool shape(const struct mesh_options *options, struct model *model)
{
    if (options->normals != MODEL_NORMALS_KEEP) {
        drop_normals(model);
        if (!model_weld(model)) {
            return false;
        }
    }
    model_turn_up(model, options->up);
    if (options->center) {
        model_center(model);
    }
    if (options->fit > 0.0) {
        model_fit(model, options->fit);
    }
    if (options->scale > 0.0) {
        model_scale(model, options->scale);
    }
    return simplify(options, model) &&
           model_make_normals(model, options->normals, options->smooth_degrees) &&
           model_weld(model);
}

/* Of a generated mesh without normals, which is lit face by face, `keep` keeps that. */
static void settle_normals(struct mesh_options *options, const struct model *model)
{
    if (options->is_generated && options->normals == MODEL_NORMALS_KEEP && !has_normals(model)) {
        options->normals = MODEL_NORMALS_NONE;
    }
}

static bool make(struct mesh_options *options, struct asset *asset, struct text_error *error)
{
    struct model model;
    bool ok = options->is_generated ? read_generated(options->input, &model, error)
                                    : model_read(options->input, !options->plain, &model, error);
    if (!ok) {
        return false;
    }
    settle_normals(options, &model);
    ok = shape(options, &model);
    if (!ok) {
        text_error_set(error, options->input, 0, "out of memory");
    } else {
        const struct asset_options wanted = {
            .compact = options->compact,
            .colors = options->colors,
            .normals = options->normals != MODEL_NORMALS_NONE,
            .make_faces = options->no_faces ? NULL : mesh_faces_make,
        };
        ok = asset_make(options->input, &model, &wanted, asset, error);
    }
    if (ok && model.has_colors && !options->colors) {
        fputs("the file's vertices have colours, which --colors would keep\n", stderr);
    }
    model_free(&model);
    return ok;
}

/* ---- Files ---- */

static bool write_c(const struct mesh_options *options, const struct asset *asset,
                    struct text_error *error)
{
    struct asset_files files;
    if (!asset_files_open(&files, options->output, options->split, error)) {
        return false;
    }
    asset_write_c(asset, options->name, files.header_name, files.header.stream,
                  files.source.stream);
    return asset_files_commit(&files, error);
}

static bool write_obj(const struct mesh_options *options, const struct asset *asset,
                      struct text_error *error)
{
    struct file_output output;
    if (!file_output_open(&output, options->output, error)) {
        return false;
    }
    asset_write_obj(asset, output.stream);
    return file_output_commit(&output, error);
}

static bool write_preview(const struct mesh_options *options, const struct asset *asset,
                          struct text_error *error)
{
    struct picture picture;
    size_t drawn = 0;
    if (options->preview == NULL) {
        return true;
    }
    if (!asset_preview(asset, PREVIEW_WIDTH, PREVIEW_HEIGHT, &picture, &drawn)) {
        text_error_set(error, options->preview, 0, "out of memory");
        return false;
    }
    if (drawn == 0) {
        fprintf(stderr, "qtri mesh: %s: nothing of the mesh is seen in the picture\n",
                options->preview);
    }
    bool ok = image_write_picture(options->preview, &picture, error);
    picture_free(&picture);
    return ok;
}

/* ---- What the user wants to know ---- */

static void report_materials(const char *input, const struct asset *asset, FILE *out)
{
    for (size_t i = 0; i < asset->count; i++) {
        const struct asset_part *part = &asset->parts[i];
        const uint8_t *c = part->material.color;
        if (asset->count > 1) {
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

static void report(const struct mesh_options *options, const struct asset *asset, FILE *out)
{
    int rows = options->rows < options->panel_height ? options->rows : options->panel_height;
    const struct asset_error *error = &asset->error;
    struct asset_memory ram = asset_ram(asset, options->panel_width, options->panel_height, rows);
    fprintf(out, "%s: %" PRIu32 " vertices, %" PRIu32 " triangles", options->name,
            asset_vertex_count(asset), asset_triangle_count(asset));
    fprintf(out, asset->count > 1 ? ", %zu meshes\n" : "\n", asset->count);
    fprintf(out, "flash: %zu bytes\n", asset_flash_bytes(asset));
    fprintf(out,
            "RAM: %zu bytes for %dx%d in bands of %d rows: %zu band, %zu line, %zu vertices, %zu "
            "lists\n",
            ram.bands + ram.line + ram.vertices + ram.lists, options->panel_width,
            options->panel_height, rows, ram.bands, ram.line, ram.vertices, ram.lists);
    fprintf(out, "greatest error: position %.3g (%.2g %% of the size)", error->position,
            100.0 * error->position_share);
    if (options->normals != MODEL_NORMALS_NONE) {
        fprintf(out, ", normal %.2g degrees", error->normal_degrees);
    }
    if (asset->parts[0].mesh.uvs != NULL || asset->parts[0].mesh.uvs16 != NULL) {
        fprintf(out, ", texture coordinate %.2g", error->uv);
    }
    fputc('\n', out);
    if (error->position_share > 1.0 / 256.0) {
        fputs("the model is so small that its shape suffers; --fit or --scale makes it larger\n",
              stderr);
    }
    report_materials(options->input, asset, out);
}

/* What was made goes to standard output: the report goes elsewhere. */
static bool is_piped(const struct mesh_options *options)
{
    return strcmp(options->output, "-") == 0 ||
           (options->preview != NULL && strcmp(options->preview, "-") == 0);
}

static int run(struct mesh_options *options)
{
    struct text_error error;
    struct asset asset;
    bool only_text = options->is_generated && options->is_obj && !options->is_changed;
    bool ok = true;
    if (!only_text || options->preview != NULL) {
        ok = make(options, &asset, &error);
        if (ok) {
            ok = write_preview(options, &asset, &error) &&
                 (only_text ? write_generated(options, &error)
                            : (options->is_obj ? write_obj(options, &asset, &error)
                                               : write_c(options, &asset, &error)));
            if (ok && !only_text) {
                report(options, &asset, is_piped(options) ? stderr : stdout);
            }
            asset_free(&asset);
        }
    } else {
        ok = write_generated(options, &error);
    }
    if (!ok) {
        fprintf(stderr, "qtri mesh: %s\n", error.message);
    }
    return ok ? 0 : 1;
}

int mesh_main(int argc, char **argv)
{
    struct mesh_options options;
    if (options_ask_help(argc, argv)) {
        mesh_options_help(stdout);
        return 0;
    }
    return mesh_options_parse(argc, argv, &options) ? run(&options) : 2;
}
