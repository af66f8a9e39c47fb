/* SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../assets/asset.h"
#include "../io/file.h"
#include "../io/obj.h"
#include "commands.h"
#include "mesh_neighbours.h"
#include "options.h"

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

/* The neighbours of the mesh; NULL where it has too many vertices or triangles, or memory ends. */
static uint16_t (*make(const struct obj_mesh *mesh))[3]
{
    qtri_vec3 *positions = malloc((mesh->vertex_count + 1) * sizeof *positions);
    uint16_t(*triangles)[3] = malloc((mesh->triangle_count + 1) * sizeof *triangles);
    uint16_t(*neighbours)[3] = malloc((mesh->triangle_count + 1) * sizeof *neighbours);
    bool ok = positions != NULL && triangles != NULL && neighbours != NULL &&
              mesh->vertex_count <= 65536 && mesh->triangle_count <= UINT16_MAX;
    for (size_t i = 0; ok && i < mesh->vertex_count; i++) {
        const qtri_vec3 p = {mesh->positions[i][0], mesh->positions[i][1], mesh->positions[i][2]};
        positions[i] = p;
    }
    for (size_t i = 0; ok && i < mesh->triangle_count; i++) {
        for (int corner = 0; corner < 3; corner++) {
            triangles[i][corner] = (uint16_t)mesh->triangles[i][corner];
        }
    }
    if (ok) {
        qtri_mesh view = {.positions = positions,
                          .triangles = (const uint16_t(*)[3])triangles,
                          .vertex_count = (uint32_t)mesh->vertex_count,
                          .triangle_count = (uint32_t)mesh->triangle_count};
        ok = mesh_neighbours_make(&view, neighbours);
    }
    free(positions);
    free(triangles);
    if (!ok) {
        free(neighbours);
        return NULL;
    }
    return neighbours;
}

static bool write(const char *path, const char *name, uint16_t (*neighbours)[3], size_t count,
                  struct text_error *error)
{
    struct file_output output;
    if (!file_output_open(&output, path, error)) {
        return false;
    }
    fprintf(output.stream,
            "/* qtri_mesh.neighbours: the triangle across each edge, %zu for none. */\n"
            "static const uint16_t %s_neighbours[%zu][3] = {\n",
            count, name, count);
    for (size_t i = 0; i < count; i++) {
        fprintf(output.stream, "    {%u, %u, %u},\n", neighbours[i][0], neighbours[i][1],
                neighbours[i][2]);
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
    struct obj_mesh mesh;
    if (!obj_read(options->in, &mesh, error)) {
        return false;
    }
    uint16_t(*neighbours)[3] = make(&mesh);
    bool ok = neighbours != NULL;
    if (ok) {
        ok = write(options->out, options->name, neighbours, mesh.triangle_count, error);
    } else {
        text_error_set(error, options->in, 0, "more than a mesh holds, or out of memory");
    }
    free(neighbours);
    obj_free(&mesh);
    return ok;
}

static const struct option_command command = {
    .name = "neighbours",
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

int neighbours_main(int argc, char **argv)
{
    struct options options = {0};
    return options_run(&command, &options, argc, argv);
}
