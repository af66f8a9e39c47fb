/* SPDX-License-Identifier: MIT */
/*
 * Outlines of meshes: which triangles face the eye, the edges between those that do and those that
 * do not, lists of these edges for bands, and their notes for the edge pass.
 *
 * After a drawing the mesh's vertices are on the screen, and each triangle gets a bit: it is front
 * or not. Its edges are in the outline where a neighbour is not front. Without neighbours a vertex
 * has two sums, modulo 2^16: each front face's edge a b adds (b, b b) at a and takes (a, a a) from
 * b. Where all edges but one to n and one from p have their counterpart, n - p and n n - p p are
 * left. So a b is alone iff S2 = S1 (2 b - S1) at a and S2 = S1 (2 a + S1) at b. A vertex where
 * several outlines meet has sums that tell nothing.
 *
 * Lists for bands: a word a band, the first entry's number in its high half and the last one's in
 * its low half, from 1 on; then the entries. An entry is
 * next << 19 | weak << 18 | corner << 16 | triangle.
 */
#include "qtri/antialias.h"

#include "checked.h"
#include "edge_pass.h"
#include "mesh_faces.h"

enum {
    NEXT_SHIFT = 19,
    WEAK_SHIFT = 18,
    CORNER_SHIFT = 16,
    ENTRIES_MAX = (1 << 13) - 1,
    ALL_EDGES = 7,
    CREASE_Q15 = 1 << 11
};

static void clear_outline(qtri_outline *outline)
{
    outline->vertices = NULL;
    outline->rows = 0;
}

