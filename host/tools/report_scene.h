/* SPDX-License-Identifier: MIT */
/*
 * A scene of the accuracy report: the core's picture over that of double precision, with a slider
 * between them, and how many pixels are off by how much. `make report` puts them into its page.
 */
#ifndef QTRI_HOST_TOOLS_REPORT_SCENE_H
#define QTRI_HOST_TOOLS_REPORT_SCENE_H

#include "gallery.h"

void report_scene_add(struct html *page, const struct gallery_scene *scene);

#endif
