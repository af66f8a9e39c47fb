/* SPDX-License-Identifier: MIT */
#include "asset.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../io/unique.h"
#include "../io/xalloc.h"
#include "mesh_arrays.h"

#define ONE 65536.0
#define PI  3.14159265358979323846

/* The most of a coordinate: Q16.16 with a unit to spare. */
#define MOST_POSITION 32767.0
#define MOST_VERTICES 65536u

/* How the numbers of a vertex are stored; the same for all parts, so that they join. */
struct packing {
    const struct asset_options *options;
    bool colors, uvs, compact_uvs;
    double origin[3], extent; /* in units of Q16.16; of compact positions */
};

/* A vertex as it will be stored. */
enum {
    PACKED_POSITION = 0,
    PACKED_NORMAL = 3,
    PACKED_UV = 6,
    PACKED_COLOR = 8,
    PACKED_SHIFT = 11, /* the first of its morph's shifts */
    PACKED_NUMBERS = 12
};
struct packed {
    int32_t number[PACKED_NUMBERS];
};

/* A part while it is made. */
struct draft {
    struct packed *vertices;
    uint32_t (*triangles)[3];
    size_t vertex_count, triangle_count;
};

void asset_free(struct asset *asset)
{
    for (size_t i = 0; asset->parts != NULL && i < asset->count; i++) {
        mesh_arrays_free(&asset->parts[i].mesh);
        free(asset->parts[i].targets);
    }
    free(asset->parts);
    for (size_t i = 0; i < asset->texture_count; i++) {
        texture_free(&asset->textures[i]);
    }
    free(asset->textures);
    free(asset->keys);
    free(asset->first_keys);
    free(asset->parents);
    memset(asset, 0, sizeof *asset);
}

/* ---- Packing ---- */

static int32_t held(double value, double most)
{
    return (int32_t)lround(fmin(fmax(value, -most), most));
}

static void pack_position(const struct packing *packing, const double position[3], int32_t out[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = packing->options->compact
                     ? held((position[i] * ONE - packing->origin[i]) * 32768.0 / packing->extent,
                            32767.0)
                     : (int32_t)lround(position[i] * ONE);
    }
}

static void unpack_position(const struct packing *packing, const int32_t in[3], double out[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = packing->options->compact
                     ? (packing->origin[i] + packing->extent * in[i] / 32768.0) / ONE
                     : in[i] / ONE;
    }
}

static double uv_scale(const struct packing *packing)
{
    return packing->compact_uvs ? 16384.0 : ONE;
}

static void pack(const struct packing *packing, const struct model *model,
                 const struct model_vertex *vertex, struct packed *out)
{
    const uint8_t *color = model->materials[vertex->material].color;
    memset(out, 0, sizeof *out);
    pack_position(packing, vertex->position, &out->number[PACKED_POSITION]);
    out->number[PACKED_SHIFT] = (int32_t)vertex->shift;
    for (int i = 0; i < 3; i++) {
        if (packing->options->normals) {
            double scale = packing->options->compact ? 127.0 : 16384.0;
            out->number[PACKED_NORMAL + i] = (int32_t)lround(vertex->normal[i] * scale);
        }
        if (packing->colors) {
            out->number[PACKED_COLOR + i] = (vertex->color[i] * color[i] + 127) / 255;
        }
    }
    for (int i = 0; i < 2 && packing->uvs; i++) {
        out->number[PACKED_UV + i] = (int32_t)lround(vertex->uv[i] * uv_scale(packing));
    }
}

static double length_of(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static double angle_between(const double a[3], const double b[3])
{
    double sine[3];
    double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        sine[i] = a[j] * b[k] - a[k] * b[j];
    }
    return atan2(length_of(sine), cosine) * 180.0 / PI;
}

