/* SPDX-License-Identifier: MIT */
#include "mesh_faces.h"

#include <math.h>
#include <stdlib.h>

#include "../io/xalloc.h"

/*
 * What a plane needs, by the bound in core/geometry/cull.c: with the eye's vector k of length 1, a
 * face of length s along its normal is culled where s n . k exceeds
 *
 *   SNAPPING thin + OFF error + ROUNDED
 *
 * for a mesh that is 2 extents and about 200 pixels wide, seen from 2.5 radii: SNAPPING is H |a ..
 * b| (1 + g)^2 / (1 - g) / |k| with H = 1.1 / 512 pixel, |a|, |b| = 100 and g = .4.
 */
#define SNAPPING (1.1 / 512.0 * 141.4 * (1.4 * 1.4 / .6) / 10000.0)
#define OFF      1.4
#define ROUNDED  .2

/* Lengths of x y z: the least that core allows, and how far off light may be. */
#define LENGTH_MIN 16.0
#define ANGLE_MAX  (1.0 / 64.0)

enum { SAMPLES = 400, WORTH_TRIANGLES = 128 };
#define WORTH_SHARE .33

struct face {
    double normal[3];  /* of length 1 */
    double corner[3];  /* in extents about the origin */
    double radius;     /* of the inner circle, in extents; 0: no area */
    double twice_area; /* in extents squared */
};

struct plane {
    qtri_face8 face;
    double length, error; /* along the normal, and beside it; length 0: none */
};

static void position(const qtri_mesh *mesh, uint32_t index, double out[3])
{
    if (mesh->positions16 != NULL) {
        const qtri_position16 *p = &mesh->positions16[index];
        out[0] = p->x / 32768.0;
        out[1] = p->y / 32768.0;
        out[2] = p->z / 32768.0;
        return;
    }
    const qtri_vec3 *p = &mesh->positions[index];
    out[0] = ((double)p->x - mesh->origin.x) / mesh->extent;
    out[1] = ((double)p->y - mesh->origin.y) / mesh->extent;
    out[2] = ((double)p->z - mesh->origin.z) / mesh->extent;
}

/* Of a wide mesh: the middle of its bounding box, and the box's largest half. */
static void set_extent(qtri_mesh *mesh)
{
    if (mesh->positions16 != NULL) {
        return;
    }
    double low[3] = {INFINITY, INFINITY, INFINITY};
    double high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        const qtri_vec3 *p = &mesh->positions[i];
        const double at[3] = {p->x, p->y, p->z};
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = fmin(low[axis], at[axis]);
            high[axis] = fmax(high[axis], at[axis]);
        }
    }
    double middle[3];
    double extent = 1.0;
    for (int axis = 0; axis < 3; axis++) {
        middle[axis] = mesh->vertex_count == 0 ? 0.0 : floor((low[axis] + high[axis]) / 2.0);
        extent = mesh->vertex_count == 0 ? 1.0 : fmax(extent, high[axis] - middle[axis]);
    }
    mesh->origin.x = (q16)middle[0];
    mesh->origin.y = (q16)middle[1];
    mesh->origin.z = (q16)middle[2];
    mesh->extent = (q16)fmin(extent, (double)INT32_MAX);
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void set_face(struct face *face, const qtri_mesh *mesh, uint32_t triangle)
{
    double p[3][3];
    double edge[3][3];
    double around = 0.0;
    *face = (struct face){0};
    for (int i = 0; i < 3; i++) {
        uint32_t index =
            mesh->triangles8 != NULL ? mesh->triangles8[triangle][i] : mesh->triangles[triangle][i];
        if (index >= mesh->vertex_count) {
            return;
        }
        position(mesh, index, p[i]);
    }
    for (int i = 0; i < 3; i++) {
        for (int axis = 0; axis < 3; axis++) {
            edge[i][axis] = p[(i + 1) % 3][axis] - p[i][axis];
        }
        face->corner[i] = p[0][i];
        around += sqrt(dot(edge[i], edge[i]));
    }
    for (int axis = 0; axis < 3; axis++) {
        const int next = (axis + 1) % 3;
        const int last = (axis + 2) % 3;
        face->normal[axis] = edge[0][next] * edge[1][last] - edge[0][last] * edge[1][next];
    }
    face->twice_area = sqrt(dot(face->normal, face->normal));
    if (face->twice_area > 0.0) {
        face->radius = face->twice_area / around;
        for (int axis = 0; axis < 3; axis++) {
            face->normal[axis] /= face->twice_area;
        }
    }
}

