/* SPDX-License-Identifier: MIT */
#include "stroke_cover.h"

#include "../io/xalloc.h"

#include <math.h>
#include <stdlib.h>

#define LINES 512

struct interval {
    double from, to;
};

/* What a level cuts of a part: of its rectangle and of the discs around its ends. */
struct cuts {
    struct interval of[3];
    size_t count;
};

static void add(struct cuts *cuts, double from, double to)
{
    if (from < to) {
        cuts->of[cuts->count].from = from;
        cuts->of[cuts->count++].to = to;
    }
}

static void add_disc(struct cuts *cuts, double x, double y, double radius, double at)
{
    double square = radius * radius - (at - y) * (at - y);
    if (square > 0.0)
        add(cuts, x - sqrt(square), x + sqrt(square));
}

/* The unit vector along a part; along x for one without a length. */
static double direction(const struct ref_stroke_part *part, double unit[2])
{
    double x = part->x1 - part->x0;
    double y = part->y1 - part->y0;
    double length = hypot(x, y);
    unit[0] = length > 0.0 ? x / length : 1.0;
    unit[1] = length > 0.0 ? y / length : 0.0;
    return length;
}

/* Narrows x to where low <= factor x + rest <= high. */
static void narrow(struct interval *interval, double factor, double rest, double low, double high)
{
    if (fabs(factor) < 1e-12) {
        if (rest < low || rest > high)
            interval->to = interval->from;
        return;
    }
    double a = (low - rest) / factor;
    double b = (high - rest) / factor;
    interval->from = fmax(interval->from, fmin(a, b));
    interval->to = fmin(interval->to, fmax(a, b));
}

/* The part on the level `at`. */
static struct cuts cut(const struct ref_stroke_part *part, double at)
{
    double unit[2];
    double length = direction(part, unit);
    double r = part->radius;
    double before = part->cap[0] == REF_CAP_SQUARE ? r : 0.0;
    double behind = part->cap[1] == REF_CAP_SQUARE ? r : 0.0;
    struct interval body = {-INFINITY, INFINITY};
    struct cuts all = {.count = 0};
    double dy = at - part->y0;
    /* Along: ux (x - x0) + uy dy; across: ux dy - uy (x - x0). */
    narrow(&body, unit[0], unit[1] * dy - unit[0] * part->x0, -before, length + behind);
    narrow(&body, -unit[1], unit[0] * dy + unit[1] * part->x0, -r, r);
    add(&all, body.from, body.to);
    if (part->cap[0] == REF_CAP_ROUND)
        add_disc(&all, part->x0, part->y0, r, at);
    if (part->cap[1] == REF_CAP_ROUND)
        add_disc(&all, part->x1, part->y1, r, at);
    return all;
}

static int by_from(const void *a, const void *b)
{
    const struct interval *first = a;
    const struct interval *second = b;
    return (first->from > second->from) - (first->from < second->from);
}

static void add_interval(double *share, int width, double from, double to)
{
    from = fmax(from, 0.0);
    to = fmin(to, width);
    for (int x = (int)from; x < width && x < to; x++)
        share[x] += (fmin(to, x + 1.0) - fmax(from, x)) / LINES;
}

void ref_stroke_cover_row(const struct ref_stroke_part *part, size_t count, int row, int width,
                          double *share)
{
    struct interval *all = xcalloc(3 * count, sizeof *all);
    for (int x = 0; x < width; x++)
        share[x] = 0.0;
    for (int line = 0; line < LINES; line++) {
        double at = row + (line + 0.5) / LINES;
        size_t found = 0;
        for (size_t i = 0; i < count; i++) {
            double reach = 1.5 * part[i].radius;
            if (at < fmin(part[i].y0, part[i].y1) - reach ||
                at > fmax(part[i].y0, part[i].y1) + reach)
                continue;
            struct cuts one = cut(&part[i], at);
            for (size_t k = 0; k < one.count; k++)
                all[found++] = one.of[k];
        }
        qsort(all, found, sizeof *all, by_from);
        for (size_t i = 0; i < found;) {
            struct interval joined = all[i++];
            for (; i < found && all[i].from <= joined.to; i++)
                joined.to = fmax(joined.to, all[i].to);
            add_interval(share, width, joined.from, joined.to);
        }
    }
    free(all);
}

bool ref_stroke_contains(const struct ref_stroke_part *part, size_t count, double x, double y)
{
    for (size_t i = 0; i < count; i++) {
        struct cuts one = cut(&part[i], y);
        for (size_t k = 0; k < one.count; k++) {
            if (x >= one.of[k].from && x < one.of[k].to)
                return true;
        }
    }
    return false;
}

size_t ref_stroke_nearest(const struct ref_stroke_part *part, size_t count, double x, double y,
                          double *along, double *distance)
{
    double best = INFINITY;
    size_t found = 0;
    for (size_t i = 0; i < count; i++) {
        double unit[2];
        double length = direction(&part[i], unit);
        double at = unit[0] * (x - part[i].x0) + unit[1] * (y - part[i].y0);
        double held = fmax(0.0, fmin(length, at));
        double off = hypot(part[i].x0 + unit[0] * held - x, part[i].y0 + unit[1] * held - y);
        if (off < best) {
            best = off;
            found = i;
            *along = length > 0.0 ? held / length : 0.0;
        }
    }
    *distance = best;
    return found;
}
