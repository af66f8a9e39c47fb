/* SPDX-License-Identifier: MIT */
/*
 * The edge pass: exact shares, the same pixels for every band, scissor, format and memory, and
 * what it must leave alone.
 */
#include "support/core.h"
#include "support/layouts.h"

#include "tools/mesh_faces.h"
#include "tools/mesh_neighbours.h"

enum { WIDTH = 61, HEIGHT = 46, RINGS = 14, SIDES = 11, VERTICES = RINGS * SIDES };
enum { TRIANGLES = 2 * VERTICES, LISTS = 4000, WORDS = 4000 };

static const qtri_format *const formats[5] = {&qtri_rgb565, &qtri_xrgb8888, &qtri_gray8,
                                              &qtri_rgb565_swapped, &qtri_rgb888};
/* RGB565 by the blend of any format. */
static void encode_any(uint32_t *color, int32_t count)
{
    (void)color;
    (void)count;
}

static const qtri_format any_565 = {.pixels = &qtri_pixels_16,
                                    .colors = &qtri_colors_565,
                                    .encode = encode_any,
                                    .decode = qtri_decode_rgb565};
static const qtri_rgb sky = {10, 20, 30};
static const qtri_light sun = {
    .towards = {Q16(.4), Q16(.6), Q16(.7)}, .ambient = Q16(.2), .diffuse = Q16(.8)};

/* ---- A torus, closed or with holes, in all forms that a mesh has ---- */

static qtri_vec3 positions[VERTICES];
static qtri_normal normals[VERTICES];
static uint16_t triangles[TRIANGLES][3];
static uint8_t triangles8[TRIANGLES][3];
static uint16_t neighbours[TRIANGLES][3], neighbours_open[TRIANGLES][3];
static qtri_face8 planes[TRIANGLES];
static qtri_faces faces;
static qtri_vec3 origin;
static q16 extent;

static int make_torus(void **state)
{
    (void)state;
    const double turn = 2 * acos(-1.0);
    for (int i = 0; i < VERTICES; i++) {
        double a = turn * (i / SIDES) / RINGS, b = turn * (i % SIDES) / SIDES;
        double p[3] = {(1 + .45 * cos(b)) * cos(a), (1 + .45 * cos(b)) * sin(a), .45 * sin(b)};
        qtri_vec3 position = {(q16)lrint(p[0] * 65536), (q16)lrint(p[1] * 65536),
                              (q16)lrint(p[2] * 65536)};
        qtri_normal normal = {(int16_t)lrint(16384 * cos(b) * cos(a)),
                              (int16_t)lrint(16384 * cos(b) * sin(a)),
                              (int16_t)lrint(16384 * sin(b))};
        positions[i] = position;
        normals[i] = normal;
    }
    for (int ring = 0, t = 0; ring < RINGS; ring++) {
        for (int side = 0; side < SIDES; side++) {
            const int c[4] = {ring * SIDES + side, (ring + 1) % RINGS * SIDES + side,
                              (ring + 1) % RINGS * SIDES + (side + 1) % SIDES,
                              ring * SIDES + (side + 1) % SIDES};
            const int corner[2][3] = {{c[0], c[1], c[2]}, {c[0], c[2], c[3]}};
            for (int half = 0; half < 2; half++, t++) {
                for (int i = 0; i < 3; i++) {
                    triangles[t][i] = (uint16_t)corner[half][i];
                    triangles8[t][i] = (uint8_t)corner[half][i];
                }
            }
        }
    }
    qtri_mesh mesh = {.positions = positions,
                      .triangles = (const uint16_t(*)[3])triangles,
                      .vertex_count = VERTICES,
                      .triangle_count = TRIANGLES};
    assert_true(mesh_neighbours_make(&mesh, neighbours));
    (void)mesh_faces_fill(&mesh, planes);
    faces = mesh.faces;
    origin = mesh.origin;
    extent = mesh.extent;
    mesh.triangle_count = TRIANGLES - 40; /* with a hole */
    assert_true(mesh_neighbours_make(&mesh, neighbours_open));
    return 0;
}

/* The neighbour across an edge has it the other way round; a closed mesh has all of them. */
TEST(neighbours_are_found)
{
    int none = 0;
    for (int t = 0; t < TRIANGLES; t++) {
        for (int i = 0; i < 3; i++) {
            const int n = neighbours[t][i];
            bool back = false;
            assert_in_range(n, 0, TRIANGLES - 1);
            for (int k = 0; k < 3; k++) {
                back |= neighbours[n][k] == t && triangles[n][k] == triangles[t][(i + 1) % 3] &&
                        triangles[n][(k + 1) % 3] == triangles[t][i];
            }
            assert_true(back);
            none += t < TRIANGLES - 40 && neighbours_open[t][i] == TRIANGLES - 40;
        }
    }
    assert_in_range(none, 10, 60);
    /* Corners of their own, an edge of three triangles, an index that is not there. */
    static const qtri_vec3 corners[6] = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0},
                                         {0, 0, 0}, {9, 0, 0}, {0, 0, 9}};
    static const uint16_t odd[4][3] = {{0, 1, 2}, {4, 3, 5}, {1, 0, 5}, {0, 1, 6}};
    static const uint16_t want[4][3] = {{1, 4, 4}, {0, 4, 4}, {4, 4, 4}, {4, 4, 4}};
    uint16_t got[4][3];
    qtri_mesh mesh = {
        .positions = corners, .triangles = odd, .vertex_count = 6, .triangle_count = 4};
    assert_true(mesh_neighbours_make(&mesh, got));
    assert_memory_equal(got, want, sizeof want);
}

/* ---- A picture ---- */

struct scene {
    const qtri_format *format;
    qtri_mesh mesh;
    qtri_material material;
    qtri_view view;
    qtri_transform pose[2];
    bool creases, has_depth;
    uint16_t far;
};

