/* SPDX-License-Identifier: MIT */
/*
 * Meshes in bands (qtri/prepared.h): vertices are transformed and lit, and triangles sorted by
 * band; then each band draws its list.
 *
 * Lists of triangles by band. In the caller's memory, one after another:
 *
 *   for every band: the place of its first entry, 0 for none; the place after its last
 *   blocks of eight: seven entries and the place of the list's next block
 *
 * Places count elements from the start. An entry is the number of a group of 2^group_log2 triangles
 * that follow each other in the mesh; it is in the list of every band that one of them may touch.
 * Lists are in the order of the mesh, as drawing is: where depths are equal, it decides.
 */
#include "checked.h"
#include "lights.h"
#include "mesh_faces.h"
#include "../raster/samples.h"
#include "qtri/prepared.h"

enum { LIST_BLOCK = 8, LIST_FULL = LIST_BLOCK - 1 };

static const qtri_rect nowhere = {0, 0, 0, 0};

/* Whether there is a slot for every vertex of the mesh. */
static inline bool is_complete(const qtri_prepared *prepared)
{
    return prepared->vertex_count >= prepared->mesh->vertex_count;
}

/*
 * What is added to the least and the greatest coordinate before they are rounded down to the first
 * pixel and the one after the last: centres in between, or what a line may touch when it rounds.
 */
static inline int32_t before_24p8(bool is_solid)
{
    return is_solid ? 127 : -256;
}

static inline int32_t after_24p8(bool is_solid)
{
    return is_solid ? 127 : 512;
}

static inline void widen(qtri_rect *extent_24p8, const qtri_vertex *vertex)
{
    extent_24p8->x0 = qtri_least32(extent_24p8->x0, vertex->at.x_24p8);
    extent_24p8->y0 = qtri_least32(extent_24p8->y0, vertex->at.y_24p8);
    extent_24p8->x1 = qtri_greatest32(extent_24p8->x1, vertex->at.x_24p8);
    extent_24p8->y1 = qtri_greatest32(extent_24p8->y1, vertex->at.y_24p8);
}

/* The group at a place of a list; *place moves on to the next. */
static inline uint32_t next_group(const uint16_t *lists, uint32_t *place)
{
    if (*place % LIST_BLOCK == LIST_FULL) {
        *place = lists[*place];
    }
    return lists[(*place)++];
}

enum { PLACES = 65536, GROUP_LOG2_MAX = 16 };

void qtri_prepared_init(qtri_prepared *prepared, void *memory, size_t bytes)
{
    QTRI_ASSERT(prepared != NULL);
    QTRI_ASSERT(memory != NULL || bytes == 0);
    const qtri_prepared empty = {.memory = memory, .bytes = bytes};
    *prepared = empty;
}

/* Memory holds slots of vertices, colours lit by sources where there is room, then lists. */
static void divide_memory(qtri_prepared *prepared, bool in_lights)
{
    const size_t before = (0 - (uintptr_t)prepared->memory) % sizeof(uint32_t);
    if (prepared->memory == NULL || prepared->bytes < before) {
        return;
    }
    const size_t bytes = prepared->bytes - before;
    const size_t room = bytes / sizeof(qtri_vertex);
    const uint32_t count = prepared->mesh->vertex_count;
    size_t vertices = count;
    if (count > room) {
        vertices = room / 2;
    } else if (in_lights) {
        const size_t colors = ((size_t)count + 4) / 5; /* of QTRI_LIT_VERTICES */
        vertices += room - count < colors ? room - count : colors;
    }
    const size_t lists = (bytes - vertices * sizeof(qtri_vertex)) / sizeof(uint16_t);
    prepared->vertices = (qtri_vertex *)(void *)((uint8_t *)prepared->memory + before);
    prepared->vertex_count = (uint32_t)vertices;
    prepared->lists = (uint16_t *)(void *)(prepared->vertices + vertices);
    prepared->list_count = lists < PLACES ? (uint32_t)lists : PLACES;
}

typedef struct binner {
    const qtri_mesh_job *job;
    qtri_prepared *prepared;
    bool is_complete;
    int32_t before_24p8, after_24p8; /* see the functions */
    int32_t height, overlap;
    uint32_t rows; /* of a band */
    qtri_band_divider divider;
    uint32_t next, end; /* places: of the next block, of the end of the memory; 0: it is full */
    uint16_t *lists;
    uint32_t group_log2;
    uint32_t group;      /* one that is not listed yet; UINT32_MAX: none */
    int32_t top, bottom; /* its rows top..bottom - 1 */
    bool is_anywhere;    /* some triangle crosses a plane */
} binner;

