/* SPDX-License-Identifier: MIT */
/*
 * Depths that leave the range of a depth buffer. Internal.
 *
 * A triangle that the near plane has cut has two vertices at depth 0, and its true plane is a
 * little below 0 where they are snapped to, outwards by up to half a step. To hold the three depths
 * to the range would bend the plane: all pixels would be off by what is steep there. So the ramp is
 * that of the true plane, and pixels whose depth leaves the range, of which few triangles have one,
 * are filled apart, at the range's end.
 */
#ifndef QTRI_RASTER_DEPTH_CLAMP_H
#define QTRI_RASTER_DEPTH_CLAMP_H

#include "job.h"
#include "unsnapped.h"

/*
 * The depth's ramp through the true places; the job's anchor is set. False, and nothing is set,
 * where 32 bits would not hold a step of it.
 */
bool qtri_depth_clamp_init(qtri_job *job, const qtri_attributes v[3], const qtri_gradient *gradient,
                           const qtri_unsnapped *unsnapped);

/* Whether no pixel of these rows is out of range; it may say no. Then they are filled as others. */
bool qtri_depth_clamp_is_inside(qtri_job *job, const qtri_span *spans, int32_t row, int32_t count);

/*
 * The next part of these rows, the last one being *part of row first + *i; at first an empty one
 * before the first row. Sets the job's depth for it. False: there is none.
 */
bool qtri_depth_clamp_next(qtri_job *job, qtri_span *part, int32_t *i, const qtri_span *spans,
                           int32_t first, int32_t count);

#endif
