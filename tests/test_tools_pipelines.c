/* SPDX-License-Identifier: MIT */
/*
 * What `qtri pipelines` prints, compiled as it is (Makefile: PASTED): it draws the scenes alone,
 * and the same pixels.
 */
#include "support/core.h"
#include "tools/scene_draw.h"

extern const qtri_pipeline *const pasted_09_floor_mipmapped[];
extern const qtri_pipeline *const pasted_11_antialias_msaa[];
extern const qtri_pipeline *const pasted_11_light_pixel[];
extern const qtri_pipeline *const pasted_11_vertex_alpha[];
extern const qtri_pipeline *const pasted_12_fog[];

static const struct {
    const char *scene;
    const qtri_pipeline *const *pipelines;
    size_t count;
} cases[] = {
    {"host/scenes/09-floor-mipmapped.scene", pasted_09_floor_mipmapped, 1},
    {"host/scenes/11-antialias-msaa.scene", pasted_11_antialias_msaa, 1},
    {"host/scenes/11-light-pixel.scene", pasted_11_light_pixel, 1},
    {"host/scenes/11-vertex-alpha.scene", pasted_11_vertex_alpha, 2},
    {"host/scenes/12-fog.scene", pasted_12_fog, 2},
};

TEST(pasted_pipelines_draw_the_scene)
{
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const struct scene_pipelines by = {cases[i].pipelines, NULL};
        const qtri_pipeline *const none[] = {NULL};
        const struct scene_pipelines nothing = {none, NULL};
        struct scene scene;
        struct text_error error;
        struct picture expected, is, empty;
        assert_true(scene_read(cases[i].scene, &scene, &error));
        assert_true(scene_render(&scene, &qtri_rgb565, 0, false, &expected));
        assert_true(scene_render_by(&scene, &qtri_rgb565, &by, &is));
        assert_true(scene_render_by(&scene, &qtri_rgb565, &nothing, &empty));
        const size_t bytes = 3 * (size_t)expected.width * (size_t)expected.height;
        assert_memory_equal(is.rgb, expected.rgb, bytes);
        assert_memory_not_equal(empty.rgb, expected.rgb, bytes);
        size_t count = 0;
        while (cases[i].pipelines[count] != NULL) {
            count++;
        }
        assert_int_equal(count, cases[i].count);
        picture_free(&expected);
        picture_free(&is);
        picture_free(&empty);
        scene_free(&scene);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
