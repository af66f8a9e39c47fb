/* SPDX-License-Identifier: MIT */
/*
 * What `qtri mesh` and `qtri model` have in common: a model in the shape that was asked for, the
 * preview, and what is said of what was made.
 */
#ifndef QTRI_HOST_TOOLS_MESH_MAKE_H
#define QTRI_HOST_TOOLS_MESH_MAKE_H

#include "../assets/asset.h"
#include "mesh_options.h"

/* Reads or generates a model, and shapes it. What it leaves out of the file it says on standard
   error. False with *error set. */
bool mesh_read(struct mesh_options *options, enum model_content content, struct model *model,
               struct text_error *error);

/* Whether it fits --flash and --ram; false with *error set. */
bool mesh_check_budget(const struct mesh_options *options, const struct asset *asset,
                       struct text_error *error);

bool mesh_write_preview(const struct mesh_options *options, const struct asset *asset,
                        struct text_error *error);
void mesh_report(const struct mesh_options *options, const struct asset *asset, FILE *out);

/* What was made goes to standard output: what is said goes elsewhere. */
bool mesh_is_piped(const struct mesh_options *options);

#endif
