/* SPDX-License-Identifier: MIT */
/*
 * A walk on a map, for e-paper of 122x250 pixels and any other display up to 320x320. A step of the
 * walk draws, sends and refreshes only the rectangle about the old and the new place; everything is
 * refreshed when the map moves on, and from time to time, so that e-paper forgets what it showed.
 * Streets are constant data in pixels of the map; yours come from a file, the place from a
 * receiver.
 */
#include <qtri.h>

#include "qtri_port/screen.h"

#include "../example.h"

enum { WIDTH = 320, HEIGHT = 320, ROWS = 16, FRESH = 20, BAR = 12, MARK = 7, MARGIN = 24 };

const char example_name[] = "map";

static uint8_t band_memory[QTRI_FRAME_BYTES(WIDTH, ROWS, QTRI_GRAY8_BYTES)];

static const qtri_rgb white = {255, 255, 255}, black = {0, 0, 0}, water = {150, 150, 150},
                      grass = {215, 215, 215};

typedef struct place {
    int16_t x, y;
} place;

typedef struct street {
    const char *name; /* NULL: none */
    place label;      /* where it begins, on its baseline */
    uint8_t width, count;
    place point[6];
} street;

static const place lake[] = {{150, 120}, {190, 100}, {250, 108}, {290, 140},
                             {280, 190}, {230, 215}, {180, 200}, {140, 165}};
static const place river[] = {{282, 160}, {330, 175}, {370, 230}, {430, 250}, {520, 330}};
static const place park[] = {{330, 40}, {450, 30}, {470, 120}, {400, 150}, {340, 130}};
static const street streets[] = {
    {"Lake Road",
     {206, 70},
     6,
     6,
     {{0, 90}, {120, 84}, {200, 78}, {310, 100}, {330, 160}, {330, 320}}},
    {"Mill Lane", {408, 164}, 4, 4, {{310, 100}, {400, 170}, {480, 190}, {600, 180}}},
    {"Old Street", {70, 60}, 4, 4, {{40, 0}, {60, 87}, {90, 220}, {110, 320}}},
    {"South Bank", {180, 252}, 4, 5, {{90, 220}, {170, 232}, {250, 240}, {330, 236}, {460, 290}}},
    {NULL, {0, 0}, 2, 3, {{330, 40}, {400, 92}, {470, 120}}},
    {NULL, {0, 0}, 2, 3, {{60, 87}, {110, 130}, {120, 226}}},
    {"Park", {366, 62}, 2, 2, {{400, 170}, {392, 262}}},
    {NULL, {0, 0}, 2, 3, {{200, 78}, {214, 30}, {330, 40}}},
    {"Station", {492, 178}, 6, 3, {{440, 0}, {480, 190}, {500, 320}}},
};

/* The walk, and back to its beginning. */
static const place route[] = {{310, 100}, {400, 170}, {480, 190}, {460, 290},
                              {330, 236}, {250, 240}, {170, 232}, {120, 226},
                              {110, 130}, {60, 87},   {120, 84},  {200, 78}};
enum { CORNERS = sizeof route / sizeof route[0], STEP = 6 };

/* What is seen of the map: its pixel at the upper left of the frame. */
typedef struct window {
    int32_t x, y, width, height;
} window;

static qtri_point at(const window *w, place p)
{
    qtri_point point = {QTRI_PX(p.x - w->x), QTRI_PX(p.y - w->y)};
    return point;
}

static void draw_polygon(const qtri_surface *band, const window *w, const place *p, int32_t count,
                         const qtri_brush *brush)
{
    qtri_point point[8];
    for (int32_t i = 0; i < count; i++) {
        point[i] = at(w, p[i]);
    }
    qtri_paint_polygon(band, point, count, brush);
}

/* Strokes have flat ends; circles make round joints of them. */
static void draw_way(const qtri_surface *band, const window *w, const place *p, int32_t count,
                     int32_t width_24p8, const qtri_brush *brush)
{
    for (int32_t i = 0; i < count; i++) {
        qtri_point to = at(w, p[i]);
        qtri_paint_circle(band, &to, width_24p8 / 2, brush);
        if (i > 0) {
            qtri_point from = at(w, p[i - 1]);
            qtri_paint_stroke(band, &from, &to, width_24p8, brush);
        }
    }
}

/* Black on a border of white, which keeps it off the streets. */
static void draw_name(const qtri_surface *band, int32_t x, int32_t y, const char *name)
{
    const qtri_brush paper = qtri_brush_of(white), ink = qtri_brush_of(black);
    for (int32_t i = 0; i < 9; i++) {
        qtri_text_paint(band, &qtri_font_small, x - 1 + i % 3, y - 1 + i / 3, name, &paper);
    }
    qtri_text_paint(band, &qtri_font_small, x, y, name, &ink);
}

static void draw_streets(const qtri_surface *band, const window *w)
{
    const qtri_brush outline = qtri_brush_of(black), inside = qtri_brush_of(white);
    const int32_t count = sizeof streets / sizeof streets[0];
    for (int32_t i = 0; i < count; i++) {
        int32_t more = streets[i].width > 2 ? QTRI_PX(2) : 0;
        draw_way(band, w, streets[i].point, streets[i].count, QTRI_PX(streets[i].width) + more,
                 &outline);
    }
    for (int32_t i = 0; i < count; i++) {
        if (streets[i].width > 2) {
            draw_way(band, w, streets[i].point, streets[i].count, QTRI_PX(streets[i].width),
                     &inside);
        }
    }
    for (int32_t i = 0; i < count; i++) {
        if (streets[i].name != NULL) {
            draw_name(band, streets[i].label.x - w->x, streets[i].label.y - w->y, streets[i].name);
        }
    }
}