static struct scene random_scene(uint64_t *seed)
{
    static const qtri_compare compares[4] = {QTRI_LESS, QTRI_LESS_EQUAL, QTRI_GREATER,
                                             QTRI_DEPTH_OFF};
    struct scene s = {.format = formats[random_in(seed, 0, 4)], .far = UINT16_MAX};
    const bool open = random_flag(seed);
    s.mesh.positions = positions;
    s.mesh.normals = normals;
    s.mesh.triangles = (const uint16_t(*)[3])triangles;
    s.mesh.triangles8 = random_flag(seed) ? (const uint8_t(*)[3])triangles8 : NULL;
    s.mesh.vertex_count = VERTICES;
    s.mesh.triangle_count = open ? TRIANGLES - 40 : TRIANGLES;
    if (random_in(seed, 0, 3) > 0) {
        s.mesh.neighbours = (const uint16_t(*)[3])(open ? neighbours_open : neighbours);
    }
    if (random_flag(seed)) {
        s.mesh.faces = faces;
        s.mesh.origin = origin;
        s.mesh.extent = extent;
    }
    s.material = qtri_material_default();
    s.material.cull = (qtri_cull)random_in(seed, 0, 2);
    s.material.shading = random_flag(seed) ? QTRI_SMOOTH : QTRI_FLAT_LAST;
    s.material.depth_compare = compares[random_in(seed, 0, 3)];
    s.creases = random_flag(seed);
    s.has_depth = random_in(seed, 0, 4) > 0;
    const qtri_vec3 eye = {0, 0, random_in(seed, Q16(.8), Q16(5))}, center = {0, 0, 0},
                    up = {0, Q16_ONE, 0};
    qtri_view_init(&s.view, WIDTH, HEIGHT);
    qtri_transform_look_at(&s.view.camera, eye, center, up);
    qtri_transform_perspective(&s.view.projection, Q16(60), Q16(1.3), Q16(.1), Q16(50));
    if (s.material.depth_compare == QTRI_GREATER) {
        s.view.viewport.depth_near = Q16_ONE;
        s.view.viewport.depth_far = 0;
        s.far = 0;
    }
    s.view.light = &sun;
    for (int i = 0; i < 2; i++) {
        qtri_transform_identity(&s.pose[i]);
        qtri_transform_rotate_x(&s.pose[i], random_in(seed, 0, Q16(360)));
        qtri_transform_rotate_y(&s.pose[i], random_in(seed, 0, Q16(360)));
    }
    return s;
}

struct picture {
    uint32_t pixel[HEIGHT][WIDTH];
};

static void keep(struct picture *out, const qtri_surface *s, int32_t x0, int32_t y0, int32_t x1,
                 int32_t y1)
{
    for (int32_t y = y0; y < y1; y++) {
        for (int32_t x = x0; x < x1; x++) {
            qtri_rgb c = qtri_surface_pixel(s, x, y);
            out->pixel[y][x] = (uint32_t)c.r << 16 | (uint32_t)c.g << 8 | c.b;
        }
    }
}

static uint32_t memory[3 * QTRI_BAND_BYTES(WIDTH, HEIGHT + 20, 4) / 4];
static qtri_vertex vertices[2][VERTICES];
static uint32_t outline_memory[2][WORDS], edge_memory[WORDS];
static uint16_t lists[2][LISTS];
static qtri_outline outline[2];

static void begin_outlines(const struct scene *s, uint32_t words)
{
    for (int i = 0; i < 2; i++) {
        assert_ok(qtri_outline_init(&outline[i], &s->mesh, outline_memory[i], words));
        outline[i].creases = s->creases;
    }
}

/* The scene on a surface; `find`: drawn first, outlines found later. */
static void draw_on(struct scene *s, qtri_surface *surface, bool find)
{
    qtri_edges edges;
    clear_to(surface, sky, s->far);
    for (int i = 0; i < 2; i++) {
        give_vertices(&s->view, vertices[i], VERTICES);
        s->material.color.g = (uint8_t)(i * 200);
        if (find) {
            qtri_draw_mesh(surface, &s->view, &s->pose[i], &s->mesh, &s->material);
        } else {
            assert_ok(
                qtri_draw_mesh_outlined(surface, &s->view, &s->pose[i], &s->material, &outline[i]));
        }
    }
    assert_ok(qtri_edges_begin(&edges, surface, edge_memory, WORDS));
    for (int i = 0; i < 2; i++) {
        if (find) {
            s->view.vertices = vertices[0]; /* shared */
            assert_ok(qtri_find_outline(surface, &s->view, &s->pose[i], &s->material, &outline[i]));
        }
        qtri_edges_note(&edges, &outline[i]);
    }
    qtri_edges_blend(&edges);
}

static void init_surface(const struct scene *s, qtri_surface *surface, int32_t first, int32_t rows)
{
    assert_ok(
        qtri_surface_init(surface, s->format, WIDTH, HEIGHT, first, rows, memory, sizeof memory));
    if (!s->has_depth) {
        surface->depth = NULL;
    }
}

static void draw_whole(struct scene *s, struct picture *out)
{
    qtri_surface surface;
    init_surface(s, &surface, 0, HEIGHT);
    begin_outlines(s, WORDS);
    draw_on(s, &surface, false);
    keep(out, &surface, 0, 0, WIDTH, HEIGHT);
}

#define assert_same(a, b) assert_memory_equal(&(a), &(b), sizeof(struct picture))

/* ---- The same pixels ---- */

/* The frame's bands: with rows that are drawn again, or with such that are kept. */
struct bands {
    bool keeps;
    qtri_frame frame;
};

