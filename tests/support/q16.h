/* SPDX-License-Identifier: MIT */
/*
 * The arithmetic scalars as a table, so that tests can run them in three builds: as the library has
 * them, as a core without a long multiply and without a division compiles them, and with
 * QTRI_CHECK_MATH and a division of 32 bits only.
 */
#ifndef QTRI_TESTS_SUPPORT_Q16_H
#define QTRI_TESTS_SUPPORT_Q16_H

#include <stdint.h>

#include <qtri/q16.h>

typedef struct q16_build {
    const char *name;
    q16 (*add)(q16 a, q16 b);
    q16 (*sub)(q16 a, q16 b);
    q16 (*neg)(q16 x);
    q16 (*abs)(q16 x);
    q16 (*ceil)(q16 x);
    q16 (*round)(q16 x);
    q16 (*from_int)(int32_t x);
    q16 (*from_fixed)(int32_t value, int fraction_bits);
    int32_t (*to_fixed)(q16 x, int fraction_bits);
    q16 (*add_sat)(q16 a, q16 b);
    q16 (*sub_sat)(q16 a, q16 b);
    q16 (*mul_sat)(q16 a, q16 b);
    q16 (*div_sat)(q16 a, q16 b);
    q16 (*mul)(q16 a, q16 b);
    q16 (*mul_floor)(q16 a, q16 b);
    q16 (*mul_wrap)(q16 a, q16 b);
    q16 (*div)(q16 a, q16 b);
    q16 (*from_ratio)(int32_t a, int32_t b);
    q16 (*mod)(q16 a, q16 b);
    q16 (*hypot)(q16 a, q16 b);
    q16 (*muldiv)(q16 a, q16 b, q16 c);
    q16 (*lerp)(q16 a, q16 b, q16 t);
    q16 (*recip)(q16 x);
    q16 (*sqrt)(q16 x);
    q16 (*rsqrt)(q16 x);
    uint64_t (*mul_high64)(uint64_t a, uint64_t b);
    uint32_t (*sqrt64_floor)(uint64_t x, uint64_t *remainder);
    uint64_t (*sqrt64_round)(uint64_t x);
    uint32_t (*reciprocal_q62)(uint32_t x);
    int32_t (*reciprocal_below)(uint32_t x);
    uint64_t (*mul_u32)(uint32_t a, uint32_t b);
    int64_t (*mul_s32)(int32_t a, int32_t b);
    uint32_t (*reciprocal_seed)(uint32_t x);
    uint32_t (*rsqrt_seed)(uint32_t t);
} q16_build;

/* Of the functions that have these names where it stands. */
#define Q16_BUILD(name)                                                                            \
    {                                                                                              \
        name, q16_add, q16_sub, q16_neg, q16_abs, q16_ceil, q16_round, q16_from_int,               \
            q16_from_fixed, q16_to_fixed, q16_add_sat, q16_sub_sat, q16_mul_sat, q16_div_sat,      \
            q16_mul, q16_mul_floor, q16_mul_wrap, q16_div, q16_from_ratio, q16_mod, q16_hypot,     \
            q16_muldiv, q16_lerp, q16_recip, q16_sqrt, q16_rsqrt, qtri_mul_high64,                 \
            qtri_sqrt64_floor, qtri_sqrt64_round, qtri_reciprocal_q62, qtri_reciprocal_below,      \
            qtri_mul_u32, qtri_mul_s32, qtri_reciprocal_seed, qtri_rsqrt_seed                      \
    }

extern const q16_build q16_narrow_build, q16_checked_build;

/* How often q16_checked_build would have stopped. */
extern int q16_checked_faults;
void q16_checked_fault(void);

#endif
