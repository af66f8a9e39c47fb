/* SPDX-License-Identifier: MIT */
/*
 * Which pipelines a scene asks for. It is drawn by a generic pipeline that notes the options of
 * each draw; a pixel function, which the options have then, counts the pixels.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../core/draw/primitive.h"
#include "../../core/raster/descriptions.h"
#include "../../core/raster/draw_state.h"
#include "../../core/raster/samples.h"
#include "commands.h"
#include "scene_draw.h"

#include <qtri/body/large.h>
#include <qtri/body/small_triangle.h>

static const char usage[] =
    "usage: qtri pipelines SCENE [OPTION ...]\n"
    "\n"
    "Draws the scene file SCENE (-: standard input) and prints, as C, a QTRI_PIPELINE for each "
    "set\n"
    "of options that its triangles ask for (qtri/pipeline.h), in the order of the pixels they "
    "drew,\n"
    "and a list of them. A comment says how many triangles and pixels that was, and whether the\n"
    "library has such a pipeline or the generic one draws them.\n"
    "\n"
    "  --format FORMAT  rgb565 (default), rgb565_swapped, rgb888, xrgb8888 or gray8: the "
    "surface's\n"
    "  --name NAME      of the list, and NAME_1, NAME_2 ... of pipelines (default: scene)\n"
    "  --allow-files    read meshes and textures wherever the scene says they are\n";

struct options {
    const char *scene;
    int format; /* of displays */
    bool allow_files;
    char name[OPTION_NAME_SIZE];
};

static const char *const display_names[] = {"rgb565", "rgb565_swapped", "rgb888", "xrgb8888",
                                            "gray8"};
static const qtri_format *const displays[] = {&qtri_rgb565, &qtri_rgb565_swapped, &qtri_rgb888,
                                              &qtri_xrgb8888, &qtri_gray8};

/* Noting -------------------------------------------------------------------------------------- */

enum { MOST = 64 }; /* a scene has one texture and one blend: a few */

struct asked {
    qtri_options options; /* without the pixel function that counts */
    unsigned long long triangles, pixels;
};

static struct asked asked[MOST];
static size_t asked_count;
static unsigned long long pixels; /* so far */

static bool count_pixel(qtri_fragment *fragment)
{
    (void)fragment;
    pixels++;
    return true;
}

/* Those that numbers tell. */
static bool are_equal(const qtri_options *a, const qtri_options *b)
{
    return memcmp(a, b, offsetof(qtri_options, pixel_bytes)) == 0;
}

/* The last one takes what is too many. */
static struct asked *asked_for(const qtri_options *options)
{
    size_t i = 0;
    while (i < asked_count && i < MOST - 1 && !are_equal(&asked[i].options, options)) {
        i++;
    }
    if (i == asked_count) {
        asked_count++;
        asked[i].options = *options;
        asked[i].options.fragment = NULL;
    }
    return &asked[i];
}

static void note(const qtri_options *options, unsigned long long before)
{
    struct asked *a = asked_for(options);
    a->pixels += pixels - before;
    a->triangles += pixels != before;
}

static const qtri_pipeline *generic_of(const qtri_options *options)
{
    return options->samples != 0 ? &qtri_pipeline_any_x4 : &qtri_pipeline_any;
}

static void large(const struct qtri_large_input *triangle)
{
    const unsigned long long before = pixels;
    const qtri_options *options = &triangle->state->options;
    generic_of(options)->large(triangle);
    note(options, before);
}

static bool small(struct qtri_small *triangle)
{
    const unsigned long long before = pixels;
    const qtri_options *options = &triangle->state->options;
    const bool is_drawn = generic_of(options)->small(triangle);
    if (is_drawn) {
        note(options, before);
    }
    return is_drawn;
}

static const qtri_pipeline *choose(const qtri_pipeline *noting, qtri_draw_state *state)
{
    return generic_of(&state->options)->choose(noting, state);
}

static const qtri_pipeline noting = {
    .options = {.format = QTRI_ANY}, .large = large, .small = small, .choose = choose};
static const qtri_pipeline noting_x4 = {.options = {.format = QTRI_ANY, .samples = 4},
                                        .large = large,
                                        .small = small,
                                        .choose = choose};
