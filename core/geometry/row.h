/*
 * Rows of transforms, to and from wide scalars. Internal.
 */
#ifndef QTRI_GEOMETRY_ROW_H
#define QTRI_GEOMETRY_ROW_H

#include "qtri/transform.h"

#include "../math/wide.h"

/* The row x y z t, block-normalised: the only place where a transform is rounded. */
void qtri_row_from_wide(qtri_row *row, const qtri_wide element[4]);

/*
 * The row with linear part `axis` that takes `point` to `image`: its translation is computed from
 * the rounded axis, or it would not cancel near `point`.
 */
void qtri_row_about(qtri_row *row, const qtri_wide axis[3], const qtri_wide point[3],
                    qtri_wide image);

/* Element 0..3 of a row. */
qtri_wide qtri_row_element(const qtri_row *row, int column);

#endif
