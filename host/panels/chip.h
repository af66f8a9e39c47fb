/* SPDX-License-Identifier: MIT */
/*
 * Display controllers, simulated from their data sheets, to test drivers with: bytes go in with the
 * level of D/C, what an eye would see on the glass comes out. Nothing here knows the drivers.
 *
 * A real chip swallows nonsense and shows something; these keep their first complaint instead: an
 * unknown command, a wrong number of parameters or a value out of range, data that no window was
 * set for or that run past its end, a command that comes before the chip is ready.
 */
#ifndef QTRI_HOST_PANELS_CHIP_H
#define QTRI_HOST_PANELS_CHIP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define CHIP_STREAM (-1) /* a command that pixels follow */

/* Commands first..last take this many parameters. */
typedef struct chip_command {
    uint8_t first, last;
    int16_t parameters;
} chip_command;

/* Where data go. Both ends are part of it. */
typedef struct chip_window {
    int x0, x1, y0, y1; /* x0 > x1 or y0 > y1 where addresses count down */
    int x, y;
    bool set, full;
} chip_window;

typedef struct chip chip;

/* What differs between controllers. */
typedef struct chip_model {
    const char *name;
    const chip_command *commands;
    size_t command_count;
    bool parameters_are_data;                        /* D/C high for parameters */
    void (*reset)(chip *it);                         /* to the values of reset */
    void (*execute)(chip *it);                       /* command and parameters are complete */
    void (*store)(chip *it, uint8_t byte);           /* a byte of pixels */
    uint32_t (*pixel)(const chip *it, int x, int y); /* seen: 0x00RRGGBB */
} chip_model;

/* A model of the file that has `commands` and these four functions. */
#define CHIP_MODEL(name, commands, parameters_are_data)                                            \
    {                                                                                              \
        (name), (commands), sizeof(commands) / sizeof(commands)[0], (parameters_are_data), reset,  \
            execute, store, pixel                                                                  \
    }

struct chip {
    const chip_model *model;
    char error[160]; /* the first complaint, or "" */

    uint64_t now_ms, ready_ms; /* commands may come from ready_ms on */
    bool in_reset, started;    /* the reset pin; started: it has been released once */
    bool busy_pin;             /* the chip has a BUSY pin, waits end when it falls */

    uint8_t command;
    uint8_t parameters[160];
    int count, expected; /* of parameters; CHIP_STREAM: pixels */

    chip_window window;
};

void chip_init(chip *it, const chip_model *model);
void chip_wait(chip *it, uint32_t ms);
void chip_reset_pin(chip *it, bool active);
bool chip_busy(const chip *it);

/* Bytes on a 4-wire SPI bus. */
void chip_send(chip *it, bool is_data, const uint8_t *bytes, size_t count);

/* What follows the address in an I2C transfer to one of Solomon's OLED controllers. */
void chip_i2c(chip *it, const uint8_t *bytes, size_t count);

/* What is seen at a pixel of the glass, 0x00RRGGBB. */
uint32_t chip_pixel(const chip *it, int x, int y);

/* For the models: a complaint, kept if it is the first. */
void chip_reject(chip *it, const char *format, ...);

/* A complaint about the command's parameter, unless it is allowed. */
void chip_allow(chip *it, bool allowed);

/* A complaint unless first..last lies in 0..most and is in order. */
void chip_allow_range(chip *it, int first, int last, int most);

/* Data go to these columns and rows, from (at_x, at_y) on. */
void chip_open_window(chip *it, const int x[2], const int y[2], int at_x, int at_y);

/* The window's next address; complains about what lies behind the last. vertical: down first. */
void chip_advance(chip *it, bool vertical);

#endif
