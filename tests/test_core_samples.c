/* SPDX-License-Identifier: MIT */
/*
 * Surfaces of four samples a pixel: samples against plain surfaces that are moved, colours in
 * range, no seams, blends, prepared meshes, resolves.
 */
#include "support/core.h"
#include "support/layouts.h"

#include "support/shares.h"
#include "support/triangle.h"

#include "raster/samples.h"

enum { WIDTH = 61, HEIGHT = 47, FORMATS = 5 };

static const qtri_format *const plain[FORMATS] = {&qtri_rgb565, &qtri_rgb565_swapped,
                                                  &qtri_xrgb8888, &qtri_rgb888, &qtri_gray8};
static const qtri_format *const four[FORMATS] = {
    &qtri_rgb565_x4, &qtri_rgb565_swapped_x4, &qtri_xrgb8888_x4, &qtri_rgb888_x4, &qtri_gray8_x4};
static const int32_t offsets[4][2] = {{-32, -96}, {96, -32}, {-96, 32}, {32, 96}};

static uint32_t sample_at(const qtri_surface *s, int32_t x, int32_t y, int k)
{
    const int32_t size = s->format->pixels->bytes;
    const uint8_t *record = s->pixels + (y - s->first_row) * s->pitch + (ptrdiff_t)x * size;
    return qtri_sample_color(record, qtri_sample_bytes(size), k);
}

static int kinds[3]; /* triangles of each */

static void count_triangle(int kind)
{
    kinds[kind]++;
}

/* Any size, from dots to more than the frame; colours within a range. */
static void random_triangle(qtri_screen_vertex v[3], uint64_t *seed, int32_t low, int32_t high)
{
    static const int32_t reaches[4] = {300, 1500, 4000, 12300};
    const int32_t reach = reaches[random_in(seed, 0, 3)];
    const int32_t grid = random_flag(seed) ? 31 : 0; /* vertices, and edges, lie on samples */
    const int32_t x = random_in(seed, -2000, WIDTH * 256 + 2000);
    const int32_t y = random_in(seed, -2000, HEIGHT * 256 + 2000);
    const bool gentle = random_flag(seed); /* depths of samples are moved, not set up */
    const bool near = random_flag(seed);   /* as small triangles are, where their size is */
    for (int i = 0; i < 3; i++) {
        v[i] = screen_at((x + random_in(seed, -reach, reach)) & ~grid,
                         (y + random_in(seed, -reach, reach)) & ~grid);
        v[i].depth_16p16 = (uint32_t)random_in(seed, 0, gentle ? 700 : 65535) << 16;
        v[i].inv_w_q31 = (uint32_t)(near ? random_in(seed, 16 << 26, 17 << 26)
                                         : random_in(seed, 1 << 29, INT32_MAX));
        for (int k = 0; k < 3; k++) {
            v[i].color_8p16[k] = random_in(seed, low, high) << 16;
        }
    }
    if (random_in(seed, 0, 3) == 0) { /* a sliver */
        v[2].x_24p8 = (v[0].x_24p8 + v[1].x_24p8) / 2 + random_in(seed, -20, 20);
        v[2].y_24p8 = (v[0].y_24p8 + v[1].y_24p8) / 2 + random_in(seed, -20, 20);
    }
}

/* A random triangle, and on plain surfaces moved so that each sample lies where centres do. */
static void draw_moved(const canvas *c, const canvas moved[4], const qtri_material *material,
                       uint64_t *seed)
{
    qtri_screen_vertex v[3];
    random_triangle(v, seed, 0, 255);
    count_triangle(draw_triangle(&c->surface, material, v, true));
    for (int k = 0; k < 4; k++) {
        qtri_screen_vertex w[3] = {v[0], v[1], v[2]};
        for (int j = 0; j < 3; j++) {
            w[j].x_24p8 -= offsets[k][0];
            w[j].y_24p8 -= offsets[k][1];
        }
        count_triangle(draw_triangle(&moved[k].surface, material, w, true));
    }
}

