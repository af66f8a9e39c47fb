/* SPDX-License-Identifier: MIT */
/*
 * The double-precision reference against the facts of the course material (computed to 50 digits).
 */
#include "support/reference.h"

#include "reference/matrix.h"
#include "reference/mesh.h"

/* ---- Coordinates of the course's scenes, through the transforms alone ---- */

struct projected {
    double x, y, depth, w;
};

static struct projected project(const struct ref_matrix *projection, const struct ref_matrix *view,
                                const double point[3], int width, int height)
{
    struct ref_matrix to_clip = ref_matrix_multiply(projection, view);
    double p[4] = {point[0], point[1], point[2], 1.0};

    ref_matrix_transform(&to_clip, p, p);
    struct ref_vertex v = {p[0], p[1], p[2], p[3], {0}};
    const struct ref_window picture = {0, 0, width, height};
    struct projected r = {
        (double)(ref_window_x(&v, &picture) / v.w),
        (double)(ref_window_y(&v, &picture) / v.w),
        (p[2] / p[3] + 1.0) / 2.0,
        p[3],
    };
    return r;
}

TEST(course_point_turned_and_moved)
{
    const double z_axis[3] = {0, 0, 7};
    const double by[2][3] = {{1, 2, 0}, {2, 1, 0}};
    const double expected[2][2] = {{1.70710678, 4.12132034}, {2.70710678, 3.12132034}};

    for (int i = 0; i < 2; i++) {
        struct ref_matrix move = ref_matrix_translate(by[i]);
        struct ref_matrix turn = ref_matrix_rotate(45, z_axis);
        struct ref_matrix both = ref_matrix_multiply(&move, &turn);
        double p[4] = {2, 1, 0, 1};
        ref_matrix_transform(&both, p, p);
        assert_near(p[0], expected[i][0], 5e-9);
        assert_near(p[1], expected[i][1], 5e-9);
    }
}

TEST(course_line_triangle_coordinates)
{
    const double eye[3] = {0, 0, 5}, center[3] = {0, 0, 4}, up[3] = {0, 1, 0};
    const double vertex[3][3] = {{2, 0, -2}, {0, 2, -2}, {-2, 0, -2}};
    const double expected[3][2] = {{591.421356, 350}, {350, 108.578644}, {108.578644, 350}};
    struct ref_matrix view = ref_matrix_look_at(eye, center, up);
    struct ref_matrix projection = ref_matrix_perspective(45, 1, 0.1, 50);

    for (int i = 0; i < 3; i++) {
        struct projected p = project(&projection, &view, vertex[i], 700, 700);
        assert_near(p.x, expected[i][0], 5e-7);
        assert_near(p.y, expected[i][1], 5e-7);
        assert_near(p.depth, 0.987689665, 5e-10);
        assert_near(p.w, 7, 1e-14);
    }
}

TEST(course_color_triangle_coordinates)
{
    const double eye[3] = {0, 0, 3}, center[3] = {0, 0, 0}, up[3] = {0, 1, 0};
    const double vertex[3][3] = {{0, 1, 0}, {-1, 0, 1}, {1, 0, 1}};
    const struct projected expected[3] = {
        {128, 54.0991655, .976430976, 3},
        {17.1487483, 128, .959595960, 2},
        {238.8512517, 128, .959595960, 2},
    };
    struct ref_matrix view = ref_matrix_look_at(eye, center, up);
    struct ref_matrix projection = ref_matrix_perspective(60, 1, 0.1, 10);

    for (int i = 0; i < 3; i++) {
        struct projected p = project(&projection, &view, vertex[i], 256, 256);
        assert_near(p.x, expected[i].x, 5e-8);
        assert_near(p.y, expected[i].y, 5e-8);
        assert_near(p.depth, expected[i].depth, 5e-10);
        assert_near(p.w, expected[i].w, 1e-14);
    }
}

