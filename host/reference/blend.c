/* SPDX-License-Identifier: MIT */
#include "blend.h"

#include <math.h>

bool ref_is_blended(const struct scene *scene)
{
    return scene->blend != SCENE_BLEND_OFF || scene->fog.kind != SCENE_FOG_OFF || scene->keep[0] ||
           scene->keep[1] || scene->keep[2];
}

bool ref_passes_door(const struct scene *scene, double opaque, int x, int y)
{
    /* Ordered dithering: bits of x ^ y and y, the lowest first, make the rank. */
    const unsigned a = (unsigned)(x ^ y), b = (unsigned)y;
    const unsigned rank = (a & 1) << 3 | (b & 1) << 2 | (a & 2) | (b & 2) >> 1;
    if (scene->blend != SCENE_BLEND_SCREENDOOR)
        return true;
    const double material = floor(scene->alpha / 65536.0 * 255 + .5);
    return floor(material * opaque + .5) > 16 * rank + 8;
}

double ref_vertex_alpha(const struct scene *scene, const struct scene_op *op, size_t i)
{
    const bool counts = scene->blend == SCENE_BLEND_ALPHA || scene->blend == SCENE_BLEND_ADD;
    return counts && op->by_vertex && !scene->wireframe ? op->vertex_alpha[i % 3] / 65536.0 : 1;
}

double ref_kept(const struct scene *scene, double opaque)
{
    switch (scene->blend) {
    case SCENE_BLEND_ALPHA:
        return 1 - scene->alpha / 65536.0 * opaque;
    case SCENE_BLEND_ADD:
    case SCENE_BLEND_MULTIPLY:
    case SCENE_BLEND_NONE:
        return 1;
    default:
        return 0;
    }
}

/* How much of a colour is left at a distance. */
static double clear_share(const struct scene_fog *fog, double z)
{
    const double a = fog->number[0] / 65536.0;
    const double b = fog->number[1] / 65536.0;
    switch (fog->kind) {
    case SCENE_FOG_LINEAR:
        if (b <= a)
            return z <= a ? 1 : 0;
        return fmin(1, fmax(0, (b - z) / (b - a)));
    case SCENE_FOG_EXP:
        return exp(-fmax(0, a) * z);
    case SCENE_FOG_EXP2:
        return exp(-pow(fmax(0, a) * z, 2));
    default:
        return 1;
    }
}

static double fogged(const struct scene_fog *fog, int channel, double color, double depth)
{
    const double near_z = fog->range[0] / 65536.0;
    const double far_z = fog->range[1] / 65536.0;
    /* depth = far (z - near) / (z (far - near)), solved for z */
    const double z = far_z * near_z / (far_z - depth * (far_z - near_z));
    const double share = clear_share(fog, z);
    return color * share + 255 * (fog->color[channel] / 65536.0) * (1 - share);
}

double ref_blend(const struct scene *scene, int channel, double color, double opaque, double under,
                 double depth)
{
    const double alpha = scene->alpha / 65536.0 * opaque;
    if (scene->keep[channel] && scene->blend != SCENE_BLEND_SCREENDOOR)
        return under;
    if (scene->fog.kind != SCENE_FOG_OFF)
        color = fogged(&scene->fog, channel, color, depth);
    switch (scene->blend) {
    case SCENE_BLEND_ALPHA:
        return color * alpha + under * (1 - alpha);
    case SCENE_BLEND_ADD:
        return fmin(255, under + color * alpha);
    case SCENE_BLEND_MULTIPLY:
        return color * under / 255;
    case SCENE_BLEND_NONE:
        return under;
    default:
        return color;
    }
}
