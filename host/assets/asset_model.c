/* SPDX-License-Identifier: MIT */
#include "asset_model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../io/file.h"
#include "../io/xalloc.h"

#define ONE 65536.0

/* ---- Textures ---- */

/* Where pictures have holes, this stands in the texture. */
static const uint8_t key_color[3] = {255, 0, 255};

static bool read_picture(const char *path, const struct model *model, const char *name,
                         struct image *image, struct text_error *error)
{
    if (name[0] != '*') {
        return image_read(name, image, error);
    }
    const size_t number = (size_t)strtoul(name + 1, NULL, 10);
    char inside[600];
    if (number >= model->picture_count) {
        return text_error_set(error, path, 0, "has not the picture that its materials name");
    }
    (void)snprintf(inside, sizeof inside, "%.500s: picture %zu inside", path, number);
    return image_parse(inside, model->pictures[number].bytes, model->pictures[number].length, image,
                       error);
}

/* What the file wants nothing of is not to weigh colours either. */
static void drop_alpha(const struct image *image)
{
    const size_t count = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < count; i++) {
        image->rgba[4 * i + 3] = 255;
    }
}

static bool has_holes(const struct image *image)
{
    const size_t count = (size_t)image->width * (size_t)image->height;
    size_t i = 0;
    while (i < count && image->rgba[4 * i + 3] >= 128) {
        i++;
    }
    return i < count;
}

/* Whether more than one pixel in a hundred is neither opaque nor away. */
static bool is_partly_seen_through(const struct image *image)
{
    const size_t count = (size_t)image->width * (size_t)image->height;
    size_t partly = 0;
    for (size_t i = 0; i < count; i++) {
        const uint8_t alpha = image->rgba[4 * i + 3];
        partly += alpha >= 16 && alpha < 240 ? 1 : 0;
    }
    return partly > count / 100;
}

/* Powers of two in the picture's proportion, both at most what is asked for. */
static void set_size(const struct image *image, const struct texture_options *most,
                     struct texture_options *options)
{
    options->width = texture_nearest_side(image->width);
    options->height = texture_nearest_side(image->height);
    while (options->width > most->width || options->height > most->height) {
        options->width = options->width > 1 ? options->width / 2 : 1;
        options->height = options->height > 1 ? options->height / 2 : 1;
    }
}

static bool add_texture(struct asset *asset, const char *path, const struct model *model,
                        const struct model_material *material, const struct texture_options *most,
                        struct text_error *error)
{
    struct image image;
    struct texture_options options = *most;
    if (!read_picture(path, model, material->texture, &image, error)) {
        return false;
    }
    if (!material->has_holes) {
        drop_alpha(&image);
    }
    set_size(&image, most, &options);
    options.has_key = material->has_holes && has_holes(&image);
    memcpy(options.key, key_color, sizeof options.key);
    asset->blended_count += material->is_blended && is_partly_seen_through(&image) ? 1 : 0;
    bool ok = texture_make(path, &image, &options, &asset->textures[asset->texture_count], error);
    asset->texture_count += ok ? 1 : 0;
    image_free(&image);
    return ok;
}

/* The part before this one whose texture is the same, or this one. */
static size_t first_alike(const struct asset *asset, size_t part)
{
    const struct model_material *wanted = &asset->parts[part].material;
    for (size_t i = 0; i < part; i++) {
        const struct model_material *material = &asset->parts[i].material;
        if (strcmp(material->texture, wanted->texture) == 0 &&
            material->has_holes == wanted->has_holes && material->clamp_u == wanted->clamp_u &&
            material->clamp_v == wanted->clamp_v) {
            return i;
        }
    }
    return part;
}

