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
    char up;           /* 'y' or 'z' */
    double fit, scale; /* 0: as it is */
    enum model_normals normals;
    double smooth_degrees;
    long simplify; /* 0: all triangles */
    int panel_width, panel_height, rows;
    size_t most_flash, most_ram; /* 0: any */

    /* Of `qtri model` alone. */
    bool is_model, wide, in_place;
    const char *skin;            /* the picture of materials that have none; NULL: none */
    struct texture_options most; /* width and height: the most of a texture */
};

/* False after a message on standard error: wrong usage. `is_model`: of `qtri model`. */
bool mesh_options_parse(int argc, char **argv, bool is_model, struct mesh_options *options);

void mesh_options_help(bool is_model, FILE *out);

#endif
