/* SPDX-License-Identifier: MIT */
/*
 * Fog and blends of small triangles on surfaces of four samples a pixel: what the way of large
 * triangles makes of the same ones.
 */
#include "support/core.h"

#include "raster/samples.h"

enum { WIDTH = 48, HEIGHT = 40, FORMATS = 5, SIDE = 16 };

static const qtri_format *const four[FORMATS] = {
    &qtri_rgb565_x4, &qtri_rgb565_swapped_x4, &qtri_xrgb8888_x4, &qtri_rgb888_x4, &qtri_gray8_x4};

static long small_ones;

/* All triangles are large ones. */
static bool draw_no_small(struct qtri_small *triangle)
{
    (void)triangle;
    return false;
}

/* Counts those that are small. */
static bool draw_counted(struct qtri_small *triangle)
{
    const bool drawn = qtri_pipeline_any_x4.small(triangle);
    small_ones += drawn;
    return drawn;
}

static qtri_pipeline pipeline_as(bool large)
{
    qtri_pipeline pipeline = qtri_pipeline_any_x4;
    pipeline.small = large ? draw_no_small : draw_counted;
    return pipeline;
}

/* ---- Scenes ---- */

enum { VERTICES = 96, TRIANGLES = 120 };
static qtri_vec3 positions[VERTICES];
static qtri_rgb colors[VERTICES];
static uint16_t triangles[TRIANGLES][3];
static qtri_vec2 coordinates[VERTICES];
static qtri_vertex slots[VERTICES];
static uint32_t texels[SIDE * SIDE];

/* Overlapping triangles of one depth: neither slopes nor perspective part the ways. */
static qtri_mesh flat_mesh(uint64_t *seed, double reach)
{
    const qtri_mesh mesh = {.positions = positions,
                            .colors = colors,
                            .uvs = coordinates,
                            .triangles = (const uint16_t(*)[3])triangles,
                            .vertex_count = VERTICES,
                            .triangle_count = TRIANGLES};
    for (int i = 0; i < VERTICES; i += 3) {
        const double x = random_in(seed, -120, 120) / 100.;
        const double y = random_in(seed, -100, 100) / 100.;
        for (int k = 0; k < 3; k++) {
            positions[i + k] = vec3_of(x + reach * random_in(seed, -99, 99) / 99.,
                                       y + reach * random_in(seed, -99, 99) / 99., 0);
            colors[i + k] =
                (qtri_rgb){(uint8_t)random_in(seed, 0, 255), (uint8_t)random_in(seed, 0, 255),
                           (uint8_t)random_in(seed, 0, 255)};
            coordinates[i + k].x = random_in(seed, 0, 65536);
            coordinates[i + k].y = random_in(seed, 0, 65536);
        }
    }
    for (int i = 0; i < TRIANGLES; i++) {
        const int first = i < VERTICES / 3 ? 3 * i : 3 * random_in(seed, 0, VERTICES / 3 - 1);
        for (int k = 0; k < 3; k++) {
            triangles[i][k] = (uint16_t)(first + k);
        }
    }
    return mesh;
}

typedef struct scene {
    qtri_material material;
    qtri_texture texture;
    qtri_fog fog;
    bool varies; /* colours do, which differ by the way within their error */
} scene;

