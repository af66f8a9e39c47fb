/* SPDX-License-Identifier: MIT */
/*
 * For the gate checked.sh: a library with QTRI_CHECKED stops at mistakes, and names the condition.
 * Prints a line for each that it let pass, and ends with their number.
 */
#include <setjmp.h>
#include <stdio.h>
#include <string.h>

#include <qtri.h>
#include <qtri_port/completion.h>
#include <qtri_port/i2c.h>
#include <qtri_port/ili9341.h>
#include <qtri_port/tearing.h>

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

/* What a list of pipelines lacked. */
static qtri_options missing;

void checked_missing(const qtri_options *wanted);

void checked_missing(const qtri_options *wanted)
{
    missing = *wanted;
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
    qtri_prepared_init(&prepared, vertices, sizeof vertices);
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
    qtri_raster_triangle(&surface, qtri_pipelines_default, &material, screen);
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
    } else if (strstr(broken, text) == NULL ||
               (strstr(place, "core/") == NULL && strstr(place, "port/") == NULL) ||
               place_line < 1) {
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
    STOPS("v != NULL", qtri_raster_triangle(&surface, qtri_pipelines_default, &material, NULL));
    STOPS("v != NULL", qtri_raster_line(&surface, &material, NULL));
    STOPS("surface != NULL",
          (void)qtri_surface_init(NULL, &qtri_gray8, 1, 1, 0, 1, memory, sizeof memory));
    STOPS("frame != NULL", qtri_frame_begin(NULL));
    STOPS("prepared != NULL", qtri_prepare_mesh(NULL, &frame, &view, &pose, &mesh, &material));
    STOPS("prepared != NULL", qtri_draw_prepared(&surface, NULL));
    STOPS("memory != NULL", qtri_prepared_init(&prepared, NULL, 9));
    STOPS("out != NULL", qtri_transform_mul(NULL, &pose, &pose));
    STOPS("vertices != NULL", (view.vertices = NULL, draw_all()));
    STOPS("positions != NULL", (mesh.positions = NULL, draw_all()));
    STOPS("triangles != NULL", (mesh.triangles = NULL, draw_all()));
    STOPS("pixels != NULL", (surface.pixels = NULL, draw_all()));
}

/* What else draws, and what makes ready for it. */
static void pipelines_that_lack(void)
{
    static const qtri_pipeline *const none[] = {NULL};
    static const qtri_pipeline *const others[] = {&qtri_pipeline_lit, &qtri_pipeline_swapped_flat,
                                                  NULL};
    STOPS("found != NULL", (view.pipelines = NULL, draw_all()));
    STOPS("found != NULL", (view.pipelines = none, draw_all()));
    missing.format = QTRI_ANY;
    STOPS("found != NULL", (view.pipelines = others,
                            qtri_draw_triangles(&surface, &view, &pose, corners, 3, &material)));
    if (missing.format != QTRI_RGB565 || missing.depth != QTRI_LINEAR16 ||
        missing.compare != QTRI_LESS || missing.texel != QTRI_TEXEL_RGB565) {
        printf("what is missing was not said\n");
        failures++;
    }
}

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
    STOPS("band != NULL", (void)qtri_halve(NULL, &surface));
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
    STOPS("has_zero_w(pose)", (memset(&pose, 0, sizeof pose), draw_all()));
    STOPS("view->camera", (memset(&view.camera, 0, sizeof view.camera), draw_all()));
    STOPS("viewport->width", (view.viewport.width = Q16(320), draw_all()));
    STOPS("viewport->width", (view.viewport.width = 0, draw_all()));
    STOPS("viewport->height", (view.viewport.height = 0, draw_all()));
    STOPS("viewport->height", (view.viewport.height = -1, draw_all()));
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

