/* SPDX-License-Identifier: MIT */
/*
 * Stand-ins for what port/examples/glue/zephyr.c calls, declared as Zephyr's documentation
 * describes it (Zephyr API 3.x: "SPI Bus", "GPIO", "Semaphores", "Devicetree API"). Of devicetree
 * there is what the overlay at the top of that file says.
 */
#ifndef QTRI_TESTS_ZEPHYR_DEVICE_H
#define QTRI_TESTS_ZEPHYR_DEVICE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct device {
    const char *name;
};

extern const struct device stand_in_spi, stand_in_gpio;

#define DT_NODELABEL(label) label
#define DT_PATH(node)       node

#endif
