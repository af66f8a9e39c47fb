/* SPDX-License-Identifier: MIT */
/*
 * The vertex stage of meshes: the fast way, the exact way and the code for small cores give the
 * same bits; 16-bit positions and normals are as good as they claim.
 */
#include "support/core.h"

#include "geometry/lighting.h"
#include "geometry/projector.h"
#include "support/vertex_narrow.h"

enum { POINTS = 64 };

/* Any view of any size; every fourth one exact, so that points lie halfway between grid points. */
static void random_transform(qtri_transform *t, qtri_viewport *viewport, uint64_t *seed)
{
    qtri_transform_identity(t);
    *viewport = qtri_viewport_top(random_in(seed, -9000, 9000), random_in(seed, -300, 300),
                                  random_in(seed, 0, 9000), random_in(seed, 1, 1000));
    if (random_flag(seed)) {
        *viewport = qtri_viewport_top(0, 0, 320, 240);
    }
    if (random_in(seed, 0, 7) == 0) {
        viewport->depth_near = random_in(seed, 0, 65536);
        viewport->depth_far = random_in(seed, 0, 65536);
    }
    qtri_vec3 eye = {random_any(seed), random_any(seed), random_any(seed)};
    qtri_vec3 origin = {0, 0, 0};
    qtri_vec3 up = {0, Q16_ONE, 0};
    qtri_mat4 m;
    switch (random_in(seed, 0, 4)) {
    case 0:
        break;
    case 1:
        for (int i = 0; i < 16; i++) {
            m.m[i / 4][i % 4] = random_any(seed);
        }
        qtri_transform_from_mat4(t, &m);
        break;
    case 2:
        qtri_transform_ortho(t, Q16(-2), Q16(2), Q16(-1.5), Q16(1.5), Q16(-8), Q16(8));
        break;
    default:
        eye.x = random_in(seed, -300000, 300000);
        eye.y = random_in(seed, -300000, 300000);
        eye.z = random_in(seed, -300000, 300000);
        qtri_transform_perspective(t, Q16(60), Q16(1.3333333), Q16(0.1), Q16(100));
        qtri_transform_look_at(t, eye, origin, up);
        qtri_transform_rotate_y(t, random_any(seed));
        break;
    }
}

static bool same(const qtri_vertex *a, const qtri_vertex *b)
{
    return a->at.x_24p8 == b->at.x_24p8 && a->at.y_24p8 == b->at.y_24p8 &&
           a->depth_16p8 == b->depth_16p8 && a->inv_w == b->inv_w &&
           a->intensity_q15 == b->intensity_q15;
}

static void assert_same(const qtri_vertex *a, const qtri_vertex *b)
{
    if (!same(a, b)) {
        fail_msg("%d %d %08x %08x, not %d %d %08x %08x", (int)a->at.x_24p8, (int)a->at.y_24p8,
                 (unsigned)a->depth_16p8, (unsigned)a->inv_w, (int)b->at.x_24p8, (int)b->at.y_24p8,
                 (unsigned)b->depth_16p8, (unsigned)b->inv_w);
    }
}

static unsigned is_inside(const qtri_vertex *v)
{
    return (v->depth_16p8 & QTRI_VERTEX_OUTSIDE) == 0;
}

TEST(wide_positions)
{
    uint64_t seed = 51;
    unsigned seen = 0;
    for (int n = 0; n < repeats(40000); n++) {
        qtri_transform t;
        qtri_viewport viewport;
        qtri_projector projector;
        qtri_vec3 p[POINTS];
        qtri_vertex fast[POINTS];
        qtri_vertex narrow[POINTS];
        bool inside = true;
        int32_t reach = random_in(&seed, 1, 31);
        random_transform(&t, &viewport, &seed);
        qtri_projector_init(&projector, &t, &viewport);
        for (int i = 0; i < POINTS; i++) {
            p[i].x = random_bits32(&seed) >> (32 - reach);
            p[i].y = random_bits32(&seed) >> (32 - reach);
            p[i].z = random_bits32(&seed) >> (32 - random_in(&seed, 1, reach));
            if (n % 4 == 0) {
                p[i].x &= ~63;
                p[i].y &= ~63;
            }
        }
        bool told = qtri_projector_vertices(&projector, p, POINTS, fast, false);
        narrow_vertices(&t, &viewport, p, POINTS, narrow);
        for (int i = 0; i < POINTS; i++) {
            qtri_clip_vertex clip;
            qtri_vertex exact;
            qtri_projector_point(&projector, &p[i], &clip);
            qtri_vertex_exact(&projector, &clip, &exact);
            assert_same(&fast[i], &exact);
            assert_same(&narrow[i], &exact);
            inside &= is_inside(&exact);
            seen += is_inside(&exact);
        }
        assert_int_equal(told, inside);
    }
    print_message("%u vertices inside\n", seen);
    assert_true(seen > (unsigned)random_cases(500000));
}

