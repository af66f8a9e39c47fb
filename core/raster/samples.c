/* SPDX-License-Identifier: MIT */
/*
 * Triangles on surfaces with four samples a pixel.
 *
 * The triangle is covered five times by its spans: moved so that each sample, and at last the
 * centre, lies where centres do. Depths come from the moved triangles as well, and so do colours at
 * a sample, by the stages of every other surface: they store into a row of words, from which the
 * samples that pass take theirs. Nothing here knows what a triangle is filled with.
 */
#include "samples.h"

#include "effect.h"
#include "list.h"
#include "shading.h"
#include "rows.h"
#include "setup.h"
#include "span.h"
#include "loop.h"

enum { CENTER = QTRI_SAMPLES, PLACES };

const int8_t qtri_sample_offset[PLACES][2] = {{-32, -96}, {96, -32}, {-96, 32}, {32, 96}, {0, 0}};

/* ---- A row of stored pixels, each as a word ---- */

#define DRAWN 0x80000000u /* no format has as many bits */

static uint32_t load(const uint8_t *pixel)
{
    return *(const uint32_t *)(const void *)pixel & ~DRAWN;
}

static void fill(uint8_t *pixel, uint32_t stored, uint32_t mask, int32_t count)
{
    uint32_t *word = (uint32_t *)(void *)pixel;
    for (int32_t i = 0; i < count; i++) {
        if ((mask >> (count - 1 - i) & 1) != 0) {
            word[i] = stored | DRAWN;
        }
    }
}

static void store(uint8_t *pixel, const uint32_t *stored, uint32_t mask, int32_t count)
{
    uint32_t *word = (uint32_t *)(void *)pixel;
    for (int32_t i = 0; i < count; i++) {
        if ((mask >> (count - 1 - i) & 1) != 0) {
            word[i] = stored[i] | DRAWN;
        }
    }
}

/* Rows go through `store`; here for the type. */
static void scatter(uint8_t *pixels, ptrdiff_t pitch, const uint32_t *place, const uint32_t *stored,
                    int32_t count)
{
    (void)pitch;
    for (int32_t i = 0; i < count; i++) {
        ((uint32_t *)(void *)pixels)[place[i] & 0xFFFF] = stored[i] | DRAWN;
    }
}

static const qtri_pixels words = {4, load, fill, store, scatter};

/* ---- The triangle at one of its places ---- */

typedef struct moved {
    qtri_screen_point p[3];
    qtri_triangle triangle;
    qtri_rows rows;
    int32_t first, count; /* rows whose spans the triangle has */
    bool any;             /* it covers something */
    bool ready;           /* its job and `fill` are set */
    qtri_job job;
    qtri_fill_rows fill;
    qtri_ramp depth;
    int32_t anchor_x, anchor_y; /* of `depth` */
} moved;

