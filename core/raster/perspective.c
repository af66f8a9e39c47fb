#include "perspective.h"

#include "linear.h"

enum { BLOCK = 8 };

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
static int32_t divided(const qtri_job *job, const qtri_scanline *row, int i, int32_t x, const divider *d)
{
    uint32_t s = held(qtri_plane_column(row->plane[i], job->attribute[i].plane.dx, x));
    return qtri_saturate32((int64_t)(qtri_mul_u32(s, d->reciprocal) >> d->shift));
}


/* Attribute i at column x, as curves have it. */
static uint32_t exact(const qtri_job *job, const qtri_scanline *row, int i, int32_t x, const divider *d)
{
    int32_t value = divided(job, row, i, x, d);
    if (i < QTRI_U) {
        return (uint32_t)qtri_hold32(value >> QTRI_COLOR_PERSPECTIVE_SHIFT,
                                     job->color.range.least[i], job->color.range.greatest[i]) +
               0x8000u;
    }
    const qtri_texel_axis *axis = &job->axis[i - QTRI_U];
    return qtri_run_scaled((uint32_t)value + axis->bias, axis->up);
}

int32_t qtri_interpolate_perspective(qtri_scanline *row, int32_t x, int32_t count, int first, int end,
                                     qtri_curve *out)
{
    if (row->level) {
        return qtri_interpolate_linear(row, x, count, first, end, out);
    }
    const qtri_job *job = row->job;
    const uint64_t dx = job->attribute[job->end].plane.dx;
    uint32_t q;
    const int32_t to = qtri_least32(x + BLOCK, row->right - 1);
    const divider a = divider_for(qtri_plane_column(row->plane[job->end], dx, x), &q);
    const divider b = divider_for(qtri_plane_column(row->plane[job->end], dx, to), &q);
    for (int i = first; i < end; i++, out++) {
        out->at = exact(job, row, i, x, &a);
        out->step = to == x ? 0 : (uint32_t)((int32_t)(exact(job, row, i, to, &b) - out->at) / (to - x));
        out->bend = 0;
    }
    return qtri_least32(count, BLOCK);
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
    if (job->attribute[job->end].plane.dx != 0 || job->first != QTRI_U) {
        return 0;
    }
    int32_t bits = 16;
    for (int i = QTRI_U; i < job->end; i++) {
        const qtri_texel_axis *axis = &job->axis[i - QTRI_U];
        bits = qtri_least32(bits, axis->shift + axis->up - 10);
    }
    return bits < 0 ? 0 : (int32_t)1 << bits;
}


void qtri_perspective_begin(qtri_scanline *row)
{
    const qtri_job *job = row->job;
    for (int i = job->first; i <= job->end; i++) {
        row->plane[i] = qtri_plane_row(&job->attribute[i].plane, row->y);
    }
}

void qtri_perspective_row(qtri_scanline *row)
{
    const qtri_job *job = row->job;
    row->level = row->right - row->left < level_pixels(job);
    if (!row->level) {
        return;
    }
    uint32_t q;
    const divider d = divider_for(row->plane[job->end], &q);
    row->run = row->left;
    for (int i = 0; i < 2; i++) {
        row->uv[i].at = exact(job, row, QTRI_U + i, row->left, &d);
        row->uv[i].step =
            divide_step(job->attribute[QTRI_U + i].plane.dx, &d, job->axis[i].up);
    }
}
