/* SPDX-License-Identifier: MIT */
/*
 * A triangle of screen vertices by the generic pipeline, the small way where it is small: what
 * qtri_raster_triangle() is given.
 */
#ifndef QTRI_TESTS_SUPPORT_BY_PIPELINE_H
#define QTRI_TESTS_SUPPORT_BY_PIPELINE_H

#include "core.h"

#include "qtri/body/small_triangle.h"
#include "raster/draw_state.h"
#include "raster/large.h"
#include "raster/triangle.h"

static inline uint32_t by_pipeline_color(const qtri_screen_vertex *v)
{
    uint32_t rgb = 0;
    for (int k = 0; k < 3; k++) {
        rgb = rgb << 8 | (uint32_t)(v->color_8p16[k] >> 16);
    }
    return rgb;
}

static inline void draw_large_by_pipeline(qtri_draw_state *state, const qtri_screen_vertex v[3],
                                          int64_t area)
{
    const qtri_point at[3] = {
        {v[0].x_24p8, v[0].y_24p8}, {v[1].x_24p8, v[1].y_24p8}, {v[2].x_24p8, v[2].y_24p8}};
    const qtri_point *const p[3] = {&at[0], &at[1], &at[2]};
    qtri_large_vertex large[3];
    memset(large, 0, sizeof large);
    for (int i = 0; i < 3; i++) {
        const uint32_t inv_w = v[i].inv_w_q31 == 0 ? 1 : v[i].inv_w_q31;
        const uint32_t zeros = (uint32_t)__builtin_clz(inv_w);
        large[i].depth_16p16 = v[i].depth_16p16;
        large[i].inv_w_q31 = zeros == 0 ? inv_w >> 1 : inv_w << (zeros - 1); /* 2^30..2^31 */
        large[i].inv_w_exponent = 40 + v[i].inv_w_exponent - (int32_t)zeros;
        large[i].u_q32 = v[i].u_q32;
        large[i].v_q32 = v[i].v_q32;
        large[i].light_q15 = (uint32_t)v[i].color_8p16[0] / 510;
        memcpy(large[i].color_8p16, v[i].color_8p16, sizeof large[i].color_8p16);
    }
    qtri_large_triangle(state, p, area, by_pipeline_color(&v[0]), large);
}

static inline void draw_by_pipeline(const qtri_surface *surface, const qtri_material *material,
                                    const qtri_screen_vertex v[3])
{
    static const uint16_t indices[3] = {0, 1, 2};
    const qtri_pipeline *const list[] = {&qtri_pipeline_any, NULL};
    const bool is_smooth = material->shading != NULL && material->shading != QTRI_FLAT_FIRST &&
                           material->shading != QTRI_FLAT_LAST;
    qtri_draw_state state;
    qtri_vertex vertex[3];
    qtri_vec2 uvs[3];
    qtri_rgb colors[3];
    qtri_mesh mesh;
    qtri_small t;
    qtri_draw_state_init(&state, surface, list, material, material->texture,
                         is_smooth ? QTRI_COLORS : QTRI_TINT);
    memset(&mesh, 0, sizeof mesh);
    memset(&t, 0, sizeof t);
    mesh.uvs = uvs;
    mesh.colors = colors;
    t.state = &state;
    t.mesh = &mesh;
    t.indices = indices;
    t.light_q15 = 1 << 15;
    for (int i = 0; i < 3; i++) {
        const uint32_t inv_w = v[i].inv_w_q31 == 0 ? 1 : v[i].inv_w_q31;
        const uint32_t zeros = (uint32_t)__builtin_clz(inv_w);
        vertex[i].at.x_24p8 = v[i].x_24p8;
        vertex[i].at.y_24p8 = v[i].y_24p8;
        vertex[i].depth_16p8 =
            (v[i].depth_16p16 & ~0xFFu) | (uint32_t)(40 + v[i].inv_w_exponent - (int32_t)zeros);
        vertex[i].inv_w = zeros == 0 ? inv_w >> 1 : inv_w << (zeros - 1);
        vertex[i].intensity_q15 = 1 << 15;
        vertex[i].index = (uint16_t)i;
        uvs[i].x = (q16)(v[i].u_q32 >> 16);
        uvs[i].y = (q16)(v[i].v_q32 >> 16);
        colors[i].r = (uint8_t)(v[i].color_8p16[0] >> 16);
        colors[i].g = (uint8_t)(v[i].color_8p16[1] >> 16);
        colors[i].b = (uint8_t)(v[i].color_8p16[2] >> 16);
        t.v[i] = &vertex[i];
        t.index[i] = (uint32_t)i;
    }
    const qtri_point at[3] = {vertex[0].at, vertex[1].at, vertex[2].at};
    const int64_t area = qtri_triangle_area(&at[0], &at[1], &at[2]);
    if (area != 0 && !state.small(&t)) {
        draw_large_by_pipeline(&state, v, area);
    }
}

#endif
