/* SPDX-License-Identifier: MIT */
/*
 * Views that are moved by a part of a pixel, for sums of frames (filters.h).
 */
#ifndef QTRI_JITTER_H
#define QTRI_JITTER_H

#include <stdint.h>

#include "view.h"

#ifdef __cplusplus
extern "C" {
#endif

#define QTRI_JITTER_LOG2_MAX 5 /* 32 frames, as many as a sum holds */

/*
 * *out sees what *view sees, moved within half a pixel of its viewport by place n (modulo their
 * number) of 2^frames_log2 (held to 0..5): one in each column and each row of as many parts of a
 * pixel (Hammersley's set, every second one exchanged with the next: of four, a rotated grid).
 * Their mean is the middle of the pixel. To 1/65536 of half the viewport. The two may be the same;
 * to go on to the next place, start from the view that was not moved.
 */
void qtri_view_jitter(qtri_view *out, const qtri_view *view, uint32_t n, int32_t frames_log2);

#ifdef __cplusplus
}
#endif

#endif
