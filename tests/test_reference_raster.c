/* SPDX-License-Identifier: MIT */
/*
 * The triangles of the double-precision reference: which pixels belong to them, snapped and not,
 * for every sign of w.
 */
#include "support/reference.h"
#include "support/reference_soup.h"

/* ---- The top-left rule ---- */

TEST(borders_belong_to_top_and_left_edges)
{
    /* two right triangles that share a diagonal, all borders through pixel centres */
    static const char *const rows[] = {
        "1111....", "1112....", "1122....", "1222....",
        "........", "........", "........", "........",
    };

    for (size_t b = 0; b < ARRAY_LENGTH(all_bits); b++) {
        for (int turn = 0; turn < 8; turn++) { /* any first vertex, either orientation */
            soup_begin(8, 8);
            struct scene_vertex v[4] = {window_vertex(.5, .5, 0, 1), window_vertex(.5, 4.5, 0, 1),
                                        window_vertex(4.5, .5, 0, 2),
                                        window_vertex(4.5, 4.5, 0, .5)};
            const int first[3] = {0, 1, 2}, second[3] = {1, 3, 2};
            int i = turn % 3, j = turn & 4 ? 1 : 2;
            soup_add(&v[first[i]], &v[first[(i + j) % 3]], &v[first[(i + 2 * j) % 3]]);
            soup_add(&v[second[i]], &v[second[(i + j) % 3]], &v[second[(i + 2 * j) % 3]]);
            struct reference_image image = soup_render(all_bits[b]);
            assert_ids(&image, rows);
            reference_free(&image);
        }
    }
}

static void assert_hits(const struct reference_image *image, int x_end, int y_end)
{
    for (int y = 0; y < image->height; y++) {
        for (int x = 0; x < image->width; x++) {
            uint32_t expected = x < x_end && y < y_end;
            uint32_t hits = image->hits[at(image, x, y)];
            if (hits != expected)
                fail_msg("pixel %d,%d is covered %u times", x, y, (unsigned)hits);
        }
    }
}

/* A grid whose vertices all are pixel centres, with random diagonals, orientations and powers of
   two for w: every edge passes through pixel centres, and each belongs to one triangle. */
TEST(ties_are_covered_once)
{
    uint32_t seed = 1;

    for (int round = 0; round < 4; round++) {
        enum { SIZE = 64, STEP = 9, CELLS = 7 };
        struct scene_vertex grid[CELLS + 1][CELLS + 1];
        soup_begin(SIZE, SIZE);
        for (int j = 0; j <= CELLS; j++)
            for (int i = 0; i <= CELLS; i++)
                grid[j][i] = window_vertex(i * STEP + .5, j * STEP + .5, 0,
                                           ldexp(1, (int)(next_random(&seed) % 5) - 2));
        for (int j = 0; j < CELLS; j++) {
            for (int i = 0; i < CELLS; i++) {
                const struct scene_vertex *q[4] = {&grid[j][i], &grid[j][i + 1],
                                                   &grid[j + 1][i + 1], &grid[j + 1][i]};
                int d = next_random(&seed) & 1;
                soup_add(q[d], q[d + 1], q[d + 2]);
                soup_add(q[d], q[(d + 3) % 4], q[d + 2]);
            }
        }
        for (size_t b = 0; b < ARRAY_LENGTH(all_bits); b++) {
            struct reference_image image = soup_render(all_bits[b]);
            assert_hits(&image, 63, 63);
            reference_free(&image);
        }
    }
}

