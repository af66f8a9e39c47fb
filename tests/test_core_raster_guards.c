/* SPDX-License-Identifier: MIT */
/*
 * Guards of the rasterizer's arithmetic, each with an input that needs it: rows that are divided
 * once, slopes of slivers, areas that snapping makes, lines that cover more than a row keeps.
 */
#include "support/core.h"

#include "raster/large_setup.h"

#include <qtri/stroke.h>

enum { WIDTH = 320, HEIGHT = 240 };

static const uint16_t texels[64] = {0xF800, 0x07E0, 0x001F, 0xFFFF, 0x8410, 0xFFE0, 0x07FF, 0xF81F};

/* x and y in 1/256 pixel, 1/w, coordinates in repeats times 2^32. */
typedef struct corner {
    int32_t x, y;
    uint32_t inv_w;
    int32_t exponent;
    int64_t u, v;
} corner;

static const struct {
    corner of[3];
    uint8_t width_log2, height_log2;
} rare[] = {
    /* A row of one 1/w whose first value rounding leaves below 0. */
    {{{-20645, 19436, 0x80000000u, -28, 1593344, -970006528},
      {-6109, 19436, 0x7FFFFFFAu, -28, 125449092, 43371991040},
      {11896, 17786, 0x80000000u, 0, 0, 0}},
     3,
     3},
    /* 1/w of a row is so small, and a repeat so short, that a step is shifted to the left. */
    {{{19804, 6528, 0x80000000u, -29, 349297377280, -88929615872},
      {76945, 6528, 0x80000000u, -29, 980224, 93},
      {26365, 27492, 0x80000000u, 0, 0, 307806208}},
     0,
     1},
    {{{74145, 30336, 1835348840, -30, -1032192, -3456},
      {30617, 30336, 1835348833, -30, 1408, 164287},
      {3508, 57063, 0x80000000u, 0, 720, 0}},
     0,
     3},
    /* A sliver whose slopes have no block of two pixels, whatever its 1/w. */
    {{{63659, -3233, 3086591233u, -16, -6144, 4096},
      {45035, 32855, 3974791540u, -18, -280763040, -2706107136},
      {59934, 3985, 2403538026u, -30, -57745143758848, 814916304896}},
     1,
     1},
    {{{34110, 61152, 1, 0, 0, 16185516032},
      {34144, 163509, 51179, 0, 6638264123392, -433182294016},
      {34028, 200845, 69847, 0, 287328, -392}},
     3,
     2},
};

/* Such triangles are the same in parts. */
TEST(rows_and_slivers)
{
    for (size_t n = 0; n < LENGTH_OF(rare); n++) {
        const qtri_texture texture = {.format = &qtri_texel_rgb565,
                                      .texels = texels,
                                      .width_log2 = rare[n].width_log2,
                                      .height_log2 = rare[n].height_log2,
                                      .wrap_v = n < 4 ? QTRI_CLAMP : QTRI_REPEAT};
        qtri_screen_vertex v[3];
        for (int i = 0; i < 3; i++) {
            const corner *at = &rare[n].of[i];
            v[i] = screen_at(at->x, at->y);
            v[i].inv_w_q31 = at->inv_w;
            v[i].inv_w_exponent = at->exponent;
            v[i].u_q32 = at->u;
            v[i].v_q32 = at->v;
        }
        qtri_material material = qtri_material_default();
        material.cull = QTRI_CULL_NONE;
        material.texture = &texture;
        canvas whole = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
        canvas parts = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
        qtri_raster_triangle(&whole.surface, qtri_pipelines_default, &material, v);
        for (int part = 0; part < 4; part++) {
            qtri_surface s = parts.surface;
            s.scissor.x0 = part & 1 ? 157 : 0;
            s.scissor.x1 = part & 1 ? WIDTH : 157;
            s.scissor.y0 = part & 2 ? 101 : 0;
            s.scissor.y1 = part & 2 ? HEIGHT : 101;
            qtri_raster_triangle(&s, qtri_pipelines_default, &material, v);
        }
        assert_same_picture(&whole.surface, &parts.surface);
        canvas_free(&whole);
        canvas_free(&parts);
    }
}

/* Where snapping made an area of a line, vertices stay where it put them; elsewhere they do not. */
TEST(areas_that_snapping_made)
{
    for (int n = 0; n < 2; n++) {
        const int32_t side = n == 0 ? 1 : 4096;
        for (int32_t less = 8192; less < 65536; less += 8192) { /* in 2^-16 of the grid's unit */
            qtri_large_vertex v[3];
            qtri_large job;
            qtri_large_input in;
            memset(v, 0, sizeof v);
            memset(&job, 0, sizeof job);
            job.in = &in;
            job.corner_x[1] = side;
            job.corner_y[2] = side;
            job.area = (int64_t)side * side;
            in.v = v;
            v[0].rest[1] = (int16_t)(less / 2);
            v[2].rest[1] = (int16_t)(-less / 2);
            qtri_large_set_weights(&job);
            assert_int_equal(job.has_true_positions, n == 1);
        }
    }
}

/* More thin lines side by side than a row keeps apart, in two groups, and nothing between. */
TEST(combs_with_a_gap)
{
    enum { TEETH = 22, RIGHT = 13, GAP = 12, GAP_END = 14, HIGH = 20 };
    static const qtri_rgb sky = {24, 40, 88};
    for (int n = 0; n < 4; n++) {
        qtri_stroke stroke = qtri_stroke_default();
        qtri_material material = qtri_material_default();
        qtri_screen_vertex v[2 * TEETH];
        canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HIGH);
        qtri_surface_clear(&c.surface, sky);
        for (int i = 0; i < 2 * TEETH; i++) { /* from the right to the left, or the other way */
            const int tooth = (n & 1) != 0 ? TEETH - 1 - i / 2 : i / 2;
            const int32_t x =
                tooth < RIGHT ? 31 * 256 - tooth * 330 : GAP * 256 - 300 - (tooth - RIGHT) * 300;
            v[i] = screen_at(x, (i + 1) / 2 % 2 == 0 ? -3000 : HIGH * 256 + 3000);
            for (int k = 0; k < 3; k++) {
                v[i].color_8p16[k] = 0;
            }
        }
        stroke.width = Q16(.25);
        material.depth_compare = QTRI_DEPTH_OFF;
        material.blend = (n & 2) != 0 ? &qtri_blend_add : NULL;
        qtri_raster_polyline(&c.surface, &material, &stroke, v, 2 * TEETH);
        const uint32_t sky888 = (uint32_t)sky.r << 16 | (uint32_t)sky.g << 8 | sky.b;
        int drawn = 0;
        for (int32_t x = 0; x < 32; x++) {
            const bool other = stored_pixel(&c.surface, x, HIGH / 2) != sky888;
            assert_false(other && x >= GAP && x < GAP_END);
            drawn += other;
        }
        assert_true((n & 2) != 0 ? drawn == 0 : drawn >= 20); /* adding black changes nothing */
        canvas_free(&c);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
