#include "bench_scenes.h"

/*
 * Meshes are compact: 16-bit positions, 8-bit normals. S4w and S5w: with the wide mesh, Q16.16
 * positions. S4k, S5k and S7k: as S4, S5 and S7 with the project's own mesh of like size, 5760
 * triangles. S4b, S4wb, S5b and S7b: S4, S4w, S5 and S7 in 15 bands of 16 rows, all of a frame's
 * work but the clear.
 */
#ifdef BENCH_PLAIN
#define COMPACT(mesh) &bench_mesh_##mesh
#else
#define COMPACT(mesh) &bench_mesh_##mesh##_compact
#endif
#define FLAT(name_, mesh_, turn_)                                                                  \
    {                                                                                              \
        .name = (name_), .work = BENCH_MESH, .shading = QTRI_FLAT_LAST, .mesh = (mesh_),           \
        .turn = (turn_)                                                                            \
    }
#define SMOOTH(name_, mesh_, turn_)                                                                \
    {                                                                                              \
        .name = (name_), .work = BENCH_MESH, .mesh = (mesh_), .turn = (turn_)                      \
    }
#define LINES(name_, mesh_, turn_)                                                                 \
    {                                                                                              \
        .name = (name_), .work = BENCH_MESH, .fill = &qtri_wireframe, .mesh = (mesh_),             \
        .turn = (turn_)                                                                            \
    }
#define BANDS(name_, mesh_, turn_, shading_, fill_)                                                \
    {                                                                                              \
        .name = (name_), .work = BENCH_MESH, .shading = (shading_), .fill = (fill_),               \
        .mesh = (mesh_), .turn = (turn_), .band_rows = 16                                          \
    }

const bench_scene bench_scenes[] = {
    {.name = "S0", .work = BENCH_CLEAR},
    {.name = "S1", .work = BENCH_SCREEN, .shading = QTRI_FLAT_LAST},
    {.name = "S2", .work = BENCH_SCREEN, .shading = QTRI_SMOOTH},
    {.name = "S3", .work = BENCH_FLOOR, .interpolation = QTRI_PERSPECTIVE},
    {.name = "S3a", .work = BENCH_FLOOR, .interpolation = QTRI_SCREEN_LINEAR},
    SMOOTH("S4", COMPACT(spot), Q16(150)),
    FLAT("S5", COMPACT(teapot), Q16(30)),
    LINES("S7", COMPACT(spot), Q16(150)),
    SMOOTH("S4k", COMPACT(knot), Q16(30)),
    FLAT("S5k", COMPACT(knot), Q16(30)),
    LINES("S7k", COMPACT(knot), Q16(30)),
#ifndef BENCH_PLAIN
    SMOOTH("S4w", &bench_mesh_spot, Q16(150)),
    FLAT("S5w", &bench_mesh_teapot, Q16(30)),
    BANDS("S4b", COMPACT(spot), Q16(150), QTRI_SMOOTH, NULL),
    BANDS("S4wb", &bench_mesh_spot, Q16(150), QTRI_SMOOTH, NULL),
    BANDS("S5b", COMPACT(teapot), Q16(30), QTRI_FLAT_LAST, NULL),
    BANDS("S7b", COMPACT(spot), Q16(150), QTRI_SMOOTH, &qtri_wireframe),
    BANDS("S4kb", COMPACT(knot), Q16(30), QTRI_SMOOTH, NULL),
#endif
    {.name = NULL},
};

static const qtri_rgb background = {24, 32, 48};

static qtri_corner corner(q16 x, q16 y, q16 z, qtri_rgb color, q16 u, q16 v)
{
    qtri_corner result = {{x, y, z, Q16_ONE}, color, {u, v}};
    return result;
}

/* Triangles (0,1,2) and (0,2,3). */
static void set_quad(bench_frame *frame, const qtri_corner quad[4])
{
    static const uint8_t order[6] = {0, 1, 2, 0, 2, 3};
    for (uint32_t i = 0; i < 6; i++) {
        frame->corners[i] = quad[order[i]];
    }
}

static void set_screen(bench_frame *frame)
{
    const q16 x = Q16(2.3070917), y = Q16(1.7303188);
    const qtri_rgb red = {255, 0, 0}, green = {0, 255, 0}, blue = {0, 0, 255};
    const qtri_rgb yellow = {255, 255, 0}, orange = {255, 128, 64};
    bool flat = frame->scene->shading != QTRI_SMOOTH;
    const qtri_corner quad[4] = {
        corner(-x, -y, 0, flat ? orange : red, 0, Q16_ONE),
        corner(x, -y, 0, flat ? orange : green, Q16_ONE, Q16_ONE),
        corner(x, y, 0, flat ? orange : blue, Q16_ONE, 0),
        corner(-x, y, 0, flat ? orange : yellow, 0, 0),
    };
    set_quad(frame, quad);
}

/* The colour to the nearest that RGB565 has. */
static uint16_t rgb565(uint32_t r, uint32_t g, uint32_t b)
{
    return (uint16_t)((r * 31 + 127) / 255 << 11 | (g * 63 + 127) / 255 << 5 |
                      (b * 31 + 127) / 255);
}

