/* SPDX-License-Identifier: MIT */
/*
 * What C99 has not and systems do each in their way: POSIX's in system_posix.c and
 * system_memory.c, Windows' in system_windows.c. Beside it two files have a twin for Windows,
 * file_identity.c and ../assets/apart.c. Functions that return an int return 0 or an errno, unless
 * they say otherwise.
 */
#ifndef QTRI_HOST_IO_SYSTEM_H
#define QTRI_HOST_IO_SYSTEM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Before all else: files and standard streams hold bytes as they are, and `/` is what separates the
 * folders of arguments. */
void system_begin(int argc, char **argv);

/* A descriptor to read from, without waiting for who writes to a pipe; -1 with errno. */
int system_open_input(const char *path);

/* Waits until there is something to read, or the end; ETIMEDOUT after so many seconds. */
int system_await_input(int descriptor, int seconds);

/* A descriptor to write to a file that did not exist; -1 with errno. It can be removed while it is
 * open. */
int system_create(const char *path);

/* Gives a file another's name, in whose place it is then. */
int system_replace(const char *from, const char *to);

/* Absolute, without links, `/` between folders; free() it. NULL where there is no such file. */
char *system_real_path(const char *path);

int system_make_folder(const char *path);

/* The path of this program without links; false where nobody tells. */
bool system_program(char *path, size_t size);

/* Windows alone: an empty file without a name, gone when it is closed; NULL where there is no room.
 */
FILE *system_temporary(void);

/* What `write` writes for a name, with a zero behind it; free() it. NULL where there is no room. */
char *system_collect(void (*write)(FILE *out, const char *name), const char *name, size_t *length);

/* Calls `end` with the signal's number in a signal that ends the program, unless it is ignored. */
void system_on_end(void (*end)(int number));

/* Calls `stop` for Ctrl-C. */
void system_on_interrupt(void (*stop)(int number));

/* Calls `ring` once, after so many seconds, whatever the program is at. */
void system_alarm(unsigned seconds, void (*ring)(int number));

#endif
