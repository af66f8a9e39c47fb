/* SPDX-License-Identifier: MIT */
#include "lighting.h"

#include "../bits/bits.h"
#include "../math/unit.h"
#include "projector.h"

/*
 * ambient + diffuse (n . towards) / unit as a row of intensities times 2^25, plus half of a step of
 * 2^-15. |m| <= 4 2^27, 2^29.8 for all three.
 */
static void set_plain_row(qtri_lighting *lighting, bool is_bytes)
{
    int32_t m[3];
    for (int i = 0; i < 3; i++) {
        int64_t product_q46 =
            qtri_mul_s32(lighting->towards_q30[i], lighting->diffuse); /* <= 2^48 */
        const uint64_t above = qtri_magnitude64(product_q46) >> 12;
        /* The factor is 2^64 / 127, rounded up by less than 2^-36 of the 2^36 that above may be. */
        const int32_t size =
            (int32_t)(is_bytes ? qtri_mul_high64(above, 0x204081020408103u) : above >> 7);
        m[i] = (product_q46 < 0 ? -size : size) & ~(int32_t)3;
    }
    int64_t ambient_q16 = lighting->ambient > Q16_ONE ? Q16_ONE : lighting->ambient;
    int64_t t_q41 = (ambient_q16 << 25) + ((int64_t)1 << 25);
    qtri_row16_set(&lighting->by.row, m, t_q41);
    lighting->least_q15 = (uint32_t)(t_q41 >> 26);
}

void qtri_lighting_init(qtri_lighting *lighting, const qtri_light *light,
                        const qtri_transform *object_to_eye, bool is_bytes,
                        const qtri_uneven_light *uneven)
{
    int32_t m[3][4];
    (void)qtri_linear_align(m, object_to_eye);
    lighting->ambient = light->ambient;
    lighting->diffuse = light->diffuse;
    lighting->even = qtri_linear_is_even(m);
    lighting->plain = lighting->even && light->ambient >= 0 && light->diffuse >= 0 &&
                      light->diffuse <= 4 * Q16_ONE;
    const int32_t towards[3] = {light->towards.x, light->towards.y, light->towards.z};
    lighting->uneven = uneven;
    if (!lighting->plain && uneven == NULL) {
        lighting->ambient = Q16_ONE;
        lighting->diffuse = 0;
        lighting->even = lighting->plain = true;
    }
    if (!lighting->even) {
        uneven->init(lighting, towards, object_to_eye);
        return;
    }
    int64_t object[3]; /* the transpose takes it there; < 3 2^61 */
    int32_t fitted[3];
    for (int i = 0; i < 3; i++) {
        m[i][3] = towards[i];
    }
    for (int i = 0; i < 3; i++) {
        object[i] = qtri_linear_dot(m, i, 3);
    }
    (void)qtri_fit32(fitted, object, 3);
    (void)qtri_unit(lighting->towards_q30, fitted, 3, 30); /* stays zero for no direction */
    if (lighting->plain) {
        set_plain_row(lighting, is_bytes);
    }
}

static int64_t dot_q30(const int32_t v[3], const int32_t unit_q30[3])
{
    return (int64_t)v[0] * unit_q30[0] + (int64_t)v[1] * unit_q30[1] + (int64_t)v[2] * unit_q30[2];
}

static uint32_t intensity(const qtri_lighting *lighting, int64_t cosine_q16)
{
    q16 cosine = cosine_q16 > 0 ? qtri_saturate32(cosine_q16) : 0;
    q16 sum = q16_add(lighting->ambient, q16_mul(lighting->diffuse, cosine));
    return ((uint32_t)q16_clamp(sum, 0, Q16_ONE) + 1) >> 1;
}

