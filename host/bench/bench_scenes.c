/* SPDX-License-Identifier: MIT */
#include "bench_scenes.h"

/*
 * Meshes are compact: 16-bit positions, 8-bit normals, 16-bit texture coordinates but for the
 * wall's, which reach 4. S4w and S5w: with the wide mesh, Q16.16 positions. S4k, S5k and S7k: as
 * S4, S5 and S7 with the project's own mesh of like size, 5760 triangles. S4b, S4wb, S5b, S6b and
 * S7b: S4, S4w, S5, S6 and S7 in 15 bands of 16 rows, all of a frame's work but the clear. ST: the
 * mesh of S4 as loose triangles.
 */
#ifdef BENCH_PLAIN
#define COMPACT(mesh) &bench_mesh_##mesh
#else
#define COMPACT(mesh) &bench_mesh_##mesh##_compact
#endif
#define QUAD(quad_, colors_) .work = BENCH_QUAD, .quad = (quad_), .colors = (colors_)
#define MESH(mesh_, turn_)   .work = BENCH_MESH, .mesh = (mesh_), .turn = (turn_)
#define FLAT                 .shading = QTRI_FLAT_LAST
#define BANDS                .band_rows = 16
#define FORMAT               &qtri_rgb565

static const qtri_rgb white[4] = {
    {255, 255, 255}, {255, 255, 255}, {255, 255, 255}, {255, 255, 255}};
static const qtri_rgb orange[4] = {{255, 128, 64}, {255, 128, 64}, {255, 128, 64}, {255, 128, 64}};
static const qtri_rgb rainbow[4] = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 0}};

const bench_scene bench_scenes[] = {
    {.name = "S0", .work = BENCH_CLEAR},
    {.name = "S1", QUAD(&bench_screen, orange), FLAT},
    {.name = "S2", QUAD(&bench_screen, rainbow)},
    {.name = "S3", QUAD(&bench_floor, white), .textured = true},
    {.name = "S3a",
     QUAD(&bench_floor, white),
     .textured = true,
     .interpolation = QTRI_SCREEN_LINEAR},
    {.name = "S4", MESH(COMPACT(spot), Q16(150))},
    {.name = "S5", MESH(COMPACT(teapot), Q16(30)), FLAT},
    {.name = "S6", MESH(COMPACT(spot_uv), Q16(150)), .textured = true},
    {.name = "S7", MESH(COMPACT(spot), Q16(150)), .wireframe = true},
    {.name = "S8", MESH(COMPACT(wall), 0), .textured = true},
    {.name = "S9", MESH(COMPACT(spot), Q16(150)), .colors = bench_colors_spot},
    {.name = "S10", MESH(COMPACT(spot), Q16(150)), .wireframe = true, .without_depth = true},
    {.name = "S11", QUAD(&bench_turned, white), .textured = true},
    {.name = "ST",
     .work = BENCH_CORNERS,
     .mesh = &bench_mesh_spot,
     .turn = Q16(150),
     .colors = bench_colors_spot},
    {.name = "S4k", MESH(COMPACT(knot), Q16(30))},
    {.name = "S5k", MESH(COMPACT(knot), Q16(30)), FLAT},
    {.name = "S7k", MESH(COMPACT(knot), Q16(30)), .wireframe = true},
#ifndef BENCH_PLAIN
    {.name = "S4w", MESH(&bench_mesh_spot, Q16(150))},
    {.name = "S5w", MESH(&bench_mesh_teapot, Q16(30)), FLAT},
    {.name = "S4b", MESH(COMPACT(spot), Q16(150)), BANDS},
    {.name = "S4wb", MESH(&bench_mesh_spot, Q16(150)), BANDS},
    {.name = "S5b", MESH(COMPACT(teapot), Q16(30)), FLAT, BANDS},
    {.name = "S6b", MESH(COMPACT(spot_uv), Q16(150)), .textured = true, BANDS},
    {.name = "S7b", MESH(COMPACT(spot), Q16(150)), .wireframe = true, BANDS},
    {.name = "S4kb", MESH(COMPACT(knot), Q16(30)), BANDS},
#endif
    {.name = NULL},
};

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
    frame->material.texture = &frame->texture;
    frame->material.texture_mode = mode;
}

