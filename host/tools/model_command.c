/* SPDX-License-Identifier: MIT */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "../assets/asset_header.h"
#include "../assets/asset_model.h"
#include "mesh_make.h"
#include "model_make.h"

static void report(const struct mesh_options *options, const struct asset *asset, FILE *out)
{
    mesh_report(options, asset, out);
    for (size_t i = 0; i < asset->texture_count; i++) {
        const struct texture *texture = &asset->textures[i];
        fprintf(out, "texture %zu: %d x %d, %s, %zu bytes\n", i, texture->width, texture->height,
                texture_format_names[texture->format], texture_flash_bytes(texture));
    }
    if (asset->node_count > 0) {
        fprintf(out, "motion: %zu nodes, %zu keys, %.2f seconds\n", asset->node_count - 1,
                asset->first_keys[asset->node_count + asset->track_count],
                asset->seconds / 65536.0);
    }
    for (size_t i = 0; i < asset->count; i++) {
        const struct asset_part *part = &asset->parts[i];
        if (part->target_count > 0) {
            fprintf(out, "morph targets: %zu of mesh %zu, %zu bytes\n", part->target_count, i,
                    part->target_count * part->mesh.vertex_count * sizeof *part->targets);
        }
    }
}

bool model_run(void *given, struct text_error *error)
{
    struct mesh_options *options = given;
    struct asset asset;
    if (!model_make(options, &asset, error)) {
        return false;
    }
    const bool ok = mesh_check_budget(options, &asset, error) &&
                    mesh_write_preview(options, &asset, error) &&
                    asset_header_save(&asset_header_model, &asset, options->name, options->output,
                                      options->split, error);
    if (ok && asset.blended_count > 0) {
        fprintf(stderr, "%s: left out: partial opacity of %zu picture%s\n", options->input,
                asset.blended_count, asset.blended_count == 1 ? "" : "s");
    }
    if (ok) {
        report(options, &asset, mesh_is_piped(options) ? stderr : stdout);
    }
    asset_free(&asset);
    return ok;
}
