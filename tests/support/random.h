/* SPDX-License-Identifier: MIT */
/*
 * What tests and firmware share: random numbers that are the same everywhere, and what a surface
 * holds. Nothing of a C library but memcpy.
 */
#ifndef QTRI_TESTS_SUPPORT_RANDOM_H
#define QTRI_TESTS_SUPPORT_RANDOM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <qtri.h>

#define LENGTH_OF(array) (sizeof(array) / sizeof((array)[0]))

/* splitmix64 (Steele, Lea and Flood 2014). */
static inline uint64_t random64(uint64_t *state)
{
    uint64_t z = (*state += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

static inline int32_t random_bits32(uint64_t *state)
{
    uint32_t bits = (uint32_t)(random64(state) >> 32);
    int32_t value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* Uniform in low..high. */
static inline int32_t random_in(uint64_t *state, int32_t low, int32_t high)
{
    uint64_t count = (uint64_t)((int64_t)high - low) + 1;
    return (int32_t)(low + (int64_t)((random64(state) >> 16) % count));
}

/* Any magnitude, either sign. */
static inline int32_t random_any(uint64_t *state)
{
    const int32_t bits = random_bits32(state); /* here and elsewhere: one at a time, in order */
    return bits >> random_in(state, 0, 31);
}

static inline bool random_flag(uint64_t *state)
{
    return (random64(state) >> 40 & 1) != 0;
}

/* One of the formats that are drawn on. */
static inline const qtri_format *drawn_format(int32_t n)
{
    static const qtri_format *const formats[7] = {
        &qtri_rgb565, &qtri_xrgb8888, &qtri_gray8,       &qtri_rgb565_swapped,
        &qtri_rgb888, &qtri_bgr888,   &qtri_rgb565_exact};
    return formats[n % 7];
}

static inline uint32_t stored_pixel(const qtri_surface *s, int32_t x, int32_t y)
{
    const uint8_t *row = s->pixels + (y - s->first_row) * s->pitch;
    uint32_t pixel32;
    uint16_t pixel16;
    switch (s->format->pixels->bytes) {
    case 3:
        return row[3 * x] | (uint32_t)row[3 * x + 1] << 8 | (uint32_t)row[3 * x + 2] << 16;
    case 2:
        memcpy(&pixel16, row + 2 * x, sizeof pixel16);
        return pixel16;
    case 4:
        memcpy(&pixel32, row + 4 * x, sizeof pixel32);
        return pixel32;
    default:
        return row[x];
    }
}

static inline uint16_t stored_depth(const qtri_surface *s, int32_t x, int32_t y)
{
    return s->depth[(y - s->first_row) * s->depth_pitch + x];
}

#endif
