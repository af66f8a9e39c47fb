/* SPDX-License-Identifier: MIT */
/*
 * The generator of core/math/coefficients.h.
 */
#ifndef GENERATE_COEFFICIENTS_H
#define GENERATE_COEFFICIENTS_H

#include <stdio.h>

/* Prints the whole header. The same text wherever long double has 64 bits or more. */
void generate_coefficients(FILE *out);

#endif
