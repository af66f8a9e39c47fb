/*
 * Rows with perspective: an attribute a is s / q of two that are linear on the screen, q = 1/w being
 * 1 at the vertex nearest to the eye. One reciprocal serves a block of up to 32 pixels: d pixels
 * from its middle m
 *
 *     a = a_m + L (d - e d^2 + e^2 d^3 - ...),   L = K / q^2,   e = q' / q,   K = s' q - s q'
 *
 * where K does not change along a row, and is linear in y. A block reaches h pixels to both sides;
 * with E = e h, x = d / h the cubic term is L h E^2 x^3, which 3/4 x replaces with an error of 1/4.
 * The term after it, L h E^3 x^4, is x^2 with one of 1/8 and a constant of as much. So a curve of
 * second order,
 *
 *     a_m + L (1 + 3/4 E^2) d - L e (1 + E^2) d^2,
 *
 * is off by L h E^2 (1/4 + E/4 + E^2 / (1 - E)). It is to be less than 1/256 of a texel, or of what
 * a pixel steps by where that is more. Blocks are halved until q in the middle is great enough for
 * it: E <= 1/4, and h E^2 <= 1/80 or K h^3 q'^2 / q^4 <= 1/80, where K is the greatest of the
 * triangle. Colours have only the second form, in units of their own.
 *
 * Blocks begin at a chunk's start, 32 pixels apart from the span's left end, plus multiples of
 * their length, and q at their start decides: pixels do not depend on scissor or band.
 */
#include "perspective.h"

#include "linear.h"

/* Planes are times 2^16 more in a row's at[]: the high word is what blocks read. */
static inline uint32_t high_word(uint64_t value)
{
    return (uint32_t)(value >> 32);
}

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
 * s 2^32 / q = s r 2^(zeros - 30), s <= 2^31, r <= 2^31.
 */
typedef struct divider {
    uint32_t reciprocal;
    int32_t shift;
} divider;

static divider divider_for(uint64_t inv_w)
{
    uint32_t exact = held(inv_w);
    uint32_t q = exact == 0 ? 1 : exact;
    int32_t zeros = qtri_clz32(q);
    divider d = {qtri_reciprocal_q62(q << zeros), 30 - zeros};
    return d;
}

/*
 * dx r / 2^down for a plane's dx, in 2^-16: 16 bits of it and the rest. Over a span of two pixels
 * and more |dx| < 2^47, since the attribute stays below 2^31; one pixel takes no step.
 */
