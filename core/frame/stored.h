/* SPDX-License-Identifier: MIT */
/*
 * Stored pixels of a size that a loop knows. Internal.
 */
#ifndef QTRI_FRAME_STORED_H
#define QTRI_FRAME_STORED_H

#include <stdint.h>

#include "../bits/bits.h"

/* A pixel of 1 to 4 bytes. */
QTRI_INLINE uint32_t qtri_stored_get(int32_t bytes, const uint8_t *at)
{
    switch (bytes) {
    case 1:
        return at[0];
    case 2:
        return *(const uint16_t *)(const void *)at;
    case 3:
        return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16;
    default:
        return *(const uint32_t *)(const void *)at;
    }
}

QTRI_INLINE void qtri_stored_put(int32_t bytes, uint8_t *at, uint32_t stored)
{
    switch (bytes) {
    case 1:
        at[0] = (uint8_t)stored;
        break;
    case 2:
        *(uint16_t *)(void *)at = (uint16_t)stored;
        break;
    case 3:
        at[0] = (uint8_t)stored;
        at[1] = (uint8_t)(stored >> 8);
        at[2] = (uint8_t)(stored >> 16);
        break;
    default:
        *(uint32_t *)(void *)at = stored;
        break;
    }
}

#endif
