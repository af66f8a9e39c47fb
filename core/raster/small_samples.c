/* SPDX-License-Identifier: MIT */
/*
 * Small triangles on surfaces with four samples a pixel: which samples are covered, exactly, by the
 * top-left rule.
 *
 * Quarter rows count from the top of vertex 0's row; sample k of a row is quarter k, its y 64 q +
 * 32. Where an edge from (ax, ay) along (dx, dy) passes there, the first column whose sample is not
 * left of it is
 *
 *     floor(((ax + 128 - ox) dy + (64 q + 32 - ay) dx - 1) / (256 dy)),
 *
 * ox being the sample's, from the centre. Both products: below 31200 120 256 < 2^29.9.
 */
#include "qtri/body/small_samples.h"

enum { NO_LEFT = 0x7F7F7F7F };

static const int8_t offset_x[QTRI_CENTER] = {-32, 96, -96, 32};

/* A word of four columns, sample 0 in the low byte. */
static inline uint32_t word_of(const uint8_t *quarter)
{
    return (uint32_t)quarter[0] | (uint32_t)quarter[1] << 8 | (uint32_t)quarter[2] << 16 |
           (uint32_t)quarter[3] << 24;
}

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
enum { IS_LITTLE = 1 };
#else
enum { IS_LITTLE = 0 };
#endif

typedef struct quarters {
    uint8_t *left, *right; /* columns, from quarter 0 of vertex 0's row on */
} quarters;

/* The column of an edge in a quarter. */
/* NOLINTNEXTLINE(readability-non-const-parameter): they are written where nothing divides */
static inline int32_t edge_column(int32_t *numerator, int32_t *quotient, int32_t denominator)
{
#if QTRI_DIVIDE
    (void)quotient;
    return (int32_t)((uint32_t)*numerator / (uint32_t)denominator);
#else
    int32_t n = *numerator, q = *quotient;
    while (n < 0) {
        n += denominator;
        q--;
    }
    while (n >= denominator) {
        n -= denominator;
        q++;
    }
    *numerator = n;
    *quotient = q;
    return q;
#endif
}

/*
 * Stores columns of an edge in quarters from..stop - 1, going down; returns their sum. From sample
 * to sample ox changes by 128, -192, 128 and -64.
 */
static int32_t walk_edge(uint8_t *side, int32_t from, int32_t stop, int32_t dx, int32_t dy,
                         int32_t numerator)
{
    const int32_t down = 64 * dx, denominator = 256 * dy;
    const int32_t even = down - 128 * dy, one = down + 192 * dy, three = down + 64 * dy;
    const bool is_odd = (from & 1) != 0, is_low = (from & 2) != 0;
    const int32_t near = is_low ? three : one, far = is_low ? one : three;
    const int32_t s0 = is_odd ? near : even, s1 = is_odd ? even : near;
    const int32_t s2 = is_odd ? far : even, s3 = is_odd ? even : far;
    int32_t sum = 0, quotient = QTRI_SMALL_MIDDLE;
    uint8_t *at = side + from;
    const uint8_t *const end = side + stop;
    for (;;) {
        int32_t q = edge_column(&numerator, &quotient, denominator);
        *at++ = (uint8_t)q;
        sum += q;
        numerator += s0;
        if (at == end) {
            return sum;
        }
        q = edge_column(&numerator, &quotient, denominator);
        *at++ = (uint8_t)q;
        sum += q;
        numerator += s1;
        if (at == end) {
            return sum;
        }
        q = edge_column(&numerator, &quotient, denominator);
        *at++ = (uint8_t)q;
        sum += q;
        numerator += s2;
        if (at == end) {
            return sum;
        }
        q = edge_column(&numerator, &quotient, denominator);
        *at++ = (uint8_t)q;
        sum += q;
        numerator += s3;
        if (at == end) {
            return sum;
        }
    }
}

/* Stores an edge's columns between quarters: on the left when it goes down. */
static int32_t edge(const quarters *at, int32_t ax, int32_t ay, int32_t dx, int32_t dy,
                    int32_t from, int32_t to)
{
    if (from == to) {
        return 0;
    }
    uint8_t *side = at->left;
    const bool is_up = from > to;
    if (is_up) {
        const int32_t low = from;
        from = to;
        to = low;
        dx = -dx;
        dy = -dy;
        side = at->right;
    }
    const int32_t numerator = (ax - offset_x[from & 3]) * dy + (64 * from + 32 - ay) * dx - 1;
    const int32_t sum = walk_edge(side, from, to, dx, dy, numerator);
    return is_up ? sum : -sum;
}

