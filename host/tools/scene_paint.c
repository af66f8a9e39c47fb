/* SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "../io/xalloc.h"
#include "font_build.h"
#include "scene_color.h"
#include "scene_draw.h"

struct scene_painting {
    struct font_build *fonts;
    size_t font_count;
    uint32_t **pixels; /* of the pictures, 0x00RRGGBB */
    size_t image_count;
};

static void create_fonts(struct scene_painting *painting, const struct scene_paints *paints)
{
    painting->font_count = paints->font_count;
    painting->fonts = xcalloc(paints->font_count, sizeof *painting->fonts);
    for (size_t i = 0; i < paints->font_count; i++) {
        font_build_create(&painting->fonts[i], &paints->fonts[i]);
    }
}

static void create_images(struct scene_painting *painting, const struct scene_paints *paints)
{
    painting->image_count = paints->image_count;
    painting->pixels = xcalloc(paints->image_count, sizeof *painting->pixels);
    for (size_t i = 0; i < paints->image_count; i++) {
        const struct picture *image = &paints->images[i];
        const size_t count = (size_t)image->width * (size_t)image->height;
        uint32_t *pixels = xcalloc(count, sizeof *pixels);
        for (size_t j = 0; j < count; j++) {
            const uint8_t *rgb = &image->rgb[3 * j];
            pixels[j] = (uint32_t)rgb[0] << 16 | (uint32_t)rgb[1] << 8 | rgb[2];
        }
        painting->pixels[i] = pixels;
    }
}

void scene_painting_create(struct scene_resources *resources, const struct scene *scene)
{
    resources->painting = xcalloc(1, sizeof *resources->painting);
    create_fonts(resources->painting, &scene->paints);
    create_images(resources->painting, &scene->paints);
}

void scene_painting_free(struct scene_resources *resources)
{
    struct scene_painting *painting = resources->painting;
    if (painting == NULL) {
        return;
    }
    for (size_t i = 0; i < painting->font_count; i++) {
        font_build_free(&painting->fonts[i]);
    }
    for (size_t i = 0; i < painting->image_count; i++) {
        free(painting->pixels[i]);
    }
    free(painting->fonts);
    free(painting->pixels);
    free(painting);
}

/* Q16.16 to 24.8, and to whole pixels. */
static int32_t px(int32_t n)
{
    return (int32_t)(((int64_t)n + 128) >> 8);
}

static int32_t whole(int32_t n)
{
    return (int32_t)(((int64_t)n + 32768) >> 16);
}

/* Twice as large on the surface of 2x2 samples a pixel. */
static int32_t scale_of(const struct scene_resources *resources, const qtri_surface *surface)
{
    return surface->width / resources->scene->width;
}

static int32_t saturated(int64_t n)
{
    return (int32_t)(n > INT32_MAX ? INT32_MAX : n < INT32_MIN ? INT32_MIN : n);
}

static void paint_image(const struct scene_resources *resources, const qtri_surface *surface,
                        const struct scene_paint *paint, uint8_t alpha)
{
    const struct picture *from = &resources->scene->paints.images[paint->image];
    const uint8_t *key = paint->key;
    const int32_t *n = paint->number;
    const qtri_image image = {.pixels = resources->painting->pixels[paint->image],
                              .pitch = (ptrdiff_t)from->width * 4,
                              .format = &qtri_xrgb8888,
                              .width = from->width,
                              .height = from->height,
                              .has_key = paint->has_key != 0,
                              .key = (uint32_t)key[0] << 16 | (uint32_t)key[1] << 8 | key[2]};
    const int32_t scale = scale_of(resources, surface);
    if (paint->count == 2 && scale == 1) {
        qtri_image_blend(surface, &image, whole(n[0]), whole(n[1]), alpha);
        return;
    }
    const int32_t centre[2] = {from->width * 32768, from->height * 32768};
    int32_t at[2];
    for (int i = 0; i < 2; i++) {
        const int64_t upright = (int64_t)whole(n[i]) * 65536 + centre[i];
        at[i] = saturated(scale * (paint->count == 2 ? upright : n[i]));
    }
    const int32_t size = saturated((int64_t)scale * (paint->count == 2 ? Q16_ONE : n[3]));
    qtri_affine affine;
    qtri_affine_place(&affine, centre[0], centre[1], at[0], at[1], size, size,
                      paint->count == 2 ? 0 : n[2]);
    qtri_image_paint_affine(surface, &image, &affine, alpha);
}

