/* SPDX-License-Identifier: MIT */
/*
 * Formats of depth: what a surface stores for each pixel's distance, as constant data.
 *
 * Depth is window z, 0 at the near plane and 1 at the far one. A surface stores it as 16 bits,
 * linear in the window, unless it is laid out with another format (qtri_surface_init_depth,
 * qtri_frame_init_depth); what an application does not name is not linked.
 *
 *     static uint8_t memory[QTRI_FRAME_BYTES_DEPTH(320, 16, QTRI_RGB565_BYTES,
 *                                                  QTRI_DEPTH_FLOAT16_BYTES)];
 *     qtri_frame_init_depth(&frame, &qtri_rgb565, &qtri_depth_float16, 320, 240, 16, memory,
 *                           sizeof memory);
 */
#ifndef QTRI_DEPTH_H
#define QTRI_DEPTH_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What tests depths that are not linear16: &qtri_depth_testing_stages. */
typedef struct qtri_depth_testing qtri_depth_testing;
extern const qtri_depth_testing qtri_depth_testing_stages;

/*
 * Between the stages depth is 16.16: window z times 65535, 0..0xFFFF0000. A stored depth is an
 * integer in the machine's byte order; of three bytes the lowest is first. Stored depths must
 * compare as depths do: a farther one is never less.
 */
typedef struct qtri_depth_format {
    uint8_t bytes;                     /* of a stored depth: 2, 3 or 4 */
    const qtri_depth_testing *testing; /* &qtri_depth_testing_stages; NULL: it is linear16 */
    /* Depths to stored ones and back, in place; `count` is 1..32. */
    void (*encode)(uint32_t *depth, int32_t count);
    void (*decode)(uint32_t *depth, int32_t count);
} qtri_depth_format;

extern const qtri_depth_format qtri_depth_linear16; /* 65535 steps; where none is named */
extern const qtri_depth_format qtri_depth_float16;  /* 1 - z: 4 bits exponent, 12 bits mantissa */
extern const qtri_depth_format qtri_depth_linear24; /* steps of 1/256 of those of linear16 */
extern const qtri_depth_format qtri_depth_linear32; /* steps of 1/65536 of them */

/* Bytes of a stored depth, for memory of constant size. */
enum {
    QTRI_DEPTH_LINEAR16_BYTES = 2,
    QTRI_DEPTH_FLOAT16_BYTES = 2,
    QTRI_DEPTH_LINEAR24_BYTES = 3,
    QTRI_DEPTH_LINEAR32_BYTES = 4
};

#ifdef __cplusplus
}
#endif

#endif
