/* SPDX-License-Identifier: MIT */
/*
 * qtri-verify: the accuracy of every function of core/math as a table, and plots of errors.
 */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */

#include "verify.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

typedef struct table {
    FILE *tsv;
    int failed;
} table;

static const char usage[] =
    "usage: qtri-verify [--quick | --full | --long] [--threads N] [--exact-only] [--quiet]\n"
    "                   [-o FILE.tsv] [FUNCTION...]\n"
    "       qtri-verify --plot sin|atan2|sqrt -o FILE.gp\n"
    "       qtri-verify --list\n";

static const char help[] =
    "\n"
    "The error of every function of the mathematics against correctly rounded references, as a\n"
    "table: the largest error in ULP (1 ULP = 1/65536), an input that gives it, and the share of\n"
    "correctly rounded results. Also what must hold for every input: monotone, odd, even, and\n"
    "the documented results elsewhere.\n"
    "\n"
    "  --quick       strata of the inputs, seconds\n"
    "  --full        every input of the functions of one argument; of those of two, all pairs of\n"
    "                4096 stress values and 2 10^7 random ones; minutes. The default.\n"
    "  --long        as --full, with 10^9 random arguments for those of two and three\n"
    "  --threads N   at once; 2\n"
    "  --exact-only  no shortcuts, every reference from MPFR or integers: the same table, days\n"
    "  --quiet       no progress on stderr\n"
    "  -o FILE       the table with tabs and a header line, or the plot\n"
    "  --plot NAME   the error over the domain as a program for gnuplot\n"
    "  --list        the names that FUNCTION can be\n"
    "\n"
    "Status: 0 when every row is within its limit, 1 when not, 2 when it could not be done.\n";

static void join_worst(const verify_row *row, int arguments, char *text, size_t room)
{
    text[0] = '\0';
    for (int i = 0; i < arguments; i++) {
        size_t used = strlen(text);
        (void)snprintf(text + used, room - used, "%s%ld", i > 0 ? "," : "", (long)row->worst[i]);
    }
}

/* With six decimals, rounded towards the worse: one wrong in 2^32 is not lost. */
static double percent(const verify_row *row)
{
    double share = 100 * (double)row->correct / (double)row->inputs;
    return row->correct == row->inputs ? 100 : floor(share * 1e6) / 1e6;
}

static double largest(const verify_row *row)
{
    return ceil(row->max * 1e6) / 1e6;
}

static void print_row(table *out, const verify_label *label, const verify_row *row)
{
    char name[64];
    char worst[VERIFY_ARGUMENTS * 12];
    bool passes = verify_row_passes(row, label);
    (void)snprintf(name, sizeof name, "%s%s", label->function, label->suffix);
    join_worst(row, label->arguments, worst, sizeof worst);
    printf("%-18s %-30s %11llu %11.6f %6.4g %11.6f  %s%s\n", name, label->domain,
           (unsigned long long)row->inputs, largest(row), label->limit, percent(row), worst,
           passes ? "" : "  <-- OVER ITS LIMIT");
    (void)fflush(stdout);
    if (out->tsv != NULL) {
        (void)fprintf(out->tsv, "%s\t%s\t%llu\t%.6f\t%s\t%.6f\n", name, label->domain,
                      (unsigned long long)row->inputs, largest(row), worst, percent(row));
        (void)fflush(out->tsv);
    }
    out->failed += !passes;
}

static void run_test(table *out, const verify_test *test, const verify_options *options)
{
    verify_row rows[VERIFY_ROWS];
    verify_run(test, options, rows);
    for (int i = 0; i < VERIFY_ROWS; i++) {
        if (rows[i].inputs > 0 && test->label[i].function != NULL) {
            print_row(out, &test->label[i], &rows[i]);
        }
    }
}

