/* SPDX-License-Identifier: MIT */
#include "checked.h"

#include "qtri/frame.h"

#ifdef QTRI_CHECKED

/* Whether the last row is 0, so that w is 0 everywhere: no builder makes that. */
static bool has_zero_w(const qtri_transform *t)
{
    const qtri_row *w = &t->row[3];
    return (w->m[0] | w->m[1] | w->m[2]) == 0 && w->t == 0;
}

/* 0..1 in Q16.16, and not an integer 1 in place of Q16_ONE. */
static bool is_window_depth(q16 z)
{
    return z >= 0 && z != 1 && z <= Q16_ONE;
}

void qtri_check_view(const qtri_view *view, const qtri_transform *pose)
{
    QTRI_ASSERT(view != NULL);
    QTRI_ASSERT(pose != NULL);
    QTRI_ASSERT(!has_zero_w(pose));
    QTRI_ASSERT(!has_zero_w(&view->camera));
    QTRI_ASSERT(!has_zero_w(&view->projection));
    const qtri_viewport *viewport = &view->viewport;
    QTRI_ASSERT(viewport->width >= 1 && viewport->width <= QTRI_VIEWPORT_MAX);
    QTRI_ASSERT(viewport->height >= 1 && viewport->height <= QTRI_VIEWPORT_MAX);
    QTRI_ASSERT(is_window_depth(viewport->depth_near) && is_window_depth(viewport->depth_far));
    QTRI_ASSERT(view->vertices != NULL || view->vertex_count == 0);
    const qtri_light *light = view->light;
    QTRI_ASSERT(light == NULL || (light->ambient != 1 && light->diffuse != 1));
    QTRI_ASSERT(light == NULL || light->model != NULL || light->count == 0);
    QTRI_ASSERT(light == NULL || light->sources != NULL || light->count == 0);
}

static bool is_color(const qtri_light_color *color)
{
    return color->r != 1 && color->g != 1 && color->b != 1;
}

/* 180 in place of Q16(180) is less than 1/300 degree. */
static bool is_angle(q16 degrees)
{
    return degrees <= 0 || degrees > 180;
}

void qtri_check_lights(const qtri_light_source *sources, uint32_t count,
                       const qtri_light_color *ambient)
{
    QTRI_ASSERT(sources != NULL || count == 0);
    QTRI_ASSERT(is_color(ambient));
    for (uint32_t i = 0; i < count && i < QTRI_LIGHTS_MAX; i++) {
        const qtri_light_source *source = &sources[i];
        QTRI_ASSERT(is_color(&source->color));
        QTRI_ASSERT(source->constant != 1);
        QTRI_ASSERT(is_angle(source->inner) && is_angle(source->outer));
    }
}

void qtri_check_mesh(const qtri_mesh *mesh)
{
    QTRI_ASSERT(mesh != NULL);
    QTRI_ASSERT(mesh->vertex_count <= 65536);
    QTRI_ASSERT(mesh->positions != NULL || mesh->positions16 != NULL || mesh->vertex_count == 0);
    QTRI_ASSERT(mesh->positions16 == NULL || mesh->extent > 0);
    QTRI_ASSERT(mesh->triangles != NULL || mesh->triangles8 != NULL || mesh->triangle_count == 0);
    QTRI_ASSERT(mesh->faces.culling == NULL || mesh->faces.planes != NULL);
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        for (int corner = 0; corner < 3; corner++) {
            const uint32_t index =
                mesh->triangles8 != NULL ? mesh->triangles8[i][corner] : mesh->triangles[i][corner];
            QTRI_ASSERT(index < mesh->vertex_count);
        }
    }
}

static bool is_within(int32_t x, int32_t last)
{
    return x >= 0 && x <= last;
}

/* Fields of type bool are not read: where nothing set them, they may have values of no bool. */
void qtri_check_prepared(const qtri_prepared *prepared)
{
    QTRI_ASSERT(prepared != NULL);
    const bool has_mesh = prepared->mesh != NULL;
    const bool is_whole = (prepared->view != NULL) == has_mesh &&
                          (prepared->pose != NULL) == has_mesh &&
                          (prepared->material != NULL) == has_mesh &&
                          (prepared->vertices != NULL || prepared->vertex_count == 0) &&
                          (prepared->lists != NULL || prepared->list_count == 0) &&
                          (prepared->front == NULL) == (prepared->front_of == NULL);
    const bool is_ranged = is_within(prepared->width, QTRI_SURFACE_MAX) &&
                           is_within(prepared->height, QTRI_SURFACE_MAX) &&
                           is_within(prepared->rows, QTRI_SURFACE_MAX) &&
                           is_within(prepared->overlap, QTRI_OVERLAP_MAX) &&
                           is_within(prepared->edges_above, 2 * QTRI_OVERLAP_MAX) &&
                           is_within(prepared->edges_below, QTRI_OVERLAP_MAX) &&
                           prepared->group_log2 <= 16 &&
                           (has_mesh || (prepared->rows | prepared->width) == 0);
    QTRI_ASSERT(is_whole && is_ranged); /* qtri_prepared_init was called */
}

void qtri_check_corners(const void *corners, uint32_t count, uint32_t each)
{
    QTRI_ASSERT(corners != NULL || count == 0);
    QTRI_ASSERT(count % each == 0);
}

#else

/* C99 wants a declaration in every file. */
typedef int qtri_draw_is_not_checked;

#endif
