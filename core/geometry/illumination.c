/* SPDX-License-Identifier: MIT */
/*
 * Set-up of the light sources of a draw call, rarer cases of lit points, tables of shininess, and
 * sphere maps.
 */
#include "qtri/error.h"
#include "qtri/q16.h"

#include "../bits/bits.h"
#include "../math/q16_trig.h"
#include "../math/unit.h"
#include "illumination.h"
#include "lighting.h"
#include "row.h"

/* ---- Set-up ---- */

/* A place below 2^29 has 2 bits to spare for the difference of two. */
enum { PLACE_BITS = 29, EXPONENT_MAX = 128, UNEVEN_UNIT_LOG2 = 24 };

/* A vector of the world in eye space; with `place` it is a position. */
static void to_eye(qtri_wide eye[3], const qtri_transform *camera, const qtri_vec3 *v, bool place)
{
    qtri_wide world[3];
    qtri_wide_from_vec3(world, v);
    for (int row = 0; row < 3; row++) {
        qtri_wide axis[3];
        qtri_row_axis(axis, &camera->row[row]);
        eye[row] = qtri_wide_inner(axis, world);
        if (place) {
            const qtri_wide element = qtri_row_element(&camera->row[row], 3);
            qtri_wide_add_to(&eye[row], &element);
        }
    }
}

/* From eye space back to object space, but for the scale: v times the transposed linear part. */
static void turn_back(qtri_wide v[3], const qtri_light_space *space)
{
    const qtri_wide eye[3] = {v[0], v[1], v[2]};
    for (int i = 0; i < 3; i++) {
        v[i] = qtri_wide_inner(space->column[i], eye);
    }
}

/* The least `bits` with all |v| below 2^bits. */
static int32_t bits_of(const qtri_wide v[3])
{
    return 62 - qtri_least32(qtri_wide_least(v, 3), 4 * QTRI_WIDE_EXPONENT_MAX);
}

static bool unit_q14(int32_t out[3], const qtri_wide v[3])
{
    const int32_t exponent = bits_of(v) - PLACE_BITS;
    int64_t fixed[3];
    for (int i = 0; i < 3; i++) {
        const int32_t down = v[i].e + exponent;
        fixed[i] = down > 62 ? 0 : qtri_shift_round(v[i].m, down);
    }
    return qtri_direction_q14(out, fixed);
}

bool qtri_light_direction(int32_t out_q14[3], const qtri_light_space *space, const qtri_vec3 *v)
{
    qtri_wide local[3];
    to_eye(local, space->camera, v, false);
    if (space->even) {
        turn_back(local, space);
    }
    return unit_q14(out_q14, local);
}

void qtri_light_place(int32_t out[3], int32_t *exponent, const qtri_light_space *space,
                      const qtri_vec3 *position)
{
    qtri_wide local[3];
    to_eye(local, space->camera, position, true);
    if (space->even) {
        for (int i = 0; i < 3; i++) {
            qtri_wide_add_to(&local[i], &space->offset[i]);
        }
        turn_back(local, space);
        for (int i = 0; i < 3; i++) {
            qtri_wide_mul_by(&local[i], &space->inverse);
            qtri_wide_add_to(&local[i], &space->origin[i]);
        }
    } else {
        for (int i = 0; i < 3; i++) {
            qtri_wide_div_by(&local[i], &space->unit);
        }
    }
    *exponent = qtri_hold32(bits_of(local) - PLACE_BITS, 0, EXPONENT_MAX);
    for (int i = 0; i < 3; i++) {
        const int64_t bound = (int64_t)1 << PLACE_BITS;
        const int32_t down = local[i].e + *exponent; /* below 31: the exponent was held */
        int64_t at = local[i].m < 0 ? -bound : bound;
        if (local[i].m == 0 || down > 62) {
            at = 0;
        } else if (down >= 31) {
            at = qtri_shift_round(local[i].m, down);
        }
        out[i] = (int32_t)(at > bound ? bound : at < -bound ? -bound : at);
    }
}

