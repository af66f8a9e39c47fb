/* SPDX-License-Identifier: MIT */
#include "random_states.h"

void random_size(random_states *w, int32_t shapes)
{
    static const int32_t sizes[][2] = {{STATES_WIDTH, STATES_HEIGHT}, {300, 7}, {9, 240}};
    const int32_t kind =
        shapes > 1 && random_in(&w->seed, 0, 4) == 0 ? random_in(&w->seed, 1, shapes - 1) : 0;
    w->width = sizes[kind][0];
    w->height = sizes[kind][1];
}

int32_t random_below(random_states *w, int32_t count)
{
    return random_in(&w->seed, 0, count - 1);
}

bool random_one_in(random_states *w, int32_t count)
{
    return random_below(w, count) == 0;
}

q16 random_between(random_states *w, q16 low, q16 high)
{
    return random_in(&w->seed, low, high);
}

/* Often one of those where something begins or ends. */
static uint8_t random_byte(random_states *w)
{
    static const uint8_t ends[] = {0, 1, 2, 127, 128, 129, 254, 255};
    return random_one_in(w, 3) ? ends[random_below(w, LENGTH_OF(ends))]
                               : (uint8_t)random_below(w, 256);
}

static uint32_t random_word(random_states *w)
{
    static const uint32_t ends[] = {0,           1,           0x7FFFFFFFu, 0x80000000u,
                                    0x80000001u, 0xFFFEFFFFu, 0xFFFF0000u, 0xFFFEFF80u,
                                    0xFFFFFFFFu, 0x00010000u};
    return random_one_in(w, 4) ? ends[random_below(w, LENGTH_OF(ends))]
                               : (uint32_t)random_bits32(&w->seed);
}

static qtri_vec3 random_vec(random_states *w, q16 reach)
{
    qtri_vec3 v;
    v.x = random_between(w, -reach, reach);
    v.y = random_between(w, -reach, reach);
    v.z = random_between(w, -reach, reach);
    return v;
}

qtri_rgb random_rgb(random_states *w)
{
    const uint32_t bits = (uint32_t)random_bits32(&w->seed);
    const qtri_rgb color = {(uint8_t)bits, (uint8_t)(bits >> 8), (uint8_t)(bits >> 16)};
    return color;
}

static qtri_light_color random_light_color(random_states *w)
{
    qtri_light_color color;
    color.r = random_between(w, 0, Q16(1.2));
    color.g = random_between(w, 0, Q16(1.2));
    color.b = random_between(w, 0, Q16(1.2));
    return color;
}

static const qtri_rgb palette[256] = {{1, 2, 3}, {255, 255, 255}, {200, 10, 90}, {9, 99, 255}};
static const uint16_t palette565[256] = {0x0001, 0xFFFF, 0xC84B, 0x0B1F};

static void random_fog(random_states *w)
{
    qtri_fog_range range;
    range.near_z = random_between(w, Q16(.1), Q16(1));
    range.far_z = random_between(w, Q16(5), Q16(20));
    range.orthographic = random_one_in(w, 3);
    const qtri_rgb color = random_rgb(w);
    const q16 a = random_between(w, 0, Q16(3));
    const q16 b = random_between(w, Q16(2), Q16(9));
    memset(&w->fog, 0, sizeof w->fog);
    switch (random_below(w, 3)) {
    case 0:
        qtri_fog_linear(&w->fog, color, range, a, b);
        break;
    case 1:
        qtri_fog_exp(&w->fog, color, range, a / 4);
        break;
    default:
        qtri_fog_exp2(&w->fog, color, range, a / 4);
        break;
    }
}

