/*
 * What fills rows fastest draws what the generic path draws, to the bit: every format, shading,
 * interpolation, depth mode, texture, alignment and cut by a scissor.
 */
#include "raster/triangle.h"
#include "support_core.h"

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
    m->shading = (qtri_shading)random_in(seed, 0, 2);
    m->interpolation = (qtri_interpolation)random_in(seed, 0, 1);
    m->texture_mode = (qtri_texture_mode)random_in(seed, 0, 1);
    m->cull = QTRI_CULL_NONE;
    m->depth_compare = (qtri_compare)random_in(seed, 0, 8);
    if (random_flag(seed)) {
        m->depth_compare = random_flag(seed) ? QTRI_LESS : QTRI_DEPTH_OFF;
    }
    m->depth_read_only = random_in(seed, 0, 3) == 0;
    qtri_texture texture = {.texels = texels, .format = QTRI_TEXEL_RGB565};
    texture.width_log2 = (uint8_t)random_in(seed, 0, 9);
    texture.height_log2 = (uint8_t)random_in(seed, 0, 16 - texture.width_log2);
    texture.height_log2 = texture.height_log2 > 10 ? 10 : texture.height_log2;
    texture.filter = random_in(seed, 0, 5) == 0 ? QTRI_BILINEAR : QTRI_NEAREST;
    texture.wrap_u = random_in(seed, 0, 5) == 0 ? QTRI_CLAMP : QTRI_REPEAT;
    texture.has_key = random_in(seed, 0, 5) == 0;
    texture.key = texels[0];
    *t = texture;
    m->texture = random_flag(seed) ? t : NULL;
}

/* As qtri_raster_triangle; true when a path of its own drew the triangle. */
static bool draw(const qtri_surface *surface, const qtri_material *material,
                 const qtri_screen_vertex v[3], bool generic)
{
    qtri_raster raster;
    qtri_raster_init(&raster, surface, material);
    bool fast = raster.texture != NULL             ? raster.copy_run != qtri_run_generic
                : material->shading != QTRI_SMOOTH ? raster.fill_flat != qtri_fill_spans
                                                   : raster.fill_linear != qtri_fill_spans;
    if (generic) {
        raster.fill_flat = raster.fill_linear = raster.fill_tiny = qtri_fill_spans;
        raster.copy_run = qtri_run_generic;
    }
    qtri_raster_draw(&raster, v);
    return fast;
}

static void random_background(canvas *a, canvas *b, uint64_t *seed)
{
    uint8_t *bytes = a->memory;
    for (size_t i = 0; i < a->bytes; i++) {
        bytes[i] = (uint8_t)random64(seed);
    }
    memcpy(b->memory, a->memory, a->bytes);
}

static void fast_equals_generic(void **state)
{
    (void)state;
    static const qtri_format formats[3] = {QTRI_RGB565, QTRI_XRGB8888, QTRI_GRAY8};
    uint64_t seed = 7;
    int fast = 0;
    for (size_t i = 0; i < LENGTH_OF(texels); i++) {
        texels[i] = (uint16_t)random64(&seed);
    }
    for (int f = 0; f < 3; f++) {
        canvas a = canvas_new(formats[f], WIDTH, HEIGHT);
        canvas b = canvas_new(formats[f], WIDTH, HEIGHT);
        for (int n = 0; n < (f == 0 ? 12000 : 4000); n++) {
            qtri_screen_vertex v[3];
            qtri_material material;
            qtri_texture texture;
            random_triangle(v, &seed, n);
            random_material(&material, &texture, &seed);
            if (n % 100 == 0) {
                random_background(&a, &b, &seed);
            }
            qtri_rect scissor = {random_in(&seed, -5, 90), random_in(&seed, -5, 20),
                                 random_in(&seed, 60, WIDTH + 5), random_in(&seed, 10, HEIGHT + 5)};
            a.surface.scissor = b.surface.scissor = scissor;
            fast += draw(&a.surface, &material, v, false);
            draw(&b.surface, &material, v, true);
            assert_memory_equal(a.memory, b.memory, a.bytes);
        }
        canvas_free(&a);
        canvas_free(&b);
    }
    assert_true(fast > 2000);
}

/*
 * A texel that is copied is the one that the texture's own functions find and that white leaves,
 * but for coordinates at the very edge of a texel: they are rounded otherwise.
 */
static void copies_equal_modulation(void **state)
{
    (void)state;
    uint64_t seed = 8;
    canvas a = canvas_new(QTRI_RGB565, WIDTH, HEIGHT);
    canvas b = canvas_new(QTRI_RGB565, WIDTH, HEIGHT);
    int copied = 0;
    int pixels = 0;
    int others = 0;
    for (int n = 0; n < 4000; n++) {
        qtri_screen_vertex v[3];
        qtri_material material = qtri_material_default();
        qtri_texture texture = {.texels = texels, .format = QTRI_TEXEL_RGB565};
        texture.width_log2 = (uint8_t)random_in(&seed, 1, 8);
        texture.height_log2 = (uint8_t)random_in(&seed, 0, 8);
        qtri_texture keyed = texture; /* a key that no texel has: drawn by the generic path */
        keyed.has_key = true;
        keyed.key = 0x10000;
        material.cull = QTRI_CULL_NONE;
        material.texture_mode = QTRI_REPLACE;
        material.interpolation = (qtri_interpolation)(n % 2);
        random_triangle(v, &seed, n % 5);
        canvas_clear(&a);
        canvas_clear(&b);
        material.texture = &texture;
        copied += draw(&a.surface, &material, v, false);
        material.texture = &keyed;
        draw(&b.surface, &material, v, false);
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
        cmocka_unit_test(fast_equals_generic),
        cmocka_unit_test(copies_equal_modulation),
    };
    return cmocka_run_group_tests_name("core runs", tests, NULL, NULL);
}
