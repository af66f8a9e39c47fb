/* SPDX-License-Identifier: MIT */
#include "stroke.h"

#include "../frame/colors.h"
#include "../frame/depth_format.h"
#include "../frame/pixel.h"
#include "effect.h"
#include "loop.h"
#include "stroke_pixel.h"

bool qtri_stroker_init(qtri_stroker *stroker, const qtri_surface *surface,
                       const qtri_material *material, const qtri_stroke *stroke)
{
    const qtri_compare compare = qtri_compare_of(material);
    stroker->surface = surface;
    stroker->bounds = qtri_surface_bounds(surface);
    stroker->compare = surface->depth == NULL ? QTRI_DEPTH_OFF : compare;
    stroker->depth_write = stroker->compare != QTRI_DEPTH_OFF && !material->depth_read_only;
    stroker->passing = (uint8_t)(qtri_orders_of(compare) & 7);
    stroker->alpha = stroke->alpha;
    stroker->edges = stroke->edges;
    stroker->material = material;
    stroker->effects = qtri_effect_stages_of(material);
    return stroker->bounds.x0 < stroker->bounds.x1 && stroke->alpha != 0 && compare != QTRI_NEVER;
}

/* What a pixel takes of its part. */
typedef struct sample {
    uint32_t depth_16p8;   /* 0..65535.0 */
    int32_t color_8p16[3]; /* 0..255.0 */
} sample;

/* Where along the parts pixels of a window are. */
typedef struct position {
    uint64_t square; /* of the distance in 24.8 */
    uint32_t share_q16;
    uint32_t part; /* UINT32_MAX: none yet */
} position;

/* From a pixel's centre to the part; |along|, |across| < 2^25, far away taken as 2^22. */
static uint64_t square_of(int32_t beyond, int32_t across)
{
    const int32_t most = (int32_t)1 << 22;
    const int32_t x = qtri_hold32(beyond, -most, most);
    const int32_t y = qtri_hold32(across, -most, most);
    return (uint64_t)qtri_mul_s32(x, x) + (uint64_t)qtri_mul_s32(y, y);
}

/* Of the pixels first .. end-1 of the window, from `at` on: taken where the shape is nearer than
   others. */
static void take_positions(position *at, const qtri_stroker *stroker,
                           const qtri_stroke_shape *shape, int32_t first, int32_t end,
                           bool is_alone)
{
    const int32_t x = (stroker->column + first) * 256 + 128 - shape->origin.x_24p8;
    const int32_t y = stroker->row * 256 + 128 - shape->origin.y_24p8;
    qtri_stroke_walk walk = qtri_stroke_walk_from(shape, x, y);
    if (is_alone) {
        for (int32_t i = first; i < end; i++, at++) {
            at->part = shape->part;
            at->share_q16 = shape->level ? 0 : qtri_stroke_walk_next(&walk);
        }
        return;
    }
    int64_t across_q30 = qtri_mul_s32(y, shape->along_x_q30) - qtri_mul_s32(x, shape->along_y_q30);
    const int64_t step_across = (int64_t)shape->along_y_q30 * -256;
    for (int32_t i = first; i < end; i++, at++) {
        const int64_t held_q30 = qtri_stroke_walk_held(&walk);
        const uint64_t square =
            square_of((int32_t)((walk.along_q30 - held_q30) >> 30), (int32_t)(across_q30 >> 30));
        // NOLINTNEXTLINE(clang-analyzer-core.*): take_all_positions() has set all of the clip
        if (at->part == UINT32_MAX || square < at->square) {
            at->square = square;
            at->share_q16 = qtri_stroke_walk_share(&walk, held_q30);
            at->part = shape->part;
        }
        walk.along_q30 += walk.step_q30;
        across_q30 += step_across;
    }
}

/* The part of the window inside the bounds, from its first pixel on. */
typedef struct clip {
    int32_t first, end;
} clip;

