/* SPDX-License-Identifier: MIT */
#include "internal.h"

#include <string.h>

static bool turned(const qtri_panel *panel)
{
    return panel->rotation == QTRI_ROTATE_90 || panel->rotation == QTRI_ROTATE_270;
}

int32_t qtri_panel_width(const qtri_panel *panel)
{
    QTRI_ASSERT(panel != NULL && panel->description != NULL);
    return turned(panel) ? panel->description->height : panel->description->width;
}

int32_t qtri_panel_height(const qtri_panel *panel)
{
    QTRI_ASSERT(panel != NULL && panel->description != NULL);
    return turned(panel) ? panel->description->width : panel->description->height;
}

static bool packed(qtri_panel_format format)
{
    return format == QTRI_PANEL_GRAY4 || format == QTRI_PANEL_GRAY1 ||
           format == QTRI_PANEL_GRAY1_PAGE;
}

/* The least memory, or 0 where format and bus do not go together. */
static uint64_t least_bytes(const qtri_panel_description *d)
{
    if (d->partial != NULL && !packed(d->format)) {
        return 0;
    }
    if (d->window != NULL) {
        return d->partial != NULL  ? QTRI_PANEL_IMAGE_BYTES(d->width, d->height, d->format)
               : packed(d->format) ? QTRI_PANEL_ROW_BYTES(d->width, d->format)
               : d->format == QTRI_PANEL_RGB565 ? QTRI_PANEL_LINE_BYTES(1)
               : d->format == QTRI_PANEL_RGB666 ? QTRI_PANEL_LINE_BYTES(2)
                                                : 0;
    }
    if (d->format != QTRI_PANEL_RGB565 && d->format != QTRI_PANEL_XRGB8888) {
        return 0;
    }
    uint32_t row = d->width * (d->format == QTRI_PANEL_RGB565 ? (uint32_t)2 : 4);
    uint32_t pitch = d->pitch != 0 ? d->pitch : row;
    return pitch < row ? 0 : (uint64_t)pitch * (d->height - 1u) + row;
}

/* Pixels, all of them in the controller's memory, the first of packed ones where a byte begins. */
static bool has_glass(const qtri_panel *panel)
{
    const qtri_panel_description *d = panel->description;
    bool pages = d->format == QTRI_PANEL_GRAY1_PAGE;
    int32_t across = d->format == QTRI_PANEL_GRAY4 ? 1 : (d->format == QTRI_PANEL_GRAY1 ? 7 : 0);
    return d->width >= 1 && d->width <= QTRI_SURFACE_MAX && d->height >= 1 &&
           d->height <= QTRI_SURFACE_MAX && panel->column >= 0 && panel->row >= 0 &&
           panel->column + (int32_t)d->width <= d->memory_width &&
           panel->row + (int32_t)d->height <= d->memory_height && (panel->column & across) == 0 &&
           (panel->row & (pages ? 7 : 0)) == 0;
}

/* What the description cannot do for a module. */
static bool can_be(const qtri_panel *panel)
{
    const qtri_panel_description *d = panel->description;
    return (!panel->module.swap_red_blue || d->red_blue_bit != 0) &&
           (!panel->module.invert || d->invert_commands[0] != 0);
}

/* Black in a window, from the panel's memory: as many zeros at a time as that holds. */
static enum qtri_error blank_window(qtri_panel *panel, qtri_rect window)
{
    const qtri_panel_format format = panel->description->format;
    size_t unit = packed(format) ? 1 : format == QTRI_PANEL_RGB666 ? 3 : 2;
    uint32_t left =
        (uint32_t)(window.x1 - window.x0) * (uint32_t)(window.y1 - window.y0) * (uint32_t)unit;
    enum qtri_error error = qtri_panel_open(panel, &window);
    while (left > 0 && error == QTRI_OK) {
        size_t n = panel->bytes < left ? panel->bytes / unit * unit : left;
        memset(panel->memory, 0, n);
        error = qtri_panel_data(panel, panel->memory, n);
        left -= (uint32_t)n;
    }
    return error;
}

/* Black all over. */
static enum qtri_error blank(qtri_panel *panel)
{
    const qtri_panel_description *d = panel->description;
    qtri_rect all = {0, 0, qtri_panel_width(panel), qtri_panel_height(panel)};
    if (packed(d->format)) {
        all.x1 = (int32_t)QTRI_PANEL_ROW_BYTES(d->width, d->format);
        all.y1 = (int32_t)QTRI_PANEL_ROWS(d->height, d->format);
    }
    if (!d->window_is_row) {
        return blank_window(panel, all);
    }
    enum qtri_error error = QTRI_OK;
    for (int32_t y = 0; y < all.y1 && error == QTRI_OK; y++) {
        qtri_rect row = {0, y, all.x1, y + 1};
        error = blank_window(panel, row);
    }
    return error;
}