/* Flat and without depth: each sample is a plain surface's, drawn with the triangle moved. */
TEST(coverage)
{
    uint64_t seed = 1;
    for (int n = 0; n < 200; n++) {
        canvas c = canvas_new(four[n % FORMATS], WIDTH, HEIGHT);
        canvas moved[4];
        qtri_material material = plain_material();
        const qtri_rgb sky = {10, 20, 30};
        material.shading = QTRI_FLAT_LAST;
        material.depth_compare = n % 2 == 0 ? QTRI_DEPTH_OFF : QTRI_ALWAYS;
        qtri_samples_clear(&c.surface, sky);
        for (int k = 0; k < 4; k++) {
            moved[k] = canvas_new(plain[n % FORMATS], WIDTH, HEIGHT);
            qtri_surface_clear(&moved[k].surface, sky);
        }
        for (int i = 0; i < 8; i++) {
            draw_moved(&c, moved, &material, &seed);
        }
        for (int k = 0; k < 4; k++) {
            for (int y = 0; y < HEIGHT; y++) {
                for (int x = 0; x < WIDTH; x++) {
                    assert_int_equal(sample_at(&c.surface, x, y, k),
                                     stored_pixel(&moved[k].surface, x, y));
                }
            }
            canvas_free(&moved[k]);
        }
        canvas_free(&c);
    }
}

/* Depth: nearly always the sample of the moved picture; where two are as near either may win. */
TEST(depths)
{
    uint64_t seed = 7;
    long wrong = 0;
    long all = 0;
    for (int n = 0; n < 60; n++) {
        canvas c = canvas_new(four[n % FORMATS], WIDTH, HEIGHT);
        canvas moved[4];
        qtri_material material = plain_material();
        const qtri_rgb sky = {10, 20, 30};
        material.shading = QTRI_FLAT_LAST;
        material.depth_compare = QTRI_LESS;
        qtri_samples_clear(&c.surface, sky);
        for (int k = 0; k < 4; k++) {
            moved[k] = canvas_new(plain[n % FORMATS], WIDTH, HEIGHT);
            qtri_surface_clear(&moved[k].surface, sky);
        }
        for (int i = 0; i < 40; i++) {
            draw_moved(&c, moved, &material, &seed);
        }
        for (int k = 0; k < 4; k++) {
            for (int i = 0; i < WIDTH * HEIGHT; i++, all++) {
                wrong += sample_at(&c.surface, i % WIDTH, i / WIDTH, k) !=
                         stored_pixel(&moved[k].surface, i % WIDTH, i / WIDTH);
            }
            canvas_free(&moved[k]);
        }
        canvas_free(&c);
    }
    print_message("%ld of %ld samples differ\n", wrong, all);
    assert_true(wrong * 100000 < all);
}

/* Colours stay between those of the vertices, at edges too, and with perspective. */
TEST(range)
{
    uint64_t seed = 3;
    for (int n = 0; n < 400; n++) {
        canvas c = canvas_new(&qtri_xrgb8888_x4, WIDTH, HEIGHT);
        qtri_material material = plain_material();
        qtri_screen_vertex v[3];
        const qtri_rgb sky = {128, 128, 128};
        qtri_samples_clear(&c.surface, sky);
        material.interpolation = n % 2 == 0 ? QTRI_PERSPECTIVE : QTRI_SCREEN_LINEAR;
        material.shading = QTRI_SMOOTH;
        random_triangle(v, &seed, 100, 150);
        count_triangle(draw_triangle(&c.surface, &material, v, true));
        for (int i = 0; i < WIDTH * HEIGHT * 4; i++) {
            const uint32_t stored = sample_at(&c.surface, i / 4 % WIDTH, i / 4 / WIDTH, i % 4);
            for (int k = 0; k < 24; k += 8) {
                assert_in_range(stored >> k & 255, 99, 151);
            }
        }
        canvas_free(&c);
    }
}

