/* SPDX-License-Identifier: MIT */
#include "blend_vertex.h"

#include "../bits/reciprocal.h"
#include "../frame/pixel.h"
#include "effect.h"
#include "samples.h"
#include "setup.h"
#include "stage_color.h"

/*
 * Alpha on a triangle: linear on the screen, or the quotient of two that are, alpha q and q = 1/w,
 * 2^31 for the vertex nearest to the eye. Planes are of 64 bits: at a covered pixel within 2^7
 * units of 2^30, or of 2^31 (gradient.h), so that alpha, of which 2^-10 counts, keeps that where
 * 1/w is no less than 2^-13 of its greatest.
 */
struct qtri_alpha_planes {
    qtri_raster raster;        /* the triangle's own */
    qtri_format format;        /* its: colours of 8 bits a channel, that nothing encodes */
    const qtri_format *stored; /* the surface's */
    qtri_plane alpha;          /* 2^30 is 1; divided: times q, 2^31 */
    qtri_plane q;              /* where it is divided */
    bool divided;
    bool held;               /* centres may lie outside of the triangle */
    int32_t least, greatest; /* of the vertices, 2^20 */
};

enum {
    BLOCK = 8, /* pixels between quotients, from columns that are multiples of that */
    ONE_Q20 = 1 << 20
};

/* ---- Alpha of vertices ---- */

/* a b / 255^2 in Q16: 66051 is 2^32 / 255^2 less .73, and what it lacks at 1 is added. */
static uint32_t product_q16(uint32_t a, uint32_t b)
{
    const uint32_t p = a * b;
    return ((p * 66051u) >> 16) + (p >> 15);
}

static uint32_t alpha_of(const qtri_raster *raster, uint32_t index)
{
    return raster->alphas != NULL ? raster->alphas[index] : 255;
}

static void set(qtri_attributes v[3], const qtri_raster *raster, const uint32_t index[3])
{
    for (int i = 0; i < 3; i++) {
        v[i].alpha_q16 = product_q16(alpha_of(raster, index[i]), raster->alpha);
    }
}

static void note(const qtri_raster *raster, const uint32_t index[3])
{
    for (int i = 0; i < 3; i++) {
        raster->batch->alpha[i] = (uint8_t)alpha_of(raster, index[i]);
    }
}

static uint32_t at(const qtri_raster *raster, int32_t b1_q30, int32_t b2_q30)
{
    int32_t a[3];
    for (int i = 0; i < 3; i++) {
        a[i] = (int32_t)product_q16(raster->batch->alpha[i], raster->alpha);
    }
    const int64_t more = qtri_mul_s32(a[1] - a[0], b1_q30) + qtri_mul_s32(a[2] - a[0], b2_q30);
    return (uint32_t)qtri_hold32(a[0] + (int32_t)(more >> 30), 0, 65536);
}

static const qtri_vertex_blend by_vertex = {set, note, at};

/* ---- Planes ---- */

/* 1/w with one exponent, the largest in 2^30..2^31. False when all are equal. */
static bool align(uint32_t q[3], const qtri_attributes v[3])
{
    int32_t greatest = qtri_greatest32(v[0].inv_w_exponent, v[1].inv_w_exponent);
    greatest = qtri_greatest32(greatest, v[2].inv_w_exponent);
    for (int i = 0; i < 3; i++) {
        const uint32_t down = (uint32_t)greatest - (uint32_t)v[i].inv_w_exponent;
        q[i] = down > 29 ? 1 : v[i].inv_w_q31 >> down;
    }
    return q[0] != q[1] || q[0] != q[2];
}

static void find_range(uint32_t *least, uint32_t *greatest, const uint32_t f[3])
{
    *least = f[0];
    *greatest = f[0];
    for (int i = 1; i < 3; i++) {
        *least = f[i] < *least ? f[i] : *least;
        *greatest = f[i] > *greatest ? f[i] : *greatest;
    }
}

/* Whether linear is off by 2^-12 at most: by range (q_greatest - q_least) / 4 q_least (setup.c). */
static bool is_nearly_linear(const uint32_t alpha_q16[3], const uint32_t q[3])
{
    uint32_t range[2];
    uint32_t ends[2];
    find_range(&range[0], &range[1], alpha_q16);
    find_range(&ends[0], &ends[1], q);
    return qtri_mul_u32(range[1] - range[0], ends[1] - ends[0]) >> 6 < ends[0];
}

