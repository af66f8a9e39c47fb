/* SPDX-License-Identifier: MIT */
/*
 * The stages that make a pixel, each alone: against exact arithmetic over all that they may be
 * given, and against a plain model of one fragment after the other.
 */
#include <math.h>

#include "raster/batch.h"
#include "raster/stage_color.h"
#include "raster/stage_depth.h"
#include "raster/texel_number.h"
#include "raster/textured.h"
#include "support/core.h"

/* ---- Colours ---- */

static double channel(uint32_t color, int i, bool narrow)
{
    static const int shift[2][3] = {{16, 8, 0}, {11, 5, 0}};
    static const uint32_t most[2][3] = {{255, 255, 255}, {31, 63, 31}};
    return color >> shift[narrow][i] & most[narrow][i];
}

/* The farthest that a channel is from what it should be. */
static double worst_channel(uint32_t color, const double expected[3], bool narrow)
{
    double worst = 0;
    for (int i = 0; i < 3; i++) {
        worst = fmax(worst, fabs(channel(color, i, narrow) - expected[i]));
    }
    return worst;
}

/* A colour whose three channels are as near to x / 255 as they get, in either kind. */
static uint32_t gray(uint32_t x, bool narrow)
{
    return narrow ? (x * 31 / 255) << 11 | (x * 63 / 255) << 5 | x * 31 / 255 : x * 0x010101u;
}

static double worst_light(bool narrow)
{
    double worst = 0;
    for (uint32_t x = 0; x < 256; x++) {
        for (uint32_t light = 0; light <= 1024; light++) {
            const uint32_t given = gray(x, narrow);
            uint32_t color[QTRI_BATCH_ROOM] = {given};
            const uint32_t shade[QTRI_BATCH_ROOM] = {light};
            double expected[3];
            for (int i = 0; i < 3; i++) {
                expected[i] = channel(given, i, narrow) * light / 1024;
            }
            (narrow ? qtri_light_565 : qtri_light_888)(color, shade, 1);
            worst = fmax(worst, worst_channel(color[0], expected, narrow));
        }
    }
    return worst;
}

static void light_is_exact(void **state)
{
    (void)state;
    const double narrow = worst_light(true);
    const double wide = worst_light(false);
    print_message("light: RGB565 %.4f, 8 bits %.4f\n", narrow, wide);
    assert_true(narrow <= .501);
    assert_true(wide <= .501);
}

/* Factors of n.16, through their shades: from a channel of 0..255.0 to the product. */
static double worst_product(bool narrow)
{
    double worst = 0;
    uint64_t seed = 5;
    for (uint32_t x = 0; x < 256; x++) {
        for (int n = 0; n < 3000; n++) {
            int32_t by[3];
            for (int i = 0; i < 3; i++) {
                by[i] = n < 2 ? (n == 0 ? 0 : 255 << 16) : random_in(&seed, 0, 255 << 16);
            }
            const uint32_t given = gray(x, narrow);
            uint32_t color[QTRI_BATCH_ROOM] = {given};
            const uint32_t shade[QTRI_BATCH_ROOM] = {qtri_shade_of(by)};
            double expected[3];
            for (int i = 0; i < 3; i++) {
                expected[i] = channel(given, i, narrow) * by[i] / (255. * 65536);
            }
            (narrow ? qtri_times_565 : qtri_times_888)(color, shade, 1);
            worst = fmax(worst, worst_channel(color[0], expected, narrow));
        }
    }
    return worst;
}

static void products_are_within_three_quarters(void **state)
{
    (void)state;
    const double narrow = worst_product(true);
    const double wide = worst_product(false);
    print_message("times red green blue: RGB565 %.4f, 8 bits %.4f\n", narrow, wide);
    assert_true(narrow <= .66);
    assert_true(wide <= .75);
}

static void white_leaves_texels(void **state)
{
    (void)state;
    const int32_t white[3] = {255 << 16, 255 << 16, 255 << 16};
    assert_int_equal(qtri_shade_of(white), QTRI_SHADE_WHITE);
    for (uint32_t x = 0; x < 65536; x++) {
        uint32_t color[QTRI_BATCH_ROOM] = {x, x};
        const uint32_t shade[QTRI_BATCH_ROOM] = {QTRI_SHADE_WHITE, 1024};
        qtri_times_565(color, shade, 1);
        assert_int_equal(color[0] & 0xFFFF, x);
        color[0] = color[1] = x << 8 | (x & 255);
        qtri_times_888(color, shade, 1);
        assert_int_equal(color[0], x << 8 | (x & 255));
        color[1] = x;
        qtri_light_565(color + 1, shade + 1, 1);
        assert_int_equal(color[1] & 0xFFFF, x);
    }
}

