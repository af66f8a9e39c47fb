/* SPDX-License-Identifier: MIT */
#include "random_states.h"
#include "layouts.h"

#include "qtri/pipeline_make.h"

/* Checksums of what was drawn ------------------------------------------------------------------ */

uint32_t random_hash(uint32_t hash, uint32_t value, int32_t bytes)
{
    for (int32_t i = 0; i < bytes; i++) {
        hash = (hash ^ (value >> 8 * i & 0xFF)) * 16777619u;
    }
    return hash;
}

static uint32_t add_surface(uint32_t hash, const qtri_surface *s)
{
    for (int32_t y = s->first_row; y < s->first_row + s->rows; y++) {
        for (int32_t x = 0; x < s->width; x++) {
            hash = random_hash(hash, stored_pixel(s, x, y), s->format->pixels->bytes);
        }
    }
    return hash;
}

static void keep_depths(random_states *w, const qtri_surface *s)
{
    for (int32_t y = s->first_row; y < s->first_row + s->rows; y++) {
        for (int32_t x = 0; x < s->width; x++) {
            w->depths[y * s->width + x] = stored_depth(s, x, y);
        }
    }
}

static uint32_t add_depths(const random_states *w, uint32_t hash)
{
    for (int32_t i = 0; i < w->width * w->height; i++) {
        hash = random_hash(hash, w->depths[i], 2);
    }
    return hash;
}

/* Of surfaces from the top on, as they are in memory. */
static void add_other_depths(random_states *w, const qtri_surface *s, int32_t bytes)
{
    const uint8_t *row = (const uint8_t *)s->depth;
    for (int32_t y = 0; y < s->rows; y++, row += (ptrdiff_t)s->depth_pitch * bytes) {
        for (int32_t i = 0; i < s->width * bytes; i++) {
            w->other_depths = random_hash(w->other_depths, row[i], 1);
        }
    }
}

/* The rows of one band, or all. */
static int32_t rows_of(const random_states *w)
{
    return w->band_rows != 0 && w->band_rows < w->height ? w->band_rows : w->height;
}

/* The last bytes of the memory, so that what is written past their end is seen. */
static void surface_at(random_states *w, qtri_surface *surface, uint8_t *memory,
                       const qtri_format *format, const qtri_depth_format *depths, int32_t first)
{
    const size_t bytes =
        QTRI_BAND_BYTES_DEPTH(w->width, rows_of(w), format->pixels->bytes, depths->bytes);
    uint8_t *at = memory + (STATES_BYTES - bytes);
    memset(at, 0, bytes);
    w->failed |= surface_with_depth(surface, format, depths, w->width, w->height, first, rows_of(w),
                                    at, bytes) != QTRI_OK;
}

static void draw_twice(random_states *w, const qtri_surface *surface, random_draw *draw)
{
    for (int times = 0; times < 2; times++) {
        random_view(w);
        random_material(w);
        draw(w, surface);
    }
}

static void draw_in_tiles(random_states *w, qtri_surface *surface, random_draw *draw)
{
    const qtri_rect all = surface->scissor;
    const int32_t columns = w->tile_columns != 0 ? w->tile_columns : w->width;
    const uint64_t seed = w->seed;
    for (int32_t x = 0; x < w->width; x += columns) {
        surface->scissor.x0 = x > all.x0 ? x : all.x0;
        surface->scissor.x1 = x + columns < all.x1 ? x + columns : all.x1;
        w->seed = seed;
        draw_twice(w, surface, draw);
    }
    surface->scissor = all;
}

