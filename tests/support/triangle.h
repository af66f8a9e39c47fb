/* SPDX-License-Identifier: MIT */
/* A triangle on the screen by the generic pipeline: as a small one of a mesh, if it is one. */
#ifndef TEST_SUPPORT_TRIANGLE_H
#define TEST_SUPPORT_TRIANGLE_H

#include "qtri/pipeline_make.h"

#include "core.h"
#include "raster/draw_state.h"
#include "raster/large.h"
#include "raster/triangle.h"

enum { TRIANGLE_LARGE, TRIANGLE_SMALL, TRIANGLE_NOWHERE };

/* Whole colours; u and v of 16 bits of fraction. `may_be_small`: false makes all large. */
static inline int draw_triangle(const qtri_surface *surface, const qtri_material *material,
                                const qtri_screen_vertex v[3], bool may_be_small)
{
    static const qtri_pipeline *const any[] = {&qtri_pipeline_any, NULL};
    static const uint16_t indices[1][3] = {{0, 1, 2}};
    qtri_draw_state state;
    qtri_rgb colors[3];
    qtri_vec2 uvs[3];
    qtri_vertex vertex[3];
    qtri_large_vertex large[3];
    qtri_point at[3];
    const bool is_smooth = material->shading == QTRI_SMOOTH;
    const int provoking = material->shading == QTRI_FLAT_FIRST ? 0 : 2;
    memset(vertex, 0, sizeof vertex);
    memset(large, 0, sizeof large);
    for (int i = 0; i < 3; i++) {
        colors[i].r = (uint8_t)(v[i].color_8p16[0] >> 16);
        colors[i].g = (uint8_t)(v[i].color_8p16[1] >> 16);
        colors[i].b = (uint8_t)(v[i].color_8p16[2] >> 16);
        uvs[i].x = (q16)(v[i].u_q32 >> 16);
        uvs[i].y = (q16)(v[i].v_q32 >> 16);
        at[i].x_24p8 = v[i].x_24p8;
        at[i].y_24p8 = v[i].y_24p8;
        vertex[i].at = at[i];
        int32_t exponent = v[i].inv_w_exponent + 40;
        uint32_t inv_w = v[i].inv_w_q31;
        for (; inv_w < (uint32_t)1 << 30; inv_w <<= 1) {
            exponent--;
        }
        vertex[i].depth_16p8 = (v[i].depth_16p16 & ~0xFFu) | (uint32_t)exponent;
        vertex[i].inv_w = inv_w;
        large[i].depth_16p16 = v[i].depth_16p16 & ~0xFFu;
        large[i].inv_w_q31 = inv_w;
        large[i].inv_w_exponent = exponent;
        memcpy(large[i].color_8p16, v[i].color_8p16, sizeof large[i].color_8p16);
        large[i].u_q32 = v[i].u_q32;
        large[i].v_q32 = v[i].v_q32;
    }
    const int64_t area = qtri_triangle_area(&at[0], &at[1], &at[2]);
    qtri_draw_state_init(&state, surface, any, material, material->texture,
                         is_smooth ? QTRI_COLORS : QTRI_TINT);
    const qtri_mesh mesh = {
        .colors = colors, .uvs = uvs, .triangles = indices, .vertex_count = 3, .triangle_count = 1};
    qtri_small small = {.state = &state,
                        .mesh = &mesh,
                        .v = {&vertex[0], &vertex[1], &vertex[2]},
                        .index = {0, 1, 2},
                        .indices = indices[0],
                        .light_q15 = 1 << 15};
    if (area == 0) {
        return TRIANGLE_NOWHERE;
    }
    if (may_be_small && state.pipeline->small(&small)) {
        return TRIANGLE_SMALL;
    }
    const qtri_point *const p[3] = {&at[0], &at[1], &at[2]};
    const qtri_rgb c = colors[provoking];
    qtri_large_triangle(&state, p, area, (uint32_t)c.r << 16 | (uint32_t)c.g << 8 | c.b, large);
    return TRIANGLE_LARGE;
}

#endif
