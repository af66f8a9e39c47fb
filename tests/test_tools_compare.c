/* SPDX-License-Identifier: MIT */
/*
 * The comparison of two pictures, and the command around it.
 */
#define _POSIX_C_SOURCE 200809L /* dup, dup2 */

#include "support/test.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "tools/commands.h"
#include "tools/compare.h"

enum { WIDTH = 20, HEIGHT = 10, PIXELS = WIDTH * HEIGHT };

static void make_pair(struct picture pair[2], bool with_dump)
{
    for (int p = 0; p < 2; p++) {
        assert_true(picture_create(&pair[p], WIDTH, HEIGHT, with_dump));
        for (int i = 0; i < 3 * PIXELS; i++)
            pair[p].rgb[i] = (uint8_t)(i * 7);
        for (int i = 0; i < PIXELS && with_dump; i++) {
            pair[p].id[i] = (uint32_t)(i % 3);
            pair[p].depth[i] = 0.5;
        }
    }
}

static void free_pair(struct picture pair[2])
{
    picture_free(&pair[0]);
    picture_free(&pair[1]);
}

TEST(equal_pictures)
{
    struct picture pair[2];
    struct comparison c;

    make_pair(pair, true);
    compare_pictures(&pair[0], &pair[1], &c);
    assert_true(c.same_size && c.has_id && c.has_depth);
    assert_int_equal(c.pixels, PIXELS);
    assert_int_equal(c.differing, 0);
    assert_int_equal(c.max_color_error, 0);
    assert_true(c.mean_color_error == 0.0);
    assert_true(isinf(c.psnr) && c.psnr > 0);
    assert_int_equal(c.covered[0], 133);
    assert_int_equal(c.coverage_mismatches, 0);
    assert_int_equal(c.other_triangle, 0);
    assert_int_equal(c.depth_pixels, PIXELS);
    assert_true(c.max_depth_error == 0.0 && c.mean_depth_error == 0.0);
    assert_true(c.p999_depth_error == 0.0);
    free_pair(pair);
}

TEST(color_errors)
{
    struct picture pair[2];
    struct comparison c;

    make_pair(pair, false);
    memset(pair[0].rgb, 100, 3 * PIXELS);
    memset(pair[1].rgb, 100, 3 * PIXELS);
    pair[1].rgb[0] = 103; /* pixel 0: 3 */
    pair[1].rgb[7] = 96;  /* pixel 2: 4 and 1 */
    pair[1].rgb[8] = 101;
    pair[0].rgb[599] = 255; /* the last pixel: 255 */
    pair[1].rgb[599] = 0;
    compare_pictures(&pair[0], &pair[1], &c);
    assert_int_equal(c.differing, 3);
    assert_int_equal(c.max_color_error, 255);
    assert_int_equal(c.pixels_with_error[0], PIXELS - 3);
    assert_int_equal(c.pixels_with_error[3], 1);
    assert_int_equal(c.pixels_with_error[4], 1);
    assert_int_equal(c.pixels_with_error[255], 1);
    assert_int_equal(compare_pixels_above(&c, 0), 3);
    assert_int_equal(compare_pixels_above(&c, 3), 2);
    assert_int_equal(compare_pixels_above(&c, 4), 1);
    assert_int_equal(compare_pixels_above(&c, 255), 0);
    assert_true(fabs(c.mean_color_error - (3 + 4 + 1 + 255) / 600.0) < 1e-12);
    double mean_square = (9 + 16 + 1 + 255.0 * 255.0) / 600.0;
    assert_true(fabs(c.psnr - 10 * log10(255.0 * 255.0 / mean_square)) < 1e-9);
    assert_false(c.has_id || c.has_depth);
    free_pair(pair);
}

