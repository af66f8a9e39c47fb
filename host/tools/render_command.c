/* SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../reference/reference.h"
#include "../reference/reference_picture.h"
#include "../io/file.h"
#include "commands.h"
#include "scene_draw.h"

static const char usage[] =
    "usage: qtri render SCENE -o PREFIX [OPTION ...]\n"
    "\n"
    "Draws the scene file SCENE (-: standard input) and writes PREFIX.ppm. A PREFIX that is a\n"
    "device or a pipe, or - for standard output, is written as it is named. A picture is replaced\n"
    "when it is complete, and never what it is drawn from. Meshes and textures are read in the\n"
    "scene's folder and below.\n"
    "\n"
    "  --allow-files    read meshes and textures wherever the scene says they are\n"
    "  --format FORMAT  rgb888 (default), rgb565 or gray8: the surface's pixel format;\n"
    "                   the PPM shows its colours widened to 8 bits\n"
    "  --dump           also write PREFIX.id (uint32) and PREFIX.depth (float64), little-endian,\n"
    "                   top row first: visible triangle (0: background), window depth 0..1\n"
    "  --rows N         draw in bands of N rows (default: the whole picture); same pixels\n"
    "  --reference      draw with the double-precision pipeline instead\n"
    "  --snap N         with --reference: snap vertices to N sub-pixel bits, 0..16 (default 0:\n"
    "                   infinite precision)\n"
    "  --large          with --reference: pictures above 2048 x 2048 pixels, up to 4096 x 4096.\n"
    "                   One takes 100 bytes of memory a pixel, 0.4 GB below the limit\n";

#define REFERENCE_PIXELS (2048L * 2048L) /* without --large */

struct options {
    const char *scene, *prefix;
    int format; /* see formats */
    bool dump, reference, allow_files, large;
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
        } else if (strcmp(argument, "--allow-files") == 0) {
            options->allow_files = true;
        } else if (strcmp(argument, "--large") == 0) {
            options->large = true;
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
    if (options->dump && file_is_stream(options->prefix)) {
        fprintf(stderr, "qtri render: --dump writes three files: not to '%s'\n", options->prefix);
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

/* PREFIX.ppm, or a stream's own name; free() it. NULL when memory runs out. */
static char *output_path(const struct options *options, const char *suffix)
{
    size_t length = strlen(options->prefix) + strlen(suffix) + 1;
    char *path = malloc(length);
    if (path != NULL) {
        const bool is_stream = file_is_stream(options->prefix);
        snprintf(path, length, "%s%s", options->prefix, is_stream ? "" : suffix);
    }
    return path;
}

static bool write_files(const struct options *options, const char *path,
                        const struct picture *picture, struct text_error *error)
{
    return (!options->dump || picture_write_dump(options->prefix, picture, error)) &&
           picture_write_ppm(path, picture, error);
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

/* A limit of what is drawn, with a message where it is exceeded. */
static bool is_within_limits(const struct options *options, const struct scene *scene)
{
    if (options->dump && !options->reference && scene->triangle_count > SCENE_MAX_DUMP_ID) {
        fprintf(stderr, "qtri render: %s: more than %u triangles cannot be dumped\n",
                options->scene, SCENE_MAX_DUMP_ID);
        return false;
    }
    if (options->reference && !options->large &&
        (long)scene->width * scene->height > REFERENCE_PIXELS) {
        fprintf(stderr, "qtri render: %s: %d x %d pixels are above 2048 x 2048 (--large)\n",
                options->scene, scene->width, scene->height);
        return false;
    }
    return true;
}

/* Draws the scene into the file; returns the exit status. */
static int render_file(const struct options *options, const char *path)
{
    struct scene scene;
    struct text_error error;
    bool ok = options->allow_files ? scene_read_for(options->scene, path, &scene, &error)
                                   : scene_read_below(options->scene, path, &scene, &error);
    if (!ok) {
        fprintf(stderr, "qtri render: %s\n", error.message);
        return 1;
    }
    struct picture picture;
    ok = is_within_limits(options, &scene);
    if (ok && !render(options, &scene, &picture)) {
        fprintf(stderr, "qtri render: out of memory\n");
        ok = false;
    } else if (ok) {
        ok = write_files(options, path, &picture, &error);
        if (!ok) {
            fprintf(stderr, "qtri render: %s\n", error.message);
        }
        picture_free(&picture);
    }
    scene_free(&scene);
    return ok ? 0 : 1;
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
    char *path = output_path(&options, ".ppm");
    if (path == NULL) {
        fprintf(stderr, "qtri render: out of memory\n");
        return 1;
    }
    int status = render_file(&options, path);
    free(path);
    return status;
}
