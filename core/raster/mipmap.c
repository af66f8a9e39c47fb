/* SPDX-License-Identifier: MIT */
#include "mipmap.h"

#include <string.h>

#include "list_values.h"
#include "texel_copy.h"
#include "texel_format.h"

void qtri_axis_move(qtri_texel_axis *axis, int32_t down)
{
    const uint32_t by = (uint32_t)(down < 0 ? -down : down);
    axis->texel_shift = (uint8_t)(axis->texel_shift + down);
    axis->side_log2 = (uint8_t)(axis->side_log2 - down);
    axis->mask = (uint16_t)((1u << axis->side_log2) - 1);
    if (down < 0) {
        axis->first *= (int32_t)1 << by;
    } else {
        axis->first >>= by; /* without a rest: sides are powers of two */
    }
}

/* The axes of the triangle whose rows are drawn. */
static void move_axes(const qtri_levels *levels, int32_t along, int32_t across)
{
    const bool fills = levels->raster->texel_cut != 0;
    if (!fills || levels->axis[0].clamped) {
        qtri_axis_move(&levels->axis[0], along);
    }
    if (!fills || levels->axis[1].clamped) {
        qtri_axis_move(&levels->axis[1], across);
    }
}

void qtri_level_change(qtri_levels *levels, uint32_t level)
{
    const qtri_texture *whole = levels->whole;
    qtri_texture *texture = &levels->texture;
    qtri_raster *raster = levels->raster;
    const uint32_t width_log2 = qtri_side_log2(whole->width_log2);
    const uint32_t height_log2 = qtri_side_log2(whole->height_log2);
    const uint32_t down = level < height_log2 ? level : height_log2;
    if (levels->axis != NULL) {
        move_axes(levels, (int32_t)level - levels->down[0], (int32_t)down - levels->down[1]);
    }
    levels->level = (uint8_t)level;
    levels->down[0] = (uint8_t)level;
    levels->down[1] = (uint8_t)down;
    texture->texels = level == 0 ? whole->texels : whole->levels[level - 1];
    texture->width_log2 = (uint8_t)(width_log2 - level);
    texture->height_log2 = (uint8_t)(height_log2 - down);
    if (raster->texel_cut != 0) {
        raster->texel_cut = qtri_texel_cut(texture);
    }
    qtri_textured_set_coordinates(raster);
}

/* Small triangles ------------------------------------------------------------------------------ */

/* x 2^up, rounded down. */
static inline int32_t shifted(int32_t x, int32_t up)
{
    return up >= 0 ? x * ((int32_t)1 << up) : x >> qtri_least32(-up, 31);
}

/*
 * The footprint at vertex 0. With the names of list_values.h what u gains from there is l / (1 + e)
 * with l = 0, so its steps are those of l: n / size, where n are the numerators of place_ramp.h,
 * times 256 a pixel. Differences have 15 bits of the greatest, in 2^-fraction of a texel: n is
 * below 2^29.5, and its length below 2^30.
 *
 * A level is left behind where length 2^(8 - fraction) / size is 2^(level + 1/2) or more; 1 + 1/4 +
 * 1/8 + 1/32 + 1/128 stands in for 2^(1/2), .00011 of it less.
 */
static uint32_t small_level(qtri_list_values *v, const qtri_levels *levels)
{
    const qtri_place *p = v->t->place;
    const uint8_t side_log2[2] = {qtri_side_log2(levels->whole->width_log2),
                                  qtri_side_log2(levels->whole->height_log2)};
    int32_t d[2][2];
    int32_t up[2]; /* to 15 bits; then of what a texel has of them */
    int32_t fraction = INT32_MAX;
    qtri_list_find_e(v);
    for (int i = 0; i < 2; i++) {
        const qtri_coordinates *c = &v->t->uv[i];
        d[i][0] = c->at[v->second] - c->at[0];
        d[i][1] = c->at[v->third] - c->at[0];
        up[i] = c->fraction - side_log2[i];
        const int32_t zeros = qtri_clz32(qtri_about(d[i][0]) | qtri_about(d[i][1]));
        fraction = qtri_least32(fraction, zeros - 17 + up[i]);
    }
    uint32_t right[2];
    uint32_t down[2];
    for (int i = 0; i < 2; i++) {
        const int32_t f1 = qtri_list_scaled(shifted(d[i][0], fraction - up[i]), v->e1_q18);
        const int32_t f2 = qtri_list_scaled(shifted(d[i][1], fraction - up[i]), v->e2_q18);
        right[i] = qtri_magnitude32(qtri_place_nx(p, f1, f2));
        down[i] = qtri_magnitude32(qtri_place_ny(p, f1, f2));
    }
    const uint32_t across = qtri_step_length(right[0], right[1]);
    const uint32_t along = qtri_step_length(down[0], down[1]);
    const uint32_t length = across > along ? across : along;
    const uint32_t size = p->size; /* < 2^28 */
    const uint32_t limit = size + (size >> 2) + (size >> 3) + (size >> 5) + (size >> 7);
    uint32_t level = 0;
    while (level < levels->last) {
        const int32_t shift = (int32_t)level + fraction - 8;
        if (shift >= 0 ? length >> qtri_least32(shift, 31) < limit
                       : length <= (limit - 1) >> qtri_least32(-shift, 31)) {
            break;
        }
        level++;
    }
    return level;
}

void qtri_mipmap_set_list(qtri_list_values *v)
{
    qtri_levels *levels = qtri_levels_of(v->raster);
    qtri_levels_vary(levels, false);
    qtri_level_set(levels, small_level(v, levels));
    qtri_list_set_texels(v);
}

/*
 * Fragments of other triangles that wait are of another level: they are drawn first, and those of
 * this one, which have only their places as yet, begin the batch anew.
 */
uint32_t qtri_mipmap_color_list(const qtri_list_values *v, uint32_t *color, uint32_t *shade,
                                const uint32_t *place, int32_t count)
{
    qtri_batch *batch = v->raster->batch;
    qtri_levels *levels = qtri_levels_of(v->raster);
    if (levels->waiting != levels->level) {
        const int32_t first = (int32_t)(place - batch->place);
        if (first != 0) {
            batch->count = (uint8_t)first;
            qtri_list_flush(v->raster);
            memmove(batch->place, place,
                    (size_t)(count + 1) * sizeof batch->place[0]); /* its end */
            batch->count = (uint8_t)count;
            color = batch->color;
            shade = batch->by.shade;
            place = batch->place;
        }
        levels->waiting = levels->level;
    }
    return qtri_list_texels(v, color, shade, place, count);
}

uint32_t qtri_mipmap_finish_list(const qtri_raster *raster, int32_t count, uint32_t mask)
{
    qtri_levels *levels = qtri_levels_of(raster);
    const uint32_t level = levels->level;
    qtri_level_set(levels, levels->waiting);
    mask = qtri_list_finish_texels(raster, count, mask);
    qtri_level_set(levels, level);
    return mask;
}
