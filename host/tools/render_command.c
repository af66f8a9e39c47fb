/* SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../reference/reference.h"
#include "../reference/reference_picture.h"
#include "commands.h"
#include "scene_draw.h"

static const char usage[] =
    "usage: qtri render SCENE -o PREFIX [OPTION ...]\n"
    "\n"
    "Draws the scene file SCENE and writes PREFIX.ppm.\n"
    "\n"
    "  --format FORMAT  rgb888 (default), rgb565 or gray8: the surface's pixel format;\n"
    "                   the PPM shows its colours widened to 8 bits\n"
    "  --dump           also write PREFIX.id (uint32) and PREFIX.depth (float64), little-endian,\n"
    "                   top row first: visible triangle (0: background), window depth 0..1\n"
    "  --rows N         draw in bands of N rows (default: the whole picture); same pixels\n"
    "  --reference      draw with the double-precision pipeline instead\n"
    "  --snap N         with --reference: snap vertices to N sub-pixel bits, 0..16 (default 0:\n"
    "                   infinite precision)\n";

struct options {
    const char *scene, *prefix;
    int format; /* see formats */
    bool dump, reference;
    int snap, rows;
};

static const struct {
    const char *name;
    const qtri_format *core;
    enum reference_format reference;
} formats[] = {
    {"rgb888", &qtri_xrgb8888, REFERENCE_RGB888},
    {"rgb565", &qtri_rgb565, REFERENCE_RGB565},
    {"gray8", &qtri_gray8, REFERENCE_GRAY8},
};

/* Reads a decimal in 0..max; false for anything else. */
static bool parse_count(const char *text, int max, int *out)
{
    char *end = NULL;
    long value = strtol(text, &end, 10);
    if (*text == '\0' || *end != '\0' || value < 0 || value > max) {
        return false;
    }
    *out = (int)value;
    return true;
}

static bool parse_format(const char *text, int *out)
{
    for (int i = 0; i < (int)(sizeof formats / sizeof formats[0]); i++) {
        if (strcmp(text, formats[i].name) == 0) {
            *out = i;
            return true;
        }
    }
    return false;
}

/* One option with a value; false when the value does not fit it. */
static bool set_value(struct options *options, const char *name, const char *value)
{
    if (strcmp(name, "-o") == 0) {
        options->prefix = value;
        return *value != '\0';
    }
    if (strcmp(name, "--format") == 0) {
        return parse_format(value, &options->format);
    }
    if (strcmp(name, "--rows") == 0) {
        return parse_count(value, SCENE_MAX_SIZE, &options->rows);
    }
    return parse_count(value, 16, &options->snap);
}

static bool takes_value(const char *name)
{
    return strcmp(name, "-o") == 0 || strcmp(name, "--format") == 0 ||
           strcmp(name, "--rows") == 0 || strcmp(name, "--snap") == 0;
}

/* Fills *options; false after a message. */
static bool parse_options(int argc, char **argv, struct options *options)
{
    for (int i = 1; i < argc; i++) {
        const char *argument = argv[i];
        if (takes_value(argument)) {
            if (i + 1 == argc) {
                fprintf(stderr, "qtri render: %s needs a value\n", argument);
                return false;
            }
            i++;
            if (!set_value(options, argument, argv[i])) {
                fprintf(stderr, "qtri render: '%s' is not a value for %s\n", argv[i], argument);
                return false;
            }
        } else if (strcmp(argument, "--dump") == 0) {
            options->dump = true;
        } else if (strcmp(argument, "--reference") == 0) {
            options->reference = true;
        } else if (argument[0] == '-' && argument[1] != '\0') {
            fprintf(stderr, "qtri render: unknown option '%s'\n", argument);
            return false;
        } else if (options->scene != NULL) {
            fprintf(stderr, "qtri render: one scene at a time, please: '%s'\n", argument);
            return false;
        } else {
            options->scene = argument;
        }
    }
    if (options->scene == NULL || options->prefix == NULL) {
        fprintf(stderr, "qtri render: a scene file and -o PREFIX are needed\n");
        return false;
    }
    return true;
}

static bool render(const struct options *options, const struct scene *scene,
                   struct picture *picture)
{
    if (!options->reference) {
        return scene_render(scene, formats[options->format].core, options->rows, options->dump,
                            picture);
    }
    struct reference_image image;
    if (!reference_render(scene, options->snap, &image)) {
        return false;
    }
    bool ok = reference_picture(&image, formats[options->format].reference, picture);
    reference_free(&image);
    return ok;
}

static bool write_files(const struct options *options, const struct picture *picture,
                        struct text_error *error)
{
    size_t length = strlen(options->prefix) + sizeof ".ppm";
    char *path = malloc(length);
    if (path == NULL) {
        text_error_set(error, options->prefix, 0, "out of memory");
        return false;
    }
    snprintf(path, length, "%s.ppm", options->prefix);
    bool ok = (!options->dump || picture_write_dump(options->prefix, picture, error)) &&
              picture_write_ppm(path, picture, error);
    free(path);
    return ok;
}

static void print_help(void)
{
    const char *name;
    const char *arguments;
    fputs(usage, stdout);
    fputs("\nStatements of a scene file, one a line; # starts a comment:\n\n", stdout);
    for (size_t i = 0; scene_statement_usage(i, &name, &arguments); i++) {
        printf("  %-12s %s\n", name, arguments);
    }
}

int render_main(int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
            print_help();
            return 0;
        }
    }
    struct options options = {0};
    if (!parse_options(argc, argv, &options)) {
        fputs("Try `qtri render --help`.\n", stderr);
        return 2;
    }
    struct scene scene;
    struct text_error error;
    if (!scene_read(options.scene, &scene, &error)) {
        fprintf(stderr, "qtri render: %s\n", error.message);
        return 1;
    }
    if (options.dump && !options.reference && scene.triangle_count > SCENE_MAX_DUMP_ID) {
        fprintf(stderr, "qtri render: %s: more than %u triangles cannot be dumped\n", options.scene,
                SCENE_MAX_DUMP_ID);
        scene_free(&scene);
        return 1;
    }
    struct picture picture;
    int status = 0;
    if (!render(&options, &scene, &picture)) {
        fprintf(stderr, "qtri render: out of memory\n");
        status = 1;
    } else {
        if (!write_files(&options, &picture, &error)) {
            fprintf(stderr, "qtri render: %s\n", error.message);
            status = 1;
        }
        picture_free(&picture);
    }
    scene_free(&scene);
    return status;
}