static void begin_bands(struct bands *b, const struct scene *s, int32_t rows, int32_t overlap,
                        size_t bytes)
{
    static uint32_t kept[QTRI_FRAME_KEPT_BYTES(WIDTH, 3, 4) / sizeof(uint32_t)];
    assert_ok(qtri_frame_init(&b->frame, s->format, WIDTH, HEIGHT, rows, memory, bytes));
    assert_ok(qtri_frame_set_overlap(&b->frame, overlap, b->keeps ? kept : NULL, sizeof kept));
}

static void prepare(struct bands *b, const struct scene *s, qtri_prepared *prepared,
                    qtri_outline *of, const qtri_transform *pose, const qtri_material *material)
{
    qtri_prepared_set_outline(prepared, of);
    qtri_prepare_mesh(prepared, &b->frame, &s->view, pose, &s->mesh, material);
    assert_ok(qtri_prepared_find_edges(prepared, of));
}

TEST(bands_and_lists)
{
    uint64_t seed = 1;
    for (int round = 0; round < 600; round++) {
        struct scene s = random_scene(&seed);
        static struct picture whole, banded;
        draw_whole(&s, &whole);
        struct bands b = {.keeps = round % 3 == 2};
        const int32_t overlap = random_in(&seed, 1, 3);
        const int32_t rows = random_in(&seed, b.keeps ? 2 * overlap : 1, HEIGHT + 3);
        const uint32_t least = QTRI_OUTLINE_WORDS(TRIANGLES) + QTRI_OUTLINE_SUMS(VERTICES);
        begin_outlines(&s, least + (uint32_t)random_in(&seed, 0, 1) *
                                       (uint32_t)random_in(&seed, 0, 300));
        qtri_prepared prepared[2];
        begin_bands(&b, &s, rows, overlap, sizeof memory / (random_flag(&seed) ? 1 : 3));
        qtri_material material[2] = {s.material, s.material};
        material[0].color.g = 0;
        material[1].color.g = 200;
        for (int i = 0; i < 2; i++) {
            prepared_init_with(&prepared[i], vertices[i], VERTICES, lists[i],
                               (uint32_t)random_in(&seed, 0, LISTS));
            prepare(&b, &s, &prepared[i], &outline[i], &s.pose[i], &material[i]);
        }
        qtri_surface band, shown;
        int32_t next = 0;
        while (qtri_frame_next_band(&b.frame, &band)) {
            qtri_edges edges;
            if (!s.has_depth) {
                band.depth = NULL;
            }
            clear_to(&band, sky, s.far);
            qtri_draw_prepared(&band, &prepared[0]);
            qtri_draw_prepared(&band, &prepared[1]);
            qtri_frame_join(&b.frame, &band);
            qtri_frame_shown(&b.frame, &band, &shown);
            assert_int_equal(shown.first_row, next);
            if (s.format == &qtri_rgb565 && random_flag(&seed)) {
                band.format = &any_565;
            }
            assert_ok(qtri_edges_begin(&edges, &band, edge_memory, WORDS));
            qtri_edges_note(&edges, &outline[0]);
            qtri_edges_note(&edges, &outline[1]);
            qtri_edges_blend(&edges);
            keep(&banded, &shown, 0, next, WIDTH, next + shown.rows);
            next += shown.rows;
        }
        assert_int_equal(next, HEIGHT);
        assert_same(whole, banded);
    }
}

TEST(scissors_and_pitches)
{
    uint64_t seed = 2;
    for (int round = 0; round < 400; round++) {
        struct scene s = random_scene(&seed);
        static struct picture whole, part;
        draw_whole(&s, &whole);
        qtri_surface surface;
        init_surface(&s, &surface, 0, HEIGHT);
        const int32_t gap = random_in(&seed, 0, 9);
        surface.pitch += (ptrdiff_t)gap * (s.format->pixels->bytes == 3 ? 3 : 4);
        if (random_flag(&seed)) { /* bottom up */
            surface.pixels += (HEIGHT - 1) * surface.pitch;
            surface.pitch = -surface.pitch;
        }
        if (surface.depth != NULL) {
            surface.depth = (uint16_t *)(void *)(memory + sizeof memory / 8);
            surface.depth_pitch = WIDTH + random_in(&seed, 0, 5);
            if (random_flag(&seed)) {
                surface.depth += (HEIGHT - 1) * surface.depth_pitch;
                surface.depth_pitch = -surface.depth_pitch;
            }
        }
        const qtri_rect r = {random_in(&seed, -3, WIDTH - 1), random_in(&seed, -3, HEIGHT - 1),
                             random_in(&seed, 1, WIDTH + 3), random_in(&seed, 1, HEIGHT + 3)};
        const qtri_rect halo = {r.x0 - 1, r.y0 - 1, r.x1 + 1, r.y1 + 1};
        surface.scissor = halo;
        const bool find = random_flag(&seed);
        part = whole;
        if (r.x0 < r.x1 && r.y0 < r.y1) {
            draw_on(&s, &surface, find);
            keep(&part, &surface, r.x0 > 0 ? r.x0 : 0, r.y0 > 0 ? r.y0 : 0,
                 r.x1 < WIDTH ? r.x1 : WIDTH, r.y1 < HEIGHT ? r.y1 : HEIGHT);
        }
        assert_same(whole, part);
    }
}

