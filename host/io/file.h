/* SPDX-License-Identifier: MIT */
/*
 * Files as a whole: read into memory, or written so that they appear complete or not at all.
 */
#ifndef QTRI_HOST_IO_FILE_H
#define QTRI_HOST_IO_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "text_error.h"

#define FILE_MAX_BYTES ((size_t)1 << 30) /* a larger file is an error */

struct file_content {
    char *bytes; /* free() it */
    size_t length;
};

#define FILE_PIPE_SECONDS 10 /* a pipe that says nothing for so long is an error */

/* Reads all of a file, a pipe or a device, "-": standard input; an empty one is fine. False with
 *error set. */
bool file_read(const char *path, struct file_content *content, struct text_error *error);

/* Whether a name ends in `end`, .png for example, and is more than that. */
bool file_name_ends_in(const char *name, const char *end);

/* FOLDER OF `beside`/name in `out`, or `name` where it is absolute. False if that does not fit. */
bool file_path_beside(char *out, size_t size, const char *beside, const char *name);

/* "-", a device, a pipe: what cannot be replaced as a whole. */
bool file_is_stream(const char *path);

/*
 * A file being written. The bytes go to a temporary file in the target's folder, which takes the
 * target's name on commit; until then, and after any failure, the target is as it was. Signals
 * that end the program remove the temporary file. What is no ordinary file, and "-", standard
 * output, is written as it is. One output is open at a time. Of a program that guards its inputs
 * (file_inputs.h) none can be a target.
 */
struct file_output {
    FILE *stream;
    char *path;
    char *temporary; /* NULL: written as it is */
    int failure;     /* errno of the first write that failed */
};

bool file_output_open(struct file_output *output, const char *path, struct text_error *error);

/* Failures are kept and reported by commit. */
void file_output_write(struct file_output *output, const void *bytes, size_t length);

/* Ends the output: the target is complete, or false with *error set. */
bool file_output_commit(struct file_output *output, struct text_error *error);

/* Gives the output up: the target stays as it was. */
void file_output_cancel(struct file_output *output);

/* For signal handlers that end the program: removes the temporary file of an output that is open.
 */
void file_remove_unfinished(void);

#endif
