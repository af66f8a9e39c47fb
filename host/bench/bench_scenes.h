/* SPDX-License-Identifier: MIT */
/*
 * The benchmark scenes: the same work on boards and on the host, and for every renderer.
 *
 * 320x240, RGB565 and 16-bit depth, whole frame. Freestanding.
 */
#ifndef BENCH_SCENES_H
#define BENCH_SCENES_H

#include <stdbool.h>
#include <stdint.h>

#include "bench_world.h"
#include "qtri.h"

#define BENCH_WIDTH       320
#define BENCH_HEIGHT      240
#define BENCH_CORNERS_MAX (3 * BENCH_TRIANGLES_MAX)

struct bench_frame;

typedef enum bench_work {
    BENCH_CLEAR,  /* colour and depth */
    BENCH_QUAD,   /* two triangles */
    BENCH_MESH,   /* lit */
    BENCH_STROKE, /* a polyline or points, see bench_strokes.c */
    BENCH_PAINT,  /* flat shapes, pictures and text: see bench_paint.h */
    BENCH_CORNERS /* the triangles of a wide mesh without indices or light, each with corners of its
                     own */
} bench_work;

/* What is done about jagged edges. */
typedef enum bench_smooth {
    BENCH_JAGGED,
    BENCH_EDGES,   /* the mesh's outline, by neighbours */
    BENCH_SUMS,    /* the same by sums */
    BENCH_HALVE,   /* drawn at twice the size, cleared before, and halved */
    BENCH_SAMPLES, /* four a pixel, cleared before, and resolved */
    BENCH_FXAA,
    BENCH_ADD, /* only a frame's addition to a sum, and only the mean's storing */
    BENCH_STORE
} bench_smooth;

typedef struct bench_scene {
    const char *name;
    const qtri_shading *shading; /* NULL: smooth */
    const qtri_filter *filter;
    const bench_quad *quad;
    const qtri_mesh *mesh;
    const qtri_rgb *colors; /* of the quad's corners; of the mesh's vertices, or NULL: one colour */
    void (*paint)(struct bench_frame *frame);
    const qtri_blend *blend;        /* at half alpha */
    const qtri_depth_format *depth; /* NULL: linear16 */
    const qtri_format *format;      /* NULL: RGB565 */
    qtri_compare compare;           /* 0: less */
    bench_work work;
    qtri_interpolation interpolation;
    q16 turn;          /* the mesh, about y */
    q16 width;         /* of strokes, with smooth edges; of a mesh: its wireframe's */
    int32_t band_rows; /* not 0: prepared, then drawn in bands of so many rows */
    uint32_t lights;   /* not 0: so many sources, and highlights, in place of the light */
    bench_smooth smooth;
    uint32_t characters; /* that are painted */
    uint32_t calls; /* not 0: the mesh so often, 8 to a row of the screen, each turned otherwise */
    bool white;     /* the material's colour, which then leaves texels in light alone */
    bool wireframe, without_depth, fog;
    bool dull;           /* lights, but no highlights */
    bool textured;       /* REPLACE on quads, MODULATE on meshes */
    bool keyed;          /* the texture has a key, which no texel equals */
    bool texels_888;     /* the texture is of XRGB8888 */
    bool sprite;         /* it is of ARGB4444, half transparent */
    bool thin;           /* a wireframe of smooth lines */
    bool points, hidden; /* points for a polyline; a wireframe without hidden lines */
    bool chart;          /* a polyline of 160 points */
    bool keeps;          /* bands that keep the rows they share */
} bench_scene;

extern const bench_scene bench_scenes[]; /* a null name ends it */

/* What smoothing needs. Bands that overlap lie one below the other, unless rows are kept. */
typedef struct bench_smoother {
    qtri_outline outline;
    qtri_frame overlapped;
    uint32_t kept[QTRI_FRAME_KEPT_BYTES(BENCH_WIDTH, 1, QTRI_RGB565_BYTES) / sizeof(uint32_t)];
    uint32_t outline_memory[QTRI_OUTLINE_WORDS(BENCH_TRIANGLES_MAX) +
                            QTRI_OUTLINE_SUMS(BENCH_VERTICES_MAX) +
                            QTRI_OUTLINE_LISTS(BENCH_TRIANGLES_MAX, BENCH_HEIGHT, 16)];
    uint32_t edge_memory[QTRI_EDGES_WORDS(BENCH_WIDTH, BENCH_HEIGHT, QTRI_RGB565_BYTES)];
    uint32_t bands[QTRI_BAND_BYTES(BENCH_WIDTH, BENCH_HEIGHT * 18 / 16, QTRI_RGB565_BYTES) /
                   sizeof(uint32_t)];
    uint32_t large[QTRI_BAND_BYTES(2 * BENCH_WIDTH, 2 * BENCH_HEIGHT, QTRI_RGB565_BYTES) /
                   sizeof(uint32_t)];
    uint32_t rows[QTRI_FXAA_565_WORDS(BENCH_WIDTH)];
    uint32_t sums[QTRI_SUM_565_WORDS(BENCH_WIDTH, BENCH_HEIGHT)];
} bench_smoother;

/* All that drawing a scene needs. */
typedef struct bench_frame {
    const bench_scene *scene;
    qtri_surface surface;
    qtri_view view;
    qtri_transform pose;
    qtri_fog fog; /* the material's */
    qtri_material material;
    qtri_texture texture;
    qtri_mesh mesh; /* with the scene's colours */
    qtri_corner corners[BENCH_CORNERS_MAX];
    uint32_t
        memory[QTRI_BAND_BYTES(BENCH_WIDTH, BENCH_HEIGHT, QTRI_RGB565_BYTES) / sizeof(uint32_t)];
    qtri_vertex vertices[QTRI_LIT_VERTICES(BENCH_VERTICES_MAX)];
    qtri_light lights;
    qtri_shininess shininess;
    qtri_reflection reflection;
    uint16_t texels[BENCH_CHAIN_TEXELS];
    uint32_t texels_888[BENCH_TEXTURE_SIDE * BENCH_TEXTURE_SIDE];
    const void *levels[BENCH_TEXTURE_LOG2 - 1];
    qtri_frame bands;
    qtri_prepared prepared;
    uint16_t lists[QTRI_PREPARED_LISTS(BENCH_TRIANGLES_MAX, BENCH_HEIGHT, 16)];
    bench_smoother smoother;
} bench_frame;

/* Camera, pose, material, and a frame of the background's colour. False: the model is not there. */
bool bench_prepare(bench_frame *frame, const bench_scene *scene);

/* What is measured: the draw calls, without the clear; the clear for BENCH_CLEAR. */
void bench_draw(bench_frame *frame);

/* After it, and not measured: the picture is in frame->surface. */
void bench_finish(bench_frame *frame);

/* Those of them for a scene that is smoothed: bench_smooth.c. */
bool bench_prepare_smooth(bench_frame *frame);
void bench_draw_smooth(bench_frame *frame);
void bench_finish_smooth(bench_frame *frame);

/* Triangles that the draw call is given; characters of text. */
uint32_t bench_triangles(const bench_scene *scene);

/* The corners of a scene of strokes: returns how many, and draws them; or a mesh's edges. */
uint32_t bench_set_strokes(qtri_corner *corners, const bench_scene *scene);
void bench_draw_strokes(bench_frame *frame);

/* Whether the pixel is not of the background's colour and depth. */
bool bench_is_drawn(const bench_frame *frame, int32_t x, int32_t y);

#endif
