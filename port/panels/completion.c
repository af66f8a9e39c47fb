/* SPDX-License-Identifier: MIT */
#include "qtri_port/completion.h"

#include "qtri/error.h"

#include <stddef.h>

static const qtri_bus *below(const void *context)
{
    return ((const qtri_completion *)context)->to;
}

static bool command(void *context, const uint8_t *bytes, size_t count)
{
    const qtri_bus *to = below(context);
    return to->command(to->context, bytes, count);
}

static bool data(void *context, const uint8_t *bytes, size_t count)
{
    const qtri_bus *to = below(context);
    return to->data(to->context, bytes, count);
}

/* Counted before it begins: its interrupt may come before data_start returns. */
static bool data_start(void *context, const uint8_t *bytes, size_t count)
{
    qtri_completion *completion = (qtri_completion *)context;
    const qtri_bus *to = completion->to;
    completion->started++;
    if (!to->data_start(to->context, bytes, count)) {
        completion->started--;
        return false;
    }
    return true;
}

static bool data_finish(void *context)
{
    const qtri_bus *to = below(context);
    return to->data_finish(to->context);
}

static void wait_ms(void *context, uint32_t ms)
{
    const qtri_bus *to = below(context);
    to->wait_ms(to->context, ms);
}

static void reset(void *context, bool active)
{
    const qtri_bus *to = below(context);
    to->reset(to->context, active);
}

static bool busy(void *context)
{
    const qtri_bus *to = below(context);
    return to->busy(to->context);
}

const qtri_bus *qtri_completion_init(qtri_completion *completion, const qtri_bus *to,
                                     void (*done)(void *context), void *context)
{
    QTRI_ASSERT(completion != NULL);
    QTRI_ASSERT(to != NULL);
    QTRI_ASSERT(done != NULL);
    const qtri_bus bus = {completion,
                          command,
                          data,
                          to->data_start != NULL ? data_start : NULL,
                          to->data_finish != NULL ? data_finish : NULL,
                          wait_ms,
                          to->reset != NULL ? reset : NULL,
                          to->busy != NULL ? busy : NULL,
                          to->most_bytes};
    completion->to = to;
    completion->done = done;
    completion->context = context;
    completion->bus = bus;
    completion->started = completion->sent = completion->awaited = 0;
    completion->is_asked = false;
    return &completion->bus;
}

/* Whoever finds the request takes it away before the call. */
static void tell(qtri_completion *completion)
{
    if (completion->is_asked) {
        completion->is_asked = false;
        completion->done(completion->context);
    }
}

void qtri_completion_sent(qtri_completion *completion)
{
    QTRI_ASSERT(completion != NULL && completion->to != NULL);
    completion->sent++;
    if (completion->sent == completion->awaited) {
        tell(completion);
    }
}

/*
 * The interrupt may come between any two lines. Where it comes behind the request it finds it and
 * tells, and the last line does not; where it comes before, `sent` is up to date by the last line.
 * An interrupt cannot come between the two halves of that one's tell: no transfer is left then.
 */
void qtri_completion_notify(qtri_completion *completion)
{
    QTRI_ASSERT(completion != NULL && completion->to != NULL);
    completion->is_asked = false;
    completion->awaited = completion->started;
    completion->is_asked = true;
    if (completion->sent == completion->awaited) {
        tell(completion);
    }
}