/* A jittered grid that overhangs the picture, with random w: every pixel is covered once. */
TEST(random_meshes_are_covered_once)
{
    static const int bits[] = {0, 1, 4, 8, 16};
    uint32_t seed = 2;

    for (int round = 0; round < 10; round++) {
        enum { CELLS = 9 };
        struct scene_vertex grid[CELLS + 1][CELLS + 1];
        soup_begin(80, 60);
        for (int j = 0; j <= CELLS; j++)
            for (int i = 0; i <= CELLS; i++)
                grid[j][i] =
                    window_vertex(i * 12 - 12 + random_between(&seed, -3, 3),
                                  j * 9 - 10 + random_between(&seed, -2.2, 2.2),
                                  random_between(&seed, -1, 1), random_between(&seed, .5, 8));
        for (int j = 0; j < CELLS; j++) {
            for (int i = 0; i < CELLS; i++) {
                soup_add(&grid[j][i], &grid[j][i + 1], &grid[j + 1][i + 1]);
                soup_add(&grid[j][i], &grid[j + 1][i + 1], &grid[j + 1][i]);
            }
        }
        for (size_t b = 0; b < ARRAY_LENGTH(bits); b++) {
            struct reference_image image = soup_render(bits[b]);
            assert_hits(&image, 80, 60);
            reference_free(&image);
        }
    }
}

/* A ground plane that passes under the eye and reaches far behind it, from a random camera:
   below the horizon and inside near and far everything is covered once, whatever w is. */
TEST(ground_through_the_eye_is_covered_once)
{
    uint32_t seed = 3;

    for (int round = 0; round < 6; round++) {
        char text[16384];
        enum { CELLS = 6 };
        double x[CELLS + 1][CELLS + 1], z[CELLS + 1][CELLS + 1];
        int length = snprintf(text, sizeof text,
                              "viewport 96 64\nmode projection\nfrustum -.15 .15 -.1 .1 .1 60\n"
                              "mode modelview\nrotate %g 0 0 1\nrotate %g 1 0 0\nrotate %g 0 1 0\n",
                              random_between(&seed, -20, 20), random_between(&seed, 0, 90),
                              random_between(&seed, 0, 360));
        for (int j = 0; j <= CELLS; j++) {
            for (int i = 0; i <= CELLS; i++) {
                x[j][i] = (i - 3) * 40 + random_between(&seed, -9, 9);
                z[j][i] = (j - 3) * 40 + random_between(&seed, -9, 9);
            }
        }
        for (int t = 0; t < CELLS * CELLS * 2; t++) {
            int j = t / 2 / CELLS, i = t / 2 % CELLS, k = t & 1;
            length += snprintf(text + length, sizeof text - (size_t)length,
                               "tri %.5f -1 %.5f 1 1 1 1  %.5f -1 %.5f 1 1 1 1  "
                               "%.5f -1 %.5f 1 1 1 1\n",
                               x[j][i], z[j][i], x[j + 1 - k][i + 1], z[j + 1 - k][i + 1],
                               x[j + 1][i + k], z[j + 1][i + k]);
        }
        assert_true((size_t)length < sizeof text);
        struct reference_image exact = render(text, 0);
        int covered = count_covered(&exact);
        assert_in_range(covered, 500, 96 * 64);
        for (size_t b = 0; b < ARRAY_LENGTH(all_bits); b++) {
            struct reference_image image = render(text, all_bits[b]);
            int differing = 0;
            for (int i = 0; i < 96 * 64; i++) {
                assert_in_range(image.hits[i], 0, 1);
                differing += image.hits[i] != exact.hits[i];
            }
            assert_in_range(differing, 0, 12); /* along the horizon */
            reference_free(&image);
        }
        reference_free(&exact);
    }
}

/* With one sub-pixel bit, the sides at 2.75 and 6.8 move to 3 and 7, the rows 1.2 and 4.3 to 1 and
   4.5: to nearest, half up. Exactly, the rectangle covers columns 3..6 and rows 1..3. */
TEST(vertices_snap_to_nearest)
{
    static const char *const rows[] = {
        "........", "...1111.", "...1111.", "...1111.",
        "........", "........", "........", "........",
    };
    static const char *const snapped[] = {
        "........", "........", "..1111..", "..1111..",
        "..1111..", "........", "........", "........",
    };

    for (int shifted = 0; shifted < 2; shifted++) {
        /* the second: 2.2 and 5.75 move to 2 and 6, 1.75 and 4.8 to 2 and 5 */
        double x0 = shifted ? 2.2 : 2.75, x1 = shifted ? 5.75 : 6.8;
        double y0 = shifted ? 1.75 : 1.2, y1 = shifted ? 4.8 : 4.3;
        soup_begin(8, 8);
        struct scene_vertex v[4] = {window_vertex(x0, y0, 0, 1), window_vertex(x0, y1, 0, 1),
                                    window_vertex(x1, y0, 0, 1), window_vertex(x1, y1, 0, 1)};
        soup_add(&v[0], &v[1], &v[2]);
        soup_add(&v[1], &v[3], &v[2]);
        soup.ops[1].id = 1;
        struct reference_image image = soup_render(1);
        assert_ids(&image, shifted ? snapped : rows);
        reference_free(&image);
    }
}

