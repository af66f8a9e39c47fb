/* SPDX-License-Identifier: MIT */
/*
 * Headers that C99 and C++11 compile, with constant data: what is around it.
 */
#ifndef QTRI_HOST_ASSETS_ASSET_HEADER_H
#define QTRI_HOST_ASSETS_ASSET_HEADER_H

#include <stdbool.h>
#include <stdio.h>

#include "../io/text_error.h"

/* What the data is called: in C, and in macros; and its linkage, "static " or "". */
struct asset_names {
    const char *name, *linkage;
    char capitals[100];
};

/* Writes a piece of a header about a thing, which is what the kind of the header says. */
typedef void asset_piece(FILE *out, const void *thing, const struct asset_names *names);

/* A kind of headers. */
struct asset_header {
    const char *guard;    /* NAME_guard_H */
    asset_piece *summary; /* the comment at the top */
    asset_piece *sizes;   /* macros; NULL: none */
    asset_piece *data, *declarations;
};

extern const struct asset_header asset_header_mesh;    /* of a struct asset: its meshes */
extern const struct asset_header asset_header_model;   /* of a struct asset: see asset_model.h */
extern const struct asset_header asset_header_texture; /* of a struct texture */

/*
 * All to `header`, or, where `source` is not NULL, declarations to `header` and the data to
 * `source`, which includes `header_name`.
 */
void asset_header_write(const struct asset_header *kind, const void *thing, const char *name,
                        const char *header_name, FILE *header, FILE *source);

/* To the file NAME.h, "-" for standard output, and with `split` NAME.c: both appear or, where one
   of them cannot be written, neither. False with *error set. */
bool asset_header_save(const struct asset_header *kind, const void *thing, const char *name,
                       const char *path, bool split, struct text_error *error);

#endif
