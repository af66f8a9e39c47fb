/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700 /* M_PI */

#include "mesh_generate.h"

#include <math.h>
#include <string.h>

/* ---- Tubes ---- */

/* A closed tube: a circle of `radius` swept along a closed curve. */
struct tube {
    void (*curve)(double t, double point[3]); /* t in 0..1 */
    double radius;
    int rings, sides;
    int repeats_along, repeats_around; /* of the texture */
};

/* The (2,3) torus knot, scaled to fit. */
static void knot_curve(double t, double point[3])
{
    double p = 2.0 * M_PI * t;
    double r = 0.42 * (2.0 + cos(3.0 * p));
    point[0] = r * cos(2.0 * p);
    point[1] = r * sin(2.0 * p);
    point[2] = -0.55 * sin(3.0 * p);
}

static void torus_curve(double t, double point[3])
{
    point[0] = cos(2.0 * M_PI * t);
    point[1] = sin(2.0 * M_PI * t);
    point[2] = 0.0;
}

static const struct tube knot = {knot_curve, 0.26, 160, 18, 12, 1},
                         torus = {torus_curve, 0.4, 48, 24, 6, 2};

static void cross(double out[3], const double a[3], const double b[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static void normalize(double v[3])
{
    double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int i = 0; i < 3; i++) {
        v[i] /= length;
    }
}

/* Two axes across the curve. Referred to z, they close smoothly for curves that never point up. */
static void frame_at(const struct tube *tube, double t, double center[3], double side[3],
                     double up[3])
{
    double ahead[3];
    double behind[3];
    double tangent[3];
    const double z[3] = {0.0, 0.0, 1.0};
    tube->curve(t, center);
    tube->curve(t + 1e-5, ahead);
    tube->curve(t - 1e-5, behind);
    for (int i = 0; i < 3; i++) {
        tangent[i] = ahead[i] - behind[i];
    }
    normalize(tangent);
    cross(side, z, tangent);
    normalize(side);
    cross(up, tangent, side);
}

void mesh_write_quads(FILE *out, int rows, int columns)
{
    for (int row = 0; row < rows; row++) {
        for (int column = 0; column < columns; column++) {
            const int a = row * (columns + 1) + column + 1;
            const int b = a + columns + 1;
            fprintf(out, "f %d/%d/%d %d/%d/%d %d/%d/%d %d/%d/%d\n", a, a, a, a + 1, a + 1, a + 1,
                    b + 1, b + 1, b + 1, b, b, b);
        }
    }
}

static void write_tube(const struct tube *tube, FILE *out)
{
    for (int ring = 0; ring <= tube->rings; ring++) {
        double t = (double)ring / tube->rings;
        double center[3];
        double side[3];
        double up[3];
        frame_at(tube, ring == tube->rings ? 0.0 : t, center, side, up);
        for (int i = 0; i <= tube->sides; i++) {
            double angle = 2.0 * M_PI * (i % tube->sides) / tube->sides;
            double n[3];
            for (int axis = 0; axis < 3; axis++) {
                n[axis] = cos(angle) * side[axis] + sin(angle) * up[axis];
            }
            fprintf(out, "v %.6f %.6f %.6f\n", center[0] + tube->radius * n[0],
                    center[1] + tube->radius * n[1], center[2] + tube->radius * n[2]);
            fprintf(out, "vn %.6f %.6f %.6f\n", n[0], n[1], n[2]);
            fprintf(out, "vt %.6f %.6f\n", t * tube->repeats_along,
                    (double)i / tube->sides * tube->repeats_around);
        }
    }
    mesh_write_quads(out, tube->rings, tube->sides);
}

/* 0 in place of -0, which a reader may take for another place. */
static double positive_zero(double value)
{
    return fabs(value) < 5e-7 ? 0.0 : value;
}

static void write_numbers(FILE *out, const char *keyword, double x, double y, double z)
{
    fprintf(out, "%s %.6f %.6f %.6f\n", keyword, positive_zero(x), positive_zero(y),
            positive_zero(z));
}

/* ---- Surfaces of (columns + 1) x (rows + 1) vertices that have all three attributes ---- */

struct vertex {
    double position[3], normal[3], uv[2];
};

/* What is at a point of a flat sheet, seen from outside. */
struct plane {
    double normal[3], right[3], up[3];
};

struct sheet {
    int columns, rows;
    /* u and v in 0..1; seen from outside u grows to the right and v downwards */
    void (*at)(const struct plane *plane, double u, double v, struct vertex *out);
    const struct plane *plane;          /* of a flat sheet, else NULL */
    bool first_is_point, last_is_point; /* a row that is one point has no triangles of its own */
};

static void write_corner(FILE *out, int index)
{
    fprintf(out, " %d/%d/%d", index, index, index);
}

static void write_face(FILE *out, int a, int b, int c)
{
    fputc('f', out);
    write_corner(out, a);
    write_corner(out, b);
    write_corner(out, c);
    fputc('\n', out);
}

/* Returns the index of the next sheet's first vertex. */
static int write_sheet(FILE *out, const struct sheet *sheet, int first)
{
    int stride = sheet->columns + 1;
    for (int row = 0; row <= sheet->rows; row++) {
        for (int column = 0; column <= sheet->columns; column++) {
            struct vertex vertex;
            double u = (double)column / sheet->columns, v = (double)row / sheet->rows;
            sheet->at(sheet->plane, u, v, &vertex);
            write_numbers(out, "v", vertex.position[0], vertex.position[1], vertex.position[2]);
            write_numbers(out, "vn", vertex.normal[0], vertex.normal[1], vertex.normal[2]);
            fprintf(out, "vt %.6f %.6f\n", vertex.uv[0], 1.0 - vertex.uv[1]);
        }
    }
    for (int row = 0; row < sheet->rows; row++) {
        for (int column = 0; column < sheet->columns; column++) {
            int a = first + row * stride + column;
            int below = a + stride;
            if (!sheet->first_is_point || row > 0) {
                write_face(out, a, below, a + 1);
            }
            if (!sheet->last_is_point || row + 1 < sheet->rows) {
                write_face(out, a + 1, below, below + 1);
            }
        }
    }
    return first + stride * (sheet->rows + 1);
}

static void set(double out[3], double x, double y, double z)
{
    out[0] = x;
    out[1] = y;
    out[2] = z;
}

static void set_uv(struct vertex *out, double u, double v)
{
    out->uv[0] = u;
    out->uv[1] = v;
}

/* The angle of u around y, whose last column lies exactly on the first. */
static double around(double u)
{
    return u == 1.0 ? 0.0 : 2.0 * M_PI * u;
}

static void sphere_at(const struct plane *none, double u, double v, struct vertex *out)
{
    (void)none;
    double r = v == 0.0 || v == 1.0 ? 0.0 : sin(M_PI * v);
    set(out->position, r * sin(around(u)), cos(M_PI * v), r * cos(around(u)));
    set(out->normal, out->position[0], out->position[1], out->position[2]);
    set_uv(out, u, v);
}

static void side_at(const struct plane *none, double u, double v, struct vertex *out)
{
    (void)none;
    double x = sin(around(u)), z = cos(around(u));
    set(out->position, x, 1.0 - 2.0 * v, z);
    set(out->normal, x, 0.0, z);
    set_uv(out, u, v);
}

/* The slope of a cone as high as wide: its normal rises by half of what it goes out. */
static void cone_at(const struct plane *none, double u, double v, struct vertex *out)
{
    (void)none;
    double x = sin(around(u)), z = cos(around(u));
    set(out->position, v * x, 1.0 - 2.0 * v, v * z);
    set(out->normal, x * sqrt(.8), sqrt(.2), z * sqrt(.8));
    set_uv(out, u, v);
}

static void top_at(const struct plane *none, double u, double v, struct vertex *out)
{
    (void)none;
    double x = v * sin(around(u)), z = v * cos(around(u));
    set(out->position, x, 1.0, z);
    set(out->normal, 0.0, 1.0, 0.0);
    set_uv(out, .5 + .5 * x, .5 + .5 * z);
}

static void bottom_at(const struct plane *none, double u, double v, struct vertex *out)
{
    (void)none;
    double x = (1.0 - v) * sin(around(u)), z = (1.0 - v) * cos(around(u));
    set(out->position, x, -1.0, z);
    set(out->normal, 0.0, -1.0, 0.0);
    set_uv(out, .5 + .5 * x, .5 - .5 * z);
}

/* A square of side 2 in front of the origin. */
static void square_at(const struct plane *plane, double u, double v, struct vertex *out)
{
    for (int i = 0; i < 3; i++) {
        out->position[i] =
            plane->normal[i] + (2.0 * u - 1.0) * plane->right[i] + (1.0 - 2.0 * v) * plane->up[i];
        out->normal[i] = plane->normal[i];
    }
    set_uv(out, u, v);
}

static void grid_at(const struct plane *plane, double u, double v, struct vertex *out)
{
    square_at(plane, u, v, out);
    out->position[1] = 0.0;
}

static const struct plane front = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                          back = {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}},
                          right = {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
                          left = {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                          lid = {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}},
                          ground = {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}};

