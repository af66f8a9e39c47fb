/* SPDX-License-Identifier: MIT */
#include "bench_scenes.h"

#include "bench_paint.h"

/* README.md says what each scene is. */
#define COMPACT(mesh)        &bench_mesh_##mesh##_compact
#define QUAD(quad_, colors_) .work = BENCH_QUAD, .quad = (quad_), .colors = (colors_)
#define MESH(mesh_, turn_)   .work = BENCH_MESH, .mesh = (mesh_), .turn = (turn_)
#define FLAT                 .shading = QTRI_FLAT_LAST
#define BY_PIXEL             .shading = QTRI_PER_PIXEL
#define BANDS                .band_rows = 16
#define FORMAT               &qtri_rgb565
#define PAINT(name_, paint_)                                                                       \
    {                                                                                              \
        .name = (name_), .work = BENCH_PAINT, .paint = (paint_)                                    \
    }

static const qtri_rgb white[4] = {
    {255, 255, 255}, {255, 255, 255}, {255, 255, 255}, {255, 255, 255}};
static const qtri_rgb orange[4] = {{255, 128, 64}, {255, 128, 64}, {255, 128, 64}, {255, 128, 64}};
static const qtri_rgb rainbow[4] = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 0}};

/* clang-format off */
const bench_scene bench_scenes[] = {
    {.name = "S0", .work = BENCH_CLEAR},
    {.name = "S1", QUAD(&bench_screen, orange), FLAT},
    {.name = "S2", QUAD(&bench_screen, rainbow)},
    {.name = "S3", QUAD(&bench_floor, white), .textured = true},
    {.name = "S3a", QUAD(&bench_floor, white), .textured = true, .interpolation = QTRI_SCREEN_LINEAR},
    {.name = "S4", MESH(COMPACT(spot), Q16(150))},
    {.name = "S5", MESH(COMPACT(teapot), Q16(30)), FLAT},
    {.name = "S6", MESH(COMPACT(spot_uv), Q16(150)), .textured = true},
    {.name = "S7", MESH(COMPACT(spot), Q16(150)), .wireframe = true},
    {.name = "S8", MESH(COMPACT(wall), 0), .textured = true},
    {.name = "S8w", MESH(COMPACT(wall), 0), .textured = true, .white = true},
    {.name = "S9", MESH(COMPACT(spot), Q16(150)), .colors = bench_colors_spot},
    {.name = "S10", MESH(COMPACT(spot), Q16(150)), .wireframe = true, .without_depth = true},
    {.name = "S11", QUAD(&bench_turned, white), .textured = true},
    {.name = "S12", MESH(&bench_mesh_torus96_compact, Q16(25))},
    {.name = "S12b", MESH(&bench_mesh_torus216_compact, Q16(25))},
    {.name = "S12c", MESH(&bench_mesh_torus384_compact, Q16(25))},
    {.name = "S12d", MESH(&bench_mesh_torus864_compact, Q16(25))},
    {.name = "S13a", MESH(&bench_mesh_torus96_compact, Q16(25)), .textured = true},
    {.name = "S13b", MESH(&bench_mesh_torus216_compact, Q16(25)), .textured = true},
    {.name = "S13", MESH(&bench_mesh_torus384_compact, Q16(25)), .textured = true},
    {.name = "S13d", MESH(&bench_mesh_torus864_compact, Q16(25)), .textured = true},
    {.name = "S14", MESH(&bench_cube, 0), FLAT, .calls = 64},
    {.name = "SB", MESH(&bench_box, Q16(45)), .colors = bench_box_colors},
    {.name = "SBl", MESH(&bench_box, Q16(45))},
    {.name = "SBt", MESH(&bench_box, Q16(45)), .textured = true},
    {.name = "SE", MESH(&bench_turned_away, 0)},
    {.name = "ST", .work = BENCH_CORNERS, .mesh = &bench_mesh_spot, .turn = Q16(150), .colors = bench_colors_spot},
    {.name = "S4k", MESH(COMPACT(knot), Q16(30))},
    {.name = "S5k", MESH(COMPACT(knot), Q16(30)), FLAT},
    {.name = "S7k", MESH(COMPACT(knot), Q16(30)), .wireframe = true},
    {.name = "S4w", MESH(&bench_mesh_spot, Q16(150))},
    {.name = "S5w", MESH(&bench_mesh_teapot, Q16(30)), FLAT},
    {.name = "S4b", MESH(COMPACT(spot), Q16(150)), BANDS},
    {.name = "S4wb", MESH(&bench_mesh_spot, Q16(150)), BANDS},
    {.name = "S5b", MESH(COMPACT(teapot), Q16(30)), FLAT, BANDS},
    {.name = "S6b", MESH(COMPACT(spot_uv), Q16(150)), .textured = true, BANDS},
    {.name = "S7b", MESH(COMPACT(spot), Q16(150)), .wireframe = true, BANDS},
    {.name = "S4kb", MESH(COMPACT(knot), Q16(30)), BANDS},
    {.name = "L1", MESH(COMPACT(spot), Q16(150)), .lights = 1},
    {.name = "L2", MESH(COMPACT(spot), Q16(150)), .lights = 2},
    {.name = "L3", MESH(COMPACT(spot), Q16(150)), .lights = 4},
    {.name = "L1f", MESH(COMPACT(teapot), Q16(30)), FLAT, .lights = 1},
    {.name = "L1b", MESH(COMPACT(spot), Q16(150)), BANDS, .lights = 1},
    {.name = "LP", QUAD(&bench_screen, orange), BY_PIXEL, .lights = 1},
    {.name = "LPd", QUAD(&bench_screen, orange), BY_PIXEL, .lights = 1, .dull = true},
    {.name = "LPf", QUAD(&bench_floor, white), BY_PIXEL, .lights = 1},
    {.name = "S4e", MESH(COMPACT(spot), Q16(150)), .smooth = BENCH_EDGES},
    {.name = "S4es", MESH(COMPACT(spot), Q16(150)), .smooth = BENCH_SUMS},
    {.name = "S4h", MESH(COMPACT(spot), Q16(150)), .smooth = BENCH_HALVE},
    {.name = "S4x", MESH(COMPACT(spot), Q16(150)), .smooth = BENCH_SAMPLES},
    {.name = "S6x", MESH(COMPACT(spot_uv), Q16(150)), .textured = true, .smooth = BENCH_SAMPLES},
    {.name = "S11x", QUAD(&bench_turned, white), .textured = true, .smooth = BENCH_SAMPLES},
    {.name = "B4x", MESH(COMPACT(spot), Q16(150)), .blend = &qtri_blend_alpha, .smooth = BENCH_SAMPLES},
    {.name = "F4x", MESH(COMPACT(spot), Q16(150)), .fog = true, .smooth = BENCH_SAMPLES},
    {.name = "S4f", MESH(COMPACT(spot), Q16(150)), .smooth = BENCH_FXAA},
    {.name = "S4a", MESH(COMPACT(spot), Q16(150)), .smooth = BENCH_ADD},
    {.name = "S4m", MESH(COMPACT(spot), Q16(150)), .smooth = BENCH_STORE},
    {.name = "S4be", MESH(COMPACT(spot), Q16(150)), BANDS, .smooth = BENCH_EDGES},
    {.name = "S4br", MESH(COMPACT(spot), Q16(150)), BANDS, .smooth = BENCH_EDGES, .keeps = true},
    {.name = "K1", .work = BENCH_STROKE, .width = Q16(1)},
    {.name = "K5", .work = BENCH_STROKE, .width = Q16(5)},
    {.name = "KP", .work = BENCH_STROKE, .width = Q16(6), .points = true},
    {.name = "KQ", .work = BENCH_STROKE, .width = Q16(2), .points = true},
    {.name = "KC", .work = BENCH_STROKE, .width = Q16(3), .chart = true},
    {.name = "KW", MESH(COMPACT(spot), Q16(150)), .width = Q16(1)},
    {.name = "KS", MESH(COMPACT(spot), Q16(150)), .wireframe = true, .thin = true},
    {.name = "KH", MESH(COMPACT(spot), Q16(150)), .hidden = true},
    {.name = "B1", QUAD(&bench_screen, orange), FLAT, .blend = &qtri_blend_alpha},
    {.name = "B2", QUAD(&bench_screen, rainbow), .blend = &qtri_blend_alpha},
    {.name = "B3", QUAD(&bench_screen, rainbow), .blend = &qtri_blend_add},
    {.name = "B4", MESH(COMPACT(spot), Q16(150)), .blend = &qtri_blend_alpha},
    {.name = "B5", QUAD(&bench_screen, rainbow), .blend = &qtri_blend_vertex_alpha},
    {.name = "B6", QUAD(&bench_turned, rainbow), .blend = &qtri_blend_vertex_alpha},
    {.name = "F2", QUAD(&bench_screen, rainbow), .fog = true},
    {.name = "F11", QUAD(&bench_turned, white), .textured = true, .fog = true},
    {.name = "F4", MESH(COMPACT(spot), Q16(150)), .fog = true},
    {.name = "B11", QUAD(&bench_turned, white), .textured = true, .sprite = true, .blend = &qtri_blend_alpha},
    {.name = "B7", MESH(COMPACT(spot_uv), Q16(150)), .textured = true, .blend = &qtri_blend_alpha},
    {.name = "F6", MESH(COMPACT(spot_uv), Q16(150)), .textured = true, .fog = true},
    {.name = "D1", QUAD(&bench_screen, orange), FLAT, .depth = &qtri_depth_float16},
    {.name = "D2", QUAD(&bench_screen, rainbow), .depth = &qtri_depth_float16},
    {.name = "D3", QUAD(&bench_floor, white), .textured = true, .depth = &qtri_depth_float16},
    {.name = "D6", MESH(COMPACT(spot_uv), Q16(150)), .textured = true, .depth = &qtri_depth_float16},
    {.name = "F5", .work = BENCH_STROKE, .width = Q16(5), .fog = true},
    {.name = "S3m", QUAD(&bench_floor, white), .textured = true, .filter = &qtri_mipmapped},
    {.name = "S6m", MESH(COMPACT(spot_uv), Q16(150)), .textured = true, .filter = &qtri_mipmapped},
    {.name = "S8m", MESH(COMPACT(wall), 0), .textured = true, .filter = &qtri_mipmapped},
    {.name = "S11m", QUAD(&bench_turned, white), .textured = true, .filter = &qtri_mipmapped},
    {.name = "S11f", QUAD(&bench_turned, white), .textured = true, .filter = &qtri_bilinear},
    /* The rows of models once more, with a mesh that everybody has. */
    {.name = "S6k", MESH(COMPACT(knot_uv), Q16(30)), .textured = true},
    {.name = "S9k", MESH(COMPACT(knot), Q16(30)), .colors = bench_colors_knot},
    {.name = "S10k", MESH(COMPACT(knot), Q16(30)), .wireframe = true, .without_depth = true},
    {.name = "STk", .work = BENCH_CORNERS, .mesh = &bench_mesh_knot, .turn = Q16(30), .colors = bench_colors_knot},
    {.name = "S4wk", MESH(&bench_mesh_knot, Q16(30))},
    {.name = "S5wk", MESH(&bench_mesh_knot, Q16(30)), FLAT},
    {.name = "S4wbk", MESH(&bench_mesh_knot, Q16(30)), BANDS},
    {.name = "S5bk", MESH(COMPACT(knot), Q16(30)), FLAT, BANDS},
    {.name = "S6bk", MESH(COMPACT(knot_uv), Q16(30)), .textured = true, BANDS},
    {.name = "S7bk", MESH(COMPACT(knot), Q16(30)), .wireframe = true, BANDS},
    {.name = "L1k", MESH(COMPACT(knot), Q16(30)), .lights = 1},
    {.name = "L2k", MESH(COMPACT(knot), Q16(30)), .lights = 2},
    {.name = "L3k", MESH(COMPACT(knot), Q16(30)), .lights = 4},
    {.name = "L1fk", MESH(COMPACT(knot), Q16(30)), FLAT, .lights = 1},
    {.name = "L1bk", MESH(COMPACT(knot), Q16(30)), BANDS, .lights = 1},
    {.name = "LPk", MESH(COMPACT(knot), Q16(30)), BY_PIXEL, .lights = 1},
    {.name = "S4ek", MESH(COMPACT(knot), Q16(30)), .smooth = BENCH_EDGES},
    {.name = "S4esk", MESH(COMPACT(knot), Q16(30)), .smooth = BENCH_SUMS},
    {.name = "S4hk", MESH(COMPACT(knot), Q16(30)), .smooth = BENCH_HALVE},
    {.name = "S4xk", MESH(COMPACT(knot), Q16(30)), .smooth = BENCH_SAMPLES},
    {.name = "B4xk", MESH(COMPACT(knot), Q16(30)), .blend = &qtri_blend_alpha, .smooth = BENCH_SAMPLES},
    {.name = "F4xk", MESH(COMPACT(knot), Q16(30)), .fog = true, .smooth = BENCH_SAMPLES},
    {.name = "S6xk", MESH(COMPACT(knot_uv), Q16(30)), .textured = true, .smooth = BENCH_SAMPLES},
    {.name = "S4fk", MESH(COMPACT(knot), Q16(30)), .smooth = BENCH_FXAA},
    {.name = "S4ak", MESH(COMPACT(knot), Q16(30)), .smooth = BENCH_ADD},
    {.name = "S4mk", MESH(COMPACT(knot), Q16(30)), .smooth = BENCH_STORE},
    {.name = "S4bek", MESH(COMPACT(knot), Q16(30)), BANDS, .smooth = BENCH_EDGES},
    {.name = "KWk", MESH(COMPACT(knot), Q16(30)), .width = Q16(1)},
    {.name = "KSk", MESH(COMPACT(knot), Q16(30)), .wireframe = true, .thin = true},
    {.name = "KHk", MESH(COMPACT(knot), Q16(30)), .hidden = true},
    {.name = "B4k", MESH(COMPACT(knot), Q16(30)), .blend = &qtri_blend_alpha},
    {.name = "F4k", MESH(COMPACT(knot), Q16(30)), .fog = true},
    {.name = "B7k", MESH(COMPACT(knot_uv), Q16(30)), .textured = true, .blend = &qtri_blend_alpha},
    {.name = "D6k", MESH(COMPACT(knot_uv), Q16(30)), .textured = true, .depth = &qtri_depth_float16},
    {.name = "F6k", MESH(COMPACT(knot_uv), Q16(30)), .textured = true, .fog = true},
    {.name = "S6mk", MESH(COMPACT(knot_uv), Q16(30)), .textured = true, .filter = &qtri_mipmapped},
    /* Next door. */
    {.name = "S7s", MESH(COMPACT(spot), Q16(150)), .wireframe = true, .format = &qtri_rgb565_swapped},
    {.name = "S7g", MESH(COMPACT(spot), Q16(150)), .wireframe = true, .format = &qtri_gray8},
    {.name = "S7l", MESH(COMPACT(spot), Q16(150)), .wireframe = true, .compare = QTRI_LESS_EQUAL},
    {.name = "KSs", MESH(COMPACT(spot), Q16(150)), .wireframe = true, .thin = true, .format = &qtri_rgb565_swapped},
    {.name = "KSl", MESH(COMPACT(spot), Q16(150)), .wireframe = true, .thin = true, .compare = QTRI_LESS_EQUAL},
    {.name = "KPg", .work = BENCH_STROKE, .width = Q16(6), .points = true, .format = &qtri_gray8},
    /* By the generic pipeline. */
    {.name = "S1l", QUAD(&bench_screen, orange), FLAT, .compare = QTRI_LESS_EQUAL},
    {.name = "S2l", QUAD(&bench_screen, rainbow), .compare = QTRI_LESS_EQUAL},
    {.name = "S3l", QUAD(&bench_floor, white), .textured = true, .compare = QTRI_LESS_EQUAL},
    {.name = "S4kl", MESH(COMPACT(knot), Q16(30)), .compare = QTRI_LESS_EQUAL},
    {.name = "S6kl", MESH(COMPACT(knot_uv), Q16(30)), .textured = true, .compare = QTRI_LESS_EQUAL},
    {.name = "S4kg", MESH(COMPACT(knot), Q16(30)), .format = &qtri_gray8},
    {.name = "S3q", QUAD(&bench_floor, white), .textured = true, .keyed = true},
    {.name = "B1l",
     QUAD(&bench_screen, orange),
     FLAT,
     .blend = &qtri_blend_alpha,
     .compare = QTRI_LESS_EQUAL},
    {.name = "B4kl",
     MESH(COMPACT(knot), Q16(30)),
     .blend = &qtri_blend_alpha,
     .compare = QTRI_LESS_EQUAL},
    {.name = "F4kl", MESH(COMPACT(knot), Q16(30)), .fog = true, .compare = QTRI_LESS_EQUAL},
    {.name = "S11l",
     QUAD(&bench_turned, white),
     .textured = true,
     .filter = &qtri_bilinear,
     .compare = QTRI_LESS_EQUAL},
    {.name = "D6l",
     MESH(COMPACT(knot_uv), Q16(30)),
     .textured = true,
     .depth = &qtri_depth_float16,
     .compare = QTRI_LESS_EQUAL},
    {.name = "S3v", QUAD(&bench_floor, white), .textured = true, .texels_888 = true},
    PAINT("P1", bench_paint_rect),
    PAINT("P2", bench_paint_rects),
    PAINT("P3", bench_paint_alpha),
    PAINT("P4", bench_paint_copy),
    PAINT("P5", bench_paint_keyed),
    PAINT("P6", bench_paint_turned),
    PAINT("P7", bench_paint_circle),
    PAINT("P8", bench_paint_smooth),
    PAINT("P9", bench_paint_polygon),
    {.name = "P10", .work = BENCH_PAINT, .paint = bench_paint_text, .characters = BENCH_PAINT_CHARACTERS},
    {.name = NULL},
};
/* clang-format on */

