/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700

#include "demo_scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../io/file.h"
#include "../io/obj.h"
#include "../io/system.h"
#include "demo_waves.h"
#include "mesh_generate.h"

static const char stage[] = "viewport 320 240\n"
                            "clear .094118 .125490 .188235\n"
                            "depth less\n"
                            "cull back\n"
                            "light .4 .6 .69282032 .2 .8\n";

static const char camera[] = "mode projection\n"
                             "perspective 60 1.33333333 .1 100\n"
                             "mode modelview\n"
                             "lookat 0 0 3  0 0 0  0 1 0\n";

static const char checker[] = "texture 64 64 8  255 240 220  90 130 200\n";

/* mesh NULL: `pose` ends with what is drawn, of the meshes of demo_waves.h. */
struct generated {
    const char *name, *shows, *mesh, *state, *pose;
};

static const char flag[] = "cull none\ntwosided on\nambient .2 .2 .2\nlight 0 0 1 0 0\n"
                           "light directional .4 .6 .7 .8 .8 .8\n"
                           "texture 64 32 8  255 80 60  255 240 220\n";

static const struct generated scenes[] = {
    {"07-knot-textured.scene", "A textured knot of 5,760 small triangles.", "knot", checker,
     "rotate -35  1 0 0\nrotate 20  0 1 0\n"},
    {"07-knot-flat.scene", "The knot, one colour a triangle.", "knot", "shade flat\n",
     "rotate -35  1 0 0\nrotate 20  0 1 0\n"},
    {"07-knot-stretched.scene",
     "The knot under a scale that is not uniform: its normals stay right.", "knot", "",
     "scale 1.5 .7 1\nrotate -35  1 0 0\nrotate 20  0 1 0\n"},
    {"07-torus-wireframe.scene", "A torus as lines of one pixel.", "torus", "polygon line\n",
     "rotate -50  1 0 0\n"},
    {"11-light-point.scene", "A point light with highlights, and a directional light.", "knot",
     "light 0 0 1 0 0\nambient .1 .1 .15\nmaterial specular 1 1 1 40\n"
     "light point 1.5 1 .2 1 .9 .8 1 0 .1\nlight directional -1 0 .3 .2 .3 .6\n",
     "rotate -35  1 0 0\nrotate 20  0 1 0\n"},
    {"11-light-spots-flat.scene", "Three spot lights on flat triangles.", "knot",
     "light 0 0 1 0 0\nambient .05 .05 .05\nshade flat\nmaterial specular .6 .6 .6 20\n"
     "light spot 0 0 1  0 0 -1  5 20  1 1 1\n"
     "light spot 2 2 -1  -1 -1 -1  10 25  1 .2 .2  .5 0 .05 4\n"
     "light spot -2 1 -1  .8 -.5 -.8  10 25  .2 1 .2\n",
     "rotate -35  1 0 0\nrotate 20  0 1 0\n"},
    {"11-light-stretched.scene",
     "Highlights, a colour of its own for ambient light, and emission, under a scale that is not "
     "uniform.",
     "knot",
     "light 0 0 1 0 0\nambient .1 .1 .15\nmaterial specular 1 1 1 100\n"
     "material emission .1 0 0\nmaterial ambient 0 .5 1\nlight point 1.5 1 .2 1 .9 .8 1 0 .1\n",
     "scale 1.5 .7 1\nrotate -35  1 0 0\nrotate 20  0 1 0\n"},
    {"11-light-two-sided.scene", "The inside of a torus, lit from both sides.", "torus",
     "light 0 0 1 0 0\ncull front\ntwosided on\nambient .1 .1 .15\nmaterial specular 1 1 1 30\n"
     "light point 0 1 0 1 1 1 1 .2 .2\nlight point 2 2 -2 1 .3 .3\n",
     "rotate -50  1 0 0\n"},
    {"11-sphere-map.scene", "A sphere map: texture coordinates are those of the normals.", "knot",
     "light 0 0 1 1 0\ntexgen sphere\ntexture 256 256 8  255 200 60 60 30 90\n"
     "texwrap clamp\ntexmode replace\n",
     "rotate -35  1 0 0\nrotate 20  0 1 0\n"},
    {"11-torus-smooth-lines.scene", "A torus as lines with smooth edges.", "torus",
     "polygon smooth\n", "rotate -50  1 0 0\n"},
    {"11-knot-edges.scene", "A knot with its outlines smoothed by the edge pass.", "knot",
     "antialias edges\n", "rotate -35  1 0 0\nrotate 20  0 1 0\n"},
    {"11-torus-hidden-lines.scene",
     "A torus as lines, of which those behind its surface are hidden.", "torus",
     "cull none\npolygon hidden .004\n", "rotate -50  1 0 0\n"},
    {"11-torus-wide-lines.scene", "A torus as wide lines.", "torus",
     "linewidth 2.5\npolygon wide\n", "rotate -50  1 0 0\n"},
    {"12-morph.scene", "A flag between two shapes.", NULL, flag,
     "rotate -25  0 1 0\nmorph .3 wave-0.obj wave-1.obj color 1 1 1\n"},
    {"12-frames.scene", "Flags at moments between four shapes, and beyond them.", NULL, flag,
     "push\ntranslate 0 .8 0\nscale .7 .7 .7\nrotate -25  0 1 0\n"
     "frames 1.5 wave-0.obj wave-1.obj wave-2.obj wave-3.obj\npop\n"
     "push\ntranslate 0 -.1 0\nscale .7 .7 .7\nrotate -25  0 1 0\n"
     "frames -.25 wave-0.obj wave-1.obj wave-2.obj wave-3.obj\npop\n"
     "push\ntranslate 0 -1 0\nscale .7 .7 .7\nrotate -25  0 1 0\n"
     "frames 8 wave-0.obj wave-1.obj wave-2.obj wave-3.obj color .6 .8 1\npop\n"},
    {"12-targets.scene", "A flag with weighted differences of other shapes.", NULL, flag,
     "rotate -25  0 1 0\ntargets wave-0.obj 1.5 wave-1.obj -.5 wave-2.obj color .9 1 .8\n"},
};

