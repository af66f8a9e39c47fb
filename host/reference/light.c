/* SPDX-License-Identifier: MIT */
#include "light.h"
#include "primitive.h"

#include <math.h>

static double clamp01(double x)
{
    return fmax(0.0, fmin(1.0, x));
}

/* The eye is where w gets smaller, or the depth in a parallel projection. */
struct ref_lighting ref_lighting_of(const struct scene *scene, const struct ref_matrix *projection,
                                    const struct ref_matrix *modelview)
{
    double away = projection->m[3][2] != 0.0 ? projection->m[3][2] : projection->m[2][2];
    struct ref_lighting lighting = {
        .scene = scene, .to_eye = *modelview, .eye = away > 0.0 ? -1.0 : 1.0};

    ref_matrix_normal(modelview, lighting.normal_matrix);
    return lighting;
}

void ref_light_normal(const struct ref_lighting *lighting, const double normal[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = ref_dot3(lighting->normal_matrix[i], normal);
    ref_normalise3(out);
}

void ref_face_normal(const double a[3], const double b[3], const double c[3], double normal[3])
{
    double along[3], across[3];

    for (int k = 0; k < 3; k++) {
        along[k] = b[k] - a[k];
        across[k] = c[k] - a[k];
    }
    ref_cross3(along, across, normal);
}

double ref_intensity(const struct ref_lighting *lighting, const double normal[3])
{
    const struct scene_light *light = &lighting->scene->light;
    double n[3], towards[3];

    ref_from_q16(light->towards, 3, towards);
    if (ref_dot3(towards, towards) == 0.0)
        return 1.0;
    ref_normalise3(towards);
    ref_light_normal(lighting, normal, n);
    return clamp01((double)light->ambient / 65536.0 +
                   (double)light->diffuse / 65536.0 * fmax(0.0, ref_dot3(n, towards)));
}

/* What a unit of light from one source adds: n, l unit vectors in eye space. */
struct reflected {
    double diffuse, specular;
};

static struct reflected reflect(const struct ref_lighting *lighting, const double n[3],
                                const double l[3])
{
    struct reflected r = {fmax(0.0, ref_dot3(n, l)), 0.0};
    double half[3] = {l[0], l[1], l[2] + lighting->eye};
    const struct scene *scene = lighting->scene;

    if (r.diffuse > 0.0 && scene->reflection.shininess > 0) {
        ref_normalise3(half);
        double cosine = ref_dot3(n, half);
        if (cosine > 0.0)
            r.specular = pow(cosine, (double)scene->reflection.shininess / 65536.0);
    }
    return r;
}

/* The share of a spot light's cone that goes the way -l. */
static double cone(const struct scene_lamp *lamp, const double l[3])
{
    double axis[3];

    if (lamp->kind != SCENE_SPOT)
        return 1.0;
    ref_from_q16(lamp->direction, 3, axis);
    ref_normalise3(axis);
    double cosine = -ref_dot3(axis, l);
    const double turn = acos(-1.0) / 180.0 / 65536.0;
    double inner = cos(lamp->inner * turn);
    double outer = cos(lamp->outer * turn);
    double share = clamp01((cosine - outer) / fmax(inner - outer, 1.0 / 256.0));
    if (lamp->exponent > 0)
        share *= cosine > 0.0 ? pow(cosine, (double)lamp->exponent / 65536.0) : 0.0;
    return share;
}

/* Adds one source to the sums of what reaches the point. */
static void add_lamp(const struct ref_lighting *lighting, const struct scene_lamp *lamp,
                     const double n[3], const double at[3], double diffuse[3], double specular[3])
{
    double l[3], color[3], fade[3], fading = 1.0;

    ref_from_q16(lamp->position, 3, l);
    ref_from_q16(lamp->color, 3, color);
    ref_from_q16(lamp->fade, 3, fade);
    if (lamp->kind != SCENE_DIRECTIONAL) {
        for (int i = 0; i < 3; i++)
            l[i] -= at[i];
        double distance = sqrt(ref_dot3(l, l));
        fading = fade[0] + fade[1] * distance + fade[2] * distance * distance;
    }
    ref_normalise3(l);
    struct reflected reflected = reflect(lighting, n, l);
    double share = cone(lamp, l);
    double most = fmax(color[0], fmax(color[1], color[2]));
    if (most == 0.0)
        return;
    double kept = fmin(fading > 0.0 ? 1.0 / fading : HUGE_VAL, 16.0 / most) * share;
    for (int c = 0; c < 3; c++) {
        diffuse[c] += color[c] * kept * reflected.diffuse;
        specular[c] += color[c] * kept * reflected.specular;
    }
}

/* `light` with numbers alone, among others: a white directional one. */
static void add_light(const struct ref_lighting *lighting, const double n[3], double ambient[3],
                      double diffuse[3], double specular[3])
{
    const struct scene_light *light = &lighting->scene->light;
    double l[3];

    ref_from_q16(light->towards, 3, l);
    if (ref_dot3(l, l) == 0.0)
        return;
    ref_normalise3(l);
    struct reflected reflected = reflect(lighting, n, l);
    for (int c = 0; c < 3; c++) {
        ambient[c] += (double)light->ambient / 65536.0;
        diffuse[c] += (double)light->diffuse / 65536.0 * reflected.diffuse;
        specular[c] += (double)light->diffuse / 65536.0 * reflected.specular;
    }
}

/* Of a unit normal and a place in eye space. */
static void illuminate(const struct ref_lighting *lighting, const double n[3], const double at[3],
                       const double color[3], double out[3])
{
    const struct scene *scene = lighting->scene;
    const struct scene_reflection *reflection = &scene->reflection;
    double ambient[3], own[3], emission[3], highlight[3];
    double diffuse[3] = {0, 0, 0}, specular[3] = {0, 0, 0};

    ref_from_q16(scene->ambient, 3, ambient);
    ref_from_q16(reflection->ambient, 3, own);
    ref_from_q16(reflection->emission, 3, emission);
    ref_from_q16(reflection->specular, 3, highlight);
    add_light(lighting, n, ambient, diffuse, specular);
    for (int i = 0; i < scene->lamp_count; i++)
        add_lamp(lighting, &scene->lamps[i], n, at, diffuse, specular);
    for (int c = 0; c < 3; c++) {
        double reflects = reflection->own_ambient ? own[c] : color[c];
        out[c] = 255.0 * clamp01(emission[c] + reflects * ambient[c] + color[c] * diffuse[c] +
                                 highlight[c] * specular[c]);
    }
}

void ref_illuminate(const struct ref_lighting *lighting, const double normal[3],
                    const double position[3], const double color[3], double out[3])
{
    double at[4] = {position[0], position[1], position[2], 1.0};
    double n[3];

    ref_light_normal(lighting, normal, n);
    ref_matrix_transform(&lighting->to_eye, at, at);
    illuminate(lighting, n, at, color, out);
}

void ref_light_by_pixel(const struct ref_lighting *lighting, const double normal[3],
                        const double position[3], const double color[3], double *attribute)
{
    double at[4] = {position[0], position[1], position[2], 1.0};

    ref_light_normal(lighting, normal, &attribute[REF_NORMAL]);
    ref_matrix_transform(&lighting->to_eye, at, at);
    for (int i = 0; i < 3; i++) {
        attribute[REF_PLACE + i] = at[i];
        attribute[i] = 255.0 * color[i];
    }
}

void ref_pixel_color(const struct ref_lighting *lighting, const double *attribute, double out[3])
{
    double n[3], color[3];

    for (int i = 0; i < 3; i++) {
        n[i] = attribute[REF_NORMAL + i];
        color[i] = attribute[i] / 255.0;
    }
    ref_normalise3(n);
    illuminate(lighting, n, &attribute[REF_PLACE], color, out);
}
