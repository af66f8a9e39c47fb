/* SPDX-License-Identifier: MIT */
#include "scene_view.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../reference/matrix.h"
#include "../reference/reference.h"
#include "../reference/reference_picture.h"
#include "compare.h"
#include "scene_cost.h"
#include "scene_draw.h"

enum { MODES = 3, FORMATS = 3, ANTIALIAS_KINDS = SCENE_ANTIALIAS_MSAA + 2, TURN = 5 };

static const struct {
    const char *name;
    const qtri_format *core;
    enum reference_format reference;
    enum scene_pixels pixels;
} formats[FORMATS] = {
    {"RGB888", &qtri_xrgb8888, REFERENCE_RGB888, SCENE_XRGB8888},
    {"RGB565", &qtri_rgb565, REFERENCE_RGB565, SCENE_RGB565},
    {"GRAY8", &qtri_gray8, REFERENCE_GRAY8, SCENE_GRAY8},
};

/* The eye of a camera around what it looks at: by azimuth about `up`, then up and down. */
static void turn_lookat(int32_t number[9], const struct scene_view *view)
{
    double arm[4] = {0}, up[3], side[3];
    for (int i = 0; i < 3; i++) {
        arm[i] = (double)number[i] - number[3 + i];
        up[i] = number[6 + i];
    }
    const struct ref_matrix turn = ref_matrix_rotate(view->azimuth, up);
    ref_matrix_transform(&turn, arm, arm);
    ref_cross3(arm, up, side);
    const struct ref_matrix lift = ref_matrix_rotate(view->elevation, side);
    ref_matrix_transform(&lift, arm, arm);
    for (int i = 0; i < 3; i++) {
        const double eye = number[3 + i] + arm[i];
        number[i] = (int32_t)lrint(fmin(fmax(eye, -2147483647.0), 2147483647.0));
    }
}

/* Turns the cameras that the scene has; false where it has none. */
static bool turn_cameras(struct scene *scene, const struct scene_view *view)
{
    bool found = false;
    for (; scene != NULL; scene = scene->next) {
        for (size_t i = 0; i < scene->op_count; i++) {
            struct scene_op *op = &scene->ops[i];
            if (op->kind == SCENE_LOOKAT || op->kind == SCENE_LOOKAT_D3D) {
                found = true;
                if (view->azimuth != 0 || view->elevation != 0) {
                    turn_lookat(op->u.number, view);
                }
            } else if (op->kind == SCENE_ORBIT) {
                found = true;
                op->u.number[4] += view->azimuth * 65536;
                op->u.number[5] += view->elevation * 65536;
            }
        }
    }
    return found;
}

static void count(const struct scene *scene, const struct scene_view *view,
                  const struct picture *core, struct scene_figures *figures)
{
    const size_t all = (size_t)core->width * (size_t)core->height;
    const size_t rows = (size_t)(view->band_rows > 0 ? view->band_rows : scene->height);
    figures->width = core->width;
    figures->height = core->height;
    figures->triangles = scene->triangle_count;
    figures->pixels = 0;
    for (size_t i = 0; i < all; i++) {
        figures->pixels += core->id[i] != 0;
    }
    figures->band_bytes =
        QTRI_BAND_BYTES(scene->width, rows, formats[view->format].core->pixels->bytes);
    figures->vertex_bytes = 0;
    for (size_t i = 0; i < scene->mesh_count; i++) {
        const size_t bytes = scene->meshes[i].vertex_count * sizeof(qtri_vertex);
        figures->vertex_bytes = bytes > figures->vertex_bytes ? bytes : figures->vertex_bytes;
    }
    figures->m0plus = figures->m3 = 0;
    figures->error = 0;
    struct scene_load load = {.format = formats[view->format].pixels,
                              .rows = view->band_rows,
                              .triangles = (double)figures->triangles,
                              .pixels = (double)figures->pixels,
                              .screen = (double)all};
    if (scene->next == NULL && scene_load_pass(&load, scene)) {
        const struct scene_cost cost = scene_cost(&load);
        figures->m0plus = cost.m0plus;
        figures->m3 = cost.m3;
        figures->error = cost.error;
    }
}

static bool draw_exact(const struct scene *scene, const struct scene_view *view,
                       struct picture *picture)
{
    struct reference_image image = {0};
    const bool ok = reference_render(scene, 0, &image) &&
                    reference_picture(&image, formats[view->format].reference, picture);
    reference_free(&image);
    return ok;
}

