/* SPDX-License-Identifier: MIT */
/*
 * Alpha that varies between the vertices of a triangle. Every triangle of such a blend is drawn by
 * the stages of large ones, on a raster of its own whose colours have 8 bits a channel, and whose
 * `planes` say what alpha is at a pixel. What is interpolated, textured and fogged is what it is
 * without; the blend alone looks at the planes.
 */
#include "../bits/reciprocal.h"
#include "../frame/pixel.h"
#include "effect.h"
#include "mipmap.h"
#include "sampling.h"
#include "setup.h"
#include "stage_color.h"

/*
 * Alpha on a triangle: linear on the screen, or the quotient of two that are, alpha q and q = 1/w,
 * 2^31 for the vertex nearest to the eye. Planes are of 64 bits: at a covered pixel within 2^7
 * units of 2^30, or of 2^31 (gradient.h), so that alpha, of which 2^-10 counts, keeps that where
 * 1/w is no less than 2^-13 of its greatest. Below 2^-20, at vertices of the far side, nothing is
 * left of the quotient, and alpha is held between those of the vertices.
 */
struct qtri_alpha_planes {
    qtri_raster raster;        /* the triangle's own */
    qtri_format format;        /* its: colours of 8 bits a channel, that nothing encodes */
    const qtri_format *stored; /* the surface's */
    qtri_plane alpha;          /* 2^30 is 1; divided: times q, 2^31 */
    qtri_plane q;              /* where it is divided */
    bool divided;
    bool held;               /* centres may lie outside of the triangle, or 1/w is small there */
    int32_t least, greatest; /* of the vertices, 2^20 */
};

enum {
    BLOCK_LOG2 = 3,
    BLOCK = 8, /* pixels between quotients, from columns that are multiples of that */
    ONE_Q20 = 1 << 20,
    LEAST_Q = 1 << 18 /* of 2^31: planes, off by 2^7, leave their quotient 11 bits */
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
    const uint8_t *alphas = raster->of.material->alphas;
    return alphas != NULL ? alphas[index] : 255;
}

static void set(qtri_attributes *v, const qtri_raster *raster, const uint32_t index[3])
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

/* ---- Planes ---- */

/* Whether linear is off by 2^-12 at most: by range (q_greatest - q_least) / 4 q_least (setup.c). */
static bool is_nearly_linear(const uint32_t alpha_q16[3], const uint32_t q[3])
{
    uint32_t range[2];
    uint32_t ends[2];
    qtri_find_range(&range[0], &range[1], alpha_q16);
    qtri_find_range(&ends[0], &ends[1], q);
    return qtri_mul_u32(range[1] - range[0], ends[1] - ends[0]) >> 6 < ends[0];
}

static void set_planes(qtri_alpha_planes *p, const qtri_triangle *triangle,
                       const qtri_attributes v[3])
{
    const uint32_t alpha_q16[3] = {v[0].alpha_q16, v[1].alpha_q16, v[2].alpha_q16};
    qtri_gradient gradient;
    uint32_t q[3] = {0, 0, 0};
    uint32_t f[3];
    uint32_t ends[2];
    qtri_gradient_place(&gradient, triangle);
    qtri_gradient_init(&gradient, triangle->extent);
    qtri_find_range(&ends[0], &ends[1], alpha_q16);
    p->least = (int32_t)ends[0] << 4;
    p->greatest = (int32_t)ends[1] << 4;
    p->divided = QTRI_WITH_PERSPECTIVE && p->raster.perspective && qtri_align_inv_w(q, v) &&
                 !is_nearly_linear(alpha_q16, q);
    for (int i = 0; i < 3; i++) {
        f[i] = p->divided ? (uint32_t)(qtri_mul_u32(q[i], alpha_q16[i]) >> 16) : alpha_q16[i] << 14;
    }
    qtri_plane_init(&p->alpha, &gradient, f);
    if (p->divided) {
        qtri_plane_init(&p->q, &gradient, q);
        qtri_find_range(&ends[0], &ends[1], q);
        p->held |= ends[0] < LEAST_Q;
    }
}

