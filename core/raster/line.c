/* SPDX-License-Identifier: MIT */
#include "line.h"

#include "checked_material.h"
#include "dda.h"
#include "line_path.h"

#include "../frame/depth_format.h"
#include "../frame/pixel.h"

/* Pixels begin..end - 1 of a path are inside along the major axis, these on the minor one. */
typedef struct limits {
    int32_t begin, end;
    int32_t minor;
    uint32_t minor_count;
} limits;

static void limits_init(limits *in, const qtri_line_job *job, const qtri_line_path *l)
{
    const int32_t left = job->left_24p8 >> 8;
    const int32_t top = job->top_24p8 >> 8;
    const int32_t width = (int32_t)(job->width_24p8 >> 8);
    const int32_t height = (int32_t)(job->height_24p8 >> 8);
    in->begin = (l->steep ? top : left) - l->position;
    in->end = in->begin + (l->steep ? height : width);
    in->minor = l->steep ? left : top;
    in->minor_count = (uint32_t)(l->steep ? width : height);
}

/* Moves w to the first pixel inside; returns the end of those that are, at most `end`. */
static int32_t walk_cut(qtri_line_walk *w, const limits *in, int32_t end)
{
    end = qtri_least32(end, in->end);
    while (w->k < end &&
           (w->k < in->begin || (uint32_t)(w->minor - in->minor) >= in->minor_count)) {
        qtri_line_walk_next(w);
    }
    qtri_line_walk ahead = *w;
    while (ahead.k < end && (uint32_t)(ahead.minor - in->minor) < in->minor_count) {
        qtri_line_walk_next(&ahead);
    }
    return ahead.k;
}

int32_t qtri_line_cut_short(qtri_line_walk *w, const qtri_line_job *job, const qtri_line_path *l)
{
    limits in;
    limits_init(&in, job, l);
    return walk_cut(w, &in, l->count);
}

/* To pixel k of any line. */
static void walk_long(qtri_line_walk *w, const qtri_line_path *l, int32_t k)
{
    qtri_dda dda;
    qtri_dda_init(&dda, l->minor, l->delta, l->length, l->along + 256 * k, 0);
    w->k = k;
    w->minor = dda.value;
    w->slope = dda.step;
    w->rest = (int32_t)(dda.remainder - dda.denominator);
    w->rest_step = (int32_t)dda.remainder_step;
    w->denominator = dda.denominator;
}

/* At pixel `start`, with which a chunk begins. */
static void ramp_init(qtri_line_ramp *r, int32_t from, int32_t to, int32_t along,
                      const qtri_divider *by, int32_t start)
{
    if (start == 0) {
        qtri_line_ramp_init(r, from, to, along, by);
        return;
    }
    along += 256 * start; /* < length */
    const int32_t quotient = qtri_divide(to - from, by);
    const int32_t remainder = to - from - quotient * (int32_t)by->divisor; /* < 2^23 */
    const int64_t product = qtri_mul_s32(remainder, along);                /* < 2^46 */
    uint32_t unused;
    uint32_t rest = qtri_divide_long(qtri_magnitude64(product), by->divisor, &unused);
    rest = product < 0 ? 0 - rest : rest;
    r->value = (uint32_t)(from + quotient * along) + rest;
    r->step = (uint32_t)quotient * 256u + (uint32_t)qtri_divide(remainder * 256, by);
}

/* Colours from the chunk's first pixel on: channels in steps of a colour word, n.16. */
typedef struct shade {
    qtri_line_ramp channel[3];
} shade;

/* Between these colours, in the chunk that begins at pixel `start`. */
QTRI_NOINLINE static void shade_init(shade *s, const qtri_colors *colors, const int32_t *first,
                                     const int32_t *last, int32_t along, const qtri_divider *by,
                                     int32_t start)
{
    const uint32_t half = 0x8000; /* rounds */
    const uint32_t *ratio_q30 = colors->ratio_q30;
    uint32_t from[3];
    uint32_t to[3];
    from[0] = qtri_channel_scaled((uint32_t)first[0], ratio_q30[0]) + half;
    to[0] = qtri_channel_scaled((uint32_t)last[0], ratio_q30[0]) + half;
    from[1] = qtri_channel_scaled((uint32_t)first[1], ratio_q30[1]) + half;
    to[1] = qtri_channel_scaled((uint32_t)last[1], ratio_q30[1]) + half;
    from[2] = qtri_channel_scaled((uint32_t)first[2], ratio_q30[2]) + half;
    to[2] = qtri_channel_scaled((uint32_t)last[2], ratio_q30[2]) + half;
    if (colors->single) {
        from[2] += from[0] + from[1] - 2 * half;
        to[2] += to[0] + to[1] - 2 * half;
        from[0] = from[1] = to[0] = to[1] = 0;
    }
    for (int i = 0; i < 3; i++) {
        s->channel[i].value = from[i];
        s->channel[i].step = 0;
        if (from[i] == to[i]) {
            continue;
        }
        if (start == 0) {
            qtri_line_ramp_init(&s->channel[i], (int32_t)from[i], (int32_t)to[i], along, by);
        } else {
            ramp_init(&s->channel[i], (int32_t)from[i], (int32_t)to[i], along, by, start);
        }
    }
}