/* frustum and ortho map the corners of their box to the corners of clip space. */
TEST(frustum_and_ortho_map_their_box)
{
    const double bounds[6] = {-1, 3, -2, 0.5, 2, 9};
    struct ref_matrix frustum = ref_matrix_frustum(bounds);
    struct ref_matrix ortho = ref_matrix_ortho(bounds);

    for (int corner = 0; corner < 8; corner++) {
        double distance = bounds[4 + (corner >> 2)];
        double x = bounds[corner & 1], y = bounds[2 + (corner >> 1 & 1)];
        double spread = distance / bounds[4];
        double p[4] = {x * spread, y * spread, -distance, 1};
        double q[4] = {x, y, -distance, 1};
        ref_matrix_transform(&frustum, p, p);
        ref_matrix_transform(&ortho, q, q);
        assert_near(p[3], distance, 1e-12);
        assert_near(q[3], 1, 0);
        for (int i = 0; i < 3; i++) {
            double expected = (corner >> i & 1) ? 1 : -1;
            assert_near(p[i] / p[3], expected, 1e-12);
            assert_near(q[i], expected, 1e-12);
        }
    }
}

TEST(rotations_are_exact_at_right_angles)
{
    const double axis[3] = {0, 0, 0.25};

    for (int quarter = -9; quarter <= 9; quarter++) {
        const double cosines[4] = {1, 0, -1, 0}, sines[4] = {0, 1, 0, -1};
        struct ref_matrix m = ref_matrix_rotate(90.0 * quarter, axis);
        int q = (quarter + 12) % 4;
        assert_near(m.m[0][0], cosines[q], 0);
        assert_near(m.m[1][1], cosines[q], 0);
        assert_near(m.m[1][0], sines[q], 0);
        assert_near(m.m[0][1], -sines[q], 0);
    }
}

/* Rodrigues about (-1,1,0), the course's second axis: keeps the axis, keeps lengths, and turns a
   perpendicular vector by the angle, counter-clockwise seen from the tip of the axis. */
TEST(rotation_about_a_slanted_axis)
{
    const double axis[3] = {-1, 1, 0};
    const double unit[3] = {-sqrt(0.5), sqrt(0.5), 0};
    const double across[3] = {sqrt(0.5), sqrt(0.5), 0};
    double quarter_turned[3];

    ref_cross3(unit, across, quarter_turned);
    for (int degrees = -720; degrees <= 720; degrees += 10) {
        struct ref_matrix m = ref_matrix_rotate(degrees, axis);
        double p[4] = {axis[0], axis[1], axis[2], 1};
        double v[4] = {across[0], across[1], across[2], 1};
        double angle = degrees * (3.14159265358979323846 / 180);
        ref_matrix_transform(&m, p, p);
        ref_matrix_transform(&m, v, v);
        for (int i = 0; i < 3; i++) {
            assert_near(p[i], axis[i], 1e-15);
            assert_near(v[i], cos(angle) * across[i] + sin(angle) * quarter_turned[i], 3e-15);
        }
    }
}

TEST(camera_survives_useless_arguments)
{
    const double origin[3] = {0, 0, 0}, ahead[3] = {0, 0, -3}, above[3] = {0, 2, 0};
    const double y[3] = {0, 1, 0};
    struct ref_matrix m;

    m = ref_matrix_look_at(origin, ahead, ahead); /* up along the view: +y instead */
    assert_near(m.m[1][1], 1, 0);
    assert_near(m.m[2][2], 1, 0);
    m = ref_matrix_look_at(origin, above, y); /* ... which is along the view: +z instead */
    assert_near(m.m[1][2], 1, 0);
    assert_near(m.m[2][1], -1, 0);
    m = ref_matrix_look_at(above, above, y); /* no direction: down -z */
    assert_near(m.m[2][2], 1, 0);
    assert_near(m.m[1][3], -2, 0);
    m = ref_matrix_rotate(30, origin); /* no axis: no turn */
    assert_near(m.m[0][0], 1, 0);
}

/* ---- The colour triangle, pixel by pixel ---- */

#define COLOR_TRIANGLE_VIEW                                                                        \
    "viewport 256 256\n"                                                                           \
    "mode projection\nperspective 60 1 .1 10\n"                                                    \
    "mode modelview\nlookat 0 0 3  0 0 0  0 1 0\n"
#define COLOR_TRIANGLE "tri 0 1 0 1 1 0 0  -1 0 1 1 0 1 0  1 0 1 1 0 0 1\n"

struct sample {
    int x, y;
    double perspective[3], linear[3], depth;
};

