/* SPDX-License-Identifier: MIT */
/*
 * Pixel formats of surfaces: loads and stores by size, decoding, and the library's formats, each a
 * constant of its own, so that a program links those that it names.
 */
#include "qtri/format.h"

#include "pixel.h"

/* ---- Pixels in memory ---- */

#define NAME(name) name##_8
#define BYTES      1
#include "pixels.inc"
const qtri_pixels qtri_pixels_8 = {1, load_8, fill_8, store_8};

#define NAME(name) name##_16
#define BYTES      2
#include "pixels.inc"
const qtri_pixels qtri_pixels_16 = {2, load_16, fill_16, store_16};

#define NAME(name) name##_24
#define BYTES      3
#include "pixels.inc"
const qtri_pixels qtri_pixels_24 = {3, load_24, fill_24, store_24};

#define NAME(name) name##_32
#define BYTES      4
#include "pixels.inc"
const qtri_pixels qtri_pixels_32 = {4, load_32, fill_32, store_32};

/* ---- Stored pixels as 0x00RRGGBB ---- */

uint32_t qtri_decode_rgb565(uint32_t stored)
{
    return qtri_pixel_565_to_888(stored & 0xFFFF);
}

uint32_t qtri_decode_rgb565_swapped(uint32_t stored)
{
    return qtri_decode_rgb565(qtri_swap_16(stored));
}

uint32_t qtri_decode_rgb888(uint32_t stored)
{
    return qtri_swap_red_blue(stored);
}

uint32_t qtri_decode_xrgb8888(uint32_t stored)
{
    return stored & 0xFFFFFF;
}

uint32_t qtri_decode_gray8(uint32_t stored)
{
    return (stored & 0xFF) * 0x010101u;
}

/* ---- Formats ---- */

const qtri_format qtri_rgb565 = {&qtri_pixels_16, &qtri_colors_565, NULL, qtri_decode_rgb565, NULL,
                                 QTRI_RGB565};

void qtri_encode_rgb565_swapped(uint32_t *color, int32_t count)
{
    QTRI_EACH_WORD(color, count, c, qtri_swap_16(c))
}

const qtri_format qtri_rgb565_swapped = {&qtri_pixels_16,
                                         &qtri_colors_565,
                                         qtri_encode_rgb565_swapped,
                                         qtri_decode_rgb565_swapped,
                                         NULL,
                                         QTRI_RGB565_SWAPPED};

static void encode_rgb565_exact(uint32_t *color, int32_t count)
{
    QTRI_EACH_WORD(color, count, c, qtri_pixel_888_to_565(c))
}

const qtri_format qtri_rgb565_exact = {
    &qtri_pixels_16,  &qtri_colors_888, encode_rgb565_exact, qtri_decode_rgb565, NULL,
    QTRI_RGB565_EXACT};

/* Bytes in the other order: an instruction of Arm's, which the barrier keeps whole. */
static inline uint32_t reversed(uint32_t x)
{
    x = x << 24 | (x & 0xFF00) << 8 | (x >> 8 & 0xFF00) | x >> 24;
    QTRI_BODY_BARRIER(x);
    return x;
}

/* Of three bytes the lowest is first: red. */
void qtri_encode_rgb888(uint32_t *color, int32_t count)
{
    QTRI_EACH_WORD(color, count, c, reversed(c) >> 8)
}

const qtri_format qtri_rgb888 = {
    &qtri_pixels_24, &qtri_colors_888, qtri_encode_rgb888, qtri_decode_rgb888, NULL, QTRI_RGB888};

/* 0x00RRGGBB as it is: of three bytes the lowest is first, blue. */
const qtri_format qtri_bgr888 = {
    &qtri_pixels_24, &qtri_colors_888, NULL, qtri_decode_xrgb8888, NULL, QTRI_BGR888};

const qtri_format qtri_xrgb8888 = {
    &qtri_pixels_32, &qtri_colors_888, NULL, qtri_decode_xrgb8888, NULL, QTRI_XRGB8888};

const qtri_format qtri_gray8 = {&qtri_pixels_8, &qtri_colors_gray, NULL, qtri_decode_gray8,
                                NULL,           QTRI_GRAY8};

/* ---- Depth alone: pixels of no bytes ---- */

#define NAME(name) name##_0
#define BYTES      0
#include "pixels.inc"
static const qtri_pixels no_pixels = {0, load_0, fill_0, store_0};

const qtri_format qtri_depth_only = {&no_pixels, &qtri_colors_gray, NULL, qtri_decode_gray8,
                                     NULL,       QTRI_DEPTH_ONLY};
