/* SPDX-License-Identifier: MIT */
#include "svg.h"

#include <math.h>

#define PI 3.14159265358979323846

enum {
    LEFT = 90,
    RIGHT = 90,
    TOP = 40,    /* of the page */
    PANEL = 310, /* from one to the next */
    ABOVE = 46,  /* of that, before the plot */
    PLOT = 200,
    WIDTH = LEFT + SVG_COLUMNS + RIGHT
};

static const char band_colour[] = "#cfe2f5";
static const char edge_colour[] = "#1f5f9e";
static const char mean_colour[] = "#111";
static const char limit_colour[] = "#d00";
static const char grid_colour[] = "#ddd";

void svg_begin(FILE *file, const char *title, int panels)
{
    int height = TOP + panels * PANEL;
    (void)fprintf(file,
                  "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" "
                  "viewBox=\"0 0 %d %d\" font-family=\"sans-serif\" font-size=\"13\">\n"
                  "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n"
                  "<text x=\"%d\" y=\"30\" font-size=\"19\">%s</text>\n",
                  WIDTH, height, WIDTH, height, LEFT, title);
}

static double vertical(const svg_axis *axis, int top, double error)
{
    double held = fmax(axis->bottom, fmin(axis->top, error));
    return top + (axis->top - held) / (axis->top - axis->bottom) * PLOT;
}

static double horizontal(const svg_axis *axis, double x)
{
    double share = axis->scale == SVG_POWERS ? log(x / axis->low) / log(axis->high / axis->low)
                                             : (x - axis->low) / (axis->high - axis->low);
    return LEFT + share * SVG_COLUMNS;
}

static void line(FILE *file, double x0, double y0, double x1, double y1, const char *style)
{
    (void)fprintf(file, "<path d=\"M%.2f %.2fL%.2f %.2f\" stroke=\"%s\"/>\n", x0, y0, x1, y1,
                  style);
}

static void tick_text(FILE *file, const svg_axis *axis, double x)
{
    switch (axis->scale) {
    case SVG_TURNS:
        (void)fprintf(file, "%.4g%s", x / PI, x != 0 ? " &#960;" : "");
        break;
    case SVG_POWERS:
        (void)fprintf(file, "2<tspan dy=\"-5\" font-size=\"10\">%.3g</tspan>", log2(x));
        break;
    default:
        (void)fprintf(file, "%.5g", x);
        break;
    }
}

static void horizontal_ticks(FILE *file, const svg_axis *axis, int top)
{
    const bool factors = axis->scale == SVG_POWERS;
    const double steps = factors ? log(axis->high / axis->low) / log(axis->step)
                                 : (axis->high - axis->low) / axis->step;
    for (int i = 0; i <= (int)(steps + 1e-9); i++) {
        double x = factors ? axis->low * pow(axis->step, i) : axis->low + i * axis->step;
        double at = horizontal(axis, x);
        line(file, at, top + PLOT, at, top + PLOT + 5, "black");
        (void)fprintf(file, "<text x=\"%.2f\" y=\"%d\" text-anchor=\"middle\">", at,
                      top + PLOT + 20);
        tick_text(file, axis, x);
        (void)fputs("</text>\n", file);
    }
    (void)fprintf(file, "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\">%s</text>\n",
                  LEFT + SVG_COLUMNS / 2, top + PLOT + 41, axis->label);
}

static void vertical_ticks(FILE *file, const svg_axis *axis, int top)
{
    enum { TICKS = 6 };
    for (int i = 0; i <= TICKS; i++) {
        double error = axis->bottom + (axis->top - axis->bottom) * i / TICKS;
        double y = vertical(axis, top, error);
        line(file, LEFT - 5, y, LEFT + SVG_COLUMNS, y, grid_colour);
        (void)fprintf(file, "<text x=\"%d\" y=\"%.2f\" text-anchor=\"end\">%.4g</text>\n", LEFT - 9,
                      y + 4, fabs(error) < 1e-9 ? 0 : error);
    }
    (void)fprintf(file,
                  "<text transform=\"translate(20 %d) rotate(-90)\" text-anchor=\"middle\">"
                  "%s, ULP</text>\n",
                  top + PLOT / 2, axis->magnitude ? "|error|" : "error");
}

/* What is drawn through the middles of the columns. */
enum curve { LEAST, MEAN, LARGEST };

static double height_of(const svg_axis *axis, int top, const svg_column *column, enum curve which)
{
    double mean = column->sum / column->count;
    double error = which == MEAN ? mean : (which == LEAST ? column->low : column->high);
    return vertical(axis, top, error);
}

