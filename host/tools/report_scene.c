/* SPDX-License-Identifier: MIT */
#include "report_scene.h"

#include <math.h>

#include "compare.h"

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

void report_scene_add(struct html *page, const struct gallery_scene *scene)
{
    int crop[2];
    html_print(page, "<section id=\"%s\" class=\"scene\"><h3>%s</h3>\n", scene->name, scene->name);
    gallery_describe(page, scene, crop);
    html_put(page, "<div class=\"row\"><div>");
    put_slider(page, scene);
    html_put(page, "</div><div>");
    put_histogram(page, scene);
    gallery_put_figures(page, scene);
    html_put(page, "</div></div></section>\n");
}
