/* SPDX-License-Identifier: MIT */
/* Pieces of rows along which attributes are linear, what bounds leave of pieces, and fog. */
#include "descriptions.h"
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

enum { FOG_FULL = 1 << 24 };

/* Cuts fog to its range; returns for how many pixels, n at most, it stays out of it, or within. */
static int32_t clamp_fog(qtri_large *t, int32_t n)
{
    const int32_t fog = (int32_t)t->fog, step = (int32_t)t->fog_step;
    const uint32_t speed = qtri_magnitude32(step);
    const int32_t over = fog < 0 ? fog : fog > FOG_FULL ? fog - FOG_FULL : 0;
    uint32_t most = (uint32_t)n;
    if (over != 0) {
        if ((over < 0) == (step > 0) && step != 0) {
            most = (qtri_magnitude32(over) + speed - 1) / speed;
        }
        t->fog = over < 0 ? 0 : FOG_FULL;
        t->fog_step = 0;
    } else if (step != 0) {
        most = (uint32_t)(step > 0 ? FOG_FULL - fog : fog) / speed + 1;
    }
    return most < (uint32_t)n ? (int32_t)most : n;
}

/* 2^14 rise part / 2^bits, to nearest: |rise| <= 2^16, |part| <= 2^31. */
static int32_t fog_of(const qtri_fog_stretch *s, int32_t part)
{
    return (int32_t)(((int64_t)s->rise * part * (1 << 14) + ((int64_t)1 << s->bits >> 1)) >>
                     s->bits);
}

/* Sets fog from column t->fog_x on: a line up to the end of the stretch. A rounded step strays by
   2^-7 of 1/256 over 2^10 pixels, from the stretch's first pixel in the whole row, so that what is
   drawn of the row does not matter. */
static void find_fog(qtri_large *t)
{
    const int32_t x = t->fog_x, by = (int32_t)(0 - t->z_step);
    const uint32_t speed = qtri_magnitude32(by);
    uint32_t passed = 0, n = (uint32_t)(t->row_right - x);
    qtri_fog_stretch s;
    qtri_fog_find_stretch(&s, t->state->fog, t->row_z + (uint32_t)x * t->z_step);
    const uint32_t ahead = by < 0 ? s.behind : s.ahead, behind = by < 0 ? s.ahead : s.behind;
    t->fog_step = (uint32_t)fog_of(&s, by);
    if (speed != 0 && ahead / speed < n) {
        n = ahead / speed + 1;
    }
    if (behind >= speed && speed != 0) {
        passed = behind / speed;
        passed = passed < (uint32_t)(x - t->row_left) ? passed : (uint32_t)(x - t->row_left);
    }
    t->fog = (uint32_t)(s.low * (1 << 14) + (1 << 13) + /* as qtri_fog_share() */
                        fog_of(&s, (int32_t)(s.behind - passed * (uint32_t)by))) +
             passed * t->fog_step;
    const int32_t end = s.low + s.rise;
    if ((s.low | end | (1024 - s.low) | (1024 - end)) < 0) {
        n = (uint32_t)clamp_fog(t, (int32_t)n);
    }
    t->fog += 0x8000u;
    t->fog_end = x + (int32_t)n;
}

int32_t qtri_large_next_fog(qtri_large *t, int32_t count)
{
    if (t->fog_x == t->fog_end) {
        find_fog(t);
    }
    const int32_t n = qtri_least32(count, t->fog_end - t->fog_x);
    t->fog_x += n;
    return n;
}
