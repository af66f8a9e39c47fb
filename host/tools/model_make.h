/* SPDX-License-Identifier: MIT */
#ifndef QTRI_HOST_TOOLS_MODEL_MAKE_H
#define QTRI_HOST_TOOLS_MODEL_MAKE_H

#include "../assets/asset.h"
#include "mesh_options.h"

/* All that the header of `qtri model` holds, of a model that mesh_read has read: its materials are
   merged. What is left out is said on standard error. False with *error set. */
bool model_make(const struct mesh_options *options, struct model *model, struct asset *asset,
                struct text_error *error);

#endif
