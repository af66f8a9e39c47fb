/* SPDX-License-Identifier: MIT */
/*
 * The picture being drawn: depth test, shading of one pixel, and the record of what is visible.
 */
#ifndef QTRI_HOST_REFERENCE_TARGET_H
#define QTRI_HOST_REFERENCE_TARGET_H

#include "primitive.h"
#include "reference.h"

/* Where pixels are looked at, from their centres; see samples.h. */
struct ref_sampling {
    double x, y;                /* multiples of 1/32 pixel */
    bool shades_pixels;         /* shaded once a pixel, not where it is looked at */
    const double (*samples)[2]; /* shades_pixels: all samples of a pixel, the first one first */
    int sample_count;
    double scale; /* footprints of textures are this share of a pixel's; 0: the finest level */
};

/* Whether a pixel is drawn, and whether it may be otherwise: see reference_image.either. */
enum ref_decision { REF_NOT_DRAWN, REF_DRAWN, REF_EITHER_DRAWN, REF_EITHER_NOT };

struct ref_target {
    const struct scene *scene;
    struct reference_image *image;
    int subpixel_bits;
    double depth_near, depth_far; /* of the depth range */
    struct ref_sampling at;
    bool depth_only;            /* triangles are solid, write their depth and have no colour */
    struct ref_window window;   /* pixels outside of it are not drawn */
    double depth_slope;         /* of triangles: see ref_target_shift */
    enum ref_decision decision; /* by ref_target_cover */
};

/* Allocates the image and clears it; false when memory runs out, with nothing to free. */
bool ref_target_open(struct ref_target *target, const struct scene *scene, int subpixel_bits,
                     struct reference_image *image);

/* What follows has its depths moved by `bias`, Q16.16; the range's ends are held to 0..1. */
void ref_target_bias(struct ref_target *target, int32_t bias);

/* What is added to depths of a triangle that change by `right` and `down` a pixel: so that the
   range of its vertices stays in 0..1. */
double ref_target_shift(const struct ref_target *target, double right, double down, double nearest,
                        double farthest);

/* Window depth of clip z / w: -1..1 to the depth range. */
double ref_target_depth(const struct ref_target *target, long double z_over_w);

/* A primitive covers pixel (x, y) at window depth `depth`: counts the hit and tests the depth. True
   if the pixel is to be shaded; where `decision` says EITHER_NOT, only ref_target_either is told.
 */
bool ref_target_cover(struct ref_target *target, int x, int y, double depth);

/* Whether a depth passes the test at pixel i; may it be otherwise? */
enum ref_decision ref_target_decide(const struct ref_target *target, size_t i, double depth);

/* Notes that pixel i may be off by `most` of 0..255 for what was decided. */
void ref_target_either(struct ref_target *target, size_t i, double most);

/* Writes the depth of pixel i, as was decided. */
void ref_target_write_depth(struct ref_target *target, size_t i, double depth);

/* Colours pixel (x, y) with the attributes there and, if the scene says so, writes the depth;
   `triangle` tells id, texturing and the colours' range. Nothing where the texture has its key.
   footprint: texels a pixel, see texture.h; of lines 0. */
void ref_target_shade(struct ref_target *target, int x, int y, double depth,
                      const struct ref_triangle *triangle, const double attribute[REF_ATTRIBUTES],
                      double footprint);

/* a0 + w1 (a1 - a0) + w2 (a2 - a0) for weights that sum to 1: equal values stay exactly equal. */
void ref_interpolate(const struct ref_vertex *const vertex[3], double weight1, double weight2,
                     double attribute[REF_ATTRIBUTES]);

/*
 * Notes in the image that pixel i was mixed: `kept` of what was there is left, and it is stored
 * anew. `edge`: how far the area of a smooth edge moves it, 0..255.
 */
void ref_target_mixed(struct ref_target *target, size_t i, double kept, double edge);

#endif