static void conversions(void **state)
{
    (void)state;
    double narrow[3] = {0, 0, 0};
    double luma = 0;
    for (uint32_t x = 0; x < 256; x++) {
        for (uint32_t y = 0; y < 256; y += 3) {
            const uint32_t rgb = x << 16 | y << 8 | (x ^ y);
            uint32_t color[QTRI_BATCH_ROOM] = {rgb, rgb};
            qtri_888_to_565(color, 1);
            const double full[3] = {31, 63, 31};
            for (int i = 0; i < 3; i++) {
                const double exact = channel(rgb, i, false) * full[i] / 255;
                narrow[i] = fmax(narrow[i], fabs(channel(color[0], i, true) - exact));
            }
            color[0] = rgb;
            qtri_888_to_gray(color, 1);
            const double exact = .299 * x + .587 * y + .114 * (x ^ y);
            luma = fmax(luma, fabs(color[0] - exact));
        }
    }
    for (uint32_t x = 0; x < 65536; x++) {
        uint32_t color[QTRI_BATCH_ROOM] = {x};
        qtri_565_to_888(color, 1);
        assert_int_equal(color[0], qtri_decode_rgb565(x));
    }
    print_message("to RGB565: %.4f %.4f %.4f, to gray %.4f\n", narrow[0], narrow[1], narrow[2],
                  luma);
    assert_true(narrow[0] <= .61 && narrow[1] <= .70 && narrow[2] <= .61);
    assert_true(luma <= .51);
}

/* Any count gives what the fragments give one by one. */
static void counts(void **state)
{
    (void)state;
    static void (*const stages[])(uint32_t *, int32_t) = {qtri_565_to_888, qtri_888_to_565,
                                                          qtri_888_to_gray};
    static void (*const products[])(uint32_t *, const uint32_t *, int32_t) = {
        qtri_light_565, qtri_light_888, qtri_times_565, qtri_times_888};
    uint64_t seed = 77;
    for (int32_t count = 1; count <= QTRI_BATCH; count++) {
        qtri_batch given;
        for (int i = 0; i < QTRI_BATCH_ROOM; i++) {
            given.color[i] = (uint32_t)random64(&seed) & 0xFFFFFF;
            given.by.shade[i] = (uint32_t)random64(&seed) & 0x3FF;
        }
        for (size_t s = 0; s < LENGTH_OF(stages) + LENGTH_OF(products); s++) {
            const size_t p = s - LENGTH_OF(stages);
            qtri_batch together = given;
            if (s < LENGTH_OF(stages)) {
                stages[s](together.color, count);
            } else {
                products[p](together.color, together.by.shade, count);
            }
            for (int i = 0; i < count; i++) {
                uint32_t one[QTRI_BATCH_ROOM] = {given.color[i]};
                uint32_t shade[QTRI_BATCH_ROOM] = {given.by.shade[i]};
                if (s < LENGTH_OF(stages)) {
                    stages[s](one, 1);
                } else {
                    products[p](one, shade, 1);
                }
                assert_int_equal(together.color[i], one[0]);
            }
        }
    }
}

/* ---- Shades ---- */

static void curves_become_shades(void **state)
{
    (void)state;
    uint64_t seed = 3;
    for (int n = 0; n < 2000; n++) {
        const int32_t count = random_in(&seed, 1, QTRI_BATCH);
        qtri_curve c[3];
        for (int i = 0; i < 3; i++) { /* stays inside 0..255.0 */
            c[i].at = (uint32_t)random_in(&seed, 100 << 16, 150 << 16) + 0x8000u;
            c[i].step = (uint32_t)random_in(&seed, -65536, 65536);
            c[i].bend = (uint32_t)random_in(&seed, -2000, 2000);
        }
        uint32_t shade[QTRI_BATCH_ROOM];
        qtri_shade_rgb(shade, c, count);
        for (int32_t k = 0; k < count; k++) {
            for (int i = 0; i < 3; i++) {
                const double value = (int32_t)(c[i].at - 0x8000u) + (double)(int32_t)c[i].step * k +
                                     (double)(int32_t)c[i].bend * k * (k - 1) / 2;
                const double got = shade[k] >> 10 * (2 - i) & 1023;
                assert_true(fabs(got - value / 16384) <= .5);
            }
        }
        qtri_shade_light(shade, c, count);
        for (int32_t k = 0; k < count; k++) {
            const double value = (int32_t)(c[0].at - 0x8000u) + (double)(int32_t)c[0].step * k +
                                 (double)(int32_t)c[0].bend * k * (k - 1) / 2;
            assert_true(fabs(shade[k] - value / 4096) <= .5);
        }
    }
}

