/* SPDX-License-Identifier: MIT */
#include "paint.h"

#include <math.h>

#define PI      3.14159265358979323846
#define SAMPLES 32

struct shape {
    enum scene_paint_kind kind;
    double n[SCENE_PAINT_NUMBERS];
    int count;
};

static bool in_rect(double x, double y, double x0, double y0, double x1, double y1)
{
    return x >= x0 && x < x1 && y >= y0 && y < y1;
}

static bool in_round_rect(double x, double y, const double n[4], double inset, double radius)
{
    double x0 = n[0] + inset, y0 = n[1] + inset, x1 = n[2] - inset, y1 = n[3] - inset;

    if (!in_rect(x, y, x0, y0, x1, y1))
        return false;
    double dx = fmax(0, fmax(x0 + radius - x, x - x1 + radius));
    double dy = fmax(0, fmax(y0 + radius - y, y - y1 + radius));
    return hypot(dx, dy) <= radius || dx == 0 || dy == 0;
}

/* Whether the points, joined in order, turn around (x, y). */
static bool in_area(double x, double y, const double *n, int points)
{
    int winding = 0;

    for (int i = 0; i < points; i++) {
        const double *a = &n[2 * i];
        const double *b = &n[2 * ((i + 1) % points)];
        double side = (b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1]);
        if (a[1] <= y && b[1] > y)
            winding += side <= 0;
        else if (a[1] > y && b[1] <= y)
            winding -= side >= 0;
    }
    return winding != 0;
}

static bool in_arc(double dx, double dy, const double *n)
{
    double from = n[5] < 0 ? n[4] + n[5] : n[4];
    double distance = hypot(dx, dy);
    double angle = fmod(atan2(dy, dx) * 180 / PI - from, 360);

    if (angle < 0)
        angle += 360;
    return distance <= n[2] && distance > n[2] - n[3] && angle <= fabs(n[5]);
}

/* A rectangle along the way, whose sides follow the same rule as those of any area. */
static bool in_stroke(double x, double y, const double *n)
{
    double dx = n[2] - n[0];
    double dy = n[3] - n[1];
    double length = hypot(dx, dy);

    if (!(length > 0) || n[4] <= 0)
        return false;
    double ox = -dy / length * n[4] / 2;
    double oy = dx / length * n[4] / 2;
    double corner[8] = {n[0] + ox, n[1] + oy, n[2] + ox, n[3] + oy,
                        n[2] - ox, n[3] - oy, n[0] - ox, n[1] - oy};
    return in_area(x, y, corner, 4);
}

static bool is_inside(const struct shape *shape, double x, double y)
{
    const double *n = shape->n;
    double dx = x - n[0];
    double dy = y - n[1];

    switch (shape->kind) {
    case SCENE_PAINT_RECT:
        return in_rect(x, y, n[0], n[1], n[2], n[3]) &&
               (shape->count == 4 ||
                (n[4] > 0 && !in_rect(x, y, n[0] + n[4], n[1] + n[4], n[2] - n[4], n[3] - n[4])));
    case SCENE_PAINT_ROUNDRECT: {
        double radius = fmax(0, fmin(n[4], fmin(n[2] - n[0], n[3] - n[1]) / 2));
        return in_round_rect(x, y, n, 0, radius) &&
               (shape->count == 5 ||
                (n[5] > 0 && !in_round_rect(x, y, n, n[5], fmax(0, radius - n[5]))));
    }
    case SCENE_PAINT_CIRCLE: {
        double distance = hypot(dx, dy);
        return distance <= n[2] && (shape->count == 3 || (n[3] > 0 && distance > n[2] - n[3]));
    }
    case SCENE_PAINT_ARC:
        return in_arc(dx, dy, n);
    case SCENE_PAINT_AREA:
        return in_area(x, y, n, shape->count / 2);
    case SCENE_PAINT_STROKE:
        return in_stroke(x, y, n);
    case SCENE_PAINT_TEXT:
    case SCENE_PAINT_IMAGE:
        break;
    }
    return false;
}

/* The bits of i, 0..k-1, in reverse: where in its cell a point lies, 0..1. k: a power of two. */
static double reversed(int i, int k)
{
    int out = 0;

    for (int bit = 1; bit < k; bit *= 2, i /= 2)
        out = 2 * out + i % 2;
    return (out + 0.5) / k;
}

/*
 * How many of k x k points in a pixel lie inside: one in each cell of a grid, and one in each of
 * k * k columns and rows, so that edges along an axis count as finely as others.
 */
static int count_inside(const struct shape *shape, int x, int y, int k)
{
    int inside = 0;

    for (int i = 0; i < k; i++)
        for (int j = 0; j < k; j++)
            inside += is_inside(shape, x + (j + reversed(i, k)) / k, y + (i + reversed(j, k)) / k);
    return inside;
}

