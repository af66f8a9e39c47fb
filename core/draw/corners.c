#include "fill.h"

static void attributes_of(qtri_screen_vertex *out, const qtri_corner *corner)
{
    out->color_8p16[0] = (int32_t)corner->color.r << 16;
    out->color_8p16[1] = (int32_t)corner->color.g << 16;
    out->color_8p16[2] = (int32_t)corner->color.b << 16;
    out->u_q32 = (int64_t)corner->uv.x * 65536;
    out->v_q32 = (int64_t)corner->uv.y * 65536;
}

/* From three corners. */
static void attributes_of_triangle(const void *from, qtri_screen_vertex attributes[3])
{
    const qtri_corner *corners = from;
    for (int i = 0; i < 3; i++) {
        attributes_of(&attributes[i], &corners[i]);
    }
}

/* Transforms `count` corners of one primitive, which then share one scale. */
static void fetch(const qtri_primitive *primitive, const qtri_corner *corners, int count,
                  qtri_clip_vertex v[3])
{
    const qtri_vec4 *position[3];
    for (int i = 0; i < count; i++) {
        position[i] = &corners[i].position;
    }
    qtri_projector_points(&primitive->projector, position, count, v);
}

/* Triangles of a draw call. */
typedef struct soup {
    qtri_primitive primitive;
    const qtri_corner *corners;
    uint32_t count;
} soup;

static void draw_triangles(void *what)
{
    const soup *s = what;
    for (uint32_t i = 0; s->count - i >= 3; i += 3) {
        qtri_shape shape;
        fetch(&s->primitive, &s->corners[i], 3, shape.clip);
        qtri_primitive_triangle(&s->primitive, &shape, attributes_of_triangle, &s->corners[i]);
    }
}

void qtri_draw_triangles(const qtri_surface *surface, const qtri_view *view,
                         const qtri_transform *pose, const qtri_corner *corners,
                         uint32_t corner_count, const qtri_material *material)
{
    const qtri_fill_way *fill = qtri_fill_of(material);
    soup s;
    s.corners = corners;
    s.count = corner_count;
    qtri_primitive_init(&s.primitive, surface, view, pose, material);
    if (fill != NULL) {
        fill->draw(&s.primitive, draw_triangles, &s);
    } else {
        draw_triangles(&s);
    }
}

void qtri_draw_lines(const qtri_surface *surface, const qtri_view *view, const qtri_transform *pose,
                     const qtri_corner *corners, uint32_t corner_count,
                     const qtri_material *material)
{
    qtri_primitive primitive;
    qtri_line_batch batch;
    if (!QTRI_WITH_LINES) {
        return;
    }
    primitive.surface = surface;
    primitive.material = material;
    qtri_primitive_place(&primitive, view, pose);
    qtri_line_job_init(&primitive.to.line, surface, material, &batch);
    for (uint32_t i = 0; corner_count - i >= 2; i += 2) {
        qtri_clip_vertex v[3];
        qtri_screen_vertex attributes[2];
        fetch(&primitive, &corners[i], 2, v);
        attributes_of(&attributes[0], &corners[i]);
        attributes_of(&attributes[1], &corners[i + 1]);
        qtri_primitive_line(&primitive, v, attributes);
    }
    qtri_line_flush(&primitive.to.line);
}
