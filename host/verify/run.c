/* SPDX-License-Identifier: MIT */
/*
 * Chunks of a test, shared out to threads; each has rows of its own, merged at the end.
 */
#define _POSIX_C_SOURCE 200809L /* isatty, clock_gettime */

#include "table.h"
#include "tuple.h"

#include <assert.h>
#include <pthread.h>
#include <time.h>
#include <unistd.h>

typedef struct job {
    const verify_test *test;
    const verify_options *options;
    pthread_mutex_t mutex; /* of what follows */
    uint64_t next, chunks;
    verify_row *rows;
    bool terminal;        /* is stderr */
    time_t started, said; /* when it last said how far it is */
} job;

static time_t now(void)
{
    struct timespec clock;
    (void)clock_gettime(CLOCK_MONOTONIC, &clock);
    return clock.tv_sec;
}

/* On a terminal one line that changes, each second; elsewhere a new line every ten seconds. */
static void say(job *j, uint64_t chunk)
{
    const time_t clock = now();
    if (clock - j->said < (j->terminal ? 1 : 10)) {
        return;
    }
    j->said = clock;
    (void)fprintf(stderr, "%s%s%-18s %3d %%  %4ld s%s", j->terminal ? "\r" : "",
                  j->options->progress, j->test->name, (int)(chunk * 100 / j->chunks),
                  (long)(clock - j->started), j->terminal ? "" : "\n");
}

/* The next chunk, or `chunks`. Says how far it is. */
static uint64_t take(job *j)
{
    (void)pthread_mutex_lock(&j->mutex);
    uint64_t chunk = j->next;
    if (chunk < j->chunks) {
        j->next++;
    }
    if (j->options->progress != NULL) {
        say(j, chunk);
    }
    (void)pthread_mutex_unlock(&j->mutex);
    return chunk;
}

static void *work(void *argument)
{
    job *j = (job *)argument;
    verify_row rows[VERIFY_ROWS];
    for (int i = 0; i < VERIFY_ROWS; i++) {
        verify_row_clear(&rows[i]);
    }
    for (uint64_t chunk = take(j); chunk < j->chunks; chunk = take(j)) {
        j->test->run(j->test, j->options, chunk, rows);
    }
    (void)pthread_mutex_lock(&j->mutex);
    for (int i = 0; i < VERIFY_ROWS; i++) {
        verify_row_merge(&j->rows[i], &rows[i]);
    }
    (void)pthread_mutex_unlock(&j->mutex);
    return NULL;
}

void verify_run(const verify_test *test, const verify_options *options, verify_row *rows)
{
    enum { MOST = 64 };
    pthread_t thread[MOST];
    bool started[MOST] = {false};
    for (int i = 0; i < VERIFY_ROWS; i++) {
        verify_row_clear(&rows[i]);
    }
    job j = {.test = test,
             .options = options,
             .mutex = PTHREAD_MUTEX_INITIALIZER,
             .chunks = test->chunks(test, options),
             .rows = rows,
             .terminal = isatty(STDERR_FILENO) != 0,
             .started = now(),
             .said = now()};
    for (int i = 0; i < options->threads - 1 && i < MOST; i++) {
        started[i] = pthread_create(&thread[i], NULL, work, &j) == 0;
    }
    (void)work(&j); /* one of them, and the only one where threads are not to be had */
    for (int i = 0; i < MOST; i++) {
        if (started[i]) {
            (void)pthread_join(thread[i], NULL);
        }
    }
    (void)pthread_mutex_destroy(&j.mutex);
    if (options->progress != NULL && j.terminal) {
        (void)fprintf(stderr, "\r%60s\r", "");
    }
}

size_t verify_all_tests(verify_test tests[VERIFY_TESTS])
{
    size_t count = 0;
    assert(verify_function_count + VERIFY_PROPERTIES + verify_length_count + verify_product_count <
           VERIFY_TESTS);
    for (size_t i = 0; i < verify_function_count; i++) {
        tests[count++] = verify_scalar_test(&verify_functions[i]);
    }
    for (size_t i = 0; i < VERIFY_PROPERTIES; i++) {
        tests[count++] = verify_property_tests[i];
    }
    for (size_t i = 0; i < verify_length_count; i++) {
        tests[count++] = verify_tuple_test(&verify_lengths[i]);
    }
    for (size_t i = 0; i < verify_product_count; i++) {
        tests[count++] = verify_tuple_test(&verify_products[i]);
    }
    tests[count++] = verify_power_test;
    return count;
}