/* Coordinates stay between those of the vertices: texels beside those of the triangle are red. */
TEST(texels)
{
    enum { SIDE = 64, FIRST = 20, END = 44 };
    static uint32_t texel[SIDE * SIDE];
    uint64_t seed = 13;
    for (int i = 0; i < SIDE * SIDE; i++) {
        const bool inside =
            i % SIDE >= FIRST && i % SIDE < END && i / SIDE >= FIRST && i / SIDE < END;
        texel[i] = inside ? 0x00FF40 : 0xFF0000;
    }
    for (int n = 0; n < 600; n++) {
        canvas c = canvas_new(&qtri_xrgb8888_x4, WIDTH, HEIGHT);
        const qtri_wrap wrap = n % 3 == 0 ? QTRI_CLAMP : QTRI_REPEAT;
        const int32_t margin = n % 5 == 0 ? 1 : 0; /* a filter takes half a texel more */
        const qtri_texture texture = {.texels = texel,
                                      .format = &qtri_texel_xrgb8888,
                                      .filter = margin != 0 ? &qtri_bilinear : NULL,
                                      .width_log2 = 6,
                                      .height_log2 = 6,
                                      .wrap_u = wrap,
                                      .wrap_v = wrap};
        qtri_material material = plain_material();
        qtri_screen_vertex v[3];
        material.texture = &texture;
        material.texture_mode = n % 7 == 0 ? QTRI_REPLACE : QTRI_MODULATE;
        material.shading = n % 4 == 0 ? QTRI_FLAT_LAST : QTRI_SMOOTH;
        material.interpolation = n % 2 == 0 ? QTRI_PERSPECTIVE : QTRI_SCREEN_LINEAR;
        qtri_samples_clear(&c.surface, (qtri_rgb){0, 0, 0});
        random_triangle(v, &seed, 100, 150);
        for (int i = 0; i < 3; i++) {
            v[i].u_q32 = (int64_t)random_in(&seed, (FIRST + margin) << 16, (END - margin) << 16)
                         << 10;
            v[i].v_q32 = (int64_t)random_in(&seed, (FIRST + margin) << 16, (END - margin) << 16)
                         << 10;
        }
        count_triangle(draw_triangle(&c.surface, &material, v, true));
        for (int i = 0; i < WIDTH * HEIGHT * 4; i++) {
            assert_true(sample_at(&c.surface, i / 4 % WIDTH, i / 4 / WIDTH, i % 4) >> 16 < 3);
        }
        canvas_free(&c);
    }
}

/* Texture coordinates, in texels, at a place of the screen in 1/256 pixel. */
static void exact_texel(double at[2], const qtri_screen_vertex v[3], double x, double y,
                        int side_log2)
{
    double b[3];
    shares_at_place(b, v, x, y, true);
    at[0] = at[1] = 0;
    for (int i = 0; i < 3; i++) {
        at[0] += b[i] * ldexp((double)v[i].u_q32, side_log2 - 32);
        at[1] += b[i] * ldexp((double)v[i].v_q32, side_log2 - 32);
    }
}

/* 1: the place lies inside of all edges, 0: outside of one, -1: on one of them. */
static int covers(const qtri_screen_vertex v[3], int32_t x, int32_t y)
{
    int positive = 0, negative = 0;
    for (int i = 0; i < 3; i++) {
        const qtri_screen_vertex *a = &v[i], *b = &v[(i + 1) % 3];
        const int64_t side = (int64_t)(b->x_24p8 - a->x_24p8) * (y - a->y_24p8) -
                             (int64_t)(b->y_24p8 - a->y_24p8) * (x - a->x_24p8);
        positive += side > 0;
        negative += side < 0;
    }
    return positive + negative < 3 ? -1 : positive == 0 || negative == 0;
}

