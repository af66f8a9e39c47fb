#include "svg.h"

#include <math.h>

const svg_interval svg_empty = {1e9, -1e9};

enum {
    LEFT = 84,
    RIGHT = 40,
    TOP = 50,
    PANEL = 260,
    PLOT = 190,
    WIDTH = LEFT + SVG_COLUMNS + RIGHT
};

void svg_begin(FILE *file, const char *title, int panels)
{
    int height = TOP + panels * PANEL;
    (void)fprintf(file,
                  "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" "
                  "viewBox=\"0 0 %d %d\" font-family=\"sans-serif\" font-size=\"13\">\n"
                  "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n"
                  "<text x=\"%d\" y=\"28\" font-size=\"18\">%s</text>\n",
                  WIDTH, height, WIDTH, height, LEFT, title);
}

static double vertical(const svg_axis *axis, int top, double error)
{
    double held = fmax(axis->bottom, fmin(axis->top, error));
    return top + (axis->top - held) / (axis->top - axis->bottom) * PLOT;
}

static double horizontal(const svg_axis *axis, double x)
{
    double share = axis->logarithmic ? log(x / axis->low) / log(axis->high / axis->low)
                                     : (x - axis->low) / (axis->high - axis->low);
    return LEFT + share * SVG_COLUMNS;
}

static void line(FILE *file, double x0, double y0, double x1, double y1, const char *colour)
{
    (void)fprintf(file, "<path d=\"M%.2f %.2fL%.2f %.2f\" stroke=\"%s\"/>\n", x0, y0, x1, y1,
                  colour);
}

static void horizontal_ticks(FILE *file, const svg_axis *axis, int top)
{
    const double steps = axis->logarithmic ? log(axis->high / axis->low) / log(axis->step)
                                           : (axis->high - axis->low) / axis->step;
    for (int i = 0; i <= (int)(steps + 1e-9); i++) {
        double x = axis->logarithmic ? axis->low * pow(axis->step, i) : axis->low + i * axis->step;
        double at = horizontal(axis, x);
        line(file, at, top + PLOT, at, top + PLOT + 5, "black");
        (void)fprintf(file, "<text x=\"%.2f\" y=\"%d\" text-anchor=\"middle\">", at,
                      top + PLOT + 19);
        if (axis->logarithmic) {
            (void)fprintf(file, "2^%.3g</text>\n", log2(x));
        } else {
            (void)fprintf(file, "%.5g</text>\n", x);
        }
    }
}

static void vertical_ticks(FILE *file, const svg_axis *axis, int top)
{
    enum { TICKS = 6 };
    for (int i = 0; i <= TICKS; i++) {
        double error = axis->bottom + (axis->top - axis->bottom) * i / TICKS;
        double y = vertical(axis, top, error);
        line(file, LEFT - 5, y, LEFT + SVG_COLUMNS, y, "#ddd");
        (void)fprintf(file, "<text x=\"%d\" y=\"%.2f\" text-anchor=\"end\">%.4g</text>\n", LEFT - 9,
                      y + 4, error);
    }
    (void)fprintf(file,
                  "<text transform=\"translate(18 %d) rotate(-90)\" text-anchor=\"middle\">"
                  "error, ULP</text>\n",
                  top + PLOT / 2);
}

/* A bar for every column, as one path; a column beyond the axis is drawn in red to its edge. */
static void envelope(FILE *file, const svg_axis *axis, int top, const svg_interval *column)
{
    for (int beyond = 0; beyond < 2; beyond++) {
        (void)fprintf(file, "<path stroke=\"%s\" d=\"", beyond ? "#d00" : "#27c");
        for (int c = 0; c < SVG_COLUMNS; c++) {
            double low = column[c].low;
            double high = column[c].high;
            bool out = low < axis->bottom || high > axis->top;
            if (low <= high && out == (beyond == 1)) {
                double from = vertical(axis, top, low) + 0.5;
                double to = vertical(axis, top, high) - 0.5;
                (void)fprintf(file, "M%.1f %.2fV%.2f", LEFT + c + 0.5, from, to);
            }
        }
        (void)fputs("\"/>\n", file);
    }
}

void svg_panel(FILE *file, int index, const svg_axis *axis, const svg_interval *column)
{
    int top = TOP + index * PANEL;
    double low = svg_empty.low;
    double high = svg_empty.high;
    for (int c = 0; c < SVG_COLUMNS; c++) {
        low = fmin(low, column[c].low);
        high = fmax(high, column[c].high);
    }
    vertical_ticks(file, axis, top);
    envelope(file, axis, top, column);
    horizontal_ticks(file, axis, top);
    if (axis->limit <= axis->top) {
        double y = vertical(axis, top, axis->limit);
        line(file, LEFT, y, LEFT + SVG_COLUMNS, y, "#d00");
    }
    line(file, LEFT, top + PLOT, LEFT + SVG_COLUMNS, top + PLOT, "black");
    line(file, LEFT, top, LEFT, top + PLOT, "black");
    (void)fprintf(file, "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\">%s (%.4f to %.4f)</text>\n",
                  LEFT + SVG_COLUMNS / 2, top + PLOT + 40, axis->label, low, high);
}

void svg_end(FILE *file)
{
    (void)fputs("</svg>\n", file);
}