static void measure(const struct packing *packing, const struct model_vertex *vertex,
                    const struct packed *packed, struct asset_error *error)
{
    double at[3], normal[3], off[3];
    unpack_position(packing, &packed->number[PACKED_POSITION], at);
    for (int i = 0; i < 3; i++) {
        off[i] = at[i] - vertex->position[i];
        normal[i] = packed->number[PACKED_NORMAL + i];
    }
    error->position = fmax(error->position, length_of(off));
    if (packing->options->normals) {
        error->normal_degrees = fmax(error->normal_degrees, angle_between(normal, vertex->normal));
    }
    for (int i = 0; i < 2 && packing->uvs; i++) {
        double stored = packed->number[PACKED_UV + i] / uv_scale(packing);
        error->uv = fmax(error->uv, fabs(stored - vertex->uv[i]));
    }
}

/* ---- What is equal is one, what has no area goes ---- */

static bool same_position(const int32_t *a, const int32_t *b)
{
    return memcmp(a, b, 3 * sizeof *a) == 0;
}

/*
 * Whether a b != c d, for factors below 2^33: from 2^62 on the difference in double precision says
 * so, as its error is below 2^14; below, it fits 64 bits, and is 0 when it is so modulo 2^64.
 */
static bool products_differ(int64_t a, int64_t b, int64_t c, int64_t d)
{
    double difference = (double)a * (double)b - (double)c * (double)d;
    return fabs(difference) >= 4611686018427387904.0 ||
           (uint64_t)a * (uint64_t)b != (uint64_t)c * (uint64_t)d;
}

static bool has_area(const int32_t *a, const int32_t *b, const int32_t *c)
{
    int64_t edge[2][3];
    if (same_position(a, b) || same_position(b, c) || same_position(a, c)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        edge[0][i] = (int64_t)b[i] - a[i];
        edge[1][i] = (int64_t)c[i] - a[i];
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        if (products_differ(edge[0][j], edge[1][k], edge[0][k], edge[1][j])) {
            return true;
        }
    }
    return false;
}

static void add_triangles(struct draft *draft, const struct packing *packing,
                          const struct model *model, int material, struct unique *vertices,
                          struct asset_error *error)
{
    for (size_t i = 0; i < model->triangle_count; i++) {
        const uint32_t *corner = model->triangles[i];
        struct packed packed[3];
        if (material >= 0 && model->vertices[corner[0]].material != material) {
            continue;
        }
        for (int j = 0; j < 3; j++) {
            pack(packing, model, &model->vertices[corner[j]], &packed[j]);
        }
        if (has_area(packed[0].number, packed[1].number, packed[2].number)) {
            uint32_t *triangle = draft->triangles[draft->triangle_count++];
            for (int j = 0; j < 3; j++) {
                measure(packing, &model->vertices[corner[j]], &packed[j], error);
                triangle[j] = unique_add(vertices, &packed[j]);
            }
        }
    }
}

/* Triangles for the cache, or as they are; vertices in the order of their first use. */
static void order(struct draft *draft, bool keep_order)
{
    struct packed *moved = xcalloc(draft->vertex_count, sizeof *moved);
    uint32_t *place = xcalloc(draft->vertex_count, sizeof *place); /* new index + 1, or 0 */
    if (!keep_order) {
        asset_order_triangles(draft->triangles, draft->triangle_count, draft->vertex_count);
    }
    uint32_t count = 0;
    for (size_t i = 0; i < 3 * draft->triangle_count; i++) {
        uint32_t *corner = &draft->triangles[i / 3][i % 3];
        if (place[*corner] == 0) {
            moved[count] = draft->vertices[*corner];
            place[*corner] = ++count;
        }
        *corner = place[*corner] - 1;
    }
    free(draft->vertices);
    draft->vertices = moved;
    free(place);
}

