/*
 * Tiny triangles of a mesh drawn in one go have the pixels and depths of the general path, to the
 * bit: any place, shape, light, tint, depth, distance, scissor and background.
 */
#include "raster/tiny.h"
#include "support_core.h"

enum { WIDTH = 40, HEIGHT = 30, TRIANGLES = 300000 };

static void random_vertices(qtri_vertex v[3], uint64_t *seed, int kind)
{
    static const int32_t reach[] = {150, 300, 700, 1100, 1300, 2500, 5000};
    const int32_t r = reach[kind % 7];
    const int32_t x = random_in(seed, -512, (WIDTH + 2) * 256);
    const int32_t y = random_in(seed, -512, (HEIGHT + 2) * 256);
    const int32_t depth = random_in(seed, 0, 65535 << 8);
    const int32_t steep = (int32_t)1 << random_in(seed, 0, 24);
    const int32_t w_reach = (int32_t)1 << random_in(seed, 1, 29);
    const int32_t dark = random_in(seed, 0, 32768);
    for (int i = 0; i < 3; i++) {
        int32_t own = depth + random_in(seed, -steep, steep);
        own = own < 0 ? 0 : (own > 65535 << 8 ? 65535 << 8 : own);
        v[i].at.x_24p8 = x + random_in(seed, -r, r);
        v[i].at.y_24p8 = y + random_in(seed, -r, r);
        v[i].depth_16p8 = (uint32_t)own << 8 | (random_in(seed, 0, 40) == 0 ? 3 : 2);
        v[i].inv_w = (uint32_t)((int32_t)1 << 30) + (uint32_t)random_in(seed, 0, w_reach);
        v[i].intensity_q15 = (uint16_t)(random_flag(seed) ? random_in(seed, dark, 32768) : dark);
    }
}

/* As draw calls do for what the others leave. */
static void draw_general(const qtri_raster *raster, qtri_triangle *triangle, const qtri_vertex v[3],
                         uint32_t face_q15)
{
    qtri_attributes attributes[3];
    for (int i = 0; i < 3; i++) {
        const uint32_t own = face_q15 == QTRI_VERTEX_UNLIT ? v[i].intensity_q15 : face_q15;
        attributes[i].depth_16p16 = v[i].depth_16p8 & ~0xFFu;
        attributes[i].inv_w_q31 = v[i].inv_w;
        attributes[i].inv_w_exponent = (int32_t)(v[i].depth_16p8 & 0xFFu);
        attributes[i].color[0] = (int32_t)(own << 7);
    }
    qtri_triangle_draw(raster, triangle, attributes);
}

static bool find(qtri_triangle *triangle, const qtri_raster *raster, const qtri_vertex v[3])
{
    for (int i = 0; i < 3; i++) {
        triangle->p[i] = &v[i].at;
    }
    triangle->tinted = true;
    triangle->area = qtri_triangle_area(&v[0].at, &v[1].at, &v[2].at);
    return triangle->area != 0 && qtri_triangle_begin(raster, triangle);
}

/*
 * As draw calls do before; false when nothing was drawn that may have to be. Flat without a face's
 * light where the vertices have the same.
 */
static bool draw_small(const qtri_raster *raster, const qtri_triangle *triangle, bool seen,
                       const qtri_vertex v[3], uint32_t face_q15)
{
    qtri_tiny tiny;
    switch (qtri_tiny_place(&tiny, &raster->bounds, &v[0], &v[1], &v[2])) {
    case QTRI_PLACED_NOWHERE:
        assert_false(seen);
        return true;
    case QTRI_PLACED_TINY:
        assert_true(seen);
        return qtri_tiny_draw(raster, &tiny, &v[0], &v[1], &v[2], face_q15);
    default:
        return !seen || (face_q15 != QTRI_VERTEX_UNLIT &&
                         qtri_small_draw(raster, triangle, &v[0], &v[1], &v[2], face_q15));
    }
}

