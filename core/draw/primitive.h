/* SPDX-License-Identifier: MIT */
/*
 * From homogeneous screen coordinates to the rasterizer: clip, project, fan. Internal.
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
 * What &qtri_per_pixel adds to draw calls with a view's lights: reached through the material's
 * shading, so that an application that does not name it does not link it. In per_pixel.c.
 */
struct qtri_by_pixel {
    const qtri_pipeline *const *pipelines; /* before the generic one of a view's */
    /* Calls `body` while triangles are drawn by pixel. */
    void (*run)(qtri_primitive *primitive, const qtri_illumination *by, qtri_lit_body body,
                void *with);
    /* Before each triangle: its corners. Those of a mesh, and one of another. */
    void (*note)(const struct qtri_mesh_job *draw, const void *indices, bool is_back);
    void (*set)(const qtri_primitive *primitive, int i, const qtri_lit_point *point,
                const qtri_rgb *color);
};

extern const qtri_pipeline qtri_pipeline_by_pixel, qtri_pipeline_texture_by_pixel;
extern const qtri_pipeline *const qtri_pipelines_by_pixel[]; /* these, and NULL */

/* That of a material that draws solid triangles; NULL: they are lit by vertex or by face. */
static inline const qtri_by_pixel *qtri_by_pixel_of(const qtri_material *material)
{
    return material->fill == NULL ? qtri_shading_of(material)->by_pixel : NULL;
}

/* A vertex of what clipping left of a triangle, on the screen. */
typedef struct qtri_fan_vertex {
    qtri_point at;
    uint32_t depth_16p8; /* times 256, and in the low byte the exponent of inv_w */
    uint32_t inv_w_q31;
    int32_t b1_q30, b2_q30;
    int16_t rest[2]; /* as in qtri_large_vertex */
} qtri_fan_vertex;

/* A triangle before and after clipping. */
typedef union qtri_shape {
    qtri_clip_vertex clip[3];
    qtri_fan_vertex fan[QTRI_CLIP_MAX];
} qtri_shape;

/*
 * Surface and material, and the pipeline that draws its triangles; `texture`, `shade`: see
 * draw_state.h.
 */
void qtri_primitive_set_target(qtri_primitive *primitive, const qtri_surface *surface,
                               const qtri_view *view, const qtri_material *material,
                               const qtri_texture *texture, int shade);

/*
 * Sets the projector: projection camera pose, folded with the viewport; and camera pose, unless
 * object_to_eye is NULL.
 */
void qtri_primitive_place(qtri_primitive *primitive, const qtri_view *view,
                          const qtri_transform *pose, qtri_transform *object_to_eye);

/*
 * Sets colour, u and v of a triangle's vertices. They are asked for when a piece of the triangle is
 * to be drawn, and again for the next piece: what is not kept takes no stack while rows are filled.
 */
typedef void (*qtri_attribute_source)(const void *from, qtri_screen_vertex attributes[3]);

/* A vertex's texture coordinates, 0 in a mesh without. */
void qtri_mesh_set_uv(int64_t *u_q32, int64_t *v_q32, const qtri_mesh *mesh, uint32_t index);

/* Draws a triangle that may need clipping. `shape` brings clip, and is overwritten. */
void qtri_primitive_triangle(const qtri_primitive *primitive, qtri_shape *shape,
                             qtri_attribute_source source, const void *from);

/* ---- Large triangles ---- */

/* Whether it matters where vertices truly are, which are snapped to 1/256 pixel. */
bool qtri_rests_matter(const qtri_draw_state *state, const qtri_point *const p[3],
                       const uint32_t depth_16p16[3], int64_t area);

/* Whether the triangle lies wholly on one side of what may be drawn. */
bool qtri_is_beside(const qtri_draw_state *state, const qtri_point *const p[3]);

/*
 * Draws a triangle of what clipping left, or a whole one; twice its area. With QTRI_LIGHT the light
 * of a vertex is its color_8p16[0], 255.0 being 1.
 */
void qtri_primitive_piece(const qtri_primitive *primitive, const qtri_fan_vertex *const vertex[3],
                          int64_t area, qtri_attribute_source source, const void *from);

/* 0..255.0 each, rounded: 0x00RRGGBB. */
uint32_t qtri_color_word(const int32_t color_8p16[3]);

/* ---- Lines ---- */

/* For lines, whatever the material says; then as above. */
void qtri_primitive_begin_lines(qtri_primitive *primitive);

/* The outline of a triangle that may need clipping by `planes`, the sum of its outcodes. */
void qtri_primitive_outline(const qtri_primitive *primitive, const qtri_clip_vertex v[3],
                            unsigned planes, qtri_attribute_source source, const void *from);

/* Draws the line between two vertices. Their attributes bring colour, and no position. */
void qtri_primitive_line(const qtri_primitive *primitive, const qtri_clip_vertex *a,
                         const qtri_clip_vertex *b, const qtri_screen_vertex *a_attributes,
                         const qtri_screen_vertex *b_attributes);

#endif