/* ---- Snapped against exact ---- */

static bool is_border(const struct reference_image *image, int x, int y)
{
    bool covered = false, open = false;

    for (int j = y - 1; j <= y + 1; j++) {
        for (int i = x - 1; i <= x + 1; i++) {
            if (i < 0 || j < 0 || i >= image->width || j >= image->height)
                continue;
            if (image->id[at(image, i, j)])
                covered = true;
            else
                open = true;
        }
    }
    return covered && open;
}

struct agreement {
    int both, coverage;
    double color, depth; /* greatest differences where both are covered */
};

static void compare_modes(struct agreement *sum, double *color, double *depth)
{
    struct reference_image exact = soup_render(0);
    struct reference_image fine = soup_render(16);

    *color = *depth = 0;
    for (int y = 0; y < exact.height; y++) {
        for (int x = 0; x < exact.width; x++) {
            size_t i = at(&exact, x, y);
            if (exact.id[i] != fine.id[i]) {
                assert_true(is_border(&exact, x, y) || is_border(&fine, x, y));
                sum->coverage++;
            } else if (exact.id[i]) {
                sum->both++;
                for (size_t c = 0; c < 3; c++)
                    *color = fmax(*color, fabs(exact.color[3 * i + c] - fine.color[3 * i + c]));
                *depth = fmax(*depth, fabs(exact.depth[i] - fine.depth[i]));
            }
        }
    }
    sum->color = fmax(sum->color, *color);
    sum->depth = fmax(sum->depth, *depth);
    reference_free(&exact);
    reference_free(&fine);
}

TEST(fine_snapping_agrees_with_exact)
{
    uint32_t seed = 4;
    struct agreement sum = {0};

    for (int round = 0; round < 300; round++) {
        double color, depth;
        struct scene_vertex v[3];
        soup_begin(64, 64);
        soup.scene.depth_test = soup.scene.depth_write = true;
        soup.scene.screen_linear = round & 1;
        for (int i = 0; i < 3; i++) {
            double w = exp(random_between(&seed, -1, 2));
            v[i] = random_color(window_vertex(random_between(&seed, -40, 104),
                                              random_between(&seed, -40, 104),
                                              random_between(&seed, -1, 1), w),
                                &seed);
        }
        soup_add(&v[0], &v[1], &v[2]);
        compare_modes(&sum, &color, &depth);
    }
    assert_in_range(sum.both, 100000, 1000000);
    assert_in_range(sum.coverage, 0, sum.both / 10000);
    assert_true(sum.color < 0.05);
    assert_true(sum.depth < 1e-4);
}

/* Vertices anywhere in homogeneous space: w of either sign, z outside near and far, coordinates
   far outside the picture. Two thirds of these triangles are cut by a plane. */
TEST(any_w_agrees_with_exact)
{
    uint32_t seed = 5;
    struct agreement sum = {0};
    int visible = 0, steep = 0;

    for (int round = 0; round < 2000; round++) {
        double color, depth;
        struct scene_vertex v[3];
        int before = sum.both;
        soup_begin(48, 48);
        soup.scene.depth_test = soup.scene.depth_write = true;
        for (int i = 0; i < 3; i++) {
            memset(&v[i], 0, sizeof v[i]);
            for (int k = 0; k < 4; k++)
                v[i].position[k] = q16(random_between(&seed, -2, 2));
            if (next_random(&seed) % 8 == 0)
                v[i].position[3] = 0;
            v[i] = random_color(v[i], &seed);
        }
        soup_add(&v[0], &v[1], &v[2]);
        compare_modes(&sum, &color, &depth);
        visible += sum.both > before;
        steep += color > 0.1 || depth > 1e-3; /* slivers, or colours squeezed towards w = 0 */
    }
    assert_in_range(visible, 500, 2000);
    assert_in_range(sum.coverage, 0, sum.both / 1000);
    assert_in_range(steep, 0, 10);
}

