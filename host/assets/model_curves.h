/* SPDX-License-Identifier: MIT */
/*
 * Animations of glTF whose values step or curve between keys, which the library assimp takes for
 * straight lines.
 */
#ifndef QTRI_HOST_ASSETS_MODEL_CURVES_H
#define QTRI_HOST_ASSETS_MODEL_CURVES_H

#include <stdbool.h>
#include <stddef.h>

#include "json.h"

enum motion_path { MOTION_POSITION, MOTION_ORIENTATION, MOTION_SCALE, MOTION_WEIGHTS };

struct motion_curve {
    struct json name; /* the node's; none: it has no name, but an index */
    size_t node;
    enum motion_path path;
    bool is_cubic;       /* else values stay until the next key */
    size_t count, width; /* keys, 1 or more, and numbers of a value */
    double per_second;   /* units of time */
    double *times;
    double *values; /* a value a key, or three: in-tangent, value, out-tangent */
};

struct motion_curves {
    struct motion_curve *items;
    size_t count, lost; /* lost: that could not be read */
};

/*
 * Those of the file's first animation, with times in units of 1/per_second. Those that cannot be
 * read are counted, and are straight lines. False when memory runs out; either way *curves is to be
 * freed.
 */
bool motion_curves_read(const char *path, const char *text, size_t length, double per_second,
                        struct motion_curves *curves);
void motion_curves_free(struct motion_curves *curves);

/* NULL: there is none. `name` is the library's. */
const struct motion_curve *motion_curve_of(const struct motion_curves *curves, const char *name,
                                           enum motion_path path);

/* The value at a time, or before it, where it steps. Orientations are w x y z and have length 1. */
void motion_curve_at(const struct motion_curve *curve, double time, bool is_before, double *value);

/* When keys are wanted, between which lines are straight enough. */
struct motion_moment {
    double time;
    bool is_before;
};

/* How many there are, and those written to `moments` where it is not NULL. */
size_t motion_curve_moments(const struct motion_curve *curve, struct motion_moment *moments);

#endif