static void lights(void)
{
    static qtri_light_source lamp[1];
    static const qtri_light one = {.towards = {0, 0, Q16_ONE}, .ambient = 0, .diffuse = 1};
    const qtri_light_color dim = {Q16(.1), Q16(.1), Q16(.1)};
    const qtri_light_color plain = {1, 1, 1};
    const qtri_light_source good = {.kind = &qtri_spot_light, .outer = Q16(30)};
    const qtri_light never = {.count = 1};
    qtri_light of;
    qtri_uv16 uvs[3];
    lamp[0] = good;
    STOPS("light != NULL", (void)qtri_light_init(NULL, lamp, 1, dim));
    STOPS("sources != NULL", (void)qtri_light_init(&of, NULL, 1, dim));
    STOPS("is_color(ambient)", (void)qtri_light_init(&of, lamp, 1, plain));
    STOPS("source->color", (lamp[0].color = plain, (void)qtri_light_init(&of, lamp, 1, dim)));
    lamp[0] = good;
    STOPS("constant", (lamp[0].constant = 1, (void)qtri_light_init(&of, lamp, 1, dim)));
    lamp[0] = good;
    STOPS("is_angle", (lamp[0].outer = 30, (void)qtri_light_init(&of, lamp, 1, dim)));
    STOPS("table != NULL", qtri_shininess_init(NULL, Q16(40)));
    STOPS("light->model", (view.light = &never, draw_all()));
    STOPS("light->diffuse", (view.light = &one, draw_all()));
    STOPS("corners != NULL",
          qtri_draw_lit_triangles(&surface, &view, &pose, NULL, NULL, 3, &material));
    STOPS("uvs != NULL", qtri_sphere_map(NULL, &pose, &pose, &mesh));
    STOPS("camera != NULL", qtri_sphere_map(uvs, NULL, &pose, &mesh));
    STOPS("fog != NULL",
          qtri_fog_exp(NULL, material.color, (qtri_fog_range){Q16(1), Q16(9), false}, Q16(.1)));
}

static void shapes_and_bounds(void)
{
    static qtri_vec3 at[QTRI_BOX_VERTICES];
    static uint16_t of[QTRI_BOX_TRIANGLES][3];
    const qtri_shape_memory good = {at, NULL, NULL, of, QTRI_BOX_VERTICES, QTRI_BOX_TRIANGLES};
    const qtri_shape_memory nowhere = {NULL, NULL, NULL, of, QTRI_BOX_VERTICES, QTRI_BOX_TRIANGLES};
    const qtri_vec3 half = {Q16(1), Q16(1), Q16(1)};
    const qtri_vec3 plain = {1, 2, 3};
    const qtri_ball inside_out = {{0, 0, 0}, -1};
    qtri_clip_vertex v[QTRI_CLIP_MAX] = {{0}};
    STOPS("mesh != NULL", (void)qtri_shape_box(NULL, &good, half));
    STOPS("memory != NULL", (void)qtri_shape_box(&mesh, NULL, half));
    STOPS("memory->positions", (void)qtri_shape_box(&mesh, &nowhere, half));
    STOPS("half.x", (void)qtri_shape_box(&mesh, &good, plain));
    STOPS("radius", (void)qtri_shape_sphere(&mesh, &good, 1, 3, 2));
    STOPS("half_height", (void)qtri_shape_cone(&mesh, &good, Q16(1), 2, 3));
    STOPS("tube", (void)qtri_shape_torus(&mesh, &good, Q16(3), 1, 3, 3));
    STOPS("half_z", (void)qtri_shape_grid(&mesh, &good, Q16(3), 3, 1, 1));
    STOPS("mesh != NULL", (void)qtri_mesh_box(NULL));
    STOPS("mesh != NULL", (void)qtri_mesh_ball(NULL));
    STOPS("box != NULL", (void)qtri_view_sees_box(&view, &pose, NULL));
    STOPS("radius >= 0", (void)qtri_view_sees_ball(&view, &pose, &inside_out));
    STOPS("v != NULL", (void)qtri_clip_outcode(NULL));
    STOPS("count <= 3", (void)qtri_clip_polygon(v, 4, 0));
    STOPS("planes", (void)qtri_clip_polygon(v, 3, 64));
    STOPS("planes", (void)qtri_clip_line(v, 64));
    STOPS("out != NULL", qtri_view_jitter(NULL, &view, 0, 2));
}

