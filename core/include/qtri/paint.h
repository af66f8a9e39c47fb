/* SPDX-License-Identifier: MIT */
/*
 * Flat shapes on a surface: rectangles, circles, rings, arcs, polygons, strokes.
 *
 * Coordinates are those of the frame in 1/256 pixel, as a triangle's corners are: QTRI_PX(3) is the
 * left or upper side of column or row 3. They are held to +-QTRI_PAINT_MAX_24P8. Everything is
 * clipped to the surface's rows and scissor, and a frame in bands has the pixels of the whole
 * frame. Depth is neither tested nor written.
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

#include <stdbool.h>
#include <stdint.h>

#include "q16.h"
#include "surface.h"

#ifdef __cplusplus
extern "C" {
#endif

#define QTRI_PX(n)                 ((int32_t)((n)*256)) /* pixels in 1/256: QTRI_PX(10), QTRI_PX(1.5) */
#define QTRI_PAINT_MAX_24P8        ((int32_t)1 << 22) /* 16384 pixels */
#define QTRI_PAINT_RADIUS_MAX_24P8 ((int32_t)1 << 21) /* 8192 pixels */

/* From x0, y0 to x1, y1 in 1/256 pixel; without an inside when x1 <= x0 or y1 <= y0. */
typedef struct qtri_area {
    int32_t x0_24p8, y0_24p8, x1_24p8, y1_24p8;
} qtri_area;

/* What edges and colours become. A description: what is not named is not linked. */
typedef struct qtri_ink qtri_ink;
extern const qtri_ink qtri_ink_blend, qtri_ink_smooth;

/* What flat shapes and text are painted with. */
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
 * The outline of a rectangle, `width_24p8` wide, inside of it; half of a side or more fills it, 0
 * or less paints nothing. No pixel is painted twice.
 */
void qtri_paint_rect_outline(const qtri_surface *surface, const qtri_area *box, int32_t width_24p8,
                             const qtri_brush *brush);

/*
 * A filled rectangle with round corners, and its outline, `width_24p8` wide. radius_24p8 is clamped
 * to 0 .. half the shorter side; the outline's inner corners have the radius less the width.
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
 * dozen. Smooth edges are only exact of an outline that does not cross itself.
 */
void qtri_paint_polygon(const qtri_surface *surface, const qtri_point *point, int32_t count,
                        const qtri_brush *brush);

/*
 * A straight stroke with flat ends, half of the width on either side. Width 0 or less, and equal
 * points, paint nothing. (Lines one pixel wide, with depth: qtri_raster_line, qtri_draw_lines.)
 */
void qtri_paint_stroke(const qtri_surface *surface, const qtri_point *from, const qtri_point *to,
                       int32_t width_24p8, const qtri_brush *brush);

/* Pictures
 * ---------------------------------------------------------------------------------------------- */

/*
 * A picture is memory in any format of surfaces: one drawn by the library itself, or constant data.
 * What has the surface's own format is copied as it is stored; anything else is converted through 8
 * bits a channel, 20 to 80 instructions a pixel on a Cortex-M0+.
 */

/* A picture in memory, flash or RAM, in any format that surfaces have. */
typedef struct qtri_image {
    const void *pixels;        /* of row 0, aligned for the format; NULL: nothing is painted */
    ptrdiff_t pitch;           /* bytes from a row to the next; negative for bottom-up memory */
    const qtri_format *format; /* NULL: nothing is painted */
    int32_t width, height;     /* any of 1..QTRI_SURFACE_MAX; otherwise nothing is painted */
    bool has_key;
    uint32_t key; /* the stored pixel that is not painted, if has_key */
} qtri_image;

/* The picture that a surface holds: all rows of it, without a key. */
qtri_image qtri_image_of(const qtri_surface *surface);

/*
 * The picture with its left upper corner at column x, row y. Of RGB565 on RGB565: 4 instructions a
 * pixel at most, 9 with a key.
 */
void qtri_image_paint(const qtri_surface *surface, const qtri_image *image, int32_t x, int32_t y);

