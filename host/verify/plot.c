/* SPDX-License-Identifier: MIT */
/*
 * The error of a function over its domain, as a program for gnuplot with its data: for every column
 * of a panel the least, the mean and the largest error of the inputs that fall into it. Rounding
 * alone makes half an ULP of either sign nearly everywhere; what the algorithm adds to that is
 * shown by the panels of the magnitude.
 */
#include "reference.h"

#include "qtri/q16.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define PI 3.14159265358979323846

enum { COLUMNS = 480, PANELS = 3 };

typedef struct plot_panel {
    const char *title;
    double low, high, step; /* of the axis; step: between marks, of a logarithmic axis a factor */
    double bottom, top, limit;
    int samples; /* a column, if it has as many inputs */
    bool is_logarithmic, is_magnitude;
    double radius_low, radius_high; /* of atan2: log2, raw */
} plot_panel;

typedef struct error_plot {
    const char *name, *title, *label;
    const verify_reference *reference;
    /* The error at input i of the column from x0 to x1. */
    double (*error)(const struct error_plot *plot, const plot_panel *panel, double x0, double x1,
                    int i, uint64_t *seed);
    q16 (*function)(q16);
    plot_panel panels[PANELS];
} error_plot;

static double unit_random(uint64_t *seed)
{
    return (double)(verify_random(seed) >> 11) * 0x1p-53;
}

/* result - exact, in ULP. */
static double error_of(const verify_reference *reference, const q16 *argument, q16 result)
{
    if (reference->fast == NULL) {
        const verify_exact exact = reference->exact(reference->data, argument);
        return (double)(result - exact.nearest) - exact.delta;
    }
    return (double)result - reference->fast(reference->data, argument).value;
}

/* Every input where there are few, otherwise a random one; NaN behind the last. */
static double curve(const error_plot *plot, const plot_panel *panel, double x0, double x1, int i,
                    uint64_t *seed)
{
    const double first = ceil(65536 * x0), count = ceil(65536 * x1) - first;
    if (i >= count) {
        return NAN;
    }
    const q16 x = (q16)(first + (count <= panel->samples ? i : floor(count * unit_random(seed))));
    return error_of(plot->reference, &x, plot->function(x));
}

/* x is an angle of one turn; the input any of 10,000 turns. */
static double phase(const error_plot *plot, const plot_panel *panel, double x0, double x1, int i,
                    uint64_t *seed)
{
    if (!panel->is_magnitude) {
        return curve(plot, panel, x0, x1, i, seed);
    }
    const double turn = floor(10000 * unit_random(seed)) - 5000;
    const q16 x = (q16)lrint((x0 + (x1 - x0) * unit_random(seed) + 2 * PI * turn) * 65536);
    return error_of(plot->reference, &x, plot->function(x));
}

/* x is a direction in degrees. */
static double direction(const error_plot *plot, const plot_panel *panel, double x0, double x1,
                        int i, uint64_t *seed)
{
    const double angle = (x0 + (x1 - x0) * unit_random(seed)) * PI / 180;
    const double radius =
        exp2(panel->radius_low + (panel->radius_high - panel->radius_low) * unit_random(seed));
    const q16 a[2] = {(q16)lrint(radius * sin(angle)), (q16)lrint(radius * cos(angle))};
    (void)i;
    return error_of(plot->reference, a, q16_atan2(a[0], a[1]));
}