/* ---- Particular homogeneous triangles ---- */

static void assert_rectangle(const struct reference_image *image, int x0, int y0, int x1, int y1)
{
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            if ((image->id[at(image, x, y)] != 0) != (x >= x0 && x < x1 && y >= y0 && y < y1))
                fail_msg("pixel %d,%d", x, y);
}

/* A floor all around the eye: one vertex in front, two behind. It covers the picture from the line
   where it reaches the far plane, at 100, .32 pixels below the horizon. */
TEST(triangle_around_the_eye)
{
    static const char text[] = "viewport 64 64\nmode projection\nperspective 90 1 .5 100\n"
                               "mode modelview\n"
                               "tri 0 -1 -9000 1 1 0 0  -9000 -1 3000 1 0 1 0  "
                               "9000 -1 3000 1 0 0 1\n";

    for (size_t b = 0; b < ARRAY_LENGTH(all_bits); b++) {
        struct reference_image image = render(text, all_bits[b]);
        assert_rectangle(&image, 0, 32, 64, 64);
        reference_free(&image);
    }
}

TEST(vertex_at_infinity)
{
    /* a strip between two vertical lines that meet at infinity, upwards */
    static const char text[] = "viewport 64 64\n"
                               "tri -.5 -.5 0 1 1 0 0  .5 -.5 0 1 0 1 0  0 1 0 0 0 0 1\n";

    for (size_t b = 0; b < ARRAY_LENGTH(all_bits); b++) {
        struct reference_image image = render(text, all_bits[b]);
        assert_rectangle(&image, 16, 0, 48, 48);
        /* at y/w = 1 - 2 * .5 / 64 the third vertex has weight 1.484375 / 2.484375 */
        assert_near(image.color[3 * at(&image, 20, 0) + 2], 255 * 1.484375 / 2.484375, 1e-4);
        reference_free(&image);
    }
}

TEST(nothing_is_drawn_behind_the_eye)
{
    static const char *const text[] = {
        "viewport 16 16\ntri 1 1 0 -1 1 0 0  -1 1 0 -1 1 0 0  0 -1 0 -1 1 0 0\n", /* mirrored */
        "viewport 16 16\ntri 0 0 0 0 1 1 1  0 0 0 0 1 1 1  0 0 0 0 1 1 1\n",
        "viewport 16 16\ntri 1 0 0 0 1 1 1  0 1 0 0 1 1 1  -1 -1 0 0 1 1 1\n",  /* at infinity */
        "viewport 16 16\ntri -1 -1 0 1 1 1 1  1 1 0 1 1 1 1  0 0 0 1 1 1 1\n",  /* no area */
        "viewport 16 16\ntri -1 -1 2 1 1 1 1  1 -1 2 1 1 1 1  0 1 2 1 1 1 1\n", /* beyond far */
    };

    for (size_t t = 0; t < ARRAY_LENGTH(text); t++) {
        for (size_t b = 0; b < ARRAY_LENGTH(all_bits); b++) {
            struct reference_image image = render(text[t], all_bits[b]);
            assert_int_equal(count_covered(&image), 0);
            reference_free(&image);
        }
    }
}

/* Near and far cut by the pixel: z goes from -2 to 2 across 16 columns. A triangle that lies in
   the near or far plane is inside. */
