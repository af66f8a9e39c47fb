/* SPDX-License-Identifier: MIT */
/*
 * Random draws with options that scene files do not name, and functions of random arguments:
 * checksums, as tests/pictures.tsv records them (`make pictures`). Other tests say what is right;
 * these see that nothing else changed.
 */
#include "support/faces.h"
#include "support/recorded.h"

enum { WIDTH = 53, HEIGHT = 41, GROUPS = 8, CORNERS = 12, VERTICES = FACES_VERTICES };
enum { TRIANGLES = FACES_TRIANGLES };

static uint64_t seed;
static int32_t width, height; /* of a surface: mostly WIDTH and HEIGHT, or about as many pixels */

static void random_size(int32_t shapes)
{
    static const int32_t sizes[][2] = {{WIDTH, HEIGHT}, {300, 7}, {9, 240}};
    const int32_t kind =
        shapes > 1 && random_in(&seed, 0, 4) == 0 ? random_in(&seed, 1, shapes - 1) : 0;
    width = sizes[kind][0];
    height = sizes[kind][1];
}

static int32_t below(int32_t count)
{
    return random_in(&seed, 0, count - 1);
}

static bool one_in(int32_t count)
{
    return below(count) == 0;
}

static q16 between(double low, double high)
{
    return random_in(&seed, fixed(low), fixed(high));
}

/* Often one of those where something begins or ends. */
static uint8_t random_byte(void)
{
    static const uint8_t ends[] = {0, 1, 2, 127, 128, 129, 254, 255};
    return one_in(3) ? ends[below(LENGTH_OF(ends))] : (uint8_t)below(256);
}

static uint32_t random_word(void)
{
    static const uint32_t ends[] = {0,           1,           0x7FFFFFFFu, 0x80000000u,
                                    0x80000001u, 0xFFFEFFFFu, 0xFFFF0000u, 0xFFFEFF80u,
                                    0xFFFFFFFFu, 0x00010000u};
    return one_in(4) ? ends[below(LENGTH_OF(ends))] : (uint32_t)random_bits32(&seed);
}

static qtri_vec3 random_vec(double reach)
{
    qtri_vec3 v;
    v.x = between(-reach, reach);
    v.y = between(-reach, reach);
    v.z = between(-reach, reach);
    return v;
}

static qtri_rgb random_color(void)
{
    const uint32_t bits = (uint32_t)random_bits32(&seed);
    const qtri_rgb color = {(uint8_t)bits, (uint8_t)(bits >> 8), (uint8_t)(bits >> 16)};
    return color;
}

static qtri_light_color random_light_color(void)
{
    qtri_light_color color;
    color.r = between(0, 1.2);
    color.g = between(0, 1.2);
    color.b = between(0, 1.2);
    return color;
}

/* What drawing needs, of random options. ------------------------------------------------------ */

static struct world {
    canvas c;
    qtri_view view;
    qtri_vertex vertices[VERTICES];
    qtri_transform pose;
    qtri_material material;
    qtri_texture texture;
    const void *levels[5];
    uint32_t texels[32 * 32];
    qtri_fog fog;
    qtri_light light;
    qtri_lights lights;
    qtri_light_source sources[3];
    qtri_shininess table;
    qtri_reflection reflection;
    qtri_mesh mesh;
    qtri_vec3 positions[VERTICES];
    qtri_normal normals[VERTICES];
    qtri_vec2 uvs[VERTICES];
    qtri_rgb colors[VERTICES];
    uint8_t alphas[VERTICES];
    uint16_t triangles[TRIANGLES][3];
    qtri_position16 positions16[VERTICES];
    qtri_normal8 normals8[VERTICES];
    qtri_uv16 uvs16[VERTICES];
    qtri_corner corners[CORNERS];
    qtri_screen_vertex screen[CORNERS];
    qtri_stroke stroke;
} w;

static const qtri_rgb palette[256] = {{1, 2, 3}, {255, 255, 255}, {200, 10, 90}, {9, 99, 255}};

