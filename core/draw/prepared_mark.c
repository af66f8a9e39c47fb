/* SPDX-License-Identifier: MIT */
#include "checked.h"
#include "prepared_lists.h"

static const qtri_rect nowhere = {0, 0, 0, 0};

/* The pixels that the vertices met span. */
static qtri_rect find_bounds(const qtri_prepared *prepared)
{
    if (prepared->mesh == NULL || !prepared->is_seen) {
        return nowhere;
    }
    if (prepared->is_anywhere) {
        const qtri_rect frame = {0, 0, prepared->width, prepared->height};
        return frame;
    }
    qtri_rect extent = prepared->extent_24p8; /* of those that have no slot */
    if (qtri_prepared_is_complete(prepared)) {
        for (uint32_t i = 0; i < prepared->mesh->vertex_count; i++) {
            if (prepared->vertices[i].depth_16p8 != QTRI_VERTEX_EMPTY &&
                prepared->vertices[i].intensity_q15 != QTRI_VERTEX_UNLIT) {
                qtri_prepared_widen(&extent, &prepared->vertices[i]);
            }
        }
    }
    if (extent.x0 > extent.x1) {
        return nowhere;
    }
    extent.x0 = (extent.x0 + qtri_prepared_before_24p8(prepared->is_solid)) >> 8;
    extent.y0 = (extent.y0 + qtri_prepared_before_24p8(prepared->is_solid)) >> 8;
    extent.x1 = (extent.x1 + qtri_prepared_after_24p8(prepared->is_solid)) >> 8;
    extent.y1 = (extent.y1 + qtri_prepared_after_24p8(prepared->is_solid)) >> 8;
    return extent;
}

void qtri_prepared_mark(qtri_prepared *prepared, qtri_frame *frame)
{
    QTRI_ASSERT(prepared != NULL && frame != NULL);
    QTRI_CHECK(qtri_check_prepared(prepared));
    qtri_frame_mark(frame, &prepared->marked);
    prepared->marked = find_bounds(prepared);
    qtri_frame_mark(frame, &prepared->marked);
}