/* For a normal of any length below 2^31. */
static uint32_t light_direction(const qtri_lighting *lighting, const int32_t normal[3])
{
    int64_t v[3] = {normal[0], normal[1], normal[2]};
    if (!lighting->even) {
        for (int i = 0; i < 3; i++) {
            v[i] = dot_q30(normal, lighting->by.normal_q28[i]); /* < 3 2^59 */
        }
    }
    int32_t scaled[3];
    (void)qtri_align32(scaled, v, 29);
    if ((scaled[0] | scaled[1] | scaled[2]) == 0) {
        return intensity(lighting, 0);
    }
    /* (v . l) 2^16 / |v|: |v| >= 2^28, v . l < 2^29.8 2^30 */
    uint64_t square = 0;
    for (int i = 0; i < 3; i++) {
        square += (uint64_t)((int64_t)scaled[i] * scaled[i]); /* < 2^58 each */
    }
    int64_t dot = dot_q30(scaled, lighting->towards_q30);
    bool half;
    return intensity(lighting, dot <= 0
                                   ? 0
                                   : (int64_t)qtri_divide64((uint64_t)dot >> 14,
                                                            qtri_sqrt64_round(square), 0, &half));
}

static inline uint32_t light_plain(const qtri_row16 *row, uint32_t least_q15, int32_t x, int32_t y,
                                   int32_t z)
{
    const int32_t sum_q15 = qtri_greatest32(qtri_row16_sum(row, x, y, z) >> 10, (int32_t)least_q15);
    return (uint32_t)sum_q15 > QTRI_INTENSITY_ONE ? QTRI_INTENSITY_ONE : (uint32_t)sum_q15;
}

static uint32_t light_vertex(const qtri_lighting *lighting, const qtri_mesh *mesh, uint32_t index)
{
    int32_t n[3];
    qtri_lit_vertex_normal(n, mesh, index);
    return lighting->plain ? light_plain(&lighting->by.row, lighting->least_q15, n[0], n[1], n[2])
                           : lighting->uneven->direction(lighting, n);
}

static void light_list(const qtri_lighting *lighting, const qtri_mesh *mesh, uint32_t count,
                       qtri_vertex *vertices)
{
    const qtri_normal8 *normals = mesh->normals8;
    const qtri_vertex *end = vertices + count;
    if (normals == NULL || !lighting->plain) {
        for (const qtri_vertex *at = vertices; at != end; at++) {
            vertices[at->index].intensity_q15 = (uint16_t)light_vertex(lighting, mesh, at->index);
        }
        return;
    }
    const qtri_row16 row = lighting->by.row;
    const uint32_t least_q15 = lighting->least_q15;
    for (const qtri_vertex *at = vertices; at != end; at++) {
        const qtri_normal8 *n = &normals[at->index];
        vertices[at->index].intensity_q15 =
            (uint16_t)light_plain(&row, least_q15, n->x * 128, n->y * 128, n->z * 128);
    }
}

const qtri_vertex_light qtri_light_by_vertex = {
    .init = qtri_lighting_init, .vertex = light_vertex, .list = light_list};

/* A word whose upper half is 0 when all are within +-2^15; several may be or-ed. */
static inline uint32_t reach(const int32_t e[3])
{
    return ((uint32_t)e[0] + 0x7FFFu) | ((uint32_t)e[1] + 0x7FFFu) | ((uint32_t)e[2] + 0x7FFFu);
}

/* Whether both edges are below 2^15, so that the face's normal fits 32 bits. */
static inline bool is_short(const int32_t e[3], const int32_t f[3])
{
    return (reach(e) | reach(f)) < 0x10000u;
}

/* The upper 16 bits of n 2^(zeros - 1), to nearest; 1 - 2^-15 times that, or the half would not
 * fit. */
static inline int32_t mantissa16(int32_t n, int32_t zeros)
{
    int32_t whole = (int32_t)((uint32_t)n << (zeros - 1));
    return (whole - (whole >> 15) + 0x8000) >> 16;
}

