/* SPDX-License-Identifier: MIT */
#include "../bits/bits.h"
#include "../bits/wide.h"
#include "projector.h"
#include "row.h"

/* The row whose value is a pixel coordinate times w: (scale row[axis] + center row[3]) / 2, as
 * scale and center count half pixels. */
static void fold_viewport(qtri_row *out, const qtri_transform *clip, int axis, int32_t scale,
                          int32_t center)
{
    const qtri_row *const row[2] = {&clip->row[axis], &clip->row[3]};
    const int32_t factor[2] = {scale * 32768, center * 32768}; /* < 2^30 */
    if (!qtri_row_combine(out, row, factor, 2, 16, 0)) {
        qtri_row left = {.t = (int64_t)center * 65536, .exponent = 1};
        left.m[axis] = scale;
        qtri_row_mul(out, &left, clip);
    }
}

/* floor(65535 x / 2) for x <= 2^17. */
static uint32_t half_depth(uint32_t x)
{
    return 32768 * x - (x + 1) / 2;
}

/* A depth plus a bias, both clamped; 0..1. */
static q16 biased(q16 depth, q16 bias)
{
    return qtri_hold32(qtri_hold32(depth, 0, Q16_ONE) + qtri_hold32(bias, -Q16_ONE, Q16_ONE), 0,
                       Q16_ONE);
}

void qtri_projector_set_depth(qtri_projector *projector, const qtri_viewport *viewport, q16 bias)
{
    const q16 near_z = biased(viewport->depth_near, bias);
    const q16 far_z = biased(viewport->depth_far, bias);
    const uint32_t reach = half_depth(qtri_magnitude32(far_z - near_z)); /* < 2^31 */
    projector->depth_center = half_depth((uint32_t)(near_z + far_z)) + 0x80u;
    projector->depth_reach = far_z < near_z ? -(int32_t)reach : (int32_t)reach;
}

void qtri_projector_init(qtri_projector *projector, const qtri_transform *object_to_clip,
                         const qtri_viewport *viewport)
{
    int32_t x = qtri_hold32(viewport->x, -QTRI_VIEWPORT_MAX, QTRI_VIEWPORT_MAX);
    int32_t y = qtri_hold32(viewport->y, -QTRI_VIEWPORT_MAX, QTRI_VIEWPORT_MAX);
    int32_t width = qtri_hold32(viewport->width, 0, QTRI_VIEWPORT_MAX);
    int32_t height = qtri_hold32(viewport->height, 0, QTRI_VIEWPORT_MAX);
    fold_viewport(&projector->row.wide[0], object_to_clip, 0, width, 2 * x + width);
    fold_viewport(&projector->row.wide[1], object_to_clip, 1, -height, 2 * y + height);
    projector->row.wide[2] = object_to_clip->row[2];
    projector->row.wide[3] = object_to_clip->row[3];

    int32_t least = INT32_MAX;
    for (int i = 0; i < 4; i++) {
        const qtri_row *row = &projector->row.wide[i];
        int empty = (row->m[0] | row->m[1] | row->m[2]) == 0 && row->t == 0;
        if (!empty && row->exponent < least) {
            least = row->exponent;
        }
    }
    for (int i = 0; i < 4; i++) {
        /* A row of zeros may have any exponent, and a user's row too: no sign is left for one. */
        const int32_t exponent = qtri_greatest32(projector->row.wide[i].exponent, least);
        const uint32_t above = (uint32_t)exponent - (uint32_t)least;
        projector->shift[i] = above < 61 ? (int32_t)above + 2 : 63;
    }

    qtri_projector_set_depth(projector, viewport, 0);
}

void qtri_projector_init_view(qtri_projector *projector, const qtri_view *view,
                              const qtri_transform *pose, q16 depth_bias,
                              qtri_transform *object_to_eye)
{
    qtri_transform object_to_clip;
    qtri_transform *to_eye = object_to_eye != NULL ? object_to_eye : &object_to_clip;
    qtri_transform_mul(to_eye, &view->camera, pose);
    qtri_transform_mul(&object_to_clip, &view->projection, to_eye);
    qtri_projector_init(projector, &object_to_clip, &view->viewport);
    if (depth_bias != 0) {
        qtri_projector_set_depth(projector, &view->viewport, depth_bias);
    }
}

