/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../assets/animation.h"
#include "../assets/image.h"
#include "../reference/reference.h"
#include "../reference/reference_picture.h"
#include "../io/file.h"
#include "../io/file_inputs.h"
#include "../io/system.h"
#include "commands.h"
#include "options.h"
#include "scene_draw.h"

static const char usage[] =
    "usage: qtri render SCENE -o PICTURE [OPTION ...]\n"
    "\n"
    "Draws the scene file SCENE (-: standard input) and writes PICTURE: PNG where it is named "
    ".png,\n"
    "else PPM, to which a name without an ending adds .ppm. A PICTURE that is a device or a pipe, "
    "or\n"
    "- for standard output, is written as it is named. A picture is replaced when it is complete,\n"
    "and never what it is drawn from. Meshes and textures are read in the scene's folder and "
    "below.\n"
    "\n"
    "  --frames N       draw N pictures, in which $t of the scene's expressions goes from 0 to 1:\n"
    "                   PICTURE.apng is one animated picture, PICTURE.y4m and - are video,\n"
    "                   NAME.png and others become NAME-0000.png and so on. Ctrl-C ends with the\n"
    "                   frames that are drawn\n"
    "  --fps N          frames a second, 1..1000 (default 25)\n"
    "  --at T           without --frames: $t, 0..1 (default 0)\n"
    "  --allow-files    read meshes and textures wherever the scene says they are\n"
    "  --format FORMAT  rgb888 (default), rgb565 or gray8: the surface's pixel format;\n"
    "                   the PPM shows its colours widened to 8 bits\n"
    "  --dump           also write, with .id and .depth as the name's ending, uint32 and float64,\n"
    "                   little-endian, top row first: visible triangle (0: background), window\n"
    "                   depth 0..1\n"
    "  --rows N         draw in bands of N rows (default: the whole picture); same pixels\n"
    "  --reference      draw with the double-precision pipeline instead\n"
    "  --snap N         with --reference: snap vertices to N sub-pixel bits, 0..16 (default 0:\n"
    "                   infinite precision)\n"
    "  --large          with --reference: pictures above 2048 x 2048 pixels, up to 4096 x 4096.\n"
    "                   One takes 136 bytes of memory a pixel, 0.6 GB below the limit, and with\n"
    "                   antialias msaa, ssaa or temporal twice that\n"
    "\n"
    "A scene that asks for more than 300 seconds of work ends with a message: see `qtri --help`.\n";

#define REFERENCE_PIXELS (2048L * 2048L) /* without --large */

