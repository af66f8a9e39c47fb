/* SPDX-License-Identifier: MIT */
/*
 * Smooth lines of up to two pixels: coverage against exact areas, bands and scissors, formats,
 * ends that change places, extremes; wireframes of them, whole, prepared and clipped.
 */
#include "support/core.h"
#include "support/layouts.h"

#include "raster/line.h"
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
    qtri_line_job job;
    qtri_stroke_target to;
    uint16_t table[QTRI_TABLE];
    const qtri_line_color color[2] = {
        {l->color[1][0], l->color[1][1], l->color[1][2]},
        {l->color[0][0], l->color[0][1], l->color[0][2]},
    };
    to.state.table = table;
    qtri_line_job_init(&job, surface, material, &to);
    qtri_stroke_line_choose(&job, surface, material, &l->style, qtri_stroke_line_draw);
    if (turned) {
        job.draw(&job, &l->v[1], &l->v[0], l->colored ? color : NULL);
    } else {
        job.draw(&job, &l->v[0], &l->v[1], l->colored ? (const qtri_line_color *)l->color : NULL);
    }
}

/* White on black in gray: a pixel is its coverage. */
TEST(coverage)
{
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

/*
 * Half of the width across, 203.50 and 180.50 of 1/256 pixel, is rounded to the nearest: of these
 * lines each pixel is its area to 1.5 steps of 255, and one is off by more where it is rounded to
 * the other side.
 */
TEST(widths_are_rounded_to_the_nearest)
{
    static const int32_t radius[2] = {256, 187}, across[2] = {1954, 693};
    canvas c = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    const qtri_material material = plain_material();
    for (int n = 0; n < 2; n++) {
        line l = {.style = {.radius_24p8 = radius[n], .square = true, .alpha = 255}};
        for (int i = 0; i < 2; i++) {
            l.v[i].at.x_24p8 = 4000 + i * 2560;
            l.v[i].at.y_24p8 = 4000 + i * across[n];
            l.v[i].intensity_q15 = 32768;
        }
        const struct ref_stroke_part part = {4000 / 256.0,      4000 / 256.0,
                                             6560 / 256.0,      (4000 + across[n]) / 256.0,
                                             radius[n] / 256.0, {REF_CAP_SQUARE, REF_CAP_SQUARE}};
        canvas_clear(&c);
        draw(&c.surface, &material, &l, false);
        for (int y = 0; y < HEIGHT; y++) {
            double share[WIDTH] = {0};
            ref_stroke_cover_row(&part, 1, y, WIDTH, share);
            for (int x = 0; x < WIDTH; x++) {
                assert_near(stored_pixel(&c.surface, x, y), 255 * share[x], 1.5);
            }
        }
    }
    canvas_free(&c);
}

/*
 * Colours are shared by length on lines that are shorter than a pixel as well: at the middle of a
 * pixel that is covered. Of a line below 1/16 of a pixel the share grows as if it had that length.
 */
TEST(short_lines_share_colors)
{
    canvas c = canvas_new(&qtri_xrgb8888, 8, 8);
    qtri_material material = plain_material();
    for (int32_t length = 4; length <= 300; length += length < 80 ? 1 : 20) {
        for (int32_t part = 0; part <= 8; part++) {
            const bool steep = (length + part) % 2 != 0;
            const int32_t before = length * part / 8;
            const int32_t start = 4 * 256 + 128 - before;
            const int32_t middle = 4 * 256 + 128;
            const qtri_line_color color[2] = {{255 << 16, 0, 40 << 16}, {0, 255 << 16, 200 << 16}};
            line l = {.colored = true, .style = {.radius_24p8 = 256, .square = true, .alpha = 255}};
            for (int i = 0; i < 2; i++) {
                const int32_t along = start + i * length;
                l.v[i].at.x_24p8 = steep ? middle : along;
                l.v[i].at.y_24p8 = steep ? along : middle;
                memcpy(l.color[i], color[i], sizeof color[i]);
            }
            canvas_clear(&c);
            draw(&c.surface, &material, &l, part % 2 != 0);
            const uint32_t pixel = stored_pixel(&c.surface, 4, 4);
            for (int k = 0; k < 3; k++) {
                const double from = color[0][k] / 65536.0, to = color[1][k] / 65536.0;
                const double expected = from + (to - from) * before / fmax(length, 16);
                const double found = pixel >> (16 - 8 * k) & 0xFF;
                if (fabs(found - expected) > 3) {
                    fail_msg("length %d, %d before: channel %d is %.0f, not %.1f", (int)length,
                             (int)before, k, found, expected);
                }
            }
        }
    }
    canvas_free(&c);
}

static void set_effects(qtri_material *material, qtri_fog *fog, uint64_t *seed)
{
    const qtri_blend *const blends[] = {NULL,
                                        &qtri_blend_alpha,
                                        &qtri_blend_add,
                                        &qtri_blend_multiply,
                                        &qtri_blend_none,
                                        &qtri_blend_replace,
                                        &qtri_blend_screen_door,
                                        &qtri_blend_vertex_add};
    const qtri_fog_range range = {Q16(.5), Q16(8), false};
    qtri_fog_exp(fog, (qtri_rgb){40, 120, 230}, range, Q16(.2));
    material->fog = random_flag(seed) ? fog : NULL;
    material->blend = blends[random_in(seed, 0, 7)];
    material->alpha = (uint8_t)random_in(seed, 0, 255);
    material->keep = (uint8_t)random_in(seed, 0, 7);
}

/* Turned round, in bands and by scissors: the same pixels, in every format, with and without depth.
 */
TEST(pieces)
{
    uint64_t seed = 2;
    for (int n = 0; n < 300; n++) {
        line l[4];
        const qtri_format *format = drawn_format(random_in(&seed, 0, 5));
        qtri_material material = plain_material();
        material.color = (qtri_rgb){255, 200, 100};
        material.depth_compare = (qtri_compare)random_in(&seed, QTRI_DEPTH_OFF, QTRI_ALWAYS);
        material.depth_read_only = random_in(&seed, 0, 3) == 0;
        qtri_fog fog;
        if (n % 3 != 0) {
            set_effects(&material, &fog, &seed);
        }
        canvas whole = canvas_new(format, WIDTH, HEIGHT);
        canvas other = canvas_new(format, WIDTH, HEIGHT);
        canvas cut = canvas_new(format, WIDTH, HEIGHT);
        canvas_clear(&whole);
        canvas_clear(&other);
        canvas_clear(&cut);
        cut.surface.scissor =
            (qtri_rect){random_in(&seed, 0, 30), random_in(&seed, 0, 20),
                        random_in(&seed, 31, WIDTH), random_in(&seed, 21, HEIGHT)};
        for (int i = 0; i < 4; i++) {
            l[i] = random_line(&seed);
            l[i].style.alpha = (uint8_t)(random_flag(&seed) ? 255 : random_in(&seed, 1, 254));
            draw(&whole.surface, &material, &l[i], false);
            draw(&other.surface, &material, &l[i], true);
            draw(&cut.surface, &material, &l[i], false);
        }
        assert_same_picture(&whole.surface, &other.surface);
        for (int32_t row = 0; row < HEIGHT; row += 9) {
            canvas band =
                canvas_band(format, WIDTH, HEIGHT, row, HEIGHT - row < 9 ? HEIGHT - row : 9);
            canvas_clear(&band);
            for (int i = 0; i < 4; i++) {
                draw(&band.surface, &material, &l[i], false);
            }
            assert_same_picture(&whole.surface, &band.surface);
            canvas_free(&band);
        }
        const qtri_rect *in = &cut.surface.scissor;
        for (int y = in->y0; y < in->y1; y++) {
            for (int x = in->x0; x < in->x1; x++) {
                assert_int_equal(stored_pixel(&cut.surface, x, y),
                                 stored_pixel(&whole.surface, x, y));
            }
        }
        canvas_free(&whole);
        canvas_free(&other);
        canvas_free(&cut);
    }
}

/* Rows may lie far apart in memory, in either direction, at the end of the largest frame. */
TEST(rows_may_lie_far_apart)
{
    enum { ROWS = 8, TOP = QTRI_SURFACE_MAX - ROWS, PITCH = 1 << 18, LINES = 40 };
    uint8_t *pixels = calloc(ROWS, PITCH);
    uint16_t *depths = calloc(ROWS, sizeof *depths * PITCH);
    canvas c = canvas_band(&qtri_rgb565, WIDTH, QTRI_SURFACE_MAX, TOP, ROWS);
    uint64_t seed = 40;
    assert_non_null(pixels);
    assert_non_null(depths);
    for (int n = 0; n < 8; n++) {
        const int32_t sign = (n & 1) != 0 ? -1 : 1;
        const bool has_depth = (n & 2) != 0;
        const ptrdiff_t first = sign < 0 ? (ROWS - 1) * PITCH : 0;
        qtri_material material = plain_material();
        qtri_surface far = c.surface;
        uint32_t drawn = 0;
        material.depth_compare = has_depth ? QTRI_LESS : QTRI_DEPTH_OFF;
        far.pixels = pixels + first;
        far.pitch = sign * PITCH;
        far.depth = depths + first;
        far.depth_pitch = sign * PITCH;
        canvas_clear(&c);
        for (int32_t y = 0; y < ROWS; y++) {
            memcpy(far.pixels + y * far.pitch, c.surface.pixels + y * c.surface.pitch, 2 * WIDTH);
            memcpy(far.depth + y * far.depth_pitch, c.surface.depth + y * c.surface.depth_pitch,
                   2 * WIDTH);
        }
        for (int i = 0; i < LINES; i++) {
            line l = random_line(&seed);
            l.colored = false;
            for (int k = 0; k < 2; k++) {
                l.v[k].at.y_24p8 = TOP * 256 + l.v[k].at.y_24p8 % (ROWS * 256);
            }
            draw(&c.surface, &material, &l, false);
            draw(&far, &material, &l, false);
        }
        for (int32_t y = 0; y < ROWS; y++) {
            assert_memory_equal(far.pixels + y * far.pitch, c.surface.pixels + y * c.surface.pitch,
                                2 * WIDTH);
            assert_memory_equal(far.depth + y * far.depth_pitch,
                                c.surface.depth + y * c.surface.depth_pitch, 2 * WIDTH);
            for (int32_t x = 0; x < WIDTH; x++) {
                drawn += stored_pixel(&c.surface, x, TOP + y) != 0;
            }
        }
        assert_true(drawn > 100);
    }
    canvas_free(&c);
    free(pixels);
    free(depths);
}

/* Where the screen door turns a pixel away, its depth stays as well. */
TEST(doors)
{
    uint64_t seed = 9;
    int turned_away = 0;
    for (int n = 0; n < 60; n++) {
        line l = random_line(&seed);
        qtri_material material = plain_material();
        canvas door = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
        canvas open = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
        material.depth_compare = QTRI_ALWAYS;
        l.colored = false;
        l.v[0].intensity_q15 = l.v[1].intensity_q15 = 32768;
        draw(&open.surface, &material, &l, false);
        material.blend = &qtri_blend_screen_door;
        material.alpha = 120;
        draw(&door.surface, &material, &l, false);
        for (int32_t y = 0; y < HEIGHT; y++) {
            for (int32_t x = 0; x < WIDTH; x++) {
                const bool drawn = stored_pixel(&door.surface, x, y) != 0;
                const uint16_t depth = stored_depth(&open.surface, x, y);
                assert_int_equal(stored_depth(&door.surface, x, y), drawn ? depth : 65535);
                turned_away += !drawn && depth != 65535;
            }
        }
        canvas_free(&door);
        canvas_free(&open);
    }
    assert_true(turned_away > 100);
}

/* Ends anywhere: nothing is written outside, and nothing overflows. */
TEST(extremes)
{
    uint64_t seed = 3;
    canvas c = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    qtri_material material = plain_material();
    material.depth_compare = QTRI_LESS;
    for (int n = 0; n < 4000; n++) {
        line l = random_line(&seed);
        const int32_t most =
            random_flag(&seed) ? QTRI_SCREEN_MAX_24P8 : 1 << random_in(&seed, 4, 22);
        for (int i = 0; i < 2; i++) {
            l.v[i].at.x_24p8 = random_in(&seed, -most, most);
            l.v[i].at.y_24p8 =
                random_in(&seed, 0, 3) == 0 ? 5000 + i : random_in(&seed, -most, most);
        }
        draw(&c.surface, &material, &l, false);
    }
    canvas_free(&c);
}

/* ---- Wireframes ---- */

enum { SIDE = 8, VERTICES = SIDE * SIDE, TRIANGLES = 2 * VERTICES };

static qtri_vec3 positions[VERTICES];
static uint16_t triangles[TRIANGLES][3];
static qtri_vertex slots[VERTICES];

/* A torus. */
static qtri_mesh torus(void)
{
    const qtri_mesh mesh = {.positions = positions,
                            .triangles = (const uint16_t(*)[3])triangles,
                            .vertex_count = VERTICES,
                            .triangle_count = TRIANGLES};
    for (int i = 0; i < VERTICES; i++) {
        const double u = i % SIDE * 6.2831853 / SIDE;
        const double v = i / SIDE * 6.2831853 / SIDE; /* NOLINT(bugprone-integer-division): a row */
        const double r = 1 + .5 * cos(v);
        const int right = i / SIDE * SIDE + (i + 1) % SIDE;
        const int up = (i + SIDE) % VERTICES;
        const int both = (right + SIDE) % VERTICES;
        const int corner[6] = {i, right, both, i, both, up};
        positions[i] = vec3_of(r * cos(u), r * sin(u), .5 * sin(v));
        for (int k = 0; k < 6; k++) {
            triangles[2 * i + k / 3][k % 3] = (uint16_t)corner[k];
        }
    }
    return mesh;
}

static void set_view(qtri_view *view, double distance)
{
    qtri_view_init(view, WIDTH, HEIGHT);
    qtri_transform_look_at(&view->camera, vec3_of(0, 0, distance), vec3_of(0, 0, 0),
                           vec3_of(0, 1, 0));
    qtri_transform_perspective(&view->projection, Q16(60), Q16(1.4), Q16(.1), Q16(50));
    give_vertices(view, slots, VERTICES);
}

/* Bands of a prepared mesh, bands of the mesh, and the whole, also where it is clipped. */
TEST(wireframes)
{
    uint64_t seed = 4;
    static uint16_t lists[QTRI_PREPARED_LISTS(TRIANGLES, HEIGHT, 7)];
    const qtri_mesh mesh = torus();
    for (int n = 0; n < 60; n++) {
        qtri_view view;
        qtri_transform pose;
        qtri_prepared prepared;
        const qtri_format *format = drawn_format(n % 6);
        qtri_material material = qtri_material_default();
        material.fill = &qtri_smooth_wireframe;
        material.color = (qtri_rgb){250, 220, 120};
        material.cull = n % 2 == 0 ? QTRI_CULL_BACK : QTRI_CULL_NONE;
        material.depth_compare = n % 3 == 0 ? QTRI_DEPTH_OFF : QTRI_LESS;
        set_view(&view, n % 5 == 0 ? 1.2 : 3);
        qtri_transform_identity(&pose);
        qtri_transform_rotate_y(&pose, random_in(&seed, 0, 360 << 16));
        canvas whole = canvas_new(format, WIDTH, HEIGHT);
        canvas_clear(&whole);
        qtri_draw_mesh(&whole.surface, &view, &pose, &mesh, &material);
        const qtri_frame frame = {.width = WIDTH, .height = HEIGHT, .rows = 7, .format = format};
        prepared_init_with(&prepared, slots, VERTICES, lists, sizeof lists / sizeof lists[0]);
        for (int way = 0; way < 2; way++) {
            if (way == 1) {
                qtri_prepare_mesh(&prepared, &frame, &view, &pose, &mesh, &material);
            }
            for (int32_t row = 0; row < HEIGHT; row += 7) {
                canvas band =
                    canvas_band(format, WIDTH, HEIGHT, row, HEIGHT - row < 7 ? HEIGHT - row : 7);
                canvas_clear(&band);
                if (way == 1) {
                    qtri_draw_prepared(&band.surface, &prepared);
                } else {
                    qtri_draw_mesh(&band.surface, &view, &pose, &mesh, &material);
                }
                assert_same_picture(&whole.surface, &band.surface);
                canvas_free(&band);
            }
        }
        canvas_free(&whole);
    }
}

/* Channels that a material keeps are as they were, and others whatever else is kept. */
TEST(kept_channels)
{
    static const uint32_t mask[3] = {0xF800, 0x07E0, 0x001F}; /* of RGB565 */
    static const uint8_t kept[3] = {QTRI_KEEP_RED, QTRI_KEEP_GREEN, QTRI_KEEP_BLUE};
    const qtri_mesh mesh = torus();
    qtri_view view;
    qtri_transform pose;
    canvas c[8]; /* of what is kept; the first is without lines */
    int drawn = 0;
    set_view(&view, 3);
    qtri_transform_identity(&pose);
    qtri_transform_rotate_y(&pose, Q16(40));
    for (int keep = 0; keep < 8; keep++) {
        qtri_material material = qtri_material_default();
        c[keep] = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
        clear_to(&c[keep].surface, (qtri_rgb){90, 30, 170}, 65535);
        material.fill = &qtri_smooth_wireframe;
        material.color = (qtri_rgb){250, 220, 120};
        material.blend = &qtri_blend_replace;
        for (int k = 0; k < 3; k++) {
            material.keep |= (uint8_t)((keep >> k & 1) != 0 ? kept[k] : 0);
        }
        if (keep != 0) {
            qtri_draw_mesh(&c[keep].surface, &view, &pose, &mesh, &material);
        }
    }
    for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
        uint32_t is[8];
        for (int keep = 0; keep < 8; keep++) {
            is[keep] = stored_pixel(&c[keep].surface, i % WIDTH, i / WIDTH);
        }
        for (int k = 0; k < 3; k++) {
            const uint32_t alone = is[1 << (k + 1) % 3]; /* another is kept */
            for (int keep = 1; keep < 8; keep++) {
                const uint32_t want = (keep >> k & 1) != 0 ? is[0] : alone;
                assert_int_equal(is[keep] & mask[k], want & mask[k]);
            }
            drawn += ((alone ^ is[0]) & mask[k]) != 0;
        }
    }
    assert_true(drawn > 500);
    for (int keep = 0; keep < 8; keep++) {
        canvas_free(&c[keep]);
    }
}

