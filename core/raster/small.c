/* SPDX-License-Identifier: MIT */
#include "small.h"

#include "../geometry/projector.h"
#include "linear.h"
#include "list_values.h"
#include "setup.h"
#include "textured.h"

/*
 * Curves along a row. With the names of list_values.h an attribute is u = u_0 + l / (1 + e), where
 * l and e are linear on the screen. At pixel m, with k = 1 / (1 + e),
 *
 *     u = u_0 + l k,   slope L = l_x k - l k e',   e' = e_x k
 *
 * and d pixels from there, perspective.c says why, u + L (d - e' d^2 + ...). A block reaches h
 * pixels to both sides of m; 3/4 E^2 with E = e' h stands in for the cubic term, so that what is
 * left of it is L h E^2 / 4. Blocks have 32 pixels where |e_x| is below 1/768, 16 where it is below
 * 1/248: with k < 1.085 that is 1/420 of L and 1/400 of L. Steeper triangles go another way.
 */
enum { STEEP_32 = (1 << 26) / 768, STEEP_16 = (1 << 26) / 248 };

/* The middle of a block. */
typedef struct middle {
    uint32_t x, y; /* from the base */
    int32_t half;  /* pixels before it: h, 0..16 */
    int32_t w;     /* 1 - k, Q16 */
    int32_t e_q23; /* e' */
    int32_t arc;   /* 3/4 E^2, Q16 */
} middle;

static void set_middle(middle *m, const qtri_list_values *v, uint32_t x, uint32_t y, int32_t half)
{
    m->x = x + (uint32_t)half;
    m->y = y;
    m->half = half;
    m->w = qtri_list_w(&v->e_q26, m->x, m->y);
    m->e_q23 = qtri_list_divided((int32_t)v->e_q26.dx, m->w) >> 3; /* < 2^15.3 */
    const int32_t reach = (m->e_q23 * half) >> 7;                  /* < 2^11.3, Q16 */
    m->arc = (reach * reach) >> 16;
    m->arc -= m->arc >> 2;
}

/*
 * The middle is a pixel of the triangle, so |l| <= 2^24.1, and since the longest row has 12 pixels
 * or more, see rows_are_long, |l_x| is below 2^20.6.
 */
static void set_curve(qtri_curve *out, const middle *m, const qtri_ramp *l, uint32_t base,
                      int32_t up)
{
    const int32_t half = m->half;
    const int32_t value = qtri_list_divided((int32_t)qtri_list_at(l, m->x, m->y), m->w);
    int32_t slope = qtri_list_divided((int32_t)l->dx, m->w) - (((value >> 9) * m->e_q23) >> 14);
    slope += ((slope >> 8) * m->arc) >> 8;
    const int32_t bend = -(((slope >> 5) * m->e_q23) >> 18); /* once: it counts twice */
    out->at = base + ((uint32_t)(value + (half * bend - slope) * half) << up);
    out->step = (uint32_t)(slope + (1 - 2 * half) * bend) << up;
    out->bend = (uint32_t)bend << (up + 1);
    out->twist = 0;
}

static void set_line(qtri_curve *out, const qtri_ramp *ramp, uint32_t x, uint32_t y)
{
    out->at = qtri_list_at(ramp, x, y);
    out->step = ramp->dx;
    out->bend = 0;
    out->twist = 0;
}

/* A qtri_interpolate. */
static int32_t interpolate(qtri_scanline *row, int32_t x, int32_t count, int first, int end,
                           qtri_curve *out)
{
    const qtri_job *job = row->job;
    const qtri_list_values *v = job->values;
    const uint32_t column = (uint32_t)(x - job->anchor_x);
    const uint32_t line = (uint32_t)(row->y - job->anchor_y);
    middle m;
    if (first < QTRI_U && !v->curved) {
        for (int i = first; i < end; i++, out++) {
            set_line(out, &v->channel[i], column, line);
        }
        return count;
    }
    count = qtri_least32(count, qtri_least32(v->block, row->right - x));
    set_middle(&m, v, column, line, count >> 1);
    for (int i = first; i < end; i++, out++) {
        if (i < QTRI_U) {
            set_curve(out, &m, &v->channel[i], v->base[i], 0);
        } else {
            const qtri_list_axis *axis = &v->uv[i - QTRI_U];
            set_curve(out, &m, &axis->l, axis->at, axis->up);
        }
    }
    return count;
}

/*
 * Whether rows have six pixels in the mean: then the longest has twice that, to what is cut off at
 * its ends.
 */
static bool rows_are_long(const qtri_place *p)
{
    const int32_t height = qtri_greatest_from_0(p->dy1, p->dy2) - qtri_least_from_0(p->dy1, p->dy2);
    return p->size >> 10 >= 3 * (uint32_t)height;
}

/* Curves of v, which are asked for. False: they are too steep. */
static bool set_block(qtri_list_values *v)
{
    qtri_list_find_e(v);
    const uint32_t steep = qtri_about((int32_t)v->e_q26.dx);
    v->block = steep < STEEP_32 ? 32 : 16;
    return steep < STEEP_16;
}

/*
 * Colours without texture. Returns what fills rows, NULL where light would have to be curved, of
 * which the tint's channels cannot be made.
 */
