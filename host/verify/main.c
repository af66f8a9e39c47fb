/*
 * qtri-verify: the accuracy of every function of core/math as a table, and plots of errors.
 */
#define _POSIX_C_SOURCE 200809L /* isatty, clock_gettime */

#include "verify.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

typedef struct table {
    FILE *tsv;
    int failed;
} table;

static const char usage[] =
    "usage: qtri-verify [--quick | --full | --long] [--exact-only] [--threads N] "
    "[-o FILE.tsv] [FUNCTION...]\n"
    "       qtri-verify --plot sin|atan2|sqrt -o FILE.svg\n"
    "       qtri-verify --list\n";

static void join_worst(const verify_row *row, int arguments, char *text, size_t room)
{
    text[0] = '\0';
    for (int i = 0; i < arguments; i++) {
        size_t used = strlen(text);
        (void)snprintf(text + used, room - used, "%s%ld", i > 0 ? "," : "", (long)row->worst[i]);
    }
}

/* Rounded towards the worse: .51001 is not shown as .5100, nor is one wrong in 2^32 lost. */
static double percent(const verify_row *row)
{
    double share = 100 * (double)row->correct / (double)row->inputs;
    return row->correct < row->inputs && share > 99.999999 ? 99.999999 : share;
}

static void print_row(table *out, const verify_label *label, const verify_row *row)
{
    char name[64];
    char worst[160];
    bool passes = verify_row_passes(row, label);
    (void)snprintf(name, sizeof name, "%s%s", label->function, label->suffix);
    join_worst(row, label->arguments, worst, sizeof worst);
    printf("%-18s %-30s %11llu %11.6f %6.4g %11.6f  %s%s\n", name, label->domain,
           (unsigned long long)row->inputs, row->max, label->limit, percent(row), worst,
           passes ? "" : "  <-- OVER ITS LIMIT");
    (void)fflush(stdout);
    if (out->tsv != NULL) {
        (void)fprintf(out->tsv, "%s\t%s\t%llu\t%.6f\t%s\t%.6f\n", name, label->domain,
                      (unsigned long long)row->inputs, row->max, worst, percent(row));
        (void)fflush(out->tsv);
    }
    out->failed += !passes;
}

static void run_test(table *out, const verify_test *test, const verify_options *options)
{
    verify_row rows[VERIFY_ROWS];
    verify_run(test, options, rows);
    for (int i = 0; i < VERIFY_ROWS; i++) {
        verify_label label;
        if (rows[i].inputs > 0 && test->label(test, i, &label)) {
            print_row(out, &label, &rows[i]);
        }
    }
}

static double seconds(void)
{
    struct timespec now;
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

static int run_table(const verify_options *options, const char *file, char **names, int name_count)
{
    verify_test tests[VERIFY_TESTS];
    size_t count = verify_all_tests(tests);
    for (int n = 0; n < name_count; n++) {
        size_t i = 0;
        while (i < count && strcmp(names[n], tests[i].name) != 0) {
            i++;
        }
        if (i == count) {
            (void)fprintf(stderr, "qtri-verify: no function '%s'; --list names them\n", names[n]);
            return 2;
        }
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
    double start = seconds();
    for (size_t i = 0; i < count; i++) {
        bool wanted = name_count == 0;
        for (int n = 0; n < name_count; n++) {
            wanted = wanted || strcmp(names[n], tests[i].name) == 0;
        }
        if (wanted) {
            run_test(&out, &tests[i], options);
        }
    }
    bool written = out.tsv == NULL || fclose(out.tsv) == 0;
    printf("%d rows over their limit, %.0f s\n", out.failed, seconds() - start);
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
    verify_options options = {VERIFY_FULL, false, isatty(STDERR_FILENO) != 0, 2};
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
