/* SPDX-License-Identifier: MIT */
#include "qtri/q16_trig.h"

#include "atan.h"

q16 q16_asin(q16 x)
{
    q16 angle = qtri_half_turns_to_radians(qtri_side_angle_q31(x, false));
    return x < 0 ? -angle : angle;
}

q16 q16_asin_deg(q16 x)
{
    q16 angle = qtri_half_turns_to_degrees(qtri_side_angle_q31(x, false));
    return x < 0 ? -angle : angle;
}

q16 q16_acos(q16 x)
{
    return qtri_half_turns_to_radians(qtri_side_angle_q31(x, true));
}

q16 q16_acos_deg(q16 x)
{
    return qtri_half_turns_to_degrees(qtri_side_angle_q31(x, true));
}
