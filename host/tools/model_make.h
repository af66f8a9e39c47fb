/* SPDX-License-Identifier: MIT */
#ifndef QTRI_HOST_TOOLS_MODEL_MAKE_H
#define QTRI_HOST_TOOLS_MODEL_MAKE_H

#include "../assets/asset.h"
#include "mesh_options.h"

/* Reads the model and makes all that the header of `qtri model` holds; its materials are merged.
   What is left out is said on standard error. False with *error set. */
bool model_make(struct mesh_options *options, struct asset *asset, struct text_error *error);

#endif
