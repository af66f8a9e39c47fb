/* SPDX-License-Identifier: MIT */
/*
 * Mipmaps: the footprint of large triangles with perspective, and levels along their rows.
 *
 * Pieces are of level 0 as they come, and not cut: neither a band nor a scissor changes what level
 * a piece has, nor what rounding does where coordinates are brought to it.
 */
#include "descriptions.h"
#include "large_setup.h"

/* The footprint ---------------------------------------------------------------------------------
 *
 * A texture coordinate u is S / Q of two that are linear on the screen: with weights b_i of the
 * vertices, Q = sum b_i q_i, S = sum b_i q_i u_i. Its steps to the right and down are K / Q^2 and
 * M / Q^2 with
 *
 *     K = S_x Q - S Q_x = sum over i j of (b_i,x b_j - b_j,x b_i) q_i q_j (u_i - u_j)
 *
 * over the three sides, in their order. Weights i and j are both 0 at the third vertex k, and a is
 * twice the area: b_i,x b_j - b_j,x b_i = (y - y_k) / a, and for M it is -(x - x_k) / a. So with
 * P_k = q_i q_j (u_i - u_j), all exact from the vertices,
 *
 *     K = (y sum P_k - sum P_k y_k) / a          M = -(x sum P_k - sum P_k x_k) / a
 *
 * K does not change along a row nor M along a column; and what K grows by in a row M loses in a
 * column. So the footprint of a piece of a row is one sum for each coordinate, a length, and q in
 * its middle.
 */

/* K and M of a coordinate in the triangle's first and last row in the frame, and column. */
typedef struct ends {
    int64_t right[2], down[2]; /* times the area, 2^exponent */
    int64_t slope;             /* of `right`, a row */
    int32_t exponent;
} ends;

typedef struct frame {
    int32_t row[2], column[2];
    uint32_t qq[3]; /* q_i q_j 2^-32 < 2^30 */
} frame;

static void set_range(int32_t range[2], int32_t least_24p8, int32_t size_24p8, int32_t count)
{
    range[0] = qtri_hold32(qtri_large_first_center(least_24p8), 0, count - 1);
    range[1] =
        qtri_hold32(qtri_large_first_center(least_24p8 + size_24p8) - 1, range[0], count - 1);
}

static void set_frame(frame *f, const qtri_large_job *job)
{
    const uint32_t *q = job->vertex_q;
    const qtri_surface *surface = job->t.state->surface;
    set_range(f->row, job->t.y_least, job->t.height,
              qtri_least32(surface->height, QTRI_SURFACE_MAX));
    set_range(f->column, job->t.x_least, job->t.width, job->t.frame_width);
    for (int k = 0; k < 3; k++) {
        f->qq[k] = qtri_mul_high32(q[k == 2 ? 0 : k + 1], q[k == 0 ? 2 : k - 1]);
    }
}

/*
 * |u_i - u_j| < 2^30, so P < 2^60, which is brought below 2^36; places are at most 2^22 1/256
 * pixels away from the frame's corner: sums are below 2^36 2^22 3 and twice that.
 */
static void set_ends(ends *e, const frame *f, const qtri_large_job *job,
                     const qtri_large_attribute *a, int32_t texel_shift)
{
    const int32_t *x = job->t.corner_x, *y = job->t.corner_y;
    int64_t p[3];
    uint64_t all = 1;
    for (int k = 0; k < 3; k++) {
        const uint32_t from = a->f[k == 2 ? 0 : k + 1], to = a->f[k == 0 ? 2 : k - 1];
        p[k] = qtri_mul_s32((int32_t)f->qq[k], (int32_t)(from - to));
        all |= qtri_magnitude64(p[k]);
    }
    const int32_t down = qtri_greatest32(28 - qtri_clz64(all), 0);
    int64_t sum = 0, along_x = 0, along_y = 0;
    for (int k = 0; k < 3; k++) {
        const int64_t part = p[k] >> down;
        sum += part;
        along_x += part * x[k];
        along_y += part * y[k];
    }
    for (int k = 0; k < 2; k++) {
        e->right[k] = sum * (f->row[k] * 256 + 128) - along_y;
        e->down[k] = along_x - sum * (f->column[k] * 256 + 128);
    }
    e->slope = sum * 256;
    e->exponent = down - texel_shift;
}

