/* SPDX-License-Identifier: MIT */
/*
 * Flat shapes: against areas and insides in double precision, and that no band, scissor or format
 * changes a pixel.
 */
#include "support/core.h"

#include <qtri/paint.h>

typedef struct shape shape;
struct shape {
    enum shape_kind {
        RECT,
        RECT_OUTLINE,
        ROUND,
        ROUND_OUTLINE,
        CIRCLE,
        RING,
        ARC,
        POLYGON,
        STROKE,
        KINDS
    } kind;
    qtri_area box;
    qtri_point center, to, point[9];
    int32_t radius, width, count;
    q16 from, sweep;
};

static void paint(const qtri_surface *s, const shape *h, const qtri_brush *brush)
{
    switch (h->kind) {
    case RECT:
        qtri_paint_rect(s, &h->box, brush);
        break;
    case RECT_OUTLINE:
        qtri_paint_rect_outline(s, &h->box, h->width, brush);
        break;
    case ROUND:
        qtri_paint_round_rect(s, &h->box, h->radius, brush);
        break;
    case ROUND_OUTLINE:
        qtri_paint_round_rect_outline(s, &h->box, h->radius, h->width, brush);
        break;
    case CIRCLE:
        qtri_paint_circle(s, &h->center, h->radius, brush);
        break;
    case RING:
        qtri_paint_ring(s, &h->center, h->radius, h->width, brush);
        break;
    case ARC:
        qtri_paint_arc(s, &h->center, h->radius, h->width, h->from, h->sweep, brush);
        break;
    case POLYGON:
        qtri_paint_polygon(s, h->point, h->count, brush);
        break;
    default:
        qtri_paint_stroke(s, &h->center, &h->to, h->width, brush);
        break;
    }
}

/* ---- Insides in double precision, in pixels ---- */

static bool in_box(double x, double y, double x0, double y0, double x1, double y1)
{
    return x >= x0 && x < x1 && y >= y0 && y < y1;
}

static bool in_round(double x, double y, const double b[4], double r)
{
    if (!in_box(x, y, b[0], b[1], b[2], b[3])) {
        return false;
    }
    const double half = fmin(b[2] - b[0], b[3] - b[1]) / 2;
    r = fmax(0, fmin(r, half));
    const double dx = fmax(fmax(b[0] + r - x, x - (b[2] - r)), 0);
    const double dy = fmax(fmax(b[1] + r - y, y - (b[3] - r)), 0);
    return dx * dx + dy * dy <= r * r;
}

static bool in_polygon(double x, double y, const double (*p)[2], int count)
{
    int winding = 0;
    for (int i = 0; i < count; i++) {
        const double *a = p[i];
        const double *b = p[(i + 1) % count];
        if ((a[1] <= y) != (b[1] <= y)) {
            const double at = a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]);
            winding += x >= at ? (b[1] > a[1] ? 1 : -1) : 0;
        }
    }
    return winding != 0;
}

