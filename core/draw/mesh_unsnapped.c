/* SPDX-License-Identifier: MIT */
/*
 * Where the vertices of large triangles truly are: vertices do not keep it, since the small
 * triangles that meshes have most of do not ask. It is found again from the mesh's positions.
 */
#include "large_piece.h"
#include "mesh_job.h"

/* Of meshes that were prepared, a band sets transforms only for large triangles. */
QTRI_NOINLINE static void place_late(const qtri_mesh_job *draw)
{
    qtri_late_place *late = draw->late;
    qtri_primitive_place(late->primitive, late->view, late->pose);
    if (draw->positions->begin != NULL) {
        draw->positions->begin(&late->primitive->projector, draw->mesh);
    }
    late->is_set = true;
}

QTRI_NOINLINE static void find_rests(qtri_large_vertex v[3], const qtri_mesh_job *draw,
                                     const uint32_t index[3], const qtri_screen_point *const p[3])
{
    if (draw->late != NULL && !draw->late->is_set) {
        place_late(draw);
    }
    for (int i = 0; i < 3; i++) {
        qtri_clip_vertex clip;
        draw->positions->transform(&draw->primitive.projector, draw->mesh, index[i], &clip);
        qtri_project_rest(v[i].rest, &clip, p[i], v[i].inv_w_q31);
    }
}

void qtri_mesh_find_rests(qtri_large_vertex v[3], const qtri_mesh_job *draw,
                          const uint32_t index[3], const qtri_screen_point *const p[3],
                          int64_t area)
{
    const uint32_t depth_16p16[3] = {v[0].depth_16p16, v[1].depth_16p16, v[2].depth_16p16};
    if (qtri_rests_matter(&draw->primitive.to.solid.state, p, depth_16p16, area)) {
        find_rests(v, draw, index, p);
    }
}
