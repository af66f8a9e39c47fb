/* SPDX-License-Identifier: MIT */
#include "mesh_write.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

#include "../tools/mesh_faces.h"
#include "../tools/mesh_neighbours.h"

#define ONE 65536

static int32_t round_q16(double value)
{
    return (int32_t)lround(value);
}

/* ---- As C ---- */

/* Q16.16 to the Q2.14 that a qtri_normal holds. */
static int32_t normal_q14(int32_t value)
{
    return round_q16((double)value / 4.0);
}

/* One array of the C file: `type name_suffix[] = {...}`, `count` numbers an element. */
static void begin_array(FILE *out, const char *type, const char *name, const char *suffix)
{
    fprintf(out, "static const %s %s_%s[] = {\n", type, name, suffix);
}

static void write_element(FILE *out, const int32_t *element, int count)
{
    for (int i = 0; i < count; i++) {
        fprintf(out, "%s%" PRId32, i == 0 ? "{" : ", ", element[i]);
    }
    fprintf(out, "},\n");
}

/* qtri_mesh.bounds of what lies within +-half of the origin. */
static void write_bounds(FILE *out, const int32_t half[3])
{
    fprintf(out, "    .bounds = {{0, 0, 0}, {%" PRId32 ", %" PRId32 ", %" PRId32 "}},\n", half[0],
            half[1], half[2]);
}

/* The largest absolute value on each axis. */
static void reach_of(const struct obj_mesh *mesh, int32_t reach[3])
{
    for (int axis = 0; axis < 3; axis++) {
        reach[axis] = 0;
        for (size_t i = 0; i < mesh->vertex_count; i++) {
            int32_t value = abs(mesh->positions[i][axis]);
            reach[axis] = value > reach[axis] ? value : reach[axis];
        }
    }
}

static int32_t extent_of(const struct obj_mesh *mesh)
{
    int32_t reach[3];
    reach_of(mesh, reach);
    int32_t extent = reach[0] > reach[1] ? reach[0] : reach[1];
    return extent > reach[2] ? extent : reach[2];
}

/* What both forms of a mesh name: colours, texture coordinates, triangles. */
static void write_shared(FILE *out, const char *name, const struct obj_mesh *mesh)
{
    fprintf(out, "const qtri_rgb bench_colors_%s[] = {\n", name);
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        int32_t color[3];
        for (int c = 0; c < 3; c++) {
            color[c] = round_q16(127.5 * (1.0 + (double)mesh->normals[i][c] / ONE));
        }
        write_element(out, color, 3);
    }
    fprintf(out, "};\n");
    if (mesh->uvs != NULL) {
        begin_array(out, "qtri_vec2", name, "uvs");
        for (size_t i = 0; i < mesh->vertex_count; i++) {
            write_element(out, mesh->uvs[i], 2);
        }
        fprintf(out, "};\n");
    }
    fprintf(out, "static const uint16_t %s_triangles[][3] = {\n", name);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        const uint32_t *t = mesh->triangles[i];
        fprintf(out, "{%" PRIu32 ", %" PRIu32 ", %" PRIu32 "},\n", t[0], t[1], t[2]);
    }
    fprintf(out, "};\n");
}

static void write_wide(FILE *out, const char *name, const struct obj_mesh *mesh)
{
    int32_t reach[3];
    reach_of(mesh, reach);
    begin_array(out, "qtri_vec3", name, "positions");
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        write_element(out, mesh->positions[i], 3);
    }
    fprintf(out, "};\n");
    begin_array(out, "qtri_normal", name, "normals");
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const int32_t *n = mesh->normals[i];
        const int32_t normal[3] = {normal_q14(n[0]), normal_q14(n[1]), normal_q14(n[2])};
        write_element(out, normal, 3);
    }
    fprintf(out,
            "};\nconst qtri_mesh bench_mesh_%s = {\n"
            "    .positions = %s_positions,\n    .normals = %s_normals,\n",
            name, name, name);
    if (mesh->uvs != NULL) {
        fprintf(out, "    .uvs = %s_uvs,\n", name);
    }
    write_bounds(out, reach);
    fprintf(out,
            "    .triangles = %s_triangles,\n    .vertex_count = %zu,\n"
            "    .triangle_count = %zu};\n\n",
            name, mesh->vertex_count, mesh->triangle_count);
}

/* 16 bits of a coordinate within +-extent. */
static int32_t compact_position(int32_t value, int32_t extent)
{
    int32_t compact = round_q16((double)value * 32768.0 / (double)extent);
    return compact > 32767 ? 32767 : compact < -32767 ? -32767 : compact;
}

