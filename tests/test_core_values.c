/* SPDX-License-Identifier: MIT */
/*
 * What functions return for random arguments, and what paints, filters and passes over a frame make
 * of random pictures: checksums, as tests/pictures.tsv records them (`make pictures`). Other tests
 * say what is right; these see that nothing else changed.
 */
#include "support/core.h"

#include "support/recorded.h"

#include <qtri/dither.h>

enum { WIDTH = 47, HEIGHT = 37, GROUPS = 4, ROUNDS = 8000 };

static uint64_t seed;
static int32_t stress[STRESS_COUNT];
static int stress_count;

static int32_t below(int32_t count)
{
    return random_in(&seed, 0, count - 1);
}

static bool one_in(int32_t count)
{
    return below(count) == 0;
}

/* Of any size, of one that numbers usually have, or where something begins or ends. */
static q16 number(void)
{
    if (one_in(6)) {
        return stress[below(stress_count)];
    }
    return one_in(2) ? random_any(&seed) : random_in(&seed, -Q16(8), Q16(8));
}

static void numbers(q16 *out, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        out[i] = number();
    }
}

static qtri_rgb random_color(void)
{
    const uint32_t bits = (uint32_t)random_bits32(&seed);
    const qtri_rgb color = {(uint8_t)bits, (uint8_t)(bits >> 8), (uint8_t)(bits >> 16)};
    return color;
}

static uint32_t add(uint32_t hash, const int32_t *value, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        hash = recorded_add(hash, (uint32_t)value[i], 4);
    }
    return hash;
}

static void record(const char *name, int32_t rounds, uint32_t (*one)(uint32_t hash))
{
    for (int group = 0; group < GROUPS; group++) {
        char line[RECORDED_NAME_MAX];
        uint32_t hash = RECORDED_BEGIN;
        seed = recorded_seed(group);
        for (int32_t n = 0; n < rounds; n++) {
            hash = one(hash);
        }
        snprintf(line, sizeof line, "core %s %d", name, group);
        recorded_judge(line, hash);
    }
}

/* Functions ------------------------------------------------------------------------------------ */

static uint32_t add_scalars(uint32_t hash, const q16 a[3])
{
    const int bits = below(40);
    const q16 of_two[] = {
        q16_add(a[0], a[1]),   q16_sub(a[0], a[1]),        q16_lerp(a[0], a[1], a[2]),
        q16_mul(a[0], a[1]),   q16_mul_floor(a[0], a[1]),  q16_mul_wrap(a[0], a[1]),
        q16_div(a[0], a[1]),   q16_mod(a[0], a[1]),        q16_muldiv(a[0], a[1], a[2]),
        q16_hypot(a[0], a[1]), q16_from_ratio(a[0], a[1]), q16_from_fixed(a[0], bits),
        q16_atan2(a[0], a[1]), q16_atan2_deg(a[0], a[1]),  q16_to_fixed(a[0], bits),
        q16_pow(a[0], a[1]),   q16_mul_sat(a[0], a[1]),    q16_div_sat(a[0], a[1])};
    const q16 unit = random_in(&seed, -Q16(1.1), Q16(1.1));
    const q16 of_one[] = {
        q16_neg(a[0]),     q16_abs(a[0]),      q16_recip(a[0]),    q16_sqrt(a[0]),
        q16_rsqrt(a[0]),   q16_ceil(a[0]),     q16_round(a[0]),    q16_exp2(a[0]),
        q16_exp(a[0]),     q16_log2(a[0]),     q16_log(a[0]),      q16_sin(a[0]),
        q16_cos(a[0]),     q16_sin_deg(a[0]),  q16_cos_deg(a[0]),  q16_tan(a[0]),
        q16_tan_deg(a[0]), q16_atan(a[0]),     q16_atan_deg(a[0]), q16_asin(unit),
        q16_acos(unit),    q16_asin_deg(unit), q16_acos_deg(unit), q16_from_int(a[0])};
    hash = add(hash, of_two, LENGTH_OF(of_two));
    return add(hash, of_one, LENGTH_OF(of_one));
}

static uint32_t scalars(uint32_t hash)
{
    q16 a[3];
    numbers(a, 3);
    return add_scalars(hash, a);
}

/* One of them with all of them. */
static uint32_t ends(uint32_t hash)
{
    q16 a[3];
    a[0] = stress[below(stress_count)];
    a[2] = number();
    for (int i = 0; i < stress_count; i++) {
        a[1] = stress[i];
        hash = add_scalars(hash, a);
    }
    return hash;
}

