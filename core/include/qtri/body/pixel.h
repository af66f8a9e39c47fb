/* SPDX-License-Identifier: MIT */
/*
 * A pixel: tests, texture, light, fog, blend, store, in one function. Internal, part of the
 * pipelines' body (pipeline_make.h).
 *
 * `o` is constant in a pipeline, and the compiler leaves out what it does not ask for; the generic
 * pipeline reads it for every pixel. All sums wrap, so both draw the same bits.
 */
#ifndef QTRI_BODY_PIXEL_H
#define QTRI_BODY_PIXEL_H

#include "samples.h"
#include "texel.h"

/* Colour --------------------------------------------------------------------------------------- */

/* The colour in c and g, without texture. Packed 565: red << 27, blue << 16, green << 5. */
QTRI_BODY uint32_t qtri_smooth_color(const qtri_options *o, const qtri_pixel_walk *w)
{
    switch (qtri_kind_of(o)) {
    case QTRI_IN_565: {
        const uint32_t c = w->c & 0xF81F07E0u;
        return (c | c >> 16) & 0xFFFFu;
    }
    case QTRI_IN_GRAY:
        return w->c >> 16;
    default: /* a mask where green is taken out again: shifts cost fog 3 %, a mask others 3 to 5 */
        return (w->c >> 8 & QTRI_BODY_LANES_888) |
               (o->fog || qtri_reads_pixel(o) ? w->g >> 8 & 0xFF00u
                                              : qtri_body_bits(w->g, 16, 8) << 8);
    }
}

/* Half of the unit that pixels cut c of the walk to: added to its start, so that cutting rounds. */
QTRI_BODY uint32_t qtri_light_half(const qtri_options *o)
{
    if (!qtri_is_textured(o)) {
        return qtri_uses_table(o) ? (uint32_t)1 << (23 - QTRI_TABLE_LOG2) : 0x8000u;
    }
    return qtri_kind_of(o) == QTRI_IN_565 ? (uint32_t)1 << 17 : 0x8000u;
}

/* A texel times light, the vertices' colours or that of the triangle. */
QTRI_BODY uint32_t qtri_shaded_texel(const qtri_options *o, const qtri_pixel_walk *w,
                                     uint32_t texel)
{
    const qtri_color_kind kind = qtri_kind_of(o);
    switch (o->shade) {
    case QTRI_TINT: { /* of the triangle: 8 bits a channel */
        const uint32_t less = kind == QTRI_IN_565 ? 2 : 0;
        const uint32_t r = (w->color >> 16 & 255) + (w->color >> 23 & 1);
        const uint32_t g = (w->color >> 8 & 255) + (w->color >> 15 & 1);
        const uint32_t b = (w->color & 255) + (w->color >> 7 & 1);
        return qtri_color_modulate(kind, texel, (r + less) >> less, (g + less) >> less,
                                   (b + less) >> less);
    }
    case QTRI_WHITE_LIGHT:
        return qtri_color_modulate_intensity(kind, texel, w->c >> (kind == QTRI_IN_565 ? 18 : 16));
    case QTRI_LIGHT: { /* rounded once; with weights of 256 QTRI_WHITE_LIGHT to the bit */
        const uint32_t down = kind == QTRI_IN_565 ? 14 : 16;
        const uint32_t light = w->c >> (32 - down); /* 64 or 256 is 1 */
        const uint32_t half = w->half;
        if (kind == QTRI_IN_565) {
            /* One after the other, or GCC runs out of registers. Of red, and of green << 16: 2^14
               at most, each. */
            uint32_t by = light * w->red;
            uint32_t color = qtri_add_product16(half, qtri_green_565(texel), by >> 16) >> down;
            QTRI_BODY_BARRIER(color);
            color |= qtri_add_product16(half, texel >> 11, qtri_low16(by)) >> down << 6;
            by = light * w->blue;
            return color << 5 | ((texel & 31) * by + half) >> down;
        }
        return ((texel >> 16 & 255) * (light * w->red) + half) >> down << 16 |
               (qtri_green_888(texel) * (light * w->green) + half) >> down << 8 |
               ((texel & 255) * (light * w->blue) + half) >> down;
    }
    case QTRI_COLORS:
        return kind == QTRI_IN_565
                   ? qtri_color_modulate(kind, texel, w->c >> 25, w->g >> 18, w->c << 16 >> 25)
                   : qtri_color_modulate(kind, texel, w->c >> 23, w->g >> 16, w->c << 16 >> 23);
    default:
        return texel;
    }
}

