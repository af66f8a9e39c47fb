/* SPDX-License-Identifier: MIT */
/* The references that table.c chooses from. */
#ifndef QTRI_VERIFY_REFERENCE_H
#define QTRI_VERIFY_REFERENCE_H

#include "verify.h"

/* exact.c: by integers. */
extern const verify_reference verify_neg, verify_abs, verify_floor, verify_ceil, verify_round,
    verify_fract, verify_recip, verify_sqrt, verify_rsqrt;
extern const verify_reference verify_add, verify_sub, verify_mul, verify_mul_floor, verify_div,
    verify_mod, verify_hypot;
extern const verify_reference verify_muldiv, verify_lerp;

/* trigonometry.c, exponential.c: in double with MPFR as the judge. */
extern const verify_reference verify_sin, verify_cos, verify_tan;
extern const verify_reference verify_sin_deg, verify_cos_deg, verify_tan_deg;
extern const verify_reference verify_asin, verify_acos, verify_atan, verify_atan2;
extern const verify_reference verify_asin_deg, verify_acos_deg, verify_atan_deg, verify_atan2_deg;
extern const verify_reference verify_exp, verify_exp2, verify_log, verify_log2, verify_pow;

#endif
