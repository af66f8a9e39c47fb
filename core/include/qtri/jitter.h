/*
 * Views that are moved by a part of a pixel, for sums of frames (image.h).
 */
#ifndef QTRI_JITTER_H
#define QTRI_JITTER_H

#include <stdint.h>

#include "view.h"

#ifdef __cplusplus
extern "C" {
#endif

#define QTRI_JITTER_COUNT 32 /* places; further ones repeat them */

/*
 * *out sees what *view sees, moved within half a pixel of its viewport by place n, n modulo
 * QTRI_JITTER_COUNT, of the Halton sequence of bases 2 and 3: any 4, 8 or 16 that follow each other
 * from a multiple of as many lie evenly. To 1/65536 of half the viewport. The two may be the same;
 * to go on to the next place, start from the view that was not moved.
 */
void qtri_view_jitter(qtri_view *out, const qtri_view *view, uint32_t n);

#ifdef __cplusplus
}
#endif

#endif
