/* SPDX-License-Identifier: MIT */
/*
 * Planes of faces: none is culled that would have been drawn, pictures stay as they are, and what
 * the host makes keeps the contract.
 */
#include "support/faces.h"
#include "support/layouts.h"

#include "geometry/cull.h"
#include "geometry/lighting.h"
#include "raster/triangle.h"
#include "support/vertex_narrow.h"

enum { WIDTH = 160, HEIGHT = 120 };

static int max_of(int a, int b)
{
    return a > b ? a : b;
}

/* How noisy the n-th mesh is. */
static double noise_of(int n)
{
    static const double noise[] = {0.0, .002, .01, .05, .2, 1.0};
    return noise[n % (int)LENGTH_OF(noise)];
}

typedef struct tally {
    unsigned poses, used, faces, culled, back;
    double nearest; /* front face, in parts of the bound */
} tally;

/* The mesh's vertices, all of them, by the way that a draw call without planes goes. */
static bool place(const qtri_mesh *mesh, const qtri_projector *wide, const qtri_projector *compact,
                  qtri_vertex *out)
{
    return mesh->positions16 != NULL
               ? qtri_projector_vertices16(compact, mesh->positions16, mesh->vertex_count, out,
                                           false)
               : qtri_projector_vertices(wide, mesh->positions, mesh->vertex_count, out, false);
}

static void check_pose(const qtri_mesh *mesh, const qtri_view *view, const qtri_transform *pose,
                       tally *t)
{
    static qtri_vertex v[FACES_VERTICES];
    qtri_transform clip;
    qtri_projector wide;
    qtri_eye eye;
    qtri_transform_mul(&clip, &view->projection, pose);
    qtri_projector_init(&wide, &clip, &view->viewport);
    qtri_projector compact = wide;
    qtri_projector_compact(&compact, &mesh->origin, mesh->extent);
    const bool found = qtri_eye_find(&eye, &compact, &mesh->faces);
    t->poses++;
    assert_int_equal(found, narrow_eye(&clip, &view->viewport, mesh, &eye));
    if (!found) {
        return;
    }
    t->used++;
    assert_true(place(mesh, &wide, &compact, v)); /* all are inside */
    qtri_eye mirrored = eye;
    qtri_eye_mirror(&mirrored);
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        const uint16_t *index = mesh->triangles[i];
        const qtri_face8 *face = &mesh->faces.planes[i];
        const int64_t area = qtri_triangle_area(&v[index[0]].at, &v[index[1]].at, &v[index[2]].at);
        const int64_t sum = (int64_t)face->x * eye.x + (int64_t)face->y * eye.y +
                            (int64_t)face->z * eye.z + (int64_t)face->d * eye.w;
        assert_in_range(sum + ((int64_t)1 << 31), 0, UINT32_MAX);
        const bool behind = qtri_eye_is_behind(&eye, face);
        const bool before = qtri_eye_is_behind(&mirrored, face);
        if ((behind && area <= 0) || (before && area >= 0)) {
            fail_msg("area %ld, %ld of %ld", (long)area, (long)sum, (long)eye.behind);
        }
        t->faces++;
        t->culled += behind;
        t->back += area >= 0;
        if (area <= 0) {
            t->nearest = fmax(t->nearest, (double)sum / eye.behind);
        }
        if (area >= 0) {
            t->nearest = fmax(t->nearest, -(double)sum / eye.behind);
        }
    }
}

