/* SPDX-License-Identifier: MIT */
/*
 * light.h through draw calls: the same pixels with any memory, in bands, of meshes and of loose
 * triangles; the other side; power tables; spheres; and any bits as arguments.
 */
#include "support/faces.h"
#include "support/layouts.h"
#include "support/transform.h"

#include "geometry/illumination.h"

enum { WIDTH = 64, HEIGHT = 48, ROWS = 7 };

static uint16_t texels[16 * 16];
static const qtri_texture texture = {
    .texels = texels, .format = &qtri_texel_rgb565, .width_log2 = 4, .height_log2 = 4};

/* Lights, and what they point to. */
typedef struct lamps {
    qtri_light_source sources[QTRI_LIGHTS_MAX];
    qtri_shininess shininess, falloff;
    qtri_reflection reflection;
    qtri_light lights;
} lamps;

static q16 random_q16(uint64_t *seed, double low, double high)
{
    return (q16)lrint(faces_random(seed, low, high) * 65536);
}

static qtri_rgb random_rgb(uint64_t *seed)
{
    const qtri_rgb rgb = {(uint8_t)random64(seed), (uint8_t)random64(seed),
                          (uint8_t)random64(seed)};
    return rgb;
}

static void lamps_make(lamps *l, uint64_t *seed)
{
    static const qtri_light_kind *const kinds[] = {&qtri_directional_light, &qtri_point_light,
                                                   &qtri_spot_light};
    const uint32_t count = (uint32_t)random_in(seed, 0, 5);
    const qtri_light_color ambient = {random_q16(seed, 0, .3), random_q16(seed, 0, .3), 3000};
    memset(l, 0, sizeof *l);
    for (uint32_t i = 0; i < count; i++) {
        qtri_light_source *s = &l->sources[i];
        s->kind = kinds[random_in(seed, 0, 2)];
        s->position = random_vec3(seed, 19);
        s->direction = random_vec3(seed, 18);
        s->color.r = random_q16(seed, 0, 1.5);
        s->color.g = random_q16(seed, 0, 1.5);
        s->color.b = random_q16(seed, 0, 1.5);
        s->constant = random_q16(seed, .5, 2);
        s->quadratic = random_q16(seed, 0, .3);
        s->inner = random_q16(seed, 0, 40);
        s->outer = random_q16(seed, 40, 120);
        s->falloff = random_flag(seed) ? &l->falloff : NULL;
    }
    qtri_shininess_init(&l->shininess, random_q16(seed, 1, 60));
    qtri_shininess_init(&l->falloff, random_q16(seed, 1, 10));
    l->reflection.specular = random_rgb(seed);
    l->reflection.emission.b = 20;
    l->reflection.shininess = random_flag(seed) ? &l->shininess : NULL;
    l->reflection.two_sided = random_flag(seed);
    l->reflection.own_ambient = random_flag(seed);
    l->reflection.ambient = random_rgb(seed);
    assert_ok(qtri_light_init(&l->lights, l->sources, count, ambient));
}

static qtri_material random_material(uint64_t *seed, const lamps *l)
{
    qtri_material material = qtri_material_default();
    material.color = random_rgb(seed);
    material.shading = random_flag(seed) ? QTRI_PER_PIXEL : shading_of((int)random_in(seed, 0, 2));
    material.cull = (qtri_cull)random_in(seed, 0, 2);
    material.fill = random_in(seed, 0, 3) == 0 ? &qtri_wireframe : NULL;
    material.texture = random_in(seed, 0, 3) == 0 ? &texture : NULL;
    material.interpolation = random_flag(seed) ? QTRI_SCREEN_LINEAR : QTRI_PERSPECTIVE;
    material.reflection = random_in(seed, 0, 3) != 0 ? &l->reflection : NULL;
    return material;
}

static qtri_vertex vertices[QTRI_LIT_VERTICES(FACES_VERTICES)];
static uint16_t lists[QTRI_PREPARED_LISTS(FACES_TRIANGLES, HEIGHT, ROWS)];

/* Band by band, below each other in the memory of the whole frame. */
static void draw_in_bands(canvas *whole, uint32_t vertex_count, uint32_t list_count,
                          const qtri_view *view, const qtri_transform *pose, const qtri_mesh *mesh,
                          const qtri_material *material)
{
    static uint8_t memory[QTRI_FRAME_BYTES(WIDTH, ROWS, QTRI_XRGB8888_BYTES)];
    qtri_frame frame;
    qtri_prepared prepared;
    assert_ok(qtri_frame_init(&frame, &qtri_xrgb8888, WIDTH, HEIGHT, ROWS, memory, sizeof memory));
    prepared_init_with(&prepared, vertices, vertex_count, lists, list_count);
    qtri_prepare_mesh(&prepared, &frame, view, pose, mesh, material);
    draw_in_bands_of(whole, &frame, &prepared);
}