static bool is_inside(const shape *h, double x, double y)
{
    const double b[4] = {h->box.x0_24p8 / 256.0, h->box.y0_24p8 / 256.0, h->box.x1_24p8 / 256.0,
                         h->box.y1_24p8 / 256.0};
    const double w = h->width / 256.0;
    const double r = h->radius / 256.0;
    const double inner[4] = {b[0] + w, b[1] + w, b[2] - w, b[3] - w};
    const double dx = x - h->center.x_24p8 / 256.0;
    const double dy = y - h->center.y_24p8 / 256.0;
    const double distance = sqrt(dx * dx + dy * dy);
    double p[9][2];
    switch (h->kind) {
    case RECT:
        return in_box(x, y, b[0], b[1], b[2], b[3]);
    case RECT_OUTLINE:
        return in_box(x, y, b[0], b[1], b[2], b[3]) &&
               !in_box(x, y, inner[0], inner[1], inner[2], inner[3]);
    case ROUND:
        return in_round(x, y, b, r);
    case ROUND_OUTLINE: {
        const double corner = fmax(0, fmin(r, fmin(b[2] - b[0], b[3] - b[1]) / 2));
        return in_round(x, y, b, r) && !in_round(x, y, inner, fmax(corner - w, 0));
    }
    case CIRCLE:
        return distance <= r;
    case RING:
        return distance <= r && distance > r - w;
    case ARC: {
        double sweep = h->sweep / 65536.0;
        double from = h->from / 65536.0;
        if (sweep < 0) {
            from += sweep;
            sweep = -sweep;
        }
        double angle = fmod(atan2(dy, dx) * 180 / acos(-1) - from, 360);
        angle += angle < 0 ? 360 : 0;
        return distance <= r && distance > r - w && angle <= sweep;
    }
    case POLYGON:
        for (int i = 0; i < h->count; i++) {
            p[i][0] = h->point[i].x_24p8 / 256.0;
            p[i][1] = h->point[i].y_24p8 / 256.0;
        }
        return in_polygon(x, y, (const double(*)[2])p, h->count);
    default: {
        const double tx = (h->to.x_24p8 - h->center.x_24p8) / 256.0;
        const double ty = (h->to.y_24p8 - h->center.y_24p8) / 256.0;
        const double length = sqrt(tx * tx + ty * ty);
        const double along = (dx * tx + dy * ty) / length;
        const double across = (dx * ty - dy * tx) / length;
        return along >= 0 && along <= length && fabs(across) <= w / 2;
    }
    }
}

/* ---- Random shapes ---- */

enum { SIDE = 48 };

static int32_t somewhere(uint64_t *seed)
{
    return random_in(seed, -6 * 256, (SIDE + 6) * 256) & (random_in(seed, 0, 3) ? -1 : -256);
}

static qtri_point random_point(uint64_t *seed)
{
    qtri_point p = {somewhere(seed), somewhere(seed)};
    return p;
}

/* Corners in order of their angle around a point: a star, which is simple. */
static void random_star(shape *h, uint64_t *seed)
{
    h->count = random_in(seed, 3, 9);
    for (int i = 0; i < h->count; i++) {
        const double angle = (i + random_in(seed, 0, 800) / 1000.0) * 2 * acos(-1) / h->count;
        const double r = random_in(seed, 256, 24 * 256);
        h->point[i].x_24p8 = h->center.x_24p8 + (int32_t)lround(r * cos(angle));
        h->point[i].y_24p8 = h->center.y_24p8 + (int32_t)lround(r * sin(angle));
    }
    if (random_flag(seed)) {
        for (int i = 0; i < h->count / 2; i++) {
            qtri_point p = h->point[i];
            h->point[i] = h->point[h->count - 1 - i];
            h->point[h->count - 1 - i] = p;
        }
    }
}

static shape random_shape(uint64_t *seed, int32_t n)
{
    shape h = {0};
    h.kind = (enum shape_kind)n;
    h.center = random_point(seed);
    h.to = random_point(seed);
    const int32_t least = n == STROKE ? 256 : 0;
    if (h.to.x_24p8 == h.center.x_24p8 && h.to.y_24p8 == h.center.y_24p8) {
        h.to.x_24p8 += 256;
    }
    h.box.x0_24p8 = somewhere(seed);
    h.box.y0_24p8 = somewhere(seed);
    h.box.x1_24p8 = h.box.x0_24p8 + random_in(seed, 1, 40 * 256);
    h.box.y1_24p8 = h.box.y0_24p8 + random_in(seed, 1, 40 * 256);
    h.radius = random_in(seed, 0, 3) ? random_in(seed, 1, 30 * 256) : random_in(seed, 1, 700);
    h.width =
        least + (random_in(seed, 0, 3) ? random_in(seed, 1, 8 * 256) : random_in(seed, 1, 512));
    h.from = random_in(seed, -800 * 65536, 800 * 65536);
    h.sweep = random_in(seed, -359 * 65536, 359 * 65536);
    if (random_flag(seed)) {
        h.from &= ~((90 << 16) - 1);
    }
    random_star(&h, seed);
    return h;
}

/* ---- Tests ---- */

static void clear(qtri_surface *s, uint8_t level)
{
    const qtri_rgb color = {level, level, level};
    clear_to(s, color, 1234);
}