static int32_t compact_normal(int32_t value)
{
    return round_q16((double)value * 127.0 / ONE);
}

/* Q16.16 to the Q2.14 that a qtri_uv16 holds. */
static int32_t compact_uv(int32_t value)
{
    return round_q16((double)value / 4.0);
}

/* Whether there are texture coordinates and 16 bits hold them. */
static bool has_compact_uvs(const struct obj_mesh *mesh)
{
    bool fit = mesh->uvs != NULL;
    for (size_t i = 0; fit && i < mesh->vertex_count; i++) {
        for (int axis = 0; axis < 2; axis++) {
            int32_t compact = compact_uv(mesh->uvs[i][axis]);
            fit = fit && compact >= INT16_MIN && compact <= INT16_MAX;
        }
    }
    return fit;
}

static void write_compact_uvs(FILE *out, const char *name, const struct obj_mesh *mesh)
{
    begin_array(out, "qtri_uv16", name, "uvs16");
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const int32_t uv[2] = {compact_uv(mesh->uvs[i][0]), compact_uv(mesh->uvs[i][1])};
        write_element(out, uv, 2);
    }
    fprintf(out, "};\n");
}

static void *allocate(size_t count, size_t size)
{
    void *memory = calloc(count + 1, size);
    if (memory == NULL) {
        fprintf(stderr, "bench_meshes: out of memory\n");
        exit(1);
    }
    return memory;
}

static void write_neighbours(FILE *out, const char *name, qtri_mesh *mesh)
{
    uint16_t(*neighbours)[3] = allocate(mesh->triangle_count, sizeof *neighbours);
    if (!mesh_neighbours_make(mesh, neighbours)) {
        fprintf(stderr, "bench_meshes: out of memory\n");
        exit(1);
    }
    fprintf(out, "static const uint16_t %s_neighbours[][3] = {\n", name);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        fprintf(out, "{%u, %u, %u},\n", neighbours[i][0], neighbours[i][1], neighbours[i][2]);
    }
    fprintf(out, "};\n");
    free(neighbours);
}

/* Positions and triangles of the compact mesh. Those of faces that pay are written. */
static void write_faces(FILE *out, const char *name, const struct obj_mesh *mesh, int32_t extent,
                        qtri_faces *faces)
{
    qtri_position16 *positions = allocate(mesh->vertex_count, sizeof *positions);
    uint16_t(*triangles)[3] = allocate(mesh->triangle_count, sizeof *triangles);
    qtri_face8 *planes = allocate(mesh->triangle_count, sizeof *planes);
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const int32_t *p = mesh->positions[i];
        positions[i].x = (int16_t)compact_position(p[0], extent);
        positions[i].y = (int16_t)compact_position(p[1], extent);
        positions[i].z = (int16_t)compact_position(p[2], extent);
    }
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        for (int corner = 0; corner < 3; corner++) {
            triangles[i][corner] = (uint16_t)mesh->triangles[i][corner];
        }
    }
    qtri_mesh compact = {.positions16 = positions,
                         .extent = extent,
                         .triangles = (const uint16_t(*)[3])triangles,
                         .vertex_count = (uint32_t)mesh->vertex_count,
                         .triangle_count = (uint32_t)mesh->triangle_count};
    if (mesh_faces_make(&compact, planes)) {
        begin_array(out, "qtri_face8", name, "planes");
        for (size_t i = 0; i < mesh->triangle_count; i++) {
            fprintf(out, "{%d, %d, %d, %d},\n", planes[i].x, planes[i].y, planes[i].z, planes[i].d);
        }
        fprintf(out, "};\n");
    }
    write_neighbours(out, name, &compact);
    *faces = compact.faces;
    free(positions);
    free(triangles);
    free(planes);
}

