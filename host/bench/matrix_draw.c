/* SPDX-License-Identifier: MIT */
#include "matrix.h"
#include "matrix_pipelines.h"

#define BYTES_OF(frame, offset) ((const void *)((const uint8_t *)(frame) + (offset)))

/* Squares of 4 x 4 texels: a palette entry each. One of 16 has the key's colour. */
#define SQUARES 16

static bool is_key(uint32_t column, uint32_t row)
{
    return column % 4 == 1 && row % 4 == 1;
}

void matrix_set_textures(matrix_frame *frame)
{
    const qtri_rgb key = MATRIX_KEY_COLOR;
    for (uint32_t i = 0; i < MATRIX_TEXELS; i++) {
        uint32_t u = i % BENCH_TEXTURE_SIDE, v = i / BENCH_TEXTURE_SIDE;
        uint32_t column = u / 4, row = v / 4;
        qtri_rgb color = is_key(column, row) ? key : bench_texel(u, v);
        frame->rgb565[i] = bench_rgb565(color);
        frame->xrgb8888[i] = (uint32_t)color.r << 16 | (uint32_t)color.g << 8 | color.b;
        frame->gray8[i] = (uint8_t)((299 * color.r + 587 * color.g + 114 * color.b + 500) / 1000);
        frame->palette8[i] =
            (uint8_t)(is_key(column, row) ? MATRIX_KEY_PALETTE8 : row * SQUARES + column);
    }
    for (uint32_t i = 0; i < 256; i++) {
        uint32_t column = i % SQUARES, row = i / SQUARES;
        frame->palette[i] = is_key(column, row) ? key : bench_texel(4 * column + 2, 4 * row + 2);
    }
}

static void set_texture(matrix_frame *frame, const matrix_case *now)
{
    const qtri_texture texture = {
        .texels = BYTES_OF(frame, now->texel->texels),
        .format = now->texel->format,
        .width_log2 = BENCH_TEXTURE_LOG2,
        .height_log2 = BENCH_TEXTURE_LOG2,
        .fields = 8,
        .color = {{255, 160, 32}, {32, 64, 255}},
        .wrap_u = now->wrap->wrap,
        .wrap_v = now->wrap->wrap,
        .filter = now->filter->filter,
        .palette = frame->palette,
        .has_key = now->wrap->has_key,
        .key = now->texel->key,
    };
    frame->texture = texture;
    frame->material.texture = &frame->texture;
    frame->material.texture_mode = now->source->mode;
}

static qtri_rgb scaled(qtri_rgb color, uint32_t intensity)
{
    const qtri_rgb result = {(uint8_t)(color.r * intensity / 255),
                             (uint8_t)(color.g * intensity / 255),
                             (uint8_t)(color.b * intensity / 255)};
    return result;
}

static const qtri_rgb white = {255, 255, 255};

static void set_quad(matrix_frame *frame, const matrix_geometry *geometry, matrix_colors kind)
{
    static const qtri_rgb different[4] = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 0}};
    static const uint8_t intensity[4] = {255, 200, 120, 60};
    bench_quad quad = *geometry->quad;
    qtri_rgb colors[4];
    quad.repeats = geometry->repeats;
    for (uint32_t i = 0; i < 4; i++) {
        colors[i] = kind == MATRIX_RGB    ? different[i]
                    : kind == MATRIX_GREY ? scaled(white, intensity[i])
                    : kind == MATRIX_TINT ? scaled(bench_lit_color, intensity[i])
                                          : bench_lit_color;
    }
    bench_set_quad(frame->corners, &quad, colors);
}

/* Light that REPLACE hides is not asked for. */
static void set_mesh(matrix_frame *frame, const matrix_geometry *geometry,
                     const matrix_source *source)
{
    bool hidden = source->textured && source->mode == QTRI_REPLACE;
    frame->view.light = hidden ? NULL : &bench_light;
    frame->view.vertices = frame->vertices;
    frame->view.vertex_count = geometry->mesh->vertex_count;
    frame->mesh = *geometry->mesh;
    frame->mesh.colors = source->colors == MATRIX_RGB ? geometry->colors : NULL;
    frame->material.color = source->colors == MATRIX_GREY ? white : bench_lit_color;
    frame->material.cull = QTRI_CULL_BACK;
}