static const qtri_pipeline *const noting_list[] = {&noting_x4, &noting, NULL};
static const struct scene_pipelines noting_pipelines = {noting_list, count_pixel};

/* Printing ------------------------------------------------------------------------------------ */

static const char *const format_names[] = {
    "QTRI_OTHER_FORMAT", "QTRI_RGB565",   "QTRI_RGB565_SWAPPED", "QTRI_RGB565_EXACT", "QTRI_RGB888",
    "QTRI_BGR888",       "QTRI_XRGB8888", "QTRI_GRAY8",          "QTRI_DEPTH_ONLY"};
static const char *const depth_names[] = {
    NULL, "QTRI_LINEAR16", "QTRI_FLOAT16", "QTRI_LINEAR24", "QTRI_LINEAR32", "QTRI_OTHER_DEPTH"};
static const char *const compare_names[] = {
    NULL,           "QTRI_NEVER",     "QTRI_LESS",          "QTRI_EQUAL", "QTRI_LESS_EQUAL",
    "QTRI_GREATER", "QTRI_NOT_EQUAL", "QTRI_GREATER_EQUAL", "QTRI_ALWAYS"};
static const char *const texel_names[] = {NULL,
                                          "QTRI_TEXEL_RGB565",
                                          "QTRI_TEXEL_XRGB8888",
                                          "QTRI_TEXEL_GRAY8",
                                          "QTRI_TEXEL_PALETTE8",
                                          "QTRI_TEXEL_PALETTE565",
                                          "QTRI_TEXEL_CHECKER",
                                          "QTRI_TEXEL_ARGB8888",
                                          "QTRI_TEXEL_ARGB4444",
                                          "QTRI_TEXEL_ARGB1555",
                                          "QTRI_TEXEL_ALPHA8",
                                          "QTRI_OTHER_TEXEL"};
static const char *const shade_names[] = {NULL, "QTRI_TINT", "QTRI_LIGHT", "QTRI_WHITE_LIGHT",
                                          "QTRI_COLORS"};
static const char *const blend_names[] = {
    NULL, "QTRI_ALPHA", "QTRI_ADD", "QTRI_MULTIPLY", "QTRI_KEEP_PIXEL", "QTRI_SCREEN_DOOR"};

/* Fields of qtri_options that are numbers: 0 is not printed, nor where there is a name that is
 * NULL. */
static const struct {
    const char *name;
    size_t at;
    const char *const *names; /* NULL: the number itself */
} fields[] = {
#define FIELD(field, names)                                                                        \
    {                                                                                              \
#field, offsetof(qtri_options, field), names                                               \
    }
    FIELD(format, format_names), FIELD(depth, depth_names), FIELD(compare, compare_names),
    FIELD(read_only, NULL),      FIELD(texel, texel_names), FIELD(bilinear, NULL),
    FIELD(mipmapped, NULL),      FIELD(key, NULL),          FIELD(alpha_test, NULL),
    FIELD(shade, shade_names),   FIELD(blend, blend_names), FIELD(vertex_alpha, NULL),
    FIELD(keep, NULL),           FIELD(fog, NULL),          FIELD(samples, NULL),
    FIELD(large_texture, NULL),  FIELD(per_pixel, NULL),
#undef FIELD
};

static void print_options(const qtri_options *options)
{
    int count = 0;
    for (size_t i = 0; i < sizeof fields / sizeof fields[0]; i++) {
        const uint8_t value = ((const uint8_t *)options)[fields[i].at];
        if (value != 0) {
            fputs(count++ % 3 == 2 ? ",\n              " : ", ", stdout);
            printf(".%s = ", fields[i].name);
            if (fields[i].names != NULL) {
                fputs(fields[i].names[value], stdout);
            } else {
                printf("%d", value);
            }
        }
    }
}

static bool has(const qtri_pipeline *const *pipelines, const qtri_options *options)
{
    while (*pipelines != NULL && !are_equal(&(*pipelines)->options, options)) {
        pipelines++;
    }
    return *pipelines != NULL;
}

/* Blends, fog, the filter and formats of depth. Those they bring serve read-only depths and others.
 */