/* 2^-down x, which is below 2^30, times `factor` 2^-31. */
static int32_t scaled(int64_t x, int32_t down, int32_t factor)
{
    return (int32_t)(qtri_mul_s32((int32_t)(x >> down), factor) >> 31);
}

/*
 * In texels a pixel, of a coordinate that has 2^texel_shift a texel, x of `ends` is
 *
 *     x 2^(exponent + 32 + 8) / area / q^2 = x r 2^(exponent + 40 - 94 + zeros) / q^2
 *
 * with r = 2^62 / (area 2^(zeros - 32)). In 30 bits of x, of the greatest of both ends, and r /
 * 2^(1/2) 2^-31, the product is below 2^30, and two bits more go; q has q_up bits that q_at has
 * not. The level is left behind where that is 2^(level + 2 zeros of q) times q's square or more,
 * which has 22 of 64 bits: see is_left().
 */
static void set_footprint(qtri_footprint_plane *out, const qtri_large_job *job)
{
    frame f;
    ends e[2];
    int32_t bits[2], exponent[2];
    const uint64_t size = qtri_magnitude64(job->t.area);
    const int32_t zeros = qtri_clz64(size);
    const uint32_t r = qtri_reciprocal_near((uint32_t)(size << (zeros & 63) >> 32));
    const int32_t factor = (int32_t)qtri_mul_high32(r, 3037000500u); /* 2^31.5 */
    set_frame(&f, job);
    for (int i = 0; i < 2; i++) {
        set_ends(&e[i], &f, job, &job->a[i], job->axis[i].texel_shift);
        const uint64_t all = qtri_magnitude64(e[i].right[0]) | qtri_magnitude64(e[i].right[1]) |
                             qtri_magnitude64(e[i].down[0]) | qtri_magnitude64(e[i].down[1]);
        bits[i] = qtri_greatest32(64 - qtri_clz64(all | 1), 30);
        exponent[i] = e[i].exponent + bits[i] - 30 + 31 - 54 + zeros;
    }
    const int32_t most = qtri_greatest32(exponent[0], exponent[1]) + 2;
    const bool varies = f.row[0] != f.row[1] || f.column[0] != f.column[1];
    for (int i = 0; i < 2; i++) {
        const int32_t by = qtri_least32(most - exponent[i], 31);
        const int32_t down = bits[i] - 30;
        const int32_t slope = varies ? scaled(e[i].slope, down, factor) >> by : 0;
        out->right_dy[i] = (uint32_t)slope;
        out->down_dx[i] = 0u - (uint32_t)slope;
        out->right[i] = (uint32_t)(scaled(e[i].right[0], down, factor) >> by) -
                        (uint32_t)f.row[0] * out->right_dy[i];
        out->down[i] = (uint32_t)(scaled(e[i].down[0], down, factor) >> by) -
                       (uint32_t)f.column[0] * out->down_dx[i];
    }
    out->before = -most + 41 - 2 * job->q_headroom;
}

enum {
    LEVEL_RUN_LOG2 = 7,   /* pixels along a row where w does not change that have one level */
    LEVEL_PIECE_LOG2 = 5, /* and elsewhere, at most */
    EVEN_DELTA = 1 << 13  /* 1/8 of q, Q16 */
};

/* Setting up ----------------------------------------------------------------------------------- */

/* Levels that can be used besides the first: their widths are 2 texels or more. */
static uint8_t last_level(const qtri_texture *texture)
{
    const int32_t width_log2 = qtri_side_log2(texture->width_log2);
    uint8_t last = 0;
    if (texture->levels != NULL) {
        while (last + 1 < width_log2 && last < texture->level_count &&
               texture->levels[last] != NULL) {
            last++;
        }
    }
    return last;
}

