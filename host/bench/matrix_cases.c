/* SPDX-License-Identifier: MIT */
#include "matrix.h"

static const matrix_surface surfaces[] = {
    {"rgb565", &qtri_rgb565}, {"rgb565_swapped", &qtri_rgb565_swapped},
    {"rgb888", &qtri_rgb888}, {"xrgb8888", &qtri_xrgb8888},
    {"gray8", &qtri_gray8},
};

static const matrix_depth depths[] = {
    {"less", QTRI_LESS, Q16_ONE, false, false},
    {"less-readonly", QTRI_LESS, Q16_ONE, true, false},
    {"lequal", QTRI_LESS_EQUAL, Q16_ONE, false, false},
    {"greater", QTRI_GREATER, 0, false, false},
    {"always", QTRI_ALWAYS, Q16_ONE, false, false},
    {"equal", QTRI_EQUAL, Q16_ONE, false, true},
    {"off", QTRI_DEPTH_OFF, Q16_ONE, false, false},
};

static const matrix_wrap wraps[] = {
    {"repeat", QTRI_REPEAT, false},
    {"clamp", QTRI_CLAMP, false},
    {"repeat-key", QTRI_REPEAT, true},
    {"clamp-key", QTRI_CLAMP, true},
};

static const matrix_texel texels[] = {
    {"rgb565", offsetof(matrix_frame, rgb565), &qtri_texel_rgb565, MATRIX_KEY_RGB565},
    {"xrgb8888", offsetof(matrix_frame, xrgb8888), &qtri_texel_xrgb8888, MATRIX_KEY_XRGB8888},
    {"palette8", offsetof(matrix_frame, palette8), &qtri_texel_palette8, MATRIX_KEY_PALETTE8},
    {"gray8", offsetof(matrix_frame, gray8), &qtri_texel_gray8, MATRIX_KEY_GRAY8},
    {"checker", 0, &qtri_texel_checker, MATRIX_KEY_CHECKER},
};

static const matrix_filter filters[] = {
    {"nearest", NULL},
    {"bilinear", &qtri_bilinear},
};

static const matrix_source sources[] = {
    {"flat", MATRIX_ONE, QTRI_FLAT_LAST, QTRI_REPLACE, false},
    {"smooth", MATRIX_RGB, QTRI_SMOOTH, QTRI_REPLACE, false},
    {"tint", MATRIX_TINT, QTRI_SMOOTH, QTRI_REPLACE, false},
    {"replace", MATRIX_ONE, QTRI_SMOOTH, QTRI_REPLACE, true},
    {"modulate-light", MATRIX_GREY, QTRI_SMOOTH, QTRI_MODULATE, true},
    {"modulate-rgb", MATRIX_RGB, QTRI_SMOOTH, QTRI_MODULATE, true},
};

/* Quads lie in 160x120, most rows of theirs above 100 pixels. The wall's and the spot's triangles
   have the size of those of S8 and S6: all of the spot is seen, and a quarter of the wall. */
static const matrix_geometry geometries[] = {
    {.name = "level", .quad = &bench_screen, .repeats = Q16(2), .window = {0, 0, 160, 120}},
    {.name = "floor", .quad = &bench_floor, .repeats = Q16(1), .window = {0, 0, 160, 120}},
    {.name = "turned", .quad = &bench_turned, .repeats = Q16(2), .window = {0, 0, 160, 120}},
    {.name = "wall",
     .mesh = &bench_mesh_wall_compact,
     .colors = bench_colors_wall,
     .window = {80, 60, 240, 180}},
    {.name = "mesh",
     .mesh = &bench_mesh_spot_uv_compact,
     .colors = bench_colors_spot_uv,
     .turn = Q16(150),
     .window = {82, 22, 210, 206}},
};

#define COUNT(table) ((uint8_t)(sizeof(table) / sizeof((table)[0])))

