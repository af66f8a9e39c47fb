/* SPDX-License-Identifier: MIT */
#include "stroke_wire.h"

#include "../bits/multiply.h"
#include "../filter/mix.h"
#include "../frame/colors.h"
#include "../frame/depth_format.h"
#include "../frame/mix.h"
#include "../frame/pixel.h"
#include "effect.h"

/* Colour words of a line in colours of its own. */
static void color_words(uint32_t *word, const qtri_wire *w, const qtri_wire_pixels *p)
{
    const qtri_colors *colors = w->job->surface->format->colors;
    const qtri_channels from = qtri_channels_from_color(colors, *w->from);
    const qtri_channels to = qtri_channels_from_color(colors, *w->to);
    for (int32_t i = 0; i < p->count; i++) {
        int32_t c[3];
        for (int k = 0; k < 3; k++) { /* 2^16 steps of 1/256 by 2^14 */
            c[k] = from.c[k] + (((to.c[k] - from.c[k]) >> 8) * qtri_wire_share_of(p->word[i]) >> 6);
        }
        word[i] = colors->pack(c);
    }
}

/* Of RGB565, by a share of 10 bits, in which covers are cut off to a multiple of 1/1024. */
static inline uint32_t mix_565(uint32_t over, uint32_t under, uint32_t k)
{
    return qtri_lerp_565(under, over, (k + 16) >> 5);
}

static inline uint32_t mix_channel(uint32_t over, uint32_t under, uint32_t k, uint32_t most)
{
    (void)most;
    return qtri_mix_over(over, under, k);
}

/* The colour of a pixel as 0x00RRGGBB. */
static uint32_t color_888(const qtri_wire *w, int32_t share)
{
    int32_t c[3];
    if (w->from != NULL) {
        for (int k = 0; k < 3; k++) { /* 2^16 steps of 1/256 by 2^14 */
            c[k] = (*w->from)[k] + ((((*w->to)[k] - (*w->from)[k]) >> 8) * share >> 6);
        }
    } else {
        const qtri_rgb *tint = &w->job->material->color;
        const int32_t light_q15 = (w->light_q29 + w->light_step * share) >> 14;
        c[0] = tint->r * light_q15 * 2; /* <= 255.0 */
        c[1] = tint->g * light_q15 * 2;
        c[2] = tint->b * light_q15 * 2;
    }
    return qtri_pack_888(c);
}

uint32_t qtri_wire_fine_depth(const qtri_wire *w, int32_t share)
{
    const int64_t more = qtri_mul_s32(w->z_delta, share) >> (QTRI_WIRE_SHARE_BITS - 8);
    return (((uint32_t)w->z_16p8 << 8) + (uint32_t)more) & ~1u;
}

/* So many at a time, to take less stack. */
enum { AFFECTED = 6 };

/* Of the pixels of one line those from the first on, with fog and a blend. */
QTRI_NOINLINE static void store_some(const qtri_wire *w, const qtri_wire_pixels *p, int32_t first,
                                     int32_t count)
{
    const qtri_line_job *job = w->job;
    uint32_t color[AFFECTED + QTRI_BATCH_ROOM - QTRI_BATCH];
    uint32_t place[AFFECTED];
    uint32_t depth[AFFECTED];
    int32_t share_q16[AFFECTED];
    qtri_covered covered = {count, color, place, depth, share_q16};
    for (int32_t i = 0; i < count; i++) {
        const uint32_t word = p->word[first + i];
        color[i] = color_888(w, qtri_wire_share_of(word));
        place[i] = p->place[first + i];
        depth[i] = job->testing != NULL
                       ? qtri_wire_fine_depth(w, qtri_wire_share_of(word)) + 0x8000u
                       : (uint32_t)(w->z_16p14 + w->z_step * qtri_wire_share_of(word)) << 2;
        depth[i] |= word >> QTRI_WIRE_LATE_BIT & 1;
        share_q16[i] = (int32_t)(word >> QTRI_WIRE_COVER_AT << 6);
    }
    qtri_effect_stages_of(job->material)->covered(job->surface, job->material, &covered);
}

/* Stores pixels of one line, of any format. No pixel is there twice. */
QTRI_NOINLINE static void store_plain(const qtri_wire *w, qtri_wire_pixels *p)
{
    const qtri_surface *surface = w->job->surface;
    const qtri_format *format = surface->format;
    const qtri_pixels *memory = format->pixels;
    uint32_t word[QTRI_BATCH_ROOM] = {0};
    uint32_t under[QTRI_BATCH];
    const int32_t count = p->count;
    if (count == 0) {
        return;
    }
    if (w->from != NULL) {
        color_words(word, w, p);
    } else {
        for (int32_t i = 0; i < count; i++) {
            word[i] =
                (uint32_t)(w->light_q29 + w->light_step * qtri_wire_share_of(p->word[i])) >> 7;
        }
        qtri_line_tint(word, w->job, count);
    }
    for (int32_t i = 0; i < count; i++) {
        const uint32_t place = p->place[i];
        under[i] = qtri_color_of(format, memory->load(surface->pixels +
                                                      (ptrdiff_t)(place >> 16) * surface->pitch +
                                                      (ptrdiff_t)(place & 0xFFFF) * memory->bytes));
    }
    if (format->colors == &qtri_colors_565) {
        for (int32_t i = 0; i < count; i++) {
            word[i] = mix_565(word[i], under[i], p->word[i] >> QTRI_WIRE_COVER_AT);
        }
    } else {
        QTRI_MIX(word, under[i], count, format->colors, p->word[i] >> QTRI_WIRE_COVER_AT,
                 mix_channel)
    }
    if (format->encode != NULL) {
        format->encode(word, count);
    }
    memory->scatter(surface->pixels, surface->pitch, p->place, word, count);
    p->count = 0;
}

void qtri_wire_store(const qtri_wire *w, qtri_wire_pixels *p)
{
    if (qtri_effect_stages_of(w->job->material) == NULL) {
        store_plain(w, p);
        return;
    }
    for (int32_t first = 0; first < p->count; first += AFFECTED) {
        store_some(w, p, first, qtri_least32(p->count - first, AFFECTED));
    }
    p->count = 0;
}
