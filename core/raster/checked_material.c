/* SPDX-License-Identifier: MIT */
#include "checked_material.h"

#ifdef QTRI_CHECKED

void qtri_check_surface(const qtri_surface *surface)
{
    QTRI_ASSERT(surface != NULL);
    if (surface->format == NULL) {
        return; /* nothing is drawn */
    }
    QTRI_ASSERT(surface->pixels != NULL);
    QTRI_ASSERT(surface->width >= 1 && surface->width <= QTRI_SURFACE_MAX);
    QTRI_ASSERT(surface->height >= 1 && surface->height <= QTRI_SURFACE_MAX);
    QTRI_ASSERT(surface->first_row >= 0 && surface->rows >= 0);
    qtri_check_format(surface->format);
    qtri_check_depth_format(surface->depth_format);
}

/* A number of an enum is signed or not, as the compiler likes. */
static bool is_one_of(long long value, long long last)
{
    return value >= 0 && value <= last;
}

static void check_texture(const qtri_texture *texture)
{
    QTRI_ASSERT(texture->format != NULL);
    QTRI_ASSERT(texture->format->colors != NULL);
    QTRI_ASSERT(texture->format->usable != NULL);
    QTRI_ASSERT(texture->format->fetch != NULL || texture->format->kind != QTRI_NO_TEXEL);
    QTRI_ASSERT(texture->format->usable(texture)); /* texels, and a palette where it has one */
    QTRI_ASSERT(texture->width_log2 <= 10 && texture->height_log2 <= 10);
    QTRI_ASSERT(is_one_of(texture->wrap_u, QTRI_CLAMP));
    QTRI_ASSERT(is_one_of(texture->wrap_v, QTRI_CLAMP));
}

void qtri_check_material(const qtri_material *material)
{
    QTRI_ASSERT(material != NULL);
    QTRI_ASSERT(is_one_of(material->interpolation, QTRI_SCREEN_LINEAR));
    QTRI_ASSERT(is_one_of(material->texture_mode, QTRI_REPLACE));
    QTRI_ASSERT(is_one_of(material->cull, QTRI_CULL_FRONT));
    QTRI_ASSERT(is_one_of(material->depth_compare, QTRI_ALWAYS));
    if (material->texture != NULL) {
        check_texture(material->texture);
    }
}

#ifdef QTRI_MISSING
void QTRI_MISSING(const qtri_options *wanted);
#endif

void qtri_check_pipeline(const qtri_pipeline *found, const qtri_options *wanted)
{
#ifdef QTRI_MISSING
    if (found == NULL) {
        QTRI_MISSING(wanted);
    }
#else
    (void)wanted; /* a debugger shows them */
#endif
    QTRI_ASSERT(found != NULL);
}

/*
 * Of pixels: what is left of 1/128, to which widths are rounded. Points in object space may be
 * small where the object is: no less than what checked builds take for a length.
 */
static bool is_width(const qtri_stroke *stroke)
{
    return stroke->width <= 0 || stroke->width >= (stroke->in_space ? 16 : 512);
}

void qtri_check_stroke(const qtri_stroke *stroke)
{
    QTRI_ASSERT(stroke != NULL);
    QTRI_ASSERT(is_width(stroke));
}

#else

/* C99 wants a declaration in every file. */
typedef int qtri_raster_is_not_checked;

#endif
