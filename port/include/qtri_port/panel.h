/* SPDX-License-Identifier: MIT */
/*
 * Panels: a display is a description (constant data, one per model), a bus (functions of the
 * user's) and memory (the caller's).
 *
 *     static uint8_t line[QTRI_PANEL_LINE_BYTES(240)];
 *
 *     qtri_panel panel;
 *     qtri_panel_init(&panel, &qtri_ili9341, &spi, QTRI_ROTATE_0, line, sizeof line);
 *     for (each band) {
 *         draw into the band;
 *         qtri_panel_write(&panel, &band);
 *     }
 *
 * Surfaces of any format go to panels of any format: colour becomes gray by its luma
 * (qtri_surface_gray), gray becomes a few levels by dithering in coordinates of the frame, so bands
 * of any height and rectangles give the pixels of the whole frame.
 *
 * Rotation. The frame is what the viewer sees: a 240x320 panel turned by 90 degrees shows frames of
 * 320x240. QTRI_ROTATE_90 turns the picture clockwise on the glass. Colour controllers turn it
 * themselves; for the others and for framebuffers the panel does while it converts.
 *
 * Memory of a panel, `bytes` of qtri_panel_init:
 *   colours over a bus  two line buffers, so that one is filled while DMA sends the other:
 *                       QTRI_PANEL_LINE_BYTES(pixels); fewer pixels than a row, more transfers.
 *   GRAY1, GRAY4        an image of the display's memory, QTRI_PANEL_IMAGE_BYTES(...): 1 KB for
 *                       an SSD1306. Bands and rectangles of any shape then complete each
 *                       other's bytes. With less, down to a row of bytes,
 *                       QTRI_PANEL_ROW_BYTES(...), what is written must fill whole bytes, or
 *                       reach the frame's end: see qtri_panel_write_rect.
 *   memory-mapped       the framebuffer itself.
 */
#ifndef QTRI_PORT_PANEL_H
#define QTRI_PORT_PANEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "bus.h"
#include "qtri/dither.h"
#include "qtri/error.h"
#include "qtri/surface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Clockwise, as seen. Anything else is QTRI_ERROR_SIZE. */
typedef enum qtri_rotation {
    QTRI_ROTATE_0,
    QTRI_ROTATE_90,
    QTRI_ROTATE_180,
    QTRI_ROTATE_270
} qtri_rotation;

/* What the display's memory holds. Anything else is QTRI_ERROR_SIZE. */
typedef enum qtri_panel_format {
    QTRI_PANEL_RGB565,    /* 16 bits a pixel */
    QTRI_PANEL_RGB666,    /* 3 bytes a pixel, red first, six bits each, the high ones */
    QTRI_PANEL_XRGB8888,  /* 32 bits a pixel, memory-mapped displays only */
    QTRI_PANEL_GRAY4,     /* two pixels of a row a byte, the left one in the high half */
    QTRI_PANEL_GRAY1,     /* eight pixels of a row a byte, the leftmost in bit 7; 1 is white */
    QTRI_PANEL_GRAY1_PAGE /* eight pixels of a column a byte, the topmost in bit 0; 1 is white */
} qtri_panel_format;

/* Of pixels that are more than a byte. Anything else is QTRI_ORDER_BIG. */
typedef enum qtri_byte_order {
    QTRI_ORDER_BIG,    /* high byte first: what controllers on a bus of bytes expect */
    QTRI_ORDER_LITTLE, /* low byte first */
    QTRI_ORDER_NATIVE  /* as this machine stores a uint16_t: framebuffers; buses that send words.
                          rgb565 surfaces then go out without a copy, and rgb565_swapped ones
                          where the order is the other: see qtri_panel_finish */
} qtri_byte_order;

/* The most parameters that a step of a sequence has. */
#define QTRI_STEP_PARAMETERS 16

/* wait_ms: until the controller is ready, at most the description's busy_ms. */
#define QTRI_STEP_UNTIL_READY 255

/* One command of a sequence. */
typedef struct qtri_panel_step {
    uint8_t command;
    uint8_t count; /* of parameters, up to QTRI_STEP_PARAMETERS; more is QTRI_ERROR_SIZE */
    uint8_t parameters[QTRI_STEP_PARAMETERS];
    uint8_t wait_ms; /* after it */
} qtri_panel_step;

