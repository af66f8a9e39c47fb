#include "setup.h"

#include "packed.h"
#include "texel_copy.h"

/*
 * Colours may stray by 1/4 of a step for being linear on the screen: with the rounding to a pixel
 * and the short fractions of packed.h less than one step in all.
 */
#define LINEAR_LOG2 14

/* 1/w of the three with one exponent, the largest in 2^30..2^31. False when all are equal. */
static bool inv_w_align(uint32_t q[3], const qtri_attributes v[3])
{
    int32_t e0 = v[0].inv_w_exponent;
    int32_t e1 = v[1].inv_w_exponent;
    int32_t e2 = v[2].inv_w_exponent;
    int32_t greatest = e0 > e1 ? e0 : e1;
    greatest = greatest > e2 ? greatest : e2;
    for (int i = 0; i < 3; i++) {
        uint32_t down = (uint32_t)greatest - (uint32_t)v[i].inv_w_exponent; /* < 2^32 */
        q[i] = down > 29 ? 1 : v[i].inv_w_q31 >> down;
    }
    return q[0] != q[1] || q[0] != q[2];
}

/* Greatest less least. */
static uint32_t range_of(const uint32_t f[3], uint32_t *least)
{
    uint32_t greatest = f[0] > f[1] ? f[0] : f[1];
    *least = f[0] < f[1] ? f[0] : f[1];
    *least = *least < f[2] ? *least : f[2];
    return (greatest > f[2] ? greatest : f[2]) - *least;
}

/*
 * Whether linear interpolation of an attribute that spans `range` strays by less than
 * 2^tolerance_log2 anywhere in the triangle, q being 1/w at the vertices. With weights b_i, sum 1,
 * and Q = sum b_i q_i the true value has weights b_i q_i / Q: off by at most
 * (range / 2) sum b_i |q_i - Q| / Q, and a mean distance from the mean is at most half the range:
 * range (q_greatest - q_least) / (4 q_least).
 */
static bool nearly_linear(uint32_t range, const uint32_t q[3], int tolerance_log2)
{
    uint32_t q_least; /* <= 2^31 */
    uint32_t q_range = range_of(q, &q_least);
    return qtri_mul_u32(range, q_range) >> (tolerance_log2 + 2) < q_least;
}

/*
 * The same for colours, at a glance: true only where nearly_linear is. With one exponent, 16 bits
 * of q and a range of up to 2^24, rounded up in steps of 2^14.
 */
static bool plainly_linear(uint32_t range, const qtri_attributes v[3])
{
    if (v[0].inv_w_exponent != v[1].inv_w_exponent || v[0].inv_w_exponent != v[2].inv_w_exponent) {
        return false;
    }
    const uint32_t q[3] = {v[0].inv_w_q31 >> 16, v[1].inv_w_q31 >> 16, v[2].inv_w_q31 >> 16};
    uint32_t q_least; /* 2^14..2^15 */
    uint32_t q_range = range_of(q, &q_least) + 1;
    return ((range >> 14) + 1) * q_range < q_least << (LINEAR_LOG2 + 2 - 14); /* <= 2^25 */
}

/* Both, first the one at a glance. */
static bool colors_are_linear(uint32_t range, const qtri_attributes v[3], uint32_t q[3])
{
    return (QTRI_WITH_FAST_PATHS && plainly_linear(range, v)) || !inv_w_align(q, v) ||
           nearly_linear(range, q, LINEAR_LOG2);
}

static void ramp_init(qtri_ramp *ramp, const qtri_gradient *g, const uint32_t f[3])
{
    if (g->inverse != 0 && qtri_ramp_fits(f[0], f[1]) && qtri_ramp_fits(f[0], f[2])) {
        qtri_ramp_multiply(ramp, g, f);
    } else {
        qtri_ramp_divide(ramp, g, f);
    }
}

/* Colour i of the three vertices, as they have it: a channel, or 0, their share of a tint. */
static void colors_of(uint32_t f[3], const qtri_attributes v[3], int i)
{
    for (int k = 0; k < 3; k++) {
        f[k] = (uint32_t)v[k].color[i];
    }
}