/* Of all groups, for the pixels of a clip: at[0] is the first. */
static void take_all_positions(position *at, qtri_stroker *stroker, const clip *in)
{
    const bool many = stroker->touch_count == QTRI_STROKE_MANY;
    const uint32_t count = many ? 1 : stroker->touch_count;
    for (int32_t i = in->first; i < in->end; i++) {
        at[i - in->first].part = UINT32_MAX;
    }
    for (uint32_t from = 0; from < count; from = stroker->touch_end) {
        uint32_t listed = 0;
        qtri_stroker_set_group(stroker, from);
        const bool is_alone = !many && stroker->touch_end - from == 1;
        for (const qtri_stroke_shape *s; (s = qtri_stroker_next(stroker, &listed)) != NULL;) {
            int32_t first;
            int32_t end;
            (void)qtri_stroke_shape_columns(s, stroker->row, &first, &end);
            first = qtri_greatest32(first - stroker->column, in->first);
            end = qtri_least32(end - stroker->column, in->end);
            if (first < end) {
                take_positions(&at[first - in->first], stroker, s, first, end, is_alone);
            }
        }
    }
}

static void take_sample(sample *out, const qtri_stroke_shape *shape, uint32_t share_q16)
{
    const int32_t *from = shape->end[0].color_8p16;
    const int32_t *to = shape->end[1].color_8p16;
    out->depth_16p8 = qtri_stroke_depth(shape, share_q16);
    for (int i = 0; i < 3; i++) {
        out->color_8p16[i] = shape->even ? from[i] : qtri_stroke_mixed(from[i], to[i], share_q16);
    }
}

/* Less than a half of 1/256 is nothing. */
#define LEAST (QTRI_STROKE_FULL / 512)

/* Depths, colours and stores of the pixels that are covered. */
QTRI_NOINLINE static void draw_covered(qtri_stroker *stroker, const clip *in)
{
    const qtri_surface *surface = stroker->surface;
    const qtri_format *format = surface->format;
    const ptrdiff_t row = stroker->row - surface->first_row;
    uint8_t *pixel = surface->pixels + row * surface->pitch +
                     (ptrdiff_t)format->pixels->bytes * (stroker->column + in->first);
    uint8_t *first_pixel = pixel;
    const qtri_depth_testing *testing =
        stroker->compare != QTRI_DEPTH_OFF ? qtri_depth_testing_of(surface) : NULL;
    uint16_t *depth = stroker->compare != QTRI_DEPTH_OFF && testing == NULL
                          ? surface->depth + row * surface->depth_pitch + stroker->column
                          : NULL;
    position at[QTRI_STROKE_WINDOW];
    uint32_t word[QTRI_STROKE_WINDOW + 4];
    uint32_t mask = 0;
    const qtri_stroke_shape *shape = &stroker->shape[0];
    uint32_t even = 0;               /* what is stored of a part of one colour, */
    uint32_t even_part = UINT32_MAX; /* and which */
    take_all_positions(at, stroker, in);
    for (int32_t i = in->first; i < in->end; i++, pixel += format->pixels->bytes) {
        const int32_t cover = stroker->cover[i];
        const position *p = &at[i - in->first];
        uint32_t *w = &word[i - in->first];
        mask <<= 1;
        *w = 0;
        if (cover < LEAST || p->part == UINT32_MAX) {
            continue;
        }
        shape = shape->part == p->part ? shape : qtri_stroker_shape(stroker, p->part);
        const uint32_t depth_16p8 = qtri_stroke_depth(shape, p->share_q16);
        const bool writes = stroker->depth_write && cover >= QTRI_STROKE_FULL / 2;
        if (depth != NULL) {
            const uint32_t z = (depth_16p8 + 128) >> 8;
            if (qtri_stroke_passes(stroker->passing, z, depth[i]) == 0) {
                continue;
            }
            if (writes) {
                depth[i] = (uint16_t)z;
            }
        } else if (testing != NULL &&
                   !testing->passes(surface, stroker->compare,
                                    (uint32_t)row << 16 | (uint32_t)(stroker->column + i),
                                    depth_16p8 << 8, writes)) {
            continue;
        }
        const int32_t share = qtri_stroke_share(stroker, cover);
        if (shape->even && share == 65536) {
            if (even_part != shape->part) {
                even = qtri_stroke_word(format, shape->end[0].color_8p16, pixel, 65536);
                even_part = shape->part;
            }
            *w = even;
        } else {
            sample s;
            take_sample(&s, shape, p->share_q16);
            *w = qtri_stroke_word(format, s.color_8p16, pixel, share);
        }
        mask |= 1;
    }
    const int32_t count = in->end - in->first;
    if (mask != 0) {
        if (format->encode != NULL) {
            word[count] = word[count + 1] = word[count + 2] = 0; /* which it may encode as well */
            format->encode(word, count);
        }
        format->pixels->store(first_pixel, word, mask, count);
    }
}