/* Lights a visible triangle's vertices, which marks them as visited even without light. Vertices in
   slots are lit when they are drawn, and widen the extent now. */
static inline void visit_vertices(const binner *s, const void *triangle,
                                  qtri_vertex *const vertex[3])
{
    if (qtri_vertices_are_lit(vertex[0], vertex[1], vertex[2])) {
        return;
    }
    if (s->is_complete) {
        qtri_mesh_light_vertices(s->job, triangle, vertex[0], vertex[1], vertex[2]);
        return;
    }
    for (int i = 0; i < 3; i++) {
        widen(&s->prepared->extent_24p8, vertex[i]);
    }
}

/* Starts a block for the list of `band`, which goes on from `place`. */
QTRI_NOINLINE static uint32_t add_block(binner *s, uint32_t band, uint32_t place)
{
    uint32_t block = s->next;
    s->lists[s->lists[2 * band] == 0 ? 2 * band : place] = (uint16_t)block;
    s->next += LIST_BLOCK;
    return block;
}

/* Appends a group to a band's list; there is room for a new block. */
static inline void append(binner *s, uint32_t band, uint32_t group)
{
    uint16_t *list = &s->lists[2 * band];
    uint32_t place = list[1];
    if (place % LIST_BLOCK == LIST_FULL) {
        place = add_block(s, band, place);
    }
    s->lists[place] = (uint16_t)group;
    list[1] = (uint16_t)(place + 1);
}

/* Lists a group in the bands of rows top..bottom - 1 of the frame, at least one. Without room
   neither this group nor one that follows is in a list. */
static inline void list_group(binner *s, uint32_t group, int32_t top, int32_t bottom)
{
    uint32_t band = qtri_band_of(&s->divider, (uint32_t)top);
    const uint32_t last = qtri_band_of(&s->divider, (uint32_t)bottom - 1);
    if (s->next + (last - band + 1) * LIST_BLOCK > s->end) {
        if (s->end != 0) {
            s->end = 0;
            s->prepared->listed = group << s->group_log2;
        }
        return;
    }
    for (; band <= last; band++) {
        append(s, band, group);
    }
}

static void list_pending(binner *s)
{
    if (s->group != UINT32_MAX) {
        list_group(s, s->group, s->top, s->bottom);
    }
}

/* Adds a triangle to its group, which is listed when it is complete. */
QTRI_NOINLINE static void list_in_group(binner *s, uint32_t number, int32_t top, int32_t bottom)
{
    if (number >> s->group_log2 != s->group) {
        list_pending(s);
        s->group = number >> s->group_log2;
        s->top = top;
        s->bottom = bottom;
    }
    s->top = qtri_least32(s->top, top);
    s->bottom = qtri_greatest32(s->bottom, bottom);
}

/* Lists a triangle that may touch rows top..bottom - 1, if there are any. */
static inline void list_triangle(binner *s, uint32_t number, int32_t top, int32_t bottom)
{
    top = qtri_greatest32(top - s->overlap, 0);
    bottom = qtri_least32(bottom + s->overlap, s->height);
    if (top >= bottom) {
        return;
    }
    if (s->group_log2 == 0) {
        list_group(s, number, top, bottom);
    } else {
        list_in_group(s, number, top, bottom);
    }
}

/* Lists a triangle that is not culled, is inside all planes and has its vertices visited. */
static inline void list_inside(binner *s, uint32_t number, qtri_vertex *const vertex[3])
{
    const int32_t a = vertex[0]->at.y_24p8, b = vertex[1]->at.y_24p8, c = vertex[2]->at.y_24p8;
    list_triangle(s, number, (qtri_least32(a, qtri_least32(b, c)) + s->before_24p8) >> 8,
                  (qtri_greatest32(a, qtri_greatest32(b, c)) + s->after_24p8) >> 8);
}

/* Bins a triangle that is not culled and is inside all planes. */
QTRI_NOINLINE static void bin_inside(binner *s, uint32_t number, const void *triangle,
                                     qtri_vertex *const vertex[3])
{
    visit_vertices(s, triangle, vertex);
    list_inside(s, number, vertex);
}

