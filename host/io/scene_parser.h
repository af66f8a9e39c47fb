/* SPDX-License-Identifier: MIT */
/*
 * Inside the scene reader. scene_read.c reads the text and finds the statement in its table; the
 * statements themselves are in
 *
 *   scene_ops.c      matrices and geometry, kept in order
 *   scene_model.c    shapes, morphs, and what a model is culled by
 *   scene_pose.c     keys, joints, cameras, billboards, windows
 *   scene_state.c    global state
 *   scene_assets.c   the texture; mesh files
 *   scene_alpha.c    alpha of the texture, and its test
 *   scene_light.c    lights, the material
 *   scene_blend.c    blends, fog, channels, shifts of depth
 *   scene_paint.c    flat shapes, text, pictures
 *   scene_stroke.c   lines and points
 */
#ifndef QTRI_HOST_IO_SCENE_PARSER_H
#define QTRI_HOST_IO_SCENE_PARSER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "file.h"
#include "file_identity.h"
#include "lines.h"
#include "scene.h"

#define SCENE_ONE           65536 /* 1.0 */
#define SCENE_MAX_ARGUMENTS 36    /* tritn */
#define SCENE_MAX_TEXTURE   1024  /* texels along a side */

#define SCENE_ANY (-1)

struct scene_statement;

/*
 * The last `texture` statement. Its texels are made when the scene has been read, so that a file
 * with many such statements costs no more than its length.
 */
struct scene_texture_request {
    enum { SCENE_TEXTURE_OFF, SCENE_TEXTURE_CHECKERS, SCENE_TEXTURE_FILE } kind;
    int line;
    const struct scene_statement *statement;
    int width, height, cells;
    uint8_t rgb[2][3];
    char *path;
};

/* The last `texalpha` statement, kept for the same reason. */
struct scene_alpha_request {
    enum { SCENE_ALPHA_OFF, SCENE_ALPHA_CHECKERS, SCENE_ALPHA_FILE } kind;
    int line;
    uint8_t alpha[2];
    char *path;
};

/* What shapes, text and pictures are painted with from here on, and the files read so far. */
struct scene_brush {
    struct scene_paint paint;
    bool is_set, has_font; /* `ink`, `font` were there */
    struct scene_paint_file {
        char *path;
        bool is_font;
        uint16_t index;
    } * files;
    size_t file_count, file_capacity, font_capacity, image_capacity, text_capacity;
};

/* What a mesh was made of. */
struct scene_mesh_file {
    struct file_identity identity;
    struct obj_scale scale;
};

struct scene_parser {
    const char *name;
    struct text_error *error;
    struct scene *scene;
    char *root;         /* files lie below this folder, which has no links; NULL: anywhere */
    const char *output; /* a path that must not be one of them; NULL: none */
    int line;
    const struct scene_statement *statement; /* the one being parsed */
    struct token arguments[SCENE_MAX_ARGUMENTS];
    int argument_count;
    bool any_statement;
    size_t op_capacity;
    int mode;     /* 0 projection, 1 modelview */
    int depth[2]; /* matrices pushed on each stack */
    size_t mesh_capacity, model_capacity;
    struct scene_mesh_file *mesh_files; /* beside scene->meshes */
    size_t mesh_file_capacity;
    struct scene_stroke line_state, point_state; /* of the next line and point */
    struct scene_op *polyline; /* the last statement was about this one: vertices join it */
    size_t stroke_vertex_capacity;
    size_t key_capacity;
    size_t track_first; /* the first key of the track that `keys` looks at */
    bool track_is_used; /* the next `key` begins another one */
    bool has_camera;    /* `camera` was there */
    int joint_count;
    int32_t depth_bias, depth_slope; /* of the geometry that follows */
    bool by_vertex;
    int32_t vertex_alpha[3];
    struct scene_texture_request texture;
    struct scene_alpha_request texalpha;
    int alphatest_line, texkey_line; /* of the last of each that is not off, or 0 */
    int texformat_line; /* of the last `texformat`, in case its palette does not suffice */
    const struct scene_statement *texformat_statement;
    struct scene_brush brush;
};

/* Takes the statement's arguments, whose number is right; false with the error set. */
typedef bool scene_handler(struct scene_parser *parser);

struct scene_statement {
    const char *name;
    int counts[2]; /* permitted numbers of arguments; behind the first, SCENE_ANY: as the handler
                      says; -n: up to n */
    scene_handler *handler;
    enum scene_op_kind kind; /* for scene_statement_numbers */
    const char *usage;       /* for messages */
};

/* ---- Helpers for handlers (scene_parser.c) ---- */

/* Sets the error, "FILE:LINE: STATEMENT: sentence", and returns false. */
bool scene_fail(struct scene_parser *parser, const char *sentence);

/* The message for a number of arguments that is none of the statement's; false. */
bool scene_fail_count(struct scene_parser *parser);