/* Some pixels wide, with many texels a pixel and 1/w that changes by a sixteenth and more. */
static void random_curved_triangle(qtri_screen_vertex v[3], uint64_t *seed)
{
    const int32_t reach = random_in(seed, 900, 2500);
    const int32_t texels = random_in(seed, 20, 110);
    const uint32_t q = (uint32_t)random_in(seed, 18 << 26, 25 << 26);
    for (int i = 0; i < 3; i++) {
        const int32_t part = i == 0 ? 0 : random_in(seed, 1 << 26, 2 << 26);
        const int32_t x = random_in(seed, -reach, reach);
        const int32_t y = random_in(seed, -reach, reach);
        v[i] = screen_at(WIDTH * 128 + x, HEIGHT * 128 + y);
        v[i].inv_w_q31 = random_flag(seed) ? q + (uint32_t)part : q - (uint32_t)part;
        v[i].u_q32 = (int64_t)(128 * 65536 + random_in(seed, -texels * 65536, texels * 65536)) << 8;
        v[i].v_q32 = (int64_t)(128 * 65536 + random_in(seed, -texels * 65536, texels * 65536)) << 8;
    }
}

/* A pixel takes its texel at its centre or, where that is not covered, at the first sample that
   is, along texture coordinates that are curved on the screen. */
TEST(texels_are_those_of_the_place)
{
    enum { SIDE_LOG2 = 8, SIDE = 1 << SIDE_LOG2 };
    static uint32_t texel[SIDE * SIDE];
    uint64_t seed = 17;
    double worst[2] = {0, 0};
    long count[2] = {0, 0};
    int small = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        texel[i] = (uint32_t)(i % SIDE) << 16 | (uint32_t)(i / SIDE) << 8 | 0xFF;
    }
    canvas c = canvas_new(&qtri_xrgb8888_x4, WIDTH, HEIGHT);
    for (int n = 0; n < 8000; n++) {
        qtri_texture texture = {.texels = texel,
                                .format = &qtri_texel_xrgb8888,
                                .width_log2 = SIDE_LOG2,
                                .height_log2 = SIDE_LOG2};
        qtri_material material = plain_material();
        qtri_screen_vertex v[3];
        texture.wrap_u = n % 3 == 0 ? QTRI_CLAMP : QTRI_REPEAT;
        texture.wrap_v = n % 5 == 0 ? QTRI_CLAMP : QTRI_REPEAT;
        material.texture = &texture;
        material.texture_mode = QTRI_REPLACE;
        random_curved_triangle(v, &seed);
        qtri_samples_clear(&c.surface, (qtri_rgb){0, 0, 0});
        const int64_t area = (int64_t)(v[1].x_24p8 - v[0].x_24p8) * (v[2].y_24p8 - v[0].y_24p8) -
                             (int64_t)(v[2].x_24p8 - v[0].x_24p8) * (v[1].y_24p8 - v[0].y_24p8);
        if (llabs(area) < 70 << 16 ||
            draw_triangle(&c.surface, &material, v, true) != TRIANGLE_SMALL) {
            continue;
        }
        small++;
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            const int32_t x = i % WIDTH, y = i / WIDTH;
            int k = 0;
            while (k < 4 && sample_at(&c.surface, x, y, k) == 0) {
                k++;
            }
            const int inside = covers(v, x * 256 + 128, y * 256 + 128);
            if (k == 4 || inside < 0) {
                continue;
            }
            double there[2], opposite[2], center[2];
            const int32_t dx = inside ? 0 : offsets[k][0], dy = inside ? 0 : offsets[k][1];
            exact_texel(there, v, x * 256 + 128 + dx, y * 256 + 128 + dy, SIDE_LOG2);
            exact_texel(opposite, v, x * 256 + 128 - dx, y * 256 + 128 - dy, SIDE_LOG2);
            exact_texel(center, v, x * 256 + 128, y * 256 + 128, SIDE_LOG2);
            const uint32_t found = sample_at(&c.surface, x, y, k);
            for (int j = 0; j < 2; j++) {
                const double got = found >> (16 - 8 * j) & 255;
                const double error = fmax(fmax(got - there[j], there[j] - got - 1), 0) -
                                     fabs(there[j] + opposite[j] - 2 * center[j]);
                worst[inside] = fmax(worst[inside], error);
                count[inside]++;
            }
        }
    }
    print_message(
        "%d small triangles: off by %.4f texel of %ld at centres, %.4f of %ld at samples\n", small,
        worst[1], count[1], worst[0], count[0]);
    assert_true(small > 300);
    assert_true(worst[0] <= 1.0 / 16 && worst[1] <= 1.0 / 16);
    canvas_free(&c);
}