/* The core is always drawn, as it tells which pixels are covered. */
static bool draw(const struct scene *scene, const struct scene_view *view, struct picture *picture,
                 struct scene_figures *figures)
{
    struct picture core = {0}, exact = {0};
    bool ok = scene_render(scene, formats[view->format].core, view->band_rows, true, &core);
    if (ok) {
        count(scene, view, &core, figures);
    }
    if (ok && view->mode == SCENE_VIEW_CORE) {
        *picture = core;
        return true;
    }
    ok = ok && draw_exact(scene, view, view->mode == SCENE_VIEW_DOUBLE ? picture : &exact) &&
         (view->mode == SCENE_VIEW_DOUBLE || compare_difference(&core, &exact, picture));
    picture_free(&core);
    picture_free(&exact);
    return ok;
}

bool scene_view_draw(const struct scene_view *view, const char *path, struct picture *picture,
                     struct scene_figures *figures, struct text_error *error)
{
    const struct scene_reading how = {.time = view->time};
    struct scene scene;
    if (!scene_read_as(path, &how, &scene, error)) {
        return false;
    }
    figures->can_turn = turn_cameras(&scene, view);
    scene.wireframe = scene.wireframe || view->wireframe != 0;
    if (view->antialias > 0) {
        scene.antialias = (enum scene_antialias)(view->antialias - 1);
    }
    const bool ok = draw(&scene, view, picture, figures);
    if (!ok) {
        text_error_set(error, path, 0, "out of memory");
    }
    scene_free(&scene);
    return ok;
}

const char *const scene_view_keys[] = {
    "  arrows or h j k l  turn the camera",
    "  m  fixed point, double precision, their difference",
    "  f  format: RGB888, RGB565, GRAY8",
    "  b  bands: none, 16 rows, 8 rows",
    "  w  wireframe",
    "  a  anti-aliasing: as the scene, off, edges, ssaa, fxaa, temporal, msaa",
    "  .  a step of the time $t, and , back; space: runs and stops",
    "  r  everything but the format as at first",
    "  q or Escape  the end",
    NULL,
};

/* Kept small: a turn more is the same. */
static int turned(int degrees, int by)
{
    return (degrees + by) % 360;
}

int scene_view_key(struct scene_view *view, int key)
{
    switch (key) {
    case 'm':
        view->mode = (enum scene_view_mode)((view->mode + 1) % MODES);
        break;
    case 'f':
        view->format = (view->format + 1) % FORMATS;
        break;
    case 'b':
        view->band_rows = view->band_rows == 0 ? 16 : view->band_rows == 16 ? 8 : 0;
        break;
    case 'w':
        view->wireframe = !view->wireframe;
        break;
    case 'a':
        view->antialias = (view->antialias + 1) % ANTIALIAS_KINDS;
        break;
    case 'h':
        view->azimuth = turned(view->azimuth, -TURN);
        break;
    case 'l':
        view->azimuth = turned(view->azimuth, TURN);
        break;
    case 'k':
        view->elevation = turned(view->elevation, TURN);
        break;
    case 'j':
        view->elevation = turned(view->elevation, -TURN);
        break;
    case '.':
        view->time = view->time < .99 ? view->time + .02 : 0;
        break;
    case ',':
        view->time = view->time > .01 ? view->time - .02 : 1;
        break;
    case 'r':
        *view = (struct scene_view){.format = view->format};
        break;
    default:
        return 0;
    }
    return 1;
}

void scene_view_describe(const struct scene_view *view, const struct scene_figures *figures,
                         char lines[SCENE_VIEW_LINES][120])
{
    static const char *const modes[MODES] = {"fixed point", "double precision", "difference"};
    static const char *const antialias[ANTIALIAS_KINDS] = {
        "as the scene", "off", "edges", "ssaa", "fxaa", "temporal", "msaa"};
    char rows[32] = "no bands";
    if (view->band_rows > 0) {
        (void)snprintf(rows, sizeof rows, "bands of %d rows", view->band_rows);
    }
    (void)snprintf(lines[0], 120, "%s, %s, %s%s", modes[view->mode], formats[view->format].name,
                   rows, view->wireframe ? ", wireframe" : "");
    (void)snprintf(lines[1], 120, "anti-aliasing %s, $t %.2f%s", antialias[view->antialias],
                   view->time, figures->can_turn ? "" : ", no camera to turn");
    (void)snprintf(lines[2], 120, "%lu triangles, %lu pixels, RAM %.1f + %.1f KB",
                   figures->triangles, figures->pixels, (double)figures->band_bytes / 1000,
                   (double)figures->vertex_bytes / 1000);
    if (figures->m0plus > 0) {
        (void)snprintf(lines[3], 120, "M0+ %.2f, M3 %.2f million instructions, within %d %%",
                       figures->m0plus / 1e6, figures->m3 / 1e6, figures->error);
    } else {
        (void)snprintf(lines[3], 120, "%s",
                       view->format != 1 || view->band_rows != 0
                           ? "instructions: estimated for RGB565 in one band"
                           : "instructions: no estimate of these options");
    }
}
