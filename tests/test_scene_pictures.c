/* SPDX-License-Identifier: MIT */
/*
 * Pictures are those that tests/pictures.tsv records: what a change of the core alters is seen,
 * and said in CHANGELOG.md. QTRI_RECORD=FILE writes the file anew (`make pictures`).
 *
 * They are of every file in host/scenes and of random scenes, a checksum for each file and each
 * ten seeds, over colours, depths and numbers of triangles.
 */
#define _POSIX_C_SOURCE 200809L

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support/scene_random.h"
#include "tools/scene_draw.h"

#define RECORDED        "tests/pictures.tsv"
#define NAME_MAX_LENGTH 64
#define SEEDS           10 /* with one checksum */

static const qtri_format *const formats[] = {&qtri_rgb565, &qtri_xrgb8888,       &qtri_gray8,
                                             &qtri_rgb888, &qtri_rgb565_swapped, &qtri_bgr888};
#define FORMATS (sizeof formats / sizeof formats[0])

/* FNV-1a of bytes in the order that every machine has. */
static uint32_t add(uint32_t hash, uint32_t value, int bytes)
{
    for (int i = 0; i < bytes; i++) {
        hash = (hash ^ (value >> 8 * i & 0xFF)) * 16777619u;
    }
    return hash;
}

static uint32_t add_picture(uint32_t hash, const struct picture *picture)
{
    size_t count = (size_t)picture->width * (size_t)picture->height;
    for (size_t i = 0; i < 3 * count; i++) {
        hash = add(hash, picture->rgb[i], 1);
    }
    for (size_t i = 0; i < count; i++) {
        hash = add(hash, picture->id[i], 4);
        hash = add(hash, (uint32_t)(picture->depth[i] * 65535.0 + .5), 4);
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

/* What is recorded of a name, 0: nothing. Or a line for the file that is written. */
static void judge(const char *name, uint32_t hash)
{
    const char *record = getenv("QTRI_RECORD");
    char line[2 * NAME_MAX_LENGTH];
    if (record != NULL) {
        FILE *out = fopen(record, "a");
        assert_non_null(out);
        fprintf(out, "%s\t%08x\n", name, (unsigned)hash);
        assert_int_equal(fclose(out), 0);
        return;
    }
    FILE *in = fopen(RECORDED, "r");
    assert_non_null(in);
    size_t length = strlen(name);
    unsigned recorded = 0;
    while (fgets(line, sizeof line, in) != NULL) {
        if (strncmp(line, name, length) == 0 && line[length] == '\t') {
            recorded = (unsigned)strtoul(line + length, NULL, 16);
        }
    }
    fclose(in);
    if (recorded != hash) {
        fail_msg("%s: %08x, recorded %08x (if it is meant to differ: make pictures)", name,
                 (unsigned)hash, recorded);
    }
}

static void files(void **state)
{
    (void)state;
    char line[2 * NAME_MAX_LENGTH];
    FILE *list = popen("cd host/scenes && ls *.scene", "r");
    assert_non_null(list);
    size_t count = 0;
    for (; fgets(line, sizeof line, list) != NULL; count++) {
        char path[3 * NAME_MAX_LENGTH];
        struct scene scene;
        struct text_error error;
        line[strcspn(line, "\n")] = '\0';
        snprintf(path, sizeof path, "host/scenes/%s", line);
        if (!scene_read(path, &scene, &error)) {
            fail_msg("%s", error.message);
        }
        const uint32_t hash = add_scene(2166136261u, &scene, 0);
        judge(line, add_scene(hash, &scene, 1 + count % (FORMATS - 1)));
        scene_free(&scene);
    }
    pclose(list);
    assert_in_range(count, 30, 1000);
}

static void random_scenes(const char *kind, char *(*write)(uint32_t seed, size_t *length),
                          uint32_t seeds)
{
    for (uint32_t first = 1; first < seeds; first += SEEDS) {
        char name[NAME_MAX_LENGTH];
        uint32_t hash = 2166136261u;
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
        judge(name, hash);
    }
}

static void plain(void **state)
{
    (void)state;
    random_scenes("random", scene_random, 200);
}

static void textured(void **state)
{
    (void)state;
    random_scenes("textured", scene_random_textured, 200);
}

static void mixed(void **state)
{
    (void)state;
    random_scenes("mixed", scene_random_mixed, 200);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(files),
        cmocka_unit_test(plain),
        cmocka_unit_test(textured),
        cmocka_unit_test(mixed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
