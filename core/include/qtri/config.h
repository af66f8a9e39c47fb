/* SPDX-License-Identifier: MIT */
/*
 * Options of the compiler's command line, -DQTRI_WITH_BROUGHT_PIPELINES=0: each is 1, the default,
 * or 0, left out to save code. An option never changes what is left in: it draws the same pixels to
 * the bit. What is left out has the one result that stands beside the option. What is chosen by a
 * description, as formats, filters and the stages of vertices (draw.h) are, needs none: it is
 * linked where it is named.
 */
#ifndef QTRI_CONFIG_H
#define QTRI_CONFIG_H

#include <limits.h>
#include <stdint.h>

/*
 * Drawing needs an int and a size_t of 32 bits. The mathematics and the transforms (q16.h, vec.h,
 * mat.h, quat.h, transform.h) do not, and give the same bits on an AVR or an MSP430.
 */
#if INT_MAX < 0x7FFFFFFF || SIZE_MAX < 0xFFFFFFFF
#error "qtri draws where int and size_t have 32 bits or more; here only its mathematics can be used"
#endif

/*
 * Pipelines for RGB565 that blends, fog, bilinear filters and formats of depth bring, and that draw
 * in place of the generic one (pipeline.h): some 1.5 KB each at -Os. Without: the generic one
 * draws, the same pixels at many times the cost. For applications whose lists name all that they
 * draw with.
 */
#ifndef QTRI_WITH_BROUGHT_PIPELINES
#define QTRI_WITH_BROUGHT_PIPELINES 1
#endif

#endif
