/* SPDX-License-Identifier: MIT */
#include "target.h"
#include "blend.h"
#include "light.h"
#include "matrix.h"
#include "texture.h"

#include <math.h>
#include <stdlib.h>

static double clamp(double v, double low, double high)
{
    return v < low ? low : v > high ? high : v;
}

static bool allocate(struct reference_image *image, int width, int height)
{
    size_t pixels = (size_t)width * (size_t)height;
    struct reference_image fresh = {
        .width = width,
        .height = height,
        .color = malloc(pixels * 3 * sizeof(double)),
        .color_min = malloc(pixels * 3 * sizeof(double)),
        .color_max = malloc(pixels * 3 * sizeof(double)),
        .depth = malloc(pixels * sizeof(double)),
        .rounding = malloc(pixels * sizeof(double)),
        .edge = calloc(pixels, sizeof(double)),
        .either = calloc(pixels, sizeof(double)),
        .other_depth = malloc(pixels * sizeof(double)),
        .footprint = calloc(pixels, sizeof(double)),
        .id = calloc(pixels, sizeof(uint32_t)),
        .hits = calloc(pixels, sizeof(uint32_t)),
    };
    *image = fresh;
    if (image->color && image->color_min && image->color_max && image->depth && image->rounding &&
        image->edge && image->either && image->other_depth && image->footprint && image->id &&
        image->hits)
        return true;
    reference_free(image);
    return false;
}

void reference_free(struct reference_image *image)
{
    free(image->color);
    free(image->color_min);
    free(image->color_max);
    free(image->depth);
    free(image->rounding);
    free(image->edge);
    free(image->either);
    free(image->other_depth);
    free(image->footprint);
    free(image->id);
    free(image->hits);
    *image = (struct reference_image){0};
}

bool ref_target_open(struct ref_target *target, const struct scene *scene, int subpixel_bits,
                     struct reference_image *image)
{
    if (!allocate(image, scene->width, scene->height))
        return false;
    target->scene = scene;
    target->image = image;
    target->subpixel_bits = subpixel_bits;
    target->at = (struct ref_sampling){.scale = 1.0};
    target->window = (struct ref_window){0, 0, scene->width, scene->height};
    target->depth_only = false;
    ref_target_bias(target, 0);
    target->depth_slope = 0;
    target->decision = REF_DRAWN;

    size_t pixels = (size_t)scene->width * (size_t)scene->height;
    double clear_depth = ref_unit_from_q16(scene->clear_depth);
    for (size_t i = 0; i < pixels; i++) {
        image->depth[i] = clear_depth;
        image->other_depth[i] = clear_depth;
        image->rounding[i] = 1;
        for (size_t c = 0; c < 3; c++) {
            double value = 255.0 * ref_unit_from_q16(scene->clear[c]);
            image->color[3 * i + c] = value;
            image->color_min[3 * i + c] = value;
            image->color_max[3 * i + c] = value;
        }
    }
    return true;
}

void ref_target_mixed(struct ref_target *target, size_t i, double kept, double edge)
{
    struct reference_image *image = target->image;
    kept = clamp(kept, 0.0, 1.0); /* less, by a rounding of weights */
    image->rounding[i] = 1 + kept * image->rounding[i];
    image->edge[i] = edge + kept * image->edge[i];
    image->either[i] *= kept;
}

void ref_target_bias(struct ref_target *target, int32_t bias)
{
    const double by = bias / 65536.0;
    target->depth_near = clamp(ref_unit_from_q16(target->scene->depth_near) + by, 0.0, 1.0);
    target->depth_far = clamp(ref_unit_from_q16(target->scene->depth_far) + by, 0.0, 1.0);
}

double ref_target_shift(const struct ref_target *target, double right, double down, double nearest,
                        double farthest)
{
    const double by = target->depth_slope * fmax(fabs(right), fabs(down));
    return clamp(by, -nearest, 1 - farthest);
}

double ref_target_depth(const struct ref_target *target, long double z_over_w)
{
    /* Rounding may carry z/w of a point on the near or far plane a hair past it. */
    double unit = clamp((double)((z_over_w + 1) / 2), 0.0, 1.0);
    return target->depth_near + unit * (target->depth_far - target->depth_near);
}

/* What float16 keeps of 1 - depth: 12 bits behind the highest, from 2^17 of 2^32 on. */
static double float_units(double depth)
{
    double rest = (1.0 - depth) * 65535.0 * 65536.0;
    int exponent = 17;
    frexp(rest, &exponent);
    int down = exponent > 18 ? exponent - 13 : 5;
    return 65535.0 - ((down - 5) * 4096.0 + floor(ldexp(rest, -down)));
}

/* The depth buffer's units: comparisons are made between stored values, because `equal` and
   `lequal` have their meaning only there. The picture keeps the depth before this rounding. */
static double depth_units(const struct scene *scene, double depth)
{
    switch (scene->depth_format) {
    case SCENE_FLOAT16:
        return float_units(depth);
    case SCENE_LINEAR24:
        return floor(depth * 65535.0 * 256.0 + 0.5);
    case SCENE_LINEAR32:
        return floor(depth * 65535.0 * 65536.0 + 0.5);
    default:
        return floor(depth * 65535.0 + 0.5);
    }
}