/* Bins a triangle that is not culled, wherever it is. */
static void bin_visible(binner *s, uint32_t number, const void *triangle,
                        qtri_vertex *const vertex[3])
{
    if (qtri_mesh_is_inside(vertex[0], vertex[1], vertex[2])) {
        bin_inside(s, number, triangle, vertex);
    } else if (!qtri_mesh_is_outside(vertex)) {
        s->is_anywhere = true;
        visit_vertices(s, triangle, vertex);
        list_triangle(s, number, 0, s->height);
    }
}

/* Bins all triangles of a mesh whose vertices are transformed. */
QTRI_NOINLINE static void bin_all_triangles(binner *s)
{
    const qtri_mesh *mesh = s->job->mesh;
    qtri_vertex *vertices = s->job->vertices;
    const uint32_t count = mesh->vertex_count;
    const bool narrow = qtri_mesh_has_bytes(mesh);
    const bool back_only = s->prepared->back_only;
    const uint8_t *triangle = qtri_mesh_triangle(mesh, 0, narrow);
    for (uint32_t number = 0; number != mesh->triangle_count;
         number++, triangle += narrow ? 3 : 6) {
        uint32_t index[3];
        qtri_vertex *vertex[3];
        if (!qtri_mesh_find(index, vertex, vertices, count, triangle, narrow)) {
            continue;
        }
        if (!back_only) {
            if (!qtri_mesh_is_culled(s->job, vertex[0], vertex[1], vertex[2])) {
                bin_visible(s, number, triangle, vertex);
            }
        } else if (!qtri_triangle_is_back(&vertex[0]->at, &vertex[1]->at, &vertex[2]->at)) {
            bin_inside(s, number, triangle, vertex);
        }
    }
}

/* Bins a list of faces. `simple`: back faces culled, no vertex outside, indices of 16 bits. */
static inline void bin_face_list(binner *s, const qtri_mesh_faces *faces, uint32_t first,
                                 bool narrow, bool simple)
{
    qtri_vertex *vertices = s->job->vertices;
    for (const uint16_t *at = faces->list; at != faces->end; at++) {
        const uint8_t *triangle = qtri_mesh_faces_triangle(faces->triangles, *at, narrow);
        const uint32_t number = first + qtri_mesh_faces_number(*at);
        uint32_t index[3];
        qtri_vertex *vertex[3];
        qtri_mesh_get(index, vertex, vertices, triangle, narrow);
        if (simple ? qtri_triangle_is_back(&vertex[0]->at, &vertex[1]->at, &vertex[2]->at)
                   : qtri_mesh_is_culled(s->job, vertex[0], vertex[1], vertex[2])) {
            continue;
        }
        if (simple) {
            list_inside(s, number, vertex);
        } else {
            bin_visible(s, number, triangle, vertex);
        }
    }
}

/* Transforms and bins a mesh by its planes of faces; false: these tell nothing. */
QTRI_NOINLINE static bool bin_by_faces(binner *s)
{
    const qtri_face_culling *culling = s->job->mesh->faces.culling;
    const bool back = s->job->primitive.material->cull == QTRI_CULL_BACK;
    const bool narrow = qtri_mesh_has_bytes(s->job->mesh);
    qtri_mesh_faces faces;
    if (culling == NULL || !culling->begin(&faces, s->job)) {
        return false;
    }
    for (uint32_t first = 0; culling->next(&faces, s->job); first = faces.next) {
        if (back && faces.inside && !narrow) {
            bin_face_list(s, &faces, first, false, true);
        } else {
            bin_face_list(s, &faces, first, narrow, false);
        }
    }
    s->prepared->back_only = back && faces.inside;
    return true;
}

/* Transforms and bins a mesh whose vertices all have room. */
static void bin_mesh(binner *s)
{
    const qtri_mesh_job *job = s->job;
    if (!bin_by_faces(s)) {
        const bool inside = qtri_mesh_transform(job, 0, job->mesh->vertex_count, job->vertices);
        s->prepared->back_only = inside && job->primitive.material->cull == QTRI_CULL_BACK;
        bin_all_triangles(s);
    }
    if (job->primitive.material->fill != NULL) {
        job->primitive.material->fill->prepare(job, s->prepared->back_only);
    }
}

