/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../assets/asset.h"
#include "../assets/texture.h"
#include "../io/file.h"
#include "commands.h"

static const char usage[] =
    "usage: qtri texture IN -o NAME.h [OPTION ...]\n"
    "\n"
    "Makes a constant qtri_texture of a picture: a header that C99 and C++11 compile, or a "
    "picture\n"
    "of what it will show where the output is named .png or .ppm. IN is PNG, PPM or PGM, or - for\n"
    "standard input; -o - is standard output.\n"
    "\n"
    "  --format FORMAT  rgb565 (default), palette (256 colours), gray8 or xrgb8888\n"
    "  --size WxH       powers of two up to 1024 (default: those nearest to the picture's sides)\n"
    "  --dither         spread rounding errors over neighbours: rgb565 and palette\n"
    "  --mipmaps        levels of half the size each, down to 2 texels, for &qtri_mipmapped\n"
    "  --key RRGGBB     the colour that is not drawn; pixels that are less than half opaque get "
    "it\n"
    "  --name NAME      of the qtri_texture (default: the output's, the input's)\n"
    "  --split          a declaration in NAME.h, data in NAME.c\n";

struct options {
    const char *input, *output;
    char name[64];
    bool split, is_picture;
    struct texture_options texture;
};

static bool complain(const char *problem, const char *what)
{
    fprintf(stderr, "qtri texture: %s%s\n", problem, what);
    return false;
}

static bool is_side(long side)
{
    return side >= 1 && side <= TEXTURE_MAX_SIDE && (side & (side - 1)) == 0;
}

static bool parse_size(struct options *options, const char *text)
{
    char *end = NULL;
    long width = strtol(text, &end, 10);
    if (*text < '0' || *text > '9' || *end != 'x' || end[1] < '0' || end[1] > '9') {
        return false;
    }
    long height = strtol(end + 1, &end, 10);
    if (*end != '\0' || !is_side(width) || !is_side(height)) {
        return false;
    }
    options->texture.width = (int)width;
    options->texture.height = (int)height;
    return true;
}

static bool parse_key(struct options *options, const char *text)
{
    if (strlen(text) != 6 || strspn(text, "0123456789abcdefABCDEF") != 6) {
        return false;
    }
    unsigned long value = strtoul(text, NULL, 16);
    for (int i = 0; i < 3; i++) {
        options->texture.key[i] = (uint8_t)(value >> (16 - 8 * i));
    }
    options->texture.has_key = true;
    return true;
}

static bool parse_format(struct options *options, const char *text)
{
    for (int i = 0; i < TEXTURE_FORMATS; i++) {
        if (strcmp(text, texture_format_names[i]) == 0) {
            options->texture.format = (enum texture_format)i;
            return true;
        }
    }
    return false;
}

static bool parse_name(struct options *options, const char *text)
{
    size_t length = strlen(text);
    asset_identifier(text, options->name, sizeof options->name);
    return length > 0 && length < sizeof options->name && strcmp(text, options->name) == 0;
}

static bool set_value(struct options *options, const char *name, const char *value)
{
    if (strcmp(name, "-o") == 0) {
        options->output = value;
        return *value != '\0';
    }
    if (strcmp(name, "--format") == 0) {
        return parse_format(options, value);
    }
    if (strcmp(name, "--size") == 0) {
        return parse_size(options, value);
    }
    if (strcmp(name, "--name") == 0) {
        return parse_name(options, value);
    }
    return parse_key(options, value);
}

static bool takes_value(const char *name)
{
    return strcmp(name, "-o") == 0 || strcmp(name, "--format") == 0 ||
           strcmp(name, "--size") == 0 || strcmp(name, "--key") == 0 || strcmp(name, "--name") == 0;
}

