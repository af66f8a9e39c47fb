/* SPDX-License-Identifier: MIT */
/*
 * Arbitrary bytes for what draws on a surface and what surfaces become: shapes, pictures, text,
 * strokes, meshes in bands, outlines, samples, filters. Nothing may trap, overflow or write outside
 * of memory; and what is drawn by two scissors, in bands or in bands that overlap, is what is drawn
 * at once.
 */
#include "support/fuzz_input.h"
#include "support/layouts.h"

enum { SIDE = 40, CORNERS = 9, POINTS = 7, IMAGE = 8, WORDS = 8 * SIDE * SIDE };

static const qtri_format *const formats[11] = {
    &qtri_rgb565,    &qtri_xrgb8888,    &qtri_gray8,     &qtri_rgb565_swapped,
    &qtri_rgb888,    &qtri_bgr888,      &qtri_rgb565_x4, &qtri_rgb565_swapped_x4,
    &qtri_rgb888_x4, &qtri_xrgb8888_x4, &qtri_gray8_x4};
enum { PLAIN_FORMATS = 6 };

static const qtri_depth_format *const depths[4] = {NULL, &qtri_depth_float16, &qtri_depth_linear24,
                                                   &qtri_depth_linear32};

static uint32_t words[WORDS];

/* What a call of any kind may take. */
typedef struct job {
    uint8_t kind;
    qtri_view view;
    qtri_transform pose;
    qtri_material material;
    qtri_light light;
    qtri_texture texture;
    const void *levels[4];
    lamps lamps;
    uint8_t alphas[64];
    soup soup;
    qtri_vertex vertices[VERTICES];
    qtri_corner corners[CORNERS];
    qtri_screen_vertex screen[POINTS];
    qtri_point points[POINTS];
    qtri_area box;
    int32_t number[6];
    qtri_brush brush;
    qtri_stroke stroke;
    qtri_image image;
    qtri_affine affine;
    uint32_t pixels[IMAGE * IMAGE];
    char text[24];
} job;

static void abort_if(bool wrong)
{
    if (wrong) {
        abort();
    }
}

/* ---- Arguments ---- */

/* Small numbers mostly, so that something is seen. */
static int32_t take_place(struct reader *r)
{
    const uint8_t kind = take_byte(r);
    const int32_t value = take_int(r);
    return kind % 8 == 0 ? value : kind % 8 == 1 ? value >> 8 : value >> 18;
}

static void build_stage(struct reader *r, job *j)
{
    static const uint32_t texels[64] = {0xFF00FFu, 0x123456u, 0xFFFFFFu};
    static const qtri_blend *const by_vertex[2] = {&qtri_blend_vertex_alpha,
                                                   &qtri_blend_vertex_add};
    qtri_view_init(&j->view, SIDE, SIDE);
    build_transform(r, &j->view.projection);
    build_transform(r, &j->view.camera);
    build_transform(r, &j->pose);
    take(r, &j->light, offsetof(qtri_light, model)); /* one white light */
    j->view.light = take_byte(r) % 2 ? &j->light : NULL;
    if (take_byte(r) % 2) {
        j->view.light = build_lamps(r, &j->lamps);
    }
    j->view.vertices = j->vertices;
    j->view.vertex_count = take_byte(r) % (VERTICES + 1);
    j->material = build_material(r, &j->texture, j->levels, texels);
    j->material.reflection =
        j->view.light != NULL && j->view.light->model != NULL ? &j->lamps.reflection : NULL;
    const uint8_t more = take_byte(r);
    take(r, j->alphas, sizeof j->alphas);
    j->material.alphas = more & 1 ? j->alphas : NULL;
    j->material.shading = more % 8 == 2 ? &qtri_per_pixel : j->material.shading;
    j->material.fill = more % 16 == 6 ? &qtri_smooth_wireframe : j->material.fill;
    j->material.blend = more & 32 ? by_vertex[more >> 6 & 1] : j->material.blend;
    j->material.depth_shift = more & 128 ? &qtri_slope_bias : NULL;
    j->material.depth_slope = take_number(r);
    j->material.depth_bias = take_number(r);
    j->material.keep = take_byte(r) % 4 == 0 ? take_byte(r) : 0;
}

