/* SPDX-License-Identifier: MIT */
/*
 * Levels along rows of large triangles: footprint.c says what is known of a triangle.
 */
#include "loop.h"
#include "mipmap.h"
#include "perspective_block.h"
#include "textured_span.h"

/* Pixels along a row where w does not change that have one level. */
#define LEVEL_RUN 128

/* Setting up ----------------------------------------------------------------------------------- */

void qtri_mipmap_axes(qtri_job *job, uint32_t value[2][3], const qtri_attributes v[3])
{
    qtri_levels *levels = qtri_levels_of(job->raster);
    levels->axis = NULL;
    qtri_level_set(levels, 0);
    qtri_textured_axes(job, value, v);
    for (int i = 0; i < 2; i++) { /* from corners, until the level is known */
        if (levels->texture.filter != NULL) {
            job->axis[i].bias += (uint32_t)1 << (job->axis[i].shift - 1);
        }
    }
}

/* 2^-12 texel a pixel, held to 2^30. slope: 2^-(16 + shift). */
static uint32_t linear_step(uint64_t slope, int32_t shift)
{
    const uint64_t size = qtri_magnitude64(qtri_wrap64(slope)) >> (4 + shift);
    return size >> 30 != 0 ? (uint32_t)1 << 30 : (uint32_t)size;
}

/* The level of coordinates that are linear. 5793 is 2^(1/2) 2^12. */
static uint32_t linear_level(const qtri_job *job, uint32_t last)
{
    uint32_t right[2];
    uint32_t down[2];
    for (int i = 0; i < 2; i++) {
        const qtri_plane *plane = &job->attribute[QTRI_U + i].plane;
        right[i] = linear_step(plane->dx, job->axis[i].shift);
        down[i] = linear_step(plane->dy, job->axis[i].shift);
    }
    const uint32_t across = qtri_step_length(right[0], right[1]);
    const uint32_t along = qtri_step_length(down[0], down[1]);
    const uint32_t length = across > along ? across : along;
    uint32_t level = 0;
    while (level < last && length >= (uint32_t)5793 << level) {
        level++;
    }
    return level;
}

/* All rows of the job are of the raster's level. */
static void set_axes_down(qtri_job *job, const qtri_levels *levels)
{
    const uint8_t *down = levels->down;
    for (int i = 0; i < 2; i++) {
        qtri_texel_axis *axis = &job->axis[i];
        if (levels->texture.filter != NULL) {
            axis->bias -= (uint32_t)1 << ((uint32_t)axis->shift + down[i] - 1);
        }
        if (axis->clamped || levels->raster->texel_cut == 0) {
            qtri_axis_move(axis, down[i]);
        } else {
            axis->texel_shift = levels->raster->coordinate[i].shift;
            axis->up = (int8_t)(i == 0 ? axis->up : axis->up - down[0] - down[1]);
        }
    }
}

/* Along a row ---------------------------------------------------------------------------------- */

/* The longer of both steps at pixel x; right: of the row's. < 2^29 */
static inline uint32_t length_at(const qtri_footprint *f, uint32_t right, int32_t x)
{
    uint32_t down;
    if (f->straight) {
        down = f->along + (uint32_t)x * f->along_dx;
    } else {
        down =
            qtri_step_length(qtri_magnitude32((int32_t)(f->down[0] + (uint32_t)x * f->down_dx[0])),
                             qtri_magnitude32((int32_t)(f->down[1] + (uint32_t)x * f->down_dx[1])));
    }
    return right > down ? right : down;
}

/*
 * A footprint is 2^(level + 1/2) texels or more, so that the level is left behind, where length >>
 * (before + 1 + level) is q's square or more: with 22 bits of that, 2^(20 + 2 zeros), and a length
 * that is 1/2^(1/2) of half the footprint's 2^-exponent / q^2.
 */
typedef struct measure {
    uint32_t square; /* 2^20..2^22 */
    int32_t before;  /* for level 0 */
} measure;

/* q: times 2^zeros, 2^31 or more. */
static inline measure measure_of(const qtri_footprint *f, uint32_t q, int32_t zeros)
{
    const uint32_t q_q11 = q >> 21;
    const measure m = {q_q11 * q_q11, f->before - 2 * zeros};
    return m;
}

static inline bool is_left(uint32_t length, uint32_t square, int32_t shift)
{
    if (shift >= 0) {
        return shift < 32 && square <= length >> shift;
    }
    return (square - 1) >> qtri_least32(-shift, 31) < length;
}

/* Of m, of which `level` is not the right one. */
static inline uint32_t find_level(const measure *m, uint32_t length, const qtri_levels *levels,
                                  uint32_t level)
{
    int32_t before = m->before + (int32_t)level;
    while (level < levels->last && is_left(length, m->square, before + 1)) {
        before++;
        level++;
    }
    while (level > 0 && !is_left(length, m->square, before)) {
        before--;
        level--;
    }
    return level;
}