/* From the slopes of a curve at the centre, an eighth and three of their steps, rounded down once.
 */
TEST(places_of_a_curve_are_rounded_once)
{
    uint64_t seed = 19;
    for (int n = 0; n < 1000; n++) {
        qtri_small_curve c = {0};
        const uint32_t x = (uint32_t)random_in(&seed, -60, 60);
        const int32_t dx = random_in(&seed, INT32_MIN, INT32_MAX);
        const int32_t dy = random_in(&seed, INT32_MIN, INT32_MAX);
        c.at = (uint32_t)random_bits32(&seed);
        c.xx = (uint32_t)random_bits32(&seed);
        c.xy = (uint32_t)random_bits32(&seed);
        c.dx = (uint32_t)dx - 2 * x * c.xx;
        c.dy = (uint32_t)dy - x * c.xy;
        const uint32_t center = c.at + x * (c.dx + x * c.xx);
        const uint32_t p = (uint32_t)(((int64_t)(dx >> 1) + 3 * (int64_t)(dy >> 1)) >> 2);
        const uint32_t q = (uint32_t)((3 * (int64_t)(dx >> 1) - (int64_t)(dy >> 1)) >> 2);
        const uint32_t want[QTRI_PLACES] = {center - p, center + q, center - q, center + p, center};
        for (int32_t place = 0; place < QTRI_PLACES; place++) {
            assert_int_equal(qtri_small_curve_at_place(&c, x, place), want[place]);
        }
    }
}

/* A square of two triangles of one colour: no sample is left out along their edge, none twice. */
TEST(seams)
{
    uint64_t seed = 5;
    for (int n = 0; n < 100; n++) {
        canvas c = canvas_new(&qtri_rgb565_x4, WIDTH, HEIGHT);
        qtri_material material = plain_material();
        material.blend = &qtri_blend_add;
        qtri_samples_clear(&c.surface, (qtri_rgb){0, 0, 0});
        qtri_screen_vertex v[4];
        const int32_t far_x = WIDTH * 256 + 300;
        const int32_t far_y = HEIGHT * 256 + 300;
        v[0] = screen_at(-300, random_in(&seed, -2000, -300));
        v[1] = screen_at(random_in(&seed, far_x, far_x + 999), -300);
        v[2] = screen_at(far_x + 1500, far_y);
        v[3] = screen_at(-random_in(&seed, 300, 2000), far_y + 200);
        for (int i = 0; i < 4; i++) {
            for (int k = 0; k < 3; k++) {
                v[i].color_8p16[k] = 132 << 16;
            }
        }
        const qtri_screen_vertex first[3] = {v[0], v[1], v[2]};
        const qtri_screen_vertex second[3] = {v[0], v[2], v[3]};
        count_triangle(draw_triangle(&c.surface, &material, first, true));
        count_triangle(draw_triangle(&c.surface, &material, second, true));
        const uint32_t want = sample_at(&c.surface, 30, 5, 0);
        assert_int_equal(want, 16 << 11 | 33 << 5 | 16);
        for (int i = 0; i < WIDTH * HEIGHT * 4; i++) {
            assert_int_equal(sample_at(&c.surface, i / 4 % WIDTH, i / 4 / WIDTH, i % 4), want);
        }
        canvas_free(&c);
    }
}