static qtri_fill_rows set_colors(qtri_job *job, qtri_list_values *v)
{
    const qtri_raster *raster = job->raster;
    const qtri_list_triangle *t = v->t;
    const bool smooth = QTRI_WITH_SMOOTH && raster->shading == QTRI_SMOOTH;
    if (smooth && t->color == NULL && t->light_q15 == QTRI_VERTEX_UNLIT) {
        qtri_list_set_light(v, 16);
        if (v->curved) {
            return NULL;
        }
        job->first = raster->units->single ? QTRI_U - 1 : 0;
        qtri_job_tint(job, &v->channel[2]);
    } else if (smooth && t->color != NULL && !qtri_list_is_one_color(t)) {
        qtri_list_set_channels(v, 16);
        job->first = QTRI_U - v->channels;
        if (v->curved) {
            return set_block(v) ? qtri_span_fill : NULL;
        }
        for (int i = job->first; i < QTRI_U; i++) {
            job->attribute[i].ramp = v->channel[i];
        }
    } else {
        job->pixel = qtri_raster_stored(raster, qtri_list_flat_color(raster, t));
        return raster->fill_flat;
    }
    job->interpolate = qtri_interpolate_linear;
    qtri_job_pack(job);
    return raster->fill_smooth;
}

/* What texels are multiplied by. */
static void set_shades(qtri_job *job, qtri_list_values *v)
{
    const qtri_raster *raster = job->raster;
    const qtri_list_triangle *t = v->t;
    job->shaded = !raster->replace;
    job->tinted = t->color == NULL;
    if (raster->replace) {
        return;
    }
    if (t->color == NULL && t->light_q15 == QTRI_VERTEX_UNLIT) {
        qtri_list_set_light(v, 16);
        job->first = QTRI_U - 1;
    } else if (t->color != NULL && QTRI_WITH_SMOOTH && raster->shading == QTRI_SMOOTH &&
               !qtri_list_is_one_color(t)) {
        qtri_list_set_channels(v, 16);
        job->first = 0;
    } else {
        job->pixel = qtri_list_flat_shade(raster, t);
        job->shaded = job->pixel != QTRI_SHADE_WHITE;
    }
}

static qtri_fill_rows set_job(qtri_job *job, qtri_list_values *v)
{
    const qtri_raster *raster = v->raster;
    const qtri_place *p = v->t->place;
    job->raster = raster;
    job->values = v;
    job->interpolate = interpolate;
    job->tinted = false;
    job->perspective = false;
    job->packed = false;
    job->copies = false;
    job->shaded = false;
    job->cut = p->cut;
    job->first = QTRI_U;
    job->end = QTRI_U;
    job->anchor_x = p->column;
    job->anchor_y = p->row + raster->surface->first_row;
    v->channels = 0;
    v->curved = false;
    if (raster->texture == NULL) {
        const qtri_fill_rows fill = set_colors(job, v);
        if (fill == NULL) {
            return NULL;
        }
        qtri_list_set_depth(&job->depth, v);
        return fill;
    }
    if (!set_block(v)) {
        return NULL;
    }
    job->end = QTRI_ATTRIBUTES;
    set_shades(job, v);
    job->copies = raster->copied && !job->shaded;
    raster->texturing->set_list(v);
    for (int i = 0; i < 2; i++) {
        job->axis[i] = v->axis[i];
    }
    qtri_list_set_depth(&job->depth, v);
    return qtri_span_fill;
}

/* False when it must go another way. */
QTRI_NOINLINE static bool draw_rows(const qtri_raster *raster, const qtri_list_triangle *t)
{
    qtri_job job;
    qtri_list_values v;
    qtri_list_begin(&v, raster, t);
    v.along_rows = true;
    const qtri_fill_rows fill = set_job(&job, &v);
    if (fill == NULL) {
        return false;
    }
    qtri_list_flush(raster);
    int32_t row = job.anchor_y;
    const uint8_t *span = t->place->first;
    while (span[0] != QTRI_PLACE_STOP) {
        qtri_span spans[QTRI_ROWS_AHEAD];
        int32_t count = 0;
        do {
            spans[count].left = (int16_t)(span[0] + job.anchor_x);
            spans[count].right = (int16_t)(span[1] + job.anchor_x);
            span += 2;
            count++;
        } while (span[0] != QTRI_PLACE_STOP && count < QTRI_ROWS_AHEAD);
        fill(&job, spans, row, count);
        row += count;
    }
    return true;
}

void qtri_small_draw(const qtri_raster *raster, const qtri_list_triangle *t)
{
    if (!rows_are_long(t->place) || !draw_rows(raster, t)) {
        qtri_list_draw(raster, t);
    }
}

void qtri_small_attributes(const qtri_raster *raster, qtri_place *place,
                           const qtri_vertex *const v[3], const qtri_attributes attributes[3])
{
    int32_t color[3][3];
    qtri_coordinates uv[2];
    const qtri_list_triangle t = {
        place, {v[0], v[1], v[2]}, (const int32_t(*)[3])color, QTRI_VERTEX_UNLIT, uv};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            color[i][k] = attributes[i].color[k];
        }
    }
    if (raster->texture != NULL) {
        const int64_t u_q32[3] = {attributes[0].u_q32, attributes[1].u_q32, attributes[2].u_q32};
        const int64_t v_q32[3] = {attributes[0].v_q32, attributes[1].v_q32, attributes[2].v_q32};
        qtri_coordinates_set(&uv[0], u_q32);
        qtri_coordinates_set(&uv[1], v_q32);
    }
    qtri_small_draw(raster, &t);
}
