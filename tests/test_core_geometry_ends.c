/* SPDX-License-Identifier: MIT */
/*
 * Geometry at the ends of its ranges: arguments that a scene never has, and that have a result.
 */
#include "support/transform.h"
#include "support/vertex_narrow.h"

#include "geometry/cull.h"
#include "geometry/illumination.h"
#include "geometry/lighting.h"
#include "geometry/projector.h"

#include <qtri/animation.h>
#include <qtri/mesh.h>
#include <qtri/view.h>
#include <qtri/light.h>

TEST(viewports_are_held)
{
    assert_int_equal(qtri_viewport_bottom(1, 2, 30, 40, 100).y, 58);
    assert_int_equal(qtri_viewport_bottom(0, INT32_MAX, 10, 10, 10).y, -QTRI_VIEWPORT_MAX);
    assert_int_equal(qtri_viewport_bottom(0, INT32_MIN, 10, INT32_MIN, 10).y, QTRI_VIEWPORT_MAX);
}

/* A camera that has lost an axis, or that looks straight down, turns nothing. */
TEST(billboards_need_all_axes)
{
    qtri_transform start;
    qtri_transform camera;
    const qtri_row empty = {0};
    qtri_transform_identity(&start);
    qtri_transform_translate(&start, vec3_of(1, 2, 3));
    for (int lost = 0; lost < 3; lost++) {
        qtri_transform t = start;
        qtri_transform_identity(&camera);
        qtri_transform_rotate_x(&camera, Q16(30));
        camera.row[lost] = empty;
        qtri_transform_billboard(&t, &camera);
        assert_memory_equal(&t, &start, sizeof t);
    }
    qtri_transform t = start;
    qtri_transform_billboard_upright(&t, &camera); /* without its third row */
    assert_memory_equal(&t, &start, sizeof t);
    for (int down = -1; down <= 1; down += 2) {
        qtri_transform_identity(&camera);
        qtri_transform_look_at(&camera, vec3_of(0, 5 * down, 0), vec3_of(0, 0, 0),
                               vec3_of(0, 0, 1));
        qtri_transform_billboard_upright(&t, &camera);
        assert_memory_equal(&t, &start, sizeof t);
    }
}

/* A polygon that is not convex crosses a plane more often: no more vertices than there is room. */
TEST(zigzags_stay_in_their_room)
{
    for (int count = 3; count <= QTRI_CLIP_MAX; count++) {
        for (int turn = 0; turn < 2; turn++) {
            struct {
                qtri_clip_vertex v[QTRI_CLIP_MAX];
                uint32_t guard[8];
            } room;
            memset(&room, 0, sizeof room);
            memset(room.guard, 0x5A, sizeof room.guard);
            for (int i = 0; i < count; i++) {
                const int64_t z = (i + turn) % 2 == 0 ? 3000 : -3000; /* in and out of near */
                const qtri_clip_vertex v = {100 * i, 77 * i * i, z, 2000, 0, 0};
                room.v[i] = v;
            }
            const int kept = qtri_clip_polygon(room.v, count, QTRI_OUT_NEAR);
            assert_in_range(kept, 0, QTRI_CLIP_MAX);
            for (int i = 0; i < kept; i++) {
                assert_true(room.v[i].z + room.v[i].w >= -1);
            }
            for (size_t i = 0; i < LENGTH_OF(room.guard); i++) {
                assert_int_equal(room.guard[i], 0x5A5A5A5A);
            }
        }
    }
}

