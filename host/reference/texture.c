/* SPDX-License-Identifier: MIT */
#include "texture.h"

#include <math.h>
#include <string.h>

/* The texels that are looked at: the whole texture, or one of its levels. */
struct sheet {
    const struct scene *scene;
    const uint8_t *rgb;
    const uint8_t *alpha; /* NULL: opaque */
    int width, height;
};

/* The nearest of `steps` + 1 evenly spaced levels. */
static double level(double value, double steps)
{
    return floor(value * steps / 255.0 + 0.5) * 255.0 / steps;
}

/* An 8-bit colour as the scene's texel format can hold it. A palette can hold any. */
static void store(enum scene_texel_format format, const uint8_t rgb[3], double stored[3])
{
    double gray = (299.0 * rgb[0] + 587.0 * rgb[1] + 114.0 * rgb[2]) / 1000.0;

    for (int c = 0; c < 3; c++) {
        switch (format) {
        case SCENE_TEXEL_RGB565:
        case SCENE_TEXEL_PALETTE565:
            stored[c] = level(rgb[c], c == 1 ? 63.0 : 31.0);
            break;
        case SCENE_TEXEL_ARGB4444:
            stored[c] = level(rgb[c], 15.0);
            break;
        case SCENE_TEXEL_ARGB1555:
            stored[c] = level(rgb[c], 31.0);
            break;
        case SCENE_TEXEL_ALPHA8:
            stored[c] = 255.0;
            break;
        case SCENE_TEXEL_GRAY8:
            stored[c] = floor(gray + 0.5);
            break;
        case SCENE_TEXEL_XRGB8888:
        case SCENE_TEXEL_PALETTE:
        case SCENE_TEXEL_ARGB8888:
            stored[c] = rgb[c];
            break;
        }
    }
}

static double store_alpha(enum scene_texel_format format, uint8_t alpha)
{
    if (format == SCENE_TEXEL_ARGB4444)
        return level(alpha, 15.0);
    return format == SCENE_TEXEL_ARGB1555 ? level(alpha, 1.0) : alpha;
}

/* Texel number `texel` of a side that repeats or ends at its last texels. 0 for NaN. */
static size_t wrap(double texel, int size, bool clamp)
{
    double wrapped = clamp ? fmin(texel, size - 1.0) : texel - size * floor(texel / size);
    return wrapped > 0.0 && wrapped < size ? (size_t)wrapped : 0;
}

/* The texel in `column` and `row`, counted from (u, v) = 0, and its alpha. False: it has the key's
   colour. */
static bool texel_at(const struct sheet *sheet, double column, double row, double color[4])
{
    const struct scene *scene = sheet->scene;
    size_t x = wrap(column, sheet->width, scene->texture_clamp[0]);
    size_t y = wrap(row, sheet->height, scene->texture_clamp[1]);
    const uint8_t *rgb = &sheet->rgb[3 * (y * (size_t)sheet->width + x)];
    double key[3];

    store(scene->texel_format, rgb, color);
    color[3] = 255.0;
    if (sheet->alpha != NULL)
        color[3] = store_alpha(scene->texel_format, sheet->alpha[y * (size_t)sheet->width + x]);
    if (!scene->texture_keyed)
        return true;
    if (scene->texel_format == SCENE_TEXEL_PALETTE565) /* entries are compared, not their colours */
        return memcmp(rgb, scene->texture_key, 3) != 0;
    store(scene->texel_format, scene->texture_key, key);
    return color[0] != key[0] || color[1] != key[1] || color[2] != key[2];
}

/* Whether anything looks at alpha: if not, colours are mixed as if there were none. */
static bool counts_alpha(const struct sheet *sheet)
{
    const struct scene *scene = sheet->scene;
    return sheet->alpha != NULL && (scene->blend != SCENE_BLEND_OFF || scene->least_alpha > 0 ||
                                    scene->keep[0] || scene->keep[1] || scene->keep[2]);
}