/* The pixels of a glyph as squares of `scale` pixels. */
static void paint_glyph(const qtri_surface *surface, const qtri_font *font, const qtri_glyph *glyph,
                        int64_t x, int64_t y, int32_t scale, const qtri_brush *brush)
{
    for (int32_t row = 0; row < glyph->height; row++) {
        for (int32_t column = 0; column < glyph->width; column++) {
            const int32_t pitch = (glyph->width + 7) / 8;
            const uint8_t byte = font->rows[glyph->first + row * pitch + column / 8];
            if ((byte << column % 8 & 128) != 0) {
                const int64_t left = (x + column) * scale * 256;
                const int64_t top = (y + row) * scale * 256;
                const qtri_area square = {saturated(left), saturated(top),
                                          saturated(left + 256 * scale),
                                          saturated(top + 256 * scale)};
                qtri_paint_rect(surface, &square, brush);
            }
        }
    }
}

static void paint_text(const struct scene_resources *resources, const qtri_surface *surface,
                       const struct scene_paint *paint, const qtri_brush *brush)
{
    const qtri_font *font = &resources->painting->fonts[paint->font].font;
    const char *text = resources->scene->paints.texts[paint->text];
    const int32_t scale = scale_of(resources, surface);
    int64_t x = whole(paint->number[0]);
    const int64_t y = whole(paint->number[1]);
    if (scale == 1) {
        qtri_text_paint(surface, font, (int32_t)x, (int32_t)y, text, brush);
        return;
    }
    for (uint32_t character = qtri_text_next(&text); character != 0;
         character = qtri_text_next(&text)) {
        const qtri_glyph *glyph = qtri_font_glyph(font, character);
        paint_glyph(surface, font, glyph, x + glyph->left, y - glyph->top, scale, brush);
        x += glyph->advance;
    }
}

static void paint_shape(const qtri_surface *surface, const struct scene_paint *paint,
                        const qtri_brush *brush, int32_t scale)
{
    int32_t n[SCENE_PAINT_NUMBERS];
    for (int i = 0; i < SCENE_PAINT_NUMBERS; i++) {
        n[i] = px(paint->number[i]) * scale; /* |px| <= 2^23 */
    }
    const qtri_area box = {n[0], n[1], n[2], n[3]};
    const qtri_point from = {n[0], n[1]};
    const qtri_point to = {n[2], n[3]};
    qtri_point point[SCENE_PAINT_NUMBERS / 2];
    switch (paint->kind) {
    case SCENE_PAINT_RECT:
        if (paint->count == 4) {
            qtri_paint_rect(surface, &box, brush);
        } else {
            qtri_paint_rect_outline(surface, &box, n[4], brush);
        }
        break;
    case SCENE_PAINT_ROUNDRECT:
        if (paint->count == 5) {
            qtri_paint_round_rect(surface, &box, n[4], brush);
        } else {
            qtri_paint_round_rect_outline(surface, &box, n[4], n[5], brush);
        }
        break;
    case SCENE_PAINT_CIRCLE:
        if (paint->count == 3) {
            qtri_paint_circle(surface, &from, n[2], brush);
        } else {
            qtri_paint_ring(surface, &from, n[2], n[3], brush);
        }
        break;
    case SCENE_PAINT_ARC:
        qtri_paint_arc(surface, &from, n[2], n[3], paint->number[4], paint->number[5], brush);
        break;
    case SCENE_PAINT_STROKE:
        qtri_paint_stroke(surface, &from, &to, n[4], brush);
        break;
    default:
        for (int i = 0; i < SCENE_PAINT_NUMBERS / 2; i++) {
            const qtri_point p = {n[2 * i], n[2 * i + 1]};
            point[i] = p;
        }
        qtri_paint_polygon(surface, point, paint->count / 2, brush);
        break;
    }
}

void scene_paint(const struct scene_resources *resources, const qtri_surface *surface,
                 const struct scene_paint *paint)
{
    const qtri_brush brush = {scene_rgb(paint->color), scene_byte(paint->alpha),
                              paint->is_smooth ? &qtri_ink_smooth : &qtri_ink_blend};
    switch (paint->kind) {
    case SCENE_PAINT_IMAGE:
        paint_image(resources, surface, paint, brush.alpha);
        break;
    case SCENE_PAINT_TEXT:
        paint_text(resources, surface, paint, &brush);
        break;
    default:
        paint_shape(surface, paint, &brush, scale_of(resources, surface));
        break;
    }
}
