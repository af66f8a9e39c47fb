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
#define MODEL_MAX_UV        32767.0

struct model_material {
    char name[64];         /* cut where it is longer */
    uint8_t color[3];      /* sRGB */
    uint8_t opacity;       /* 255: all of what is behind it is hidden */
    char texture[512];     /* path of its picture; "*0", "*1": inside the file; "": none */
    bool clamp_u, clamp_v; /* the picture does not repeat */
    bool has_holes;        /* where its picture is less than half opaque, nothing is drawn */
    bool is_blended;       /* what its picture has of alpha was meant to be blended */
    bool two_sided;
    uint16_t node, morph; /* of its vertices, once model_merge_materials has set them */
};

/* Without bytes between members: vertices are compared as bytes. */
struct model_vertex {
    double position[3];
    double normal[3]; /* length 1; 0 0 0: none */
    double uv[2];     /* v = 0 is the first row of a picture */
    uint8_t color[3]; /* sRGB, to be multiplied with the material's */
    uint8_t zero;
    uint16_t material;
    uint16_t node;  /* which of the model's nodes moves it */
    uint16_t morph; /* which of its morphs shapes it; 0: none */
    uint16_t zero_too;
    uint32_t shift; /* the first of its morph's shifts that are its */
};

/* A picture that is stored inside the model's file, as PNG or JPEG. */
struct model_picture {
    char *bytes;
    size_t length;
};

/* A pose at a time in seconds: scale, then rotation by a unit quaternion w x y z, then position. */
struct model_key {
    double time, position[3], orientation[4], scale[3];
};

/* What moves by itself. Node 0 is the model as a whole and has no keys; `parent` is before it. */
struct model_node {
    uint16_t parent;
    size_t first_key, key_count; /* 1: at rest */
};

/* Shapes that are added to vertices, each times its weight. Tracks hold the weights: those of three
   targets are the position of a key. */
enum { MODEL_TRACK_WEIGHTS = 3 };
struct model_morph {
    uint32_t target_count;
    size_t first_track;
};

struct model {
    struct model_vertex *vertices;
    uint32_t (*triangles)[3]; /* all three of one material and one node */
    struct model_material *materials;
    size_t vertex_count, triangle_count, material_count; /* 1 or more materials */
    struct model_picture *pictures;
    struct model_node *nodes;   /* besides node 0: nodes[0] is node 1 */
    struct model_key *keys;     /* of nodes and of tracks */
    struct model_morph *morphs; /* morphs[0] is morph 1 */
    struct model_node *tracks;
    double (*shifts)[3]; /* of each vertex with a morph, one a target */
    size_t picture_count, node_count, key_count, morph_count, track_count, shift_count;
    size_t file_triangles, file_vertices; /* that the file has, where that is known */
    bool has_uvs, has_colors;
    char left_out[1000]; /* what the file has and the model has not: a list in words, or "" */
};

/* Appends ", 3 skins" to what is left out, or nothing where there are none. */
void model_leave_out(struct model *model, size_t count, const char *one, const char *many);

/* Appends words to what is left out; "" is nothing. */
void model_leave_out_words(struct model *model, const char *words);

/* Zeroed memory for so many of each; false when it runs out: then the model is empty. */
bool model_create(struct model *model, size_t vertices, size_t triangles, size_t materials);
void model_free(struct model *model);

/* How much of a file is wanted. */
enum model_content {
    MODEL_SHAPE,     /* one white material, at rest */
    MODEL_MATERIALS, /* colours and textures */
    MODEL_ALL        /* the pictures inside and the first animation as well */
};

/* The weights of all targets at a time, MODEL_TRACK_WEIGHTS a track; where a vertex is with them,
   and between what bounds with any from 0 to 1, in the space of its node. */
void model_weights(const struct model *model, double time, double *weights);
void model_shape_at(const struct model *model, const double *weights,
                    const struct model_vertex *vertex, double at[3]);
void model_shape_bounds(const struct model *model, const struct model_vertex *vertex, double low[3],
                        double high[3]);

/* All vertices stay where they are without targets. */
void model_drop_morphs(struct model *model);