const char *demo_generated_scene(size_t i)
{
    return i < sizeof scenes / sizeof scenes[0] ? scenes[i].name : NULL;
}

/* Opens folder/name for writing. */
static bool create(struct file_output *out, const char *folder, const char *name,
                   struct text_error *error)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return file_output_open(out, path, error);
}

static bool write_mesh(const char *folder, const char *mesh, struct text_error *error)
{
    char name[64];
    struct file_output out;
    snprintf(name, sizeof name, "%s.obj", mesh);
    if (!create(&out, folder, name, error)) {
        return false;
    }
    (void)mesh_generate(mesh, out.stream);
    return file_output_commit(&out, error);
}

bool demo_write_generated_scene(const char *folder, size_t i, struct text_error *error)
{
    const struct generated *scene = &scenes[i];
    struct file_output out;
    if (!(scene->mesh != NULL ? write_mesh(folder, scene->mesh, error)
                              : demo_write_waves(folder, error)) ||
        !create(&out, folder, scene->name, error)) {
        return false;
    }
    fprintf(out.stream, "# %s\n%s%s%s%s", scene->shows, stage, scene->state, camera, scene->pose);
    if (scene->mesh != NULL) {
        fprintf(out.stream, "mesh %s.obj color 1 .75 .4\n", scene->mesh);
    }
    return file_output_commit(&out, error);
}

/* Centre and half the largest side of the bounding box. */
static void fit(const struct obj_mesh *mesh, double center[3], double *half)
{
    *half = 1.0 / 65536.0;
    for (int axis = 0; axis < 3; axis++) {
        int32_t least = mesh->positions[0][axis];
        int32_t greatest = least;
        for (size_t i = 1; i < mesh->vertex_count; i++) {
            int32_t x = mesh->positions[i][axis];
            least = x < least ? x : least;
            greatest = x > greatest ? x : greatest;
        }
        center[axis] = ((double)least + greatest) / 2.0 / 65536.0;
        double size = ((double)greatest - least) / 2.0 / 65536.0;
        *half = size > *half ? size : *half;
    }
}

/* Models look along +z, where the camera is, but for the cow; a little to the side shows more. */
static int degrees_to_face(const char *file)
{
    return strcmp(file, "spot.obj") == 0 ? 150 : -30;
}

bool demo_write_model_scene(const char *folder, const char *models, const char *file, char *name,
                            size_t name_size, struct text_error *error)
{
    char path[1024];
    char texture[1024 + 32];
    struct obj_mesh mesh;
    snprintf(path, sizeof path, "%s/%s", models, file);
    if (!obj_read(path, &mesh, error)) {
        return false;
    }
    double center[3];
    double half;
    fit(&mesh, center, &half);
    bool has_uvs = mesh.uvs != NULL;
    obj_free(&mesh);

    char *absolute = system_real_path(path);
    if (absolute == NULL) {
        return text_error_set(error, path, 0, "has no absolute path");
    }
    int stem = (int)(strlen(file) - strlen(".obj"));
    snprintf(name, name_size, "model-%.*s.scene", stem, file);
    snprintf(texture, sizeof texture, "%.*s_texture.ppm", (int)(strlen(absolute) - 4), absolute);
    struct file_output out;
    const bool ok = create(&out, folder, name, error);
    if (ok) {
        fprintf(out.stream, "# The model %s.\n%s", file, stage);
        if (has_uvs && access(texture, R_OK) == 0) {
            fprintf(out.stream, "texture %s\n", texture);
        }
        const double scale = 1.2 / half;
        fprintf(out.stream,
                "%srotate %d  0 1 0\nscale %.6f %.6f %.6f\ntranslate %.6f %.6f %.6f\n"
                "mesh %s color 1 1 1\n",
                camera, degrees_to_face(file), scale, scale, scale, -center[0], -center[1],
                -center[2], absolute);
    }
    free(absolute);
    return ok && file_output_commit(&out, error);
}
