/*
 * A line's pixels and what lies between its ends. Internal to line.c and line_fast.c, whose pixels
 * are the same to the bit.
 */
#ifndef QTRI_RASTER_LINE_PATH_H
#define QTRI_RASTER_LINE_PATH_H

#include "divider.h"
#include "line.h"

/*
 * Colours and depths are ramps of 32 bits from pixel to pixel. Their steps are cut off to 2^-16
 * (depth: 2^-15) and so lag by 2^-8 at most after 128 pixels: longer lines start anew every
 * QTRI_LINE_CHUNK pixels, counted from their first one, whatever a scissor or a band cuts off.
 * Values lie between those of the ends and need no clamps.
 */
enum { QTRI_LINE_CHUNK = 128, QTRI_LINE_SHORT_24P8 = QTRI_LINE_CHUNK * 256 };

/*
 * A line along its major axis: x when it is at least as wide as high. Pixel k, k = 0, 1, ..., is
 * where it passes the k-th centre on that axis: along + 256 k from the first end.
 */
typedef struct qtri_line_path {
    const qtri_vertex *first, *last; /* by increasing major coordinate */
    bool steep;                      /* the major axis is y */
    int32_t minor;                   /* of the first end, 1/256 pixel */
    int32_t length, delta;           /* to the last: 0 <= |delta| <= length <= 2^23 */
    int32_t along;                   /* 0..255 */
    int32_t position;                /* of pixel 0 on the major axis */
    int32_t count;                   /* may be negative */
} qtri_line_path;

static inline void qtri_line_path_init(qtri_line_path *l, const qtri_vertex *a,
                                       const qtri_vertex *b)
{
    int32_t width = b->at.x_24p8 - a->at.x_24p8;
    int32_t height = b->at.y_24p8 - a->at.y_24p8;
    l->steep = qtri_magnitude32(height) > qtri_magnitude32(width);
    l->length = l->steep ? height : width;
    l->delta = l->steep ? width : height;
    l->first = a;
    l->last = b;
    if (l->length < 0) {
        l->length = -l->length;
        l->delta = -l->delta;
        l->first = b;
        l->last = a;
    }
    int32_t major = l->steep ? l->first->at.y_24p8 : l->first->at.x_24p8;
    l->minor = l->steep ? l->first->at.x_24p8 : l->first->at.y_24p8;
    /* Centres in [start, end): ceil((start - 128) / 256) is the first. */
    l->position = (major + 127) >> 8;
    l->along = 255 - ((major + 127) & 255);
    l->count = ((major + l->length + 127) >> 8) - l->position;
}

/* 0..65535.0: differences fit 32 bits. */
static inline int32_t qtri_line_depth_16p15(const qtri_line_job *job, const qtri_vertex *end)
{
    return (int32_t)((end->depth_16p8 & job->depth_mask) >> 1);
}

/* The share of the tint that a lit end has. */
static inline void qtri_line_tinted(const qtri_line_job *job, const qtri_vertex *end,
                                    qtri_line_color out)
{
    for (int i = 0; i < 3; i++) {
        out[i] = job->tint[i] * end->intensity_q15; /* <= 255.0 */
    }
}

/* Units of RGB565: times a colour of 8.16 bits, `steps` of 255 in Q32. */
#define QTRI_LINE_RATIO_Q32(steps) ((uint32_t)((((uint64_t)(steps) << 32) + 127) / 255))

/* Rounded to n.16, and half a step that rounds the pixel. */
static inline int32_t qtri_line_channel_565(int32_t color_8p16, uint32_t ratio_q32)
{
    const uint64_t rounding = (uint64_t)0x8000 << 32 | (uint32_t)1 << 31;
    return (int32_t)((qtri_mul_u32((uint32_t)color_8p16, ratio_q32) + rounding) >> 32);
}

static inline void qtri_line_channels_565(int32_t out[3], const qtri_line_color color)
{
    out[0] = qtri_line_channel_565(color[0], QTRI_LINE_RATIO_Q32(31));
    out[1] = qtri_line_channel_565(color[1], QTRI_LINE_RATIO_Q32(63));
    out[2] = qtri_line_channel_565(color[2], QTRI_LINE_RATIO_Q32(31));
}

/* Draws any line. */
void qtri_line_draw_any(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                        const qtri_line_color *color);

#endif
