/* SPDX-License-Identifier: MIT */
/*
 * Clamped textures on large triangles. A coordinate is inside of its zone, which ends 1/16 texel
 * before the texture does and filtered at the centres of its outer texels, or is clamped to one of
 * these ends, where it does not change. Pieces are cut into runs along which each coordinate stays
 * where it is, and pixels know nothing of it.
 *
 * Filtered coordinates count from texels' centres: from set-up on, or, where textures have levels,
 * once they are brought to one here.
 */
#include "large_setup.h"

typedef enum side { BELOW, INSIDE, ABOVE } side;

static inline side side_of(const qtri_large_zone *z, uint32_t at)
{
    const uint32_t from = at - z->least;
    return from <= z->size ? INSIDE : (int32_t)from < 0 ? BELOW : ABOVE;
}

/* A coordinate of a run, in the walk's units, clamped if it is on a side. */
static inline void to_walk(qtri_large_coordinate *c, const qtri_large_zone *z, side where)
{
    if (where == INSIDE) {
        c->at =
            qtri_both_shifts((int32_t)(c->at - z->least + z->start), z->shift_left, z->shift_right);
        c->step = qtri_both_shifts((int32_t)c->step, z->shift_left, z->shift_right);
        c->bend = qtri_both_shifts((int32_t)c->bend, z->shift_left, z->shift_right);
    } else {
        const uint32_t end = z->start + (where == BELOW ? 0 : z->size);
        c->at = qtri_both_shifts((int32_t)end, z->shift_left, z->shift_right);
        c->step = 0;
        c->bend = 0;
    }
}

/* Clamps all of a span if coordinates stay where they are, since what follows perspective goes one
   way along a row, and curves miss less of it than lies between a zone and the texture's ends.
   Without it a quad turned sideways takes 93 % more on a Cortex-M0+, 62 % on a Cortex-M3. */
static bool clamp_span(qtri_large_job *job, int32_t pieces)
{
    side where[2] = {INSIDE, INSIDE};
    if (job->row_is_linear || qtri_large_has_levels(job)) {
        return false;
    }
    for (int i = 0; i < 2; i++) {
        const qtri_large_attribute *a = &job->a[i];
        const qtri_large_zone *z = &job->axis[i].zone;
        if (job->axis[i].needs_clamp) {
            where[i] = side_of(z, job->piece[0].uv[i].at);
            if (where[i] !=
                side_of(z, qtri_both_shifts(a->point_quarter, a->at_left, a->at_right))) {
                return false;
            }
        }
    }
    for (int i = 0; i < 2; i++) {
        const qtri_large_zone *z = &job->axis[i].zone;
        if (job->axis[i].needs_clamp) {
            qtri_large_knots *knots = &job->piece[0].of.knots;
            to_walk(&job->piece[0].uv[i], z, where[i]);
            if (pieces == 2) {
                to_walk(&job->piece[1].uv[i], z, where[i]);
            } else if (job->has_knots) {
                knots->bend_gain[i] = where[i] == INSIDE ? knots->bend_gain[i] << z->shift_left : 0;
                knots->gain_loss[i] = where[i] == INSIDE ? knots->gain_loss[i] << z->shift_left : 0;
            }
        }
    }
    return true;
}

/* How many pixels, `count` at most, stay where the first is: as many as the greatest step of all
   cannot take across, so all that do where steps are equal. */
static uint32_t run_of(const qtri_large_zone *z, const qtri_large_coordinate *c, uint32_t count)
{
    const uint32_t from = c->at - z->least;
    const side where = side_of(z, c->at);
    const int32_t first = (int32_t)c->step, last = (int32_t)(c->step + c->bend * (count - 1));
    const bool rises = first > 0 || last > 0, falls = first < 0 || last < 0;
    const uint32_t most = (uint32_t)qtri_greatest32((int32_t)qtri_magnitude32(first),
                                                    (int32_t)qtri_magnitude32(last));
    uint32_t room = UINT32_MAX;
    if (rises && where != ABOVE) {
        room = where == BELOW ? 0u - from - 1 : z->size - from;
    }
    if (falls && where != BELOW) {
        const uint32_t below = where == ABOVE ? from - z->size - 1 : from;
        room = below < room ? below : room;
    }
    return qtri_mul_u32(most, count - 1) <= room ? count : room / most + 1;
}

/* Makes piece[0] its first run, up to a knot at most, and piece[2] the rest. */
static void take_run(qtri_large_job *job)
{
    qtri_large_piece *piece = &job->piece[0], *rest = &job->piece[2];
    uint32_t count = (uint32_t)piece->count;
    if (job->has_knots && piece->of.knots.next < piece->count) {
        count = (uint32_t)piece->of.knots.next;
    }
    for (int i = 0; i < 2 && count != 0; i++) {
        qtri_large_axis *axis = &job->axis[i];
        if (axis->needs_clamp) {
            if (qtri_large_has_levels(job)) {
                axis->zone = qtri_large_zone_of(job, i, piece->level);
            }
            count = run_of(&axis->zone, &piece->uv[i], count);
        }
    }
    if (count != (uint32_t)piece->count) {
        *rest = *piece;
        rest->count -= (int32_t)count;
        qtri_large_skip(job, rest, count);
        piece->count = (int32_t)count;
    }
    if (job->first_color == job->count) {
        piece->of.knots.next = piece->count;
    }
    for (int i = 0; i < 2; i++) {
        const qtri_large_zone *z = &job->axis[i].zone;
        if (job->axis[i].needs_clamp) {
            to_walk(&piece->uv[i], z, side_of(z, piece->uv[i].at));
        }
    }
}

/* The row goes on with what is left of pieces, else after them. */
static void go_on(qtri_large_job *job)
{
    job->t.x = job->piece[2].count != 0 || job->second_waits ? job->t.x1 - 1 : job->resume_x;
}

bool qtri_large_next_rest(qtri_large_job *job)
{
    if (job->piece[2].count != 0) {
        job->piece[0] = job->piece[2];
        job->piece[2].count = 0;
    } else if (job->second_waits) {
        job->piece[0] = job->piece[1];
        job->second_waits = false;
    } else {
        return false;
    }
    if (!clamp_span(job, 1)) {
        take_run(job);
    }
    go_on(job);
    return true;
}

int32_t qtri_large_clamp_pieces(qtri_large_job *job, int32_t pieces)
{
    if (clamp_span(job, pieces)) {
        return pieces;
    }
    job->resume_x = job->t.x;
    job->second_waits = pieces == 2;
    take_run(job);
    go_on(job);
    return 1;
}
