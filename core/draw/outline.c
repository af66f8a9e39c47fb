/* SPDX-License-Identifier: MIT */
/*
 * Outlines of meshes: their memory, lists of their edges for bands, and edges noted on the pixels
 * that they pass through.
 *
 * Lists: a word a band, the first entry's number in its high half and the last one's in its low
 * half, from 1 on; then the entries. An entry is next << 19 | weak << 18 | corner << 16 | triangle.
 */
#include "outline_find.h"

#include "qtri/halo.h"

#include "checked.h"

enum { NEXT_SHIFT = 19, WEAK_SHIFT = 18, CORNER_SHIFT = 16, ENTRIES_MAX = (1 << 13) - 1 };

/* ---- Lists ---- */

/* floor(row / rows), as in prepared.c: exact for rows below 2^13. */
static uint32_t band_of(const qtri_edge_finder *f, int32_t row)
{
    return ((uint32_t)row * f->inverse) >> f->shift;
}

/*
 * The bands that walk along the edge between two vertices: those that have a row which it passes
 * through. (Where the walk's rounding takes it into the next row, its share is that of a neighbour
 * in the row that it left, so a band without that row has no note of it.) False: none.
 */
static inline bool bands_of(const qtri_edge_finder *f, const qtri_vertex *a, const qtri_vertex *b,
                            uint32_t *band, uint32_t *last)
{
    const int32_t y = a->at.y_24p8;
    const int32_t other = b->at.y_24p8;
    int32_t top = (y < other ? y : other) >> 8;
    int32_t bottom = (y < other ? other : y) >> 8;
    if (bottom < 0 || top >= f->height) {
        return false;
    }
    top -= f->below;
    bottom += f->above;
    *band = top < 0 ? 0 : band_of(f, top);
    *last = bottom >= f->height ? f->bands - 1 : band_of(f, bottom);
    return true;
}

/* The entries that these edges take. */
QTRI_NOINLINE static uint32_t count_entries(const qtri_edge_finder *f, qtri_vertex *const vertex[3],
                                            uint32_t edges)
{
    uint32_t count = 0;
    uint32_t band;
    uint32_t last;
    for (uint32_t i = 0; i < 3; i++) {
        if ((edges >> i & 1) != 0 &&
            bands_of(f, vertex[i], vertex[i == 2 ? 0 : i + 1], &band, &last)) {
            count += last - band + 1;
        }
    }
    return count;
}

/* Appends an entry to the lists of the bands of an edge. */
QTRI_NOINLINE static void list_edge(qtri_edge_finder *f, const qtri_vertex *a, const qtri_vertex *b,
                                    uint32_t entry)
{
    uint32_t band;
    uint32_t last;
    if (!bands_of(f, a, b, &band, &last)) {
        return;
    }
    uint32_t number = f->next;
    uint32_t *head = f->outline->list + band;
    uint32_t *before = f->outline->list + f->bands - 1; /* of the first entry, which is 1 */
    f->next = number + (last - band + 1);
    for (; band <= last; band++) {
        const uint32_t ends = *head;
        number++;
        before[number] = entry;
        if (ends == 0) {
            *head++ = number << 16 | number;
        } else {
            before[ends & 0xFFFF] |= number << NEXT_SHIFT;
            *head++ = (ends & 0xFFFF0000u) | number;
        }
    }
}

static bool take_for_lists(qtri_edge_finder *f, uint32_t triangle, uint32_t edges, bool weak)
{
    qtri_vertex *vertex[3];
    if (!qtri_outline_vertices(f->outline, triangle, vertex)) {
        return true;
    }
    const uint32_t room = f->end - f->next;
    if (room < 3 * f->bands && count_entries(f, vertex, edges) > room) {
        return false; /* all of a triangle's edges are listed, or none */
    }
    const uint32_t entry = (uint32_t)weak << WEAK_SHIFT | triangle;
    if ((edges & 1) != 0) {
        list_edge(f, vertex[0], vertex[1], entry);
    }
    if ((edges & 2) != 0) {
        list_edge(f, vertex[1], vertex[2], entry | (uint32_t)1 << CORNER_SHIFT);
    }
    if ((edges & 4) != 0) {
        list_edge(f, vertex[2], vertex[0], entry | (uint32_t)2 << CORNER_SHIFT);
    }
    return true;
}