/* column and row: of the point among texel centres. What is not seen lends no colour. */
static void bilinear(const struct sheet *sheet, double column, double row, const double nearest[4],
                     double color[4])
{
    bool weighted = counts_alpha(sheet);
    double sum = 0.0;
    double along = column - floor(column);
    double across = row - floor(row);

    color[0] = color[1] = color[2] = color[3] = 0.0;
    for (int i = 0; i < 4; i++) {
        int right = i % 2;
        int below = i / 2;
        double weight = (right ? along : 1.0 - along) * (below ? across : 1.0 - across);
        double texel[4];
        const double *shown =
            texel_at(sheet, floor(column) + right, floor(row) + below, texel) ? texel : nearest;
        double share = weighted ? weight * shown[3] / 255.0 : weight;
        for (int c = 0; c < 3; c++)
            color[c] += share * shown[c];
        color[3] += weight * shown[3];
        sum += share;
    }
    for (int c = 0; c < 3 && weighted && sum > 0.0; c++)
        color[c] /= sum;
}

/* Halved as often as makes a texel nearest to the footprint, in proportion; while there are levels
   and their width is two texels or more. */
static struct sheet sheet_of(const struct scene *scene, double footprint)
{
    const struct scene_texture *texture = &scene->texture;
    struct sheet sheet = {scene, texture->rgb, texture->alpha, texture->width, texture->height};
    double most = sqrt(2.0);

    if (!scene->texture_mipmapped)
        return sheet;
    for (int i = 0; i < texture->level_count && footprint >= most; i++) {
        sheet.rgb = texture->level[i];
        sheet.alpha = texture->alpha != NULL ? texture->level_alpha[i] : NULL;
        sheet.width /= 2;
        sheet.height = sheet.height > 1 ? sheet.height / 2 : 1;
        most *= 2.0;
    }
    return sheet;
}

bool ref_texture_at(const struct scene *scene, double u, double v, double footprint,
                    double color[4])
{
    struct sheet sheet = sheet_of(scene, footprint);
    double column = u * sheet.width;
    double row = v * sheet.height;
    double nearest[4];

    if (!texel_at(&sheet, floor(column), floor(row), nearest))
        return false;
    if (scene->texture_bilinear && isfinite(column) && isfinite(row)) {
        bilinear(&sheet, column - 0.5, row - 0.5, nearest, color);
    } else {
        for (int c = 0; c < 4; c++)
            color[c] = nearest[c];
    }
    /* Alpha has 8 bits before it is compared. */
    return floor(color[3] + 0.5) >= scene->least_alpha;
}

/* Of a mean with weights the derivative: sum w' (f - mean) / sum w. */
static double derivative(const struct ref_vertex *const vertex[3], int attribute,
                         const double weight[3], const double slope[3])
{
    double sum = weight[0] + weight[1] + weight[2];
    double mean = 0.0, change = 0.0;

    for (int i = 0; i < 3; i++)
        mean += weight[i] / sum * vertex[i]->attribute[attribute];
    for (int i = 0; i < 3; i++)
        change += slope[i] / sum * (vertex[i]->attribute[attribute] - mean);
    return change;
}

static double step_length(const struct scene *scene, const struct ref_vertex *const vertex[3],
                          const double weight[3], const double slope[3])
{
    double u = fabs(derivative(vertex, REF_U, weight, slope)) * scene->texture.width;
    double v = fabs(derivative(vertex, REF_V, weight, slope)) * scene->texture.height;
    return fmax(u, v) + 0.375 * fmin(u, v);
}

double ref_footprint(const struct scene *scene, const struct ref_vertex *const vertex[3],
                     const double weight[3], const double right[3], const double down[3])
{
    if (!scene->texture_mipmapped)
        return 0.0;
    return fmax(step_length(scene, vertex, weight, right),
                step_length(scene, vertex, weight, down));
}
