/* SPDX-License-Identifier: MIT */
/*
 * Computed meshes and what encloses them: closed, outwards, round; and what a view sees.
 */
#include "support/transform.h"

#include <qtri/mesh.h>
#include <qtri/shapes.h>

enum { VERTICES = 2000, TRIANGLES = 4000 };

static qtri_vec3 positions[VERTICES];
static qtri_normal normals[VERTICES];
static qtri_vec2 uvs[VERTICES];
static uint16_t triangles[TRIANGLES][3];
static const qtri_shape_memory memory = {positions, normals, uvs, triangles, VERTICES, TRIANGLES};

typedef struct made {
    qtri_mesh mesh;
    enum qtri_error error;
} made;

enum { BOX, SPHERE, CYLINDER, CONE, TORUS, GRID, KINDS };

static made make(int kind, const qtri_shape_memory *m, q16 a, q16 b, int32_t n, int32_t k)
{
    made r;
    const qtri_vec3 half = {a, b, a};
    r.error = kind == BOX        ? qtri_shape_box(&r.mesh, m, half)
              : kind == SPHERE   ? qtri_shape_sphere(&r.mesh, m, a, n, k)
              : kind == CYLINDER ? qtri_shape_cylinder(&r.mesh, m, a, b, n)
              : kind == CONE     ? qtri_shape_cone(&r.mesh, m, a, b, n)
              : kind == TORUS    ? qtri_shape_torus(&r.mesh, m, a, b, n, k)
                                 : qtri_shape_grid(&r.mesh, m, a, b, n, k);
    return r;
}

static uint32_t vertices_of(int kind, int32_t n, int32_t k)
{
    const int32_t count[KINDS] = {QTRI_BOX_VERTICES,         QTRI_SPHERE_VERTICES(n, k),
                                  QTRI_CYLINDER_VERTICES(n), QTRI_CONE_VERTICES(n),
                                  QTRI_TORUS_VERTICES(n, k), QTRI_GRID_VERTICES(n, k)};
    return (uint32_t)count[kind];
}

static uint32_t triangles_of(int kind, int32_t n, int32_t k)
{
    const int32_t count[KINDS] = {QTRI_BOX_TRIANGLES,         QTRI_SPHERE_TRIANGLES(n, k),
                                  QTRI_CYLINDER_TRIANGLES(n), QTRI_CONE_TRIANGLES(n),
                                  QTRI_TORUS_TRIANGLES(n, k), QTRI_GRID_TRIANGLES(n, k)};
    return (uint32_t)count[kind];
}

static bool is_same_place(uint32_t a, uint32_t b)
{
    return memcmp(&positions[a], &positions[b], sizeof positions[0]) == 0;
}

/* Every side has one on the other side of it, but for the grid's border. */
static void assert_closed(const qtri_mesh *mesh)
{
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        for (int e = 0; e < 3; e++) {
            const uint32_t a = mesh->triangles[i][e];
            const uint32_t b = mesh->triangles[i][(e + 1) % 3];
            int others = 0;
            for (uint32_t j = 0; j < mesh->triangle_count; j++) {
                for (int f = 0; f < 3; f++) {
                    others += is_same_place(mesh->triangles[j][f], b) &&
                              is_same_place(mesh->triangles[j][(f + 1) % 3], a);
                }
            }
            assert_int_equal(others, 1);
        }
    }
}

/* Faces look where their corners' normals look, and are not degenerate. Normals are 1 long. */
static void assert_outwards(const qtri_mesh *mesh)
{
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        double p[3][3];
        double n[3] = {0, 0, 0};
        double face[3];
        for (int c = 0; c < 3; c++) {
            const uint32_t v = mesh->triangles[i][c];
            assert_true(v < mesh->vertex_count);
            doubles(p[c], positions[v]);
            const double m[3] = {normals[v].x / 16384.0, normals[v].y / 16384.0,
                                 normals[v].z / 16384.0};
            assert_near(sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]), 1, 2e-4);
            for (int k = 0; k < 3; k++) {
                n[k] += m[k];
            }
        }
        for (int k = 0; k < 3; k++) {
            p[1][k] -= p[0][k];
            p[2][k] -= p[0][k];
        }
        cross(face, p[1], p[2]);
        assert_true(normalize(face) > 0);
        (void)normalize(n);
        assert_true(face[0] * n[0] + face[1] * n[1] + face[2] * n[2] > .4);
    }
}