/* The colour of a pixel, in qtri_kind_of(o), before fog and blend. */
QTRI_BODY uint32_t qtri_pixel_color(const qtri_options *o, const qtri_pixel_walk *w, uint32_t texel)
{
    if (qtri_is_textured(o)) {
        return qtri_shaded_texel(o, w, texel);
    }
    if (o->shade == QTRI_COLORS) {
        return qtri_smooth_color(o, w);
    }
    if (qtri_is_lit(o)) {
        // NOLINTNEXTLINE(clang-analyzer-core.NullDereference): qtri_walk_begin() set it
        return qtri_uses_table(o) ? w->table[w->c >> (24 - QTRI_TABLE_LOG2)]
                                  : qtri_color_scale(qtri_kind_of(o), w->color, w->c >> 16);
    }
    return w->color;
}

/* Alpha of a pixel: 256 is 1. */
QTRI_BODY uint32_t qtri_pixel_alpha(const qtri_options *o, const qtri_pixel_walk *w, uint32_t texel)
{
    uint32_t alpha = w->opacity;
    if (qtri_has_alpha(o)) {
        alpha = (alpha * ((texel >> 24) + (texel >> 31)) + 128) >> 8;
    }
    if (o->vertex_alpha) {
        alpha = (alpha * (w->alpha >> 16) + 128) >> 8;
    }
    return alpha;
}

/* `color` blended with `stored`, a decoded pixel. */
QTRI_BODY uint32_t qtri_blended(const qtri_options *o, const qtri_pixel_walk *w, uint32_t color,
                                uint32_t texel, uint32_t stored)
{
    const qtri_color_kind kind = qtri_kind_of(o);
    switch (o->blend) {
    case QTRI_ALPHA: {
        const uint32_t alpha = qtri_pixel_alpha(o, w, texel);
        return kind == QTRI_IN_FINE_565 && !o->covered ? qtri_color_fade_fine(color, alpha, stored)
                                                       : qtri_color_mix(kind, color, alpha, stored);
    }
    case QTRI_ADD:
        return qtri_color_add(kind, stored, color, qtri_pixel_alpha(o, w, texel));
    case QTRI_MULTIPLY:
        return qtri_color_product(kind, color, stored);
    default:
        return color;
    }
}

/* Whether a pixel's alpha, 256 being 1, is above its threshold in Bayer's matrix: 16 steps + 8. */
QTRI_BODY_PART bool qtri_passes_screen_door(const qtri_options *o, const qtri_pixel_walk *w,
                                            uint32_t texel)
{
    static const uint8_t step[16] = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
    return qtri_pixel_alpha(o, w, texel) > 16u * step[(w->y & 3) * 4 + (w->x & 3)] + 8;
}

/* The texel at the walk's coordinates; *drawn becomes false where it is discarded. */
QTRI_BODY uint32_t qtri_texel_at(const qtri_options *o, const qtri_pixel_walk *w, bool *drawn)
{
    uint32_t texel;
    if (o->bilinear) {
#ifdef QTRI_PIPELINE_IS_ANY_BY_ASKS /* which programs without a filter link, too */
        texel = w->state->between(w, drawn);
#else
        texel = qtri_texel_bilinear(o, w, drawn);
#endif
    } else {
        const uint32_t number = qtri_texel_column(w, w->u) + qtri_texel_row(o, w, w->v);
        const uint32_t stored = qtri_texel_stored(o, w, number);
        if (o->key) {
            const uint32_t mask = o->texel == QTRI_TEXEL_XRGB8888 ? 0xFFFFFFu
                                  : o->texel == QTRI_OTHER_TEXEL  ? w->state->key_mask
                                                                  : UINT32_MAX;
            *drawn = (stored & mask) != w->state->key;
        }
        texel = qtri_texel_color(o, w, stored);
    }
    if (o->alpha_test && texel < w->state->alpha_least) {
        *drawn = false;
    }
    return texel;
}

/* Pixel and loop ------------------------------------------------------------------------------- */

/* The most pixels a loop is unrolled to: 1 in a single-file library and the generic pipeline. */
#if defined(QTRI_PIPELINE_IS_ANY) || defined(QTRI_AMALGAMATION)
#define QTRI_BODY_UNROLLS 1
#elif defined(__OPTIMIZE_SIZE__)
#define QTRI_BODY_UNROLLS 2
#else
#define QTRI_BODY_UNROLLS 8
#endif

