#include "span.h"

enum { BLOCK = 16 }; /* pixels from one exact division to the next where w changes fast */

/* Exact attributes at one pixel of a span. */
typedef struct sample {
    uint32_t q; /* 1/w, Q31 of the largest; at least 1 */
    int32_t value[QTRI_ATTRIBUTES];
} sample;

/* A row on its way to pixels. */
typedef struct window {
    int32_t y;
    int32_t last;              /* pixel of the span */
    int32_t x0, x1;            /* of which these are drawn */
    uint64_t row[QTRI_PLANES]; /* planes at column 0 */
    sample from;               /* where the next run starts */
    qtri_run run;
} window;

/* A plane's value rounded down, held to 0..2^31. */
static uint32_t held(uint64_t value)
{
    int32_t high = (int32_t)(value >> 32);
    if (high < 0) {
        return 0;
    }
    return high >= (int32_t)1 << 15 ? (uint32_t)1 << 31 : (uint32_t)(value >> 16);
}

/*
 * (a/w) / (1/w): 1/w is q 2^-31 with q in 1..2^31, normalised to 32 bits for the reciprocal;
 * s 2^31 / q = s r 2^(zeros - 31), s <= 2^31, r <= 2^31.
 */
typedef struct divider {
    uint32_t reciprocal;
    int32_t shift;
} divider;

static divider divider_for(uint64_t inv_w, uint32_t *q)
{
    uint32_t exact = held(inv_w);
    *q = exact == 0 ? 1 : exact;
    int32_t zeros = qtri_clz32(*q);
    divider d = {qtri_reciprocal_q62(*q << zeros), 31 - zeros};
    return d;
}

/* Attribute i at column x. */
static int32_t divided(const qtri_job *job, const window *w, int i, int32_t x, const divider *d)
{
    uint32_t s = held(qtri_plane_column(w->row[i], job->attribute[i].plane.dx, x));
    return qtri_saturate32((int64_t)(qtri_mul_u32(s, d->reciprocal) >> d->shift));
}

static void sample_at(sample *out, const qtri_job *job, const window *w, int32_t x)
{
    const int end = qtri_job_end(job);
    const uint64_t dx = job->attribute[end].plane.dx;
    const divider d = divider_for(qtri_plane_column(w->row[end], dx, x), &out->q);
    for (int i = qtri_job_first(job); i < end; i++) {
        int32_t value = divided(job, w, i, x, &d);
        if (i < QTRI_U) {
            value = qtri_hold32(value >> QTRI_COLOR_PERSPECTIVE_SHIFT, job->color.range.least[i],
                                job->color.range.greatest[i]);
        }
        out->value[i] = value;
    }
}

static uint32_t difference(int32_t a, int32_t b)
{
    return a < b ? (uint32_t)b - (uint32_t)a : (uint32_t)a - (uint32_t)b;
}

/*
 * How many pixels a run between a and b, `distance` pixels apart, may have: distance / 2^n, rounded
 * up, for which linear interpolation strays by less than 1/32 of a colour step and 1/1024 of a
 * texel.
 *
 * f = s/q has f' = k/q^2 with a constant k, and f'' = -2 k q'/q^3. Over a run of h out of L pixels
 * the chord strays by at most h^2/8 max|f''| = (h/L)^2 |f(b) - f(a)| |q(b) - q(a)| m / (4 n^2),
 * n and m being the least and greatest q. Where m < 2 n, m / n counts as 2; elsewhere every pixel
 * is divided.
 */
static int32_t run_length(const qtri_job *job, const sample *a, const sample *b, int32_t distance)
{
    const int end = qtri_job_end(job);
    uint32_t q_least = a->q < b->q ? a->q : b->q; /* <= 2^31 */
    uint32_t q_difference = a->q < b->q ? b->q - a->q : a->q - b->q;
    if (q_difference == 0) {
        return distance;
    }
    int32_t length = q_difference < q_least ? distance : 1;
    for (int i = qtri_job_first(job); i < end; i++) {
        uint64_t error = qtri_mul_u32(difference(a->value[i], b->value[i]), q_difference);
        int32_t up = i < QTRI_U ? 12 : job->axis[i - QTRI_U].shift - 9; /* -7..20 */
        uint64_t tolerance = up >= 0 ? (uint64_t)q_least << up : q_least >> -up;
        for (; length > 1 && error > tolerance; error >>= 2) {
            length = (length + 1) / 2;
        }
    }
    return length;
}