/* The mean of four, in each format's steps; of other surfaces an error. */
TEST(resolve)
{
    uint64_t seed = 11;
    for (int f = 0; f < FORMATS; f++) {
        canvas c = canvas_new(four[f], WIDTH, HEIGHT);
        canvas copy = canvas_new(four[f], WIDTH, HEIGHT);
        qtri_surface out;
        qtri_material material = plain_material();
        canvas *both[2] = {&c, &copy};
        const uint64_t from = seed;
        for (int i = 0; i < 2; i++) {
            seed = from;
            qtri_samples_clear(&both[i]->surface, (qtri_rgb){40, 90, 200});
            for (int n = 0; n < 20; n++) {
                qtri_screen_vertex v[3];
                random_triangle(v, &seed, 0, 255);
                count_triangle(draw_triangle(&both[i]->surface, &material, v, true));
            }
        }
        assert_ok(qtri_samples_resolve(&c.surface, &out));
        assert_true(out.format == plain[f] && out.depth == NULL);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            const int x = i % WIDTH;
            const int y = i / WIDTH;
            const qtri_rgb got = qtri_surface_pixel(&out, x, y);
            const int channel[3] = {got.r, got.g, got.b};
            for (int k = 0; k < 3; k++) {
                double mean = 0;
                for (int s = 0; s < 4; s++) {
                    const uint32_t color = plain[f]->decode(sample_at(&copy.surface, x, y, s));
                    mean += (color >> (16 - 8 * k) & 255) / 4.0;
                }
                assert_true(fabs(mean - channel[k]) <= (f < 2 ? 5.2 : .51));
            }
        }
        assert_int_equal(qtri_samples_resolve(&out, &out), QTRI_ERROR_FORMAT);
        canvas_free(&c);
        canvas_free(&copy);
    }
}

static void assert_samples(const qtri_surface *whole, const qtri_surface *part, qtri_rect in)
{
    for (int32_t y = in.y0; y < in.y1; y++) {
        for (int32_t x = in.x0; x < in.x1; x++) {
            for (int k = 0; k < 4; k++) {
                assert_int_equal(sample_at(whole, x, y, k), sample_at(part, x, y, k));
            }
        }
    }
}

static qtri_vec3 positions[64];
static qtri_normal normals[64];
static uint16_t triangles[126][3];
static qtri_vertex slots[64];

static qtri_mesh random_mesh(uint64_t *seed)
{
    const qtri_mesh mesh = {.positions = positions,
                            .normals = normals,
                            .triangles = (const uint16_t(*)[3])triangles,
                            .vertex_count = 64,
                            .triangle_count = 98};
    for (int i = 0; i < 64; i++) {
        positions[i] = vec3_of(i % 8 * .4 - 1.5, i / 8 * .4 - 1.5, random_in(seed, -99, 99) / 80.);
        normals[i].x = (int16_t)random_in(seed, -9000, 9000);
        normals[i].y = (int16_t)random_in(seed, -9000, 9000);
        normals[i].z = (int16_t)random_in(seed, 4000, 12000);
    }
    for (int i = 0, n = 0; i < 49; i++) {
        const int at = i / 7 * 8 + i % 7;
        const int corner[6] = {at, at + 1, at + 9, at, at + 9, at + 8};
        for (int k = 0; k < 6; k++) {
            triangles[n + k / 3][k % 3] = (uint16_t)corner[k];
        }
        n += 2;
    }
    return mesh;
}

/* A lit mesh that reaches out of the frame and through the near plane, prepared: in bands, and
   within a scissor. */
