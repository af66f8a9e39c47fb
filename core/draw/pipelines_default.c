/* SPDX-License-Identifier: MIT */
/* What a view draws with that names no pipelines of its own. */
#include "qtri/pipeline.h"

const qtri_pipeline *const qtri_pipelines_default[] = {&qtri_pipeline_flat,
                                                       &qtri_pipeline_lit,
                                                       &qtri_pipeline_colors,
                                                       &qtri_pipeline_texture,
                                                       &qtri_pipeline_texture_tint,
                                                       &qtri_pipeline_texture_lit,
                                                       &qtri_pipeline_texture_white,
                                                       &qtri_pipeline_mipmapped,
                                                       &qtri_pipeline_mipmapped_lit,
                                                       &qtri_pipeline_mipmapped_white,
                                                       &qtri_pipeline_brought,
                                                       &qtri_pipeline_any,
                                                       NULL};

void qtri_view_init(qtri_view *view, int32_t frame_width, int32_t frame_height)
{
    qtri_view_init_pipelines(view, frame_width, frame_height, qtri_pipelines_default);
}
