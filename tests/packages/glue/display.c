/* SPDX-License-Identifier: MIT */
#include "display.h"

#include <panels/controllers.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 320, HEIGHT = 240, FRAMES = 3, LEAST_DRAWN = 5000 };

static struct {
    lcd chip;
    bool is_data, is_begun;
    const uint8_t *sending;
    uint8_t sent[WIDTH * HEIGHT * 2];
    size_t sending_bytes;
    unsigned long bytes;               /* of pixels */
    uint8_t shown[WIDTH * HEIGHT * 2]; /* of windows */
    int x, y, left, right, bottom;
} display;

void glue_stop(int status, const char *why)
{
    printf("%s\n", why);
    exit(status);
}

static void end_if(unsigned long drawn)
{
    glue_stop(drawn > LEAST_DRAWN ? 0 : 1, "three frames");
}

static lcd *begun(void)
{
    if (!display.is_begun) {
        ili9341_init(&display.chip);
        display.is_begun = true;
    }
    return &display.chip;
}

static void end_of_frames(void)
{
    unsigned long drawn = 0;
    if (begun()->chip.error[0] != '\0') {
        glue_stop(1, begun()->chip.error);
    }
    for (int y = 0; y < WIDTH; y++) {
        for (int x = 0; x < HEIGHT; x++) {
            drawn += chip_pixel(&begun()->chip, x, y) != chip_pixel(&begun()->chip, 0, 0);
        }
    }
    end_if(drawn);
}

static void be_still(void)
{
    if (display.sending != NULL) {
        glue_stop(1, "something happens while DMA runs");
    }
}

void glue_data_pin(bool is_data)
{
    be_still();
    display.is_data = is_data;
}

void glue_reset_pin(bool is_low)
{
    be_still();
    chip_reset_pin(&begun()->chip, is_low);
}

void glue_wait(uint32_t ms)
{
    chip_wait(&begun()->chip, ms);
}

static void take(const uint8_t *bytes, size_t count)
{
    chip_send(&begun()->chip, display.is_data, bytes, count);
    display.bytes += display.is_data && begun()->chip.expected == CHIP_STREAM ? count : 0;
    if (display.bytes >=
        (FRAMES + 1ul) * WIDTH * HEIGHT * 2) { /* the black of the beginning is one */
        end_of_frames();
    }
}

void glue_send(const void *bytes, size_t count)
{
    be_still();
    take((const uint8_t *)bytes, count);
}

void glue_start(const void *bytes, size_t count)
{
    be_still();
    if (count > sizeof display.sent || !display.is_data) {
        glue_stop(1, "DMA sends what is no picture");
    }
    display.sending = (const uint8_t *)bytes;
    display.sending_bytes = count;
    memcpy(display.sent, bytes, count);
}

bool glue_is_sending(void)
{
    return display.sending != NULL;
}

void glue_finish(void)
{
    if (display.sending == NULL) {
        glue_stop(1, "nothing is being sent");
    }
    if (memcmp(display.sending, display.sent, display.sending_bytes) != 0) {
        glue_stop(1, "bytes changed while DMA sent them");
    }
    display.sending = NULL;
    take(display.sent, display.sending_bytes);
}

void glue_window(int x, int y, int width, int height)
{
    if (x < 0 || y < 0 || width < 1 || height < 1 || x + width > WIDTH || y + height > HEIGHT) {
        glue_stop(1, "a window beyond the display");
    }
    display.x = display.left = x;
    display.y = y;
    display.right = x + width;
    display.bottom = y + height;
}

void glue_pixels(const void *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (display.y >= display.bottom) {
            glue_stop(1, "more pixels than the window has");
        }
        memcpy(&display.shown[2 * (display.y * WIDTH + display.x)], (const char *)bytes + 2 * i, 2);
        display.x++;
        if (display.x == display.right) {
            display.x = display.left;
            display.y++;
        }
    }
    display.bytes += 2 * count;
    if (display.bytes >= (FRAMES + 1ul) * WIDTH * HEIGHT * 2) {
        unsigned long drawn = 0;
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            drawn += memcmp(&display.shown[2 * i], display.shown, 2) != 0;
        }
        end_if(drawn);
    }
}