void qtri_light_color_q12(uint32_t out[3], const qtri_light_color *color)
{
    const q16 channel[3] = {color->r, color->g, color->b};
    for (int i = 0; i < 3; i++) {
        out[i] = ((uint32_t)qtri_hold32(channel[i], 0, 16 * Q16_ONE) + 8) >> 4;
    }
}

static void set_even_space(qtri_light_space *space, int32_t m[3][4], int32_t exponent,
                           const qtri_transform *object_to_eye, const qtri_mesh *compact)
{
    qtri_wide unit = qtri_wide_make(1, 16);
    qtri_vec3 origin = {0, 0, 0};
    if (compact != NULL) { /* extent / 32768 / 256 */
        unit = qtri_wide_make(compact->extent, 39);
        origin = compact->origin;
    }
    qtri_wide scale = qtri_wide_make(qtri_linear_dot(m, 0, 0), 2 * exponent); /* its square */
    space->unit = qtri_wide_sqrt(scale);
    qtri_wide_mul_by(&space->unit, &unit);
    qtri_wide_mul_by(&scale, &unit);
    space->inverse = qtri_wide_make(1, 0);
    qtri_wide_div_by(&space->inverse, &scale);
    qtri_wide_from_vec3(space->origin, &origin);
    for (int i = 0; i < 3; i++) {
        qtri_wide_div_by(&space->origin[i], &unit);
        space->origin[i].m = -space->origin[i].m;
        space->offset[i] = qtri_row_element(&object_to_eye->row[i], 3);
        space->offset[i].m = -space->offset[i].m;
        for (int row = 0; row < 3; row++) {
            space->column[i][row] = qtri_row_element(&object_to_eye->row[row], i);
        }
    }
    space->unit.m = (int64_t)qtri_magnitude64(space->unit.m); /* of an extent below 0, too */
}

/*
 * Rows from 16-bit positions to places, |m n + t| < 2^29 2^16 for |n| <= 2^15: with a, the sum of
 * |m| 2^15 and |t| in eye space, a 2^(62 - e) <= 2^28 in local units.
 */
static void set_compact_rows(qtri_illumination *by, qtri_light_space *space,
                             const qtri_transform *object_to_eye, const qtri_mesh *mesh)
{
    qtri_wide origin[3];
    qtri_wide_from_vec3(origin, &mesh->origin);
    const qtri_wide step = qtri_wide_make(mesh->extent, 31);
    qtri_wide m[3][4];
    qtri_wide reach[3];
    for (int row = 0; row < 3; row++) {
        m[row][3] = qtri_row_element(&object_to_eye->row[row], 3);
        reach[row] = qtri_wide_make(0, 0);
        for (int i = 0; i < 3; i++) {
            m[row][i] = qtri_row_element(&object_to_eye->row[row], i);
            qtri_wide_add_product(&m[row][3], &m[row][i], &origin[i]);
            qtri_wide_mul_by(&m[row][i], &step);
            const qtri_wide size =
                qtri_wide_make((int64_t)qtri_magnitude64(m[row][i].m), m[row][i].e - 15);
            qtri_wide_add_to(&reach[row], &size);
        }
        const qtri_wide size = qtri_wide_make((int64_t)qtri_magnitude64(m[row][3].m), m[row][3].e);
        qtri_wide_add_to(&reach[row], &size);
    }
    const int32_t unit_exponent = qtri_hold32(28 - bits_of(reach), -EXPONENT_MAX, 256);
    space->unit = qtri_wide_make(1, unit_exponent);
    for (int row = 0; row < 3; row++) {
        int32_t fixed[3];
        for (int i = 0; i < 3; i++) { /* |m| <= 2^28 2^16 / 2^15 */
            const int32_t down = m[row][i].e - unit_exponent - 16;
            fixed[i] = (int32_t)(down > 62 || down < 31 ? 0 : qtri_shift_round(m[row][i].m, down)) &
                       ~(int32_t)3;
        }
        const int32_t down = m[row][3].e - unit_exponent - 16;
        const int64_t t = down > 62 || down < 16 ? 0 : qtri_shift_round(m[row][3].m, down);
        qtri_row16_set(&by->row.compact[row], fixed, t & ~(int64_t)3);
    }
}

