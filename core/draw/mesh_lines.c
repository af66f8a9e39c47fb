/* SPDX-License-Identifier: MIT */
/*
 * Wireframes, &qtri_wireframe: edges as lines, and which of two triangles draws a shared edge.
 *
 * Two triangles share most edges. One of them owns the edge: it draws it for both, whatever colours
 * the other has there and whatever is drawn in between. The depth test decides which:
 *
 * - "Less" or "greater", written: the first triangle. Stored depths only get nearer (or farther)
 *   and equal ones fail, so later lines fail where the first one was drawn.
 * - "Less or equal" or "greater or equal", written: the last triangle. Where the last line fails,
 *   something nearer was drawn since the first, and hides that too; elsewhere it covers the first.
 * - No depth, read only, "equal" or "always": the last triangle. Depths stay as they are or do not
 *   count, so the last line passes wherever the first did.
 * - "Not equal", written: every triangle. The second line fails where nothing was drawn in between,
 *   and covers what was. With a blend, too, so that a picture does not depend on notes.
 *
 * A vertex notes the edges that leave it in inv_w, which holds 1/w for solid triangles: the edge
 * from vertex i to j as (j - i) modulo 2^16, in either half, the newest in the lower one. Indices
 * are below 2^16, so no other j gives the same; 0 is no edge, or one from a vertex to itself, which
 * has no pixel. A neighbour that faces the same way has the edge from j to i. Triangles are visited
 * from the first on, or from the last one back; one that finds its edge noted leaves it to the
 * owner and removes the note. A vertex has room for two notes, and faces of a mesh may disagree on
 * what is front: edges whose note is missing are drawn twice, of spot's one in a thousand.
 *
 * For last triangles and for bands, owners are found before anything is drawn: each vertex keeps
 * the edges of four triangles in `index`, which tells elsewhere whose vertex is in a slot. In a
 * mesh of more than four triangles a vertex, the last ones draw all their edges. Bands draw a
 * prepared mesh without writing to it, and each edge in every band that it touches.
 */
#include "lights.h"
#include "mesh_faces.h"

/*
 * Notes of triangles: the edges that one draws, and whether it is visible. Where every vertex has a
 * slot, each holds the notes of NOTES triangles, in place of its index.
 */
enum {
    EDGE_AB = 1,
    EDGE_BC = 2,
    EDGE_CA = 4,
    EDGES_VISIBLE = 8,
    EDGES_ALL = 15,
    NOTE_BITS = 4,
    NOTES = 16 / NOTE_BITS
};

/* How many triangles have notes: all but in a mesh with few vertices. */
static uint32_t noted_count(const qtri_mesh *mesh)
{
    return mesh->triangle_count / NOTES < mesh->vertex_count ? mesh->triangle_count
                                                             : mesh->vertex_count * NOTES;
}

/* Which of the triangles that share an edge draws it. */
typedef enum edge_owner { EVERY, FIRST, LAST } edge_owner;

static edge_owner edge_owner_of(const qtri_mesh_job *draw, bool has_depth)
{
    const qtri_material *material = draw->primitive.material;
    const qtri_compare compare = material->depth_compare;
    if (material->blend != NULL) {
        return EVERY;
    }
    if (!has_depth || compare == QTRI_DEPTH_OFF || material->depth_read_only) {
        return LAST;
    }
    if (compare == QTRI_LESS || compare == QTRI_GREATER) {
        return FIRST;
    }
    return compare == QTRI_NOT_EQUAL ? EVERY : LAST;
}

/* Whether the triangle draws its edge a b: it does, and notes it, unless a neighbour noted b a,
   whose note it removes. */
QTRI_INLINE bool claim_edge(qtri_vertex *a, qtri_vertex *b, uint32_t from, uint32_t to)
{
    const uint32_t notes = b->inv_w;
    const uint32_t edge = (from - to) & 0xFFFFu;
    if ((notes & 0xFFFFu) == edge) {
        b->inv_w = notes >> 16;
        return false;
    }
    if (notes >> 16 == edge) {
        b->inv_w = notes & 0xFFFFu;
        return false;
    }
    a->inv_w = a->inv_w << 16 | ((to - from) & 0xFFFFu);
    return true;
}

/* The edges, as bits, that a triangle draws. */
QTRI_INLINE uint32_t claim_edges(qtri_vertex *a, qtri_vertex *b, qtri_vertex *c,
                                 const uint32_t index[3])
{
    uint32_t edges = claim_edge(a, b, index[0], index[1]) ? EDGE_AB : 0;
    edges |= claim_edge(b, c, index[1], index[2]) ? EDGE_BC : 0;
    return edges | (claim_edge(c, a, index[2], index[0]) ? EDGE_CA : 0);
}

