/* SPDX-License-Identifier: MIT */
#include "animation.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../io/xalloc.h"
#include "image.h"

void animation_begin(struct animation *animation, const char *path, int per_second)
{
    memset(animation, 0, sizeof *animation);
    animation->path = path;
    animation->per_second = per_second;
    animation->apng.per_second = (uint16_t)per_second;
    animation->kind = file_name_ends_in(path, ".apng") ? ANIMATION_APNG
                      : file_name_ends_in(path, ".y4m") || file_is_stream(path)
                          ? ANIMATION_Y4M
                          : ANIMATION_NUMBERED;
}

/* NAME.png becomes NAME-0012.png. */
static bool write_numbered(const struct animation *animation, const struct picture *picture,
                           struct text_error *error)
{
    const char *path = animation->path;
    const bool is_named = file_name_ends_in(path, ".ppm") || file_name_ends_in(path, ".png");
    const int stem = (int)strlen(path) - (is_named ? 4 : 0);
    const size_t size = strlen(path) + 32;
    char *name = xcalloc(size, 1);
    (void)snprintf(name, size, "%.*s-%04d%s", stem, path, animation->count,
                   is_named ? path + stem : ".ppm");
    const bool ok = image_write_picture(name, picture, error);
    free(name);
    return ok;
}

/* 0..255 of ITU-R BT.601, a plane after the other, none subsampled. */
static void write_planes(struct file_output *output, const struct picture *picture)
{
    static const double weights[3][4] = {
        {.299, .587, .114, 0}, {-.168736, -.331264, .5, 128}, {.5, -.418688, -.081312, 128}};
    const size_t count = (size_t)picture->width * (size_t)picture->height;
    for (int plane = 0; plane < 3; plane++) {
        const double *w = weights[plane];
        for (size_t i = 0; i < count; i++) {
            const uint8_t *rgb = &picture->rgb[3 * i];
            const double value = w[0] * rgb[0] + w[1] * rgb[1] + w[2] * rgb[2] + w[3] + .5;
            const uint8_t byte = (uint8_t)(value > 255 ? 255 : value);
            file_output_write(output, &byte, 1);
        }
    }
}

static bool write_y4m(struct animation *animation, const struct picture *picture,
                      struct text_error *error)
{
    struct file_output *output = &animation->output;
    if (!animation->is_open) {
        if (!file_output_open(output, animation->path, error)) {
            return false;
        }
        char header[100];
        const int length = snprintf(header, sizeof header,
                                    "YUV4MPEG2 W%d H%d F%d:1 Ip A1:1 C444 XCOLORRANGE=FULL\n",
                                    picture->width, picture->height, animation->per_second);
        animation->is_open = true;
        file_output_write(output, header, (size_t)length);
    }
    file_output_write(output, "FRAME\n", 6);
    write_planes(output, picture);
    if (output->failure != 0) {
        animation->is_open = false;
        (void)file_output_commit(output, error); /* says what is wrong */
        return false;
    }
    return true;
}

bool animation_add(struct animation *animation, const struct picture *picture,
                   struct text_error *error)
{
    bool ok = true;
    switch (animation->kind) {
    case ANIMATION_APNG:
        apng_add(&animation->apng, picture);
        break;
    case ANIMATION_Y4M:
        ok = write_y4m(animation, picture, error);
        break;
    default:
        ok = write_numbered(animation, picture, error);
    }
    animation->count += ok;
    return ok;
}

static bool write_apng(struct animation *animation, struct text_error *error)
{
    struct byte_list bytes = {.bytes = NULL};
    struct file_output output;
    apng_finish(&animation->apng, &bytes);
    bool ok = file_output_open(&output, animation->path, error);
    if (ok) {
        file_output_write(&output, bytes.bytes, bytes.count);
        ok = file_output_commit(&output, error);
    }
    free(bytes.bytes);
    return ok;
}

bool animation_end(struct animation *animation, struct text_error *error)
{
    if (animation->kind == ANIMATION_APNG && animation->count > 0) {
        return write_apng(animation, error);
    }
    return !animation->is_open || file_output_commit(&animation->output, error);
}
