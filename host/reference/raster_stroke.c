/* SPDX-License-Identifier: MIT */
#include "raster_stroke.h"

#include "../io/xalloc.h"
#include "blend.h"
#include "clip.h"
#include "snap.h"
#include "stroke_cover.h"

#include <math.h>
#include <stdlib.h>

#define PI 3.14159265358979323846

/* What a part's ends have beside their place. */
struct ends {
    double depth[2], color[2][3];
};

struct strokes {
    struct ref_stroke_part *part;
    struct ends *ends;
    size_t count;
};

/* Window coordinates in pixels, snapped if the target is. */
static void window_of(const struct ref_target *target, const struct ref_vertex *v, double out[2])
{
    int bits = target->subpixel_bits;
    long double at[2] = {ref_window_x(v, &target->window) / v->w,
                         ref_window_y(v, &target->window) / v->w};

    for (int k = 0; k < 2; k++) {
        if (bits > 0)
            at[k] = ldexpl((long double)ref_snap(at[k], bits), -bits);
        out[k] = (double)at[k];
    }
}

/* The length of half a width along the picture's upwards on the screen. */
static double radius_in_space(const struct ref_target *target, const struct scene_vertex *v,
                              double width, const struct ref_matrix *to_clip,
                              const struct ref_matrix *modelview)
{
    double up[3] = {modelview->m[1][0], modelview->m[1][1], modelview->m[1][2]};
    double p[4];
    double at[2][2];

    ref_normalise3(up);
    for (int i = 0; i < 2; i++) {
        struct ref_vertex moved = {0};
        ref_from_q16(v->position, 4, p);
        for (int k = 0; k < 3 && i == 1; k++)
            p[k] += up[k] * width / 2.0 * p[3];
        ref_matrix_transform(to_clip, p, p);
        moved.x = p[0];
        moved.y = p[1];
        moved.w = p[3];
        at[i][0] = (double)(ref_window_x(&moved, &target->window) / moved.w);
        at[i][1] = (double)(ref_window_y(&moved, &target->window) / moved.w);
    }
    return hypot(at[1][0] - at[0][0], at[1][1] - at[0][1]);
}

/* Appends what clipping leaves of the part between two vertices. */
static struct ref_stroke_part *add_part(struct strokes *all, const struct ref_target *target,
                                        const struct ref_vertex *a, const struct ref_vertex *b)
{
    struct ref_vertex end[2] = {*a, *b};
    struct ref_stroke_part *part = &all->part[all->count];
    struct ends *ends = &all->ends[all->count];
    double at[2][2];

    if (!ref_clip_line(end, &target->window, ref_guard_band(target->subpixel_bits)))
        return NULL;
    for (int i = 0; i < 2; i++) {
        window_of(target, &end[i], at[i]);
        ends->depth[i] = ref_target_depth(target, end[i].z / end[i].w);
        for (int c = 0; c < 3; c++)
            ends->color[i][c] = end[i].attribute[c];
    }
    part->x0 = at[0][0];
    part->y0 = at[0][1];
    part->x1 = at[1][0];
    part->y1 = at[1][1];
    all->count++;
    return part;
}

static void add_parts(struct strokes *all, const struct ref_target *target,
                      const struct scene_op *op, const struct ref_matrix *to_clip,
                      const struct ref_matrix *modelview)
{
    const struct scene_stroke *stroke = &op->u.stroke;
    const struct scene_vertex *in = &target->scene->stroke_vertices[stroke->first];
    bool closed = stroke->closed && stroke->count > 2;
    size_t parts = closed || stroke->count == 1 ? stroke->count : stroke->count - 1;
    enum ref_cap cap = (enum ref_cap)stroke->cap;

    if (stroke->is_point && cap == REF_CAP_BUTT)
        cap = REF_CAP_SQUARE;
    for (size_t i = 0; i < parts; i++) {
        struct ref_vertex a = ref_vertex_of(to_clip, &in[i], in[i].color);
        const struct scene_vertex *next = &in[(i + 1) % stroke->count];
        struct ref_vertex b = ref_vertex_of(to_clip, next, next->color);
        struct ref_stroke_part *part = add_part(all, target, &a, &b);
        if (part == NULL)
            continue;
        double width = (double)stroke->width / 65536.0;
        part->radius = stroke->in_space ? radius_in_space(target, &in[i], width, to_clip, modelview)
                                        : width / 2.0;
        part->radius = fmin(part->radius, 256.0);
        part->cap[0] = closed || i > 0 ? REF_CAP_ROUND : cap;
        part->cap[1] = closed || i + 1 < parts ? REF_CAP_ROUND : cap;
    }
}