/* Transforms and bins a mesh whose vertices have not all room: slots hold some of them. */
QTRI_NOINLINE static void bin_by_slots(binner *s)
{
    const qtri_mesh *mesh = s->job->mesh;
    for (uint32_t number = 0; number < mesh->triangle_count; number++) {
        const uint8_t *triangle = qtri_mesh_triangle(mesh, number, qtri_mesh_has_bytes(mesh));
        qtri_vertex spare[3];
        qtri_vertex *vertex[3];
        if (qtri_mesh_fetch_triangle(s->job, triangle, spare, vertex) &&
            !qtri_mesh_is_culled(s->job, vertex[0], vertex[1], vertex[2])) {
            bin_visible(s, number, triangle, vertex);
        }
    }
}

/* Lists for every band, empty, and groups of a size that they are likely to hold. */
static void begin_lists(binner *s, qtri_prepared *prepared)
{
    const uint32_t bands = ((uint32_t)s->height + s->rows - 1) / s->rows;
    const uint32_t count = prepared->mesh->triangle_count;
    s->next = (2 * bands + LIST_BLOCK - 1) / LIST_BLOCK * LIST_BLOCK;
    s->end = prepared->list_count;
    s->lists = prepared->lists;
    qtri_band_divider_init(&s->divider, s->rows);
    s->group_log2 = 0;
    s->group = UINT32_MAX;
    prepared->listed = count;
    if (s->end < s->next + LIST_BLOCK) {
        s->end = 0;
        prepared->listed = 0;
        return;
    }
    while (s->group_log2 < GROUP_LOG2_MAX && count >> s->group_log2 > s->end - s->next) {
        s->group_log2++;
    }
    for (uint32_t i = 0; i < bands; i++) {
        s->lists[2 * i] = 0;
        s->lists[2 * i + 1] = LIST_FULL;
    }
}

/* The job for a surface, with `place` its transforms too. Not inlined: its arguments take stack. */
QTRI_NOINLINE static bool prepared_begin(qtri_mesh_job *job, const qtri_prepared *prepared,
                                         const qtri_surface *surface, bool place)
{
    return qtri_mesh_job_init(job, prepared->stage, surface, prepared->view,
                              place ? prepared->pose : NULL, prepared->mesh, prepared->material,
                              prepared->vertices, prepared->vertex_count);
}

static void bin(void *with)
{
    binner *s = with;
    if (s->is_complete) {
        bin_mesh(s);
    } else {
        qtri_mesh_clear_slots(s->job);
        bin_by_slots(s);
    }
}

