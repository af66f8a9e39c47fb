/* SPDX-License-Identifier: MIT */
#include "samples.h"

#include <math.h>

enum { MOST = 16 };

/* Places of a pixel, from its centre. */
struct places {
    int count;
    double at[MOST][2];
};

/* Each in a row and a column of its own of four, 1/8 from their middles: a square turned by
   atan(1/3). */
static const double rotated[4][2] = {
    {-1.0 / 8, -3.0 / 8}, {3.0 / 8, -1.0 / 8}, {-3.0 / 8, 1.0 / 8}, {1.0 / 8, 3.0 / 8}};

/*
 * Van der Corput's sequence: the binary digits of i behind the point, the lowest first. Beside i it
 * makes Hammersley's set; neighbours of which are exchanged.
 */
static double radical_inverse(unsigned i)
{
    double value = 0.0;

    for (double digit = 0.5; i != 0; i /= 2, digit /= 2)
        value += (i % 2) * digit;
    return value;
}

/* A view that is moved to the right and upwards sees what lies to the left and below. */
static void set_temporal(struct places *places)
{
    places->count = 16;
    for (int i = 0; i < 16; i++) {
        double other = radical_inverse((unsigned)i);
        double exchanged = floor(other * 16.0);
        exchanged += fmod(exchanged, 2.0) == 0.0 ? 1.0 : -1.0;
        places->at[i][0] = 0.5 - (i + 0.5) / 16.0;
        places->at[i][1] = (exchanged + 0.5) / 16.0 - 0.5;
    }
}

static void set_places(struct places *places, enum scene_antialias antialias)
{
    places->count = 0;
    switch (antialias) {
    case SCENE_ANTIALIAS_MSAA:
        places->count = 4;
        for (int i = 0; i < 4; i++)
            for (int k = 0; k < 2; k++)
                places->at[i][k] = rotated[i][k];
        break;
    case SCENE_ANTIALIAS_SSAA:
        places->count = 4;
        for (int i = 0; i < 4; i++) {
            places->at[i][0] = i % 2 == 0 ? -0.25 : 0.25;
            places->at[i][1] = i / 2 == 0 ? -0.25 : 0.25;
        }
        break;
    case SCENE_ANTIALIAS_TEMPORAL:
        set_temporal(places);
        break;
    case SCENE_ANTIALIAS_OFF:
    case SCENE_ANTIALIAS_EDGES:
    case SCENE_ANTIALIAS_FXAA:
        break;
    }
}

static struct ref_sampling sampling_of(const struct scene *scene, const struct places *places,
                                       int i)
{
    struct ref_sampling at = {.x = places->at[i][0], .y = places->at[i][1], .scale = 1.0};

    if (scene->antialias == SCENE_ANTIALIAS_MSAA) {
        at.shades_pixels = true;
        at.samples = rotated;
        at.sample_count = 4;
        at.scale = 0.0;
    } else if (scene->antialias == SCENE_ANTIALIAS_SSAA) {
        at.scale = 0.5; /* pixels of half the side */
    }
    return at;
}

/* Adds a picture's colours to those of the first; what a pixel may be off by is the most. */
static void add(struct reference_image *sum, const struct reference_image *one)
{
    size_t pixels = (size_t)sum->width * (size_t)sum->height;

    for (size_t i = 0; i < 3 * pixels; i++) {
        sum->color[i] += one->color[i];
        sum->color_min[i] = fmin(sum->color_min[i], one->color_min[i]);
        sum->color_max[i] = fmax(sum->color_max[i], one->color_max[i]);
    }
    for (size_t i = 0; i < pixels; i++) {
        sum->rounding[i] = fmax(sum->rounding[i], one->rounding[i]);
        sum->edge[i] = fmax(sum->edge[i], one->edge[i]);
        sum->either[i] = fmax(sum->either[i], one->either[i]);
    }
}

bool reference_render(const struct scene *scene, int subpixel_bits, struct reference_image *image)
{
    const struct ref_sampling centre = {.scale = 1.0};
    struct places places;
    size_t colors = 3 * (size_t)scene->width * (size_t)scene->height;

    set_places(&places, scene->antialias);
    if (!ref_render_at(scene, subpixel_bits, &centre, image))
        return false;
    for (size_t i = 0; i < colors && places.count > 0; i++) {
        image->color[i] = 0.0;
        image->color_min[i] = HUGE_VAL;
        image->color_max[i] = -HUGE_VAL;
    }
    for (int i = 0; i < places.count; i++) {
        struct ref_sampling at = sampling_of(scene, &places, i);
        struct reference_image one;
        if (!ref_render_at(scene, subpixel_bits, &at, &one)) {
            reference_free(image);
            return false;
        }
        add(image, &one);
        reference_free(&one);
    }
    for (size_t i = 0; i < colors && places.count > 0; i++)
        image->color[i] /= places.count;
    return true;
}
