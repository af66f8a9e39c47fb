/* SPDX-License-Identifier: MIT */
#include "bench_paint.h"

static const qtri_rgb color = {255, 128, 64};

static qtri_brush brush_of(const qtri_ink *ink, uint8_t alpha)
{
    const qtri_brush brush = {color, alpha, ink};
    return brush;
}

static void rect(bench_frame *frame, const qtri_brush *brush)
{
    const qtri_area area = {QTRI_PX(9), QTRI_PX(20), QTRI_PX(309), QTRI_PX(220)};
    qtri_paint_rect(&frame->surface, &area, brush);
}

void bench_paint_rect(bench_frame *frame)
{
    const qtri_brush brush = brush_of(NULL, 255);
    rect(frame, &brush);
}

void bench_paint_rects(bench_frame *frame)
{
    const qtri_brush brush = brush_of(NULL, 255);
    for (int32_t i = 0; i < 800; i++) {
        const int32_t x = 12 * (i % 25) + (i / 25) % 3;
        const int32_t y = 7 * (i / 25);
        const qtri_area area = {QTRI_PX(x), QTRI_PX(y), QTRI_PX(x + 11), QTRI_PX(y + 7)};
        qtri_paint_rect(&frame->surface, &area, &brush);
    }
}

void bench_paint_alpha(bench_frame *frame)
{
    const qtri_brush brush = brush_of(&qtri_ink_blend, 100);
    rect(frame, &brush);
}

static qtri_image image_of(const bench_frame *frame)
{
    const qtri_image image = {.pixels = frame->texels,
                              .pitch = 2 * BENCH_TEXTURE_SIDE,
                              .format = &qtri_rgb565,
                              .width = BENCH_TEXTURE_SIDE < 100 ? BENCH_TEXTURE_SIDE : 100,
                              .height = BENCH_TEXTURE_SIDE < 100 ? BENCH_TEXTURE_SIDE : 100};
    return image;
}

static void four(bench_frame *frame, const qtri_image *image)
{
    for (int32_t i = 0; i < 4; i++) {
        qtri_image_paint(&frame->surface, image, 130 * (i & 1) + i, 110 * (i >> 1) + i);
    }
}

void bench_paint_copy(bench_frame *frame)
{
    const qtri_image image = image_of(frame);
    four(frame, &image);
}

void bench_paint_keyed(bench_frame *frame)
{
    qtri_image image = image_of(frame);
    image.has_key = true;
    image.key = bench_rgb565(bench_background);
    for (uint32_t i = 0; i < BENCH_TEXTURE_SIDE * BENCH_TEXTURE_SIDE; i += 8) {
        frame->texels[i] = (uint16_t)image.key;
    }
    four(frame, &image);
}

void bench_paint_turned(bench_frame *frame)
{
    const qtri_image image = image_of(frame);
    qtri_affine affine;
    qtri_affine_place(&affine, Q16(50), Q16(50), Q16(160), Q16(120), Q16(1.5), Q16(1.5), Q16(30));
    qtri_image_paint_affine(&frame->surface, &image, &affine, 255);
}

static void circle(bench_frame *frame, const qtri_ink *ink)
{
    const qtri_point center = {QTRI_PX(160.3), QTRI_PX(120.7)};
    const qtri_brush brush = brush_of(ink, 255);
    qtri_paint_circle(&frame->surface, &center, QTRI_PX(100), &brush);
}

void bench_paint_circle(bench_frame *frame)
{
    circle(frame, NULL);
}

void bench_paint_smooth(bench_frame *frame)
{
    circle(frame, &qtri_ink_smooth);
}

void bench_paint_polygon(bench_frame *frame)
{
    static const qtri_point star[12] = {
        {QTRI_PX(160), QTRI_PX(12)},  {QTRI_PX(185), QTRI_PX(77)},  {QTRI_PX(253), QTRI_PX(66)},
        {QTRI_PX(210), QTRI_PX(120)}, {QTRI_PX(253), QTRI_PX(174)}, {QTRI_PX(185), QTRI_PX(163)},
        {QTRI_PX(160), QTRI_PX(228)}, {QTRI_PX(135), QTRI_PX(163)}, {QTRI_PX(67), QTRI_PX(174)},
        {QTRI_PX(110), QTRI_PX(120)}, {QTRI_PX(67), QTRI_PX(66)},   {QTRI_PX(135), QTRI_PX(77)}};
    const qtri_brush brush = brush_of(&qtri_ink_smooth, 255);
    qtri_paint_polygon(&frame->surface, star, 12, &brush);
}

/* Two letters of 8 x 16, the small font's A and g drawn twice as high. */
static const uint8_t rows[] = {0x00, 0x18, 0x3C, 0x3C, 0x66, 0x66, 0xC3, 0xC3, 0xFF, 0xFF, 0xC3,
                               0xC3, 0xC3, 0xC3, 0xC3, 0x00, 0x00, 0x00, 0x00, 0x00, 0x3E, 0x7E,
                               0xE6, 0xC6, 0xC6, 0xE6, 0x7E, 0x3E, 0x06, 0x86, 0xFE, 0x7C};
static const qtri_glyph glyphs[] = {{0, 8, 16, 0, 12, 9}, {16, 8, 16, 0, 12, 9}};
static const qtri_glyph_range ranges[] = {{'A', 2, 0}};
static const qtri_font font = {rows, glyphs, ranges, 1, 0, 12, 4};

void bench_paint_text(bench_frame *frame)
{
    const qtri_brush brush = brush_of(NULL, 255);
    for (int32_t i = 0; i < 10; i++) {
        qtri_text_paint(&frame->surface, &font, 3 + i, 16 + 20 * i,
                        "ABABBAAABBABABABBAABABABABABABBA", &brush);
    }
}
