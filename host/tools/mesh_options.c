/* SPDX-License-Identifier: MIT */
#include "../io/file.h"
#include "mesh_options.h"

#include <stdlib.h>
#include <string.h>

#include "../assets/asset.h"
#include "mesh_generate.h"

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

static bool complain(const char *problem, const char *what)
{
    fprintf(stderr, "qtri mesh: %s%s\n", problem, what);
    return false;
}

static bool parse_whole(const char *text, long least, long most, long *out)
{
    char *end = NULL;
    long value = strtol(text, &end, 10);
    if (*text < '0' || *text > '9' || *end != '\0' || value < least || value > most) {
        return false;
    }
    *out = value;
    return true;
}

static bool parse_real(const char *text, double least, double most, double *out)
{
    char *end = NULL;
    double value = strtod(text, &end);
    if (end == text || *end != '\0' || !(value >= least && value <= most)) {
        return false;
    }
    *out = value;
    return true;
}

/* WxH, both 1..8192. */
static bool parse_size(const char *text, int *width, int *height)
{
    char *end = NULL;
    long first = strtol(text, &end, 10);
    long second = 0;
    if (*text < '0' || *text > '9' || *end != 'x' || first < 1 || first > QTRI_SURFACE_MAX ||
        !parse_whole(end + 1, 1, QTRI_SURFACE_MAX, &second)) {
        return false;
    }
    *width = (int)first;
    *height = (int)second;
    return true;
}

static bool is_identifier(const char *text)
{
    bool ok = *text != '\0' && strlen(text) < sizeof((struct mesh_options *)NULL)->name &&
              !(*text >= '0' && *text <= '9');
    for (; *text != '\0'; text++) {
        bool letter = (*text >= 'a' && *text <= 'z') || (*text >= 'A' && *text <= 'Z') ||
                      (*text >= '0' && *text <= '9') || *text == '_';
        ok = ok && letter;
    }
    return ok;
}

static bool parse_name(struct mesh_options *options, const char *text)
{
    if (!is_identifier(text)) {
        return false;
    }
    memcpy(options->name, text, strlen(text) + 1); /* is_identifier has measured it */
    return true;
}

/* The word after --normals; `smooth` takes the next argument too. */
static bool parse_normals(struct mesh_options *options, int argc, char **argv, int *at)
{
    static const char *const words[] = {"keep", "smooth", "flat", "none"};
    for (int i = 0; i < 4; i++) {
        if (strcmp(argv[*at], words[i]) == 0) {
            options->normals = (enum model_normals)i;
            if (options->normals != MODEL_NORMALS_SMOOTH) {
                return true;
            }
            return ++*at < argc && parse_real(argv[*at], 0.0, 180.0, &options->smooth_degrees);
        }
    }
    return false;
}

static bool parse_rows(struct mesh_options *options, const char *text)
{
    long rows = 0;
    bool ok = parse_whole(text, 1, QTRI_SURFACE_MAX, &rows);
    options->rows = (int)rows;
    return ok;
}

static bool parse_up(struct mesh_options *options, const char *text)
{
    options->up = text[0];
    return strcmp(text, "y") == 0 || strcmp(text, "z") == 0;
}

static bool set_value(struct mesh_options *options, const char *name, int argc, char **argv,
                      int *at)
{
    const char *value = argv[*at];
    if (strcmp(name, "-o") == 0) {
        options->output = value;
        return *value != '\0';
    }
    if (strcmp(name, "--panel") == 0) {
        return parse_size(value, &options->panel_width, &options->panel_height);
    }
    if (strcmp(name, "--rows") == 0) {
        return parse_rows(options, value);
    }
    if (strcmp(name, "--preview") == 0) {
        options->preview = value;
        return *value != '\0';
    }
    if (strcmp(name, "--name") == 0) {
        return parse_name(options, value);
    }
    options->is_changed = true;
    if (strcmp(name, "--fit") == 0) {
        return parse_real(value, 1e-3, 65534.0, &options->fit);
    }
    if (strcmp(name, "--up") == 0) {
        return parse_up(options, value);
    }
    if (strcmp(name, "--simplify") == 0) {
        return parse_whole(value, 1, (long)MODEL_MAX_TRIANGLES, &options->simplify);
    }
    return parse_normals(options, argc, argv, at);
}