static void clear_notes(const qtri_mesh_job *draw)
{
    const qtri_vertex *end = draw->vertices + draw->mesh->vertex_count;
    for (qtri_vertex *vertex = draw->vertices; vertex != end; vertex++) {
        vertex->inv_w = 0;
        vertex->index = 0;
    }
}

/* Whether lines have the material's colour times the intensities of vertices. */
static inline bool is_tinted(const qtri_mesh_job *draw)
{
    return draw->mesh->colors == NULL && !draw->lit_per_face && draw->lights == NULL;
}

/* Some edges of a triangle inside all planes, in other colours: of a view's lights, or of the
   vertices or the material in the light of the face or of the vertices. */
QTRI_NOINLINE static void draw_colored(const qtri_mesh_job *draw, const void *triangle,
                                       qtri_vertex *const vertex[3], uint32_t edges)
{
    const qtri_line_job *line = &draw->primitive.to.lines.job;
    const qtri_rgb *colors = draw->mesh->colors;
    qtri_rgb shaded[3];
    uint32_t index[3];
    uint32_t light_q15[3] = {QTRI_INTENSITY_ONE, QTRI_INTENSITY_ONE, QTRI_INTENSITY_ONE};
    qtri_mesh_indices(index, triangle, qtri_mesh_has_bytes(draw->mesh));
    if (draw->lights != NULL) {
        uint32_t lit[3];
        draw->lights->model->shade(draw, index, vertex[0], vertex[1], vertex[2], lit);
        colors = shaded;
        for (uint32_t i = 0; i < 3; i++) {
            shaded[i] = qtri_lit_rgb(lit[i]);
            index[i] = i;
        }
    } else if (draw->lit_per_face) {
        light_q15[0] = light_q15[1] = light_q15[2] = qtri_mesh_light_face(draw, triangle);
    } else {
        if (!qtri_vertices_are_lit(vertex[0], vertex[1], vertex[2])) {
            qtri_mesh_light_vertices(draw, triangle, vertex[0], vertex[1], vertex[2]);
        }
        for (int i = 0; i < 3; i++) {
            light_q15[i] = vertex[i]->intensity_q15;
        }
    }
    if (!qtri_is_smooth(draw->primitive.material)) {
        /* All have one light: it is by vertex for smooth shading alone. */
        index[0] = index[1] = index[2] = index[qtri_provoking_of(draw->primitive.material)];
    }
    qtri_vertex corner[4]; /* the first again behind the third */
    qtri_line_color color[4];
    for (int i = 0; i < 4; i++) {
        const int from = i < 3 ? i : 0;
        corner[i] = *vertex[from];
        corner[i].intensity_q15 = (uint16_t)light_q15[from];
        if (colors != NULL) {
            qtri_line_color_set(color[i], &colors[index[from]], light_q15[from]);
        }
    }
    for (int i = 0; i < 3; i++) {
        if ((edges >> i & 1) != 0) {
            line->draw(line, &corner[i], &corner[i + 1],
                       colors != NULL ? (const qtri_line_color *)&color[i] : NULL);
        }
    }
}

/* Some edges of a triangle inside all planes. */
QTRI_INLINE void draw_edges(const qtri_mesh_job *draw, const void *triangle,
                            qtri_vertex *const vertex[3], uint32_t edges, bool tinted)
{
    const qtri_line_job *line = &draw->primitive.to.lines.job;
    qtri_vertex *a = vertex[0], *b = vertex[1], *c = vertex[2];
    if (qtri_line_misses(line, a->at.y_24p8, b->at.y_24p8, c->at.y_24p8)) {
        return;
    }
    if (!tinted) {
        qtri_vertex *const corner[3] = {a, b, c};
        draw_colored(draw, triangle, corner, edges);
        return;
    }
    if (!qtri_vertices_are_lit(a, b, c)) {
        qtri_mesh_light_vertices(draw, triangle, a, b, c);
    }
    if ((edges & EDGE_AB) != 0) {
        line->draw(line, a, b, NULL);
    }
    if ((edges & EDGE_BC) != 0) {
        line->draw(line, b, c, NULL);
    }
    if ((edges & EDGE_CA) != 0) {
        line->draw(line, c, a, NULL);
    }
}

