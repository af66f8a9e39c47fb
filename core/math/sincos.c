/* SPDX-License-Identifier: MIT */
#include "sincos.h"

#include "../bits/bits.h"

#define DEGREES(n)             ((int32_t)(n)*65536)
#define RADIANS_PER_DEGREE_Q37 2398762259u /* pi / 180 * 2^37, rounded */

void qtri_sincos_deg_q30(int32_t degrees, int32_t *sine_q30, int32_t *cosine_q30)
{
    /* Unsigned: a core that does not divide then needs one function for it, not two. */
    int32_t turn = (int32_t)(qtri_magnitude32(degrees) % (uint32_t)DEGREES(360));
    if (degrees < 0 && turn != 0) {
        turn = DEGREES(360) - turn;
    }
    int32_t quarter = (int32_t)((uint32_t)(turn + DEGREES(45)) / (uint32_t)DEGREES(90)); /* 0..4 */
    int32_t rest = turn - quarter * DEGREES(90);                 /* [-45, 45) degrees */
    uint32_t size = rest < 0 ? (uint32_t)-rest : (uint32_t)rest; /* < 2^22 */
    uint32_t x_q31 =
        (uint32_t)(((uint64_t)size * RADIANS_PER_DEGREE_Q37 + ((uint32_t)1 << 21)) >> 22);

    uint32_t square_q31 = qtri_mul_q31(x_q31, x_q31);
    uint32_t cube_q31 = qtri_mul_q31(square_q31, x_q31);
    uint32_t sine_q31 = x_q31 - qtri_mul_q31(cube_q31, qtri_series_q31(false, square_q31));
    int32_t sine = (int32_t)((sine_q31 + 1) >> 1);
    int32_t cosine = (int32_t)((qtri_cosine_q31(square_q31) + 1) >> 1);
    if (rest < 0) {
        sine = -sine;
    }
    *sine_q30 = (quarter & 1) != 0 ? cosine : sine;
    *cosine_q30 = (quarter & 1) != 0 ? -sine : cosine;
    if ((quarter & 2) != 0) {
        *sine_q30 = -*sine_q30;
        *cosine_q30 = -*cosine_q30;
    }
}