/* The same, mixed with what is there: alpha of 255 is the picture alone, 0 paints nothing. */
void qtri_image_blend(const qtri_surface *surface, const qtri_image *image, int32_t x, int32_t y,
                      uint8_t alpha);

/*
 * Where the pixels of a picture come to lie, Q16.16, x right and y down:
 *
 *     x' = xx x + xy y + x0        y' = yx x + yy y + y0
 */
typedef struct qtri_affine {
    q16 xx, xy, x0, yx, yy, y0;
} qtri_affine;

/*
 * Scales a picture by (scale_x, scale_y), turns it by degrees, clockwise as seen in the picture,
 * around its point `pivot`, and puts that to `place`: all Q16.16, pixels. Saturates.
 */
void qtri_affine_place(qtri_affine *affine, q16 pivot_x, q16 pivot_y, q16 place_x, q16 place_y,
                       q16 scale_x, q16 scale_y, q16 degrees);

/*
 * The picture as `affine` says: each pixel whose centre it covers takes the picture's pixel there,
 * nearest. One that does not turn and scales by 1 paints what qtri_image_blend does. A matrix
 * without an inverse, or with one beyond 16384, paints nothing. The inverse is rounded to Q16.16:
 * across n pixels the picture's coordinate is off by n / 131072 at most. Cheapest without a turn.
 * The picture may not lie in the surface.
 */
void qtri_image_paint_affine(const qtri_surface *surface, const qtri_image *image,
                             const qtri_affine *affine, uint8_t alpha);

/* Text
 * ---------------------------------------------------------------------------------------------- */

/*
 * Proportional bitmap fonts, UTF-8. A font is constant data: what is not named is not linked. `qtri
 * font IN.bdf -o NAME.h` makes one of a BDF file; qtri_font_small is the library's own.
 *
 *     qtri_text_paint(&band, &qtri_font_small, 10, 20, "42 km/h", &brush);
 */

/* Rows of a glyph have (width + 7) / 8 bytes each, the leftmost pixel in the highest bit. */
typedef struct qtri_glyph {
    uint16_t first;        /* of its bytes in the font's `rows` */
    uint8_t width, height; /* of the box that is stored; 0 where there is nothing to see */
    int8_t left, top;      /* of the box: to the right of the pen, and above the baseline */
    uint8_t advance;       /* how far the pen goes on */
} qtri_glyph;

/* Characters `first` .. first + count - 1 are the glyphs from `glyph` on. */
typedef struct qtri_glyph_range {
    uint32_t first;
    uint16_t count, glyph;
} qtri_glyph_range;

/* A font: constant data, which `qtri font` makes of a BDF file. */
typedef struct qtri_font {
    const uint8_t *rows;
    const qtri_glyph *glyphs;
    const qtri_glyph_range *ranges; /* growing */
    uint16_t range_count;
    uint16_t missing;        /* the glyph of what the ranges do not have */
    uint8_t ascent, descent; /* pixels of a line above and below the baseline */
} qtri_font;

/* ASCII, proportional, capitals of 7 pixels, lines of 10. */
extern const qtri_font qtri_font_small;

/*
 * Paints text from pen position x (the left side of the first character's cell) on the baseline
 * above row `y`: whole pixels. Returns the pen's position behind it, saturated. A newline goes back
 * to x and down by ascent + descent rows. Bytes that are not UTF-8 are a missing character each.
 * Hard edges; alpha counts with an ink.
 */
int32_t qtri_text_paint(const qtri_surface *surface, const qtri_font *font, int32_t x, int32_t y,
                        const char *text, const qtri_brush *brush);

/* How far the pen goes in the widest line of the text, pixels, saturated. */
int32_t qtri_text_width(const qtri_font *font, const char *text);

/* The glyph of a character, never NULL. */
const qtri_glyph *qtri_font_glyph(const qtri_font *font, uint32_t character);

/*
 * The character that begins at *text, which moves on behind it; 0 at the end, where it stays.
 * 0xFFFD for a byte that does not begin a character: overlong, a surrogate, beyond 10FFFF, cut off.
 */
uint32_t qtri_text_next(const char **text);

#ifdef __cplusplus
}
#endif

#endif
