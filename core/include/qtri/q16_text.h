/* SPDX-License-Identifier: MIT */
/*
 * Q16.16 numbers as decimal text. No libc, no locale: the decimal sign is '.'.
 */
#ifndef QTRI_Q16_TEXT_H
#define QTRI_Q16_TEXT_H

#include <stddef.h>

#include "error.h"
#include "q16.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Characters that any number needs, with the NUL: "-32767.99998". */
#define QTRI_Q16_TEXT_SIZE 13

/*
 * Reads an optional sign, digits and an optional '.' with digits, at least one digit in all, from
 * the start of the text: "2", "-.5", "+3.", "1.70710678". No blanks before it and no exponent:
 * what follows the number is the caller's to judge. Any number of digits is rounded once, to
 * nearest, halves away from zero.
 *
 * Returns how many characters were read, and stores the number. Text that does not begin with
 * one gives 0 and leaves *out alone. A number beyond the range (-32768.000007..32767.999992 round
 * into it) stores Q16_MIN or Q16_MAX and gives QTRI_ERROR_SIZE.
 */
int32_t q16_from_string(const char *text, q16 *out);

/*
 * Writes the shortest decimal that q16_from_string reads as x again, of those with as many digits
 * the nearest: "0.1", "-1.5", "3", "0.00002". At most five digits behind the point.
 *
 * Returns the length without the NUL. A buffer too small for the text and its NUL gives
 * QTRI_ERROR_MEMORY and holds an empty string, if it has room for that.
 */
int32_t q16_to_string(q16 x, char *buffer, size_t size);

#ifdef __cplusplus
}
#endif

#endif
