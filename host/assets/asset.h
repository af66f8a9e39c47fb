/* SPDX-License-Identifier: MIT */
/*
 * Meshes for a microcontroller: constant data as qtri/mesh.h describes it, made of a model.
 */
#ifndef QTRI_HOST_ASSETS_ASSET_H
#define QTRI_HOST_ASSETS_ASSET_H

#include <qtri.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "../io/picture.h"
#include "../io/text_error.h"
#include "model.h"
#include "texture.h"

struct asset_options {
    bool compact; /* 16-bit positions and uvs, 8-bit normals and indices, where they fit */
    bool colors;  /* the materials' colours and the vertices' become vertex colours of one mesh */
    bool normals; /* normals are wanted */
    /* Gives a mesh planes of its faces where they pay: mesh_faces_make, or NULL for none. */
    bool (*make_faces)(qtri_mesh *mesh, qtri_face8 *planes);
    /* The model's materials are merged: one mesh each. Where its vertices have one colour, that is
       the material's, else the mesh has colours; without a picture it has no texture coordinates.
     */
    bool merged;
    bool keep_order; /* triangles follow each other as in the model */
};

/* A mesh whose arrays are its own. */
struct asset_part {
    qtri_mesh mesh;
    struct model_material material; /* what draws it; white where vertices have colours */
    int texture;                    /* of the asset's; -1: none */
    qtri_position16 *targets;       /* target_count times vertex_count positions */
    size_t target_count;
    size_t first_weight; /* the asset's weight of its first target */
};

/* Of all parts together. */
struct asset_error {
    double position;       /* the greatest distance of a vertex from where the model has it */
    double position_share; /* of the largest side of the model's box */
    double normal_degrees; /* the greatest angle */
    double uv;             /* the greatest difference of a coordinate */
};

struct asset {
    struct asset_part *parts; /* one a material that triangles have, or one */
    size_t count;
    struct asset_error error;
    size_t flat_triangles; /* of the model's, that have no area as they are stored: left out */

    /* Of `qtri model` alone: see asset_model.h. */
    struct texture *textures;
    size_t texture_count;
    size_t blended_count; /* pictures whose partial opacity is left out */
    qtri_key *keys;       /* of all nodes and tracks, one after the other; NULL: nothing moves */
    size_t *first_keys;   /* of each node and track; one more at the end */
    int16_t *parents;     /* of each node; node 0 is the model as a whole and has no keys */
    size_t node_count;    /* with node 0; 0: nothing moves */
    size_t track_count;   /* of weights, three each: positions of keys */
    q16 seconds;          /* until the last key */
    qtri_vec3 center;     /* the middle of its box at time 0 */
    q16 radius;           /* no vertex is farther from there, at any key */
};

/*
 * Makes meshes of a welded model. Vertices that are equal in what the microcontroller will see are
 * one, triangles that have no area there are left out, triangles follow each other so that vertices
 * are used again soon unless `keep_order`, vertices in the order of their first use. False with
 * *error set, which begins with `path`: what does not fit a qtri_mesh.
 */
bool asset_make(const char *path, const struct model *model, const struct asset_options *options,
                struct asset *asset, struct text_error *error);
void asset_free(struct asset *asset);

/* Reorders triangles (indices of `vertices` vertices). Without the library they stay as they are.
 */
void asset_order_triangles(uint32_t (*triangles)[3], size_t count, size_t vertices);

uint32_t asset_vertex_count(const struct asset *asset);
uint32_t asset_triangle_count(const struct asset *asset);

/* Bytes of constant data on a machine with 32-bit pointers. */
size_t asset_flash_bytes(const struct asset *asset);

/* RAM of a program like the README's: RGB565 bands with depth, a panel's line buffer, a prepared
   mesh. */
struct asset_memory {
    size_t bands, line, vertices, lists;
};
struct asset_memory asset_ram(const struct asset *asset, int32_t width, int32_t height,
                              int32_t rows);

/* Wavefront OBJ, of what the meshes hold after quantisation: `is_exact` with all digits of numbers,
   but of compact ones, which readers round to Q16.16. */
void asset_write_obj(const struct asset *asset, bool is_exact, FILE *out);

/* Draws the meshes with the core, lit, from a little above: all of them fit. False when memory runs
   out. *drawn: pixels that show something. */
bool asset_preview(const struct asset *asset, int width, int height, struct picture *picture,
                   size_t *drawn);

/* A name for C made of a file's: "my-part 2.glb" gives "my_part_2". */
void asset_identifier(const char *path, char *out, size_t size);

#endif
