/* SPDX-License-Identifier: MIT */
/*
 * The state of a draw call of a mesh, and its triangles: drawn whole (mesh.c), in bands
 * (mesh_bands.c), as loose triangles (triangles.c), as lines, with outlines. Internal.
 */
#ifndef QTRI_DRAW_MESH_JOB_H
#define QTRI_DRAW_MESH_JOB_H

#include "qtri/light.h"

#include "../geometry/illumination.h"
#include "../geometry/lighting.h"
#include "../bits/bits.h"
#include "primitive.h"

/* A job's transforms, which are set when the first triangle needs them. */
typedef struct qtri_deferred_transform {
    qtri_projector *projector; /* the job's */
    const qtri_view *view;
    const qtri_transform *pose;
    bool is_set;
} qtri_deferred_transform;

/* Loose triangles, each of which is drawn as a mesh of one triangle. */
typedef union qtri_loose_triangle {
    struct {
        qtri_vec3 positions[3];
        qtri_vec2 uvs[3];
        qtri_rgb colors[3];
        /* Vertices of the triangle and of the one before it: files mostly list triangles in an
           order in which two that follow each other share vertices. */
        qtri_vertex vertex[2][3];
    } inside;
    qtri_shape shape; /* of one that may be clipped: it overwrites the vertices */
} qtri_loose_triangle;

/* See qtri_small.light. */
typedef uint32_t qtri_light_finder(const void *from, const void *indices, qtri_vertex *a,
                                   qtri_vertex *b, qtri_vertex *c);

/* One draw call: what every triangle needs. */
typedef struct qtri_mesh_job {
    const qtri_mesh *mesh;
    const qtri_vertex_stage *stage;
    const qtri_position_ops *positions; /* for its kind of them; NULL: the stage has none */
    qtri_vertex *vertices;              /* slot_count of them */
    uint32_t slot_count;
    bool lit_per_vertex, lit_per_face;
    bool noted;             /* a wireframe: slots note the edges to draw, see mesh_lines.c */
    bool shaded_per_vertex; /* with lights: colours are of vertices, not of faces */
    qtri_light_finder *find_large_light; /* NULL: intensity 1 */
    /* view->light, if it has sources, and with them: */
    const qtri_light *lights;
    const struct qtri_illumination *illumination; /* NULL: lit_colors has all that is needed */
    uint32_t *lit_colors;                         /* of every vertex; NULL: there is no room */
    qtri_deferred_transform *deferred;            /* NULL: transforms are set */
    /* For an outline: a bit a triangle, which mesh_faces.c clears if it faces away; NULL: none. */
    uint32_t *front;
    qtri_primitive primitive; /* behind fields that Armv6-M's short offsets should reach */
    union {
        struct {
            qtri_lighting lighting;
            uint16_t table[QTRI_TABLE]; /* the draw state's */
        } mesh;
        qtri_loose_triangle triangle;
    } of;
} qtri_mesh_job;

/*
 * material->fill: how triangles are drawn. NULL fills them: mesh_triangle.c those of meshes,
 * primitive.c clipped ones. Other ways are tables of functions that nothing else refers to: the
 * linker drops those that no material names.
 */
struct qtri_fill {
    /* Sets primitive->to for its surface and its material. */
    void (*begin)(qtri_primitive *primitive);
    /* A triangle that may need clipping by `planes`, and culling; see qtri_primitive_triangle. */
    void (*clipped)(const qtri_primitive *primitive, const qtri_clip_vertex v[3], unsigned planes,
                    qtri_attribute_source source, const void *from);
    /* A visible triangle of a mesh, inside all planes. */
    void (*triangle)(const qtri_mesh_job *draw, const void *indices, qtri_vertex *const vertex[3]);
    /* Transforms and draws a mesh with a slot for every vertex. */
    void (*mesh)(qtri_mesh_job *draw);
    /* Called once the vertices of a prepared mesh are in their slots; those of culled faces may be
       left out. */
    void (*prepare)(const qtri_mesh_job *draw, bool back_only);
    /* Called before each band of a prepared mesh. */
    void (*band)(qtri_mesh_job *draw);
};

/* Functions that the fills of wireframes share, in mesh_lines.c: shared edges are drawn once. */
void qtri_wireframe_triangle(const qtri_mesh_job *draw, const void *triangle,
                             qtri_vertex *const vertex[3]);
void qtri_wireframe_mesh(qtri_mesh_job *draw);
void qtri_wireframe_prepare(const qtri_mesh_job *draw, bool back_only);
void qtri_wireframe_band(qtri_mesh_job *draw);

/* The fill of a wireframe with this `begin`. */
#define QTRI_WIREFRAME_FILL(begin)                                                                 \
    {                                                                                              \
        begin, qtri_primitive_outline, qtri_wireframe_triangle, qtri_wireframe_mesh,               \
            qtri_wireframe_prepare, qtri_wireframe_band                                            \
    }

/* Sets a job up, with transforms and light where a pose is given. False: nothing of the mesh can be
   seen on the surface. */