/* Empties a row, whose quarters edges may not all reach. */
static void clear_row(qtri_small_samples *s, int32_t row)
{
    s->left[row] = NO_LEFT;
    s->right[row] = 0;
}

static bool set_depth(qtri_small_place *p, qtri_small_samples *s, const qtri_small *t)
{
    int32_t z1, z2, up;
    qtri_small_sampled z;
    if (!qtri_small_find_depth(&z1, &z2, &up, p, t)) {
        return false;
    }
    qtri_small_set_sampled(&z, p, t->v[0]->depth_16p8 >> 8 << 8, z1, z2, up);
    p->z = z.r;
    s->z_p = z.p;
    s->z_q = z.q;
    return true;
}

/* Clips quarters, which count from `row`, to the bounds. False: nothing is left. */
static bool clip_rows(int32_t quarter[3], int32_t *first, int32_t *end, int32_t row,
                      const qtri_rect *bounds)
{
    const int32_t least = (bounds->y0 - row) * 4, greatest = (bounds->y1 - row) * 4;
    if (*first >= greatest || *end <= least) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        quarter[i] = qtri_small_clamp(quarter[i], least, greatest);
    }
    *first = *first > least ? *first : least;
    *end = *end < greatest ? *end : greatest;
    return true;
}

qtri_small_found qtri_small_samples_find(qtri_small_place *p, qtri_small_samples *s, qtri_small *t)
{
    const int32_t x0 = t->v[0]->at.x_24p8, y0 = t->v[0]->at.y_24p8;
    int32_t dx1 = t->v[1]->at.x_24p8 - x0, dy1 = t->v[1]->at.y_24p8 - y0;
    int32_t dx2 = t->v[2]->at.x_24p8 - x0, dy2 = t->v[2]->at.y_24p8 - y0;
    const uint32_t near = QTRI_SMALL_NEAR;
    p->wide = false;
    p->turned = false;
    if ((((uint32_t)dx1 + near) | ((uint32_t)dy1 + near) | ((uint32_t)dx2 + near) |
         ((uint32_t)dy2 + near)) >= 2 * near) {
        if (qtri_small_is_far(dx1, dy1, dx2, dy2, QTRI_SMALL_MIDDLE)) {
            return QTRI_SMALL_IS_LARGE;
        }
        p->wide = true;
    }
    int32_t size = dx2 * dy1 - dx1 * dy2;
    if (size <= 0) {
        const int32_t dx = dx1, dy = dy1;
        if (!qtri_small_turn(t, size)) {
            return QTRI_SMALL_NOTHING;
        }
        p->turned = true;
        dx1 = dx2, dx2 = dx;
        dy1 = dy2, dy2 = dy;
        size = -size;
    }
    const int32_t row = y0 >> 8, rest_y = y0 & 255, rest_x = x0 & 255;
    int32_t quarter[3] = {(rest_y + 31) >> 6, (rest_y + dy1 + 31) >> 6, (rest_y + dy2 + 31) >> 6};
    int32_t first = quarter[0] + qtri_small_min0(quarter[1] - quarter[0], quarter[2] - quarter[0]);
    int32_t end = quarter[0] + qtri_small_max0(quarter[1] - quarter[0], quarter[2] - quarter[0]);
    if (first == end) {
        return QTRI_SMALL_NOTHING;
    }
    const qtri_draw_state *state = t->state;
    p->column = x0 >> 8;
    p->left = 0;
    p->right = 0;
    p->cut = false;
    if ((uint32_t)x0 - state->inner.x >= state->inner.width ||
        (uint32_t)y0 - state->inner.y >= state->inner.height) {
        const qtri_rect *bounds = &state->bounds;
        p->left = bounds->x0 - p->column + QTRI_SMALL_MIDDLE;
        p->right = bounds->x1 - p->column + QTRI_SMALL_MIDDLE;
        p->cut = p->left > 0 || p->right < QTRI_SMALL_ROWS;
        if (!clip_rows(quarter, &first, &end, row, bounds)) {
            return QTRI_SMALL_NOTHING;
        }
    }
    p->first = first >> 2;
    p->row = row + p->first;
    p->x = 128 - rest_x;
    p->y = 128 - rest_y + 256 * p->first;
    p->dx1 = dx1;
    p->dy1 = dy1;
    p->dx2 = dx2;
    p->dy2 = dy2;
    s->first = p->first + QTRI_SMALL_MIDDLE;
    s->rows = ((end + 3) >> 2) - p->first;
    clear_row(s, s->first);
    clear_row(s, s->first + s->rows - 1);
    const quarters at = {(uint8_t *)&s->left[QTRI_SMALL_MIDDLE],
                         (uint8_t *)&s->right[QTRI_SMALL_MIDDLE]};
    const int32_t ax = rest_x + 128 + (QTRI_DIVIDE ? 256 * QTRI_SMALL_MIDDLE : 0);
    const int32_t samples =
        edge(&at, ax, rest_y, dx1, dy1, quarter[0], quarter[1]) +
        edge(&at, ax + dx1, rest_y + dy1, dx2 - dx1, dy2 - dy1, quarter[1], quarter[2]) +
        edge(&at, ax, rest_y, -dx2, -dy2, quarter[2], quarter[0]);
    if (samples == 0) {
        return QTRI_SMALL_NOTHING;
    }
    if (!IS_LITTLE) {
        for (int32_t i = s->first; i < s->first + s->rows; i++) {
            s->left[i] = word_of((const uint8_t *)&s->left[i]);
            s->right[i] = word_of((const uint8_t *)&s->right[i]);
        }
    }
    return qtri_small_set_q(p, t) && qtri_small_set_inverse(p, (uint32_t)size) && set_depth(p, s, t)
               ? QTRI_SMALL_FOUND
               : QTRI_SMALL_IS_LARGE;
}

