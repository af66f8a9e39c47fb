/* SPDX-License-Identifier: MIT */
#include "scene_cost.h"

#include <math.h>

/*
 * Instructions = a pixels + b triangles; then what another format of pixels or depth than RGB565
 * with linear16 adds, c pixels + d sqrt(pixels triangles), the root being about how many rows all
 * triangles have; and what bands add. Fitted so that the largest relative error is as small as it
 * can be, to scenes of the benchmark and to some of them, with the torus of S12c flat and as lines,
 * in all formats, depths and bands of 8, 16, 32 and 64 rows (tests/test_tools_view.c has those that
 * `make bench` counts). Large triangles, of more than 1000 pixels, are a kind of their own: what a
 * pixel costs there depends on how perspective runs along the rows, so that textured ones differ by
 * a factor of three.
 */
enum core { M0PLUS, M3, CORES };

struct model {
    double pixel, triangle;
};

static const struct {
    struct model cores[CORES];
    int error;
} models[2][4] = {
    {
        [SCENE_KIND_FLAT] = {{{22, 528}, {16.2, 254}}, 25},
        [SCENE_KIND_SMOOTH] = {{{38.8, 492}, {24.7, 234}}, 30},
        [SCENE_KIND_TEXTURED] = {{{117.7, 220}, {68.3, 135}}, 45},
        [SCENE_KIND_LINES] = {{{36, 499}, {18.6, 217}}, 15},
    },
    {
        [SCENE_KIND_FLAT] = {{{8.6, 0}, {7.4, 0}}, 15},
        [SCENE_KIND_SMOOTH] = {{{16.7, 0}, {12.4, 0}}, 25},
        [SCENE_KIND_TEXTURED] = {{{40, 0}, {24, 0}}, 60},
        [SCENE_KIND_LINES] = {{{36, 499}, {18.6, 217}}, 15},
    },
};

/* What takes another way than RGB565 with linear16: a pipeline of the depth's, or the generic one.
 */
enum way { FLOAT16, LINEAR24, LINEAR32, XRGB8888, GRAY8, GENERIC_DEPTH, WAYS };

static const struct {
    double pixel, root;
} ways[4][WAYS][CORES] =
    {
        [SCENE_KIND_FLAT] =
            {
                [FLOAT16] = {{11.3, 193}, {3.8, 98}},
                [LINEAR24] = {{33.4, 0}, {19.1, 9}},
                [LINEAR32] = {{11.7, 12}, {8.1, 8}},
                [XRGB8888] = {{51.5, 146}, {27.7, 76}},
                [GRAY8] = {{51.4, 151}, {28, 80}},
                [GENERIC_DEPTH] = {{203.4, 185}, {151.8, 90}},
            },
        [SCENE_KIND_SMOOTH] =
            {
                [FLOAT16] = {{16.4, 152}, {5.7, 97}},
                [LINEAR24] = {{23.5, 22}, {20, 15}},
                [LINEAR32] = {{16.3, 0}, {8.5, 13}},
                [XRGB8888] = {{68.5, 260}, {39.9, 145}},
                [GRAY8] = {{16.4, 240}, {15.1, 145}},
                [GENERIC_DEPTH] = {{242.1, 350}, {177.2, 205}},
            },
        [SCENE_KIND_TEXTURED] =
            {
                [FLOAT16] = {{17.1, 140}, {7.3, 83}},
                [LINEAR24] = {{27.8, 37}, {21.3, 21}},
                [LINEAR32] = {{11.6, 32}, {10.1, 21}},
                [XRGB8888] = {{113, 280}, {74, 170}},
                [GRAY8] = {{125, 250}, {83, 160}},
                [GENERIC_DEPTH] = {{323.7, 311}, {228, 149}},
            },
        [SCENE_KIND_LINES] =
            {
                [FLOAT16] = {{255, 586}, {189.9, 422}},
                [LINEAR24] = {{210.5, 539}, {165.1, 395}},
                [LINEAR32] = {{197.5, 546}, {157.3, 389}},
                [XRGB8888] = {{177.4, 838}, {156.4, 531}},
                [GRAY8] = {{0, 252}, {0, 118}},
                [GENERIC_DEPTH] = {{189.9, 904}, {166.7, 552}},
            },
};

/* What bands add: a triangle, and a pixel over the rows of a band. */
static const struct {
    double triangle, pixel;
} bands[4][CORES] = {
    [SCENE_KIND_FLAT] = {{126, 238}, {70, 121}},
    [SCENE_KIND_SMOOTH] = {{58, 291}, {68, 142}},
    [SCENE_KIND_TEXTURED] = {{124, 389}, {72, 192}},
    [SCENE_KIND_LINES] = {{247, 1419}, {118, 987}},
};