static void prepare(qtri_prepared *prepared, const qtri_format *format)
{
    const qtri_mesh *mesh = prepared->mesh;
    const qtri_rect frame = {0, 0, prepared->width, prepared->height};
    const qtri_surface whole = {.format = format,
                                .width = prepared->width,
                                .height = prepared->height,
                                .rows = prepared->height,
                                .scissor = frame};
    qtri_mesh_job job;
    prepared->is_seen = false;
    if (mesh->triangle_count == 0 || qtri_rect_is_empty(&frame) ||
        !prepared_begin(&job, prepared, &whole, true)) {
        return;
    }
    /* With samples, which lie beside pixels' centres, rows are bounded as for lines. */
    const bool is_solid = job.primitive.material->fill == NULL && qtri_sampling_of(format) == NULL;
    binner s = {.job = &job,
                .prepared = prepared,
                .is_complete = is_complete(prepared),
                .before_24p8 = before_24p8(is_solid),
                .after_24p8 = after_24p8(is_solid),
                .height = prepared->height,
                .overlap = prepared->overlap,
                .rows = (uint32_t)prepared->rows};
    const qtri_rect none = {INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
    prepared->extent_24p8 = none;
    if (prepared->front_of == mesh) { /* they are set together */
        job.front = prepared->front;
        qtri_front_set_all(job.front, mesh->triangle_count);
    }
    begin_lists(&s, prepared);
    if (job.lights != NULL && job.lights->model->keeps_colors(&job, false)) {
        job.lights->model->mesh(&job, prepared->view, prepared->pose, true, bin, &s);
    } else {
        bin(&s);
    }
    list_pending(&s);
    prepared->is_seen = true;
    prepared->is_solid = is_solid;
    prepared->is_anywhere = s.is_anywhere;
    prepared->group_log2 = (uint8_t)s.group_log2;
    prepared->is_placed = !s.is_complete || s.is_anywhere || job.lit_per_face ||
                          (job.lights != NULL && !job.lights->model->keeps_colors(&job, true));
}

void qtri_prepare_mesh_by(const qtri_vertex_stage *stage, qtri_prepared *prepared,
                          const qtri_frame *frame, const qtri_view *view,
                          const qtri_transform *pose, const qtri_mesh *mesh,
                          const qtri_material *material)
{
    QTRI_ASSERT(stage != NULL && prepared != NULL && frame != NULL);
    QTRI_CHECK(qtri_check_prepared(prepared));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_CHECK(qtri_check_view(view, pose));
    QTRI_CHECK(qtri_check_mesh(mesh));
    prepared->stage = stage;
    prepared->view = view;
    prepared->pose = pose;
    prepared->mesh = mesh;
    prepared->material = material;
    prepared->width = frame->width;
    prepared->height = frame->height;
    prepared->rows = frame->rows;
    const int32_t overlap = qtri_hold32(frame->overlap, 0, QTRI_OVERLAP_MAX);
    const bool keeps = frame->kept != NULL; /* nothing is drawn in rows that are kept */
    prepared->overlap = keeps ? 0 : overlap;
    prepared->edges_above = keeps ? 2 * overlap : overlap;
    prepared->edges_below = prepared->overlap;
    divide_memory(prepared, qtri_colored_light(view) != NULL);
    prepare(prepared, frame->format);
}

void qtri_prepare_mesh(qtri_prepared *prepared, const qtri_frame *frame, const qtri_view *view,
                       const qtri_transform *pose, const qtri_mesh *mesh,
                       const qtri_material *material)
{
    qtri_prepare_mesh_by(&qtri_vertex_stage_any, prepared, frame, view, pose, mesh, material);
}

bool qtri_prepared_fits(const qtri_prepared *prepared)
{
    QTRI_ASSERT(prepared != NULL);
    QTRI_CHECK(qtri_check_prepared(prepared));
    return prepared->mesh != NULL &&
           (!prepared->is_seen || (is_complete(prepared) && prepared->group_log2 == 0 &&
                                   prepared->listed >= prepared->mesh->triangle_count));
}

/* ---- One band ---- */

/* Draws a list of single triangles of a complete mesh: all of them are visible. */
static void draw_visible(const qtri_mesh_job *job, const uint16_t *lists, uint32_t place,
                         uint32_t end)
{
    const bool narrow = qtri_mesh_has_bytes(job->mesh);
    while (place != end) {
        const void *triangle = qtri_mesh_triangle(job->mesh, next_group(lists, &place), narrow);
        uint32_t index[3];
        qtri_vertex *vertex[3];
        qtri_mesh_get(index, vertex, job->vertices, triangle, narrow);
        qtri_mesh_draw_visible(job, triangle, vertex);
    }
}

/* Fills a band's list of a mesh whose back faces were culled, all vertices inside. */
QTRI_NOINLINE static void draw_fronts(const qtri_mesh_job *draw, const uint16_t *lists,
                                      uint32_t place, uint32_t end)
{
    const bool narrow = qtri_mesh_has_bytes(draw->mesh);
    const uint8_t *triangles = qtri_mesh_triangle(draw->mesh, 0, narrow);
    qtri_small t = draw->primitive.to.solid.small;
    qtri_vertex *vertices = draw->vertices;
    while (place != end) {
        const uint8_t *triangle = triangles + next_group(lists, &place) * (narrow ? 3 : 6);
        uint32_t index[3];
        qtri_vertex *vertex[3];
        qtri_mesh_get(index, vertex, vertices, triangle, narrow);
        qtri_mesh_draw_front(draw, &t, triangle, index, vertex);
    }
}

QTRI_NOINLINE static void draw_list(const qtri_mesh_job *job, const qtri_prepared *prepared,
                                    uint32_t band)
{
    const qtri_mesh *mesh = prepared->mesh;
    const uint16_t *lists = prepared->lists;
    const uint32_t log2 = prepared->group_log2;
    uint32_t place = lists[2 * band];
    const uint32_t end = lists[2 * band + 1];
    if (place == 0) {
        return;
    }
    if (log2 == 0 && is_complete(prepared)) {
        if (prepared->back_only && job->primitive.material->fill == NULL) {
            draw_fronts(job, lists, place, end);
        } else {
            draw_visible(job, lists, place, end);
        }
        return;
    }
    while (place != end) {
        const uint32_t first = next_group(lists, &place) << log2;
        const uint32_t left = mesh->triangle_count - first;
        const uint32_t size = (uint32_t)1 << log2;
        qtri_mesh_draw_range(job, first, first + (left < size ? left : size));
    }
}

/* One band: its list, and triangles first..count - 1, which are in no list. */
typedef struct band_work {
    const qtri_mesh_job *job;
    const qtri_prepared *prepared;
    bool by_list;
    uint32_t band, first, count;
} band_work;

static void draw_band(void *with)
{
    const band_work *work = with;
    if (work->by_list) {
        draw_list(work->job, work->prepared, work->band);
    }
    qtri_mesh_draw_range(work->job, work->first, work->count);
}

void qtri_draw_prepared(const qtri_surface *surface, const qtri_prepared *prepared)
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_prepared(prepared));
    const qtri_rect bounds = qtri_surface_bounds(surface);
    if (prepared->mesh == NULL || !prepared->is_seen || qtri_rect_is_empty(&bounds) ||
        surface->width != prepared->width || surface->height != prepared->height) {
        return;
    }
    /* Rows of one band of the frame, and its overlap, have a list; others look at all triangles. */
    const uint32_t count = prepared->mesh->triangle_count;
    const uint32_t band = (uint32_t)(bounds.y0 + prepared->overlap) / (uint32_t)prepared->rows;
    const int32_t number = (int32_t)band;
    const bool by_list = prepared->listed > 0 && number * prepared->rows < prepared->height &&
                         bounds.y1 <= (number + 1) * prepared->rows + prepared->overlap;
    const uint32_t first = by_list ? prepared->listed : 0;
    qtri_mesh_job job;
    if ((first >= count && prepared->lists[2 * band] == 0) ||
        !prepared_begin(&job, prepared, surface, prepared->is_placed)) {
        return;
    }
    qtri_deferred_transform deferred = {&job.primitive.projector, prepared->view, prepared->pose,
                                        false};
    job.deferred = prepared->is_placed ? NULL : &deferred;
    if (!is_complete(prepared)) {
        qtri_mesh_clear_slots(&job);
    }
    if (job.primitive.material->fill != NULL) {
        job.primitive.material->fill->band(&job);
    } else if (is_complete(prepared)) {
        qtri_mesh_set_lit(&job);
    }
    band_work work = {&job, prepared, by_list, band, first, count};
    if (job.lights != NULL && prepared->is_placed) {
        job.lights->model->mesh(&job, prepared->view, prepared->pose, false, draw_band, &work);
    } else {
        draw_band(&work);
    }
}