static void forget(void)
{
    memset(vertices, 0xA5, sizeof vertices);
}

/* A mesh is the same with colours kept, with vertices kept, with few and none, and in bands. */
TEST(any_memory)
{
    static faces_mesh m;
    static qtri_rgb colors[FACES_VERTICES];
    static qtri_vec2 uvs[FACES_VERTICES];
    uint64_t seed = 3;
    int painted = 0;
    for (int i = 0; i < FACES_VERTICES; i++) {
        colors[i] = random_rgb(&seed);
        uvs[i].x = random_q16(&seed, 0, 3);
        uvs[i].y = random_q16(&seed, 0, 3);
    }
    for (size_t i = 0; i < LENGTH_OF(texels); i++) {
        texels[i] = (uint16_t)random64(&seed);
    }
    for (int n = 0; n < random_cases(400); n++) {
        if (n % 8 == 0) {
            faces_mesh_make(&m, &seed, n % 16 == 0 ? 0 : .05);
        }
        qtri_mesh mesh = n % 2 != 0 ? m.wide : m.compact;
        mesh.colors = random_flag(&seed) ? colors : NULL;
        mesh.uvs = uvs;
        if (random_in(&seed, 0, 3) == 0) {
            mesh.normals = NULL;
            mesh.normals8 = NULL;
        }
        lamps l;
        qtri_view view;
        qtri_transform pose;
        lamps_make(&l, &seed);
        const qtri_material material = random_material(&seed, &l);
        faces_view(&view, &seed, WIDTH, HEIGHT);
        faces_pose(&pose, &seed, &mesh);
        view.light = &l.lights;
        canvas first = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        canvas other = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        qtri_draw_mesh(&first.surface, &view, &pose, &mesh, &material);
        const uint32_t counts[] = {LENGTH_OF(vertices), LENGTH_OF(vertices) - 1, FACES_VERTICES, 9};
        for (size_t i = 0; i < LENGTH_OF(counts); i++) {
            canvas_clear(&other);
            forget();
            give_vertices(&view, vertices, counts[i]);
            qtri_draw_mesh(&other.surface, &view, &pose, &mesh, &material);
            assert_same_picture(&first.surface, &other.surface);
            canvas_clear(&other);
            forget();
            draw_in_bands(&other, counts[i], i % 2 == 0 ? LENGTH_OF(lists) : 50, &view, &pose,
                          &mesh, &material);
            assert_same_picture(&first.surface, &other.surface);
        }
        painted += count_painted(&first.surface);
        canvas_free(&first);
        canvas_free(&other);
    }
    print_message("%d pixels\n", painted);
    assert_true(painted > random_cases(50000));
}

/* A mesh is the same drawn with its outline, and edges are lit where they are strokes. */
TEST(outlines_and_edges)
{
    static faces_mesh m;
    static uint32_t words[QTRI_OUTLINE_WORDS(FACES_TRIANGLES) + QTRI_OUTLINE_SUMS(FACES_VERTICES)];
    uint64_t seed = 9;
    int lit = 0;
    for (int n = 0; n < random_cases(100); n++) {
        faces_mesh_make(&m, &seed, 0);
        const qtri_mesh mesh = n % 2 != 0 ? m.wide : m.compact;
        lamps l;
        qtri_view view;
        qtri_transform pose;
        qtri_outline outline;
        lamps_make(&l, &seed);
        const qtri_material material = random_material(&seed, &l);
        qtri_stroke stroke = qtri_stroke_default();
        stroke.width = random_q16(&seed, .5, 6);
        stroke.cap = random_flag(&seed) ? QTRI_CAP_BUTT : QTRI_CAP_ROUND;
        faces_view(&view, &seed, WIDTH, HEIGHT);
        faces_pose(&pose, &seed, &mesh);
        view.light = &l.lights;
        give_vertices(&view, vertices, random_flag(&seed) ? LENGTH_OF(vertices) : FACES_VERTICES);
        canvas first = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        canvas other = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        assert_ok(qtri_outline_init(&outline, &mesh, words, LENGTH_OF(words)));
        qtri_draw_mesh(&first.surface, &view, &pose, &mesh, &material);
        assert_ok(qtri_draw_mesh_outlined(&other.surface, &view, &pose, &material, &outline));
        assert_same_picture(&first.surface, &other.surface);
        canvas_clear(&first);
        canvas_clear(&other);
        qtri_draw_wide_wireframe(&first.surface, &view, &pose, &mesh, &stroke, &material);
        qtri_draw_hidden_lines(&other.surface, &view, &pose, &mesh, &stroke, &material, Q16(.002));
        lit += count_painted(&first.surface);
        canvas_free(&first);
        canvas_free(&other);
    }
    assert_true(lit > 1000);
}

