/* SPDX-License-Identifier: MIT */
#include "asset_model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../io/mipmap.h"
#include "../io/xalloc.h"

#define ONE 65536.0

static q16 q16_of(double value)
{
    return (q16)lround(fmin(fmax(value * ONE, -2147483647.0), 2147483647.0));
}

/* A model's sphere, or that around the box of all parts, in units of Q16.16. */
static double find_sphere(const struct asset *asset, double middle[3])
{
    double low[3] = {INFINITY, INFINITY, INFINITY};
    double high[3] = {-INFINITY, -INFINITY, -INFINITY};
    double sum = 0.0;
    if (asset->radius > 0) {
        middle[0] = asset->center.x;
        middle[1] = asset->center.y;
        middle[2] = asset->center.z;
        return asset->radius;
    }
    for (size_t i = 0; i < asset->count; i++) {
        const qtri_box *box = &asset->parts[i].mesh.bounds;
        const double center[3] = {box->center.x, box->center.y, box->center.z};
        const double half[3] = {box->half.x, box->half.y, box->half.z};
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = fmin(low[axis], center[axis] - half[axis]);
            high[axis] = fmax(high[axis], center[axis] + half[axis]);
        }
    }
    for (int axis = 0; axis < 3; axis++) {
        middle[axis] = (low[axis] + high[axis]) / 2.0;
        sum += (high[axis] - low[axis]) * (high[axis] - low[axis]) / 4.0;
    }
    return sqrt(sum);
}

/* Scales by any factor up to 2^30, in two steps that Q16.16 holds with 8 digits. */
static void scale(qtri_transform *transform, double factor)
{
    const q16 step = q16_of(sqrt(factor));
    const q16 rest = q16_of(factor / (step / ONE));
    const qtri_vec3 first = {step, step, step}, second = {rest, rest, rest};
    qtri_transform_scale(transform, first);
    qtri_transform_scale(transform, second);
}

/* The sphere becomes that of radius 1 about the origin, seen from above and from the side. */
static void set_pose(const struct asset *asset, qtri_transform *pose)
{
    double middle[3];
    const double radius = fmax(find_sphere(asset, middle), 1.0);
    const qtri_vec3 back = {(q16)-middle[0], (q16)-middle[1], (q16)-middle[2]};
    qtri_transform_identity(pose);
    qtri_transform_rotate_x(pose, Q16(25));
    qtri_transform_rotate_y(pose, Q16(-35));
    scale(pose, ONE / radius);
    qtri_transform_translate(pose, back);
}

/* ---- Textures ---- */

/* Texels as the core reads them; those of the key are not drawn. */
struct skins {
    qtri_texture *textures;
    uint32_t **texels;
};

static void free_skins(const struct asset *asset, struct skins *skins)
{
    for (size_t i = 0; i < asset->texture_count; i++) {
        free(skins->texels[i]);
    }
    free(skins->texels);
    free(skins->textures);
}

static bool make_skin(const struct texture *texture, qtri_texture *skin, uint32_t **texels)
{
    struct picture picture;
    const size_t count = (size_t)texture->width * (size_t)texture->height;
    *texels = xcalloc(count, sizeof **texels);
    if (!texture_picture(texture, &picture)) {
        return false;
    }
    memset(skin, 0, sizeof *skin);
    for (size_t i = 0; i < count; i++) {
        const uint8_t *c = &picture.rgb[3 * i];
        (*texels)[i] = (uint32_t)c[0] << 16 | (uint32_t)c[1] << 8 | c[2];
        if (texture->has_key && texture->texels[i] == texture->key) {
            skin->has_key = true;
            skin->key = (*texels)[i];
        }
    }
    picture_free(&picture);
    skin->texels = *texels;
    skin->format = &qtri_texel_xrgb8888;
    skin->width_log2 = mipmap_log2(texture->width);
    skin->height_log2 = mipmap_log2(texture->height);
    skin->wrap_u = texture->clamp_u ? QTRI_CLAMP : QTRI_REPEAT;
    skin->wrap_v = texture->clamp_v ? QTRI_CLAMP : QTRI_REPEAT;
    return true;
}

