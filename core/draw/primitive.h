/* SPDX-License-Identifier: MIT */
/*
 * Triangles and lines in homogeneous coordinates: clipped, projected, drawn as a fan. Internal.
 */
#ifndef QTRI_DRAW_PRIMITIVE_H
#define QTRI_DRAW_PRIMITIVE_H

#include "qtri/draw.h"

#include "../geometry/projector.h"
#include "qtri/body/small_triangle.h"

#include "../raster/descriptions.h"
#include "../raster/draw_state.h"
#include "../raster/large.h"
#include "../raster/line.h"
#include "../raster/pixel_light.h"
#include "../raster/stroke_pixels.h"
#include "../raster/triangle.h"

struct qtri_mesh_job;

/* Where a draw call draws to and how. */
typedef struct qtri_primitive {
    const qtri_surface *surface;
    const qtri_material *material;
    qtri_projector projector;
    union {
        struct {
            qtri_draw_state state;
            qtri_small small; /* what a mesh's small triangles have in common */
            qtri_mesh mesh;   /* of loose triangles: where lines need more, there is room */
        } solid;              /* triangles */
        struct {
            qtri_line_job job;
            qtri_stroke_target target; /* the job's */
        } lines;                       /* and wireframes */
    } to;
} qtri_primitive;

/*
 * What &qtri_per_pixel adds to draw calls with a view's lights, in per_pixel.c. Reached through the
 * material's shading alone, so that the linker drops it where no material names it.
 */
struct qtri_by_pixel {
    const qtri_pipeline *const *pipelines; /* preferred to a view's generic one */
    /* Sets the light up, and calls `body`, which draws triangles. */
    void (*run)(qtri_primitive *primitive, const qtri_illumination *by, qtri_lit_body body,
                void *with);
    /* Set the light up at the corners of a mesh's triangle, or at corner i of a loose one. */
    void (*set_corners)(const struct qtri_mesh_job *draw, const void *indices, bool is_back);
    void (*set_corner)(const qtri_primitive *primitive, int i, const qtri_lit_point *point,
                       const qtri_rgb *color);
};

extern const qtri_pipeline qtri_pipeline_by_pixel, qtri_pipeline_texture_by_pixel;
extern const qtri_pipeline *const qtri_pipelines_by_pixel[]; /* these, and NULL */

/* NULL: triangles of this material are lit by vertex or by face, or not filled. */
static inline const qtri_by_pixel *qtri_by_pixel_of(const qtri_material *material)
{
    return material->fill == NULL ? qtri_shading_of(material)->by_pixel : NULL;
}

/* A vertex, on the screen, of the polygon that clipping leaves of a triangle. */
typedef struct qtri_fan_vertex {
    qtri_point at;
    uint32_t depth_16p8; /* times 256, and in the low byte the exponent of inv_w */
    uint32_t inv_w_q31;
    int32_t b1_q30, b2_q30; /* barycentric: weights of the triangle's vertices 1 and 2 */
    int16_t rest[2];        /* snap residual, as in qtri_large_vertex */
} qtri_fan_vertex;

/* A triangle before and after clipping. */
typedef union qtri_shape {
    qtri_clip_vertex clip[3];
    qtri_fan_vertex fan[QTRI_CLIP_MAX];
} qtri_shape;

/*
 * Sets surface, material and the pipeline that draws its triangles. `texture`, `shade`: see
 * draw_state.h.
 */
void qtri_primitive_set_target(qtri_primitive *primitive, const qtri_surface *surface,
                               const qtri_view *view, const qtri_material *material,
                               const qtri_texture *texture, int shade);

/*
 * Sets colour, u and v of a triangle's vertices. Called for each piece of the triangle, since
 * attributes that are not kept take no stack while rows are filled.
 */
typedef void (*qtri_attribute_source)(const void *from, qtri_screen_vertex attributes[3]);

/* Draws the triangle shape->clip, which may need clipping; `shape` is overwritten. */
void qtri_primitive_triangle(const qtri_primitive *primitive, qtri_shape *shape,
                             qtri_attribute_source source, const void *from);

/* ---- Large triangles ---- */

/* Whether the triangle lies wholly on one side of the rectangle that may be drawn to. */
bool qtri_is_beside(const qtri_draw_state *state, const qtri_point *const p[3]);

/*
 * Sets the vertices of a triangle of a fan, or of a whole one; returns its colour, 0x00RRGGBB.
 * Never inlined: attributes take no stack while rows are filled. With QTRI_LIGHT the light of a
 * vertex is its color_8p16[0], 255.0 being 1.
 */
uint32_t qtri_primitive_set_piece(qtri_large_vertex v[3], const qtri_primitive *primitive,
                                  const qtri_fan_vertex *const vertex[3],
                                  qtri_attribute_source source, const void *from);

/* 0x00RRGGBB of channels 0..255.0, rounded. */
uint32_t qtri_color_word(const int32_t color_8p16[3]);

/* ---- Lines ---- */

/* Sets primitive->to for lines, whatever the material's fill. */
void qtri_primitive_begin_lines(qtri_primitive *primitive);

/* Draws the outline of a triangle that may need clipping by `planes`, its outcodes or-ed. */
void qtri_primitive_outline(const qtri_primitive *primitive, const qtri_clip_vertex v[3],
                            unsigned planes, qtri_attribute_source source, const void *from);

/* Draws the line between two vertices, which may need clipping. Attributes: colours alone. */
void qtri_primitive_line(const qtri_primitive *primitive, const qtri_clip_vertex *a,
                         const qtri_clip_vertex *b, const qtri_screen_vertex *a_attributes,
                         const qtri_screen_vertex *b_attributes);

#endif
