/* SPDX-License-Identifier: MIT */
/*
 * Colours and vectors of scene files as those of the core.
 */
#ifndef QTRI_HOST_TOOLS_SCENE_COLOR_H
#define QTRI_HOST_TOOLS_SCENE_COLOR_H

#include <qtri.h>

/* 0..1 in 8 bits. */
static inline uint8_t scene_byte(int32_t part)
{
    return (uint8_t)((part * 255 + 32768) >> 16);
}

/* The same of red, green and blue. */
static inline qtri_rgb scene_rgb(const int32_t color[3])
{
    const qtri_rgb rgb = {scene_byte(color[0]), scene_byte(color[1]), scene_byte(color[2])};
    return rgb;
}

static inline qtri_vec3 scene_vec3(const int32_t v[3])
{
    const qtri_vec3 vec = {v[0], v[1], v[2]};
    return vec;
}

#endif