static bool is_brought(const qtri_options *options)
{
    const qtri_pipeline *const *const lists[] = {
        qtri_effect_pipelines(qtri_blend_alpha.effect),
        qtri_effect_pipelines(qtri_blend_add.effect),
        qtri_effect_pipelines(qtri_blend_multiply.effect),
        qtri_pipelines_fog,
        qtri_effect_pipelines(qtri_bilinear.effect),
        qtri_effect_pipelines(qtri_depth_float16.effect),
        qtri_effect_pipelines(qtri_depth_linear24.effect),
        qtri_effect_pipelines(qtri_depth_linear32.effect),
    };
    qtri_options wanted = *options;
    bool found = false;
    wanted.read_only = QTRI_ANY;
    for (size_t i = 0; i < sizeof lists / sizeof lists[0] && !found; i++) {
        found = lists[i] != NULL && has(lists[i], &wanted);
    }
    return found;
}

static const char *where_it_is(const qtri_options *options, const qtri_format *format)
{
    return has(qtri_pipelines_default, options)    ? "qtri_pipelines_default has one"
           : has(qtri_pipelines_swapped, options)  ? "qtri_pipelines_swapped has one"
           : has(qtri_pipelines_by_pixel, options) ? "qtri_per_pixel brings one"
           : is_brought(options)                   ? "the blend, fog, filter or depths bring one"
           : options->samples != 0 && has(qtri_sampling_of(format)->pipelines, options)
               ? "the surface's format brings one"
               : "the generic one draws it";
}

static void print(const struct options *o, const qtri_format *format)
{
    puts("#include <qtri/pipeline_make.h>\n");
    for (size_t i = 0; i < asked_count; i++) {
        const struct asked *a = &asked[i];
        printf("/* %llu triangles, %llu pixels; %s */\n", a->triangles, a->pixels,
               where_it_is(&a->options, format));
        printf("QTRI_PIPELINE(%s_%zu", o->name, i + 1);
        print_options(&a->options);
        puts(")\n");
    }
    printf("const qtri_pipeline *const %s[] = {", o->name);
    for (size_t i = 0; i < asked_count; i++) {
        printf("&%s_%zu, ", o->name, i + 1);
    }
    puts("NULL};");
}

static int by_pixels(const void *a, const void *b)
{
    const unsigned long long x = ((const struct asked *)a)->pixels;
    const unsigned long long y = ((const struct asked *)b)->pixels;
    return (x < y) - (x > y);
}

/* ---- The command ---- */

#define AT(member)      offsetof(struct options, member)
#define COUNT_OF(array) (sizeof(array) / sizeof(array)[0])

static const struct option all[] = {
    {"--format", OPTION_WORD, AT(format), {.words = {display_names, COUNT_OF(display_names)}}},
    {"--name", OPTION_NAME, AT(name), {NULL}},
    {"--allow-files", OPTION_FLAG, AT(allow_files), {NULL}},
};

static bool run(void *given, struct text_error *error)
{
    const struct options *options = given;
    const qtri_format *format = displays[options->format];
    struct scene scene;
    struct picture picture;
    const struct scene_reading how = {.below = !options->allow_files};
    if (!scene_read_as(options->scene, &how, &scene, error)) {
        return false;
    }
    const bool is_drawn = scene_render_by(&scene, format, &noting_pipelines, &picture);
    const bool has_samples = scene.antialias == SCENE_ANTIALIAS_MSAA;
    scene_free(&scene);
    if (!is_drawn) {
        (void)snprintf(error->message, sizeof error->message, "out of memory");
        return false;
    }
    picture_free(&picture);
    if (asked_count == 0) {
        return text_error_set(error, options->scene, 0, "no triangle is drawn");
    }
    qsort(asked, asked_count, sizeof asked[0], by_pixels);
    print(options, has_samples ? scene_sampled_format(format) : format);
    return true;
}

static const struct options defaults = {.name = "scene"};

const struct option_command pipelines_command = {
    .name = "pipelines",
    .summary = "print the pipelines that a scene file asks for, as C",
    .size = sizeof(struct options),
    .defaults = &defaults,
    .input = "scene",
    .needs = "a scene file is needed",
    .input_at = AT(scene),
    .output_at = AT(scene),
    .options = all,
    .count = sizeof all / sizeof all[0],
    .usage = usage,
    .run = run,
};
