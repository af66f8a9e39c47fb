#include "texel_number.h"

#include "loop.h"
#include "texel_copy.h"
#include "words.h"

#define MOVE(n)                                                                                    \
    number += (n);                                                                                 \
    QTRI_OPAQUE(number)

#define STEP                                                                                       \
    u += u_step;                                                                                   \
    v += v_step;                                                                                   \
    QTRI_OPAQUE(u)                                                                                 \
    QTRI_OPAQUE(v)                                                                                 \
    QTRI_ASIDE(u_step)                                                                             \
    QTRI_ASIDE(v_step)

#define BEND                                                                                       \
    u_step += u_bend;                                                                              \
    v_step += v_bend;                                                                              \
    QTRI_ASIDE(u_bend)                                                                             \
    QTRI_ASIDE(v_bend)

void qtri_texel_numbers_repeated(uint32_t *number, const qtri_curve uv[2], uint32_t cut,
                                 int32_t count)
{
#define READ(i) number[i] = qtri_texel_index(u, v, cut);
#include "texel_number.inc"
}

#ifndef __OPTIMIZE_SIZE__
void qtri_texels_repeated_16(uint32_t *number, const qtri_curve uv[2], uint32_t cut,
                             const void *texels, int32_t count)
{
    const uint8_t *bytes = texels;
#define READ(i)                                                                                    \
    {                                                                                              \
        const uint32_t at = qtri_texel_index(u, v, cut) * 2;                                       \
        number[i] = *(const uint16_t *)(const void *)(bytes + at);                                 \
        QTRI_ASIDE(bytes)                                                                          \
    }
#include "texel_number.inc"
}
#endif

void qtri_texel_numbers(uint32_t *number, const qtri_curve uv[2], const qtri_texel_axis axis[2],
                        int32_t count)
{
    uint32_t u = uv[0].at;
    uint32_t v = uv[1].at;
    uint32_t u_step = uv[0].step;
    uint32_t v_step = uv[1].step;
    const uint32_t *end = number + count;
    do {
        const uint32_t column = qtri_texel_wrapped(&axis[0], u >> axis[0].texel_shift);
        const uint32_t row = qtri_texel_wrapped(&axis[1], v >> axis[1].texel_shift);
        *number++ = (row << axis[0].side_log2) + column;
        u += u_step;
        v += v_step;
        u_step += uv[0].bend;
        v_step += uv[1].bend;
    } while (number != end);
    /* Up to a multiple of four they must be numbers of texels. */
    for (; (count & 3) != 0; count++) {
        *number++ = 0;
    }
}

#undef MOVE
#define MOVE(n)                                                                                    \
    u += (n);                                                                                      \
    v += (n);

void qtri_texel_coordinates(uint32_t *u, uint32_t *v, const qtri_curve uv[2], int32_t count)
{
    uint32_t u_at = uv[0].at;
    uint32_t v_at = uv[1].at;
    uint32_t u_step = uv[0].step;
    uint32_t v_step = uv[1].step;
    const uint32_t u_bend = uv[0].bend;
    const uint32_t v_bend = uv[1].bend;
#define ONE(i)                                                                                     \
    u[i] = u_at;                                                                                   \
    v[i] = v_at;                                                                                   \
    u_at += u_step;                                                                                \
    v_at += v_step;                                                                                \
    u_step += u_bend;                                                                              \
    v_step += v_bend;
    QTRI_WORDS(count)
#undef ONE
}