/*
 * Eight by eight points and the corners tell whether an edge passes through. What is left of a
 * pixel may fall between all points: it has an edge nevertheless.
 */
static double coverage(const struct shape *shape, int x, int y, bool *is_edge)
{
    int few = count_inside(shape, x, y, 8);
    int corners = is_inside(shape, x, y) + is_inside(shape, x + 1, y) + is_inside(shape, x, y + 1) +
                  is_inside(shape, x + 1, y + 1);

    *is_edge = (few != 0 || corners != 0) && (few != 64 || corners != 4);
    if (!*is_edge)
        return few / 64.0;
    return count_inside(shape, x, y, SAMPLES) / (double)(SAMPLES * SAMPLES);
}

/* Of hard edges: whether a point 1/256 pixel from the centre lies on the other side. */
static bool is_at_edge(const struct shape *shape, double x, double y, bool inside)
{
    for (int i = 0; i < 8; i++)
        if (is_inside(shape, x + cos(i * PI / 4) / 256, y + sin(i * PI / 4) / 256) != inside)
            return true;
    return false;
}

/* Notes what a shape of hard edges would change that may cover the pixel as well as not. */
static void note_either(struct ref_target *target, int x, int y, const double color[3],
                        double alpha)
{
    size_t i = (size_t)y * (size_t)target->image->width + (size_t)x;
    double most = 0;

    for (size_t c = 0; c < 3; c++)
        most = fmax(most, fabs(color[c] - target->image->color[3 * i + c]));
    ref_target_either(target, i, alpha * most);
}

static void mix(struct ref_target *target, int x, int y, const double color[3], double alpha,
                bool is_edge)
{
    struct reference_image *image = target->image;
    size_t pixel = (size_t)y * (size_t)image->width + (size_t)x;
    size_t i = 3 * pixel;
    double most = 0;

    for (size_t c = 0; c < 3; c++) {
        double *to = &image->color[i + c];
        most = fmax(most, fabs(color[c] - *to));
        *to += alpha * (color[c] - *to);
        image->color_min[i + c] = fmin(image->color_min[i + c], *to);
        image->color_max[i + c] = fmax(image->color_max[i + c], *to);
    }
    ref_target_mixed(target, pixel, 1 - alpha, is_edge ? most : 0);
}

/* Pixels that the shape may reach: its points and radii, generously. */
static void bounds(const struct ref_target *target, const struct shape *shape, int box[4])
{
    const double *n = shape->n;
    double x0 = n[0], y0 = n[1], x1 = n[0], y1 = n[1], reach = 2;
    int points = shape->kind == SCENE_PAINT_AREA ? shape->count / 2
                 : shape->kind == SCENE_PAINT_CIRCLE || shape->kind == SCENE_PAINT_ARC ? 1
                                                                                       : 2;

    for (int i = 1; i < points; i++) {
        x0 = fmin(x0, n[2 * i]);
        x1 = fmax(x1, n[2 * i]);
        y0 = fmin(y0, n[2 * i + 1]);
        y1 = fmax(y1, n[2 * i + 1]);
    }
    if (points == 1)
        reach += n[2];
    if (shape->kind == SCENE_PAINT_STROKE)
        reach += fabs(n[4]);
    box[0] = (int)fmax(0, floor(x0 - reach));
    box[1] = (int)fmax(0, floor(y0 - reach));
    box[2] = (int)fmin(target->image->width, ceil(x1 + reach));
    box[3] = (int)fmin(target->image->height, ceil(y1 + reach));
}

/* Shapes are given in 1/256 pixel, to nearest; the angles of an arc are degrees. */
static double number(const struct scene_paint *paint, int i)
{
    double n = (double)paint->number[i] / 65536.0;

    return paint->kind == SCENE_PAINT_ARC && i >= 4 ? n : floor(n * 256 + 0.5) / 256;
}

static void paint_shape(struct ref_target *target, const struct scene_paint *paint,
                        const double color[3], double alpha)
{
    struct shape shape = {.kind = paint->kind, .count = paint->count};
    int box[4];

    for (int i = 0; i < SCENE_PAINT_NUMBERS; i++)
        shape.n[i] = number(paint, i);
    bounds(target, &shape, box);
    for (int y = box[1]; y < box[3]; y++) {
        for (int x = box[0]; x < box[2]; x++) {
            bool is_edge = false;
            double share = paint->is_smooth ? coverage(&shape, x, y, &is_edge)
                                            : (double)is_inside(&shape, x + 0.5, y + 0.5);
            bool either = !paint->is_smooth && is_at_edge(&shape, x + 0.5, y + 0.5, share > 0);
            double before[3];
            for (int c = 0; c < 3; c++)
                before[c] = target->image->color[3 * (y * target->image->width + x) + c];
            if (share > 0)
                mix(target, x, y, color, alpha * share, is_edge);
            if (either)
                note_either(target, x, y, share > 0 ? before : color, share > 0 ? 1 : alpha);
        }
    }
}