/* Whether a pixel is so little work that unrolling its loop pays. */
QTRI_BODY bool qtri_is_short(const qtri_options *o)
{
#if defined(QTRI_PIPELINE_IS_ANY)
    (void)o;
    return false;
#else
    return !(o->bilinear || (qtri_is_textured(o) && qtri_varies(o)) || o->fog ||
             qtri_reads_pixel(o) || qtri_needs_place(o) || o->alpha_test);
#endif
}

/* How many pixels a loop is unrolled to: short ones, where rows are not short as well, and where
   there are registers: on Armv6-M texels that become RGB565 leave none. */
QTRI_BODY int qtri_unrolled(const qtri_options *o, bool bent)
{
    const bool has_few = !QTRI_LONG_MULTIPLY && qtri_is_textured(o);
    const int most = bent || has_few ? 4 : 8;
    if (!qtri_is_short(o) || (QTRI_BODY_UNROLLS == 2 && (bent || o->shade == QTRI_TINT)) ||
        (has_few && qtri_stores_565(o) && qtri_kind_of(o) != QTRI_IN_565)) {
        return 1;
    }
    return most < QTRI_BODY_UNROLLS ? most : QTRI_BODY_UNROLLS;
}

/* Calls the material's fragment function, which may change *color; false: it discards the pixel. */
QTRI_BODY_PART bool qtri_pixel_run_fragment(const qtri_options *o, const qtri_pixel_walk *w,
                                            uint32_t *color)
{
    qtri_fragment f;
    f.x = w->x;
    f.y = w->y;
    f.depth_16p16 = qtri_has_samples(o)        ? w->z + w->z_place
                    : o->depth == QTRI_FLOAT16 ? w->z + w->octave.zero
                                               : w->z;
    f.u = w->u;
    f.v = o->large_texture || !qtri_is_textured(o)
              ? w->v
              : w->v << (16u - w->width_log2 - qtri_texture_height_log2(o, w->state));
    f.light_q8 = qtri_is_lit(o) ? w->c >> 16 : 256;
    f.color = *color & 0xFFFFFFu;
    // NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage): callers look at it
    if (!o->fragment(&f)) {
        return false;
    }
    *color = (*color & 0xFF000000u) | (f.color & 0xFFFFFFu);
    return true;
}

/* A colour, blended with the stored pixel `under`, by channel mask and a stroke's coverage. */
QTRI_BODY uint32_t qtri_pixel_composite(const qtri_options *o, const qtri_pixel_walk *w,
                                        uint32_t color, uint32_t texel, uint32_t under)
{
    const qtri_surface *surface = w->state->surface;
    const uint32_t stored = qtri_decode(o, surface, under);
    color = qtri_blended(o, w, color, texel, stored);
    if (o->keep) {
        color = (color & ~w->state->keep) | (stored & w->state->keep);
    }
    if (o->covered) {
        color = qtri_kind_of(o) == QTRI_IN_FINE_565
                    ? qtri_color_fade_fine(color, w->cover, stored)
                    : qtri_color_fade(qtri_kind_of(o), color, w->cover, stored);
    }
    return color;
}

/* Stores a colour in samples of a pixel; blends once for neighbours that have equal colours. */
QTRI_BODY void qtri_pixel_put_samples(const qtri_options *o, const qtri_pixel_walk *w,
                                      uint32_t samples, uint32_t color, uint32_t texel,
                                      uint8_t *pixel)
{
    const qtri_surface *surface = w->state->surface;
    const uint32_t bytes = qtri_pixel_bytes(o);
    uint32_t under = 0, stored = 0;
    bool is_known = false;
    if (o->blend == QTRI_KEEP_PIXEL) {
        return;
    }
    if (!qtri_reads_pixel(o)) {
        stored = qtri_has_constant_color(o) ? color : qtri_encode(o, surface, color);
        qtri_pixel_store_samples(bytes, pixel, samples, stored);
        return;
    }
    for (; samples != 0; samples >>= 8, pixel += bytes) {
        if ((samples & QTRI_SAMPLE_0) == 0) {
            continue;
        }
        const uint32_t there = qtri_load(bytes, pixel);
        if (!is_known || there != under) {
            under = there;
            is_known = true;
            stored = qtri_encode(o, surface, qtri_pixel_composite(o, w, color, texel, there));
        }
        qtri_save(bytes, pixel, stored);
    }
}

