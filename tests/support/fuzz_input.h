/* SPDX-License-Identifier: MIT */
/*
 * Arbitrary bytes as transforms, materials, lights and meshes. The order in which bytes are taken
 * is that of tests/corpus: what changes it makes that of no use. Numbers are read the lowest byte
 * first and member by member, by a statement each: an input draws the same with any compiler and
 * any size of a pointer.
 */
#ifndef QTRI_TESTS_SUPPORT_FUZZ_INPUT_H
#define QTRI_TESTS_SUPPORT_FUZZ_INPUT_H

#include <qtri.h>

#include <stdlib.h>
#include <string.h>

enum { VERTICES = 12, TRIANGLES = 16 };

struct reader {
    const uint8_t *data;
    size_t left;
};

/* Zeros once the input is used up. */
static inline uint8_t take_byte(struct reader *r)
{
    if (r->left == 0) {
        return 0;
    }
    r->left--;
    return *r->data++;
}

static inline void take(struct reader *r, void *out, size_t size)
{
    uint8_t *byte = out;
    for (size_t i = 0; i < size; i++) {
        byte[i] = take_byte(r);
    }
}

/* One of `count` values of an enum; for one byte in sixteen a number that is none, small or large.
 */
static inline uint32_t take_choice(struct reader *r, uint32_t count)
{
    const uint32_t byte = take_byte(r);
    return byte < 240 ? byte % count : byte < 248 ? byte : 0u - byte;
}

static inline uint32_t take_bits(struct reader *r)
{
    uint8_t byte[4];
    take(r, byte, sizeof byte);
    return byte[0] | (uint32_t)byte[1] << 8 | (uint32_t)byte[2] << 16 | (uint32_t)byte[3] << 24;
}

