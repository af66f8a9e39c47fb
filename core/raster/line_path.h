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
    const qtri_line_end *first, *last; /* by increasing major coordinate */
    bool steep;                        /* the major axis is y */
    int32_t major, minor;              /* of the first end, 1/256 pixel */
    int32_t length, delta;             /* to the last: 0 <= |delta| <= length <= 2^23 */
    int32_t along;                     /* 0..255 */
    int32_t position;                  /* of pixel 0 on the major axis */
    int32_t count;                     /* may be negative */
} qtri_line_path;

static inline void qtri_line_path_init(qtri_line_path *l, const qtri_line_end *a,
                                       const qtri_line_end *b)
{
    int32_t width = b->x_24p8 - a->x_24p8;
    int32_t height = b->y_24p8 - a->y_24p8;
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
    l->major = l->steep ? l->first->y_24p8 : l->first->x_24p8;
    l->minor = l->steep ? l->first->x_24p8 : l->first->y_24p8;
    /* Centres in [start, end): ceil((start - 128) / 256) is the first. */
    l->position = (l->major + 127) >> 8;
    l->along = 255 - ((l->major + 127) & 255);
    l->count = ((l->major + l->length + 127) >> 8) - l->position;
}

/* Draws any line. */
void qtri_line_draw_any(const qtri_line_job *job, const qtri_line_end *a, const qtri_line_end *b);

#endif
