#include "span.h"

enum { BLOCK = 16 }; /* pixels from one exact division to the next, at most */

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

/*
 * (a/w) / (1/w): 1/w is q 2^-31 with q in 1..2^31, normalised to 32 bits for the reciprocal;
 * s 2^31 / q = s r 2^(zeros - 31), |s| < 2^31, r <= 2^31.
 */
typedef struct divider {
    uint32_t reciprocal;
    int32_t shift;
} divider;

static uint32_t inv_w_at(const qtri_span_job *job, int32_t x, int32_t y)
{
    int64_t q = qtri_plane_floor(qtri_plane_at(&job->inv_w, x, y));
    return q < 1 ? 1u : (q > (int64_t)1 << 31 ? (uint32_t)1 << 31 : (uint32_t)q);
}

static int64_t divide(const qtri_span_job *job, int attribute, const divider *d, int32_t x,
                      int32_t y)
{
    int64_t s = qtri_plane_floor(qtri_plane_at(&job->attribute[attribute], x, y));
    s = hold(s, 0, INT32_MAX); /* a rounding below 0 at most */
    return (s * d->reciprocal) >> d->shift;
}

static void sample_at(sample *out, const qtri_span_job *job, int32_t x, int32_t y)
{
    out->q = inv_w_at(job, x, y);
    int32_t zeros = qtri_clz32(out->q);
    divider d = {qtri_reciprocal_q62(out->q << zeros), 31 - zeros};
    for (int i = 0; i < 3 && job->smooth; i++) {
        int64_t c = divide(job, i, &d, x, y) >> QTRI_COLOR_PERSPECTIVE_SHIFT;
        out->color[i] = hold(c, job->least[i], job->greatest[i]);
    }
    for (int i = 0; i < 2 && job->texture != NULL; i++) {
        out->uv[i] = hold(divide(job, 3 + i, &d, x, y), 0, INT32_MAX);
    }
}

static uint64_t difference(int32_t a, int32_t b)
{
    return (uint64_t)(a < b ? (int64_t)b - a : (int64_t)a - b);
}

/*
 * How many pixels a run between a and b, `distance` pixels apart, may have: the power of two, up to
 * BLOCK, for which linear interpolation strays by less than 1/32 of a colour step and 1/1024 of a
 * texel.
 *
 * f = s/q has f' = k/q^2 with a constant k, and f'' = -2 k q'/q^3. Over a run of h out of L pixels
 * the chord strays by at most h^2/8 max|f''| = (h/L)^2 |f(b) - f(a)| |q(b) - q(a)| m / (4 n^2),
 * n and m being the least and greatest q. Where m < 2 n, m / n counts as 2; elsewhere every pixel
 * is divided.
 */
static int32_t run_length(const qtri_span_job *job, const sample *a, const sample *b,
                          int32_t distance)
{
    uint64_t q_least = a->q < b->q ? a->q : b->q; /* <= 2^31 */
    uint64_t q_difference = a->q < b->q ? b->q - a->q : a->q - b->q;
    int32_t length = BLOCK;
    while (length / 2 >= distance) {
        length /= 2; /* one run: the h = L of the bound */
    }
    length = q_difference < q_least ? length : 1;
    for (int i = 0; i < 3 && job->smooth; i++) {
        uint64_t error = difference(a->color[i], b->color[i]) * q_difference; /* < 2^55 */
        for (; length > 1 && error > q_least << 12; length /= 2) {
            q_least <<= 2;
        }
    }
    for (int i = 0; i < 2 && job->texture != NULL; i++) {
        uint64_t error = difference(a->uv[i], b->uv[i]) * q_difference; /* < 2^62 */
        int32_t texel = job->axis[i].shift - 9;                         /* -7..20 */
        for (; length > 1; length /= 2) {
            if (error <= (texel >= 0 ? q_least << texel : q_least >> -texel)) {
                break;
            }
            q_least <<= 2; /* <= 2^39 in the end */
        }
    }
    return length;
}

/* One pixel's step on the way from a to b, `length` (1..BLOCK) pixels apart. */
static uint32_t step_of(int32_t a, int32_t b, int32_t length)
{
    static const int32_t inverse_q30[BLOCK + 1] = {
        0,         1073741824, 536870912, 357913941, 268435456, 214748365,
        178956971, 153391689,  134217728, 119304647, 107374182, 97612893,
        89478485,  82595525,   76695845,  71582788,  67108864};
    return (uint32_t)((((int64_t)b - a) * inverse_q30[length]) >> 30);
}

/* Which part of a span is drawn. */
typedef struct window {
    int32_t y, x0, x1;
} window;

