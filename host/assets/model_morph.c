/* SPDX-License-Identifier: MIT */
/*
 * Morph targets: shapes that are added to a mesh, each by its weight.
 */
#include "model_morph.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model_motion.h"

void model_weights(const struct model *model, double time, double *weights)
{
    for (size_t i = 0; i < model->track_count; i++) {
        const struct model_key key = motion_key_at(model, &model->tracks[i], time);
        memcpy(&weights[MODEL_TRACK_WEIGHTS * i], key.position, sizeof key.position);
    }
}

void model_shape_at(const struct model *model, const double *weights,
                    const struct model_vertex *vertex, double at[3])
{
    memcpy(at, vertex->position, sizeof vertex->position);
    if (vertex->morph == 0) {
        return;
    }
    const struct model_morph *morph = &model->morphs[vertex->morph - 1];
    for (uint32_t i = 0; i < morph->target_count; i++) {
        const double weight = weights[MODEL_TRACK_WEIGHTS * morph->first_track + i];
        for (int axis = 0; axis < 3; axis++) {
            at[axis] += weight * model->shifts[vertex->shift + i][axis];
        }
    }
}

void model_shape_bounds(const struct model *model, const struct model_vertex *vertex, double low[3],
                        double high[3])
{
    memcpy(low, vertex->position, sizeof vertex->position);
    memcpy(high, vertex->position, sizeof vertex->position);
    const uint32_t count = vertex->morph > 0 ? model->morphs[vertex->morph - 1].target_count : 0;
    for (uint32_t i = 0; i < count; i++) {
        for (int axis = 0; axis < 3; axis++) {
            const double shift = model->shifts[vertex->shift + i][axis];
            low[axis] += fmin(shift, 0.0);
            high[axis] += fmax(shift, 0.0);
        }
    }
}

void model_drop_morphs(struct model *model)
{
    for (size_t i = 0; i < model->vertex_count; i++) {
        model->vertices[i].morph = 0;
        model->vertices[i].shift = 0;
    }
    model->track_count = 0;
}

#ifdef QTRI_HAVE_ASSIMP

#include <assimp/scene.h>

/* In all; files with more keep the meshes that come first. */
#define MOST_SHIFTS ((size_t)1 << 23)

unsigned morph_targets(const struct aiMesh *mesh)
{
    bool is_whole = true;
    for (unsigned i = 0; i < mesh->mNumAnimMeshes; i++) {
        const struct aiAnimMesh *target = mesh->mAnimMeshes[i];
        is_whole =
            is_whole && target->mVertices != NULL && target->mNumVertices == mesh->mNumVertices;
    }
    return is_whole ? mesh->mNumAnimMeshes : 0;
}

/* The weights of three targets at a key, or at rest. */
static void set_weights(const struct aiMesh *mesh, const struct aiMeshMorphKey *from,
                        unsigned first, struct model_key *key)
{
    key->orientation[0] = 1.0;
    for (unsigned i = 0; i < MODEL_TRACK_WEIGHTS && first + i < mesh->mNumAnimMeshes; i++) {
        key->position[i] = (double)mesh->mAnimMeshes[first + i]->mWeight;
        key->scale[i] = 1.0;
        for (unsigned j = 0; from != NULL && j < from->mNumValuesAndWeights; j++) {
            key->position[i] = from->mValues[j] == first + i ? from->mWeights[j] : key->position[i];
        }
    }
}

/* The keys of a curve's weights from `first` on; false when memory runs out. */
static bool set_curve(const struct motion_curve *curve, unsigned first, size_t count,
                      struct model_key *keys)
{
    struct motion_moment *moments = malloc((count + 1) * sizeof *moments);
    double *weights = malloc((curve->width + 1) * sizeof *weights);
    const bool ok = moments != NULL && weights != NULL;
    if (ok) {
        (void)motion_curve_moments(curve, moments);
    }
    for (size_t i = 0; ok && i < count; i++) {
        motion_curve_at(curve, moments[i].time, moments[i].is_before, weights);
        for (unsigned j = 0; j < MODEL_TRACK_WEIGHTS && first + j < curve->width; j++) {
            keys[i].position[j] = weights[first + j];
        }
        keys[i].time = moments[i].time;
    }
    free(weights);
    free(moments);
    return ok;
}

