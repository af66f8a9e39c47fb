/* SPDX-License-Identifier: MIT */
#include "vertex.h"

void qtri_row16_set(qtri_row16 *row, const int32_t m[3], int64_t t)
{
#if QTRI_LONG_MULTIPLY
    row->t_q16 = t * 65536;
    for (int i = 0; i < 3; i++) {
        row->m[i] = m[i];
    }
#else
    row->t_high = (int32_t)(t >> 16);
    row->t_low = (int32_t)(t & 0xFFFF) >> 2;
    for (int i = 0; i < 3; i++) {
        row->high[i] = m[i] >> 16;
        row->low[i] = (m[i] & 0xFFFF) >> 2;
    }
#endif
}

/* A row's part of qtri_projector_compact(): m n 2^-(e + 15) + t 2^-e for n = 32768 (p - o) /
 * extent. */
typedef struct folded {
    int64_t m[3]; /* |m| <= 2^61 */
    int64_t t;
    int32_t exponent;
} folded;

/*
 * |row.m| <= 2^30 and |row.t| < 2^61: t stays below 2^63. Returns the finest exponent that keeps
 * the row's sum below 2^29: with a = |m0| + |m1| + |m2| + |t| < 2^(64 - zeros), which fits 64 bits,
 * |m . n 2^-15 + t| <= a.
 */
static int32_t fold(folded *out, const qtri_row *row, const int32_t origin[3], q16 extent)
{
    uint64_t size = 0;
    out->t = row->t;
    out->exponent = row->exponent + 16;
    for (int i = 0; i < 3; i++) {
        out->m[i] = qtri_mul_s32(row->m[i], extent);
        out->t += qtri_mul_s32(row->m[i], origin[i]);
        size += qtri_magnitude64(out->m[i]);
    }
    size += qtri_magnitude64(out->t);
    return size == 0 ? INT32_MAX : out->exponent + qtri_clz64(size) - 35;
}

/* x 2^-shift for a result below 2^62, rounded down; |x| < 2^63. */
static int64_t shifted(int64_t x, int32_t shift)
{
    if (shift <= 0) {
        return qtri_shift_left64(x, shift < -62 ? 62 : -shift);
    }
    return x >> (shift > 63 ? 63 : shift);
}

/* With |m n 2^-15 + t| 2^(exponent - e) < 2^29: |m| < 2^30 and |t| < 2^45, in steps of 4. */
static void set_row(qtri_row16 *row, const folded *from, int32_t exponent)
{
    int64_t t = shifted(from->t, from->exponent - exponent - 16) & ~(int64_t)3;
    int32_t m[3];
    for (int i = 0; i < 3; i++) {
        m[i] = (int32_t)shifted(from->m[i], from->exponent - exponent - 1) & ~(int32_t)3;
    }
    qtri_row16_set(row, m, t);
}

/*
 * One exponent for x and y, one for z and w, at most 30 apart: sums then fit 31 bits, and what is
 * cut off is 2^-13 of a step of the positions.
 */
void qtri_projector_compact(qtri_projector *projector, const qtri_vec3 *origin, q16 extent)
{
    const int32_t at[3] = {origin->x, origin->y, origin->z};
    folded row[4];
    int32_t exponent[2] = {INT32_MAX, INT32_MAX};
    for (int i = 0; i < 4; i++) {
        int32_t finest = fold(&row[i], &projector->row.wide[i], at, extent);
        exponent[i / 2] = finest < exponent[i / 2] ? finest : exponent[i / 2];
    }
    for (int i = 0; i < 2; i++) { /* the finer one gives way; rows of zeros take the other's */
        int64_t most = (int64_t)exponent[1 - i] + 30;
        exponent[i] = exponent[i] > most ? (int32_t)most : exponent[i];
    }
    if (exponent[0] == INT32_MAX) {
        exponent[0] = 0;
        exponent[1] = 0;
    }
    for (int i = 0; i < 4; i++) {
        int32_t up = exponent[1 - i / 2] - exponent[i / 2];
        projector->shift[i] = up > 0 ? up : 0;
        set_row(&projector->row.compact[i], &row[i], exponent[i / 2]);
    }
}

/* Exact coordinates of one scale: |x|, |y|, |z|, |w| < 2^30 2^30. */
void qtri_projector_point16(const qtri_projector *projector, const qtri_position16 *p,
                            qtri_clip_vertex *out)
{
    int64_t v[4];
    for (int i = 0; i < 4; i++) {
        int32_t sum = qtri_row16_sum(&projector->row.compact[i], p->x, p->y, p->z);
        v[i] = qtri_shift_left64(sum, projector->shift[i]);
    }
    out->x = v[0];
    out->y = v[1];
    out->z = v[2];
    out->w = v[3];
    out->b1_q30 = 0;
    out->b2_q30 = 0;
}

