/* SPDX-License-Identifier: MIT */
/*
 * Edges of outlines: passes over the triangles that face the eye.
 *
 *   0  silhouettes: edges of a face that is front whose neighbour is not
 *   1  of a mesh that is not culled, edges of back faces without a neighbour
 *   2  creases, weaker than what the others noted
 *
 * Without neighbours a vertex has two sums, modulo 2^16: each front face's edge a b adds (b, b b)
 * at a and takes (a, a a) from b. Where all edges but one to n and one from p have their
 * counterpart, n - p and n n - p p are left. So a b is alone iff S2 = S1 (2 b - S1) at a and
 * S2 = S1 (2 a + S1) at b. A vertex where several outlines meet has sums that tell nothing.
 */
#include "outline.h"

#include "qtri/halo.h"

#include "mesh_faces.h"

enum { PASSES = 3, ALL_EDGES = 7, CREASE_Q15 = 1 << 11 };

/*
 * Lists: a word a band, the first entry's number in its high half and the last one's in its low
 * half, from 1 on; then the entries. An entry is next << 19 | weak << 18 | corner << 16 | triangle.
 */
enum { NEXT_SHIFT = 19, WEAK_SHIFT = 18, CORNER_SHIFT = 16, ENTRIES_MAX = (1 << 13) - 1 };

/* ---- Finding ---- */

typedef struct finder finder;
struct finder {
    const qtri_outline *outline;
    const qtri_mesh_job *job; /* for light: NULL where no creases are asked for */
    /* Takes those of a triangle's edges that have a bit; false: it has no room for all of them. */
    bool (*take)(finder *f, uint32_t triangle, uint32_t edges, bool weak);
    uint32_t from;           /* the first triangle that was not looked at or not taken */
    qtri_edge_walker walker; /* for walks */
    uint32_t bands, next, end, inverse, shift; /* for lists: entries, and 1 / rows */
    int32_t height;                            /* rows of the frame */
    int32_t above, below;                      /* rows that bands reach beyond their own */
};

static const void *triangle_at(const qtri_mesh *mesh, uint32_t number)
{
    return qtri_mesh_triangle(mesh, number, qtri_mesh_has_bytes(mesh));
}

/* Of the triangle whose neighbours these are. */
static inline uint32_t number_of(const uint16_t *neighbours, const uint16_t *n)
{
    return (uint32_t)(n - neighbours) * qtri_mesh_faces_third();
}

/* A function of its own: none of the other ways to find edges takes its registers. */
QTRI_NOINLINE static bool find_by_neighbours(finder *f)
{
    const uint16_t *neighbours = f->outline->mesh->neighbours[0];
    const uint32_t *front = f->outline->front;
    const uint32_t count = f->outline->mesh->triangle_count;
    uint32_t next = f->from;
    while (next < count) {
        uint32_t bits = front[next >> 5] >> (next & 31);
        const uint16_t *n = neighbours + (size_t)next * 3;
        next = (next | 31) + 1;
        while (bits != 0) {
            if ((int32_t)(bits << 31) >= 0) {
                QTRI_HOLD(bits); /* or eight bits are looked at before the one */
                if ((bits & 0xFF) == 0) {
                    n += 24;
                    bits >>= 8;
                    continue;
                }
                do {
                    n += 3;
                    bits >>= 1;
                } while ((int32_t)(bits << 31) >= 0);
            }
            uint32_t a = qtri_front_bit(front, n[0]);
            uint32_t b = qtri_front_bit(front, n[1]);
            uint32_t c = qtri_front_bit(front, n[2]);
            if ((int32_t)((a & b & c) << 31) >= 0) {
                QTRI_HOLD(a); /* GCC 12 would compute what follows for all faces */
                QTRI_HOLD(b);
                QTRI_HOLD(c);
                const uint32_t edges = ((a & 1) | (b & 1) << 1 | (c & 1) << 2) ^ ALL_EDGES;
                if (!f->take(f, number_of(neighbours, n), edges, false)) {
                    f->from = number_of(neighbours, n);
                    return false;
                }
            }
            n += 3;
            bits >>= 1;
        }
    }
    return true;
}

static void add_edge(uint32_t *sums, uint32_t a, uint32_t b)
{
    sums[a] += b + (b * b << 16); /* carries from the low half are undone in is_alone() */
    sums[b] -= a + (a * a << 16);
}

static void add_all(const qtri_outline *outline)
{
    const qtri_mesh *mesh = outline->mesh;
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        outline->sums[i] = 0;
    }
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        if ((qtri_front_bit(outline->front, i) & 1) != 0) {
            uint32_t index[3];
            qtri_mesh_indices(index, triangle_at(mesh, i), qtri_mesh_has_bytes(mesh));
            add_edge(outline->sums, index[0], index[1]);
            add_edge(outline->sums, index[1], index[2]);
            add_edge(outline->sums, index[2], index[0]);
        }
    }
}

