/* SPDX-License-Identifier: MIT */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../io/obj.h"
#include "commands.h"
#include "mesh_neighbours.h"

static const char usage[] =
    "usage: qtri neighbours MESH.obj -o FILE\n"
    "\n"
    "Writes qtri_mesh.neighbours of a mesh as C, for outlines (qtri/edges.h): MESH_neighbours, "
    "three\n"
    "numbers a triangle, in the order of the file's faces, polygons being fans. Triangles are\n"
    "neighbours across an edge of equal positions, whatever their normals and texture "
    "coordinates.\n";

/* The file's name without folder and ending, as a name in C. */
static void name_of(const char *path, char *name, size_t size)
{
    const char *base = strrchr(path, '/');
    base = base != NULL ? base + 1 : path;
    size_t length = 0;
    for (; base[length] != '\0' && base[length] != '.' && length + 1 < size; length++) {
        name[length] = isalnum((unsigned char)base[length]) != 0 ? base[length] : '_';
    }
    name[length] = '\0';
}

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

static bool write(const char *path, const char *name, uint16_t (*neighbours)[3], size_t count)
{
    FILE *out = fopen(path, "w");
    if (out == NULL) {
        return false;
    }
    fprintf(out,
            "/* qtri_mesh.neighbours: the triangle across each edge, %zu for none. */\n"
            "static const uint16_t %s_neighbours[%zu][3] = {\n",
            count, name, count);
    for (size_t i = 0; i < count; i++) {
        fprintf(out, "    {%u, %u, %u},\n", neighbours[i][0], neighbours[i][1], neighbours[i][2]);
    }
    fprintf(out, "};\n");
    const bool ok = !ferror(out);
    return fclose(out) == 0 && ok;
}

int neighbours_main(int argc, char **argv)
{
    if (argc == 2 && (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0)) {
        fputs(usage, stdout);
        return 0;
    }
    if (argc != 4 || strcmp(argv[2], "-o") != 0) {
        fputs(usage, stderr);
        return 2;
    }
    struct obj_mesh mesh;
    struct text_error error;
    if (!obj_read(argv[1], &mesh, &error)) {
        fprintf(stderr, "qtri neighbours: %s\n", error.message);
        return 1;
    }
    char name[64];
    name_of(argv[1], name, sizeof name);
    uint16_t(*neighbours)[3] = make(&mesh);
    int status = 0;
    if (neighbours == NULL) {
        fprintf(stderr, "qtri neighbours: %s: more than a mesh holds, or out of memory\n", argv[1]);
        status = 1;
    } else if (!write(argv[3], name, neighbours, mesh.triangle_count)) {
        fprintf(stderr, "qtri neighbours: %s: cannot be written\n", argv[3]);
        remove(argv[3]);
        status = 1;
    }
    free(neighbours);
    obj_free(&mesh);
    return status;
}
