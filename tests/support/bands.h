/* SPDX-License-Identifier: MIT */
/*
 * A scene drawn in bands has the pixels of the whole frame.
 */
#ifndef QTRI_TESTS_SUPPORT_BANDS_H
#define QTRI_TESTS_SUPPORT_BANDS_H

#include <stdint.h>

#include "test.h"
#include "tools/scene_draw.h"

/* In bands of 1, 1 + step, ... rows, below 100. */
static inline void assert_same_in_bands(const struct scene *scene, const qtri_format *format,
                                        int32_t step)
{
    struct picture whole, banded;
    assert_true(scene_render(scene, format, 0, false, &whole));
    for (int32_t rows = 1; rows < 100; rows += step) {
        assert_true(scene_render(scene, format, rows, false, &banded));
        assert_memory_equal(whole.rgb, banded.rgb, 3 * (size_t)whole.width * (size_t)whole.height);
        picture_free(&banded);
    }
    picture_free(&whole);
}

#endif