static bool has_valid_neighbours(const qtri_mesh *mesh)
{
    const uint16_t *n = mesh->neighbours != NULL ? mesh->neighbours[0] : NULL;
    for (uint32_t i = 0; n != NULL && i < 3 * mesh->triangle_count; i++) {
        if (n[i] > mesh->triangle_count) {
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
    if (mesh->triangle_count > UINT16_MAX || !has_valid_neighbours(mesh)) {
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
    return QTRI_OK;
}

/* ---- Which triangles are front ---- */

/* Bit 0 tells whether this triangle is front; the other bits are those of other triangles. */
static inline uint32_t front_bits_at(const uint32_t *front, uint32_t triangle)
{
    return qtri_rotated(front[triangle / 32], triangle);
}

/* The indices and vertices of a triangle; false: an index is past the mesh's last vertex. */
QTRI_INLINE bool find_vertices(const qtri_outline *outline, uint32_t triangle, uint32_t index[3],
                               qtri_vertex *vertex[3])
{
    const qtri_mesh *mesh = outline->mesh;
    const bool narrow = qtri_mesh_has_bytes(mesh);
    return qtri_mesh_find(index, vertex, outline->vertices, mesh->vertex_count,
                          qtri_mesh_triangle(mesh, triangle, narrow), narrow);
}

/*
 * Clears the bits of triangles that are not front; planes of faces have done so where any is 0. A
 * triangle that crosses a plane of the frustum counts as front, as its edges are not known to be
 * the outline's; one beyond a plane does not.
 */
static void find_front(const qtri_outline *outline)
{
    const uint32_t count = outline->mesh->triangle_count;
    const bool mirrored = outline->material->cull == QTRI_CULL_FRONT;
    uint32_t *front = outline->front;
    for (uint32_t i = 0; i < count / 32; i++) {
        if (front[i] != UINT32_MAX) {
            return;
        }
    }
    for (uint32_t i = 0; i < count; i++) {
        uint32_t index[3];
        qtri_vertex *v[3];
        if ((front_bits_at(front, i) & 1) == 0) {
            continue;
        }
        if (!find_vertices(outline, i, index, v) ||
            (qtri_mesh_is_inside(v[0], v[1], v[2])
                 ? qtri_triangle_is_back(&v[0]->at, &v[mirrored ? 2 : 1]->at,
                                         &v[mirrored ? 1 : 2]->at)
                 : qtri_mesh_is_outside(v))) {
            front[i / 32] &= ~((uint32_t)1 << (i & 31));
        }
    }
}

/* Adds an edge of a front face to the sums, see above. */
static void add_edge(uint32_t *sums, uint32_t a, uint32_t b)
{
    sums[a] += b + (b * b << 16); /* fits() undoes carries from the low half */
    sums[b] -= a + (a * a << 16);
}

/* The sums of a mesh without neighbours. */
static void add_sums(const qtri_outline *outline)
{
    const qtri_mesh *mesh = outline->mesh;
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        outline->sums[i] = 0;
    }
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        uint32_t index[3];
        qtri_vertex *vertex[3];
        if ((front_bits_at(outline->front, i) & 1) != 0 &&
            find_vertices(outline, i, index, vertex)) {
            add_edge(outline->sums, index[0], index[1]);
            add_edge(outline->sums, index[1], index[2]);
            add_edge(outline->sums, index[2], index[0]);
        }
    }
}

/* Sets what finding edges needs, once `vertices` holds the mesh's transformed vertices. */
static void set_outline(qtri_outline *outline, qtri_vertex *vertices, const qtri_view *view,
                        const qtri_transform *pose, const qtri_material *material, int32_t width,
                        int32_t height)
{
    if (material->fill != NULL || material->depth_compare == QTRI_NEVER) {
        return;
    }
    outline->vertices = vertices;
    outline->view = view;
    outline->pose = pose;
    outline->material = material;
    outline->width = width;
    outline->height = height;
    find_front(outline);
    if (outline->sums != NULL) {
        add_sums(outline);
    }
}

/* ---- Drawing ---- */

/* Sets the bits of all triangles; the one behind them, of "no neighbour", is 0. */
static enum qtri_error begin_outline(qtri_outline *outline, const qtri_view *view)
{
    QTRI_ASSERT(outline != NULL);
    clear_outline(outline);
    if (outline->mesh == NULL || view->vertex_count < outline->mesh->vertex_count) {
        return QTRI_ERROR_MEMORY;
    }
    qtri_front_set_all(outline->front, outline->mesh->triangle_count);
    return QTRI_OK;
}

enum qtri_error qtri_draw_mesh_outlined(const qtri_surface *surface, const qtri_view *view,
                                        const qtri_transform *pose, const qtri_material *material,
                                        qtri_outline *outline)
{
    const enum qtri_error error = begin_outline(outline, view);
    if (error == QTRI_OK && qtri_mesh_draw(&qtri_vertex_stage_any, surface, view, pose,
                                           outline->mesh, material, outline->front)) {
        set_outline(outline, view->vertices, view, pose, material, surface->width, surface->height);
    } else if (error != QTRI_OK && outline->mesh != NULL) {
        qtri_draw_mesh(surface, view, pose, outline->mesh, material);
    }
    return error;
}

/* Transforms the vertices that drawing would. A function of its own: a job takes much stack. */
QTRI_NOINLINE static bool transform(const qtri_surface *surface, const qtri_view *view,
                                    const qtri_transform *pose, const qtri_material *material,
                                    const qtri_outline *outline)
{
    const qtri_mesh *mesh = outline->mesh;
    const qtri_face_culling *culling = mesh->faces.culling;
    qtri_mesh_faces faces;
    qtri_mesh_job job;
    if (!qtri_mesh_job_init(&job, &qtri_vertex_stage_any, surface, view, pose, mesh, material,
                            view->vertices, view->vertex_count)) {
        return false;
    }
    job.front = outline->front;
    if (culling == NULL || !culling->begin(&faces, &job)) {
        (void)qtri_mesh_transform(&job, 0, mesh->vertex_count, view->vertices);
        return true;
    }
    while (culling->next(&faces, &job)) {
    }
    return true;
}

enum qtri_error qtri_find_outline(const qtri_surface *surface, const qtri_view *view,
                                  const qtri_transform *pose, const qtri_material *material,
                                  qtri_outline *outline)
{
    const enum qtri_error error = begin_outline(outline, view);
    if (error == QTRI_OK && transform(surface, view, pose, material, outline)) {
        set_outline(outline, view->vertices, view, pose, material, surface->width, surface->height);
    }
    return error;
}

/* ---- Edges: listed by band, or noted ---- */

/* A triangle's vertices, the first two again behind the third. False: one is outside a plane. */
QTRI_INLINE bool find_corners(const qtri_outline *outline, uint32_t triangle, qtri_vertex *v[5])
{
    uint32_t index[3];
    if (!find_vertices(outline, triangle, index, v)) {
        return false;
    }
    v[3] = v[0];
    v[4] = v[1];
    return qtri_mesh_is_inside(v[0], v[1], v[2]);
}

typedef struct finder {
    const qtri_outline *outline;
    const qtri_mesh_job *job; /* for light; NULL: creases are not asked for */
    qtri_edge_axis axis[2];   /* where edges are noted */
    uint32_t bands;           /* that have lists; 0: edges are noted */
    uint32_t next, end;       /* entries that are taken, and that there is room for */
    qtri_band_divider divider;
} finder;

/*
 * Appends an entry to the lists of the bands that have a row which the edge passes through. (Where
 * the walk's rounding takes it into the next row, its weight is that of a neighbour in the row that
 * it left, so a band without that row has no note of it.) False: there is no room.
 */
static bool list_edge(finder *f, const qtri_vertex *a, const qtri_vertex *b, uint32_t entry)
{
    const qtri_outline *outline = f->outline;
    uint32_t *before = outline->list + f->bands - 1; /* of the first entry, which is 1 */
    int32_t top = qtri_least32(a->at.y_24p8, b->at.y_24p8) >> 8;
    int32_t bottom = qtri_greatest32(a->at.y_24p8, b->at.y_24p8) >> 8;
    if (bottom < 0 || top >= outline->height) {
        return true;
    }
    top = qtri_greatest32(top - outline->below, 0);
    bottom = qtri_least32(bottom + outline->above, outline->height - 1);
    const uint32_t last = qtri_band_of(&f->divider, (uint32_t)bottom);
    for (uint32_t band = qtri_band_of(&f->divider, (uint32_t)top); band <= last; band++) {
        uint32_t *head = &outline->list[band];
        if (f->next == f->end) {
            return false;
        }
        const uint32_t number = ++f->next;
        before[number] = entry;
        if (*head == 0) {
            *head = number << 16;
        } else {
            before[*head & 0xFFFF] |= number << NEXT_SHIFT;
        }
        *head = (*head & 0xFFFF0000u) | number;
    }
    return true;
}

/* Notes or lists the edges of a triangle that have a bit. False, here and below: lists are full. */
static bool record_edges(finder *f, uint32_t triangle, uint32_t edges, bool weak)
{
    const uint32_t entry = (uint32_t)weak << WEAK_SHIFT | triangle;
    qtri_vertex *v[5];
    if (!find_corners(f->outline, triangle, v)) {
        return true;
    }
    for (uint32_t k = 0; k < 3; k++) {
        if ((edges >> k & 1) == 0) {
            continue;
        }
        if (f->bands == 0) {
            qtri_edge_note(f->axis, v[k], v[k + 1], v[k + 2]);
        } else if (!list_edge(f, v[k], v[k + 1], entry | k << CORNER_SHIFT)) {
            return false;
        }
    }
    return true;
}

/* ---- Finding edges ---- */

/* Whether the sum at one end of an edge is what the edge alone leaves. `twice`: 2 times the index
   of the other end; `leaves`: this end is a. */
static bool fits(uint32_t sum, uint32_t twice, bool leaves)
{
    const uint32_t s1 = (uint32_t)(int32_t)(int16_t)(sum & 0xFFFF);
    const uint32_t s2 = (sum - s1) >> 16;
    const uint32_t product = s1 * (leaves ? twice - s1 : twice + s1);
    return ((product - s2) & 0xFFFF) == 0;
}

/* 1 or 0: whether edge a b of a front face has no front neighbour, by the sums. */
static uint32_t is_alone(const uint32_t *sums, uint32_t a, uint32_t b)
{
    return sums[a] != 0 && sums[b] != 0 && fits(sums[a], 2 * b, true) &&
           fits(sums[b], 2 * a, false);
}

/* The edges of a front triangle, as bits, whose neighbours are not front. */
static uint32_t silhouettes_of(const qtri_outline *outline, uint32_t triangle)
{
    const uint32_t *front = outline->front;
    if (outline->sums == NULL) {
        const uint16_t *n = outline->mesh->neighbours[triangle];
        // NOLINTNEXTLINE(clang-analyzer-core.NullDereference): without sums a mesh has neighbours
        const uint32_t a = front_bits_at(front, n[0]);
        const uint32_t b = front_bits_at(front, n[1]);
        const uint32_t c = front_bits_at(front, n[2]);
        return (a & b & c & 1) != 0 ? 0 : ((a & 1) | (b & 1) << 1 | (c & 1) << 2) ^ ALL_EDGES;
    }
    const bool narrow = qtri_mesh_has_bytes(outline->mesh);
    uint32_t i[3];
    qtri_mesh_indices(i, qtri_mesh_triangle(outline->mesh, triangle, narrow), narrow);
    return is_alone(outline->sums, i[0], i[1]) | is_alone(outline->sums, i[1], i[2]) << 1 |
           is_alone(outline->sums, i[2], i[0]) << 2;
}

/* The edges, as bits, to front faces of other light; of two faces the first one has them. */
static uint32_t creases_of(const finder *f, uint32_t triangle)
{
    const qtri_mesh *mesh = f->outline->mesh;
    const bool narrow = qtri_mesh_has_bytes(mesh);
    const uint16_t *n = mesh->neighbours[triangle];
    const uint32_t light = qtri_mesh_light_face(f->job, qtri_mesh_triangle(mesh, triangle, narrow));
    uint32_t edges = 0;
    for (int i = 0; i < 3; i++) {
        if (n[i] > triangle && (front_bits_at(f->outline->front, n[i]) & 1) != 0) {
            const uint32_t other =
                qtri_mesh_light_face(f->job, qtri_mesh_triangle(mesh, n[i], narrow));
            const uint32_t difference = light > other ? light - other : other - light;
            edges |= (uint32_t)(difference > CREASE_Q15) << i;
        }
    }
    return edges;
}

/* Records the silhouettes of front triangles, or their creases, which are weak. */
static bool find_front_edges(finder *f, bool creases)
{
    const qtri_outline *outline = f->outline;
    const uint32_t *front = outline->front;
    const uint32_t count = outline->mesh->triangle_count;
    for (uint32_t i = 0; i < count; i++) {
        if ((front_bits_at(front, i) & 1) != 0) {
            const uint32_t edges = creases ? creases_of(f, i) : silhouettes_of(outline, i);
            if (edges != 0 && !record_edges(f, i, edges, creases)) {
                return false;
            }
        }
    }
    return true;
}

/* Records edges of back faces that have no neighbour, where back faces are not culled. */
static bool find_borders(finder *f)
{
    const qtri_mesh *mesh = f->outline->mesh;
    const uint32_t none = mesh->triangle_count;
    if (qtri_culls(f->outline->material->cull) || mesh->neighbours == NULL) {
        return true;
    }
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        const uint16_t *n = mesh->neighbours[i];
        const uint32_t edges = (uint32_t)(n[0] == none) | (uint32_t)(n[1] == none) << 1 |
                               (uint32_t)(n[2] == none) << 2;
        if (edges != 0 && (front_bits_at(f->outline->front, i) & 1) == 0 &&
            !record_edges(f, i, edges, false)) {
            return false;
        }
    }
    return true;
}

