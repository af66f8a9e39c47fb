/* SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../assets/asset.h"
#include "../assets/mesh_arrays.h"
#include "../io/file.h"
#include "../io/obj.h"
#include "commands.h"
#include "mesh_neighbours.h"

static const char usage[] =
    "usage: qtri neighbours MESH.obj -o FILE [--name NAME]\n"
    "\n"
    "Writes qtri_mesh.neighbours of a mesh as C, for outlines (qtri/antialias.h): "
    "NAME_neighbours,\n"
    "MESH_neighbours without --name; - is standard input, -o - standard output. There are three\n"
    "numbers a triangle, in the order of the file's faces, polygons being fans. Triangles are\n"
    "neighbours across an edge of equal positions, whatever their normals and texture "
    "coordinates.\n";

struct options {
    const char *in, *out;
    char name[OPTION_NAME_SIZE];
};

/* Positions and triangles of the file, and neighbours; false where it has too many of either. */
static bool make(const struct obj_mesh *from, qtri_mesh *mesh)
{
    mesh->vertex_count = (uint32_t)from->vertex_count;
    mesh->triangle_count = (uint32_t)from->triangle_count;
    if (from->vertex_count > 65536 || from->triangle_count > UINT16_MAX) {
        return false;
    }
    mesh_array_fill(mesh, MESH_POSITIONS, from->positions[0]);
    mesh_array_fill(mesh, MESH_TRIANGLES, (const int32_t *)from->triangles[0]);
    return mesh_neighbours_add(mesh);
}

static bool write(const char *path, const char *name, const qtri_mesh *mesh,
                  struct text_error *error)
{
    const unsigned count = mesh->triangle_count;
    struct file_output output;
    if (!file_output_open(&output, path, error)) {
        return false;
    }
    fprintf(output.stream,
            "/* qtri_mesh.neighbours: the triangle across each edge, %u for none. */\n"
            "static const uint16_t %s_neighbours[%u][3] = {\n",
            count, name, count);
    for (unsigned i = 0; i < count; i++) {
        const uint16_t *n = mesh->neighbours[i];
        fprintf(output.stream, "    {%u, %u, %u},\n", n[0], n[1], n[2]);
    }
    fprintf(output.stream, "};\n");
    return file_output_commit(&output, error);
}

/* ---- The command ---- */

#define AT(member) offsetof(struct options, member)

static const struct option all[] = {{"-o", OPTION_TEXT, AT(out), {NULL}},
                                    {"--name", OPTION_NAME, AT(name), {NULL}}};
/* Neighbours are called as the mesh is, unless --name says otherwise. */
static bool check(const struct option_command *command, void *given)
{
    struct options *options = given;
    if (options->name[0] == '\0') {
        asset_identifier(strcmp(options->in, "-") == 0 ? "mesh" : options->in, options->name,
                         sizeof options->name);
    }
    return options->name[0] != '\0' || options_complain(command, "--name NAME is needed", "");
}

static bool run(void *given, struct text_error *error)
{
    const struct options *options = given;
    struct obj_mesh read;
    qtri_mesh mesh = {.positions = NULL};
    if (!obj_read(options->in, &read, error)) {
        return false;
    }
    const bool ok = make(&read, &mesh)
                        ? write(options->out, options->name, &mesh, error)
                        : text_error_set(error, options->in, 0, "more than a mesh holds");
    mesh_arrays_free(&mesh);
    obj_free(&read);
    return ok;
}

const struct option_command neighbours_command = {
    .name = "neighbours",
    .summary = "write a mesh's neighbours as C, for smooth outlines",
    .size = sizeof(struct options),
    .input = "mesh",
    .needs = "an OBJ file and -o FILE are needed",
    .input_at = AT(in),
    .output_at = AT(out),
    .options = all,
    .count = sizeof all / sizeof all[0],
    .usage = usage,
    .check = check,
    .run = run,
};