/* A row of zeros is one whatever its exponent. */
TEST(rows_of_zeros_have_any_exponent)
{
    static const int32_t exponents[] = {-4096, -300, -80, 0, 43, 300, 4096};
    const qtri_vec3 origin = vec3_of(.5, -1, 2);
    const qtri_position16 p[3] = {{-32767, 100, 5}, {0, 0, 0}, {32767, -20000, 32767}};
    qtri_clip_vertex want[3];
    for (size_t n = 0; n < LENGTH_OF(exponents); n++) {
        qtri_transform t;
        qtri_projector projector;
        const qtri_viewport viewport = qtri_viewport_top(0, 0, 100, 80);
        const qtri_row empty = {.exponent = exponents[n]};
        qtri_transform_identity(&t);
        t.row[2] = empty;
        t.row[0] = empty;
        qtri_projector_init(&projector, &t, &viewport);
        qtri_projector_compact(&projector, &origin, Q16(1));
        for (int i = 0; i < 3; i++) {
            qtri_clip_vertex got;
            qtri_projector_point16(&projector, &p[i], &got);
            want[i] = n == 0 ? got : want[i];
            assert_int_equal(got.z, 0);
            assert_memory_equal(&got, &want[i], sizeof got);
        }
    }
}

/* Translations of nearly 2^61, the most that a row holds, whose sum is more: in other units. */
TEST(translations_at_their_limit)
{
    for (int n = 0; n < 4; n++) {
        qtri_transform a, b, product;
        qtri_transform_identity(&a);
        qtri_transform_identity(&b);
        a.row[1].t = (((int64_t)1 << 60) - 1) * (n & 1 ? -1 : 1);
        b.row[1].t = (((int64_t)1 << 61) - 1) * (n & 2 ? -1 : 1);
        qtri_transform_mul(&product, &a, &b);
        check_form(&product);
        for (int j = 0; j < 4; j++) {
            const double sum = j < 3 ? element(&b, 1, j) : element(&a, 1, j) + element(&b, 1, j);
            assert_near(element(&product, 1, j), sum, fabs(sum) * 1e-8);
        }
    }
}

/* w = 8 everywhere: affine but for its scale, which the product keeps. */
TEST(constant_weights_are_kept)
{
    qtri_transform eighth;
    qtri_transform turned;
    qtri_transform product;
    qtri_transform_identity(&eighth);
    eighth.row[3].exponent -= 3;
    qtri_transform_identity(&turned);
    qtri_transform_perspective(&turned, Q16(60), Q16(1), Q16(1), Q16(9));
    qtri_transform_rotate_z(&turned, Q16(40));
    qtri_transform_translate(&turned, vec3_of(3, -2, 1));
    qtri_transform_mul(&product, &turned, &eighth);
    check_form(&product);
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            assert_near(element(&product, i, j), element(&turned, i, j) * (j == 3 ? 8 : 1), 1e-7);
        }
    }
}

/* The rest of a vertex that cannot be projected is that of w = 1, and none beyond the guard. */
TEST(rests_without_w)
{
    const qtri_point at = {0, 0};
    int16_t rest[2][2];
    for (int64_t w = -3; w <= 0; w++) {
        for (int64_t x = -2; x <= 2; x++) {
            const qtri_clip_vertex v[2] = {{x, 0, 0, w, 0, 0}, {x, 0, 0, 1, 0, 0}};
            qtri_project_rest(rest[0], &v[0], &at, 0x7FFFFFFF);
            qtri_project_rest(rest[1], &v[1], &at, 0x7FFFFFFF);
            assert_memory_equal(rest[0], rest[1], sizeof rest[0]);
            assert_true(rest[0][0] == 0 && rest[0][1] == 0);
        }
    }
}

/* ---- Bounds and shapes that move ---- */

TEST(boxes_of_all_numbers)
{
    static const q16 ends[][2] = {
        {Q16_MIN, Q16_MAX}, {Q16_MIN + 1, Q16_MAX}, {Q16_MIN, -1}, {0, Q16_MAX}, {-3, 4}, {5, 5},
        {Q16_MAX, Q16_MAX}, {Q16_MIN, Q16_MIN}};
    for (size_t i = 0; i < LENGTH_OF(ends); i++) {
        const qtri_vec3 p[2] = {{ends[i][0], 0, 0}, {ends[i][1], 0, 0}};
        const qtri_mesh mesh = {.positions = p, .vertex_count = 2};
        const qtri_box box = qtri_mesh_box(&mesh);
        const int64_t low = (int64_t)box.center.x - box.half.x;
        const int64_t high = (int64_t)box.center.x + box.half.x;
        assert_true(low <= ends[i][0] && low >= (int64_t)ends[i][0] - 1);
        /* The only one that no half is large enough for is off by one. */
        assert_true(high == ends[i][1] - (i == 0));
    }
}