/* 1 / length = reciprocal 2^(zeros - 62). */
typedef struct inverse {
    uint32_t reciprocal;
    int32_t zeros;
} inverse;

static inverse inverse_of(int32_t length)
{
    uint32_t pixels = length > 1 ? (uint32_t)length : 1;
    int32_t zeros = qtri_clz32(pixels);
    inverse result = {qtri_reciprocal_q62(pixels << zeros), zeros};
    return result;
}

/* One pixel's step on the way from a to b, times 2^up, up in -12..20; zeros >= 17. */
static uint32_t step_of(int32_t a, int32_t b, const inverse *length, int32_t up)
{
    uint64_t size = qtri_mul_u32(difference(a, b), length->reciprocal); /* < 2^62 */
    uint32_t step = (uint32_t)(size >> (62 - length->zeros - up));
    return a < b ? step : 0 - step;
}

/* The run's value and step: `from` is `skip` pixels before it. */
static void set_value(qtri_run *run, const qtri_job *job, int i, int32_t from, uint32_t step,
                      int32_t skip)
{
    uint32_t value = (uint32_t)from;
    if (i < QTRI_U) {
        value += 0x8000u;
    } else {
        const qtri_texel_axis *axis = &job->axis[i - QTRI_U];
        value = qtri_run_scaled(value + axis->bias, axis->up);
    }
    run->value[i] = value + (uint32_t)skip * step;
    run->step[i] = step;
}

/*
 * Sets the run from w->from at x to `to` at `end`; the next one starts there. The last pixel of a
 * span is drawn by the run that aims at it. False when nothing of it is drawn.
 */
static bool set_run(const qtri_job *job, window *w, const sample *to, int32_t x, int32_t end)
{
    const int32_t stop = qtri_least32(end == w->last ? end + 1 : end, w->x1);
    const int32_t skip = x < w->x0 ? w->x0 - x : 0;
    w->run.x = x + skip;
    w->run.count = stop - w->run.x;
    if (w->run.count > 0) {
        const int attributes_end = qtri_job_end(job);
        inverse per_pixel = inverse_of(end - x);
        for (int i = qtri_job_first(job); i < attributes_end; i++) {
            int32_t up = i < QTRI_U ? 0 : job->axis[i - QTRI_U].up;
            uint32_t step = step_of(w->from.value[i], to->value[i], &per_pixel, up);
            set_value(&w->run, job, i, w->from.value[i], step, skip);
        }
    }
    w->from = *to;
    return w->run.count > 0;
}

/* From w->from at x to `to` at `end` in runs of `length`. */
static void draw_block(const qtri_job *job, window *w, const sample *to, int32_t x, int32_t end,
                       int32_t length)
{
    while (x < end) {
        const int32_t next = qtri_least32(x + length, end);
        const sample *at = to;
        sample middle;
        if (next < end) {
            sample_at(&middle, job, w, next);
            at = &middle;
        }
        if (set_run(job, w, at, x, next)) {
            qtri_run_draw(job, &w->run, w->y);
        }
        x = next;
    }
}

/*
 * dx r / 2^down for a plane's dx, in 2^-16: 16 bits of it and the rest. Over a span of two pixels
 * and more |dx| < 2^47, since the attribute stays below 2^31; one pixel takes no step.
 */
static uint32_t divide_step(uint64_t dx, const divider *d, int32_t up)
{
    int32_t down = d->shift - up; /* -20..43 */
    int64_t high = qtri_wrap64(dx) >> 16;
    uint64_t low = qtri_mul_u32((uint32_t)dx & 0xFFFF, d->reciprocal) >> 16;
    uint64_t product = (uint64_t)high * d->reciprocal + low;
    return (uint32_t)(down >= 0 ? (uint64_t)(qtri_wrap64(product) >> down) : product << -down);
}