static void begin_levels(qtri_draw_state *state)
{
    state->level_texture = *state->texture;
    state->last_level = last_level(state->texture);
    state->texture = &state->level_texture;
    qtri_draw_state_set_level(state, 0);
}

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
        right[i] = linear_step(plane->dx, job->axis[i].texel_shift);
        down[i] = linear_step(plane->dy, job->axis[i].texel_shift);
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

static void set_levels(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    const qtri_draw_state *state = t->state;
    job->levels->only = 0;
    job->levels->are_found = false;
    job->piece[0].level = state->level;
    job->piece[1].level = state->level;
    if (!qtri_large_has_levels(job)) {
        return;
    }
    if (!job->is_curved) {
        job->levels->only = (uint8_t)linear_level(job, state->last_level);
        return;
    }
    const int32_t most = LEVEL_PIECE_LOG2 + 1;
    job->levels->are_found = true;
    job->levels->run_log2 = (uint8_t)qtri_least32(job->run_log2, LEVEL_RUN_LOG2);
    job->span_log2_max = qtri_least32(job->span_log2_max, most);
    job->fixed_span_log2 = qtri_least32(job->fixed_span_log2, most);
    set_footprint(&job->levels->footprint, job);
}

/* Along a row ---------------------------------------------------------------------------------- */