/*
 * Its triangles one by one, with and without normals, whole and clipped, are the mesh: but for
 * roundings, as small triangles of meshes are drawn by other sums. Where two triangles meet in a
 * pixel these decide which is seen. By pixel colours are not compared: those of meshes that are
 * smaller than 6 pixels are lit by vertex.
 */
TEST(loose_triangles)
{
    int drawn = 0, apart = 0;
    static faces_mesh m;
    static qtri_corner corners[3 * FACES_TRIANGLES];
    static qtri_normal normals[3 * FACES_TRIANGLES];
    uint64_t seed = 5;
    for (int n = 0; n < random_cases(200); n++) {
        faces_mesh_make(&m, &seed, 0);
        qtri_mesh mesh = m.wide;
        const bool has_normals = random_flag(&seed);
        lamps l;
        qtri_view view;
        qtri_transform pose;
        lamps_make(&l, &seed);
        qtri_material material = random_material(&seed, &l);
        material.texture = NULL;
        material.fill = NULL;
        faces_view(&view, &seed, WIDTH, HEIGHT);
        faces_pose(&pose, &seed, &mesh);
        view.light = &l.lights;
        mesh.normals = has_normals ? mesh.normals : NULL;
        for (uint32_t i = 0; i < 3 * mesh.triangle_count; i++) {
            const uint32_t vertex = mesh.triangles[i / 3][i % 3];
            const qtri_vec3 *p = &mesh.positions[vertex];
            const qtri_corner corner = {{p->x, p->y, p->z, Q16_ONE}, material.color, {0, 0}};
            corners[i] = corner;
            normals[i] = m.normal[vertex];
        }
        canvas first = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        canvas other = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        qtri_draw_mesh(&first.surface, &view, &pose, &mesh, &material);
        qtri_draw_lit_triangles(&other.surface, &view, &pose, corners, has_normals ? normals : NULL,
                                3 * mesh.triangle_count, &material);
        drawn += count_painted(&first.surface);
        apart += count_depths_apart(&first.surface, &other.surface, 1);
        if (material.shading != QTRI_PER_PIXEL) {
            apart += count_apart(&first.surface, &other.surface, 1);
        }
        /* Without lights they are what qtri_draw_triangles draws. */
        canvas_clear(&first);
        canvas_clear(&other);
        view.light = NULL;
        qtri_draw_triangles(&first.surface, &view, &pose, corners, 3 * mesh.triangle_count,
                            &material);
        qtri_draw_lit_triangles(&other.surface, &view, &pose, corners, normals,
                                3 * mesh.triangle_count, &material);
        assert_same_picture(&first.surface, &other.surface);
        canvas_free(&first);
        canvas_free(&other);
    }
    print_message("%d of %d pixels are not those of the mesh\n", apart, drawn);
    assert_true(apart <= drawn / 500);
}

/* ---- By pixel ---- */

/* Corner i at a place of the screen, in pixels; the view has neither camera nor projection. */
static qtri_corner corner_on_screen(double x, double y, qtri_rgb color)
{
    const qtri_corner corner = {{(q16)lrint((2 * x / WIDTH - 1) * 65536),
                                 (q16)lrint((1 - 2 * y / HEIGHT) * 65536), 0, Q16_ONE},
                                color,
                                {0, 0}};
    return corner;
}

static void draw_flat_on(canvas *c, const lamps *l, const qtri_corner *corners,
                         const qtri_normal *normals, const qtri_material *material)
{
    qtri_view view;
    qtri_transform pose;
    start_view(&view, &pose, WIDTH, HEIGHT);
    view.light = l != NULL ? &l->lights : NULL;
    canvas_clear(c);
    if (l != NULL) {
        qtri_draw_lit_triangles(&c->surface, &view, &pose, corners, normals, 3, material);
    } else {
        qtri_draw_triangles(&c->surface, &view, &pose, corners, 3, material);
    }
}

