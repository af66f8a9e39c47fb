/* SPDX-License-Identifier: MIT */
/*
 * Computed shapes. Round ones are profiles that turn about y: a row of circles, each with the
 * normal of its side, and triangles between a circle and the one before it where it asks for them,
 * row by row, to the right, the lower left one first.
 */
#include "model.h"
#include "matrix.h"

#include <math.h>
#include <string.h>

enum joined {
    APART, /* nothing leads to the circle before */
    JOINED,
    FROM_POINT, /* the circle before is a point */
    TO_POINT    /* this one is */
};

struct circle {
    double radius, y;
    double out, up; /* the normal: along the radius, along y */
    double v;
    enum joined joined;
};

struct shaper {
    struct ref_model *model;
    size_t vertices, triangles;
};

static void add_vertex(struct shaper *s, const double position[3], const double normal[3], double u,
                       double v)
{
    memcpy(s->model->positions[s->vertices], position, 3 * sizeof *position);
    memcpy(s->model->normals[s->vertices], normal, 3 * sizeof *normal);
    s->model->uvs[s->vertices][0] = u;
    s->model->uvs[s->vertices][1] = v;
    s->vertices++;
}

static void add_triangle(struct shaper *s, size_t a, size_t b, size_t c)
{
    uint32_t *triangle = s->model->triangles[s->triangles++];

    triangle[0] = (uint32_t)a;
    triangle[1] = (uint32_t)b;
    triangle[2] = (uint32_t)c;
}

static void add_circle(struct shaper *s, int slices, const struct circle *c)
{
    size_t first = s->vertices;
    size_t before = first - (size_t)slices - 1;

    for (int i = 0; i <= slices; i++) {
        double x, z;
        ref_sincos_degrees(360.0 * (i % slices) / slices, &x, &z);
        const double position[3] = {c->radius * x, c->y, c->radius * z};
        const double normal[3] = {c->out * x, c->up, c->out * z};
        add_vertex(s, position, normal, (double)i / slices, c->v);
    }
    for (size_t i = 0; i < (size_t)slices && c->joined != APART; i++) {
        if (c->joined != TO_POINT)
            add_triangle(s, before + i, first + i, first + i + 1);
        if (c->joined != FROM_POINT)
            add_triangle(s, before + i, first + i + 1, before + i + 1);
    }
}

static void add_sphere(struct shaper *s, double radius, int slices, int rows)
{
    for (int i = 0; i <= rows; i++) {
        double out, up;
        ref_sincos_degrees(180.0 * i / rows, &out, &up);
        struct circle c = {radius * out, radius * up, out, up, (double)i / rows, JOINED};
        c.joined = i == 0 ? APART : i == rows ? TO_POINT : i == 1 ? FROM_POINT : JOINED;
        add_circle(s, slices, &c);
    }
}

static void add_torus(struct shaper *s, double radius, double tube, int slices, int rings)
{
    for (int i = 0; i <= rings; i++) {
        double out, up;
        ref_sincos_degrees(360.0 * (i % rings) / rings, &out, &up);
        struct circle c = {radius + tube * out, tube * up, out, up, (double)i / rings, JOINED};
        c.joined = i == 0 ? APART : JOINED;
        add_circle(s, slices, &c);
    }
}

static void add_bottom(struct shaper *s, double radius, double half, int slices)
{
    const struct circle edge = {radius, -half, 0, -1, 1, APART};
    const struct circle middle = {0, -half, 0, -1, 1, TO_POINT};

    add_circle(s, slices, &edge);
    add_circle(s, slices, &middle);
}

static void add_cylinder(struct shaper *s, double radius, double half, int slices)
{
    const struct circle circles[4] = {{0, half, 0, 1, 0, APART},
                                      {radius, half, 0, 1, 0, FROM_POINT},
                                      {radius, half, 1, 0, 0, APART},
                                      {radius, -half, 1, 0, 1, JOINED}};

    for (int i = 0; i < 4; i++)
        add_circle(s, slices, &circles[i]);
    add_bottom(s, radius, half, slices);
}

/* The side goes out by the radius while it falls by the height: its normal is across that. */
static void add_cone(struct shaper *s, double radius, double half, int slices)
{
    double length = hypot(2.0 * half, radius);
    double out = length > 0.0 ? 2.0 * half / length : 0.0;
    double up = length > 0.0 ? radius / length : 0.0;
    const struct circle top = {0, half, out, up, 0, APART};
    const struct circle edge = {radius, -half, out, up, 1, FROM_POINT};

    add_circle(s, slices, &top);
    add_circle(s, slices, &edge);
    add_bottom(s, radius, half, slices);
}

/* Four sides that face +z, +x, -z, -x, then the upper one and the lower one. */
static void add_box(struct shaper *s, const double half[3])
{
    for (int side = 0; side < 6; side++) {
        double x, z;
        ref_sincos_degrees(90.0 * side, &x, &z);
        double normal[3] = {x, 0, z}, right[3] = {z, 0, -x}, up[3] = {0, 1, 0};
        if (side >= 4) {
            const double y = side == 4 ? 1 : -1;
            const double n[3] = {0, y, 0}, r[3] = {1, 0, 0}, u[3] = {0, 0, -y};
            memcpy(normal, n, sizeof n);
            memcpy(right, r, sizeof r);
            memcpy(up, u, sizeof u);
        }
        size_t first = s->vertices;
        for (int corner = 0; corner < 4; corner++) {
            double u = corner >= 2, v = corner == 1 || corner == 2;
            double position[3];
            for (int k = 0; k < 3; k++)
                position[k] = half[k] * (normal[k] + (2 * u - 1) * right[k] + (1 - 2 * v) * up[k]);
            add_vertex(s, position, normal, u, v);
        }
        add_triangle(s, first, first + 1, first + 2);
        add_triangle(s, first, first + 2, first + 3);
    }
}

static void add_grid(struct shaper *s, double half_x, double half_z, int columns, int rows)
{
    static const double up[3] = {0, 1, 0};
    size_t stride = (size_t)columns + 1;

    for (int z = 0; z <= rows; z++) {
        for (int x = 0; x <= columns; x++) {
            double u = (double)x / columns, v = (double)z / rows;
            const double position[3] = {half_x * (2 * u - 1), 0, half_z * (2 * v - 1)};
            size_t here = s->vertices;
            add_vertex(s, position, up, u, v);
            if (x > 0 && z > 0) {
                add_triangle(s, here - stride - 1, here - 1, here);
                add_triangle(s, here - stride - 1, here, here - stride);
            }
        }
    }
}

void ref_shape(struct ref_model *model, const struct scene_model *shape)
{
    struct shaper s = {model, 0, 0};
    const double size[3] = {shape->size[0] / 65536.0, shape->size[1] / 65536.0,
                            shape->size[2] / 65536.0};
    const int *count = shape->count;

    switch (shape->shape) {
    case SCENE_BOX:
        add_box(&s, size);
        break;
    case SCENE_SPHERE:
        add_sphere(&s, size[0], count[0], count[1]);
        break;
    case SCENE_CYLINDER:
        add_cylinder(&s, size[0], size[1], count[0]);
        break;
    case SCENE_CONE:
        add_cone(&s, size[0], size[1], count[0]);
        break;
    case SCENE_TORUS:
        add_torus(&s, size[0], size[1], count[0], count[1]);
        break;
    case SCENE_GRID:
        add_grid(&s, size[0], size[1], count[0], count[1]);
        break;
    }
}