static void build_shapes(struct reader *r, job *j)
{
    static const qtri_ink *const inks[3] = {NULL, &qtri_ink_blend, &qtri_ink_smooth};
    static const qtri_stroke_edges *const edges[2] = {NULL, &qtri_stroke_smooth};
    for (int i = 0; i < POINTS; i++) {
        j->points[i].x_24p8 = take_place(r);
        j->points[i].y_24p8 = take_place(r);
        take(r, &j->screen[i], sizeof j->screen[i]);
        j->screen[i].x_24p8 = j->points[i].x_24p8;
        j->screen[i].y_24p8 = j->points[i].y_24p8;
    }
    j->box.x0_24p8 = take_place(r);
    j->box.y0_24p8 = take_place(r);
    j->box.x1_24p8 = take_place(r);
    j->box.y1_24p8 = take_place(r);
    for (int i = 0; i < 6; i++) {
        j->number[i] = take_place(r);
    }
    take(r, &j->brush.color, sizeof j->brush.color);
    j->brush.alpha = take_byte(r);
    j->brush.ink = inks[take_byte(r) % 3];
    j->stroke = qtri_stroke_default();
    j->stroke.width = take_number(r);
    j->stroke.cap = (qtri_cap)take_choice(r, 4);
    j->stroke.edges = edges[take_byte(r) % 2];
    j->stroke.alpha = take_byte(r);
    j->stroke.closed = take_byte(r) % 2;
    j->stroke.in_space = take_byte(r) % 2;
    for (int i = 0; i < CORNERS; i++) {
        const qtri_vec3 p = take_vec3(r);
        const qtri_vec4 position = {p.x, p.y, p.z, take_byte(r) % 4 ? Q16_ONE : take_number(r)};
        j->corners[i].position = position;
        take(r, &j->corners[i].color, sizeof j->corners[i].color);
        take(r, &j->corners[i].uv, sizeof j->corners[i].uv);
    }
}

static void build_pictures(struct reader *r, job *j)
{
    take(r, j->pixels, sizeof j->pixels);
    j->image.pixels = j->pixels;
    j->image.format = formats[take_byte(r) % PLAIN_FORMATS];
    j->image.width = 1 + take_byte(r) % IMAGE;
    j->image.height = 1 + take_byte(r) % IMAGE;
    j->image.pitch = 4 * IMAGE;
    j->image.has_key = take_byte(r) % 2;
    j->image.key = j->pixels[0];
    qtri_affine_place(&j->affine, take_number(r), take_number(r), take_number(r), take_number(r),
                      take_number(r), take_number(r), take_int(r));
    if (take_byte(r) % 4 == 0) {
        take(r, &j->affine, sizeof j->affine);
    }
    take(r, j->text, sizeof j->text - 1);
    j->text[sizeof j->text - 1] = 0;
}

/* ---- Calls that draw ---- */

static void paint(const job *j, const qtri_surface *s)
{
    const int32_t *n = j->number;
    const qtri_point *p = j->points;
    switch (j->kind / 8 % 9) {
    case 0:
        qtri_paint_rect(s, &j->box, &j->brush);
        break;
    case 1:
        qtri_paint_rect_outline(s, &j->box, n[0], &j->brush);
        break;
    case 2:
        qtri_paint_round_rect(s, &j->box, n[0], &j->brush);
        break;
    case 3:
        qtri_paint_round_rect_outline(s, &j->box, n[0], n[1], &j->brush);
        break;
    case 4:
        qtri_paint_circle(s, &p[0], n[0], &j->brush);
        break;
    case 5:
        qtri_paint_ring(s, &p[0], n[0], n[1], &j->brush);
        break;
    case 6:
        qtri_paint_arc(s, &p[0], n[0], n[1], j->stroke.width, n[3], &j->brush);
        break;
    case 7:
        qtri_paint_polygon(s, p, j->kind / 72 % (POINTS + 1), &j->brush);
        break;
    default:
        qtri_paint_stroke(s, &p[0], &p[1], n[0], &j->brush);
        break;
    }
}

static void paint_pictures(const job *j, const qtri_surface *s)
{
    const int32_t x = j->number[0] >> 6;
    const int32_t y = j->number[1] >> 6;
    switch (j->kind / 8 % 4) {
    case 0:
        qtri_image_paint(s, &j->image, x, y);
        break;
    case 1:
        qtri_image_blend(s, &j->image, x, y, j->brush.alpha);
        break;
    case 2:
        qtri_image_paint_affine(s, &j->image, &j->affine, j->brush.alpha);
        break;
    default:
        (void)qtri_text_paint(s, &qtri_font_small, x, y, j->text, &j->brush);
        (void)qtri_text_width(&qtri_font_small, j->text);
        break;
    }
}