/* Makes colour words of the numbers of pixels that the batch has from `first` on. */
QTRI_NOINLINE static void shade_pixels(const shade *s, const qtri_line_job *job, uint32_t first)
{
    const qtri_line_ramp *r = s->channel;
    const qtri_colors *colors = job->surface->format->colors;
    const uint32_t red = colors->red;
    const uint32_t green = colors->green;
    uint32_t *color = &job->batch->color[first];
    for (const uint32_t *end = job->batch->color + job->batch->count; color != end; color++) {
        const uint32_t k = *color;
        *color = (r[0].value + k * r[0].step) >> 16 << red |
                 (r[1].value + k * r[1].step) >> 16 << green | (r[2].value + k * r[2].step) >> 16;
    }
}

/* Times a tint of at most 255.0 shares are below 2^26. */
QTRI_NOINLINE void qtri_line_tint(uint32_t *color, const qtri_line_job *job, int32_t count)
{
    const qtri_colors *colors = job->surface->format->colors;
    const uint32_t red = colors->red;
    const uint32_t green = colors->green;
    const uint32_t down = 22u - colors->light_bits;
    const uint32_t share_half = (uint32_t)1 << (down - 1);
    const uint32_t shift = 8u + colors->light_bits;
    const uint32_t half = (uint32_t)1 << (shift - 1);
    const uint32_t tint[3] = {job->tint_n8[0], job->tint_n8[1], job->tint_n8[2]};
    for (const uint32_t *end = color + count; color != end; color++) {
        const uint32_t share = (*color + share_half) >> down;
        *color = (share * tint[0] + half) >> shift << red |
                 (share * tint[1] + half) >> shift << green | (share * tint[2] + half) >> shift;
    }
}

/* Smooth lines have no use for `effect`: they take the table where there is neither fog nor blend.
 */
static bool is_plain_smooth(const qtri_line_job *job)
{
    return job->smooth != NULL && job->material->fog == NULL && job->material->blend == NULL;
}

void qtri_line_make_table(const qtri_line_job *job)
{
    const qtri_format *format = job->surface->format;
    uint16_t *table = qtri_batch_table(job->batch);
    if (table == NULL || format == NULL || format->colors->light_bits != QTRI_TINT_BITS ||
        format->pixels->bytes > 2 || (job->effect != NULL && !is_plain_smooth(job))) {
        return;
    }
    for (uint32_t i = 0; i < (1u << QTRI_TINT_BITS) + 1; i += 4) {
        uint32_t color[4];
        for (uint32_t k = 0; k < 4; k++) {
            color[k] = (i + k) << QTRI_LINE_TINT_SHIFT;
        }
        qtri_line_tint(color, job, 4);
        if (format->encode != NULL) {
            format->encode(color, 4);
        }
        for (uint32_t k = 0; k < 4; k++) {
            table[i + k] = (uint16_t)color[k];
        }
    }
    job->batch->has_table = true;
}

static void look_up(qtri_batch *batch)
{
    const uint16_t *table = qtri_batch_table(batch);
    for (int32_t i = 0; i < batch->count; i++) {
        batch->color[i] = table[(batch->color[i] + QTRI_LINE_TINT_HALF) >> QTRI_LINE_TINT_SHIFT];
    }
}

