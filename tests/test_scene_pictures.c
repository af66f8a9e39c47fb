/* SPDX-License-Identifier: MIT */
/*
 * Pictures are those that tests/pictures.tsv records: what a change of the core alters is seen,
 * and said in CHANGELOG.md. QTRI_RECORD=FILE writes the file anew (`make pictures`).
 *
 * They are of every file in host/scenes and of random scenes, a checksum for each file and each
 * ten seeds, over colours, depths and numbers of triangles.
 */
#define _POSIX_C_SOURCE 200809L

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/test.h"
#include "support/recorded.h"
#include "support/scene_random.h"
#include "tools/scene_draw.h"

#define SEEDS 10 /* with one checksum */

static const qtri_format *const formats[] = {&qtri_rgb565, &qtri_xrgb8888,       &qtri_gray8,
                                             &qtri_rgb888, &qtri_rgb565_swapped, &qtri_bgr888};
#define FORMATS (sizeof formats / sizeof formats[0])

static uint32_t add_picture(uint32_t hash, const struct picture *picture)
{
    size_t count = (size_t)picture->width * (size_t)picture->height;
    for (size_t i = 0; i < 3 * count; i++) {
        hash = recorded_add(hash, picture->rgb[i], 1);
    }
    for (size_t i = 0; i < count; i++) {
        hash = recorded_add(hash, picture->id[i], 4);
        hash = recorded_add(hash, (uint32_t)(picture->depth[i] * 65535.0 + .5), 4);
    }
    return hash;
}

static uint32_t add_scene(uint32_t hash, const struct scene *scene, size_t format)
{
    struct picture picture;
    assert_true(scene_render(scene, formats[format % FORMATS], 0, true, &picture));
    hash = add_picture(hash, &picture);
    picture_free(&picture);
    return hash;
}

TEST(files)
{
    char line[2 * RECORDED_NAME_MAX];
    FILE *list = popen("cd host/scenes && ls *.scene", "r");
    assert_non_null(list);
    size_t count = 0;
    for (; fgets(line, sizeof line, list) != NULL; count++) {
        char path[3 * RECORDED_NAME_MAX];
        struct scene scene;
        struct text_error error;
        line[strcspn(line, "\n")] = '\0';
        snprintf(path, sizeof path, "host/scenes/%s", line);
        if (!scene_read(path, &scene, &error)) {
            fail_msg("%s", error.message);
        }
        const uint32_t hash = add_scene(RECORDED_BEGIN, &scene, 0);
        recorded_judge(line, add_scene(hash, &scene, 1 + count % (FORMATS - 1)));
        scene_free(&scene);
    }
    pclose(list);
    assert_in_range(count, 30, 1000);
}

static void random_scenes(const char *kind, char *(*write)(uint32_t seed, size_t *length),
                          uint32_t seeds)
{
    for (uint32_t first = 1; first < seeds; first += SEEDS) {
        char name[RECORDED_NAME_MAX];
        uint32_t hash = RECORDED_BEGIN;
        for (uint32_t seed = first; seed < first + SEEDS; seed++) {
            size_t length = 0;
            struct scene scene;
            struct text_error error;
            char *text = write(seed, &length);
            if (!scene_parse("random", text, length, &scene, &error)) {
                fail_msg("seed %u: %s", (unsigned)seed, error.message);
            }
            hash = add_scene(hash, &scene, seed);
            scene_free(&scene);
            free(text);
        }
        snprintf(name, sizeof name, "%s %u", kind, (unsigned)first);
        recorded_judge(name, hash);
    }
}

TEST(plain)
{
    random_scenes("random", scene_random, 200);
}

TEST(textured)
{
    random_scenes("textured", scene_random_textured, 200);
}

TEST(mixed)
{
    random_scenes("mixed", scene_random_mixed, 200);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