/* The exponent that goes with W itself: shifts are the same for all of a draw. */
QTRI_NOINLINE static bool exact16(const qtri_projector *projector, const qtri_position16 *p,
                                  qtri_vertex *out)
{
    qtri_clip_vertex clip;
    qtri_projector_point16(projector, p, &clip);
    qtri_vertex_exact(projector, &clip, out);
    if ((out->depth_16p8 & QTRI_VERTEX_OUTSIDE) != 0) {
        return false;
    }
    out->depth_16p8 -= 32 - (uint32_t)projector->shift[3];
    return true;
}

/* Of x > 0; mostly those of the vertex before, 1..31: small cores have to count them. */
static inline int32_t leading_zeros(uint32_t x, int32_t guess)
{
#if !QTRI_LONG_MULTIPLY
    if (x << guess >> 31 != 0 && x >> (32 - guess) == 0) {
        return guess;
    }
#endif
    (void)guess;
    return qtri_clz32(x);
}

/*
 * x / w in 1/256 pixel is X 2^30 / w_q32 =: V over 2^n, where w_q32 = W 2^zeros is the normalised
 * mantissa. The high word h of X r is close: r is less than 1 below 2^62 / w_q32 and |X| < 2^30,
 * so -1/4 < V - h < 5/4. Half is added before n bits are cut off; where that of h - 1 and of h + 1
 * give the same, so does V. They do unless h + half + 1 ends in n - 1 zeros and any bit: 2 vertices
 * in 2^n have to go the exact way.
 */
typedef struct shared16 {
    const qtri_projector *projector;
    int32_t bits;  /* n + zeros */
    int32_t zeros; /* of the vertex before */
} shared16;

static inline void begin16(shared16 *shared, const qtri_projector *projector)
{
    shared->projector = projector;
    shared->bits = 22 - projector->shift[0] + projector->shift[3];
    shared->zeros = 2;
}

/* False: outside. */
QTRI_IN_PLACE bool place16(shared16 *shared, const qtri_position16 *p, qtri_vertex *out)
{
    const qtri_projector *projector = shared->projector;
    const qtri_row16 *row = projector->row.compact;
    int32_t w = qtri_row16_sum(&row[3], p->x, p->y, p->z);
    int32_t z = qtri_row16_sum(&row[2], p->x, p->y, p->z);
    if (w <= 0 || (uint32_t)z + (uint32_t)w > 2u * (uint32_t)w) {
        return exact16(projector, p, out);
    }
    const int32_t zeros = leading_zeros((uint32_t)w, shared->zeros);
    shared->zeros = zeros;
    int32_t n = shared->bits - zeros;
    if ((uint32_t)n - 2u > 28u) {
        return exact16(projector, p, out);
    }
    int32_t r = qtri_reciprocal_below((uint32_t)w << zeros);
    out->inv_w = (uint32_t)r;
    out->depth_16p8 =
        qtri_vertex_depth(projector, z * ((int32_t)1 << (zeros - 1)), r) | (uint32_t)zeros;
    out->intensity_q15 = QTRI_VERTEX_UNLIT;

    int32_t half = (int32_t)(UINT32_MAX >> (33 - n)); /* 2^(n - 1), and the - 1 of h - 1 */
    int32_t x = qtri_mul_high_s32(qtri_row16_sum(&row[0], p->x, p->y, p->z), r) + half;
    int32_t y = qtri_mul_high_s32(qtri_row16_sum(&row[1], p->x, p->y, p->z), r) + half;
    out->at.x_24p8 = x >> n;
    out->at.y_24p8 = y >> n;
    if (((x + 2) & (2 * half)) == 0 || ((y + 2) & (2 * half)) == 0 ||
        !qtri_vertex_in_guard(x >> n, y >> n)) {
        return exact16(projector, p, out);
    }
    return true;
}

bool qtri_projector_vertices16(const qtri_projector *projector, const qtri_position16 *p,
                               uint32_t count, qtri_vertex *vertices, bool is_listed)
{
    shared16 shared;
    begin16(&shared, projector);
    bool inside = true;
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t index = is_listed ? vertices[i].index : i;
        inside &= place16(&shared, &p[index], &vertices[index]);
    }
    return inside;
}

static void begin_compact(qtri_projector *projector, const qtri_mesh *mesh)
{
    qtri_projector_compact(projector, &mesh->origin, mesh->extent);
}

static bool project_compact(const qtri_projector *projector, const qtri_mesh *mesh, uint32_t first,
                            uint32_t count, qtri_vertex *vertices, bool is_listed)
{
    return qtri_projector_vertices16(projector, mesh->positions16 + first, count, vertices,
                                     is_listed);
}

static void transform_compact(const qtri_projector *projector, const qtri_mesh *mesh,
                              uint32_t index, qtri_clip_vertex *out)
{
    qtri_projector_point16(projector, &mesh->positions16[index], out);
}

const qtri_position_ops qtri_positions_compact = {
    .begin = begin_compact, .project = project_compact, .transform = transform_compact};