/* Draws the walk's pixel, and steps. `bent`: u_step and v_step grow by u_bend and v_bend. */
QTRI_BODY_PIXEL void qtri_pixel_at(const qtri_options *o, qtri_pixel_walk *w, bool bent,
                                   uint8_t *pixel, uint8_t *depth)
{
    const qtri_surface *surface = w->state->surface;
    const uint32_t bytes = qtri_pixel_bytes(o), depth_bytes = qtri_depth_size(o, surface);
    const bool has_barriers = QTRI_BODY_IS_SMALL || qtri_unrolled(o, bent) > 1;
    bool drawn = true;
    uint32_t z = 0, texel = 0, color = 0, samples = 0;
    if (qtri_has_samples(o)) {
        samples = qtri_samples_test(o, w, pixel, depth);
        drawn = samples != 0;
    } else if (qtri_tests_depth(o)) {
        z = o->depth == QTRI_FLOAT16 && w->octave.down != 0
                ? w->octave.base + (w->z >> w->octave.down)
                : qtri_depth_encode(o, surface, w->z);
        drawn = qtri_depth_passes(o, w, z, qtri_load(depth_bytes, depth));
    }
    const bool early = qtri_is_textured(o) && !qtri_discards(o);
    if (drawn && qtri_pixel_writes(o, w) && early && !qtri_has_samples(o)) {
        QTRI_BODY_BRANCH(); /* now: it need not be kept in a register */
        qtri_save(depth_bytes, depth, z);
    }
    if (drawn && qtri_is_textured(o)) {
        texel = qtri_texel_at(o, w, &drawn);
    }
    if (drawn && o->blend == QTRI_SCREEN_DOOR) {
        drawn = qtri_passes_screen_door(QTRI_PART_OPTIONS(o, w), w, texel);
    }
    if (drawn) {
        QTRI_BODY_BRANCH();
        if (o->blend != QTRI_KEEP_PIXEL || o->fragment != NULL) {
            color = qtri_pixel_color(o, w, texel);
        }
        if (o->fragment != NULL) {
            drawn = qtri_pixel_run_fragment(QTRI_PART_OPTIONS(o, w), w, &color);
        }
    }
    if (drawn) {
        if (o->fog) {
            const uint32_t clear = w->fog >> 16;
            color = qtri_kind_of(o) == QTRI_IN_FINE_565 && !qtri_reads_pixel(o)
                        ? qtri_color_fade_fine(color, clear, w->fog_color)
                        : qtri_color_fade(qtri_kind_of(o), color, clear, w->fog_color);
        }
        if (qtri_has_samples(o)) {
            qtri_samples_write_late(o, w, samples, pixel, depth);
            qtri_pixel_put_samples(o, w, samples, color, texel, pixel);
        } else {
            if (qtri_reads_pixel(o)) {
                color = qtri_pixel_composite(o, w, color, texel, qtri_load(bytes, pixel));
            }
            if (qtri_pixel_writes(o, w) && !early && (!o->covered || w->cover_writes)) {
                if (QTRI_BODY_IS_SMALL && o->depth == QTRI_LINEAR16 &&
                    (qtri_is_lit(o) || o->fog || qtri_reads_pixel(o))) {
                    /* a shift, where registers are few */
                    QTRI_BODY_BARRIER(w->z);
                    z = qtri_depth_encode(o, surface, w->z);
                }
                qtri_save(depth_bytes, depth, z);
            }
            if (o->blend != QTRI_KEEP_PIXEL) {
                qtri_save(bytes, pixel,
                          qtri_has_constant_color(o) ? color : qtri_encode(o, surface, color));
            }
        }
    }
    if (qtri_needs_depth(o)) {
        w->z += w->z_step;
        if (has_barriers) {
            QTRI_BODY_BARRIER(w->z);
        }
    }
    if (qtri_is_textured(o)) {
        w->u += w->u_step;
        w->v += w->v_step;
        if (has_barriers) {
            QTRI_BODY_BARRIER(w->u);
            QTRI_BODY_BARRIER(w->v);
        }
        if (qtri_unrolled(o, bent) > 1) {
            QTRI_BODY_HIGH(w->z_step);
            QTRI_BODY_HIGH(w->u_step);
            QTRI_BODY_HIGH(w->v_step);
            if (!bent) { /* or there are not enough of them */
                QTRI_BODY_HIGH(w->texels);
            }
            QTRI_BODY_HIGH(w->rows);
        }
        if (bent) {
            w->u_step += w->u_bend;
            w->v_step += w->v_bend;
            if (has_barriers) {
                QTRI_BODY_HIGH_BARRIER(w->u_step);
                QTRI_BODY_HIGH_BARRIER(w->v_step);
            }
        }
    }
    if (qtri_varies(o)) {
        w->c += w->c_step;
        if (has_barriers) {
            QTRI_BODY_BARRIER(w->c);
        }
        if (qtri_unrolled(o, bent) > 1) {
            QTRI_BODY_HIGH(w->c_step);
            QTRI_BODY_HIGH(w->z_step);
        }
        if (qtri_has_two_words(o)) {
            w->g += w->g_step;
            QTRI_BODY_BARRIER(w->g);
            if (qtri_unrolled(o, bent) > 1) {
                QTRI_BODY_HIGH(w->g_step); /* 8 % of smooth XRGB8888 on a Cortex-M0+ */
            }
        }
    }
    if (o->vertex_alpha) {
        w->alpha += w->alpha_step;
    }
    if (o->fog) {
        w->fog += w->fog_step;
        QTRI_BODY_BARRIER(w->fog);
    }
    if (qtri_needs_place(o)) {
        w->x++;
    }
}