/* The mean of four texels, without what makes it right in linear light. */
static uint16_t mean_of(const uint16_t *row, uint32_t side)
{
    const uint16_t four[4] = {row[0], row[1], row[side], row[side + 1]};
    uint32_t red_blue = 0, green = 0;
    for (int i = 0; i < 4; i++) {
        red_blue += (four[i] & 0xF800u) << 8 | (four[i] & 0x1Fu);
        green += four[i] & 0x7E0u;
    }
    return (uint16_t)((red_blue >> 10 & 0xF800) | (green >> 2 & 0x7E0) | (red_blue >> 2 & 0x1F));
}

static void set_levels(bench_frame *frame)
{
    const uint16_t *from = frame->texels;
    uint16_t *to = frame->texels + BENCH_TEXTURE_SIDE * BENCH_TEXTURE_SIDE;
    uint32_t side = BENCH_TEXTURE_SIDE;
    for (uint32_t level = 0; level < BENCH_TEXTURE_LOG2 - 1; level++) {
        frame->levels[level] = to;
        for (uint32_t i = 0; i < side * side / 4; i++) {
            to[i] = mean_of(&from[2 * (i / (side / 2) * side + i % (side / 2))], side);
        }
        from = to;
        to += side * side / 4;
        side /= 2;
    }
    frame->texture.levels = frame->levels;
    frame->texture.level_count = BENCH_TEXTURE_LOG2 - 1;
    frame->texture.filter = frame->scene->filter;
}