static bool make_skins(const struct asset *asset, struct skins *skins)
{
    skins->textures = xcalloc(asset->texture_count, sizeof *skins->textures);
    skins->texels = xcalloc(asset->texture_count, sizeof *skins->texels);
    bool ok = true;
    for (size_t i = 0; ok && i < asset->texture_count; i++) {
        ok = make_skin(&asset->textures[i], &skins->textures[i], &skins->texels[i]);
    }
    return ok;
}

/* ---- The picture ---- */

/* Weights of targets, and room for the positions of a part that they shape. */
struct shape {
    q16 *weights;
    qtri_position16 *positions;
};

static void draw(const struct asset *asset, const struct skins *skins, const struct shape *shape,
                 qtri_transform *poses, const qtri_surface *surface, const qtri_view *view)
{
    qtri_transform pose;
    const qtri_rgb sky = {24, 32, 48};
    set_pose(asset, &pose);
    asset_pose(asset, &pose, 0, poses);
    qtri_surface_clear(surface, sky);
    for (size_t i = 0; i < asset->count; i++) {
        const struct asset_part *part = &asset->parts[i];
        qtri_material material = asset_material(part);
        if (asset->texture_count > 0 && part->texture >= 0) {
            material.texture = &skins->textures[part->texture];
        }
        const size_t node = asset->node_count > 0 ? part->material.node : 0;
        qtri_mesh mesh = part->mesh;
        if (part->target_count > 0) {
            asset_shape(part, shape->weights, shape->positions);
            mesh.positions16 = shape->positions;
        }
        qtri_draw_mesh(surface, view, &poses[node], &mesh, &material);
    }
}

static void copy_pixels(const qtri_surface *surface, struct picture *picture, size_t *drawn)
{
    *drawn = 0;
    for (int32_t y = 0; y < surface->height; y++) {
        for (int32_t x = 0; x < surface->width; x++) {
            uint8_t *pixel = &picture->rgb[3 * ((size_t)y * (size_t)surface->width + (size_t)x)];
            const qtri_rgb color = qtri_surface_pixel(surface, x, y);
            pixel[0] = color.r;
            pixel[1] = color.g;
            pixel[2] = color.b;
            /* What is seen through leaves depth alone; the first pixel is background. */
            *drawn += surface->depth[y * surface->depth_pitch + x] != UINT16_MAX ||
                      memcmp(pixel, picture->rgb, 3) != 0;
        }
    }
}

bool asset_preview(const struct asset *asset, int width, int height, struct picture *picture,
                   size_t *drawn)
{
    const qtri_light light = {
        .towards = {Q16(0.4), Q16(0.6), Q16(0.7)}, .ambient = Q16(0.25), .diffuse = Q16(0.75)};
    const size_t bytes = QTRI_BAND_BYTES(width, height, 4);
    const qtri_vec3 eye = {0, 0, Q16(3)}, center = {0, 0, 0}, up = {0, Q16(1), 0};
    uint32_t most = 0;
    for (size_t i = 0; i < asset->count; i++) {
        uint32_t count = asset->parts[i].mesh.vertex_count;
        most = count > most ? count : most;
    }
    void *memory = xcalloc(bytes, 1);
    qtri_vertex *vertices = xcalloc(most, sizeof *vertices);
    qtri_transform *poses = xcalloc(asset->node_count + 1, sizeof *poses);
    struct shape shape = {xcalloc(asset->track_count, 3 * sizeof(q16)),
                          xcalloc(most, sizeof(qtri_position16))};
    struct skins skins;
    qtri_surface surface;
    bool ok = make_skins(asset, &skins) &&
              qtri_surface_init(&surface, &qtri_xrgb8888, width, height, 0, height, memory,
                                bytes) == QTRI_OK &&
              picture_create(picture, width, height, false);
    if (ok) {
        qtri_view view;
        qtri_view_init(&view, width, height);
        qtri_transform_look_at(&view.camera, eye, center, up);
        qtri_transform_perspective(&view.projection, Q16(40), q16_from_ratio(width, height),
                                   Q16(0.5), Q16(10));
        view.light = &light;
        view.vertices = vertices;
        view.vertex_count = most;
        asset_weights(asset, 0, shape.weights);
        draw(asset, &skins, &shape, poses, &surface, &view);
        copy_pixels(&surface, picture, drawn);
    }
    free_skins(asset, &skins);
    free(shape.weights);
    free(shape.positions);
    free(poses);
    free(memory);
    free(vertices);
    return ok;
}