static lamps lamps_of(const qtri_light_source *sources, uint32_t count, q16 ambient)
{
    lamps l;
    const qtri_light_color color = {ambient, ambient, ambient};
    memset(&l, 0, sizeof l);
    memcpy(l.sources, sources, count * sizeof *sources);
    assert_ok(qtri_light_init(&l.lights, l.sources, count, color));
    return l;
}

/* Corners that differ in one channel of one of them: in full light as without any. */
TEST(colors_of_corners)
{
    const qtri_light_source off = {.kind = NULL};
    qtri_material material = qtri_material_default();
    canvas lit = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    canvas plain = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    material.cull = QTRI_CULL_NONE;
    for (int n = 0; n < 18; n++) {
        lamps l = lamps_of(&off, 0, Q16_ONE);
        l.lights.sources = l.sources; /* of the copy */
        const qtri_normal front = {0, 0, 16384};
        const qtri_normal aside = {0, 11585, 11585};
        qtri_rgb color[3] = {{90, 80, 70}, {90, 80, 70}, {90, 80, 70}};
        qtri_rgb *other = &color[n % 3];
        uint8_t *const channel[3] = {&other->r, &other->g, &other->b};
        *channel[n / 3 % 3] = 230;
        const qtri_corner corners[3] = {corner_on_screen(2, 3, color[0]),
                                        corner_on_screen(60, 7, color[1]),
                                        corner_on_screen(20, 44, color[2])};
        const qtri_normal normals[3] = {front, n < 9 ? front : aside, front};
        material.shading = QTRI_PER_PIXEL;
        draw_flat_on(&lit, &l, corners, normals, &material);
        material.shading = QTRI_SMOOTH;
        draw_flat_on(&plain, NULL, corners, NULL, &material);
        uint32_t seen = 0;
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const uint32_t a = stored_pixel(&lit.surface, i % WIDTH, i / WIDTH);
            const uint32_t b = stored_pixel(&plain.surface, i % WIDTH, i / WIDTH);
            for (int k = 0; k < 24; k += 8) {
                assert_near(a >> k & 255, b >> k & 255, 1);
            }
            seen += b != 0;
        }
        assert_true(seen > 800);
    }
    canvas_free(&lit);
    canvas_free(&plain);
}

/* Normals turn from one side to the other: halfway there is none, and no light but the ambient. */
TEST(normals_that_vanish)
{
    enum { MIDDLE = WIDTH / 2 };
    const qtri_light_source source[2] = {
        {.kind = &qtri_directional_light, .position = {0, 0, Q16_ONE}, .color = {Q16_ONE, 0, 0}},
        {.kind = &qtri_directional_light, .position = {0, 0, -Q16_ONE}, .color = {0, 0, Q16_ONE}}};
    lamps l = lamps_of(source, 2, Q16(.25));
    l.lights.sources = l.sources; /* of the copy */
    const qtri_rgb gray = {128, 128, 128};
    const qtri_normal front = {0, 0, 16384};
    const qtri_normal back = {0, 0, -16384};
    qtri_material material = qtri_material_default();
    material.shading = QTRI_PER_PIXEL;
    material.cull = QTRI_CULL_NONE;
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    for (int perspective = 0; perspective < 2; perspective++) {
        /* A weight of half, rounded down, would be less: the finest step of the screen makes it
           more, in a triangle so wide that this is below 2^-15. */
        const double finest = 1 / 256.;
        const qtri_corner corners[3] = {corner_on_screen(MIDDLE - 511.5 - finest, HEIGHT / 2, gray),
                                        corner_on_screen(MIDDLE + 512.5, HEIGHT / 2 + 16, gray),
                                        corner_on_screen(MIDDLE + 512.5, HEIGHT / 2 - 16, gray)};
        const qtri_normal normals[3] = {front, back, back};
        material.interpolation = perspective != 0 ? QTRI_PERSPECTIVE : QTRI_SCREEN_LINEAR;
        draw_flat_on(&c, &l, corners, normals, &material);
        for (int32_t y = HEIGHT / 2 - 4; y < HEIGHT / 2 + 4; y++) {
            assert_int_equal(stored_pixel(&c.surface, MIDDLE - 1, y) & 0xFFFFFF, 0xA02020);
            assert_int_equal(stored_pixel(&c.surface, MIDDLE, y) & 0xFFFFFF, 0x202020);
            assert_int_equal(stored_pixel(&c.surface, MIDDLE + 1, y) & 0xFFFFFF, 0x2020A0);
        }
    }
    canvas_free(&c);
}

