/* SPDX-License-Identifier: MIT */
#include "triangle.h"

#if !QTRI_LONG_MULTIPLY
int64_t qtri_triangle_area_long(const qtri_point *a, const qtri_point *b, const qtri_point *c)
{
    return qtri_mul_s32(b->x_24p8 - a->x_24p8, c->y_24p8 - a->y_24p8) -
           qtri_mul_s32(c->x_24p8 - a->x_24p8, b->y_24p8 - a->y_24p8);
}
#endif

#undef qtri_triangle_area /* for files that are compiled to be small */
int64_t qtri_triangle_area(const qtri_point *a, const qtri_point *b, const qtri_point *c)
{
    return qtri_triangle_area_in_place(a, b, c);
}