static void animations(void)
{
    const qtri_vec3 one = {Q16_ONE, Q16_ONE, Q16_ONE};
    const qtri_vec3 plain = {1, 1, 1};
    const qtri_quat still = {Q16_ONE, 0, 0, 0};
    const qtri_key keys[2] = {{Q16(2), one, still, one}, {Q16(1), one, still, plain}};
    const qtri_key of_two[1] = {{0, one, still, {2, 2, 2}}};
    const int16_t parent[1] = {-1};
    const q16 weight[1] = {0};
    qtri_position16 p[1] = {{0, 0, 0}};
    const qtri_position16 *const nothing[1] = {NULL};
    STOPS("keys != NULL", (void)qtri_keys_at(NULL, 1, 0));
    STOPS("time >=", (void)qtri_keys_at(keys, 2, 0));
    STOPS("key != NULL", qtri_transform_key(&pose, NULL));
    STOPS("is_scale", (void)qtri_keys_at(of_two, 1, 0));
    STOPS("plain_1(factor)", qtri_transform_key(&pose, &keys[1]));
    STOPS("parent != NULL", qtri_poses_compose(&pose, &pose, NULL, 1));
    STOPS("world != NULL", qtri_poses_compose(NULL, &pose, parent, 1));
    STOPS("to != NULL", qtri_morph_positions(p, p, NULL, 1, Q16(.5)));
    STOPS("from != NULL", qtri_morph_normals(NULL, NULL, NULL, 1, Q16(.5)));
    STOPS("weight != NULL", qtri_morph_targets(p, p, nothing, NULL, 1, 1));
    STOPS("target[k]", qtri_morph_targets(p, p, nothing, weight, 1, 1));
    STOPS("frames <= 32767", qtri_frames_positions(p, p, 32768, 1, 0));
}

static void mathematics(void)
{
    const qtri_vec3 v = {Q16(1), Q16(2), Q16(3)};
    qtri_mat3 m3 = qtri_mat3_identity();
    qtri_mat4 m4 = qtri_mat4_identity();
    q16 sine;
    STOPS("cosine != NULL", q16_sincos_deg(Q16(30), &sine, NULL));
    STOPS("text != NULL", (void)q16_from_string(NULL, &sine));
    STOPS("buffer != NULL", (void)q16_to_string(sine, NULL, 9));
    STOPS("a != NULL", (void)qtri_vec_distance(NULL, NULL, 3));
    STOPS("b != NULL", (void)qtri_mat3_mul(&m3, NULL));
    STOPS("a != NULL", (void)qtri_mat4_transpose(NULL));
    STOPS("m != NULL", (void)qtri_mat4_point(NULL, v));
    STOPS("out != NULL", (void)qtri_mat4_inverse(NULL, &m4));
    STOPS("out != v", qtri_mat4_times(m4.m[0], &m4, m4.m[0]));
    STOPS("m != NULL", (void)qtri_quat_from_mat3(NULL));
    STOPS("attitude != NULL", (void)qtri_attitude_quat(NULL));
    STOPS("filter != NULL", qtri_attitude_filter_step(NULL, v, v, 0));
}

static void transforms(void)
{
    const qtri_vec3 v = {Q16(1), Q16(2), Q16(3)};
    const qtri_vec3 plain = {1, 1, 1};
    const qtri_vec3 two = {2, 2, 2};
    const qtri_vec3 flat = {15, -15, 0};
    qtri_affine affine;
    const qtri_vec3 behind = {0, 0, 5};
    const qtri_vec3 zero = {0, 0, 0};
    qtri_transform *const to = &view.projection;
    STOPS("m != NULL", qtri_transform_from_mat4(&pose, NULL));
    STOPS("out != NULL", qtri_transform_to_mat4(&pose, NULL));
    STOPS("t != NULL", qtri_transform_translate(NULL, v));
    STOPS("t != NULL", qtri_transform_rotate_y(NULL, Q16(90)));
    STOPS("v != NULL", qtri_transform_rotate_triangle(&pose, Q16(90), NULL));
    STOPS("camera != NULL", qtri_transform_billboard(&pose, NULL));
    STOPS("t != NULL", qtri_transform_orthonormalize(NULL));
    STOPS("t != NULL", qtri_transform_perspective(NULL, Q16(60), Q16(1), Q16(1), Q16(9)));
    STOPS("plain_1", qtri_transform_scale(&pose, plain));
    STOPS("is_scale", qtri_transform_scale(&pose, two));
    STOPS("is_scale", qtri_transform_scale(&pose, flat));
    STOPS("is_scale", qtri_affine_place(&affine, 0, 0, 0, 0, 2, 2, 0));
    STOPS("is_sight", qtri_transform_look_at(&view.camera, behind, zero, v));
    STOPS("is_sight", qtri_transform_look_at_d3d(&view.camera, behind, zero, v));
    STOPS("distance", qtri_transform_orbit(&view.camera, zero, 5, 0, 0));
    STOPS("near_z", qtri_transform_perspective(to, Q16(60), Q16(1), 1, Q16(100)));
    STOPS("apart(left", qtri_transform_frustum(to, -1, 1, -1, 1, Q16(1), Q16(9)));
    STOPS("apart(near_z", qtri_transform_ortho(to, 0, Q16(320), Q16(240), 0, -1, 1));
}

