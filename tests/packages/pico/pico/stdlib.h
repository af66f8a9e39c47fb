/* SPDX-License-Identifier: MIT */
/*
 * Stand-ins for what port/examples/glue/pico.c calls of the Pico SDK, declared as its headers of
 * the same names do (raspberrypi/pico-sdk 1.5, src/rp2_common/hardware_gpio, _spi and _dma).
 */
#ifndef QTRI_TESTS_PICO_STDLIB_H
#define QTRI_TESTS_PICO_STDLIB_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef unsigned int uint;

enum gpio_function { GPIO_FUNC_SPI = 1 };
#define GPIO_OUT 1

void gpio_init(uint gpio);
void gpio_put(uint gpio, bool value);
void gpio_set_dir(uint gpio, bool out);
void gpio_set_function(uint gpio, enum gpio_function fn);
void sleep_ms(uint32_t ms);

#endif
