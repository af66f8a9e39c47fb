#include "triangle.h"

#include "fill.h"
#include "rows.h"
#include "setup.h"
#include "texel_copy.h"

void qtri_raster_init(qtri_raster *raster, const qtri_surface *surface,
                      const qtri_material *material)
{
    raster->surface = surface;
    raster->texture =
        QTRI_WITH_TEXTURES && qtri_texture_usable(material->texture) ? material->texture : NULL;
    raster->bounds = qtri_drawn_bounds(surface);
    raster->compare = surface->depth == NULL ? QTRI_DEPTH_OFF : material->depth_compare;
    raster->depth_write = !material->depth_read_only;
    raster->perspective = QTRI_WITH_PERSPECTIVE && material->interpolation == QTRI_PERSPECTIVE;
    raster->replace = qtri_raster_texture(raster) != NULL && material->texture_mode == QTRI_REPLACE;
    raster->cull = material->cull;
    raster->shading = qtri_shading_of(material);
    raster->copies_white = qtri_raster_texture(raster) != NULL &&
                           qtri_kind_of(surface) == QTRI_KIND_RGB565 &&
                           qtri_texel_copy_fits(raster->texture);
    if (raster->copies_white) {
        raster->texel_cut = qtri_texel_cut(raster->texture);
    }
    qtri_fill_choose(raster);
}

void qtri_raster_set_tint(qtri_raster *raster, qtri_rgb color)
{
    int32_t color_8p16[3] = {(int32_t)color.r << 16, (int32_t)color.g << 16,
                             (int32_t)color.b << 16};
    raster->tint = qtri_channels_from_color(qtri_colors_of(raster->surface), color_8p16);
    for (int i = 0; i < 3; i++) {
        raster->tint_n6[i] = raster->tint.c[i] >> 10;
    }
}

/* Apart, as its edges take stack that most triangles do without. */
QTRI_NOINLINE static void fill_tall(const qtri_job *job, qtri_triangle *triangle,
                                    qtri_fill_rows fill)
{
    qtri_rows rows;
    qtri_rows_init(&rows, triangle);
    for (;;) {
        int32_t row = rows.row;
        int32_t count = qtri_rows_next(&rows, triangle->spans);
        if (count == 0) {
            break;
        }
        fill(job, triangle->spans, row, count);
    }
}

void qtri_triangle_fill(const qtri_job *job, qtri_triangle *triangle, qtri_fill_rows fill)
{
    if (QTRI_WITH_FAST_PATHS && triangle->size != QTRI_LARGE) {
        fill(job, triangle->spans, triangle->row, triangle->end - triangle->row);
    } else {
        fill_tall(job, triangle, fill);
    }
}

void qtri_triangle_draw(const qtri_raster *raster, qtri_triangle *triangle,
                        const qtri_attributes v[3])
{
    qtri_job job;
    qtri_triangle_fill(&job, triangle, qtri_job_init(&job, raster, triangle, v));
}

static void attributes_from_screen(qtri_attributes *out, const qtri_screen_vertex *v,
                                   const qtri_colors *colors)
{
    const uint32_t farthest = (uint32_t)65535 << 16;
    out->depth_16p16 = v->depth_16p16 < farthest ? v->depth_16p16 : farthest;
    uint32_t mantissa = v->inv_w_q31 | (v->inv_w_q31 == 0);
    int32_t zeros = qtri_clz32(mantissa);
    out->inv_w_q31 = mantissa << zeros >> 1;
    out->inv_w_exponent = qtri_saturate32((int64_t)v->inv_w_exponent - zeros);
    qtri_channels color = qtri_channels_from_color(colors, v->color_8p16);
    for (int i = 0; i < 3; i++) {
        out->color[i] = color.c[i];
    }
    out->u_q32 = v->u_q32;
    out->v_q32 = v->v_q32;
}

void qtri_raster_draw(const qtri_raster *raster, const qtri_screen_vertex v[3])
{
    qtri_triangle triangle;
    qtri_screen_point p[3];
    for (int i = 0; i < 3; i++) {
        p[i].x_24p8 = qtri_hold32(v[i].x_24p8, -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
        p[i].y_24p8 = qtri_hold32(v[i].y_24p8, -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
        triangle.p[i] = &p[i];
    }
    triangle.tinted = false;
    triangle.area = qtri_triangle_area(&p[0], &p[1], &p[2]);
    if (triangle.area == 0 || qtri_is_culled(raster->cull, triangle.area) ||
        !qtri_triangle_begin(raster, &triangle)) {
        return;
    }
    qtri_attributes attributes[3];
    for (int i = 0; i < 3; i++) {
        attributes_from_screen(&attributes[i], &v[i], qtri_colors_of(raster->surface));
    }
    qtri_triangle_draw(raster, &triangle, attributes);
}

void qtri_raster_triangle(const qtri_surface *surface, const qtri_material *material,
                          const qtri_screen_vertex v[3])
{
    qtri_raster raster;
    qtri_raster_init(&raster, surface, material);
    qtri_raster_draw(&raster, v);
}
