/* SPDX-License-Identifier: MIT */
/*
 * A screen: a panel, and the bands of its frame. Where to begin.
 *
 *     static uint8_t memory[QTRI_SCREEN_BYTES(320, 16, QTRI_RGB565_BYTES)];
 *
 *     qtri_screen_init(&screen, &qtri_ili9341, &bus, QTRI_ROTATE_90, &qtri_rgb565, 16, memory,
 *                      sizeof memory);
 *     for (;;) {
 *         while (qtri_screen_next(&screen, &band)) {
 *             qtri_draw_mesh(&band, &view, &pose, &mesh, &material);
 *         }
 *     }
 *
 * qtri_screen_next sends the band that was drawn, and clears the next one. There are two buffers:
 * with DMA in the bus one band is on its way while the next is drawn. Native RGB565 is brought into
 * the byte order of the display in its buffer, without a copy.
 *
 * screen.frame is the frame, for qtri_prepare_mesh, marks of changes and bands that overlap
 * (qtri/frame.h): of a band only the rows that are shown are sent, and of these what changed.
 * screen.panel is the panel, for qtri_panel_finish and qtri_panel_refresh.
 */
#ifndef QTRI_PORT_SCREEN_H
#define QTRI_PORT_SCREEN_H

#include "panel.h"
#include "qtri/frame.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A panel and the frame that it shows, in bands. */
typedef struct qtri_screen {
    qtri_panel panel;
    qtri_frame frame;
    qtri_rgb background;   /* of each band, black at first: for the user to set */
    enum qtri_error error; /* of init, then of the frame that was sent last */
    /* Internal. */
    qtri_surface band; /* that is being drawn */
    bool is_drawing;
} qtri_screen;

/*
 * Memory of a screen of so many columns, in bands of `rows` rows: two buffers, whose bands share
 * their depth, and the panel's line buffers. A constant expression. With fewer bytes, down to
 * QTRI_FRAME_BYTES + QTRI_PANEL_LINE_BYTES, there is one buffer.
 */
#define QTRI_SCREEN_BYTES(width, rows, pixel_bytes)                                                \
    (QTRI_FRAME_BYTES_DOUBLE(width, rows, pixel_bytes) + QTRI_PANEL_LINE_BYTES(width))

/*
 * Switches the panel on, with the first QTRI_PANEL_LINE_BYTES of the memory, and lays out a frame
 * of its size in the rest. Errors are those of qtri_panel_init and qtri_frame_init. After an error
 * the screen has no bands. Displays of packed pixels want bands of 8 rows, or a multiple of it.
 */
enum qtri_error qtri_screen_init(qtri_screen *screen, const qtri_panel_description *description,
                                 const qtri_bus *bus, qtri_rotation rotation,
                                 const qtri_format *format, int32_t rows, void *memory,
                                 size_t bytes);

/*
 * For a panel that is on already: screen->panel, after qtri_panel_init of it. Framebuffers,
 * modules that differ from their description, and displays that need an image of their memory.
 * All of the memory is the frame's. Errors: as qtri_frame_init.
 */
enum qtri_error qtri_screen_begin(qtri_screen *screen, const qtri_format *format, int32_t rows,
                                  void *memory, size_t bytes);

/*
 * Sends the last band, if there is one that was not sent, and clears the next. False: all of the
 * frame was sent, and the next call begins a new one; or sending failed, see screen->error. The end
 * of the last band may still be on its way: qtri_panel_finish waits for it.
 */
bool qtri_screen_next(qtri_screen *screen, qtri_surface *band);

#ifdef __cplusplus
}
#endif

#endif