/* S0 of the benchmark: colour and depth of 76,800 pixels, half of it either. */
enum { CLEAR = 29280, CLEARED = 76800, LARGE = 1000, FLOAT16_ERROR = 20 };

static const double clear_color[] = {
    [SCENE_RGB565] = .5, [SCENE_XRGB8888] = 1, [SCENE_GRAY8] = .25};
static const double clear_depth[][CORES] = {[SCENE_LINEAR16] = {.5, .5},
                                            [SCENE_FLOAT16] = {.5, .5},
                                            [SCENE_LINEAR24] = {3.5, 2.5},
                                            [SCENE_LINEAR32] = {1, 1}};

/* What blending by alpha adds a pixel: to RGB565, there to flat colours, to the generic pipeline,
   and there with depths of other formats. */
enum { BLENDED, BLENDED_FLAT, BLENDED_GENERIC, BLENDED_DEPTH, BLENDS };
static const double blends[BLENDS][CORES] = {[BLENDED] = {55, 29},
                                             [BLENDED_FLAT] = {35, 19},
                                             [BLENDED_GENERIC] = {280, 190},
                                             [BLENDED_DEPTH] = {112, 66}};

static int blend_of(enum scene_kind kind, enum way way)
{
    return way == GENERIC_DEPTH      ? BLENDED_DEPTH
           : way != WAYS             ? BLENDED_GENERIC
           : kind == SCENE_KIND_FLAT ? BLENDED_FLAT
                                     : BLENDED;
}

/* WAYS: the one that the models are of. Depths of other formats bring no pipelines that blend. */
static enum way way_of(const struct scene_load *load)
{
    static const enum way of_depth[] = {[SCENE_LINEAR16] = WAYS,
                                        [SCENE_FLOAT16] = FLOAT16,
                                        [SCENE_LINEAR24] = LINEAR24,
                                        [SCENE_LINEAR32] = LINEAR32};
    const bool is_generic = load->format != SCENE_RGB565 || load->is_blended;
    return is_generic && load->depth != SCENE_LINEAR16 ? GENERIC_DEPTH
           : load->format == SCENE_XRGB8888            ? XRGB8888
           : load->format == SCENE_GRAY8               ? GRAY8
                                                       : of_depth[load->depth];
}

static double instructions(const struct scene_load *load, const struct model *model, enum core core)
{
    const double root = sqrt(load->pixels * load->triangles);
    const enum way way = way_of(load);
    double sum = model->pixel * load->pixels + model->triangle * load->triangles +
                 CLEAR * load->screen / CLEARED *
                     (clear_color[load->format] + clear_depth[load->depth][core]);
    if (way != WAYS) {
        sum += ways[load->kind][way][core].pixel * load->pixels +
               ways[load->kind][way][core].root * root;
    }
    if (load->is_blended) {
        sum += blends[blend_of(load->kind, way)][core] * load->pixels;
    }
    if (load->rows > 0) {
        sum += bands[load->kind][core].triangle * load->triangles +
               bands[load->kind][core].pixel * load->pixels / load->rows;
    }
    return sum;
}

struct scene_cost scene_cost(const struct scene_load *load)
{
    const int is_large = load->pixels > LARGE * load->triangles;
    const struct model *of = models[is_large][load->kind].cores;
    const struct scene_cost cost = {
        instructions(load, &of[M0PLUS], M0PLUS), instructions(load, &of[M3], M3),
        models[is_large][load->kind].error + (way_of(load) == FLOAT16 ? FLOAT16_ERROR : 0)};
    return cost;
}

bool scene_load_pass(struct scene_load *load, const struct scene *pass)
{
    bool is_known = !pass->lamps_on && pass->fog.kind == SCENE_FOG_OFF && !pass->texture_bilinear &&
                    pass->antialias == SCENE_ANTIALIAS_OFF && !pass->hidden_lines &&
                    !pass->smooth_lines && !pass->wide_lines &&
                    pass->triangle_count > pass->triangles_before;
    for (size_t i = 0; i < pass->op_count; i++) {
        is_known =
            is_known && pass->ops[i].kind != SCENE_STROKE && pass->ops[i].kind != SCENE_PAINT;
    }
    load->kind = pass->wireframe           ? SCENE_KIND_LINES
                 : pass->texture.width > 0 ? SCENE_KIND_TEXTURED
                 : pass->flat              ? SCENE_KIND_FLAT
                                           : SCENE_KIND_SMOOTH;
    load->depth = pass->depth_format;
    load->is_blended = pass->blend == SCENE_BLEND_ALPHA;
    return is_known && (pass->blend == SCENE_BLEND_OFF || (load->is_blended && !pass->wireframe));
}