QTRI_NOINLINE void qtri_line_flush(const qtri_line_job *job)
{
    qtri_batch *batch = job->batch;
    const int32_t count = batch->count;
    if (count == 0) {
        return;
    }
    const qtri_surface *surface = job->surface;
    const qtri_format *format = surface->format;
    const bool are_stored = batch->kind == QTRI_LINE_SHARES && batch->has_table;
    if (are_stored) {
        look_up(batch);
    } else if (batch->kind == QTRI_LINE_SHARES) {
        qtri_line_tint(batch->color, job, count);
    }
    if (!are_stored && format->encode != NULL) {
        format->encode(batch->color, count);
    }
    format->pixels->scatter(surface->pixels, surface->pitch, batch->place, batch->color, count);
    batch->count = 0;
}

/* Pixels of a chunk on their way to the batch. */
typedef struct walk {
    uint32_t place, step, step_minor;
    int32_t rest, rest_step;
    uint32_t denominator;
    uint32_t z_16p15, z_step;
    uint32_t value, value_step; /* share of the tint in Q22, or number in the chunk */
} walk;

/* From `at` on, in the chunk that begins with `start`. */
static inline void walk_init(walk *w, const qtri_line_walk *at, int32_t start,
                             const qtri_line_ramp *z, const qtri_line_ramp *value,
                             const qtri_line_job *job, const qtri_line_path *l)
{
    const uint32_t number = (uint32_t)(at->k - start);
    w->place = (uint32_t)(l->position + at->k) * (uint32_t)l->step +
               (uint32_t)at->minor * (uint32_t)l->step_minor - job->first_place;
    w->step = (uint32_t)l->step + (uint32_t)at->slope * (uint32_t)l->step_minor;
    w->step_minor = (uint32_t)l->step_minor;
    w->rest = at->rest;
    w->rest_step = at->rest_step;
    w->denominator = at->denominator;
    w->z_16p15 = z->value + QTRI_LINE_DEPTH_HALF + number * z->step;
    w->z_step = z->step;
    w->value = value->value + number * value->step;
    w->value_step = value->step;
}

static inline void walk_next(walk *w)
{
    w->place += w->step;
    w->z_16p15 += w->z_step;
    w->value += w->value_step;
    w->rest += w->rest_step;
    if (w->rest >= 0) {
        w->rest = (int32_t)((uint32_t)w->rest - w->denominator);
        w->place += w->step_minor;
    }
}

/* Takes those of the next `count` pixels that pass, and writes their depths: there is room. */
QTRI_INLINE void take_pixels(walk *walk_of, int32_t count, const qtri_line_job *job)
{
    qtri_batch *batch = job->batch;
    uint32_t *place = &batch->place[batch->count];
    uint32_t *value = &batch->color[batch->count];
    walk w = *walk_of;
    if (!job->has_depth) {
        do {
            *place++ = w.place;
            *value++ = w.value;
            walk_next(&w);
        } while (--count > 0);
    } else {
        uint16_t *depths = job->surface->depth;
        const ptrdiff_t pitch = job->surface->depth_pitch;
        const uint32_t less = job->less;
        const uint32_t passing = job->passing;
        const bool is_written = job->writes_early;
        do {
            uint16_t *depth =
                &depths[(ptrdiff_t)(w.place >> 16) * pitch + (ptrdiff_t)(w.place & 0xFFFFu)];
            const uint32_t z = w.z_16p15 >> 15;
            if (z - *depth - less < passing) {
                if (is_written) {
                    *depth = (uint16_t)z;
                }
                *place++ = w.place;
                *value++ = w.value;
            }
            walk_next(&w);
        } while (--count > 0);
    }
    batch->count = (uint8_t)(place - batch->place);
    *walk_of = w;
}

/* Room for pixels of this kind. */
static inline void make_room(const qtri_line_job *job, int32_t count, uint8_t kind)
{
    qtri_batch *batch = job->batch;
    if (batch->kind != kind || batch->count + count > QTRI_BATCH) {
        qtri_line_flush(job);
        batch->kind = kind;
    }
}

/* Depths of a chunk, 16.16, by the places of its pixels: along the major axis. */
static void depth_ramp(qtri_ramp *depth, const qtri_line_job *job, const qtri_line_path *l,
                       const qtri_line_ramp *z, int32_t start)
{
    const uint32_t step = 2 * z->step;
    const uint32_t first =
        (uint32_t)(l->position + start) - (l->steep ? job->first_place >> 16 : 0);
    depth->dx = l->steep ? 0 : step;
    depth->dy = l->steep ? step : 0;
    depth->origin = 2 * (z->value + QTRI_LINE_DEPTH_HALF) - first * step;
}