/* A whole number of a byte, without a call: most of the time of this file is spent here. */
static double nearest(double x)
{
    return (double)(int)(x < 0.0 ? x - .5 : x + .5);
}

enum { PART_MIN = 8, PART_MAX = 127 };

/* The planes nearest to a face whose largest part is PART_MIN and more; length 0: not allowed. */
static void find_planes(struct plane planes[PART_MAX + 1], const struct face *face)
{
    const double *n = face->normal;
    double largest = 0.0;
    for (int axis = 0; axis < 3; axis++) {
        largest = fabs(n[axis]) > largest ? fabs(n[axis]) : largest;
    }
    for (int part = PART_MIN; part <= PART_MAX; part++) {
        struct plane *plane = &planes[part];
        double q[3];
        double beside = 0.0;
        *plane = (struct plane){{0, 0, 0, 0}, 0.0, 0.0};
        if (!(largest > 0.0)) {
            continue; /* no area, no normal */
        }
        for (int axis = 0; axis < 3; axis++) {
            q[axis] = nearest(n[axis] * part / largest);
        }
        const double length = dot(q, n);
        for (int axis = 0; axis < 3; axis++) {
            const double difference = q[axis] - length * n[axis];
            beside += difference * difference;
        }
        beside = sqrt(beside);
        if (beside > ANGLE_MAX * length || dot(q, q) < LENGTH_MIN * LENGTH_MIN) {
            continue;
        }
        const double d = round(dot(q, face->corner));
        if (d >= -128.0 && d <= 127.0) {
            *plane = (struct plane){
                {(int8_t)q[0], (int8_t)q[1], (int8_t)q[2], (int8_t)d}, length, beside};
        }
    }
}

/* The longest of them with these limits; length 0: none. */
static struct plane longest(const struct plane planes[PART_MAX + 1], const struct face *face,
                            double thin, double error_max)
{
    const double length_max = thin * face->radius;
    if (face->radius > 0.0 && length_max >= LENGTH_MIN) {
        /* A plane is as long as its largest part, but for the angle between it and the normal. */
        const int most = (int)fmin(PART_MAX, length_max + 1.0);
        for (int part = most; part >= PART_MIN; part--) {
            const struct plane *plane = &planes[part];
            if (plane->length > 0.0 && plane->length <= length_max && plane->error <= error_max) {
                return *plane;
            }
        }
    }
    return (struct plane){{0, 0, 0, 0}, 0.0, 0.0};
}

/* The limits that are tried: of errors, and of lengths in median radii. */
static const double errors[] = {.06, .1, .15, .2, .3, .4, .6, .87};
static const double lengths[] = {16, 24, 32, 48, 64, 80, 96, 128, 160, 220, 320};
enum { ERRORS = sizeof errors / sizeof errors[0], LENGTHS = sizeof lengths / sizeof lengths[0] };

static double thin_of(int length, double median)
{
    return fmin(lengths[length] / median, (double)UINT32_MAX);
}

/*
 * The share of directions from which planes of all limits cull a face, over some of the faces. The
 * planes of a face are found once.
 */
static void find_shares(double share[ERRORS][LENGTHS], const struct face *faces, uint32_t count,
                        double median)
{
    struct plane planes[PART_MAX + 1];
    const uint32_t step = count / SAMPLES + 1;
    uint32_t samples = 0;
    for (uint32_t i = 0; i < count; i += step) {
        find_planes(planes, &faces[i]);
        for (int k = 0; k < ERRORS * LENGTHS; k++) {
            const double error_max = errors[k / LENGTHS];
            const double thin = thin_of(k % LENGTHS, median);
            const double least = SNAPPING * thin + OFF * error_max + ROUNDED;
            const struct plane plane = longest(planes, &faces[i], thin, error_max);
            share[k / LENGTHS][k % LENGTHS] +=
                plane.length > least ? .5 * (1.0 - least / plane.length) : 0.0;
        }
        samples++;
    }
    for (int k = 0; k < ERRORS * LENGTHS && samples > 0; k++) {
        share[k / LENGTHS][k % LENGTHS] /= samples;
    }
}