/* Whether a sum at one end is what the edge alone leaves: `twice` the other end, with its sign. */
static bool fits(uint32_t sum, uint32_t twice, bool leaves)
{
    const uint32_t s1 = (uint32_t)(int32_t)(int16_t)(sum & 0xFFFF);
    const uint32_t s2 = (sum - s1) >> 16;
    const uint32_t product = s1 * (leaves ? twice - s1 : twice + s1);
    return ((product - s2) & 0xFFFF) == 0;
}

static uint32_t is_alone(const uint32_t *sums, uint32_t a, uint32_t b)
{
    return sums[a] != 0 && sums[b] != 0 && fits(sums[a], 2 * b, true) &&
           fits(sums[b], 2 * a, false);
}

static bool find_by_sums(finder *f)
{
    const qtri_mesh *mesh = f->outline->mesh;
    const uint32_t *sums = f->outline->sums;
    for (; f->from < mesh->triangle_count; f->from++) {
        if ((qtri_front_bit(f->outline->front, f->from) & 1) == 0) {
            continue;
        }
        uint32_t index[3];
        qtri_mesh_indices(index, triangle_at(mesh, f->from), qtri_mesh_has_bytes(mesh));
        const uint32_t edges = is_alone(sums, index[0], index[1]) |
                               is_alone(sums, index[1], index[2]) << 1 |
                               is_alone(sums, index[2], index[0]) << 2;
        if (edges != 0 && !f->take(f, f->from, edges, false)) {
            return false;
        }
    }
    return true;
}

/*
 * The vertices of a triangle, if all are inside. One that is front, or has an edge in a list, has
 * indices of vertices: whoever found that has looked at them.
 */
static inline bool get_vertices(const qtri_outline *outline, uint32_t number,
                                qtri_vertex *vertex[3])
{
    const qtri_mesh *mesh = outline->mesh;
    uint32_t index[3];
    qtri_mesh_indices(index, triangle_at(mesh, number), qtri_mesh_has_bytes(mesh));
    qtri_mesh_get(vertex, outline->vertices, index, qtri_vertex_size());
    return qtri_mesh_is_inside(vertex[0], vertex[1], vertex[2]);
}

static bool has_vertices(const qtri_mesh *mesh, uint32_t number)
{
    uint32_t index[3];
    qtri_mesh_indices(index, triangle_at(mesh, number), qtri_mesh_has_bytes(mesh));
    return index[0] < mesh->vertex_count && index[1] < mesh->vertex_count &&
           index[2] < mesh->vertex_count;
}

static bool find_borders(finder *f)
{
    const qtri_outline *outline = f->outline;
    const qtri_mesh *mesh = outline->mesh;
    if (outline->material->cull != QTRI_CULL_NONE || mesh->neighbours == NULL) {
        return true;
    }
    for (; f->from < mesh->triangle_count; f->from++) {
        const uint16_t *n = mesh->neighbours[f->from];
        const uint32_t none = mesh->triangle_count;
        const uint32_t edges = (uint32_t)(n[0] == none) | (uint32_t)(n[1] == none) << 1 |
                               (uint32_t)(n[2] == none) << 2;
        if (edges != 0 && (qtri_front_bit(outline->front, f->from) & 1) == 0 &&
            has_vertices(mesh, f->from) && !f->take(f, f->from, edges, false)) {
            return false;
        }
    }
    return true;
}

static uint32_t creases_of(const finder *f, uint32_t number)
{
    const qtri_mesh *mesh = f->outline->mesh;
    const uint16_t *neighbours = mesh->neighbours[number];
    const uint32_t own = qtri_mesh_light_face(f->job, triangle_at(mesh, number));
    uint32_t edges = 0;
    for (int i = 0; i < 3; i++) {
        const uint32_t n = neighbours[i];
        if (n > number && (qtri_front_bit(f->outline->front, n) & 1) != 0) {
            const uint32_t other = qtri_mesh_light_face(f->job, triangle_at(mesh, n));
            const uint32_t apart = own > other ? own - other : other - own;
            edges |= (uint32_t)(apart > CREASE_Q15) << i;
        }
    }
    return edges;
}

static bool find_creases(finder *f)
{
    const qtri_outline *outline = f->outline;
    if (f->job == NULL || !f->job->lit_per_face || outline->mesh->neighbours == NULL) {
        return true;
    }
    for (; f->from < outline->mesh->triangle_count; f->from++) {
        if ((qtri_front_bit(outline->front, f->from) & 1) == 0) {
            continue;
        }
        const uint32_t edges = creases_of(f, f->from);
        if (edges != 0 && !f->take(f, f->from, edges, true)) {
            return false;
        }
    }
    return true;
}

/* Passes from this one of the three on, the first from a triangle on; returns the one that was not
 * finished. */
static uint32_t find(finder *f, uint32_t pass, uint32_t from)
{
    f->from = from;
    if (pass == 0) {
        if (!(f->outline->sums != NULL ? find_by_sums(f) : find_by_neighbours(f))) {
            return 0;
        }
        pass = 1;
        f->from = 0;
    }
    if (pass == 1) {
        if (!find_borders(f)) {
            return 1;
        }
        f->from = 0;
    }
    return find_creases(f) ? PASSES : 2;
}

