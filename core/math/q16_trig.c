/* SPDX-License-Identifier: MIT */
/*
 * Sines, tangents and their inverses.
 */
#include "qtri/error.h"
#include "qtri/q16.h"

#include "../bits/bits.h"
#include "coefficients.h"
#include "q16_trig.h"

/* ---- Sine and cosine at 30 fraction bits ---- */

/*
 * Taylor series on [0, pi/4] of the square, in Q31. The first terms left out are x^13 / 13! < 2^-37
 * and x^12 / 12! < 2^-33: below a rounding, so no minimax fit is needed.
 */
#define TERMS 5

static const uint32_t terms_q31[2][TERMS] = {{54u, 5918u, 426088u, 17895697u, 357913941u},
                                             {592u, 53261u, 2982616u, 89478485u, 0x40000000u}};

uint32_t qtri_mul_q31(uint32_t a, uint32_t b)
{
    return (uint32_t)((qtri_mul_u32(a, b) + 0x40000000u) >> 31);
}

/* c4 - square (c3 - square (...)) */
uint32_t qtri_series_q31(bool cosine, uint32_t square_q31)
{
    const uint32_t *c = terms_q31[cosine];
    uint32_t sum = c[0];
    for (int i = 1; i < TERMS; i++) {
        sum = c[i] - qtri_mul_q31(square_q31, sum);
    }
    return sum;
}

#define DEGREES(n) ((int32_t)(n)*65536)

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
        (uint32_t)(((uint64_t)size * QTRI_RADIANS_PER_DEGREE_Q37 + ((uint32_t)1 << 21)) >> 22);

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

/* ---- Sine and cosine of Q16.16 ---- */

/* Both results exceed the polynomial's error by .002 ULP: most of it the last place of 16-bit
 * coefficients. */
uint32_t qtri_sine_of_eighths_q30(uint32_t w)
{
    uint32_t v_q30 = qtri_mul_high31(w, w);
    uint32_t v_q16 = v_q30 >> 14;
    uint32_t sum = QTRI_SINE_2_Q24 - ((QTRI_SINE_3_Q30 * v_q16) >> 22); /* < 2^16 */
    sum = QTRI_SINE_1_Q33 - ((sum * v_q16) >> 7);
    sum = QTRI_SINE_0_Q31 - qtri_mul_high31(v_q30, sum);
    return qtri_mul_high31(w, sum);
}

uint32_t qtri_cosine_of_eighths_q30(uint32_t w)
{
    uint32_t v_q30 = qtri_mul_high31(w, w);
    uint32_t v_q16 = v_q30 >> 14;
    uint32_t sum = QTRI_COSINE_2_Q36 - ((QTRI_COSINE_3_Q27 * v_q16) >> 7);
    sum = QTRI_COSINE_1_Q32 - (qtri_mul_high31(v_q30, sum) >> 2);
    return QTRI_COSINE_0_Q30 - qtri_mul_high31(v_q30, sum);
}

#define EIGHTH_TURN 0x20000000u

/*
 * Turns are in Q32 and wrap.
 *
 * 2^15 / pi for a radian: at 2^31 units the rounding of its fraction is a quarter of the last
 * place, and what is cut off is one, 2^-29.3 radians: .0001 ULP.
 */
static inline uint32_t turns_of_radians(q16 radians)
{
    uint32_t size = qtri_magnitude32(radians);
    return size * 10430u + qtri_mul_high31(size, 1625002897u);
}

/*
 * 2^16 / 360 = 182 + 2/45 for a degree. The exact result to nearest, so that angles a whole turn
 * apart are the same, negative ones too: an exact fraction is a multiple of 1/45, at least 1/90
 * from a half, and 2/45 in Q35 is less than 2^-5 of its last place too small: 2^-9 for 2^31 units.
 */
static inline uint32_t turns_of_degrees(q16 degrees)
{
    uint32_t size = qtri_magnitude32(degrees);
    return size * 182u + ((qtri_mul_high31(size, 1527099483u) + 4) >> 3);
}

static inline q16 rounded_q30(uint32_t size_q30, uint32_t negative)
{
    q16 result = (q16)((size_q30 + 0x2000u) >> 14);
    return negative ? -result : result;
}