TEST(ten_thousand_targets_are_held)
{
    enum { TARGETS = 9000 };
    static const qtri_position16 far[2] = {{32767, -32768, 100}, {-32768, 32767, -100}};
    static const qtri_position16 *target[TARGETS];
    static q16 weight[TARGETS];
    const qtri_position16 base[2] = {{-32767, 32767, 99}, {32767, -32767, -99}};
    for (int i = 0; i < TARGETS; i++) {
        target[i] = far;
        weight[i] = Q16_MAX;
    }
    qtri_position16 out[2];
    qtri_morph_targets(out, base, target, weight, TARGETS, 2);
    assert_true(out[0].x == 32767 && out[0].y == -32767 && out[0].z == 32767);
    assert_true(out[1].x == -32767 && out[1].y == 32767 && out[1].z == -32767);
}

TEST(frames_end_at_32767)
{
    enum { FRAMES = 40000 };
    static qtri_position16 positions[FRAMES];
    for (int i = 0; i < FRAMES; i++) {
        positions[i].x = (int16_t)(i < 32767 ? i : -5);
    }
    for (int frames = 32766; frames <= FRAMES; frames += frames < 32768 ? 1 : 7232) {
        const int last = frames < 32767 ? frames - 1 : 32766;
        qtri_position16 out;
        qtri_frames_positions(&out, positions, frames, 1, last * 65536);
        assert_int_equal(out.x, last);
        qtri_frames_positions(&out, positions, frames, 1, last * 65536 + 32768); /* to the first */
        assert_int_equal(out.x, last / 2);
        qtri_frames_positions(&out, positions, frames, 1, -65536);
        assert_int_equal(out.x, last);
    }
}

/* ---- Where all faces are seen from, which leaves some out ---- */

static bool finds_eye(const qtri_mat4 *m, const qtri_viewport *viewport, uint32_t thin)
{
    const qtri_mesh mesh = {.extent = Q16(1), .faces = {NULL, NULL, thin, 60, 1 << 14}};
    qtri_transform t;
    qtri_projector projector;
    qtri_eye eye;
    qtri_transform_from_mat4(&t, m);
    qtri_projector_init(&projector, &t, viewport);
    qtri_projector_compact(&projector, &mesh.origin, mesh.extent);
    const bool found = qtri_eye_find(&eye, &projector, &mesh.faces);
    assert_int_equal(found, narrow_eye(&t, viewport, &mesh, &eye));
    return found;
}

/* How wide the bound is, within which a face may turn either way: an eye at three distances. */
TEST(bounds_of_eyes)
{
    static const struct {
        double distance;
        int32_t w, behind;
    } cases[] = {{2.5, 538433, 321675}, {4, 355032, 230699}, {9, 162590, 156602}};
    for (size_t i = 0; i < LENGTH_OF(cases); i++) {
        const qtri_mesh mesh = {.extent = Q16(1), .faces = {NULL, NULL, 300, 60, 1 << 14}};
        const qtri_viewport viewport = qtri_viewport_top(0, 0, 320, 240);
        const qtri_vec3 at = {fixed(cases[i].distance), Q16(1), Q16(.5)};
        const qtri_vec3 center = {0, 0, 0};
        const qtri_vec3 up = {0, Q16_ONE, 0};
        qtri_transform t;
        qtri_projector projector;
        qtri_eye eye;
        qtri_transform_identity(&t);
        qtri_transform_perspective(&t, Q16(60), Q16(1.25), Q16(.1), Q16(50));
        qtri_transform_look_at(&t, at, center, up);
        qtri_projector_init(&projector, &t, &viewport);
        qtri_projector_compact(&projector, &mesh.origin, mesh.extent);
        assert_true(qtri_eye_find(&eye, &projector, &mesh.faces));
        assert_int_equal(eye.w, cases[i].w);
        assert_int_equal(eye.behind, cases[i].behind);
    }
}