static void draw_strokes(const job *j, const qtri_surface *s)
{
    const uint32_t count = j->kind / 64;
    switch (j->kind / 8 % 8) {
    case 0:
        qtri_raster_polyline(s, &j->material, &j->stroke, j->screen, POINTS);
        break;
    case 1:
        qtri_raster_point(s, &j->material, &j->stroke, j->screen);
        break;
    case 2:
        qtri_draw_polyline(s, &j->view, &j->pose, j->corners, CORNERS, &j->stroke, &j->material);
        break;
    case 3:
        qtri_draw_wide_lines(s, &j->view, &j->pose, j->corners, CORNERS, &j->stroke, &j->material);
        break;
    case 4:
        qtri_draw_points(s, &j->view, &j->pose, j->corners, CORNERS, &j->stroke, &j->material);
        break;
    case 5:
        qtri_draw_wide_wireframe(s, &j->view, &j->pose, &j->soup.mesh, &j->stroke, &j->material);
        break;
    case 6:
        qtri_draw_hidden_lines(s, &j->view, &j->pose, &j->soup.mesh, &j->stroke, &j->material,
                               j->number[0]);
        break;
    default:
        qtri_raster_polyline(s, &j->material, &j->stroke, j->screen, count);
        break;
    }
}

static void draw_solids(const job *j, const qtri_surface *s)
{
    if (j->kind / 8 % 4 == 0) {
        qtri_draw_triangles(s, &j->view, &j->pose, j->corners, CORNERS, &j->material);
        qtri_draw_lit_triangles(s, &j->view, &j->pose, j->corners, NULL, CORNERS, &j->material);
    } else if (j->kind / 8 % 4 == 1) {
        qtri_raster_triangle(s, qtri_pipelines_default, &j->material, j->screen);
        qtri_raster_line(s, &j->material, j->screen);
    } else {
        qtri_draw_mesh(s, &j->view, &j->pose, &j->soup.mesh, &j->material);
    }
}

static void draw(const job *j, const qtri_surface *s)
{
    switch (j->kind % 8) {
    case 0:
    case 1:
        paint(j, s);
        break;
    case 2:
        paint_pictures(j, s);
        break;
    case 3:
    case 4:
        draw_strokes(j, s);
        break;
    default:
        draw_solids(j, s);
        break;
    }
}

/* ---- Surfaces ---- */

typedef struct board {
    qtri_surface surface;
    uint8_t *memory; /* exactly as large: AddressSanitizer watches its ends */
    size_t bytes;
} board;

static board board_new(const qtri_format *format, const qtri_depth_format *depth, int32_t first,
                       int32_t rows)
{
    const qtri_rgb sky = {1, 2, 3};
    board b;
    b.bytes = QTRI_BAND_BYTES_DEPTH(SIDE, rows, format->pixels->bytes,
                                    depth != NULL ? depth->bytes : QTRI_DEPTH_LINEAR16_BYTES);
    b.memory = calloc(b.bytes, 1);
    abort_if(b.memory == NULL ||
             qtri_surface_init(&b.surface, format, SIDE, SIDE, first, rows, b.memory, b.bytes) !=
                 QTRI_OK ||
             qtri_surface_set_depth(&b.surface, depth, b.bytes) != QTRI_OK);
    if (format->pixels->bytes >= QTRI_GRAY8_X4_BYTES) {
        qtri_samples_clear(&b.surface, sky);
    } else {
        qtri_surface_clear(&b.surface, sky);
    }
    return b;
}

/* What becomes of a drawn surface. */
static void filter(struct reader *r, const qtri_surface *s)
{
    qtri_surface out;
    const uint32_t count = take_byte(r) % 4 ? WORDS : take_byte(r);
    switch (take_byte(r) % 3) {
    case 0:
        (void)qtri_halve(s, &out);
        break;
    case 1:
        (void)qtri_fxaa(s, words, count);
        break;
    default:
        qtri_sum_clear(words, WORDS);
        (void)qtri_sum_add(words, count, s);
        (void)qtri_sum_store(s, words, count, take_int(r));
        break;
    }
}