/* What the description and the module say of how the glass is mounted. */
static enum qtri_error mount(qtri_panel *panel)
{
    const qtri_panel_description *d = panel->description;
    enum qtri_error error = QTRI_OK;
    if (d->orientation_command != 0) {
        error = qtri_panel_command(panel, d->orientation_command, &panel->orientation, 1);
    }
    if (error == QTRI_OK && d->invert_commands[0] != 0) {
        bool on = d->inverted != panel->module.invert;
        error = qtri_panel_command(panel, d->invert_commands[on ? 1 : 0], NULL, 0);
    }
    return error;
}

/* The last command of the sequence, display on, comes when there is something to see. */
static enum qtri_error start(qtri_panel *panel)
{
    const qtri_panel_description *d = panel->description;
    const qtri_bus *bus = panel->bus;
    if (bus == NULL) {
        return QTRI_OK;
    }
    if (bus->reset != NULL) {
        bus->reset(bus->context, true);
        bus->wait_ms(bus->context, d->reset_ms);
        bus->reset(bus->context, false);
    }
    bus->wait_ms(bus->context, d->start_ms);
    size_t last = d->init_count > 0 && d->init != NULL ? d->init_count - 1 : 0;
    enum qtri_error error = qtri_panel_send(panel, d->init, last);
    error = error == QTRI_OK ? mount(panel) : error;
    if (error == QTRI_OK && d->window != NULL && d->refresh == NULL) {
        error = blank(panel);
    }
    if (error == QTRI_OK && d->init_count > 0 && d->init != NULL) {
        error = qtri_panel_send(panel, &d->init[last], 1);
    }
    return error == QTRI_OK ? qtri_panel_finish(panel) : error;
}

static enum qtri_error check(const qtri_panel *panel)
{
    const qtri_panel_description *d = panel->description;
    if ((unsigned)panel->rotation > QTRI_ROTATE_270 || !has_glass(panel) || !can_be(panel) ||
        (d->window != NULL && panel->bus == NULL) || d->write == NULL) {
        return QTRI_ERROR_SIZE;
    }
    uint64_t least = least_bytes(d);
    if (least == 0) {
        return QTRI_ERROR_SIZE;
    }
    return panel->memory == NULL || panel->bytes < least ? QTRI_ERROR_MEMORY : QTRI_OK;
}

#ifdef QTRI_CHECKED
/* What does without a window is memory-mapped, and may be reset by a bus that sends nothing. */
static void check_bus(const qtri_bus *bus, bool sends)
{
    QTRI_ASSERT(bus->command != NULL || !sends);
    QTRI_ASSERT(bus->data != NULL || !sends);
    QTRI_ASSERT(bus->wait_ms != NULL);
    QTRI_ASSERT((bus->data_start == NULL) == (bus->data_finish == NULL));
    QTRI_ASSERT(bus->most_bytes == 0 || (bus->most_bytes >= 16 && bus->most_bytes % 2 == 0));
}

static void check_description(const qtri_panel_description *description)
{
    QTRI_ASSERT((unsigned)description->order <= QTRI_ORDER_NATIVE);
    QTRI_ASSERT(description->partial == NULL || description->partial->refresh != NULL);
    QTRI_ASSERT(description->partial == NULL || description->partial->shown != NULL);
}
#endif

enum qtri_error qtri_panel_init(qtri_panel *panel, const qtri_panel_description *description,
                                const qtri_bus *bus, qtri_rotation rotation, void *memory,
                                size_t bytes)
{
    return qtri_panel_init_module(panel, description, NULL, bus, rotation, memory, bytes);
}

/* Bits of the address mode that a module turns. */
static uint8_t orientation_of(const qtri_panel *panel)
{
    const qtri_module *m = &panel->module;
    const qtri_panel_description *d = panel->description;
    uint8_t bits = d->orientation[(unsigned)panel->rotation & 3];
    return (uint8_t)(bits ^ (m->mirror_rows ? d->rows_bit : 0) ^
                     (m->mirror_columns ? d->columns_bit : 0) ^
                     (m->swap_red_blue ? d->red_blue_bit : 0));
}

