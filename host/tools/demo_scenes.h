/* SPDX-License-Identifier: MIT */
/*
 * Scene files that the demo writes: around generated meshes and around the user's models.
 */
#ifndef QTRI_HOST_TOOLS_DEMO_SCENES_H
#define QTRI_HOST_TOOLS_DEMO_SCENES_H

#include <stdbool.h>
#include <stddef.h>

#include "../io/text_error.h"

/* The file name of generated scene `i`; NULL behind the last. */
const char *demo_generated_scene(size_t i);

/* Writes it and the mesh it shows into `folder`. */
bool demo_write_generated_scene(const char *folder, size_t i, struct text_error *error);

/*
 * Writes a scene into `folder` that shows models/file: centred on its bounding box, scaled to fit,
 * lit, textured with NAME_texture.ppm where that exists. `name` receives the scene's file name.
 */
bool demo_write_model_scene(const char *folder, const char *models, const char *file, char *name,
                            size_t name_size, struct text_error *error);

#endif