/* How far an inside test may differ where the outline is closer to the pixel's centre than this. */
static bool is_clear_cut(const shape *h, double x, double y, double reach)
{
    const bool is = is_inside(h, x, y);
    for (int i = 0; i < 16; i++) {
        const double angle = i * acos(-1) / 8;
        if (is_inside(h, x + reach * cos(angle), y + reach * sin(angle)) != is) {
            return false;
        }
    }
    return true;
}

TEST(hard_edges)
{
    uint64_t seed = 1;
    canvas c = canvas_new(&qtri_gray8, SIDE, SIDE);
    const qtri_rgb white = {255, 255, 255};
    const qtri_brush brush = qtri_brush_of(white);
    for (int n = 0; n < random_cases(2000); n++) {
        const shape h = random_shape(&seed, n % KINDS);
        clear(&c.surface, 0);
        paint(&c.surface, &h, &brush);
        for (int32_t y = 0; y < SIDE; y++) {
            for (int32_t x = 0; x < SIDE; x++) {
                const bool is = stored_pixel(&c.surface, x, y) == 255;
                if (is != is_inside(&h, x + .5, y + .5) && is_clear_cut(&h, x + .5, y + .5, .012)) {
                    fail_msg("shape %d of kind %d: pixel %d,%d is %d", n, (int)h.kind, (int)x,
                             (int)y, is);
                }
                assert_int_equal(stored_depth(&c.surface, x, y), 1234);
            }
        }
    }
    canvas_free(&c);
}

enum { SAMPLES = 48 };

/* The share of a pixel that lies inside, by samples unless it looks the same all over. */
static double area(const shape *h, int32_t x, int32_t y, uint32_t painted)
{
    const bool is = is_inside(h, x + .5, y + .5);
    if (painted == (is ? 255 : 0) && is_clear_cut(h, x + .5, y + .5, .36) &&
        is_clear_cut(h, x + .5, y + .5, .72)) {
        return is;
    }
    int inside = 0;
    for (int i = 0; i < SAMPLES; i++) {
        for (int j = 0; j < SAMPLES; j++) {
            inside += is_inside(h, x + (i + .5) / SAMPLES, y + (j + .5) / SAMPLES);
        }
    }
    return inside / (double)(SAMPLES * SAMPLES);
}

/* Within 1/32, the samples' own error of an edge along their rows, 1/96, on top. */
TEST(smooth_edges)
{
    uint64_t seed = 2;
    canvas c = canvas_new(&qtri_gray8, SIDE, SIDE);
    const qtri_rgb white = {255, 255, 255};
    const qtri_brush brush = {white, 255, &qtri_ink_smooth};
    double worst[KINDS] = {0};
    for (int n = 0; n < (long_run() ? 4000 : random_cases(360)); n++) {
        const shape h = random_shape(&seed, n % KINDS);
        clear(&c.surface, 0);
        paint(&c.surface, &h, &brush);
        for (int32_t y = 0; y < SIDE; y++) {
            for (int32_t x = 0; x < SIDE; x++) {
                const uint32_t is = stored_pixel(&c.surface, x, y);
                const double error = is / 255.0 - area(&h, x, y, is);
                worst[h.kind] = fmax(worst[h.kind], fabs(error));
                if (fabs(error) > 1.0 / 32 + 1.0 / 96) {
                    fail_msg("shape %d of kind %d: pixel %d,%d is %u, not %.1f", n, (int)h.kind,
                             (int)x, (int)y, (unsigned)is, is - 255 * error);
                }
            }
        }
    }
    for (int k = 0; k < KINDS; k++) {
        print_message("kind %d: %.4f\n", k, worst[k]);
    }
    canvas_free(&c);
}

/* How much of [from, to] lies in pixel i. */
static double overlap(int32_t from, int32_t to, int32_t i)
{
    return fmax(0, fmin(to, i * 256 + 256) - fmax(from, i * 256)) / 256.;
}

