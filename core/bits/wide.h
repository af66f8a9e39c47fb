/* SPDX-License-Identifier: MIT */
/*
 * Wide scalars, in which builders of transforms work: a 62-bit mantissa and an exponent. Exponents
 * are held within +-QTRI_WIDE_EXPONENT_MAX: smaller numbers become 0, larger ones stay at the
 * limit. Results are truncated, relative error below 2^-59. Internal.
 */
#ifndef QTRI_BITS_WIDE_H
#define QTRI_BITS_WIDE_H

#include <stdbool.h>
#include <stdint.h>

#define QTRI_WIDE_EXPONENT_MAX 2048

/* m 2^-e, with 2^61 <= |m| < 2^62, or m = 0 and e = 0. */
typedef struct qtri_wide {
    int64_t m;
    int32_t e;
} qtri_wide;

/* x = m 2^-e for any m and e; and as a value. */
void qtri_wide_set(qtri_wide *x, int64_t m, int32_t e);
qtri_wide qtri_wide_make(int64_t m, int32_t e);

/* The least exponent of those that are not 0, the longest one's; INT32_MAX if all are 0. */
int32_t qtri_wide_least(const qtri_wide *v, int count);

/*
 * a += b, a *= b, a /= b; b may be a. a / 0 is the largest magnitude with the sign of a; 0 / 0 is
 * 0.
 */
void qtri_wide_add_to(qtri_wide *a, const qtri_wide *b);
void qtri_wide_mul_by(qtri_wide *a, const qtri_wide *b);
void qtri_wide_div_by(qtri_wide *a, const qtri_wide *b);

/* sum += a b, or sum -= a b. */
void qtri_wide_add_product(qtri_wide *sum, const qtri_wide *a, const qtri_wide *b);
void qtri_wide_sub_product(qtri_wide *sum, const qtri_wide *a, const qtri_wide *b);

/* a < 0 gives 0. */
qtri_wide qtri_wide_sqrt(qtri_wide a);

/* a b / 2^62, truncated, for |a|, |b| < 2^63. */
int64_t qtri_mul_q62(int64_t a, int64_t b);

/*
 * v / |v|: a direction of the longest component's 60 bits, absolute error below 2^-58. False, and
 * nothing is set, for the zero vector.
 */
bool qtri_wide_unit_q62(int64_t unit_q62[3], const qtri_wide v[3]);
bool qtri_wide_normalize(qtri_wide v[3]);
void qtri_wide_cross(qtri_wide out[3], const qtri_wide a[3], const qtri_wide b[3]);
qtri_wide qtri_wide_inner(const qtri_wide a[3], const qtri_wide b[3]);

#endif
