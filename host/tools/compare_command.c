/* SPDX-License-Identifier: MIT */
/*
 * The command `qtri compare`.
 */
#include "../assets/image.h"
#include "../io/file.h"
#include "../io/xalloc.h"
#include "commands.h"
#include "compare.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char usage[] =
    "usage: qtri compare [OPTION]... A B\n"
    "\n"
    "Compares two pictures, PPM or PNG (-: PPM of standard input), and the dumps beside them\n"
    "(A.id, A.depth of A.ppm) where both have them.\n"
    "Prints one measure a line. Exit status 0: the same within the limits below; 1: "
    "different,\n"
    "or a file cannot be read; 2: wrong usage.\n"
    "\n"
    "  --max-color N     colour difference a pixel may have in its worst channel (default 0)\n"
    "  --max-pixels N    how many pixels may exceed that (default 0)\n"
    "  --max-coverage N  how many pixels may be covered in one picture only (default 0)\n"
    "  --max-depth X     greatest depth difference, in 1/65535 (default 0); where there are\n"
    "                    ids, of the pixels that show the same triangle in both\n"
    "  -o FILE           write a picture of the differences: dark grey where there is none,\n"
    "                    64 + 16 times the difference in each channel where there is one,\n"
    "                    red where only one picture is covered\n"
    "  --help            print this\n";

struct options {
    const char *path[2];
    const char *difference_path;
    double max_color, max_pixels, max_coverage, max_depth;
};

#define AT(member) offsetof(struct options, member)
#define LIMIT                                                                                      \
    {                                                                                              \
        .range = { 0, 1e15 }                                                                       \
    }

static const struct option all[] = {
    {"--max-color", OPTION_REAL, AT(max_color), LIMIT},
    {"--max-pixels", OPTION_REAL, AT(max_pixels), LIMIT},
    {"--max-coverage", OPTION_REAL, AT(max_coverage), LIMIT},
    {"--max-depth", OPTION_REAL, AT(max_depth), LIMIT},
    {"-o", OPTION_TEXT, AT(difference_path), {NULL}},
};

/* All limits but that of depth are whole numbers. */
static bool check(const struct option_command *command, void *given)
{
    const struct options *options = given;
    const double whole[] = {options->max_color, options->max_pixels, options->max_coverage};
    for (int i = 0; i < 3; i++) {
        if (whole[i] != floor(whole[i])) {
            return options_complain(command, all[i].name, ": not a whole number");
        }
    }
    return true;
}

/* PNG, where this was built with its library, or PPM. */
static bool read_pixels(const char *path, struct picture *picture, struct text_error *error)
{
    struct image image;

    if (!file_name_ends_in(path, ".png"))
        return picture_read_ppm(path, picture, error);
    if (!image_read(path, &image, error))
        return false;
    bool made = picture_create(picture, image.width, image.height, false);
    for (size_t i = 0; made && i < (size_t)image.width * (size_t)image.height; i++)
        memcpy(&picture->rgb[3 * i], &image.rgba[4 * i], 3);
    image_free(&image);
    return made || text_error_set(error, path, 0, "out of memory");
}

/* Reads the picture and the dumps beside it: PREFIX.id and PREFIX.depth of PREFIX.ppm. */
static bool read_picture(const char *path, struct picture *picture)
{
    struct text_error error;
    size_t length = strlen(path);

    if (!read_pixels(path, picture, &error)) {
        fprintf(stderr, "%s\n", error.message);
        return false;
    }
    char *prefix = xstrdup(path);
    if (file_name_ends_in(path, ".ppm") || file_name_ends_in(path, ".png"))
        prefix[length - 4] = '\0';
    bool read = picture_read_dump(prefix, picture, &error);
    free(prefix);
    if (!read) {
        fprintf(stderr, "%s\n", error.message);
        picture_free(picture);
    }
    return read;
}

static void print_count(FILE *out, const char *name, uint64_t value)
{
    fprintf(out, "%-20s %" PRIu64 "\n", name, value);
}

static void print_number(FILE *out, const char *name, double value)
{
    if (isinf(value))
        fprintf(out, "%-20s inf\n", name);
    else
        fprintf(out, "%-20s %.6g\n", name, value);
}

static void print_comparison(FILE *out, const struct comparison *c)
{
    fprintf(out, "%-20s %dx%d\n", "size", c->width[0], c->height[0]);
    print_count(out, "pixels", c->pixels);
    print_count(out, "pixels-differing", c->differing);
    print_count(out, "color-max", (uint64_t)c->max_color_error);
    print_number(out, "color-mean", c->mean_color_error);
    print_number(out, "psnr-db", c->psnr);
    if (c->has_id) {
        print_count(out, "covered-a", c->covered[0]);
        print_count(out, "covered-b", c->covered[1]);
        print_count(out, "coverage-mismatches", c->coverage_mismatches);
        print_count(out, "other-triangle", c->other_triangle);
    }
    if (c->has_depth) {
        print_count(out, "depth-pixels", c->depth_pixels);
        print_number(out, "depth-max", c->max_depth_error);
        print_number(out, "depth-mean", c->mean_depth_error);
        print_number(out, "depth-p99.9", c->p999_depth_error);
    }
}

static bool within_limits(const struct comparison *c, const struct options *options)
{
    const int color = (int)fmin(options->max_color, 255);

    return (double)compare_pixels_above(c, color) <= options->max_pixels &&
           (double)c->coverage_mismatches <= options->max_coverage &&
           c->max_depth_error <= options->max_depth;
}

static bool write_difference(const char *path, const struct picture picture[2])
{
    struct picture difference;
    struct text_error error;

    if (!compare_difference(&picture[0], &picture[1], &difference)) {
        fprintf(stderr, "qtri compare: out of memory\n");
        return false;
    }
    bool written = image_write_picture(path, &difference, &error);
    if (!written)
        fprintf(stderr, "%s\n", error.message);
    picture_free(&difference);
    return written;
}

/* False, without an error, where they differ by more than the limits. */
static bool compare_read_pictures(const struct options *options, const struct picture picture[2])
{
    struct comparison comparison;

    compare_pictures(&picture[0], &picture[1], &comparison);
    if (!comparison.same_size) {
        fprintf(stderr, "qtri compare: different sizes: %s is %dx%d, %s is %dx%d\n",
                options->path[0], comparison.width[0], comparison.height[0], options->path[1],
                comparison.width[1], comparison.height[1]);
        return false;
    }
    /* Where the picture of the differences goes to standard output, the measures go elsewhere. */
    bool is_piped = options->difference_path && strcmp(options->difference_path, "-") == 0;
    print_comparison(is_piped ? stderr : stdout, &comparison);
    return (!options->difference_path || write_difference(options->difference_path, picture)) &&
           within_limits(&comparison, options);
}

static bool run(void *given, struct text_error *error)
{
    const struct options *options = given;
    struct picture picture[2] = {{0}};

    (void)error; /* what is wrong with a picture has been told */
    const bool ok = read_picture(options->path[0], &picture[0]) &&
                    read_picture(options->path[1], &picture[1]) &&
                    compare_read_pictures(options, picture);
    picture_free(&picture[0]);
    picture_free(&picture[1]);
    return ok;
}

const struct option_command compare_command = {
    .name = "compare",
    .summary = "compare two pictures",
    .size = sizeof(struct options),
    .input = "pair of pictures",
    .needs = "two pictures are needed",
    .input_at = AT(path[0]),
    .output_at = AT(path[1]),
    .has_pair = true,
    .options = all,
    .count = sizeof all / sizeof all[0],
    .usage = usage,
    .check = check,
    .run = run,
};
