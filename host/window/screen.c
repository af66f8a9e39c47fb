/* SPDX-License-Identifier: MIT */
#include "screen.h"

#include <qtri.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What the window may take of a display, and its text: enlarged twice. */
enum { MOST_WIDTH = 1280, MOST_HEIGHT = 800, LINES = 4, LINE = 12, TEXT_SCALE = 2, MARGIN = 4 };

static bool fail(const char *what)
{
    fprintf(stderr, "window: %s: %s\n", what, SDL_GetError());
    return false;
}

static int text_width(const struct screen *screen)
{
    const int width = screen->scale * screen->width;
    return width > 640 ? width : 640;
}

bool screen_open(struct screen *screen, const char *title, int width, int height)
{
    const int across = MOST_WIDTH / width, down = MOST_HEIGHT / height;
    *screen = (struct screen){.width = width, .height = height};
    screen->scale = across < down ? across : down;
    screen->scale = screen->scale < 1 ? 1 : screen->scale;
    if (SDL_Init(SDL_INIT_VIDEO) != 0) {
        return fail("no display");
    }
    screen->window =
        SDL_CreateWindow(title, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, text_width(screen),
                         screen->scale * height + TEXT_SCALE * (LINES * LINE + 2 * MARGIN), 0);
    screen->renderer = screen->window == NULL
                           ? NULL
                           : SDL_CreateRenderer(screen->window, -1, SDL_RENDERER_SOFTWARE);
    return screen->renderer != NULL || fail("no window");
}

void screen_close(struct screen *screen)
{
    SDL_DestroyRenderer(screen->renderer);
    SDL_DestroyWindow(screen->window);
    SDL_Quit();
}

static bool copy(struct screen *screen, const void *pixels, Uint32 format, int pitch,
                 const SDL_Rect *from, const SDL_Rect *to)
{
    SDL_Texture *texture =
        SDL_CreateTexture(screen->renderer, format, SDL_TEXTUREACCESS_STREAMING, from->w, from->h);
    const bool ok = texture != NULL && SDL_UpdateTexture(texture, NULL, pixels, pitch) == 0 &&
                    SDL_RenderCopy(screen->renderer, texture, NULL, to) == 0;
    SDL_DestroyTexture(texture);
    return ok || fail("no picture");
}

/* The text by the core's own font. */
static bool show_text(struct screen *screen, const char *const *lines, int line_count)
{
    const int width = text_width(screen) / TEXT_SCALE, height = LINES * LINE + 2 * MARGIN;
    const size_t bytes = QTRI_BAND_BYTES(width, height, QTRI_XRGB8888_BYTES);
    void *memory = malloc(bytes);
    qtri_surface surface;
    if (memory == NULL || qtri_surface_init(&surface, &qtri_xrgb8888, width, height, 0, height,
                                            memory, bytes) != QTRI_OK) {
        free(memory);
        return fail("no memory for text");
    }
    const qtri_brush light = qtri_brush_of((qtri_rgb){230, 230, 230});
    qtri_surface_clear(&surface, (qtri_rgb){24, 24, 24});
    for (int i = 0; i < line_count && i < LINES; i++) {
        qtri_text_paint(&surface, &qtri_font_small, MARGIN, MARGIN + i * LINE + 9, lines[i],
                        &light);
    }
    const SDL_Rect from = {0, 0, width, height};
    const SDL_Rect to = {0, screen->scale * screen->height, TEXT_SCALE * width,
                         TEXT_SCALE * height};
    const bool ok =
        copy(screen, surface.pixels, SDL_PIXELFORMAT_RGB888, (int)surface.pitch, &from, &to);
    free(memory);
    return ok;
}

bool screen_show(struct screen *screen, const struct picture *picture, const char *const *lines,
                 int line_count)
{
    const SDL_Rect from = {0, 0, screen->width, screen->height};
    const SDL_Rect to = {0, 0, screen->scale * screen->width, screen->scale * screen->height};
    bool ok = SDL_SetRenderDrawColor(screen->renderer, 24, 24, 24, 255) == 0 &&
              SDL_RenderClear(screen->renderer) == 0;
    ok = ok && copy(screen, picture->rgb, SDL_PIXELFORMAT_RGB24, 3 * screen->width, &from, &to) &&
         show_text(screen, lines, line_count);
    SDL_RenderPresent(screen->renderer);
    return ok;
}

int screen_key(int wait_ms)
{
    SDL_Event event;
    if (SDL_WaitEventTimeout(&event, wait_ms) == 0) {
        return 0;
    }
    if (event.type == SDL_QUIT) {
        return 'q';
    }
    if (event.type == SDL_WINDOWEVENT) {
        return event.window.event == SDL_WINDOWEVENT_EXPOSED ? -1 : 0;
    }
    if (event.type != SDL_KEYDOWN) {
        return 0;
    }
    switch (event.key.keysym.sym) {
    case SDLK_LEFT:
        return 'h';
    case SDLK_RIGHT:
        return 'l';
    case SDLK_UP:
        return 'k';
    case SDLK_DOWN:
        return 'j';
    case SDLK_ESCAPE:
        return 'q';
    default:
        return event.key.keysym.sym > 0 && event.key.keysym.sym < 127 ? event.key.keysym.sym : 0;
    }
}

/* One pixel for each block, where it has one colour. */
static bool shrink(const struct screen *screen, const uint8_t *rgb, struct picture *picture)
{
    const int scale = screen->scale;
    const size_t pitch = 3 * (size_t)(scale * screen->width);
    for (int y = 0; y < scale * screen->height; y++) {
        for (int x = 0; x < scale * screen->width; x++) {
            uint8_t *pixel = picture->rgb + 3 * ((size_t)(y / scale) * (size_t)screen->width +
                                                 (size_t)(x / scale));
            const uint8_t *seen = rgb + (size_t)y * pitch + 3 * (size_t)x;
            if (x % scale == 0 && y % scale == 0) {
                memcpy(pixel, seen, 3);
            } else if (memcmp(pixel, seen, 3) != 0) {
                fprintf(stderr, "window: pixel %d %d is not enlarged by whole pixels\n", x, y);
                return false;
            }
        }
    }
    return true;
}

/* The display, a pixel for each block; false after a message. */
static bool read_back(struct screen *screen, struct picture *picture)
{
    const SDL_Rect part = {0, 0, screen->scale * screen->width, screen->scale * screen->height};
    uint8_t *rgb = malloc(3 * (size_t)part.w * (size_t)part.h);
    bool ok = rgb != NULL && picture_create(picture, screen->width, screen->height, false);
    if (!ok) {
        fputs("window: out of memory\n", stderr);
    } else if (SDL_RenderReadPixels(screen->renderer, &part, SDL_PIXELFORMAT_RGB24, rgb,
                                    3 * part.w) != 0) {
        ok = fail("cannot be read back");
    } else {
        ok = shrink(screen, rgb, picture);
    }
    free(rgb);
    return ok;
}

bool screen_shoot(struct screen *screen, const char *path)
{
    struct picture seen = {0};
    struct text_error error;
    bool ok = read_back(screen, &seen);
    if (ok && !picture_write_ppm(path, &seen, &error)) {
        fprintf(stderr, "window: %s\n", error.message);
        ok = false;
    }
    picture_free(&seen);
    return ok;
}