/* An edge that two triangles share is blended once: as of thin strokes, and as of either alone. */
TEST(shared_edges)
{
    const qtri_vec3 square[4] = {vec3_of(-1, -1, 0), vec3_of(1, -.9, 0), vec3_of(.8, 1, 0),
                                 vec3_of(-1.1, .7, 0)};
    const uint16_t two[2][3] = {{0, 1, 2}, {0, 2, 3}};
    qtri_mesh mesh = {
        .positions = square, .triangles = two, .vertex_count = 4, .triangle_count = 2};
    qtri_view view;
    qtri_transform pose;
    qtri_material material = qtri_material_default();
    canvas both = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    canvas one = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    canvas stroked = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    set_view(&view, 3);
    qtri_transform_identity(&pose);
    material.fill = &qtri_smooth_wireframe;
    for (int compare = QTRI_DEPTH_OFF; compare <= QTRI_ALWAYS; compare++) {
        material.depth_compare = (qtri_compare)compare;
        if (compare == QTRI_NEVER || compare == QTRI_EQUAL || compare == QTRI_NOT_EQUAL) {
            continue;
        }
        qtri_stroke stroke = qtri_stroke_default();
        stroke.cap = QTRI_CAP_BUTT;
        canvas_clear(&both);
        canvas_clear(&one);
        canvas_clear(&stroked);
        mesh.triangle_count = 2;
        qtri_draw_mesh(&both.surface, &view, &pose, &mesh, &material);
        qtri_draw_wide_wireframe(&stroked.surface, &view, &pose, &mesh, &stroke, &material);
        mesh.triangle_count = 1;
        qtri_draw_mesh(&one.surface, &view, &pose, &mesh, &material);
        assert_same_picture(&both.surface, &stroked.surface);
        /* On the diagonal, far from its ends. */
        for (int y = HEIGHT / 2 - 4; y < HEIGHT / 2 + 4; y++) {
            for (int x = WIDTH / 2 - 4; x < WIDTH / 2 + 4; x++) {
                assert_int_equal(stored_pixel(&both.surface, x, y),
                                 stored_pixel(&one.surface, x, y));
            }
        }
    }
    canvas_free(&both);
    canvas_free(&one);
    canvas_free(&stroked);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