/* A quarter of a turn begins an eighth before its right angle. */
static inline uint32_t eighths_q31(uint32_t shifted, uint32_t *negative)
{
    uint32_t rest = shifted & (2 * EIGHTH_TURN - 1);
    *negative = rest < EIGHTH_TURN;
    return (*negative ? EIGHTH_TURN - rest : rest - EIGHTH_TURN) << 2;
}

static q16 sine_of_turns(uint32_t turn, uint32_t negative)
{
    uint32_t shifted = turn + EIGHTH_TURN;
    uint32_t before;
    uint32_t w_q31 = eighths_q31(shifted, &before);
    negative ^= shifted >> 31;
    if ((shifted & 0x40000000u) != 0) {
        return rounded_q30(qtri_cosine_of_eighths_q30(w_q31), negative);
    }
    return rounded_q30(qtri_sine_of_eighths_q30(w_q31), negative ^ before);
}

static void sincos_of_turns(uint32_t turn, uint32_t negative, q16 *sine, q16 *cosine)
{
    uint32_t shifted = turn + EIGHTH_TURN;
    uint32_t before;
    uint32_t w_q31 = eighths_q31(shifted, &before);
    uint32_t quarter = shifted >> 30;
    uint32_t half = quarter >> 1;
    q16 s = rounded_q30(qtri_sine_of_eighths_q30(w_q31), before);
    q16 c = rounded_q30(qtri_cosine_of_eighths_q30(w_q31), 0);
    if ((quarter & 1) != 0) {
        q16 swap = s;
        s = c;
        c = -swap;
    }
    *sine = half != negative ? -s : s;
    *cosine = half ? -c : c;
}

q16 q16_sin(q16 radians)
{
    return sine_of_turns(turns_of_radians(radians), radians < 0);
}

q16 q16_cos(q16 radians)
{
    return sine_of_turns(turns_of_radians(radians) + 2 * EIGHTH_TURN, 0);
}

void q16_sincos(q16 radians, q16 *sine, q16 *cosine)
{
    QTRI_ASSERT(sine != NULL && cosine != NULL);
    sincos_of_turns(turns_of_radians(radians), radians < 0, sine, cosine);
}

q16 q16_sin_deg(q16 degrees)
{
    return sine_of_turns(turns_of_degrees(degrees), degrees < 0);
}

q16 q16_cos_deg(q16 degrees)
{
    return sine_of_turns(turns_of_degrees(degrees) + 2 * EIGHTH_TURN, 0);
}

void q16_sincos_deg(q16 degrees, q16 *sine, q16 *cosine)
{
    QTRI_ASSERT(sine != NULL && cosine != NULL);
    sincos_of_turns(turns_of_degrees(degrees), degrees < 0, sine, cosine);
}

/* ---- Tangent ---- */

#define PI_Q30 3373259426u

/*
 * Half turns of 2^31 units at most, of half turns per Q16.16 unit in two words: high in Q48 + up,
 * low in Q80 + up.
 */
static inline uint64_t half_turns_q64(q16 x, uint32_t high, uint32_t low, int32_t up)
{
    uint32_t size = qtri_magnitude32(x);
    return (qtri_mul_u32(size, high) << (16 - up)) + (qtri_mul_u32(size, low) >> (16 + up));
}

/*
 * tan repeats after half a turn. Near a pole the distance to it counts: half turns per Q16.16
 * unit are kept in Q80, so that the argument's last bit and 2^31 units leave 2^-50 half turns.
 */