/* Smooth outlines whose inner side begins and ends with a row, and may lie in one column. */
TEST(hollow_rows)
{
    uint64_t seed = 12;
    canvas c = canvas_new(&qtri_gray8, SIDE, SIDE);
    const qtri_rgb white = {255, 255, 255};
    const qtri_brush brush = {white, 255, &qtri_ink_smooth};
    for (int n = 0; n < random_cases(300); n++) {
        const int32_t width = QTRI_PX(random_in(&seed, 1, 3));
        const int32_t x = random_in(&seed, 0, QTRI_PX(20));
        const int32_t y = QTRI_PX(random_in(&seed, 0, 20));
        const int32_t hollow = random_in(&seed, 1, n % 3 == 0 ? 1200 : 255);
        const qtri_area box = {x, y, x + 2 * width + hollow, y + QTRI_PX(random_in(&seed, 7, 20))};
        clear(&c.surface, 0);
        qtri_paint_rect_outline(&c.surface, &box, width, &brush);
        for (int32_t i = 0; i < SIDE * SIDE; i++) {
            const int32_t column = i % SIDE;
            const int32_t row = i / SIDE;
            const double outer =
                overlap(box.x0_24p8, box.x1_24p8, column) * overlap(box.y0_24p8, box.y1_24p8, row);
            const double inner = overlap(box.x0_24p8 + width, box.x1_24p8 - width, column) *
                                 overlap(box.y0_24p8 + width, box.y1_24p8 - width, row);
            assert_near(stored_pixel(&c.surface, column, row), 255 * (outer - inner), 2);
        }
    }
    canvas_free(&c);
}

static const qtri_ink *const inks[] = {NULL, &qtri_ink_blend, &qtri_ink_smooth};

/* Something to mix with. */
static void background(qtri_surface *s)
{
    for (int32_t i = 0; i < SIDE; i += 4) {
        const qtri_rgb color = {(uint8_t)(5 * i), (uint8_t)(255 - 3 * i), (uint8_t)(40 + i)};
        const qtri_brush brush = qtri_brush_of(color);
        const qtri_area box = {QTRI_PX(i), 0, QTRI_PX(i + 4), QTRI_PX(SIDE)};
        qtri_paint_rect(s, &box, &brush);
    }
}

static qtri_brush random_brush(uint64_t *seed)
{
    const qtri_brush brush = {
        {(uint8_t)random64(seed), (uint8_t)random64(seed), (uint8_t)random64(seed)},
        (uint8_t)(random_flag(seed) ? 255 : random64(seed)),
        inks[random_in(seed, 0, 2)]};
    return brush;
}

/* Bands and scissors leave the pixels of the whole frame, and nothing outside. */
TEST(bands)
{
    uint64_t seed = 3;
    for (int n = 0; n < random_cases(1500); n++) {
        const qtri_format *format = drawn_format(n);
        const shape h = random_shape(&seed, n % KINDS);
        const qtri_brush brush = random_brush(&seed);
        canvas whole = canvas_new(format, SIDE, SIDE);
        background(&whole.surface);
        paint(&whole.surface, &h, &brush);
        const int32_t first = random_in(&seed, 0, SIDE - 1);
        canvas band = canvas_band(format, SIDE, SIDE, first, random_in(&seed, 1, 9));
        background(&band.surface);
        qtri_surface left = band.surface;
        qtri_surface right = band.surface;
        left.scissor.x1 = right.scissor.x0 = random_in(&seed, 0, SIDE);
        paint(&left, &h, &brush);
        paint(&right, &h, &brush);
        assert_same_picture(&whole.surface, &band.surface);
        canvas_free(&whole);
        canvas_free(&band);
    }
}

/* What a channel's step is, of 255. */
static double step_of(const qtri_format *format, int channel)
{
    return format->pixels->bytes == 2 ? 255 / (channel == 1 ? 63.0 : 31.0) : 1;
}