/* "1234 m" at the end of the text. */
static const char *text_of(char text[12], int32_t metres)
{
    char *end = text + 11;
    *end = '\0';
    *--end = 'm';
    *--end = ' ';
    do {
        *--end = (char)('0' + metres % 10);
        metres /= 10;
    } while (metres > 0 && end > text);
    return end;
}

static void draw_bar(const qtri_surface *band, const window *w, int32_t metres)
{
    const qtri_brush paper = qtri_brush_of(white), ink = qtri_brush_of(black);
    const qtri_area bar = {0, QTRI_PX(w->height - BAR), QTRI_PX(w->width), QTRI_PX(w->height)};
    char text[12];
    qtri_paint_rect(band, &bar, &ink);
    qtri_text_paint(band, &qtri_font_small, 3, w->height - 3, text_of(text, metres), &paper);
}

/* A ring with a point in it. */
static void draw_mark(const qtri_surface *band, const window *w, place p)
{
    const qtri_brush paper = qtri_brush_of(white), ink = qtri_brush_of(black);
    qtri_point center = at(w, p);
    qtri_paint_circle(band, &center, QTRI_PX(MARK), &ink);
    qtri_paint_circle(band, &center, QTRI_PX(MARK - 2), &paper);
    qtri_paint_circle(band, &center, QTRI_PX(2.5), &ink);
}

static void draw(const qtri_surface *band, const window *w, place here, int32_t metres)
{
    const qtri_brush blue = qtri_brush_of(water), green = qtri_brush_of(grass);
    draw_polygon(band, w, park, sizeof park / sizeof park[0], &green);
    draw_polygon(band, w, lake, sizeof lake / sizeof lake[0], &blue);
    draw_way(band, w, river, sizeof river / sizeof river[0], QTRI_PX(9), &blue);
    draw_streets(band, w);
    draw_mark(band, w, here);
    draw_bar(band, w, metres);
}

static qtri_rect mark_box(const window *w, place p)
{
    qtri_rect box = {p.x - w->x - MARK - 1, p.y - w->y - MARK - 1, p.x - w->x + MARK + 1,
                     p.y - w->y + MARK + 1};
    return box;
}

/* The window moves on when the place comes near its sides. */
static bool is_inside(const window *w, place p)
{
    return p.x - w->x >= MARGIN && p.x - w->x < w->width - MARGIN && p.y - w->y >= MARGIN &&
           p.y - w->y < w->height - MARGIN - BAR;
}

static void center_on(window *w, place p)
{
    w->x = p.x - w->width / 2;
    w->y = p.y - w->height / 2;
}

/* STEP pixels along the walk, or less to its next corner. */
static place walk(place from, int32_t *corner)
{
    q16 dx = (route[*corner].x - from.x) * Q16(1), dy = (route[*corner].y - from.y) * Q16(1);
    q16 left = q16_hypot(dx, dy);
    place to = route[*corner];
    if (left <= STEP * Q16(1)) {
        *corner = (*corner + 1) % CORNERS;
        return to;
    }
    to.x = (int16_t)(from.x + q16_to_int_round(q16_div(STEP * dx, left)));
    to.y = (int16_t)(from.y + q16_to_int_round(q16_div(STEP * dy, left)));
    return to;
}

enum qtri_error example_run(void)
{
    qtri_screen screen;
    enum qtri_error error = example_display(&screen.panel);
    if (error == QTRI_OK) {
        error = qtri_screen_begin(&screen, &qtri_gray8, ROWS, band_memory, sizeof band_memory);
    }
    if (error != QTRI_OK) {
        return error;
    }
    screen.background = white;
    window seen = {0, 0, screen.frame.width, screen.frame.height};

    place here = route[0], before = here;
    int32_t corner = 1, metres = 0, since = 0; /* since everything was refreshed */
    center_on(&seen, here);
    do {
        qtri_surface band;
        qtri_rect left = mark_box(&seen, before), entered = mark_box(&seen, here);
        if (!is_inside(&seen, here)) {
            center_on(&seen, here);
            since = 0;
        }
        if (since == 0) { /* the number below the map changes only then */
            qtri_frame_mark_all(&screen.frame);
        } else {
            qtri_frame_mark(&screen.frame, &left);
            qtri_frame_mark(&screen.frame, &entered);
            qtri_frame_only_changes(&screen.frame);
        }
        while (qtri_screen_next(&screen, &band)) {
            draw(&band, &seen, here, metres);
        }
        error = screen.error;
        if (error == QTRI_OK) {
            error = since == 0 ? qtri_panel_refresh(&screen.panel)
                               : qtri_panel_refresh_changes(&screen.panel);
        }
        since = (since + 1) % FRESH;
        before = here;
        here = walk(here, &corner);
        metres = (metres + 4 * STEP) % 1000000;
    } while (error == QTRI_OK && example_next_frame(&screen.panel));
    return error;
}
