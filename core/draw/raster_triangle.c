/* SPDX-License-Identifier: MIT */
#include "qtri/raster.h"

#include "qtri/error.h"

#include "../bits/bits.h"
#include "../raster/checked_material.h"
#include "../raster/descriptions.h"
#include "../raster/draw_state.h"
#include "../raster/triangle.h"
#include "large_piece.h"

/* Coordinates are as they are; all else is held to what large.h says. */
static void set_vertex(qtri_large_vertex *out, const qtri_screen_vertex *v, uint32_t alpha)
{
    const uint32_t farthest = (uint32_t)65535 << 16;
    const uint32_t mantissa = v->inv_w_q31 | (v->inv_w_q31 == 0);
    const int32_t zeros = qtri_clz32(mantissa);
    out->depth_16p16 = v->depth_16p16 < farthest ? v->depth_16p16 : farthest;
    out->inv_w_q31 = mantissa << zeros >> 1;
    out->inv_w_exponent = qtri_saturate32((int64_t)v->inv_w_exponent - zeros);
    out->light_q15 = 0;
    for (int i = 0; i < 3; i++) {
        out->color_8p16[i] = qtri_hold32(v->color_8p16[i], 0, 255 << 16);
    }
    out->u_q32 = v->u_q32;
    out->v_q32 = v->v_q32;
    out->rest[0] = 0;
    out->rest[1] = 0;
    out->alpha_q16 = (alpha << 16) / 255;
}

void qtri_raster_triangle(const qtri_surface *surface, const qtri_pipeline *const *pipelines,
                          const qtri_material *material, const qtri_screen_vertex v[3])
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_ASSERT(v != NULL);
    qtri_draw_state state;
    qtri_screen_point at[3];
    qtri_large_vertex vertex[3];
    const qtri_screen_point *const p[3] = {&at[0], &at[1], &at[2]};
    for (int i = 0; i < 3; i++) {
        at[i].x_24p8 = qtri_hold32(v[i].x_24p8, -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
        at[i].y_24p8 = qtri_hold32(v[i].y_24p8, -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
        set_vertex(&vertex[i], &v[i], material->alphas != NULL ? material->alphas[i] : 255);
    }
    const int64_t area = qtri_triangle_area(p[0], p[1], p[2]);
    if (area == 0 || qtri_is_culled(material->cull, area)) {
        return;
    }
    qtri_draw_state_init(&state, surface, pipelines, material,
                         qtri_is_smooth(material) ? QTRI_COLORS : QTRI_TINT);
    qtri_large_triangle(&state, p, area,
                        qtri_color_word(vertex[qtri_provoking_of(material)].color_8p16), vertex);
}