/* Corners at w = 1 are points as a mesh has them, whatever is with them in a triangle. */
TEST(corners_are_points)
{
    uint64_t seed = 55;
    for (int n = 0; n < repeats(200000); n++) {
        qtri_transform t;
        qtri_viewport viewport;
        qtri_projector projector;
        qtri_clip_vertex corner[3];
        qtri_vec4 p[3];
        const qtri_vec4 *const from[3] = {&p[0], &p[1], &p[2]};
        random_transform(&t, &viewport, &seed);
        qtri_projector_init(&projector, &t, &viewport);
        for (int i = 0; i < 3; i++) {
            const qtri_vec4 at = {random_any(&seed), random_any(&seed), random_any(&seed), Q16_ONE};
            p[i] = at;
        }
        qtri_projector_points(&projector, from, 3, corner);
        for (int i = 0; i < 3; i++) {
            const qtri_vec3 at = {p[i].x, p[i].y, p[i].z};
            qtri_clip_vertex clip;
            qtri_vertex exact;
            qtri_vertex fast;
            qtri_projector_point(&projector, &at, &clip);
            assert_true(clip.x == corner[i].x && clip.y == corner[i].y);
            assert_true(clip.z == corner[i].z && clip.w == corner[i].w);
            qtri_vertex_exact(&projector, &corner[i], &exact);
            (void)qtri_projector_vertices(&projector, &at, 1, &fast, false);
            assert_same(&fast, &exact);
        }
    }
}

static qtri_position16 random_position16(uint64_t *seed, int n)
{
    qtri_position16 p = {(int16_t)random64(seed), (int16_t)random64(seed), (int16_t)random64(seed)};
    if (n % 4 == 0) {
        p.x &= ~127;
        p.y &= ~127;
        p.z >>= n / 4 % 16;
    }
    return p;
}

TEST(compact_positions)
{
    uint64_t seed = 52;
    unsigned seen = 0;
    for (int n = 0; n < repeats(40000); n++) {
        qtri_transform t;
        qtri_viewport viewport;
        qtri_projector projector;
        qtri_position16 p[POINTS];
        qtri_vertex fast[POINTS];
        qtri_vertex narrow[POINTS];
        bool inside = true;
        qtri_vec3 origin = {random_any(&seed), random_any(&seed), random_any(&seed)};
        q16 extent = random_any(&seed);
        if (n % 8 < 3) {
            qtri_vec3 none = {0, 0, 0};
            origin = none;
            extent = (int32_t)1 << random_in(&seed, 10, 18);
        }
        random_transform(&t, &viewport, &seed);
        qtri_projector_init(&projector, &t, &viewport);
        qtri_projector_compact(&projector, &origin, extent);
        for (int i = 0; i < POINTS; i++) {
            p[i] = random_position16(&seed, n);
        }
        bool told = qtri_projector_vertices16(&projector, p, POINTS, fast, false);
        narrow_vertices16(&t, &viewport, &origin, extent, p, POINTS, narrow);
        for (int i = 0; i < POINTS; i++) {
            qtri_clip_vertex clip;
            qtri_vertex exact;
            qtri_projector_point16(&projector, &p[i], &clip);
            qtri_vertex_exact(&projector, &clip, &exact);
            if (is_inside(&exact)) {
                exact.depth_16p8 -= (uint32_t)(32 - projector.shift[3]);
            }
            assert_same(&fast[i], &exact);
            assert_same(&narrow[i], &exact);
            inside &= is_inside(&exact);
            seen += is_inside(&exact);
        }
        assert_int_equal(told, inside);
    }
    print_message("%u vertices inside\n", seen);
    assert_true(seen > (unsigned)random_cases(500000));
}

static unsigned max_of(unsigned a, unsigned b)
{
    return a > b ? a : b;
}

