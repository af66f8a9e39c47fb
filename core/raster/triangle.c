#include "qtri/raster.h"

#include "dda.h"
#include "span.h"

static int32_t hold(int32_t x)
{
    return x < -QTRI_SCREEN_MAX_24P8 ? -QTRI_SCREEN_MAX_24P8
                                     : (x > QTRI_SCREEN_MAX_24P8 ? QTRI_SCREEN_MAX_24P8 : x);
}

/* Position on the screen, held to the guard band. */
typedef struct corner {
    int32_t x, y;
} corner;

static void base_init(qtri_plane_base *base, const corner p[3])
{
    base->x_24p8 = p[0].x;
    base->y_24p8 = p[0].y;
    base->dx1 = p[1].x - p[0].x;
    base->dy1 = p[1].y - p[0].y;
    base->dx2 = p[2].x - p[0].x;
    base->dy2 = p[2].y - p[0].y;
    base->area = (int64_t)base->dx1 * base->dy2 - (int64_t)base->dx2 * base->dy1;
}

/* y points down: counter-clockwise to the eye is a negative area. */
static bool culled(qtri_cull cull, int64_t area)
{
    return area == 0 || (cull == QTRI_CULL_BACK && area > 0) ||
           (cull == QTRI_CULL_FRONT && area < 0);
}

static int64_t depth_of(const qtri_screen_vertex *v)
{
    const uint32_t farthest = (uint32_t)65535 << 16;
    return v->depth_16p16 < farthest ? v->depth_16p16 : farthest;
}

/* 1/w of the three with one exponent, the largest becoming 2^30..2^31. False when all are equal. */
static bool inv_w_align(int64_t q[3], const qtri_screen_vertex v[3])
{
    int32_t greatest = INT32_MIN;
    for (int i = 0; i < 3; i++) {
        int32_t zeros = qtri_clz32(v[i].inv_w_q31 | 1);
        int64_t exponent = (int64_t)v[i].inv_w_exponent - zeros;
        greatest = exponent > greatest ? qtri_saturate32(exponent) : greatest;
    }
    for (int i = 0; i < 3; i++) {
        uint32_t mantissa = v[i].inv_w_q31 | (v[i].inv_w_q31 == 0);
        int32_t zeros = qtri_clz32(mantissa);
        int64_t down = greatest - ((int64_t)v[i].inv_w_exponent - zeros) + 1;
        q[i] = down > 32 ? 0 : (int64_t)(((uint64_t)mantissa << zeros) >> down);
        q[i] = q[i] < 1 ? 1 : q[i];
    }
    return q[0] != q[1] || q[0] != q[2];
}

/* attribute q / 2^31, for attributes below 2^30: below 2^30, rounded. */
static void plane_over_w(qtri_plane *plane, const qtri_plane_base *base, const int64_t f[3],
                         const int64_t q[3])
{
    int64_t over_w[3];
    for (int i = 0; i < 3; i++) {
        over_w[i] = (f[i] * q[i] + ((int64_t)1 << 30)) >> 31;
    }
    qtri_plane_init(plane, base, over_w);
}

static void job_ramp(const qtri_span_job *job, qtri_ramp *ramp, const qtri_plane_base *base,
                     const int64_t f[3])
{
    qtri_plane plane;
    qtri_plane_init(&plane, base, f);
    qtri_ramp_init(ramp, &plane, job->anchor_x, job->anchor_y);
}

