#include "small.h"

#include "fill.h"
#include "packed.h"
#include "rows.h"

/* A ramp's origin from the anchor to column 0 of `row`. */
static inline void move(qtri_ramp *ramp, const qtri_gradient *g, int32_t row)
{
    ramp->origin += (uint32_t)(row - g->anchor_y) * ramp->dy - (uint32_t)g->anchor_x * ramp->dx;
}

/*
 * Positions, area and anchor: as of the general path, see setup.c. False for a triangle that is
 * large or a sliver.
 */
static inline bool gradient_from(qtri_gradient *g, const qtri_triangle *t)
{
    const uint32_t size = qtri_magnitude32((int32_t)t->area);
    if (t->size == QTRI_LARGE || qtri_gradient_is_sliver(size, t->extent)) {
        return false;
    }
    g->area = t->area;
    int32_t zeros = qtri_clz32(size);
    qtri_gradient_set_inverse(g, qtri_reciprocal_below(size << zeros) >> 1, zeros);
    g->x_24p8 = t->p[0]->x_24p8;
    g->y_24p8 = t->p[0]->y_24p8;
    g->dx1 = t->p[1]->x_24p8 - g->x_24p8;
    g->dy1 = t->p[1]->y_24p8 - g->y_24p8;
    g->dx2 = t->p[2]->x_24p8 - g->x_24p8;
    g->dy2 = t->p[2]->y_24p8 - g->y_24p8;
    g->anchor_x = (t->x_least + t->x_greatest) >> 9;
    g->anchor_y = (t->top->y_24p8 + t->bottom->y_24p8) >> 9;
    g->anchor_dx = g->anchor_x * 256 + 128 - g->x_24p8;
    g->anchor_dy = g->anchor_y * 256 + 128 - g->y_24p8;
    return true;
}

/* And not cut off at a side. */
static inline bool is_tiny(const qtri_triangle *t)
{
    return t->size == QTRI_TINY && !t->cut;
}

/* False where a difference does not fit. */
static inline bool depth_from(qtri_ramp *out, const qtri_gradient *g, const qtri_vertex *a,
                              const qtri_vertex *b, const qtri_vertex *c)
{
    const uint32_t reach = (uint32_t)1 << 15;
    const uint32_t z0 = a->depth_16p8 >> 8;
    const uint32_t z1 = (b->depth_16p8 >> 8) - z0;
    const uint32_t z2 = (c->depth_16p8 >> 8) - z0;
    if (((z1 + reach) | (z2 + reach)) >= 2 * reach) {
        return false;
    }
    qtri_ramp_from_steps(out, g, z0 << 8, ((int32_t)z1 + 1) >> (QTRI_RAMP_DOWN - 8),
                         ((int32_t)z2 + 1) >> (QTRI_RAMP_DOWN - 8));
    return true;
}

/* The rows of a tiny triangle: of packed colours, or of one pixel. Ramps start at column 0. */
static inline void fill(const qtri_raster *raster, const qtri_triangle *t, const qtri_ramp *depth,
                        const qtri_ramp *color, uint32_t pixel, bool smooth)
{
    qtri_lines lines = qtri_lines_at(raster->surface, t->row);
    const ptrdiff_t pitch = raster->surface->pitch;
    const ptrdiff_t depth_pitch = raster->surface->depth_pitch;
    uint32_t depth_step = depth->dx;
    const uint32_t step = smooth ? color->dx : 0;
    const uint32_t color_dy = smooth ? color->dy : 0;
    uint32_t depth_row = depth->origin;
    uint32_t color_row = smooth ? color->origin : 0;
    const qtri_span *span = t->spans;
    for (int32_t count = t->end - t->row; count > 0; count--, span++) {
        int32_t x = span->left;
        const int32_t stop = span->right;
        if (x < stop) {
            uint16_t *pixels = (uint16_t *)(void *)lines.pixels;
            uint16_t *depths = lines.depths;
            uint32_t z = depth_row + (uint32_t)x * depth_step;
            uint32_t packed = color_row + (uint32_t)x * step;
            do {
                if (z >> 16 < depths[x]) {
                    QTRI_BRANCH
                    depths[x] = (uint16_t)(z >> 16);
                    pixels[x] = (uint16_t)(smooth ? qtri_packed_pixel(packed) : pixel);
                }
                z += depth_step;
                packed += step;
                QTRI_ASIDE(depth_step)
            } while (++x < stop);
        }
        depth_row += depth->dy;
        color_row += color_dy;
        lines.pixels += pitch;
        lines.depths += depth_pitch;
    }
}

/* |x| or one less. */
static inline uint32_t magnitude(int32_t x)
{
    return (uint32_t)(x ^ (x >> 31));
}

