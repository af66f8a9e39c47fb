/* SPDX-License-Identifier: MIT */
/*
 * The demo's pictures as one page that needs nothing else: each scene as the core draws it, as
 * double precision does, and how they differ, with what it shows and its figures.
 */
#ifndef QTRI_HOST_TOOLS_GALLERY_H
#define QTRI_HOST_TOOLS_GALLERY_H

#include "accuracy.h"
#include "html.h"

/* A scene, its pictures: core, double precision, difference; and errors against the reference, as
   it is and with vertices snapped as the core does. */
struct gallery_scene {
    const char *name;
    const char *text; /* of the scene file: the comments it begins with say what it shows */
    size_t length;
    const struct picture *pictures[3];
    const struct accuracy *exact, *snapped;
};

void gallery_add(struct html *page, const struct gallery_scene *scene);

/* The scene in the accuracy report, whose page `make report` makes: the core's picture over that of
   double precision, with a slider between them, and how many pixels are off by how much. */
void gallery_add_to_report(struct html *page, const struct gallery_scene *scene);

/* Writes the page and frees it. False with *error set, also where memory ran out before. */
bool gallery_write(struct html *page, const char *path, struct text_error *error);

#endif