/* Kinds in the order of their first source, each with all of its sources. */
static void set_sources(qtri_illumination *by, const qtri_light *lights,
                        const qtri_light_space *space)
{
    const uint32_t count = lights->count < QTRI_LIGHTS_MAX ? lights->count : QTRI_LIGHTS_MAX;
    bool done[QTRI_LIGHTS_MAX] = {false};
    qtri_source *out = by->source;
    by->count = 0;
    for (uint32_t i = 0; i < count; i++) {
        const qtri_light_kind *kind = lights->sources[i].kind;
        const qtri_source *first = out;
        for (uint32_t j = i; j < count && kind != NULL; j++) {
            if (!done[j] && lights->sources[j].kind == kind) {
                done[j] = true;
                out += kind->prepare(out, &lights->sources[j], space) ? 1 : 0;
            }
        }
        if (out != first) {
            by->run[by->count].kind = kind;
            by->run[by->count].end = out;
            by->count++;
        }
    }
}

static void set_material(qtri_illumination *by, const qtri_light *lights,
                         const qtri_reflection *reflection)
{
    static const qtri_reflection none;
    const qtri_reflection *r = reflection != NULL ? reflection : &none;
    const uint8_t reflects[3] = {r->ambient.r, r->ambient.g, r->ambient.b};
    const uint8_t emits[3] = {r->emission.r, r->emission.g, r->emission.b};
    uint32_t light_q12[3];
    qtri_light_color_q12(light_q12, &lights->color);
    for (int i = 0; i < 3; i++) { /* < 2^19 2^8 */
        const uint32_t own = r->own_ambient ? reflects[i] : 0;
        by->base_q15[i] = ((uint32_t)emits[i] << 15) + own * (light_q12[i] << 3) + 0x4000;
        by->ambient_q24[i] = r->own_ambient ? 0 : light_q12[i] << 12;
    }
    by->specular = r->specular;
    by->shininess = r->shininess;
    by->two_sided = r->two_sided;
}

/*
 * Which way along z the eye is: where w gets smaller, or the depth, if w is the same everywhere.
 * Projections in OpenGL's form look down -z, in Direct3D's along +z.
 */
static int32_t towards_eye(const qtri_transform *projection)
{
    const int32_t w = projection->row[3].m[2];
    return (w != 0 ? w : projection->row[2].m[2]) > 0 ? -1 : 1;
}

void qtri_illumination_init(qtri_illumination *by, const qtri_view *view,
                            const qtri_transform *pose, const qtri_reflection *reflection,
                            const qtri_mesh *compact)
{
    qtri_transform object_to_eye;
    qtri_light_space space;
    int32_t m[3][4];
    qtri_transform_mul(&object_to_eye, &view->camera, pose);
    const int32_t exponent = qtri_linear_align(m, &object_to_eye);
    space.camera = &view->camera;
    space.even = qtri_linear_is_even(m) && exponent >= -512 && exponent <= 512;
    qtri_wide eye[3] = {qtri_wide_make(0, 0), qtri_wide_make(0, 0),
                        qtri_wide_make(towards_eye(&view->projection), 0)};
    if (space.even) {
        set_even_space(&space, m, exponent, &object_to_eye, compact);
        turn_back(eye, &space);
    } else {
        qtri_linear_normals(by->normal_q28, &object_to_eye);
        space.unit = qtri_wide_make(1, UNEVEN_UNIT_LOG2);
        if (compact != NULL) {
            set_compact_rows(by, &space, &object_to_eye, compact);
        } else {
            for (int i = 0; i < 3; i++) {
                by->row.wide[i] = object_to_eye.row[i];
            }
        }
    }
    (void)unit_q14(by->view_q14, eye);
    space.view_q14 = by->view_q14;
    by->even = space.even;
    set_material(by, view->light, reflection);
    set_sources(by, view->light, &space);
}

