#include "perspective.h"

#include "rows.h"
#include "setup.h"

/* What all attributes of a triangle share. */
typedef struct shared {
    const qtri_gradient *gradient;
    const uint32_t *q;
    int top, bottom;     /* of the vertices: the highest and the lowest */
    uint32_t reciprocal; /* 2^(62 - zeros) / height */
    int32_t zeros;
    uint32_t along_q31; /* of the height, from the top to row `row` */
    int32_t row;
    int32_t q_dx;     /* of inv_w, Q31 */
    uint32_t q_steep; /* its magnitude, rounded up; 2^31 where it is more */
    int32_t least_down;
} shared;

/* log2 x in 1/256, at most 22 too little: the mantissa in place of its logarithm. */
static int32_t log2_below(uint32_t x)
{
    const int32_t zeros = qtri_clz32(x | 1);
    return ((31 - zeros) * 256) + (int32_t)((x << zeros & 0x7FFFFFFFu) >> 23);
}

/* 2^(x / 256) 2^31 for x < 0, at most 2^(22 / 256) times that; else 2^31. */
static uint32_t exp2_above_q31(int32_t x)
{
    if (x >= 0) {
        return 0x80000000u;
    }
    return x < -30 * 256 ? 0 : (uint32_t)(256 + (x & 255)) << 23 >> -(x >> 8);
}

static void set_plane(qtri_projected *p, const qtri_plane *plane)
{
    p->origin = (uint32_t)(plane->origin >> 16);
    p->dx = (uint32_t)(plane->dx >> 16);
    p->dy = (uint32_t)(plane->dy >> 16);
    p->dx_rest = (uint16_t)(plane->dx & 0xFFFFu);
    p->dy_rest = (uint16_t)(plane->dy & 0xFFFFu);
}

/* The vertices' a q / 2^32, rounded: below 2^29. */
static void attribute_plane(qtri_plane *plane, const uint32_t a[3], const shared *s)
{
    uint32_t f[3];
    for (int k = 0; k < 3; k++) {
        f[k] = (uint32_t)((qtri_mul_u32(a[k], s->q[k]) + 0x80000000u) >> 32);
    }
    qtri_plane_init(plane, s->gradient, f);
}

/*
 * The product of an attribute's slope and inv_w^2 along rows,
 *
 *     K = s' q - s q' = q (s' - a q'),   s = a q,   q = inv_w / 2^31,
 *
 * does not change along a row and is linear in y: from two vertices. s' - a q' is in 2^-15 of a's
 * unit, cut to 30 bits, times inv_w, so that K is below 2^29 and times 2^(cut + 32 - 15 - 31). As curves take 15/16 of it, 1/15
 * is added.
 */
static uint32_t set_slope(qtri_projected *p, const qtri_plane *plane, const uint32_t a[3],
                          const shared *s)
{
    const int vertex[2] = {s->top, s->bottom};
    int64_t m[2];
    uint64_t all = 0;
    for (int i = 0; i < 2; i++) {
        m[i] = qtri_wrap64(plane->dx - (uint64_t)(qtri_mul_s32(s->q_dx, (int32_t)a[vertex[i]]) >> 16));
        all |= qtri_magnitude64(m[i]);
    }
    int32_t cut = 34 - qtri_clz64(all);
    cut = cut < 0 ? 0 : cut;
    int32_t k[2];
    for (int i = 0; i < 2; i++) {
        const uint32_t q = s->q[vertex[i]];
        k[i] = (int32_t)(qtri_mul_s32((int32_t)(m[i] >> cut), (int32_t)(q >> 1)) >> 31);
        k[i] += (k[i] >> 4) + (k[i] >> 8) + (k[i] >> 12) + (k[i] >> 16);
    }
    p->down = (int8_t)-(cut - 14 + p->up + 1);
    const int32_t rise = k[1] - k[0];
    const int64_t per_row = qtri_mul_s32(rise, (int32_t)s->reciprocal) >> (54 - s->zeros);
    p->slope_dy = (uint32_t)(uint64_t)per_row;
    p->slope = (uint32_t)(k[0] + (int32_t)(qtri_mul_s32(rise, (int32_t)s->along_q31) >> 31)) -
               (uint32_t)s->row * p->slope_dy;
    const uint32_t first = qtri_magnitude32(k[0]);
    const uint32_t last = qtri_magnitude32(k[1]);
    return first > last ? first : last;
}

