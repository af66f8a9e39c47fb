/* SPDX-License-Identifier: MIT */
#ifndef QTRI_TESTS_ESP_GPIO_H
#define QTRI_TESTS_ESP_GPIO_H

#include <stdint.h>

typedef int esp_err_t;
#define ESP_OK 0

typedef int gpio_num_t;
typedef enum { GPIO_MODE_DISABLE = 0, GPIO_MODE_INPUT = 1, GPIO_MODE_OUTPUT = 2 } gpio_mode_t;

esp_err_t gpio_set_direction(gpio_num_t gpio_num, gpio_mode_t mode);
esp_err_t gpio_set_level(gpio_num_t gpio_num, uint32_t level);

#endif