/* Mixed pixels: the surface's own mixed in double precision; 1 of 255, 3/4 of a step of RGB565. */
TEST(mixes)
{
    uint64_t seed = 4;
    double worst = 0;
    for (int n = 0; n < random_cases(120); n++) {
        const qtri_format *format = drawn_format(n);
        qtri_brush brush = random_brush(&seed);
        brush.ink = &qtri_ink_blend;
        canvas before = canvas_new(format, SIDE, SIDE);
        canvas after = canvas_new(format, SIDE, SIDE);
        background(&before.surface);
        background(&after.surface);
        const qtri_area all = {0, 0, QTRI_PX(SIDE), QTRI_PX(SIDE)};
        qtri_paint_rect(&after.surface, &all, &brush);
        const double a = brush.alpha / 255.0;
        for (int32_t x = 0; x < SIDE; x++) {
            const qtri_rgb d = qtri_surface_pixel(&before.surface, x, 7);
            const qtri_rgb m = qtri_surface_pixel(&after.surface, x, 7);
            double s[3] = {brush.color.r, brush.color.g, brush.color.b};
            if (format->colors == &qtri_colors_gray) {
                s[0] = s[1] = s[2] = .299 * s[0] + .587 * s[1] + .114 * s[2];
            }
            const double from[3] = {d.r, d.g, d.b};
            const double is[3] = {m.r, m.g, m.b};
            for (int i = 0; i < 3; i++) {
                const double step = step_of(format, i);
                const double error = fabs(is[i] - (from[i] + a * (s[i] - from[i]))) / step;
                worst = fmax(worst, step == 1 ? error * .75 : error);
                assert_true(error <= (step == 1 ? 1 : .75));
            }
        }
        canvas_free(&before);
        canvas_free(&after);
    }
    print_message("worst mix: %.3f of .75\n", worst);
}

/* A smooth brush that covers all of a pixel paints what the hard one does. */
TEST(whole_pixels)
{
    uint64_t seed = 5;
    for (int n = 0; n < random_cases(200); n++) {
        const qtri_format *format = drawn_format(n);
        qtri_brush brush = random_brush(&seed);
        brush.alpha = 255;
        canvas a = canvas_new(format, SIDE, SIDE);
        canvas b = canvas_new(format, SIDE, SIDE);
        const int32_t x = random_in(&seed, -3, SIDE);
        const int32_t y = random_in(&seed, -3, SIDE);
        const qtri_area box = {QTRI_PX(x), QTRI_PX(y), QTRI_PX(x + random_in(&seed, 1, 20)),
                               QTRI_PX(y + random_in(&seed, 1, 20))};
        const qtri_point corner[4] = {{box.x0_24p8, box.y0_24p8},
                                      {box.x1_24p8, box.y0_24p8},
                                      {box.x1_24p8, box.y1_24p8},
                                      {box.x0_24p8, box.y1_24p8}};
        brush.ink = NULL;
        qtri_paint_rect(&a.surface, &box, &brush);
        brush.ink = &qtri_ink_smooth;
        if (random_flag(&seed)) {
            qtri_paint_rect(&b.surface, &box, &brush);
        } else {
            qtri_paint_polygon(&b.surface, corner, 4, &brush);
        }
        assert_same_picture(&a.surface, &b.surface);
        canvas_free(&a);
        canvas_free(&b);
    }
}

/* Sides on centres of pixels: the left and the upper ones belong to the shape. */
TEST(sides_on_centers)
{
    const qtri_rgb white = {255, 255, 255};
    const qtri_brush brush = qtri_brush_of(white);
    const qtri_area box = {QTRI_PX(1.5), QTRI_PX(0.5), QTRI_PX(4.5), QTRI_PX(2.5)};
    const qtri_point corner[4] = {{box.x0_24p8, box.y0_24p8},
                                  {box.x1_24p8, box.y0_24p8},
                                  {box.x1_24p8, box.y1_24p8},
                                  {box.x0_24p8, box.y1_24p8}};
    for (int n = 0; n < 4; n++) {
        canvas c = canvas_new(&qtri_rgb565, 6, 4);
        if (n == 0) {
            qtri_paint_rect(&c.surface, &box, &brush);
        } else if (n == 1) {
            qtri_paint_polygon(&c.surface, corner, 4, &brush);
        } else if (n == 2) {
            qtri_paint_round_rect(&c.surface, &box, 0, &brush);
        } else {
            const qtri_point from = {QTRI_PX(1.5), QTRI_PX(1.5)};
            const qtri_point to = {QTRI_PX(4.5), QTRI_PX(1.5)};
            qtri_paint_stroke(&c.surface, &from, &to, QTRI_PX(2), &brush);
        }
        assert_raster(&c.surface, ".###..", ".###..", "......", "......");
        canvas_free(&c);
    }
}

