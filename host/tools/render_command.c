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
#include "../io/xalloc.h"
#include "commands.h"
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
    int format; /* of formats */
    bool dump, reference, allow_files, large;
    int snap, rows;
    int frames; /* 0: one picture */
    int per_second;
    double time;
};

static const char *const format_names[] = {"rgb888", "rgb565", "gray8"};
static const struct {
    const qtri_format *core;
    enum reference_format reference;
} formats[] = {
    {&qtri_xrgb8888, REFERENCE_RGB888},
    {&qtri_rgb565, REFERENCE_RGB565},
    {&qtri_gray8, REFERENCE_GRAY8},
};

#define AT(member) offsetof(struct options, member)

static const struct option all[] = {
    {"-o", OPTION_TEXT, AT(output), {NULL}},
    {"--format", OPTION_WORD, AT(format), {.words = {format_names, 3}}},
    {"--rows", OPTION_WHOLE, AT(rows), {.range = {0, SCENE_MAX_SIZE}}},
    {"--snap", OPTION_WHOLE, AT(snap), {.range = {0, 16}}},
    {"--frames", OPTION_WHOLE, AT(frames), {.range = {1, 100000}}},
    {"--fps", OPTION_WHOLE, AT(per_second), {.range = {1, 1000}}},
    {"--at", OPTION_REAL, AT(time), {.range = {0, 1}}},
    {"--dump", OPTION_FLAG, AT(dump), {NULL}},
    {"--reference", OPTION_FLAG, AT(reference), {NULL}},
    {"--allow-files", OPTION_FLAG, AT(allow_files), {NULL}},
    {"--large", OPTION_FLAG, AT(large), {NULL}},
};

/* What others write, and would get .ppm behind it. */
static bool is_other_format(const char *name)
{
    static const char *const endings[] = {".gif", ".jpg", ".jpeg", ".bmp", ".mp4", ".webp"};
    for (size_t i = 0; i < sizeof endings / sizeof endings[0]; i++) {
        if (file_name_ends_in(name, endings[i])) {
            return true;
        }
    }
    return false;
}

