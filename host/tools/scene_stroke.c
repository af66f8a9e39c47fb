/* SPDX-License-Identifier: MIT */
#include "scene_stroke.h"

#include <stdlib.h>

#include "scene_color.h"

static qtri_corner corner_of(const struct scene_vertex *v, const qtri_rgb *id)
{
    qtri_corner corner = {
        {v->position[0], v->position[1], v->position[2], v->position[3]}, {0, 0, 0}, {0, 0}};
    corner.color = id != NULL ? *id : scene_rgb(v->color);
    return corner;
}

qtri_stroke scene_stroke_of(const struct scene *scene, const struct scene_stroke *from,
                            const qtri_surface *surface, bool for_ids)
{
    static const qtri_cap caps[] = {[SCENE_CAP_ROUND] = QTRI_CAP_ROUND,
                                    [SCENE_CAP_BUTT] = QTRI_CAP_BUTT,
                                    [SCENE_CAP_SQUARE] = QTRI_CAP_SQUARE};
    qtri_stroke stroke = qtri_stroke_default();
    const int64_t scale = from->in_space ? 1 : surface->width / scene->width; /* 2: 2x2 samples */
    const int64_t width = from->width * scale;
    stroke.width = (q16)(width > INT32_MAX ? INT32_MAX : width < INT32_MIN ? INT32_MIN : width);
    stroke.cap = caps[from->cap];
    stroke.edges = from->smooth && !for_ids ? &qtri_stroke_smooth : NULL;
    stroke.alpha = for_ids ? 255 : scene_byte(from->alpha);
    stroke.closed = from->closed;
    stroke.in_space = from->in_space;
    return stroke;
}

void scene_draw_stroke(const struct scene *scene, const struct scene_op *op,
                       const qtri_surface *surface, const qtri_view *view,
                       const qtri_transform *modelview, const qtri_material *material,
                       const qtri_rgb *id)
{
    const struct scene_stroke *from = &op->u.stroke;
    const qtri_stroke stroke = scene_stroke_of(scene, from, surface, id != NULL);
    qtri_corner *corners = malloc((from->count + 1) * sizeof *corners);
    if (corners == NULL) {
        abort();
    }
    for (size_t i = 0; i < from->count; i++) {
        corners[i] = corner_of(&scene->stroke_vertices[from->first + i], id);
    }
    const uint32_t count = (uint32_t)from->count;
    if (from->is_point) {
        qtri_draw_points(surface, view, modelview, corners, count, &stroke, material);
    } else {
        qtri_draw_polyline(surface, view, modelview, corners, count, &stroke, material);
    }
    free(corners);
}
