/*
 * The error of a function over its domain as SVG: for every column of the picture the interval from
 * the least to the largest error of the inputs that fall into it.
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

/* Vertical axes, in ULP: all errors, or where the largest are. */
static const double envelope = 0.6;
static const double largest_from = 0.498;
static const double largest_to = 0.51;

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

static void widen(svg_interval *interval, double error)
{
    interval->low = error < interval->low ? error : interval->low;
    interval->high = error > interval->high ? error : interval->high;
}

/* The inputs of one argument from `low` to `high`, evenly or, for low > 0, by their logarithm. */
static void envelope_of_one(const verify_reference *reference, q16 (*f)(q16), double low,
                            double high, bool logarithmic, svg_interval *column)
{
    uint64_t seed = 5;
    for (int c = 0; c < SVG_COLUMNS; c++) {
        double from = logarithmic ? low * pow(high / low, (double)c / SVG_COLUMNS)
                                  : low + (high - low) * c / SVG_COLUMNS;
        double to = logarithmic ? low * pow(high / low, (double)(c + 1) / SVG_COLUMNS)
                                : low + (high - low) * (c + 1) / SVG_COLUMNS;
        double first = ceil(from);
        double count = ceil(to) - first;
        column[c] = svg_empty;
        for (int i = 0; i < SAMPLES && i < count; i++) {
            double offset = count <= SAMPLES ? i : floor(count * unit_random(&seed));
            q16 x = (q16)(first + offset);
            widen(&column[c], error_of(reference, &x, f(x)));
        }
    }
}

/* The interval from the foot of the picture to the largest magnitude. */
static void fold(svg_interval *interval)
{
    interval->high = fmax(-interval->low, interval->high);
    interval->low = largest_from;
}

/* Of the sine, over one turn; inputs from all turns. */
static void largest_of_phases(svg_interval *column)
{
    uint64_t seed = 9;
    for (int c = 0; c < SVG_COLUMNS; c++) {
        column[c] = svg_empty;
        for (int i = 0; i < MANY; i++) {
            double turn = floor(10000 * unit_random(&seed)) - 5000;
            double phase = 2 * PI * ((c + unit_random(&seed)) / SVG_COLUMNS - 0.5);
            q16 x = (q16)lrint((phase + 2 * PI * turn) * 65536);
            widen(&column[c], error_of(&verify_sin, &x, q16_sin(x)));
        }
        fold(&column[c]);
    }
}

static void envelope_panel(FILE *file, int index, svg_axis axis, double limit,
                           const svg_interval *column)
{
    axis.bottom = -envelope;
    axis.top = envelope;
    axis.limit = limit;
    svg_panel(file, index, &axis, column);
}

static void largest_panel(FILE *file, int index, svg_axis axis, double limit,
                          const svg_interval *column)
{
    axis.bottom = largest_from;
    axis.top = largest_to;
    axis.limit = limit;
    svg_panel(file, index, &axis, column);
}

static void plot_sin(FILE *file)
{
    static const svg_axis turns = {.label = "x in radians, two turns: every input",
                                   .low = -2 * PI,
                                   .high = 2 * PI,
                                   .step = PI / 2};
    static const svg_axis all = {.label = "x in radians, the whole range: 4000 inputs a column",
                                 .low = -32768,
                                 .high = 32768,
                                 .step = 8192};
    static const svg_axis phases = {
        .label = "largest |error| by phase in radians: 20000 inputs a column, of the whole range",
        .low = -PI,
        .high = PI,
        .step = PI / 4};
    svg_interval column[SVG_COLUMNS];
    svg_begin(file, "q16_sin: error in ULP (2^-16)", 3);
    envelope_of_one(&verify_sin, q16_sin, -2 * PI * 65536, 2 * PI * 65536, false, column);
    envelope_panel(file, 0, turns, 0.51, column);
    envelope_of_one(&verify_sin, q16_sin, Q16_MIN, Q16_MAX, false, column);
    envelope_panel(file, 1, all, 0.51, column);
    largest_of_phases(column);
    largest_panel(file, 2, phases, 0.51, column);
    svg_end(file);
}

static void plot_sqrt(FILE *file)
{
    static const svg_axis all = {.label = "x, logarithmic: up to 4000 inputs a column",
                                 .low = 0x1p-16,
                                 .high = 0x1p15,
                                 .step = 4,
                                 .logarithmic = true};
    static const svg_axis near_by = {
        .label = "x from 0 to 4: every input", .low = 0, .high = 4, .step = 0.5};
    svg_interval column[SVG_COLUMNS];
    svg_begin(file, "q16_sqrt: error in ULP (2^-16)", 2);
    envelope_of_one(&verify_sqrt, q16_sqrt, 1, 0x1p31, true, column);
    envelope_panel(file, 0, all, 0.5, column);
    envelope_of_one(&verify_sqrt, q16_sqrt, 0, Q16(4), false, column);
    envelope_panel(file, 1, near_by, 0.5, column);
    svg_end(file);
}

/* Points at the angles of each column, at radii of 2^low to 2^high raw units. */
static void envelope_of_angles(double low, double high, int samples, svg_interval *column)
{
    uint64_t seed = 7;
    for (int c = 0; c < SVG_COLUMNS; c++) {
        column[c] = svg_empty;
        for (int i = 0; i < samples; i++) {
            double angle = PI * (2 * (c + unit_random(&seed)) / SVG_COLUMNS - 1);
            double radius = exp2(low + (high - low) * unit_random(&seed));
            q16 a[2] = {(q16)lrint(radius * sin(angle)), (q16)lrint(radius * cos(angle))};
            widen(&column[c], error_of(&verify_atan2, a, q16_atan2(a[0], a[1])));
        }
    }
}

static svg_axis directions(const char *label)
{
    svg_axis axis = {.label = label, .low = -180, .high = 180, .step = 45};
    return axis;
}

static void plot_atan2(FILE *file)
{
    svg_interval column[SVG_COLUMNS];
    svg_begin(file, "q16_atan2: error in ULP (2^-16)", 3);
    envelope_of_angles(16, 30.99, SAMPLES, column);
    envelope_panel(file, 0,
                   directions("direction in degrees, radii 1 to 32767: 4000 points a column"), 0.53,
                   column);
    envelope_of_angles(0, 10, SAMPLES, column);
    envelope_panel(file, 1,
                   directions("direction in degrees, radii 2^-16 to 2^-6: 4000 points a column"),
                   0.53, column);
    envelope_of_angles(4, 30.99, MANY, column);
    for (int c = 0; c < SVG_COLUMNS; c++) {
        fold(&column[c]);
    }
    largest_panel(file, 2,
                  directions("largest |error| by direction in degrees: 20000 points a column"),
                  0.53, column);
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