/* Until the blend, an outlined mesh is drawn as any other, and only pixels near edges change. */
TEST(drawing_is_the_same)
{
    uint64_t seed = 3;
    int changed = 0;
    for (int round = 0; round < 100; round++) {
        struct scene s = random_scene(&seed);
        static struct picture plain, outlined, smooth;
        qtri_surface surface;
        init_surface(&s, &surface, 0, HEIGHT);
        give_vertices(&s.view, vertices[0], VERTICES);
        clear_to(&surface, sky, s.far);
        qtri_draw_mesh(&surface, &s.view, &s.pose[0], &s.mesh, &s.material);
        keep(&plain, &surface, 0, 0, WIDTH, HEIGHT);
        begin_outlines(&s, WORDS);
        clear_to(&surface, sky, s.far);
        (void)qtri_draw_mesh_outlined(&surface, &s.view, &s.pose[0], &s.material, &outline[0]);
        keep(&outlined, &surface, 0, 0, WIDTH, HEIGHT);
        assert_same(plain, outlined);
        qtri_edges edges;
        (void)qtri_edges_begin(&edges, &surface, edge_memory, WORDS);
        qtri_edges_note(&edges, &outline[0]);
        qtri_edges_blend(&edges);
        keep(&smooth, &surface, 0, 0, WIDTH, HEIGHT);
        for (int32_t y = 0; y < HEIGHT; y++) {
            for (int32_t x = 0; x < WIDTH; x++) {
                changed += smooth.pixel[y][x] != plain.pixel[y][x];
            }
        }
    }
    assert_in_range(changed, 5000, 40000);
}

/* ---- Exact shares ---- */

/* A convex polygon of white on black, as a fan, in pixels of a surface. */
struct polygon {
    double x[4], y[4];
    int count;
};

static qtri_vec3 corner_at(double x, double y, double width, double height)
{
    qtri_vec3 p = {(q16)lrint((2 * x / width - 1) * 65536),
                   (q16)lrint((1 - 2 * y / height) * 65536), 0};
    return p;
}

static void draw_polygon(qtri_surface *surface, const struct polygon *polygon, qtri_vec3 *corners,
                         bool blended)
{
    static const uint16_t fan[2][3] = {{0, 1, 2}, {0, 2, 3}};
    static const uint16_t inner[2][3] = {{2, 2, 1}, {0, 2, 2}}, single[1][3] = {{1, 1, 1}};
    qtri_view view;
    qtri_transform pose;
    qtri_edges edges;
    qtri_material material = qtri_material_default();
    qtri_mesh mesh = {.positions = corners,
                      .triangles = fan,
                      .neighbours = polygon->count == 4 ? inner : single,
                      .vertex_count = (uint32_t)polygon->count,
                      .triangle_count = (uint32_t)polygon->count - 2};
    material.cull = QTRI_CULL_NONE;
    for (int i = 0; i < polygon->count; i++) {
        corners[i] = corner_at(polygon->x[i], polygon->y[i], surface->width, surface->height);
    }
    qtri_view_init(&view, surface->width, surface->height);
    give_vertices(&view, vertices[0], VERTICES);
    qtri_transform_identity(&pose);
    const qtri_rgb black = {0, 0, 0};
    qtri_surface_clear(surface, black);
    assert_ok(qtri_outline_init(&outline[0], &mesh, outline_memory[0], WORDS));
    (void)qtri_draw_mesh_outlined(surface, &view, &pose, &material, &outline[0]);
    if (blended) {
        assert_ok(qtri_edges_begin(&edges, surface, edge_memory, WORDS));
        qtri_edges_note(&edges, &outline[0]);
        qtri_edges_blend(&edges);
    }
}

/* The share of a pixel inside of a polygon given clockwise or not: clipped against the pixel. */
static double coverage_of(const struct polygon *polygon, int px, int py)
{
    double x[16], y[16], cx[16], cy[16];
    int count = polygon->count;
    for (int i = 0; i < count; i++) {
        x[i] = polygon->x[i] - px;
        y[i] = polygon->y[i] - py;
    }
    for (int side = 0; side < 4; side++) {
        int kept = 0;
        for (int i = 0; i < count; i++) {
            const int j = (i + 1) % count;
            const double a[2] = {x[i], y[i]}, b[2] = {x[j], y[j]};
            const int axis = side >> 1;
            const double limit = side & 1, sign = (side & 1) != 0 ? -1 : 1;
            const double da = sign * (a[axis] - limit), db = sign * (b[axis] - limit);
            if (da >= 0) {
                cx[kept] = a[0];
                cy[kept++] = a[1];
            }
            if ((da >= 0) != (db >= 0)) {
                const double t = da / (da - db);
                cx[kept] = a[0] + t * (b[0] - a[0]);
                cy[kept++] = a[1] + t * (b[1] - a[1]);
            }
        }
        count = kept;
        memcpy(x, cx, sizeof x);
        memcpy(y, cy, sizeof y);
    }
    double area = 0;
    for (int i = 0; i < count; i++) {
        const int j = (i + 1) % count;
        area += x[i] * y[j] - x[j] * y[i];
    }
    return fabs(area) / 2;
}

/*
 * Far from corners, the box's coverage. An edge that passes a pixel's centre by less than the walk
 * knows, 2^-10 of a pixel, may find the neighbour on the wrong side: then nothing changes.
 */
