/* SPDX-License-Identifier: MIT */
/*
 * Textures for a microcontroller: constant texels as qtri/texture.h describes them, of a picture.
 */
#ifndef QTRI_HOST_ASSETS_TEXTURE_H
#define QTRI_HOST_ASSETS_TEXTURE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "image.h"

#define TEXTURE_MAX_SIDE 1024 /* of qtri_texture: width_log2 and height_log2 up to 10 */

enum texture_format {
    TEXTURE_RGB565,
    TEXTURE_PALETTE,
    TEXTURE_GRAY8,
    TEXTURE_XRGB8888,
    TEXTURE_PALETTE565, /* chosen as TEXTURE_PALETTE's, then rounded */
    TEXTURE_FORMATS
};
extern const char *const texture_format_names[TEXTURE_FORMATS];

struct texture_options {
    enum texture_format format;
    bool dither;       /* error diffusion, for rgb565 and palettes */
    bool mipmaps;      /* levels down to a width of two texels: see io/mipmap.h */
    bool has_key;      /* texels that are less than half opaque are the key's */
    uint8_t key[3];    /* its colour; texels of the picture that have it are the key's too */
    int width, height; /* powers of two up to TEXTURE_MAX_SIDE; 0: the nearest of the picture's */
};

struct texture {
    enum texture_format format;
    int width, height;
    uint32_t *texels;        /* as they are stored; levels behind each other */
    int level_count;         /* besides the first */
    uint8_t palette[256][3]; /* as the core shows it */
    int palette_count;
    bool has_key;
    uint32_t key;          /* the stored texel */
    bool clamp_u, clamp_v; /* beyond its edges they go on; else it repeats */
    struct {
        int greatest; /* difference of a channel, of 255, over texels that are not the key's */
        double rms;   /* of all channels */
    } error;
};

/* A colour of RGB565 for one of 8 bits a channel, to nearest. */
uint32_t texture_rgb565(const int color[3]);

/* The power of two nearest to a side, in proportion, 1..TEXTURE_MAX_SIDE. */
int texture_nearest_side(int side);

/*
 * Another size: triangle filter of the larger of both pixels, in linear light, weighted by how
 * opaque pixels are; edges repeat their pixels. The same size: the same bytes. False when memory
 * runs out.
 */
bool texture_resample(const struct image *image, int width, int height, struct image *out);

/* Up to `most` colours (1..256) for the picture's pixels that are opaque by half: all where they
   are so few, else median cut and k-means. Returns how many. */
int texture_palette(const struct image *image, int most, uint8_t palette[256][3]);

/* The entry from `first` to before `end` that is nearest to a colour. */
int texture_nearest_color(const uint8_t (*palette)[3], int first, int end, const int color[3]);

/* Makes a texture; false with *error set, which begins with `path`. */
bool texture_make(const char *path, const struct image *image,
                  const struct texture_options *options, struct texture *texture,
                  struct text_error *error);
void texture_free(struct texture *texture);

/* The first texel of a level; of the one after the last, how many there are. */
size_t texture_level_at(const struct texture *texture, int level);

/* Bytes of constant data on a machine with 32-bit pointers. */
size_t texture_flash_bytes(const struct texture *texture);

/* C source: the texels and `const qtri_texture NAME`. */
void texture_write_data(const struct texture *texture, const char *name, const char *linkage,
                        FILE *out);

/* What the core will show of it. False when memory runs out. */
bool texture_picture(const struct texture *texture, struct picture *picture);

#endif