static void set_texels_888(bench_frame *frame)
{
    for (uint32_t i = 0; i < BENCH_TEXTURE_SIDE * BENCH_TEXTURE_SIDE; i++) {
        const qtri_rgb c = bench_texel(i % BENCH_TEXTURE_SIDE, i / BENCH_TEXTURE_SIDE);
        frame->texels_888[i] = (uint32_t)c.r << 16 | (uint32_t)c.g << 8 | c.b;
    }
    frame->texture.texels = frame->texels_888;
    frame->texture.format = &qtri_texel_xrgb8888;
}

static void set_sprite(bench_frame *frame)
{
    for (uint32_t i = 0; i < BENCH_TEXTURE_SIDE * BENCH_TEXTURE_SIDE; i++) {
        const qtri_rgb c = bench_texel(i % BENCH_TEXTURE_SIDE, i / BENCH_TEXTURE_SIDE);
        frame->texels[i] = (uint16_t)(0x8000 | c.r >> 4 << 8 | c.g >> 4 << 4 | c.b >> 4);
    }
    frame->texture.format = &qtri_texel_argb4444;
}

static void set_texture(bench_frame *frame, qtri_texture_mode mode)
{
    for (uint32_t i = 0; i < BENCH_TEXTURE_SIDE * BENCH_TEXTURE_SIDE; i++) {
        frame->texels[i] =
            bench_rgb565(bench_texel(i % BENCH_TEXTURE_SIDE, i / BENCH_TEXTURE_SIDE));
    }
    const qtri_texture texture = {.texels = frame->texels,
                                  .format = &qtri_texel_rgb565,
                                  .width_log2 = BENCH_TEXTURE_LOG2,
                                  .height_log2 = BENCH_TEXTURE_LOG2};
    frame->texture = texture;
    frame->texture.has_key = frame->scene->keyed;
    frame->texture.key = 0xFFFF; /* bench_texel() is not white */
    if (frame->scene->texels_888) {
        set_texels_888(frame);
    }
    if (frame->scene->sprite) {
        set_sprite(frame);
    }
    set_levels(frame);
    frame->material.texture = &frame->texture;
    frame->material.texture_mode = mode;
}

