#include "fill.h"
#include "packed.h"

enum { BLOCK = 16 }; /* pixels from one exact division to the next where w changes fast */

/* Which part of a span is drawn, and with PERSPECTIVE the planes at column 0 of its row. */
typedef struct window {
    int32_t y, x0, x1;
    uint64_t inv_w, uv[2], color[3];
} window;

/* Exact attributes at one pixel of a span with perspective. */
typedef struct sample {
    uint32_t q; /* 1/w, Q31 of the largest; at least 1 */
    int32_t color[3];
    int32_t uv[2];
} sample;

static int32_t hold(int64_t x, int32_t least, int32_t greatest)
{
    return x < least ? least : (x > greatest ? greatest : (int32_t)x);
}

static uint64_t column_of(uint64_t row, uint64_t dx, int32_t x)
{
    return row + (uint64_t)(int64_t)x * dx;
}

static uint64_t row_of(const qtri_plane *plane, int32_t y)
{
    return plane->origin + (uint64_t)(int64_t)y * plane->dy;
}

static void window_planes(window *w, const qtri_job *job)
{
    for (int i = 0; i < 3; i++) {
        w->color[i] = 0;
    }
    w->uv[0] = w->uv[1] = 0;
    w->inv_w = row_of(&job->inv_w, w->y);
    if (qtri_raster_texture(job->raster) != NULL) {
        w->uv[0] = row_of(&job->uv[0], w->y);
        w->uv[1] = row_of(&job->uv[1], w->y);
    }
    if (qtri_job_is_smooth(job)) {
        for (int i = 0; i < 3; i++) {
            w->color[i] = row_of(&job->color.plane[i], w->y);
        }
    }
}

/*
 * (a/w) / (1/w): 1/w is q 2^-31 with q in 1..2^31, normalised to 32 bits for the reciprocal;
 * s 2^31 / q = s r 2^(zeros - 31), |s| < 2^31, r <= 2^31.
 */
typedef struct divider {
    uint32_t reciprocal;
    int32_t shift;
} divider;

static int64_t divide(uint64_t over_w, const divider *d)
{
    int32_t s = hold(qtri_plane_floor(over_w), 0, INT32_MAX); /* a rounding below 0 at most */
    return (int64_t)(qtri_mul_u32((uint32_t)s, d->reciprocal) >> d->shift);
}

static divider divider_for(uint64_t inv_w, uint32_t *q)
{
    int64_t exact = qtri_plane_floor(inv_w);
    *q = exact < 1 ? 1u : (exact > (int64_t)1 << 31 ? (uint32_t)1 << 31 : (uint32_t)exact);
    int32_t zeros = qtri_clz32(*q);
    divider d = {qtri_reciprocal_q62(*q << zeros), 31 - zeros};
    return d;
}

static int32_t coordinate(uint64_t over_w, const divider *d)
{
    return hold(divide(over_w, d), 0, INT32_MAX);
}

static void sample_at(sample *out, const qtri_job *job, const window *w, int32_t x)
{
    divider d = divider_for(column_of(w->inv_w, job->inv_w.dx, x), &out->q);
    if (qtri_job_is_smooth(job)) {
        for (int i = 0; i < 3; i++) {
            uint64_t over_w = column_of(w->color[i], job->color.plane[i].dx, x);
            int64_t c = divide(over_w, &d) >> QTRI_COLOR_PERSPECTIVE_SHIFT;
            out->color[i] = hold(c, job->least[i], job->greatest[i]);
        }
    }
    if (qtri_raster_texture(job->raster) != NULL) {
        for (int i = 0; i < 2; i++) {
            out->uv[i] = coordinate(column_of(w->uv[i], job->uv[i].dx, x), &d);
        }
    }
}

static uint64_t difference(int32_t a, int32_t b)
{
    return (uint64_t)(a < b ? (int64_t)b - a : (int64_t)a - b);
}