static bool passes(enum scene_compare compare, double incoming, double stored)
{
    switch (compare) {
    case SCENE_LESS:
        return incoming < stored;
    case SCENE_LEQUAL:
        return incoming <= stored;
    case SCENE_GREATER:
        return incoming > stored;
    case SCENE_GEQUAL:
        return incoming >= stored;
    case SCENE_ALWAYS:
        return true;
    case SCENE_EQUAL:
        return incoming == stored;
    case SCENE_NOTEQUAL:
        return incoming != stored;
    case SCENE_NEVER:
        break;
    }
    return false;
}

enum ref_decision ref_target_decide(const struct ref_target *target, size_t i, double depth)
{
    const struct scene *scene = target->scene;
    const double stored[2] = {target->image->depth[i], target->image->other_depth[i]};

    if (!scene->depth_test)
        return REF_DRAWN;
    const bool drawn =
        passes(scene->depth_compare, depth_units(scene, depth), depth_units(scene, stored[0]));
    for (int k = 0; k < 2; k++)
        for (int off = -1; off <= 1; off++)
            if (passes(scene->depth_compare, depth_units(scene, depth + off / 65535.0),
                       depth_units(scene, stored[k])) != drawn)
                return drawn ? REF_EITHER_DRAWN : REF_EITHER_NOT;
    return drawn ? REF_DRAWN : REF_NOT_DRAWN;
}

void ref_target_either(struct ref_target *target, size_t i, double most)
{
    target->image->either[i] += most;
}

void ref_target_write_depth(struct ref_target *target, size_t i, double depth)
{
    struct reference_image *image = target->image;

    if (target->decision == REF_EITHER_NOT) {
        image->other_depth[i] = depth;
        return;
    }
    image->other_depth[i] = target->decision == REF_EITHER_DRAWN ? image->depth[i] : depth;
    image->depth[i] = depth;
}

bool ref_target_cover(struct ref_target *target, int x, int y, double depth)
{
    const struct scene *scene = target->scene;
    const struct ref_window *window = &target->window;
    size_t i = (size_t)y * (size_t)scene->width + (size_t)x;

    if (x < window->x || x - window->x >= window->width || y < window->y ||
        y - window->y >= window->height)
        return false;
    target->image->hits[i]++;
    target->decision = ref_target_decide(target, i, depth);
    return target->decision != REF_NOT_DRAWN;
}

void ref_target_shade(struct ref_target *target, int x, int y, double depth,
                      const struct ref_triangle *triangle, const double attribute[REF_ATTRIBUTES],
                      double footprint)
{
    const struct scene *scene = target->scene;
    const struct ref_vertex *vertex = triangle->vertex;
    struct reference_image *image = target->image;
    size_t i = (size_t)y * (size_t)scene->width + (size_t)x;
    double texel[4] = {255.0, 255.0, 255.0, 255.0};

    if (triangle->textured &&
        !ref_texture_at(scene, attribute[REF_U], attribute[REF_V], footprint, texel))
        return;
    if (!ref_passes_door(scene, texel[3] / 255.0, x, y))
        return;
    if (scene->depth_test && (scene->depth_write || target->depth_only))
        ref_target_write_depth(target, i, depth);
    if (target->depth_only)
        return;
    double lit[3] = {attribute[0], attribute[1], attribute[2]};
    if (triangle->by_pixel != NULL)
        ref_pixel_color(triangle->by_pixel, attribute, lit);
    const double opaque = texel[3] / 255.0 * clamp(attribute[REF_ALPHA], 0.0, 1.0);
    const bool blended = ref_is_blended(scene);
    double color[3], least[3], greatest[3], most = 0;
    for (size_t c = 0; c < 3; c++) {
        double a = vertex[0].attribute[c];
        double b = vertex[1].attribute[c];
        double d = vertex[2].attribute[c];
        least[c] = triangle->by_pixel != NULL ? 0 : fmin(a, fmin(b, d));
        greatest[c] = triangle->by_pixel != NULL ? 255 : fmax(a, fmax(b, d));
        color[c] = clamp(lit[c], least[c], greatest[c]);
        if (triangle->textured && scene->texture_mode == SCENE_REPLACE)
            color[c] = texel[c];
        else if (triangle->textured)
            color[c] = color[c] * texel[c] / 255.0;
        if (blended) {
            color[c] = ref_blend(scene, (int)c, color[c], opaque, image->color[3 * i + c], depth);
            least[c] = 0;
            greatest[c] = 255;
        }
        most = fmax(most, fabs(color[c] - image->color[3 * i + c]));
    }
    if (target->decision == REF_EITHER_NOT) {
        ref_target_either(target, i, most);
        return;
    }
    for (size_t c = 0; c < 3; c++) {
        image->color[3 * i + c] = color[c];
        image->color_min[3 * i + c] = least[c];
        image->color_max[3 * i + c] = greatest[c];
    }
    image->id[i] = triangle->id;
    ref_target_mixed(target, i, ref_kept(scene, opaque), 0);
    if (target->decision == REF_EITHER_DRAWN)
        ref_target_either(target, i, most);
    image->footprint[i] = footprint;
}

void ref_interpolate(const struct ref_vertex *const vertex[3], double weight1, double weight2,
                     double attribute[REF_ATTRIBUTES])
{
    for (int k = 0; k < REF_ATTRIBUTES; k++) {
        double base = vertex[0]->attribute[k];
        attribute[k] = base + weight1 * (vertex[1]->attribute[k] - base) +
                       weight2 * (vertex[2]->attribute[k] - base);
    }
}
