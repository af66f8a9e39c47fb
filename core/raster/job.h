/*
 * A triangle on its way to pixels. Internal.
 *
 * A raster holds what the triangles of a draw call share, a job what the rows of a triangle share.
 * Which function fills the rows is chosen once a triangle. Flat and linear colours have loops of
 * their own, made from fill.inc, that fill whole rows; for everything else a row is a span, drawn
 * as runs: stretches over which every attribute is a 32-bit ramp. Without perspective runs have one
 * length; with it, a run goes from one exact division to the next. qtri_run_generic draws any run;
 * every loop gives its pixels to the bit.
 */
#ifndef QTRI_RASTER_JOB_H
#define QTRI_RASTER_JOB_H

#include <stdbool.h>

#include "qtri/material.h"

#include "gradient.h"
#include "../frame/pixel.h"
#include "texel.h"

typedef struct qtri_job qtri_job;

/* Pixels left..right-1 of a row, before any scissor: within 2^14 of 0. Empty when right <= left. */
typedef struct qtri_span {
    int16_t left, right;
} qtri_span;

/* How many rows are walked at a time: of a short triangle all of them, to save time. */
#define QTRI_ROWS_AHEAD (QTRI_WITH_FAST_PATHS ? 16 : 4)

/* Fills `count` rows from `row` on. */
typedef void (*qtri_fill_rows)(const qtri_job *job, const qtri_span *spans, int32_t row,
                               int32_t count);

/* What the triangles of a draw call share. */
typedef struct qtri_run qtri_run;
typedef void (*qtri_draw_run)(const qtri_job *job, const qtri_run *run);

typedef struct qtri_raster {
    const qtri_surface *surface;
    const qtri_texture *texture; /* NULL: none */
    qtri_rect bounds;
    qtri_fill_rows fill_flat, fill_linear, fill_tiny; /* without texture */
    qtri_draw_run copy_run;                           /* for jobs that copy texels */
    qtri_compare compare; /* QTRI_DEPTH_OFF: depth neither read nor written */
    bool depth_write;
    bool perspective, replace; /* as the material asks */
    qtri_channels tint;        /* what tinted triangles have shares of */
    int32_t tint_n6[3];        /* the same with 6 bits after the point, cut off */
    bool small;                /* small.h and tiny.h serve */
    uint32_t texel_cut;        /* of texels that are copied, see texel_copy.h */
    bool copies_white;         /* texels may be copied where the colour is white */
    qtri_cull cull;
    qtri_shading shading;
} qtri_raster;

/* NULL for none, known to the compiler where the library is built without. */
static inline const qtri_texture *qtri_raster_texture(const qtri_raster *raster)
{
    return QTRI_WITH_TEXTURES ? raster->texture : NULL;
}

/* What a material asks for and the library is built with: see config.h. */
static inline qtri_shading qtri_shading_of(const qtri_material *material)
{
    return QTRI_WITH_SMOOTH || material->shading == QTRI_FLAT_FIRST ? material->shading
                                                                    : QTRI_FLAT_LAST;
}

/* Where colour and texture coordinates come from. */
typedef enum qtri_paint {
    QTRI_PAINT_FLAT,       /* one pixel value */
    QTRI_PAINT_LINEAR,     /* ramps of colours, planes of texture coordinates */
    QTRI_PAINT_PERSPECTIVE /* planes of attribute / w, and of 1 / w */
} qtri_paint;

/* PERSPECTIVE: colours (n.16, up to 24 bits) are scaled by this much to use 30 bits. */
#define QTRI_COLOR_PERSPECTIVE_SHIFT 6

/*
 * Attributes in arrays of them: colours red green blue, then texture coordinates u and v, so that
 * those that a job has are neighbours. Where there are planes, that of 1/w follows.
 */
#define QTRI_U          3
#define QTRI_ATTRIBUTES 5
#define QTRI_PLANES     (QTRI_WITH_TEXTURES ? QTRI_ATTRIBUTES + 1 : (QTRI_WITH_SMOOTH ? QTRI_U + 1 : 1))

typedef union qtri_attribute {
    qtri_ramp ramp; /* LINEAR, colours */
    /*
     * LINEAR: texture coordinates in the unit of their axis. PERSPECTIVE: attribute inv_w / 2^31,
     * colours times 2^6; inv_w is 2^31 for the vertex nearest to the eye.
     */
    qtri_plane plane;
} qtri_attribute;

