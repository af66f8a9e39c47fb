/* SPDX-License-Identifier: MIT */
#ifndef QTRI_TESTS_ZEPHYR_GPIO_H
#define QTRI_TESTS_ZEPHYR_GPIO_H

#include <zephyr/device.h>

typedef uint8_t gpio_pin_t;
typedef uint16_t gpio_dt_flags_t;
typedef uint32_t gpio_flags_t;

#define GPIO_ACTIVE_LOW      (1u << 0)
#define GPIO_OUTPUT_INACTIVE (1u << 17 | 1u << 18)
#define GPIO_OUTPUT_ACTIVE   (1u << 17 | 1u << 19)

struct gpio_dt_spec {
    const struct device *port;
    gpio_pin_t pin;
    gpio_dt_flags_t dt_flags;
};

#define GPIO_DT_SPEC_GET(node, property) STAND_IN_GPIO(node, property)
#define STAND_IN_GPIO(node, property)    STAND_IN_##node##_##property
#define STAND_IN_zephyr_user_dc_gpios                                                              \
    {                                                                                              \
        &stand_in_gpio, 20, 0                                                                      \
    }
#define STAND_IN_zephyr_user_reset_gpios                                                           \
    {                                                                                              \
        &stand_in_gpio, 21, GPIO_ACTIVE_LOW                                                        \
    }

int gpio_pin_configure_dt(const struct gpio_dt_spec *spec, gpio_flags_t extra_flags);
int gpio_pin_set_dt(const struct gpio_dt_spec *spec, int value);

#endif
