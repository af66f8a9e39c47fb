/* SPDX-License-Identifier: MIT */
/*
 * Small triangles with fog, blends and what discards pixels, which lie on each other: one draw call
 * has the pixels and depths of one draw call a triangle.
 */
#include "support/core.h"

enum { WIDTH = 64, HEIGHT = 48, COUNT = 90, SIDE_LOG2 = 3, TEXELS = 1 << (2 * SIDE_LOG2) };

typedef struct heap {
    qtri_vec3 positions[3 * COUNT];
    qtri_normal normals[3 * COUNT];
    qtri_vec2 uvs[3 * COUNT];
    qtri_rgb colors[3 * COUNT];
    uint16_t triangles[COUNT][3];
    uint16_t texels[TEXELS];
    qtri_texture texture;
    qtri_fog fog;
    qtri_mesh mesh;
} heap;

static q16 random_q16(uint64_t *seed, int32_t thousandths)
{
    return (q16)((int64_t)random_in(seed, -thousandths, thousandths) * Q16_ONE / 1000);
}

/* Triangles of a few pixels, so near to each other that many share pixels. */
static void set_heap(heap *h, uint64_t *seed, int32_t size)
{
    for (int i = 0; i < COUNT; i++) {
        const q16 x = random_q16(seed, 300);
        const q16 y = random_q16(seed, 300);
        const q16 z = random_in(seed, -1, 1) * Q16(.2); /* some on each other */
        for (int k = 3 * i; k < 3 * i + 3; k++) {
            h->positions[k].x = x + random_q16(seed, size);
            h->positions[k].y = y + random_q16(seed, size);
            h->positions[k].z = z + random_q16(seed, i % 3 != 0 ? 0 : 30);
            h->normals[k].x = (int16_t)random_in(seed, -16384, 16384);
            h->normals[k].y = (int16_t)random_in(seed, -16384, 16384);
            h->normals[k].z = (int16_t)random_in(seed, 1, 16384);
            h->uvs[k].x = random_q16(seed, 900);
            h->uvs[k].y = random_q16(seed, 900);
            h->colors[k].r = (uint8_t)random_in(seed, 0, 255);
            h->colors[k].g = (uint8_t)random_in(seed, 0, 255);
            h->colors[k].b = (uint8_t)random_in(seed, 0, 255);
            h->triangles[i][k - 3 * i] = (uint16_t)k;
        }
    }
    for (int i = 0; i < TEXELS; i++) {
        h->texels[i] = (uint16_t)(random_flag(seed) ? random_in(seed, 0, 65535) : 0x1234);
    }
    const qtri_mesh mesh = {.positions = h->positions,
                            .triangles = (const uint16_t(*)[3])h->triangles,
                            .vertex_count = 3 * COUNT,
                            .triangle_count = COUNT};
    h->mesh = mesh;
}

/* Everything that options ask of a material, one after the other. */
static qtri_material material_of(heap *h, int n)
{
    static const qtri_blend *const blends[] = {NULL,
                                               &qtri_blend_alpha,
                                               &qtri_blend_add,
                                               &qtri_blend_multiply,
                                               &qtri_blend_none,
                                               &qtri_blend_replace,
                                               &qtri_blend_screen_door};
    static const qtri_texel_format *const texels[] = {&qtri_texel_rgb565, &qtri_texel_argb4444};
    static const qtri_compare compares[] = {QTRI_LESS,   QTRI_LESS,      QTRI_LESS_EQUAL,
                                            QTRI_EQUAL,  QTRI_NOT_EQUAL, QTRI_GREATER,
                                            QTRI_ALWAYS, QTRI_DEPTH_OFF, QTRI_GREATER_EQUAL};
    const int source = n % 4; /* one colour, lit or not; colours; texels */
    qtri_material m = qtri_material_default();
    m.cull = QTRI_CULL_NONE;
    m.color.g = 200;
    m.color.b = 90;
    m.blend = blends[n / 4 % 7];
    m.alpha = (uint8_t)(n % 5 == 0 ? 255 : 40 * (n % 5));
    m.keep = n % 11 == 0 ? QTRI_KEEP_GREEN : 0;
    m.fog = n % 3 == 0 ? &h->fog : NULL;
    m.depth_compare = compares[n % 9];
    m.depth_read_only = n % 13 == 0;
    h->mesh.normals = source == 0 ? h->normals : NULL;
    h->mesh.colors = source == 2 ? h->colors : NULL;
    h->mesh.uvs = source == 3 ? h->uvs : NULL;
    if (source == 3) {
        const qtri_texture texture = {.texels = h->texels,
                                      .format = texels[n / 8 % 2],
                                      .width_log2 = SIDE_LOG2,
                                      .height_log2 = SIDE_LOG2,
                                      .has_key = n / 16 % 2 == 0,
                                      .key = 0x1234,
                                      .filter = n % 5 == 1 ? &qtri_bilinear : NULL};
        h->texture = texture;
        m.texture = &h->texture;
        m.least_alpha = n / 8 % 2 == 1 ? 100 : 0;
    }
    return m;
}

