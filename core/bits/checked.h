/* SPDX-License-Identifier: MIT */
/*
 * What a checked build asks of arguments, see qtri/error.h. Without QTRI_CHECKED nothing is here to
 * be compiled, called or linked. Internal.
 */
#ifndef QTRI_BITS_CHECKED_H
#define QTRI_BITS_CHECKED_H

#include "qtri/error.h"

#ifdef QTRI_CHECKED
#define QTRI_CHECK(call) call
#else
#define QTRI_CHECK(call) ((void)0)
#endif

#endif