/* Whether the level, of what was drawn before, is that where m was taken, as most often it is. */
static inline bool is_level(const measure *m, uint32_t length, const qtri_levels *levels,
                            uint32_t level)
{
    const uint32_t before = (uint32_t)m->before + level;
    if (before < 31) {
        const uint32_t most = length >> before;
        return m->square > most ? level == 0 : m->square > most >> 1 || level == levels->last;
    }
    return false;
}

static inline void set_level(const measure *m, uint32_t length, qtri_levels *levels)
{
    const uint32_t level = levels->level;
    if (!is_level(m, length, levels, level)) {
        qtri_level_set(levels, find_level(m, length, levels, level));
    }
}

/* Of the step right, of all of a row. */
static inline uint32_t row_length(const qtri_footprint *f, int32_t y)
{
    return qtri_step_length(
        qtri_magnitude32((int32_t)(f->right[0] + (uint32_t)y * f->right_dy[0])),
        qtri_magnitude32((int32_t)(f->right[1] + (uint32_t)y * f->right_dy[1])));
}

static inline measure measure_at(const qtri_scanline *row, const qtri_footprint *f, int32_t x)
{
    const uint32_t q = qtri_row_inv_w_at(row, x);
    const int32_t zeros = qtri_clz32(q);
    return measure_of(f, q << zeros, zeros);
}

/* Before pixels of a row are asked for. */
static inline void begin_row(qtri_footprint *f, int32_t y)
{
    if (f->row != y) {
        f->row = (int16_t)y;
        f->length = row_length(f, y);
    }
}

static inline uint32_t curve_down(uint32_t step, uint32_t down)
{
    // cppcheck-suppress shiftTooManyBitsSigned
    return (uint32_t)((int32_t)(step + ((uint32_t)1 << down >> 1)) >> down);
}

/*
 * v in the unit of the level, where it fills 32 bits: a texel's fraction ends two bits lower for
 * each level, one where the height goes down no more, see texel_copy.h. Steps are off by half of
 * the last bit, 2^-(17 + width_log2) of the level's texel: 128 pixels on by 2^-11 of one.
 */
static inline void scale_v(qtri_curve *v, uint32_t down)
{
    if (down == 0) {
        return;
    }
    v->at >>= down;
    v->step = curve_down(v->step, down);
    if ((v->bend | v->twist) != 0) {
        v->bend = curve_down(v->bend, down);
        v->twist = curve_down(v->twist, down);
    }
}

/* Curves in base units to those of the level; axis: its, where coordinates do not fill 32 bits. */
static void scale_curves(qtri_curve uv[2], const qtri_levels *levels, const qtri_texel_axis axis[2])
{
    const qtri_raster *raster = levels->raster;
    if (raster->texel_cut != 0 && !axis[1].clamped) {
        scale_v(&uv[1], (uint32_t)levels->down[0] + levels->down[1]);
    }
    if (levels->texture.filter != NULL) {
        for (int i = 0; i < 2; i++) {
            const uint32_t shift = raster->texel_cut == 0 || axis[i].clamped
                                       ? axis[i].texel_shift
                                       : raster->coordinate[i].shift;
            uv[i].at -= (uint32_t)1 << (shift - 1);
        }
    }
}

/*
 * Of a row along which w does not change: the level at pixel x, with curves of u and v that begin
 * at the run of LEVEL_RUN pixels that it lies in, which is where they are scaled. Returns where
 * the run begins; at: that of the row's curves.
 */
QTRI_IN_PLACE int32_t begin_run(const qtri_scanline *row, qtri_levels *levels, const measure *m,
                                qtri_curve uv[2], int32_t at, int32_t x)
{
    const int32_t first = x - ((x - row->left) & (LEVEL_RUN - 1));
    const int32_t length = qtri_least32(LEVEL_RUN, row->right - first);
    const int32_t last = row->job->raster->surface->width - 1;
    const int32_t middle = qtri_hold32(first + (length >> 1), 0, last); /* in the frame */
    const uint32_t size = length_at(&levels->footprint, levels->footprint.length, middle);
    set_level(m, size, levels);
    for (int i = 0; i < 2; i++) {
        uv[i] = row->curve[QTRI_U + i];
        uv[i].at += (uint32_t)(first - at) * uv[i].step;
    }
    return first;
}

/*
 * Along a row where w does not change colours do not vary either, see level_pixels() of
 * perspective.c, so curves of the run that pixel x lies in have room in place of theirs. Returns
 * how many pixels x is into it.
 */