/* draw_edges() in any colours, out of line. */
QTRI_NOINLINE static void draw_inside(const qtri_mesh_job *draw, const void *triangle,
                                      qtri_vertex *const vertex[3], uint32_t edges)
{
    draw_edges(draw, triangle, vertex, edges, is_tinted(draw));
}

/*
 * Draws edges of a triangle; where it crosses a plane, all that clipping leaves of them. `simple`,
 * here and below: back faces are culled, and no vertex is outside.
 */
QTRI_INLINE void draw_visible(const qtri_mesh_job *draw, const void *triangle,
                              qtri_vertex *const vertex[3], uint32_t edges, bool tinted,
                              bool simple)
{
    if (simple) {
        draw_edges(draw, triangle, vertex, edges, tinted);
    } else if (qtri_mesh_is_inside(vertex[0], vertex[1], vertex[2])) {
        draw_inside(draw, triangle, vertex, edges);
    } else {
        qtri_mesh_draw_visible(draw, triangle, vertex);
    }
}

/* The edges that a triangle owns, or all where it crosses a plane; 0: it is culled. */
QTRI_INLINE uint32_t edges_of(const qtri_mesh_job *draw, const uint32_t index[3],
                              qtri_vertex *const vertex[3], edge_owner who, bool simple)
{
    qtri_vertex *a = vertex[0], *b = vertex[1], *c = vertex[2];
    if (simple ? qtri_triangle_is_back(&a->at, &b->at, &c->at)
               : qtri_mesh_is_culled(draw, a, b, c)) {
        return 0;
    }
    if (who == EVERY || !(simple || qtri_mesh_is_inside(a, b, c))) {
        return EDGES_ALL;
    }
    return EDGES_VISIBLE | claim_edges(a, b, c, index);
}

/*
 * Visits triangles, from `number` on or, for LAST, from the last one back to the first, and draws
 * them or, without `draws`, notes their edges. `complete`: no vertex was left out.
 */
QTRI_INLINE void visit_triangles(const qtri_mesh_job *draw, uint32_t number, edge_owner who,
                                 bool narrow, bool simple, bool draws, bool complete)
{
    const qtri_mesh *mesh = draw->mesh;
    const bool tinted = is_tinted(draw);
    const uint32_t count = mesh->vertex_count;
    const int step = (who == LAST ? -1 : 1) * (narrow ? 3 : 6);
    qtri_vertex *vertices = draw->vertices;
    uint32_t rest = (draws ? mesh->triangle_count : noted_count(mesh)) - number;
    if (rest == 0) {
        return;
    }
    number = who == LAST ? rest - 1 : number;
    const uint8_t *triangle = qtri_mesh_triangle(mesh, number, narrow);
    for (; rest > 0; rest--, triangle += step, number += who == LAST ? UINT32_MAX : 1) {
        uint32_t index[3];
        qtri_vertex *vertex[3];
        if (!qtri_mesh_find(index, vertex, vertices, count, triangle, narrow) ||
            (!draws && !complete && !qtri_mesh_are_transformed(vertex))) {
            continue;
        }
        const uint32_t edges = edges_of(draw, index, vertex, who, simple);
        if (edges == 0) {
            continue;
        }
        if (draws) {
            draw_visible(draw, triangle, vertex, edges, tinted, simple && complete);
        } else {
            uint16_t *notes = &vertices[number / NOTES].index;
            *notes = (uint16_t)(*notes | edges << number % NOTES * NOTE_BITS);
        }
    }
}

/* visit_triangles() out of line. */
QTRI_NOINLINE static void visit_any(const qtri_mesh_job *draw, uint32_t number, edge_owner who,
                                    bool simple, bool draws)
{
    visit_triangles(draw, number, who, qtri_mesh_has_bytes(draw->mesh), simple, draws, false);
}

/* Draws the triangles of a list, edges by FIRST. */
QTRI_INLINE void draw_list(const qtri_mesh_job *draw, const qtri_mesh_faces *faces, bool narrow,
                           bool simple)
{
    const bool tinted = is_tinted(draw);
    const uint8_t *triangles = faces->triangles;
    const uint16_t *end = faces->end;
    qtri_vertex *vertices = draw->vertices;
    for (const uint16_t *at = faces->list; at != end; at++) {
        const uint8_t *triangle = qtri_mesh_faces_triangle(triangles, *at, narrow);
        uint32_t index[3];
        qtri_vertex *vertex[3];
        qtri_mesh_get(index, vertex, vertices, triangle, narrow);
        const uint32_t edges = edges_of(draw, index, vertex, FIRST, simple);
        if (edges != 0) {
            draw_visible(draw, triangle, vertex, edges, tinted, simple);
        }
    }
}

