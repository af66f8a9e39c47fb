/* SPDX-License-Identifier: MIT */
/*
 * The lines of the double-precision reference: outlines of triangles, and their clipping.
 */
#include "support/reference.h"
#include "support/reference_soup.h"

#include "reference/clip.h"

static struct reference_image outline(const char *triangle, int bits)
{
    char text[512];

    snprintf(text, sizeof text, "viewport 8 8\npolygon line\n%s", triangle);
    return render(text, bits);
}

/* Corners at window (1,1) (7,1) (1,5): the top and left edges fill their rows and columns up to the
   end, the slanted one has a pixel in each column 1..6. */
TEST(outlines_are_one_pixel_wide)
{
    static const char *const rows[] = {
        "........", ".111111.", ".1..11..", ".1.1....",
        ".11.....", "........", "........", "........",
    };
    static const char triangle[] =
        "tri -.75 .75 0 1 1 1 1  .75 .75 0 1 1 1 1  -.75 -.25 0 1 1 1 1\n";

    for (size_t b = 0; b < ARRAY_LENGTH(all_bits); b++) {
        struct reference_image image = outline(triangle, all_bits[b]);
        assert_ids(&image, rows);
        reference_free(&image);
    }
}

/* Colours and depth run linearly from end to end, measured at the pixel centres. */
TEST(lines_interpolate_on_the_screen)
{
    static const char text[] = "viewport 8 8\npolygon line\ndepth less\n"
                               "tri -1 .0625 0 1 0 0 1  4 .25 2 4 1 0 1  -1 -3 0 1 0 0 1\n";

    for (size_t b = 0; b < ARRAY_LENGTH(all_bits); b++) {
        struct reference_image image = render(text, all_bits[b]);
        for (int x = 1; x < 8; x++) {
            size_t i = at(&image, x, 3);
            assert_int_equal(image.id[i], 1);
            assert_near(image.color[3 * i], 255 * (x + .5) / 8, 1e-9);
            assert_near(image.depth[i], .5 + .25 * (x + .5) / 8, 1e-12);
        }
        reference_free(&image);
    }
}

/* A line just above the picture, from y = -.9 to -.2, leaves row 0 alone. */
TEST(lines_outside_leave_no_pixels)
{
    static const char triangle[] = "tri -1 1.225 0 1 1 1 1  1 1.05 0 1 1 1 1  0 9 0 1 1 1 1\n";

    for (size_t b = 0; b < ARRAY_LENGTH(all_bits); b++) {
        struct reference_image image = outline(triangle, all_bits[b]);
        assert_int_equal(count_covered(&image), 0);
        reference_free(&image);
    }
}

TEST(lines_are_not_textured)
{
    struct reference_image image =
        render("viewport 8 8\npolygon line\ntexture 2 2 2 0 0 0 0 0 0\ntexmode replace\n"
               "trit -1 0 0 1 1 1 1 0 0  1 0 0 1 1 1 1 1 0  0 -9 0 1 1 1 1 0 1\n",
               0);
    assert_int_equal(image.id[at(&image, 3, 4)], 1);
    assert_near(image.color[3 * at(&image, 3, 4)], 255, 0);
    reference_free(&image);
}

/* Both triangles of a shared edge draw the same pixels for it, whatever the vertices' order and
   wherever it is clipped. */
TEST(shared_lines_coincide)
{
    uint32_t seed = 6;

    for (int round = 0; round < 500; round++) {
        struct scene_vertex v[3] = {{{0}, {0}, {0}, {0}}};
        struct reference_image image[2];
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < 3; i++)
                v[i].position[k] = q16(random_between(&seed, -2, 2));
        for (size_t b = 0; b < ARRAY_LENGTH(all_bits); b++) {
            for (int order = 0; order < 2; order++) {
                soup_begin(40, 40);
                soup.scene.wireframe = true;
                soup_add(&v[0], &v[1 + order], &v[2 - order]);
                image[order] = soup_render(all_bits[b]);
            }
            for (int i = 0; i < 40 * 40; i++)
                assert_int_equal(image[0].hits[i], image[1].hits[i]);
            reference_free(&image[0]);
            reference_free(&image[1]);
        }
    }
}

/* A line from in front of the eye to behind it goes on to the edge of the picture, and does not
   come back on the other side. */
TEST(lines_are_clipped_at_the_eye)
{
    static const char text[] = "viewport 64 64\npolygon line\n"
                               "mode projection\nperspective 90 1 .5 100\nmode modelview\n"
                               "tri 0 -1 -10 1 1 1 1  0 -1 10 1 1 1 1  0 -3 10 1 1 1 1\n";

    /* all three vertices have x = 0: the triangle is seen edge-on and has no outline */
    struct reference_image image = render(text, 0);
    assert_int_equal(count_covered(&image), 0);
    reference_free(&image);

    static const char tilted[] = "viewport 64 64\npolygon line\n"
                                 "mode projection\nperspective 90 1 .5 100\nmode modelview\n"
                                 "tri .1 -1 -10 1 1 1 1  .1 -1 10 1 1 1 1  900 -1 10 1 1 1 1\n";
    for (size_t b = 0; b < ARRAY_LENGTH(all_bits); b++) {
        image = render(tilted, all_bits[b]);
        /* it starts at ndc (.01, -.1), row 35.2, and leaves at the bottom, at ndc (.1, -1) */
        for (int y = 0; y < 64; y++) {
            int pixels = 0;
            for (int x = 0; x < 36; x++)
                pixels += image.id[at(&image, x, y)] != 0;
            if (y < 35 || y > 35)
                assert_int_equal(pixels, y > 35);
        }
        reference_free(&image);
    }
}

/* The ends of an edge may come in either order: clipping gives the same points, to the last bit. */
TEST(clipping_does_not_depend_on_direction)
{
    const struct ref_window picture = {0, 0, 320, 240};
    uint32_t seed = 8;
    int cut = 0;

    for (int round = 0; round < 20000; round++) {
        struct ref_vertex forth[2] = {{0}}, back[2];
        for (int i = 0; i < 2; i++) {
            forth[i].x = random_between(&seed, -1, 1) * (round % 3 == 0 ? 1e7 : 2);
            forth[i].y = random_between(&seed, -1, 1) * (round % 5 == 0 ? 1e7 : 2);
            forth[i].z = random_between(&seed, -2, 2);
            forth[i].w = random_between(&seed, -2, 2);
            forth[i].attribute[REF_RED] = random_between(&seed, 0, 255);
        }
        struct ref_vertex start = forth[0];
        back[0] = forth[1];
        back[1] = forth[0];
        bool left = ref_clip_line(forth, &picture, ref_guard_band(8));
        assert_true(left == ref_clip_line(back, &picture, ref_guard_band(8)));
        if (!left)
            continue;
        cut += forth[0].z != start.z;
        for (int i = 0; i < 2; i++) {
            assert_true(forth[i].x == back[1 - i].x && forth[i].y == back[1 - i].y);
            assert_true(forth[i].z == back[1 - i].z && forth[i].w == back[1 - i].w);
            assert_true(forth[i].attribute[REF_RED] == back[1 - i].attribute[REF_RED]);
        }
    }
    assert_true(cut > 1000);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
