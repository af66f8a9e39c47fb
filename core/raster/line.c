#include "line.h"

#include "dda.h"
#include "line_path.h"
#include "pixel.h"
#include "job.h"

typedef struct ramp {
    int32_t value;
    uint32_t step; /* modulo 2^32: signed, and a single pixel's may exceed 32 bits */
} ramp;

/* From pixel k to the end of its chunk. */
static void ramp_init(ramp *r, int32_t from, int32_t to, const qtri_line_path *l,
                      const qtri_divider *by, int32_t k)
{
    int32_t past = k % QTRI_LINE_CHUNK;
    int32_t start = l->along + 256 * (k - past); /* < length */
    int32_t quotient = qtri_divide(to - from, by);
    int32_t remainder = to - from - quotient * l->length; /* < 2^23 */
    int64_t product = qtri_mul_s32(remainder, start);     /* < 2^46 */
    int32_t rest;
    if (product == (int32_t)product) {
        rest = qtri_divide((int32_t)product, by);
    } else {
        uint32_t unused;
        rest = (int32_t)qtri_divide_long(qtri_magnitude64(product), (uint32_t)l->length, &unused);
        rest = product < 0 ? -rest : rest;
    }
    r->step = (uint32_t)quotient * 256u + (uint32_t)qtri_divide(remainder * 256, by);
    r->value = (int32_t)((uint32_t)(from + quotient * start + rest) + (uint32_t)past * r->step);
}

static inline void ramp_next(ramp *r)
{
    r->value = (int32_t)((uint32_t)r->value + r->step);
}

enum { CHANNELS = 3, DEPTH = CHANNELS, VALUES };

static void ramps_init(ramp r[VALUES], const qtri_line_path *l, const qtri_divider *by, int32_t k)
{
    for (int i = 0; i < CHANNELS; i++) {
        ramp_init(&r[i], l->first->color[i], l->last->color[i], l, by, k);
    }
    ramp_init(&r[DEPTH], l->first->depth_16p15, l->last->depth_16p15, l, by, k);
}

static inline uint32_t pixel_of(qtri_format format, int32_t c0, int32_t c1, int32_t c2)
{
    uint32_t red = (uint32_t)c0 >> 16;
    uint32_t green = (uint32_t)c1 >> 16;
    uint32_t blue = (uint32_t)c2 >> 16;
    switch (format) {
    case QTRI_RGB565:
        return red << 11 | green << 5 | blue;
    case QTRI_XRGB8888:
        return red << 16 | green << 8 | blue;
    default:
        return red; /* gray */
    }
}

static void plot(const qtri_line_job *job, int32_t x, int32_t y, const ramp r[VALUES])
{
    const qtri_surface *surface = job->surface;
    ptrdiff_t stored_row = y - surface->first_row;
    if (job->compare != QTRI_DEPTH_OFF) {
        uint16_t *stored = surface->depth + stored_row * surface->depth_pitch + x;
        uint32_t z = ((uint32_t)r[DEPTH].value + ((uint32_t)1 << 14)) >> 15;
        if (!qtri_depth_passes(job->compare, z, *stored)) {
            return;
        }
        if (job->depth_write) {
            *stored = (uint16_t)z;
        }
    }
    qtri_pixel_store(surface->format, surface->pixels + stored_row * surface->pitch, x,
                     pixel_of(surface->format, r[0].value, r[1].value, r[2].value));
}

void qtri_line_draw_any(const qtri_line_job *job, const qtri_line_end *a, const qtri_line_end *b)
{
    qtri_line_path own;
    qtri_line_path_init(&own, a, b);
    const qtri_line_path *l = &own;
    const qtri_rect *bounds = &job->bounds;
    int32_t low = l->steep ? bounds->y0 : bounds->x0;
    int32_t high = l->steep ? bounds->y1 : bounds->x1;
    int32_t minor_low = l->steep ? bounds->x0 : bounds->y0;
    int32_t minor_high = l->steep ? bounds->x1 : bounds->y1;
    int32_t minor_last = l->minor + l->delta;
    int32_t k = low > l->position ? low - l->position : 0;
    int32_t end = l->count < high - l->position ? l->count : high - l->position;
    if (k >= end || (l->minor >> 8 < minor_low && minor_last >> 8 < minor_low) ||
        (l->minor >> 8 >= minor_high && minor_last >> 8 >= minor_high)) {
        return;
    }
    qtri_dda minor;
    qtri_divider by;
    ramp r[VALUES];
    qtri_divider_init(&by, (uint32_t)l->length);
    qtri_dda_init(&minor, l->minor, l->delta, l->length, l->along + 256 * k, 0);
    ramps_init(r, l, &by, k);
    for (;;) {
        if (minor.value >= minor_low && minor.value < minor_high) {
            int32_t position = l->position + k;
            plot(job, l->steep ? minor.value : position, l->steep ? position : minor.value, r);
        }
        if (++k >= end) {
            return;
        }
        qtri_dda_next(&minor);
        for (int i = 0; i < VALUES; i++) {
            ramp_next(&r[i]);
        }
        if (k % QTRI_LINE_CHUNK == 0) {
            ramps_init(r, l, &by, k);
        }
    }
}