/* What a stroke would make of a pixel there: without its coverage, under fog and blend. */
struct paint {
    double depth, color[3];
};

static struct paint paint_at(const struct ref_target *target, const struct ends *ends, double along,
                             const double under[3])
{
    struct paint out;

    out.depth = ends->depth[0] + along * (ends->depth[1] - ends->depth[0]);
    for (size_t c = 0; c < 3; c++) {
        out.color[c] = ends->color[0][c] + along * (ends->color[1][c] - ends->color[0][c]);
        if (ref_is_blended(target->scene))
            out.color[c] = ref_blend(target->scene, (int)c, out.color[c], 1, under[c], out.depth);
    }
    return out;
}

/* That of the nearest part, and of another that is as near, within 1/128 pixel; else the same. */
static void nearest(struct paint paint[2], const struct ref_target *target,
                    const struct strokes *all, int x, int y, const double under[3])
{
    double along = 0.0, distance = 0.0;
    size_t part = ref_stroke_nearest(all->part, all->count, x + 0.5, y + 0.5, &along, &distance);
    size_t first[2] = {0, part + 1}, end[2] = {part, all->count};

    paint[0] = paint_at(target, &all->ends[part], along, under);
    paint[1] = paint[0];
    for (int i = 0; i < 2; i++) {
        double off = INFINITY;
        size_t other = first[i] + ref_stroke_nearest(&all->part[first[i]], end[i] - first[i],
                                                     x + 0.5, y + 0.5, &along, &off);
        if (off < distance + 1 / 128.0)
            paint[1] = paint_at(target, &all->ends[other], along, under);
    }
}

static double difference(const double a[3], const double b[3])
{
    return fmax(fabs(a[0] - b[0]), fmax(fabs(a[1] - b[1]), fabs(a[2] - b[2])));
}

/* The depth of a pixel of which `share` is covered: is written where that is half of it. */
static void write_depth(struct ref_target *target, size_t i, const struct paint paint[2],
                        double share)
{
    struct reference_image *image = target->image;
    double before = image->depth[i];

    if (share >= 0.5) {
        ref_target_write_depth(target, i, paint[0].depth);
        if (paint[1].depth != paint[0].depth)
            image->other_depth[i] = paint[1].depth;
    }
    if (share < 1.0 && fabs(share - 0.5) <= 1 / 32.0)
        image->other_depth[i] = share >= 0.5 ? before : paint[0].depth;
}

/* Of a hard edge: whether a point 1/256 pixel from the centre lies on the other side. */
static bool is_at_edge(const struct strokes *all, double x, double y, bool inside)
{
    double along = 0.0, distance = 0.0, radius = 0.0;

    ref_stroke_nearest(all->part, all->count, x, y, &along, &distance);
    for (size_t i = 0; i < all->count; i++)
        radius = fmax(radius, all->part[i].radius);
    for (int i = 0; i < 8 && distance < 1.5 * radius + 0.1; i++)
        if (ref_stroke_contains(all->part, all->count, x + cos(i * PI / 4) / 256,
                                y + sin(i * PI / 4) / 256) != inside)
            return true;
    return false;
}

/* decision: of a hard edge, DRAWN where the pixel is certainly covered; else of depth alone. */
static void draw_pixel(struct ref_target *target, const struct scene_op *op,
                       const struct strokes *all, int x, int y, double share,
                       enum ref_decision decision)
{
    const struct scene *scene = target->scene;
    const struct scene_stroke *stroke = &op->u.stroke;
    struct reference_image *image = target->image;
    size_t i = (size_t)y * (size_t)scene->width + (size_t)x;
    double *to = &image->color[3 * i];
    double weight = share * (double)stroke->alpha / 65536.0;
    struct paint paint[2];