static bool takes_value(const char *name)
{
    static const char *const names[] = {"-o",     "--fit",   "--up",   "--normals", "--simplify",
                                        "--name", "--panel", "--rows", "--preview"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        if (strcmp(name, names[i]) == 0) {
            return true;
        }
    }
    return false;
}

/* An option without a value; NULL: there is none of the name. */
static bool *find_flag(struct mesh_options *options, const char *name)
{
    const struct {
        const char *name;
        bool *flag;
    } flags[] = {{"--split", &options->split},   {"--compact", &options->compact},
                 {"--center", &options->center}, {"--colors", &options->colors},
                 {"--plain", &options->plain},   {"--no-faces", &options->no_faces}};
    for (size_t i = 0; i < sizeof flags / sizeof flags[0]; i++) {
        if (strcmp(name, flags[i].name) == 0) {
            return flags[i].flag;
        }
    }
    return NULL;
}

static bool parse_arguments(int argc, char **argv, struct mesh_options *options)
{
    for (int i = 1; i < argc; i++) {
        const char *argument = argv[i];
        bool *flag = find_flag(options, argument);
        if (flag != NULL) {
            *flag = true;
            options->is_changed = options->is_changed || flag != &options->split;
        } else if (takes_value(argument)) {
            if (++i == argc) {
                return complain("a value is missing after ", argument);
            }
            if (!set_value(options, argument, argc, argv, &i)) {
                return complain("this is no value for ", argument);
            }
        } else if (argument[0] == '-' && argument[1] != '\0') {
            return complain("unknown option ", argument);
        } else if (options->input != NULL) {
            return complain("one model at a time, please: ", argument);
        } else {
            options->input = argument;
        }
    }
    return true;
}

/* What the names say about input and output. */
static bool check_names(struct mesh_options *options)
{
    if (options->input == NULL || options->output == NULL) {
        return complain("a model and -o NAME.h are needed", "");
    }
    for (int i = 0; mesh_names[i] != NULL; i++) {
        options->is_generated = options->is_generated || strcmp(options->input, mesh_names[i]) == 0;
    }
    if (!options->is_generated && !model_is_file_name(options->input)) {
        return complain("neither a mesh that it makes nor .obj, .gltf, .glb, .stl or .ply: ",
                        options->input);
    }
    options->is_obj = file_name_ends_in(options->output, ".obj");
    if (strcmp(options->output, "-") != 0 && !options->is_obj &&
        !file_name_ends_in(options->output, ".h")) {
        return complain("the output is named neither .h nor .obj: ", options->output);
    }
    if (options->split && (options->is_obj || strcmp(options->output, "-") == 0)) {
        return complain("--split needs an output named .h", "");
    }
    if (options->name[0] == '\0') {
        const char *from = strcmp(options->output, "-") == 0 ? options->input : options->output;
        asset_identifier(from, options->name, sizeof options->name);
    }
    return options->name[0] != '\0' || complain("--name is needed", "");
}

bool mesh_options_parse(int argc, char **argv, struct mesh_options *options)
{
    memset(options, 0, sizeof *options);
    options->up = 'y';
    options->panel_width = 320;
    options->panel_height = 240;
    options->rows = 16;
    bool ok = parse_arguments(argc, argv, options) && check_names(options);
    if (ok && options->simplify > 0 && !model_can_simplify()) {
        ok = complain("this qtri was built without libmeshoptimizer and cannot --simplify", "");
    }
    if (!ok) {
        fputs("Try `qtri mesh --help`.\n", stderr);
    }
    return ok;
}
