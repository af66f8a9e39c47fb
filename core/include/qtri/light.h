/* SPDX-License-Identifier: MIT */
/*
 * Several coloured lights: ambient, directional, point and spot lights, Blinn-Phong highlights,
 * emission, two-sided surfaces, and what makes a normal a place in a picture of a sphere.
 *
 *     static const qtri_light_source sources[] = {
 *         {.kind = &qtri_point_light, .position = {Q16(2), Q16(3), Q16(1)},
 *          .color = {Q16(1), Q16(.9), Q16(.7)}, .constant = Q16(1), .quadratic = Q16(.05)},
 *         {.kind = &qtri_directional_light, .position = {0, Q16(1), 0},
 *          .color = {Q16(.2), Q16(.2), Q16(.3)}}};
 *     const qtri_light_color dim = {Q16(.1), Q16(.1), Q16(.1)};
 *     qtri_light light;
 *     qtri_shininess polished;
 *     qtri_light_init(&light, sources, 2, dim);
 *     qtri_shininess_init(&polished, Q16(40));
 *     const qtri_reflection steel = {.specular = {255, 255, 255}, .shininess = &polished};
 *     view.light = &light;
 *     material.reflection = &steel;
 *
 * What a vertex shows, each channel by itself, is held to 0..1:
 *
 *     emission + ambient' ambient + sum over the sources of
 *         fade color cone (diffuse max(0, n . l) + specular (n . h)^shininess)
 *
 * n is the unit normal, l the direction to the source; h halves the angle between l and the line to
 * the eye, which is taken to be parallel to z of eye space everywhere, as OpenGL does without a
 * local viewer: +z, or -z where the projection looks along +z, as Direct3D's do. A source lights
 * nothing where n . l <= 0, and a highlight is nothing where n . h <= 0. diffuse is the vertex's
 * own colour, or the material's; ambient' is diffuse, or the reflection's own. Products of fade and
 * color are held to 16.
 *
 * Smooth shading: every vertex is lit, with its triangle's normal where it has none. Flat: every
 * triangle, with its own normal, at the mean of its corners, in the provoking one's colour. Normals
 * of any length go through the inverse transpose of camera and pose and are normalised; a zero one,
 * or a triangle without area, has emission and ambient light only.
 *
 * A vertex's colours are within 1 of 255 of the formula's, up to a shininess of 128 and a product
 * of fade and color of 4, and off by more where the formula jumps or its arguments cancel: in
 * highlights where n . l is within 2^-13 of 0, or of a source within 8 degrees of straight behind
 * the vertex; in the penumbra of a spot light whose cosines are less than .03 apart.
 *
 * By pixel, material.shading = &qtri_per_pixel: as smooth, but triangles with a vertex 6 pixels and
 * more from their first one, across or down, are lit along their rows, from the place and the unit
 * normal there, which is linear between those of the corners. So two triangles are enough for a
 * floor under a lamp. Light is found for every eighth pixel of a row, the sixteenth where there are
 * neither highlights nor spot lights, and for more where it bends; between, colours are linear.
 * Small triangles of meshes, within 60 pixels, are lit at their vertices where that is within 1 of
 * 255, on RGB565 within 4, of light in the middles of their edges, and within 8 by the polynomial
 * of second order through these six, if it is as good at the centroid. Colours are within 2 of 255
 * of the formula's, but for a pixel in some thousands, where an edge of light is sharper than that,
 * within 6. Highlights of less than 4 pixels may be missed. Triangles of qtri_draw_lit_triangles
 * and pieces of clipped ones are lit along their rows whatever their size. host/bench/README.md
 * says what it costs.
 *
 * Nothing of this is linked where qtri_light_init is not named, nor a kind of light that no source
 * names. A single directional light without colour is qtri_light, see view.h, at a tenth of the
 * cost.
 */
#ifndef QTRI_LIGHT_H
#define QTRI_LIGHT_H

#include <stdbool.h>
#include <stdint.h>