static int compare_doubles(const void *a, const void *b)
{
    const double *x = a;
    const double *y = b;
    return (*x > *y) - (*x < *y);
}

static double median_radius(const struct face *faces, uint32_t count)
{
    double *radius = xcalloc(count, sizeof *radius);
    for (uint32_t i = 0; i < count; i++) {
        radius[i] = faces[i].radius;
    }
    qsort(radius, count, sizeof *radius, compare_doubles);
    const double median = count == 0 ? 0.0 : radius[count / 2];
    free(radius);
    return median;
}

static uint32_t above(double value, double most)
{
    return (uint32_t)fmin(floor(value) + 1.0, most);
}

double mesh_faces_fill(qtri_mesh *mesh, qtri_face8 *planes)
{
    const uint32_t count = mesh->triangle_count;
    struct face *faces = xcalloc(count, sizeof *faces);
    mesh->faces.planes = NULL;
    set_extent(mesh);
    for (uint32_t i = 0; i < count; i++) {
        set_face(&faces[i], mesh, i);
    }
    const double median = median_radius(faces, count);
    double share[ERRORS][LENGTHS] = {{0}};
    double best = 0.0;
    double error_max = 0.0;
    double thin_max = 0.0;
    if (median > 0.0) {
        find_shares(share, faces, count, median);
    }
    for (int k = 0; k < ERRORS * LENGTHS; k++) {
        if (share[k / LENGTHS][k % LENGTHS] > best) {
            best = share[k / LENGTHS][k % LENGTHS];
            error_max = errors[k / LENGTHS];
            thin_max = thin_of(k % LENGTHS, median);
        }
    }
    double thin = 0.0;
    double error = 0.0;
    double radius = 1.0;
    for (uint32_t i = 0; i < count; i++) {
        struct plane near[PART_MAX + 1];
        find_planes(near, &faces[i]);
        const struct plane plane = longest(near, &faces[i], thin_max, error_max);
        planes[i] = plane.face;
        error = fmax(error, plane.error);
        thin = plane.length > 0.0 ? fmax(thin, plane.length / faces[i].radius) : thin;
    }
    free(faces);
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        double p[3];
        position(mesh, i, p);
        radius = fmax(radius, sqrt(dot(p, p)));
    }
    mesh->faces.culling = &qtri_cull_by_planes;
    mesh->faces.planes = planes;
    mesh->faces.thin = above(thin, (double)UINT32_MAX);
    mesh->faces.error_q16 = (uint16_t)above(error * 65536.0, UINT16_MAX);
    mesh->faces.radius_q14 = (uint16_t)above(radius * 16384.0, UINT16_MAX);
    return best;
}

/* 0 for a closed mesh, 1 for a plane. */
static double openness(const qtri_mesh *mesh)
{
    double sum[3] = {0.0, 0.0, 0.0};
    double area = 0.0;
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        struct face face;
        set_face(&face, mesh, i);
        for (int axis = 0; axis < 3 && face.radius > 0.0; axis++) {
            sum[axis] += face.normal[axis] * face.twice_area;
        }
        area += face.twice_area;
    }
    return area > 0.0 ? sqrt(dot(sum, sum)) / area : 1.0;
}

bool mesh_faces_make(qtri_mesh *mesh, qtri_face8 *planes)
{
    set_extent(mesh);
    const bool made = mesh->triangle_count >= WORTH_TRIANGLES && openness(mesh) < .5 &&
                      mesh_faces_fill(mesh, planes) >= WORTH_SHARE;
    if (!made) {
        mesh->faces.planes = NULL;
    }
    return made;
}

void mesh_faces_add(qtri_mesh *mesh)
{
    qtri_face8 *planes = xcalloc(mesh->triangle_count, sizeof *planes);
    if (!mesh_faces_make(mesh, planes)) {
        free(planes);
    }
}