/* Lists for bands of so many rows, if there is room for them. */
static void make_lists(qtri_outline *outline, int32_t rows, int32_t above, int32_t below)
{
    const uint32_t bands = ((uint32_t)outline->height + (uint32_t)rows - 1) / (uint32_t)rows;
    outline->rows = 0;
    outline->left_pass = 0;
    outline->left_from = 0;
    if (outline->list_words <= bands) {
        return;
    }
    qtri_edge_finder f = {.outline = outline,
                          .take = take_for_lists,
                          .bands = bands,
                          .shift = 13,
                          .height = outline->height,
                          .above = above,
                          .below = below};
    const uint32_t room = outline->list_words - bands;
    f.end = room < ENTRIES_MAX ? room : ENTRIES_MAX;
    while ((int32_t)1 << (f.shift - 13) < rows) {
        f.shift++;
    }
    f.inverse = (((uint32_t)1 << f.shift) + (uint32_t)rows - 1) / (uint32_t)rows;
    for (uint32_t i = 0; i < bands; i++) {
        outline->list[i] = 0;
    }
    outline->rows = rows;
    outline->above = above;
    outline->below = below;
    outline->left_pass = qtri_outline_find(&f, 0, 0);
    outline->left_from = f.from;
}

/* ---- Outlines ---- */

void qtri_outline_clear(qtri_outline *outline)
{
    outline->vertices = NULL;
    outline->rows = 0;
    outline->left_pass = 0;
    outline->left_from = 0;
}

void qtri_outline_set(qtri_outline *outline, qtri_vertex *vertices, const qtri_view *view,
                      const qtri_transform *pose, const qtri_material *material, int32_t width,
                      int32_t height)
{
    qtri_outline_clear(outline);
    if (material->fill != NULL || material->depth_compare == QTRI_NEVER) {
        return;
    }
    outline->vertices = vertices;
    outline->view = view;
    outline->pose = pose;
    outline->material = material;
    outline->width = width;
    outline->height = height;
    if (outline->sums != NULL) {
        qtri_outline_add_sums(outline);
    }
}

static bool are_neighbours(const qtri_mesh *mesh)
{
    for (uint32_t i = 0; mesh->neighbours != NULL && i < mesh->triangle_count; i++) {
        const uint16_t *n = mesh->neighbours[i];
        if (n[0] > mesh->triangle_count || n[1] > mesh->triangle_count ||
            n[2] > mesh->triangle_count) {
            return false;
        }
    }
    return true;
}

enum qtri_error qtri_outline_init(qtri_outline *outline, const qtri_mesh *mesh, uint32_t *memory,
                                  uint32_t words)
{
    QTRI_ASSERT(outline != NULL);
    QTRI_CHECK(qtri_check_mesh(mesh));
    const qtri_outline none = {0};
    const uint32_t front = QTRI_OUTLINE_WORDS(mesh->triangle_count);
    const uint32_t sums = mesh->neighbours == NULL ? QTRI_OUTLINE_SUMS(mesh->vertex_count) : 0;
    *outline = none;
    if (mesh->triangle_count > UINT16_MAX || !are_neighbours(mesh)) {
        return QTRI_ERROR_SIZE;
    }
    if (memory == NULL || words < front || words - front < sums) {
        return QTRI_ERROR_MEMORY;
    }
    outline->mesh = mesh;
    outline->front = memory;
    outline->sums = mesh->neighbours == NULL ? memory + front : NULL;
    outline->list = memory + front + sums;
    outline->list_words = words - front - sums;
    qtri_front_clear(outline->front, mesh->triangle_count);
    return QTRI_OK;
}

enum qtri_error qtri_prepared_find_edges(const qtri_prepared *prepared, qtri_outline *outline)
{
    QTRI_CHECK(qtri_check_prepared(prepared));
    QTRI_ASSERT(outline != NULL);
    qtri_outline_clear(outline);
    if (outline->mesh == NULL || prepared->mesh != outline->mesh ||
        prepared->front != outline->front ||
        prepared->vertex_count < prepared->mesh->vertex_count) {
        return QTRI_ERROR_MEMORY;
    }
    if (!prepared->is_seen) {
        return QTRI_OK;
    }
    qtri_outline_set(outline, prepared->vertices, prepared->view, prepared->pose,
                     prepared->material, prepared->width, prepared->height);
    if (outline->vertices != NULL) {
        make_lists(outline, prepared->rows, prepared->edges_above, prepared->edges_below);
    }
    return QTRI_OK;
}

