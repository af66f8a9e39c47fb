/* SPDX-License-Identifier: MIT */
/*
 * What a command has read, so that it does not write over it: of a name given twice by mistake, or
 * of a link, the original would be lost with status 0. Only a program that asks for it is guarded,
 * as tests read and write the same file on purpose.
 */
#ifndef QTRI_HOST_IO_FILE_INPUTS_H
#define QTRI_HOST_IO_FILE_INPUTS_H

#include <stdbool.h>

/* From now on file_read() remembers files, and file_output_open() refuses them. */
void file_inputs_guard(void);

/* Remembers the file behind an open descriptor, unless it is a pipe or a device. */
void file_inputs_add(int descriptor);

/* What the program makes itself is no input, though it reads it again: it may make it anew. */
void file_inputs_except(int descriptor);

/* Whether this is a file that was read, by whatever name. */
bool file_inputs_has(const char *path);

#endif