/* 16-bit positions that are Q16.16 numbers: the same vertices but for a rounding in 2^28. */
TEST(compact_is_exact_enough)
{
    uint64_t seed = 53;
    unsigned seen = 0;
    unsigned moved = 0;
    unsigned deeper = 0;
    for (int n = 0; n < 20000; n++) {
        qtri_transform t;
        qtri_viewport viewport = qtri_viewport_top(0, 0, 320, 240);
        qtri_projector wide;
        qtri_projector compact;
        qtri_vec3 eye = {random_in(&seed, -200000, 200000), random_in(&seed, -200000, 200000),
                         200000};
        qtri_vec3 origin = {random_in(&seed, -40000, 40000), random_in(&seed, -40000, 40000), 77};
        qtri_vec3 up = {0, Q16_ONE, 0};
        int32_t scale = (int32_t)1 << random_in(&seed, 0, 3);
        qtri_transform_identity(&t);
        qtri_transform_perspective(&t, Q16(60), Q16(1.3333333), Q16(0.1), Q16(100));
        qtri_transform_look_at(&t, eye, origin, up);
        qtri_transform_rotate_y(&t, random_any(&seed));
        qtri_projector_init(&wide, &t, &viewport);
        compact = wide;
        qtri_projector_compact(&compact, &origin, 32768 * scale);
        for (int i = 0; i < POINTS; i++) {
            qtri_position16 p16 = random_position16(&seed, 1);
            qtri_vec3 p = {origin.x + scale * p16.x, origin.y + scale * p16.y,
                           origin.z + scale * p16.z};
            qtri_vertex a;
            qtri_vertex b;
            qtri_projector_vertices(&wide, &p, 1, &a, false);
            qtri_projector_vertices16(&compact, &p16, 1, &b, false);
            if (is_inside(&a) && is_inside(&b) && abs(a.at.x_24p8 - 160 * 256) < 400 * 256 &&
                abs(a.at.y_24p8 - 120 * 256) < 400 * 256) {
                seen++;
                moved += a.at.x_24p8 != b.at.x_24p8;
                moved += a.at.y_24p8 != b.at.y_24p8;
                assert_true(abs(a.at.x_24p8 - b.at.x_24p8) <= 1);
                assert_true(abs(a.at.y_24p8 - b.at.y_24p8) <= 1);
                deeper = max_of(deeper,
                                (unsigned)abs((int)(a.depth_16p8 >> 8) - (int)(b.depth_16p8 >> 8)));
            }
        }
    }
    print_message("%u vertices: %u coordinates on the other side of a rounding, depth %u / 256\n",
                  seen, moved, deeper);
    assert_true(seen > (unsigned)random_cases(500000));
    assert_true(moved < seen / 1000);
    assert_true(deeper <= 8);
}

/* min(1, ambient + diffuse max(0, n . l)) for a pose that turns nothing. */
static double intensity(const qtri_light *light, const double n[3])
{
    const double l[3] = {light->towards.x, light->towards.y, light->towards.z};
    double size[2] = {0, 0};
    double dot = 0;
    for (int i = 0; i < 3; i++) {
        size[0] += l[i] * l[i];
        size[1] += n[i] * n[i];
        dot += n[i] * l[i];
    }
    double cosine = size[0] * size[1] > 0 ? dot / sqrt(size[0] * size[1]) : 0;
    return fmin(1, real(light->ambient) + real(light->diffuse) * fmax(0, cosine));
}