static void set_planes(qtri_alpha_planes *p, const qtri_triangle *triangle,
                       const qtri_attributes v[3])
{
    const uint32_t alpha_q16[3] = {v[0].alpha_q16, v[1].alpha_q16, v[2].alpha_q16};
    qtri_gradient gradient;
    uint32_t q[3];
    uint32_t f[3];
    uint32_t ends[2];
    qtri_gradient_place(&gradient, triangle);
    qtri_gradient_init(&gradient, triangle->extent);
    find_range(&ends[0], &ends[1], alpha_q16);
    p->least = (int32_t)ends[0] << 4;
    p->greatest = (int32_t)ends[1] << 4;
    p->divided = QTRI_WITH_PERSPECTIVE && p->raster.perspective && align(q, v) &&
                 !is_nearly_linear(alpha_q16, q);
    for (int i = 0; i < 3; i++) {
        f[i] = p->divided ? (uint32_t)(qtri_mul_u32(q[i], alpha_q16[i]) >> 16) : alpha_q16[i] << 14;
    }
    qtri_plane_init(&p->alpha, &gradient, f);
    if (p->divided) {
        qtri_plane_init(&p->q, &gradient, q);
    }
}

static void draw(const qtri_raster *raster, qtri_triangle *triangle, const qtri_attributes v[3])
{
    qtri_alpha_planes p;
    p.raster = *raster;
    p.raster.format = &p.format;
    p.raster.planes = &p;
    p.format = *raster->format;
    p.format.colors = &qtri_colors_888;
    p.format.encode = NULL;
    p.stored = raster->format;
    p.held = raster->samples != NULL;
    set_planes(&p, triangle, v);
    if (raster->samples != NULL) {
        raster->samples->draw(&p.raster, triangle, v);
    } else {
        qtri_triangle_draw_plain(&p.raster, triangle, v);
    }
}

/* For what texels and colours become before: `draw` has the pixels'. */
static const qtri_format wide = {.colors = &qtri_colors_888};

static void begin(qtri_raster *raster)
{
    raster->by_vertex = &by_vertex;
    raster->units = &qtri_colors_888;
    raster->format = &wide;
    raster->route = draw;
}

/* ---- Alpha of pixels ---- */

/* alpha q / q in Q20: two numbers of 16 bits, so within 2^-14. */
static int32_t quotient_q20(uint64_t alpha, uint64_t q)
{
    if ((int64_t)alpha <= 0 || (int64_t)q <= 0) {
        return 0;
    }
    if (alpha >= q) {
        return ONE_Q20;
    }
    const int32_t zeros = qtri_clz64(q);
    const uint32_t divisor = (uint32_t)((q << zeros) >> 32);
    const uint32_t numerator = (uint32_t)((alpha << zeros) >> 48);
    return (int32_t)((numerator * (qtri_reciprocal_near(divisor) >> 15)) >> 11);
}

/* One end of a block. */
typedef struct alpha_end {
    uint64_t alpha, q;
    int32_t value_q20;
} alpha_end;

static void set_end(alpha_end *end, const qtri_alpha_planes *p, int32_t x, int32_t y)
{
    end->alpha = qtri_plane_column(qtri_plane_row(&p->alpha, y), p->alpha.dx, x);
    end->q = qtri_plane_column(qtri_plane_row(&p->q, y), p->q.dx, x);
    end->value_q20 = quotient_q20(end->alpha, end->q);
}

/*
 * Whether alpha is linear from end to end: off by their difference times that of q, of 4 q, which
 * is to be less than 2^-11. Ends may lie outside of the triangle, where q is anything.
 */
static bool is_straight(const alpha_end *a, const alpha_end *b)
{
    const uint32_t change = qtri_magnitude32(b->value_q20 - a->value_q20) >> 6; /* <= 2^14 */
    const uint64_t least = a->q < b->q ? a->q : b->q;
    const uint64_t more = a->q < b->q ? b->q - a->q : a->q - b->q;
    if ((int64_t)a->q <= 0 || (int64_t)b->q <= 0 || a->value_q20 == ONE_Q20 ||
        b->value_q20 == ONE_Q20 || a->value_q20 == 0 || b->value_q20 == 0) {
        return false;
    }
    return (more >> 16) * change < least >> 13; /* 2^31 2^14 */
}