/* At once, and left and right of a column: the same memory. */
static void draw_twice(struct reader *r, const job *j)
{
    const qtri_format *format = formats[take_byte(r) % 11];
    const bool samples = format->pixels->bytes >= QTRI_GRAY8_X4_BYTES;
    const qtri_depth_format *depth = samples ? NULL : depths[take_byte(r) % 4];
    const int32_t first = take_byte(r) % SIDE;
    const int32_t rows = 1 + take_byte(r) % SIDE;
    const int32_t column = take_byte(r) % SIDE;
    board whole = board_new(format, depth, first, rows);
    board parts = board_new(format, depth, first, rows);
    const qtri_rect left = {0, 0, column, SIDE};
    const qtri_rect right = {column, 0, SIDE, SIDE};
    draw(j, &whole.surface);
    parts.surface.scissor = left;
    draw(j, &parts.surface);
    parts.surface.scissor = right;
    draw(j, &parts.surface);
    abort_if(memcmp(whole.memory, parts.memory, whole.bytes) != 0);
    if (samples) {
        qtri_surface resolved;
        (void)qtri_samples_resolve(&whole.surface, &resolved);
    } else {
        filter(r, &whole.surface);
    }
    free(whole.memory);
    free(parts.memory);
}

/* ---- Frames ---- */

/* A mesh, prepared, in bands: the pixels of the whole frame. */
static void draw_bands(struct reader *r, const job *j)
{
    const qtri_format *format = formats[take_byte(r) % PLAIN_FORMATS];
    const int32_t rows = 1 + take_byte(r) % SIDE;
    uint16_t lists[QTRI_PREPARED_LISTS(TRIANGLES, SIDE, 1)];
    static qtri_vertex vertices[QTRI_LIT_VERTICES(VERTICES)];
    static uint8_t memory[QTRI_FRAME_BYTES_DOUBLE(SIDE, SIDE, 4)];
    qtri_frame frame;
    qtri_prepared prepared;
    qtri_surface band;
    board whole = board_new(format, NULL, 0, SIDE);
    qtri_mesh mesh = j->soup.mesh;
    mesh.faces.culling = NULL; /* planes are not those of its triangles */
    qtri_material material = j->material;
    if (material.fill == &qtri_smooth_wireframe) { /* how often edges are blended: by memory */
        material.fill = &qtri_wireframe;
    }
    qtri_draw_mesh(&whole.surface, &j->view, &j->pose, &mesh, &material);
    abort_if(qtri_frame_init(&frame, format, SIDE, SIDE, rows, memory, sizeof memory) != QTRI_OK);
    prepared_init_with(&prepared, vertices, take_byte(r) % (QTRI_LIT_VERTICES(VERTICES) + 1), lists,
                       take_byte(r) % (sizeof lists / sizeof lists[0] + 1));
    qtri_frame_begin(&frame);
    qtri_prepare_mesh(&prepared, &frame, &j->view, &j->pose, &mesh, &material);
    qtri_prepared_mark(&prepared, &frame);
    while (qtri_frame_next_band(&frame, &band)) {
        const qtri_rgb sky = {1, 2, 3};
        qtri_surface_clear(&band, sky);
        qtri_draw_prepared(&band, &prepared);
        for (int32_t y = 0; y < band.rows; y++) {
            abort_if(memcmp(band.pixels + y * band.pitch,
                            whole.surface.pixels + (band.first_row + y) * whole.surface.pitch,
                            (size_t)SIDE * (size_t)format->pixels->bytes) != 0);
        }
    }
    free(whole.memory);
}

/* Any triangle's neighbour may be any, or none. */
static void build_neighbours(struct reader *r, uint16_t neighbours[TRIANGLES][3])
{
    for (int i = 0; i < TRIANGLES; i++) {
        for (int k = 0; k < 3; k++) {
            neighbours[i][k] = take_byte(r) % (TRIANGLES + 1);
        }
    }
}

/* Outlines are found, noted and blended. */
static void draw_outlines(struct reader *r, const job *j)
{
    const qtri_format *format = formats[take_byte(r) % PLAIN_FORMATS];
    static uint32_t marks[QTRI_EDGES_WORDS(SIDE, SIDE, 4)];
    static uint32_t list[QTRI_OUTLINE_WORDS(TRIANGLES) + VERTICES + 40];
    uint16_t neighbours[TRIANGLES][3];
    qtri_mesh mesh = j->soup.mesh;
    qtri_outline outline;
    qtri_edges edges;
    build_neighbours(r, neighbours);
    mesh.neighbours = take_byte(r) % 4 ? (const uint16_t(*)[3])neighbours : NULL;
    board b =
        board_new(format, depths[take_byte(r) % 4], take_byte(r) % SIDE, 1 + take_byte(r) % SIDE);
    if (qtri_outline_init(&outline, &mesh, list, take_byte(r) % (sizeof list / sizeof list[0])) ==
        QTRI_OK) {
        (void)qtri_draw_mesh_outlined(&b.surface, &j->view, &j->pose, &j->material, &outline);
        if (qtri_edges_begin(&edges, &b.surface, marks, sizeof marks / sizeof marks[0]) ==
            QTRI_OK) {
            qtri_edges_note(&edges, &outline);
            qtri_edges_blend(&edges);
        }
    }
    free(b.memory);
}

