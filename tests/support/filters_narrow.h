/* SPDX-License-Identifier: MIT */
#ifndef QTRI_TESTS_SUPPORT_FILTERS_NARROW_H
#define QTRI_TESTS_SUPPORT_FILTERS_NARROW_H

#include <qtri/antialias.h>

/* filter/fxaa.c without long multiply: the same pixels. */
enum qtri_error narrow_fxaa(const qtri_surface *surface, uint32_t *memory, uint32_t words);

#endif
