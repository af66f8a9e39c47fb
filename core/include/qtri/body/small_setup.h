/* SPDX-License-Identifier: MIT */
/*
 * Set-up of a small triangle: its rows, and light and texture coordinates that are linear on the
 * screen. Internal, part of the pipelines' body (pipeline_make.h).
 *
 * Inlined in each pipeline; where code is to be small and in the generic pipeline, functions of the
 * library that all share (small_triangle.h).
 *
 * 1 / size, size being twice the area, has 16 bits and is off by 2^-14.4 of itself, so a ramp is at
 * a vertex by that much of its range:
 *
 *     x = size 2^zeros / 2^16, rounded, in 2^15..2^16; y = 2^31 / x, rounded down
 *     n 2^16 / size = n y / 2^17 / 2^down, down = 14 - zeros
 *
 * Where the area is below a pixel steps go left by `up` bits, which they then have not: 240 pixels
 * away that is 240 units 2^up.
 */
#ifndef QTRI_BODY_SMALL_SETUP_H
#define QTRI_BODY_SMALL_SETUP_H

#include "small_ramp.h"

#ifdef __cplusplus
extern "C" {
#endif

/* 1 / size. False: a needle. */
QTRI_BODY bool qtri_small_set_inverse(qtri_small_place *p, uint32_t size)
{
    const int32_t zeros = qtri_clz32(size);
    uint32_t y = qtri_small_reciprocal(((size << zeros >> 1) + ((uint32_t)1 << 14)) >> 15);
    y -= y >> 16;
    p->inverse = (int32_t)(QTRI_LONG_MULTIPLY ? y << 15 : y);
    p->down = 14 - zeros;
    p->up = 0;
    if (p->down < 0) {
        QTRI_RARELY();
        p->up = -p->down;
        p->down = 0;
    }
    return p->up <= QTRI_SMALL_NEEDLE;
}

/* Depth of vertices 1 and 2 less that of vertex 0, 16.8, less *up bits where it is steep. False: so
   steep that the snap of vertices shows. */
QTRI_BODY bool qtri_small_find_depth(int32_t *z1, int32_t *z2, int32_t *up,
                                     const qtri_small_place *p, const qtri_small *t)
{
    const uint32_t z0 = t->v[0]->depth_16p8 >> 8;
    *z1 = (int32_t)((t->v[1]->depth_16p8 >> 8) - z0);
    *z2 = (int32_t)((t->v[2]->depth_16p8 >> 8) - z0);
    *up = 0;
    const uint32_t about = qtri_small_abs(*z1) | qtri_small_abs(*z2);
    if (about >> (p->wide ? 15 : 16) != 0) {
        QTRI_RARELY();
        if (about >> QTRI_SMALL_STEEP_LOG2 != 0) {
            return false;
        }
        *z1 >>= QTRI_SMALL_STEEP_DOWN;
        *z2 >>= QTRI_SMALL_STEEP_DOWN;
        *up = QTRI_SMALL_STEEP_DOWN;
    }
    return true;
}

QTRI_BODY bool qtri_small_set_depth(qtri_small_place *p, const qtri_small *t)
{
    int32_t z1, z2, up;
    if (!qtri_small_find_depth(&z1, &z2, &up, p, t)) {
        return false;
    }
    qtri_small_ramp_set(&p->z, p, t->v[0]->depth_16p8 >> 8 << 8, z1, z2, up);
    return true;
}

/* Whether any of these is more than so many pixels. */
QTRI_BODY bool qtri_small_is_far(int32_t dx1, int32_t dy1, int32_t dx2, int32_t dy2,
                                 uint32_t pixels)
{
    const uint32_t far = 256 * pixels;
    return (uint32_t)dx1 + far >= 2 * far || (uint32_t)dy1 + far >= 2 * far ||
           (uint32_t)dx2 + far >= 2 * far || (uint32_t)dy2 + far >= 2 * far;
}

/* Whether vertex 1 or 2 is more than QTRI_SMALL_MIDDLE pixels from vertex 0. */
QTRI_BODY bool qtri_small_is_beyond_middle(const qtri_small_place *p)
{
    return p->wide && qtri_small_is_far(p->dx1, p->dy1, p->dx2, p->dy2, QTRI_SMALL_MIDDLE);
}

/* Light by vertex is as good as by pixel: vertices 1 and 2 are within 6 pixels of vertex 0, or
   light is linear between them. */
QTRI_BODY bool qtri_small_is_lit_by_vertex(const qtri_small_place *p, const qtri_small *t)
{
    const uint32_t half = 6 * 256;
    const qtri_point *a = &t->v[0]->at, *b = &t->v[1]->at, *c = &t->v[2]->at;
    return (((uint32_t)(b->x_24p8 - a->x_24p8) + half) |
            ((uint32_t)(b->y_24p8 - a->y_24p8) + half) |
            ((uint32_t)(c->x_24p8 - a->x_24p8) + half) |
            ((uint32_t)(c->y_24p8 - a->y_24p8) + half)) < 2 * half ||
           (!qtri_small_is_beyond_middle(p) && t->state->has_linear_light(t));
}

/* Sets q1, q2 and q_abs. False: 1/w changes too much. */
QTRI_BODY bool qtri_small_set_q(qtri_small_place *p, const qtri_small *t)
{
    const qtri_vertex *a = t->v[0], *b = t->v[1], *c = t->v[2];
    const uint32_t exponents = (a->depth_16p8 ^ b->depth_16p8) | (a->depth_16p8 ^ c->depth_16p8);
    p->q1 = (int32_t)(b->inv_w - a->inv_w);
    p->q2 = (int32_t)(c->inv_w - a->inv_w);
    p->q_abs = qtri_small_abs(p->q1) | qtri_small_abs(p->q2);
    if (((exponents & 0xFF) | p->q_abs >> 27) != 0) {
        int32_t q[2];
        QTRI_RARELY();
        if (!qtri_small_find_uneven(q, t)) {
            return false;
        }
        p->q1 = q[0];
        p->q2 = q[1];
        p->q_abs = qtri_small_abs(q[0]) | qtri_small_abs(q[1]);
    }
    return true;
}

/* See qtri_small_find(). */
QTRI_BODY qtri_small_found qtri_setup_find(qtri_small_place *p, uint8_t spans[QTRI_SMALL_SPANS],
                                           qtri_small *t)
{
    const qtri_vertex *a = t->v[0], *b = t->v[1], *c = t->v[2];
    uint32_t near = QTRI_SMALL_NEAR;
    QTRI_BODY_BARRIER(near); /* GCC 12 would make it anew each time on a Cortex-M0+ */
    const int32_t x0 = a->at.x_24p8, y0 = a->at.y_24p8;
    int32_t dx1 = b->at.x_24p8 - x0, dy1 = b->at.y_24p8 - y0;
    int32_t dx2 = c->at.x_24p8 - x0, dy2 = c->at.y_24p8 - y0;
    p->wide = false;
    p->turned = false;
    if ((((uint32_t)dx1 + near) | ((uint32_t)dy1 + near) | ((uint32_t)dx2 + near) |
         ((uint32_t)dy2 + near)) >= 2 * near) {
        QTRI_RARELY();
        if (qtri_small_is_far(dx1, dy1, dx2, dy2, QTRI_SMALL_REACH) ||
            qtri_small_range(dy1, dy2) >= QTRI_SMALL_FAR) {
            return QTRI_SMALL_IS_LARGE;
        }
        p->wide = true;
    }
    int32_t size = dx2 * dy1 - dx1 * dy2;
    if (size <= 0) {
        const int32_t dx = dx1, dy = dy1;
        QTRI_RARELY();
        if (!qtri_small_turn(t, size)) {
            return QTRI_SMALL_NOTHING;
        }
        p->turned = true;
        dx1 = dx2, dx2 = dx;
        dy1 = dy2, dy2 = dy;
        size = -size;
    }
    int32_t row = y0 + 127;
    const int32_t rest = row & 255;
    row >>= 8;
    int32_t a_row = 0;
    int32_t b_row = (rest + dy1) >> 8, c_row = (rest + dy2) >> 8;
    int32_t first = qtri_small_min0(b_row, c_row), end = qtri_small_max0(b_row, c_row);
    if (first == end) {
        return QTRI_SMALL_NOTHING;
    }
    const qtri_draw_state *state = t->state;
    const int32_t column = x0 >> 8;
    p->left = 0;
    p->right = 0;
    p->cut = false;
    if (p->wide || (uint32_t)x0 - state->inner.x >= state->inner.width ||
        (uint32_t)y0 - state->inner.y >= state->inner.height) {
        const qtri_rect *bounds = &state->bounds;
        QTRI_RARELY();
        /* In bands most pass no edge but the upper or the lower one: 3 % of a mesh there. */
        if (p->wide || (uint32_t)x0 - state->inner.x >= state->inner.width) {
            p->left = bounds->x0 - column + QTRI_SMALL_REACH;
            p->right = bounds->x1 - column + QTRI_SMALL_REACH;
            p->cut = (x0 + qtri_small_min0(dx1, dx2)) >> 8 < bounds->x0 ||
                     (x0 + qtri_small_max0(dx1, dx2)) >> 8 >= bounds->x1;
        }
        if (row + first < bounds->y0 || row + end > bounds->y1) {
            const int32_t least = bounds->y0 - row, greatest = bounds->y1 - row;
            if (first >= greatest || end <= least) {
                return QTRI_SMALL_NOTHING;
            }
            a_row = qtri_small_clamp(0, least, greatest);
            b_row = qtri_small_clamp(b_row, least, greatest);
            c_row = qtri_small_clamp(c_row, least, greatest);
            first = first > least ? first : least;
            end = end < greatest ? end : greatest;
        }
    }
    uint8_t *const middle = spans - 2 * first; /* of vertex 0's row */
    const int32_t y = 255 - rest;
    const int32_t ax = (x0 & 255) + 128 + (QTRI_DIVIDE ? QTRI_SMALL_FAR : 0);
    p->column = column;
    p->row = row + first;
    p->first = first;
    p->x = 256 + (QTRI_DIVIDE ? QTRI_SMALL_FAR : 0) - ax;
    p->y = y + 256 * first;
    p->dx1 = dx1;
    p->dy1 = dy1;
    p->dx2 = dx2;
    p->dy2 = dy2;
    p->span = spans;
    middle[2 * end] = QTRI_SMALL_STOP;
    middle[2 * end + 1] = QTRI_SMALL_STOP; /* read, and of no effect: nothing ends after a stop */
    QTRI_BODY_READ_AGAIN();
    const int32_t dx = dx2 - dx1, dy = dy2 - dy1;
    int32_t pixels =
        qtri_small_edge(middle, dx1, dy1, qtri_small_cross(ax, y, dx1, dy1), a_row, b_row);
    pixels +=
        qtri_small_edge(middle, dx, dy, qtri_small_cross(ax + dx1, y - dy1, dx, dy), b_row, c_row);
    pixels +=
        qtri_small_edge(middle, -dx2, -dy2, qtri_small_cross(ax, y, -dx2, -dy2), c_row, a_row);
    if (pixels == 0) {
        return QTRI_SMALL_NOTHING;
    }
    QTRI_BODY_READ_AGAIN();
    if (!qtri_small_set_q(p, t)) {
        return QTRI_SMALL_IS_LARGE;
    }
    return qtri_small_set_inverse(p, (uint32_t)size) && qtri_small_set_depth(p, t)
               ? QTRI_SMALL_FOUND
               : QTRI_SMALL_IS_LARGE;
}

/* Light and colours ---------------------------------------------------------------------------- */

/* Linear light and colours may be off by 2^-part of full: half a step of 255, or of 63 over a
   texture and a quarter of one without. */
QTRI_BODY uint32_t qtri_small_part_of(const qtri_options *o)
{
    return qtri_stores_565(o) ? 8u - qtri_is_textured(o) : 9u;
}

/* A curve may be off by 2^-part of full: a quarter of a step, as it may pass vertices' values. */
QTRI_BODY uint32_t qtri_small_curve_part_of(const qtri_options *o)
{
    return qtri_stores_565(o) ? 8u : 10u;
}

/*
 * Whether a value that differs from vertex 0's by f1 and f2, Q15, strays by 2^-part of full at most
 * if it is linear on the screen: by Gruess's bound of a covariance, range (q_max - q_min) / (4
 * q_min). The first test, q_min >= 3/4 2^30 and range <= the sum of magnitudes, does for most.
 */
QTRI_BODY bool qtri_small_is_linear(const qtri_small_place *p, const qtri_small *t, int32_t f1,
                                    int32_t f2, uint32_t part)
{
    const uint32_t sum = qtri_small_abs(f1) + qtri_small_abs(f2) + 2;
    if (sum * ((p->q_abs >> 15) + 1) <= (uint32_t)3 << (29 - part)) {
        return true;
    }
    const uint32_t q_min = t->v[0]->inv_w + (uint32_t)qtri_small_min0(p->q1, p->q2);
    return qtri_small_is_linear_by_range(qtri_small_range(f1, f2), qtri_small_range(p->q1, p->q2),
                                         q_min >> (part - 2));
}

QTRI_BODY bool qtri_setup_light_is_linear(const qtri_small_place *p, const qtri_small *t,
                                          const qtri_options *o)
{
    const int32_t i0 = t->v[0]->intensity_q15;
    return t->state->is_linear ||
           qtri_small_is_linear(p, t, t->v[1]->intensity_q15 - i0, t->v[2]->intensity_q15 - i0,
                                qtri_small_part_of(o));
}

QTRI_BODY void qtri_setup_set_light(qtri_small_ramp *c, const qtri_small_place *p,
                                    const qtri_small *t, uint32_t half)
{
    const int32_t i0 = t->v[0]->intensity_q15;
    qtri_small_ramp_set(c, p, ((uint32_t)i0 << 9) + half, t->v[1]->intensity_q15 - i0,
                        t->v[2]->intensity_q15 - i0, 1);
}

/* Lit channels of a vertex, Q15. */
typedef struct qtri_small_channels {
    int32_t r, g, b;
} qtri_small_channels;

QTRI_SMALL_PART qtri_small_channels qtri_small_channels_of(const qtri_small *t, int i)
{
    qtri_small_channels f;
    const qtri_rgb *color = &t->mesh->colors[t->index[i]];
    const uint32_t light =
        257u * (t->light_q15 <= QTRI_SMALL_ONE ? t->light_q15 : t->v[i]->intensity_q15);
    f.r = (int32_t)((color->r * light + 0x8000u) >> 16); /* <= 2^31 */
    f.g = (int32_t)((color->g * light + 0x8000u) >> 16);
    f.b = (int32_t)((color->b * light + 0x8000u) >> 16);
    return f;
}

/* Channels of vertex 0, and those of vertices 1 and 2 less these. */
typedef struct qtri_small_colors {
    qtri_small_channels at, d1, d2;
} qtri_small_colors;

/* Vertices' colours in a view's lights, in small_values.c. */
void qtri_small_lit_channels(qtri_small_colors *f, const qtri_small *t, bool turned);

QTRI_BODY void qtri_small_colors_of(qtri_small_colors *f, const qtri_small_place *p,
                                    const qtri_small *t)
{
    if (t->state->is_lit) {
        qtri_small_colors lit; /* a copy, so that others need not be in memory */
        QTRI_RARELY();
        qtri_small_lit_channels(&lit, t, p->turned);
        *f = lit;
    } else {
        f->at = qtri_small_channels_of(t, 0);
        f->d1 = qtri_small_channels_of(t, 1);
        f->d2 = qtri_small_channels_of(t, 2);
    }
    f->d1.r -= f->at.r;
    f->d1.g -= f->at.g;
    f->d1.b -= f->at.b;
    f->d2.r -= f->at.r;
    f->d2.g -= f->at.g;
    f->d2.b -= f->at.b;
}

/* Finds the vertices' colours; false: on the screen the lack of perspective would show. */
QTRI_BODY bool qtri_small_colors_find(qtri_small_colors *f, const qtri_small_place *p,
                                      const qtri_small *t, const qtri_options *o)
{
    const uint32_t part = qtri_small_part_of(o);
    qtri_small_colors_of(f, p, t);
    if (t->state->is_linear || p->q_abs >> (30 - part) == 0) {
        return true;
    }
    const int32_t differences[6] = {f->d1.r, f->d2.r, f->d1.g, f->d2.g, f->d1.b, f->d2.b};
    return qtri_small_are_linear(differences, t->v[0]->inv_w, p->q1, p->q2, part);
}

/* A ramp of a channel, Q15 at the vertices, to n.16 from 0 to `full`, in vertex 0's row. */
QTRI_SMALL_PART void qtri_small_channel_set(qtri_small_ramp *r, const qtri_small_place *p,
                                            int32_t f0, int32_t f1, int32_t f2, int32_t full,
                                            uint32_t half)
{
    qtri_setup_ramp_set_at(r, p, p->x, p->y - 256 * p->first, (uint32_t)(f0 * full * 2) + half,
                           (f1 * full) >> 8, (f2 * full) >> 8, 1);
}

/* Moves a ramp from vertex 0's row to the first, by steps that packing has rounded. */
QTRI_BODY void qtri_small_ramp_to_first_row(qtri_small_ramp *r, const qtri_small_place *p)
{
    r->at += (uint32_t)p->first * r->dy;
}

QTRI_BODY uint32_t qtri_small_signed_shift(uint32_t x, int by)
{
    return (uint32_t)((int32_t)x >> by);
}

/* .299 R + .587 G + .114 B */
QTRI_SMALL_PART int32_t qtri_small_luma(const qtri_small_channels *f)
{
    return (f->r * 9798 + f->g * 19235 + f->b * 3735 + 0x4000) >> 15;
}

/* Channels of 565, n.16, in one word: red, then the others. */
QTRI_BODY void qtri_small_pack_red_565(qtri_small_ramp *c, const qtri_small_ramp *r)
{
    c->at = r->at >> 10 << 21;
    c->dx = (r->dx + 0x200) >> 10 << 21;
    c->dy = (r->dy + 0x200) >> 10 << 21;
}

QTRI_BODY void qtri_small_pack_blue_565(qtri_small_ramp *c, const qtri_small_ramp *b)
{
    c->at += b->at & ~(uint32_t)0x7FF;
    c->dx += (b->dx + 0x400) & ~(uint32_t)0x7FF;
    c->dy += (b->dy + 0x400) & ~(uint32_t)0x7FF;
}

QTRI_BODY void qtri_small_pack_green_565(qtri_small_ramp *c, const qtri_small_ramp *g)
{
    c->at += qtri_small_signed_shift(g->at, 11);
    c->dx += qtri_small_signed_shift(g->dx + 0x400, 11);
    c->dy += qtri_small_signed_shift(g->dy + 0x400, 11);
}

/* Whether vertices are so near that channels of 565, whose steps are off by 1/64 at most, stay in
   their fields. */
QTRI_BODY bool qtri_small_keeps_fields(const qtri_small_place *p)
{
    return !qtri_small_is_far(p->dx1, p->dy1, p->dx2, p->dy2, 14);
}

/* In small_values.c: rounds steps to 2^down, so that a channel of 565, f0 at vertex 0 and f1 and f2
   more at the others, stays in its field. False: it does not. */
bool qtri_small_round_steps(qtri_small_ramp *r, const qtri_small_place *p, int32_t f0, int32_t f1,
                            int32_t f2, int down);

/* A channel of 565 and its steps, rounded where they might leave its field. False: they do. */
QTRI_BODY bool qtri_small_channel_set_565(qtri_small_ramp *r, const qtri_small_place *p, int32_t f0,
                                          int32_t f1, int32_t f2, int32_t full, int down,
                                          bool keeps_field)
{
    qtri_small_channel_set(r, p, f0, f1, f2, full, 0x8000u);
    return keeps_field || qtri_small_round_steps(r, p, f0, f1, f2, down);
}

QTRI_BODY bool qtri_setup_set_colors_565(qtri_small_ramp *c, const qtri_small_place *p,
                                         const qtri_small *t, const qtri_options *o,
                                         bool keeps_fields)
{
    qtri_small_colors f;
    qtri_small_ramp g;
    if (!qtri_small_colors_find(&f, p, t, o) ||
        !qtri_small_channel_set_565(&g, p, f.at.r, f.d1.r, f.d2.r, 31, 10, keeps_fields)) {
        return false;
    }
    qtri_small_pack_red_565(c, &g);
    if (!qtri_small_channel_set_565(&g, p, f.at.b, f.d1.b, f.d2.b, 31, 11, keeps_fields)) {
        return false;
    }
    qtri_small_pack_blue_565(c, &g);
    if (!qtri_small_channel_set_565(&g, p, f.at.g, f.d1.g, f.d2.g, 63, 11, keeps_fields)) {
        return false;
    }
    qtri_small_pack_green_565(c, &g);
    qtri_small_ramp_to_first_row(c, p);
    return true;
}

/* Texture coordinates -------------------------------------------------------------------------- */

/* Coordinates at the vertices, Q16 of a repeat: at the first one, and what the others have more. */
typedef struct qtri_small_uv {
    int32_t u[3], v[3];
} qtri_small_uv;

QTRI_SMALL_PART void qtri_small_uv_find(qtri_small_uv *uv, const qtri_small *t)
{
    const qtri_mesh *mesh = t->mesh;
    if (mesh->uvs16 != NULL) {
        const qtri_uv16 *a = &mesh->uvs16[t->index[0]];
        const qtri_uv16 *b = &mesh->uvs16[t->index[1]];
        const qtri_uv16 *c = &mesh->uvs16[t->index[2]];
        uv->u[0] = a->x * 4;
        uv->v[0] = a->y * 4;
        uv->u[1] = (b->x - a->x) * 4;
        uv->v[1] = (b->y - a->y) * 4;
        uv->u[2] = (c->x - a->x) * 4;
        uv->v[2] = (c->y - a->y) * 4;
    } else {
        const qtri_vec2 *a = &mesh->uvs[t->index[0]];
        const qtri_vec2 *b = &mesh->uvs[t->index[1]];
        const qtri_vec2 *c = &mesh->uvs[t->index[2]];
        uv->u[0] = a->x;
        uv->v[0] = a->y;
        uv->u[1] = (int32_t)((uint32_t)b->x - (uint32_t)a->x);
        uv->v[1] = (int32_t)((uint32_t)b->y - (uint32_t)a->y);
        uv->u[2] = (int32_t)((uint32_t)c->x - (uint32_t)a->x);
        uv->v[2] = (int32_t)((uint32_t)c->y - (uint32_t)a->y);
    }
}

/* Whether perspective of coordinates could be seen: see small_texture.c. */
QTRI_BODY bool qtri_small_is_texture_curved(const qtri_small_uv *f, const qtri_small_place *p,
                                            const qtri_small *t, const qtri_options *o)
{
    const uint32_t width_log2 = qtri_texture_width_log2(o, t->state);
    const uint32_t height_log2 = qtri_texture_height_log2(o, t->state);
    const uint32_t u = qtri_small_range(f->u[1], f->u[2]) >> (10 - width_log2);
    const uint32_t v = qtri_small_range(f->v[1], f->v[2]) >> (10 - height_log2);
    const uint32_t range = u > v ? u : v;                          /* 2^-6 of a texel */
    const uint32_t q_range = qtri_small_range(p->q1, p->q2) >> 16; /* < 2^14.6 */
    const uint32_t q_min = (t->v[0]->inv_w + (uint32_t)qtri_small_min0(p->q1, p->q2)) >> 16;
    return range >> 17 != 0 || (range + 1) * (q_range + 1) > q_min << (8 - QTRI_SMALL_TEXEL_LOG2);
}

/*
 * Whether coordinates are linear on the screen. The bound of small_texture.c is tried by sums of
 * magnitudes first, in 2^-6 texel of the longer side, and q_min >= 3/4 2^30: true of most. False:
 * they may be seen to follow perspective, or are not as simple.
 */
QTRI_BODY bool qtri_small_is_linear_texture(const qtri_small_uv *f, const qtri_small_place *p,
                                            const qtri_small *t, const qtri_options *o)
{
    const uint32_t width_log2 = qtri_texture_width_log2(o, t->state);
    const uint32_t height_log2 = qtri_texture_height_log2(o, t->state);
    const uint32_t u1 = qtri_small_abs(f->u[1]), u2 = qtri_small_abs(f->u[2]);
    const uint32_t v1 = qtri_small_abs(f->v[1]), v2 = qtri_small_abs(f->v[2]);
    if ((u1 | u2 | v1 | v2) >> (p->wide ? 15 : 16) != 0) {
        return false;
    }
    if (!t->state->is_linear) {
        const uint32_t side_log2 = width_log2 > height_log2 ? width_log2 : height_log2;
        const uint32_t most = ((u1 + u2 + v1 + v2 + 4) >> (10 - side_log2)) + 1; /* < 2^18.1 */
        const uint32_t greatest = (uint32_t)3 << (10 + 8 - QTRI_SMALL_TEXEL_LOG2);
        if (most * ((p->q_abs >> 17) + 1) > greatest) {
            QTRI_RARELY();
            return !qtri_small_is_texture_curved(f, p, t, o);
        }
    }
    return true;
}

/* Finds coordinates of a plain texture, nearest and repeating. False: not plain, or not linear. */
QTRI_BODY bool qtri_small_find_linear_texture(qtri_small_uv *f, const qtri_small_place *p,
                                              const qtri_small *t, const qtri_options *o)
{
    if (o->bilinear || o->large_texture || t->state->traits != 0) {
        return false;
    }
    qtri_small_uv_find(f, t);
    return qtri_small_is_linear_texture(f, p, t, o);
}

/* The walk's u and v at vertex 0, plus 2^-11 texel: what lies on a texel's edge goes up. */
QTRI_BODY uint32_t qtri_small_linear_u(const qtri_small_uv *f, uint32_t width_log2)
{
    return ((uint32_t)f->u[0] << 16) + ((uint32_t)1 << (21 - width_log2));
}

QTRI_BODY uint32_t qtri_small_linear_v(const qtri_small_uv *f, uint32_t width_log2,
                                       uint32_t height_log2)
{
    return ((uint32_t)f->v[0] << (width_log2 + height_log2)) + ((uint32_t)1 << (5 + width_log2));
}

QTRI_BODY void qtri_small_set_linear(qtri_small_ramp *u, qtri_small_ramp *v,
                                     const qtri_small_place *p, const qtri_small_uv *f,
                                     uint32_t width_log2, uint32_t height_log2)
{
    qtri_small_ramp_set(u, p, qtri_small_linear_u(f, width_log2), f->u[1], f->u[2], 8);
    qtri_small_ramp_set(v, p, qtri_small_linear_v(f, width_log2, height_log2), f->v[1], f->v[2],
                        (int32_t)(width_log2 + height_log2) - 8);
}

/* False: nothing was set. */
QTRI_BODY bool qtri_setup_set_linear_texture(qtri_small_ramp *u, qtri_small_ramp *v,
                                             const qtri_small_place *p, const qtri_small *t,
                                             const qtri_options *o)
{
    qtri_small_uv f;
    if (!qtri_small_find_linear_texture(&f, p, t, o)) {
        return false;
    }
    qtri_small_set_linear(u, v, p, &f, qtri_texture_width_log2(o, t->state),
                          qtri_texture_height_log2(o, t->state));
    return true;
}

#ifdef __cplusplus
}
#endif

#endif
