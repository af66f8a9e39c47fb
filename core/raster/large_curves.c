/* SPDX-License-Identifier: MIT */
/*
 * Perspective along rows. An attribute is s / q, both linear on the screen, and so a + b / q. It is
 * found by one reciprocal at points that are two pieces apart, counted from the left end of the
 * span; along a piece a coordinate is the parabola through both ends and the exact middle, colours
 * are the chord. With eps = (q1 - q0) / (q1 + q0) between two points and `rise` the difference of
 * an attribute, the middle is w / 2 above that of the chord, w = rise eps; of the chord of half of
 * it about w / 8, so that colours are w / 16 more than their chords. Points lie two pieces apart
 * and the middle is where the first piece ends, of which
 *
 *     eps1 = eps / (2 - eps),   eps2 = eps / (2 + eps).
 *
 * Along a piece of h pixels
 *
 *     step = (rise + 2 w) / h + bend / 2,   bend = -4 w / h^2.
 */
#include "large_setup.h"

/* Lengths ----------------------------------------------------------------------------------------
 *
 * With L the step of the coordinate and e = q' / q the parabola is off by .048 L e^2 h^3: h is the
 * greatest power of two for which that is below 2^-7 of L, and of a texel.
 *
 * A step has half of the bend, 2 L e at most, which wraps with the coordinate: where that may be
 * half a repeat, h is 1, and no pixel is a step away from where its piece begins.
 */
enum {
    STEP_BOUND = -671, /* 256 log2(2^-7 / .048): of a step, and of a texel where steps are longer */
    WRAP_BOUND = -512, /* 256 log2(1/4): of L e, in repeats */
    LOG2_ERROR = 22    /* of log2_q8(), 1/256 */
};

/* log2 x in 1/256, at most LOG2_ERROR too little: the mantissa in place of its logarithm. */
static int32_t log2_q8(uint32_t x)
{
    const int32_t zeros = qtri_clz32(x | 1);
    return (31 - zeros) * 256 + (int32_t)((x << zeros & 0x7FFFFFFFu) >> 23);
}

static uint32_t slope_of(uint64_t dx)
{
    return qtri_magnitude32((int32_t)qtri_large_whole(dx)) + 1;
}

/* log2 of the texels that a pixel steps where q is this or more, 1/256; 0 where it is one. */
static int32_t texels_for(const qtri_large_job *job, uint32_t q)
{
    return qtri_greatest32(job->texel_log2 - log2_q8(q), 0);
}

/* log2 of a piece's pixels where q is this or more; may be negative. Points a piece apart must have
   q' 4 h <= q, so that q is positive at the point behind a row's end. */
static int32_t length_for(const qtri_large_job *job, uint32_t q)
{
    const int32_t inverse_e = log2_q8(q) - job->q_slope_log2;
    int32_t bound = STEP_BOUND;
    if (job->first_color != 0) {
        bound -= texels_for(job, q);
    }
    int32_t log2 = (2 * inverse_e + bound) * 85 >> 8; /* / 3 */
    log2 = qtri_least32(log2, inverse_e - 512);
    if (job->first_color != 0 && job->repeat_log2 - log2_q8(q) - inverse_e >= WRAP_BOUND) {
        log2 = qtri_least32(log2, 255); /* of one pixel */
    }
    if (job->first_color != job->count) { /* chords: q'/q h^2 c'/8 <= bound, c' <= slope / q */
        const int32_t color = (2 * log2_q8(q) - job->q_slope_log2 + job->chord_log2) >> 1;
        log2 = qtri_least32(log2, color);
    }
    return log2 >> 8;
}

/* log2 of the greatest slope of coordinates times q along rows, in repeats 2^32 and in texels; of
   levels steps are about a texel. */
static void set_texel_slope(qtri_large_job *job)
{
    const uint32_t q_slope = slope_of(job->q.dx);
    int32_t most = 0, most_repeats = 0;
    for (int i = 0; i < job->first_color; i++) {
        const qtri_large_attribute *a = &job->a[i];
        uint32_t least, greatest;
        qtri_find_range(&least, &greatest, a->f);
        const uint32_t slope =
            (slope_of(a->along.plane.dx) >> 1) + (qtri_mul_high32(greatest, q_slope) >> 1) + 1;
        const int32_t log2 = log2_q8(slope) + LOG2_ERROR + (33 - job->axis[i].shift) * 256;
        const int32_t side_log2 = i == 0 ? job->t.state->width_log2 : job->t.state->height_log2;
        most = qtri_greatest32(log2, most);
        most_repeats = qtri_greatest32(log2 - side_log2 * 256, most_repeats);
    }
    job->repeat_log2 = (int16_t)most_repeats;
    job->texel_log2 = (int16_t)(qtri_large_has_levels(job) ? INT16_MIN : most);
}

