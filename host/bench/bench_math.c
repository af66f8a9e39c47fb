/* SPDX-License-Identifier: MIT */
/*
 * The program of a board: one line `function instructions` for each, with one decimal.
 *
 * What is counted is a call as its user pays for it: loading the arguments, the call, the function
 * and its return; a result in registers stays there, a structure goes where the caller wants it.
 * What is not: the loop around it (step, compare, branch), measured as an empty loop.
 */
#include "bench_math.h"

#include "../../port/boards/board.h"

/* A tick is 40 instructions: the figures err by less than 80 / (2048 4) = .01. */
#define CALLS     2048
#define REPEATS   4
#define WORDS_MAX 32

static uint32_t next_random(uint32_t *state)
{
    uint32_t x = *state; /* xorshift32 (Marsaglia 2003) */
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    *state = x;
    return x;
}

static q16 draw(uint8_t range, uint32_t *state)
{
    uint32_t octaves = range == BENCH_EXPONENT ? 9 : range >= BENCH_SINE ? 6 : 14;
    int32_t size = (int32_t)(65536u + (next_random(state) >> 16)); /* [1, 2) */
    size = size * (1 << (next_random(state) >> 8) % octaves) / 64;
    bool negative = next_random(state) >> 31 != 0;
    return negative && range != BENCH_POSITIVE && range != BENCH_FRACTION ? -size : size;
}

static void make_unit(q16 *x)
{
    qtri_quat q = {x[0], x[1], x[2], x[3]};
    q = qtri_quat_normalize(q);
    x[0] = q.w;
    x[1] = q.x;
    x[2] = q.y;
    x[3] = q.z;
}

static void make_arguments(q16 *x, const bench_case *function)
{
    static const uint8_t first[] = {BENCH_SIGNED,   BENCH_POSITIVE, BENCH_EXPONENT,
                                    BENCH_SINE,     BENCH_FRACTION, BENCH_SIGNED,
                                    BENCH_POSITIVE, BENCH_SINE,     BENCH_SINE};
    static const uint8_t last[] = {BENCH_SIGNED,   BENCH_POSITIVE, BENCH_EXPONENT,
                                   BENCH_SINE,     BENCH_FRACTION, BENCH_FRACTION,
                                   BENCH_EXPONENT, BENCH_SINE,     BENCH_FRACTION};
    bool quaternions = function->range >= BENCH_QUATERNIONS;
    uint32_t state = 2463534242u;
    for (uint32_t call = 0; call < CALLS; call++, x += function->words) {
        for (uint32_t i = 0; i < function->words; i++) {
            bool is_last = i + 1u == function->words;
            x[i] = draw(is_last ? last[function->range] : first[function->range], &state);
            if (quaternions && i % 4 == 3) {
                make_unit(&x[i - 3]);
            }
        }
    }
}

/* A step of every size takes the same three instructions. */
static void run_empty(const q16 *x, const q16 *end)
{
    for (; x != end; x += 4) {
        __asm__ volatile("" : : "r"(x));
    }
}

static uint32_t count_instructions(const bench_case *function, const q16 *x)
{
    uint32_t start = board_ticks();
    for (uint32_t i = 0; i < REPEATS; i++) {
        function->run(x, x + CALLS * function->words);
    }
    return board_instructions(start, board_ticks());
}

/* Not bench_print.c: what runs between two counts moves the phase of the ticks, and with it last
 * digits. */
static void write_decimal(uint32_t value, uint32_t least_digits)
{
    char text[12];
    char *p = &text[sizeof text - 1];
    *p = '\0';
    for (; value != 0 || least_digits > 0; value /= 10) {
        *--p = (char)('0' + value % 10);
        least_digits -= least_digits > 0;
    }
    board_write(p);
}

static void write_counts(const bench_case *functions, uint32_t empty, q16 *x)
{
    for (; functions->name != NULL; functions++) {
        make_arguments(x, functions);
        uint32_t spent = count_instructions(functions, x) - empty;
        uint32_t tenths =
            (uint32_t)(((uint64_t)spent * 10 + CALLS * REPEATS / 2) / (CALLS * REPEATS));
        board_write(functions->name);
        board_write(" ");
        write_decimal(tenths / 10, 1);
        board_write(".");
        write_decimal(tenths % 10, 1);
        board_write("\n");
    }
}

int board_program(void *memory, size_t bytes)
{
    static const bench_case nothing = {"empty", run_empty, 4, BENCH_SIGNED};
    if (bytes < sizeof(q16) * CALLS * WORDS_MAX) {
        return 1;
    }
    uint32_t empty = count_instructions(&nothing, memory);
    write_counts(bench_cases, empty, memory);
    board_write("end\n");
    return 0;
}