/* Frames of all sizes: snapping counts most in the smallest. */
TEST(culls_no_front_face)
{
    static faces_mesh m;
    static const int32_t sizes[] = {16, 64, 320, 1000, 4000};
    uint64_t seed = 201;
    tally t = {0, 0, 0, 0, 0, 0};
    for (int n = 0; n < repeats(240); n++) {
        faces_mesh_make(&m, &seed, noise_of(n));
        for (int k = 0; k < 20; k++) {
            const qtri_mesh *mesh = k % 2 != 0 ? &m.wide : &m.compact;
            const int32_t size = sizes[random_in(&seed, 0, LENGTH_OF(sizes) - 1)];
            qtri_view view;
            qtri_transform pose;
            faces_view(&view, &seed, size, size * 3 / 4);
            faces_pose(&pose, &seed, mesh);
            check_pose(mesh, &view, &pose, &t);
        }
    }
    print_message("%u poses, by planes %u; of their faces %.1f %% turn away, %.1f %% culled; the "
                  "nearest wrong one is at %.2f of the bound\n",
                  t.poses, t.used, 100.0 * t.back / t.faces, 100.0 * t.culled / t.faces, t.nearest);
    assert_true(t.used > t.poses / 2);
    assert_true(t.culled > t.faces / 4);
    assert_true(t.nearest < 1);
}

/* Any transform, any numbers in planes: nothing traps, sums stay below 2^31. */
TEST(any_numbers)
{
    uint64_t seed = 202;
    unsigned found = 0;
    for (int n = 0; n < repeats(200000); n++) {
        qtri_transform t;
        qtri_projector projector;
        qtri_mat4 m;
        const int32_t left = random_in(&seed, -9000, 9000);
        const int32_t top = random_in(&seed, -300, 300);
        const int32_t width = random_in(&seed, 0, 9000);
        const int32_t height = random_in(&seed, 0, 1000);
        const qtri_viewport viewport = qtri_viewport_top(left, top, width, height);
        for (int i = 0; i < 16; i++) {
            m.m[i / 4][i % 4] = random_in(&seed, 0, 3) == 0 ? 0 : random_any(&seed);
        }
        if (random_flag(&seed)) {
            m.m[3][3] = INT32_MAX; /* or it is mostly near */
        }
        qtri_mesh mesh = {.origin = {random_any(&seed), random_any(&seed), random_any(&seed)},
                          .extent = random_any(&seed),
                          .faces = {NULL, NULL, (uint32_t)random_any(&seed),
                                    (uint16_t)random64(&seed), (uint16_t)random64(&seed)}};
        qtri_transform_from_mat4(&t, &m);
        qtri_projector_init(&projector, &t, &viewport);
        qtri_projector_compact(&projector, &mesh.origin, mesh.extent);
        qtri_eye eye;
        const bool is_found = qtri_eye_find(&eye, &projector, &mesh.faces);
        assert_int_equal(is_found, narrow_eye(&t, &viewport, &mesh, &eye));
        if (!is_found) {
            continue;
        }
        found++;
        const int64_t sum = 128 * ((int64_t)abs(eye.x) + abs(eye.y) + abs(eye.z) + abs(eye.w));
        assert_in_range(sum, 0, INT32_MAX);
        assert_in_range(eye.behind, 1, 1 << 29);
    }
    print_message("%u eyes\n", found);
    assert_true(found > (unsigned)random_cases(1000));
}

static qtri_material random_material(uint64_t *seed)
{
    qtri_material m = qtri_material_default();
    m.shading = shading_of((int)random_in(seed, 0, 2));
    m.cull = (qtri_cull)random_in(seed, 0, 2);
    m.fill = random_in(seed, 0, 2) == 0 ? &qtri_wireframe : NULL;
    m.depth_compare = random_in(seed, 0, 3) == 0 ? QTRI_DEPTH_OFF : QTRI_LESS;
    return m;
}

static void draw_in_bands(canvas *c, qtri_vertex *vertices, uint32_t count, uint16_t *lists,
                          uint32_t list_count, const qtri_view *view, const qtri_transform *pose,
                          const qtri_mesh *mesh, const qtri_material *material)
{
    static uint32_t memory[QTRI_BAND_BYTES(WIDTH, 16, QTRI_XRGB8888_BYTES) / sizeof(uint32_t)];
    qtri_frame frame;
    qtri_prepared prepared;
    assert_ok(qtri_frame_init(&frame, c->surface.format, WIDTH, HEIGHT, 16, memory, sizeof memory));
    prepared_init_with(&prepared, vertices, count, lists, list_count);
    qtri_prepare_mesh(&prepared, &frame, view, pose, mesh, material);
    draw_in_bands_of(c, &frame, &prepared);
}

