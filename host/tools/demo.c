/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../io/array.h"
#include "../io/file.h"
#include "../io/system.h"
#include "../reference/reference.h"
#include "../reference/reference_picture.h"
#include "accuracy.h"
#include "commands.h"
#include "compare.h"
#include "demo_scenes.h"
#include "gallery.h"
#include "scene_draw.h"

static const char usage[] =
    "usage: qtri demo [-o DIR] [--scenes DIR] [--models DIR] [--only WORD]\n"
    "                 [--report FILE]\n"
    "\n"
    "Renders every *.scene file of the scenes folder, generated meshes and, with --models, every\n"
    "OBJ file there, into the output folder. Both are, where nothing is said, those of the "
    "sources\n"
    "that this program was built in, wherever it is called: host/scenes and build/demo. Each is\n"
    "NAME.ppm beside NAME-reference.ppm and NAME-difference.ppm; index.html shows all of them.\n"
    "Prints one row a scene.\n"
    "--only draws those whose names contain WORD. --report writes each scene with a slider\n"
    "between core and double precision, and a histogram of errors: sections of a page, for `make "
    "report`.\n"
    "\n"
    "The reference has infinite sub-pixel precision; `snapped` counts coverage mismatches against\n"
    "the reference with vertices snapped to 8 bits, as the core does. Errors are over the pixels\n"
    "that show the same triangle in both. Colour: of 255; depth: of 65535. With `antialias` msaa,\n"
    "ssaa or temporal the reference looks at the same places of each pixel; `edges` and `fxaa` "
    "differ\n"
    "from its one sample at edges.\n";

enum { PATH_SIZE = 1024 };

struct demo {
    const char *out, *scenes, *models; /* folders; models NULL: none */
    const char *only;                  /* a part of the names of what is drawn; NULL: all */
    const char *report; /* where the sections of the accuracy report go; NULL: nowhere */
    struct html gallery, sections;
};

static const char header[] =
    "scene                          pixels  mismatch  snapped  colour  off by > 1  depth\n";

static bool complain(const struct text_error *error)
{
    fprintf(stderr, "qtri demo: %s\n", error->message);
    return false;
}

/* Measures one scene against both references and writes its three pictures. */
static bool run_scene(struct demo *demo, const char *name, const struct file_content *file,
                      const struct scene *scene, struct text_error *error)
{
    struct picture picture = {0};
    struct picture expected = {0};
    struct picture difference = {0};
    struct reference_image exact = {0};
    struct reference_image snapped = {0};
    struct accuracy to_exact = {0};
    struct accuracy to_snapped = {0};
    bool ok = scene_render(scene, &qtri_xrgb8888, 0, true, &picture) &&
              reference_render(scene, 0, &exact) && reference_render(scene, 8, &snapped) &&
              reference_picture(&exact, REFERENCE_RGB888, &expected) &&
              compare_difference(&picture, &expected, &difference);
    if (!ok) {
        text_error_set(error, name, 0, "out of memory");
    } else {
        accuracy_add(&to_exact, &picture, &exact, true);
        accuracy_add(&to_snapped, &picture, &snapped, true);
        printf("%-28s %8llu  %8llu  %7llu  %6d  %10llu  %5.2f\n", name,
               (unsigned long long)to_exact.covered, (unsigned long long)to_exact.coverage,
               (unsigned long long)to_snapped.coverage, to_exact.max_color,
               (unsigned long long)to_exact.color_above_1, to_exact.max_depth);
        fflush(stdout);
        const struct picture *pictures[3] = {&picture, &expected, &difference};
        static const char *const suffix[3] = {"", "-reference", "-difference"};
        for (int i = 0; i < 3 && ok; i++) {
            char path[1024];
            snprintf(path, sizeof path, "%s/%s%s.ppm", demo->out, name, suffix[i]);
            ok = picture_write_ppm(path, pictures[i], error);
        }
        const struct gallery_scene shown = {name,         file->bytes,
                                            file->length, {&picture, &expected, &difference},
                                            &to_exact,    &to_snapped};
        gallery_add(&demo->gallery, &shown);
        if (demo->report != NULL) {
            gallery_add_to_report(&demo->sections, &shown);
        }
    }
    reference_free(&exact);
    reference_free(&snapped);
    picture_free(&picture);
    picture_free(&expected);
    picture_free(&difference);
    return ok;
}

static bool is_wanted(struct demo *demo, const char *file)
{
    return demo->only == NULL || strstr(file, demo->only) != NULL;
}

static bool run_file(struct demo *demo, const char *folder, const char *file)
{
    char path[1024];
    char name[256];
    struct scene scene;
    struct text_error error;
    if (!is_wanted(demo, file)) {
        return true;
    }
    snprintf(path, sizeof path, "%s/%s", folder, file);
    snprintf(name, sizeof name, "%.*s", (int)(strlen(file) - strlen(".scene")), file);
    struct file_content text;
    bool ok = file_read(path, &text, &error);
    if (ok && (ok = scene_parse(path, text.bytes, text.length, &scene, &error))) {
        ok = run_scene(demo, name, &text, &scene, &error);
        scene_free(&scene);
    }
    free(text.bytes);
    return ok || complain(&error);
}

typedef char file_name[256];

static int compare_names(const void *a, const void *b)
{
    return strcmp(a, b);
}

