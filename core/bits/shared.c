/* Defined whatever this file is compiled for: others may be compiled for size. */
#define QTRI_SHARE 1
#include "bits.h"

#define QTRI_SHARED
#include "shared.inc"