/*
 * The least q at the start of a block of 2 h pixels, h = 2^l, see perspective.c:
 *
 *     q >= min(sqrt(72 h^3) |q'|, (72 h^3 K q'^2)^(1/4)),   q >= 4 h |q'|,   q >= q_floor
 *
 * the first of the two where `relative`; steep: log2 K. It is q in the middle that counts, and
 * where q grows that at the start too, as a span's last block has its middle sooner.
 */
static void set_limits(qtri_block_limits limits, const shared *s, bool relative, bool twisted,
                       int32_t steep, uint32_t q_floor)
{
    const int32_t slope = log2_below(s->q_steep) - 31 * 256;
    int32_t square_root = ((1580 + 2) >> 1) + slope + 22;            /* log2 72 = 6.17 */
    int32_t fourth_root = (1580 + 2 + steep + 2 * slope + 3 * 22) >> 2;
    for (int32_t l = 0; l < QTRI_BLOCK_LOG2; l++) {
        int32_t either = square_root;
        int32_t other = fourth_root;
        if (twisted && l + 1 >= QTRI_TWISTED_LOG2) {
            const bool long_one = l + 1 > QTRI_TWISTED_LOG2;
            either = (long_one ? 1930 : 1701) + slope + 22;
            const int32_t fourth = ((long_one ? 3826 : 3363) + steep + 2 * slope + 3 * 22) >> 2;
            const int32_t fifth =
                (((long_one ? 5929 : 5394) + steep + 3 * slope + 4 * 22) * 205) >> 10;
            other = qtri_greatest32(fourth, fifth);
        }
        const bool first = relative && either < other;
        const uint32_t quarter = s->q_steep >> (29 - l) != 0 ? UINT32_MAX : s->q_steep << (l + 2);
        uint32_t least = exp2_above_q31(first ? either : other);
        least = least > quarter ? least : quarter;
        least = least > q_floor ? least : q_floor;
        limits[l] = least >= 0x80000000u ? UINT32_MAX
                                         : least + (s->q_dx < 0 ? s->q_steep << l : 0);
        square_root += 384;
        fourth_root += 192;
    }
}

/*
 * Colours may stray by 2^-8 of 2^this, times 2^6 as their planes are: 1/8 of a step where they are
 * drawn, 1/16 where texels are multiplied by them.
 */
static int32_t color_unit_log2(const qtri_raster *raster, bool light)
{
    int32_t log2 = 16 + 5;
    if (raster->texture != NULL) {
        log2 = (light ? 18 : 20) + (raster->working == &qtri_colors_565 ? 2 : 0);
    }
    return log2 + QTRI_COLOR_PERSPECTIVE_SHIFT;
}

/*
 * Shades round 2^-10 of 1 and must not be negative, which leaves 1/8 of a step of 8 bits: enough
 * for the half of that by which 8 bits stray. What is for RGB565 strays by 1/4, above which it is
 * lifted.
 */
static uint32_t color_bias(const qtri_raster *raster, bool light)
{
    if (raster->texture == NULL || raster->working != &qtri_colors_565) {
        return 0x8000u;
    }
    return 0x8000u + (light ? 4096u : 12288u);
}

static void set_shared(shared *s, const qtri_triangle *t, const uint32_t q[3],
                       const qtri_gradient *gradient)
{
    s->gradient = gradient;
    s->q = q;
    for (int i = 0; i < 3; i++) {
        s->top = t->p[i] == t->top ? i : (i == 0 ? 0 : s->top);
        s->bottom = t->p[i] == t->bottom ? i : (i == 0 ? 0 : s->bottom);
    }
    const uint32_t height = (uint32_t)(t->bottom->y_24p8 - t->top->y_24p8); /* > 0 */
    s->zeros = qtri_clz32(height);
    s->reciprocal = (uint32_t)qtri_reciprocal_below(height << s->zeros);
    s->row = qtri_hold32(gradient->anchor_y, qtri_first_center(t->top->y_24p8),
                         qtri_first_center(t->bottom->y_24p8) - 1);
    const uint32_t along = (uint32_t)(s->row * 256 + 128 - t->top->y_24p8); /* < height */
    s->along_q31 = (uint32_t)(qtri_mul_u32(along << s->zeros, s->reciprocal) >> 31);
}

