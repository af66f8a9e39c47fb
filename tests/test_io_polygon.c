/* SPDX-License-Identifier: MIT */
/*
 * Polygons cut into triangles: each covers what the polygon covers, once.
 */
#define _POSIX_C_SOURCE 200809L
#include "support/io.h"

#include <math.h>

#include "io/polygon.h"

enum { MOST = 4096 };

static double corners[MOST][3];
static uint32_t triangles[MOST][3];

/* Corners in two dimensions, whole numbers, and where they go in space. */
struct outline {
    size_t count;
    int at[MOST][2];
};
static struct outline outline;

static void add(int x, int y)
{
    assert_true(outline.count < MOST);
    outline.at[outline.count][0] = x;
    outline.at[outline.count++][1] = y;
}

static uint32_t seed = 1;

/* 0 to limit - 1. */
static int draw(int limit)
{
    seed = seed * 1664525u + 1013904223u;
    return (int)((seed >> 8) % (uint32_t)limit);
}

static int64_t twice_area(const uint32_t *corner)
{
    const int *a = outline.at[corner[0]], *b = outline.at[corner[1]], *c = outline.at[corner[2]];
    return (int64_t)(b[0] - a[0]) * (c[1] - a[1]) - (int64_t)(b[1] - a[1]) * (c[0] - a[0]);
}

static int64_t outline_area(void)
{
    int64_t sum = 0;
    for (uint32_t i = 1; i + 1 < outline.count; i++) {
        sum += twice_area((const uint32_t[]){0, i, i + 1});
    }
    return sum;
}

/* On a plane that is seen best along `axis`; its slope lets no two corners have the same depth. */
static void triangulate(int axis)
{
    for (size_t i = 0; i < outline.count; i++) {
        const double x = outline.at[i][0], y = outline.at[i][1];
        corners[i][(axis + 1) % 3] = x * .0625 - 7;
        corners[i][(axis + 2) % 3] = y * .0625 + 100;
        corners[i][axis] = (x + 2 * y) * .015625;
    }
    memset(triangles, 255, sizeof triangles);
    polygon_triangulate((const double(*)[3])corners, outline.count, triangles);
    for (size_t i = 0; i + 2 < outline.count; i++) {
        for (int j = 0; j < 3; j++) {
            assert_true(triangles[i][j] < outline.count);
        }
    }
    assert_int_equal(triangles[outline.count - 2][0], UINT32_MAX);
}

/* Each triangle goes round as the polygon does, but for what a fan may, and their areas are its
   area: none overlap. */
static void assert_covered(const char *what)
{
    const int64_t whole = outline_area();
    for (int axis = 0; axis < 3; axis++) {
        int64_t sum = 0;
        triangulate(axis);
        for (size_t i = 0; i + 2 < outline.count; i++) {
            const int64_t part = twice_area(triangles[i]);
            if ((whole < 0 ? part : -part) > llabs(whole) / 65536) {
                fail_msg("%s of %zu corners: triangle %zu is turned over", what, outline.count, i);
            }
            sum += part;
        }
        assert_int_equal(sum, whole);
    }
}

static void assert_fan(void)
{
    for (uint32_t i = 0; i + 2 < outline.count; i++) {
        assert_int_equal(triangles[i][0], 0);
        assert_int_equal(triangles[i][1], i + 1);
        assert_int_equal(triangles[i][2], i + 2);
    }
}

/* The same polygon from each of its corners, both ways round. */
static void assert_covered_from_all(const char *what)
{
    for (int way = 0; way < 2; way++) {
        for (size_t turn = 0; turn < outline.count; turn++) {
            const int first[2] = {outline.at[0][0], outline.at[0][1]};
            memmove(outline.at, outline.at + 1, (outline.count - 1) * sizeof outline.at[0]);
            memcpy(outline.at[outline.count - 1], first, sizeof first);
            assert_covered(what);
        }
        for (size_t i = 0; i < outline.count / 2; i++) {
            const size_t other = outline.count - 1 - i;
            const int at[2] = {outline.at[i][0], outline.at[i][1]};
            memcpy(outline.at[i], outline.at[other], sizeof at);
            memcpy(outline.at[other], at, sizeof at);
        }
    }
}