static void channel_of(uint32_t f[3], const qtri_job *job, const qtri_attributes v[3], int i)
{
    colors_of(f, v, job->tinted ? 0 : i);
    for (int k = 0; job->tinted && k < 3; k++) {
        f[k] = (uint32_t)qtri_raster_shade(job->raster, (int32_t)f[k], i);
    }
}

static uint32_t channel_range(const qtri_attributes v[3], int i)
{
    uint32_t f[3];
    uint32_t least;
    colors_of(f, v, i);
    return range_of(f, &least);
}

bool qtri_tint_is_linear(const qtri_vertex *a, const qtri_vertex *b, const qtri_vertex *c)
{
    qtri_attributes v[3];
    uint32_t q[3];
    qtri_vertex_attributes(&v[0], a, a->intensity_q15);
    qtri_vertex_attributes(&v[1], b, b->intensity_q15);
    qtri_vertex_attributes(&v[2], c, c->intensity_q15);
    return colors_are_linear(channel_range(v, 0), v, q);
}

/*
 * The widest of the colour channels, n.16, or their sum where a pixel is. A tint's channels are at
 * most 2^22 in RGB565, else 2^24, and so is their sum in GRAY8.
 */
static uint32_t color_range(const qtri_job *job, const qtri_attributes v[3])
{
    const qtri_raster *raster = job->raster;
    uint32_t range = channel_range(v, 0);
    if (job->tinted) {
        return qtri_kind_of(raster->surface) == QTRI_KIND_RGB565 ? range : range << 2;
    }
    for (int i = 1; i < 3; i++) {
        uint32_t other = channel_range(v, i);
        if (qtri_kind_of(raster->surface) == QTRI_KIND_GRAY8) {
            range += other;
        } else {
            range = other > range ? other : range;
        }
    }
    return range;
}

/*
 * Planes of attribute q / 2^31, rounded: below 2^30, as are the attributes, colours scaled. value:
 * the vertices' texture coordinates.
 */
static void perspective_planes(qtri_job *job, const qtri_attributes v[3], uint32_t value[2][3],
                               const uint32_t q[3], const qtri_gradient *gradient)
{
    qtri_plane_init(&job->attribute[qtri_job_end(job)].plane, gradient, q);
    for (int i = qtri_job_first(job); i < qtri_job_end(job); i++) {
        uint32_t color[3];
        uint32_t *f = i < QTRI_U ? color : value[i - QTRI_U];
        if (i < QTRI_U) {
            channel_of(color, job, v, i);
            uint32_t least;
            uint32_t range = range_of(color, &least);
            job->color.range.least[i] = (int32_t)least;
            job->color.range.greatest[i] = (int32_t)(least + range);
        }
        for (int k = 0; k < 3; k++) {
            uint32_t scaled = i < QTRI_U ? f[k] << QTRI_COLOR_PERSPECTIVE_SHIFT : f[k];
            f[k] = (uint32_t)((qtri_mul_u32(scaled, q[k]) + ((uint32_t)1 << 30)) >> 31);
        }
        qtri_plane_init(&job->attribute[i].plane, gradient, f);
    }
}

/*
 * The ramp of a tint's share, packed at once for a tiny triangle in RGB565: in 32 bits. Else it
 * serves all channels, as it is not so steep that it wraps.
 */
static void tint_ramps(qtri_job *job, const qtri_attributes v[3], const qtri_gradient *gradient)
{
    const int32_t one_q20 = (int32_t)1 << 20;
    const qtri_raster *raster = job->raster;
    uint32_t share[3];
    qtri_ramp ramp;
    colors_of(share, v, 0);
    qtri_ramp_multiply(&ramp, gradient, share);
    const int32_t origin = (int32_t)(ramp.origin - 0x8000u);
    const int32_t dx = (int32_t)ramp.dx;
    const int32_t dy = (int32_t)ramp.dy;
    if (job->packed && job->tiny) {
        const int32_t *tint = raster->tint_n6;
        job->color.word.origin = qtri_pack_tint(tint, origin, one_q20, one_q20);
        job->color.word.step.even = qtri_pack_tint(tint, dx, (int32_t)1 << 14, (int32_t)1 << 15);
        job->color.word.dy = qtri_pack_tint(tint, dy, (int32_t)1 << 14, (int32_t)1 << 15);
        return;
    }
    for (int i = qtri_job_first(job); i < QTRI_U; i++) {
        qtri_ramp *c = &job->attribute[i].ramp;
        c->origin = (uint32_t)qtri_raster_shade(raster, origin, i) + 0x8000u;
        c->dx = (uint32_t)qtri_raster_shade(raster, dx, i);
        c->dy = (uint32_t)qtri_raster_shade(raster, dy, i);
    }
}

