/* SPDX-License-Identifier: MIT */
#include "model.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../io/file.h"
#include "../io/file_identity.h"
#include "../io/lines.h"
#include "../io/number.h"
#include "../io/obj_source.h"

/* ---- MTL ---- */

struct mtl_parser {
    const char *path;
    struct model *model;
    struct model_material *material; /* NULL: one that the model has not */
    int line;
    bool has_opacity;          /* the material has a d */
    size_t pictures, emissive; /* that are left out */
    struct text_error *error;
};

static bool fail(const struct mtl_parser *parser, const char *problem, const char *what)
{
    return text_error_set(parser->error, parser->path, parser->line, "%s%s", problem, what);
}

/* What is left of the line, without space around it. */
static struct token rest_of(struct line *line)
{
    while (line->at < line->end && text_is_space(*line->at)) {
        line->at++;
    }
    while (line->end > line->at && text_is_space(line->end[-1])) {
        line->end--;
    }
    struct token rest = {line->at, (size_t)(line->end - line->at)};
    return rest;
}

static void begin_material(struct mtl_parser *parser, struct line *line)
{
    struct token name = rest_of(line);
    parser->material = NULL;
    parser->has_opacity = false;
    for (size_t i = 0; i < parser->model->material_count; i++) {
        struct model_material *known = &parser->model->materials[i];
        size_t length = name.length < sizeof known->name ? name.length : sizeof known->name - 1;
        if (strlen(known->name) == length && memcmp(known->name, name.text, length) == 0) {
            parser->material = known;
        }
    }
}

/* Kd r g b, or Kd r for a gray; the colours of `spectral` and `xyz` are left as they are. */
static bool parse_color(struct mtl_parser *parser, struct line *line)
{
    struct token token;
    uint8_t color[3];
    int count = 0;
    for (; count < 3 && line_token(line, &token); count++) {
        double value;
        if (token_equals(&token, "spectral") || token_equals(&token, "xyz")) {
            return true;
        }
        if (number_parse_real(token.text, token.length, &value) != NUMBER_OK) {
            return fail(parser, "Kd needs numbers", "");
        }
        color[count] = (uint8_t)lround(255.0 * fmin(fmax(value, 0.0), 1.0));
    }
    if (count != 1 && count != 3) {
        return fail(parser, "Kd needs one or three numbers", "");
    }
    for (int i = 0; i < 3 && parser->material != NULL; i++) {
        parser->material->color[i] = color[count == 1 ? 0 : i];
    }
    return true;
}

/* d opacity, or d -halo opacity, of what is dense towards its edge: that is left as it is. */
static bool parse_opacity(struct mtl_parser *parser, struct line *line)
{
    struct token token;
    double value = 1.0;
    if (!line_token(line, &token) ||
        (!token_equals(&token, "-halo") &&
         number_parse_real(token.text, token.length, &value) != NUMBER_OK)) {
        return fail(parser, "d needs a number", "");
    }
    parser->has_opacity = true;
    if (parser->material != NULL && !token_equals(&token, "-halo")) {
        parser->material->opacity = (uint8_t)lround(255.0 * fmin(fmax(value, 0.0), 1.0));
    }
    return true;
}

/* Tr 1 - opacity, where there is no d. Programs write Tr 1 of what is not seen through at all. */
static bool parse_transparency(struct mtl_parser *parser, struct line *line)
{
    struct token token;
    double value = 0.0;
    if (!line_token(line, &token) ||
        number_parse_real(token.text, token.length, &value) != NUMBER_OK) {
        return fail(parser, "Tr needs a number", "");
    }
    if (parser->material != NULL && !parser->has_opacity && value > 0.0 && value < 1.0) {
        parser->material->opacity = (uint8_t)lround(255.0 * (1.0 - value));
    }
    return true;
}

/* How many tokens follow an option of map_Kd; -o, -s and -t take up to three numbers. */
static int option_length(const struct token *option)
{
    static const struct {
        const char *name;
        int length;
    } options[] = {{"-blendu", 1}, {"-blendv", 1}, {"-cc", 1},      {"-clamp", 1},     {"-mm", 2},
                   {"-o", -3},     {"-s", -3},     {"-t", -3},      {"-texres", 1},    {"-bm", 1},
                   {"-boost", 1},  {"-type", 1},   {"-imfchan", 1}, {"-colorspace", 1}};
    for (size_t i = 0; i < sizeof options / sizeof options[0]; i++) {
        if (token_equals(option, options[i].name)) {
            return options[i].length;
        }
    }
    return 0;
}