/* A function of its own: light takes a job's stack. */
QTRI_NOINLINE static bool find_creases(finder *f)
{
    const qtri_outline *outline = f->outline;
    const qtri_rect frame = {0, 0, outline->width, outline->height};
    const qtri_surface whole = {.width = outline->width,
                                .height = outline->height,
                                .rows = outline->height,
                                .scissor = frame};
    qtri_mesh_job job;
    const bool is_seen = qtri_mesh_job_init(&job, &qtri_vertex_stage_any, &whole, outline->view,
                                            outline->pose, outline->mesh, outline->material,
                                            outline->view->vertices, outline->view->vertex_count);
    f->job = &job;
    f->axis[0].weak = UINT32_MAX;
    f->axis[1].weak = UINT32_MAX;
    // NOLINTNEXTLINE(clang-analyzer-core.*): what reads the job has returned by then
    return !is_seen || !job.lit_per_face || find_front_edges(f, true);
}

static bool find_edges(finder *f)
{
    const qtri_outline *outline = f->outline;
    const bool has_creases =
        outline->creases && outline->view->light != NULL && outline->mesh->neighbours != NULL;
    return find_front_edges(f, false) && find_borders(f) && (!has_creases || find_creases(f));
}

/* ---- Bands ---- */

void qtri_prepared_set_outline(qtri_prepared *prepared, const qtri_outline *outline)
{
    QTRI_CHECK(qtri_check_prepared(prepared));
    prepared->front = outline != NULL ? outline->front : NULL;
    prepared->front_of = outline != NULL ? outline->mesh : NULL;
}