static const uint8_t counts[MATRIX_AXES] = {
    [MATRIX_SURFACE] = COUNT(surfaces),    [MATRIX_DEPTH] = COUNT(depths),
    [MATRIX_WRAP] = COUNT(wraps),          [MATRIX_TEXEL] = COUNT(texels),
    [MATRIX_FILTER] = COUNT(filters),      [MATRIX_SOURCE] = COUNT(sources),
    [MATRIX_GEOMETRY] = COUNT(geometries),
};

static void look_up(matrix_case *now)
{
    now->surface = &surfaces[now->at[MATRIX_SURFACE]];
    now->depth = &depths[now->at[MATRIX_DEPTH]];
    now->wrap = &wraps[now->at[MATRIX_WRAP]];
    now->texel = &texels[now->at[MATRIX_TEXEL]];
    now->filter = &filters[now->at[MATRIX_FILTER]];
    now->source = &sources[now->at[MATRIX_SOURCE]];
    now->geometry = &geometries[now->at[MATRIX_GEOMETRY]];
}

void matrix_first(matrix_case *first)
{
    const matrix_case zero = {{0}, NULL, NULL, NULL, NULL, NULL, NULL, NULL};
    *first = zero;
    look_up(first);
}

/* What has a pipeline of its own: see matrix_pipelines.h. */
static bool is_wanted(const matrix_case *now, bool full)
{
    const bool textured = now->source->textured;
    if (!textured &&
        (now->at[MATRIX_TEXEL] != 0 || now->at[MATRIX_FILTER] != 0 || now->at[MATRIX_WRAP] != 0)) {
        return false;
    }
    const int varied = (now->at[MATRIX_SURFACE] != 0) + (now->at[MATRIX_DEPTH] != 0) +
                       (now->at[MATRIX_WRAP] != 0) + (now->at[MATRIX_TEXEL] != 0);
    const bool is_filtered = now->at[MATRIX_FILTER] != 0 && now->at[MATRIX_TEXEL] == 0;
    return full || varied + is_filtered <= 1;
}

bool matrix_next(matrix_case *now, bool full)
{
    do {
        int axis = 0;
        while (axis < MATRIX_AXES && ++now->at[axis] == counts[axis]) {
            now->at[axis++] = 0;
        }
        if (axis == MATRIX_AXES) {
            return false;
        }
        look_up(now);
    } while (!is_wanted(now, full));
    return true;
}

/* Appends a part of a name, and returns its new end. */
static char *append(char *end, const char *limit, const char *part)
{
    while (*part != '\0' && end + 1 < limit) {
        *end++ = *part++;
    }
    *end = '\0';
    return end;
}

void matrix_name(const matrix_case *now, char name[MATRIX_NAME_MAX])
{
    const char *parts[] = {now->surface->name, now->depth->name,  now->source->name,
                           now->texel->name,   now->filter->name, now->wrap->name,
                           now->geometry->name};
    const char *limit = name + MATRIX_NAME_MAX;
    for (uint32_t i = 0; i < sizeof parts / sizeof parts[0]; i++) {
        bool of_texture = i >= 3 && i <= 5;
        if (now->source->textured || !of_texture) {
            name = append(name, limit, i == 0 ? "" : "/");
            name = append(name, limit, parts[i]);
        }
    }
}

/* One pattern, which ends at `end`. A text that does not go on as the last `*` wants is tried again
   one character later. */
static bool matches_one(const char *pattern, const char *end, const char *name)
{
    const char *star = NULL, *tried = NULL;
    for (;;) {
        if (pattern != end && *pattern == '*') {
            star = ++pattern;
            tried = name;
        } else if (*name == '\0') {
            return pattern == end;
        } else if (pattern != end && *pattern == *name) {
            pattern++;
            name++;
        } else if (star != NULL) {
            pattern = star;
            name = ++tried;
        } else {
            return false;
        }
    }
}

bool matrix_matches(const char *patterns, const char *name)
{
    bool any = false;
    while (*patterns != '\0') {
        const char *end = patterns;
        while (*end != '\0' && *end != ' ') {
            end++;
        }
        if (end != patterns && matches_one(patterns, end, name)) {
            return true;
        }
        any = any || end != patterns;
        patterns = *end == ' ' ? end + 1 : end;
    }
    return !any;
}
