/* SPDX-License-Identifier: MIT */
/*
 * What the window shows of a scene, without a window; and how well its model of instructions fits
 * the benchmark.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/test.h"
#include "tools/scene_cost.h"
#include "tools/scene_draw.h"
#include "tools/scene_view.h"

static const char floor_scene[] = "host/scenes/09-floor.scene";

static struct picture view_picture(const struct scene_view *view, const char *path,
                                   struct scene_figures *figures)
{
    struct picture picture = {0};
    struct text_error error;
    assert_true(scene_view_draw(view, path, &picture, figures, &error));
    return picture;
}

static bool same(const struct picture *a, const struct picture *b)
{
    assert_int_equal(a->width, b->width);
    assert_int_equal(a->height, b->height);
    return memcmp(a->rgb, b->rgb, 3 * (size_t)a->width * (size_t)a->height) == 0;
}

/* Presses keys and says whether the picture is that of no key. */
static bool keys_show_the_same(const char *keys, const char *path)
{
    struct scene_view plain = {.format = 1}, view = plain;
    struct scene_figures figures;
    for (; *keys != '\0'; keys++) {
        assert_int_equal(scene_view_key(&view, *keys), 1);
    }
    struct picture first = view_picture(&plain, path, &figures);
    struct picture second = view_picture(&view, path, &figures);
    const bool equal = same(&first, &second);
    picture_free(&first);
    picture_free(&second);
    return equal;
}

TEST(shows_what_render_draws)
{
    const struct scene_view view = {.format = 1};
    struct scene_figures figures;
    struct scene scene;
    struct text_error error;
    struct picture expected = {0};
    struct picture picture = view_picture(&view, floor_scene, &figures);
    assert_true(scene_read(floor_scene, &scene, &error));
    assert_true(scene_render(&scene, &qtri_rgb565, 0, false, &expected));
    assert_true(same(&picture, &expected));
    assert_int_equal(figures.pixels, 45332); /* as `qtri demo` prints */
    assert_int_equal(figures.triangles, scene.triangle_count);
    assert_int_equal(figures.band_bytes, QTRI_BAND_BYTES(320, 240, QTRI_RGB565_BYTES));
    scene_free(&scene);
    picture_free(&picture);
    picture_free(&expected);
}

TEST(keys_switch_and_switch_back)
{
    assert_true(keys_show_the_same("b", floor_scene)); /* bands have the same pixels */
    assert_true(keys_show_the_same("mmm", floor_scene));
    assert_true(keys_show_the_same("fff", floor_scene));
    assert_true(keys_show_the_same("ww", floor_scene));
    assert_true(keys_show_the_same("aaaaaaa", floor_scene));
    assert_true(keys_show_the_same("mbwall..r", floor_scene));
    assert_true(keys_show_the_same(".,", "host/scenes/06-animation.scene"));
    static const char *const others[] = {"m", "mm", "f", "w", "aaa", NULL};
    for (int i = 0; others[i] != NULL; i++) {
        assert_false(keys_show_the_same(others[i], floor_scene));
    }
    assert_false(keys_show_the_same("..........", "host/scenes/06-animation.scene"));
    struct scene_view view = {0};
    assert_int_equal(scene_view_key(&view, 'x'), 0);
}

/* From in front to the right side, and from above: what a camera there sees. */
TEST(cameras_turn)
{
    static const char body[] = "mode modelview\n%s\ntri -1 -1 0 1 1 0 0  1 -.5 .3 1 0 1 0  "
                               "0 1 -.8 1 0 0 1\n";
    static const struct {
        const char *camera, *there;
        int azimuth, elevation;
    } cases[] = {
        {"lookat 0 0 4  0 0 0  0 1 0", "lookat 4 0 0  0 0 0  0 1 0", 90, 0},
        {"lookat 0 0 4  0 0 0  0 2 0", "lookat 0 2 3.4641016  0 0 0  0 1 0", 0, 30},
        {"orbit 0 0 0  4  10 20", "orbit 0 0 0  4  15 15", 5, -5},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char path[] = "/tmp/qtri_view_XXXXXX";
        struct picture pictures[2];
        for (int k = 0; k < 2; k++) {
            struct scene_figures figures;
            const struct scene_view view = {.azimuth = k == 0 ? cases[i].azimuth : 0,
                                            .elevation = k == 0 ? cases[i].elevation : 0};
            snprintf(path, sizeof path, "/tmp/qtri_view_%d", (int)i);
            FILE *file = fopen(path, "w");
            assert_non_null(file);
            fprintf(file, "viewport 64 48\nmode projection\nperspective 60 1.3333333 .1 100\n");
            fprintf(file, body, k == 0 ? cases[i].camera : cases[i].there); /* NOLINT */
            fclose(file);
            pictures[k] = view_picture(&view, path, &figures);
            assert_true(figures.can_turn);
            assert_true(figures.pixels > 40);
            remove(path);
        }
        int different = 0;
        for (int n = 0; n < 3 * 64 * 48; n++) {
            different += abs(pictures[0].rgb[n] - pictures[1].rgb[n]) > 8;
        }
        assert_true(different <= 6); /* the eye is rounded */
        picture_free(&pictures[0]);
        picture_free(&pictures[1]);
    }
}

TEST(bad_scenes_are_told)
{
    const struct scene_view view = {0};
    struct picture picture = {0};
    struct scene_figures figures;
    struct text_error error;
    assert_false(scene_view_draw(&view, "no/such.scene", &picture, &figures, &error));
    assert_non_null(strstr(error.message, "no/such.scene"));
}