/*
 * One material for all that look alike and move together: colours of materials become those of
 * vertices, and of each material is what the picture, its holes and sides, the opacity and the node
 * say. Those that are seen through come last. False when memory runs out, or where materials times
 * nodes are more than 65535.
 */
bool model_merge_materials(struct model *model);

/* Where nodes are at a time, in the space of the model: 3 rows of a matrix each. `world` has
   node_count + 1 elements. */
void model_pose(const struct model *model, double time, double (*world)[3][4]);

/*
 * Reads a model: OBJ with its MTL, and where the library was there when this was built glTF, GLB,
 * STL and PLY; the end of the name decides. "-" is standard input, whose first bytes decide.
 * Every number is finite, every index in range. False with *error set.
 */
bool model_read(const char *path, enum model_content content, struct model *model,
                struct text_error *error);

/* The end of the name is one that model_read knows, if not can read. */
bool model_is_file_name(const char *path);

/* The parts of model_read. */
bool model_parse_obj(const char *path, const char *text, size_t length, bool with_materials,
                     struct model *model, struct text_error *error);
bool model_read_library(const char *path, const char *text, size_t length, const char *format,
                        enum model_content content, struct model *model, struct text_error *error);

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

/* Whether a PLY file holds what its header promises, and no more than a model may have. What the
   library passes over is left out of *model. */
bool model_check_ply(const char *path, const char *text, size_t length, struct model *model,
                     struct text_error *error);

/* Whether a glTF or GLB file is complete, and needs nothing that cannot be read. What the library
   passes over is left out of *model. */
bool model_check_gltf(const char *path, const char *text, size_t length, struct model *model,
                      struct text_error *error);

/* How many triangles the meshes of a glTF or GLB file say that they have; 0 where that is not said.
 */
size_t model_gltf_triangles(const char *text, size_t length);

/* Materials of an MTL file by name: colour (Kd), opacity (d) and texture (map_Kd) of those that the
   model has. Statements that are not known are passed over, as their number grows. */
bool model_parse_mtl(const char *path, const char *text, size_t length, struct model *model,
                     struct text_error *error);

/* Sets the material's picture: what is at `name` or, where that is the name on another computer,
   beside the file `beside`. One that is not there is left out. */
void model_picture_beside(struct model *model, struct model_material *material, const char *beside,
                          const char *name);

/* Numbers finite and below MODEL_MAX_VALUE, normals of length 1 or none, indices in range. */
bool model_check(const char *path, struct model *model, struct text_error *error);

/* One vertex for all that are equal in everything; no triangle with two equal corners or without
   area; no vertex without a triangle. */
void model_weld(struct model *model);

struct model_box {
    double low[3], high[3];
};
struct model_box model_bounds(const struct model *model); /* at time 0 */

/* Vertices as they are stored, in all of their shapes, each in the space of its node. */
struct model_box model_vertex_bounds(const struct model *model);

/* Where a vertex is, of a node that model_pose has placed. */
void model_vertex_at(const double world[3][4], const struct model_vertex *vertex, double at[3]);

/* 'y': as it is; 'z': the file's z points up. qtri's cameras have y up. */
void model_turn_up(struct model *model, char up);

/* The middle of the box becomes the origin. */
void model_center(struct model *model);

/* Scales about the origin: by a factor. */
void model_scale(struct model *model, double factor);

/* Scales about the origin: the largest side of the box becomes `size`. */
void model_fit(struct model *model, double size);

#define MODEL_CREASE_DEGREES 45.0 /* faces that meet at more have an edge between them */

enum model_normals {
    MODEL_NORMALS_KEEP,   /* the file's; where it has none, smooth up to MODEL_CREASE_DEGREES */
    MODEL_NORMALS_SMOOTH, /* over faces that meet at less than an angle */
    MODEL_NORMALS_FLAT,   /* each face's own */
    MODEL_NORMALS_NONE    /* none: the core lights faces */
};

/* Gives each triangle three vertices of its own with these normals: weld the model afterwards.
 */
void model_make_normals(struct model *model, enum model_normals normals, double degrees);

/* Whether --simplify was built in, and simplifying to about `triangles`, on a welded model. The
   greatest distance from the old surface, relative to the model's size, goes to *distance. */
bool model_can_simplify(void);
void model_simplify(struct model *model, size_t triangles, double *distance);

#endif
