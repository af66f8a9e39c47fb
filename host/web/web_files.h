/* SPDX-License-Identifier: MIT */
/*
 * Files of a page: in memory, by name. web_files.c defines what io/file.h and io/file_identity.h
 * declare.
 */
#ifndef QTRI_HOST_WEB_WEB_FILES_H
#define QTRI_HOST_WEB_WEB_FILES_H

#include <stddef.h>

/* A new file, or one that takes the place of what has this name: the memory for its content, or
   NULL where there is no more. */
char *web_file_create(const char *name, size_t length);

/* The content of a file and its length; NULL: there is none. */
char *web_file_content(const char *name);
size_t web_file_length(const char *name);

void web_files_clear(void);

#endif
