/* SPDX-License-Identifier: MIT */
/*
 * Random states and the pictures that are drawn with them: surfaces, depths, textures, light,
 * blends, fog, shapes, whole and in bands. Only the public API, no memory but the caller's and
 * nothing of a C library but memcpy and memset, so firmware draws them too: `check-same` compares
 * the pictures of compilers and cores, test_core_pictures.c with those that were recorded.
 */
#ifndef QTRI_TESTS_SUPPORT_RANDOM_STATES_H
#define QTRI_TESTS_SUPPORT_RANDOM_STATES_H

#include "random.h"

enum {
    STATES_WIDTH = 53,
    STATES_HEIGHT = 41,
    STATES_PIXELS = STATES_WIDTH * STATES_HEIGHT, /* at most */
    STATES_CORNERS = 12,
    STATES_VERTICES = 210, /* at most, of a mesh */
    STATES_TRIANGLES = 420,
    STATES_BYTES = STATES_PIXELS * (QTRI_XRGB8888_X4_BYTES + QTRI_DEPTH_LINEAR16_BYTES) + 8
};

typedef struct random_states {
    uint64_t seed;
    bool failed;           /* an init function returned an error, or a word behind was written */
    int32_t band_rows;     /* of surfaces, which are drawn band by band; 0: whole */
    int32_t tile_columns;  /* of scissors, which bands are drawn by one after the other; 0: all */
    uint32_t other_depths; /* goes on from here: a checksum of depths that are not 16 bits */
    int32_t width, height; /* of a surface: mostly those above, or about as many pixels */
    const qtri_pipeline *const *pipelines; /* of all draws; NULL: the default list */
    qtri_view view;
    qtri_vertex vertices[STATES_VERTICES];
    qtri_transform pose;
    qtri_material material;
    qtri_texture texture;
    const void *levels[5];
    uint32_t texels[32 * 32];
    qtri_fog fog;
    qtri_light light;
    qtri_light lights;
    qtri_light_source sources[3];
    qtri_shininess table;
    qtri_reflection reflection;
    qtri_mesh mesh;
    qtri_vec3 positions[STATES_VERTICES];
    qtri_normal normals[STATES_VERTICES];
    qtri_vec2 uvs[STATES_VERTICES];
    qtri_rgb colors[STATES_VERTICES];
    uint8_t alphas[STATES_VERTICES];
    uint16_t triangles[STATES_TRIANGLES][3];
    qtri_position16 positions16[STATES_VERTICES];
    qtri_normal8 normals8[STATES_VERTICES];
    qtri_uv16 uvs16[STATES_VERTICES];
    qtri_corner corners[STATES_CORNERS];
    qtri_screen_vertex screen[STATES_CORNERS];
    qtri_stroke stroke;
    /* Passes over a frame or over its bands. */
    uint32_t
        outline[QTRI_OUTLINE_WORDS(STATES_TRIANGLES) + QTRI_OUTLINE_SUMS(STATES_VERTICES) + 60];
    uint32_t outline_words; /* of it, before one that nobody writes */
    uint32_t edges[QTRI_EDGES_WORDS_WITHOUT_DEPTH(STATES_WIDTH, STATES_HEIGHT, 4)];
    uint16_t lists[400];
    qtri_vertex prepared_vertices[STATES_VERTICES + STATES_VERTICES / 2];
    uint16_t neighbours[STATES_TRIANGLES][3];
    uint8_t halo_memory[QTRI_FRAME_BYTES(STATES_WIDTH, STATES_HEIGHT + 2 * 3, QTRI_XRGB8888_BYTES)];
    qtri_outline outlined;
    qtri_edges pass;
    /* Surfaces. */
    uint8_t *memory, *resolved;     /* the caller's, STATES_BYTES each */
    uint16_t depths[STATES_PIXELS]; /* of all bands */
} random_states;

/* Random numbers of the states' own. */
int32_t random_below(random_states *w, int32_t count);
bool random_one_in(random_states *w, int32_t count);

/* In any range, and the size of a surface: one of so many shapes. */
q16 random_between(random_states *w, q16 low, q16 high);
qtri_rgb random_rgb(random_states *w);
void random_size(random_states *w, int32_t shapes);

/* View, lights and material, fog and texture. */
void random_view(random_states *w);
void random_material(random_states *w);

/* After these: what most programs draw, with none of what is special. */
void random_usual(random_states *w);

/* A shape, or a soup, in either form of coordinates. */
void random_mesh(random_states *w);

/*
 * Shapes that fill the picture, lit, and mostly seen whole: each step of a pixel shows,
 * which a wrong depth test or an alpha of 0 hides in the others.
 */
void random_solid(random_states *w);

/* Corners of lines and triangles in space, and vertices on the screen. */
void random_corners(random_states *w);
void random_screen(random_states *w);

/* A draw call of a view and a material that are random. */
typedef void random_draw(random_states *w, const qtri_surface *surface);
void random_draw_mesh(random_states *w, const qtri_surface *surface); /* of w->mesh */
void random_draw_soup(random_states *w, const qtri_surface *surface); /* of a random mesh */
void random_draw_solid(random_states *w, const qtri_surface *surface);
void random_draw_corners(random_states *w, const qtri_surface *surface);
void random_draw_screen(random_states *w, const qtri_surface *surface);
/* Mostly by pipelines that have a name. */
void random_draw_usual(random_states *w, const qtri_surface *surface);
void random_draw_usual_screen(random_states *w, const qtri_surface *surface);
void random_draw_outlined(random_states *w, const qtri_surface *surface);

/* A picture: what it draws into, and a checksum that goes on from `hash`. */
typedef uint32_t random_picture(random_states *w, uint32_t hash, random_draw *draw);

/* Two draws on a surface of any format and depth, and the same of four samples a pixel, resolved.
 */
uint32_t random_on_surface(random_states *w, uint32_t hash, random_draw *draw);
uint32_t random_on_samples(random_states *w, uint32_t hash, random_draw *draw);

/* A mesh that is prepared once and drawn in bands with rows in common; `draw` does not matter. */
uint32_t random_in_bands(random_states *w, uint32_t hash, random_draw *draw);

/* Large triangles that are flat or of colours, in front of and behind depths a step away, by all
   pipelines that draw pixels by fours; `draw` does not matter. */
uint32_t random_by_fours(random_states *w, uint32_t hash, random_draw *draw);

/* FNV-1a of the lowest bytes of a value, in the order that every machine has. */
#define RANDOM_HASH_BEGIN 2166136261u
uint32_t random_hash(uint32_t hash, uint32_t value, int32_t bytes);

/* The kinds of pictures, in a list that ends with a NULL name. */
typedef struct random_kind {
    const char *name;
    random_draw *draw;
    random_picture *picture;
    bool in_bands; /* a picture drawn in bands of any height has the pixels of the whole */
} random_kind;
extern const random_kind random_kinds[];

#endif
