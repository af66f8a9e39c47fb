/* SPDX-License-Identifier: MIT */
/*
 * Triangles along which 1/w varies by up to 1/16, as those of meshes. With X, Y from the middle,
 * e = (q - Q) / Q and l the linear part of an attribute there, it is
 *
 *     c + l / (1 + e) = c + l (1 - e + e^2 - ...)
 *
 * which is a polynomial of second order. What it leaves out, l e^2, is less than E^2 l; 3/4 E^2 l
 * is added, which leaves a quarter of that.
 */
#include "large_setup.h"

enum { NEAR_STEP_LOG2 = 6 /* coordinates may stray by 2^-this of a pixel's step, and a texel */ };

static uint32_t at_middle(const qtri_large_job *job, const qtri_large_plane *p)
{
    const uint64_t more = (uint64_t)(int64_t)(job->middle_y - job->plane_y) * p->dy;
    return qtri_large_plane_at(p, job->middle_x) + qtri_large_whole(more);
}

/* Whether x 2^zeros fits: not where triangles are thin. */
static bool fits(uint32_t x, int32_t zeros)
{
    return qtri_magnitude32((int32_t)x) >> (30 - zeros) == 0;
}

static bool set_polynomial(const qtri_large_job *job, qtri_large_attribute *a, int32_t reciprocal,
                           const int32_t d[2], int32_t e2)
{
    const int32_t zeros = job->zeros, up = a->up + 2;
    const int32_t c =
        qtri_large_quotient((uint64_t)at_middle(job, &a->plane) << 32, zeros, reciprocal);
    const uint64_t steps[2] = {a->plane.dx, a->plane.dy}, q_steps[2] = {job->q.dx, job->q.dy};
    int32_t slope[2];
    for (int k = 0; k < 2; k++) {
        const int32_t part =
            (int32_t)(qtri_mul_s32(c, (int32_t)qtri_large_whole(q_steps[k])) >> 30);
        const uint32_t s = qtri_large_whole(steps[k]) - (uint32_t)part;
        if (!fits(s, zeros)) {
            return false;
        }
        slope[k] = qtri_large_quotient((uint64_t)s << 32, zeros, reciprocal);
    }
    a->xx = qtri_large_shift((uint32_t)(-2 * qtri_mul_s16(slope[0], d[0])), up);
    a->xy = qtri_large_shift(
        (uint32_t)(-2 * (qtri_mul_s16(slope[0], d[1]) + qtri_mul_s16(slope[1], d[0]))), up);
    a->yy = qtri_large_shift((uint32_t)(-2 * qtri_mul_s16(slope[1], d[1])), up);
    a->x = qtri_large_shift((uint32_t)(slope[0] + qtri_mul_s16(slope[0], 3 * e2 >> 2)), up);
    a->y = qtri_large_shift((uint32_t)(slope[1] + qtri_mul_s16(slope[1], 3 * e2 >> 2)), up);
    a->c = qtri_large_shift((uint32_t)c, up) + a->start;
    return true;
}

/* A chord over n pixels is off by xx n^2 / 4. */
static void set_run(qtri_large_job *job)
{
    const int32_t bound = qtri_large_chord_bound_log2(job) + 2;
    uint32_t bends = 0;
    for (int i = job->first_color; i < job->count; i++) {
        bends |= qtri_magnitude32((int32_t)job->a[i].xx);
    }
    const int32_t most = (bound - (32 - qtri_clz32(bends))) >> 1;
    job->near_log2 = (uint8_t)qtri_hold32(most, 0, job->run_log2);
}

