/* SPDX-License-Identifier: MIT */
#ifndef QTRI_TESTS_ZEPHYR_KERNEL_H
#define QTRI_TESTS_ZEPHYR_KERNEL_H

#include <zephyr/device.h>

typedef struct {
    int64_t ticks;
} k_timeout_t;
#define K_FOREVER ((k_timeout_t){-1})

struct k_sem {
    unsigned int count, limit;
};
#define K_SEM_DEFINE(name, initial_count, count_limit)                                             \
    struct k_sem name = {initial_count, count_limit}

void k_sem_give(struct k_sem *sem);
int k_sem_take(struct k_sem *sem, k_timeout_t timeout);
int32_t k_msleep(int32_t ms);

#endif
