/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "obj.h"

#include <stdlib.h>
#include <string.h>

#include "array.h"
#include "file.h"
#include "lines.h"
#include "number.h"
#include "obj_source.h"

#define ONE 65536

struct obj_parser {
    const char *name;
    struct text_error *error;
    int line;
    struct obj_source source;
    /* Faces may name elements that follow; the largest such index is checked at the end. */
    struct {
        uint32_t index; /* 1-based, 0: none */
        int line;
    } forward[OBJ_ATTRIBUTES];
};

static const char *const attribute_names[OBJ_ATTRIBUTES] = {"v", "vt", "vn"};

static bool fail(const struct obj_parser *parser, const char *sentence)
{
    text_error_set(parser->error, parser->name, parser->line, "%s", sentence);
    return false;
}

static bool fail_token(const struct obj_parser *parser, const struct token *token,
                       const char *problem)
{
    char quoted[TOKEN_QUOTE_SIZE];
    text_error_set(parser->error, parser->name, parser->line, "'%s' %s", token_quote(token, quoted),
                   problem);
    return false;
}

/* ---- v, vt, vn ---- */

struct obj_numbers {
    int needed;   /* numbers that must be there */
    int kept;     /* numbers that are stored; 0 for those that are not there */
    int accepted; /* further ones are checked to be numbers and dropped */
};

/* v: x y z [w] [r g b]. vt: u [v] [w]. */
static const struct obj_numbers number_statements[] = {
    [OBJ_POSITION] = {3, 3, 7},
    [OBJ_UV] = {1, 2, 3},
    [OBJ_NORMAL] = {3, 3, 3},
};

static bool read_numbers(struct obj_parser *parser, struct line *line,
                         const struct obj_numbers *shape, int32_t out[3])
{
    struct token token;
    int count = 0;
    for (; line_token(line, &token); count++) {
        if (count == shape->accepted) {
            return fail_token(parser, &token, "is more than the statement takes");
        }
        int32_t value;
        enum number_result result = number_parse_q16(token.text, token.length, &value);
        if (result == NUMBER_MALFORMED || (result != NUMBER_OK && count < shape->kept)) {
            return fail_token(parser, &token, number_problem(result));
        }
        if (count < shape->kept) {
            out[count] = value;
        }
    }
    return count >= shape->needed || fail(parser, "too few numbers");
}

static bool parse_numbers(struct obj_parser *parser, struct line *line,
                          enum obj_attribute attribute)
{
    int32_t numbers[3] = {0, 0, 0};
    if (!read_numbers(parser, line, &number_statements[attribute], numbers)) {
        return false;
    }
    if (attribute == OBJ_UV) { /* the file counts v from a picture's last row */
        if (numbers[1] < ONE - INT32_MAX) {
            return fail(parser, "1 - v does not fit Q16.16");
        }
        numbers[1] = ONE - numbers[1];
    }
    struct obj_list *list = &parser->source.lists[attribute];
    int32_t(*grown)[3] = array_grow(list->items, list->count, &list->capacity, sizeof *grown);
    if (grown == NULL || list->count >= OBJ_MAX_COUNT) {
        return fail(parser, "out of memory");
    }
    list->items = grown;
    memcpy(grown[list->count++], numbers, sizeof numbers);
    return true;
}

/* ---- f ---- */

/* Turns the text of an index into a 0-based one. */
static bool parse_index(struct obj_parser *parser, const struct token *corner,
                        enum obj_attribute attribute, const struct token *text, uint32_t *index)
{
    int64_t count = (int64_t)parser->source.lists[attribute].count;
    int64_t value;
    enum number_result result =
        number_parse_integer(text->text, text->length, -count, (int64_t)OBJ_MAX_COUNT, &value);
    if (result == NUMBER_MALFORMED) {
        return fail_token(parser, corner, "is not a corner (v, v/vt, v//vn or v/vt/vn)");
    }
    if (result == NUMBER_OUT_OF_RANGE) {
        return fail_token(parser, corner, "has an index out of range");
    }
    if (value == 0) {
        return fail_token(parser, corner, "has the index 0; they count from 1");
    }
    *index = (uint32_t)(value < 0 ? count + value : value - 1);
    if (value > count && value > parser->forward[attribute].index) {
        parser->forward[attribute].index = (uint32_t)value;
        parser->forward[attribute].line = parser->line;
    }
    return true;
}

static bool parse_corner(struct obj_parser *parser, const struct token *token,
                         struct obj_corner *corner)
{
    const char *at = token->text;
    const char *end = at + token->length;
    for (int i = 0; i < OBJ_ATTRIBUTES; i++) {
        corner->index[i] = OBJ_ABSENT;
    }
    for (int i = 0; i < OBJ_ATTRIBUTES; i++) {
        const char *slash = memchr(at, '/', (size_t)(end - at));
        struct token text = {at, (size_t)((slash != NULL ? slash : end) - at)};
        bool left_out = i == OBJ_UV && text.length == 0 && slash != NULL; /* v//vn */
        if (!left_out &&
            !parse_index(parser, token, (enum obj_attribute)i, &text, &corner->index[i])) {
            return false;
        }
        if (slash == NULL) {
            return true;
        }
        at = slash + 1;
    }
    return fail_token(parser, token, "is not a corner (v, v/vt, v//vn or v/vt/vn)");
}

