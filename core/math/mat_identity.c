/* SPDX-License-Identifier: MIT */
/*
 * Apart from the matrices that begin as an identity: they call it, and are no copies of it.
 */
#include "qtri/mat.h"

qtri_mat3 qtri_mat3_identity(void)
{
    qtri_mat3 m = {{{Q16_ONE, 0, 0}, {0, Q16_ONE, 0}, {0, 0, Q16_ONE}}};
    return m;
}

qtri_mat4 qtri_mat4_identity(void)
{
    qtri_mat4 m = {
        {{Q16_ONE, 0, 0, 0}, {0, Q16_ONE, 0, 0}, {0, 0, Q16_ONE, 0}, {0, 0, 0, Q16_ONE}}};
    return m;
}
