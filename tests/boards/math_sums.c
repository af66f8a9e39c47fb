/* SPDX-License-Identifier: MIT */
#include "math_sums.h"

#include "../../port/boards/board.h"

/* Integers, because Q16() rounds in double, and double has 24 bits on some of the targets. */
#define WHOLE(n) ((q16)(n)*65536)
/* clang-format off */
static const q16 edges[] = {
    0, 1, -1, 2, -2, 3, 255, 256, -256, 257, 0x7FFF, 0x8000, 0x8001, -32768, 0xFFFF,
    WHOLE(1), WHOLE(1) + 1, WHOLE(-1), WHOLE(-1) - 1, 98304, WHOLE(2), WHOLE(-2),
    WHOLE(3), -46334, 102944, 205887, -411775, /* -1/sqrt 2, pi/2, pi, -2 pi */
    681391, -726817, WHOLE(15), WHOLE(-17),  /* about where exp and exp2 saturate */
    WHOLE(30), WHOLE(45), WHOLE(-90), WHOLE(90) + 1, WHOLE(180), WHOLE(270),
    WHOLE(-360), 11863324, WHOLE(256), WHOLE(-16384), /* sqrt 32767 */
    0x3FFFFFFF, 0x40000000, Q16_MAX - 0x8000, Q16_MAX - 1, Q16_MAX, -Q16_MAX, Q16_MIN};
/* clang-format on */
#define EDGE_COUNT ((uint32_t)(sizeof edges / sizeof edges[0]))

/* xorshift32 (Marsaglia 2003); the state is never 0. */
static uint32_t next_random(uint32_t *state)
{
    uint32_t x = *state;
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    *state = x;
    return x;
}

/* An unsigned number as the two's complement it spells. */
static q16 as_signed(uint32_t x)
{
    return x > (uint32_t)INT32_MAX ? -(q16)(UINT32_MAX - x) - 1 : (q16)x;
}

/*
 * Every eighth sample takes edge values only, all pairs of them in turn. The others: numbers of
 * every length, of -4..4, near an edge, and of the whole range.
 */
static void make_arguments(q16 *arguments, uint8_t count, uint32_t sample, uint32_t *state)
{
    uint32_t turn = sample / 8;
    for (uint8_t i = 0; i < count; i++) {
        uint32_t random = next_random(state);
        uint32_t shift = next_random(state) >> 27;
        uint32_t kind = sample % 8 == 0 ? 0 : 1 + random % 4;
        q16 sized = as_signed(random) / ((q16)1 << (shift < 30 ? shift : 30));
        switch (kind) {
        case 0:
            arguments[i] = edges[(i < 3 ? turn : random >> 8) % EDGE_COUNT];
            turn /= EDGE_COUNT;
            break;
        case 1:
            arguments[i] = as_signed(random);
            break;
        case 2:
            arguments[i] = as_signed(random) / 8192;
            break;
        case 3:
            arguments[i] =
                as_signed((uint32_t)edges[(random >> 8) % EDGE_COUNT] + (uint32_t)(sized / 65536));
            break;
        default:
            arguments[i] = sized;
            break;
        }
    }
}

static void write_hexadecimal(uint32_t value)
{
    char text[9];
    for (uint8_t i = 8; i-- > 0; value >>= 4) {
        text[i] = "0123456789abcdef"[value & 15];
    }
    text[8] = '\0';
    board_write(text);
}

static uint32_t write_sums(const math_case *cases, uint32_t samples)
{
    uint32_t lines = 0;
    for (; cases->name != NULL; cases++, lines++) {
        q16 arguments[MATH_ARGUMENTS_MAX];
        uint32_t state = 2463534242u;
        uint32_t sum = 2166136261u;
        uint32_t least = samples / (cases->count > 4 ? MATH_WIDE_SHARE : 1);
        for (uint32_t sample = 0; sample <= least; sample++) {
            make_arguments(arguments, cases->count, sample, &state);
            sum = cases->add(sum, arguments);
        }
        board_write(cases->name);
        board_write(" ");
        write_hexadecimal(sum);
        board_write("\n");
    }
    return lines;
}

void math_sums_write(uint32_t samples)
{
    uint32_t lines = write_sums(math_function_cases, samples);
    lines += write_sums(math_transform_cases, samples / MATH_WIDE_SHARE);
    board_write("end ");
    write_hexadecimal(lines);
    board_write("\n");
}