/* Leaves the line at the picture's name. */
static void skip_options(struct line *line)
{
    for (;;) {
        struct line ahead = *line;
        struct token token;
        if (!line_token(&ahead, &token) || option_length(&token) == 0) {
            return;
        }
        int length = option_length(&token);
        *line = ahead;
        for (int i = 0; i < (length < 0 ? -length : length); i++) {
            double value;
            if (!line_token(&ahead, &token) ||
                (length < 0 &&
                 number_parse_real(token.text, token.length, &value) == NUMBER_MALFORMED)) {
                break;
            }
            *line = ahead;
        }
    }
}

static bool parse_texture(struct mtl_parser *parser, struct line *line)
{
    char name[512];
    skip_options(line);
    struct token rest = rest_of(line);
    if (parser->material == NULL) {
        return true;
    }
    if (rest.length == 0 || rest.length >= sizeof name || memchr(rest.text, 0, rest.length)) {
        return fail(parser, "map_Kd needs the name of a picture", "");
    }
    for (size_t i = 0; i <= rest.length; i++) { /* some programs write folders of Windows */
        char c = '\0';
        if (i < rest.length) {
            c = rest.text[i];
        }
        name[i] = (char)(c == '\\' ? '/' : c);
    }
    model_picture_beside(parser->model, parser->material, parser->path, name);
    return true;
}

/* Statements of what no model has, of a material that the model has. */
static void count_left_out(struct mtl_parser *parser, const struct token *keyword,
                           const struct line *line)
{
    static const char *const pictures[] = {"map_Ka",   "map_Ks", "map_Ns", "map_d", "map_Ke",
                                           "map_Pr",   "map_Pm", "map_Ps", "norm",  "map_bump",
                                           "map_Bump", "bump",   "disp",   "decal", "refl"};
    struct line rest = *line;
    struct token token;
    if (parser->material == NULL) {
        return;
    }
    for (size_t i = 0; i < sizeof pictures / sizeof pictures[0]; i++) {
        parser->pictures += token_equals(keyword, pictures[i]) ? 1 : 0;
    }
    bool glows = false;
    while (token_equals(keyword, "Ke") && line_token(&rest, &token)) {
        double value = 0.0;
        (void)number_parse_real(token.text, token.length, &value);
        glows = glows || value > 0.0;
    }
    parser->emissive += glows ? 1 : 0;
}

bool model_parse_mtl(const char *path, const char *text, size_t length, struct model *model,
                     struct text_error *error)
{
    struct mtl_parser parser = {.path = path, .model = model, .error = error};
    struct line_reader reader;
    struct line line;
    bool ok = true;
    lines_begin(&reader, text, length, true);
    while (ok && lines_next(&reader, &line)) {
        struct token keyword;
        parser.line = line.number;
        if (!line_token(&line, &keyword)) {
            continue;
        }
        if (token_is_binary(&keyword)) {
            ok = fail(&parser, "is not text: is this an MTL file?", "");
        } else if (token_equals(&keyword, "newmtl")) {
            begin_material(&parser, &line);
        } else if (token_equals(&keyword, "Kd")) {
            ok = parse_color(&parser, &line);
        } else if (token_equals(&keyword, "d")) {
            ok = parse_opacity(&parser, &line);
        } else if (token_equals(&keyword, "Tr")) {
            ok = parse_transparency(&parser, &line);
        } else if (token_equals(&keyword, "map_Kd")) {
            ok = parse_texture(&parser, &line);
        } else {
            count_left_out(&parser, &keyword, &line);
        }
    }
    model_leave_out(model, parser.pictures, "picture of other things than colour",
                    "pictures of other things than colour");
    model_leave_out(model, parser.emissive, "emissive colour", "emissive colours");
    return ok;
}

static bool read_mtl(const char *obj, int line, const char *name, struct model *model,
                     struct text_error *error)
{
    char path[1024];
    struct file_content file;
    if (!file_path_beside(path, sizeof path, obj, name)) {
        return text_error_set(error, obj, line, "the name of the materials is too long");
    }
    if (file_inspect(path, NULL) == FILE_MISSING) {
        return text_error_set(error, obj, line, "there is no file %s; --plain does without", path);
    }
    if (!file_read(path, &file, error)) {
        return false;
    }
    bool ok = model_parse_mtl(path, file.bytes, file.length, model, error);
    free(file.bytes);
    return ok;
}

