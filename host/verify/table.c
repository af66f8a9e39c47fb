/* SPDX-License-Identifier: MIT */
#include "table.h"

#include "reference.h"

#include "qtri/q16.h"

#define ONE(f)      f, NULL, NULL
#define TWO(f)      NULL, f, NULL
#define THREE(f)    NULL, NULL, f
#define ALL         Q16_MIN, Q16_MAX, "all"
#define PAIRS       Q16_MIN, Q16_MAX, "all"
#define RISING      1
#define FALLING     (-1)
#define NOWHERE     0
#define NO_RELATIVE 0, 0, NULL

/* From here on, q16 in ULP, the error counts in parts of the result. */
#define TAN_RELATIVE 256 * 65536.0, 0x1p-22, "|tan| >= 256, in 2^-22 of it"
#define POW_RELATIVE 64 * 65536.0, 0x1p-21, "pow >= 64, in 2^-21 of it"

/* clang-format off */
const verify_function verify_functions[] = {
    /* name, function, reference, limit in ULP, domain, monotone, relative limit */
    {"neg",       ONE(q16_neg),       &verify_neg,       0,   ALL,   FALLING, NO_RELATIVE},
    {"abs",       ONE(q16_abs),       &verify_abs,       0,   ALL,   NOWHERE, NO_RELATIVE},
    {"floor",     ONE(q16_floor),     &verify_floor,     0,   ALL,   RISING,  NO_RELATIVE},
    {"ceil",      ONE(q16_ceil),      &verify_ceil,      0,   ALL,   RISING,  NO_RELATIVE},
    {"round",     ONE(q16_round),     &verify_round,     0,   ALL,   RISING,  NO_RELATIVE},
    {"fract",     ONE(q16_fract),     &verify_fract,     0,   ALL,   NOWHERE, NO_RELATIVE},
    {"recip",     ONE(q16_recip),     &verify_recip,     .5,  ALL,   NOWHERE, NO_RELATIVE},
    {"sqrt",      ONE(q16_sqrt),      &verify_sqrt,      .5,  0, Q16_MAX, "x >= 0", RISING, NO_RELATIVE},
    {"rsqrt",     ONE(q16_rsqrt),     &verify_rsqrt,     .5,  1, Q16_MAX, "x > 0", FALLING, NO_RELATIVE},
    {"sin",       ONE(q16_sin),       &verify_sin,       .51, ALL,   NOWHERE, NO_RELATIVE},
    {"cos",       ONE(q16_cos),       &verify_cos,       .51, ALL,   NOWHERE, NO_RELATIVE},
    {"tan",       ONE(q16_tan),       &verify_tan,       .6,  Q16_MIN, Q16_MAX, "|tan| < 256", NOWHERE, TAN_RELATIVE},
    {"sin_deg",   ONE(q16_sin_deg),   &verify_sin_deg,   .51, ALL,   NOWHERE, NO_RELATIVE},
    {"cos_deg",   ONE(q16_cos_deg),   &verify_cos_deg,   .51, ALL,   NOWHERE, NO_RELATIVE},
    {"tan_deg",   ONE(q16_tan_deg),   &verify_tan_deg,   .6,  Q16_MIN, Q16_MAX, "|tan| < 256", NOWHERE, TAN_RELATIVE},
    {"asin",      ONE(q16_asin),      &verify_asin,      .53, -65536, 65536, "|x| <= 1", RISING, NO_RELATIVE},
    {"acos",      ONE(q16_acos),      &verify_acos,      .53, -65536, 65536, "|x| <= 1", FALLING, NO_RELATIVE},
    {"atan",      ONE(q16_atan),      &verify_atan,      .53, ALL,   RISING,  NO_RELATIVE},
    {"asin_deg",  ONE(q16_asin_deg),  &verify_asin_deg,  .53, -65536, 65536, "|x| <= 1", RISING, NO_RELATIVE},
    {"acos_deg",  ONE(q16_acos_deg),  &verify_acos_deg,  .53, -65536, 65536, "|x| <= 1", FALLING, NO_RELATIVE},
    {"atan_deg",  ONE(q16_atan_deg),  &verify_atan_deg,  .53, ALL,   RISING,  NO_RELATIVE},
    {"exp",       ONE(q16_exp),       &verify_exp,       1,   Q16(-12), Q16(11), "-12 <= x <= 11", RISING, NO_RELATIVE},
    {"exp2",      ONE(q16_exp2),      &verify_exp2,      1,   Q16(-18), Q16(15), "-18 <= x <= 15", RISING, NO_RELATIVE},
    {"log",       ONE(q16_log),       &verify_log,       .6,  1, Q16_MAX, "x > 0", RISING, NO_RELATIVE},
    {"log2",      ONE(q16_log2),      &verify_log2,      .6,  1, Q16_MAX, "x > 0", RISING, NO_RELATIVE},
    {"add",       TWO(q16_add),       &verify_add,       0,   PAIRS, NOWHERE, NO_RELATIVE},
    {"sub",       TWO(q16_sub),       &verify_sub,       0,   PAIRS, NOWHERE, NO_RELATIVE},
    {"mul",       TWO(q16_mul),       &verify_mul,       .5,  PAIRS, NOWHERE, NO_RELATIVE},
    {"mul_floor", TWO(q16_mul_floor), &verify_mul_floor, 1,   PAIRS, NOWHERE, NO_RELATIVE},
    {"div",       TWO(q16_div),       &verify_div,       .5,  PAIRS, NOWHERE, NO_RELATIVE},
    {"mod",       TWO(q16_mod),       &verify_mod,       0,   PAIRS, NOWHERE, NO_RELATIVE},
    {"hypot",     TWO(q16_hypot),     &verify_hypot,     .5,  PAIRS, NOWHERE, NO_RELATIVE},
    {"atan2",     TWO(q16_atan2),     &verify_atan2,     .53, PAIRS, NOWHERE, NO_RELATIVE},
    {"atan2_deg", TWO(q16_atan2_deg), &verify_atan2_deg, .53, PAIRS, NOWHERE, NO_RELATIVE},
    {"pow",       TWO(q16_pow),       &verify_pow,       .52,   Q16_MIN, Q16_MAX, "pow < 64", NOWHERE, POW_RELATIVE},
    {"muldiv",    THREE(q16_muldiv),  &verify_muldiv,    .5,  PAIRS, NOWHERE, NO_RELATIVE},
    {"lerp",      THREE(q16_lerp),    &verify_lerp,      .5,  PAIRS, NOWHERE, NO_RELATIVE},
};
/* clang-format on */

const size_t verify_function_count = sizeof verify_functions / sizeof verify_functions[0];
