/* SPDX-License-Identifier: MIT */
/*
 * The error of a function over its domain as SVG: for every column of the picture the least, the
 * mean and the largest error of the inputs that fall into it. Rounding alone makes half an ULP of
 * either sign nearly everywhere; what the algorithm adds to that is shown by the panels of the
 * magnitude.
 */
#include "svg.h"

#include "reference.h"

#include "qtri/q16_trig.h"

#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846

enum {
    SAMPLES = 4000, /* in each column, if it has as many */
    MANY = 20000    /* where only the largest counts */
};

static double unit_random(uint64_t *seed)
{
    return (double)(verify_random(seed) >> 11) * 0x1p-53;
}

/* result - exact, in ULP. */
static double error_of(const verify_reference *reference, const q16 *argument, q16 result)
{
    verify_exact exact = {0, 0};
    if (reference->fast == NULL) {
        exact = reference->exact(reference->data, argument);
        return (double)(result - exact.nearest) - exact.delta;
    }
    return (double)result - reference->fast(reference->data, argument).value;
}

static void clear(svg_column *column)
{
    static const svg_column empty = {INFINITY, -INFINITY, 0, 0};
    *column = empty;
}

static void include(svg_column *column, double error)
{
    column->low = fmin(column->low, error);
    column->high = fmax(column->high, error);
    column->sum += error;
    column->count++;
}

/* A panel of up to `samples` inputs of one argument a column; beyond that, a random choice. */
typedef struct curve {
    const verify_reference *reference;
    q16 (*function)(q16);
    int samples;
} curve;

/* Where column c begins, raw. */
static double edge(const svg_axis *axis, int c)
{
    double share = (double)c / SVG_COLUMNS;
    double x = axis->scale == SVG_POWERS ? axis->low * pow(axis->high / axis->low, share)
                                         : axis->low + (axis->high - axis->low) * share;
    return ceil(65536 * x);
}

static void plot_curve(FILE *file, int index, const curve *plotted, const svg_axis *axis)
{
    svg_column column[SVG_COLUMNS];
    uint64_t seed = 5;
    for (int c = 0; c < SVG_COLUMNS; c++) {
        double first = edge(axis, c);
        double count = edge(axis, c + 1) - first;
        clear(&column[c]);
        for (int i = 0; i < plotted->samples && i < count; i++) {
            double offset = count <= plotted->samples ? i : floor(count * unit_random(&seed));
            q16 x = (q16)(first + offset);
            double error = error_of(plotted->reference, &x, plotted->function(x));
            include(&column[c], axis->magnitude ? fabs(error) : error);
        }
    }
    svg_panel(file, index, axis, column);
}

/* Of the sine, over one turn; inputs from all turns. */
static void plot_phases(FILE *file, int index, const svg_axis *axis)
{
    svg_column column[SVG_COLUMNS];
    uint64_t seed = 9;
    for (int c = 0; c < SVG_COLUMNS; c++) {
        clear(&column[c]);
        for (int i = 0; i < MANY; i++) {
            double turn = floor(10000 * unit_random(&seed)) - 5000;
            double phase = 2 * PI * ((c + unit_random(&seed)) / SVG_COLUMNS - 0.5);
            q16 x = (q16)lrint((phase + 2 * PI * turn) * 65536);
            include(&column[c], fabs(error_of(&verify_sin, &x, q16_sin(x))));
        }
    }
    svg_panel(file, index, axis, column);
}

static void plot_sin(FILE *file)
{
    static const curve sine = {&verify_sin, q16_sin, SAMPLES};
    static const svg_axis turns = {.title = "Two turns, every input",
                                   .label = "x in radians",
                                   .low = -2 * PI,
                                   .high = 2 * PI,
                                   .step = PI / 2,
                                   .scale = SVG_TURNS,
                                   .bottom = -0.6,
                                   .top = 0.6,
                                   .limit = 0.51};
    static const svg_axis all = {.title = "The whole range, 4000 inputs a column",
                                 .label = "x in radians",
                                 .low = -32768,
                                 .high = 32768,
                                 .step = 8192,
                                 .bottom = -0.6,
                                 .top = 0.6,
                                 .limit = 0.51};
    static const svg_axis phases = {.title = "By phase, 20000 inputs a column from the whole range",
                                    .label = "x modulo one turn, in radians",
                                    .low = -PI,
                                    .high = PI,
                                    .step = PI / 4,
                                    .scale = SVG_TURNS,
                                    .magnitude = true,
                                    .bottom = 0.498,
                                    .top = 0.51,
                                    .limit = 0.51};
    svg_begin(file, "q16_sin: result minus sine, in ULP (1 ULP = 1/65536)", 3);
    plot_curve(file, 0, &sine, &turns);
    plot_curve(file, 1, &sine, &all);
    plot_phases(file, 2, &phases);
    svg_end(file);
}

