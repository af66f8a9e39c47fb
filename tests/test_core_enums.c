/* SPDX-License-Identifier: MIT */
/*
 * A number that is none of its enum has the result that its header names: of each field, drawn by
 * everything that reads it, with the pixels and depths of the value that it stands for.
 */
#include "support/cube.h"
#include "support/layouts.h"

enum { WIDTH = 44, HEIGHT = 40, CORNERS = 6, FIELDS = 7 };

/* The least bits of a number are often those of a value that exists. */
static const uint32_t numbers[6] = {9, 10, 66, 255, 0x7FFFFFFFu, 0xFFFFFFF1u};

static void set_field(qtri_material *m, qtri_texture *t, qtri_stroke *s, int field, uint32_t number)
{
    switch (field) {
    case 0:
        m->interpolation = (qtri_interpolation)number;
        break;
    case 1:
        m->texture_mode = (qtri_texture_mode)number;
        break;
    case 2:
        m->cull = (qtri_cull)number;
        break;
    case 3:
        m->depth_compare = (qtri_compare)number;
        break;
    case 4:
        t->wrap_u = (qtri_wrap)number;
        break;
    case 5:
        t->wrap_v = (qtri_wrap)number;
        break;
    default:
        s->cap = (qtri_cap)number;
        break;
    }
}

static const uint32_t stands_for[FIELDS] = {QTRI_SCREEN_LINEAR, QTRI_MODULATE, QTRI_CULL_NONE,
                                            QTRI_ALWAYS,        QTRI_REPEAT,   QTRI_REPEAT,
                                            QTRI_CAP_ROUND};

typedef struct setting {
    const qtri_format *format;
    const qtri_depth_format *depth;
    int field, fill, effect;
} setting;

typedef struct board {
    qtri_surface surface;
    uint32_t memory[QTRI_BAND_BYTES_DEPTH(WIDTH, HEIGHT, QTRI_XRGB8888_X4_BYTES, 4) / 4];
} board;

static void draw_all(const qtri_surface *surface, const qtri_material *m, const qtri_stroke *stroke)
{
    static const qtri_corner corners[CORNERS] = {
        {{Q16(-2), Q16(-.5), Q16(4), Q16(1)}, {255, 0, 0}, {0, 0}}, /* behind the eye */
        {{Q16(1), Q16(-.5), Q16(-1), Q16(1)}, {0, 255, 0}, {Q16(3), 0}},
        {{Q16(.5), Q16(2), Q16(-3), Q16(2)}, {0, 0, 255}, {0, Q16(3)}},
        {{Q16(-1), Q16(-1), 0, Q16(1)}, {255, 255, 0}, {0, 0}},
        {{Q16(1), Q16(-.5), Q16(.5), Q16(1)}, {0, 255, 255}, {Q16(1), 0}},
        {{0, Q16(.5), Q16(-.5), Q16(1)}, {255, 0, 255}, {0, Q16(1)}},
    };
    qtri_vertex vertices[CUBE_VERTICES];
    qtri_transform pose;
    qtri_view view = cube_view(WIDTH, HEIGHT, 3, vertices, CUBE_VERTICES, &pose);
    qtri_mesh mesh = cube_mesh();
    mesh.triangle_count--; /* a hole, through which back faces are seen */
    qtri_draw_mesh(surface, &view, &pose, &mesh, m);
    mesh.triangle_count++;
    qtri_transform_translate(&pose, vec3_of(.7, .2, 0));
    qtri_draw_mesh(surface, &view, &pose, &mesh, m);
    qtri_draw_triangles(surface, &view, &pose, corners, CORNERS, m);
    qtri_draw_lines(surface, &view, &pose, corners, CORNERS, m);
    qtri_draw_polyline(surface, &view, &pose, corners, CORNERS, stroke, m);
    qtri_draw_points(surface, &view, &pose, corners, CORNERS, stroke, m);
}

static void draw_with(board *b, const setting *s, uint32_t number)
{
    static const qtri_fill *const fills[3] = {NULL, &qtri_wireframe, &qtri_smooth_wireframe};
    static const uint16_t texels[16] = {0xF800, 0x07E0, 0x001F, 0xFFFF, 0x1234, 0x7BEF, 0xF81F};
    qtri_texture texture = {.texels = texels,
                            .format = &qtri_texel_rgb565,
                            .width_log2 = 2,
                            .height_log2 = 2,
                            .filter = s->effect == 1 ? &qtri_bilinear : NULL};
    qtri_stroke stroke = qtri_stroke_default();
    qtri_material m = qtri_material_default();
    stroke.width = Q16(4.5);
    stroke.edges = s->effect == 1 ? NULL : stroke.edges;
    m.texture = s->fill == 0 ? &texture : NULL;
    m.fill = fills[s->fill];
    m.blend = s->effect == 2 ? &qtri_blend_alpha : NULL;
    m.alpha = 100;
    set_field(&m, &texture, &stroke, s->field, number);
    memset(b, 0, sizeof *b);
    assert_ok(surface_with_depth(&b->surface, s->format, s->depth, WIDTH, HEIGHT, 0, HEIGHT,
                                 b->memory, sizeof b->memory));
    const qtri_rgb sky = {10, 20, 60};
    if (s->format->pixels->bytes >= QTRI_GRAY8_X4_BYTES) {
        qtri_samples_clear(&b->surface, sky);
    } else {
        qtri_surface_clear(&b->surface, sky);
    }
    draw_all(&b->surface, &m, &stroke);
}

TEST(numbers_that_are_none_have_the_documented_result)
{
    static board expected, got;
    static const qtri_format *const formats[4] = {&qtri_rgb565, &qtri_xrgb8888, &qtri_gray8,
                                                  &qtri_rgb565_x4};
    for (int n = 0; n < FIELDS * 3 * 3 * 5; n++) {
        const int kind = n / (FIELDS * 3 * 3);
        const setting s = {.format = formats[kind % 4],
                           .depth = kind == 4 ? &qtri_depth_linear24 : NULL,
                           .field = n % FIELDS,
                           .fill = n / FIELDS % 3,
                           .effect = n / FIELDS / 3 % 3};
        draw_with(&expected, &s, stands_for[s.field]);
        for (int i = 0; i < (int)LENGTH_OF(numbers); i++) {
            draw_with(&got, &s, numbers[i]);
            if (memcmp(expected.memory, got.memory, sizeof got.memory) != 0) {
                fail_msg("field %d, %u: fill %d, effect %d, format %d", s.field,
                         (unsigned)numbers[i], s.fill, s.effect, kind);
            }
        }
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