static bool check(const struct option_command *command, void *given)
{
    const struct options *options = given;
    if (is_other_format(options->output)) {
        return options_complain(command, "pictures are .ppm, .png, .apng or .y4m, not ",
                                options->output);
    }
    if (options->frames > 0 && options->dump) {
        return options_complain(command, "--dump is for one picture, not for --frames", "");
    }
    if (options->frames > 0 && strcmp(options->scene, "-") == 0) {
        return options_complain(command, "--frames reads the scene for each of them: not ", "-");
    }
    if (options->dump && file_is_stream(options->output)) {
        return options_complain(command, "--dump writes three files: not to ", options->output);
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

/* The output's name with another ending, or none, in place of .ppm or .png; free() it. */
static char *name_with(const struct options *options, const char *ending)
{
    const char *name = options->output;
    const bool is_named = file_name_ends_in(name, ".ppm") || file_name_ends_in(name, ".png");
    const size_t length = strlen(name) - (is_named ? 4 : 0);
    const size_t size = length + strlen(ending) + 1;
    char *path = xcalloc(size, 1);
    (void)snprintf(path, size, "%.*s%s", (int)length, name, ending);
    return path;
}

/* The picture's name: as it was given where it is a stream or has an ending, else with .ppm. */
static char *picture_path(const struct options *options)
{
    const bool is_png = file_name_ends_in(options->output, ".png");
    if (file_is_stream(options->output)) {
        return xstrdup(options->output);
    }
    return name_with(options, is_png ? ".png" : ".ppm");
}

static bool write_files(const struct options *options, const char *path,
                        const struct picture *picture, struct text_error *error)
{
    char *prefix = name_with(options, "");
    const bool ok = (!options->dump || picture_write_dump(prefix, picture, error)) &&
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

static void print_statements(void)
{
    const char *name;
    const char *arguments;
    fputs("\nStatements of a scene file, one a line; # starts a comment:\n\n", stdout);
    for (size_t i = 0; scene_statement_usage(i, &name, &arguments); i++) {
        printf("  %-12s %s\n", name, arguments);
    }
}

/* A limit of what is drawn; false with *error set where it is exceeded. */
static bool is_within_limits(const struct options *options, const struct scene *scene,
                             struct text_error *error)
{
    if (options->dump && !options->reference && scene->triangle_count > SCENE_MAX_DUMP_ID) {
        return text_error_set(error, options->scene, 0, "more than %u triangles cannot be dumped",
                              SCENE_MAX_DUMP_ID);
    }
    if (options->reference && !options->large &&
        (long)scene->width * scene->height > REFERENCE_PIXELS) {
        return text_error_set(error, options->scene, 0,
                              "%d x %d pixels are above 2048 x 2048 (--large)", scene->width,
                              scene->height);
    }
    return true;
}

static bool may_write(const char *path, struct text_error *error)
{
    const bool is_input = path != NULL && file_inputs_has(path);
    if (is_input) {
        text_error_set(error, path, 0, "has been read: it would be overwritten");
    }
    return !is_input;
}

/* Asked before anything is drawn, or one of three files would be there without the others. */
static bool keeps_inputs(const struct options *options, const char *path, struct text_error *error)
{
    char *id = options->dump ? name_with(options, ".id") : NULL;
    char *depth = options->dump ? name_with(options, ".depth") : NULL;
    const bool ok = may_write(path, error) && may_write(id, error) && may_write(depth, error);
    free(id);
    free(depth);
    return ok;
}

/* Reads the scene at a time and draws what is going to `path`; false with *error set. */
static bool draw(const struct options *options, double time, const char *path, struct scene *scene,
                 struct picture *picture, struct text_error *error)
{
    const struct scene_reading how = {time, !options->allow_files, path};
    if (!scene_read_as(options->scene, &how, scene, error)) {
        return false;
    }
    bool ok = keeps_inputs(options, path, error) && is_within_limits(options, scene, error);
    if (ok && !render(options, scene, picture)) {
        text_error_set(error, options->scene, 0, "out of memory");
        ok = false;
    }
    if (!ok) {
        scene_free(scene);
    }
    return ok;
}

/* ---- One picture ---- */

static bool render_file(const struct options *options, const char *path, struct text_error *error)
{
    struct scene scene;
    struct picture picture;
    if (!draw(options, options->time, path, &scene, &picture, error)) {
        return false;
    }
    const bool ok = write_files(options, path, &picture, error);
    if (ok && is_empty(options, &scene, &picture)) {
        fprintf(stderr, "qtri render: %s: nothing is seen in the picture but its background\n",
                options->scene);
    }
    picture_free(&picture);
    scene_free(&scene);
    return ok;
}

/* ---- Many ---- */

static volatile sig_atomic_t is_interrupted;

static void interrupt(int number)
{
    (void)number;
    is_interrupted = 1;
}

static bool render_frame(const struct options *options, int i, struct animation *animation,
                         struct text_error *error)
{
    struct scene scene;
    struct picture picture;
    const double time = options->frames > 1 ? (double)i / (options->frames - 1) : 0;
    if (!draw(options, time, options->output, &scene, &picture, error)) {
        return false;
    }
    const bool ok = animation_add(animation, &picture, error);
    picture_free(&picture);
    scene_free(&scene);
    return ok;
}

static bool render_frames(const struct options *options, struct text_error *error)
{
    struct animation animation;
    const bool is_watched = isatty(STDERR_FILENO) != 0;
    bool ok = true;
    system_on_interrupt(interrupt);
    animation_begin(&animation, options->output, options->per_second);
    for (int i = 0; ok && i < options->frames && !is_interrupted; i++) {
        ok = render_frame(options, i, &animation, error);
        if (is_watched) {
            fprintf(stderr, "\rframe %d of %d%s", i + 1, options->frames,
                    !ok || i + 1 == options->frames ? "\n" : "");
        }
    }
    if (is_interrupted) {
        fprintf(stderr, "qtri render: ended after %d of %d frames\n", animation.count,
                options->frames);
    }
    struct text_error at_end;
    if (!animation_end(&animation, &at_end) && ok) {
        *error = at_end;
        ok = false;
    }
    return ok && !is_interrupted;
}

/* ---- The command ---- */

static bool run(void *given, struct text_error *error)
{
    const struct options *options = given;
    if (options->frames > 0) {
        return render_frames(options, error);
    }
    char *path = picture_path(options);
    const bool ok = render_file(options, path, error);
    free(path);
    return ok;
}

static const struct options defaults = {.per_second = 25};

const struct option_command render_command = {
    .name = "render",
    .summary = "draw a scene file to a picture, PNG or PPM",
    .size = sizeof(struct options),
    .defaults = &defaults,
    .input = "scene",
    .needs = "a scene file and -o PICTURE are needed",
    .input_at = AT(scene),
    .output_at = AT(output),
    .options = all,
    .count = sizeof all / sizeof all[0],
    .usage = usage,
    .print_more = print_statements,
    .check = check,
    .run = run,
};