#include "draw.h"
#include "error.h"
#include "mesh.h"
#include "view.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How many sources a view may have. */
#define QTRI_LIGHTS_MAX 8

/*
 * (n . h)^shininess, made once: up to 129 values, linear in between. Fields are internal.
 */
typedef struct qtri_shininess {
    uint8_t shift, count;
    uint16_t least_q15; /* the square of n . h where the table ends */
    uint16_t value_q15[130];
} qtri_shininess;

/*
 * shininess is held to 1..1024. Values are within 2^-9 of the power, and 0 where that is below
 * 2^-10.
 */
void qtri_shininess_init(qtri_shininess *table, q16 shininess);

/* How a source shines; linked where one names it. */
typedef struct qtri_light_kind qtri_light_kind;
extern const qtri_light_kind qtri_directional_light, qtri_point_light, qtri_spot_light;

/* A source of light in the world. */
struct qtri_light_source {
    const qtri_light_kind *kind; /* NULL: is off */
    /* In the world. Of a directional light: the direction to it, any length; zero: is off. A vertex
       at the very position of a source is not lit by it. */
    qtri_vec3 position;
    qtri_light_color color;

    /*
     * Point and spot: fade = 1 / (constant + linear d + quadratic d^2) at a distance d, measured
     * in eye space. Below 0 counts as 0. Less than 1/1024 of full light is none.
     */
    q16 constant, linear, quadratic;

    /*
     * Spot: where it shines to, any length (zero: is off), and the angle from there in degrees,
     * held to 0..180. Light is full up to `inner`, gone from `outer` on and linear in the cosine
     * between; where inner >= outer it ends at `outer` within 1/256 of the cosine. With `falloff`
     * it is also times cos(angle)^shininess, as OpenGL's spot exponent.
     */
    qtri_vec3 direction;
    q16 inner, outer;
    const qtri_shininess *falloff; /* NULL: none */
};

/*
 * Elements of scratch memory, view->vertices or a prepared mesh's vertices, with room for the
 * colours of a mesh of so many lit vertices. With less, vertices are lit again for every triangle:
 * slower, and the same pixels.
 */
#define QTRI_LIT_VERTICES(count) ((count) + ((count) + 4u) / 5u)

/*
 * Sources are read by every draw call: they may move between frames. QTRI_ERROR_SIZE, and the first
 * QTRI_LIGHTS_MAX of them, when there are more.
 */
enum qtri_error qtri_light_init(qtri_light *light, const qtri_light_source *sources, uint32_t count,
                                qtri_light_color ambient);

/* What a material reflects beside its own colour: material->reflection. */
struct qtri_reflection {
    qtri_rgb ambient;  /* of ambient light; only with own_ambient, otherwise the diffuse colour */
    qtri_rgb specular; /* of highlights */
    qtri_rgb emission;
    const qtri_shininess *shininess; /* NULL: no highlights */
    bool own_ambient;
    bool two_sided; /* triangles that show their back are lit there: their normals are turned.
                       Those are lit anew for every triangle. */
};

/*
 * qtri_draw_triangles in the light of view->light, if it has sources: at the place (x/w, y/w, z/w)
 * of each corner, rounded to Q16.16. normals: of each corner, in object space; NULL, or zero for a
 * corner, for that of the triangle.
 */
void qtri_draw_lit_triangles(const qtri_surface *surface, const qtri_view *view,
                             const qtri_transform *pose, const qtri_corner *corners,
                             const qtri_normal *normals, uint32_t corner_count,
                             const qtri_material *material);

/*
 * Texture coordinates that look up a picture of a lit sphere (matcap): u = (1 + n.x) / 2 and v = (1
 * - n.y) / 2 of the unit normal in eye space, within 2^-13; (1/2, 1/2) without normals, and for a
 * zero one. Draw a copy of the mesh that has them as uvs16, with a texture that clamps.
 */
void qtri_sphere_map(qtri_uv16 *uvs, const qtri_transform *camera, const qtri_transform *pose,
                     const qtri_mesh *mesh);

#ifdef __cplusplus
}
#endif

#endif
