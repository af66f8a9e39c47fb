/* SPDX-License-Identifier: MIT */
/*
 * Fits the polynomials of core/math by Remez' exchange and prints core/math/coefficients.h.
 *
 * Coefficients are rounded to their fixed-point formats from the highest power down, and the lower
 * ones are fitted again each time, so that they take up what the rounding of the higher ones lost.
 */
#include "coefficients.h"

#include <math.h>

#define TERMS_MAX   8
#define GRID        4000
#define EXTREMA_MAX 24

typedef long double real;

static const real pi = 3.14159265358979323846264338327950288L;
static const real ln2 = 0.693147180559945309417232121458176568L;

/* The functions, of v in [0, high]; each is continued to its limit at 0. */
static real sine(real v) /* sin(w pi / 4) / w, w^2 = v */
{
    real w = sqrtl(v);
    return w < 1e-6L ? pi / 4 : sinl(w * pi / 4) / w;
}

static real cosine(real v)
{
    return cosl(sqrtl(v) * pi / 4);
}

static real arctangent(real v) /* atan(w) / (pi w), w^2 = v */
{
    real w = sqrtl(v);
    return w < 1e-6L ? 1 / pi : atanl(w) / (pi * w);
}

static real binary_log(real v) /* log2(1 + v) / v */
{
    return v < 1e-12L ? 1 / ln2 : log1pl(v) / (ln2 * v);
}

static real binary_power(real v) /* (2^v - 1) / v - 1/2 */
{
    return (v < 1e-12L ? ln2 : expm1l(v * ln2) / v) - 0.5L;
}

static real area_tangent(real v) /* 2 atanh(w) / (w ln 2), w^2 = v */
{
    real w = sqrtl(v);
    return w < 1e-6L ? 2 / ln2 : 2 * atanhl(w) / (w * ln2);
}

typedef struct fit {
    real high; /* v is in [0, high] */
    const char *name;
    const char *what;
    real (*function)(real v);
    int terms;
    int bits[TERMS_MAX]; /* coefficient k is printed times 2^bits[k] */
} fit;

static const fit fits[] = {
    {1, "SINE", "sin(w pi/4) / w, w^2 = v in [0, 1]", sine, 4, {31, 33, 24, 30}},
    {1, "COSINE", "cos(w pi/4), w^2 = v in [0, 1]", cosine, 4, {30, 32, 36, 27}},
    {1 / 9.0L,
     "ATAN",
     "atan(w) / (pi w), w^2 = v in [0, 1/9]",
     arctangent,
     5,
     {32, 34, 34, 20, 20}},
    {1 / 16.0L, "LOG2", "log2(1 + v) / v, v in [0, 1/16]", binary_log, 3, {30, 31, 32}},
    {1,
     "EXP2",
     "(2^v - 1) / v - 1/2, v in [0, 1]",
     binary_power,
     8,
     {33, 33, 35, 35, 35, 35, 35, 35}},
    {0.0294372515228594L,
     "LOG2S",
     "2 atanh(w) / (w ln 2), w^2 = v in [0, 3 - sqrt(8)]^2",
     area_tangent,
     5,
     {30, 32, 32, 32, 16}},
};

static real polynomial(const real *c, int terms, real v)
{
    real sum = 0;
    for (int k = terms - 1; k >= 0; k--) {
        sum = sum * v + c[k];
    }
    return sum;
}

/* Gaussian elimination with pivots; the solution replaces column n. */
static void solve(real m[TERMS_MAX + 1][TERMS_MAX + 2], int n)
{
    for (int i = 0; i < n; i++) {
        int pivot = i;
        for (int row = i + 1; row < n; row++) {
            pivot = fabsl(m[row][i]) > fabsl(m[pivot][i]) ? row : pivot;
        }
        for (int k = 0; k <= n; k++) {
            real swap = m[i][k];
            m[i][k] = m[pivot][k];
            m[pivot][k] = swap;
        }
        for (int row = 0; row < n; row++) {
            real factor = row == i ? 0 : m[row][i] / m[i][i];
            for (int k = i; k <= n && row != i; k++) {
                m[row][k] -= factor * m[i][k];
            }
        }
    }
    for (int i = 0; i < n; i++) {
        m[i][n] /= m[i][i];
    }
}

/*
 * The extrema of the error between its changes of sign: the `count` in sequence that leave out the
 * least ones. False, and nothing found, if there are fewer.
 */