/* Lists for bands of so many rows, if there is room for them. */
static void make_lists(qtri_outline *outline, const qtri_prepared *prepared)
{
    const uint32_t rows = (uint32_t)prepared->rows;
    const uint32_t bands = ((uint32_t)outline->height + rows - 1) / rows;
    if (outline->list_words <= bands) {
        return;
    }
    const uint32_t room = outline->list_words - bands;
    finder f = {.outline = outline, .bands = bands};
    f.end = room < ENTRIES_MAX ? room : ENTRIES_MAX;
    qtri_band_divider_init(&f.divider, rows);
    for (uint32_t i = 0; i < bands; i++) {
        outline->list[i] = 0;
    }
    outline->above = prepared->edges_above;
    outline->below = prepared->edges_below;
    outline->rows = find_edges(&f) ? prepared->rows : 0;
}

enum qtri_error qtri_prepared_find_edges(const qtri_prepared *prepared, qtri_outline *outline)
{
    QTRI_CHECK(qtri_check_prepared(prepared));
    QTRI_ASSERT(outline != NULL);
    clear_outline(outline);
    if (outline->mesh == NULL || prepared->mesh != outline->mesh ||
        prepared->front != outline->front ||
        prepared->vertex_count < prepared->mesh->vertex_count) {
        return QTRI_ERROR_MEMORY;
    }
    if (prepared->is_seen) {
        set_outline(outline, prepared->vertices, prepared->view, prepared->pose, prepared->material,
                    prepared->width, prepared->height);
    }
    if (outline->vertices != NULL) {
        make_lists(outline, prepared);
    }
    return QTRI_OK;
}