TEST(coverage_and_triangles)
{
    struct picture pair[2];
    struct comparison c;

    make_pair(pair, true);
    pair[0].id[1] = 0; /* was 1 */
    pair[1].id[3] = 9; /* was 0 */
    pair[1].id[6] = 9; /* was 0 */
    pair[1].id[4] = 9; /* was 1 */
    compare_pictures(&pair[0], &pair[1], &c);
    assert_int_equal(c.coverage_mismatches, 3);
    assert_int_equal(c.other_triangle, 1);
    assert_int_equal(c.covered[0], 132);
    assert_int_equal(c.covered[1], 135);
    assert_int_equal(c.depth_pixels, PIXELS - 4);
    free_pair(pair);
}

/* Depth errors 0, 1, .. of all pixels, shuffled; ones between different triangles do not count. */
TEST(depth_errors)
{
    struct picture pair[2];
    struct comparison c;

    make_pair(pair, true);
    for (int i = 0; i < PIXELS; i++)
        pair[1].depth[i] = 0.5 + (i % 2 ? 1 : -1) * (i * 77 % PIXELS) / 65535.0;
    compare_pictures(&pair[0], &pair[1], &c);
    assert_true(fabs(c.max_depth_error - (PIXELS - 1)) < 1e-6);
    assert_true(fabs(c.mean_depth_error - (PIXELS - 1) / 2.0) < 1e-6);
    assert_true(fabs(c.p999_depth_error - (PIXELS - 1)) < 1e-6); /* .1 % of 200 is no pixel */
    pair[0].id[5] = 77;
    pair[1].depth[5] = 1;
    compare_pictures(&pair[0], &pair[1], &c);
    assert_true(c.max_depth_error < PIXELS);
    pair[1].depth[6] = NAN;
    compare_pictures(&pair[0], &pair[1], &c);
    assert_true(isinf(c.max_depth_error));
    free_pair(pair);
}

TEST(depth_percentile_of_many)
{
    struct picture pair[2];
    struct comparison c;

    for (int p = 0; p < 2; p++)
        assert_true(picture_create(&pair[p], 100, 50, true));
    for (int i = 0; i < 5000; i++)
        pair[1].depth[i] = (i * 3 % 5000) / 65535.0;
    compare_pictures(&pair[0], &pair[1], &c);
    /* five of 5000 may lie above: 4995 .. 4999 */
    assert_true(fabs(c.p999_depth_error - 4994) < 1e-6);
    free_pair(pair);
}

TEST(different_sizes)
{
    struct picture pair[2], out;
    struct comparison c;

    assert_true(picture_create(&pair[0], 4, 6, false));
    assert_true(picture_create(&pair[1], 6, 4, false));
    compare_pictures(&pair[0], &pair[1], &c);
    assert_false(c.same_size);
    assert_int_equal(c.width[1], 6);
    assert_false(compare_difference(&pair[0], &pair[1], &out));
    free_pair(pair);
}

TEST(difference_pictures)
{
    struct picture pair[2], out;
    static const uint8_t expected[4][3] = {
        {255, 0, 0},   /* covered in one only */
        {44, 44, 44},  /* equal, luma 100 */
        {64, 112, 64}, /* 3 more green */
        {255, 64, 64}, /* 100 less red */
    };

    make_pair(pair, true);
    memset(pair[0].rgb, 100, 3 * PIXELS);
    memset(pair[1].rgb, 100, 3 * PIXELS);
    pair[0].id[0] = 0;
    pair[1].id[0] = 5;
    pair[1].rgb[3 * 2 + 1] = 103;
    pair[1].rgb[3 * 3] = 0;
    assert_true(compare_difference(&pair[0], &pair[1], &out));
    assert_memory_equal(out.rgb, expected, sizeof expected);
    picture_free(&out);
    free_pair(pair);
}

/* ---- The command ---- */

static char path[4][512]; /* a.ppm, b.ppm, difference.ppm, and what the command printed */
static char printed[2048];

static int set_up_paths(void **state)
{
    (void)state;
    const char *directory = getenv("QTRI_TMP");
    const char *const name[4] = {"a", "b", "difference", "printed"};

    for (int i = 0; i < 4; i++)
        snprintf(path[i], sizeof path[i], "%s/test_compare_%s.ppm", directory ? directory : "/tmp",
                 name[i]);
    return 0;
}

