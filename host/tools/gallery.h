/* SPDX-License-Identifier: MIT */
/*
 * The demo's pictures as one page that needs nothing else: each scene as the core draws it, as
 * double precision does, and how they differ, with what it shows and its figures.
 */
#ifndef QTRI_HOST_TOOLS_GALLERY_H
#define QTRI_HOST_TOOLS_GALLERY_H

#include "../assets/png_write.h"
#include "../io/picture.h"
#include "../io/text_error.h"
#include "accuracy.h"

struct gallery { /* begins with zeros */
    struct byte_list page;
    bool is_short; /* of memory */
};

/* A scene, its pictures: core, double precision, difference; and errors against the reference, as
   it is and with vertices snapped as the core does. */
struct gallery_scene {
    const char *name;
    const char *text; /* of the scene file: the comments it begins with say what it shows */
    size_t length;
    const struct picture *pictures[3];
    const struct accuracy *exact, *snapped;
};

void gallery_add(struct gallery *gallery, const struct gallery_scene *scene);

/* Writes the page and frees it. False with *error set, also where memory ran out before. */
bool gallery_write(struct gallery *gallery, const char *path, struct text_error *error);

#endif
