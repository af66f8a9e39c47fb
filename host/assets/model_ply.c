/* SPDX-License-Identifier: MIT */
/*
 * Whether a PLY file is as long as its header says: the library that reads it makes up what is
 * missing.
 */
#include <stdlib.h>
#include <string.h>

#include "../io/lines.h"
#include "../io/number.h"
#include "model.h"

enum { MOST_ELEMENTS = 16, MOST_PROPERTIES = 64 };

struct element {
    int64_t count;
    bool is_list[MOST_PROPERTIES];
    int property_count;
};

struct ply {
    const char *path;
    struct text_error *error;
    int line;
    bool is_ascii, ended;
    bool in_faces, has_face_colors;
    int64_t faces;
    struct element elements[MOST_ELEMENTS];
    int element_count;
};

static bool fail(const struct ply *ply, int line, const char *problem)
{
    return text_error_set(ply->error, ply->path, line, "%s", problem);
}

/* ---- The header ---- */

static bool parse_element(struct ply *ply, struct line *line)
{
    struct token name, count;
    if (ply->element_count == MOST_ELEMENTS) {
        return fail(ply, ply->line, "more than 16 elements");
    }
    struct element *element = &ply->elements[ply->element_count++];
    memset(element, 0, sizeof *element);
    if (!line_token(line, &name) || !line_token(line, &count) ||
        number_parse_integer(count.text, count.length, 0, INT64_C(1) << 32, &element->count) !=
            NUMBER_OK) {
        return fail(ply, ply->line, "an element needs a name and a count");
    }
    if (token_equals(&name, "tristrips")) {
        return fail(
            ply, ply->line,
            "its triangles are strips (tristrips), which cannot be read: store it as faces");
    }
    ply->in_faces = token_equals(&name, "face");
    ply->faces += ply->in_faces ? element->count : 0;
    if (ply->in_faces && element->count > (int64_t)MODEL_MAX_TRIANGLES) {
        return fail(ply, ply->line,
                    "more than 2097152 triangles; simplify the model elsewhere first");
    }
    return true;
}

static bool parse_property(struct ply *ply, struct line *line)
{
    struct token type, name;
    if (ply->element_count == 0) {
        return fail(ply, ply->line, "a property before the first element");
    }
    struct element *element = &ply->elements[ply->element_count - 1];
    if (element->property_count == MOST_PROPERTIES || !line_token(line, &type)) {
        return fail(ply, ply->line, "a property of no known type");
    }
    element->is_list[element->property_count++] = token_equals(&type, "list");
    ply->has_face_colors = ply->has_face_colors ||
                           (ply->in_faces && line_token(line, &name) &&
                            (token_equals(&name, "red") || token_equals(&name, "diffuse_red")));
    return true;
}

static bool parse_line(struct ply *ply, struct line *line)
{
    struct token keyword, format;
    if (!line_token(line, &keyword)) {
        return true;
    }
    if (token_equals(&keyword, "element")) {
        return parse_element(ply, line);
    }
    if (token_equals(&keyword, "property")) {
        return parse_property(ply, line);
    }
    if (token_equals(&keyword, "format") && line_token(line, &format)) {
        ply->is_ascii = token_equals(&format, "ascii");
    }
    ply->ended = token_equals(&keyword, "end_header");
    return true;
}

/* ---- The data ---- */

/* Whether a line holds what its element has. */
static bool check_values(const struct ply *ply, const struct element *element, struct line line)
{
    struct token token;
    for (int i = 0; i < element->property_count; i++) {
        int64_t count = 1;
        if (element->is_list[i] &&
            (!line_token(&line, &token) ||
             number_parse_integer(token.text, token.length, 0, INT32_MAX, &count) != NUMBER_OK)) {
            return fail(ply, line.number, "a list needs a count");
        }
        for (; count > 0; count--) {
            if (!line_token(&line, &token)) {
                return fail(ply, line.number,
                            element->is_list[i] ? "a list is longer than its line"
                                                : "fewer values than its element has");
            }
        }
    }
    return true;
}

/* Each line that is not blank is an element. */
static bool check_text(const struct ply *ply, struct line_reader *reader)
{
    struct line line;
    int last = ply->line;
    for (int i = 0; i < ply->element_count; i++) {
        for (int64_t j = 0; j < ply->elements[i].count; j++) {
            struct token token;
            struct line rest = {NULL, NULL, 0};
            do {
                if (!lines_next(reader, &line)) {
                    return fail(ply, last, "ends before the last of its elements");
                }
                last = line.number;
                rest = line;
            } while (!line_token(&rest, &token));
            if (!check_values(ply, &ply->elements[i], line)) {
                return false;
            }
        }
    }
    return true;
}

bool model_check_ply(const char *path, const char *text, size_t length, struct model *model,
                     struct text_error *error)
{
    struct ply *ply = calloc(1, sizeof *ply);
    struct line_reader reader;
    struct line line;
    bool ok = true;
    if (ply == NULL) {
        return text_error_set(error, path, 0, "out of memory");
    }
    ply->path = path;
    ply->error = error;
    lines_begin(&reader, text, length, false);
    while (ok && !ply->ended && lines_next(&reader, &line)) {
        ply->line = line.number;
        ok = parse_line(ply, &line);
    }
    if (ok && !ply->ended) {
        ok = fail(ply, ply->line,
                  length > 4 && text[3] == '\r' && text[4] != '\n'
                      ? "its lines end with carriage returns alone: store it with newlines"
                      : "the header does not end");
    } else if (ok && ply->faces == 0) {
        ok = fail(ply, 0, "has no faces: is it a cloud of points?");
    } else if (ok) {
        ok = !ply->is_ascii || check_text(ply, &reader); /* the library looks at others itself */
    }
    model_leave_out_words(model, ply->has_face_colors ? "colours of faces" : "");
    free(ply);
    return ok;
}
