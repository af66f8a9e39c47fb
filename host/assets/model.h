/* SPDX-License-Identifier: MIT */
/*
 * A model as its file has it, whatever the format: what meshes for a microcontroller are made of.
 */
#ifndef QTRI_HOST_ASSETS_MODEL_H
#define QTRI_HOST_ASSETS_MODEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "../io/text_error.h"

/* Limits of a model; a file that is beyond one of them is refused. */
#define MODEL_MAX_TRIANGLES ((size_t)1 << 21)
#define MODEL_MAX_MATERIALS ((size_t)4096)
#define MODEL_MAX_VALUE     1e9 /* of a coordinate, so that areas and their sums stay finite */

struct model_material {
    char name[64];     /* cut where it is longer */
    uint8_t color[3];  /* sRGB */
    char texture[512]; /* path of its picture; "": none */
};

/* Without bytes between members: vertices are compared as bytes. */
struct model_vertex {
    double position[3];
    double normal[3]; /* length 1; 0 0 0: none */
    double uv[2];     /* v = 0 is the first row of a picture */
    uint8_t color[3]; /* sRGB, to be multiplied with the material's */
    uint8_t zero;
    uint16_t material;
    uint16_t zeros;
};

struct model {
    struct model_vertex *vertices;
    uint32_t (*triangles)[3]; /* all three of one material */
    struct model_material *materials;
    size_t vertex_count, triangle_count, material_count; /* 1 or more materials */
    bool has_uvs, has_colors;
};

/* Zeroed memory for so many of each; false when it runs out: then the model is empty. */
bool model_create(struct model *model, size_t vertices, size_t triangles, size_t materials);
void model_free(struct model *model);

/*
 * Reads a model: OBJ with its MTL, and where the library was there when this was built glTF, GLB,
 * STL and PLY; the end of the name decides. "-" is standard input, whose first bytes decide.
 * `with_materials`: colours and textures are looked for, and must be there; without, the model has
 * one white material. Every number is finite, every index in range. False with *error set.
 */
bool model_read(const char *path, bool with_materials, struct model *model,
                struct text_error *error);

/* The end of the name is one that model_read knows, if not can read. */
bool model_is_file_name(const char *path);

/* The parts of model_read. */
bool model_parse_obj(const char *path, const char *text, size_t length, bool with_materials,
                     struct model *model, struct text_error *error);
bool model_read_library(const char *path, const char *text, size_t length, const char *format,
                        bool with_materials, struct model *model, struct text_error *error);

/* Whether these are the bytes of glTF or GLB, as far as one can see. */
bool model_can_hold_pictures(const char *text, size_t length);

/*
 * The bytes of picture `number`, from 0, that is stored inside such a model: PNG or JPEG. free()
 * them. False with *error set. `text` is all of `path`, "-" being standard input.
 */
bool model_picture(const char *path, const char *text, size_t length, unsigned number, char **bytes,
                   size_t *bytes_length, struct text_error *error);
bool model_library_picture(const char *path, const char *text, size_t length, const char *format,
                           unsigned number, char **bytes, size_t *bytes_length,
                           struct text_error *error);

/* Whether a PLY file holds what its header promises, and no more than a model may have. */
bool model_check_ply(const char *path, const char *text, size_t length, struct text_error *error);

/* Materials of an MTL file by name: colour (Kd) and texture (map_Kd) of those that the model has.
   Statements that are not known are passed over, as their number grows. */
bool model_parse_mtl(const char *path, const char *text, size_t length, struct model *model,
                     struct text_error *error);

/* FOLDER OF `beside`/name in `out`, or `name` where it is absolute. False if that does not fit. */
bool model_path_beside(char *out, size_t size, const char *beside, const char *name);

/* Numbers finite and below MODEL_MAX_VALUE, normals of length 1 or none, indices in range. */
bool model_check(const char *path, struct model *model, struct text_error *error);

/* One vertex for all that are equal in everything; no triangle with two equal corners or without
   area; no vertex without a triangle. False when memory runs out. */
bool model_weld(struct model *model);

struct model_box {
    double low[3], high[3];
};
struct model_box model_bounds(const struct model *model);

/* 'y': as it is; 'z': the file's z points up. qtri's cameras have y up. */
void model_turn_up(struct model *model, char up);

/* The middle of the box becomes the origin. */
void model_center(struct model *model);

/* Scales about the origin: by a factor. */
void model_scale(struct model *model, double factor);

/* Scales about the origin: the largest side of the box becomes `size`. */
void model_fit(struct model *model, double size);

enum model_normals {
    MODEL_NORMALS_KEEP,   /* the file's; where it has none, smooth over all faces */
    MODEL_NORMALS_SMOOTH, /* over faces that meet at less than an angle */
    MODEL_NORMALS_FLAT,   /* each face's own */
    MODEL_NORMALS_NONE    /* none: the core lights faces */
};

/* Gives each triangle three vertices of its own with these normals: weld the model afterwards.
   False when memory runs out. */
bool model_make_normals(struct model *model, enum model_normals normals, double degrees);

/* Whether --simplify was built in, and simplifying to about `triangles`, on a welded model. The
   greatest distance from the old surface, relative to the model's size, goes to *distance. False
   when memory runs out. */
bool model_can_simplify(void);
bool model_simplify(struct model *model, size_t triangles, double *distance);

#endif