/*
 * Steps as constants, whose parameters are counted: QTRI_STEP(0x2A, 0, 0, 0, 0, 239) is CASET,
 * columns 0..239, and no wait; QTRI_STEP_ALONE(0x11, 120) has none and 120 ms. A step with more
 * than 16 parameters does not compile: it stops at qtri_step_has_more_than_16_parameters.
 */
#define QTRI_STEP_ALONE(command, wait_ms)                                                          \
    {                                                                                              \
        command, 0, {0}, wait_ms                                                                   \
    }
#define QTRI_STEP(command, wait_ms, ...)                                                           \
    {                                                                                              \
        command, QTRI_STEP_COUNT(__VA_ARGS__), {__VA_ARGS__}, wait_ms                              \
    }

/* The 33rd argument: what stands as far behind the parameters as there are of them. */
#define QTRI_STEP_MORE qtri_step_has_more_than_16_parameters
#define QTRI_STEP_COUNT(...)                                                                       \
    QTRI_STEP_AT_33(__VA_ARGS__, QTRI_STEP_MORE, QTRI_STEP_MORE, QTRI_STEP_MORE, QTRI_STEP_MORE,   \
                    QTRI_STEP_MORE, QTRI_STEP_MORE, QTRI_STEP_MORE, QTRI_STEP_MORE,                \
                    QTRI_STEP_MORE, QTRI_STEP_MORE, QTRI_STEP_MORE, QTRI_STEP_MORE,                \
                    QTRI_STEP_MORE, QTRI_STEP_MORE, QTRI_STEP_MORE, QTRI_STEP_MORE, 16, 15, 14,    \
                    13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0)
#define QTRI_STEP_AT_33(a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16,     \
                        a17, a18, a19, a20, a21, a22, a23, a24, a25, a26, a27, a28, a29, a30, a31, \
                        a32, a33, ...)                                                             \
    a33

typedef struct qtri_panel qtri_panel;

/* E-paper that can refresh what has changed alone: fast, and without turning black and white. */
typedef struct qtri_panel_partial {
    const qtri_panel_step *refresh;
    size_t refresh_count;
    /* Tells the controller what it shows now; called after each refresh. */
    enum qtri_error (*shown)(qtri_panel *panel);
} qtri_panel_partial;

/*
 * How a module differs from the description of its model: makers of modules mount and wire the same
 * glass in several ways. All false and 0: it does not. Fields are set one by one, none is needed:
 *
 *     qtri_module mine = {0};
 *     mine.swap_red_blue = true;
 *     qtri_panel_init_module(&panel, &qtri_st7789_135x240, &mine, &spi, ...);
 */
typedef struct qtri_module {
    bool swap_red_blue;  /* red looks blue. Controllers with a red_blue_bit only */
    bool invert;         /* black looks white. Controllers with invert_commands only */
    bool mirror_columns; /* left and right of the glass are exchanged, whatever the rotation */
    bool mirror_rows;    /* top and bottom are */
    int16_t column, row; /* added to the description's first_column and first_row: pixels */
} qtri_module;

/*
 * A model of display. Those in this folder are constants to use or to copy and change: another
 * size, another sequence. What differs from module to module is a qtri_module.
 */