static uint32_t vectors(uint32_t hash)
{
    q16 a[4], b[4], out[4];
    numbers(a, 4);
    numbers(b, 4);
    for (int32_t count = 2; count <= 4; count++) {
        const int32_t keep = below(2);
        const int32_t times = below(4) - 1;
        const q16 some[] = {qtri_vec_distance(a, b, count), qtri_vec_angle_deg(a, b, count)};
        hash = add(hash, some, 2);
        qtri_vec_normalize(out, a, count);
        hash = add(hash, out, count);
        qtri_vec_along(out, a, b, count, keep, times);
        hash = add(hash, out, count);
    }
    const qtri_vec3 u = {a[0], a[1], a[2]};
    const qtri_vec3 v = {b[0], b[1], b[2]};
    const qtri_vec2 u2 = {a[0], a[1]};
    const qtri_vec2 v2 = {b[0], b[1]};
    const qtri_vec3 cross = qtri_vec3_cross(u, v);
    const q16 more[] = {qtri_vec3_dot(u, v),
                        qtri_vec2_cross(u2, v2),
                        qtri_vec2_dot(u2, v2),
                        cross.x,
                        cross.y,
                        cross.z};
    return add(hash, more, LENGTH_OF(more));
}

/* Elements of one size, so that determinants are neither 0 nor saturate. */
static void elements(q16 *out, int32_t count)
{
    const int32_t shift = below(24);
    for (int32_t i = 0; i < count; i++) {
        out[i] = random_bits32(&seed) >> shift;
    }
    if (one_in(4)) {
        const int32_t zero = below(count);
        const int32_t other = below(count); /* a statement each: the same order with any compiler */
        out[zero] = 0;
        out[other] = number();
    }
}

static uint32_t matrices(uint32_t hash)
{
    static const qtri_euler orders[] = {QTRI_EULER_XYZ, QTRI_EULER_XZY, QTRI_EULER_YXZ,
                                        QTRI_EULER_YZX, QTRI_EULER_ZXY, QTRI_EULER_ZYX};
    qtri_mat3 a, b;
    qtri_mat4 c, d;
    q16 v[4];
    elements(&a.m[0][0], 9);
    elements(&b.m[0][0], 9);
    elements(&c.m[0][0], 16);
    elements(&d.m[0][0], 16);
    numbers(v, 4);
    const qtri_vec3 axis = {v[0], v[1], v[2]};
    const qtri_vec3 point = {v[3], v[1], v[0]};
    const qtri_vec4 plane = {v[0], v[1], v[2], v[3]};
    qtri_mat3 m3 = qtri_mat3_mul(&a, &b);
    hash = add(hash, &m3.m[0][0], 9);
    (void)qtri_mat3_inverse(&m3, &a);
    hash = add(hash, &m3.m[0][0], 9);
    const q16 determinants[] = {qtri_mat3_determinant(&a), qtri_mat4_determinant(&c)};
    hash = add(hash, determinants, 2);
    qtri_mat4 m4 = qtri_mat4_mul(&c, &d);
    hash = add(hash, &m4.m[0][0], 16);
    (void)qtri_mat4_inverse(&m4, &c);
    hash = add(hash, &m4.m[0][0], 16);
    m4 = qtri_mat4_reflect(plane);
    hash = add(hash, &m4.m[0][0], 16);
    m4 = qtri_mat4_rotate_axis_deg(axis, v[3]);
    hash = add(hash, &m4.m[0][0], 16);
    m4 = qtri_mat4_rotate_about_deg(axis, v[3], point);
    hash = add(hash, &m4.m[0][0], 16);
    m4 = qtri_mat4_rotate_euler_deg(axis, orders[below(6)]);
    return add(hash, &m4.m[0][0], 16);
}

static qtri_quat random_quat(void)
{
    q16 v[4];
    const int32_t reach = one_in(3) ? INT32_MAX : Q16(1.2);
    for (int i = 0; i < 4; i++) {
        v[i] = random_in(&seed, -reach, reach);
    }
    const qtri_quat a = {v[0], v[1], v[2], v[3]};
    return one_in(2) ? qtri_quat_normalize(a) : a;
}

static uint32_t add_quat(uint32_t hash, qtri_quat a)
{
    const q16 v[] = {a.w, a.x, a.y, a.z};
    return add(hash, v, 4);
}