/* The cube has side 2 and a whole texture on each face, the grid side 2 in the plane y = 0, seen
   from above; round ones have radius 1, y from -1 to 1 and 32 sides, the sphere its poles at +-y,
   the cone its tip at y = 1. */
static const struct sheet cube[] =
    {
        {1, 1, square_at, &front, false, false}, {1, 1, square_at, &right, false, false},
        {1, 1, square_at, &back, false, false},  {1, 1, square_at, &left, false, false},
        {1, 1, square_at, &lid, false, false},   {1, 1, square_at, &ground, false, false},
},
                          sphere[] = {{32, 16, sphere_at, NULL, true, true}},
                          cylinder[] = {{32, 1, side_at, NULL, false, false},
                                        {32, 1, top_at, NULL, true, false},
                                        {32, 1, bottom_at, NULL, false, true}},
                          cone[] = {{32, 1, cone_at, NULL, true, false},
                                    {32, 1, bottom_at, NULL, false, true}},
                          grid[] = {{16, 16, grid_at, &lid, false, false}};

/* ---- The gear: rings about z, joined one to the next ---- */

enum { TEETH = 21, TOOTH_POINTS = 5, OUTLINE = TEETH * TOOTH_POINTS, RING = 36 };

/* The angle of a ring's point, in turns; rings of any count begin together. */
static double ring_turn(int count, int point)
{
    static const double tooth[TOOTH_POINTS] = {-.25, -.12, 0.0, .12, .25};
    if (count != OUTLINE) {
        return (double)point / count;
    }
    int number = point / TOOTH_POINTS;
    return (number + .25 + tooth[point % TOOTH_POINTS]) / TEETH;
}

