/* SPDX-License-Identifier: MIT */
/*
 * A triangle on its way to pixels: what its rows share. Internal.
 *
 * Attributes are linear on the screen or, with perspective, quotients of two that are; then a row
 * is cut into blocks along which curves of second order serve, see perspective.c. Which function
 * fills the rows is chosen once a triangle: span.c draws any by the stages of batch.h, those of
 * core/fast stand in where a format has them, with the same pixels to the bit.
 */
#ifndef QTRI_RASTER_JOB_H
#define QTRI_RASTER_JOB_H

#include "gradient.h"
#include "raster.h"

/* How many rows are walked at a time: of a short triangle all of them, to save time. */
#define QTRI_ROWS_AHEAD (QTRI_WITH_FAST_PATHS ? 16 : 4)

/* Colours (n.16, up to 24 bits) are scaled by this much to use 30 bits with perspective. */
#define QTRI_COLOR_PERSPECTIVE_SHIFT 6

/* Blocks along which curves hold have up to 2^QTRI_BLOCK_LOG2 pixels. */
#define QTRI_BLOCK_LOG2 5

/*
 * Attributes in an array: colours red green blue, then texture coordinates u and v, so that those
 * that a job has are neighbours. One colour, gray or light, is in blue's place. With perspective
 * they are times inv_w / 2^32, colours times 2^6 as well, and inv_w follows: 2^31 for the vertex
 * nearest to the eye.
 */
#define QTRI_U          3
#define QTRI_ATTRIBUTES 5
#define QTRI_PLANES     (QTRI_ATTRIBUTES + 1)

/*
 * An attribute with perspective, or inv_w: its plane in its own unit, and what else its curves
 * need, see perspective.c.
 */
typedef struct qtri_projected {
    uint32_t origin, dx, dy;   /* at the centre of pixel (0, 0), for one pixel right, one down */
    uint16_t dx_rest, dy_rest; /* 2^-16 of the unit */
    uint16_t origin_rest;
    uint32_t slope, slope_dy; /* the attribute's slope times inv_w^2: in row 0, one row down */
    uint32_t bias;            /* of values */
    int8_t down;              /* slopes are times 2^-down in the curve's unit */
    int8_t up;                /* of values */
} qtri_projected;

typedef union qtri_attribute {
    qtri_ramp ramp;   /* colours that are linear */
    qtri_plane plane; /* texture coordinates that are linear, in the unit of their axis */
    qtri_projected projected;
} qtri_attribute;

/* The least inv_w at the start of a block of 2^(i+1) pixels. */
typedef uint32_t qtri_block_limits[QTRI_BLOCK_LOG2];

/* Of a job with perspective. */
typedef struct qtri_perspective {
    int32_t slope; /* inv_w's dx with 15 bits, times 2^slope_exponent where inv_w is 2^31 */
    int32_t slope_exponent;
    qtri_block_limits colors, texels;
    uint8_t up, moved;      /* planes are 2^up (1 - moved / 32) of those of the vertices' inv_w */
    uint8_t texels_twisted; /* log2 of the least blocks of texels that are of third order */
    int32_t least[3], greatest[3]; /* colours of the vertices, n.16 */
} qtri_perspective;

/* Steps of a packed colour, see packed.h: from pixels 0 2 4 6 of a group, 1 3 5, 7; of all eight.
 */
typedef struct qtri_packed_steps {
    uint32_t even, odd, last, eight;
} qtri_packed_steps;

typedef struct qtri_scanline qtri_scanline;

struct qtri_job {
    const qtri_raster *raster;
    uint8_t first, end; /* the attributes that vary: all from the first to before the end */
    bool tinted;        /* colours are shares of the raster's tint */
    bool perspective;
    bool packed;                /* colours are one word, see packed.h */
    bool cut;                   /* spans may reach past the bounds */
    bool copies;                /* texels become pixels as they are */
    bool shaded;                /* texels are multiplied */
    uint32_t pixel;             /* without attributes: the stored pixel; textured: the shade */
    int32_t anchor_x, anchor_y; /* origin of the ramps */
    qtri_ramp depth;            /* 16.16 */
    bool clamps_depth;          /* it may leave the range: rows are filled by depth_clamp.h */
    qtri_ramp true_depth;       /* then: the depth is that or, for pixels out of range, even */
    int32_t depth_above;        /* then: what the origin has above its 32 bits */
    qtri_attribute attribute[QTRI_PLANES];
    union {
        qtri_packed_steps step; /* when packed */
        qtri_perspective perspective;
    } color;
    qtri_texel_axis axis[2];
};

/* A plane along a row: at column 0, and an attribute's slope times inv_w^2. */
typedef struct qtri_row_plane {
    uint32_t at;
    int32_t rest;  /* 2^-16 of that */
    int32_t slope; /* 15 bits, times 2^-down in the curve's unit */
    int8_t down;
    uint8_t cut; /* bits that the slope has not, in the row before */
} qtri_row_plane;

/* A row on its way to pixels. */
struct qtri_scanline {
    const qtri_job *job;
    int32_t y;
    int32_t left, right; /* its span */
    int32_t x0, x1;      /* of which this is drawn */
    uint8_t *pixels;     /* of column 0 */
    uint16_t *depths;    /* NULL: there are none */
    bool level;          /* with perspective: coordinates are linear along this row */
    union {
        uint64_t plane[2]; /* linear coordinates at column 0, with the bias */
        struct {
            qtri_row_plane plane[QTRI_PLANES];
            int32_t zeros; /* of inv_w, when it was last asked */
        } perspective;
    } by;
    int32_t run_length; /* pixels after which linear coordinates begin anew, 2^n */
    /* Of the job's attributes, from a chunk's start on, or a block's with perspective. */
    qtri_curve curve[QTRI_ATTRIBUTES];
};

/* Pixels x .. x+count-1 of a row that copies texels; all values at the first. */
struct qtri_run {
    uint8_t *pixels; /* of the whole row */
    uint16_t *depths;
    int32_t x, count;           /* 0 < count */
    uint32_t z;                 /* 16.16 */
    uint32_t value[2], step[2]; /* u and v as texel_copy.h has them */
};

/* Whether attributes are divided: without perspective in the library none are. */
static inline bool qtri_job_is_bent(const qtri_job *job)
{
    return QTRI_WITH_PERSPECTIVE && job->perspective;
}

/* Jobs of one colour, without effects, by stages; then any. */
void qtri_span_flat(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count);
void qtri_span_fill(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count);

/* The part of a span inside the bounds: its first pixel, and how many; may be negative. */
static inline int32_t qtri_span_clip(const qtri_span *span, const qtri_rect *bounds, int32_t *x)
{
    int32_t end = span->right < bounds->x1 ? span->right : bounds->x1;
    *x = span->left > bounds->x0 ? span->left : bounds->x0;
    return end - *x;
}

/* A plane at column 0 of a row; then at a column. */
static inline uint64_t qtri_plane_row(const qtri_plane *plane, int32_t y)
{
    return plane->origin + (uint64_t)(int64_t)y * plane->dy;
}

static inline uint64_t qtri_plane_column(uint64_t row, uint64_t dx, int32_t x)
{
    return row + (uint64_t)(int64_t)x * dx;
}

/* An attribute in the unit of a run. */
static inline uint32_t qtri_run_scaled(uint32_t value, int32_t up)
{
    return up >= 0 ? value << up : value >> -up;
}

#endif