/* Draws what the window shows of a run that starts at a and aims at b, `length` pixels on. */
static void draw_run(const qtri_span_job *job, const window *w, qtri_run *run, const sample *a,
                     const sample *b, int32_t x, int32_t length, int32_t count)
{
    int32_t skip = x < w->x0 ? w->x0 - x : 0;
    int32_t end = x + count < w->x1 ? x + count : w->x1;
    run->x = x + skip;
    run->count = end - run->x;
    if (run->count <= 0) {
        return;
    }
    for (int i = 0; i < 3 && job->smooth; i++) {
        run->color_step[i] = step_of(a->color[i], b->color[i], length);
        run->color[i] = (uint32_t)a->color[i] + 0x8000u + (uint32_t)skip * run->color_step[i];
    }
    for (int i = 0; i < 2 && job->texture != NULL; i++) {
        run->uv_step[i] = step_of(a->uv[i], b->uv[i], length);
        run->uv[i] = (uint32_t)a->uv[i] + job->axis[i].bias + (uint32_t)skip * run->uv_step[i];
    }
    run->z = qtri_ramp_at(&job->depth, run->x - job->anchor_x, w->y - job->anchor_y);
    job->loop(job, run);
}

/* From one exact division to the next; the span's last pixel is always one of them. */
static void perspective_span(const qtri_span_job *job, const window *w, qtri_run *run, int32_t left,
                             int32_t right)
{
    int32_t last = right - 1;
    int32_t x = left + (w->x0 - left) / BLOCK * BLOCK;
    if (x == last && x > left) {
        x -= BLOCK; /* the last pixel belongs to the run before it */
    }
    sample from;
    sample_at(&from, job, x, w->y);
    while (x < w->x1) {
        int32_t end = x + BLOCK < last ? x + BLOCK : last;
        if (end <= x) { /* the last pixel alone */
            draw_run(job, w, run, &from, &from, x, 1, 1);
            break;
        }
        sample to;
        sample_at(&to, job, end, w->y);
        int32_t length = run_length(job, &from, &to, end - x);
        while (x < end) {
            int32_t next = x + length < end ? x + length : end;
            sample middle = to;
            if (next < end) {
                sample_at(&middle, job, next, w->y);
            }
            /* The last run takes the pixel that it aims at along. */
            draw_run(job, w, run, &from, &middle, x, next - x, next - x + (next == last));
            from = middle;
            x = next;
        }
        if (x == last) {
            break;
        }
    }
}

/* Everything is linear: one run. */
static void linear_span(const qtri_span_job *job, const window *w, qtri_run *run)
{
    int32_t dx = w->x0 - job->anchor_x;
    int32_t dy = w->y - job->anchor_y;
    run->x = w->x0;
    run->count = w->x1 - w->x0;
    run->z = qtri_ramp_at(&job->depth, dx, dy);
    for (int i = 0; i < 3 && job->smooth; i++) {
        run->color[i] = qtri_ramp_at(&job->ramp[i], dx, dy);
        run->color_step[i] = job->ramp[i].dx;
    }
    job->loop(job, run);
}

/*
 * Texture coordinates linear on the screen: they fill their 32 bits, so that steps lose what a long
 * run would show. They start anew from their planes every 64 pixels.
 */
static void linear_textured_span(const qtri_span_job *job, const window *w, qtri_run *run,
                                 int32_t left)
{
    enum { RUN = 64 };
    int32_t x = left + (w->x0 - left) / RUN * RUN;
    for (; x < w->x1; x += RUN) {
        window part = {w->y, x < w->x0 ? w->x0 : x, x + RUN < w->x1 ? x + RUN : w->x1};
        for (int i = 0; i < 2; i++) {
            const qtri_plane *plane = &job->attribute[3 + i];
            uint32_t start = (uint32_t)qtri_plane_floor(qtri_plane_at(plane, x, w->y));
            run->uv_step[i] = (uint32_t)qtri_plane_floor(plane->dx + 0x8000u);
            run->uv[i] = start + job->axis[i].bias + (uint32_t)(part.x0 - x) * run->uv_step[i];
        }
        linear_span(job, &part, run);
    }
}

void qtri_span(const qtri_span_job *job, int32_t y, int32_t left, int32_t right, int32_t x0,
               int32_t x1)
{
    const qtri_surface *surface = job->surface;
    ptrdiff_t row = y - surface->first_row;
    window w = {y, x0, x1};
    qtri_run run;
    run.pixels = surface->pixels + row * surface->pitch;
    run.depths =
        job->compare == QTRI_DEPTH_OFF ? NULL : surface->depth + row * surface->depth_pitch;
    if (job->paint == QTRI_PAINT_PERSPECTIVE) {
        perspective_span(job, &w, &run, left, right);
    } else if (job->texture != NULL) {
        linear_textured_span(job, &w, &run, left);
    } else {
        linear_span(job, &w, &run);
    }
}