static void random_fog(void)
{
    qtri_fog_range range;
    range.near_z = between(.1, 1);
    range.far_z = between(5, 20);
    range.orthographic = one_in(3);
    const qtri_rgb color = random_color();
    const q16 a = between(0, 3);
    const q16 b = between(2, 9);
    memset(&w.fog, 0, sizeof w.fog);
    switch (below(3)) {
    case 0:
        qtri_fog_linear(&w.fog, color, range, a, b);
        break;
    case 1:
        qtri_fog_exp(&w.fog, color, range, a / 4);
        break;
    default:
        qtri_fog_exp2(&w.fog, color, range, a / 4);
        break;
    }
}

static void random_texture(void)
{
    static const qtri_texel_format *const formats[] = {
        &qtri_texel_rgb565,   &qtri_texel_xrgb8888, &qtri_texel_checker,
        &qtri_texel_palette8, &qtri_texel_gray8,    &qtri_texel_argb4444,
        &qtri_texel_argb1555, &qtri_texel_argb8888, &qtri_texel_alpha8};
    static const qtri_filter *const filters[] = {NULL, &qtri_bilinear, &qtri_mipmapped,
                                                 &qtri_mipmapped_bilinear};
    uint8_t *bytes = (uint8_t *)w.texels; /* each written by itself: the same in any byte order */
    memset(&w.texture, 0, sizeof w.texture);
    for (int32_t i = 0; i < 32 * 32; i++) {
        w.texels[i] = (uint32_t)random_bits32(&seed);
    }
    const int32_t kind = below(LENGTH_OF(formats));
    if (formats[kind] == &qtri_texel_palette8) {
        for (size_t i = 0; i < sizeof w.texels; i++) {
            bytes[i] = (uint8_t)below(4);
        }
    } else if (formats[kind] == &qtri_texel_gray8 || formats[kind] == &qtri_texel_alpha8) {
        for (size_t i = 0; i < sizeof w.texels; i++) {
            bytes[i] = (uint8_t)below(256);
        }
    } else if (formats[kind] == &qtri_texel_rgb565 || formats[kind] == &qtri_texel_argb4444 ||
               formats[kind] == &qtri_texel_argb1555) {
        for (size_t i = 0; i < sizeof w.texels; i += 2) {
            const uint16_t texel = (uint16_t)below(65536);
            memcpy(bytes + i, &texel, sizeof texel);
        }
    }
    w.texture.texels = w.texels;
    w.texture.format = formats[kind];
    w.texture.width_log2 = (uint8_t)below(6);
    w.texture.height_log2 = (uint8_t)below(6);
    w.texture.fields = (uint16_t)(1 + below(9));
    w.texture.color[0] = random_color();
    w.texture.color[1] = random_color();
    w.texture.wrap_u = (qtri_wrap)below(2);
    w.texture.wrap_v = (qtri_wrap)below(2);
    w.texture.filter = filters[below(4)];
    w.texture.palette = palette;
    w.texture.has_key = one_in(4);
    w.texture.key = w.texels[0];
    for (size_t i = 0; i < LENGTH_OF(w.levels); i++) {
        w.levels[i] = w.texels;
    }
    w.texture.levels = w.levels;
    w.texture.level_count = (uint8_t)below(6);
}

static void random_lights(void)
{
    static const qtri_light_kind *const kinds[] = {&qtri_directional_light, &qtri_point_light,
                                                   &qtri_spot_light};
    qtri_shininess_init(&w.table, between(1, 90));
    memset(w.sources, 0, sizeof w.sources);
    for (size_t i = 0; i < LENGTH_OF(w.sources); i++) {
        qtri_light_source *source = &w.sources[i];
        source->kind = kinds[below(3)];
        source->position = random_vec(5);
        source->color = random_light_color();
        source->constant = between(.2, 1);
        source->linear = between(0, .5);
        source->quadratic = between(0, .3);
        source->direction = random_vec(1);
        source->inner = between(0, 30);
        source->outer = source->inner + between(1, 40);
        source->falloff = one_in(2) ? &w.table : NULL;
    }
    const qtri_light_color ambient = random_light_color();
    (void)qtri_lights_init(&w.lights, w.sources, 1 + (uint32_t)below(3), ambient);
    w.reflection.ambient = random_color();
    w.reflection.specular = random_color();
    w.reflection.emission = random_color();
    w.reflection.shininess = one_in(3) ? NULL : &w.table;
    w.reflection.own_ambient = one_in(2);
    w.reflection.two_sided = one_in(2);
    w.light.towards = random_vec(2);
    w.light.ambient = between(0, 1);
    w.light.diffuse = between(0, 1);
}

