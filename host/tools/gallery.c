/* SPDX-License-Identifier: MIT */
#include "gallery.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare.h"

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

/* What the scene shows: the comments that it begins with. `# crop X Y` names the upper left corner
   of what is shown enlarged, `# qtri` a command. */
static void describe(struct html *page, const struct gallery_scene *scene, int crop[2])
{
    const char *at = scene->text, *end = scene->text + scene->length;
    html_put(page, "<p>");
    while (at < end && *at == '#') {
        const char *stop = memchr(at, '\n', (size_t)(end - at));
        const size_t length = (size_t)((stop != NULL ? stop : end) - at);
        char line[200];
        (void)snprintf(line, sizeof line, "%.*s", (int)(length < 199 ? length : 199), at);
        if (sscanf(line, "# crop %d %d", &crop[0], &crop[1]) != 2 &&
            strncmp(line, "# qtri", 6) != 0) {
            html_put_text(page, at + 1, length - 1);
        }
        at += length + (stop != NULL);
    }
    html_put(page, "</p>\n");
}

enum { ENLARGED = 6 };

static void put_pictures(struct html *page, const struct gallery_scene *scene, const int crop[2])
{
    static const char *const captions[3] = {"core", "double precision", "difference"};
    html_put(page, "<div class=\"row\">\n");
    for (int i = 0; i < 3; i++) {
        html_print(page,
                   scene->pictures[i]->width <= 320 ? "<figure class=\"small\">" : "<figure>");
        if (crop[0] >= 0) {
            html_print(page, "<div class=\"crop\">");
        }
        html_print(page, "<img alt=\"%s: %s\" src=\"", scene->name, captions[i]);
        html_put_png(page, scene->pictures[i]);
        if (crop[0] >= 0) {
            html_print(page, "\" style=\"width:%dpx;left:%dpx;top:%dpx\"></div>",
                       ENLARGED * scene->pictures[i]->width, -ENLARGED * crop[0],
                       -ENLARGED * crop[1]);
            html_print(page, "<figcaption>%s, %d x enlarged</figcaption></figure>\n", captions[i],
                       ENLARGED);
        } else {
            html_print(page, "\"><figcaption>%s</figcaption></figure>\n", captions[i]);
        }
    }
    html_put(page, "</div>\n");
}

static void put_figures(struct html *page, const struct gallery_scene *scene)
{
    html_put(page,
             "<table><tr><th>pixels<th>mismatch<th>snapped<th>colour<th>off by &gt; 1<th>depth\n");
    html_print(page, "<tr><td>%llu<td>%llu<td>%llu<td>%d<td>%llu<td>%.2f</table>\n",
               (unsigned long long)scene->exact->covered,
               (unsigned long long)scene->exact->coverage,
               (unsigned long long)scene->snapped->coverage, scene->exact->max_color,
               (unsigned long long)scene->exact->color_above_1, scene->exact->max_depth);
}

void gallery_add(struct html *page, const struct gallery_scene *scene)
{
    static const int whole[2] = {-1, -1};
    int crop[2] = {-1, -1};
    if (page->page.count == 0) {
        html_put(page, head);
    }
    html_print(page, "<section id=\"%s\"><h2>%s</h2>\n", scene->name, scene->name);
    describe(page, scene, crop);
    put_pictures(page, scene, whole);
    if (crop[0] >= 0) {
        put_pictures(page, scene, crop);
    }
    put_figures(page, scene);
    html_put(page, "</section>\n");
}

bool gallery_write(struct html *page, const char *path, struct text_error *error)
{
    html_put(page, "</html>\n");
    return html_write(page, path, error);
}

/* ---- The accuracy report ---- */

/* Errors of 0, 1, 2, and then by octaves: 3..4, 5..8, ..., 129..255. */
enum { BARS = 10, BAR = 34, HEIGHT = 70 };

static int bar_of(int error)
{
    int bar = error < 3 ? error : 3;
    for (int end = 4; bar >= 3 && error > end; end *= 2) {
        bar++;
    }
    return bar;
}

static void put_slider(struct html *page, const struct gallery_scene *scene)
{
    const struct picture *core = scene->pictures[0];
    html_print(page,
               "<div class=\"compare\" style=\"--width:%dpx\"><img alt=\"%s: double precision\" "
               "src=\"",
               core->width > 320 ? core->width : 320, scene->name);
    html_put_png(page, scene->pictures[1]);
    html_print(page, "\"><img class=\"over\" alt=\"%s: core\" src=\"", scene->name);
    html_put_png(page, core);
    html_print(
        page,
        "\"></div>\n<label class=\"slider\"><span>double precision</span><input type=\"range\" "
        "min=\"0\" max=\"100\" value=\"50\" aria-label=\"%s: percent of the picture that the "
        "core draws\"><span>core</span></label>\n",
        scene->name);
}

/* Bars as high as the logarithm of their count. */
static void put_histogram(struct html *page, const struct gallery_scene *scene)
{
    static const char *const ranges[BARS] = {"0",    "1",     "2",     "3-4",    "5-8",
                                             "9-16", "17-32", "33-64", "65-128", "129+"};
    struct comparison all;
    unsigned long long counts[BARS] = {0};
    compare_pictures(scene->pictures[0], scene->pictures[1], &all);
    for (int error = 0; error < 256; error++) {
        counts[bar_of(error)] += all.pixels_with_error[error];
    }
    html_print(page,
               "<svg class=\"bars\" viewBox=\"0 0 %d %d\" role=\"img\" aria-label=\"%s: pixels by "
               "error of colour:",
               BARS * BAR, HEIGHT + 32, scene->name);
    for (int i = 0; i < BARS; i++) {
        html_print(page, " %s: %llu%s", ranges[i], counts[i], i + 1 < BARS ? "," : "\">");
    }
    for (int i = 0; i < BARS; i++) {
        const double height = counts[i] == 0 ? 0 : 4 + (HEIGHT - 4) * log10((double)counts[i]) / 6;
        html_print(page,
                   "<rect x=\"%d\" y=\"%.1f\" width=\"%d\" height=\"%.1f\"/><text x=\"%d\" "
                   "y=\"%.1f\">%llu</text><text x=\"%d\" y=\"%d\">%s</text>",
                   i * BAR + 3, HEIGHT + 14 - height, BAR - 6, height, i * BAR + BAR / 2,
                   HEIGHT + 11 - height, counts[i], i * BAR + BAR / 2, HEIGHT + 26, ranges[i]);
    }
    html_put(page, "</svg>\n");
}

void gallery_add_to_report(struct html *page, const struct gallery_scene *scene)
{
    int crop[2];
    html_print(page, "<section id=\"%s\" class=\"scene\"><h3>%s</h3>\n", scene->name, scene->name);
    describe(page, scene, crop);
    html_put(page, "<div class=\"row\"><div>");
    put_slider(page, scene);
    html_put(page, "</div><div>");
    put_histogram(page, scene);
    put_figures(page, scene);
    html_put(page, "</div></div></section>\n");
}
