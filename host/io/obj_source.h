/* SPDX-License-Identifier: MIT */
/*
 * Inside the OBJ reader: what the parser (obj.c) collects, and what makes a mesh of it
 * (obj_build.c).
 */
#ifndef QTRI_HOST_IO_OBJ_SOURCE_H
#define QTRI_HOST_IO_OBJ_SOURCE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "lines.h"
#include "obj.h"
#include "unique.h"

#define OBJ_ABSENT    UINT32_MAX        /* a corner without this attribute */
#define OBJ_MAX_COUNT ((size_t)1 << 31) /* of anything in a file: indices fit 32 bits */

enum obj_attribute { OBJ_POSITION, OBJ_UV, OBJ_NORMAL, OBJ_ATTRIBUTES };

/* Of a `full` source: what a microcontroller's mesh could be made of, and a scan no longer is. */
#define OBJ_MAX_TRIANGLES ((size_t)1 << 21)

/* A corner of a face: 0-based index of each attribute, or OBJ_ABSENT; its place in `names`. */
struct obj_corner {
    uint32_t index[OBJ_ATTRIBUTES];
    uint32_t material;
};

/* The numbers of all v, vt or vn statements; uv uses [0] and [1], v already turned over. Those that
   were read as Q16.16 are multiples of 2^-16, exactly. */
struct obj_list {
    double (*items)[3];
    size_t count, capacity;
};

/* A name that the file mentions: of a material, or of a file of materials. */
struct obj_name {
    char *text;
    int line;
};

/* Statements that make no triangle. */
struct obj_count {
    size_t faces, edges, lines, points, curved;
};

/* A face of more than three corners: its triangles, one behind the other. */
struct obj_polygon {
    uint32_t first, count;
};

#define OBJ_MAX_NAMES 4096 /* of either kind; they are found one by one */

struct obj_names {
    struct obj_name *items;
    size_t count, capacity;
};

struct obj_source {
    struct obj_list lists[OBJ_ATTRIBUTES];
    struct unique vertices; /* the distinct corners, in the order they appear */
    uint32_t (*triangles)[3];
    size_t triangle_count, triangle_capacity;
    struct obj_polygon *polygons;
    size_t polygon_count, polygon_capacity;
    struct obj_list colors; /* one for each position, 0..1; white where the file gives none */
    bool has_colors;
    struct obj_count count;
    bool wide_positions; /* positions alone are in double precision: they will be scaled */
    /* Where `full`: all that follows, and numbers in double precision. */
    bool full;
    struct obj_names materials; /* the first, "", is that of faces before any usemtl */
    struct obj_names libraries; /* mtllib */
};

/*
 * Parses the text into *source, which is zero but for `full` and `wide_positions`. False with
 * *error set. Either way the source is to be freed.
 */
bool obj_parse_source(const char *name, const char *text, size_t length, struct obj_source *source,
                      struct text_error *error);

void obj_source_free(struct obj_source *source);

/* The corner of a vertex. */
static inline const struct obj_corner *obj_vertex(const struct obj_source *source, size_t vertex)
{
    return (const struct obj_corner *)source->vertices.items + vertex;
}

/* Cuts polygons, which are fans, into triangles that cover them. */
void obj_triangulate(struct obj_source *source);

/* Scales the positions that faces name and rounds them to Q16.16. False where one does not fit. */
bool obj_scale_positions(struct obj_source *source, const struct obj_scale *scale);

/* Makes the mesh (all but `path`). Every index of every corner lies inside its list. Takes the
   triangles over from the source. */
void obj_build(struct obj_source *source, struct obj_mesh *mesh);

#endif