TEST(near_and_far_cut)
{
    static const char slope[] = "viewport 16 16\n"
                                "tri -1 -1 -2 1 1 0 0  1 -1 2 1 1 0 0  1 1 2 1 1 0 0\n"
                                "tri -1 -1 -2 1 1 0 0  1 1 2 1 1 0 0  -1 1 -2 1 1 0 0\n";

    for (size_t b = 0; b < ARRAY_LENGTH(all_bits); b++) {
        struct reference_image image = render(slope, all_bits[b]);
        assert_rectangle(&image, 4, 0, 12, 16);
        reference_free(&image);
        for (int z = -1; z <= 1; z += 2) {
            soup_begin(16, 16);
            soup.scene.depth_test = soup.scene.depth_write = true;
            soup.scene.depth_compare = SCENE_ALWAYS;
            struct scene_vertex v[3] = {window_vertex(-16.3, 0, z, 1.7),
                                        window_vertex(32.9, 0, z, .3),
                                        window_vertex(8.1, 60.7, z, 1.1)};
            for (int i = 0; i < 3; i++)
                v[i].position[2] = z * v[i].position[3];
            soup_add(&v[0], &v[1], &v[2]);
            image = soup_render(all_bits[b]);
            assert_int_equal(count_covered(&image), 256);
            assert_near(image.depth[100], z > 0, 1e-15);
            reference_free(&image);
        }
    }
}

/* ---- Anything at all ---- */

static int32_t random_number(uint32_t *seed)
{
    uint32_t v = next_random(seed);

    switch (next_random(seed) % 6) {
    case 0:
        return 0;
    case 1:
        return v & 1 ? INT32_MAX : INT32_MIN;
    case 2:
        return (int32_t)(v % 9) * 32768 - 4 * 32768;
    case 3:
        return (int32_t)(v >> 1);
    default:
        return (int32_t)(v % 400000) - 200000;
    }
}

static void random_op(struct scene_op *op, uint32_t *seed)
{
    memset(op, 0, sizeof *op);
    op->kind = (enum scene_op_kind)(next_random(seed) % 12);
    if (next_random(seed) % 3 == 0)
        op->kind = SCENE_TRIANGLE;
    op->id = 7;
    if (op->kind != SCENE_TRIANGLE) {
        for (int i = 0; i < 16; i++)
            op->u.number[i] = random_number(seed);
        return;
    }
    op->u.triangle.textured = true;
    for (int i = 0; i < 3; i++) {
        struct scene_vertex *v = &op->u.triangle.vertex[i];
        for (int k = 0; k < 4; k++)
            v->position[k] = random_number(seed);
        for (int k = 0; k < 2; k++)
            v->uv[k] = random_number(seed);
        *v = random_color(*v, seed);
    }
}

/* Whatever the numbers are, rendering ends, and colours and depths are numbers in range. */
TEST(every_scene_is_rendered)
{
    static uint8_t texels[8 * 4 * 3];
    uint32_t seed = 7;
    int covered = 0;

    for (int round = 0; round < 1500; round++) {
        soup_begin(17, 13);
        soup.scene.op_count = 12;
        for (size_t i = 0; i < soup.scene.op_count; i++)
            random_op(&soup.ops[i], &seed);
        soup.scene.texture = (struct scene_texture){.width = 8, .height = 4, .rgb = texels};
        soup.scene.depth_test = soup.scene.depth_write = true;
        soup.scene.depth_compare = (enum scene_compare)(next_random(&seed) % 8);
        soup.scene.screen_linear = next_random(&seed) & 1;
        soup.scene.flat = next_random(&seed) & 1;
        soup.scene.wireframe = next_random(&seed) % 4 == 0;
        soup.scene.cull = (enum scene_cull)(next_random(&seed) % 3);
        soup.scene.texture_mode = SCENE_MODULATE;
        memset(texels, (int)(next_random(&seed) % 256), sizeof texels);
        for (size_t b = 0; b < ARRAY_LENGTH(all_bits); b++) {
            struct reference_image image = soup_render(all_bits[b]);
            for (int i = 0; i < 17 * 13; i++) {
                assert_true(image.id[i] == 0 || image.id[i] == 7);
                assert_true(image.depth[i] >= 0 && image.depth[i] <= 1);
                for (int c = 0; c < 3; c++) {
                    double color = image.color[3 * i + c];
                    assert_true(color >= 0 && color <= image.color_max[3 * i + c] + 1e-9);
                }
                covered += image.id[i] != 0;
            }
            reference_free(&image);
        }
    }
    assert_true(covered > 10000);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
