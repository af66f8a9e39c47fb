#include "projector.h"

#include "../math/bits.h"
#include "../math/wide.h"
#include "row.h"

/* scale clip_row + center w_row, for a half-pixel unit: scale and center count halves. */
static void fold_viewport(qtri_row *out, const qtri_row *axis, int32_t scale, const qtri_row *w,
                          int32_t center)
{
    qtri_wide element[4];
    for (int i = 0; i < 4; i++) {
        qtri_wide scaled = qtri_wide_mul(qtri_row_element(axis, i), qtri_wide_make(scale, 1));
        qtri_wide moved = qtri_wide_mul(qtri_row_element(w, i), qtri_wide_make(center, 1));
        element[i] = qtri_wide_add(scaled, moved);
    }
    qtri_row_from_wide(out, element);
}

static int32_t hold(int32_t x, int32_t low, int32_t high)
{
    return x < low ? low : (x > high ? high : x);
}

void qtri_projector_init(qtri_projector *projector, const qtri_transform *object_to_clip,
                         const qtri_viewport *viewport)
{
    int32_t x = hold(viewport->x, -QTRI_VIEWPORT_MAX, QTRI_VIEWPORT_MAX);
    int32_t y = hold(viewport->y, -QTRI_VIEWPORT_MAX, QTRI_VIEWPORT_MAX);
    int32_t width = hold(viewport->width, 0, QTRI_VIEWPORT_MAX);
    int32_t height = hold(viewport->height, 0, QTRI_VIEWPORT_MAX);
    const qtri_row *clip = object_to_clip->row;
    fold_viewport(&projector->row[0], &clip[0], width, &clip[3], 2 * x + width);
    fold_viewport(&projector->row[1], &clip[1], -height, &clip[3], 2 * y + height);
    projector->row[2] = clip[2];
    projector->row[3] = clip[3];

    int32_t least = INT32_MAX;
    for (int i = 0; i < 4; i++) {
        const qtri_row *row = &projector->row[i];
        int empty = (row->m[0] | row->m[1] | row->m[2]) == 0 && row->t == 0;
        if (!empty && row->exponent < least) {
            least = row->exponent;
        }
    }
    for (int i = 0; i < 4; i++) {
        int32_t shift = projector->row[i].exponent - least + 2;
        projector->shift[i] = hold(shift, 2, 63);
    }

    int64_t near_z = q16_clamp(viewport->depth_near, 0, Q16_ONE);
    int64_t far_z = q16_clamp(viewport->depth_far, 0, Q16_ONE);
    projector->depth_sum = (near_z + far_z) * 65535;
    projector->depth_span = (far_z - near_z) * 65535;
}

/* |m| <= 2^30, |t| < 2^61: the sum stays below 3 2^61 + 2^61 = 2^63. */
static int64_t row_sum(const qtri_row *row, int64_t t, q16 x, q16 y, q16 z)
{
    return (int64_t)row->m[0] * x + (int64_t)row->m[1] * y + (int64_t)row->m[2] * z + t;
}

void qtri_projector_point(const qtri_projector *projector, const qtri_vec3 *p,
                          qtri_clip_vertex *out)
{
    int64_t sum[4];
    for (int i = 0; i < 4; i++) {
        const qtri_row *row = &projector->row[i];
        sum[i] = row_sum(row, row->t, p->x, p->y, p->z) >> projector->shift[i]; /* < 2^61 */
    }
    out->x = sum[0];
    out->y = sum[1];
    out->z = sum[2];
    out->w = sum[3];
    out->b1_q30 = 0;
    out->b2_q30 = 0;
}

/* t w / 2^bits, truncated, for |t| < 2^61 and |t w / 2^bits| < 2^62; 16 <= bits <= 32. */
static int64_t scale_translation(int64_t t, q16 w, int32_t bits)
{
    uint64_t size = qtri_mul_high64(qtri_magnitude64(t) << 2, qtri_magnitude64(w) << (62 - bits));
    return (t < 0) == (w < 0) ? (int64_t)size : -(int64_t)size;
}

