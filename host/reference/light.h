/* SPDX-License-Identifier: MIT */
/*
 * The light of scenes: `light`, `ambient` and `material`, at one point of a surface.
 */
#ifndef QTRI_HOST_REFERENCE_LIGHT_H
#define QTRI_HOST_REFERENCE_LIGHT_H

#include <stdbool.h>

#include "../io/scene.h"
#include "matrix.h"

struct ref_lighting {
    const struct scene *scene;
    struct ref_matrix to_eye;
    double normal_matrix[3][3];
    double eye; /* z of the direction to the eye: 1 or -1 */
};

struct ref_lighting ref_lighting_of(const struct scene *scene, const struct ref_matrix *projection,
                                    const struct ref_matrix *modelview);

/* The unit normal in eye space of one in object space; zero stays zero. */
void ref_light_normal(const struct ref_lighting *lighting, const double normal[3], double out[3]);

/* (b - a) x (c - a). */
void ref_face_normal(const double a[3], const double b[3], const double c[3], double normal[3]);

/* Lambert's law for the scene's one light, the statement with numbers alone: 0..1, 1 without. */
double ref_intensity(const struct ref_lighting *lighting, const double normal[3]);

/*
 * What a point shows in all lights, 0..255 a channel: Blinn and Phong's formula with the eye at an
 * infinite distance. Normal and position are in object space; color is 0..1, as diffuse.
 */
void ref_illuminate(const struct ref_lighting *lighting, const double normal[3],
                    const double position[3], const double color[3], double out[3]);

/* Light by pixel: the attributes of a vertex that it asks for, and what a pixel with such shows. */
void ref_light_by_pixel(const struct ref_lighting *lighting, const double normal[3],
                        const double position[3], const double color[3], double *attribute);
void ref_pixel_color(const struct ref_lighting *lighting, const double *attribute, double out[3]);

#endif
