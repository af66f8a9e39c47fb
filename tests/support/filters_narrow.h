/* SPDX-License-Identifier: MIT */
#ifndef QTRI_TESTS_SUPPORT_FILTERS_NARROW_H
#define QTRI_TESTS_SUPPORT_FILTERS_NARROW_H

#include <qtri/filters.h>

/* filter/fxaa_565.c without long multiply: the same pixels. */
enum qtri_error narrow_fxaa_565(const qtri_surface *surface, uint32_t *memory, uint32_t words);

#endif
