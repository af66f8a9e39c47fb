/* SPDX-License-Identifier: MIT */
/*
 * Levels along rows of large triangles: large_footprint.c says what is known of a triangle.
 *
 * Pieces are of level 0 as they come, and not cut: neither a band nor a scissor changes what level
 * a piece has, nor what rounding does where coordinates are brought to it.
 */
#include "large_setup.h"

enum {
    LEVEL_RUN_LOG2 = 7,  /* pixels along a row where w does not change that have one level */
    LEVEL_PIECE_LOG2 = 5 /* and elsewhere, at most */
};

/* Setting up ----------------------------------------------------------------------------------- */

/* 2^-12 texel a pixel, held to 2^30. slope: 2^-(32 + shift). */
static uint32_t linear_step(uint64_t slope, int32_t shift)
{
    const uint64_t size = qtri_magnitude64(qtri_wrap64(slope)) >> (20 + shift);
    return size >> 30 != 0 ? (uint32_t)1 << 30 : (uint32_t)size;
}

/* The level of coordinates that are linear. 5793 is 2^(1/2) 2^12. */
static uint32_t linear_level(const qtri_large_job *job, uint32_t last)
{
    uint32_t right[2], down[2];
    for (int i = 0; i < 2; i++) {
        const qtri_large_plane *plane = &job->a[i].plane;
        right[i] = linear_step(plane->dx, job->levels.axis[i].shift);
        down[i] = linear_step(plane->dy, job->levels.axis[i].shift);
    }
    const uint32_t across = qtri_step_length_of(right[0], right[1]);
    const uint32_t along = qtri_step_length_of(down[0], down[1]);
    const uint32_t length = across > along ? across : along;
    uint32_t level = 0;
    while (level < last && length >= (uint32_t)5793 << level) {
        level++;
    }
    return level;
}

static uint32_t down_of(const qtri_large_job *job, int i, uint32_t level)
{
    const uint32_t height_log2 = job->t.state->height_log2;
    return i == 1 && level > height_log2 ? height_log2 : level;
}

/* Whole repeats are counted in texels, a power of two each: nothing is lost. */
static void set_axes(qtri_large_job *job, uint32_t level)
{
    for (int i = 0; i < 2; i++) {
        const qtri_clamp_axis *from = &job->levels.axis[i];
        qtri_clamp_axis *axis = &job->t.axis[i];
        const uint32_t down = down_of(job, i, level);
        axis->shift = (uint8_t)(from->shift + down);
        axis->mask = (uint16_t)(from->mask >> down);
        axis->first = from->first >> down;
    }
}

void qtri_large_set_level(qtri_large *t, uint32_t level)
{
    qtri_draw_state_set_level(t->state, level);
    set_axes(qtri_large_job_of(t), level);
}

void qtri_large_set_levels(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    const qtri_draw_state *state = t->state;
    job->levels.axis[0] = t->axis[0];
    job->levels.axis[1] = t->axis[1];
    job->levels.only = 0;
    job->levels.y = -1;
    set_axes(job, state->level);
    t->piece[0].level = state->level;
    t->piece[1].level = state->level;
    if (!qtri_large_has_levels(job)) {
        return;
    }
    if (!job->is_curved) {
        job->levels.only = (uint8_t)linear_level(job, state->last_level);
        return;
    }
    const int32_t most = LEVEL_PIECE_LOG2;
    job->run_log2 = (uint8_t)qtri_least32(job->run_log2, LEVEL_RUN_LOG2);
    if (job->is_near) {
        job->near_log2 = (uint8_t)qtri_least32(job->near_log2, most);
    } else {
        job->piece_max = qtri_least32(job->piece_max, most);
        job->one_log2 = qtri_least32(job->one_log2, most);
    }
    qtri_large_set_footprint(&job->levels.footprint, job);
}

/* Along a row ---------------------------------------------------------------------------------- */

/* The longer of both steps at pixel x of the row. < 2^29 */
static inline uint32_t length_at(const qtri_footprint_plane *f, int32_t x)
{
    uint32_t down;
    if (f->straight) {
        down = f->along + (uint32_t)x * f->along_dx;
    } else {
        down = qtri_step_length_of(
            qtri_magnitude32((int32_t)(f->down[0] + (uint32_t)x * f->down_dx[0])),
            qtri_magnitude32((int32_t)(f->down[1] + (uint32_t)x * f->down_dx[1])));
    }
    return f->length > down ? f->length : down;
}

/*
 * A footprint is 2^(level + 1/2) texels or more, so that the level is left behind, where length >>
 * (before + 1 + level) is q's square or more: with 22 bits of that, 2^(20 + 2 zeros).
 */
static inline bool is_left(uint32_t length, uint32_t square, int32_t shift)
{
    if (shift >= 0) {
        return shift < 32 && square <= length >> shift;
    }
    return (square - 1) >> qtri_least32(-shift, 31) < length;
}

