/* SPDX-License-Identifier: MIT */
#include "html.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../io/file.h"

void html_put(struct html *html, const char *text)
{
    byte_list_add(&html->page, text, strlen(text));
}

void html_print(struct html *html, const char *format, ...)
{
    char text[600];
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    html_put(html, text);
}

void html_put_text(struct html *html, const char *text, size_t length)
{
    for (size_t i = 0; i < length; i++) {
        switch (text[i]) {
        case '<':
            html_put(html, "&lt;");
            break;
        case '&':
            html_put(html, "&amp;");
            break;
        default:
            byte_list_add(&html->page, &text[i], 1);
        }
    }
}

static void put_base64(struct html *html, const struct byte_list *list)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < list->count; i += 3) {
        const size_t rest = list->count - i;
        const uint32_t word = (uint32_t)list->bytes[i] << 16 |
                              (rest > 1 ? (uint32_t)list->bytes[i + 1] << 8 : 0) |
                              (rest > 2 ? list->bytes[i + 2] : 0);
        const char four[4] = {digits[word >> 18], digits[word >> 12 & 63],
                              rest > 1 ? digits[word >> 6 & 63] : '=',
                              rest > 2 ? digits[word & 63] : '='};
        byte_list_add(&html->page, four, sizeof four);
    }
}

void html_put_png(struct html *html, const struct picture *picture)
{
    struct byte_list png = {.bytes = NULL};
    png_append(&png, picture);
    html_put(html, "data:image/png;base64,");
    put_base64(html, &png);
    free(png.bytes);
}

bool html_write(struct html *html, const char *path, struct text_error *error)
{
    struct file_output output;
    bool ok = file_output_open(&output, path, error);
    if (ok) {
        file_output_write(&output, html->page.bytes, html->page.count);
        ok = file_output_commit(&output, error);
    }
    free(html->page.bytes);
    html->page = (struct byte_list){.bytes = NULL};
    return ok;
}