/* Steps of a packed colour, see packed.h: from pixels 0 2 4 6 of a group, 1 3 5, 7; of all eight.
 */
typedef struct qtri_packed_steps {
    uint32_t even, odd, last, eight;
} qtri_packed_steps;

struct qtri_job {
    const qtri_raster *raster;
    qtri_draw_run draw_run; /* of spans */
    bool tinted;            /* colours are shares of the raster's tint */
    qtri_paint paint;
    uint8_t first, end;         /* the attributes that vary: all from the first to before the end */
    bool packed;                /* colours are one word, see packed.h */
    bool tiny;                  /* packed colours have one start for the whole triangle */
    bool cut;                   /* spans may reach past the bounds */
    bool copies_texels;         /* see texel_copy.h */
    uint32_t pixel;             /* FLAT */
    int32_t anchor_x, anchor_y; /* origin of the ramps */
    qtri_ramp depth;            /* 16.16 */
    qtri_attribute attribute[QTRI_PLANES];
    union {
        qtri_channels constant; /* when not smooth */
        struct {
            uint32_t origin, dy; /* tiny: a ramp of packed.h, with step.even for dx */
            qtri_packed_steps step;
        } word; /* when packed */
        struct {
            int32_t least[3], greatest[3]; /* of the vertices, n.16 */
        } range;                           /* PERSPECTIVE clamps */
    } color;
    qtri_texel_axis axis[QTRI_WITH_TEXTURES ? 2 : 1];
};

static inline bool qtri_job_is_smooth(const qtri_job *job)
{
    return QTRI_WITH_SMOOTH && job->first == 0;
}

static inline bool qtri_job_is_flat(const qtri_job *job)
{
    return !(QTRI_WITH_SMOOTH || QTRI_WITH_TEXTURES) || job->paint == QTRI_PAINT_FLAT;
}

static inline bool qtri_job_copies_texels(const qtri_job *job)
{
    return QTRI_WITH_TEXTURES && job->copies_texels;
}

static inline bool qtri_job_is_packed(const qtri_job *job)
{
    return QTRI_WITH_SMOOTH && job->packed;
}

static inline int qtri_job_first(const qtri_job *job)
{
    return QTRI_WITH_SMOOTH ? job->first : QTRI_U;
}

static inline int qtri_job_end(const qtri_job *job)
{
    return QTRI_WITH_TEXTURES ? job->end : QTRI_U;
}

/* Pixels x .. x+count-1 of a row; all values at the first, with what rounds them added. */
struct qtri_run {
    uint8_t *pixels; /* of the whole row */
    uint16_t *depths;
    int32_t x, count; /* 0 < count */
    uint32_t z;       /* 16.16 */
    /* Packed: value[0] alone, `phase` pixels before x. */
    int32_t phase;
    uint32_t value[QTRI_ATTRIBUTES]; /* colours n.16, coordinates in the unit of a run */
    uint32_t step[QTRI_ATTRIBUTES];
};

/* Fills rows by spans: any job without perspective. */
void qtri_fill_spans(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count);

/* The same with perspective. */
void qtri_fill_perspective(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count);

/* The fastest functions for jobs of this raster without texture. */
void qtri_fill_choose(qtri_raster *raster);

void qtri_run_generic(const qtri_job *job, const qtri_run *run);

/* The part of a span inside the bounds: its first pixel, and how many; may be negative. */
static inline int32_t qtri_span_clip(const qtri_span *span, const qtri_rect *bounds, int32_t *x)
{
    int32_t end = span->right < bounds->x1 ? span->right : bounds->x1;
    *x = span->left > bounds->x0 ? span->left : bounds->x0;
    return end - *x;
}

/*
 * Whether a fragment at depth z passes against the stored depth. From QTRI_NEVER to QTRI_ALWAYS
 * comparisons count in bits: less, equal, greater pass.
 */
static inline bool qtri_depth_passes(qtri_compare compare, uint32_t z, uint32_t stored)
{
    const uint32_t passes = (uint32_t)compare - QTRI_NEVER;
    const int order = z < stored ? 0 : (z == stored ? 1 : 2);
    return compare > QTRI_ALWAYS || (passes >> order & 1) != 0;
}

#endif
