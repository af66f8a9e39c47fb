/* SPDX-License-Identifier: MIT */
#include "mesh_options.h"

#include <string.h>

#include "../assets/asset.h"
#include "../io/file.h"
#include "../io/obj.h"
#include "commands.h"
#include "mesh_generate.h"

static const char mesh_usage[] =
    "usage: qtri mesh IN -o NAME.h [OPTION ...]\n"
    "\n"
    "Makes constant data for qtri_draw_mesh of a model: a header that C99 and C++11 compile, or "
    "an\n"
    "OBJ file where the output is named so. IN is a file named .obj, .gltf, .glb, .stl or .ply, "
    "or\n"
    "- for standard input; -o - is standard output.\n"
    "\n"
    "  --compact          16-bit positions and texture coordinates, 8-bit normals and indices\n"
    "  --center           the middle of the model's box becomes the origin\n"
    "  --colors           colours of materials and vertices become vertex colours of one mesh;\n"
    "                     without, there is one mesh a material\n";

static const char model_usage[] =
    "usage: qtri model IN -o NAME.h [OPTION ...]\n"
    "\n"
    "Makes all of a model that the core can draw: meshes, their materials and textures, and what\n"
    "moves, in one header that C99 and C++11 compile; the program at its top draws it. IN is a "
    "file\n"
    "named .obj, .gltf, .glb, .stl or .ply, or - for standard input; -o - is standard output. The\n"
    "model is centred, its largest side 2, its data compact.\n"
    "\n"
    "  --texture FILE     the picture of materials that name none\n"
    "  --texture-side N   larger textures are scaled to N x N or less (default 256)\n"
    "  --format FORMAT    of textures: rgb565 (default), palette (256 colours),\n"
    "                       palette565 (256 of RGB565), gray8, xrgb8888\n"
    "  --dither           of textures: spread rounding errors over neighbours\n"
    "  --mipmaps          of textures: levels of half the size each\n"
    "  --in-place         where and as large as it is in the file\n"
    "  --wide             32-bit positions, 16-bit normals and indices\n";

static const char usage[] =
    "  --fit SIZE         scale: the largest side of the model's box becomes SIZE\n"
    "  --scale FACTOR     scale by a factor: .001 makes metres of millimetres\n"
    "  --up y|z           the file's axis that points up (default y)\n"
    "  --normals keep     those of the file; where it has none, smooth 45 (default)\n"
    "  --normals smooth DEGREES   smooth where faces meet at less than DEGREES\n"
    "  --normals flat     those of faces; --normals none, without any, looks the same and is "
    "smaller\n"
    "  --plain            one mesh; materials and pictures are not looked for\n"
    "  --simplify N       at most about N triangles\n"
    "  --no-faces         without the planes that let back faces be culled early\n"
    "  --keep-order       triangles in the order of the file, not in that of the vertex cache\n"
    "  --name NAME        in C (default: the output's, the input's)\n"
    "  --split            declarations in NAME.h, data in NAME.c\n"
    "  --panel WxH        the display for which RAM is counted (default 320x240)\n"
    "  --rows N           of a band of it (default 16)\n"
    "  --flash N, --ram N   bytes, or kilobytes as in 256K: an error where it takes more\n"
    "  --preview FILE     a picture, .png or .ppm, drawn with the core\n"
    "\n"
    "In place of IN one of these is generated:";

/* What both commands' --help has in common. */
static void print_more(void)
{
    fputs(usage, stdout);
    for (int i = 0; mesh_names[i] != NULL; i++) {
        printf(" %s", mesh_names[i]);
    }
    putchar('\n');
}

static bool set_panel(void *options, const char *value, struct option_words *more)
{
    struct mesh_options *o = (struct mesh_options *)options;
    (void)more;
    return option_size(value, QTRI_SURFACE_MAX, &o->panel_width, &o->panel_height);
}

/* The word after --normals; `smooth` takes the next one too. */
static bool set_normals(void *options, const char *value, struct option_words *more)
{
    static const char *const words[] = {"keep", "smooth", "flat", "none"};
    struct mesh_options *o = (struct mesh_options *)options;
    for (int i = 0; i < 4; i++) {
        if (strcmp(value, words[i]) == 0) {
            const char *degrees = i == MODEL_NORMALS_SMOOTH ? option_next(more) : "0";
            o->normals = (enum model_normals)i;
            return degrees != NULL && option_real(degrees, 0.0, 180.0, &o->smooth_degrees);
        }
    }
    return false;
}

#define AT(member) offsetof(struct mesh_options, member)

static const char *const axes[] = {"y", "z"};