static void random_material(void)
{
    static const qtri_blend *const blends[] = {&qtri_blend_alpha,        &qtri_blend_add,
                                               &qtri_blend_multiply,     &qtri_blend_none,
                                               &qtri_blend_replace,      &qtri_blend_screen_door,
                                               &qtri_blend_vertex_alpha, &qtri_blend_vertex_add};
    qtri_material *m = &w.material;
    memset(m, 0, sizeof *m);
    m->color = random_color();
    m->shading = one_in(6)   ? &qtri_per_pixel
                 : one_in(2) ? QTRI_SMOOTH
                             : (one_in(2) ? QTRI_FLAT_FIRST : QTRI_FLAT_LAST);
    m->interpolation = (qtri_interpolation)below(2);
    m->texture = one_in(2) ? NULL : &w.texture;
    m->texture_mode = (qtri_texture_mode)below(2);
    m->cull = (qtri_cull)below(3);
    m->fill = one_in(6) ? (one_in(2) ? &qtri_wireframe : &qtri_smooth_wireframe) : NULL;
    m->depth_compare = one_in(3) ? QTRI_LESS : (qtri_compare)below(10);
    m->depth_read_only = one_in(5);
    m->depth_bias = one_in(3) ? between(-.1, .1) : 0;
    m->blend = one_in(2) ? NULL : blends[below(LENGTH_OF(blends))];
    m->alpha = random_byte();
    m->keep = (uint8_t)(one_in(4) ? below(8) : 0);
    m->least_alpha = (uint8_t)(one_in(4) ? random_byte() : 0);
    m->fog = one_in(3) ? &w.fog : NULL;
    m->reflection = &w.reflection;
    m->alphas = one_in(2) ? w.alphas : NULL;
    m->depth_shift = one_in(5) ? &qtri_slope_bias : NULL;
    m->depth_slope = between(-2, 2);
    random_texture();
    random_fog();
    w.stroke.width = one_in(3) ? between(.5, 2.5) : between(0, 14);
    w.stroke.width = one_in(9) ? Q16(1. / 512) * below(6) : w.stroke.width;
    w.stroke.cap = (qtri_cap)below(3);
    w.stroke.edges = one_in(2) ? &qtri_stroke_smooth : NULL;
    w.stroke.alpha = one_in(2) ? 255 : random_byte();
    w.stroke.closed = one_in(3);
    w.stroke.in_space = one_in(3);
}

static void random_view(void)
{
    const q16 fovy = between(30, 90);
    const q16 near_z = between(.1, 1.5);
    const q16 turn = between(-180, 180);
    const q16 above = between(-60, 60);
    const q16 distance = between(1, 5);
    const qtri_vec3 center = random_vec(.5);
    qtri_view_init(&w.view, width, height);
    if (one_in(4)) {
        qtri_transform_ortho(&w.view.projection, -fovy / 20, fovy / 20, -fovy / 24, fovy / 24,
                             near_z, Q16(12));
    } else {
        qtri_transform_perspective(&w.view.projection, fovy, Q16(1.3), near_z, Q16(12));
    }
    qtri_transform_orbit(&w.view.camera, center, distance, turn, above);
    if (one_in(5)) {
        w.view.viewport.depth_near = between(0, 1);
        w.view.viewport.depth_far = between(0, 1);
        w.view.viewport.x = below(20) - 5;
        w.view.viewport.height = height - below(height / 2);
    }
    random_lights();
    w.view.light = one_in(3) ? NULL : &w.light;
    w.view.lights = one_in(2) ? &w.lights : NULL;
    w.view.vertices = w.vertices;
    w.view.vertex_count = one_in(3) ? (uint32_t)below(VERTICES) : VERTICES;
    qtri_transform_identity(&w.pose);
    if (one_in(2)) {
        const qtri_vec3 axis = random_vec(1);
        const qtri_vec3 scale = random_vec(1.5);
        qtri_transform_rotate(&w.pose, turn, axis);
        qtri_transform_scale(&w.pose, scale);
    }
}