static inline int32_t take_int(struct reader *r)
{
    const uint32_t bits = take_bits(r);
    int32_t value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static inline void take_ints(struct reader *r, int32_t *out, int count)
{
    for (int i = 0; i < count; i++) {
        out[i] = take_int(r);
    }
}

static inline int64_t take_long(struct reader *r)
{
    const uint32_t low = take_bits(r);
    return ((int64_t)take_int(r) * 65536 * 65536) + low;
}

static inline int16_t take_short(struct reader *r)
{
    const int32_t low = take_byte(r);
    const int32_t high = take_byte(r);
    return (int16_t)(low + 256 * (high < 128 ? high : high - 256));
}

/* Mostly numbers of a plausible size: pure noise would be clipped away at once. */
static inline q16 take_number(struct reader *r)
{
    uint8_t kind = take_byte(r);
    int32_t value = take_int(r);
    return (kind & 3) == 0 ? value : value >> (10 + (kind & 7));
}

static inline void take_numbers(struct reader *r, q16 *out, int count)
{
    for (int i = 0; i < count; i++) {
        out[i] = take_number(r);
    }
}

static inline qtri_vec3 take_vec3(struct reader *r)
{
    qtri_vec3 v;
    v.x = take_number(r);
    v.y = take_number(r);
    v.z = take_number(r);
    return v;
}

/* Three numbers of any bits. */
static inline qtri_vec3 take_any_vec3(struct reader *r)
{
    qtri_vec3 v;
    v.x = take_int(r);
    v.y = take_int(r);
    v.z = take_int(r);
    return v;
}

static inline void build_transform(struct reader *r, qtri_transform *t)
{
    qtri_transform_identity(t);
    for (int steps = take_byte(r) % 5; steps > 0; steps--) {
        qtri_vec3 a = take_vec3(r);
        qtri_vec3 triangle[3]; /* numbers are taken a statement each: in one order */
        q16 n[3];
        qtri_quat q;
        qtri_mat4 m;
        switch (take_byte(r) % 14) {
        case 0:
            qtri_transform_translate(t, a);
            break;
        case 1:
            qtri_transform_scale(t, a);
            break;
        case 2:
            qtri_transform_rotate(t, take_number(r), a);
            break;
        case 3:
            n[0] = take_number(r);
            qtri_transform_rotate_about(t, n[0], a, take_vec3(r));
            break;
        case 4:
            triangle[0] = a;
            triangle[1] = take_vec3(r);
            triangle[2] = take_vec3(r);
            qtri_transform_rotate_triangle(t, take_number(r), triangle);
            break;
        case 5:
            q.w = take_int(r);
            q.x = take_int(r);
            q.y = take_int(r);
            q.z = take_int(r);
            qtri_transform_rotate_quat(t, q);
            break;
        case 6:
            triangle[0] = take_vec3(r);
            triangle[1] = take_vec3(r);
            qtri_transform_look_at(t, a, triangle[0], triangle[1]);
            break;
        case 7:
            qtri_transform_perspective(t, a.x, a.y, a.z, take_number(r));
            break;
        case 8:
            take_numbers(r, n, 3);
            qtri_transform_frustum(t, a.x, a.y, a.z, n[0], n[1], n[2]);
            break;
        case 9:
            take_numbers(r, n, 3);
            qtri_transform_ortho(t, a.x, a.y, a.z, n[0], n[1], n[2]);
            break;
        case 10:
            qtri_transform_perspective_d3d(t, a.x, a.y, a.z, take_number(r));
            break;
        case 11:
            qtri_transform_rotate_x(t, a.x);
            qtri_transform_rotate_y(t, a.y);
            break;
        case 12:
            qtri_transform_perspective(t, Q16(60), Q16(1), Q16(0.1), Q16(10));
            break;
        default:
            for (int i = 0; i < 4; i++) {
                take_ints(r, m.m[i], 4);
            }
            qtri_transform_from_mat4(t, &m);
            qtri_transform_to_mat4(t, &m);
            break;
        }
    }
}

static const qtri_rgb palette[256] = {{1, 2, 3}, {255, 255, 255}};
static const uint16_t palette565[256] = {0x0001, 0xFFFF};

static const qtri_texel_format *const texel_formats[7] = {
    &qtri_texel_rgb565,    &qtri_texel_xrgb8888, &qtri_texel_checker,
    &qtri_texel_palette8,  &qtri_texel_gray8,    NULL,
    &qtri_texel_palette565};

static const qtri_format *const surface_formats[6] = {
    &qtri_rgb565, &qtri_xrgb8888, &qtri_gray8, &qtri_rgb565_swapped, &qtri_rgb888, &qtri_bgr888};

static qtri_fog fog;

/* Blend, fog and alpha, of one input in two. */
static inline void build_effects(struct reader *r, qtri_material *m, qtri_texture *texture)
{
    static const qtri_blend *const blends[6] = {NULL,
                                                &qtri_blend_alpha,
                                                &qtri_blend_add,
                                                &qtri_blend_multiply,
                                                &qtri_blend_none,
                                                &qtri_blend_screen_door};
    static const qtri_texel_format *const with_alpha[4] = {
        &qtri_texel_argb4444, &qtri_texel_argb1555, &qtri_texel_argb8888, &qtri_texel_alpha8};
    if (take_byte(r) % 2 == 0) {
        return;
    }
    m->blend = blends[take_byte(r) % 6];
    m->alpha = take_byte(r);
    m->least_alpha = take_byte(r) % 2 ? take_byte(r) : 0;
    if (take_byte(r) % 2) {
        texture->format = with_alpha[take_byte(r) % 4];
    }
    const uint8_t kind = take_byte(r);
    qtri_fog_range range;
    range.near_z = take_int(r);
    range.far_z = take_int(r);
    range.orthographic = kind % 8 > 3;
    const qtri_rgb color = {kind, 1, 2};
    memset(&fog, 0, sizeof fog);
    if (kind % 4 == 1) {
        const q16 near_distance = take_int(r);
        qtri_fog_linear(&fog, color, range, near_distance, take_int(r));
    } else if (kind % 4 == 2) {
        qtri_fog_exp(&fog, color, range, take_int(r));
    } else if (kind % 4 == 3) {
        qtri_fog_exp2(&fog, color, range, take_int(r));
    }
    m->fog = kind % 16 == 0 ? NULL : &fog;
}

static inline qtri_material build_material(struct reader *r, qtri_texture *texture,
                                           const void *levels[4], const void *texels)
{
    const qtri_shading *const shadings[3] = {QTRI_SMOOTH, QTRI_FLAT_FIRST, QTRI_FLAT_LAST};
    qtri_material m = qtri_material_default();
    m.shading = shadings[take_byte(r) % 3];
    m.interpolation = (qtri_interpolation)take_choice(r, 2);
    m.texture_mode = (qtri_texture_mode)take_choice(r, 2);
    m.cull = (qtri_cull)take_choice(r, 3);
    m.fill = take_byte(r) % 2 ? &qtri_wireframe : NULL;
    m.depth_compare = (qtri_compare)take_choice(r, 9);
    m.depth_read_only = take_byte(r) % 4 == 0;
    take(r, &m.color, sizeof m.color);
    texture->format = texel_formats[take_byte(r) % 7];
    texture->texels = take_byte(r) % 16 ? texels : NULL;
    texture->width_log2 = take_byte(r) % 4; /* 8 x 8 texels of memory */
    texture->height_log2 = take_byte(r) % 4;
    texture->fields = take_byte(r);
    take(r, texture->color, sizeof texture->color);
    texture->wrap_u = (qtri_wrap)take_choice(r, 3);
    texture->wrap_v = (qtri_wrap)take_choice(r, 3);
    static const qtri_filter *const filters[] = {NULL, &qtri_bilinear, &qtri_mipmapped,
                                                 &qtri_mipmapped_bilinear};
    texture->filter = filters[take_byte(r) % 4];
    const uint8_t holes = take_byte(r);
    for (size_t i = 0; i < 4; i++) {
        levels[i] = holes >> i & 1 ? NULL : texels;
    }
    texture->levels = holes % 16 == 5 ? NULL : levels;
    texture->level_count = holes >> 4;
    texture->palette = take_byte(r) % 16 == 0                      ? NULL
                       : texture->format == &qtri_texel_palette565 ? (const void *)palette565
                                                                   : palette;
    texture->has_key = take_byte(r) % 2;
    texture->key = take_byte(r) % 8 ? take_byte(r) : (uint32_t)take_int(r);
    m.texture = take_byte(r) % 2 ? texture : NULL;
    build_effects(r, &m, texture);
    return m;
}

/* Lights of any bits, and what they point to. */
typedef struct lamps {
    qtri_light lights;
    qtri_light_source sources[QTRI_LIGHTS_MAX];
    qtri_shininess table;
    qtri_reflection reflection;
} lamps;

static inline void build_source(struct reader *r, qtri_light_source *source)
{
    source->position = take_any_vec3(r);
    source->color.r = take_int(r);
    source->color.g = take_int(r);
    source->color.b = take_int(r);
    source->constant = take_int(r);
    source->linear = take_int(r);
    source->quadratic = take_int(r);
    source->direction = take_any_vec3(r);
    source->inner = take_int(r);
    source->outer = take_int(r);
}

static inline const qtri_light *build_lamps(struct reader *r, lamps *l)
{
    static const qtri_light_kind *const kinds[4] = {&qtri_directional_light, &qtri_point_light,
                                                    &qtri_spot_light, NULL};
    qtri_light_color ambient;
    const uint32_t count = take_byte(r) % (QTRI_LIGHTS_MAX + 2);
    ambient.r = take_int(r);
    ambient.g = take_int(r);
    ambient.b = take_int(r);
    qtri_shininess_init(&l->table, take_number(r));
    for (uint32_t i = 0; i < count && i < QTRI_LIGHTS_MAX; i++) {
        build_source(r, &l->sources[i]);
        l->sources[i].kind = kinds[take_byte(r) % 4];
        l->sources[i].falloff = take_byte(r) % 2 ? &l->table : NULL;
    }
    take(r, &l->reflection.ambient, sizeof l->reflection.ambient);
    take(r, &l->reflection.specular, sizeof l->reflection.specular);
    take(r, &l->reflection.emission, sizeof l->reflection.emission);
    l->reflection.shininess = take_byte(r) % 2 ? &l->table : NULL;
    l->reflection.own_ambient = take_byte(r) % 2;
    l->reflection.two_sided = take_byte(r) % 2;
    (void)qtri_light_init(&l->lights, l->sources, count, ambient);
    return &l->lights;
}

/* A mesh of any bits, in memory of its own. */
typedef struct soup {
    qtri_vec3 positions[VERTICES];
    qtri_normal normals[VERTICES];
    qtri_vec2 uvs[VERTICES];
    qtri_rgb colors[VERTICES];
    uint16_t triangles[TRIANGLES][3];
    qtri_position16 positions16[VERTICES];
    qtri_face8 planes[TRIANGLES];
    qtri_mesh mesh;
} soup;

static inline const qtri_mesh *build_mesh(struct reader *r, soup *s)
{
    for (int i = 0; i < VERTICES; i++) {
        s->positions[i] = take_vec3(r);
    }
    for (int i = 0; i < VERTICES; i++) {
        s->normals[i].x = take_short(r);
        s->normals[i].y = take_short(r);
        s->normals[i].z = take_short(r);
    }
    for (int i = 0; i < VERTICES; i++) {
        s->uvs[i].x = take_int(r);
        s->uvs[i].y = take_int(r);
    }
    take(r, s->colors, sizeof s->colors);
    for (int i = 0; i < TRIANGLES; i++) {
        for (int j = 0; j < 3; j++) {
            s->triangles[i][j] = take_byte(r) % (VERTICES + 1);
        }
    }
    uint8_t parts = take_byte(r);
    const qtri_mesh mesh = {.positions = s->positions,
                            .normals = parts & 1 ? s->normals : NULL,
                            .uvs = parts & 2 ? s->uvs : NULL,
                            .colors = parts & 4 ? s->colors : NULL,
                            .triangles = (const uint16_t(*)[3])s->triangles,
                            .vertex_count = VERTICES,
                            .triangle_count = TRIANGLES};
    s->mesh = mesh;
    for (int i = 0; i < VERTICES; i++) {
        s->positions16[i].x = take_short(r);
        s->positions16[i].y = take_short(r);
        s->positions16[i].z = take_short(r);
    }
    take(r, s->planes, sizeof s->planes);
    s->mesh.positions16 = parts & 8 ? s->positions16 : NULL;
    s->mesh.origin = take_vec3(r);
    s->mesh.extent = take_number(r);
    if (parts & 16) { /* whatever the planes are */
        s->mesh.faces.culling = parts & 32 ? &qtri_cull_by_planes : NULL;
        s->mesh.faces.planes = s->planes;
        s->mesh.faces.thin = (uint32_t)take_number(r);
        s->mesh.faces.error_q16 = (uint16_t)take_number(r);
        s->mesh.faces.radius_q14 = (uint16_t)take_number(r);
    }
    return &s->mesh;
}

#endif
