#include "qtri/q16_trig.h"

#include "atan.h"
#include "bits.h"

/* The angle between the sides |x| and sqrt(1 - x^2): opposite x, or at it. */
static uint32_t angle_q31(q16 x, bool cosine)
{
    uint32_t size = qtri_magnitude32(x);
    size = size > (uint32_t)Q16_ONE ? (uint32_t)Q16_ONE : size;
    uint64_t square_q32 = ((uint64_t)1 << 32) - qtri_mul_u32(size, size);
    uint32_t root_q31 = (uint32_t)qtri_sqrt64_round(square_q32 << 30);
    size <<= 15;
    return cosine ? qtri_angle_q31(root_q31, size, x < 0) : qtri_angle_q31(size, root_q31, false);
}

q16 q16_asin(q16 x)
{
    q16 angle = qtri_half_turns_to_radians(angle_q31(x, false));
    return x < 0 ? -angle : angle;
}

q16 q16_asin_deg(q16 x)
{
    q16 angle = qtri_half_turns_to_degrees(angle_q31(x, false));
    return x < 0 ? -angle : angle;
}

q16 q16_acos(q16 x)
{
    return qtri_half_turns_to_radians(angle_q31(x, true));
}

q16 q16_acos_deg(q16 x)
{
    return qtri_half_turns_to_degrees(angle_q31(x, true));
}