/* The greatest slope of colours times q, and what of it comes of q. */
static int32_t chord_log2(const qtri_large_job *job)
{
    uint32_t most = 1;
    const uint32_t q_slope = slope_of(job->q.dx);
    for (int i = job->first_color; i < job->count; i++) {
        const qtri_large_attribute *a = &job->a[i];
        const uint32_t range = (a->most - a->least) << QTRI_LARGE_COLOR_UP;
        const uint32_t slope = slope_of(a->along.plane.dx) + qtri_mul_high32(range, q_slope) + 1;
        most = slope > most ? slope : most;
    }
    const int32_t bound = 3 + qtri_large_chord_bound_log2(job) + QTRI_LARGE_COLOR_UP - 32;
    return bound * 256 - log2_q8(most) - LOG2_ERROR;
}

static void set_lengths(qtri_large_job *job)
{
    const uint32_t slope = slope_of(job->q.dx);
    uint32_t least = UINT32_MAX;
    job->q_slope_log2 = (int16_t)(log2_q8(slope) + LOG2_ERROR);
    job->chord_log2 = (int16_t)chord_log2(job);
    set_texel_slope(job);
    const uint64_t steep = qtri_magnitude64(qtri_wrap64(job->q.dx)) >> 16; /* 2^-16 */
    job->may_be_level = steep >> 16 == 0;
    job->steep = (uint32_t)steep;
    job->level_log2 = QTRI_LARGE_NO_LEVEL;
    job->steps_log2 = QTRI_LARGE_NO_LEVEL;
    for (int k = 0; k < 3; k++) {
        const uint64_t q = (uint64_t)job->q_at[k] << job->q_up;
        least = q < least ? (uint32_t)q : least;
    }
    least -= job->t.is_true ? least >> 5 : 0;
    const int32_t log2 = length_for(job, least);
    job->piece_max = qtri_least32(job->run_log2, job->rounds ? QTRI_LARGE_RUN_LOG2 - 1
                                                             : QTRI_LARGE_CHUNK_LOG2 - 1);
    job->one_log2 = log2 >= job->piece_max                      ? job->piece_max
                    : log2 >= 0 && (job->t.pixels >> log2) == 0 ? log2
                                                                : -1;
    for (int i = 0; i < job->count; i++) {
        job->a[i].at_left = (uint8_t)qtri_greatest32(job->a[i].up + 2, 0);
        job->a[i].at_right = (uint8_t)qtri_greatest32(-(job->a[i].up + 2), 0);
    }
}

/* Points ------------------------------------------------------------------------------------------
 */

/* floor(a b / 2^32), 0 <= b. */
static inline int32_t mul_high(int32_t a, int32_t b)
{
#if QTRI_LONG_MULTIPLY
    return (int32_t)(qtri_mul_s32(a, b) >> 32);
#else
    return qtri_mul_high_s31(a, (uint32_t)b);
#endif
}

/* s 2^zeros, 32 bits of it. */
static inline uint32_t shifted_left(uint64_t s, int32_t zeros)
{
    return qtri_large_whole(s) << zeros | (uint32_t)s >> 1 >> (31 - zeros);
}

/* 2^62 / q 2^zeros, below 2^31; sets job->zeros. q: 2^-32. */
static inline int32_t reciprocal_of(qtri_large_job *job, uint64_t q_q32)
{
    const uint32_t q = qtri_large_positive(qtri_large_whole(q_q32));
#if QTRI_LONG_MULTIPLY
    const int32_t zeros = qtri_clz32(q);
#else
    int32_t zeros = job->zeros; /* of the point before nearly as many */
    while (q >> (31 - zeros) > 1) {
        zeros--;
    }
    while ((int32_t)(q << zeros) >= 0) {
        zeros++;
    }
#endif
    job->zeros = zeros;
    const uint32_t r = qtri_reciprocal_near(q << zeros | (uint32_t)q_q32 >> 1 >> (31 - zeros));
    return (int32_t)(r - (r >> 31));
}

/* A quarter of what is s / q; s 2^-32. */
static inline int32_t quotient_of(uint64_t s, int32_t zeros, int32_t reciprocal)
{
    return mul_high((int32_t)shifted_left(s, zeros), reciprocal);
}

static int32_t log2_above(int32_t x)
{
    return x <= 1 ? 0 : 32 - qtri_clz32((uint32_t)x - 1);
}