/* Faces of all sizes, thin ones and none at all; what the error of a colour is, of 255. */
TEST(lights)
{
    uint64_t seed = 54;
    double face_worst = 0;
    double vertex_worst = 0;
    qtri_transform identity;
    qtri_transform_identity(&identity);
    for (int n = 0; n < repeats(300000); n++) {
        qtri_lighting lighting;
        qtri_light light = {.towards = {random_any(&seed), random_any(&seed), random_any(&seed)},
                            .ambient = random_in(&seed, 0, 30000),
                            .diffuse = random_in(&seed, 0, 70000)};
        qtri_position16 p[3];
        int shift = random_in(&seed, 0, 15);
        for (int i = 0; i < 3; i++) {
            p[i] = random_position16(&seed, 1);
            p[i].x >>= shift;
            p[i].y >>= n % 3 == 0 ? shift / 2 : shift;
            p[i].z >>= n % 5 == 0 ? 15 : shift;
        }
        const qtri_vec3 corner[3] = {
            {p[0].x, p[0].y, p[0].z}, {p[1].x, p[1].y, p[1].z}, {p[2].x, p[2].y, p[2].z}};
        double e[3] = {p[1].x - p[0].x, p[1].y - p[0].y, p[1].z - p[0].z};
        double f[3] = {p[2].x - p[0].x, p[2].y - p[0].y, p[2].z - p[0].z};
        double normal[3] = {e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2],
                            e[0] * f[1] - e[1] * f[0]};
        qtri_lighting_init(&lighting, &light, &identity, false, NULL);
        uint32_t face = qtri_lighting_face(&lighting, &corner[0], &corner[1], &corner[2]);
        assert_int_equal(face, narrow_light_face(&light, &identity, corner));
        face_worst = fmax(face_worst, fabs(face / 32768. - intensity(&light, normal)));

        double length = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        qtri_normal unit = {0, 0, 0};
        if (length > 0) {
            unit.x = (int16_t)lrint(normal[0] / length * 16384);
            unit.y = (int16_t)lrint(normal[1] / length * 16384);
            unit.z = (int16_t)lrint(normal[2] / length * 16384);
        }
        const qtri_mesh mesh = {.normals = &unit};
        uint32_t vertex = qtri_light_by_vertex.vertex(&lighting, &mesh, 0);
        assert_int_equal(vertex, narrow_light_vertex(&light, &identity, &unit));
        vertex_worst = fmax(vertex_worst, fabs(vertex / 32768. - intensity(&light, normal)));
    }
    print_message("light: face %.4f, vertex %.4f of 255\n", 255 * face_worst, 255 * vertex_worst);
    assert_true(255 * face_worst <= .02);
    assert_true(255 * vertex_worst <= .03);
}

/* Just beyond 2^15 the products of edges would fill 32 bits. */
TEST(edges_beyond_the_short)
{
    qtri_transform identity;
    qtri_transform_identity(&identity);
    for (int i = 0; i < 6; i++) {
        const int x = i % 3;
        const int y = (x + 1) % 3;
        q16 towards[3] = {0, 0, 0};
        q16 e[3] = {0, 0, 0};
        q16 f[3] = {0, 0, 0};
        towards[3 - x - y] = Q16_ONE;
        e[x] = 32768 + (i < 3);
        e[y] = -32767;
        f[x] = 32768;
        f[y] = 32768 + (i >= 3);
        const qtri_light light = {
            .towards = {towards[0], towards[1], towards[2]}, .ambient = 0, .diffuse = Q16_ONE};
        const qtri_vec3 corner[3] = {{0, 0, 0}, {e[0], e[1], e[2]}, {f[0], f[1], f[2]}};
        qtri_lighting lighting;
        qtri_lighting_init(&lighting, &light, &identity, false, NULL);
        const uint32_t face = qtri_lighting_face(&lighting, &corner[0], &corner[1], &corner[2]);
        assert_in_range(face, QTRI_INTENSITY_ONE - 1, QTRI_INTENSITY_ONE);
    }
}

/* The last bit of light on faces and vertices that are short: others judge it by what is seen. */
TEST(last_bits_of_light)
{
    uint64_t seed = 55;
    uint32_t hash = 2166136261u;
    qtri_transform identity;
    qtri_transform_identity(&identity);
    for (int n = 0; n < 20000; n++) {
        const qtri_light light = {.towards = {random_in(&seed, -65536, 65536),
                                              random_in(&seed, -65536, 65536),
                                              random_in(&seed, -65536, 65536)},
                                  .ambient = random_in(&seed, 0, 30000),
                                  .diffuse = random_in(&seed, 0, 70000)};
        const qtri_face8 face = {(int8_t)random_in(&seed, -100, 100),
                                 (int8_t)random_in(&seed, -100, 100),
                                 (int8_t)random_in(&seed, -100, 100), 0};
        const qtri_normal8 normal = {face.x, face.y, face.z};
        qtri_lighting lighting;
        qtri_lighting_init(&lighting, &light, &identity, false, NULL);
        hash = (hash ^ qtri_lighting_face8(&lighting, &face)) * 16777619u;
        const qtri_mesh mesh = {.normals8 = &normal};
        hash = (hash ^ qtri_light_by_vertex.vertex(&lighting, &mesh, 0)) * 16777619u;
    }
    assert_int_equal(hash, 0xbd7332a8u);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