static const qtri_light_source sources[] = {
    {.kind = &qtri_point_light,
     .position = {Q16(1.5), Q16(1), Q16(3)},
     .color = {Q16(1), Q16(.9), Q16(.8)},
     .constant = Q16(1),
     .quadratic = Q16(.05)},
    {.kind = &qtri_directional_light,
     .position = {Q16(-1), Q16(.5), Q16(.3)},
     .color = {Q16(.1), Q16(.2), Q16(.4)}},
    {.kind = &qtri_directional_light,
     .position = {Q16(.4), Q16(.6), Q16(.69282032)},
     .color = {Q16(.2), Q16(.2), Q16(.2)}},
    {.kind = &qtri_directional_light,
     .position = {Q16(.2), Q16(-.8), Q16(.5)},
     .color = {Q16(.2), Q16(.1), Q16(.1)}},
};

/* In the world; the camera looks at it from z = 3. */
static void set_lights(bench_frame *frame)
{
    const qtri_light_color ambient = {Q16(.125), Q16(.125), Q16(.125)};
    const qtri_reflection reflection = {.specular = {255, 255, 255},
                                        .shininess = &frame->shininess};
    if (frame->scene->lights == 0) {
        return;
    }
    qtri_shininess_init(&frame->shininess, Q16(30));
    (void)qtri_light_init(&frame->lights, sources, frame->scene->lights, ambient);
    frame->reflection = reflection;
    frame->material.reflection = frame->scene->dull ? NULL : &frame->reflection;
    frame->view.light = &frame->lights;
    frame->view.vertex_count = QTRI_LIT_VERTICES(BENCH_VERTICES_MAX);
}

