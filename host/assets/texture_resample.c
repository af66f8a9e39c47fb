/* SPDX-License-Identifier: MIT */
#include "texture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../io/mipmap.h"

int texture_nearest_side(int side)
{
    int power = 1;
    while (power < TEXTURE_MAX_SIDE && (double)side > power * 1.41421356237) {
        power *= 2;
    }
    return power;
}

/* Light of three channels times opacity, and opacity. */
struct plane {
    int width, height;
    float (*pixels)[4];
};

static bool plane_create(struct plane *plane, int width, int height)
{
    plane->width = width;
    plane->height = height;
    plane->pixels = calloc((size_t)width * (size_t)height, sizeof *plane->pixels);
    return plane->pixels != NULL;
}

static bool plane_of(const struct image *image, struct plane *plane)
{
    float linear[256];
    if (!plane_create(plane, image->width, image->height)) {
        return false;
    }
    for (int i = 0; i < 256; i++) {
        linear[i] = (float)mipmap_to_linear(i / 255.0);
    }
    size_t count = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < count; i++) {
        const uint8_t *pixel = &image->rgba[4 * i];
        float opacity = (float)pixel[3] / 255.0F;
        for (int channel = 0; channel < 3; channel++) {
            plane->pixels[i][channel] = linear[pixel[channel]] * opacity;
        }
        plane->pixels[i][3] = opacity;
    }
    return true;
}

/* One line, whose pixels lie `stride` apart, to another length. */
static void resample_line(const float (*from)[4], int from_count, size_t from_stride,
                          float (*to)[4], int to_count, size_t to_stride)
{
    double step = (double)from_count / to_count;
    double reach = fmax(step, 1.0); /* of the triangle, to either side */
    for (int i = 0; i < to_count; i++) {
        double center = (i + 0.5) * step - 0.5;
        double sum[4] = {0.0, 0.0, 0.0, 0.0}, weights = 0.0;
        int last = (int)ceil(center + reach);
        for (int at = (int)floor(center - reach); at <= last; at++) {
            double weight = 1.0 - fabs(at - center) / reach;
            int held = at < 0 ? 0 : at >= from_count ? from_count - 1 : at;
            if (weight > 0.0) {
                weights += weight;
                for (int channel = 0; channel < 4; channel++) {
                    sum[channel] += weight * (double)from[(size_t)held * from_stride][channel];
                }
            }
        }
        for (int channel = 0; channel < 4; channel++) {
            to[(size_t)i * to_stride][channel] = (float)(sum[channel] / weights);
        }
    }
}

static uint8_t byte_of(double value)
{
    return (uint8_t)lround(255.0 * fmin(fmax(value, 0.0), 1.0));
}

static bool image_of(const struct plane *plane, struct image *out)
{
    size_t count = (size_t)plane->width * (size_t)plane->height;
    out->width = plane->width;
    out->height = plane->height;
    out->rgba = calloc(count, 4);
    for (size_t i = 0; out->rgba != NULL && i < count; i++) {
        double opacity = (double)plane->pixels[i][3];
        for (int channel = 0; channel < 3 && opacity > 0.0; channel++) {
            double light = (double)plane->pixels[i][channel] / opacity;
            out->rgba[4 * i + (size_t)channel] = byte_of(mipmap_from_linear(light));
        }
        out->rgba[4 * i + 3] = byte_of(opacity);
    }
    return out->rgba != NULL;
}

static bool resize(const struct image *image, struct plane planes[3], int width, int height,
                   struct image *out)
{
    struct plane *from = &planes[0], *across = &planes[1], *down = &planes[2];
    if (!plane_of(image, from) || !plane_create(across, width, image->height) ||
        !plane_create(down, width, height)) {
        return false;
    }
    for (int y = 0; y < from->height; y++) {
        size_t row = (size_t)y;
        resample_line((const float(*)[4]) & from->pixels[row * (size_t)from->width], from->width, 1,
                      &across->pixels[row * (size_t)width], width, 1);
    }
    for (int x = 0; x < width; x++) {
        resample_line((const float(*)[4]) & across->pixels[x], across->height, (size_t)width,
                      &down->pixels[x], height, (size_t)width);
    }
    return image_of(down, out);
}

bool texture_resample(const struct image *image, int width, int height, struct image *out)
{
    struct plane planes[3];
    memset(planes, 0, sizeof planes);
    memset(out, 0, sizeof *out);
    if (width == image->width && height == image->height) {
        size_t bytes = (size_t)width * (size_t)height * 4;
        *out = *image;
        out->rgba = malloc(bytes);
        if (out->rgba != NULL) {
            memcpy(out->rgba, image->rgba, bytes);
        }
        return out->rgba != NULL;
    }
    bool ok = resize(image, planes, width, height, out);
    for (int i = 0; i < 3; i++) {
        free(planes[i].pixels);
    }
    return ok;
}
