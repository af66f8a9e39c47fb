/* SPDX-License-Identifier: MIT */
#include "qtri/animation.h"
#include "qtri/error.h"

#include "../math/unit.h"

/* 127 v, rounded, of a part of a unit vector in Q2.30. */
static int8_t part_of(int32_t v_q30)
{
    return (int8_t)(((v_q30 >> 8) * 127 + ((int32_t)1 << 21)) >> 22); /* |.| <= 2^22 127 < 2^29 */
}

/* a (1 - t) + b t in Q16: |.| <= 127 2^16. */
static int32_t between(int8_t a, int8_t b, int32_t t)
{
    return a * (Q16_ONE - t) + b * t;
}

void qtri_morph_normals(qtri_normal8 *out, const qtri_normal8 *from, const qtri_normal8 *to,
                        uint32_t count, q16 t)
{
    QTRI_ASSERT((out != NULL && from != NULL && to != NULL) || count == 0);
    const q16 part = q16_clamp(t, 0, Q16_ONE);
    for (uint32_t i = 0; i < count; i++) {
        int32_t v[3] = {between(from[i].x, to[i].x, part), between(from[i].y, to[i].y, part),
                        between(from[i].z, to[i].z, part)};
        qtri_normal8 normal = from[i];
        if (qtri_unit(v, v, 3, 30)) {
            normal.x = part_of(v[0]);
            normal.y = part_of(v[1]);
            normal.z = part_of(v[2]);
        }
        out[i] = normal;
    }
}