static void set_mesh(bench_frame *frame)
{
    frame->view.light = &bench_light;
    frame->view.vertices = frame->vertices;
    frame->view.vertex_count = frame->scene->mesh->vertex_count;
    frame->mesh = *frame->scene->mesh;
    frame->mesh.colors = frame->scene->colors;
    set_lights(frame);
}

static void set_corners(bench_frame *frame)
{
    const bench_scene *scene = frame->scene;
    const qtri_mesh *mesh = scene->mesh;
    for (uint32_t i = 0; i < 3 * mesh->triangle_count; i++) {
        uint32_t vertex = mesh->triangles[i / 3][i % 3];
        const qtri_vec3 *p = &mesh->positions[vertex];
        const qtri_corner corner = {{p->x, p->y, p->z, Q16_ONE}, scene->colors[vertex], {0, 0}};
        frame->corners[i] = corner;
    }
}

/* Bands lie in the memory of the whole frame, one below the other, so that there is a picture. */
static void draw_bands(bench_frame *frame)
{
    const qtri_surface *whole = &frame->surface;
    qtri_surface band;
    qtri_prepare_mesh(&frame->prepared, &frame->bands, &frame->view, &frame->pose, &frame->mesh,
                      &frame->material);
    while (qtri_frame_next_band(&frame->bands, &band)) {
        band.pixels = whole->pixels + band.first_row * whole->pitch;
        band.depth = whole->depth + band.first_row * whole->depth_pitch;
        qtri_draw_prepared(&band, &frame->prepared);
    }
}

