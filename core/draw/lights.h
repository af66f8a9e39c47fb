/*
 * What draw calls do with the lights of a view: lights->model. Internal.
 *
 * Nothing else names these functions: where no lights are set, nothing of them is linked.
 */
#ifndef QTRI_DRAW_LIGHTS_H
#define QTRI_DRAW_LIGHTS_H

#include "../geometry/illumination.h"
#include "mesh_job.h"

struct qtri_light_model {
    /* Calls `body` while draw->illumination is there: on the stack. */
    void (*mesh)(qtri_mesh_job *draw, const qtri_view *view, const qtri_transform *pose,
                 void (*body)(qtri_mesh_job *draw, void *with), void *with);
    /* Lights the vertices whose numbers are vertices[0..count-1].index, where they have room. */
    void (*list)(const qtri_mesh_job *draw, uint32_t count);
    /* The same for these three, where they are not lit yet. */
    void (*meet)(const qtri_mesh_job *draw, const uint32_t index[3]);
    /*
     * The colours of a triangle of the mesh, in its light. One inside all planes shows the side
     * that its area tells; the other kind brings its corners.
     */
    void (*shade)(const qtri_mesh_job *draw, const uint32_t index[3], const qtri_vertex *a,
                  const qtri_vertex *b, const qtri_vertex *c, qtri_rgb color[3]);
    void (*shade_clipped)(const qtri_mesh_job *draw, const uint32_t index[3],
                          const qtri_clip_vertex v[3], qtri_rgb color[3]);
    /* For three corners of their own: calls `body` with what shade_corners wants. */
    void (*corners)(const qtri_view *view, const qtri_transform *pose,
                    const qtri_material *material,
                    void (*body)(const qtri_illumination *by, void *with), void *with);
    /* Replaces the corners' colours. clip: NULL for a triangle inside all planes, of this area. */
    void (*shade_corners)(const qtri_illumination *by, const qtri_material *material,
                          const qtri_clip_vertex *clip, int64_t area, qtri_corner corner[3]);
};

/* Forgets what vertices were lit. */
void qtri_mesh_clear_light(const qtri_mesh_job *draw);

#endif