/*
 * A corner is snapped to the middle of a pixel, and truly lies beside it, in the triangle. So 1/w
 * is more at that pixel than at any corner, up to 2^31 and beyond, as w is 1 there and 4 at the
 * others; the light is that of the corner. The far plane clips the triangle: of others that have no
 * texture no true positions are asked for.
 */
TEST(corners_that_lie_beside_their_pixels)
{
    enum { X = 10, Y = 24 };
    const qtri_light_source source = {
        .kind = &qtri_directional_light, .position = {0, 0, Q16_ONE}, .color = {Q16_ONE, 0, 0}};
    lamps l = lamps_of(&source, 1, Q16(.25));
    l.lights.sources = l.sources; /* of the copy */
    const qtri_rgb gray = {128, 128, 128};
    const qtri_normal front = {0, 0, 16384};
    const qtri_normal back = {0, 0, -16384};
    qtri_material material = qtri_material_default();
    material.shading = QTRI_PER_PIXEL;
    material.cull = QTRI_CULL_NONE;
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    for (int n = 0; n < 28; n++) { /* less than 1/512 pixel to the right, up and down */
        const double right = n / 7 / 2048.0, down = (n % 7 - 3) / 2048.0;
        qtri_corner corners[3] = {corner_on_screen(X + 0.5 + right, Y + 0.5 + down, gray),
                                  corner_on_screen(60, 4, gray), corner_on_screen(60, 44, gray)};
        const qtri_normal normals[3] = {front, back, back};
        for (int i = 1; i < 3; i++) {
            corners[i].position.x *= 4;
            corners[i].position.y *= 4;
            corners[i].position.w *= 4;
        }
        corners[2].position.z = 2 * corners[2].position.w;
        draw_flat_on(&c, &l, corners, normals, &material);
        assert_int_equal(stored_pixel(&c.surface, X - 1, Y) & 0xFFFFFF, 0);
        assert_int_equal(stored_pixel(&c.surface, X, Y) & 0xFFFFFF, 0xA02020);
    }
    canvas_free(&c);
}

/*
 * Small triangles with four samples a pixel, whose blend asks for alpha of vertices, take the way
 * of large ones. Where all is opaque and light the same everywhere it is that of the others.
 */
TEST(samples_and_alphas)
{
    static faces_mesh m;
    uint64_t seed = 15;
    uint8_t alphas[FACES_VERTICES];
    memset(alphas, 255, sizeof alphas);
    const qtri_light_source off = {.kind = NULL};
    lamps l = lamps_of(&off, 0, Q16(.75));
    l.lights.sources = l.sources; /* of the copy */
    uint32_t seen = 0;
    for (int n = 0; n < 20; n++) {
        qtri_view view;
        qtri_transform pose;
        qtri_surface resolved[2];
        canvas c[2];
        qtri_material material = qtri_material_default();
        faces_mesh_make(&m, &seed, 0);
        faces_view(&view, &seed, WIDTH, HEIGHT);
        faces_pose(&pose, &seed, &m.wide);
        view.light = &l.lights;
        material.color = random_rgb(&seed);
        material.shading = QTRI_PER_PIXEL;
        material.alphas = alphas;
        for (int i = 0; i < 2; i++) {
            const qtri_rgb black = {0, 0, 0};
            material.blend = i == 0 ? NULL : &qtri_blend_vertex_alpha;
            c[i] = canvas_new(&qtri_xrgb8888_x4, WIDTH, HEIGHT);
            qtri_samples_clear(&c[i].surface, black);
            qtri_draw_mesh(&c[i].surface, &view, &pose, &m.wide, &material);
            assert_ok(qtri_samples_resolve(&c[i].surface, &resolved[i]));
        }
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const uint32_t a = stored_pixel(&resolved[0], i % WIDTH, i / WIDTH);
            const uint32_t b = stored_pixel(&resolved[1], i % WIDTH, i / WIDTH);
            for (int k = 0; k < 24; k += 8) {
                assert_near(a >> k & 255, b >> k & 255, 1);
            }
            seen += (a & 0xFFFFFF) != 0;
        }
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
    assert_true(seen > 3000);
}

