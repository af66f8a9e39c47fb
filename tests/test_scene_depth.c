/* SPDX-License-Identifier: MIT */
/*
 * Sheets of paper far away: which format of depth tells them apart, against the double-precision
 * reference. These are figures of qtri/depth.h.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "reference/reference.h"
#include "tools/scene_draw.h"

enum { SUBPIXEL_BITS = 8 };

static struct scene read_scene(void)
{
    struct scene scene;
    struct text_error error;
    if (!scene_read("host/scenes/12-depth-linear16.scene", &scene, &error)) {
        fail_msg("%s", error.message);
    }
    return scene;
}

/* Pixels that show another triangle than the reference, in percent of what it covers. */
static double wrong_percent(const struct picture *picture, const struct reference_image *image)
{
    const size_t count = (size_t)picture->width * (size_t)picture->height;
    int covered = 0;
    int wrong = 0;
    for (size_t i = 0; i < count; i++) {
        covered += image->id[i] != 0;
        wrong += image->id[i] != picture->id[i];
    }
    assert_true(covered > 30000);
    return 100.0 * wrong / covered;
}

static void sheets_of_paper(void **state)
{
    (void)state;
    static const double most[] = {50, .02, .02, .02};
    struct scene scene = read_scene();
    struct reference_image exact;
    scene.depth_format = SCENE_LINEAR32;
    assert_true(reference_render(&scene, SUBPIXEL_BITS, &exact));
    for (int format = SCENE_LINEAR16; format <= SCENE_LINEAR32; format++) {
        struct picture picture;
        struct reference_image same;
        scene.depth_format = (enum scene_depth_format)format;
        assert_true(scene_render(&scene, &qtri_xrgb8888, 50, true, &picture));
        assert_true(reference_render(&scene, SUBPIXEL_BITS, &same));
        const double wrong = wrong_percent(&picture, &exact);
        print_message("format %d: %.3f %% wrong, %.3f %% in its own steps\n", format, wrong,
                      wrong_percent(&picture, &same));
        assert_true(wrong <= most[format]);
        assert_true(format != SCENE_LINEAR16 || wrong > 40);
        assert_true(wrong_percent(&picture, &same) <= (format == SCENE_LINEAR16 ? .4 : .02));
        picture_free(&picture);
        reference_free(&same);
    }
    reference_free(&exact);
    scene_free(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sheets_of_paper),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
