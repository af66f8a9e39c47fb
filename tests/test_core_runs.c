/* SPDX-License-Identifier: MIT */
/*
 * What fills rows fastest, here or on another core, draws what the stages draws, to the bit:
 * every format, shading, interpolation, depth mode, texture, alignment and cut by a scissor.
 */
#include "raster/span.h"
#include "raster/triangle.h"
#include "support/core.h"
#include "support/fill.h"

enum { WIDTH = 150, HEIGHT = 40 };

static uint16_t texels[1 << 16];

static void random_triangle(qtri_screen_vertex v[3], uint64_t *seed, int kind)
{
    static const int32_t reach[] = {600, 900, 1500, 6000, 20000, 200000, 1 << 20};
    int32_t r = reach[kind % 7];
    int32_t x = random_in(seed, 0, WIDTH * 256);
    int32_t y = random_in(seed, 0, HEIGHT * 256);
    int32_t depth_range = random_in(seed, 0, 1) != 0 ? 65535 * 32768 : 1 << 20;
    for (int i = 0; i < 3; i++) {
        v[i] = screen_at(x + random_in(seed, -r, r), y + random_in(seed, -r, r));
        v[i].depth_16p16 = (uint32_t)random_in(seed, 0, depth_range) * 2;
        v[i].inv_w_q31 =
            0x80000000u - ((uint32_t)random_in(seed, 0, 0x3FFFFFFF) >> random_in(seed, 0, 12));
        v[i].u_q32 = (int64_t)random_in(seed, -(1 << 18), 1 << 18) * 65536;
        v[i].v_q32 = (int64_t)random_in(seed, -(1 << 18), 1 << 18) * 65536;
        for (int channel = 0; channel < 3; channel++) {
            v[i].color_8p16[channel] = kind % 5 == 0 ? 255 << 16 : random_in(seed, 0, 255 << 16);
        }
    }
    if (kind % 11 == 0) { /* a sliver */
        v[2].x_24p8 = v[0].x_24p8 + (v[1].x_24p8 - v[0].x_24p8) / 3 + random_in(seed, -9, 9);
        v[2].y_24p8 = v[0].y_24p8 + (v[1].y_24p8 - v[0].y_24p8) / 3 + random_in(seed, -9, 9);
    }
}

static void random_material(qtri_material *m, qtri_texture *t, uint64_t *seed)
{
    *m = qtri_material_default();
    m->shading = shading_of((int)random_in(seed, 0, 2));
    m->interpolation = (qtri_interpolation)random_in(seed, 0, 1);
    m->texture_mode = (qtri_texture_mode)random_in(seed, 0, 1);
    m->cull = QTRI_CULL_NONE;
    m->depth_compare = (qtri_compare)random_in(seed, 0, 8);
    if (random_flag(seed)) {
        static const qtri_compare usual[3] = {QTRI_LESS, QTRI_LESS_EQUAL, QTRI_DEPTH_OFF};
        m->depth_compare = usual[random_in(seed, 0, 2)];
    }
    m->depth_read_only = random_in(seed, 0, 3) == 0;
    qtri_texture texture = {.texels = texels, .format = &qtri_texel_rgb565};
    texture.width_log2 = (uint8_t)random_in(seed, 0, 9);
    texture.height_log2 = (uint8_t)random_in(seed, 0, 16 - texture.width_log2);
    texture.height_log2 = texture.height_log2 > 10 ? 10 : texture.height_log2;
    static const qtri_filter *const filters[6] = {&qtri_bilinear, &qtri_mipmapped, &qtri_mipmapped,
                                                  &qtri_mipmapped_bilinear};
    static const void *const levels[5] = {texels + 1, texels + 7, texels + 3, texels + 9, texels};
    texture.filter = filters[random_in(seed, 0, 5)];
    texture.levels = levels; /* any texels: which ones is the same for all ways */
    texture.level_count = 5;
    texture.wrap_u = random_in(seed, 0, 5) == 0 ? QTRI_CLAMP : QTRI_REPEAT;
    texture.has_key = random_in(seed, 0, 5) == 0;
    texture.key = texels[0];
    *t = texture;
    m->texture = random_flag(seed) ? t : NULL;
}

/* Which functions fill rows: what a raster chooses, or one way for all that it has. */
enum way { CHOSEN, STAGES, PAIRS, SELECTED, WAYS };

static void choose(qtri_raster *raster, enum way way)
{
    static const struct {
        qtri_fill_rows flat, smooth;
        qtri_draw_run copy;
    } loops[2][2] = {
        {{qtri_flat_pairs, qtri_smooth_pairs, qtri_copy_pairs},
         {qtri_flat_pairs_lequal, qtri_smooth_pairs_lequal, qtri_copy_pairs_lequal}},
        {{selected_flat_pairs, selected_smooth_pairs, selected_copy_pairs},
         {selected_flat_pairs_lequal, selected_smooth_pairs_lequal, selected_copy_pairs_lequal}},
    };
    const bool has_loops = raster->fill_flat != qtri_span_flat;
    if (way == STAGES) {
        raster->fill_flat = qtri_span_flat;
        raster->fill_smooth = qtri_span_fill;
        raster->copy_run = NULL;
    } else if (way != CHOSEN && has_loops) {
        const int equal = raster->compare == QTRI_LESS_EQUAL;
        raster->fill_flat = loops[way == SELECTED][equal].flat;
        raster->fill_smooth = loops[way == SELECTED][equal].smooth;
        raster->copy_run = raster->copied ? loops[way == SELECTED][equal].copy : NULL;
    }
}