/* Bands that overlap, of any sizes. */
static void overlap_any(struct reader *r)
{
    static uint8_t memory[QTRI_FRAME_BYTES_DOUBLE(SIDE, SIDE + 2 * 9, 4)];
    static uint8_t kept[QTRI_FRAME_KEPT_BYTES(SIDE, 9, 4)];
    const qtri_format *format = formats[take_byte(r) % PLAIN_FORMATS];
    const int32_t height = take_byte(r) % 4 ? SIDE : take_int(r);
    const int32_t rows = take_byte(r) % 8 ? take_byte(r) % SIDE : take_int(r);
    const int32_t overlap = take_byte(r) % 8 ? take_byte(r) % 10 : take_int(r);
    for (int keeps = 0; keeps < 2; keeps++) {
        qtri_frame frame;
        qtri_surface band, shown;
        (void)qtri_frame_init(&frame, format, SIDE, height, rows, memory, sizeof memory);
        (void)qtri_frame_set_overlap(&frame, overlap, keeps ? kept : NULL, sizeof kept);
        for (int i = 0; i < 200 && qtri_frame_next_band(&frame, &band); i++) {
            memset(band.pixels, i, (size_t)band.pitch * (size_t)band.rows);
            qtri_frame_join(&frame, &band);
            qtri_frame_shown(&frame, &band, &shown);
            memset(band.pixels, i, (size_t)band.pitch * (size_t)band.rows);
            memset(shown.pixels, i, (size_t)shown.pitch * (size_t)shown.rows);
        }
    }
}

/* ---- Bands that overlap ---- */

/* What smooths a frame, or a band of one. */
typedef struct smoothing {
    uint8_t kind;
    qtri_outline outline; /* for kind 1 */
} smoothing;

enum { NO_SMOOTHING, EDGES, FXAA, SMOOTHINGS };

static void smooth(smoothing *by, const qtri_surface *s)
{
    static uint32_t memory[QTRI_EDGES_WORDS(SIDE, SIDE + 32, 4)];
    qtri_edges edges;
    if (by->kind == FXAA) {
        abort_if(qtri_fxaa(s, words, WORDS) != QTRI_OK);
    } else if (by->kind == EDGES) {
        abort_if(qtri_edges_begin(&edges, s, memory, sizeof memory / sizeof memory[0]) != QTRI_OK);
        qtri_edges_note(&edges, &by->outline);
        qtri_edges_blend(&edges);
    }
}

