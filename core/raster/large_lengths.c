/* SPDX-License-Identifier: MIT */
/*
 * How long pieces of rows are. Along one a coordinate is a parabola (large_curves.c).
 * With L the step of the coordinate and e = q' / q the parabola is off by .048 L e^2 h^3: h is the
 * greatest power of two for which that is below 2^-7 of L, and of a texel.
 */
#include "large_setup.h"

enum {
    STEP_BOUND = -671, /* 256 log2(2^-7 / .048): of a step, and of a texel where steps are longer */
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

int32_t qtri_large_texels_log2(const qtri_large_job *job, uint32_t q)
{
    return (texels_for(job, q) + 255) >> 8;
}

int32_t qtri_large_length_for(const qtri_large_job *job, uint32_t q)
{
    const int32_t inverse_e = log2_q8(q) - job->q_slope_log2;
    int32_t bound = STEP_BOUND;
    if (job->first_color != 0) {
        bound -= texels_for(job, q);
    }
    int32_t log2 = (2 * inverse_e + bound) * 85 >> 8; /* / 3 */
    log2 = qtri_least32(log2, inverse_e - 512);
    if (job->first_color != job->count) { /* chords: q'/q h^2 c'/4 <= bound, c' <= slope / q */
        const int32_t color = (2 * log2_q8(q) - job->q_slope_log2 + job->chord_log2) >> 1;
        log2 = qtri_least32(log2, color);
    }
    return log2 >> 8;
}

/* log2 of the greatest slope of coordinates times q along rows, in texels 2^32; of levels steps are
   about a texel. */
void qtri_large_set_texel_slope(qtri_large_job *job)
{
    const uint32_t q_slope = slope_of(job->q.dx);
    int32_t most = 0;
    for (int i = 0; i < job->first_color; i++) {
        const qtri_large_attribute *a = &job->a[i];
        uint32_t least, greatest;
        qtri_find_range(&least, &greatest, a->f);
        const uint32_t slope =
            (slope_of(a->plane.dx) >> 1) + (qtri_mul_high32(greatest, q_slope) >> 1) + 1;
        const int32_t log2 = log2_q8(slope) + LOG2_ERROR + (33 - job->t.axis[i].shift) * 256;
        most = log2 > most ? log2 : most;
    }
    job->texel_log2 = qtri_large_has_levels(job) ? INT16_MIN : most;
}

/* The greatest slope of colours times q, and what of it comes of q. */
static int32_t chord_log2(const qtri_large_job *job)
{
    uint32_t most = 1;
    const uint32_t q_slope = slope_of(job->q.dx);
    for (int i = job->first_color; i < job->count; i++) {
        const qtri_large_attribute *a = &job->a[i];
        const uint32_t range = (a->most - a->least) << QTRI_LARGE_COLOR_UP;
        const uint32_t slope = slope_of(a->plane.dx) + qtri_mul_high32(range, q_slope) + 1;
        most = slope > most ? slope : most;
    }
    const int32_t bound = 2 + qtri_large_chord_bound_log2(job) + QTRI_LARGE_COLOR_UP - 32;
    return bound * 256 - log2_q8(most) - LOG2_ERROR;
}

void qtri_large_set_lengths(qtri_large_job *job)
{
    const uint32_t slope = slope_of(job->q.dx);
    uint32_t least = UINT32_MAX;
    job->q_slope_log2 = log2_q8(slope) + LOG2_ERROR;
    job->chord_log2 = chord_log2(job);
    const uint64_t steep = qtri_magnitude64(qtri_wrap64(job->q.dx)) >> 16; /* 2^-16 */
    job->may_be_level = steep >> 16 == 0;
    job->steep = (uint32_t)steep;
    job->level_log2 = QTRI_LARGE_NO_LEVEL;
    job->steps_log2 = QTRI_LARGE_NO_LEVEL;
    for (int k = 0; k < 3; k++) {
        const uint64_t q = (uint64_t)job->q_at[k] << job->q_up;
        least = q < least ? (uint32_t)q : least;
    }
    least -= job->residual.is_on ? least >> 5 : 0;
    const int32_t log2 = qtri_large_length_for(job, least);
    job->piece_max =
        qtri_least32(job->run_log2, job->packing == QTRI_PACK_565 ? QTRI_LARGE_RUN_LOG2 - 1
                                                                  : QTRI_LARGE_CHUNK_LOG2 - 1);
    job->one_log2 = log2 >= job->piece_max                    ? job->piece_max
                    : log2 >= 0 && (job->pixels >> log2) == 0 ? log2
                                                              : -1;
    for (int i = 0; i < job->count; i++) {
        job->a[i].at_left = (uint8_t)qtri_greatest32(job->a[i].up + 2, 0);
        job->a[i].at_right = (uint8_t)qtri_greatest32(-(job->a[i].up + 2), 0);
    }
}