/*
 * The plain light on a face whose normal is n, not 0, with a largest component of 2^14 - 1..2^15.
 * s = n . n is in (2^27, 3 2^30]; with v = s 2^zeros / 2^32 in [1/4, 1) and y = v^-1/2 the dot
 * product with n counts 2^14 / |n| = 2^(zeros / 2 - 2) y times. Newton's step y + y (1 - v y^2) / 2
 * takes y from 2^-13 to 2^-25.
 */
static uint32_t light_mantissas(const qtri_lighting *lighting, int32_t x, int32_t y, int32_t z)
{
    QTRI_HOLD(x); /* 32 bits again: GCC 12 would multiply 64 */
    QTRI_HOLD(y);
    QTRI_HOLD(z);
    int32_t ambient_q25 = qtri_row16_sum(&lighting->by.row, 0, 0, 0);
    int32_t dot_q25 = qtri_row16_sum(&lighting->by.row, x, y, z) - ambient_q25; /* < 2^29 */
    if (dot_q25 <= 0) {
        return lighting->least_q15;
    }
    QTRI_HOLD(dot_q25);
    uint32_t square = (uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z);
    int32_t even = qtri_clz32(square) & 6;
    square <<= even;
    uint32_t y_q30 = qtri_rsqrt_seed(square >> 16) << 15; /* <= 2^31 + 2^17 */
    uint32_t unit_q28 = qtri_mul_high32(qtri_mul_high32(square, y_q30), y_q30);
    int32_t error_q28 = (int32_t)(0x10000000u - unit_q28); /* < 2^17 */
    y_q30 += (uint32_t)(((error_q28 >> 2) * (int32_t)(y_q30 >> 15)) >> 12);
    int32_t y_q29 = (int32_t)(y_q30 >> 1);
    QTRI_HOLD(y_q29);
    int32_t light_q24 = qtri_mul_high_s32(dot_q25, y_q29) << (even >> 1);
    int32_t sum_q15 = (light_q24 * 2 + ambient_q25) >> 10;
    return (uint32_t)sum_q15 > QTRI_INTENSITY_ONE ? QTRI_INTENSITY_ONE : (uint32_t)sum_q15;
}

/* |x|, or one less. */
static inline uint32_t size_of(int32_t x)
{
    return (uint32_t)(x ^ (x >> 31));
}

static uint32_t light_face(const qtri_lighting *lighting, const int32_t n[3])
{
    const uint32_t all = size_of(n[0]) | size_of(n[1]) | size_of(n[2]);
    if ((n[0] | n[1] | n[2]) == 0) {
        return lighting->least_q15;
    }
    int32_t zeros = qtri_clz32(all | 1u); /* >= 1 */
    return light_mantissas(lighting, mantissa16(n[0], zeros), mantissa16(n[1], zeros),
                           mantissa16(n[2], zeros));
}

void qtri_face_edge(int32_t edge[3], const qtri_vec3 *a, const qtri_vec3 *b)
{
    const int64_t e[3] = {(int64_t)b->x - a->x, (int64_t)b->y - a->y, (int64_t)b->z - a->z};
    const uint64_t all = qtri_magnitude64(e[0]) | qtri_magnitude64(e[1]) | qtri_magnitude64(e[2]);
    const int32_t down = all >> 30 != 0 ? 3 : 0; /* below 2^33 */
    for (int i = 0; i < 3; i++) {
        edge[i] = (int32_t)(e[i] >> down);
    }
}