/* Views in which snapping moves corners by more than a face: no face is left out. */
TEST(views_that_tell_nothing)
{
    uint64_t seed = 8;
    /* A pixel that shows next to nothing: x and y in finer units than w. */
    const qtri_viewport pixel = qtri_viewport_top(0, 0, 1, 1);
    for (int n = 0; n < 500; n++) {
        const qtri_mat4 m = {{{random_in(&seed, 1, 100), 0, 0, -65536},
                              {0, random_in(&seed, 1, 100), 0, 65536},
                              {0, 0, 0, 0},
                              {0, 0, 0, 65536}}};
        assert_false(finds_eye(&m, &pixel, 3000));
    }
    /* From the side: x and y go nearly the same way. */
    const qtri_viewport small = qtri_viewport_top(0, 0, 10, 10);
    const qtri_mat4 side = {{{7642800, -1549856, -261132, 6894826},
                             {7642826, -1549835, -261125, 6894806},
                             {21780, 0, 0, 53896},
                             {26485, 0, 0, 65536}}};
    assert_false(finds_eye(&side, &small, 2729));
    /* And one that does. */
    const qtri_viewport large = qtri_viewport_top(0, 0, 300, 200);
    const qtri_mat4 plain = {
        {{65536, 0, 0, 0}, {0, 65536, 0, 0}, {0, 0, 4096, 0}, {0, 0, -10000, 65536}}};
    assert_true(finds_eye(&plain, &large, 3000));
}

/* ---- Light ---- */

/* min(1, ambient + diffuse max(0, n . towards)), of any two numbers. */
TEST(any_ambient_and_diffuse)
{
    static const double shares[] = {-3, -.5, 0, .25, .8, 1, 1.5, 4, 4.5, 30000};
    uint64_t seed = 12;
    for (int n = 0; n < 4000; n++) {
        qtri_transform pose;
        qtri_lighting lighting;
        const double ambient = shares[random_in(&seed, 0, 9)];
        const double diffuse = shares[random_in(&seed, 0, 9)];
        const qtri_light light = {
            .towards = vec3_of(2, -1, 3), .ambient = fixed(ambient), .diffuse = fixed(diffuse)};
        double v[3] = {0, 0, 0};
        double length = 0;
        double cosine = 0;
        int16_t c[3];
        qtri_transform_identity(&pose);
        qtri_transform_rotate_x(&pose, random_bits32(&seed));
        qtri_transform_rotate_y(&pose, random_bits32(&seed));
        qtri_lighting_init(&lighting, &light, &pose, false, &qtri_light_uneven);
        for (int i = 0; i < 3; i++) {
            v[i] = random_in(&seed, -1000, 1000) + .5;
            length += v[i] * v[i];
        }
        for (int i = 0; i < 3; i++) {
            c[i] = (int16_t)lrint(16384 * v[i] / sqrt(length));
        }
        const qtri_normal normal = {c[0], c[1], c[2]};
        const double towards[3] = {2, -1, 3};
        length = 0;
        for (int i = 0; i < 3; i++) { /* turned into eye space */
            cosine += towards[i] / sqrt(14) *
                      (element(&pose, i, 0) * c[0] + element(&pose, i, 1) * c[1] +
                       element(&pose, i, 2) * c[2]);
            length += (double)c[i] * c[i];
        }
        const double exact = fmin(1, fmax(0, ambient + diffuse * fmax(0, cosine / sqrt(length))));
        const double tolerance = 3e-5 + fabs(diffuse) * 1.3e-4; /* of the normal's length */
        const qtri_mesh mesh = {.normals = &normal};
        const uint32_t got = qtri_light_by_vertex.vertex(&lighting, &mesh, 0);
        assert_near(got / 32768., exact, tolerance);
    }
}

