#include "sincos.h"

#include "bits.h"

#define DEGREES(n)             ((int32_t)(n)*65536)
#define RADIANS_PER_DEGREE_Q37 2398762259u /* pi / 180 * 2^37, rounded */

/* a b in Q31, rounded, for factors up to 1. */
static uint32_t mul_q31(uint32_t a, uint32_t b)
{
    return (uint32_t)((qtri_mul_u32(a, b) + 0x40000000u) >> 31);
}

/*
 * Taylor series on [0, pi/4] of the square, in Q31. The first terms left out are x^13 / 13! < 2^-37
 * and x^12 / 12! < 2^-33: below a rounding, so no minimax fit is needed.
 */
#define TERMS 5

static const uint32_t sine_terms_q31[TERMS] = {54u, 5918u, 426088u, 17895697u, 357913941u};
static const uint32_t cosine_terms_q31[TERMS] = {592u, 53261u, 2982616u, 89478485u, 0x40000000u};

/* c4 - square (c3 - square (...)) */
static uint32_t series_q31(const uint32_t *c, uint32_t square)
{
    uint32_t sum = c[0];
    for (int i = 1; i < TERMS; i++) {
        sum = c[i] - mul_q31(square, sum);
    }
    return sum;
}

uint32_t qtri_sine_ratio_q31(uint32_t square)
{
    return 0x80000000u - mul_q31(square, series_q31(sine_terms_q31, square));
}

uint32_t qtri_cosine_q31(uint32_t square)
{
    return 0x80000000u - mul_q31(square, series_q31(cosine_terms_q31, square));
}

void qtri_sincos_deg_q30(int32_t degrees, int32_t *sine_q30, int32_t *cosine_q30)
{
    int32_t turn = degrees % DEGREES(360);
    if (turn < 0) {
        turn += DEGREES(360);
    }
    int32_t quarter = (turn + DEGREES(45)) / DEGREES(90);        /* 0..4 */
    int32_t rest = turn - quarter * DEGREES(90);                 /* [-45, 45) degrees */
    uint32_t size = rest < 0 ? (uint32_t)-rest : (uint32_t)rest; /* < 2^22 */
    uint32_t x_q31 =
        (uint32_t)(((uint64_t)size * RADIANS_PER_DEGREE_Q37 + ((uint32_t)1 << 21)) >> 22);

    uint32_t square_q31 = mul_q31(x_q31, x_q31);
    uint32_t cube_q31 = mul_q31(square_q31, x_q31);
    int32_t sine =
        (int32_t)((x_q31 - mul_q31(cube_q31, series_q31(sine_terms_q31, square_q31)) + 1) >> 1);
    int32_t cosine = (int32_t)((qtri_cosine_q31(square_q31) + 1) >> 1);
    if (rest < 0) {
        sine = -sine;
    }
    *sine_q30 = (quarter & 1) ? cosine : sine;
    *cosine_q30 = (quarter & 1) ? -sine : cosine;
    if (quarter & 2) {
        *sine_q30 = -*sine_q30;
        *cosine_q30 = -*cosine_q30;
    }
}
