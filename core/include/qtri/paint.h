/* SPDX-License-Identifier: MIT */
/*
 * Flat shapes on a surface: rectangles, circles, rings, arcs, polygons, strokes.
 *
 * Coordinates are those of the frame in 1/256 pixel, as a triangle's corners are: QTRI_PX(3) is the
 * left or upper side of column or row 3. They are held to +-QTRI_PAINT_MAX_24P8. Everything is
 * clipped to the surface's rows and scissor, and a frame in bands has the pixels of the whole
 * frame. Depth is neither tested nor written. Pictures are in image.h, text is in font.h.
 *
 * A brush says how a shape becomes pixels. Without an ink (NULL) it is opaque and has hard edges: a
 * pixel is painted when its centre lies inside, the left and the upper side counting as inside, the
 * right and the lower not, so that shapes which share a side share no pixel. With one:
 *
 *     qtri_ink_blend     hard edges; alpha counts
 *     qtri_ink_smooth    pixels take the share of the colour that the shape covers of their area,
 *                        within 1/32, exactly for rectangles; alpha counts
 *
 * Shapes are closed: where outlines overlap themselves, what they turn around at all is inside.
 */
#ifndef QTRI_PAINT_H
#define QTRI_PAINT_H

#include <stdint.h>

#include "q16.h"
#include "surface.h"

#ifdef __cplusplus
extern "C" {
#endif

#define QTRI_PX(n)                 ((int32_t)((n)*256)) /* pixels in 1/256: QTRI_PX(10), QTRI_PX(1.5) */
#define QTRI_PAINT_MAX_24P8        ((int32_t)1 << 22) /* 16384 pixels */
#define QTRI_PAINT_RADIUS_MAX_24P8 ((int32_t)1 << 21)

/* In 1/256 pixel. */
typedef struct qtri_point {
    int32_t x_24p8, y_24p8;
} qtri_point;

/* From x0, y0 to x1, y1 in 1/256 pixel; without an inside when x1 <= x0 or y1 <= y0. */
typedef struct qtri_area {
    int32_t x0_24p8, y0_24p8, x1_24p8, y1_24p8;
} qtri_area;

/* What edges and colours become. A description: what is not named is not linked. */
typedef struct qtri_ink qtri_ink;
extern const qtri_ink qtri_ink_blend, qtri_ink_smooth;

typedef struct qtri_brush {
    qtri_rgb color;
    uint8_t alpha;       /* 255: opaque, 0: nothing is painted; without an ink it counts as 255 */
    const qtri_ink *ink; /* NULL: opaque, hard edges */
} qtri_brush;

/* An opaque brush with hard edges, {color, 255, NULL}. */
static inline qtri_brush qtri_brush_of(qtri_rgb color)
{
    qtri_brush brush = {color, 255, NULL};
    return brush;
}

/* A filled rectangle; with hard edges 1.5 instructions a pixel at most. */
void qtri_paint_rect(const qtri_surface *surface, const qtri_area *box, const qtri_brush *brush);

/*
 * Its outline, `width_24p8` wide, inside the rectangle; half of a side or more fills it, 0 or less
 * paints nothing. No pixel is painted twice.
 */
void qtri_paint_rect_outline(const qtri_surface *surface, const qtri_area *box, int32_t width_24p8,
                             const qtri_brush *brush);

/*
 * With round corners: radius_24p8 is held to 0 .. half the shorter side. The outline's inner
 * corners have what the width leaves of the radius.
 */
void qtri_paint_round_rect(const qtri_surface *surface, const qtri_area *box, int32_t radius_24p8,
                           const qtri_brush *brush);
void qtri_paint_round_rect_outline(const qtri_surface *surface, const qtri_area *box,
                                   int32_t radius_24p8, int32_t width_24p8,
                                   const qtri_brush *brush);

/*
 * A filled circle, and a ring that reaches from the radius inwards. A radius of 0 or less paints
 * nothing, one above QTRI_PAINT_RADIUS_MAX_24P8 is that; a width of 0 or less paints nothing, one
 * of the radius or more fills the circle.
 */
void qtri_paint_circle(const qtri_surface *surface, const qtri_point *center, int32_t radius_24p8,
                       const qtri_brush *brush);
void qtri_paint_ring(const qtri_surface *surface, const qtri_point *center, int32_t radius_24p8,
                     int32_t width_24p8, const qtri_brush *brush);

/*
 * The part of a ring from an angle on: degrees in Q16.16, 0 to the right, growing clockwise as seen
 * in the picture. A negative sweep goes the other way round; 360 and more is the whole ring. A
 * width of the radius or more makes it a slice. Ends are straight.
 */
void qtri_paint_arc(const qtri_surface *surface, const qtri_point *center, int32_t radius_24p8,
                    int32_t width_24p8, q16 from, q16 sweep, const qtri_brush *brush);

/*
 * The inside of point[0] .. point[count-1] and back to the first, in either direction, convex or
 * not. Fewer than three points paint nothing. Every row looks at every side: for shapes of a few
 * dozen. An outline that crosses itself is filled wherever it turns around a pixel in sum, but its
 * smooth edges are only exact where it is simple.
 */
void qtri_paint_polygon(const qtri_surface *surface, const qtri_point *point, int32_t count,
                        const qtri_brush *brush);

/*
 * A straight stroke with flat ends, half of the width on either side. Width 0 or less, and equal
 * points, paint nothing. (Lines one pixel wide, with depth: qtri_raster_line, qtri_draw_lines.)
 */
void qtri_paint_stroke(const qtri_surface *surface, const qtri_point *from, const qtri_point *to,
                       int32_t width_24p8, const qtri_brush *brush);

#ifdef __cplusplus
}
#endif

#endif
