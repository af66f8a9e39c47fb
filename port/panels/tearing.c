/* SPDX-License-Identifier: MIT */
#include "qtri_port/tearing.h"

#include "internal.h"

enum qtri_error qtri_tearing_on(qtri_panel *panel)
{
    QTRI_ASSERT(panel != NULL && panel->description != NULL);
    static const qtri_panel_step on = QTRI_STEP(0x35, 0, 0x00); /* vertical blanking only */
    if (panel->description->window != qtri_panel_mipi_window) {
        return QTRI_ERROR_SIZE;
    }
    return qtri_panel_send(panel, &on, 1);
}

enum qtri_error qtri_tearing_wait(qtri_panel *panel, bool (*is_high)(void *context),
                                  uint32_t most_reads)
{
    QTRI_ASSERT(panel != NULL && panel->description != NULL);
    QTRI_ASSERT(is_high != NULL);
    void *context = panel->bus != NULL ? panel->bus->context : NULL;
    enum qtri_error error = qtri_panel_finish(panel);
    bool was_high = true; /* a pin that is high already does not rise */
    for (uint32_t i = 0; i < most_reads && error == QTRI_OK; i++) {
        bool high = is_high(context);
        if (high && !was_high) {
            return QTRI_OK;
        }
        was_high = high;
    }
    return error == QTRI_OK ? QTRI_ERROR_BUS : error;
}