/*
 * Where w does not change along rows, as on floors and walls, texture coordinates are linear as
 * they are. Returns the pixels of a span below which a step's last bit adds up to 2^-10 of a texel
 * at most; 0: w changes.
 */
static int32_t level_pixels(const qtri_job *job)
{
    if (job->attribute[qtri_job_end(job)].plane.dx != 0 || qtri_job_is_smooth(job)) {
        return 0;
    }
    int32_t bits = 16;
    for (int i = QTRI_U; i < qtri_job_end(job); i++) {
        const qtri_texel_axis *axis = &job->axis[i - QTRI_U];
        bits = qtri_least32(bits, axis->shift + axis->up - 10);
    }
    return bits < 0 ? 0 : (int32_t)1 << bits;
}

static void draw_level(const qtri_job *job, window *w, int32_t left)
{
    const int end = qtri_job_end(job);
    uint32_t q;
    const divider d = divider_for(w->row[end], &q);
    w->run.x = w->x0;
    w->run.count = w->x1 - w->x0;
    for (int i = QTRI_U; i < end; i++) {
        const qtri_plane *plane = &job->attribute[i].plane;
        uint32_t step = divide_step(plane->dx, &d, job->axis[i - QTRI_U].up);
        set_value(&w->run, job, i, divided(job, w, i, left, &d), step, w->x0 - left);
    }
    qtri_run_draw(job, &w->run, w->y);
}

/*
 * The whole span in equal runs where w changes little, else in blocks of such runs. The last pixel
 * is always divided exactly. Where the exact divisions fall depends on the span alone, not on what
 * is drawn of it, so that a scissor does not change a pixel.
 */
static void draw_span(const qtri_job *job, window *w, int32_t left)
{
    const int32_t whole = w->last - left;
    sample to;
    sample_at(&w->from, job, w, left);
    if (whole == 0) {
        (void)set_run(job, w, &w->from, left, left);
        qtri_run_draw(job, &w->run, w->y);
        return;
    }
    sample_at(&to, job, w, w->last);
    int32_t length = run_length(job, &w->from, &to, whole);
    const int32_t block = length < BLOCK ? BLOCK : length;
    /* Unsigned: without an instruction that divides, that is the function linked anyway. */
    int32_t x = left + (int32_t)((uint32_t)(w->x0 - left) / (uint32_t)block * (uint32_t)block);
    if (x == w->last) {
        x -= block; /* the last pixel belongs to the run before it */
    }
    if (x > left) {
        sample_at(&w->from, job, w, x);
    }
    for (; x < w->x1 && x < w->last; x += block) {
        const int32_t end = qtri_least32(x + block, w->last);
        if (end - x != whole) {
            sample_at(&to, job, w, end);
            length = run_length(job, &w->from, &to, end - x);
        }
        draw_block(job, w, &to, x, end, length);
    }
}

void qtri_fill_perspective(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count)
{
    const qtri_raster *raster = job->raster;
    const int32_t level = level_pixels(job);
    const int first = qtri_job_first(job);
    const int end = qtri_job_end(job);
    window w;
    qtri_run_set_row(&w.run, raster, row);
    for (int i = first; i <= end; i++) {
        w.row[i] = qtri_plane_row(&job->attribute[i].plane, row);
    }
    for (w.y = row; count > 0; count--, spans++, w.y++) {
        const int32_t pixels = qtri_span_clip(spans, &raster->bounds, &w.x0);
        w.x1 = w.x0 + pixels;
        w.last = spans->right - 1;
        if (pixels > 0 && w.last + 1 - spans->left < level) {
            draw_level(job, &w, spans->left);
        } else if (pixels > 0) {
            draw_span(job, &w, spans->left);
        }
        for (int i = first; i <= end; i++) {
            w.row[i] += job->attribute[i].plane.dy;
        }
        qtri_run_next_row(&w.run, raster->surface);
    }
}