TEST(shares_are_the_coverage)
{
    uint64_t seed = 4;
    double worst = 0;
    int pixels = 0, wrong_side = 0;
    for (int round = 0; round < 3000; round++) {
        qtri_vec3 corners[4];
        struct polygon p = {.count = 3};
        qtri_surface surface;
        assert_ok(qtri_surface_init(&surface, &qtri_gray8, 64, 64, 0, 64, memory, sizeof memory));
        for (int i = 0; i < 3; i++) { /* on the grid of 1/256, large, of any slope */
            p.x[i] = random_in(&seed, -40 * 256, 104 * 256) / 256.0;
            p.y[i] = random_in(&seed, -40 * 256, 104 * 256) / 256.0;
        }
        if (round % 5 == 0) {
            p.x[1] = p.x[0]; /* vertical */
        } else if (round % 5 == 1) {
            p.y[1] = p.y[0];
        } else if (round % 5 == 2) {
            p.x[1] = p.x[0] + 30;
            p.y[1] = p.y[0] - 30;
        }
        draw_polygon(&surface, &p, corners, true);
        for (int y = 1; y < 63; y++) {
            for (int x = 1; x < 63; x++) {
                int crossed = 0;
                bool corner = false;
                for (int i = 0; i < 3; i++) { /* edges that come near this pixel */
                    const int j = (i + 1) % 3;
                    const double dx = p.x[j] - p.x[i], dy = p.y[j] - p.y[i];
                    const double length = sqrt(dx * dx + dy * dy) + 1e-9;
                    const double side = ((x + .5 - p.x[i]) * dy - (y + .5 - p.y[i]) * dx) / length;
                    crossed += fabs(side) < 2;
                    corner |= fabs(p.x[i] - x) < 3 && fabs(p.y[i] - y) < 3;
                }
                if (crossed <= 1 && !corner) {
                    const double want = coverage_of(&p, x, y);
                    const double error = fabs(qtri_surface_pixel(&surface, x, y).g / 255.0 - want);
                    pixels += want > 0 && want < 1;
                    if (error > .4 && fabs(want - .5) < .001) {
                        wrong_side++;
                    } else {
                        worst = error > worst ? error : worst;
                    }
                }
            }
        }
    }
    assert_true(worst < .035); /* 1/64 in f, 1/64 in what is stored, and 1/510 */
    assert_true(pixels > 100000 && wrong_side < pixels / 10000);
}

/* Edge a b is edge b a: triangles of either winding have the same outline. */
TEST(winding_does_not_matter)
{
    uint64_t seed = 5;
    for (int round = 0; round < 300; round++) {
        static struct picture one, other;
        qtri_vec3 corners[4];
        struct polygon p = {.count = 3};
        qtri_surface surface;
        (void)qtri_surface_init(&surface, &qtri_rgb565, WIDTH, HEIGHT, 0, HEIGHT, memory,
                                sizeof memory);
        for (int i = 0; i < 3; i++) {
            p.x[i] = random_in(&seed, -5 * 256, (WIDTH + 5) * 256) / 256.0;
            p.y[i] = random_in(&seed, -5 * 256, (HEIGHT + 5) * 256) / 256.0;
        }
        draw_polygon(&surface, &p, corners, true);
        keep(&one, &surface, 0, 0, WIDTH, HEIGHT);
        const struct polygon back = {{p.x[2], p.x[1], p.x[0]}, {p.y[2], p.y[1], p.y[0]}, 3};
        draw_polygon(&surface, &back, corners, true);
        keep(&other, &surface, 0, 0, WIDTH, HEIGHT);
        assert_same(one, other);
    }
}

/* Two triangles of one colour over black: no seam inside, nothing darker than their coverage. */
TEST(shared_edges_leave_no_seam)
{
    uint64_t seed = 6;
    for (int round = 0; round < 300; round++) {
        qtri_vec3 corners[4];
        const double x = random_in(&seed, 5 * 256, 20 * 256) / 256.0,
                     y = random_in(&seed, 5 * 256, 12 * 256) / 256.0;
        const double dx = random_in(&seed, 10 * 256, 35 * 256) / 256.0,
                     dy = random_in(&seed, 10 * 256, 28 * 256) / 256.0;
        const struct polygon p = {{x, x, x + dx, x + dx}, {y, y + dy, y + dy, y}, 4};
        qtri_surface surface;
        (void)qtri_surface_init(&surface, &qtri_gray8, WIDTH, HEIGHT, 0, HEIGHT, memory,
                                sizeof memory);
        draw_polygon(&surface, &p, corners, true);
        for (int py = (int)y + 1; py < (int)(y + dy); py++) {
            for (int px = (int)x + 1; px < (int)(x + dx); px++) {
                assert_int_equal(qtri_surface_pixel(&surface, px, py).g, 255);
            }
        }
    }
}

/* 8192 pixels wide: shares are as exact at the far end. */
TEST(long_edges)
{
    static uint32_t wide[QTRI_BAND_BYTES(8192, 6, 1) / 4 + 1];
    static uint32_t marks[QTRI_EDGES_WORDS(8192, 6, 1)];
    static const uint16_t triangle[1][3] = {{0, 1, 2}}, none[1][3] = {{1, 1, 1}};
    uint64_t seed = 7;
    for (int round = 0; round < 40; round++) {
        qtri_surface surface;
        (void)qtri_surface_init(&surface, &qtri_gray8, 8192, 8192, 4093, 6, wide, sizeof wide);
        const double left = -random_in(&seed, 0, 4000), right = 8192 + random_in(&seed, 0, 4000);
        struct polygon p = {{left, right, 4000},
                            {4093.5 + random_in(&seed, 0, 4 * 256) / 256.0,
                             4093.5 + random_in(&seed, 0, 4 * 256) / 256.0, 12000},
                            3};
        qtri_vec3 corners[3];
        for (int i = 0; i < 3; i++) {
            corners[i] = corner_at(p.x[i], p.y[i], 8192, 8192);
            p.x[i] = (corners[i].x / 65536.0 + 1) * 4096; /* 1/16 of a pixel a step */
            p.y[i] = (1 - corners[i].y / 65536.0) * 4096;
        }
        const qtri_mesh mesh = {.positions = corners,
                                .triangles = triangle,
                                .neighbours = none,
                                .vertex_count = 3,
                                .triangle_count = 1};
        qtri_view view;
        qtri_transform pose;
        qtri_edges edges;
        qtri_material material = qtri_material_default();
        const qtri_rgb black = {0, 0, 0};
        material.cull = QTRI_CULL_NONE;
        qtri_view_init(&view, 8192, 8192);
        give_vertices(&view, vertices[0], 3);
        qtri_transform_identity(&pose);
        qtri_surface_clear(&surface, black);
        assert_ok(qtri_outline_init(&outline[0], &mesh, outline_memory[0], WORDS));
        (void)qtri_draw_mesh_outlined(&surface, &view, &pose, &material, &outline[0]);
        (void)qtri_edges_begin(&edges, &surface, marks, QTRI_EDGES_WORDS(8192, 6, 1));
        qtri_edges_note(&edges, &outline[0]);
        qtri_edges_blend(&edges);
        for (int x = 0; x < 8192; x += 7) {
            for (int y = 4094; y < 4098; y++) {
                const double slope = (p.y[1] - p.y[0]) / (p.x[1] - p.x[0]);
                const double at = p.y[0] + (x + .5 - p.x[0]) * slope - y;
                const double want = at < 0 ? 1 : at > 1 ? 0 : 1 - at;
                const double got = qtri_surface_pixel(&surface, x, y).g / 255.0;
                assert_true(fabs(got - want) < .035 || fabs(want - .5) < .004);
            }
        }
    }
}