struct options {
    const char *scene, *output;
    int format; /* see formats */
    bool dump, reference, allow_files, large;
    int snap, rows;
    int frames; /* 0: one picture */
    int per_second;
    double time;
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

static bool set_format(void *options, const char *value, struct option_words *more)
{
    (void)more;
    for (int i = 0; i < (int)(sizeof formats / sizeof formats[0]); i++) {
        if (strcmp(value, formats[i].name) == 0) {
            ((struct options *)options)->format = i;
            return true;
        }
    }
    return false;
}

static bool set_rows(void *options, const char *value, struct option_words *more)
{
    long rows = 0;
    (void)more;
    bool ok = option_whole(value, 0, SCENE_MAX_SIZE, &rows);
    ((struct options *)options)->rows = (int)rows;
    return ok;
}

static bool set_frames(void *options, const char *value, struct option_words *more)
{
    long frames = 0;
    (void)more;
    bool ok = option_whole(value, 1, 100000, &frames);
    ((struct options *)options)->frames = (int)frames;
    return ok;
}

static bool set_fps(void *options, const char *value, struct option_words *more)
{
    long per_second = 0;
    (void)more;
    bool ok = option_whole(value, 1, 1000, &per_second);
    ((struct options *)options)->per_second = (int)per_second;
    return ok;
}

static bool set_time(void *options, const char *value, struct option_words *more)
{
    (void)more;
    return option_real(value, 0, 1, &((struct options *)options)->time);
}

static bool set_snap(void *options, const char *value, struct option_words *more)
{
    long bits = 0;
    (void)more;
    bool ok = option_whole(value, 0, 16, &bits);
    ((struct options *)options)->snap = (int)bits;
    return ok;
}

#define AT(member) offsetof(struct options, member)

static const struct option options_of_render[] = {
    {"-o", OPTION_TEXT, AT(output), NULL},
    {"--format", OPTION_SET, 0, set_format},
    {"--rows", OPTION_SET, 0, set_rows},
    {"--snap", OPTION_SET, 0, set_snap},
    {"--frames", OPTION_SET, 0, set_frames},
    {"--fps", OPTION_SET, 0, set_fps},
    {"--at", OPTION_SET, 0, set_time},
    {"--dump", OPTION_FLAG, AT(dump), NULL},
    {"--reference", OPTION_FLAG, AT(reference), NULL},
    {"--allow-files", OPTION_FLAG, AT(allow_files), NULL},
    {"--large", OPTION_FLAG, AT(large), NULL},
};

static const struct option_list list = {"render", "scene", offsetof(struct options, scene),
                                        options_of_render,
                                        sizeof options_of_render / sizeof options_of_render[0]};

/* Fills *options; false after a message. */
static bool parse_options(int argc, char **argv, struct options *options)
{
    if (!options_parse(&list, options, argc, argv)) {
        return false;
    }
    if (options->scene == NULL || options->output == NULL) {
        return options_complain(&list, "a scene file and -o PICTURE are needed", "");
    }
    if (options->frames > 0 && options->dump) {
        return options_complain(&list, "--dump is for one picture, not for --frames", "");
    }
    if (options->frames > 0 && strcmp(options->scene, "-") == 0) {
        return options_complain(&list, "--frames reads the scene for each of them: not ", "-");
    }
    if (options->dump && file_is_stream(options->output)) {
        return options_complain(&list, "--dump writes three files: not to ", options->output);
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

/* The output's name with another ending, or none, in place of .ppm or .png; free() it. NULL when
   memory runs out. */
static char *name_with(const struct options *options, const char *ending)
{
    const char *name = options->output;
    const bool is_named = file_name_ends_in(name, ".ppm") || file_name_ends_in(name, ".png");
    const size_t length = strlen(name) - (is_named ? 4 : 0);
    const size_t size = length + strlen(ending) + 1;
    char *path = malloc(size);
    if (path != NULL) {
        (void)snprintf(path, size, "%.*s%s", (int)length, name, ending);
    }
    return path;
}

/* The picture's name: as it was given where it is a stream or has an ending, else with .ppm. */
static char *picture_path(const struct options *options)
{
    const bool is_png = file_name_ends_in(options->output, ".png");
    if (file_is_stream(options->output)) {
        const size_t size = strlen(options->output) + 1;
        char *path = malloc(size);
        return path != NULL ? memcpy(path, options->output, size) : NULL;
    }
    return name_with(options, is_png ? ".png" : ".ppm");
}

static bool write_files(const struct options *options, const char *path,
                        const struct picture *picture, struct text_error *error)
{
    char *prefix = name_with(options, "");
    bool ok = prefix != NULL;
    if (!ok) {
        text_error_set(error, path, 0, "out of memory");
    }
    ok = ok && (!options->dump || picture_write_dump(prefix, picture, error)) &&
         image_write_picture(path, picture, error);
    free(prefix);
    return ok;
}

/*
 * Whether the picture is what it is without anything drawn: all pixels are that of a picture of
 * one, into which nothing goes. False where memory runs out.
 */
static bool is_empty(const struct options *options, const struct scene *scene,
                     const struct picture *picture)
{
    struct scene nothing = *scene;
    struct picture one;
    nothing.width = nothing.height = 1;
    nothing.op_count = 0;
    nothing.antialias = SCENE_ANTIALIAS_OFF;
    if (!render(options, &nothing, &one)) {
        return false;
    }
    const size_t count = (size_t)picture->width * (size_t)picture->height;
    size_t same = 0;
    while (same < count && memcmp(&picture->rgb[3 * same], one.rgb, 3) == 0) {
        same++;
    }
    picture_free(&one);
    return same == count;
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

static bool may_write(const char *path)
{
    const bool is_input = path != NULL && file_inputs_has(path);
    if (is_input) {
        fprintf(stderr, "qtri render: %s: has been read: it would be overwritten\n", path);
    }
    return !is_input;
}

/* Asked before anything is drawn, or one of three files would be there without the others. */
static bool keeps_inputs(const struct options *options, const char *path)
{
    char *id = options->dump ? name_with(options, ".id") : NULL;
    char *depth = options->dump ? name_with(options, ".depth") : NULL;
    const bool ok = may_write(path) && may_write(id) && may_write(depth);
    free(id);
    free(depth);
    return ok;
}

/* Draws the scene into the file; returns the exit status. */
static int render_file(const struct options *options, const char *path)
{
    struct scene scene;
    struct text_error error;
    const struct scene_reading how = {options->time, !options->allow_files, path};
    bool ok = scene_read_as(options->scene, &how, &scene, &error);
    if (!ok) {
        fprintf(stderr, "qtri render: %s\n", error.message);
        return 1;
    }
    struct picture picture;
    ok = keeps_inputs(options, path) && is_within_limits(options, &scene);
    if (ok && !render(options, &scene, &picture)) {
        fprintf(stderr, "qtri render: out of memory\n");
        ok = false;
    } else if (ok) {
        ok = write_files(options, path, &picture, &error);
        if (!ok) {
            fprintf(stderr, "qtri render: %s\n", error.message);
        } else if (is_empty(options, &scene, &picture)) {
            fprintf(stderr, "qtri render: %s: nothing is seen in the picture but its background\n",
                    options->scene);
        }
        picture_free(&picture);
    }
    scene_free(&scene);
    return ok ? 0 : 1;
}

static volatile sig_atomic_t is_interrupted;

static void interrupt(int number)
{
    (void)number;
    is_interrupted = 1;
}

/* Draws frame `i` of the animation; false with *error set. */
static bool render_frame(const struct options *options, int i, struct animation *animation,
                         struct text_error *error)
{
    struct scene scene;
    struct picture picture;
    const struct scene_reading how = {options->frames > 1 ? (double)i / (options->frames - 1) : 0,
                                      !options->allow_files, options->output};
    if (!scene_read_as(options->scene, &how, &scene, error)) {
        return false;
    }
    bool ok = is_within_limits(options, &scene);
    error->message[0] = '\0';
    if (ok && !render(options, &scene, &picture)) {
        text_error_set(error, options->scene, 0, "out of memory");
        ok = false;
    } else if (ok) {
        ok = animation_add(animation, &picture, error);
        picture_free(&picture);
    }
    scene_free(&scene);
    return ok;
}

/* Draws all frames; returns the exit status. */
static int render_frames(const struct options *options)
{
    struct animation animation;
    struct text_error error = {""};
    const bool is_watched = isatty(STDERR_FILENO) != 0;
    bool ok = true;
    system_on_interrupt(interrupt);
    animation_begin(&animation, options->output, options->per_second);
    for (int i = 0; ok && i < options->frames && !is_interrupted; i++) {
        ok = render_frame(options, i, &animation, &error);
        if (is_watched) {
            fprintf(stderr, "\rframe %d of %d%s", i + 1, options->frames,
                    !ok || i + 1 == options->frames ? "\n" : "");
        }
    }
    if (!ok && error.message[0] != '\0') {
        fprintf(stderr, "qtri render: %s\n", error.message);
    }
    if (is_interrupted) {
        fprintf(stderr, "qtri render: ended after %d of %d frames\n", animation.count,
                options->frames);
    }
    if (!animation_end(&animation, &error)) {
        fprintf(stderr, "qtri render: %s\n", error.message);
        ok = false;
    }
    return ok && !is_interrupted ? 0 : 1;
}

int render_main(int argc, char **argv)
{
    if (options_ask_help(argc, argv)) {
        print_help();
        return 0;
    }
    struct options options = {.per_second = 25};
    if (!parse_options(argc, argv, &options)) {
        fputs("Try `qtri render --help`.\n", stderr);
        return 2;
    }
    if (options.frames > 0) {
        return render_frames(&options);
    }
    char *path = picture_path(&options);
    if (path == NULL) {
        fprintf(stderr, "qtri render: out of memory\n");
        return 1;
    }
    int status = render_file(&options, path);
    free(path);
    return status;
}