static bool parse_arguments(int argc, char **argv, struct options *options)
{
    for (int i = 1; i < argc; i++) {
        const char *argument = argv[i];
        if (strcmp(argument, "--dither") == 0) {
            options->texture.dither = true;
        } else if (strcmp(argument, "--mipmaps") == 0) {
            options->texture.mipmaps = true;
        } else if (strcmp(argument, "--split") == 0) {
            options->split = true;
        } else if (takes_value(argument)) {
            if (++i == argc) {
                return complain("a value is missing after ", argument);
            }
            if (!set_value(options, argument, argv[i])) {
                fprintf(stderr, "qtri texture: '%s' is no value for %s\n", argv[i], argument);
                return false;
            }
        } else if (argument[0] == '-' && argument[1] != '\0') {
            return complain("unknown option ", argument);
        } else if (options->input != NULL) {
            return complain("one picture at a time, please: ", argument);
        } else {
            options->input = argument;
        }
    }
    return true;
}

static bool check_names(struct options *options)
{
    if (options->input == NULL || options->output == NULL) {
        return complain("a picture and -o NAME.h are needed", "");
    }
    bool is_standard = strcmp(options->output, "-") == 0;
    options->is_picture =
        file_name_ends_in(options->output, ".png") || file_name_ends_in(options->output, ".ppm");
    if (!is_standard && !options->is_picture && !file_name_ends_in(options->output, ".h")) {
        return complain("the output is named neither .h nor .png nor .ppm: ", options->output);
    }
    if (options->split && (is_standard || options->is_picture)) {
        return complain("--split needs an output named .h", "");
    }
    if (options->name[0] == '\0') {
        asset_identifier(is_standard ? options->input : options->output, options->name,
                         sizeof options->name);
    }
    return options->name[0] != '\0' || complain("--name is needed", "");
}

static bool write_picture(const struct options *options, const struct texture *texture,
                          struct text_error *error)
{
    struct picture picture;
    if (!texture_picture(texture, &picture)) {
        text_error_set(error, options->output, 0, "out of memory");
        return false;
    }
    bool ok = image_write_picture(options->output, &picture, error);
    picture_free(&picture);
    return ok;
}

static bool write_c(const struct options *options, const struct texture *texture,
                    struct text_error *error)
{
    struct asset_files files;
    if (!asset_files_open(&files, options->output, options->split, error)) {
        return false;
    }
    texture_write_c(texture, options->name, files.header_name, files.header.stream,
                    files.source.stream);
    return asset_files_commit(&files, error);
}

static void report(const struct options *options, const struct texture *texture, FILE *out)
{
    fprintf(out, "%s: %d x %d, %s", options->name, texture->width, texture->height,
            texture_format_names[texture->format]);
    if (texture->format == TEXTURE_PALETTE) {
        fprintf(out, " of %d colours", texture->palette_count);
    }
    if (texture->level_count > 0) {
        fprintf(out, ", %d levels", texture->level_count + 1);
    }
    fprintf(out, "\nflash: %zu bytes\ncolour error: at most %d of 255, %.2f rms\n",
            texture_flash_bytes(texture), texture->error.greatest, texture->error.rms);
}

static bool run(const struct options *options, struct text_error *error)
{
    struct image image;
    struct texture texture;
    if (!image_read(options->input, &image, error)) {
        return false;
    }
    bool ok = texture_make(options->input, &image, &options->texture, &texture, error);
    image_free(&image);
    if (ok) {
        ok = options->is_picture ? write_picture(options, &texture, error)
                                 : write_c(options, &texture, error);
        if (ok) {
            report(options, &texture, strcmp(options->output, "-") == 0 ? stderr : stdout);
        }
        texture_free(&texture);
    }
    return ok;
}

int texture_main(int argc, char **argv)
{
    struct options options;
    struct text_error error;
    memset(&options, 0, sizeof options);
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
            fputs(usage, stdout);
            return 0;
        }
    }
    if (!parse_arguments(argc, argv, &options) || !check_names(&options)) {
        fputs("Try `qtri texture --help`.\n", stderr);
        return 2;
    }
    if (!run(&options, &error)) {
        fprintf(stderr, "qtri texture: %s\n", error.message);
        return 1;
    }
    return 0;
}