/* The colour and depth that a surface is cleared to are not the ends. */
uint32_t random_on_surface(random_states *w, uint32_t hash, random_draw *draw)
{
    static const qtri_depth_format *const depth_formats[] = {
        &qtri_depth_linear16, &qtri_depth_float16, &qtri_depth_linear24, &qtri_depth_linear32};
    const int32_t kind = random_below(w, 4);
    random_size(w, 3);
    const bool farthest = !random_one_in(w, 4);
    const q16 depth = farthest ? Q16(1) : random_between(w, 0, Q16(1));
    const qtri_depth_format *depths = depth_formats[random_one_in(w, 2) ? 0 : kind];
    const qtri_format *format =
        random_one_in(w, 2) ? &qtri_rgb565 : drawn_format(random_below(w, 7));
    const qtri_rgb sky = random_rgb(w);
    qtri_rect scissor = {0, 0, w->width, w->height};
    if (random_one_in(w, 5)) {
        scissor.x0 = random_below(w, w->width);
        scissor.y0 = random_below(w, w->height);
    }
    const uint64_t seed = w->seed;
    for (int32_t first = 0; first < w->height; first += rows_of(w)) {
        qtri_surface surface;
        surface_at(w, &surface, w->memory, format, depths, first);
        qtri_surface_clear(&surface, sky);
        qtri_surface_clear_depth(&surface, depth);
        surface.scissor = scissor;
        w->seed = seed;
        draw_in_tiles(w, &surface, draw);
        hash = add_surface(hash, &surface);
        if (depths->bytes == 2) {
            keep_depths(w, &surface);
        } else {
            add_other_depths(w, &surface, depths->bytes);
        }
    }
    return depths->bytes == 2 ? add_depths(w, hash) : hash;
}

uint32_t random_on_samples(random_states *w, uint32_t hash, random_draw *draw)
{
    static const qtri_format *const four[] = {&qtri_rgb565_x4, &qtri_rgb565_swapped_x4,
                                              &qtri_xrgb8888_x4, &qtri_rgb888_x4, &qtri_gray8_x4};
    static const qtri_format *const plain[] = {&qtri_rgb565, &qtri_rgb565_swapped, &qtri_xrgb8888,
                                               &qtri_rgb888, &qtri_gray8};
    const int32_t kind = random_one_in(w, 2) ? 0 : random_below(w, 5);
    random_size(w, 3);
    const qtri_rgb sky = random_rgb(w);
    const q16 depth = random_one_in(w, 4) ? random_between(w, 0, Q16(1)) : Q16(1);
    const uint64_t seed = w->seed;
    for (int32_t first = 0; first < w->height; first += rows_of(w)) {
        qtri_surface samples, shown;
        surface_at(w, &samples, w->memory, four[kind], &qtri_depth_linear16, first);
        surface_at(w, &shown, w->resolved, plain[kind], &qtri_depth_linear16, first);
        qtri_samples_clear(&samples, sky);
        if (depth != Q16(1)) {
            qtri_samples_clear_depth(&samples, depth);
        }
        w->seed = seed;
        draw_in_tiles(w, &samples, draw);
        w->failed |= qtri_samples_resolve(&samples, &shown) != QTRI_OK;
        hash = add_surface(hash, &shown);
        keep_depths(w, &samples);
    }
    return add_depths(w, hash);
}

/* Draws ---------------------------------------------------------------------------------------- */

void random_draw_mesh(random_states *w, const qtri_surface *surface)
{
    switch (random_below(w, 8)) {
    case 0:
        qtri_draw_hidden_lines(surface, &w->view, &w->pose, &w->mesh,
                               random_one_in(w, 2) ? &w->stroke : NULL, &w->material, Q16(.002));
        break;
    case 1:
        qtri_draw_wide_wireframe(surface, &w->view, &w->pose, &w->mesh, &w->stroke, &w->material);
        break;
    default:
        qtri_draw_mesh(surface, &w->view, &w->pose, &w->mesh, &w->material);
        break;
    }
}

void random_draw_soup(random_states *w, const qtri_surface *surface)
{
    random_mesh(w);
    random_draw_mesh(w, surface);
}

void random_draw_solid(random_states *w, const qtri_surface *surface)
{
    random_solid(w);
    qtri_draw_mesh(surface, &w->view, &w->pose, &w->mesh, &w->material);
}

