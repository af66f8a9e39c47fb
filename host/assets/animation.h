/* SPDX-License-Identifier: MIT */
/*
 * Frames on their way to files: one of all frames, APNG or YUV4MPEG2, or a picture each.
 */
#ifndef QTRI_HOST_ASSETS_ANIMATION_H
#define QTRI_HOST_ASSETS_ANIMATION_H

#include "../io/file.h"
#include "png_write.h"

struct animation {
    const char *path;
    enum { ANIMATION_NUMBERED, ANIMATION_APNG, ANIMATION_Y4M } kind;
    int per_second, count;
    struct file_output output; /* Y4M */
    bool is_open;
    struct apng apng;
};

/*
 * .apng is one animated picture; .y4m, or what is a stream, video without loss but that of its
 * colours; NAME.png and others are NAME-0000.png and so on, each complete when it is there.
 */
void animation_begin(struct animation *animation, const char *path, int per_second);

/* False with *error set. */
bool animation_add(struct animation *animation, const struct picture *picture,
                   struct text_error *error);

/* Ends the file with the frames that were added. */
bool animation_end(struct animation *animation, struct text_error *error);

#endif