static uint32_t quaternions(uint32_t hash)
{
    const qtri_quat a = random_quat();
    const qtri_quat b = random_quat();
    q16 n[4];
    numbers(n, 4);
    const qtri_vec3 v = {n[0], n[1], n[2]};
    const q16 t = random_in(&seed, -Q16(.2), Q16(1.2));
    qtri_attitude attitude = qtri_attitude_from_quat(a);
    hash = add_quat(hash, qtri_quat_mul(a, b));
    hash = add_quat(hash, qtri_quat_inverse(a));
    hash = add_quat(hash, qtri_quat_normalize(a));
    hash = add_quat(hash, qtri_quat_nlerp(a, b, t));
    hash = add_quat(hash, qtri_quat_slerp(a, b, t));
    hash = add_quat(hash, qtri_quat_integrate_deg(a, v, t));
    hash = add_quat(hash, qtri_quat_from_axis_deg(v, n[3]));
    hash = add_quat(hash, qtri_quat_from_euler_deg(v, QTRI_EULER_YXZ));
    const qtri_mat3 m = qtri_quat_to_mat3(a);
    hash = add(hash, &m.m[0][0], 9);
    hash = add_quat(hash, qtri_quat_from_mat3(&m));
    const qtri_vec3 turned = qtri_quat_rotate(a, v);
    const q16 more[] = {turned.x, turned.y, turned.z, qtri_quat_dot(a, b)};
    hash = add(hash, more, 4);
    qtri_attitude_integrate_deg(&attitude, v, t);
    return add(hash, attitude.q_q30, 4);
}

static qtri_vec3 random_vec(void)
{
    q16 n[3];
    numbers(n, 3);
    const qtri_vec3 v = {n[0], n[1], n[2]};
    return v;
}

static uint32_t add_transform(uint32_t hash, const qtri_transform *t)
{
    for (int i = 0; i < 4; i++) {
        const qtri_row *row = &t->row[i];
        hash = add(hash, row->m, 3);
        hash = add(hash, &row->exponent, 1);
        hash = recorded_add(hash, (uint32_t)((uint64_t)row->t >> 32), 4);
        hash = recorded_add(hash, (uint32_t)row->t, 4);
    }
    return hash;
}

static uint32_t transforms(uint32_t hash)
{
    qtri_transform t, camera;
    qtri_mat4 m;
    const qtri_vec3 a = random_vec();
    const qtri_vec3 b = random_vec();
    const qtri_vec3 c = random_vec();
    const qtri_vec3 triangle[3] = {a, b, c};
    const q16 degrees = number();
    const q16 near_z = random_in(&seed, 100, Q16(2));
    const q16 far_z = random_in(&seed, Q16(1), Q16(900));
    qtri_transform_identity(&t);
    qtri_transform_identity(&camera);
    qtri_transform_look_at(&camera, a, b, c);
    switch (below(12)) {
    case 0:
        qtri_transform_perspective(&t, random_in(&seed, 1, Q16(179)), Q16(1.3), near_z, far_z);
        break;
    case 1:
        qtri_transform_frustum(&t, a.x, b.x, a.y, b.y, near_z, far_z);
        break;
    case 2:
        qtri_transform_ortho(&t, a.x, b.x, a.y, b.y, near_z, far_z);
        break;
    case 3:
        qtri_transform_perspective_d3d(&t, random_in(&seed, 1, Q16(179)), Q16(1.3), near_z, far_z);
        break;
    case 4:
        qtri_transform_look_at_d3d(&t, a, b, c);
        break;
    case 5:
        qtri_transform_rotate_triangle(&t, degrees, triangle);
        break;
    case 6:
        qtri_transform_rotate_about(&t, degrees, a, b);
        break;
    case 7:
        qtri_transform_orbit(&t, a, far_z, degrees, b.x);
        break;
    case 8:
        qtri_transform_translate(&t, b);
        qtri_transform_billboard(&t, &camera);
        break;
    case 9:
        qtri_transform_translate(&t, b);
        qtri_transform_billboard_upright(&t, &camera);
        break;
    case 10:
        qtri_transform_rotate_quat(&t, random_quat());
        qtri_transform_orthonormalize(&t);
        break;
    default:
        elements(&m.m[0][0], 16);
        qtri_transform_from_mat4(&t, &m);
        break;
    }
    qtri_transform_scale(&t, c);
    qtri_transform_rotate(&t, degrees, a);
    hash = add_transform(hash, &t);
    qtri_transform_mul(&t, &camera, &t);
    hash = add_transform(hash, &t);
    qtri_transform_to_mat4(&t, &m);
    return add(hash, &m.m[0][0], 16);
}

