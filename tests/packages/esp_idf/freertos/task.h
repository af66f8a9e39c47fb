/* SPDX-License-Identifier: MIT */
#ifndef QTRI_TESTS_FREERTOS_TASK_H
#define QTRI_TESTS_FREERTOS_TASK_H

#include "FreeRTOS.h"

void vTaskDelay(TickType_t ticks);

#endif
