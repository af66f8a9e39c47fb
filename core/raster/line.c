#include "line.h"

#include "dda.h"
#include "line_path.h"

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

/* white / 255.0 in Q30, rounded. */
#define RATIO_Q30(white)                                                                           \
    ((uint32_t)((((uint64_t)(white) << 30) + ((uint32_t)255 << 15)) / ((uint32_t)255 << 16)))

static const qtri_line_units units_of[3] = {
    {{RATIO_Q30((uint32_t)31 << 16), RATIO_Q30((uint32_t)63 << 16), RATIO_Q30((uint32_t)31 << 16)},
     {1 << 11, 1 << 5, 1},
     false},
    {{RATIO_Q30((uint32_t)255 << 16), RATIO_Q30((uint32_t)255 << 16),
      RATIO_Q30((uint32_t)255 << 16)},
     {1 << 16, 1 << 8, 1},
     false},
    {{RATIO_Q30(QTRI_GRAY_RED), RATIO_Q30(QTRI_GRAY_GREEN), RATIO_Q30(QTRI_GRAY_BLUE)},
     {1, 1, 1},
     true}};

/*
 * A channel in steps of a colour word, n.16: color_8p16 (0..255.0) times ratio_q30 to nearest, as
 * qtri_channels_from_color has it. A ratio of 1 is 0 in Q32.
 */
static inline uint32_t scaled(int32_t color_8p16, uint32_t ratio_q30)
{
    const uint32_t ratio_q32 = ratio_q30 << 2;
    const uint32_t c = (uint32_t)color_8p16;
    if (ratio_q32 == 0) {
        return c;
    }
    const uint64_t product = qtri_mul_u32(c, ratio_q32);
    return (uint32_t)(product >> 32) + ((uint32_t)product >> 31);
}

static inline uint32_t word_of(const uint32_t unit[3], uint32_t c0, uint32_t c1, uint32_t c2)
{
    return c0 * unit[0] + c1 * unit[1] + c2 * unit[2];
}

/* Colours from the chunk's first pixel on: channels in steps of a colour word, n.16. */
typedef struct shade {
    qtri_line_ramp channel[3];
} shade;