bool asset_add_textures(struct asset *asset, const char *path, const struct model *model,
                        const struct texture_options *most, struct text_error *error)
{
    bool ok = true;
    asset->textures = xcalloc(asset->count, sizeof *asset->textures);
    for (size_t i = 0; ok && i < asset->count; i++) {
        struct asset_part *part = &asset->parts[i];
        const size_t alike = first_alike(asset, i);
        if (part->material.texture[0] == '\0') {
            continue;
        }
        if (alike < i) {
            part->texture = asset->parts[alike].texture;
            continue;
        }
        ok = add_texture(asset, path, model, &part->material, most, error);
        if (ok) {
            part->texture = (int)asset->texture_count - 1;
            asset->textures[part->texture].clamp_u = part->material.clamp_u;
            asset->textures[part->texture].clamp_v = part->material.clamp_v;
        }
    }
    return ok;
}

/* ---- Motion ---- */

static bool is_q16(const double *values, int count)
{
    bool fits = true;
    for (int i = 0; i < count; i++) {
        fits = fits && fabs(values[i]) <= 32767.0;
    }
    return fits;
}

static q16 q16_of(double value)
{
    return (q16)lround(value * ONE);
}

static bool copy_key(const struct model_key *from, qtri_key *to)
{
    const double *p = from->position, *q = from->orientation, *s = from->scale;
    if (!is_q16(&from->time, 1) || !is_q16(p, 3) || !is_q16(q, 4) || !is_q16(s, 3)) {
        return false;
    }
    const qtri_key key = {q16_of(from->time),
                          {q16_of(p[0]), q16_of(p[1]), q16_of(p[2])},
                          {q16_of(q[0]), q16_of(q[1]), q16_of(q[2]), q16_of(q[3])},
                          {q16_of(s[0]), q16_of(s[1]), q16_of(s[2])}};
    *to = key;
    return true;
}

/* Appends the keys of the next node or track; false where one does not fit. */
static bool copy_keys(struct asset *asset, const struct model *model, const struct model_node *node,
                      size_t at)
{
    bool ok = true;
    size_t count = asset->first_keys[at];
    for (size_t i = 0; ok && i < node->key_count; i++) {
        qtri_key *key = &asset->keys[count++];
        ok = copy_key(&model->keys[node->first_key + i], key);
        asset->seconds = key->time > asset->seconds ? key->time : asset->seconds;
    }
    asset->first_keys[at + 1] = count;
    return ok;
}

static bool copy_nodes(struct asset *asset, const struct model *model)
{
    bool ok = true;
    asset->node_count = model->node_count + 1;
    asset->track_count = model->track_count;
    asset->parents[0] = -1;
    for (size_t i = 0; ok && i < model->node_count; i++) {
        asset->parents[i + 1] = (int16_t)model->nodes[i].parent;
        ok = copy_keys(asset, model, &model->nodes[i], i + 1);
    }
    for (size_t i = 0; ok && i < model->track_count; i++) {
        ok = copy_keys(asset, model, &model->tracks[i], asset->node_count + i);
    }
    return ok;
}

/* The greatest distance of a vertex from a place, at one time. */
static double reach(const struct model *model, double time, const double from[3],
                    double (*world)[3][4], double *weights)
{
    double most = 0.0;
    model_pose(model, time, world);
    model_weights(model, time, weights);
    for (size_t i = 0; i < model->vertex_count; i++) {
        struct model_vertex vertex = model->vertices[i];
        double at[3], sum = 0.0;
        model_shape_at(model, weights, &model->vertices[i], vertex.position);
        model_vertex_at((const double(*)[4])world[vertex.node], &vertex, at);
        for (int axis = 0; axis < 3; axis++) {
            sum += (at[axis] - from[axis]) * (at[axis] - from[axis]);
        }
        most = fmax(most, sum);
    }
    return sqrt(most);
}