    nearest(paint, target, all, x, y, to);
    if (!ref_target_cover(target, x, y, paint[0].depth) || !ref_passes_door(scene, 1, x, y))
        return;
    if (target->decision == REF_DRAWN && ref_target_decide(target, i, paint[1].depth) != REF_DRAWN)
        target->decision = REF_EITHER_DRAWN;
    if (decision == REF_EITHER_NOT)
        image->hits[i]--;
    if (decision == REF_EITHER_NOT || target->decision == REF_DRAWN)
        target->decision = decision;
    double most = difference(paint[0].color, to);
    bool writes = scene->depth_test && scene->depth_write;
    if (writes)
        write_depth(target, i, paint, share);
    if (target->decision == REF_EITHER_NOT) {
        ref_target_either(target, i, weight * most);
        return;
    }
    ref_target_mixed(target, i, 1.0 - weight + weight * ref_kept(scene, 1),
                     stroke->smooth ? most : 0);
    ref_target_either(target, i, weight * difference(paint[0].color, paint[1].color));
    if (target->decision == REF_EITHER_DRAWN)
        ref_target_either(target, i, weight * most);
    for (size_t c = 0; c < 3; c++) {
        double mixed = to[c] * (1.0 - weight) + paint[0].color[c] * weight;
        to[c] = mixed;
        image->color_min[3 * i + c] = fmin(mixed, image->color_min[3 * i + c]);
        image->color_max[3 * i + c] = fmax(mixed, image->color_max[3 * i + c]);
    }
    /* Where the centre is inside, and the depth beside it is the stroke's own. */
    if ((!writes || share >= 0.5) && ref_stroke_contains(all->part, all->count, x + 0.5, y + 0.5))
        image->id[i] = op->id;
}

/* Rows that parts may reach: corners of square caps are not farther than 3/2 radii. */
static void find_rows(int rows[2], const struct strokes *all, int height)
{
    double low = height, high = 0.0;

    for (size_t i = 0; i < all->count; i++) {
        const struct ref_stroke_part *part = &all->part[i];
        low = fmin(low, fmin(part->y0, part->y1) - 1.5 * part->radius - 2.0);
        high = fmax(high, fmax(part->y0, part->y1) + 1.5 * part->radius + 2.0);
    }
    rows[0] = (int)fmax(low, 0.0);
    rows[1] = (int)fmin(high, height);
}

/* A hard edge is where the pixel is looked at; four samples of a pixel are as its centre. */
static void draw_rows(struct ref_target *target, const struct scene_op *op,
                      const struct strokes *all, double *share)
{
    int width = target->scene->width;
    double along = target->at.shades_pixels ? 0.0 : target->at.x;
    double across = target->at.shades_pixels ? 0.0 : target->at.y;
    int rows[2];

    find_rows(rows, all, target->scene->height);
    for (int y = rows[0]; y < rows[1]; y++) {
        if (op->u.stroke.smooth)
            ref_stroke_cover_row(all->part, all->count, y, width, share);
        for (int x = 0; x < width; x++) {
            double at[2] = {x + 0.5 + along, y + 0.5 + across};
            if (op->u.stroke.smooth) {
                if (share[x] > 0.0)
                    draw_pixel(target, op, all, x, y, share[x], REF_DRAWN);
                continue;
            }
            bool inside = ref_stroke_contains(all->part, all->count, at[0], at[1]);
            if (is_at_edge(all, at[0], at[1], inside))
                draw_pixel(target, op, all, x, y, 1, inside ? REF_EITHER_DRAWN : REF_EITHER_NOT);
            else if (inside)
                draw_pixel(target, op, all, x, y, 1, REF_DRAWN);
        }
    }
}

void ref_draw_stroke(struct ref_target *target, const struct scene_op *op,
                     const struct ref_matrix *projection, const struct ref_matrix *modelview)
{
    struct ref_matrix to_clip = ref_matrix_multiply(projection, modelview);
    size_t count = op->u.stroke.count;
    struct strokes all = {xcalloc(count + 1, sizeof *all.part),
                          xcalloc(count + 1, sizeof *all.ends), 0};
    double *share = xcalloc((size_t)target->scene->width, sizeof *share);

    if (count > 0 && op->u.stroke.width > 0) {
        add_parts(&all, target, op, &to_clip, modelview);
        draw_rows(target, op, &all, share);
    }
    free(all.part);
    free(all.ends);
    free(share);
}

void ref_draw_edge(struct ref_target *target, const struct ref_vertex *a,
                   const struct ref_vertex *b, const struct scene_stroke *look, uint32_t id)
{
    struct ref_stroke_part part;
    struct ends ends;
    struct strokes all = {&part, &ends, 0};
    struct scene_op op = {.id = id, .u.stroke = *look};
    double *share = xcalloc((size_t)target->scene->width, sizeof *share);

    if (look->width > 0 && add_part(&all, target, a, b) != NULL) {
        part.radius = fmin((double)look->width / 131072.0, 256.0);
        part.cap[0] = (enum ref_cap)look->cap;
        part.cap[1] = part.cap[0];
        draw_rows(target, &op, &all, share);
    }
    free(share);
}
