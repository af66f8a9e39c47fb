/* SPDX-License-Identifier: MIT */
/*
 * For the gate checked.sh: a library with QTRI_CHECKED stops at mistakes, and names the condition.
 * Prints a line for each that it let pass, and ends with their number.
 */
#include <setjmp.h>
#include <stdio.h>
#include <string.h>

#include <qtri.h>

static jmp_buf stopped;
static const char *broken;
static const char *place;
static int place_line;

void checked_fault(const char *condition, const char *file, int line);

void checked_fault(const char *condition, const char *file, int line)
{
    broken = condition;
    place = file;
    place_line = line;
    longjmp(stopped, 1);
}

enum { SIDE = 16 };

/* All that a draw call takes, correct until a case spoils it. */
static uint8_t memory[QTRI_FRAME_BYTES(SIDE, SIDE, QTRI_RGB565_BYTES)];
static qtri_surface surface;
static qtri_frame frame;
static qtri_prepared prepared;
static qtri_view view;
static qtri_transform pose;
static qtri_material material;
static qtri_texture texture;
static qtri_mesh mesh;
static qtri_corner corners[6];
static qtri_vertex vertices[3];
static uint16_t triangles[2][3];
static const qtri_vec3 positions[3] = {{0, 0, 0}, {Q16_ONE, 0, 0}, {0, Q16_ONE, 0}};
static const uint16_t texels[4] = {1, 2, 3, 4};

static void begin(void)
{
    static const uint16_t right[2][3] = {{0, 1, 2}, {2, 1, 0}};
    const qtri_mesh good = {.positions = positions,
                            .triangles = (const uint16_t(*)[3])triangles,
                            .vertex_count = 3,
                            .triangle_count = 2};
    const qtri_texture image = {
        .texels = texels, .format = &qtri_texel_rgb565, .width_log2 = 1, .height_log2 = 1};
    memcpy(triangles, right, sizeof right);
    (void)qtri_surface_init(&surface, &qtri_rgb565, SIDE, SIDE, 0, SIDE, memory, sizeof memory);
    (void)qtri_frame_init(&frame, &qtri_rgb565, SIDE, SIDE, SIDE, memory, sizeof memory);
    qtri_prepared_init(&prepared, vertices, 3, NULL, 0);
    qtri_view_init(&view, SIDE, SIDE);
    view.vertices = vertices;
    view.vertex_count = 3;
    qtri_transform_identity(&pose);
    material = qtri_material_default();
    texture = image;
    material.texture = &texture;
    mesh = good;
}

/* Everything that can be called, in turn. */
static void draw_all(void)
{
    qtri_surface band;
    const qtri_screen_vertex screen[3] = {{.x_24p8 = 0}, {.x_24p8 = 999}, {.y_24p8 = 999}};
    qtri_draw_mesh(&surface, &view, &pose, &mesh, &material);
    qtri_draw_triangles(&surface, &view, &pose, corners, 6, &material);
    qtri_draw_lines(&surface, &view, &pose, corners, 4, &material);
    qtri_raster_triangle(&surface, &material, screen);
    qtri_raster_line(&surface, &material, screen);
    qtri_frame_begin(&frame);
    qtri_prepare_mesh(&prepared, &frame, &view, &pose, &mesh, &material);
    qtri_prepared_mark(&prepared, &frame);
    while (qtri_frame_next_band(&frame, &band)) {
        qtri_draw_prepared(&band, &prepared);
    }
}

static int failures;
static int cases;

