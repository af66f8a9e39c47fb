/* SPDX-License-Identifier: MIT */
/*
 * Perspective along rows. An attribute is s / q, both linear on the screen, and so a + b / q. It is
 * found by one reciprocal at points that are a span apart, counted from the left end of the row.
 * With eps = (q1 - q0) / (q1 + q0) between two points and `rise` the difference of an attribute, at
 * s of -1..1 between them it is above the chord by
 *
 *     rise eps / 2 (1 - s^2) / (1 + eps s).
 *
 * With w = rise eps, w2 = w eps, w3 = w eps^2 and a span of n pixels:
 *
 * Coordinates alone, along a whole span, are that with 1 - eps (1 + c eps^2) s + eps^2 s^2 in place
 * of the last quotient, which with c = .382 is off least: by .04 rise eps^4. Pixels have of it a
 * spline of second order, exact at its knots, one every n / 4 pixels: with eps (1 + c eps^2) in w2
 *
 *     bend = -(4 w + 9 w2 + 9 w3) / n^2 at first,
 *     and 6 w2 + 12 w3, 6 w2, 6 w2 - 12 w3, all by n^2, more from a knot on,
 *     step = (rise + 2 w + 15/8 w2 + 3/2 w3) / n + bend / 2.
 *
 * Beside colours, where textures have levels, and along spans so long that what bends lose by
 * rounding would be seen at their ends, coordinates are two parabolas of h = n / 2 pixels, through
 * both ends and the exact middle, (rise + w) / 2:
 *
 *     bend = -(4 w + 6 w2 + 4 w3) / n^2, -(4 w - 6 w2 + 4 w3) / n^2,
 *     step = what half rises / h - bend h / 2 + bend / 2.
 *
 * Colours are two chords, of h pixels. The chord of half a span is w / 8 below its middle: w / 16
 * is added to both.
 */
#include "large_setup.h"

/* Lengths ----------------------------------------------------------------------------------------
 *
 * With L the step of the coordinate and e = q' / q, so that eps is e n / 2, a whole span is off by
 * .0025 L e^4 n^5, and the spline from it by .00075 L e^2 n^3 and terms of higher order; a half by
 * .048 L e^2 h^3. n is the greatest power of two for which n^5 e^4 <= .62 and n^3 e^2 <= 6, or n^3
 * e^2 <= 1.3 of halves: .0095 of L at most, measured for all n, or of a texel where L is more.
 *
 * Bends are 4.2 L e and change by 1.8 L e at most, and steps have half of them, which wraps with
 * the coordinate: where that may be half a repeat, n is 1, and no pixel is a step away from where
 * its piece begins.
 */
