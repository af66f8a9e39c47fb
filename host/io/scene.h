/* SPDX-License-Identifier: MIT */
/*
 * Scene files: a parsed scene, ready for a renderer to replay.
 *
 * The scene language (README, "Scene files") is OpenGL-like: matrix statements and geometry take
 * effect in file order, every other statement is global and its last occurrence wins. A parsed
 * scene therefore is a list of operations (matrix statements and geometry) beside one record of
 * global state; one of several passes is a list of such scenes. Both renderers, the fixed-point one
 * and the double-precision reference, replay the same list, each with arithmetic of its own;
 * nothing here computes anything.
 *
 * All numbers are Q16.16: read as decimal fractions and rounded to nearest. One that does not fit
 * is an error in the file, so both renderers start from exactly the same inputs. A number may be an
 * expression of the time $t (expression.h); without one it is 0.
 */
#ifndef QTRI_HOST_IO_SCENE_H
#define QTRI_HOST_IO_SCENE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "obj.h"
#include "scene_paint.h"
#include "text_error.h"

#define SCENE_MAX_SIZE    4096 /* largest viewport width or height, pixels */
#define SCENE_STACK_DEPTH 32   /* matrices per stack that push may nest; deeper is an error */

enum scene_op_kind {
    SCENE_MODE_PROJECTION, /* following matrix statements change the projection matrix */
    SCENE_MODE_MODELVIEW,  /* ... the modelview matrix (the state at the start) */
    SCENE_IDENTITY,
    SCENE_LOAD,         /* number[0..15], column-major, replaces the current matrix */
    SCENE_MULT,         /* number[0..15], column-major; current = current * given, as all below */
    SCENE_LOOKAT,       /* eye xyz, center xyz, up xyz */
    SCENE_PERSPECTIVE,  /* fovy degrees, aspect, near, far */
    SCENE_FRUSTUM,      /* left right bottom top near far */
    SCENE_ORTHO,        /* left right bottom top near far */
    SCENE_TRANSLATE,    /* x y z */
    SCENE_ROTATE,       /* degrees, axis x y z (any non-zero length) */
    SCENE_SCALE,        /* x y z */
    SCENE_ROTATE_ABOUT, /* degrees, axis x y z, a point x y z */
    SCENE_ROTATE_TRIANGLE, /* degrees, three points: about their normal through their middle */
    SCENE_QUATERNION,      /* w x y z, of any length but 0 */
    SCENE_ORBIT,           /* center xyz, distance, azimuth and elevation in degrees */
    SCENE_LOOKAT_D3D,      /* these four as the ones above, left-handed: the camera looks along */
    SCENE_PERSPECTIVE_D3D, /* +z, as Direct3D has it */
    SCENE_FRUSTUM_D3D,
    SCENE_ORTHO_D3D,
    SCENE_ORTHONORMALIZE,
    SCENE_CAMERA,    /* the current matrix is the camera of the billboards that follow */
    SCENE_BILLBOARD, /* number[0]: 0, or 1 upright */
    SCENE_KEYS,      /* current = current * the pose of `keys` at a time */
    SCENE_JOINT,     /* number[0]: the parent, an earlier joint, or -1; its pose in it is the
                        current matrix */
    SCENE_AT_JOINT,  /* number[0]: current = current * joint in its first ancestor's frame */
    SCENE_WINDOW,    /* number[0..3], whole pixels: x y width height of what follows; y down
                        from the top, or number[4] != 0: up from the bottom */
    SCENE_PUSH,
    SCENE_POP, /* the parser guarantees that pops match pushes on each stack */
    SCENE_TRIANGLE /* vertex[0..2]; textured: whether it came from `trit` */,
    SCENE_MESH,   /* mesh: index into scene.meshes; color: 0..1 */
    SCENE_MODEL,  /* mesh: index into scene.models; color: 0..1 */
    SCENE_STROKE, /* stroke: a line, a polyline or a point */
    SCENE_PAINT   /* paint: a flat shape, text or a picture; no matrix applies */
};

struct scene_vertex {
    int32_t position[4]; /* object space x y z w */
    int32_t color[3];    /* 0..1 */
    int32_t uv[2];       /* 0 for `tri` */
    int32_t normal[3];   /* of `trin` and `tritn`, any length; 0: that of the triangle */
};