/* clang-format off */
static const struct option all_options[] = {
    /* of `qtri mesh` */
    {"--compact", OPTION_FLAG, AT(compact), {NULL}},
    {"--center", OPTION_FLAG, AT(center), {NULL}},
    {"--colors", OPTION_FLAG, AT(colors), {NULL}},
    /* of both */
    {"-o", OPTION_TEXT, AT(output), {NULL}},
    {"--preview", OPTION_TEXT, AT(preview), {NULL}},
    {"--name", OPTION_NAME, AT(name), {NULL}},
    {"--panel", OPTION_SET, 0, {.set = set_panel}},
    {"--rows", OPTION_WHOLE, AT(rows), {.range = {1, QTRI_SURFACE_MAX}}},
    {"--flash", OPTION_BYTES, AT(most_flash), {NULL}},
    {"--ram", OPTION_BYTES, AT(most_ram), {NULL}},
    {"--fit", OPTION_REAL, AT(fit), {.range = {1e-3, 65534.0}}},
    {"--scale", OPTION_REAL, AT(scale), {.range = {OBJ_SCALE_MIN, OBJ_SCALE_MAX}}},
    {"--up", OPTION_WORD, AT(up), {.words = {axes, 2}}},
    {"--simplify", OPTION_WHOLE, AT(simplify), {.range = {1, MODEL_MAX_TRIANGLES}}},
    {"--normals", OPTION_SET, 0, {.set = set_normals}},
    {"--split", OPTION_FLAG, AT(split), {NULL}},
    {"--plain", OPTION_FLAG, AT(plain), {NULL}},
    {"--no-faces", OPTION_FLAG, AT(no_faces), {NULL}},
    {"--keep-order", OPTION_FLAG, AT(keep_order), {NULL}},
    /* of `qtri model` */
    {"--texture", OPTION_TEXT, AT(skin), {NULL}},
    {"--texture-side", OPTION_WHOLE, AT(most.width), {.range = {1, TEXTURE_MAX_SIDE}}},
    {"--format", OPTION_WORD, AT(most.format), {.words = {texture_format_names, TEXTURE_FORMATS}}},
    {"--dither", OPTION_FLAG, AT(most.dither), {NULL}},
    {"--mipmaps", OPTION_FLAG, AT(most.mipmaps), {NULL}},
    {"--in-place", OPTION_FLAG, AT(in_place), {NULL}},
    {"--wide", OPTION_FLAG, AT(wide), {NULL}},
};
/* clang-format on */

enum { ALL_OPTIONS = sizeof all_options / sizeof all_options[0], MESH_ONLY = 3, MODEL_ONLY = 7 };

/* Whether an option asks for more than a generated mesh's text. */
static bool is_changed(const struct mesh_options *o)
{
    return o->compact || o->center || o->colors || o->plain || o->no_faces || o->fit > 0.0 ||
           o->scale > 0.0 || o->up != 0 || o->simplify > 0 || o->normals != MODEL_NORMALS_KEEP;
}

/* What the names say about input and output. */
static bool check_names(const struct option_command *command, struct mesh_options *options)
{
    for (int i = 0; mesh_names[i] != NULL; i++) {
        options->is_generated = options->is_generated || strcmp(options->input, mesh_names[i]) == 0;
    }
    if (!options->is_generated && !model_is_file_name(options->input)) {
        return options_complain(
            command,
            "neither a mesh that it makes nor .obj, .gltf, .glb, .stl or .ply: ", options->input);
    }
    options->is_obj = file_name_ends_in(options->output, ".obj");
    if (strcmp(options->output, "-") != 0 && (!options->is_obj || options->is_model) &&
        !file_name_ends_in(options->output, ".h")) {
        return options_complain(command,
                                options->is_model ? "the output is not named .h: "
                                                  : "the output is named neither .h nor .obj: ",
                                options->output);
    }
    if (options->in_place && (options->fit > 0.0 || options->scale > 0.0)) {
        return options_complain(command, "--in-place, --fit and --scale exclude each other", "");
    }
    if (options->fit > 0.0 && options->scale > 0.0) {
        return options_complain(command, "--fit and --scale exclude each other", "");
    }
    if (options->split && (options->is_obj || strcmp(options->output, "-") == 0)) {
        return options_complain(command, "--split needs an output named .h", "");
    }
    options->is_changed = is_changed(options);
    return options_default_name(command, options->input, options->output, options->name);
}

/* What `qtri model` does unless it is told otherwise. */
static void set_model_defaults(struct mesh_options *options)
{
    options->compact = !options->wide;
    options->center = !options->in_place;
    if (!options->in_place && options->fit == 0.0 && options->scale == 0.0) {
        options->fit = 2.0;
    }
}

static bool check(const struct option_command *command, void *given)
{
    struct mesh_options *options = given;
    if (!check_names(command, options)) {
        return false;
    }
    if (options->simplify > 0 && !model_can_simplify()) {
        return options_complain(
            command, "this qtri was built without libmeshoptimizer and cannot --simplify", "");
    }
    options->most.height = options->most.width;
    options->rows = options->rows < options->panel_height ? options->rows : options->panel_height;
    if (options->is_model) {
        set_model_defaults(options);
    }
    return true;
}

static const struct mesh_options mesh_defaults = {
    .panel_width = 320, .panel_height = 240, .rows = 16};
static const struct mesh_options model_defaults = {
    .panel_width = 320, .panel_height = 240, .rows = 16, .is_model = true, .most = {.width = 256}};

#define OF_BOTH                                                                                    \
    .input = "model", .needs = "a model and -o NAME.h are needed", .input_at = AT(input),          \
    .output_at = AT(output), .size = sizeof(struct mesh_options), .print_more = print_more,        \
    .check = check

const struct option_command mesh_command = {
    OF_BOTH,
    .name = "mesh",
    .summary = "make C data of a model, or of a mesh that it generates",
    .defaults = &mesh_defaults,
    .options = all_options,
    .count = ALL_OPTIONS - MODEL_ONLY,
    .usage = mesh_usage,
    .run = mesh_run,
};

const struct option_command model_command = {
    OF_BOTH,
    .name = "model",
    .summary = "make C data of a whole model: meshes, textures, materials, motion",
    .defaults = &model_defaults,
    .options = all_options + MESH_ONLY,
    .count = ALL_OPTIONS - MESH_ONLY,
    .usage = model_usage,
    .run = model_run,
};