/* All that are made for the matrix; what else is drawn the generic one draws. */
static const qtri_pipeline *const *list_pipelines(void)
{
    static const qtri_pipeline *list[128];
    static const qtri_pipeline *const *const groups[] = {
        matrix_pipelines_flat,    matrix_pipelines_lit,         matrix_pipelines_colors,
        matrix_pipelines_texture, matrix_pipelines_texture_lit, matrix_pipelines_texture_colors};
    uint32_t count = 0;
    for (uint32_t i = 0; i < sizeof groups / sizeof *groups; i++) {
        for (uint32_t k = 0; groups[i][k] != NULL; k++) {
            list[count++] = groups[i][k];
        }
    }
    list[count] = &qtri_pipeline_any;
    return list;
}

/* The picture's size is that of which the window is a part. */
static void set_view(matrix_frame *frame, const matrix_geometry *geometry)
{
    const qtri_rect *window = &geometry->window;
    int32_t width = geometry->mesh != NULL ? 320 : 160, height = width * 3 / 4;
    bench_set_view(&frame->view, width, height);
    frame->view.pipelines = list_pipelines();
    frame->view.viewport = qtri_viewport_top(-window->x0, -window->y0, width, height);
    qtri_transform_identity(&frame->pose);
    qtri_transform_rotate_y(&frame->pose, geometry->turn);
}

static bool set_surface(matrix_frame *frame, const matrix_case *now)
{
    const qtri_rect *window = &now->geometry->window;
    int32_t width = window->x1 - window->x0, rows = window->y1 - window->y0;
    if (qtri_surface_init(&frame->surface, now->surface->format, width, rows, 0, rows,
                          frame->memory, sizeof frame->memory) != QTRI_OK) {
        return false;
    }
    qtri_surface_clear(&frame->surface, bench_background);
    qtri_surface_clear_depth(&frame->surface, now->depth->cleared);
    return true;
}

static void draw(matrix_frame *frame, const matrix_geometry *geometry)
{
    if (geometry->mesh != NULL) {
        qtri_draw_mesh(&frame->surface, &frame->view, &frame->pose, &frame->mesh, &frame->material);
    } else {
        qtri_draw_triangles(&frame->surface, &frame->view, &frame->pose, frame->corners, 6,
                            &frame->material);
    }
}

bool matrix_prepare(matrix_frame *frame, const matrix_case *now)
{
    const matrix_geometry *geometry = now->geometry;
    if (geometry->mesh != NULL && geometry->mesh->triangle_count == 0) {
        return false;
    }
    set_view(frame, geometry);
    frame->material = qtri_material_default();
    frame->material.cull = QTRI_CULL_NONE;
    if (geometry->mesh != NULL) {
        set_mesh(frame, geometry, now->source);
    } else {
        set_quad(frame, geometry, now->source->colors);
    }
    if (!set_surface(frame, now)) {
        return false;
    }
    frame->material.shading = now->source->shading;
    if (now->depth->is_there) {
        draw(frame, geometry);
        qtri_surface depthless = frame->surface;
        depthless.depth = NULL;
        qtri_surface_clear(&depthless, bench_background);
    }
    frame->material.depth_compare = now->depth->compare;
    frame->material.depth_read_only = now->depth->read_only;
    if (now->source->textured) {
        set_texture(frame, now);
    }
    return true;
}

void matrix_draw(matrix_frame *frame, const matrix_case *now)
{
    draw(frame, now->geometry);
}

uint32_t matrix_pixels(matrix_frame *frame, const matrix_geometry *geometry)
{
    matrix_case plain;
    uint32_t count = 0;
    matrix_first(&plain);
    plain.geometry = geometry;
    if (!matrix_prepare(frame, &plain)) {
        return 0;
    }
    matrix_draw(frame, &plain);
    for (int32_t y = 0; y < frame->surface.rows; y++) {
        for (int32_t x = 0; x < frame->surface.width; x++) {
            count += frame->surface.depth[y * frame->surface.depth_pitch + x] != UINT16_MAX;
        }
    }
    return count;
}