static void set(const int (*at)[2], size_t count)
{
    outline.count = 0;
    for (size_t i = 0; i < count; i++) {
        add(at[i][0], at[i][1]);
    }
}

/* Round a circle, of radius as `radius` says of each corner. */
static void add_round(int x, int y, int count, int radius, int spread)
{
    for (int i = 0; i < count; i++) {
        const double angle = 6.283185307179586 * i / count;
        const double r = radius - draw(spread + 1);
        add(x + (int)(r * cos(angle)), y + (int)(r * sin(angle)));
    }
}

TEST(convex_polygons_are_fans)
{
    static const int collinear[][2] = {{0, 0}, {5, 0}, {9, 0}, {9, 9}, {4, 9}, {0, 9}, {0, 3}};
    for (int count = 4; count < 60; count++) {
        outline.count = 0;
        add_round(0, 0, count, 30000, 0);
        assert_covered("convex");
        assert_fan();
        for (int i = 0; i < count; i++) { /* the other way round */
            outline.at[i][1] = -outline.at[i][1];
        }
        assert_covered("convex");
        assert_fan();
    }
    set(collinear, ARRAY_LENGTH(collinear));
    assert_covered("with corners on its edges");
    assert_fan();
    /* Numbers of six digits of a turned square with a corner on an edge, a little inside. */
    static const double square[][3] = {
        {0, 0, .5}, {.333333, .333333, .5}, {1, 1.000001, .5}, {0, 2, .5}, {-1, 1, .5}};
    polygon_triangulate(square, 5, triangles);
    outline.count = 5;
    assert_fan();
}

TEST(concave_polygons_are_covered_once)
{
    static const int l[][2] = {{0, 0}, {8, 0}, {8, 3}, {3, 3}, {3, 9}, {0, 9}};
    static const int u[][2] = {{0, 0}, {9, 0}, {9, 9}, {6, 9}, {6, 3}, {3, 3}, {3, 9}, {0, 9}};
    static const int e[][2] = {{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 4},  {5, 4},
                               {5, 6}, {2, 6}, {2, 8}, {6, 8}, {6, 10}, {0, 10}};
    static const int arrow[][2] = {{0, 0}, {10, 5}, {0, 10}, {3, 5}};
    set(l, ARRAY_LENGTH(l));
    assert_covered_from_all("L");
    set(u, ARRAY_LENGTH(u));
    assert_covered_from_all("U");
    set(e, ARRAY_LENGTH(e));
    assert_covered_from_all("E");
    set(arrow, ARRAY_LENGTH(arrow));
    assert_covered_from_all("arrow");
    for (int points = 3; points < 12; points++) { /* stars */
        outline.count = 0;
        for (int i = 0; i < 2 * points; i++) {
            const double angle = 3.141592653589793 * i / points, r = i % 2 ? 900 : 10000;
            add((int)(r * cos(angle)), (int)(r * sin(angle)));
        }
        assert_covered_from_all("star");
    }
    outline.count = 0; /* a comb, and a spiral */
    for (int i = 0; i < 200; i++) {
        add(2 * i, 0);
        add(2 * i + 1, 1000);
    }
    add(400, -1);
    add(0, -1);
    assert_covered("comb");
    outline.count = 0;
    for (int i = 0; i < 300; i++) {
        add((int)((100 + 10 * i) * cos(i * .2)), (int)((100 + 10 * i) * sin(i * .2)));
    }
    for (int i = 299; i >= 0; i--) {
        add((int)((50 + 10 * i) * cos(i * .2)), (int)((50 + 10 * i) * sin(i * .2)));
    }
    assert_covered("spiral");
}

TEST(random_polygons_are_covered_once)
{
    for (int i = 0; i < 3000; i++) {
        outline.count = 0;
        add_round(0, 0, 3 + draw(60), 20000, 19000);
        assert_covered("random");
    }
}

/* Which cells of a board are set; the outline of those goes along their sides, corner by corner,
   and through one corner twice where two cells touch there. */
enum { BOARD = 10 };
static bool cells[BOARD + 2][BOARD + 2];

static bool cell_at(int x, int y)
{
    return cells[y + 1][x + 1];
}