static void set_shifts(uint8_t *left, uint8_t *right, int32_t up)
{
    *left = (uint8_t)(up > 0 ? up : 0);
    *right = (uint8_t)(up < 0 ? qtri_least32(-up, 31) : 0);
}

/* Points 2^log2 pixels apart, pieces 2^job->h_log2. */
static void set_steps(qtri_large_job *job, int32_t log2)
{
    const int32_t h = qtri_greatest32(job->h_log2, 0);
    job->q.s_step = job->q.dx << log2;
    job->delta_step =
        job->h_log2 < 0 ? 0 : qtri_large_whole(job->q.s_step); /* single pixels have no curve */
    for (int i = 0; i < job->count; i++) {
        qtri_large_attribute *a = &job->a[i];
        a->along.plane.s_step = a->along.plane.dx << log2;
        set_shifts(&a->step_left, &a->step_right, a->up + 2 - h);
        set_shifts(&a->bend_left, &a->bend_right, a->up + 4 - 2 * h);
    }
}

/* The first of them is at x. */
static inline void set_first(qtri_large_job *job, int32_t x)
{
    job->q.s = qtri_large_plane_from(&job->q, x);
    for (int i = 0; i < job->count; i++) {
        job->a[i].along.plane.s = qtri_large_plane_from(&job->a[i].along.plane, x);
    }
}

/* A quarter of all attributes at the next point, which is gone past. */
static int32_t next_reciprocal(qtri_large_job *job)
{
    const int32_t reciprocal = reciprocal_of(job, job->q.s);
    job->q.s += job->q.s_step;
    return reciprocal;
}

static inline int32_t next_quotient(qtri_large_attribute *a, int32_t zeros, int32_t reciprocal)
{
    const uint64_t s = a->along.plane.s;
    a->along.plane.s = s + a->along.plane.s_step;
    return quotient_of(s, zeros, reciprocal);
}

/* (q1 - q0) / 2 q at a point, Q16. */
static inline int32_t delta_at(const qtri_large_job *job, int32_t reciprocal)
{
    return (((int32_t)(job->delta_step << job->zeros) >> 16) * (reciprocal >> 16)) >> 15;
}

static void begin_chunk(qtri_large_job *job)
{
    const int32_t chunk =
        job->t.row_left + ((job->t.x - job->t.row_left) & -(int32_t)QTRI_LARGE_CHUNK);
    job->chunk_end = qtri_least32(chunk + QTRI_LARGE_CHUNK, job->t.row_right);
    const int32_t width = job->chunk_end - chunk;
    int32_t log2 = job->one_log2;
    if (log2 < 0) {
        const bool falls = (int32_t)qtri_large_whole(job->q.dx) < 0;
        /* The least: 2^31 at most, and behind the row's end it may be below 0. */
        const uint32_t q = qtri_large_plane_at(&job->q, falls ? chunk + width : chunk);
        log2 = length_for(job, q - 1 < 0x80000000u ? q : 1);
        log2 = qtri_hold32(log2, -1, qtri_least32(job->piece_max, log2_above(width) - 1));
    }
    while (log2 > 0 && width >> log2 == 0) { /* far behind a thin one's end values do not fit */
        log2--;
    }
    job->h_log2 = log2;
    const int32_t apart = log2 + 1;
    const int32_t number = (job->t.x - chunk) >> apart;
    if (log2 != job->steps_log2) {
        set_steps(job, apart);
        job->steps_log2 = (int8_t)log2;
        job->level_log2 = QTRI_LARGE_NO_LEVEL;
    }
    set_first(job, chunk);
    job->t.x = chunk + number * ((int32_t)1 << apart);
    job->q.s += job->q.s_step * (uint64_t)(int64_t)number;
    for (int i = 0; i < job->count; i++) {
        job->a[i].along.plane.s += job->a[i].along.plane.s_step * (uint64_t)(int64_t)number;
    }
    const int32_t reciprocal = next_reciprocal(job);
    job->delta = delta_at(job, reciprocal);
    for (int i = 0; i < job->count; i++) {
        job->a[i].point = next_quotient(&job->a[i], job->zeros, reciprocal);
    }
}

/*
 * Whether q changes so little along the row that attributes are linear: with e = q' / q and K the
 * slope, K e d^2 is missed d pixels from where the row begins, here 2^-14 K. q: there.
 */
static inline bool is_level(const qtri_large_job *job)
{
    const uint32_t width = (uint32_t)(job->t.row_right - job->t.row_left); /* <= 2^13 */
    return job->steep == 0 ||
           qtri_mul_u32(width * width, job->steep) >> 2 <=
               qtri_large_positive(qtri_large_plane_at(&job->q, job->t.row_left));
}

