/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700 /* M_PI */

#include "mesh_generate.h"

#include <math.h>
#include <string.h>

#include "mesh_solids.h"

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

/* Order of mesh_names: what is not a tube is of mesh_solids.c. */
const char *const mesh_names[] = {"knot", "torus", "cube", "sphere", "cylinder",
                                  "cone", "grid",  "gear", NULL};

bool mesh_generate(const char *name, FILE *out)
{
    static const struct tube tubes[] = {
        {knot_curve, 0.26, 160, 18, 12, 1},
        {torus_curve, 0.4, 48, 24, 6, 2},
    };
    static void (*const solids[])(FILE *) = {mesh_solid_cube,     mesh_solid_sphere,
                                             mesh_solid_cylinder, mesh_solid_cone,
                                             mesh_solid_grid,     mesh_solid_gear};
    const int tube_count = sizeof tubes / sizeof tubes[0];
    for (int i = 0; mesh_names[i] != NULL; i++) {
        if (strcmp(name, mesh_names[i]) == 0) {
            fprintf(out, "# generated: qtri mesh %s\n", name);
            if (i < tube_count) {
                write_tube(&tubes[i], out);
            } else {
                solids[i - tube_count](out);
            }
            return true;
        }
    }
    return false;
}