/* Light that creases are found by: the job of the drawing, once more. */
static const qtri_mesh_job *light_of(qtri_mesh_job *job, const qtri_outline *outline)
{
    if (outline->view->light == NULL) {
        return NULL;
    }
    const qtri_rect frame = {0, 0, outline->width, outline->height};
    const qtri_surface whole = {.width = outline->width,
                                .height = outline->height,
                                .rows = outline->height,
                                .scissor = frame};
    qtri_mesh_job_init(job, &whole, outline->view, outline->mesh, outline->material,
                       outline->view->vertices, outline->view->vertex_count);
    return qtri_mesh_job_place(job, outline->view, outline->pose) ? job : NULL;
}

/* A function of its own: light takes a job's stack. */
QTRI_NOINLINE static uint32_t find_in_light(finder *f, uint32_t pass, uint32_t from)
{
    qtri_mesh_job job;
    f->job = light_of(&job, f->outline);
    const uint32_t left = find(f, pass, from);
    f->job = NULL;
    return left;
}

static uint32_t find_from(finder *f, uint32_t pass, uint32_t from)
{
    if (pass >= PASSES) {
        return PASSES;
    }
    return f->outline->creases ? find_in_light(f, pass, from) : find(f, pass, from);
}

/* ---- Lists ---- */

/* floor(row / rows), as in prepared.c: exact for rows below 2^13. */
static uint32_t band_of(const finder *f, int32_t row)
{
    return ((uint32_t)row * f->inverse) >> f->shift;
}

/*
 * The bands that walk along the edge between two vertices: those that have a row which it passes
 * through. (Where the walk's rounding takes it into the next row, its share is that of a neighbour
 * in the row that it left, so a band without that row has no note of it.) False: none.
 */
static inline bool bands_of(const finder *f, const qtri_vertex *a, const qtri_vertex *b,
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
QTRI_NOINLINE static uint32_t count_entries(const finder *f, qtri_vertex *const vertex[3],
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
QTRI_NOINLINE static void list_edge(finder *f, const qtri_vertex *a, const qtri_vertex *b,
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

static bool take_for_lists(finder *f, uint32_t triangle, uint32_t edges, bool weak)
{
    qtri_vertex *vertex[3];
    if (!get_vertices(f->outline, triangle, vertex)) {
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
    finder f = {.outline = outline,
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
    outline->left_pass = find_from(&f, 0, 0);
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
        add_all(outline);
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
    const qtri_outline none = {0};
    const uint32_t front = QTRI_OUTLINE_WORDS(mesh->triangle_count);
    const uint32_t sums = mesh->neighbours == NULL ? QTRI_OUTLINE_SUMS(mesh->vertex_count) : 0;
    *outline = none;
    if (mesh->triangle_count > UINT16_MAX || !are_neighbours(mesh)) {
        return QTRI_ERROR_SIZE;
    }
    if (words < front || words - front < sums) {
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

static void note_edge(const finder *f, qtri_vertex *const vertex[3], uint32_t corner)
{
    const uint32_t next = corner == 2 ? 0 : corner + 1;
    const uint32_t last = corner == 0 ? 2 : corner - 1;
    qtri_edge_note(&f->walker, vertex[corner], vertex[next], vertex[last]);
}

static bool take_for_walks(finder *f, uint32_t triangle, uint32_t edges, bool weak)
{
    qtri_vertex *vertex[3];
    f->walker.weak = weak ? UINT32_MAX : 0;
    if (get_vertices(f->outline, triangle, vertex)) {
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

static void note_list(finder *f, uint32_t band)
{
    const uint32_t *list = f->outline->list;
    const uint32_t *entries = list + f->bands;
    for (uint32_t number = list[band] >> 16; number != 0;) {
        const uint32_t entry = entries[number - 1];
        qtri_vertex *vertex[3];
        (void)get_vertices(f->outline, entry & 0xFFFF, vertex); /* all inside, or not listed */
        f->walker.weak = (entry >> WEAK_SHIFT & 1) != 0 ? UINT32_MAX : 0;
        note_edge(f, vertex, entry >> CORNER_SHIFT & 3);
        number = entry >> NEXT_SHIFT;
    }
}

static qtri_edge_test test_of(const qtri_edges *edges, const qtri_material *material)
{
    const qtri_compare compare = material->depth_compare;
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
    const qtri_rect *bounds = &edges->bounds;
    if (outline->vertices == NULL || bounds->x0 >= bounds->x1 ||
        edges->surface.width != outline->width || edges->surface.height != outline->height) {
        return;
    }
    finder f = {.outline = outline, .take = take_for_walks};
    uint32_t band;
    qtri_edge_walker_init(&f.walker, edges, test_of(edges, outline->material));
    if (!find_list(outline, bounds, &band)) {
        (void)find_from(&f, 0, 0);
        return;
    }
    f.bands = ((uint32_t)outline->height + (uint32_t)outline->rows - 1) / (uint32_t)outline->rows;
    note_list(&f, band);
    (void)find_from(&f, outline->left_pass, outline->left_from);
}