static void set_mesh(bench_frame *frame)
{
    frame->view.light = &bench_light;
    frame->view.vertices = frame->vertices;
    frame->view.vertex_count = frame->scene->mesh->vertex_count;
    frame->mesh = *frame->scene->mesh;
    frame->mesh.colors = frame->scene->colors;
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

#ifndef BENCH_PLAIN
/* Bands lie in the memory of the whole frame, one below the other, so that there is a picture. */
static void draw_bands(bench_frame *frame)
{
    const qtri_surface *whole = &frame->surface;
    qtri_surface band;
    qtri_frame_begin(&frame->bands);
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
    qtri_prepared_init(&frame->prepared, frame->vertices, BENCH_VERTICES_MAX, frame->lists,
                       sizeof frame->lists / sizeof frame->lists[0]);
    return qtri_frame_init(&frame->bands, FORMAT, BENCH_WIDTH, BENCH_HEIGHT,
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
    if (scene->mesh != NULL && scene->mesh->triangle_count == 0) {
        return false;
    }
    frame->scene = scene;
    bench_set_view(&frame->view, BENCH_WIDTH, BENCH_HEIGHT);
    qtri_transform_identity(&frame->pose);
    qtri_transform_rotate_y(&frame->pose, scene->turn);
    frame->material = qtri_material_default();
    frame->material.color = bench_lit_color;
    frame->material.cull = scene->mesh != NULL ? QTRI_CULL_BACK : QTRI_CULL_NONE;
    frame->material.shading = scene->shading;
    frame->material.interpolation = scene->interpolation;
    frame->material.fill = scene->wireframe ? &qtri_wireframe : NULL;
    if (scene->without_depth) {
        frame->material.depth_compare = QTRI_DEPTH_OFF;
    }
    if (scene->textured) {
        set_texture(frame, scene->work == BENCH_MESH ? QTRI_MODULATE : QTRI_REPLACE);
    }
    if (scene->work == BENCH_QUAD) {
        bench_set_quad(frame->corners, scene->quad, scene->colors);
    } else if (scene->work == BENCH_MESH) {
        set_mesh(frame);
    } else if (scene->work == BENCH_CORNERS) {
        set_corners(frame);
    }
    if (qtri_surface_init(&frame->surface, FORMAT, BENCH_WIDTH, BENCH_HEIGHT, 0, BENCH_HEIGHT,
                          frame->memory, sizeof frame->memory) != QTRI_OK) {
        return false;
    }
    if (scene->band_rows != 0 && !set_bands(frame)) {
        return false;
    }
    const qtri_rgb other = {255, 255, 255}; /* for S0, anything but what it is to become */
    qtri_surface_clear(&frame->surface, scene->work == BENCH_CLEAR ? other : bench_background,
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
        qtri_surface_clear(&frame->surface, bench_background, UINT16_MAX);
        break;
    case BENCH_MESH:
        qtri_draw_mesh(&frame->surface, &frame->view, &frame->pose, &frame->mesh, &frame->material);
        break;
    default:
        qtri_draw_triangles(&frame->surface, &frame->view, &frame->pose, frame->corners,
                            3 * bench_triangles(frame->scene), &frame->material);
        break;
    }
}

uint32_t bench_triangles(const bench_scene *scene)
{
    return scene->mesh != NULL ? scene->mesh->triangle_count : scene->quad != NULL ? 2 : 0;
}

/* Without depth, what was drawn is known by its colour, which nothing shares with the background.
 */
bool bench_is_drawn(const bench_frame *frame, int32_t x, int32_t y)
{
    const qtri_surface *surface = &frame->surface;
    const void *row = surface->pixels + y * surface->pitch;
    const uint16_t *color = row;
    return color[x] != bench_rgb565(bench_background) ||
           surface->depth[y * surface->depth_pitch + x] != UINT16_MAX;
}