static void bands_and_filters(void)
{
    qtri_format no_colors = qtri_rgb565;
    const qtri_brush brush = {{1, 2, 3}, 255, NULL};
    qtri_frame overlapped;
    qtri_surface band;
    qtri_edges edges;
    qtri_outline outline;
    qtri_diffusion diffusion;
    qtri_font font = qtri_font_small;
    qtri_texel_format texel = qtri_texel_rgb565;
    qtri_depth_format depth = qtri_depth_float16;
    uint8_t gray[1] = {0};
    no_colors.colors = NULL;
    font.glyphs = NULL;
    texel.kind = QTRI_NO_TEXEL;
    depth.decode = NULL;
    (void)qtri_frame_init(&overlapped, &qtri_rgb565, 4, 4, 4, memory, sizeof memory);
    (void)qtri_frame_set_overlap(&overlapped, 1, NULL, 0);
    STOPS("format->colors",
          (void)qtri_frame_init(&frame, &no_colors, 4, 4, 4, memory, sizeof memory));
    STOPS("decode != NULL", (void)qtri_frame_set_depth(&overlapped, &depth));
    STOPS("frame != NULL", qtri_frame_share(NULL, 0, 2));
    STOPS("frame != NULL", (void)qtri_frame_changes(NULL));
    STOPS("frame != NULL", qtri_frame_begin(NULL));
    STOPS("frame != NULL", (void)qtri_frame_set_overlap(NULL, 1, NULL, 0));
    STOPS("band != NULL", (void)qtri_frame_next_band(&overlapped, NULL));
    STOPS("band != NULL", qtri_frame_join(&overlapped, NULL));
    STOPS("shown != NULL", qtri_frame_shown(&overlapped, &band, NULL));
    STOPS("surface != NULL", (void)qtri_fxaa(NULL, NULL, 0));
    STOPS("memory != NULL", (void)qtri_fxaa(&surface, NULL, 999));
    STOPS("sums != NULL", qtri_sum_clear(NULL, 9));
    STOPS("surface != NULL", (void)qtri_sum_add(NULL, 0, NULL));
    STOPS("sums != NULL", (void)qtri_sum_add(NULL, 999, &surface));
    STOPS("surface != NULL", (void)qtri_sum_store(NULL, NULL, 0, 4));
    STOPS("surface != NULL", (void)qtri_edges_begin(&edges, NULL, NULL, 0));
    STOPS("edges != NULL", qtri_edges_blend(NULL));
    STOPS("outline != NULL", qtri_edges_note(&edges, NULL));
    STOPS("prepared != NULL", qtri_prepared_set_outline(NULL, NULL));
    STOPS("prepared != NULL", (void)qtri_prepared_find_edges(NULL, &outline));
    STOPS("gray != NULL", qtri_surface_gray(&surface, 0, 0, 1, NULL));
    STOPS("level != NULL", qtri_dither_row(QTRI_DITHER_BAYER4, 1, 0, 0, gray, 1, NULL));
    STOPS("error != NULL", (void)qtri_diffusion_init(&diffusion, 1, NULL, 1));
    STOPS("diffusion != NULL", qtri_diffuse_row(NULL, 1, 0, 0, gray, 1, gray));
    STOPS("font->glyphs", (void)qtri_text_paint(&surface, &font, 0, 9, "a", &brush));
    STOPS("font->glyphs", (void)qtri_font_glyph(&font, 'a'));
    STOPS("text != NULL", (void)qtri_text_next(NULL));
    STOPS("affine != NULL", qtri_affine_place(NULL, 0, 0, 0, 0, Q16_ONE, Q16_ONE, 0));
    STOPS("surface != NULL", (void)qtri_image_of(NULL));
    STOPS("fetch != NULL", (texture.format = &texel, draw_all()));
}