/* ---- Text ---- */

static void paint_glyph(struct ref_target *target, const struct bdf_font *font,
                        const struct bdf_glyph *glyph, int pen, int baseline, const double color[3],
                        double alpha)
{
    size_t stride = ((size_t)glyph->width + 7) / 8;

    for (int j = 0; j < glyph->height; j++) {
        for (int i = 0; i < glyph->width; i++) {
            uint8_t byte = font->rows[glyph->first + (size_t)j * stride + (size_t)i / 8];
            int x = pen + glyph->left + i;
            int y = baseline - glyph->top + j;
            if ((byte & 0x80u >> i % 8) != 0 && x >= 0 && x < target->image->width && y >= 0 &&
                y < target->image->height)
                mix(target, x, y, color, alpha, false);
        }
    }
}

/* UTF-8 of up to three bytes is read here; anything else is a missing character a byte. */
static const char *take_character(const char *text, uint32_t *character)
{
    const unsigned char *byte = (const unsigned char *)text;

    if (byte[0] < 0x80) {
        *character = byte[0];
        return text + 1;
    }
    if (byte[0] >= 0xC2 && byte[0] < 0xE0 && (byte[1] & 0xC0) == 0x80) {
        *character = (byte[0] & 0x1Fu) * 64 + (byte[1] & 0x3Fu);
        return text + 2;
    }
    if (byte[0] >= 0xE0 && byte[0] < 0xF0 && (byte[1] & 0xC0) == 0x80 && (byte[2] & 0xC0) == 0x80) {
        *character = (byte[0] & 0x0Fu) * 4096 + (byte[1] & 0x3Fu) * 64 + (byte[2] & 0x3Fu);
        if (*character >= 0x800 && (*character < 0xD800 || *character > 0xDFFF))
            return text + 3;
    }
    *character = 0xFFFD;
    return text + 1;
}

static void paint_text(struct ref_target *target, const struct scene_paint *paint,
                       const double color[3], double alpha)
{
    const struct scene_paints *paints = &target->scene->paints;
    const struct bdf_font *font = &paints->fonts[paint->font];
    int pen = (int)floor(paint->number[0] / 65536.0 + 0.5);
    int baseline = (int)floor(paint->number[1] / 65536.0 + 0.5);

    for (const char *at = paints->texts[paint->text]; *at != '\0';) {
        uint32_t character;
        at = take_character(at, &character);
        const struct bdf_glyph *glyph = bdf_find(font, character);
        paint_glyph(target, font, glyph, pen, baseline, color, alpha);
        pen += glyph->advance;
    }
}

/* ---- Pictures ---- */

static void paint_texel(struct ref_target *target, const struct scene_paint *paint, int x, int y,
                        double u, double v, double alpha)
{
    const struct picture *image = &target->scene->paints.images[paint->image];

    if (!(u >= 0 && u < image->width && v >= 0 && v < image->height))
        return;
    const uint8_t *rgb = &image->rgb[3 * ((size_t)v * (size_t)image->width + (size_t)u)];
    if (paint->has_key != 0 && rgb[0] == paint->key[0] && rgb[1] == paint->key[1] &&
        rgb[2] == paint->key[2])
        return;
    double color[3] = {rgb[0], rgb[1], rgb[2]};
    mix(target, x, y, color, alpha, false);
}

static void paint_image(struct ref_target *target, const struct scene_paint *paint, double alpha)
{
    const struct picture *image = &target->scene->paints.images[paint->image];
    double n[4];

    for (int i = 0; i < 4; i++)
        n[i] = (double)paint->number[i] / 65536.0;
    double angle = paint->count == 4 ? n[2] * PI / 180 : 0;
    double c = cos(angle);
    double s = sin(angle);
    for (int y = 0; y < target->image->height; y++) {
        for (int x = 0; x < target->image->width; x++) {
            double dx = x + 0.5 - (paint->count == 4 ? n[0] : floor(n[0] + 0.5));
            double dy = y + 0.5 - (paint->count == 4 ? n[1] : floor(n[1] + 0.5));
            double u = dx;
            double v = dy;
            if (paint->count == 4) {
                u = image->width / 2.0 + (c * dx + s * dy) / n[3];
                v = image->height / 2.0 + (c * dy - s * dx) / n[3];
            }
            paint_texel(target, paint, x, y, u, v, alpha);
        }
    }
}

void ref_paint(struct ref_target *target, const struct scene_paint *paint)
{
    double alpha = (double)paint->alpha / 65536.0;
    double color[3];

    for (int c = 0; c < 3; c++)
        color[c] = 255.0 * (double)paint->color[c] / 65536.0;
    if (paint->kind == SCENE_PAINT_TEXT)
        paint_text(target, paint, color, alpha);
    else if (paint->kind == SCENE_PAINT_IMAGE)
        paint_image(target, paint, alpha);
    else
        paint_shape(target, paint, color, alpha);
}