/* So many pixels at a time, to take less stack. */
enum { AFFECTED = QTRI_STROKE_WINDOW / 2 };

static bool passes_at(const qtri_stroker *stroker, const sample *s, int32_t x)
{
    const qtri_surface *surface = stroker->surface;
    const qtri_depth_testing *testing = qtri_depth_testing_of(surface);
    if (stroker->compare == QTRI_DEPTH_OFF) {
        return true;
    }
    if (testing == NULL) {
        return qtri_stroke_passes(stroker->passing, (s->depth_16p8 + 128) >> 8,
                                  qtri_depths_at(surface, stroker->row)[x]) != 0;
    }
    const uint32_t row = (uint32_t)(stroker->row - surface->first_row);
    return testing->passes(surface, stroker->compare, row << 16 | (uint32_t)x, s->depth_16p8 << 8,
                           false);
}

/* What passes of the clip, as what fog and blends ask for; bit 0 of a depth that is written. */
QTRI_NOINLINE static void take_covered(qtri_covered *pixels, qtri_stroker *stroker, const clip *in)
{
    const qtri_surface *surface = stroker->surface;
    const uint32_t row = (uint32_t)(stroker->row - surface->first_row);
    position at[AFFECTED];
    take_all_positions(at, stroker, in);
    for (int32_t i = in->first; i < in->end; i++) {
        const int32_t cover = stroker->cover[i];
        const int32_t x = stroker->column + i;
        if (cover < LEAST || at[i - in->first].part == UINT32_MAX) {
            continue;
        }
        sample s;
        take_sample(&s, qtri_stroker_shape(stroker, at[i - in->first].part),
                    at[i - in->first].share_q16);
        if (!passes_at(stroker, &s, x)) {
            continue;
        }
        const bool writes = stroker->depth_write && cover >= QTRI_STROKE_FULL / 2;
        const int32_t n = pixels->count++;
        pixels->color[n] = qtri_pack_888(s.color_8p16);
        pixels->place[n] = (row << 16) + (uint32_t)x;
        pixels->depth[n] = (s.depth_16p8 + 128) << 8 | writes;
        pixels->share_q16[n] = qtri_stroke_share(stroker, cover); /* n <= i */
    }
}

/* Pixels that are covered, with fog and a blend. */
QTRI_NOINLINE static void draw_affected(qtri_stroker *stroker, const clip *in)
{
    uint32_t color[AFFECTED + QTRI_BATCH_ROOM - QTRI_BATCH];
    uint32_t place[AFFECTED];
    uint32_t depth[AFFECTED];
    qtri_covered pixels = {0, color, place, depth, stroker->cover};
    take_covered(&pixels, stroker, in);
    if (pixels.count != 0) {
        stroker->effects->covered(stroker->surface, stroker->material, &pixels);
    }
}

static void cover_between(qtri_stroker *stroker, const qtri_stroke_slice *slice)
{
    const int32_t first = ((slice->left[0] + 127) >> 8) - stroker->column;
    const int32_t end = ((slice->right[0] + 127) >> 8) - stroker->column;
    for (int32_t i = qtri_greatest32(first, 0); i < qtri_least32(end, QTRI_STROKE_WINDOW); i++) {
        stroker->cover[i] = QTRI_STROKE_FULL;
    }
}

/* Those whose centres lie inside. */
static void add_hard(qtri_stroker *stroker)
{
    const int32_t y = stroker->row * 256 + 128;
    uint32_t listed = 0;
    for (qtri_stroke_shape *s; (s = qtri_stroker_next(stroker, &listed)) != NULL;) {
        qtri_stroke_slice slice;
        /* Down to the next level, so that a side which ends here does not count. */
        if (qtri_stroke_shape_slice(s, y, y + 1, &slice)) {
            cover_between(stroker, &slice);
        }
        if (s->disc_apart != 0 && qtri_stroke_shape_disc(s, y, y + 1, &slice)) {
            cover_between(stroker, &slice);
        }
    }
}

/* The columns of the strip that the row's parts touch. */
static void set_columns(qtri_stroker *stroker)
{
    int32_t first = stroker->column;
    int32_t end = stroker->column + QTRI_STROKE_WINDOW;
    if (stroker->touch_count != QTRI_STROKE_MANY) {
        first = stroker->touch[0].first;
        end = stroker->touch[0].end;
        for (uint32_t i = 1; i < stroker->touch_count; i++) {
            end = qtri_greatest32(end, stroker->touch[i].end);
        }
    }
    stroker->first = (uint8_t)qtri_greatest32(first - stroker->column, 0);
    stroker->end = (uint8_t)qtri_least32(end - stroker->column, QTRI_STROKE_WINDOW);
}

