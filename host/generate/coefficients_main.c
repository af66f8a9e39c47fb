/* SPDX-License-Identifier: MIT */
#include "coefficients.h"

int main(void)
{
    generate_coefficients(stdout);
    return ferror(stdout) ? 1 : 0;
}
