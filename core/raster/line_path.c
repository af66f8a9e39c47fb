/* SPDX-License-Identifier: MIT */
/* What of a line is inside of the bounds. */
#include "line_path.h"

void qtri_line_limits_init(qtri_line_limits *in, const qtri_line_job *job, const qtri_line_path *l)
{
    const int32_t left = job->left_24p8 >> 8;
    const int32_t top = job->top_24p8 >> 8;
    const int32_t width = (int32_t)(job->width_24p8 >> 8);
    const int32_t height = (int32_t)(job->height_24p8 >> 8);
    in->begin = (l->steep ? top : left) - l->position;
    in->end = in->begin + (l->steep ? height : width);
    in->minor = l->steep ? left : top;
    in->minor_count = (uint32_t)(l->steep ? width : height);
}

int32_t qtri_line_walk_cut(qtri_line_walk *w, const qtri_line_limits *in, int32_t end)
{
    end = qtri_least32(end, in->end);
    while (w->k < end &&
           (w->k < in->begin || (uint32_t)(w->minor - in->minor) >= in->minor_count)) {
        qtri_line_walk_next(w);
    }
    qtri_line_walk ahead = *w;
    while (ahead.k < end && (uint32_t)(ahead.minor - in->minor) < in->minor_count) {
        qtri_line_walk_next(&ahead);
    }
    return ahead.k;
}

int32_t qtri_line_cut_short(qtri_line_walk *w, const qtri_line_job *job, const qtri_line_path *l)
{
    qtri_line_limits in;
    qtri_line_limits_init(&in, job, l);
    return qtri_line_walk_cut(w, &in, l->count);
}
