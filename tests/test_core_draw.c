/* SPDX-License-Identifier: MIT */
/*
 * Draw calls: meshes and corners through the whole pipeline.
 */
#include "support/core.h"

#include "qtri/pipeline.h"

enum { WIDTH = 48, HEIGHT = 40, VERTICES = 30, TRIANGLES = 40 };

/* A mesh with everything. */
typedef struct full_mesh {
    qtri_vec3 position[VERTICES];
    qtri_normal normal[VERTICES];
    qtri_vec2 uv[VERTICES];
    qtri_rgb color[VERTICES];
    uint16_t triangle[TRIANGLES][3];
    qtri_position16 position16[VERTICES];
    qtri_normal8 normal8[VERTICES];
    qtri_uv16 uv16[VERTICES];
    uint8_t triangle8[TRIANGLES][3];
    qtri_mesh mesh;
} full_mesh;

static const qtri_texture checker = {
    .format = &qtri_texel_checker,
    .width_log2 = 5,
    .height_log2 = 5,
    .fields = 8,
    .color = {{255, 200, 60}, {60, 90, 255}},
};

static qtri_normal unit_normal(uint64_t *seed)
{
    double n[3];
    double length = 0;
    while (length < .1) {
        for (int i = 0; i < 3; i++) {
            n[i] = random_in(seed, -1000, 1000) / 1000.;
        }
        length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    }
    qtri_normal normal = {(int16_t)lrint(n[0] / length * 16384),
                          (int16_t)lrint(n[1] / length * 16384),
                          (int16_t)lrint(n[2] / length * 16384)};
    return normal;
}

static void random_mesh(full_mesh *m, uint64_t *seed)
{
    for (int i = 0; i < VERTICES; i++) {
        qtri_vec3 p = {random_in(seed, -200000, 200000), random_in(seed, -200000, 200000),
                       random_in(seed, -200000, 200000)};
        m->position[i] = p;
        m->normal[i] = unit_normal(seed);
        m->uv[i].x = random_in(seed, -200000, 200000);
        m->uv[i].y = random_in(seed, -200000, 200000);
        m->color[i].r = (uint8_t)random64(seed);
        m->color[i].g = (uint8_t)random64(seed);
        m->color[i].b = (uint8_t)random64(seed);
    }
    for (int i = 0; i < TRIANGLES * 3; i++) { /* a few past the end */
        m->triangle[i / 3][i % 3] = (uint16_t)random_in(seed, 0, VERTICES - (i % 20 != 0));
    }
    qtri_mesh mesh = {.positions = m->position,
                      .normals = random_flag(seed) ? m->normal : NULL,
                      .uvs = random_flag(seed) ? m->uv : NULL,
                      .colors = random_flag(seed) ? m->color : NULL,
                      .triangles = (const uint16_t(*)[3])m->triangle,
                      .vertex_count = VERTICES,
                      .triangle_count = TRIANGLES};
    m->mesh = mesh;
}

/* Some of its arrays in the compact form. */
static void compact_mesh(full_mesh *m, uint64_t *seed)
{
    for (int i = 0; i < VERTICES; i++) {
        const qtri_position16 p = {(int16_t)random64(seed), (int16_t)random64(seed),
                                   (int16_t)random64(seed)};
        const qtri_normal8 n = {(int8_t)(m->normal[i].x / 129), (int8_t)(m->normal[i].y / 129),
                                (int8_t)(m->normal[i].z / 129)};
        m->position16[i] = p;
        m->normal8[i] = n;
        m->uv16[i].x = (int16_t)random64(seed);
        m->uv16[i].y = (int16_t)random64(seed);
    }
    for (int i = 0; i < TRIANGLES * 3; i++) {
        m->triangle8[i / 3][i % 3] = (uint8_t)m->triangle[i / 3][i % 3];
    }
    m->mesh.positions16 = random_flag(seed) ? m->position16 : NULL;
    m->mesh.origin.x = random_in(seed, -50000, 50000);
    m->mesh.extent = random_in(seed, 100000, 250000);
    m->mesh.normals8 = random_flag(seed) ? m->normal8 : NULL;
    m->mesh.uvs16 = random_flag(seed) ? m->uv16 : NULL;
    m->mesh.triangles8 = random_flag(seed) ? (const uint8_t(*)[3])m->triangle8 : NULL;
}

static qtri_material random_material(uint64_t *seed)
{
    qtri_material m = qtri_material_default();
    m.shading = shading_of((int)random_in(seed, 0, 2));
    m.interpolation = (qtri_interpolation)random_in(seed, 0, 1);
    m.texture = random_flag(seed) ? &checker : NULL;
    m.cull = (qtri_cull)random_in(seed, 0, 2);
    m.fill = random_in(seed, 0, 4) == 0 ? &qtri_wireframe : NULL;
    return m;
}