/* The one division of a row: the quotient of a step, of as many pixels as go into 32 bits, is the
   step. */
QTRI_NOINLINE bool qtri_large_begin_level(qtri_large_job *job)
{
    job->is_level = is_level(job);
    if (!job->is_level) {
        return false;
    }
    const uint32_t beyond = (uint32_t)(job->t.row_right - job->t.row_left) - 1;
    if (beyond >> (job->level_log2 - 1) != 1) { /* longer or shorter than the row before */
        job->level_log2 = (uint8_t)qtri_greatest32(log2_above((int32_t)beyond + 1), 1);
        job->h_log2 = job->level_log2;
        set_steps(job, job->h_log2);
        job->steps_log2 = QTRI_LARGE_NO_LEVEL;
    }
    set_first(job, job->t.row_left);
    const int32_t reciprocal = next_reciprocal(job);
    for (int i = 0; i < job->count; i++) {
        qtri_large_attribute *a = &job->a[i];
        const int32_t from = next_quotient(a, job->zeros, reciprocal);
        const int32_t rise = quotient_of(a->along.plane.s_step, job->zeros, reciprocal);
        a->at = (uint32_t)((int32_t)((uint32_t)from << a->at_left) >> a->at_right) + a->start;
        a->step = (uint32_t)((int32_t)((uint32_t)rise << a->step_left) >> a->step_right);
    }
    return true;
}

static inline uint32_t both_shifts(int32_t x, uint8_t left, uint8_t right)
{
    return (uint32_t)((int32_t)((uint32_t)x << left) >> right);
}

/* Coordinate i of both pieces. */
static inline void set_coordinate(qtri_large_job *job, int i, int32_t end, int32_t eps,
                                  int32_t eps1, int32_t eps2)
{
    qtri_large_attribute *a = &job->a[i];
    const int32_t from = a->point, rise = end - from;
    const int32_t rise1 = (rise + qtri_mul_s16(rise, eps)) >> 1, rise2 = rise - rise1;
    const int32_t w1 = qtri_mul_s16(rise1, eps1), w2 = qtri_mul_s16(rise2, eps2);
    const uint32_t bend1 = 0 - both_shifts(w1, a->bend_left, a->bend_right);
    const uint32_t bend2 = 0 - both_shifts(w2, a->bend_left, a->bend_right);
    const uint32_t at1 = both_shifts(from, a->at_left, a->at_right);
    const uint32_t at2 = both_shifts(from + rise1, a->at_left, a->at_right);
    const uint32_t step1 =
        both_shifts(rise1 + 2 * w1, a->step_left, a->step_right) + (uint32_t)((int32_t)bend1 >> 1);
    const uint32_t step2 =
        both_shifts(rise2 + 2 * w2, a->step_left, a->step_right) + (uint32_t)((int32_t)bend2 >> 1);
    qtri_large_piece *piece = job->piece;
    a->point = end;
    if (i == 0) {
        piece[0].u = at1;
        piece[0].u_step = step1;
        piece[0].u_bend = bend1;
        piece[1].u = at2;
        piece[1].u_step = step2;
        piece[1].u_bend = bend2;
    } else {
        piece[0].v = at1;
        piece[0].v_step = step1;
        piece[0].v_bend = bend1;
        piece[1].v = at2;
        piece[1].v_step = step2;
        piece[1].v_bend = bend2;
    }
}

/* Colours of both pieces along chords. */
QTRI_NOINLINE static void set_chords(qtri_large_job *job, const int32_t *end, int32_t eps)
{
    uint32_t at[2][QTRI_LARGE_ATTRIBUTES], step[2][QTRI_LARGE_ATTRIBUTES];
    const int32_t h = (int32_t)1 << qtri_greatest32(job->h_log2, 0);
    const int32_t rest = job->t.row_right - job->t.x;
    for (int i = job->first_color; i < job->count; i++) {
        qtri_large_attribute *a = &job->a[i];
        const int32_t from = a->point, rise = end[i] - from;
        const int32_t rise1 = (rise + qtri_mul_s16(rise, eps)) >> 1;
        const int32_t lifted = from + ((2 * rise1 - rise) >> 4); /* w / 16 */
        at[0][i] = both_shifts(lifted, a->at_left, a->at_right) + a->start;
        step[0][i] = both_shifts(rise1, a->step_left, a->step_right);
        qtri_large_clamp_chord(a, &at[0][i], &step[0][i], qtri_least32(h, rest));
        at[1][i] = both_shifts(lifted + rise1, a->at_left, a->at_right) + a->start;
        step[1][i] = both_shifts(rise - rise1, a->step_left, a->step_right);
        qtri_large_clamp_chord(a, &at[1][i], &step[1][i], qtri_hold32(rest - h, 1, h));
        a->point = end[i];
    }
    qtri_large_pack(job, &job->piece[0], at[0], step[0], qtri_least32(h, rest));
    qtri_large_pack(job, &job->piece[1], at[1], step[1], qtri_hold32(rest - h, 0, h));
}