/* |m| <= 2^30, |t| < 2^61: the sum stays below 3 2^61 + 2^61 = 2^63. */
QTRI_IN_PLACE int64_t row_sum(const qtri_row *row, int64_t t, q16 x, q16 y, q16 z)
{
    t += qtri_mul_s32(row->m[0], x);
    t += qtri_mul_s32(row->m[1], y);
    t += qtri_mul_s32(row->m[2], z);
    return t;
}

static void set_coordinates(qtri_clip_vertex *out, const int64_t v[4])
{
    out->x = v[0];
    out->y = v[1];
    out->z = v[2];
    out->w = v[3];
    out->b1_q30 = 0;
    out->b2_q30 = 0;
}

void qtri_projector_point(const qtri_projector *projector, const qtri_vec3 *p,
                          qtri_clip_vertex *out)
{
    int64_t sum[4];
    for (int i = 0; i < 4; i++) {
        const qtri_row *row = &projector->row.wide[i];
        sum[i] = row_sum(row, row->t, p->x, p->y, p->z) >> projector->shift[i]; /* < 2^61 */
    }
    set_coordinates(out, sum);
}

void qtri_projector_points(const qtri_projector *projector, const qtri_vec4 *const p[], int count,
                           qtri_clip_vertex out[])
{
    /* |w| up to 2^extra, 65536 counting as 1: everything is scaled down by 2^extra. */
    uint32_t largest = 65536;
    for (int i = 0; i < count; i++) {
        const uint32_t size = qtri_magnitude32(p[i]->w);
        largest = size > largest ? size : largest;
    }
    const int32_t extra = 16 - qtri_clz32(largest - 1); /* 0..15 */

    for (int i = 0; i < count; i++) {
        int64_t sum[4];
        for (int axis = 0; axis < 4; axis++) {
            const qtri_row *row = &projector->row.wide[axis];
            /* t w / 2^(16 + extra), truncated: |w| <= 2^(16 + extra), so <= |t| */
            int64_t t = qtri_mul_q62(row->t, qtri_shift_left64(p[i]->w, 46 - extra));
            sum[axis] = row_sum(row, 0, p[i]->x, p[i]->y, p[i]->z) >> extra;
            sum[axis] = (sum[axis] + t) >> projector->shift[axis];
        }
        set_coordinates(&out[i], sum);
    }
}

/*
 * Window depth in steps of 2^-8 from z in the scale of w_q32, |z_q31| <= w_q32 / 2: times the
 * reciprocal, z / w in Q29.
 */
static inline uint32_t depth_of(const qtri_projector *projector, int32_t z_q31, int32_t reciprocal)
{
    int32_t ratio_q29 = qtri_mul_high_s32(z_q31, reciprocal); /* +-2^29 */
    int32_t half = qtri_mul_high_s32(projector->depth_reach, ratio_q29 * 4);
    return (projector->depth_center + (uint32_t)half * 2u) & ~0xFFu;
}

/* Plainly within the guard band: |x|, |y| <= 2^21. */
static inline bool is_in_guard(int32_t x_24p8, int32_t y_24p8)
{
    const uint32_t reach = QTRI_SCREEN_MAX_24P8 / 2;
    return (((uint32_t)x_24p8 + reach) | ((uint32_t)y_24p8 + reach)) < 2 * reach;
}

/* x / w times 2^31 over 2^15, for |x| <= 2^14 w: the mantissa that the reciprocal multiplies. */
static int32_t scaled(int64_t x, int32_t zeros)
{
    int64_t aligned = zeros >= 15 ? qtri_shift_left64(x, zeros - 15) : x >> (15 - zeros);
    return (int32_t)(aligned >> 32); /* |.| < w 2^zeros / 2^33 < 2^31 */
}

/*
 * floor((512 x + w) / 2w): x / w in 1/256 pixel, correctly rounded. The product with the
 * reciprocal is within 1/64 of 256 x / w, so rounded down it is that or one less; the remainder,
 * exact modulo 2^64 and below 2^63 in truth, tells. Scenes with round numbers put vertices exactly
 * halfway between grid points: an estimate alone would drop them on either side.
 */