TEST(meshes)
{
    static const int32_t counts[][2] = {{3, 3}, {4, 3}, {5, 7}, {12, 6}, {17, 9}};
    for (int n = 0; n < KINDS * 5; n++) {
        const int kind = n % KINDS;
        const int32_t slices = counts[n / KINDS][0];
        const int32_t rows = counts[n / KINDS][1];
        const q16 a = Q16(2.5);
        const q16 b = Q16(0.75);
        const made r = make(kind, &memory, a, b, slices, rows);
        assert_ok(r.error);
        assert_int_equal(r.mesh.vertex_count, vertices_of(kind, slices, rows));
        assert_int_equal(r.mesh.triangle_count, triangles_of(kind, slices, rows));
        assert_outwards(&r.mesh);
        if (kind != GRID) {
            assert_closed(&r.mesh);
        }
        for (uint32_t i = 0; i < r.mesh.vertex_count; i++) {
            double p[3];
            doubles(p, positions[i]);
            const double around = hypot(p[0], p[2]);
            const double ulp = (1 + 2.5 + .75) / 65536;
            if (kind == SPHERE) {
                assert_near(hypot(around, p[1]), 2.5, ulp);
            } else if (kind == TORUS) {
                assert_near(hypot(around - 2.5, p[1]), .75, ulp);
            } else if (kind == CYLINDER || kind == CONE) {
                assert_true(around == 0 || fabs(around - 2.5) <= ulp);
                assert_true(fabs(p[1]) == .75);
            }
            assert_true(uvs[i].x >= 0 && uvs[i].x <= Q16_ONE && uvs[i].y >= 0 &&
                        uvs[i].y <= Q16_ONE);
        }
    }
}

TEST(errors)
{
    qtri_shape_memory m = memory;
    for (int kind = 0; kind < KINDS; kind++) {
        m.vertices = vertices_of(kind, 8, 5) - 1;
        m.triangle_count = TRIANGLES;
        made r = make(kind, &m, Q16(1), Q16(1), 8, 5);
        assert_int_equal(r.error, QTRI_ERROR_MEMORY);
        assert_int_equal(r.mesh.triangle_count, 0);
        m.vertices = VERTICES;
        m.triangle_count = triangles_of(kind, 8, 5) - 1;
        r = make(kind, &m, Q16(1), Q16(1), 8, 5);
        assert_int_equal(r.error, QTRI_ERROR_MEMORY);
        static const int32_t bad[] = {INT32_MIN, -1, 0, 1025, INT32_MAX};
        for (size_t i = 0; i < LENGTH_OF(bad) && kind != BOX; i++) {
            assert_int_equal(make(kind, &memory, 1, 1, bad[i], 5).error, QTRI_ERROR_SIZE);
            if (kind != CYLINDER && kind != CONE) {
                assert_int_equal(make(kind, &memory, 1, 1, 5, bad[i]).error, QTRI_ERROR_SIZE);
                assert_int_equal(make(kind, &memory, 1, 1, 1024, 1024).error, QTRI_ERROR_SIZE);
            }
        }
    }
    /* The fewest that have a shape, and one less. */
    static const int32_t least[KINDS][2] = {{0, 0}, {3, 2}, {3, 0}, {3, 0}, {3, 3}, {1, 1}};
    for (int kind = SPHERE; kind < KINDS; kind++) {
        const int32_t n = least[kind][0];
        const int32_t k = least[kind][1];
        assert_ok(make(kind, &memory, 1, 1, n, k).error);
        assert_int_equal(make(kind, &memory, 1, 1, n - 1, k).error, QTRI_ERROR_SIZE);
        if (k > 0) {
            assert_int_equal(make(kind, &memory, 1, 1, n, k - 1).error, QTRI_ERROR_SIZE);
        }
    }
    /* Any size has a result; without room for normals there are none. */
    uint64_t seed = 31;
    m = memory;
    m.normals = NULL;
    m.uvs = NULL;
    for (int n = 0; n < 3000; n++) {
        const made r =
            make(n % KINDS, n & 64 ? &m : &memory, random_any(&seed), random_any(&seed), 7, 4);
        assert_ok(r.error);
    }
}

/* ---- Bounds ---- */

static double distance(const qtri_vec3 *a, const double b[3])
{
    const double d[3] = {real(a->x) - b[0], real(a->y) - b[1], real(a->z) - b[2]};
    return sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
}