/* Sources that are too far for any exponent stay on their side. */
TEST(places_are_held_on_both_sides)
{
    qtri_transform camera;
    qtri_transform_identity(&camera);
    qtri_light_space space = {.camera = &camera, .even = false};
    for (int32_t exponent = 0; exponent < 500; exponent += 7) {
        const qtri_vec3 p = vec3_of(20000, -3, .001);
        const qtri_vec3 opposite = {-p.x, -p.y, -p.z};
        int32_t at[2][3];
        int32_t scale[2];
        space.unit = qtri_wide_make(1, exponent);
        qtri_light_place(at[0], &scale[0], &space, &p);
        qtri_light_place(at[1], &scale[1], &space, &opposite);
        assert_int_equal(scale[0], scale[1]);
        for (int i = 0; i < 3; i++) {
            assert_true(abs(at[0][i]) <= 1 << 29);
            assert_true(abs(at[0][i] + at[1][i]) <= 1);
        }
        assert_true(at[0][0] > 1 << 27 || exponent < 20);
        assert_true(exponent < 200 || (at[0][0] == 1 << 29 && at[1][0] == -(1 << 29)));
    }
}

/* Poses of any size have the light of their angles. */
TEST(sizes_beyond_any_do_not_dim)
{
    const qtri_light_color white = {Q16(1), Q16(1), Q16(1)};
    const qtri_light_color black = {0, 0, 0};
    const qtri_light_source source = {
        .kind = &qtri_directional_light, .position = vec3_of(1, 2, 2), .color = white};
    const qtri_rgb full = {255, 255, 255};
    qtri_light lights;
    qtri_view view;
    qtri_view_init(&view, 10, 10);
    assert_ok(qtri_light_init(&lights, &source, 1, black));
    view.light = &lights;
    for (int up = 0; up < 2; up++) {
        const q16 scale = up ? Q16(16384) : 4;
        const qtri_vec3 same = {scale, scale, scale};
        int uneven = 0;
        qtri_transform pose;
        qtri_transform_identity(&pose);
        qtri_transform_rotate_x(&pose, Q16(70));
        for (int n = 0; n < 60; n++) { /* to 2^840, and to 2^-840 */
            qtri_illumination by;
            qtri_lit_point point = {0};
            qtri_illumination_init(&by, &view, &pose, NULL, NULL);
            qtri_illuminated_normal(&point, &by, 3000, 9000, 13000);
            const uint32_t color = qtri_illuminate(&by, &point, &full);
            const double angle = 70 * radians;
            const double n2[3] = {3, 9 * cos(angle) - 13 * sin(angle),
                                  9 * sin(angle) + 13 * cos(angle)};
            const double cosine = (n2[0] + 2 * n2[1] + 2 * n2[2]) / 3 / sqrt(9 + 81 + 169);
            assert_near(color & 255, 255 * cosine, 1.5);
            uneven += !by.even;
            qtri_transform_scale(&pose, same);
        }
        assert_true(uneven > 10);
    }
}

/* An element of a row, but for its translation. */
static double of_row(const qtri_row *row, int i)
{
    return ldexp(row->m[i], -row->exponent);
}

/*
 * From 16-bit positions to places in eye space by rows of whole numbers, in a unit that is a power
 * of 2: they fill 28 bits and no more, are multiples of 4, and end where the pose says.
 */
