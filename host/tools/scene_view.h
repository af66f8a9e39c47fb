/* SPDX-License-Identifier: MIT */
/*
 * A scene as somebody looks at it who turns the camera and switches options: what the window of
 * host/window shows, without a window.
 */
#ifndef QTRI_HOST_TOOLS_SCENE_VIEW_H
#define QTRI_HOST_TOOLS_SCENE_VIEW_H

#include <stdbool.h>
#include <stddef.h>

#include "../io/picture.h"
#include "../io/text_error.h"

enum scene_view_mode { SCENE_VIEW_CORE, SCENE_VIEW_DOUBLE, SCENE_VIEW_DIFFERENCE };

/* Zeros: the scene as `qtri render` draws it. */
struct scene_view {
    enum scene_view_mode mode;
    int format;             /* 0 RGB888, 1 RGB565, 2 GRAY8 */
    int band_rows;          /* 0: one band */
    int wireframe;          /* not 0: lines */
    int antialias;          /* 0: as the scene says; else an enum scene_antialias and 1 */
    int azimuth, elevation; /* degrees that cameras are turned by */
    double time;            /* $t, 0..1 */
};

/* What a frame takes. */
struct scene_figures {
    int width, height;
    unsigned long triangles, pixels; /* asked for; covered */
    size_t band_bytes, vertex_bytes; /* RAM for colour and depth, and for vertices */
    double m0plus, m3;               /* instructions, scene_cost.h; 0: not known */
    int error;                       /* of these, percent */
    bool can_turn;                   /* there is a camera */
};

/* Draws the scene file into a new picture. False with *error set: it cannot be read or drawn. */
bool scene_view_draw(const struct scene_view *view, const char *path, struct picture *picture,
                     struct scene_figures *figures, struct text_error *error);

/* Turns to the next of what a key switches; 0: the key is none of these. */
int scene_view_key(struct scene_view *view, int key);

/* What the keys do, a line each; ends with NULL. */
extern const char *const scene_view_keys[];

/* Four lines of text about a frame, ended by NULL. */
enum { SCENE_VIEW_LINES = 4 };
void scene_view_describe(const struct scene_view *view, const struct scene_figures *figures,
                         char lines[SCENE_VIEW_LINES][120]);

#endif