/*
 * With planes and without, in every form, whole, by fewer slots, in bands with all lists and with
 * few: the same pixels. Light by faces is another matter, see below. Every eighth mesh has indices
 * past the end.
 */
TEST(same_pictures)
{
    static faces_mesh m;
    static qtri_vertex vertices[FACES_VERTICES + 50];
    static uint16_t lists[QTRI_PREPARED_LISTS(FACES_TRIANGLES, HEIGHT, 16)];
    uint64_t seed = 203;
    int painted = 0;
    for (int n = 0; n < repeats(1500); n++) {
        if (n % 8 == 0) {
            faces_mesh_make(&m, &seed, noise_of(n / 8));
        }
        qtri_mesh mesh = n % 2 != 0 ? m.wide : m.compact;
        if (random_flag(&seed)) {
            mesh.triangles8 = (const uint8_t(*)[3])m.triangle8;
        }
        mesh.vertex_count -= n % 8 == 7 ? 20 : 0;
        qtri_material material = random_material(&seed);
        const qtri_light light = {.towards = {random_any(&seed), random_any(&seed), 70000},
                                  .ambient = Q16(.3),
                                  .diffuse = Q16(.9)};
        qtri_view view;
        qtri_transform pose;
        faces_view(&view, &seed, WIDTH, HEIGHT);
        faces_pose(&pose, &seed, &mesh);
        view.light = material.shading == QTRI_SMOOTH && random_flag(&seed) ? &light : NULL;
        give_vertices(&view, vertices, FACES_VERTICES + 50);
        const qtri_format *format = drawn_format(n % 3);
        canvas without = canvas_new(format, WIDTH, HEIGHT);
        canvas with = canvas_new(format, WIDTH, HEIGHT);
        qtri_mesh plain = mesh;
        plain.faces.culling = NULL;
        qtri_draw_mesh(&without.surface, &view, &pose, &plain, &material);
        memset(vertices, 0xA5, sizeof vertices);
        qtri_draw_mesh(&with.surface, &view, &pose, &mesh, &material);
        assert_same_picture(&without.surface, &with.surface);
        painted += count_painted(&with.surface);
        canvas_clear(&with);
        view.vertex_count = (uint32_t)random_in(&seed, 0, FACES_VERTICES - 30);
        qtri_draw_mesh(&with.surface, &view, &pose, &mesh, &material);
        assert_same_picture(&without.surface, &with.surface);
        for (int k = 0; k < 2; k++) {
            canvas_clear(&with);
            memset(vertices, 0xA5, sizeof vertices);
            const uint32_t list_count =
                k == 0 ? LENGTH_OF(lists) : (uint32_t)random_in(&seed, 0, LENGTH_OF(lists));
            draw_in_bands(&with, vertices, FACES_VERTICES, lists, list_count, &view, &pose, &mesh,
                          &material);
            assert_same_picture(&without.surface, &with.surface);
        }
        canvas_free(&without);
        canvas_free(&with);
    }
    print_message("%d pixels\n", painted);
    assert_true(painted > random_cases(1000000));
}

/* The numbers of a corner as planes count them. */
static void corner_of(const qtri_mesh *mesh, uint32_t index, double out[3])
{
    if (mesh->positions16 != NULL) {
        const qtri_position16 *p = &mesh->positions16[index];
        out[0] = p->x / 32768.0;
        out[1] = p->y / 32768.0;
        out[2] = p->z / 32768.0;
        return;
    }
    const qtri_vec3 *p = &mesh->positions[index];
    out[0] = (double)((int64_t)p->x - mesh->origin.x) / mesh->extent;
    out[1] = (double)((int64_t)p->y - mesh->origin.y) / mesh->extent;
    out[2] = (double)((int64_t)p->z - mesh->origin.z) / mesh->extent;
}