enum {
    SPAN_BOUND = -177,  /* 256 log2(.62) */
    KNOT_BOUND = 662,   /* 256 log2(6) */
    HALF_BOUND = 97,    /* 256 log2(1.3) */
    WRAP_BOUND = -1024, /* 256 log2(1/16): of L e, in repeats */
    LOG2_ERROR = 22,    /* of log2_q8(), 1/256 */
    WHOLE_LOG2 = 6      /* of the longest whole span */
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

/* log2 of a span's pixels where q is this or more; may be negative. Points must have q' 2 n <= q,
   so that q is positive at the point behind a row's end. */
static int32_t length_for(const qtri_large_job *job, uint32_t q)
{
    const int32_t inverse_e = log2_q8(q) - job->q_slope_log2;
    int32_t log2 = inverse_e - 256;
    if (job->first_color != 0) {
        const int32_t texels = texels_for(job, q);
        const int32_t halves = (2 * inverse_e + HALF_BOUND - texels) * 85 >> 8;
        log2 = qtri_least32(log2, halves);
        if (job->has_knots && halves < (WHOLE_LOG2 + 1) * 256) {
            const int32_t knots = (2 * inverse_e + KNOT_BOUND - texels) * 85 >> 8;
            const int32_t whole = (4 * inverse_e + SPAN_BOUND - texels) * 51 >> 8;
            log2 = qtri_least32(qtri_least32(knots, whole), inverse_e - 256);
            log2 = qtri_least32(log2, (WHOLE_LOG2 + 1) * 256 - 1);
        }
        if (job->repeat_log2 - log2_q8(q) - inverse_e >= WRAP_BOUND) {
            log2 = qtri_least32(log2, 0);
        }
    }
    if (job->first_color != job->count) { /* chords: q'/q h^2 c'/8 <= bound, c' <= slope / q */
        const int32_t color = (2 * log2_q8(q) - job->q_slope_log2 + job->chord_log2) >> 1;
        log2 = qtri_least32(log2, color + 256);
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
            (slope_of(a->plane.dx) >> 1) + (qtri_mul_high32(greatest, q_slope) >> 1) + 1;
        const int32_t log2 = log2_q8(slope) + LOG2_ERROR + (33 - job->axis[i].texel_shift) * 256;
        const int32_t side_log2 = i == 0 ? job->t.state->width_log2 : job->t.state->height_log2;
        most = qtri_greatest32(log2, most);
        most_repeats = qtri_greatest32(log2 - side_log2 * 256, most_repeats);
    }
    job->repeat_log2 = (int16_t)most_repeats;
    job->texel_log2 = (int16_t)(qtri_large_has_levels(job) ? INT16_MIN : most);
}

/* The greatest slope of colours times q, and what of it comes of q. They may stray by 1/4 of a step
   for going along chords. */
static int32_t chord_log2(const qtri_large_job *job)
{
    const int32_t quarter_log2 =
        !job->rounds && qtri_stores_565(job->t.options) ? 16 : 14; /* 8.16 */
    uint32_t most = 1;
    const uint32_t q_slope = slope_of(job->q.dx);
    for (int i = job->first_color; i < job->count; i++) {
        const qtri_large_attribute *a = &job->a[i];
        const uint32_t slope =
            slope_of(a->plane.dx) + qtri_mul_high32(a->range << QTRI_LARGE_COLOR_UP, q_slope) + 1;
        most = slope > most ? slope : most;
    }
    const int32_t bound = 3 + quarter_log2 + QTRI_LARGE_COLOR_UP - 32;
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
    job->rows_may_be_linear = steep >> 16 == 0;
    job->steep = (uint32_t)steep;
    job->linear_log2 = QTRI_LARGE_NO_STEPS;
    job->span_log2 = QTRI_LARGE_NO_STEPS;
    for (int k = 0; k < 3; k++) {
        const uint64_t q = (uint64_t)job->vertex_q[k] << job->q_headroom;
        least = q < least ? (uint32_t)q : least;
    }
    least -= job->t.has_true_positions ? least >> 5 : 0;
    const int32_t log2 = length_for(job, least);
    job->span_log2_max =
        qtri_least32(job->run_log2 + 1, job->rounds ? QTRI_LARGE_RUN_LOG2 : QTRI_LARGE_CHUNK_LOG2);
    /* To look for longer ones than whole ones costs quads turned by 10 to 20 degrees 4 %. */
    const int32_t enough =
        job->has_knots ? qtri_least32(WHOLE_LOG2, job->span_log2_max) : job->span_log2_max;
    const int32_t pixels = (qtri_greatest32(job->t.width, job->t.height) >> 8) + 1;
    job->fixed_span_log2 = log2 >= enough || (log2 >= 0 && pixels >> log2 == 0)
                               ? qtri_least32(log2, job->span_log2_max)
                               : -1;
    for (int i = 0; i < job->count; i++) {
        qtri_set_shifts(&job->a[i].at_left, &job->a[i].at_right, job->a[i].piece_shift + 2);
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

/* 2^62 / (q 2^q_zeros), below 2^31; sets job->q_zeros. q: 2^-32. */
static inline int32_t reciprocal_of(qtri_large_job *job, uint64_t q_q32)
{
    const uint32_t q = qtri_large_positive(qtri_large_whole(q_q32));
#if QTRI_LONG_MULTIPLY
    const int32_t zeros = qtri_clz32(q);
#else
    int32_t zeros = job->q_zeros; /* of the point before nearly as many */
    while (q >> (31 - zeros) > 1) {
        zeros--;
    }
    while ((int32_t)(q << zeros) >= 0) {
        zeros++;
    }
#endif
    job->q_zeros = zeros;
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

/* Points 2^log2 pixels apart; steps of what 2^rise_log2 pixels rise. */
static void set_steps(qtri_large_job *job, int32_t log2, int32_t rise_log2)
{
    job->q.s_step = job->q.dx << log2;
    job->q_rise = log2 == 0 ? 0 : qtri_large_whole(job->q.s_step); /* single pixels have no curve */
    for (int i = 0; i < job->count; i++) {
        qtri_large_attribute *a = &job->a[i];
        a->plane.s_step = a->plane.dx << log2;
        qtri_set_shifts(&a->step_left, &a->step_right, a->piece_shift + 2 - rise_log2);
        qtri_set_shifts(&a->bend_left, &a->bend_right, a->piece_shift + 4 - 2 * log2);
    }
}

/* The first of them is at x. */
static inline void set_first(qtri_large_job *job, int32_t x)
{
    job->q.s = qtri_large_plane_from(&job->q, x);
    for (int i = 0; i < job->count; i++) {
        job->a[i].plane.s = qtri_large_plane_from(&job->a[i].plane, x);
    }
}

/* The reciprocal of q at the next point, which is gone past; a quarter of an attribute there. */
static int32_t next_reciprocal(qtri_large_job *job)
{
    const int32_t reciprocal = reciprocal_of(job, job->q.s);
    job->q.s += job->q.s_step;
    return reciprocal;
}

static inline int32_t next_quotient(qtri_large_attribute *a, int32_t zeros, int32_t reciprocal)
{
    const uint64_t s = a->plane.s;
    a->plane.s = s + a->plane.s_step;
    return quotient_of(s, zeros, reciprocal);
}

/* (q1 - q0) / 2 q at a point, Q16. */
static inline int32_t relative_rise_at(const qtri_large_job *job, int32_t reciprocal)
{
    const int32_t step = (int32_t)(job->q_rise << job->q_zeros) >> 16;
    return ((2 * step + 1) * (reciprocal >> 16) + 0x8000) >> 16;
}

static void begin_chunk(qtri_large_job *job)
{
    const int32_t chunk =
        job->t.row_left + ((job->t.x - job->t.row_left) & -(int32_t)QTRI_LARGE_CHUNK);
    job->chunk_end = qtri_least32(chunk + QTRI_LARGE_CHUNK, job->t.row_right);
    const int32_t width = job->chunk_end - chunk;
    int32_t log2 = job->fixed_span_log2;
    job->has_second = false;
    if (log2 < 0) {
        const bool falls = (int32_t)qtri_large_whole(job->q.dx) < 0;
        /* The least: 2^31 at most, and behind the row's end it may be below 0. */
        const uint32_t q = qtri_large_plane_at(&job->q, falls ? chunk + width : chunk);
        log2 = length_for(job, q - 1 < 0x80000000u ? q : 1);
        log2 = qtri_hold32(log2, 0, qtri_least32(job->span_log2_max, log2_above(width)));
    }
    /* Of fixed lengths: a point twice the chunk away may be where values of a thin triangle do not
       fit. */
    while (log2 > 0 && 2 * width >> log2 == 0) {
        log2--;
    }
    if (job->has_knots && log2 == 1) { /* too short for knots */
        log2 = 0;
    }
    const int32_t number = (job->t.x - chunk) >> log2;
    if (log2 != job->span_log2) {
        set_steps(job, log2, log2 - 1);
        job->span_log2 = (int8_t)log2;
        job->linear_log2 = QTRI_LARGE_NO_STEPS;
    }
    set_first(job, chunk);
    job->t.x = chunk + number * ((int32_t)1 << log2);
    if (number != 0) {
        job->q.s += job->q.s_step * (uint64_t)(int64_t)number;
        for (int i = 0; i < job->count; i++) {
            job->a[i].plane.s += job->a[i].plane.s_step * (uint64_t)(int64_t)number;
        }
    }
    const int32_t reciprocal = next_reciprocal(job);
    job->relative_q_rise = relative_rise_at(job, reciprocal);
    for (int i = 0; i < job->count; i++) {
        job->a[i].point_quarter = next_quotient(&job->a[i], job->q_zeros, reciprocal);
    }
}

/* Whether attributes are linear along the row: with e = q' / q, one of slope K is off by K e d^2
   after d pixels, here by 2^-14 K at most. */
static inline bool can_be_linear(const qtri_large_job *job)
{
    const uint32_t width = (uint32_t)(job->t.row_right - job->t.row_left); /* <= 2^13 */
    return job->steep == 0 ||
           qtri_mul_u32(width * width, job->steep) >> 2 <=
               qtri_large_positive(qtri_large_plane_at(&job->q, job->t.row_left));
}

/* One reciprocal of q a row: steps are from what 2^linear_log2 pixels rise. */
QTRI_NOINLINE void qtri_large_begin_linear_row(qtri_large_job *job)
{
    job->row_is_linear = can_be_linear(job);
    if (!job->row_is_linear) {
        return;
    }
    const uint32_t beyond = (uint32_t)(job->t.row_right - job->t.row_left) - 1;
    if (beyond >> (job->linear_log2 - 1) != 1) { /* longer or shorter than the row before */
        job->linear_log2 = (uint8_t)qtri_greatest32(log2_above((int32_t)beyond + 1), 1);
        set_steps(job, job->linear_log2, job->linear_log2);
        job->span_log2 = QTRI_LARGE_NO_STEPS;
    }
    set_first(job, job->t.row_left);
    const int32_t reciprocal = next_reciprocal(job);
    for (int i = 0; i < job->count; i++) {
        qtri_large_attribute *a = &job->a[i];
        const int32_t from = next_quotient(a, job->q_zeros, reciprocal);
        const int32_t rise = quotient_of(a->plane.s_step, job->q_zeros, reciprocal);
        a->at = qtri_both_shifts(from, a->at_left, a->at_right) + a->start;
        a->step = qtri_both_shifts(rise, a->step_left, a->step_right);
    }
}

/* Of a span, Q16. |eps| <= 1/3. */
typedef struct span_bend {
    int32_t eps;
    int32_t eps_c;  /* eps + c eps^3 of whole ones, else eps */
    int32_t square; /* eps^2 */
} span_bend;

/* Of d = (q1 - q0) / 2 q with the greater q, |d| <= 1/4: eps = d / (1 - |d|). */
static inline span_bend bend_of(int32_t d, bool whole)
{
    const int32_t d2 = d * d >> 14; /* Q18 */
    const int32_t more = d2 + (d2 * d2 >> 18);
    span_bend b;
    b.eps = d + (((d < 0 ? -more : more) + (d2 * d >> 16) + 2) >> 2);
    b.square = b.eps * b.eps >> 16;
    b.eps_c = b.eps + (whole ? (b.square * b.eps >> 16) * 49 >> 7 : 0);
    return b;
}

/* Coordinate i of a whole span, up to its end. */
static inline void set_whole(qtri_large_job *job, int i, int32_t end, const span_bend *b)
{
    qtri_large_attribute *a = &job->a[i];
    qtri_large_piece *piece = job->piece;
    const int32_t from = a->point_quarter, rise = end - from;
    qtri_large_knots *knots = &piece->of.knots;
    a->point_quarter = end;
    piece->uv[i].at = qtri_both_shifts(from, a->at_left, a->at_right);
    const int32_t w = qtri_mul_s16(rise, b->eps);
    const int32_t w2 = qtri_mul_s16(w, b->eps_c), w3 = qtri_mul_s16(w, b->square);
    const int32_t half = ((rise + w) >> 1) + (w >> 1) + w2 + w3 - (w2 >> 4) - (w3 >> 2);
    knots->gain_loss[i] = qtri_both_shifts(w3 + 2 * w3, a->bend_left, a->bend_right);
    knots->bend_gain[i] =
        knots->gain_loss[i] + qtri_both_shifts(w2 + (w2 >> 1), a->bend_left, a->bend_right);
    piece->uv[i].bend =
        0 - qtri_both_shifts(w + 2 * (w2 + w3) + ((w2 + w3) >> 2), a->bend_left, a->bend_right);
    piece->uv[i].step = qtri_both_shifts(half, a->step_left, a->step_right) +
                        (uint32_t)((int32_t)piece->uv[i].bend >> 1);
}

/* And of both halves. */
static inline void set_halves(qtri_large_job *job, int i, int32_t end, const span_bend *b)
{
    qtri_large_attribute *a = &job->a[i];
    qtri_large_coordinate *first = &job->piece[0].uv[i], *second = &job->piece[1].uv[i];
    const int32_t from = a->point_quarter, rise = end - from;
    const int32_t w = qtri_mul_s16(rise, b->eps);
    const int32_t rise1 = (rise + w) >> 1;
    a->point_quarter = end;
    first->at = qtri_both_shifts(from, a->at_left, a->at_right);
    second->at = qtri_both_shifts(from + rise1, a->at_left, a->at_right);
    const int32_t w2 = qtri_mul_s16(w, b->eps_c), w3 = qtri_mul_s16(w, b->square);
    const uint32_t bend = 0 - qtri_both_shifts(w + w3, a->bend_left, a->bend_right);
    const uint32_t third = qtri_both_shifts(w2 + (w2 >> 1), a->bend_left, a->bend_right);
    const uint32_t bend1 = bend - third, bend2 = bend + third;
    const uint32_t half_h = (uint32_t)1 << job->span_log2 >> 2;
    first->bend = bend1;
    second->bend = bend2;
    first->step = qtri_both_shifts(rise1, a->step_left, a->step_right) - bend1 * half_h +
                  (uint32_t)((int32_t)bend1 >> 1);
    second->step = qtri_both_shifts(rise - rise1, a->step_left, a->step_right) - bend2 * half_h +
                   (uint32_t)((int32_t)bend2 >> 1);
}

QTRI_NOINLINE static void hold_chord(const qtri_large_attribute *a, uint32_t *at, uint32_t *step,
                                     int32_t count)
{
    const int32_t min = (int32_t)a->start, max = (int32_t)(a->start + a->range);
    const int32_t from = qtri_hold32((int32_t)*at, min, max);
    const int32_t end = from + (int32_t)*step * (count - 1);
    const int32_t to = qtri_hold32(end, min, max);
    if (to != end && count > 1) {
        *step = (uint32_t)qtri_divide32(to - from, (uint32_t)count - 1);
    }
    *at = (uint32_t)from;
}

/* Clamps a chord of `count` pixels to the range of the vertices, at its last pixel too: few need
   it. */
static inline void clamp_chord(const qtri_large_attribute *a, uint32_t *at, uint32_t *step,
                               int32_t count)
{
    const uint32_t from = *at - a->start;
    if (from > a->range || from + *step * ((uint32_t)count - 1) > a->range) {
        hold_chord(a, at, step, count);
    }
}

/* Colours of both pieces along chords. */
QTRI_NOINLINE static void set_chords(qtri_large_job *job, int32_t reciprocal, int32_t eps)
{
    uint32_t at[2][QTRI_LARGE_ATTRIBUTES], step[2][QTRI_LARGE_ATTRIBUTES];
    const int32_t h = (int32_t)1 << qtri_greatest32(job->span_log2 - 1, 0);
    const int32_t rest = job->t.row_right - job->t.x;
    for (int i = job->first_color; i < job->count; i++) {
        qtri_large_attribute *a = &job->a[i];
        const int32_t end = next_quotient(a, job->q_zeros, reciprocal);
        const int32_t from = a->point_quarter, rise = end - from;
        const int32_t rise1 = (rise + qtri_mul_s16(rise, eps)) >> 1;
        const int32_t lifted = from + ((2 * rise1 - rise) >> 4); /* w / 16 */
        at[0][i] = qtri_both_shifts(lifted, a->at_left, a->at_right) + a->start;
        step[0][i] = qtri_both_shifts(rise1, a->step_left, a->step_right);
        clamp_chord(a, &at[0][i], &step[0][i], qtri_least32(h, rest));
        at[1][i] = qtri_both_shifts(lifted + rise1, a->at_left, a->at_right) + a->start;
        step[1][i] = qtri_both_shifts(rise - rise1, a->step_left, a->step_right);
        clamp_chord(a, &at[1][i], &step[1][i], qtri_hold32(rest - h, 1, h));
        a->point_quarter = end;
    }
    qtri_large_pack(job, &job->piece[0], at[0], step[0], qtri_least32(h, rest));
    if (rest > h) { /* or there is no second one */
        qtri_large_pack(job, &job->piece[1], at[1], step[1], qtri_least32(h, rest - h));
    }
}

/* The next span: whole, of coordinates alone, or its halves. */
QTRI_INLINE int32_t span_pieces(qtri_large_job *job, bool whole, bool textured, bool colored)
{
    qtri_large *t = &job->t;
    const int32_t reciprocal = next_reciprocal(job), zeros = job->q_zeros;
    const int32_t after = relative_rise_at(job, reciprocal);
    /* Of the greater q: |d| <= 1/4. A point beyond the row may have a greater one, which wraps. */
    const int32_t d = (int32_t)job->q_rise < 0 ? job->relative_q_rise : after;
    const span_bend b = bend_of(d, whole);
    job->relative_q_rise = after;
    if (whole) {
        set_whole(job, 0, next_quotient(&job->a[0], zeros, reciprocal), &b);
        set_whole(job, 1, next_quotient(&job->a[1], zeros, reciprocal), &b);
    } else if (textured) {
        set_halves(job, 0, next_quotient(&job->a[0], zeros, reciprocal), &b);
        set_halves(job, 1, next_quotient(&job->a[1], zeros, reciprocal), &b);
    }
    if (colored) {
        set_chords(job, reciprocal, b.eps);
    }
    const int32_t x = job->t.x, left = job->chunk_end - x;
    const int32_t n = (int32_t)1 << job->span_log2;
    const bool cut = x < t->x0 || x + n > t->x1; /* a chunk ends between pieces, or with the row */
    job->t.x = x + qtri_least32(n, left);
    if (whole || n == 1) {
        job->piece[0].count = qtri_least32(n, left);
        if (!colored) {
            job->piece[0].of.knots.spacing = qtri_greatest32(n >> 2, 1);
            job->piece[0].of.knots.next = job->piece[0].of.knots.spacing;
        }
        if (cut) {
            qtri_large_clip(job, &job->piece[0], x);
        }
        return 1;
    }
    const int32_t h = n >> 1;
    job->piece[0].count = qtri_least32(h, left);
    job->piece[1].count = qtri_hold32(left - h, 0, h);
    if (!colored) {
        job->piece[0].of.knots.next = h;
        job->piece[1].of.knots.next = h;
    }
    if (cut) {
        qtri_large_clip(job, &job->piece[0], x);
        qtri_large_clip(job, &job->piece[1], x + h);
    }
    return left > h ? 2 : 1;
}

QTRI_NOINLINE static int32_t both_halves(qtri_large_job *job)
{
    return span_pieces(job, false, true, false);
}

/* The next half of a long span: without these a quad turned by 5 degrees takes 13 % more. */
QTRI_NOINLINE static void next_half(qtri_large_job *job)
{
    qtri_large_piece *piece = job->piece;
    if (job->has_second) {
        piece[0] = piece[1];
        job->has_second = false;
        job->t.x = job->second_end;
        return;
    }
    const int32_t middle = job->t.x + ((int32_t)1 << job->span_log2 >> 1);
    both_halves(job);
    if (job->t.x > middle) {
        job->has_second = true;
        job->second_end = job->t.x;
        job->t.x = middle;
    }
}

/* Begins the next span: 0; or, of a row that needs none, finds pieces: how many. */
QTRI_INLINE int32_t begin_span(qtri_large_job *job)
{
    if (!job->is_curved) {
        return qtri_large_linear_piece(job);
    }
    if (job->t.is_new) {
        qtri_large_planes_move(job);
        if (job->rows_may_be_linear) {
            qtri_large_begin_linear_row(job);
        }
    }
    if (job->row_is_linear) {
        return qtri_large_linear_piece(job);
    }
    if (job->t.is_new || job->t.x == job->chunk_end) {
        job->t.is_new = false;
        begin_chunk(job);
    }
    return 0;
}

void qtri_large_set_planes(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    int64_t q_q8[3];
    job->has_knots = job->first_color == job->count && !t->options->mipmapped;
    if (qtri_large_set_linear(job, q_q8)) {
        return;
    }
    qtri_large_use_weights(t, t->has_true_positions);
    qtri_large_set_curved(job, q_q8);
    set_lengths(job);
}

QTRI_NOINLINE int32_t qtri_large_find_pieces(qtri_large_job *job)
{
    const int32_t pieces = begin_span(job);
    return pieces != 0
               ? pieces
               : span_pieces(job, false, job->first_color != 0, job->first_color != job->count);
}

static void next_uv(qtri_large_job *job)
{
    if (begin_span(job) != 0) {
        return;
    }
    if (job->span_log2 > WHOLE_LOG2) {
        next_half(job);
    } else {
        (void)span_pieces(job, true, true, false);
    }
}

void qtri_large_next_uv(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    if (job->needs_clamp && qtri_large_next_rest(job)) {
        return;
    }
    next_uv(job);
    if (job->needs_clamp) {
        (void)qtri_large_clamp_pieces(job, 1);
    }
}

int32_t qtri_large_next_halves(qtri_large_job *job)
{
    const int32_t pieces = begin_span(job);
    return pieces != 0 ? pieces : both_halves(job);
}

int32_t qtri_large_next_any(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    if (!job->needs_clamp) {
        return qtri_large_find_pieces(job);
    }
    return qtri_large_next_rest(job) ? 1
                                     : qtri_large_clamp_pieces(job, qtri_large_find_pieces(job));
}