bool qtri_large_set_near(qtri_large_job *job)
{
    const uint32_t q = qtri_large_positive(at_middle(job, &job->q));
    uint32_t most = 0;
    for (int k = 0; k < 3; k++) {
        const uint64_t at = (uint64_t)job->q_at[k] << job->q_up;
        const uint64_t away = at > q ? at - q : q - at;
        if (away > q >> 4) {
            return false;
        }
        most = (uint32_t)away > most ? (uint32_t)away : most;
    }
    const int32_t reciprocal = qtri_large_reciprocal(job, (uint64_t)q << 32);
    const int32_t zeros = job->zeros, half = reciprocal >> 16;
    if (zeros > 30 || !fits(qtri_large_whole(job->q.dx), zeros) ||
        !fits(qtri_large_whole(job->q.dy), zeros)) {
        return false;
    }
    const int32_t e = (int32_t)(((most << zeros) >> 15) * (uint32_t)half >> 15); /* Q16 */
    const int32_t e2 = e * e >> 16;
    const int32_t texels = qtri_least32(qtri_large_texels_log2(job, q - most), 16);
    if ((uint32_t)e2 * (uint32_t)job->pixels > (uint32_t)65536 >> (NEAR_STEP_LOG2 - 3 + texels)) {
        return false; /* half the width, a quarter of e^2 of it */
    }
    const int32_t d[2] = {/* half of e's slopes */
                          ((int32_t)(qtri_large_whole(job->q.dx) << zeros) >> 16) * half >> 15,
                          ((int32_t)(qtri_large_whole(job->q.dy) << zeros) >> 16) * half >> 15};
    for (int i = 0; i < job->count; i++) {
        if (!set_polynomial(job, &job->a[i], reciprocal, d, e2)) {
            return false;
        }
    }
    set_run(job);
    return true;
}

static void hold_chord(const qtri_large_attribute *a, uint32_t *at, uint32_t *step, int32_t count)
{
    const int32_t least = (int32_t)a->start, most = (int32_t)(a->start + a->most - a->least);
    const int32_t from = qtri_hold32((int32_t)*at, least, most);
    const int32_t end = from + (int32_t)*step * (count - 1);
    const int32_t to = qtri_hold32(end, least, most);
    if (to != end) { /* rare */
        *step = (uint32_t)((to - from) / (count - 1));
    }
    *at = (uint32_t)from;
}

int32_t qtri_large_near_piece(qtri_large_job *job)
{
    qtri_large_piece *piece = &job->t.piece[0];
    uint32_t at[QTRI_LARGE_ATTRIBUTES], step[QTRI_LARGE_ATTRIBUTES];
    uint32_t bend[2] = {0, 0};
    at[0] = 0;
    at[1] = 0;
    step[0] = 0;
    step[1] = 0;
    const int32_t run = (int32_t)1 << job->near_log2;
    if (job->is_new) {
        job->is_new = false;
        job->t.x =
            job->row_left + ((job->t.x0 - job->row_left) >> job->near_log2 << job->near_log2);
    }
    const int32_t n = qtri_least32(run, job->row_right - job->t.x);
    const uint32_t x = (uint32_t)(job->t.x - job->middle_x);
    const uint32_t y = (uint32_t)(job->t.y - job->middle_y);
    for (int i = 0; i < job->count; i++) {
        const qtri_large_attribute *a = &job->a[i];
        const uint32_t slope = a->x + a->xy * y + a->xx * x;
        at[i] = a->c + slope * x + (a->y + a->yy * y) * y;
        if (i < job->first_color) {
            step[i] = slope + a->xx * (x + 1);
            bend[i] = 2 * a->xx;
        } else {
            step[i] = slope + a->xx * (x + (uint32_t)n);
            hold_chord(a, &at[i], &step[i], n);
        }
    }
    if (job->first_color != 0) {
        piece->u = at[0];
        piece->v = at[1];
        piece->u_step = step[0];
        piece->v_step = step[1];
        piece->u_bend = bend[0];
        piece->v_bend = bend[1];
    }
    if (job->first_color != job->count) {
        qtri_large_pack(job, piece, at, step, n);
    }
    piece->count = n;
    if (job->t.x < job->t.x0 || job->t.x + n > job->t.x1) {
        qtri_large_clip(job, piece, job->t.x);
    }
    job->t.x += run;
    return 1;
}
