/* SPDX-License-Identifier: MIT */
#include "text_error.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define NAME_SHOWN 200 /* characters of a long name that a message keeps: its end says more */

/* A path or a token may hold anything; a terminal should not obey it. */
static void replace_control_characters(char *message)
{
    for (char *p = message; *p != '\0'; p++) {
        if ((unsigned char)*p < 0x20 || *p == 0x7f) {
            *p = '?';
        }
    }
}

static size_t write_place(char *message, size_t size, const char *name, int line)
{
    size_t length = strlen(name);
    const char *dots = "";
    if (length > NAME_SHOWN) {
        name += length - NAME_SHOWN;
        dots = "...";
    }
    int written = line == 0 ? snprintf(message, size, "%s%s: ", dots, name)
                            : snprintf(message, size, "%s%s:%d: ", dots, name, line);
    return written < 0 ? 0 : (size_t)written; /* < NAME_SHOWN + 20 < size */
}

int text_error_format(struct text_error *error, const char *name, int line, const char *format, ...)
{
    size_t used = write_place(error->message, sizeof error->message, name, line);
    va_list arguments;
    va_start(arguments, format);
    if (vsnprintf(error->message + used, sizeof error->message - used, format, arguments) < 0) {
        error->message[used] = '\0';
    }
    va_end(arguments);
    replace_control_characters(error->message);
    return (int)strlen(error->message);
}