static uint32_t pack_step(const qtri_job *job, uint32_t times)
{
    const qtri_attribute *c = job->attribute;
    return qtri_pack_round(times * c[0].ramp.dx, times * c[1].ramp.dx, times * c[2].ramp.dx);
}

static void linear_colors(qtri_job *job, const qtri_attributes v[3], const qtri_gradient *gradient)
{
    const qtri_attribute *c = job->attribute;
    qtri_packed_steps *step = &job->color.word.step;
    job->packed = qtri_kind_of(job->raster->surface) == QTRI_KIND_RGB565 && job->end == QTRI_U;
    if (job->tinted && gradient->inverse != 0) {
        tint_ramps(job, v, gradient);
    } else {
        for (int i = qtri_job_first(job); i < QTRI_U; i++) {
            uint32_t f[3];
            channel_of(f, job, v, i);
            ramp_init(&job->attribute[i].ramp, gradient, f);
        }
    }
    if (!job->packed) {
        return;
    }
    if (!job->tiny) {
        step->even = pack_step(job, 1);
        step->odd = pack_step(job, 2) - step->even;
        step->eight = pack_step(job, 8);
        step->last = step->eight - 4 * step->even - 3 * step->odd;
        return;
    }
    if (!job->tinted) {
        step->even = pack_step(job, 1);
        job->color.word.origin =
            qtri_pack_floor(c[0].ramp.origin, c[1].ramp.origin, c[2].ramp.origin);
        job->color.word.dy = qtri_pack_round(c[0].ramp.dy, c[1].ramp.dy, c[2].ramp.dy);
    }
    step->odd = step->last = step->even;
    step->eight = 8 * step->even;
}

/*
 * Whether attributes must be divided. q: 1/w with one exponent. Texture coordinates may stray by
 * 1/1024 of a texel for being linear. value: those of the vertices; range: of the colours.
 */
static bool needs_perspective(const qtri_job *job, const qtri_attributes v[3],
                              const uint32_t value[2][3], uint32_t range, uint32_t q[3])
{
    if (!(QTRI_WITH_PERSPECTIVE && job->raster->perspective)) {
        return false;
    }
    if (job->end == QTRI_U) {
        return !colors_are_linear(range, v, q);
    }
    if (!inv_w_align(q, v)) {
        return false;
    }
    if (!nearly_linear(range, q, LINEAR_LOG2)) {
        return true;
    }
    for (int i = QTRI_U; i < qtri_job_end(job); i++) {
        const int32_t tolerance = job->axis[i - QTRI_U].shift - 10;
        uint32_t least;
        if (tolerance < 0 || !nearly_linear(range_of(value[i - QTRI_U], &least), q, tolerance)) {
            return true;
        }
    }
    return false;
}

/*
 * The anchor of a small triangle is in its middle, that of others at vertex 0, or as near to it as
 * the frame has a pixel. Neither depends on bands or scissor. True for a tiny triangle: covered
 * pixel centres lie within its bounds, the anchor's within half a pixel of their middle.
 */
static bool gradient_from(qtri_gradient *g, const qtri_triangle *t, const qtri_surface *surface)
{
    qtri_gradient_place(g, t);
    qtri_gradient_init(g, t->extent);
    if (g->inverse == 0) { /* <= 2^13 pixels */
        qtri_gradient_set_anchor(g, qtri_hold32(g->x_24p8, 0, surface->width * 256 - 1) >> 8,
                                 qtri_hold32(g->y_24p8, 0, surface->height * 256 - 1) >> 8);
        return false;
    }
    qtri_gradient_set_middle(g, t);
    return t->size == QTRI_TINY;
}

static bool is_white(const qtri_job *job)
{
    const int32_t *c = job->color.constant.c;
    return ((c[0] ^ (int32_t)31 << 16) | (c[1] ^ (int32_t)63 << 16) | (c[2] ^ (int32_t)31 << 16)) ==
           0;
}

