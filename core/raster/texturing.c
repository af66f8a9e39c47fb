/* SPDX-License-Identifier: MIT */
#include "list_values.h"
#include "textured.h"

const qtri_texturing qtri_texturing_stages = {
    qtri_textured_init,   qtri_textured_axes, qtri_textured_begin_large, qtri_textured_chunk,
    qtri_list_set_texels, qtri_list_texels,   qtri_list_finish_texels};
