#include "small.h"

/* Positions, area and anchor: as of the general path, see setup.c. */
static inline void gradient_from(qtri_gradient *g, const qtri_triangle *t, uint32_t size)
{
    const int32_t zeros = qtri_clz32(size | 1u);
    g->area = t->area;
    qtri_gradient_set_inverse(g, qtri_reciprocal_below(size << zeros) >> 1, zeros);
    g->x_24p8 = t->p[0]->x_24p8;
    g->y_24p8 = t->p[0]->y_24p8;
    g->dx1 = t->p[1]->x_24p8 - g->x_24p8;
    g->dy1 = t->p[1]->y_24p8 - g->y_24p8;
    g->dx2 = t->p[2]->x_24p8 - g->x_24p8;
    g->dy2 = t->p[2]->y_24p8 - g->y_24p8;
    g->anchor_x = (t->x_least + t->x_greatest) >> 9;
    g->anchor_y = (t->top->y_24p8 + t->bottom->y_24p8) >> 9;
    g->anchor_dx = g->anchor_x * 256 + 128 - g->x_24p8;
    g->anchor_dy = g->anchor_y * 256 + 128 - g->y_24p8;
}

bool qtri_small_draw(const qtri_raster *raster, const qtri_triangle *t, const qtri_vertex *a,
                     const qtri_vertex *b, const qtri_vertex *c, uint32_t intensity_q15)
{
    const uint32_t size = qtri_magnitude32((int32_t)t->area);
    if (!raster->small || t->size == QTRI_LARGE || qtri_gradient_is_sliver(size, t->extent) ||
        !qtri_depths_are_close(a, b, c)) {
        return false;
    }
    qtri_gradient gradient;
    qtri_job job;
    gradient_from(&gradient, t, size);
    job.raster = raster;
    job.anchor_x = gradient.anchor_x;
    job.anchor_y = gradient.anchor_y;
    job.pixel = qtri_raster_shade_565(raster, intensity_q15);
    qtri_ramp_from_steps(&job.depth, &gradient, a->depth_16p8 & ~0xFFu, qtri_depth_step(a, b),
                         qtri_depth_step(a, c));
    raster->fill_flat(&job, t->spans, t->row, t->end - t->row);
    return true;
}
