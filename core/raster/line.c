/* SPDX-License-Identifier: MIT */
/* Lines one pixel wide: clipped to the bounds, and cut into runs of a chunk. */
#include "line.h"

#include <string.h>

#include "../bits/bits.h"
#include "large_setup.h"
#include "line_path.h"

void qtri_line_end(qtri_vertex *end, qtri_line_color color, const qtri_screen_vertex *v)
{
    const uint32_t farthest = (uint32_t)65535 << 16;
    end->at.x_24p8 = qtri_hold32(v->x_24p8, -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
    end->at.y_24p8 = qtri_hold32(v->y_24p8, -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
    end->depth_16p8 = v->depth_16p16 < farthest ? v->depth_16p16 : farthest;
    for (int i = 0; i < 3; i++) {
        color[i] = qtri_hold32(v->color_8p16[i], 0, 255 << 16);
    }
}

/* Bounds of a path: pixels begin..end - 1 on the major axis, minor_count from `minor` on. */
typedef struct limits {
    int32_t begin, end, minor;
    uint32_t minor_count;
} limits;

static limits limits_of(const qtri_line_job *job, const qtri_line_path *l)
{
    const qtri_rect *b = &job->to->state.bounds;
    const limits steep = {b->y0 - l->position, b->y1 - l->position, b->x0,
                          (uint32_t)(b->x1 - b->x0)};
    const limits flat = {b->x0 - l->position, b->x1 - l->position, b->y0,
                         (uint32_t)(b->y1 - b->y0)};
    return l->steep ? steep : flat;
}

/* Moves w to the first pixel inside; returns how many follow that are, of those before `end`. */
static int32_t clip(qtri_line_walk *w, const limits *in, int32_t end)
{
    end = qtri_least32(end, in->end);
    while (w->k < end &&
           (w->k < in->begin || (uint32_t)(w->minor.value - in->minor) >= in->minor_count)) {
        qtri_dda_next(&w->minor);
        w->k++;
    }
    qtri_dda ahead = w->minor;
    int32_t k = w->k;
    for (; k < end && (uint32_t)(ahead.value - in->minor) < in->minor_count; k++) {
        qtri_dda_next(&ahead);
    }
    return k - w->k;
}

int32_t qtri_line_clip_short(qtri_line_walk *w, const qtri_line_job *job, const qtri_line_path *l)
{
    const limits in = limits_of(job, l);
    return clip(w, &in, l->count);
}

/* A ramp along a line from pixel `start`, with which a chunk begins. */
QTRI_NOINLINE static void ramp_init(qtri_line_ramp *r, int32_t from, int32_t to, int32_t along,
                                    const qtri_divider *by, int32_t start)
{
    if (start == 0) {
        qtri_line_ramp_short(r, from, to, along, by);
        return;
    }
    along += 256 * start; /* < length */
    const int32_t quotient = qtri_divide(to - from, by);
    const int32_t remainder = to - from - quotient * (int32_t)by->divisor; /* < 2^23 */
    const int64_t product = qtri_mul_s32(remainder, along);                /* < 2^46 */
    uint32_t unused;
    uint32_t rest = qtri_divide_long(qtri_magnitude64(product), by->divisor, &unused);
    rest = product < 0 ? 0 - rest : rest;
    r->value = (uint32_t)(from + quotient * along) + rest;
    r->step = (uint32_t)quotient * 256u + (uint32_t)qtri_divide(remainder * 256, by);
}

/* The colours of a line's ends: color[turned] at a, or the material's in the light of a and b. */
static void set_ends(qtri_line_color at_a, qtri_line_color at_b, const qtri_line_job *job,
                     const qtri_vertex *a, const qtri_vertex *b, const qtri_line_color *color,
                     bool turned)
{
    if (color == NULL) {
        qtri_line_color_set(at_a, &job->to->material.color, a->intensity_q15);
        qtri_line_color_set(at_b, &job->to->material.color, b->intensity_q15);
    } else {
        memcpy(at_a, color[turned], sizeof color[0]);
        memcpy(at_b, color[!turned], sizeof color[0]);
    }
}

bool qtri_line_has_table(const qtri_line_job *job)
{
    qtri_draw_state *state = &job->to->state;
    if (!state->has_table && qtri_kind_of(&state->options) == QTRI_IN_565) {
        qtri_draw_state_set_table(state);
    }
    return state->has_table;
}

void qtri_line_look(qtri_stroke_look *look, const qtri_line_job *job, const qtri_vertex *a,
                    const qtri_vertex *b, const qtri_line_color *color, bool turned)
{
    qtri_stroke_end end[2];
    end[0].depth_16p8 = a->depth_16p8 & job->depth_mask;
    end[1].depth_16p8 = b->depth_16p8 & job->depth_mask;
    if (color == NULL && qtri_line_has_table(job)) {
        qtri_stroke_look_set_depth(look, end[0].depth_16p8, end[1].depth_16p8);
        look->is_constant = look->has_one_color = false;
        look->light_table = job->to->state.table;
        look->light_q29 = (int32_t)((uint32_t)a->intensity_q15 << 14);
        look->light_step = (int32_t)b->intensity_q15 - (int32_t)a->intensity_q15;
        return;
    }
    set_ends(end[0].color_8p16, end[1].color_8p16, job, a, b, color, turned);
    qtri_stroke_look_init(look, end);
}

/* Colours from pixel `start` of the line on; see qtri_line_draws. */
QTRI_NOINLINE static void set_colors(qtri_line_run *run, const qtri_line_job *job,
                                     const qtri_line_path *l, const qtri_divider *by, int32_t start,
                                     const qtri_line_color *color)
{
    qtri_line_color first, last;
    uint32_t from[3], to[3];
    set_ends(first, last, job, l->first, l->last, color, l->turned);
    job->packing->channels(from, (const uint32_t *)first);
    job->packing->channels(to, (const uint32_t *)last);
    run->has_one_color = true;
    for (int i = 0; i < 3; i++) {
        const int32_t half = 0x8000; /* rounds */
        run->color[i].value = from[i] + (uint32_t)half;
        run->color[i].step = 0;
        if (from[i] != to[i]) {
            ramp_init(&run->color[i], (int32_t)from[i] + half, (int32_t)to[i] + half, l->along, by,
                      start);
            run->has_one_color = false;
        }
    }
}

/* Draws a run; pixels of four samples one by one. */
static void draw_run(qtri_stroke_target *to, const qtri_line_run *run, qtri_line_runs draw)
{
    if (to->samples == NULL) {
        draw(run);
        return;
    }
    qtri_line_run one = *run;
    one.count = 1;
    for (int32_t i = 0; i < run->count; i++) {
        qtri_stroke_sample sample;
        const int32_t minor = one.walk.minor.value;
        one.y = run->is_steep ? run->y + i : minor;
        qtri_stroke_sample_begin(&sample, to, run->is_steep ? minor : run->x + i, one.y);
        one.x = sample.x;
        draw(&one);
        qtri_stroke_sample_end(&sample, to);
        qtri_dda_next(&one.walk.minor);
        one.z.value += one.z.step;
        for (int k = 0; k < 3; k++) {
            one.color[k].value += one.color[k].step;
        }
    }
}

QTRI_NOINLINE static void draw_long(const qtri_line_job *job, const qtri_line_path *l,
                                    const qtri_line_color *color, qtri_line_runs draw)
{
    const limits in = limits_of(job, l);
    qtri_divider by;
    qtri_line_run run;
    const int32_t minor_first = (l->minor >> 8) - in.minor;
    const int32_t minor_last = ((l->minor + l->delta) >> 8) - in.minor;
    const int32_t minor_end = (int32_t)in.minor_count;
    const int32_t count = qtri_least32(l->count, in.end);
    int32_t k = qtri_greatest32(0, in.begin);
    if (k >= count || (minor_first < 0 && minor_last < 0) ||
        (minor_first >= minor_end && minor_last >= minor_end)) {
        return;
    }
    qtri_divider_init(&by, (uint32_t)l->length);
    run.is_lit = false;
    while (k < count) {
        const int32_t start = k & ~(QTRI_LINE_CHUNK - 1);
        run.walk.k = k;
        qtri_dda_init(&run.walk.minor, l->minor, l->delta, l->length, l->along + 256 * k, 0);
        k = qtri_least32(count, start + QTRI_LINE_CHUNK);
        run.count = clip(&run.walk, &in, k);
        if (run.count > 0) {
            ramp_init(&run.z, qtri_line_depth(job, l->first), qtri_line_depth(job, l->last),
                      l->along, &by, start);
            set_colors(&run, job, l, &by, start, color);
            qtri_line_run_place(&run, job, l, start);
            draw_run(job->to, &run, draw);
        }
    }
}

void qtri_line_draw(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                    const qtri_line_color *color, qtri_line_runs draw)
{
    qtri_line_path l;
    qtri_line_path_init(&l, a, b);
    if ((uint32_t)(l.count - 1) >= QTRI_LINE_CHUNK) {
        draw_long(job, &l, color, draw);
        return;
    }
    qtri_line_run run;
    qtri_divider by;
    qtri_line_walk_short(&run.walk, &l);
    run.count = qtri_line_is_inside(job, &l) ? l.count : qtri_line_clip_short(&run.walk, job, &l);
    if (run.count <= 0) {
        return;
    }
    qtri_line_run_depth(&run, &by, job, &l, true);
    if (color == NULL && qtri_line_has_table(job)) {
        qtri_line_run_light(&run, &l, &by);
        run.color[1] = run.color[2] = run.color[0]; /* they do not count */
    } else {
        run.is_lit = false;
        set_colors(&run, job, &l, &by, 0, color);
    }
    qtri_line_run_place(&run, job, &l, 0);
    draw_run(job->to, &run, draw);
}
