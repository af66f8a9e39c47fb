/* SPDX-License-Identifier: MIT */
/*
 * Motion: key-framed poses, hierarchies of poses, and meshes that change their shape.
 */
#ifndef QTRI_ANIMATION_H
#define QTRI_ANIMATION_H

#include "mesh.h"
#include "transform.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A pose at a time. Times, in seconds or whatever the caller counts, grow from key to key. */
typedef struct qtri_key {
    q16 time;
    qtri_vec3 position;
    qtri_quat orientation; /* of any length; zero: none */
    qtri_vec3 scale;
} qtri_key;

/*
 * The pose between the two keys around `time`: position and scale on straight lines, each
 * coordinate within 1/2 ULP and what it changes by times 2^-32; orientation along the shortest arc
 * at a constant speed, its part of the way of 16 bits. Before the first key it is that one, after
 * the last that one; of keys with equal times the later counts. count <= 0: no motion at all, the
 * identity.
 */
qtri_key qtri_keys_at(const qtri_key *keys, int32_t count, q16 time);

/* t = t translate(position) rotate(orientation) scale(scale). */
void qtri_transform_key(qtri_transform *t, const qtri_key *key);

/*
 * Hierarchies: world[i] = world[parent[i]] local[i], for i = 0 .. count-1 in turn. A parent that is
 * not an earlier one, -1 among them, stands for none: world[i] = local[i]. world may be local.
 */
void qtri_poses_compose(qtri_transform *world, const qtri_transform *local, const int16_t *parent,
                        int32_t count);

/*
 * Between two sets of 16-bit positions: from[i] + t (to[i] - from[i]), rounded, t held to 0..1. The
 * sets share the mesh's origin and extent. out may be one of them.
 */
void qtri_morph_positions(qtri_position16 *out, const qtri_position16 *from,
                          const qtri_position16 *to, uint32_t count, q16 t);

/* The same for normals, made as long as 127 again; where they cancel each other, `from` stays. */
void qtri_morph_normals(qtri_normal8 *out, const qtri_normal8 *from, const qtri_normal8 *to,
                        uint32_t count, q16 t);

/*
 * Blend shapes: base[i] and the sum of weight[k] (target[k][i] - base[i]), rounded once, held to
 * +-32767. Weights of any value. out may be base.
 */
void qtri_morph_targets(qtri_position16 *out, const qtri_position16 *base,
                        const qtri_position16 *const *target, const q16 *weight, int32_t targets,
                        uint32_t count);

/*
 * Vertex animation: `frames` frames of `count` positions each, one after the other in memory, at
 * position `at`: 1.5 is half-way from frame 1 to frame 2. Taken modulo the number of frames, the
 * last one leading to the first. frames < 1 does nothing; up to 32767.
 */
void qtri_frames_positions(qtri_position16 *out, const qtri_position16 *positions, int32_t frames,
                           uint32_t count, q16 at);

#ifdef __cplusplus
}
#endif

#endif