void qtri_line_job_init(qtri_line_job *job, const qtri_surface *surface,
                        const qtri_material *material)
{
    static const qtri_rect nothing = {0, 0, 0, 0};
    job->surface = surface;
    job->bounds = qtri_surface_bounds(surface);
    if (job->bounds.x0 >= job->bounds.x1 || job->bounds.y0 >= job->bounds.y1) {
        job->bounds = nothing;
    }
    job->compare = surface->depth == NULL ? QTRI_DEPTH_OFF : material->depth_compare;
    job->depth_write = !material->depth_read_only;
    bool fast = surface->format == QTRI_RGB565 && job->compare == QTRI_LESS && job->depth_write &&
                surface->pitch == 2 * surface->depth_pitch;
    job->fast_24p8 = fast ? QTRI_LINE_SHORT_24P8 : 0;
}

static inline int32_t hold(int32_t x)
{
    const int32_t limit = QTRI_SCREEN_MAX_24P8;
    if ((uint32_t)x + (uint32_t)limit > 2u * (uint32_t)limit) {
        QTRI_RARELY();
        x = x < 0 ? -limit : limit;
    }
    return x;
}

/* Times a colour of 8.16 bits: `steps` of 255 in Q32. */
#define RATIO_565_Q32(steps) ((uint32_t)((((uint64_t)(steps) << 32) + 127) / 255))

/* Rounded, and half a step more. */
static inline int32_t channel_565(int32_t color_8p16, uint32_t ratio_q32)
{
    const uint32_t white = (uint32_t)255 << 16;
    const uint64_t rounding = (uint64_t)0x8000 << 32 | (uint32_t)1 << 31;
    uint32_t c = (uint32_t)color_8p16;
    if (c > white) {
        QTRI_RARELY();
        c = color_8p16 < 0 ? 0 : white;
    }
    return (int32_t)((qtri_mul_u32(c, ratio_q32) + rounding) >> 32);
}

void qtri_line_end_init(qtri_line_end *end, const qtri_line_job *job, const qtri_screen_vertex *v)
{
    const uint32_t farthest = (uint32_t)65535 << 16;
    const int32_t half = 0x8000;
    const qtri_format format = job->surface->format;
    const qtri_rect *bounds = &job->bounds;
    int32_t x_24p8 = hold(v->x_24p8);
    int32_t y_24p8 = hold(v->y_24p8);
    int32_t x = x_24p8 >> 8;
    int32_t y = y_24p8 >> 8;
    end->x_24p8 = x_24p8;
    end->y_24p8 = y_24p8;
    end->outside =
        (x - bounds->x0) | (bounds->x1 - 1 - x) | (y - bounds->y0) | (bounds->y1 - 1 - y);
    end->depth_16p15 = (int32_t)((v->depth_16p16 < farthest ? v->depth_16p16 : farthest) >> 1);
    if (format == QTRI_RGB565) { /* half of what the call below costs */
        end->color[0] = channel_565(v->color_8p16[0], RATIO_565_Q32(31));
        end->color[1] = channel_565(v->color_8p16[1], RATIO_565_Q32(63));
        end->color[2] = channel_565(v->color_8p16[2], RATIO_565_Q32(31));
    } else {
        qtri_channels channels = qtri_channels_from_color(format, v->color_8p16);
        if (format != QTRI_XRGB8888) {
            channels.c[0] += channels.c[1] + channels.c[2];
            channels.c[1] = channels.c[2] = -half;
        }
        end->color[0] = channels.c[0] + half;
        end->color[1] = channels.c[1] + half;
        end->color[2] = channels.c[2] + half;
    }
    end->pixel = pixel_of(format, end->color[0], end->color[1], end->color[2]);
}

void qtri_line_triangle(const qtri_line_job *job, const qtri_screen_vertex v[3])
{
    const int32_t above = job->bounds.y0 * 256;
    const int32_t below = job->bounds.y1 * 256;
    if ((v[0].y_24p8 < above && v[1].y_24p8 < above && v[2].y_24p8 < above) ||
        (v[0].y_24p8 >= below && v[1].y_24p8 >= below && v[2].y_24p8 >= below)) {
        return;
    }
    qtri_line_end end[3];
    for (int i = 0; i < 3; i++) {
        qtri_line_end_init(&end[i], job, &v[i]);
    }
    qtri_line_draw(job, &end[0], &end[1]);
    qtri_line_draw(job, &end[1], &end[2]);
    qtri_line_draw(job, &end[2], &end[0]);
}

void qtri_raster_line(const qtri_surface *surface, const qtri_material *material,
                      const qtri_screen_vertex v[2])
{
    qtri_line_job job;
    qtri_line_end end[2];
    qtri_line_job_init(&job, surface, material);
    qtri_line_end_init(&end[0], &job, &v[0]);
    qtri_line_end_init(&end[1], &job, &v[1]);
    qtri_line_draw(&job, &end[0], &end[1]);
}