bool qtri_mesh_job_init(qtri_mesh_job *draw, const qtri_vertex_stage *stage,
                        const qtri_surface *surface, const qtri_view *view,
                        const qtri_transform *pose, const qtri_mesh *mesh,
                        const qtri_material *material, qtri_vertex *vertices,
                        uint32_t vertex_count);

/* Transforms `count` vertices from `first` on. False: one of them is outside a plane. */
static inline bool qtri_mesh_transform(const qtri_mesh_job *draw, uint32_t first, uint32_t count,
                                       qtri_vertex *out)
{
    return draw->positions->project(&draw->primitive.projector, draw->mesh, first, count, out,
                                    false);
}

/*
 * The vertices of the triangle with these indices, transformed into their slots: vertex i lives in
 * slot i modulo their number; when another corner holds it, or there is none, spare[] serves.
 * False when an index is past the end.
 */
bool qtri_mesh_fetch_triangle(const qtri_mesh_job *draw, const void *triangle, qtri_vertex spare[3],
                              qtri_vertex *vertex[3]);

/* Marks all slots as empty. */
static inline void qtri_mesh_clear_slots(const qtri_mesh_job *draw)
{
    const uint32_t all = draw->mesh->vertex_count;
    qtri_vertex *vertex = draw->vertices;
    for (uint32_t left = draw->slot_count < all ? draw->slot_count : all; left != 0; left--) {
        vertex->depth_16p8 = QTRI_VERTEX_EMPTY;
        vertex++;
    }
}

/* For a job that fills and whose visible vertices are all lit: small triangles need not ask for
   their light. */
static inline void qtri_mesh_set_lit(qtri_mesh_job *draw)
{
    if (draw->lit_per_vertex) {
        draw->primitive.to.solid.small.light = NULL;
    }
}

/* Sets the intensity of vertices that have none yet: 1 where the mesh is not lit per vertex. */
void qtri_mesh_light_vertices(const qtri_mesh_job *draw, const void *indices, qtri_vertex *a,
                              qtri_vertex *b, qtri_vertex *c);

/* The intensity, Q15, of the triangle with these indices, for a mesh lit per face. */
uint32_t qtri_mesh_light_face(const qtri_mesh_job *draw, const void *indices);

/* Whether a triangle is culled; one with a vertex outside a plane is not, before clipping. */
bool qtri_mesh_is_culled(const qtri_mesh_job *draw, const qtri_vertex *a, const qtri_vertex *b,
                         const qtri_vertex *c);

/* Draws what is visible of triangles first..end - 1. Where there is a slot for every vertex, they
   hold all but those of triangles that were culled by their planes. */
void qtri_mesh_draw_range(const qtri_mesh_job *draw, uint32_t first, uint32_t end);

/* Draws a triangle that crosses a plane or was not culled. */
void qtri_mesh_draw_visible(const qtri_mesh_job *draw, const void *indices,
                            qtri_vertex *const vertex[3]);

/* Sets what filled triangles share. `light`: &qtri_mesh_find_light, or NULL for intensity 1. */
void qtri_mesh_solid_init(qtri_mesh_job *draw, qtri_light_finder *light);
qtri_light_finder qtri_mesh_find_light;

/* Draws a triangle inside all planes that is too large for qtri_mesh_draw_small(). */
void qtri_mesh_draw_large(const qtri_mesh_job *draw, const void *indices, qtri_vertex *a,
                          qtri_vertex *b, qtri_vertex *c);

/* Draws the triangle with these indices, inside all planes; false: it is too large for this. */
QTRI_INLINE bool qtri_mesh_draw_small(qtri_small *t, const void *indices, const uint32_t index[3],
                                      qtri_vertex *const vertex[3])
{
    t->indices = indices;
    t->index[0] = index[0];
    t->index[1] = index[1];
    t->index[2] = index[2];
    t->v[0] = vertex[0];
    t->v[1] = vertex[1];
    t->v[2] = vertex[2];
    return t->state->small(t);
}

static inline bool qtri_mesh_has_bytes(const qtri_mesh *mesh)
{
    return mesh->triangles8 != NULL;
}

/* qtri_draw_mesh_by() with job.front set. False: nothing of the mesh can be seen. */
bool qtri_mesh_draw(const qtri_vertex_stage *stage, const qtri_surface *surface,
                    const qtri_view *view, const qtri_transform *pose, const qtri_mesh *mesh,
                    const qtri_material *material, uint32_t *front);

/* The front bits of all triangles, and a 0 behind them. */
static inline void qtri_front_set_all(uint32_t *front, uint32_t count)
{
    for (; count >= 32; count -= 32) {
        *front++ = UINT32_MAX;
    }
    *front = ((uint32_t)1 << count) - 1;
}

/* The indices of a triangle. */
static inline const void *qtri_mesh_triangle(const qtri_mesh *mesh, uint32_t number, bool narrow)
{
    return narrow ? (const void *)mesh->triangles8[number] : (const void *)mesh->triangles[number];
}

