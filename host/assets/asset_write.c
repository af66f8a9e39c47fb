/* SPDX-License-Identifier: MIT */
#include "asset_write.h"

#include <inttypes.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "asset_header.h"
#include "mesh_arrays.h"

enum { COLUMNS = 100 };

/* An array being written: rows of elements, as many as fit a line. */
struct array {
    FILE *out;
    int column;
};

static void begin_array(struct array *array, FILE *out, const char *type, const char *name,
                        const char *dimensions)
{
    array->out = out;
    array->column = 0;
    fprintf(out, "static const %s %s%s = {", type, name, dimensions);
}

static void end_array(const struct array *array)
{
    fputs("\n};\n\n", array->out);
}

static void write_element(struct array *array, const int32_t *numbers, int count)
{
    char text[80];
    int length = 0;
    for (int i = 0; i < count; i++) { /* 4 numbers of 11 characters at most, and what is between */
        length += snprintf(text + length, sizeof text - (size_t)length, "%s%" PRId32,
                           i == 0 ? "{" : ", ", numbers[i]);
    }
    length += snprintf(text + length, sizeof text - (size_t)length, "},");
    if (array->column == 0 || array->column + 1 + length > COLUMNS) {
        fprintf(array->out, "\n    %s", text);
        array->column = 4 + length;
    } else {
        fprintf(array->out, " %s", text);
        array->column += 1 + length;
    }
}

static void name_of(char out[160], const char *name, size_t part, size_t count, const char *what)
{
    if (count == 1) {
        (void)snprintf(out, 160, "%s_%s", name, what);
    } else {
        (void)snprintf(out, 160, "%s_%zu_%s", name, part, what);
    }
}

void asset_write_comment(FILE *out, const char *text)
{
    for (; *text != '\0'; text++) {
        bool plain = *text >= ' ' && *text <= '~' && strchr("*\\?", *text) == NULL;
        fputc(plain ? *text : '_', out);
    }
}

/* ---- The arrays of a mesh ---- */

static void write_array(const struct asset_writer *writer, const qtri_mesh *mesh,
                        enum mesh_array which, const char *what)
{
    const struct mesh_array_kind *kind = &mesh_array_kinds[which];
    const bool is_of_numbers =
        which == MESH_TRIANGLES || which == MESH_TRIANGLES8 || which == MESH_NEIGHBOURS;
    struct array array;
    char name[160];
    name_of(name, writer->name, writer->part, writer->count, what);
    begin_array(&array, writer->out, kind->type, name, is_of_numbers ? "[][3]" : "[]");
    for (size_t i = 0; i < mesh_array_count(mesh, which); i++) {
        int32_t numbers[MESH_NUMBERS];
        mesh_array_get(mesh, which, i, numbers);
        write_element(&array, numbers, kind->numbers);
    }
    end_array(&array);
}

void asset_write_arrays(const struct asset_writer *writer, const qtri_mesh *mesh)
{
    for (enum mesh_array i = 0; i < MESH_ARRAYS; i++) {
        if (mesh_array(mesh, i) != NULL) {
            write_array(writer, mesh, i, mesh_array_kinds[i].name);
        }
    }
}

void asset_target_name(const struct asset_writer *writer, size_t target, char out[160])
{
    char what[40];
    (void)snprintf(what, sizeof what, "target_%zu", target);
    name_of(out, writer->name, writer->part, writer->count, what);
}

void asset_write_targets(const struct asset_writer *writer, const struct asset_part *part)
{
    qtri_mesh mesh = part->mesh;
    for (size_t i = 0; i < part->target_count; i++) {
        char what[40];
        (void)snprintf(what, sizeof what, "target_%zu", i);
        mesh.positions16 = &part->targets[i * mesh.vertex_count];
        write_array(writer, &mesh, MESH_POSITIONS16, what);
    }
}

/* ---- The mesh itself ---- */

/* An array's name, or NULL where the mesh has it not. */
static void write_pointers(const struct asset_writer *writer, const qtri_mesh *mesh,
                           const enum mesh_array *arrays, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const struct mesh_array_kind *kind = &mesh_array_kinds[arrays[i]];
        char name[160] = "NULL";
        if (mesh_array(mesh, arrays[i]) != NULL) {
            name_of(name, writer->name, writer->part, writer->count, kind->name);
        }
        fprintf(writer->out, "    %s, /* %s */\n", name, kind->field);
    }
}