/* Halves `length` until the error is within the tolerance, or the length 1. */
static int32_t shorten(int32_t length, uint64_t error, uint64_t tolerance)
{
    while (length > 1 && error > tolerance) {
        length = (length + 1) / 2;
        error >>= 2;
    }
    return length;
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
    uint64_t q_least = a->q < b->q ? a->q : b->q; /* <= 2^31 */
    uint64_t q_difference = a->q < b->q ? b->q - a->q : a->q - b->q;
    if (q_difference == 0) {
        return distance;
    }
    int32_t length = q_difference < q_least ? distance : 1;
    for (int i = 0; i < 3 && qtri_job_is_smooth(job); i++) {
        uint64_t error = difference(a->color[i], b->color[i]) * q_difference; /* < 2^55 */
        length = shorten(length, error, q_least << 12);
    }
    for (int i = 0; i < 2 && qtri_raster_texture(job->raster) != NULL; i++) {
        uint64_t error = difference(a->uv[i], b->uv[i]) * q_difference; /* < 2^62 */
        int32_t texel = job->axis[i].shift - 9;                         /* -7..20 */
        length = shorten(length, error, texel >= 0 ? q_least << texel : q_least >> -texel);
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
    int32_t zeros = qtri_clz32((uint32_t)length);
    inverse result = {qtri_reciprocal_q62((uint32_t)length << zeros), zeros};
    return result;
}

/* One pixel's step on the way from a to b, times 2^up, up in -30..20. */
static uint32_t step_of(int32_t a, int32_t b, const inverse *length, int32_t up)
{
    uint64_t size = difference(a, b) * length->reciprocal; /* < 2^62 */
    uint32_t step = (uint32_t)(size >> (62 - length->zeros - up));
    return a < b ? step : 0 - step;
}

static uint32_t scaled(uint32_t value, int32_t up)
{
    return up >= 0 ? value << up : value >> -up;
}

/* A plane's step in the attribute's unit times 2^up, rounded. */
static uint32_t plane_step(uint64_t dx, int32_t up)
{
    int32_t down = 16 - up; /* -4..46 */
    return (uint32_t)(down > 0 ? qtri_wrap64(dx + ((uint64_t)1 << (down - 1))) >> down
                               : qtri_wrap64(dx << -down));
}

static void draw_run(const qtri_job *job, const window *w, qtri_run *run, const sample *a,
                     const sample *b, int32_t x, int32_t length, int32_t count)
{
    int32_t skip = x < w->x0 ? w->x0 - x : 0;
    int32_t end = x + count < w->x1 ? x + count : w->x1;
    run->x = x + skip;
    run->count = end - run->x;
    if (run->count <= 0) {
        return;
    }
    inverse per_pixel = inverse_of(length);
    for (int i = 0; i < 3 && qtri_job_is_smooth(job); i++) {
        run->color_step[i] = step_of(a->color[i], b->color[i], &per_pixel, 0);
        run->color[i] = (uint32_t)a->color[i] + 0x8000u + (uint32_t)skip * run->color_step[i];
    }
    for (int i = 0; i < 2 && qtri_raster_texture(job->raster) != NULL; i++) {
        int32_t up = job->uv_up[i];
        run->uv_step[i] = step_of(a->uv[i], b->uv[i], &per_pixel, up);
        run->uv[i] =
            scaled((uint32_t)a->uv[i] + job->axis[i].bias, up) + (uint32_t)skip * run->uv_step[i];
    }
    run->z = qtri_ramp_at(&job->depth, run->x - job->anchor_x, w->y - job->anchor_y);
    job->draw_run(job, run);
}

/* From x to end, exact at both, in as many runs as it takes; `extra` pixels from end on. */
static void draw_block(const qtri_job *job, const window *w, qtri_run *run, sample *from,
                       const sample *to, int32_t x, int32_t end, int32_t extra)
{
    int32_t length = run_length(job, from, to, end - x);
    while (x < end) {
        int32_t next = x + length < end ? x + length : end;
        sample middle = *to;
        if (next < end) {
            sample_at(&middle, job, w, next);
        }
        draw_run(job, w, run, from, &middle, x, next - x, next - x + (next == end ? extra : 0));
        *from = middle;
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
 * Texture coordinates where w does not change along the row, as on floors and walls: linear as they
 * are. False for spans so long that a step's last bit adds up to more than 2^-10 of a texel.
 */
static bool level_span(const qtri_job *job, const window *w, qtri_run *run, int32_t left,
                       int32_t right)
{
    for (int i = 0; i < 2; i++) {
        int32_t shift = job->axis[i].shift + job->uv_up[i] - 10;
        if (shift < 0 || (right - left) >> shift != 0) {
            return false;
        }
    }
    uint32_t q;
    divider d = divider_for(qtri_plane_at(&job->inv_w, left, w->y), &q);
    for (int i = 0; i < 2; i++) {
        int32_t up = job->uv_up[i];
        int32_t start = coordinate(qtri_plane_at(&job->uv[i], left, w->y), &d);
        run->uv_step[i] = divide_step(job->uv[i].dx, &d, up);
        run->uv[i] = scaled((uint32_t)start + job->axis[i].bias, up) +
                     (uint32_t)(w->x0 - left) * run->uv_step[i];
    }
    run->x = w->x0;
    run->count = w->x1 - w->x0;
    run->z = qtri_ramp_at(&job->depth, run->x - job->anchor_x, w->y - job->anchor_y);
    job->draw_run(job, run);
    return true;
}

/*
 * The whole span in equal runs where w changes little, else in blocks. The span's last pixel is
 * always divided exactly, and drawn by the run that aims at it.
 */
static void perspective_span(const qtri_job *job, window *w, qtri_run *run, int32_t left,
                             int32_t right)
{
    int32_t last = right - 1;
    if (job->inv_w.dx == 0 && !qtri_job_is_smooth(job) && level_span(job, w, run, left, right)) {
        return;
    }
    sample from = {0, {0, 0, 0}, {0, 0}};
    sample to = from;
    window_planes(w, job);
    sample_at(&from, job, w, left);
    if (last == left) {
        draw_run(job, w, run, &from, &from, left, 1, 1);
        return;
    }
    sample_at(&to, job, w, last);
    int32_t block = run_length(job, &from, &to, last - left);
    if (block == last - left) {
        draw_run(job, w, run, &from, &to, left, block, block + 1);
        return;
    }
    block = block < BLOCK ? BLOCK : block;
    /* Unsigned: without an instruction that divides, that is the function linked anyway. */
    int32_t x = left + (int32_t)((uint32_t)(w->x0 - left) / (uint32_t)block * (uint32_t)block);
    if (x == last) {
        x -= block; /* the last pixel belongs to the run before it */
    }
    if (x > left) {
        sample_at(&from, job, w, x);
    }
    for (; x < w->x1 && x < last; x += block) {
        int32_t end = last;
        sample next = to;
        if (x + block < last) {
            end = x + block;
            sample_at(&next, job, w, end);
        }
        draw_block(job, w, run, &from, &next, x, end, end == last);
    }
}

static void linear_colors(const qtri_job *job, int32_t y, qtri_run *run)
{
    int32_t dx = run->x - job->anchor_x;
    int32_t dy = y - job->anchor_y;
    for (int i = 0; i < 3; i++) {
        run->color[i] = qtri_ramp_at(&job->color.ramp[i], dx, dy);
        run->color_step[i] = job->color.ramp[i].dx;
    }
}

/* Everything is linear: one run, of which the place is known, and uv. */
static inline void linear_run(const qtri_job *job, int32_t y, qtri_run *run)
{
    if (qtri_job_is_smooth(job)) {
        linear_colors(job, y, run);
    }
    run->z = qtri_ramp_at(&job->depth, run->x - job->anchor_x, y - job->anchor_y);
    job->draw_run(job, run);
}

/* Linear colours in RGB565: they start anew every QTRI_PACKED_RUN pixels, see packed.h. */
static void packed_span(const qtri_job *job, const window *w, qtri_run *run, int32_t left)
{
    int32_t dy = w->y - job->anchor_y;
    run->x = w->x0;
    run->is_packed = true;
    while (run->x < w->x1) {
        int32_t dx = run->x - job->anchor_x;
        int32_t rest = w->x1 - run->x;
        int32_t phase = job->tiny ? 0 : (run->x - left) % QTRI_PACKED_RUN;
        run->count = job->tiny || rest < QTRI_PACKED_RUN - phase ? rest : QTRI_PACKED_RUN - phase;
        run->z = qtri_ramp_at(&job->depth, dx, dy);
        run->phase = phase;
        run->packed =
            job->tiny ? qtri_packed_tiny(job, dx, dy) : qtri_packed_start(job, dx - phase, dy);
        qtri_run_generic(job, run);
        run->x += run->count;
    }
}

/*
 * The pixels of row y that lie in x0..x1-1, inside the bounds, of a span that covers left..right-1.
 * Where the exact divisions fall depends on left and right alone, so that a scissor does not change
 * a pixel.
 */
static void span(const qtri_job *job, int32_t y, int32_t left, int32_t right, int32_t x0,
                 int32_t x1)
{
    const qtri_surface *surface = job->raster->surface;
    ptrdiff_t row = y - surface->first_row;
    window w;
    qtri_run run;
    w.y = y;
    w.x0 = x0;
    w.x1 = x1;
    run.is_packed = false;
    run.pixels = surface->pixels + row * surface->pitch;
    run.depths =
        job->raster->compare == QTRI_DEPTH_OFF ? NULL : surface->depth + row * surface->depth_pitch;
    if (qtri_job_is_perspective(job)) {
        perspective_span(job, &w, &run, left, right);
    } else if (qtri_job_is_smooth(job) && qtri_format_of(surface) == QTRI_RGB565) {
        packed_span(job, &w, &run, left);
    } else {
        run.x = x0;
        run.count = x1 - x0;
        linear_run(job, y, &run);
    }
}

void qtri_fill_spans(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count)
{
    for (; count > 0; count--, row++, spans++) {
        int32_t x;
        int32_t pixels = qtri_span_clip(spans, &job->raster->bounds, &x);
        if (pixels > 0) {
            span(job, row, spans->left, spans->right, x, x + pixels);
        }
    }
}

/* Axis i at column x of a row, `row` being its plane at column 0 with the bias. */
static inline uint32_t linear_coordinate(const qtri_job *job, int i, uint64_t row, int32_t x)
{
    uint32_t value = (uint32_t)qtri_plane_floor(column_of(row, job->uv[i].dx, x));
    return scaled(value, job->uv_up[i]);
}

/*
 * Texture coordinates linear on the screen: they fill their 32 bits, so that steps lose what a long
 * run would show. They start anew from their planes: every 64 pixels, or, where copied texels leave
 * 2^-17 of a texel and less to the last bit, every 512.
 */
void qtri_fill_textured(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count)
{
    const qtri_raster *raster = job->raster;
    const qtri_surface *surface = raster->surface;
    const int32_t length = qtri_job_copies_texels(job) ? 512 : 64;
    const bool tested = raster->compare != QTRI_DEPTH_OFF;
    const qtri_lines lines = qtri_lines_at(surface, row);
    uint64_t uv[2];
    qtri_run run;
    run.pixels = lines.pixels;
    run.depths = tested ? lines.depths : NULL;
    run.is_packed = false;
    for (int i = 0; i < 2; i++) {
        uv[i] = row_of(&job->uv[i], row) + ((uint64_t)job->axis[i].bias << 16);
        run.uv_step[i] = plane_step(job->uv[i].dx, job->uv_up[i]);
    }
    for (const qtri_span *end = spans + count; spans < end; spans++, row++) {
        int32_t x0;
        int32_t rest = qtri_span_clip(spans, &raster->bounds, &x0);
        int32_t skip = (x0 - spans->left) & (length - 1);
        for (run.x = x0; rest > 0; run.x += run.count) {
            int32_t x = run.x - skip;
            run.count = length - skip < rest ? length - skip : rest;
            run.uv[0] = linear_coordinate(job, 0, uv[0], x) + (uint32_t)skip * run.uv_step[0];
            run.uv[1] = linear_coordinate(job, 1, uv[1], x) + (uint32_t)skip * run.uv_step[1];
            linear_run(job, row, &run);
            rest -= run.count;
            skip = 0;
        }
        uv[0] += job->uv[0].dy;
        uv[1] += job->uv[1].dy;
        run.pixels += surface->pitch;
        run.depths += tested ? surface->depth_pitch : 0;
    }
}
