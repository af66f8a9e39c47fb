/* SPDX-License-Identifier: MIT */
/* Pieces of rows: colours are packed, attributes that are linear, and fog. */
#include "large_setup.h"

static uint32_t shifted(uint32_t x, int32_t up)
{
    return up >= 0 ? x << up : (uint32_t)((int32_t)x >> (up < -31 ? 31 : -up));
}

void qtri_large_planes_move(qtri_large_job *job)
{
    const qtri_large_attribute *const end = &job->a[job->count];
    for (int32_t rows = job->t.y - job->t.plane_y; rows > 0; rows--) { /* one, mostly */
        for (qtri_large_attribute *a = job->a; a != end; a++) {
            a->along.plane.row += a->along.plane.dy;
        }
        job->q.row += job->q.dy;
    }
    job->t.plane_y = job->t.y;
}

/* Attributes at the row's left end, where nothing follows perspective. */
static inline void set_left(qtri_large_job *job)
{
    qtri_large_planes_move(job);
    for (int i = 0; i < job->count; i++) {
        qtri_large_attribute *a = &job->a[i];
        a->at = shifted(qtri_large_plane_at(&a->along.plane, job->t.row_left), a->up) + a->start;
    }
}

/* Colours: see qtri_pixel_walk -------------------------------------------------------------------
 */

static uint32_t signed_shift(uint32_t x, int32_t by)
{
    return (uint32_t)((int32_t)x >> by);
}

/* Steps of lanes lose `down` bits. */
static void lane_steps(uint32_t *c_step, uint32_t *g_step, const uint32_t *step, int32_t down)
{
    const uint32_t round = (uint32_t)1 << (down - 1);
    *c_step = (signed_shift(step[0] + round, down) << 16) + signed_shift(step[2] + round, down);
    *g_step = step[1];
}

/* A step to nearest 2^(bits - 16); to nearest zero of what is below 0, as all sums are unsigned. */
static uint32_t rounded(uint32_t step, uint32_t bits)
{
    return (step + ((uint32_t)1 << (bits - 1))) & ~(((uint32_t)1 << bits) - 1);
}

static uint32_t word_step(const uint32_t step[3])
{
    return (step[0] >> 10 << 21) + step[2] + signed_shift(step[1], 11);
}

/*
 * Two steps in turn, whose sum is rounded; and what is added where n pixels start: half of what
 * that sums up to along them.
 */
static inline void channel_steps(uint32_t *one, uint32_t *two, uint32_t *center, uint32_t step,
                                 uint32_t bits, int32_t n)
{
    const uint32_t both = rounded(2 * step, bits);
    *one = rounded(step, bits);
    *two = both - *one;
    *center = (uint32_t)(((int32_t)(2 * step - both) * (n - 1)) >> 2);
}

static void word_steps(uint32_t *even, uint32_t *odd, uint32_t center[3], const uint32_t *step,
                       int32_t n)
{
    uint32_t one[3], two[3];
    channel_steps(&one[0], &two[0], &center[0], step[0], 10, n);
    channel_steps(&one[1], &two[1], &center[1], step[1], 11, n);
    channel_steps(&one[2], &two[2], &center[2], step[2], 11, n);
    *even = word_step(one);
    *odd = word_step(two);
}

void qtri_large_pack_colors(int packing, qtri_large_piece *piece, const uint32_t *c,
                            const uint32_t *step, int32_t n)
{
    if (packing == QTRI_PACK_ONE) {
        piece->c = c[0];
        piece->c_step = step[0];
    } else if (packing == QTRI_PACK_565) {
        uint32_t center[3];
        word_steps(&piece->c_step, &piece->c_other, center, step, n);
        piece->c = qtri_large_word(c[0] + center[0], c[1] + center[1], c[2] + center[2]);
    } else if (packing != QTRI_PACK_NONE) {
        const int32_t down = packing == QTRI_PACK_WEIGHTS ? 9 : 8;
        lane_steps(&piece->c_step, &piece->g_step, step, down);
        piece->c = (c[0] >> down << 16) + (c[2] >> down);
        piece->g = c[1];
    }
}

void qtri_large_pack(const qtri_large_job *job, qtri_large_piece *piece,
                     const uint32_t at[QTRI_LARGE_ATTRIBUTES],
                     const uint32_t step[QTRI_LARGE_ATTRIBUTES], int32_t n)
{
    qtri_large_pack_colors(job->packing, piece, &at[job->first_color], &step[job->first_color], n);
    if (job->alpha < job->count) {
        piece->alpha = at[job->alpha];
        piece->alpha_step = step[job->alpha];
    }
}