typedef struct qtri_panel_description {
    uint16_t width, height; /* pixels of the glass, not rotated */
    qtri_panel_format format;
    qtri_byte_order order;

    const qtri_panel_step *init; /* after reset; the last one: display on. NULL: none */
    size_t init_count;
    const qtri_panel_step *refresh; /* shows what was written (e-paper). NULL: shown at once */
    size_t refresh_count;
    bool parameters_are_data; /* D/C is high for parameters (MIPI), or low (Solomon's OLEDs) */

    uint8_t reset_ms;  /* how long reset is active */
    uint8_t start_ms;  /* from there to the first command */
    uint16_t busy_ms;  /* the longest that QTRI_STEP_UNTIL_READY waits; longer is an error */
    uint16_t blind_ms; /* what it waits where the BUSY pin is not wired */

    /* Where the controller rotates: a command and its parameter for each rotation. 0: it does
       not. Bits as in MIPI's address mode: 0x80 rows, 0x40 columns reversed, 0x20 exchanged. */
    uint8_t orientation_command;
    uint8_t orientation[4];
    uint8_t rows_bit, columns_bit, red_blue_bit; /* of the parameter: what a module may turn */

    uint16_t memory_width, memory_height; /* pixels of the controller's memory, not rotated */
    uint16_t first_column, first_row;     /* of the glass in it; whole bytes of packed pixels */

    /* Sends the commands after which the data of a window follow, row by row, and stay inside.
       columns, rows: half-open, in units of the memory: pixels; bytes across for GRAY4 and GRAY1;
       pages down for GRAY1_PAGE. Those of the frame where the controller rotates, of the memory
       elsewhere. NULL: memory-mapped. */
    enum qtri_error (*window)(const qtri_panel *panel, const qtri_rect *window);

    /* How pixels reach the display's memory: one of the functions at the end of this header. */
    enum qtri_error (*write)(qtri_panel *panel, const qtri_surface *surface, qtri_rect rect);

    uint32_t pitch; /* memory-mapped: bytes from a row to the next; 0: without gaps */

    bool window_is_row;         /* packed pixels: windows are one row of bytes, a page, each */
    uint8_t window_mask;        /* packed pixels: bits of columns that windows begin and end
                                   without: 1 for pairs of bytes, 255 for whole rows */
    bool inverted;              /* inversion on shows colours as they are */
    uint8_t invert_commands[2]; /* inversion off, and on. 0: there are none, `init` decides */

    const qtri_panel_partial *partial; /* such a panel needs an image. NULL: none of these */
} qtri_panel_description;

/* A display in use, in memory of the caller. */
struct qtri_panel {
    const qtri_panel_description *description;
    const qtri_bus *bus;
    qtri_rotation rotation;
    uint8_t *memory;
    size_t bytes;

    qtri_module module;
    uint8_t orientation; /* the parameter that was sent */
    int32_t column, row; /* of the glass in the controller's memory */

    /* For the user to set between frames; BAYER8 and NULL after init. diffusion: GRAY1 and GRAY4.
     */
    qtri_dither dither;
    qtri_diffusion *diffusion; /* instead, if not NULL: bands in order; needs an image */

    /* RGB565: what surfaces of more bits are sent with, qtri_dither_row_565, which smooths the
       bands of smooth shading. NULL after init: each pixel to nearest. */
    void (*dither_565)(qtri_dither dither, int32_t x, int32_t y, const uint32_t *rgb, int32_t count,
                       uint16_t *pixels);

    bool sending;  /* between data_start and data_finish */
    bool is_shown; /* partial: the controller knows what it shows */
    bool polarity; /* Sharp's memory LCDs: the side of VCOM */
};

/* Memory of a colour panel on a bus: two buffers of `pixels`, one row or less; 1 at least, of
   RGB666, whose pixels take half as much more, 2. */
#define QTRI_PANEL_LINE_BYTES(pixels) ((size_t)(pixels)*4u)

/* Bytes across and rows of bytes down in the memory of a panel of packed pixels. */
#define QTRI_PANEL_ROW_BYTES(width, format)                                                        \
    ((format) == QTRI_PANEL_GRAY4   ? ((size_t)(width) + 1u) / 2u                                  \
     : (format) == QTRI_PANEL_GRAY1 ? ((size_t)(width) + 7u) / 8u                                  \
                                    : (size_t)(width))
#define QTRI_PANEL_ROWS(height, format)                                                            \
    ((format) == QTRI_PANEL_GRAY1_PAGE ? ((size_t)(height) + 7u) / 8u : (size_t)(height))

/* Memory that holds all of it; width and height of the glass, not rotated. */
#define QTRI_PANEL_IMAGE_BYTES(width, height, format)                                              \
    (QTRI_PANEL_ROW_BYTES(width, format) * QTRI_PANEL_ROWS(height, format))

/*
 * Fills in *panel, resets the display, sends its init sequence and black: the display is on and
 * dark. E-paper keeps what it shows, framebuffers what they hold. bus may be NULL for the latter.
 *
 * QTRI_ERROR_SIZE: a rotation outside 0..3; a description without pixels or `write`, with more than
 *   QTRI_SURFACE_MAX a side, with some outside the controller's memory, or, of packed pixels,
 *   with a first one inside a byte; a format that does not go with a bus, or without one; a step of
 *   too many parameters; something of the module that the controller cannot do.
 * QTRI_ERROR_MEMORY: bytes below the least stated above; a framebuffer that is too small.
 * QTRI_ERROR_BUS: a function of the bus returned false, or the display was busy for too long.
 *
 * After SIZE and MEMORY the panel has no pixels, and writing to it is QTRI_ERROR_SIZE.
 */
