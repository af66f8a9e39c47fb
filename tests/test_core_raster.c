/* SPDX-License-Identifier: MIT */
/*
 * The fill rule of draw.h, exactly: against an independent integer edge function, on meshes whose
 * triangles must meet without gaps, and as pictures.
 */
#include "support/core.h"

typedef struct point {
    int32_t x, y;
} point;

static void draw(const qtri_surface *s, point a, point b, point c)
{
    qtri_material material = plain_material();
    qtri_screen_vertex v[3] = {screen_at(a.x, a.y), screen_at(b.x, b.y), screen_at(c.x, c.y)};
    qtri_raster_triangle(s, qtri_pipelines_default, &material, v);
}

/* (b - a) x (p - a): positive to the right of a -> b on a screen whose y points down. */
static int64_t edge(point a, point b, point p)
{
    return (int64_t)(b.x - a.x) * (p.y - a.y) - (int64_t)(b.y - a.y) * (p.x - a.x);
}

/* The centre of pixel x, y is right of the edge, or on it where the rule gives it away. */
static bool beside(point a, point b, int32_t x, int32_t y)
{
    point centre = {x * 256 + 128, y * 256 + 128};
    int64_t e = edge(a, b, centre);
    bool left = b.y < a.y;              /* clockwise, left edges go up */
    bool top = b.y == a.y && b.x > a.x; /* and top edges to the right */
    return e > 0 || (e == 0 && (left || top));
}

static bool inside(point a, point b, point c, int32_t x, int32_t y)
{
    int64_t area = edge(a, b, c);
    if (area == 0) {
        return false;
    }
    return area > 0 ? beside(a, b, x, y) && beside(b, c, x, y) && beside(c, a, x, y)
                    : beside(a, c, x, y) && beside(c, b, x, y) && beside(b, a, x, y);
}

enum { GRID = 17, POINTS = GRID * GRID, SIDE = 4 };

static uint16_t beside_mask[POINTS][POINTS];

static point grid_point(int index)
{
    point p = {index % GRID * 64, index / GRID * 64};
    return p;
}

static uint32_t mask_of(const qtri_surface *s)
{
    uint32_t mask = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        mask |= (uint32_t)(s->pixels[i / SIDE * s->pitch + i % SIDE] != 0) << i;
    }
    return mask;
}

static void check_grid_triangle(canvas *c, int i, int j, int k)
{
    point p[3] = {grid_point(i), grid_point(j), grid_point(k)};
    int64_t area = edge(p[0], p[1], p[2]);
    uint32_t expected = 0;
    if (area > 0) {
        expected = beside_mask[i][j] & beside_mask[j][k] & beside_mask[k][i];
    } else if (area < 0) {
        expected = beside_mask[i][k] & beside_mask[k][j] & beside_mask[j][i];
    }
    memset(c->surface.pixels, 0, SIDE * SIDE);
    draw(&c->surface, p[0], p[1], p[2]);
    if (mask_of(&c->surface) != expected) {
        fail_msg("%d,%d %d,%d %d,%d: %04x, not %04x", (int)p[0].x, (int)p[0].y, (int)p[1].x,
                 (int)p[1].y, (int)p[2].x, (int)p[2].y, (unsigned)mask_of(&c->surface),
                 (unsigned)expected);
    }
}

/* All triangles with corners at multiples of 1/4 pixel on 4 x 4 pixels: a quarter of all centres
   and edges meet. Each in one order by default, in all six in the long run. */
TEST(all_small_triangles)
{
    canvas c = canvas_new(&qtri_gray8, SIDE, SIDE);
    assert_int_equal(c.surface.pitch, SIDE);
    for (int i = 0; i < POINTS; i++) {
        for (int j = 0; j < POINTS; j++) {
            uint32_t mask = 0;
            for (int k = 0; k < SIDE * SIDE; k++) {
                mask |= (uint32_t)beside(grid_point(i), grid_point(j), k % SIDE, k / SIDE) << k;
            }
            beside_mask[i][j] = (uint16_t)mask;
        }
    }
    unsigned order = 0;
    for (int i = 0; i < POINTS; i++) {
        for (int j = long_run() ? 0 : i; j < POINTS; j++) {
            for (int k = long_run() ? 0 : j; k < POINTS; k++) {
                switch (order++ % 6) {
                case 0:
                    check_grid_triangle(&c, i, j, k);
                    break;
                case 1:
                    check_grid_triangle(&c, k, j, i);
                    break;
                case 2:
                    check_grid_triangle(&c, j, k, i);
                    break;
                case 3:
                    check_grid_triangle(&c, j, i, k);
                    break;
                case 4:
                    check_grid_triangle(&c, k, i, j);
                    break;
                default:
                    check_grid_triangle(&c, i, k, j);
                    break;
                }
            }
        }
    }
    canvas_free(&c);
}