/* `rest` pixels from `at` on, in the chunk of a line that begins at pixel `start`. */
static void draw_chunk(const qtri_line_job *job, const qtri_line_path *l, const qtri_divider *by,
                       const qtri_line_walk *at, int32_t start, int32_t rest, const qtri_vertex *a,
                       const qtri_line_color *color)
{
    walk w;
    shade s;
    qtri_line_ramp z;
    qtri_line_ramp value = {0, 1};
    ramp_init(&z, qtri_line_depth_16p15(job->depth_mask, l->first),
              qtri_line_depth_16p15(job->depth_mask, l->last), l->along, by, start);
    if (color != NULL) {
        shade_init(&s, job->surface->format->colors, color[l->first != a], color[l->first == a],
                   l->along, by, start);
    } else if (start == 0) {
        qtri_line_ramp_share(&value, l, by);
    } else {
        ramp_init(&value, qtri_line_share_q22(l->first), qtri_line_share_q22(l->last), l->along, by,
                  start);
    }
    walk_init(&w, at, start, &z, &value, job, l);
    while (rest > 0) {
        const int32_t count = qtri_least32(rest, QTRI_BATCH);
        make_room(job, count, color == NULL ? QTRI_LINE_SHARES : QTRI_LINE_WORDS);
        const uint32_t taken = job->batch->count;
        take_pixels(&w, count, job);
        if (color != NULL) {
            shade_pixels(&s, job, taken);
        }
        if (job->effect != NULL) {
            qtri_ramp depth;
            depth_ramp(&depth, job, l, &z, start);
            job->effect(job, &depth);
        }
        rest -= count;
    }
}

/* Any line. */
QTRI_NOINLINE static void draw_long(const qtri_line_job *job, const qtri_line_path *l,
                                    const qtri_vertex *a, const qtri_line_color *color)
{
    limits in;
    qtri_divider by;
    limits_init(&in, job, l);
    const int32_t minor_first = (l->minor >> 8) - in.minor;
    const int32_t minor_last = ((l->minor + l->delta) >> 8) - in.minor;
    const int32_t minor_end = (int32_t)in.minor_count;
    const int32_t count = qtri_least32(l->count, in.end);
    int32_t k = qtri_greatest32(0, in.begin);
    if (k >= count || (minor_first < 0 && minor_last < 0) ||
        (minor_first >= minor_end && minor_last >= minor_end)) {
        return;
    }
    qtri_divider_init(&by, (uint32_t)l->length);
    while (k < count) {
        const int32_t start = k & ~(QTRI_LINE_CHUNK - 1);
        qtri_line_walk at;
        walk_long(&at, l, k);
        k = qtri_least32(count, start + QTRI_LINE_CHUNK);
        const int32_t rest = walk_cut(&at, &in, k) - at.k;
        if (rest > 0) {
            draw_chunk(job, l, &by, &at, start, rest, a, color);
        }
    }
}

void qtri_line_draw_apart(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                          const qtri_line_color *color)
{
    qtri_line_path l;
    qtri_line_path_init(&l, a, b, 1, 65536);
    draw_long(job, &l, a, color);
}

void qtri_line_draw(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                    const qtri_line_color *color)
{
    qtri_line_path l;
    qtri_line_path_init(&l, a, b, 1, 65536);
    if ((uint32_t)(l.count - 1) >= QTRI_BATCH) {
        const qtri_line_path path = l;
        draw_long(job, &path, a, color);
        return;
    }
    qtri_line_walk at;
    qtri_divider by;
    qtri_line_ramp z;
    qtri_line_ramp value = {0, 1};
    walk w;
    int32_t end = l.count;
    qtri_line_walk_short(&at, &l);
    if (!qtri_line_is_inside(job, a, b)) {
        const qtri_line_path path = l;
        qtri_line_walk first = at;
        end = qtri_line_cut_short(&first, job, &path);
        at = first;
        if (at.k >= end) {
            return;
        }
    }
    qtri_divider_init_short(&by, (uint32_t)l.length);
    qtri_line_ramp_init(&z, qtri_line_depth_16p15(job->depth_mask, l.first),
                        qtri_line_depth_16p15(job->depth_mask, l.last), l.along, &by);
    if (color == NULL) {
        qtri_line_ramp_share(&value, &l, &by);
    }
    walk_init(&w, &at, 0, &z, &value, job, &l);
    make_room(job, end - at.k, color == NULL ? QTRI_LINE_SHARES : QTRI_LINE_WORDS);
    const uint32_t taken = job->batch->count;
    take_pixels(&w, end - at.k, job);
    if (color != NULL && job->batch->count > taken) {
        const qtri_divider divider = by;
        shade s;
        shade_init(&s, job->surface->format->colors, color[l.first != a], color[l.first == a],
                   l.along, &divider, 0);
        shade_pixels(&s, job, taken);
    }
}