static int32_t snap(int64_t x, int64_t w, int32_t zeros, int32_t reciprocal)
{
    int64_t limit = zeros > QTRI_GUARD_LOG2 ? w << QTRI_GUARD_LOG2 : INT64_MAX;
    x = x > limit ? limit : (x < -limit ? -limit : x); /* the clipper may leave a unit too much */
    int64_t estimate = qtri_mul_s32(scaled(x, zeros), reciprocal) >> 39;
    int64_t remainder =
        qtri_wrap64(((uint64_t)x << 9) + (uint64_t)w - (((uint64_t)w << 1) * (uint64_t)estimate));
    if (remainder >= 2 * w) {
        estimate++;
    }
    return qtri_hold32((int32_t)estimate, -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
}

void qtri_project(const qtri_projector *projector, const qtri_clip_vertex *v,
                  qtri_screen_vertex *out)
{
    int64_t w = v->w > 0 ? v->w : 1;
    int32_t zeros = qtri_clz64((uint64_t)w);
    uint32_t w_q32 = (uint32_t)(((uint64_t)w << zeros) >> 32);
    int32_t reciprocal = qtri_reciprocal_below(w_q32);
    out->x_24p8 = snap(v->x, w, zeros, reciprocal);
    out->y_24p8 = snap(v->y, w, zeros, reciprocal);
    out->inv_w_q31 = (uint32_t)reciprocal;
    out->inv_w_exponent = zeros;

    int64_t z = v->z > w ? w : (v->z < -w ? -w : v->z);
    int32_t z_q31 = (int32_t)(qtri_shift_left64(z, zeros - 1) >> 32);
    int32_t least_q31 = -(int32_t)(w_q32 >> 1); /* z was rounded down, and w, too */
    out->depth_16p16 = depth_of(projector, qtri_greatest32(z_q31, least_q31), reciprocal);
}

/*
 * With R = 512 x - 2 w at, exact modulo 2^64 and within +-w in truth, R / 2w of a step are left:
 * the upper half of R 2^(zeros - 1), 31 bits and a sign, times the reciprocal 2^62 / w_q32.
 */
static int16_t rest_of(int64_t x, int64_t w, int32_t at, int32_t reciprocal)
{
    const int64_t rest =
        qtri_wrap64(((uint64_t)x << 9) - ((uint64_t)w << 1) * (uint64_t)(int64_t)at);
    if (rest < -w || rest > w) {
        return 0; /* held to the guard band */
    }
    const int32_t zeros = qtri_clz64((uint64_t)w);
    const int32_t size = (int32_t)(qtri_shift_left64(rest, zeros - 1) >> 32);
    return (int16_t)qtri_hold32((int32_t)(qtri_mul_s32(size, reciprocal) >> 46), -32768, 32767);
}

void qtri_project_rest(int16_t rest[2], const qtri_clip_vertex *v, const qtri_point *at,
                       uint32_t inv_w_q31)
{
    const int64_t w = v->w > 0 ? v->w : 1;
    rest[0] = rest_of(v->x, w, at->x_24p8, (int32_t)inv_w_q31);
    rest[1] = rest_of(v->y, w, at->y_24p8, (int32_t)inv_w_q31);
}

void qtri_vertex_exact(const qtri_projector *projector, const qtri_clip_vertex *clip,
                       qtri_vertex *out)
{
    unsigned outcode = qtri_clip_outcode(clip);
    qtri_screen_vertex screen = {0};
    if (outcode == 0) {
        qtri_project(projector, clip, &screen);
    }
    out->at.x_24p8 = screen.x_24p8;
    out->at.y_24p8 = screen.y_24p8;
    out->depth_16p8 = outcode == 0 ? screen.depth_16p16 | (uint32_t)screen.inv_w_exponent
                                   : QTRI_VERTEX_OUTSIDE | outcode;
    out->inv_w = screen.inv_w_q31;
    out->intensity_q15 = QTRI_VERTEX_UNLIT;
}

/* Projects p by 64-bit coordinates, where faster ways do not fit; false: it is outside. */
QTRI_NOINLINE static bool project_exact(const qtri_projector *projector, const qtri_vec3 *p,
                                        qtri_vertex *out)
{
    qtri_clip_vertex clip;
    qtri_projector_point(projector, p, &clip);
    qtri_vertex_exact(projector, &clip, out);
    return (out->depth_16p8 & QTRI_VERTEX_OUTSIDE) == 0;
}

/*
 * As for compact positions, from 64-bit coordinates: X = x 2^zeros / 2^45 rounded down, |X| < 2^31,
 * with w_q32 the upper half of w 2^zeros. x / w in 1/256 pixel is V / 2^9 for a V within 1/2 (r
 * below its value), 1/2 (w_q32, cut off) and 1/2 (X, 2^30 / w_q32 of what was cut off) of X r /
 * 2^32, and so -1 < V - h < 3, where h is the high word: h - 1 and h + 2 decide.
 */
enum { FAST_BITS = 9 };

/* x 2^-shift for shift >= 1, rounded down; false when it does not fit. */
static inline bool narrow(int32_t *out, int64_t x, int32_t shift)
{
    const int64_t result = x >> shift;
    *out = (int32_t)(uint32_t)((uint64_t)result & UINT32_MAX);
    return (int32_t)(result >> 32) == (*out < 0 ? -1 : 0);
}

/* Shifts from sums of rows to X, Y and z_q31, to be reduced by the leading zeros of w's sum. */
typedef struct stage {
    const qtri_projector *projector;
    int32_t x_down, y_down, z_down;
    int32_t most; /* zeros of w; 0 where shifts do not serve */
} stage;

static inline void stage_init(stage *to, const qtri_projector *projector)
{
    const int32_t *shift = projector->shift;
    to->projector = projector;
    to->z_down = 33 + shift[2] - shift[3];
    to->x_down = 45 + shift[0] - shift[3];
    to->y_down = 45 + shift[1] - shift[3];
    const int32_t down = qtri_greatest32(to->z_down, qtri_greatest32(to->x_down, to->y_down));
    to->most = down <= 63 ? 31 - shift[3] : 0;
}

/* Leading zeros of w's upper half, 0 as well for w < 0 and for 32. */
static inline int32_t zeros_of(int64_t w)
{
    return qtri_clz32((uint32_t)((uint64_t)w >> 32)) & 31;
}

/* project_exact() by 32-bit coordinates, where they decide. */
QTRI_IN_PLACE bool project_fast(const stage *to, const qtri_vec3 *p, qtri_vertex *out)
{
    const qtri_projector *projector = to->projector;
    const qtri_row *row = projector->row.wide;
    const int64_t w = row_sum(&row[3], row[3].t, p->x, p->y, p->z);
    const int32_t zeros = zeros_of(w);
    if (zeros == 0 || zeros > to->most) {
        return project_exact(projector, p, out);
    }
    const uint32_t w_low = (uint32_t)((uint64_t)w & UINT32_MAX);
    uint32_t w_q32 = (uint32_t)((uint64_t)w >> 32) << zeros | w_low >> (32 - zeros);
    int32_t z_q31, x, y;
    bool fits = narrow(&z_q31, row_sum(&row[2], row[2].t, p->x, p->y, p->z), to->z_down - zeros) &&
                narrow(&x, row_sum(&row[0], row[0].t, p->x, p->y, p->z), to->x_down - zeros) &&
                narrow(&y, row_sum(&row[1], row[1].t, p->x, p->y, p->z), to->y_down - zeros) &&
                (uint32_t)z_q31 + (w_q32 >> 1) - 2 < w_q32 - 4; /* |z_q31| < w_q32 / 2 - 1 */
    if (!fits) {
        return project_exact(projector, p, out);
    }
    int32_t r = qtri_reciprocal_below(w_q32);
    const int32_t half = (1 << (FAST_BITS - 1)) - 1; /* and the - 1 of h - 1 */
    const int32_t mask = (1 << FAST_BITS) - 1;
    x = qtri_mul_high_s32(x, r) + half;
    y = qtri_mul_high_s32(y, r) + half;
    if (((x + 3) & mask) < 3 || ((y + 3) & mask) < 3) {
        return project_exact(projector, p, out);
    }
    out->at.x_24p8 = x >> FAST_BITS;
    out->at.y_24p8 = y >> FAST_BITS;
    out->depth_16p8 = depth_of(projector, z_q31, r) | (uint32_t)(zeros + projector->shift[3]);
    out->inv_w = (uint32_t)r;
    out->intensity_q15 = QTRI_VERTEX_UNLIT;
    return true;
}

bool qtri_projector_vertices(const qtri_projector *projector, const qtri_vec3 *p, uint32_t count,
                             qtri_vertex *vertices, bool is_listed)
{
    stage to;
    stage_init(&to, projector);
    bool inside = true;
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t index = is_listed ? vertices[i].index : i;
        inside &= project_fast(&to, &p[index], &vertices[index]);
    }
    return inside;
}