/* Pixels in place of 1/256 of them, on a frame of 16 x 16 and on one of 320 x 240. */
static void plain_pixels(void)
{
    const qtri_brush brush = {{1, 2, 3}, 255, NULL};
    const qtri_area right = {QTRI_PX(1), QTRI_PX(1), QTRI_PX(9), QTRI_PX(9)};
    const qtri_area box = {2, 3, 10, 12};
    const qtri_area screen = {0, 0, 320, 240};
    const qtri_point center = {8, 8};
    const qtri_point middle = {QTRI_PX(8), QTRI_PX(8)};
    const qtri_point point[3] = {{1, 2}, {15, 3}, {4, 12}};
    const qtri_surface wide = {.width = 320, .height = 240};
    STOPS("is_plain_area", qtri_paint_rect(&surface, &box, &brush));
    STOPS("is_plain_area", qtri_paint_rect(&wide, &screen, &brush));
    STOPS("is_plain_area", qtri_paint_rect_outline(&surface, &box, QTRI_PX(1), &brush));
    STOPS("is_plain_area", qtri_paint_round_rect(&surface, &box, QTRI_PX(1), &brush));
    STOPS("is_plain_area", qtri_paint_round_rect_outline(&surface, &box, 0, QTRI_PX(1), &brush));
    STOPS("is_plain_area", qtri_paint_circle(&surface, &center, 5, &brush));
    STOPS("is_plain_area", qtri_paint_ring(&surface, &center, 5, 2, &brush));
    STOPS("is_plain_area", qtri_paint_arc(&surface, &center, 5, 2, 0, Q16(90), &brush));
    STOPS("is_plain_area", qtri_paint_polygon(&surface, point, 3, &brush));
    STOPS("is_plain_area", qtri_paint_stroke(&surface, &point[0], &point[1], QTRI_PX(1), &brush));
    STOPS("width_24p8", qtri_paint_rect_outline(&surface, &right, 1, &brush));
    STOPS("width_24p8", qtri_paint_round_rect_outline(&surface, &right, 0, 15, &brush));
    STOPS("width_24p8", qtri_paint_ring(&surface, &middle, QTRI_PX(5), 2, &brush));
    STOPS("width_24p8", qtri_paint_arc(&surface, &middle, QTRI_PX(5), 2, 0, Q16(90), &brush));
    STOPS("width_24p8", qtri_paint_stroke(&surface, &middle, &point[0], 2, &brush));
}

/* What is small and meant: nothing stops. */
static void small_shapes(void)
{
    const qtri_brush brush = {{1, 2, 3}, 255, &qtri_ink_smooth};
    const qtri_surface wide = {.width = 320, .height = 240};
    const qtri_area first = {0, 0, QTRI_PX(1), QTRI_PX(1)};
    const qtri_area half = {0, 0, QTRI_PX(.5), QTRI_PX(.5)};
    const qtri_area elsewhere = {QTRI_PX(2) + 3, 5, QTRI_PX(2) + 8, 9};
    const qtri_area cut_off = {-3, 2, 9, 8};
    const qtri_area empty = {9, 9, 9, 9};
    const qtri_point side[3] = {{0, 0}, {QTRI_PX(1), 0}, {0, QTRI_PX(1)}};
    const qtri_point tiny[3] = {{QTRI_PX(8), 9}, {QTRI_PX(8) + 9, 9}, {QTRI_PX(8), 15}};
    qtri_paint_rect(&surface, &first, &brush);
    qtri_paint_rect(&wide, &first, &brush);
    qtri_paint_rect(&wide, &half, &brush);
    qtri_paint_rect(&surface, &elsewhere, &brush);
    qtri_paint_rect(&surface, &cut_off, &brush);
    qtri_paint_rect(&surface, &empty, &brush);
    qtri_paint_rect_outline(&wide, &first, 64, &brush);
    qtri_paint_rect_outline(&surface, &first, 16, &brush);
    qtri_paint_rect_outline(&surface, &first, 0, &brush);
    qtri_paint_round_rect(&surface, &elsewhere, 1, &brush);
    qtri_paint_circle(&surface, &tiny[0], 1, &brush);
    qtri_paint_circle(&surface, &side[0], 2, &brush);
    qtri_paint_ring(&surface, &tiny[0], 9, 9, &brush);
    qtri_paint_arc(&surface, &tiny[0], 999, 16, 0, Q16(360), &brush);
    qtri_paint_polygon(&surface, side, 3, &brush);
    qtri_paint_polygon(&surface, tiny, 3, &brush);
    qtri_paint_stroke(&wide, &side[0], &side[1], QTRI_PX(1), &brush);
    qtri_paint_stroke(&surface, &tiny[0], &tiny[1], 16, &brush);
    qtri_paint_stroke(&surface, &tiny[0], &tiny[0], 0, &brush);
}

