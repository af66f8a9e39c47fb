/* SPDX-License-Identifier: MIT */
#include "scene_draw.h"

#include <stdlib.h>

/* Frames of a picture that is a mean, and rows of halo that techniques need. */
enum { FRAMES_LOG2 = 4, EDGES_HALO = 1 };

/* What a pass takes beside the scene. */
struct target {
    struct scene_resources *resources;
    const qtri_format *format;
    const qtri_depth_format *depth;
    enum scene_pass pass;
    struct picture *picture;
    void *memory; /* of the largest band */
    size_t bytes;
    uint32_t *words; /* for filters */
    uint32_t word_count;
};

/* Depth 0..1. */
static double depth_at(const qtri_surface *surface, int32_t x, int32_t y)
{
    const qtri_depth_format *format = surface->depth_format;
    const int bytes = format->bytes;
    const uint8_t *at = (const uint8_t *)surface->depth +
                        bytes * ((y - surface->first_row) * surface->depth_pitch + x);
    uint32_t depth;
    if (bytes == 2) {
        depth = *(const uint16_t *)(const void *)at;
    } else if (bytes == 3) {
        depth = at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16;
    } else {
        depth = *(const uint32_t *)(const void *)at;
    }
    format->decode(&depth, 1);
    return depth / (65535 * 65536.0);
}

/* Copies rows first..end - 1 of a surface to the picture. */
static void keep_rows(const struct target *t, const qtri_surface *surface, int32_t first,
                      int32_t end)
{
    struct picture *picture = t->picture;
    for (int32_t y = first; y < end; y++) {
        for (int32_t x = 0; x < picture->width; x++) {
            size_t at = (size_t)y * (size_t)picture->width + (size_t)x;
            qtri_rgb rgb = qtri_surface_pixel(surface, x, y);
            if (t->pass == SCENE_IDS) {
                picture->id[at] = (uint32_t)rgb.r << 16 | (uint32_t)rgb.g << 8 | rgb.b;
                picture->depth[at] = depth_at(surface, x, y);
            } else {
                picture->rgb[3 * at] = rgb.r;
                picture->rgb[3 * at + 1] = rgb.g;
                picture->rgb[3 * at + 2] = rgb.b;
            }
        }
    }
}

/* Rows of a frame `scale` times as large. */
static void begin_rows(const struct target *t, qtri_surface *surface, int32_t scale, int32_t first,
                       int32_t end)
{
    if (qtri_surface_init(surface, t->format, scale * t->picture->width, scale * t->picture->height,
                          scale * first, scale * (end - first), t->memory, t->bytes) != QTRI_OK ||
        qtri_surface_set_depth(surface, t->depth, t->bytes) != QTRI_OK) {
        abort(); /* the scene reader keeps sizes within the core's range */
    }
}

static void set_jitter(struct scene_resources *resources, uint32_t place, int32_t places_log2)
{
    for (; resources != NULL; resources = resources->next) {
        resources->jitter = place;
        resources->jitter_log2 = places_log2;
    }
}

/* The mean of several frames. */
static void draw_mean(const struct target *t, const qtri_surface *surface)
{
    struct scene_resources *resources = t->resources;
    qtri_sum_clear(t->words, t->word_count);
    for (uint32_t i = 0; i < 1u << FRAMES_LOG2; i++) {
        set_jitter(resources, i, FRAMES_LOG2);
        scene_draw(resources, surface, SCENE_COLORS);
        (void)qtri_sum_add(t->words, t->word_count, surface);
    }
    set_jitter(resources, 0, 0);
    (void)qtri_sum_store(surface, t->words, t->word_count, FRAMES_LOG2);
}

static int32_t halo_of(enum scene_antialias antialias)
{
    return antialias == SCENE_ANTIALIAS_EDGES  ? EDGES_HALO
           : antialias == SCENE_ANTIALIAS_FXAA ? QTRI_FXAA_OVERLAP
                                               : 0;
}

static enum scene_antialias antialias_of(const struct target *t)
{
    return t->pass == SCENE_COLORS ? t->resources->scene->antialias : SCENE_ANTIALIAS_OFF;
}

const qtri_format *scene_sampled_format(const qtri_format *format)
{
    static const qtri_format *const formats[][2] = {
        {&qtri_rgb565, &qtri_rgb565_x4}, {&qtri_rgb565_swapped, &qtri_rgb565_swapped_x4},
        {&qtri_rgb888, &qtri_rgb888_x4}, {&qtri_xrgb8888, &qtri_xrgb8888_x4},
        {&qtri_gray8, &qtri_gray8_x4},
    };
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++) {
        if (formats[i][0] == format) {
            return formats[i][1];
        }
    }
    return format;
}

