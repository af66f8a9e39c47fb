#include "span.h"

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

static void window_planes(window *w, const qtri_job *job)
{
    for (int i = 0; i < 3; i++) {
        w->color[i] = 0;
    }
    w->uv[0] = w->uv[1] = 0;
    w->inv_w = qtri_plane_row(&job->inv_w, w->y);
    if (qtri_raster_texture(job->raster) != NULL) {
        w->uv[0] = qtri_plane_row(&job->uv[0], w->y);
        w->uv[1] = qtri_plane_row(&job->uv[1], w->y);
    }
    if (qtri_job_is_smooth(job)) {
        for (int i = 0; i < 3; i++) {
            w->color[i] = qtri_plane_row(&job->color.plane[i], w->y);
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
    divider d = divider_for(qtri_plane_column(w->inv_w, job->inv_w.dx, x), &out->q);
    if (qtri_job_is_smooth(job)) {
        for (int i = 0; i < 3; i++) {
            uint64_t over_w = qtri_plane_column(w->color[i], job->color.plane[i].dx, x);
            int64_t c = divide(over_w, &d) >> QTRI_COLOR_PERSPECTIVE_SHIFT;
            out->color[i] = hold(c, job->least[i], job->greatest[i]);
        }
    }
    if (qtri_raster_texture(job->raster) != NULL) {
        for (int i = 0; i < 2; i++) {
            out->uv[i] = coordinate(qtri_plane_column(w->uv[i], job->uv[i].dx, x), &d);
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
    uint32_t pixels = length > 1 ? (uint32_t)length : 1;
    int32_t zeros = qtri_clz32(pixels);
    inverse result = {qtri_reciprocal_q62(pixels << zeros), zeros};
    return result;
}

/* One pixel's step on the way from a to b, times 2^up, up in -30..20. */
static uint32_t step_of(int32_t a, int32_t b, const inverse *length, int32_t up)
{
    uint64_t size = difference(a, b) * length->reciprocal; /* < 2^62 */
    uint32_t step = (uint32_t)(size >> (62 - length->zeros - up));
    return a < b ? step : 0 - step;
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
        run->uv[i] = qtri_run_scaled((uint32_t)a->uv[i] + job->axis[i].bias, up) +
                     (uint32_t)skip * run->uv_step[i];
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
        run->uv[i] = qtri_run_scaled((uint32_t)start + job->axis[i].bias, up) +
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
void qtri_span_perspective(const qtri_job *job, qtri_run *run, int32_t y, const qtri_span *span,
                           int32_t x0, int32_t x1)
{
    const int32_t left = span->left;
    const int32_t last = span->right - 1;
    window w;
    w.y = y;
    w.x0 = x0;
    w.x1 = x1;
    if (job->inv_w.dx == 0 && !qtri_job_is_smooth(job) &&
        level_span(job, &w, run, left, span->right)) {
        return;
    }
    sample from = {0, {0, 0, 0}, {0, 0}};
    sample to = from;
    window_planes(&w, job);
    sample_at(&from, job, &w, left);
    if (last == left) {
        draw_run(job, &w, run, &from, &from, left, 1, 1);
        return;
    }
    sample_at(&to, job, &w, last);
    int32_t block = run_length(job, &from, &to, last - left);
    if (block == last - left) {
        draw_run(job, &w, run, &from, &to, left, block, block + 1);
        return;
    }
    block = block < BLOCK ? BLOCK : block;
    /* Unsigned: without an instruction that divides, that is the function linked anyway. */
    int32_t x = left + (int32_t)((uint32_t)(w.x0 - left) / (uint32_t)block * (uint32_t)block);
    if (x == last) {
        x -= block; /* the last pixel belongs to the run before it */
    }
    if (x > left) {
        sample_at(&from, job, &w, x);
    }
    for (; x < w.x1 && x < last; x += block) {
        int32_t end = last;
        sample next = to;
        if (x + block < last) {
            end = x + block;
            sample_at(&next, job, &w, end);
        }
        draw_block(job, &w, run, &from, &next, x, end, end == last);
    }
}
