/* SPDX-License-Identifier: MIT */
#include "display.h"

#include <string.h>

#include "example.h"
#include "panels/controllers.h"
#include "qtri_port/framebuffer.h"
#include "qtri_port/ssd0323.h"
#include "qtri_port/ssd1680.h"

enum { LCD_WIDTH = 320, LCD_HEIGHT = 240 };

static struct {
    enum { LCD, OLED, PAPER } display;
    uint16_t framebuffer[LCD_WIDTH * LCD_HEIGHT];
    union {
        chip chip;
        ssd0323 oled;
        ssd1680 paper;
    } sim;
    uint8_t panel_memory[QTRI_SSD1680_BYTES]; /* the OLED needs a row of it */
} simulated;

bool display_choose(const char *name)
{
    static const char *const displays[] = {"lcd", "oled", "paper"};
    for (int i = 0; i < 3; i++) {
        if (strcmp(name, displays[i]) == 0) {
            simulated.display = i == 0 ? LCD : i == 1 ? OLED : PAPER;
            return true;
        }
    }
    return false;
}

const char *display_complaint(void)
{
    const bool complains = simulated.display != LCD && simulated.sim.chip.error[0] != '\0';
    return complains ? simulated.sim.chip.error : NULL;
}

static bool send_command(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    chip_send(&simulated.sim.chip, false, bytes, count);
    return true;
}

static bool send_data(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    chip_send(&simulated.sim.chip, true, bytes, count);
    return true;
}

static void wait_ms(void *context, uint32_t ms)
{
    (void)context;
    chip_wait(&simulated.sim.chip, ms);
}

static void reset(void *context, bool active)
{
    (void)context;
    chip_reset_pin(&simulated.sim.chip, active);
}

static bool busy(void *context)
{
    (void)context;
    return chip_busy(&simulated.sim.chip);
}

enum qtri_error example_display(qtri_panel *panel)
{
    static const qtri_panel_description screen =
        QTRI_FRAMEBUFFER(LCD_WIDTH, LCD_HEIGHT, QTRI_PANEL_RGB565, QTRI_ORDER_NATIVE);
    static const qtri_bus bus = {NULL,    send_command, send_data, NULL, NULL,
                                 wait_ms, reset,        busy,      0};
    if (simulated.display == LCD) {
        return qtri_panel_init(panel, &screen, NULL, QTRI_ROTATE_0, simulated.framebuffer,
                               sizeof simulated.framebuffer);
    }
    if (simulated.display == PAPER) {
        ssd1680_init(&simulated.sim.paper);
        return qtri_panel_init(panel, &qtri_ssd1680_partial, &bus, QTRI_ROTATE_90,
                               simulated.panel_memory, sizeof simulated.panel_memory);
    }
    ssd0323_init(&simulated.sim.oled);
    return qtri_panel_init(panel, &qtri_ssd0323, &bus, QTRI_ROTATE_0, simulated.panel_memory,
                           QTRI_SSD0323_ROW_BYTES);
}

/* E-paper is turned clockwise: the frame's upper left corner is the glass's upper right one. */
void display_pixel(int x, int y, unsigned char rgb[3])
{
    uint32_t color = simulated.display == LCD
                         ? qtri_decode_rgb565(simulated.framebuffer[y * LCD_WIDTH + x])
                     : simulated.display == OLED ? chip_pixel(&simulated.sim.chip, x, y)
                                                 : chip_pixel(&simulated.sim.chip, 121 - y, x);
    rgb[0] = (unsigned char)(color >> 16);
    rgb[1] = (unsigned char)(color >> 8);
    rgb[2] = (unsigned char)color;
}
