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
#include "xalloc.h"

#define ONE 65536

struct obj_parser {
    const char *name, *end; /* of the text */
    struct text_error *error;
    int line;
    uint32_t material; /* of the faces that follow */
    struct obj_source *source;
    /* Faces may name elements that follow; the largest such index is checked at the end. */
    struct {
        uint32_t index; /* 1-based, 0: none */
        int line;
    } forward[OBJ_ATTRIBUTES];
};

static const char *const attribute_names[OBJ_ATTRIBUTES] = {"v", "vt", "vn"};

static bool fail(const struct obj_parser *parser, const char *sentence)
{
    return text_error_set(parser->error, parser->name, parser->line, "%s", sentence);
}

static bool fail_token(const struct obj_parser *parser, const struct token *token,
                       const char *problem)
{
    char quoted[TOKEN_QUOTE_SIZE];
    return text_error_set(parser->error, parser->name, parser->line, "'%s' %s",
                          token_quote(token, quoted), problem);
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

/* Q16.16 exactly, or in double precision. */
static enum number_result parse_number(const struct obj_parser *parser, const struct token *token,
                                       bool is_wide, double *out)
{
    int32_t value;
    if (parser->source->full || is_wide) {
        return number_parse_real(token->text, token->length, out);
    }
    enum number_result result = number_parse_q16(token->text, token->length, &value);
    if (result == NUMBER_OK) {
        *out = (double)value / ONE;
    }
    return result;
}

enum { MOST_NUMBERS = 7 };

/* Returns how many there are, or -1. */
static int read_numbers(struct obj_parser *parser, struct line *line, enum obj_attribute attribute,
                        double out[MOST_NUMBERS])
{
    const struct obj_numbers *shape = &number_statements[attribute];
    const bool is_wide = attribute == OBJ_POSITION && parser->source->wide_positions;
    struct token token;
    int count = 0;
    for (; line_token(line, &token); count++) {
        if (count == shape->accepted) {
            fail_token(parser, &token, "is more than the statement takes");
            return -1;
        }
        enum number_result result = parse_number(parser, &token, is_wide, &out[count]);
        if (result == NUMBER_MALFORMED || (result != NUMBER_OK && count < shape->kept)) {
            fail_token(parser, &token, number_problem(result));
            return -1;
        }
    }
    if (count < shape->needed) {
        fail(parser, "too few numbers");
        return -1;
    }
    return count;
}

static void append(struct obj_list *list, const double numbers[3])
{
    double(*item)[3] = array_add(&list->items, &list->count, &list->capacity, sizeof *item);
    memcpy(item, numbers, sizeof *item);
}

/* v x y z r g b and v x y z w r g b: the last three of six or seven numbers. */
static void append_color(struct obj_source *source, const double *numbers, int count)
{
    double color[3] = {1.0, 1.0, 1.0};
    if (count >= 6) {
        for (int i = 0; i < 3; i++) {
            double value = numbers[count - 3 + i];
            color[i] = value < 0.0 ? 0.0 : value > 1.0 ? 1.0 : value;
        }
        source->has_colors = true;
    }
    append(&source->colors, color);
}

static bool parse_numbers(struct obj_parser *parser, struct line *line,
                          enum obj_attribute attribute)
{
    double numbers[MOST_NUMBERS] = {0.0};
    struct obj_source *source = parser->source;
    int count = read_numbers(parser, line, attribute, numbers);
    if (count < 0) {
        return false;
    }
    for (int i = number_statements[attribute].kept; i < 3; i++) {
        numbers[i] = 0.0;
    }
    if (attribute == OBJ_UV) { /* the file counts v from a picture's last row */
        numbers[1] = 1.0 - numbers[1];
        if (!source->full && numbers[1] > (double)INT32_MAX / ONE) {
            return fail(parser, "1 - v does not fit Q16.16");
        }
    }
    append(&source->lists[attribute], numbers);
    if (attribute == OBJ_POSITION) {
        append_color(source, numbers, count);
    }
    return true;
}

/* ---- f ---- */

/* Turns the text of an index into a 0-based one. */
static bool parse_index(struct obj_parser *parser, const struct token *corner,
                        enum obj_attribute attribute, const struct token *text, uint32_t *index)
{
    int64_t count = (int64_t)parser->source->lists[attribute].count;
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
    corner->material = parser->material;
    for (int i = 0; i < OBJ_ATTRIBUTES; i++) {
        const char *slash = memchr(at, '/', (size_t)(end - at));
        struct token text = {at, (size_t)((slash != NULL ? slash : end) - at)};
        bool left_out = i > OBJ_POSITION && text.length == 0; /* v//vn; some write v/ v// v/vt/ */
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
    struct obj_source *source = parser->source;
    if (source->full && source->triangle_count >= OBJ_MAX_TRIANGLES) {
        return fail(parser, "more than 2097152 triangles; simplify the model elsewhere first");
    }
    uint32_t *triangle = array_add(&source->triangles, &source->triangle_count,
                                   &source->triangle_capacity, sizeof *source->triangles);
    triangle[0] = a;
    triangle[1] = b;
    triangle[2] = c;
    return true;
}

static void add_polygon(struct obj_source *source, size_t first_triangle)
{
    struct obj_polygon *polygon = array_add(&source->polygons, &source->polygon_count,
                                            &source->polygon_capacity, sizeof *polygon);
    polygon->first = (uint32_t)first_triangle;
    polygon->count = (uint32_t)(source->triangle_count - first_triangle);
}

static bool is_edge(struct line line)
{
    struct token token;
    int corners = 0;
    while (corners < 3 && line_token(&line, &token)) {
        corners++;
    }
    return corners == 1 || corners == 2;
}

/* A fan around the first corner, until all positions are known. An edge at the end of the text is a
   face of which something is missing. */
static bool parse_face(struct obj_parser *parser, struct line *line)
{
    parser->source->count.faces++;
    if (is_edge(*line) && line->end != parser->end) {
        parser->source->count.edges++;
        return true;
    }
    const size_t first_triangle = parser->source->triangle_count;
    struct token token;
    uint32_t first = 0, previous = 0;
    int corners = 0; /* 0, 1, 2: and then "more" */
    while (line_token(line, &token)) {
        struct obj_corner corner;
        if (!parse_corner(parser, &token, &corner)) {
            return false;
        }
        const uint32_t vertex = unique_add(&parser->source->vertices, &corner);
        if (corners >= 2 && !add_triangle(parser, first, previous, vertex)) {
            return false;
        }
        first = corners == 0 ? vertex : first;
        previous = vertex;
        corners += corners < 3 ? 1 : 0;
    }
    if (corners < 3) {
        return fail(parser, "a face needs 3 corners or more");
    }
    if (parser->source->triangle_count > first_triangle + 1) {
        add_polygon(parser->source, first_triangle);
    }
    return true;
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

/* The place of the line's rest among the names, where it is added if it is new. */
static bool parse_name(struct obj_parser *parser, struct line *line, struct obj_names *names,
                       size_t *place)
{
    const char *end = line->end;
    while (line->at < end && text_is_space(*line->at)) {
        line->at++;
    }
    while (end > line->at && text_is_space(end[-1])) {
        end--;
    }
    size_t length = (size_t)(end - line->at);
    for (*place = 0; *place < names->count; (*place)++) {
        const char *known = names->items[*place].text;
        if (strlen(known) == length && memcmp(known, line->at, length) == 0) {
            return true;
        }
    }
    if (names->count == OBJ_MAX_NAMES || memchr(line->at, 0, length) != NULL) {
        return fail(parser, "too many names, or a name that holds a NUL");
    }
    struct obj_name *name = array_add(&names->items, &names->count, &names->capacity, sizeof *name);
    name->line = parser->line;
    name->text = xcalloc(length + 1, 1);
    memcpy(name->text, line->at, length);
    return true;
}

static bool parse_material(struct obj_parser *parser, struct line *line)
{
    size_t place;
    if (!parse_name(parser, line, &parser->source->materials, &place)) {
        return false;
    }
    parser->material = (uint32_t)place;
    return true;
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
    if (parser->source->full && token_equals(&keyword, "usemtl")) {
        return parse_material(parser, line);
    }
    if (parser->source->full && token_equals(&keyword, "mtllib")) {
        size_t place;
        return parse_name(parser, line, &parser->source->libraries, &place);
    }
    if (is_passed_over(&keyword)) {
        struct obj_count *count = &parser->source->count;
        count->lines += token_equals(&keyword, "l");
        count->points += token_equals(&keyword, "p");
        count->curved += token_equals(&keyword, "curv") || token_equals(&keyword, "curv2") ||
                         token_equals(&keyword, "surf");
        return true;
    }
    return fail_token(parser, &keyword,
                      token_is_binary(&keyword) ? "is not text: is this an OBJ file?"
                                                : "is not an OBJ statement");
}

static bool check_forward_references(struct obj_parser *parser)
{
    for (int i = 0; i < OBJ_ATTRIBUTES; i++) {
        size_t count = parser->source->lists[i].count;
        if (parser->forward[i].index > count) {
            return text_error_set(parser->error, parser->name, parser->forward[i].line,
                                  "index %lu is out of range: the file has %zu %s statements",
                                  (unsigned long)parser->forward[i].index, count,
                                  attribute_names[i]);
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
    if (parser->source->triangle_count == 0) {
        const struct obj_count *count = &parser->source->count;
        const bool is_other = count->faces == 0 && count->lines + count->points + count->curved > 0;
        return fail(parser, parser->source->full && is_other
                                ? "has no faces, only lines, points or curves"
                                : "has no faces");
    }
    const bool ok = check_forward_references(parser);
    if (ok) {
        obj_triangulate(parser->source);
    }
    return ok;
}

bool obj_parse_source(const char *name, const char *text, size_t length, struct obj_source *source,
                      struct text_error *error)
{
    source->vertices.item_size = sizeof(struct obj_corner);
    struct obj_parser parser = {
        .name = name, .end = text + length, .error = error, .source = source};
    if (source->full) { /* the material of faces before any usemtl */
        struct line nothing = {text, text, 0};
        if (!parse_material(&parser, &nothing)) {
            return false;
        }
    }
    return parse_all(&parser, text, length);
}

bool obj_parse_scaled(const char *name, const char *text, size_t length,
                      const struct obj_scale *scale, struct obj_mesh *mesh,
                      struct text_error *error)
{
    struct obj_source source = {.full = false, .wide_positions = scale != NULL};
    memset(mesh, 0, sizeof *mesh);
    bool ok = obj_parse_source(name, text, length, &source, error);
    if (ok && scale != NULL && !obj_scale_positions(&source, scale)) {
        text_error_set(error, name, 0, "does not fit Q16.16 when it is scaled");
        ok = false;
    }
    if (ok) {
        mesh->path = xstrdup(name);
        obj_build(&source, mesh);
    }
    obj_source_free(&source);
    return ok;
}

bool obj_parse(const char *name, const char *text, size_t length, struct obj_mesh *mesh,
               struct text_error *error)
{
    return obj_parse_scaled(name, text, length, NULL, mesh, error);
}

bool obj_read(const char *path, struct obj_mesh *mesh, struct text_error *error)
{
    return obj_read_scaled(path, NULL, mesh, error);
}

bool obj_read_scaled(const char *path, const struct obj_scale *scale, struct obj_mesh *mesh,
                     struct text_error *error)
{
    struct file_content file;
    memset(mesh, 0, sizeof *mesh);
    if (!file_read(path, &file, error)) {
        return false;
    }
    bool ok = obj_parse_scaled(path, file.bytes, file.length, scale, mesh, error);
    free(file.bytes);
    return ok;
}

void obj_free(struct obj_mesh *mesh)
{
    free(mesh->path);
    free(mesh->positions);
    free(mesh->normals);
    free(mesh->uvs);
    free(mesh->colors);
    free(mesh->triangles);
    memset(mesh, 0, sizeof *mesh);
}
