/* SPDX-License-Identifier: MIT */
#include "illumination.h"

#include "linear_part.h"
#include "row.h"

/* A place below 2^29 has 2 bits to spare for the difference of two. */
enum { PLACE_BITS = 29, EXPONENT_MAX = 128, UNEVEN_UNIT_LOG2 = 24 };

static qtri_wide fraction_of(q16 x)
{
    return qtri_wide_make(x, 16);
}

/* A vector of the world in eye space; with `place`, a point. */
static void to_eye(qtri_wide eye[3], const qtri_transform *camera, const qtri_vec3 *v, bool place)
{
    const qtri_wide world[3] = {fraction_of(v->x), fraction_of(v->y), fraction_of(v->z)};
    for (int row = 0; row < 3; row++) {
        eye[row] = qtri_wide_make(0, 0);
        for (int i = 0; i < 3; i++) {
            const qtri_wide element = qtri_row_element(&camera->row[row], i);
            qtri_wide_add_product(&eye[row], &element, &world[i]);
        }
        if (place) {
            const qtri_wide element = qtri_row_element(&camera->row[row], 3);
            qtri_wide_add_to(&eye[row], &element);
        }
    }
}

/* Times the transpose of the linear part, which turns it as the inverse does. */
static void turn_back(qtri_wide v[3], const qtri_light_space *space)
{
    const qtri_wide eye[3] = {v[0], v[1], v[2]};
    for (int i = 0; i < 3; i++) {
        v[i] = qtri_wide_make(0, 0);
        for (int row = 0; row < 3; row++) {
            qtri_wide_add_product(&v[i], &space->column[i][row], &eye[row]);
        }
    }
}

/* The greatest of |v| is below 2^bits. */
static int32_t bits_of(const qtri_wide v[3])
{
    int32_t bits = -4 * QTRI_WIDE_EXPONENT_MAX;
    for (int i = 0; i < 3; i++) {
        if (v[i].m != 0) {
            bits = qtri_greatest32(bits, 62 - v[i].e);
        }
    }
    return bits;
}

static int32_t shifted(const qtri_wide *x, int32_t exponent)
{
    const int32_t down = x->e + exponent;
    return (int32_t)(down > 62 ? 0 : qtri_shift_round(x->m, down));
}

static bool unit_q14(int32_t out[3], const qtri_wide v[3])
{
    const int32_t exponent = bits_of(v) - PLACE_BITS;
    const int64_t fixed[3] = {shifted(&v[0], exponent), shifted(&v[1], exponent),
                              shifted(&v[2], exponent)};
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
            local[i] = qtri_wide_sub(local[i], space->offset[i]);
        }
        turn_back(local, space);
        for (int i = 0; i < 3; i++) {
            qtri_wide_mul_by(&local[i], &space->inverse);
            local[i] = qtri_wide_sub(local[i], space->origin[i]);
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
    q16 origin[3] = {0, 0, 0};
    if (compact != NULL) { /* extent / 32768 / 256 */
        unit = qtri_wide_make(compact->extent, 39);
        origin[0] = compact->origin.x;
        origin[1] = compact->origin.y;
        origin[2] = compact->origin.z;
    }
    const qtri_wide square = qtri_wide_make(qtri_linear_dot(m, 0, 0), 2 * exponent);
    space->inverse = qtri_wide_div(qtri_wide_make(1, 0), qtri_wide_mul(square, unit));
    space->unit = qtri_wide_mul(qtri_wide_sqrt(square), unit);
    for (int i = 0; i < 3; i++) {
        space->origin[i] = qtri_wide_div(fraction_of(origin[i]), unit);
        space->offset[i] = qtri_row_element(&object_to_eye->row[i], 3);
        for (int row = 0; row < 3; row++) {
            space->column[i][row] = qtri_row_element(&object_to_eye->row[row], i);
        }
    }
    if (space->unit.m < 0) { /* of an extent below 0: distances are not */
        space->unit = qtri_wide_neg(space->unit);
    }
}

/*
 * Rows from 16-bit positions to places, |m n + t| < 2^29 2^16 for |n| <= 2^15: with a, the sum of
 * |m| 2^15 and |t| in eye space, a 2^(62 - e) <= 2^28 in local units.
 */
static void set_compact_rows(qtri_illumination *by, qtri_light_space *space,
                             const qtri_transform *object_to_eye, const qtri_mesh *mesh)
{
    const qtri_wide origin[3] = {fraction_of(mesh->origin.x), fraction_of(mesh->origin.y),
                                 fraction_of(mesh->origin.z)};
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
static void set_sources(qtri_illumination *by, const qtri_lights *lights,
                        const qtri_light_space *space)
{
    const uint32_t count = lights->count < QTRI_LIGHTS_MAX ? lights->count : QTRI_LIGHTS_MAX;
    bool done[QTRI_LIGHTS_MAX] = {false};
    qtri_shine *out = by->shine;
    by->count = 0;
    for (uint32_t i = 0; i < count; i++) {
        const qtri_light_kind *kind = lights->sources[i].kind;
        const qtri_shine *first = out;
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

static void set_material(qtri_illumination *by, const qtri_lights *lights,
                         const qtri_reflection *reflection)
{
    static const qtri_rgb black = {0, 0, 0};
    const bool own = reflection != NULL && reflection->own_ambient;
    const qtri_rgb ambient = own ? reflection->ambient : black;
    const qtri_rgb emission = reflection != NULL ? reflection->emission : black;
    const uint8_t reflects[3] = {ambient.r, ambient.g, ambient.b};
    const uint8_t emits[3] = {emission.r, emission.g, emission.b};
    uint32_t light_q12[3];
    qtri_light_color_q12(light_q12, &lights->ambient);
    for (int i = 0; i < 3; i++) { /* < 2^19 2^8 */
        by->base_q15[i] = ((uint32_t)emits[i] << 15) + reflects[i] * (light_q12[i] << 3) + 0x4000;
        by->ambient_q24[i] = own ? 0 : light_q12[i] << 12;
    }
    by->specular = reflection != NULL ? reflection->specular : black;
    by->shininess = reflection != NULL ? reflection->shininess : NULL;
    by->two_sided = reflection != NULL && reflection->two_sided;
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
    (void)unit_q14(space.view_q14, eye);
    by->even = space.even;
    by->compact = compact != NULL;
    for (int i = 0; i < 3; i++) {
        by->view_q14[i] = space.view_q14[i];
    }
    set_material(by, view->lights, reflection);
    set_sources(by, view->lights, &space);
}
