/* SPDX-License-Identifier: MIT */
/* Pieces of rows along which attributes are linear, and fog. */
#include "large_setup.h"

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

void qtri_large_planes_move(qtri_large_job *job)
{
    const qtri_large_attribute *const end = &job->t.a[job->count];
    for (int32_t rows = job->t.y - job->plane_y; rows > 0; rows--) { /* one, mostly */
        for (qtri_large_attribute *a = job->t.a; a != end; a++) {
            a->plane.row += a->plane.dy;
        }
        job->q.row += job->q.dy;
    }
    job->plane_y = job->t.y;
}

void qtri_large_clip(qtri_large_job *job, qtri_large_piece *piece, int32_t x)
{
    if (!job->options->mipmapped) {
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
        skip(job->options, piece, (uint32_t)(first - x));
    }
    piece->count = end - first;
}

static uint32_t shifted(uint32_t x, int32_t up)
{
    return up >= 0 ? x << up : (uint32_t)((int32_t)x >> (up < -31 ? 31 : -up));
}

/* Attributes at the row's left end, where nothing follows perspective. */
static inline void set_left(qtri_large_job *job)
{
    qtri_large_planes_move(job);
    for (int i = 0; i < job->count; i++) {
        qtri_large_attribute *a = &job->t.a[i];
        a->at = shifted(qtri_large_plane_at(&a->plane, job->row_left), a->up) + a->start;
    }
}

/* All of a row of texture coordinates alone. */
static inline int32_t whole_row(qtri_large_job *job)
{
    qtri_large_piece *piece = &job->t.piece[0];
    const qtri_large_attribute *u = &job->t.a[0], *v = &job->t.a[1];
    const uint32_t skipped = (uint32_t)(job->t.x0 - job->row_left);
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
    const int32_t left = job->row_left;
    const int32_t skipped = (job->t.x0 - left) >> job->run_log2 << job->run_log2;
    job->is_new = false;
    job->t.x = left + skipped;
    if (!job->is_curved) {
        set_left(job);
    }
    for (int i = 0; i < job->count; i++) {
        job->t.a[i].at += job->t.a[i].step * (uint32_t)skipped;
    }
}

int32_t qtri_large_linear_piece(qtri_large_job *job)
{
    qtri_large_piece *piece = &job->t.piece[0];
    if (job->first_color == job->count && !job->options->mipmapped) {
        return whole_row(job);
    }
    if (job->is_new) {
        begin_row(job);
    }
    const int32_t run = (int32_t)1 << job->run_log2, x = job->t.x;
    piece->count = qtri_least32(run, job->row_right - x);
    if (job->first_color != 0) {
        piece->u = job->t.a[0].at;
        piece->v = job->t.a[1].at;
        piece->u_step = job->t.a[0].step;
        piece->v_step = job->t.a[1].step;
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
            job->t.a[i].at += job->t.a[i].step << job->run_log2;
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
    const qtri_large_job *job = qtri_large_job_of(t);
    const int32_t x = t->fog_x;
    int32_t first = job->row_left + ((x - job->row_left) & -FOG_PIXELS);
    int32_t last = qtri_least32(first + FOG_PIXELS, job->row_right) - 1;
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
