#include "plane.h"

/* numerator 2^16 / area, rounded, modulo 2^64. |numerator| < 2^57, |area| <= 2^47. */
static uint64_t gradient(int64_t numerator, int64_t area)
{
    uint64_t size = qtri_magnitude64(numerator);
    uint64_t divisor = qtri_magnitude64(area);
    uint64_t whole = size / divisor;
    uint64_t rest = size % divisor;                         /* < 2^47 */
    uint64_t part = ((rest << 16) + divisor / 2) / divisor; /* < 2^63 + 2^46: no overflow */
    uint64_t quotient = (whole << 16) + part;
    return (numerator < 0) == (area < 0) ? quotient : 0 - quotient;
}

void qtri_plane_init(qtri_plane *plane, const qtri_plane_base *base, const int64_t f[3])
{
    int64_t df1 = f[1] - f[0];
    int64_t df2 = f[2] - f[0];
    plane->origin = (uint64_t)f[0] << 16;
    plane->dx = 0;
    plane->dy = 0;
    if (df1 == 0 && df2 == 0) {
        return;
    }
    uint64_t per_x = gradient(df1 * base->dy2 - df2 * base->dy1, base->area);
    uint64_t per_y = gradient(df2 * base->dx1 - df1 * base->dx2, base->area);
    plane->origin += per_x * (uint64_t)(int64_t)(128 - base->x_24p8);
    plane->origin += per_y * (uint64_t)(int64_t)(128 - base->y_24p8);
    plane->dx = per_x << 8;
    plane->dy = per_y << 8;
}

static uint32_t round_to_ramp(uint64_t value)
{
    return (uint32_t)((value + 0x8000u) >> 16);
}

void qtri_ramp_init(qtri_ramp *ramp, const qtri_plane *plane, int32_t x, int32_t y)
{
    ramp->origin = round_to_ramp(qtri_plane_at(plane, x, y)) + 0x8000u;
    ramp->dx = round_to_ramp(plane->dx);
    ramp->dy = round_to_ramp(plane->dy);
}
