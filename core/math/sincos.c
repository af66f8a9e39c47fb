#include "sincos.h"

#define DEGREES(n)             ((int32_t)(n)*65536)
#define RADIANS_PER_DEGREE_Q37 2398762259u /* pi / 180 * 2^37, rounded */

/* a b in Q31, rounded, for factors up to 1. */
static uint32_t mul_q31(uint32_t a, uint32_t b)
{
    return (uint32_t)(((uint64_t)a * b + 0x40000000u) >> 31);
}

/*
 * Taylor series on [0, pi/4], x and results in Q31. The first terms left out are
 * x^13 / 13! < 2^-37 and x^12 / 12! < 2^-33: below a rounding, so no minimax fit is needed.
 */
static uint32_t sine_q31(uint32_t x)
{
    uint32_t square = mul_q31(x, x);
    uint32_t sum = 54u;                          /* 1/11! = 2^31 / 39916800 */
    sum = 5918u - mul_q31(square, sum);          /* 1/9! */
    sum = 426088u - mul_q31(square, sum);        /* 1/7! */
    sum = 17895697u - mul_q31(square, sum);      /* 1/5! */
    sum = 357913941u - mul_q31(square, sum);     /* 1/3! */
    return x - mul_q31(mul_q31(square, x), sum); /* x - x^3 (1/3! - x^2 (1/5! - ...)) */
}

static uint32_t cosine_q31(uint32_t x)
{
    uint32_t square = mul_q31(x, x);
    uint32_t sum = 592u;                       /* 1/10! */
    sum = 53261u - mul_q31(square, sum);       /* 1/8! */
    sum = 2982616u - mul_q31(square, sum);     /* 1/6! */
    sum = 89478485u - mul_q31(square, sum);    /* 1/4! */
    sum = 0x40000000u - mul_q31(square, sum);  /* 1/2! */
    return 0x80000000u - mul_q31(square, sum); /* 2^31 is 1: fits only unsigned */
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
    uint32_t x_q31 = (uint32_t)(((uint64_t)size * RADIANS_PER_DEGREE_Q37 + (1u << 21)) >> 22);

    int32_t sine = (int32_t)((sine_q31(x_q31) + 1) >> 1);
    int32_t cosine = (int32_t)((cosine_q31(x_q31) + 1) >> 1);
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