enum { WIDTH = 40, HEIGHT = 36 };

static void check_triangle(canvas *c, point p0, point p1, point p2)
{
    canvas_clear(c);
    draw(&c->surface, p0, p1, p2);
    for (int32_t y = 0; y < HEIGHT; y++) {
        for (int32_t x = 0; x < WIDTH; x++) {
            bool is = stored_pixel(&c->surface, x, y) != 0;
            if (is != inside(p0, p1, p2, x, y)) {
                fail_msg("%d,%d %d,%d %d,%d: pixel %d,%d %s", (int)p0.x, (int)p0.y, (int)p1.x,
                         (int)p1.y, (int)p2.x, (int)p2.y, (int)x, (int)y,
                         is ? "covered" : "missing");
            }
        }
    }
}

static point random_point(uint64_t *seed, int32_t reach)
{
    point p = {random_in(seed, WIDTH * 128 - reach, WIDTH * 128 + reach),
               random_in(seed, HEIGHT * 128 - reach, HEIGHT * 128 + reach)};
    p.x = p.x > QTRI_SCREEN_MAX_24P8 ? QTRI_SCREEN_MAX_24P8 : p.x;
    p.x = p.x < -QTRI_SCREEN_MAX_24P8 ? -QTRI_SCREEN_MAX_24P8 : p.x;
    p.y = p.y > QTRI_SCREEN_MAX_24P8 ? QTRI_SCREEN_MAX_24P8 : p.y;
    p.y = p.y < -QTRI_SCREEN_MAX_24P8 ? -QTRI_SCREEN_MAX_24P8 : p.y;
    if (random_in(seed, 0, 3) == 0) { /* on pixel centres or corners */
        p.x &= ~127;
        p.y &= ~127;
    }
    return p;
}

/* Both widths of edge arithmetic, and the change between them at 2^15. */
TEST(any_size)
{
    static const int32_t reach[] = {300, 3000, 8000, 16384, 17000, 33000, 70000, 1 << 19, 1 << 22};
    canvas c = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    uint64_t seed = 51;
    for (int n = 0; n < random_cases(9000); n++) {
        int32_t r = reach[n % 9];
        point p[3];
        for (int i = 0; i < 3; i++) {
            p[i] = random_point(&seed, random_in(&seed, 0, 2) == 0 ? 5000 : r);
        }
        if (n % 3 == 0) { /* a sliver: the third corner close to the first edge */
            p[2].x = p[0].x + (p[1].x - p[0].x) / 3 + random_in(&seed, -2, 2);
            p[2].y = p[0].y + (p[1].y - p[0].y) / 3 + random_in(&seed, -2, 2);
        }
        check_triangle(&c, p[0], p[1], p[2]);
    }
    for (int32_t d = -2; d <= 2; d++) { /* lengths and widths around 2^15 */
        point p[4] = {{1000, 700}, {1000 + 32768 + d, 300}, {500, 700 + 32768 - d}, {9000, 9000}};
        point q[3] = {{9000 - 32768 - d, 100}, {9000, 6000 + d}, {5, 100 - 32768 + d}};
        check_triangle(&c, p[0], p[1], p[2]);
        check_triangle(&c, p[3], p[2], p[1]);
        check_triangle(&c, q[0], q[1], q[2]);
    }
    const int32_t far_out = QTRI_SCREEN_MAX_24P8;
    point w[4] = {
        {-far_out, -far_out}, {far_out, -far_out}, {far_out, far_out}, {-far_out, far_out}};
    for (int i = 0; i < 4; i++) {
        check_triangle(&c, w[i], w[(i + 1) % 4], w[(i + 2) % 4]);
        check_triangle(&c, w[i], w[(i + 3) % 4], random_point(&seed, 5000));
    }
    /* What lies farther out is held to the guard band. */
    point beyond = {INT32_MAX, INT32_MIN};
    point held = {far_out, -far_out};
    point other[2] = {{300, 300}, {5000, 7000}};
    canvas same = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    canvas_clear(&c);
    draw(&c.surface, beyond, other[0], other[1]);
    draw(&same.surface, held, other[0], other[1]);
    assert_same_picture(&c.surface, &same.surface);
    canvas_free(&same);
    canvas_free(&c);
}

