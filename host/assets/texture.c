/* SPDX-License-Identifier: MIT */
#include "texture.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../io/mipmap.h"
#include "../io/xalloc.h"

const char *const texture_format_names[TEXTURE_FORMATS] = {"rgb565", "palette", "gray8", "xrgb8888",
                                                           "palette565"};

static bool has_palette(const struct texture *texture)
{
    return texture->format == TEXTURE_PALETTE || texture->format == TEXTURE_PALETTE565;
}

void texture_free(struct texture *texture)
{
    free(texture->texels);
    memset(texture, 0, sizeof *texture);
}

/* ---- Colours and stored texels ---- */

static uint32_t level(int value, int steps)
{
    return (uint32_t)((value * steps + 127) / 255);
}

uint32_t texture_rgb565(const int color[3])
{
    return level(color[0], 31) << 11 | level(color[1], 63) << 5 | level(color[2], 31);
}

/* As the core widens it to 8 bits a channel. */
static void from_rgb565(uint32_t texel, int color[3])
{
    int r = (int)(texel >> 11), g = (int)(texel >> 5 & 63), b = (int)(texel & 31);
    color[0] = r << 3 | r >> 2;
    color[1] = g << 2 | g >> 4;
    color[2] = b << 3 | b >> 2;
}

static uint32_t encode(const struct texture *texture, const int color[3])
{
    switch (texture->format) {
    case TEXTURE_RGB565:
        return texture_rgb565(color);
    case TEXTURE_GRAY8:
        return (uint32_t)(299 * color[0] + 587 * color[1] + 114 * color[2] + 500) / 1000;
    case TEXTURE_PALETTE:
    case TEXTURE_PALETTE565:
        return (uint32_t)texture_nearest_color(texture->palette, texture->has_key ? 1 : 0,
                                               texture->palette_count, color);
    default:
        return (uint32_t)color[0] << 16 | (uint32_t)color[1] << 8 | (uint32_t)color[2];
    }
}

static void decode(const struct texture *texture, uint32_t texel, int color[3])
{
    if (texture->format == TEXTURE_RGB565) {
        from_rgb565(texel, color);
        return;
    }
    for (int c = 0; c < 3; c++) {
        color[c] = texture->format == TEXTURE_GRAY8 ? (int)texel
                   : has_palette(texture)           ? texture->palette[texel][c]
                                                    : (int)(texel >> (16 - 8 * c) & 255);
    }
}

/* A texel that is to be seen must not be the key's: the nearest other one. */
static uint32_t keep_off_key(const struct texture *texture, uint32_t texel)
{
    if (!texture->has_key || texel != texture->key || has_palette(texture)) {
        return texel;
    }
    uint32_t step = texture->format == TEXTURE_RGB565 ? 1U << 5 : 1U;
    return texel ^ step; /* one step of green, gray or blue up or down */
}

/* ---- Dithering ---- */

/* Error diffusion (Floyd and Steinberg 1976): errors of this row's pixels to come and the next's,
   in sixteenths. */
struct diffusion {
    int (*row)[3], (*next)[3]; /* width + 2 each, the first is left of the picture */
};

static void diffuse(struct diffusion *diffusion, int x, const int error[3])
{
    for (int c = 0; c < 3; c++) {
        diffusion->row[x + 2][c] += 7 * error[c];
        diffusion->next[x][c] += 3 * error[c];
        diffusion->next[x + 1][c] += 5 * error[c];
        diffusion->next[x + 2][c] += error[c];
    }
}

static int with_error(int value, int sixteenths)
{
    int moved = value + (sixteenths >= 0 ? (sixteenths + 8) / 16 : -((8 - sixteenths) / 16));
    return moved < 0 ? 0 : moved > 255 ? 255 : moved;
}

static bool is_key(const struct texture_options *options, const uint8_t *pixel)
{
    return options->has_key && (pixel[3] < 128 || memcmp(pixel, options->key, 3) == 0);
}

/* texels: of a picture's first row. */
static void convert_row(const struct texture *texture, const struct texture_options *options,
                        const struct image *image, int y, uint32_t *texels,
                        struct diffusion *diffusion)
{
    for (int x = 0; x < image->width; x++) {
        size_t at = (size_t)y * (size_t)image->width + (size_t)x;
        const uint8_t *pixel = &image->rgba[4 * at];
        int wanted[3], got[3], error[3];
        if (is_key(options, pixel)) {
            texels[at] = texture->key;
            continue;
        }
        for (int c = 0; c < 3; c++) {
            wanted[c] = options->dither ? with_error(pixel[c], diffusion->row[x + 1][c]) : pixel[c];
        }
        texels[at] = keep_off_key(texture, encode(texture, wanted));
        decode(texture, texels[at], got);
        for (int c = 0; c < 3; c++) {
            error[c] = wanted[c] - got[c];
        }
        if (texture->format != TEXTURE_GRAY8) {
            diffuse(diffusion, x, error);
        }
    }
}

static void convert(const struct texture *texture, const struct texture_options *options,
                    const struct image *image, uint32_t *texels)
{
    size_t columns = (size_t)image->width + 2;
    int(*rows)[3] = xcalloc(2 * columns, sizeof *rows);
    for (int y = 0; y < image->height; y++) {
        struct diffusion diffusion = {&rows[(size_t)(y & 1) * columns],
                                      &rows[(size_t)(~y & 1) * columns]};
        memset(diffusion.next, 0, columns * sizeof *rows);
        convert_row(texture, options, image, y, texels, &diffusion);
    }
    free(rows);
}