static bool set_bands(bench_frame *frame)
{
    qtri_prepared_init(&frame->prepared, NULL, 0); /* in memory that scenes share */
    frame->prepared.vertices = frame->vertices;
    frame->prepared.vertex_count = sizeof frame->vertices / sizeof frame->vertices[0];
    frame->prepared.lists = frame->lists;
    frame->prepared.list_count = sizeof frame->lists / sizeof frame->lists[0];
    return qtri_frame_init(&frame->bands, FORMAT, BENCH_WIDTH, BENCH_HEIGHT,
                           frame->scene->band_rows, frame->memory, sizeof frame->memory) == QTRI_OK;
}

/* Half of each pixel; fog that hides a quarter of the middle. */
static void set_effects(bench_frame *frame, const bench_scene *scene)
{
    static const qtri_fog_range range = {Q16(0.1), Q16(100), false};
    static const qtri_rgb gray = {128, 144, 160};
    static const uint8_t alphas[6] = {255, 153, 51, 255, 51, 204};
    frame->material.blend = scene->blend;
    frame->material.alpha = scene->blend == &qtri_blend_vertex_alpha ? 255 : 128;
    frame->material.alphas = alphas;
    if (scene->fog) {
        qtri_fog_exp2(&frame->fog, gray, range, Q16(0.18));
        frame->material.fog = &frame->fog;
    }
}