TEST(bounds)
{
    uint64_t seed = 32;
    enum { COUNT = 40 };
    for (int n = 0; n < 4000; n++) {
        qtri_vec3 wide[COUNT];
        qtri_position16 compact[COUNT];
        qtri_mesh mesh = {0};
        mesh.vertex_count = (uint32_t)random_in(&seed, 1, COUNT);
        const int bits = random_in(&seed, 0, n % 7 == 0 ? 30 : 24);
        mesh.origin = random_vec3(&seed, bits);
        mesh.extent = random_in(&seed, 0, (int32_t)1 << bits);
        for (uint32_t i = 0; i < mesh.vertex_count; i++) {
            wide[i] = random_vec3(&seed, bits);
            const qtri_position16 p = {(int16_t)random_in(&seed, -32767, 32767),
                                       (int16_t)random_in(&seed, -32767, 32767),
                                       (int16_t)random_in(&seed, -32767, 32767)};
            compact[i] = p;
        }
        mesh.positions = wide;
        mesh.positions16 = n % 2 ? compact : NULL;
        const qtri_box box = qtri_mesh_box(&mesh);
        const qtri_ball ball = qtri_mesh_ball(&mesh);
        double low[3] = {1e9, 1e9, 1e9};
        double high[3] = {-1e9, -1e9, -1e9};
        double most = 0;
        for (uint32_t i = 0; i < mesh.vertex_count; i++) {
            double p[3];
            doubles(p, wide[i]);
            if (n % 2) {
                p[0] = real(mesh.origin.x) + real(mesh.extent) * compact[i].x / 32768;
                p[1] = real(mesh.origin.y) + real(mesh.extent) * compact[i].y / 32768;
                p[2] = real(mesh.origin.z) + real(mesh.extent) * compact[i].z / 32768;
            }
            for (int k = 0; k < 3; k++) {
                low[k] = fmin(low[k], p[k]);
                high[k] = fmax(high[k], p[k]);
            }
            most = fmax(most, distance(&ball.center, p));
        }
        const q16 center[3] = {box.center.x, box.center.y, box.center.z};
        const q16 half[3] = {box.half.x, box.half.y, box.half.z};
        for (int k = 0; k < 3; k++) {
            const double step = 1 / 65536.0;
            assert_true(real(center[k]) - real(half[k]) <= low[k]);
            assert_true(real(center[k]) + real(half[k]) >= high[k]);
            assert_true(real(center[k]) - real(half[k]) >= low[k] - (n % 2 ? 3 : 1.01) * step);
            assert_true(real(center[k]) + real(half[k]) <= high[k] + (n % 2 ? 3 : 1.01) * step);
        }
        assert_true(real(ball.radius) >= most || ball.radius == Q16_MAX);
        assert_true(real(ball.radius) <= most + 12 / 65536.0);
    }
    const qtri_mesh none = {0};
    const qtri_ball ball = qtri_mesh_ball(&none);
    const qtri_box box = qtri_mesh_box(&none);
    assert_int_equal(ball.radius | box.half.x | box.center.y, 0);
}

/* What is drawn is seen; what is far outside is not. */
TEST(seeing)
{
    uint64_t seed = 33;
    int unseen = 0;
    int drawn = 0;
    enum { WIDTH = 48, HEIGHT = 36 };
    const made r = make(SPHERE, &memory, Q16(1), 0, 8, 5);
    const qtri_box box = qtri_mesh_box(&r.mesh);
    const qtri_ball ball = qtri_mesh_ball(&r.mesh);
    for (int n = 0; n < 1500; n++) {
        canvas c = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
        qtri_view view;
        qtri_transform pose;
        qtri_view_init(&view, WIDTH, HEIGHT);
        qtri_transform_perspective(&view.projection, Q16(60), Q16(1.3333), Q16(.5), Q16(40));
        qtri_transform_orbit(&view.camera, vec3_of(0, 0, 0), Q16(6), random_angle(&seed),
                             random_angle(&seed));
        qtri_transform_identity(&pose);
        qtri_transform_translate(&pose, random_vec3(&seed, 20));
        qtri_transform_rotate_x(&pose, random_angle(&seed));
        qtri_material material = qtri_material_default();
        material.color.r = 255;
        qtri_draw_mesh(&c.surface, &view, &pose, &r.mesh, &material);
        bool any = false;
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            any |= stored_depth(&c.surface, i % WIDTH, i / WIDTH) != 65535;
        }
        const bool is_seen = qtri_view_sees_box(&view, &pose, &box);
        assert_true(is_seen || !any);
        assert_true(qtri_view_sees_ball(&view, &pose, &ball) || !any);
        unseen += !is_seen;
        drawn += any;
        canvas_free(&c);
    }
    print_message("%d drawn, %d known to be unseen, of 1500\n", drawn, unseen);
    assert_true(unseen > (1500 - drawn) * 3 / 4);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