/* One that has planes of its faces. */
static void random_faces(void)
{
    static faces_mesh made;
    faces_mesh_make(&made, &seed, one_in(2) ? 0 : .05);
    w.mesh = one_in(2) ? made.wide : made.compact;
    faces_view(&w.view, &seed, WIDTH, HEIGHT);
    faces_pose(&w.pose, &seed, &w.mesh);
    w.view.light = one_in(3) ? NULL : &w.light;
    w.view.lights = one_in(3) ? &w.lights : NULL;
    w.view.vertices = w.vertices;
    w.view.vertex_count = VERTICES;
    w.material.cull = one_in(3) ? w.material.cull : QTRI_CULL_BACK;
}

/* A shape, or a soup, in either form of coordinates. */
static void random_mesh(void)
{
    const qtri_shape_memory memory = {w.positions, w.normals, w.uvs,
                                      w.triangles, VERTICES,  TRIANGLES};
    const qtri_vec3 half = vec3_of(.9, .6, 1.1);
    enum qtri_error error = QTRI_OK;
    switch (below(5)) {
    case 0:
        error = qtri_shape_box(&w.mesh, &memory, half);
        break;
    case 1:
        error = qtri_shape_sphere(&w.mesh, &memory, Q16(1), 9, 6);
        break;
    case 2:
        error = qtri_shape_torus(&w.mesh, &memory, Q16(1), Q16(.4), 8, 7);
        break;
    case 3:
        error = qtri_shape_cone(&w.mesh, &memory, Q16(1), Q16(1.2), 9);
        break;
    default:
        error = qtri_shape_grid(&w.mesh, &memory, Q16(2), Q16(2), 6, 7);
        break;
    }
    assert_int_equal(error, QTRI_OK);
    for (uint32_t i = 0; i < w.mesh.vertex_count; i++) {
        w.colors[i] = random_color();
        w.alphas[i] = random_byte();
        w.positions16[i].x = (int16_t)(w.positions[i].x >> 3);
        w.positions16[i].y = (int16_t)(w.positions[i].y >> 3);
        w.positions16[i].z = (int16_t)(w.positions[i].z >> 3);
    }
    if (one_in(4)) {
        for (uint32_t i = 0; i < w.mesh.triangle_count; i += 5) {
            w.triangles[i][1] = (uint16_t)below((int32_t)w.mesh.vertex_count);
        }
    }
    for (uint32_t i = 0; i < w.mesh.vertex_count; i++) {
        w.normals8[i].x = (int8_t)(w.normals[i].x / 256);
        w.normals8[i].y = (int8_t)(w.normals[i].y / 256);
        w.normals8[i].z = (int8_t)(w.normals[i].z / 256);
        w.uvs16[i].x = (int16_t)(w.uvs[i].x / 8);
        w.uvs16[i].y = (int16_t)(w.uvs[i].y / 8);
    }
    w.mesh.normals8 = one_in(4) ? w.normals8 : NULL;
    w.mesh.uvs16 = one_in(4) ? w.uvs16 : NULL;
    w.mesh.colors = one_in(2) ? w.colors : NULL;
    w.mesh.normals = one_in(6) ? NULL : w.mesh.normals;
    w.mesh.uvs = one_in(6) ? NULL : w.mesh.uvs;
    if (one_in(3)) {
        w.mesh.positions16 = w.positions16;
        w.mesh.origin = random_vec(.3);
        w.mesh.extent = between(.5, 5);
    }
}

