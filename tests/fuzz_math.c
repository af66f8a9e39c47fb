/* SPDX-License-Identifier: MIT */
/*
 * Fuzz target: functions of any arguments are the same with and without a long multiply and a
 * division, and as a debug build has them; nothing traps.
 */
#include "support/elementary.h"
#include "support/q16.h"

#include "bits/bits.h"

#include <stdlib.h>
#include <string.h>

static const q16_build usual = Q16_BUILD("usual");
static const elementary_build elementary = ELEMENTARY_BUILD;

static void same(int64_t a, int64_t b)
{
    if (a != b) {
        abort();
    }
}

#define BOTH(call)                                                                                 \
    do {                                                                                           \
        same(usual.call, q16_narrow_build.call);                                                   \
        same(usual.call, q16_checked_build.call);                                                  \
    } while (0)

static void compare_scalars(int32_t a, int32_t b, int32_t c)
{
    BOTH(add_sat(a, b));
    BOTH(sub_sat(a, b));
    BOTH(mul_sat(a, b));
    BOTH(div_sat(a, b));
    BOTH(mul_wrap(a, b));
    BOTH(hypot(a, b));
    BOTH(muldiv(a, b, c));
    BOTH(from_ratio(a, b));
    BOTH(mod(a, b));
    BOTH(recip(a));
    BOTH(sqrt(a));
    BOTH(rsqrt(a));
    BOTH(from_fixed(a, b % 64));
    BOTH(to_fixed(a, b % 64));
    same(usual.mul(a, b), q16_narrow_build.mul(a, b));
    same(usual.mul_floor(a, b), q16_narrow_build.mul_floor(a, b));
    same(usual.div(a, b), q16_narrow_build.div(a, b));
    same(usual.lerp(a, b, c), q16_narrow_build.lerp(a, b, c));
    same(usual.mul_s32(a, b), q16_narrow_build.mul_s32(a, b));
}

static void compare_elementary(int32_t a, int32_t b)
{
    for (int i = 0; i < ELEMENTARY_SINGLE; i++) {
        same(elementary.single[i](a), elementary_narrow_build.single[i](a));
    }
    for (int i = 0; i < 3; i++) {
        same(elementary.pair[i](a, b), elementary_narrow_build.pair[i](a, b));
    }
    for (int i = 0; i < 2; i++) {
        q16 sine[2], cosine[2];
        elementary.sincos[i](a, &sine[0], &cosine[0]);
        elementary_narrow_build.sincos[i](a, &sine[1], &cosine[1]);
        same(sine[0], sine[1]);
        same(cosine[0], cosine[1]);
        same(sine[0], elementary.single[i == 0 ? 0 : 2](a));
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    int32_t argument[3];
    for (; size >= sizeof argument; data += sizeof argument, size -= sizeof argument) {
        memcpy(argument, data, sizeof argument);
        compare_scalars(argument[0], argument[1], argument[2]);
        compare_elementary(argument[0], argument[1]);
    }
    return 0;
}