static uint32_t tables(uint32_t hash)
{
    qtri_shininess table;
    char text[32];
    q16 back = 0;
    const q16 a = number();
    qtri_shininess_init(&table, a);
    hash = recorded_add(hash, table.least_q15, 2);
    for (int i = 0; i < table.count && i < (int)LENGTH_OF(table.value_q15); i++) {
        hash = recorded_add(hash, table.value_q15[i], 2);
    }
    const int32_t length = q16_to_string(a, text, sizeof text);
    for (int32_t i = 0; i < length; i++) {
        hash = recorded_add(hash, (uint32_t)(unsigned char)text[i], 1);
    }
    (void)q16_from_string(text, &back);
    assert_int_equal(back, a);
    return hash;
}

static uint32_t keys(uint32_t hash)
{
    qtri_key key[3];
    qtri_transform t;
    q16 time = 0;
    for (int i = 0; i < 3; i++) {
        key[i].time = time;
        key[i].position = random_vec();
        key[i].orientation = random_quat();
        key[i].scale = random_vec();
        time += 1 + below(Q16(3));
    }
    const q16 at = random_in(&seed, -Q16(1), time);
    const qtri_key now = qtri_keys_at(key, 3, at);
    qtri_transform_identity(&t);
    qtri_transform_key(&t, &now);
    return add_transform(hash, &t);
}

static uint32_t morphs(uint32_t hash)
{
    enum { COUNT = 7 };
    qtri_position16 p[3][COUNT], out[COUNT];
    qtri_normal8 n[2][COUNT], turned[COUNT];
    q16 weight[2];
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < COUNT; i++) {
            p[k][i].x = (int16_t)(random_bits32(&seed) >> 16);
            p[k][i].y = (int16_t)(random_bits32(&seed) >> 16);
            p[k][i].z = (int16_t)(random_bits32(&seed) >> 16);
        }
    }
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < COUNT; i++) {
            n[k][i].x = (int8_t)(below(255) - 127);
            n[k][i].y = (int8_t)(below(255) - 127);
            n[k][i].z = (int8_t)(below(255) - 127);
        }
        weight[k] = random_in(&seed, -Q16(1), Q16(2));
    }
    const q16 t = random_in(&seed, -Q16(.1), Q16(1.1));
    const qtri_position16 *const target[2] = {p[1], p[2]};
    const int32_t kind = below(3);
    if (kind == 0) {
        qtri_morph_positions(out, p[0], p[1], COUNT, t);
    } else if (kind == 1) {
        qtri_morph_targets(out, p[0], target, weight, 2, COUNT);
    } else {
        qtri_frames_positions(out, p[0], 3, COUNT, random_in(&seed, -Q16(1), Q16(4)));
    }
    qtri_morph_normals(turned, n[0], n[1], COUNT, t);
    for (int i = 0; i < COUNT; i++) {
        const int32_t all[] = {out[i].x, out[i].y, out[i].z, turned[i].x, turned[i].y, turned[i].z};
        hash = add(hash, all, 6);
    }
    return hash;
}

/* Pictures ------------------------------------------------------------------------------------- */

static uint32_t add_surface(uint32_t hash, const qtri_surface *s)
{
    for (int32_t y = s->first_row; y < s->first_row + s->rows; y++) {
        for (int32_t x = 0; x < s->width; x++) {
            hash = recorded_add(hash, stored_pixel(s, x, y), s->format->pixels->bytes);
        }
    }
    return hash;
}

/* Mostly like what is beside it, by steps of any size: thresholds of filters lie in between. */
static void fill_with_steps(const qtri_surface *s)
{
    const int32_t step = 1 + below(60);
    const qtri_rgb base = random_color();
    qtri_area area;
    qtri_surface_clear(s, base);
    for (int n = 0; n < 40; n++) {
        qtri_rgb color = base;
        color.r = (uint8_t)(color.r + below(step));
        color.g = (uint8_t)(color.g + below(step));
        color.b = (uint8_t)(color.b + below(step));
        area.x0_24p8 = below(s->width) * 256;
        area.y0_24p8 = below(s->height) * 256;
        area.x1_24p8 = area.x0_24p8 + (1 + below(9)) * 256;
        area.y1_24p8 = area.y0_24p8 + (1 + below(5)) * 256;
        const qtri_brush brush = qtri_brush_of(color);
        qtri_paint_rect(s, &area, &brush);
    }
}