size_t texture_level_at(const struct texture *texture, int level)
{
    size_t at = 0;
    for (int i = 0; i < level; i++) {
        at += (size_t)mipmap_side(texture->width, i) * (size_t)mipmap_side(texture->height, i);
    }
    return at;
}

/* Levels of the picture, of which what is the key's counts as transparent. */
static void convert_levels(const struct texture *texture, const struct texture_options *options,
                           const struct image *image)
{
    size_t count = (size_t)image->width * (size_t)image->height;
    uint8_t *seen = xcalloc(count, 4), *smaller = xcalloc(count, 4);
    for (size_t i = 0; i < count; i++) {
        const uint8_t *pixel = &image->rgba[4 * i];
        memcpy(&seen[4 * i], pixel, 4);
        seen[4 * i + 3] = is_key(options, pixel) ? 0 : pixel[3];
    }
    for (int level = 1; level <= texture->level_count; level++) {
        const struct image picture = {mipmap_side(image->width, level),
                                      mipmap_side(image->height, level), smaller};
        mipmap_level(seen, image->width, image->height, level, smaller);
        convert(texture, options, &picture, &texture->texels[texture_level_at(texture, level)]);
    }
    free(seen);
    free(smaller);
}

static void measure(struct texture *texture, const struct texture_options *options,
                    const struct image *image)
{
    double sum = 0.0;
    size_t seen = 0, count = (size_t)texture->width * (size_t)texture->height;
    for (size_t i = 0; i < count; i++) {
        int color[3];
        if (is_key(options, &image->rgba[4 * i])) {
            continue;
        }
        seen++;
        decode(texture, texture->texels[i], color);
        for (int c = 0; c < 3; c++) {
            int difference = abs(color[c] - image->rgba[4 * i + (size_t)c]);
            sum += (double)difference * difference;
            texture->error.greatest =
                difference > texture->error.greatest ? difference : texture->error.greatest;
        }
    }
    texture->error.rms = seen > 0 ? sqrt(sum / (3.0 * (double)seen)) : 0.0;
}

/* ---- The texture ---- */

/* Of a palette with a key, entry 0 is the key's. */
static void make_palette(struct texture *texture, const struct texture_options *options,
                         const struct image *image)
{
    int first = options->has_key ? 1 : 0;
    uint8_t colors[256][3];
    int count = texture_palette(image, 256 - first, colors);
    memcpy(texture->palette[0], options->key, 3);
    memcpy(texture->palette[first], colors, (size_t)(256 - first) * 3);
    texture->palette_count = count + first;
    for (int i = 0; i < 256 && texture->format == TEXTURE_PALETTE565; i++) {
        uint8_t *entry = texture->palette[i];
        int color[3] = {entry[0], entry[1], entry[2]};
        from_rgb565(texture_rgb565(color), color);
        for (int c = 0; c < 3; c++) {
            entry[c] = (uint8_t)color[c];
        }
    }
}

static void fill(struct texture *texture, const struct texture_options *options,
                 const struct image *image)
{
    const int key[3] = {options->key[0], options->key[1], options->key[2]};
    texture->level_count = options->mipmaps ? mipmap_count(texture->width) : 0;
    texture->texels =
        xcalloc(texture_level_at(texture, texture->level_count + 1), sizeof *texture->texels);
    if (has_palette(texture)) {
        make_palette(texture, options, image);
    }
    texture->has_key = options->has_key;
    texture->key = options->has_key && !has_palette(texture) ? encode(texture, key) : 0;
    convert(texture, options, image, texture->texels);
    convert_levels(texture, options, image);
}

bool texture_make(const char *path, const struct image *image,
                  const struct texture_options *options, struct texture *texture,
                  struct text_error *error)
{
    struct image sized;
    memset(texture, 0, sizeof *texture);
    texture->format = options->format;
    texture->width = options->width > 0 ? options->width : texture_nearest_side(image->width);
    texture->height = options->height > 0 ? options->height : texture_nearest_side(image->height);
    if (!texture_resample(image, texture->width, texture->height, &sized)) {
        return text_error_set(error, path, 0, "out of memory");
    }
    fill(texture, options, &sized);
    measure(texture, options, &sized);
    image_free(&sized);
    return true;
}

static size_t texel_bytes(const struct texture *texture)
{
    return texture->format == TEXTURE_XRGB8888 ? 4 : texture->format == TEXTURE_RGB565 ? 2 : 1;
}

/* 52: sizeof (qtri_texture) with 32-bit pointers and enums; a pointer for each level. */
size_t texture_flash_bytes(const struct texture *texture)
{
    return texture_level_at(texture, texture->level_count + 1) * texel_bytes(texture) +
           (texture->format == TEXTURE_PALETTE      ? 768U
            : texture->format == TEXTURE_PALETTE565 ? 512U
                                                    : 0U) +
           52U + 4U * (size_t)texture->level_count;
}

bool texture_picture(const struct texture *texture, struct picture *picture)
{
    if (!picture_create(picture, texture->width, texture->height, false)) {
        return false;
    }
    size_t count = (size_t)texture->width * (size_t)texture->height;
    for (size_t i = 0; i < count; i++) {
        int color[3];
        decode(texture, texture->texels[i], color);
        for (size_t c = 0; c < 3; c++) {
            picture->rgb[3 * i + c] = (uint8_t)color[c];
        }
    }
    return true;
}