/* Between these colours, in the chunk that begins at pixel `start`. */
QTRI_NOINLINE static void shade_init(shade *s, const qtri_line_units *units, const int32_t *first,
                                     const int32_t *last, int32_t along, const qtri_divider *by,
                                     int32_t start)
{
    const uint32_t half = 0x8000; /* rounds */
    uint32_t from[3];
    uint32_t to[3];
    from[0] = scaled(first[0], units->ratio_q30[0]) + half;
    to[0] = scaled(last[0], units->ratio_q30[0]) + half;
    from[1] = scaled(first[1], units->ratio_q30[1]) + half;
    to[1] = scaled(last[1], units->ratio_q30[1]) + half;
    from[2] = scaled(first[2], units->ratio_q30[2]) + half;
    to[2] = scaled(last[2], units->ratio_q30[2]) + half;
    if (units->single) {
        from[0] += from[1] + from[2] - 2 * half;
        to[0] += to[1] + to[2] - 2 * half;
        from[1] = from[2] = to[1] = to[2] = 0;
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
QTRI_NOINLINE static void shade_pixels(const shade *s, const qtri_line_job *job, int32_t first)
{
    const qtri_line_ramp *r = s->channel;
    const uint32_t *unit = job->units->unit;
    for (int32_t i = first; i < job->batch->count; i++) {
        const uint32_t k = job->batch->pixel[i];
        job->batch->pixel[i] =
            word_of(unit, (r[0].value + k * r[0].step) >> 16, (r[1].value + k * r[1].step) >> 16,
                    (r[2].value + k * r[2].step) >> 16);
    }
}

/* share_q15 <= 2^15: sums are below 255 2^24 + 2^23. */
static inline uint32_t tint_of(const qtri_line_job *job, uint32_t share_q15)
{
    const uint32_t half = (uint32_t)1 << 23;
    return word_of(job->units->unit, (job->tint_n9[0] * share_q15 + half) >> 24,
                   (job->tint_n9[1] * share_q15 + half) >> 24,
                   (job->tint_n9[2] * share_q15 + half) >> 24);
}

/* Stored pixels to their places. */
static inline void scatter_as(qtri_format format, const qtri_surface *surface,
                              const uint32_t *place, const uint32_t *pixel, int32_t count)
{
    uint8_t *pixels = surface->pixels;
    const ptrdiff_t pitch = surface->pitch;
    for (int32_t i = 0; i < count; i++) {
        uint8_t *row = pixels + (ptrdiff_t)(place[i] >> 16) * pitch;
        qtri_pixel_store(format, row, (int32_t)(place[i] & 0xFFFFu), pixel[i]);
    }
}

static void scatter(const qtri_surface *surface, const uint32_t *place, const uint32_t *pixel,
                    int32_t count)
{
    switch (qtri_format_of(surface)) {
    case QTRI_RGB565:
        scatter_as(QTRI_RGB565, surface, place, pixel, count);
        break;
    case QTRI_XRGB8888:
        scatter_as(QTRI_XRGB8888, surface, place, pixel, count);
        break;
    default:
        scatter_as(QTRI_GRAY8, surface, place, pixel, count);
        break;
    }
}

QTRI_NOINLINE void qtri_line_flush(const qtri_line_job *job)
{
    qtri_line_batch *b = job->batch;
    const int32_t count = b->count;
    if (count == 0) {
        return;
    }
    if (b->tinted && job->tints != NULL) {
        for (int32_t i = 0; i < count; i++) {
            b->pixel[i] = job->tints[(b->pixel[i] + QTRI_LINE_TINT_HALF) >> 15];
        }
    } else {
        const uint32_t down = job->tint_down;
        const uint32_t half = (uint32_t)64 << down;
        for (int32_t i = 0; b->tinted && i < count; i++) {
            b->pixel[i] = tint_of(job, ((b->pixel[i] + half) >> (7 + down)) << down);
        }
    }
    scatter(job->surface, b->place, b->pixel, count);
    b->count = 0;
}

void qtri_line_set_tints(qtri_line_job *job)
{
    if (job->table == NULL || qtri_format_of(job->surface) != QTRI_RGB565) {
        return;
    }
    for (uint32_t i = 0; i < QTRI_LINE_TINTS; i++) {
        job->table[i] = (uint16_t)tint_of(job, i << QTRI_LINE_TINT_DOWN);
    }
    job->tints = job->table;
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
    qtri_line_batch *b = job->batch;
    uint32_t *place = &b->place[b->count];
    walk w = *walk_of;
    if (!job->has_depth) {
        do {
            place[0] = w.place;
            place[QTRI_LINE_BATCH] = w.value;
            place++;
            walk_next(&w);
        } while (--count > 0);
    } else {
        uint16_t *depths = job->surface->depth;
        const ptrdiff_t pitch = job->surface->depth_pitch;
        const uint32_t less = job->less;
        const uint32_t passing = job->passing;
        const bool is_written = job->depth_write;
        do {
            uint16_t *depth = &depths[(ptrdiff_t)(w.place >> 16) * pitch + (w.place & 0xFFFFu)];
            const uint32_t z = w.z_16p15 >> 15;
            if (z - *depth - less < passing) {
                if (is_written) {
                    *depth = (uint16_t)z;
                }
                place[0] = w.place;
                place[QTRI_LINE_BATCH] = w.value;
                place++;
            }
            walk_next(&w);
        } while (--count > 0);
    }
    b->count = (int32_t)(place - b->place);
    *walk_of = w;
}

/* Room for pixels whose values are shares of the tint, or are not. */
static inline void make_room(const qtri_line_job *job, int32_t count, bool tinted)
{
    qtri_line_batch *b = job->batch;
    if (b->tinted != tinted || b->count + count > QTRI_LINE_BATCH) {
        qtri_line_flush(job);
        b->tinted = tinted;
    }
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
        shade_init(&s, job->units, color[l->first != a], color[l->first == a], l->along, by, start);
    } else if (start == 0) {
        qtri_line_ramp_share(&value, l, by);
    } else {
        ramp_init(&value, qtri_line_share_q22(l->first), qtri_line_share_q22(l->last), l->along, by,
                  start);
    }
    walk_init(&w, at, start, &z, &value, job, l);
    while (rest > 0) {
        const int32_t count = qtri_least32(rest, QTRI_LINE_BATCH);
        make_room(job, count, color == NULL);
        const int32_t taken = job->batch->count;
        take_pixels(&w, count, job);
        if (color != NULL) {
            shade_pixels(&s, job, taken);
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

void qtri_line_draw(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                    const qtri_line_color *color)
{
    qtri_line_path l;
    qtri_line_path_init(&l, a, b, 1, 65536);
    if (!QTRI_WITH_FAST_PATHS || (uint32_t)(l.count - 1) >= QTRI_LINE_BATCH) {
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
    make_room(job, end - at.k, color == NULL);
    const int32_t taken = job->batch->count;
    take_pixels(&w, end - at.k, job);
    if (color != NULL && job->batch->count > taken) {
        const qtri_divider divider = by;
        shade s;
        shade_init(&s, job->units, color[l.first != a], color[l.first == a], l.along, &divider, 0);
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

void qtri_line_job_init(qtri_line_job *job, const qtri_surface *surface,
                        const qtri_material *material, qtri_line_batch *batch)
{
    const qtri_rect bounds = qtri_surface_bounds(surface);
    const qtri_format format = qtri_format_of(surface);
    const qtri_compare compare = material->depth_compare;
    job->surface = surface;
    job->draw = qtri_line_draw;
    job->batch = batch;
    job->left_24p8 = bounds.x0 * 256;
    job->top_24p8 = bounds.y0 * 256;
    job->width_24p8 = (uint32_t)(bounds.x1 - bounds.x0) * 256;
    job->height_24p8 = (uint32_t)(bounds.y1 - bounds.y0) * 256;
    job->first_place = (uint32_t)surface->first_row << 16;
    job->depth_mask = ~0xFFu;
    job->has_depth = surface->depth != NULL && compare != QTRI_DEPTH_OFF;
    job->is_less = compare == QTRI_LESS;
    job->depth_write = !material->depth_read_only;
    job->less = differences[compare > QTRI_ALWAYS ? QTRI_ALWAYS : compare].less;
    job->passing = differences[compare > QTRI_ALWAYS ? QTRI_ALWAYS : compare].passing;
    job->units = &units_of[format == QTRI_RGB565 ? 0 : (format == QTRI_XRGB8888 ? 1 : 2)];
    job->tint_down = format == QTRI_RGB565 ? QTRI_LINE_TINT_DOWN : 0;
    job->table = NULL;
    job->tints = NULL;
    const uint32_t *ratio_q30 = job->units->ratio_q30;
    job->tint_n9[0] = scaled(material->color.r << 16, ratio_q30[0]);
    job->tint_n9[1] = scaled(material->color.g << 16, ratio_q30[1]);
    job->tint_n9[2] = scaled(material->color.b << 16, ratio_q30[2]);
    if (job->units->single) {
        job->tint_n9[0] += job->tint_n9[1] + job->tint_n9[2];
        job->tint_n9[1] = job->tint_n9[2] = 0;
    }
    for (int i = 0; i < 3; i++) {
        job->tint_n9[i] = (job->tint_n9[i] + 64) >> 7;
    }
    batch->count = 0;
    batch->tinted = true;
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
    qtri_line_batch batch;
    qtri_line_job job;
    qtri_vertex end[2];
    qtri_line_color color[2];
    if (!QTRI_WITH_LINES) {
        return;
    }
    qtri_line_job_init(&job, surface, material, &batch);
    job.depth_mask = UINT32_MAX;
    qtri_line_end(&end[0], color[0], &v[0]);
    qtri_line_end(&end[1], color[1], &v[1]);
    qtri_line_draw(&job, &end[0], &end[1], (const qtri_line_color *)color);
    qtri_line_flush(&job);
}
