/*
 * Wireframes of meshes.
 */
#include "mesh_job.h"

QTRI_NOINLINE void qtri_mesh_draw_lines(const qtri_mesh_job *draw, const void *indices,
                                        qtri_vertex *const vertex[3])
{
    const qtri_mesh *mesh = draw->mesh;
    uint32_t intensity_q15 =
        draw->lit_per_face ? qtri_mesh_light_face(draw, indices) : QTRI_INTENSITY_ONE;
    qtri_screen_vertex screen[3];
    for (int i = 0; i < 3; i++) {
        screen[i].x_24p8 = vertex[i]->at.x_24p8;
        screen[i].y_24p8 = vertex[i]->at.y_24p8;
        screen[i].depth_16p16 = vertex[i]->depth_16p8 & ~0xFFu;
        if (draw->lit_per_vertex) {
            intensity_q15 = qtri_mesh_light_once(draw, indices, i, vertex[i]);
        }
        int32_t intensity = (int32_t)intensity_q15 * 2;
        qtri_rgb color = mesh->colors != NULL ? mesh->colors[qtri_mesh_index(mesh, indices, i)]
                                              : draw->material.color;
        screen[i].color_8p16[0] = color.r * intensity; /* <= 255.0 */
        screen[i].color_8p16[1] = color.g * intensity;
        screen[i].color_8p16[2] = color.b * intensity;
    }
    qtri_primitive_wireframe(&draw->primitive, screen);
}