/* Draws rows first..end - 1 and copies them to the picture. */
static void render_band(const struct target *t, int32_t first, int32_t end)
{
    const enum scene_antialias antialias = antialias_of(t);
    const int32_t halo = halo_of(antialias);
    const int32_t last = end + halo < t->picture->height ? end + halo : t->picture->height;
    qtri_surface surface;
    begin_rows(t, &surface, antialias == SCENE_ANTIALIAS_SSAA ? 2 : 1,
               first > halo ? first - halo : 0, last);
    if (antialias == SCENE_ANTIALIAS_TEMPORAL) {
        draw_mean(t, &surface);
    } else {
        scene_draw(t->resources, &surface, t->pass);
    }
    if (antialias == SCENE_ANTIALIAS_EDGES) {
        scene_draw(t->resources, &surface, SCENE_EDGES);
    } else if (antialias == SCENE_ANTIALIAS_FXAA) {
        (void)qtri_fxaa(&surface, t->words, t->word_count);
    } else if (antialias == SCENE_ANTIALIAS_MSAA) {
        (void)qtri_samples_resolve(&surface, &surface);
    } else if (antialias == SCENE_ANTIALIAS_SSAA) {
        (void)qtri_halve(&surface, &surface);
    }
    keep_rows(t, &surface, first, end);
}

/* Samples keep linear16. */
static const qtri_depth_format *depth_of(const struct target *t)
{
    static const qtri_depth_format *const formats[] = {
        [SCENE_LINEAR16] = &qtri_depth_linear16,
        [SCENE_FLOAT16] = &qtri_depth_float16,
        [SCENE_LINEAR24] = &qtri_depth_linear24,
        [SCENE_LINEAR32] = &qtri_depth_linear32,
    };
    const bool has_samples = antialias_of(t) == SCENE_ANTIALIAS_MSAA;
    return has_samples ? &qtri_depth_linear16 : formats[t->resources->scene->depth_format];
}

static bool render_pass(struct scene_resources *resources, const qtri_format *format, int32_t rows,
                        enum scene_pass pass, struct picture *picture)
{
    struct target t = {.resources = resources, .format = format, .pass = pass, .picture = picture};
    const int32_t scale = antialias_of(&t) == SCENE_ANTIALIAS_SSAA ? 2 : 1;
    if (antialias_of(&t) == SCENE_ANTIALIAS_MSAA) {
        t.format = format = scene_sampled_format(format);
    }
    const int32_t held = rows + 2 * halo_of(antialias_of(&t));
    t.depth = depth_of(&t);
    t.bytes = QTRI_BAND_BYTES_DEPTH(scale * picture->width, scale * held, format->pixels->bytes,
                                    t.depth->bytes);
    t.memory = malloc(t.bytes);
    t.word_count = QTRI_SUM_WORDS(picture->width, held) + QTRI_FXAA_WORDS(picture->width);
    t.words = malloc(t.word_count * sizeof *t.words);
    const bool ok = t.memory != NULL && t.words != NULL;
    for (int32_t first = 0; ok && first < picture->height; first += rows) {
        render_band(&t, first, first + rows < picture->height ? first + rows : picture->height);
    }
    free(t.memory);
    free(t.words);
    return ok;
}

bool scene_render_resources(struct scene_resources *resources, const qtri_format *format,
                            int32_t rows, bool with_dump, struct picture *picture)
{
    const struct scene *scene = resources->scene;
    if (!picture_create(picture, scene->width, scene->height, with_dump)) {
        return false;
    }
    rows = rows < 1 || rows > scene->height ? scene->height : rows;
    const bool ok =
        render_pass(resources, format, rows, SCENE_COLORS, picture) &&
        (!with_dump || render_pass(resources, &qtri_xrgb8888, rows, SCENE_IDS, picture));
    if (!ok) {
        picture_free(picture);
    }
    return ok;
}

static bool render_scene(const struct scene *scene, const qtri_format *format, int32_t rows,
                         bool with_dump, const struct scene_pipelines *pipelines,
                         struct picture *picture)
{
    struct scene_resources resources;
    scene_resources_create(&resources, scene);
    for (struct scene_resources *pass = &resources; pass != NULL; pass = pass->next) {
        pass->pipelines = pipelines;
    }
    const bool ok = scene_render_resources(&resources, format, rows, with_dump, picture);
    scene_resources_free(&resources);
    return ok;
}

bool scene_render(const struct scene *scene, const qtri_format *format, int32_t rows,
                  bool with_dump, struct picture *picture)
{
    return render_scene(scene, format, rows, with_dump, NULL, picture);
}

bool scene_render_by(const struct scene *scene, const qtri_format *format,
                     const struct scene_pipelines *pipelines, struct picture *picture)
{
    return render_scene(scene, format, 0, false, pipelines, picture);
}
