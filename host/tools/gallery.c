/* SPDX-License-Identifier: MIT */
#include "gallery.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../io/file.h"

static const char head[] =
    "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
    "<title>qtri: the demo</title>\n"
    "<style>\n"
    ":root { color-scheme: light dark; }\n"
    "body { font: 16px/1.5 system-ui, sans-serif; max-width: 1080px; margin: 0 auto; "
    "padding: 1rem; }\n"
    "section { margin: 3rem 0; }\n"
    "h2 { margin: 0; font-size: 1.2rem; }\n"
    ".row { display: flex; flex-wrap: wrap; gap: .75rem; }\n"
    "figure { margin: 0; }\n"
    "figcaption { font-size: .85rem; opacity: .8; }\n"
    "img { max-width: 320px; width: 100%; height: auto; }\n"
    ".crop img, .small img { image-rendering: pixelated; }\n"
    ".crop { width: 320px; height: 240px; overflow: hidden; position: relative; }\n"
    ".crop img { position: absolute; max-width: none; }\n"
    "table { border-collapse: collapse; font-size: .9rem; margin-top: .5rem; }\n"
    "th, td { text-align: right; padding: .1rem .6rem; border-bottom: 1px solid #8884; "
    "font-weight: normal; }\n"
    ".key { display: inline-block; width: 1.1em; height: 1.1em; vertical-align: -.2em; "
    "margin: 0 .2em 0 .8em; }\n"
    "</style>\n"
    "<h1>qtri: the demo</h1>\n"
    "<p>Every scene three times: drawn by the fixed-point core, by an independent renderer in "
    "double precision, and where the two differ.</p>\n"
    "<p>In the difference: <span class=\"key\" style=\"background:#2c2c2c\"></span>the same "
    "<span class=\"key\" style=\"background:#505050\"></span>1 "
    "<span class=\"key\" style=\"background:#808080\"></span>4 "
    "<span class=\"key\" style=\"background:#fff;outline:1px solid #8888\"></span>12 and more "
    "of 255 in each channel "
    "<span class=\"key\" style=\"background:#f00\"></span>covered in one of them only</p>\n"
    "<p>The figures. <b>Pixels</b>: covered in both. <b>Mismatch</b>: covered in one of the two "
    "only. <b>Snapped</b>: the same where double precision has its vertices on the core's grid of "
    "1/256 pixel. <b>Colour</b>: the largest difference of a channel, of 255, where both show the "
    "same triangle; <b>off by &gt; 1</b>: how many pixels differ by more than one. <b>Depth</b>: "
    "the largest difference, in steps of 1/65535. Edges that are smoothed after drawing differ "
    "from the reference's one sample a pixel.</p>\n";

static void add(struct gallery *gallery, const void *bytes, size_t count)
{
    gallery->is_short = gallery->is_short || !byte_list_add(&gallery->page, bytes, count);
}

static void put(struct gallery *gallery, const char *text)
{
    add(gallery, text, strlen(text));
}

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
static void
print(struct gallery *gallery, const char *format, ...)
{
    char text[600];
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    put(gallery, text);
}

/* Text as HTML has it. */
static void put_escaped(struct gallery *gallery, const char *text, size_t length)
{
    for (size_t i = 0; i < length; i++) {
        switch (text[i]) {
        case '<':
            put(gallery, "&lt;");
            break;
        case '&':
            put(gallery, "&amp;");
            break;
        default:
            add(gallery, &text[i], 1);
        }
    }
}

static void put_base64(struct gallery *gallery, const struct byte_list *list)
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
        add(gallery, four, sizeof four);
    }
}

/* What the scene shows: the comments that it begins with. `# crop X Y` names the upper left corner
   of what is shown enlarged, `# qtri` a command. */
static void put_description(struct gallery *gallery, const struct gallery_scene *scene, int crop[2])
{
    const char *at = scene->text, *end = scene->text + scene->length;
    put(gallery, "<p>");
    while (at < end && *at == '#') {
        const char *stop = memchr(at, '\n', (size_t)(end - at));
        const size_t length = (size_t)((stop != NULL ? stop : end) - at);
        char line[200];
        (void)snprintf(line, sizeof line, "%.*s", (int)(length < 199 ? length : 199), at);
        if (sscanf(line, "# crop %d %d", &crop[0], &crop[1]) != 2 &&
            strncmp(line, "# qtri", 6) != 0) {
            put_escaped(gallery, at + 1, length - 1);
        }
        at += length + (stop != NULL);
    }
    put(gallery, "</p>\n");
}

enum { ENLARGED = 6 };

static void put_pictures(struct gallery *gallery, const struct gallery_scene *scene,
                         const int crop[2])
{
    static const char *const captions[3] = {"core", "double precision", "difference"};
    put(gallery, "<div class=\"row\">\n");
    for (int i = 0; i < 3; i++) {
        struct byte_list png = {.bytes = NULL};
        gallery->is_short = gallery->is_short || !png_append(&png, scene->pictures[i]);
        print(gallery, scene->pictures[i]->width <= 320 ? "<figure class=\"small\">" : "<figure>");
        if (crop[0] >= 0) {
            print(gallery, "<div class=\"crop\">");
        }
        print(gallery, "<img alt=\"%s: %s\" src=\"data:image/png;base64,", scene->name,
              captions[i]);
        put_base64(gallery, &png);
        if (crop[0] >= 0) {
            print(gallery, "\" style=\"width:%dpx;left:%dpx;top:%dpx\"></div>",
                  ENLARGED * scene->pictures[i]->width, -ENLARGED * crop[0], -ENLARGED * crop[1]);
            print(gallery, "<figcaption>%s, %d x enlarged</figcaption></figure>\n", captions[i],
                  ENLARGED);
        } else {
            print(gallery, "\"><figcaption>%s</figcaption></figure>\n", captions[i]);
        }
        free(png.bytes);
    }
    put(gallery, "</div>\n");
}

static void put_figures(struct gallery *gallery, const struct gallery_scene *scene)
{
    put(gallery,
        "<table><tr><th>pixels<th>mismatch<th>snapped<th>colour<th>off by &gt; 1<th>depth\n");
    print(gallery, "<tr><td>%llu<td>%llu<td>%llu<td>%d<td>%llu<td>%.2f</table>\n",
          (unsigned long long)scene->exact->covered, (unsigned long long)scene->exact->coverage,
          (unsigned long long)scene->snapped->coverage, scene->exact->max_color,
          (unsigned long long)scene->exact->color_above_1, scene->exact->max_depth);
}

void gallery_add(struct gallery *gallery, const struct gallery_scene *scene)
{
    static const int whole[2] = {-1, -1};
    int crop[2] = {-1, -1};
    if (gallery->page.count == 0) {
        put(gallery, head);
    }
    print(gallery, "<section id=\"%s\"><h2>%s</h2>\n", scene->name, scene->name);
    put_description(gallery, scene, crop);
    put_pictures(gallery, scene, whole);
    if (crop[0] >= 0) {
        put_pictures(gallery, scene, crop);
    }
    put_figures(gallery, scene);
    put(gallery, "</section>\n");
}

bool gallery_write(struct gallery *gallery, const char *path, struct text_error *error)
{
    struct file_output output;
    put(gallery, "</html>\n");
    bool ok = !gallery->is_short;
    if (!ok) {
        text_error_set(error, path, 0, "out of memory");
    } else if ((ok = file_output_open(&output, path, error))) {
        file_output_write(&output, gallery->page.bytes, gallery->page.count);
        ok = file_output_commit(&output, error);
    }
    free(gallery->page.bytes);
    return ok;
}
