/* SPDX-License-Identifier: MIT */
/*
 * Smooth lines of up to two pixels: coverage against exact areas, bands and scissors, formats,
 * ends that change places, extremes; wireframes of them, whole, prepared and clipped.
 */
#include "support_core.h"

#include "raster/stroke_line.h"
#include "reference/stroke_cover.h"

enum { WIDTH = 75, HEIGHT = 53 };

typedef struct line {
    qtri_vertex v[2];
    qtri_line_color color[2];
    bool colored;
    qtri_stroke_line style;
} line;

static line random_line(uint64_t *seed)
{
    line l;
    const int32_t reach = random_in(seed, 0, 3) == 0 ? 12000 : 1500;
    int32_t x = random_in(seed, -1000, WIDTH * 256 + 1000);
    int32_t y = random_in(seed, -1000, HEIGHT * 256 + 1000);
    for (int i = 0; i < 2; i++) {
        l.v[i].at.x_24p8 = x;
        l.v[i].at.y_24p8 = y;
        l.v[i].depth_16p8 = (uint32_t)random_in(seed, 0, 65535) << 16;
        l.v[i].intensity_q15 = (uint16_t)random_in(seed, 0, 32768);
        for (int k = 0; k < 3; k++) {
            l.color[i][k] = random_in(seed, 0, 255 << 16);
        }
        x += random_in(seed, 0, 4) == 0 ? 0 : random_in(seed, -reach, reach);
        y += random_in(seed, 0, 4) == 0 ? 0 : random_in(seed, -reach, reach);
    }
    if (random_in(seed, 0, 9) == 0) {
        l.v[1].at.y_24p8 = l.v[0].at.y_24p8 + (l.v[1].at.x_24p8 - l.v[0].at.x_24p8);
    }
    l.style.radius_24p8 = random_flag(seed) ? 128 : random_in(seed, 64, 256);
    l.style.square = random_flag(seed);
    l.style.alpha = 255;
    l.colored = random_flag(seed);
    return l;
}

static void draw(const qtri_surface *surface, const qtri_material *material, const line *l,
                 bool turned)
{
    qtri_batch batch;
    qtri_line_job job;
    const qtri_line_color color[2] = {
        {l->color[1][0], l->color[1][1], l->color[1][2]},
        {l->color[0][0], l->color[0][1], l->color[0][2]},
    };
    qtri_line_job_init(&job, surface, material, &batch);
    qtri_line_make_table(&job);
    qtri_stroke_line_choose(&job, &l->style, qtri_stroke_line_draw);
    if (turned) {
        job.draw(&job, &l->v[1], &l->v[0], l->colored ? color : NULL);
    } else {
        job.draw(&job, &l->v[0], &l->v[1], l->colored ? (const qtri_line_color *)l->color : NULL);
    }
    qtri_line_flush(&job);
}

/* White on black in gray: a pixel is its coverage. */
static void coverage(void **state)
{
    (void)state;
    canvas c = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    qtri_material material = plain_material();
    uint64_t seed = 1;
    double worst = 0;
    for (int n = 0; n < 3000; n++) {
        line l = random_line(&seed);
        l.colored = false;
        l.v[0].intensity_q15 = l.v[1].intensity_q15 = 32768;
        const bool is_there =
            l.v[0].at.x_24p8 != l.v[1].at.x_24p8 || l.v[0].at.y_24p8 != l.v[1].at.y_24p8;
        const enum ref_cap cap = l.style.square ? REF_CAP_SQUARE : REF_CAP_BUTT;
        const struct ref_stroke_part part = {l.v[0].at.x_24p8 / 256.0,    l.v[0].at.y_24p8 / 256.0,
                                             l.v[1].at.x_24p8 / 256.0,    l.v[1].at.y_24p8 / 256.0,
                                             l.style.radius_24p8 / 256.0, {cap, cap}};
        canvas_clear(&c);
        draw(&c.surface, &material, &l, false);
        for (int y = 0; y < HEIGHT; y++) {
            double share[WIDTH] = {0};
            if (is_there) {
                ref_stroke_cover_row(&part, 1, y, WIDTH, share);
            }
            for (int x = 0; x < WIDTH; x++) {
                const double error = fabs(stored_pixel(&c.surface, x, y) / 255.0 - share[x]);
                if (error > 1.0 / 32) {
                    fail_msg("line %d (%d %d)-(%d %d) r %d: pixel %d %d is off by %.4f", n,
                             (int)l.v[0].at.x_24p8, (int)l.v[0].at.y_24p8, (int)l.v[1].at.x_24p8,
                             (int)l.v[1].at.y_24p8, (int)l.style.radius_24p8, x, y, error);
                }
                worst = fmax(worst, error);
            }
        }
    }
    print_message("coverage: off by %.4f at most\n", worst);
    canvas_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(coverage),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