/* Somewhere near the object, inside it as often as not: triangles cross all planes. */
static void random_view(qtri_view *view, uint64_t *seed)
{
    qtri_vec3 up = {0, Q16_ONE, 0};
    int32_t r = random_in(seed, 0, 400000);
    qtri_vec3 eye = {random_in(seed, -r, r), random_in(seed, -r, r), random_in(seed, -r, r)};
    qtri_vec3 center = {random_in(seed, -65536, 65536), 0, 0};
    qtri_view_init(view, WIDTH, HEIGHT);
    qtri_transform_look_at(&view->camera, eye, center, up);
    const q16 angle = random_in(seed, 20 << 16, 150 << 16);
    const q16 near_z = random_in(seed, 66, 65536);
    const q16 far_z = random_in(seed, 131072, 1 << 20);
    qtri_transform_perspective(&view->projection, angle, Q16(1.2), near_z, far_z);
}

static void random_pose(qtri_transform *pose, uint64_t *seed)
{
    qtri_vec3 axis = {random_in(seed, -100, 100), random_in(seed, -100, 100), 50};
    qtri_vec3 factor = {random_in(seed, -90000, 90000), random_in(seed, 20000, 90000),
                        random_in(seed, 20000, 90000)};
    qtri_transform_identity(pose);
    qtri_transform_rotate(pose, random_in(seed, 0, 360 << 16), axis);
    qtri_transform_scale(pose, factor);
    qtri_transform_rotate_y(pose, random_in(seed, 0, 360 << 16));
}

TEST(any_scratch_size)
{
    static const uint32_t sizes[] = {1, 2, 3, 7, VERTICES - 1, VERTICES, 2 * VERTICES};
    static qtri_vertex scratch[2 * VERTICES + 1];
    static full_mesh m;
    uint64_t seed = 101;
    int total = 0;
    for (int n = 0; n < 600; n++) {
        qtri_view view;
        qtri_transform pose;
        qtri_light light = {.towards = {random_any(&seed), random_any(&seed), 70000},
                            .ambient = Q16(0.3),
                            .diffuse = Q16(0.9)};
        random_mesh(&m, &seed);
        if (n % 2 != 0) {
            compact_mesh(&m, &seed);
        }
        random_view(&view, &seed);
        random_pose(&pose, &seed);
        qtri_material material = random_material(&seed);
        view.light = random_flag(&seed) ? &light : NULL;
        const qtri_format *format = drawn_format(n);
        canvas none = canvas_new(format, WIDTH, HEIGHT);
        qtri_draw_mesh(&none.surface, &view, &pose, &m.mesh, &material);
        total += count_painted(&none.surface);
        for (size_t i = 0; i < LENGTH_OF(sizes); i++) {
            canvas c = canvas_new(format, WIDTH, HEIGHT);
            memset(scratch, 0x5A + (int)i, sizeof scratch);
            give_vertices(&view, scratch, sizes[i]);
            qtri_draw_mesh(&c.surface, &view, &pose, &m.mesh, &material);
            assert_same_picture(&none.surface, &c.surface);
            uint8_t behind = ((const uint8_t *)&scratch[sizes[i]])[0];
            assert_int_equal(behind, 0x5A + (int)i); /* only what it was given */
            canvas_free(&c);
        }
        canvas_free(&none);
    }
    assert_true(total > 100000);
}

/* The same corners drawn as a mesh and as a list, each band alone too. */
TEST(corners_equal_mesh)
{
    static full_mesh m;
    static qtri_corner corners[TRIANGLES * 3];
    uint64_t seed = 102;
    for (int n = 0; n < random_cases(600); n++) {
        qtri_view view;
        qtri_transform pose;
        random_mesh(&m, &seed);
        random_view(&view, &seed);
        random_pose(&pose, &seed);
        m.mesh.uvs = m.uv;
        m.mesh.colors = m.color;
        uint32_t count = 0;
        for (int i = 0; i < TRIANGLES; i++) {
            const uint16_t *t = m.triangle[i];
            for (int k = 0; k < 3 && t[0] < VERTICES && t[1] < VERTICES && t[2] < VERTICES; k++) {
                const qtri_vec3 *p = &m.position[t[k]];
                qtri_corner corner = {{p->x, p->y, p->z, Q16_ONE}, m.color[t[k]], m.uv[t[k]]};
                corners[count++] = corner;
            }
        }
        qtri_material material = random_material(&seed);
        const qtri_format *format = drawn_format(n);
        canvas whole = canvas_new(format, WIDTH, HEIGHT);
        qtri_draw_mesh(&whole.surface, &view, &pose, &m.mesh, &material);
        for (int32_t first = 0; first < HEIGHT;) {
            int32_t rows = n % 2 != 0 ? HEIGHT : random_in(&seed, 1, 20);
            canvas c = canvas_band(format, WIDTH, HEIGHT, first, rows);
            qtri_draw_triangles(&c.surface, &view, &pose, corners, count + 2, &material);
            qtri_draw_triangles(&c.surface, &view, &pose, corners, 2, &material);
            assert_same_picture(&whole.surface, &c.surface);
            canvas_free(&c);
            first += rows;
        }
        canvas_free(&whole);
    }
}