static void set_quotients(uint32_t *share, const qtri_alpha_planes *p, int32_t x, int32_t y,
                          int32_t count)
{
    const int32_t end = x + count;
    int32_t block = x & -BLOCK;
    alpha_end from;
    alpha_end to;
    set_end(&from, p, block, y);
    while (x < end) {
        const int32_t stop = qtri_least32(block + BLOCK, end);
        set_end(&to, p, block + BLOCK, y);
        const bool straight = is_straight(&from, &to);
        for (; x < stop; x++) {
            const int32_t k = x - block;
            int32_t value_q20 = from.value_q20 + (to.value_q20 - from.value_q20) / BLOCK * k;
            if (!straight) {
                value_q20 = quotient_q20(from.alpha + p->alpha.dx * (uint64_t)(int64_t)k,
                                         from.q + p->q.dx * (uint64_t)(int64_t)k);
            }
            *share++ = (uint32_t)(value_q20 + 512) >> 10;
        }
        block += BLOCK;
        from = to;
    }
}

/* Alpha of pixels of a row: shares of 1024. */
static void set_shares(uint32_t *share, const qtri_alpha_planes *p, int32_t x, int32_t y,
                       int32_t count)
{
    if (p->divided) {
        set_quotients(share, p, x, y, count);
    } else {
        const uint64_t first = qtri_plane_column(qtri_plane_row(&p->alpha, y), p->alpha.dx, x);
        uint32_t alpha_q30 = (uint32_t)(first >> 16) + ((uint32_t)1 << 19);
        const uint32_t step = (uint32_t)(p->alpha.dx >> 16);
        for (int32_t i = 0; i < count; i++, alpha_q30 += step) {
            share[i] = (uint32_t)((int32_t)alpha_q30 >> 20);
        }
    }
    for (int32_t i = 0; p->held && i < count; i++) {
        share[i] = (uint32_t)qtri_hold32((int32_t)share[i], p->least >> 10, p->greatest >> 10);
    }
}

/* Times alpha of texels. */
static void multiply(uint32_t *share, const uint32_t *color, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        const uint32_t alpha = color[i] >> 24;
        share[i] = (share[i] * (alpha + (alpha >> 7)) + 128) >> 8;
    }
}

/* ---- Blending ---- */

/* Stored pixels of a row as 0x00RRGGBB. */
static void gather(uint32_t *under, const qtri_raster *raster, uint32_t place, int32_t count)
{
    const qtri_surface *surface = raster->surface;
    const qtri_pixels *memory = raster->format->pixels;
    const qtri_format *stored = raster->planes->stored;
    const uint8_t *pixel = surface->pixels + (ptrdiff_t)(place >> 16) * surface->pitch +
                           (ptrdiff_t)((place & 0xFFFF) * memory->bytes);
    if (memory->bytes == 2 && stored->colors == &qtri_colors_565 && stored->encode == NULL) {
        for (int32_t i = 0; i < count; i++) {
            under[i] = ((const uint16_t *)(const void *)pixel)[i];
        }
        qtri_565_to_888(under, count);
        return;
    }
    for (int32_t i = 0; i < count; i++, pixel += memory->bytes) {
        under[i] = stored->decode(memory->load(pixel));
    }
}

/* A channel of 0..255 in 2^-10, of two and a share of 1024; below 2^18. */
static inline uint32_t over(uint32_t color, uint32_t under, uint32_t k)
{
    return (under << 10) + (uint32_t)((int32_t)(color - under) * (int32_t)k);
}

static inline uint32_t sum(uint32_t color, uint32_t under, uint32_t k)
{
    const uint32_t all = (under << 10) + color * k;
    return all < (uint32_t)255 << 10 ? all : (uint32_t)255 << 10;
}

/* That in steps of 8 bits; and, with 15 bits of it, of 5 and of 6: 63738 is 31 2^26 / (255 2^7). */
static inline uint32_t to_8(uint32_t channel_q10)
{
    return (channel_q10 + 512) >> 10;
}