void qtri_perspective_init(qtri_job *job, const qtri_triangle *triangle,
                           const qtri_attributes v[3], const uint32_t value[2][3],
                           const uint32_t q[3], const qtri_gradient *gradient)
{
    qtri_perspective *p = &job->color.perspective;
    qtri_plane plane;
    shared s;
    set_shared(&s, triangle, q, gradient);
    qtri_plane_init(&plane, gradient, q);
    set_plane(&job->attribute[job->end].projected, &plane);
    const int64_t dx = qtri_wrap64(plane.dx);
    const uint64_t steep = qtri_magnitude64(dx);
    s.q_dx = (int32_t)((plane.dx + 0x8000u) >> 16);
    s.q_steep = steep >> 47 != 0 ? 0x80000000u : (uint32_t)(steep >> 16) + 1;
    const int32_t cut = qtri_greatest32(49 - qtri_clz64(steep), 0); /* to 15 bits */
    p->slope = (int32_t)(dx >> cut);
    p->slope_exponent = cut - 47;
    const bool light = job->first == QTRI_U - 1;
    int32_t least_down = 31;
    int32_t color_steep = INT32_MIN / 2;
    int32_t texel_steep = INT32_MIN / 2;
    for (int i = job->first; i < job->end; i++) {
        qtri_projected *a = &job->attribute[i].projected;
        uint32_t f[3];
        int32_t unit_log2;
        if (i < QTRI_U) {
            qtri_job_color(f, job, v, i);
            p->least[i] = INT32_MAX;
            p->greatest[i] = 0;
            for (int k = 0; k < 3; k++) {
                p->least[i] = qtri_least32(p->least[i], (int32_t)f[k]);
                p->greatest[i] = qtri_greatest32(p->greatest[i], (int32_t)f[k]);
                f[k] <<= QTRI_COLOR_PERSPECTIVE_SHIFT;
            }
            a->up = -QTRI_COLOR_PERSPECTIVE_SHIFT;
            unit_log2 = color_unit_log2(job->raster, light);
        } else {
            const qtri_texel_axis *axis = &job->axis[i - QTRI_U];
            for (int k = 0; k < 3; k++) {
                f[k] = value[i - QTRI_U][k];
            }
            a->up = axis->up;
            unit_log2 = axis->shift;
        }
        attribute_plane(&plane, f, &s);
        set_plane(a, &plane);
        const uint32_t k = set_slope(a, &plane, f, &s);
        const int32_t steepness = log2_below(k) - (a->down + a->up + 1 + unit_log2) * 256;
        least_down = qtri_least32(least_down, a->down);
        if (i < QTRI_U) {
            color_steep = qtri_greatest32(color_steep, steepness);
            a->bias = color_bias(job->raster, light);
            a->up = 0;
        } else { /* what blocks have of a value is a quarter */
            const uint32_t bias = job->axis[i - QTRI_U].bias >> 2;
            texel_steep = qtri_greatest32(texel_steep, steepness);
            a->bias = bias + (bias == 0);
            a->up = (int8_t)(a->up + 2);
        }
    }
    /*
     * Below that blocks are single pixels: 2^16, and where slopes would be shifted left by more
     * than 30, which no row of two pixels needs.
     */
    const int32_t zeros = qtri_least32(15, (30 + least_down) >> 1);
    const uint32_t q_floor = zeros < 0 ? UINT32_MAX : (uint32_t)1 << (31 - zeros);
    if (job->first < QTRI_U) {
        set_limits(p->colors, &s, false, false, color_steep, q_floor);
    }
    if (job->end > QTRI_U) {
        /* Third differences are to have bits enough. */
        const int32_t bits = qtri_least32(job->axis[0].shift + job->axis[0].up,
                                          job->axis[1].shift + job->axis[1].up);
        const bool twisted = bits >= 20;
        p->texels_twisted = twisted ? QTRI_TWISTED_LOG2 : QTRI_BLOCK_LOG2 + 1;
        set_limits(p->texels, &s, true, twisted, texel_steep, q_floor);
        for (int32_t l = 0; l < QTRI_BLOCK_LOG2; l++) { /* a bend's last half adds up to 2^(2 l + 1) */
            p->texels[l] = 2 * l + 12 > bits ? UINT32_MAX : p->texels[l];
        }
    }
}