/* ---- What is left alone ---- */

/* A mesh behind a near quad: none of the quad's pixels changes but on its own border. */
TEST(hidden_edges)
{
    uint64_t seed = 8;
    int beside = 0;
    for (int round = 0; round < 100; round++) {
        struct scene s = random_scene(&seed);
        static struct picture before, after;
        s.material.cull = QTRI_CULL_BACK;
        s.material.depth_compare = round % 2 == 0 ? QTRI_LESS : QTRI_GREATER;
        s.view.viewport.depth_near = round % 2 == 0 ? 0 : Q16_ONE;
        s.view.viewport.depth_far = round % 2 == 0 ? Q16_ONE : 0;
        s.far = round % 2 == 0 ? UINT16_MAX : 0;
        s.has_depth = true;
        const qtri_vec3 eye = {0, 0, Q16(4)}, center = {0, 0, 0}, up = {0, Q16_ONE, 0};
        qtri_transform_look_at(&s.view.camera, eye, center, up);
        qtri_surface surface;
        init_surface(&s, &surface, 0, HEIGHT);
        begin_outlines(&s, WORDS);
        give_vertices(&s.view, vertices[0], VERTICES);
        clear_to(&surface, sky, s.far);
        (void)qtri_draw_mesh_outlined(&surface, &s.view, &s.pose[0], &s.material, &outline[0]);
        qtri_transform still;
        qtri_transform_identity(&still);
        const q16 z = Q16(1.7);
        const qtri_rgb blue = {0, 0, 255};
        const qtri_corner quad[6] = {{{Q16(-.5), Q16(-.5), z, Q16_ONE}, blue, {0, 0}},
                                     {{Q16(.5), Q16(-.5), z, Q16_ONE}, blue, {0, 0}},
                                     {{Q16(.5), Q16(.5), z, Q16_ONE}, blue, {0, 0}},
                                     {{Q16(-.5), Q16(-.5), z, Q16_ONE}, blue, {0, 0}},
                                     {{Q16(.5), Q16(.5), z, Q16_ONE}, blue, {0, 0}},
                                     {{Q16(-.5), Q16(.5), z, Q16_ONE}, blue, {0, 0}}};
        qtri_draw_triangles(&surface, &s.view, &still, quad, 6, &s.material);
        keep(&before, &surface, 0, 0, WIDTH, HEIGHT);
        const uint32_t paint = before.pixel[HEIGHT / 2][WIDTH / 2];
        qtri_edges edges;
        (void)qtri_edges_begin(&edges, &surface, edge_memory, WORDS);
        qtri_edges_note(&edges, &outline[0]);
        qtri_edges_blend(&edges);
        keep(&after, &surface, 0, 0, WIDTH, HEIGHT);
        for (int y = 1; y < HEIGHT - 1; y++) {
            for (int x = 1; x < WIDTH - 1; x++) {
                if (before.pixel[y][x] == paint && before.pixel[y - 1][x] == paint &&
                    before.pixel[y + 1][x] == paint && before.pixel[y][x - 1] == paint &&
                    before.pixel[y][x + 1] == paint) {
                    assert_int_equal(after.pixel[y][x], paint);
                }
                beside += after.pixel[y][x] != before.pixel[y][x];
            }
        }
    }
    assert_true(beside > 2000);
}

/* Memory and arguments that do not serve. */
TEST(errors)
{
    uint64_t seed = 9;
    struct scene s = random_scene(&seed);
    qtri_surface surface;
    qtri_edges edges;
    s.format = &qtri_xrgb8888;
    s.has_depth = true;
    s.mesh.neighbours = (const uint16_t(*)[3])neighbours;
    s.mesh.triangle_count = TRIANGLES;
    const uint32_t least = QTRI_OUTLINE_WORDS(TRIANGLES);
    assert_int_equal(qtri_outline_init(&outline[0], &s.mesh, outline_memory[0], least - 1),
                     QTRI_ERROR_MEMORY);
    init_surface(&s, &surface, 0, HEIGHT);
    give_vertices(&s.view, vertices[0], VERTICES);
    assert_int_equal(
        qtri_draw_mesh_outlined(&surface, &s.view, &s.pose[0], &s.material, &outline[0]),
        QTRI_ERROR_MEMORY);
    assert_ok(qtri_outline_init(&outline[0], &s.mesh, outline_memory[0], least));
    s.view.vertex_count = VERTICES - 1;
    assert_int_equal(
        qtri_draw_mesh_outlined(&surface, &s.view, &s.pose[0], &s.material, &outline[0]),
        QTRI_ERROR_MEMORY);
    static uint16_t wrong[TRIANGLES][3];
    memcpy(wrong, neighbours, sizeof wrong);
    wrong[7][1] = TRIANGLES + 1;
    s.mesh.neighbours = (const uint16_t(*)[3])wrong;
    assert_int_equal(qtri_outline_init(&outline[0], &s.mesh, outline_memory[0], WORDS),
                     QTRI_ERROR_SIZE);
    const uint32_t words = QTRI_EDGES_WORDS(WIDTH, HEIGHT, 4);
    assert_ok(qtri_edges_begin(&edges, &surface, edge_memory, words));
    assert_int_equal(qtri_edges_begin(&edges, &surface, edge_memory, words - 1), QTRI_ERROR_MEMORY);
    qtri_edges_note(&edges, &outline[0]);
    qtri_edges_blend(&edges);
    surface.depth_pitch = WIDTH - 1;
    assert_int_equal(qtri_edges_begin(&edges, &surface, edge_memory, words), QTRI_ERROR_SIZE);
    surface.depth_pitch = -65537;
    assert_int_equal(qtri_edges_begin(&edges, &surface, edge_memory, words), QTRI_ERROR_SIZE);
    qtri_edges_note(&edges, &outline[0]);
    qtri_edges_blend(&edges);
    surface.depth = NULL;
    const uint32_t more = QTRI_EDGES_WORDS_WITHOUT_DEPTH(WIDTH, HEIGHT, 4);
    assert_ok(qtri_edges_begin(&edges, &surface, edge_memory, more));
    assert_int_equal(qtri_edges_begin(&edges, &surface, edge_memory, more - 1), QTRI_ERROR_MEMORY);
    surface.rows = 0;
    assert_ok(qtri_edges_begin(&edges, &surface, NULL, 0));
}