/* How often each pixel has been drawn. */
typedef struct hits {
    canvas c;
    int count[HEIGHT][WIDTH];
} hits;

static void hit(hits *h, point p0, point p1, point p2)
{
    canvas_clear(&h->c);
    draw(&h->c.surface, p0, p1, p2);
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            h->count[y][x] += stored_pixel(&h->c.surface, x, y) != 0;
        }
    }
}

static void assert_once(const hits *h, const char *what, int number)
{
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            if (h->count[y][x] != 1) {
                fail_msg("%s %d: pixel %d,%d drawn %d times", what, number, x, y, h->count[y][x]);
            }
        }
    }
}

static void hits_reset(hits *h)
{
    memset(h->count, 0, sizeof h->count);
}

TEST(jittered_grids)
{
    enum { CELLS = 9 };
    hits h = {canvas_new(&qtri_gray8, WIDTH, HEIGHT), {{0}}};
    uint64_t seed = 52;
    for (int n = 0; n < random_cases(300); n++) {
        point p[CELLS + 1][CELLS + 1];
        int32_t step = 6 * 256;
        for (int i = 0; i <= CELLS; i++) {
            for (int j = 0; j <= CELLS; j++) {
                p[i][j].x = (j - 1) * step + random_in(&seed, -600, 600);
                p[i][j].y = (i - 1) * step + random_in(&seed, -600, 600);
                if (n % 3 == 0) {
                    p[i][j].x &= ~127;
                    p[i][j].y &= ~127;
                }
            }
        }
        hits_reset(&h);
        for (int i = 0; i < CELLS; i++) {
            for (int j = 0; j < CELLS; j++) { /* cells stay convex enough: jitter < step / 2 */
                point *a = &p[i][j];
                point *b = &p[i][j + 1];
                point *c = &p[i + 1][j + 1];
                point *d = &p[i + 1][j];
                bool diagonal = edge(*a, *b, *c) > 0 && edge(*a, *c, *d) > 0;
                if (diagonal) {
                    hit(&h, *a, *b, *c);
                    hit(&h, *d, *a, *c);
                } else {
                    hit(&h, *a, *b, *d);
                    hit(&h, *b, *d, *c);
                }
            }
        }
        assert_once(&h, "grid", n);
    }
    canvas_free(&h.c);
}

TEST(fans)
{
    enum { RIM = 12 };
    hits h = {canvas_new(&qtri_gray8, WIDTH, HEIGHT), {{0}}};
    uint64_t seed = 53;
    for (int n = 0; n < random_cases(600); n++) {
        point hub = random_point(&seed, 4000);
        double radius = n % 2 != 0 ? 3e4 : 4e6;
        point rim[RIM];
        for (int i = 0; i < RIM; i++) {
            double angle = (i + random_in(&seed, 0, 900) / 1000.) * 6.283185307 / RIM;
            rim[i].x = hub.x + (int32_t)(radius * cos(angle));
            rim[i].y = hub.y + (int32_t)(radius * sin(angle));
        }
        hits_reset(&h);
        for (int i = 0; i < RIM; i++) {
            hit(&h, rim[i], n % 5 < 2 ? hub : rim[(i + 1) % RIM],
                n % 5 < 2 ? rim[(i + 1) % RIM] : hub);
        }
        assert_once(&h, "fan", n);
    }
    canvas_free(&h.c);
}

/* A square over everything, its triangles split at points inside again and again: slivers. */
TEST(split_triangles)
{
    enum { MOST = 150 };
    hits h = {canvas_new(&qtri_gray8, WIDTH, HEIGHT), {{0}}};
    uint64_t seed = 54;
    for (int n = 0; n < random_cases(120); n++) {
        int32_t r = n % 2 != 0 ? QTRI_SCREEN_MAX_24P8 : 11000;
        point q[4] = {{-r, -r}, {r, -r}, {r, r}, {-r, r}};
        point t[MOST][3] = {{q[0], q[1], q[2]}, {q[0], q[2], q[3]}};
        int count = 2;
        while (count + 2 <= MOST) {
            point *s = t[random_in(&seed, 0, count - 1)];
            point p = random_point(&seed, 5000);
            if (edge(s[0], s[1], p) <= 0 || edge(s[1], s[2], p) <= 0 || edge(s[2], s[0], p) <= 0) {
                s = NULL; /* find the triangle that holds the point */
                for (int i = 0; i < count && s == NULL; i++) {
                    if (edge(t[i][0], t[i][1], p) > 0 && edge(t[i][1], t[i][2], p) > 0 &&
                        edge(t[i][2], t[i][0], p) > 0) {
                        s = t[i];
                    }
                }
            }
            if (s == NULL) {
                continue; /* on an edge */
            }
            point c[3] = {s[0], s[1], s[2]};
            point one[3] = {c[1], c[2], p};
            point two[3] = {p, c[2], c[0]};
            s[2] = p;
            memcpy(t[count++], one, sizeof one);
            memcpy(t[count++], two, sizeof two);
        }
        hits_reset(&h);
        for (int i = 0; i < count; i++) {
            bool turned = random_flag(&seed);
            hit(&h, t[i][1], t[i][turned ? 0 : 2], t[i][turned ? 2 : 0]);
        }
        assert_once(&h, "split", n);
    }
    canvas_free(&h.c);
}