/* Texture coordinates that 16 bits do not hold stay wide. */
static void write_compact(FILE *out, const char *name, const struct obj_mesh *mesh, int32_t extent)
{
    const int32_t half[3] = {extent, extent, extent};
    bool compact_uvs = has_compact_uvs(mesh);
    qtri_faces faces;
    begin_array(out, "qtri_position16", name, "positions16");
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const int32_t *p = mesh->positions[i];
        const int32_t position[3] = {compact_position(p[0], extent), compact_position(p[1], extent),
                                     compact_position(p[2], extent)};
        write_element(out, position, 3);
    }
    fprintf(out, "};\n");
    begin_array(out, "qtri_normal8", name, "normals8");
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const int32_t *n = mesh->normals[i];
        const int32_t normal[3] = {compact_normal(n[0]), compact_normal(n[1]),
                                   compact_normal(n[2])};
        write_element(out, normal, 3);
    }
    fprintf(out, "};\n");
    if (compact_uvs) {
        write_compact_uvs(out, name, mesh);
    }
    write_faces(out, name, mesh, extent, &faces);
    fprintf(out,
            "const qtri_mesh bench_mesh_%s_compact = {\n"
            "    .positions16 = %s_positions16,\n    .normals8 = %s_normals8,\n"
            "    .extent = %" PRId32 ",\n",
            name, name, name, extent);
    if (mesh->uvs != NULL) {
        fprintf(out, compact_uvs ? "    .uvs16 = %s_uvs16,\n" : "    .uvs = %s_uvs,\n", name);
    }
    if (faces.planes != NULL) {
        fprintf(out, "    .faces = {&qtri_cull_by_planes, %s_planes, %" PRIu32 ", %u, %u},\n", name,
                faces.thin, faces.error_q16, faces.radius_q14);
    }
    write_bounds(out, half);
    fprintf(out,
            "    .triangles = %s_triangles,\n    .neighbours = %s_neighbours,\n"
            "    .vertex_count = %zu,\n    .triangle_count = %zu};\n\n",
            name, name, mesh->vertex_count, mesh->triangle_count);
}

void mesh_write_empty(FILE *out, const char *name)
{
    fprintf(out,
            "const qtri_mesh bench_mesh_%s = {0}, bench_mesh_%s_compact = {0};\n"
            "const qtri_rgb bench_colors_%s[] = {{0, 0, 0}};\n\n",
            name, name, name);
}

/* ---- As OBJ ---- */

/*
 * With extent 0 the numbers of the wide mesh, exactly: 16 decimals hold a Q16.16, 14 a Q2.14. Else
 * those of the compact one, which readers round to Q16.16.
 */
static bool write_obj(const char *path, const struct obj_mesh *mesh, int32_t extent)
{
    FILE *out = fopen(path, "w");
    if (out == NULL) {
        perror(path);
        return false;
    }
    bool compact_uvs = extent != 0 && has_compact_uvs(mesh);
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        double p[3], n[3];
        for (int axis = 0; axis < 3; axis++) {
            int32_t position = mesh->positions[i][axis];
            int32_t normal = mesh->normals[i][axis];
            p[axis] = extent == 0 ? position / 65536.0
                                  : (double)compact_position(position, extent) * (double)extent /
                                        32768.0 / 65536.0;
            n[axis] = extent == 0 ? normal_q14(normal) / 16384.0 : compact_normal(normal) / 127.0;
        }
        fprintf(out, "v %.16f %.16f %.16f\nvn %.14f %.14f %.14f\n", p[0], p[1], p[2], n[0], n[1],
                n[2]);
        if (mesh->uvs != NULL) {
            double uv[2];
            for (int axis = 0; axis < 2; axis++) {
                int32_t value = mesh->uvs[i][axis];
                uv[axis] = compact_uvs ? compact_uv(value) / 16384.0 : value / 65536.0;
            }
            fprintf(out, "vt %.16f %.16f\n", uv[0], 1.0 - uv[1]);
        }
    }
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        fprintf(out, "f");
        for (int corner = 0; corner < 3; corner++) {
            uint32_t vertex = mesh->triangles[i][corner] + 1;
            if (mesh->uvs != NULL) {
                fprintf(out, " %" PRIu32 "/%" PRIu32 "/%" PRIu32, vertex, vertex, vertex);
            } else {
                fprintf(out, " %" PRIu32 "//%" PRIu32, vertex, vertex);
            }
        }
        fprintf(out, "\n");
    }
    return fclose(out) == 0;
}

bool mesh_write(FILE *out, const char *name, const char *folder, const struct obj_mesh *mesh)
{
    char path[1024];
    int32_t extent = extent_of(mesh);
    write_shared(out, name, mesh);
    write_wide(out, name, mesh);
    write_compact(out, name, mesh, extent);
    snprintf(path, sizeof path, "%s/%s.obj", folder, name);
    bool ok = write_obj(path, mesh, 0);
    snprintf(path, sizeof path, "%s/%s-compact.obj", folder, name);
    return write_obj(path, mesh, extent) && ok;
}
