/* SPDX-License-Identifier: MIT */
/*
 * Pages as text that grows in memory, with pictures inside: pages need no other file.
 */
#ifndef QTRI_HOST_TOOLS_HTML_H
#define QTRI_HOST_TOOLS_HTML_H

#include <stdbool.h>
#include <stddef.h>

#include "../assets/png_write.h"
#include "../io/picture.h"
#include "../io/text_error.h"

struct html { /* begins with zeros */
    struct byte_list page;
};

void html_put(struct html *html, const char *text);

/* Up to 599 characters. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void html_print(struct html *html, const char *format, ...);

/* Text that is no HTML. */
void html_put_text(struct html *html, const char *text, size_t length);

/* The picture as a PNG in an address: data:image/png;base64,... */
void html_put_png(struct html *html, const struct picture *picture);

/* Writes the page and frees it. False with *error set. */
bool html_write(struct html *html, const char *path, struct text_error *error);

#endif