static void random_corners(void)
{
    for (int i = 0; i < CORNERS; i++) {
        qtri_corner *corner = &w.corners[i];
        const qtri_vec3 at = random_vec(one_in(4) ? 6 : 1.3);
        corner->position.x = at.x;
        corner->position.y = at.y;
        corner->position.z = at.z;
        corner->position.w = one_in(6) ? between(-.2, 2) : Q16(1);
        corner->color = random_color();
        corner->uv.x = between(-3, 3);
        corner->uv.y = between(-3, 3);
        w.alphas[i] = random_byte();
        w.normals[i].x = (int16_t)below(32768);
        w.normals[i].y = (int16_t)below(32768);
        w.normals[i].z = (int16_t)-below(32768);
    }
}

/* On an edge of the surface, or next to it. */
static int32_t at_edge(int32_t size)
{
    const int32_t edge = one_in(2) ? 0 : size * 256;
    return edge + below(5) - 2;
}

/* From 0 to what a number of `bits` bits holds. */
static uint32_t of_bits(int32_t bits)
{
    return (uint32_t)random_bits32(&seed) >> (32 - bits);
}

/*
 * Depths, distances and places in a texture of a triangle's vertices are mostly next to each other:
 * thresholds of slopes are passed by few that have nothing to do with each other.
 */
static void bring_together(void)
{
    const int32_t depth_bits = 8 + below(22);
    const int32_t inv_w_bits = 8 + below(22);
    const int32_t nearer = below(9);
    const int32_t exponent = below(5) - 2;
    for (int i = 1; i < CORNERS; i++) {
        qtri_screen_vertex *v = &w.screen[i];
        v->depth_16p16 = w.screen[0].depth_16p16 + of_bits(depth_bits);
        v->inv_w_q31 = 0x40000000u + of_bits(inv_w_bits);
        v->inv_w_exponent = exponent + (one_in(3) ? below(4) : 0);
        v->u_q32 = w.screen[0].u_q32 + v->u_q32 / (1 << nearer);
        v->v_q32 = w.screen[0].v_q32 + v->v_q32 / (1 << nearer);
    }
}

static void random_screen(void)
{
    static const int32_t reaches[] = {200, 900, 4000, 20000, 900000, 1 << 23};
    const int32_t reach = reaches[below(LENGTH_OF(reaches))];
    const int32_t x = below(width * 256);
    const int32_t y = below(height * 256);
    const bool on_grid = one_in(3); /* vertices and edges on centres of pixels */
    const bool at_edges = one_in(4);
    for (int i = 0; i < CORNERS; i++) {
        qtri_screen_vertex *v = &w.screen[i];
        v->x_24p8 = x + random_in(&seed, -reach, reach);
        v->y_24p8 = y + random_in(&seed, -reach, reach);
        if (on_grid) {
            v->x_24p8 = (v->x_24p8 & ~255) + 128;
            v->y_24p8 = (v->y_24p8 & ~255) + 128;
        } else if (at_edges && one_in(2)) {
            v->x_24p8 = one_in(2) ? at_edge(width) : v->x_24p8;
            v->y_24p8 = one_in(2) ? at_edge(height) : v->y_24p8;
        }
        v->depth_16p16 = random_word();
        v->inv_w_q31 = 0x40000000u + ((uint32_t)random_bits32(&seed) >> 1);
        v->inv_w_exponent = one_in(3) ? below(20) - 10 : 0;
        v->u_q32 = (int64_t)between(-3, 3) * 65536;
        v->v_q32 = (int64_t)between(-3, 3) * 65536;
        for (int k = 0; k < 3; k++) {
            v->color_8p16[k] = one_in(4) ? (below(3) - 1) * (255 << 17) : below(256 << 16);
        }
    }
    if (one_in(2)) {
        bring_together();
    }
}

/* Checksums of what was drawn ------------------------------------------------------------------ */

static uint32_t add_surface(uint32_t hash, const qtri_surface *s)
{
    for (int32_t y = s->first_row; y < s->first_row + s->rows; y++) {
        for (int32_t x = 0; x < s->width; x++) {
            hash = recorded_add(hash, stored_pixel(s, x, y), s->format->pixels->bytes);
        }
    }
    return hash;
}

