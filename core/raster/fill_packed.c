#include "fill_packed.h"

#include "fill_pairs.h"

/* `count` pixels, the first of which is pixel `phase` of a group. */
static void draw(qtri_packed_row *row, const qtri_job *job, int32_t phase, int32_t count)
{
    const qtri_packed_steps *step = &job->color.word.step;
    for (; count > 0; count--, phase++) {
        if (row->z >> 16 < *row->depth) {
            *row->depth = (uint16_t)(row->z >> 16);
            *row->pixel = (uint16_t)qtri_packed_pixel(row->packed);
        }
        row->z += job->depth.dx;
        row->packed += phase % 8 == 7 ? step->last : (phase % 2 == 0 ? step->even : step->odd);
        row->depth++;
        row->pixel++;
    }
}

static bool next_run(qtri_packed_row *row, const qtri_job *job)
{
    if (row->rest <= 0) {
        return false;
    }
    row->packed = qtri_packed_next(row, job);
    row->part = qtri_packed_part(row->rest);
    row->rest -= row->part;
    return true;
}

bool qtri_packed_cut(qtri_packed_row *row, const qtri_job *job, int32_t skip)
{
    const int32_t to_group = -skip & 7;
    const int32_t count = to_group < row->part ? to_group : row->part;
    row->packed += qtri_packed_skip(job, skip);
    draw(row, job, skip, count);
    row->part -= count;
    return row->part > 0 || next_run(row, job);
}

#if QTRI_PAIRS || defined(__OPTIMIZE_SIZE__)

/* Small code: where there are pairs, few surfaces need it. */
void qtri_packed_singly(qtri_packed_row *row, const qtri_job *job)
{
    do {
        draw(row, job, 0, row->part);
    } while (next_run(row, job));
}

#else

#define PIXEL(i, step)                                                                             \
    if (z >> 16 < depth[i]) {                                                                      \
        QTRI_BRANCH                                                                                \
        depth[i] = (uint16_t)(z >> 16);                                                            \
        pixel[i] = (uint16_t)qtri_packed_pixel(packed);                                            \
    }                                                                                              \
    z += depth_step;                                                                               \
    packed += (step);                                                                              \
    QTRI_OPAQUE(z)                                                                                 \
    QTRI_OPAQUE(packed)                                                                            \
    QTRI_ASIDE(depth_step)                                                                         \
    QTRI_ASIDE(even)                                                                               \
    QTRI_ASIDE(odd)

void qtri_packed_singly(qtri_packed_row *row, const qtri_job *job)
{
    uint32_t depth_step = job->depth.dx;
    uint32_t even = job->color.word.step.even;
    uint32_t odd = job->color.word.step.odd;
    const uint32_t last = job->color.word.step.last;
    uint16_t *pixel = row->pixel;
    uint16_t *depth = row->depth;
    uint32_t z = row->z;
    uint32_t packed = row->packed;
    int32_t count = row->part;
    int32_t rest = row->rest;
    for (;;) {
        if (count >= 8) {
            const uint16_t *stop = depth + (count & ~7);
            do {
                PIXEL(0, even)
                PIXEL(1, odd)
                PIXEL(2, even)
                PIXEL(3, odd)
                PIXEL(4, even)
                PIXEL(5, odd)
                PIXEL(6, even)
                PIXEL(7, last)
                QTRI_MOVE(8)
            } while (depth != stop);
        }
        if (count & 4) {
            PIXEL(0, even)
            PIXEL(1, odd)
            PIXEL(2, even)
            PIXEL(3, odd)
            depth += 4;
            pixel += 4;
        }
        if (count & 2) {
            PIXEL(0, even)
            PIXEL(1, odd)
            depth += 2;
            pixel += 2;
        }
        if (count & 1) {
            PIXEL(0, even)
            depth++;
            pixel++;
        }
        if (rest <= 0) {
            return;
        }
        packed = qtri_packed_next(row, job);
        count = qtri_packed_part(rest);
        rest -= count;
    }
}

#endif

/* A tiny triangle: values at column 0 step from row to row, and a span needs no groups. */
void qtri_fill_tiny_less(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count)
{
    const qtri_raster *raster = job->raster;
    const ptrdiff_t pitch = raster->surface->pitch;
    const ptrdiff_t depth_pitch = raster->surface->depth_pitch;
    qtri_lines lines = qtri_lines_at(raster->surface, row);
    uint32_t depth_step = job->depth.dx;
    uint32_t step = job->color.word.step.even;
    uint32_t depth_row = qtri_ramp_at(&job->depth, -job->anchor_x, row - job->anchor_y);
    uint32_t packed_row = qtri_packed_tiny(job, -job->anchor_x, row - job->anchor_y);
    for (; count > 0; count--) {
        int32_t x = spans->left;
        int32_t stop = spans->right;
        if (job->cut) {
            stop = qtri_span_clip(spans, &raster->bounds, &x);
            stop += x;
        }
        if (x < stop) {
            uint16_t *pixels = (uint16_t *)(void *)lines.pixels;
            uint16_t *depths = lines.depths;
            uint32_t z = depth_row + (uint32_t)x * depth_step;
            uint32_t packed = packed_row + (uint32_t)x * step;
            do {
                if (z >> 16 < depths[x]) {
                    QTRI_BRANCH
                    depths[x] = (uint16_t)(z >> 16);
                    pixels[x] = (uint16_t)qtri_packed_pixel(packed);
                }
                z += depth_step;
                packed += step;
                QTRI_ASIDE(depth_step)
                QTRI_ASIDE(step)
            } while (++x < stop);
        }
        spans++;
        depth_row += job->depth.dy;
        packed_row += job->color.word.dy;
        lines.pixels += pitch;
        lines.depths += depth_pitch;
    }
}

void qtri_fill_packed_less(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count)
{
    qtri_packed_rows(job, spans, row, count, qtri_packed_singly);
}