/* Names of the folder's entries that end so, in order: how many, or -1 with errno. free() them. */
static long list_names(const char *folder, const char *ending, file_name **names)
{
    DIR *entries = opendir(folder);
    size_t count = 0, capacity = 0;
    bool ok = entries != NULL;
    const struct dirent *entry = NULL;
    *names = NULL;
    while (ok && (entry = readdir(entries)) != NULL) {
        if (!file_name_ends_in(entry->d_name, ending)) {
            continue;
        }
        file_name *name = array_add(names, &count, &capacity, sizeof *name);
        (void)snprintf(*name, sizeof *name, "%s", entry->d_name);
    }
    if (entries != NULL) {
        (void)closedir(entries);
    }
    if (ok && count > 0) {
        qsort(*names, count, sizeof **names, compare_names);
    }
    return ok ? (long)count : -1;
}

/* Calls `run` for the folder's entries that end so, in order of their names. */
static bool for_each(struct demo *demo, const char *folder, const char *ending,
                     bool (*run)(struct demo *, const char *folder, const char *file))
{
    file_name *names = NULL;
    const long count = list_names(folder, ending, &names);
    if (count < 0) {
        fprintf(stderr, "qtri demo: %s: %s\n", folder, strerror(errno));
    }
    bool ok = count >= 0;
    for (long i = 0; i < count; i++) {
        ok = run(demo, folder, names[i]) && ok;
    }
    free(names);
    return ok;
}

/* A model gets a scene file of its own beside the pictures, which is then rendered like any other.
 */
static bool run_model(struct demo *demo, const char *folder, const char *file)
{
    char name[256];
    struct text_error error;
    if (!demo_write_model_scene(demo->out, folder, file, name, sizeof name, &error)) {
        return complain(&error);
    }
    return run_file(demo, demo->out, name);
}

static bool run_generated(struct demo *demo)
{
    struct text_error error;
    bool ok = true;
    for (size_t i = 0; demo_generated_scene(i) != NULL; i++) {
        const char *name = demo_generated_scene(i);
        if (!is_wanted(demo, name)) {
            continue;
        }
        if (!demo_write_generated_scene(demo->out, i, &error)) {
            return complain(&error);
        }
        ok = run_file(demo, demo->out, name) && ok;
    }
    return ok;
}

/* mkdir -p */
static bool make_folder(const char *path)
{
    char part[1024];
    size_t length = strlen(path);
    if (length >= sizeof part) {
        return false;
    }
    for (size_t i = 1; i <= length; i++) {
        if (path[i] == '/' || path[i] == '\0') {
            memcpy(part, path, i);
            part[i] = '\0';
            const int failure = system_make_folder(part);
            if (failure != 0 && failure != EEXIST) {
                errno = failure;
                return false;
            }
        }
    }
    return true;
}

/*
 * The folder of the sources, with a slash behind it, or "" for the one that we are in: it has the
 * scenes, or a folder has them where the program lies, which is built in build/ or below.
 */
static void find_root(char root[PATH_SIZE])
{
    char scenes[PATH_SIZE + 16] = "host/scenes";
    char *slash = NULL;
    if (access(scenes, R_OK) != 0 && system_program(root, PATH_SIZE)) {
        while ((slash = strrchr(root, '/')) != NULL) {
            slash[1] = '\0';
            (void)snprintf(scenes, sizeof scenes, "%shost/scenes", root);
            if (access(scenes, R_OK) == 0) {
                return;
            }
            *slash = '\0';
        }
    }
    root[0] = '\0';
}

/* ---- The command ---- */

#define AT(member) offsetof(struct demo, member)

static const struct option all[] = {
    {"-o", OPTION_TEXT, AT(out), {NULL}},          {"--scenes", OPTION_TEXT, AT(scenes), {NULL}},
    {"--models", OPTION_TEXT, AT(models), {NULL}}, {"--only", OPTION_TEXT, AT(only), {NULL}},
    {"--report", OPTION_TEXT, AT(report), {NULL}},
};

static bool run(void *given, struct text_error *error)
{
    struct demo *demo = given;
    char root[PATH_SIZE], scenes[PATH_SIZE + 16], out[PATH_SIZE + 16], page[PATH_SIZE];
    find_root(root);
    (void)snprintf(scenes, sizeof scenes, "%shost/scenes", root);
    (void)snprintf(out, sizeof out, "%sbuild/demo", root);
    demo->scenes = demo->scenes != NULL ? demo->scenes : scenes;
    demo->out = demo->out != NULL ? demo->out : out;
    if (!make_folder(demo->out)) {
        return text_error_set(error, demo->out, 0, "%s", strerror(errno));
    }
    fputs(header, stdout);
    bool ok = for_each(demo, demo->scenes, ".scene", run_file);
    ok = run_generated(demo) && ok;
    if (demo->models != NULL) {
        ok = for_each(demo, demo->models, ".obj", run_model) && ok;
    }
    (void)snprintf(page, sizeof page, "%s/index.html", demo->out);
    ok = (gallery_write(&demo->gallery, page, error) || complain(error)) && ok;
    if (demo->report != NULL) {
        ok = (html_write(&demo->sections, demo->report, error) || complain(error)) && ok;
    }
    printf("\nPictures are in %s, all of them in index.html. mismatch: pixels covered in one of\n"
           "picture and reference only.\n",
           demo->out);
    error->message[0] = '\0'; /* what went wrong has been told */
    return ok;
}

const struct option_command demo_command = {
    .name = "demo",
    .summary = "render the demo scenes beside their references",
    .is_unlimited = true,
    .size = sizeof(struct demo),
    .options = all,
    .count = sizeof all / sizeof all[0],
    .usage = usage,
    .run = run,
};