/* A square that shows its back is lit as one that shows its front from the other side. */
TEST(two_sides)
{
    static const uint16_t front[2][3] = {{0, 1, 2}, {0, 2, 3}};
    static const uint16_t back[2][3] = {{0, 2, 1}, {0, 3, 2}};
    uint64_t seed = 6;
    for (int n = 0; n < random_cases(100); n++) {
        const double size = n % 2 != 0 ? 1 : 40; /* the large one is clipped */
        qtri_vec3 p[4];
        qtri_normal towards[4];
        qtri_normal away[4];
        for (int i = 0; i < 4; i++) {
            p[i] = vec3_of(i == 0 || i == 3 ? -size : size, i < 2 ? -size : size, -1);
            const qtri_normal normal = {(int16_t)random_in(&seed, -9000, 9000),
                                        (int16_t)random_in(&seed, -9000, 9000), 12000};
            const qtri_normal opposite = {(int16_t)-normal.x, (int16_t)-normal.y,
                                          (int16_t)-normal.z};
            towards[i] = normal;
            away[i] = opposite;
        }
        lamps l;
        qtri_view view;
        qtri_transform pose;
        lamps_make(&l, &seed);
        l.reflection.two_sided = true;
        qtri_material material = plain_material();
        material.shading = n % 3 == 0 ? QTRI_FLAT_LAST : QTRI_SMOOTH;
        material.reflection = &l.reflection;
        qtri_view_init(&view, WIDTH, HEIGHT);
        qtri_transform_perspective(&view.projection, Q16(60), Q16(1), Q16(.1), Q16(50));
        qtri_transform_identity(&pose);
        qtri_transform_rotate_x(&pose, n % 4 < 2 ? 0 : Q16(30));
        view.light = &l.lights;
        qtri_mesh mesh = {.positions = p,
                          .normals = towards,
                          .triangles = front,
                          .vertex_count = 4,
                          .triangle_count = 2};
        canvas first = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        canvas other = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        qtri_draw_mesh(&first.surface, &view, &pose, &mesh, &material);
        mesh.normals = away;
        mesh.triangles = back;
        qtri_draw_mesh(&other.surface, &view, &pose, &mesh, &material);
        if (material.shading == QTRI_SMOOTH) { /* from another corner: roundings differ */
            assert_close(&first.surface, &other.surface, 1);
        }
        canvas_free(&first);
        canvas_free(&other);
    }
}

TEST(power_tables)
{
    double worst = 0;
    uint64_t seed = 7;
    for (int n = 0; n < random_cases(300); n++) {
        const q16 shininess = n < 128 ? Q16(1) * (n + 1) : random_q16(&seed, 1, 1024);
        qtri_shininess table;
        qtri_shininess_init(&table, shininess);
        for (int i = 0; i < 2000; i++) {
            const uint32_t t_q29 = (uint32_t)(random64(&seed) >> (35 + random_in(&seed, 0, 12)));
            const double t = ldexp(t_q29, -29);
            const double exact = t < 1 ? pow(1 - t, real(shininess)) : 0;
            worst = fmax(worst, fabs(qtri_shininess_at(&table, t_q29) / 32768.0 - exact));
        }
    }
    print_message("powers off by %.5f at most\n", worst);
    assert_true(worst < 1. / 512); /* .00098 where it ends, 2^-10 */
    const q16 any[] = {INT32_MIN, -1, 0, 1, Q16(.5), INT32_MAX};
    for (size_t i = 0; i < LENGTH_OF(any); i++) {
        qtri_shininess held;
        qtri_shininess same;
        memset(&held, 0, sizeof held);
        memset(&same, 0, sizeof same);
        qtri_shininess_init(&held, any[i]);
        qtri_shininess_init(&same, any[i] > Q16_ONE ? 1024 * Q16_ONE : Q16_ONE);
        assert_memory_equal(&held, &same, sizeof held);
    }
}