static void constant_color(qtri_job *job, const qtri_attributes v[3])
{
    static const int32_t white_8p16[3] = {(int32_t)255 << 16, (int32_t)255 << 16,
                                          (int32_t)255 << 16};
    const qtri_raster *raster = job->raster;
    if (raster->replace) {
        job->color.constant = qtri_channels_from_color(qtri_colors_of(raster->surface), white_8p16);
        return;
    }
    const qtri_attributes *from = &v[qtri_raster_provoking(raster)];
    for (int i = 0; i < 3; i++) {
        job->color.constant.c[i] =
            job->tinted ? qtri_raster_shade(raster, from->color[0], i) : from->color[i];
    }
}

/*
 * The axes and the vertices' coordinates on them; whether texels become pixels as they are, which
 * decides on the unit of runs: see texel_copy.h.
 */
QTRI_NOINLINE static void texture_axes(qtri_job *job, uint32_t value[2][3],
                                       const qtri_attributes v[3])
{
    const qtri_raster *raster = job->raster;
    const qtri_texture *texture = raster->texture;
    job->copies_texels = raster->copies_white && !qtri_job_is_smooth(job) && is_white(job);
    for (int i = 0; i < 2; i++) {
        qtri_texel_axis *axis = &job->axis[i];
        int64_t f_q32[3];
        for (int k = 0; k < 3; k++) {
            f_q32[k] = i == 0 ? v[k].u_q32 : v[k].v_q32;
        }
        qtri_texel_axis_init(axis, value[i], f_q32,
                             i == 0 ? texture->width_log2 : texture->height_log2);
        axis->up = qtri_job_copies_texels(job)
                       ? (int8_t)(qtri_texel_copy_shift(texture, i) - axis->shift)
                       : 0;
    }
    if (qtri_job_copies_texels(job)) {
        job->draw_run = raster->copy_run;
    }
}

qtri_fill_rows qtri_job_init(qtri_job *job, const qtri_raster *raster,
                             const qtri_triangle *triangle, const qtri_attributes v[3])
{
    qtri_gradient gradient;
    job->raster = raster;
    job->tinted = triangle->tinted;
    job->draw_run = qtri_run_generic;
    job->copies_texels = false;
    job->packed = false;
    job->end = qtri_raster_texture(raster) != NULL ? QTRI_ATTRIBUTES : QTRI_U;
    job->cut = triangle->cut;
    job->tiny = gradient_from(&gradient, triangle, raster->surface);
    job->anchor_x = gradient.anchor_x;
    job->anchor_y = gradient.anchor_y;
    if (raster->compare != QTRI_DEPTH_OFF) {
        const uint32_t depth[3] = {v[0].depth_16p16, v[1].depth_16p16, v[2].depth_16p16};
        ramp_init(&job->depth, &gradient, depth);
    }
    uint32_t range = 0; /* of colours to interpolate */
    if (QTRI_WITH_SMOOTH && raster->shading == QTRI_SMOOTH && !raster->replace) {
        range = color_range(job, v);
    }
    job->first = range != 0 ? 0 : QTRI_U;
    if (!qtri_job_is_smooth(job)) {
        constant_color(job, v);
        if (qtri_raster_texture(raster) == NULL) {
            job->paint = QTRI_PAINT_FLAT;
            job->pixel = qtri_pixel_pack(qtri_kind_of(raster->surface), &job->color.constant);
            return raster->fill_flat;
        }
    }
    uint32_t q[3];
    uint32_t value[2][3];
    if (qtri_raster_texture(raster) != NULL) {
        texture_axes(job, value, v);
    }
    if (needs_perspective(job, v, (const uint32_t(*)[3])value, range, q)) {
        job->paint = QTRI_PAINT_PERSPECTIVE;
        perspective_planes(job, v, value, q, &gradient);
        return qtri_fill_perspective;
    }
    job->paint = QTRI_PAINT_LINEAR;
    if (qtri_job_is_smooth(job)) {
        linear_colors(job, v, &gradient);
    }
    if (qtri_raster_texture(raster) == NULL) {
        return job->tiny ? raster->fill_tiny : raster->fill_linear;
    }
    for (int i = QTRI_U; i < qtri_job_end(job); i++) {
        qtri_plane_init(&job->attribute[i].plane, &gradient, value[i - QTRI_U]);
    }
    return qtri_fill_spans;
}