/* As qtri_raster_triangle; true when a loop of its own drew the triangle. */
static bool draw(const qtri_surface *surface, const qtri_material *material,
                 const qtri_screen_vertex v[3], enum way way)
{
    qtri_raster raster;
    qtri_batch batch;
    qtri_raster_init(&raster, surface, material, &batch);
    choose(&raster, way);
    qtri_raster_draw(&raster, v);
    return raster.texture != NULL             ? raster.copy_run != NULL
           : material->shading != QTRI_SMOOTH ? raster.fill_flat != qtri_span_flat
                                              : raster.fill_smooth != qtri_span_fill;
}

static void random_background(canvas c[WAYS], uint64_t *seed)
{
    uint8_t *bytes = c[0].memory;
    for (size_t i = 0; i < c[0].bytes; i++) {
        bytes[i] = (uint8_t)random64(seed);
    }
    for (int way = 1; way < WAYS; way++) {
        memcpy(c[way].memory, c[0].memory, c[0].bytes);
    }
}

static void every_way_draws_the_same(void **state)
{
    (void)state;
    static const qtri_format *const formats[3] = {&qtri_rgb565, &qtri_xrgb8888, &qtri_gray8};
    uint64_t seed = 7;
    int fast = 0;
    for (size_t i = 0; i < LENGTH_OF(texels); i++) {
        texels[i] = (uint16_t)random64(&seed);
    }
    for (int f = 0; f < 3; f++) {
        canvas c[WAYS];
        for (int way = 0; way < WAYS; way++) {
            c[way] = canvas_new(formats[f], WIDTH, HEIGHT);
        }
        for (int n = 0; n < (f == 0 ? 12000 : 4000); n++) {
            qtri_screen_vertex v[3];
            qtri_material material;
            qtri_texture texture;
            random_triangle(v, &seed, n);
            random_material(&material, &texture, &seed);
            if (n % 100 == 0) {
                random_background(c, &seed);
            }
            qtri_rect scissor = {random_in(&seed, -5, 90), random_in(&seed, -5, 20),
                                 random_in(&seed, 60, WIDTH + 5), random_in(&seed, 10, HEIGHT + 5)};
            for (int way = 0; way < WAYS; way++) {
                qtri_surface *surface = &c[way].surface;
                surface->scissor = scissor;
                /* Every other hundred: depths begin words in one row, pixels in the next. */
                surface->width = WIDTH - n / 100 % 2;
                surface->depth_pitch = surface->width;
                fast += draw(surface, &material, v, (enum way)way) && way == CHOSEN;
                assert_memory_equal(c[way].memory, c[0].memory, c[0].bytes);
            }
        }
        for (int way = 0; way < WAYS; way++) {
            canvas_free(&c[way]);
        }
    }
    assert_true(fast > 2000);
}

/* A surface that holds no depth draws what any does without the test. */
static void surfaces_without_depth(void **state)
{
    (void)state;
    static const qtri_format *const formats[3] = {&qtri_rgb565, &qtri_xrgb8888, &qtri_gray8};
    uint64_t seed = 9;
    for (int f = 0; f < 3; f++) {
        canvas off = canvas_new(formats[f], WIDTH, HEIGHT);
        canvas none = canvas_new(formats[f], WIDTH, HEIGHT);
        none.surface.depth = NULL;
        for (int n = 0; n < 1500; n++) {
            qtri_screen_vertex v[3];
            qtri_material material;
            qtri_texture texture;
            random_triangle(v, &seed, n);
            random_material(&material, &texture, &seed);
            draw(&none.surface, &material, v, CHOSEN);
            material.depth_compare = QTRI_DEPTH_OFF;
            draw(&off.surface, &material, v, CHOSEN);
            assert_memory_equal(off.memory, none.memory, off.bytes);
        }
        canvas_free(&off);
        canvas_free(&none);
    }
}

/*
 * A texel that is copied is the one that the texture's own functions find and that white leaves,
 * but for coordinates at the very edge of a texel: they are rounded otherwise.
 */
static void copies_equal_modulation(void **state)
{
    (void)state;
    uint64_t seed = 8;
    canvas a = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    canvas b = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    int copied = 0;
    int pixels = 0;
    int others = 0;
    for (int n = 0; n < 4000; n++) {
        qtri_screen_vertex v[3];
        qtri_material material = qtri_material_default();
        qtri_texture texture = {.texels = texels, .format = &qtri_texel_rgb565};
        texture.width_log2 = (uint8_t)random_in(&seed, 1, 8);
        texture.height_log2 = (uint8_t)random_in(&seed, 0, 8);
        qtri_texture keyed = texture; /* a key that no texel has: drawn by the stages */
        keyed.has_key = true;
        keyed.key = 0x10000;
        material.cull = QTRI_CULL_NONE;
        material.texture_mode = QTRI_REPLACE;
        material.interpolation = (qtri_interpolation)(n % 2);
        random_triangle(v, &seed, n % 5);
        canvas_clear(&a);
        canvas_clear(&b);
        material.texture = &texture;
        copied += draw(&a.surface, &material, v, CHOSEN);
        material.texture = &keyed;
        draw(&b.surface, &material, v, CHOSEN);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            int32_t x = i % WIDTH;
            int32_t y = i / WIDTH;
            assert_int_equal(stored_depth(&a.surface, x, y), stored_depth(&b.surface, x, y));
            pixels += stored_depth(&a.surface, x, y) != 65535;
            others += stored_pixel(&a.surface, x, y) != stored_pixel(&b.surface, x, y);
        }
    }
    print_message("copied: %d of %d pixels are another texel\n", others, pixels);
    assert_true(copied > 1000);
    assert_true(others * 20000LL <= pixels);
    canvas_free(&a);
    canvas_free(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_way_draws_the_same),
        cmocka_unit_test(surfaces_without_depth),
        cmocka_unit_test(copies_equal_modulation),
    };
    return cmocka_run_group_tests_name("core runs", tests, NULL, NULL);
}