static uint32_t add_depth(uint32_t hash, const qtri_surface *s)
{
    for (int32_t y = s->first_row; y < s->first_row + s->rows; y++) {
        for (int32_t x = 0; x < s->width; x++) {
            hash = recorded_add(hash, stored_depth(s, x, y), 2);
        }
    }
    return hash;
}

static const qtri_depth_format *const depth_formats[] = {
    &qtri_depth_linear16, &qtri_depth_float16, &qtri_depth_linear24, &qtri_depth_linear32};

/* Draws twice on a surface of any format and depth, of a colour and depth that are not the ends. */
static uint32_t on_surface(uint32_t hash, void (*draw)(const qtri_surface *surface))
{
    const int32_t kind = below(4);
    random_size(3);
    const bool farthest = !one_in(4);
    const q16 depth = farthest ? Q16(1) : between(0, 1);
    const qtri_depth_format *depths = depth_formats[one_in(2) ? 0 : kind];
    const qtri_format *format = one_in(2) ? &qtri_rgb565 : drawn_format(below(7));
    const size_t bytes = QTRI_BAND_BYTES_DEPTH(width, height, format->pixels->bytes, depths->bytes);
    void *memory = calloc(1, bytes);
    qtri_surface surface;
    assert_non_null(memory);
    assert_int_equal(
        qtri_surface_init_depth(&surface, format, depths, width, height, 0, height, memory, bytes),
        QTRI_OK);
    qtri_surface_clear(&surface, random_color());
    qtri_surface_clear_depth(&surface, depth);
    if (one_in(5)) {
        surface.scissor.x0 = below(width);
        surface.scissor.y0 = below(height);
    }
    for (int times = 0; times < 2; times++) {
        random_view();
        random_material();
        draw(&surface);
    }
    hash = add_surface(hash, &surface);
    hash = depths->bytes == 2 ? add_depth(hash, &surface) : hash;
    free(memory);
    return hash;
}

/* The same with four samples a pixel, resolved. */
static uint32_t on_samples(uint32_t hash, void (*draw)(const qtri_surface *surface))
{
    static const qtri_format *const four[] = {&qtri_rgb565_x4, &qtri_rgb565_swapped_x4,
                                              &qtri_xrgb8888_x4, &qtri_rgb888_x4, &qtri_gray8_x4};
    static const qtri_format *const plain[] = {&qtri_rgb565, &qtri_rgb565_swapped, &qtri_xrgb8888,
                                               &qtri_rgb888, &qtri_gray8};
    const int32_t kind = one_in(2) ? 0 : below(5);
    random_size(3);
    canvas c = canvas_new(four[kind], width, height);
    canvas out = canvas_new(plain[kind], width, height);
    qtri_samples_clear(&c.surface, random_color());
    if (one_in(4)) {
        qtri_samples_clear_depth(&c.surface, between(0, 1));
    }
    for (int times = 0; times < 2; times++) {
        random_view();
        random_material();
        draw(&c.surface);
    }
    assert_int_equal(qtri_samples_resolve(&c.surface, &out.surface), QTRI_OK);
    hash = add_surface(hash, &out.surface);
    hash = add_depth(hash, &c.surface);
    canvas_free(&out);
    canvas_free(&c);
    return hash;
}

static void record(const char *name, int32_t pictures, void (*draw)(const qtri_surface *surface),
                   uint32_t (*on)(uint32_t hash, void (*draw)(const qtri_surface *surface)))
{
    for (int group = 0; group < GROUPS; group++) {
        char line[RECORDED_NAME_MAX];
        uint32_t hash = RECORDED_BEGIN;
        seed = recorded_seed(group);
        for (int32_t n = 0; n < pictures; n++) {
            hash = on(hash, draw);
        }
        snprintf(line, sizeof line, "core %s %d", name, group);
        recorded_judge(line, hash);
    }
}

/* Draws ---------------------------------------------------------------------------------------- */