static bool draws(qtri_cull cull, bool clockwise)
{
    canvas c = canvas_new(&qtri_gray8, 8, 8);
    qtri_material material = plain_material();
    material.cull = cull;
    qtri_screen_vertex v[3] = {screen_at(0, 0),
                               screen_at(clockwise ? 2048 : 0, clockwise ? 0 : 2048),
                               screen_at(2048, 2048)};
    bool drawn = false;
    for (int turn = 0; turn < 3; turn++) {
        qtri_screen_vertex w[3] = {v[turn], v[(turn + 1) % 3], v[(turn + 2) % 3]};
        canvas_clear(&c);
        qtri_raster_triangle(&c.surface, qtri_pipelines_default, &material, w);
        bool now = stored_pixel(&c.surface, clockwise ? 5 : 2, clockwise ? 2 : 5) != 0;
        assert_true(turn == 0 || now == drawn);
        drawn = now;
    }
    canvas_free(&c);
    return drawn;
}

TEST(culling)
{
    assert_true(draws(QTRI_CULL_NONE, true) && draws(QTRI_CULL_NONE, false));
    assert_true(!draws(QTRI_CULL_BACK, true) && draws(QTRI_CULL_BACK, false));
    assert_true(draws(QTRI_CULL_FRONT, true) && !draws(QTRI_CULL_FRONT, false));
}

static point at(double x, double y)
{
    point p = {(int32_t)(x * 256), (int32_t)(y * 256)};
    return p;
}

TEST(pictures)
{
    canvas c = canvas_new(&qtri_rgb565, 6, 4);
    const qtri_surface *s = &c.surface;
    /* All corners on centres: left and top edges are in, right and bottom are out. */
    draw(s, at(1.5, .5), at(1.5, 3.5), at(4.5, 3.5));
    assert_raster(s, "......", ".#....", ".##...", "......");
    canvas_clear(&c);
    draw(s, at(1.5, .5), at(4.5, .5), at(4.5, 3.5));
    assert_raster(s, ".###..", "..##..", "...#..", "......");
    canvas_clear(&c);
    draw(s, at(1.5, .5), at(1.5, 3.5), at(4.5, 3.5)); /* together: a square of 3 x 3 */
    draw(s, at(1.5, .5), at(4.5, .5), at(4.5, 3.5));
    assert_raster(s, ".###..", ".###..", ".###..", "......");
    canvas_clear(&c);
    draw(s, at(1, 1), at(3, 1), at(1, 3)); /* corners between centres */
    assert_raster(s, "......", ".#....", "......", "......");
    canvas_clear(&c);
    draw(s, at(3, 1), at(3, 3), at(1, 3));
    assert_raster(s, "......", "..#...", ".##...", "......");
    canvas_clear(&c);
    draw(s, at(0, 0), at(0, 9), at(9, 0));
    assert_raster(s, "######", "######", "######", "#####.");
    canvas_clear(&c);
    draw(s, at(.5, 1.5), at(5.5, 1.5), at(3, 1.5)); /* no area */
    draw(s, at(2.5, 2.5), at(2.5, 2.5), at(2.5, 2.5));
    draw(s, at(2.6, 2.6), at(3.4, 2.6), at(2.6, 3.4)); /* between the centres */
    assert_raster(s, "......", "......", "......", "......");
    draw(s, at(2, 2), at(3, 2), at(2.5, 2.50390625)); /* tip one step below a centre */
    assert_raster(s, "......", "......", "..#...", "......");
    canvas_clear(&c);
    draw(s, at(2, 2), at(3, 2), at(2.5, 2.5)); /* tip on a centre */
    assert_raster(s, "......", "......", "......", "......");
    canvas_free(&c);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