static inline uint32_t to_5(uint32_t channel_q10)
{
    return (((channel_q10 + 4) >> 3) * 63738u + ((uint32_t)1 << 25)) >> 26;
}

static inline uint32_t to_6(uint32_t channel_q10)
{
    return (((channel_q10 + 4) >> 3) * 64766u + ((uint32_t)1 << 24)) >> 25;
}

#define MIX(MIXED, RED, GREEN, BLUE, red_at, green_at)                                             \
    for (int32_t i = 0; i < count; i++) {                                                          \
        const uint32_t c = color[i];                                                               \
        const uint32_t u = under[i];                                                               \
        const uint32_t k = share[i];                                                               \
        color[i] = RED(MIXED(c >> 16 & 255, u >> 16 & 255, k & keep[0])) << (red_at) |             \
                   GREEN(MIXED(c >> 8 & 255, u >> 8 & 255, k & keep[1])) << (green_at) |           \
                   BLUE(MIXED(c & 255, u & 255, k & keep[2]));                                     \
    }

/* Which shares count: all bits, or none of channels that are kept. */
static void set_kept(uint32_t keep[3], const qtri_raster *raster)
{
    const uint32_t bits[3] = {QTRI_KEEP_RED, QTRI_KEEP_GREEN, QTRI_KEEP_BLUE};
    const uint32_t all = QTRI_KEEP_RED | QTRI_KEEP_GREEN | QTRI_KEEP_BLUE;
    for (int i = 0; i < 3; i++) {
        const uint32_t bit = raster->planes->stored->colors->single ? all : bits[i];
        keep[i] = (raster->keep & bit) == bit ? 0 : UINT32_MAX;
    }
}

QTRI_INLINE void apply(const qtri_raster *raster, uint32_t *color, const qtri_fragments *at,
                       int32_t count, bool adds)
{
    const qtri_format *stored = raster->planes->stored;
    uint32_t share[QTRI_BATCH_ROOM];
    uint32_t under[QTRI_BATCH_ROOM];
    uint32_t keep[3];
    set_shares(share, raster->planes, (int32_t)(at->first & 0xFFFF),
               (int32_t)(at->first >> 16) + raster->surface->first_row, count);
    if (raster->wide) {
        multiply(share, color, count);
    }
    set_kept(keep, raster);
    gather(under, raster, at->first, count);
    if (stored->colors == &qtri_colors_565) {
        if (adds) {
            MIX(sum, to_5, to_6, to_5, 11, 5)
        } else {
            MIX(over, to_5, to_6, to_5, 11, 5)
        }
    } else if (stored->colors == &qtri_colors_888) {
        if (adds) {
            MIX(sum, to_8, to_8, to_8, 16, 8)
        } else {
            MIX(over, to_8, to_8, to_8, 16, 8)
        }
    } else {
        qtri_888_to_gray(color, count);
        for (int32_t i = 0; i < count; i++) {
            const uint32_t k = share[i] & keep[0];
            color[i] =
                to_8(adds ? sum(color[i], under[i] & 255, k) : over(color[i], under[i] & 255, k));
        }
    }
    if (stored->encode != NULL) {
        stored->encode(color, count);
    }
}

/* Lines have no planes. */
static uint32_t blend_over(const qtri_raster *raster, uint32_t *color, const qtri_fragments *at,
                           uint32_t mask, int32_t count)
{
    if (raster->planes == NULL) {
        return qtri_blend_alpha.apply(raster, color, at, mask, count);
    }
    apply(raster, color, at, count, false);
    return mask;
}

static uint32_t blend_add(const qtri_raster *raster, uint32_t *color, const qtri_fragments *at,
                          uint32_t mask, int32_t count)
{
    if (raster->planes == NULL) {
        return qtri_blend_add.apply(raster, color, at, mask, count);
    }
    apply(raster, color, at, count, true);
    return mask;
}

const qtri_blend qtri_blend_vertex_alpha = {&qtri_effects, blend_over, false, begin};
const qtri_blend qtri_blend_vertex_add = {&qtri_effects, blend_add, false, begin};
