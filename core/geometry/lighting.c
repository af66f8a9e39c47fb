#include "lighting.h"

#include "../math/bits.h"
#include "../math/wide.h"
#include "row.h"

static qtri_wide dot(const qtri_wide a[3], const qtri_wide b[3])
{
    return qtri_wide_add(qtri_wide_add(qtri_wide_mul(a[0], b[0]), qtri_wide_mul(a[1], b[1])),
                         qtri_wide_mul(a[2], b[2]));
}

/* |a| <= |b| 2^-20: far above the noise of a rotation in Q2.30, far below 1/255. */
static bool negligible(qtri_wide a, qtri_wide b)
{
    return a.m == 0 || a.e >= b.e + 20;
}

/* Columns of equal length, at right angles. */
static bool is_even(qtri_wide column[3][3])
{
    qtri_wide square = dot(column[0], column[0]);
    if (square.m == 0) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        const qtri_wide *next = column[(i + 1) % 3];
        if (!negligible(dot(column[i], next), square) ||
            !negligible(qtri_wide_sub(dot(next, next), square), square)) {
            return false;
        }
    }
    return true;
}

static void unit_q30(int32_t out[3], const qtri_wide unit[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = (int32_t)qtri_shift_round(unit[i].m, unit[i].e - 30);
    }
}

/* Cofactors times the sign of the determinant: the inverse transpose without its division. */
static void normal_matrix(int32_t out_q28[3][3], qtri_wide column[3][3])
{
    qtri_wide cofactor[3][3]; /* columns */
    int32_t least = INT32_MAX;
    for (int i = 0; i < 3; i++) {
        qtri_wide_cross(cofactor[i], column[(i + 1) % 3], column[(i + 2) % 3]);
        for (int row = 0; row < 3; row++) {
            if (cofactor[i][row].m != 0 && cofactor[i][row].e < least) {
                least = cofactor[i][row].e;
            }
        }
    }
    bool mirrored = dot(column[0], cofactor[0]).m < 0;
    for (int i = 0; i < 3; i++) {
        for (int row = 0; row < 3; row++) {
            qtri_wide c = cofactor[i][row];
            int32_t size = (int32_t)qtri_shift_round(c.m, c.m == 0 ? 0 : c.e - least + 34);
            out_q28[row][i] = mirrored ? -size : size;
        }
    }
}

void qtri_lighting_init(qtri_lighting *lighting, const qtri_light *light,
                        const qtri_transform *object_to_eye)
{
    qtri_wide column[3][3];
    for (int i = 0; i < 3; i++) {
        for (int row = 0; row < 3; row++) {
            column[i][row] = qtri_row_element(&object_to_eye->row[row], i);
        }
    }
    qtri_wide towards[3] = {qtri_wide_q16(light->towards.x), qtri_wide_q16(light->towards.y),
                            qtri_wide_q16(light->towards.z)};
    lighting->ambient = light->ambient;
    lighting->diffuse = light->diffuse;
    lighting->even = is_even(column);
    if (lighting->even) {
        qtri_wide object[3] = {dot(column[0], towards), dot(column[1], towards),
                               dot(column[2], towards)};
        (void)qtri_wide_normalize(object); /* stays zero for no direction */
        unit_q30(lighting->towards_q30, object);
    } else {
        (void)qtri_wide_normalize(towards);
        unit_q30(lighting->towards_q30, towards);
        normal_matrix(lighting->normal_q28, column);
    }
}

/* Scales v so that its largest component lies in [2^28, 2^29). False for the zero vector. */
static bool normalize_scale(int32_t out[3], const int64_t v[3])
{
    uint64_t all = qtri_magnitude64(v[0]) | qtri_magnitude64(v[1]) | qtri_magnitude64(v[2]);
    if (all == 0) {
        return false;
    }
    int32_t zeros = qtri_clz64(all); /* to become 35 */
    for (int i = 0; i < 3; i++) {
        out[i] = zeros >= 35 ? (int32_t)(v[i] * ((int64_t)1 << (zeros - 35)))
                             : (int32_t)(v[i] >> (35 - zeros));
    }
    return true;
}

static int64_t dot_q30(const int32_t v[3], const int32_t unit_q30[3])
{
    return (int64_t)v[0] * unit_q30[0] + (int64_t)v[1] * unit_q30[1] + (int64_t)v[2] * unit_q30[2];
}

static q16 intensity(const qtri_lighting *lighting, int64_t cosine_q16)
{
    q16 cosine = cosine_q16 > 0 ? qtri_saturate32(cosine_q16) : 0;
    q16 sum = q16_add(lighting->ambient, q16_mul(lighting->diffuse, cosine));
    return q16_clamp(sum, 0, Q16_ONE);
}

/* For a normal of any length below 2^30. */
static q16 light_direction(const qtri_lighting *lighting, const int32_t normal[3])
{
    int64_t v[3] = {normal[0], normal[1], normal[2]};
    if (!lighting->even) {
        for (int i = 0; i < 3; i++) {
            v[i] = dot_q30(normal, lighting->normal_q28[i]); /* < 3 2^58 */
        }
    }
    int32_t scaled[3];
    if (!normalize_scale(scaled, v)) {
        return intensity(lighting, 0);
    }
    /* (v . l) 2^16 / |v|: |v| >= 2^28, v . l < 2^29.8 2^30 */
    uint64_t square = 0;
    for (int i = 0; i < 3; i++) {
        square += (uint64_t)((int64_t)scaled[i] * scaled[i]); /* < 2^58 each */
    }
    int64_t length = (int64_t)qtri_sqrt64_round(square);
    return intensity(lighting, (dot_q30(scaled, lighting->towards_q30) / length) >> 14);
}

q16 qtri_lighting_vertex(const qtri_lighting *lighting, const qtri_normal *normal)
{
    int32_t n[3] = {normal->x, normal->y, normal->z};
    if (!lighting->even) {
        return light_direction(lighting, n);
    }
    return intensity(lighting, qtri_shift_round(dot_q30(n, lighting->towards_q30), 28));
}

q16 qtri_lighting_face(const qtri_lighting *lighting, const qtri_vec3 *a, const qtri_vec3 *b,
                       const qtri_vec3 *c)
{
    /* Scaled edges keep the direction of small faces and hold the products below 2^58. */
    int64_t e_exact[3] = {(int64_t)b->x - a->x, (int64_t)b->y - a->y, (int64_t)b->z - a->z};
    int64_t f_exact[3] = {(int64_t)c->x - a->x, (int64_t)c->y - a->y, (int64_t)c->z - a->z};
    int32_t e_scaled[3];
    int32_t f_scaled[3];
    if (!normalize_scale(e_scaled, e_exact) || !normalize_scale(f_scaled, f_exact)) {
        return intensity(lighting, 0);
    }
    int64_t e[3] = {e_scaled[0], e_scaled[1], e_scaled[2]};
    int64_t f[3] = {f_scaled[0], f_scaled[1], f_scaled[2]};
    int64_t cross[3] = {e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2],
                        e[0] * f[1] - e[1] * f[0]}; /* <= 2^59 */
    int32_t normal[3];
    if (!normalize_scale(normal, cross)) {
        return intensity(lighting, 0);
    }
    return light_direction(lighting, normal);
}