/* ---- Rows that changed ---- */

/* The bounds, in pixels, of the visited vertices. */
static qtri_rect find_bounds(const qtri_prepared *prepared)
{
    if (prepared->mesh == NULL || !prepared->is_seen) {
        return nowhere;
    }
    if (prepared->is_anywhere) {
        const qtri_rect frame = {0, 0, prepared->width, prepared->height};
        return frame;
    }
    qtri_rect extent = prepared->extent_24p8; /* of vertices without a slot */
    if (is_complete(prepared)) {
        for (uint32_t i = 0; i < prepared->mesh->vertex_count; i++) {
            if (prepared->vertices[i].depth_16p8 != QTRI_VERTEX_EMPTY &&
                prepared->vertices[i].intensity_q15 != QTRI_VERTEX_UNLIT) {
                widen(&extent, &prepared->vertices[i]);
            }
        }
    }
    if (extent.x0 > extent.x1) {
        return nowhere;
    }
    extent.x0 = (extent.x0 + before_24p8(prepared->is_solid)) >> 8;
    extent.y0 = (extent.y0 + before_24p8(prepared->is_solid)) >> 8;
    extent.x1 = (extent.x1 + after_24p8(prepared->is_solid)) >> 8;
    extent.y1 = (extent.y1 + after_24p8(prepared->is_solid)) >> 8;
    return extent;
}

void qtri_prepared_mark(qtri_prepared *prepared, qtri_frame *frame)
{
    QTRI_ASSERT(prepared != NULL && frame != NULL);
    QTRI_CHECK(qtri_check_prepared(prepared));
    qtri_frame_mark(frame, &prepared->marked);
    prepared->marked = find_bounds(prepared);
    qtri_frame_mark(frame, &prepared->marked);
}
