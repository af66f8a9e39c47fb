/* SPDX-License-Identifier: MIT */
#include "oled.h"

void oled_reset(chip *it, oled_drive *drive)
{
    const oled_drive fresh = {.multiplex = 63, .pins = 0x12};
    *drive = fresh;
    it->ready_ms = it->now_ms + 100;
}

/* Commands whose last bit is what they set; false: none of them. */
static bool set_switch(oled_drive *drive, uint8_t command)
{
    const bool on = (command & 1) != 0;
    switch (command & ~1) {
    case 0xA0: /* only data that follow are written so: the memory must be written again */
        drive->columns_reversed = on;
        return true;
    case 0xA4:
        drive->all_on = on;
        return true;
    case 0xA6:
        drive->inverse = on;
        return true;
    case 0xAE:
        drive->on = on;
        return true;
    default:
        return false;
    }
}

bool oled_execute(chip *it, oled_drive *drive)
{
    const uint8_t command = it->command, p = it->parameters[0];
    if (set_switch(drive, command)) {
        return true;
    }
    if (command >= 0x40 && command <= 0x7F) {
        drive->start_line = command & 63;
    } else if (command >= 0xC0 && command <= 0xC8) {
        drive->rows_reversed = command == 0xC8;
    } else if (command == 0xD3) {
        chip_allow(it, p <= 63);
        drive->offset = p;
    } else if (command == 0xD9) {
        chip_allow(it, (p & 15) != 0 && p >> 4 != 0);
    } else {
        return false;
    }
    return true;
}

uint32_t oled_pixel(const oled_drive *drive, int rows, int y, const uint8_t *segment, int pitch)
{
    const int com = rows - 1 - y;
    const int line = drive->rows_reversed ? drive->multiplex - com : com;
    const int row = (line + drive->start_line + drive->offset) & 63;
    const bool lit = (segment[(row >> 3) * pitch] >> (row & 7) & 1) != 0;
    return drive->all_on || lit != drive->inverse ? 0xFFFFFF : 0;
}