/* "FILE:LINE: STATEMENT: 'ARGUMENT' problem". */
bool scene_fail_argument(struct scene_parser *parser, int argument, const char *problem);

/* Reads `count` numbers beginning with argument `first`. */
bool scene_numbers(struct scene_parser *parser, int first, int count, int32_t *numbers);

/* Reads `count` numbers in 0..1: colours, depths, intensities. */
bool scene_fractions(struct scene_parser *parser, int first, int count, int32_t *numbers);

bool scene_integer(struct scene_parser *parser, int argument, int minimum, int maximum, int *value);

/* The rank of an argument in words[0..count-1]. */
bool scene_choice(struct scene_parser *parser, int argument, const char *const *words, int count,
                  int *choice);

/* Appends an operation of the given kind; NULL with the error set when memory runs out. */
struct scene_op *scene_add_op(struct scene_parser *parser, enum scene_op_kind kind);

/* ---- Handlers ---- */

/* scene_ops.c */
scene_handler scene_statement_mode, scene_statement_numbers, scene_statement_push,
    scene_statement_pop, scene_statement_triangle, scene_statement_mesh;

/* scene_model.c */
scene_handler scene_statement_shape, scene_statement_morph, scene_statement_frames,
    scene_statement_targets, scene_statement_frustumcull;

/* scene_pose.c */
scene_handler scene_statement_key, scene_statement_keys, scene_statement_joint,
    scene_statement_atjoint, scene_statement_camera, scene_statement_billboard,
    scene_statement_window;

/* scene_state.c; texture: scene_assets.c */
scene_handler scene_statement_viewport, scene_statement_clear, scene_statement_cleardepth,
    scene_statement_depth, scene_statement_depthformat, scene_statement_depthmask,
    scene_statement_depthrange, scene_statement_cull, scene_statement_shade,
    scene_statement_texmode, scene_statement_texwrap, scene_statement_texfilter,
    scene_statement_texformat, scene_statement_texkey, scene_statement_interpolate,
    scene_statement_polygon, scene_statement_texture, scene_statement_antialias;

/* scene_light.c */
scene_handler scene_statement_light, scene_statement_ambient, scene_statement_material,
    scene_statement_twosided, scene_statement_texgen;

/* scene_paint.c */
scene_handler scene_statement_ink, scene_statement_edges, scene_statement_font,
    scene_statement_imagekey, scene_statement_rect, scene_statement_roundrect,
    scene_statement_circle, scene_statement_arc, scene_statement_area, scene_statement_stroke,
    scene_statement_text, scene_statement_image;

void scene_brush_free(struct scene_brush *brush);

/* scene_blend.c */
scene_handler scene_statement_blend, scene_statement_fog, scene_statement_fogdensity,
    scene_statement_colormask, scene_statement_depthbias, scene_statement_depthslope,
    scene_statement_vertexalpha;

/* scene_stroke.c */
scene_handler scene_statement_linewidth, scene_statement_linesmooth, scene_statement_linecap,
    scene_statement_linealpha, scene_statement_line, scene_statement_polyline,
    scene_statement_vertex, scene_statement_pointsize, scene_statement_point;

/* Lines are a pixel wide, smooth, round, opaque; points are 4 pixels. */
void scene_stroke_defaults(struct scene_parser *parser);

/* ---- Shared by the files of statements (scene_ops.c) ---- */

bool scene_is_zero(const int32_t v[3]);

/* Numbers `count` triangles; *id is the first one's. */
bool scene_take_ids(struct scene_parser *parser, size_t count, uint32_t *id);

/* Position and colour, and texture coordinates where `textured`, from argument `first` on. */
bool scene_read_vertex(struct scene_parser *parser, int first, bool textured, bool normal,
                       struct scene_vertex *vertex);

/* ---- The alpha of textures (scene_alpha.c) ---- */

scene_handler scene_statement_texalpha, scene_statement_alphatest;

/* Fills scene->texture.alpha, after its colours, and checks what goes with what. */
bool scene_make_alpha(struct scene_parser *parser);

/* ---- Files that a scene names (scene_path.c) ---- */

/* The path that an argument names, seen from the scene file's folder; free() it. NULL with the
   error. */
char *scene_path(struct scene_parser *parser, int argument);

/* Whether it is an ordinary file; `identity` may be NULL. False with the error. */
bool scene_inspect(struct scene_parser *parser, const char *path, struct file_identity *identity);

/* ---- Assets (scene_assets.c) ---- */

/* The index in scene->meshes of the file that an argument names, in this scale (NULL: as it is);
   reads a file the first time, and anew in another scale. */
bool scene_find_mesh(struct scene_parser *parser, int argument, const struct obj_scale *scale,
                     size_t *mesh);

/* Fills scene->texture with what the last `texture` statement asks for; checks the last
 * `texformat`. */
bool scene_make_texture(struct scene_parser *parser);

#endif