static bool add_triangle(struct obj_parser *parser, uint32_t a, uint32_t b, uint32_t c)
{
    struct obj_source *source = &parser->source;
    uint32_t(*grown)[3] = array_grow(source->triangles, source->triangle_count,
                                     &source->triangle_capacity, sizeof *grown);
    if (grown == NULL || source->triangle_count >= OBJ_MAX_COUNT) {
        return fail(parser, "out of memory");
    }
    source->triangles = grown;
    uint32_t *triangle = grown[source->triangle_count++];
    triangle[0] = a;
    triangle[1] = b;
    triangle[2] = c;
    return true;
}

/* A fan around the first corner. */
static bool parse_face(struct obj_parser *parser, struct line *line)
{
    struct token token;
    uint32_t first = 0, previous = 0;
    int corners = 0; /* 0, 1, 2: and then "more" */
    while (line_token(line, &token)) {
        struct obj_corner corner;
        uint32_t vertex;
        if (!parse_corner(parser, &token, &corner)) {
            return false;
        }
        if (!obj_add_corner(&parser->source, &corner, &vertex)) {
            return fail(parser, "out of memory");
        }
        if (corners >= 2 && !add_triangle(parser, first, previous, vertex)) {
            return false;
        }
        first = corners == 0 ? vertex : first;
        previous = vertex;
        corners += corners < 3 ? 1 : 0;
    }
    return corners == 3 || fail(parser, "a face needs 3 corners or more");
}

/* ---- Statements ---- */

/* Known statements that a triangle mesh has no use for. */
static const char *const passed_over[] = {
    "o",      "g",      "s",        "mg",       "l",    "p",          "vp",        "usemtl",
    "mtllib", "usemap", "maplib",   "cstype",   "deg",  "bmat",       "step",      "curv",
    "curv2",  "surf",   "parm",     "trim",     "hole", "scrv",       "sp",        "end",
    "con",    "bevel",  "c_interp", "d_interp", "lod",  "shadow_obj", "trace_obj", "ctech",
    "stech",  "call",   "csh",      "bsp",      "bzp",  "cdc",        "cdp",       "res",
};

static bool is_passed_over(const struct token *keyword)
{
    for (size_t i = 0; i < sizeof passed_over / sizeof passed_over[0]; i++) {
        if (token_equals(keyword, passed_over[i])) {
            return true;
        }
    }
    return false;
}

static bool parse_statement(struct obj_parser *parser, struct line *line)
{
    struct token keyword;
    if (!line_token(line, &keyword)) {
        return true;
    }
    for (int i = 0; i < OBJ_ATTRIBUTES; i++) {
        if (token_equals(&keyword, attribute_names[i])) {
            return parse_numbers(parser, line, (enum obj_attribute)i);
        }
    }
    if (token_equals(&keyword, "f") || token_equals(&keyword, "fo")) { /* fo: before 1990 */
        return parse_face(parser, line);
    }
    if (is_passed_over(&keyword)) {
        return true;
    }
    return fail_token(parser, &keyword,
                      token_is_binary(&keyword) ? "is not text: is this an OBJ file?"
                                                : "is not an OBJ statement");
}

static bool check_forward_references(struct obj_parser *parser)
{
    for (int i = 0; i < OBJ_ATTRIBUTES; i++) {
        size_t count = parser->source.lists[i].count;
        if (parser->forward[i].index > count) {
            text_error_set(parser->error, parser->name, parser->forward[i].line,
                           "index %lu is out of range: the file has %zu %s statements",
                           (unsigned long)parser->forward[i].index, count, attribute_names[i]);
            return false;
        }
    }
    return true;
}

static bool parse_all(struct obj_parser *parser, const char *text, size_t length)
{
    struct line_reader reader;
    struct line line;
    lines_begin(&reader, text, length, true);
    while (lines_next(&reader, &line)) {
        parser->line = line.number;
        if (!parse_statement(parser, &line)) {
            return false;
        }
    }
    parser->line = 0; /* what follows is about the whole file */
    if (parser->source.triangle_count == 0) {
        return fail(parser, "has no faces");
    }
    return check_forward_references(parser);
}

bool obj_parse(const char *name, const char *text, size_t length, struct obj_mesh *mesh,
               struct text_error *error)
{
    struct obj_parser parser = {.name = name, .error = error};
    memset(mesh, 0, sizeof *mesh);
    bool ok = parse_all(&parser, text, length);
    if (ok) {
        mesh->path = strdup(name);
        if (mesh->path == NULL || !obj_build(&parser.source, mesh)) {
            ok = fail(&parser, "out of memory");
            obj_free(mesh);
        }
    }
    obj_source_free(&parser.source);
    return ok;
}

bool obj_read(const char *path, struct obj_mesh *mesh, struct text_error *error)
{
    struct file_content file;
    memset(mesh, 0, sizeof *mesh);
    if (!file_read(path, &file, error)) {
        return false;
    }
    bool ok = obj_parse(path, file.bytes, file.length, mesh, error);
    free(file.bytes);
    return ok;
}

void obj_free(struct obj_mesh *mesh)
{
    free(mesh->path);
    free(mesh->positions);
    free(mesh->normals);
    free(mesh->uvs);
    free(mesh->triangles);
    memset(mesh, 0, sizeof *mesh);
}
