/* SPDX-License-Identifier: MIT */
#include "../io/file.h"
#include "mesh_options.h"

#include <string.h>

#include "../assets/asset.h"
#include "../io/obj.h"
#include "mesh_generate.h"
#include "options.h"

static const char usage[] =
    "usage: qtri mesh IN -o NAME.h [OPTION ...]\n"
    "\n"
    "Makes constant data for qtri_draw_mesh of a model: a header that C99 and C++11 compile, or "
    "an\n"
    "OBJ file where the output is named so. IN is a file named .obj, .gltf, .glb, .stl or .ply, "
    "or\n"
    "- for standard input; -o - is standard output.\n"
    "\n"
    "  --compact          16-bit positions and texture coordinates, 8-bit normals and indices\n"
    "  --fit SIZE         scale: the largest side of the model's box becomes SIZE\n"
    "  --scale FACTOR     scale by a factor: .001 makes metres of millimetres\n"
    "  --center           the middle of the model's box becomes the origin\n"
    "  --up y|z           the file's axis that points up (default y)\n"
    "  --normals keep     those of the file; smooth where it has none (default)\n"
    "  --normals smooth DEGREES   smooth where faces meet at less than DEGREES\n"
    "  --normals flat     those of faces; --normals none, without any, looks the same and is "
    "smaller\n"
    "  --colors           colours of materials and vertices become vertex colours of one mesh;\n"
    "                     without, there is one mesh a material\n"
    "  --plain            one mesh; materials and pictures are not looked for\n"
    "  --simplify N       at most about N triangles\n"
    "  --no-faces         without the planes that let back faces be culled early\n"
    "  --name NAME        of the qtri_mesh (default: the output's, the input's)\n"
    "  --split            declarations in NAME.h, data in NAME.c\n"
    "  --panel WxH        the display for which RAM is counted (default 320x240)\n"
    "  --rows N           of a band of it (default 16)\n"
    "  --preview FILE     a picture, .png or .ppm, drawn with the core\n"
    "\n"
    "In place of IN one of these is generated:";

void mesh_options_help(FILE *out)
{
    fputs(usage, out);
    for (int i = 0; mesh_names[i] != NULL; i++) {
        fprintf(out, " %s", mesh_names[i]);
    }
    fputc('\n', out);
}

static bool set_panel(void *options, const char *value, struct option_words *more)
{
    struct mesh_options *o = (struct mesh_options *)options;
    (void)more;
    return option_size(value, QTRI_SURFACE_MAX, &o->panel_width, &o->panel_height);
}

static bool set_rows(void *options, const char *value, struct option_words *more)
{
    long rows = 0;
    (void)more;
    bool ok = option_whole(value, 1, QTRI_SURFACE_MAX, &rows);
    ((struct mesh_options *)options)->rows = (int)rows;
    return ok;
}

static bool set_fit(void *options, const char *value, struct option_words *more)
{
    (void)more;
    return option_real(value, 1e-3, 65534.0, &((struct mesh_options *)options)->fit);
}

static bool set_scale(void *options, const char *value, struct option_words *more)
{
    (void)more;
    return option_real(value, OBJ_SCALE_MIN, OBJ_SCALE_MAX,
                       &((struct mesh_options *)options)->scale);
}

static bool set_up(void *options, const char *value, struct option_words *more)
{
    (void)more;
    ((struct mesh_options *)options)->up = value[0];
    return strcmp(value, "y") == 0 || strcmp(value, "z") == 0;
}

static bool set_simplify(void *options, const char *value, struct option_words *more)
{
    (void)more;
    return option_whole(value, 1, (long)MODEL_MAX_TRIANGLES,
                        &((struct mesh_options *)options)->simplify);
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

/* clang-format off */
static const struct option options_of_mesh[] = {
    {"-o", OPTION_TEXT, AT(output), NULL},
    {"--preview", OPTION_TEXT, AT(preview), NULL},
    {"--name", OPTION_NAME, AT(name), NULL},
    {"--panel", OPTION_SET, 0, set_panel},
    {"--rows", OPTION_SET, 0, set_rows},
    {"--fit", OPTION_SET, 0, set_fit},
    {"--scale", OPTION_SET, 0, set_scale},
    {"--up", OPTION_SET, 0, set_up},
    {"--simplify", OPTION_SET, 0, set_simplify},
    {"--normals", OPTION_SET, 0, set_normals},
    {"--split", OPTION_FLAG, AT(split), NULL},
    {"--compact", OPTION_FLAG, AT(compact), NULL},
    {"--center", OPTION_FLAG, AT(center), NULL},
    {"--colors", OPTION_FLAG, AT(colors), NULL},
    {"--plain", OPTION_FLAG, AT(plain), NULL},
    {"--no-faces", OPTION_FLAG, AT(no_faces), NULL},
};
/* clang-format on */

static const struct option_list list = {"mesh", "model", offsetof(struct mesh_options, input),
                                        options_of_mesh,
                                        sizeof options_of_mesh / sizeof options_of_mesh[0]};

/* Whether an option asks for more than a generated mesh's text. */
static bool is_changed(const struct mesh_options *o)
{
    return o->compact || o->center || o->colors || o->plain || o->no_faces || o->fit > 0.0 ||
           o->scale > 0.0 || o->up != 'y' || o->simplify > 0 || o->normals != MODEL_NORMALS_KEEP;
}

/* What the names say about input and output. */
static bool check_names(struct mesh_options *options)
{
    if (options->input == NULL || options->output == NULL) {
        return options_complain(&list, "a model and -o NAME.h are needed", "");
    }
    for (int i = 0; mesh_names[i] != NULL; i++) {
        options->is_generated = options->is_generated || strcmp(options->input, mesh_names[i]) == 0;
    }
    if (!options->is_generated && !model_is_file_name(options->input)) {
        return options_complain(
            &list,
            "neither a mesh that it makes nor .obj, .gltf, .glb, .stl or .ply: ", options->input);
    }
    options->is_obj = file_name_ends_in(options->output, ".obj");
    if (strcmp(options->output, "-") != 0 && !options->is_obj &&
        !file_name_ends_in(options->output, ".h")) {
        return options_complain(&list,
                                "the output is named neither .h nor .obj: ", options->output);
    }
    if (options->fit > 0.0 && options->scale > 0.0) {
        return options_complain(&list, "--fit and --scale exclude each other", "");
    }
    if (options->split && (options->is_obj || strcmp(options->output, "-") == 0)) {
        return options_complain(&list, "--split needs an output named .h", "");
    }
    options->is_changed = is_changed(options);
    return options_default_name(&list, options->input, options->output, options->name);
}

bool mesh_options_parse(int argc, char **argv, struct mesh_options *options)
{
    memset(options, 0, sizeof *options);
    options->up = 'y';
    options->panel_width = 320;
    options->panel_height = 240;
    options->rows = 16;
    bool ok = options_parse(&list, options, argc, argv) && check_names(options);
    if (ok && options->simplify > 0 && !model_can_simplify()) {
        ok = options_complain(
            &list, "this qtri was built without libmeshoptimizer and cannot --simplify", "");
    }
    if (!ok) {
        fputs("Try `qtri mesh --help`.\n", stderr);
    }
    return ok;
}
