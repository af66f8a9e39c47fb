/*
 * Strokes: coverage against exact areas, joints, bands and scissors, formats, depth, extremes.
 */
#include "support_core.h"

#include "reference/stroke_cover.h"

enum { WIDTH = 83, HEIGHT = 53, POINTS = 24 };

typedef struct scene {
    qtri_screen_vertex v[POINTS];
    uint32_t count;
    qtri_stroke stroke;
} scene;

static scene random_scene(uint64_t *seed, int32_t most)
{
    scene s;
    const int32_t reach = random_flag(seed) ? 600 : 12000;
    s.count = (uint32_t)random_in(seed, 1, most);
    s.stroke = qtri_stroke_default();
    s.stroke.width = random_in(seed, 0, 3) == 0 ? random_in(seed, 65536, 20 * 65536)
                                                : random_in(seed, 20000, 3 * 65536);
    s.stroke.cap = (qtri_cap)random_in(seed, 0, 2);
    s.stroke.closed = random_in(seed, 0, 3) == 0;
    int32_t x = random_in(seed, -2000, WIDTH * 256 + 2000);
    int32_t y = random_in(seed, -2000, HEIGHT * 256 + 2000);
    for (uint32_t i = 0; i < s.count; i++) {
        s.v[i] = screen_at(x, y);
        if (random_in(seed, 0, 3) != 0) {
            x += random_in(seed, -reach, reach);
        }
        if (random_in(seed, 0, 3) != 0) {
            y += random_in(seed, -reach, reach);
        }
    }
    return s;
}

static size_t parts_of(const scene *s, struct ref_stroke_part part[POINTS])
{
    const bool closed = s->stroke.closed && s->count > 2;
    const size_t count = closed || s->count == 1 ? s->count : s->count - 1;
    for (size_t i = 0; i < count; i++) {
        const qtri_screen_vertex *a = &s->v[i];
        const qtri_screen_vertex *b = &s->v[(i + 1) % s->count];
        const enum ref_cap cap = (enum ref_cap)s->stroke.cap;
        struct ref_stroke_part one = {a->x_24p8 / 256.0,
                                      a->y_24p8 / 256.0,
                                      b->x_24p8 / 256.0,
                                      b->y_24p8 / 256.0,
                                      s->stroke.width / 131072.0,
                                      {closed || i > 0 ? REF_CAP_ROUND : cap,
                                       closed || i + 1 < count ? REF_CAP_ROUND : cap}};
        part[i] = one;
    }
    return count;
}

static void draw(const qtri_surface *surface, const scene *s)
{
    qtri_material material = plain_material();
    qtri_raster_polyline(surface, &material, &s->stroke, s->v, s->count);
}

/* White on black in gray: a pixel is its coverage. */
static double worst_error(canvas *c, const scene *s)
{
    struct ref_stroke_part part[POINTS];
    const size_t count = parts_of(s, part);
    double worst = 0.0;
    canvas_clear(c);
    draw(&c->surface, s);
    for (int y = 0; y < HEIGHT; y++) {
        double share[WIDTH];
        ref_stroke_cover_row(part, count, y, WIDTH, share);
        for (int x = 0; x < WIDTH; x++) {
            worst = fmax(worst, fabs(stored_pixel(&c->surface, x, y) / 255.0 - share[x]));
        }
    }
    return worst;
}

static void coverage_of(uint64_t seed, int32_t most, int runs, double limit)
{
    canvas c = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    double worst = 0.0;
    for (int n = 0; n < runs; n++) {
        const uint64_t from = seed;
        const scene s = random_scene(&seed, most);
        const double error = worst_error(&c, &s);
        if (error > limit) {
            fail_msg("scene %llx, %u points: off by %.4f", (unsigned long long)from,
                     (unsigned)s.count, error);
        }
        worst = fmax(worst, error);
    }
    print_message("coverage of up to %d points: off by %.4f at most\n", (int)most, worst);
    canvas_free(&c);
}

static void coverage(void **state)
{
    (void)state;
    coverage_of(1, 1, 300, 1.0 / 32);
    coverage_of(2, 2, 1000, 1.0 / 32);
    coverage_of(3, 3, 700, 1.0 / 32);
    coverage_of(4, POINTS, 300, 1.0 / 32);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(coverage),
    };
    return cmocka_run_group_tests_name("core_stroke", tests, NULL, NULL);
}
