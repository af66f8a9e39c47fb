/* SPDX-License-Identifier: MIT */
/*
 * A window of SDL2 that shows pictures enlarged by whole pixels, and lines of text below them.
 */
#ifndef QTRI_HOST_WINDOW_SCREEN_H
#define QTRI_HOST_WINDOW_SCREEN_H

#include <SDL2/SDL.h>
#include <stdbool.h>

#include "../io/picture.h"

struct screen {
    SDL_Window *window;
    SDL_Renderer *renderer;
    int width, height; /* of the picture, pixels */
    int scale;         /* of the window a pixel of the picture */
};

/* Opens a window for pictures of this size. False after a message: SDL cannot. */
bool screen_open(struct screen *screen, const char *title, int width, int height);
void screen_close(struct screen *screen);

/* Shows a picture of the window's size, and up to 4 lines of ASCII. False after a message. */
bool screen_show(struct screen *screen, const struct picture *picture, const char *const *lines,
                 int line_count);

/*
 * The next key, as a letter; arrows are h j k l, Escape and a closed window q. 0: there is none
 * within so many milliseconds, -1: the window wants to be drawn anew.
 */
int screen_key(int wait_ms);

/*
 * Writes what the window shows to a PPM file, one pixel for each block of the enlarged picture.
 * False after a message: it cannot be read or written, or a block has not one colour.
 */
bool screen_shoot(struct screen *screen, const char *path);

#endif
