/* SPDX-License-Identifier: MIT */
/*
 * Direct3D's builders against its documentation's formulae, and the same picture, light included,
 * from both conventions.
 */
#include "support/faces.h"
#include "support/transform.h"

/* D3DXMatrixLookAtLH, for column vectors. */
static matrix looking(qtri_vec3 eye, qtri_vec3 at, qtri_vec3 up)
{
    double e[3];
    double axis[3][3];
    double u[3];
    doubles(e, eye);
    doubles(axis[2], at);
    doubles(u, up);
    for (int i = 0; i < 3; i++) {
        axis[2][i] -= e[i];
    }
    normalize(axis[2]);
    cross(axis[0], u, axis[2]);
    normalize(axis[0]);
    cross(axis[1], axis[2], axis[0]);
    matrix a = identity();
    for (int i = 0; i < 3; i++) {
        a.m[i][3] = 0;
        for (int j = 0; j < 3; j++) {
            a.m[i][j] = axis[i][j];
            a.m[i][3] -= axis[i][j] * e[j];
        }
    }
    return a;
}

TEST(cameras)
{
    double worst = 0;
    uint64_t seed = 1;
    for (int n = 0; n < 2000; n++) {
        const qtri_vec3 eye = random_vec3(&seed, 20);
        const qtri_vec3 at = random_vec3(&seed, 20);
        const qtri_vec3 up = random_vec3(&seed, 20);
        qtri_transform t;
        qtri_transform_identity(&t);
        qtri_transform_look_at_d3d(&t, eye, at, up);
        const matrix exact = looking(eye, at, up);
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 4; j++) {
                worst = fmax(worst, fabs(element(&t, i, j) - exact.m[i][j]));
            }
        }
    }
    print_message("cameras off by %.2g\n", worst);
    assert_true(worst < 1e-6);
}

/* Clip z in 0..w as the documentation has it is 2 z - w here. */
TEST(projections)
{
    uint64_t seed = 2;
    for (int n = 0; n < 2000; n++) {
        const q16 l = random_in(&seed, -Q16(4), -100);
        const q16 r = random_in(&seed, 100, Q16(4));
        const q16 b = random_in(&seed, -Q16(4), -100);
        const q16 t = random_in(&seed, 100, Q16(4));
        const q16 near_z = random_in(&seed, Q16(.1), Q16(2));
        const q16 far_z = near_z + random_in(&seed, Q16(1), Q16(200));
        const double width = real(r) - real(l);
        const double height = real(t) - real(b);
        const double zn = real(near_z);
        const double zf = real(far_z);
        const bool is_ortho = n % 2 != 0;
        matrix exact = {{{0}}};
        if (is_ortho) {
            exact.m[0][0] = 2 / width;
            exact.m[0][3] = -(real(l) + real(r)) / width;
            exact.m[1][1] = 2 / height;
            exact.m[1][3] = -(real(t) + real(b)) / height;
            exact.m[2][2] = 2 / (zf - zn);
            exact.m[2][3] = 2 * zn / (zn - zf) - 1;
            exact.m[3][3] = 1;
        } else {
            exact.m[0][0] = 2 * zn / width;
            exact.m[0][2] = -(real(l) + real(r)) / width;
            exact.m[1][1] = 2 * zn / height;
            exact.m[1][2] = -(real(t) + real(b)) / height;
            exact.m[2][2] = 2 * zf / (zf - zn) - 1;
            exact.m[2][3] = 2 * zn * zf / (zn - zf);
            exact.m[3][2] = 1;
        }
        qtri_transform got;
        qtri_transform_identity(&got);
        if (is_ortho) {
            qtri_transform_ortho_d3d(&got, l, r, b, t, near_z, far_z);
        } else {
            qtri_transform_frustum_d3d(&got, l, r, b, t, near_z, far_z);
        }
        assert_true(error_of(&got, &exact, &exact) <= 1.01);
    }
}

static qtri_vec3 mirrored(qtri_vec3 v)
{
    v.z = -v.z;
    return v;
}

static void set_lights(qtri_light_source sources[2], bool is_mirrored)
{
    static const qtri_light_source given[2] = {{.kind = &qtri_point_light,
                                                .position = {Q16(1), Q16(2), Q16(2)},
                                                .color = {Q16(1), Q16(.7), Q16(.5)},
                                                .constant = Q16(1)},
                                               {.kind = &qtri_directional_light,
                                                .position = {Q16(-1), Q16(1), Q16(.5)},
                                                .color = {Q16(.3), Q16(.3), Q16(.5)}}};
    for (int i = 0; i < 2; i++) {
        sources[i] = given[i];
        sources[i].position = is_mirrored ? mirrored(given[i].position) : given[i].position;
    }
}