static void draw(const qtri_raster *raster, qtri_triangle *triangle, const qtri_attributes v[3])
{
    qtri_alpha_planes p;
    p.raster = *raster;
    p.raster.format = &p.format;
    p.raster.of.planes = &p;
    p.format = *raster->format;
    p.format.colors = &qtri_colors_888;
    p.format.encode = NULL;
    p.stored = raster->format;
    p.held = raster->samples != NULL;
    set_planes(&p, triangle, v);
    qtri_raster *owner = qtri_levels_lend(&p.raster);
    qtri_triangle_draw_plain(&p.raster, triangle, v);
    qtri_levels_return(owner, &p.raster);
}

/* For what texels and colours become before: `draw` has the pixels'. */
static const qtri_format wide = {.colors = &qtri_colors_888};

static void begin(qtri_raster *raster)
{
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

/* What both planes are at a place of a row. */
typedef struct alpha_place {
    uint64_t alpha, q;
} alpha_place;

static void move(alpha_place *place, const qtri_alpha_planes *p, uint32_t pixels_log2)
{
    place->alpha += p->alpha.dx << pixels_log2;
    place->q += p->q.dx << pixels_log2;
}

/*
 * Whether alpha is linear from one end of a block to the other: off by their difference times that
 * of q, of 4 q, which is to be less than 2^-11. Ends may lie outside of the triangle, where q is
 * anything, and alpha held.
 */
static bool is_straight(uint64_t q0, uint64_t q1, int32_t from_q20, int32_t to_q20)
{
    const uint32_t change_q10 = qtri_magnitude32(to_q20 - from_q20) >> 10;
    const int32_t first = (int32_t)(q0 >> 24 & 0xFFFFFF); /* inside it is 2^47 at most */
    const int32_t last = (int32_t)(q1 >> 24 & 0xFFFFFF);
    const int32_t least = qtri_least32(first, last);
    if ((q0 | q1) >> 48 != 0 || least == 0 || from_q20 == ONE_Q20 || to_q20 == ONE_Q20 ||
        from_q20 == 0 || to_q20 == 0) {
        return false;
    }
    const uint32_t more = qtri_magnitude32(last - first) + 1;
    return more < (uint32_t)1 << 21 && more * (change_q10 + 1) < 2 * (uint32_t)least;
}

static void set_quotients(uint32_t *share, const qtri_alpha_planes *p, int32_t x, int32_t y,
                          int32_t count)
{
    const int32_t end = x + count;
    int32_t block = x & -BLOCK;
    alpha_place from;
    from.alpha = qtri_plane_column(qtri_plane_row(&p->alpha, y), p->alpha.dx, block);
    from.q = qtri_plane_column(qtri_plane_row(&p->q, y), p->q.dx, block);
    int32_t from_q20 = quotient_q20(from.alpha, from.q);
    while (x < end) {
        const int32_t stop = qtri_least32(block + BLOCK, end);
        alpha_place to = from;
        move(&to, p, BLOCK_LOG2);
        const int32_t to_q20 = quotient_q20(to.alpha, to.q);
        if (is_straight(from.q, to.q, from_q20, to_q20)) {
            const int32_t step = (to_q20 - from_q20) / BLOCK;
            uint32_t value = (uint32_t)(from_q20 + step * (x - block)) + 512;
            for (; x < stop; x++, value += (uint32_t)step) {
                *share++ = value >> 10;
            }
        } else {
            for (; block < x; block++) {
                move(&from, p, 0);
            }
            for (; x < stop; x++, move(&from, p, 0)) {
                *share++ = (uint32_t)(quotient_q20(from.alpha, from.q) + 512) >> 10;
            }
        }
        block = x;
        from = to;
        from_q20 = to_q20;
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
        // NOLINTNEXTLINE(clang-analyzer-core.*): all `count` were set
        share[i] = (uint32_t)qtri_hold32((int32_t)share[i], p->least >> 10, p->greatest >> 10);
    }
}

/* Times alpha of texels. */
static void multiply(uint32_t *share, const uint32_t *color, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        const uint32_t alpha = color[i] >> 24;
        // NOLINTNEXTLINE(clang-analyzer-core.*): set_shares() has set all `count`
        share[i] = (share[i] * (alpha + (alpha >> 7)) + 128) >> 8;
    }
}

/* ---- Blending ---- */