enum qtri_error qtri_panel_init(qtri_panel *panel, const qtri_panel_description *description,
                                const qtri_bus *bus, qtri_rotation rotation, void *memory,
                                size_t bytes);

/* As qtri_panel_init, for a module that differs from its description; NULL: it does not. */
enum qtri_error qtri_panel_init_module(qtri_panel *panel, const qtri_panel_description *description,
                                       const qtri_module *module, const qtri_bus *bus,
                                       qtri_rotation rotation, void *memory, size_t bytes);

/* The frame that the panel shows: width and height of its surfaces. */
int32_t qtri_panel_width(const qtri_panel *panel);
int32_t qtri_panel_height(const qtri_panel *panel);

/*
 * Sends the rows that the surface holds, whatever its scissor. With DMA it returns while the last
 * part is on its way: the surface may be drawn into at once, except for surfaces that go out
 * without a copy (over a bus: rgb565 to RGB565 in native order, rgb565_swapped to the other order);
 * those wait for qtri_panel_finish, or there is a second band to draw into meanwhile.
 *
 * QTRI_ERROR_SIZE: the surface's frame is not the panel's.
 * QTRI_ERROR_FORMAT: the surface has no format.
 * QTRI_ERROR_MEMORY: as for qtri_panel_write_rect.
 * QTRI_ERROR_BUS: the bus failed.
 */
enum qtri_error qtri_panel_write(qtri_panel *panel, const qtri_surface *surface);

/*
 * Sends what the surface holds of a rectangle of the frame; nothing if it holds nothing of it. More
 * may be sent: the rest of bytes that the rectangle cuts, from the same surface.
 *
 * QTRI_ERROR_MEMORY: packed pixels, a panel without a whole image, and the surface does not hold
 *   the rest of those bytes (bands of 8 rows would do, or 2), or diffusion is on.
 */
enum qtri_error qtri_panel_write_rect(qtri_panel *panel, const qtri_surface *surface,
                                      qtri_rect rect);

/* Waits until everything is sent. Nothing to do after functions that return an error. */
enum qtri_error qtri_panel_finish(qtri_panel *panel);

/* Shows what was written on displays that need to be told (e-paper), and waits until they have. */
enum qtri_error qtri_panel_refresh(qtri_panel *panel);

/*
 * Shows what has changed since the last refresh, where the description has `partial`; the first
 * refresh of a panel, and those of others, are as qtri_panel_refresh. What is left of old pictures
 * adds up: refresh everything after some twenty of these.
 */
enum qtri_error qtri_panel_refresh_changes(qtri_panel *panel);

/*
 * Sends commands of the user's: contrast, sleep, other gamma curves.
 *
 * QTRI_ERROR_SIZE: a step of more than QTRI_STEP_PARAMETERS parameters; it and what follows is not
 *   sent.
 */
enum qtri_error qtri_panel_send(qtri_panel *panel, const qtri_panel_step *steps, size_t count);

/*
 * What a description may `write` with, by its format: RGB565. A program links what its descriptions
 * name. These are called by qtri_panel_write_rect alone: rect is part of the frame and of the
 * surface, and not empty. QTRI_ERROR_BUS: the bus failed.
 */
enum qtri_error qtri_panel_write_565(qtri_panel *panel, const qtri_surface *surface,
                                     qtri_rect rect);

/* For RGB666, as qtri_panel_write_565. */
enum qtri_error qtri_panel_write_666(qtri_panel *panel, const qtri_surface *surface,
                                     qtri_rect rect);

/* For GRAY4, GRAY1 and GRAY1_PAGE. QTRI_ERROR_MEMORY: as for qtri_panel_write_rect. */
enum qtri_error qtri_panel_write_gray(qtri_panel *panel, const qtri_surface *surface,
                                      qtri_rect rect);

/* For displays whose memory is the panel's, RGB565 or XRGB8888. No errors. */
enum qtri_error qtri_panel_write_mapped(qtri_panel *panel, const qtri_surface *surface,
                                        qtri_rect rect);

#ifdef __cplusplus
}
#endif

#endif