static void tints(void **state)
{
    (void)state;
    double worst[2] = {0, 0};
    for (uint32_t t = 0; t < 256; t++) {
        const uint32_t q10 = (t * 1024 + 127) / 255;
        const uint32_t tint_q10[3] = {q10, q10, q10};
        for (uint32_t light = 0; light <= 1024; light += t % 16 == 0 ? 1 : 7) {
            const uint32_t lights[QTRI_BATCH_ROOM] = {light};
            for (uint32_t c = 0; c < 256; c += 3) {
                uint32_t wide[QTRI_BATCH_ROOM] = {c << 16 | c << 8 | c};
                uint32_t narrow[QTRI_BATCH_ROOM] = {(c & 31) << 11 | (c & 63) << 5 | (c & 31)};
                qtri_tint_888(wide, lights, tint_q10, 1);
                qtri_tint_565(narrow, lights, tint_q10, 1);
                const double share = t / 255.0 * light / 1024;
                for (int i = 0; i < 24; i += 8) {
                    worst[0] = fmax(worst[0], fabs((wide[0] >> i & 255) - c * share));
                }
                worst[1] = fmax(worst[1], fabs((narrow[0] >> 11) - (c & 31) * share));
                worst[1] = fmax(worst[1], fabs((narrow[0] >> 5 & 63) - (c & 63) * share));
                worst[1] = fmax(worst[1], fabs((narrow[0] & 31) - (c & 31) * share));
            }
        }
    }
    print_message("tints: %.3f of 255, %.3f of RGB565\n", worst[0], worst[1]);
    assert_true(worst[0] <= .63 && worst[1] <= .54);
}

/* ---- Depth ---- */

static bool passes(qtri_compare compare, uint32_t z, uint32_t stored)
{
    switch (compare) {
    case QTRI_LESS:
        return z < stored;
    case QTRI_EQUAL:
        return z == stored;
    case QTRI_LESS_EQUAL:
        return z <= stored;
    case QTRI_GREATER:
        return z > stored;
    case QTRI_NOT_EQUAL:
        return z != stored;
    case QTRI_GREATER_EQUAL:
        return z >= stored;
    default:
        return true;
    }
}

static void depths(void **state)
{
    (void)state;
    uint64_t seed = 9;
    for (int n = 0; n < 60000; n++) {
        const qtri_compare compare = (qtri_compare)random_in(&seed, QTRI_LESS, QTRI_ALWAYS);
        const bool write = random_in(&seed, 0, 1) != 0;
        const bool late = random_in(&seed, 0, 1) != 0;
        const int32_t count = random_in(&seed, 1, 32);
        const uint32_t z = (uint32_t)random_in(&seed, 0, 6) << 16;
        const uint32_t step = (uint32_t)random_in(&seed, -1, 1) << 15;
        uint16_t stored[34];
        uint16_t expected[34];
        for (int i = 0; i < 34; i++) {
            stored[i] = expected[i] = (uint16_t)random_in(&seed, 0, 8);
        }
        uint32_t mask = 0;
        for (int32_t i = 0; i < count; i++) {
            const uint32_t top = (z + (uint32_t)i * step) >> 16;
            const bool passed = passes(compare, top, stored[1 + i]);
            mask = 2 * mask + passed;
            expected[1 + i] = passed && write ? (uint16_t)top : stored[1 + i];
        }
        const qtri_depth stages = qtri_depth_stages(compare, write, late);
        uint32_t found = qtri_mask_of(count);
        if (stages.test != NULL) {
            const uint32_t named = stages.test(stored + 1, z, step, count);
            found = stages.inverted ? found ^ named : named;
        }
        if (stages.write) {
            qtri_depth_write(stored + 1, z, step, found, count);
        }
        assert_int_equal(found, mask);
        assert_memory_equal(stored, expected, sizeof stored);
    }
}

/* ---- Clamped coordinates ---- */

/* A curve as texel_number.c follows it: what it is at each of `count` pixels. */
static void follow(uint32_t *value, qtri_curve c, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        value[i] = c.at;
        c.at += c.step;
        c.step += c.bend;
        if (i % 8 == 7) {
            c.step += c.twist;
            c.bend += 2 * c.twist;
        }
    }
}

/* Within bounds that clamped coordinates have anyway. */
static bool stays(const uint32_t *value, int32_t count)
{
    bool inside = true;
    for (int32_t i = 0; i < count; i++) {
        inside = inside && value[i] < (uint32_t)1 << 30;
    }
    return inside;
}