/* Two shapes with a common side leave no gap and no pixel painted twice. */
TEST(common_sides)
{
    uint64_t seed = 6;
    const qtri_rgb level = {100, 100, 100};
    const qtri_brush brush = {level, 128, &qtri_ink_blend};
    canvas c = canvas_new(&qtri_gray8, SIDE, SIDE);
    for (int n = 0; n < random_cases(300); n++) {
        clear(&c.surface, 0);
        const qtri_point a = {random_in(&seed, 0, 255), random_in(&seed, 0, 255)};
        const qtri_point d = {QTRI_PX(SIDE) - random_in(&seed, 0, 255),
                              QTRI_PX(SIDE) - random_in(&seed, 0, 255)};
        const qtri_point b = {d.x_24p8, a.y_24p8};
        const qtri_point e = {a.x_24p8, d.y_24p8};
        const qtri_point upper[3] = {a, b, d};
        const qtri_point lower[3] = {d, e, a};
        qtri_paint_polygon(&c.surface, upper, 3, &brush);
        qtri_paint_polygon(&c.surface, lower, 3, &brush);
        for (int32_t y = 1; y < SIDE - 1; y++) {
            for (int32_t x = 1; x < SIDE - 1; x++) {
                assert_int_equal(stored_pixel(&c.surface, x, y), 50);
            }
        }
    }
    canvas_free(&c);
}

/* Any arguments: nothing is written outside, which sanitizers see. */
TEST(any_arguments)
{
    uint64_t seed = 7;
    canvas c = canvas_new(&qtri_rgb565, SIDE, SIDE);
    for (int n = 0; n < random_cases(30000); n++) {
        shape h = random_shape(&seed, n % KINDS);
        int32_t *const value[] = {
            &h.box.x0_24p8,     &h.box.y0_24p8,     &h.box.x1_24p8,    &h.box.y1_24p8,
            &h.center.x_24p8,   &h.center.y_24p8,   &h.to.x_24p8,      &h.to.y_24p8,
            &h.radius,          &h.width,           &h.from,           &h.sweep,
            &h.point[0].x_24p8, &h.point[1].y_24p8, &h.point[2].x_24p8};
        for (int i = random_in(&seed, 0, 6); i > 0; i--) {
            *value[random_in(&seed, 0, (int32_t)LENGTH_OF(value) - 1)] = random_any(&seed);
        }
        const qtri_brush brush = random_brush(&seed);
        paint(&c.surface, &h, &brush);
    }
    c.surface.format = NULL;
    const shape h = random_shape(&seed, CIRCLE);
    const qtri_brush brush = random_brush(&seed);
    paint(&c.surface, &h, &brush);
    canvas_free(&c);
}

/* A comb: more sides cross a row than are kept. It is its teeth. */
TEST(many_sides_in_a_row)
{
    enum { TEETH = 11, POINTS = 4 * TEETH };
    static const qtri_ink *const kinds[3] = {NULL, &qtri_ink_blend, &qtri_ink_smooth};
    qtri_point point[POINTS];
    for (int i = 0; i < TEETH; i++) {
        const int32_t x = QTRI_PX(2 + 4 * i), y = QTRI_PX(3 + i % 3);
        const qtri_point tooth[4] = {
            {x, QTRI_PX(30)}, {x, y}, {x + QTRI_PX(2), y}, {x + QTRI_PX(2), QTRI_PX(30)}};
        memcpy(&point[4 * i], tooth, sizeof tooth);
    }
    for (int n = 0; n < 3; n++) {
        const qtri_brush brush = {{9, 99, 199}, 255, kinds[n]};
        canvas comb = canvas_new(&qtri_rgb565, SIDE, SIDE);
        canvas teeth = canvas_new(&qtri_rgb565, SIDE, SIDE);
        qtri_paint_polygon(&comb.surface, point, POINTS, &brush);
        for (int i = 0; i < TEETH; i++) {
            const qtri_area tooth = {point[4 * i].x_24p8, point[4 * i + 1].y_24p8,
                                     point[4 * i + 2].x_24p8, point[4 * i].y_24p8};
            qtri_paint_rect(&teeth.surface, &tooth, &brush);
        }
        assert_same_picture(&teeth.surface, &comb.surface);
        canvas_free(&comb);
        canvas_free(&teeth);
    }
}

