/* SPDX-License-Identifier: MIT */
#include "mesh_make.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "../assets/image.h"
#include "../io/system.h"
#include "mesh_generate.h"

enum { PREVIEW_WIDTH = 480, PREVIEW_HEIGHT = 360 };

static void write_generated(FILE *out, const char *name)
{
    (void)mesh_generate(name, out);
}

static bool read_generated(const char *name, struct model *model, struct text_error *error)
{
    size_t length = 0;
    char *text = system_collect(write_generated, name, &length);
    bool ok = text != NULL;
    if (!ok) {
        text_error_set(error, name, 0, "out of memory");
    } else {
        ok = model_parse_obj(name, text, length, false, model, error) &&
             model_check(name, model, error);
    }
    if (ok) {
        model_weld(model);
    }
    free(text);
    return ok;
}

/* ---- Its shape ---- */

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
static void simplify(const struct mesh_options *options, struct model *model)
{
    double distance = 0.0;
    size_t before = model->triangle_count;
    if (options->simplify == 0 || (size_t)options->simplify >= before) {
        return;
    }
    model_simplify(model, (size_t)options->simplify, &distance);
    fprintf(stderr, "simplified from %zu to %zu triangles, within %.2g %% of the model's size\n",
            before, model->triangle_count, 100.0 * distance);
    if (model->triangle_count > (size_t)options->simplify) {
        fputs("its edges, seams and normals allow no fewer; --normals smooth 180 or --plain may\n",
              stderr);
    }
}

static void shape(const struct mesh_options *options, struct model *model)
{
    if (options->normals != MODEL_NORMALS_KEEP) {
        drop_normals(model);
        model_weld(model);
    }
    model_turn_up(model, options->up == 0 ? 'y' : 'z');
    if (options->center) {
        model_center(model);
    }
    if (options->fit > 0.0) {
        model_fit(model, options->fit);
    }
    if (options->scale > 0.0) {
        model_scale(model, options->scale);
    }
    simplify(options, model);
    model_make_normals(model, options->normals, options->smooth_degrees);
    model_weld(model);
}

/* Of a generated mesh without normals, which is lit face by face, `keep` keeps that. */
static void settle_normals(struct mesh_options *options, const struct model *model)
{
    if (options->is_generated && options->normals == MODEL_NORMALS_KEEP && !has_normals(model)) {
        options->normals = MODEL_NORMALS_NONE;
    }
}

bool mesh_read(struct mesh_options *options, enum model_content content, struct model *model,
               struct text_error *error)
{
    bool ok = options->is_generated ? read_generated(options->input, model, error)
                                    : model_read(options->input, content, model, error);
    if (!ok) {
        return false;
    }
    if (model->left_out[0] != '\0') {
        fprintf(stderr, "%s: left out: %s\n", options->input, model->left_out);
    }
    settle_normals(options, model);
    shape(options, model);
    return true;
}

/* ---- Budgets ---- */

static bool check_bytes(const struct mesh_options *options, const char *what, size_t needed,
                        size_t most, const char *advice, struct text_error *error)
{
    if (most == 0 || needed <= most) {
        return true;
    }
    return text_error_set(error, options->input, 0,
                          "needs %zu bytes of %s, %zu more than --%s allows; %s", needed, what,
                          needed - most, strcmp(what, "RAM") == 0 ? "ram" : what, advice);
}

bool mesh_check_budget(const struct mesh_options *options, const struct asset *asset,
                       struct text_error *error)
{
    const struct asset_memory ram =
        asset_ram(asset, options->panel_width, options->panel_height, options->rows);
    return check_bytes(options, "flash", asset_flash_bytes(asset), options->most_flash,
                       asset->texture_count > 0
                           ? "--simplify, --texture-side and --format palette make it smaller"
                           : "--compact and --simplify make it smaller",
                       error) &&
           check_bytes(options, "RAM", ram.bands + ram.line + ram.vertices + ram.lists,
                       options->most_ram, "--simplify and fewer --rows make it smaller", error);
}

/* ---- What the user sees ---- */

bool mesh_write_preview(const struct mesh_options *options, const struct asset *asset,
                        struct text_error *error)
{
    struct picture picture;
    size_t drawn = 0;
    if (options->preview == NULL) {
        return true;
    }
    if (!asset_preview(asset, PREVIEW_WIDTH, PREVIEW_HEIGHT, &picture, &drawn)) {
        return text_error_set(error, options->preview, 0, "out of memory");
    }
    if (drawn == 0) {
        fprintf(stderr,
                "qtri: %s: nothing of the mesh is seen in the picture: its faces look away\n",
                options->preview);
    }
    bool ok = image_write_picture(options->preview, &picture, error);
    picture_free(&picture);
    return ok;
}

void mesh_report(const struct mesh_options *options, const struct asset *asset, FILE *out)
{
    const struct asset_error *error = &asset->error;
    if (asset->flat_triangles > 0) {
        fprintf(stderr, "%s: left out: %zu triangle%s too small to be stored\n", options->input,
                asset->flat_triangles, asset->flat_triangles == 1 ? "" : "s");
    }
    struct asset_memory ram =
        asset_ram(asset, options->panel_width, options->panel_height, options->rows);
    fprintf(out, "%s: %" PRIu32 " vertices, %" PRIu32 " triangles", options->name,
            asset_vertex_count(asset), asset_triangle_count(asset));
    fprintf(out, asset->count > 1 ? ", %zu meshes\n" : "\n", asset->count);
    fprintf(out, "flash: %zu bytes\n", asset_flash_bytes(asset));
    fprintf(out,
            "RAM: %zu bytes for %dx%d in bands of %d rows: %zu band, %zu line, %zu vertices, %zu "
            "lists\n",
            ram.bands + ram.line + ram.vertices + ram.lists, options->panel_width,
            options->panel_height, options->rows, ram.bands, ram.line, ram.vertices, ram.lists);
    fprintf(out, "greatest error: position %.3g (%.2g %% of the size)", error->position,
            100.0 * error->position_share);
    if (options->normals != MODEL_NORMALS_NONE) {
        fprintf(out, ", normal %.2g degrees", error->normal_degrees);
    }
    if (asset->error.uv > 0.0 || asset->parts[0].mesh.uvs != NULL ||
        asset->parts[0].mesh.uvs16 != NULL) {
        fprintf(out, ", texture coordinate %.2g", error->uv);
    }
    fputc('\n', out);
    if (error->position_share > 1.0 / 256.0) {
        fputs("the model is so small that its shape suffers; --fit or --scale makes it larger\n",
              stderr);
    }
}

/* What was made goes to standard output: the report goes elsewhere. */
bool mesh_is_piped(const struct mesh_options *options)
{
    return strcmp(options->output, "-") == 0 ||
           (options->preview != NULL && strcmp(options->preview, "-") == 0);
}
