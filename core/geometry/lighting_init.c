/* SPDX-License-Identifier: MIT */
#include "lighting.h"

#include "../math/unit.h"
#include "linear_part.h"

/*
 * ambient + diffuse (n . towards) / unit as a row of intensities times 2^25, plus half of a step of
 * 2^-15. |m| <= 4 2^27, 2^29.8 for all three.
 */
static void set_plain_row(qtri_lighting *lighting, int32_t unit)
{
    int32_t m[3];
    for (int i = 0; i < 3; i++) {
        int64_t product_q46 = (int64_t)lighting->towards_q30[i] * lighting->diffuse; /* <= 2^48 */
        bool half;
        int32_t size =
            (int32_t)qtri_divide64(qtri_magnitude64(product_q46), (uint32_t)unit * 32, 0, &half);
        m[i] = (product_q46 < 0 ? -size : size) & ~(int32_t)3;
    }
    int64_t ambient_q16 = lighting->ambient > Q16_ONE ? Q16_ONE : lighting->ambient;
    int64_t t_q41 = (ambient_q16 << 25) + ((int64_t)1 << 25);
    qtri_row16_set(&lighting->by.row, m, t_q41);
    lighting->least_q15 = (uint32_t)(t_q41 >> 26);
}

void qtri_lighting_init(qtri_lighting *lighting, const qtri_light *light,
                        const qtri_transform *object_to_eye, int32_t unit)
{
    int32_t m[3][4];
    (void)qtri_linear_align(m, object_to_eye);
    lighting->ambient = light->ambient;
    lighting->diffuse = light->diffuse;
    lighting->even = qtri_linear_is_even(m);
    lighting->plain = lighting->even && light->ambient >= 0 && light->diffuse >= 0 &&
                      light->diffuse <= 4 * Q16_ONE;
    const int32_t towards[3] = {light->towards.x, light->towards.y, light->towards.z};
    if (!QTRI_WITH_UNEVEN_LIGHT && !lighting->plain) {
        return;
    }
    if (!lighting->even) {
        (void)qtri_unit(lighting->towards_q30, towards, 3, 30);
        qtri_linear_normals(lighting->by.normal_q28, object_to_eye);
        return;
    }
    int64_t object[3]; /* the transpose takes it there; < 3 2^61 */
    int32_t fitted[3];
    for (int i = 0; i < 3; i++) {
        m[i][3] = towards[i];
    }
    for (int i = 0; i < 3; i++) {
        object[i] = qtri_linear_dot(m, i, 3);
    }
    (void)qtri_fit32(fitted, object, 3);
    (void)qtri_unit(lighting->towards_q30, fitted, 3, 30); /* stays zero for no direction */
    if (lighting->plain) {
        set_plain_row(lighting, unit);
    }
}
