/* SPDX-License-Identifier: MIT */
/*
 * An example of port/examples in a window, on a display as its panel shows it: `make window
 * EXAMPLE=terrain`. In place of host.c, which writes frames to files.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../port/examples/display.h"
#include "../../port/examples/example.h"
#include "../io/picture.h"
#include "screen.h"

static struct {
    struct screen screen;
    struct picture picture;
    const char *shot; /* where the frame is written that is seen then; NULL: nowhere */
    int frame, last;  /* the frame that is seen, and the one it ends with; -1: none */
    bool stands, failed;
} seen = {.last = -1};

static bool show(void)
{
    char text[2][120];
    const char *const lines[] = {text[0], text[1]};
    (void)snprintf(text[0], sizeof text[0], "%s, %d x %d, frame %d", example_name,
                   seen.picture.width, seen.picture.height, seen.frame);
    (void)snprintf(text[1], sizeof text[1], "space: %s, . a frame more, q the end",
                   seen.stands ? "goes on" : "stands still");
    return screen_show(&seen.screen, &seen.picture, lines, 2);
}

/* Shows the panel's pixels; false: the window is closed, or cannot be drawn. */
static bool wait_for_next(void)
{
    for (;;) {
        const int key = screen_key(seen.stands ? 1000 : 40);
        if (key == 'q') {
            return false;
        }
        if (key == ' ' || key == '.') {
            seen.stands = key == '.' || !seen.stands;
        }
        if (key == '.' || (key == 0 && !seen.stands)) {
            return true;
        }
        if ((key == -1 || key == ' ') && !show()) {
            seen.failed = true;
            return false;
        }
    }
}

bool example_next_frame(qtri_panel *panel)
{
    const int width = (int)qtri_panel_width(panel), height = (int)qtri_panel_height(panel);
    struct picture *picture = &seen.picture;
    seen.failed =
        qtri_panel_finish(panel) != QTRI_OK || display_complaint() != NULL ||
        (picture->rgb == NULL && !picture_create(picture, width, height, false)) ||
        (seen.screen.window == NULL && !screen_open(&seen.screen, example_name, width, height));
    if (display_complaint() != NULL) {
        fprintf(stderr, "window: %s\n", display_complaint());
    }
    for (int i = 0; i < width * height && !seen.failed; i++) {
        display_pixel(i % width, i / width, picture->rgb + 3 * (size_t)i);
    }
    seen.failed = seen.failed || !show();
    if (!seen.failed && seen.frame == seen.last) {
        seen.failed = !screen_shoot(&seen.screen, seen.shot);
        return false;
    }
    seen.frame++;
    return !seen.failed && (seen.last >= 0 || wait_for_next());
}

int main(int argc, char **argv)
{
    static const char usage[] = "usage: window lcd|oled|paper [FRAME FILE.ppm]\n\n"
                                "Shows the example's frames. With FRAME, a number: writes what "
                                "the window shows then, and ends.\n"
                                "Keys: space stands still and goes on, . a frame more, q ends.\n";
    const bool is_help = argc == 2 && strcmp(argv[1], "--help") == 0;
    if (is_help || (argc != 2 && argc != 4) || !display_choose(argv[1])) {
        fputs(usage, is_help ? stdout : stderr);
        return is_help ? 0 : 2;
    }
    if (argc == 4) {
        seen.last = (int)strtol(argv[2], NULL, 10);
        seen.shot = argv[3];
    }
    const bool ok = example_run() == QTRI_OK && !seen.failed;
    if (seen.screen.window != NULL) {
        screen_close(&seen.screen);
    }
    picture_free(&seen.picture);
    return ok ? 0 : 1;
}
