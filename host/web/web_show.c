/* SPDX-License-Identifier: MIT */
/* What a header of `qtri model` holds, as files of a scene: each part a mesh, each texture a
 * picture. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "../assets/asset_model.h"
#include "../io/file.h"
#include "../io/xalloc.h"
#include "../tools/commands.h"
#include "../tools/model_make.h"
#include "web.h"

static bool write_part(const struct asset *asset, size_t i, const q16 *weights)
{
    struct file_output output;
    struct text_error error;
    struct asset_part part = asset->parts[i];
    struct asset one = {.parts = &part, .count = 1};
    qtri_position16 *positions = NULL;
    char path[40];
    (void)snprintf(path, sizeof path, "shown_%zu.obj", i);
    if (part.target_count > 0) {
        positions = xcalloc(part.mesh.vertex_count, sizeof *positions);
        asset_shape(&part, weights, positions);
        part.mesh.positions16 = positions;
    }
    const bool ok = file_output_open(&output, path, &error);
    if (ok) {
        asset_write_obj(&one, false, output.stream);
    }
    free(positions);
    return ok && file_output_commit(&output, &error);
}

static bool write_texture(const struct texture *texture, size_t i)
{
    struct picture picture;
    struct text_error error;
    char path[40];
    (void)snprintf(path, sizeof path, "shown_%zu.ppm", i);
    if (!texture_picture(texture, &picture)) {
        return false;
    }
    const bool ok = picture_write_ppm(path, &picture, &error);
    picture_free(&picture);
    return ok;
}

/* A line of numbers: its texture or -1, whether that has a key, ends at its edges, whether both
   sides are seen and whether it has normals, opacity and colour of 255, and the matrix that places
   it, column by column. */
static void print_part(const struct asset *asset, size_t i, const qtri_transform *pose)
{
    const struct asset_part *part = &asset->parts[i];
    const struct texture *texture = part->texture >= 0 ? &asset->textures[part->texture] : NULL;
    printf("%d %d %d %d %d %d %d %d %d %d", part->texture, texture != NULL && texture->has_key,
           texture != NULL && texture->clamp_u, texture != NULL && texture->clamp_v,
           part->material.two_sided, part->mesh.normals != NULL || part->mesh.normals8 != NULL,
           part->material.opacity, part->material.color[0], part->material.color[1],
           part->material.color[2]);
    for (int column = 0; column < 4; column++) {
        for (int k = 0; k < 4; k++) {
            const qtri_row *row = &pose->row[k];
            printf(" %.9g", column < 3 ? ldexp(row->m[column], -row->exponent)
                                       : ldexp((double)row->t, -row->exponent - 16));
        }
    }
    putchar('\n');
}

static bool show(const struct asset *asset)
{
    qtri_transform whole;
    qtri_transform *poses = xcalloc(asset->node_count + 1, sizeof *poses);
    q16 *weights = xcalloc(asset->track_count, 3 * sizeof *weights);
    bool ok = true;
    qtri_transform_identity(&whole);
    asset_pose(asset, &whole, 0, poses);
    asset_weights(asset, 0, weights);
    for (size_t i = 0; ok && i < asset->count; i++) {
        ok = write_part(asset, i, weights);
        print_part(asset, i, &poses[asset->node_count > 0 ? asset->parts[i].material.node : 0]);
    }
    for (size_t i = 0; ok && i < asset->texture_count; i++) {
        ok = write_texture(&asset->textures[i], i);
    }
    free(poses);
    free(weights);
    return ok;
}

static bool run(void *given, struct text_error *error)
{
    struct asset asset;
    bool ok = model_make(given, &asset, error);
    if (ok) {
        ok = show(&asset);
        asset_free(&asset);
    }
    (void)fflush(stdout);
    return ok;
}

int web_show(int argc, char **argv)
{
    struct option_command command = model_command;
    command.run = run;
    return options_run(&command, argc, argv);
}