static q16 tangent(q16 x, uint64_t turn_q64)
{
    uint64_t shifted_q48 = ((turn_q64 + 0x8000u) >> 16) + ((uint64_t)1 << 46);
    bool pole = (shifted_q48 >> 47) & 1;
    int64_t rest_q48 = (int64_t)(shifted_q48 & (((uint64_t)1 << 47) - 1)) -
                       ((int64_t)1 << 46); /* from 0 or a pole */
    bool negative = (x < 0) != (rest_q48 < 0);
    uint64_t distance_q48 = qtri_magnitude64(rest_q48); /* <= 2^46: pi / 4 */
    int32_t zeros = qtri_clz64(distance_q48);           /* >= 17 */
    if (pole) {
        negative = rest_q48 == 0 ? x < 0 : (x < 0) == (rest_q48 < 0);
        if (zeros > 32) { /* within 2^-17 half turns: above 2^15 */
            QTRI_MATH_CHECK(false);
            return negative ? Q16_MIN : Q16_MAX;
        }
    }
    if (distance_q48 == 0) {
        return 0;
    }
    uint32_t radians_q31 = qtri_mul_high32((uint32_t)(distance_q48 >> 15), PI_Q30);
    uint32_t square_q31 = qtri_mul_q31(radians_q31, radians_q31);
    uint32_t cosine_q31 = qtri_cosine_q31(square_q31);
    /* The sine is m 2^-(14 + zeros), and m normalised. */
    uint32_t m = qtri_mul_high32((uint32_t)((distance_q48 << zeros) >> 32), PI_Q30);
    m = (uint32_t)(qtri_mul_u32(m, qtri_sine_ratio_q31(square_q31)) >> 31);
    if (m < 0x80000000u) {
        m <<= 1;
        zeros++;
    }
    uint64_t quotient;
    int32_t shift;
    if (pole) { /* 2^31 cos 2^62 / m */
        quotient = qtri_mul_u32(cosine_q31, qtri_reciprocal_q62(m));
        shift = 63 - zeros;
    } else { /* m 2^62 / (2^32 cos), where a cosine of 1 gives way to 1 - 2^-32 */
        uint32_t cosine_q32 = cosine_q31 < 0x80000000u ? cosine_q31 << 1 : UINT32_MAX;
        quotient = qtri_mul_u32(m, qtri_reciprocal_q62(cosine_q32));
        shift = 28 + zeros;
    }
    int64_t size_q16 = qtri_shift_round((int64_t)quotient, shift); /* quotient < 2^62.5 */
    return qtri_saturate32_checked(negative ? -size_q16 : size_q16);
}

q16 q16_tan(q16 radians)
{
    return tangent(radians, half_turns_q64(radians, 0x517CC1B7u, 0x27220A95u, 0)); /* 2^64 / pi */
}

/*
 * 2^71 / 180. In Q48 an exact result is a multiple of 1/45, at least 1/90 from a half, and what
 * 2^31 units lose here is 2^-9: angles half a turn apart are the same.
 */
q16 q16_tan_deg(q16 degrees)
{
    return tangent(degrees, half_turns_q64(degrees, 0xB60B60B6u, 0x0B60B60Bu, 7));
}

/* ---- Inverses ---- */

#define ATAN_HALF_Q32 633866811u  /* atan(1/2) / pi 2^32 */
#define PI_Q29        1686629713u /* pi 2^29 */

/*
 * 1/D - 1 in Q16 for D = d_q16 / 2^16 in [1/2, 1], less than 2^-14 too small.
 *
 * r = 48/17 - 32/17 D is 1/D within 1/17; each of Newton's steps r += r (1 - D r) squares that:
 * 2^-8.1, then 2^-16 from below.
 */
static inline uint32_t reciprocal_less_one_q16(uint32_t d_q16)
{
    uint32_t r_q14 = 46261u - ((d_q16 * 30840u) >> 16); /* < 2^15 */
    int32_t error_q30 = 0x40000000 - (int32_t)(d_q16 * r_q14);
    r_q14 <<= 2; /* from here in Q16 */
    uint32_t r_q16 = r_q14 + (uint32_t)(((int32_t)r_q14 * (error_q30 >> 16)) >> 14);
    int32_t error_q32 = (int32_t)(0u - d_q16 * r_q16); /* |1 - D r| < 2^-8: 2^32 wraps */
    r_q16 += (uint32_t)(((int32_t)r_q16 * (error_q32 >> 11)) >> 21);
    return r_q16 - (r_q16 < 0x10000u ? r_q16 : 0x10000u); /* r is in [1, 2) */
}

/*
 * n / d in Q32, at most 2^-28 of itself too small, for n <= d / 2 and d >= 2^31: the last of
 * Newton's steps is done on n r. D = d / 2^32 is taken too large, which costs r at most 2^-15 and
 * leaves an error that is not negative: < 2^-14.
 */
