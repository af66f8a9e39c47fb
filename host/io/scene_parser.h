/* SPDX-License-Identifier: MIT */
/*
 * Inside the scene reader. A statement is a row of the table in scene_statements.c: its name, what
 * its values are, and the function that takes them. The functions are in
 *
 *   scene_state.c     global state: depth, texels, lights, blends, fog
 *   scene_geometry.c  matrices, meshes, triangles, lines: operations, kept in order
 *   scene_paint.c     flat shapes, text, pictures
 *   scene_texture.c   the texture, its alpha and its levels
 *
 * and scene_read.c reads the text and the files that a scene names.
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

struct scene_statement;

/* Where texels, or their alpha, are from. */
enum scene_source { SCENE_OF_NOTHING, SCENE_OF_CHECKERS, SCENE_OF_FILE };

/*
 * The last `texture` statement. Its texels are made when the scene has been read, so that a file
 * with many such statements costs no more than its length.
 */
struct scene_texture_request {
    enum scene_source kind;
    int line;
    const struct scene_statement *statement;
    int width, height, cells;
    uint8_t rgb[2][3];
    char *path;
};

/* The last `texalpha` statement, kept for the same reason. */
struct scene_alpha_request {
    enum scene_source kind;
    int line;
    uint8_t alpha[2];
    char *path;
};

/* What shapes, text and pictures are painted with from here on, and the files read so far. */
struct scene_brush {
    struct scene_paint paint;
    bool has_font;
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
    struct scene *first; /* the first pass, which has what is the whole picture's */
    struct scene *scene; /* the pass that is being read */
    int pass_count;      /* besides the first */
    size_t texel_count;  /* of passes that have been read */
    char *root;          /* files lie below this folder, which has no links; NULL: anywhere */
    const char *output;  /* a path that must not be one of them; NULL: none */
    double time;         /* $t of expressions */
    int line;
    const char *line_text;                   /* where the line begins */
    const struct scene_statement *statement; /* the one being parsed */
    struct token arguments[SCENE_MAX_ARGUMENTS];
    int argument_count, value_count; /* the statement's values are those left out, too */
    bool any_statement;
    size_t op_capacity;
    int32_t mode; /* 0 projection, 1 modelview */
    int depth[2]; /* matrices pushed on each stack */
    size_t mesh_capacity, model_capacity;
    struct scene_mesh_file *mesh_files; /* beside scene->meshes */
    size_t mesh_file_capacity;
    struct scene_stroke stroke; /* of the next line; of the next point but for: */
    int32_t point_size, point_in_space;
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
    int texformat_line;              /* of the last, in case its palette does not suffice */
    struct scene_brush brush;
};

/*
 * Takes a statement's values: numbers and fractions in Q16.16, whole numbers, of a word its rank
 * among those of the usage text, from 1 where it may be left out, 0 for a token that the handler
 * reads itself. Values that were left out are there, too; argument_count says which. False with the
 * error set.
 */
typedef bool scene_handler(struct scene_parser *parser, const int32_t *value);

struct scene_statement {
    const char *name;
    const char *usage;  /* an argument a word, optional ones in brackets, choices as one|two */
    const char *values; /* a letter a value: see scene_statements.c */
    scene_handler *handler;
    size_t into; /* where a value is stored, or what is added: as the handler says */
};

/* Reads the statement that an argument list begins, whose keyword is not part of it. */
bool scene_parse_statement(struct scene_parser *parser, const struct token *keyword);

/* ---- Errors and arguments (scene_statements.c) ---- */

/* Sets the error, "FILE:LINE: STATEMENT: sentence", and returns false. */
bool scene_fail(struct scene_parser *parser, const char *sentence);

/* The message for a number of arguments that is none of the statement's; false. */
bool scene_fail_count(struct scene_parser *parser);

/* "FILE:LINE: STATEMENT: 'ARGUMENT' problem". */
bool scene_fail_argument(struct scene_parser *parser, int argument, const char *problem);

/* For lists of any length: values of one kind from argument `first` on. */
bool scene_read_values(struct scene_parser *parser, int first, int count, char letter,
                       int32_t *value);

bool scene_integer(struct scene_parser *parser, int argument, int minimum, int maximum,
                   int32_t *value);

/* Whether an argument is this word; otherwise the error that it is unknown. */
bool scene_word(struct scene_parser *parser, int argument, const char *word);

/* ---- Handlers ---- */

/* Store values where `into` says: as they are; as flags, set by all words but the first, or by the
   first alone; as one byte that says whether there is a colour, and the colour's. */
scene_handler scene_store, scene_store_flags, scene_store_on, scene_store_key;

/* scene_state.c */
scene_handler scene_statement_viewport, scene_statement_depth, scene_statement_depthbias,
    scene_statement_shade, scene_statement_texwrap, scene_statement_texformat,
    scene_statement_texkey, scene_statement_alphatest, scene_statement_polygon,
    scene_statement_vertexalpha, scene_statement_fog, scene_statement_one_light,
    scene_statement_light, scene_statement_ambient, scene_statement_material;

/* scene_geometry.c */
scene_handler scene_statement_mode, scene_statement_numbers, scene_statement_push,
    scene_statement_pop, scene_statement_triangle, scene_statement_mesh, scene_statement_shape,
    scene_statement_morph, scene_statement_frames, scene_statement_targets, scene_statement_key,
    scene_statement_keys, scene_statement_joint, scene_statement_atjoint, scene_statement_camera,
    scene_statement_billboard, scene_statement_window, scene_statement_line,
    scene_statement_polyline, scene_statement_vertex, scene_statement_point;

/* scene_texture.c */
scene_handler scene_statement_texture, scene_statement_texalpha;

/* scene_paint.c */
scene_handler scene_statement_font, scene_statement_paint, scene_statement_text,
    scene_statement_image;

/* White. */
void scene_brush_defaults(struct scene_brush *brush);
void scene_brush_free(struct scene_brush *brush);

/* Appends an operation of the given kind. */
struct scene_op *scene_add_op(struct scene_parser *parser, enum scene_op_kind kind);

/* scene_read.c */
scene_handler scene_statement_pass;

/* Fills scene->texture with what the last `texture` and `texalpha` ask for, and checks what goes
   with what. */
bool scene_make_texture(struct scene_parser *parser);

/* ---- Files that a scene names (scene_read.c) ---- */

/* The path that an argument names, seen from the scene file's folder, of an ordinary file that the
   scene may read; free() it. NULL with the error. `identity` may be NULL. */
char *scene_path(struct scene_parser *parser, int argument, struct file_identity *identity);

#endif
