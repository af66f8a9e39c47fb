/* SPDX-License-Identifier: MIT */
/*
 * What &qtri_per_pixel adds to draw calls with a view's lights: reached through the material's
 * shading, so that an application that does not name it does not link it. Internal.
 */
#ifndef QTRI_DRAW_PER_PIXEL_H
#define QTRI_DRAW_PER_PIXEL_H

#include "../raster/pixel_light.h"
#include "../raster/descriptions.h"
#include "mesh_job.h"
#include "qtri/pipeline.h"

extern const qtri_pipeline qtri_pipeline_by_pixel, qtri_pipeline_texture_by_pixel;
extern const qtri_pipeline *const qtri_pipelines_by_pixel[];

struct qtri_by_pixel {
    const qtri_pipeline *const *pipelines; /* before the generic one of a view's */
    /* Calls `body` while triangles are drawn by pixel. */
    void (*run)(qtri_primitive *primitive, const qtri_illumination *by, qtri_lit_body body,
                void *with);
    /* Before each triangle: its corners. Those of a mesh, and one of another. */
    void (*note)(const qtri_mesh_job *draw, const void *indices, bool is_back);
    void (*set)(const qtri_primitive *primitive, int i, const qtri_lit_point *point,
                const qtri_rgb *color);
};

/* That of a material that draws solid triangles; NULL: they are lit by vertex or by face. */
static inline const qtri_by_pixel *qtri_by_pixel_of(const qtri_material *material)
{
    return material->fill == NULL ? qtri_shading_of(material)->by_pixel : NULL;
}

#endif