static void prefix_of(const char *ppm, char prefix[512])
{
    snprintf(prefix, 512, "%.*s", (int)(strlen(ppm) - 4), ppm);
}

static void remove_files(void)
{
    for (int i = 0; i < 4; i++) {
        char prefix[512], dump[520];
        prefix_of(path[i], prefix);
        remove(path[i]);
        snprintf(dump, sizeof dump, "%s.id", prefix);
        remove(dump);
        snprintf(dump, sizeof dump, "%s.depth", prefix);
        remove(dump);
    }
}

static void write_pair(struct picture pair[2], bool with_dump)
{
    struct text_error error;

    remove_files();
    for (int i = 0; i < 2; i++) {
        char prefix[512];
        prefix_of(path[i], prefix);
        assert_true(picture_write_ppm(path[i], &pair[i], &error));
        if (with_dump)
            assert_true(picture_write_dump(prefix, &pair[i], &error));
    }
}

/* `qtri compare` with its output, both streams, in `printed`. */
static int run_captured(int argc, char **argv)
{
    fflush(stdout);
    fflush(stderr);
    int old_stdout = dup(1), old_stderr = dup(2);
    FILE *file = fopen(path[3], "wb+");
    assert_non_null(file);
    assert_true(dup2(fileno(file), 1) == 1 && dup2(fileno(file), 2) == 2);
    int status = options_run(&compare_command, argc, argv);
    fflush(stdout);
    fflush(stderr);
    assert_true(dup2(old_stdout, 1) == 1 && dup2(old_stderr, 2) == 2);
    close(old_stdout);
    close(old_stderr);
    rewind(file);
    printed[fread(printed, 1, sizeof printed - 1, file)] = '\0';
    fclose(file);
    remove(path[3]);
    return status;
}

/* Runs `qtri compare` with up to six words. */
static int run(const char *w1, const char *w2, const char *w3, const char *w4, const char *w5,
               const char *w6)
{
    const char *const words[] = {"compare", w1, w2, w3, w4, w5, w6};
    char storage[7][512];
    char *argv[8] = {NULL};
    int argc = 0;

    for (int i = 0; i < 7 && words[i]; i++) {
        snprintf(storage[i], sizeof storage[i], "%s", words[i]);
        argv[argc++] = storage[i];
    }
    return run_captured(argc, argv);
}

static void assert_printed(const char *text)
{
    if (!strstr(printed, text))
        fail_msg("\"%s\" is missing in:\n%s", text, printed);
}

TEST(command_judges_colors)
{
    struct picture pair[2];

    make_pair(pair, false);
    write_pair(pair, false);
    assert_int_equal(run(path[0], path[1], NULL, NULL, NULL, NULL), 0);
    assert_printed("size                 20x10\n");
    assert_printed("psnr-db              inf\n");
    assert_null(strstr(printed, "coverage"));
    assert_null(strstr(printed, "depth"));
    assert_int_equal(run(path[0], path[0], NULL, NULL, NULL, NULL), 0);
    pair[1].rgb[30] = (uint8_t)(pair[1].rgb[30] + 5);
    write_pair(pair, false);
    assert_int_equal(run(path[0], path[1], NULL, NULL, NULL, NULL), 1);
    assert_printed("pixels-differing     1\ncolor-max            5\n");
    assert_int_equal(run("--max-color", "4", path[0], path[1], NULL, NULL), 1);
    assert_int_equal(run("--max-color", "5", path[0], path[1], NULL, NULL), 0);
    assert_int_equal(run(path[0], "--max-pixels", "1", path[1], NULL, NULL), 0);
    assert_int_equal(run("--max-pixels", "0", "--max-color", "5", path[0], path[1]), 0);
    remove_files();
    free_pair(pair);
}