QTRI_INLINE void draw_noted(const qtri_mesh_job *draw, bool narrow, bool simple)
{
    const bool tinted = is_tinted(draw);
    const int size = narrow ? 3 : 6;
    qtri_vertex *vertices = draw->vertices;
    const qtri_vertex *end = vertices + (noted_count(draw->mesh) + NOTES - 1) / NOTES;
    const uint8_t *first = qtri_mesh_triangle(draw->mesh, 0, narrow);
    for (const qtri_vertex *at = vertices; at != end; at++, first += NOTES * size) {
        const uint8_t *triangle = first;
        for (uint32_t notes = at->index; notes != 0; notes >>= NOTE_BITS, triangle += size) {
            uint32_t index[3];
            qtri_vertex *vertex[3];
            if ((notes & EDGES_ALL) != 0) {
                qtri_mesh_get(index, vertex, vertices, triangle, narrow);
                draw_visible(draw, triangle, vertex, notes & EDGES_ALL, tinted, simple);
            }
        }
    }
}

/*
 * Draws a mesh whose faces have planes, edges by FIRST. False, and nothing is drawn: it has none,
 * or they tell nothing.
 */
QTRI_NOINLINE static bool draw_faces(qtri_mesh_job *draw)
{
    const qtri_face_culling *culling = draw->mesh->faces.culling;
    const bool narrow = qtri_mesh_has_bytes(draw->mesh);
    const bool back = draw->primitive.material->cull == QTRI_CULL_BACK;
    qtri_mesh_faces faces;
    if (culling == NULL || !culling->begin(&faces, draw)) {
        return false;
    }
    while (culling->next(&faces, draw)) {
        const bool simple = back && faces.inside;
        if (!QTRI_SHARE && simple && !narrow) {
            draw_list(draw, &faces, false, true);
        } else {
            draw_list(draw, &faces, narrow, simple);
        }
    }
    return true;
}

void qtri_wireframe_mesh(qtri_mesh_job *draw)
{
    const qtri_mesh *mesh = draw->mesh;
    const bool narrow = qtri_mesh_has_bytes(mesh);
    edge_owner who = edge_owner_of(draw, draw->primitive.surface->depth != NULL);
    uint32_t number = 0;
    if (who == FIRST && draw_faces(draw)) {
        return;
    }
    const bool simple = qtri_mesh_transform(draw, 0, mesh->vertex_count, draw->vertices) &&
                        draw->primitive.material->cull == QTRI_CULL_BACK;
    const bool quick = !QTRI_SHARE && simple && !narrow;
    clear_notes(draw);
    if (quick && who == FIRST) {
        visit_triangles(draw, 0, FIRST, false, true, true, true);
        return;
    }
    if (who == LAST) {
        if (quick) {
            visit_triangles(draw, 0, LAST, false, true, false, true);
            draw_noted(draw, false, true);
        } else {
            visit_any(draw, 0, LAST, simple, false);
            draw_noted(draw, narrow, simple);
        }
        number = noted_count(mesh); /* and those that have no notes */
        who = EVERY;
    }
    visit_any(draw, number, who, simple, true);
}

void qtri_wireframe_triangle(const qtri_mesh_job *draw, const void *triangle,
                             qtri_vertex *const vertex[3])
{
    uint32_t edges = EDGES_ALL;
    if (draw->noted) {
        const bool narrow = qtri_mesh_has_bytes(draw->mesh);
        const uint8_t *first = qtri_mesh_triangle(draw->mesh, 0, narrow);
        const uint32_t number = (uint32_t)((const uint8_t *)triangle - first) / (narrow ? 3 : 6);
        if (number < noted_count(draw->mesh)) {
            edges = draw->vertices[number / NOTES].index >> number % NOTES * NOTE_BITS & EDGES_ALL;
        }
    }
    draw_inside(draw, triangle, vertex, edges); /* as qtri_fill promises: nothing calls itself */
}

void qtri_wireframe_prepare(const qtri_mesh_job *draw, bool back_only)
{
    clear_notes(draw);
    visit_any(draw, 0, edge_owner_of(draw, true), back_only, false); /* bands mostly have depth */
}

void qtri_wireframe_band(qtri_mesh_job *draw)
{
    draw->noted =
        draw->slot_count >= draw->mesh->vertex_count &&
        edge_owner_of(draw, draw->primitive.surface->depth != NULL) == edge_owner_of(draw, true);
}

const qtri_fill qtri_wireframe = QTRI_WIREFRAME_FILL(qtri_primitive_begin_lines);
