/* SPDX-License-Identifier: MIT */
/*
 * What is wrong with an input file, and where.
 */
#ifndef QTRI_HOST_IO_TEXT_ERROR_H
#define QTRI_HOST_IO_TEXT_ERROR_H

#include <stdbool.h>

struct text_error {
    char message[512]; /* "FILE:LINE: what is wrong", or "FILE: ..." where no line applies */
};

/* Formats "name:line: " (line 0: "name: ") and the printf-style rest; cuts what does not fit. Its
   value is false, which is what functions return that fail. */
#define text_error_set(...) text_error_is_none(text_error_format(__VA_ARGS__))

#if defined(__GNUC__)
__attribute__((format(printf, 4, 5)))
#endif
int text_error_format(struct text_error *error, const char *name, int line, const char *format, ...);

/* Inline: whoever reads a caller sees what it returns. */
static inline bool text_error_is_none(int length)
{
    (void)length;
    return false;
}

#endif