enum scene_cap { SCENE_CAP_ROUND, SCENE_CAP_BUTT, SCENE_CAP_SQUARE };

enum scene_model_kind {
    SCENE_SHAPE,  /* computed */
    SCENE_MORPH,  /* between two meshes */
    SCENE_FRAMES, /* between two of several, one after the other */
    SCENE_TARGETS /* a mesh, and weighted differences of others to it */
};

enum scene_shape {
    SCENE_BOX,      /* size: half the sides */
    SCENE_SPHERE,   /* size[0]: radius; count: slices around, rows from pole to pole */
    SCENE_CYLINDER, /* size: radius, half the height; count[0]: slices; so has the next */
    SCENE_CONE,
    SCENE_TORUS, /* size: radius, that of the tube; count: slices, rings around the tube */
    SCENE_GRID   /* size: half of x and z; count: columns, rows */
};

#define SCENE_MAX_MODEL_MESHES   16
#define SCENE_MAX_MODEL_VERTICES 65536

struct scene_model {
    enum scene_model_kind kind;
    enum scene_shape shape;
    int32_t size[3];
    int count[2];
    /* Indices into scene.meshes, all with the triangles of the first, and their weights. */
    size_t mesh[SCENE_MAX_MODEL_MESHES];
    int32_t weight[SCENE_MAX_MODEL_MESHES]; /* TARGETS: of all but the first */
    int mesh_count;
    int32_t at; /* MORPH: 0..1; FRAMES: 1.5 is half-way from the second to the third */
    uint32_t vertices, triangles;
};

#define SCENE_MAX_JOINTS 64

/* `key`: a pose at a time. */
struct scene_key {
    int32_t time;
    int32_t position[3];
    int32_t degrees, axis[3]; /* the axis is not 0 */
    int32_t scale[3];
};

/* Keys with growing times, and the time that is looked at. */
struct scene_track {
    size_t first, count; /* of scene.keys; count > 0 */
    int32_t time;
};

/* Lines and points, with the state that held when they were given. */
struct scene_stroke {
    size_t first, count; /* of scene.stroke_vertices */
    bool is_point;       /* otherwise a polyline through all vertices */
    int32_t width;       /* pixels; of a point in_space: units of object space */
    int32_t alpha;       /* 0..1 */
    enum scene_cap cap;
    bool smooth, closed, in_space;
};

struct scene_op {
    enum scene_op_kind kind;
    int line;                /* line in the scene file, for messages */
    int32_t depth_bias;      /* of geometry, -1..1 */
    int32_t depth_slope;     /* of triangles: times what depth changes by a pixel, is added */
    bool by_vertex;          /* alpha varies: */
    int32_t vertex_alpha[3]; /* 0..1, of corners, or of a mesh's vertices by turns */
    uint32_t id; /* TRIANGLE: its id; MESH: id of its first triangle, the others follow in order.
                    1-based rank among all triangles of the file; 0 for other operations */
    union {
        int32_t number[16];
        struct scene_track track;
        struct {
            struct scene_vertex vertex[3];
            bool textured;
        } triangle;
        struct {
            size_t mesh;
            int32_t color[3];
        } mesh;
        struct scene_stroke stroke;
        struct scene_paint paint;
    } u;
};

enum scene_compare {
    SCENE_LESS,
    SCENE_LEQUAL,
    SCENE_GREATER,
    SCENE_GEQUAL,
    SCENE_ALWAYS,
    SCENE_EQUAL,
    SCENE_NOTEQUAL,
    SCENE_NEVER
};
/* Whether meshes outside of the frustum are left out: the picture is the same. */
enum scene_frustum_cull { SCENE_FRUSTUM_OFF, SCENE_FRUSTUM_BOX, SCENE_FRUSTUM_BALL };
enum scene_cull { SCENE_CULL_NONE, SCENE_CULL_BACK, SCENE_CULL_FRONT };
enum scene_texture_mode { SCENE_REPLACE, SCENE_MODULATE };

/* What becomes of jagged edges. EDGES and FXAA are the core's: the reference samples centres. */
enum scene_antialias {
    SCENE_ANTIALIAS_OFF,
    SCENE_ANTIALIAS_EDGES,
    SCENE_ANTIALIAS_SSAA,
    SCENE_ANTIALIAS_FXAA,
    SCENE_ANTIALIAS_TEMPORAL,
    SCENE_ANTIALIAS_MSAA
};

