/*
 * Wireframes of meshes.
 */
#include "mesh_job.h"

/* The corners' colours, and the first once more: those of an edge are next to each other. */
static void set_colors(const qtri_mesh_job *draw, const void *indices, qtri_vertex *const vertex[3],
                       qtri_line_color color[4])
{
    const qtri_mesh *mesh = draw->mesh;
    const qtri_shading shading = draw->material.shading;
    uint32_t intensity_q15 =
        draw->lit_per_face ? qtri_mesh_light_face(draw, indices) : QTRI_INTENSITY_ONE;
    for (int i = 0; i < 4; i++) {
        int corner = i < 3 ? i : 0;
        if (shading != QTRI_SMOOTH) {
            corner = shading == QTRI_FLAT_FIRST ? 0 : 2;
        }
        if (draw->lit_per_vertex) {
            intensity_q15 = qtri_mesh_light_once(draw, indices, corner, vertex[corner]);
        }
        int32_t intensity = (int32_t)intensity_q15 * 2;
        qtri_rgb rgb = mesh->colors != NULL ? mesh->colors[qtri_mesh_index(mesh, indices, corner)]
                                            : draw->material.color;
        color[i][0] = rgb.r * intensity; /* <= 255.0 */
        color[i][1] = rgb.g * intensity;
        color[i][2] = rgb.b * intensity;
    }
}

void qtri_mesh_clear_edges(const qtri_mesh_job *draw)
{
    for (uint32_t i = 0; i < draw->mesh->vertex_count; i++) {
        draw->vertices[i].inv_w = 0;
    }
}

/* Whether the edge from a to b is drawn for the first time, as far as is known; notes that it is.
 */
static inline bool is_new_edge(uint32_t from, uint32_t to, qtri_vertex *a, const qtri_vertex *b)
{
    const uint32_t noted = b->inv_w;
    const uint32_t back = (from - to) & 0xFFFFu;
    if ((noted & 0xFFFFu) == back || noted >> 16 == back) {
        return false;
    }
    a->inv_w = a->inv_w << 16 | ((to - from) & 0xFFFFu);
    return true;
}

/* One bit for each of the edges 01 12 20 that has to be drawn. */
static inline uint32_t new_edges(const qtri_mesh_job *draw, const void *indices,
                                 qtri_vertex *const vertex[3])
{
    uint32_t index[3];
    qtri_mesh_indices(index, indices, draw->mesh->triangles8 != NULL);
    return (is_new_edge(index[0], index[1], vertex[0], vertex[1]) ? 1u : 0) |
           (is_new_edge(index[1], index[2], vertex[1], vertex[2]) ? 2u : 0) |
           (is_new_edge(index[2], index[0], vertex[2], vertex[0]) ? 4u : 0);
}

QTRI_NOINLINE void qtri_mesh_draw_lines(const qtri_mesh_job *draw, const void *indices,
                                        qtri_vertex *const vertex[3])
{
    const qtri_line_job *line = &draw->primitive.line;
    if (qtri_line_misses(line, vertex[0]->at.y_24p8, vertex[1]->at.y_24p8, vertex[2]->at.y_24p8)) {
        return;
    }
    const uint32_t edges = draw->edges_once ? new_edges(draw, indices, vertex) : 7;
    if (edges == 0) {
        return;
    }
    qtri_line_color own[4];
    const qtri_line_color *color = NULL;
    if (draw->lit_per_vertex && draw->mesh->colors == NULL) {
        for (int i = 0; i < 3; i++) {
            (void)qtri_mesh_light_once(draw, indices, i, vertex[i]);
        }
    } else {
        set_colors(draw, indices, vertex, own);
        color = (const qtri_line_color *)own;
    }
    if ((edges & 1) != 0) {
        qtri_line_draw(line, vertex[0], vertex[1], color);
    }
    if ((edges & 2) != 0) {
        qtri_line_draw(line, vertex[1], vertex[2], color != NULL ? color + 1 : NULL);
    }
    if ((edges & 4) != 0) {
        qtri_line_draw(line, vertex[2], vertex[0], color != NULL ? color + 2 : NULL);
    }
}