/* Of all triangles, or of those of a material, 0 or more. */
static void make_draft(struct draft *draft, const struct packing *packing,
                       const struct model *model, int material, struct asset_error *error)
{
    struct unique vertices = {.item_size = sizeof *draft->vertices};
    draft->triangles = xcalloc(model->triangle_count, sizeof *draft->triangles);
    add_triangles(draft, packing, model, material, &vertices, error);
    draft->vertices = vertices.items;
    draft->vertex_count = vertices.count;
    vertices.items = NULL;
    unique_free(&vertices);
    order(draft, packing->options->keep_order);
}

/* ---- The arrays of a part ---- */

/* The packed numbers of vertices from `first` on, if they are wanted. */
static void make_array(struct asset_part *part, const struct draft *draft, enum mesh_array which,
                       int first, bool is_wanted)
{
    if (is_wanted) {
        mesh_array_create(&part->mesh, which);
    }
    for (size_t i = 0; is_wanted && i < draft->vertex_count; i++) {
        mesh_array_put(&part->mesh, which, i, &draft->vertices[i].number[first]);
    }
}

static void make_vertices(struct asset_part *part, const struct draft *draft,
                          const struct packing *packing)
{
    const bool compact = packing->options->compact;
    if (compact) {
        part->mesh.origin.x = (q16)packing->origin[0];
        part->mesh.origin.y = (q16)packing->origin[1];
        part->mesh.origin.z = (q16)packing->origin[2];
        part->mesh.extent = (q16)packing->extent;
    }
    make_array(part, draft, compact ? MESH_POSITIONS16 : MESH_POSITIONS, PACKED_POSITION, true);
    make_array(part, draft, compact ? MESH_NORMALS8 : MESH_NORMALS, PACKED_NORMAL,
               packing->options->normals);
    make_array(part, draft, packing->compact_uvs ? MESH_UVS16 : MESH_UVS, PACKED_UV, packing->uvs);
    make_array(part, draft, MESH_COLORS, PACKED_COLOR, packing->colors);
}

/* One colour of all vertices is the material's. */
static void share_color(struct asset_part *part)
{
    const qtri_rgb *colors = part->mesh.colors;
    bool is_one = colors != NULL;
    for (uint32_t i = 1; is_one && i < part->mesh.vertex_count; i++) {
        is_one = memcmp(&colors[i], &colors[0], sizeof *colors) == 0;
    }
    if (is_one) {
        part->material.color[0] = colors[0].r;
        part->material.color[1] = colors[0].g;
        part->material.color[2] = colors[0].b;
        mesh_array_free(&part->mesh, MESH_COLORS);
    }
}

static void make_triangles(struct asset_part *part, const struct draft *draft,
                           const struct packing *packing)
{
    const bool narrow = packing->options->compact && draft->vertex_count <= 256;
    mesh_array_fill(&part->mesh, narrow ? MESH_TRIANGLES8 : MESH_TRIANGLES,
                    (const int32_t *)draft->triangles[0]);
}

/* The targets of a morph as 16-bit positions, which wide meshes have none of. */
static void make_targets(struct asset_part *part, const struct draft *draft,
                         const struct packing *packing, const struct model *model)
{
    const size_t count = draft->vertex_count;
    const struct model_morph *morph = &model->morphs[part->material.morph - 1];
    part->target_count = morph->target_count;
    part->first_weight = MODEL_TRACK_WEIGHTS * morph->first_track;
    part->targets = xcalloc(count * part->target_count, sizeof *part->targets);
    for (size_t i = 0; i < count * part->target_count; i++) {
        const int32_t *base = draft->vertices[i % count].number;
        const double *shift = model->shifts[(size_t)base[PACKED_SHIFT] + i / count];
        int16_t to[3];
        for (int axis = 0; axis < 3; axis++) {
            to[axis] =
                (int16_t)held(base[axis] + shift[axis] * ONE * 32768.0 / packing->extent, 32767.0);
        }
        const qtri_position16 target = {to[0], to[1], to[2]};
        part->targets[i] = target;
    }
}