uint32_t qtri_large_begin_runs(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    const uint32_t skipped = (uint32_t)(t->x0 - job->t.row_left);
    const uint32_t start = skipped & ~(uint32_t)(QTRI_LARGE_RUN - 1);
    const uint32_t x = (uint32_t)job->t.row_left + start, y = (uint32_t)t->y;
    for (int i = 0; i < 3; i++) {
        job->run[i] = job->run_at[i] + job->a[i].step * x + job->run_down[i] * y + job->center[i];
    }
    return skipped - start;
}

void qtri_large_set_run_steps(qtri_large_job *job)
{
    const qtri_large_attribute *a = &job->a[job->first_color];
    if (job->packing == QTRI_PACK_ONE) {
        job->piece[0].c_step = a->step;
    } else if (job->packing != QTRI_PACK_NONE) {
        const uint32_t step[3] = {a[0].step, a[1].step, a[2].step};
        if (job->packing == QTRI_PACK_565) {
            word_steps(&job->run_even, &job->run_odd, job->center, step, QTRI_LARGE_RUN);
        } else {
            lane_steps(&job->piece[0].c_step, &job->piece[0].g_step, step,
                       job->packing == QTRI_PACK_WEIGHTS ? 9 : 8);
        }
    }
    if (job->alpha < job->count) {
        job->piece[0].alpha_step = job->a[job->alpha].step;
    }
}

void qtri_large_pack_linear(qtri_large_job *job, qtri_large_piece *piece)
{
    const qtri_large_attribute *a = &job->a[job->first_color];
    if (job->packing == QTRI_PACK_ONE) {
        piece->c = a->at;
    } else if (job->packing == QTRI_PACK_565) {
        piece->c = qtri_large_word(a[0].at + job->center[0], a[1].at + job->center[1],
                                   a[2].at + job->center[2]);
        piece->c_step = job->run_even;
        piece->c_other = job->run_odd;
    } else if (job->packing != QTRI_PACK_NONE) {
        const int32_t down = job->packing == QTRI_PACK_WEIGHTS ? 9 : 8;
        piece->c = (a[0].at >> down << 16) + (a[2].at >> down);
        piece->g = a[1].at;
    }
    if (job->alpha < job->count) {
        piece->alpha = job->a[job->alpha].at;
    }
}
/* Pieces --------------------------------------------------------------------------------------- */

void qtri_large_skip_colors(const qtri_options *o, qtri_large_piece *piece, uint32_t n)
{
    if (qtri_is_packed_565(o)) {
        const uint32_t even = piece->c_step, odd = piece->c_other;
        piece->c += even * ((n + 1) >> 1) + odd * (n >> 1);
        piece->c_step = (n & 1) != 0 ? odd : even;
        piece->c_other = (n & 1) != 0 ? even : odd;
    } else {
        piece->c += piece->c_step * n;
    }
    if (qtri_has_two_words(o)) {
        piece->g += piece->g_step * n;
    }
}

/* What bounds cut off: goes on by n pixels. */
static void skip(const qtri_options *o, qtri_large_piece *piece, uint32_t n)
{
    if (qtri_is_textured(o)) {
        const uint32_t bends = n * (n - 1) / 2;
        piece->u += piece->u_step * n + piece->u_bend * bends;
        piece->v += piece->v_step * n + piece->v_bend * bends;
        piece->u_step += piece->u_bend * n;
        piece->v_step += piece->v_bend * n;
    }
    if (qtri_large_varies(o)) {
        qtri_large_skip_colors(o, piece, n);
    }
    if (o->vertex_alpha) {
        piece->alpha += piece->alpha_step * n;
    }
}

void qtri_large_clip(qtri_large_job *job, qtri_large_piece *piece, int32_t x)
{
    if (!job->t.options->mipmapped) {
        qtri_large_cut(job, piece, x);
    }
}

void qtri_large_cut(qtri_large_job *job, qtri_large_piece *piece, int32_t x)
{
    const int32_t first = qtri_greatest32(x, job->t.x0);
    const int32_t end = qtri_least32(x + piece->count, job->t.x1);
    if (first >= end) {
        piece->count = 0;
        return;
    }
    if (first != x) {
        skip(job->t.options, piece, (uint32_t)(first - x));
    }
    piece->count = end - first;
}

