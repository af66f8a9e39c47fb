/* SPDX-License-Identifier: MIT */
#include "bench_math.h"

#include "qtri/q16.h"

/* A result that is used, at no cost: in a register, or in memory. */
#define KEEP(value)         __asm__ volatile("" : : "r"(value))
#define KEEP_MEMORY(object) __asm__ volatile("" : : "m"(object))

static int32_t to_string(q16 x)
{
    char text[QTRI_Q16_TEXT_SIZE];
    int32_t length = q16_to_string(x, text, sizeof text);
    KEEP_MEMORY(text);
    return length;
}

/* One number for all: the cost goes with the digits. */
static int32_t from_string(q16 x)
{
    q16 result;
    KEEP(x);
    int32_t length = q16_from_string("-123.45678", &result);
    KEEP(result);
    return length;
}

#define LOOP(name, words, body)                                                                    \
    static void run_##name(const q16 *x, const q16 *end)                                           \
    {                                                                                              \
        for (; x != end; x += (words)) {                                                           \
            body;                                                                                  \
        }                                                                                          \
    }

#define VALUE(name, words, range, expression) LOOP(name, words, KEEP(expression))
#define OBJECT(name, words, range, type, statement)                                                \
    LOOP(name, words, type result; statement; KEEP_MEMORY(result))
#define FLAGGED(name, words, range, type, expression)                                              \
    LOOP(name, words, type result; KEEP((int)(expression)); KEEP_MEMORY(result))
#include "math_functions.inc"

/* Transforms are not made of q16: one product for all, of two cameras. */
static void run_qtri_transform_mul(const q16 *x, const q16 *end)
{
    qtri_vec3 eye = {Q16(3), Q16(2), Q16(5)};
    qtri_vec3 center = {0, 0, 0};
    qtri_vec3 up = {0, Q16_ONE, 0};
    qtri_transform camera;
    qtri_transform product;
    qtri_transform_identity(&camera);
    qtri_transform_look_at(&camera, eye, center, up);
    for (; x != end; x++) {
        qtri_transform_mul(&product, &camera, &camera);
        KEEP_MEMORY(product);
    }
}

/* What every figure contains: the cost of a call of nothing. */
__attribute__((noinline)) static q16 nothing1(q16 a)
{
    KEEP(a);
    return a;
}

__attribute__((noinline)) static q16 nothing2(q16 a, q16 b)
{
    KEEP(b);
    return a;
}

LOOP(nothing1, 1, KEEP(nothing1(x[0])))
LOOP(nothing2, 2, KEEP(nothing2(x[0], x[1])))

#define VALUE(name, words, range, expression)         {#name, run_##name, words, BENCH_##range},
#define OBJECT(name, words, range, type, statement)   {#name, run_##name, words, BENCH_##range},
#define FLAGGED(name, words, range, type, expression) {#name, run_##name, words, BENCH_##range},

const bench_case bench_cases[] = {{"#nothing(a)", run_nothing1, 1, BENCH_SIGNED},
                                  {"#nothing(a,b)", run_nothing2, 2, BENCH_SIGNED},
#include "math_functions.inc"
                                  {"qtri_transform_mul", run_qtri_transform_mul, 1, BENCH_SIGNED},
                                  {NULL, NULL, 0, BENCH_SIGNED}};