static int find_extrema(const fit *f, const real *c, int count, real *at)
{
    real place[EXTREMA_MAX];
    real size[EXTREMA_MAX] = {0};
    int last = 0;
    real previous = 0;
    for (int i = 0; i <= GRID; i++) {
        real v = f->high * (1 - cosl(pi * (real)i / GRID)) / 2;
        real error = f->function(v) - polynomial(c, f->terms, v);
        if (error * previous < 0 && ++last == EXTREMA_MAX) {
            return 0;
        }
        if (fabsl(error) >= size[last]) {
            size[last] = fabsl(error);
            place[last] = v;
        }
        previous = error != 0 ? error : previous;
    }
    int first = 0;
    while (last - first + 1 > count) {
        if (size[first] < size[last]) {
            first++;
        } else {
            last--;
        }
    }
    for (int i = 0; i < count && last - first + 1 == count; i++) {
        at[i] = place[first + i];
    }
    return last - first + 1 == count;
}

/* Fits c[0..unknown-1]; the ones above are given. */
static void exchange(const fit *f, real *c, int unknown)
{
    real at[TERMS_MAX + 1];
    for (int i = 0; i <= unknown; i++) {
        at[i] = f->high * (1 - cosl(pi * (real)i / (real)unknown)) / 2;
    }
    for (int round = 0; round < 12; round++) {
        real m[TERMS_MAX + 1][TERMS_MAX + 2];
        for (int k = 0; k < unknown; k++) {
            c[k] = 0;
        }
        for (int i = 0; i <= unknown; i++) { /* sum c v^k + (-1)^i e = what the others leave */
            for (int k = 0; k < unknown; k++) {
                m[i][k] = powl(at[i] / f->high, (real)k);
            }
            m[i][unknown] = i % 2 == 0 ? 1 : -1;
            m[i][unknown + 1] = f->function(at[i]) - polynomial(c, f->terms, at[i]);
        }
        solve(m, unknown + 1);
        for (int k = 0; k < unknown; k++) {
            c[k] = m[k][unknown + 1] / powl(f->high, (real)k);
        }
        if (!find_extrema(f, c, unknown + 1, at)) {
            return; /* rounding has bent the error: these points are good enough */
        }
    }
}

static void print_fit(FILE *out, const fit *f)
{
    real c[TERMS_MAX] = {0};
    for (int unknown = f->terms; unknown > 0; unknown--) {
        exchange(f, c, unknown);
        int k = unknown - 1;
        c[k] = ldexpl(roundl(ldexpl(c[k], f->bits[k])), -f->bits[k]);
    }
    real worst = 0;
    for (int i = 0; i <= GRID; i++) {
        real v = f->high * (real)i / GRID;
        real error = fabsl(f->function(v) - polynomial(c, f->terms, v));
        worst = error > worst ? error : worst;
    }
    fprintf(out, "\n/* %s, within 2^%.1Lf */\n", f->what, log2l(worst));
    for (int k = 0; k < f->terms; k++) {
        fprintf(out, "#define QTRI_%s_%d_Q%d %.0Lfu\n", f->name, k, f->bits[k],
                fabsl(ldexpl(c[k], f->bits[k])));
    }
}

/* For each sixteenth m of [1, 2): a factor that brings it to [1, 1 + 1/16], and minus its log2. */
static void print_log_table(FILE *out)
{
    real factor[16];
    fprintf(out,
            "\n/* For m in [1 + i/16, 1 + (i+1)/16): a factor f with m f in [1, 1 + 1/16], and "
            "-log2(f). */\n#define QTRI_LOG2_FACTORS_Q16 \\\n    {");
    for (int i = 0; i < 16; i++) {
        factor[i] = ceill(ldexpl(16, 16) / (real)(16 + i));
        fprintf(out, "%.0Lfu%s", factor[i], i == 15 ? "}\n" : (i % 8 == 7 ? ", \\\n     " : ", "));
    }
    fprintf(out, "#define QTRI_LOG2_OF_FACTORS_Q31 \\\n    {");
    for (int i = 0; i < 16; i++) {
        fprintf(out, "%.0Lfu%s", roundl(ldexpl(-log2l(ldexpl(factor[i], -16)), 31)) + 0.0L,
                i == 15 ? "}\n" : (i % 8 == 7 ? ", \\\n     " : ", "));
    }
}

void generate_coefficients(FILE *out)
{
    fprintf(out, "/* SPDX-License-Identifier: MIT */\n/*\n"
                 " * Printed by host/generate/coefficients.c (`make tables`): do not edit.\n"
                 " *\n"
                 " * Coefficient k of a polynomial in v times 2^Q, without its sign. Internal.\n"
                 " */\n"
                 "/* clang-format off */\n"
                 "#ifndef QTRI_MATH_COEFFICIENTS_H\n"
                 "#define QTRI_MATH_COEFFICIENTS_H\n");
    for (size_t i = 0; i < sizeof fits / sizeof fits[0]; i++) {
        print_fit(out, &fits[i]);
    }
    print_log_table(out);
    fprintf(out, "\n/* clang-format on */\n#endif\n");
}
