#ifndef QTRI_TESTS_SUPPORT_LINE_NARROW_H
#define QTRI_TESTS_SUPPORT_LINE_NARROW_H

#include <qtri.h>

/* qtri_raster_line without long multiply and divide. */
void narrow_raster_line(const qtri_surface *surface, const qtri_material *material,
                        const qtri_screen_vertex v[2]);

/* A channel of RGB565 of 31 or 63 steps, n.16, and half a step. */
int32_t narrow_line_channel(int32_t color_8p16, uint32_t steps);

#endif