static uint32_t filters(uint32_t hash)
{
    static uint32_t memory[2 * WIDTH * HEIGHT];
    const qtri_format *format = one_in(2) ? &qtri_rgb565 : drawn_format(below(7));
    const bool is_565 = format == &qtri_rgb565;
    const int32_t width = 2 + 2 * below(WIDTH / 2);
    const int32_t height = 2 + 2 * below(HEIGHT / 2);
    canvas c = canvas_new(format, width, height);
    qtri_surface half;
    fill_with_steps(&c.surface);
    if (one_in(3)) {
        c.surface.scissor.x0 = below(width);
        c.surface.scissor.y1 = below(height + 1);
    }
    qtri_sum_clear(memory, LENGTH_OF(memory));
    const int32_t frames_log2 = below(4);
    for (int i = 0; i < 1 << frames_log2; i++) {
        (void)qtri_sum_add(memory, LENGTH_OF(memory), &c.surface);
        if (one_in(2)) {
            (void)(is_565 &&
                   one_in(2)); /* keeps the random numbers that pictures were recorded by */
            (void)qtri_fxaa(&c.surface, memory + WIDTH * HEIGHT, 999);
            hash = add_surface(hash, &c.surface);
        }
    }
    (void)qtri_sum_store(&c.surface, memory, LENGTH_OF(memory), frames_log2);
    hash = add_surface(hash, &c.surface);
    (void)(is_565 && one_in(2));
    assert_ok(qtri_halve(&c.surface, &half));
    hash = add_surface(hash, &c.surface);
    canvas_free(&c);
    return hash;
}

static int32_t place(int32_t size)
{
    return random_in(&seed, -size * 100, size * 350) & (one_in(3) ? ~255 : ~0);
}

static void paint_image(const qtri_surface *s)
{
    canvas c = canvas_new(one_in(2) ? s->format : drawn_format(below(7)), 16, 11);
    fill_with_steps(&c.surface);
    qtri_image image = qtri_image_of(&c.surface);
    qtri_affine affine;
    image.has_key = one_in(2);
    image.key = stored_pixel(&c.surface, 0, 0);
    const int32_t x = below(WIDTH) - 10;
    const int32_t y = below(HEIGHT) - 10;
    const uint8_t alpha = (uint8_t)(one_in(2) ? 255 : below(256));
    const q16 size_x = random_in(&seed, -Q16(3), Q16(3));
    const q16 size_y = random_in(&seed, -Q16(3), Q16(3));
    const q16 degrees = one_in(3) ? Q16(90) * below(5) : number();
    switch (below(3)) {
    case 0:
        qtri_image_paint(s, &image, x, y);
        break;
    case 1:
        qtri_image_blend(s, &image, x, y, alpha);
        break;
    default:
        qtri_affine_place(&affine, Q16(8), Q16(5), q16_from_int(x), q16_from_int(y), size_x, size_y,
                          degrees);
        qtri_image_paint_affine(s, &image, &affine, alpha);
        break;
    }
    canvas_free(&c);
}

static void paint_shape(const qtri_surface *s, const qtri_brush *brush)
{
    qtri_point point[5];
    qtri_area area;
    for (int i = 0; i < 5; i++) {
        point[i].x_24p8 = place(WIDTH);
        point[i].y_24p8 = place(HEIGHT);
    }
    area.x0_24p8 = point[0].x_24p8;
    area.y0_24p8 = point[0].y_24p8;
    area.x1_24p8 = point[1].x_24p8;
    area.y1_24p8 = point[1].y_24p8;
    const int32_t radius = below(20 * 256);
    const int32_t width = below(8 * 256);
    const q16 from = number();
    const q16 sweep = random_in(&seed, -Q16(400), Q16(400));
    switch (below(10)) {
    case 0:
        qtri_paint_rect(s, &area, brush);
        break;
    case 1:
        qtri_paint_rect_outline(s, &area, width, brush);
        break;
    case 2:
        qtri_paint_round_rect(s, &area, radius, brush);
        break;
    case 3:
        qtri_paint_round_rect_outline(s, &area, radius, width, brush);
        break;
    case 4:
        qtri_paint_circle(s, point, radius, brush);
        break;
    case 5:
        qtri_paint_ring(s, point, radius, width, brush);
        break;
    case 6:
        qtri_paint_arc(s, point, radius, width, from, sweep, brush);
        break;
    case 7:
        qtri_paint_polygon(s, point, 2 + below(4), brush);
        break;
    case 8:
        qtri_paint_stroke(s, point, point + 1, width, brush);
        break;
    default:
        (void)qtri_text_paint(s, &qtri_font_small, area.x0_24p8 >> 8, area.y0_24p8 >> 8,
                              "Wq7 #|~@\n\303\251!", brush);
        break;
    }
}