void random_draw_corners(random_states *w, const qtri_surface *surface)
{
    random_corners(w);
    switch (random_below(w, 6)) {
    case 0:
        qtri_draw_lines(surface, &w->view, &w->pose, w->corners, STATES_CORNERS, &w->material);
        break;
    case 1:
        qtri_draw_polyline(surface, &w->view, &w->pose, w->corners, STATES_CORNERS, &w->stroke,
                           &w->material);
        break;
    case 2:
        qtri_draw_wide_lines(surface, &w->view, &w->pose, w->corners, STATES_CORNERS, &w->stroke,
                             &w->material);
        break;
    case 3:
        qtri_draw_points(surface, &w->view, &w->pose, w->corners, STATES_CORNERS, &w->stroke,
                         &w->material);
        break;
    case 4:
        qtri_draw_lit_triangles(surface, &w->view, &w->pose, w->corners,
                                random_one_in(w, 2) ? w->normals : NULL, STATES_CORNERS,
                                &w->material);
        break;
    default:
        qtri_draw_triangles(surface, &w->view, &w->pose, w->corners, STATES_CORNERS, &w->material);
        break;
    }
}

void random_draw_screen(random_states *w, const qtri_surface *surface)
{
    for (int times = 0; times < 3; times++) {
        random_screen(w);
        switch (random_below(w, 4)) {
        case 0:
            qtri_raster_line(surface, &w->material, w->screen);
            break;
        case 1:
            qtri_raster_polyline(surface, &w->material, &w->stroke, w->screen,
                                 1 + (uint32_t)random_below(w, STATES_CORNERS));
            break;
        case 2:
            qtri_raster_point(surface, &w->material, &w->stroke, w->screen);
            break;
        default:
            for (int i = 0; i < STATES_CORNERS; i += 3) {
                qtri_raster_triangle(surface, w->view.pipelines, &w->material, w->screen + i);
            }
            break;
        }
    }
}

/* Passes over a whole frame, or over its bands ------------------------------------------------- */

/* The triangle across each side, or none: as QTRI_MESH's tools make them. */
static void find_neighbours(random_states *w)
{
    for (uint32_t i = 0; i < w->mesh.triangle_count; i++) {
        for (int k = 0; k < 3; k++) {
            const uint16_t a = w->triangles[i][k];
            const uint16_t b = w->triangles[i][(k + 1) % 3];
            uint32_t across = w->mesh.triangle_count;
            for (uint32_t j = 0; j < w->mesh.triangle_count * 3; j++) {
                if (w->triangles[j / 3][j % 3] == b && w->triangles[j / 3][(j + 1) % 3] == a) {
                    across = j / 3;
                }
            }
            w->neighbours[i][k] = (uint16_t)across;
        }
    }
    w->mesh.neighbours = (const uint16_t(*)[3])w->neighbours;
}

static void random_pass(random_states *w)
{
    random_view(w);
    random_material(w);
    random_mesh(w);
    w->view.vertex_count = STATES_VERTICES;
    w->material.fill = random_one_in(w, 9) ? &qtri_wireframe : NULL;
    if (random_one_in(w, 2)) {
        find_neighbours(w);
    }
    w->outline_words = QTRI_OUTLINE_WORDS(w->mesh.triangle_count) +
                       (w->mesh.neighbours != NULL ? 0 : QTRI_OUTLINE_SUMS(w->mesh.vertex_count)) +
                       (uint32_t)random_below(w, 60);
    w->outline[w->outline_words] = 0xA5A5A5A5u;
    w->failed |= qtri_outline_init(&w->outlined, &w->mesh, w->outline, w->outline_words) != QTRI_OK;
    w->outlined.creases = random_one_in(w, 2);
}

static void blend_edges(random_states *w, const qtri_surface *surface)
{
    w->failed |= w->outline[w->outline_words] != 0xA5A5A5A5u;
    w->failed |= qtri_edges_begin(&w->pass, surface, w->edges, LENGTH_OF(w->edges)) != QTRI_OK;
    qtri_edges_note(&w->pass, &w->outlined);
    qtri_edges_blend(&w->pass);
}

void random_draw_outlined(random_states *w, const qtri_surface *surface)
{
    random_pass(w);
    if (surface->depth_format != NULL && surface->depth_format->bytes != 2) {
        qtri_surface_clear_depth(surface, Q16(1)); /* notes of 16 bits, where there was a pass */
    }
    (void)qtri_draw_mesh_outlined(surface, &w->view, &w->pose, &w->material, &w->outlined);
    blend_edges(w, surface);
}

