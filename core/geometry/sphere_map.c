/* SPDX-License-Identifier: MIT */
#include "illumination.h"

#include "qtri/error.h"
#include "linear_part.h"

/* The nearest of (1 + n) / 2 in Q14. */
static int16_t half_q14(int32_t n_q14)
{
    return (int16_t)((n_q14 + (1 << 14) + 1) >> 1);
}

void qtri_sphere_map(qtri_uv16 *uvs, const qtri_transform *camera, const qtri_transform *pose,
                     const qtri_mesh *mesh)
{
    QTRI_ASSERT(camera != NULL);
    QTRI_ASSERT(pose != NULL);
    QTRI_ASSERT(mesh != NULL);
    QTRI_ASSERT(uvs != NULL || mesh->vertex_count == 0);
    qtri_transform object_to_eye;
    int32_t m_q28[3][3];
    qtri_transform_mul(&object_to_eye, camera, pose);
    qtri_linear_normals(m_q28, &object_to_eye);
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        int32_t n[3] = {0, 0, 0};
        int64_t eye[3];
        int32_t unit_q14[3];
        if (mesh->normals8 != NULL) {
            n[0] = mesh->normals8[i].x * 128;
            n[1] = mesh->normals8[i].y * 128;
            n[2] = mesh->normals8[i].z * 128;
        } else if (mesh->normals != NULL) {
            n[0] = mesh->normals[i].x;
            n[1] = mesh->normals[i].y;
            n[2] = mesh->normals[i].z;
        }
        for (int row = 0; row < 3; row++) {
            eye[row] = qtri_mul_s32(m_q28[row][0], n[0]) + qtri_mul_s32(m_q28[row][1], n[1]) +
                       qtri_mul_s32(m_q28[row][2], n[2]);
        }
        (void)qtri_direction_q14(unit_q14, eye);
        uvs[i].x = half_q14(unit_q14[0]);
        uvs[i].y = half_q14(-unit_q14[1]);
    }
}
