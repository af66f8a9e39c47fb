#include "span.h"

/* Running values along a row, one for each plane in use. */
typedef struct walk {
    uint64_t depth, inv_w;
    uint64_t attribute[QTRI_ATTRIBUTES];
    int first, last; /* attributes in use: colours 0..2 when smooth, u and v when textured */
} walk;

static void walk_start(walk *w, const qtri_span_job *job, int32_t x, int32_t y)
{
    w->depth = qtri_plane_at(&job->depth, x, y);
    w->inv_w = job->paint == QTRI_PAINT_PERSPECTIVE ? qtri_plane_at(&job->inv_w, x, y) : 0;
    w->first = job->smooth ? 0 : 3;
    w->last = job->texture != NULL ? QTRI_ATTRIBUTES : 3;
    for (int i = w->first; i < w->last; i++) {
        w->attribute[i] = qtri_plane_at(&job->attribute[i], x, y);
    }
}

static void walk_next(walk *w, const qtri_span_job *job)
{
    w->depth += job->depth.dx;
    w->inv_w += job->inv_w.dx;
    for (int i = w->first; i < w->last; i++) {
        w->attribute[i] += job->attribute[i].dx;
    }
}

static int32_t hold(int64_t x, int32_t least, int32_t greatest)
{
    return x < least ? least : (x > greatest ? greatest : (int32_t)x);
}

/*
 * (a/w) / (1/w): 1/w is q 2^-31 with q in 1..2^31, normalised to 32 bits for the reciprocal;
 * s 2^31 / q = s r 2^(zeros - 31), |s| < 2^31, r <= 2^31.
 */
typedef struct divider {
    uint32_t reciprocal;
    int32_t shift;
} divider;

static divider divider_for(uint64_t inv_w)
{
    int64_t q = qtri_plane_floor(inv_w);
    uint32_t size = q < 1 ? 1u : (q > (int64_t)1 << 31 ? 1u << 31 : (uint32_t)q);
    int32_t zeros = qtri_clz32(size);
    divider d = {qtri_reciprocal_q62(size << zeros), 31 - zeros};
    return d;
}

static int64_t divide(const divider *d, uint64_t attribute)
{
    int64_t s = qtri_plane_floor(attribute);
    s = hold(s, 0, INT32_MAX); /* a rounding below 0 at most */
    return (s * d->reciprocal) >> d->shift;
}

/* The pixel value at the walk's position. Flat triangles do not come here. */
static uint32_t shade(const qtri_span_job *job, const walk *w)
{
    qtri_channels color = job->color;
    int64_t uv[2] = {0, 0};
    if (job->paint == QTRI_PAINT_PERSPECTIVE) {
        divider d = divider_for(w->inv_w);
        for (int i = w->first; i < 3; i++) {
            int64_t c = divide(&d, w->attribute[i]) >> QTRI_COLOR_PERSPECTIVE_SHIFT;
            color.c[i] = hold(c, job->least[i], job->greatest[i]);
        }
        for (int i = 3; i < w->last; i++) {
            uv[i - 3] = divide(&d, w->attribute[i]);
        }
    } else {
        for (int i = w->first; i < 3; i++) {
            color.c[i] = hold(qtri_plane_floor(w->attribute[i]), job->least[i], job->greatest[i]);
        }
        for (int i = 3; i < w->last; i++) {
            uv[i - 3] = qtri_plane_floor(w->attribute[i]);
        }
    }
    if (job->texture != NULL) {
        uint32_t column = qtri_texel_index(&job->axis[0], uv[0]);
        uint32_t row = qtri_texel_index(&job->axis[1], uv[1]);
        color = qtri_texel_modulate(&color, qtri_texel_fetch(job->texture, column, row));
    }
    return qtri_pixel_pack(job->surface->format, &color);
}

/* Depth in 16.16 units of 2^-16, rounded to an integer; the plane never leaves 0..65535.0 by half.
 */
static uint16_t depth_round(uint64_t depth)
{
    return (uint16_t)((depth + ((uint64_t)1 << 31)) >> 32);
}

void qtri_span(const qtri_span_job *job, int32_t y, int32_t x0, int32_t x1)
{
    const qtri_surface *surface = job->surface;
    ptrdiff_t stored_row = y - surface->first_row;
    uint8_t *row = surface->pixels + stored_row * surface->pitch;
    uint16_t *depth_row =
        job->compare == QTRI_DEPTH_OFF ? NULL : surface->depth + stored_row * surface->depth_pitch;

    walk w;
    walk_start(&w, job, x0, y);
    for (int32_t x = x0; x < x1; x++, walk_next(&w, job)) {
        if (depth_row != NULL) {
            uint16_t z = depth_round(w.depth);
            if (!qtri_depth_passes(job->compare, z, depth_row[x])) {
                continue;
            }
            if (job->depth_write) {
                depth_row[x] = z;
            }
        }
        uint32_t pixel = job->paint == QTRI_PAINT_FLAT ? job->pixel : shade(job, &w);
        qtri_pixel_store(surface->format, row, x, pixel);
    }
}
