/* SPDX-License-Identifier: MIT */
/*
 * What the library uses of <string.h>, for compilers that come without a C library (Debian's for
 * RISC-V): -idirafter this folder. The functions are in ../memory.c.
 */
#ifndef QTRI_BOARD_STRING_H
#define QTRI_BOARD_STRING_H

#include <stddef.h>

void *memcpy(void *restrict to, const void *restrict from, size_t count);
void *memmove(void *to, const void *from, size_t count);
void *memset(void *to, int value, size_t count);

#endif