TEST(places_of_short_positions)
{
    const qtri_light_color black = {0, 0, 0};
    const qtri_light_source source = {
        .kind = &qtri_directional_light, .position = vec3_of(1, 2, 2), .color = black};
    qtri_light lights;
    qtri_view view;
    uint64_t seed = 31;
    double worst = 0;
    int uneven = 0;
    qtri_view_init(&view, 10, 10);
    assert_ok(qtri_light_init(&lights, &source, 1, black));
    view.light = &lights;
    for (int n = 0; n < 4000; n++) {
        qtri_transform pose;
        qtri_illumination by;
        qtri_mesh mesh = {.extent = random_in(&seed, 1, 1 << random_in(&seed, 1, 30))};
        qtri_vec3 v[3];
        for (int i = 0; i < 3; i++) {
            v[i].x = random_in(&seed, -Q16(9), Q16(9)) >> random_in(&seed, 0, 12);
            v[i].y = random_in(&seed, -Q16(9), Q16(9)) >> random_in(&seed, 0, 12);
            v[i].z = random_in(&seed, -Q16(9), Q16(9)) >> random_in(&seed, 0, 12);
        }
        qtri_transform_identity(&pose);
        qtri_transform_translate(&pose, v[0]);
        qtri_transform_rotate(&pose, random_in(&seed, 0, Q16(360)), v[2]);
        qtri_transform_scale(&pose, v[1]);
        mesh.origin = v[2];
        qtri_illumination_init(&by, &view, &pose, NULL, &mesh);
        if (by.even) {
            continue;
        }
        double reach = 0, unit = 0, most = 0;
        for (int row = 0; row < 3; row++) {
            const qtri_row16 *r = &by.row.compact[row];
            double all = fabs(qtri_row16_translation(r) / 2.0);
            for (int i = 0; i < 3; i++) {
                const int32_t m = qtri_row16_coefficient(r, i);
                const double truth = of_row(&pose.row[row], i) * real(mesh.extent);
                assert_int_equal(m & 3, 0);
                all += fabs(m / 2.0);
                if (fabs(truth) > most) { /* 65536 m / 2^16 is of the whole extent, not of 2^15 */
                    most = fabs(truth);
                    unit = most / fabs(m / 2.0);
                }
            }
            reach = fmax(reach, all);
#if QTRI_LONG_MULTIPLY
            assert_int_equal(r->t_q16 & 0x3FFFF, 0);
#endif
        }
        assert_true(reach > (1 << 27) - 8 && reach <= (1 << 28) + 8);
        unit = exp2(round(log2(unit)));
        for (int k = 0; k < 8; k++) {
            const int32_t at[3] = {random_in(&seed, -32768, 32767), random_in(&seed, -32768, 32767),
                                   random_in(&seed, -32768, 32767)};
            const double p[3] = {real(v[2].x) + real(mesh.extent) * at[0] / 32768,
                                 real(v[2].y) + real(mesh.extent) * at[1] / 32768,
                                 real(v[2].z) + real(mesh.extent) * at[2] / 32768};
            for (int row = 0; row < 3; row++) {
                double wanted = ldexp((double)pose.row[row].t, -pose.row[row].exponent - 16);
                for (int i = 0; i < 3; i++) {
                    wanted += of_row(&pose.row[row], i) * p[i];
                }
                const int32_t is = qtri_row16_sum(&by.row.compact[row], at[0], at[1], at[2]);
                worst = fmax(worst, fabs(is - wanted / unit));
            }
        }
        uneven++;
    }
    print_message("%d poses, places within %.3f units\n", uneven, worst);
    assert_true(uneven > 2000);
    assert_true(worst < 5);
}

/* A point is seen up to a pixel beside the viewport and not half a pixel further; depths, to 1/16.
 */
TEST(views_end_a_pixel_beside)
{
    enum { SIDE = 64, PIXEL = 2 * 65536 / SIDE };
    static const int32_t end[3][2] = {
        {Q16_ONE + PIXEL, PIXEL / 4}, {Q16_ONE + PIXEL, PIXEL / 4}, {Q16_ONE, Q16_ONE / 16}};
    qtri_view view;
    qtri_transform pose;
    start_view(&view, &pose, SIDE, SIDE);
    for (int axis = 0; axis < 3; axis++) {
        for (int side = -1; side <= 1; side += 2) {
            for (int further = -1; further <= 1; further += 2) {
                int32_t at[3] = {0, 0, 0};
                at[axis] = side * (end[axis][0] + further * end[axis][1]);
                const qtri_box point = {{at[0], at[1], at[2]}, {0, 0, 0}};
                assert_int_equal(qtri_view_sees_box(&view, &pose, &point), further < 0);
            }
        }
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
