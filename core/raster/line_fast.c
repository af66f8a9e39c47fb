/*
 * Short lines inside the bounds, RGB565, depth "less" and written: most of a wireframe.
 */
#include "line_path.h"

/* A pixel and the steps to the next. */
typedef struct walk {
    ptrdiff_t at;               /* bytes from the first pixel of the surface, as its depth */
    ptrdiff_t step, step_minor; /* to the next pixel, and what a carry adds */
    int32_t rest, rest_step;    /* remainder of the DDA (dda.h) less its denominator: < 0 */
    int32_t denominator;
    uint32_t z_16p15, z_step;
    uint64_t color, color_step; /* red 5.16, green 6.16, blue 5.16 bits, from the top */
} walk;

static inline void walk_position(walk *w, const qtri_line_path *l, const qtri_surface *surface)
{
    const ptrdiff_t pitch = surface->pitch;
    w->step = l->steep ? pitch : 2;
    w->step_minor = l->steep ? 2 : pitch;
    w->at = l->position * w->step + (l->minor >> 8) * w->step_minor - surface->first_row * pitch;
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
    int32_t first = qtri_line_depth_16p15(job, l->first);
    int32_t difference = qtri_line_depth_16p15(job, l->last) - first;
    int32_t quotient = qtri_divide(difference, by);
    int32_t remainder = difference - quotient * l->length; /* < 2^15 */
    int32_t start = quotient * l->along + qtri_divide(remainder * l->along, by);
    w->z_16p15 = (uint32_t)(first + start) + ((uint32_t)1 << 14);
    /* exceeds 32 bits where length < 256, with a single pixel */
    w->z_step = (uint32_t)quotient * 256u + (uint32_t)qtri_divide(remainder * 256, by);
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

/* At pixel k, from the channels of the ends. */
static inline void walk_color(walk *w, const int32_t *c, const int32_t *last,
                              const qtri_line_path *l, const qtri_divider *by, int32_t k)
{
    int32_t red = last[0] - c[0]; /* < 2^22 as the others */
    int32_t green = last[1] - c[1];
    int32_t blue = last[2] - c[2];
    w->color_step = packed(qtri_divide(red * 256, by), qtri_divide(green * 256, by),
                           qtri_divide(blue * 256, by));
    w->color =
        packed(c[0] + qtri_divide(red * l->along, by), c[1] + qtri_divide(green * l->along, by),
               c[2] + qtri_divide(blue * l->along, by)) +
        (uint32_t)k * w->color_step;
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

/* Of `count` pixels, those that are left from the first visible one on. */
static inline int32_t walk_hidden(walk *w, const qtri_surface *surface, int32_t count)
{
    const uint8_t *depths = (const uint8_t *)surface->depth;
    while (w->z_16p15 >> 15 >= *(const uint16_t *)(const void *)(depths + w->at) && --count > 0) {
        walk_next(w);
    }
    return count;
}

static inline void walk_visible(walk *w, const qtri_surface *surface, int32_t count, bool flat)
{
    uint8_t *pixels = surface->pixels;
    uint8_t *depths = (uint8_t *)surface->depth;
    do {
        uint16_t *depth = (uint16_t *)(void *)(depths + w->at);
        uint32_t z = w->z_16p15 >> 15;
        if (z < *depth) {
            *depth = (uint16_t)z;
            *(uint16_t *)(void *)(pixels + w->at) =
                (uint16_t)(flat ? (uint32_t)w->color : packed_pixel(w->color));
        }
        if (!flat) {
            w->color += w->color_step;
        }
        walk_next(w);
    } while (--count > 0);
}

static inline void channels_of(int32_t out[3], const qtri_line_job *job, const qtri_vertex *end,
                               const qtri_line_color *color)
{
    if (color != NULL) {
        qtri_line_channels_565(out, *color);
    } else {
        qtri_line_color tinted;
        qtri_line_tinted(job, end, tinted);
        qtri_line_channels_565(out, tinted);
    }
}

static inline void draw_fast(const qtri_line_job *job, const qtri_line_path *l,
                             const qtri_vertex *a, const qtri_line_color *color)
{
    const qtri_surface *surface = job->surface;
    walk w;
    qtri_divider by;
    qtri_divider_init(&by, (uint32_t)l->length);
    walk_position(&w, l, surface);
    walk_depth(&w, l, job, &by);
    int32_t count = walk_hidden(&w, surface, l->count); /* all of many edges of a mesh */
    if (count <= 0) {
        return;
    }
    int32_t first[3];
    int32_t last[3];
    const bool turned = l->first != a;
    channels_of(first, job, l->first, color != NULL ? &color[turned] : NULL);
    channels_of(last, job, l->last, color != NULL ? &color[!turned] : NULL);
    if ((((first[0] ^ last[0]) | (first[1] ^ last[1]) | (first[2] ^ last[2])) >> 16) == 0) {
        w.color = packed_pixel(packed(first[0], first[1], first[2])); /* so are all between */
        walk_visible(&w, surface, count, true);
    } else {
        walk_color(&w, first, last, l, &by, l->count - count);
        walk_visible(&w, surface, count, false);
    }
}

static inline bool is_inside(const qtri_line_job *job, const qtri_screen_point *at)
{
    return (uint32_t)(at->x_24p8 - job->left_24p8) < job->width_24p8 &&
           (uint32_t)(at->y_24p8 - job->top_24p8) < job->height_24p8;
}

void qtri_line_draw(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                    const qtri_line_color *color)
{
    qtri_line_path l;
    qtri_line_path_init(&l, a, b);
    if (l.count <= 0) {
        return;
    }
    if (QTRI_WITH_FAST_PATHS && is_inside(job, &a->at) && is_inside(job, &b->at) &&
        l.length < QTRI_LINE_SHORT_24P8) {
        draw_fast(job, &l, a, color);
    } else {
        qtri_line_draw_any(job, a, b, color);
    }
}
