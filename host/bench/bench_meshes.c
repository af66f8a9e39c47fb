/* SPDX-License-Identifier: MIT */
/*
 * Writes the meshes of the benchmark as C and as OBJ: bench_meshes FOLDER MODELS
 *
 * FOLDER/bench_meshes.c has a qtri_mesh for each and a compact one (mesh.h). Beside them lies a
 * colour for each vertex, 127.5 (1 + n) of its normal, which a scene may give the mesh.
 * FOLDER/NAME.obj and FOLDER/NAME-compact.obj have the same numbers, for the double-precision
 * reference. MODELS holds spot.obj and teapot.obj; without one of them its meshes are empty. The
 * knot, the wall and the tori are the project's own.
 *
 * Meshes of files are centred on their bounding box and scaled. Vertices are the file's positions,
 * or, where the texture coordinates are kept, its pairs of both. Normals of the file are not used:
 * they are area-weighted over the faces that share the position.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../io/file.h"
#include "../io/file_identity.h"
#include "../io/obj.h"
#include "../io/xalloc.h"
#include "../tools/mesh_generate.h"
#include "mesh_write.h"

#define ONE 65536

enum source {
    SOURCE_FILE,      /* of MODELS */
    SOURCE_GENERATED, /* of mesh_generate.h */
    SOURCE_WALL,      /* of here */
    SOURCE_TORUS      /* likewise */
};

static const struct model {
    const char *name; /* of the mesh, in C */
    const char *file; /* its name where it comes from, without .obj */
    double scale;
    enum source source;
    bool keeps_uvs;
    int slices, rings; /* of a torus */
} models[] = {
    {"spot", "spot", 1.28748383, SOURCE_FILE, false, 0, 0},
    {"spot_uv", "spot", 1.28748383, SOURCE_FILE, true, 0, 0},
    {"teapot", "teapot", .48920438, SOURCE_FILE, false, 0, 0},
    {"knot", "knot", 1.0, SOURCE_GENERATED, false, 0, 0},
    {"knot_uv", "knot", 1.0, SOURCE_GENERATED, true, 0, 0},
    {"wall", NULL, 1.0, SOURCE_WALL, true, 0, 0},
    {"torus96", NULL, 1.3, SOURCE_TORUS, true, 8, 6},
    {"torus216", NULL, 1.3, SOURCE_TORUS, true, 12, 9},
    {"torus384", NULL, 1.3, SOURCE_TORUS, true, 16, 12},
    {"torus864", NULL, 1.3, SOURCE_TORUS, true, 24, 18},
};

/* ---- What a mesh is made from ---- */

static bool begins_with(const char *text, size_t length, const char *word)
{
    return length >= strlen(word) && memcmp(text, word, strlen(word)) == 0;
}

/*
 * Keeps the statements v and f, and of a corner `v/vt/vn` the v; with uvs also the statement vt,
 * and of a corner v/vt. In place.
 */
static size_t keep_statements(char *text, size_t length, bool with_uvs)
{
    size_t kept = 0;
    for (size_t i = 0; i < length;) {
        const char *newline = memchr(&text[i], '\n', length - i);
        size_t next = newline == NULL ? length : (size_t)(newline - text) + 1;
        bool wanted = begins_with(&text[i], next - i, "v ") ||
                      begins_with(&text[i], next - i, "f ") ||
                      (with_uvs && begins_with(&text[i], next - i, "vt "));
        for (int slashes = 0; wanted && i < next; i++) {
            bool between = text[i] == ' ' || text[i] == '\n';
            slashes = between ? 0 : slashes + (text[i] == '/');
            if (slashes <= (with_uvs ? 1 : 0)) {
                text[kept++] = text[i];
            }
        }
        i = next;
    }
    return kept;
}

static int32_t round_q16(double value)
{
    return (int32_t)lround(value);
}