/* Between what a vertex is with weights from 0 to 1. */
static void part_extremes(const struct asset_part *part, const struct draft *draft, size_t at,
                          int32_t low[3], int32_t high[3])
{
    const int32_t *base = draft->vertices[at].number;
    memcpy(low, base, 3 * sizeof *low);
    memcpy(high, base, 3 * sizeof *high);
    for (size_t i = 0; i < part->target_count; i++) {
        const qtri_position16 *target = &part->targets[i * draft->vertex_count + at];
        const int32_t shift[3] = {target->x - base[0], target->y - base[1], target->z - base[2]};
        for (int axis = 0; axis < 3; axis++) {
            low[axis] += shift[axis] < 0 ? shift[axis] : 0;
            high[axis] += shift[axis] > 0 ? shift[axis] : 0;
        }
    }
}

/* The smallest box of whole units that holds what the core will see. */
static void set_bounds(struct asset_part *part, const struct draft *draft,
                       const struct packing *packing)
{
    qtri_mesh *mesh = &part->mesh;
    q16 *center[3] = {&mesh->bounds.center.x, &mesh->bounds.center.y, &mesh->bounds.center.z};
    q16 *half[3] = {&mesh->bounds.half.x, &mesh->bounds.half.y, &mesh->bounds.half.z};
    double low[3] = {INFINITY, INFINITY, INFINITY};
    double high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (size_t i = 0; i < draft->vertex_count; i++) {
        int32_t least[3], most[3];
        double from[3], to[3];
        part_extremes(part, draft, i, least, most);
        unpack_position(packing, least, from);
        unpack_position(packing, most, to);
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = fmin(low[axis], from[axis] * ONE);
            high[axis] = fmax(high[axis], to[axis] * ONE);
        }
    }
    for (int axis = 0; axis < 3; axis++) {
        double middle = floor((low[axis] + high[axis]) / 2.0);
        *center[axis] = (q16)middle;
        *half[axis] = (q16)fmax(1.0, ceil(fmax(high[axis] - middle, middle - low[axis])));
    }
}

/* Planes of faces that pay. */
static void make_planes(struct asset_part *part, const struct packing *packing)
{
    qtri_face8 *planes = xcalloc(part->mesh.triangle_count, sizeof *planes);
    if (!packing->options->make_faces(&part->mesh, planes)) {
        free(planes);
    }
}

static void make_part(struct asset_part *part, const struct draft *draft,
                      const struct packing *packing, const struct model *model)
{
    const bool has_targets = part->material.morph > 0 && packing->options->compact;
    part->mesh.vertex_count = (uint32_t)draft->vertex_count;
    part->mesh.triangle_count = (uint32_t)draft->triangle_count;
    make_vertices(part, draft, packing);
    make_triangles(part, draft, packing);
    if (has_targets) {
        make_targets(part, draft, packing, model);
    }
    set_bounds(part, draft, packing);
    if (packing->options->make_faces != NULL && !has_targets) { /* planes stay where they are */
        make_planes(part, packing);
    }
}

/* ---- The asset ---- */

/* Whether the model fits, and how its numbers are stored. */
static bool set_packing(struct packing *packing, const char *path, const struct model *model,
                        struct text_error *error)
{
    struct model_box box = model_vertex_bounds(model);
    packing->uvs = model->has_uvs;
    packing->colors = packing->options->colors || packing->options->merged;
    packing->compact_uvs = packing->options->compact;
    packing->extent = 1.0;
    for (int i = 0; i < 3; i++) {
        if (box.low[i] < -MOST_POSITION || box.high[i] > MOST_POSITION) {
            return text_error_set(error, path, 0,
                                  "reaches beyond 32767, Q16.16's end; --fit makes it smaller");
        }
        packing->origin[i] = round((box.low[i] + box.high[i]) / 2.0 * ONE);
        /* So that the farthest is 32767 and not 32768, which would be held: half a unit off. */
        double reach =
            fmax(box.high[i] * ONE - packing->origin[i], packing->origin[i] - box.low[i] * ONE);
        packing->extent = fmax(packing->extent, ceil(reach * 32768.0 / 32767.0));
    }
    for (size_t i = 0; i < model->vertex_count && packing->uvs; i++) {
        for (int j = 0; j < 2; j++) {
            double uv = model->vertices[i].uv[j];
            if (fabs(uv) > MOST_POSITION) {
                return text_error_set(error, path, 0, "has a texture coordinate beyond 32767");
            }
            double compact = round(uv * 16384.0);
            packing->compact_uvs =
                packing->compact_uvs && compact >= -32768.0 && compact <= 32767.0;
        }
    }
    return true;
}

