/* SPDX-License-Identifier: MIT */
/* Defined whatever this file is compiled for: others may be compiled for size. In the amalgamation
   there are no others. */
#ifndef QTRI_AMALGAMATION
#define QTRI_SHARE 1
#endif
#include "bits.h"

#if QTRI_SHARE
#define QTRI_SHARED
#include "shared.inc"
#endif
