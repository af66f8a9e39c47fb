/* SPDX-License-Identifier: MIT */
/*
 * Lines and tokens of a text in memory: any bytes, nothing copied, nothing terminated by NUL.
 * Scene files and OBJ files share the rules: tokens are separated by white space (a carriage
 * return is white space, so CRLF needs nothing special), `#` starts a comment anywhere in a line,
 * the last line may lack its newline, and a UTF-8 byte order mark at the start is passed over.
 */
#ifndef QTRI_HOST_IO_LINES_H
#define QTRI_HOST_IO_LINES_H

#include <stdbool.h>
#include <stddef.h>

/* Blank, tab, newline, carriage return, vertical tab, form feed; whatever the locale. */
bool text_is_space(char c);

struct token {
    const char *text;
    size_t length;
};

struct line {
    const char *at; /* what line_token has not taken yet, without comment and newline */
    const char *end;
    int number; /* 1-based; of a continued line, the first it spans */
};

struct line_reader {
    const char *at;
    const char *end;
    int number;         /* of the next line; stops counting at INT_MAX */
    bool continuations; /* a backslash before the newline (outside comments) joins two lines */
};

void lines_begin(struct line_reader *reader, const char *text, size_t length, bool continuations);

/* The next line, empty ones included; false at the end of the text. */
bool lines_next(struct line_reader *reader, struct line *line);

/* Takes the next token off the line; false when there is none left. */
bool line_token(struct line *line, struct token *token);

bool token_equals(const struct token *token, const char *text);

#define TOKEN_QUOTE_SIZE 48

/* The token as a message may quote it: printable ASCII, cut to 40 characters, in `out`. */
const char *token_quote(const struct token *token, char out[TOKEN_QUOTE_SIZE]);

/* Whether a token holds control characters, that is, whether the file is hardly text. */
bool token_is_binary(const struct token *token);

#endif