static uint32_t first_bytes(const uint8_t *bytes)
{
    return bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

/* Texels of 16 bits: the same in any byte order. Returns the first two. */
static uint32_t random_halves(random_states *w)
{
    uint8_t *bytes = (uint8_t *)w->texels;
    uint32_t key = 0;
    for (size_t i = 0; i < sizeof w->texels; i += 2) {
        const uint16_t texel = (uint16_t)random_below(w, 65536);
        memcpy(bytes + i, &texel, sizeof texel);
        key = i < 4 ? key >> 16 | (uint32_t)texel << 16 : key;
    }
    return key;
}

static void random_texture(random_states *w)
{
    static const qtri_texel_format *const formats[] = {
        &qtri_texel_rgb565,     &qtri_texel_xrgb8888, &qtri_texel_checker,  &qtri_texel_palette8,
        &qtri_texel_palette565, &qtri_texel_gray8,    &qtri_texel_argb4444, &qtri_texel_argb1555,
        &qtri_texel_argb8888,   &qtri_texel_alpha8};
    static const qtri_filter *const filters[] = {NULL, &qtri_bilinear, &qtri_mipmapped,
                                                 &qtri_mipmapped_bilinear};
    uint8_t *bytes = (uint8_t *)w->texels; /* each written by itself: the same in any byte order */
    uint32_t key;                          /* the first texels, from the lowest bits on */
    memset(&w->texture, 0, sizeof w->texture);
    for (int32_t i = 0; i < 32 * 32; i++) {
        w->texels[i] = (uint32_t)random_bits32(&w->seed);
    }
    key = w->texels[0];
    const int32_t kind = random_below(w, LENGTH_OF(formats));
    if (formats[kind] == &qtri_texel_palette8 || formats[kind] == &qtri_texel_palette565) {
        for (size_t i = 0; i < sizeof w->texels; i++) {
            bytes[i] = (uint8_t)random_below(w, 4);
        }
        key = first_bytes(bytes);
    } else if (formats[kind] == &qtri_texel_gray8 || formats[kind] == &qtri_texel_alpha8) {
        for (size_t i = 0; i < sizeof w->texels; i++) {
            bytes[i] = (uint8_t)random_below(w, 256);
        }
        key = first_bytes(bytes);
    } else if (formats[kind] == &qtri_texel_rgb565 || formats[kind] == &qtri_texel_argb4444 ||
               formats[kind] == &qtri_texel_argb1555) {
        key = random_halves(w);
    }
    w->texture.texels = w->texels;
    w->texture.format = formats[kind];
    w->texture.width_log2 = (uint8_t)random_below(w, 6);
    w->texture.height_log2 = (uint8_t)random_below(w, 6);
    w->texture.fields = (uint16_t)(1 + random_below(w, 9));
    w->texture.color[0] = random_rgb(w);
    w->texture.color[1] = random_rgb(w);
    w->texture.wrap_u = (qtri_wrap)random_below(w, 2);
    w->texture.wrap_v = (qtri_wrap)random_below(w, 2);
    w->texture.filter = filters[random_below(w, 4)];
    w->texture.palette =
        formats[kind] == &qtri_texel_palette565 ? (const void *)palette565 : palette;
    w->texture.has_key = random_one_in(w, 4);
    w->texture.key = key;
    for (size_t i = 0; i < LENGTH_OF(w->levels); i++) {
        w->levels[i] = w->texels;
    }
    w->texture.levels = w->levels;
    w->texture.level_count = (uint8_t)random_below(w, 6);
}

static void random_lights(random_states *w)
{
    static const qtri_light_kind *const kinds[] = {&qtri_directional_light, &qtri_point_light,
                                                   &qtri_spot_light};
    qtri_shininess_init(&w->table, random_between(w, Q16(1), Q16(90)));
    memset(w->sources, 0, sizeof w->sources);
    for (size_t i = 0; i < LENGTH_OF(w->sources); i++) {
        qtri_light_source *source = &w->sources[i];
        source->kind = kinds[random_below(w, 3)];
        source->position = random_vec(w, Q16(5));
        source->color = random_light_color(w);
        source->constant = random_between(w, Q16(.2), Q16(1));
        source->linear = random_between(w, 0, Q16(.5));
        source->quadratic = random_between(w, 0, Q16(.3));
        source->direction = random_vec(w, Q16(1));
        source->inner = random_between(w, 0, Q16(30));
        source->outer = source->inner + random_between(w, Q16(1), Q16(40));
        source->falloff = random_one_in(w, 2) ? &w->table : NULL;
    }
    const qtri_light_color ambient = random_light_color(w);
    (void)qtri_light_init(&w->lights, w->sources, 1 + (uint32_t)random_below(w, 3), ambient);
    w->reflection.ambient = random_rgb(w);
    w->reflection.specular = random_rgb(w);
    w->reflection.emission = random_rgb(w);
    w->reflection.shininess = random_one_in(w, 3) ? NULL : &w->table;
    w->reflection.own_ambient = random_one_in(w, 2);
    w->reflection.two_sided = random_one_in(w, 2);
    w->light.towards = random_vec(w, Q16(2));
    w->light.ambient = random_between(w, 0, Q16(1));
    w->light.diffuse = random_between(w, 0, Q16(1));
}

void random_material(random_states *w)
{
    static const qtri_blend *const blends[] = {&qtri_blend_alpha,        &qtri_blend_add,
                                               &qtri_blend_multiply,     &qtri_blend_none,
                                               &qtri_blend_replace,      &qtri_blend_screen_door,
                                               &qtri_blend_vertex_alpha, &qtri_blend_vertex_add};
    qtri_material *m = &w->material;
    memset(m, 0, sizeof *m);
    m->color = random_rgb(w);
    m->shading = random_one_in(w, 6)   ? &qtri_per_pixel
                 : random_one_in(w, 2) ? QTRI_SMOOTH
                                       : (random_one_in(w, 2) ? QTRI_FLAT_FIRST : QTRI_FLAT_LAST);
    m->interpolation = (qtri_interpolation)random_below(w, 2);
    m->texture = random_one_in(w, 2) ? NULL : &w->texture;
    m->texture_mode = (qtri_texture_mode)random_below(w, 2);
    m->cull = (qtri_cull)random_below(w, 3);
    m->fill = random_one_in(w, 6) ? (random_one_in(w, 2) ? &qtri_wireframe : &qtri_smooth_wireframe)
                                  : NULL;
    m->depth_compare = random_one_in(w, 3) ? QTRI_LESS : (qtri_compare)random_below(w, 10);
    m->depth_read_only = random_one_in(w, 5);
    m->depth_bias = random_one_in(w, 3) ? random_between(w, Q16(-.1), Q16(.1)) : 0;
    m->blend = random_one_in(w, 2) ? NULL : blends[random_below(w, LENGTH_OF(blends))];
    m->alpha = random_byte(w);
    m->keep = (uint8_t)(random_one_in(w, 4) ? random_below(w, 8) : 0);
    m->least_alpha = (uint8_t)(random_one_in(w, 4) ? random_byte(w) : 0);
    m->fog = random_one_in(w, 3) ? &w->fog : NULL;
    m->reflection = &w->reflection;
    m->alphas = random_one_in(w, 2) ? w->alphas : NULL;
    m->depth_shift = random_one_in(w, 5) ? &qtri_slope_bias : NULL;
    m->depth_slope = random_between(w, Q16(-2), Q16(2));
    random_texture(w);
    random_fog(w);
    w->stroke.width =
        random_one_in(w, 3) ? random_between(w, Q16(.5), Q16(2.5)) : random_between(w, 0, Q16(14));
    w->stroke.width = random_one_in(w, 9) ? Q16(1. / 512) * random_below(w, 6) : w->stroke.width;
    w->stroke.cap = (qtri_cap)random_below(w, 3);
    w->stroke.edges = random_one_in(w, 2) ? &qtri_stroke_smooth : NULL;
    w->stroke.alpha = random_one_in(w, 2) ? 255 : random_byte(w);
    w->stroke.closed = random_one_in(w, 3);
    w->stroke.in_space = random_one_in(w, 3);
}

void random_usual(random_states *w)
{
    qtri_material *m = &w->material;
    const qtri_rgb white = {255, 255, 255};
    const qtri_shading *const shadings[] = {QTRI_SMOOTH, QTRI_FLAT_FIRST};
    m->color = random_one_in(w, 2) ? white : m->color;
    m->shading = shadings[random_one_in(w, 4)];
    m->interpolation = QTRI_PERSPECTIVE;
    m->texture_mode = random_one_in(w, 4) ? QTRI_REPLACE : QTRI_MODULATE;
    m->cull = QTRI_CULL_BACK;
    m->fill = NULL;
    m->depth_compare = QTRI_LESS;
    m->depth_read_only = false;
    m->depth_bias = 0;
    m->depth_shift = NULL;
    m->blend = NULL;
    m->keep = 0;
    m->least_alpha = 0;
    m->fog = NULL;
    m->alphas = NULL;
    if (!random_one_in(w, 3)) {
        (void)random_halves(w);
        w->texture.format = &qtri_texel_rgb565;
    }
    w->texture.filter = NULL;
    w->texture.has_key = false;
    w->texture.wrap_u = w->texture.wrap_v = QTRI_REPEAT;
    w->view.light = random_one_in(w, 3) ? NULL : &w->light;
    w->view.vertex_count = STATES_VERTICES;
}

static void init_view(random_states *w)
{
    qtri_view_init(&w->view, w->width, w->height);
    w->view.pipelines = w->pipelines != NULL ? w->pipelines : w->view.pipelines;
}

void random_view(random_states *w)
{
    const q16 fovy = random_between(w, Q16(30), Q16(90));
    const q16 near_z = random_between(w, Q16(.1), Q16(1.5));
    const q16 turn = random_between(w, Q16(-180), Q16(180));
    const q16 above = random_between(w, Q16(-60), Q16(60));
    const q16 distance = random_between(w, Q16(1), Q16(5));
    const qtri_vec3 center = random_vec(w, Q16(.5));
    init_view(w);
    if (random_one_in(w, 4)) {
        qtri_transform_ortho(&w->view.projection, -fovy / 20, fovy / 20, -fovy / 24, fovy / 24,
                             near_z, Q16(12));
    } else {
        qtri_transform_perspective(&w->view.projection, fovy, Q16(1.3), near_z, Q16(12));
    }
    qtri_transform_orbit(&w->view.camera, center, distance, turn, above);
    if (random_one_in(w, 5)) {
        w->view.viewport.depth_near = random_between(w, 0, Q16(1));
        w->view.viewport.depth_far = random_between(w, 0, Q16(1));
        w->view.viewport.x = random_below(w, 20) - 5;
        w->view.viewport.height = w->height - random_below(w, w->height / 2);
    }
    random_lights(w);
    w->view.light = random_one_in(w, 3) ? NULL : &w->light;
    if (random_one_in(w, 2)) {
        w->view.light = &w->lights;
    }
    w->view.vertices = w->vertices;
    w->view.vertex_count =
        random_one_in(w, 3) ? (uint32_t)random_below(w, STATES_VERTICES) : STATES_VERTICES;
    qtri_transform_identity(&w->pose);
    if (random_one_in(w, 2)) {
        const qtri_vec3 axis = random_vec(w, Q16(1));
        const qtri_vec3 scale = random_vec(w, Q16(1.5));
        qtri_transform_rotate(&w->pose, turn, axis);
        qtri_transform_scale(&w->pose, scale);
    }
}

void random_mesh(random_states *w)
{
    const qtri_shape_memory memory = {w->positions, w->normals,      w->uvs,
                                      w->triangles, STATES_VERTICES, STATES_TRIANGLES};
    const qtri_vec3 half = {Q16(.9), Q16(.6), Q16(1.1)};
    enum qtri_error error = QTRI_OK;
    switch (random_below(w, 5)) {
    case 0:
        error = qtri_shape_box(&w->mesh, &memory, half);
        break;
    case 1:
        error = qtri_shape_sphere(&w->mesh, &memory, Q16(1), 9, 6);
        break;
    case 2:
        error = qtri_shape_torus(&w->mesh, &memory, Q16(1), Q16(.4), 8, 7);
        break;
    case 3:
        error = qtri_shape_cone(&w->mesh, &memory, Q16(1), Q16(1.2), 9);
        break;
    default:
        error = qtri_shape_grid(&w->mesh, &memory, Q16(2), Q16(2), 6, 7);
        break;
    }
    w->failed |= error != QTRI_OK;
    for (uint32_t i = 0; i < w->mesh.vertex_count; i++) {
        w->colors[i] = random_rgb(w);
        w->alphas[i] = random_byte(w);
        w->positions16[i].x = (int16_t)(w->positions[i].x >> 3);
        w->positions16[i].y = (int16_t)(w->positions[i].y >> 3);
        w->positions16[i].z = (int16_t)(w->positions[i].z >> 3);
    }
    if (random_one_in(w, 4)) {
        for (uint32_t i = 0; i < w->mesh.triangle_count; i += 5) {
            w->triangles[i][1] = (uint16_t)random_below(w, (int32_t)w->mesh.vertex_count);
        }
    }
    for (uint32_t i = 0; i < w->mesh.vertex_count; i++) {
        w->normals8[i].x = (int8_t)(w->normals[i].x / 256);
        w->normals8[i].y = (int8_t)(w->normals[i].y / 256);
        w->normals8[i].z = (int8_t)(w->normals[i].z / 256);
        w->uvs16[i].x = (int16_t)(w->uvs[i].x / 8);
        w->uvs16[i].y = (int16_t)(w->uvs[i].y / 8);
    }
    w->mesh.normals8 = random_one_in(w, 4) ? w->normals8 : NULL;
    w->mesh.uvs16 = random_one_in(w, 4) ? w->uvs16 : NULL;
    w->mesh.colors = random_one_in(w, 2) ? w->colors : NULL;
    w->mesh.normals = random_one_in(w, 6) ? NULL : w->mesh.normals;
    w->mesh.uvs = random_one_in(w, 6) ? NULL : w->mesh.uvs;
    if (random_one_in(w, 3)) {
        static const qtri_box none;
        w->mesh.positions16 = w->positions16;
        w->mesh.bounds = none; /* they were those of the wide positions */
        w->mesh.origin = random_vec(w, Q16(.3));
        w->mesh.extent = random_between(w, Q16(.5), Q16(5));
    }
}

void random_solid(random_states *w)
{
    qtri_material *m = &w->material;
    const qtri_vec3 center = {0, 0, 0};
    const q16 fovy = random_between(w, Q16(30), Q16(60));
    const q16 turn = random_between(w, Q16(-180), Q16(180));
    const q16 above = random_between(w, Q16(-60), Q16(60));
    const q16 distance = random_between(w, Q16(2), Q16(4));
    random_mesh(w);
    w->mesh.extent = Q16(2);
    init_view(w);
    qtri_transform_perspective(&w->view.projection, fovy, Q16(1) * w->width / w->height, Q16(.3),
                               Q16(12));
    qtri_transform_orbit(&w->view.camera, center, distance, turn, above);
    w->view.vertices = w->vertices;
    w->view.vertex_count = STATES_VERTICES;
    w->view.light = random_one_in(w, 3) ? &w->light : &w->lights;
    qtri_transform_identity(&w->pose);
    switch (random_below(w, 4)) {
    case 0:
        m->shading = QTRI_FLAT_FIRST;
        break;
    case 1:
        m->shading = QTRI_SMOOTH;
        break;
    default:
        m->shading = &qtri_per_pixel;
        break;
    }
    m->texture = random_one_in(w, 4) ? NULL : &w->texture;
    m->texture_mode = random_one_in(w, 4) ? QTRI_REPLACE : QTRI_MODULATE;
    w->texture.has_key = random_one_in(w, 8);
    m->cull = random_one_in(w, 2) ? QTRI_CULL_BACK : QTRI_CULL_NONE;
    m->fill = NULL;
    m->depth_compare = random_one_in(w, 6) ? QTRI_DEPTH_OFF : QTRI_LESS;
    m->depth_bias = 0;
    m->depth_shift = NULL;
    m->alpha |= 64;
    m->keep = 0;
    m->least_alpha = 0;
}

void random_corners(random_states *w)
{
    for (int i = 0; i < STATES_CORNERS; i++) {
        qtri_corner *corner = &w->corners[i];
        const qtri_vec3 at = random_vec(w, random_one_in(w, 4) ? Q16(6) : Q16(1.3));
        corner->position.x = at.x;
        corner->position.y = at.y;
        corner->position.z = at.z;
        corner->position.w = random_one_in(w, 6) ? random_between(w, Q16(-.2), Q16(2)) : Q16(1);
        corner->color = random_rgb(w);
        corner->uv.x = random_between(w, Q16(-3), Q16(3));
        corner->uv.y = random_between(w, Q16(-3), Q16(3));
        w->alphas[i] = random_byte(w);
        w->normals[i].x = (int16_t)random_below(w, 32768);
        w->normals[i].y = (int16_t)random_below(w, 32768);
        w->normals[i].z = (int16_t)-random_below(w, 32768);
    }
}

/* On an edge of the surface, or next to it. */
static int32_t at_edge(random_states *w, int32_t size)
{
    const int32_t edge = random_one_in(w, 2) ? 0 : size * 256;
    return edge + random_below(w, 5) - 2;
}

/* From 0 to what a number of `bits` bits holds. */
static uint32_t of_bits(random_states *w, int32_t bits)
{
    return (uint32_t)random_bits32(&w->seed) >> (32 - bits);
}

/*
 * Depths, distances and places in a texture of a triangle's vertices are mostly next to each other:
 * thresholds of slopes are passed by few that have nothing to do with each other.
 */
static void bring_together(random_states *w)
{
    const int32_t depth_bits = 8 + random_below(w, 22);
    const int32_t inv_w_bits = 8 + random_below(w, 22);
    const int32_t nearer = random_below(w, 9);
    const int32_t exponent = random_below(w, 5) - 2;
    for (int i = 1; i < STATES_CORNERS; i++) {
        qtri_screen_vertex *v = &w->screen[i];
        v->depth_16p16 = w->screen[0].depth_16p16 + of_bits(w, depth_bits);
        v->inv_w_q31 = 0x40000000u + of_bits(w, inv_w_bits);
        v->inv_w_exponent = exponent + (random_one_in(w, 3) ? random_below(w, 4) : 0);
        v->u_q32 = w->screen[0].u_q32 + v->u_q32 / (1 << nearer);
        v->v_q32 = w->screen[0].v_q32 + v->v_q32 / (1 << nearer);
    }
}

void random_screen(random_states *w)
{
    static const int32_t reaches[] = {200, 900, 4000, 20000, 900000, 1 << 23};
    const int32_t reach = reaches[random_below(w, LENGTH_OF(reaches))];
    const int32_t x = random_below(w, w->width * 256);
    const int32_t y = random_below(w, w->height * 256);
    const bool on_grid = random_one_in(w, 3); /* vertices and edges on centres of pixels */
    const bool at_edges = random_one_in(w, 4);
    for (int i = 0; i < STATES_CORNERS; i++) {
        qtri_screen_vertex *v = &w->screen[i];
        v->x_24p8 = x + random_in(&w->seed, -reach, reach);
        v->y_24p8 = y + random_in(&w->seed, -reach, reach);
        if (on_grid) {
            v->x_24p8 = (v->x_24p8 & ~255) + 128;
            v->y_24p8 = (v->y_24p8 & ~255) + 128;
        } else if (at_edges && random_one_in(w, 2)) {
            v->x_24p8 = random_one_in(w, 2) ? at_edge(w, w->width) : v->x_24p8;
            v->y_24p8 = random_one_in(w, 2) ? at_edge(w, w->height) : v->y_24p8;
        }
        v->depth_16p16 = random_word(w);
        v->inv_w_q31 = 0x40000000u + ((uint32_t)random_bits32(&w->seed) >> 1);
        v->inv_w_exponent = random_one_in(w, 3) ? random_below(w, 20) - 10 : 0;
        v->u_q32 = (int64_t)random_between(w, Q16(-3), Q16(3)) * 65536;
        v->v_q32 = (int64_t)random_between(w, Q16(-3), Q16(3)) * 65536;
        for (int k = 0; k < 3; k++) {
            v->color_8p16[k] = random_one_in(w, 4) ? (random_below(w, 3) - 1) * (255 << 17)
                                                   : random_below(w, 256 << 16);
        }
    }
    if (random_one_in(w, 2)) {
        bring_together(w);
    }
}
