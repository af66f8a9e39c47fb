/* SPDX-License-Identifier: MIT */
#include "../raster/sampling.h"
#include "lights.h"
#include "per_pixel.h"

/* Vertices from which on a look at eight corners pays. */
enum { WORTH_A_BOX = 64 };

/* Whether the mesh cannot touch the surface: not its rows, for a band. */
static bool is_missed(const qtri_mesh_job *draw, const qtri_surface *surface)
{
    const qtri_mesh *mesh = draw->mesh;
    qtri_box box = mesh->bounds;
    if ((box.half.x | box.half.y | box.half.z) == 0) {
        if (!qtri_mesh_has_compact(mesh->positions16) || mesh->vertex_count < WORTH_A_BOX) {
            return false;
        }
        box.center = mesh->origin; /* the cube that 16 bits span */
        box.half.x = mesh->extent;
        box.half.y = mesh->extent;
        box.half.z = mesh->extent;
    }
    if (box.half.x == INT32_MAX) {
        return false; /* of wide lines, whose reach does not count in any space */
    }
    const qtri_rect bounds = qtri_surface_bounds(surface);
    /* Smooth lines reach out of their mesh, and samples lie beside the centres of pixels. */
    const int32_t more = draw->material.fill != NULL || qtri_sampling_of(surface->format) != NULL;
    const int32_t low[2] = {bounds.x0 - more, bounds.y0 - more};
    const int32_t high[2] = {bounds.x1 + more, bounds.y1 + more};
    return qtri_projector_misses(&draw->primitive.projector, &box, low, high);
}

static bool is_compact(const qtri_mesh *mesh)
{
    return mesh->positions16 != NULL || mesh->normals8 != NULL || mesh->uvs16 != NULL ||
           mesh->triangles8 != NULL;
}

static bool is_wide(const qtri_mesh *mesh)
{
    return mesh->positions16 == NULL || (mesh->normals != NULL && mesh->normals8 == NULL) ||
           (mesh->uvs != NULL && mesh->uvs16 == NULL);
}

/* Without vertices every index is past the end; the arrays of what is empty may be NULL. */
static bool is_empty(const qtri_mesh *mesh)
{
    return mesh->vertex_count == 0 || mesh->triangle_count == 0;
}

/* Whether the library is built with what the mesh has, see config.h. */
static bool is_built(const qtri_mesh *mesh)
{
    return (QTRI_WITH_COMPACT_MESHES || !is_compact(mesh)) &&
           (QTRI_WITH_WIDE_MESHES || !is_wide(mesh));
}

/* What colours do, see qtri_draw_state_init(). */
static int shade_of(const qtri_mesh_job *draw)
{
    if (draw->lights != NULL && qtri_by_pixel_of(&draw->material) != NULL) {
        return QTRI_BY_PIXEL;
    }
    if (draw->mesh->colors != NULL || draw->lights != NULL) {
        return qtri_is_smooth(&draw->material) ? QTRI_COLORS : QTRI_TINT;
    }
    if (draw->lit_per_vertex) {
        return QTRI_LIGHT;
    }
    return draw->lit_per_face ? QTRI_TINT : QTRI_FLAT;
}

void qtri_mesh_job_init(qtri_mesh_job *draw, const qtri_surface *surface, const qtri_view *view,
                        const qtri_mesh *mesh, const qtri_material *material, qtri_vertex *vertices,
                        uint32_t vertex_count)
{
    draw->material = *material;
    if (mesh->uvs == NULL && mesh->uvs16 == NULL) {
        draw->material.texture = NULL;
    }
    draw->mesh = mesh;
    draw->vertices = vertices;
    draw->slot_count = vertex_count;
    draw->lights = view->lights;
    draw->illumination = NULL;
    draw->lit_colors = NULL;
    draw->late = NULL;
    draw->noted = false;
    draw->lit = false;
    const bool normals = mesh->normals != NULL || mesh->normals8 != NULL;
    const bool is_lit = view->light != NULL && view->lights == NULL;
    draw->lit_per_vertex = is_lit && qtri_is_smooth(material) && normals;
    draw->lit_per_face = QTRI_WITH_FACE_LIGHT && is_lit && !draw->lit_per_vertex;
    if (draw->lights != NULL) {
        draw->lights->model->begin(draw);
    }
    qtri_primitive_set_target(&draw->primitive, surface, view, &draw->material, shade_of(draw));
    if (material->fill == NULL) {
        qtri_mesh_solid_init(draw);
    }
}

bool qtri_mesh_job_place(qtri_mesh_job *draw, const qtri_view *view, const qtri_transform *pose)
{
    const qtri_mesh *mesh = draw->mesh;
    qtri_primitive_place(&draw->primitive, view, pose);
    if (is_empty(mesh) || !is_built(mesh) || is_missed(draw, draw->primitive.surface)) {
        return false;
    }
    if (qtri_mesh_has_compact(mesh->positions16)) {
        qtri_projector_compact(&draw->primitive.projector, &mesh->origin, mesh->extent);
    }
    if (view->light != NULL && view->lights == NULL) {
        qtri_transform object_to_eye;
        qtri_transform_mul(&object_to_eye, &view->camera, pose);
        const bool bytes = QTRI_WITH_COMPACT_MESHES && mesh->normals8 != NULL;
        qtri_lighting_init(&draw->lighting, view->light, &object_to_eye,
                           draw->lit_per_vertex && bytes ? 127 * 128 : 1 << 14);
        if (!QTRI_WITH_UNEVEN_LIGHT && !draw->lighting.plain) {
            draw->lit_per_vertex = false;
            draw->lit_per_face = false;
        }
    }
    return true;
}