uint32_t qtri_lighting_face(const qtri_lighting *lighting, const qtri_vec3 *a, const qtri_vec3 *b,
                            const qtri_vec3 *c)
{
    int32_t e[6];
    int32_t n[3];
    const uint32_t size = size_of(a->x) | size_of(a->y) | size_of(a->z) | size_of(b->x) |
                          size_of(b->y) | size_of(b->z) | size_of(c->x) | size_of(c->y) |
                          size_of(c->z);
    if (size >> 29 != 0) {
        qtri_face_edge(e, a, b);
        qtri_face_edge(&e[3], a, c);
    } else {
        e[0] = b->x - a->x;
        e[1] = b->y - a->y;
        e[2] = b->z - a->z;
        e[3] = c->x - a->x;
        e[4] = c->y - a->y;
        e[5] = c->z - a->z;
    }
    if (is_short(e, &e[3])) {
        n[0] = e[1] * e[5] - e[2] * e[4]; /* |e| < 2^15: below 2^31 */
        n[1] = e[2] * e[3] - e[0] * e[5];
        n[2] = e[0] * e[4] - e[1] * e[3];
    } else {
        int64_t cross[3];
        qtri_cross64(cross, e, &e[3]); /* <= 2^61 */
        const uint64_t all =
            qtri_magnitude64(cross[0]) | qtri_magnitude64(cross[1]) | qtri_magnitude64(cross[2]);
        const int32_t down = qtri_greatest32(35 - qtri_clz64(all), 0); /* leaves 29 bits */
        n[0] = (int32_t)(cross[0] >> down);
        n[1] = (int32_t)(cross[1] >> down);
        n[2] = (int32_t)(cross[2] >> down);
    }
    return lighting->plain ? light_face(lighting, n) : lighting->uneven->direction(lighting, n);
}

/*
 * With s = n . n < 2^16 and h = zeros / 2 such that 2^14 <= s 4^h < 2^16, y = (s 4^h / 2^16)^-1/2:
 * the row's product of 128 n counts |n| / 128 too much, which is 2^h y / 2^8 to be multiplied by.
 */
uint32_t qtri_lighting_face8(const qtri_lighting *lighting, const qtri_face8 *face)
{
    const int32_t x = face->x * 128;
    const int32_t y = face->y * 128;
    const int32_t z = face->z * 128;
    const int32_t ambient_q25 = qtri_row16_sum(&lighting->by.row, 0, 0, 0);
    const int32_t dot_q25 = qtri_row16_sum(&lighting->by.row, x, y, z) - ambient_q25;
    if (dot_q25 <= 0) {
        return lighting->least_q15;
    }
    const uint32_t square = (uint32_t)(x * x + y * y + z * z) >> 14;
    const int32_t zeros = qtri_clz32(square) & 14;
    const uint32_t y_q15 = qtri_rsqrt_seed(square << zeros);            /* <= 2^16 + 4 */
    const uint32_t dot_q12 = ((uint32_t)dot_q25 << (zeros >> 1)) >> 13; /* < 4 2 2^12 */
    const uint32_t light_q25 = (dot_q12 * y_q15) >> 3;
    const uint32_t sum_q15 = (light_q25 + (uint32_t)ambient_q25) >> 10;
    return sum_q15 > QTRI_INTENSITY_ONE ? QTRI_INTENSITY_ONE : sum_q15;
}

static uint32_t light_mesh_face(const qtri_lighting *lighting, const qtri_mesh *mesh,
                                uint32_t number, const uint32_t index[3])
{
    qtri_vec3 p[3];
    if (mesh->faces.planes != NULL && lighting->plain) {
        const qtri_face8 *plane = &mesh->faces.planes[number];
        if ((plane->x | plane->y | plane->z) != 0) {
            return qtri_lighting_face8(lighting, plane);
        }
    }
    qtri_mesh_positions(p, mesh, index);
    return qtri_lighting_face(lighting, &p[0], &p[1], &p[2]);
}

const qtri_face_light qtri_light_by_face = {.init = qtri_lighting_init, .face = light_mesh_face};

static void init_uneven(qtri_lighting *lighting, const int32_t towards[3],
                        const qtri_transform *object_to_eye)
{
    (void)qtri_unit(lighting->towards_q30, towards, 3, 30);
    qtri_linear_normals(lighting->by.normal_q28, object_to_eye);
}

const qtri_uneven_light qtri_light_uneven = {.init = init_uneven, .direction = light_direction};