/* Beside what stops, as near as error.h says. */
static void small_numbers(void)
{
    static const q16 widths[] = {512, QTRI_STROKE_WIDTH_MAX * Q16_ONE, 0, -1};
    const qtri_screen_vertex screen[2] = {{.x_24p8 = 0}, {.x_24p8 = 999}};
    const qtri_vec3 small = {16, 16, 16};
    const qtri_vec3 flat = {Q16(2), 2, -2};
    const qtri_vec3 none = {0, 0, 0};
    const qtri_vec3 mirror = {-16, 0, 0};
    const qtri_vec3 one = {Q16_ONE, Q16_ONE, Q16_ONE};
    const qtri_key grows[2] = {{0, none, {Q16_ONE, 0, 0, 0}, none},
                               {Q16_ONE, none, {Q16_ONE, 0, 0, 0}, one}};
    const qtri_key hardly = qtri_keys_at(grows, 2, 2);
    static qtri_prepared zeros;
    qtri_outline outline;
    qtri_affine affine;
    qtri_stroke stroke = qtri_stroke_default();
    for (size_t i = 0; i < sizeof widths / sizeof widths[0]; i++) {
        stroke.width = widths[i];
        qtri_draw_polyline(&surface, &view, &pose, corners, 3, &stroke, &material);
        qtri_raster_polyline(&surface, &material, &stroke, screen, 2);
    }
    stroke.width = 16;
    stroke.in_space = true;
    qtri_draw_points(&surface, &view, &pose, corners, 1, &stroke, &material);
    qtri_transform_scale(&pose, small);
    qtri_transform_scale(&pose, flat);
    qtri_transform_scale(&pose, mirror);
    qtri_transform_scale(&pose, none);
    qtri_transform_key(&pose, &hardly);
    qtri_affine_place(&affine, 0, 0, 0, 0, 16, 2, 0);
    qtri_affine_place(&affine, 0, 0, 0, 0, 0, 0, 0);
    qtri_transform_identity(&pose);
    view.viewport = qtri_viewport_top(3, 3, 1, 1);
    draw_all();
    memset(&prepared, 0xA5, sizeof prepared);
    qtri_prepared_init(&prepared, NULL, 0);
    qtri_draw_prepared(&surface, &prepared);
    draw_all();
    (void)qtri_outline_init(&outline, &mesh, NULL, 0);
    qtri_prepared_set_outline(&prepared, NULL);
    (void)qtri_prepared_find_edges(&prepared, &outline);
    qtri_draw_prepared(&surface, &zeros);
}

/* One that was never initialised. */
static void make_garbage(int byte)
{
    memset(&prepared, byte, sizeof prepared);
}

static void garbage(int byte)
{
    static qtri_outline outline;
    STOPS("is_whole", (make_garbage(byte), draw_all()));
    STOPS("is_whole", (make_garbage(byte), qtri_draw_prepared(&surface, &prepared)));
    STOPS("is_whole", (make_garbage(byte), qtri_prepared_mark(&prepared, &frame)));
    STOPS("is_whole", (make_garbage(byte), qtri_prepared_set_outline(&prepared, NULL)));
    STOPS("is_whole", (make_garbage(byte), (void)qtri_prepared_find_edges(&prepared, &outline)));
    STOPS("is_whole", (prepared.mesh = &mesh, qtri_draw_prepared(&surface, &prepared)));
    STOPS("is_whole", (prepared.overlap = QTRI_OVERLAP_MAX + 1, draw_all()));
}

/* Widths of strokes. */
static void plain_widths(void)
{
    const qtri_screen_vertex screen[2] = {{.x_24p8 = 0}, {.x_24p8 = 999}};
    qtri_stroke two = qtri_stroke_default();
    qtri_stroke in_space = two;
    two.width = 2;
    in_space.width = 15;
    in_space.in_space = true;
    STOPS("is_width", qtri_draw_wide_lines(&surface, &view, &pose, corners, 2, &two, &material));
    STOPS("is_width", qtri_draw_polyline(&surface, &view, &pose, corners, 3, &two, &material));
    STOPS("is_width", qtri_draw_points(&surface, &view, &pose, corners, 1, &two, &material));
    STOPS("is_width", qtri_draw_points(&surface, &view, &pose, corners, 1, &in_space, &material));
    STOPS("is_width", qtri_draw_wide_wireframe(&surface, &view, &pose, &mesh, &two, &material));
    STOPS("is_width", qtri_draw_hidden_lines(&surface, &view, &pose, &mesh, &two, &material, 0));
    STOPS("is_width", qtri_raster_polyline(&surface, &material, &two, screen, 2));
    STOPS("is_width", (two.width = 511, qtri_raster_point(&surface, &material, &two, screen)));
}