static void draw_mesh(const qtri_surface *surface)
{
    if (one_in(4)) {
        random_faces();
    } else {
        random_mesh();
    }
    switch (below(8)) {
    case 0:
        qtri_draw_hidden_lines(surface, &w.view, &w.pose, &w.mesh, one_in(2) ? &w.stroke : NULL,
                               &w.material, Q16(.002));
        break;
    case 1:
        qtri_draw_wide_wireframe(surface, &w.view, &w.pose, &w.mesh, &w.stroke, &w.material);
        break;
    default:
        qtri_draw_mesh(surface, &w.view, &w.pose, &w.mesh, &w.material);
        break;
    }
}

static void draw_corners(const qtri_surface *surface)
{
    random_corners();
    switch (below(6)) {
    case 0:
        qtri_draw_lines(surface, &w.view, &w.pose, w.corners, CORNERS, &w.material);
        break;
    case 1:
        qtri_draw_polyline(surface, &w.view, &w.pose, w.corners, CORNERS, &w.stroke, &w.material);
        break;
    case 2:
        qtri_draw_wide_lines(surface, &w.view, &w.pose, w.corners, CORNERS, &w.stroke, &w.material);
        break;
    case 3:
        qtri_draw_points(surface, &w.view, &w.pose, w.corners, CORNERS, &w.stroke, &w.material);
        break;
    case 4:
        qtri_draw_lit_triangles(surface, &w.view, &w.pose, w.corners, one_in(2) ? w.normals : NULL,
                                CORNERS, &w.material);
        break;
    default:
        qtri_draw_triangles(surface, &w.view, &w.pose, w.corners, CORNERS, &w.material);
        break;
    }
}

static void draw_screen(const qtri_surface *surface)
{
    for (int times = 0; times < 3; times++) {
        random_screen();
        switch (below(4)) {
        case 0:
            qtri_raster_line(surface, &w.material, w.screen);
            break;
        case 1:
            qtri_raster_polyline(surface, &w.material, &w.stroke, w.screen,
                                 1 + (uint32_t)below(CORNERS));
            break;
        case 2:
            qtri_raster_point(surface, &w.material, &w.stroke, w.screen);
            break;
        default:
            for (int i = 0; i < CORNERS; i += 3) {
                qtri_raster_triangle(surface, &w.material, w.screen + i);
            }
            break;
        }
    }
}

/* Passes over a whole frame, or over its bands ------------------------------------------------- */

static struct passes {
    uint32_t outline[QTRI_OUTLINE_WORDS(TRIANGLES) + QTRI_OUTLINE_SUMS(VERTICES) + 60];
    uint32_t words; /* of it, before one that nobody writes */
    uint32_t edges[QTRI_EDGES_WORDS_WITHOUT_DEPTH(WIDTH, HEIGHT, 4)];
    uint16_t lists[400];
    qtri_vertex vertices[VERTICES + VERTICES / 2];
    uint16_t neighbours[TRIANGLES][3];
    uint8_t memory[QTRI_HALO_BYTES(WIDTH, HEIGHT, 3, QTRI_XRGB8888_BYTES)];
    qtri_outline of;
    qtri_edges pass;
} p;

/* The triangle across each side, or none: as QTRI_MESH's tools make them. */
static void find_neighbours(void)
{
    for (uint32_t i = 0; i < w.mesh.triangle_count; i++) {
        for (int k = 0; k < 3; k++) {
            const uint16_t a = w.triangles[i][k];
            const uint16_t b = w.triangles[i][(k + 1) % 3];
            uint32_t across = w.mesh.triangle_count;
            for (uint32_t j = 0; j < w.mesh.triangle_count * 3; j++) {
                if (w.triangles[j / 3][j % 3] == b && w.triangles[j / 3][(j + 1) % 3] == a) {
                    across = j / 3;
                }
            }
            p.neighbours[i][k] = (uint16_t)across;
        }
    }
    w.mesh.neighbours = (const uint16_t(*)[3])p.neighbours;
}

