/* SPDX-License-Identifier: MIT */
#include "shading.h"

const qtri_varying qtri_varying_stages = {qtri_span_fill, qtri_job_set_varying, qtri_list_set_light,
                                          qtri_list_set_channels, qtri_list_words};

const qtri_shading qtri_smooth = {2, &qtri_varying_stages, NULL};