/* The outline goes from root to root over a tip that is a little round. */
static double outline_radius(int point)
{
    static const double radius[TOOTH_POINTS] = {.84, .99, 1.0, .99, .84};
    return radius[point % TOOTH_POINTS];
}

struct ring {
    int count;     /* of its points */
    double radius; /* 0: the gear's outline */
    double z;
};

static void write_ring(FILE *out, const struct ring *ring)
{
    for (int i = 0; i < ring->count; i++) {
        double radius = ring->radius == 0.0 ? outline_radius(i) : ring->radius;
        double angle = 2.0 * M_PI * ring_turn(ring->count, i);
        write_numbers(out, "v", radius * cos(angle), radius * sin(angle), ring->z);
    }
}

/* Triangles between ring a, whose points begin at index a_first, and ring b, which is further along
   the profile: whichever point comes next is the next triangle's. */
static void join_rings(FILE *out, const struct ring *a, int a_first, const struct ring *b,
                       int b_first)
{
    int i = 0, j = 0;
    while (i < a->count || j < b->count) {
        int at_a = a_first + i % a->count, at_b = b_first + j % b->count;
        double next_a = i < a->count ? ring_turn(a->count, i + 1) : 2.0;
        double next_b = j < b->count ? ring_turn(b->count, j + 1) : 2.0;
        if (i + 1 == a->count) {
            next_a = 1.0;
        }
        if (j + 1 == b->count) {
            next_b = 1.0;
        }
        if (next_a <= next_b) {
            i++;
            fprintf(out, "f %d %d %d\n", at_a, at_b, a_first + i % a->count);
        } else {
            j++;
            fprintf(out, "f %d %d %d\n", at_a, at_b, b_first + j % b->count);
        }
    }
}