/* Bands whose overlap is drawn again: where they lie, and what is changed. */
TEST(overlap_is_drawn_again)
{
    uint64_t seed = 10;
    qtri_frame frame;
    qtri_surface band, shown;
    assert_int_equal(frame_with_overlap(&frame, &qtri_gray8, 10, 10, 4, 9, memory, sizeof memory),
                     QTRI_ERROR_SIZE);
    assert_false(next_shown(&frame, &band, &shown));
    assert_int_equal(frame_with_overlap(&frame, &qtri_gray8, 10, 10, 4, 1, memory,
                                        QTRI_FRAME_BYTES(10, 4 + 2 * 1, 1) - 1),
                     QTRI_ERROR_MEMORY);
    for (int round = 0; round < 500; round++) {
        const int32_t rows = random_in(&seed, 1, 60), above = random_in(&seed, 0, 8);
        const bool two = random_flag(&seed);
        assert_ok(frame_with_overlap(&frame, &qtri_rgb565, WIDTH, HEIGHT, rows, above, memory,
                                     two ? QTRI_FRAME_BYTES_DOUBLE(WIDTH, rows + 2 * above, 2)
                                         : QTRI_FRAME_BYTES(WIDTH, rows + 2 * above, 2)));
        for (int turn = 0; turn < 2; turn++) {
            const qtri_rect changed = {20, 15, 30, 22};
            int32_t next = 0;
            if (turn == 1) {
                qtri_frame_mark(&frame, &changed);
                qtri_frame_only_changes(&frame);
            }
            const uint8_t *last = NULL;
            while (next_shown(&frame, &band, &shown)) {
                assert_true(shown.first_row >= next && shown.first_row % rows == 0);
                assert_int_equal(band.first_row,
                                 shown.first_row > above ? shown.first_row - above : 0);
                next = shown.first_row + shown.rows;
                assert_int_equal(band.first_row + band.rows,
                                 next + above < HEIGHT ? next + above : HEIGHT);
                assert_ptr_equal(shown.pixels,
                                 band.pixels + (shown.first_row - band.first_row) * band.pitch);
                const uint8_t *end = (const uint8_t *)memory + sizeof memory;
                assert_true((const uint8_t *)(band.depth + band.rows * band.depth_pitch) <= end);
                assert_true(last == NULL || (last != band.pixels) == two);
                last = band.pixels;
                if (turn == 1) {
                    assert_int_equal(shown.scissor.x0, 20 - above);
                    assert_int_equal(band.scissor.x0, 20 - 2 * above);
                    assert_int_equal(shown.scissor.y1, 22 + above);
                    assert_int_equal(band.scissor.y1, 22 + 2 * above);
                    clear_to(&band, sky, 0);
                }
            }
            assert_true(next >= (turn == 0 ? HEIGHT : 22));
        }
    }
}

