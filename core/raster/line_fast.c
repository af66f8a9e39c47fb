/*
 * Short lines whose columns lie inside the bounds, RGB565, depth "less" and written: most of a
 * wireframe, of a band too. Rows outside are cut off.
 */
#include "line_path.h"

#include "../geometry/row16.h"

/* A pixel and the steps to the next. */
typedef struct walk {
    int32_t at;               /* bytes from the first pixel of the surface, as its depth */
    int32_t step, step_minor; /* to the next pixel, and what a carry adds */
    int32_t rest, rest_step;  /* remainder of the DDA (dda.h) less its denominator: < 0 */
    int32_t denominator;
    uint32_t z_16p15, z_step;
} walk;

/* Where colours come from, and those of a pixel and the steps to the next. */
typedef struct shade {
    const qtri_vertex *first, *last;
    qtri_divider by;       /* the length */
    int32_t along;         /* from the first end to pixel 0 */
    int32_t k;             /* the pixel that `packed` is for */
    uint64_t packed, step; /* red 5.16, green 6.16, blue 5.16 bits, from the top */
} shade;

static inline void walk_position(walk *w, const qtri_line_path *l, const qtri_line_job *job)
{
    w->step = l->step;
    w->step_minor = l->step_minor;
    w->at = l->position * w->step + (l->minor >> 8) * w->step_minor - job->origin;
    /*
     * From that pixel to the minor coordinate at pixel 0, times length. 0 <= along < 256 and
     * |delta| <= length: the slope moves it by less than a pixel.
     */
    w->denominator = l->length * 256;
    w->rest = (l->minor & 255) * l->length + l->along * l->delta; /* |.| < 2^9 2^15 */
    w->rest_step = l->delta * 256;
    if (l->delta < 0) {
        w->rest_step += w->denominator;
        w->step -= w->step_minor;
        if (w->rest < 0) {
            w->rest += w->denominator;
            w->at -= w->step_minor;
        }
    } else if (w->rest >= w->denominator) {
        w->rest -= w->denominator;
        w->at += w->step_minor;
    }
    w->rest -= w->denominator;
}

static inline void walk_depth(walk *w, const qtri_line_path *l, const qtri_line_job *job,
                              const qtri_divider *by)
{
    const uint32_t small = (uint32_t)1 << 22; /* times 256 it fits 31 bits */
    int32_t first = qtri_line_depth_16p15(job, l->first);
    int32_t rest = qtri_line_depth_16p15(job, l->last) - first;
    int32_t quotient = 0;
    if (QTRI_DIVIDE || (uint32_t)rest + small >= 2 * small) { /* or the others serve alone */
        quotient = qtri_divide(rest, by);
        rest -= quotient * l->length; /* < 2^15 */
    }
    int32_t start = quotient * l->along + qtri_divide(rest * l->along, by);
    w->z_16p15 = (uint32_t)(first + start) + ((uint32_t)1 << 14);
    /* exceeds 32 bits where length < 256, with a single pixel */
    w->z_step = (uint32_t)quotient * 256u + (uint32_t)qtri_divide(rest * 256, by);
}

static inline void walk_next(walk *w)
{
    w->z_16p15 += w->z_step;
    w->at += w->step;
    w->rest += w->rest_step;
    if (w->rest >= 0) {
        w->rest -= w->denominator;
        w->at += w->step_minor;
    }
}

/* The memory of the rows inside the bounds, in bytes from the first pixel of the surface. */
typedef struct rows {
    uint32_t begin, size;
} rows;

static inline rows rows_inside(const qtri_line_job *job)
{
    const int32_t count = (int32_t)(job->height_24p8 >> 8);
    int32_t lowest = job->top_24p8 >> 8;
    int32_t pitch = job->pitch;
    if (pitch < 0) { /* bottom-up */
        lowest += count - 1;
        pitch = -pitch;
    }
    rows result = {(uint32_t)(lowest * job->pitch - job->origin), (uint32_t)(count * pitch)};
    return result;
}

/* Whether the row is; the column is. */
static inline bool is_inside(const walk *w, const rows *inside)
{
    return (uint32_t)w->at - inside->begin < inside->size;
}

/* Of `count` pixels, those that are left from the first visible one on. */
static inline int32_t walk_hidden(walk *w, const qtri_line_job *job, int32_t count)
{
    const uint8_t *depths = (const uint8_t *)job->surface->depth;
    for (; count > 0; count--) {
        if (w->z_16p15 >> 15 < *(const uint16_t *)(const void *)(depths + w->at)) {
            break;
        }
        walk_next(w);
    }
    return count;
}

/*
 * The word is the sum of its fields, each times its unit, modulo 2^64: right wherever all fields
 * are in range, steps may be negative.
 */
static inline uint64_t packed(int32_t red, int32_t green, int32_t blue)
{
    uint32_t high = ((uint32_t)red << 11) + (uint32_t)(green >> 11);
    return ((uint64_t)high << 32 | (uint32_t)green << 21) + (uint64_t)(int64_t)blue;
}

static inline uint32_t packed_pixel(uint64_t color)
{
    uint32_t high = (uint32_t)(color >> 32);
    uint32_t low = (uint32_t)(color & UINT32_MAX);
    return (high >> 27) << 11 | (high & 0x7E0u) | (low >> 16 & 31);
}

