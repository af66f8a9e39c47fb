/* SPDX-License-Identifier: MIT */
/*
 * Work in a process of its own: what a broken file does there to a library's memory, time or stack
 * ends as one sentence here.
 */
#ifndef QTRI_HOST_ASSETS_APART_H
#define QTRI_HOST_ASSETS_APART_H

#include <stdbool.h>
#include <stdio.h>

#include "../io/text_error.h"

/* Writes an answer; false with *error set where there is none. Its own output goes nowhere. */
typedef bool apart_work(FILE *answer, void *context, struct text_error *error);

/*
 * The answer, to be read from where the stream is and closed; NULL with *error set, which begins
 * with `path`: what the work said, or that it took longer than a minute, more than 4 GB, or ended
 * in a crash.
 */
FILE *apart_run(const char *path, apart_work *work, void *context, struct text_error *error);

#endif
