/* SPDX-License-Identifier: MIT */
/*
 * Three scenes on a colour LCD of 320x240: a Gouraud-shaded quad, a textured floor in perspective
 * and a lit mesh, as the benchmark scenes S2, S3 and S4 are, the last with a torus made here.
 */
#include "board_scenes.h"
#include "display_show.h"

enum { WIDTH = 320, HEIGHT = 240, TEXTURE_LOG2 = 6, TEXTURE_SIDE = 1 << TEXTURE_LOG2 };

typedef struct lcd_memory {
    board_scene_memory meshes;
    uint16_t texels[TEXTURE_SIDE * TEXTURE_SIDE];
    uint32_t frame;
} lcd_memory;

static uint16_t rgb565(uint32_t r, uint32_t g, uint32_t b)
{
    return (uint16_t)((r * 31 + 127) / 255 << 11 | (g * 63 + 127) / 255 << 5 |
                      (b * 31 + 127) / 255);
}

static void prepare(void *memory)
{
    lcd_memory *lcd = memory;
    board_scenes_prepare(&lcd->meshes);
    for (uint32_t i = 0; i < TEXTURE_SIDE * TEXTURE_SIDE; i++) {
        uint32_t x = i % TEXTURE_SIDE, y = i / TEXTURE_SIDE;
        lcd->texels[i] = ((x >> 3 ^ y >> 3) & 1) != 0 ? rgb565(255, 4 * x, 4 * y)
                                                      : rgb565(4 * y, 64, 255 - 4 * x);
    }
}

/* Two triangles; corners counter-clockwise from the lower left one. */
static void draw_quad(const qtri_surface *surface, const qtri_view *view,
                      const qtri_material *material, const qtri_corner quad[4])
{
    const qtri_corner corners[6] = {quad[0], quad[1], quad[2], quad[0], quad[2], quad[3]};
    qtri_transform pose;
    qtri_transform_identity(&pose);
    qtri_draw_triangles(surface, view, &pose, corners, 6, material);
}

static void draw_gouraud(lcd_memory *lcd, const qtri_surface *surface, qtri_view *view)
{
    static const qtri_corner quad[4] = {
        {{Q16(-2.3070917), Q16(-1.7303188), 0, Q16_ONE}, {255, 0, 0}, {0, 0}},
        {{Q16(2.3070917), Q16(-1.7303188), 0, Q16_ONE}, {0, 255, 0}, {0, 0}},
        {{Q16(2.3070917), Q16(1.7303188), 0, Q16_ONE}, {0, 0, 255}, {0, 0}},
        {{Q16(-2.3070917), Q16(1.7303188), 0, Q16_ONE}, {255, 255, 0}, {0, 0}},
    };
    (void)lcd;
    qtri_material material = qtri_material_default();
    draw_quad(surface, view, &material, quad);
}

/* A quad of 6 x 4.8, turned by -60 degrees about x. */
static void draw_texture(lcd_memory *lcd, const qtri_surface *surface, qtri_view *view)
{
    static const qtri_corner quad[4] = {
        {{Q16(-3), Q16(-1.2), Q16(2.0784610), Q16_ONE}, {255, 255, 255}, {0, Q16_ONE}},
        {{Q16(3), Q16(-1.2), Q16(2.0784610), Q16_ONE}, {255, 255, 255}, {Q16_ONE, Q16_ONE}},
        {{Q16(3), Q16(1.2), Q16(-2.0784610), Q16_ONE}, {255, 255, 255}, {Q16_ONE, 0}},
        {{Q16(-3), Q16(1.2), Q16(-2.0784610), Q16_ONE}, {255, 255, 255}, {0, 0}},
    };
    const qtri_texture texture = {.texels = lcd->texels,
                                  .format = &qtri_texel_rgb565,
                                  .width_log2 = TEXTURE_LOG2,
                                  .height_log2 = TEXTURE_LOG2};
    qtri_material material = qtri_material_default();
    material.texture = &texture;
    material.texture_mode = QTRI_REPLACE;
    draw_quad(surface, view, &material, quad);
}

static void draw_mesh(lcd_memory *lcd, const qtri_surface *surface, qtri_view *view)
{
    static const qtri_light light = {
        .towards = {Q16(.4), Q16(.6), Q16(.69282032)}, .ambient = Q16(.2), .diffuse = Q16(.8)};
    qtri_mesh torus = board_torus(&lcd->meshes);
    view->light = &light;
    view->vertices = lcd->meshes.vertices;
    view->vertex_count = BOARD_TORUS_VERTICES;
    qtri_transform pose;
    qtri_transform_identity(&pose);
    qtri_transform_rotate_x(&pose, Q16(50));
    qtri_transform_rotate_z(&pose, Q16(-15));
    qtri_transform_scale(&pose, (qtri_vec3){Q16(.9), Q16(.9), Q16(.9)});
    qtri_material material = qtri_material_default();
    material.color = (qtri_rgb){255, 180, 90};
    qtri_draw_mesh(surface, view, &pose, &torus, &material);
}

static const struct {
    const char *name;
    void (*draw)(lcd_memory *lcd, const qtri_surface *surface, qtri_view *view);
} scenes[] = {{"gouraud", draw_gouraud}, {"texture", draw_texture}, {"mesh", draw_mesh}};

static const char *advance(void *memory, uint32_t frame)
{
    ((lcd_memory *)memory)->frame = frame;
    return scenes[frame].name;
}

static void draw(void *memory, const qtri_surface *surface)
{
    const qtri_vec3 eye = {0, 0, Q16(3)}, center = {0, 0, 0}, up = {0, Q16_ONE, 0};
    lcd_memory *lcd = memory;
    qtri_view view;
    qtri_view_init(&view, WIDTH, HEIGHT);
    qtri_transform_look_at(&view.camera, eye, center, up);
    qtri_transform_perspective(&view.projection, Q16(60), Q16(4.0 / 3.0), Q16(.1), Q16(100));
    scenes[lcd->frame].draw(lcd, surface, &view);
}

const display_show display_show_here = {
    .format = &qtri_rgb565,
    .width = WIDTH,
    .height = HEIGHT,
    .band_rows = 16,
    .background = {24, 32, 48},
    .frames = sizeof scenes / sizeof scenes[0],
    .bytes = sizeof(lcd_memory),
    .prepare = prepare,
    .advance = advance,
    .draw = draw,
};