/* A mesh, prepared, in bands that overlap: smoothed, those of the frame. */
static void join(struct reader *r, const job *j)
{
    static uint8_t memory[QTRI_FRAME_BYTES(SIDE, SIDE + 2 * 3, 4)];
    static uint8_t kept[QTRI_FRAME_KEPT_BYTES(SIDE, 3, 4)];
    static uint16_t lists[QTRI_PREPARED_LISTS(TRIANGLES, SIDE, 1)];
    static qtri_vertex vertices[QTRI_LIT_VERTICES(VERTICES)];
    static uint32_t list[QTRI_OUTLINE_WORDS(TRIANGLES) + VERTICES + 40];
    uint16_t neighbours[TRIANGLES][3];
    const qtri_rgb sky = {1, 2, 3};
    const qtri_format *format = formats[take_byte(r) % PLAIN_FORMATS];
    smoothing by = {.kind = take_byte(r) % SMOOTHINGS};
    const int32_t overlap = (by.kind == FXAA ? QTRI_FXAA_OVERLAP : 1) + take_byte(r) % 2;
    const int32_t rows = 2 * overlap + take_byte(r) % (SIDE - 2 * overlap + 1);
    qtri_frame frame;
    qtri_prepared prepared;
    qtri_surface band, shown;
    qtri_mesh mesh = j->soup.mesh;
    qtri_material material = j->material;
    qtri_view view = j->view;
    build_neighbours(r, neighbours);
    mesh.neighbours = take_byte(r) % 4 ? (const uint16_t(*)[3])neighbours : NULL;
    mesh.faces.culling = NULL;                     /* planes are not those of its triangles */
    if (material.fill == &qtri_smooth_wireframe) { /* how often edges are blended: by memory */
        material.fill = &qtri_wireframe;
    }
    view.vertices = vertices;
    view.vertex_count = VERTICES;
    abort_if(qtri_outline_init(&by.outline, &mesh, list,
                               sizeof list / sizeof list[0] - take_byte(r) % 40) != QTRI_OK);
    by.outline.creases = take_byte(r) % 2;
    board whole = board_new(format, NULL, 0, SIDE);
    abort_if(qtri_draw_mesh_outlined(&whole.surface, &view, &j->pose, &material, &by.outline) !=
             QTRI_OK);
    smooth(&by, &whole.surface);
    abort_if(qtri_frame_init(&frame, format, SIDE, SIDE, rows, memory, sizeof memory) != QTRI_OK);
    abort_if(qtri_frame_set_overlap(&frame, overlap, take_byte(r) % 4 ? kept : NULL, sizeof kept) !=
             QTRI_OK);
    prepared_init_with(&prepared, vertices, QTRI_LIT_VERTICES(VERTICES), lists,
                       take_byte(r) % (sizeof lists / sizeof lists[0] + 1));
    qtri_prepared_set_outline(&prepared, &by.outline);
    qtri_prepare_mesh(&prepared, &frame, &view, &j->pose, &mesh, &material);
    abort_if(qtri_prepared_find_edges(&prepared, &by.outline) != QTRI_OK);
    int32_t row = 0;
    while (qtri_frame_next_band(&frame, &band)) {
        qtri_surface_clear(&band, sky);
        qtri_draw_prepared(&band, &prepared);
        qtri_frame_join(&frame, &band);
        smooth(&by, &band);
        qtri_frame_shown(&frame, &band, &shown);
        abort_if(shown.first_row != row);
        for (int32_t y = 0; y < shown.rows; y++, row++) {
            abort_if(memcmp(shown.pixels + y * shown.pitch,
                            whole.surface.pixels + row * whole.surface.pitch,
                            (size_t)SIDE * (size_t)format->pixels->bytes) != 0);
        }
    }
    abort_if(row != SIDE);
    free(whole.memory);
}

/* Where a mesh is, and what becomes of it. */
static void look_at(struct reader *r, job *j)
{
    const qtri_box box = qtri_mesh_box(&j->soup.mesh);
    const qtri_ball ball = qtri_mesh_ball(&j->soup.mesh);
    (void)qtri_view_sees_box(&j->view, &j->pose, &box);
    (void)qtri_view_sees_ball(&j->view, &j->pose, &ball);
    const int32_t frames_log2 = take_int(r);
    const uint32_t frame = (uint32_t)take_int(r);
    qtri_view_jitter(&j->view, &j->view, frame, frames_log2);
    const qtri_position16 *target[1] = {j->soup.positions16 + 1};
    const q16 weight = take_int(r);
    qtri_position16 out[VERTICES - 1];
    qtri_morph_targets(out, j->soup.positions16, target, &weight, 1, VERTICES - 1);
    qtri_morph_positions(out, j->soup.positions16, target[0], VERTICES - 1, weight);
    qtri_frames_positions(out, j->soup.positions16, VERTICES, 1, weight);
    qtri_key keys[3];
    take(r, keys, sizeof keys);
    const qtri_key key = qtri_keys_at(keys, take_byte(r) % 4, weight);
    qtri_transform_key(&j->pose, &key);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static job zero;
    static job j;
    struct reader reader = {data, size};
    struct reader *r = &reader;
    const uint8_t what = take_byte(r);
    j = zero;
    j.kind = take_byte(r);
    const bool has_bands = what % 8 == 1 || what % 8 == 2 || what % 8 == 3 || what % 8 >= 6;
    if (!has_bands) { /* bytes that bands would skip keep the fuzzer from what they read */
        build_shapes(r, &j);
        build_pictures(r, &j);
    }
    build_stage(r, &j);
    (void)build_mesh(r, &j.soup);
    if (what % 16 == 0) {
        look_at(r, &j);
    }
    if (what % 8 == 1) {
        overlap_any(r);
    } else if (what % 8 >= 6) {
        join(r, &j);
    } else if (what % 8 == 2) {
        draw_outlines(r, &j);
    } else if (what % 8 == 3) {
        draw_bands(r, &j);
    } else {
        draw_twice(r, &j);
    }
    return 0;
}