bool bench_prepare(bench_frame *frame, const bench_scene *scene)
{
    if (scene->mesh != NULL && scene->mesh->triangle_count == 0) {
        return false;
    }
    frame->scene = scene;
    bench_set_view(&frame->view, BENCH_WIDTH, BENCH_HEIGHT);
    qtri_transform_identity(&frame->pose);
    qtri_transform_rotate_y(&frame->pose, scene->turn);
    frame->material = qtri_material_default();
    const qtri_rgb white_color = {255, 255, 255};
    frame->material.color = scene->white ? white_color : bench_lit_color;
    frame->material.cull = scene->mesh != NULL ? QTRI_CULL_BACK : QTRI_CULL_NONE;
    frame->material.shading = scene->shading != NULL ? scene->shading : QTRI_SMOOTH;
    frame->material.interpolation = scene->interpolation;
    frame->material.fill = scene->thin        ? &qtri_smooth_wireframe
                           : scene->wireframe ? &qtri_wireframe
                                              : NULL;
    set_effects(frame, scene);
    if (scene->compare != 0) {
        frame->material.depth_compare = scene->compare;
    }
    if (scene->without_depth) {
        frame->material.depth_compare = QTRI_DEPTH_OFF;
    }
    if (scene->textured) {
        set_texture(frame, scene->work == BENCH_MESH ? QTRI_MODULATE : QTRI_REPLACE);
    }
    if (scene->work == BENCH_PAINT) {
        set_texture(frame, QTRI_REPLACE); /* pictures are of its memory */
    } else if (scene->work == BENCH_QUAD) {
        bench_set_quad(frame->corners, scene->quad, scene->colors);
        set_lights(frame);
    } else if (scene->work == BENCH_MESH) {
        set_mesh(frame);
    } else if (scene->work == BENCH_CORNERS) {
        set_corners(frame);
    }
    if (scene->work == BENCH_STROKE) {
        (void)bench_set_strokes(frame->corners, scene);
        frame->view.vertices = frame->vertices;
        frame->view.vertex_count = BENCH_VERTICES_MAX;
    }
    if (qtri_surface_init(&frame->surface, scene->format != NULL ? scene->format : &qtri_rgb565,
                          BENCH_WIDTH, BENCH_HEIGHT, 0, BENCH_HEIGHT, frame->memory,
                          sizeof frame->memory) != QTRI_OK) {
        return false;
    }
    if (scene->band_rows != 0 && !set_bands(frame)) {
        return false;
    }
    frame->surface.depth_format = scene->depth;
    const qtri_rgb other = {255, 255, 255}; /* for S0, anything but what it is to become */
    qtri_surface_clear(&frame->surface, scene->work == BENCH_CLEAR ? other : bench_background);
    if (scene->work == BENCH_CLEAR) {
        qtri_surface_clear_depth(&frame->surface, 0);
    }
    return scene->smooth == BENCH_JAGGED || bench_prepare_smooth(frame);
}

