/* SPDX-License-Identifier: MIT */
/*
 * A scene file or an OBJ model in a window: `make window SCENE=...`.
 */
#include <stdio.h>
#include <string.h>

#include "../tools/demo_scenes.h"
#include "../tools/scene_view.h"
#include "screen.h"

static const char usage[] =
    "usage: window SCENE|MODEL.obj [--keys KEYS] [--shot FILE.ppm] [--folder DIR]\n"
    "\n"
    "Shows a scene file, or an OBJ model, as the fixed-point core draws it, enlarged by whole\n"
    "pixels. Below stand triangles, covered pixels, RAM (colour and depth + vertices), and about\n"
    "how many instructions a Cortex-M0+ and an M3 take.\n"
    "\n"
    "  --keys KEYS  presses these keys at first\n"
    "  --shot FILE  then writes what the window shows, one pixel for each block, and ends\n"
    "  --folder DIR where a model's scene file is made (default: .)\n"
    "\n"
    "Keys:\n";

static void print_usage(FILE *out)
{
    fputs(usage, out);
    for (int i = 0; scene_view_keys[i] != NULL; i++) {
        fprintf(out, "%s\n", scene_view_keys[i]);
    }
}

/* A model gets a scene file of its own. */
static bool scene_of(const char **path, const char *folder, char *made, size_t size)
{
    char models[1024], name[256];
    struct text_error error;
    const size_t length = strlen(*path);
    if (length < 4 || strcmp(*path + length - 4, ".obj") != 0) {
        return true;
    }
    const char *slash = strrchr(*path, '/');
    (void)snprintf(models, sizeof models, "%.*s", slash != NULL ? (int)(slash - *path) : 1,
                   slash != NULL ? *path : ".");
    if (!demo_write_model_scene(folder, models, slash != NULL ? slash + 1 : *path, name,
                                sizeof name, &error)) {
        fprintf(stderr, "window: %s\n", error.message);
        return false;
    }
    (void)snprintf(made, size, "%s/%s", folder, name);
    *path = made;
    return true;
}

static bool draw(struct screen *screen, const struct scene_view *view, const char *path)
{
    struct picture picture = {0};
    struct scene_figures figures;
    struct text_error error;
    char text[SCENE_VIEW_LINES][120];
    const char *lines[SCENE_VIEW_LINES];
    if (!scene_view_draw(view, path, &picture, &figures, &error)) {
        fprintf(stderr, "window: %s\n", error.message);
        return false;
    }
    bool ok = screen->window != NULL || screen_open(screen, path, picture.width, picture.height);
    ok = ok && screen->width == picture.width && screen->height == picture.height;
    scene_view_describe(view, &figures, text);
    for (int i = 0; i < SCENE_VIEW_LINES; i++) {
        lines[i] = text[i];
    }
    ok = ok && screen_show(screen, &picture, lines, SCENE_VIEW_LINES);
    picture_free(&picture);
    return ok;
}

/* Until q; space runs the time. A scene that cannot be drawn any more ends it. */
static bool run(struct screen *screen, struct scene_view *view, const char *path)
{
    bool runs = false;
    for (int key = 0; key != 'q'; key = screen_key(runs ? 40 : 1000)) {
        const bool is_due = runs && key == 0;
        runs = key == ' ' ? !runs : runs;
        const bool changed = scene_view_key(view, is_due ? '.' : key) != 0;
        if ((changed || key == -1) && !draw(screen, view, path)) {
            return false;
        }
    }
    return true;
}

int main(int argc, char **argv)
{
    const char *path = NULL, *keys = "", *shot = NULL, *folder = ".";
    char made[1400];
    struct screen screen = {0};
    struct scene_view view = {.format = 1};
    for (int i = 1; i < argc; i++) {
        const char **value = strcmp(argv[i], "--keys") == 0     ? &keys
                             : strcmp(argv[i], "--shot") == 0   ? &shot
                             : strcmp(argv[i], "--folder") == 0 ? &folder
                                                                : NULL;
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
            print_usage(stdout);
            return 0;
        }
        if (value != NULL ? i + 1 == argc : path != NULL || argv[i][0] == '-') {
            fprintf(stderr, "window: '%s' is not understood\n", argv[i]);
            path = NULL;
            break;
        }
        *(value != NULL ? value : &path) = argv[value != NULL ? ++i : i];
    }
    if (path == NULL) {
        print_usage(stderr);
        return 2;
    }
    bool ok = scene_of(&path, folder, made, sizeof made);
    for (; ok && *keys != '\0'; keys++) {
        (void)scene_view_key(&view, *keys);
    }
    ok = ok && draw(&screen, &view, path) &&
         (shot != NULL ? screen_shoot(&screen, shot) : run(&screen, &view, path));
    if (screen.window != NULL) {
        screen_close(&screen);
    }
    return ok ? 0 : 1;
}
