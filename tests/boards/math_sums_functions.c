/* SPDX-License-Identifier: MIT */
#include "math_sums.h"

#include "qtri/q16.h"

#define ADD(name, body)                                                                            \
    static uint32_t add_##name(uint32_t sum, const q16 *x)                                         \
    {                                                                                              \
        body;                                                                                      \
        return sum;                                                                                \
    }
#define MIX_RESULT sum = mix_object(sum, &result, sizeof result)

/* Vectors, quaternions and matrices consist of q16 alone, without padding. */
static uint32_t mix_object(uint32_t sum, const void *object, size_t bytes)
{
    const q16 *words = object;
    for (uint8_t i = 0; i < bytes / sizeof words[0]; i++) {
        sum = math_mix(sum, words[i]);
    }
    return sum;
}

static q16 to_string(q16 x)
{
    char text[QTRI_Q16_TEXT_SIZE];
    q16 hash = q16_to_string(x, text, sizeof text);
    for (const char *p = text; *p != '\0'; p++) {
        hash = (q16)(((uint32_t)hash * 31u + (uint8_t)*p) & (uint32_t)INT32_MAX);
    }
    return hash;
}

/* Text from x: its decimal form, and behind it whatever its bits spell. */
static q16 from_string(q16 x)
{
    char text[QTRI_Q16_TEXT_SIZE + 8];
    q16 result = 0;
    int32_t length = q16_to_string(x, text, sizeof text);
    for (uint32_t bits = (uint32_t)x; length < QTRI_Q16_TEXT_SIZE + 7; bits >>= 3) {
        text[length++] = "0.459-12"[bits & 7];
    }
    text[length] = '\0';
    length = q16_from_string(text, &result);
    return (q16)(((uint32_t)result ^ (uint32_t)length * 65599u) & (uint32_t)INT32_MAX);
}

#define VALUE(name, words, range, expression)       ADD(name, sum = math_mix(sum, expression))
#define OBJECT(name, words, range, type, statement) ADD(name, type result; statement; MIX_RESULT)
/* Where a function says no, its result may be left alone. */
#define FLAGGED(name, words, range, type, expression)                                              \
    ADD(name, static const type nothing; type result = nothing; sum = math_mix(sum, expression);   \
        MIX_RESULT)
#include "../../host/bench/math_functions.inc"

#define VALUE(name, words, range, expression)         {#name, add_##name, words},
#define OBJECT(name, words, range, type, statement)   {#name, add_##name, words},
#define FLAGGED(name, words, range, type, expression) {#name, add_##name, words},

const math_case math_function_cases[] = {
#include "../../host/bench/math_functions.inc"
    {NULL, NULL, 0}};