/*
 * A depth passes when it is at least `less` above the stored one, modulo 2^32, and `passing` of
 * these differences do. They are within +-65535.
 */
static const struct {
    uint32_t less, passing;
} differences[QTRI_ALWAYS + 1] = {
    {0, 0},                      /* off */
    {0, 0},                      /* never */
    {0u - 65535, 65535},         /* less */
    {0, 1},                      /* equal */
    {0u - 65535, 65536},         /* less or equal */
    {1, 65535},                  /* greater */
    {1, UINT32_MAX},             /* not equal */
    {0, 65536},                  /* greater or equal */
    {0u - 65535, 2 * 65535 + 1}, /* always */
};

static void set_tint(qtri_line_job *job, const qtri_colors *colors, qtri_rgb color)
{
    uint32_t channel[3] = {qtri_channel_scaled((uint32_t)color.r << 16, colors->ratio_q30[0]),
                           qtri_channel_scaled((uint32_t)color.g << 16, colors->ratio_q30[1]),
                           qtri_channel_scaled((uint32_t)color.b << 16, colors->ratio_q30[2])};
    if (colors->single) {
        channel[2] += channel[0] + channel[1];
        channel[0] = channel[1] = 0;
    }
    for (int i = 0; i < 3; i++) {
        job->tint_n8[i] = (channel[i] + 128) >> 8;
    }
}

void qtri_line_job_init(qtri_line_job *job, const qtri_surface *surface,
                        const qtri_material *material, qtri_batch *batch)
{
    const qtri_rect bounds = qtri_surface_bounds(surface);
    const qtri_compare compare = qtri_compare_of(material);
    job->surface = surface;
    job->draw = qtri_line_draw;
    job->batch = batch;
    job->left_24p8 = bounds.x0 * 256;
    job->top_24p8 = bounds.y0 * 256;
    job->width_24p8 = 0;
    job->height_24p8 = 0;
    job->first_place = (uint32_t)surface->first_row << 16;
    job->smooth = NULL;
    job->depth_mask = ~0xFFu;
    job->has_depth = surface->depth != NULL && compare != QTRI_DEPTH_OFF;
    job->is_less = compare == QTRI_LESS;
    job->depth_write = !material->depth_read_only;
    job->writes_early = job->depth_write;
    job->material = material;
    job->effect = NULL;
    job->testing = NULL;
    job->less = differences[compare].less;
    job->passing = differences[compare].passing;
    if (surface->format != NULL) { /* or nothing is drawn */
        job->width_24p8 = (uint32_t)(bounds.x1 - bounds.x0) * 256;
        job->height_24p8 = (uint32_t)(bounds.y1 - bounds.y0) * 256;
        set_tint(job, surface->format->colors, material->color);
    }
    batch->count = 0;
    batch->kind = QTRI_LINE_SHARES;
    batch->has_table = false;
}

void qtri_line_end(qtri_vertex *end, qtri_line_color color, const qtri_screen_vertex *v)
{
    const uint32_t farthest = (uint32_t)65535 << 16;
    end->at.x_24p8 = qtri_hold32(v->x_24p8, -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
    end->at.y_24p8 = qtri_hold32(v->y_24p8, -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
    end->depth_16p8 = v->depth_16p16 < farthest ? v->depth_16p16 : farthest;
    for (int i = 0; i < 3; i++) {
        color[i] = qtri_hold32(v->color_8p16[i], 0, 255 << 16);
    }
}

void qtri_raster_line(const qtri_surface *surface, const qtri_material *material,
                      const qtri_screen_vertex v[2])
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_ASSERT(v != NULL);
    qtri_batch batch;
    qtri_line_job job;
    qtri_vertex end[2];
    qtri_line_color color[2];
    qtri_line_job_init(&job, surface, material, &batch);
    job.depth_mask = UINT32_MAX;
    qtri_line_end(&end[0], color[0], &v[0]);
    qtri_line_end(&end[1], color[1], &v[1]);
    job.draw(&job, &end[0], &end[1], (const qtri_line_color *)color);
    qtri_line_flush(&job);
}