static double length_of(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* What mesh.h promises of a plane that is not 0 0 0. */
static void check_plane(const qtri_mesh *mesh, uint32_t triangle)
{
    const qtri_face8 *face = &mesh->faces.planes[triangle];
    const double q[3] = {face->x, face->y, face->z};
    double p[3][3];
    double e[3][3];
    double n[3];
    double around = 0;
    for (int i = 0; i < 3; i++) {
        corner_of(mesh, mesh->triangles[triangle][i], p[i]);
    }
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            e[i][k] = p[(i + 1) % 3][k] - p[i][k];
        }
        around += length_of(e[i]);
    }
    for (int k = 0; k < 3; k++) {
        n[k] = e[0][(k + 1) % 3] * e[1][(k + 2) % 3] - e[0][(k + 2) % 3] * e[1][(k + 1) % 3];
    }
    const double area = length_of(n);
    const double along = (q[0] * n[0] + q[1] * n[1] + q[2] * n[2]) / area;
    const double beside = sqrt(fmax(0, q[0] * q[0] + q[1] * q[1] + q[2] * q[2] - along * along));
    const double d = q[0] * p[0][0] + q[1] * p[0][1] + q[2] * p[0][2];
    assert_true(length_of(q) >= 16);
    assert_true(fabs(face->d - d) <= .5 + 1e-9);
    assert_true(along * around / area <= mesh->faces.thin);
    assert_true(beside * 65536 <= mesh->faces.error_q16 + .1);
    assert_true(beside <= along / 64 + 1e-6);
}

/* The sign of the area, which 32 bits may hold or not: to both sides of that, and where it is 0. */
TEST(back_faces_of_any_size)
{
    uint64_t seed = 21;
    int back = 0;
    for (int n = 0; n < 400000; n++) {
        qtri_point p[3];
        for (int i = 0; i < 3; i++) {
            const int x_log2 = random_in(&seed, 0, 22), y_log2 = random_in(&seed, 0, 22);
            p[i].x_24p8 = random_in(&seed, -(1 << x_log2), 1 << x_log2);
            p[i].y_24p8 = random_in(&seed, -(1 << y_log2), 1 << y_log2);
        }
        if (n % 8 == 0) { /* in one line */
            p[2].x_24p8 = 2 * p[1].x_24p8 - p[0].x_24p8;
            p[2].y_24p8 = 2 * p[1].y_24p8 - p[0].y_24p8;
        }
        const int64_t dx1 = p[1].x_24p8 - p[0].x_24p8, dy1 = p[1].y_24p8 - p[0].y_24p8;
        const int64_t dx2 = p[2].x_24p8 - p[0].x_24p8, dy2 = p[2].y_24p8 - p[0].y_24p8;
        const bool is_back = dx1 * dy2 >= dx2 * dy1;
        assert_int_equal(qtri_triangle_is_back(&p[0], &p[1], &p[2]), is_back);
        back += is_back;
    }
    assert_in_range(back, 150000, 300000);
}

TEST(planes_keep_the_contract)
{
    static faces_mesh m;
    uint64_t seed = 204;
    for (int n = 0; n < repeats(60); n++) {
        unsigned made = 0;
        faces_mesh_make(&m, &seed, noise_of(n));
        const qtri_mesh *mesh = n / 6 % 2 != 0 ? &m.wide : &m.compact;
        assert_non_null(mesh->faces.planes);
        for (uint32_t i = 0; i < mesh->vertex_count; i++) {
            double p[3];
            corner_of(mesh, i, p);
            assert_true(length_of(p) * 16384 <= mesh->faces.radius_q14);
            for (int k = 0; k < 3; k++) {
                assert_true(fabs(p[k]) <= 1);
            }
        }
        for (uint32_t i = 0; i < mesh->triangle_count; i++) {
            const qtri_face8 *face = &mesh->faces.planes[i];
            if ((face->x | face->y | face->z) == 0) {
                assert_int_equal(face->d, 0);
                continue;
            }
            made++;
            check_plane(mesh, i);
        }
        assert_true(made > mesh->triangle_count / 2);
    }
}