void asset_write_mesh(const struct asset_writer *writer, const qtri_mesh *mesh)
{
    static const enum mesh_array wide[] = {MESH_POSITIONS, MESH_NORMALS, MESH_UVS, MESH_COLORS,
                                           MESH_TRIANGLES};
    static const enum mesh_array compact[] = {MESH_POSITIONS16, MESH_NORMALS8, MESH_UVS16,
                                              MESH_TRIANGLES8};
    static const enum mesh_array neighbours = MESH_NEIGHBOURS;
    FILE *out = writer->out;
    const qtri_box *box = &mesh->bounds;
    write_pointers(writer, mesh, wide, sizeof wide / sizeof wide[0]);
    fprintf(out, "    %" PRIu32 "u, %" PRIu32 "u, /* vertices, triangles */\n", mesh->vertex_count,
            mesh->triangle_count);
    write_pointers(writer, mesh, compact, sizeof compact / sizeof compact[0]);
    fprintf(out, "    {%" PRId32 ", %" PRId32 ", %" PRId32 "}, %" PRId32 ", /* origin, extent */\n",
            mesh->origin.x, mesh->origin.y, mesh->origin.z, mesh->extent);
    if (mesh->faces.planes != NULL) {
        char name[160];
        name_of(name, writer->name, writer->part, writer->count, "planes");
        fprintf(out, "    {&qtri_cull_by_planes, %s, %" PRIu32 "u, %u, %u}, /* faces */\n", name,
                mesh->faces.thin, mesh->faces.error_q16, mesh->faces.radius_q14);
    } else {
        fputs("    {NULL, NULL, 0, 0, 0}, /* faces */\n", out);
    }
    fprintf(out,
            "    {{%" PRId32 ", %" PRId32 ", %" PRId32 "}, {%" PRId32 ", %" PRId32 ", %" PRId32
            "}}, /* bounds */\n",
            box->center.x, box->center.y, box->center.z, box->half.x, box->half.y, box->half.z);
    if (mesh->neighbours != NULL) {
        write_pointers(writer, mesh, &neighbours, 1);
    } else {
        fputs("    NULL, /* neighbours: `qtri neighbours` makes them */\n", out);
    }
}

static void write_summary(FILE *out, const void *thing, const struct asset_names *names)
{
    const struct asset *asset = thing;
    fprintf(out,
            "/*\n * %s: %" PRIu32 " vertices, %" PRIu32
            " triangles, %zu bytes of flash. Made by `qtri mesh`.\n",
            names->name, asset_vertex_count(asset), asset_triangle_count(asset),
            asset_flash_bytes(asset));
    for (size_t i = 0; i < asset->count; i++) {
        const struct asset_part *part = &asset->parts[i];
        const uint8_t *c = part->material.color;
        if (asset->count == 1 && part->material.name[0] == '\0') {
            continue;
        }
        fprintf(out, " * Material %zu, ", i);
        asset_write_comment(out, part->material.name[0] != '\0' ? part->material.name : "unnamed");
        fprintf(out, ": colour %d %d %d", c[0], c[1], c[2]);
        if (part->material.texture[0] != '\0') {
            fputs(", texture ", out);
            asset_write_comment(out, part->material.texture);
        }
        fputs("\n", out);
    }
    fputs(" */\n", out);
}

static void write_data(FILE *out, const void *thing, const struct asset_names *names)
{
    const struct asset *asset = thing;
    const char *name = names->name, *linkage = names->linkage, *capitals = names->capitals;
    for (size_t i = 0; i < asset->count; i++) {
        const struct asset_writer writer = {out, name, i, asset->count};
        asset_write_arrays(&writer, &asset->parts[i].mesh);
    }
    if (asset->count == 1) {
        const struct asset_writer writer = {out, name, 0, 1};
        fprintf(out, "%sconst qtri_mesh %s = {\n", linkage, name);
        asset_write_mesh(&writer, &asset->parts[0].mesh);
        fputs("};\n", out);
        return;
    }
    fprintf(out, "%sconst qtri_rgb %s_materials[%s_MESHES] = {\n", linkage, name, capitals);
    for (size_t i = 0; i < asset->count; i++) {
        const uint8_t *c = asset->parts[i].material.color;
        fprintf(out, "    {%d, %d, %d},\n", c[0], c[1], c[2]);
    }
    fprintf(out, "};\n\n%sconst qtri_mesh %s[%s_MESHES] = {\n", linkage, name, capitals);
    for (size_t i = 0; i < asset->count; i++) {
        const struct asset_writer writer = {out, name, i, asset->count};
        fputs("    {\n", out);
        asset_write_mesh(&writer, &asset->parts[i].mesh);
        fputs("    },\n", out);
    }
    fputs("};\n", out);
}

static void write_declarations(FILE *out, const void *thing, const struct asset_names *names)
{
    const struct asset *asset = thing;
    const char *name = names->name, *capitals = names->capitals;
    if (asset->count == 1) {
        fprintf(out, "extern const qtri_mesh %s;\n", name);
    } else {
        fprintf(out, "extern const qtri_mesh %s[%s_MESHES];\n", name, capitals);
        fprintf(out, "extern const qtri_rgb %s_materials[%s_MESHES];\n", name, capitals);
    }
}