static double seconds(void)
{
    struct timespec now;
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

/* Keeps those tests that are named, or all where no name is given; false: a name without a test. */
static bool choose(verify_test *tests, size_t *count, char **names, int name_count)
{
    for (int n = 0; n < name_count; n++) {
        size_t i = 0;
        while (i < *count && strcmp(names[n], tests[i].name) != 0) {
            i++;
        }
        if (i == *count) {
            (void)fprintf(stderr, "qtri-verify: no function '%s'; --list names them\n", names[n]);
            return false;
        }
    }
    size_t kept = 0;
    for (size_t i = 0; i < *count; i++) {
        bool wanted = name_count == 0;
        for (int n = 0; n < name_count; n++) {
            wanted = wanted || strcmp(names[n], tests[i].name) == 0;
        }
        if (wanted) {
            tests[kept++] = tests[i];
        }
    }
    *count = kept;
    return true;
}

static void run_tests(table *out, const verify_test *tests, size_t count,
                      const verify_options *options)
{
    double start = seconds();
    for (size_t i = 0; i < count; i++) {
        char place[48]; /* of a hundred */
        verify_options placed = *options;
        (void)snprintf(place, sizeof place, "%2d/%d  ", (int)i + 1, (int)count);
        placed.progress = options->progress != NULL ? place : NULL;
        run_test(out, &tests[i], &placed);
    }
    printf("%d rows over their limit; %.0f s, %d threads\n", out->failed, seconds() - start,
           options->threads);
}

static int run_table(const verify_options *options, const char *file, char **names, int name_count)
{
    verify_test tests[VERIFY_TESTS];
    size_t count = verify_all_tests(tests);
    if (!choose(tests, &count, names, name_count)) {
        return 2;
    }
    table out = {NULL, 0};
    if (file != NULL && (out.tsv = fopen(file, "w")) == NULL) {
        perror(file);
        return 2;
    }
    if (out.tsv != NULL) {
        (void)fprintf(
            out.tsv, "function\tdomain\tinputs\tmax_ulp\tworst_input\tcorrectly_rounded_percent\n");
    }
    printf("%-18s %-30s %11s %11s %6s %11s  %s\n", "function", "domain", "inputs", "max ULP",
           "limit", "% correct", "worst input (raw Q16.16)");
    (void)fflush(stdout);
    run_tests(&out, tests, count, options);
    bool written = out.tsv == NULL || fclose(out.tsv) == 0;
    return out.failed > 0 || !written;
}

static int list(void)
{
    verify_test tests[VERIFY_TESTS];
    size_t count = verify_all_tests(tests);
    for (size_t i = 0; i < count; i++) {
        (void)puts(tests[i].name);
    }
    return 0;
}

static int plot(const char *name, const char *path)
{
    FILE *file = path != NULL ? fopen(path, "w") : NULL;
    if (file == NULL) {
        perror(path != NULL ? path : "-o FILE");
        return 2;
    }
    bool drawn = verify_plot(name, file);
    if (fclose(file) != 0 || !drawn) {
        (void)fprintf(stderr, "qtri-verify: no plot of '%s' in %s\n", name, path);
        return 2;
    }
    return 0;
}

int main(int argc, char **argv)
{
    verify_options options = {VERIFY_FULL, false, 2, ""};
    const char *file = NULL;
    const char *plotted = NULL;
    int i = 1;
    for (; i < argc && argv[i][0] == '-'; i++) {
        const char *value = i + 1 < argc ? argv[i + 1] : NULL;
        if (strcmp(argv[i], "--quick") == 0) {
            options.mode = VERIFY_QUICK;
        } else if (strcmp(argv[i], "--full") == 0) {
            options.mode = VERIFY_FULL;
        } else if (strcmp(argv[i], "--long") == 0) {
            options.mode = VERIFY_LONG;
        } else if (strcmp(argv[i], "--exact-only") == 0) {
            options.exact_only = true;
        } else if (strcmp(argv[i], "--quiet") == 0) {
            options.progress = NULL;
        } else if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
            return fputs(usage, stdout) < 0 || fputs(help, stdout) < 0;
        } else if (strcmp(argv[i], "--list") == 0) {
            return list();
        } else if (value != NULL && strcmp(argv[i], "--threads") == 0) {
            options.threads = (int)strtol(value, NULL, 10);
            i++;
        } else if (value != NULL && strcmp(argv[i], "--plot") == 0) {
            plotted = value;
            i++;
        } else if (value != NULL && strcmp(argv[i], "-o") == 0) {
            file = value;
            i++;
        } else {
            (void)fputs(usage, stderr);
            return 2;
        }
    }
    return plotted != NULL ? plot(plotted, file) : run_table(&options, file, argv + i, argc - i);
}