TEST(prepared_meshes)
{
    uint64_t seed = 21;
    static uint16_t lists[QTRI_PREPARED_LISTS(98, HEIGHT, 5)];
    for (int n = 0; n < 24; n++) {
        const qtri_format *format = four[n % FORMATS];
        canvas whole = canvas_new(format, WIDTH, HEIGHT);
        qtri_mesh mesh = random_mesh(&seed);
        qtri_view view;
        qtri_light light = {.towards = vec3_of(.3, .5, .8), .ambient = Q16(.2), .diffuse = Q16(.8)};
        qtri_transform pose;
        qtri_material material = qtri_material_default();
        material.color = (qtri_rgb){255, 180, 90};
        material.cull = n % 4 == 0 ? QTRI_CULL_NONE : QTRI_CULL_BACK;
        material.shading = n % 3 == 0 ? QTRI_FLAT_LAST : QTRI_SMOOTH;
        qtri_view_init(&view, WIDTH, HEIGHT);
        qtri_transform_look_at(&view.camera, vec3_of(0, 0, n % 6 == 0 ? .9 : 3), vec3_of(0, 0, 0),
                               vec3_of(0, 1, 0));
        qtri_transform_perspective(&view.projection, Q16(60), Q16(1.3), Q16(.1), Q16(50));
        view.light = &light;
        give_vertices(&view, slots, 64);
        qtri_transform_identity(&pose);
        qtri_transform_rotate_y(&pose, random_in(&seed, 0, 60 << 16));
        qtri_samples_clear(&whole.surface, (qtri_rgb){24, 32, 48});
        qtri_draw_mesh(&whole.surface, &view, &pose, &mesh, &material);
        qtri_frame frame = {.width = WIDTH, .height = HEIGHT, .rows = 5, .format = format};
        qtri_prepared prepared;
        prepared_init_with(&prepared, slots, 64, lists, sizeof lists / sizeof lists[0]);
        qtri_prepare_mesh(&prepared, &frame, &view, &pose, &mesh, &material);
        for (int32_t row = 0; row < HEIGHT; row += 5) {
            const int32_t end = row + 5 < HEIGHT ? row + 5 : HEIGHT;
            canvas band = canvas_band(format, WIDTH, HEIGHT, row, end - row);
            qtri_samples_clear(&band.surface, (qtri_rgb){24, 32, 48});
            qtri_draw_prepared(&band.surface, &prepared);
            const qtri_rect rows = {0, row, WIDTH, end};
            assert_samples(&whole.surface, &band.surface, rows);
            canvas_free(&band);
        }
        canvas cut = canvas_new(format, WIDTH, HEIGHT);
        cut.surface.scissor = (qtri_rect){random_in(&seed, 1, 30), random_in(&seed, 1, 20),
                                          random_in(&seed, 31, WIDTH), random_in(&seed, 21, 40)};
        qtri_samples_clear(&cut.surface, (qtri_rgb){24, 32, 48});
        qtri_draw_prepared(&cut.surface, &prepared);
        assert_samples(&whole.surface, &cut.surface, cut.surface.scissor);
        canvas_free(&cut);
        canvas_free(&whole);
    }
}

/* What came before drew small triangles and large ones. */
TEST(both_ways)
{
    print_message("%d small and %d large triangles\n", kinds[TRIANGLE_SMALL],
                  kinds[TRIANGLE_LARGE]);
    assert_true(kinds[TRIANGLE_SMALL] > 4000 && kinds[TRIANGLE_LARGE] > 4000);
}