static void center_and_scale(struct obj_mesh *mesh, double scale)
{
    for (int axis = 0; axis < 3; axis++) {
        int32_t least = INT32_MAX;
        int32_t greatest = INT32_MIN;
        for (size_t i = 0; i < mesh->vertex_count; i++) {
            int32_t value = mesh->positions[i][axis];
            least = value < least ? value : least;
            greatest = value > greatest ? value : greatest;
        }
        double center = ((double)least + (double)greatest) / 2.0;
        for (size_t i = 0; i < mesh->vertex_count; i++) {
            double value = ((double)mesh->positions[i][axis] - center) * scale;
            mesh->positions[i][axis] = round_q16(value);
        }
    }
}

#define WALL_COLUMNS 16
#define WALL_ROWS    8

/* z = .25 sin 3x cos 2y over x +-2.31, y +-1.74, from the top; u and v from 0 to 4 over it. */
static void set_wall_vertex(struct obj_mesh *mesh, int column, int row)
{
    int i = row * (WALL_COLUMNS + 1) + column;
    double along = (double)column / WALL_COLUMNS, down = (double)row / WALL_ROWS;
    double x = 2.31 * (2.0 * along - 1.0), y = 1.74 * (1.0 - 2.0 * down);
    double normal[3] = {-.75 * cos(3.0 * x) * cos(2.0 * y), .5 * sin(3.0 * x) * sin(2.0 * y), 1.0};
    const double position[3] = {x, y, .25 * sin(3.0 * x) * cos(2.0 * y)};
    double length = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + 1.0);
    for (int axis = 0; axis < 3; axis++) {
        mesh->positions[i][axis] = round_q16(position[axis] * ONE);
        mesh->normals[i][axis] = round_q16(normal[axis] / length * ONE);
    }
    mesh->uvs[i][0] = round_q16(4.0 * along * ONE);
    mesh->uvs[i][1] = round_q16(4.0 * down * ONE);
}

/* Vertices (-,-) (+,-) (+,+) (-,+), triangles (0,1,2) (0,2,3), as all quads of the benchmark. */
static void set_cell(struct obj_mesh *mesh, int columns, int column, int row)
{
    const uint32_t upper = (uint32_t)(row * (columns + 1) + column);
    const uint32_t lower = upper + (uint32_t)columns + 1;
    const uint32_t vertex[4] = {lower, lower + 1, upper + 1, upper};
    static const uint8_t order[2][3] = {{0, 1, 2}, {0, 2, 3}};
    for (int triangle = 0; triangle < 2; triangle++) {
        for (int i = 0; i < 3; i++) {
            mesh->triangles[2 * (row * columns + column) + triangle][i] =
                vertex[order[triangle][i]];
        }
    }
}

/* Room for columns x rows cells of two triangles. */
static void begin_grid(struct obj_mesh *mesh, int columns, int rows)
{
    memset(mesh, 0, sizeof *mesh);
    mesh->vertex_count = (size_t)(columns + 1) * (size_t)(rows + 1);
    mesh->triangle_count = (size_t)2 * (size_t)columns * (size_t)rows;
    mesh->positions = xcalloc(mesh->vertex_count, sizeof *mesh->positions);
    mesh->normals = xcalloc(mesh->vertex_count, sizeof *mesh->normals);
    mesh->uvs = xcalloc(mesh->vertex_count, sizeof *mesh->uvs);
    mesh->triangles = xcalloc(mesh->triangle_count, sizeof *mesh->triangles);
    for (int row = 0; row < rows; row++) {
        for (int column = 0; column < columns; column++) {
            set_cell(mesh, columns, column, row);
        }
    }
}

static void make_wall(struct obj_mesh *mesh)
{
    begin_grid(mesh, WALL_COLUMNS, WALL_ROWS);
    for (int row = 0; row <= WALL_ROWS; row++) {
        for (int column = 0; column <= WALL_COLUMNS; column++) {
            set_wall_vertex(mesh, column, row);
        }
    }
}