/* The level at pixel x of the row, where q is this; that of the piece before most often is. */
static uint32_t level_at(const qtri_large_job *job, int32_t x, uint32_t q)
{
    const qtri_footprint_plane *f = &job->levels.footprint;
    const qtri_draw_state *state = job->t.state;
    const int32_t zeros = qtri_clz32(q);
    const uint32_t q_q11 = q << zeros >> 21;
    const uint32_t square = q_q11 * q_q11, length = length_at(f, x);
    uint32_t level = job->t.piece[0].level;
    int32_t before = f->before - 2 * zeros + (int32_t)level;
    while (level < state->last_level && is_left(length, square, before + 1)) {
        before++;
        level++;
    }
    while (level > 0 && !is_left(length, square, before)) {
        before--;
        level--;
    }
    return level;
}

static void begin_row(qtri_large_job *job)
{
    qtri_footprint_plane *f = &job->levels.footprint;
    const uint32_t y = (uint32_t)job->t.y;
    job->levels.y = job->t.y;
    qtri_large_planes_move(job);
    f->length = qtri_step_length_of(qtri_magnitude32((int32_t)(f->right[0] + y * f->right_dy[0])),
                                    qtri_magnitude32((int32_t)(f->right[1] + y * f->right_dy[1])));
}

static uint32_t level_of(const qtri_large_job *job, int32_t x, int32_t count)
{
    const int32_t middle = x + (count >> 1);
    return level_at(job, middle, qtri_large_positive(qtri_large_plane_at(&job->q, middle)));
}

static inline uint32_t curve_down(uint32_t step, uint32_t down)
{
    // cppcheck-suppress shiftTooManyBitsSigned
    return (uint32_t)((int32_t)(step + ((uint32_t)1 << down >> 1)) >> down);
}

/*
 * Brings coordinates to the level. v, where it fills not all bits, has a texel's fraction that ends
 * two bits lower for each level, one where the height goes down no more. Steps are off by half of
 * the last bit, 2^-(17 + width_log2) of the level's texel: 128 pixels on by 2^-11 of one.
 */
static void set_level(const qtri_large_job *job, qtri_large_piece *piece, uint32_t level)
{
    const qtri_options *o = job->options;
    const qtri_draw_state *state = job->t.state;
    const uint32_t across = down_of(job, 1, level);
    piece->level = level;
    if (o->wrap_v != QTRI_CLAMP && !o->large_texture && level != 0) {
        const uint32_t down = level + across;
        piece->v >>= down;
        piece->v_step = curve_down(piece->v_step, down);
        piece->v_bend = curve_down(piece->v_bend, down);
    }
    if (o->bilinear) { /* from texels' centres */
        const uint32_t u_shift = o->wrap_u == QTRI_CLAMP ? job->levels.axis[0].shift + level
                                                         : 32u - state->width_log2 + level;
        const uint32_t v_shift = o->wrap_v == QTRI_CLAMP ? job->levels.axis[1].shift + across
                                 : o->large_texture      ? 32u - state->height_log2 + across
                                                         : 16u + state->width_log2 - level;
        piece->u -= (uint32_t)1 << (u_shift - 1);
        piece->v -= (uint32_t)1 << (v_shift - 1);
    }
}

/* Of pieces that begin at column x. */
static void set_levels(qtri_large_job *job, int32_t pieces, int32_t x)
{
    qtri_large_piece *piece = job->t.piece;
    if (!job->is_curved) {
        set_level(job, piece, job->levels.only);
        return;
    }
    if (job->levels.y != job->t.y) {
        begin_row(job);
    }
    for (int32_t i = 0; i < pieces; i++) {
        if (piece[i].count > 0) {
            set_level(job, &piece[i], level_of(job, x, piece[i].count));
            x += piece[i].count;
        }
    }
}

/* Where pieces began that were found last. */
static int32_t start_of(const qtri_large_job *job)
{
    if (job->is_curved && job->is_near) {
        return job->x - ((int32_t)1 << job->near_log2);
    }
    if (!job->is_curved || (job->may_be_level && job->is_level)) {
        return job->x - ((int32_t)1 << job->run_log2);
    }
    const int32_t last = job->x - 1, apart = job->h_log2 + 1;
    const int32_t chunk = job->row_left + ((last - job->row_left) & -(int32_t)QTRI_LARGE_CHUNK);
    return chunk + ((last - chunk) >> apart << apart);
}

int32_t qtri_large_next_levels(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    const int32_t pieces =
        job->options->linear ? qtri_large_linear_piece(job) : qtri_large_next_any(t);
    if (pieces == 0) {
        return 0;
    }
    int32_t x = start_of(job);
    if (qtri_large_has_levels(job)) {
        set_levels(job, pieces, x);
    }
    for (int32_t i = 0; i < pieces; i++) {
        const int32_t count = t->piece[i].count;
        if (x < t->x0 || x + count > t->x1) {
            qtri_large_cut(job, &t->piece[i], x);
        }
        x += count;
    }
    return pieces;
}
