/* SPDX-License-Identifier: MIT */
#include "internal.h"

/* A controller that rotates mirrors too; for the others a mirrored module's glass is another one,
   seen from its end. */
static bool mirrors(const qtri_panel *panel, bool mirrored)
{
    return mirrored && panel->description->orientation_command == 0;
}

/* Pixel (x, y) of the frame on a glass of w x h, clockwise. */
static void place(const qtri_panel *panel, int32_t x, int32_t y, int32_t *glass_x, int32_t *glass_y)
{
    int32_t w = panel->description->width;
    int32_t h = panel->description->height;
    switch (panel->rotation) {
    case QTRI_ROTATE_90: /* the top row becomes the right column */
        *glass_x = w - 1 - y;
        *glass_y = x;
        break;
    case QTRI_ROTATE_180:
        *glass_x = w - 1 - x;
        *glass_y = h - 1 - y;
        break;
    case QTRI_ROTATE_270: /* the top row becomes the left column */
        *glass_x = y;
        *glass_y = h - 1 - x;
        break;
    default:
        *glass_x = x;
        *glass_y = y;
        break;
    }
    if (mirrors(panel, panel->module.mirror_columns)) {
        *glass_x = w - 1 - *glass_x;
    }
    if (mirrors(panel, panel->module.mirror_rows)) {
        *glass_y = h - 1 - *glass_y;
    }
}

/* The half-open rectangle with these pixels in opposite corners. */
static qtri_rect spanned(int32_t x0, int32_t y0, int32_t x1, int32_t y1)
{
    qtri_rect rect = {x0 < x1 ? x0 : x1, y0 < y1 ? y0 : y1, (x0 < x1 ? x1 : x0) + 1,
                      (y0 < y1 ? y1 : y0) + 1};
    return rect;
}

qtri_rect qtri_panel_to_glass(const qtri_panel *panel, qtri_rect rect)
{
    int32_t x0, y0, x1, y1;
    place(panel, rect.x0, rect.y0, &x0, &y0);
    place(panel, rect.x1 - 1, rect.y1 - 1, &x1, &y1);
    return spanned(x0, y0, x1, y1);
}

/* The other way: 90 and 270 degrees are each other's inverse, on the glass turned. */
qtri_rect qtri_panel_from_glass(const qtri_panel *panel, qtri_rect rect)
{
    int32_t w = panel->description->width;
    int32_t h = panel->description->height;
    if (mirrors(panel, panel->module.mirror_columns)) {
        rect = spanned(w - 1 - rect.x0, rect.y0, w - rect.x1, rect.y1 - 1);
    }
    if (mirrors(panel, panel->module.mirror_rows)) {
        rect = spanned(rect.x0, h - 1 - rect.y0, rect.x1 - 1, h - rect.y1);
    }
    switch (panel->rotation) {
    case QTRI_ROTATE_90:
        return spanned(rect.y0, w - 1 - rect.x0, rect.y1 - 1, w - rect.x1);
    case QTRI_ROTATE_180:
        return spanned(w - 1 - rect.x0, h - 1 - rect.y0, w - rect.x1, h - rect.y1);
    case QTRI_ROTATE_270:
        return spanned(h - 1 - rect.y0, rect.x0, h - rect.y1, rect.x1 - 1);
    default:
        return rect;
    }
}

qtri_walk qtri_panel_walk(const qtri_panel *panel, int32_t y)
{
    qtri_walk walk;
    int32_t next_x, next_y;
    place(panel, 0, y, &walk.x, &walk.y);
    place(panel, 1, y, &next_x, &next_y);
    walk.dx = next_x - walk.x;
    walk.dy = next_y - walk.y;
    return walk;
}