/* The longer of both steps at pixel x of the row. < 2^29 */
static inline uint32_t length_at(const qtri_footprint_plane *f, int32_t x)
{
    const uint32_t down =
        qtri_step_length(qtri_magnitude32((int32_t)(f->down[0] + (uint32_t)x * f->down_dx[0])),
                         qtri_magnitude32((int32_t)(f->down[1] + (uint32_t)x * f->down_dx[1])));
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

typedef qtri_footprint_measure measure;

/* `zeros`: those of q, or of what is 3/4 to 4/3 of it. */
static inline measure measure_of(const qtri_footprint_plane *f, uint32_t q, int32_t zeros)
{
    const uint32_t q_q11 = (q >> 1) << zeros >> 20; /* 2^9.5..2^11.5 */
    const measure m = {q_q11 * q_q11, f->before - 2 * zeros};
    return m;
}

static inline measure measure_at(const qtri_large_job *job, int32_t x)
{
    const uint32_t q = qtri_large_positive(qtri_large_plane_at(&job->q, x));
    return measure_of(&job->levels->footprint, q, qtri_clz32(q));
}

QTRI_NOINLINE static uint32_t find_level(const measure *m, uint32_t length, uint32_t level,
                                         uint32_t last)
{
    int32_t before = m->before + (int32_t)level;
    while (level < last && is_left(length, m->square, before + 1)) {
        before++;
        level++;
    }
    while (level > 0 && !is_left(length, m->square, before)) {
        before--;
        level--;
    }
    return level;
}

/* The level at pixel x of the row; `level`, that of what was drawn before, most often is. */
static inline uint32_t level_at(const qtri_large_job *job, const measure *m, int32_t x,
                                uint32_t level)
{
    const uint32_t length = length_at(&job->levels->footprint, x);
    const uint32_t last = job->t.state->last_level;
    const uint32_t before = (uint32_t)m->before + level;
    if (before < 31) {
        const uint32_t most = length >> before;
        if (m->square > most ? level == 0 : m->square > most >> 1 || level == last) {
            return level;
        }
    }
    const measure copy = *m; /* or all of it would be in memory */
    return find_level(&copy, length, level, last);
}

static void begin_row(qtri_large_job *job)
{
    qtri_footprint_plane *f = &job->levels->footprint;
    const uint32_t y = (uint32_t)job->t.y;
    f->length = qtri_step_length(qtri_magnitude32((int32_t)(f->right[0] + y * f->right_dy[0])),
                                 qtri_magnitude32((int32_t)(f->right[1] + y * f->right_dy[1])));
}

/* Coordinates count from texels' centres. */
QTRI_NOINLINE static void center(const qtri_large_job *job, qtri_large_piece *piece, uint32_t level)
{
    const qtri_options *o = job->t.options;
    const qtri_draw_state *state = job->t.state;
    const uint32_t across = qtri_large_level_down(job, 1, level);
    const uint32_t u_shift = 32u - state->width_log2 + level;
    const uint32_t v_shift =
        o->large_texture ? 32u - state->height_log2 + across : 16u + state->width_log2 - level;
    piece->uv[0].at -= job->axis[0].needs_clamp ? 0 : (uint32_t)1 << (u_shift - 1);
    piece->uv[1].at -= job->axis[1].needs_clamp ? 0 : (uint32_t)1 << (v_shift - 1);
}

static inline uint32_t curve_down(uint32_t step, uint32_t down)
{
    // cppcheck-suppress shiftTooManyBitsSigned
    return (uint32_t)((int32_t)(step + ((uint32_t)1 << down >> 1)) >> down);
}

/*
 * Brings coordinates to the level, but those that are yet to be clamped. v, where it fills not all
 * bits, has a texel's fraction that ends two bits lower for each level, one where the height goes
 * down no more. Steps are off by half of the last bit, 2^-(17 + width_log2) of the level's texel:
 * 128 pixels on by 2^-11 of one.
 */
static inline void set_level(const qtri_large_job *job, qtri_large_piece *piece, uint32_t level)
{
    const qtri_options *o = job->t.options;
    piece->level = level;
    if (level != 0 && !job->axis[1].needs_clamp && !o->large_texture) {
        const uint32_t down = level + qtri_large_level_down(job, 1, level);
        piece->uv[1].at >>= down;
        piece->uv[1].step = curve_down(piece->uv[1].step, down);
        piece->uv[1].bend = curve_down(piece->uv[1].bend, down);
    }
    if (o->bilinear) {
        center(job, piece, level);
    }
}

/* Of a piece from column x on, which has its level. */
static inline void cut(qtri_large_job *job, qtri_large_piece *piece, int32_t x)
{
    if (x < job->t.x0 || x + piece->count > job->t.x1) {
        qtri_large_cut(job, piece, x);
    }
}

/* Rows along which w does not change ----------------------------------------------------------- */

static inline int32_t run_of(const qtri_large_job *job)
{
    return (int32_t)1 << job->levels->run_log2;
}

/* Of the run that begins at column x. */
static inline uint32_t run_level(const qtri_large_job *job, int32_t x, uint32_t level)
{
    const int32_t count = qtri_least32(run_of(job), job->t.row_right - x);
    return level_at(job, &job->levels->measure, x + (count >> 1), level);
}

static void begin_linear_row(qtri_large_job *job)
{
    job->levels->measure = measure_at(job, job->t.row_left);
    job->levels->only = (uint8_t)run_level(job, job->t.row_left, job->levels->only);
    job->t.x = job->t.row_left;
}

/* Colours that are linear along the row, where it is `skipped` pixels on. */
QTRI_NOINLINE static void set_colors(qtri_large_job *job, qtri_large_piece *piece, uint32_t skipped)
{
    for (int i = job->first_color; i < job->count; i++) {
        job->a[i].at += job->a[i].step * skipped;
    }
    qtri_large_pack_linear(job, piece);
    for (int i = job->first_color; i < job->count; i++) {
        job->a[i].at -= job->a[i].step * skipped;
    }
}

/* Runs that have one level are a piece, but where colours are not stepped as far, from the row's
   left end on: what rounding does where it begins depends on neither band nor scissor. */
static int32_t linear_row_piece(qtri_large_job *job)
{
    qtri_large_levels *levels = job->levels;
    qtri_large_piece *piece = job->piece;
    const int32_t run = run_of(job), right = job->t.row_right;
    int32_t x, end = job->t.x;
    uint32_t level, next = levels->only;
    do {
        x = end;
        level = next;
        for (end += run; end < right; end += run) {
            next = run_level(job, end, level);
            if (next != level || job->run_log2 <= job->levels->run_log2) {
                break;
            }
        }
    } while (end <= job->t.x0);
    job->t.x = end;
    levels->only = (uint8_t)next;
    const uint32_t skipped = (uint32_t)(x - job->t.row_left);
    piece->count = qtri_least32(end, right) - x;
    qtri_large_set_straight(job, piece, skipped);
    if (job->first_color != job->count) {
        set_colors(job, piece, skipped);
    }
    set_level(job, piece, level);
    cut(job, piece, x);
    return 1;
}

/* Other rows ----------------------------------------------------------------------------------- */

/* Pieces of which one or both are short, or along which q varies more. */
QTRI_NOINLINE static void set_apart(qtri_large_job *job, int32_t pieces, int32_t x)
{
    qtri_large_piece *piece = job->piece;
    uint32_t level = piece->level;
    for (int32_t i = 0; i < pieces; i++) {
        const int32_t count = piece[i].count, middle = x + (count >> 1);
        if (count > 0) {
            const measure m = measure_at(job, middle);
            level = level_at(job, &m, middle, level);
        }
        set_level(job, &piece[i], level);
        cut(job, &piece[i], x);
        x += count;
    }
}

/* Two pieces along which q varies by 1/8 to both sides at most have one level, that in the middle,
   which is one and a half steps before the next point. */
static int32_t curved_pieces(qtri_large_job *job)
{
    const int32_t pieces =
        job->first_color == job->count ? qtri_large_next_halves(job) : qtri_large_find_pieces(job);
    qtri_large_piece *piece = job->piece;
    const int32_t h = piece[0].count;
    if (pieces == 1 || piece[1].count != h ||
        (uint32_t)(job->relative_q_rise + EVEN_DELTA) > 2 * EVEN_DELTA) {
        set_apart(job, pieces, job->t.x - h - (pieces == 1 ? 0 : piece[1].count));
        return pieces;
    }
    const int32_t middle = job->t.x - h;
    const uint64_t step = job->q.s_step;
    const uint32_t q = qtri_large_whole(job->q.s - step - (uint64_t)(qtri_wrap64(step) >> 1));
    const measure m = measure_of(&job->levels->footprint, q, job->q_zeros);
    const uint32_t level = level_at(job, &m, middle, piece[0].level);
    set_level(job, &piece[0], level);
    set_level(job, &piece[1], level);
    cut(job, &piece[0], middle - h);
    cut(job, &piece[1], middle);
    return 2;
}

/* No levels, or one for all of the triangle: pieces as they come. */
static int32_t plain_pieces(qtri_large_job *job)
{
    const int32_t pieces = qtri_large_find_pieces(job);
    if (qtri_large_has_levels(job)) {
        set_level(job, job->piece, job->levels->only);
        cut(job, job->piece, job->t.x - ((int32_t)1 << job->run_log2));
    }
    return pieces;
}

static int32_t find_pieces(qtri_large_job *job)
{
    if (!job->levels->are_found) {
        return plain_pieces(job);
    }
    if (job->t.is_new) {
        begin_row(job);
        if (job->rows_may_be_linear) {
            qtri_large_planes_move(job);
            qtri_large_begin_linear_row(job);
            if (job->row_is_linear) {
                job->t.is_new = false;
                begin_linear_row(job);
            }
        }
    }
    return job->row_is_linear ? linear_row_piece(job) : curved_pieces(job);
}

static int32_t next_pieces(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    if (job->needs_clamp && qtri_large_next_rest(job)) {
        return 1;
    }
    const int32_t pieces = find_pieces(job);
    return job->needs_clamp ? qtri_large_clamp_pieces(job, pieces) : pieces;
}

const qtri_level_ops qtri_levels = {begin_levels, qtri_small_find_level, set_levels, next_pieces};