/* Inside a closed box whose faces are cut to pieces: every pixel is covered exactly once. */
TEST(inside_a_box)
{
    enum { CUTS = 3 };
    uint64_t seed = 103;
    canvas c = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    for (int n = 0; n < random_cases(120); n++) {
        int count[HEIGHT][WIDTH] = {{0}};
        qtri_view view;
        qtri_transform pose;
        qtri_vec3 up = {0, Q16_ONE, 0};
        int32_t size = n % 2 != 0 ? 3 << 16 : 200 << 16;
        int32_t r = size / 3 * 2;
        qtri_vec3 eye = {random_in(&seed, -r, r), random_in(&seed, -r, r), random_in(&seed, -r, r)};
        qtri_vec3 center = {random_any(&seed), random_any(&seed), random_any(&seed)};
        qtri_view_init(&view, WIDTH, HEIGHT);
        qtri_transform_look_at(&view.camera, eye, center, up);
        qtri_transform_perspective(&view.projection, Q16(100), Q16(1.2), Q16(0.01), Q16(2000));
        qtri_transform_identity(&pose);
        qtri_material material = plain_material();
        for (int face = 0; face < 6; face++) {
            for (int i = 0; i < CUTS * CUTS * 2; i++) {
                static const int step[2][3][2] = {{{0, 0}, {1, 0}, {1, 1}},
                                                  {{0, 0}, {1, 1}, {0, 1}}};
                qtri_corner corners[3];
                memset(corners, 0, sizeof corners);
                for (int k = 0; k < 3; k++) {
                    q16 p[3];
                    p[face % 3] = face < 3 ? size : -size;
                    p[(face + 1) % 3] =
                        (i / 2 % CUTS + step[i % 2][k][0]) * (2 * size / CUTS) - size;
                    p[(face + 2) % 3] =
                        (i / 2 / CUTS + step[i % 2][k][1]) * (2 * size / CUTS) - size;
                    qtri_corner corner = {{p[0], p[1], p[2], Q16_ONE}, {255, 255, 255}, {0, 0}};
                    corners[k] = corner;
                }
                canvas_clear(&c);
                qtri_draw_triangles(&c.surface, &view, &pose, corners, 3, &material);
                for (int32_t k = 0; k < WIDTH * HEIGHT; k++) {
                    count[k / WIDTH][k % WIDTH] +=
                        stored_pixel(&c.surface, k % WIDTH, k / WIDTH) != 0;
                }
            }
        }
        for (int k = 0; k < WIDTH * HEIGHT; k++) {
            if (count[k / WIDTH][k % WIDTH] != 1) {
                fail_msg("box %d: pixel %d,%d drawn %d times", n, k % WIDTH, k / WIDTH,
                         count[k / WIDTH][k % WIDTH]);
            }
        }
    }
    canvas_free(&c);
}

/* Light by faces does not depend on the normals that the mesh has for light by vertices. */
TEST(flat_light_without_normals)
{
    static full_mesh m;
    uint64_t seed = 110;
    int total = 0;
    for (int n = 0; n < random_cases(200); n++) {
        qtri_view view;
        qtri_transform pose;
        qtri_light light = {.towards = {random_any(&seed), random_any(&seed), 70000},
                            .ambient = Q16(0.1),
                            .diffuse = Q16(0.9)};
        random_mesh(&m, &seed);
        compact_mesh(&m, &seed);
        random_view(&view, &seed);
        qtri_transform_identity(&pose);
        view.light = &light;
        qtri_material material = qtri_material_default();
        material.shading = QTRI_FLAT_LAST;
        canvas with = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        canvas without = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        m.mesh.normals8 = m.normal8;
        qtri_draw_mesh(&with.surface, &view, &pose, &m.mesh, &material);
        m.mesh.normals8 = NULL;
        m.mesh.normals = NULL;
        qtri_draw_mesh(&without.surface, &view, &pose, &m.mesh, &material);
        assert_same_picture(&with.surface, &without.surface);
        total += count_painted(&with.surface);
        canvas_free(&with);
        canvas_free(&without);
    }
    assert_true(total > 10000);
}

/*
 * Compact arrays that hold the same numbers as the wide ones give the same picture, but for the
 * pixels where a rounding of the position in 2^28 shows.
 */
