/*
 * The vertex stage: object space to the screen, for one draw call. Internal.
 */
#ifndef QTRI_GEOMETRY_PROJECTOR_H
#define QTRI_GEOMETRY_PROJECTOR_H

#include "qtri/clip.h"
#include "qtri/raster.h"
#include "qtri/view.h"

/* Rows from object space to pixels, with the viewport folded in, and their common scale. */
typedef struct qtri_projector {
    qtri_row row[4];   /* x y in pixels times w, z and w of clip space */
    int32_t shift[4];  /* right shift that brings a row's sum to the common scale, >= 2 */
    int64_t depth_sum; /* depth_16p16 = (depth_sum + depth_span z / w) / 2 */
    int64_t depth_span;
} qtri_projector;

/* object_to_clip = projection camera pose. */
void qtri_projector_init(qtri_projector *projector, const qtri_transform *object_to_clip,
                         const qtri_viewport *viewport);

/* (p, 1) in homogeneous screen coordinates; b1 and b2 are set to 0. */
void qtri_projector_point(const qtri_projector *projector, const qtri_vec3 *p,
                          qtri_clip_vertex *out);

/*
 * `count` (1..3) points with any w, of one triangle or line. They share one scale, that of the
 * largest |w| among them.
 */
void qtri_projector_points(const qtri_projector *projector, const qtri_vec4 *const p[], int count,
                           qtri_clip_vertex out[]);

/*
 * Divides by w, snaps x and y to 1/256 pixel (correctly rounded, halves up) and fills position,
 * depth and inv_w of *out. For vertices with outcode 0 or from the clipper; w > 0.
 */
void qtri_project(const qtri_projector *projector, const qtri_clip_vertex *v,
                  qtri_screen_vertex *out);

#endif