/* The first of a row's pixels. */
static const uint8_t *pixel_at(const qtri_raster *raster, uint32_t place)
{
    const qtri_surface *surface = raster->surface;
    return surface->pixels + (ptrdiff_t)(place >> 16) * surface->pitch +
           (ptrdiff_t)((place & 0xFFFF) * raster->format->pixels->bytes);
}

/* Stored pixels of a row as 0x00RRGGBB. */
static void gather(uint32_t *under, const qtri_raster *raster, uint32_t place, int32_t count)
{
    const qtri_pixels *memory = raster->format->pixels;
    const uint8_t *pixel = pixel_at(raster, place);
    for (int32_t i = 0; i < count; i++, pixel += memory->bytes) {
        under[i] = raster->format->decode(memory->load(pixel));
    }
}

/* The same as RGB565: where it is stored as that, in its place, or in `half`. */
QTRI_NOINLINE static const uint16_t *gather_565(uint16_t *half, const qtri_raster *raster,
                                                uint32_t place, int32_t count)
{
    uint32_t under[QTRI_BATCH_ROOM];
    if (raster->format->pixels->bytes == 2 && raster->of.planes->stored->encode == NULL) {
        return (const uint16_t *)(const void *)pixel_at(raster, place);
    }
    gather(under, raster, place, count);
    qtri_888_to_565(under, count);
    for (int32_t i = 0; i < count; i++) {
        half[i] = (uint16_t)under[i];
    }
    return half;
}

/* The pixels that were there again, where channels are to stay. */
static void keep_888(uint32_t *color, const qtri_raster *raster, const uint32_t *under,
                     int32_t count)
{
    const uint32_t all = QTRI_KEEP_RED | QTRI_KEEP_GREEN | QTRI_KEEP_BLUE;
    uint32_t kept = ((raster->keep & QTRI_KEEP_RED) != 0 ? 0xFF0000u : 0) |
                    ((raster->keep & QTRI_KEEP_GREEN) != 0 ? 0xFF00u : 0) |
                    ((raster->keep & QTRI_KEEP_BLUE) != 0 ? 0xFFu : 0);
    if (raster->of.planes->stored->colors->single) {
        kept = (raster->keep & all) == all ? 0xFFFFFF : 0;
    }
    for (int32_t i = 0; i < count; i++) {
        color[i] = (color[i] & ~kept) | (under[i] & kept);
    }
}

/* The same of RGB565. */
static void keep_565(uint32_t *color, const qtri_raster *raster, const uint16_t *under,
                     int32_t count)
{
    const uint32_t kept = ((raster->keep & QTRI_KEEP_RED) != 0 ? 0xF800u : 0) |
                          ((raster->keep & QTRI_KEEP_GREEN) != 0 ? 0x07E0u : 0) |
                          ((raster->keep & QTRI_KEEP_BLUE) != 0 ? 0x1Fu : 0);
    for (int32_t i = 0; i < count; i++) {
        color[i] = (color[i] & ~kept) | (under[i] & kept);
    }
}

/* A channel of 0..255 from two and a share of 1024, rounded. */
static inline uint32_t over(uint32_t color, uint32_t under, uint32_t k)
{
    return ((under << 10) + (uint32_t)((int32_t)(color - under) * (int32_t)k) + 512) >> 10;
}

static inline uint32_t sum(uint32_t color, uint32_t under, uint32_t k)
{
    const uint32_t all = under + ((color * k + 512) >> 10);
    return all < 255 ? all : 255;
}

/*
 * The same in steps of RGB565, of a colour in 8 bits: 996 / 2^13 is 31 / 255, and 2024 / 2^13 is
 * 63 / 255, each within 2^-14 of itself. Below 2^29, and rounded once.
 */
enum { FIVE = 996, SIX = 2024 };
#define HALF_565 ((uint32_t)1 << 22)

static inline uint32_t over_565(uint32_t color, uint32_t under, uint32_t k, uint32_t unit)
{
    return (((under * (1024 - k)) << 13) + color * k * unit + HALF_565) >> 23;
}

static inline uint32_t sum_565(uint32_t color, uint32_t under, uint32_t k, uint32_t unit)
{
    const uint32_t all = under + ((color * k * unit + HALF_565) >> 23);
    const uint32_t most = unit == SIX ? 63 : 31;
    return all < most ? all : most;
}

