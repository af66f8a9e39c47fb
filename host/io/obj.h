/* SPDX-License-Identifier: MIT */
/*
 * Wavefront OBJ meshes, triangulated and indexed by one index per corner.
 */
#ifndef QTRI_HOST_IO_OBJ_H
#define QTRI_HOST_IO_OBJ_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "text_error.h"

/* Numbers are Q16.16. A vertex is one distinct (v, vt, vn) triple of the file. */
struct obj_mesh {
    char *path;
    size_t vertex_count;
    size_t triangle_count;
    int32_t (*positions)[3];
    int32_t (*normals)[3]; /* unit length. From the file, or where the file gives none or zero,
                              area-weighted over the faces at equal positions; (0,0,1)
                              where those have no area or cancel */
    int32_t (*uvs)[2];     /* NULL when no corner has any; 0 0 for corners without.
                              v = 0 is the first row of a texture: 1 - v of the file */
    uint8_t (*colors)[3];  /* sRGB; NULL when the file gives none; white for vertices without */
    uint32_t (*triangles)[3];
};

/*
 * Positions are scaled about the origin before they become Q16.16, so that models of any unit keep
 * their shape: in Q16.16 a model of radius .01 has only 1,310 places along an axis, and triangles
 * that share them are gone.
 */
struct obj_scale {
    double factor; /* 0: 1 */
    double fit; /* above 0: the largest side of the box of what faces name becomes this, instead */
};

#define OBJ_SCALE_MIN 1e-9 /* of a factor that a user gives */
#define OBJ_SCALE_MAX 1e9
#define OBJ_FIT_MIN   1e-3
#define OBJ_FIT_MAX   65534.0

/*
 * Parses `length` bytes of OBJ text: v, vt, vn and f with any mix of v, v/vt, v//vn, v/vt/vn,
 * negative indices, polygons (polygon.h), comments, line continuations; o g s usemtl mtllib and
 * other known statements, and faces of one or two corners, are passed over. Faces may name elements
 * that follow them. A vertex that no face names is left out, and a file without faces is an error.
 * Messages give the line on which a continued statement begins. Returns true with *mesh filled
 * (free with obj_free), or false with *error set and nothing to free.
 */
bool obj_parse(const char *name, const char *text, size_t length, struct obj_mesh *mesh,
               struct text_error *error);

/* The same with positions scaled; `scale` NULL: as they are. */
bool obj_parse_scaled(const char *name, const char *text, size_t length,
                      const struct obj_scale *scale, struct obj_mesh *mesh,
                      struct text_error *error);

bool obj_read_scaled(const char *path, const struct obj_scale *scale, struct obj_mesh *mesh,
                     struct text_error *error);

bool obj_read(const char *path, struct obj_mesh *mesh, struct text_error *error);

void obj_free(struct obj_mesh *mesh);

#endif