void qtri_prepared_set_outline(qtri_prepared *prepared, const qtri_outline *outline, int32_t halo)
{
    QTRI_CHECK(qtri_check_prepared(prepared));
    prepared->front = NULL;
    prepared->front_of = NULL;
    prepared->halo = qtri_hold32(halo, 0, QTRI_HALO_MAX);
    prepared->edges_above = prepared->halo;
    prepared->edges_below = prepared->halo;
    if (outline != NULL) {
        prepared->front = outline->front;
        prepared->front_of = outline->mesh;
    }
}

void qtri_prepared_set_rolling_outline(qtri_prepared *prepared, const qtri_outline *outline,
                                       int32_t halo)
{
    qtri_prepared_set_outline(prepared, outline, halo);
    prepared->edges_above = 2 * prepared->halo; /* rows that were kept; nothing is drawn there */
    prepared->edges_below = 0;
    prepared->halo = 0;
}

/* ---- Noting ---- */

static void note_edge(const qtri_edge_finder *f, qtri_vertex *const vertex[3], uint32_t corner)
{
    const uint32_t next = corner == 2 ? 0 : corner + 1;
    const uint32_t last = corner == 0 ? 2 : corner - 1;
    qtri_edge_note(&f->walker, vertex[corner], vertex[next], vertex[last]);
}

static bool take_for_walks(qtri_edge_finder *f, uint32_t triangle, uint32_t edges, bool weak)
{
    qtri_vertex *vertex[3];
    f->walker.weak = weak ? UINT32_MAX : 0;
    if (qtri_outline_vertices(f->outline, triangle, vertex)) {
        if ((edges & 1) != 0) {
            qtri_edge_note(&f->walker, vertex[0], vertex[1], vertex[2]);
        }
        if ((edges & 2) != 0) {
            qtri_edge_note(&f->walker, vertex[1], vertex[2], vertex[0]);
        }
        if ((edges & 4) != 0) {
            qtri_edge_note(&f->walker, vertex[2], vertex[0], vertex[1]);
        }
    }
    return true;
}

static void note_list(qtri_edge_finder *f, uint32_t band)
{
    const uint32_t *list = f->outline->list;
    const uint32_t *entries = list + f->bands;
    for (uint32_t number = list[band] >> 16; number != 0;) {
        const uint32_t entry = entries[number - 1];
        qtri_vertex *vertex[3];
        (void)qtri_outline_vertices(f->outline, entry & 0xFFFF,
                                    vertex); /* all inside, or not listed */
        f->walker.weak = (entry >> WEAK_SHIFT & 1) != 0 ? UINT32_MAX : 0;
        note_edge(f, vertex, entry >> CORNER_SHIFT & 3);
        number = entry >> NEXT_SHIFT;
    }
}

static qtri_edge_test test_of(const qtri_edges *edges, const qtri_material *material)
{
    const qtri_compare compare = qtri_compare_of(material);
    if (edges->surface.depth == NULL || compare == QTRI_DEPTH_OFF || compare == QTRI_ALWAYS) {
        return QTRI_EDGE_ALWAYS;
    }
    return compare == QTRI_GREATER || compare == QTRI_GREATER_EQUAL ? QTRI_EDGE_FARTHER
                                                                    : QTRI_EDGE_NEARER;
}

/* The list that has all edges of these rows; false: there is none. */
static bool find_list(const qtri_outline *outline, const qtri_rect *bounds, uint32_t *band)
{
    if (outline->rows == 0) {
        return false;
    }
    const int32_t number = (bounds->y0 + outline->above) / outline->rows;
    *band = (uint32_t)number;
    return number * outline->rows < outline->height &&
           bounds->y1 <= (number + 1) * outline->rows + outline->below;
}

void qtri_edges_note(qtri_edges *edges, const qtri_outline *outline)
{
    QTRI_ASSERT(edges != NULL);
    QTRI_ASSERT(outline != NULL);
    const qtri_rect *bounds = &edges->bounds;
    if (outline->vertices == NULL || bounds->x0 >= bounds->x1 ||
        edges->surface.width != outline->width || edges->surface.height != outline->height) {
        return;
    }
    qtri_edge_finder f = {.outline = outline, .take = take_for_walks};
    uint32_t band;
    qtri_edge_walker_init(&f.walker, edges, test_of(edges, outline->material));
    if (!find_list(outline, bounds, &band)) {
        (void)qtri_outline_find(&f, 0, 0);
        return;
    }
    f.bands = ((uint32_t)outline->height + (uint32_t)outline->rows - 1) / (uint32_t)outline->rows;
    note_list(&f, band);
    (void)qtri_outline_find(&f, outline->left_pass, outline->left_from);
}