static void set_view(qtri_view *view, int32_t width, int32_t height)
{
    qtri_view_init(view, width, height);
    qtri_transform_identity(&view->camera);
    const qtri_vec3 back = {0, 0, Q16(-1.5)};
    qtri_transform_translate(&view->camera, back);
    qtri_transform_perspective(&view->projection, Q16(60), Q16(1.333), Q16(.5), Q16(20));
}

TEST(in_order)
{
    static heap h;
    uint64_t seed = 11;
    const qtri_light light = {
        .towards = {Q16(.3), Q16(.2), Q16(1)}, .ambient = Q16(.2), .diffuse = Q16(.8)};
    const qtri_fog_range range = {Q16(.5), Q16(20), false};
    const qtri_rgb gray = {90, 100, 110};
    static qtri_vertex vertices[3 * COUNT];
    for (int n = 0; n < 504; n++) {
        const qtri_format *format = n % 2 == 0 ? &qtri_rgb565 : drawn_format(n / 2);
        set_heap(&h, &seed, n % 8 == 7 ? 200 : 60);
        qtri_fog_exp2(&h.fog, gray, range, Q16(.5));
        const qtri_material m = material_of(&h, n);
        qtri_view view;
        qtri_transform pose;
        set_view(&view, WIDTH, HEIGHT);
        qtri_transform_identity(&pose);
        view.light = n % 8 == 4 ? NULL : &light;
        give_vertices(&view, vertices, 3 * COUNT);
        canvas whole = canvas_new(format, WIDTH, HEIGHT);
        canvas parts = canvas_new(format, WIDTH, HEIGHT);
        if (n % 6 == 5) {
            whole.surface.depth_format = &qtri_depth_float16;
            parts.surface.depth_format = &qtri_depth_float16;
        }
        qtri_surface_clear_depth(&whole.surface,
                                 m.depth_compare >= QTRI_GREATER ? Q16(.6) : Q16(.9));
        qtri_surface_clear_depth(&parts.surface,
                                 m.depth_compare >= QTRI_GREATER ? Q16(.6) : Q16(.9));
        qtri_draw_mesh(&whole.surface, &view, &pose, &h.mesh, &m);
        for (int i = 0; i < COUNT; i++) {
            h.mesh.triangles = (const uint16_t(*)[3])h.triangles + i;
            h.mesh.triangle_count = 1;
            qtri_draw_mesh(&parts.surface, &view, &pose, &h.mesh, &m);
        }
        assert_same_picture(&whole.surface, &parts.surface);
        canvas_free(&whole);
        canvas_free(&parts);
    }
}

/* In the middle of a frame that is large enough for that none is cut; and where scissors cut them.
 */
TEST(cut_or_whole)
{
    enum { WIDE = 160, HIGH = 120, TILE = 19 };
    static heap h;
    static qtri_vertex vertices[3 * COUNT];
    uint64_t seed = 12;
    const qtri_light light = {
        .towards = {Q16(.3), Q16(.2), Q16(1)}, .ambient = Q16(.2), .diffuse = Q16(.8)};
    const qtri_fog_range range = {Q16(.5), Q16(20), false};
    const qtri_rgb gray = {90, 100, 110};
    for (int n = 0; n < 56; n++) {
        set_heap(&h, &seed, 40);
        qtri_fog_exp2(&h.fog, gray, range, Q16(.5));
        const qtri_material m = material_of(&h, n);
        qtri_view view;
        qtri_transform pose;
        set_view(&view, WIDE, HIGH);
        qtri_transform_identity(&pose);
        view.light = &light;
        give_vertices(&view, vertices, 3 * COUNT);
        canvas whole = canvas_new(&qtri_rgb565, WIDE, HIGH);
        canvas parts = canvas_new(&qtri_rgb565, WIDE, HIGH);
        qtri_surface_clear_depth(&whole.surface, Q16(.9));
        qtri_surface_clear_depth(&parts.surface, Q16(.9));
        qtri_draw_mesh(&whole.surface, &view, &pose, &h.mesh, &m);
        for (int32_t i = 0; i < 9 * 7; i++) {
            const qtri_rect tile = {i % 9 * TILE, i / 9 * TILE, (i % 9 + 1) * TILE,
                                    (i / 9 + 1) * TILE};
            parts.surface.scissor = tile;
            qtri_draw_mesh(&parts.surface, &view, &pose, &h.mesh, &m);
        }
        assert_same_picture(&whole.surface, &parts.surface);
        canvas_free(&whole);
        canvas_free(&parts);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