void qtri_projector_points(const qtri_projector *projector, const qtri_vec4 *const p[], int count,
                           qtri_clip_vertex out[])
{
    /* |w| up to 2^extra, 65536 counting as 1: everything is scaled down by 2^extra. */
    uint64_t largest = 0;
    for (int i = 0; i < count; i++) {
        uint64_t size = qtri_magnitude64(p[i]->w);
        largest = size > largest ? size : largest;
    }
    int32_t extra = largest > 65536 ? 48 - qtri_clz64(largest - 1) : 0; /* 0..15 */

    for (int i = 0; i < count; i++) {
        int64_t sum[4];
        for (int axis = 0; axis < 4; axis++) {
            const qtri_row *row = &projector->row[axis];
            int64_t t = scale_translation(row->t, p[i]->w, 16 + extra); /* <= |t| */
            sum[axis] = row_sum(row, 0, p[i]->x, p[i]->y, p[i]->z) >> extra;
            sum[axis] = (sum[axis] + t) >> projector->shift[axis];
        }
        out[i].x = sum[0];
        out[i].y = sum[1];
        out[i].z = sum[2];
        out[i].w = sum[3];
        out[i].b1_q30 = i == 1 ? (int32_t)1 << 30 : 0;
        out[i].b2_q30 = i == 2 ? (int32_t)1 << 30 : 0;
    }
}

/* x / w times 2^31 over 2^15, for |x| <= 2^14 w: the mantissa that the reciprocal multiplies. */
static int64_t scaled(int64_t x, int32_t zeros)
{
    int64_t aligned = zeros >= 15 ? x * ((int64_t)1 << (zeros - 15)) : x >> (15 - zeros);
    return aligned >> 32;
}

/*
 * floor((512 x + w) / 2w): x / w in 1/256 pixel, correctly rounded. The product with the
 * reciprocal is within one of it; the remainder, exact modulo 2^64 and below 2^63 in truth, tells.
 * Scenes with round numbers put vertices exactly halfway between grid points: an estimate alone
 * would drop them on either side.
 */
static int32_t snap(int64_t x, int64_t w, int32_t zeros, uint32_t reciprocal)
{
    int64_t limit = zeros > QTRI_GUARD_LOG2 ? w << QTRI_GUARD_LOG2 : INT64_MAX;
    x = x > limit ? limit : (x < -limit ? -limit : x); /* the clipper may leave a unit too much */
    int64_t estimate = (scaled(x, zeros) * reciprocal + ((int64_t)1 << 38)) >> 39;
    int64_t remainder =
        qtri_wrap64(((uint64_t)x << 9) + (uint64_t)w - (((uint64_t)w << 1) * (uint64_t)estimate));
    if (remainder < 0) {
        estimate--;
    } else if (remainder >= 2 * w) {
        estimate++;
    }
    return hold((int32_t)estimate, -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
}

void qtri_project(const qtri_projector *projector, const qtri_clip_vertex *v,
                  qtri_screen_vertex *out)
{
    int64_t w = v->w > 0 ? v->w : 1;
    int32_t zeros = qtri_clz64((uint64_t)w);
    uint64_t w_normal = (uint64_t)w << zeros;
    uint32_t reciprocal = qtri_reciprocal_q62((uint32_t)(w_normal >> 32));
    out->x_24p8 = snap(v->x, w, zeros, reciprocal);
    out->y_24p8 = snap(v->y, w, zeros, reciprocal);
    out->inv_w_q31 = reciprocal;
    out->inv_w_exponent = zeros;

    int64_t z = v->z > w ? w : (v->z < -w ? -w : v->z);
    int64_t z_q31 = z < 0 ? -(int64_t)(((uint64_t)-z << zeros) >> 33)
                          : (int64_t)(((uint64_t)z << zeros) >> 33); /* of w's mantissa */
    int64_t ratio_q31 = (z_q31 * reciprocal) >> 30;                  /* [-2^31, 2^31] */
    int64_t depth = projector->depth_sum + ((projector->depth_span * ratio_q31) >> 31);
    out->depth_16p16 = (uint32_t)(depth >> 1);
}