static const error_plot plots[] = {
    {"sin",
     "q16_sin: result minus sine, in ULP (1 ULP = 1/65536)",
     "x in radians",
     &verify_sin,
     phase,
     q16_sin,
     {{"Two turns, every input", -2 * PI, 2 * PI, PI / 2, -.6, .6, .51, 4000, false, false, 0, 0},
      {"The whole range, 4000 inputs a column", -32768, 32768, 8192, -.6, .6, .51, 4000, false,
       false, 0, 0},
      {"By phase, 20000 inputs a column from the whole range", -PI, PI, PI / 4, .498, .51, .51,
       20000, false, true, 0, 0}}},
    {"atan2",
     "q16_atan2: result minus angle, in ULP (1 ULP = 1/65536 radian)",
     "direction of (x, y) in degrees",
     &verify_atan2,
     direction,
     NULL,
     {{"Radii 1 to 32767, 4000 points a column", -180, 180, 45, -.6, .6, .53, 4000, false, false,
       16, 30.99},
      {"Radii 1/65536 to 1/64, 4000 points a column", -180, 180, 45, -.6, .6, .53, 4000, false,
       false, 0, 10},
      {"Radii 1/4096 to 32767, 20000 points a column (limit 0.53)", -180, 180, 45, .4995, .5007,
       .53, 20000, false, true, 4, 30.99}}},
    {"sqrt",
     "q16_sqrt: result minus root, in ULP (1 ULP = 1/65536)",
     "x",
     &verify_sqrt,
     curve,
     q16_sqrt,
     {{"The whole range, up to 4000 inputs a column", 0x1p-16, 0x1p15, 32, -.6, .6, .5, 4000, true,
       false, 0, 0},
      {"From 0 to 4, every input", 0, 4, .5, -.6, .6, .5, 4000, false, false, 0, 0},
      {"The whole range, up to 20000 inputs a column", 0x1p-16, 0x1p15, 32, .49, .502, .5, 20000,
       true, true, 0, 0}}}};

/* Where column c begins. */
static double edge(const plot_panel *panel, int c)
{
    const double share = (double)c / COLUMNS;
    return panel->is_logarithmic ? panel->low * pow(panel->high / panel->low, share)
                                 : panel->low + (panel->high - panel->low) * share;
}

static void write_panel(FILE *file, const error_plot *plot, const plot_panel *panel)
{
    uint64_t seed = 5;
    fprintf(file,
            "set title '%s'\nset xtics %.9g\nset yrange [%g:%g]\n%s logscale x\n$data << END\n",
            panel->title, panel->step, panel->bottom, panel->top,
            panel->is_logarithmic ? "set" : "unset");
    for (int c = 0; c < COLUMNS; c++) {
        double low = INFINITY, high = -INFINITY, sum = 0;
        int count = 0;
        for (int i = 0; i < panel->samples; i++) {
            double error = plot->error(plot, panel, edge(panel, c), edge(panel, c + 1), i, &seed);
            if (isnan(error)) {
                break;
            }
            error = panel->is_magnitude ? fabs(error) : error;
            low = fmin(low, error);
            high = fmax(high, error);
            sum += error;
            count++;
        }
        if (count > 0) {
            fprintf(file, "%.9g %.6f %.6f %.6f\n", edge(panel, c), low, sum / count, high);
        }
    }
    fprintf(file,
            "END\nplot [%.9g:%.9g] $data using 1:2:4 with filledcurves lc rgb '#9ecae1' notitle, "
            "$data using 1:4 with lines lc rgb '#3182bd' notitle, "
            "$data using 1:3 with lines lc rgb '#08519c' notitle, %g lc rgb '#de2d26' notitle, "
            "%g lc rgb '#de2d26' notitle\n",
            panel->low, panel->high, panel->limit,
            panel->is_magnitude ? panel->limit : -panel->limit);
}

bool verify_plot(const char *name, FILE *file)
{
    const error_plot *plot = plots;
    while (plot < plots + sizeof plots / sizeof *plots && strcmp(name, plot->name) != 0) {
        plot++;
    }
    if (plot == plots + sizeof plots / sizeof *plots) {
        return false;
    }
    fprintf(file,
            "set terminal svg size 960,900 background '#ffffff'\n"
            "set multiplot layout %d,1 title \"%s\" noenhanced\nset format x '%%.4g'\nset xlabel "
            "'%s'\n",
            PANELS, plot->title, plot->label);
    for (int i = 0; i < PANELS; i++) {
        write_panel(file, plot, &plot->panels[i]);
    }
    return ferror(file) == 0;
}
