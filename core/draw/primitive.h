/*
 * From homogeneous screen coordinates to the rasterizer: clip, project, fan. Internal.
 */
#ifndef QTRI_DRAW_PRIMITIVE_H
#define QTRI_DRAW_PRIMITIVE_H

#include "qtri/draw.h"

#include "../geometry/projector.h"
#include "../raster/line.h"
#include "../raster/triangle.h"

/* Where a draw call draws to and how. */
typedef struct qtri_primitive {
    const qtri_surface *surface;
    const qtri_material *material;
    qtri_raster raster; /* of solid triangles */
    qtri_line_job line; /* of lines and wireframes */
    qtri_projector projector;
} qtri_primitive;

/* projection camera pose, folded with the viewport. */
void qtri_primitive_init(qtri_primitive *primitive, const qtri_surface *surface,
                         const qtri_view *view, const qtri_transform *pose,
                         const qtri_material *material);

/*
 * Draws a triangle or a line that may need clipping. `attributes` brings colour, u and v of each
 * vertex; its positions are not read.
 */
void qtri_primitive_triangle(const qtri_primitive *primitive, const qtri_clip_vertex v[3],
                             const qtri_screen_vertex attributes[3]);
void qtri_primitive_line(const qtri_primitive *primitive, const qtri_clip_vertex v[2],
                         const qtri_screen_vertex attributes[2]);

/* Draws a triangle whose vertices are on the screen, solid or as three lines. */
void qtri_primitive_screen_triangle(const qtri_primitive *primitive, qtri_screen_vertex v[3]);

/* Whether culling drops a triangle of this area: 2^-15 square pixels, negative is front. */
bool qtri_primitive_culled(const qtri_material *material, int64_t area);

/* Twice the area in 1/256 pixel squared; negative is counter-clockwise to the eye. */
int64_t qtri_primitive_area(const qtri_screen_vertex *a, const qtri_screen_vertex *b,
                            const qtri_screen_vertex *c);

#endif
