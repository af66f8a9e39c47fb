/* SPDX-License-Identifier: MIT */
/*
 * Meshes of the demo that have the same triangles: a flag in four places of its wave.
 */
#ifndef QTRI_HOST_TOOLS_DEMO_WAVES_H
#define QTRI_HOST_TOOLS_DEMO_WAVES_H

#include <stdbool.h>

#include "../io/text_error.h"

/* Writes wave-0.obj to wave-3.obj. */
bool demo_write_waves(const char *folder, struct text_error *error);

#endif
