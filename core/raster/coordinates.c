/* SPDX-License-Identifier: MIT */
#include "list.h"

void qtri_coordinates_set(qtri_coordinates *out, const int64_t at_q32[3])
{
    const int64_t limit = (int64_t)1 << 48;
    int64_t offset[3];
    uint64_t all = 0;
    for (int i = 0; i < 3; i++) {
        offset[i] = at_q32[i] < -limit ? -limit : (at_q32[i] > limit ? limit : at_q32[i]);
    }
    out->repeats = (int32_t)(offset[0] >> 32);
    for (int i = 0; i < 3; i++) {
        offset[i] -= (int64_t)out->repeats * ((int64_t)1 << 32); /* < 2^50 */
        all |= qtri_magnitude64(offset[i]);
    }
    int32_t down = 34 - qtri_clz64(all); /* to below 2^30 */
    down = down < 2 ? 2 : down;
    out->fraction = 32 - down;
    for (int i = 0; i < 3; i++) {
        out->at[i] = (int32_t)(offset[i] >> down);
    }
}