/* Shapes that have no inside. */
TEST(no_inside)
{
    canvas c = canvas_new(&qtri_rgb565, SIDE, SIDE);
    canvas cleared = canvas_new(&qtri_rgb565, SIDE, SIDE);
    const qtri_brush brush = qtri_brush_of((qtri_rgb){255, 255, 255});
    const qtri_point point[3] = {{0, 0}, {QTRI_PX(9), 0}, {0, QTRI_PX(9)}};
    for (int32_t count = -1; count < 3; count++) {
        qtri_paint_polygon(&c.surface, point, count, &brush);
    }
    qtri_paint_polygon(&c.surface, point, INT32_MIN, &brush);
    qtri_paint_stroke(&c.surface, &point[1], &point[1], QTRI_PX(5), &brush);
    qtri_paint_stroke(&c.surface, &point[1], &point[2], 0, &brush);
    assert_same_picture(&cleared.surface, &c.surface);
    canvas_free(&c);
    canvas_free(&cleared);
}

/* Outlines that leave no inside, just so or by far, are their rectangles; just some inside is seen.
 */
TEST(outlines_without_inside)
{
    const qtri_rgb white = {255, 255, 255};
    uint64_t seed = 18;
    int other = 0;
    for (int n = 0; n < 900; n++) {
        const qtri_brush brush = {white, n % 3 == 0 ? 255 : 150, inks[n % 3]};
        const int32_t grid = n % 2 == 0 ? 256 : 1;
        const int32_t half[2] = {random_in(&seed, 1, 1500 / grid) * grid,
                                 random_in(&seed, 1, 1500 / grid) * grid};
        const int32_t x = random_in(&seed, -1000 / grid, 5000 / grid) * grid;
        const int32_t y = random_in(&seed, -1000 / grid, 5000 / grid) * grid;
        const qtri_area box = {x, y, x + 2 * half[0], y + 2 * half[1]};
        const int32_t most = half[0] < half[1] ? half[0] : half[1];
        const int32_t width = most + (n % 5 == 4 ? -256 : n % 5 / 3);
        canvas c[2] = {canvas_new(&qtri_xrgb8888, SIDE, SIDE),
                       canvas_new(&qtri_xrgb8888, SIDE, SIDE)};
        qtri_paint_rect(&c[0].surface, &box, &brush);
        qtri_paint_rect_outline(&c[1].surface, &box, width, &brush);
        if (width >= most) {
            assert_same_picture(&c[0].surface, &c[1].surface);
        } else {
            other += memcmp(c[0].memory, c[1].memory, c[0].bytes) != 0;
        }
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
    assert_true(other > 50);
}

/*
 * Polygons of few points have their sides made ready once, others in every row. An L whose sides
 * have more points between their ends is the same; so are its level sides anywhere in a row.
 */
TEST(sides_with_points_between)
{
    enum { ENDS = 6, PARTS = 9 };
    static const qtri_rgb white = {255, 255, 255};
    uint64_t seed = 19;
    int painted = 0;
    for (int n = 0; n < 600; n++) {
        const qtri_brush brush = {white, n % 3 == 0 ? 255 : 150, inks[n % 3]};
        int32_t x[3];
        int32_t y[3];
        for (int i = 0; i < 3; i++) {
            x[i] = random_in(&seed, -1000, SIDE * 256 + 1000);
            y[i] = random_in(&seed, -1000, SIDE * 256 + 1000);
        }
        const qtri_point ends[ENDS] = {{x[0], y[0]}, {x[1], y[0]}, {x[1], y[1]},
                                       {x[2], y[1]}, {x[2], y[2]}, {x[0], y[2]}};
        qtri_point points[ENDS * PARTS];
        for (int i = 0; i < ENDS * PARTS; i++) {
            const qtri_point *a = &ends[i / PARTS];
            const qtri_point *b = &ends[(i / PARTS + 1) % ENDS];
            points[i].x_24p8 = a->x_24p8 + (b->x_24p8 - a->x_24p8) * (i % PARTS) / PARTS;
            points[i].y_24p8 = a->y_24p8 + (b->y_24p8 - a->y_24p8) * (i % PARTS) / PARTS;
        }
        canvas c[2] = {canvas_new(&qtri_xrgb8888, SIDE, SIDE),
                       canvas_new(&qtri_xrgb8888, SIDE, SIDE)};
        canvas empty = canvas_new(&qtri_xrgb8888, SIDE, SIDE);
        qtri_paint_polygon(&c[0].surface, ends, ENDS, &brush);
        qtri_paint_polygon(&c[1].surface, points, ENDS * PARTS, &brush);
        assert_same_picture(&c[0].surface, &c[1].surface);
        painted += memcmp(c[0].memory, empty.memory, empty.bytes) != 0;
        canvas_free(&c[0]);
        canvas_free(&c[1]);
        canvas_free(&empty);
    }
    assert_true(painted > 500);
}

/* A rectangle's share of one pixel, to nearest, for every width and height: mixed as an alpha is.
 */
TEST(shares_of_a_pixel)
{
    static const qtri_rgb black = {0, 0, 0};
    const qtri_brush brush = {black, 255, &qtri_ink_smooth};
    uint8_t mixed[256];
    const qtri_area pixel = {0, 0, 256, 256};
    canvas c = canvas_new(&qtri_gray8, 2, 2);
    for (int32_t alpha = 0; alpha < 256; alpha++) {
        const qtri_brush plain = {black, (uint8_t)alpha, &qtri_ink_blend};
        c.surface.pixels[0] = 255;
        qtri_paint_rect(&c.surface, &pixel, &plain);
        mixed[alpha] = c.surface.pixels[0];
        assert_in_range(mixed[alpha] + alpha, 254, 256);
    }
    for (int32_t n = 0; n < 256 * 256; n++) {
        const int32_t width = n / 256;
        const int32_t height = n % 256 + 1;
        const int32_t right = (n & 1) * (256 - width);
        const qtri_area box = {right, 256 - height, right + width, 256};
        c.surface.pixels[0] = 255;
        qtri_paint_rect(&c.surface, &box, &brush);
        const int32_t wanted = mixed[(width * height * 255 + 32768) >> 16];
        if (c.surface.pixels[0] != wanted) {
            fail_msg("%d by %d: %d", (int)width, (int)height, c.surface.pixels[0]);
        }
    }
    canvas_free(&c);
}

/* Thin slices of a row, of a polygon: of no height that a color's step shows is anything left out.
 */
TEST(slices_of_a_row)
{
    static const qtri_rgb white = {255, 255, 255};
    const qtri_brush brush = {white, 255, &qtri_ink_smooth};
    for (int32_t height = 1; height <= 256; height++) {
        canvas c[2] = {canvas_new(&qtri_xrgb8888, 100, 2), canvas_new(&qtri_xrgb8888, 100, 2)};
        const qtri_area box = {300, 256 - height, 25000, 256};
        const qtri_point corner[4] = {
            {300, 256 - height}, {25000, 256 - height}, {25000, 256}, {300, 256}};
        qtri_paint_rect(&c[0].surface, &box, &brush);
        qtri_paint_polygon(&c[1].surface, corner, 4, &brush);
        for (int32_t x = 2; x < 97; x++) {
            assert_int_equal(stored_pixel(&c[0].surface, x, 0), stored_pixel(&c[1].surface, x, 0));
            assert_int_not_equal(stored_pixel(&c[1].surface, x, 0), 0);
        }
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
}

/* The least that is seen at all is 1 of 255. */
TEST(least_alpha)
{
    static const qtri_rgb white = {255, 255, 255};
    canvas c = canvas_new(&qtri_xrgb8888, SIDE, SIDE);
    const qtri_area all = {0, 0, QTRI_PX(SIDE), QTRI_PX(SIDE)};
    for (uint8_t alpha = 0; alpha < 3; alpha++) {
        const qtri_brush brush = {white, alpha, &qtri_ink_blend};
        canvas_clear(&c);
        qtri_paint_rect(&c.surface, &all, &brush);
        assert_int_equal(stored_pixel(&c.surface, 3, 4), alpha * 0x010101u);
    }
    canvas_free(&c);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