/* Colours: constant, or one plane a channel. Sets least and greatest. */
static void job_colors(qtri_span_job *job, const qtri_material *material,
                       const qtri_screen_vertex v[3], const qtri_plane_base *base, const int64_t *q)
{
    static const int32_t white_8p16[3] = {(int32_t)255 << 16, (int32_t)255 << 16,
                                          (int32_t)255 << 16};
    const qtri_format format = job->surface->format;
    qtri_channels color[3];
    bool replace = job->texture != NULL && material->texture_mode == QTRI_REPLACE;
    for (int i = 0; i < 3; i++) {
        const qtri_screen_vertex *source = material->shading == QTRI_SMOOTH       ? &v[i]
                                           : material->shading == QTRI_FLAT_FIRST ? &v[0]
                                                                                  : &v[2];
        color[i] = qtri_channels_from_color(format, replace ? white_8p16 : source->color_8p16);
    }
    job->color = color[0];
    job->smooth = false;
    for (int channel = 0; channel < 3; channel++) {
        int32_t a = color[0].c[channel];
        int32_t b = color[1].c[channel];
        int32_t c = color[2].c[channel];
        job->least[channel] = a < b ? (a < c ? a : c) : (b < c ? b : c);
        job->greatest[channel] = a > b ? (a > c ? a : c) : (b > c ? b : c);
        job->smooth = job->smooth || job->least[channel] != job->greatest[channel];
    }
    for (int channel = 0; channel < 3 && job->smooth; channel++) {
        int64_t f[3];
        for (int i = 0; i < 3; i++) {
            f[i] = color[i].c[channel];
            if (q != NULL) {
                f[i] *= (int64_t)1 << QTRI_COLOR_PERSPECTIVE_SHIFT;
            }
        }
        if (q != NULL) {
            plane_over_w(&job->attribute[channel], base, f, q);
        } else {
            job_ramp(job, &job->ramp[channel], base, f);
        }
    }
}

static void job_texture(qtri_span_job *job, const qtri_screen_vertex v[3],
                        const qtri_plane_base *base, const int64_t *q)
{
    int64_t u_q32[3] = {v[0].u_q32, v[1].u_q32, v[2].u_q32};
    int64_t v_q32[3] = {v[0].v_q32, v[1].v_q32, v[2].v_q32};
    qtri_texel_axis_init(&job->axis[0], u_q32, job->texture->width_log2);
    qtri_texel_axis_init(&job->axis[1], v_q32, job->texture->height_log2);
    for (int i = 0; i < 2; i++) {
        if (q != NULL) {
            plane_over_w(&job->attribute[3 + i], base, job->axis[i].value, q);
        } else {
            qtri_plane_init(&job->attribute[3 + i], base, job->axis[i].value);
        }
    }
}

/* The pixel at x (or y) of the frame, which has `size` of them, or the nearest one. */
static int32_t frame_pixel(int32_t x_24p8, int32_t size)
{
    int32_t pixel = x_24p8 >> 8;
    return pixel < 0 ? 0 : (pixel < size ? pixel : size - 1);
}

/* Everything that does not change from row to row. */
static void job_init(qtri_span_job *job, const qtri_surface *surface, const qtri_material *material,
                     const qtri_screen_vertex v[3], const qtri_plane_base *base)
{
    static const qtri_plane no_plane = {0, 0, 0};
    static const qtri_ramp no_ramp = {0, 0, 0};
    job->surface = surface;
    job->texture = qtri_texture_usable(material->texture) ? material->texture : NULL;
    job->compare = surface->depth == NULL ? QTRI_DEPTH_OFF : material->depth_compare;
    job->depth_write = !material->depth_read_only;
    job->anchor_x = frame_pixel(base->x_24p8, surface->width);
    job->anchor_y = frame_pixel(base->y_24p8, surface->height);
    job->depth = no_ramp;
    job->ramp[0] = job->ramp[1] = job->ramp[2] = no_ramp;
    job->inv_w = no_plane;
    if (job->compare != QTRI_DEPTH_OFF) {
        int64_t depth[3] = {depth_of(&v[0]), depth_of(&v[1]), depth_of(&v[2])};
        job_ramp(job, &job->depth, base, depth);
    }
    int64_t q[3];
    bool perspective = material->interpolation == QTRI_PERSPECTIVE && inv_w_align(q, v) &&
                       (job->texture != NULL || material->shading == QTRI_SMOOTH);
    job_colors(job, material, v, base, perspective ? q : NULL);
    if (job->texture != NULL) {
        job_texture(job, v, base, perspective ? q : NULL);
    }
    if (job->texture == NULL && !job->smooth) {
        job->paint = QTRI_PAINT_FLAT;
        job->pixel = qtri_pixel_pack(surface->format, &job->color);
    } else if (perspective) {
        job->paint = QTRI_PAINT_PERSPECTIVE;
        qtri_plane_init(&job->inv_w, base, q);
    } else {
        job->paint = QTRI_PAINT_LINEAR;
    }
    job->loop = qtri_run_choose(job);
}