/* A sphere about the middle of the box, over the whole animation in so many steps. */
static void set_bounds(struct asset *asset, const struct model *model)
{
    enum { STEPS = 32 };
    const struct model_box box = model_bounds(model);
    const int steps = asset->seconds > 0 ? STEPS : 0;
    double middle[3], most = 0.0;
    double(*world)[3][4] = xcalloc(model->node_count + 1, sizeof *world);
    double *weights = xcalloc(model->track_count * MODEL_TRACK_WEIGHTS, sizeof *weights);
    for (int axis = 0; axis < 3; axis++) {
        middle[axis] = (box.low[axis] + box.high[axis]) / 2.0;
    }
    for (int i = 0; i <= steps; i++) {
        const double time = asset->seconds / ONE * i / STEPS;
        most = fmax(most, reach(model, time, middle, world, weights));
    }
    free(world);
    free(weights);
    asset->center.x = q16_of(middle[0]);
    asset->center.y = q16_of(middle[1]);
    asset->center.z = q16_of(middle[2]);
    asset->radius = (q16)ceil(fmin(most * ONE, 2147483647.0));
}

bool asset_add_motion(struct asset *asset, const char *path, const struct model *model,
                      struct text_error *error)
{
    if (model->node_count > INT16_MAX - 1) {
        return text_error_set(error, path, 0, "more than 32766 parts that move");
    }
    if (model->node_count + model->track_count > 0) {
        asset->keys = xcalloc(model->key_count, sizeof *asset->keys);
        asset->first_keys =
            xcalloc(model->node_count + model->track_count + 2, sizeof *asset->first_keys);
        asset->parents = xcalloc(model->node_count + 1, sizeof *asset->parents);
        if (!copy_nodes(asset, model)) {
            return text_error_set(error, path, 0,
                                  "moves beyond 32767, Q16.16's end; --fit makes it smaller");
        }
    }
    set_bounds(asset, model);
    return true;
}

void asset_pose(const struct asset *asset, const qtri_transform *pose, q16 time,
                qtri_transform *poses)
{
    poses[0] = *pose;
    for (size_t i = 1; i < asset->node_count; i++) {
        const size_t first = asset->first_keys[i];
        const qtri_key key =
            qtri_keys_at(&asset->keys[first], (int32_t)(asset->first_keys[i + 1] - first), time);
        qtri_transform_identity(&poses[i]);
        qtri_transform_key(&poses[i], &key);
    }
    if (asset->node_count > 0) {
        qtri_poses_compose(poses, poses, asset->parents, (int32_t)asset->node_count);
    }
}

void asset_weights(const struct asset *asset, q16 time, q16 *weights)
{
    for (size_t i = 0; i < asset->track_count; i++) {
        const size_t *first = &asset->first_keys[asset->node_count + i];
        const qtri_key key =
            qtri_keys_at(&asset->keys[first[0]], (int32_t)(first[1] - first[0]), time);
        weights[MODEL_TRACK_WEIGHTS * i] = key.position.x;
        weights[MODEL_TRACK_WEIGHTS * i + 1] = key.position.y;
        weights[MODEL_TRACK_WEIGHTS * i + 2] = key.position.z;
    }
}

void asset_shape(const struct asset_part *part, const q16 *weights, qtri_position16 *out)
{
    const qtri_position16 **targets = xcalloc(part->target_count, sizeof(void *));
    for (size_t i = 0; i < part->target_count; i++) {
        targets[i] = &part->targets[i * part->mesh.vertex_count];
    }
    qtri_morph_targets(out, part->mesh.positions16, targets, &weights[part->first_weight],
                       (int32_t)part->target_count, part->mesh.vertex_count);
    free(targets);
}

/* ---- Materials ---- */

qtri_material asset_material(const struct asset_part *part)
{
    qtri_material material = qtri_material_default();
    material.color.r = part->material.color[0];
    material.color.g = part->material.color[1];
    material.color.b = part->material.color[2];
    if (part->material.two_sided) {
        material.cull = QTRI_CULL_NONE;
    }
    if (part->material.opacity < 255) {
        material.blend = &qtri_blend_alpha;
        material.alpha = part->material.opacity;
        material.depth_read_only = true;
    }
    return material;
}
