#include "line.h"

#include "dda.h"
#include "line_path.h"
#include "../frame/pixel.h"
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

typedef struct values {
    int32_t first[VALUES], last[VALUES];
} values;

void qtri_line_channels(int32_t out[3], const qtri_line_job *job, const qtri_vertex *end,
                        const qtri_line_color *color)
{
    const int32_t half = 0x8000;
    const qtri_kind kind = qtri_kind_of(job->surface);
    qtri_line_color tinted;
    if (color == NULL) {
        qtri_line_tinted(job, end, tinted);
        color = (const qtri_line_color *)&tinted;
    }
    if (kind == QTRI_KIND_RGB565) {
        qtri_line_channels_565(out, *color);
        return;
    }
    qtri_channels channels = qtri_channels_from_color(qtri_colors_of(job->surface), *color);
    if (kind == QTRI_KIND_GRAY8) {
        channels.c[0] += channels.c[1] + channels.c[2];
        channels.c[1] = channels.c[2] = -half;
    }
    for (int i = 0; i < CHANNELS; i++) {
        out[i] = channels.c[i] + half;
    }
}

/* At the ends of l, which goes from a to b or from b to a. */
static void values_init(values *v, const qtri_line_job *job, const qtri_line_path *l,
                        const qtri_vertex *a, const qtri_line_color *color)
{
    const qtri_line_color *first = color;
    const qtri_line_color *last = color;
    if (color != NULL) {
        first += l->first != a;
        last += l->first == a;
    }
    qtri_line_channels(v->first, job, l->first, first);
    qtri_line_channels(v->last, job, l->last, last);
    v->first[DEPTH] = qtri_line_depth_16p15(job, l->first);
    v->last[DEPTH] = qtri_line_depth_16p15(job, l->last);
}

static void ramps_init(ramp r[VALUES], const values *v, const qtri_line_path *l,
                       const qtri_divider *by, int32_t k)
{
    for (int i = 0; i < VALUES; i++) {
        ramp_init(&r[i], v->first[i], v->last[i], l, by, k);
    }
}

static inline uint32_t pixel_of(qtri_kind kind, int32_t c0, int32_t c1, int32_t c2)
{
    uint32_t red = (uint32_t)c0 >> 16;
    uint32_t green = (uint32_t)c1 >> 16;
    uint32_t blue = (uint32_t)c2 >> 16;
    switch (kind) {
    case QTRI_KIND_RGB565:
        return red << 11 | green << 5 | blue;
    case QTRI_KIND_XRGB8888:
        return red << 16 | green << 8 | blue;
    default:
        return red; /* gray */
    }
}

static void plot(const qtri_line_job *job, int32_t x, int32_t y, const ramp r[VALUES])
{
    const qtri_surface *surface = job->surface;
    const qtri_kind kind = qtri_kind_of(surface);
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
    qtri_pixel_store(kind, surface->pixels + stored_row * surface->pitch, x,
                     pixel_of(kind, r[0].value, r[1].value, r[2].value));
}

void qtri_line_draw_any(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                        const qtri_line_color *color)
{
    qtri_line_path own;
    qtri_line_path_init(&own, a, b, 0);
    const qtri_line_path *l = &own;
    const int32_t left = job->left_24p8 >> 8;
    const int32_t top = job->top_24p8 >> 8;
    const int32_t right = left + (int32_t)(job->width_24p8 >> 8);
    const int32_t bottom = top + (int32_t)(job->height_24p8 >> 8);
    int32_t low = l->steep ? top : left;
    int32_t high = l->steep ? bottom : right;
    int32_t minor_low = l->steep ? left : top;
    int32_t minor_high = l->steep ? right : bottom;
    int32_t minor_last = l->minor + l->delta;
    int32_t k = low > l->position ? low - l->position : 0;
    int32_t end = l->count < high - l->position ? l->count : high - l->position;
    if (k >= end || (l->minor >> 8 < minor_low && minor_last >> 8 < minor_low) ||
        (l->minor >> 8 >= minor_high && minor_last >> 8 >= minor_high)) {
        return;
    }
    qtri_dda minor;
    qtri_divider by;
    values v;
    ramp r[VALUES];
    values_init(&v, job, l, a, color);
    qtri_divider_init(&by, (uint32_t)l->length);
    qtri_dda_init(&minor, l->minor, l->delta, l->length, l->along + 256 * k, 0);
    ramps_init(r, &v, l, &by, k);
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
            ramps_init(r, &v, l, &by, k);
        }
    }
}

void qtri_line_job_init(qtri_line_job *job, const qtri_surface *surface,
                        const qtri_material *material)
{
    const qtri_rect bounds = qtri_drawn_bounds(surface);
    job->surface = surface;
    job->left_24p8 = bounds.x0 * 256;
    job->top_24p8 = bounds.y0 * 256;
    job->width_24p8 = (uint32_t)(bounds.x1 - bounds.x0) * 256;
    job->height_24p8 = (uint32_t)(bounds.y1 - bounds.y0) * 256;
    job->depth_mask = ~0xFFu;
    job->compare = surface->depth == NULL ? QTRI_DEPTH_OFF : material->depth_compare;
    job->depth_write = !material->depth_read_only;
    const ptrdiff_t pitch_end = (ptrdiff_t)1 << 16; /* times rows within 2^14 of 0: < 2^31 */
    const bool fast = QTRI_WITH_FAST_PATHS && qtri_kind_of(surface) == QTRI_KIND_RGB565 &&
                      job->compare == QTRI_LESS && job->depth_write &&
                      surface->pitch == 2 * surface->depth_pitch && surface->pitch < pitch_end &&
                      surface->pitch > -pitch_end;
    job->fast_24p8 = fast ? QTRI_LINE_SHORT_24P8 : 0;
    job->pitch = fast ? (int32_t)surface->pitch : 0;
    job->origin = surface->first_row * job->pitch;
    job->tint = material->color;
}

void qtri_line_end(qtri_vertex *end, qtri_line_color color, const qtri_screen_vertex *v)
{
    const uint32_t farthest = (uint32_t)65535 << 16;
    end->at.x_24p8 = qtri_hold32(v->x_24p8, -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
    end->at.y_24p8 = qtri_hold32(v->y_24p8, -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
    end->depth_16p8 = v->depth_16p16 < farthest ? v->depth_16p16 : farthest;
    for (int i = 0; i < 3; i++) {
        color[i] = qtri_hold32(v->color_8p16[i], 0, 255 << 16);
    }
}

void qtri_raster_line(const qtri_surface *surface, const qtri_material *material,
                      const qtri_screen_vertex v[2])
{
    qtri_line_job job;
    qtri_vertex end[2];
    qtri_line_color color[2];
    qtri_line_job_init(&job, surface, material);
    job.depth_mask = UINT32_MAX;
    qtri_line_end(&end[0], color[0], &v[0]);
    qtri_line_end(&end[1], color[1], &v[1]);
    qtri_line_draw(&job, &end[0], &end[1], (const qtri_line_color *)color);
}