/* All of a row of texture coordinates alone. */
static inline int32_t whole_row(qtri_large_job *job)
{
    qtri_large_piece *piece = &job->piece[0];
    const qtri_large_attribute *u = &job->a[0], *v = &job->a[1];
    const uint32_t skipped = (uint32_t)(job->t.x0 - job->t.row_left);
    if (!job->is_curved) {
        set_left(job);
    }
    piece->u = u->at + u->step * skipped;
    piece->v = v->at + v->step * skipped;
    piece->u_step = u->step;
    piece->v_step = v->step;
    piece->u_bend = 0;
    piece->v_bend = 0;
    piece->count = job->t.x1 - job->t.x0;
    job->t.x = job->t.x1;
    return 1;
}

/* The row's first piece of those that start at multiples of a run from the row's left end. */
static void begin_row(qtri_large_job *job)
{
    const int32_t left = job->t.row_left;
    const int32_t skipped = (job->t.x0 - left) >> job->run_log2 << job->run_log2;
    job->t.is_new = false;
    job->t.x = left + skipped;
    if (!job->is_curved) {
        set_left(job);
    }
    for (int i = 0; i < job->count; i++) {
        job->a[i].at += job->a[i].step * (uint32_t)skipped;
    }
}

int32_t qtri_large_linear_piece(qtri_large_job *job)
{
    qtri_large_piece *piece = &job->piece[0];
    if (job->first_color == job->count && !job->t.options->mipmapped) {
        return whole_row(job);
    }
    if (job->t.is_new) {
        begin_row(job);
    }
    const int32_t run = (int32_t)1 << job->run_log2, x = job->t.x;
    piece->count = qtri_least32(run, job->t.row_right - x);
    if (job->first_color != 0) {
        piece->u = job->a[0].at;
        piece->v = job->a[1].at;
        piece->u_step = job->a[0].step;
        piece->v_step = job->a[1].step;
        piece->u_bend = 0;
        piece->v_bend = 0;
    }
    if (job->first_color != job->count) {
        qtri_large_pack_linear(job, piece);
    }
    if (x < job->t.x0 || x + piece->count > job->t.x1) {
        qtri_large_clip(job, piece, x);
    }
    job->t.x = x + run;
    if (job->t.x < job->t.x1) {
        for (int i = 0; i < job->count; i++) {
            job->a[i].at += job->a[i].step << job->run_log2;
        }
    }
    return 1;
}

/* Fog --------------------------------------------------------------------------------------------
 */

enum { FOG_PIXELS = 32, FOG_ERROR = 1 << 14 /* half of 1/256: between it may be twice that */ };

static uint32_t fog_at(const qtri_large *t, int32_t x)
{
    return qtri_fog_share(t->state->fog, t->z + (uint32_t)(x - t->x0) * t->z_step);
}

/*
 * Between pixels `first` and `last` fog is linear if it is so in the middle: bisects, from the left
 * end of the row on, what has more. All are within the row, whose depth is in range.
 */
int32_t qtri_large_next_fog(qtri_large *t, int32_t count)
{
    const int32_t x = t->fog_x;
    int32_t first = t->row_left + ((x - t->row_left) & -FOG_PIXELS);
    int32_t last = qtri_least32(first + FOG_PIXELS, t->row_right) - 1;
    uint32_t from = fog_at(t, first), to = fog_at(t, last);
    while (last - first > 1) {
        const int32_t middle = (first + last) >> 1;
        const uint32_t f = fog_at(t, middle);
        const int32_t on_chord =
            (int32_t)from + (int32_t)(to - from) / (last - first) * (middle - first);
        if (qtri_magnitude32(on_chord - (int32_t)f) <= FOG_ERROR) {
            break;
        }
        if (x <= middle) {
            last = middle;
            to = f;
        } else {
            first = middle + 1;
            from = fog_at(t, first);
        }
    }
    const int32_t n = last - first;
    t->fog_step = n > 0 ? (uint32_t)((int32_t)(to - from) / n) : 0;
    t->fog = from + 0x8000u + t->fog_step * (uint32_t)(x - first);
    const int32_t done = qtri_least32(count, last + 1 - x);
    t->fog_x = x + done;
    return done;
}

int32_t qtri_large_chord_bound_log2(const qtri_large_job *job)
{
    return job->packing != QTRI_PACK_565 && qtri_stores_565(job->t.options) ? 16 : 14;
}
