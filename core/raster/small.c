#include "small.h"

#include "setup.h"

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
    const int32_t zeros = qtri_clz32(size | 1u);
    qtri_gradient_place(&gradient, t);
    qtri_gradient_set_inverse(&gradient, qtri_reciprocal_below(size << zeros) >> 1, zeros);
    qtri_gradient_set_middle(&gradient, t);
    job.raster = raster;
    job.anchor_x = gradient.anchor_x;
    job.anchor_y = gradient.anchor_y;
    job.pixel = qtri_raster_shade_565(raster, intensity_q15);
    qtri_ramp_from_steps(&job.depth, &gradient, a->depth_16p8 & ~0xFFu, qtri_depth_step(a, b),
                         qtri_depth_step(a, c));
    raster->fill_flat(&job, t->spans, t->row, t->end - t->row);
    return true;
}