static bool add_part(struct asset *asset, const char *path, const struct packing *shared,
                     const struct model *model, int material, struct text_error *error)
{
    struct packing own = *shared;
    const struct packing *packing = &own;
    struct draft draft = {NULL, NULL, 0, 0};
    struct asset_part *part = &asset->parts[asset->count];
    if (shared->options->merged) {
        own.uvs = own.uvs && model->materials[material].texture[0] != '\0';
    }
    make_draft(&draft, packing, model, material, &asset->error);
    const bool ok = draft.vertex_count <= MOST_VERTICES;
    if (!ok) {
        text_error_set(error, path, 0, "%zu vertices, and a mesh has up to 65536; see --simplify",
                       draft.vertex_count);
    } else if (draft.triangle_count > 0) {
        asset->count++;
        part->material = model->materials[material < 0 ? 0 : material];
        part->texture = -1;
        if (packing->colors) {
            memset(part->material.color, 255, sizeof part->material.color);
        }
        make_part(part, &draft, packing, model);
        if (packing->options->merged) {
            share_color(part);
        }
    }
    free(draft.vertices);
    free(draft.triangles);
    return ok;
}

/* A mesh for each material that triangles have. */
static bool add_parts(struct asset *asset, const char *path, const struct packing *packing,
                      const struct model *model, struct text_error *error)
{
    bool *used = xcalloc(model->material_count, sizeof *used);
    bool ok = true;
    size_t count = 0;
    for (size_t i = 0; i < model->triangle_count; i++) {
        bool *flag = &used[model->vertices[model->triangles[i][0]].material];
        count += *flag ? 0 : 1;
        *flag = true;
    }
    if (count > 64) {
        ok = text_error_set(
            error, path, 0, "%s",
            packing->options->merged
                ? "more than 64 parts that look or move differently; --plain makes it one"
                : "more than 64 materials; --colors makes one mesh of them");
    }
    for (size_t i = 0; ok && i < model->material_count; i++) {
        if (used[i]) {
            ok = add_part(asset, path, packing, model, (int)i, error);
        }
    }
    free(used);
    return ok;
}

bool asset_make(const char *path, const struct model *model, const struct asset_options *options,
                struct asset *asset, struct text_error *error)
{
    struct packing packing = {.options = options};
    memset(asset, 0, sizeof *asset);
    if (!set_packing(&packing, path, model, error)) {
        return false;
    }
    asset->parts = xcalloc(model->material_count + 1, sizeof *asset->parts);
    bool ok = options->colors ? add_part(asset, path, &packing, model, -1, error)
                              : add_parts(asset, path, &packing, model, error);
    if (ok && asset->count == 0) {
        ok = text_error_set(error, path, 0,
                            "is so small that no triangle is left; --fit makes it larger");
    }
    if (!ok) {
        asset_free(asset);
        return false;
    }
    asset->flat_triangles = model->triangle_count - asset_triangle_count(asset);
    struct model_box box = model_bounds(model);
    double largest = 0.0;
    for (int i = 0; i < 3; i++) {
        largest = fmax(largest, box.high[i] - box.low[i]);
    }
    asset->error.position_share = largest > 0.0 ? asset->error.position / largest : 0.0;
    return true;
}