QTRI_NOINLINE static int32_t begin_level(qtri_scanline *row, qtri_levels *levels, int32_t x)
{
    begin_row(&levels->footprint, row->y);
    const measure m = measure_at(row, &levels->footprint, row->left);
    return x - begin_run(row, levels, &m, row->curve, x, x);
}

/* A chunk: of its texels, those before `from` are colours, `drawn` says which of them are drawn. */
typedef struct chunk {
    int32_t from;
    uint32_t drawn;
} chunk;

/*
 * Texels up to `to`, which are of the level that is set, become colours. Stages work on four at a
 * time: what they find beyond must be of some texel, as blocks that begin with a fourth leave it.
 */
static void color_texels(chunk *c, const qtri_job *job, int32_t to)
{
    const qtri_raster *raster = job->raster;
    uint32_t *color = raster->batch->color;
    uint32_t *shade = raster->batch->by.shade;
    const int32_t count = to - c->from;
    if ((c->from & 3) != 0) {
        for (int32_t i = to; i < to + 3; i++) {
            color[i] = color[c->from];
            shade[i] = shade[c->from];
        }
    }
    const uint32_t some =
        qtri_texels_color(raster, raster->texel_cut != 0 ? NULL : job->axis, color + c->from,
                          shade + c->from, count, raster->fetched, job->shaded) &
        qtri_mask_of(count);
    c->drawn = c->from == 0 ? some : c->drawn << count | some;
    c->from = to;
}

/* The same of a block of curves, `done` pixels into a chunk: returns how many it has. */
QTRI_NOINLINE static int32_t begin_bent(qtri_scanline *row, qtri_levels *levels, chunk *c,
                                        int32_t x, int32_t done)
{
    const qtri_footprint *f = &levels->footprint;
    qtri_block b;
    begin_row(&levels->footprint, row->y);
    const int32_t length = qtri_block_begin(row, &b, row->job->color.perspective.texels, x + done);
    const measure m = measure_of(f, b.q, b.zeros);
    const uint32_t size = length_at(f, f->length, b.x);
    if (!is_level(&m, size, levels, levels->level)) {
        if (c->from < done) {
            color_texels(c, row->job, done);
        }
        set_level(&m, size, levels);
    }
    qtri_block_end(row, &b, QTRI_U, QTRI_ATTRIBUTES);
    return length;
}

uint32_t qtri_mipmap_chunk(qtri_scanline *row, int32_t x, int32_t count, uint32_t mask)
{
    const qtri_job *job = row->job;
    const qtri_raster *raster = job->raster;
    qtri_levels *levels = qtri_levels_of(raster);
    const bool fills = raster->texel_cut != 0;
    chunk c = {0, 0};
    for (int32_t done = 0; done < count;) {
        qtri_curve *uv = &row->curve[QTRI_U];
        int32_t length = count;
        int32_t skip = 0;
        if (row->level) {
            uv = row->curve;
            skip = begin_level(row, levels, x);
        } else {
            length = qtri_least32(begin_bent(row, levels, &c, x, done), count - done);
        }
        scale_curves(uv, levels, job->axis);
        uv[0].at += (uint32_t)skip * uv[0].step; /* 0, or the curves are straight */
        uv[1].at += (uint32_t)skip * uv[1].step;
        qtri_number_texels(raster, job->axis, done, uv, !raster->repeated && fills, length);
        done += length;
    }
    color_texels(&c, job, count);
    mask &= c.drawn;
    if (mask == 0 || !job->shaded) {
        return mask;
    }
    qtri_shade_texels(row, x, count);
    if (raster->narrow != NULL && !raster->gray) {
        raster->narrow(raster->batch->color, count);
    }
    return mask;
}

/* Rows that become pixels as they are ---------------------------------------------------------- */

QTRI_NOINLINE static void copy_level_row(qtri_scanline *row, qtri_run *run, qtri_levels *levels)
{
    const qtri_job *job = row->job;
    begin_row(&levels->footprint, row->y);
    const measure m = measure_at(row, &levels->footprint, row->left);
    for (int32_t x = row->x0; x < row->x1; x += run->count) {
        qtri_curve uv[2];
        const int32_t first = begin_run(row, levels, &m, uv, row->left, x);
        scale_v(&uv[1], (uint32_t)levels->down[0] + levels->down[1]);
        run->x = x;
        run->count = qtri_least32(first + LEVEL_RUN, row->x1) - x;
        run->z = qtri_ramp_at(&job->depth, x - job->anchor_x, row->y - job->anchor_y);
        for (int i = 0; i < 2; i++) {
            run->value[i] = uv[i].at + (uint32_t)(x - first) * uv[i].step;
            run->step[i] = uv[i].step;
        }
        job->raster->copy_run(job, run);
    }
}