/* Of a table with a line a scene and a column a core; its head names the cores. */
static double budget_of(const char *scene, const char *core)
{
    char line[400];
    double budget = 0;
    int column = 0;
    FILE *file = fopen("host/bench/budgets.tsv", "r");
    assert_non_null(file);
    while (fgets(line, sizeof line, file) != NULL) {
        const char *name = strtok(line, "\t\n");
        const bool is_head = strcmp(name, "what") == 0;
        const char *cell = strtok(NULL, "\t\n");
        for (int i = 1; cell != NULL; i++, cell = strtok(NULL, "\t\n")) {
            column = is_head && strcmp(cell, core) == 0 ? i : column;
            budget = strcmp(name, scene) == 0 && i == column ? strtod(cell, NULL) : budget;
        }
    }
    fclose(file);
    return budget;
}

/* The benchmark's scenes, with the triangles and pixels that `make bench` prints. */
TEST(cost_fits_the_benchmark)
{
    static const struct {
        const char *name;
        enum scene_kind kind;
        int triangles, pixels, rows;
        enum scene_pixels format;
        enum scene_depth_format depth;
        bool is_blended;
    } scenes[] = {
        {"S1", SCENE_KIND_FLAT, 2, 76800, .rows = 0},
        {"S5", SCENE_KIND_FLAT, 6320, 15296, .rows = 0},
        {"S5k", SCENE_KIND_FLAT, 5760, 30520, .rows = 0},
        {"S2", SCENE_KIND_SMOOTH, 2, 76800, .rows = 0},
        {"S4", SCENE_KIND_SMOOTH, 5856, 12414, .rows = 0},
        {"S4k", SCENE_KIND_SMOOTH, 5760, 30520, .rows = 0},
        {"S12", SCENE_KIND_SMOOTH, 96, 35132, .rows = 0},
        {"S12b", SCENE_KIND_SMOOTH, 216, 38484, .rows = 0},
        {"S12c", SCENE_KIND_SMOOTH, 384, 39368, .rows = 0},
        {"S12d", SCENE_KIND_SMOOTH, 864, 40308, .rows = 0},
        {"S3", SCENE_KIND_TEXTURED, 2, 53290, .rows = 0},
        {"S11", SCENE_KIND_TEXTURED, 2, 45956, .rows = 0},
        {"S6", SCENE_KIND_TEXTURED, 5856, 12414, .rows = 0},
        {"S6k", SCENE_KIND_TEXTURED, 5760, 30520, .rows = 0},
        {"S8", SCENE_KIND_TEXTURED, 256, 74236, .rows = 0},
        {"S8w", SCENE_KIND_TEXTURED, 256, 74236, .rows = 0},
        {"S13a", SCENE_KIND_TEXTURED, 96, 35132, .rows = 0},
        {"S13b", SCENE_KIND_TEXTURED, 216, 38484, .rows = 0},
        {"S13", SCENE_KIND_TEXTURED, 384, 39368, .rows = 0},
        {"S13d", SCENE_KIND_TEXTURED, 864, 40308, .rows = 0},
        {"S7", SCENE_KIND_LINES, 5856, 7917, .rows = 0},
        {"S7k", SCENE_KIND_LINES, 5760, 15924, .rows = 0},
        {"S4b", SCENE_KIND_SMOOTH, 5856, 12414, .rows = 16},
        {"S4kb", SCENE_KIND_SMOOTH, 5760, 30520, .rows = 16},
        {"S5b", SCENE_KIND_FLAT, 6320, 15296, .rows = 16},
        {"S6b", SCENE_KIND_TEXTURED, 5856, 12414, .rows = 16},
        {"S7b", SCENE_KIND_LINES, 5856, 7917, .rows = 16},
        {"S4kg", SCENE_KIND_SMOOTH, 5760, 30520, .format = SCENE_GRAY8},
        {"S7g", SCENE_KIND_LINES, 5856, 7917, .format = SCENE_GRAY8},
        {"D1", SCENE_KIND_FLAT, 2, 76800, .depth = SCENE_FLOAT16},
        {"D2", SCENE_KIND_SMOOTH, 2, 76800, .depth = SCENE_FLOAT16},
        {"D3", SCENE_KIND_TEXTURED, 2, 53290, .depth = SCENE_FLOAT16},
        {"D6", SCENE_KIND_TEXTURED, 5856, 12414, .depth = SCENE_FLOAT16},
        {"B1", SCENE_KIND_FLAT, 2, 76800, .is_blended = true},
        {"B2", SCENE_KIND_SMOOTH, 2, 76800, .is_blended = true},
        {"B4", SCENE_KIND_SMOOTH, 5856, 12414, .is_blended = true},
        {"B7", SCENE_KIND_TEXTURED, 5856, 12414, .is_blended = true},
    };
    for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; i++) {
        const struct scene_load load = {.kind = scenes[i].kind,
                                        .format = scenes[i].format,
                                        .depth = scenes[i].depth,
                                        .is_blended = scenes[i].is_blended,
                                        .rows = scenes[i].rows,
                                        .triangles = scenes[i].triangles,
                                        .pixels = scenes[i].pixels};
        const struct scene_cost cost = scene_cost(&load);
        const double ratios[2] = {cost.m0plus / budget_of(scenes[i].name, "cortex-m0plus"),
                                  cost.m3 / budget_of(scenes[i].name, "cortex-m3")};
        for (int core = 0; core < 2; core++) {
            if (!(ratios[core] >= 1 - cost.error / 100.0 &&
                  ratios[core] <= 1 + cost.error / 100.0)) {
                fail_msg("%s: %.2f times what the benchmark counts, more than %d %% off",
                         scenes[i].name, ratios[core], cost.error);
            }
        }
    }
    const struct scene_load nothing = {.screen = 76800};
    const struct scene_cost cleared = scene_cost(&nothing);
    assert_true(cleared.m3 > 25000 && cleared.m3 < 35000);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