static const struct sample samples[] = {
    {128, 60, {223, 15, 17}, {233, 10, 12}, .974972831},
    {128, 90, {104, 75, 76}, {129, 62, 63}, .968138666},
    {100, 100, {72, 127.5, 55}, {95, 112, 48}, .965860611},
    {150, 100, {72, 62, 121}, {95, 54, 106}, .965860611},
    {60, 120, {18, 199, 38}, {26, 192, 37}, .961304501},
    {200, 120, {18, 32, 205}, {26, 31, 198}, .961304501},
    {225, 126, {3, 13, 239}, {5, 13, 237}, .959937668},
    {110, 75, {158, 75, 22}, {181, 57, 17}, .971555749},
};

static void assert_color_triangle(const char *extra, int bits)
{
    char text[512];
    bool linear = strstr(extra, "linear") != NULL;

    snprintf(text, sizeof text, "%s%s%s", COLOR_TRIANGLE_VIEW, extra,
             "depth less\n" COLOR_TRIANGLE);
    struct reference_image image = render(text, bits);
    assert_int_equal(count_covered(&image), 8214);
    assert_row(&image, 53, 1, 0);
    assert_row(&image, 54, 127, 128);
    assert_row(&image, 90, 73, 182);
    assert_row(&image, 127, 18, 237);
    assert_row(&image, 128, 1, 0);
    for (size_t s = 0; s < ARRAY_LENGTH(samples); s++) {
        size_t i = at(&image, samples[s].x, samples[s].y);
        const double *expected = linear ? samples[s].linear : samples[s].perspective;
        double slack = bits == 8 ? 0.6 : 0.501;
        for (size_t c = 0; c < 3; c++)
            assert_near(image.color[3 * i + c], expected[c], slack);
        /* near = .1 is 6554/65536 in the scene: the depths differ by up to 2.4e-6 */
        assert_near(image.depth[i], samples[s].depth, bits == 8 ? 1e-5 : 3e-6);
    }
    reference_free(&image);
}

TEST(course_color_triangle)
{
    for (size_t b = 0; b < ARRAY_LENGTH(all_bits); b++) {
        assert_color_triangle("", all_bits[b]);
        assert_color_triangle("interpolate linear\n", all_bits[b]);
    }
}

/* The same triangle with the exact near plane, past the scene's Q16.16: all nine digits. */
TEST(course_color_triangle_depths)
{
    const double eye[3] = {0, 0, 3}, center[3] = {0, 0, 0}, up[3] = {0, 1, 0};
    const double position[3][4] = {{0, 1, 0, 1}, {-1, 0, 1, 1}, {1, 0, 1, 1}};
    struct scene scene;
    struct reference_image image;
    struct ref_target target;
    struct ref_triangle triangle = {.id = 1};

    parse("viewport 256 256\ndepth less\n", &scene);
    struct ref_matrix view = ref_matrix_look_at(eye, center, up);
    struct ref_matrix projection = ref_matrix_perspective(60, 1, 0.1, 10);
    struct ref_matrix to_clip = ref_matrix_multiply(&projection, &view);
    for (int i = 0; i < 3; i++) {
        double p[4];
        ref_matrix_transform(&to_clip, position[i], p);
        triangle.vertex[i] = (struct ref_vertex){p[0], p[1], p[2], p[3], {0}};
        triangle.vertex[i].attribute[i] = 255;
    }
    assert_true(ref_target_open(&target, &scene, 0, &image));
    ref_draw_triangle(&target, &triangle);
    for (size_t s = 0; s < ARRAY_LENGTH(samples); s++) {
        size_t i = at(&image, samples[s].x, samples[s].y);
        assert_near(image.depth[i], samples[s].depth, 5.1e-10);
    }
    size_t tie = at(&image, 100, 100);
    assert_near(image.color[3 * tie + 1], 127.5, 1e-9);
    reference_free(&image);
    scene_free(&scene);
}

/* The animation of a triangle in the plane z = 0: at t = 1 it is seen edge-on. Whatever the order
   of the turns, y by 90 makes the other two turns about one and the same axis. */
