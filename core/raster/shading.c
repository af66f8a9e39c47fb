/* SPDX-License-Identifier: MIT */
#include "shading.h"

const qtri_shading qtri_flat_first = {0, NULL, NULL};
const qtri_shading qtri_flat_last = {2, NULL, NULL};

const qtri_shading *qtri_shading_of(const qtri_material *material)
{
    return material->shading != NULL ? material->shading : &qtri_flat_last;
}

bool qtri_is_smooth(const qtri_material *material)
{
    return qtri_shading_of(material)->varying != NULL;
}

int qtri_provoking_of(const qtri_material *material)
{
    return qtri_shading_of(material)->provoking;
}