/* Bands whose overlap is kept: which rows are drawn, kept and shown, in one buffer and in two. */
TEST(overlap_is_kept)
{
    uint64_t seed = 11;
    qtri_surface band, shown;
    uint8_t kept[QTRI_FRAME_KEPT_BYTES(WIDTH, 8, 2) + 1];
    static const struct {
        int32_t rows;
        size_t bytes, kept_bytes;
        enum qtri_error error;
    } tries[] = {
        {5, sizeof memory, sizeof kept, QTRI_ERROR_SIZE},
        {6, QTRI_FRAME_BYTES(WIDTH, 6 + 2 * 3, 2) - 1, sizeof kept, QTRI_ERROR_MEMORY},
        {6, sizeof memory, QTRI_FRAME_KEPT_BYTES(WIDTH, 3, 2) - 1, QTRI_ERROR_MEMORY},
        {6, QTRI_FRAME_BYTES(WIDTH, 6 + 2 * 3, 2), QTRI_FRAME_KEPT_BYTES(WIDTH, 3, 2), QTRI_OK}};
    for (size_t i = 0; i < LENGTH_OF(tries); i++) {
        qtri_frame frame;
        assert_ok(qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, tries[i].rows, memory,
                                  tries[i].bytes));
        assert_int_equal(qtri_frame_set_overlap(&frame, 3, kept, tries[i].kept_bytes),
                         tries[i].error);
        assert_true(qtri_frame_next_band(&frame, &band) == (tries[i].error == QTRI_OK));
    }
    for (int round = 0; round < 300; round++) {
        qtri_frame frame;
        const int32_t overlap = random_in(&seed, 0, 8);
        const int32_t rows = random_in(&seed, overlap > 0 ? 2 * overlap : 1, 60);
        const bool two = random_flag(&seed);
        uint8_t *rest = kept + random_in(&seed, 0, 1); /* at words or not */
        assert_ok(qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, rows, memory,
                                  two ? QTRI_FRAME_BYTES_DOUBLE(WIDTH, rows + 2 * overlap, 2)
                                      : QTRI_FRAME_BYTES(WIDTH, rows + 2 * overlap, 2)));
        assert_ok(
            qtri_frame_set_overlap(&frame, overlap, rest, sizeof kept - (size_t)(rest - kept)));
        for (int turn = 0; turn < 2; turn++) {
            int32_t next_drawn = 0;
            int32_t next_shown_row = 0;
            while (qtri_frame_next_band(&frame, &band)) {
                assert_int_equal(band.first_row, next_drawn);
                const int32_t above = next_drawn == 0 ? 0 : 2 * overlap;
                for (int32_t y = 0; y < band.rows; y++) {
                    const uint16_t row = (uint16_t)(band.first_row + y);
                    for (int32_t x = 0; x < WIDTH; x++) {
                        ((uint16_t *)(void *)(band.pixels + y * band.pitch))[x] = row;
                        band.depth[y * band.depth_pitch + x] = (uint16_t)(row + 1000);
                    }
                }
                const int32_t drawn = band.rows;
                qtri_frame_join(&frame, &band);
                assert_int_equal(band.first_row, next_drawn - above);
                next_drawn += drawn;
                assert_int_equal(band.first_row + band.rows, next_drawn);
                for (int32_t y = 0; y < band.rows; y++) {
                    const uint16_t row = (uint16_t)(band.first_row + y);
                    const uint16_t *pixels = (uint16_t *)(void *)(band.pixels + y * band.pitch);
                    assert_int_equal(pixels[0], row);
                    assert_int_equal(pixels[WIDTH - 1], row);
                    if (y > 0 || above == 0) {
                        assert_int_equal(band.depth[y * band.depth_pitch], row + 1000);
                        assert_int_equal(band.depth[(y + 1) * band.depth_pitch - 1], row + 1000);
                    }
                }
                qtri_frame_shown(&frame, &band, &shown);
                assert_int_equal(shown.first_row, next_shown_row);
                assert_ptr_equal(shown.pixels,
                                 band.pixels + (shown.first_row - band.first_row) * band.pitch);
                next_shown_row += shown.rows;
                assert_int_equal(next_shown_row,
                                 next_drawn < HEIGHT ? next_drawn - overlap : HEIGHT);
                clear_to(&band, sky, 0); /* whatever a filter makes of it */
            }
            assert_int_equal(next_shown_row, HEIGHT);
        }
    }
}

/* What overlap adds to what has changed: in the middle, and at each border of the frame. */
TEST(overlap_widens_changes)
{
    enum { OVERLAP = 2, SIDE = 20, ROWS = 5 };
    static uint32_t bytes[QTRI_FRAME_BYTES(SIDE, ROWS + 2 * OVERLAP, 4) / 4 + 4];
    static const struct {
        qtri_rect changed, widened;
    } cases[] = {{{7, 8, 11, 12}, {5, 6, 13, 14}}, {{3, 3, 17, 17}, {1, 1, 19, 19}},
                 {{2, 2, 18, 18}, {0, 0, 20, 20}}, {{1, 0, 19, 20}, {0, 0, 20, 20}},
                 {{0, 9, 1, 10}, {0, 7, 3, 12}},   {{19, 9, 20, 10}, {17, 7, 20, 12}}};
    for (size_t i = 0; i < LENGTH_OF(cases); i++) {
        qtri_frame frame;
        assert_ok(frame_with_overlap(&frame, &qtri_xrgb8888, SIDE, SIDE, ROWS, OVERLAP, bytes,
                                     sizeof bytes));
        qtri_surface band, shown;
        while (next_shown(&frame, &band, &shown)) { /* the first: all of it has changed */
        }
        qtri_frame_mark(&frame, &cases[i].changed);
        qtri_frame_only_changes(&frame);
        assert_memory_equal(&frame.changes, &cases[i].widened, sizeof(qtri_rect));
    }
}

/* Rows that are no band's, in the halo below the last: all triangles are looked at. */
TEST(rows_below_the_last_band)
{
    uint64_t seed = 9;
    for (int round = 0; round < 40; round++) {
        struct scene s = random_scene(&seed);
        static struct picture plain, listed;
        struct bands b = {.keeps = false};
        qtri_prepared prepared;
        begin_outlines(&s, WORDS);
        begin_bands(&b, &s, HEIGHT / 2, 2, sizeof memory);
        prepared_init_with(&prepared, vertices[0], VERTICES, lists[0], LISTS);
        memset(lists[0], 0, sizeof lists[0]);
        prepare(&b, &s, &prepared, &outline[0], &s.pose[0], &s.material);
        for (int i = 0; i < 2; i++) {
            qtri_surface surface;
            init_surface(&s, &surface, 0, HEIGHT);
            clear_to(&surface, sky, s.far);
            surface.scissor.y0 = HEIGHT - 1 - round % 2;
            give_vertices(&s.view, vertices[1], VERTICES);
            if (i == 0) {
                qtri_draw_prepared(&surface, &prepared);
            } else {
                qtri_draw_mesh(&surface, &s.view, &s.pose[0], &s.mesh, &s.material);
            }
            keep(i == 0 ? &listed : &plain, &surface, 0, 0, WIDTH, HEIGHT);
        }
        assert_same(plain, listed);
    }
}

int main(void)
{
    return run_all_tests(make_torus, NULL);
}
