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
#include "outline_find.h"

#include "mesh_faces.h"

enum { PASSES = 3, ALL_EDGES = 7, CREASE_Q15 = 1 << 11 };

/* Of the triangle whose neighbours these are. */
static inline uint32_t number_of(const uint16_t *neighbours, const uint16_t *n)
{
    return (uint32_t)(n - neighbours) * qtri_mesh_faces_third();
}

/* A function of its own: none of the other ways to find edges takes its registers. */
QTRI_NOINLINE static bool find_by_neighbours(qtri_edge_finder *f)
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

void qtri_outline_add_sums(const qtri_outline *outline)
{
    const qtri_mesh *mesh = outline->mesh;
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        outline->sums[i] = 0;
    }
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        if ((qtri_front_bit(outline->front, i) & 1) != 0) {
            uint32_t index[3];
            qtri_mesh_indices(index, qtri_outline_triangle(mesh, i), qtri_mesh_has_bytes(mesh));
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

static bool find_by_sums(qtri_edge_finder *f)
{
    const qtri_mesh *mesh = f->outline->mesh;
    const uint32_t *sums = f->outline->sums;
    for (; f->from < mesh->triangle_count; f->from++) {
        if ((qtri_front_bit(f->outline->front, f->from) & 1) == 0) {
            continue;
        }
        uint32_t index[3];
        qtri_mesh_indices(index, qtri_outline_triangle(mesh, f->from), qtri_mesh_has_bytes(mesh));
        const uint32_t edges = is_alone(sums, index[0], index[1]) |
                               is_alone(sums, index[1], index[2]) << 1 |
                               is_alone(sums, index[2], index[0]) << 2;
        if (edges != 0 && !f->take(f, f->from, edges, false)) {
            return false;
        }
    }
    return true;
}

static bool has_vertices(const qtri_mesh *mesh, uint32_t number)
{
    uint32_t index[3];
    qtri_mesh_indices(index, qtri_outline_triangle(mesh, number), qtri_mesh_has_bytes(mesh));
    return index[0] < mesh->vertex_count && index[1] < mesh->vertex_count &&
           index[2] < mesh->vertex_count;
}

static bool find_borders(qtri_edge_finder *f)
{
    const qtri_outline *outline = f->outline;
    const qtri_mesh *mesh = outline->mesh;
    if (qtri_culls(outline->material->cull) || mesh->neighbours == NULL) {
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

static uint32_t creases_of(const qtri_edge_finder *f, uint32_t number)
{
    const qtri_mesh *mesh = f->outline->mesh;
    const uint16_t *neighbours = mesh->neighbours[number];
    const uint32_t own = qtri_mesh_light_face(f->job, qtri_outline_triangle(mesh, number));
    uint32_t edges = 0;
    for (int i = 0; i < 3; i++) {
        const uint32_t n = neighbours[i];
        if (n > number && (qtri_front_bit(f->outline->front, n) & 1) != 0) {
            const uint32_t other = qtri_mesh_light_face(f->job, qtri_outline_triangle(mesh, n));
            const uint32_t apart = own > other ? own - other : other - own;
            edges |= (uint32_t)(apart > CREASE_Q15) << i;
        }
    }
    return edges;
}

static bool find_creases(qtri_edge_finder *f)
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
static uint32_t find(qtri_edge_finder *f, uint32_t pass, uint32_t from)
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
    qtri_mesh_job_init(job, &qtri_vertex_stage_any, &whole, outline->view, outline->mesh,
                       outline->material, outline->view->vertices, outline->view->vertex_count);
    return qtri_mesh_job_place(job, outline->view, outline->pose) ? job : NULL;
}

/* A function of its own: light takes a job's stack. */
QTRI_NOINLINE static uint32_t find_in_light(qtri_edge_finder *f, uint32_t pass, uint32_t from)
{
    qtri_mesh_job job;
    f->job = light_of(&job, f->outline);
    const uint32_t left = find(f, pass, from);
    f->job = NULL;
    return left;
}

uint32_t qtri_outline_find(qtri_edge_finder *f, uint32_t pass, uint32_t from)
{
    if (pass >= PASSES) {
        return PASSES;
    }
    return f->outline->creases ? find_in_light(f, pass, from) : find(f, pass, from);
}