/* Two pieces, or one of a pixel. */
QTRI_INLINE int32_t curved_pieces(qtri_large_job *job, bool textured, bool colored)
{
    qtri_large *t = &job->t;
    if (job->t.is_new) {
        job->t.is_new = false;
        qtri_large_planes_move(job);
        begin_chunk(job);
    } else if (t->x == job->chunk_end) {
        begin_chunk(job);
    }
    const int32_t reciprocal = next_reciprocal(job);
    const int32_t after = delta_at(job, reciprocal);
    /* Of the greater q: |d| <= 1/4. A point beyond the row may have a greater one, which wraps. */
    const int32_t d = (int32_t)job->delta_step < 0 ? job->delta : after;
    job->delta = after;
    const int32_t d2 = d * d >> 16;
    const int32_t d3 = d2 * d >> 16;
    const int32_t sign = d < 0 ? -1 : 1;
    const int32_t eps = d + sign * (d2 + (d2 * d2 >> 16)) + d3;
    const int32_t square = eps * eps >> 17; /* eps^2 / 2 */
    const int32_t cube = eps * square >> 18;
    const int32_t eps1 = ((eps + square) >> 1) + cube;
    const int32_t eps2 = ((eps - square) >> 1) + cube;
    if (textured) {
        const int32_t zeros = job->zeros;
        set_coordinate(job, 0, next_quotient(&job->a[0], zeros, reciprocal), eps, eps1, eps2);
        set_coordinate(job, 1, next_quotient(&job->a[1], zeros, reciprocal), eps, eps1, eps2);
    }
    if (colored) {
        int32_t end[QTRI_LARGE_ATTRIBUTES];
        for (int i = job->first_color; i < job->count; i++) {
            end[i] = next_quotient(&job->a[i], job->zeros, reciprocal);
        }
        set_chords(job, end, eps);
    }
    const int32_t x = job->t.x;
    if (job->h_log2 < 0) {
        job->piece[0].count = 1;
        job->t.x = x + 1;
        return 1;
    }
    const int32_t h = (int32_t)1 << job->h_log2;
    job->piece[0].count = h;
    job->piece[1].count = h;
    job->t.x = qtri_least32(x + 2 * h, job->chunk_end);
    if (x < t->x0 || x + 2 * h > t->x1) { /* a chunk ends between pieces, or with the row */
        job->piece[1].count = qtri_hold32(job->chunk_end - x - h, 0, h);
        job->piece[0].count = qtri_least32(job->chunk_end - x, h);
        qtri_large_clip(job, &job->piece[0], x);
        qtri_large_clip(job, &job->piece[1], x + h);
    }
    return 2;
}

QTRI_INLINE int32_t next_pieces(qtri_large_job *job, bool textured, bool colored)
{
    if (job->is_quadratic) {
        return qtri_large_quadratic_piece(job);
    }
    if (!job->is_curved) {
        return qtri_large_linear_piece(job);
    }
    if (job->may_be_level) {
        if (job->t.is_new) {
            qtri_large_planes_move(job);
            job->is_bent = !qtri_large_begin_level(job);
        }
        if (job->is_level) {
            return qtri_large_linear_piece(job);
        }
    }
    return curved_pieces(job, textured, colored);
}

void qtri_large_set_planes(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    int64_t q_q8[3];
    if (qtri_large_set_linear(job, q_q8)) {
        return;
    }
    if (qtri_large_is_quadratic(job)) {
        /* Colours where vertices are snapped to, so that they stay within those of the vertices. */
        qtri_large_use_weights(t, t->is_true && job->first_color != 0);
        if (qtri_large_set_quadratics(job)) {
            return;
        }
    }
    qtri_large_use_weights(t, t->is_true);
    qtri_large_set_curved(job, q_q8);
    set_lengths(job);
}

int32_t qtri_large_next_uv(qtri_large *t)
{
    return next_pieces(qtri_large_job_of(t), true, false);
}

int32_t qtri_large_next_any(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    return next_pieces(job, job->first_color != 0, job->first_color != job->count);
}
