/* SPDX-License-Identifier: MIT */
#define QTRI_LONG_MULTIPLY 0
#define QTRI_DIVIDE        0

/* GCC does not see that the generic instance reads only the ramps that its options also set. */
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#define qtri_small_are_linear            narrow_small_are_linear
#define qtri_small_color                 narrow_small_color
#define qtri_small_cut                   narrow_small_cut
#define qtri_small_find                  narrow_small_find
#define qtri_small_lit_channels          narrow_small_lit_channels
#define qtri_small_set_alpha             narrow_small_set_alpha
#define qtri_small_set_colors_565        narrow_small_set_colors_565
#define qtri_small_round_steps           narrow_small_round_steps
#define qtri_small_set_colors_888        narrow_small_set_colors_888
#define qtri_small_set_colors_gray       narrow_small_set_colors_gray
#define qtri_small_color_curves_next_row narrow_small_color_curves_next_row
#define qtri_small_add_divided           narrow_small_add_divided
#define qtri_small_begin_division        narrow_small_begin_division
#define qtri_small_chord_log2            narrow_small_chord_log2
#define qtri_small_divide                narrow_small_divide
#define qtri_small_end_division          narrow_small_end_division
#define qtri_small_set_light_along       narrow_small_set_light_along
#define qtri_small_find_inv_w_deltas     narrow_small_find_inv_w_deltas
#define qtri_small_find_light            narrow_small_find_light
#define qtri_small_is_near_curve         narrow_small_is_near_curve
#define qtri_small_set_color_chord       narrow_small_set_color_chord
#define qtri_small_set_color_curves      narrow_small_set_color_curves
#define qtri_small_set_curvature         narrow_small_set_curvature
#define qtri_small_set_curve             narrow_small_set_curve
#define qtri_small_find_uneven           narrow_small_find_uneven
#define qtri_small_is_linear_by_range    narrow_small_is_linear_by_range
#define qtri_small_ramp_set_at           narrow_small_ramp_set_at
#define qtri_small_turn                  narrow_small_turn
#define qtri_small_light_is_linear       narrow_small_light_is_linear
#define qtri_small_set_linear_texture    narrow_small_set_linear_texture
#define qtri_small_set_light             narrow_small_set_light
#define qtri_small_set_curves            narrow_small_set_curves
#define qtri_small_set_level             narrow_small_find_level
#define qtri_small_find_level            narrow_small_find_level
#define qtri_small_set_light_curve       narrow_small_set_light_curve
#define qtri_small_set_weights           narrow_small_set_weights

#include "raster/small_triangle.c"
#include "raster/small_values.c"

#include "raster/small_curves.c"
#include "raster/small_division.c"
#include "raster/small_texture.c"

#include "qtri/body/small.h"
#include "small_narrow.h"

static void pixel(qtri_pixel_walk *w, bool bent, uint8_t *at, uint8_t *depth)
{
    qtri_pixel_at(&w->state->options, w, bent, at, depth);
}

bool narrow_small_draw(struct qtri_small *triangle)
{
    return qtri_small_triangle_draw(&triangle->state->options, pixel, triangle);
}