/* What the texture's 8-bit colours are stored as. Each renderer converts them: to the nearest level
   of RGB565, to .299 r + .587 g + .114 b, rounded, for GRAY8. A palette holds them as they are, or
   as RGB565 does. */
enum scene_texel_format {
    SCENE_TEXEL_XRGB8888,
    SCENE_TEXEL_RGB565,
    SCENE_TEXEL_PALETTE,
    SCENE_TEXEL_GRAY8,
    SCENE_TEXEL_PALETTE565,
    SCENE_TEXEL_ARGB4444, /* from here on with alpha: see scene_texel_has_alpha */
    SCENE_TEXEL_ARGB1555,
    SCENE_TEXEL_ARGB8888,
    SCENE_TEXEL_ALPHA8
};

static inline bool scene_texel_has_palette(enum scene_texel_format format)
{
    return format == SCENE_TEXEL_PALETTE || format == SCENE_TEXEL_PALETTE565;
}

static inline bool scene_texel_has_alpha(enum scene_texel_format format)
{
    return format >= SCENE_TEXEL_ARGB4444;
}

#define SCENE_MAX_LEVELS 9 /* besides the first, of a width of 1024 */

struct scene_texture { /* width == 0: texturing is off */
    int width, height; /* powers of two, 1..1024 */
    uint8_t *rgb;      /* width * height * 3 bytes, row 0 (v = 0) first, owned by the scene */
    uint8_t *alpha;    /* width * height bytes of a format with alpha, else NULL */
    /* Where it is mipmapped, behind them: each of mipmap_side() of the sides, see mipmap.h. */
    int level_count;
    uint8_t *level[SCENE_MAX_LEVELS];
    uint8_t *level_alpha[SCENE_MAX_LEVELS];
};

/* Of `light directional|point|spot`: eye space, colours 0..16. */
enum scene_lamp_kind { SCENE_DIRECTIONAL, SCENE_POINT, SCENE_SPOT };

#define SCENE_MAX_LAMPS 7 /* and `light` with numbers alone is one more */

struct scene_lamp {
    enum scene_lamp_kind kind;
    int32_t position[3]; /* directional: the direction to it, any length but 0 */
    int32_t color[3];
    int32_t fade[3];      /* point, spot: constant, linear, quadratic */
    int32_t direction[3]; /* spot: to where it shines, any length but 0 */
    int32_t inner, outer; /* degrees, 0..180 */
    int32_t exponent;     /* 1..1024; 0: none */
};

/* `material`: what a surface reflects beside its own colour, 0..1. */
struct scene_reflection {
    bool own_ambient;
    int32_t ambient[3], specular[3], emission[3];
    int32_t shininess; /* 1..1024; 0: no highlights */
    bool two_sided;
};

struct scene_light {    /* towards[] all zero: no light */
    int32_t towards[3]; /* direction to the light in eye space, any length */
    int32_t ambient, diffuse;
};

/* What becomes of a pixel that is drawn over another. */
enum scene_blend {
    SCENE_BLEND_OFF,
    SCENE_BLEND_ALPHA,
    SCENE_BLEND_ADD,
    SCENE_BLEND_MULTIPLY,
    SCENE_BLEND_NONE,    /* only depths are written */
    SCENE_BLEND_REPLACE, /* as off, but for what is kept */
    SCENE_BLEND_SCREENDOOR
};

/* `depthformat`: what stores depths. */
enum scene_depth_format { SCENE_LINEAR16, SCENE_FLOAT16, SCENE_LINEAR24, SCENE_LINEAR32 };

enum scene_fog_kind { SCENE_FOG_OFF, SCENE_FOG_LINEAR, SCENE_FOG_EXP, SCENE_FOG_EXP2 };

struct scene_fog {
    enum scene_fog_kind kind;
    int32_t range[2];  /* near and far of the projection, 0 < near < far */
    int32_t color[3];  /* 0..1 */
    int32_t number[2]; /* start and end, or the density */
};

