/* SPDX-License-Identifier: MIT */
/*
 * Scenes that are smoothed.
 */
#include "bench_scenes.h"

#define WORDS(array) ((uint32_t)(sizeof(array) / sizeof((array)[0])))

enum { BAND_ROWS = 16, OVERLAP = 1, BANDS = BENCH_HEIGHT / BAND_ROWS };

static bool prepare_outline(bench_frame *frame)
{
    bench_smoother *s = &frame->smoother;
    if (frame->scene->smooth == BENCH_SUMS) {
        frame->mesh.neighbours = NULL;
    }
    return qtri_outline_init(&s->outline, &frame->mesh, s->outline_memory,
                             WORDS(s->outline_memory)) == QTRI_OK;
}

/* Memory of bands: one below the other. Overlap takes as many rows as are kept. */
static uint32_t *memory_of(bench_smoother *s, int32_t band)
{
    return &s->bands[band * ((BAND_ROWS + 2 * OVERLAP) * BENCH_WIDTH)];
}

static void draw(bench_frame *frame, const qtri_surface *surface)
{
    qtri_draw_mesh(surface, &frame->view, &frame->pose, &frame->mesh, &frame->material);
}

bool bench_prepare_smooth(bench_frame *frame)
{
    bench_smoother *s = &frame->smoother;
    switch (frame->scene->smooth) {
    case BENCH_EDGES:
    case BENCH_SUMS:
        if (!prepare_outline(frame)) {
            return false;
        }
        break;
    case BENCH_HALVE:
        frame->view.viewport.width = 2 * BENCH_WIDTH;
        frame->view.viewport.height = 2 * BENCH_HEIGHT;
        break;
    case BENCH_STORE:
        draw(frame, &frame->surface);
        qtri_sum_clear(s->sums, WORDS(s->sums));
        for (int i = 0; i < 4; i++) {
            (void)qtri_sum_add(s->sums, WORDS(s->sums), &frame->surface);
        }
        break;
    case BENCH_ADD:
        draw(frame, &frame->surface);
        break;
    default:
        break;
    }
    if (frame->scene->band_rows == 0) {
        return true;
    }
    qtri_prepared_set_outline(&frame->prepared, &s->outline);
    if (qtri_frame_init(&s->overlapped, &qtri_rgb565, BENCH_WIDTH, BENCH_HEIGHT, BAND_ROWS,
                        frame->memory, /* one buffer */
                        QTRI_FRAME_BYTES(BENCH_WIDTH, BAND_ROWS + 2 * OVERLAP, 2)) != QTRI_OK ||
        qtri_frame_set_overlap(&s->overlapped, OVERLAP, frame->scene->keeps ? s->kept : NULL,
                               sizeof s->kept) != QTRI_OK) {
        return false;
    }
    for (int32_t i = 0; i < BANDS; i++) {
        qtri_surface rows;
        const int32_t count =
            i == 0 && frame->scene->keeps ? BAND_ROWS : BAND_ROWS + 2 * OVERLAP; /* none are kept */
        (void)qtri_surface_init(&rows, &qtri_rgb565, BENCH_WIDTH, count, 0, count, memory_of(s, i),
                                QTRI_BAND_BYTES(BENCH_WIDTH, count, 2));
        qtri_surface_clear(&rows, bench_background);
    }
    return true;
}

static void smooth(bench_frame *frame, const qtri_surface *surface)
{
    bench_smoother *s = &frame->smoother;
    qtri_edges edges;
    (void)qtri_edges_begin(&edges, surface, s->edge_memory, WORDS(s->edge_memory));
    qtri_edges_note(&edges, &s->outline);
    qtri_edges_blend(&edges);
}

/* Bands in memory of their own, so that they can be shown later. */
static bool next_band(bench_frame *frame, qtri_surface *band)
{
    bench_smoother *s = &frame->smoother;
    qtri_surface shown;
    if (!qtri_frame_next_band(&s->overlapped, band)) {
        return false;
    }
    qtri_frame_shown(&s->overlapped, band, &shown);
    uint32_t *memory = memory_of(s, shown.first_row / BAND_ROWS);
    band->pixels = (uint8_t *)memory;
    band->depth = (uint16_t *)(void *)memory + (BAND_ROWS + 2 * OVERLAP) * BENCH_WIDTH;
    return true;
}