static bool add_track(struct model *model, const struct aiMesh *mesh,
                      const struct aiMeshMorphAnim *channel, const struct motion_curve *curve,
                      double per_second, unsigned first)
{
    const bool moves = channel != NULL && channel->mNumKeys > 0;
    const size_t count = curve != NULL ? motion_curve_moments(curve, NULL)
                         : moves       ? channel->mNumKeys
                                       : 1;
    struct model_node *tracks =
        realloc(model->tracks, (model->track_count + 1) * sizeof *model->tracks);
    struct model_key *keys = motion_append_keys(model, count);
    model->tracks = tracks != NULL ? tracks : model->tracks;
    if (tracks == NULL || keys == NULL) {
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        const bool has_key = moves && curve == NULL;
        set_weights(mesh, has_key ? &channel->mKeys[i] : NULL, first, &keys[i]);
        keys[i].time = has_key ? channel->mKeys[i].mTime : 0.0;
    }
    if (curve != NULL && !set_curve(curve, first, count, keys)) {
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        keys[i].time /= per_second;
    }
    const size_t kept = motion_thin_keys(keys, count);
    model->key_count -= count - kept;
    struct model_node *track = &tracks[model->track_count++];
    memset(track, 0, sizeof *track);
    track->first_key = model->key_count - kept;
    track->key_count = kept;
    return true;
}

bool morph_add(struct model *model, const struct aiMesh *mesh,
               const struct aiMeshMorphAnim *channel, const struct motion_curve *curve,
               double per_second)
{
    struct model_morph *morphs =
        model->morph_count < UINT16_MAX
            ? realloc(model->morphs, (model->morph_count + 1) * sizeof *model->morphs)
            : NULL;
    if (morphs == NULL) {
        return false;
    }
    model->morphs = morphs;
    struct model_morph *morph = &morphs[model->morph_count++];
    memset(morph, 0, sizeof *morph);
    morph->target_count = mesh->mNumAnimMeshes;
    morph->first_track = model->track_count;
    bool ok = true;
    for (unsigned i = 0; ok && i < mesh->mNumAnimMeshes; i += MODEL_TRACK_WEIGHTS) {
        ok = add_track(model, mesh, channel, curve, per_second, i);
    }
    return ok;
}

bool morph_reserve(struct model *model, const struct aiMesh *mesh)
{
    const size_t count = (size_t)mesh->mNumVertices * mesh->mNumAnimMeshes;
    double(*shifts)[3] =
        count < MOST_SHIFTS && model->shift_count + count < MOST_SHIFTS
            ? realloc(model->shifts, (model->shift_count + count + 1) * sizeof *model->shifts)
            : NULL;
    model->shifts = shifts != NULL ? shifts : model->shifts;
    return shifts != NULL;
}

void morph_copy(struct model *model, const struct aiMesh *mesh, unsigned at,
                const double matrix[3][3], struct model_vertex *vertex)
{
    vertex->morph = (uint16_t)model->morph_count;
    vertex->shift = (uint32_t)model->shift_count;
    for (unsigned i = 0; i < mesh->mNumAnimMeshes; i++) {
        const struct aiVector3D *to = &mesh->mAnimMeshes[i]->mVertices[at];
        const struct aiVector3D *from = &mesh->mVertices[at];
        const double shift[3] = {(double)to->x - (double)from->x, (double)to->y - (double)from->y,
                                 (double)to->z - (double)from->z};
        double *out = model->shifts[model->shift_count++];
        for (int row = 0; row < 3; row++) {
            out[row] =
                matrix[row][0] * shift[0] + matrix[row][1] * shift[1] + matrix[row][2] * shift[2];
        }
    }
}

#endif