struct scene {
    int width, height; /* viewport: the whole picture, 1..SCENE_MAX_SIZE */
    int32_t clear[3];  /* 0..1 */
    int32_t clear_depth;
    bool depth_test;  /* `depth off`: neither tested nor written */
    bool depth_write; /* false only after `depthmask off` */
    enum scene_compare depth_compare;
    enum scene_depth_format depth_format;
    enum scene_cull cull;
    enum scene_frustum_cull frustum_cull;
    bool flat;
    bool by_pixel;       /* lights are looked at from every pixel, not from vertices */
    int provoking;       /* flat: the vertex, 0 or 2, whose colour the triangle takes */
    bool screen_linear;  /* `interpolate linear`: attributes linear on the screen */
    bool wireframe;      /* `polygon line` and `polygon smooth` */
    bool hidden_lines;   /* `polygon hidden`: of meshes, their surface hides what is behind it */
    int32_t hidden_bias; /* 0..1: how much nearer their lines are */
    bool smooth_lines;   /* `polygon smooth` */
    bool wide_lines;     /* `polygon wide`: of meshes, every edge is a stroke */
    struct scene_stroke wide; /* how, with smooth lines too */
    enum scene_antialias antialias;
    enum scene_texture_mode texture_mode;
    enum scene_blend blend;
    int32_t alpha; /* 0..1 */
    bool keep[3];  /* `colormask`: channels that a blend does not write */
    struct scene_fog fog;
    bool texture_clamp[2];  /* `texwrap`, u and v; otherwise repeated */
    bool texture_bilinear;  /* `texfilter` */
    bool texture_mipmapped; /* its second word */
    uint8_t texture_keyed;  /* `texkey`: texels stored as texture_key would be are not drawn */
    uint8_t texture_key[3]; /* 8 bits a channel */
    int least_alpha;        /* `alphatest`: texels of less are not drawn, 0..255 */
    enum scene_texel_format
        texel_format; /* of palettes the parser guarantees 256 colours at most */
    struct scene_texture texture;
    int32_t depth_near, depth_far; /* `depthrange`, 0..1 each, either order */
    struct scene_light light;
    bool lamps_on; /* `ambient`, `material` or a kind of `light` was met: meshes and triangles */
    int32_t ambient[3];
    struct scene_lamp lamps[SCENE_MAX_LAMPS];
    int lamp_count;
    struct scene_reflection reflection;
    bool texture_sphere; /* `texgen sphere`: meshes' coordinates are those of their normals */

    struct scene_vertex *stroke_vertices; /* of all strokes, in order */
    size_t stroke_vertex_count;
    struct scene_key *keys; /* of all tracks, in order */
    size_t key_count;

    struct scene_op *ops;
    size_t op_count;
    struct obj_mesh *meshes; /* each file once, however often it is drawn */
    size_t mesh_count;
    struct scene_model *models; /* of each operation its own */
    size_t model_count;
    uint32_t triangle_count;   /* the largest id: of the first pass that of all passes */
    uint32_t triangles_before; /* of passes before this one */
    struct scene_paints paints;
    struct scene *next; /* the pass that is drawn over this one; NULL: none */
};

/*
 * Parses the scene in `text` (`length` bytes, any content). `name` is what messages call the file;
 * paths of meshes and textures are relative to the folder of `name`, hold no white space and no
 * `#`, and must lead to ordinary files. Of several `texture` statements only the last is carried
 * out. Returns true and fills *scene (to be freed with scene_free), or false with *error set and
 * nothing to free.
 */
bool scene_parse(const char *name, const char *text, size_t length, struct scene *scene,
                 struct text_error *error);

/* Reads a file and parses it as above. */
bool scene_read(const char *path, struct scene *scene, struct text_error *error);

struct scene_reading {
    double time; /* $t of expressions, 0..1 */
    /* Meshes and textures must lie in the scene's folder or below, links followed, or they are an
       error: for scenes from elsewhere. */
    bool below;
    const char *output; /* NULL, or a path that is going to be written: if it leads to the scene or
                           to a file that it names, that is an error, too */
};

bool scene_read_as(const char *path, const struct scene_reading *how, struct scene *scene,
                   struct text_error *error);

void scene_free(struct scene *scene);

/* The name and the arguments of statement `i` of the language; false behind the last. */
bool scene_statement_usage(size_t i, const char **name, const char **arguments);

#endif
