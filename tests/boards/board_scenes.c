/* SPDX-License-Identifier: MIT */
#include "board_scenes.h"

/* n = (cos b cos a, sin b, cos b sin a); position = (cos a, 0, sin a) + .4 n */
static void torus_vertex(board_scene_memory *memory, uint32_t ring, uint32_t side)
{
    q16 ring_sine, ring_cosine, side_sine, side_cosine;
    q16_sincos_deg((q16)ring * Q16(360.0 / BOARD_TORUS_RINGS), &ring_sine, &ring_cosine);
    q16_sincos_deg((q16)side * Q16(360.0 / BOARD_TORUS_SIDES), &side_sine, &side_cosine);
    qtri_vec3 normal = {q16_mul(side_cosine, ring_cosine), side_sine,
                        q16_mul(side_cosine, ring_sine)};
    qtri_vec3 center = {ring_cosine, 0, ring_sine};

    uint32_t i = ring * BOARD_TORUS_SIDES + side;
    memory->positions[i] = qtri_vec3_add(center, qtri_vec3_scale(normal, Q16(0.4)));
    memory->normals[i].x = (int16_t)(normal.x / 4); /* Q16.16 to Q2.14 */
    memory->normals[i].y = (int16_t)(normal.y / 4);
    memory->normals[i].z = (int16_t)(normal.z / 4);
}

static void torus_facet(board_scene_memory *memory, uint32_t ring, uint32_t side)
{
    uint32_t next_ring = (ring + 1) % BOARD_TORUS_RINGS;
    uint32_t next_side = (side + 1) % BOARD_TORUS_SIDES;
    uint16_t a = (uint16_t)(ring * BOARD_TORUS_SIDES + side);
    uint16_t b = (uint16_t)(ring * BOARD_TORUS_SIDES + next_side);
    uint16_t c = (uint16_t)(next_ring * BOARD_TORUS_SIDES + next_side);
    uint16_t d = (uint16_t)(next_ring * BOARD_TORUS_SIDES + side);
    uint16_t(*triangle)[3] = &memory->triangles[2 * a];
    triangle[0][0] = a, triangle[0][1] = b, triangle[0][2] = c;
    triangle[1][0] = a, triangle[1][1] = c, triangle[1][2] = d;
}

qtri_mesh board_torus(const board_scene_memory *memory)
{
    qtri_mesh torus = {.positions = memory->positions,
                       .normals = memory->normals,
                       .vertex_count = BOARD_TORUS_VERTICES,
                       .triangle_count = 2 * BOARD_TORUS_VERTICES};
    torus.triangles = (const uint16_t(*)[3])memory->triangles;
    return torus;
}

void board_scenes_prepare(board_scene_memory *memory)
{
    for (uint32_t ring = 0; ring < BOARD_TORUS_RINGS; ring++) {
        for (uint32_t side = 0; side < BOARD_TORUS_SIDES; side++) {
            torus_vertex(memory, ring, side);
            torus_facet(memory, ring, side);
        }
    }
    for (uint32_t i = 0; i < 1u << (2 * BOARD_TEXTURE_LOG2); i++) {
        uint32_t x = i & ((1u << BOARD_TEXTURE_LOG2) - 1);
        uint32_t y = i >> BOARD_TEXTURE_LOG2;
        uint32_t even = 31u << 11 | (2 * x) << 5 | y; /* red, towards yellow and white */
        uint32_t odd = x << 11 | (2 * y) << 5 | 31u;  /* blue */
        memory->texels[i] = (uint16_t)((((x >> 4) ^ (y >> 4)) & 1) != 0 ? odd : even);
    }
}

static void view_from(qtri_view *view, const qtri_surface *surface, qtri_vec3 eye, qtri_vec3 center,
                      q16 fovy)
{
    qtri_vec3 up = {0, Q16_ONE, 0};
    qtri_view_init(view, surface->width, surface->height);
    qtri_transform_look_at(&view->camera, eye, center, up);
    qtri_transform_perspective(&view->projection, fovy,
                               q16_from_ratio(surface->width, surface->height), Q16(0.1), Q16(10));
}