/*
 * The level of what is copied along curves: of the raster only what such loops look at, the texels
 * and the cut, until finish_copies.
 */
typedef struct copied {
    uint32_t level, down; /* down: of v */
} copied;

/* What is copied has a cut, so sides below 2^16. */
QTRI_NOINLINE static void set_copied(copied *c, qtri_levels *levels, const measure *m,
                                     uint32_t length)
{
    const uint32_t level = find_level(m, length, levels, c->level);
    const qtri_texture *whole = levels->whole;
    const uint32_t height_log2 = whole->height_log2;
    const uint32_t down = level < height_log2 ? level : height_log2;
    const qtri_texture sides = {.width_log2 = (uint8_t)(whole->width_log2 - level),
                                .height_log2 = (uint8_t)(height_log2 - down)};
    c->level = level;
    c->down = level + down;
    levels->texture.texels = level == 0 ? whole->texels : whole->levels[level - 1];
    levels->raster->texel_cut = qtri_texel_cut(&sides);
}

static inline copied begin_copies(const qtri_levels *levels)
{
    const copied c = {levels->level, (uint32_t)levels->down[0] + levels->down[1]};
    return c;
}

static inline void finish_copies(const copied *c, qtri_levels *levels)
{
    qtri_level_set(levels, c->level);
}

QTRI_IN_PLACE void copy_bent_row(qtri_scanline *row, qtri_run *run, qtri_levels *levels, copied *c)
{
    const qtri_job *job = row->job;
    const qtri_footprint *f = &levels->footprint;
    const uint32_t right = row_length(f, row->y);
    for (int32_t x = row->left + ((row->x0 - row->left) & -QTRI_BATCH); x < row->x1;) {
        qtri_block b;
        const int32_t length = qtri_block_begin(row, &b, job->color.perspective.texels, x);
        const int32_t skip = qtri_greatest32(row->x0 - x, 0);
        run->count = qtri_least32(length, row->x1 - x) - skip;
        if (run->count > 0) {
            const measure m = measure_of(f, b.q, b.zeros);
            const uint32_t size = length_at(f, right, b.x);
            if (!is_level(&m, size, levels, c->level)) {
                const measure copy = m; /* or all of it would be in memory */
                set_copied(c, levels, &copy, size);
            }
            qtri_block_end(row, &b, QTRI_U, QTRI_ATTRIBUTES);
            scale_v(&row->curve[QTRI_U + 1], c->down);
            run->x = x + skip;
            run->z = qtri_ramp_at(&job->depth, run->x - job->anchor_x, row->y - job->anchor_y);
            job->raster->copy_bent(job, run, &row->curve[QTRI_U], skip);
        }
        x += length;
    }
}

/* As qtri_span_fill does it, level by level. */
static void fill_copies(const qtri_job *job, const qtri_span *spans, int32_t y, int32_t count)
{
    const qtri_raster *raster = job->raster;
    qtri_levels *levels = qtri_levels_of(raster);
    qtri_lines lines = qtri_lines_at(raster->surface, y);
    qtri_scanline row;
    row.job = job;
    row.y = y;
    row.level = false;
    copied c = begin_copies(levels);
    qtri_perspective_begin(&row);
    for (; count > 0; count--, spans++) {
        const int32_t pixels = qtri_span_clip(spans, &raster->bounds, &row.x0);
        if (pixels > 0) {
            qtri_run run;
            run.pixels = lines.pixels;
            run.depths = lines.depths;
            row.x1 = row.x0 + pixels;
            row.left = spans->left;
            row.right = spans->right;
            qtri_perspective_row(&row);
            if (row.level) {
                finish_copies(&c, levels);
                copy_level_row(&row, &run, levels);
                c = begin_copies(levels);
            } else {
                copy_bent_row(&row, &run, levels, &c);
            }
        }
        row.y++;
        lines.pixels += raster->surface->pitch;
        lines.depths += raster->surface->depth_pitch;
    }
    finish_copies(&c, levels);
}

qtri_fill_rows qtri_mipmap_begin_large(qtri_job *job, const qtri_triangle *triangle,
                                       const uint32_t value[2][3], const uint32_t q[3])
{
    const qtri_raster *raster = job->raster;
    qtri_levels *levels = qtri_levels_of(raster);
    qtri_levels_vary(levels, qtri_job_is_bent(job));
    if (!qtri_job_is_bent(job)) {
        qtri_level_set(levels, linear_level(job, levels->last));
        set_axes_down(job, levels);
        return qtri_span_fill;
    }
    qtri_footprint_init(&levels->footprint, job, triangle, value, q);
    levels->axis = job->axis;
    return job->copies && raster->copy_run != NULL ? fill_copies : qtri_span_fill;
}