static bool sends(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    (void)bytes;
    (void)count;
    return true;
}

static bool is_done(void *context)
{
    (void)context;
    return true;
}

static void waits(void *context, uint32_t ms)
{
    (void)context;
    (void)ms;
}

static const qtri_bus right_bus = {.command = sends, .data = sends, .wait_ms = waits};

static enum qtri_error init_panel(const qtri_bus *bus)
{
    static uint8_t line[QTRI_PANEL_LINE_BYTES(240)];
    static qtri_panel panel;
    return qtri_panel_init(&panel, &qtri_ili9341, bus, QTRI_ROTATE_0, line, sizeof line);
}

static void panels(void)
{
    qtri_panel panel = {.description = &qtri_ili9341};
    const qtri_panel none = {.description = NULL};
    qtri_completion completion;
    qtri_bus bus = right_bus;
    qtri_i2c i2c = {.write = NULL, .wait_ms = waits, .bytes = QTRI_I2C_BYTES};
    STOPS("panel != NULL",
          (void)qtri_panel_init(NULL, &qtri_ili9341, &bus, QTRI_ROTATE_0, memory, sizeof memory));
    STOPS("description != NULL",
          (void)qtri_panel_init(&panel, NULL, &bus, QTRI_ROTATE_0, memory, sizeof memory));
    panel.description = &qtri_ili9341;
    STOPS("memory != NULL",
          (void)qtri_panel_init(&panel, &qtri_ili9341, &bus, QTRI_ROTATE_0, NULL, 99));
    bus.command = NULL;
    STOPS("command != NULL", (void)init_panel(&bus));
    bus = right_bus;
    bus.data = NULL;
    STOPS("data != NULL", (void)init_panel(&bus));
    bus = right_bus;
    bus.wait_ms = NULL;
    STOPS("wait_ms != NULL", (void)init_panel(&bus));
    bus = right_bus;
    bus.data_finish = is_done;
    STOPS("data_start == NULL", (void)init_panel(&bus));
    bus = right_bus;
    bus.most_bytes = 17;
    STOPS("most_bytes", (void)init_panel(&bus));
    STOPS("description != NULL", (void)qtri_panel_width(&none));
    STOPS("surface != NULL", (void)qtri_panel_write(&panel, NULL));
    STOPS("panel != NULL", (void)qtri_panel_finish(NULL));
    STOPS("panel != NULL", (void)qtri_panel_refresh(NULL));
    STOPS("steps != NULL", (void)qtri_panel_send(&panel, NULL, 1));
    STOPS("is_high != NULL", (void)qtri_tearing_wait(&panel, NULL, 1));
    STOPS("write != NULL", (void)qtri_i2c_bus(&bus, &i2c));
    i2c.write = sends;
    STOPS("buffer != NULL", (void)qtri_i2c_bus(&bus, &i2c));
    STOPS("done != NULL", (void)qtri_completion_init(&completion, &bus, NULL, NULL));
    STOPS("completion != NULL", qtri_completion_sent(NULL));
}

int main(void)
{
    begin();
    if (setjmp(stopped) == 0) { /* what is correct is let pass */
        draw_all();
        qtri_transform_perspective(&view.projection, Q16(60), Q16(1), Q16(.1), Q16(100));
        surface.format = NULL;
        draw_all();
        failures += init_panel(&right_bus) != QTRI_OK;
        begin();
        small_shapes();
        small_numbers();
    } else {
        printf("%s:%d: %s stopped a correct program\n", place, place_line, broken);
        failures++;
    }
    null_pointers();
    more_null_pointers();
    pipelines_that_lack();
    wrong_numbers();
    plain_numbers();
    plain_pixels();
    plain_widths();
    garbage(0xFF);
    garbage(0xA5);
    garbage(0x01);
    lights();
    shapes_and_bounds();
    animations();
    mathematics();
    transforms();
    bands_and_filters();
    panels();
    printf("%d mistakes, %d not found\n", cases, failures);
    return failures != 0;
}