/* STATEMENT is a mistake: what stops it has this text in its condition. */
#define STOPS(text, statement)                                                                     \
    do {                                                                                           \
        begin();                                                                                   \
        broken = NULL;                                                                             \
        if (setjmp(stopped) == 0) {                                                                \
            statement;                                                                             \
        }                                                                                          \
        judge(#statement, text);                                                                   \
    } while (0)

static void judge(const char *statement, const char *text)
{
    cases++;
    if (broken == NULL) {
        printf("nothing stopped: %s\n", statement);
        failures++;
    } else if (strstr(broken, text) == NULL || strstr(place, "core/") == NULL || place_line < 1) {
        printf("%s:%d: %s stopped: %s\n", place, place_line, broken, statement);
        failures++;
    }
}

static void null_pointers(void)
{
    STOPS("surface != NULL", qtri_draw_mesh(NULL, &view, &pose, &mesh, &material));
    STOPS("view != NULL", qtri_draw_mesh(&surface, NULL, &pose, &mesh, &material));
    STOPS("pose != NULL", qtri_draw_mesh(&surface, &view, NULL, &mesh, &material));
    STOPS("mesh != NULL", qtri_draw_mesh(&surface, &view, &pose, NULL, &material));
    STOPS("material != NULL", qtri_draw_mesh(&surface, &view, &pose, &mesh, NULL));
    STOPS("corners != NULL", qtri_draw_triangles(&surface, &view, &pose, NULL, 3, &material));
    STOPS("corners != NULL", qtri_draw_lines(&surface, &view, &pose, NULL, 2, &material));
    STOPS("v != NULL", qtri_raster_triangle(&surface, &material, NULL));
    STOPS("v != NULL", qtri_raster_line(&surface, &material, NULL));
    STOPS("surface != NULL",
          (void)qtri_surface_init(NULL, &qtri_gray8, 1, 1, 0, 1, memory, sizeof memory));
    STOPS("frame != NULL", qtri_frame_begin(NULL));
    STOPS("prepared != NULL", qtri_prepare_mesh(NULL, &frame, &view, &pose, &mesh, &material));
    STOPS("prepared != NULL", qtri_draw_prepared(&surface, NULL));
    STOPS("lists != NULL", qtri_prepared_init(&prepared, vertices, 3, NULL, 9));
    STOPS("out != NULL", qtri_transform_mul(NULL, &pose, &pose));
    STOPS("vertices != NULL", (view.vertices = NULL, draw_all()));
    STOPS("positions != NULL", (mesh.positions = NULL, draw_all()));
    STOPS("triangles != NULL", (mesh.triangles = NULL, draw_all()));
    STOPS("pixels != NULL", (surface.pixels = NULL, draw_all()));
}

/* What else draws, and what makes ready for it. */
static void more_null_pointers(void)
{
    const qtri_brush brush = {{1, 2, 3}, 255, NULL};
    const qtri_area box = {0, 0, 999, 999};
    const qtri_point point[3] = {{0, 0}, {999, 0}, {0, 999}};
    const qtri_stroke stroke = {.width = 512};
    qtri_outline outline;
    STOPS("surface != NULL", qtri_paint_rect(NULL, &box, &brush));
    STOPS("box != NULL", qtri_paint_rect(&surface, NULL, &brush));
    STOPS("brush != NULL", qtri_paint_rect(&surface, &box, NULL));
    STOPS("box != NULL", qtri_paint_rect_outline(&surface, NULL, 256, &brush));
    STOPS("box != NULL", qtri_paint_round_rect(&surface, NULL, 256, &brush));
    STOPS("box != NULL", qtri_paint_round_rect_outline(&surface, NULL, 256, 256, &brush));
    STOPS("center != NULL", qtri_paint_circle(&surface, NULL, 999, &brush));
    STOPS("center != NULL", qtri_paint_arc(&surface, NULL, 999, 256, 0, Q16(90), &brush));
    STOPS("point != NULL", qtri_paint_polygon(&surface, NULL, 3, &brush));
    STOPS("brush != NULL", qtri_paint_polygon(&surface, point, 3, NULL));
    STOPS("to != NULL", qtri_paint_stroke(&surface, point, NULL, 256, &brush));
    STOPS("image != NULL", qtri_image_paint(&surface, NULL, 0, 0));
    STOPS("image != NULL", qtri_image_blend(&surface, NULL, 0, 0, 99));
    STOPS("font != NULL", (void)qtri_text_paint(&surface, NULL, 0, 9, "a", &brush));
    STOPS("text != NULL", (void)qtri_text_paint(&surface, &qtri_font_small, 0, 9, NULL, &brush));
    STOPS("text != NULL", (void)qtri_text_width(&qtri_font_small, NULL));
    STOPS("view != NULL", qtri_view_init(NULL, SIDE, SIDE));
    STOPS("out != NULL", qtri_transform_identity(NULL));
    STOPS("out != NULL", (void)qtri_halve(&surface, NULL));
    STOPS("band != NULL", (void)qtri_halve_565(NULL, &surface));
    STOPS("samples != NULL", (void)qtri_samples_resolve(NULL, &surface));
    STOPS("surface != NULL", qtri_samples_clear(NULL, brush.color));
    STOPS("stroke != NULL",
          qtri_draw_polyline(&surface, &view, &pose, corners, 3, NULL, &material));
    STOPS("corners != NULL",
          qtri_draw_wide_lines(&surface, &view, &pose, NULL, 2, &stroke, &material));
    STOPS("view != NULL", qtri_draw_points(&surface, NULL, &pose, corners, 1, &stroke, &material));
    STOPS("stroke != NULL",
          qtri_draw_wide_wireframe(&surface, &view, &pose, &mesh, NULL, &material));
    STOPS("mesh != NULL",
          qtri_draw_hidden_lines(&surface, &view, &pose, NULL, &stroke, &material, 0));
    STOPS("mesh != NULL", (void)qtri_outline_init(&outline, NULL, NULL, 0));
    STOPS("outline != NULL",
          (void)qtri_draw_mesh_outlined(&surface, &view, &pose, &material, NULL));
}

static void wrong_numbers(void)
{
    const qtri_stroke stroke = {.width = 512};
    STOPS("count % each == 0",
          qtri_draw_wide_lines(&surface, &view, &pose, corners, 3, &stroke, &material));
    STOPS("index < mesh->vertex_count",
          (triangles[1][2] = 3,
           qtri_draw_wide_wireframe(&surface, &view, &pose, &mesh, &stroke, &material)));
    STOPS("index < mesh->vertex_count", (triangles[1][2] = 3, draw_all()));
    STOPS("interpolation", (material.interpolation = (qtri_interpolation)2, draw_all()));
    STOPS("texture_mode", (material.texture_mode = (qtri_texture_mode)7, draw_all()));
    STOPS("cull", (material.cull = (qtri_cull)3, draw_all()));
    STOPS("depth_compare", (material.depth_compare = (qtri_compare)9, draw_all()));
    STOPS("wrap_v", (texture.wrap_v = (qtri_wrap)2, draw_all()));
    STOPS("width_log2", (texture.width_log2 = 11, draw_all()));
    STOPS("usable", (texture.texels = NULL, draw_all()));
    STOPS("format != NULL", (texture.format = NULL, draw_all()));
    STOPS("count % each == 0", qtri_draw_triangles(&surface, &view, &pose, corners, 4, &material));
    STOPS("count % each == 0", qtri_draw_lines(&surface, &view, &pose, corners, 3, &material));
    STOPS("is_zero(pose)", (memset(&pose, 0, sizeof pose), draw_all()));
    STOPS("view->camera", (memset(&view.camera, 0, sizeof view.camera), draw_all()));
    STOPS("viewport->width", (view.viewport.width = Q16(320), draw_all()));
    STOPS("depth_far", (view.viewport.depth_far = 1, draw_all()));
    STOPS("surface->height", (surface.height = QTRI_SURFACE_MAX + 1, draw_all()));
}

/* Q16() forgotten, and projections of nothing. */
static void plain_numbers(void)
{
    qtri_transform *const to = &view.projection;
    STOPS("fovy", qtri_transform_perspective(to, 60, Q16(1), Q16(.1), Q16(100)));
    STOPS("fovy", qtri_transform_perspective(to, Q16(180), Q16(1), Q16(.1), Q16(100)));
    STOPS("aspect", qtri_transform_perspective(to, Q16(60), 4 / 3, Q16(.1), Q16(100)));
    STOPS("near_z", qtri_transform_perspective(to, Q16(60), Q16(1), 0, Q16(100)));
    STOPS("near_z", qtri_transform_frustum(to, 0, 1, 0, 1, 0, Q16(9)));
    STOPS("left != right", qtri_transform_ortho(to, 0, 1 / 2, 0, 1, 0, Q16(9)));
    STOPS("depth != 1", qtri_surface_clear_depth(&surface, 1));
    STOPS("near_z", qtri_transform_perspective_d3d(to, Q16(60), Q16(1), Q16(1), Q16(1)));
}

int main(void)
{
    begin();
    if (setjmp(stopped) == 0) { /* what is correct is let pass */
        draw_all();
        qtri_transform_perspective(&view.projection, Q16(60), Q16(1), Q16(.1), Q16(100));
        surface.format = NULL;
        draw_all();
    } else {
        printf("%s:%d: %s stopped a correct program\n", place, place_line, broken);
        failures++;
    }
    null_pointers();
    more_null_pointers();
    wrong_numbers();
    plain_numbers();
    printf("%d mistakes, %d not found\n", cases, failures);
    return failures != 0;
}