uint32_t random_in_bands(random_states *w, uint32_t hash, random_draw *draw)
{
    const qtri_format *format =
        random_one_in(w, 2) ? &qtri_rgb565 : drawn_format(random_below(w, 7));
    const int32_t rows = 4 + random_below(w, STATES_HEIGHT - 4);
    const qtri_rgb sky = random_rgb(w);
    const bool with_edges = random_one_in(w, 2);
    random_size(w, 1);
    qtri_frame frame;
    qtri_prepared prepared;
    qtri_surface band, shown;
    (void)draw;
    random_pass(w);
    w->failed |= frame_with_overlap(&frame, format, STATES_WIDTH, STATES_HEIGHT, rows,
                                    1 + random_below(w, 3), w->halo_memory,
                                    sizeof w->halo_memory) != QTRI_OK;
    const uint32_t vertex_count = random_one_in(w, 4) ? 0 : LENGTH_OF(w->prepared_vertices);
    const uint32_t list_count =
        random_one_in(w, 3) ? (uint32_t)random_below(w, 200) : LENGTH_OF(w->lists);
    prepared_init_with(&prepared, w->prepared_vertices, vertex_count, w->lists, list_count);
    qtri_prepared_set_outline(&prepared, with_edges ? &w->outlined : NULL);
    qtri_prepare_mesh(&prepared, &frame, &w->view, &w->pose, &w->mesh, &w->material);
    if (with_edges) {
        (void)qtri_prepared_find_edges(&prepared, &w->outlined);
    }
    qtri_prepared_mark(&prepared, &frame);
    const qtri_rect changes = qtri_frame_changes(&frame);
    const int32_t touched[] = {changes.x0, changes.y0, changes.x1, changes.y1};
    for (int i = 0; i < 4; i++) {
        hash = random_hash(hash, (uint32_t)touched[i], 4);
    }
    while (next_shown(&frame, &band, &shown)) {
        qtri_surface_clear(&band, sky);
        qtri_draw_prepared(&band, &prepared);
        if (with_edges) {
            blend_edges(w, &band);
        }
        hash = add_surface(hash, &shown);
    }
    return hash;
}

#define FOURS(compares) .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = (compares)
QTRI_PIPELINE(fours_less, FOURS(QTRI_LESS))
QTRI_PIPELINE(fours_less_equal, FOURS(QTRI_LESS_EQUAL))
QTRI_PIPELINE(fours_greater, FOURS(QTRI_GREATER))
QTRI_PIPELINE(fours_greater_equal, FOURS(QTRI_GREATER_EQUAL))
QTRI_PIPELINE(fours_off, .format = QTRI_RGB565)
QTRI_PIPELINE(fours_colors_less, FOURS(QTRI_LESS), .shade = QTRI_COLORS)
QTRI_PIPELINE(fours_colors_less_equal, FOURS(QTRI_LESS_EQUAL), .shade = QTRI_COLORS)
QTRI_PIPELINE(fours_colors_greater, FOURS(QTRI_GREATER), .shade = QTRI_COLORS)
QTRI_PIPELINE(fours_colors_greater_equal, FOURS(QTRI_GREATER_EQUAL), .shade = QTRI_COLORS)

static const qtri_pipeline *const fours[] = {&fours_less,
                                             &fours_less_equal,
                                             &fours_greater,
                                             &fours_greater_equal,
                                             &fours_off,
                                             &fours_colors_less,
                                             &fours_colors_less_equal,
                                             &fours_colors_greater,
                                             &fours_colors_greater_equal,
                                             &qtri_pipeline_any,
                                             NULL};

/* Depths that are a step below, at and above that of a plane: long and short runs of each. */
static void lay_depths(random_states *w, const qtri_surface *surface, const qtri_screen_vertex *v)
{
    for (int32_t y = 0; y < w->height; y++) {
        uint16_t *row = (uint16_t *)surface->depth + (ptrdiff_t)y * surface->depth_pitch;
        int32_t left = 0, step = 0;
        for (int32_t x = 0; x < w->width; x++, left--) {
            if (left == 0) {
                left = 1 + random_below(w, random_one_in(w, 2) ? 3 : 20);
                step = random_below(w, 3) - 1;
            }
            const int64_t right = ((int64_t)v[1].depth_16p16 - v[0].depth_16p16) * x;
            const int64_t down = ((int64_t)v[2].depth_16p16 - v[0].depth_16p16) * y;
            row[x] = (uint16_t)((v[0].depth_16p16 + (right + down) / 256) / 65536 + step);
        }
    }
}