TEST(compact_equals_wide)
{
    static full_mesh m;
    static qtri_vertex scratch[VERTICES];
    uint64_t seed = 107;
    int different = 0;
    int total = 0;
    for (int n = 0; n < random_cases(400); n++) {
        qtri_view view;
        qtri_transform pose;
        qtri_light light = {.towards = {random_any(&seed), random_any(&seed), 70000},
                            .ambient = Q16(0.3),
                            .diffuse = Q16(0.9)};
        random_mesh(&m, &seed);
        random_view(&view, &seed);
        random_pose(&pose, &seed);
        compact_mesh(&m, &seed);
        m.mesh.positions16 = m.position16;
        m.mesh.normals8 = NULL;
        m.mesh.extent = 4 * 32768;
        qtri_mesh wide = m.mesh;
        for (int i = 0; i < VERTICES; i++) {
            m.position[i].x = m.mesh.origin.x + 4 * m.position16[i].x;
            m.position[i].y = m.mesh.origin.y + 4 * m.position16[i].y;
            m.position[i].z = m.mesh.origin.z + 4 * m.position16[i].z;
            m.uv[i].x = m.uv16[i].x * 4;
            m.uv[i].y = m.uv16[i].y * 4;
        }
        wide.positions16 = NULL;
        wide.uvs = m.mesh.uvs16 != NULL ? m.uv : wide.uvs;
        wide.uvs16 = NULL;
        wide.triangles8 = NULL;
        view.light = &light;
        give_vertices(&view, scratch, VERTICES);
        qtri_material material = random_material(&seed);
        canvas a = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        canvas b = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        qtri_draw_mesh(&a.surface, &view, &pose, &m.mesh, &material);
        qtri_draw_mesh(&b.surface, &view, &pose, &wide, &material);
        different += count_apart(&a.surface, &b.surface, 1);
        total += count_painted(&a.surface);
        canvas_free(&a);
        canvas_free(&b);
    }
    print_message("compact: %d of %d pixels differ\n", different, total);
    assert_true(total > 30000);
    assert_true(different <= total / 1000);
}

/*
 * A vertex stage draws the meshes that it serves as the whole one does, nothing of those whose
 * positions it does not serve, and without light what it does not light.
 */
TEST(stages)
{
    static full_mesh m;
    static qtri_vertex scratch[VERTICES];
    uint64_t seed = 113;
    int total = 0;
    int unlit = 0;
    for (int n = 0; n < 600; n++) {
        qtri_view view;
        qtri_transform pose;
        const qtri_light light = {.towards = {random_any(&seed), random_any(&seed), 70000},
                                  .ambient = Q16(.3),
                                  .diffuse = Q16(.9)};
        const bool is_compact = random_flag(&seed);
        const qtri_vertex_stage stage = {
            .positions = random_in(&seed, 1, 4) == 1 ? NULL : &qtri_positions_wide,
            .positions16 = random_in(&seed, 1, 4) == 1 ? NULL : &qtri_positions_compact,
            .vertex_light = random_in(&seed, 1, 3) == 1 ? NULL : &qtri_light_by_vertex,
            .face_light = random_in(&seed, 1, 3) == 1 ? NULL : &qtri_light_by_face,
            .uneven_light = random_flag(&seed) ? NULL : &qtri_light_uneven};
        random_mesh(&m, &seed);
        compact_mesh(&m, &seed);
        random_view(&view, &seed);
        qtri_transform_identity(&pose);
        qtri_transform_rotate_x(&pose, random_any(&seed));
        const bool is_uneven = random_in(&seed, 1, 3) == 1;
        if (is_uneven) {
            const qtri_vec3 factor = {Q16_ONE, Q16(.5), Q16_ONE};
            qtri_transform_scale(&pose, factor);
        }
        m.mesh.positions16 = is_compact ? m.position16 : NULL;
        m.mesh.normals8 = NULL;
        give_vertices(&view, scratch, VERTICES);
        qtri_material material = random_material(&seed);
        const bool by_vertex = material.shading == QTRI_SMOOTH && m.mesh.normals != NULL;
        const bool is_served = (is_compact ? stage.positions16 : stage.positions) != NULL;
        const bool is_lit = (by_vertex ? stage.vertex_light != NULL : stage.face_light != NULL) &&
                            (!is_uneven || stage.uneven_light != NULL);
        canvas a = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        canvas b = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        view.light = &light;
        qtri_draw_mesh_by(&stage, &a.surface, &view, &pose, &m.mesh, &material);
        view.light = is_lit ? &light : NULL;
        if (is_served) {
            qtri_draw_mesh(&b.surface, &view, &pose, &m.mesh, &material);
        }
        assert_close(&a.surface, &b.surface, 1);
        if (is_lit || !is_uneven) { /* others are drawn in a light of 1 */
            assert_same_picture(&a.surface, &b.surface);
        }
        total += count_painted(&b.surface);
        unlit += is_served && !is_lit;
        canvas_free(&a);
        canvas_free(&b);
    }
    print_message("stages: %d pixels, %d not lit\n", total, unlit);
    assert_true(total > 10000);
    assert_true(unlit > 50);
}