static void random_pass(void)
{
    random_view();
    random_material();
    random_mesh();
    w.view.vertex_count = VERTICES;
    w.material.fill = one_in(9) ? &qtri_wireframe : NULL;
    if (one_in(2)) {
        find_neighbours();
    }
    p.words = QTRI_OUTLINE_WORDS(w.mesh.triangle_count) +
              (w.mesh.neighbours != NULL ? 0 : QTRI_OUTLINE_SUMS(w.mesh.vertex_count)) +
              (uint32_t)below(60);
    p.outline[p.words] = 0xA5A5A5A5u;
    assert_int_equal(qtri_outline_init(&p.of, &w.mesh, p.outline, p.words), QTRI_OK);
    p.of.creases = one_in(2);
}

static void blend_edges(const qtri_surface *surface)
{
    assert_int_equal(p.outline[p.words], 0xA5A5A5A5u);
    assert_int_equal(qtri_edges_begin(&p.pass, surface, p.edges, LENGTH_OF(p.edges)), QTRI_OK);
    qtri_edges_note(&p.pass, &p.of);
    if (one_in(2) || qtri_edges_blend_565(&p.pass) != QTRI_OK) {
        qtri_edges_blend(&p.pass);
    }
}

static void draw_outlined(const qtri_surface *surface)
{
    random_pass();
    (void)qtri_draw_mesh_outlined(surface, &w.view, &w.pose, &w.material, &p.of);
    blend_edges(surface);
}

static uint32_t in_bands(uint32_t hash, void (*draw)(const qtri_surface *surface))
{
    const qtri_format *format = one_in(2) ? &qtri_rgb565 : drawn_format(below(7));
    const int32_t rows = 4 + below(HEIGHT - 4);
    const qtri_rgb sky = random_color();
    const bool with_edges = one_in(2);
    random_size(1);
    qtri_halo halo;
    qtri_prepared prepared;
    qtri_surface band, shown;
    (void)draw;
    random_pass();
    assert_int_equal(
        qtri_halo_init(&halo, format, WIDTH, HEIGHT, rows, 1 + below(3), p.memory, sizeof p.memory),
        QTRI_OK);
    const uint32_t vertex_count = one_in(4) ? 0 : LENGTH_OF(p.vertices);
    const uint32_t list_count = one_in(3) ? (uint32_t)below(200) : LENGTH_OF(p.lists);
    qtri_prepared_init(&prepared, p.vertices, vertex_count, p.lists, list_count);
    qtri_prepared_set_outline(&prepared, with_edges ? &p.of : NULL, 1);
    qtri_halo_begin(&halo);
    qtri_prepare_mesh(&prepared, &halo.frame, &w.view, &w.pose, &w.mesh, &w.material);
    if (with_edges) {
        (void)qtri_prepared_find_edges(&prepared, &p.of);
    }
    qtri_prepared_mark(&prepared, &halo.frame);
    const qtri_rect changes = qtri_frame_changes(&halo.frame);
    const int32_t touched[] = {changes.x0, changes.y0, changes.x1, changes.y1};
    for (int i = 0; i < 4; i++) {
        hash = recorded_add(hash, (uint32_t)touched[i], 4);
    }
    while (qtri_halo_next_band(&halo, &band, &shown)) {
        qtri_surface_clear(&band, sky);
        qtri_draw_prepared(&band, &prepared);
        if (with_edges) {
            blend_edges(&band);
        }
        hash = add_surface(hash, &shown);
    }
    return hash;
}

static void passes(void **state)
{
    (void)state;
    record("outlines", 60, draw_outlined, on_surface);
    record("bands", 60, NULL, in_bands);
}

static void meshes(void **state)
{
    (void)state;
    record("meshes", 120, draw_mesh, on_surface);
    record("meshes of samples", 50, draw_mesh, on_samples);
}

static void corners(void **state)
{
    (void)state;
    record("corners", 120, draw_corners, on_surface);
    record("corners of samples", 50, draw_corners, on_samples);
}

static void on_screen(void **state)
{
    (void)state;
    record("screen", 120, draw_screen, on_surface);
    record("screen of samples", 50, draw_screen, on_samples);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(meshes),
        cmocka_unit_test(corners),
        cmocka_unit_test(on_screen),
        cmocka_unit_test(passes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
