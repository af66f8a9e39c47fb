/* SPDX-License-Identifier: MIT */
/*
 * Arbitrary bytes as a drawing: what fuzz_draw.c tries, and test_core_corpus.c records of the
 * inputs in tests/corpus.
 */
#ifndef QTRI_TESTS_SUPPORT_DRAW_BYTES_H
#define QTRI_TESTS_SUPPORT_DRAW_BYTES_H

#include <stddef.h>
#include <stdint.h>

#include <qtri/pipeline.h>

/* A checksum of the pixels and depths that these bytes draw by a list of pipelines, the same on
   every machine. */
uint32_t draw_bytes(const uint8_t *data, size_t size, const qtri_pipeline *const *pipelines);

#endif
