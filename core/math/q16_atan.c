/* SPDX-License-Identifier: MIT */
#include "qtri/q16_trig.h"

q16 q16_atan(q16 x)
{
    return q16_atan2(x, Q16_ONE);
}

q16 q16_atan_deg(q16 x)
{
    return q16_atan2_deg(x, Q16_ONE);
}