/* The colour triangle of the graphics course: 8214 pixels of 256 x 256. */
static void draw_triangle(const qtri_surface *surface, board_scene_memory *memory)
{
    static const qtri_corner corners[3] = {
        {{0, Q16_ONE, 0, Q16_ONE}, {255, 0, 0}, {0, 0}},
        {{-Q16_ONE, 0, Q16_ONE, Q16_ONE}, {0, 255, 0}, {0, 0}},
        {{Q16_ONE, 0, Q16_ONE, Q16_ONE}, {0, 0, 255}, {0, 0}},
    };
    (void)memory;
    qtri_view view;
    view_from(&view, surface, (qtri_vec3){0, 0, Q16(3)}, (qtri_vec3){0, 0, 0}, Q16(60));
    qtri_transform pose;
    qtri_transform_identity(&pose);
    qtri_material material = qtri_material_default();
    qtri_draw_triangles(surface, &view, &pose, corners, 3, &material);
}

static void draw_torus_mesh(const qtri_surface *surface, board_scene_memory *memory,
                            qtri_view *view, const qtri_material *material)
{
    qtri_mesh torus = board_torus(memory);
    view->vertices = memory->vertices;
    view->vertex_count = BOARD_TORUS_VERTICES;
    qtri_transform pose;
    qtri_transform_identity(&pose);
    qtri_transform_rotate_x(&pose, Q16(50));
    qtri_transform_rotate_z(&pose, Q16(-15));
    qtri_draw_mesh(surface, view, &pose, &torus, material);
}

/* Gouraud, lit per vertex. */
static void draw_torus(const qtri_surface *surface, board_scene_memory *memory)
{
    static const qtri_light light = {
        .towards = {Q16(0.4), Q16(0.6), Q16(0.69282032)}, .ambient = Q16(0.2), .diffuse = Q16(0.8)};
    qtri_view view;
    view_from(&view, surface, (qtri_vec3){0, 0, Q16(3)}, (qtri_vec3){0, 0, 0}, Q16(55));
    view.light = &light;
    qtri_material material = qtri_material_default();
    material.color = (qtri_rgb){255, 180, 90};
    draw_torus_mesh(surface, memory, &view, &material);
}

/* From so near that the near plane cuts triangles open and many reach past the frame. */
static void draw_wireframe(const qtri_surface *surface, board_scene_memory *memory)
{
    qtri_view view;
    view_from(&view, surface, (qtri_vec3){Q16(0.2), Q16(-0.2), Q16(0.9)}, (qtri_vec3){0, 0, 0},
              Q16(80));
    qtri_material material = qtri_material_default();
    material.color = (qtri_rgb){120, 255, 140};
    material.fill = &qtri_wireframe;
    draw_torus_mesh(surface, memory, &view, &material);
}

/* Perspective texture; the floor begins behind the camera, so the near plane cuts it. */
static void draw_floor(const qtri_surface *surface, board_scene_memory *memory)
{
    static const qtri_corner corner[4] = {
        {{Q16(-6), 0, Q16(2), Q16_ONE}, {255, 255, 255}, {0, 0}},
        {{Q16(6), 0, Q16(2), Q16_ONE}, {255, 255, 255}, {Q16(6), 0}},
        {{Q16(6), 0, Q16(-8), Q16_ONE}, {90, 110, 150}, {Q16(6), Q16(5)}},
        {{Q16(-6), 0, Q16(-8), Q16_ONE}, {90, 110, 150}, {0, Q16(5)}},
    };
    const qtri_corner corners[6] = {corner[0], corner[1], corner[2],
                                    corner[0], corner[2], corner[3]};
    qtri_texture texture = {
        .texels = memory->texels,
        .format = &qtri_texel_rgb565,
        .width_log2 = BOARD_TEXTURE_LOG2,
        .height_log2 = BOARD_TEXTURE_LOG2,
    };
    qtri_view view;
    view_from(&view, surface, (qtri_vec3){0, Q16_ONE, 0}, (qtri_vec3){Q16(0.5), Q16(0.2), Q16(-2)},
              Q16(60));
    qtri_transform pose;
    qtri_transform_identity(&pose);
    qtri_material material = qtri_material_default();
    material.texture = &texture;
    qtri_draw_triangles(surface, &view, &pose, corners, 6, &material);
}