/* Sets the walk's texels, palette and shifts, by the texture or its current mipmap level. */
QTRI_BODY void qtri_walk_set_texture(const qtri_options *o, qtri_pixel_walk *w)
{
    const qtri_draw_state *state = w->state;
    const uint32_t width_log2 = qtri_texture_width_log2(o, state);
    const uint32_t height_log2 = qtri_texture_height_log2(o, state);
    w->texels = o->mipmapped ? state->level_texture.texels : state->texture->texels;
    if (o->texel == QTRI_TEXEL_CHECKER) {
        w->palette = state->texture->color;
    } else if (o->texel == QTRI_TEXEL_PALETTE8 || o->texel == QTRI_TEXEL_PALETTE565) {
        w->palette = state->texture->palette;
    }
    w->width_log2 = width_log2;
    w->v_shift = (o->large_texture ? 32u - height_log2 : 16u + width_log2) & 31;
    /* The mask leaves the low byte to the column's shift: what it lets through of v is cut off. */
    w->rows =
        (o->large_texture ? 0 : (((uint32_t)1 << height_log2) - 1) << ((16 + width_log2) & 31)) |
        ((32u - width_log2) & 31);
}

/* Sets what of the walk all triangles and rows of a draw call share. */
QTRI_BODY void qtri_walk_begin(const qtri_options *o, qtri_pixel_walk *w,
                               const qtri_draw_state *state)
{
    w->state = state;
    w->opacity = state->alpha;
    w->fog_color = state->fog_color;
    if (o->read_only == QTRI_ANY) {
        w->keeps_depth = state->options.read_only;
    }
    if (qtri_compares_by_any(o)) { /* a qtri_compare has such bits; without a test all pass */
        qtri_walk_set_compare(o, w, (state->options.compare - (uint32_t)QTRI_NEVER) & 7);
    }
    if (qtri_is_lit(o) && !qtri_is_textured(o)) {
        w->color = state->color;
        w->table = state->table;
        if (qtri_kind_of(o) == QTRI_IN_GRAY) {
            w->color = qtri_pixel_888_to_luma(state->color);
        } else if (qtri_kind_of(o) == QTRI_IN_FINE_565) {
            w->color = qtri_pixel_888_to_fine(state->color);
        }
    }
    if (qtri_is_textured(o)) {
        qtri_walk_set_texture(o, w);
    }
    if (qtri_is_textured(o) && o->shade == QTRI_LIGHT) {
        const bool is_565 = qtri_kind_of(o) == QTRI_IN_565;
        w->red = state->weight[0] | (is_565 ? state->weight[1] << 16 : 0);
        w->green = state->weight[1];
        w->blue = state->weight[2];
        w->half = is_565 ? 0x2000u : 0x8000u;
        QTRI_BODY_BARRIER(w->half); /* or GCC 12 makes the constant anew for each pixel */
    }
}

/* The colour of a triangle, 0x00RRGGBB, as the walk of these options wants it. */
QTRI_BODY uint32_t qtri_walk_color(const qtri_options *o, const qtri_surface *surface, uint32_t rgb)
{
    if (qtri_is_textured(o)) {
        return rgb;
    }
    const qtri_color_kind kind = qtri_kind_of(o);
    if (kind != QTRI_IN_888) {
        rgb = kind == QTRI_IN_565    ? qtri_pixel_888_to_565(rgb)
              : kind == QTRI_IN_GRAY ? qtri_pixel_888_to_luma(rgb)
                                     : qtri_pixel_888_to_fine(rgb);
    }
    return qtri_has_constant_color(o) ? qtri_encode(o, surface, rgb) : rgb;
}

#endif