/* ---- Points ---- */

/*
 * q = v . v becomes v' = q 4^up / 2^32 in [1/4, 1), and y is
 * v'^-1/2 in Q15 within 2^-13: v / |v| = v y 2^up / 2^31.
 */
void qtri_normalize_q14(int32_t out[3], const int32_t v[3], uint32_t square)
{
    const int32_t zeros = qtri_clz32(square) & ~1;
    const int32_t y_q14 = (int32_t)(qtri_rsqrt_seed((square << zeros) >> 16) >> 1);
    int32_t down = 16 - (zeros >> 1); /* 1..16 */
    for (int i = 0; i < 3; i++) {     /* |v| y <= 2^(30 - zeros / 2) */
        out[i] = (v[i] * y_q14) >> down;
    }
}

bool qtri_direction_q14(int32_t out[3], const int64_t v[3])
{
    int32_t scaled[3];
    (void)qtri_align32(scaled, v, 15);
    const uint32_t square = qtri_square_q28(scaled);
    if (square == 0) {
        out[0] = out[1] = out[2] = 0;
        return false;
    }
    qtri_normalize_q14(out, scaled, square);
    return true;
}

void qtri_uneven_normal_q14(int32_t out[3], const int32_t *m_q28, const int32_t v[3])
{
    int64_t turned[3]; /* < 3 2^15 2^29 */
    for (int row = 0; row < 3; row++) {
        const int32_t *m = m_q28 + 3 * row;
        turned[row] =
            qtri_mul_s32(m[0], v[0]) + qtri_mul_s32(m[1], v[1]) + qtri_mul_s32(m[2], v[2]);
    }
    (void)qtri_direction_q14(out, turned);
}

void qtri_face_normal(int32_t normal[3], const qtri_vec3 *a, const qtri_vec3 *b, const qtri_vec3 *c)
{
    int32_t e[3];
    int32_t f[3];
    int64_t cross[3];
    qtri_face_edge(e, a, b);
    qtri_face_edge(f, a, c);
    qtri_cross64(cross, e, f);
    (void)qtri_direction_q14(normal, cross);
}

/* Rows times a position fit 64 bits; local units are 2^-24. */
void qtri_illuminated_place_uneven(qtri_lit_point *point, const qtri_row row[3], const qtri_vec3 *p)
{
    int64_t sum[3];
    int32_t exponent = 0;
    for (int i = 0; i < 3; i++) {
        const int32_t *m = row[i].m;
        sum[i] = qtri_mul_s32(m[0], p->x) + qtri_mul_s32(m[1], p->y) + qtri_mul_s32(m[2], p->z) +
                 row[i].t;
        const int32_t bits = 64 - qtri_clz64(qtri_magnitude64(sum[i]) | 1u);
        exponent = qtri_greatest32(exponent, bits - row[i].exponent + 8 - 29);
    }
    for (int i = 0; i < 3; i++) {
        const int32_t down = row[i].exponent - 8 + exponent;
        point->place[i] = (int32_t)(down >= 0 ? sum[i] >> (down > 63 ? 63 : down)
                                              : qtri_shift_left64(sum[i], -down));
    }
    point->exponent = exponent;
}

/* ---- Shininess ---- */

#define ONE_Q31 0x80000000u

/*
 * x^shininess in Q15 for x <= 1. The whole part by squares: ten of them and ten products leave
 * 2^-25 of 1. The rest is an exponent below 1, which makes no error of x larger.
 */
