/* SPDX-License-Identifier: MIT */
/*
 * Draws a parsed scene with the fixed-point core.
 */
#ifndef QTRI_HOST_TOOLS_SCENE_DRAW_H
#define QTRI_HOST_TOOLS_SCENE_DRAW_H

#include <qtri.h>

#include "../io/picture.h"
#include "../io/scene.h"

/* A mesh file as the core wants it: parts of at most 65536 vertices, in file order. */
struct scene_parts {
    qtri_mesh *part;
    size_t count;
};

/* What draws in place of the default pipelines, and a pixel function for all materials or NULL. */
struct scene_pipelines {
    const qtri_pipeline *const *list;
    bool (*fragment)(qtri_fragment *fragment);
};

/* What drawing needs beside the scene: converted once, drawn any number of times. */
struct scene_resources {
    const struct scene *scene;
    struct scene_parts *meshes; /* one for each of scene->meshes */
    void *texels;               /* NULL when texturing is off */
    qtri_rgb palette[256];      /* what texture.palette points at: resources must not be moved */
    uint16_t palette565[256];   /* or this */
    qtri_texture texture;
    const void *levels[SCENE_MAX_LEVELS], *mask_levels[SCENE_MAX_LEVELS];
    uint8_t *mask_texels; /* NULL without a colour key or alpha */
    qtri_texture mask;    /* white, with the same holes or alpha: ids are drawn through it */
    qtri_light light;
    /* Of `light`, `ambient`, `material`: they point into resources. */
    qtri_light lights;
    qtri_light_source sources[QTRI_LIGHTS_MAX];
    qtri_shininess shininess, falloff[QTRI_LIGHTS_MAX];
    qtri_reflection reflection;
    qtri_uv16 *sphere_uvs; /* scratch for the largest part; NULL without `texgen sphere` */
    qtri_vertex *vertices; /* scratch for the largest part */
    uint32_t vertex_count;
    uint32_t jitter; /* drawn from place `jitter` of 2^jitter_log2, see qtri_view_jitter() */
    int32_t jitter_log2;
    struct scene_painting *painting;         /* fonts and pictures */
    const struct scene_pipelines *pipelines; /* NULL: the default ones */
    struct scene_resources *next;            /* of the scene's next pass */
};

enum scene_pass {
    SCENE_COLORS, /* what the scene shows */
    SCENE_IDS,    /* flat triangle ids as 24-bit colours, for XRGB8888 surfaces */
    SCENE_EDGES   /* on a surface with its colours and depths: smooths the outlines */
};

#define SCENE_MAX_DUMP_ID 0xFFFFFFu /* ids travel as 24-bit colours */

/* The scene must outlive the resources. */
void scene_resources_create(struct scene_resources *resources, const struct scene *scene);
void scene_resources_free(struct scene_resources *resources);

/* The part of scene_resources_create that is about light. */
void scene_lights_create(struct scene_resources *resources, const struct scene *scene);

/* The part that is about the texture. */
void scene_texture_create(struct scene_resources *resources, const struct scene *scene);

/* The part that is about flat shapes, text and pictures, and the operations of this kind. */
void scene_painting_create(struct scene_resources *resources, const struct scene *scene);
void scene_painting_free(struct scene_resources *resources);
void scene_paint(const struct scene_resources *resources, const qtri_surface *surface,
                 const struct scene_paint *paint);

/* A model of the scene as it is at this moment, to be freed by mesh_arrays_free(). */
void scene_model_create(qtri_mesh *mesh, const struct scene *scene,
                        const struct scene_model *model);

/*
 * Clears the surface and draws the scene into the rows and scissor it has. The viewport is the
 * surface's frame. SCENE_EDGES: blends the outlines of what is there and
 * spends the depth; triangles that follow each other in the file are one mesh.
 */
void scene_draw(const struct scene_resources *resources, const qtri_surface *surface,
                enum scene_pass pass);

/*
 * Renders the whole scene in bands of `rows` rows (0: one band) into a new picture, with id and
 * depth when asked for. False when memory runs out.
 */
bool scene_render(const struct scene *scene, const qtri_format *format, int32_t rows,
                  bool with_dump, struct picture *picture);

/* Renders a scene that is drawn more than once, by its resources. */
bool scene_render_resources(struct scene_resources *resources, const qtri_format *format,
                            int32_t rows, bool with_dump, struct picture *picture);

/* Of a format the one with four samples a pixel; itself where there is none. */
const qtri_format *scene_sampled_format(const qtri_format *format);

/* The whole scene at once by these pipelines. */
bool scene_render_by(const struct scene *scene, const qtri_format *format,
                     const struct scene_pipelines *pipelines, struct picture *picture);

#endif
