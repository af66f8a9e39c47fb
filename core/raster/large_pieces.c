/* SPDX-License-Identifier: MIT */
/* Pieces of rows along which attributes are linear, what bounds leave of pieces, and fog. */
#include "large_setup.h"

void qtri_large_planes_move(qtri_large_job *job)
{
    const qtri_large_attribute *const end = &job->a[job->count];
    for (int32_t rows = job->t.y - job->t.plane_y; rows > 0; rows--) { /* one, mostly */
        for (qtri_large_attribute *a = job->a; a != end; a++) {
            a->plane.row += a->plane.dy;
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
        const uint32_t at = qtri_large_plane_at(&a->plane, job->t.row_left);
        a->at = (uint32_t)qtri_shift32((int32_t)at, a->piece_shift) + a->start;
    }
}

/* Pieces --------------------------------------------------------------------------------------- */

void qtri_large_pack(const qtri_large_job *job, qtri_large_piece *piece,
                     const uint32_t at[QTRI_LARGE_ATTRIBUTES],
                     const uint32_t step[QTRI_LARGE_ATTRIBUTES], int32_t n)
{
    if (job->packing != NULL) {
        job->packing->pack(piece, &at[job->first_color], &step[job->first_color], n);
    }
    if (job->alpha < job->count) {
        piece->of.colors.alpha = at[job->alpha];
        piece->of.colors.alpha_step = step[job->alpha];
    }
}

void qtri_large_pack_linear(const qtri_large_job *job, qtri_large_piece *piece)
{
    uint32_t at[QTRI_LARGE_ATTRIBUTES], step[QTRI_LARGE_ATTRIBUTES];
    for (int i = job->first_color; i < job->count; i++) {
        at[i] = job->a[i].at;
        step[i] = job->a[i].step;
    }
    qtri_large_pack(job, piece, at, step, QTRI_LARGE_RUN);
}

/* Goes on by n pixels, to the next knot at most. */
static void skip_coordinates(qtri_large_piece *piece, uint32_t n)
{
    const uint32_t bends = n * (n - 1) / 2;
    for (int i = 0; i < 2; i++) {
        piece->uv[i].at += piece->uv[i].step * n + piece->uv[i].bend * bends;
        piece->uv[i].step += piece->uv[i].bend * n;
    }
}

void qtri_large_skip(const qtri_large_job *job, qtri_large_piece *piece, uint32_t n)
{
    if (job->first_color != 0) {
        uint32_t left = n;
        if (job->has_knots) {
            while (left >= (uint32_t)piece->of.knots.next) {
                left -= (uint32_t)piece->of.knots.next;
                skip_coordinates(piece, (uint32_t)piece->of.knots.next);
                qtri_large_pass_knot(piece, &piece->uv[0].step, &piece->uv[0].bend,
                                     &piece->uv[1].step, &piece->uv[1].bend);
            }
            piece->of.knots.next -= (int32_t)left;
        }
        skip_coordinates(piece, left);
    }
    if (job->packing != NULL) {
        qtri_large_skip_colors(piece, n);
    }
    if (job->alpha < job->count) {
        piece->of.colors.alpha += piece->of.colors.alpha_step * n;
    }
}

void qtri_large_clip(qtri_large_job *job, qtri_large_piece *piece, int32_t x)
{
    if (!qtri_large_has_levels(job)) {
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
        qtri_large_skip(job, piece, (uint32_t)(first - x));
    }
    piece->count = end - first;
}

/* All of a row of texture coordinates alone. */
static inline int32_t whole_row(qtri_large_job *job)
{
    qtri_large_piece *piece = &job->piece[0];
    const uint32_t skipped = (uint32_t)(job->t.x0 - job->t.row_left);
    if (!job->is_curved) {
        set_left(job);
    }
    qtri_large_set_straight(job, piece, skipped);
    piece->count = job->t.x1 - job->t.x0;
    piece->of.knots.next = piece->count;
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
    if (job->has_knots) {
        return whole_row(job);
    }
    if (job->t.is_new) {
        begin_row(job);
    }
    const int32_t run = (int32_t)1 << job->run_log2, x = job->t.x;
    piece->count = qtri_least32(run, job->t.row_right - x);
    if (job->first_color != 0) {
        qtri_large_set_straight(job, piece, 0);
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
    return qtri_fog_share(t->state->fog, t->row_z + (uint32_t)x * t->z_step);
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
            (int32_t)from +
            qtri_divide32((int32_t)(to - from), (uint32_t)(last - first)) * (middle - first);
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
    t->fog_step = n > 0 ? (uint32_t)qtri_divide32((int32_t)(to - from), (uint32_t)n) : 0;
    t->fog = from + 0x8000u + t->fog_step * (uint32_t)(x - first);
    const int32_t done = qtri_least32(count, last + 1 - x);
    t->fog_x = x + done;
    return done;
}
