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
    int32_t step, step_minor;        /* 2 and the pitch, or the other way round */
} qtri_line_path;

static inline void qtri_line_path_init(qtri_line_path *l, const qtri_vertex *a,
                                       const qtri_vertex *b, int32_t pitch)
{
    int32_t step = 2;
    int32_t step_minor = pitch;
    int32_t major = a->at.x_24p8;
    int32_t minor = a->at.y_24p8;
    int32_t length = b->at.x_24p8 - major;
    int32_t delta = b->at.y_24p8 - minor;
    bool steep = false;
    if (qtri_magnitude32(delta) > qtri_magnitude32(length)) {
        int32_t x = major;
        int32_t width = length;
        major = minor;
        length = delta;
        minor = x;
        delta = width;
        steep = true;
        step = pitch;
        step_minor = 2;
    }
    l->first = a;
    l->last = b;
    if (length < 0) {
        major += length;
        minor += delta;
        length = -length;
        delta = -delta;
        l->first = b;
        l->last = a;
    }
    l->steep = steep;
    l->step = step;
    l->step_minor = step_minor;
    l->minor = minor;
    l->length = length;
    l->delta = delta;
    /* Centres in [start, end): ceil((start - 128) / 256) is the first. */
    l->position = (major + 127) >> 8;
    l->along = (128 - major) & 255;
    l->count = ((major + length + 127) >> 8) - l->position;
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
    const int32_t intensity = end->intensity_q15 * 2;
    out[0] = job->tint.r * intensity; /* <= 255.0 */
    out[1] = job->tint.g * intensity;
    out[2] = job->tint.b * intensity;
}

/* `steps` of 255, for a colour of 8.16 bits: in Q32, and what is 2^16 + 1 times that. */
#define QTRI_LINE_RATIO_Q32(steps) ((uint32_t)((((uint64_t)(steps) << 32) + 127) / 255))
#define QTRI_LINE_RATIO_Q16(steps) (QTRI_LINE_RATIO_Q32(steps) >> 16)

typedef char qtri_line_ratios_repeat
    [QTRI_LINE_RATIO_Q32(31) == 0x1F1F1F1F && QTRI_LINE_RATIO_Q32(63) == 0x3F3F3F3F ? 1 : -1];

/*
 * In units of RGB565, rounded to n.16, and half a step that rounds the pixel: color ratio_q32 +
 * 2^31 over 2^32. Without a long multiply, with p = color ratio_q16 = h 2^16 + l < 2^38, that is h
 * 2^32 + (l + h + 2^15) 2^16 + l over 2^32.
 */
static inline int32_t qtri_line_channel_565(int32_t color_8p16, uint32_t steps)
{
    const uint32_t color = (uint32_t)color_8p16; /* <= 255.0 */
#if QTRI_LONG_MULTIPLY
    const uint64_t rounding = (uint64_t)0x8000 << 32 | (uint32_t)1 << 31;
    return (int32_t)((qtri_mul_u32(color, QTRI_LINE_RATIO_Q32(steps)) + rounding) >> 32);
#else
    const uint32_t low = qtri_low16(color) * QTRI_LINE_RATIO_Q16(steps);
    const uint32_t high = (color >> 16) * QTRI_LINE_RATIO_Q16(steps) + (low >> 16);
    return (int32_t)(high + ((high + qtri_low16(low) + 0x8000u) >> 16) + 0x8000u);
#endif
}

static inline void qtri_line_channels_565(int32_t out[3], const qtri_line_color color)
{
    out[0] = qtri_line_channel_565(color[0], 31);
    out[1] = qtri_line_channel_565(color[1], 63);
    out[2] = qtri_line_channel_565(color[2], 31);
}

static inline void qtri_line_tinted_565(int32_t out[3], const qtri_line_job *job,
                                        const qtri_vertex *end)
{
    qtri_line_color color;
    qtri_line_tinted(job, end, color);
    qtri_line_channels_565(out, color);
}

/*
 * The channels of an end in units of the format, or gray and nothing more; n.16, and half a unit
 * that rounds. Without a colour it is tinted.
 */
void qtri_line_channels(int32_t out[3], const qtri_line_job *job, const qtri_vertex *end,
                        const qtri_line_color *color);

/* Draws any line. */
void qtri_line_draw_any(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                        const qtri_line_color *color);

#endif