TEST(course_animation)
{
    static const char *const turns[] = {"rotate %g 0 0 1\nrotate %g 0 1 0\nrotate %g 1 0 0\n",
                                        "rotate %g 1 0 0\nrotate %g 0 1 0\nrotate %g 0 0 1\n"};

    for (size_t b = 0; b < ARRAY_LENGTH(all_bits) * 2; b++) {
        int before = 256 * 256;
        for (int step = 0; step < 5; step++) {
            char turn[128], text[512];
            double t = step / 4.0;
            snprintf(turn, sizeof turn, turns[b % 2], 60 * t, 90 * t, 60 * t);
            snprintf(text, sizeof text, "%s%s%s", COLOR_TRIANGLE_VIEW, turn,
                     "tri -1 -.6 0 1 1 0 0  1 -.6 0 1 1 0 0  0 1.2 0 1 1 0 0\n");
            struct reference_image image = render(text, all_bits[b / 2]);
            int count = count_covered(&image);
            assert_true(count < before);
            assert_true(step == 4 ? count == 0 : count > 2000);
            before = count;
            reference_free(&image);
        }
    }
}

/* The colour triangle turned about its own normal, (0,1,1), through its centroid, (0,1/3,2/3). It
   stays in its plane; its depth at the centroid does not change. */
TEST(course_turn_about_the_normal)
{
    for (int degrees = 0; degrees <= 180; degrees += 45) {
        char text[512];
        snprintf(text, sizeof text,
                 "%sdepth less\ntranslate 0 .333333333 .666666667\nrotate %d 0 1 1\n"
                 "translate 0 -.333333333 -.666666667\n%s",
                 COLOR_TRIANGLE_VIEW, degrees, COLOR_TRIANGLE);
        struct reference_image image = render(text, 0);
        /* (0, 1/3, 2/3) lands on (128, 96.33), where the three colours are equal */
        size_t left = at(&image, 127, 96), right = at(&image, 128, 96);
        assert_int_equal(image.id[left], 1);
        assert_near((image.depth[left] + image.depth[right]) / 2, 0.9667698, 2e-6);
        for (size_t c = 0; c < 3; c++)
            assert_near((image.color[3 * left + c] + image.color[3 * right + c]) / 2, 85, 1.5);
        reference_free(&image);
    }
}

/* ---- Depth ---- */

#define OVERLAP_VIEW                                                                               \
    "viewport 700 700\n"                                                                           \
    "mode projection\nperspective 45 1 .1 50\n"                                                    \
    "mode modelview\nlookat 0 0 5  0 0 0  0 1 0\n"
#define OVERLAP_1 "tri 2 0 -2 1 .85 .93 .73  0 2 -2 1 .85 .93 .73  -2 0 -2 1 .85 .93 .73\n"
#define OVERLAP_2 "tri 3.5 -1 -5 1 .73 .85 .93  2.5 1.5 -5 1 .73 .85 .93  -1 .5 -5 1 .73 .85 .93\n"

TEST(course_overlapping_triangles)
{
    for (size_t b = 0; b < ARRAY_LENGTH(all_bits); b++) {
        struct reference_image image =
            render(OVERLAP_VIEW "depth less\n" OVERLAP_1 OVERLAP_2, all_bits[b]);
        struct reference_image swapped =
            render(OVERLAP_VIEW "depth less\n" OVERLAP_2 OVERLAP_1, all_bits[b]);
        int doubled = 0;
        for (int i = 0; i < 700 * 700; i++) {
            assert_int_equal(image.id[i] ? 3 - image.id[i] : 0, swapped.id[i]);
            if (image.hits[i] == 2) {
                assert_int_equal(image.id[i], 1);
                doubled++;
            }
        }
        assert_in_range(doubled, 5000, 50000);
        assert_near(image.depth[at(&image, 350, 300)], .987689665, 2e-6);
        reference_free(&image);
        reference_free(&swapped);
    }
}

/* Two triangles that cross along the picture's vertical middle, in clip space. */
TEST(crossing_triangles)
{
    static const char text[] = "viewport 64 64\ndepth less\n"
                               "tri -1 -1 -.5 1 1 0 0  1 -1 .5 1 1 0 0  0 1 0 1 1 0 0\n"
                               "tri -1 -1 .5 1 0 0 1  1 -1 -.5 1 0 0 1  0 1 0 1 0 0 1\n";

    for (size_t b = 0; b < ARRAY_LENGTH(all_bits); b++) {
        struct reference_image image = render(text, all_bits[b]);
        for (int y = 0; y < 64; y++) {
            for (int x = 0; x < 64; x++) {
                size_t i = at(&image, x, y);
                if (image.hits[i] == 0)
                    continue;
                assert_int_equal(image.hits[i], 2);
                assert_int_equal(image.id[i], x < 32 ? 1 : 2);
            }
        }
        reference_free(&image);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
