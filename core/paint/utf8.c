/* SPDX-License-Identifier: MIT */
#include "qtri/font.h"
#include "qtri/error.h"

/* A first byte 110xxxxx, 1110xxxx or 11110xxx tells how many bytes 10xxxxxx follow. */
static int32_t following(uint32_t first)
{
    return first >= 0xF8 || first < 0xC0 ? -1 : (first >= 0xF0 ? 3 : (first >= 0xE0 ? 2 : 1));
}

uint32_t qtri_text_next(const char **text)
{
    QTRI_ASSERT(text != NULL && *text != NULL);
    static const uint32_t least[4] = {0, 0x80, 0x800, 0x10000};
    const uint32_t wrong = 0xFFFD;
    const char *at = *text;
    const uint32_t first = (uint8_t)*at;
    if (first < 0x80) {
        *text = at + (first != 0);
        return first;
    }
    *text = at + 1;
    const int32_t count = following(first);
    if (count < 0) {
        return wrong;
    }
    uint32_t character = first & (0x3Fu >> count);
    for (int32_t i = 1; i <= count; i++) { /* a zero ends it: it does not follow */
        const uint32_t next = (uint8_t)at[i];
        if ((next & 0xC0) != 0x80) {
            return wrong;
        }
        character = character << 6 | (next & 0x3F);
    }
    if (character < least[count] || character > 0x10FFFF || (character >> 11) == 0x1B) {
        return wrong;
    }
    *text = at + 1 + count;
    return character;
}
