/* SPDX-License-Identifier: MIT */
/*
 * Printed by host/generate/coefficients.c (`make tables`): do not edit.
 *
 * Coefficient k of a polynomial in v times 2^Q, without its sign. Internal.
 */
/* clang-format off */
#ifndef QTRI_MATH_COEFFICIENTS_H
#define QTRI_MATH_COEFFICIENTS_H

/* sin(w pi/4) / w, w^2 = v in [0, 1], within 2^-27.8 */
#define QTRI_SINE_0_Q31 1686629704u
#define QTRI_SINE_1_Q33 693597804u
#define QTRI_SINE_2_Q24 41775u
#define QTRI_SINE_3_Q30 38606u

/* cos(w pi/4), w^2 = v in [0, 1], within 2^-25.1 */
#define QTRI_COSINE_0_Q30 1073741794u
#define QTRI_COSINE_1_Q32 1324672077u
#define QTRI_COSINE_2_Q36 1089197616u
#define QTRI_COSINE_3_Q27 42799u

/* atan(w) / (pi w), w^2 = v in [0, 1/9], within 2^-30.1 */
#define QTRI_ATAN_0_Q32 1367130548u
#define QTRI_ATAN_1_Q34 1822834855u
#define QTRI_ATAN_2_Q34 1093279977u
#define QTRI_ATAN_3_Q20 47012u
#define QTRI_ATAN_4_Q20 29824u

/* log2(1 + v) / v, v in [0, 1/16], within 2^-18.6 */
#define QTRI_LOG2_0_Q30 1549079325u
#define QTRI_LOG2_1_Q31 1547512981u
#define QTRI_LOG2_2_Q32 1928506221u

/* (2^v - 1) / v - 1/2, v in [0, 1], within 2^-33.6 */
#define QTRI_EXP2_0_Q33 1659121647u
#define QTRI_EXP2_1_Q33 2063529987u
#define QTRI_EXP2_2_Q35 1907106266u
#define QTRI_EXP2_3_Q35 330479460u
#define QTRI_EXP2_4_Q35 45801889u
#define QTRI_EXP2_5_Q35 5317479u
#define QTRI_EXP2_6_Q35 495518u
#define QTRI_EXP2_7_Q35 62035u

/* 2 atanh(w) / (w ln 2), w^2 = v in [0, 3 - sqrt(8)]^2, within 2^-31.4 */
#define QTRI_LOG2S_0_Q30 3098164009u
#define QTRI_LOG2S_1_Q32 4130885257u
#define QTRI_LOG2S_2_Q32 2478555185u
#define QTRI_LOG2S_3_Q32 1768117457u
#define QTRI_LOG2S_4_Q16 22331u

/* For m in [1 + i/16, 1 + (i+1)/16): a factor f with m f in [1, 1 + 1/16], and -log2(f). */
#define QTRI_LOG2_FACTORS_Q16 \
    {65536u, 61681u, 58255u, 55189u, 52429u, 49933u, 47663u, 45591u, \
     43691u, 41944u, 40330u, 38837u, 37450u, 36158u, 34953u, 33826u}
#define QTRI_LOG2_OF_FACTORS_Q31 \
    {0u, 187822067u, 364869797u, 532375962u, 691323501u, 842445022u, 986592342u, 1124290511u, \
     1256173768u, 1382599729u, 1504171023u, 1621040611u, 1733710583u, 1842482430u, 1947491360u, 2049032336u}

/* clang-format on */
#endif
