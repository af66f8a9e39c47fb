/*
 * Writes the meshes of the benchmark as C and as OBJ: bench_meshes FOLDER MODELS
 *
 * FOLDER/bench_meshes.c has a qtri_mesh for each and a compact one (mesh.h), unless BENCH_PLAIN is
 * defined: for a core from before there were compact meshes and bounds. FOLDER/NAME.obj and
 * FOLDER/NAME-compact.obj have the same numbers, for the double-precision reference. MODELS holds
 * spot.obj and teapot.obj; without one of them its mesh is empty. The knot is the project's own.
 *
 * Meshes are centred on their bounding box and scaled. Vertices are the file's positions: texture
 * coordinates and normals of the file are not used, normals are area-weighted over the faces that
 * share the position.
 */
#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../io/file.h"
#include "../io/obj.h"
#include "../tools/mesh_faces.h"
#include "../tools/mesh_generate.h"

static const struct model {
    const char *name;
    double scale;
    bool own; /* of mesh_generate.h */
} models[] = {{"spot", 1.28748383, false}, {"teapot", .48920438, false}, {"knot", 1.0, true}};

/* Keeps the statements v and f, and of a corner `v/vt/vn` the v; in place. */
static size_t keep_positions(char *text, size_t length)
{
    size_t kept = 0;
    for (size_t i = 0; i < length;) {
        const char *newline = memchr(&text[i], '\n', length - i);
        size_t next = newline == NULL ? length : (size_t)(newline - text) + 1;
        bool wanted = (text[i] == 'v' || text[i] == 'f') && i + 1 < next && text[i + 1] == ' ';
        for (bool in_position = true; wanted && i < next; i++) {
            in_position = text[i] == ' ' || text[i] == '\n' || (in_position && text[i] != '/');
            if (in_position) {
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

/* Q16.16 to the Q2.14 that a qtri_normal holds. */
static int32_t normal_q14(int32_t value)
{
    return round_q16((double)value / 4.0);
}

/* One array of the C file: `struct_name mesh_suffix[] = {...}`, three numbers an element. */
static void begin_array(FILE *out, const char *type, const char *name, const char *suffix)
{
    fprintf(out, "static const %s %s_%s[] = {\n", type, name, suffix);
}

static void write_element(FILE *out, const int32_t element[3])
{
    fprintf(out, "{%" PRId32 ", %" PRId32 ", %" PRId32 "},\n", element[0], element[1], element[2]);
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

static void write_wide(FILE *out, const char *name, const struct obj_mesh *mesh)
{
    int32_t reach[3];
    reach_of(mesh, reach);
    begin_array(out, "qtri_vec3", name, "positions");
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        write_element(out, mesh->positions[i]);
    }
    fprintf(out, "};\n");
    begin_array(out, "qtri_normal", name, "normals");
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const int32_t *n = mesh->normals[i];
        const int32_t normal[3] = {normal_q14(n[0]), normal_q14(n[1]), normal_q14(n[2])};
        write_element(out, normal);
    }
    fprintf(out, "};\nstatic const uint16_t %s_triangles[][3] = {\n", name);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        const uint32_t *t = mesh->triangles[i];
        fprintf(out, "{%" PRIu32 ", %" PRIu32 ", %" PRIu32 "},\n", t[0], t[1], t[2]);
    }
    fprintf(out,
            "};\nconst qtri_mesh bench_mesh_%s = {\n"
            "    .positions = %s_positions,\n    .normals = %s_normals,\n"
            "#ifndef BENCH_PLAIN\n",
            name, name, name);
    write_bounds(out, reach);
    fprintf(out,
            "#endif\n    .triangles = %s_triangles,\n    .vertex_count = %zu,\n"
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
    return round_q16((double)value * 127.0 / 65536.0);
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
    *faces = compact.faces;
    free(positions);
    free(triangles);
    free(planes);
}

static void write_compact(FILE *out, const char *name, const struct obj_mesh *mesh, int32_t extent)
{
    const int32_t half[3] = {extent, extent, extent};
    qtri_faces faces;
    fprintf(out, "#ifndef BENCH_PLAIN\n");
    begin_array(out, "qtri_position16", name, "positions16");
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const int32_t *p = mesh->positions[i];
        const int32_t position[3] = {compact_position(p[0], extent), compact_position(p[1], extent),
                                     compact_position(p[2], extent)};
        write_element(out, position);
    }
    fprintf(out, "};\n");
    begin_array(out, "qtri_normal8", name, "normals8");
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const int32_t *n = mesh->normals[i];
        const int32_t normal[3] = {compact_normal(n[0]), compact_normal(n[1]),
                                   compact_normal(n[2])};
        write_element(out, normal);
    }
    fprintf(out, "};\n");
    write_faces(out, name, mesh, extent, &faces);
    fprintf(out,
            "const qtri_mesh bench_mesh_%s_compact = {\n"
            "    .positions16 = %s_positions16,\n    .normals8 = %s_normals8,\n"
            "    .extent = %" PRId32 ",\n",
            name, name, name, extent);
    if (faces.planes != NULL) {
        fprintf(out, "    .faces = {&qtri_cull_by_planes, %s_planes, %" PRIu32 ", %u, %u},\n", name,
                faces.thin, faces.error_q16, faces.radius_q14);
    }
    write_bounds(out, half);
    fprintf(out,
            "    .triangles = %s_triangles,\n    .vertex_count = %zu,\n"
            "    .triangle_count = %zu};\n#endif\n\n",
            name, mesh->vertex_count, mesh->triangle_count);
}

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
    }
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        fprintf(out, "f");
        for (int corner = 0; corner < 3; corner++) {
            uint32_t vertex = mesh->triangles[i][corner] + 1;
            fprintf(out, " %" PRIu32 "//%" PRIu32, vertex, vertex);
        }
        fprintf(out, "\n");
    }
    return fclose(out) == 0;
}