/* Vertices 256 pixels apart, right and down. */
static void lay_triangle(random_states *w, qtri_screen_vertex v[3])
{
    random_screen(w);
    const uint32_t z = (uint32_t)random_between(w, Q16(.2), Q16(.8)) << 16;
    for (int i = 0; i < 3; i++) {
        v[i] = w->screen[i];
        v[i].x_24p8 = (i == 1 ? 256 * 256 : 0) + 128;
        v[i].y_24p8 = (i == 2 ? 256 * 256 : 0) + 128;
        v[i].depth_16p16 = z + (uint32_t)(i == 0 ? 0 : random_below(w, 1 << 26) - (1 << 25));
        v[i].inv_w_q31 = 0x40000000u;
        v[i].inv_w_exponent = 0;
        for (int k = 0; k < 3; k++) {
            v[i].color_8p16[k] = random_below(w, 256 << 16);
        }
    }
}

uint32_t random_by_fours(random_states *w, uint32_t hash, random_draw *draw)
{
    static const qtri_compare compares[] = {QTRI_LESS, QTRI_LESS_EQUAL, QTRI_GREATER,
                                            QTRI_GREATER_EQUAL, QTRI_DEPTH_OFF};
    qtri_screen_vertex v[3];
    qtri_surface surface;
    (void)draw;
    random_size(w, 3);
    random_material(w);
    random_usual(w);
    w->material.texture = NULL;
    w->material.shading = random_one_in(w, 2) ? QTRI_SMOOTH : QTRI_FLAT_FIRST;
    lay_triangle(w, v);
    surface_at(w, &surface, w->memory, &qtri_rgb565, &qtri_depth_linear16, 0);
    surface.scissor.x0 = random_below(w, 9);
    surface.scissor.x1 -= random_below(w, 9);
    for (size_t i = 0; i < LENGTH_OF(compares); i++) {
        qtri_surface_clear(&surface, random_rgb(w));
        lay_depths(w, &surface, v);
        w->material.depth_compare = compares[i];
        qtri_raster_triangle(&surface, fours, &w->material, v);
        hash = add_surface(hash, &surface);
        keep_depths(w, &surface);
        hash = add_depths(w, hash);
    }
    return hash;
}

void random_draw_usual(random_states *w, const qtri_surface *surface)
{
    random_usual(w);
    random_mesh(w);
    w->mesh.colors = random_one_in(w, 3) ? w->mesh.colors : NULL;
    qtri_draw_mesh(surface, &w->view, &w->pose, &w->mesh, &w->material);
}

void random_draw_usual_screen(random_states *w, const qtri_surface *surface)
{
    random_usual(w);
    random_draw_screen(w, surface);
}

/* Edges are blended with rows of the bands above and below, as random_in_bands does. */
const random_kind random_kinds[] = {
    {"solids", random_draw_solid, random_on_surface, true},
    {"solids of samples", random_draw_solid, random_on_samples, true},
    {"meshes", random_draw_soup, random_on_surface, true},
    {"meshes of samples", random_draw_soup, random_on_samples, true},
    {"corners", random_draw_corners, random_on_surface, true},
    {"corners of samples", random_draw_corners, random_on_samples, true},
    {"screen", random_draw_screen, random_on_surface, true},
    {"screen of samples", random_draw_screen, random_on_samples, true},
    {"usual", random_draw_usual, random_on_surface, true},
    {"usual on screen", random_draw_usual_screen, random_on_surface, true},
    {"outlines", random_draw_outlined, random_on_surface, false},
    {"bands", NULL, random_in_bands, false},
    {"fours", NULL, random_by_fours, false},
    {NULL, NULL, NULL, false},
};
