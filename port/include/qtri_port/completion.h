/* SPDX-License-Identifier: MIT */
/*
 * A call when everything that was sent has left: to wake a task, to switch a supply off, to hand
 * memory on. The panel itself needs none: it waits before it sends again.
 *
 *     static qtri_completion completion;
 *     qtri_panel_init(&panel, &qtri_ili9341, qtri_completion_init(&completion, &spi, done, task),
 * ...);
 *
 *     void DMA_IRQHandler(void)
 *     {
 *         qtri_completion_sent(&completion);
 *     }
 *
 *     qtri_panel_write(&panel, &band);
 *     qtri_completion_notify(&completion); -- done(task) comes once, when the band has left
 *
 * It stands between panel and bus, so who does not use it has none of it. For one core, on which an
 * interrupt runs to its end before what it has interrupted goes on.
 */
#ifndef QTRI_PORT_COMPLETION_H
#define QTRI_PORT_COMPLETION_H

#include "bus.h"

#ifdef __cplusplus
extern "C" {
#endif

/* In the caller's memory, as long as the panel; to be read only. */
typedef struct qtri_completion {
    const qtri_bus *to;
    void (*done)(void *context);
    void *context;
    qtri_bus bus;              /* the panel's */
    volatile uint32_t started; /* transfers; written outside of interrupts alone */
    volatile uint32_t sent;    /* written by qtri_completion_sent alone */
    volatile uint32_t awaited;
    volatile bool is_asked;
} qtri_completion;

/* Fills in *completion and returns its bus, which sends by `to`: both live as long as the panel. */
const qtri_bus *qtri_completion_init(qtri_completion *completion, const qtri_bus *to,
                                     void (*done)(void *context), void *context);

/* For the interrupt: a transfer that data_start has begun is over. Once for each. */
void qtri_completion_sent(qtri_completion *completion);

/*
 * Asks for one call of `done` when all transfers that were started until now are over: from
 * qtri_completion_sent, or from here if they are, as always on buses without data_start. Asking
 * again before the call came moves it to the transfers that were started since.
 */
void qtri_completion_notify(qtri_completion *completion);

#ifdef __cplusplus
}
#endif

#endif