/* ---- Noting ---- */

static void note_list(finder *f, uint32_t band)
{
    const qtri_outline *outline = f->outline;
    const uint32_t rows = (uint32_t)outline->rows;
    const uint32_t *entries = outline->list + ((uint32_t)outline->height + rows - 1) / rows;
    for (uint32_t number = outline->list[band] >> 16; number != 0;) {
        const uint32_t entry = entries[number - 1];
        qtri_vertex *v[5];
        f->axis[0].weak = 0 - (entry >> WEAK_SHIFT & 1);
        f->axis[1].weak = f->axis[0].weak;
        if (find_corners(outline, entry & 0xFFFF, v)) {
            qtri_vertex *const *from = &v[entry >> CORNER_SHIFT & 3];
            qtri_edge_note(f->axis, from[0], from[1], from[2]);
        }
        number = entry >> NEXT_SHIFT;
    }
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
    finder f = {.outline = outline};
    qtri_edge_axes_init(f.axis, edges, qtri_compare_of(outline->material));
    if (outline->rows != 0) { /* is there a list that has all edges of these rows? */
        const int32_t band = (bounds->y0 + outline->above) / outline->rows;
        if (band * outline->rows < outline->height &&
            bounds->y1 <= (band + 1) * outline->rows + outline->below) {
            note_list(&f, (uint32_t)band);
            return;
        }
    }
    (void)find_edges(&f);
}