/* A world mirrored in z, seen by mirrored builders, looks the same. */
TEST(same_picture)
{
    static faces_mesh m;
    uint64_t seed = 4;
    for (int n = 0; n < 60; n++) {
        faces_mesh_make(&m, &seed, 0);
        canvas c[2] = {canvas_new(&qtri_xrgb8888, 64, 48), canvas_new(&qtri_xrgb8888, 64, 48)};
        const qtri_vec3 eye = vec3_of(faces_random(&seed, -2, 2), faces_random(&seed, -2, 2), 5);
        const qtri_vec3 up = {0, Q16_ONE, 0};
        qtri_shininess table;
        qtri_shininess_init(&table, Q16(10));
        const qtri_reflection reflection = {.specular = {255, 255, 255}, .shininess = &table};
        for (int i = 0; i < 2; i++) {
            const bool d3d = i == 1;
            const qtri_light_color ambient = {6000, 6000, 6000};
            qtri_light_source sources[2];
            qtri_light lights;
            qtri_view view;
            qtri_transform pose;
            set_lights(sources, d3d);
            assert_ok(qtri_light_init(&lights, sources, 2, ambient));
            start_view(&view, &pose, 64, 48);
            view.light = &lights;
            if (d3d) {
                const qtri_vec3 factor = {Q16_ONE, Q16_ONE, -Q16_ONE};
                qtri_transform_scale(&pose, factor);
                qtri_transform_look_at_d3d(&view.camera, mirrored(eye), mirrored(m.wide.origin),
                                           up);
            } else {
                qtri_transform_look_at(&view.camera, eye, m.wide.origin, up);
            }
            if (n % 2 != 0 && d3d) {
                qtri_transform_ortho_d3d(&view.projection, Q16(-3), Q16(3), Q16(-2), Q16(2),
                                         Q16(.5), Q16(20));
            } else if (n % 2 != 0) {
                qtri_transform_ortho(&view.projection, Q16(-3), Q16(3), Q16(-2), Q16(2), Q16(.5),
                                     Q16(20));
            } else if (d3d) {
                qtri_transform_perspective_d3d(&view.projection, Q16(50), Q16(1.5), Q16(.5),
                                               Q16(20));
            } else {
                qtri_transform_perspective(&view.projection, Q16(50), Q16(1.5), Q16(.5), Q16(20));
            }
            qtri_material material = qtri_material_default();
            material.reflection = &reflection;
            qtri_draw_mesh(&c[i].surface, &view, &pose, &m.wide, &material);
        }
        int drawn = 0;
        int other = 0;
        for (int32_t i = 0; i < 64 * 48; i++) {
            const uint32_t a = stored_pixel(&c[0].surface, i % 64, i / 64);
            const uint32_t b = stored_pixel(&c[1].surface, i % 64, i / 64);
            drawn += a != 0;
            for (int shift = 0; shift < 24; shift += 8) { /* directions are rounded down */
                other += abs((int)(a >> shift & 255) - (int)(b >> shift & 255)) > 1;
            }
            assert_true((a != 0) == (b != 0));
            assert_int_equal(stored_depth(&c[0].surface, i % 64, i / 64),
                             stored_depth(&c[1].surface, i % 64, i / 64));
        }
        assert_true(drawn > 10);
        assert_int_equal(other, 0);
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
}

/* One of six: perspective, frustum, ortho, and Direct3D's. */
static void project_by(qtri_transform *t, int form, q16 near_z, q16 far_z)
{
    switch (form) {
    case 0:
        qtri_transform_perspective(t, Q16(50), Q16(1.5), near_z, far_z);
        break;
    case 1:
        qtri_transform_perspective_d3d(t, Q16(50), Q16(1.5), near_z, far_z);
        break;
    case 2: /* that of near = .5: a frustum's sides are those at near_z */
        qtri_transform_frustum(t, near_z * -2 / 3, near_z * 2 / 3, near_z / -2, near_z / 2, near_z,
                               far_z);
        break;
    case 3:
        qtri_transform_frustum_d3d(t, near_z * -2 / 3, near_z * 2 / 3, near_z / -2, near_z / 2,
                                   near_z, far_z);
        break;
    case 4:
        qtri_transform_ortho(t, Q16(-3), Q16(3), Q16(-2), Q16(2), near_z, far_z);
        break;
    default:
        qtri_transform_ortho_d3d(t, Q16(-3), Q16(3), Q16(-2), Q16(2), near_z, far_z);
        break;
    }
}

/* near beyond far: "greater" after a clear to 0 draws what "less" after one to 65535 does. */
TEST(depth_reversed)
{
    static faces_mesh m;
    uint64_t seed = 5;
    int pixels = 0;
    int differ = 0;
    for (int n = 0; n < 60; n++) {
        faces_mesh_make(&m, &seed, 0);
        canvas c[2] = {canvas_new(&qtri_xrgb8888, 64, 48), canvas_new(&qtri_xrgb8888, 64, 48)};
        for (int i = 0; i < 2; i++) {
            const qtri_vec3 eye = {0, 0, n % 2 != 0 ? Q16(-5) : Q16(5)};
            const qtri_vec3 up = {0, Q16_ONE, 0};
            const qtri_rgb black = {0, 0, 0};
            qtri_view view;
            qtri_transform pose;
            qtri_material material = qtri_material_default();
            start_view(&view, &pose, 64, 48);
            if (n % 2 != 0) {
                qtri_transform_look_at_d3d(&view.camera, eye, m.wide.origin, up);
            } else {
                qtri_transform_look_at(&view.camera, eye, m.wide.origin, up);
            }
            project_by(&view.projection, n % 6, i == 0 ? Q16(.5) : Q16(20),
                       i == 0 ? Q16(20) : Q16(.5));
            material.depth_compare = i == 0 ? QTRI_LESS : QTRI_GREATER;
            clear_to(&c[i].surface, black, i == 0 ? 65535 : 0);
            qtri_draw_mesh(&c[i].surface, &view, &pose, &m.wide, &material);
        }
        for (int32_t i = 0; i < 64 * 48; i++) {
            const uint32_t a = stored_pixel(&c[0].surface, i % 64, i / 64);
            const uint32_t b = stored_pixel(&c[1].surface, i % 64, i / 64);
            const int depths = stored_depth(&c[0].surface, i % 64, i / 64) +
                               stored_depth(&c[1].surface, i % 64, i / 64);
            pixels += a != 0;
            differ += a != b || abs(depths - 65535) > 2;
        }
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
    print_message("%d of %d pixels differ\n", differ, pixels);
    assert_true(pixels > 10000);
    assert_true(differ * 1000 < pixels); /* triangles as far as each other, steep ones */
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