static uint32_t quotient_q32(uint32_t n, uint32_t d)
{
    uint32_t r_q16 = reciprocal_less_one_q16((d >> 16) + 1); /* of 2^15..2^16; one is added below */
    uint32_t rest_q32 = 0u - (d + qtri_mul_high16(d, r_q16));
    uint32_t q_q32 = n + qtri_mul_high16(n, r_q16);
    return q_q32 + (qtri_mul_high16(q_q32, rest_q32 >> 2) >> 14);
}

/*
 * With the shorter side n and the longer one d, n / d in [0, 1]: from 5/16 up the angle is
 * atan(1/2) + atan((n - d/2) / (d + n/2)), whose quotient is in [-1/6, 1/3].
 */
uint32_t qtri_angle_q31(uint32_t y, uint32_t x, bool mirrored)
{
    uint32_t n = y < x ? y : x;
    uint32_t d = y < x ? x : y;
    if (d == 0) {
        return 0;
    }
    int32_t zeros = qtri_clz32(d);
    n <<= zeros;
    d <<= zeros; /* in [2^31, 2^32) */
    uint32_t base_q32 = 0;
    bool below = false;
    if (n > (d >> 2) + (d >> 4)) {
        uint32_t half = d >> 1;
        base_q32 = ATAN_HALF_Q32;
        below = n < half;
        d = half + (n >> 2); /* halves: d + n / 2 would not fit */
        n = (below ? half - n : n - half) >> 1;
        if (d < 0x80000000u) {
            d <<= 1;
            n <<= 1;
        }
    }
    uint32_t q_q32 = quotient_q32(n, d);
    uint32_t v_q32 = qtri_mul_high31(q_q32, q_q32);
    uint32_t v_q19 = v_q32 >> 13;                                       /* < 2^16 */
    uint32_t sum = QTRI_ATAN_3_Q20 - ((QTRI_ATAN_4_Q20 * v_q19) >> 19); /* < 2^16 */
    sum = QTRI_ATAN_2_Q34 - ((sum * v_q19) >> 5);
    sum = QTRI_ATAN_1_Q34 - qtri_mul_high31(v_q32, sum);
    sum = QTRI_ATAN_0_Q32 - (qtri_mul_high31(v_q32, sum) >> 2);
    uint32_t angle_q32 = qtri_mul_high31(q_q32, sum);
    angle_q32 = below ? base_q32 - angle_q32 : base_q32 + angle_q32;
    if (y > x) {
        angle_q32 = 0x80000000u - angle_q32;
    }
    uint32_t angle_q31 = (angle_q32 + 1) >> 1;
    return mirrored ? 0x80000000u - angle_q31 : angle_q31;
}

q16 qtri_half_turns_to_radians(uint32_t angle_q31)
{
    return (q16)((qtri_mul_high31(angle_q31, PI_Q29) + 0x800u) >> 12); /* from Q28 */
}

q16 q16_atan2(q16 y, q16 x)
{
    q16 angle =
        qtri_half_turns_to_radians(qtri_angle_q31(qtri_magnitude32(y), qtri_magnitude32(x), x < 0));
    return y < 0 ? -angle : angle;
}

q16 q16_atan2_deg(q16 y, q16 x)
{
    q16 angle =
        qtri_half_turns_to_degrees(qtri_angle_q31(qtri_magnitude32(y), qtri_magnitude32(x), x < 0));
    return y < 0 ? -angle : angle;
}

q16 q16_atan(q16 x)
{
    return q16_atan2(x, Q16_ONE);
}

q16 q16_atan_deg(q16 x)
{
    return q16_atan2_deg(x, Q16_ONE);
}

uint32_t qtri_side_angle_q31(q16 x, bool cosine)
{
    uint32_t size = qtri_magnitude32(x);
    QTRI_MATH_CHECK(size <= (uint32_t)Q16_ONE);
    size = size > (uint32_t)Q16_ONE ? (uint32_t)Q16_ONE : size;
    uint64_t square_q32 = ((uint64_t)1 << 32) - qtri_mul_u32(size, size);
    uint32_t root_q31 = (uint32_t)qtri_sqrt64_round(square_q32 << 30);
    size <<= 15;
    return cosine ? qtri_angle_q31(root_q31, size, x < 0) : qtri_angle_q31(size, root_q31, false);
}

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