/* The indices of a triangle as numbers. `narrow`: they are stored as bytes. */
QTRI_INLINE void qtri_mesh_indices(uint32_t index[3], const void *triangle, bool narrow)
{
    const uint16_t *wide = triangle;
    const uint8_t *bytes = triangle;
    index[0] = narrow ? bytes[0] : wide[0];
    index[1] = narrow ? bytes[1] : wide[1];
    index[2] = narrow ? bytes[2] : wide[2];
}

/* The vertices with these indices, of a mesh that has a slot for each. */
QTRI_INLINE void qtri_mesh_get_vertices(qtri_vertex *vertex[3], qtri_vertex *vertices,
                                        const uint32_t index[3])
{
    uint8_t *first = (uint8_t *)vertices;
    uint32_t size = sizeof(qtri_vertex);
    QTRI_HOLD(size); /* one multiplication: GCC 12 would make shifts and sums of it */
    qtri_vertex *a = (qtri_vertex *)(void *)(first + index[0] * size);
    qtri_vertex *b = (qtri_vertex *)(void *)(first + index[1] * size);
    qtri_vertex *c = (qtri_vertex *)(void *)(first + index[2] * size);
    QTRI_HOLD(a); /* three registers; GCC 12 would keep six */
    QTRI_HOLD(b);
    QTRI_HOLD(c);
    vertex[0] = a;
    vertex[1] = b;
    vertex[2] = c;
}

/* The indices and vertices of a triangle, as both functions above. */
QTRI_INLINE void qtri_mesh_get(uint32_t index[3], qtri_vertex *vertex[3], qtri_vertex *vertices,
                               const void *triangle, bool narrow)
{
    qtri_mesh_indices(index, triangle, narrow);
    qtri_mesh_get_vertices(vertex, vertices, index);
}

/* As qtri_mesh_get(); false if an index is not below `count`. */
QTRI_INLINE bool qtri_mesh_find(uint32_t index[3], qtri_vertex *vertex[3], qtri_vertex *vertices,
                                uint32_t count, const void *triangle, bool narrow)
{
    qtri_mesh_indices(index, triangle, narrow);
    if (index[0] >= count || index[1] >= count || index[2] >= count) {
        return false;
    }
    qtri_mesh_get_vertices(vertex, vertices, index);
    return true;
}

static inline bool qtri_mesh_is_inside(const qtri_vertex *a, const qtri_vertex *b,
                                       const qtri_vertex *c)
{
    return ((a->depth_16p8 | b->depth_16p8 | c->depth_16p8) & QTRI_VERTEX_OUTSIDE) == 0;
}

/* Whether one plane has all three on its outer side. */
static inline bool qtri_mesh_is_outside(qtri_vertex *const vertex[3])
{
    unsigned common = QTRI_VERTEX_OUTCODE;
    for (int i = 0; i < 3; i++) {
        uint32_t word = vertex[i]->depth_16p8;
        common &= (word & QTRI_VERTEX_OUTSIDE) != 0 ? word : 0;
    }
    return common != 0;
}

/* False: a vertex was left out, as all its faces are culled. */
static inline bool qtri_mesh_are_transformed(qtri_vertex *const vertex[3])
{
    return vertex[0]->depth_16p8 != QTRI_VERTEX_EMPTY &&
           vertex[1]->depth_16p8 != QTRI_VERTEX_EMPTY && vertex[2]->depth_16p8 != QTRI_VERTEX_EMPTY;
}

/*
 * floor(row / rows) for bands of so many rows: the inverse is 2^shift / rows rounded up, so the
 * product is row / rows and at most row / 2^shift too much: less than 1 / rows, since row < 2^13
 * and 2^shift >= 2^13 rows.
 */
typedef struct qtri_band_divider {
    uint32_t inverse, shift;
} qtri_band_divider;

static inline void qtri_band_divider_init(qtri_band_divider *divider, uint32_t rows)
{
    divider->shift = 13;
    while ((uint32_t)1 << (divider->shift - 13) < rows) {
        divider->shift++;
    }
    divider->inverse = (((uint32_t)1 << divider->shift) + rows - 1) / rows;
}

static inline uint32_t qtri_band_of(const qtri_band_divider *divider, uint32_t row)
{
    return (row * divider->inverse) >> divider->shift; /* < 2^13 (2^14 + 1) */
}

/* Sets point->place: a vertex's position in the coordinates of the job's illumination. */
QTRI_IN_PLACE void qtri_lit_vertex_place(qtri_lit_point *point, const qtri_mesh_job *draw,
                                         uint32_t index)
{
    const qtri_mesh *mesh = draw->mesh;
    if (mesh->positions16 != NULL) {
        qtri_illuminated_place16(point, draw->illumination, &mesh->positions16[index]);
    } else {
        qtri_illuminated_place(point, draw->illumination, &mesh->positions[index]);
    }
}

/* The colour of a vertex before light: its own, or the material's. */
static inline const qtri_rgb *qtri_mesh_color(const qtri_mesh_job *draw, uint32_t index)
{
    return draw->mesh->colors != NULL ? &draw->mesh->colors[index]
                                      : &draw->primitive.material->color;
}

#endif