static uint32_t power_q15(uint32_t x_q31, q16 shininess)
{
    uint32_t result = ONE_Q31;
    uint32_t square = x_q31;
    for (uint32_t whole = (uint32_t)shininess >> 16; whole != 0; whole >>= 1) {
        if ((whole & 1u) != 0) {
            result = qtri_mul_q31(result, square);
        }
        square = qtri_mul_q31(square, square);
    }
    const q16 rest = shininess & 0xFFFF;
    if (rest != 0) {
        const uint32_t x_q16 = (x_q31 + 0x4000u) >> 15;
        result = qtri_mul_q31(result, (uint32_t)q16_pow((q16)x_q16, rest) << 15);
    }
    return (result + 0x8000u) >> 16;
}

/*
 * Steps of t = 1 - n . h are a power of two, so that an index is a shift; the largest with which at
 * most 128 of them reach t = 6.93 / shininess, where the power is 2^-10. Between two values of a
 * convex function the line is above it, by an eighth of the second difference at most: half of that
 * is taken off everywhere.
 */
void qtri_shininess_init(qtri_shininess *table, q16 shininess)
{
    QTRI_ASSERT(table != NULL);
    enum { STEPS = 128, LEAST_LOG2 = 7, LEAST_Q15 = 32 };
    const q16 held = qtri_hold32(shininess, Q16_ONE, 1024 * Q16_ONE);
    uint32_t log2 = LEAST_LOG2;
    while ((uint32_t)held / 512 >= 7u << (log2 + 1)) { /* 2^16 / 2^9 = 128 */
        log2++;
    }
    const uint32_t step_q31 = ONE_Q31 >> log2;
    const uint32_t first = power_q15(ONE_Q31 - step_q31, held);
    const uint32_t second = power_q15(ONE_Q31 - 2 * step_q31, held);
    uint32_t at = ONE_Q31 >> 16;
    uint32_t before = 3 * (at - first) + second; /* so that it bends as at the next */
    uint32_t count = 0;
    for (; count < STEPS && at >= LEAST_Q15; count++) {
        const uint32_t after = power_q15(ONE_Q31 - (count + 1) * step_q31, held);
        const uint32_t bend = before + after + 1 - 2 * at; /* 0 or more: values are rounded */
        table->value_q15[count] = (uint16_t)(at - bend / 16);
        before = at;
        at = after;
    }
    table->value_q15[count] = (uint16_t)at;
    table->count = (uint8_t)count;
    const uint32_t least_q15 = (ONE_Q31 - count * step_q31) >> 16;
    table->least_q15 = (uint16_t)((least_q15 * least_q15) >> 15);
    table->shift = (uint8_t)(29 - log2);
}

/* ---- Sphere maps ---- */

/* The nearest of (1 + n) / 2 in Q14. */
static int16_t half_q14(int32_t n_q14)
{
    return (int16_t)((n_q14 + (1 << 14) + 1) >> 1);
}

void qtri_sphere_map(qtri_uv16 *uvs, const qtri_transform *camera, const qtri_transform *pose,
                     const qtri_mesh *mesh)
{
    QTRI_ASSERT(camera != NULL);
    QTRI_ASSERT(pose != NULL);
    QTRI_ASSERT(mesh != NULL);
    QTRI_ASSERT(uvs != NULL || mesh->vertex_count == 0);
    qtri_transform object_to_eye;
    int32_t m_q28[3][3];
    qtri_transform_mul(&object_to_eye, camera, pose);
    qtri_linear_normals(m_q28, &object_to_eye);
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        int32_t n[3] = {0, 0, 0};
        int32_t unit_q14[3];
        if (mesh->normals8 != NULL || mesh->normals != NULL) {
            qtri_lit_vertex_normal(n, mesh, i);
        }
        qtri_uneven_normal_q14(unit_q14, m_q28[0], n);
        uvs[i].x = half_q14(unit_q14[0]);
        uvs[i].y = half_q14(-unit_q14[1]);
    }
}