/* A box around the mesh never changes the picture, and does keep a mesh out of sight from work. */
TEST(bounds)
{
    static full_mesh m;
    static qtri_vertex scratch[VERTICES];
    uint64_t seed = 108;
    int skipped = 0;
    int empty = 0;
    for (int n = 0; n < 3000; n++) {
        qtri_view view;
        qtri_transform pose;
        random_mesh(&m, &seed);
        random_view(&view, &seed);
        random_pose(&pose, &seed);
        int32_t shift = random_in(&seed, 0, 8);
        qtri_vec3 away = {random_in(&seed, -600000, 600000), random_in(&seed, -600000, 600000),
                          random_in(&seed, -600000, 600000)};
        qtri_vec3 low = away;
        qtri_vec3 high = away;
        for (int i = 0; i < VERTICES; i++) {
            qtri_vec3 *p = &m.position[i];
            p->x = away.x + (p->x >> shift);
            p->y = away.y + (p->y >> shift);
            p->z = away.z + (p->z >> shift);
            low.x = p->x < low.x ? p->x : low.x;
            low.y = p->y < low.y ? p->y : low.y;
            low.z = p->z < low.z ? p->z : low.z;
            high.x = p->x > high.x ? p->x : high.x;
            high.y = p->y > high.y ? p->y : high.y;
            high.z = p->z > high.z ? p->z : high.z;
        }
        qtri_box box = {
            {(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2},
            {(high.x - low.x) / 2 + 1, (high.y - low.y) / 2 + 1, (high.z - low.z) / 2 + 1}};
        qtri_material material = random_material(&seed);
        int32_t first = random_in(&seed, 0, HEIGHT - 1);
        canvas a = canvas_band(&qtri_rgb565, WIDTH, HEIGHT, first, random_in(&seed, 1, HEIGHT));
        canvas b = canvas_band(&qtri_rgb565, WIDTH, HEIGHT, first, a.surface.rows);
        give_vertices(&view, scratch, VERTICES);
        m.mesh.bounds = box;
        memset(scratch, 0x77, sizeof scratch);
        qtri_draw_mesh(&a.surface, &view, &pose, &m.mesh, &material);
        bool untouched = scratch[0].inv_w == 0x77777777u && scratch[1].inv_w == 0x77777777u;
        qtri_box unknown = {{0, 0, 0}, {0, 0, 0}};
        m.mesh.bounds = unknown;
        qtri_draw_mesh(&b.surface, &view, &pose, &m.mesh, &material);
        assert_same_picture(&a.surface, &b.surface);
        skipped += untouched;
        bool any = false;
        for (int32_t y = first; y < first + b.surface.rows; y++) {
            for (int32_t x = 0; x < WIDTH; x++) {
                any |= stored_depth(&b.surface, x, y) != 65535;
            }
        }
        empty += !any;
        canvas_free(&a);
        canvas_free(&b);
    }
    print_message("bounds: %d of 3000 skipped, %d show nothing\n", skipped, empty);
    assert_true(skipped > 1000);
    assert_true(skipped <= empty);
}

static double element(const qtri_transform *t, int i, int j)
{
    return ldexp((double)t->row[i].m[j], -t->row[i].exponent);
}

static void cross(double out[3], const double a[3], const double b[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    }
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* min(1, ambient + diffuse max(0, n . l)), n by the inverse transpose of object to eye. */
static double intensity(const qtri_light *light, const qtri_transform *to_eye, const double n[3])
{
    double column[3][3];
    double eye[3];
    double l[3] = {light->towards.x, light->towards.y, light->towards.z};
    for (int i = 0; i < 9; i++) {
        column[i / 3][i % 3] = element(to_eye, i % 3, i / 3);
    }
    double cofactor[3][3];
    for (int i = 0; i < 3; i++) {
        cross(cofactor[i], column[(i + 1) % 3], column[(i + 2) % 3]);
    }
    double determinant = dot(column[0], cofactor[0]);
    for (int i = 0; i < 3; i++) {
        eye[i] =
            (cofactor[0][i] * n[0] + cofactor[1][i] * n[1] + cofactor[2][i] * n[2]) / determinant;
    }
    double lengths = sqrt(dot(eye, eye) * dot(l, l));
    double cosine = lengths > 0 ? dot(eye, l) / lengths : 0;
    return fmin(1, real(light->ambient) + real(light->diffuse) * fmax(0, cosine));
}

/* COURSE scene 7: light under rotation, even and uneven scale, reflection and shear. */
TEST(lit)
{
    double worst[2][2] = {{0, 0}, {0, 0}};
    int seen = 0;
    uint64_t seed = 104;
    canvas c = canvas_new(&qtri_xrgb8888, 32, 32);
    for (int n = 0; n < 6000; n++) {
        bool per_vertex = n % 2 != 0;
        bool even = n % 4 < 2;
        qtri_vec3 p[3];
        qtri_normal normal = unit_normal(&seed);
        qtri_normal normals[3] = {normal, normal, normal};
        static const uint16_t triangle[1][3] = {{0, 1, 2}};
        for (int i = 0; i < 3; i++) {
            p[i].x = random_in(&seed, -(15 << 16), 15 << 16);
            p[i].y = random_in(&seed, -(15 << 16), 15 << 16);
            p[i].z = random_in(&seed, -(15 << 16), 15 << 16);
        }
        qtri_mesh mesh = {.positions = p,
                          .normals = per_vertex ? normals : NULL,
                          .triangles = triangle,
                          .vertex_count = 3,
                          .triangle_count = 1};
        qtri_view view;
        qtri_transform pose;
        qtri_transform to_eye;
        qtri_vec3 eye = {random_in(&seed, -65536, 65536), 9999, random_in(&seed, -65536, 65536)};
        qtri_vec3 origin = {0, 0, 0};
        qtri_vec3 up = {0, Q16_ONE, 0};
        q16 k = random_in(&seed, 20000, 120000);
        qtri_vec3 factor = {random_flag(&seed) ? k : -k, k, random_flag(&seed) ? k : -k};
        qtri_light light = {.towards = {random_any(&seed), random_any(&seed), random_any(&seed)},
                            .ambient = random_in(&seed, 10000, 30000),
                            .diffuse = random_in(&seed, 0, 90000)};
        qtri_view_init(&view, 32, 32);
        qtri_transform_look_at(&view.camera, eye, origin, up);
        qtri_transform_ortho(&view.projection, Q16(-20), Q16(20), Q16(-20), Q16(20), Q16(-200),
                             Q16(200));
        view.light = &light;
        qtri_transform_identity(&pose);
        qtri_transform_rotate_x(&pose, random_in(&seed, 0, 360 << 16));
        if (!even) { /* between two rotations: a shear, too; slight every other time */
            factor.x = n % 8 < 4 ? factor.x / 3 : factor.x;
            factor.y = n % 8 < 4 ? factor.y + 30000 : factor.y + factor.y / 32;
        }
        qtri_transform_scale(&pose, factor);
        qtri_transform_rotate_z(&pose, random_in(&seed, 0, 360 << 16));
        qtri_transform_mul(&to_eye, &view.camera, &pose);

        qtri_material material = plain_material();
        material.shading = per_vertex ? QTRI_SMOOTH : shading_of((int)random_in(&seed, 1, 2));
        canvas_clear(&c);
        qtri_draw_mesh(&c.surface, &view, &pose, &mesh, &material);
        double nd[3] = {normal.x, normal.y, normal.z};
        if (!per_vertex) {
            double a[3] = {real(p[1].x) - real(p[0].x), real(p[1].y) - real(p[0].y),
                           real(p[1].z) - real(p[0].z)};
            double b[3] = {real(p[2].x) - real(p[0].x), real(p[2].y) - real(p[0].y),
                           real(p[2].z) - real(p[0].z)};
            cross(nd, a, b);
        }
        double expected = 255 * intensity(&light, &to_eye, nd);
        for (int32_t i = 0; i < 32 * 32; i++) {
            uint32_t pixel = stored_pixel(&c.surface, i % 32, i / 32);
            if (pixel != 0) {
                worst[per_vertex][even] =
                    fmax(worst[per_vertex][even], fabs((double)(pixel & 255) - expected));
                seen++;
            }
        }
    }
    print_message("light: face %.4f, uneven %.4f; vertex %.4f, uneven %.4f of 255\n", worst[0][1],
                  worst[0][0], worst[1][1], worst[1][0]);
    assert_true(seen > 100000);
    assert_true(worst[0][0] <= .52 && worst[0][1] <= .52); /* .5 of it the rounding of a pixel */
    assert_true(worst[1][0] <= 1 && worst[1][1] <= 1);     /* light between vertices has 8 bits */
    canvas_free(&c);
}

TEST(nothing_to_draw)
{
    canvas c = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    qtri_view view;
    qtri_transform pose;
    qtri_material material = qtri_material_default();
    qtri_vec3 points[2] = {{0, 0, 0}, {1, 1, 1}};
    static const uint16_t triangles[3][3] = {{0, 1, 2}, {0, 0, 0}, {65535, 0, 1}};
    qtri_mesh empty = {.positions = NULL};
    qtri_mesh bad = {
        .positions = points, .triangles = triangles, .vertex_count = 2, .triangle_count = 3};
    qtri_mesh no_vertices = {.triangles = triangles, .triangle_count = 3};
    start_view(&view, &pose, WIDTH, HEIGHT);
    qtri_draw_mesh(&c.surface, &view, &pose, &empty, &material);
    qtri_draw_mesh(&c.surface, &view, &pose, &no_vertices, &material);
    material.cull = QTRI_CULL_NONE;
    qtri_draw_mesh(&c.surface, &view, &pose, &bad, &material);
    qtri_draw_triangles(&c.surface, &view, &pose, NULL, 0, &material);
    qtri_draw_lines(&c.surface, &view, &pose, NULL, 0, &material);
    assert_int_equal(count_painted(&c.surface), 0);
    canvas_free(&c);

    canvas one = canvas_new(&qtri_gray8, 1, 1); /* a target of one pixel */
    qtri_corner corners[3] = {{{Q16(-1), Q16(-1), 0, Q16_ONE}, {255, 255, 255}, {0, 0}},
                              {{Q16(3), Q16(-1), 0, Q16_ONE}, {255, 255, 255}, {0, 0}},
                              {{Q16(-1), Q16(3), 0, Q16_ONE}, {255, 255, 255}, {0, 0}}};
    qtri_view_init(&view, 1, 1);
    qtri_draw_triangles(&one.surface, &view, &pose, corners, 3, &material);
    assert_int_equal(stored_pixel(&one.surface, 0, 0), 255);
    assert_int_equal(stored_depth(&one.surface, 0, 0), 32768); /* the half rounds up */
    canvas_free(&one);
}

/* Clip-space corners with any w: the three share a scale, the picture does not depend on it. */
TEST(homogeneous)
{
    uint64_t seed = 105;
    for (int n = 0; n < random_cases(2000); n++) {
        canvas a = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        canvas b = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        qtri_view view;
        qtri_transform pose;
        qtri_corner corners[2][3];
        start_view(&view, &pose, WIDTH, HEIGHT);
        for (int i = 0; i < 3; i++) {
            q16 *p[2] = {&corners[0][i].position.x, &corners[1][i].position.x};
            for (int k = 0; k < 4; k++) {
                p[0][k] = random_in(&seed, -200000, 200000);
                p[1][k] = p[0][k] * 4096; /* exactly the same point */
            }
            corners[0][i].color.r = (uint8_t)random64(&seed);
            corners[0][i].color.g = (uint8_t)random64(&seed);
            corners[0][i].color.b = 200;
            corners[0][i].uv.x = corners[0][i].uv.y = 0;
            corners[1][i].color = corners[0][i].color;
            corners[1][i].uv = corners[0][i].uv;
        }
        qtri_material material = random_material(&seed);
        material.texture = NULL;
        qtri_draw_triangles(&a.surface, &view, &pose, corners[0], 3, &material);
        qtri_draw_triangles(&b.surface, &view, &pose, corners[1], 3, &material);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            assert_int_equal(stored_pixel(&a.surface, i % WIDTH, i / WIDTH) == 0,
                             stored_pixel(&b.surface, i % WIDTH, i / WIDTH) == 0);
        }
        canvas_free(&a);
        canvas_free(&b);
    }
}

static void fill_random(void *memory, size_t bytes, uint64_t *seed)
{
    for (size_t i = 0; i < bytes; i++) {
        ((uint8_t *)memory)[i] = (uint8_t)random64(seed);
    }
}

/* Random bits in every field that is not a pointer or a bool. */
/* Lights of any bits, of kinds and tables that exist. */
static void random_lights(qtri_light *lights, qtri_light_source sources[QTRI_LIGHTS_MAX],
                          const qtri_shininess *table, uint64_t *seed)
{
    static const qtri_light_kind *const kinds[] = {&qtri_directional_light, &qtri_point_light,
                                                   &qtri_spot_light, NULL};
    qtri_light_color ambient;
    fill_random(&ambient, sizeof ambient, seed);
    fill_random(sources, QTRI_LIGHTS_MAX * sizeof *sources, seed);
    for (int i = 0; i < QTRI_LIGHTS_MAX; i++) {
        sources[i].kind = kinds[random_in(seed, 0, 3)];
        sources[i].falloff = random_flag(seed) ? table : NULL;
    }
    (void)qtri_light_init(lights, sources, (uint32_t)random_in(seed, 0, 9), ambient);
}

TEST(garbage)
{
    static full_mesh m;
    static qtri_vertex scratch[QTRI_LIT_VERTICES(VERTICES)];
    static qtri_corner corners[12];
    static qtri_normal normals[12];
    uint64_t seed = 106;
    canvas c = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    for (int n = 0; n < random_cases(8000); n++) {
        qtri_view view;
        qtri_transform pose;
        qtri_light light = {.ambient = 0};
        qtri_light lights;
        qtri_light_source sources[QTRI_LIGHTS_MAX];
        qtri_shininess table;
        qtri_reflection reflection;
        fill_random(&view, sizeof view, &seed);
        fill_random(&pose, sizeof pose, &seed);
        fill_random(&light, offsetof(qtri_light, model), &seed);
        fill_random(m.position, sizeof m.position, &seed);
        fill_random(m.normal, sizeof m.normal, &seed);
        fill_random(m.uv, sizeof m.uv, &seed);
        fill_random(m.triangle, sizeof m.triangle, &seed);
        fill_random(corners, sizeof corners, &seed);
        fill_random(scratch, sizeof scratch, &seed);
        if (n % 3 != 0) { /* a pose and camera that let something through */
            random_view(&view, &seed);
            random_pose(&pose, &seed);
        }
        if (n % 6 == 1) {
            fill_random(&view.viewport, sizeof view.viewport, &seed);
        }
        for (int i = 0; i < 4 && n % 3 == 0; i++) { /* exponents of any size, small ones too */
            pose.row[i].exponent >>= random_in(&seed, 0, 28);
            view.camera.row[i].exponent >>= random_in(&seed, 0, 28);
        }
        for (int i = 0; i < TRIANGLES * 3; i++) {
            m.triangle[i / 3][i % 3] %= VERTICES + 1;
        }
        qtri_mesh mesh = {.positions = m.position,
                          .normals = random_flag(&seed) ? m.normal : NULL,
                          .uvs = random_flag(&seed) ? m.uv : NULL,
                          .colors = random_flag(&seed) ? m.color : NULL,
                          .triangles = (const uint16_t(*)[3])m.triangle,
                          .vertex_count = VERTICES,
                          .triangle_count = TRIANGLES};
        fill_random(m.position16, sizeof m.position16, &seed);
        fill_random(m.normal8, sizeof m.normal8, &seed);
        fill_random(m.uv16, sizeof m.uv16, &seed);
        fill_random(&mesh.origin, sizeof mesh.origin, &seed);
        mesh.positions16 = random_flag(&seed) ? m.position16 : NULL;
        mesh.normals8 = random_flag(&seed) ? m.normal8 : NULL;
        mesh.uvs16 = random_flag(&seed) ? m.uv16 : NULL;
        mesh.extent = random_any(&seed);
        if (random_flag(&seed)) {
            fill_random(&mesh.bounds, sizeof mesh.bounds, &seed);
        }
        view.light = random_flag(&seed) ? &light : NULL;
        view.pipelines = random_flag(&seed) ? qtri_pipelines_default : NULL;
        const bool has_scratch = random_flag(&seed);
        give_vertices(&view, has_scratch ? scratch : NULL, has_scratch ? LENGTH_OF(scratch) : 0);
        qtri_shininess_init(&table, random_any(&seed));
        random_lights(&lights, sources, &table, &seed);
        if (random_flag(&seed)) {
            view.light = &lights;
        }
        fill_random(&reflection.ambient, sizeof reflection.ambient, &seed);
        fill_random(&reflection.specular, sizeof reflection.specular, &seed);
        fill_random(&reflection.emission, sizeof reflection.emission, &seed);
        reflection.shininess = random_flag(&seed) ? &table : NULL;
        reflection.own_ambient = random_flag(&seed);
        reflection.two_sided = random_flag(&seed);
        qtri_texture texture = checker;
        texture.fields = (uint16_t)random64(&seed);
        texture.width_log2 = (uint8_t)random64(&seed);
        texture.wrap_u = (qtri_wrap)random_bits32(&seed);
        texture.wrap_v = (qtri_wrap)random_in(&seed, 0, 1);
        texture.filter = random_in(&seed, 0, 2) == 1 ? &qtri_bilinear : NULL;
        texture.has_key = random_flag(&seed);
        texture.key = (uint32_t)random_in(&seed, 0, 2);
        qtri_material material = random_material(&seed);
        material.texture = random_flag(&seed) ? &texture : NULL;
        material.cull = (qtri_cull)random_bits32(&seed);
        material.shading = random_flag(&seed) ? NULL : QTRI_SMOOTH;
        material.fill = random_bits32(&seed) >> 30 != 0 ? &qtri_wireframe : NULL;
        material.depth_compare = (qtri_compare)random_bits32(&seed);
        material.reflection = random_flag(&seed) ? &reflection : NULL;
        fill_random(normals, sizeof normals, &seed);
        qtri_draw_mesh(&c.surface, &view, &pose, &mesh, &material);
        qtri_draw_triangles(&c.surface, &view, &pose, corners, 12, &material);
        qtri_draw_lit_triangles(&c.surface, &view, &pose, corners, normals, 12, &material);
        qtri_draw_lines(&c.surface, &view, &pose, corners, 12, &material);
    }
    canvas_free(&c);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