/* And inside the bounds; empty: none. */
static clip clip_of(const qtri_stroker *stroker)
{
    const clip in = {qtri_greatest32(stroker->first, stroker->bounds.x0 - stroker->column),
                     qtri_least32(stroker->end, stroker->bounds.x1 - stroker->column)};
    return in;
}

/* A row that one convex part alone touches, without what it takes to unite several. */
static void draw_alone(qtri_stroker *stroker, const clip *in)
{
    qtri_stroke_slice slice;
    qtri_stroke_shape *s = qtri_stroker_shape(stroker, stroker->touch[0].part);
    if (qtri_stroke_shape_slice(s, stroker->row * 256 + 128, stroker->row * 256 + 129, &slice)) {
        const int32_t first =
            qtri_greatest32((slice.left[0] + 127) >> 8, stroker->column + in->first);
        const int32_t end = qtri_least32((slice.right[0] + 127) >> 8, stroker->column + in->end);
        if (first < end) {
            qtri_stroke_run(stroker, s, first, end);
        }
    }
}

/* The least run of pixels that are covered wholly for which it is worth to draw them apart. */
enum { RUN = 4 };

/* Smooth edges of one part, and between them what it covers wholly. */
static void draw_between(qtri_stroker *stroker, const clip *in)
{
    clip whole = {in->first, in->first};
    while (whole.first < in->end && stroker->cover[whole.first] != QTRI_STROKE_FULL) {
        whole.first++;
    }
    whole.end = whole.first;
    while (whole.end < in->end && stroker->cover[whole.end] == QTRI_STROKE_FULL) {
        whole.end++;
    }
    if (whole.end - whole.first < RUN) {
        draw_covered(stroker, in);
        return;
    }
    const clip before = {in->first, whole.first};
    const clip behind = {whole.end, in->end};
    if (before.first < before.end) {
        draw_covered(stroker, &before);
    }
    qtri_stroke_run(stroker, qtri_stroker_shape(stroker, stroker->touch[0].part),
                    stroker->column + whole.first, stroker->column + whole.end);
    if (behind.first < behind.end) {
        draw_covered(stroker, &behind);
    }
}

static void draw_row(qtri_stroker *stroker)
{
    if (!qtri_stroker_find_touches(stroker)) {
        return;
    }
    set_columns(stroker);
    const clip in = clip_of(stroker);
    if (in.first >= in.end) {
        return;
    }
    if (stroker->touch_count == 1 && stroker->edges == NULL && stroker->effects == NULL &&
        qtri_stroker_shape(stroker, stroker->touch[0].part)->disc_apart == 0) {
        draw_alone(stroker, &in);
        return;
    }
    for (int32_t i = stroker->first; i <= stroker->end; i++) {
        stroker->cover[i] = 0;
    }
    const uint32_t count = stroker->touch_count == QTRI_STROKE_MANY ? 1 : stroker->touch_count;
    for (uint32_t from = 0; from < count; from = stroker->touch_end) {
        qtri_stroker_set_group(stroker, from);
        if (stroker->edges != NULL) {
            stroker->edges->add(stroker);
        } else {
            add_hard(stroker);
        }
    }
    if (stroker->edges != NULL) {
        stroker->edges->finish(stroker);
    }
    if (stroker->effects != NULL) {
        for (clip some = in; some.first < in.end; some.first = some.end) {
            some.end = qtri_least32(some.first + AFFECTED, in.end);
            draw_affected(stroker, &some);
        }
    } else if (stroker->touch_count == 1) {
        draw_between(stroker, &in);
    } else {
        draw_covered(stroker, &in);
    }
}

void qtri_stroker_draw(qtri_stroker *stroker, const qtri_stroke_source *source)
{
    int32_t columns[2];
    qtri_stroker_begin(stroker, source, columns);
    stroker->column = columns[0] & ~(QTRI_STROKE_WINDOW - 1);
    for (; stroker->column < columns[1]; stroker->column += QTRI_STROKE_WINDOW) {
        int32_t rows[2];
        qtri_stroker_find_parts(stroker, rows);
        for (stroker->row = rows[0]; stroker->row < rows[1]; stroker->row++) {
            draw_row(stroker);
        }
    }
}