static void write_sizes(FILE *out, const void *thing, const struct asset_names *names)
{
    const struct asset *asset = thing;
    const char *capitals = names->capitals;
    uint32_t vertices = 0, triangles = 0;
    for (size_t i = 0; i < asset->count; i++) {
        const qtri_mesh *mesh = &asset->parts[i].mesh;
        vertices = mesh->vertex_count > vertices ? mesh->vertex_count : vertices;
        triangles = mesh->triangle_count > triangles ? mesh->triangle_count : triangles;
    }
    fprintf(out, "#define %s_VERTICES %" PRIu32 "%s\n", capitals, vertices,
            asset->count > 1 ? " /* of the largest mesh */" : "");
    fprintf(out, "#define %s_TRIANGLES %" PRIu32 "\n\n", capitals, triangles);
    fprintf(out,
            "/* Memory to draw it in bands: static uint8_t memory[%s_BYTES(240, 16)]; of a frame "
            "of 240 "
            "rows. */\n"
            "#define %s_BYTES(height, rows) \\\n"
            "    QTRI_PREPARED_BYTES(%s_VERTICES, %s_TRIANGLES, height, rows)\n\n",
            capitals, capitals, capitals, capitals);
    if (asset->count > 1) {
        fprintf(out, "#define %s_MESHES %zu /* one a material */\n\n", capitals, asset->count);
    }
}

/* `const qtri_mesh NAME`, or `NAME[NAME_MESHES]` with the materials' colours beside it. */
const struct asset_header asset_header_mesh = {"MESH", write_summary, write_sizes, write_data,
                                               write_declarations};

/* ---- OBJ ---- */

static void position_of(const qtri_mesh *mesh, uint32_t i, double out[3])
{
    const bool wide = mesh->positions != NULL;
    const int32_t origin[3] = {mesh->origin.x, mesh->origin.y, mesh->origin.z};
    int32_t p[3];
    mesh_array_get(mesh, wide ? MESH_POSITIONS : MESH_POSITIONS16, i, p);
    for (int axis = 0; axis < 3; axis++) {
        out[axis] = wide ? p[axis] / 65536.0
                         : (origin[axis] + (double)mesh->extent * p[axis] / 32768.0) / 65536.0;
    }
}

/* 16 decimals hold a Q16.16, 14 a Q2.14. */
static void write_obj_vertex(const qtri_mesh *mesh, uint32_t i, bool is_exact, FILE *out)
{
    double at[3];
    int32_t n[3];
    position_of(mesh, i, at);
    fprintf(out, is_exact ? "v %.16f %.16f %.16f" : "v %.9g %.9g %.9g", at[0], at[1], at[2]);
    if (mesh->colors != NULL) {
        const qtri_rgb c = mesh->colors[i];
        fprintf(out, " %.4g %.4g %.4g", c.r / 255.0, c.g / 255.0, c.b / 255.0);
    }
    fputc('\n', out);
    if (mesh->normals != NULL || mesh->normals8 != NULL) {
        const bool wide = mesh->normals != NULL;
        const double one = wide ? 16384.0 : 127.0;
        mesh_array_get(mesh, wide ? MESH_NORMALS : MESH_NORMALS8, i, n);
        fprintf(out,
                is_exact ? "vn %.14f %.14f %.14f\n"
                : wide   ? "vn %.7g %.7g %.7g\n"
                         : "vn %.4g %.4g %.4g\n",
                n[0] / one, n[1] / one, n[2] / one);
    }
    if (mesh->uvs != NULL || mesh->uvs16 != NULL) {
        const double one = mesh->uvs != NULL ? 65536.0 : 16384.0;
        mesh_array_get(mesh, mesh->uvs != NULL ? MESH_UVS : MESH_UVS16, i, n);
        fprintf(out, is_exact ? "vt %.16f %.16f\n" : "vt %.9g %.9g\n", n[0] / one,
                1.0 - n[1] / one);
    }
}

void asset_write_obj(const struct asset *asset, bool is_exact, FILE *out)
{
    uint32_t first = 1;
    fputs("# made by qtri mesh\n", out);
    for (size_t part = 0; part < asset->count; part++) {
        const qtri_mesh *mesh = &asset->parts[part].mesh;
        bool uvs = mesh->uvs != NULL || mesh->uvs16 != NULL;
        bool normals = mesh->normals != NULL || mesh->normals8 != NULL;
        for (uint32_t i = 0; i < mesh->vertex_count; i++) {
            write_obj_vertex(mesh, i, is_exact, out);
        }
        if (asset->count > 1) {
            fprintf(out, "g material_%zu\n", part);
        }
        for (uint32_t i = 0; i < mesh->triangle_count; i++) {
            fputc('f', out);
            for (int j = 0; j < 3; j++) {
                uint32_t at = first + (mesh->triangles8 != NULL ? mesh->triangles8[i][j]
                                                                : mesh->triangles[i][j]);
                fprintf(out, " %" PRIu32, at);
                if (uvs) {
                    fprintf(out, "/%" PRIu32, at);
                }
                if (normals) {
                    fprintf(out, "%s%" PRIu32, uvs ? "/" : "//", at);
                }
            }
            fputc('\n', out);
        }
        first += mesh->vertex_count;
    }
}