/* First row whose centre is at or below y: ceil((y - 128) / 256). The end is excluded likewise. */
static int32_t first_row(int32_t y)
{
    return (y + 127) >> 8;
}

/*
 * x where the edge from a down to b crosses the centre of `row`, as the first pixel whose centre is
 * at or right of it: ceil((X - 128) / 256) = floor((X + 127.99..) / 256). Taken as the first pixel
 * of a left edge and the end of a right one, a centre exactly on an edge is inside on the left
 * only.
 */
static void edge_init(qtri_dda *edge, corner a, corner b, int32_t row)
{
    int32_t length = b.y - a.y;
    int32_t along = row * 256 + 128 - a.y;
    qtri_dda_init(edge, a.x, b.x - a.x, length, along, 128 * length - 1);
}

static int32_t least(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

static int32_t greatest(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

/* Rows row..end-1 between the long edge and a short one. */
static void fill_rows(const qtri_span_job *job, const qtri_rect *bounds, qtri_dda *long_edge,
                      qtri_dda *short_edge, bool long_is_left, int32_t row, int32_t end)
{
    qtri_dda *left = long_is_left ? long_edge : short_edge;
    qtri_dda *right = long_is_left ? short_edge : long_edge;
    for (; row < end; row++) {
        int32_t x0 = greatest(left->value, bounds->x0);
        int32_t x1 = least(right->value, bounds->x1);
        if (x0 < x1) {
            qtri_span(job, row, left->value, right->value, x0, x1);
        }
        qtri_dda_next(left);
        qtri_dda_next(right);
    }
}

static void order_by_y(corner *upper, corner *lower)
{
    if (lower->y < upper->y) {
        corner swap = *upper;
        *upper = *lower;
        *lower = swap;
    }
}

/* top, middle and bottom by y: the long edge on one side, two short ones on the other. */
static void fill(const qtri_span_job *job, const qtri_rect *bounds, const corner p[3])
{
    corner top = p[0];
    corner middle = p[1];
    corner bottom = p[2];
    order_by_y(&top, &middle);
    order_by_y(&middle, &bottom);
    order_by_y(&top, &middle);
    int32_t row = greatest(first_row(top.y), bounds->y0);
    int32_t end = least(first_row(bottom.y), bounds->y1);
    int32_t turn = least(first_row(middle.y), end);
    if (row >= end) {
        return;
    }
    int64_t side = (int64_t)(middle.x - top.x) * (bottom.y - top.y) -
                   (int64_t)(bottom.x - top.x) * (middle.y - top.y);
    bool long_is_left = side > 0;
    qtri_dda long_edge;
    qtri_dda short_edge;
    edge_init(&long_edge, top, bottom, row);
    if (row < turn) {
        edge_init(&short_edge, top, middle, row);
        fill_rows(job, bounds, &long_edge, &short_edge, long_is_left, row, turn);
        row = turn;
    }
    if (row < end) {
        edge_init(&short_edge, middle, bottom, row);
        fill_rows(job, bounds, &long_edge, &short_edge, long_is_left, row, end);
    }
}

void qtri_raster_triangle(const qtri_surface *surface, const qtri_material *material,
                          const qtri_screen_vertex v[3])
{
    corner p[3];
    for (int i = 0; i < 3; i++) {
        p[i].x = hold(v[i].x_24p8);
        p[i].y = hold(v[i].y_24p8);
    }
    qtri_plane_base base;
    base_init(&base, p);
    if (culled(material->cull, base.area)) {
        return;
    }
    qtri_rect bounds = qtri_surface_bounds(surface);
    int32_t x_least = least(p[0].x, least(p[1].x, p[2].x));
    int32_t x_greatest = greatest(p[0].x, greatest(p[1].x, p[2].x));
    int32_t y_least = least(p[0].y, least(p[1].y, p[2].y));
    int32_t y_greatest = greatest(p[0].y, greatest(p[1].y, p[2].y));
    if (greatest(first_row(x_least), bounds.x0) >= least(first_row(x_greatest), bounds.x1) ||
        greatest(first_row(y_least), bounds.y0) >= least(first_row(y_greatest), bounds.y1)) {
        return; /* touches no pixel centre */
    }
    qtri_span_job job;
    job_init(&job, surface, material, v, &base);
    fill(&job, &bounds, p);
}