static bool project_wide(const qtri_projector *projector, const qtri_mesh *mesh, uint32_t first,
                         uint32_t count, qtri_vertex *vertices, bool is_listed)
{
    return qtri_projector_vertices(projector, mesh->positions + first, count, vertices, is_listed);
}

static void transform_wide(const qtri_projector *projector, const qtri_mesh *mesh, uint32_t index,
                           qtri_clip_vertex *out)
{
    qtri_projector_point(projector, &mesh->positions[index], out);
}

const qtri_position_ops qtri_positions_wide = {.project = project_wide,
                                               .transform = transform_wide};

/* ---- Compact positions ---- */

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
    uint32_t sum = 0;
    out->t = row->t;
    out->exponent = row->exponent + 16;
    for (int i = 0; i < 3; i++) {
        out->m[i] = qtri_mul_s32(row->m[i], extent);
        out->t += qtri_mul_s32(row->m[i], origin[i]);
        sum += qtri_magnitude32(row->m[i]); /* <= 3 2^30 */
    }
    const uint64_t size = qtri_mul_u32(sum, qtri_magnitude32(extent)) + qtri_magnitude64(out->t);
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
    set_coordinates(out, v);
}

/* As project_exact(). The exponent is that of W itself: shifts are the same for all of a draw. */
QTRI_NOINLINE static bool project16_exact(const qtri_projector *projector, const qtri_position16 *p,
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

/*
 * x / w in 1/256 pixel is X 2^30 / w_q32 =: V over 2^n, where w_q32 = W 2^zeros is the normalised
 * mantissa. The high word h of X r is close: r is less than 1 below 2^62 / w_q32 and |X| < 2^30,
 * so -1/4 < V - h < 5/4. Half is added before n bits are cut off; where that of h - 1 and of h + 1
 * give the same, so does V. They do unless h + half + 1 ends in n - 1 zeros and any bit: 2 vertices
 * in 2^n have to go the exact way. `bits` is n + zeros.
 * False: outside.
 */
QTRI_IN_PLACE bool project16_fast(const qtri_projector *projector, int32_t bits,
                                  const qtri_position16 *p, qtri_vertex *out)
{
    const qtri_row16 *row = projector->row.compact;
    int32_t w = qtri_row16_sum(&row[3], p->x, p->y, p->z);
    int32_t z = qtri_row16_sum(&row[2], p->x, p->y, p->z);
    if (w <= 0 || (uint32_t)z + (uint32_t)w > 2u * (uint32_t)w) {
        return project16_exact(projector, p, out);
    }
    const int32_t zeros = qtri_clz32((uint32_t)w);
    int32_t n = bits - zeros;
    if ((uint32_t)n - 2u > 28u) {
        return project16_exact(projector, p, out);
    }
    int32_t r = qtri_reciprocal_below((uint32_t)w << zeros);
    out->inv_w = (uint32_t)r;
    out->depth_16p8 = depth_of(projector, z * ((int32_t)1 << (zeros - 1)), r) | (uint32_t)zeros;
    out->intensity_q15 = QTRI_VERTEX_UNLIT;

    int32_t half = (int32_t)(UINT32_MAX >> (33 - n)); /* 2^(n - 1), and the - 1 of h - 1 */
    int32_t x = qtri_mul_high_s32(qtri_row16_sum(&row[0], p->x, p->y, p->z), r) + half;
    int32_t y = qtri_mul_high_s32(qtri_row16_sum(&row[1], p->x, p->y, p->z), r) + half;
    out->at.x_24p8 = x >> n;
    out->at.y_24p8 = y >> n;
    if (((x + 2) & (2 * half)) == 0 || ((y + 2) & (2 * half)) == 0 ||
        !is_in_guard(x >> n, y >> n)) {
        return project16_exact(projector, p, out);
    }
    return true;
}

bool qtri_projector_vertices16(const qtri_projector *projector, const qtri_position16 *p,
                               uint32_t count, qtri_vertex *vertices, bool is_listed)
{
    const int32_t bits = 22 - projector->shift[0] + projector->shift[3];
    bool inside = true;
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t index = is_listed ? vertices[i].index : i;
        inside &= project16_fast(projector, bits, &p[index], &vertices[index]);
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
