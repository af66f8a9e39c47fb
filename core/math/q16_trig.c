#include "qtri/q16_trig.h"

#include "sincos.h"

void q16_sincos_deg(q16 degrees, q16 *sine, q16 *cosine)
{
    int32_t sine_q30;
    int32_t cosine_q30;
    qtri_sincos_deg_q30(degrees, &sine_q30, &cosine_q30);
    *sine = (sine_q30 + 0x2000) >> 14;
    *cosine = (cosine_q30 + 0x2000) >> 14;
}

q16 q16_sin_deg(q16 degrees)
{
    q16 sine;
    q16 cosine;
    q16_sincos_deg(degrees, &sine, &cosine);
    return sine;
}

q16 q16_cos_deg(q16 degrees)
{
    q16 sine;
    q16 cosine;
    q16_sincos_deg(degrees, &sine, &cosine);
    return cosine;
}