/* A curve is interrupted where a column is empty. */
static void curve(FILE *file, const svg_axis *axis, int top, const svg_column *column,
                  enum curve which, const char *colour)
{
    (void)fprintf(file, "<path fill=\"none\" stroke=\"%s\" d=\"", colour);
    bool pen_down = false;
    for (int c = 0; c < SVG_COLUMNS; c++) {
        if (column[c].count > 0) {
            (void)fprintf(file, "%s%d %.2f", pen_down ? "L" : "M", LEFT + c,
                          height_of(axis, top, &column[c], which));
            (void)fputs(pen_down ? "" : "h1", file); /* so that one column alone is seen */
        }
        pen_down = column[c].count > 0;
    }
    (void)fputs("\"/>\n", file);
}

/* Between the least and the largest error: a bar for every column. */
static void band(FILE *file, const svg_axis *axis, int top, const svg_column *column)
{
    (void)fprintf(file, "<path stroke=\"%s\" d=\"", band_colour);
    for (int c = 0; c < SVG_COLUMNS; c++) {
        if (column[c].count > 0) {
            double from = axis->magnitude ? top + PLOT : height_of(axis, top, &column[c], LEAST);
            (void)fprintf(file, "M%.1f %.2fV%.2f", LEFT + c + 0.5, from,
                          height_of(axis, top, &column[c], LARGEST));
        }
    }
    (void)fputs("\"/>\n", file);
}

static void limit_line(FILE *file, const svg_axis *axis, int top, double limit)
{
    if (limit < axis->bottom || limit > axis->top) {
        return;
    }
    double y = vertical(axis, top, limit);
    (void)fprintf(file, "<path d=\"M%d %.2fh%d\" stroke=\"%s\" stroke-dasharray=\"7 4\"/>\n", LEFT,
                  y, SVG_COLUMNS, limit_colour);
    (void)fprintf(file, "<text x=\"%d\" y=\"%.2f\" fill=\"%s\">limit %.4g</text>\n",
                  LEFT + SVG_COLUMNS + 6, y + 4, limit_colour, limit);
}

/* One entry of the legend, its right end at x; gives where the next one ends. */
static int legend_entry(FILE *file, int x, int y, const char *text, int width, const char *style)
{
    (void)fprintf(file, "<text x=\"%d\" y=\"%d\" text-anchor=\"end\">%s</text>\n", x, y + 4, text);
    (void)fprintf(file, "<path d=\"M%d %dh24\" stroke=\"%s\"/>\n", x - width - 30, y, style);
    return x - width - 50;
}

static void legend(FILE *file, const svg_axis *axis, int y)
{
    int x = LEFT + SVG_COLUMNS;
    if (axis->magnitude) {
        (void)legend_entry(file, x, y, "largest of each column", 150, edge_colour);
        return;
    }
    x = legend_entry(file, x, y, "mean", 35, mean_colour);
    (void)legend_entry(file, x, y, "least and largest of each column", 215, edge_colour);
}

static void panel_title(FILE *file, const svg_axis *axis, int y, const svg_column *column)
{
    double low = INFINITY;
    double high = -INFINITY;
    for (int c = 0; c < SVG_COLUMNS; c++) {
        if (column[c].count > 0) {
            low = fmin(low, column[c].low);
            high = fmax(high, column[c].high);
        }
    }
    (void)fprintf(file, "<text x=\"%d\" y=\"%d\">%s: ", LEFT, y, axis->title);
    if (axis->magnitude) {
        (void)fprintf(file, "up to %.4f ULP</text>\n", high);
    } else {
        (void)fprintf(file, "%.4f to %+.4f ULP</text>\n", low, high);
    }
}

void svg_panel(FILE *file, int index, const svg_axis *axis, const svg_column *column)
{
    const int top = TOP + index * PANEL + ABOVE;
    panel_title(file, axis, top - 11, column);
    legend(file, axis, top - 15);
    vertical_ticks(file, axis, top);
    band(file, axis, top, column);
    curve(file, axis, top, column, LARGEST, edge_colour);
    if (!axis->magnitude) {
        curve(file, axis, top, column, LEAST, edge_colour);
        curve(file, axis, top, column, MEAN, mean_colour);
        limit_line(file, axis, top, -axis->limit);
    }
    limit_line(file, axis, top, axis->limit);
    horizontal_ticks(file, axis, top);
    line(file, LEFT, top + PLOT, LEFT + SVG_COLUMNS, top + PLOT, "black");
    line(file, LEFT, top, LEFT, top + PLOT, "black");
}

void svg_end(FILE *file)
{
    (void)fputs("</svg>\n", file);
}
