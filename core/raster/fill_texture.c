#include "fill.h"
#include "texel_copy.h"

void qtri_run_copy_less(const qtri_job *job, const qtri_run *run)
{
    const qtri_texture *texture = job->raster->texture;
    const uint16_t *texels = texture->texels;
    const uint32_t row_mask = qtri_texel_copy_rows(texture);
    const int32_t column_shift = qtri_texel_copy_shift(texture, 0);
    uint16_t *pixel = (uint16_t *)(void *)run->pixels + run->x;
    uint16_t *depth = run->depths + run->x;
    uint32_t z = run->z;
    uint32_t u = run->uv[0];
    uint32_t v = run->uv[1];
    const uint32_t depth_step = job->depth.dx;
    const uint32_t u_step = run->uv_step[0];
    const uint32_t v_step = run->uv_step[1];
    int32_t count = run->count;
#define ONE(i)                                                                                     \
    if (z >> 16 < depth[i]) {                                                                      \
        QTRI_BRANCH                                                                                \
        depth[i] = (uint16_t)(z >> 16);                                                            \
        pixel[i] = texels[(u >> column_shift) + ((v & row_mask) >> 16)];                           \
    }                                                                                              \
    z += depth_step;                                                                               \
    u += u_step;                                                                                   \
    v += v_step;                                                                                   \
    QTRI_OPAQUE(z)                                                                                 \
    QTRI_OPAQUE(u)                                                                                 \
    QTRI_OPAQUE(v)
    QTRI_PIXELS(count)
#undef ONE
}