static void random_scene(scene *s, uint64_t *seed)
{
    static const qtri_blend *const blends[7] = {
        &qtri_blend_alpha, &qtri_blend_add,     &qtri_blend_multiply,    &qtri_blend_none,
        &qtri_blend_alpha, &qtri_blend_replace, &qtri_blend_screen_door,
    };
    static const qtri_compare compares[6] = {QTRI_LESS,      QTRI_LESS_EQUAL, QTRI_DEPTH_OFF,
                                             QTRI_NOT_EQUAL, QTRI_ALWAYS,     QTRI_GREATER_EQUAL};
    const qtri_fog_range range = {Q16(1), Q16(20), false};
    s->material = qtri_material_default();
    s->material.cull = QTRI_CULL_NONE;
    s->material.shading = random_flag(seed) ? QTRI_FLAT_LAST : QTRI_SMOOTH;
    s->material.blend = random_in(seed, 0, 4) == 0 ? NULL : blends[random_in(seed, 0, 6)];
    s->material.alpha = (uint8_t)random_in(seed, 0, 255);
    s->material.keep = random_in(seed, 0, 3) == 0 ? (uint8_t)random_in(seed, 0, 7) : 0;
    s->material.depth_compare = compares[random_in(seed, 0, 5)];
    s->material.depth_read_only = random_flag(seed);
    s->material.color = (qtri_rgb){(uint8_t)random_in(seed, 0, 255), 200, 30};
    s->texture = (qtri_texture){.texels = texels,
                                .format = &qtri_texel_argb8888,
                                .filter = random_flag(seed) ? &qtri_bilinear : NULL,
                                .width_log2 = 4,
                                .height_log2 = 4};
    if (random_in(seed, 0, 2) == 0) {
        s->material.texture = &s->texture;
        s->material.texture_mode = random_flag(seed) ? QTRI_REPLACE : QTRI_MODULATE;
        s->material.least_alpha = random_in(seed, 0, 3) == 0 ? 128 : 0;
        const uint32_t texel = (uint32_t)random_bits32(seed);
        for (int i = 0; i < SIDE * SIDE; i++) { /* wherever it is looked at */
            texels[i] = texel;
        }
    }
    qtri_fog_linear(&s->fog, (qtri_rgb){200, 90, 10}, range, Q16(1), Q16(12));
    if (s->material.blend == NULL || random_in(seed, 0, 2) == 0) {
        s->material.fog = &s->fog;
    }
    s->varies = s->material.shading == QTRI_SMOOTH &&
                (s->material.texture == NULL || s->material.texture_mode == QTRI_MODULATE);
}

static void draw_by(const qtri_pipeline *pipeline, const qtri_surface *surface, const scene *s,
                    uint64_t seed, q16 tilt)
{
    const qtri_pipeline *const list[] = {pipeline, NULL};
    qtri_view view;
    qtri_transform pose;
    qtri_view_init(&view, WIDTH, HEIGHT);
    qtri_transform_perspective(&view.projection, Q16(60), Q16(1.2), Q16(1), Q16(20));
    give_vertices(&view, slots, VERTICES);
    view.pipelines = list;
    for (int n = 0; n < 3; n++) {
        const double reach = n == 1 ? .5 : .12;
        const qtri_mesh mesh = flat_mesh(&seed, reach);
        qtri_transform_look_at(&view.camera, vec3_of(0, 0, 2.2 + random_in(&seed, 0, 9) / 10.),
                               vec3_of(0, 0, 0), vec3_of(0, 1, 0));
        qtri_transform_identity(&pose);
        qtri_transform_rotate_y(&pose, tilt);
        qtri_draw_mesh(surface, &view, &pose, &mesh, &s->material);
    }
}

static void draw(const qtri_surface *surface, const scene *s, uint64_t seed, q16 tilt)
{
    draw_by(&qtri_pipeline_any, surface, s, seed, tilt);
}

/* Samples of any colours, every other like the one before. */
static void fill_at_random(const qtri_surface *s, uint64_t seed)
{
    const int32_t size = s->format->pixels->bytes;
    const int32_t bytes = qtri_sample_bytes(size);
    for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
        uint8_t *record = s->pixels + (i / WIDTH) * s->pitch + (ptrdiff_t)(i % WIDTH) * size;
        for (int k = 0; k < 4; k++) {
            uint32_t word = (uint32_t)random_bits32(&seed) & 0xFFFFFF;
            if (k > 0 && random_flag(&seed)) {
                word = qtri_sample_color(record, bytes, k - 1);
            }
            qtri_sample_set_color(record, bytes, k, word);
        }
    }
}

/* Off by a channel's step of what they are mixed to. */
static bool is_near(const qtri_format *format, uint32_t a, uint32_t b)
{
    const uint32_t x = format->decode(a);
    const uint32_t y = format->decode(b);
    const int32_t most = format->colors == &qtri_colors_565 ? 9 : 3;
    for (int k = 0; k < 24; k += 8) {
        if (abs((int32_t)(x >> k & 255) - (int32_t)(y >> k & 255)) > most) {
            return false;
        }
    }
    return true;
}

static long assert_like(const qtri_surface *a, const qtri_surface *b, const qtri_format *format,
                        bool near)
{
    const int32_t size = format->pixels->bytes;
    const int32_t bytes = qtri_sample_bytes(size);
    long differ = 0;
    for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const ptrdiff_t at = (i / WIDTH) * a->pitch + (ptrdiff_t)(i % WIDTH) * size;
        for (int k = 0; k < 4; k++) {
            const uint32_t x = qtri_sample_color(a->pixels + at, bytes, k);
            const uint32_t y = qtri_sample_color(b->pixels + at, bytes, k);
            if (near) {
                differ += !is_near(format, x, y);
            } else {
                assert_int_equal(x, y);
            }
        }
        assert_int_equal(a->depth[(i / WIDTH) * a->depth_pitch + i % WIDTH],
                         b->depth[(i / WIDTH) * b->depth_pitch + i % WIDTH]);
        assert_memory_equal(a->pixels + at + 4 * bytes, b->pixels + at + 4 * bytes, 6);
    }
    return differ;
}