/* Radii .8 and .45 around the z axis; u from 0 to 1.9 around it, v from 0 to 1 around the tube. */
static void make_torus(struct obj_mesh *mesh, const struct model *model)
{
    const double turn = 2.0 * acos(-1.0);
    begin_grid(mesh, model->slices, model->rings);
    for (int ring = 0, i = 0; ring <= model->rings; ring++) {
        for (int slice = 0; slice <= model->slices; slice++, i++) {
            const double around = (double)slice / model->slices,
                         along = (double)ring / model->rings;
            const double a = turn * around, b = turn * along;
            const double normal[3] = {cos(b) * cos(a), cos(b) * sin(a), -sin(b)};
            const double center[3] = {.8 * cos(a), .8 * sin(a), 0.0};
            for (int axis = 0; axis < 3; axis++) {
                const double position = (center[axis] + .45 * normal[axis]) * model->scale;
                mesh->positions[i][axis] = round_q16(position * ONE);
                mesh->normals[i][axis] = round_q16(normal[axis] * ONE);
            }
            mesh->uvs[i][0] = round_q16(1.9 * around * ONE);
            mesh->uvs[i][1] = round_q16(along * ONE);
        }
    }
}

/* The text of a mesh of ours, from a file in FOLDER. */
static bool generate(const char *folder, const char *name, char *path, size_t path_size)
{
    snprintf(path, path_size, "%s/%s-generated.obj", folder, name);
    FILE *file = fopen(path, "w");
    bool ok = file != NULL && mesh_generate(name, file);
    return file != NULL && fclose(file) == 0 && ok;
}

/* Reads and prepares the mesh of a file. */
static bool read_mesh(const char *path, const struct model *model, struct obj_mesh *mesh,
                      struct text_error *error)
{
    struct file_content content;
    if (!file_read(path, &content, error)) {
        return false;
    }
    size_t length = keep_statements(content.bytes, content.length, model->keeps_uvs);
    bool ok = obj_parse(path, content.bytes, length, mesh, error);
    free(content.bytes);
    if (ok) {
        center_and_scale(mesh, model->scale);
    }
    return ok;
}

/* ---- Output ---- */

static bool write_model(FILE *out, const struct model *model, const char *folder,
                        const char *models_folder)
{
    char path[1024];
    struct text_error error = {0};
    struct obj_mesh mesh;
    bool ok = true;
    if (model->source == SOURCE_WALL) {
        make_wall(&mesh);
    } else if (model->source == SOURCE_TORUS) {
        make_torus(&mesh, model);
    } else {
        snprintf(path, sizeof path, "%s/%s.obj", models_folder, model->file);
        if (model->source == SOURCE_GENERATED &&
            !generate(folder, model->file, path, sizeof path)) {
            fprintf(stderr, "bench_meshes: %s cannot be generated\n", model->file);
            return false;
        }
        if (file_inspect(path, NULL) == FILE_MISSING) {
            mesh_write_empty(out, model->name);
            return true;
        }
        ok = read_mesh(path, model, &mesh, &error);
    }
    if (!ok) {
        fprintf(stderr, "bench_meshes: %s: %s\n", model->name, error.message);
        return false;
    }
    ok = mesh_write(out, model->name, folder, &mesh);
    obj_free(&mesh);
    return ok;
}

int main(int argc, char **argv)
{
    char path[1024];
    if (argc != 3) {
        fprintf(stderr, "usage: bench_meshes FOLDER MODELS\n");
        return 2;
    }
    snprintf(path, sizeof path, "%s/bench_meshes.c", argv[1]);
    FILE *out = fopen(path, "w");
    if (out == NULL) {
        perror(path);
        return 1;
    }
    fprintf(out, "#include \"bench_scenes.h\"\n\n");
    bool ok = true;
    for (size_t i = 0; i < sizeof models / sizeof models[0]; i++) {
        ok = ok && write_model(out, &models[i], argv[1], argv[2]);
    }
    return fclose(out) == 0 && ok ? 0 : 1;
}