/* Light by a plane is that of its x y z, and within the plane's angle of the face's own. */
TEST(light_by_planes)
{
    static faces_mesh m;
    uint64_t seed = 206;
    double worst = 0;
    double apart = 0;
    qtri_transform identity;
    qtri_transform_identity(&identity);
    for (int n = 0; n < repeats(120); n++) {
        faces_mesh_make(&m, &seed, noise_of(n));
        const double diffuse = faces_random(&seed, 0, 4);
        const qtri_light light = {
            .towards = {random_any(&seed), random_any(&seed), random_any(&seed)},
            .ambient = random_in(&seed, 0, 30000),
            .diffuse = fixed(diffuse)};
        const double l[3] = {light.towards.x, light.towards.y, light.towards.z};
        qtri_lighting lighting;
        qtri_lighting_init(&lighting, &light, &identity, false, NULL);
        assert_true(lighting.plain);
        for (uint32_t i = 0; i < m.wide.triangle_count; i++) {
            const qtri_face8 *face = &m.plane[i];
            const uint16_t *t = m.triangle[i];
            const double q[3] = {face->x, face->y, face->z};
            if (length_of(q) == 0) {
                continue;
            }
            const uint32_t got = qtri_lighting_face8(&lighting, face);
            assert_int_equal(got, narrow_light_plane(&light, &identity, face));
            const double size = length_of(q) * length_of(l);
            const double cosine = size > 0 ? (q[0] * l[0] + q[1] * l[1] + q[2] * l[2]) / size : 0;
            const double wanted = fmin(1, real(light.ambient) + diffuse * fmax(0, cosine));
            const double own = qtri_lighting_face(&lighting, &m.position[t[0]], &m.position[t[1]],
                                                  &m.position[t[2]]) /
                               32768.0;
            worst = fmax(worst, fabs(got / 32768.0 - wanted) - diffuse / 8192);
            apart = fmax(apart, (fabs(got / 32768.0 - own) - 1.0 / 2048) / fmax(diffuse, .01));
        }
    }
    print_message("light: off by %.6f; %.5f of the diffuse part from a face's own\n", worst, apart);
    assert_true(worst <= 1.0 / 2048);
    assert_true(apart <= 1.0 / 64);
}

static int channel(uint32_t pixel, int shift)
{
    return (int)(pixel >> shift & 0xFF);
}

/*
 * A flat mesh with planes: the picture without, but for colours that are off as light is. Where
 * planes do not light, uneven transforms, it is the same. In bands and by slots as well.
 */