/* How many samples differ where small triangles are drawn as such, and as large ones. */
static long small_from_large(const qtri_format *format, const scene *s, uint64_t seed, q16 tilt,
                             bool is_filled, bool near)
{
    canvas c[2];
    for (int i = 0; i < 2; i++) {
        const qtri_pipeline pipeline = pipeline_as(i == 1);
        c[i] = canvas_new(format, WIDTH, HEIGHT);
        qtri_samples_clear(&c[i].surface, (qtri_rgb){0, 0, 0});
        if (is_filled) {
            fill_at_random(&c[i].surface, seed);
        }
        draw_by(&pipeline, &c[i].surface, s, seed, tilt);
    }
    const long differ = assert_like(&c[0].surface, &c[1].surface, format, near);
    canvas_free(&c[0]);
    canvas_free(&c[1]);
    return differ;
}

/* Of one colour and one depth all samples are the same to the bit. */
TEST(small_as_large)
{
    uint64_t seed = 1;
    long differ = 0;
    long varied = 0;
    for (int n = 0; n < 240; n++) {
        scene s;
        random_scene(&s, &seed);
        const uint64_t own = seed += 99;
        differ += small_from_large(four[n % FORMATS], &s, own, 0, true, s.varies);
        varied += s.varies ? WIDTH * HEIGHT * 4 : 0;
    }
    print_message("%ld small triangles; %ld of %ld samples of varied colours differ\n", small_ones,
                  differ, varied);
    assert_true(small_ones > 20000);
    assert_true(differ * 10000 < varied);
}

/* Fog that changes much in a pixel is as deep as where the pixel takes its colour. */
TEST(slopes)
{
    uint64_t seed = 3;
    long differ = 0;
    long all = 0;
    for (int n = 0; n < 60; n++) {
        scene s;
        random_scene(&s, &seed);
        const qtri_fog_range range = {Q16(1), Q16(20), false};
        const uint64_t own = seed += 99;
        qtri_fog_linear(&s.fog, (qtri_rgb){255, 255, 255}, range, Q16(2), Q16(2.8));
        s.material.fog = &s.fog;
        s.material.blend = n % 3 == 0 ? &qtri_blend_alpha : NULL;
        s.material.depth_compare = QTRI_DEPTH_OFF;
        s.material.keep = 0;
        differ += small_from_large(four[n % FORMATS], &s, own, Q16(40), false, true);
        all += WIDTH * HEIGHT * 4;
    }
    print_message("%ld of %ld samples differ\n", differ, all);
    assert_true(differ * 20000 < all);
}

/* A frame in bands, and with a scissor; of texels of any alpha, which are drawn in part. */
TEST(pieces)
{
    uint64_t seed = 5;
    for (int n = 0; n < 60; n++) {
        const qtri_format *format = four[n % FORMATS];
        canvas whole = canvas_new(format, WIDTH, HEIGHT);
        canvas part = canvas_new(format, WIDTH, HEIGHT);
        scene s;
        random_scene(&s, &seed);
        for (int i = 0; i < SIDE * SIDE; i++) {
            texels[i] = (uint32_t)random_bits32(&seed);
        }
        const uint64_t own = seed += 99;
        qtri_samples_clear(&whole.surface, (qtri_rgb){0, 0, 0});
        fill_at_random(&whole.surface, own);
        draw(&whole.surface, &s, own, Q16(50));
        qtri_samples_clear(&part.surface, (qtri_rgb){0, 0, 0});
        fill_at_random(&part.surface, own);
        for (int32_t row = 0; row < HEIGHT; row += 7) {
            qtri_surface band = part.surface;
            band.first_row = row;
            band.rows = qtri_least32(7, HEIGHT - row);
            band.pixels += row * band.pitch;
            band.depth += row * band.depth_pitch;
            for (int32_t x = 0; x < WIDTH; x += 19) {
                band.scissor = (qtri_rect){x, 0, qtri_least32(x + 19, WIDTH), HEIGHT};
                draw(&band, &s, own, Q16(50));
            }
        }
        (void)assert_like(&whole.surface, &part.surface, format, false);
        canvas_free(&whole);
        canvas_free(&part);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
