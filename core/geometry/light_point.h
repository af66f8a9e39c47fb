/*
 * What point and spot lights share. Internal.
 */
#ifndef QTRI_GEOMETRY_LIGHT_POINT_H
#define QTRI_GEOMETRY_LIGHT_POINT_H

#include "illumination.h"

/* The way from a vertex to a source. */
typedef struct qtri_light_way {
    int32_t direction_q14[3];
    int32_t cosine_q28;  /* between the normal and the direction, > 0 */
    uint32_t distance16; /* times 2^exponent, in local units */
    int32_t exponent;
} qtri_light_way;

bool qtri_light_point_prepare(qtri_shine *out, const qtri_light_source *source,
                              const qtri_light_space *space);

/* False: the source is behind the surface or at the vertex itself. */
bool qtri_light_way_find(qtri_light_way *way, const qtri_shine *source,
                         const qtri_lit_point *point);

/* fade, as a mantissa of up to 2^16 and a shift; false: less than 2^-10. */
typedef struct qtri_light_fade {
    uint32_t mantissa;
    int32_t shift; /* fade = mantissa 2^-(shift - 3), 15..28 */
} qtri_light_fade;

bool qtri_light_fade_find(qtri_light_fade *fade, const qtri_shine *source,
                          const qtri_light_way *way);

/* Adds what is reflected of it. */
void qtri_light_fade_add(qtri_lit_point *point, const qtri_shine *source, const qtri_light_way *way,
                         const qtri_light_fade *fade);

#endif