/* Of a scissor's pixels and no others, in each format. */
/* In the middle of a large surface nothing is cut: as in tiles, where all is. */
TEST(far_from_the_bounds)
{
    enum { SIDE = 200, TILE = 50 };
    uint64_t seed = 31;
    for (int n = 0; n < 20; n++) {
        canvas c[2];
        qtri_screen_vertex v[40][3];
        qtri_material material = plain_material();
        material.depth_compare = QTRI_LESS;
        for (int i = 0; i < 40; i++) {
            random_triangle(v[i], &seed, 0, 255);
            for (int k = 0; k < 3; k++) {
                v[i][k].x_24p8 += (SIDE - WIDTH) * 128;
                v[i][k].y_24p8 += (SIDE - HEIGHT) * 128;
            }
        }
        for (int i = 0; i < 2; i++) {
            c[i] = canvas_new(four[n % FORMATS], SIDE, SIDE);
            qtri_samples_clear(&c[i].surface, (qtri_rgb){10, 20, 30});
            for (int tile = 0; tile < (i == 0 ? 1 : 16); tile++) {
                const int32_t x = tile % 4 * TILE, y = tile / 4 * TILE;
                const qtri_rect part = {x, y, x + TILE, y + TILE};
                c[i].surface.scissor = i == 0 ? c[i].surface.scissor : part;
                for (int k = 0; k < 40; k++) {
                    (void)draw_triangle(&c[i].surface, &material, v[k], true);
                }
            }
        }
        assert_memory_equal(c[0].surface.pixels, c[1].surface.pixels,
                            (size_t)c[0].surface.pitch * SIDE);
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
}

/* Needles to the end of the guard band, which samples' offsets cut off there: the same in rows, and
   nothing but what lies on them. */
TEST(needles_to_the_last_place)
{
    static const int32_t apart[4] = {3, 20, 60, 200};
    for (int n = 0; n < 16; n++) {
        const int32_t most = QTRI_SCREEN_MAX_24P8, sign = n & 1 ? -1 : 1;
        canvas c[2];
        qtri_material material = plain_material();
        qtri_screen_vertex v[3] = {screen_at(0, 0), screen_at(most, most),
                                   screen_at(most - apart[n / 4], most)};
        for (int k = 0; k < 3; k++) {
            if (n & 2) { /* at the other end */
                v[k].x_24p8 = HEIGHT * 256 - v[k].x_24p8;
                v[k].y_24p8 = HEIGHT * 256 - v[k].y_24p8;
                v[k].x_24p8 = k == 0 ? v[k].x_24p8 : v[k].x_24p8 - HEIGHT * 256;
                v[k].y_24p8 = k == 0 ? v[k].y_24p8 : v[k].y_24p8 - HEIGHT * 256;
            }
            v[k].depth_16p16 = (uint32_t)(k * 30000) << 16;
            v[k].color_8p16[0] = v[k].color_8p16[1] = v[k].color_8p16[2] = 255 << 16;
        }
        if (sign < 0) {
            const qtri_screen_vertex first = v[1];
            v[1] = v[2];
            v[2] = first;
        }
        material.depth_compare = QTRI_LESS;
        for (int i = 0; i < 2; i++) {
            c[i] = canvas_new(&qtri_rgb565_x4, WIDTH, HEIGHT);
            qtri_samples_clear(&c[i].surface, (qtri_rgb){0, 0, 0});
            for (int32_t y = 0; y < (i == 0 ? 1 : HEIGHT); y++) {
                if (i == 1) {
                    c[i].surface.scissor.y0 = y;
                    c[i].surface.scissor.y1 = y + 1;
                }
                (void)draw_triangle(&c[i].surface, &material, v, false);
            }
        }
        assert_memory_equal(c[0].surface.pixels, c[1].surface.pixels,
                            (size_t)c[0].surface.pitch * HEIGHT);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const int32_t x = i % WIDTH, y = i / WIDTH;
            for (int k = 0; k < 4; k++) {
                assert_true(sample_at(&c[0].surface, x, y, k) == 0 || abs(x - y) <= 1);
            }
        }
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
}

TEST(clears_in_a_scissor)
{
    for (int n = 0; n < FORMATS; n++) {
        canvas c = canvas_new(four[n], WIDTH, HEIGHT);
        qtri_surface part = c.surface;
        part.scissor = (qtri_rect){40, 10, 50, 20};
        qtri_samples_clear(&c.surface, (qtri_rgb){0, 0, 0});
        qtri_samples_clear(&part, (qtri_rgb){255, 255, 255});
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const int32_t x = i % WIDTH;
            const int32_t y = i / WIDTH;
            const bool inside = x >= 40 && x < 50 && y >= 10 && y < 20;
            assert_int_equal(sample_at(&c.surface, x, y, i % 4) != 0, inside);
        }
        canvas_free(&c);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