static void plot_sqrt(FILE *file)
{
    static const curve root = {&verify_sqrt, q16_sqrt, SAMPLES};
    static const curve densely = {&verify_sqrt, q16_sqrt, MANY};
    static const svg_axis all = {.title = "The whole range, up to 4000 inputs a column",
                                 .label = "x, logarithmic",
                                 .low = 0x1p-16,
                                 .high = 0x1p15,
                                 .step = 4,
                                 .scale = SVG_POWERS,
                                 .bottom = -0.6,
                                 .top = 0.6,
                                 .limit = 0.5};
    static const svg_axis near_by = {.title = "From 0 to 4, every input",
                                     .label = "x",
                                     .low = 0,
                                     .high = 4,
                                     .step = 0.5,
                                     .bottom = -0.6,
                                     .top = 0.6,
                                     .limit = 0.5};
    static const svg_axis largest = {.title = "The whole range, up to 20000 inputs a column",
                                     .label = "x, logarithmic",
                                     .low = 0x1p-16,
                                     .high = 0x1p15,
                                     .step = 4,
                                     .scale = SVG_POWERS,
                                     .magnitude = true,
                                     .bottom = 0.49,
                                     .top = 0.502,
                                     .limit = 0.5};
    svg_begin(file, "q16_sqrt: result minus root, in ULP (1 ULP = 1/65536)", 3);
    plot_curve(file, 0, &root, &all);
    plot_curve(file, 1, &root, &near_by);
    plot_curve(file, 2, &densely, &largest);
    svg_end(file);
}

/* Points at the angles of each column, at radii of 2^low to 2^high raw units. */
static void plot_angles(FILE *file, int index, const svg_axis *axis, double low, double high)
{
    svg_column column[SVG_COLUMNS];
    uint64_t seed = 7;
    for (int c = 0; c < SVG_COLUMNS; c++) {
        clear(&column[c]);
        for (int i = 0; i < (axis->magnitude ? MANY : SAMPLES); i++) {
            double angle = PI * (2 * (c + unit_random(&seed)) / SVG_COLUMNS - 1);
            double radius = exp2(low + (high - low) * unit_random(&seed));
            q16 a[2] = {(q16)lrint(radius * sin(angle)), (q16)lrint(radius * cos(angle))};
            double error = error_of(&verify_atan2, a, q16_atan2(a[0], a[1]));
            include(&column[c], axis->magnitude ? fabs(error) : error);
        }
    }
    svg_panel(file, index, axis, column);
}

static void plot_atan2(FILE *file)
{
    static const svg_axis far = {.title = "Radii 1 to 32767, 4000 points a column",
                                 .label = "direction of (x, y) in degrees",
                                 .low = -180,
                                 .high = 180,
                                 .step = 45,
                                 .bottom = -0.6,
                                 .top = 0.6,
                                 .limit = 0.53};
    static const svg_axis near_by = {.title = "Radii 1/65536 to 1/64, 4000 points a column",
                                     .label = "direction of (x, y) in degrees",
                                     .low = -180,
                                     .high = 180,
                                     .step = 45,
                                     .bottom = -0.6,
                                     .top = 0.6,
                                     .limit = 0.53};
    static const svg_axis largest = {
        .title = "Radii 1/4096 to 32767, 20000 points a column (limit 0.53)",
        .label = "direction of (x, y) in degrees",
        .low = -180,
        .high = 180,
        .step = 45,
        .magnitude = true,
        .bottom = 0.4995,
        .top = 0.5007,
        .limit = 0.53};
    svg_begin(file, "q16_atan2: result minus angle, in ULP (1 ULP = 1/65536 radian)", 3);
    plot_angles(file, 0, &far, 16, 30.99);
    plot_angles(file, 1, &near_by, 0, 10);
    plot_angles(file, 2, &largest, 4, 30.99);
    svg_end(file);
}

bool verify_plot(const char *name, FILE *file)
{
    static const struct {
        const char *name;
        void (*draw)(FILE *);
    } plots[] = {{"sin", plot_sin}, {"atan2", plot_atan2}, {"sqrt", plot_sqrt}};
    for (size_t i = 0; i < sizeof plots / sizeof plots[0]; i++) {
        if (strcmp(name, plots[i].name) == 0) {
            plots[i].draw(file);
            return ferror(file) == 0;
        }
    }
    return false;
}