static uint32_t paints(uint32_t hash)
{
    static const qtri_ink *const inks[] = {NULL, &qtri_ink_blend, &qtri_ink_smooth};
    canvas c = canvas_new(one_in(2) ? &qtri_rgb565 : drawn_format(below(7)), WIDTH, HEIGHT);
    fill_with_steps(&c.surface);
    if (one_in(3)) {
        c.surface.scissor.x0 = below(WIDTH);
        c.surface.scissor.y1 = below(HEIGHT + 1);
    }
    for (int n = 0; n < 4; n++) {
        qtri_brush brush = qtri_brush_of(random_color());
        brush.alpha = (uint8_t)(one_in(2) ? 255 : below(256));
        brush.ink = inks[below(3)];
        if (one_in(4)) {
            paint_image(&c.surface);
        } else {
            paint_shape(&c.surface, &brush);
        }
    }
    hash = add_surface(hash, &c.surface);
    canvas_free(&c);
    return hash;
}

/* Points of up to 32 pixels, and some that are larger. */
static uint32_t points(uint32_t hash)
{
    canvas c = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    const qtri_material material = plain_material();
    qtri_stroke stroke = qtri_stroke_default();
    const int32_t y = below(HEIGHT * 256), x = below(WIDTH * 256);
    const qtri_screen_vertex v = screen_at(x, y);
    stroke.width = 512 * (1 + below(one_in(2) ? 33 * 128 : 6 * 128));
    stroke.cap = one_in(4) ? QTRI_CAP_SQUARE : QTRI_CAP_ROUND;
    stroke.edges = one_in(4) ? NULL : &qtri_stroke_smooth;
    stroke.alpha = (uint8_t)(one_in(2) ? 255 : below(256));
    canvas_clear(&c);
    qtri_raster_polyline(&c.surface, &material, &stroke, &v, 1);
    hash = add_surface(hash, &c.surface);
    canvas_free(&c);
    return hash;
}

static uint32_t grays(uint32_t hash)
{
    uint8_t gray[WIDTH], level[WIDTH];
    int16_t error[WIDTH + 2];
    qtri_diffusion diffusion;
    const uint8_t max_level = (uint8_t)(1 + below(255));
    const qtri_dither dither = (qtri_dither)below(3);
    assert_ok(qtri_diffusion_init(&diffusion, WIDTH, error, LENGTH_OF(error)));
    for (int32_t y = 0; y < 6; y++) {
        for (int32_t x = 0; x < WIDTH; x++) {
            gray[x] = (uint8_t)below(256);
        }
        qtri_dither_row(dither, max_level, y, y, gray, WIDTH - y, level);
        for (int32_t x = 0; x < WIDTH - y; x++) {
            hash = recorded_add(hash, level[x], 1);
        }
        qtri_diffuse_row(&diffusion, max_level, 0, y, gray, WIDTH, level);
        for (int32_t x = 0; x < WIDTH; x++) {
            hash = recorded_add(hash, level[x], 1);
        }
    }
    return hash;
}

TEST(functions)
{
    record("scalars", ROUNDS, scalars);
    record("ends of scalars", ROUNDS / 50, ends);
    record("vectors", ROUNDS, vectors);
    record("matrices", ROUNDS / 2, matrices);
    record("quaternions", ROUNDS, quaternions);
    record("transforms", ROUNDS, transforms);
    record("tables", ROUNDS / 10, tables);
    record("keys", ROUNDS, keys);
    record("morphs", ROUNDS, morphs);
}

TEST(pictures)
{
    record("filters", 300, filters);
    record("paints", 800, paints);
    record("grays", 200, grays);
    record("points", 300, points);
}

int main(void)
{
    stress_count = stress_values(stress);
    return run_all_tests(NULL, NULL);
}