static bool is_beside(const char *obj, const struct token *name)
{
    char path[1024], text[1024];
    (void)snprintf(text, sizeof text, "%.*s", (int)name->length, name->text);
    return file_path_beside(path, sizeof path, obj, text) &&
           file_inspect(path, NULL) != FILE_MISSING;
}

/* mtllib takes several names; where the first is not there, its line is one name with spaces. */
static bool read_library(const char *obj, const struct obj_name *library, struct model *model,
                         struct text_error *error)
{
    const struct token whole = {library->text, strlen(library->text)};
    struct line line = {library->text, library->text + whole.length, library->line};
    struct token token;
    char name[1024];
    bool ok = true;
    if (is_beside(obj, &whole) || !line_token(&line, &token) || !is_beside(obj, &token)) {
        return read_mtl(obj, library->line, library->text, model, error);
    }
    do {
        (void)snprintf(name, sizeof name, "%.*s", (int)token.length, token.text);
        ok = read_mtl(obj, library->line, name, model, error);
    } while (ok && line_token(&line, &token));
    return ok;
}

/* ---- OBJ ---- */

static void copy_numbers(const struct obj_list *list, uint32_t index, int count, double *out)
{
    for (int i = 0; index != OBJ_ABSENT && i < count; i++) {
        out[i] = list->items[index][i];
    }
}

static void copy_vertex(const struct obj_source *source, size_t at, struct model_vertex *vertex)
{
    const struct obj_corner *corner = obj_vertex(source, at);
    const uint32_t *index = corner->index;
    copy_numbers(&source->lists[OBJ_POSITION], index[OBJ_POSITION], 3, vertex->position);
    copy_numbers(&source->lists[OBJ_NORMAL], index[OBJ_NORMAL], 3, vertex->normal);
    copy_numbers(&source->lists[OBJ_UV], index[OBJ_UV], 2, vertex->uv);
    for (int i = 0; i < 3; i++) {
        double color = source->colors.items[index[OBJ_POSITION]][i];
        vertex->color[i] = (uint8_t)lround(255.0 * color);
    }
    vertex->material = (uint16_t)corner->material;
}

static bool build(const struct obj_source *source, bool with_materials, struct model *model)
{
    size_t materials = with_materials ? source->materials.count : 1;
    if (!model_create(model, source->vertices.count, source->triangle_count, materials)) {
        return false;
    }
    for (size_t i = 0; i < source->vertices.count; i++) {
        copy_vertex(source, i, &model->vertices[i]);
        model->has_uvs = model->has_uvs || obj_vertex(source, i)->index[OBJ_UV] != OBJ_ABSENT;
        if (!with_materials) {
            model->vertices[i].material = 0;
        }
    }
    for (size_t i = 0; with_materials && i < materials; i++) {
        char *name = model->materials[i].name;
        snprintf(name, sizeof model->materials[i].name, "%s", source->materials.items[i].text);
    }
    memcpy(model->triangles, source->triangles, source->triangle_count * sizeof *model->triangles);
    model->has_colors = source->has_colors;
    return true;
}

bool model_parse_obj(const char *path, const char *text, size_t length, bool with_materials,
                     struct model *model, struct text_error *error)
{
    struct obj_source source = {.full = true};
    const struct obj_count *count = &source.count;
    memset(model, 0, sizeof *model);
    bool ok = obj_parse_source(path, text, length, &source, error);
    if (ok && !build(&source, with_materials, model)) {
        text_error_set(error, path, 0, "out of memory");
        ok = false;
    }
    if (ok) {
        model_leave_out(model, count->edges, "face of less than 3 corners",
                        "faces of less than 3 corners");
        model_leave_out(model, count->lines, "line", "lines");
        model_leave_out(model, count->points, "statement of points", "statements of points");
        model_leave_out(model, count->curved, "curve or curved surface",
                        "curves and curved surfaces");
    }
    for (size_t i = 0; ok && with_materials && i < source.libraries.count; i++) {
        ok = read_library(path, &source.libraries.items[i], model, error);
    }
    obj_source_free(&source);
    if (!ok) {
        model_free(model);
    }
    return ok;
}