TEST(spheres)
{
    static faces_mesh m;
    static qtri_uv16 uvs[FACES_VERTICES];
    uint64_t seed = 8;
    double worst = 0;
    for (int n = 0; n < 60; n++) {
        faces_mesh_make(&m, &seed, 0);
        qtri_transform camera;
        qtri_transform pose;
        const qtri_vec3 up = {0, Q16_ONE, 0};
        qtri_transform_identity(&camera);
        qtri_transform_look_at(&camera, random_vec3(&seed, 18), random_vec3(&seed, 16), up);
        qtri_transform_identity(&pose);
        qtri_transform_rotate_x(&pose, random_angle(&seed));
        qtri_transform_rotate_z(&pose, random_angle(&seed));
        qtri_transform_mul(&camera, &camera, &pose);
        qtri_transform_identity(&pose);
        qtri_sphere_map(uvs, &camera, &pose, n % 2 != 0 ? &m.wide : &m.compact);
        for (int i = 0; i < FACES_VERTICES; i++) {
            double v[3] = {m.normal[i].x, m.normal[i].y, m.normal[i].z};
            if (n % 2 == 0) {
                v[0] = m.normal8[i].x;
                v[1] = m.normal8[i].y;
                v[2] = m.normal8[i].z;
            }
            const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
            double eye[2];
            for (int k = 0; k < 2; k++) {
                eye[k] = (element(&camera, k, 0) * v[0] + element(&camera, k, 1) * v[1] +
                          element(&camera, k, 2) * v[2]) /
                         length;
            }
            worst = fmax(worst, fabs(uvs[i].x / 16384.0 - (1 + eye[0]) / 2));
            worst = fmax(worst, fabs(uvs[i].y / 16384.0 - (1 - eye[1]) / 2));
        }
    }
    print_message("sphere map off by %.6f at most\n", worst);
    assert_true(worst < 1. / 8192);
    qtri_mesh bare = m.wide;
    bare.normals = NULL;
    qtri_transform same;
    qtri_transform_identity(&same);
    qtri_sphere_map(uvs, &same, &same, &bare);
    assert_int_equal(uvs[5].x, 8192);
    assert_int_equal(uvs[5].y, 8192);
}

TEST(too_many)
{
    static const qtri_light_source sources[QTRI_LIGHTS_MAX + 1];
    const qtri_light_color none = {0, 0, 0};
    qtri_light lights;
    assert_ok(qtri_light_init(&lights, sources, QTRI_LIGHTS_MAX, none));
    assert_int_equal(qtri_light_init(&lights, sources, QTRI_LIGHTS_MAX + 1, none), QTRI_ERROR_SIZE);
    assert_int_equal(lights.count, QTRI_LIGHTS_MAX);
}

static qtri_vec3 any_vec3(uint64_t *seed)
{
    const qtri_vec3 v = {random_any(seed), random_any(seed), random_any(seed)};
    return v;
}

static void any_transform(uint64_t *seed, qtri_transform *t)
{
    qtri_mat4 m;
    for (int i = 0; i < 16; i++) {
        m.m[i / 4][i % 4] = random_any(seed);
    }
    if (random_flag(seed)) {
        qtri_transform_from_mat4(t, &m);
        return;
    }
    qtri_transform_identity(t);
    qtri_transform_translate(t, any_vec3(seed));
    qtri_transform_rotate(t, random_any(seed), any_vec3(seed));
    const q16 k = random_any(seed);
    const qtri_vec3 factor = {k, random_in(seed, 0, 3) != 0 ? k : 0, k};
    qtri_transform_scale(t, factor);
}

