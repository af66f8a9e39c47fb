/* SPDX-License-Identifier: MIT */
#include "qtri/format.h"

#include "barrier.h"

#define PUT(pixel, i, stored) (pixel)[i] = (PIXEL)(stored);
#define GET(pixel)            (pixel)[0]
#define UNITS                 1

#define NAME(name) name##_8
#define PIXEL      uint8_t
#include "pixels.inc"
const qtri_pixels qtri_pixels_8 = {1, load_8, fill_8, store_8};

#define NAME(name) name##_16
#define PIXEL      uint16_t
#include "pixels.inc"
const qtri_pixels qtri_pixels_16 = {2, load_16, fill_16, store_16};

#define NAME(name) name##_32
#define PIXEL      uint32_t
#include "pixels.inc"
const qtri_pixels qtri_pixels_32 = {4, load_32, fill_32, store_32};

#undef PUT
#undef GET
#undef UNITS
#define PUT(pixel, i, stored)                                                                      \
    {                                                                                              \
        const uint32_t put = (stored);                                                             \
        (pixel)[3 * (i)] = (uint8_t)put;                                                           \
        (pixel)[3 * (i) + 1] = (uint8_t)(put >> 8);                                                \
        (pixel)[3 * (i) + 2] = (uint8_t)(put >> 16);                                               \
    }
#define GET(pixel) ((pixel)[0] | (uint32_t)(pixel)[1] << 8 | (uint32_t)(pixel)[2] << 16)
#define UNITS      3

#define NAME(name) name##_24
#define PIXEL      uint8_t
#include "pixels.inc"
const qtri_pixels qtri_pixels_24 = {3, load_24, fill_24, store_24};