static void move(moved *m, const qtri_raster *raster, const qtri_triangle *from, int place)
{
    for (int i = 0; i < 3; i++) {
        /* By less than a pixel: coordinates stay where all that follows has room. */
        m->p[i].x_24p8 = qtri_hold32(from->p[i]->x_24p8 - qtri_sample_offset[place][0],
                                     -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
        m->p[i].y_24p8 = qtri_hold32(from->p[i]->y_24p8 - qtri_sample_offset[place][1],
                                     -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
        m->triangle.p[i] = &m->p[i];
    }
    m->triangle.area = qtri_triangle_area(&m->p[0], &m->p[1], &m->p[2]);
    m->triangle.tinted = from->tinted;
    m->ready = false;
    m->any = m->triangle.area != 0 && qtri_triangle_begin(raster, &m->triangle);
    if (!m->any) {
        return;
    }
    m->first = m->triangle.row;
    m->count = 0;
    if (QTRI_WITH_FAST_PATHS && m->triangle.is_short) {
        m->count = m->triangle.end - m->triangle.row;
    } else {
        qtri_rows_init(&m->rows, &m->triangle);
    }
}

/* Its pixels in a row; rows come in their order. */
static qtri_span span_in(moved *m, int32_t row)
{
    const qtri_span none = {0, 0};
    if (!m->any || row < m->triangle.row || row >= m->triangle.end) {
        return none;
    }
    while (row >= m->first + m->count) {
        m->first += m->count;
        m->count = qtri_rows_next(&m->rows, m->triangle.spans);
    }
    return m->triangle.spans[row - m->first];
}

/* ---- All of it ---- */

typedef struct work {
    const qtri_raster *raster;
    const qtri_triangle *triangle; /* where it is; whether a band has its centres does not count */
    const qtri_attributes *v;
    qtri_raster shade; /* into `word` */
    qtri_surface row;
    qtri_format format;
    qtri_depth depth;
    moved at[PLACES];
    qtri_span span[PLACES]; /* of the row */
    int32_t y, x, count;    /* a chunk of it, of up to QTRI_BATCH pixels */
    uint32_t cover[PLACES]; /* of the chunk */
    uint32_t pass[QTRI_SAMPLES];
    uint8_t *record;                /* of the chunk's first pixel */
    uint16_t *depths[QTRI_SAMPLES]; /* and where its samples keep theirs */
    uint32_t z[QTRI_SAMPLES];
    ptrdiff_t steps[QTRI_SAMPLES];
    uint32_t word[QTRI_BATCH];
} work;

/* What fills rows of words by the stages of the raster. */
static void set_shade(work *w)
{
    const qtri_raster *raster = w->raster;
    w->row = *raster->surface;
    w->row.depth = NULL;
    w->row.pitch = 0;
    w->format.pixels = &words;
    w->format.colors = raster->format->colors;
    w->format.encode = raster->format->encode;
    w->format.decode = raster->format->decode;
    w->format.fused = NULL;
    w->row.format = &w->format;
    w->shade = *raster;
    w->shade.surface = &w->row;
    w->shade.format = &w->format;
    w->shade.samples = NULL;
    w->shade.route = NULL;
    w->shade.compare = QTRI_DEPTH_OFF;
    w->shade.depth_write = false;
    w->shade.with_depth = raster->with_depth;
    w->shade.depth = qtri_depth_stages(QTRI_DEPTH_OFF, false, true);
    w->shade.fill_flat = raster->by_pixel          ? raster->fill_flat
                         : raster->effects != NULL ? raster->effects->fill
                                                   : qtri_span_flat;
    w->shade.fill_smooth = raster->varying != NULL ? raster->varying->fill : w->shade.fill_flat;
    w->shade.copy_run = NULL;
    w->shade.copy_bent = NULL;
    w->depth = qtri_depth_stages(raster->compare, raster->depth_write, true);
}

/*
 * Whether depth changes by less than 2^31 from pixel to pixel, so that its ramp did not wrap: of no
 * sliver (gradient.h: |area| >= 32 extents, where both differences are at most an extent) it is at
 * most 16 times the range of the vertices.
 */
static bool is_gentle(const work *w, const qtri_triangle *t)
{
    const uint32_t half = (uint32_t)1 << 25;
    const uint32_t first = w->v[0].depth_16p16;
    const int64_t size = t->area < 0 ? -t->area : t->area;
    return size >= (int64_t)t->extent * 32 && w->v[1].depth_16p16 - first + half < 2 * half &&
           w->v[2].depth_16p16 - first + half < 2 * half;
}

/* The job of a place. */
static void make_ready(work *w, int place)
{
    moved *m = &w->at[place];
    if (!m->ready) {
        m->fill =
            qtri_job_init(&m->job, &w->shade, place == CENTER ? w->triangle : &m->triangle, w->v);
        m->ready = true;
    }
}

/* The depths of samples: the centre's, moved, or each by itself, without colours. */
static void set_depths(work *w)
{
    const bool is_whole = is_gentle(w, w->triangle);
    qtri_raster plain = w->shade;
    qtri_job job;
    if (is_whole) {
        make_ready(w, CENTER);
    } else {
        plain.texture = NULL;
        plain.units = plain.format->colors;
        plain.effects = NULL;
        plain.fog = NULL;
        plain.varying = NULL;
    }
    for (int k = 0; k < QTRI_SAMPLES; k++) {
        moved *m = &w->at[k];
        const qtri_job *from = is_whole ? &w->at[CENTER].job : &job;
        if (!m->any) {
            continue;
        }
        if (!is_whole) {
            (void)qtri_job_init(&job, &plain, &m->triangle, w->v);
        }
        m->depth = from->depth;
        m->anchor_x = from->anchor_x;
        m->anchor_y = from->anchor_y;
        if (is_whole) {
            m->depth.origin += qtri_gradient_along((int32_t)m->depth.dx, qtri_sample_offset[k][0],
                                                   (int32_t)m->depth.dy, qtri_sample_offset[k][1]);
        }
    }
}

/* Which pixels of the chunk lie in a span. */
static uint32_t mask_in(const work *w, const qtri_span *span)
{
    const int32_t first = qtri_greatest32(span->left - w->x, 0);
    const int32_t end = qtri_least32(span->right - w->x, w->count);
    return first >= end ? 0 : qtri_mask_of(end - first) << (w->count - end);
}

/* Where the samples of the chunk's pixels are, and their depths at the first. */
static void find_samples(work *w)
{
    const qtri_surface *surface = w->raster->surface;
    const int32_t size = surface->format->pixels->bytes;
    const int32_t bytes = w->raster->samples->format->pixels->bytes;
    w->record = qtri_pixels_at(surface, w->y) + (ptrdiff_t)w->x * size;
    for (int k = 0; k < QTRI_SAMPLES; k++) {
        const moved *m = &w->at[k];
        w->depths[k] = NULL;
        w->steps[k] = 0;
        w->z[k] = 0;
        if (w->raster->compare == QTRI_DEPTH_OFF || !m->any) {
            continue;
        }
        w->depths[k] =
            k == 0 ? qtri_depths_at(surface, w->y) + w->x : qtri_sample_depth(w->record, bytes, k);
        w->steps[k] = k == 0 ? 1 : size / 2;
        w->z[k] = qtri_ramp_at(&m->depth, w->x - m->anchor_x, w->y - m->anchor_y);
    }
}

/* Which of the covered samples pass. */
static uint32_t test(const work *w, int k)
{
    uint16_t stored[QTRI_BATCH];
    if (w->depth.test == NULL || w->cover[k] == 0) {
        return w->cover[k];
    }
    const uint16_t *depth = w->depths[k];
    for (int32_t i = 0; i < w->count; i++, depth += w->steps[k]) {
        stored[i] = *depth;
    }
    const uint32_t passed = w->depth.test(stored, w->z[k], w->at[k].depth.dx, w->count);
    return (passed ^ (w->depth.inverted ? UINT32_MAX : 0)) & w->cover[k];
}

/* Colours of these pixels into words, at one place; run by run. */
static void shade_at(work *w, int place, uint32_t mask)
{
    moved *m = &w->at[place];
    if (mask == 0) {
        return;
    }
    make_ready(w, place);
    mask <<= 32 - w->count; /* the first pixel's bit is the mask's sign */
    for (int32_t i = w->x; mask != 0;) {
        const int32_t zeros = qtri_clz32(mask);
        const int32_t ones = ~(mask << zeros) == 0 ? 32 : qtri_clz32(~(mask << zeros));
        w->shade.bounds.x0 = i + zeros;
        w->shade.bounds.x1 = i + zeros + ones;
        m->fill(&m->job, &w->span[place], w->y, 1);
        i += zeros + ones;
        mask = zeros + ones < 32 ? mask << (zeros + ones) : 0;
    }
}

/* Each at the centre, or at the first sample that is covered. */
static void shade(work *w, uint32_t mask)
{
    /* An integer, as no pointer may lead out of an array: the row's column 0. */
    w->row.pixels = (uint8_t *)((uintptr_t)w->word - 4 * (uintptr_t)w->x); /* NOLINT */
    shade_at(w, CENTER, mask & w->cover[CENTER]);
    mask &= ~w->cover[CENTER];
    for (int k = 0; k < QTRI_SAMPLES && mask != 0; k++) {
        shade_at(w, k, mask & w->cover[k]);
        mask &= ~w->cover[k];
    }
}

/* Which of the words were drawn. */
static uint32_t drawn(const work *w)
{
    uint32_t mask = 0;
    for (int32_t i = 0; i < w->count; i++) {
        mask = mask << 1 | w->word[i] >> 31;
    }
    return mask;
}

/* Words and depths to sample k of these pixels. */
QTRI_INLINE void put_of(const work *w, int k, uint32_t mask, int32_t bytes, int32_t size)
{
    const bool writes = w->raster->depth_write;
    const uint32_t dz = w->at[k].depth.dx;
    const ptrdiff_t step = w->steps[k];
    const uint32_t *word = w->word;
    uint8_t *record = w->record;
    uint16_t *depth = w->depths[k];
    uint32_t z = w->z[k];
    /* The first pixel's bit is the mask's sign. */
    mask <<= 32 - w->count;
    for (ptrdiff_t i = 0; mask != 0; mask <<= 1, word++, record += size, z += dz, i += step) {
        if ((int32_t)mask < 0) {
            qtri_sample_set_color(record, bytes, k, *word & ~DRAWN);
            if (writes) {
                depth[i] = (uint16_t)(z >> 16);
            }
        }
    }
}

static void put(const work *w, int k, uint32_t mask)
{
    const int32_t size = w->raster->format->pixels->bytes;
    if (size == QTRI_RGB565_X4_BYTES) {
        put_of(w, k, mask, QTRI_RGB565_BYTES, QTRI_RGB565_X4_BYTES);
    } else {
        put_of(w, k, mask, qtri_sample_bytes(size), size);
    }
}

/* Stored colours of sample k, for what blends with them. */
static void set_words(work *w, int k)
{
    const int32_t size = w->raster->format->pixels->bytes;
    const uint8_t *record = w->record;
    for (int32_t i = 0; i < w->count; i++, record += size) {
        w->word[i] = qtri_sample_color(record, qtri_sample_bytes(size), k);
    }
}

static void draw_chunk(work *w)
{
    uint32_t any = 0;
    for (int k = 0; k < PLACES; k++) {
        w->cover[k] = mask_in(w, &w->span[k]);
    }
    find_samples(w);
    for (int k = 0; k < QTRI_SAMPLES; k++) {
        w->pass[k] = test(w, k);
        any |= w->pass[k];
    }
    if (any == 0) {
        return;
    }
    if (w->raster->blend != NULL) {
        for (int k = 0; k < QTRI_SAMPLES; k++) {
            if (w->pass[k] != 0) {
                set_words(w, k);
                shade(w, w->pass[k]);
                put(w, k, w->pass[k] & drawn(w));
            }
        }
        return;
    }
    for (int32_t i = 0; i < w->count; i++) {
        w->word[i] = 0;
    }
    shade(w, any);
    any = drawn(w);
    for (int k = 0; k < QTRI_SAMPLES; k++) {
        if ((w->pass[k] & any) != 0) {
            put(w, k, w->pass[k] & any);
        }
    }
}

static void draw_row(work *w, const qtri_rect *bounds)
{
    int32_t left = bounds->x1;
    int32_t right = bounds->x0;
    for (int k = 0; k < PLACES; k++) {
        w->span[k] = span_in(&w->at[k], w->y);
        if (w->span[k].left < w->span[k].right) {
            left = qtri_least32(left, w->span[k].left);
            right = qtri_greatest32(right, w->span[k].right);
        }
    }
    left = qtri_greatest32(left, bounds->x0);
    right = qtri_least32(right, bounds->x1);
    for (w->x = left; w->x < right; w->x += QTRI_BATCH) {
        w->count = qtri_least32(QTRI_BATCH, right - w->x);
        draw_chunk(w);
    }
}

QTRI_NOINLINE void qtri_samples_draw(const qtri_raster *raster, qtri_triangle *triangle,
                                     const qtri_attributes v[3])
{
    work w;
    int32_t row = INT32_MAX;
    int32_t end = INT32_MIN;
    qtri_list_flush(raster); /* small ones that came before */
    w.raster = raster;
    w.triangle = triangle;
    w.v = v;
    set_shade(&w);
    for (int k = 0; k < PLACES; k++) {
        move(&w.at[k], &w.shade, triangle, k);
        if (w.at[k].any && k != CENTER) {
            row = qtri_least32(row, w.at[k].triangle.row);
            end = qtri_greatest32(end, w.at[k].triangle.end);
        }
    }
    if (row >= end) {
        return;
    }
    if (raster->compare != QTRI_DEPTH_OFF) {
        set_depths(&w);
    }
    for (w.y = row; w.y < end; w.y++) {
        draw_row(&w, &raster->bounds);
    }
}
