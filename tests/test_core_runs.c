/*
 * The loops made from a template draw the generic loop's pixels to the bit.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "raster/span.h"
#include "support_core.h"

enum { WIDTH = 61 };

struct row {
    uint32_t pixels[WIDTH]; /* of any format */
    uint16_t depths[WIDTH];
};

static void random_row(struct row *row, uint64_t *seed)
{
    for (int i = 0; i < WIDTH; i++) {
        row->pixels[i] = (uint32_t)random_in(seed, INT32_MIN, INT32_MAX);
        row->depths[i] = (uint16_t)random_in(seed, 0, 65535);
    }
}

/* Ramps that stay in range over the run: n.16, `max` the largest channel value. */
static void random_ramp(uint64_t *seed, int32_t max, int32_t count, uint32_t *start, uint32_t *step)
{
    int32_t from = (int32_t)random_in(seed, 0, max);
    int32_t to = (int32_t)random_in(seed, 0, max);
    *start = (uint32_t)from + 0x8000u;
    *step = (uint32_t)((to - from) / count);
}

static void loops_equal_generic(void **state)
{
    (void)state;
    static const int32_t white[3][3] = {{31 << 16, 63 << 16, 31 << 16},
                                        {255 << 16, 255 << 16, 255 << 16},
                                        {QTRI_GRAY_RED, QTRI_GRAY_GREEN, QTRI_GRAY_BLUE}};
    uint64_t seed = 7;
    int fast = 0;
    for (int n = 0; n < 40000; n++) {
        qtri_surface surface = {.format = (qtri_format)(n % 3)};
        qtri_span_job job;
        qtri_run run;
        struct row rows[2];
        memset(&job, 0, sizeof job);
        memset(&run, 0, sizeof run);
        job.surface = &surface;
        job.compare = (qtri_compare)random_in(&seed, 0, 8);
        if (n % 2 == 0) {
            job.compare = n % 4 == 0 ? QTRI_LESS : QTRI_DEPTH_OFF;
        }
        job.depth_write = random_in(&seed, 0, 3) != 0;
        job.smooth = random_in(&seed, 0, 1) != 0;
        job.paint = !job.smooth                   ? QTRI_PAINT_FLAT
                    : random_in(&seed, 0, 1) != 0 ? QTRI_PAINT_LINEAR
                                                  : QTRI_PAINT_PERSPECTIVE;
        job.pixel = (uint32_t)random_in(&seed, 0, INT32_MAX);
        run.x = (int32_t)random_in(&seed, 0, WIDTH - 1);
        run.count = (int32_t)random_in(&seed, 1, WIDTH - run.x);
        random_ramp(&seed, INT32_MAX - 65536, run.count, &run.z, &job.depth.dx);
        for (int i = 0; i < 3; i++) {
            random_ramp(&seed, white[n % 3][i], run.count, &run.color[i], &run.color_step[i]);
        }
        random_row(&rows[0], &seed);
        rows[1] = rows[0];

        qtri_run_loop loop = qtri_run_choose(&job);
        fast += loop != qtri_run_generic;
        run.pixels = (uint8_t *)rows[0].pixels;
        run.depths = rows[0].depths;
        qtri_run_generic(&job, &run);
        run.pixels = (uint8_t *)rows[1].pixels;
        run.depths = rows[1].depths;
        loop(&job, &run);
        assert_memory_equal(rows[0].pixels, rows[1].pixels, sizeof rows[0].pixels);
        assert_memory_equal(rows[0].depths, rows[1].depths, sizeof rows[0].depths);
    }
    assert_in_range(fast, 10000, 39000); /* the template's loops were among them */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(loops_equal_generic),
    };
    return cmocka_run_group_tests_name("core runs", tests, NULL, NULL);
}
