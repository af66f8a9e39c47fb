#include "../geometry/lighting.h"
#include "../math/bits.h"
#include "primitive.h"

/* One draw call: what every triangle needs. */
typedef struct mesh_draw {
    qtri_primitive primitive;
    const qtri_view *view;
    const qtri_mesh *mesh;
    bool lit, lit_per_vertex;
    qtri_lighting lighting;
} mesh_draw;

static void transform(const mesh_draw *draw, uint32_t index, qtri_vertex *out)
{
    qtri_clip_vertex clip;
    qtri_screen_vertex screen = {0};
    qtri_projector_point(&draw->primitive.projector, &draw->mesh->positions[index], &clip);
    unsigned outcode = qtri_clip_outcode(&clip);
    if (outcode == 0) {
        qtri_project(&draw->primitive.projector, &clip, &screen);
    }
    out->tag = index + 1;
    out->intensity = -1;
    out->outcode = (uint8_t)outcode;
    out->x_24p8 = screen.x_24p8;
    out->y_24p8 = screen.y_24p8;
    out->depth_16p16 = screen.depth_16p16;
    out->inv_w_q31 = screen.inv_w_q31;
    out->inv_w_exponent = (int16_t)screen.inv_w_exponent;
}

/*
 * The vertex's slot, filled. Vertex i lives in slot i modulo their number: with a slot for each,
 * every vertex is transformed once; with fewer, some are transformed again. Without memory, or
 * when a corner of the same triangle holds the slot, `spare` serves.
 */
static qtri_vertex *fetch(const mesh_draw *draw, uint32_t index, qtri_vertex *spare,
                          qtri_vertex *const taken[2])
{
    qtri_vertex *slot = spare;
    if (draw->view->vertex_count > 0) {
        qtri_vertex *own = &draw->view->vertices[index % draw->view->vertex_count];
        slot = own->tag != index + 1 && (own == taken[0] || own == taken[1]) ? spare : own;
    }
    if (slot == spare || slot->tag != index + 1) {
        transform(draw, index, slot);
    }
    return slot;
}

static q16 vertex_intensity(const mesh_draw *draw, qtri_vertex *vertex)
{
    if (vertex->intensity < 0) {
        vertex->intensity =
            qtri_lighting_vertex(&draw->lighting, &draw->mesh->normals[vertex->tag - 1]);
    }
    return vertex->intensity;
}

static void set_color(qtri_screen_vertex *out, qtri_rgb color, q16 intensity)
{
    out->color_8p16[0] = color.r * intensity; /* intensity <= 1.0 */
    out->color_8p16[1] = color.g * intensity;
    out->color_8p16[2] = color.b * intensity;
}

/* Colours, light and texture coordinates of a triangle that will be drawn. */
static void set_attributes(const mesh_draw *draw, qtri_vertex *const vertex[3],
                           qtri_screen_vertex out[3])
{
    const qtri_mesh *mesh = draw->mesh;
    q16 face = Q16_ONE;
    if (draw->lit && !draw->lit_per_vertex) {
        const qtri_vec3 *p = mesh->positions;
        face = qtri_lighting_face(&draw->lighting, &p[vertex[0]->tag - 1], &p[vertex[1]->tag - 1],
                                  &p[vertex[2]->tag - 1]);
    }
    for (int i = 0; i < 3; i++) {
        uint32_t index = vertex[i]->tag - 1;
        q16 intensity = draw->lit_per_vertex ? vertex_intensity(draw, vertex[i]) : face;
        set_color(&out[i],
                  mesh->colors != NULL ? mesh->colors[index] : draw->primitive.material->color,
                  intensity);
        out[i].u_q32 = mesh->uvs != NULL ? (int64_t)mesh->uvs[index].x * 65536 : 0;
        out[i].v_q32 = mesh->uvs != NULL ? (int64_t)mesh->uvs[index].y * 65536 : 0;
    }
}

static void set_position(qtri_screen_vertex *out, const qtri_vertex *vertex)
{
    out->x_24p8 = vertex->x_24p8;
    out->y_24p8 = vertex->y_24p8;
    out->depth_16p16 = vertex->depth_16p16;
    out->inv_w_q31 = vertex->inv_w_q31;
    out->inv_w_exponent = vertex->inv_w_exponent;
}

static void draw_triangle(const mesh_draw *draw, const uint16_t indices[3])
{
    qtri_vertex spare[3];
    qtri_vertex *vertex[3] = {NULL, NULL, NULL};
    for (int i = 0; i < 3; i++) {
        if (indices[i] >= draw->mesh->vertex_count) {
            return;
        }
        vertex[i] = fetch(draw, indices[i], &spare[i], vertex);
    }
    if ((vertex[0]->outcode & vertex[1]->outcode & vertex[2]->outcode) != 0) {
        return;
    }
    qtri_screen_vertex screen[3];
    if ((vertex[0]->outcode | vertex[1]->outcode | vertex[2]->outcode) == 0) {
        for (int i = 0; i < 3; i++) {
            set_position(&screen[i], vertex[i]);
        }
        int64_t area = qtri_primitive_area(&screen[0], &screen[1], &screen[2]);
        if (qtri_primitive_culled(draw->primitive.material, area)) {
            return; /* before it is lit */
        }
        set_attributes(draw, vertex, screen);
        qtri_primitive_screen_triangle(&draw->primitive, screen);
    } else {
        /* Rare: homogeneous coordinates are not kept but computed again. */
        qtri_clip_vertex clip[3];
        for (int i = 0; i < 3; i++) {
            qtri_projector_point(&draw->primitive.projector,
                                 &draw->mesh->positions[vertex[i]->tag - 1], &clip[i]);
        }
        set_attributes(draw, vertex, screen);
        qtri_primitive_triangle(&draw->primitive, clip, screen);
    }
}

void qtri_draw_mesh(const qtri_surface *surface, const qtri_view *view, const qtri_transform *pose,
                    const qtri_mesh *mesh, const qtri_material *material)
{
    mesh_draw draw;
    qtri_material used = *material;
    if (mesh->uvs == NULL) {
        used.texture = NULL;
    }
    qtri_primitive_init(&draw.primitive, surface, view, pose, &used);
    draw.view = view;
    draw.mesh = mesh;
    draw.lit = view->light != NULL;
    draw.lit_per_vertex = draw.lit && mesh->normals != NULL && material->shading == QTRI_SMOOTH;
    if (draw.lit) {
        qtri_transform object_to_eye;
        qtri_transform_mul(&object_to_eye, &view->camera, pose);
        qtri_lighting_init(&draw.lighting, view->light, &object_to_eye);
    }
    for (uint32_t i = 0; i < view->vertex_count; i++) {
        view->vertices[i].tag = 0;
    }
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        draw_triangle(&draw, mesh->triangles[i]);
    }
}
