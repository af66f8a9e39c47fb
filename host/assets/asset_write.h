/* SPDX-License-Identifier: MIT */
/*
 * Meshes as C source: the pieces that headers of meshes and of models are made of.
 */
#ifndef QTRI_HOST_ASSETS_ASSET_WRITE_H
#define QTRI_HOST_ASSETS_ASSET_WRITE_H

#include "asset.h"

/* Where a mesh goes: arrays of one of `count` meshes are named NAME_PART_what, of one NAME_what. */
struct asset_writer {
    FILE *out;
    const char *name;
    size_t part, count;
};

/* The arrays of a mesh, as static constants. */
void asset_write_arrays(const struct asset_writer *writer, const qtri_mesh *mesh);

/* The positions of a part's targets, as static constants: NAME_PART_target_0, and so on. The name
   of one of them. */
void asset_write_targets(const struct asset_writer *writer, const struct asset_part *part);
void asset_target_name(const struct asset_writer *writer, size_t target, char out[160]);

/* The members of a qtri_mesh by their places, as C++11 has no names in initialisers. */
void asset_write_mesh(const struct asset_writer *writer, const qtri_mesh *mesh);

/* Text from a file as a comment may hold it. */
void asset_write_comment(FILE *out, const char *text);

#endif
