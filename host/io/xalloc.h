/* SPDX-License-Identifier: MIT */
/*
 * Memory that is there: when it runs out, the program ends with a message and status 1. What is as
 * large as a user may ask for, a picture or a file, is not taken from here, nor what a library
 * reads of a foreign file (../assets/apart.h): they are missing by name.
 */
#ifndef QTRI_HOST_IO_XALLOC_H
#define QTRI_HOST_IO_XALLOC_H

#include <stddef.h>

/* Items of zeros; free() them. */
void *xcalloc(size_t count, size_t size);

/* The items with room for so many, or as few; what is new holds anything. */
void *xrealloc(void *items, size_t count, size_t size);

/* A copy of the text; free() it. */
char *xstrdup(const char *text);

/* Removes outputs that are not finished and ends the program (file.c). */
void xalloc_die(void);

#endif