/* At twice the size; the frame shows what is made of it. */
static void draw_large(bench_frame *frame)
{
    bench_smoother *s = &frame->smoother;
    qtri_surface large, half;
    (void)qtri_surface_init(&large, &qtri_rgb565, 2 * BENCH_WIDTH, 2 * BENCH_HEIGHT, 0,
                            2 * BENCH_HEIGHT, s->large, sizeof s->large);
    qtri_surface_clear(&large, bench_background);
    draw(frame, &large);
    (void)qtri_halve(&large, &half);
    frame->surface.pixels = half.pixels;
    frame->surface.pitch = half.pitch;
}

/* With four samples a pixel; as above. */
static void draw_samples(bench_frame *frame)
{
    bench_smoother *s = &frame->smoother;
    qtri_surface samples;
    (void)qtri_surface_init(&samples, &qtri_rgb565_x4, BENCH_WIDTH, BENCH_HEIGHT, 0, BENCH_HEIGHT,
                            s->large, sizeof s->large);
    qtri_samples_clear(&samples, bench_background);
    if (frame->scene->work == BENCH_MESH) {
        draw(frame, &samples);
    } else {
        qtri_draw_triangles(&samples, &frame->view, &frame->pose, frame->corners, 6,
                            &frame->material); /* a quad */
    }
    (void)qtri_samples_resolve(&samples, &samples);
    frame->surface.pixels = samples.pixels;
    frame->surface.pitch = samples.pitch;
}

static void draw_whole(bench_frame *frame)
{
    bench_smoother *s = &frame->smoother;
    switch (frame->scene->smooth) {
    case BENCH_HALVE:
        draw_large(frame);
        break;
    case BENCH_SAMPLES:
        draw_samples(frame);
        break;
    case BENCH_FXAA:
        draw(frame, &frame->surface);
        (void)qtri_fxaa(&frame->surface, s->rows, WORDS(s->rows));
        break;
    case BENCH_ADD:
        (void)qtri_sum_add(s->sums, WORDS(s->sums), &frame->surface);
        break;
    case BENCH_STORE:
        (void)qtri_sum_store(&frame->surface, s->sums, WORDS(s->sums), 2);
        break;
    default:
        (void)qtri_draw_mesh_outlined(&frame->surface, &frame->view, &frame->pose, &frame->material,
                                      &s->outline);
        smooth(frame, &frame->surface);
        break;
    }
}

/* Bands that keep the rows they share, each in memory of its own. */
static void draw_keeping(bench_frame *frame)
{
    bench_smoother *s = &frame->smoother;
    qtri_surface band;
    for (int32_t i = 0;; i++) {
        s->overlapped.memory = (uint8_t *)memory_of(s, i);
        if (!qtri_frame_next_band(&s->overlapped, &band)) {
            return;
        }
        qtri_draw_prepared(&band, &frame->prepared);
        qtri_frame_join(&s->overlapped, &band);
        smooth(frame, &band);
    }
}

void bench_draw_smooth(bench_frame *frame)
{
    bench_smoother *s = &frame->smoother;
    if (frame->scene->band_rows == 0) {
        draw_whole(frame);
        return;
    }
    qtri_surface band;
    qtri_prepare_mesh(&frame->prepared, &s->overlapped, &frame->view, &frame->pose, &frame->mesh,
                      &frame->material);
    (void)qtri_prepared_find_edges(&frame->prepared, &s->outline);
    if (frame->scene->keeps) {
        draw_keeping(frame);
        return;
    }
    while (next_band(frame, &band)) {
        qtri_draw_prepared(&band, &frame->prepared);
        smooth(frame, &band);
    }
}

void bench_finish_smooth(bench_frame *frame)
{
    if (frame->scene->band_rows == 0) {
        return;
    }
    const int32_t behind = frame->scene->keeps ? OVERLAP : 0; /* what is shown, and what is drawn */
    for (int32_t y = 0; y < BENCH_HEIGHT; y++) {
        const int32_t band =
            (y + behind) / BAND_ROWS < BANDS ? (y + behind) / BAND_ROWS : BANDS - 1;
        const int32_t first = band == 0 ? 0 : band * BAND_ROWS - OVERLAP - behind;
        const uint16_t *from = (const uint16_t *)(const void *)memory_of(&frame->smoother, band) +
                               (y - first) * BENCH_WIDTH;
        uint16_t *to = (uint16_t *)(void *)(frame->surface.pixels + y * frame->surface.pitch);
        for (int32_t x = 0; x < BENCH_WIDTH; x++) {
            to[x] = from[x];
        }
    }
}