/* Each triangle is in front on one side of the line where they cross. Colours screen-linear. */
static void draw_crossing(const qtri_surface *surface, board_scene_memory *memory)
{
    static const qtri_corner corners[6] = {
        {{Q16(-1), Q16(-0.8), Q16(0.5), Q16_ONE}, {255, 200, 40}, {0, 0}},
        {{Q16(1), Q16(-0.6), Q16(-0.5), Q16_ONE}, {255, 60, 20}, {0, 0}},
        {{Q16(0), Q16(0.9), Q16(0), Q16_ONE}, {255, 240, 200}, {0, 0}},
        {{Q16(-1), Q16(0.7), Q16(-0.5), Q16_ONE}, {20, 60, 255}, {0, 0}},
        {{Q16(1), Q16(0.8), Q16(0.5), Q16_ONE}, {40, 220, 255}, {0, 0}},
        {{Q16(0.1), Q16(-0.9), Q16(0), Q16_ONE}, {200, 240, 255}, {0, 0}},
    };
    (void)memory;
    qtri_view view;
    view_from(&view, surface, (qtri_vec3){0, 0, Q16(2)}, (qtri_vec3){0, 0, 0}, Q16(60));
    qtri_transform pose;
    qtri_transform_identity(&pose);
    qtri_material material = qtri_material_default();
    material.cull = QTRI_CULL_NONE;
    material.interpolation = QTRI_SCREEN_LINEAR;
    qtri_draw_triangles(surface, &view, &pose, corners, 6, &material);
}

#define P Q16(0.6)
#define N Q16(-0.6)

/* Flat, lit per face, under a non-uniform scale; too few vertex slots, which must not matter. */
static void draw_box(const qtri_surface *surface, board_scene_memory *memory)
{
    static const qtri_vec3 positions[8] = {{N, N, N}, {P, N, N}, {N, P, N}, {P, P, N},
                                           {N, N, P}, {P, N, P}, {N, P, P}, {P, P, P}};
    static const qtri_rgb colors[8] = {{255, 80, 80},  {80, 255, 80},  {80, 80, 255},
                                       {255, 255, 80}, {80, 255, 255}, {255, 80, 255},
                                       {255, 160, 80}, {255, 255, 255}};
    static const uint16_t triangles[12][3] = {
        {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5},  /* -x, +x */
        {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},  /* -y, +y */
        {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}}; /* -z, +z */
    static const qtri_mesh box = {.positions = positions,
                                  .colors = colors,
                                  .triangles = triangles,
                                  .vertex_count = 8,
                                  .triangle_count = 12};
    static const qtri_light light = {
        .towards = {Q16(-1), Q16(2), Q16(2)}, .ambient = Q16(0.3), .diffuse = Q16(0.7)};
    qtri_view view;
    view_from(&view, surface, (qtri_vec3){0, 0, Q16(3)}, (qtri_vec3){0, 0, 0}, Q16(45));
    view.light = &light;
    view.vertices = memory->vertices;
    view.vertex_count = 3;
    qtri_transform pose;
    qtri_transform_identity(&pose);
    qtri_transform_rotate_quat(
        &pose, qtri_quat_from_axis_deg((qtri_vec3){Q16(1), Q16(1), Q16(0.2)}, Q16(40)));
    qtri_transform_scale(&pose, (qtri_vec3){Q16(1.6), Q16(0.8), Q16(1)});
    qtri_material material = qtri_material_default();
    material.shading = QTRI_FLAT_LAST;
    qtri_draw_mesh(surface, &view, &pose, &box, &material);
}

const board_scene board_scenes[BOARD_SCENE_COUNT] = {
    {"triangle", 256, 256, {0, 0, 0}, draw_triangle},
    {"torus", 160, 128, {24, 32, 48}, draw_torus},
    {"wireframe", 160, 128, {0, 0, 0}, draw_wireframe},
    {"floor", 160, 128, {90, 110, 150}, draw_floor},
    {"crossing", 160, 128, {24, 32, 48}, draw_crossing},
    {"box", 160, 128, {24, 32, 48}, draw_box},
};
