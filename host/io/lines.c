/* SPDX-License-Identifier: MIT */
#include "lines.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>

#define QUOTED 40 /* characters of a token that a message shows */

void lines_begin(struct line_reader *reader, const char *text, size_t length, bool continuations)
{
    if (length == 0) {
        text = ""; /* NULL is allowed then */
    }
    if (length >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0) {
        text += 3;
        length -= 3;
    }
    reader->at = text;
    reader->end = text + length;
    reader->number = 1;
    reader->continuations = continuations;
}

/* Whether the newline at `newline` follows a backslash that is not before `start`. */
static bool is_continued(const char *start, const char *newline)
{
    if (newline - start >= 2 && newline[-1] == '\r') {
        newline--;
    }
    return newline > start && newline[-1] == '\\';
}

static const char *find_newline(const char *p, const char *end)
{
    const char *newline = memchr(p, '\n', (size_t)(end - p));
    return newline == NULL ? end : newline;
}

static void count_line(struct line_reader *reader)
{
    if (reader->number < INT_MAX) {
        reader->number++;
    }
}

bool lines_next(struct line_reader *reader, struct line *line)
{
    const char *start = reader->at;
    const char *p = start;
    if (p == reader->end) {
        return false;
    }
    line->at = start;
    line->number = reader->number;
    for (; p < reader->end && *p != '#'; p++) {
        if (*p != '\n') {
            continue;
        }
        if (!reader->continuations || !is_continued(start, p)) {
            break;
        }
        count_line(reader);
    }
    line->end = p;
    p = find_newline(p, reader->end); /* past a comment */
    count_line(reader);
    reader->at = p < reader->end ? p + 1 : p;
    return true;
}

bool text_is_space(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/* A newline inside a line means that the backslash before it joined two: both separate tokens. */
static bool is_separator(const char *p, const char *end)
{
    if (*p == '\\') {
        return (end - p >= 2 && p[1] == '\n') || (end - p >= 3 && p[1] == '\r' && p[2] == '\n');
    }
    return text_is_space(*p);
}

bool line_token(struct line *line, struct token *token)
{
    const char *p = line->at;
    while (p < line->end && is_separator(p, line->end)) {
        p++;
    }
    token->text = p;
    while (p < line->end && !is_separator(p, line->end)) {
        p++;
    }
    token->length = (size_t)(p - token->text);
    line->at = p;
    return token->length > 0;
}

bool token_equals(const struct token *token, const char *text)
{
    return token->length == strlen(text) && memcmp(token->text, text, token->length) == 0;
}

static bool is_control(char c)
{
    return (unsigned char)c < 0x20 || c == 0x7f;
}

const char *token_quote(const struct token *token, char out[TOKEN_QUOTE_SIZE])
{
    size_t shown = token->length < QUOTED ? token->length : QUOTED;
    for (size_t i = 0; i < shown; i++) {
        char c = token->text[i];
        out[i] = is_control(c) || (unsigned char)c >= 0x80 ? '?' : c;
    }
    (void)snprintf(out + shown, TOKEN_QUOTE_SIZE - shown, "%s", shown < token->length ? "..." : "");
    return out;
}

bool token_is_binary(const struct token *token)
{
    for (size_t i = 0; i < token->length; i++) {
        if (is_control(token->text[i])) {
            return true;
        }
    }
    return false;
}