/* Nothing overflows, whatever the arguments are: the sanitizers look on. */
TEST(any_bits)
{
    static const qtri_light_kind *const kinds[] = {&qtri_directional_light, &qtri_point_light,
                                                   &qtri_spot_light, NULL};
    uint64_t seed = 9;
    for (int n = 0; n < random_cases(20000); n++) {
        lamps l;
        qtri_view view;
        qtri_transform pose;
        lamps_make(&l, &seed);
        for (int i = 0; i < QTRI_LIGHTS_MAX; i++) {
            qtri_light_source *s = &l.sources[i];
            s->kind = kinds[random_in(&seed, 0, 3)];
            s->position = any_vec3(&seed);
            s->direction = any_vec3(&seed);
            s->color.r = random_any(&seed);
            s->color.g = random_any(&seed);
            s->color.b = random_any(&seed);
            s->constant = random_any(&seed);
            s->linear = random_any(&seed);
            s->quadratic = random_any(&seed);
            s->inner = random_any(&seed);
            s->outer = random_any(&seed);
        }
        const qtri_light_color ambient = {random_any(&seed), random_any(&seed), random_any(&seed)};
        (void)qtri_light_init(&l.lights, l.sources, (uint32_t)random_in(&seed, 0, 9), ambient);
        qtri_view_init(&view, WIDTH, HEIGHT);
        any_transform(&seed, &view.camera);
        any_transform(&seed, &pose);
        if (random_flag(&seed)) {
            qtri_transform_perspective(&view.projection, Q16(70), Q16(1), Q16(.1), Q16(1000));
        }
        view.light = &l.lights;
        qtri_material material = random_material(&seed, &l);
        qtri_corner corners[6];
        qtri_normal normals[6];
        qtri_vec3 positions[6];
        qtri_position16 positions16[6];
        qtri_normal8 normals8[6];
        static const uint16_t triangles[2][3] = {{0, 1, 2}, {3, 4, 5}};
        for (int i = 0; i < 6; i++) {
            const qtri_corner corner = {{random_any(&seed), random_any(&seed), random_any(&seed),
                                         random_flag(&seed) ? Q16_ONE : random_any(&seed)},
                                        random_rgb(&seed),
                                        {0, 0}};
            const qtri_normal normal = {(int16_t)random_any(&seed), (int16_t)random_any(&seed),
                                        (int16_t)random_any(&seed)};
            const qtri_position16 position = {(int16_t)random64(&seed), (int16_t)random64(&seed),
                                              (int16_t)random64(&seed)};
            const qtri_normal8 normal8 = {(int8_t)random64(&seed), (int8_t)random64(&seed),
                                          (int8_t)random64(&seed)};
            corners[i] = corner;
            normals[i] = normal;
            positions[i] = any_vec3(&seed);
            positions16[i] = position;
            normals8[i] = normal8;
        }
        const bool compact = random_flag(&seed);
        const qtri_mesh mesh = {.positions = positions,
                                .positions16 = compact ? positions16 : NULL,
                                .normals = random_flag(&seed) ? normals : NULL,
                                .normals8 = random_flag(&seed) ? normals8 : NULL,
                                .origin = any_vec3(&seed),
                                .extent = random_any(&seed),
                                .triangles = triangles,
                                .vertex_count = 6,
                                .triangle_count = 2};
        canvas c = canvas_new(&qtri_xrgb8888, 16, 16);
        qtri_draw_lit_triangles(&c.surface, &view, &pose, corners, normals, 6, &material);
        qtri_draw_mesh(&c.surface, &view, &pose, &mesh, &material);
        qtri_uv16 uvs[6];
        qtri_sphere_map(uvs, &view.camera, &pose, &mesh);
        /* What is not seen is lit as well. */
        qtri_illumination by;
        qtri_illumination_init(&by, &view, &pose, &l.reflection, compact ? &mesh : NULL);
        for (int i = 0; i < 6; i++) {
            qtri_lit_point point;
            qtri_illuminated_normal(&point, &by, normals[i].x, normals[i].y, normals[i].z);
            if (compact) {
                qtri_illuminated_place16(&point, &by, &positions16[i]);
            } else {
                qtri_illuminated_place(&point, &by, &positions[i]);
            }
            (void)qtri_illuminate(&by, &point, &corners[i].color);
        }
        canvas_free(&c);
    }
}

/* Sources of a kind are added by one call, whatever lies between them. */
TEST(sources_of_a_kind_are_one_run)
{
    static const qtri_light_kind *const kinds[] = {
        &qtri_directional_light, &qtri_point_light,      &qtri_directional_light, NULL,
        &qtri_point_light,       &qtri_directional_light};
    qtri_light_source sources[LENGTH_OF(kinds)] = {{0}};
    const qtri_light_color ambient = {0, 0, 0};
    const qtri_reflection reflection = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, NULL, false, false};
    qtri_light lights;
    qtri_view view;
    qtri_transform pose;
    qtri_illumination by;
    for (size_t i = 0; i < LENGTH_OF(kinds); i++) {
        sources[i].kind = kinds[i];
        sources[i].position.z = Q16(1) + (q16)i;
        sources[i].constant = Q16(1);
        sources[i].color.r = Q16(.5);
    }
    assert_ok(qtri_light_init(&lights, sources, LENGTH_OF(kinds), ambient));
    qtri_view_init(&view, 16, 16);
    view.light = &lights;
    qtri_transform_identity(&pose);
    qtri_illumination_init(&by, &view, &pose, &reflection, NULL);
    assert_int_equal(by.count, 2);
    assert_ptr_equal(by.run[0].kind, &qtri_directional_light);
    assert_int_equal(by.run[0].end - by.source, 3);
    assert_ptr_equal(by.run[1].kind, &qtri_point_light);
    assert_int_equal(by.run[1].end - by.source, 5);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
