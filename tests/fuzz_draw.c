/* SPDX-License-Identifier: MIT */
/*
 * Fuzz target: arbitrary bytes as a drawing (support/draw_bytes.c). Nothing may trap, overflow or
 * write outside the surface; `make fuzz` runs it under AddressSanitizer and UBSan.
 */
#include "support/draw_bytes.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    (void)draw_bytes(data, size);
    return 0;
}
