/* SPDX-License-Identifier: MIT */
/* Small triangles compiled for a core without long multiply and divide. */
#ifndef QTRI_TESTS_SUPPORT_SMALL_NARROW_H
#define QTRI_TESTS_SUPPORT_SMALL_NARROW_H

#include <qtri/body/small_triangle.h>

bool narrow_small_draw(struct qtri_small *triangle);

#endif
