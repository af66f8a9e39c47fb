/* SPDX-License-Identifier: MIT */
/*
 * The double-precision reference on the benchmark scenes: pixels and fragments must be the counts
 * every renderer of these scenes is measured against.
 */
#include "support/reference.h"

#define CAMERA                                                                                     \
    "viewport 320 240\nclear .094 .125 .188\ndepth less\n"                                         \
    "mode projection\nperspective 60 1.33333333 .1 100\n"                                          \
    "mode modelview\nlookat 0 0 3  0 0 0  0 1 0\n"
#define LIGHT "light .4 .6 .69282032 .2 .8\ncull back\n"

static void assert_counts(const char *text, int covered, int fragments)
{
    struct reference_image image = render(text, 0);
    int hits = 0;

    for (int i = 0; i < image.width * image.height; i++)
        hits += (int)image.hits[i];
    assert_int_equal(count_covered(&image), covered);
    assert_int_equal(hits, fragments);
    reference_free(&image);
}

TEST(full_screen_quad)
{
    assert_counts(CAMERA "tri -2.3070917 -1.7303188 0 1 1 0 0  2.3070917 -1.7303188 0 1 0 1 0  "
                         "2.3070917 1.7303188 0 1 0 0 1\n"
                         "tri -2.3070917 -1.7303188 0 1 1 0 0  2.3070917 1.7303188 0 1 0 0 1  "
                         "-2.3070917 1.7303188 0 1 1 1 0\n",
                  76800, 76800);
}

TEST(floor_in_perspective)
{
    assert_counts(CAMERA "tri -3 -1.2 2.078461 1 1 1 1  3 -1.2 2.078461 1 1 1 1  "
                         "3 1.2 -2.078461 1 1 1 1\n"
                         "tri -3 -1.2 2.078461 1 1 1 1  3 1.2 -2.078461 1 1 1 1  "
                         "-3 1.2 -2.078461 1 1 1 1\n",
                  53290, 53290);
}

/* Draws a model of the folder QTRI_MODELS, or skips. */
static void assert_model_counts(const char *file, const char *statements, int covered,
                                int fragments)
{
    const char *folder = getenv("QTRI_MODELS");
    char path[1024], text[4096];

    snprintf(path, sizeof path, "%s/%s", folder ? folder : "", file);
    FILE *model = folder ? fopen(path, "rb") : NULL;
    if (!model) {
        print_message("skipped: no %s in the folder of MODELS: host/bench/README.md, Models, has "
                      "where to get it\n",
                      file);
        skip();
    }
    fclose(model);
    snprintf(text, sizeof text, "%s%s%smesh %s color 1 .70588 .35294\n", CAMERA, LIGHT, statements,
             path);
    assert_counts(text, covered, fragments);
}

/* The translations centre the models on their bounding boxes. */
TEST(spot)
{
    assert_model_counts("spot.obj",
                        "rotate 150 0 1 0\nscale 1.28748383 1.28748383 1.28748383\n"
                        "translate 0 -.108431 -.190045\n",
                        12414, 13009);
}

TEST(teapot)
{
    assert_model_counts("teapot.obj",
                        "shade flat\nrotate 30 0 1 0\nscale .48920438 .48920438 .48920438\n"
                        "translate -0.217000 -1.575000 -0.000000\n",
                        15296, 16390);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
