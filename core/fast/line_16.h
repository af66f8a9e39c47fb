/* SPDX-License-Identifier: MIT */
/*
 * Lines on pixels of 16 bits. Internal.
 */
#ifndef QTRI_FAST_LINE_16_H
#define QTRI_FAST_LINE_16_H

#include "../raster/line.h"

/* Lets the job draw by the loops of line_16.c if they serve. */
void qtri_line_16_choose(qtri_line_job *job);

#endif