TEST(pictures_lit_by_planes)
{
    static faces_mesh m;
    static qtri_vertex vertices[FACES_VERTICES];
    static uint16_t lists[QTRI_PREPARED_LISTS(FACES_TRIANGLES, HEIGHT, 16)];
    uint64_t seed = 207;
    int most = 0;
    unsigned painted = 0;
    for (int n = 0; n < repeats(300); n++) {
        faces_mesh_make(&m, &seed, noise_of(n));
        qtri_mesh mesh = n % 2 != 0 ? m.wide : m.compact;
        if (random_flag(&seed)) {
            mesh.triangles8 = (const uint8_t(*)[3])m.triangle8;
        }
        qtri_material material = qtri_material_default();
        const qtri_light light = {.towards = {random_any(&seed), random_any(&seed), 70000},
                                  .ambient = Q16(.2),
                                  .diffuse = Q16(.8)};
        qtri_view view;
        qtri_transform pose;
        material.shading = n % 3 != 0 ? QTRI_FLAT_LAST : QTRI_FLAT_FIRST;
        material.cull = (qtri_cull)random_in(&seed, 0, 2);
        faces_view(&view, &seed, WIDTH, HEIGHT);
        faces_pose(&pose, &seed, &mesh);
        const bool uneven = random_in(&seed, 0, 3) == 0;
        if (uneven) {
            const qtri_vec3 factor = {Q16(.5), Q16(.7), Q16(1)};
            qtri_transform_scale(&pose, factor);
        }
        view.light = &light;
        give_vertices(&view, vertices, FACES_VERTICES);
        canvas without = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        canvas with = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        canvas other = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        qtri_mesh plain = mesh;
        plain.faces.planes = NULL;
        qtri_draw_mesh(&without.surface, &view, &pose, &plain, &material);
        qtri_draw_mesh(&with.surface, &view, &pose, &mesh, &material);
        mesh.faces.culling = NULL;
        qtri_draw_mesh(&other.surface, &view, &pose, &mesh, &material);
        assert_same_picture(&with.surface, &other.surface);
        canvas_clear(&other);
        mesh.faces.culling = &qtri_cull_by_planes;
        view.vertex_count = 40;
        qtri_draw_mesh(&other.surface, &view, &pose, &mesh, &material);
        assert_same_picture(&with.surface, &other.surface);
        canvas_clear(&other);
        draw_in_bands(&other, vertices, FACES_VERTICES, lists, LENGTH_OF(lists), &view, &pose,
                      &mesh, &material);
        assert_same_picture(&with.surface, &other.surface);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const uint32_t a = stored_pixel(&without.surface, i % WIDTH, i / WIDTH);
            const uint32_t b = stored_pixel(&with.surface, i % WIDTH, i / WIDTH);
            painted += b != 0;
            for (int shift = 0; shift < 24; shift += 8) {
                most = max_of(most, abs(channel(a, shift) - channel(b, shift)));
            }
            assert_int_equal(stored_depth(&without.surface, i % WIDTH, i / WIDTH),
                             stored_depth(&with.surface, i % WIDTH, i / WIDTH));
            assert_true(!uneven || a == b);
        }
        canvas_free(&without);
        canvas_free(&with);
        canvas_free(&other);
    }
    print_message("%u pixels, off by %d of 255\n", painted, most);
    assert_true(painted > (unsigned)random_cases(300000));
    assert_true(most <= 5); /* .8 255 / 64 is 3.2, and the rounding of both */
    assert_true(most > 0);
}

/* Small ones and open ones are left as they are; what is no triangle has no plane. */
TEST(planes_where_they_pay)
{
    static faces_mesh m;
    static qtri_face8 planes[FACES_TRIANGLES];
    uint64_t seed = 205;
    faces_mesh_make(&m, &seed, 0.0);
    assert_true(mesh_faces_make(&m.compact, planes));
    assert_ptr_equal(m.compact.faces.planes, planes);
    m.compact.triangle_count = 100;
    assert_false(mesh_faces_make(&m.compact, planes));
    assert_null(m.compact.faces.planes);
    for (int i = 0; i < FACES_TRIANGLES / 2; i++) { /* the other way round */
        const uint16_t swapped = m.triangle[i][0];
        m.triangle[i][0] = m.triangle[i][1];
        m.triangle[i][1] = swapped;
    }
    for (int i = 0; i < FACES_VERTICES; i++) {
        m.position[i].z = 1000;
    }
    m.triangle[0][1] = FACES_VERTICES;
    m.triangle[1][1] = m.triangle[1][0];
    m.wide.triangle_count = FACES_TRIANGLES / 4;
    (void)mesh_faces_fill(&m.wide, planes);
    for (int i = 0; i < 2; i++) {
        assert_int_equal(planes[i].x | planes[i].y | planes[i].z | planes[i].d, 0);
    }
    qtri_mesh empty = {.positions = m.position};
    assert_false(mesh_faces_make(&empty, planes));
    assert_true(mesh_faces_fill(&empty, planes) == 0.0);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
