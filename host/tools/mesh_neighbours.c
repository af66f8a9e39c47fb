/* SPDX-License-Identifier: MIT */
#include "mesh_neighbours.h"

#include <stdlib.h>

#include "../io/unique.h"
#include "../io/xalloc.h"

/* An edge from place to place: numbers of distinct positions. */
struct edge {
    uint32_t from, to;
    uint32_t triangle;
    int corner;
};

static int compare_numbers(int64_t a, int64_t b)
{
    return (a > b) - (a < b);
}

/* By the pair of places, whatever the direction, then in the order of the mesh. */
static int compare_edges(const void *left, const void *right)
{
    const struct edge *a = left;
    const struct edge *b = right;
    const uint32_t a_low = a->from < a->to ? a->from : a->to;
    const uint32_t b_low = b->from < b->to ? b->from : b->to;
    const uint32_t a_high = a->from ^ a->to ^ a_low;
    const uint32_t b_high = b->from ^ b->to ^ b_low;
    if (a_low != b_low) {
        return compare_numbers(a_low, b_low);
    }
    if (a_high != b_high) {
        return compare_numbers(a_high, b_high);
    }
    return compare_numbers((int64_t)a->triangle * 3 + a->corner,
                           (int64_t)b->triangle * 3 + b->corner);
}

static void number_places(const qtri_mesh *mesh, uint32_t *places)
{
    const bool is_wide = mesh->positions16 == NULL;
    const void *positions = is_wide ? (const void *)mesh->positions : mesh->positions16;
    const size_t size = is_wide ? sizeof *mesh->positions : sizeof *mesh->positions16;
    (void)unique_numbers(positions, mesh->vertex_count, size, size, places);
}

/* Edges of triangles whose indices exist; returns how many. */
static uint32_t find_edges(const qtri_mesh *mesh, const uint32_t *places, struct edge *edges)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        uint32_t index[3];
        bool exists = true;
        for (int corner = 0; corner < 3; corner++) {
            index[corner] =
                mesh->triangles8 != NULL ? mesh->triangles8[i][corner] : mesh->triangles[i][corner];
            exists = exists && index[corner] < mesh->vertex_count;
        }
        for (int corner = 0; corner < 3 && exists; corner++) {
            struct edge edge = {places[index[corner]], places[index[(corner + 1) % 3]], i, corner};
            if (edge.from != edge.to) {
                edges[count++] = edge;
            }
        }
    }
    return count;
}

/* Pairs those of one place, edges[0..count-1]: each with the next free one of the other way. */
static void pair(const struct edge *edges, uint32_t count, uint16_t (*neighbours)[3], uint16_t none)
{
    for (uint32_t i = 0; i < count; i++) {
        uint16_t *own = &neighbours[edges[i].triangle][edges[i].corner];
        for (uint32_t j = i + 1; j < count && *own == none; j++) {
            uint16_t *other = &neighbours[edges[j].triangle][edges[j].corner];
            if (*other == none && edges[j].from == edges[i].to &&
                edges[j].triangle != edges[i].triangle) {
                *own = (uint16_t)edges[j].triangle;
                *other = (uint16_t)edges[i].triangle;
            }
        }
    }
}

static bool is_same_place(const struct edge *a, const struct edge *b)
{
    return (a->from == b->from && a->to == b->to) || (a->from == b->to && a->to == b->from);
}

bool mesh_neighbours_make(qtri_mesh *mesh, uint16_t (*neighbours)[3])
{
    const uint32_t count = mesh->triangle_count;
    mesh->neighbours = NULL;
    if (count > UINT16_MAX) {
        return false;
    }
    uint32_t *places = xcalloc(mesh->vertex_count, sizeof *places);
    struct edge *edges = xcalloc(3 * (size_t)count, sizeof *edges);
    number_places(mesh, places);
    const uint32_t found = find_edges(mesh, places, edges);
    qsort(edges, found, sizeof *edges, compare_edges);
    for (uint32_t i = 0; i < count; i++) {
        for (int corner = 0; corner < 3; corner++) {
            neighbours[i][corner] = (uint16_t)count;
        }
    }
    for (uint32_t i = 0, end; i < found; i = end) {
        for (end = i + 1; end < found && is_same_place(&edges[i], &edges[end]); end++) {
        }
        pair(&edges[i], end - i, neighbours, (uint16_t)count);
    }
    mesh->neighbours = (const uint16_t(*)[3])neighbours;
    free(places);
    free(edges);
    return true;
}

bool mesh_neighbours_add(qtri_mesh *mesh)
{
    uint16_t(*neighbours)[3] = xcalloc(mesh->triangle_count, sizeof *neighbours);
    const bool ok = mesh_neighbours_make(mesh, neighbours);
    if (!ok) {
        free(neighbours);
    }
    return ok;
}