static void set_floor(bench_frame *frame)
{
    const q16 x = Q16(3), y = Q16(1.2), z = Q16(2.0784610);
    const qtri_rgb white = {255, 255, 255};
    const qtri_corner quad[4] = {
        corner(-x, -y, z, white, 0, Q16_ONE),
        corner(x, -y, z, white, Q16_ONE, Q16_ONE),
        corner(x, y, -z, white, Q16_ONE, 0),
        corner(-x, y, -z, white, 0, 0),
    };
    set_quad(frame, quad);
    for (uint32_t i = 0; i < 64 * 64; i++) {
        uint32_t u = i % 64, v = i / 64;
        frame->texels[i] = ((u >> 3 ^ v >> 3) & 1) != 0 ? rgb565(255, 4 * u, 4 * v)
                                                        : rgb565(4 * v, 64, 255 - 4 * u);
    }
    const qtri_texture texture = {
        .texels = frame->texels, .format = &qtri_texel_rgb565, .width_log2 = 6, .height_log2 = 6};
    frame->texture = texture;
    frame->material.texture = &frame->texture;
    frame->material.texture_mode = QTRI_REPLACE;
}

static void set_mesh(bench_frame *frame)
{
    const qtri_light light = {{Q16(.4), Q16(.6), Q16(.69282032)}, Q16(.2), Q16(.8)};
    const qtri_rgb color = {255, 180, 90};
    frame->light = light;
    frame->view.light = &frame->light;
    frame->view.vertices = frame->vertices;
    frame->view.vertex_count = frame->scene->mesh->vertex_count;
    frame->material.color = color;
    frame->material.cull = QTRI_CULL_BACK;
    qtri_transform_rotate_y(&frame->pose, frame->scene->turn);
}

#ifndef BENCH_PLAIN
/* Bands lie in the memory of the whole frame, one below the other, so that there is a picture. */
static void draw_bands(bench_frame *frame)
{
    const qtri_surface *whole = &frame->surface;
    qtri_surface band;
    qtri_frame_begin(&frame->bands);
    qtri_prepare_mesh(&frame->prepared, &frame->bands, &frame->view, &frame->pose,
                      frame->scene->mesh, &frame->material);
    while (qtri_frame_next_band(&frame->bands, &band)) {
        band.pixels = whole->pixels + band.first_row * whole->pitch;
        band.depth = whole->depth + band.first_row * whole->depth_pitch;
        qtri_draw_prepared(&band, &frame->prepared);
    }
}

static bool set_bands(bench_frame *frame)
{
    qtri_prepared_init(&frame->prepared, frame->vertices, BENCH_VERTICES_MAX, frame->lists,
                       sizeof frame->lists / sizeof frame->lists[0]);
    return qtri_frame_init(&frame->bands, &qtri_rgb565, BENCH_WIDTH, BENCH_HEIGHT,
                           frame->scene->band_rows, frame->memory, sizeof frame->memory) == QTRI_OK;
}
#else
static void draw_bands(bench_frame *frame)
{
    (void)frame;
}

static bool set_bands(bench_frame *frame)
{
    return frame == NULL;
}
#endif

bool bench_prepare(bench_frame *frame, const bench_scene *scene)
{
    const qtri_vec3 eye = {0, 0, Q16(3)}, center = {0, 0, 0}, up = {0, Q16_ONE, 0};
    if (bench_triangles(scene) == 0 && scene->work == BENCH_MESH) {
        return false;
    }
    frame->scene = scene;
    qtri_view_init(&frame->view, BENCH_WIDTH, BENCH_HEIGHT);
    qtri_transform_look_at(&frame->view.camera, eye, center, up);
    qtri_transform_perspective(&frame->view.projection, Q16(60), Q16(4.0 / 3.0), Q16(.1), Q16(100));
    qtri_transform_identity(&frame->pose);
    frame->material = qtri_material_default();
    frame->material.cull = QTRI_CULL_NONE;
    frame->material.shading = scene->shading;
    frame->material.interpolation = scene->interpolation;
    frame->material.fill = scene->fill;
    if (scene->work == BENCH_SCREEN) {
        set_screen(frame);
    } else if (scene->work == BENCH_FLOOR) {
        set_floor(frame);
    } else if (scene->work == BENCH_MESH) {
        set_mesh(frame);
    }
    if (qtri_surface_init(&frame->surface, &qtri_rgb565, BENCH_WIDTH, BENCH_HEIGHT, 0, BENCH_HEIGHT,
                          frame->memory, sizeof frame->memory) != QTRI_OK) {
        return false;
    }
    if (scene->band_rows != 0 && !set_bands(frame)) {
        return false;
    }
    const qtri_rgb other = {255, 255, 255}; /* for S0, anything but what it is to become */
    qtri_surface_clear(&frame->surface, scene->work == BENCH_CLEAR ? other : background,
                       scene->work == BENCH_CLEAR ? 0 : UINT16_MAX);
    return true;
}

void bench_draw(bench_frame *frame)
{
    if (frame->scene->band_rows != 0) {
        draw_bands(frame);
        return;
    }
    switch (frame->scene->work) {
    case BENCH_CLEAR:
        qtri_surface_clear(&frame->surface, background, UINT16_MAX);
        break;
    case BENCH_MESH:
        qtri_draw_mesh(&frame->surface, &frame->view, &frame->pose, frame->scene->mesh,
                       &frame->material);
        break;
    default:
        qtri_draw_triangles(&frame->surface, &frame->view, &frame->pose, frame->corners, 6,
                            &frame->material);
        break;
    }
}

uint32_t bench_triangles(const bench_scene *scene)
{
    return scene->work == BENCH_CLEAR  ? 0
           : scene->work == BENCH_MESH ? scene->mesh->triangle_count
                                       : 2;
}