TEST(command_judges_dumps)
{
    struct picture pair[2];

    make_pair(pair, true);
    write_pair(pair, true);
    assert_int_equal(run(path[0], path[1], NULL, NULL, NULL, NULL), 0);
    pair[0].id[0] = 4;
    pair[0].depth[7] += 2.5 / 65535;
    write_pair(pair, true);
    assert_int_equal(run(path[0], path[1], NULL, NULL, NULL, NULL), 1);
    assert_printed("coverage-mismatches  1\n");
    assert_printed("depth-max            2.5\n");
    assert_int_equal(run("--max-coverage", "1", path[0], path[1], NULL, NULL), 1);
    assert_int_equal(run("--max-depth", "2.6", path[0], path[1], NULL, NULL), 1);
    assert_int_equal(run("--max-depth", "2.6", "--max-coverage", "1", path[0], path[1]), 0);
    assert_int_equal(run("--max-depth", "2.4", "--max-coverage", "1", path[0], path[1]), 1);
    remove_files();
    free_pair(pair);
}

TEST(command_writes_the_difference)
{
    struct picture pair[2], difference;
    struct text_error error;

    make_pair(pair, false);
    memset(pair[0].rgb, 100, 3 * PIXELS);
    memset(pair[1].rgb, 100, 3 * PIXELS);
    write_pair(pair, false);
    assert_int_equal(run("-o", path[2], path[0], path[1], NULL, NULL), 0);
    assert_true(picture_read_ppm(path[2], &difference, &error));
    assert_int_equal(difference.width, WIDTH);
    assert_int_equal(difference.rgb[0], 44);
    picture_free(&difference);
    assert_int_equal(run("-o", "/nonexistent/x.ppm", path[0], path[1], NULL, NULL), 1);
    remove_files();
    free_pair(pair);
}

TEST(command_refuses_bad_input)
{
    struct picture pair[2];

    make_pair(pair, true);
    write_pair(pair, true);
    assert_int_equal(run("--help", NULL, NULL, NULL, NULL, NULL), 0);
    assert_int_equal(run(NULL, NULL, NULL, NULL, NULL, NULL), 2);
    assert_int_equal(run(path[0], NULL, NULL, NULL, NULL, NULL), 2);
    assert_int_equal(run(path[0], path[0], path[0], NULL, NULL, NULL), 2);
    assert_int_equal(run(path[0], path[1], "--max-colour", "3", NULL, NULL), 2);
    assert_int_equal(run(path[0], path[1], "--max-color", NULL, NULL, NULL), 2);
    assert_int_equal(run(path[0], path[1], "--max-color", "3x", NULL, NULL), 2);
    assert_int_equal(run(path[0], path[1], "--max-color", "-3", NULL, NULL), 2);
    assert_int_equal(run(path[0], path[1], "--max-pixels", "1.5", NULL, NULL), 2);
    assert_int_equal(run(path[0], path[1], "--max-depth", "nan", NULL, NULL), 2);
    assert_int_equal(run(path[0], "/nonexistent/x.ppm", NULL, NULL, NULL, NULL), 1);
    assert_printed("/nonexistent/x.ppm");
    assert_int_equal(run("/nonexistent/x.ppm", path[0], NULL, NULL, NULL, NULL), 1);

    char prefix[512], dump[520]; /* a dump of another size */
    prefix_of(path[1], prefix);
    snprintf(dump, sizeof dump, "%s.id", prefix);
    FILE *file = fopen(dump, "wb");
    assert_non_null(file);
    fputs("short", file);
    fclose(file);
    assert_int_equal(run(path[0], path[1], NULL, NULL, NULL, NULL), 1);
    free_pair(pair);

    assert_true(picture_create(&pair[0], 4, 6, false));
    assert_true(picture_create(&pair[1], 6, 4, false));
    write_pair(pair, false);
    assert_int_equal(run(path[0], path[1], "--max-color", "255", NULL, NULL), 1);
    assert_printed("different sizes");
    remove_files();
    free_pair(pair);
}

int main(void)
{
    return run_all_tests(set_up_paths, NULL);
}
