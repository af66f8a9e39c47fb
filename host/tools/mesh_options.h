/* SPDX-License-Identifier: MIT */
/*
 * What `qtri mesh` and `qtri model` were asked for.
 */
#ifndef QTRI_HOST_TOOLS_MESH_OPTIONS_H
#define QTRI_HOST_TOOLS_MESH_OPTIONS_H

#include <stdbool.h>
#include <stdio.h>

#include "../assets/model.h"
#include "../assets/texture.h"
#include "options.h"

struct mesh_options {
    const char *input, *output;
    const char *preview;         /* NULL: none */
    char name[OPTION_NAME_SIZE]; /* of the mesh in C */
    bool is_generated;           /* the input is a name that mesh_generate knows */
    bool is_obj;                 /* the output is OBJ, not C */
    bool is_changed;             /* an option asks for more than the generated text */
    bool split, compact, center, colors, plain, no_faces, keep_order;
    int up;            /* 0: y, 1: z */
    double fit, scale; /* 0: as it is */
    enum model_normals normals;
    double smooth_degrees;
    int simplify; /* 0: all triangles */
    int panel_width, panel_height, rows;
    size_t most_flash, most_ram; /* 0: any */

    /* Of `qtri model` alone. */
    bool is_model, wide, in_place;
    const char *skin;            /* the picture of materials that have none; NULL: none */
    struct texture_options most; /* width and height: the most of a texture */
};

/* What `qtri mesh` and `qtri model` do with a struct mesh_options; false with *error set. */
bool mesh_run(void *options, struct text_error *error);
bool model_run(void *options, struct text_error *error);

#endif