/* Clamps each byte of a word. */
static uint32_t clamp_bytes(uint32_t word, int32_t least, int32_t greatest)
{
    uint32_t out = 0;
    for (int k = 0; k < 32; k += 8) {
        out |= (uint32_t)qtri_small_clamp((int32_t)(word >> k & 255), least, greatest) << k;
    }
    return out;
}

void qtri_small_samples_cut(qtri_small_samples *s, int32_t left, int32_t right)
{
    const int32_t least = qtri_small_clamp(left, 0, 127),
                  greatest = qtri_small_clamp(right, 0, 127);
    for (int32_t i = s->first; i < s->first + s->rows; i++) {
        s->left[i] = clamp_bytes(s->left[i], least, greatest);
        s->right[i] = clamp_bytes(s->right[i], least, greatest);
    }
}

/* Edge functions at the pixel's centre: the third is what two leave of the area. */
bool qtri_small_covers_center(const qtri_small_place *p, int32_t column, int32_t row)
{
    const int32_t x = p->x + 256 * column, y = p->y + 256 * row;
    const int32_t size = p->dx2 * p->dy1 - p->dx1 * p->dy2;
    const int32_t a = x * p->dy1 - y * p->dx1;
    const int32_t c = y * p->dx2 - x * p->dy2;
    const int32_t b = size - a - c;
    const int32_t dx = p->dx2 - p->dx1, dy = p->dy2 - p->dy1;
    /* On an edge a centre is inside where that is a left or an upper one. */
    const int32_t a_least = p->dy1 > 0 || (p->dy1 == 0 && p->dx1 < 0) ? 0 : 1;
    const int32_t b_least = dy > 0 || (dy == 0 && dx < 0) ? 0 : 1;
    const int32_t c_least = p->dy2 < 0 || (p->dy2 == 0 && p->dx2 > 0) ? 0 : 1;
    return a >= a_least && b >= b_least && c >= c_least;
}

/* |gx| and |gy| are below 2^29.6: half the numerator's bound. */
void qtri_small_set_sampled(qtri_small_sampled *r, const qtri_small_place *p, uint32_t value,
                            int32_t f1, int32_t f2, int32_t up)
{
    const int32_t gx = qtri_small_quotient(p, f2 * p->dy1 - f1 * p->dy2);
    const int32_t gy = qtri_small_quotient(p, f1 * p->dx2 - f2 * p->dx1);
    const uint32_t at = qtri_small_along(gx, p->x, gy, p->y);
    up += p->up;
    r->r.at = value + (at << up);
    r->r.dx = (uint32_t)gx << up;
    r->r.dy = (uint32_t)gy << up;
    r->p = (uint32_t)(((gx >> 1) + 3 * (gy >> 1)) >> 2) << up;
    r->q = (uint32_t)((3 * (gx >> 1) - (gy >> 1)) >> 2) << up;
}