/* Of a texture of 16 texels, near one of whose sides the curve begins and turns round or not. */
static void make_curve(qtri_curve *c, const qtri_texel_axis *axis, uint64_t *rng)
{
    const int32_t side = axis->first + (random_flag(rng) ? axis->mask : 0);
    const int32_t step = random_in(rng, -(1 << 16), 1 << 16) >> random_in(rng, 0, 8);
    const int32_t bend = random_flag(rng) ? step / random_in(rng, 2, 200) : 0;
    const int32_t twist = random_flag(rng) ? step / random_in(rng, 2, 500) : 0;
    c->at = (uint32_t)(side * (1 << axis->texel_shift) + random_in(rng, -(1 << 18), 1 << 18));
    c->step = (uint32_t)step;
    c->bend = (uint32_t)(random_flag(rng) ? bend : -bend);
    c->twist = (uint32_t)(random_flag(rng) ? twist : -twist);
}

/* What is held for a whole row at a look leads every pixel where it leads by itself. */
static void curves_held_by_their_ends(void **state)
{
    (void)state;
    uint64_t rng = 47;
    const qtri_texel_axis axis = {.texel_shift = 16, .clamped = true, .mask = 15, .first = 1000};
    int32_t held = 0;
    for (int n = 0; n < 200000; n++) {
        uint32_t before[QTRI_BATCH];
        uint32_t after[QTRI_BATCH];
        const int32_t count = random_in(&rng, 1, QTRI_BATCH);
        qtri_curve curve;
        make_curve(&curve, &axis, &rng);
        follow(before, curve, count);
        if (!stays(before, count) || !qtri_texel_curve_held(&curve, &axis, 28, count)) {
            continue;
        }
        held++;
        follow(after, curve, count);
        for (int32_t i = 0; i < count; i++) {
            assert_int_equal(after[i] >> 28, qtri_texel_wrapped(&axis, before[i] >> 16));
        }
    }
    assert_in_range(held, 50000, 200000); /* most that may be */
}

/* None, the limit, twice that, or any up to it, with either sign. */
static int32_t near_limit(int32_t limit, uint64_t *rng)
{
    const int32_t size[4] = {0, limit, 2 * limit, random_in(rng, 0, 2 * limit)};
    const int32_t chosen = size[random_in(rng, 0, 3)];
    return random_flag(rng) ? chosen : -chosen;
}

/*
 * Of texels 0 to 14 a curve leaves none, or only its least pixel by the least there is. If a step
 * changes by 64, 32 or 16 bends at most over more than 16, more than 8 or fewer pixels, and four
 * twists are no more than such a bend, it is held in the one case; in the other, and beyond these
 * limits, only what is right is held.
 */
static void curves_that_turn_at_the_limit(void **state)
{
    (void)state;
    uint64_t rng = 48;
    const qtri_texel_axis axis = {.texel_shift = 16, .clamped = true, .mask = 15, .first = 1000};
    for (int n = 0; n < 20000; n++) {
        const int32_t count = random_in(&rng, 2, QTRI_BATCH);
        const int32_t step = random_in(&rng, 1 << 10, 1 << 13);
        const int32_t limit = step / (count > 16 ? 64 : (count > 8 ? 32 : 16));
        const int32_t bend = near_limit(limit, &rng);
        const int32_t twist = near_limit(limit / 4, &rng);
        const int32_t beyond = random_in(&rng, 0, 1);
        uint32_t pixel[QTRI_BATCH];
        qtri_curve curve = {(uint32_t)1 << 29, 0u - (uint32_t)step, (uint32_t)bend,
                            (uint32_t)twist};
        follow(pixel, curve, count);
        uint32_t least = pixel[0];
        for (int32_t i = 1; i < count; i++) {
            least = pixel[i] < least ? pixel[i] : least;
        }
        curve.at += ((uint32_t)axis.first << axis.texel_shift) - least - (uint32_t)beyond;
        follow(pixel, curve, count);
        const bool held = qtri_texel_curve_held(&curve, &axis, 28, count);
        if (abs(bend) <= limit && abs(twist) <= limit / 4) {
            assert_int_equal(held, beyond == 0);
        }
        if (held) {
            uint32_t after[QTRI_BATCH];
            follow(after, curve, count);
            for (int32_t i = 0; i < count; i++) {
                assert_int_equal(after[i] >> 28, qtri_texel_wrapped(&axis, pixel[i] >> 16));
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(light_is_exact),
        cmocka_unit_test(products_are_within_three_quarters),
        cmocka_unit_test(white_leaves_texels),
        cmocka_unit_test(conversions),
        cmocka_unit_test(counts),
        cmocka_unit_test(curves_become_shades),
        cmocka_unit_test(tints),
        cmocka_unit_test(depths),
        cmocka_unit_test(curves_held_by_their_ends),
        cmocka_unit_test(curves_that_turn_at_the_limit),
    };
    return cmocka_run_group_tests_name("core stages", tests, NULL, NULL);
}