/*
 * Whether no colour strays for being linear on the screen, for intensities i1 and i2 from that of
 * vertex 0: enough for the general path's nearly_linear, range q_range < 2^16 q_least for a share
 * in Q22, since q_least >= 2^30. Neither range is more than the sum of its two differences.
 */
static inline bool is_linear(const qtri_vertex *a, const qtri_vertex *b, const qtri_vertex *c,
                             int32_t i1_q15, int32_t i2_q15)
{
    const uint32_t range_q15 = magnitude(i1_q15) + magnitude(i2_q15) + 2; /* <= 2^16 + 2 */
    const int32_t q0 = (int32_t)(a->inv_w >> 1);                          /* 2^29..2^30 */
    const uint32_t q_range = magnitude((int32_t)(b->inv_w >> 1) - q0) +
                             magnitude((int32_t)(c->inv_w >> 1) - q0) + 4; /* <= 2^30 + 4 */
    const uint32_t exponents = (a->depth_16p8 ^ b->depth_16p8) | (a->depth_16p8 ^ c->depth_16p8);
    return (exponents & 0xFF) == 0 && range_q15 * ((q_range >> 15) + 1) < (uint32_t)1 << 23;
}

/* Packed: shares of the tint, and what they step by. */
static inline void color_from(qtri_ramp *out, const qtri_raster *raster, const qtri_gradient *g,
                              int32_t i0_q15, int32_t i1_q15, int32_t i2_q15)
{
    const int32_t one_q20 = (int32_t)1 << 20;
    const int32_t *tint = raster->tint_n6;
    qtri_ramp share;
    qtri_ramp_from_steps(&share, g, (uint32_t)i0_q15 << 7, (i1_q15 + 2) >> (QTRI_RAMP_DOWN - 7),
                         (i2_q15 + 2) >> (QTRI_RAMP_DOWN - 7));
    out->origin = qtri_pack_tint(tint, (int32_t)(share.origin - 0x8000u), one_q20, one_q20);
    out->dx = qtri_pack_tint(tint, (int32_t)share.dx, (int32_t)1 << 14, (int32_t)1 << 15);
    out->dy = qtri_pack_tint(tint, (int32_t)share.dy, (int32_t)1 << 14, (int32_t)1 << 15);
}

static uint32_t pixel_of(const qtri_raster *raster, uint32_t intensity_q15)
{
    qtri_channels color;
    for (int i = 0; i < 3; i++) {
        color.c[i] = qtri_raster_shade(raster, (int32_t)(intensity_q15 << 7), i);
    }
    return qtri_pixel_pack(QTRI_RGB565, &color);
}

/* One pixel everywhere: the loops for any size serve. */
QTRI_NOINLINE static void fill_flat(const qtri_raster *raster, const qtri_triangle *t,
                                    int32_t anchor_x, int32_t anchor_y, qtri_ramp depth,
                                    uint32_t pixel)
{
    qtri_job job;
    job.raster = raster;
    job.anchor_x = anchor_x;
    job.anchor_y = anchor_y;
    job.depth = depth;
    job.pixel = pixel;
    raster->fill_flat(&job, t->spans, t->row, t->end - t->row);
}

bool qtri_small_draw(const qtri_raster *raster, const qtri_triangle *triangle, const qtri_vertex *a,
                     const qtri_vertex *b, const qtri_vertex *c, uint32_t face_q15)
{
    int32_t i0 = (int32_t)face_q15;
    int32_t i1 = 0;
    int32_t i2 = 0;
    qtri_gradient gradient;
    qtri_ramp depth;
    if (face_q15 == QTRI_VERTEX_UNLIT) {
        i0 = a->intensity_q15;
        i1 = b->intensity_q15 - i0;
        i2 = c->intensity_q15 - i0;
    }
    const bool smooth = QTRI_WITH_SMOOTH && (i1 | i2) != 0;
    if (!raster->small ||
        (smooth && (!is_tiny(triangle) || (raster->perspective && !is_linear(a, b, c, i1, i2)))) ||
        !gradient_from(&gradient, triangle) || !depth_from(&depth, &gradient, a, b, c)) {
        return false;
    }
    if (smooth) {
        qtri_ramp color;
        move(&depth, &gradient, triangle->row);
        color_from(&color, raster, &gradient, i0, i1, i2);
        move(&color, &gradient, triangle->row);
        fill(raster, triangle, &depth, &color, 0, true);
        return true;
    }
    const uint32_t pixel = pixel_of(raster, (uint32_t)i0);
    if (is_tiny(triangle)) {
        move(&depth, &gradient, triangle->row);
        fill(raster, triangle, &depth, NULL, pixel, false);
    } else {
        fill_flat(raster, triangle, gradient.anchor_x, gradient.anchor_y, depth, pixel);
    }
    return true;
}