static void add_outline_of_cells(int x, int y)
{
    static const int step[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    /* The cell ahead on the right of a direction, and on its left; set cells lie on the left. */
    static const int right[4][2] = {{0, -1}, {0, 0}, {-1, 0}, {-1, -1}};
    static const int left[4][2] = {{0, 0}, {-1, 0}, {-1, -1}, {0, -1}};
    const int start[2] = {x, y};
    int way = 0;
    outline.count = 0;
    do {
        add(x, y);
        x += step[way][0];
        y += step[way][1];
        if (cell_at(x + right[way][0], y + right[way][1])) {
            way = (way + 3) % 4;
        } else if (!cell_at(x + left[way][0], y + left[way][1])) {
            way = (way + 1) % 4;
        }
    } while (x != start[0] || y != start[1] || way != 0);
}

TEST(outlines_that_touch_themselves_are_covered_once)
{
    for (int i = 0; i < 3000; i++) {
        memset(cells, 0, sizeof cells);
        int x = BOARD / 2, y = BOARD / 2;
        for (int j = 0; j < 60; j++) {
            cells[y + 1][x + 1] = true;
            const int way = draw(4), next_x = x + (way == 0) - (way == 1),
                      next_y = y + (way == 2) - (way == 3);
            if (next_x >= 0 && next_x < BOARD && next_y >= 0 && next_y < BOARD) {
                x = next_x;
                y = next_y;
            }
        }
        for (y = 0, x = 0; !cell_at(x, y); x++) { /* its lowest row */
            if (x == BOARD) {
                x = -1;
                y++;
            }
        }
        add_outline_of_cells(x, y);
        assert_covered("cells");
    }
}

/* Corner i of a hole of 2 * half corners, clockwise from 0 degrees. */
static void add_hole_corner(int hole, int half, int i)
{
    const double angle = -3.141592653589793 * i / half;
    const double r = i % half == 0 ? 3000 : 3000 - draw(1000);
    add(10000 - 8000 * hole + (int)(r * cos(angle)), (int)(r * sin(angle)));
}

/* An edge leads from the first to each hole on its left: round half of each, and back. */
static void add_holes(int holes)
{
    const int half = 2 + draw(4);
    for (int hole = 0; hole < holes; hole++) {
        for (int i = 0; i <= half; i++) {
            add_hole_corner(hole, half, i);
        }
    }
    for (int hole = holes - 1; hole >= 0; hole--) {
        for (int i = half + (hole == holes - 1); i <= 2 * half; i++) {
            add_hole_corner(hole, half, i);
        }
    }
}

/* Holes are reached by an edge that is gone there and back, as programs write letters. */
TEST(holes_are_left_out)
{
    for (int i = 0; i < 3000; i++) {
        outline.count = 0;
        add_round(0, 0, 12 + draw(30), 20000, 2000);
        add(outline.at[0][0], outline.at[0][1]);
        add_holes(1 + draw(3));
        assert_covered("holes");
    }
}

/* Whatever it is, as many triangles come out, and what they cover with its sign is the polygon. */
TEST(others_end)
{
    static const double same[5][3] = {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
    static const double endless[5][3] = {
        {0, 2, 3}, {1, 5, 3}, {1e308, 2, 3}, {-1e308, 2, -1e308}, {0, 1e308, 0}};
    static const double tiny[5][3] = {
        {0, 0, 0}, {5e-324, 0, 0}, {5e-324, 5e-324, 0}, {0, 5e-324, 0}, {0, 1e-323, 5e-324}};
    for (int i = 0; i < 3000; i++) {
        const int count = 4 + draw(40), side = 2 + draw(i % 3 ? 10 : 20000);
        outline.count = 0;
        for (int j = 0; j < count; j++) {
            add(draw(side), i % 5 == 0 ? 0 : draw(side)); /* on a line */
        }
        for (int axis = 0; axis < 3; axis++) {
            int64_t sum = 0;
            triangulate(axis);
            for (int j = 0; j + 2 < count; j++) {
                sum += twice_area(triangles[j]);
            }
            assert_int_equal(sum, outline_area());
        }
    }
    polygon_triangulate(same, 5, triangles);
    polygon_triangulate(endless, 5, triangles);
    polygon_triangulate(tiny, 5, triangles);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