/* The text of a mesh of ours, from a file in FOLDER. */
static bool generate(const char *folder, const char *name, char *path, size_t path_size)
{
    snprintf(path, path_size, "%s/%s-generated.obj", folder, name);
    FILE *file = fopen(path, "w");
    bool ok = file != NULL && mesh_generate(name, file);
    return file != NULL && fclose(file) == 0 && ok;
}

static bool write_model(FILE *out, const struct model *model, const char *folder,
                        const char *models_folder)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/%s.obj", models_folder, model->name);
    if (model->own && !generate(folder, model->name, path, sizeof path)) {
        fprintf(stderr, "bench_meshes: %s cannot be generated\n", model->name);
        return false;
    }
    if (file_inspect(path, NULL) == FILE_MISSING) {
        fprintf(out, "const qtri_mesh bench_mesh_%s = {0}, bench_mesh_%s_compact = {0};\n\n",
                model->name, model->name);
        return true;
    }
    struct file_content content;
    struct text_error error;
    struct obj_mesh mesh;
    if (!file_read(path, &content, &error)) {
        fprintf(stderr, "bench_meshes: %s\n", error.message);
        return false;
    }
    size_t length = keep_positions(content.bytes, content.length);
    bool ok = obj_parse(path, content.bytes, length, &mesh, &error);
    free(content.bytes);
    if (!ok) {
        fprintf(stderr, "bench_meshes: %s\n", error.message);
        return false;
    }
    center_and_scale(&mesh, model->scale);
    int32_t extent = extent_of(&mesh);
    write_wide(out, model->name, &mesh);
    write_compact(out, model->name, &mesh, extent);
    snprintf(path, sizeof path, "%s/%s.obj", folder, model->name);
    ok = write_obj(path, &mesh, 0);
    snprintf(path, sizeof path, "%s/%s-compact.obj", folder, model->name);
    ok = write_obj(path, &mesh, extent) && ok;
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