void bench_finish(bench_frame *frame)
{
    if (frame->scene->smooth != BENCH_JAGGED) {
        bench_finish_smooth(frame);
    }
}

/* Copies of the mesh in rows of eight. */
static void draw_calls(bench_frame *frame)
{
    for (uint32_t i = 0; i < frame->scene->calls; i++) {
        const qtri_vec3 place = {Q16(.4) * (int32_t)(i % 8) - Q16(1.4),
                                 Q16(.4) * (int32_t)(i / 8) - Q16(1.4), 0};
        const qtri_vec3 axis = {Q16_ONE, Q16(2), 0};
        qtri_transform_identity(&frame->pose);
        qtri_transform_translate(&frame->pose, place);
        qtri_transform_rotate(&frame->pose, Q16(11) * (int32_t)(i + 1), axis);
        qtri_draw_mesh(&frame->surface, &frame->view, &frame->pose, &frame->mesh, &frame->material);
    }
}

void bench_draw(bench_frame *frame)
{
    if (frame->scene->smooth != BENCH_JAGGED) {
        bench_draw_smooth(frame);
        return;
    }
    if (frame->scene->band_rows != 0) {
        draw_bands(frame);
        return;
    }
    switch (frame->scene->work) {
    case BENCH_CLEAR:
        qtri_surface_clear(&frame->surface, bench_background);
        break;
    case BENCH_PAINT:
        frame->scene->paint(frame);
        break;
    case BENCH_MESH:
        if (frame->scene->width != 0 || frame->scene->hidden) {
            bench_draw_strokes(frame);
            break;
        }
        if (frame->scene->calls != 0) {
            draw_calls(frame);
            break;
        }
        qtri_draw_mesh(&frame->surface, &frame->view, &frame->pose, &frame->mesh, &frame->material);
        break;
    case BENCH_STROKE:
        bench_draw_strokes(frame);
        break;
    case BENCH_QUAD:
        qtri_draw_lit_triangles(&frame->surface, &frame->view, &frame->pose, frame->corners, NULL,
                                6, &frame->material);
        break;
    default:
        qtri_draw_triangles(&frame->surface, &frame->view, &frame->pose, frame->corners,
                            3 * bench_triangles(frame->scene), &frame->material);
        break;
    }
}

uint32_t bench_triangles(const bench_scene *scene)
{
    if (scene->work == BENCH_PAINT) {
        return scene->characters;
    }
    const uint32_t calls = scene->calls != 0 ? scene->calls : 1;
    return scene->mesh != NULL ? calls * scene->mesh->triangle_count : scene->quad != NULL ? 2 : 0;
}

/* Without depth, what was drawn on RGB565 is known by its colour, which nothing shares with the
   background. */
bool bench_is_drawn(const bench_frame *frame, int32_t x, int32_t y)
{
    const qtri_surface *surface = &frame->surface;
    const void *row = surface->pixels + y * surface->pitch;
    const uint16_t *color = row;
    return (frame->scene->format == NULL && color[x] != bench_rgb565(bench_background)) ||
           surface->depth[y * surface->depth_pitch + x] != UINT16_MAX;
}
