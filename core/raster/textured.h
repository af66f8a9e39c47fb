/* SPDX-License-Identifier: MIT */
/*
 * What textures add to a raster: which stages texels go through. Internal.
 */
#ifndef QTRI_RASTER_TEXTURED_H
#define QTRI_RASTER_TEXTURED_H

#include "job.h"
#include "stage_color.h"
#include "triangle.h"

#define QTRI_SHADE_WHITE ((uint32_t)1020 << QTRI_SHADE_RED | 1020u << QTRI_SHADE_GREEN | 1020u)

/*
 * All that draw calls without texture do without: it is reached through the texel format, so that
 * an application that names none does not link it.
 */
struct qtri_texturing {
    /* The raster's texture, which can be read, and its stages. */
    void (*init)(qtri_raster *raster, const qtri_material *material);
    /* Of a large triangle: its axes and the vertices' coordinates on them. */
    void (*set_axes)(qtri_job *job, uint32_t value[2][3], const qtri_attributes v[3]);
    /* When the attributes of one are set: returns what fills its rows. value as above, q: 1/w of
       the vertices, read where it has perspective. */
    qtri_fill_rows (*begin_large)(qtri_job *job, const qtri_triangle *triangle,
                                  const uint32_t value[2][3], const uint32_t q[3]);
    /* Colours of `count` pixels of the row from x on; the mask of those that are drawn. */
    uint32_t (*color_chunk)(qtri_scanline *row, int32_t x, int32_t count, uint32_t mask);
    /* Of small triangles: see list_values.h. */
    void (*set_list)(qtri_list_values *v);
    uint32_t (*color_list)(const qtri_list_values *v, uint32_t *color, uint32_t *shade,
                           const uint32_t *place, int32_t count);
    uint32_t (*finish_list)(const qtri_raster *raster, int32_t count, uint32_t mask);
};

/* What the raster's coordinates are, of its texture's sides. */
void qtri_textured_set_coordinates(qtri_raster *raster);

void qtri_textured_init(qtri_raster *raster, const qtri_material *material);
void qtri_textured_axes(qtri_job *job, uint32_t value[2][3], const qtri_attributes v[3]);
qtri_fill_rows qtri_textured_begin_large(qtri_job *job, const qtri_triangle *triangle,
                                         const uint32_t value[2][3], const uint32_t q[3]);
uint32_t qtri_textured_chunk(qtri_scanline *row, int32_t x, int32_t count, uint32_t mask);

/*
 * Numbers of texels, texels (`fetched`), or u and v where they are filtered, become colours: of the
 * working kind where they are to be multiplied (`shaded`), else of the format's. Returns the mask
 * of those that are drawn: the others are the colour key.
 */
uint32_t qtri_texels_color(const qtri_raster *raster, const qtri_texel_axis axis[2],
                           uint32_t *color, uint32_t *v, int32_t count, bool fetched, bool shaded);

#endif
