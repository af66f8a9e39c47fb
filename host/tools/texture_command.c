/* SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../assets/asset.h"
#include "../assets/asset_header.h"
#include "../assets/model.h"
#include "../assets/texture.h"
#include "../io/file.h"
#include "commands.h"

static const char usage[] =
    "usage: qtri texture IN -o NAME.h [OPTION ...]\n"
    "\n"
    "Makes a constant qtri_texture of a picture: a header that C99 and C++11 compile, or a "
    "picture\n"
    "of what it will show where the output is named .png or .ppm. IN is PNG, JPEG, PPM or PGM, or "
    "a\n"
    "glTF or GLB model with pictures inside; - is standard input, -o - standard output.\n"
    "\n"
    "  --format FORMAT  rgb565 (default), palette (256 colours), palette565 (256\n"
    "                   of RGB565: faster on such displays), gray8 or xrgb8888\n"
    "  --size WxH       powers of two up to 1024 (default: those nearest to the picture's sides)\n"
    "  --dither         spread rounding errors over neighbours: rgb565 and palettes\n"
    "  --mipmaps        levels of half the size each, down to 2 texels, for &qtri_mipmapped\n"
    "  --key RRGGBB     the colour that is not drawn; pixels that are less than half opaque get "
    "it\n"
    "  --picture N      of a model: which of its pictures, from 0 (default 0)\n"
    "  --name NAME      of the qtri_texture (default: the output's, the input's)\n"
    "  --split          a declaration in NAME.h, data in NAME.c\n";

struct options {
    const char *input, *output;
    char name[OPTION_NAME_SIZE];
    bool split, is_picture;
    int picture; /* inside a model */
    struct texture_options texture;
};

static bool is_side(int side)
{
    return (side & (side - 1)) == 0;
}

static bool set_size(void *options, const char *value, struct option_words *more)
{
    struct texture_options *texture = &((struct options *)options)->texture;
    (void)more;
    return option_size(value, TEXTURE_MAX_SIDE, &texture->width, &texture->height) &&
           is_side(texture->width) && is_side(texture->height);
}

static bool set_key(void *options, const char *value, struct option_words *more)
{
    struct texture_options *texture = &((struct options *)options)->texture;
    (void)more;
    if (strlen(value) != 6 || strspn(value, "0123456789abcdefABCDEF") != 6) {
        return false;
    }
    unsigned long number = strtoul(value, NULL, 16);
    for (int i = 0; i < 3; i++) {
        texture->key[i] = (uint8_t)(number >> (16 - 8 * i));
    }
    texture->has_key = true;
    return true;
}

#define AT(member) offsetof(struct options, member)

static const struct option all[] = {
    {"-o", OPTION_TEXT, AT(output), {NULL}},
    {"--format",
     OPTION_WORD,
     AT(texture.format),
     {.words = {texture_format_names, TEXTURE_FORMATS}}},
    {"--size", OPTION_SET, 0, {.set = set_size}},
    {"--key", OPTION_SET, 0, {.set = set_key}},
    {"--name", OPTION_NAME, AT(name), {NULL}},
    {"--picture", OPTION_WHOLE, AT(picture), {.range = {0, 65535}}},
    {"--dither", OPTION_FLAG, AT(texture.dither), {NULL}},
    {"--mipmaps", OPTION_FLAG, AT(texture.mipmaps), {NULL}},
    {"--split", OPTION_FLAG, AT(split), {NULL}},
};

static bool check(const struct option_command *command, void *given)
{
    struct options *options = given;
    bool is_standard = strcmp(options->output, "-") == 0;
    options->is_picture =
        file_name_ends_in(options->output, ".png") || file_name_ends_in(options->output, ".ppm");
    if (!is_standard && !options->is_picture && !file_name_ends_in(options->output, ".h")) {
        return options_complain(
            command, "the output is named neither .h nor .png nor .ppm: ", options->output);
    }
    if (options->split && (is_standard || options->is_picture)) {
        return options_complain(command, "--split needs an output named .h", "");
    }
    return options_default_name(command, options->input, options->output, options->name);
}

static bool write_picture(const struct options *options, const struct texture *texture,
                          struct text_error *error)
{
    struct picture picture;
    if (!texture_picture(texture, &picture)) {
        return text_error_set(error, options->output, 0, "out of memory");
    }
    bool ok = image_write_picture(options->output, &picture, error);
    picture_free(&picture);
    return ok;
}

/* width, height: of the picture. */
static void report(const struct options *options, const struct texture *texture, int width,
                   int height, FILE *out)
{
    fprintf(out, "%s: %d x %d, %s", options->name, texture->width, texture->height,
            texture_format_names[texture->format]);
    if (texture->palette_count > 0) {
        fprintf(out, " of %d colours", texture->palette_count);
    }
    if (texture->level_count > 0) {
        fprintf(out, ", %d levels", texture->level_count + 1);
    }
    if (texture->width != width || texture->height != height) {
        fprintf(out, ", resampled from %d x %d", width, height);
    }
    fprintf(out, "\nflash: %zu bytes\ncolour error: at most %d of 255, %.2f rms\n",
            texture_flash_bytes(texture), texture->error.greatest, texture->error.rms);
}

/* The input's picture, or one of those inside a model. */
static bool read_image(const struct options *options, struct image *image, struct text_error *error)
{
    struct file_content file;
    char *inside = NULL;
    size_t length = 0;
    if (!file_read(options->input, &file, error)) {
        return false;
    }
    bool is_model = model_can_hold_pictures(file.bytes, file.length);
    bool ok = !is_model || model_picture(options->input, file.bytes, file.length,
                                         (unsigned)options->picture, &inside, &length, error);
    ok = ok && image_parse(options->input, is_model ? inside : file.bytes,
                           is_model ? length : file.length, image, error);
    free(inside);
    free(file.bytes);
    return ok;
}

static bool run(void *given, struct text_error *error)
{
    const struct options *options = given;
    struct image image;
    struct texture texture;
    if (!read_image(options, &image, error)) {
        return false;
    }
    bool ok = texture_make(options->input, &image, &options->texture, &texture, error);
    const int width = image.width;
    const int height = image.height;
    image_free(&image);
    if (ok) {
        ok = options->is_picture ? write_picture(options, &texture, error)
                                 : asset_header_save(&asset_header_texture, &texture, options->name,
                                                     options->output, options->split, error);
        if (ok) {
            report(options, &texture, width, height,
                   strcmp(options->output, "-") == 0 ? stderr : stdout);
        }
        texture_free(&texture);
    }
    return ok;
}

const struct option_command texture_command = {
    .name = "texture",
    .summary = "make C data of a picture",
    .size = sizeof(struct options),
    .input = "picture",
    .needs = "a picture and -o NAME.h are needed",
    .input_at = AT(input),
    .output_at = AT(output),
    .options = all,
    .count = sizeof all / sizeof all[0],
    .usage = usage,
    .check = check,
    .run = run,
};