#define MIX_565(MIXED)                                                                             \
    for (int32_t i = 0; i < count; i++) {                                                          \
        const uint32_t c = color[i];                                                               \
        const uint32_t u = under[i];                                                               \
        const uint32_t k = share[i];                                                               \
        color[i] = MIXED(c << 8 >> 24, u >> 11, k, FIVE) << 11 |                                   \
                   MIXED(c << 16 >> 24, u << 21 >> 26, k, SIX) << 5 |                              \
                   MIXED(c & 255, u & 31, k, FIVE);                                                \
    }

#define MIX_888(MIXED)                                                                             \
    for (int32_t i = 0; i < count; i++) {                                                          \
        const uint32_t c = color[i];                                                               \
        const uint32_t u = under[i];                                                               \
        const uint32_t k = share[i];                                                               \
        color[i] = MIXED(c << 8 >> 24, u >> 16 & 255, k) << 16 |                                   \
                   MIXED(c << 16 >> 24, u >> 8 & 255, k) << 8 | MIXED(c & 255, u & 255, k);        \
    }

/* NOLINTBEGIN(clang-analyzer-core.*): set_shares() has set all `count` shares */
static void mix_565(uint32_t *color, const qtri_raster *raster, const uint32_t *share,
                    uint32_t place, int32_t count, bool adds)
{
    uint16_t half[QTRI_BATCH_ROOM];
    const uint16_t *under = gather_565(half, raster, place, count);
    if (adds) {
        MIX_565(sum_565)
    } else {
        MIX_565(over_565)
    }
    if (raster->keep != 0) {
        keep_565(color, raster, under, count);
    }
}

static void mix_888(uint32_t *color, const qtri_raster *raster, const uint32_t *share,
                    uint32_t place, int32_t count, bool adds)
{
    uint32_t under[QTRI_BATCH_ROOM];
    gather(under, raster, place, count);
    const bool gray = raster->of.planes->stored->colors == &qtri_colors_gray;
    if (gray) {
        qtri_888_to_gray(color, count);
    }
    if (adds) {
        MIX_888(sum)
    } else {
        MIX_888(over)
    }
    if (raster->keep != 0) {
        keep_888(color, raster, under, count);
    }
    for (int32_t i = 0; gray && i < count; i++) {
        color[i] &= 255;
    }
}

/* NOLINTEND(clang-analyzer-core.*) */

static void apply(const qtri_raster *raster, uint32_t *color, const qtri_fragments *at,
                  int32_t count, bool adds)
{
    const qtri_format *stored = raster->of.planes->stored;
    uint32_t share[QTRI_BATCH_ROOM];
    set_shares(share, raster->of.planes, (int32_t)(at->first & 0xFFFF),
               (int32_t)(at->first >> 16) + raster->surface->first_row, count);
    if (raster->wide) {
        multiply(share, color, count);
    }
    if (stored->colors == &qtri_colors_565) {
        mix_565(color, raster, share, at->first, count, adds);
    } else {
        mix_888(color, raster, share, at->first, count, adds);
    }
    if (stored->encode != NULL) {
        stored->encode(color, count);
    }
}

/* Lines have no planes. */
static uint32_t blend_over(const qtri_raster *raster, uint32_t *color, const qtri_fragments *at,
                           uint32_t mask, int32_t count)
{
    if (raster->of.planes == NULL) {
        return qtri_blend_alpha.apply(raster, color, at, mask, count);
    }
    apply(raster, color, at, count, false);
    return mask;
}

static uint32_t blend_add(const qtri_raster *raster, uint32_t *color, const qtri_fragments *at,
                          uint32_t mask, int32_t count)
{
    if (raster->of.planes == NULL) {
        return qtri_blend_add.apply(raster, color, at, mask, count);
    }
    apply(raster, color, at, count, true);
    return mask;
}

static const qtri_vertex_blend by_vertex = {begin, draw, set, note, at};

const qtri_blend qtri_blend_vertex_alpha = {&qtri_effects, blend_over, NULL,  NULL,
                                            false,         &by_vertex, false, QTRI_ALPHA};
const qtri_blend qtri_blend_vertex_add = {&qtri_effects, blend_add,  NULL,  NULL,
                                          false,         &by_vertex, false, QTRI_ADD};
