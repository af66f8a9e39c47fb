/* SPDX-License-Identifier: MIT */
#include "palette.h"

#include <string.h>

enum { SLOTS = 1024 }; /* four for each colour: chains stay short */

bool palette_make(struct palette *palette, const uint8_t *rgb, size_t count, uint8_t *numbers)
{
    int16_t slots[SLOTS] = {0}; /* 1 + a colour's place; linear probing */
    memset(palette, 0, sizeof *palette);
    for (size_t i = 0; i < count; i++, rgb += 3) {
        uint32_t key = (uint32_t)rgb[0] << 16 | (uint32_t)rgb[1] << 8 | rgb[2];
        uint32_t slot = (key * 2654435761u) >> 22; /* Knuth's multiplicative hash */
        while (slots[slot] != 0 && memcmp(palette->color[slots[slot] - 1], rgb, 3) != 0) {
            slot = (slot + 1) % SLOTS;
        }
        if (slots[slot] == 0) {
            if (palette->count == PALETTE_MAX) {
                return false;
            }
            memcpy(palette->color[palette->count], rgb, 3);
            slots[slot] = (int16_t)++palette->count;
        }
        if (numbers != NULL) {
            numbers[i] = (uint8_t)(slots[slot] - 1);
        }
    }
    return true;
}

int palette_find(const struct palette *palette, const uint8_t rgb[3])
{
    for (int i = 0; i < palette->count; i++) {
        if (memcmp(palette->color[i], rgb, 3) == 0) {
            return i;
        }
    }
    return -1;
}
