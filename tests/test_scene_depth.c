/* SPDX-License-Identifier: MIT */
/*
 * Sheets of paper far away: which format of depth tells them apart, against the double-precision
 * reference. These are figures of qtri/format.h.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/test.h"
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

TEST(sheets_of_paper)
{
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

enum { SHEETS = 12, TEXT_MAX = 4096 };

/* Those sheets, at `distance`, `apart` from each other. */
static void write_sheets(char text[TEXT_MAX], double distance, double apart)
{
    static const double corner[6][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};
    int length = snprintf(text, TEXT_MAX,
                          "viewport 320 240\ndepth less\nmode projection\n"
                          "perspective 40 1.33333333 .1 1000\nmode modelview\n"
                          "lookat 0 0 %.4f  0 0 0  0 1 0\nrotate -40 1 0 0\nrotate 25 0 1 0\n",
                          distance);
    for (int i = 0; i < SHEETS; i++) {
        const double half = (10 - .8 * i) * distance / 30;
        length +=
            snprintf(text + length, (size_t)(TEXT_MAX - length), "push\nrotate %d 0 0 1\n", 7 * i);
        for (int k = 0; k < 6; k++) {
            length +=
                snprintf(text + length, (size_t)(TEXT_MAX - length), "%s %.5f %.5f %.5f 1 1 1 1%s",
                         k % 3 == 0 ? "tri" : "", half * corner[k][0], half * corner[k][1],
                         apart * i, k % 3 == 2 ? "\n" : "");
        }
        length += snprintf(text + length, (size_t)(TEXT_MAX - length), "pop\n");
    }
}

/* Far away linear32 tells apart what linear24 does not. */
TEST(sheets_far_away)
{
    static const struct {
        double distance, apart;
        double most[2]; /* wrong with linear24 and linear32, percent */
    } rows[] = {{30, .001, {.02, .02}}, {30, .0005, {5.2, 1.5}}, {30, .0002, {40, 10.5}},
                {100, .01, {.02, .02}}, {100, .005, {7.5, 1.0}}, {100, .002, {44, 12.5}}};
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
        char text[TEXT_MAX];
        double wrong[2];
        struct scene scene;
        struct text_error error;
        write_sheets(text, rows[n].distance, rows[n].apart);
        if (!scene_parse("sheets", text, strlen(text), &scene, &error)) {
            fail_msg("%s", error.message);
        }
        struct reference_image exact;
        scene.depth_format = SCENE_LINEAR32;
        assert_true(reference_render(&scene, SUBPIXEL_BITS, &exact));
        for (int i = 0; i < 2; i++) {
            struct picture picture;
            scene.depth_format = i == 0 ? SCENE_LINEAR24 : SCENE_LINEAR32;
            assert_true(scene_render(&scene, &qtri_xrgb8888, 50, true, &picture));
            wrong[i] = wrong_percent(&picture, &exact);
            picture_free(&picture);
        }
        print_message("%.0f away, %.4f apart: %.3f, linear32 %.3f %% wrong\n", rows[n].distance,
                      rows[n].apart, wrong[0], wrong[1]);
        assert_true(wrong[0] <= rows[n].most[0] && wrong[1] <= rows[n].most[1]);
        assert_true(wrong[0] < 1 || wrong[1] < wrong[0] / 3);
        reference_free(&exact);
        scene_free(&scene);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
