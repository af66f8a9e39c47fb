/*
 * Rows of transforms, to and from wide scalars. Internal.
 */
#ifndef QTRI_GEOMETRY_ROW_H
#define QTRI_GEOMETRY_ROW_H

#include "qtri/transform.h"

#include "../math/wide.h"

/* The row x y z t, block-normalised: the only place where a transform is rounded. */
void qtri_row_from_wide(qtri_row *row, const qtri_wide element[4]);

/* Element 0..3 of a row. */
qtri_wide qtri_row_element(const qtri_row *row, int column);

#endif