enum qtri_error qtri_panel_init_module(qtri_panel *panel, const qtri_panel_description *description,
                                       const qtri_module *module, const qtri_bus *bus,
                                       qtri_rotation rotation, void *memory, size_t bytes)
{
    QTRI_ASSERT(panel != NULL);
    QTRI_ASSERT(description != NULL);
    QTRI_ASSERT(memory != NULL || bytes == 0);
#ifdef QTRI_CHECKED
    check_description(description);
    if (bus != NULL) {
        check_bus(bus, description->window != NULL);
    }
#endif
    /* A panel without pixels: no surface fits it. */
    static const qtri_panel_description nothing = {.width = 0, .height = 0};
    static const qtri_module as_described = {false, false, false, false, 0, 0};
    const qtri_panel fresh = {.description = description,
                              .bus = bus,
                              .rotation = rotation,
                              .memory = (uint8_t *)memory,
                              .bytes = bytes,
                              .dither = QTRI_DITHER_BAYER8};
    *panel = fresh;
    panel->module = module != NULL ? *module : as_described;
    panel->orientation = orientation_of(panel);
    panel->column = description->first_column + (int32_t)panel->module.column;
    panel->row = description->first_row + (int32_t)panel->module.row;
    enum qtri_error error = check(panel);
    if (error != QTRI_OK) {
        const qtri_panel unusable = {.description = &nothing, .dither = QTRI_DITHER_BAYER8};
        *panel = unusable;
        return error;
    }
    if (packed(description->format)) {
        memset(memory, 0, bytes);
    }
    return start(panel);
}

enum qtri_error qtri_panel_write(qtri_panel *panel, const qtri_surface *surface)
{
    QTRI_ASSERT(surface != NULL);
    qtri_rect frame = {0, 0, surface->width, surface->height};
    return qtri_panel_write_rect(panel, surface, frame);
}

static int32_t greater(int64_t a, int64_t b)
{
    return (int32_t)(a > b ? a : b);
}

static int32_t smaller(int64_t a, int64_t b)
{
    return (int32_t)(a < b ? a : b);
}

enum qtri_error qtri_panel_write_rect(qtri_panel *panel, const qtri_surface *surface,
                                      qtri_rect rect)
{
    QTRI_ASSERT(surface != NULL);
    if (surface->width != qtri_panel_width(panel) || surface->height != qtri_panel_height(panel)) {
        return QTRI_ERROR_SIZE;
    }
    if (surface->format == NULL) {
        return QTRI_ERROR_FORMAT;
    }
    int64_t held_end = (int64_t)surface->first_row + surface->rows;
    rect.x0 = greater(rect.x0, 0);
    rect.x1 = smaller(rect.x1, surface->width);
    rect.y0 = greater(greater(rect.y0, surface->first_row), 0);
    rect.y1 = smaller(smaller(rect.y1, surface->height), held_end);
    if (rect.x1 <= rect.x0 || rect.y1 <= rect.y0) {
        return QTRI_OK;
    }
    enum qtri_error error = qtri_panel_finish(panel);
    return error == QTRI_OK ? panel->description->write(panel, surface, rect) : error;
}

/* Shows it, and tells controllers that compare what they show now. */
static enum qtri_error show(qtri_panel *panel, const qtri_panel_step *steps, size_t count)
{
    const qtri_panel_partial *partial = panel->description->partial;
    enum qtri_error error = qtri_panel_send(panel, steps, count);
    panel->is_shown = false;
    if (partial != NULL && error == QTRI_OK) {
        error = partial->shown(panel);
        error = error == QTRI_OK ? qtri_panel_finish(panel) : error;
        panel->is_shown = error == QTRI_OK;
    }
    return error;
}

enum qtri_error qtri_panel_refresh(qtri_panel *panel)
{
    enum qtri_error error = qtri_panel_finish(panel);
    const qtri_panel_description *d = panel->description;
    return error == QTRI_OK ? show(panel, d->refresh, d->refresh_count) : error;
}

enum qtri_error qtri_panel_refresh_changes(qtri_panel *panel)
{
    QTRI_ASSERT(panel != NULL && panel->description != NULL);
    const qtri_panel_partial *partial = panel->description->partial;
    if (partial == NULL || !panel->is_shown) {
        return qtri_panel_refresh(panel);
    }
    enum qtri_error error = qtri_panel_finish(panel);
    return error == QTRI_OK ? show(panel, partial->refresh, partial->refresh_count) : error;
}