/* A fan that closes a ring; seen from +z where `up`. */
static void close_ring(FILE *out, const struct ring *ring, int first, int center, bool up)
{
    for (int i = 0; i < ring->count; i++) {
        int a = first + i, b = first + (i + 1) % ring->count;
        fprintf(out, "f %d %d %d\n", center, up ? a : b, up ? b : a);
    }
}

/*
 * 21 teeth with a recess on either side, on its shaft along z: without normals, lit face by face,
 * it is 500 vertices and 996 triangles. Two closed surfaces, one of them with a bore, have
 * V = F / 2 + 2.
 */
static void write_gear(FILE *out)
{
    enum { GEAR_RINGS = 8, RINGS = 10 };
    /* From the front of the outline inwards, through the bore, and outwards behind. */
    static const struct ring rings[RINGS] = {
        {OUTLINE, 0.0, .2}, {RING, .7, .2},    {RING, .66, .08}, {RING, .2, .08},
        {RING, .2, -.08},   {RING, .66, -.08}, {RING, .7, -.2},  {OUTLINE, 0.0, -.2},
        {RING, .17, .34},   {RING, .17, -.34},
    };
    int first[RINGS];
    int next = 1;
    for (int i = 0; i < RINGS; i++) {
        first[i] = next;
        write_ring(out, &rings[i]);
        next += rings[i].count;
    }
    write_numbers(out, "v", 0.0, 0.0, rings[GEAR_RINGS].z);
    write_numbers(out, "v", 0.0, 0.0, rings[GEAR_RINGS + 1].z);
    for (int i = 0; i < GEAR_RINGS; i++) {
        int after = (i + 1) % GEAR_RINGS;
        join_rings(out, &rings[after], first[after], &rings[i], first[i]);
    }
    join_rings(out, &rings[GEAR_RINGS], first[GEAR_RINGS], &rings[GEAR_RINGS + 1],
               first[GEAR_RINGS + 1]);
    close_ring(out, &rings[GEAR_RINGS], first[GEAR_RINGS], next, true);
    close_ring(out, &rings[GEAR_RINGS + 1], first[GEAR_RINGS + 1], next + 1, false);
}

/* ---- All of them ---- */

const char *const mesh_names[] = {"knot", "torus", "cube", "sphere", "cylinder",
                                  "cone", "grid",  "gear", NULL};

/* In the order of mesh_names: a tube, or sheets; neither is the gear. */
static const struct {
    const struct tube *tube;
    const struct sheet *sheets;
    int sheet_count;
} meshes[] = {
    {&knot, NULL, 0},    {&torus, NULL, 0}, {NULL, cube, 6}, {NULL, sphere, 1},
    {NULL, cylinder, 3}, {NULL, cone, 2},   {NULL, grid, 1}, {NULL, NULL, 0},
};

bool mesh_generate(const char *name, FILE *out)
{
    int which = 0, first = 1;
    while (mesh_names[which] != NULL && strcmp(name, mesh_names[which]) != 0) {
        which++;
    }
    if (mesh_names[which] == NULL) {
        return false;
    }
    fprintf(out, "# generated: qtri mesh %s\n", name);
    if (meshes[which].tube != NULL) {
        write_tube(meshes[which].tube, out);
    } else if (meshes[which].sheets == NULL) {
        write_gear(out);
    }
    for (int i = 0; i < meshes[which].sheet_count; i++) {
        first = write_sheet(out, &meshes[which].sheets[i], first);
    }
    return true;
}
