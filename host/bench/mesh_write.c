/* SPDX-License-Identifier: MIT */
#include "mesh_write.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

#include "../assets/asset_write.h"
#include "../assets/mesh_arrays.h"
#include "../tools/mesh_faces.h"
#include "../tools/mesh_neighbours.h"

#define ONE 65536.0

/* ---- The two forms of a mesh ---- */

/* A Q16.16 times a factor, which a quotient makes exact, as a number of an array. */
static int32_t scaled(int32_t value, double times, double per)
{
    return (int32_t)lround((double)value * times / per);
}

/* The array of vertices whose numbers, of Q16.16, are scaled; 16 bits hold -32767 and more. */
static void add_array(qtri_mesh *mesh, enum mesh_array which, const int32_t *from, double times,
                      double per)
{
    const struct mesh_array_kind *kind = &mesh_array_kinds[which];
    mesh_array_create(mesh, which);
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        int32_t numbers[MESH_NUMBERS];
        for (int k = 0; k < kind->numbers; k++) {
            const int32_t number = scaled(*from++, times, per);
            const bool is_held = kind->bytes == 2 && abs(number) > 32767;
            numbers[k] = !is_held ? number : number < 0 ? -32767 : 32767;
        }
        mesh_array_put(mesh, which, i, numbers);
    }
}

static qtri_mesh begin_mesh(const struct obj_mesh *from)
{
    qtri_mesh mesh = {.vertex_count = (uint32_t)from->vertex_count,
                      .triangle_count = (uint32_t)from->triangle_count};
    mesh_array_fill(&mesh, MESH_TRIANGLES, (const int32_t *)from->triangles[0]);
    return mesh;
}

/* The largest absolute value on each axis. */
static qtri_vec3 reach_of(const struct obj_mesh *mesh)
{
    int32_t reach[3] = {0, 0, 0};
    for (size_t i = 0; i < 3 * mesh->vertex_count; i++) {
        const int32_t value = abs(mesh->positions[i / 3][i % 3]);
        reach[i % 3] = value > reach[i % 3] ? value : reach[i % 3];
    }
    const qtri_vec3 result = {reach[0], reach[1], reach[2]};
    return result;
}

static qtri_mesh wide_mesh(const struct obj_mesh *from)
{
    qtri_mesh mesh = begin_mesh(from);
    add_array(&mesh, MESH_POSITIONS, from->positions[0], 1.0, 1.0);
    add_array(&mesh, MESH_NORMALS, from->normals[0], 16384.0, ONE);
    if (from->uvs != NULL) {
        add_array(&mesh, MESH_UVS, from->uvs[0], 1.0, 1.0);
    }
    mesh.bounds.half = reach_of(from);
    return mesh;
}

/* Whether 16 bits hold the texture coordinates: others stay wide. */
static bool are_compact(const struct obj_mesh *mesh)
{
    bool fit = true;
    for (size_t i = 0; fit && i < 2 * mesh->vertex_count; i++) {
        const int32_t compact = scaled(mesh->uvs[i / 2][i % 2], 16384.0, ONE);
        fit = compact >= INT16_MIN && compact <= INT16_MAX;
    }
    return fit;
}

/* With the planes of faces that pay, and neighbours. */
static qtri_mesh compact_mesh(const struct obj_mesh *from)
{
    const qtri_vec3 reach = reach_of(from);
    qtri_mesh mesh = begin_mesh(from);
    mesh.extent = reach.x > reach.y ? reach.x : reach.y;
    mesh.extent = mesh.extent > reach.z ? mesh.extent : reach.z;
    mesh.bounds.half = (qtri_vec3){mesh.extent, mesh.extent, mesh.extent};
    add_array(&mesh, MESH_POSITIONS16, from->positions[0], 32768.0, mesh.extent);
    add_array(&mesh, MESH_NORMALS8, from->normals[0], 127.0, ONE);
    if (from->uvs != NULL && are_compact(from)) {
        add_array(&mesh, MESH_UVS16, from->uvs[0], 16384.0, ONE);
    } else if (from->uvs != NULL) {
        add_array(&mesh, MESH_UVS, from->uvs[0], 1.0, 1.0);
    }
    mesh_faces_add(&mesh);
    (void)mesh_neighbours_add(&mesh); /* there are fewer triangles than 65536 */
    return mesh;
}

/* ---- As C ---- */

static void write_colors(FILE *out, const char *name, const struct obj_mesh *mesh)
{
    fprintf(out, "const qtri_rgb bench_colors_%s[] = {\n", name);
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        for (int c = 0; c < 3; c++) {
            fprintf(out, "%s%ld", c == 0 ? "{" : ", ",
                    lround(127.5 * (1.0 + (double)mesh->normals[i][c] / ONE)));
        }
        fprintf(out, "},\n");
    }
    fprintf(out, "};\n");
}

static void write_c(FILE *out, const char *name, const qtri_mesh *mesh)
{
    const struct asset_writer writer = {out, name, 0, 1};
    asset_write_arrays(&writer, mesh);
    fprintf(out, "const qtri_mesh bench_mesh_%s = {\n", name);
    asset_write_mesh(&writer, mesh);
    fprintf(out, "};\n\n");
}

void mesh_write_empty(FILE *out, const char *name)
{
    fprintf(out,
            "const qtri_mesh bench_mesh_%s = {0}, bench_mesh_%s_compact = {0};\n"
            "const qtri_rgb bench_colors_%s[] = {{0, 0, 0}};\n\n",
            name, name, name);
}

/* ---- As OBJ ---- */

static bool write_obj(const char *folder, const char *name, const char *suffix,
                      const qtri_mesh *mesh)
{
    char path[1024];
    struct asset_part part = {.mesh = *mesh};
    const struct asset asset = {.parts = &part, .count = 1};
    snprintf(path, sizeof path, "%s/%s%s.obj", folder, name, suffix);
    FILE *out = fopen(path, "w");
    if (out == NULL) {
        perror(path);
        return false;
    }
    asset_write_obj(&asset, true, out);
    return fclose(out) == 0;
}

bool mesh_write(FILE *out, const char *name, const char *folder, const struct obj_mesh *from)
{
    char compact_name[64];
    qtri_mesh wide = wide_mesh(from), compact = compact_mesh(from);
    snprintf(compact_name, sizeof compact_name, "%s_compact", name);
    write_colors(out, name, from);
    write_c(out, name, &wide);
    write_c(out, compact_name, &compact);
    bool ok = write_obj(folder, name, "", &wide);
    ok = write_obj(folder, name, "-compact", &compact) && ok;
    mesh_arrays_free(&wide);
    mesh_arrays_free(&compact);
    return ok;
}