static uint32_t divide_step(uint64_t dx, const divider *d, int32_t up)
{
    int32_t down = d->shift - up; /* -21..42 */
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

/* The one division of a row along which w does not change. */
static void begin_level(qtri_scanline *row)
{
    const qtri_job *job = row->job;
    const divider d = divider_for(row->plane[job->end]);
    row->run = row->left;
    for (int i = 0; i < 2; i++) {
        const qtri_plane *plane = &job->attribute[QTRI_U + i].plane;
        const qtri_texel_axis *axis = &job->axis[i];
        const uint32_t s = held(qtri_plane_column(row->plane[QTRI_U + i], plane->dx, row->left));
        const uint64_t product = qtri_mul_u32(s, d.reciprocal);
        const int32_t value =
            qtri_saturate32((int64_t)(d.shift >= 0 ? product >> d.shift : product << -d.shift));
        row->uv[i].at = qtri_run_scaled((uint32_t)value + axis->bias, axis->up);
        row->uv[i].step = divide_step(plane->dx, &d, axis->up);
    }
}

void qtri_perspective_begin(qtri_scanline *row)
{
    const qtri_job *job = row->job;
    for (int i = job->first; i <= job->end; i++) {
        row->plane[i] = qtri_plane_row(&job->attribute[i].plane, row->y);
    }
    for (int i = job->first; i < job->end; i++) {
        const qtri_projected *a = &job->more.perspective.attribute[i];
        row->slope[i] = a->slope + (uint32_t)row->y * a->slope_dy;
    }
}

void qtri_perspective_next(qtri_scanline *row)
{
    const qtri_job *job = row->job;
    for (int i = job->first; i < job->end; i++) {
        row->plane[i] += job->attribute[i].plane.dy;
        row->slope[i] += job->more.perspective.attribute[i].slope_dy;
    }
    row->plane[job->end] += job->attribute[job->end].plane.dy;
}

void qtri_perspective_row(qtri_scanline *row)
{
    row->level = row->right - row->left < level_pixels(row->job);
    row->chunk = INT32_MIN;
    if (row->level) {
        begin_level(row);
    }
}

/* Planes at a chunk's first pixel. */
static void begin_chunk(qtri_scanline *row, int32_t x)
{
    const qtri_job *job = row->job;
    for (int i = job->first; i <= job->end; i++) {
        const uint64_t dx = job->attribute[i].plane.dx;
        row->at[i] = x == row->chunk + QTRI_BATCH
                         ? row->at[i] + (dx << 21)
                         : qtri_plane_column(row->plane[i], dx, x) << 16;
    }
    row->chunk = x;
}

/* x 2^-shift, rounded down, modulo 2^32; -31..31. */
static inline uint32_t shifted(int32_t x, int32_t shift)
{
    return shift >= 0 ? (uint32_t)(x >> shift) : (uint32_t)x << -shift;
}

/* The same to nearest, -30..32. */
static inline uint32_t rounded(int32_t x, int32_t shift)
{
    return shift > 0 ? (uint32_t)(((x >> (shift - 1)) + 1) >> 1) : (uint32_t)x << -shift;
}

/* A block's middle. */
typedef struct middle {
    int32_t from_chunk;
    uint32_t reciprocal; /* 2^62 / (q 2^zeros) */
    int32_t zeros;
    int32_t square; /* 15 bits of the reciprocal's square, times 2^-odd */
    int32_t odd;
    int32_t curved_q16; /* e 2^log2 / 2 */
    int32_t squared_q16; /* and its square */
} middle;

static void set_middle(middle *m, const qtri_scanline *row, int32_t x, int32_t log2)
{
    const qtri_perspective *p = &row->job->more.perspective;
    uint32_t q = high_word(row->at[row->job->end]) + (uint32_t)x * p->dx;
    q = q - 1 < 0xC0000000u ? q : 1;
    m->from_chunk = x;
    m->zeros = qtri_clz32(q);
    m->reciprocal = qtri_reciprocal_near(q << m->zeros);
    if (log2 == 0) {
        return;
    }
    const uint32_t y_q15 = m->reciprocal >> 16; /* 2^14..2^15 */
    uint32_t square = y_q15 * y_q15 + ((y_q15 * qtri_low16(m->reciprocal)) >> 15); /* 2^28..2^30 */
    m->odd = square >> 29 == 0;
    square = ((square << m->odd) + 0x4000u) >> 15;
    m->square = (int32_t)(square - (square >> 15));
    /* |e| h <= 1/3: the middle may be nearer to the start than where the limit was tested. */
    const int32_t down = -(p->slope_exponent + m->zeros + log2);
    m->curved_q16 = (p->slope * (int32_t)y_q15) >> (down > 31 ? 31 : down);
    m->squared_q16 = (m->curved_q16 * m->curved_q16) >> 16;
}

int32_t qtri_interpolate_perspective(qtri_scanline *row, int32_t x, int32_t count, int first,
                                     int end, qtri_curve *out)
{
    if (row->level) {
        return qtri_interpolate_linear(row, x, count, first, end, out);
    }
    const qtri_perspective *p = &row->job->more.perspective;
    const int32_t from = (x - row->left) & (QTRI_BATCH - 1);
    if (row->chunk != x - from) {
        begin_chunk(row, x - from);
    }
    const uint32_t *limits = first < QTRI_U ? p->colors : p->texels;
    const uint32_t q = high_word(row->at[row->job->end]) + (uint32_t)from * p->dx;
    const int32_t rest = qtri_least32(row->right - x, QTRI_BATCH - from);
    int32_t log2 = QTRI_BLOCK_LOG2;
    while (log2 > 0 && ((from & (((int32_t)1 << log2) - 1)) != 0 ||
                        (int32_t)1 << (log2 - 1) >= rest || q < limits[log2 - 1])) {
        log2--;
    }
    const int32_t length = qtri_least32((int32_t)1 << log2, rest);
    const int32_t half = length >> 1;
    middle m;
    set_middle(&m, row, from + half, log2);
    for (int i = first; i < end; i++, out++) {
        const qtri_projected *a = &p->attribute[i];
        const uint32_t s = high_word(row->at[i]) + (uint32_t)m.from_chunk * a->dx;
        uint32_t value =
            (uint32_t)qtri_mul_high_s31((int32_t)(s << m.zeros), m.reciprocal) << 2;
        if (i < QTRI_U) {
            value = (uint32_t)qtri_hold32((int32_t)value >> QTRI_COLOR_PERSPECTIVE_SHIFT,
                                          p->least[i], p->greatest[i]) +
                    a->bias;
        } else {
            value = qtri_run_scaled(value + a->bias, a->up);
        }
        uint32_t slope = 0;
        uint32_t bend = 0; /* of L e */
        if (log2 != 0) {
            const int32_t down = a->down - 2 * m.zeros + m.odd;
            int32_t l = qtri_mul_s16((int32_t)row->slope[i], m.square);
            l += qtri_mul_s16(l, 3 * m.squared_q16 >> 2);
            const int32_t e = m.curved_q16 + ((m.curved_q16 * m.squared_q16) >> 18);
            bend = rounded(qtri_mul_s16(l, e), down + log2 - 1);
            slope = shifted(l, down);
        }
        const uint32_t arc = bend * (uint32_t)half;
        out->at = value - (slope + arc) * (uint32_t)half;
        out->step = slope + 2 * arc - bend;
        out->bend = 0 - 2 * bend;
    }
    return qtri_least32(length, count);
}
