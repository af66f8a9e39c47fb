/*
 * Wireframes of meshes.
 *
 * Two triangles share most edges. Where a line drawn again has no effect, see qtri_line_is_final,
 * the second one need not draw it. Vertices note the edges that leave them, in the word that has
 * 1/w for solid triangles: from vertex i to vertex j it is (j - i) modulo 2^16, in either half, the
 * newest in the lower one. Indices are below 2^16, so no other j gives the same; 0 is no edge, or
 * one from a vertex to itself, which has no pixel. A neighbour that faces the same way has the edge
 * from j to i. What is not noted is drawn again: there is room for two edges only, and a mesh may
 * have faces that disagree on what is front.
 *
 * A mesh drawn whole notes an edge when it draws it, in place of the oldest: all notes are of edges
 * drawn before. Bands draw a prepared mesh without writing to it: there notes are made beforehand,
 * for good, of edges that no earlier triangle has. Every triangle with an edge is drawn in every
 * band that the edge touches, in the order of the mesh.
 */
#include <string.h>

#include "mesh_job.h"

static inline uint32_t edge_between(uint32_t from, uint32_t to)
{
    return (to - from) & 0xFFFFu;
}

static inline bool is_noted(const qtri_vertex *vertex, uint32_t edge)
{
    return (vertex->inv_w & 0xFFFFu) == edge || vertex->inv_w >> 16 == edge;
}

static inline void note(qtri_vertex *vertex, uint32_t edge)
{
    vertex->inv_w = vertex->inv_w << 16 | edge;
}

static inline bool is_full(const qtri_vertex *vertex)
{
    return vertex->inv_w >> 16 != 0;
}

/* Whether a triangle has to draw its edge from a to b, which is noted then if edges are. */
static inline bool takes_edge(qtri_mesh_edges edges, qtri_vertex *a, const qtri_vertex *b,
                              uint32_t from, uint32_t to)
{
    if (edges == QTRI_EDGES_ALL) {
        return true;
    }
    if (is_noted(b, edge_between(to, from))) {
        return false;
    }
    if (edges == QTRI_EDGES_DRAWN) {
        note(a, edge_between(from, to));
    }
    return true;
}

/* Notes the edge from a to b, unless an earlier triangle has it from b to a, or may: b is full. */
static void note_first(qtri_vertex *a, const qtri_vertex *b, uint32_t from, uint32_t to)
{
    if (!is_full(a) && !is_full(b) && !is_noted(b, edge_between(to, from))) {
        note(a, edge_between(from, to));
    }
}

void qtri_mesh_clear_edges(const qtri_mesh_job *draw)
{
    for (uint32_t i = 0; i < draw->mesh->vertex_count; i++) {
        draw->vertices[i].inv_w = 0;
    }
}

void qtri_mesh_note_edges(const qtri_mesh_job *draw, const void *triangle,
                          qtri_vertex *const vertex[3])
{
    uint32_t index[3];
    qtri_mesh_indices(index, triangle, qtri_mesh_has_bytes(draw->mesh));
    note_first(vertex[0], vertex[1], index[0], index[1]);
    note_first(vertex[1], vertex[2], index[1], index[2]);
    note_first(vertex[2], vertex[0], index[2], index[0]);
}

/* One colour, by light per vertex or as it is. */
static inline bool is_tinted(const qtri_mesh_job *draw)
{
    return draw->mesh->colors == NULL && !draw->lit_per_face;
}

/* The corners' colours, and the first once more: those of an edge are next to each other. */
static void set_colors(const qtri_mesh_job *draw, const void *triangle,
                       qtri_vertex *const vertex[3], qtri_line_color color[4])
{
    const qtri_shading shading = draw->material.shading;
    qtri_mesh_set_colors(draw, triangle, vertex, color);
    if (shading != QTRI_SMOOTH) {
        const int32_t *from = color[shading == QTRI_FLAT_FIRST ? 0 : 2];
        for (int i = 0; i < 3; i++) {
            memmove(color[i], from, sizeof color[i]);
        }
    }
    memcpy(color[3], color[0], sizeof color[3]);
}

QTRI_NOINLINE void qtri_mesh_draw_lines(const qtri_mesh_job *draw, const void *triangle,
                                        qtri_vertex *const vertex[3])
{
    const qtri_line_job *line = &draw->primitive.to.line;
    qtri_vertex *a = vertex[0];
    qtri_vertex *b = vertex[1];
    qtri_vertex *c = vertex[2];
    if (qtri_line_misses(line, a->at.y_24p8, b->at.y_24p8, c->at.y_24p8)) {
        return;
    }
    qtri_line_color own[4];
    const qtri_line_color *color[3] = {NULL, NULL, NULL};
    if (!is_tinted(draw)) {
        set_colors(draw, triangle, vertex, own);
        for (int i = 0; i < 3; i++) {
            color[i] = (const qtri_line_color *)&own[i];
        }
    } else if (!qtri_vertices_are_lit(a, b, c)) {
        qtri_mesh_light_corners(draw, triangle, a, b, c);
    }
    uint32_t index[3];
    qtri_mesh_indices(index, triangle, qtri_mesh_has_bytes(draw->mesh));
    if (takes_edge(draw->edges, a, b, index[0], index[1])) {
        qtri_line_draw(line, a, b, color[0]);
    }
    if (takes_edge(draw->edges, b, c, index[1], index[2])) {
        qtri_line_draw(line, b, c, color[1]);
    }
    if (takes_edge(draw->edges, c, a, index[2], index[0])) {
        qtri_line_draw(line, c, a, color[2]);
    }
}

bool qtri_mesh_draw_front_lines(const qtri_mesh_job *draw)
{
    const uint32_t count = draw->mesh->vertex_count;
    const uint16_t(*triangle)[3] = draw->mesh->triangles;
    const uint16_t(*end)[3] = triangle + draw->mesh->triangle_count;
    const qtri_line_job *line = &draw->primitive.to.line;
    const uint32_t vertex_size = qtri_vertex_size();
    qtri_vertex *vertices = draw->vertices;
    if (QTRI_SHARE || qtri_mesh_has_bytes(draw->mesh) || draw->edges != QTRI_EDGES_DRAWN ||
        !is_tinted(draw)) {
        return false;
    }
    for (; triangle != end; triangle++) {
        uint32_t index[3];
        qtri_mesh_indices(index, triangle, false);
        qtri_vertex *vertex[3];
        if (!qtri_mesh_find(vertex, vertices, count, index, vertex_size)) {
            continue;
        }
        qtri_vertex *a = vertex[0];
        qtri_vertex *b = vertex[1];
        qtri_vertex *c = vertex[2];
        if (qtri_triangle_is_back(&a->at, &b->at, &c->at) ||
            qtri_line_misses(line, a->at.y_24p8, b->at.y_24p8, c->at.y_24p8)) {
            continue;
        }
        if (!qtri_vertices_are_lit(a, b, c)) {
            qtri_mesh_light_corners(draw, triangle, a, b, c);
        }
        if (takes_edge(QTRI_EDGES_DRAWN, a, b, index[0], index[1])) {
            qtri_line_draw(line, a, b, NULL);
        }
        if (takes_edge(QTRI_EDGES_DRAWN, b, c, index[1], index[2])) {
            qtri_line_draw(line, b, c, NULL);
        }
        if (takes_edge(QTRI_EDGES_DRAWN, c, a, index[2], index[0])) {
            qtri_line_draw(line, c, a, NULL);
        }
    }
    return true;
}