static void small_equals_general(void **state)
{
    (void)state;
    uint64_t seed = 11;
    int smooth = 0;
    int flat = 0;
    int others = 0;
    canvas a = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    canvas b = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    qtri_material material = qtri_material_default();
    material.cull = QTRI_CULL_NONE;
    for (int n = 0; n < TRIANGLES; n++) {
        if (n % 50 == 0) {
            const qtri_rect scissor = {random_in(&seed, -3, 9), random_in(&seed, -3, 9),
                                       random_in(&seed, 25, WIDTH + 5),
                                       random_in(&seed, 20, HEIGHT + 5)};
            a.surface.scissor = b.surface.scissor = scissor;
            material.interpolation = random_flag(&seed) ? QTRI_PERSPECTIVE : QTRI_SCREEN_LINEAR;
            for (size_t i = 0; i < a.bytes; i++) {
                ((uint8_t *)a.memory)[i] = (uint8_t)random64(&seed);
            }
            memcpy(b.memory, a.memory, a.bytes);
        }
        const bool is_flat = n % 3 == 0;
        const uint32_t face_q15 =
            is_flat ? (uint32_t)random_in(&seed, 0, 32768) : QTRI_VERTEX_UNLIT;
        const qtri_rgb tint = {(uint8_t)random64(&seed), (uint8_t)random64(&seed),
                               (uint8_t)random64(&seed)};
        qtri_vertex v[3];
        qtri_triangle triangle;
        qtri_raster raster;
        random_vertices(v, &seed, n);
        material.shading = is_flat ? QTRI_FLAT_LAST : QTRI_SMOOTH;
        qtri_raster_init(&raster, &a.surface, &material);
        qtri_raster_set_tint(&raster, tint);
        const bool seen = find(&triangle, &raster, v);
        const bool drawn = draw_small(&raster, &triangle, seen, v, face_q15);
        if (!seen) {
            assert_memory_equal(a.memory, b.memory, a.bytes);
            continue;
        }
        if (!drawn) {
            assert_memory_equal(a.memory, b.memory, a.bytes);
            others++;
            draw_general(&raster, &triangle, v, face_q15);
        } else {
            smooth += !is_flat;
            flat += is_flat;
        }
        raster.surface = &b.surface;
        draw_general(&raster, &triangle, v, face_q15);
        assert_memory_equal(a.memory, b.memory, a.bytes);
    }
    assert_true(smooth > TRIANGLES / 20 && flat > TRIANGLES / 20 && others > TRIANGLES / 20);
    canvas_free(&a);
    canvas_free(&b);
}

/* Where it would be wrong: another format, depth test, or a texture. */
static void others_are_left_alone(void **state)
{
    (void)state;
    static const uint16_t texel = 0;
    static const qtri_texture texture = {.texels = &texel, .format = &qtri_texel_rgb565};
    static const struct {
        const qtri_format *format;
        qtri_compare compare;
        bool read_only;
        const qtri_texture *texture;
    } cases[] = {
        {&qtri_xrgb8888, QTRI_LESS, false, NULL},    {&qtri_gray8, QTRI_LESS, false, NULL},
        {&qtri_rgb565, QTRI_DEPTH_OFF, false, NULL}, {&qtri_rgb565, QTRI_LESS, true, NULL},
        {&qtri_rgb565, QTRI_GREATER, false, NULL},   {&qtri_rgb565, QTRI_LESS, false, &texture}};
    uint64_t seed = 12;
    for (size_t i = 0; i < LENGTH_OF(cases); i++) {
        canvas a = canvas_new(cases[i].format, WIDTH, HEIGHT);
        qtri_material material = qtri_material_default();
        material.depth_compare = cases[i].compare;
        material.depth_read_only = cases[i].read_only;
        material.texture = cases[i].texture;
        for (int n = 0; n < 1000; n++) {
            qtri_vertex v[3];
            qtri_triangle triangle;
            qtri_raster raster;
            random_vertices(v, &seed, n);
            qtri_raster_init(&raster, &a.surface, &material);
            assert_false(find(&triangle, &raster, v) &&
                         qtri_small_draw(&raster, &triangle, &v[0], &v[1], &v[2], 1000));
        }
        canvas_free(&a);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(small_equals_general),
        cmocka_unit_test(others_are_left_alone),
    };
    return cmocka_run_group_tests_name("core small", tests, NULL, NULL);
}