/*
 * False when all pixels are the one that s->packed starts with. A function of its own: what the
 * walk keeps in registers is put aside at once.
 */
QTRI_NOINLINE static bool shade_init(shade *s, const qtri_line_job *job,
                                     const qtri_line_color *first, const qtri_line_color *last)
{
    int32_t a[3];
    int32_t b[3];
    if (QTRI_SHARE) {
        qtri_line_channels(a, job, s->first, first);
        qtri_line_channels(b, job, s->last, last);
    } else if (first == NULL) {
        qtri_line_tinted_565(a, job, s->first);
        qtri_line_tinted_565(b, job, s->last);
    } else {
        qtri_line_channels_565(a, *first);
        qtri_line_channels_565(b, *last);
    }
    if ((((a[0] ^ b[0]) | (a[1] ^ b[1]) | (a[2] ^ b[2])) >> 16) == 0) {
        s->packed = packed(a[0], a[1], a[2]);
        s->step = 0;
        return false;
    }
    int32_t red = b[0] - a[0]; /* < 2^22 as the others */
    int32_t green = b[1] - a[1];
    int32_t blue = b[2] - a[2];
    int32_t red_step = qtri_divide(red * 256, &s->by);
    int32_t green_step = qtri_divide(green * 256, &s->by);
    int32_t blue_step = qtri_divide(blue * 256, &s->by);
    s->step = packed(red_step, green_step, blue_step);
    s->packed = packed(a[0] + qtri_divide(red * s->along, &s->by) + s->k * red_step,
                       a[1] + qtri_divide(green * s->along, &s->by) + s->k * green_step,
                       a[2] + qtri_divide(blue * s->along, &s->by) + s->k * blue_step);
    return true;
}

static inline void draw_visible(walk *w, const qtri_line_job *job, int32_t count, const shade *s,
                                bool flat)
{
    uint8_t *pixels = job->surface->pixels;
    uint8_t *depths = (uint8_t *)job->surface->depth;
    uint64_t color = s->packed;
    const uint64_t step = s->step;
    const uint32_t pixel = packed_pixel(color);
    do {
        uint16_t *depth = (uint16_t *)(void *)(depths + w->at);
        uint32_t z = w->z_16p15 >> 15;
        if (z < *depth) {
            *depth = (uint16_t)z;
            *(uint16_t *)(void *)(pixels + w->at) = (uint16_t)(flat ? pixel : packed_pixel(color));
        }
        if (!flat) {
            color += step;
        }
        walk_next(w);
    } while (--count > 0);
}

/* Pixels k..end-1, a few before and a few after them being outside of the rows: w moves to k. */
static inline void walk_cut(walk *w, const qtri_line_job *job, int32_t *k, int32_t *end)
{
    const rows inside = rows_inside(job);
    int32_t i = 0;
    for (; i < *end && !is_inside(w, &inside); i++) {
        walk_next(w);
    }
    *k = i;
    for (walk ahead = *w; i < *end && is_inside(&ahead, &inside); i++) {
        walk_next(&ahead);
    }
    *end = i;
}

static inline void draw_fast(const qtri_line_job *job, const qtri_line_path *l,
                             const qtri_vertex *a, const qtri_line_color *color, bool is_cut)
{
    walk w;
    shade s;
    int32_t k = 0;
    int32_t end = l->count;
    qtri_divider_init(&s.by, (uint32_t)l->length);
    walk_position(&w, l, job);
    walk_depth(&w, l, job, &s.by);
    if (is_cut) {
        walk_cut(&w, job, &k, &end);
    }
    int32_t count = walk_hidden(&w, job, end - k);
    if (count <= 0) {
        return;
    }
    s.first = l->first;
    s.last = l->last;
    s.along = l->along;
    s.k = end - count;
    const qtri_line_color *first = color;
    const qtri_line_color *last = color;
    if (color != NULL) {
        first += l->first != a;
        last += l->first == a;
    }
    if (shade_init(&s, job, first, last) || QTRI_SHARE) { /* one loop where code is to be small */
        draw_visible(&w, job, count, &s, false);
    } else {
        draw_visible(&w, job, count, &s, true);
    }
}

void qtri_line_draw(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                    const qtri_line_color *color)
{
    qtri_line_path l;
    qtri_line_path_init(&l, a, b, job->pitch);
    if (l.count <= 0) {
        return;
    }
    if (!QTRI_WITH_FAST_PATHS || l.length >= job->fast_24p8 ||
        (uint32_t)(a->at.x_24p8 - job->left_24p8) >= job->width_24p8 ||
        (uint32_t)(b->at.x_24p8 - job->left_24p8) >= job->width_24p8) {
        qtri_line_draw_any(job, a, b, color);
        return;
    }
    const uint32_t below_a = (uint32_t)(a->at.y_24p8 - job->top_24p8);
    const uint32_t below_b = (uint32_t)(b->at.y_24p8 - job->top_24p8);
    const bool is_cut = below_a >= job->height_24p8 || below_b >= job->height_24p8;
    if (is_cut && qtri_line_misses(job, a->at.y_24p8, b->at.y_24p8, b->at.y_24p8)) {
        return;
    }
    draw_fast(job, &l, a, color, is_cut);
}
